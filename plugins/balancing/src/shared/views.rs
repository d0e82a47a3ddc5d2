//! Tables and drawings of unbalances, the same for every rotor.

use std::f64::consts::TAU;

use dalembert_core::{Cell, Column, Drawing, Ink, Point, Sketch, TableExhibit, Text, trace::ROUNDING};

/// An unbalance as it is listed and drawn.
#[derive(Clone, Debug)]
pub(crate) struct ListedUnbalance {
    /// Name in the table.
    pub name: Text,
    /// Name in drawings.
    pub label: String,
    /// Size and angle as the end view writes them: `m₁ r₁ ∠ θ₁`.
    pub polar: String,
    /// Symbol of its position along the shaft; empty where that is not given.
    pub place: String,
    /// Mass and radius, where they are known.
    pub mass_and_radius: Option<(f64, f64)>,
    /// Components of the unbalance, kg·m.
    pub unbalance: (f64, f64),
    /// Position along the shaft, m.
    pub position: f64,
    /// A mass on the rotor, or a correction.
    pub ink: Ink,
}

impl ListedUnbalance {
    fn size(&self) -> f64 {
        self.unbalance.0.hypot(self.unbalance.1)
    }

    fn along(&self) -> (f64, f64) {
        (self.unbalance.0 * self.position, self.unbalance.1 * self.position)
    }
}

/// The table of textbooks, with the corrections under the masses and the sums under both. Positions and moments
/// stand in it for rotors with more than one plane.
pub(crate) fn table(shown: &[ListedUnbalance], planes: bool) -> TableExhibit {
    let with_masses = shown.iter().any(|s| s.mass_and_radius.is_some());
    let column = |heading: &'static str, unit| Column { heading: heading.into(), unit };
    let mut columns = vec![column("", "")];
    if with_masses {
        columns.extend([column("m", "kg"), column("r", "mm")]);
    }
    columns.extend([column("m r", "kg*mm"), column("θ", "deg")]);
    if planes {
        columns.push(column("z", "mm"));
    }
    columns.extend([column("m r cos θ", "kg*mm"), column("m r sin θ", "kg*mm")]);
    if planes {
        columns.extend([column("m r z cos θ", "kg*mm^2"), column("m r z sin θ", "kg*mm^2")]);
    }
    let row = |s: &ListedUnbalance| -> Vec<Cell> {
        let (x, y) = s.unbalance;
        let (u, angle) = (s.size(), y.atan2(x).rem_euclid(TAU));
        // The cosine of a right angle is zero, not its rounding.
        let [x, y] = [x, y].map(|component| if component.abs() < ROUNDING * u { 0.0 } else { component });
        let mut cells: Vec<Cell> = vec![s.name.clone().into()];
        if with_masses {
            let (mass, radius) =
                s.mass_and_radius.map_or((Cell::Empty, Cell::Empty), |(m, r)| (m.into(), r.into()));
            cells.extend([mass, radius]);
        }
        cells.extend([u.into(), angle.into()]);
        if planes {
            cells.push(s.position.into());
        }
        cells.extend([x.into(), y.into()]);
        if planes {
            cells.extend([(x * s.position).into(), (y * s.position).into()]);
        }
        cells
    };
    let rows: Vec<Vec<Cell>> = shown.iter().map(row).collect();
    let sum = |at: usize| {
        let numbers =
            || rows.iter().filter_map(|row| if let Cell::Number(x) = row[at] { Some(x) } else { None });
        // A sum that cancels is zero, not its rounding.
        let (sum, size) = (numbers().sum::<f64>(), numbers().map(f64::abs).sum::<f64>());
        Cell::Number(if sum.abs() < 1e-12 * size { 0.0 } else { sum })
    };
    let sums = if planes { 4 } else { 2 };
    let mut foot = vec![Cell::Empty; columns.len() - sums];
    foot[0] = "sum".into();
    foot.extend((columns.len() - sums..columns.len()).map(sum));
    TableExhibit { title: "Masses and corrections".into(), columns, rows, foot }
}

/// Polar diagram of unbalances and corrections, along the shaft, and the symbol of the speed where there is one.
pub(crate) fn polar(shown: &[ListedUnbalance], speed: Option<&'static str>) -> Drawing {
    let reach = shown.iter().map(ListedUnbalance::size).fold(0.0, f64::max);
    let reach = if reach > 0.0 { reach } else { 1.0 };
    let mut sketch = dial("End view: unbalances and corrections");
    sketch.circle((0.0, 0.0), 0.5, Ink::Faint);
    for s in shown {
        let tip = (s.unbalance.0 / reach, s.unbalance.1 / reach);
        sketch.vector(Text::verbatim(&s.polar), (0.0, 0.0), tip, s.ink);
    }
    if let Some(speed) = speed {
        turning(&mut sketch, speed);
    }
    sketch.finish()
}

