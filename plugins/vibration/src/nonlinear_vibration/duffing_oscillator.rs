//! A mass on a spring whose stiffness grows or falls with the square of the displacement, or a body on a torsional one.

use std::f64::consts::TAU;

use dalembert_core::{About, Analysis, Exhibit, Inputs, Refusal, Text, Worksheet, register};
use dalembert_mechanics::{Real, sdof, vibration::duffing::Duffing};

mod checks;
mod pictures;

use self::pictures::{backbone_plot, free_plot, response_plot, table};
use crate::{
    shared::oscillator::{
        Mass, mass,
        motion::OscillatorMotion,
        parts::{OscillatingBody, one_motion},
    },
    sources::{ABRAMOWITZ, NAYFEH, THOMSON},
};

/// Duffing's oscillator, free or forced.
#[derive(Clone, Debug, Inputs)]
pub struct DuffingOscillator {
    /// Inertia.
    pub mass: OscillatingBody,
    /// Stiffness at small displacements.
    pub stiffness: SmallStiffness,
    /// Cubic stiffness coefficient.
    /// The force of the spring is k x + h x³: positive for a hardening spring, negative for a softening one.
    pub cubic: CubicStiffness,
    /// Motion.
    pub motion: DuffingMotion,
}

/// Stiffness at small displacements or angles.
#[derive(Clone, Debug, Inputs)]
pub enum SmallStiffness {
    /// Stiffness given
    Given {
        /// Stiffness.
        #[input("k", "N/m", positive)]
        stiffness: f64,
    },
    /// Torsional stiffness given
    /// For a rotation.
    Torsional {
        /// Torsional stiffness.
        #[input("k_t", "N*m/rad", positive)]
        stiffness: f64,
    },
    /// Weight of a pendulum
    /// For a rotation about its pivot.
    Pendulum {
        /// Mass or weight.
        mass: Mass,
        /// Distance from the pivot to the centre of mass.
        #[input("d_G", "m", positive)]
        distance: f64,
        /// Gravity.
        #[input("g", "m/s^2", positive, default = "9.81 m/s^2")]
        gravity: f64,
    },
}

/// The cubic term of the restoring force or torque.
#[derive(Clone, Debug, Inputs)]
pub enum CubicStiffness {
    /// Cubic coefficient given
    Given {
        /// Cubic stiffness coefficient.
        #[input("h", "N/m^3")]
        cubic: f64,
    },
    /// Torsional cubic coefficient given
    /// For a rotation: the torque of the spring is k_t θ + h_t θ³.
    Torsional {
        /// Torsional cubic coefficient.
        #[input("h_t", "N*m/rad^3")]
        cubic: f64,
    },
    /// Of a pendulum: sin θ ≈ θ − θ³/6
    /// For a rotation under the weight of the body.
    Pendulum,
}

/// Type of motion: free or forced.
#[derive(Clone, Debug, Inputs)]
pub enum DuffingMotion {
    /// Free, released from rest
    Free {
        /// Amplitude.
        #[input("A", "m", positive, kind = "Amplitude")]
        amplitude: f64,
    },
    /// Forced vibration under a harmonic force, with viscous damping
    Forced {
        /// Damping coefficient.
        #[input("c", "N*s/m", positive)]
        damping: f64,
        /// Amplitude of the force.
        #[input("F", "N", positive)]
        force: f64,
        /// Frequency of the force.
        #[input("ω", "rad/s", positive)]
        frequency: f64,
    },
    /// Free rotation, released from rest
    FreeRotation {
        /// Amplitude.
        #[input("Θ", "rad", positive)]
        amplitude: f64,
    },
    /// Forced rotation under a harmonic torque, with viscous damping
    ForcedRotation {
        /// Torsional damping coefficient.
        #[input("c_t", "N*m*s/rad", positive)]
        damping: f64,
        /// Amplitude of the torque.
        #[input("T₀", "N*m", positive)]
        torque: f64,
        /// Frequency of the torque.
        #[input("ω", "rad/s", positive)]
        frequency: f64,
    },
}

