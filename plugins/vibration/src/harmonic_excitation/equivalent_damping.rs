//! Damping that is not viscous, as the viscous damping that takes the same energy in a cycle.

use std::f64::consts::{PI, TAU};

use dalembert_core::{
    About, Analysis, Axis, Drawing, Exhibit, Inputs, Plot, Refusal, Series, Sketch, Worksheet, register,
};
use dalembert_mechanics::{Real, sdof};

use crate::{
    shared::oscillator::{
        motion::OscillatorMotion,
        parts::{BodyStiffness, OscillatingBody, one_motion},
        plots::inertia_spring_damper,
    },
    sources::{RAO, THOMSON},
};

/// An oscillator under a harmonic force, and what its damping is known by.
#[derive(Clone, Debug, Inputs)]
pub struct EquivalentDamping {
    /// Inertia.
    pub mass: OscillatingBody,
    /// Springs.
    pub stiffness: BodyStiffness,
    /// Damping.
    pub damping: DampingLaw,
    /// Force or torque.
    pub force: ForceAmplitude,
    /// Frequency of the force.
    #[input("ω", "rad/s", positive)]
    pub frequency: f64,
}

/// Amplitude of the force, or of the torque.
#[derive(Clone, Debug, Inputs)]
pub enum ForceAmplitude {
    /// Force
    Force {
        /// Amplitude of the force.
        #[input("F₀", "N", positive)]
        force: f64,
    },
    /// Torque
    /// For a rotation.
    Torque {
        /// Amplitude of the torque.
        #[input("T₀", "N*m", positive)]
        torque: f64,
    },
}

/// Damping law and its parameters.
#[derive(Clone, Debug, Inputs)]
pub enum DampingLaw {
    /// Hysteretic: loss factor given
    /// The damping force is a fixed fraction of the elastic force at any frequency: k(1 + iη).
    LossFactor {
        /// Loss factor.
        /// At resonance it is twice the damping ratio; zero without damping.
        #[input("η", "1", nonnegative)]
        loss_factor: f64,
    },
    /// Hysteretic: loop area given
    LoopArea {
        /// Energy lost per cycle.
        /// The area of the force–displacement loop.
        #[input("ΔW", "J", positive)]
        energy: f64,
        /// Amplitude at which it was measured.
        #[input("X_W", "m", positive, kind = "Amplitude")]
        amplitude: f64,
    },
    /// Proportional to the stiffness, by a multiplier
    /// The damping matrix of finite elements, c = βk; the loss factor applies at this frequency.
    StiffnessMultiplier {
        /// Multiplier of the stiffness.
        #[input("β", "s", positive)]
        multiplier: f64,
    },
    /// Drag proportional to the square of the velocity
    QuadraticDrag {
        /// Drag over the square of the velocity.
        #[input("a", "N*s^2/m^2", positive)]
        drag: f64,
    },
    /// Hysteretic: loop area of a rotation given
    /// For a rotation.
    RotationLoop {
        /// Energy lost per cycle.
        /// The area of the torque–angle loop.
        #[input("ΔW", "J", positive)]
        energy: f64,
        /// Amplitude at which it was measured.
        #[input("Θ_W", "rad", positive)]
        amplitude: f64,
    },
    /// Resisting torque proportional to the square of the angular velocity
    /// For a rotation.
    TorsionalDrag {
        /// Torque over the square of the angular velocity.
        #[input("a_t", "N*m*s^2/rad^2", positive)]
        drag: f64,
    },
}

register!(EquivalentDamping);

