//! Words beside points of a picture: none over another, and over as little else as possible.

use dalembert_core::LabelSide;
use unicode_width::UnicodeWidthStr;

use super::picture::{Anchor, PictureElement, Tone, WORDS};

/// The width of words, about.
pub(super) fn width(text: &str) -> f64 {
    0.56 * WORDS * text.width() as f64
}

/// The words of a picture, and what they should not cover.
pub(super) struct Labels {
    area: (f64, f64, f64, f64),
    /// Points of lines, near enough to each other that none passes under words unseen.
    ink: Vec<(f64, f64)>,
    placed: Vec<(f64, f64, f64, f64)>,
    /// The words at their places.
    pub(super) parts: Vec<PictureElement>,
}

impl Labels {
    /// None yet, inside `(left, top, right, bottom)`.
    pub(super) fn new(area: (f64, f64, f64, f64)) -> Self {
        Self { area, ink: Vec::new(), placed: Vec::new(), parts: Vec::new() }
    }

    /// A line that words should not cover.
    pub(super) fn avoid(&mut self, line: &[(f64, f64)]) {
        const STEP: f64 = 5.0;
        self.ink.extend(line.first());
        for pair in line.windows(2) {
            let (across, down) = (pair[1].0 - pair[0].0, pair[1].1 - pair[0].1);
            let steps = (across.hypot(down) / STEP).ceil().clamp(1.0, 1000.0);
            let at = |n: u32| f64::from(n) / steps;
            self.ink
                .extend((1..=steps as u32).map(|n| (pair[0].0 + across * at(n), pair[0].1 + down * at(n))));
        }
    }

    /// Words beside a point: right or left of it, above or below.
    pub(super) fn beside(&mut self, text: &str, tone: Tone, (x, y): (f64, f64)) {
        let (far, half) = (7.0, width(text) / 2.0);
        let (right, left, middle) = (x + far, x - far - 2.0 * half, x - half);
        let level = y + 0.35 * WORDS;
        let rows = [0.0, -0.9, 0.9, -1.8, 1.8, -2.7, 2.7].map(|row| level + row * WORDS);
        let mut places: Vec<(f64, f64)> = rows.iter().flat_map(|row| [(right, *row), (left, *row)]).collect();
        places.extend(rows[1..].iter().map(|row| (middle, *row)));
        self.put(text, tone, &places);
    }

    /// Words at a side of a point, farther out where they would cover something, or at the nearest side where they do not.
    pub(super) fn at_side(&mut self, text: &str, tone: Tone, (x, y): (f64, f64), side: LabelSide) {
        let long = width(text);
        let level = y + 0.35 * WORDS;
        let mut sides = LabelSide::AROUND;
        sides.sort_by_key(|other| side.turn_to(*other));
        let mut places = Vec::new();
        if side == LabelSide::Over {
            places.push(((x - long / 2.0, level), 0));
        }
        for other in sides {
            let (right, up) = other.direction();
            let corner = if right.abs() > 0.1 && up.abs() > 0.1 { 0.5 } else { 1.0 };
            for step in 0..6u8 {
                let out = corner * 6.0 * f64::from(step);
                let left = match right {
                    right if right > 0.1 => x + 7.0 + out,
                    right if right < -0.1 => x - 7.0 - long - out,
                    _ => x - long / 2.0,
                };
                let rows = if up.abs() > 0.1 { up.signum() * (0.9 * WORDS + out) } else { 0.0 };
                places.push(((left, level - rows), 2 * side.turn_to(other) + usize::from(step)));
            }
        }
        self.cheapest(text, tone, &places);
    }

    /// Words at the first of `places` (of the beginning of their base line) where they cover least.
    pub(super) fn put(&mut self, text: &str, tone: Tone, places: &[(f64, f64)]) {
        let places: Vec<_> = places.iter().map(|at| (*at, 0)).collect();
        self.cheapest(text, tone, &places);
    }

    /// Words at the place where what they cover and the price of the place itself are least.
    fn cheapest(&mut self, text: &str, tone: Tone, places: &[((f64, f64), usize)]) {
        let long = width(text);
        let (left, top, right, bottom) = self.area;
        let best = places
            .iter()
            .map(|((x, base), price)| {
                // Moved back inside, where that is possible.
                let x = x.min(right - long).max(left);
                let base = base.min(bottom - 0.3 * WORDS).max(top + 0.85 * WORDS);
                ((x, base), price)
            })
            .map(|(at, price)| (self.cost(box_of(at, long)) + price, at))
            .reduce(|best, next| if next.0 < best.0 { next } else { best });
        if let Some((_, at)) = best.filter(|_| !text.is_empty()) {
            self.placed.push(box_of(at, long));
            self.parts.push(PictureElement::Words { at, anchor: Anchor::Start, text: text.to_owned(), tone });
        }
    }

    fn cost(&self, (left, top, right, bottom): (f64, f64, f64, f64)) -> usize {
        let inside = |at: &&(f64, f64)| at.0 > left && at.0 < right && at.1 > top && at.1 < bottom;
        let over = |other: &&(f64, f64, f64, f64)| {
            other.0 < right && other.2 > left && other.1 < bottom && other.3 > top
        };
        self.ink.iter().filter(inside).count() + 1000 * self.placed.iter().filter(over).count()
    }
}

/// Left, top, right and bottom of words of that length.
fn box_of((x, base): (f64, f64), long: f64) -> (f64, f64, f64, f64) {
    (x - 2.0, base - 0.8 * WORDS, x + long + 2.0, base + 0.25 * WORDS)
}
