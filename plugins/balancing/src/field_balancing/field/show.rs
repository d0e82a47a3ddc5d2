//! Tables and drawings of a job.

use dalembert_core::{
    Axis, Cell, Column, Drawing, Exhibit, Ink, Plot, Series, TableExhibit, Text, Worksheet,
};
use dalembert_mechanics::balance::{self, influence};
use nalgebra::{Complex, DMatrix};

use super::{Field, Numbers, readings::Units};
use crate::shared::{rotor::letter, views::dial};

/// The most vector triangles that are drawn.
const MOST_TRIANGLES: usize = 4;

pub(super) fn all<W: Worksheet>(
    field: &Field,
    (numbers, factors): (&Numbers, &[f64]),
    (weights, left): (&[Complex<f64>], &[Complex<f64>]),
    units: Units,
    sheet: W,
) {
    sheet.show(|| Exhibit::Table(coefficients(&numbers.alpha, units.coefficient)));
    sheet.show(|| Exhibit::Table(readings(&numbers.first, left, units.reading)));
    if weights.len() > 1 {
        sheet.show(|| Exhibit::Table(left_out(numbers, factors, units.reading)));
    }
    if numbers.first.len() > 1 {
        sheet.show(|| Exhibit::Plot(before_and_after(&numbers.first, left, units.reading)));
    }
    sheet.show(|| Exhibit::Drawing(polar(field, numbers, weights)));
    for (row, first) in numbers.first.iter().enumerate().take(MOST_TRIANGLES) {
        if first.norm() > 0.0 {
            sheet.show(|| Exhibit::Drawing(triangle(numbers, row, *first)));
        }
    }
}

fn column(heading: &'static str, unit: &'static str) -> Column {
    Column { heading: heading.into(), unit }
}

/// As the input of a later job takes it.
fn coefficients(alpha: &DMatrix<Complex<f64>>, unit: &'static str) -> TableExhibit {
    let places = (0..alpha.ncols()).flat_map(|plane| (0..alpha.nrows()).map(move |row| (plane, row)));
    let row = |(plane, row): (usize, usize)| {
        let entry = alpha[(row, plane)];
        let number = |n: usize| Cell::Text(Text::new((n + 1).to_string()));
        vec![number(plane), number(row), entry.norm().into(), balance::marked_angle_found(entry.arg()).into()]
    };
    TableExhibit {
        title: "Influence coefficients, to be used again".into(),
        columns: vec![column("plane", ""), column("reading", ""), column("|α|", unit), column("∠α", "deg")],
        rows: places.map(row).collect(),
        foot: Vec::new(),
    }
}

fn readings(first: &[Complex<f64>], left: &[Complex<f64>], unit: &'static str) -> TableExhibit {
    let row = |(n, (before, after)): (usize, (&Complex<f64>, &Complex<f64>))| {
        let angle = |v: &Complex<f64>| {
            if v.norm() > 0.0 { balance::marked_angle_found(v.arg()).into() } else { Cell::Empty }
        };
        vec![
            Cell::Text(Text::new(n.to_string())),
            before.norm().into(),
            angle(before),
            after.norm().into(),
            angle(after),
        ]
    };
    TableExhibit {
        title: "Readings before and after".into(),
        columns: vec![
            column("reading", ""),
            column("before", unit),
            column("angle before", "deg"),
            column("after", unit),
            column("angle after", "deg"),
        ],
        rows: (1..).zip(first.iter().zip(left)).map(row).collect(),
        foot: Vec::new(),
    }
}

/// The readings of the initial run, in the sense of the weights.
pub(super) fn initial(first: &[Complex<f64>], unit: &'static str) -> TableExhibit {
    let row = |(n, reading): (usize, &Complex<f64>)| {
        let angle = balance::marked_angle_found(reading.arg());
        vec![Cell::Text(Text::new(n.to_string())), reading.norm().into(), angle.into()]
    };
    TableExhibit {
        title: "Readings of the initial run".into(),
        columns: vec![column("reading", ""), column("before", unit), column("angle before", "deg")],
        rows: (1..).zip(first).map(row).collect(),
        foot: Vec::new(),
    }
}

