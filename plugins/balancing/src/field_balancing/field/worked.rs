//! The jobs that textbooks work by hand: one plane with one sensor, two planes with two sensors.

use dalembert_core::{Symbol, Worksheet};
use dalembert_mechanics::{
    Real,
    balance::{self, Phasor, two_plane_weights},
};
use std::f64::consts::PI;

use super::{
    Found, Influence, Job,
    readings::{Units, WorkedReading, WorkedRun},
};
use crate::{shared::rotor, sources::RAO};

/// The error of readings with the run-out in them.
const RUN_OUT_LEFT: &str = "the run-out not subtracted";
/// The error of a correction computed from a trial run.
const AFTER_TRIAL: &str = "the reading of the trial run used, although the trial weight was taken off";
/// The error of a correction on the side of the unbalance.
const AT_HEAVY_SPOT: &str = "the correction mass placed at the heavy spot";

/// The corrections, worked; `None` where the job is not one of the textbooks'.
pub(super) fn solve<W: Worksheet>(job: &Job<W::Num>, opposed: bool, sheet: W) -> Option<Vec<Found<W::Num>>> {
    let Influence::Runs { stay, runs } = &job.influence else { return None };
    let in_order = runs.iter().enumerate().all(|(n, run)| run.plane == n);
    if !in_order || runs.len() != job.first.len() {
        return None;
    }
    match runs.as_slice() {
        [run] => Some(vec![triangle(job, run, *stay, opposed, sheet)]),
        [_, _] => Some(two_planes(job, runs, *stay, opposed, sheet)),
        _ => None,
    }
}

/// The phase in the sense in which weights are counted.
fn phase<N: Real>(reading: &WorkedReading<N>, opposed: bool) -> N {
    if opposed { -reading.phase } else { reading.phase }
}

/// A reading by its components.
fn components<W: Worksheet>(
    symbols: [Symbol; 2],
    reading: &WorkedReading<W::Num>,
    opposed: bool,
    unit: &'static str,
    sheet: W,
) -> Phasor<W::Num> {
    let vector = Phasor::polar(reading.amplitude, phase(reading, opposed));
    let why = "Component of the reading";
    let [x, y] = symbols;
    Phasor { x: sheet.step(x, unit, vector.x, why), y: sheet.step(y, unit, vector.y, why) }
}

/// The vector triangle of one plane and one sensor.
fn triangle<W: Worksheet>(
    job: &Job<W::Num>,
    run: &WorkedRun<W::Num>,
    stay: bool,
    opposed: bool,
    sheet: W,
) -> Found<W::Num> {
    let (first, units) = (&job.first[0], job.units);
    let trial = &run.readings[0];
    let before = components(["V_x".into(), "V_y".into()], first, opposed, units.reading, sheet);
    let after = components(["R_x".into(), "R_y".into()], trial, opposed, units.reading, sheet);
    let change = after.minus(before);
    let why = ("The trial weight alone: the reading with it less the reading without it", RAO.at("§9.4.1"));
    let change = Phasor {
        x: sheet.step("T_x", units.reading, change.x, why),
        y: sheet.step("T_y", units.reading, change.y, why),
    };
    let what = "the reading with the trial weight taken for the effect of the weight alone";
    sheet.common_error("T", what, || trial.amplitude);
    sheet.common_error("ψ", what, || phase(trial, opposed));
    let what = "the readings with and without the trial weight added as vectors";
    sheet.common_error("T", what, || after.plus(before).size());
    sheet.common_error("ψ", what, || after.plus(before).angle());
    let what = "the amplitudes subtracted as numbers, the phases ignored";
    sheet.common_error("T", what, || (trial.amplitude - first.amplitude).abs());
    let effect = sheet.step("T", units.reading, change.size(), "Magnitude of the effect of the trial weight");
    rotor::quadrant_ignored(sheet, "ψ", (change.x, change.y));
    let direction = sheet.step("ψ", "deg", change.angle(), "Its angle");
    let law_of_cosines = (first.amplitude.powi(2) + trial.amplitude.powi(2)
        - first.amplitude * trial.amplitude * 2.0 * (trial.phase - first.phase).cos())
    .sqrt();
    // The law of cosines squares, which takes half the digits of a small effect.
    let size = first.amplitude.value().max(trial.amplitude.value());
    if effect.value() > 1e-3 * size {
        sheet.check("effect of the trial weight by the law of cosines", law_of_cosines, effect);
    }
    let alpha = sheet.step(
        "α",
        units.coefficient,
        effect / run.mass,
        ("Influence coefficient: vibration per unit mass", RAO.at("§9.4.2")),
    );
    // The run-out is in both readings, so that it does not change the effect.
    let raw = job.raw.as_ref().map(|raw| (raw[0], RUN_OUT_LEFT));
    let instead = raw.into_iter().chain((!stay).then_some((*trial, AFTER_TRIAL)));
    for (reading, what) in instead {
        sheet.common_error("m_c", what, || reading.amplitude / alpha);
        sheet.common_error("θ_c", what, || {
            balance::marked_angle(run.angle + (phase(&reading, opposed) - direction) + PI)
        });
    }
    let mass = sheet.step(
        "m_c",
        "g",
        first.amplitude / alpha,
        ("Mass whose effect has the amplitude of the initial reading", RAO.at("§9.4.1")),
    );
    let angle = run.angle + (phase(first, opposed) - direction) + PI;
    let why = (
        "From the trial weight, rotate by the angle from its effect to the initial reading, then by 180° to oppose it",
        RAO.at("§9.4.1"),
    );
    let what = "the angle from the effect to the initial reading laid off in the opposite sense";
    sheet.common_error("θ_c", what, || {
        balance::marked_angle(run.angle - (phase(first, opposed) - direction) + PI)
    });
    sheet.common_error("θ_c", AT_HEAVY_SPOT, || {
        balance::marked_angle(run.angle + (phase(first, opposed) - direction))
    });
    sheet.common_error("θ_c", "the correction placed opposite to the initial reading itself", || {
        balance::marked_angle(phase(first, opposed) + PI)
    });
    Found { mass, angle: sheet.step("θ_c", "deg", balance::marked_angle(angle), why) }
}

