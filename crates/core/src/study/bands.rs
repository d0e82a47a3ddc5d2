//! Scatter of answers along an input of a grid, from rows in their order.

use dalembert_numerics::distribution::quantile_of_sorted;

use super::{Row, Spacing, Study, curves::along};
use crate::{Answer, Plot, Scale, Series};

/// The most samples at a point of the grid, and the most points.
const MOST_SAMPLES: u64 = 1_000_000;
const MOST_POINTS: u64 = 10_000;

/// Mean and interval of 95 % of the answers of a study along the one input of its grid; the values at one point of the
/// grid alone are kept.
#[derive(Clone, Debug)]
pub struct Bands<'s> {
    study: &'s Study<'s>,
    /// Place of the input along the grid.
    x: usize,
    scale: Scale,
    /// Samples at a point of the grid.
    samples: u64,
    taken: u64,
    /// Values at the present point, for each answer, in SI.
    values: Vec<Vec<f64>>,
    /// For each answer: place, mean, 2.5 % and 97.5 %, in SI.
    found: Vec<Vec<(f64, [f64; 3])>>,
}

impl<'s> Bands<'s> {
    /// Bands of a study, without points yet; `None` where its grid is not one input with samples at each point.
    pub fn of(study: &'s Study<'s>) -> Option<Self> {
        let design = &study.design;
        let mut axes = design.axes().filter(|(_, points, _)| *points > 1);
        let (inputs, points, spacing) = axes.next()?;
        let samples = design.points() / points;
        let is_drawn = design.drawn().next().is_some();
        if !is_drawn || axes.next().is_some() || samples > MOST_SAMPLES || points > MOST_POINTS {
            return None;
        }
        let of_answers = study.answers.len();
        Some(Self {
            study,
            x: *inputs.first()?,
            scale: if spacing == Spacing::Log { Scale::Log } else { Scale::Linear },
            samples,
            taken: 0,
            values: vec![Vec::new(); of_answers],
            found: vec![Vec::new(); of_answers],
        })
    }

    /// Takes the next row.
    pub fn push(&mut self, row: &Row<'_>) {
        for ((values, value), answer) in self.values.iter_mut().zip(row.answers).zip(&self.study.answers) {
            if value.is_finite() {
                values.push(answer.unit.si(*value));
            }
        }
        self.taken += 1;
        if !self.taken.is_multiple_of(self.samples) {
            return;
        }
        let x = self.study.design.inputs[self.x].unit.si(row.inputs[self.x]);
        for (values, found) in self.values.iter_mut().zip(&mut self.found) {
            values.sort_by(f64::total_cmp);
            let mean = values.iter().sum::<f64>() / values.len() as f64;
            let ends = [0.025, 0.975].map(|share| match values[..] {
                [] => f64::NAN,
                _ => quantile_of_sorted(values, share),
            });
            found.push((x, [mean, ends[0], ends[1]]));
            values.clear();
        }
    }

    /// A plot for each answer, with the points of the grid whose samples were all taken.
    pub fn plots(&self) -> Vec<Plot> {
        let input = &self.study.design.inputs[self.x];
        let plot = |(answer, found): (&Answer, &Vec<(f64, [f64; 3])>)| {
            let mut found = found.clone();
            found.sort_by(|(one, _), (other, _)| one.total_cmp(other));
            let series = ["mean", "2.5 %", "97.5 %"]
                .into_iter()
                .enumerate()
                .map(|(n, label)| Series::line(label, found.iter().map(|(x, of)| (*x, of[n])).collect()));
            along(input, self.scale, answer, series.collect())
        };
        self.study.answers.iter().zip(&self.found).map(plot).collect()
    }
}
