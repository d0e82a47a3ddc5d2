//! Figures of analyses: marks at answers, and words that cover nothing.

use dalembert_core::{Entry, Exhibit, Locale, Plot};
use dalembert_plot::{drawing, look::Appearance};
use dalembert_report::figure::{
    axes::Axes,
    figure,
    picture::{PictureElement, WORDS},
};
use dalembert_terminal::glyphs::Colors;
use ratatui::{buffer::Buffer, layout::Rect};

use crate::problems::{first_solutions, numbers};

/// Compares every mark of a plot with the answers and the curves: it is an answer, or the value of a curve where it
/// stands. Returns the number of marks.
pub fn every_mark_equals_an_answer_or_a_point_of_a_curve(entries: &[&'static Entry]) -> usize {
    let mut seen = 0;
    for (entry, solution) in first_solutions(entries) {
        let answers: Vec<f64> = solution.answers.iter().flat_map(|answer| numbers(&answer.value)).collect();
        let is_answer = |x: f64, scale: f64| {
            answers.iter().any(|answer| (x.abs() - answer.abs()).abs() <= 1e-9 * answer.abs().max(scale))
        };
        for exhibit in &solution.exhibits {
            let Exhibit::Plot(plot) = exhibit else { continue };
            let heights = plot.series.iter().flat_map(|series| &series.points).map(|at| at.1.abs());
            let height = heights.filter(|y| y.is_finite()).fold(0.0, f64::max);
            for mark in &plot.marks {
                let (x, y) = mark.at;
                // At a resonance without damping there is nothing to mark.
                if !y.is_finite() {
                    continue;
                }
                seen += 1;
                assert!(
                    is_answer(x, 0.0) || is_answer(y, height) || is_on_a_curve(plot, (x, y)),
                    "{}: the mark `{}` of `{}` at ({x}, {y}) is no answer and on no curve",
                    entry.about.id,
                    mark.label.english(),
                    plot.title.english()
                );
            }
        }
    }
    seen
}

/// True for a point on a curve, within what the line between two computed points can miss: as much as the curve changes
/// next to it.
fn is_on_a_curve(plot: &Plot, (x, y): (f64, f64)) -> bool {
    let Some(axes) = Axes::of(plot) else { return false };
    let Some(place) = axes.y.of(y) else { return false };
    plot.series.iter().any(|series| {
        let Some(read) = axes.read(series, x).and_then(|reading| axes.y.of(reading.y)) else { return false };
        let at = series.points.windows(2).position(|pair| (pair[0].0 - x) * (pair[1].0 - x) <= 0.0);
        let at = at.unwrap_or(0);
        let near = &series.points[at.saturating_sub(1)..(at + 3).min(series.points.len())];
        let heights: Vec<f64> = near.iter().filter_map(|at| axes.y.of(at.1)).collect();
        let most = heights.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let least = heights.iter().copied().fold(f64::INFINITY, f64::min);
        (read - place).abs() <= (most - least).clamp(1e-6, 0.05)
    })
}

/// Sizes of the areas that drawings are examined in, in cells; the smallest in ASCII too.
const SIZES: [((u16, u16), bool); 7] = [
    ((38, 14), false),
    ((38, 14), true),
    ((60, 20), false),
    ((60, 26), false),
    ((76, 18), false),
    ((100, 40), false),
    ((110, 44), false),
];

/// Draws every sketch in several sizes: words stand within two cells of their point, over no other words and over no head
/// of an arrow, and what has no place is listed below. Returns the numbers of words that have a place and that are
/// listed.
pub fn words_of_drawings_stand_over_no_other_words_and_over_no_head_of_an_arrow(
    entries: &[&'static Entry],
) -> (usize, usize) {
    let (mut placed, mut listed) = (0, 0);
    for (entry, solution) in first_solutions(entries) {
        for exhibit in &solution.exhibits {
            let Some(sketch) = exhibit.sketch(0) else { continue };
            for (size, ascii) in SIZES {
                let look = Appearance { ascii, colors: Colors::None, ..Appearance::default() };
                let area = Rect::new(0, 0, size.0, size.1);
                let mut buffer = Buffer::empty(area);
                let words = drawing::render(&sketch, &look, &Locale::english(), area, &mut buffer);
                let of = format!("{}: {} at {size:?}", entry.about.id, sketch.title.english());
                for (n, (at, text, point)) in words.beside.iter().enumerate() {
                    let read: String = (at.x..at.right()).map(|x| buffer[(x, at.y)].symbol()).collect();
                    assert_eq!(&read, text, "{of}");
                    assert!(!words.heads.iter().any(|cell| at.contains((*cell).into())), "{of}: {text}");
                    assert!(is_near(*at, text, *point), "{of}: {text} is far from its point");
                    for (other, ..) in &words.beside[n + 1..] {
                        assert!(!at.intersects(*other), "{of}: {text}");
                    }
                }
                placed += words.beside.len();
                listed += words.listed.len();
                // What is listed is read under the drawing, whole where there is room.
                let rows =
                    (0..size.1).map(|y| (0..size.0).map(|x| buffer[(x, y)].symbol()).collect::<String>());
                let below = rows.skip(usize::from(size.1) * 3 / 4 - 1).collect::<String>();
                let first = words.listed.first().filter(|first| first.chars().count() < 12);
                assert!(first.is_none_or(|first| below.contains(first.as_str())), "{of}: {:?}", words.listed);
            }
        }
    }
    (placed, listed)
}

/// True for words with at most two cells between them and a cell.
fn is_near(at: Rect, text: &str, (x, y): (u16, u16)) -> bool {
    let blanks = |ends: usize| ends as u16;
    let left = at.x + blanks(text.len() - text.trim_start().len());
    let right = at.right() - blanks(text.len() - text.trim_end().len());
    let across = left.saturating_sub(x).max((x + 1).saturating_sub(right));
    across <= 3 && y.abs_diff(at.y) <= 2
}

/// Draws the figures of every analysis for paper: words stand over no other words.
pub fn words_of_figures_stand_over_no_other_words(entries: &[&'static Entry]) {
    let mut faults = Vec::new();
    for (entry, solution) in first_solutions(entries) {
        for exhibit in solution.exhibits.iter().filter(|exhibit| exhibit.frames().0 > 0) {
            let Some(picture) = figure(exhibit, &Locale::english()) else { continue };
            let boxes: Vec<(f64, f64, f64, &str)> = picture
                .parts
                .iter()
                .filter_map(|part| match part {
                    PictureElement::Words { at, text, .. } => {
                        Some((at.0, at.0 + 0.5 * WORDS * text.chars().count() as f64, at.1, text.as_str()))
                    }
                    _ => None,
                })
                .collect();
            for (n, one) in boxes.iter().enumerate() {
                for other in &boxes[n + 1..] {
                    if one.0 < other.1 && other.0 < one.1 && (one.2 - other.2).abs() < 0.8 * WORDS {
                        faults
                            .push(format!("{} {}: {} and {}", entry.about.id, picture.title, one.3, other.3));
                    }
                }
            }
        }
    }
    assert!(faults.is_empty(), "{} words:\n{}", faults.len(), faults.join("\n"));
}
