//! Gas pressure on the piston.

use dalembert_core::{Inputs, Refusal, Text, Worksheet};
use dalembert_mechanics::{
    Real, section,
    slider_crank::{
        engine::EngineCylinder,
        gas::{self, Diagram},
        piston,
    },
};
use dalembert_numerics::gauss_legendre;

use super::{
    ideal::{Combustion, CycleData, Indicated, WorkedCycle},
    motion::{Lengths, PistonState},
};
use crate::{shared::flywheel::Strokes, sources::KHURMI};

/// The force on the piston towards the crank, and what is known of it.
#[derive(Clone, Debug, Inputs)]
pub enum Gas {
    /// No force
    Nothing,
    /// Force given
    Force {
        /// Force on the piston.
        /// Towards the crank; at this crank angle.
        #[input("F_G", "N")]
        force: f64,
    },
    /// Sought: the force for a turning moment
    Balancing {
        /// Turning moment of the engine.
        /// Torque to be held or driven, in the sense of rotation.
        #[input("M", "N*m")]
        moment: f64,
    },
    /// Pressures at this crank angle
    Pressures {
        /// Bore.
        #[input("D", "mm", positive)]
        bore: f64,
        /// Pressure.
        /// On the side opposite to the crankshaft.
        #[input("p₁", "kPa")]
        pressure: f64,
        /// Other side of the piston.
        behind: Behind,
        /// Pressure reference.
        datum: Datum,
    },
    /// Admission, cut-off and expansion
    /// Of a steam engine, over the whole cycle.
    Expansion {
        /// Bore.
        #[input("D", "mm", positive)]
        bore: f64,
        /// Working sides of the piston.
        acting: Acting,
        /// Admission pressure.
        #[input("p_a", "kPa")]
        admission: f64,
        /// Exhaust pressure.
        #[input("p_b", "kPa")]
        exhaust: f64,
        /// Cut-off.
        /// Fraction of the stroke during which the cylinder is filled.
        #[input("ε", "1", positive, max = 1)]
        cut_off: f64,
        /// Clearance.
        /// Clearance volume at the dead centre divided by the swept volume.
        #[input("κ", "1", nonnegative, max = 1, default = "0")]
        clearance: f64,
        /// Expansion law.
        law: ExpansionLaw,
        /// Pressure reference.
        datum: Datum,
    },
    /// Ideal cycle: Otto, Diesel
    /// Of an internal-combustion engine. The crank angle counts from the dead centre of the combustion; suction and
    /// exhaust are at the pressure of the inlet.
    Cycle {
        /// Bore.
        #[input("D", "mm", positive)]
        bore: f64,
        /// Strokes of a cycle.
        strokes: Strokes,
        /// Compression ratio.
        #[input("r_v", "1", above = 1, max = 100)]
        ratio: f64,
        /// Pressure of the inlet.
        #[input("p₁", "kPa")]
        inlet: f64,
        /// Exponent of the compression.
        #[input("k_c", "1", positive, max = 3)]
        compression: f64,
        /// Exponent of the expansion.
        #[input("k_e", "1", positive, max = 3)]
        expansion: f64,
        /// Combustion.
        combustion: Combustion,
        /// Pressure reference.
        datum: Datum,
    },
    /// Indicator diagram over the stroke
    Stroke {
        /// Bore.
        #[input("D", "mm", positive)]
        bore: f64,
        /// Working sides of the piston.
        acting: Acting,
        /// Pressures.
        /// Linear interpolation between the rows.
        #[input(table)]
        rows: Vec<StrokeRow>,
        /// Pressure reference.
        datum: Datum,
    },
    /// Indicator diagram over the crank angle
    Angle {
        /// Bore.
        #[input("D", "mm", positive)]
        bore: f64,
        /// Strokes of a cycle.
        strokes: Strokes,
        /// Pressures.
        /// Linear interpolation between the rows.
        #[input(table)]
        rows: Vec<AngleRow>,
        /// Pressure reference.
        datum: Datum,
    },
}

/// Pressure on the crank side of the piston.
#[derive(Clone, Debug, Inputs)]
pub enum Behind {
    /// The atmosphere
    Atmosphere,
    /// A pressure
    Pressure {
        /// Pressure.
        /// On the side towards the crankshaft.
        #[input("p₂", "kPa")]
        pressure: f64,
        /// Diameter of the piston rod.
        #[input("d_p", "mm", nonnegative, default = "0 mm")]
        rod: f64,
    },
}

