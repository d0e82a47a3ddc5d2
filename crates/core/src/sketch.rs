//! Sketches of machines: symbols at points, with the letters of the textbooks.
//!
//! A sketch is written as a list of symbols. Their size follows the size of the whole sketch, springs have coils of one
//! pitch, and every letter is placed where it covers least ([`placement`]). Later symbols lie over earlier ones.
//!
//! ```
//! use dalembert_core::{Drawing, Sketch};
//!
//! /// A slider-crank: crank 2, coupler 3, slider 4.
//! fn slider_crank(crank: f64, coupler: f64, angle: f64) -> Drawing {
//!     let a = (crank * angle.cos(), crank * angle.sin());
//!     let b = (a.0 + (coupler.powi(2) - a.1.powi(2)).sqrt(), 0.0);
//!     Sketch::new("Slider-crank")
//!         .guide((coupler - crank, 0.0), (coupler + crank, 0.0))
//!         .slider("", b, 0.0)
//!         .link("r", (0.0, 0.0), a)
//!         .link("l", a, b)
//!         .pin("O", (0.0, 0.0))
//!         .joint("A", a)
//!         .joint("B", b)
//!         .angle("θ₂", (0.0, 0.0), 0.0, angle)
//!         .force("F", (b.0 + crank, 0.0), (b.0 + 0.3 * crank, 0.0))
//!         .finish()
//! }
//!
//! let drawing = slider_crank(0.1, 0.35, 0.6);
//! assert_eq!(drawing.title.english(), "Slider-crank");
//! ```
//!
//! An animation is one sketch for each frame, joined by [`Sketch::animation`]: all frames share one window,
//! symbols keep their size, springs their coils and letters their sides.

mod part;
pub mod placement;

use self::{
    part::{Item, Part, items},
    placement::sides,
};
use crate::{Animation, Deferred, Drawing, DrawnShape, Frames, Ink, LabelSide, Point, Text};

/// A drawing in the making. Names that are empty are not written.
#[derive(Clone, Debug, Default)]
pub struct Sketch {
    title: Text,
    size: Option<f64>,
    parts: Vec<Part>,
}

impl Sketch {
    /// An empty sketch.
    pub fn new(title: impl Into<Text>) -> Self {
        Self { title: title.into(), ..Self::default() }
    }

    /// The same sketch under another title.
    #[must_use]
    pub fn titled(self, title: impl Into<Text>) -> Self {
        Self { title: title.into(), ..self }
    }

    /// Scales the symbols to a sketch of this size, rather than to the extent of what is drawn: where the same symbols
    /// have to come out alike in several sketches.
    pub fn size(&mut self, size: f64) -> &mut Self {
        self.size = Some(size);
        self
    }

    /// The size of a symbol, a thirtieth of the sketch: half the height of a slider is a little more. Known where the size of
    /// the sketch was set.
    pub fn symbol(&self) -> f64 {
        part::symbol(self.size)
    }

    /// Fixed ground along a line, hatched on its right-hand side seen from the first point.
    pub fn ground(&mut self, from: Point, to: Point) -> &mut Self {
        self.shape(DrawnShape::Ground(from, to))
    }

    /// A fixed pin on ground.
    pub fn pin(&mut self, name: impl Into<Text>, at: Point) -> &mut Self {
        self.add(Part::Pin(at), name)
    }

    /// A fixed pin under ground: the pivot of what hangs.
    pub fn hung_pin(&mut self, name: impl Into<Text>, at: Point) -> &mut Self {
        self.add(Part::HungPin(at), name)
    }

    /// A pin that joins moving links.
    pub fn joint(&mut self, name: impl Into<Text>, at: Point) -> &mut Self {
        self.add(Part::Joint(at), name)
    }

    /// A roller on ground that carries a point.
    pub fn roller(&mut self, name: impl Into<Text>, at: Point) -> &mut Self {
        self.add(Part::Roller(at), name)
    }

    /// A bearing of a shaft that lies in the direction of an angle.
    pub fn bearing(&mut self, name: impl Into<Text>, at: Point, angle: f64) -> &mut Self {
        self.add(Part::Bearing(at, angle), name)
    }

