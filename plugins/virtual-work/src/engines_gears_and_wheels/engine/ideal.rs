//! The ideal cycle of an internal-combustion engine.

use std::f64::consts::TAU;

use dalembert_core::{Inputs, Refusal, Worksheet};
use dalembert_mechanics::{
    Real,
    slider_crank::gas::{Corners, Diagram},
};
use dalembert_numerics::gauss_legendre;

use crate::{shared::flywheel::Strokes, sources::KHURMI};

/// Combustion of an ideal cycle.
#[derive(Clone, Debug, Inputs)]
pub enum Combustion {
    /// At constant volume (Otto)
    Otto {
        /// Rise of the pressure.
        peak: PeakPressure,
    },
    /// At constant pressure (Diesel)
    Diesel {
        /// Cut-off.
        cut_off: FuelCutOff,
    },
    /// First at constant volume, then at constant pressure
    Dual {
        /// Rise of the pressure.
        peak: PeakPressure,
        /// Cut-off.
        cut_off: FuelCutOff,
    },
}

/// Pressure after a combustion at constant volume.
#[derive(Clone, Debug, Inputs)]
pub enum PeakPressure {
    /// Maximum pressure
    Pressure {
        /// Maximum pressure.
        #[input("p₃", "kPa", positive)]
        pressure: f64,
    },
    /// Ratio of the pressures
    Ratio {
        /// Pressure after the combustion over that before it.
        #[input("r_p", "1", min = 1)]
        ratio: f64,
    },
}

/// End of a combustion at constant pressure.
#[derive(Clone, Debug, Inputs)]
pub enum FuelCutOff {
    /// Fraction of the stroke
    Stroke {
        /// Fraction of the stroke at the cut-off.
        #[input("ε", "1", positive, max = 1)]
        fraction: f64,
    },
    /// Cut-off ratio
    Ratio {
        /// Cut-off ratio.
        /// Volume at the cut-off over the clearance volume.
        #[input("ρ", "1", min = 1)]
        ratio: f64,
    },
}

/// Pressures over a cycle: a drawn diagram, or the ideal cycle.
pub(super) enum Indicated {
    Drawn(Diagram),
    Ideal(IdealCycle),
}

impl Indicated {
    /// Pressure on the side away from the crankshaft.
    pub(super) fn pressure(&self, angle: f64, fraction: f64, out: bool) -> f64 {
        match self {
            Indicated::Drawn(diagram) => diagram.pressure(angle, fraction, out),
            Indicated::Ideal(cycle) => cycle.pressure(angle, fraction),
        }
    }

    /// Pressure on the other side of a double-acting piston.
    pub(super) fn opposite(&self, angle: f64, fraction: f64, out: bool) -> f64 {
        match self {
            Indicated::Drawn(diagram) => diagram.opposite(angle, fraction, out),
            Indicated::Ideal(cycle) => cycle.numbers.inlet,
        }
    }

    /// Turns of a cycle.
    pub(super) fn turns(&self) -> u8 {
        match self {
            Indicated::Drawn(diagram) => diagram.turns(),
            Indicated::Ideal(cycle) => cycle.turns,
        }
    }

    pub(super) fn corners(&self) -> Corners {
        match self {
            Indicated::Drawn(diagram) => diagram.corners(),
            Indicated::Ideal(cycle) => Corners::Fractions(vec![cycle.cut_off()]),
        }
    }
}

/// An ideal cycle over the crank angle, in Pa; it begins with the combustion.
#[derive(Clone, Debug)]
pub(super) struct IdealCycle {
    numbers: WorkedCycle<f64>,
    turns: u8,
    /// Crank angles of the dead centres: away from the crankshaft, and towards it.
    dead_centres: [f64; 2],
}

/// The stroke that a crank angle falls in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum EngineStroke {
    Expansion,
    Compression,
    Exchange,
}

impl IdealCycle {
    /// Fraction of the stroke at the cut-off; zero without a combustion at constant pressure.
    fn cut_off(&self) -> f64 {
        self.numbers.cut_off.unwrap_or(0.0)
    }

    pub(super) fn stroke(&self, angle: f64) -> EngineStroke {
        // What rounding leaves before a dead centre belongs to the stroke after it.
        let [outer, inner] = self.dead_centres;
        let turns = f64::from(self.turns);
        let gone = (angle - outer + 1e-9).rem_euclid(turns * TAU);
        let is_out = gone.rem_euclid(TAU) < inner - outer + 1e-9;
        match (gone < TAU, is_out) {
            (true, true) => EngineStroke::Expansion,
            (true, false) if self.turns == 1 => EngineStroke::Compression,
            (false, false) => EngineStroke::Compression,
            _ => EngineStroke::Exchange,
        }
    }