/// Single or double acting.
#[derive(Clone, Debug, Inputs)]
pub enum Acting {
    /// Single acting
    /// Atmospheric pressure acts on the side towards the crankshaft.
    Single,
    /// Double acting
    /// The same on both sides, half a revolution apart.
    Double {
        /// Diameter of the piston rod.
        #[input("d_p", "mm", nonnegative, default = "0 mm")]
        rod: f64,
    },
}

/// Datum of pressures: absolute or gauge.
#[derive(Clone, Debug, Inputs)]
pub enum Datum {
    /// The atmosphere: gauge pressures
    Gauge {
        /// Atmospheric pressure.
        #[input("p₀", "kPa", nonnegative, default = "101.325 kPa")]
        atmosphere: f64,
    },
    /// Vacuum: absolute pressures
    Absolute {
        /// Atmospheric pressure.
        #[input("p₀", "kPa", nonnegative, default = "101.325 kPa")]
        atmosphere: f64,
    },
}

/// The law of an expansion.
#[derive(Clone, Debug, Inputs)]
pub enum ExpansionLaw {
    /// Hyperbolic, p v constant
    Hyperbolic,
    /// Polytropic, p vᵏ constant
    Polytropic {
        /// Exponent.
        #[input("k", "1", positive, max = 3)]
        exponent: f64,
    },
}

/// A row of an indicator diagram over the stroke.
#[derive(Clone, Debug, Inputs)]
pub struct StrokeRow {
    /// Fraction of the stroke.
    #[input("s/S", "1", nonnegative, max = 1)]
    pub fraction: f64,
    /// Pressure on the stroke towards the crankshaft.
    #[input("p_out", "kPa")]
    pub out: f64,
    /// Pressure on the return stroke.
    #[input("p_back", "kPa")]
    pub back: f64,
}

/// A row of an indicator diagram over the crank angle.
#[derive(Clone, Debug, Inputs)]
pub struct AngleRow {
    /// Crank angle.
    #[input("θ", "deg")]
    pub angle: f64,
    /// Pressure.
    #[input("p", "kPa")]
    pub pressure: f64,
}

/// The gas over a whole cycle, in absolute pressures.
pub(super) struct GasCycle {
    pub diagram: Indicated,
    pub area: f64,
    /// Of the side towards the crank, where it works too.
    pub crank_side: Option<f64>,
    pub atmosphere: f64,
}

impl GasCycle {
    /// Force towards the crank.
    pub(super) fn force(&self, angle: f64, fraction: f64, out: bool) -> f64 {
        let cover = self.diagram.pressure(angle, fraction, out) - self.atmosphere;
        let crank = self
            .crank_side
            .map_or(0.0, |area| area * (self.diagram.opposite(angle, fraction, out) - self.atmosphere));
        cover * self.area - crank
    }
}

