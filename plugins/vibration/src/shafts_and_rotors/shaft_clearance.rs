//! Conditions for an unbalanced rotor to clear its stator: diameters or stiffnesses of its shaft, eccentricities,
//! speeds.

use std::f64::consts::{FRAC_1_SQRT_2, PI};

use dalembert_core::{
    About, Analysis, Drawing, Exhibit, Ink, Inputs, Refusal, Sketch, Text, Worksheet, register,
};
use dalembert_mechanics::{
    Real, sdof,
    whirl::{self, LimitedBy, PermittedStiffness},
};
use dalembert_numerics::intervals::IntervalSet;

mod diameter;
mod eccentricity;
mod judged;
mod limits;
mod plot;
mod speed;

pub use crate::shared::jeffcott::Mounting;
use crate::{
    shared::jeffcott::RotorShaft,
    sources::{BEER, LISTS, RAO, SHIGLEY},
};

/// The rotor in its stator, and what is sought.
#[derive(Clone, Debug, Inputs)]
pub struct ShaftClearance {
    /// Mass of the rotor.
    #[input("m", "kg", positive)]
    pub mass: f64,
    /// Radial clearance between rotor and stator.
    #[input("R", "m", positive)]
    pub clearance: f64,
    /// Damping.
    pub damping: ClearanceDamping,
    /// Find.
    pub sought: PermittedQuantity,
}

/// The quantity whose permitted values are sought, and what is given of the others.
#[derive(Clone, Debug, Inputs)]
pub enum PermittedQuantity {
    /// Diameter of the shaft
    Diameter {
        /// Unbalance.
        /// Mass of the rotor times the distance of its centre of mass from the axis.
        #[input("m₀e", "kg*m", positive)]
        unbalance: f64,
        /// Speeds.
        speeds: SpeedRange,
        /// Shaft.
        shaft: RoundShaft,
        /// Minimum available diameter.
        #[input("d_min", "m", positive)]
        smallest_diameter: Option<f64>,
        /// Maximum available diameter.
        #[input("d_max", "m", positive)]
        largest_diameter: Option<f64>,
        /// Diameter to be checked.
        #[input("d", "m", positive)]
        diameter: Option<f64>,
    },
    /// Stiffness of the shaft at the rotor
    Stiffness {
        /// Unbalance.
        /// Mass of the rotor times the distance of its centre of mass from the axis.
        #[input("m₀e", "kg*m", positive)]
        unbalance: f64,
        /// Speeds.
        speeds: SpeedRange,
        /// Minimum available stiffness.
        #[input("k_min", "N/m", positive)]
        smallest_stiffness: Option<f64>,
        /// Maximum available stiffness.
        #[input("k_max", "N/m", positive)]
        largest_stiffness: Option<f64>,
        /// Stiffness to be checked.
        #[input("k", "N/m", positive)]
        stiffness: Option<f64>,
    },
    /// Eccentricity of the rotor
    Eccentricity {
        /// Speeds.
        speeds: SpeedRange,
        /// Shaft.
        shaft: RotorShaft,
    },
    /// Speed of the rotor
    Speed {
        /// Unbalance.
        /// Mass of the rotor times the distance of its centre of mass from the axis.
        #[input("m₀e", "kg*m", positive)]
        unbalance: f64,
        /// Shaft.
        shaft: RotorShaft,
    },
}

/// The speeds at which the rotor runs.
#[derive(Clone, Debug, Inputs)]
pub struct SpeedRange {
    /// Minimum speed.
    #[input("ω_a", "rad/s", nonnegative)]
    pub lowest: f64,
    /// Maximum speed.
    #[input("ω_b", "rad/s", positive)]
    pub highest: f64,
    /// Margin on the speed range.
    /// Taken off the lowest speed and added to the highest.
    #[input("s", "%", nonnegative, below = 100)]
    pub margin: Option<f64>,
}

/// Damping of the whirl.
#[derive(Clone, Debug, Inputs)]
pub enum ClearanceDamping {
    /// Undamped
    Undamped,
    /// Damping ratio given
    /// The same for every shaft, so that the coefficient varies with the stiffness.
    Ratio {
        /// Damping ratio.
        #[input("ζ", "1", nonnegative)]
        ratio: f64,
    },
    /// Damping coefficient given
    /// The same for every shaft.
    Coefficient {
        /// Damping coefficient.
        #[input("c", "N*s/m", nonnegative)]
        coefficient: f64,
    },
}

/// A solid round shaft.
#[derive(Clone, Debug, Inputs)]
pub struct RoundShaft {
    /// Mounting.
    pub mounting: Mounting,
    /// Length.
    /// Of the overhang where the rotor is at its end, of the span otherwise.
    #[input("L", "m", positive)]
    pub length: f64,
    /// Young's modulus.
    #[input("E", "Pa", positive)]
    pub young: f64,
}

