//! Drawings of springs and networks of springs.

use dalembert_core::{Point, Sketch, Symbol, Text, printer};

use super::{Spring, element::symbol, torsional::TorsionalSpring};

/// Height of one spring, and the width it takes up; the width of a beam.
const HEIGHT: f64 = 1.2;
const WIDTH: f64 = 1.6;
const BEAM: f64 = 4.0;

/// A spring or a network that can be drawn hanging down.
pub(crate) trait Suspended: Sized {
    /// The symbol of its stiffness.
    const SYMBOL: &'static str;
    /// Connection of its members.
    fn hanging(&self) -> Hanging<'_, Self>;
}

/// Connection of the members of a drawn network.
pub(crate) enum Hanging<'a, T> {
    /// End to end.
    Series(&'a [T]),
    /// Side by side.
    Parallel(&'a [T]),
    /// A beam that the load bends: clamped at one end, or on two supports; the distance of the load from the left one as a
    /// share of the length, where it is given.
    Beam { cantilever: bool, share: Option<f64> },
    /// A single spring, of a kind; empty for one of given stiffness.
    One(&'static str),
}

impl Suspended for Spring {
    const SYMBOL: &'static str = "k";
    fn hanging(&self) -> Hanging<'_, Self> {
        Hanging::One(match self {
            Spring::Series { members } => return Hanging::Series(members),
            Spring::Parallel { members } => return Hanging::Parallel(members),
            Spring::Equal { .. } => "equal springs",
            Spring::Stiffness { .. } | Spring::Deflected { .. } | Spring::Tuned { .. } => "",
            Spring::Cantilever { .. } => return Hanging::Beam { cantilever: true, share: None },
            Spring::Column { .. } => "column",
            Spring::Bar { .. } | Spring::TaperedBar { .. } => "bar",
            Spring::TorsionBar { .. } => "torsion bar",
            Spring::Helical { .. } => "helical spring",
            Spring::Leaf { .. } => "leaf spring",
            Spring::ShearPad { .. } => "rubber pad",
            Spring::Gas { .. } => "air spring",
            Spring::TautString { .. } => "taut string",
            Spring::Pendulum { .. } => "pendulum",
            Spring::Buoyancy { .. } => "buoyancy",
            Spring::UTube { .. } => "liquid column",
            Spring::Lever { .. } => "through a lever",
            Spring::Inclined { .. } => "inclined",
            Spring::SimplySupported { length, distance, .. }
            | Spring::Clamped { length, distance, .. }
            | Spring::ClampedPinned { length, distance, .. } => {
                let share = distance.map(|distance| distance / length);
                return Hanging::Beam { cantilever: false, share };
            }
            Spring::Overhang { .. } => return Hanging::Beam { cantilever: false, share: None },
        })
    }
}

impl Suspended for TorsionalSpring {
    const SYMBOL: &'static str = "k_t";
    fn hanging(&self) -> Hanging<'_, Self> {
        Hanging::One(match self {
            TorsionalSpring::Series { members } => return Hanging::Series(members),
            TorsionalSpring::Parallel { members } => return Hanging::Parallel(members),
            TorsionalSpring::Stiffness { .. } => "",
            TorsionalSpring::Shaft { .. } | TorsionalSpring::TaperedShaft { .. } => "shaft",
            TorsionalSpring::Helical { .. } => "helical spring",
            TorsionalSpring::Spiral { .. } => "spiral spring",
            TorsionalSpring::Cantilever { .. }
            | TorsionalSpring::SimplySupported { .. }
            | TorsionalSpring::ClampedPinned { .. } => "beam",
            TorsionalSpring::Arm { .. } => "springs on an arm",
            TorsionalSpring::Pendulum { .. } => "pendulum",
            TorsionalSpring::Wires { .. } => "wire suspension",
            TorsionalSpring::Gears { .. } => "through gears",
        })
    }
}

/// True for a beam, which has supports of its own, and for what hangs on beams alone.
pub(crate) fn stands_alone<T: Suspended>(spring: &T) -> bool {
    match spring.hanging() {
        Hanging::Beam { .. } => true,
        Hanging::Series(members) => members.first().is_some_and(stands_alone),
        Hanging::Parallel(members) => !members.is_empty() && members.iter().all(stands_alone),
        Hanging::One(_) => false,
    }
}

/// Kind of a single spring that is drawn with coils.
fn coil<T: Suspended>(spring: &T) -> Option<&'static str> {
    match spring.hanging() {
        Hanging::One(kind) if kind != "shaft" => Some(kind),
        _ => None,
    }
}

/// True for cantilevers side by side, which stand on one wall with their tips joined.
fn are_cantilevers<T: Suspended>(members: &[T]) -> bool {
    members.len() > 1
        && members.iter().all(|member| matches!(member.hanging(), Hanging::Beam { cantilever: true, .. }))
}

