//! A mass on a spring with dry friction under a harmonic force: equivalent damping beside the exact motion.

use std::f64::consts::{PI, TAU};

use dalembert_core::{
    About, Analysis, Axis, Drawing, Exhibit, Inputs, Plot, Refusal, Series, Sketch, Text, Worksheet, register,
};
use dalembert_mechanics::{
    Real, sdof,
    vibration::forced_coulomb::{self, CoulombOscillator, CoulombResponse},
};
use dalembert_numerics::quadrature::integral;

use crate::{
    shared::oscillator::{Mass, SpringData, given_weight, mass},
    sources::{DEN_HARTOG_1931, GROVER, RAO},
};

/// A mass that rubs, and what shakes it.
#[derive(Clone, Debug, Inputs)]
pub struct ForcedCoulomb {
    /// Mass or weight.
    pub mass: Mass,
    /// Springs.
    pub stiffness: SpringData,
    /// Friction.
    pub friction: FrictionLevel,
    /// Frequency of the force.
    #[input("ω", "rad/s", positive)]
    pub frequency: f64,
    /// Excitation.
    pub excitation: ForceOrAmplitude,
}

/// Friction force, or the coefficient that gives it.
#[derive(Clone, Debug, Inputs)]
pub enum FrictionLevel {
    /// Friction force given
    Force {
        /// Friction force.
        #[input("F", "N", positive)]
        force: f64,
    },
    /// Coefficient of friction on a horizontal surface
    Coefficient {
        /// Coefficient of friction.
        #[input("µ", "1", positive)]
        coefficient: f64,
        /// Gravity.
        #[input("g", "m/s^2", positive, default = "9.81 m/s^2")]
        gravity: f64,
    },
    /// Coefficient of friction and normal force
    Normal {
        /// Coefficient of friction.
        #[input("µ", "1", positive)]
        coefficient: f64,
        /// Normal force.
        #[input("N", "N", positive)]
        normal: f64,
    },
}

/// Given quantities of force and motion.
#[derive(Clone, Debug, Inputs)]
pub enum ForceOrAmplitude {
    /// Force given, amplitude unknown
    Force {
        /// Amplitude of the force.
        #[input("F₀", "N", positive)]
        force: f64,
    },
    /// Amplitude given, force unknown
    Amplitude {
        /// Amplitude of the motion.
        #[input("X", "m", positive, kind = "Amplitude")]
        amplitude: f64,
    },
}

register!(ForcedCoulomb);

