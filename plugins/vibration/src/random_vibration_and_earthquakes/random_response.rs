//! One degree of freedom under a random force or torque, or on a randomly excited base.

use dalembert_core::{
    About, Analysis, Axis, Drawing, Exhibit, Ink, Inputs, Plot, Refusal, Series, Symbol, Text, Worksheet,
    register,
};
use dalembert_mechanics::{
    Real,
    vibration::random::{self, Resonance, integrate, integrate_about, modal_moment},
};

use crate::{
    shared::{
        free_motion::{DampedOscillator, system_of_body},
        oscillator::{
            motion::OscillatorMotion,
            parts::{BodyDamping, BodySprings, OscillatingBody, motion_of},
            plots,
        },
        spectral_density::{
            AccelerationDensity, AccelerationDensityGiven, AngularAccelerationDensity,
            AngularAccelerationDensityGiven, ForceDensity, ForceDensityGiven, Spectrum, TorqueDensity,
            TorqueDensityGiven, not_found, zero_crossings,
        },
    },
    sources::{MILES, RAO, THOMSON},
};

/// The oscillator and what shakes it.
#[derive(Clone, Debug, Inputs)]
pub struct RandomResponse {
    /// Inertia.
    /// Required only for a force or torque on it, or if the stiffness is given instead of a frequency.
    pub mass: Option<OscillatingBody>,
    /// Springs.
    pub elasticity: BodySprings,
    /// Damping.
    pub damping: BodyDamping,
    /// Excitation.
    /// Stationary, Gaussian, zero mean.
    pub excitation: RandomExcitation,
}

/// Excitation of the mass.
#[derive(Clone, Debug, Inputs)]
pub enum RandomExcitation {
    /// Base acceleration
    Base {
        /// Power spectral density of the acceleration.
        density: AccelerationDensity,
    },
    /// Force on the mass
    Force {
        /// Power spectral density of the force.
        density: ForceDensity,
    },
    /// Angular acceleration of the base
    /// For a rotation.
    BaseRotation {
        /// Power spectral density of the angular acceleration.
        density: AngularAccelerationDensity,
    },
    /// Torque on the body
    /// For a rotation.
    Torque {
        /// Power spectral density of the torque.
        density: TorqueDensity,
    },
}

register!(RandomResponse);

