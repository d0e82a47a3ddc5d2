//! The symbols, as the shapes they are made of.

use std::f64::consts::{FRAC_PI_2, TAU};

use super::placement::{Towards, Words};
use crate::{DrawnShape, Ink, Point, Text};

/// A symbol of a sketch.
#[derive(Clone, Debug)]
pub(super) enum Part {
    Shape(DrawnShape),
    Named(Box<Part>, Text),
    /// A place that has a name.
    Nothing(Point),
    /// A place over which words stand.
    Centre(Point),
    Pin(Point),
    HungPin(Point),
    Joint(Point),
    Roller(Point),
    Bearing(Point, f64),
    Slider(Point, f64),
    Guide(Point, Point),
    Line(Vec<Point>, Ink),
    Body(Vec<Point>, Ink),
    Block(Point, Point, Ink),
    Particle(Point),
    Round(Point, f64, Ink),
    Gear(Point, f64, f64),
    Spring(Point, Point),
    TorsionSpring(Point, f64),
    Damper(Point, Point),
    Cylinder(Point, Point, f64),
    MassCentre(Point),
    Vector(Point, Point, Ink),
    Edge(Point, Point, Ink),
    Couple(Point, f64, f64, Ink),
    Angle(Point, f64, f64),
    Dimension(Point, Point, f64),
}

/// A piece of a symbol.
#[derive(Clone, Debug)]
pub(super) enum Item {
    Shape(DrawnShape),
    Words(Words),
}

/// The height of half a slider, in sizes of a symbol.
const HALF_SLIDER: f64 = 1.2;
/// The radius of a joint, in sizes of a symbol.
const JOINT: f64 = 0.5;
/// The radius of the arc of an angle, in sizes of a symbol.
const ANGLE: f64 = 4.5;
/// The radius of the arrow of a couple, in sizes of a symbol.
const COUPLE: f64 = 3.0;
/// The pitch of the coils of a spring, in sizes of a symbol.
const PITCH: f64 = 1.6;
/// The part of the length of a spring that is wound.
const WOUND: f64 = 0.7;

/// The coils of a spring of that length.
pub(super) fn coils(length: f64, unit: f64) -> u32 {
    let coils = WOUND * length / (PITCH * unit);
    if coils.is_finite() { coils.round().clamp(2.0, 30.0) as u32 } else { 2 }
}

/// The size of a symbol: a thirtieth of the sketch.
pub(super) fn unit<'a>(parts: impl Iterator<Item = &'a Part>, size: Option<f64>) -> f64 {
    let size = size.or_else(|| {
        let (low, high) = bounds(parts.flat_map(Part::points))?;
        Some((high.0 - low.0).max(high.1 - low.1))
    });
    symbol(size)
}

/// The size of a symbol in a sketch of a size.
pub(super) fn symbol(size: Option<f64>) -> f64 {
    match size {
        Some(size) if size > 0.0 && size.is_finite() => size / 30.0,
        _ => 1.0 / 30.0,
    }
}

/// Opposite corners of what is drawn.
pub(super) fn window<'a>(shapes: impl Iterator<Item = &'a DrawnShape>) -> Option<(Point, Point)> {
    bounds(shapes.flat_map(DrawnShape::corners))
}

/// Opposite corners of the points that are finite.
fn bounds(points: impl Iterator<Item = Point>) -> Option<(Point, Point)> {
    points.filter(|at| at.0.is_finite() && at.1.is_finite()).fold(None, |all, at| {
        let (low, high) = all.unwrap_or((at, at));
        Some(((low.0.min(at.0), low.1.min(at.1)), (high.0.max(at.0), high.1.max(at.1))))
    })
}

