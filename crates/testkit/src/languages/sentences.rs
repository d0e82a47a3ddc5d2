//! The sentences of an analysis: its description, its cases and their solutions.

use std::collections::{BTreeMap, BTreeSet};

use dalembert_core::{
    AnswerValue, Arg, DrawnShape, Exhibit, Field, Shape, Solution, Text,
    cases::{Case, ComparisonRule},
    exhibit::Cell,
};

/// Sentences, and the place where each is used.
#[derive(Default)]
pub(super) struct Sentences(pub(super) BTreeMap<String, String>);

impl Sentences {
    pub(super) fn add(&mut self, of: &str, sentence: &str) {
        self.0.entry(sentence.to_owned()).or_insert_with(|| of.to_owned());
    }

    pub(super) fn text(&mut self, of: &str, text: &Text) {
        self.add(of, &text.template);
        for (_, arg) in &text.args {
            if let Arg::Text(text) = arg {
                self.text(of, text);
            }
        }
    }

    pub(super) fn fields(&mut self, of: &str, fields: &[Field], seen: &mut BTreeSet<usize>) {
        for field in fields {
            self.add(of, field.label);
            self.add(of, field.help);
            self.shape(of, &field.shape, seen);
        }
    }

    fn shape(&mut self, of: &str, shape: &Shape, seen: &mut BTreeSet<usize>) {
        match shape {
            Shape::Group(fields) | Shape::Table(fields) => self.once(of, fields(), seen),
            Shape::Optional(inner) => self.shape(of, inner(), seen),
            Shape::Rows { item, .. } => self.shape(of, item(), seen),
            Shape::OneOf(variants) => {
                for variant in variants() {
                    self.add(of, variant.label);
                    self.add(of, variant.help);
                    self.once(of, (variant.fields)(), seen);
                }
            }
            _ => {}
        }
    }

    /// A type may contain itself: its fields are visited once.
    fn once(&mut self, of: &str, fields: &'static [Field], seen: &mut BTreeSet<usize>) {
        if !fields.is_empty() && seen.insert(fields.as_ptr() as usize) {
            self.fields(of, fields, seen);
        }
    }

    pub(super) fn case(&mut self, of: &str, case: &Case) {
        for text in words_of(case) {
            self.text(of, &text);
        }
    }

    pub(super) fn solution(&mut self, of: &str, solution: &Solution) {
        solution.steps.iter().for_each(|step| self.text(of, &step.why));
        solution.answers.iter().for_each(|answer| self.add(of, answer.label));
        solution.checks.iter().for_each(|check| self.text(of, &check.what));
        solution.warnings.iter().for_each(|warning| self.text(of, warning));
        for answer in &solution.answers {
            if let AnswerValue::Set(_, limits) = &answer.value {
                for limit in limits {
                    self.text(of, limit);
                }
            }
        }
        for exhibit in &solution.exhibits {
            match exhibit {
                Exhibit::Plot(plot) => {
                    let texts = [&plot.title, &plot.x.label, &plot.y.label].into_iter();
                    let series = plot.series.iter().map(|series| &series.label);
                    let marks = plot.marks.iter().map(|mark| &mark.label);
                    let bands = plot.bands.iter().map(|band| &band.label);
                    let levels = plot.levels.iter().map(|level| &level.label);
                    texts
                        .chain(series)
                        .chain(marks)
                        .chain(bands)
                        .chain(levels)
                        .for_each(|text| self.text(of, text));
                }
                Exhibit::Table(table) => {
                    self.text(of, &table.title);
                    table.columns.iter().for_each(|column| self.text(of, &column.heading));
                    for cell in table.rows.iter().flatten().chain(&table.foot) {
                        if let Cell::Text(text) = cell {
                            self.text(of, text);
                        }
                    }
                }
                Exhibit::Drawing(drawing) => self.drawing(of, &drawing.title, &drawing.shapes),
                Exhibit::Animation(animation) => {
                    animation.frames.iter().for_each(|frame| self.drawing(of, &animation.title, frame));
                }
                Exhibit::Scene(scene) => (0..scene.frames.len()).for_each(|frame| {
                    let drawing = scene.seen(frame, scene.view);
                    self.drawing(of, &drawing.title, &drawing.shapes);
                }),
            }
        }
    }

    fn drawing(&mut self, of: &str, title: &Text, shapes: &[DrawnShape]) {
        self.text(of, title);
        for shape in shapes {
            if let DrawnShape::Label(.., text) = shape {
                self.text(of, text);
            }
        }
    }
}

/// Returns true if a sentence is the same in every language: symbols, units and numbers, and what stands in a place.
pub(super) fn is_the_same_in_every_language(sentence: &str) -> bool {
    let mut words = sentence.to_owned();
    while let (Some(open), Some(close)) = (words.find('{'), words.find('}')) {
        words.replace_range(open.min(close)..=open.max(close), " ");
    }
    let notation = |word: &str| {
        ["sin", "cos", "tan"].contains(&word) || word.chars().filter(char::is_ascii_alphabetic).count() < 3
    };
    words.split(|c: char| !c.is_alphabetic()).all(notation)
}

/// The words of a case that people read.
pub(super) fn words_of(case: &Case) -> Vec<Text> {
    let reasons = case.expect.iter().filter_map(|expected| match &expected.how {
        ComparisonRule::Within(_, why) | ComparisonRule::Disputed { why, .. } => Some(why.clone()),
        ComparisonRule::ToTheLastPlace | ComparisonRule::Computed => None,
    });
    [case.title(), case.source.clone(), case.note.clone(), case.statement.clone()]
        .into_iter()
        .chain(reasons)
        .collect()
}