/// Force on the piston towards the crank, and the cylinder where its whole cycle is known; nothing where nothing
/// pushes, or where the force is sought.
pub(super) fn force<W: Worksheet>(
    problem: &Gas,
    given: &GasGiven<W>,
    lengths: &Lengths<W::Num>,
    moving: &PistonState<W::Num>,
    kernel: &EngineCylinder,
    sheet: W,
) -> Result<Option<(W::Num, Option<GasCycle>)>, Refusal> {
    let stroke = kernel.stroke();
    match (problem, given) {
        (Gas::Force { .. }, GasGiven::Force { force }) => Ok(Some((*force, None))),
        (_, GasGiven::Pressures { bore, pressure, behind, datum }) => {
            let area = piston_area(*bore, sheet);
            let gauge = |symbol, pressure: W::Num| match datum {
                DatumGiven::Gauge { .. } => pressure,
                DatumGiven::Absolute { atmosphere } => {
                    sheet.step(symbol, "kPa", pressure - *atmosphere, "Gauge pressure")
                }
            };
            let pressure = gauge("p₁′", *pressure);
            let force = match behind {
                BehindGiven::Atmosphere { .. } => pressure * area,
                BehindGiven::Pressure { pressure: other, rod } => {
                    let crank_side = crank_side_area(*bore, *rod, sheet)?;
                    gas::force(pressure, area, gauge("p₂′", *other), crank_side)
                }
            };
            Ok(Some((of_gas(force, sheet), None)))
        }
        (
            Gas::Expansion { .. },
            GasGiven::Expansion { bore, acting, admission, exhaust, cut_off, clearance, law, datum },
        ) => {
            let absolute = |symbol, pressure: W::Num| match datum {
                DatumGiven::Gauge { atmosphere } => {
                    sheet.step(symbol, "kPa", pressure + *atmosphere, "Absolute pressure")
                }
                DatumGiven::Absolute { .. } => pressure,
            };
            let (admission, exhaust) = (absolute("p_a′", *admission), absolute("p_b′", *exhaust));
            if admission.value() < 0.0 || exhaust.value() < 0.0 {
                return Err(Refusal::because(
                    "an absolute pressure is negative: write gauge pressures not below minus the atmospheric pressure, or choose absolute pressures",
                ));
            }
            let exponent = match law {
                ExpansionLawGiven::Hyperbolic { .. } => None,
                ExpansionLawGiven::Polytropic { exponent } => Some(*exponent),
            };
            let diagram = Diagram::Expansion {
                admission: admission.value(),
                exhaust: exhaust.value(),
                cut_off: cut_off.value(),
                clearance: clearance.value(),
                exponent: exponent.map_or(1.0, Real::value),
            };
            let steam = Steam { admission, exhaust, cut_off: *cut_off, clearance: *clearance, exponent };
            let (area, crank_side) = areas(*bore, acting, sheet)?;
            let force = steam.force(
                lengths,
                moving,
                [area, crank_side.unwrap_or(0.0.into())],
                crank_side.is_some(),
                (datum, &diagram),
                sheet,
            );
            let atmosphere = of_datum(datum);
            let cylinder = GasCycle {
                diagram: Indicated::Drawn(diagram),
                area: area.value(),
                crank_side: crank_side.map(Real::value),
                atmosphere: atmosphere.value(),
            };
            Ok(Some((force, Some(cylinder))))
        }
        (
            Gas::Cycle { strokes, .. },
            GasGiven::Cycle { bore, ratio, inlet, compression, expansion, combustion, datum, .. },
        ) => {
            let absolute = |symbol, pressure: W::Num| match datum {
                DatumGiven::Gauge { atmosphere } => {
                    sheet.step(symbol, "kPa", pressure + *atmosphere, "Absolute pressure")
                }
                DatumGiven::Absolute { .. } => pressure,
            };
            let inlet = absolute("p₁′", *inlet);
            if inlet.value() <= 0.0 {
                return Err(Refusal::because(
                    "the absolute pressure of the inlet must be above zero: write a gauge pressure above minus the atmospheric pressure, or choose absolute pressures",
                ));
            }
            let area = piston_area(*bore, sheet);
            let data = CycleData {
                inlet,
                ratio: *ratio,
                exponents: [*compression, *expansion],
                combustion,
                absolute: &absolute,
            };
            let worked = WorkedCycle::work(&data, sheet)?;
            let plain = worked.plain(*strokes, kernel.dead_centres());
            let swept = length_of_stroke(lengths);
            let fraction = fraction_of_stroke(moving, swept, sheet);
            let pressure = worked.pressure(plain.stroke(moving.angle.value()), fraction, sheet);
            let atmosphere = of_datum(datum);
            let force = of_gas((pressure - atmosphere) * area, sheet);
            worked.answer_work(area * swept, &plain, sheet);
            let cylinder = GasCycle {
                diagram: Indicated::Ideal(plain),
                area: area.value(),
                crank_side: None,
                atmosphere: atmosphere.value(),
            };
            Ok(Some((force, Some(cylinder))))
        }
        (Gas::Stroke { rows, .. }, GasGiven::Stroke { bore, acting, datum, .. }) => {
            let (area, crank_side) = areas(*bore, acting, sheet)?;
            let diagram = stroke_diagram(rows, above(datum))?;
            Ok(Some(from_diagram(diagram, area, crank_side, datum, moving, stroke, sheet)))
        }
        (Gas::Angle { rows, strokes, .. }, GasGiven::Angle { bore, datum, .. }) => {
            let area = piston_area(*bore, sheet);
            let diagram = angle_diagram(rows, *strokes, above(datum))?;
            Ok(Some(from_diagram(diagram, area, None, datum, moving, stroke, sheet)))
        }
        _ => Ok(None),
    }
}

/// Steam over a cycle, in absolute pressures.
struct Steam<N> {
    admission: N,
    exhaust: N,
    cut_off: N,
    clearance: N,
    exponent: Option<N>,
}

