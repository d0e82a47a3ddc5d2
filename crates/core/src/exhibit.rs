//! Plots, tables and drawings: what a solution shows beside its numbers. Plain data in SI.

mod clip;
mod deferred;
mod marks;
mod side;
mod space;
mod units;

use std::{
    borrow::Cow,
    f64::consts::{FRAC_PI_2, TAU},
    fmt,
};

pub use self::clip::clipped;
pub use self::deferred::{Deferred, Frames};
pub(crate) use self::marks::mark_given;
pub use self::side::LabelSide;
pub use self::space::{Point3, Scene, Shape3, Viewpoint3};
use dalembert_units::Unit;

use crate::{Text, intern::fixed};

/// Figure or table of the results.
#[derive(Clone, Debug, PartialEq)]
#[expect(clippy::large_enum_variant, reason = "a solution has a few of them")]
pub enum Exhibit {
    /// Curves over an axis.
    Plot(Plot),
    /// Numbers in rows, as textbooks write them.
    Table(TableExhibit),
    /// A sketch of the machine.
    Drawing(Drawing),
    /// A sketch that moves.
    Animation(Animation),
    /// A sketch in space, which can be seen from every side.
    Scene(Scene),
}

/// Curves over an axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Plot {
    /// Title.
    pub title: Text,
    /// The horizontal axis.
    pub x: Axis,
    /// The vertical axis.
    pub y: Axis,
    /// The curves.
    pub series: Vec<Series>,
    /// Points worth naming: the answers.
    pub marks: Vec<Mark>,
    /// Shaded ranges of `x`.
    pub bands: Vec<Band>,
    /// Horizontal lines worth naming: limits.
    pub levels: Vec<Level>,
    /// Quantity of the horizontal axis that the problem can be solved over; `None` where no input varies along it.
    pub over: Option<Over>,
    /// True if a length across and one up are the same quantity, so that circles are to be round: a path, a Nyquist
    /// plane.
    pub equal: bool,
}

/// Quantity that varies along the horizontal axis of a plot, so that the problem can be solved at every point of it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Over {
    /// The path of the input that is changed: `crank.speed`.
    pub input: String,
    /// The answer that is the abscissa then; `None` where the input itself is.
    pub answer: Option<String>,
}

/// An axis: what it measures, and the unit it is shown in.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// Name of the quantity.
    pub label: Text,
    /// The unit it is shown in.
    pub unit: &'static str,
    /// Spacing of the values.
    pub scale: Scale,
}

/// Spacing of values over an axis: linear or logarithmic.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Scale {
    /// Equal distances for equal differences.
    #[default]
    Linear,
    /// Equal distances for equal ratios; values at or below zero are not drawn.
    Log,
}

/// A curve. A point that is not finite breaks the line.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// Name in the legend.
    pub label: Text,
    /// Points `(x, y)`, in SI.
    pub points: Vec<(f64, f64)>,
    /// True if neighbouring points are joined by a line.
    pub joined: bool,
    /// The answer that it shows, of a vector the size or a component: `frequency[2]`, `force`, `force.x`. Of a number
    /// its size, or all of its rows, where these are drawn: `|amplitude|`, `amplitude[*]`. Or the path of the input,
    /// where a curve is drawn the other way round.
    pub of: Option<String>,
    /// Inputs that have another value than in the problem, for comparison: paths and values in SI.
    pub with: Vec<(String, f64)>,
    /// The input at every point, where the abscissa does not tell it: a path, a loop. Empty otherwise.
    pub at: Vec<f64>,
}

/// A named point of a plot, in SI.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// Name of the mark.
    pub label: Text,
    /// Position `(x, y)`, in SI.
    pub at: (f64, f64),
}

/// A shaded range of `x`, in SI; infinite ends reach the edge.
#[derive(Clone, Debug, PartialEq)]
pub struct Band {
    /// Name of the band.
    pub label: Text,
    /// From.
    pub from: f64,
    /// To.
    pub to: f64,
    /// True for a permitted range, false for a forbidden one.
    pub permitted: bool,
}

/// A named horizontal line of a plot, in SI.
#[derive(Clone, Debug, PartialEq)]
pub struct Level {
    /// Name of the level.
    pub label: Text,
    /// Ordinate of the level, in SI.
    pub y: f64,
}

/// Numbers in rows.
#[derive(Clone, Debug, PartialEq)]
pub struct TableExhibit {
    /// Title.
    pub title: Text,
    /// The columns.
    pub columns: Vec<Column>,
    /// The rows.
    pub rows: Vec<Vec<Cell>>,
    /// The sums under the rows; empty where there are none.
    pub foot: Vec<Cell>,
}

