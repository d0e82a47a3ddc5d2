//! Questions about a whole range of inputs: how an answer runs over one of them, where it takes a wanted value, and
//! how it scatters when the inputs do; and studies of any size, by a [plan](StudyPlan).

mod amounts;
mod design;
mod evaluation;
mod grid;
mod indices;
mod levels;
mod plan;
mod sample;
mod scatter;
mod statistics;
mod values;

pub use self::{
    design::Design,
    evaluation::{Evaluation, Row, Rows, Study, answer},
    indices::{Estimate, SobolIndex, SobolIndices},
    levels::{LevelMean, Levels},
    plan::{
        Amount, Correlation, DataColumn, DistributionKind, Limit, MappedInputs, ReadData, Sampling, Spacing,
        StudyPlan, Variation,
    },
    scatter::Distribution,
    statistics::{Accumulator, AnswerLimit, AnswerStatistics, BLOCK, Exceedance, LEVEL_ROWS, Summary},
    values::{Histogram, PERCENTILES},
};
use crate::{
    Answer, Axis, Entry, Plot, Record, Refusal, Scale, Series, SolveError, Stop, Text,
    intern::fixed,
    unknowns::search::{Target, Variable, search},
    vary::{self, Perturbed, VariedInput},
};

/// The most points of a curve.
pub const MOST_POINTS: usize = 10_000;
/// The most samples of the pane; a [`StudyPlan`] may have many more.
pub const MOST_SAMPLES: usize = 1_000_000;
/// The most curves of a family.
pub const MOST_CURVES: usize = 6;
/// So many ranges without an answer are reported.
const MOST_GAPS: usize = 3;

/// Type and parameters of a study.
#[derive(Clone, Debug)]
pub enum Plan {
    /// Sweep: an answer as a function of an input, one curve for each value of another.
    Sweep {
        /// The path of the input.
        input: String,
        /// From and to, in SI.
        range: [f64; 2],
        /// Number of points.
        points: usize,
        /// Spacing of the points.
        scale: Scale,
        /// Another input, and its values in SI; a curve each.
        family: Option<(String, Vec<f64>)>,
        /// The answer.
        answer: String,
    },
    /// For which value of an input an answer is a wanted one.
    Find {
        /// The path of the input.
        input: String,
        /// From and to, in SI.
        range: [f64; 2],
        /// The answer.
        answer: String,
        /// Target value, in SI.
        wanted: f64,
    },
    /// Monte Carlo: dispersion of an answer under tolerances of the inputs.
    Scatter {
        /// The tolerances of inputs in SI, by their paths.
        tolerances: Vec<(String, f64)>,
        /// That of every other input, in its [steps](VariedInput::step).
        usual: f64,
        /// Distribution of values within the tolerance.
        distribution: Distribution,
        /// Number of problems to solve.
        samples: usize,
        /// The same seed gives the same samples.
        seed: u64,
        /// The answer.
        answer: String,
    },
}

/// Result of a study.
#[derive(Clone, Debug)]
pub struct StudyResult {
    /// Remarks on the result.
    pub remarks: Vec<Text>,
    /// The curves.
    pub plot: Option<Plot>,
    /// The numbers behind it, in SI: the values that were sought; mean, standard deviation and the ends of the 95 %
    /// interval of a scatter.
    pub numbers: Vec<f64>,
}

/// Carries out a study.
///
/// # Errors
/// Why the problem as given has no answer, or what of the plan does not fit it.
pub fn study(entry: &Entry, record: &Record, plan: &Plan, stop: &Stop) -> Result<StudyResult, SolveError> {
    let solution = entry.solve(record, stop)?;
    let name = match plan {
        Plan::Sweep { answer, .. } | Plan::Find { answer, .. } | Plan::Scatter { answer, .. } => answer,
    };
    let no_number = || SolveError::from(Refusal::because("this answer is not a scalar"));
    let answer = solution.answer(name).filter(|answer| answer.si().is_some()).ok_or_else(no_number)?;
    match plan {
        Plan::Sweep { input, range, points, scale, family, .. } => {
            let curve = Curve::new(entry, record, input, *range, answer)?;
            curve.sweep(*points, *scale, family.as_ref(), stop)
        }
        Plan::Find { input, range, wanted, .. } => {
            Curve::new(entry, record, input, *range, answer)?.find(*wanted, stop)
        }
        Plan::Scatter { tolerances, usual, distribution, samples, seed, .. } => {
            let tolerances = (tolerances.as_slice(), *usual);
            scatter::scatter(entry, record, answer, tolerances, *distribution, (*samples, *seed), stop)
        }
    }
}