impl Analysis for RandomResponse {
    const ABOUT: About = About {
        id: "vibration/random-response",
        title: "Random response",
        topic: "Random vibration and earthquakes",
        summary: "Root mean square of displacement and acceleration, crossing rate and three-sigma values of one degree of freedom, moving along a line or about an axis, under a spectral density.",
        main: &["displacement", "acceleration", "three_sigma_displacement"],
        keywords: "psd random vibration rms grms white noise Miles three sigma spectral density crossing rate vibração \
                   aleatória densidade espectral ruído branco valor eficaz três sigma cruzamentos",
        sources: &[&RAO, &THOMSON, &MILES],
        cases: include_str!("../../cases/random_response.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &RandomResponseGiven<W>, sheet: W) -> Result<(), Refusal> {
        let RandomResponseGiven { mass, elasticity, damping, .. } = given;
        let motion = motion_of(mass.as_ref(), elasticity, damping, Some(given.excitation.motion()))?;
        let system = system_of_body(motion, mass.as_ref(), elasticity, damping, sheet)?;
        if system.ratio.value() == 0.0 {
            return Err(Refusal::because(
                "without damping a random excitation makes the motion grow without bound, as √t: give a damping ratio",
            ));
        }
        sheet.answer("natural_frequency", "Natural frequency", system.natural);
        sheet.answer("damping_ratio", "Damping ratio", system.ratio);
        let (spectrum, on_base) = match &self.excitation {
            RandomExcitation::Base { density } => (density.spectrum()?, true),
            RandomExcitation::BaseRotation { density } => (density.spectrum()?, true),
            RandomExcitation::Force { density } => (density.spectrum()?, false),
            RandomExcitation::Torque { density } => (density.spectrum()?, false),
        };
        let scale = if on_base {
            1.0
        } else {
            let body = system.body.ok_or_else(|| {
                Refusal::because(motion.of(
                    "a force moves a mass: give the mass in addition to the natural frequency",
                    "a torque turns a body: give its moment of inertia in addition to the natural frequency",
                ))
            })?;
            1.0 / body.mass.value().powi(2)
        };
        let problem = Random { spectrum, scale, system };
        if !problem.spectrum.reaches(system.natural.value()) {
            sheet.warn(|| {
                Text::new(
                    "the natural frequency is outside the band of the excitation: no resonance is excited",
                )
            });
        }
        let level = given.excitation.level().map(|(unit, level)| sheet.step("S₀", unit, level, PER_RADIAN));
        let band = given.excitation.band();
        if on_base {
            problem.base(level, band, sheet)?;
        } else {
            problem.force(level, band, sheet)?;
        }
        sheet.show(|| Exhibit::Plot(problem.plot(on_base)));
        sheet.show(|| Exhibit::Drawing(self.drawing()));
        Ok(())
    }
}

impl RandomResponse {
    /// The oscillator on its base, or under its load.
    fn drawing(&self) -> Drawing {
        let body = self.mass.as_ref().map_or_else(|| "m".into(), OscillatingBody::letters);
        let letters = [body, self.elasticity.letters().into()];
        match self.excitation {
            RandomExcitation::Force { .. } => plots::mass_spring_damper("F(t)", letters),
            RandomExcitation::Torque { .. } => plots::inertia_spring_damper("T(t)", letters),
            RandomExcitation::BaseRotation { .. } => plots::inertia_spring_damper("α(t)", letters),
            RandomExcitation::Base { .. } => plots::supported("The mass on its base", letters)
                .block("", (-1.2, -1.9), (1.2, -1.5), Ink::Faint)
                .motion("ÿ(t)", (1.6, -2.0), (1.6, -1.3))
                .finish(),
        }
    }
}

impl<W: Worksheet> RandomExcitationGiven<W> {
    /// The motion that it is of.
    fn motion(&self) -> OscillatorMotion {
        match self {
            RandomExcitationGiven::Base { .. } | RandomExcitationGiven::Force { .. } => {
                OscillatorMotion::Translation
            }
            RandomExcitationGiven::BaseRotation { .. } | RandomExcitationGiven::Torque { .. } => {
                OscillatorMotion::Rotation
            }
        }
    }

    /// The level over a band.
    fn band(&self) -> Option<LevelBand<W::Num>> {
        match self {
            RandomExcitationGiven::Base { density: AccelerationDensityGiven::Band { level, from, to } }
            | RandomExcitationGiven::Force { density: ForceDensityGiven::Band { level, from, to } }
            | RandomExcitationGiven::BaseRotation {
                density: AngularAccelerationDensityGiven::Band { level, from, to },
            }
            | RandomExcitationGiven::Torque { density: TorqueDensityGiven::Band { level, from, to } } => {
                Some([*level, *from, *to])
            }
            _ => None,
        }
    }

    /// The level of white noise, with its unit per rad/s.
    fn level(&self) -> Option<(&'static str, W::Num)> {
        match self {
            RandomExcitationGiven::Base { density: AccelerationDensityGiven::White { level } } => {
                Some(("m^2/s^3/rad", *level))
            }
            RandomExcitationGiven::Force { density: ForceDensityGiven::White { level } } => {
                Some(("N^2*s/rad", *level))
            }
            RandomExcitationGiven::BaseRotation {
                density: AngularAccelerationDensityGiven::White { level },
            } => Some(("rad/s^3", *level)),
            RandomExcitationGiven::Torque { density: TorqueDensityGiven::White { level } } => {
                Some(("N^2*m^2*s/rad", *level))
            }
            _ => None,
        }
    }
}

/// The level of a density over a band, and the ends of the band.
type LevelBand<N> = [N; 3];

/// The formulas of white noise count frequencies in rad/s.
const PER_RADIAN: &str = "The density per rad/s: 1 Hz is 2π rad/s";

/// A density on an oscillator.
struct Random<N> {
    spectrum: Spectrum,
    /// Factor from the density to that of an acceleration: one over the square of the mass for a force.
    scale: f64,
    system: DampedOscillator<N>,
}

/// Weight of a response quantity: `∫ (a + b ω²) ω^m |H|² S dω`.
#[derive(Clone, Copy)]
struct Weight {
    power: u8,
    constant: f64,
    square: f64,
}

impl<N: Real> Random<N> {
    fn resonance(&self) -> Resonance {
        Resonance { natural: self.system.natural.value(), ratio: self.system.ratio.value() }
    }

