//! A pendulous gyrocompass.

use std::f64::consts::TAU;

use dalembert_core::Worksheet;
use dalembert_mechanics::Real;
use dalembert_numerics::linalg;
use nalgebra::{DMatrix, Vector3};

use super::{Plotted, Rates};
use crate::sources::SCHULER;

/// The pendulous rotor.
pub(super) struct Pendulum<N> {
    pub momentum: N,
    pub weight: N,
    pub mass: N,
    pub depth: N,
    pub gravity: N,
    pub radius: N,
}

impl<N: Real> Pendulum<N> {
    /// Answers tilt, period and Schuler tuning.
    pub(super) fn answer<'a, W: Worksheet<Num = N>>(&self, rates: &Rates<N>, sheet: W) -> (Plotted<'a>, N) {
        let &Self { momentum, weight, mass, depth, gravity, radius } = self;
        let directing = sheet.step(
            "B₁",
            "N*m",
            weight + momentum * rates.horizontal,
            "Moment that holds the axle level: that of the weight, and the gyroscopic one",
        );
        let latitude = || rates.vertical.atan2(rates.horizontal);
        sheet.common_error("θ₀", "axle assumed parallel to the axis of the Earth", latitude);
        let tilt = sheet.step(
            "θ₀",
            "deg",
            (momentum * rates.vertical).atan2(directing),
            "Tilt, north end upwards: the moment of the weight turns the axle with the meridian, B sin θ₀ = h_s (Ω_v cos θ₀ − Ω_h sin θ₀)",
        );
        let pendulum = || (depth / gravity).sqrt() * TAU;
        sheet.common_error("T₀", "period of a simple pendulum of the length l used", pendulum);
        let precession = || momentum / weight * TAU;
        sheet.common_error("T₀", "period of precession under the weight, 2πh_s/B, used", precession);
        let period = sheet.step(
            "T₀",
            "s",
            (momentum / (directing * rates.horizontal)).sqrt() * tilt.cos() * TAU,
            (
                "Period of small oscillations: the axle tilts at −Ω_h sin α and turns to the west at (B/h_s + Ω_h) tan θ − Ω_v",
                SCHULER.at("§3"),
            ),
        );
        let tuned = sheet.step(
            "T_S",
            "s",
            (radius / gravity).sqrt() * TAU,
            (
                "Schuler's period, at which accelerations of the vessel do not deflect the compass",
                SCHULER.at("§3"),
            ),
        );
        sheet.answer("tilt", "Tilt of the axle, north end upwards", tilt);
        sheet.answer("period", "Period of small oscillations", period);
        sheet.answer("schuler_period", "Schuler's period", tuned);
        // X = B + h Ω_h solves Ω_h X/h + h Ω_h Ω_v²/X = g/R.
        let schuler = gravity / radius;
        let root = schuler.powi(2) - (rates.horizontal * rates.vertical).powi(2) * 4.0;
        if root.value() >= 0.0 {
            let moment = sheet.step(
                "B_S",
                "N*m",
                momentum * (schuler + root.sqrt()) / (rates.horizontal * 2.0) - momentum * rates.horizontal,
                "Moment of the weight at which the period is Schuler's",
            );
            if moment.value() > 0.0 {
                let wanted =
                    sheet.step("l_S", "m", moment / (mass * gravity), "Depth of the centre of mass for it");
                sheet.answer("schuler_depth", "Depth that gives Schuler's period", wanted);
                sheet.verify(|| {
                    let other = self.eigenvalue(wanted.value(), rates);
                    if let Some(other) = other {
                        // The difference quotients are good to some 10⁻¹⁰.
                        sheet.check(
                            "period at that depth by the eigenvalues of the equations of motion",
                            tuned,
                            W::Num::from(TAU / other),
                        );
                    }
                });
            }
        }
        sheet.verify(|| {
            let still = self.rate(settled(tilt.value()), depth.value(), rates);
            let size = rates.horizontal.value() + rates.vertical.value().abs();
            sheet.check_zero(
                "the axle stays on the meridian at that tilt: τ/h − Ω × u",
                still.norm().into(),
                size,
            );
            if let Some(other) = self.eigenvalue(depth.value(), rates) {
                sheet.check(
                    "period by the eigenvalues of the equations of motion",
                    period,
                    W::Num::from(TAU / other),
                );
            }
        });
        let (h, b) = (momentum.value(), weight.value());
        let plotted = Plotted {
            answer: "period",
            here: period.value(),
            at: Box::new(move |[level, up]| {
                let directing = b + h * level;
                TAU * (h / (directing * level)).sqrt() * (h * up).atan2(directing).cos()
            }),
        };
        (plotted, period)
    }

    /// The rate of the axle `u` in axes of the place, x along the horizontal component, z up: τ/h − Ω × u, where the weight
    /// at `depth` below the support exerts τ.
    fn rate(&self, axle: Vector3<f64>, depth: f64, rates: &Rates<N>) -> Vector3<f64> {
        let place = Vector3::new(rates.horizontal.value(), 0.0, rates.vertical.value());
        // The frame stands upright across the axle, its centre of mass below.
        let upright = (Vector3::z() - axle * axle.z).normalize();
        let weight = Vector3::z() * (-self.mass.value() * self.gravity.value());
        (upright * -depth).cross(&weight) / self.momentum.value() - place.cross(&axle)
    }

    /// The angular frequency of small oscillations: the eigenvalues of the rates, differentiated at the settled tilt.
    fn eigenvalue(&self, depth: f64, rates: &Rates<N>) -> Option<f64> {
        const STEP: f64 = 1e-3;
        let (h, level) = (self.momentum.value(), rates.horizontal.value());
        let directing = self.mass.value() * self.gravity.value() * depth + h * level;
        let axle = settled((h * rates.vertical.value()).atan2(directing));
        // Along the axle it cannot move: to the west, and upwards across it.
        let ways = [Vector3::y(), Vector3::new(-axle.z, 0.0, axle.x)];
        let scale = directing / h;
        let turned = |way: Vector3<f64>, angle: f64| axle * angle.cos() + way * angle.sin();
        let slope = |row: usize, column: usize| {
            let at = |step: f64| {
                let there = turned(ways[column], step * STEP);
                ways[row].dot(&self.rate(there, depth, rates))
            };
            (8.0 * (at(1.0) - at(-1.0)) - (at(2.0) - at(-2.0))) / (12.0 * STEP * scale)
        };
        // The rates differ in size by the root of Ω_h to B/h: a balanced matrix has the same eigenvalues.
        let balance = (level / scale).sqrt();
        let matrix = DMatrix::from_row_slice(
            2,
            2,
            &[slope(0, 0) / balance, slope(0, 1), slope(1, 0) / balance.powi(2), slope(1, 1) / balance],
        );
        let values = linalg::complex_eigenvalues(&matrix).ok()?;
        values.iter().map(|value| value.im).reduce(f64::max).map(|largest| largest * scale * balance)
    }
}

/// The axle on the meridian at a tilt.
fn settled(tilt: f64) -> Vector3<f64> {
    Vector3::new(tilt.cos(), 0.0, tilt.sin())
}