impl Analysis for EquivalentDamping {
    const ABOUT: About = About {
        id: "vibration/equivalent-damping",
        title: "Hysteretic and other equivalent damping",
        topic: "Harmonic excitation",
        summary: "Equivalent viscous damping, loss factor and steady-state amplitude of an oscillator, moving along a line or about an axis, whose damping is given by its hysteresis loop.",
        main: &["equivalent_damping", "equivalent_ratio", "amplitude"],
        keywords: "structural damping hysteresis loop area loss factor specific damping capacity quadratic drag \
                   amortecimento histerético estrutural fator de perda laço de histerese arrasto quadrático",
        sources: &[&RAO, &THOMSON],
        cases: include_str!("../../cases/equivalent_damping.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &EquivalentDampingGiven<W>, sheet: W) -> Result<(), Refusal> {
        let (of_force, force) = match given.force {
            ForceAmplitudeGiven::Force { force } => (OscillatorMotion::Translation, force),
            ForceAmplitudeGiven::Torque { torque } => (OscillatorMotion::Rotation, torque),
        };
        let rest = [given.stiffness.motion(), given.damping.motion(), Some(of_force)];
        let motion = one_motion(Some(given.mass.motion()), &rest)?;
        let frequency = given.frequency;
        let mass = given.mass.inertia(sheet)?;
        let [natural, stiffness] = given.stiffness.with_body(&given.mass, mass, sheet)?;
        let (amplitude_symbol, amplitude_unit) = (motion.of("X", "Θ"), motion.displacement_unit());
        let why =
            ("Steady-state amplitude: spring and inertia on one side, damping on the other", RAO.at("§3.9"));
        let (loss, amplitude, damping) = match &given.damping {
            DampingLawGiven::QuadraticDrag { drag } | DampingLawGiven::TorsionalDrag { drag } => {
                let elastic = sheet.step(
                    motion.of("K", "K_t"),
                    motion.stiffness().1,
                    (stiffness - mass * frequency.powi(2)).abs(),
                    motion.of(
                        "Force of spring and inertia per metre of amplitude",
                        "Torque of spring and inertia per radian of amplitude",
                    ),
                );
                sheet.common_error("A", "the drag linearized at the largest velocity of the cycle", || {
                    *drag * frequency.powi(2)
                });
                sheet.common_error("A", "the drag linearized at the mean velocity of the cycle", || {
                    *drag * frequency.powi(2) * 2.0 / PI
                });
                let first = sheet.step(
                    "A",
                    motion.of("N/m^2", "N*m/rad^2"),
                    *drag * frequency.powi(2) * 8.0 / (3.0 * PI),
                    (
                        motion.of(
                            "The drag a v|v| is equivalent to a viscous damping 8aωX/(3π), which dissipates the same energy per cycle",
                            "The drag a_t Ω|Ω| is equivalent to a viscous damping 8a_tωΘ/(3π), which dissipates the same energy per cycle",
                        ),
                        RAO.at("§3.10"),
                    ),
                );
                // X² is the positive root of A²X⁴ + K²X² = F₀², without cancellation.
                let square = force.powi(2) * 2.0
                    / (elastic.powi(2) + (elastic.powi(4) + (first * force).powi(2) * 4.0).sqrt());
                let amplitude = sheet.step(
                    amplitude_symbol,
                    amplitude_unit,
                    square.sqrt(),
                    motion.of(
                        "Steady-state amplitude: (K X)² + (A X²)² = F₀², a quadratic equation in X²",
                        "Steady-state amplitude: (K_t Θ)² + (A Θ²)² = T₀², a quadratic equation in Θ²",
                    ),
                );
                sheet.common_error(
                    "c_eq",
                    "the drag linearized at the largest velocity of the cycle",
                    || *drag * frequency * amplitude,
                );
                sheet.common_error("c_eq", "the drag linearized at the mean velocity of the cycle", || {
                    *drag * frequency * amplitude * 2.0 / PI
                });
                let damping = sheet.step(
                    "c_eq",
                    motion.damping_unit(),
                    *drag * frequency * amplitude * 8.0 / (3.0 * PI),
                    motion.of(
                        "Equivalent viscous damping, 8aωX/(3π)",
                        "Equivalent viscous damping, 8a_tωΘ/(3π)",
                    ),
                );
                let loss = sheet.step(
                    "η",
                    "1",
                    damping * frequency / stiffness,
                    "Loss factor at this frequency and amplitude",
                );
                (loss, amplitude, damping)
            }
            other => {
                let loss = match other {
                    DampingLawGiven::LossFactor { loss_factor } => *loss_factor,
                    DampingLawGiven::LoopArea { energy, amplitude }
                    | DampingLawGiven::RotationLoop { energy, amplitude } => {
                        sheet.common_error(
                            "η",
                            "the specific damping capacity taken as the loss factor",
                            || *energy * 2.0 / (stiffness * amplitude.powi(2)),
                        );
                        sheet.step(
                            "η",
                            "1",
                            *energy / (stiffness * amplitude.powi(2) * PI),
                            (
                                motion.of(
                                    "Loss factor: the area of the loop is πηkX²",
                                    "Loss factor: the area of the loop is πηk_tΘ²",
                                ),
                                RAO.at("§2.10"),
                            ),
                        )
                    }
                    DampingLawGiven::StiffnessMultiplier { multiplier } => {
                        sheet.common_error(
                            "η",
                            "the natural frequency used in place of that of the excitation",
                            || natural * *multiplier,
                        );
                        sheet.step(
                            "η",
                            "1",
                            frequency * *multiplier,
                            motion.of(
                                "Loss factor at this frequency: the damping force βωkX over the elastic one",
                                "Loss factor at this frequency: the damping torque βωk_tΘ over the elastic one",
                            ),
                        )
                    }
                    DampingLawGiven::QuadraticDrag { .. } | DampingLawGiven::TorsionalDrag { .. } => {
                        unreachable!("done above")
                    }
                };
                if loss.value() == 0.0 && stiffness.value() == mass.value() * frequency.value().powi(2) {
                    return Err(Refusal::because(
                        "without damping, the amplitude at the natural frequency grows without bound: there is no steady \
                         state",
                    ));
                }
                let amplitude = force
                    / ((stiffness - mass * frequency.powi(2)).powi(2) + (loss * stiffness).powi(2)).sqrt();
                sheet.common_error(
                    amplitude_symbol,
                    "the viscous damping equivalent at resonance used at this frequency",
                    || {
                        let damping = loss * stiffness / natural;
                        sdof::forced_amplitude(force, stiffness, mass, damping, frequency)
                    },
                );
                let amplitude = sheet.step(amplitude_symbol, amplitude_unit, amplitude, why);
                sheet.common_error(
                    "c_eq",
                    "the natural frequency used in place of that of the excitation",
                    || loss * stiffness / natural,
                );
                if let DampingLawGiven::LoopArea { energy, .. }
                | DampingLawGiven::RotationLoop { energy, .. } = other
                {
                    sheet.common_error(
                        "c_eq",
                        "the energy measured at another amplitude used with the amplitude of this motion",
                        || *energy / (frequency * amplitude.powi(2) * PI),
                    );
                }
                let damping = sheet.step(
                    "c_eq",
                    motion.damping_unit(),
                    loss * stiffness / frequency,
                    ("Equivalent viscous damping at this frequency", RAO.at("§2.10")),
                );
                (loss, amplitude, damping)
            }
        };
        sheet.check(
            "the amplitude of a viscous oscillator with the equivalent damping",
            sdof::forced_amplitude(force, stiffness, mass, damping, frequency),
            amplitude,
        );
        let is_drag = matches!(
            given.damping,
            DampingLawGiven::QuadraticDrag { .. } | DampingLawGiven::TorsionalDrag { .. }
        );
        if !is_drag {
            sheet.common_error(
                "φ",
                "the phase with the viscous damping equivalent at resonance taken",
                || (loss * frequency / natural).atan2(W::Num::from(1.0) - (frequency / natural).powi(2)),
            );
        }
        let phase = sheet.step(
            "φ",
            "deg",
            (loss * stiffness).atan2(stiffness - mass * frequency.powi(2)),
            (motion.of("The motion lags the force by", "The motion lags the torque by"), RAO.at("§3.9")),
        );
        sheet.common_error("W", "the elastic energy of the spring taken as the energy lost", || {
            stiffness * amplitude.powi(2) / 2.0
        });
        let energy = sheet.step(
            "W",
            "J",
            loss * stiffness * amplitude.powi(2) * PI,
            ("Energy lost per cycle: the area of the loop", RAO.at("§2.10")),
        );
        sheet.check(
            motion.of(
                "the force supplies the same energy, πF₀X sin φ",
                "the torque supplies the same energy, πT₀Θ sin φ",
            ),
            force * amplitude * phase.sin() * PI,
            energy,
        );
        self.summed_loop([stiffness, amplitude].map(Real::value), energy, sheet);
        let capacity = sheet.step(
            "ψ",
            "%",
            loss * 2.0 * PI,
            (
                motion.of(
                    "Specific damping capacity: that energy over the largest elastic energy kX²/2",
                    "Specific damping capacity: that energy over the largest elastic energy k_tΘ²/2",
                ),
                RAO.at("§2.6.4"),
            ),
        );
        if !is_drag {
            sheet.common_error(
                "ζ_eq",
                "the relation ζ = η/2, which holds at resonance, used at another frequency",
                || loss / 2.0,
            );
        }
        let ratio = sheet.step(
            "ζ_eq",
            "1",
            sdof::damping_ratio(damping, stiffness, mass),
            ("Equivalent damping ratio; for hysteretic damping at resonance η/2", RAO.at("§2.10")),
        );
        sheet.verify(|| {
            let (one, over) = (W::Num::from(1.0), frequency / natural);
            sheet.check(
                "amplitude from the frequency ratio and the loss factor, δ/√((1 − r²)² + η²)",
                force / stiffness / ((one - over.powi(2)).powi(2) + loss.powi(2)).sqrt(),
                amplitude,
            );
            sheet.check("the loss factor at this frequency is 2ζr", ratio * over * 2.0, loss);
        });
        let (name, label) = motion.of(("mass", "Mass"), ("inertia", "Moment of inertia"));
        sheet.answer(name, label, mass);
        sheet.answer("stiffness", motion.of("Stiffness", "Torsional stiffness"), stiffness);
        let (name, label) =
            motion.of(("force", "Amplitude of the force"), ("torque", "Amplitude of the torque"));
        sheet.answer(name, label, force);
        sheet.answer("natural_frequency", "Natural frequency", natural);
        sheet.answer("loss_factor", "Loss factor", loss);
        sheet.answer("amplitude", "Amplitude at this frequency", amplitude);
        sheet.answer("phase", "Phase lag", phase);
        sheet.answer("equivalent_damping", "Equivalent viscous damping", damping);
        sheet.answer("equivalent_ratio", "Equivalent damping ratio", ratio);
        sheet.answer("energy", "Energy lost per cycle", energy);
        sheet.answer("damping_capacity", "Specific damping capacity", capacity);
        if let DampingLawGiven::LossFactor { .. }
        | DampingLawGiven::LoopArea { .. }
        | DampingLawGiven::RotationLoop { .. } = &given.damping
            && loss.value() > 0.0
        {
            let largest = sheet.step(
                motion.of("Xₘₐₓ", "Θₘₐₓ"),
                amplitude_unit,
                force / (loss * stiffness),
                (
                    "Maximum amplitude, exactly at the natural frequency, unlike that of viscous damping",
                    RAO.at("§3.9"),
                ),
            );
            sheet.answer("largest_amplitude", "Maximum amplitude at any frequency", largest);
            sheet.verify(|| {
                let damping = loss * stiffness / natural;
                sheet.check(
                    "maximum amplitude from the dynamic stiffness at the natural frequency",
                    sdof::forced_amplitude(force, stiffness, mass, damping, natural),
                    largest,
                );
            });
        }
        let numbers = Numbers {
            motion,
            mass: mass.value(),
            stiffness: stiffness.value(),
            force: force.value(),
            loss: loss.value(),
            natural: natural.value(),
        };
        let amplitude = amplitude.value();
        sheet.show(|| Exhibit::Plot(self.hysteresis(&numbers, amplitude)));
        sheet.show(|| Exhibit::Plot(self.response(&numbers, amplitude)));
        sheet.show(|| Exhibit::Drawing(self.drawing(motion)));
        Ok(())
    }
}

/// Parameters of the plotted response.
struct Numbers {
    motion: OscillatorMotion,
    mass: f64,
    stiffness: f64,
    force: f64,
    loss: f64,
    natural: f64,
}

impl<W: Worksheet> DampingLawGiven<W> {
    /// The motion that it is of, if it is of one only.
    fn motion(&self) -> Option<OscillatorMotion> {
        match self {
            DampingLawGiven::QuadraticDrag { .. } | DampingLawGiven::LoopArea { .. } => {
                Some(OscillatorMotion::Translation)
            }
            DampingLawGiven::TorsionalDrag { .. } | DampingLawGiven::RotationLoop { .. } => {
                Some(OscillatorMotion::Rotation)
            }
            DampingLawGiven::LossFactor { .. } | DampingLawGiven::StiffnessMultiplier { .. } => None,
        }
    }
}

impl EquivalentDamping {
    /// The damping force at a phase of the cycle `x = X sin ψ`; `elastic` is the force of the spring at its amplitude.
    fn damping_force(&self, elastic: f64, amplitude: f64, loss: f64, phase: f64) -> f64 {
        match self.damping {
            DampingLaw::QuadraticDrag { drag } | DampingLaw::TorsionalDrag { drag } => {
                let velocity = self.frequency * amplitude * phase.cos();
                drag * velocity * velocity.abs()
            }
            _ => loss * elastic * phase.cos(),
        }
    }

