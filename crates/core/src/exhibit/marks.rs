//! Marks of a problem on the plots that are over its inputs.

use std::f64::consts::TAU;

use super::{Exhibit, Mark, Plot, Series};
use crate::{Answer, AnswerValue, Number, Record, Text, Value};

/// The most curves of a plot that are marked; of more, the names would cover them.
const MOST: usize = 7;

/// Marks the answers on every plot over an input that has no mark there. What ends at the given value, a motion at its
/// duration, needs none; neither does a curve that is broken there.
pub(crate) fn mark_given(exhibits: &mut [Exhibit], record: &Record, answers: &[Answer]) {
    for exhibit in exhibits {
        let Exhibit::Plot(plot) = exhibit else { continue };
        let Some(input) = plot.over.as_ref().and_then(|over| value_at(record, &over.input)) else { continue };
        let marks = marks(plot, record, input, answers);
        plot.marks.extend(marks);
    }
}

fn marks(plot: &Plot, record: &Record, input: f64, answers: &[Answer]) -> Vec<Mark> {
    let over_answer = plot.over.as_ref().and_then(|over| over.answer.as_deref());
    let x = match over_answer {
        None => Some(input),
        Some(name) => number(answers, name),
    };
    let Some(x) = x else { return Vec::new() };
    // A curve for comparison is that of the problem where the problem has the same value; what is left out counts as zero.
    let is_given = |(path, si): &(String, f64)| value_at(record, path).unwrap_or(0.0) == *si;
    let curves = plot.series.iter().filter(|series| series.joined && series.with.iter().all(is_given));
    let mut marked: Vec<(&Series, (f64, f64))> = Vec::new();
    for series in curves {
        let y = series.of.as_deref().and_then(|of| number(answers, of));
        if let Some(at) = reached(plot, series, x, input).zip(y)
            && marked.iter().all(|(_, other)| *other != at)
        {
            marked.push((series, at));
        }
    }
    let is_marked = |x: f64| plot.marks.iter().any(|mark| (mark.at.0 - x).abs() <= 1e-9 * x.abs());
    if marked.len() > MOST || marked.iter().any(|(_, (x, _))| is_marked(*x)) {
        return Vec::new();
    }
    let is_alone = plot.series.len() == 1 || marked.len() == 1;
    let label = |series: &Series, x: f64| match (over_answer.is_some(), is_alone) {
        (true, _) => Text::new("here"),
        (false, true) => Text::new("at {value}").with_quantity("value", x, plot.x.unit),
        (false, false) => on_curve(series.label.clone(), x, plot.x.unit),
    };
    marked.into_iter().map(|(series, at)| Mark { label: label(series, at.0), at }).collect()
}

/// Name of a mark on a curve, one of several.
pub(super) fn on_curve(curve: Text, x: f64, unit: &'static str) -> Text {
    Text::new("{curve} at {value}").with_text("curve", curve).with_quantity("value", x, unit)
}

/// The abscissa of a value of the input on a curve, for an angle perhaps turns further on; `None` where the curve has no
/// point around it, or ends there.
fn reached(plot: &Plot, series: &Series, x: f64, input: f64) -> Option<f64> {
    let is_angle = plot.x.unit == "deg";
    if !series.at.is_empty() {
        let last = *series.at.last()?;
        return (is_between(series, &series.at, input) && input != last).then_some(x);
    }
    let abscissas: Vec<f64> = series.points.iter().map(|at| at.0).collect();
    let turns: &[f64] = if is_angle { &[0.0, 1.0, -1.0, 2.0, -2.0] } else { &[0.0] };
    let all = turns.iter().map(|turns| x + TAU * turns);
    let ends = |x: f64| !is_angle && abscissas.last().is_some_and(|last| x >= *last);
    all.into_iter().find(|x| is_between(series, &abscissas, *x) && !ends(*x))
}

/// True if a curve is drawn on either side of a value of what it runs over.
fn is_between(series: &Series, over: &[f64], value: f64) -> bool {
    let drawn = |at: &(f64, f64)| at.0.is_finite() && at.1.is_finite();
    over.windows(2).zip(series.points.windows(2)).any(|(over, points)| {
        let within = (over[0].min(over[1]), over[0].max(over[1]));
        let room = 1e-9 * (within.1 - within.0);
        (within.0 - room..=within.1 + room).contains(&value) && points.iter().all(drawn)
    })
}

/// A number at the path of an input, if it has a value.
fn value_at(record: &Record, path: &str) -> Option<f64> {
    let mut found = None;
    record.leaves(&mut |leaf, _, value| match (value, path.strip_prefix(leaf)) {
        (Value::Quantity(quantity), Some("")) => found = Some(quantity.si),
        (Value::Vector(vector), Some(axis)) => {
            let at = [".x", ".y", ".z"].iter().position(|known| *known == axis);
            found = at.filter(|at| *at < vector.len).map(|at| vector.si[at]).or(found);
        }
        _ => {}
    });
    found
}

/// The number that a curve names: an answer, the size or a component of a vector, a size alone.
fn number(answers: &[Answer], name: &str) -> Option<f64> {
    if let Some(name) = name.strip_prefix('|').and_then(|name| name.strip_suffix('|')) {
        return number(answers, name).map(f64::abs);
    }
    let of_name = |name: &str| answers.iter().find(|answer| answer.name.is(name)).map(|answer| &answer.value);
    match of_name(name) {
        Some(AnswerValue::Number(Number::Scalar(si), _)) => return Some(*si),
        Some(AnswerValue::Number(Number::Vector(si), _)) => {
            return Some(si.iter().map(|x| x * x).sum::<f64>().sqrt());
        }
        _ => {}
    }
    let (vector, axis) = name.rsplit_once('.')?;
    let axis = ["x", "y", "z"].iter().position(|known| *known == axis)?;
    match of_name(vector) {
        Some(AnswerValue::Number(Number::Vector(si), _)) => si.get(axis).copied(),
        _ => None,
    }
}