/// The pieces of the symbols of a sketch, in their order.
pub(super) fn items(parts: &[Part], unit: f64) -> Vec<Item> {
    let mut out = Vec::new();
    let touches = |at: Point| parts.iter().any(|part| part.touches(at, unit));
    for part in parts {
        match part {
            Part::Named(part, name) => {
                let (at, towards) = match **part {
                    // A vector that presses on a part has its free end, and its name, at its tail.
                    Part::Vector(tail, head, _) if touches(head) && !touches(tail) => {
                        (tail, Towards::To(direction(head, tail)))
                    }
                    _ => part.named(unit),
                };
                let before = out.len();
                part.draw(unit, &mut out);
                // What is not drawn has no name: a vector without length.
                if out.len() > before || matches!(**part, Part::Nothing(_) | Part::Centre(_)) {
                    out.push(Item::Words(Words { at, towards, half: part.half(unit), text: name.clone() }));
                }
            }
            part => part.draw(unit, &mut out),
        }
    }
    out
}

impl Part {
    /// The points that say how large a sketch is.
    fn points(&self) -> Vec<Point> {
        match self {
            Part::Shape(shape) => shape.corners(),
            Part::Named(part, _) => part.points(),
            Part::Line(points, _) | Part::Body(points, _) => points.clone(),
            Part::Round(at, radius, _) | Part::Gear(at, radius, _) => around(*at, *radius).into(),
            Part::Nothing(at)
            | Part::Centre(at)
            | Part::Pin(at)
            | Part::HungPin(at)
            | Part::Joint(at)
            | Part::Roller(at)
            | Part::Bearing(at, _)
            | Part::Slider(at, _)
            | Part::Particle(at)
            | Part::TorsionSpring(at, _)
            | Part::MassCentre(at)
            | Part::Couple(at, ..)
            | Part::Angle(at, ..) => vec![*at],
            Part::Guide(a, b)
            | Part::Block(a, b, _)
            | Part::Spring(a, b)
            | Part::Damper(a, b)
            | Part::Cylinder(a, b, _)
            | Part::Vector(a, b, _)
            | Part::Edge(a, b, _)
            | Part::Dimension(a, b, _) => vec![*a, *b],
        }
    }

    /// The point that a name belongs to, and where the name is sought.
    fn named(&self, unit: f64) -> (Point, Towards) {
        match self {
            Part::Shape(shape) => (shape.corners().first().copied().unwrap_or_default(), Towards::Out),
            Part::Named(part, _) => part.named(unit),
            Part::Nothing(at)
            | Part::Pin(at)
            | Part::HungPin(at)
            | Part::Joint(at)
            | Part::Roller(at)
            | Part::Bearing(at, _)
            | Part::Slider(at, _)
            | Part::TorsionSpring(at, _)
            | Part::MassCentre(at) => (*at, Towards::Out),
            Part::Centre(at) => (*at, Towards::Over(f64::INFINITY)),
            Part::Particle(at) => (*at, Towards::Over(2.4 * unit)),
            Part::Line(points, _) => {
                let [from, .., to] = points[..] else { return Default::default() };
                (middle(from, to), Towards::Across(direction(from, to)))
            }
            Part::Body(corners, _) => {
                let (low, high) = bounds(corners.iter().copied()).unwrap_or_default();
                (middle(low, high), Towards::Over(0.8 * (high.0 - low.0)))
            }
            Part::Block(a, b, _) => {
                let (wide, top) = ((b.0 - a.0).abs(), a.1.max(b.1));
                // The name of a narrow block stands above it.
                if wide < 3.0 * unit {
                    ((f64::midpoint(a.0, b.0), top), Towards::To((0.0, 1.0)))
                } else {
                    (middle(*a, *b), Towards::Over(wide))
                }
            }
            Part::Round(at, radius, _) if *radius < 2.0 * unit => (*at, Towards::Out),
            Part::Round(at, radius, _) | Part::Gear(at, radius, _) => (*at, Towards::Over(2.0 * radius)),
            Part::Guide(a, b)
            | Part::Spring(a, b)
            | Part::Damper(a, b)
            | Part::Cylinder(a, b, _)
            | Part::Edge(a, b, _) => (middle(*a, *b), Towards::Across(direction(*a, *b))),
            Part::Vector(tail, head, _) => (*head, Towards::To(direction(*tail, *head))),
            Part::Couple(at, from, to, _) => polar_name(*at, COUPLE * unit, f64::midpoint(*from, *to)),
            Part::Angle(at, from, to) => polar_name(*at, ANGLE * unit, f64::midpoint(*from, *to)),
            Part::Dimension(a, b, shift) => {
                let (x, y) = direction(*a, *b);
                let left = (-y * shift * unit, x * shift * unit);
                (plus(middle(*a, *b), left), Towards::To((-y * shift.signum(), x * shift.signum())))
            }
        }
    }