register!(ShaftClearance);

impl Analysis for ShaftClearance {
    const ABOUT: About = About {
        id: "vibration/shaft-clearance",
        title: "Shaft for a rotor with clearance",
        topic: "Shafts and rotors",
        summary: "All shaft diameters or stiffnesses, eccentricities or speeds for which an unbalanced rotor does not touch its stator.",
        main: &["diameters", "stiffnesses", "eccentricities", "speeds"],
        keywords: "whirl critical speed Francis turbine rotor stator jeffcott eccentricity stiffness turbina eixo \
                   diâmetro rigidez excentricidade folga velocidade crítica 08/3",
        sources: &[&RAO, &BEER, &SHIGLEY, &LISTS],
        cases: include_str!("../../cases/shaft_clearance.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &ShaftClearanceGiven<W>, sheet: W) -> Result<(), Refusal> {
        match (&self.sought, &given.sought) {
            (PermittedQuantity::Diameter { .. }, PermittedQuantityGiven::Diameter { .. }) => {
                self.diameters(given, sheet)
            }
            (PermittedQuantity::Stiffness { .. }, PermittedQuantityGiven::Stiffness { .. }) => {
                self.stiffnesses(given, sheet)
            }
            (PermittedQuantity::Eccentricity { .. }, _) => self.eccentricities(given, sheet),
            (PermittedQuantity::Speed { .. }, _) => self.speeds(given, sheet),
            _ => unreachable!("what is given is made from what is sought"),
        }?;
        sheet.show(|| Exhibit::Drawing(self.drawing()));
        Ok(())
    }
}

/// One side of the resonance.
#[derive(Clone, Copy)]
enum Branch {
    /// The rotor runs above its critical speed.
    Soft,
    /// The rotor runs below its critical speed.
    Stiff,
}

/// The rotor in its stator, as numbers of the worksheet.
#[derive(Clone, Copy)]
struct Rotor<N> {
    mass: N,
    unbalance: N,
    clearance: N,
}

/// The permitted stiffnesses: the kernel's account of them, and their limits as numbers of the worksheet.
struct Branches<N> {
    speeds: [N; 2],
    permitted: PermittedStiffness,
    soft: Option<N>,
    stiff: Option<N>,
}

impl<N: Real> Branches<N> {
    fn range(&self) -> [f64; 2] {
        self.speeds.map(Real::value)
    }
}

impl SpeedRange {
    /// The range of speeds with its margins.
    fn widened<W: Worksheet>(&self, given: &SpeedRangeGiven<W>, sheet: W) -> Result<[W::Num; 2], Refusal> {
        if self.lowest > self.highest {
            return Err(Refusal::because(
                "the lowest speed is above the highest one: write the smaller speed as the lowest",
            ));
        }
        let Some(margin) = given.margin else { return Ok([given.lowest, given.highest]) };
        let one = W::Num::from(1.0);
        Ok([
            sheet.step("ω₁", "rpm", given.lowest * (one - margin), "Minimum speed, including the margin"),
            sheet.step("ω₂", "rpm", given.highest * (one + margin), "Maximum speed, including the margin"),
        ])
    }
}

impl ShaftClearance {
    /// Permitted stiffnesses: answers the limits of the two branches.
    fn branches<W: Worksheet>(
        &self,
        given: &ShaftClearanceGiven<W>,
        unbalance: W::Num,
        speeds: [W::Num; 2],
        sheet: W,
    ) -> Result<Branches<W::Num>, Refusal> {
        let rotor = Rotor { mass: given.mass, unbalance, clearance: given.clearance };
        let eccentricity = sheet.step(
            "e",
            "µm",
            unbalance / given.mass,
            ("Distance of the centre of mass from the axis", RAO.at("§9.5")),
        );
        self.largest_amplitude(given, eccentricity, sheet);
        let permitted = self.permitted(unbalance.value(), speeds.map(Real::value))?;
        let (soft, stiff) = match &given.damping {
            ClearanceDampingGiven::Coefficient { coefficient } => {
                limits::found_limits(&rotor, *coefficient, &permitted, sheet)
            }
            ClearanceDampingGiven::Ratio { ratio } if ratio.value() > 0.0 => {
                limits::ratio_limits(&rotor, *ratio, speeds, &permitted, sheet)
            }
            _ => limits::undamped_limits(&rotor, speeds, &permitted, sheet),
        };
        if let Some(k) = soft {
            sheet.answer("soft_stiffness", "Maximum stiffness, supercritical operation", k);
        }
        if let Some(k) = stiff {
            sheet.answer("stiff_stiffness", "Minimum stiffness, subcritical operation", k);
        }
        Ok(Branches { speeds, permitted, soft, stiff })
    }

