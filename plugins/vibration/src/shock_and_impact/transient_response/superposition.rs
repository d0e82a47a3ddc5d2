//! The displacement at an instant, as a sum of closed forms; the recurrence and Duhamel's integral beside it.

use dalembert_core::{Refusal, Symbol, Worksheet};
use dalembert_mechanics::{Real, vibration::transient::closed};

use super::{
    LoadModel,
    model::{LoadTerm, Unit, Weight},
};
use crate::{
    shared::{
        free_motion::{DampedOscillator, WorkedFreeMotion},
        oscillator::motion::OscillatorMotion,
    },
    sources::{CHOPRA, RAO},
};

/// Parameters of the closed forms.
pub(super) struct Superposition<'m, N> {
    system: DampedOscillator<N>,
    free: WorkedFreeMotion<N>,
    model: &'m LoadModel<N>,
}

/// A moment, and how its numbers are called.
pub(super) struct Instant<N> {
    time: N,
    row: Option<usize>,
}

/// Nearer than this to a pole the closed forms of sine and exponential lose too much.
const NEAR: f64 = 1e-5;

impl<N> Instant<N> {
    /// The `n`th asked time, counted from 1.
    pub(super) fn output_at(time: N, n: usize) -> Self {
        Self { time, row: Some(n) }
    }

    /// The moment of the largest displacement.
    pub(super) fn largest(time: N) -> Self {
        Self { time, row: None }
    }

    /// A symbol at this moment: with its row, or with the index of the largest.
    fn symbol(&self, base: &'static str, largest: &'static str) -> Symbol {
        match self.row {
            Some(n) => Symbol::from(base).row(n),
            None => Symbol::from(largest),
        }
    }
}

impl<'m, N: Real> Superposition<'m, N> {
    /// Writes what the free motion needs.
    pub(super) fn new<W: Worksheet<Num = N>>(
        system: &DampedOscillator<N>,
        model: &'m LoadModel<N>,
        sheet: W,
    ) -> Self {
        Self { system: *system, free: WorkedFreeMotion::new(system, sheet), model }
    }

    /// The displacement at a moment, written as the sum of its terms and compared with the other two ways.
    pub(super) fn displacement<W: Worksheet<Num = N>>(
        &self,
        instant: &Instant<N>,
        sheet: W,
    ) -> Result<N, Refusal> {
        sheet.keep_going()?;
        let time = instant.time.value();
        let exact = self.model.motion.at(time).displacement;
        let motion = self.system.motion;
        let symbol = match motion {
            OscillatorMotion::Translation => instant.symbol("x", "xₘ"),
            OscillatorMotion::Rotation => instant.symbol("θ", "θₘ"),
        };
        let unit = motion.displacement_unit();
        let terms = match &self.model.terms {
            Some(terms) if !self.is_near_a_pole(terms) && time > 0.0 => terms,
            _ => {
                let why = (
                    "Displacement by the exact recurrence over the segments of the load, each linear or sinusoidal",
                    CHOPRA.at("§5.2"),
                );
                let x = sheet.numerical(symbol, unit, exact, why);
                sheet.verify(|| self.hold_to_duhamel(time, x, sheet));
                return Ok(x);
            }
        };
        let mut sum: Option<N> = None;
        let mut scale = 0.0;
        for (n, term) in terms.iter().enumerate() {
            let Some(part) = self.part(term, n + 1, instant, sheet) else { continue };
            scale += part.value().abs();
            sum = Some(match sum {
                None if term.negative => -part,
                None => part,
                Some(sum) if term.negative => sum - part,
                Some(sum) => sum + part,
            });
        }
        let sum = sum.unwrap_or(N::from(0.0));
        let (x, why) = match self.model.size {
            Some(size) => {
                scale *= size.value().abs();
                let why =
                    "Displacement: sum of the responses to the steps, ramps or waves that make up the load";
                (size * sum, (why, RAO.at("§4.5")))
            }
            None => (sum, ("Displacement of the free motion", RAO.at("§2.6"))),
        };
        if instant.row.is_none() {
            self.common_errors(terms, symbol, sheet);
        }
        let x = sheet.step(symbol, unit, x, why);
        sheet.verify(|| {
            let what = "displacement by the exact recurrence over the pieces of the load";
            sheet.check_sum(what, x, exact.into(), scale.max(exact.abs()));
            self.hold_to_duhamel(time, x, sheet);
        });
        Ok(x)
    }

