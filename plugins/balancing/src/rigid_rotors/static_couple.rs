//! Static and couple parts of what two sensors read, or of weights in two planes.

use dalembert_core::{About, Analysis, Drawing, Exhibit, Ink, Inputs, Refusal, Worksheet, register};
use dalembert_mechanics::{
    Real,
    balance::{self, Phasor},
};

use crate::{
    shared::{reading::SensorReading, rotor, views::dial},
    sources::RIUL,
};

/// Two vectors.
#[derive(Clone, Debug, Inputs)]
pub struct StaticCouple {
    /// Vectors to decompose.
    pub vectors: Vectors,
}

/// Readings of two bearings, or weights in two planes.
#[derive(Clone, Debug, Inputs)]
pub enum Vectors {
    /// Readings of two bearings
    #[input(formerly = "displacement|velocity|acceleration|number")]
    Readings {
        /// First bearing.
        #[input("1")]
        first: SensorReading,
        /// Second bearing.
        #[input("2")]
        second: SensorReading,
    },
    /// Weights in two planes, at the same radius
    Weights {
        /// First plane.
        #[input("1")]
        first: PlaneWeight,
        /// Second plane.
        #[input("2")]
        second: PlaneWeight,
    },
}

/// A weight in a plane.
#[derive(Clone, Debug, Inputs)]
pub struct PlaneWeight {
    /// Weight.
    #[input("m", "g", nonnegative)]
    pub mass: f64,
    /// Angle.
    #[input("θ", "deg")]
    pub angle: f64,
}

register!(StaticCouple);

const SPEEDS: &str = "the two readings were taken at different speeds; read both in one run";

