//! A harmonic force on one mass: the steady motion, the forces and the power in it, and how it builds up.

use std::f64::consts::{FRAC_1_SQRT_2, PI};

use dalembert_core::{About, Analysis, Exhibit, Inputs, Refusal, Text, Worksheet, register};
use dalembert_mechanics::{Real, sdof};

use crate::{
    shared::oscillator::{
        AtFrequency, Damping, Elasticity, Loss, Mass, MassAndStiffness, Suspension, mass, plots, suspension,
        transient_from_rest::{BuildUp, Wave},
    },
    sources::{RAO, THOMSON},
};

/// The oscillator and the force on it.
#[derive(Clone, Debug, Inputs)]
pub struct HarmonicForce {
    /// Inertia.
    pub mass: Mass,
    /// Springs.
    pub elasticity: Elasticity,
    /// Damping.
    pub damping: Damping,
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
        title: "Harmonic force",
        topic: "Harmonic excitation",
        summary: "Steady-state amplitude, phase, forces and power of one mass under a harmonic force, and its motion from rest.",
        keywords: "forced resonance magnification power hysteretic build-up phasor força harmônica ressonância \
                   amplificação potência regime permanente transitório",
        sources: &[&RAO, &THOMSON],
        cases: include_str!("../../cases/harmonic_force.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &HarmonicForceGiven<W>, sheet: W) -> Result<(), Refusal> {
        let mass = mass(&given.mass, sheet);
        let suspension = suspension(Some(mass), &given.elasticity, &given.damping, sheet)?;
        let body = suspension.body.expect("the mass is given");
        suspension.answer(sheet);
        let at = suspension.at(given.frequency, sheet);
        sheet.answer("frequency_ratio", "Frequency ratio", at.ratio);
        if suspension.is_undamped() && at.is_resonance() {
            return self.unbounded(given, &suspension, at, sheet);
        }
        let c = at.damping.expect("the mass is given");
        let system = ForcedOscillator { frequency: given.frequency, body, c, at };
        let (force, amplitude) = strength(given, &system, sheet)?;
        let phase = sheet.step(
            "φ",
            "deg",
            sdof::phase_lag_from_ratios(at.ratio, at.damping_ratio),
            ("The motion lags the force by", RAO.at("§3.4")),
        );
        sheet.answer("phase", "Phase lag", phase);
        let (velocity, forces) = system.forces(force, amplitude, sheet);
        system.power(force, amplitude, (velocity, phase), sheet);
        resonances(&suspension, body, force, sheet);
        if let Some(start) = &given.start {
            let wave = self.start.as_ref().map_or(Wave::Sine, |start| start.wave);
            let deflection =
                sheet.step("δ", "mm", force / body.stiffness, "Deflection under a constant force F₀");
            let build_up = BuildUp {
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
            sheet.answer("displacement", "Displacement at that time", x);
            build_up.show(start.time.value(), "Motion from rest", x.value(), sheet);
        }
        let zeta = own_damping(&suspension);
        plots::force_families(at.ratio.value(), zeta, Some("magnification"), sheet);
        sheet.show(|| {
            let [spring, damper, inertia] = forces;
            Exhibit::Drawing(plots::force_vectors(spring, damper, inertia))
        });
        sheet.show(|| Exhibit::Drawing(plots::mass_spring_damper("F₀ cos ωt")));
        Ok(())
    }
}

/// Parameters of the steady-state motion.
struct ForcedOscillator<N> {
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
    let ForcedOscillator { frequency, body: MassAndStiffness { mass, stiffness: k }, c, at } = *system;
    let magnification = sheet.step(
        "M",
        "1",
        sdof::magnification(at.ratio, at.damping_ratio),
        ("Magnification of the static deflection", RAO.at("§3.4")),
    );
    sheet.answer("magnification", "Magnification", magnification);
    let sought = |amplitude: W::Num| {
        let why = ("Force required for this amplitude", RAO.at("§3.4"));
        sheet.step("F₀", "N", amplitude * k / magnification, why)
    };
    let (force, amplitude) = match &given.excitation {
        ForceStrengthGiven::Force { force } => {
            let why = ("Steady-state amplitude", RAO.at("§3.4"));
            (*force, sheet.step("X", "mm", *force / k * magnification, why))
        }
        ForceStrengthGiven::Motion { amplitude } => (sought(*amplitude), *amplitude),
        ForceStrengthGiven::Power { power } => {
            if c.value() == 0.0 {
                return Err(Refusal::because(
                    "without damping the steady-state motion requires no power: write some damping, or give the force",
                ));
            }
            let why = ("Amplitude, from the power P = ½ c ω² X² dissipated by the damper", RAO.at("§2.6"));
            let amplitude = sheet.step("X", "mm", (*power * 2.0 / c).sqrt() / frequency, why);
            (sought(amplitude), amplitude)
        }
    };
    sheet.check(
        "amplitude from the dynamic stiffness",
        sdof::forced_amplitude(force, k, mass, c, frequency),
        amplitude,
    );
    sheet.answer("force", "Amplitude of the force", force);
    sheet.answer("amplitude", "Amplitude", amplitude);
    Ok((force, amplitude))
}

impl<N: Real> ForcedOscillator<N> {
    /// Velocity, acceleration and the forces in spring, damper and ground; the velocity, and the sizes of the forces of
    /// spring, damper and inertia.
    fn forces<W: Worksheet<Num = N>>(&self, force: N, amplitude: N, sheet: W) -> (N, [f64; 3]) {
        let ForcedOscillator { frequency, body: MassAndStiffness { mass, stiffness: k }, c, .. } = *self;
        let velocity = sheet.step("V", "mm/s", amplitude * frequency, "Amplitude of the velocity");
        let acceleration =
            sheet.step("A", "m/s^2", amplitude * frequency.powi(2), "Amplitude of the acceleration");
        let spring = sheet.step("F_k", "N", k * amplitude, "Force in the spring");
        let damper = sheet.step("F_c", "N", c * frequency * amplitude, "Force in the damper");
        let transmitted = sheet.step(
            "F_T",
            "N",
            sdof::transmitted_force(amplitude, k, c, frequency),
            ("Amplitude of the force transmitted to the foundation", RAO.at("§3.6")),
        );
        sheet.verify(|| {
            sheet.check(
                "spring, damper and inertia forces close the force polygon",
                ((spring - mass * acceleration).powi(2) + damper.powi(2)).sqrt(),
                force,
            );
            sheet.check(
                "transmitted force from the transmissibility",
                force * sdof::transmissibility(self.at.ratio, self.at.damping_ratio),
                transmitted,
            );
        });
        sheet.answer("velocity", "Amplitude of the velocity", velocity);
        sheet.answer("acceleration", "Amplitude of the acceleration", acceleration);
        sheet.answer("spring_force", "Force in the spring", spring);
        sheet.answer("damper_force", "Force in the damper", damper);
        sheet.answer("transmitted_force", "Force transmitted to the foundation", transmitted);
        (velocity, [spring, damper, mass * acceleration].map(Real::value))
    }

