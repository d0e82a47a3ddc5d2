//! Check runs with the corrections in place: residual unbalance, conformity and trim.

use dalembert_core::{Refusal, Symbol, Text, Worksheet};
use dalembert_mechanics::{
    Real,
    balance::{self, influence},
};
use nalgebra::Complex;

use super::{
    Found, Numbers,
    numbers::vector,
    orthogonal,
    readings::{Units, WorkedReading},
    refusal,
    rotor::Demand,
};
use crate::sources::{DARLOW, ISO_TOLERANCES};

/// The newest state of the rotor: what its last check run says.
pub(super) struct Checked<N> {
    /// Trim masses, to be added to everything on the rotor.
    pub(super) trim: Vec<Found<N>>,
}

/// Assesses the check runs; `None` without one.
///
/// # Errors
/// A run without the readings of the initial one.
pub(super) fn assess<W: Worksheet>(
    (numbers, factors): (&Numbers, &[f64]),
    (checks, opposed, units): (&[Vec<WorkedReading<W::Num>>], bool, Units),
    (demand, radius): (Option<&Demand<W::Num>>, Option<W::Num>),
    sheet: W,
) -> Result<Option<Checked<W::Num>>, Refusal> {
    for (run, readings) in (1..).zip(checks) {
        same_number(run, readings.len(), numbers.first.len())?;
        let largest = readings.iter().map(|reading| reading.amplitude.value()).fold(0.0, f64::max);
        let how = "Largest reading of a check run, with the corrections in place";
        let largest = sheet.numerical(Symbol::from("A_max").row(run), units.reading, largest, how);
        sheet.answer(("check", run), "Largest vibration of check run", largest);
        if let (Some(Demand::Vibration { limit }), true) = (demand, run == checks.len()) {
            let why = "Largest reading over its limit: 1 at most";
            let ratio = sheet.step("q_r", "1", largest / *limit, why);
            conformity(ratio, sheet);
        }
    }
    let Some(last) = checks.last() else { return Ok(None) };
    let vectors: Vec<Complex<f64>> = last.iter().map(|reading| vector(reading, opposed)).collect();
    let solved = influence::least_squares(&numbers.alpha, &vectors, factors)
        .map_err(|error| refusal(error, &numbers.alpha))?;
    let how = "Mass that minimises the sum of squares of the last readings, added to everything on the rotor";
    let found = |(n, weight): (usize, &Complex<f64>)| Found {
        mass: sheet.numerical(("m_k", n), "g", weight.norm(), (how, DARLOW.at(""))),
        angle: sheet.numerical(
            ("θ_k", n),
            "deg",
            balance::marked_angle_found(weight.arg()),
            "Its angle from the mark",
        ),
    };
    let trim: Vec<Found<W::Num>> = (1..).zip(&solved.weights).map(found).collect();
    for (n, found) in (1..).zip(&trim) {
        sheet.answer(("trim_correction", n), "Trim mass in plane", found.mass);
        sheet.answer(("trim_correction_angle", n), "Angle of the trim mass in plane", found.angle);
    }
    sheet.verify(|| {
        let weights: Vec<Complex<f64>> =
            trim.iter().map(|w| Complex::from_polar(w.mass.value(), w.angle.value())).collect();
        let left = influence::residuals(&numbers.alpha, &vectors, &weights);
        orthogonal(&numbers.alpha, &left, &vectors, factors, sheet);
    });
    if let Some(radius) = radius {
        residuals(&trim, radius, demand, numbers.alpha.ncols(), sheet);
    }
    Ok(Some(Checked { trim }))
}

/// The residual unbalances, and the largest over what is permitted.
fn residuals<W: Worksheet>(
    trim: &[Found<W::Num>],
    radius: W::Num,
    demand: Option<&Demand<W::Num>>,
    planes: usize,
    sheet: W,
) {
    let mut worst: Option<W::Num> = None;
    for (n, found) in (1..).zip(trim) {
        let why = "Residual unbalance: what the trim would remove";
        let residual = sheet.step(("U_r", n), "g*mm", found.mass * radius, why);
        sheet.answer(("residual_unbalance", n), "Residual unbalance in plane", residual);
        if worst.is_none_or(|worst| residual.value() > worst.value()) {
            worst = Some(residual);
        }
    }
    let (Some(worst), Some(Demand::Unbalance { permissible, from: [grade, mass, speed] })) = (worst, demand)
    else {
        return;
    };
    let why = ("Residual over permissible unbalance: 1 at most", ISO_TOLERANCES.at(""));
    let ratio = sheet.step("q_r", "1", worst / *permissible, why);
    conformity(ratio, sheet);
    sheet.check(
        "speed of the centre of mass that the residual unbalance stands for, over the grade",
        ratio * *grade * *mass / planes as f64,
        worst * *speed,
    );
}

fn conformity<W: Worksheet>(ratio: W::Num, sheet: W) {
    sheet.answer("conformity", "Largest residual over permissible value", ratio);
    if ratio.value() > 1.0 {
        sheet.warn(|| {
            Text::new("the requirement is not met: the largest residual is {times} times the permissible; add the trim masses")
                .with("times", format!("{:.2}", ratio.value()))
        });
    }
}

fn same_number(run: usize, have: usize, want: usize) -> Result<(), Refusal> {
    if have == want {
        return Ok(());
    }
    Err(Refusal::because(
        Text::new(
            "check run {run} has {have} readings and the initial run {want}; write the same sensors in the same order",
        )
        .with("run", run)
        .with("have", have)
        .with("want", want),
    ))
}
