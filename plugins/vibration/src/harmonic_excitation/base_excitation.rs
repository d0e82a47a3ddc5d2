//! A mass on a shaking base: absolute and relative motion, the wavy road, and the motion from rest.

use std::f64::consts::PI;

use dalembert_core::{
    About, Analysis, Axis, Drawing, Exhibit, Ink, Inputs, Plot, Refusal, Series, Text, Worksheet, register,
};
use dalembert_mechanics::{Real, sdof, vibration::isolation};

use crate::{
    shared::oscillator::{
        AtFrequency, Damping, Elasticity, Loss, Mass, Suspension, mass,
        motion::OscillatorMotion,
        plots, suspension,
        transient_from_rest::{BuildUp, Wave},
    },
    sources::{RAO, THOMSON},
};

/// The oscillator and the base that shakes it.
#[derive(Clone, Debug, Inputs)]
pub struct BaseExcitation {
    /// Inertia.
    /// May be omitted if the natural frequency or the static deflection is known; the forces are then not computed.
    pub mass: Option<Mass>,
    /// Springs.
    pub elasticity: Elasticity,
    /// Damping.
    pub damping: Damping,
    /// Base.
    pub base: Base,
    /// Start from rest.
    /// The base motion starts as a sine; the mass is at rest until then.
    pub start: Option<FromRest>,
}

/// Motion of the base.
#[derive(Clone, Debug, Inputs)]
pub enum Base {
    /// Displacement given
    Displacement {
        /// Amplitude of the base.
        #[input("Y", "m", positive, kind = "Amplitude")]
        amplitude: f64,
        /// Frequency of the base.
        #[input("ω", "rad/s", positive)]
        frequency: f64,
    },
    /// Acceleration given
    Acceleration {
        /// Base acceleration.
        /// Its amplitude, zero to peak.
        #[input("A_b", "m/s^2", positive)]
        acceleration: f64,
        /// Frequency of the base.
        #[input("ω", "rad/s", positive)]
        frequency: f64,
    },
    /// Vehicle on a wavy road
    Road {
        /// Amplitude of the road.
        /// Half the height from trough to crest.
        #[input("Y", "m", positive, kind = "Amplitude")]
        amplitude: f64,
        /// Wavelength.
        /// From crest to crest.
        #[input("λ", "m", positive)]
        wavelength: f64,
        /// Speed of the vehicle.
        #[input("v", "km/h", positive)]
        speed: f64,
    },
}

/// The time at which the motion from rest is asked for.
#[derive(Clone, Debug, Inputs)]
pub struct FromRest {
    /// Time.
    /// From the start of the base motion.
    #[input("t", "s", nonnegative)]
    pub time: f64,
}

register!(BaseExcitation);

