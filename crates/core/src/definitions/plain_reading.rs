//! The plain reading of a problem with definitions, formulas and questions.

use std::sync::Arc;

use super::Plan;
use crate::{Answer, Entry, Evaluate, FieldError, Record, Refusal, SolveError, Stop, Text, vary};

/// A problem with a plan, solved again and again with other values of its levers.
struct Planned {
    entry: Entry,
    record: Record,
    vary: Vec<String>,
    wanted: Vec<String>,
    /// The plain reading of the analysis, where every wanted answer is one of its own.
    plain: Option<PlainReading>,
}

/// The analysis alone, with the inputs that levers and formulas change.
struct PlainReading {
    evaluate: Box<dyn Evaluate>,
    inputs: Vec<String>,
}

/// Prepares the plain reading: `vary` are paths of quantities and names of definitions, `wanted` names of answers.
pub(crate) fn prepare(
    entry: &Entry,
    record: &Record,
    plan: &Plan,
    vary: &[&str],
    wanted: &[&str],
) -> Result<Box<dyn Evaluate>, SolveError> {
    let unknown =
        |path: &str, why: &'static str| SolveError::Fields(vec![FieldError::new(path, Text::from(why))]);
    for path in vary {
        if plan.has_formula(path) {
            return Err(unknown(
                path,
                "takes its value from a formula, so it cannot be varied; vary its definitions",
            ));
        }
    }
    let asked = |name: &&str| plan.questions.iter().any(|question| question.key == *name);
    let plain = if wanted.iter().any(asked) || plan.search().is_some() {
        None
    } else {
        let mut inputs: Vec<String> = vary
            .iter()
            .filter(|path| !plan.levers().any(|(name, ..)| name == **path))
            .map(|path| (*path).to_owned())
            .collect();
        let with_formula = plan.inputs.iter().filter(|input| input.formula.is_some());
        inputs.extend(with_formula.map(|input| input.path.clone()));
        let bare = Record { plan: None, ..record.clone() };
        let paths: Vec<&str> = inputs.iter().map(String::as_str).collect();
        Some(PlainReading { evaluate: entry.prepare(&bare, &paths, wanted)?, inputs })
    };
    let mut record = record.clone();
    if plain.is_none() {
        let solution = entry.solve(&record, &Stop::new())?;
        if let (Some(plan), Some(determined)) = (&mut record.plan, &solution.determined) {
            Arc::make_mut(plan).keep_ranges(determined);
        }
        for name in wanted {
            if solution.answer(name).and_then(Answer::si).is_none() {
                return Err(unknown(name, "is not a number among the answers"));
            }
        }
    }
    Ok(Box::new(Planned {
        entry: *entry,
        record,
        vary: vary.iter().map(|path| (*path).to_owned()).collect(),
        wanted: wanted.iter().map(|name| (*name).to_owned()).collect(),
        plain,
    }))
}

impl Planned {
    fn point(&mut self, point: &[f64], row: &mut [f64], stop: &Stop) -> Result<(), Refusal> {
        let changed = self
            .vary
            .iter()
            .zip(point)
            .try_fold(self.record.clone(), |record, (path, si)| vary::changed(&record, path, *si));
        let Some(mut changed) = changed else {
            row.fill(f64::NAN);
            return Ok(());
        };
        if let Some(plain) = &mut self.plain {
            let point: Option<Vec<f64>> =
                plain.inputs.iter().map(|path| vary::number(&mut changed, path).copied()).collect();
            // Without an input there is still one point.
            let point = point.filter(|point| !point.is_empty()).unwrap_or_else(|| vec![0.0]);
            return plain.evaluate.sweep(&point, row, stop);
        }
        match self.entry.solve(&changed, stop) {
            Err(SolveError::Refused(Refusal::Stopped)) => Err(Refusal::Stopped),
            Err(_) => {
                row.fill(f64::NAN);
                Ok(())
            }
            Ok(solution) => {
                for (place, name) in row.iter_mut().zip(&self.wanted) {
                    *place = solution.answer(name).and_then(Answer::si).unwrap_or(f64::NAN);
                }
                Ok(())
            }
        }
    }
}

impl Evaluate for Planned {
    fn sweep(&mut self, points: &[f64], answers: &mut [f64], stop: &Stop) -> Result<(), Refusal> {
        let (columns, wanted) = (self.vary.len().max(1), self.wanted.len().max(1));
        for (point, row) in points.chunks(columns).zip(answers.chunks_mut(wanted)) {
            stop.check()?;
            self.point(&point[..self.vary.len().min(point.len())], row, stop)?;
        }
        Ok(())
    }
}
