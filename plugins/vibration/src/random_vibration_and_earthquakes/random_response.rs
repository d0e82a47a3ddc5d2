//! One degree of freedom under a random force or on a randomly excited base.

use dalembert_core::{
    About, Analysis, Axis, Exhibit, Inputs, Plot, Refusal, Series, Symbol, Text, Worksheet, register,
};
use dalembert_mechanics::{
    Real,
    vibration::random::{self, Resonance, integrate, integrate_about, modal_moment},
};

use crate::{
    shared::{
        free_motion::{DampedOscillator, system},
        oscillator::{Elasticity, Mass, ViscousDamping, mass},
        spectral_density::{
            AccelerationDensity, AccelerationDensityGiven, ForceDensity, ForceDensityGiven, Spectrum,
            not_found,
        },
    },
    sources::{MILES, RAO, THOMSON},
};

/// The oscillator and what shakes it.
#[derive(Clone, Debug, Inputs)]
pub struct RandomResponse {
    /// Mass.
    /// Required only for a force on it, or if the stiffness is given instead of a frequency.
    pub mass: Option<Mass>,
    /// Springs.
    pub elasticity: Elasticity,
    /// Damping.
    pub damping: ViscousDamping,
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
}

register!(RandomResponse);

impl Analysis for RandomResponse {
    const ABOUT: About = About {
        id: "vibration/random-response",
        title: "Random response",
        topic: "Random vibration and earthquakes",
        summary: "Root mean square of displacement and acceleration, crossing rate and three-sigma values of one degree of freedom under a spectral density.",
        keywords: "psd random vibration rms grms white noise Miles three sigma spectral density crossing rate vibração \
                   aleatória densidade espectral ruído branco valor eficaz três sigma cruzamentos",
        sources: &[&RAO, &THOMSON, &MILES],
        cases: include_str!("../../cases/random_response.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &RandomResponseGiven<W>, sheet: W) -> Result<(), Refusal> {
        let mass = given.mass.as_ref().map(|given| mass(given, sheet));
        let system = system(mass, &given.elasticity, &given.damping, sheet)?;
        if system.ratio.value() == 0.0 {
            return Err(Refusal::because(
                "without damping a random excitation makes the motion grow without bound, as √t: give a damping ratio",
            ));
        }
        sheet.answer("natural_frequency", "Natural frequency", system.natural);
        sheet.answer("damping_ratio", "Damping ratio", system.ratio);
        let (spectrum, scale) = match &self.excitation {
            RandomExcitation::Base { density } => (density.spectrum()?, 1.0),
            RandomExcitation::Force { density } => {
                let body = system.body.ok_or_else(|| {
                    Refusal::because(
                        "a force moves a mass: give the mass in addition to the natural frequency",
                    )
                })?;
                (density.spectrum()?, 1.0 / body.mass.value().powi(2))
            }
        };
        let problem = Random { spectrum, scale, system };
        if !problem.spectrum.reaches(system.natural.value()) {
            sheet.warn(|| {
                Text::new(
                    "the natural frequency is outside the band of the excitation: no resonance is excited",
                )
            });
        }
        match &given.excitation {
            RandomExcitationGiven::Base { density } => {
                let level = match density {
                    AccelerationDensityGiven::White { level } => {
                        Some(sheet.step("S₀", "m^2/s^3/rad", *level, PER_RADIAN))
                    }
                    _ => None,
                };
                problem.base(level, sheet)?;
            }
            RandomExcitationGiven::Force { density } => {
                let level = match density {
                    ForceDensityGiven::White { level } => {
                        Some(sheet.step("S₀", "N^2*s/rad", *level, PER_RADIAN))
                    }
                    _ => None,
                };
                problem.force(level, sheet)?;
            }
        }
        sheet.show(|| Exhibit::Plot(problem.plot(matches!(self.excitation, RandomExcitation::Base { .. }))));
        Ok(())
    }
}

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
    fn base<W: Worksheet<Num = N>>(&self, level: Option<N>, sheet: W) -> Result<(), Refusal> {
        let DampedOscillator { natural, ratio, .. } = self.system;
        let displacement = self.rms(
            ["σ_z", "mm"],
            Weight { power: 0, constant: 1.0, square: 0.0 },
            level.map(|level| random::white_displacement(level, natural, ratio)),
            "Root mean square of the displacement relative to the base",
            sheet,
        )?;
        let velocity = self.rms(
            ["σ_v", "mm/s"],
            Weight { power: 2, constant: 1.0, square: 0.0 },
            level.map(|level| random::white_velocity(level, natural, ratio)),
            "Root mean square of the velocity relative to the base",
            sheet,
        )?;
        let (wn, zeta) = (natural.value(), ratio.value());
        let acceleration = self.rms(
            ["σ_a", "m/s^2"],
            Weight { power: 0, constant: wn.powi(4), square: (2.0 * zeta * wn).powi(2) },
            level.map(|level| random::white_acceleration(level, natural, ratio)),
            "Root mean square of the absolute acceleration",
            sheet,
        )?;
        sheet.answer("displacement", "Root mean square of the relative displacement", displacement);
        sheet.answer("velocity", "Root mean square of the relative velocity", velocity);
        sheet.answer("acceleration", "Root mean square of the absolute acceleration", acceleration);
        let at_natural = match level {
            Some(level) => Some(level),
            None if self.spectrum.reaches(wn) => {
                let why = "Power spectral density of the acceleration at the natural frequency";
                Some(sheet.numerical("S_n", "m^2/s^4/Hz", self.spectrum.at(wn), why))
            }
            None => None,
        };
        if let Some(density) = at_natural {
            let why = (
                "Miles' value, which treats the density at the natural frequency as white noise and neglects 4ζ²",
                MILES.at("1954"),
            );
            let miles = sheet.step("σ_M", "m/s^2", random::miles(density, natural, ratio).sqrt(), why);
            let error =
                sheet.step("ε_M", "%", (miles - acceleration) / acceleration, "Error of Miles' value");
            sheet.verify(|| {
                let white = Random { spectrum: Spectrum::White(self.spectrum.at(wn)), scale: 1.0, system: self.system };
                if let Ok(square) = white.integral(Weight { power: 0, constant: wn.powi(4), square: 0.0 }) {
                    let what = "force of the spring over the mass under white noise, by integration over all frequencies";
                    sheet.check(what, square.sqrt().into(), miles);
                }
            });
            sheet.answer("miles", "Acceleration by Miles' formula", miles);
            sheet.answer("miles_error", "Error of Miles' formula", error);
        }
        self.crossings(displacement, velocity, sheet);
        let why = "Three standard deviations: reached or passed 0.27 % of the time";
        let three = sheet.step("3σ_z", "mm", displacement * 3.0, why);
        sheet.answer("three_sigma_displacement", "3σ relative displacement", three);
        let three = sheet.step("3σ_a", "m/s^2", acceleration * 3.0, why);
        sheet.answer("three_sigma_acceleration", "3σ absolute acceleration", three);
        Ok(())
    }