    /// The kernel: which stiffnesses are permitted.
    fn permitted(&self, unbalance: f64, speeds: [f64; 2]) -> Result<PermittedStiffness, Refusal> {
        let (m, u, r) = (self.mass, unbalance, self.clearance);
        let permitted = match self.damping {
            ClearanceDamping::Undamped => whirl::permitted_stiffness(m, u, r, speeds, 0.0),
            ClearanceDamping::Ratio { ratio } => whirl::permitted_stiffness(m, u, r, speeds, ratio),
            ClearanceDamping::Coefficient { coefficient } => {
                whirl::permitted_stiffness_at_damping(m, u, r, speeds, coefficient)
            }
        };
        permitted.map_err(|_| {
            Refusal::because(
                "these numbers do not describe a rotor, or lead to values outside the representable range",
            )
        })
    }

    /// With a damping ratio, the largest amplitude of any shaft; and the ratio from which no shaft can touch.
    fn largest_amplitude<W: Worksheet>(
        &self,
        given: &ShaftClearanceGiven<W>,
        eccentricity: W::Num,
        sheet: W,
    ) {
        if matches!(self.damping, ClearanceDamping::Coefficient { .. }) {
            return;
        }
        let room = sheet.step(
            "Λ",
            "1",
            given.clearance / eccentricity,
            "Clearance as a multiple of the eccentricity",
        );
        if let Some(enough) = sdof::damping_ratio_from_peak(room) {
            let light = || W::Num::from(0.5) / room;
            sheet.common_error("ζ_R", "the formula for light damping, ζ = 1/(2Λ), used", light);
            let enough = sheet.step(
                "ζ_R",
                "1",
                enough,
                (
                    "Damping ratio for which the peak, e/(2ζ√(1 − ζ²)), just reaches the clearance",
                    RAO.at("§3.7"),
                ),
            );
            sheet.check(
                "the peak with that damping ratio is the clearance",
                eccentricity * sdof::peak_magnification(enough),
                given.clearance,
            );
            sheet.answer(
                "harmless_damping_ratio",
                "Minimum damping ratio for no contact with any shaft",
                enough,
            );
        }
        let ClearanceDampingGiven::Ratio { ratio } = &given.damping else { return };
        if ratio.value() > 0.0 && ratio.value() < FRAC_1_SQRT_2 {
            let resonance = || eccentricity / (*ratio * 2.0);
            sheet.common_error("Xₘₐₓ", "the amplitude at r = 1, e/(2ζ), used", resonance);
            let largest = sheet.step(
                "Xₘₐₓ",
                "mm",
                eccentricity * sdof::peak_magnification(*ratio),
                ("Maximum amplitude of any shaft, at its worst-case speed: the peak does not depend on the stiffness", RAO.at("§3.7")),
            );
            sheet.check(
                "the same from the whirl amplitude at the frequency ratio of the peak",
                whirl::whirl_amplitude(eccentricity, sdof::unbalance_peak_ratio(*ratio), *ratio),
                largest,
            );
            sheet.answer("largest_amplitude", "Maximum amplitude of any shaft at any speed", largest);
        }
    }

