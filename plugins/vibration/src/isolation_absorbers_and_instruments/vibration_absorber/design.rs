//! The absorber of a known main system: its size, its resonances and the motion of both masses.

use dalembert_core::{Exhibit, Refusal, Text, Worksheet};
use dalembert_mechanics::{Real, sdof, vibration::absorber};
use dalembert_numerics::linalg;
use nalgebra::DMatrix;

use super::{
    ExcitationSpeedGiven,
    exhibits::{self, AbsorberResponse},
    motion::AbsorberMotion,
    trial,
};
use crate::{shared::oscillator::is_one, sources::RAO};

/// Common errors of the absorber.
const TUNED_TO_MAIN: &str =
    "the absorber tuned to the natural frequency of the main system in place of the speed";
const MAIN_AT_SPEED: &str =
    "the formula for an absorber tuned to the natural frequency of the main system used";
const FIXED: &str = "the absorber mass taken as fixed to the main system";

/// Requirement on the absorber, or its known parameter.
pub(super) enum AbsorberRequirement<N> {
    Stroke(N),
    Separation(N),
    Range(N, N),
    Ratio(N),
    Mass(N),
    Given(N, N),
}

/// The main system and the speed that shakes it.
pub(super) struct Main<N> {
    pub(super) motion: AbsorberMotion,
    pub(super) mass: N,
    pub(super) stiffness: N,
    pub(super) natural: N,
    pub(super) speed: N,
}

pub(super) fn main_system<W: Worksheet>(
    motion: AbsorberMotion,
    mass: W::Num,
    stiffness: W::Num,
    natural: Option<W::Num>,
    speed: &ExcitationSpeedGiven<W>,
    sheet: W,
) -> Main<W::Num> {
    let natural = natural.unwrap_or_else(|| {
        let why = ("Natural frequency of the main system, without the absorber", RAO.at("§2.2"));
        sheet.step("ω_m", "rad/s", sdof::natural_frequency(stiffness, mass), why)
    });
    let speed = match speed {
        ExcitationSpeedGiven::Given { speed } => *speed,
        ExcitationSpeedGiven::Ratio { ratio } => sheet.step(
            "ω",
            "rad/s",
            *ratio * natural,
            "Speed, from the given fraction of the natural frequency",
        ),
    };
    Main { motion, mass, stiffness, natural, speed }
}