    /// A slider, turned by an angle; links and joints written later lie over it.
    pub fn slider(&mut self, name: impl Into<Text>, at: Point, angle: f64) -> &mut Self {
        self.add(Part::Slider(at, angle), name)
    }

    /// The guide of a slider whose centre moves along a line; it lies on the right-hand side seen from the first point.
    pub fn guide(&mut self, from: Point, to: Point) -> &mut Self {
        self.add(Part::Guide(from, to), "")
    }

    /// A bar between two points, or a beam, a shaft, a rope: a line with a name at its middle.
    pub fn link(&mut self, name: impl Into<Text>, from: Point, to: Point) -> &mut Self {
        self.add(Part::Line(vec![from, to], Ink::Body), name)
    }

    /// Bars from point to point.
    pub fn bars(&mut self, points: impl Into<Vec<Point>>) -> &mut Self {
        self.curve(points, Ink::Body)
    }

    /// An axis, a centre line, a line of reference.
    pub fn axis(&mut self, from: Point, to: Point) -> &mut Self {
        self.curve([from, to], Ink::Faint)
    }

    /// Two perpendicular axes through a centre, so far to every side.
    pub fn axes(&mut self, (x, y): Point, reach: f64) -> &mut Self {
        self.axis((x - reach, y), (x + reach, y)).axis((x, y - reach), (x, y + reach))
    }

    /// A line from point to point.
    pub fn curve(&mut self, points: impl Into<Vec<Point>>, ink: Ink) -> &mut Self {
        self.shape(DrawnShape::Polyline(points.into(), ink))
    }

    /// A line in an ink, with a name at its middle.
    pub fn line(&mut self, name: impl Into<Text>, from: Point, to: Point, ink: Ink) -> &mut Self {
        self.add(Part::Line(vec![from, to], ink), name)
    }

    /// A rigid body, by the corners of its outline.
    pub fn body(&mut self, name: impl Into<Text>, corners: impl Into<Vec<Point>>) -> &mut Self {
        self.add(Part::Body(corners.into(), Ink::Body), name)
    }

    /// A mass: a rectangle between two corners.
    pub fn mass(&mut self, name: impl Into<Text>, from: Point, to: Point) -> &mut Self {
        self.block(name, from, to, Ink::Body)
    }

    /// A rectangle between two corners, in an ink.
    pub fn block(&mut self, name: impl Into<Text>, from: Point, to: Point, ink: Ink) -> &mut Self {
        self.add(Part::Block(from, to, ink), name)
    }

    /// A square mass about a centre, of the size of a symbol.
    pub fn particle(&mut self, name: impl Into<Text>, at: Point) -> &mut Self {
        self.add(Part::Particle(at), name)
    }

    /// A disc, a wheel, a bob.
    pub fn disc(&mut self, name: impl Into<Text>, at: Point, radius: f64) -> &mut Self {
        self.round(name, at, radius, Ink::Body)
    }

    /// A filled circle, in an ink.
    pub fn round(&mut self, name: impl Into<Text>, at: Point, radius: f64, ink: Ink) -> &mut Self {
        self.add(Part::Round(at, radius, ink), name)
    }

    /// A circle that hides nothing: a path, a circle of reference.
    pub fn circle(&mut self, at: Point, radius: f64, ink: Ink) -> &mut Self {
        self.shape(DrawnShape::Circle(at, radius, ink))
    }

    /// Part of a circle, from one angle to another, counter-clockwise.
    pub fn arc(&mut self, at: Point, radius: f64, (from, to): (f64, f64), ink: Ink) -> &mut Self {
        self.shape(DrawnShape::Arc(at, radius, from, to, ink))
    }

    /// A gear by its pitch circle with teeth, and a line at the angle by which it is turned; a pair of gears is two of them.
    pub fn gear(&mut self, name: impl Into<Text>, at: Point, radius: f64, angle: f64) -> &mut Self {
        self.add(Part::Gear(at, radius, angle), name)
    }

    /// A pulley over which a cord runs.
    pub fn pulley(&mut self, name: impl Into<Text>, at: Point, radius: f64) -> &mut Self {
        self.disc(name, at, radius).joint("", at)
    }

