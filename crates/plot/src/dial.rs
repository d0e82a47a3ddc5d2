//! A dial in the cells of a terminal: a rim with names outside of it, hands, spots, and arrows around its centre.
//!
//! Directions are on the screen, in radians counter-clockwise from the right.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use dalembert_core::Ink;
use ratatui::{buffer::Buffer, layout::Rect, style::Style};
use unicode_width::UnicodeWidthStr;

use crate::{
    look::Appearance,
    plot::{
        Marker,
        dots::{Dots, Pen},
    },
    wrap,
};

/// The fewest rows of a dial that can be read.
pub const LEAST_ROWS: u16 = 7;
/// Chords of the rim.
const CHORDS: u32 = 120;
/// Length of a tick over the radius.
const TICK: f64 = 0.08;
/// Length of the head of an arrow over the radius, and half of its opening.
const HEAD: (f64, f64) = (0.2, 0.45);
/// Names whose direction has a larger cosine stand beside the rim, not above or below it.
const SIDEWAYS: f64 = 0.3;
/// The least radius, in rows, of a dial with words at its arrows.
const ROOMY: f64 = 4.0;
/// Names closer than this stand side by side.
const TOGETHER: f64 = 0.3;

/// A dial.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Dial {
    /// Title above it.
    pub title: String,
    /// Directions of the ticks of the rim.
    pub ticks: Vec<f64>,
    /// Names outside of the rim.
    pub names: Vec<DialName>,
    /// Hands from the centre to the rim.
    pub hands: Vec<(f64, Ink)>,
    /// Spots on the rim, over what else is there.
    pub spots: Vec<Spot>,
    /// Arrows around the centre.
    pub arrows: Vec<ArcArrow>,
}

/// Words outside of the rim.
#[derive(Clone, Debug, PartialEq)]
pub struct DialName {
    /// Direction.
    pub direction: f64,
    /// Words.
    pub words: String,
    /// Ink.
    pub ink: Ink,
}

/// A spot on the rim: a sign and its sign in ASCII.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spot {
    /// Direction.
    pub direction: f64,
    /// Distance from the centre over the radius.
    pub distance: f64,
    /// Sign.
    pub sign: (char, char),
    /// Ink.
    pub ink: Ink,
}

/// An arrow around the centre.
#[derive(Clone, Debug, PartialEq)]
pub struct ArcArrow {
    /// Radius over that of the rim.
    pub radius: f64,
    /// Direction of its beginning.
    pub from: f64,
    /// Angle that it goes through, counter-clockwise.
    pub sweep: f64,
    /// Words at its middle, towards the centre.
    pub words: String,
    /// Ink.
    pub ink: Ink,
}

/// The place of a dial in cells.
struct Place {
    centre: (f64, f64),
    /// Radius in rows; a row is as high as two columns are wide.
    radius: f64,
    per_cell: (f64, f64),
    area: Rect,
}

/// Draws a dial as large as it fits; nothing where it could not be read.
pub fn render(dial: &Dial, look: &Appearance, area: Rect, buffer: &mut Buffer) {
    let mut area = area.intersection(buffer.area);
    if !dial.title.is_empty() && area.height > LEAST_ROWS {
        for line in wrap::title(&dial.title, area.width.into(), 2, look) {
            buffer.set_string(area.x, area.y, line, look.title());
            area = Rect { y: area.y + 1, height: area.height - 1, ..area };
        }
    }
    let names = together(&dial.names);
    let Some(place) = Place::of(&names, look, area) else { return };
    let marker = if look.ascii { Marker::Ascii } else { Marker::Braille };
    let mut dots = Dots::new(area, marker);
    let rim: Vec<f64> = (0..=CHORDS).map(|n| TAU * f64::from(n) / f64::from(CHORDS)).collect();
    place.path(&mut dots, rim.iter().map(|direction| (*direction, 1.0)), Pen::solid(Style::new(), '.'));
    for tick in &dial.ticks {
        place.path(&mut dots, [(*tick, 1.0), (*tick, 1.0 - TICK)].into_iter(), Pen::solid(Style::new(), '+'));
    }
    for arrow in &dial.arrows {
        place.arrow(&mut dots, arrow, look);
    }
    for (direction, ink) in &dial.hands {
        place.hand(&mut dots, *direction, look.ink(*ink));
    }
    dots.draw(buffer);
    for arrow in dial.arrows.iter().filter(|arrow| !arrow.words.is_empty() && place.radius >= ROOMY) {
        let middle = arrow.from + arrow.sweep / 2.0;
        let at = place.cell(middle, arrow.radius * 0.5);
        place.words(buffer, at, 0.5, &arrow.words, look.ink(arrow.ink));
    }
    for name in &names {
        let across = 0.5 - name.direction.cos() * 0.75;
        let at = place.outside(name.direction);
        place.words(buffer, at, across.clamp(0.0, 1.0), &name.words, look.ink(name.ink));
    }
    for spot in &dial.spots {
        let (x, y) = place.cell(spot.direction, spot.distance);
        let (x, y) = (x.round() as u16, y.round() as u16);
        if x >= area.x && x < area.right() && y >= area.y && y < area.bottom() {
            let sign = if look.ascii { spot.sign.1 } else { spot.sign.0 };
            buffer[(x, y)].reset();
            buffer[(x, y)].set_char(sign).set_style(look.ink(spot.ink));
        }
    }
}

