//! The sides at which the names of a sketch stand: where they cover least, and the same in every frame.
//!
//! A name belongs to a point. Each of the eight sides of it has a price: what words of usual size would cover there,
//! their distance from the point, and the turn from the side that the symbol wants. The cheapest side is taken, name by
//! name, and once more when all others are known. Nothing is drawn at random, so that the same sketch has the same sides.

use std::f64::consts::TAU;

use crate::{DrawnShape, LabelSide, Point, Text};

/// A name and the point that it belongs to.
#[derive(Clone, Debug, PartialEq)]
pub struct Words {
    /// The point.
    pub at: Point,
    /// The side that they want.
    pub towards: Towards,
    /// Half the width of a symbol along a line, at whose edge they stand.
    pub half: f64,
    /// The words.
    pub text: Text,
}

impl Words {
    /// The point that they stand beside: at a wide symbol along a line, its edge on their side.
    pub(super) fn anchor(&self, side: LabelSide) -> Point {
        let Towards::Across((x, y)) = self.towards else { return self.at };
        let (right, up) = side.direction();
        let left = if x * up - y * right < 0.0 { -self.half } else { self.half };
        (self.at.0 - left * y, self.at.1 + left * x)
    }
}

/// The side of its point that a name wants.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub enum Towards {
    /// Away from the middle of the sketch.
    #[default]
    Out,
    /// In a direction.
    To(Point),
    /// At either side of a line in that direction.
    Across(Point),
    /// Over the point, if they are not wider than this.
    Over(f64),
}

/// The width of a letter, in sizes of a symbol: that of a screen where a sketch is forty cells wide.
const LETTER: f64 = 0.75;
/// The height of a line of words, in sizes of a symbol.
const LINE: f64 = 1.5;
/// Frames that a side is chosen by.
const SEEN: usize = 4;
/// The price of words over other words.
const OVER_WORDS: f64 = 40.0;
/// Distances from its point at which a name is tried, in sizes of a symbol.
const DISTANCES: [f64; 4] = [0.0, 1.0, 2.0, 3.0];

/// The sides of the words of every frame, in their order. Words that are the same in several frames, counted among equal
/// ones, keep their side; `unit` is the size of a symbol.
pub fn sides(words: &[Vec<Words>], shapes: &[Vec<DrawnShape>], unit: f64) -> Vec<Vec<LabelSide>> {
    let marks: Vec<Marks> = seen(shapes.len()).map(|frame| Marks::of(&shapes[frame], unit)).collect();
    let centre = centre(shapes.iter().flatten());
    let names = names(words);
    let candidates: Vec<Candidate> =
        names.iter().map(|name| Candidate::new(name, words, &marks, centre, unit)).collect();
    let mut chosen: Vec<Option<LabelSide>> = candidates.iter().map(|name| name.fixed).collect();
    for _ in 0..2 {
        for name in (0..names.len()).filter(|name| candidates[*name].fixed.is_none()) {
            let others = (0..names.len()).filter(|other| *other != name);
            let others: Vec<(&Candidate, LabelSide)> =
                others.filter_map(|other| Some((&candidates[other], chosen[other]?))).collect();
            chosen[name] = (0..LabelSide::AROUND.len())
                .map(|side| (candidates[name].price(side, &others), LabelSide::AROUND[side]))
                .reduce(|best, next| if next.0 < best.0 - 1e-9 { next } else { best })
                .map(|(_, side)| side);
        }
    }
    let mut sides: Vec<Vec<LabelSide>> =
        words.iter().map(|words| vec![LabelSide::default(); words.len()]).collect();
    for (places, side) in names.iter().zip(chosen) {
        for (frame, row) in places {
            sides[*frame][*row] = side.unwrap_or_default();
        }
    }
    sides
}

/// A name whose side is to be chosen, with what each side costs for itself.
struct Candidate {
    /// The side of words that stand over their point.
    fixed: Option<LabelSide>,
    /// In each frame that sides are chosen by: the area at each side, and the price of the lines that it covers.
    frames: Vec<Option<[(Area, f64); LabelSide::AROUND.len()]>>,
    /// Area over the point in each of these frames.
    over: Vec<Option<Area>>,
    /// The price of each side for not being the wanted one.
    turns: [f64; LabelSide::AROUND.len()],
}

