//! A harmonic force on one mass, or a harmonic torque on a body that rotates: the steady motion, the forces and the power
//! in it, and how it builds up.

use std::f64::consts::{FRAC_1_SQRT_2, PI};

use dalembert_core::{About, Analysis, Drawing, Exhibit, Inputs, Refusal, Text, Worksheet, register};
use dalembert_mechanics::{Real, sdof};

use crate::{
    shared::oscillator::{
        AtFrequency, Loss, MassAndStiffness, Suspension,
        motion::OscillatorMotion,
        parts::{BodyDamping, BodySprings, OscillatingBody, motion_of, suspension_of_body},
        plots,
        transient_from_rest::{BuildUp, Wave},
    },
    sources::{GROVER, RAO, THOMSON},
};

/// The oscillator and the force on it.
#[derive(Clone, Debug, Inputs)]
pub struct HarmonicForce {
    /// Inertia.
    pub mass: OscillatingBody,
    /// Springs.
    pub elasticity: BodySprings,
    /// Damping.
    pub damping: BodyDamping,
    /// Frequency of the force.
    #[input("ω", "rad/s", positive)]
    pub frequency: f64,
    /// Magnitude.
    pub excitation: ForceStrength,
    /// Start from rest.
    /// The displacement at a time after the force is applied.
    pub start: Option<StartFromRest>,
}

/// Amplitude of the force, or the amplitude or power that determines it.
#[derive(Clone, Debug, Inputs)]
pub enum ForceStrength {
    /// Force given
    Force {
        /// Amplitude of the force.
        #[input("F₀", "N", positive)]
        force: f64,
    },
    /// Amplitude of the motion given, force unknown
    Motion {
        /// Amplitude of the motion.
        /// Zero to peak, unless the unit specifies otherwise.
        #[input("X", "m", positive, kind = "Amplitude")]
        amplitude: f64,
    },
    /// Mean power given, force sought
    Power {
        /// Mean power.
        #[input("P", "W", positive)]
        power: f64,
    },
    /// Torque given
    /// For a rotation.
    Torque {
        /// Amplitude of the torque.
        #[input("T₀", "N*m", positive)]
        torque: f64,
    },
    /// Amplitude of the rotation given, torque unknown
    Rotation {
        /// Amplitude of the rotation.
        #[input("Θ", "rad", positive)]
        amplitude: f64,
    },
}

/// The oscillator is at rest until the force sets in.
#[derive(Clone, Debug, Inputs)]
pub struct StartFromRest {
    /// Force.
    pub wave: Wave,
    /// Time.
    /// From the start of the force.
    #[input("t", "s", nonnegative)]
    pub time: f64,
}

register!(HarmonicForce);