/// Names with those in nearly the same direction joined, in the ink of the last. At the sides, where width is dear, what
/// is faint gives way.
fn together(names: &[DialName]) -> Vec<DialName> {
    let mut joined: Vec<DialName> = Vec::new();
    for name in names.iter().filter(|name| !name.words.is_empty()) {
        let apart = |other: &DialName| {
            let apart = (other.direction - name.direction).rem_euclid(TAU);
            apart.min(TAU - apart)
        };
        match joined.iter_mut().find(|other| apart(other) < TOGETHER) {
            Some(other) => {
                let gives_way = other.ink == Ink::Faint && other.direction.cos().abs() > SIDEWAYS;
                other.words =
                    if gives_way { name.words.clone() } else { format!("{} {}", other.words, name.words) };
                other.ink = name.ink;
            }
            None => joined.push(name.clone()),
        }
    }
    joined
}

impl Place {
    fn of(names: &[DialName], look: &Appearance, area: Rect) -> Option<Self> {
        let widest = {
            let beside = |name: &&DialName| name.direction.cos().abs() > SIDEWAYS;
            names.iter().filter(beside).map(|name| name.words.width()).max().unwrap_or(0)
        };
        let beside = widest as f64 + 1.0;
        let rows = (f64::from(area.height) - 2.0) / 2.0;
        let columns = (f64::from(area.width) - 2.0 * beside) / 4.0;
        let radius = rows.min(columns) - 0.5;
        if area.height < LEAST_ROWS || radius < 2.0 {
            return None;
        }
        let centre = (
            f64::from(area.x) + (f64::from(area.width) - 1.0) / 2.0,
            f64::from(area.y) + (f64::from(area.height) - 1.0) / 2.0,
        );
        let per_cell = if look.ascii { (1.0, 1.0) } else { (2.0, 4.0) };
        Some(Self { centre, radius, per_cell, area })
    }

    /// The middle of the cell at a direction and a distance.
    fn cell(&self, direction: f64, distance: f64) -> (f64, f64) {
        let reach = self.radius * distance;
        (self.centre.0 + 2.0 * reach * direction.cos(), self.centre.1 - reach * direction.sin())
    }

    /// Place of words outside of the rim.
    fn outside(&self, direction: f64) -> (f64, f64) {
        let (x, y) = self.cell(direction, 1.0);
        (x + 1.6 * direction.cos(), y - 1.0 * direction.sin())
    }

    fn dot(&self, direction: f64, distance: f64) -> (f64, f64) {
        let (x, y) = self.cell(direction, distance);
        let dot = |at: f64, from: u16, per: f64| (at - f64::from(from) + 0.5) * per - 0.5;
        (dot(x, self.area.x, self.per_cell.0), dot(y, self.area.y, self.per_cell.1))
    }

    fn path(&self, dots: &mut Dots, points: impl Iterator<Item = (f64, f64)>, pen: Pen) {
        let points: Vec<(f64, f64)> =
            points.map(|(direction, distance)| self.dot(direction, distance)).collect();
        dots.lift();
        for pair in points.windows(2) {
            dots.line(pair[0], pair[1], pen);
        }
    }

    fn hand(&self, dots: &mut Dots, direction: f64, style: Style) {
        let pen = Pen::solid(style, '#');
        self.path(dots, [(direction, 0.0), (direction, 0.96)].into_iter(), pen);
        self.head(dots, (direction, 0.96), direction + PI, pen);
    }

