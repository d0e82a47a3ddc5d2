//! The parts of a drawing as lines: pure geometry, in the length of the drawing.

use std::f64::consts::TAU;

use dalembert_core::{Drawing, DrawnShape, Ink, Point};

/// A line through points, all of them finite.
#[derive(Clone, Debug, PartialEq)]
pub struct Stroke {
    /// The points.
    pub points: Vec<Point>,
    /// Colour role.
    pub ink: Ink,
    /// Part of the drawing.
    pub part: StrokeRole,
}

/// Part of a drawing to which a line belongs: some are drawn in another way where a cell is one dot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StrokeRole {
    /// Nothing particular.
    Line,
    /// A circle or a part of one.
    Round,
    /// The edge of something that hides what lies under it.
    Solid,
    /// The edge of a disc, which hides what lies under it.
    Disc,
    /// The wave of a spring, from its first point to its last.
    Spring,
    /// The surface of the ground, which lies at its right-hand side.
    Ground,
    /// A stroke of the hatch of the ground.
    Hatch,
    /// The shaft of an arrow.
    Shaft,
    /// The head of an arrow.
    Head,
}

/// A box round points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Box2 {
    /// The least `x`.
    pub left: f64,
    /// The largest `x`.
    pub right: f64,
    /// The least `y`.
    pub bottom: f64,
    /// The largest `y`.
    pub top: f64,
}

/// Every part but the words, later ones over earlier ones. Signs of a fixed size (hatches, pins, heads of arrows)
/// are a thirtieth of the drawing. A part that is not finite is left out.
pub fn strokes(drawing: &Drawing) -> Vec<Stroke> {
    let corners = drawing.shapes.iter().flat_map(DrawnShape::corners);
    let sign = Box2::of(corners).map_or(1.0, |all| all.width().max(all.height()) / 30.0);
    let mut pen = Strokes { sign, out: Vec::new() };
    for shape in drawing.shapes.iter() {
        pen.shape(shape);
    }
    pen.out.retain(|stroke| {
        !stroke.points.is_empty() && stroke.points.iter().all(|at| at.0.is_finite() && at.1.is_finite())
    });
    pen.out
}

impl Box2 {
    /// The smallest box round the points that are finite; one of no size gets some. `None` without points, or where
    /// they lie farther apart than a number can say.
    pub fn of(points: impl IntoIterator<Item = Point>) -> Option<Self> {
        let mut all: Option<Self> = None;
        for (x, y) in points.into_iter().filter(|at| at.0.is_finite() && at.1.is_finite()) {
            let Self { left, right, bottom, top } =
                all.unwrap_or(Self { left: x, right: x, bottom: y, top: y });
            all =
                Some(Self { left: left.min(x), right: right.max(x), bottom: bottom.min(y), top: top.max(y) });
        }
        let all = all?;
        let size = (all.right - all.left).max(all.top - all.bottom);
        if !size.is_finite() {
            return None;
        }
        let far = all.left.abs().max(all.right.abs()).max(all.bottom.abs()).max(all.top.abs());
        let least = if size > 1e-9 * far { size / 1e6 } else { far.max(1e-9) };
        let widen = |low: f64, high: f64| {
            if high - low >= least {
                (low, high)
            } else {
                ((low + high - least) / 2.0, (low + high + least) / 2.0)
            }
        };
        let ((left, right), (bottom, top)) = (widen(all.left, all.right), widen(all.bottom, all.top));
        Some(Self { left, right, bottom, top })
    }

    /// Width.
    pub fn width(&self) -> f64 {
        self.right - self.left
    }

    /// Height.
    pub fn height(&self) -> f64 {
        self.top - self.bottom
    }
}

struct Strokes {
    /// The size of signs.
    sign: f64,
    out: Vec<Stroke>,
}

impl Strokes {
    fn shape(&mut self, shape: &DrawnShape) {
        match shape {
            DrawnShape::Polyline(points, ink) => self.line(points.clone(), *ink),
            DrawnShape::Circle(at, radius, ink) => {
                self.part(arc(*at, *radius, 0.0, TAU), *ink, StrokeRole::Round);
            }
            DrawnShape::Arc(at, radius, from, to, ink) => {
                // Counter-clockwise, and no more than once round.
                let turn = match to - from {
                    turn if (0.0..=TAU).contains(&turn) => turn,
                    turn => turn.rem_euclid(TAU),
                };
                self.part(arc(*at, *radius, *from, from + turn), *ink, StrokeRole::Round);
            }
            DrawnShape::Block(a, b, ink) => {
                let points = vec![*a, (b.0, a.1), *b, (a.0, b.1), *a];
                self.part(points, *ink, StrokeRole::Solid);
            }
            DrawnShape::Body(corners, ink) => {
                let closed = corners.iter().chain(corners.first()).copied().collect();
                self.part(closed, *ink, StrokeRole::Solid);
            }
            DrawnShape::Disc(at, radius, ink) => {
                self.part(arc(*at, *radius, 0.0, TAU), *ink, StrokeRole::Disc);
            }
            DrawnShape::Pin(at) => self.pin(*at, -1.0),
            DrawnShape::HungPin(at) => self.pin(*at, 1.0),
            DrawnShape::Ground(a, b) => self.ground(*a, *b),
            DrawnShape::Spring(a, b, coils) => self.spring(*a, *b, *coils),
            DrawnShape::Damper(a, b) => self.damper(*a, *b),
            DrawnShape::Arrow(tail, head, ink) => self.arrow(*tail, *head, *ink, 1.6),
            DrawnShape::Measure(a, b) => {
                let middle = (f64::midpoint(a.0, b.0), f64::midpoint(a.1, b.1));
                self.arrow(middle, *a, Ink::Faint, 1.0);
                self.arrow(middle, *b, Ink::Faint, 1.0);
            }
            DrawnShape::Label(..) | DrawnShape::Extent(..) => {}
        }
    }

