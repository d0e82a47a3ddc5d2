//! A gyrocompass with its axle held level.

use std::f64::consts::TAU;

use dalembert_core::{Refusal, Text, Worksheet};
use dalembert_mechanics::Real;
use dalembert_numerics::{
    elliptic,
    ode::{self, OdeFunction},
};
use nalgebra::Vector3;

use super::Plotted;
use crate::sources::KIBBLE;

/// Answers the motion of the level axle about its settled direction.
pub(super) fn answer<'a, W: Worksheet>(
    momentum: W::Num,
    transverse: W::Num,
    deviation: W::Num,
    rate: W::Num,
    sheet: W,
) -> Result<(Plotted<'a>, W::Num), Refusal> {
    let directive = sheet.step(
        "h₁",
        "kg*m^2/s",
        momentum - transverse * rate,
        "Effective angular momentum for small deviations, reduced by the transverse moment of inertia",
    );
    if directive.value() <= 0.0 {
        return Err(Refusal::because(
            "the rotor is too slow for a compass: beside h_s the transverse moment of inertia turns the axle away from the meridian; write a larger angular momentum",
        ));
    }
    let nutation = || transverse / momentum * TAU;
    sheet.common_error("T₀", "period of nutation of a free gyroscope, 2πI_t/h_s, used", nutation);
    let period = sheet.step(
        "T₀",
        "s",
        (transverse / (directive * rate)).sqrt() * TAU,
        ("Period of small oscillations: I_t α̈ = −h₁ Ω_h α", KIBBLE.at("ch. 9, problem 15")),
    );
    sheet.answer("period", "Period of small oscillations", period);
    let swing = Swing { momentum: momentum.value(), transverse: transverse.value(), rate: rate.value() };
    sheet.verify(|| {
        let frequency = TAU / period.value();
        let slope = swing.couple(DIFFERENCE) / DIFFERENCE;
        // A difference of 10⁻⁵ is good to some 10⁻¹⁰.
        sheet.check(
            "couple of a small deviation, by the rate of change of the angular momentum",
            transverse * W::Num::from(frequency.powi(2)),
            W::Num::from(-slope),
        );
    });
    if deviation.value() > 0.0 {
        swing.answer(momentum, transverse, deviation, rate, sheet);
    }
    let (h, inertia) = (momentum.value(), transverse.value());
    let plotted = Plotted {
        answer: "period",
        here: period.value(),
        at: Box::new(move |[rate, _]| TAU * (inertia / ((h - inertia * rate) * rate)).sqrt()),
    };
    Ok((plotted, period))
}

const DIFFERENCE: f64 = 1e-5;

/// The axle and what turns it.
#[derive(Clone, Copy)]
struct Swing {
    momentum: f64,
    transverse: f64,
    rate: f64,
}

impl Swing {
    /// The couple about the vertical that the angular momentum asks for where the axle turns with the level plane, less
    /// what it has: −Ω × H, with x along the settled direction and z up.
    fn couple(self, angle: f64) -> f64 {
        let axle = Vector3::new(angle.cos(), angle.sin(), 0.0);
        let plane = Vector3::x() * self.rate;
        let across = plane - axle * axle.dot(&plane);
        -plane.cross(&(across * self.transverse + axle * self.momentum)).z
    }

    /// Answers the motion from a deviation of any size.
    fn answer<W: Worksheet>(
        self,
        momentum: W::Num,
        transverse: W::Num,
        deviation: W::Num,
        rate: W::Num,
        sheet: W,
    ) {
        let small = || (momentum - transverse * rate) * rate * deviation;
        sheet.common_error("C₀", "couple of a small deviation used: sin α₀ replaced by α₀", small);
        let couple = sheet.step(
            "C₀",
            "N*m",
            (momentum - transverse * rate * deviation.cos()) * rate * deviation.sin(),
            ("Couple that directs the axle, at the initial deviation", KIBBLE.at("ch. 9, problem 15")),
        );
        sheet.answer("couple", "Directing couple at the deviation", couple);
        let ratio =
            sheet.step("c", "1", transverse * rate / momentum, "Share of the transverse moment of inertia");
        let half = (deviation / 2.0).cos();
        let one = W::Num::from(1.0);
        let first = sheet.step(
            "a",
            "1",
            (one - ratio * deviation.cos()).sqrt(),
            "First number of the arithmetic–geometric mean",
        );
        let second = sheet.step("b", "1", half * (one - ratio * half.powi(2)).sqrt(), "Second number");
        let mean = sheet.numerical(
            "M",
            "1",
            elliptic::agm(first.value(), second.value()),
            "Arithmetic–geometric mean of a and b, which is the complete elliptic integral of the motion",
        );
        let small = || (transverse / ((momentum - transverse * rate) * rate)).sqrt() * TAU;
        sheet.common_error("T", "period of small oscillations used at a large deviation", small);
        let period = sheet.step(
            "T",
            "s",
            (transverse / (momentum * rate)).sqrt() * TAU / mean,
            "Period of the oscillation from the initial deviation",
        );
        let small = || deviation * ((momentum - transverse * rate) * rate / transverse).sqrt();
        sheet.common_error(
            "α̇_m",
            "harmonic motion of small oscillations assumed at a large deviation",
            small,
        );
        let fastest = sheet.step(
            "α̇_m",
            "rad/s",
            (momentum * rate / transverse
                * (one - deviation.cos())
                * (W::Num::from(2.0) - ratio * (one + deviation.cos())))
            .sqrt(),
            "Angular velocity through the settled direction, by the energy of the turning axle",
        );
        sheet.answer("amplitude_period", "Period from the initial deviation", period);
        sheet.answer("fastest", "Angular velocity through the meridian", fastest);
        sheet.verify(|| {
            let other = W::Num::from(-self.couple(deviation.value()));
            let size = self.momentum * self.rate;
            sheet.check_sum("the rate of change of the angular momentum", other, couple, size);
            let Some([angle, speed]) = self.followed(deviation.value(), period.value() / 4.0) else { return };
            sheet.check_zero(
                "the axle crosses the settled direction after a quarter of the period, by integration",
                W::Num::from(angle),
                deviation.value(),
            );
            sheet.check("angular velocity there, by integration", fastest, W::Num::from(-speed));
        });
        if deviation.value() > 3.0 {
            sheet.warn(|| {
                Text::new("near 180° the axle lingers at its unstable position, and the period follows from the last digits of the deviation")
            });
        }
    }

    /// Angle and angular velocity after a time from rest at an angle.
    fn followed(self, angle: f64, time: f64) -> Option<[f64; 2]> {
        let fastest = (self.momentum * self.rate / self.transverse).sqrt();
        let mut problem = OdeFunction {
            rates: move |_: f64, state: &[f64], rates: &mut [f64]| {
                rates[0] = state[1];
                rates[1] = self.couple(state[0]) / (self.transverse * fastest.powi(2));
            },
            relative: 1e-12,
            absolute: 1e-13 * angle,
        };
        let states = ode::states(&mut problem, &[angle, 0.0], &[0.0, time * fastest], 100_000).ok()?;
        let end = states.last()?;
        Some([end[0], end[1] * fastest])
    }
}