impl Analysis for StaticCouple {
    const ABOUT: About = About {
        id: "balancing/static-couple",
        title: "Static and couple components of two readings",
        topic: "Rigid rotors",
        summary: "Static component (common to two bearings or planes) and couple component (opposite in them), from two vectors.",
        main: &["static", "static_angle", "couple", "couple_angle"],
        keywords: "decomposição estático-conjugado parcela estática parcela de conjugado static couple derived in phase out of phase modal",
        sources: &[&RIUL],
        cases: include_str!("../../cases/static_couple.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &StaticCoupleGiven<W>, sheet: W) -> Result<(), Refusal> {
        let unit = match &self.vectors {
            Vectors::Readings { first, second } => {
                if let (Some(one), Some(other)) = (first.speed, second.speed)
                    && (one - other).abs() > 0.01 * one
                {
                    return Err(Refusal::because(SPEEDS));
                }
                first.amplitude.unit
            }
            Vectors::Weights { .. } => "g",
        };
        let (first, second) = match &given.vectors {
            VectorsGiven::Readings { first, second } => {
                ((first.amplitude, first.phase), (second.amplitude, second.phase))
            }
            VectorsGiven::Weights { first, second } => {
                ((first.mass, first.angle), (second.mass, second.angle))
            }
        };
        let symbols = match self.vectors {
            Vectors::Readings { .. } => ["A₁ ∠ φ₁", "A₂ ∠ φ₂"],
            Vectors::Weights { .. } => ["m₁ ∠ θ₁", "m₂ ∠ θ₂"],
        };
        decompose((unit, symbols), first, second, sheet)
    }
}

fn decompose<W: Worksheet>(
    (unit, symbols): (&'static str, [&'static str; 2]),
    first: (W::Num, W::Num),
    second: (W::Num, W::Num),
    sheet: W,
) -> Result<(), Refusal> {
    let scale = first.0.value() + second.0.value();
    if scale == 0.0 {
        return Err(Refusal::because("both vectors are 0, so there is nothing to decompose"));
    }
    let component =
        |symbol: &'static str, value: W::Num| sheet.step(symbol, unit, value, "Component of the vector");
    let vector = |[x, y]: [&'static str; 2], (size, angle): (W::Num, W::Num)| {
        let polar = Phasor::polar(size, angle);
        Phasor { x: component(x, polar.x), y: component(y, polar.y) }
    };
    let one = vector(["V_1x", "V_1y"], first);
    let two = vector(["V_2x", "V_2y"], second);
    let why = "Static component: half the sum of the vectors";
    let common = Phasor {
        x: sheet.step("S_x", unit, balance::static_part(one.x, two.x), why),
        y: sheet.step("S_y", unit, balance::static_part(one.y, two.y), why),
    };
    let why =
        "Couple component: half the difference of the vectors; shown for the first, opposite in the second";
    let opposite = Phasor {
        x: sheet.step("C_x", unit, balance::couple_part(one.x, two.x), why),
        y: sheet.step("C_y", unit, balance::couple_part(one.y, two.y), why),
    };
    rotor::parts_of_sizes(sheet, ["S", "C", "σ"], || [first, second]);
    let size = sheet.step("S", unit, common.size(), "Magnitude of the static component");
    sheet.answer("static", "Static component", size);
    let couple = sheet.step("C", unit, opposite.size(), "Magnitude of the couple component");
    sheet.answer("couple", "Couple component", couple);
    // A part that is only rounding has no direction.
    let mut polar = [Phasor { x: W::Num::from(0.0), y: W::Num::from(0.0) }; 2];
    if size.value() > 1e-12 * scale {
        rotor::quadrant_ignored(sheet, "σ", (common.x, common.y));
        let angle = sheet.step("σ", "deg", common.marked_angle(), "Its angle");
        sheet.answer("static_angle", "Angle of the static component", angle);
        polar[0] = Phasor::polar(size, angle);
    }
    if couple.value() > 1e-12 * scale {
        sheet.common_error("γ", rotor::REVERSED, || balance::marked_direction(-opposite.x, -opposite.y));
        rotor::quadrant_ignored(sheet, "γ", (opposite.x, opposite.y));
        let angle = sheet.step("γ", "deg", opposite.marked_angle(), "Its angle in the first vector");
        sheet.answer("couple_angle", "Angle of the couple component in the first vector", angle);
        polar[1] = Phasor::polar(couple, angle);
    }
    let [in_common, in_opposite] = polar;
    for (what, parts, (size, angle)) in [
        ("static plus couple component reproduces the first vector", in_common.plus(in_opposite), first),
        ("static minus couple component reproduces the second vector", in_common.minus(in_opposite), second),
    ] {
        // Seen along the vector, the parts are as large, and nothing is left across it.
        let (along, across) = (angle.cos(), angle.sin());
        sheet.check_sum(what, parts.x * along + parts.y * across, size, scale);
        sheet.check_zero(what, parts.y * along - parts.x * across, scale);
    }
    // The parallelogram law: S² + C² = (V₁² + V₂²)/2.
    sheet.check(
        "squares of both components compared with those of the vectors",
        size.powi(2) + couple.powi(2),
        (first.0.powi(2) + second.0.powi(2)) / 2.0,
    );
    let plain = |v: Phasor<W::Num>| (v.x.value(), v.y.value());
    let (common, opposite) = (plain(common), plain(opposite));
    let (one, two) = (plain(one), plain(two));
    sheet.show(|| Exhibit::Drawing(drawing(symbols, [one, two], common, opposite)));
    Ok(())
}

/// Both vectors, and the two parts from whose tip they branch.
fn drawing(
    symbols: [&'static str; 2],
    vectors: [(f64, f64); 2],
    common: (f64, f64),
    opposite: (f64, f64),
) -> Drawing {
    let reach = vectors.iter().map(|(x, y)| x.hypot(*y)).fold(0.0, f64::max);
    let at = |(x, y): (f64, f64)| (x / reach, y / reach);
    let mut sketch = dial("Static component S and couple component C");
    for (vector, name) in vectors.into_iter().zip(symbols) {
        sketch.motion(name, (0.0, 0.0), at(vector));
    }
    // The other diagonal of the parallelogram is twice S.
    let far = at((2.0 * common.0, 2.0 * common.1));
    for vector in vectors {
        sketch.axis(at(vector), far);
    }
    sketch.edge("S", (0.0, 0.0), at(common), Ink::Result);
    for (sign, name) in [(1.0, "C"), (-1.0, "−C")] {
        let tip = at((common.0 + sign * opposite.0, common.1 + sign * opposite.1));
        sketch.edge(name, at(common), tip, Ink::Force);
    }
    sketch.finish()
}
