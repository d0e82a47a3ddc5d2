//! A mass on a shaking base: absolute and relative motion, the wavy road, and the motion from rest.

use std::f64::consts::{PI, TAU};

use dalembert_core::{
    About, Analysis, Axis, Drawing, Exhibit, Ink, Inputs, Plot, Refusal, Series, Text, Worksheet, register,
};
use dalembert_mechanics::{Real, sdof, vibration::isolation};

use crate::{
    shared::oscillator::{
        AtFrequency, Loss, Suspension,
        motion::OscillatorMotion,
        parts::{BodyDamping, BodySprings, OscillatingBody, motion_of, suspension_of_body},
        plots,
        transient_from_rest::{BuildUp, Wave},
    },
    sources::{RAO, THOMSON},
};

/// The oscillator and the base that shakes it.
#[derive(Clone, Debug, Inputs)]
pub struct BaseExcitation {
    /// Inertia.
    /// May be omitted if the natural frequency or the static deflection is known; the forces are then not computed.
    pub mass: Option<OscillatingBody>,
    /// Springs.
    pub elasticity: BodySprings,
    /// Damping.
    pub damping: BodyDamping,
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
    /// Rotation of the base given
    /// For a rotation.
    Rotation {
        /// Amplitude of the rotation of the base.
        #[input("Φ", "rad", positive)]
        amplitude: f64,
        /// Frequency of the base.
        #[input("ω", "rad/s", positive)]
        frequency: f64,
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
        main: &["amplitude", "transmissibility", "acceleration", "growth"],
        keywords: "support motion transmissibility quarter car vehicle road ground seismic excitação de base \
                   movimento do suporte transmissibilidade veículo estrada velocidade crítica motion of the base \
                   response of a damped system to base motion movimento da base excitação pela base quarto de \
                   carro um quarto de veículo",
        sources: &[&RAO, &THOMSON],
        cases: include_str!("../../cases/base_excitation.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &BaseExcitationGiven<W>, sheet: W) -> Result<(), Refusal> {
        let BaseExcitationGiven { mass, elasticity, damping, .. } = given;
        let motion = motion_of(mass.as_ref(), elasticity, damping, Some(given.base.motion()))?;
        let suspension = suspension_of_body(motion, mass.as_ref(), elasticity, damping, sheet)?;
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
                motion.of("Ẋ", "Θ′"),
                motion.velocity_unit(),
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
                motion,
                deflection: base,
                frequency,
                natural: suspension.natural,
                at,
                steady,
                wave: Wave::Sine,
                through_dashpot: true,
            };
            let x = build_up.displacement(start.time, sheet);
            let label = motion.of("Displacement of the mass at that time", "Angle of the body at that time");
            sheet.answer("displacement", label, x);
            let title = motion.of("Motion of the mass from rest", "Motion of the body from rest");
            build_up.show(start.time.value(), title, x.value(), sheet);
        }
        let own = own_damping(&suspension);
        let ratio = at.ratio.value();
        let (frequency, amplitude) = match self.base {
            Base::Displacement { .. } => ("base.displacement.frequency", "base.displacement.amplitude"),
            Base::Acceleration { .. } => ("base.acceleration.frequency", ""),
            Base::Road { .. } => ("base.road.speed", "base.road.amplitude"),
            Base::Rotation { .. } => ("base.rotation.frequency", "base.rotation.amplitude"),
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
        sheet.show(|| Exhibit::Drawing(self.drawing(motion)));
        Ok(())
    }
}

impl<W: Worksheet> BaseGiven<W> {
    /// The motion that it is of.
    fn motion(&self) -> OscillatorMotion {
        match self {
            BaseGiven::Rotation { .. } => OscillatorMotion::Rotation,
            _ => OscillatorMotion::Translation,
        }
    }
}