/// An answer over an input.
struct Curve<'a> {
    entry: &'a Entry,
    record: &'a Record,
    answer: &'a Answer,
    inputs: Vec<VariedInput>,
    /// The place of the input.
    at: usize,
    range: [f64; 2],
}

impl<'a> Curve<'a> {
    fn new(
        entry: &'a Entry,
        record: &'a Record,
        input: &str,
        range: [f64; 2],
        answer: &'a Answer,
    ) -> Result<Self, SolveError> {
        let inputs = vary::inputs(record);
        let at = inputs.iter().position(|known| known.path == input);
        let at = at.ok_or_else(|| {
            Refusal::because("this input is not a number of the problem with its present options")
        })?;
        let range = [range[0].min(range[1]), range[0].max(range[1])];
        if !range.iter().all(|end| end.is_finite()) || range[0] == range[1] {
            return Err(Refusal::because("the range is empty: enter two different limits").into());
        }
        Ok(Self { entry, record, answer, inputs, at, range })
    }

    fn input(&self) -> &VariedInput {
        &self.inputs[self.at]
    }

    fn again(&self) -> Result<Perturbed, SolveError> {
        let path = self.input().path.clone();
        let again =
            Perturbed::new(self.entry, self.record, self.inputs.clone(), vec![self.answer.name.to_string()])?;
        if again.answers.is_empty() || !again.has_input(&path) {
            return Err(Refusal::because("this input cannot be varied").into());
        }
        Ok(again)
    }

    fn places(&self, points: usize, scale: Scale) -> Vec<f64> {
        let [from, to] = self.range;
        let last = points.max(2) - 1;
        let share = |n: usize| n as f64 / last as f64;
        match scale {
            Scale::Log if from > 0.0 => (0..=last).map(|n| from * (to / from).powf(share(n))).collect(),
            _ => (0..=last).map(|n| from + (to - from) * share(n)).collect(),
        }
    }

    fn values(
        &self,
        again: &mut Perturbed,
        places: &[f64],
        other: Option<(usize, f64)>,
        stop: &Stop,
    ) -> Result<Vec<f64>, Refusal> {
        let at = place_of(again, &self.input().path);
        places
            .iter()
            .map(|x| {
                let changes: Vec<(usize, f64)> = [(at, *x)].into_iter().chain(other).collect();
                Ok(again.with(&changes, stop)?[0])
            })
            .collect()
    }

    fn sweep(
        &self,
        points: usize,
        scale: Scale,
        family: Option<&(String, Vec<f64>)>,
        stop: &Stop,
    ) -> Result<StudyResult, SolveError> {
        let mut again = self.again()?;
        let places = self.places(points.clamp(2, MOST_POINTS), scale);
        let mut series = Vec::new();
        let mut remarks = Vec::new();
        let parameters: Vec<Option<(usize, f64)>> = match family {
            Some((path, values)) if again.has_input(path) => {
                let at = place_of(&again, path);
                values.iter().take(MOST_CURVES).map(|value| Some((at, *value))).collect()
            }
            _ => vec![None],
        };
        for other in parameters {
            let values = self.values(&mut again, &places, other, stop)?;
            let label = match other {
                None => self.answer.title(),
                Some((at, value)) => {
                    let input = &again.inputs[at];
                    Text::new("{input} = {value}").with_text("input", input.label.clone()).with_quantity(
                        "value",
                        value,
                        fixed(&input.unit),
                    )
                }
            };
            if remarks.is_empty() {
                remarks = self.gaps(&again, other, &places, &values, stop);
                if other.is_some() {
                    let of_curve = |why| {
                        Text::new("{curve}: {why}").with_text("curve", label.clone()).with_text("why", why)
                    };
                    remarks = remarks.into_iter().map(of_curve).collect();
                }
            }
            series.push(Series::line(label, places.iter().copied().zip(values).collect()));
        }
        let mut plot = self.plot(series);
        plot.x.scale = if self.range[0] > 0.0 { scale } else { Scale::Linear };
        if family.is_none() {
            plot = plot.mark("current value", (self.input().si, self.answer.si().unwrap_or(f64::NAN)));
        }
        Ok(StudyResult { remarks, plot: Some(plot), numbers: Vec::new() })
    }