impl Candidate {
    fn new(name: &[(usize, usize)], words: &[Vec<Words>], marks: &[Marks], centre: Point, unit: f64) -> Self {
        let first = &words[name[0].0][name[0].1];
        let is_over = matches!(first.towards, Towards::Over(room) if width(&first.text, unit) <= room);
        let fixed = is_over.then_some(LabelSide::Over);
        let here: Vec<Option<&Words>> = seen(words.len())
            .map(|frame| {
                let row = name.binary_search_by_key(&frame, |(at, _)| *at).ok()?;
                Some(&words[frame][name[row].1])
            })
            .collect();
        let place =
            |words: &Words, side| place(words.anchor(side), width(&words.text, unit), side, 0.0, unit);
        let frames = here.iter().zip(marks).map(|(one, marks)| {
            let one = one.filter(|_| !is_over)?;
            let wide = width(&one.text, unit);
            let near = marks.near(one, wide, unit);
            let covered = |side| near.covered(one.anchor(side), wide, side, unit);
            Some(LabelSide::AROUND.map(|side| (place(one, side), covered(side))))
        });
        Self {
            fixed,
            frames: frames.collect(),
            over: here.iter().map(|one| Some(place((*one)?, LabelSide::Over)).filter(|_| is_over)).collect(),
            turns: LabelSide::AROUND.map(|side| turn(first, side, centre)),
        }
    }

    /// The area of the name at a side, in one of the frames that sides are chosen by.
    fn area(&self, frame: usize, side: LabelSide) -> Option<Area> {
        match LabelSide::AROUND.iter().position(|known| *known == side) {
            Some(side) => self.frames[frame].as_ref().map(|sides| sides[side].0),
            None => self.over[frame],
        }
    }

    /// The price of a side beside other names at theirs: the mean over the frames, and the turn.
    fn price(&self, side: usize, others: &[(&Candidate, LabelSide)]) -> f64 {
        let mut sum = 0.0;
        for (frame, sides) in self.frames.iter().enumerate() {
            let Some(sides) = sides else { continue };
            let ([left, bottom, right, top], lines) = sides[side];
            let over =
                |other: &Area| other[0] < right && other[2] > left && other[1] < top && other[3] > bottom;
            let covered = others.iter().filter_map(|(other, side)| other.area(frame, *side)).filter(over);
            sum += lines + OVER_WORDS * covered.count() as f64;
        }
        sum / self.frames.len().max(1) as f64 + self.turns[side]
    }
}

/// The frames and rows of each name.
fn names(words: &[Vec<Words>]) -> Vec<Vec<(usize, usize)>> {
    let mut keys: Vec<(&Text, usize)> = Vec::new();
    let mut names: Vec<Vec<(usize, usize)>> = Vec::new();
    for (frame, here) in words.iter().enumerate() {
        // Nearly always the words of the first frame.
        let is_first = |first: &Vec<Words>| {
            first.len() == here.len() && first.iter().zip(here).all(|(a, b)| a.text == b.text)
        };
        if frame > 0 && words.first().is_some_and(is_first) {
            names.iter_mut().zip(0..here.len()).for_each(|(name, row)| name.push((frame, row)));
            continue;
        }
        for (row, one) in here.iter().enumerate() {
            let before = here[..row].iter().filter(|other| other.text == one.text).count();
            let key = (&one.text, before);
            match keys.iter().position(|other| *other == key) {
                Some(name) => names[name].push((frame, row)),
                None => {
                    keys.push(key);
                    names.push(vec![(frame, row)]);
                }
            }
        }
    }
    names
}

/// The frames that sides are chosen by.
fn seen(frames: usize) -> impl Iterator<Item = usize> {
    (0..frames).step_by(frames.div_ceil(SEEN).max(1))
}