    /// Holds the energy to the area of the loop, summed.
    fn summed_loop<W: Worksheet>(&self, [stiffness, amplitude]: [f64; 2], energy: W::Num, sheet: W) {
        let loss = energy.value() / (PI * stiffness * amplitude.powi(2));
        sheet.verify(|| {
            // Half a turn forward, by Simpson's rule; the other half takes as much.
            let panels = 1000u32;
            let at = |n: u32| {
                let phase = -PI / 2.0 + PI * f64::from(n) / f64::from(panels);
                let elastic = stiffness * amplitude;
                let force = elastic * phase.sin() + self.damping_force(elastic, amplitude, loss, phase);
                force * amplitude * phase.cos()
            };
            let weight = |n: u32| {
                if n == 0 || n == panels {
                    1.0
                } else if n % 2 == 1 {
                    4.0
                } else {
                    2.0
                }
            };
            let half: f64 = (0..=panels).map(|n| weight(n) * at(n)).sum();
            let area = 2.0 * half * PI / f64::from(panels) / 3.0;
            sheet.check("area of the hysteresis loop, by summation", W::Num::from(area), energy);
        });
    }

    /// The loop of spring and damping together.
    fn hysteresis(&self, numbers: &Numbers, amplitude: f64) -> Plot {
        let Numbers { motion, stiffness, loss, .. } = *numbers;
        let elastic = stiffness * amplitude;
        let at = |n: u16| {
            let phase = TAU * f64::from(n) / 240.0;
            let force = elastic * phase.sin() + self.damping_force(elastic, amplitude, loss, phase);
            (amplitude * phase.sin(), force)
        };
        Plot::new(
            motion.of("Force–displacement loop over one cycle", "Torque–angle loop over one cycle"),
            Axis::linear(motion.of("displacement", "angle"), motion.displacement_unit()),
            Axis::linear(motion.of("force", "torque"), motion.force_unit()),
            vec![
                Series::line("spring and damping", (0..=240).map(at).collect()),
                Series::line("spring alone", vec![(-amplitude, -elastic), (amplitude, elastic)]),
            ],
        )
    }