    /// The relative displacement and the absolute acceleration of a mass on a base.
    fn base<W: Worksheet<Num = N>>(
        &self,
        level: Option<N>,
        band: Option<LevelBand<N>>,
        sheet: W,
    ) -> Result<(), Refusal> {
        let DampedOscillator { natural, ratio, motion, .. } = self.system;
        let (relative, speed, absolute) = motion.of(
            (
                "Root mean square of the displacement relative to the base",
                "Root mean square of the velocity relative to the base",
                "Root mean square of the absolute acceleration",
            ),
            (
                "Root mean square of the angle relative to the base",
                "Root mean square of the angular velocity relative to the base",
                "Root mean square of the absolute angular acceleration",
            ),
        );
        let acceleration_unit = motion.of("m/s^2", "rad/s^2");
        if let Some(band) = band {
            self.band_errors(band, motion.of(["σ_z", "σ_v", "σ_a"], ["σ_θ", "σ_Ω", "σ_α"]), sheet);
        }
        let displacement = self.rms(
            [motion.of("σ_z", "σ_θ"), motion.displacement_unit()],
            Weight { power: 0, constant: 1.0, square: 0.0 },
            level.map(|level| random::white_displacement(level, natural, ratio)),
            relative,
            sheet,
        )?;
        let velocity = self.rms(
            [motion.of("σ_v", "σ_Ω"), motion.velocity_unit()],
            Weight { power: 2, constant: 1.0, square: 0.0 },
            level.map(|level| random::white_velocity(level, natural, ratio)),
            speed,
            sheet,
        )?;
        let (wn, zeta) = (natural.value(), ratio.value());
        let acceleration = self.rms(
            [motion.of("σ_a", "σ_α"), acceleration_unit],
            Weight { power: 0, constant: wn.powi(4), square: (2.0 * zeta * wn).powi(2) },
            level.map(|level| random::white_acceleration(level, natural, ratio)),
            absolute,
            sheet,
        )?;
        let labels = motion.of(
            [
                "Root mean square of the relative displacement",
                "Root mean square of the relative velocity",
                "Root mean square of the absolute acceleration",
            ],
            [
                "Root mean square of the relative angle",
                "Root mean square of the relative angular velocity",
                "Root mean square of the absolute angular acceleration",
            ],
        );
        sheet.answer("displacement", labels[0], displacement);
        sheet.answer("velocity", labels[1], velocity);
        sheet.answer("acceleration", labels[2], acceleration);
        let at_natural = match level {
            Some(level) => Some(level),
            None if self.spectrum.reaches(wn) => {
                let why = "Power spectral density of the acceleration at the natural frequency";
                let unit = motion.of("m^2/s^4/Hz", "rad^2/s^4/Hz");
                Some(sheet.numerical("S_n", unit, self.spectrum.at(wn), why))
            }
            None => None,
        };
        if let Some(density) = at_natural {
            let why = (
                "Miles' value, which treats the density at the natural frequency as white noise and neglects 4ζ²",
                MILES.at("1954"),
            );
            let miles =
                sheet.step("σ_M", acceleration_unit, random::miles(density, natural, ratio).sqrt(), why);
            let error =
                sheet.step("ε_M", "%", (miles - acceleration) / acceleration, "Error of Miles' value");
            sheet.verify(|| {
                let white = Random { spectrum: Spectrum::White(self.spectrum.at(wn)), scale: 1.0, system: self.system };
                if let Ok(square) = white.integral(Weight { power: 0, constant: wn.powi(4), square: 0.0 }) {
                    let what = motion.of(
                        "force of the spring over the mass under white noise, by integration over all frequencies",
                        "torque of the spring over the moment of inertia under white noise, by integration over all frequencies",
                    );
                    sheet.check(what, square.sqrt().into(), miles);
                }
            });
            sheet.answer("miles", "Acceleration by Miles' formula", miles);
            sheet.answer("miles_error", "Error of Miles' formula", error);
        }
        let moment = |power| self.second(Weight { power, constant: 1.0, square: 0.0 });
        zero_crossings([displacement, velocity], moment, sheet);
        let why = "Three standard deviations: reached or passed 0.27 % of the time";
        let symbol = motion.of("3σ_z", "3σ_θ");
        let three = sheet.step(symbol, motion.displacement_unit(), displacement * 3.0, why);
        let label = motion.of("3σ relative displacement", "3σ relative angle");
        sheet.answer("three_sigma_displacement", label, three);
        let symbol = motion.of("3σ_a", "3σ_α");
        let three = sheet.step(symbol, acceleration_unit, acceleration * 3.0, why);
        let label = motion.of("3σ absolute acceleration", "3σ absolute angular acceleration");
        sheet.answer("three_sigma_acceleration", label, three);
        Ok(())
    }