/// An arrow outside of a dial, in the sense of rotation.
pub(crate) fn turning(sketch: &mut Sketch, name: impl Into<Text>) {
    const RADIUS: f64 = 1.2;
    let at = |angle: f64| (RADIUS * angle.cos(), RADIUS * angle.sin());
    let bent: Vec<Point> = (0..=10).map(|n| at(2.1 + 0.05 * f64::from(n))).collect();
    sketch.curve(bent, Ink::Motion).vector(name, at(2.5), at(2.6), Ink::Motion);
}

/// A circle of radius 1 with its axes: the end view of a rotor, a polar diagram.
pub(crate) fn dial(title: impl Into<Text>) -> Sketch {
    let mut sketch = Sketch::new(title);
    sketch.axes((0.0, 0.0), 1.1).circle((0.0, 0.0), 1.0, Ink::Faint);
    sketch
}

/// Positions that have room for a dimension line each under the shaft.
const MOST_PLACES: usize = 8;

/// The shaft from the side: planes, masses and corrections at their positions, which are measured from one end; bearings
/// with the symbols of theirs.
pub(crate) fn side(shown: &[ListedUnbalance], bearings: &[(f64, &'static str)]) -> Drawing {
    let positions = || shown.iter().map(|s| s.position).chain(bearings.iter().map(|(z, _)| *z)).chain([0.0]);
    let (low, high) = positions().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), z| (a.min(z), b.max(z)));
    let span = (high - low).max(f64::MIN_POSITIVE);
    let at = |z: f64| 4.0 * (z - low) / span;
    let largest = shown.iter().map(ListedUnbalance::size).fold(0.0, f64::max);
    let height = |y: f64| if largest > 0.0 { y / largest } else { 0.0 };
    let mut sketch = Sketch::new("The shaft from the side");
    sketch.size(4.8).link("", (-0.4, 0.0), (4.4, 0.0));
    let ends =
        if bearings.is_empty() { vec![-0.4, 4.4] } else { bearings.iter().map(|(z, _)| at(*z)).collect() };
    for x in ends {
        sketch.bearing("", (x, 0.0), 0.0);
    }
    for s in shown {
        let (x, y) = (at(s.position), height(s.unbalance.1));
        let name = Text::new(s.label.clone());
        if s.ink == Ink::Result {
            sketch.axis((x, -1.1), (x, 1.1)).vector("", (x, 0.0), (x, y), s.ink).label(name, (x, 1.1));
        } else {
            sketch.vector(name, (x, 0.0), (x, y), s.ink);
        }
    }
    let mut places: Vec<(f64, Text)> = shown
        .iter()
        .filter(|s| !s.place.is_empty())
        .map(|s| (s.position, Text::verbatim(&s.place)))
        .chain(bearings.iter().map(|(z, name)| (*z, Text::from(*name))))
        .filter(|(z, _)| *z != 0.0)
        .collect();
    places.sort_by(|a, b| a.0.abs().total_cmp(&b.0.abs()));
    if places.len() <= MOST_PLACES {
        sketch.axis((at(0.0), -1.1), (at(0.0), 1.1));
        for (row, (z, name)) in (1..).zip(places) {
            let shift = -3.2 * f64::from(row) * z.signum();
            sketch.dimension(name, (at(0.0), -1.1), (at(z), -1.1), shift);
        }
    }
    sketch.finish()
}

/// The unbalances one after another: with the corrections the polygon closes.
pub(crate) fn force_polygon(shown: &[ListedUnbalance]) -> Drawing {
    polygon("Polygon of the unbalances", shown.iter().map(|s| (s, s.unbalance)))
}

/// The moments of the unbalances about the origin one after another: balanced, the polygon closes.
pub(crate) fn couple_polygon(shown: &[ListedUnbalance]) -> Drawing {
    polygon("Polygon of the moments about the origin", shown.iter().map(|s| (s, s.along())))
}

fn polygon<'s>(title: &'static str, vectors: impl Iterator<Item = (&'s ListedUnbalance, Point)>) -> Drawing {
    let mut at = (0.0, 0.0);
    let mut edges = Vec::new();
    for (shown, (x, y)) in vectors {
        let to = (at.0 + x, at.1 + y);
        edges.push((shown, at, to));
        at = to;
    }
    let reach = edges.iter().map(|(_, _, to)| to.0.abs().max(to.1.abs())).fold(0.0, f64::max);
    let scaled = |(x, y): Point| if reach > 0.0 { (x / reach, y / reach) } else { (0.0, 0.0) };
    let mut sketch = Sketch::new(title);
    for (shown, from, to) in edges {
        let (from, to) = (scaled(from), scaled(to));
        if (to.0 - from.0).hypot(to.1 - from.1) >= 1e-9 {
            sketch.edge(Text::new(shown.label.clone()), from, to, shown.ink);
        }
    }
    sketch.finish()
}
