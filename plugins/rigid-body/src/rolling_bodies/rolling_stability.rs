//! Stability of a disc or hoop: rolling straight on, or spinning on the spot.

use std::f64::consts::FRAC_PI_2;

use dalembert_core::{
    About, Analysis, Axis, Exhibit, Ink, Inputs, Plot, Refusal, Series, Worksheet, register,
};
use dalembert_mechanics::{
    Real,
    rigid::rolling::{self, Rolling},
};
use dalembert_numerics::linalg;
use nalgebra::{DMatrix, Matrix3, Vector3};

use crate::{
    shared::{
        scene::Scene,
        wheel::{self, Wheel},
    },
    sources::ROUTH,
};

/// An upright disc or hoop on a level floor that is rough enough.
#[derive(Clone, Debug, Inputs)]
pub struct RollingStability {
    /// Mass.
    #[input("m", "kg", positive, default = "1 kg")]
    pub mass: f64,
    /// Radius of the circle that touches the floor.
    #[input("r", "m", positive)]
    pub radius: f64,
    /// It is a.
    pub wheel: Wheel,
    /// Motion.
    pub motion: Upright,
    /// Acceleration of gravity.
    #[input("g", "m/s^2", positive, default = "9.81 m/s^2")]
    pub gravity: f64,
}

/// Motion of an upright disc: rolling or spinning.
#[derive(Clone, Debug, Inputs)]
pub enum Upright {
    /// Rolling in a straight line
    Rolling {
        /// Speed of the centre, to be assessed.
        #[input("v", "m/s", nonnegative)]
        speed: Option<f64>,
    },
    /// Spinning about its vertical diameter
    Spinning {
        /// Angular velocity, to be assessed.
        #[input("Ω", "rad/s", nonnegative)]
        spin: Option<f64>,
    },
}

register!(RollingStability);

