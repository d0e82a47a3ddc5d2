//! Curves of answers over an input of a grid, from rows in their order.

use super::{Row, Spacing, Study};
use crate::{
    Answer, Axis, Plot, Scale, Series, Stop, Text,
    intern::fixed,
    vary::{self, VariedInput},
};

/// The most curves of an answer.
pub const MOST_CURVES: usize = 6;
/// The most points of them all; a study of more has none.
const MOST_POINTS: u64 = 60_000;
/// So many ranges without an answer are reported.
const MOST_GAPS: usize = 3;

/// The curves of the answers of a study over the input of its grid with the most points, one for each combination of
/// the others.
#[derive(Clone, Debug)]
pub struct Curves<'s> {
    study: &'s Study<'s>,
    /// Place of the input along the curves.
    x: usize,
    scale: Scale,
    /// The inputs that differ from curve to curve.
    others: Vec<usize>,
    /// Points of a curve.
    points: u64,
    /// Points from one to the next of a curve.
    stride: u64,
    next: u64,
    drawn: Vec<Curve>,
}

#[derive(Clone, Debug)]
struct Curve {
    label: Option<Text>,
    x: Vec<f64>,
    /// For each answer, in SI.
    answers: Vec<Vec<f64>>,
    refusals: Vec<Option<Text>>,
}

impl<'s> Curves<'s> {
    /// Curves of a study, without points yet; `None` where an input is drawn from a distribution, where no input has two
    /// values, or where there are too many points.
    pub fn of(study: &'s Study<'s>) -> Option<Self> {
        let design = &study.design;
        if design.drawn().next().is_some() || design.points() > MOST_POINTS {
            return None;
        }
        let axes: Vec<(Vec<usize>, u64, Spacing)> = design.axes().collect();
        let most = axes.iter().map(|(_, points, _)| *points).max().filter(|most| *most > 1)?;
        let at = axes.iter().position(|(_, points, _)| *points == most)?;
        let others = axes.iter().enumerate().filter(|(n, _)| *n != at);
        Some(Self {
            study,
            x: *axes[at].0.first()?,
            scale: if axes[at].2 == Spacing::Log { Scale::Log } else { Scale::Linear },
            others: others.filter(|(_, axis)| axis.1 > 1).flat_map(|(_, axis)| axis.0.clone()).collect(),
            points: most,
            stride: axes[at + 1..].iter().map(|axis| axis.1).product(),
            next: 0,
            drawn: Vec::new(),
        })
    }

    /// Takes the next row.
    pub fn push(&mut self, row: &Row<'_>) {
        let (before, within) = (self.next / (self.points * self.stride), self.next % self.stride);
        self.next += 1;
        let curve = (before * self.stride + within) as usize;
        if curve >= MOST_CURVES {
            return;
        }
        let inputs = &self.study.design.inputs;
        if curve == self.drawn.len() {
            let label =
                self.others.iter().map(|at| {
                    let unit = &inputs[*at].unit;
                    Text::new("{input} = {value}")
                        .with_text("input", inputs[*at].label.clone())
                        .with_quantity("value", unit.si(row.inputs[*at]), fixed(unit))
                });
            self.drawn.push(Curve {
                label: label.reduce(|one, other| {
                    Text::new("{one}, {other}").with_text("one", one).with_text("other", other)
                }),
                x: Vec::new(),
                answers: vec![Vec::new(); row.answers.len()],
                refusals: Vec::new(),
            });
        }
        let curve = &mut self.drawn[curve];
        curve.x.push(inputs[self.x].unit.si(row.inputs[self.x]));
        let answers = row.answers.iter().zip(&self.study.answers).zip(&mut curve.answers);
        for ((value, answer), values) in answers {
            values.push(answer.unit.si(*value));
        }
        curve.refusals.push(row.refusal.cloned());
    }

    /// A plot for each answer, with the points that were taken; limits of one set are curves of one plot.
    pub fn plots(&self) -> Vec<Plot> {
        let study = self.study;
        let set_of = |at: usize| study.sets.iter().find(|(_, limits)| limits.contains(&at));
        let plot = |(at, answer): (usize, &Answer)| match set_of(at) {
            Some((set, limits)) => (limits.first() == Some(&at)).then(|| self.plot(set, limits)),
            None => Some(self.plot(answer, &[at])),
        };
        study.answers.iter().enumerate().filter_map(plot).collect()
    }