impl Analysis for ForcedCoulomb {
    const ABOUT: About = About {
        id: "vibration/forced-coulomb",
        title: "Harmonic force with dry friction",
        topic: "Harmonic excitation",
        summary: "Steady-state amplitude of a mass with friction, by equivalent viscous damping and exactly, including stops; or the force for an amplitude.",
        main: &["amplitude", "phase", "force", "stops"],
        keywords: "coulomb friction dry forced equivalent viscous damping den hartog stick slip hysteresis loop atrito \
                   seco forçada amortecimento equivalente",
        sources: &[&RAO, &DEN_HARTOG_1931, &GROVER],
        cases: include_str!("../../cases/forced_coulomb.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &ForcedCoulombGiven<W>, sheet: W) -> Result<(), Refusal> {
        let mass = mass(&given.mass, sheet);
        let stiffness = given.stiffness.stiffness_under(mass, sheet)?;
        let natural = sheet.step(
            "ωₙ",
            "rad/s",
            sdof::natural_frequency(stiffness, mass),
            ("Natural frequency: friction does not change it", RAO.at("§2.9")),
        );
        let ratio = sheet.step("r", "1", sdof::frequency_ratio(given.frequency, natural), "Frequency ratio");
        let why = ("Friction force", RAO.at("§2.9"));
        let friction = match &given.friction {
            FrictionLevelGiven::Force { force } => *force,
            FrictionLevelGiven::Coefficient { coefficient, gravity } => {
                let force = match given_weight(&given.mass, *gravity) {
                    Some(weight) => *coefficient * weight,
                    None => *coefficient * mass * *gravity,
                };
                sheet.step("F", "N", force, why)
            }
            FrictionLevelGiven::Normal { coefficient, normal } => {
                sheet.step("F", "N", *coefficient * *normal, why)
            }
        };
        let offset =
            sheet.step("f", "mm", friction / stiffness, "Deflection of the spring under the friction force");
        sheet.answer("natural_frequency", "Natural frequency", natural);
        sheet.answer("frequency_ratio", "Frequency ratio", ratio);
        sheet.answer("friction", "Friction force", friction);
        let system = Excited { mass, stiffness, frequency: given.frequency, ratio, friction, offset };
        let (force, amplitude) = match &given.excitation {
            ForceOrAmplitudeGiven::Force { force } => (force.value(), amplitude_of(&system, *force, sheet)?),
            ForceOrAmplitudeGiven::Amplitude { amplitude } => {
                (force_of(&system, *amplitude, sheet), amplitude.value())
            }
        };
        let excited = CoulombOscillator {
            ratio: ratio.value(),
            deflection: force / stiffness.value(),
            offset: offset.value(),
        };
        sheet.show(|| {
            let plot = response(&excited, natural.value(), self.frequency, amplitude);
            // Of an amplitude that is given, the force at this frequency is kept.
            let is_given = matches!(self.excitation, ForceOrAmplitude::Amplitude { .. });
            Exhibit::Plot(if is_given { plot } else { plot.over("frequency") })
        });
        sheet.show(|| Exhibit::Plot(hysteresis(friction.value(), stiffness.value(), amplitude)));
        sheet.show(|| Exhibit::Plot(history(&excited, natural.value())));
        sheet.show(|| Exhibit::Drawing(self.drawing()));
        Ok(())
    }
}

/// The oscillator with its friction.
struct Excited<N> {
    mass: N,
    stiffness: N,
    frequency: N,
    ratio: N,
    friction: N,
    /// `F/k`
    offset: N,
}

/// The amplitude under a force. The result is the exact one.
fn amplitude_of<W: Worksheet>(system: &Excited<W::Num>, force: W::Num, sheet: W) -> Result<f64, Refusal> {
    let Excited { stiffness, ratio, friction, offset, .. } = *system;
    if force.value() <= friction.value() {
        return Err(stuck());
    }
    let deflection =
        sheet.step("s", "mm", force / stiffness, "Static deflection of the spring under the force");
    let excited =
        CoulombOscillator { ratio: ratio.value(), deflection: deflection.value(), offset: offset.value() };
    let steady = excited.steady();
    if steady == CoulombResponse::Stuck {
        return Err(stuck());
    }
    if steady == CoulombResponse::Unbounded {
        return Err(Refusal::because(
            "at the natural frequency this force supplies more energy per cycle than friction dissipates, since 4F/π is below F₀: the amplitude grows with time without bound",
        ));
    }
    let by_viscous = 4.0 * friction.value() < PI * force.value() && ratio.value() != 1.0;
    let equivalent = if by_viscous {
        let detuned = || (W::Num::from(1.0) - ratio.powi(2)).abs();
        sheet.common_error("X_eq", "the friction force subtracted from the amplitude of the force", || {
            (deflection - offset) / detuned()
        });
        sheet.common_error(
            "X_eq",
            "the equivalent damping force subtracted from the force as if in phase with it",
            || (deflection - offset * 4.0 / PI) / detuned(),
        );
        let amplitude = sheet.step(
            "X_eq",
            "mm",
            forced_coulomb::equivalent_amplitude(deflection, offset, ratio),
            ("Amplitude by equivalent viscous damping", RAO.at("§3.8")),
        );
        equivalent_damping(system, amplitude, force, sheet);
        sheet.common_error("φ′", "the ratio of the forces taken as the tangent of the angle", || {
            (friction * 4.0).atan2(force * PI)
        });
        let angle = sheet.step(
            "φ′",
            "deg",
            (friction * 4.0 / (force * PI)).asin(),
            ("Damping balances the part 4F/π of the force: sine of the phase angle", RAO.at("§3.8")),
        );
        let lag = if ratio.value() < 1.0 { angle } else { W::Num::from(PI) - angle };
        let lag =
            sheet.step("φ_eq", "deg", lag, "Lag of the motion behind the force, above 90° beyond resonance");
        sheet.answer("amplitude", "Amplitude by equivalent damping", amplitude);
        sheet.answer("phase", "Phase lag by equivalent damping", lag);
        sheet.verify(|| {
            let one = W::Num::from(1.0);
            sheet.check_zero(
                "equivalent damping: spring and inertia forces are balanced by the force component in phase with the motion",
                stiffness * amplitude * (one - ratio.powi(2)) - force * lag.cos(),
                force.value(),
            );
            sheet.check_sum(
                "equivalent damping: energy input equals friction loss per cycle, πF₀X sin φ = 4FX",
                force * amplitude * lag.sin() * PI,
                friction * amplitude * 4.0,
                PI * force.value() * amplitude.value(),
            );
        });
        Some(amplitude)
    } else {
        sheet.warn(|| {
            Text::new(
                "by equivalent damping there is no steady-state motion with this force: 4F/π is not below F₀; only the exact motion, with its stops, is computed",
            )
        });
        None
    };
    let exact = match &steady {
        CoulombResponse::Sliding { lag, .. } => {
            let amplitude = sliding(deflection, offset, ratio, sheet);
            sheet.verify(|| {
                sheet.check(
                    "the work of the force in a cycle, summed over the exact motion, equals the friction work, 4FX",
                    W::Num::from(excited.sliding_work() * stiffness.value()),
                    W::Num::from(4.0 * friction.value() * amplitude.value()),
                );
            });
            let lag = sheet.numerical("φ", "deg", *lag, "Lag of its extremes behind those of the force");
            sheet.answer("exact_phase", "Phase lag, exact", lag);
            sheet.verify(|| held_by(&excited, lag.value(), sheet));
            amplitude
        }
        CoulombResponse::Stopping { amplitude, slides } => {
            let found = sheet.numerical(
                "X",
                "mm",
                *amplitude,
                "Exact amplitude: the mass stops within each half-cycle, so the motion is solved slip phase by slip phase until it becomes periodic; half the range of the motion",
            );
            sheet.verify(|| {
                let work: f64 = slides.iter().map(|slide| excited.work(slide)).sum();
                let way: f64 = slides.iter().map(|slide| (slide.end - slide.start).abs()).sum();
                // Each turning point is steady to 1e-12 of the static deflection, however short the way.
                let size = (offset.value() * way).max(1e-2 * deflection.value().powi(2));
                sheet.check_sum(
                    "the work of the force in a cycle is the friction force times the distance travelled",
                    W::Num::from(work),
                    W::Num::from(offset.value() * way),
                    size,
                );
            });
            let stops = sheet.numerical("n_s", "1", slides.len() as f64, "Stops per cycle");
            sheet.answer("stops", "Stops per cycle", stops);
            found
        }
        _ => {
            sheet.warn(|| {
                Text::new(
                    "the force is so slow relative to the natural frequency that the exact motion has too many stops to be computed: only the equivalent-damping result is given",
                )
            });
            return equivalent.map(Real::value).ok_or_else(|| {
                Refusal::because(
                    "the exact motion has too many stops to be computed, and there is no equivalent one",
                )
            });
        }
    };
    sheet.answer("exact_amplitude", "Amplitude, exact", exact);
    if let Some(equivalent) = equivalent {
        let off = sheet.step("ΔX", "%", (equivalent - exact) / exact, "Error of the equivalent damping");
        sheet.answer("difference", "Error of equivalent damping", off);
        if off.value().abs() > 0.05 {
            sheet.warn(|| {
                Text::new("the equivalent damping is in error by {off}: the friction is too large relative to the force")
                    .with_quantity("off", off.value(), "%")
            });
        }
    }
    Ok(exact.value())
}

/// Holds the lag of the motion without stops to its first harmonic, by quadrature over a half cycle: in phase, the force
/// holds spring and inertia, and a quarter of a cycle ahead, it does the work of the friction.
fn held_by<W: Worksheet>(excited: &CoulombOscillator, lag: f64, sheet: W) {
    let CoulombOscillator { ratio, deflection, offset } = *excited;
    let parts = (8.0 + 8.0 / ratio).ceil();
    if parts.is_nan() || parts > 400.0 {
        return;
    }
    let over = |of: &dyn Fn(f64) -> f64| integral(of, [0.0, 1.0], parts as u32);
    let cosine = 2.0 * over(&|part| excited.sliding_at(part) * (PI * part).cos());
    let size = deflection.max((1.0 + ratio * ratio) * cosine.abs());
    sheet.check_zero(
        "exact motion: spring and inertia forces of its first harmonic are balanced by the force component in phase with its extremes",
        W::Num::from((1.0 - ratio) * (1.0 + ratio) * cosine - deflection * lag.cos()),
        size,
    );
    let work = 2.0 * PI * over(&|part| deflection * (PI * part + lag).sin() * excited.sliding_at(part));
    let way = 4.0 * excited.sliding_at(0.0);
    sheet.check_sum(
        "exact motion: work of the force in a cycle, with that phase lag, equals the friction work",
        W::Num::from(work),
        W::Num::from(offset * way),
        2.0 * PI * deflection * excited.sliding_at(0.0),
    );
}

fn stuck() -> Refusal {
    Refusal::because("the force does not overcome the friction: the mass does not move; write a larger force")
}

/// The force for an amplitude. The result is the force by equivalent damping.
fn force_of<W: Worksheet>(system: &Excited<W::Num>, amplitude: W::Num, sheet: W) -> f64 {
    let Excited { stiffness, ratio, friction, offset, .. } = *system;
    let spring = sheet.step(
        "F_s",
        "N",
        stiffness * amplitude * (W::Num::from(1.0) - ratio.powi(2)).abs(),
        ("Part of the force that balances spring and inertia", RAO.at("§3.8")),
    );
    sheet.common_error(
        "F₀",
        "the friction added to the force of spring and inertia as if in phase",
        || spring + friction,
    );
    let force = sheet.step(
        "F₀",
        "N",
        (spring.powi(2) + (friction * 4.0 / PI).powi(2)).sqrt(),
        (
            "Force: includes the component 4F/π balanced by the equivalent damping, a quarter cycle ahead",
            RAO.at("§3.8"),
        ),
    );
    if ratio.value() != 1.0 {
        sheet.check(
            "that force reproduces the amplitude",
            forced_coulomb::equivalent_amplitude(force / stiffness, offset, ratio),
            amplitude,
        );
    }
    equivalent_damping(system, amplitude, force, sheet);
    sheet.answer("force", "Force by equivalent damping", force);
    if ratio.value() == 1.0 {
        return force.value();
    }
    // Den Hartog the other way about, where the motion has no stops.
    let damping = sheet.step(
        "U",
        "1",
        forced_coulomb::damping_function(ratio),
        ("Damping function of the exact motion without stops", DEN_HARTOG_1931.at("")),
    );
    let deflection =
        (amplitude.powi(2) + (offset * damping).powi(2)).sqrt() * (W::Num::from(1.0) - ratio.powi(2)).abs();
    let exact =
        CoulombOscillator { ratio: ratio.value(), deflection: deflection.value(), offset: offset.value() };
    if exact.sliding().is_some() {
        let exact_force = sheet.step(
            "F₀′",
            "N",
            stiffness * deflection,
            ("Exact force: X² = (F₀V/k)² − (fU)² solved for F₀", DEN_HARTOG_1931.at("")),
        );
        sheet.verify(|| {
            let exact = CoulombOscillator { deflection: exact_force.value() / stiffness.value(), ..exact };
            sheet.check(
                "the work of the force in a cycle, summed over the exact motion, equals the friction work, 4FX",
                W::Num::from(exact.sliding_work() * stiffness.value()),
                W::Num::from(4.0 * friction.value() * amplitude.value()),
            );
        });
        sheet.answer("exact_force", "Force, exact", exact_force);
    } else {
        sheet.warn(|| {
            Text::new(
                "with this amplitude the mass would stop within each half-cycle, where the exact force has no closed form: only the equivalent one is given",
            )
        });
    }
    force.value()
}

/// Coefficient and ratio of the equivalent damping, compared with the viscous oscillator.
fn equivalent_damping<W: Worksheet>(system: &Excited<W::Num>, amplitude: W::Num, force: W::Num, sheet: W) {
    let Excited { mass, stiffness, frequency, friction, .. } = *system;
    sheet.common_error("c_eq", "the friction force divided by the largest velocity", || {
        friction / (frequency * amplitude)
    });
    sheet.common_error("c_eq", "the natural frequency used in place of that of the excitation", || {
        forced_coulomb::equivalent_damping(friction, sdof::natural_frequency(stiffness, mass), amplitude)
    });
    let damping = sheet.step(
        "c_eq",
        "N*s/m",
        forced_coulomb::equivalent_damping(friction, frequency, amplitude),
        ("Viscous damping with the same energy loss per cycle, πcωX² = 4FX", RAO.at("§3.8")),
    );
    sheet.check(
        "force on a viscous oscillator with that damping",
        amplitude * sdof::dynamic_stiffness(stiffness, mass, damping, frequency),
        force,
    );
    sheet.answer("equivalent_damping", "Equivalent viscous damping", damping);
}

/// The exact amplitude without stops.
fn sliding<W: Worksheet>(deflection: W::Num, offset: W::Num, ratio: W::Num, sheet: W) -> W::Num {
    let response = sheet.step(
        "V",
        "1",
        forced_coulomb::response_function(ratio),
        ("Exact motion without stops: response function", DEN_HARTOG_1931.at("")),
    );
    let damping = sheet.step(
        "U",
        "1",
        forced_coulomb::damping_function(ratio),
        ("Damping function", DEN_HARTOG_1931.at("")),
    );
    sheet.step(
        "X",
        "mm",
        forced_coulomb::sliding_amplitude(deflection, offset, response, damping),
        ("Exact amplitude: the mass does not stop within a half-cycle", DEN_HARTOG_1931.at("")),
    )
}

/// Amplitude over frequency, equivalent and exact.
fn response(excited: &CoulombOscillator, natural: f64, frequency: f64, amplitude: f64) -> Plot {
    let last = 2.5f64.max(1.3 * excited.ratio);
    let points = || (1..=240u16).map(|n| last * f64::from(n) / 240.5);
    let equivalent = |ratio: f64| {
        let amplitude = forced_coulomb::equivalent_amplitude(excited.deflection, excited.offset, ratio);
        (ratio * natural, if amplitude > 0.0 { amplitude } else { f64::INFINITY })
    };
    let exact = |ratio: f64| {
        let found = CoulombOscillator { ratio, ..*excited }.sliding();
        (ratio * natural, found.map_or(f64::INFINITY, |(amplitude, _)| amplitude))
    };
    Plot::new(
        "Amplitude against frequency",
        Axis::linear("frequency of the force", "Hz"),
        Axis::log("amplitude", "mm"),
        vec![
            Series::line("equivalent damping", points().map(equivalent).collect()).of("amplitude"),
            Series::line("exact, without stops", points().map(exact).collect()).of("exact_amplitude"),
        ],
    )
    .mark("at this frequency", (frequency, amplitude))
}

/// The loop of spring and friction together over a cycle.
fn hysteresis(friction: f64, stiffness: f64, amplitude: f64) -> Plot {
    let corner = |x: f64, sign: f64| (x, stiffness * x + sign * friction);
    let x = amplitude;
    Plot::new(
        "Force of spring and friction over one cycle: the area of the loop is 4FX",
        Axis::linear("displacement", "mm"),
        Axis::linear("force", "N"),
        vec![Series::line(
            "spring and friction",
            vec![corner(-x, 1.0), corner(x, 1.0), corner(x, -1.0), corner(-x, -1.0), corner(-x, 1.0)],
        )],
    )
}

/// One cycle of the steady exact motion beside the deflection that the force alone would give.
fn history(excited: &CoulombOscillator, natural: f64) -> Plot {
    let cycle = TAU / excited.ratio;
    let force = |tau: f64| excited.deflection * (excited.ratio * tau).cos();
    let mut motion = Vec::new();
    match excited.steady() {
        CoulombResponse::Sliding { lag, .. } => {
            for n in 0..=300u16 {
                let part = f64::from(n) / 150.0;
                // The motion at its extreme at part 0; the force had its own before.
                let x = if part <= 1.0 { excited.sliding_at(part) } else { -excited.sliding_at(part - 1.0) };
                motion.push(((part / 2.0 * cycle + lag / excited.ratio) / natural, x));
            }
        }
        CoulombResponse::Stopping { slides, .. } => {
            let begun = slides.first().map_or(0.0, |slide| slide.from);
            for slide in &slides {
                for n in 0..=60u16 {
                    let tau = slide.from + (slide.until - slide.from) * f64::from(n) / 60.0;
                    motion.push(((tau - begun) / natural, excited.sliding_from(slide, tau)[0]));
                }
            }
            if let (Some(last), Some(slide)) = (motion.last().copied(), slides.first()) {
                motion.push((cycle / natural, last.1));
                let shift = |tau: f64| force(tau + slide.from);
                let push = (0..=200u16).map(|n| cycle * f64::from(n) / 200.0);
                return cycle_plot(motion, push.map(|tau| (tau / natural, shift(tau))).collect());
            }
        }
        _ => {}
    }
    let first = motion.first().map_or(0.0, |point| point.0);
    let push = (0..=200u16).map(|n| first * natural + cycle * f64::from(n) / 200.0);
    cycle_plot(motion, push.map(|tau| (tau / natural, force(tau))).collect())
}

fn cycle_plot(motion: Vec<(f64, f64)>, push: Vec<(f64, f64)>) -> Plot {
    Plot::new(
        "One cycle of the exact motion",
        Axis::linear("time", "s"),
        Axis::linear("displacement", "mm"),
        vec![Series::line("x", motion), Series::line("force over stiffness", push)],
    )
}

impl ForcedCoulomb {
    fn drawing(&self) -> Drawing {
        let mut sketch = Sketch::new("The mass on its spring, with friction");
        sketch
            .ground((-2.4, 1.2), (-2.4, -0.7))
            .ground((-2.4, -0.7), (2.4, -0.7))
            .spring(self.stiffness.letters(), (-2.4, 0.0), (-0.7, 0.0))
            .mass(self.mass.letter(), (-0.7, -0.7), (0.7, 0.7))
            .force(
                if let FrictionLevel::Force { .. } = self.friction { "F" } else { "µN" },
                (1.6, -0.55),
                (0.75, -0.55),
            )
            .force("F₀ cos(ω t)", (0.7, 0.2), (1.8, 0.2));
        if let FrictionLevel::Normal { .. } = self.friction {
            sketch.force("N", (0.3, 1.5), (0.3, 0.75));
        }
        let motion = if let ForceOrAmplitude::Amplitude { .. } = self.excitation { "x, X" } else { "x" };
        sketch.motion(motion, (-0.6, 1.0), (0.1, 1.0)).finish()
    }
}