register!(DuffingOscillator);

impl Analysis for DuffingOscillator {
    const ABOUT: About = About {
        id: "vibration/duffing-oscillator",
        title: "Duffing oscillator",
        topic: "Nonlinear vibration",
        summary: "Exact free period, or forced amplitudes with backbone curve, jumps and stability, of a mass on a spring with a cubic term, or of a body on a torsional one.",
        main: &["period", "amplitude", "peak_amplitude", "jump_frequency", "largest_displacement"],
        keywords: "nonlinear hardening softening jump backbone harmonic balance oscilador de Duffing não linear salto \
                   balanço harmônico mola cúbica pendulum torsional pêndulo torção",
        sources: &[&NAYFEH, &THOMSON, &ABRAMOWITZ],
        cases: include_str!("../../cases/duffing_oscillator.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &DuffingOscillatorGiven<W>, sheet: W) -> Result<(), Refusal> {
        let rest = [given.stiffness.motion(), given.cubic.motion(), given.motion.motion()];
        let motion = one_motion(Some(given.mass.motion()), &rest.map(Some))?;
        let mass = given.mass.inertia(sheet)?;
        let stiffness = given.stiffness.stiffness(sheet);
        let cubic = match given.cubic {
            CubicStiffnessGiven::Given { cubic } | CubicStiffnessGiven::Torsional { cubic } => cubic,
            CubicStiffnessGiven::Pendulum {} => {
                let why = ("Cubic coefficient of a pendulum, from sin θ ≈ θ − θ³/6", NAYFEH.at("§2.1"));
                sheet.step("h_t", "N*m/rad^3", -stiffness / 6.0, why)
            }
        };
        let natural = sheet.step(
            "ω₀",
            "rad/s",
            sdof::natural_frequency(stiffness, mass),
            ("Natural frequency at small amplitudes", NAYFEH.at("§2.1")),
        );
        let (name, label) = motion.of(("mass", "Mass"), ("inertia", "Moment of inertia"));
        sheet.answer(name, label, mass);
        sheet.answer("stiffness", motion.of("Stiffness", "Torsional stiffness"), stiffness);
        sheet.answer("natural_frequency", "Natural frequency at small amplitudes", natural);
        let worked = WorkedDuffing { motion, mass, stiffness, cubic };
        sheet.show(|| Exhibit::Drawing(self.drawing(motion)));
        sheet.verify(|| {
            let small = Duffing { cubic: 0.0, ..worked.numbers(0.0) }.free_period_by_quadrature(1.0);
            sheet.check(
                "period at small amplitudes by quadrature of dt = dx/v from the energy",
                W::Num::from(TAU / natural.value()),
                W::Num::from(small),
            );
        });
        match given.motion {
            DuffingMotionGiven::Free { amplitude } | DuffingMotionGiven::FreeRotation { amplitude } => {
                worked.free(amplitude, sheet)
            }
            DuffingMotionGiven::Forced { damping, force, frequency }
            | DuffingMotionGiven::ForcedRotation { damping, torque: force, frequency } => {
                worked.forced([damping, force, frequency], sheet)
            }
        }
    }
}

impl<W: Worksheet> SmallStiffnessGiven<W> {
    fn motion(&self) -> OscillatorMotion {
        match self {
            SmallStiffnessGiven::Given { .. } => OscillatorMotion::Translation,
            SmallStiffnessGiven::Torsional { .. } | SmallStiffnessGiven::Pendulum { .. } => {
                OscillatorMotion::Rotation
            }
        }
    }