fn width(text: &Text, unit: f64) -> f64 {
    LETTER * unit * text.english().chars().count() as f64
}

/// A box: left, bottom, right, top.
type Area = [f64; 4];

/// The area of words of a width at a side of their point.
fn place(at: Point, wide: f64, side: LabelSide, distance: f64, unit: f64) -> Area {
    let high = LINE * unit;
    let (x, y) = side.direction();
    let towards = |part: f64| if part.abs() < 0.1 { 0.0 } else { part.signum() };
    // Words at a corner begin nearer to the point than words straight beside it.
    let near = if x != 0.0 && y != 0.0 { 0.5 } else { 1.0 };
    let gap = |from: f64| near * (from + distance) * unit;
    let centre = (at.0 + towards(x) * (gap(0.9) + wide / 2.0), at.1 + towards(y) * (gap(0.4) + high / 2.0));
    [centre.0 - wide / 2.0, centre.1 - high / 2.0, centre.0 + wide / 2.0, centre.1 + high / 2.0]
}

/// The price of a side that is not the wanted one.
fn turn(words: &Words, side: LabelSide, centre: Point) -> f64 {
    let cos = |to: Point| {
        let (x, y) = side.direction();
        let length = to.0.hypot(to.1);
        if length > 0.0 { (x * to.0 + y * to.1) / length } else { y }
    };
    let out = (words.at.0 - centre.0, words.at.1 - centre.1);
    match words.towards {
        Towards::Out | Towards::Over(_) => 1.0 - cos(out),
        Towards::To(direction) => 1.5 * (1.0 - cos(direction)),
        Towards::Across(direction) => 3.0 * cos(direction).powi(2) + 0.4 * (1.0 - cos(out)),
    }
}

fn centre<'a>(shapes: impl Iterator<Item = &'a DrawnShape>) -> Point {
    let (mut low, mut high) = ((f64::INFINITY, f64::INFINITY), (f64::NEG_INFINITY, f64::NEG_INFINITY));
    for (x, y) in shapes.flat_map(DrawnShape::corners).filter(|at| at.0.is_finite() && at.1.is_finite()) {
        low = (low.0.min(x), low.1.min(y));
        high = (high.0.max(x), high.1.max(y));
    }
    (f64::midpoint(low.0, high.0), f64::midpoint(low.1, high.1))
}

/// Points of the lines of a frame, near enough to each other that none passes under words unseen.
#[derive(Default)]
struct Marks {
    x: Vec<f64>,
    y: Vec<f64>,
}

impl Marks {
    fn of(shapes: &[DrawnShape], unit: f64) -> Self {
        let mut marks = Vec::new();
        for shape in shapes {
            mark(shape, unit, &mut marks);
        }
        let (x, y) = marks.into_iter().unzip();
        Self { x, y }
    }

    /// The marks that words of a width can cover at some side of their point.
    fn near(&self, words: &Words, wide: f64, unit: f64) -> Self {
        let (x, y) = words.at;
        let [left, bottom, right, top] = LabelSide::AROUND
            .into_iter()
            .map(|side| place(words.anchor(side), wide, side, DISTANCES[DISTANCES.len() - 1], unit))
            .fold([x, y, x, y], |[left, bottom, right, top], area| {
                [left.min(area[0]), bottom.min(area[1]), right.max(area[2]), top.max(area[3])]
            });
        let marks = self.x.iter().copied().zip(self.y.iter().copied());
        let (x, y) = marks.filter(|(x, y)| *x > left && *x < right && *y > bottom && *y < top).unzip();
        Self { x, y }
    }

    fn inside(&self, [left, bottom, right, top]: Area) -> usize {
        // A product of flags has no branch, so that it is computed by SIMD.
        let within = |at: f64, low: f64, high: f64| usize::from(at > low) * usize::from(at < high);
        self.x.iter().zip(&self.y).map(|(x, y)| within(*x, left, right) * within(*y, bottom, top)).sum()
    }