/// Table of the residual readings if one correction plane is omitted.
fn left_out(numbers: &Numbers, factors: &[f64], unit: &'static str) -> TableExhibit {
    let planes = numbers.alpha.ncols();
    let row = |out: Option<usize>| {
        let keep: Vec<usize> = (0..planes).filter(|plane| Some(*plane) != out).collect();
        let name = match out {
            Some(plane) => Text::new("plane {n}").with("n", plane + 1),
            None => "no plane".into(),
        };
        let alpha = numbers.alpha.select_columns(&keep);
        match influence::least_squares(&alpha, &numbers.first, factors) {
            Ok(solved) => {
                let most = |all: &[Complex<f64>]| all.iter().map(|x| x.norm()).fold(0.0, f64::max);
                let size = most(&numbers.first);
                let left = most(&solved.residuals);
                vec![
                    name.into(),
                    solved.condition.into(),
                    most(&solved.weights).into(),
                    if left < 1e-9 * size { 0.0 } else { left }.into(),
                ]
            }
            Err(_) => vec![name.into(), Cell::Empty, Cell::Empty, Cell::Empty],
        }
    };
    TableExhibit {
        title: "Leaving a plane out, by least squares".into(),
        columns: vec![
            column("plane left out", ""),
            column("condition", "1"),
            column("largest correction mass", "g"),
            column("largest reading", unit),
        ],
        rows: std::iter::once(None).chain((0..planes).map(Some)).map(row).collect(),
        foot: Vec::new(),
    }
}

fn before_and_after(first: &[Complex<f64>], left: &[Complex<f64>], unit: &'static str) -> Plot {
    let dots =
        |all: &[Complex<f64>]| (1..).zip(all).map(|(n, v)| (f64::from(n), v.norm())).collect::<Vec<_>>();
    Plot::new(
        "Readings before and after",
        Axis::linear("reading", "1"),
        Axis::linear("amplitude", unit),
        vec![Series::dots("before", dots(first)), Series::dots("predicted", dots(left))],
    )
}

/// Weights around the shaft.
fn polar(field: &Field, numbers: &Numbers, weights: &[Complex<f64>]) -> Drawing {
    let reach = numbers.runs.iter().map(|run| run.weight.norm()).chain(weights.iter().map(|w| w.norm()));
    let reach = reach.fold(0.0, f64::max);
    let mut sketch = dial("Trial weights (m) and corrections (W) around the shaft");
    let at = |weight: Complex<f64>| {
        let seen = field.seen(weight / reach);
        (seen.re, seen.im)
    };
    for (n, run) in (1..).zip(&numbers.runs) {
        let name = format!("{} ∠ {}", letter("m", n), letter("θ", n));
        sketch.force(Text::verbatim(name), (0.0, 0.0), at(run.weight));
    }
    for (n, weight) in (1..).zip(weights) {
        sketch.vector(Text::verbatim(letter("W", n)), (0.0, 0.0), at(*weight), Ink::Result);
    }
    sketch.finish()
}

/// The reading without and with the trial weights, and what the weights changed.
fn triangle(numbers: &Numbers, row: usize, first: Complex<f64>) -> Drawing {
    let reach = numbers.runs.iter().map(|run| run.readings[row].norm()).fold(first.norm(), f64::max);
    let at = |vector: Complex<f64>| (vector.re / reach, vector.im / reach);
    let mut sketch = dial(Text::new("Vectors of reading {n}").with("n", row + 1));
    let reading = |run: &str| Text::verbatim(format!("A{run} ∠ φ{run}"));
    let sensor = dalembert_units::subscript(row + 1);
    sketch.motion(reading(&format!("_0{sensor}")), (0.0, 0.0), at(first));
    let mut before = first;
    for (n, run) in (1..).zip(&numbers.runs) {
        let after = run.readings[row];
        let of_run = format!("{},{sensor}", dalembert_units::subscript(n));
        sketch.motion(reading(&of_run), (0.0, 0.0), at(after)).edge(
            Text::verbatim(letter("T", n)),
            at(before),
            at(after),
            Ink::Force,
        );
        if numbers.stay {
            before = after;
        }
    }
    sketch.finish()
}