impl Analysis for HarmonicForce {
    const ABOUT: About = About {
        id: "vibration/harmonic-force",
        title: "Harmonic force or torque",
        topic: "Harmonic excitation",
        summary: "Steady-state amplitude, phase, forces and power of one mass under a harmonic force, or of a rotating body under a harmonic torque, and its motion from rest.",
        main: &["amplitude", "phase", "transmitted_force", "growth"],
        keywords: "forced resonance magnification power hysteretic build-up phasor torsional oscillation dashpot \
                   torque força harmônica ressonância amplificação potência regime permanente transitório torque \
                   harmônico oscilação torcional single degree of freedom um grau de liberdade",
        sources: &[&RAO, &THOMSON, &GROVER],
        cases: include_str!("../../cases/harmonic_force.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &HarmonicForceGiven<W>, sheet: W) -> Result<(), Refusal> {
        let HarmonicForceGiven { mass, elasticity, damping, .. } = given;
        let motion = motion_of(Some(mass), elasticity, damping, given.excitation.motion())?;
        let suspension = suspension_of_body(motion, Some(mass), elasticity, damping, sheet)?;
        let body = suspension.body.expect("the mass is given");
        suspension.answer(sheet);
        let at = suspension.at(given.frequency, sheet);
        sheet.answer("frequency_ratio", "Frequency ratio", at.ratio);
        if suspension.is_undamped() && at.is_resonance() {
            return self.unbounded(given, &suspension, at, sheet);
        }
        let c = at.damping.expect("the mass is given");
        let system = ForcedOscillator { motion, frequency: given.frequency, body, c, at };
        let (force, amplitude) = strength(given, &system, sheet)?;
        sheet.common_error("φ", "the phase of a mass on a moving base taken", || {
            sdof::transmissibility_phase(at.ratio, at.damping_ratio)
        });
        let phase = sheet.step(
            "φ",
            "deg",
            sdof::phase_lag_from_ratios(at.ratio, at.damping_ratio),
            (motion.of("The motion lags the force by", "The motion lags the torque by"), RAO.at("§3.4")),
        );
        sheet.answer("phase", "Phase lag", phase);
        let (velocity, forces) = system.forces(force, amplitude, sheet);
        system.power(force, amplitude, (velocity, phase), sheet);
        resonances(&suspension, body, force, sheet);
        if let Some(start) = &given.start {
            let wave = self.start.as_ref().map_or(Wave::Sine, |start| start.wave);
            let deflection = static_deflection(motion, force, body.stiffness, sheet);
            let build_up = BuildUp {
                motion,
                deflection,
                frequency: given.frequency,
                natural: suspension.natural,
                at,
                steady: Some((amplitude, phase)),
                wave,
                through_dashpot: false,
            };
            if let Loss::Hysteretic(eta) = suspension.loss
                && eta.value() > 0.0
            {
                sheet.warn(|| {
                    Text::new(
                        "the motion from rest represents hysteretic damping by a viscous damper with the same energy loss per cycle at this frequency",
                    )
                });
            }
            let x = build_up.displacement(start.time, sheet);
            sheet.answer("displacement", motion.of("Displacement at that time", "Angle at that time"), x);
            build_up.show(start.time.value(), "Motion from rest", x.value(), sheet);
        }
        let zeta = own_damping(&suspension);
        plots::force_families(at.ratio.value(), zeta, Some("magnification"), sheet);
        sheet.show(|| Exhibit::Drawing(self.drawing(motion)));
        sheet.show(|| {
            let [spring, damper, inertia] = forces;
            Exhibit::Drawing(plots::force_vectors(motion, spring, damper, inertia))
        });
        Ok(())
    }
}

impl HarmonicForce {
    /// The oscillator under its force or torque.
    fn drawing(&self, motion: OscillatorMotion) -> Drawing {
        let letters = [self.mass.letters(), self.elasticity.letters().into()];
        match motion {
            OscillatorMotion::Translation => {
                let force = match self.excitation {
                    ForceStrength::Motion { .. } => "F₀ cos(ω t), X",
                    _ => "F₀ cos(ω t)",
                };
                plots::mass_spring_damper(force, letters)
            }
            OscillatorMotion::Rotation => {
                let torque = match self.excitation {
                    ForceStrength::Rotation { .. } => "T₀ cos(ω t), Θ",
                    _ => "T₀ cos(ω t)",
                };
                plots::inertia_spring_damper(torque, letters)
            }
        }
    }
}

/// The deflection that the amplitude of the force would hold at rest.
fn static_deflection<W: Worksheet>(
    motion: OscillatorMotion,
    force: W::Num,
    stiffness: W::Num,
    sheet: W,
) -> W::Num {
    let why = motion.of("Deflection under a constant force F₀", "Angle of twist under a constant torque T₀");
    sheet.step(motion.deflection(), motion.displacement_unit(), force / stiffness, why)
}

impl<W: Worksheet> ForceStrengthGiven<W> {
    /// The motion that it is of, if it is of one only.
    fn motion(&self) -> Option<OscillatorMotion> {
        match self {
            ForceStrengthGiven::Torque { .. } | ForceStrengthGiven::Rotation { .. } => {
                Some(OscillatorMotion::Rotation)
            }
            ForceStrengthGiven::Force { .. } | ForceStrengthGiven::Motion { .. } => {
                Some(OscillatorMotion::Translation)
            }
            ForceStrengthGiven::Power { .. } => None,
        }
    }
}

/// Parameters of the steady-state motion.
struct ForcedOscillator<N> {
    motion: OscillatorMotion,
    frequency: N,
    body: MassAndStiffness<N>,
    c: N,
    at: AtFrequency<N>,
}

/// The damping ratio at a frequency ratio, for plots.
fn own_damping<N: Real>(suspension: &Suspension<N>) -> impl Fn(f64) -> f64 + Copy + use<N> {
    let (zeta, eta) = match suspension.loss {
        Loss::Viscous(zeta, _) => (zeta.value(), 0.0),
        Loss::Hysteretic(eta) => (0.0, eta.value()),
    };
    move |r| zeta + 0.5 * eta / r
}

/// Force and amplitude, the one from the other.
fn strength<W: Worksheet>(
    given: &HarmonicForceGiven<W>,
    system: &ForcedOscillator<W::Num>,
    sheet: W,
) -> Result<(W::Num, W::Num), Refusal> {
    let ForcedOscillator { motion, frequency, body: MassAndStiffness { mass, stiffness: k }, c, at } =
        *system;
    sheet.common_error("M", "the transmissibility used", || {
        sdof::transmissibility(at.ratio, at.damping_ratio)
    });
    sheet.common_error("M", "the response to a rotating unbalance used", || {
        sdof::unbalance_magnification(at.ratio, at.damping_ratio)
    });
    let magnification = sheet.step(
        "M",
        "1",
        sdof::magnification(at.ratio, at.damping_ratio),
        ("Magnification of the static deflection", RAO.at("§3.4")),
    );
    sheet.answer("magnification", "Magnification factor", magnification);
    let sought = |amplitude: W::Num| {
        let why = motion.of("Force required for this amplitude", "Torque required for this amplitude");
        let force = amplitude * k / magnification;
        sheet.common_error(
            motion.of("F₀", "T₀"),
            "the parts of spring, damper and inertia added without their phases",
            || amplitude * (k + c * frequency + mass * frequency.powi(2)),
        );
        sheet.step(motion.of("F₀", "T₀"), motion.force_unit(), force, (why, RAO.at("§3.4")))
    };
    let symbol = motion.of("X", "Θ");
    let (force, amplitude) = match &given.excitation {
        ForceStrengthGiven::Force { force } | ForceStrengthGiven::Torque { torque: force } => {
            let why = ("Steady-state amplitude", RAO.at("§3.4"));
            if c.value() > 0.0 {
                sheet.common_error(
                    symbol,
                    "the damper alone assumed to balance the excitation, as at resonance",
                    || *force / (c * frequency),
                );
            }
            (*force, sheet.step(symbol, motion.displacement_unit(), *force / k * magnification, why))
        }
        ForceStrengthGiven::Motion { amplitude } | ForceStrengthGiven::Rotation { amplitude } => {
            (sought(*amplitude), *amplitude)
        }
        ForceStrengthGiven::Power { power } => {
            if c.value() == 0.0 {
                return Err(Refusal::because(
                    "without damping the steady-state motion requires no power: write some damping, or give the force",
                ));
            }
            let why = motion.of(
                "Amplitude, from the power P = ½ c ω² X² dissipated by the damper",
                "Amplitude, from the power P = ½ c_t ω² Θ² dissipated by the damper",
            );
            let amplitude = (*power * 2.0 / c).sqrt() / frequency;
            let amplitude = sheet.step(symbol, motion.displacement_unit(), amplitude, (why, RAO.at("§2.6")));
            (sought(amplitude), amplitude)
        }
    };
    sheet.check(
        "amplitude from the dynamic stiffness",
        sdof::forced_amplitude(force, k, mass, c, frequency),
        amplitude,
    );
    let (name, label) = motion.of(("force", "Amplitude of the force"), ("torque", "Amplitude of the torque"));
    sheet.answer(name, label, force);
    sheet.answer("amplitude", motion.of("Amplitude", "Amplitude of the rotation"), amplitude);
    Ok((force, amplitude))
}

impl<N: Real> ForcedOscillator<N> {
    /// Velocity, acceleration and the forces in spring, damper and ground; the velocity, and the sizes of the forces of
    /// spring, damper and inertia.
    fn forces<W: Worksheet<Num = N>>(&self, force: N, amplitude: N, sheet: W) -> (N, [f64; 3]) {
        let ForcedOscillator { motion, frequency, body: MassAndStiffness { mass, stiffness: k }, c, .. } =
            *self;
        let label = motion.of("Amplitude of the velocity", "Amplitude of the angular velocity");
        let velocity = sheet.step(motion.of("V", "Ω"), motion.velocity_unit(), amplitude * frequency, label);
        sheet.answer("velocity", label, velocity);
        let label = motion.of("Amplitude of the acceleration", "Amplitude of the angular acceleration");
        let (symbol, unit) = motion.of(("A", "m/s^2"), ("α", "rad/s^2"));
        let acceleration = sheet.step(symbol, unit, amplitude * frequency.powi(2), label);
        sheet.answer("acceleration", label, acceleration);
        let unit = motion.force_unit();
        let (name, label) =
            motion.of(("spring_force", "Force in the spring"), ("spring_torque", "Torque in the spring"));
        let spring = sheet.step(motion.of("F_k", "T_k"), unit, k * amplitude, label);
        sheet.answer(name, label, spring);
        let (name, label) =
            motion.of(("damper_force", "Force in the damper"), ("damper_torque", "Torque in the damper"));
        let damper = sheet.step(motion.of("F_c", "T_c"), unit, c * frequency * amplitude, label);
        sheet.answer(name, label, damper);
        let why = motion.of(
            "Amplitude of the force transmitted to the foundation",
            "Amplitude of the torque transmitted to the foundation",
        );
        let transmitted = sdof::transmitted_force(amplitude, k, c, frequency);
        sheet.common_error(motion.of("F_T", "T_T"), "the transmissibility without damping used", || {
            force / (N::from(1.0) - self.at.ratio.powi(2)).abs()
        });
        sheet.common_error(
            motion.of("F_T", "T_T"),
            "inertia times acceleration taken as the load on the foundation",
            || mass * acceleration,
        );
        let transmitted = sheet.step(motion.of("F_T", "T_T"), unit, transmitted, (why, RAO.at("§3.6")));
        let (name, label) = motion.of(
            ("transmitted_force", "Force transmitted to the foundation"),
            ("transmitted_torque", "Torque transmitted to the foundation"),
        );
        sheet.answer(name, label, transmitted);
        sheet.verify(|| {
            sheet.check(
                motion.of(
                    "spring, damper and inertia forces close the force polygon",
                    "torques of spring, damper and inertia close the polygon of torques",
                ),
                ((spring - mass * acceleration).powi(2) + damper.powi(2)).sqrt(),
                force,
            );
            sheet.check(
                motion.of(
                    "transmitted force from the transmissibility",
                    "transmitted torque from the transmissibility",
                ),
                force * sdof::transmissibility(self.at.ratio, self.at.damping_ratio),
                transmitted,
            );
        });
        (velocity, [spring, damper, mass * acceleration].map(Real::value))
    }