/// The size of a spring or a network that is drawn hanging down: width and height.
pub(crate) fn size<T: Suspended>(spring: &T) -> (f64, f64) {
    match spring.hanging() {
        Hanging::Series(members) => {
            members.iter().map(size).fold((0.0, 0.0), |all, one| (f64::max(all.0, one.0), all.1 + one.1))
        }
        Hanging::Parallel(members) if are_cantilevers(members) => (BEAM, HEIGHT * members.len() as f64),
        Hanging::Parallel(members) => {
            members.iter().map(size).fold((0.0, 0.0), |all, one| (all.0 + one.0, f64::max(all.1, one.1)))
        }
        Hanging::Beam { .. } => (BEAM, HEIGHT),
        Hanging::One(_) => (WIDTH, HEIGHT),
    }
}

/// A spring or a network hanging down from `top`, filling its size in height or more.
pub(crate) fn hanging<T: Suspended>(
    spring: &T,
    top: Point,
    height: f64,
    place: &[usize],
    sketch: &mut Sketch,
) {
    let end = (top.0, top.1 - height);
    match spring.hanging() {
        Hanging::Series(members) => {
            let stretch = height / size(spring).1.max(HEIGHT);
            let mut at = top;
            for (n, member) in members.iter().enumerate() {
                let height = size(member).1 * stretch;
                hanging(member, at, height, &[place, &[n + 1]].concat(), sketch);
                at.1 -= height;
            }
        }
        Hanging::Parallel(members) if are_cantilevers(members) => {
            let each = height / members.len() as f64;
            for (n, member) in members.iter().enumerate() {
                let top = (top.0, top.1 - n as f64 * each);
                if n > 0 {
                    // From the tip above to that of this one.
                    sketch.bars([top, (top.0, top.1 - each / 2.0)]);
                }
                hanging(member, top, each, &[place, &[n + 1]].concat(), sketch);
            }
        }
        Hanging::Parallel(members) => {
            let gap = 0.1 * height;
            let widths: Vec<f64> = members.iter().map(|member| size(member).0).collect();
            let all: f64 = widths.iter().sum();
            let mut left = top.0 - all / 2.0;
            let (mut upper, mut lower) = (vec![top.0], vec![end.0]);
            for (n, (member, width)) in members.iter().zip(&widths).enumerate() {
                let bends = stands_alone(member);
                // A cantilever carries at the end of its width.
                let share = if matches!(member.hanging(), Hanging::Beam { cantilever: true, .. }) {
                    0.85
                } else {
                    0.5
                };
                let x = left + share * width;
                let (top, end) = ((x, top.1 - gap), (x, end.1 + gap));
                let place = [place, &[n + 1]].concat();
                // Coil springs of one kind say it once.
                if n > 0 && coil(member).is_some() && coil(member) == coil(&members[0]) {
                    sketch.spring(caption("", &symbol(T::SYMBOL, &place)), top, end);
                } else {
                    hanging(member, top, top.1 - end.1, &place, sketch);
                }
                lower.push(x);
                if !bends {
                    upper.push(x);
                }
                left += width;
            }
            for (ends, y) in [(&upper, top.1 - gap), (&lower, end.1 + gap)] {
                let first = ends.iter().copied().fold(f64::INFINITY, f64::min);
                let last = ends.iter().copied().fold(f64::NEG_INFINITY, f64::max);
                sketch.bars([(first, y), (last, y)]);
            }
            if upper.len() > 1 {
                sketch.bars([top, (top.0, top.1 - gap)]);
            }
            sketch.bars([(end.0, end.1 + gap), end]);
        }
        Hanging::Beam { cantilever: true, .. } => {
            // The load hangs on the free end; the wall stands by itself.
            let (wall, level) = (top.0 - 0.7 * BEAM, top.1 - height / 2.0);
            sketch
                .ground((wall, level + 0.3 * height), (wall, level - 0.3 * height))
                .bars([(wall, level), (top.0, level)])
                .label(Text::new(printer::symbol(&symbol(T::SYMBOL, place))), (wall + 0.3 * BEAM, level))
                .bars([(top.0, level), end])
                .dimension(
                    Text::new(printer::symbol(&symbol("L", place))),
                    (wall, level),
                    (top.0, level),
                    -3.0,
                );
        }
        Hanging::Beam { cantilever: false, share } => {
            let (length, level) = (0.72 * BEAM, top.1 - 0.4 * height);
            let left = top.0 - share.unwrap_or(0.5).clamp(0.3, 0.7) * length;
            let (ends, load) = ([(left, level), (left + length, level)], (top.0, level));
            sketch
                .bars(ends)
                .pin("", ends[0])
                .pin("", ends[1])
                .label(
                    Text::new(printer::symbol(&symbol(T::SYMBOL, place))),
                    (f64::midpoint(top.0, ends[1].0), level),
                )
                .bars([load, end]);
            if share.is_some() {
                sketch.dimension(Text::new(printer::symbol(&symbol("a", place))), ends[0], load, 1.5);
            }
            sketch.dimension(
                Text::new(printer::symbol(&symbol("L", place))),
                ends[0],
                ends[1],
                if share.is_some() { 4.0 } else { 1.5 },
            );
        }
        Hanging::One("shaft") => {
            for side in [-0.07, 0.07] {
                sketch.bars([(top.0 + side, top.1), (top.0 + side, end.1)]);
            }
            let middle = (top.0 + 0.07, top.1 - height / 2.0);
            sketch.label(Text::new(printer::symbol(&symbol(T::SYMBOL, place))), middle).dimension(
                Text::new(printer::symbol(&symbol("L", place))),
                top,
                end,
                -3.0,
            );
        }
        Hanging::One(kind) => {
            sketch.spring(caption(kind, &symbol(T::SYMBOL, place)), top, end);
        }
    }
}