    fn arrow(&self, dots: &mut Dots, arrow: &ArcArrow, look: &Appearance) {
        let pen = Pen::solid(look.ink(arrow.ink), '~');
        let steps = 24;
        let at = |n: i32| (arrow.from + arrow.sweep * f64::from(n) / f64::from(steps), arrow.radius);
        self.path(dots, (0..=steps).map(at), pen);
        let end = arrow.from + arrow.sweep;
        self.head(dots, (end, arrow.radius), end - arrow.sweep.signum() * FRAC_PI_2, pen);
    }

    /// The head of an arrow: two strokes from its tip, back along its line.
    fn head(&self, dots: &mut Dots, (direction, distance): (f64, f64), back: f64, pen: Pen) {
        let tip = self.cell(direction, distance);
        let length = self.radius * HEAD.0;
        for side in [back - HEAD.1, back + HEAD.1] {
            let end = (tip.0 + 2.0 * length * side.cos(), tip.1 - length * side.sin());
            let dot = |(x, y): (f64, f64)| {
                let dot = |at: f64, from: u16, per: f64| (at - f64::from(from) + 0.5) * per - 0.5;
                (dot(x, self.area.x, self.per_cell.0), dot(y, self.area.y, self.per_cell.1))
            };
            dots.lift();
            dots.line(dot(tip), dot(end), pen);
        }
    }

    /// Writes words at a place, of which `across` of their length lies to the left of it; inside the area.
    fn words(&self, buffer: &mut Buffer, (x, y): (f64, f64), across: f64, words: &str, style: Style) {
        let cells = words.width() as f64;
        let last = f64::from(self.area.right()) - cells;
        let x = (x + 0.5 - cells * across).clamp(f64::from(self.area.x), last.max(f64::from(self.area.x)));
        let y = y.clamp(f64::from(self.area.y), f64::from(self.area.bottom()) - 1.0);
        buffer.set_stringn(x.round() as u16, y.round() as u16, words, self.area.width.into(), style);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(dial: &Dial, look: &Appearance, width: u16, height: u16) -> Vec<String> {
        let area = Rect::new(0, 0, width, height);
        let mut buffer = Buffer::empty(area);
        render(dial, look, area, &mut buffer);
        let row = |y| (0..width).map(|x| buffer[(x, y)].symbol()).collect::<String>();
        (0..height).map(|y| row(y).trim_end().to_owned()).collect()
    }

    fn clock() -> Dial {
        let name = |hour: u32| DialName {
            direction: FRAC_PI_2 - f64::from(hour) * PI / 6.0,
            words: hour.to_string(),
            ink: Ink::Body,
        };
        Dial { names: [12, 3, 6, 9].map(name).to_vec(), ..Dial::default() }
    }

    #[test]
    fn names_stand_where_a_clock_has_them() {
        let rows = shown(&clock(), &Appearance::default(), 40, 15);
        let find = |words: &str| {
            let row = rows.iter().position(|row| row.contains(words)).expect("it is there");
            (rows[row].find(words).map(|at| rows[row][..at].chars().count()).expect("it is there"), row)
        };
        let (top, right, bottom, left) = (find("12"), find("3"), find("6"), find("9"));
        assert_eq!((top.1, right.1, bottom.1, left.1), (0, 7, 14, 7), "{rows:#?}");
        assert!(left.0 < 8 && right.0 > 31 && (18..=20).contains(&top.0) && top.0.abs_diff(bottom.0) <= 1);
    }

    #[test]
    fn a_spot_lies_on_the_rim_in_its_direction() {
        let spot = Spot { direction: 0.0, distance: 1.0, sign: ('●', '@'), ink: Ink::Result };
        let look = Appearance { ascii: true, ..Appearance::default() };
        let rows = shown(&Dial { spots: vec![spot], ..clock() }, &look, 40, 15);
        let middle = &rows[7];
        assert!(middle.find('@').is_some_and(|at| at > middle.len() / 2), "{rows:#?}");
        assert!(rows.iter().filter(|row| row.contains('@')).count() == 1);
        assert!(rows.iter().all(|row| row.is_ascii()), "{rows:#?}");
    }

    #[test]
    fn names_in_one_direction_stand_side_by_side() {
        let mut dial = clock();
        dial.names.push(DialName { direction: FRAC_PI_2, words: "mark".into(), ink: Ink::Motion });
        assert!(shown(&dial, &Appearance::default(), 40, 15)[0].contains("12 mark"));
    }

    #[test]
    fn what_could_not_be_read_is_not_drawn() {
        assert!(shown(&clock(), &Appearance::default(), 40, 5).iter().all(String::is_empty));
        assert!(shown(&clock(), &Appearance::default(), 9, 20).iter().all(String::is_empty));
    }
}