    /// A cord from point to point.
    pub fn cord(&mut self, points: impl Into<Vec<Point>>) -> &mut Self {
        self.curve(points, Ink::Faint)
    }

    /// A helical spring; the longer it is, the more coils it has.
    pub fn spring(&mut self, name: impl Into<Text>, from: Point, to: Point) -> &mut Self {
        self.add(Part::Spring(from, to), name)
    }

    /// A torsion spring about a point; its outer end leaves at an angle.
    pub fn torsion_spring(&mut self, name: impl Into<Text>, at: Point, angle: f64) -> &mut Self {
        self.add(Part::TorsionSpring(at, angle), name)
    }

    /// A hydraulic cylinder: its barrel, of a length, hangs on the first point, its rod on the second.
    pub fn cylinder(&mut self, name: impl Into<Text>, from: Point, to: Point, barrel: f64) -> &mut Self {
        self.add(Part::Cylinder(from, to, barrel), name)
    }

    /// A dashpot: a cylinder on the first point, a piston on the second.
    pub fn damper(&mut self, name: impl Into<Text>, from: Point, to: Point) -> &mut Self {
        self.add(Part::Damper(from, to), name)
    }

    /// A spring and, at its right-hand side seen from the first point, a dashpot, side by side about a line.
    pub fn spring_and_damper(
        &mut self,
        (spring, damper): (impl Into<Text>, impl Into<Text>),
        from: Point,
        to: Point,
        apart: f64,
    ) -> &mut Self {
        let length = (to.0 - from.0).hypot(to.1 - from.1);
        let left = (-(to.1 - from.1) * apart / length, (to.0 - from.0) * apart / length);
        let beside = |at: Point, side: f64| (at.0 + side * left.0 / 2.0, at.1 + side * left.1 / 2.0);
        self.spring(spring, beside(from, 1.0), beside(to, 1.0));
        self.damper(damper, beside(from, -1.0), beside(to, -1.0))
    }

    /// A centre of mass.
    pub fn mass_centre(&mut self, name: impl Into<Text>, at: Point) -> &mut Self {
        self.add(Part::MassCentre(at), name)
    }

    /// A force or a weight.
    pub fn force(&mut self, name: impl Into<Text>, tail: Point, head: Point) -> &mut Self {
        self.vector(name, tail, head, Ink::Force)
    }

    /// A velocity, an acceleration, the direction of a coordinate.
    pub fn motion(&mut self, name: impl Into<Text>, tail: Point, head: Point) -> &mut Self {
        self.vector(name, tail, head, Ink::Motion)
    }

    /// A vector with its name at its head; nothing where it has no length.
    pub fn vector(&mut self, name: impl Into<Text>, tail: Point, head: Point, ink: Ink) -> &mut Self {
        self.add(Part::Vector(tail, head, ink), name)
    }

    /// A vector of a polygon, with its name at its middle.
    pub fn edge(&mut self, name: impl Into<Text>, tail: Point, head: Point, ink: Ink) -> &mut Self {
        self.add(Part::Edge(tail, head, ink), name)
    }

    /// A couple or a rotation: an arrow round a point from one angle to another.
    pub fn couple(
        &mut self,
        name: impl Into<Text>,
        at: Point,
        (from, to): (f64, f64),
        ink: Ink,
    ) -> &mut Self {
        self.add(Part::Couple(at, from, to, ink), name)
    }

    /// An angle about a point, from one direction to another.
    pub fn angle(&mut self, name: impl Into<Text>, at: Point, from: f64, to: f64) -> &mut Self {
        self.add(Part::Angle(at, from, to), name)
    }

    /// A distance between two points. Its line lies beside them by so many sizes of a symbol, at the left-hand side
    /// seen from the first point, or with a negative number at the right-hand side.
    pub fn dimension(&mut self, name: impl Into<Text>, from: Point, to: Point, shift: f64) -> &mut Self {
        self.add(Part::Dimension(from, to, shift), name)
    }

    /// The name of a point.
    pub fn label(&mut self, name: impl Into<Text>, at: Point) -> &mut Self {
        self.add(Part::Nothing(at), name)
    }

