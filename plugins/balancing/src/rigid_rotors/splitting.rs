//! Workshop form of a correction: split between holes, assembled from available weights, combined, or drilled.

use dalembert_core::{About, Analysis, Drawing, Exhibit, Ink, Inputs, Refusal, Text, Worksheet, register};
use dalembert_mechanics::{
    Real,
    balance::{self, Phasor},
};
use std::f64::consts::PI;

use crate::{
    shared::{
        rotor,
        split::{self, Adjacent},
        views::dial,
    },
    sources::RIUL,
};

/// Workshop form of a correction.
#[derive(Clone, Debug, Inputs)]
pub struct Splitting {
    /// Find.
    pub task: Task,
}

/// A task of the workshop.
#[derive(Clone, Debug, Inputs)]
pub enum Task {
    /// Split a weight between two positions
    Split {
        /// Weight.
        #[input("m", "g", positive)]
        mass: f64,
        /// Angle of the weight.
        #[input("θ", "deg")]
        angle: f64,
        /// Places.
        places: Places,
        /// Available weights.
        /// If given, the best one for each position is chosen, or none.
        available: Vec<Available>,
    },
    /// Combine several weights into one
    /// All at the same radius.
    Combine {
        /// Weights.
        #[input(min = 1)]
        weights: Vec<Weight>,
    },
    /// Remove a weight by drilling
    Drill {
        /// Weight to remove.
        #[input("m", "g", positive)]
        mass: f64,
        /// Diameter of the drill.
        #[input("d", "mm", positive)]
        diameter: f64,
        /// Angle of the drill's point.
        /// 180° for a flat bottom.
        #[input("ε", "deg", min = 30.0, max = 180.0, default = "118 deg")]
        point: f64,
        /// Density.
        #[input("ρ", "kg/m^3", positive, default = "7850 kg/m^3")]
        density: f64,
    },
}

/// Positions available for weights.
#[derive(Clone, Debug, Inputs)]
pub enum Places {
    /// Two positions
    Two {
        /// Angle of the first position.
        #[input("θ₁", "deg")]
        first: f64,
        /// Angle of the second position.
        #[input("θ₂", "deg")]
        second: f64,
    },
    /// Holes or blades all around
    /// The weight is split between the two adjacent positions.
    Around {
        /// Number of positions.
        #[input(min = 3, max = 1000)]
        count: usize,
        /// Angle of position number 1.
        #[input("θ₀", "deg", default = "0 deg")]
        start: f64,
    },
}

/// A weight that can be had, as often as needed.
#[derive(Clone, Debug, Inputs)]
pub struct Available {
    /// Weight.
    #[input("m_s", "g", positive)]
    pub mass: f64,
}

/// A weight on the rotor.
#[derive(Clone, Debug, Inputs)]
pub struct Weight {
    /// Weight.
    #[input("m", "g", positive)]
    pub mass: f64,
    /// Angle.
    #[input("θ", "deg")]
    pub angle: f64,
}

register!(Splitting);

