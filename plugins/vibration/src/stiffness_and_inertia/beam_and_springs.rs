//! A mass on a network of beams and springs, found from its free motion, then excited.

use dalembert_core::{
    About, Analysis, Axis, Drawing, Exhibit, Inputs, Plot, Refusal, Series, Sketch, Worksheet, register,
};
use dalembert_mechanics::{Real, sdof};

use crate::{
    shared::{
        decay::{Decay, FreeDecay, decrement},
        spring::{
            Spring, network,
            shares::{Loaded, shares},
            sketch,
        },
    },
    sources::{LISTS, RAO},
};

/// The springs, the free motion of the mass on them, and what shakes it.
#[derive(Clone, Debug, Inputs)]
pub struct BeamAndSprings {
    /// Springs.
    /// A network: series and parallel groups may be nested.
    pub springs: Spring,
    /// Frequency of the free vibration.
    /// The frequency of the decaying motion as counted, below the natural frequency if there is damping.
    #[input("ω_d", "rad/s", positive)]
    pub damped_frequency: f64,
    /// Decay of the free vibration.
    pub decay: Decay,
    /// Excitation.
    /// A harmonic force on the mass.
    pub excitation: Option<Excitation>,
}

/// A harmonic force on the mass.
#[derive(Clone, Debug, Inputs)]
pub struct Excitation {
    /// Frequency of the force.
    #[input("ω", "rad/s", positive)]
    pub frequency: f64,
    /// Amplitude of the force.
    /// The transmissibility is independent of it.
    #[input("F₀", "N", positive)]
    pub force: Option<f64>,
}

register!(BeamAndSprings);