impl<N: Real> Main<N> {
    /// The absorber, its resonances and amplitudes. The result is its stiffness.
    pub(super) fn absorbed<W: Worksheet<Num = N>>(
        &self,
        wanted: &AbsorberRequirement<N>,
        force: Option<N>,
        sheet: W,
    ) -> Result<N, Refusal> {
        let motion = self.motion;
        let tuned = !matches!(wanted, AbsorberRequirement::Given(..));
        // What a design has written down already is not written again.
        let (mut known_tuning, mut known_ratio) = (None, None);
        let (mass, stiffness) = match wanted {
            AbsorberRequirement::Given(mass, stiffness) => (*mass, *stiffness),
            AbsorberRequirement::Stroke(stroke) => {
                let Some(force) = force else {
                    return Err(Refusal::because(
                        "the stroke of the absorber follows from the force: write the excitation",
                    ));
                };
                let why = (
                    "Stiffness of the absorber: with the main system at rest, its spring alone balances the excitation",
                    RAO.at("§9.11"),
                );
                let stiffness =
                    sheet.step(motion.absorber_stiffness(), motion.stiffness_unit(), force / *stroke, why);
                let by_natural = || sdof::mass_from_natural_frequency(stiffness, self.natural);
                sheet.common_error(motion.absorber_mass(), TUNED_TO_MAIN, by_natural);
                let mass = sheet.step(
                    motion.absorber_mass(),
                    motion.mass_unit(),
                    sdof::mass_from_natural_frequency(stiffness, self.speed),
                    (motion.tuned_mass(), RAO.at("§9.11")),
                );
                (mass, stiffness)
            }
            AbsorberRequirement::Mass(mass) => (*mass, self.tuned(*mass, sheet)),
            AbsorberRequirement::Ratio(ratio) => {
                known_ratio = Some(*ratio);
                self.sized(*ratio, sheet)
            }
            AbsorberRequirement::Separation(separation) => {
                let one = N::from(1.0);
                let ratios = ["p₁", "p₂"];
                let why = [
                    "Upper limit of the lower resonance, as a ratio to the speed",
                    "Lower limit of the upper resonance, as a ratio to the speed",
                ];
                let lower = sheet.step(ratios[0], "1", one - *separation, why[0]);
                let upper = sheet.step(ratios[1], "1", one + *separation, why[1]);
                let (tuning, ratio) = self.least_ratio(lower, upper, sheet)?;
                (known_tuning, known_ratio) = (Some(tuning), Some(ratio));
                self.sized(ratio, sheet)
            }
            AbsorberRequirement::Range(lowest, highest) => {
                let [low, high] = [lowest.value(), highest.value()];
                trial::holds_speed(low, self.speed.value(), high)?;
                let why =
                    ["Lower end of the range, over the speed", "Upper limit of the range, over the speed"];
                let lower = sheet.step("p₁", "1", *lowest / self.speed, why[0]);
                let upper = sheet.step("p₂", "1", *highest / self.speed, why[1]);
                let (tuning, ratio) = self.least_ratio(lower, upper, sheet)?;
                (known_tuning, known_ratio) = (Some(tuning), Some(ratio));
                self.sized(ratio, sheet)
            }
        };
        sheet.answer(motion.absorber_mass_answer().0, motion.absorber_mass_answer().1, mass);
        sheet.answer("absorber_stiffness", "Stiffness of the absorber", stiffness);
        let resonances = self.resonances(mass, stiffness, tuned, (known_tuning, known_ratio), sheet);
        if let Some(force) = force {
            self.amplitudes(mass, stiffness, tuned, force, sheet);
        }
        let range = match wanted {
            AbsorberRequirement::Separation(s) => {
                let [s, speed] = [s.value(), self.speed.value()];
                Some([(1.0 - s) * speed, (1.0 + s) * speed])
            }
            AbsorberRequirement::Range(lowest, highest) => Some([lowest.value(), highest.value()]),
            _ => None,
        };
        let response = AbsorberResponse {
            mass: self.mass.value(),
            stiffness: self.stiffness.value(),
            absorber_mass: mass.value(),
            absorber_stiffness: stiffness.value(),
        };
        let speed = self.speed.value();
        sheet.show(|| Exhibit::Plot(response.main_mass(speed, resonances, range)));
        sheet.show(|| Exhibit::Plot(response.absorber(speed, resonances)));
        sheet.show(|| Exhibit::Plot(response.split(tuned.then_some(speed))));
        sheet.show(|| Exhibit::Drawing(exhibits::drawing(motion)));
        Ok(stiffness)
    }

    /// The spring that tunes the absorber to the speed.
    fn tuned<W: Worksheet<Num = N>>(&self, mass: N, sheet: W) -> N {
        let by_natural = || sdof::stiffness_from_natural_frequency(mass, self.natural);
        sheet.common_error(self.motion.absorber_stiffness(), TUNED_TO_MAIN, by_natural);
        sheet.step(
            self.motion.absorber_stiffness(),
            self.motion.stiffness_unit(),
            sdof::stiffness_from_natural_frequency(mass, self.speed),
            ("Stiffness that tunes the absorber to the running speed", RAO.at("§9.11")),
        )
    }

    /// Mass and spring of a tuned absorber of that mass ratio.
    fn sized<W: Worksheet<Num = N>>(&self, ratio: N, sheet: W) -> (N, N) {
        let mass = ratio * self.mass;
        let of_total = || mass / (N::from(1.0) - ratio);
        sheet.common_error(self.motion.absorber_mass(), "the mass ratio taken over the total mass", of_total);
        let mass = sheet.step(
            self.motion.absorber_mass(),
            self.motion.mass_unit(),
            mass,
            self.motion.mass_of_ratio(),
        );
        (mass, self.tuned(mass, sheet))
    }