    fn pressure(&self, angle: f64, fraction: f64) -> f64 {
        self.numbers.pressure_in(self.stroke(angle), fraction.clamp(0.0, 1.0)).0
    }

    /// Mean effective pressure by the area of the diagram, strip by strip, and the size of what is added up.
    pub(super) fn area(&self) -> [f64; 2] {
        let WorkedCycle { inlet, peak, clearance, exponents: [compression, expansion], .. } = self.numbers;
        let (end, cut_off) = (1.0 + clearance, self.cut_off());
        // Over the logarithm of the volume a polytropic is smooth, whatever its exponent.
        let under = |from: f64, exponent: f64, pressure: f64| {
            let grown = (end / from).ln();
            grown
                * gauss_legendre::integral(24, |part| {
                    let volume = from * (part * grown).exp();
                    volume * pressure * (from / volume).powf(exponent)
                })
        };
        let first = inlet * (end / clearance).powf(compression);
        let work = under(cut_off + clearance, expansion, peak) + peak * cut_off;
        let spent = under(clearance, compression, first);
        [work - spent, work + spent]
    }
}

/// An ideal cycle in absolute pressures; volumes in parts of the swept volume.
#[derive(Clone, Copy, Debug)]
pub(super) struct WorkedCycle<N> {
    inlet: N,
    peak: N,
    /// Fraction of the stroke at the cut-off, where the combustion goes on at constant pressure.
    cut_off: Option<N>,
    clearance: N,
    exponents: [N; 2],
    compressed: N,
}

/// Numbers that an ideal cycle is made from, in absolute pressures.
pub(super) struct CycleData<'a, W: Worksheet> {
    pub inlet: W::Num,
    pub ratio: W::Num,
    pub exponents: [W::Num; 2],
    pub combustion: &'a CombustionGiven<W>,
    /// From a pressure as it is typed to an absolute one.
    pub absolute: &'a dyn Fn(&'static str, W::Num) -> W::Num,
}

impl<N: Real> WorkedCycle<N> {
    pub(super) fn work<W: Worksheet<Num = N>>(data: &CycleData<'_, W>, sheet: W) -> Result<Self, Refusal> {
        let one = || N::from(1.0);
        let &CycleData { inlet, ratio, exponents, combustion, absolute } = data;
        let clearance = sheet.step(
            "κ",
            "1",
            one() / (ratio - 1.0),
            "Clearance volume over the swept volume, from the compression ratio",
        );
        let compressed = sheet.step(
            "p₂′",
            "kPa",
            inlet * ratio.pow(exponents[0]),
            ("Absolute pressure at the end of the compression", KHURMI.at("ch. 15")),
        );
        sheet.answer("compression_pressure", "Absolute pressure after the compression", compressed);
        let peak = |peak: &PeakPressureGiven<W>| match *peak {
            PeakPressureGiven::Pressure { pressure } => absolute("p₃′", pressure),
            PeakPressureGiven::Ratio { ratio } => {
                sheet.step("p₃′", "kPa", compressed * ratio, "Absolute pressure after the combustion")
            }
        };
        let cut_off = |cut_off: &FuelCutOffGiven<W>| match *cut_off {
            FuelCutOffGiven::Stroke { fraction } => fraction,
            FuelCutOffGiven::Ratio { ratio } => sheet.step(
                "ε",
                "1",
                (ratio - 1.0) * clearance,
                "Fraction of the stroke at the cut-off, from the cut-off ratio",
            ),
        };
        let (peak, cut_off) = match combustion {
            CombustionGiven::Otto { peak: given } => (peak(given), None),
            CombustionGiven::Diesel { cut_off: given } => (compressed, Some(cut_off(given))),
            CombustionGiven::Dual { peak: first, cut_off: given } => (peak(first), Some(cut_off(given))),
        };
        if peak.value() < compressed.value() * (1.0 - 1e-9) {
            return Err(Refusal::because(
                "the maximum pressure lies below that of the compression: write a larger maximum pressure, or a smaller compression ratio",
            ));
        }
        if cut_off.is_some_and(|fraction| fraction.value() > 1.0) {
            return Err(Refusal::because(
                "the cut-off lies beyond the end of the stroke: the cut-off ratio must not be above the compression ratio",
            ));
        }
        if !matches!(combustion, CombustionGiven::Diesel { .. }) {
            sheet.answer("peak_pressure", "Maximum absolute pressure", peak);
        }
        Ok(Self { inlet, peak, cut_off, clearance, exponents, compressed })
    }