impl Analysis for BeamAndSprings {
    const ABOUT: About = About {
        id: "vibration/beam-and-springs",
        title: "Mass on beams and springs",
        topic: "Stiffness and inertia",
        summary: "Mass, damping and transmitted force of a mass on a network of beams and springs, from its free decay.",
        main: &["mass", "stiffness", "damping", "natural_frequency", "amplitude"],
        keywords: "series parallel equivalent stiffness decrement transmissibility viga molas rigidez equivalente \
                   decremento transmissibilidade massa 08/4",
        sources: &[&RAO, &LISTS],
        cases: include_str!("../../cases/beam_and_springs.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &BeamAndSpringsGiven<W>, sheet: W) -> Result<(), Refusal> {
        let springs = network(&given.springs, sheet, &[])?;
        let k = springs.stiffness;
        let FreeDecay { cycles, decrement, damping_ratio: zeta } = decrement(&given.decay, sheet);
        let what = "the frequency of the decaying motion taken as the natural frequency";
        sheet.common_error("ωₙ", what, || given.damped_frequency);
        let natural = sheet.step(
            "ωₙ",
            "rad/s",
            sdof::natural_frequency_from_damped(given.damped_frequency, zeta),
            ("The damped frequency is below the natural frequency", RAO.at("§2.6")),
        );
        if let Some(excitation) = &given.excitation {
            let of_force = || sdof::mass_from_natural_frequency(k, excitation.frequency);
            sheet.common_error("m", "the frequency of the force used as the natural frequency", of_force);
        }
        let mass = sheet.step(
            "m",
            "kg",
            sdof::mass_from_natural_frequency(k, natural),
            ("Mass that has this natural frequency on the springs", RAO.at("§2.2")),
        );
        let of_decrement = || sdof::damping_from_ratio(decrement, k, mass);
        sheet.common_error("c", "the decrement used in place of the damping ratio", of_decrement);
        let c = sheet.step(
            "c",
            "N*s/m",
            sdof::damping_from_ratio(zeta, k, mass),
            ("Damping coefficient", RAO.at("§2.6")),
        );
        sheet.check(
            "stiffness, mass and damping reproduce the frequency of the free vibration",
            (k / mass - (c / (mass * 2.0)).powi(2)).sqrt(),
            given.damped_frequency,
        );
        sheet.check(
            "the exponential decay reproduces the amplitude ratio",
            (c / (mass * 2.0) * (cycles * std::f64::consts::TAU / given.damped_frequency)).exp(),
            given.decay.amplitude_ratio,
        );
        sheet.answer("stiffness", "Equivalent stiffness", k);
        sheet.answer("decrement", "Logarithmic decrement", decrement);
        sheet.answer("damping_ratio", "Damping ratio", zeta);
        sheet.answer("natural_frequency", "Natural frequency", natural);
        sheet.answer("mass", "Mass", mass);
        sheet.answer("damping", "Damping coefficient", c);

        let system = Oscillator { k, mass, c, natural, zeta };
        let amplitude = match &given.excitation {
            Some(excitation) => excite(excitation, &system, sheet)?,
            None => None,
        };
        shares(&springs, sheet, amplitude.map(Loaded::Vibrating));
        sheet.show(|| Exhibit::Drawing(self.drawing()));
        if let Some(excitation) = &self.excitation {
            let (natural, zeta) = (natural.value(), zeta.value());
            sheet
                .show(|| Exhibit::Plot(transmissibility_over_frequency(excitation.frequency, natural, zeta)));
        }
        let decay = (mass.value(), c.value());
        sheet.show(|| Exhibit::Plot(self.free_motion(decay, cycles.value())));
        Ok(())
    }
}

/// The mass on its springs, as found from the free motion.
struct Oscillator<N> {
    k: N,
    mass: N,
    c: N,
    natural: N,
    zeta: N,
}

/// The response to the excitation; the amplitude, m, where the force is known.
fn excite<W: Worksheet>(
    given: &ExcitationGiven<W>,
    system: &Oscillator<W::Num>,
    sheet: W,
) -> Result<Option<f64>, Refusal> {
    let Oscillator { k, mass, c, natural, zeta } = *system;
    let frequency = given.frequency;
    let ratio = sheet.step("r", "1", sdof::frequency_ratio(frequency, natural), "Frequency ratio");
    if zeta.value() == 0.0 && ratio.value() == 1.0 {
        return Err(Refusal::because(
            "without damping, a force at the natural frequency makes the motion grow without bound: there is no \
             steady state",
        ));
    }
    let magnification = || sdof::magnification(ratio, zeta);
    sheet.common_error("TR", "the magnification taken for the transmissibility", magnification);
    let undamped = || W::Num::from(1.0) / (W::Num::from(1.0) - ratio.powi(2)).abs();
    sheet.common_error("TR", "the damping neglected", undamped);
    let transmissibility = sheet.step(
        "TR",
        "1",
        sdof::transmissibility(ratio, zeta),
        ("Transmissibility: force on the support over force on the mass", RAO.at("§3.6")),
    );
    sheet.check(
        "transmissibility from the dynamic stiffness",
        (k.powi(2) + (c * frequency).powi(2)).sqrt() / sdof::dynamic_stiffness(k, mass, c, frequency),
        transmissibility,
    );
    sheet.answer("frequency_ratio", "Frequency ratio", ratio);
    sheet.answer("transmissibility", "Transmissibility", transmissibility);
    let Some(force) = given.force else { return Ok(None) };
    sheet.common_error("X", "the static deflection under the force taken", || force / k);
    let undamped = || force / (k - mass * frequency.powi(2)).abs();
    sheet.common_error("X", "the damping neglected", undamped);
    let amplitude = sheet.step(
        "X",
        "mm",
        sdof::forced_amplitude(force, k, mass, c, frequency),
        ("Steady-state amplitude under the force", RAO.at("§3.4")),
    );
    sheet.check(
        "amplitude from the magnification of the static deflection",
        force / k * sdof::magnification(ratio, zeta),
        amplitude,
    );
    let phase = sheet.step(
        "φ",
        "deg",
        sdof::phase_lag_from_ratios(ratio, zeta),
        ("The motion lags the force by", RAO.at("§3.4")),
    );
    sheet.common_error("F_T", "the force of the springs alone taken", || amplitude * k);
    let added = || amplitude * (k + c * frequency);
    sheet.common_error("F_T", "the forces of spring and damper added as if in phase", added);
    let transmitted = sheet.step(
        "F_T",
        "N",
        transmissibility * force,
        ("Amplitude of the force transmitted to the support", RAO.at("§3.6")),
    );
    sheet.check(
        "force on the support from the forces of springs and damper",
        sdof::transmitted_force(amplitude, k, c, frequency),
        transmitted,
    );
    sheet.answer("amplitude", "Steady-state amplitude", amplitude);
    sheet.check("phase lag from stiffness, mass and damping", sdof::phase_lag(k, mass, c, frequency), phase);
    sheet.answer("phase", "Phase lag", phase);
    sheet.answer("transmitted_force", "Force transmitted to the support", transmitted);
    Ok(Some(amplitude.value()))
}

impl BeamAndSprings {
    /// The network under its support, with the mass at its lower end.
    fn drawing(&self) -> Drawing {
        let (width, height) = sketch::size(&self.springs);
        let half = (width / 2.0).max(0.9);
        let mut sketch = Sketch::new("The mass on its springs");
        if !sketch::stands_alone(&self.springs) {
            sketch.ground((half, 0.0), (-half, 0.0));
        }
        sketch::hanging(&self.springs, (0.0, 0.0), height, &[], &mut sketch);
        let top = -height;
        if self.decay.amplitude_ratio > 1.0 {
            let x = -half - 0.5;
            sketch
                .ground((-half, 0.0), (-half - 1.0, 0.0))
                .damper("c", (x, 0.0), (x, top))
                .bars([(x, top), (0.0, top)]);
        }
        sketch.mass("m", (-0.7, top - 0.9), (0.7, top)).motion("x, ω_d", (1.2, top - 0.1), (1.2, top - 0.8));
        if self.excitation.is_some() {
            sketch.force("F₀ cos(ω t)", (0.0, top - 0.9), (0.0, top - 1.7));
        }
        sketch.finish()
    }