    /// The price of the lines that words cover at a side, at the best distance from their point.
    fn covered(&self, at: Point, wide: f64, side: LabelSide, unit: f64) -> f64 {
        let mut least = f64::INFINITY;
        for distance in DISTANCES {
            // Farther out the distance alone costs more.
            if least <= 0.8 * distance {
                break;
            }
            let covered = self.inside(place(at, wide, side, distance, unit));
            least = least.min(covered as f64 + 0.8 * distance);
        }
        least
    }
}

/// The marks of a shape.
fn mark(shape: &DrawnShape, unit: f64, marks: &mut Vec<Point>) {
    match shape {
        DrawnShape::Polyline(points, _) | DrawnShape::Body(points, _) => {
            points.windows(2).for_each(|pair| line(pair[0], pair[1], unit, marks));
            if let (DrawnShape::Body(..), [first, .., last]) = (shape, &points[..]) {
                line(*last, *first, unit, marks);
            }
        }
        DrawnShape::Circle(at, radius, _) | DrawnShape::Disc(at, radius, _) => {
            arc(*at, *radius, 0.0, TAU, unit, marks);
        }
        DrawnShape::Arc(at, radius, from, to, _) => arc(*at, *radius, *from, *to, unit, marks),
        DrawnShape::Block(a, b, _) => {
            let corners = [*a, (b.0, a.1), *b, (a.0, b.1), *a];
            corners.windows(2).for_each(|pair| line(pair[0], pair[1], unit, marks));
        }
        DrawnShape::Pin((x, y)) | DrawnShape::HungPin((x, y)) => {
            let way = if matches!(shape, DrawnShape::Pin(_)) { -unit } else { unit };
            for far in [0.0, 0.7, 1.4, 2.1, 2.8] {
                marks.extend([-0.4, 0.4].map(|side| (x + side * far * unit, y + far * way)));
            }
        }
        DrawnShape::Ground(a, b) => beside(*a, *b, &[0.0, -0.6, -1.2], unit, marks),
        DrawnShape::Spring(a, b, _) | DrawnShape::Damper(a, b) => {
            beside(*a, *b, &[-1.2, -0.6, 0.0, 0.6, 1.2], unit, marks);
        }
        DrawnShape::Arrow(tail, head, _) => {
            line(*tail, *head, unit, marks);
            // A head is worth more than a line.
            marks.extend([*head; 4]);
        }
        DrawnShape::Measure(a, b) => line(*a, *b, unit, marks),
        DrawnShape::Label(..) | DrawnShape::Extent(..) => {}
    }
}

/// Lines beside a line, so many sizes of a symbol to the left.
fn beside(from: Point, to: Point, shifts: &[f64], unit: f64, marks: &mut Vec<Point>) {
    let (x, y) = (to.0 - from.0, to.1 - from.1);
    let length = x.hypot(y);
    if length > 0.0 {
        for shift in shifts {
            let left = (-y / length * shift * unit, x / length * shift * unit);
            let by = |at: Point| (at.0 + left.0, at.1 + left.1);
            line(by(from), by(to), unit, marks);
        }
    }
}

fn line(from: Point, to: Point, unit: f64, marks: &mut Vec<Point>) {
    let (x, y) = (to.0 - from.0, to.1 - from.1);
    let steps = (x.hypot(y) / (0.6 * unit)).ceil();
    if steps.is_finite() {
        let steps = steps.clamp(1.0, 200.0);
        marks.extend((0..=steps as u32).map(|n| {
            let part = f64::from(n) / steps;
            (from.0 + part * x, from.1 + part * y)
        }));
    }
}

fn arc(at: Point, radius: f64, from: f64, to: f64, unit: f64, marks: &mut Vec<Point>) {
    let steps = (radius * (to - from).abs() / (0.6 * unit)).ceil();
    if steps.is_finite() {
        let steps = steps.clamp(4.0, 200.0);
        marks.extend((0..=steps as u32).map(|n| {
            let angle = from + (to - from) * f64::from(n) / steps;
            (at.0 + radius * angle.cos(), at.1 + radius * angle.sin())
        }));
    }
}