    fn drawing(&self) -> Drawing {
        let (mounting, round) = match &self.sought {
            PermittedQuantity::Diameter { shaft, .. } => (shaft.mounting, true),
            PermittedQuantity::Eccentricity { shaft: RotorShaft::Round { mounting, .. }, .. }
            | PermittedQuantity::Speed { shaft: RotorShaft::Round { mounting, .. }, .. } => (*mounting, true),
            _ => (Mounting::SimplySupported, false),
        };
        let mut sketch = Sketch::new("The rotor in its stator (clearance and diameter drawn wider)");
        let x = mounting.draw(&mut sketch);
        sketch
            .mass("", (x - 0.45, -0.8), (x + 0.45, 0.8))
            .label("m", (x - 0.2, -0.5))
            .line("stator", (x - 0.7, 1.15), (x + 0.7, 1.15), Ink::Danger)
            .curve([(x - 0.7, -1.15), (x + 0.7, -1.15)], Ink::Danger)
            .axis((-2.7, 0.0), (x + 1.2, 0.0))
            .dimension("R", (x + 0.3, 0.8), (x + 0.3, 1.15), 0.0)
            .round("", (x, 0.25), 0.06, Ink::Danger);
        if round {
            mounting.label(&mut sketch, 1.5);
        } else {
            sketch.label("k", (-1.4, 0.0));
        }
        let (unbalance, speed) = match self.sought {
            PermittedQuantity::Diameter { .. } | PermittedQuantity::Stiffness { .. } => {
                ("m₀e", "ω_a ≤ ω ≤ ω_b")
            }
            PermittedQuantity::Eccentricity { .. } => ("e", "ω_a ≤ ω ≤ ω_b"),
            PermittedQuantity::Speed { .. } => ("m₀e", "ω"),
        };
        let turn = |n: i32| {
            let (sin, cos) = (PI * (0.6 + 0.8 * f64::from(n) / 12.0)).sin_cos();
            (-1.1 + 0.15 * cos, 0.45 * sin)
        };
        sketch
            .label(unbalance, (x, 0.25))
            .curve((0..12).map(turn).collect::<Vec<_>>(), Ink::Motion)
            .motion(speed, turn(11), turn(12))
            .finish()
    }
}

/// The damping ratio of a rotor on a known shaft; `None` without damping.
fn damping_ratio<W: Worksheet>(
    damping: &ClearanceDampingGiven<W>,
    stiffness: W::Num,
    mass: W::Num,
    sheet: W,
) -> Option<W::Num> {
    let ratio = match damping {
        ClearanceDampingGiven::Undamped {} => return None,
        ClearanceDampingGiven::Ratio { ratio } => *ratio,
        ClearanceDampingGiven::Coefficient { coefficient } if coefficient.value() == 0.0 => return None,
        ClearanceDampingGiven::Coefficient { coefficient } => sheet.step(
            "ζ",
            "1",
            sdof::damping_ratio(*coefficient, stiffness, mass),
            ("Damping ratio: damping over critical damping", RAO.at("§2.6")),
        ),
    };
    (ratio.value() > 0.0).then_some(ratio)
}

/// The values that are both available and permitted, and what limits each end: `available` are the smallest and
/// the largest, `[thin, thick]` the ends of the forbidden gap.
fn available_set(
    available: [(Option<f64>, &'static str); 2],
    [thin, thick]: [Option<f64>; 2],
    permitted: &PermittedStiffness,
) -> (IntervalSet, Vec<Text>) {
    use std::ops::Bound::{Excluded, Included, Unbounded};
    let finite = |d: Option<f64>| d.filter(|d| d.is_finite());
    let [(smallest, smallest_words), (largest, largest_words)] = available;
    let within = IntervalSet::interval(
        finite(smallest).map_or(Included(0.0), Included),
        finite(largest).map_or(Unbounded, Included),
    );
    let forbidden = match finite(thick) {
        Some(thick) => IntervalSet::interval(finite(thin).map_or(Included(0.0), Excluded), Excluded(thick)),
        None => IntervalSet::none(),
    };
    let set = within.intersection(&forbidden.complement());
    let why_it_ends = |at: f64| {
        let limit = match Some(at) {
            d if d == thin => permitted.soft,
            d if d == thick => permitted.stiff,
            d if d == smallest => return Text::new(smallest_words),
            _ => None,
        };
        let Some(limit) = limit else { return Text::new(largest_words) };
        reached(limit.by, limit.speed)
    };
    let ends = set.intervals().flat_map(|interval| [interval.lower, interval.upper]);
    let limits = ends.filter_map(|end| match end {
        Included(d) | Excluded(d) if d > 0.0 => Some(why_it_ends(d)),
        _ => None,
    });
    let limits = limits.collect();
    (set, limits)
}

/// Description of the speed at which the clearance is reached.
fn reached(by: LimitedBy, speed: f64) -> Text {
    let text = match by {
        LimitedBy::LowestSpeed => Text::new("the clearance is reached at the lowest speed, {speed}"),
        LimitedBy::HighestSpeed => Text::new("the clearance is reached at the highest speed, {speed}"),
        LimitedBy::Peak => Text::new("the clearance is reached at the peak of the response, at {speed}"),
    };
    text.with_quantity("speed", speed, "rpm")
}

/// Says plainly when the clearance decides nothing, or everything.
fn say_what_limits<W: Worksheet>(
    permitted: &PermittedStiffness,
    set: &IntervalSet,
    [never, nothing]: [&'static str; 2],
    sheet: W,
) {
    if permitted.stiff.is_none() {
        sheet.warn(|| Text::new(never));
    } else if permitted.soft.is_some() {
        sheet.warn(|| {
            Text::new(
                "in supercritical operation the rotor passes its critical speed before reaching the lowest speed: run through it quickly",
            )
        });
    }
    if set.is_none() {
        sheet.warn(|| Text::new(nothing));
    }
}