impl<N: Real> Steam<N> {
    fn force<W: Worksheet<Num = N>>(
        &self,
        lengths: &Lengths<N>,
        moving: &PistonState<N>,
        [area, crank_side_area]: [N; 2],
        double: bool,
        (datum, diagram): (&DatumGiven<W>, &Diagram),
        sheet: W,
    ) -> N {
        let stroke = length_of_stroke(lengths);
        let fraction = fraction_of_stroke(moving, stroke, sheet);
        let out = moving.arm.value() >= 0.0;
        let cover = self.pressure("p₁", fraction, out, sheet);
        let atmosphere = of_datum(datum);
        let force = if double {
            let way = || N::from(1.0) - fraction;
            let crank = self.pressure("p₂", way(), !out, sheet);
            gas::force(cover - atmosphere, area, crank - atmosphere, crank_side_area)
        } else {
            (cover - atmosphere) * area
        };
        let areas = if double { area + crank_side_area } else { area };
        self.work(areas * stroke, diagram, sheet);
        of_gas(force, sheet)
    }

    /// The pressure on a side of the piston that has gone a part of its way from that side's end.
    fn pressure<W: Worksheet<Num = N>>(&self, symbol: &'static str, gone: N, out: bool, sheet: W) -> N {
        if !out {
            let why = if symbol == "p₁" {
                "Exhaust on the side away from the crankshaft"
            } else {
                "Exhaust on the side towards the crankshaft"
            };
            return sheet.step(symbol, "kPa", self.exhaust, why);
        }
        if gone.value() <= self.cut_off.value() {
            return sheet.step(symbol, "kPa", self.admission, "Before the cut-off: full admission pressure");
        }
        let filled = self.clearance.value() != 0.0;
        let with_clearance = |part: N| if filled { part + self.clearance } else { part };
        let (from, to) = (with_clearance(self.cut_off), with_clearance(gone));
        let pressure = match self.exponent {
            None => gas::expanded_hyperbolically(self.admission, from, to),
            Some(exponent) => gas::expanded(self.admission, from, to, exponent),
        };
        sheet.step(symbol, "kPa", pressure, ("After the cut-off the steam expands", KHURMI.at("ch. 15")))
    }

    /// Mean effective pressure and work of a turn, in which the working sides displace a volume.
    fn work<W: Worksheet<Num = N>>(&self, displaced: N, diagram: &Diagram, sheet: W) {
        let clearance = Some(self.clearance).filter(|clearance| clearance.value() != 0.0);
        let mean = match self.exponent {
            Some(exponent) if (exponent.value() - 1.0).abs() > 1e-6 => {
                gas::mean_pressure(self.admission, self.cut_off, clearance, exponent, self.exhaust)
            }
            _ => gas::mean_pressure_hyperbolic(self.admission, self.cut_off, clearance, self.exhaust),
        };
        let mean = sheet.step(
            "p_m",
            "kPa",
            mean,
            "Mean effective pressure: work per stroke over its volume, less the back pressure",
        );
        sheet.answer("mean_pressure", "Mean effective pressure", mean);
        let work = sheet.step("W_G", "J", mean * displaced, "Work of the steam per revolution");
        sheet.answer("indicated_work", "Work of the gas per revolution", work);
        sheet.verify(|| {
            let (filled, clearance) = (self.cut_off.value() + self.clearance.value(), self.clearance.value());
            // Over the logarithm of the volume an expansion is smooth, whatever its exponent.
            let grown = ((1.0 + clearance) / filled).ln();
            let strip = |part: f64| {
                let volume = filled * (part * grown).exp();
                volume * diagram.pressure(0.0, volume - clearance, true)
            };
            let expansion = grown * gauss_legendre::integral(24, strip);
            let admission = self.cut_off.value() * diagram.pressure(0.0, 0.0, true);
            let exhaust = diagram.pressure(0.0, 0.5, false);
            let volume = displaced.value();
            let (done, size) = (admission + expansion - exhaust, admission + expansion + exhaust);
            let what = "work of the gas as the area of its diagram, strip by strip";
            sheet.check_sum(what, work, (volume * done).into(), volume * size);
        });
    }
}

fn length_of_stroke<N: Real>(lengths: &Lengths<N>) -> N {
    match lengths.offset {
        None => lengths.crank * 2.0,
        Some(offset) => {
            piston::farthest(lengths.crank, lengths.rod, offset)
                - piston::nearest(lengths.crank, lengths.rod, offset)
        }
    }
}

fn fraction_of_stroke<W: Worksheet>(moving: &PistonState<W::Num>, stroke: W::Num, sheet: W) -> W::Num {
    let harmonic = || (W::Num::from(1.0) - moving.angle.cos()) / 2.0;
    sheet.common_error("ξ", "the obliquity of the rod neglected, (1 − cos θ)/2 used", harmonic);
    sheet.step("ξ", "1", moving.displacement / stroke, "Fraction of the stroke travelled by the piston")
}

