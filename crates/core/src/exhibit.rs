//! Plots, tables and drawings: what a solution shows beside its numbers. Plain data in SI.

mod clip;
mod space;

use std::borrow::Cow;

pub use self::clip::clipped;
pub use self::space::{Scene, SpacePoint, SpaceShape, View};
use crate::Text;

/// Something to look at.
#[derive(Clone, Debug, PartialEq)]
pub enum Exhibit {
    /// Curves over an axis.
    Plot(Plot),
    /// Numbers in rows, as textbooks write them.
    Table(TableExhibit),
    /// A sketch of the machine.
    Drawing(Drawing),
    /// A sketch that moves.
    Film(Film),
    /// A sketch in space, which can be seen from every side.
    Scene(Scene),
}

/// Curves over an axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Plot {
    /// What it shows.
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
}

/// An axis: what it measures, and the unit it is shown in.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// What it measures.
    pub label: Text,
    /// The unit it is shown in.
    pub unit: &'static str,
    /// How values are spread.
    pub scale: Scale,
}

/// How values are spread over an axis.
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
    /// Its name in the legend.
    pub label: Text,
    /// Its points, in SI.
    pub points: Vec<(f64, f64)>,
    /// Whether neighbouring points are joined.
    pub joined: bool,
}

/// A named point of a plot, in SI.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// Its name.
    pub label: Text,
    /// Where it is.
    pub at: (f64, f64),
}

/// A shaded range of `x`, in SI; infinite ends reach the edge.
#[derive(Clone, Debug, PartialEq)]
pub struct Band {
    /// Its name.
    pub label: Text,
    /// From.
    pub from: f64,
    /// To.
    pub to: f64,
    /// Whether it is the good range or the bad one.
    pub permitted: bool,
}

/// A named horizontal line of a plot, in SI.
#[derive(Clone, Debug, PartialEq)]
pub struct Level {
    /// Its name.
    pub label: Text,
    /// Where it is.
    pub y: f64,
}

/// Numbers in rows.
#[derive(Clone, Debug, PartialEq)]
pub struct TableExhibit {
    /// What it shows.
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
    /// Its heading: a symbol or words.
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
    /// What it shows.
    pub title: Text,
    /// Its parts, later ones over earlier ones.
    pub shapes: Vec<DrawnShape>,
}

/// A sketch that moves: its frames, all in the same coordinates, shown one after another and again.
#[derive(Clone, Debug, PartialEq)]
pub struct Film {
    /// What it shows.
    pub title: Text,
    /// Its frames; the first one stands for the film where nothing can move.
    pub frames: Vec<Vec<DrawnShape>>,
    /// The time of all frames on the screen, in seconds.
    pub period: f64,
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
    /// A fixed pin.
    Pin(Point),
    /// Fixed ground along a line, hatched on its right-hand side seen from the first point.
    Ground(Point, Point),
    /// A helical spring between two points.
    Spring(Point, Point),
    /// A viscous damper between two points.
    Damper(Point, Point),
    /// An arrow from tail to head.
    Arrow(Point, Point, Ink),
    /// Words beside a point.
    Label(Point, Text),
}

/// What a line stands for; each screen and file gives it a colour.
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
    /// What the solution adds: corrections, results.
    Result,
    /// What is to be avoided.
    Danger,
}

impl Plot {
    /// A plot without marks, bands or levels.
    pub fn new(title: impl Into<Text>, x: Axis, y: Axis, series: Vec<Series>) -> Self {
        Self { title: title.into(), x, y, series, marks: Vec::new(), bands: Vec::new(), levels: Vec::new() }
    }

    /// The same plot with a named point.
    #[must_use]
    pub fn mark(mut self, label: impl Into<Text>, at: (f64, f64)) -> Self {
        self.marks.push(Mark { label: label.into(), at });
        self
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
            )
        };
        let mut shapes = Vec::new();
        let mut after_result = false;
        for shape in &self.shapes {
            match shape {
                shape if adds(shape) => after_result = true,
                DrawnShape::Label(..) if after_result => {}
                DrawnShape::Label(at, words) => {
                    shapes.push(DrawnShape::Label(*at, words.without_numbers()));
                }
                shape => {
                    after_result = false;
                    shapes.push(shape.clone());
                }
            }
        }
        Self { title: self.title.without_numbers(), shapes }
    }
}

impl Exhibit {
    /// What is to be drawn at that frame, where it is a sketch; the frames of one that moves repeat without end.
    pub fn sketch(&self, frame: usize) -> Option<Cow<'_, Drawing>> {
        self.sketch_seen(frame, None)
    }

    /// The same, a scene in space as it is seen from a side; `None` for its usual one.
    pub fn sketch_seen(&self, frame: usize, view: Option<View>) -> Option<Cow<'_, Drawing>> {
        match self {
            Exhibit::Drawing(drawing) => Some(Cow::Borrowed(drawing)),
            Exhibit::Film(film) => {
                let shapes = film.frames.get(frame % film.frames.len().max(1)).cloned().unwrap_or_default();
                Some(Cow::Owned(Drawing { title: film.title.clone(), shapes }))
            }
            Exhibit::Scene(scene) => Some(Cow::Owned(scene.seen(frame, view.unwrap_or(scene.view)))),
            Exhibit::Plot(_) | Exhibit::Table(_) => None,
        }
    }

    /// How many frames a sketch has, and the time of all of them in seconds.
    pub fn frames(&self) -> (usize, f64) {
        match self {
            Exhibit::Film(film) => (film.frames.len(), film.period),
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

    /// A logarithmic axis.
    pub fn log(label: impl Into<Text>, unit: &'static str) -> Self {
        Self { label: label.into(), unit, scale: Scale::Log }
    }
}

impl Series {
    /// A curve through points.
    pub fn line(label: impl Into<Text>, points: Vec<(f64, f64)>) -> Self {
        Self { label: label.into(), points, joined: true }
    }

    /// Separate points.
    pub fn dots(label: impl Into<Text>, points: Vec<(f64, f64)>) -> Self {
        Self { label: label.into(), points, joined: false }
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