/// A column of a table: its heading and, for numbers, their unit.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// Heading: a symbol or words.
    pub heading: Text,
    /// The unit its numbers are shown in; empty for text.
    pub unit: &'static str,
}

/// A cell of a table.
#[derive(Clone, Debug, PartialEq)]
pub enum Cell {
    /// Nothing.
    Empty,
    /// A number in SI.
    Number(f64),
    /// Words.
    Text(Text),
}

/// A sketch in metres (or in any one length of its own), `y` up.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawing {
    /// Title.
    pub title: Text,
    /// Shapes, later ones over earlier ones.
    pub shapes: Deferred<Vec<DrawnShape>>,
}

/// A sketch that moves: its frames, all in the same coordinates, shown one after another and again.
#[derive(Clone, Debug, PartialEq)]
pub struct Animation {
    /// Title.
    pub title: Text,
    /// Frames; the first one stands for the animation where nothing can move.
    pub frames: Frames,
    /// The time of all frames on the screen, in seconds.
    pub period: f64,
    /// The path of the input that it runs over, and its value in SI at every frame; `None` where no input does.
    pub over: Option<(String, Vec<f64>)>,
}

/// A point of a drawing.
pub type Point = (f64, f64);

/// A part of a drawing.
#[derive(Clone, Debug, PartialEq)]
pub enum DrawnShape {
    /// Straight lines from point to point.
    Polyline(Vec<Point>, Ink),
    /// A circle about a centre.
    Circle(Point, f64, Ink),
    /// Part of a circle, from one angle to another, counter-clockwise, in radians.
    Arc(Point, f64, f64, f64, Ink),
    /// A filled rectangle between two corners: a mass, a machine.
    Block(Point, Point, Ink),
    /// A filled outline through corners: a rigid body.
    Body(Vec<Point>, Ink),
    /// A filled circle about a centre: a wheel, a bob, a joint.
    Disc(Point, f64, Ink),
    /// A fixed pin on ground.
    Pin(Point),
    /// A fixed pin under ground.
    HungPin(Point),
    /// Fixed ground along a line, hatched on its right-hand side seen from the first point.
    Ground(Point, Point),
    /// A helical spring between two points, with so many coils.
    Spring(Point, Point, u32),
    /// A viscous damper between two points.
    Damper(Point, Point),
    /// An arrow from tail to head.
    Arrow(Point, Point, Ink),
    /// A line with a small head at each end: a distance.
    Measure(Point, Point),
    /// Words at a side of a point.
    Label(Point, LabelSide, Text),
    /// Nothing that is seen: opposite corners of what every frame of an animation shows.
    Extent(Point, Point),
}

/// Role of a line, to which each screen and file assigns a colour.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Ink {
    /// The parts of the machine.
    #[default]
    Body,
    /// Centre lines, axes, circles of reference.
    Faint,
    /// Forces, couples and weights.
    Force,
    /// Velocities and motions.
    Motion,
    /// Added by the solution: corrections, results.
    Result,
    /// To be avoided.
    Danger,
}

impl Plot {
    /// True where every curve is zero at all of its points: the plot of a load that there is none of.
    pub(crate) fn is_zero(&self) -> bool {
        !self.series.is_empty() && self.series.iter().flat_map(|curve| &curve.points).all(|(_, y)| *y == 0.0)
    }

    /// A plot without marks, bands or levels.
    pub fn new(title: impl Into<Text>, x: Axis, y: Axis, series: Vec<Series>) -> Self {
        Self {
            title: title.into(),
            x,
            y,
            series,
            marks: Vec::new(),
            bands: Vec::new(),
            levels: Vec::new(),
            over: None,
            equal: false,
        }
    }

    /// The same plot with equal scales across and up.
    #[must_use]
    pub fn equal(self) -> Self {
        Self { equal: true, ..self }
    }

    /// The same plot over the input at a path: every abscissa is a value of it, and a solve with that value gives the
    /// answers that the curves name. Where the problem has no such input, another alternative being chosen, the plot
    /// is over nothing.
    #[must_use]
    pub fn over(self, input: impl fmt::Display) -> Self {
        Self { over: Some(Over { input: input.to_string(), answer: None }), ..self }
    }

    /// The same plot over an answer that changes with the input at a path: a frequency ratio with the frequency.
    #[must_use]
    pub fn over_answer(self, input: impl fmt::Display, answer: impl fmt::Display) -> Self {
        Self { over: Some(Over { input: input.to_string(), answer: Some(answer.to_string()) }), ..self }
    }

    /// The same plot with a named point.
    #[must_use]
    pub fn mark(mut self, label: impl Into<Text>, at: (f64, f64)) -> Self {
        self.marks.push(Mark { label: label.into(), at });
        self
    }