/// Two planes and two sensors: four influence coefficients and Cramer's rule.
fn two_planes<W: Worksheet>(
    job: &Job<W::Num>,
    runs: &[WorkedRun<W::Num>],
    stay: bool,
    opposed: bool,
    sheet: W,
) -> Vec<Found<W::Num>> {
    let Units { reading, coefficient } = job.units;
    let two = |symbols: [Symbol; 2], unit, vector: Phasor<W::Num>, why: &'static str| {
        let [x, y] = symbols;
        let cite = || (why, RAO.at("§9.4.2"));
        Phasor { x: sheet.step(x, unit, vector.x, cite()), y: sheet.step(y, unit, vector.y, cite()) }
    };
    let vectors = |bases: [&'static str; 2], readings: &[WorkedReading<W::Num>], run: Option<usize>| {
        let symbol = |base: &'static str, n: usize| {
            let symbol = Symbol::from(base);
            run.map_or(symbol, |run| symbol.row(run)).row(n)
        };
        let of = |(n, read): (usize, &WorkedReading<W::Num>)| {
            components(bases.map(|base| symbol(base, n)), read, opposed, reading, sheet)
        };
        (1..).zip(readings).map(of).collect::<Vec<_>>()
    };
    let first = vectors(["V_x", "V_y"], &job.first, None);
    let mut before = first.clone();
    let mut alpha = Vec::new();
    for (n, run) in (1..).zip(runs) {
        let weight = two(
            [("m_x", n).into(), ("m_y", n).into()],
            "g",
            Phasor::polar(run.mass, run.angle),
            "Component of the trial weight",
        );
        let after = vectors(["R_x", "R_y"], &run.readings, Some(n));
        let column: Vec<Phasor<W::Num>> = (1..)
            .zip(after.iter().zip(&before))
            .map(|(sensor, (after, before))| {
                two(
                    ["α_x", "α_y"].map(|base| Symbol::from(base).row(sensor).row(n)),
                    coefficient,
                    after.minus(*before).over(weight),
                    "Influence coefficient: change due to the trial weight, over its mass",
                )
            })
            .collect();
        alpha.push(column);
        if stay {
            before = after;
        }
    }
    let [a11, a21, a12, a22] = [alpha[0][0], alpha[0][1], alpha[1][0], alpha[1][1]];
    let raw = job.raw.as_deref().map(|raw| (raw, RUN_OUT_LEFT));
    let instead = raw.into_iter().chain((!stay).then_some((runs[1].readings.as_slice(), AFTER_TRIAL)));
    for (readings, what) in instead {
        let found = |n: usize| {
            let vector = |at: usize| Phasor::polar(readings[at].amplitude, phase(&readings[at], opposed));
            two_plane_weights([[a11, a12], [a21, a22]], [vector(0), vector(1)])[n]
        };
        for n in 0..2 {
            sheet.common_error(("m_c", n + 1), what, || found(n).size());
            sheet.common_error(("θ_c", n + 1), what, || found(n).marked_angle());
        }
    }
    (1..)
        .zip(two_plane_weights([[a11, a12], [a21, a22]], [first[0], first[1]]))
        .map(|(n, weight)| {
            let weight = two(
                [("W_x", n).into(), ("W_y", n).into()],
                "g",
                weight,
                "The correction masses that reduce both readings to zero, by Cramer's rule",
            );
            let own = || if n == 1 { first[0].over(a11) } else { first[1].over(a22) };
            let what = "cross effects neglected, each plane corrected by its own sensor alone";
            sheet.common_error(("m_c", n), what, || own().size());
            sheet.common_error(("θ_c", n), what, || {
                let Phasor { x, y } = own();
                balance::marked_direction(-x, -y)
            });
            let mass = sheet.step(("m_c", n), "g", weight.size(), "Magnitude of the correction mass");
            let heavy_spot = || balance::marked_direction(-weight.x, -weight.y);
            sheet.common_error(("θ_c", n), AT_HEAVY_SPOT, heavy_spot);
            rotor::quadrant_ignored(sheet, ("θ_c", n), (weight.x, weight.y));
            let angle = weight.marked_angle();
            Found { mass, angle: sheet.step(("θ_c", n), "deg", angle, "Its angle from the mark") }
        })
        .collect()
}
