//! Plots of analyses as they are read on a screen: their axes, their marks, their scales.

use std::f64::consts::TAU;

use dalembert_core::{
    AnswerValue, Entry, Exhibit, Locale, Number, Plot, Scale, Series, Solution, Stop, cases, vary,
};
use dalembert_plot::{
    look::Appearance,
    plot::{self, PlotState},
};
use dalembert_terminal::glyphs::Colors;
use dalembert_units::unit;
use ratatui::{buffer::Buffer, layout::Rect};

use crate::{problems::first_solutions, some};

/// Sizes of panes, the smallest with a title at both axes first.
const SIZES: [(u16, u16); 4] = [(38, 8), (38, 14), (56, 18), (110, 30)];

/// Reads both axes of every plot back from the screen, in several sizes, in English and Portuguese, with and without ASCII:
/// no unit and no power of ten is cut, so that the largest number at an axis is one of the size of the data. Returns the
/// number of axes.
pub fn every_axis_is_read_back(entries: &[&'static Entry]) -> usize {
    let (mut read, mut wrong) = (0, Vec::new());
    for (entry, solution) in first_solutions(entries) {
        for plot in plots(&solution) {
            for size in SIZES {
                for (locale, ascii) in
                    [(Locale::english(), false), (Locale::english(), true), (Locale::portuguese(), false)]
                {
                    let locale = locale.at(entry.about.id);
                    let rows = drawn(plot, size, ascii, &locale);
                    for (name, found) in [("y", upright(&rows)), ("x", level(&rows))] {
                        read += 1;
                        let data = largest(plot, name == "x");
                        let scale = if name == "x" { plot.x.scale } else { plot.y.scale };
                        // Below a plot that is wider than its data there are numbers beyond them.
                        let beyond = if plot.equal { 40.0 } else { 4.0 };
                        let fits = match found {
                            Some(label) if scale == Scale::Linear => {
                                label == 0.0 || (0.02 * data..=beyond * data).contains(&label)
                            }
                            Some(label) => (1e-12 * data..=1000.0 * data).contains(&label),
                            None => false,
                        };
                        if !fits && data > 0.0 {
                            wrong.push(format!(
                                "{}: {}, {name} at {size:?}: {found:?} and not about {data:e}\n{}",
                                entry.about.id,
                                plot.title.english(),
                                rows.join("\n")
                            ));
                        }
                    }
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{} axes:\n{}", wrong.len(), wrong.join("\n"));
    read
}

/// Finds the answer of the problem as it is on every curve over an angle that is an input. Returns the number of plots.
pub fn every_plot_over_an_angle_marks_the_given_one(entries: &[&'static Entry]) -> usize {
    some(entries);
    let mut seen = 0;
    for entry in entries {
        let Some(record) = cases::first(entry).and_then(|case| case.record(entry).ok()) else { continue };
        let Ok(solution) = entry.solve(&record, &Stop::new()) else { continue };
        let inputs = vary::inputs(&record);
        for plot in plots(&solution).filter(|plot| plot.x.unit == "deg") {
            let Some(over) = plot.over.as_ref().filter(|over| over.answer.is_none()) else { continue };
            let Some(given) = inputs.iter().find(|input| input.path == over.input) else { continue };
            seen += 1;
            let here: Vec<f64> = plot
                .marks
                .iter()
                .filter(|mark| is_turned(mark.at.0, given.si))
                .map(|mark| mark.at.1)
                .collect();
            assert!(
                !here.is_empty(),
                "{}: no mark of `{}` at {} rad",
                entry.about.id,
                plot.title.english(),
                given.si
            );
            for series in plot.series.iter().filter(|series| series.with.is_empty()) {
                let Some(answer) = answer(&solution, series) else { continue };
                let is_marked = here.iter().any(|y| (y - answer).abs() <= 1e-9 * answer.abs().max(1e-9));
                let at = plot.marks.iter().map(|mark| (mark.label.english(), mark.at)).collect::<Vec<_>>();
                assert!(
                    is_marked || here.len() < plot.series.len(),
                    "{}: {answer} is not among {at:?}",
                    entry.about.id
                );
            }
        }
    }
    seen
}

/// Plots of two components of one quantity that are not of equal scales, by `analysis | title`, but for those that are
/// over an input.
pub fn planes_of_unequal_scales(entries: &[&'static Entry]) -> Vec<String> {
    let mut found = Vec::new();
    for (entry, solution) in first_solutions(entries) {
        for plot in plots(&solution) {
            let is_plane = plot.x.unit == plot.y.unit && !matches!(plot.x.unit, "" | "1");
            let is_linear = [&plot.x, &plot.y].iter().all(|axis| axis.scale == Scale::Linear);
            let is_curve = plot.over.as_ref().is_some_and(|over| over.answer.is_none());
            if is_plane && is_linear && !is_curve && !plot.equal {
                found.push(format!("{} | {}", entry.about.id, plot.title.template));
            }
        }
    }
    found
}

/// The text of a plot on a screen of that size.
pub fn drawn(plot: &Plot, (width, height): (u16, u16), ascii: bool, locale: &Locale) -> Vec<String> {
    let look = Appearance { ascii, colors: Colors::None, ..Appearance::default() };
    let area = Rect::new(0, 0, width, height);
    let mut buffer = Buffer::empty(area);
    plot::render(plot, None, &PlotState::default(), &look, locale, area, &mut buffer);
    (0..height).map(|y| (0..width).map(|x| buffer[(x, y)].symbol()).collect()).collect()
}

fn plots(solution: &Solution) -> impl Iterator<Item = &Plot> {
    solution.exhibits.iter().filter_map(|exhibit| match exhibit {
        Exhibit::Plot(plot) => Some(plot),
        _ => None,
    })
}

/// True if two angles differ by whole turns.
fn is_turned(a: f64, b: f64) -> bool {
    let turns = (a - b) / TAU;
    (turns - turns.round()).abs() < 1e-9
}

fn answer(solution: &Solution, series: &Series) -> Option<f64> {
    let of = series.of.as_deref()?;
    let answer = solution.answers.iter().find(|answer| answer.name.is(of))?;
    match &answer.value {
        AnswerValue::Number(Number::Scalar(si), _) => Some(*si),
        _ => None,
    }
}

/// The largest size of an abscissa or an ordinate, in SI, of what can be shown.
fn largest(plot: &Plot, across: bool) -> f64 {
    let points =
        plot.series.iter().flat_map(|series| &series.points).chain(plot.marks.iter().map(|mark| &mark.at));
    let shown = points.filter(|at| at.0.is_finite() && at.1.is_finite());
    shown.map(|at| if across { at.0.abs() } else { at.1.abs() }).fold(0.0, f64::max)
}

/// The largest size of a number at the vertical axis, in SI by the unit above it; `None` where either cannot be read.
fn upright(rows: &[String]) -> Option<f64> {
    // What stands left of the axis is a number, or nothing.
    let label = |row: &String| {
        let (before, _) = row.split_once(['┤', '│', '|', '+'])?;
        let before = before.trim();
        if before.is_empty() { Some(0.0) } else { number(before) }
    };
    let first = rows.iter().position(|row| label(row).is_some())?;
    let all = rows[first..].iter().filter_map(label).map(f64::abs);
    Some(all.fold(0.0, f64::max) * factor(&rows[..first], false)?)
}

/// The same of the horizontal axis, by the unit below it, or on it.
fn level(rows: &[String]) -> Option<f64> {
    let axis = rows.iter().rposition(|row| row.contains('└') || row.trim_start().starts_with('+'))?;
    let factor = factor(&rows[axis..], true)?;
    let all = rows.get(axis + 1)?.split_whitespace().filter_map(number).map(f64::abs);
    Some(all.fold(0.0, f64::max) * factor)
}

/// Size of the unit in the brackets of a title, one where it has none.
fn factor(rows: &[String], last: bool) -> Option<f64> {
    let text = rows.join(" ");
    let brackets = if last { text.rfind('[') } else { text.find('[') };
    let Some(begin) = brackets else {
        // A name without a unit, or nothing at all.
        return text.chars().any(char::is_alphabetic).then_some(1.0);
    };
    let inside =
        text[begin + 1..].split(']').next().filter(|inside| text[begin..].len() > inside.len() + 1)?;
    let (ten, symbol) = match inside.split_once(' ') {
        Some((ten, symbol)) => (number(ten)?, symbol),
        None => number(inside).map_or((1.0, inside), |ten| (ten, "")),
    };
    Some(ten * if symbol.is_empty() { 1.0 } else { unit(symbol).ok()?.factor })
}

/// A number as an axis has it: `−0.5`, `1e-6`, `10⁻⁶`, `0,5`.
fn number(text: &str) -> Option<f64> {
    let plain = text.replace('−', "-").replace(',', ".");
    if let Some(power) = plain.strip_prefix("10").filter(|power| power.starts_with(is_raised)) {
        return format!("1e{}", power.chars().map(lowered).collect::<String>()).parse().ok();
    }
    plain.parse().ok()
}

fn is_raised(c: char) -> bool {
    lowered(c) != c
}

fn lowered(c: char) -> char {
    const RAISED: [(char, char); 11] = [
        ('⁻', '-'),
        ('⁰', '0'),
        ('¹', '1'),
        ('²', '2'),
        ('³', '3'),
        ('⁴', '4'),
        ('⁵', '5'),
        ('⁶', '6'),
        ('⁷', '7'),
        ('⁸', '8'),
        ('⁹', '9'),
    ];
    RAISED.iter().find(|(raised, _)| *raised == c).map_or(c, |(_, plain)| *plain)
}