    /// The free decay, from an amplitude of one to the last one counted.
    fn free_motion(&self, (mass, c): (f64, f64), cycles: f64) -> Plot {
        let period = std::f64::consts::TAU / self.damped_frequency;
        let shown = cycles.clamp(2.0, 20.0);
        let envelope = |t: f64| (-c / (2.0 * mass) * t).exp();
        let at = |n: u16| {
            let t = shown * period * f64::from(n) / 600.0;
            (t, envelope(t) * (self.damped_frequency * t).cos())
        };
        let peaks = (0u16..=20).map(f64::from).take_while(|n| *n <= shown);
        Plot::new(
            "Free vibration from an initial amplitude of one",
            Axis::linear("time", "s"),
            Axis::linear("displacement over the first amplitude", "1"),
            vec![
                Series::line("x/x₁", (0..=600).map(at).collect()),
                Series::dots(
                    "successive amplitudes",
                    peaks.map(|n| (n * period, envelope(n * period))).collect(),
                ),
            ],
        )
    }
}

fn transmissibility_over_frequency(frequency: f64, natural: f64, zeta: f64) -> Plot {
    let last = 2.5 * natural.max(0.6 * frequency);
    let at = |n: u16| {
        let frequency = last * f64::from(n) / 400.0;
        (frequency, sdof::transmissibility(frequency / natural, zeta))
    };
    Plot::new(
        "Transmissibility against frequency",
        Axis::linear("frequency of the force", "rad/s"),
        Axis::log("transmissibility", "1"),
        vec![Series::line("TR", (0..=400).map(at).collect()).of("transmissibility")],
    )
    .over("excitation.frequency")
    .mark("at this frequency", (frequency, sdof::transmissibility(frequency / natural, zeta)))
    .level("applied force (TR = 1)", 1.0)
}
