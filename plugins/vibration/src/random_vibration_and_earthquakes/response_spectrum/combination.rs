//! The largest responses of modes combined.

use dalembert_core::{Symbol, Worksheet};
use dalembert_mechanics::Real;

use crate::sources::CHOPRA;

/// The three ways to add the largest responses of modes, which come at different times.
#[derive(Clone, Copy)]
pub(super) struct Combined<N> {
    pub(super) abs: N,
    pub(super) srss: N,
    pub(super) cqc: N,
}

/// Common errors of a sum of modes.
const SIGNED: &str = "the responses of the modes added with their signs";
const FIRST_MODE: &str = "the first mode alone counted";

/// Writes the three sums of the responses of modes.
pub(super) fn combined<W: Worksheet>(
    parts: &[W::Num],
    correlations: &[Vec<W::Num>],
    [abs, srss, cqc]: [&'static str; 3],
    unit: &'static str,
    row: Option<usize>,
    sheet: W,
) -> Combined<W::Num> {
    if let [alone] = parts {
        return Combined { abs: *alone, srss: *alone, cqc: *alone };
    }
    let symbol = |base: &'static str| row.map_or(Symbol::from(base), |row| Symbol::from(base).row(row));
    let why =
        ("Absolute sum: all modes at their maximum at the same time, an upper bound", CHOPRA.at("§13.7"));
    let signed = || W::Num::sum(parts.iter().copied()).abs();
    sheet.common_error(symbol(abs), SIGNED, signed);
    let abs = sheet.step(symbol(abs), unit, W::Num::sum(parts.iter().map(|part| part.abs())), why);
    let why = ("Square root of the sum of squares (SRSS): well-separated modes", CHOPRA.at("§13.7"));
    let squares = W::Num::sum(parts.iter().map(|part| part.powi(2)));
    sheet.common_error(symbol(srss), SIGNED, signed);
    sheet.common_error(symbol(srss), FIRST_MODE, || parts[0].abs());
    let srss = sheet.step(symbol(srss), unit, squares.sqrt(), why);
    let mut terms: Vec<W::Num> = parts.iter().map(|part| part.powi(2)).collect();
    for i in 0..parts.len() {
        for j in i + 1..parts.len() {
            terms.push(correlations[i][j] * parts[i] * parts[j] * 2.0);
        }
    }
    let why = (
        "Complete quadratic combination: with the correlation of closely spaced modes and the signs",
        CHOPRA.at("§13.7"),
    );
    let with_cross = |term: &dyn Fn(usize, usize) -> W::Num| {
        let pairs = (0..parts.len()).flat_map(|i| (i + 1..parts.len()).map(move |j| (i, j)));
        (squares + W::Num::sum(pairs.map(|(i, j)| term(i, j)))).sqrt()
    };
    let unsigned = || with_cross(&|i, j| correlations[i][j] * (parts[i] * parts[j]).abs() * 2.0);
    sheet.common_error(symbol(cqc), "the signs of the modes dropped in the cross terms", unsigned);
    let once = || with_cross(&|i, j| correlations[i][j] * parts[i] * parts[j]);
    sheet.common_error(symbol(cqc), "the cross term of each pair of modes counted only once", once);
    let cqc = sheet.step(symbol(cqc), unit, W::Num::sum(terms).sqrt(), why);
    sheet.verify(|| {
        let products = (0..parts.len()).flat_map(|i| (0..i).map(move |j| (i, j)));
        let twice = W::Num::sum(products.map(|(i, j)| (parts[i] * parts[j]).abs() * 2.0));
        let what = "square of the sum of absolute values: sum of squares plus twice all products";
        sheet.check(what, srss.powi(2) + twice, abs.powi(2));
        let what = "complete quadratic combination as the length of a sum of vectors, their cosines the correlations";
        let length = vector_length(parts, correlations);
        sheet.check_sum(what, cqc.powi(2), length.powi(2).into(), abs.value().powi(2));
    });
    Combined { abs, srss, cqc }
}

/// The length of the sum of vectors as long as the responses, between which the correlations are the cosines: Cholesky's
/// factor of the correlations has their directions in its rows.
fn vector_length<N: Real>(parts: &[N], correlations: &[Vec<N>]) -> f64 {
    let count = parts.len();
    let mut rows = vec![vec![0.0; count]; count];
    let mut sum = 0.0;
    for column in 0..count {
        let dot = |rows: &[Vec<f64>], row: usize| {
            (0..column).map(|place| rows[row][place] * rows[column][place]).sum::<f64>()
        };
        let pivot = (correlations[column][column].value() - dot(&rows, column)).max(0.0).sqrt();
        for row in column..count {
            let left = correlations[row][column].value() - dot(&rows, row);
            rows[row][column] = if pivot > 0.0 { left / pivot } else { 0.0 };
        }
        let along: f64 = parts.iter().zip(&rows).map(|(part, row)| part.value() * row[column]).sum();
        sum += along * along;
    }
    sum.sqrt()
}