/// Amplitude and frequency of the base.
fn base<W: Worksheet>(given: &BaseGiven<W>, sheet: W) -> (W::Num, W::Num) {
    match given {
        BaseGiven::Displacement { amplitude, frequency } | BaseGiven::Rotation { amplitude, frequency } => {
            (*amplitude, *frequency)
        }
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
    if let Loss::Viscous(zeta, _) = suspension.loss {
        let damped = || sdof::damped_frequency(suspension.natural, zeta) * wavelength / TAU;
        sheet.common_error("v_c", "the damped natural frequency used", damped);
    }
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
        sheet.common_error(
            "rₚ",
            "the peak of the magnification factor for a force on the mass taken",
            || sdof::magnification_peak_ratio(zeta),
        );
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
    let motion = suspension.motion;
    sheet.common_error("TR", "the magnification factor for a force on the mass used", || {
        sdof::magnification(ratio, damping_ratio)
    });
    sheet.common_error("TR", "the ratio of the relative motion to that of the base used", || {
        sdof::unbalance_magnification(ratio, damping_ratio)
    });
    sheet.common_error("TR", "the transmissibility without damping used", || {
        W::Num::from(1.0) / (W::Num::from(1.0) - ratio.powi(2)).abs()
    });
    let transmissibility = sheet.step(
        "TR",
        "1",
        sdof::transmissibility(ratio, damping_ratio),
        ("Transmissibility: motion of the mass over motion of the base", RAO.at("§3.6")),
    );
    let words = motion.of("Amplitude of the mass", "Amplitude of the body");
    let unit = motion.displacement_unit();
    sheet.common_error(
        motion.of("X", "Θ"),
        "the amplitudes of base and relative motion added without their phases",
        || base * (sdof::unbalance_magnification(ratio, damping_ratio) + 1.0),
    );
    let amplitude = sheet.step(motion.of("X", "Θ"), unit, base * transmissibility, words);
    let lag = sheet.step(
        "ψ",
        "deg",
        sdof::transmissibility_phase(ratio, damping_ratio),
        (motion.of("The mass lags the base by", "The body lags the base by"), RAO.at("§3.6")),
    );
    let relative = sheet.step(
        motion.of("Z", "Θ_r"),
        unit,
        base * sdof::unbalance_magnification(ratio, damping_ratio),
        ("Amplitude of the motion relative to the base: travel of the springs", RAO.at("§3.6")),
    );
    let relative_lag = sheet.step(
        "φ",
        "deg",
        sdof::phase_lag_from_ratios(ratio, damping_ratio),
        ("The relative motion lags the base by", RAO.at("§3.6")),
    );
    let label = motion.of("Acceleration of the mass", "Angular acceleration of the body");
    let (symbol, per_second) = motion.of(("A", "m/s^2"), ("α", "rad/s^2"));
    sheet.common_error(symbol, "the amplitude of the relative motion used", || relative * frequency.powi(2));
    let acceleration = sheet.step(symbol, per_second, amplitude * frequency.powi(2), label);
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
    sheet.answer("amplitude", words, amplitude);
    sheet.answer("phase", motion.of("Phase lag of the mass", "Phase lag of the body"), lag);
    sheet.answer("relative_amplitude", "Amplitude of the relative motion", relative);
    sheet.answer("relative_phase", "Phase lag of the relative motion", relative_lag);
    sheet.answer("acceleration", label, acceleration);
    if let (Some(body), Some(c)) = (suspension.body, damping) {
        let why = motion.of(
            "Amplitude of the force in spring and damper: it accelerates the mass",
            "Amplitude of the torque in spring and damper: it accelerates the body",
        );
        let unit = motion.force_unit();
        sheet.common_error(motion.of("F", "T"), "the damper omitted: the spring alone taken", || {
            body.stiffness * relative
        });
        sheet.common_error(
            motion.of("F", "T"),
            "the absolute motion taken as the deformation of spring and damper",
            || sdof::transmitted_force(amplitude, body.stiffness, c, frequency),
        );
        let force = sheet.step(motion.of("F", "T"), unit, body.mass * acceleration, (why, RAO.at("§3.6")));
        sheet.check(
            motion.of("force from the relative motion", "torque from the relative motion"),
            sdof::transmitted_force(relative, body.stiffness, c, frequency),
            force,
        );
        let (name, label) = motion.of(("force", "Force on the mass"), ("torque", "Torque on the body"));
        sheet.answer(name, label, force);
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

impl BaseExcitation {
    /// The mass on its base, or on its wheel on the road.
    fn drawing(&self, motion: OscillatorMotion) -> Drawing {
        let body = self.mass.as_ref().map_or_else(|| "m".into(), OscillatingBody::letters);
        let letters = [body, self.elasticity.letters().into()];
        if motion == OscillatorMotion::Rotation {
            return plots::inertia_spring_damper("Φ sin(ω t)", letters);
        }
        let mut sketch = plots::supported("The mass on its base", letters);
        match self.base {
            Base::Road { .. } => {
                // A wheel rolls over waves that are drawn of a length and a height of their own.
                let (length, height) = (3.2, 0.25);
                let road = |n: i32| {
                    let x = -2.4 + 4.8 * f64::from(n) / 48.0;
                    (x, -3.0 + height * (TAU * x / length).cos())
                };
                sketch = sketch.titled("The vehicle on its wavy road (not to scale)");
                sketch
                    .bars([(-0.7, -1.5), (0.7, -1.5)])
                    .bars([(0.0, -1.5), (0.0, -2.25)])
                    .disc("", (0.0, -2.25), 0.5)
                    .joint("", (0.0, -2.25))
                    .curve((0..=48).map(road).collect::<Vec<_>>(), Ink::Body)
                    .motion("v", (-1.4, 0.0), (-2.2, 0.0))
                    .dimension("λ", (-1.6, -3.25), (1.6, -3.25), -1.0)
                    .dimension("Y", (1.6, -3.0), (1.6, -2.75), -1.5)
                    .axis((-2.4, -3.0), (2.4, -3.0))
                    .finish()
            }
            _ => sketch
                .block("", (-1.2, -1.9), (1.2, -1.5), Ink::Faint)
                .motion(self.base_letters(), (1.6, -2.0), (1.6, -1.3))
                .finish(),
        }
    }

    fn base_letters(&self) -> &'static str {
        match self.base {
            Base::Acceleration { .. } => "ÿ = A_b sin(ω t)",
            _ => "y = Y sin(ω t)",
        }
    }
}