    /// The displacement of a mass under a force, and the force on its support.
    fn force<W: Worksheet<Num = N>>(
        &self,
        level: Option<N>,
        band: Option<LevelBand<N>>,
        sheet: W,
    ) -> Result<(), Refusal> {
        let DampedOscillator { natural, ratio, motion, .. } = self.system;
        let (moved, speed, carried, on_support) = motion.of(
            (
                "Root mean square of the displacement",
                "Root mean square of the velocity",
                "Root mean square of the force of spring and damper, over the mass",
                "Root mean square of the force on the support",
            ),
            (
                "Root mean square of the angle",
                "Root mean square of the angular velocity",
                "Root mean square of the torque of spring and damper, over the moment of inertia",
                "Root mean square of the torque on the support",
            ),
        );
        let acceleration_unit = motion.of("m/s^2", "rad/s^2");
        let body = self.system.body.expect("a force has a mass to move");
        let level = level.map(|level| level / body.mass.powi(2));
        if let Some([level, from, to]) = band {
            let band = [level / body.mass.powi(2), from, to];
            self.band_errors(band, motion.of(["σ_x", "σ_v", "σ_f"], ["σ_θ", "σ_Ω", "σ_f"]), sheet);
        }
        let displacement = self.rms(
            [motion.of("σ_x", "σ_θ"), motion.displacement_unit()],
            Weight { power: 0, constant: 1.0, square: 0.0 },
            level.map(|level| random::white_displacement(level, natural, ratio)),
            moved,
            sheet,
        )?;
        let velocity = self.rms(
            [motion.of("σ_v", "σ_Ω"), motion.velocity_unit()],
            Weight { power: 2, constant: 1.0, square: 0.0 },
            level.map(|level| random::white_velocity(level, natural, ratio)),
            speed,
            sheet,
        )?;
        let (wn, zeta) = (natural.value(), ratio.value());
        let transmitted = self.rms(
            ["σ_f", acceleration_unit],
            Weight { power: 0, constant: wn.powi(4), square: (2.0 * zeta * wn).powi(2) },
            level.map(|level| random::white_acceleration(level, natural, ratio)),
            carried,
            sheet,
        )?;
        let (symbol, name) = motion.of(("σ_F", "support_force"), ("σ_T", "support_torque"));
        let spring = || body.stiffness * displacement;
        sheet.common_error(symbol, "the stiffness times the displacement taken, the damper left out", spring);
        let force = sheet.step(symbol, motion.force_unit(), body.mass * transmitted, on_support);
        sheet.answer("displacement", moved, displacement);
        sheet.answer("velocity", speed, velocity);
        sheet.answer(name, on_support, force);
        sheet.verify(|| {
            let stiffness = body.stiffness.value();
            let damping = 2.0 * zeta * body.mass.value() * wn;
            let weight = Weight { power: 0, constant: stiffness.powi(2), square: damping.powi(2) };
            if let Some(square) = self.second(weight) {
                let what = motion.of(
                    "root mean square of the force k + icω of spring and damper on the displacement",
                    "root mean square of the torque k_t + ic_tω of spring and damper on the angle",
                );
                sheet.check(what, square.sqrt().into(), force);
            }
        });
        if matches!(self.spectrum, Spectrum::White(_)) {
            sheet.warn(|| {
                Text::new(motion.of(
                    "under a white-noise force the acceleration of the mass has no finite mean square: it grows with the bandwidth",
                    "under a white-noise torque the angular acceleration has no finite mean square: it grows with the bandwidth",
                ))
            });
        } else {
            let why = motion
                .of("Root mean square of the acceleration", "Root mean square of the angular acceleration");
            let acceleration = self.rms(
                [motion.of("σ_a", "σ_α"), acceleration_unit],
                Weight { power: 4, constant: 1.0, square: 0.0 },
                None,
                why,
                sheet,
            )?;
            sheet.answer("acceleration", why, acceleration);
        }
        let moment = |power| self.second(Weight { power, constant: 1.0, square: 0.0 });
        zero_crossings([displacement, velocity], moment, sheet);
        let why = "Three standard deviations: reached or passed 0.27 % of the time";
        let symbol = motion.of("3σ_x", "3σ_θ");
        let three = sheet.step(symbol, motion.displacement_unit(), displacement * 3.0, why);
        sheet.answer("three_sigma_displacement", motion.of("3σ displacement", "3σ angle"), three);
        Ok(())
    }