    /// The least mass ratio with the resonances at `p₁` or below and at `p₂` or above.
    fn least_ratio<W: Worksheet<Num = N>>(&self, lower: N, upper: N, sheet: W) -> Result<(N, N), Refusal> {
        let why = ("Tuning: absorber frequency (= speed) over main-system frequency", RAO.at("§9.11"));
        let tuning = sheet.step("f", "1", self.speed / self.natural, why);
        let at = |symbol: &'static str, p: N, why: &'static str| {
            sheet.common_error(symbol, MAIN_AT_SPEED, || absorber::mass_ratio_when_tuned(p));
            sheet.step(symbol, "1", absorber::mass_ratio_of_resonance(p, tuning), (why, RAO.at("§9.11")))
        };
        let first = at(
            "μ₁",
            lower,
            "Mass ratio that places the lower resonance at this limit, by the frequency equation",
        );
        let second = at(
            "μ₂",
            upper,
            "Mass ratio that places the upper resonance at this limit, by the frequency equation",
        );
        if first.value() <= 0.0 && second.value() <= 0.0 {
            return Err(Refusal::because(
                "the resonances lie outside of that range with any absorber, however light, as the natural frequency \
                 of the main system does not lie in it: give the stroke or the mass of the absorber instead",
            ));
        }
        let lower_asks = first.value() >= second.value();
        let (asked, why) = if lower_asks {
            (first, "Mass ratio: the larger, required by the lower resonance")
        } else {
            (second, "Mass ratio: the larger, required by the upper resonance")
        };
        Ok((tuning, sheet.step("μ", "1", asked, why)))
    }

    /// The two resonances; with tuning and mass ratio where they are written down already.
    fn resonances<W: Worksheet<Num = N>>(
        &self,
        mass: N,
        stiffness: N,
        tuned: bool,
        known: (Option<N>, Option<N>),
        sheet: W,
    ) -> [f64; 2] {
        let own = if tuned {
            self.speed
        } else {
            let why = ("Natural frequency of the absorber by itself", RAO.at("§2.2"));
            let own = sheet.step("ω_a", "rad/s", sdof::natural_frequency(stiffness, mass), why);
            if !is_one(own.value() / self.speed.value()) {
                sheet.warn(|| {
                    Text::new("the absorber is not tuned to the speed: the main system still vibrates")
                });
            }
            own
        };
        let why = ("Tuning: absorber frequency over main-system frequency, uncoupled", RAO.at("§9.11"));
        let tuning = known.0.unwrap_or_else(|| sheet.step("f", "1", own / self.natural, why));
        let ratio = known.1.unwrap_or_else(|| sheet.step("μ", "1", mass / self.mass, self.motion.ratio()));
        let why = (
            "Sum of the two resonances, over the natural frequency of the main system: from their product f and the frequency equation",
            RAO.at("§9.11"),
        );
        let sum = sheet.step("Σg", "1", absorber::resonance_sum(tuning, ratio), why);
        let why = ("Their difference", RAO.at("§9.11"));
        let difference = sheet.step("Δg", "1", absorber::resonance_difference(tuning, ratio), why);
        let upper = sheet.step("g₂", "1", (sum + difference) / 2.0, "Upper resonance, frequency ratio");
        let lower = sheet.step("g₁", "1", tuning / upper, "Lower resonance, as a ratio");
        let when_tuned = |sign: f64| {
            let split = (ratio + ratio.powi(2) / 4.0).sqrt() * sign;
            (ratio / 2.0 + 1.0 + split).sqrt() * self.natural
        };
        sheet.common_error("Ω₁", MAIN_AT_SPEED, || when_tuned(-1.0));
        let fixed = || (self.stiffness / (self.mass + mass)).sqrt();
        sheet.common_error("Ω₁", FIXED, fixed);
        let lower = sheet.step("Ω₁", "rad/s", lower * self.natural, "Lower resonance");
        sheet.common_error("Ω₂", MAIN_AT_SPEED, || when_tuned(1.0));
        let at_rest = || ((self.stiffness + stiffness) / self.mass).sqrt();
        sheet.common_error("Ω₂", "the absorber mass taken as at rest", at_rest);
        let upper = sheet.step("Ω₂", "rad/s", upper * self.natural, "Upper resonance");
        sheet.verify(|| {
            let [m, k] = [self.mass.value(), self.stiffness.value()];
            let [m_a, k_a] = [mass.value(), stiffness.value()];
            let matrix = DMatrix::from_row_slice(2, 2, &[k + k_a, -k_a, -k_a, k_a]);
            let masses = DMatrix::from_row_slice(2, 2, &[m, 0.0, 0.0, m_a]);
            if let Ok(squares) = linalg::generalised_eigenvalues(&matrix, &masses) {
                let found = [squares[0], squares[1]].map(|square| N::from(square.max(0.0).sqrt()));
                sheet.check("lower resonance, as an eigenvalue of the two-mass system", lower, found[0]);
                sheet.check("upper resonance, as an eigenvalue of the two-mass system", upper, found[1]);
            }
        });
        let first = sheet.step("n₁", "1", lower / self.speed, "Lower resonance over the speed");
        let second = sheet.step("n₂", "1", upper / self.speed, "Upper resonance over the speed");
        sheet.answer("mass_ratio", "Mass ratio", ratio);
        sheet.answer("natural_frequency", "Natural frequency without the absorber", self.natural);
        sheet.answer("lower_resonance", "Lower resonance", lower);
        sheet.answer("upper_resonance", "Upper resonance", upper);
        sheet.answer("lower_ratio", "Lower resonance over the speed", first);
        sheet.answer("upper_ratio", "Upper resonance over the speed", second);
        [lower.value(), upper.value()]
    }