    /// The stiffness, N/m or N·m/rad.
    fn stiffness(&self, sheet: W) -> W::Num {
        match self {
            SmallStiffnessGiven::Given { stiffness } | SmallStiffnessGiven::Torsional { stiffness } => {
                *stiffness
            }
            SmallStiffnessGiven::Pendulum { mass: given, distance, gravity } => {
                let why = ("Restoring torque of the weight per radian of a small angle", NAYFEH.at("§2.1"));
                sheet.step("k_t", "N*m/rad", mass(given, sheet) * *gravity * *distance, why)
            }
        }
    }
}

impl<W: Worksheet> CubicStiffnessGiven<W> {
    fn motion(&self) -> OscillatorMotion {
        match self {
            CubicStiffnessGiven::Given { .. } => OscillatorMotion::Translation,
            CubicStiffnessGiven::Torsional { .. } | CubicStiffnessGiven::Pendulum {} => {
                OscillatorMotion::Rotation
            }
        }
    }
}

impl<W: Worksheet> DuffingMotionGiven<W> {
    fn motion(&self) -> OscillatorMotion {
        match self {
            DuffingMotionGiven::Free { .. } | DuffingMotionGiven::Forced { .. } => {
                OscillatorMotion::Translation
            }
            DuffingMotionGiven::FreeRotation { .. } | DuffingMotionGiven::ForcedRotation { .. } => {
                OscillatorMotion::Rotation
            }
        }
    }
}

/// The oscillator in the working; of a rotation, its moment of inertia and torsional coefficients.
#[derive(Clone, Copy)]
struct WorkedDuffing<N> {
    motion: OscillatorMotion,
    mass: N,
    stiffness: N,
    cubic: N,
}

impl<N: Real> WorkedDuffing<N> {
    fn numbers(&self, damping: f64) -> Duffing {
        Duffing {
            mass: self.mass.value(),
            damping,
            stiffness: self.stiffness.value(),
            cubic: self.cubic.value(),
        }
    }