    /// Words centred on a point.
    pub fn caption(&mut self, words: impl Into<Text>, at: Point) -> &mut Self {
        self.add(Part::Centre(at), words)
    }

    /// The symbols of another sketch.
    pub fn include(&mut self, other: Sketch) -> &mut Self {
        self.parts.extend(other.parts);
        self
    }

    /// The drawing; its names are placed when its shapes are first read. The sketch is empty afterwards.
    pub fn finish(&mut self) -> Drawing {
        let Self { title, size, parts } = std::mem::take(self);
        Drawing { title, shapes: Deferred::new(move || placed(&[&parts], size).concat()) }
    }

    /// The frames of an animation, in one window.
    pub fn animation(
        title: impl Into<Text>,
        frames: impl IntoIterator<Item = Sketch>,
        period: f64,
    ) -> Animation {
        let frames: Vec<Sketch> = frames.into_iter().collect();
        let size = frames.iter().find_map(|frame| frame.size);
        let parts: Vec<Vec<Part>> = frames.into_iter().map(|frame| frame.parts).collect();
        let frames = Frames::new(parts.len(), move || {
            let parts: Vec<&[Part]> = parts.iter().map(Vec::as_slice).collect();
            placed(&parts, size)
        });
        Animation::new(title, frames, period)
    }

    fn shape(&mut self, shape: DrawnShape) -> &mut Self {
        self.add(Part::Shape(shape), "")
    }

    fn add(&mut self, part: Part, name: impl Into<Text>) -> &mut Self {
        let name = name.into();
        self.parts.push(if name.is_empty() { part } else { Part::Named(Box::new(part), name) });
        self
    }
}

/// The shapes of frames that share one window.
fn placed(frames: &[&[Part]], size: Option<f64>) -> Vec<Vec<DrawnShape>> {
    let unit = part::unit(frames.iter().copied().flatten(), size);
    let frames: Vec<Vec<Item>> = frames.iter().map(|parts| items(parts, unit)).collect();
    let coils = coils(&frames, unit);
    let (mut words, mut shapes) = (Vec::new(), Vec::new());
    for items in &frames {
        let (mut named, mut drawn) = (Vec::new(), Vec::new());
        for item in items {
            match item {
                Item::Words(one) => named.push(one.clone()),
                Item::Shape(shape) => drawn.push(shape.clone()),
            }
        }
        words.push(named);
        shapes.push(drawn);
    }
    let window = part::window(shapes.iter().flatten()).filter(|_| frames.len() > 1);
    let sides = sides(&words, &shapes, unit);
    let finished = |(items, sides): (Vec<Item>, Vec<LabelSide>)| {
        let (mut sides, mut coils) = (sides.into_iter(), coils.iter());
        let shape = |item| match item {
            Item::Shape(DrawnShape::Spring(from, to, _)) => {
                DrawnShape::Spring(from, to, coils.next().copied().unwrap_or_default())
            }
            Item::Shape(shape) => shape,
            Item::Words(words) => {
                let side = sides.next().unwrap_or_default();
                DrawnShape::Label(words.anchor(side), side, words.text)
            }
        };
        let mut shapes: Vec<DrawnShape> = items.into_iter().map(shape).collect();
        shapes.extend(window.map(|(low, high)| DrawnShape::Extent(low, high)));
        shapes
    };
    frames.into_iter().zip(sides).map(finished).collect()
}

/// The coils of the springs of a frame, in their order: as many in every frame as its mean length has room for.
fn coils(frames: &[Vec<Item>], unit: f64) -> Vec<u32> {
    let mut lengths: Vec<(f64, u32)> = Vec::new();
    for items in frames {
        let springs = items.iter().filter_map(|item| match item {
            Item::Shape(DrawnShape::Spring(from, to, _)) => Some((to.0 - from.0).hypot(to.1 - from.1)),
            _ => None,
        });
        for (n, length) in springs.enumerate() {
            if n == lengths.len() {
                lengths.push((0.0, 0));
            }
            lengths[n] = (lengths[n].0 + length, lengths[n].1 + 1);
        }
    }
    lengths.into_iter().map(|(sum, count)| part::coils(sum / f64::from(count), unit)).collect()
}

#[cfg(test)]
mod tests;