    /// Motion of both masses at the speed, and without the absorber.
    fn amplitudes<W: Worksheet<Num = N>>(&self, mass: N, stiffness: N, tuned: bool, force: N, sheet: W) {
        let motion = self.motion;
        let unit = motion.unit();
        if is_one(self.speed.value() / self.natural.value()) {
            sheet.warn(|| {
                Text::new(
                    "the speed is the natural frequency: without the absorber and without damping the motion grows with \
                     time without bound",
                )
            });
        } else {
            let before = force / (self.stiffness - self.mass * self.speed.powi(2)).abs();
            let why = ("Amplitude without the absorber", RAO.at("§3.3"));
            let before = sheet.step(motion.before(), unit, before, why);
            sheet.answer("amplitude_before", "Amplitude without the absorber", before);
            sheet.check(
                "without the absorber: inertia and spring balance the excitation, m|ω_m² − ω²|X = F₀",
                self.mass * before * (self.natural.powi(2) - self.speed.powi(2)).abs(),
                force,
            );
        }
        let still = tuned || is_one(sdof::natural_frequency(stiffness, mass).value() / self.speed.value());
        let determinant = absorber::determinant(self.mass, self.stiffness, mass, stiffness, self.speed);
        if still {
            let why = (
                "Motion of the absorber: the main system is at rest, and the force of the spring is opposite to the \
                 excitation",
                RAO.at("§9.11"),
            );
            let by_main = || -force / self.stiffness;
            let what = "the stiffness of the main system used in place of that of the absorber";
            sheet.common_error(motion.absorber_motion(), what, by_main);
            let absorbing = sheet.step(motion.absorber_motion(), unit, -force / stiffness, why);
            sheet.answer("absorber_motion", "Motion of the absorber, along the excitation", absorbing);
            // Where it was tuned, that is how its stiffness or mass was found.
            if !tuned {
                sheet.check_zero(
                    "the main system is at rest",
                    stiffness - mass * self.speed.powi(2),
                    stiffness.value(),
                );
            }
            sheet.check(
                "motion of the absorber from the equations of both masses",
                force * stiffness / determinant,
                absorbing,
            );
            return;
        }
        let scale = stiffness.value().powi(2);
        if determinant.value().abs() <= 1e-12 * scale {
            sheet.warn(|| {
                Text::new("the speed is one of the two resonances: the motion with the absorber grows with time without bound")
            });
            return;
        }
        let why = ("Determinant of the equations of both masses at the speed", RAO.at("§9.11"));
        let determinant = sheet.step("Δ", motion.determinant_unit(), determinant, why);
        let main = force * (stiffness - mass * self.speed.powi(2)) / determinant;
        let why = ("Motion of the main system: negative if opposite to the excitation", RAO.at("§9.11"));
        let together = || force / (self.stiffness - (self.mass + mass) * self.speed.powi(2));
        sheet.common_error(motion.main_motion(), FIXED, together);
        let main = sheet.step(motion.main_motion(), unit, main, why);
        let relative = || force * mass * self.speed.powi(2) / determinant;
        let what = "the motion of the absorber taken relative to the main system";
        sheet.common_error(motion.absorber_motion(), what, relative);
        let why = ("Motion of the absorber: negative if opposite to the excitation", RAO.at("§9.11"));
        let absorbing = sheet.step(motion.absorber_motion(), unit, force * stiffness / determinant, why);
        sheet.answer("main_motion", "Motion of the main system, along the excitation", main);
        sheet.answer("absorber_motion", "Motion of the absorber, along the excitation", absorbing);
        let pulled = self.stiffness * main - self.mass * self.speed.powi(2) * main;
        let spring = stiffness * (absorbing - main);
        let scale = force.value().abs().max(spring.value().abs());
        sheet.check_zero("the forces on the main system balance", pulled - spring - force, scale);
    }
}