    /// Amplitude over frequency, beside the viscous damping with the same loss at resonance.
    fn response(&self, numbers: &Numbers, amplitude: f64) -> Plot {
        let Numbers { motion, mass, stiffness, force, loss, natural } = *numbers;
        let last = (2.0 * natural).max(1.2 * self.frequency);
        let points = || (1..=300u16).map(|n| last * f64::from(n) / 300.0);
        let here = |w: f64| {
            let elastic = (stiffness - mass * w * w).abs();
            let amplitude = match self.damping {
                DampingLaw::QuadraticDrag { drag } | DampingLaw::TorsionalDrag { drag } => {
                    let first = 8.0 * drag * w * w / (3.0 * PI);
                    (2.0 * force * force
                        / (elastic * elastic + (elastic.powi(4) + (2.0 * first * force).powi(2)).sqrt()))
                    .sqrt()
                }
                DampingLaw::StiffnessMultiplier { multiplier } => {
                    force / elastic.hypot(multiplier * w * stiffness)
                }
                _ => force / elastic.hypot(loss * stiffness),
            };
            (w, amplitude)
        };
        // Viscous with the same loss at this frequency.
        let damping = loss * stiffness / self.frequency;
        let viscous = |w: f64| (w, sdof::forced_amplitude(force, stiffness, mass, damping, w));
        Plot::new(
            "Amplitude against frequency",
            Axis::linear(motion.of("frequency of the force", "frequency of the torque"), "Hz"),
            Axis::log("amplitude", motion.displacement_unit()),
            vec![
                Series::line("this damping", points().map(here).collect()).of("amplitude"),
                Series::line("viscous, with the same loss here", points().map(viscous).collect()),
            ],
        )
        .over("frequency")
        .mark("at this frequency", (self.frequency, amplitude))
    }
}

impl EquivalentDamping {
    fn drawing(&self, motion: OscillatorMotion) -> Drawing {
        if motion == OscillatorMotion::Rotation {
            let letters = [self.mass.letters(), self.stiffness.letters().into()];
            return inertia_spring_damper("T₀ cos(ω t)", letters);
        }
        Sketch::new("One degree of freedom")
            .ground((-1.0, -1.5), (1.0, -1.5))
            .spring("k(1 + iη)", (0.0, -1.5), (0.0, -0.4))
            .mass(self.mass.letters(), (-0.9, -0.4), (0.9, 0.4))
            .force("F₀ cos(ω t)", (0.0, 0.4), (0.0, 1.2))
            .motion("x", (1.2, -0.2), (1.2, 0.5))
            .finish()
    }
}
