//! `dalembert verify`

mod uncovered;

use std::process::ExitCode;

use dalembert_core::{
    Entry, Text,
    cases::{self, Case, Comparison, Seen, Truth, Verdict},
};
use dalembert_report::{Block, Document, NamedValue};
use serde_json::json;

use crate::{
    arguments::Verify,
    commands::{list::with_words, show::seen_in},
    console::{Console, print_json},
    failure::Failure,
    solving::guarded,
};

/// Holds every answer of every case against ours. Status 1 as soon as one differs or a check fails.
pub(crate) fn run(verify: &Verify, console: &Console) -> Result<ExitCode, Failure> {
    let found = with_words(&verify.filter);
    if found.is_empty() {
        // Nothing verified must not pass for verified.
        let why = Text::new("no analysis matches {filter}; `dalembert list` shows them all");
        return Err(Failure::input(why.with("filter", verify.filter.join(" "))));
    }
    if verify.uncovered {
        return uncovered::run(&found, verify.json, console);
    }
    let held: Vec<Held> = found.into_iter().flat_map(held).collect();
    let counts = Counts::of(&held);
    if verify.json {
        print_json(&rows(&held, &counts))?;
    } else {
        console.print(document(&held, &counts, console))?;
    }
    Ok(if counts.differing == 0 { ExitCode::SUCCESS } else { ExitCode::from(1) })
}

/// A case with its verdicts.
struct Held {
    entry: &'static Entry,
    name: Text,
    source: Text,
    /// Kind of truth of its answers; a refusal is a kind of its own.
    kind: &'static str,
    seen: Option<Seen>,
    verdicts: Vec<Verdict>,
}

/// Kinds of truth in the order of the summary. The last one is of case files that cannot be read.
const KINDS: [&str; 6] = [
    Truth::Published.name(),
    Truth::ClosedForm.name(),
    Truth::OtherProgram.name(),
    Truth::OwnEarlierValue.name(),
    REFUSAL,
    "",
];

/// A problem without an answer, which must be refused in the words of its case.
const REFUSAL: &str = "refusal";

#[derive(Clone, Copy, Default)]
struct Counts {
    agreed: usize,
    disputed: usize,
    differing: usize,
}

impl Counts {
    fn of<'h>(held: impl IntoIterator<Item = &'h Held>) -> Self {
        let mut counts = Self::default();
        for verdict in held.into_iter().flat_map(|case| &case.verdicts) {
            match verdict.outcome {
                Comparison::Agreed => counts.agreed += 1,
                Comparison::Disputed => counts.disputed += 1,
                Comparison::Differing => counts.differing += 1,
            }
        }
        counts
    }

    fn words(self) -> Text {
        Text::new("{agreed} agreed, {disputed} disputed, {differing} differing")
            .with("agreed", self.agreed)
            .with("disputed", self.disputed)
            .with("differing", self.differing)
    }
}

/// The counts of each kind of truth that there is.
fn by_kind(held: &[Held]) -> impl Iterator<Item = (&'static str, Counts)> {
    KINDS
        .into_iter()
        .map(move |kind| (kind, Counts::of(held.iter().filter(|case| case.kind == kind))))
        .filter(|(_, counts)| counts.agreed + counts.disputed + counts.differing > 0)
}

/// The cases of an analysis. What cannot be solved or read differs.
fn held(entry: &'static Entry) -> Vec<Held> {
    let failed = |why: String| {
        vec![Verdict {
            answer: String::new(),
            printed: String::new(),
            computed: String::new(),
            outcome: Comparison::Differing,
            why: Text::verbatim(why),
        }]
    };
    let verdicts = |case: &Case| match guarded(entry, || case.verify(entry)) {
        Ok(Ok(verdicts)) => verdicts,
        Ok(Err(err)) => failed(err.to_string()),
        Err(fault) => failed(fault.to_string()),
    };
    match cases::cases(entry) {
        Ok(cases) => cases
            .into_iter()
            .map(|case| Held {
                entry,
                verdicts: verdicts(&case),
                name: case.title(),
                source: case.source,
                kind: if case.refused.is_some() { REFUSAL } else { case.truth.name() },
                seen: case.seen,
            })
            .collect(),
        Err(why) => {
            vec![Held {
                entry,
                name: Text::from(""),
                source: Text::from(""),
                kind: "",
                seen: None,
                verdicts: failed(why),
            }]
        }
    }
}

fn rows(held: &[Held], counts: &Counts) -> serde_json::Value {
    let rows = held.iter().flat_map(|case| {
        case.verdicts.iter().map(|verdict| {
            json!({
                "analysis": case.entry.about.id,
                "case": case.name.english(),
                "source": case.source.english(),
                "truth": case.kind,
                "seen": case.seen.map(Seen::name),
                "answer": verdict.answer,
                "printed": verdict.printed,
                "ours": verdict.computed,
                "verdict": verdict.outcome.name(),
                "why": verdict.why.english(),
            })
        })
    });
    let of_kind = |(kind, counts): (&str, Counts)| {
        let Counts { agreed, disputed, differing } = counts;
        (kind.to_owned(), json!({ "agreed": agreed, "disputed": disputed, "differing": differing }))
    };
    json!({
        "agreed": counts.agreed,
        "disputed": counts.disputed,
        "differing": counts.differing,
        "by_truth": by_kind(held).map(of_kind).collect::<serde_json::Map<_, _>>(),
        "rows": rows.collect::<Vec<_>>(),
    })
}

fn document(held: &[Held], counts: &Counts, console: &Console) -> Document {
    let mut blocks = Vec::new();
    for of_analysis in held.chunk_by(|a, b| std::ptr::eq(a.entry, b.entry)) {
        let locale = console.locale.at(of_analysis[0].entry.about.id);
        let render = |text: &Text| text.render(&locale);
        let say = |words: &'static str| render(&Text::from(words));
        blocks.push(Block::Heading(of_analysis[0].entry.about.id.to_owned()));
        for case in of_analysis {
            let seen = case.seen.map_or_else(String::new, |seen| format!(", {}", say(seen_in(seen))));
            let truth =
                if case.kind.is_empty() { String::new() } else { format!(" ({}{seen})", say(case.kind)) };
            blocks.push(Block::Paragraph(format!(
                "{} — {}{truth}",
                render(&case.name),
                render(&case.source)
            )));
            let mut lines = Vec::new();
            let widest =
                case.verdicts.iter().map(|verdict| say(verdict.outcome.name()).len()).max().unwrap_or(0);
            for verdict in &case.verdicts {
                let both = Text::new("published {printed}, computed {ours}")
                    .with("printed", &verdict.printed)
                    .with("ours", &verdict.computed);
                lines.push(NamedValue {
                    label: format!("{:widest$}  {}", say(verdict.outcome.name()), verdict.answer),
                    value: render(&both),
                    ..NamedValue::default()
                });
                if !verdict.why.is_empty() {
                    lines.push(NamedValue { depth: 2, label: render(&verdict.why), ..NamedValue::default() });
                }
            }
            blocks.push(Block::Lines(lines));
        }
    }
    let locale = &console.locale;
    let of_kind = |(kind, counts): (&'static str, Counts)| NamedValue {
        label: if kind.is_empty() { String::new() } else { Text::from(kind).render(locale) },
        value: counts.words().render(locale),
        ..NamedValue::default()
    };
    blocks.push(Block::Lines(by_kind(held).map(of_kind).collect()));
    blocks.push(Block::Paragraph(counts.words().render(locale)));
    Document { title: String::new(), blocks }
}