    /// Common errors in the root mean squares of displacement, velocity and acceleration under a level over a
    /// band.
    fn band_errors<W: Worksheet<Num = N>>(
        &self,
        [level, from, to]: LevelBand<N>,
        [moved, speed, pushed]: [&'static str; 3],
        sheet: W,
    ) {
        let DampedOscillator { natural, ratio, .. } = self.system;
        let white = "the formula for white noise used for a band";
        sheet.common_error(moved, white, || random::white_displacement(level, natural, ratio).sqrt());
        sheet.common_error(speed, white, || random::white_velocity(level, natural, ratio).sqrt());
        sheet.common_error(pushed, white, || random::white_acceleration(level, natural, ratio).sqrt());
        let excitation = || (level * (to - from)).sqrt();
        let what = "the response taken as static, without the magnification at resonance";
        sheet.common_error(moved, what, || excitation() / natural.powi(2));
        let what = "the root mean square of the excitation multiplied by the quality factor";
        sheet.common_error(pushed, what, || excitation() / (ratio * 2.0));
    }

    /// A root mean square: by its closed form under white noise, else by adaptive integration.
    fn rms<W: Worksheet<Num = N>>(
        &self,
        [symbol, unit]: [&'static str; 2],
        weight: Weight,
        closed: Option<N>,
        why: &'static str,
        sheet: W,
    ) -> Result<N, Refusal> {
        sheet.keep_going()?;
        let symbol = Symbol::from(symbol);
        if let Some(square) = closed {
            let value = sheet.step(symbol, unit, square.sqrt(), (why, RAO.at("ch. 14")));
            let mut failed = None;
            sheet.verify(|| match self.integral(weight) {
                Ok(integral) => sheet.check(
                    "root mean square by integration over all frequencies",
                    integral.sqrt().into(),
                    value,
                ),
                Err(err) => failed = Some(err),
            });
            return failed.map_or(Ok(value), Err);
        }
        let integral = self.integral(weight)?;
        let reason = Text::new("{what}: the integral of |H|²S over the frequency, by adaptive quadrature")
            .with_text("what", why);
        let value = sheet.numerical(symbol, unit, integral.sqrt(), (reason, RAO.at("ch. 14")));
        sheet.verify(|| match self.partial_fractions(weight) {
            Some((closed, scale)) => sheet.check_zero(
                "mean square by partial fractions over the band",
                (integral - closed).into(),
                scale,
            ),
            None => {
                let mode = self.resonance();
                let about = [mode.natural, mode.natural * mode.ratio];
                let second =
                    integrate_about(|omega| self.integrand(weight, omega), &self.spectrum.ends(), about);
                sheet.check("root mean square by a rule of fixed panels", second.sqrt().into(), value);
            }
        });
        Ok(value)
    }

    /// A mean square in the way that is not its first one.
    fn second(&self, weight: Weight) -> Option<f64> {
        if let Spectrum::White(_) = self.spectrum {
            return self.integral(weight).ok();
        }
        let mode = self.resonance();
        let about = [mode.natural, mode.natural * mode.ratio];
        Some(integrate_about(|omega| self.integrand(weight, omega), &self.spectrum.ends(), about))
    }

    fn integrand(&self, weight: Weight, omega: f64) -> f64 {
        let squared = self.resonance().receptance(omega).norm_sqr();
        let size = (weight.constant + weight.square * omega * omega) * omega.powi(weight.power.into());
        squared * size * self.spectrum.at(omega) * self.scale
    }

    fn integral(&self, weight: Weight) -> Result<f64, Refusal> {
        let mode = self.resonance();
        let mut points = self.spectrum.ends();
        let (first, last) = (points[0], points[points.len() - 1]);
        points.extend(mode.breaks().filter(|omega| *omega > first && *omega < last));
        if last.is_infinite() {
            points.push(20.0 * mode.natural * (1.0 + mode.ratio));
        }
        integrate(|omega| self.integrand(weight, omega), &points).map_err(not_found)
    }

    /// The mean square under a level over a band in closed form, with the size of its terms.
    fn partial_fractions(&self, weight: Weight) -> Option<(f64, f64)> {
        let Spectrum::Band(level, ends) = self.spectrum else { return None };
        let mode = self.resonance();
        let moment = |power| modal_moment(mode, mode, power, ends);
        let first = moment(weight.power)?;
        let (mut value, mut scale) = (first.value * weight.constant, first.scale * weight.constant);
        if weight.square != 0.0 {
            let second = moment(weight.power + 2)?;
            value += second.value * weight.square;
            scale += second.scale * weight.square;
        }
        Some((value * level * self.scale, scale * level * self.scale))
    }

    /// The density of the excitation, as an acceleration, and of the response.
    fn plot(&self, base: bool) -> Plot {
        let mode = self.resonance();
        let ends = self.spectrum.ends();
        let least = ends.iter().copied().find(|omega| *omega > 0.0).unwrap_or(mode.natural);
        let most = ends.last().copied().filter(|omega| omega.is_finite()).unwrap_or(mode.natural);
        let (from, to) = (0.5 * least.min(0.2 * mode.natural), 2.0 * most.max(5.0 * mode.natural));
        let frequency = |n: u16| from * ((to / from).ln() * f64::from(n) / 400.0).exp();
        let weight = Weight {
            power: 0,
            constant: mode.natural.powi(4),
            square: (2.0 * mode.ratio * mode.natural).powi(2),
        };
        let line = |of: &dyn Fn(f64) -> f64| (0..=400).map(|n| (frequency(n), of(frequency(n)))).collect();
        let response = line(&|omega| self.integrand(weight, omega));
        let excitation = line(&|omega| self.spectrum.at(omega) * self.scale);
        let motion = self.system.motion;
        let labels = if base {
            motion.of(
                ["acceleration of the base", "absolute acceleration of the mass"],
                ["angular acceleration of the base", "absolute angular acceleration of the body"],
            )
        } else {
            motion.of(
                ["force over mass", "force on the support over mass"],
                ["torque over moment of inertia", "torque on the support over moment of inertia"],
            )
        };
        Plot::new(
            "Power spectral density",
            Axis::log("frequency", "Hz"),
            Axis::log("spectral density", motion.of("m^2/s^4/Hz", "rad^2/s^4/Hz")),
            vec![Series::line(labels[0], excitation), Series::line(labels[1], response)],
        )
    }
}