    /// True where a point lies in a body or on its edge.
    fn touches(&self, at: Point, unit: f64) -> bool {
        let near = 0.5 * unit;
        let on = |from: Point, to: Point| {
            let (x, y) = (to.0 - from.0, to.1 - from.1);
            let along = ((at.0 - from.0) * x + (at.1 - from.1) * y) / (x * x + y * y);
            let foot = plus(from, (along.clamp(0.0, 1.0) * x, along.clamp(0.0, 1.0) * y));
            (at.0 - foot.0).hypot(at.1 - foot.1) < near
        };
        match self {
            Part::Named(part, _) => part.touches(at, unit),
            Part::Line(points, Ink::Body) | Part::Shape(DrawnShape::Polyline(points, Ink::Body)) => {
                points.windows(2).any(|pair| on(pair[0], pair[1]))
            }
            Part::Body(corners, Ink::Body) => {
                let edges = || corners.iter().copied().zip(corners.iter().copied().cycle().skip(1));
                // A line from the point to the right meets the outline an odd number of times.
                let is_met = |((ax, ay), (bx, by)): &(Point, Point)| {
                    (*ay > at.1) != (*by > at.1) && at.0 < (bx - ax) * (at.1 - ay) / (by - ay) + ax
                };
                edges().filter(is_met).count() % 2 == 1 || edges().any(|(from, to)| on(from, to))
            }
            Part::Block(a, b, Ink::Body) => {
                let within = |at: f64, a: f64, b: f64| at > a.min(b) - near && at < a.max(b) + near;
                within(at.0, a.0, b.0) && within(at.1, a.1, b.1)
            }
            Part::Particle((x, y)) => {
                let reach = 1.2 * unit + near;
                (at.0 - x).abs() < reach && (at.1 - y).abs() < reach
            }
            Part::Round(middle, radius, Ink::Body) => {
                (at.0 - middle.0).hypot(at.1 - middle.1) < radius + near
            }
            _ => false,
        }
    }

    /// Half the width of a symbol along a line, between whose edges no name stands.
    fn half(&self, unit: f64) -> f64 {
        match self {
            Part::Spring(..) | Part::Damper(..) | Part::Cylinder(..) => 1.2 * unit,
            _ => 0.0,
        }
    }