impl Analysis for BaseExcitation {
    const ABOUT: About = About {
        id: "vibration/base-excitation",
        title: "Base excitation",
        topic: "Harmonic excitation",
        summary: "Absolute and relative motion, acceleration and force of a mass under harmonic base excitation, including a wavy road.",
        keywords: "support motion transmissibility quarter car vehicle road ground seismic excitação de base movimento do suporte \
                   transmissibilidade veículo estrada velocidade crítica",
        sources: &[&RAO, &THOMSON],
        cases: include_str!("../../cases/base_excitation.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &BaseExcitationGiven<W>, sheet: W) -> Result<(), Refusal> {
        let mass = given.mass.as_ref().map(|given| mass(given, sheet));
        let suspension = suspension(mass, &given.elasticity, &given.damping, sheet)?;
        suspension.answer(sheet);
        let (base, frequency) = base(&given.base, sheet);
        sheet.answer("frequency", "Frequency of the base", frequency);
        let at = suspension.at(frequency, sheet);
        sheet.answer("frequency_ratio", "Frequency ratio", at.ratio);
        if let BaseGiven::Road { wavelength, .. } = &given.base {
            critical_speed(&suspension, *wavelength, sheet);
        }
        let steady = if suspension.is_undamped() && at.is_resonance() {
            let growth = sheet.step(
                "Ẋ",
                "mm/s",
                base * suspension.natural / 2.0,
                ("The amplitude is unbounded: it grows with t, per second by", RAO.at("§3.3")),
            );
            sheet.check("growth rate of the amplitude at the base frequency", base * frequency / 2.0, growth);
            sheet.answer("growth", "Growth of the amplitude with time", growth);
            sheet.warn(|| {
                Text::new(
                    "undamped resonance: the amplitude is unbounded, it grows with t and there is no steady state",
                )
            });
            None
        } else {
            Some(steady_motion(&suspension, at, base, frequency, sheet))
        };
        if let Some(start) = &given.start {
            let build_up = BuildUp {
                motion: OscillatorMotion::Translation,
                deflection: base,
                frequency,
                natural: suspension.natural,
                at,
                steady,
                wave: Wave::Sine,
                through_dashpot: true,
            };
            let x = build_up.displacement(start.time, sheet);
            sheet.answer("displacement", "Displacement of the mass at that time", x);
            build_up.show(start.time.value(), "Motion of the mass from rest", x.value(), sheet);
        }
        let own = own_damping(&suspension);
        let ratio = at.ratio.value();
        let (frequency, amplitude) = match self.base {
            Base::Displacement { .. } => ("base.displacement.frequency", "base.displacement.amplitude"),
            Base::Acceleration { .. } => ("base.acceleration.frequency", ""),
            Base::Road { .. } => ("base.road.speed", "base.road.amplitude"),
        };
        sheet.show(|| {
            let plot = plots::transmissibility_family(ratio, own);
            Exhibit::Plot(plots::answered(plot, frequency, "transmissibility"))
        });
        sheet.show(|| {
            let relative = |r: f64, zeta: f64| plots::below(sdof::unbalance_magnification(r, zeta), 20.0);
            let here = (ratio, sdof::unbalance_magnification(ratio, own(ratio)));
            let mut plot = plots::family(
                "Relative motion against frequency ratio",
                Axis::linear("relative motion over motion of the base", "1"),
                here,
                |r| if r > 0.0 { relative(r, own(r)) } else { 0.0 },
                relative,
            );
            // Of a base that moves by one.
            plot = plots::answered(plot, frequency, "relative_amplitude");
            plot.series = plot.series.into_iter().map(|series| series.with(amplitude, 1.0)).collect();
            Exhibit::Plot(plot)
        });
        if let Base::Road { wavelength, .. } = self.base {
            sheet.show(|| {
                let natural = suspension.natural.value();
                Exhibit::Plot(self.over_speed(natural * wavelength / (2.0 * PI), base.value(), own))
            });
        }
        sheet.show(|| Exhibit::Drawing(drawing()));
        Ok(())
    }
}

/// Amplitude and frequency of the base.
fn base<W: Worksheet>(given: &BaseGiven<W>, sheet: W) -> (W::Num, W::Num) {
    match given {
        BaseGiven::Displacement { amplitude, frequency } => (*amplitude, *frequency),
        BaseGiven::Acceleration { acceleration, frequency } => {
            let why = "Amplitude of the base with this acceleration";
            (sheet.step("Y", "mm", *acceleration / frequency.powi(2), why), *frequency)
        }
        BaseGiven::Road { amplitude, wavelength, speed } => {
            let why = ("Frequency: one road wave per wavelength travelled", RAO.at("§3.6"));
            (*amplitude, sheet.step("ω", "rad/s", *speed * 2.0 * PI / *wavelength, why))
        }
    }
}

/// The speeds at which the road meets the natural frequency and the largest transmissibility.
fn critical_speed<W: Worksheet>(suspension: &Suspension<W::Num>, wavelength: W::Num, sheet: W) {
    let critical = sheet.step(
        "v_c",
        "km/h",
        suspension.natural * wavelength / (W::Num::from(2.0) * PI),
        ("Critical speed: the road waves excite at the natural frequency", RAO.at("§3.6")),
    );
    sheet.answer("critical_speed", "Critical speed", critical);
    sheet.check(
        "at the critical speed the time from wave to wave is the natural period",
        wavelength / critical,
        W::Num::from(2.0) * PI / suspension.natural,
    );
    if let Loss::Viscous(zeta, _) = suspension.loss
        && zeta.value() > 0.0
    {
        let peak = sheet.step(
            "rₚ",
            "1",
            isolation::transmissibility_peak_ratio(zeta),
            ("Frequency ratio at maximum transmissibility", RAO.at("§3.6")),
        );
        let worst = sheet.step("vₚ", "km/h", peak * critical, "Peak-response speed");
        let largest = sheet.step("TRₚ", "1", sdof::transmissibility(peak, zeta), "Maximum transmissibility");
        sheet.check_zero(
            "at its peak the transmissibility is 1/√(1 − r⁴)",
            W::Num::from(1.0) / largest.powi(2) - (W::Num::from(1.0) - peak.powi(4)),
            1.0,
        );
        sheet.verify(|| {
            let square = (worst * 2.0 * PI / (wavelength * suspension.natural)).powi(2);
            sheet.check_zero(
                "at this speed the slope of the transmissibility is zero, 2ζ²r⁴ + r² = 1",
                (zeta * square).powi(2) * 2.0 + square - 1.0,
                1.0,
            );
        });
        sheet.answer("worst_speed", "Peak-response speed", worst);
        sheet.answer("largest_transmissibility", "Maximum transmissibility at any speed", largest);
    }
}

/// Absolute and relative motion; amplitude and lag of the absolute one.
fn steady_motion<W: Worksheet>(
    suspension: &Suspension<W::Num>,
    at: AtFrequency<W::Num>,
    base: W::Num,
    frequency: W::Num,
    sheet: W,
) -> (W::Num, W::Num) {
    let AtFrequency { ratio, damping_ratio, damping } = at;
    let transmissibility = sheet.step(
        "TR",
        "1",
        sdof::transmissibility(ratio, damping_ratio),
        ("Transmissibility: motion of the mass over motion of the base", RAO.at("§3.6")),
    );
    let amplitude = sheet.step("X", "mm", base * transmissibility, "Amplitude of the mass");
    let lag = sheet.step(
        "ψ",
        "deg",
        sdof::transmissibility_phase(ratio, damping_ratio),
        ("The mass lags the base by", RAO.at("§3.6")),
    );
    let relative = sheet.step(
        "Z",
        "mm",
        base * sdof::unbalance_magnification(ratio, damping_ratio),
        ("Amplitude of the motion relative to the base: travel of the springs", RAO.at("§3.6")),
    );
    let relative_lag = sheet.step(
        "φ",
        "deg",
        sdof::phase_lag_from_ratios(ratio, damping_ratio),
        ("The relative motion lags the base by", RAO.at("§3.6")),
    );
    let acceleration = sheet.step("A", "m/s^2", amplitude * frequency.powi(2), "Acceleration of the mass");
    sheet.verify(|| {
        let scale = amplitude.value() + base.value() + relative.value();
        sheet.check_zero(
            "motion of the mass = motion of the base and relative motion, in phase with the base",
            amplitude * lag.cos() - base - relative * relative_lag.cos(),
            scale,
        );
        sheet.check_zero(
            "the same in quadrature (90° behind)",
            amplitude * lag.sin() - relative * relative_lag.sin(),
            scale,
        );
    });
    sheet.answer("base_amplitude", "Amplitude of the base", base);
    sheet.answer("transmissibility", "Transmissibility", transmissibility);
    sheet.answer("amplitude", "Amplitude of the mass", amplitude);
    sheet.answer("phase", "Phase lag of the mass", lag);
    sheet.answer("relative_amplitude", "Amplitude of the relative motion", relative);
    sheet.answer("relative_phase", "Phase lag of the relative motion", relative_lag);
    sheet.answer("acceleration", "Acceleration of the mass", acceleration);
    if let (Some(body), Some(c)) = (suspension.body, damping) {
        let why = ("Amplitude of the force in spring and damper: it accelerates the mass", RAO.at("§3.6"));
        let force = sheet.step("F", "N", body.mass * acceleration, why);
        sheet.check(
            "force from the relative motion",
            sdof::transmitted_force(relative, body.stiffness, c, frequency),
            force,
        );
        sheet.answer("force", "Force on the mass", force);
    }
    (amplitude, lag)
}

fn own_damping<N: Real>(suspension: &Suspension<N>) -> impl Fn(f64) -> f64 + Copy + use<N> {
    let (zeta, eta) = match suspension.loss {
        Loss::Viscous(zeta, _) => (zeta.value(), 0.0),
        Loss::Hysteretic(eta) => (0.0, eta.value()),
    };
    move |r| zeta + 0.5 * eta / r
}

impl BaseExcitation {
    fn over_speed(&self, critical: f64, base: f64, own: impl Fn(f64) -> f64) -> Plot {
        let speed = match self.base {
            Base::Road { speed, .. } => speed,
            _ => critical,
        };
        let last = 2.5 * critical.max(0.6 * speed);
        let at = |v: f64| {
            let r = v / critical;
            base * plots::below(sdof::transmissibility(r, if r > 0.0 { own(r) } else { 0.0 }), 50.0)
        };
        let curve = (0..=300u16).map(|n| last * f64::from(n) / 300.0).map(|v| (v, at(v))).collect();
        Plot::new(
            "Amplitude against speed",
            Axis::linear("speed of the vehicle", "km/h"),
            Axis::linear("amplitude", "mm"),
            vec![Series::line("X", curve).of("amplitude")],
        )
        .over("base.road.speed")
        .mark("at this speed", (speed, at(speed)))
    }
}

/// The mass on its base.
fn drawing() -> Drawing {
    plots::supported("The mass on its base")
        .block("", (-1.2, -1.9), (1.2, -1.5), Ink::Faint)
        .motion("y", (1.5, -2.0), (1.5, -1.3))
        .finish()
}