fn of_datum<W: Worksheet>(datum: &DatumGiven<W>) -> W::Num {
    match datum {
        DatumGiven::Gauge { atmosphere } | DatumGiven::Absolute { atmosphere } => *atmosphere,
    }
}

/// Offset from the typed pressures to absolute ones.
fn above<W: Worksheet>(datum: &DatumGiven<W>) -> f64 {
    match datum {
        DatumGiven::Gauge { atmosphere } => atmosphere.value(),
        DatumGiven::Absolute { .. } => 0.0,
    }
}

fn stroke_diagram(rows: &[StrokeRow], above: f64) -> Result<Diagram, Refusal> {
    if rows.len() < 2 || rows.windows(2).any(|pair| pair[0].fraction >= pair[1].fraction) {
        return Err(Refusal::because(
            "the indicator diagram needs at least two rows in ascending order of the fraction of stroke, from 0 to 1",
        ));
    }
    Ok(Diagram::Stroke(rows.iter().map(|row| [row.fraction, row.out + above, row.back + above]).collect()))
}

fn angle_diagram(rows: &[AngleRow], strokes: Strokes, above: f64) -> Result<Diagram, Refusal> {
    let turns = strokes.turns();
    let period = std::f64::consts::TAU * f64::from(turns);
    let (first, last) = match rows {
        [first, .., last] => (first.angle, last.angle),
        _ => (0.0, f64::INFINITY),
    };
    let ascending = rows.windows(2).all(|pair| pair[0].angle < pair[1].angle);
    if !ascending || last - first > period * (1.0 + 1e-9) {
        return Err(Refusal::because(
            "the indicator diagram needs at least two rows in ascending order of crank angle, within one cycle",
        ));
    }
    let rows = rows.iter().map(|row| [row.angle, row.pressure + above]).collect();
    Ok(Diagram::Angle { rows, turns })
}

fn from_diagram<W: Worksheet>(
    diagram: Diagram,
    area: W::Num,
    crank_side: Option<W::Num>,
    datum: &DatumGiven<W>,
    moving: &PistonState<W::Num>,
    stroke: f64,
    sheet: W,
) -> (W::Num, Option<GasCycle>) {
    let atmosphere = of_datum(datum).value();
    let (angle, fraction) = (moving.angle.value(), moving.displacement.value() / stroke);
    let out = moving.arm.value() >= 0.0;
    let read = |symbol, absolute: f64| {
        sheet.numerical(
            symbol,
            "kPa",
            absolute - atmosphere,
            "Gauge pressure, read from the diagram between its rows",
        )
    };
    let cover = read("p₁", diagram.pressure(angle, fraction, out));
    let force = match crank_side {
        Some(other) => gas::force(cover, area, read("p₂", diagram.opposite(angle, fraction, out)), other),
        None => cover * area,
    };
    let force = of_gas(force, sheet);
    let cylinder = GasCycle {
        diagram: Indicated::Drawn(diagram),
        area: area.value(),
        crank_side: crank_side.map(Real::value),
        atmosphere,
    };
    (force, Some(cylinder))
}

fn of_gas<W: Worksheet>(force: W::Num, sheet: W) -> W::Num {
    sheet.step("F_G", "N", force, ("Force of the gas on the piston, towards the crank", KHURMI.at("ch. 15")))
}

fn piston_area<W: Worksheet>(bore: W::Num, sheet: W) -> W::Num {
    sheet.step("A₁", "mm^2", section::round_area(bore), "Area of the piston")
}

fn crank_side_area<W: Worksheet>(bore: W::Num, rod: W::Num, sheet: W) -> Result<W::Num, Refusal> {
    if rod.value() >= bore.value() {
        return Err(Refusal::because(
            Text::new("the piston rod of {rod} fills the whole bore of {bore}: reduce its diameter")
                .with_quantity("rod", rod.value(), "mm")
                .with_quantity("bore", bore.value(), "mm"),
        ));
    }
    let area = if rod.value() == 0.0 { section::round_area(bore) } else { section::tube_area(bore, rod) };
    Ok(sheet.step("A₂", "mm^2", area, "Area of the piston on the side towards the crankshaft"))
}

fn areas<W: Worksheet>(
    bore: W::Num,
    acting: &ActingGiven<W>,
    sheet: W,
) -> Result<(W::Num, Option<W::Num>), Refusal> {
    let area = piston_area(bore, sheet);
    let crank_side = match acting {
        ActingGiven::Single { .. } => None,
        ActingGiven::Double { rod } => Some(crank_side_area(bore, *rod, sheet)?),
    };
    Ok((area, crank_side))
}
