//! The work of `F₀ sin ωt` on the motion `X sin(ωt − φ)`.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI, TAU};

use dalembert_core::{Axis, Exhibit, Plot, Series, Worksheet};
use dalembert_mechanics::Real;
use dalembert_numerics::quadrature::integral;
use nalgebra::Complex;

use crate::sources::{RAO, THOMSON};

/// Work up to a time, work of a cycle, mean power.
pub(super) fn solve<W: Worksheet>(
    [force, amplitude]: [W::Num; 2],
    frequency: W::Num,
    lag: W::Num,
    time: W::Num,
    sheet: W,
) {
    let displacement = || amplitude * (frequency * time - lag).sin();
    sheet.common_error("W", "the amplitude of the force multiplied by the displacement at that time", || {
        force * displacement()
    });
    sheet.common_error("W", "force and displacement at that time multiplied", || {
        force * (frequency * time).sin() * displacement()
    });
    let work = sheet.step(
        "W",
        "J",
        force * amplitude / 2.0
            * (frequency * time * lag.sin() + (lag.cos() - (frequency * time * 2.0 - lag).cos()) / 2.0),
        ("Work up to that time: the integral of F₀ sin ωt · Xω cos (ωt − φ)", THOMSON.at("ch. 3")),
    );
    sheet.common_error(
        "W_T",
        "the amplitude of the force multiplied by the distance travelled in a cycle, 4X",
        || force * amplitude * 4.0,
    );
    let cycle = sheet.step(
        "W_T",
        "J",
        force * amplitude * lag.sin() * PI,
        (
            "Work per cycle: only the component of the force in phase with the velocity does work",
            RAO.at("§2.6"),
        ),
    );
    let power = sheet.step(
        "P",
        "W",
        force * amplitude * frequency * lag.sin() / 2.0,
        "Mean power: that work, ω/2π times per second",
    );
    sheet.common_error("P_max", "the amplitudes of force and velocity multiplied", || {
        force * amplitude * frequency
    });
    let largest = sheet.step(
        "P_max",
        "W",
        force * amplitude * frequency / 2.0 * (lag.sin().abs() + 1.0),
        "Maximum instantaneous power: it oscillates about the mean with amplitude F₀Xω/2",
    );
    sheet.verify(|| {
        let numbers = [force, amplitude, frequency, lag, time].map(Real::value);
        let scale = numbers[0] * numbers[1] * (1.0 + numbers[2] * numbers[4]);
        sheet.check_sum("work by numerical integration", work, integrated(numbers).into(), scale);
        let [force, amplitude, frequency, lag, _] = numbers;
        let size = force * amplitude;
        let of_a_cycle = integrated([force, amplitude, 1.0, lag, TAU]);
        sheet.check_sum("work of a cycle by numerical integration", cycle, of_a_cycle.into(), size);
        sheet.check_sum(
            "mean power: half the real part of force times conjugate velocity, as complex amplitudes",
            power,
            (0.5 * (force * (amplitude * Complex::new(0.0, frequency) * Complex::cis(-lag)).conj()).re)
                .into(),
            size * frequency,
        );
        // The power swings about its mean by half of force times velocity: where force and velocity rise alike.
        let at = |angle: f64| force * angle.sin() * amplitude * frequency * (angle - lag).cos();
        let quarter = if lag.sin() < 0.0 { FRAC_PI_4 + FRAC_PI_2 } else { FRAC_PI_4 };
        sheet.check_sum(
            "maximum power: at the instant midway between the extremes of force and velocity",
            largest,
            at(lag / 2.0 + quarter).abs().into(),
            size * frequency,
        );
    });
    sheet.answer("work", "Work up to that time", work);
    sheet.answer("work_of_a_cycle", "Work per cycle", cycle);
    sheet.answer("power", "Mean power", power);
    sheet.answer("largest_power", "Maximum power", largest);
    let numbers = [force, amplitude, frequency, lag, time].map(Real::value);
    sheet.show(|| {
        let [force, amplitude, frequency, lag, _] = numbers;
        let last = 2.0 * TAU / frequency;
        let power =
            |t: f64| force * (frequency * t).sin() * amplitude * frequency * (frequency * t - lag).cos();
        let curve = (0..=300u16).map(|n| last * f64::from(n) / 300.0).map(|t| (t, power(t))).collect();
        Exhibit::Plot(Plot::new(
            "Power against time",
            Axis::linear("time", "s"),
            Axis::linear("power", "W"),
            vec![Series::line("P", curve)],
        ))
    });
    sheet.show(|| {
        let [force, amplitude, _, lag, _] = numbers;
        let at = |n: u16| {
            let angle = TAU * f64::from(n) / 200.0;
            (amplitude * (angle - lag).sin(), force * angle.sin())
        };
        Exhibit::Plot(Plot::new(
            "Force against displacement",
            Axis::linear("displacement", "mm"),
            Axis::linear("force", "N"),
            vec![Series::line("F", (0..=200).map(at).collect())],
        ))
    });
}

/// Whole cycles by the mean of equally spaced points, which is exact for harmonics; the rest by quadrature.
fn integrated([force, amplitude, frequency, lag, time]: [f64; 5]) -> f64 {
    let power = |angle: f64| force * angle.sin() * amplitude * (angle - lag).cos();
    let cycles = (frequency * time / TAU).floor();
    let of_a_cycle = (0..8u8).map(|n| power(TAU * f64::from(n) / 8.0)).sum::<f64>() * TAU / 8.0;
    let rest = frequency * time - cycles * TAU;
    cycles * of_a_cycle + integral(power, [0.0, rest], 16)
}