    /// The displacement of a mass under a force, and the force on its support.
    fn force<W: Worksheet<Num = N>>(&self, level: Option<N>, sheet: W) -> Result<(), Refusal> {
        let DampedOscillator { natural, ratio, .. } = self.system;
        let body = self.system.body.expect("a force has a mass to move");
        let level = level.map(|level| level / body.mass.powi(2));
        let displacement = self.rms(
            ["σ_x", "mm"],
            Weight { power: 0, constant: 1.0, square: 0.0 },
            level.map(|level| random::white_displacement(level, natural, ratio)),
            "Root mean square of the displacement",
            sheet,
        )?;
        let velocity = self.rms(
            ["σ_v", "mm/s"],
            Weight { power: 2, constant: 1.0, square: 0.0 },
            level.map(|level| random::white_velocity(level, natural, ratio)),
            "Root mean square of the velocity",
            sheet,
        )?;
        let (wn, zeta) = (natural.value(), ratio.value());
        let transmitted = self.rms(
            ["σ_f", "m/s^2"],
            Weight { power: 0, constant: wn.powi(4), square: (2.0 * zeta * wn).powi(2) },
            level.map(|level| random::white_acceleration(level, natural, ratio)),
            "Root mean square of the force of spring and damper, over the mass",
            sheet,
        )?;
        let why = "Root mean square of the force on the support";
        let force = sheet.step("σ_F", "N", body.mass * transmitted, why);
        sheet.answer("displacement", "Root mean square of the displacement", displacement);
        sheet.answer("velocity", "Root mean square of the velocity", velocity);
        sheet.answer("support_force", "Root mean square of the force on the support", force);
        sheet.verify(|| {
            let stiffness = body.stiffness.value();
            let damping = 2.0 * zeta * body.mass.value() * wn;
            let weight = Weight { power: 0, constant: stiffness.powi(2), square: damping.powi(2) };
            if let Some(square) = self.second(weight) {
                let what = "root mean square of the force k + icω of spring and damper on the displacement";
                sheet.check(what, square.sqrt().into(), force);
            }
        });
        if matches!(self.spectrum, Spectrum::White(_)) {
            sheet.warn(|| {
                Text::new(
                    "under a white-noise force the acceleration of the mass has no finite mean square: it grows with the bandwidth",
                )
            });
        } else {
            let acceleration = self.rms(
                ["σ_a", "m/s^2"],
                Weight { power: 4, constant: 1.0, square: 0.0 },
                None,
                "Root mean square of the acceleration",
                sheet,
            )?;
            sheet.answer("acceleration", "Root mean square of the acceleration", acceleration);
        }
        self.crossings(displacement, velocity, sheet);
        let why = "Three standard deviations: reached or passed 0.27 % of the time";
        let three = sheet.step("3σ_x", "mm", displacement * 3.0, why);
        sheet.answer("three_sigma_displacement", "3σ displacement", three);
        Ok(())
    }

    /// Rate of zero crossings with positive slope.
    fn crossings<W: Worksheet<Num = N>>(&self, displacement: N, velocity: N, sheet: W) {
        let why = (
            "Mean rate of upward zero crossings, by Rice: the apparent frequency of the motion",
            RAO.at("ch. 14"),
        );
        let rate = sheet.step("ν₀", "Hz", velocity / displacement, why);
        sheet.answer("crossing_rate", "Mean rate of upward zero crossings", rate);
        sheet.verify(|| {
            let moment = |power| self.second(Weight { power, constant: 1.0, square: 0.0 });
            if let (Some(zeroth), Some(second)) = (moment(0), moment(2)) {
                let what =
                    "the square of the zero-crossing rate is the second spectral moment of the response over that of order zero";
                sheet.check(what, (second / zeroth).into(), rate.powi(2));
            }
        });
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
        let labels = if base {
            ["acceleration of the base", "absolute acceleration of the mass"]
        } else {
            ["force over mass", "force on the support over mass"]
        };
        Plot::new(
            "Power spectral density",
            Axis::log("frequency", "Hz"),
            Axis::log("density", "m^2/s^4/Hz"),
            vec![Series::line(labels[0], excitation), Series::line(labels[1], response)],
        )
    }
}