/// The height of a beam under a machine.
const LINE: f64 = -0.5;

/// Length of a beam and, where it is given, the distance of the machine from its left end.
fn span(sketch: &mut Sketch, from: f64, to: f64, distance: bool) {
    sketch.dimension("L", (from, LINE), (to, LINE), -6.5);
    if distance {
        sketch.dimension("a", (from, LINE), (0.0, LINE), -4.0);
    }
}

/// Drawing of the support of a machine whose lower side lies between `(−0.6, −0.4)` and `(0.6, −0.4)`.
pub(crate) fn carrying(spring: &Spring, sketch: &mut Sketch) {
    // Where the supports stand, with the load at zero.
    let supports = |length: f64, distance: Option<f64>| {
        let share = distance.map_or(0.5, |distance| (distance / length).clamp(0.15, 0.85));
        (-5.0 * share, 5.0 - 5.0 * share)
    };
    let left_clamp = |x: f64| ((x, 0.5), (x, -1.5));
    match spring {
        Spring::Cantilever { .. } => {
            let (from, to) = left_clamp(-3.0);
            sketch.ground(from, to).bars([(-3.0, LINE), (0.6, LINE)]).dimension(
                "L",
                (-3.0, LINE),
                (0.0, LINE),
                -2.0,
            );
        }
        Spring::SimplySupported { length, distance, .. } => {
            let (from, to) = supports(*length, *distance);
            sketch.bars([(from, LINE), (to, LINE)]).pin("", (from, LINE)).pin("", (to, LINE));
            span(sketch, from, to, distance.is_some());
        }
        Spring::Clamped { length, distance, .. } => {
            let (from, to) = supports(*length, *distance);
            let ((a, b), (c, d)) = (left_clamp(from), left_clamp(to));
            sketch.ground(a, b).ground(d, c).bars([(from, LINE), (to, LINE)]);
            span(sketch, from, to, distance.is_some());
        }
        Spring::ClampedPinned { length, distance, .. } => {
            let (from, to) = supports(*length, *distance);
            let (a, b) = left_clamp(from);
            sketch.ground(a, b).bars([(from, LINE), (to, LINE)]).pin("", (to, LINE));
            span(sketch, from, to, distance.is_some());
        }
        Spring::Overhang { length, overhang, .. } => {
            let span = (1.8 * length / overhang).clamp(1.2, 4.0);
            let left = -1.8 - span;
            sketch
                .bars([(left, LINE), (0.6, LINE)])
                .pin("", (left, LINE))
                .pin("", (-1.8, LINE))
                .dimension("L", (left, LINE), (-1.8, LINE), -4.0)
                .dimension("a", (-1.8, LINE), (0.0, LINE), -4.0);
        }
        Spring::Series { .. } | Spring::Parallel { .. } => {
            let height = size(spring).1;
            sketch.ground((-1.2, LINE - height), (1.2, LINE - height));
            hanging(spring, (0.0, -0.4), height + 0.1, &[], sketch);
        }
        _ => {
            sketch.ground((-1.0, -1.5), (1.0, -1.5)).spring("k", (-0.4, -1.5), (-0.4, -0.4)).damper(
                "c",
                (0.4, -1.5),
                (0.4, -0.4),
            );
        }
    }
}

/// `k₁,₂: cantilever`
fn caption(kind: &'static str, name: &Symbol) -> Text {
    if kind.is_empty() {
        return Text::new(printer::symbol(name));
    }
    Text::new("{symbol}: {kind}").with("symbol", printer::symbol(name)).with_text("kind", kind)
}