    pub(super) fn plain(&self, strokes: Strokes, dead_centres: [f64; 2]) -> IdealCycle {
        let numbers = WorkedCycle {
            inlet: self.inlet.value(),
            peak: self.peak.value(),
            cut_off: self.cut_off.map(Real::value),
            clearance: self.clearance.value(),
            exponents: self.exponents.map(Real::value),
            compressed: self.compressed.value(),
        };
        IdealCycle { numbers, turns: strokes.turns(), dead_centres }
    }

    /// The absolute pressure at a fraction of the stroke.
    pub(super) fn pressure<W: Worksheet<Num = N>>(&self, stroke: EngineStroke, fraction: N, sheet: W) -> N {
        let (value, why) = self.pressure_in(stroke, fraction);
        sheet.step("p′", "kPa", value, (why, KHURMI.at("ch. 15")))
    }

    /// The same, with the reason of the formula.
    fn pressure_in(&self, stroke: EngineStroke, fraction: N) -> (N, &'static str) {
        let [compression, expansion] = self.exponents;
        let volume = fraction + self.clearance;
        match stroke {
            EngineStroke::Exchange => (self.inlet, "Suction and exhaust: the pressure of the inlet"),
            EngineStroke::Compression => (
                self.inlet * ((self.clearance + 1.0) / volume).pow(compression),
                "Compression from the end of the stroke, p vᵏ constant",
            ),
            EngineStroke::Expansion => match self.cut_off {
                Some(cut_off) if fraction.value() <= cut_off.value() => {
                    (self.peak, "Combustion at constant pressure, before the cut-off")
                }
                Some(cut_off) => (
                    self.peak * ((cut_off + self.clearance) / volume).pow(expansion),
                    "Expansion from the cut-off, p vᵏ constant",
                ),
                None => (
                    self.peak * (self.clearance / volume).pow(expansion),
                    "Expansion from the dead centre, p vᵏ constant",
                ),
            },
        }
    }

    /// Answers mean effective pressure and work of a cycle.
    pub(super) fn answer_work<W: Worksheet<Num = N>>(&self, swept: N, plain: &IdealCycle, sheet: W) {
        let end = self.clearance + 1.0;
        // ∫ p dv of p vᵏ from a pressure and a volume to the end of the stroke.
        let under = |pressure: N, from: N, exponent: N| {
            if (exponent.value() - 1.0).abs() > 1e-6 {
                let less = exponent - 1.0;
                pressure * from / less * (N::from(1.0) - (from / end).pow(less))
            } else {
                pressure * from * (end / from).ln()
            }
        };
        let from = self.cut_off.map_or(self.clearance, |cut_off| cut_off + self.clearance);
        let expansion = sheet.step(
            "w₂",
            "kPa",
            under(self.peak, from, self.exponents[1]),
            "Work of the expansion over the swept volume",
        );
        let first = self.inlet * (end / self.clearance).pow(self.exponents[0]);
        let compression = sheet.step(
            "w₁",
            "kPa",
            under(first, self.clearance, self.exponents[0]),
            "Work of the compression over the swept volume",
        );
        let mean = match self.cut_off {
            Some(cut_off) => self.peak * cut_off + expansion - compression,
            None => expansion - compression,
        };
        let mean =
            sheet.step("p_m", "kPa", mean, "Mean effective pressure: work of a cycle over the swept volume");
        let work = sheet.step("W_G", "J", mean * swept, "Work of the gas in a cycle");
        sheet.answer("mean_pressure", "Mean effective pressure", mean);
        sheet.answer("cycle_work", "Work of the gas per cycle", work);
        sheet.verify(|| {
            let [done, size] = plain.area();
            let what = "mean effective pressure as the area of the diagram, strip by strip";
            sheet.check_sum(what, mean, done.into(), size);
            let volume = swept.value();
            let what = "work of the gas as the area of its diagram, strip by strip";
            sheet.check_sum(what, work, (volume * done).into(), volume * size);
            let [outer, inner] = plain.dead_centres;
            let what = "pressure at the end of the compression, from the volumes";
            sheet.check(what, self.compressed, plain.pressure(outer - 1e-6, 0.0).into());
            // Back from the end of the expansion.
            let WorkedCycle { clearance, exponents: [_, exponent], .. } = plain.numbers;
            let grown = ((1.0 + clearance) / (plain.cut_off() + clearance)).powf(exponent);
            let what = "maximum pressure, back from the end of the expansion";
            sheet.check(what, self.peak, (plain.pressure(inner - 1e-6, 1.0) * grown).into());
        });
    }
}
