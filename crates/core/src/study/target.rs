//! The values of an input at which an answer is a wanted one.

use crate::{
    Answer, Entry, Plot, Record, Refusal, Scale, Series, SolveError, Stop, Text,
    intern::fixed,
    study::curves::{along, gaps, no_answer},
    unknowns::search::{Target, Variable, search},
    vary::{self, Perturbed},
};

/// The values of an input at which an answer is a wanted one, and the curve that they were found on.
#[derive(Clone, Debug, Default)]
pub struct FoundTarget {
    /// The values in SI, ascending.
    pub values: Vec<f64>,
    /// The values in words, or why there are none; ranges without an answer.
    pub remarks: Vec<Text>,
    /// The points examined, ascending, each with the answer there in SI; NaN where there is none.
    pub scan: Vec<(f64, f64)>,
    /// The answer over the input; `None` where it does not depend on it.
    pub plot: Option<Plot>,
}

/// Finds the values of an input in a range at which an answer is a wanted one, all in SI.
///
/// # Errors
/// Why the problem as given has no answer, or what does not fit it.
pub fn find_target(
    entry: &Entry,
    record: &Record,
    (input, range): (&str, [f64; 2]),
    (answer, wanted): (&Answer, f64),
    stop: &Stop,
) -> Result<FoundTarget, SolveError> {
    let inputs = vary::inputs(record);
    let input = inputs.iter().find(|known| known.path == input).cloned().ok_or_else(|| {
        Refusal::because("this input is not a number of the problem with its present options")
    })?;
    let range = [range[0].min(range[1]), range[0].max(range[1])];
    if !range.iter().all(|end| end.is_finite()) || range[0] == range[1] {
        return Err(Refusal::because("the range is empty: enter two different limits").into());
    }
    let mut again = Perturbed::new(entry, record, vec![input.clone()], vec![answer.name.to_string()])?;
    if again.answers.is_empty() || again.inputs.is_empty() {
        return Err(Refusal::because("this input cannot be varied").into());
    }
    let variable = Variable::new(range, None);
    let scale = if variable.is_logarithmic { Scale::Log } else { Scale::Linear };
    let mut evaluate = |x: &[f64]| again.with(&[(0, x[0])], stop);
    let searched = search(&mut evaluate, &[variable], &[Target { si: wanted, tolerance: None }], stop)?;
    if searched.without_influence.is_some() {
        let remark = Text::new("{answer} does not depend on {input}")
            .with_text("answer", answer.title())
            .with_text("input", input.label);
        let scan = searched.scan;
        return Ok(FoundTarget { remarks: vec![remark], scan, ..FoundTarget::default() });
    }
    let values: Vec<f64> = searched.solutions.iter().map(|solution| solution[0]).collect();
    let (x_unit, y_unit) = (fixed(&input.unit), fixed(&answer.unit));
    let mut remarks: Vec<Text> = values
        .iter()
        .map(|x| {
            Text::new("{input} = {value}")
                .with_text("input", input.label.clone())
                .with_quantity("value", *x, x_unit)
        })
        .collect();
    if values.is_empty() {
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
    let (places, found): (Vec<f64>, Vec<f64>) = searched.scan.iter().copied().unzip();
    remarks.extend(gaps(&found).into_iter().map(|(first, last)| {
        let middle = places[usize::midpoint(first, last)];
        let why = vary::why_not(entry, record, (&input, middle), &answer.name.to_string(), stop);
        no_answer([places[first], places[last]], x_unit, why)
    }));
    let curve = vec![Series::line(answer.title(), searched.scan.clone())];
    let mut plot = along(&input, scale, answer, curve).level("target", wanted);
    for x in &values {
        plot = plot.mark("", (*x, wanted));
    }
    Ok(FoundTarget { values, remarks, scan: searched.scan, plot: Some(plot) })
}
