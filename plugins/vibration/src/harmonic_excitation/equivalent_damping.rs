//! Damping that is not viscous, as the viscous damping that takes the same energy in a cycle.

use std::f64::consts::{PI, TAU};

use dalembert_core::{
    About, Analysis, Axis, Drawing, Exhibit, Inputs, Plot, Refusal, Series, Sketch, Worksheet, register,
};
use dalembert_mechanics::{Real, sdof};

use crate::{
    shared::oscillator::{Mass, mass},
    sources::{RAO, THOMSON},
};

/// An oscillator under a harmonic force, and what its damping is known by.
#[derive(Clone, Debug, Inputs)]
pub struct EquivalentDamping {
    /// Mass or weight.
    pub mass: Mass,
    /// Stiffness.
    #[input("k", "N/m", positive)]
    pub stiffness: f64,
    /// Damping.
    pub damping: DampingLaw,
    /// Amplitude of the force.
    #[input("F₀", "N", positive)]
    pub force: f64,
    /// Frequency of the force.
    #[input("ω", "rad/s", positive)]
    pub frequency: f64,
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
}

register!(EquivalentDamping);

impl Analysis for EquivalentDamping {
    const ABOUT: About = About {
        id: "vibration/equivalent-damping",
        title: "Hysteretic and other equivalent damping",
        topic: "Harmonic excitation",
        summary: "Equivalent viscous damping, loss factor and steady-state amplitude of an oscillator whose damping is given by its hysteresis loop.",
        keywords: "structural damping hysteresis loop area loss factor specific damping capacity quadratic drag \
                   amortecimento histerético estrutural fator de perda laço de histerese arrasto quadrático",
        sources: &[&RAO, &THOMSON],
        cases: include_str!("../../cases/equivalent_damping.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &EquivalentDampingGiven<W>, sheet: W) -> Result<(), Refusal> {
        let (stiffness, frequency, force) = (given.stiffness, given.frequency, given.force);
        let mass = mass(&given.mass, sheet);
        let natural = sheet.step(
            "ωₙ",
            "rad/s",
            sdof::natural_frequency(stiffness, mass),
            ("Natural frequency without damping", RAO.at("§2.2")),
        );
        let why =
            ("Steady-state amplitude: spring and inertia on one side, damping on the other", RAO.at("§3.9"));
        let (loss, amplitude, damping) = match &given.damping {
            DampingLawGiven::QuadraticDrag { drag } => {
                let elastic = sheet.step(
                    "K",
                    "N/m",
                    (stiffness - mass * frequency.powi(2)).abs(),
                    "Force of spring and inertia per metre of amplitude",
                );
                let first = sheet.step(
                    "A",
                    "N/m^2",
                    *drag * frequency.powi(2) * 8.0 / (3.0 * PI),
                    ("The drag a v|v| is equivalent to a viscous damping 8aωX/(3π), which dissipates the same energy per cycle", RAO.at("§3.10")),
                );
                // X² is the positive root of A²X⁴ + K²X² = F₀², without cancellation.
                let square = force.powi(2) * 2.0
                    / (elastic.powi(2) + (elastic.powi(4) + (first * force).powi(2) * 4.0).sqrt());
                let amplitude = sheet.step(
                    "X",
                    "mm",
                    square.sqrt(),
                    "Steady-state amplitude: (K X)² + (A X²)² = F₀², a quadratic equation in X²",
                );
                let damping = sheet.step(
                    "c_eq",
                    "N*s/m",
                    *drag * frequency * amplitude * 8.0 / (3.0 * PI),
                    "Equivalent viscous damping, 8aωX/(3π)",
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
                    DampingLawGiven::LoopArea { energy, amplitude } => sheet.step(
                        "η",
                        "1",
                        *energy / (stiffness * amplitude.powi(2) * PI),
                        ("Loss factor: the area of the loop is πηkX²", RAO.at("§2.10")),
                    ),
                    DampingLawGiven::StiffnessMultiplier { multiplier } => sheet.step(
                        "η",
                        "1",
                        frequency * *multiplier,
                        "Loss factor at this frequency: the damping force βωkX over the elastic one",
                    ),
                    DampingLawGiven::QuadraticDrag { .. } => unreachable!("done above"),
                };
                if loss.value() == 0.0 && stiffness.value() == mass.value() * frequency.value().powi(2) {
                    return Err(Refusal::because(
                        "without damping, the amplitude at the natural frequency grows without bound: there is no steady \
                         state",
                    ));
                }
                let amplitude = force
                    / ((stiffness - mass * frequency.powi(2)).powi(2) + (loss * stiffness).powi(2)).sqrt();
                let amplitude = sheet.step("X", "mm", amplitude, why);
                let damping = sheet.step(
                    "c_eq",
                    "N*s/m",
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
        let phase = sheet.step(
            "φ",
            "deg",
            (loss * stiffness).atan2(stiffness - mass * frequency.powi(2)),
            ("The motion lags the force by", RAO.at("§3.9")),
        );
        let energy = sheet.step(
            "W",
            "J",
            loss * stiffness * amplitude.powi(2) * PI,
            ("Energy lost per cycle: the area of the loop", RAO.at("§2.10")),
        );
        sheet.check(
            "the force supplies the same energy, πF₀X sin φ",
            force * amplitude * phase.sin() * PI,
            energy,
        );
        self.summed_loop(amplitude.value(), energy, sheet);
        let capacity = sheet.step(
            "ψ",
            "%",
            loss * 2.0 * PI,
            (
                "Specific damping capacity: that energy over the largest elastic energy kX²/2",
                RAO.at("§2.6.4"),
            ),
        );
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
        sheet.answer("natural_frequency", "Natural frequency", natural);
        sheet.answer("loss_factor", "Loss factor", loss);
        sheet.answer("amplitude", "Amplitude at this frequency", amplitude);
        sheet.answer("phase", "Phase lag", phase);
        sheet.answer("equivalent_damping", "Equivalent viscous damping", damping);
        sheet.answer("equivalent_ratio", "Equivalent damping ratio", ratio);
        sheet.answer("energy", "Energy lost per cycle", energy);
        sheet.answer("damping_capacity", "Specific damping capacity", capacity);
        if let DampingLawGiven::LossFactor { .. } | DampingLawGiven::LoopArea { .. } = &given.damping
            && loss.value() > 0.0
        {
            let largest = sheet.step(
                "Xₘₐₓ",
                "mm",
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
            mass: mass.value(),
            stiffness: self.stiffness,
            force: self.force,
            loss: loss.value(),
            natural: natural.value(),
        };
        let amplitude = amplitude.value();
        sheet.show(|| Exhibit::Plot(self.hysteresis(amplitude, loss.value())));
        sheet.show(|| Exhibit::Plot(self.response(&numbers, amplitude)));
        sheet.show(|| Exhibit::Drawing(drawing()));
        Ok(())
    }
}

/// Parameters of the plotted response.
struct Numbers {
    mass: f64,
    stiffness: f64,
    force: f64,
    loss: f64,
    natural: f64,
}

impl EquivalentDamping {
    /// The damping force at a phase of the cycle `x = X sin ψ`.
    fn damping_force(&self, amplitude: f64, loss: f64, phase: f64) -> f64 {
        match self.damping {
            DampingLaw::QuadraticDrag { drag } => {
                let velocity = self.frequency * amplitude * phase.cos();
                drag * velocity * velocity.abs()
            }
            _ => loss * self.stiffness * amplitude * phase.cos(),
        }
    }

    /// Holds the energy to the area of the loop, summed.
    fn summed_loop<W: Worksheet>(&self, amplitude: f64, energy: W::Num, sheet: W) {
        let (stiffness, loss) = (self.stiffness, energy.value() / (PI * self.stiffness * amplitude.powi(2)));
        sheet.verify(|| {
            // Half a turn forward, by Simpson's rule; the other half takes as much.
            let panels = 1000u32;
            let at = |n: u32| {
                let phase = -PI / 2.0 + PI * f64::from(n) / f64::from(panels);
                let force = stiffness * amplitude * phase.sin() + self.damping_force(amplitude, loss, phase);
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
    fn hysteresis(&self, amplitude: f64, loss: f64) -> Plot {
        let at = |n: u16| {
            let phase = TAU * f64::from(n) / 240.0;
            let x = amplitude * phase.sin();
            (x, self.stiffness * x + self.damping_force(amplitude, loss, phase))
        };
        Plot::new(
            "Force–displacement loop over one cycle",
            Axis::linear("displacement", "mm"),
            Axis::linear("force", "N"),
            vec![
                Series::line("spring and damping", (0..=240).map(at).collect()),
                Series::line(
                    "spring alone",
                    vec![(-amplitude, -self.stiffness * amplitude), (amplitude, self.stiffness * amplitude)],
                ),
            ],
        )
    }

    /// Amplitude over frequency, beside the viscous damping with the same loss at resonance.
    fn response(&self, numbers: &Numbers, amplitude: f64) -> Plot {
        let Numbers { mass, stiffness, force, loss, natural } = *numbers;
        let last = (2.0 * natural).max(1.2 * self.frequency);
        let points = || (1..=300u16).map(|n| last * f64::from(n) / 300.0);
        let here = |w: f64| {
            let elastic = (stiffness - mass * w * w).abs();
            let amplitude = match self.damping {
                DampingLaw::QuadraticDrag { drag } => {
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
            Axis::linear("frequency of the force", "Hz"),
            Axis::log("amplitude", "mm"),
            vec![
                Series::line("this damping", points().map(here).collect()).of("amplitude"),
                Series::line("viscous, with the same loss here", points().map(viscous).collect()),
            ],
        )
        .over("frequency")
        .mark("at this frequency", (self.frequency, amplitude))
    }
}

fn drawing() -> Drawing {
    Sketch::new("One degree of freedom")
        .ground((-1.0, -1.5), (1.0, -1.5))
        .spring("k(1 + iη)", (0.0, -1.5), (0.0, -0.4))
        .mass("m", (-0.8, -0.4), (0.8, 0.4))
        .force("F₀ cos ωt", (0.0, 0.4), (0.0, 1.2))
        .motion("x", (1.1, -0.2), (1.1, 0.5))
        .finish()
}