    fn power<W: Worksheet<Num = N>>(&self, force: N, amplitude: N, (velocity, phase): (N, N), sheet: W) {
        let ForcedOscillator { frequency, c, .. } = *self;
        let work = sheet.step(
            "E",
            "J",
            c * frequency * amplitude.powi(2) * PI,
            ("Energy dissipated by the damper per cycle", RAO.at("§2.6")),
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
                "mean power from force, velocity and the angle between them",
                force * velocity * phase.sin() / 2.0 - power,
                largest,
            );
            sheet.check_sum(
                "work of the force in a cycle = energy dissipated by the damper, πF₀X sin φ",
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
    let natural = suspension.natural;
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
            let displacement = sheet.step(
                "ω_x",
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
                "Xₘₐₓ",
                "mm",
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
            let largest = sheet.step("Xₘₐₓ", "mm", force / (eta * body.stiffness), (why, RAO.at("§3.10")));
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
        let ForceStrengthGiven::Force { force } = &given.excitation else {
            return Err(Refusal::because(
                "without damping no force is needed to keep a motion at the natural frequency, and any force makes it \
                 grow without bound: give the force",
            ));
        };
        let body = suspension.body.expect("the mass is given");
        let deflection =
            sheet.step("δ", "mm", *force / body.stiffness, "Deflection under a constant force F₀");
        let growth = sheet.step(
            "Ẋ",
            "mm/s",
            deflection * suspension.natural / 2.0,
            ("The amplitude is unbounded: it grows with t, per second by", RAO.at("§3.3")),
        );
        sheet.check(
            "growth rate from the impulse of the force",
            *force / (body.mass * suspension.natural * 2.0),
            growth,
        );
        sheet.answer("growth", "Growth of the amplitude with time", growth);
        sheet.warn(|| {
            Text::new("undamped resonance: the amplitude is unbounded, it grows with t and there is no steady state")
        });
        let build_up = |wave| BuildUp {
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
                sheet.answer("displacement", "Displacement at that time", x);
                build_up.show(start.time.value(), "Motion from rest", x.value(), sheet);
            }
            _ => {
                let cycles = 20.0 * PI / suspension.natural.value();
                let growth = growth.value() * cycles;
                build_up(Wave::Sine).show(cycles, "Motion from rest", growth, sheet);
            }
        }
        sheet.show(|| Exhibit::Drawing(plots::mass_spring_damper("F₀ cos ωt")));
        Ok(())
    }
}