impl Analysis for Splitting {
    const ABOUT: About = About {
        id: "balancing/splitting",
        title: "Splitting and combining balance weights",
        topic: "Rigid rotors",
        summary: "Splitting a correction between two holes or blades or into available weights, combining several weights into one, and the drilling depth.",
        main: &["first", "second", "mass", "angle", "depth"],
        keywords: "divisão de massas furos palhetas combinar pesos furação profundidade split weights holes blades combine drilling depth",
        sources: &[&RIUL],
        cases: include_str!("../../cases/splitting.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &SplittingGiven<W>, sheet: W) -> Result<(), Refusal> {
        match (&self.task, &given.task) {
            (
                Task::Split { places, available, .. },
                TaskGiven::Split { mass, angle, places: given_places, .. },
            ) => {
                let at = places_of(places, given_places, *angle, sheet)?;
                let parts = split([*mass, *angle], at, sheet)?;
                choose([*mass, *angle], at, parts, available, sheet);
                let arrows = [(at[0].value(), parts[0].value()), (at[1].value(), parts[1].value())];
                let whole = (angle.value(), mass.value());
                sheet.show(|| Exhibit::Drawing(drawing(&arrows, whole)));
                Ok(())
            }
            (Task::Combine { weights }, TaskGiven::Combine { weights: given }) => {
                combine(given, sheet)?;
                let sum: Phasor<f64> = total(weights.iter().map(|w| Phasor::polar(w.mass, w.angle)));
                let arrows: Vec<(f64, f64)> = weights.iter().map(|w| (w.angle, w.mass)).collect();
                sheet.show(|| Exhibit::Drawing(drawing(&arrows, (sum.angle(), sum.size()))));
                Ok(())
            }
            (Task::Drill { .. }, TaskGiven::Drill { mass, diameter, point, density }) => {
                drill([*mass, *diameter, *point, *density], sheet);
                Ok(())
            }
            _ => Err(Refusal::because("the task cannot be read")),
        }
    }
}

/// The two places between which a weight is split.
fn places_of<W: Worksheet>(
    places: &Places,
    given: &PlacesGiven<W>,
    angle: W::Num,
    sheet: W,
) -> Result<[W::Num; 2], Refusal> {
    match (places, given) {
        (Places::Around { count, .. }, PlacesGiven::Around { start, .. }) => {
            let Adjacent { numbers: [number, next], pitch } =
                split::adjacent(*count, start.value(), angle.value());
            let step = sheet.numerical(
                "δ",
                "deg",
                pitch,
                "Angle between adjacent positions: 360° divided by their number",
            );
            let place = |symbol: &'static str, number: f64, why: &'static str| {
                sheet.step(symbol, "deg", *start + step * (number - 1.0), why)
            };
            let first = place("θ₁", number, "Angle of the position before the weight");
            let second = place("θ₂", next, "Angle of the position after the weight");
            let numbers = [
                ("first_place", "Number of the first position", number),
                ("second_place", "Number of the second position", next),
            ];
            for (name, label, number) in numbers {
                let number = sheet.numerical(
                    if name == "first_place" { "N₁" } else { "N₂" },
                    "1",
                    number,
                    "Number of the position, counted from 1",
                );
                sheet.answer(name, label, number);
            }
            Ok([first, second])
        }
        (Places::Two { .. }, PlacesGiven::Two { first, second }) => Ok([*first, *second]),
        _ => Err(Refusal::because("the positions cannot be read")),
    }
}

/// The parallelogram of weights.
fn split<W: Worksheet>(
    [mass, angle]: [W::Num; 2],
    [first, second]: [W::Num; 2],
    sheet: W,
) -> Result<[W::Num; 2], Refusal> {
    let between = (second - first).value();
    if between.sin().abs() < 1e-9 {
        return Err(Refusal::because(
            "both positions lie on one line through the shaft and cannot replace a weight in another direction; choose other positions",
        ));
    }
    let why = "The two weights are the components of the given one: law of sines in the parallelogram";
    let angles = "the weight divided in proportion to the angles";
    let normal = "the weight projected orthogonally onto the direction of each position";
    sheet.common_error("m₁", angles, || mass * (second - angle) / (second - first));
    sheet.common_error("m₁", normal, || mass * (angle - first).cos());
    let one = balance::split_first(mass, angle, first, second);
    let one = sheet.step("m₁", "g", one, why);
    let two = balance::split_second(mass, angle, first, second);
    sheet.common_error("m₂", angles, || mass * (angle - first) / (second - first));
    sheet.common_error("m₂", normal, || mass * (second - angle).cos());
    sheet.common_error("m₂", "the rest of the weight taken, as if the two parts added as numbers", || {
        mass - one
    });
    let two = sheet.step("m₂", "g", two, why);
    sheet.answer("first", "Weight at the first position", one);
    sheet.answer("second", "Weight at the second position", two);
    let sum = Phasor::polar(one, first).plus(Phasor::polar(two, second)).minus(Phasor::polar(mass, angle));
    let scale = mass.value() + one.value().abs() + two.value().abs();
    sheet.check_zero("the two weights add up to the given one, along the mark", sum.x, scale);
    sheet.check_zero("the two weights add up to the given one, transverse to the mark", sum.y, scale);
    // What rounding leaves at a place that needs nothing is no weight to take off.
    let small = -1e-9 * mass.value();
    if one.value() < small || two.value() < small {
        sheet.warn(|| {
            "a negative mass would have to be removed, not added: the direction does not lie between the two positions".into()
        });
    } else if one.value() + two.value() > 1.5 * mass.value() {
        sheet.warn(|| {
            Text::new("the two weights together are {times} times the given one; positions closer to it would need less")
                .with("times", format!("{:.2}", (one.value() + two.value()) / mass.value()))
        });
    }
    Ok([one, two])
}

/// The best of the available weights for each place, and what they leave.
fn choose<W: Worksheet>(
    [mass, angle]: [W::Num; 2],
    [first, second]: [W::Num; 2],
    parts: [W::Num; 2],
    available: &[Available],
    sheet: W,
) {
    if available.is_empty() {
        return;
    }
    let wanted = Phasor::polar(mass.value(), angle.value());
    let at = [first.value(), second.value()];
    let remains =
        |one: f64, two: f64| Phasor::polar(one, at[0]).plus(Phasor::polar(two, at[1])).minus(wanted).size();
    // Only those next to what is wanted at a place can be the best, or their neighbours where places are oblique.
    let sizes = || std::iter::once(0.0).chain(available.iter().map(|a| a.mass));
    let near = |part: f64| {
        let mut all: Vec<f64> = sizes().collect();
        all.sort_by(|a, b| (a - part).abs().total_cmp(&(b - part).abs()));
        all.truncate(24);
        all
    };
    let (one, two) = near(parts[0].value())
        .into_iter()
        .flat_map(|one| near(parts[1].value()).into_iter().map(move |two| (one, two)))
        .min_by(|a, b| remains(a.0, a.1).total_cmp(&remains(b.0, b.1)))
        .unwrap_or_default();
    let why = "Among the available weights, the pair with the smallest residual";
    let one = sheet.numerical("m_h₁", "g", one, why);
    let two = sheet.numerical("m_h₂", "g", two, why);
    let along = one * first.cos() + two * second.cos() - mass * angle.cos();
    let across = one * first.sin() + two * second.sin() - mass * angle.sin();
    let left = sheet.step("m_r", "g", balance::magnitude(along, across), "Uncorrected residual weight");
    sheet.answer("first_at_hand", "Available weight for the first position", one);
    sheet.answer("second_at_hand", "Available weight for the second position", two);
    sheet.answer("uncorrected", "Uncorrected residual weight", left);
    sheet.verify(|| {
        let chosen = [one.value(), two.value()];
        let scale = wanted.size() + chosen[0] + chosen[1];
        let far = |weight: f64| sizes().map(|size| (size - weight).abs()).fold(f64::INFINITY, f64::min);
        sheet.check_zeros("the weights are among the available ones", chosen.map(far), wanted.size());
        let least = sizes().fold(f64::INFINITY, |least, size| {
            least.min(remains(size, chosen[1])).min(remains(chosen[0], size))
        });
        let more = (remains(chosen[0], chosen[1]) - least).max(0.0);
        sheet.check_zero("no other weight at either position gives a smaller residual", more.into(), scale);
        let vectors = [(chosen[0], at[0]), (chosen[1], at[1]), (-mass.value(), angle.value())];
        let (again, scale) = rotor::along_first(&vectors);
        let what = "residual, by components along the first position and across it";
        sheet.check_sum(what, left, again.into(), scale);
    });
}

/// One weight in place of several.
fn combine<W: Worksheet>(weights: &[WeightGiven<W>], sheet: W) -> Result<(), Refusal> {
    let sum = total(weights.iter().map(|w| Phasor::polar(w.mass, w.angle)));
    let why = "The components of all weights together";
    let x = sheet.step("m_x", "g", sum.x, (why, RIUL.at("eqs. 9–11")));
    let y = sheet.step("m_y", "g", sum.y, (why, RIUL.at("eqs. 9–11")));
    let scale: f64 = weights.iter().map(|w| w.mass.value()).sum();
    if x.value().hypot(y.value()) < 1e-12 * scale {
        return Err(Refusal::because(
            "the weights balance each other, so no replacement is needed: remove them all",
        ));
    }
    let whole = || W::Num::sum(weights.iter().map(|w| w.mass));
    sheet.common_error("m", "the weights added as numbers, their angles ignored", whole);
    let mass = sheet.step("m", "g", balance::magnitude(x, y), "Magnitude of the sum");
    rotor::quadrant_ignored(sheet, "θ", (x, y));
    sheet.common_error("θ", "the mean of the angles taken, weighted by the weights", || {
        W::Num::sum(weights.iter().map(|w| w.mass * w.angle)) / whole()
    });
    let angle = sheet.step("θ", "deg", balance::marked_direction(x, y), "Its angle");
    sheet.answer("mass", "Combined weight", mass);
    sheet.answer("angle", "Angle of the weight", angle);
    // Seen from the one weight, the others have nothing across it.
    let seen = |w: &WeightGiven<W>| Phasor::polar(w.mass, w.angle - angle);
    let turned = total(weights.iter().map(seen));
    sheet.check_zero(
        "component along the combined weight: the sum has the same magnitude",
        turned.x - mass,
        scale,
    );
    sheet.check_zero("component transverse to the combined weight: zero", turned.y, scale);
    Ok(())
}

/// The depth of a drilled hole: a cylinder with a cone under it.
fn drill<W: Worksheet>([mass, diameter, point, density]: [W::Num; 4], sheet: W) {
    let volume = sheet.step("V", "mm^3", mass / density, "Volume to remove");
    let flat = point.value() > PI - 1e-9;
    let area = sheet.step("A", "mm^2", diameter.powi(2) * (PI / 4.0), "Area of the hole");
    if flat {
        let depth = sheet.step("h", "mm", volume / area, "Depth of the hole with a flat bottom");
        sheet.answer("depth", "Depth to the tip of the drill", depth);
        sheet.check(
            "weight of a cylinder of that depth",
            density * diameter.powi(2) * depth * (PI / 4.0),
            mass,
        );
        return;
    }
    let tip = sheet.step("h_t", "mm", diameter / ((point / 2.0).tan() * 2.0), "Height of the drill's point");
    let cone = sheet.step("V_t", "mm^3", area * tip / 3.0, "Volume of the point, a cone");
    let flat_bottom = "the point of the drill neglected, a cylinder with a flat bottom taken";
    let depth = if volume.value() >= cone.value() {
        let wall = sheet.step("h_w", "mm", (volume - cone) / area, "Depth of the cylinder above the point");
        sheet.answer("wall", "Depth of full diameter", wall);
        sheet.common_error("h", flat_bottom, || volume / area);
        let what = "the whole volume taken at full diameter, the height of the point added";
        sheet.common_error("h", what, || volume / area + tip);
        sheet.step("h", "mm", wall + tip, "Depth to the tip of the drill")
    } else {
        sheet.warn(|| "the weight is less than the drill point removes: use a smaller drill".into());
        let depth = tip * (volume / cone).root(3);
        sheet.common_error("h", flat_bottom, || volume / area);
        let what = "the depth within the point taken as proportional to the volume";
        sheet.common_error("h", what, || tip * (volume / cone));
        sheet.step(
            "h",
            "mm",
            depth,
            "Only part of the drill point cuts: volumes are proportional to the cubes of the depths",
        )
    };
    sheet.answer("depth", "Depth to the tip of the drill", depth);
    // Thin discs from the tip upwards: within a disc the area grows linearly or quadratically, which Simpson's rule
    // takes exactly.
    sheet.verify(|| {
        let (depth, tip, width) = (depth.value(), tip.value(), diameter.value());
        let area = |z: f64| PI / 4.0 * (width * (z / tip).min(1.0)).powi(2);
        let simpson = |a: f64, b: f64| (b - a) / 6.0 * (area(a) + 4.0 * area(f64::midpoint(a, b)) + area(b));
        let corner = depth.min(tip);
        let sum = simpson(0.0, corner) + simpson(corner, depth);
        sheet.check_zero(
            "volume of the hole by Simpson's rule from the tip",
            (sum - volume.value()).into(),
            volume.value(),
        );
    });
}

fn total<N: Real>(weights: impl Iterator<Item = Phasor<N>>) -> Phasor<N> {
    let all: Vec<Phasor<N>> = weights.collect();
    Phasor { x: N::sum(all.iter().map(|w| w.x)), y: N::sum(all.iter().map(|w| w.y)) }
}

/// Weights around the shaft: the single ones and the one that stands for them.
fn drawing(parts: &[(f64, f64)], whole: (f64, f64)) -> Drawing {
    let reach = parts.iter().map(|(_, m)| m.abs()).fold(whole.1, f64::max);
    let tip = |(angle, mass): (f64, f64)| (mass / reach * angle.cos(), mass / reach * angle.sin());
    let mut sketch = dial("Weights around the shaft");
    for (n, part) in (1..).zip(parts) {
        let name = Text::verbatim(format!("{} ∠ {}", rotor::letter("m", n), rotor::letter("θ", n)));
        sketch.force(name, (0.0, 0.0), tip(*part));
    }
    sketch.vector("m ∠ θ", (0.0, 0.0), tip(whole), Ink::Result).finish()
}