    fn free<W: Worksheet<Num = N>>(&self, amplitude: N, sheet: W) -> Result<(), Refusal> {
        let WorkedDuffing { motion, mass, stiffness, cubic } = *self;
        let (oscillator, a) = (self.numbers(0.0), amplitude.value());
        if cubic.value() < 0.0 {
            let limit = sheet.step(
                motion.of("A_lim", "Θ_lim"),
                motion.displacement_unit(),
                (stiffness / -cubic).sqrt(),
                motion.of(
                    "Stability limit of a softening spring: beyond it the mass does not return",
                    "Stability limit of a softening torque: beyond it the body does not return",
                ),
            );
            sheet.answer("limit_amplitude", "Amplitude of zero restoring force", limit);
            sheet.check_zero(
                motion.of(
                    "at that amplitude the spring force is zero",
                    "at that angle the restoring torque is zero",
                ),
                stiffness * limit + cubic * limit.powi(3),
                stiffness.value() * limit.value(),
            );
        }
        let Some(exact) = oscillator.free_period(a) else {
            return Err(Refusal::because(motion.of(
                "at this amplitude the softening spring exerts no restoring force: choose an amplitude below √(k/|h|)",
                "at this angle the softening torque does not restore: choose an amplitude below √(k_t/|h_t|)",
            )));
        };
        let turn = sheet.step(
            "Ω",
            "rad/s",
            ((stiffness + cubic * amplitude.powi(2)) / mass).sqrt(),
            ("Frequency of the elliptic cosine that satisfies the equation", NAYFEH.at("§2.1")),
        );
        // agm(1, √(1 − κ²)), written out.
        let mut arithmetic = N::from(1.0);
        let mut geometric = sheet.step(
            ("b", 1),
            "1",
            ((stiffness + cubic * amplitude.powi(2) / 2.0) / (mass * turn.powi(2))).sqrt(),
            (
                "√(1 − κ²), κ² = h A²/(2(k + h A²)); arithmetic–geometric mean of 1 and this",
                ABRAMOWITZ.at("§17.6"),
            ),
        );
        for n in 2..=12 {
            if (arithmetic.value() - geometric.value()).abs() <= 1e-15 * arithmetic.value() {
                break;
            }
            let mean = sheet.step(("a", n), "1", (arithmetic + geometric) / 2.0, "Arithmetic mean");
            geometric = sheet.step(("b", n), "1", (arithmetic * geometric).sqrt(), "Geometric mean");
            arithmetic = mean;
        }
        let of = |stiffness: N| N::from(TAU) / sdof::natural_frequency(stiffness, mass);
        sheet.common_error("T", "the period at small amplitudes taken", || of(stiffness));
        sheet.common_error("T", "the secant stiffness at the amplitude used for the whole motion", || {
            of(stiffness + cubic * amplitude.powi(2))
        });
        sheet.common_error("T", "the tangent stiffness at the amplitude used for the whole motion", || {
            of(stiffness + cubic * amplitude.powi(2) * 3.0)
        });
        let period = sheet.step(
            "T",
            "s",
            N::from(TAU) / (turn * arithmetic),
            ("Exact period: four quarter periods K(κ)/Ω", NAYFEH.at("§2.1")),
        );
        let frequency = sheet.step("ω", "rad/s", sdof::angular_frequency(period), "Exact frequency");
        sheet.verify(|| {
            sheet.check(
                "period by quadrature of dt = dx/v from the energy",
                N::from(oscillator.free_period_by_quadrature(a)),
                N::from(period.value()),
            );
        });
        sheet.answer("period", "Period", period);
        sheet.answer("frequency", "Frequency", frequency);
        if oscillator.backbone(a).is_some() {
            sheet.common_error("ω′", "the square of the displacement replaced by its mean", || {
                ((stiffness + cubic * amplitude.powi(2) / 2.0) / mass).sqrt()
            });
            let balance = sheet.step(
                "ω′",
                "rad/s",
                ((stiffness + cubic * amplitude.powi(2) * 0.75) / mass).sqrt(),
                ("Harmonic balance with one term: x³ ≈ ¾ A³ cos ωt", NAYFEH.at("§2.3")),
            );
            let balance_period = sheet.step("T′", "s", N::from(TAU) / balance, "Period by harmonic balance");
            let error = sheet.step(
                "ΔT",
                "%",
                (balance_period - period) / period,
                "Relative error of harmonic balance",
            );
            sheet.answer("balance_period", "Period by harmonic balance", balance_period);
            sheet.verify(|| checks::balance_period(&oscillator, a, balance_period, sheet));
            sheet.answer("balance_error", "Error of harmonic balance", error);
        }
        sheet.show(|| Exhibit::Plot(free_plot(motion, &oscillator, a, exact)));
        sheet.show(|| Exhibit::Plot(backbone_plot(motion, &oscillator, a, exact)));
        Ok(())
    }