impl Analysis for RollingStability {
    const ABOUT: About = About {
        id: "rigid-body/rolling-stability",
        title: "Stability of an upright rolling or spinning disc",
        topic: "Rolling bodies",
        summary: "Minimum speed at which an upright disc or hoop keeps rolling, or minimum spin with which it stays upright on the spot; growth or oscillation at a given speed.",
        main: &["critical_speed", "critical_spin", "wobble", "growth"],
        keywords: "rolling spinning stability critical speed disc hoop wheel coin estabilidade velocidade crítica disco aro roda moeda rolamento giro",
        sources: &[&ROUTH],
        cases: include_str!("../../cases/rolling_stability.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &RollingStabilityGiven<W>, sheet: W) -> Result<(), Refusal> {
        let (mass, radius, gravity) = (given.mass, given.radius, given.gravity);
        let rolls = matches!(self.motion, Upright::Rolling { .. });
        // In the motion of a disc that spins on the spot I_a cancels.
        let moments = wheel::moments(&given.wheel, mass, radius, rolls, sheet);
        let [axial, transverse] = moments;
        let disc = Rolling {
            mass: self.mass,
            radius: self.radius,
            axial: axial.value(),
            transverse: transverse.value(),
            gravity: self.gravity,
        };
        let general = |state: [f64; 2]| disc.tilting_stiffness(FRAC_PI_2, state);
        let tangent = |sheet: W| {
            let reason = "Moment of inertia about the tangent at the contact";
            sheet.step("I_d", "kg*m^2", transverse + mass * radius.powi(2), reason)
        };
        let (critical, judged) = match given.motion {
            UprightGiven::Rolling { speed } => {
                sheet.common_error(
                    "v_c",
                    "the moment of inertia about the tangent at the contact used, not that about a diameter",
                    || {
                        let moments = [axial, transverse + mass * radius.powi(2)];
                        rolling::least_rolling_speed(mass, radius, moments, gravity)
                    },
                );
                sheet.common_error("v_c", "the condition v² = g r of a circular path used", || {
                    (gravity * radius).sqrt()
                });
                let critical = sheet.step(
                    "v_c",
                    "m/s",
                    rolling::least_rolling_speed(mass, radius, moments, gravity),
                    (
                        "Small tilts ε, with ω₃ = −v/r: I_t ω̇₂ = I_a ω₃ ε̇ and (I_t + m r²) ε̈ = m g r ε − (I_a + m r²) ω₂ ω₃; the tilt grows below this speed",
                        ROUTH.at("ch. V"),
                    ),
                );
                sheet.answer("critical_speed", "Minimum speed of the centre", critical);
                let judged = speed.map(|speed| {
                    let tangent = tangent(sheet);
                    let contact = axial + mass * radius.powi(2);
                    let turning = axial / transverse * contact * (speed / radius).powi(2);
                    (speed, (turning - mass * gravity * radius) / tangent)
                });
                (critical, judged)
            }
            UprightGiven::Spinning { spin } => {
                sheet.common_error(
                    "Ω_c",
                    "the moment of inertia about the axis of the disc used, not that about a diameter",
                    || rolling::least_upright_spin(mass, radius, axial, gravity),
                );
                sheet.common_error("Ω_c", "the condition of a sleeping top used", || {
                    let tangent = transverse + mass * radius.powi(2);
                    (tangent * mass * gravity * radius).sqrt() * 2.0 / transverse
                });
                let critical = sheet.step(
                    "Ω_c",
                    "rad/s",
                    rolling::least_upright_spin(mass, radius, transverse, gravity),
                    (
                        "Small tilts ε at ω₂ = Ω: (I_a + m r²) ω̇₃ = m r² Ω ε̇ and (I_t + m r²) ε̈ = (m g r − I_t Ω²) ε − (I_a + m r²) Ω ω₃; the tilt grows below this spin",
                        ROUTH.at("ch. V"),
                    ),
                );
                sheet.answer("critical_spin", "Minimum angular velocity about the vertical", critical);
                let judged = spin.map(|spin| {
                    let tangent = tangent(sheet);
                    (spin, spin.powi(2) - mass * gravity * radius / tangent)
                });
                (critical, judged)
            }
        };
        let state = |speed: f64| match self.motion {
            Upright::Rolling { .. } => [0.0, -speed / self.radius],
            Upright::Spinning { .. } => [speed, 0.0],
        };
        sheet.verify(|| {
            sheet.check_zero(
                "the general equation of small oscillations is at its limit there",
                general(state(critical.value())).into(),
                self.gravity / self.radius,
            );
        });
        if let Some((at, k)) = judged {
            let k = sheet.step("K", "1/s^2", k, "Small tilts follow ε̈ + K ε = 0: stable when K is positive");
            sheet.answer("stiffness", "Stiffness of small tilts", k);
            let ratio = sheet.step("s", "1", at / critical, "Speed divided by the minimum speed");
            sheet.answer("margin", "Ratio of speed to minimum speed", ratio);
            let square = if k.value() > 0.0 {
                let wobble = sheet.step("ω_n", "rad/s", k.sqrt(), "Angular frequency of the oscillation");
                sheet.answer("wobble", "Angular frequency of the oscillation", wobble);
                wobble.value().powi(2)
            } else {
                let growth = sheet.step("σ", "1/s", k.abs().sqrt(), "Growth rate: a tilt grows as e^σt");
                sheet.answer("growth", "Growth rate of a tilt", growth);
                sheet.warn(|| "unstable: it falls over, however small the tilt".into());
                -growth.value().powi(2)
            };
            sheet.verify(|| {
                let [second, third] = state(at.value());
                let size = self.gravity / self.radius + second.powi(2) + third.powi(2);
                let other = W::Num::from(general([second, third]) - k.value());
                sheet.check_zero("the general equation of small oscillations", other, size);
                let other = W::Num::from(general([second, third]) - square);
                sheet.check_zero(
                    "square of the oscillation frequency or growth rate by the general equation",
                    other,
                    size,
                );
                if let Some(found) = linearised(&disc, [second, third]) {
                    // Differences are good to some 10⁻¹⁰: they are compared with 10⁻⁸.
                    sheet.check_zero(
                        "the eigenvalues of the linearised equations, squared",
                        W::Num::from(0.1 * (found + k.value())),
                        size,
                    );
                }
            });
        }
        let at = judged.map(|(at, ..)| at.value());
        let critical = critical.value();
        sheet.show(|| Exhibit::Plot(over_speed(&disc, rolls, critical, at)));
        sheet.show(|| self.picture());
        Ok(())
    }
}

impl RollingStability {
    /// The upright disc on the floor, a little tilted, with its motion.
    fn picture(&self) -> Exhibit {
        let [x, y, z] = [Vector3::x(), Vector3::y(), Vector3::z()];
        // The tilt that grows or decays.
        let (sin, cos) = 0.15_f64.sin_cos();
        let up = z * cos + y * sin;
        let axle = x.cross(&up);
        let mut scene = Scene::seen_from(-0.9, 0.35);
        scene.line([x * -2.0, x * 2.0], Ink::Faint);
        scene.line([y * -0.8, y * 0.8], Ink::Faint);
        scene.line([Vector3::zeros(), z * 2.4], Ink::Faint);
        scene.disc(up, &Matrix3::from_columns(&[up, -x, -axle]), 1.0, Ink::Body);
        scene.label(up * 0.5, "r");
        scene.label(up + (up - x) * 0.75, self.wheel.letters());
        scene.label(up, "G");
        match self.motion {
            Upright::Rolling { .. } => scene.arrow(up, x * 1.7, Ink::Motion, "v"),
            Upright::Spinning { .. } => scene.turn("Ω", z * 2.3, z, 0.35, Ink::Motion),
        }
        scene.exhibit("The upright disc and a small tilt")
    }
}

/// `λ²` of the pair of eigenvalues that are not zero, of the equations linearised by differences.
fn linearised(disc: &Rolling, [second, third]: [f64; 2]) -> Option<f64> {
    let rate = (disc.gravity / disc.radius).sqrt().max(second.abs()).max(third.abs());
    let base = [FRAC_PI_2, 0.0, second, third];
    let scale = [1.0, rate, rate, rate];
    let rates = |state: [f64; 4]| {
        let [a, b, c] = disc.accelerations(state[0], [state[1], state[2], state[3]]);
        [state[1], a, b, c]
    };
    const STEP: f64 = 1e-5;
    let matrix = DMatrix::from_fn(4, 4, |row, column| {
        let mut ends = [base; 2];
        ends[0][column] += STEP * scale[column];
        ends[1][column] -= STEP * scale[column];
        let [after, before] = ends.map(|end| rates(end)[row]);
        (after - before) / (2.0 * STEP * scale[row] * rate)
    });
    let values = linalg::complex_eigenvalues(&matrix).ok()?;
    let largest = values.iter().max_by(|a, b| a.norm().total_cmp(&b.norm()))?;
    let square = largest * largest;
    Some(square.re * rate * rate)
}

/// Growth and wobble over the speed.
fn over_speed(disc: &Rolling, rolls: bool, critical: f64, at: Option<f64>) -> Plot {
    let stiffness = |speed: f64| {
        let state = if rolls { [0.0, -speed / disc.radius] } else { [speed, 0.0] };
        disc.tilting_stiffness(FRAC_PI_2, state)
    };
    let most = at.unwrap_or(0.0).max(2.0 * critical);
    let speeds = || (0..=240).map(|n| most * f64::from(n) / 240.0);
    let rate = |square: f64| if square > 0.0 { square.sqrt() } else { f64::INFINITY };
    let growth = speeds().map(|speed| (speed, rate(-stiffness(speed)))).collect();
    let wobble = speeds().map(|speed| (speed, rate(stiffness(speed)))).collect();
    let (label, unit, input) = if rolls {
        ("speed of the centre", "m/s", "motion.rolling.speed")
    } else {
        ("angular velocity", "rad/s", "motion.spinning.spin")
    };
    let plot = Plot::new(
        "Growth or oscillation of a small tilt",
        Axis::linear(label, unit),
        Axis::linear("rate", "1/s"),
        vec![Series::line("growth", growth).of("growth"), Series::line("oscillation", wobble).of("wobble")],
    )
    .over(input)
    .mark("limit", (critical, 0.0));
    match at {
        Some(at) => plot.mark("here", (at, stiffness(at).abs().sqrt())),
        None => plot,
    }
}
