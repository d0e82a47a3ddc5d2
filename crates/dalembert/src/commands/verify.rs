//! `dalembert verify`

use std::process::ExitCode;

use dalembert_core::{
    Entry, Text,
    cases::{self, Case, Outcome, Verdict},
};
use dalembert_report::{Block, Document, Line};
use serde_json::json;

use crate::{
    arguments::Verify,
    commands::list::matching,
    console::{Console, print_json},
    failure::Failure,
    solving::guarded,
};

/// Holds every printed answer against ours. Status 1 as soon as one differs.
pub(crate) fn run(verify: &Verify, console: &Console) -> Result<ExitCode, Failure> {
    let found = matching(&verify.filter);
    if found.is_empty() {
        // Nothing verified must not pass for verified.
        let why = Text::new("no analysis matches {filter}; `dalembert list` shows them all");
        return Err(Failure::input(why.with("filter", verify.filter.join(" "))));
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
    truth: &'static str,
    verdicts: Vec<Verdict>,
}

struct Counts {
    agreed: usize,
    disputed: usize,
    differing: usize,
}

impl Counts {
    fn of(held: &[Held]) -> Self {
        let count = |outcome| {
            held.iter().flat_map(|case| &case.verdicts).filter(|verdict| verdict.outcome == outcome).count()
        };
        Self {
            agreed: count(Outcome::Agreed),
            disputed: count(Outcome::Disputed),
            differing: count(Outcome::Differing),
        }
    }
}

/// The cases of an analysis. What cannot be solved or read differs.
fn held(entry: &'static Entry) -> Vec<Held> {
    let failed = |why: String| {
        vec![Verdict {
            answer: String::new(),
            printed: String::new(),
            ours: String::new(),
            outcome: Outcome::Differing,
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
                truth: case.truth.name(),
            })
            .collect(),
        Err(why) => {
            vec![Held {
                entry,
                name: Text::from(""),
                source: Text::from(""),
                truth: "",
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
                "answer": verdict.answer,
                "printed": verdict.printed,
                "ours": verdict.ours,
                "verdict": verdict.outcome.name(),
                "why": verdict.why.english(),
            })
        })
    });
    json!({
        "agreed": counts.agreed,
        "disputed": counts.disputed,
        "differing": counts.differing,
        "rows": rows.collect::<Vec<_>>(),
    })
}

fn document(held: &[Held], counts: &Counts, console: &Console) -> Document {
    let render = |text: &Text| text.render(&console.locale);
    let say = |words: &'static str| render(&Text::from(words));
    let mut blocks = Vec::new();
    for of_analysis in held.chunk_by(|a, b| std::ptr::eq(a.entry, b.entry)) {
        blocks.push(Block::Heading(of_analysis[0].entry.about.id.to_owned()));
        for case in of_analysis {
            let truth = if case.truth.is_empty() { String::new() } else { format!(" ({})", say(case.truth)) };
            blocks.push(Block::Paragraph(format!(
                "{} — {}{truth}",
                render(&case.name),
                render(&case.source)
            )));
            let mut lines = Vec::new();
            let widest =
                case.verdicts.iter().map(|verdict| say(verdict.outcome.name()).len()).max().unwrap_or(0);
            for verdict in &case.verdicts {
                let both = Text::new("printed {printed}, ours {ours}")
                    .with("printed", &verdict.printed)
                    .with("ours", &verdict.ours);
                lines.push(Line {
                    label: format!("{:widest$}  {}", say(verdict.outcome.name()), verdict.answer),
                    value: both.render(&console.locale),
                    ..Line::default()
                });
                if !verdict.why.is_empty() {
                    lines.push(Line { depth: 2, label: render(&verdict.why), ..Line::default() });
                }
            }
            blocks.push(Block::Lines(lines));
        }
    }
    let total = Text::new("{agreed} agreed, {disputed} disputed, {differing} differing")
        .with("agreed", counts.agreed)
        .with("disputed", counts.disputed)
        .with("differing", counts.differing);
    blocks.push(Block::Paragraph(total.render(&console.locale)));
    Document { title: String::new(), blocks }
}