    /// The same plot with a mark on one of its curves, named by the curve and its abscissa.
    #[must_use]
    pub fn mark_on(self, curve: impl Into<Text>, at: (f64, f64)) -> Self {
        let label = marks::on_curve(curve.into(), at.0, self.x.unit);
        self.mark(label, at)
    }

    /// The same plot with a named horizontal line.
    #[must_use]
    pub fn level(mut self, label: impl Into<Text>, y: f64) -> Self {
        self.levels.push(Level { label: label.into(), y });
        self
    }

    /// The same plot with a shaded range.
    #[must_use]
    pub fn band(mut self, label: impl Into<Text>, from: f64, to: f64, permitted: bool) -> Self {
        self.bands.push(Band { label: label.into(), from, to, permitted });
        self
    }
}

impl Animation {
    /// An animation that runs over no input.
    pub fn new(title: impl Into<Text>, frames: Frames, period: f64) -> Self {
        Self { title: title.into(), frames, period, over: None }
    }

    /// The same animation over the input at a path, with its value at every frame: the first frame of a solve with that
    /// value is the same.
    #[must_use]
    pub fn over(self, input: impl fmt::Display, values: Vec<f64>) -> Self {
        Self { over: Some((input.to_string(), values)), ..self }
    }
}

impl Drawing {
    /// The sketch as it belongs to a problem that is still to be solved: without what the solution adds to it (every
    /// line of [`Ink::Result`], and the words that name it) and without numbers. Masses stay, whatever their ink.
    #[must_use]
    pub fn unsolved(&self) -> Self {
        let adds = |shape: &DrawnShape| {
            matches!(
                shape,
                DrawnShape::Polyline(_, Ink::Result)
                    | DrawnShape::Circle(_, _, Ink::Result)
                    | DrawnShape::Arc(_, _, _, _, Ink::Result)
                    | DrawnShape::Arrow(_, _, Ink::Result)
                    | DrawnShape::Body(_, Ink::Result)
                    | DrawnShape::Disc(_, _, Ink::Result)
            )
        };
        let mut shapes = Vec::new();
        let mut after_result = false;
        for shape in self.shapes.iter() {
            match shape {
                shape if adds(shape) => after_result = true,
                DrawnShape::Label(..) if after_result => {}
                DrawnShape::Label(at, side, words) => {
                    shapes.push(DrawnShape::Label(*at, *side, words.without_numbers()));
                }
                shape => {
                    after_result = false;
                    shapes.push(shape.clone());
                }
            }
        }
        Self { title: self.title.without_numbers(), shapes: shapes.into() }
    }
}

impl DrawnShape {
    /// The points that say how large a drawing is.
    pub fn corners(&self) -> Vec<Point> {
        match self {
            DrawnShape::Polyline(points, _) | DrawnShape::Body(points, _) => points.clone(),
            DrawnShape::Circle(at, radius, _) | DrawnShape::Disc(at, radius, _) => {
                vec![(at.0 - radius, at.1 - radius), (at.0 + radius, at.1 + radius)]
            }
            DrawnShape::Arc(at, radius, from, to, _) => {
                // Its ends, and where it turns back on the way.
                let last = from + if (0.0..=TAU).contains(&(to - from)) { to - from } else { TAU };
                let quarters = (0..5).map(|n| ((from / FRAC_PI_2).ceil() + f64::from(n)) * FRAC_PI_2);
                [*from, last]
                    .into_iter()
                    .chain(quarters.filter(|angle| *angle < last))
                    .map(|angle| (at.0 + radius * angle.cos(), at.1 + radius * angle.sin()))
                    .collect()
            }
            DrawnShape::Block(a, b, _)
            | DrawnShape::Ground(a, b)
            | DrawnShape::Spring(a, b, _)
            | DrawnShape::Damper(a, b)
            | DrawnShape::Arrow(a, b, _)
            | DrawnShape::Measure(a, b)
            | DrawnShape::Extent(a, b) => vec![*a, *b],
            DrawnShape::Pin(at) | DrawnShape::HungPin(at) | DrawnShape::Label(at, ..) => vec![*at],
        }
    }
}