    fn draw(&self, unit: f64, out: &mut Vec<Item>) {
        let mut add = |shape: DrawnShape| out.push(Item::Shape(shape));
        match self {
            Part::Shape(shape) => add(shape.clone()),
            Part::Named(part, _) => part.draw(unit, out),
            Part::Nothing(_) | Part::Centre(_) => {}
            Part::Pin(at) => add(DrawnShape::Pin(*at)),
            Part::HungPin(at) => add(DrawnShape::HungPin(*at)),
            Part::Joint(at) => add(DrawnShape::Disc(*at, JOINT * unit, Ink::Body)),
            Part::Roller((x, y)) => {
                let (radius, half) = (0.8 * unit, 1.8 * unit);
                add(DrawnShape::Disc((*x, y - radius), radius, Ink::Body));
                add(DrawnShape::Ground((x - half, y - 2.0 * radius), (x + half, y - 2.0 * radius)));
            }
            Part::Bearing(at, angle) => {
                for side in [-1.0, 1.0] {
                    let end = |along: f64| turned(*at, *angle, (along * unit, side * 0.8 * unit));
                    add(DrawnShape::Ground(end(1.2 * side), end(-1.2 * side)));
                }
            }
            Part::Slider(at, angle) => add(rectangle(*at, *angle, (2.0 * unit, HALF_SLIDER * unit))),
            Part::Guide(from, to) => {
                let (x, y) = direction(*from, *to);
                let right = (y * HALF_SLIDER * unit, -x * HALF_SLIDER * unit);
                add(DrawnShape::Ground(plus(*from, right), plus(*to, right)));
            }
            Part::Line(points, ink) => add(DrawnShape::Polyline(points.clone(), *ink)),
            Part::Body(corners, ink) => add(DrawnShape::Body(corners.clone(), *ink)),
            Part::Block(a, b, ink) => add(DrawnShape::Block(*a, *b, *ink)),
            Part::Particle((x, y)) => {
                let half = 1.2 * unit;
                add(DrawnShape::Block((x - half, y - half), (x + half, y + half), Ink::Body));
            }
            Part::Round(at, radius, ink) => add(DrawnShape::Disc(*at, *radius, *ink)),
            Part::Gear(at, radius, angle) => gear(*at, *radius, *angle, unit, add),
            // The number of coils is found when all frames are known.
            Part::Spring(from, to) => add(DrawnShape::Spring(*from, *to, 0)),
            Part::TorsionSpring(at, angle) => {
                let turns = 2.5 * TAU;
                let point = |n: u32| {
                    let part = f64::from(n) / 50.0;
                    polar(*at, (0.5 + 2.0 * part) * unit, angle - turns * (1.0 - part))
                };
                add(DrawnShape::Polyline((0..=50).map(point).collect(), Ink::Body));
            }
            Part::Damper(from, to) => add(DrawnShape::Damper(*from, *to)),
            Part::Cylinder(from, to, barrel) => cylinder((*from, *to), *barrel, unit, add),
            Part::MassCentre(at) => {
                add(DrawnShape::Circle(*at, 0.6 * unit, Ink::Body));
                add(DrawnShape::Polyline(
                    vec![plus(*at, (-0.6 * unit, 0.0)), plus(*at, (0.6 * unit, 0.0))],
                    Ink::Body,
                ));
                add(DrawnShape::Polyline(
                    vec![plus(*at, (0.0, -0.6 * unit)), plus(*at, (0.0, 0.6 * unit))],
                    Ink::Body,
                ));
            }
            Part::Vector(tail, head, ink) | Part::Edge(tail, head, ink) => {
                if tail != head {
                    add(DrawnShape::Arrow(*tail, *head, *ink));
                }
            }
            Part::Couple(at, from, to, ink) => {
                let (low, high) = (from.min(*to), from.max(*to));
                add(DrawnShape::Arc(*at, COUPLE * unit, low, high, *ink));
                let before = to - 0.5 * (to - from).signum();
                add(DrawnShape::Arrow(
                    polar(*at, COUPLE * unit, before),
                    polar(*at, COUPLE * unit, *to),
                    *ink,
                ));
            }
            Part::Angle(at, from, to) => {
                // An angle of nothing has no arc, but its name stays.
                let (low, high) = (from.min(*to), from.max(*to));
                add(DrawnShape::Arc(*at, ANGLE * unit, low, high, Ink::Faint));
            }
            Part::Dimension(from, to, shift) => dimension(*from, *to, *shift, unit, add),
        }
    }
}