    /// A plot of several answers, under the title of one of them or of their set.
    fn plot(&self, title: &Answer, answers: &[usize]) -> Plot {
        let input = &self.study.design.inputs[self.x];
        let curves = self.drawn.iter().flat_map(|curve| answers.iter().map(move |at| (curve, *at)));
        let series = curves.map(|(curve, at)| {
            let answer = self.study.answers[at].title();
            let label = match &curve.label {
                None => answer,
                Some(label) if answers.len() == 1 => label.clone(),
                Some(label) => {
                    Text::new("{one}, {other}").with_text("one", answer).with_text("other", label.clone())
                }
            };
            let mut points: Vec<(f64, f64)> =
                curve.x.iter().copied().zip(curve.answers[at].iter().copied()).collect();
            points.sort_by(|(one, _), (other, _)| one.total_cmp(other));
            Series::line(label, points)
        });
        let plot = along(input, self.scale, title, series.collect());
        let now = answers.iter().filter_map(|at| self.study.answers[*at].si());
        let now = now.filter(|_| self.others.is_empty());
        now.fold(plot, |plot, si| plot.mark("current value", (input.si, si)))
    }

    /// Reason for which a point of a curve has no answer: of its refusal, or what the problem says of the answer that it
    /// lacks there.
    fn why_not(&self, curve: &Curve, at: usize) -> Option<Text> {
        let said = || {
            let (study, input) = (self.study, &self.study.design.inputs[self.x]);
            let missing = (0..study.answers.len()).find(|answer| curve.answers[*answer][at].is_nan())?;
            let name = study.answers[missing].name.to_string();
            vary::why_not(study.entry, study.record, (input, curve.x[at]), &name, &Stop::new())
        };
        curve.refusals[at].clone().or_else(|| said().filter(|_| self.others.is_empty()))
    }

    /// The ranges without an answer of the first curve that has some, and the reasons; and how many curves are not
    /// drawn.
    pub fn remarks(&self) -> Vec<Text> {
        let unit = fixed(&self.study.design.inputs[self.x].unit);
        let of = |curve: &Curve| -> Vec<Text> {
            let at = |point: usize| curve.answers.iter().map(|of| of[point]).find(|si| si.is_nan());
            let refused: Vec<f64> = (0..curve.x.len()).map(|point| at(point).unwrap_or(0.0)).collect();
            let remark = |(first, last): (usize, usize)| {
                let why = self.why_not(curve, usize::midpoint(first, last));
                let why = no_answer([curve.x[first], curve.x[last]], unit, why);
                match &curve.label {
                    None => why,
                    Some(label) => {
                        Text::new("{curve}: {why}").with_text("curve", label.clone()).with_text("why", why)
                    }
                }
            };
            gaps(&refused).into_iter().map(remark).collect()
        };
        let mut remarks = self.drawn.iter().map(of).find(|gaps| !gaps.is_empty()).unwrap_or_default();
        let all = self.study.design.points() / self.points;
        if all > MOST_CURVES as u64 {
            remarks.push(
                Text::new("the first {drawn} of {all} curves are drawn")
                    .with("drawn", MOST_CURVES)
                    .with("all", all),
            );
        }
        remarks
    }
}

/// Plot of an answer over an input.
pub(super) fn along(input: &VariedInput, scale: Scale, answer: &Answer, series: Vec<Series>) -> Plot {
    let title = Text::new("{answer} against {input}")
        .with_text("answer", answer.title())
        .with_text("input", input.label.clone());
    let x = Axis { label: input.label.clone(), unit: fixed(&input.unit), scale };
    Plot::new(title, x, Axis::linear(answer.title(), fixed(&answer.unit)), series)
}

/// The first and the last place of each of the first runs of values that are none.
pub(super) fn gaps(values: &[f64]) -> Vec<(usize, usize)> {
    let mut gaps: Vec<(usize, usize)> = Vec::new();
    for at in (0..values.len()).filter(|at| values[*at].is_nan()) {
        match gaps.last_mut() {
            Some((_, end)) if *end + 1 == at => *end = at,
            _ => gaps.push((at, at)),
        }
    }
    gaps.truncate(MOST_GAPS);
    gaps
}

/// A range without an answer, and the reason.
pub(super) fn no_answer([from, to]: [f64; 2], unit: &'static str, why: Option<Text>) -> Text {
    Text::new("no answer from {from} to {to}: {why}")
        .with_quantity("from", from, unit)
        .with_quantity("to", to, unit)
        .with_text("why", why.unwrap_or_else(|| Text::new("no reason reported")))
}
