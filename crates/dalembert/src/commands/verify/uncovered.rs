//! `dalembert verify --uncovered`

use std::process::ExitCode;

use dalembert_core::{
    Entry, Stop, Text,
    coverage::{Coverage, CoverageStatus, coverage},
};
use dalembert_report::{Block, Document, NamedValue};
use serde_json::json;

use crate::{
    console::{Console, print_json},
    failure::Failure,
    solving::guarded,
};

/// Lists the answers that no second method covers. Status 1 where one has no reason, or has one and is covered.
pub(super) fn run(found: &[&'static Entry], as_json: bool, console: &Console) -> Result<ExitCode, Failure> {
    let mut all = Vec::new();
    for &entry in found {
        let of_entry = guarded(entry, || coverage(entry, &Stop::new()))?;
        all.push((entry, of_entry.map_err(|why| Failure::Fault(format!("{}: {why}", entry.about.id)))?));
    }
    let total = Counts::of(all.iter().flat_map(|(_, coverage)| coverage));
    if as_json {
        print_json(&rows(&all, total))?;
    } else {
        console.print(document(&all, total, console))?;
    }
    Ok(if total.unexplained + total.stale == 0 { ExitCode::SUCCESS } else { ExitCode::from(1) })
}

type All = [(&'static Entry, Vec<Coverage>)];

#[derive(Clone, Copy, Default)]
struct Counts {
    covered: usize,
    forms: usize,
    inputs: usize,
    explained: usize,
    unexplained: usize,
    stale: usize,
}

impl Counts {
    fn of<'c>(all: impl IntoIterator<Item = &'c Coverage>) -> Self {
        let mut counts = Self::default();
        for one in all {
            match (&one.status, one.reason) {
                (CoverageStatus::Covered(_), _) => counts.covered += 1,
                (CoverageStatus::Form, _) => counts.forms += 1,
                (CoverageStatus::Input, _) => counts.inputs += 1,
                (CoverageStatus::Uncovered, Some(_)) => counts.explained += 1,
                (CoverageStatus::Uncovered, None) => counts.unexplained += 1,
            }
            counts.stale += usize::from(one.is_stale());
        }
        counts
    }

    fn words(self) -> Text {
        let answers = self.covered + self.forms + self.inputs + self.explained + self.unexplained;
        Text::new(
            "{answers} answers: {covered} covered, {forms} other forms of covered ones, {inputs} inputs, {explained} uncovered with a reason, {unexplained} uncovered without one",
        )
        .with("answers", answers)
        .with("covered", self.covered)
        .with("forms", self.forms)
        .with("inputs", self.inputs)
        .with("explained", self.explained)
        .with("unexplained", self.unexplained)
    }

    fn json(self) -> serde_json::Value {
        json!({
            "covered": self.covered,
            "other_forms": self.forms,
            "inputs": self.inputs,
            "uncovered_with_reason": self.explained,
            "uncovered_without_reason": self.unexplained,
            "reasons_of_covered_answers": self.stale,
        })
    }
}

/// The counts of each family.
fn by_family(all: &All) -> impl Iterator<Item = (&'static str, Counts)> {
    all.chunk_by(|(a, _), (b, _)| a.family() == b.family()).map(|of_family| {
        (of_family[0].0.family(), Counts::of(of_family.iter().flat_map(|(_, coverage)| coverage)))
    })
}

fn why(one: &Coverage) -> Text {
    if one.is_stale() {
        return Text::from("covered, although a reason is given");
    }
    one.reason.map_or_else(|| Text::from("no reason given"), dalembert_core::coverage::Reason::words)
}

fn rows(all: &All, total: Counts) -> serde_json::Value {
    let rows = all.iter().flat_map(|(entry, coverage)| {
        coverage.iter().map(|one| {
            let (standing, check) = match &one.status {
                CoverageStatus::Covered(what) => ("covered", Some(what.english())),
                CoverageStatus::Form => ("other form", None),
                CoverageStatus::Input => ("input", None),
                CoverageStatus::Uncovered => ("uncovered", None),
            };
            json!({
                "analysis": entry.about.id,
                "answer": one.answer,
                "standing": standing,
                "check": check,
                "reason": one.reason.map(|_| why(one).english()),
            })
        })
    });
    json!({
        "total": total.json(),
        "by_family": by_family(all)
            .map(|(family, counts)| (family.to_owned(), counts.json()))
            .collect::<serde_json::Map<_, _>>(),
        "rows": rows.collect::<Vec<_>>(),
    })
}

fn document(all: &All, total: Counts, console: &Console) -> Document {
    let render = |text: &Text| text.render(&console.locale);
    let mut blocks = Vec::new();
    for (entry, coverage) in all {
        let listed = |one: &&Coverage| one.status == CoverageStatus::Uncovered || one.is_stale();
        let line = |one: &Coverage| NamedValue {
            label: one.answer.to_owned(),
            value: render(&why(one)),
            ..NamedValue::default()
        };
        let lines: Vec<NamedValue> = coverage.iter().filter(listed).map(line).collect();
        if !lines.is_empty() {
            blocks.push(Block::Heading(entry.about.id.to_owned()));
            blocks.push(Block::Lines(lines));
        }
    }
    let of_family = |(family, counts): (&str, Counts)| NamedValue {
        label: family.to_owned(),
        value: render(&counts.words()),
        ..NamedValue::default()
    };
    blocks.push(Block::Lines(by_family(all).map(of_family).collect()));
    blocks.push(Block::Paragraph(render(&Text::from(
        "An answer is covered if a check of one of its cases fails when the answer is changed by one part in a million.",
    ))));
    blocks.push(Block::Paragraph(render(&total.words())));
    Document { title: String::new(), blocks }
}