/// A pitch circle with teeth outside of it.
fn gear(at: Point, radius: f64, angle: f64, unit: f64, mut add: impl FnMut(DrawnShape)) {
    add(DrawnShape::Circle(at, radius, Ink::Body));
    let teeth = (TAU * radius / (2.5 * unit)).round().clamp(8.0, 40.0);
    for tooth in 0..teeth as u32 {
        let turn = angle + TAU * f64::from(tooth) / teeth;
        let ends = vec![polar(at, radius, turn), polar(at, radius + 0.7 * unit, turn)];
        add(DrawnShape::Polyline(ends, Ink::Body));
    }
    add(DrawnShape::Polyline(vec![at, polar(at, radius, angle)], Ink::Faint));
}

/// A rod from the piston in the barrel to its eye, and pins at both ends.
fn cylinder((from, to): (Point, Point), barrel: f64, unit: f64, mut add: impl FnMut(DrawnShape)) {
    let (x, y) = direction(from, to);
    let on = |along: f64, left: f64| plus(from, (along * x - left * y, along * y + left * x));
    let (half, first) = (1.1 * unit, JOINT * unit);
    let corners = [(first, half), (barrel, half), (barrel, -half), (first, -half)];
    add(DrawnShape::Body(corners.map(|(along, left)| on(along, left)).into(), Ink::Body));
    let piston = 0.7 * barrel;
    add(DrawnShape::Polyline(vec![on(piston, half), on(piston, -half)], Ink::Body));
    add(DrawnShape::Polyline(vec![on(piston, 0.0), to], Ink::Body));
    add(DrawnShape::Disc(from, JOINT * unit, Ink::Body));
    add(DrawnShape::Disc(to, JOINT * unit, Ink::Body));
}

/// Extension lines, and a line with two heads between them.
fn dimension(from: Point, to: Point, shift: f64, unit: f64, mut add: impl FnMut(DrawnShape)) {
    let (x, y) = direction(from, to);
    let beside = |at: Point, sizes: f64| plus(at, (-y * sizes * unit, x * sizes * unit));
    if shift != 0.0 {
        for end in [from, to] {
            let line = vec![beside(end, 0.5 * shift.signum()), beside(end, shift + 0.6 * shift.signum())];
            add(DrawnShape::Polyline(line, Ink::Faint));
        }
    }
    let (from, to) = (beside(from, shift), beside(to, shift));
    add(DrawnShape::Measure(from, to));
}

/// A rectangle about a centre, turned by an angle.
fn rectangle(at: Point, angle: f64, (wide, high): Point) -> DrawnShape {
    let corners = [(-wide, -high), (wide, -high), (wide, high), (-wide, high)];
    DrawnShape::Body(corners.map(|corner| turned(at, angle, corner)).into(), Ink::Body)
}

fn polar_name(at: Point, radius: f64, angle: f64) -> (Point, Towards) {
    (polar(at, radius, angle), Towards::To((angle.cos(), angle.sin())))
}

fn around((x, y): Point, radius: f64) -> [Point; 2] {
    [(x - radius, y - radius), (x + radius, y + radius)]
}

fn polar((x, y): Point, radius: f64, angle: f64) -> Point {
    (x + radius * angle.cos(), y + radius * angle.sin())
}

/// The point beside another by an offset that is turned by an angle.
fn turned((x, y): Point, angle: f64, (along, across): Point) -> Point {
    // Exact where nothing is turned, and for a quarter.
    let (sin, cos) = match angle {
        0.0 => (0.0, 1.0),
        FRAC_PI_2 => (1.0, 0.0),
        angle => angle.sin_cos(),
    };
    (x + along * cos - across * sin, y + along * sin + across * cos)
}

fn plus(a: Point, b: Point) -> Point {
    (a.0 + b.0, a.1 + b.1)
}

fn middle(a: Point, b: Point) -> Point {
    (f64::midpoint(a.0, b.0), f64::midpoint(a.1, b.1))
}

/// The direction from one point to another, of length 1; to the right where they are one.
fn direction(from: Point, to: Point) -> Point {
    let (x, y) = (to.0 - from.0, to.1 - from.1);
    let length = x.hypot(y);
    if length > 0.0 && length.is_finite() { (x / length, y / length) } else { (1.0, 0.0) }
}