    fn find(&self, wanted: f64, stop: &Stop) -> Result<StudyResult, SolveError> {
        let mut again = self.again()?;
        let at = place_of(&again, &self.input().path);
        let variable = Variable::new(self.range, None);
        let scale = if variable.is_logarithmic { Scale::Log } else { Scale::Linear };
        let mut evaluate = |x: &[f64]| again.with(&[(at, x[0])], stop);
        let target = Target { si: wanted, tolerance: None };
        let searched = search(&mut evaluate, &[variable], &[target], stop)?;
        if searched.without_influence.is_some() {
            let remarks = Text::new("{answer} does not depend on {input}")
                .with_text("answer", self.answer.title())
                .with_text("input", self.input().label.clone());
            return Ok(StudyResult { remarks: vec![remarks], plot: None, numbers: Vec::new() });
        }
        let found: Vec<f64> = searched.solutions.iter().map(|solution| solution[0]).collect();
        let (places, values): (Vec<f64>, Vec<f64>) = searched.scan.iter().copied().unzip();
        let (x_unit, y_unit) = (fixed(&self.input().unit), fixed(&self.answer.unit));
        let mut remarks: Vec<Text> = found
            .iter()
            .map(|x| {
                Text::new("{input} = {value}")
                    .with_text("input", self.input().label.clone())
                    .with_quantity("value", *x, x_unit)
            })
            .collect();
        if found.is_empty() {
            remarks.push(match searched.covered {
                Some([least, most]) => Text::new(
                    "target not reached in the range: the answer lies between {least} (at {at_least}) and {most} (at {at_most})",
                )
                .with_quantity("least", least.1, y_unit)
                .with_quantity("at_least", least.0, x_unit)
                .with_quantity("most", most.1, y_unit)
                .with_quantity("at_most", most.0, x_unit),
                None => Text::new("no answer in the whole range"),
            });
        }
        remarks.extend(self.gaps(&again, None, &places, &values, stop));
        let mut plot =
            self.plot(vec![Series::line(self.answer.title(), searched.scan)]).level("target", wanted);
        plot.x.scale = scale;
        for x in &found {
            plot = plot.mark("", (*x, wanted));
        }
        Ok(StudyResult { remarks, plot: Some(plot), numbers: found })
    }

    fn plot(&self, series: Vec<Series>) -> Plot {
        let title = Text::new("{answer} against {input}")
            .with_text("answer", self.answer.title())
            .with_text("input", self.input().label.clone());
        let x = Axis::linear(self.input().label.clone(), fixed(&self.input().unit));
        Plot::new(title, x, Axis::linear(self.answer.title(), fixed(&self.answer.unit)), series)
    }

    /// Ranges without an answer, the other input changed too, and the reasons.
    fn gaps(
        &self,
        again: &Perturbed,
        other: Option<(usize, f64)>,
        places: &[f64],
        values: &[f64],
        stop: &Stop,
    ) -> Vec<Text> {
        let changed = other.and_then(|(at, si)| vary::changed(self.record, &again.inputs[at].path, si));
        let record = changed.as_ref().unwrap_or(self.record);
        // A value that the other input cannot have leaves no answer anywhere.
        let outside = other.filter(|(at, si)| !again.inputs[*at].permits(*si));
        let mut gaps: Vec<(usize, usize)> = Vec::new();
        for at in (0..values.len()).filter(|at| values[*at].is_nan()) {
            match gaps.last_mut() {
                Some((_, end)) if *end + 1 == at => *end = at,
                _ => gaps.push((at, at)),
            }
        }
        let unit = fixed(&self.input().unit);
        let reported = gaps.into_iter().take(MOST_GAPS).map(|(first, last)| {
            let (input, si) = match outside {
                Some((at, si)) => (&again.inputs[at], si),
                None => (self.input(), places[usize::midpoint(first, last)]),
            };
            let why = vary::why_not(self.entry, record, input, si, stop);
            Text::new("no answer from {from} to {to}: {why}")
                .with_quantity("from", places[first], unit)
                .with_quantity("to", places[last], unit)
                .with_text("why", why.unwrap_or_else(|| Text::new("no reason reported")))
        });
        reported.collect()
    }
}

fn place_of(again: &Perturbed, path: &str) -> usize {
    again.inputs.iter().position(|input| input.path == path).unwrap_or(0)
}