    fn line(&mut self, points: Vec<Point>, ink: Ink) {
        self.part(points, ink, StrokeRole::Line);
    }

    fn part(&mut self, points: Vec<Point>, ink: Ink, part: StrokeRole) {
        self.out.push(Stroke { points, ink, part });
    }

    /// A pin at the corner of a triangle on ground, which lies below it (−1) or above it (1).
    fn pin(&mut self, at: Point, side: f64) {
        let (half, deep) = (side * 1.2 * self.sign, side * 2.0 * self.sign);
        // The ground is hatched at its right-hand side.
        let (from, to) = ((at.0 + half, at.1 + deep), (at.0 - half, at.1 + deep));
        self.line(vec![at, from, to, at], Ink::Body);
        let over = side * self.sign / 2.0;
        self.ground((from.0 + over, from.1), (to.0 - over, to.1));
        self.part(arc(at, self.sign / 2.0, 0.0, TAU), Ink::Body, StrokeRole::Disc);
    }

    fn ground(&mut self, a: Point, b: Point) {
        self.part(vec![a, b], Ink::Body, StrokeRole::Ground);
        let Some(along) = Along::new(a, b) else { return };
        let count = (along.length / (1.2 * self.sign)).round().clamp(1.0, 60.0);
        for n in 1..=count as u32 {
            let at = along.length * f64::from(n) / count;
            let end = along.at(at - self.sign, -self.sign);
            self.part(vec![along.at(at, 0.0), end], Ink::Faint, StrokeRole::Hatch);
        }
    }

    /// A zigzag between two straight ends.
    fn spring(&mut self, a: Point, b: Point, coils: u32) {
        let teeth = coils.clamp(1, 60);
        let Some(along) = Along::new(a, b) else { return };
        let (first, last) = (0.15 * along.length, 0.85 * along.length);
        let half = self.sign.min(along.length / 4.0) * 1.2;
        let mut points = vec![a, along.at(first, 0.0)];
        for n in 0..2 * teeth {
            let at = first + (last - first) * (f64::from(n) + 0.5) / f64::from(2 * teeth);
            points.push(along.at(at, if n % 2 == 0 { half } else { -half }));
        }
        points.extend([along.at(last, 0.0), b]);
        self.part(points, Ink::Body, StrokeRole::Spring);
    }

    /// A dashpot: a cylinder on the first point, a piston on the second.
    fn damper(&mut self, a: Point, b: Point) {
        let Some(along) = Along::new(a, b) else { return };
        let length = along.length;
        let half = self.sign.min(length / 4.0) * 1.2;
        let (bottom, piston, brim) = (0.35 * length, 0.52 * length, 0.68 * length);
        self.line(vec![a, along.at(bottom, 0.0)], Ink::Body);
        self.line(
            vec![
                along.at(brim, half),
                along.at(bottom, half),
                along.at(bottom, -half),
                along.at(brim, -half),
            ],
            Ink::Body,
        );
        self.line(vec![along.at(piston, 0.7 * half), along.at(piston, -0.7 * half)], Ink::Body);
        self.line(vec![along.at(piston, 0.0), b], Ink::Body);
    }

    /// A line with a head of so many signs.
    fn arrow(&mut self, tail: Point, head: Point, ink: Ink, signs: f64) {
        self.part(vec![tail, head], ink, StrokeRole::Shaft);
        let Some(along) = Along::new(tail, head) else { return };
        let size = (signs * self.sign).min(0.45 * along.length);
        for side in [0.5, -0.5] {
            self.part(vec![along.at(along.length - size, side * size), head], ink, StrokeRole::Head);
        }
    }
}

/// A direction, with a left-hand side.
struct Along {
    from: Point,
    /// Of length 1.
    direction: Point,
    length: f64,
}

impl Along {
    /// `None` where two points are one.
    fn new(from: Point, to: Point) -> Option<Self> {
        let (across, up) = (to.0 - from.0, to.1 - from.1);
        let length = across.hypot(up);
        (length > 0.0 && length.is_finite()).then(|| Self {
            from,
            direction: (across / length, up / length),
            length,
        })
    }

    /// The point so far along, and so far to the left.
    fn at(&self, along: f64, left: f64) -> Point {
        let (x, y) = self.direction;
        (self.from.0 + along * x - left * y, self.from.1 + along * y + left * x)
    }
}

fn arc(at: Point, radius: f64, from: f64, to: f64) -> Vec<Point> {
    const POINTS: u32 = 72;
    (0..=POINTS)
        .map(|n| from + (to - from) * f64::from(n) / f64::from(POINTS))
        .map(|angle| (at.0 + radius * angle.cos(), at.1 + radius * angle.sin()))
        .collect()
}