    /// Common errors in the largest displacement.
    fn common_errors<W: Worksheet<Num = N>>(&self, terms: &[LoadTerm<N>], symbol: Symbol, sheet: W) {
        let DampedOscillator { natural, ratio, .. } = self.system;
        if let Some(size) = self.model.size {
            let sudden = || size * 2.0;
            sheet.common_error(
                symbol,
                "the factor 2 of an undamped system under a sudden load taken",
                sudden,
            );
            if let Some(duration) = self.model.duration {
                sheet.common_error(symbol, "the pulse treated as an impulse without duration", || {
                    size * natural * duration * self.model.share().unwrap_or(f64::NAN)
                });
            }
        } else if ratio.value() > 0.0 {
            let part = |term: &LoadTerm<N>| match (&term.unit, &term.weight) {
                (Unit::Impulse, Weight::Times(velocity)) => *velocity / natural,
                (_, Weight::Times(displacement)) => *displacement,
                _ => N::from(f64::NAN),
            };
            sheet.common_error(symbol, "the damping omitted", || {
                N::sum(terms.iter().map(|term| part(term).powi(2))).sqrt()
            });
        }
    }

    /// The size of what is added up at a time, for the rounding of checks.
    pub(super) fn scale(&self, time: f64) -> f64 {
        let static_size = self.model.size.map_or(0.0, |size| size.value().abs());
        let state = self.model.motion.at(time);
        static_size + state.displacement.abs() + self.model.motion.load(time).abs()
    }

    fn hold_to_duhamel<W: Worksheet<Num = N>>(&self, time: f64, x: N, sheet: W) {
        if let Some(integral) = self.model.motion.duhamel(time) {
            let scale = self.scale(time).max(integral.abs());
            sheet.check_sum(
                "displacement by Duhamel's integral, evaluated numerically",
                x,
                integral.into(),
                scale,
            );
        }
    }

    /// Returns true if a sine or exponential is too near a pole of its closed form.
    fn is_near_a_pole(&self, terms: &[LoadTerm<N>]) -> bool {
        let zeta = self.system.ratio.value();
        terms.iter().any(|term| match &term.unit {
            Unit::Sine(_, r) | Unit::Versine(_, r) => {
                let r = r.value();
                (1.0 - r * r).abs() + 2.0 * zeta * r < NEAR * (1.0 + r * r)
            }
            Unit::Exponential(constant) | Unit::Rise(constant) => {
                let rate = 1.0 / (constant.value() * self.system.natural.value());
                ((rate - 2.0 * zeta) * rate + 1.0).abs() < NEAR * (1.0 + rate * rate + 2.0 * zeta * rate)
            }
            _ => false,
        })
    }

    /// A term at a moment, without its sign; `None` before it begins.
    fn part<W: Worksheet<Num = N>>(
        &self,
        term: &LoadTerm<N>,
        n: usize,
        instant: &Instant<N>,
        sheet: W,
    ) -> Option<N> {
        let time = match term.onset {
            None => instant.time,
            Some(onset) if onset.value() >= instant.time.value() => return None,
            Some(onset) => {
                let symbol = instant.symbol("τ", "τₘ").row(n);
                sheet.step(symbol, "s", instant.time - onset, "Time since this part of the load began")
            }
        };
        let DampedOscillator { natural, ratio, .. } = self.system;
        let undamped = self.free.is_undamped();
        let release = || {
            let why = ("Free vibration from a unit displacement, after that time", RAO.at("§2.6"));
            sheet.step(instant.symbol("g", "gₘ").row(n), "1", self.free.release(time), why)
        };
        let impulse = || {
            let why = ("Free vibration from a unit velocity, after that time", RAO.at("§4.5"));
            sheet.step(instant.symbol("h", "hₘ").row(n), "s", self.free.impulse(time), why)
        };
        let unit = match &term.unit {
            Unit::Release => release(),
            Unit::Impulse => impulse(),
            Unit::Step => N::from(1.0) - release(),
            Unit::Ramp if undamped => time - impulse(),
            Unit::Ramp => closed::ramp(natural, ratio, time, release(), impulse()),
            Unit::Sine(frequency, r) if undamped => closed::sine_undamped(*frequency, *r, time, impulse()),
            Unit::Sine(frequency, r) => closed::sine(*frequency, *r, ratio, time, release(), impulse()),
            Unit::Exponential(constant) => {
                closed::exponential(*constant, natural, ratio, time, release(), impulse())
            }
            Unit::Rise(constant) => {
                let release = release();
                N::from(1.0)
                    - release
                    - closed::exponential(*constant, natural, ratio, time, release, impulse())
            }
            Unit::Versine(frequency, r) => {
                let release = release();
                let cosine = closed::cosine(*frequency, *r, ratio, time, release, impulse());
                (N::from(1.0) - release - cosine) / 2.0
            }
            Unit::Parabola => closed::parabola(natural, ratio, time, release(), impulse()),
        };
        Some(match term.weight {
            Weight::One => unit,
            Weight::Times(factor) => factor * unit,
            Weight::Over(divisor) => unit / divisor,
        })
    }
}