impl Exhibit {
    /// Drawing of a frame, for a sketch; the frames of a moving one repeat without end.
    pub fn sketch(&self, frame: usize) -> Option<Cow<'_, Drawing>> {
        self.projected(frame, None)
    }

    /// The same, a scene in space as it is seen from a side; `None` for its usual one.
    pub fn projected(&self, frame: usize, view: Option<Viewpoint3>) -> Option<Cow<'_, Drawing>> {
        match self {
            Exhibit::Drawing(drawing) => Some(Cow::Borrowed(drawing)),
            Exhibit::Animation(animation) => {
                let shapes: Vec<DrawnShape> =
                    animation.frames.get(frame % animation.frames.len().max(1)).cloned().unwrap_or_default();
                Some(Cow::Owned(Drawing { title: animation.title.clone(), shapes: shapes.into() }))
            }
            Exhibit::Scene(scene) => Some(Cow::Owned(scene.seen(frame, view.unwrap_or(scene.view)))),
            Exhibit::Plot(_) | Exhibit::Table(_) => None,
        }
    }

    /// Number of frames of a sketch, and their total time in seconds.
    pub fn frames(&self) -> (usize, f64) {
        match self {
            Exhibit::Animation(animation) => (animation.frames.len(), animation.period),
            Exhibit::Scene(scene) => (scene.frames.len(), scene.period),
            Exhibit::Drawing(_) => (1, 0.0),
            Exhibit::Plot(_) | Exhibit::Table(_) => (0, 0.0),
        }
    }
}

impl Axis {
    /// A linear axis.
    pub fn linear(label: impl Into<Text>, unit: &'static str) -> Self {
        Self { label: label.into(), unit, scale: Scale::Linear }
    }

    /// A linear axis in a unit that was read.
    pub fn in_unit(label: impl Into<Text>, unit: &Unit) -> Self {
        Self::linear(label, fixed(unit))
    }

    /// A logarithmic axis.
    pub fn log(label: impl Into<Text>, unit: &'static str) -> Self {
        Self { label: label.into(), unit, scale: Scale::Log }
    }
}

impl Series {
    /// A curve through points.
    pub fn line(label: impl Into<Text>, points: Vec<(f64, f64)>) -> Self {
        Self { label: label.into(), points, joined: true, of: None, with: Vec::new(), at: Vec::new() }
    }

    /// The same curve with its reflection in the axis of zero: an envelope.
    #[must_use]
    pub fn with_reflection(mut self) -> Self {
        // A point that is not finite parts the two.
        self.points.push((f64::INFINITY, f64::INFINITY));
        let above = self.points.len() - 1;
        self.points.extend_from_within(..above);
        self.points[above + 1..].iter_mut().for_each(|(_, y)| *y = -*y);
        self
    }

    /// Separate points.
    pub fn dots(label: impl Into<Text>, points: Vec<(f64, f64)>) -> Self {
        Self { label: label.into(), points, joined: false, of: None, with: Vec::new(), at: Vec::new() }
    }

    /// The same curve, as what an answer is over the abscissa of its plot.
    #[must_use]
    pub fn of(self, answer: impl fmt::Display) -> Self {
        Self { of: Some(answer.to_string()), ..self }
    }

    /// The same curve, with the input at every point of it.
    #[must_use]
    pub fn at(self, values: Vec<f64>) -> Self {
        Self { at: values, ..self }
    }

    /// The same curve, as what its answer would be with another value of the input at a path.
    #[must_use]
    pub fn with(mut self, input: impl fmt::Display, si: f64) -> Self {
        self.with.push((input.to_string(), si));
        self
    }
}

impl From<f64> for Cell {
    fn from(si: f64) -> Self {
        Cell::Number(si)
    }
}

impl From<Text> for Cell {
    fn from(text: Text) -> Self {
        Cell::Text(text)
    }
}

impl From<&'static str> for Cell {
    fn from(text: &'static str) -> Self {
        Cell::Text(text.into())
    }
}

impl Exhibit {
    /// Renames the exhibit as that of one of several problems: its title, its answers and its inputs.
    pub(crate) fn rename(
        &mut self,
        title: &dyn Fn(&Text) -> Text,
        answer: &dyn Fn(&str) -> String,
        input: &dyn Fn(&str) -> String,
    ) {
        match self {
            Exhibit::Plot(plot) => {
                plot.title = title(&plot.title);
                if let Some(over) = &mut plot.over {
                    over.input = input(&over.input);
                    over.answer = over.answer.as_deref().map(answer);
                }
                for series in &mut plot.series {
                    series.of = series.of.as_deref().map(answer);
                    for (path, _) in &mut series.with {
                        *path = input(path);
                    }
                }
            }
            Exhibit::Table(table) => table.title = title(&table.title),
            Exhibit::Drawing(drawing) => drawing.title = title(&drawing.title),
            Exhibit::Animation(animation) => {
                animation.title = title(&animation.title);
                if let Some((path, _)) = &mut animation.over {
                    *path = input(path);
                }
            }
            Exhibit::Scene(scene) => scene.title = title(&scene.title),
        }
    }
}