    fn power<W: Worksheet<Num = N>>(&self, force: N, amplitude: N, (velocity, phase): (N, N), sheet: W) {
        let ForcedOscillator { motion, frequency, c, .. } = *self;
        let work = sheet.step(
            "E",
            "J",
            c * frequency * amplitude.powi(2) * PI,
            ("Energy dissipated by the damper per cycle", RAO.at("§2.6")),
        );
        sheet.common_error(
            "P",
            "the amplitudes of excitation and velocity multiplied without the phase between them",
            || force * velocity / 2.0,
        );
        let power = sheet.step(
            "P",
            "W",
            c * (frequency * amplitude).powi(2) / 2.0,
            ("Mean power: that energy, ω/2π times per second", RAO.at("§2.6")),
        );
        let largest = frequency.value() * amplitude.value() * force.value();
        sheet.verify(|| {
            sheet.check_zero(
                motion.of(
                    "mean power from force, velocity and the angle between them",
                    "mean power from torque, angular velocity and the angle between them",
                ),
                force * velocity * phase.sin() / 2.0 - power,
                largest,
            );
            sheet.check_sum(
                motion.of(
                    "work of the force in a cycle = energy dissipated by the damper, πF₀X sin φ",
                    "work of the torque in a cycle = energy dissipated by the damper, πT₀Θ sin φ",
                ),
                force * amplitude * phase.sin() * PI,
                work,
                PI * force.value() * amplitude.value(),
            );
        });
        sheet.answer("work", "Energy lost per cycle", work);
        sheet.answer("power", "Mean power", power);
    }
}

/// Resonance frequencies of displacement, velocity and acceleration.
fn resonances<W: Worksheet>(
    suspension: &Suspension<W::Num>,
    body: MassAndStiffness<W::Num>,
    force: W::Num,
    sheet: W,
) {
    let Suspension { natural, motion, .. } = *suspension;
    let (symbol, unit) = (motion.of("Xₘₐₓ", "Θₘₐₓ"), motion.displacement_unit());
    match suspension.loss {
        Loss::Viscous(zeta, Some(c)) if zeta.value() > 0.0 => {
            if zeta.value() >= FRAC_1_SQRT_2 {
                sheet.warn(|| {
                    Text::new(
                        "with a damping ratio of 1/√2 or more the displacement has no peak: it is largest at low \
                         frequencies",
                    )
                });
                return;
            }
            sheet.common_error(
                motion.of("ω_x", "ω_θ"),
                "the damped natural frequency taken as that of the peak",
                || sdof::damped_frequency(natural, zeta),
            );
            let displacement = sheet.step(
                motion.of("ω_x", "ω_θ"),
                "rad/s",
                natural * sdof::magnification_peak_ratio(zeta),
                ("Frequency of maximum displacement; the velocity is maximum at ωₙ", RAO.at("§3.4")),
            );
            let acceleration = sheet.step(
                "ω_a",
                "rad/s",
                natural * sdof::unbalance_peak_ratio(zeta),
                ("Frequency of maximum acceleration", RAO.at("§3.4")),
            );
            let largest = sheet.step(
                symbol,
                unit,
                force / body.stiffness * sdof::peak_magnification(zeta),
                ("Maximum amplitude at any frequency", RAO.at("§3.4")),
            );
            sheet.check(
                "maximum amplitude from the dynamic stiffness at its frequency",
                sdof::forced_amplitude(force, body.stiffness, body.mass, c, displacement),
                largest,
            );
            sheet.answer("displacement_resonance", "Frequency of maximum displacement", displacement);
            sheet.answer("acceleration_resonance", "Frequency of maximum acceleration", acceleration);
            sheet.check_zero(
                "maximum acceleration: zero slope with respect to frequency, (ωₙ/ω)² = 1 − 2ζ²",
                (natural / acceleration).powi(2) + zeta.powi(2) * 2.0 - 1.0,
                1.0,
            );
            sheet.answer("largest_amplitude", "Maximum amplitude at any frequency", largest);
        }
        Loss::Hysteretic(eta) if eta.value() > 0.0 => {
            let why = "Maximum amplitude, at ωₙ, where only the loss of the spring balances the force";
            let largest = sheet.step(symbol, unit, force / (eta * body.stiffness), (why, RAO.at("§3.10")));
            sheet.answer("largest_amplitude", "Maximum amplitude at any frequency", largest);
        }
        _ => {}
    }
}

impl HarmonicForce {
    /// Undamped at the natural frequency: no steady motion, but one that grows with the time.
    fn unbounded<W: Worksheet>(
        &self,
        given: &HarmonicForceGiven<W>,
        suspension: &Suspension<W::Num>,
        at: AtFrequency<W::Num>,
        sheet: W,
    ) -> Result<(), Refusal> {
        let motion = suspension.motion;
        let (ForceStrengthGiven::Force { force } | ForceStrengthGiven::Torque { torque: force }) =
            &given.excitation
        else {
            return Err(Refusal::because(motion.of(
                "without damping no force is needed to keep a motion at the natural frequency, and any force makes it \
                 grow without bound: give the force",
                "without damping no torque is needed to keep a rotation at the natural frequency, and any torque makes \
                 it grow without bound: give the torque",
            )));
        };
        let body = suspension.body.expect("the mass is given");
        let deflection = static_deflection(motion, *force, body.stiffness, sheet);
        let growth = sheet.step(
            motion.of("Ẋ", "Θ′"),
            motion.velocity_unit(),
            deflection * suspension.natural / 2.0,
            ("The amplitude is unbounded: it grows with t, per second by", RAO.at("§3.3")),
        );
        sheet.check(
            motion.of(
                "growth rate from the impulse of the force",
                "growth rate from the impulse of the torque",
            ),
            *force / (body.mass * suspension.natural * 2.0),
            growth,
        );
        sheet.answer("growth", "Growth of the amplitude with time", growth);
        sheet.warn(|| {
            Text::new("undamped resonance: the amplitude is unbounded, it grows with t and there is no steady state")
        });
        let build_up = |wave| BuildUp {
            motion,
            deflection,
            frequency: given.frequency,
            natural: suspension.natural,
            at,
            steady: None,
            wave,
            through_dashpot: false,
        };
        match (&given.start, &self.start) {
            (Some(start), Some(StartFromRest { wave, .. })) => {
                let build_up = build_up(*wave);
                let x = build_up.displacement(start.time, sheet);
                sheet.answer("displacement", motion.of("Displacement at that time", "Angle at that time"), x);
                build_up.show(start.time.value(), "Motion from rest", x.value(), sheet);
            }
            _ => {
                let cycles = 20.0 * PI / suspension.natural.value();
                let growth = growth.value() * cycles;
                build_up(Wave::Sine).show(cycles, "Motion from rest", growth, sheet);
            }
        }
        sheet.show(|| Exhibit::Drawing(self.drawing(motion)));
        Ok(())
    }
}