    fn forced<W: Worksheet<Num = N>>(
        &self,
        [damping, force, frequency]: [N; 3],
        sheet: W,
    ) -> Result<(), Refusal> {
        let WorkedDuffing { motion, mass, stiffness, cubic } = *self;
        let oscillator = &self.numbers(damping.value());
        let [f, w] = [force, frequency].map(Real::value);
        let unit = motion.displacement_unit();
        let steady = oscillator.steady(f, w);
        if steady.is_empty() {
            return Err(Refusal::because(
                motion.of(
                    "no steady-state vibration was found: these values differ too much in magnitude; check the units of h and F",
                    "no steady-state vibration was found: these values differ too much in magnitude; check the units of h_t and T₀",
                ),
            ));
        }
        for (n, one) in (1..).zip(&steady) {
            let how = if one.stable {
                motion.of(
                    "Root of the balance of the first harmonic; stable: a larger amplitude requires a larger force",
                    "Root of the balance of the first harmonic; stable: a larger amplitude requires a larger torque",
                )
            } else {
                motion.of(
                    "Root of the balance of the first harmonic; unstable: a larger amplitude requires a smaller force, so it jumps away",
                    "Root of the balance of the first harmonic; unstable: a larger amplitude requires a smaller torque, so it jumps away",
                )
            };
            sheet.common_error((motion.of("A", "Θ"), n), "the cubic term omitted", || {
                sdof::forced_amplitude(force, stiffness, mass, damping, frequency)
            });
            let amplitude =
                sheet.numerical((motion.of("A", "Θ"), n), unit, one.amplitude, (how, NAYFEH.at("§4.1")));
            let held = stiffness - mass * frequency.powi(2) + cubic * amplitude.powi(2) * 0.75;
            // Near resonance the force is a small difference of spring and inertia.
            sheet.verify(|| {
                let size = (oscillator.stiffness
                    + oscillator.mass * w * w
                    + 0.75 * oscillator.cubic.abs() * one.amplitude.powi(2))
                    * one.amplitude;
                sheet.check_zero(
                    motion.of(
                        "spring, inertia and damper balance the force",
                        "spring, inertia and damper balance the torque",
                    ),
                    (held.powi(2) + (damping * frequency).powi(2)).sqrt() * amplitude - force,
                    size.max(f),
                );
            });
            sheet.answer(("amplitude", n), "Amplitude of the first harmonic", amplitude);
            let lag = sheet.numerical(
                ("φ", n),
                "deg",
                one.lag,
                motion.of("The motion lags the force by", "The motion lags the torque by"),
            );
            sheet.answer(("phase", n), "Phase lag", lag);
            sheet.verify(|| {
                let size =
                    (oscillator.stiffness
                    + oscillator.mass * w * w
                    + 0.75 * oscillator.cubic.abs() * one.amplitude.powi(2))
                        * one.amplitude;
                sheet.check_zero(
                    motion.of(
                        "spring and inertia forces are balanced by the force component in phase with the motion",
                        "torques of spring and inertia are balanced by the torque component in phase with the motion",
                    ),
                    held * amplitude - force * lag.cos(),
                    size.max(f),
                );
                sheet.check_sum(
                    motion.of(
                        "work of the force in a cycle = work of the damper, πFA sin φ = πcωA²",
                        "work of the torque in a cycle = work of the damper, πT₀Θ sin φ = πc_tωΘ²",
                    ),
                    force * lag.sin(),
                    damping * frequency * amplitude,
                    size.max(f),
                );
            });
            if let Some(both) = oscillator.two_harmonics(f, w, one) {
                let [_, third] = both.amplitudes();
                let largest = sheet.numerical(
                    (motion.of("X", "Θₘₐₓ"), n),
                    unit,
                    both.amplitude(),
                    (
                        motion.of(
                            "Maximum displacement with the third harmonic also balanced, by Newton's method",
                            "Maximum angle with the third harmonic also balanced, by Newton's method",
                        ),
                        NAYFEH.at("§2.3"),
                    ),
                );
                sheet.answer(
                    ("largest_displacement", n),
                    motion.of(
                        "Maximum displacement with the third harmonic",
                        "Maximum angle with the third harmonic",
                    ),
                    largest,
                );
                let third = sheet.numerical(
                    (motion.of("A‴", "Θ‴"), n),
                    unit,
                    third,
                    "Amplitude of the third harmonic",
                );
                sheet.answer(("third_harmonic", n), "Amplitude of the third harmonic", third);
                sheet.verify(|| {
                    checks::two_harmonics(oscillator, [f, w], one.amplitude, &both, [largest, third], sheet);
                });
            }
        }
        if steady.len() > 1 {
            sheet.warn(|| {
                Text::new(
                    "three steady-state vibrations are possible at this frequency: which of the two stable ones occurs depends on how it was reached",
                )
            });
        }
        let peak = oscillator.peak(f);
        if let Some((_, _)) = peak {
            let rest = stiffness - damping.powi(2) / (mass * 4.0);
            let reach = force.powi(2) * mass / damping.powi(2);
            let natural = || sdof::natural_frequency(stiffness, mass);
            sheet.common_error(
                motion.of("A_p", "Θ_p"),
                "the amplitude at resonance of the linear oscillator taken",
                || force / (damping * natural()),
            );
            let largest = sheet.step(
                motion.of("A_p", "Θ_p"),
                unit,
                (reach * 2.0 / (rest + (rest.powi(2) + cubic * reach * 3.0).sqrt())).sqrt(),
                (
                    motion.of(
                        "Maximum amplitude at any frequency, where both frequencies of an amplitude meet: ¾hA⁴ + (k − c²/4m)A² = F²m/c²",
                        "Maximum amplitude at any frequency, where both frequencies of an amplitude meet: ¾h_tΘ⁴ + (k_t − c_t²/4J)Θ² = T₀²J/c_t²",
                    ),
                    NAYFEH.at("§4.1"),
                ),
            );
            sheet.common_error("ω_p", "the natural frequency at small amplitudes taken", natural);
            let at = sheet.step(
                "ω_p",
                "rad/s",
                ((stiffness + cubic * largest.powi(2) * 0.75 - damping.powi(2) / (mass * 2.0)) / mass).sqrt(),
                "Its frequency, close to the backbone curve",
            );
            let held = stiffness + cubic * largest.powi(2) * 0.75 - mass * at.powi(2);
            sheet.check(
                motion.of(
                    "the largest amplitude satisfies the balance of forces",
                    "the largest amplitude satisfies the balance of torques",
                ),
                (held.powi(2) + (damping * at).powi(2)).sqrt() * largest,
                force,
            );
            sheet.answer("peak_amplitude", "Maximum amplitude at any frequency", largest);
            sheet.answer("peak_frequency", "Frequency of maximum amplitude", at);
        } else {
            sheet.warn(|| {
                Text::new(motion.of(
                    "the response has no maximum amplitude at a frequency above zero: the softening spring loses its restoring force, or the damping is too strong",
                    "the response has no maximum amplitude at a frequency above zero: the softening torque does not restore, or the damping is too strong",
                ))
            });
        }
        let jumps = oscillator.jumps(f);
        for (n, (at, amplitude)) in (1..).zip(&jumps) {
            let at = sheet.numerical(
                ("ω_J", n),
                "rad/s",
                *at,
                "Vertical tangent of the response curve: jump of the amplitude",
            );
            sheet.answer(("jump_frequency", n), "Frequency of a jump", at);
            let amplitude = sheet.numerical(
                (motion.of("A_J", "Θ_J"), n),
                unit,
                *amplitude,
                "Amplitude at which the jump occurs",
            );
            sheet.answer(("jump_amplitude", n), "Amplitude before the jump", amplitude);
            sheet.verify(|| {
                let hardening = cubic * amplitude.powi(2) * 0.75;
                let held = stiffness - mass * at.powi(2) + hardening;
                let damped = (damping * at).powi(2);
                sheet.check(
                    motion.of(
                        "at the jump, the spring, inertia and damping forces balance the applied force",
                        "at the jump, the torques of spring, inertia and damping balance the applied torque",
                    ),
                    (held.powi(2) + damped) * amplitude.powi(2),
                    force.powi(2),
                );
                sheet.check_zero(
                    motion.of(
                        "at the jump a small change of the amplitude needs no change of the force",
                        "at the jump a small change of the amplitude needs no change of the torque",
                    ),
                    held * (held + hardening * 2.0) + damped,
                    damped.value(),
                );
            });
        }
        sheet.show(|| Exhibit::Plot(response_plot(motion, oscillator, f, (w, &steady), &jumps)));
        sheet.show(|| Exhibit::Table(table(unit, &steady)));
        Ok(())
    }
}
