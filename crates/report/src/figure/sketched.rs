//! A drawing as a picture.

use dalembert_core::{Drawing, DrawnShape, Ink, LabelSide, Locale, Point};

use super::{
    labels::{Labels, width},
    picture::{LineStyle, Picture, PictureElement, Tone},
    strokes::{self, Box2, Stroke, strokes},
};

/// The most room for the machine itself.
const ROOM: (f64, f64) = (460.0, 340.0);
/// The margin around it, where words may stand.
const MARGIN: f64 = 24.0;

/// The drawing as large as it fits, with equal scales across and up.
pub(super) fn picture(drawing: &Drawing, locale: &Locale) -> Option<Picture> {
    let strokes = strokes(drawing);
    let labels: Vec<(Point, LabelSide, String)> =
        drawing.shapes.iter().filter_map(|shape| label(shape, locale)).collect();
    let corners = strokes.iter().flat_map(|stroke| &stroke.points).chain(labels.iter().map(|(at, ..)| at));
    let bounds = Box2::of(corners.copied())?;
    let scale = (ROOM.0 / bounds.width()).min(ROOM.1 / bounds.height());
    // Words stand beside the machine, so that they lengthen the margin at both sides.
    let words = labels.iter().map(|(.., text)| width(text)).fold(0.0, f64::max).min(140.0);
    let (left, top) = (MARGIN + words, MARGIN);
    let place = |at: &Point| (left + (at.0 - bounds.left) * scale, top + (bounds.top - at.1) * scale);
    let size = (bounds.width() * scale + 2.0 * left, bounds.height() * scale + 2.0 * top);
    let mut words = Labels::new((2.0, 2.0, size.0 - 2.0, size.1 - 2.0));
    let mut parts = Vec::new();
    for stroke in &strokes {
        let points: Vec<Point> = stroke.points.iter().map(place).collect();
        words.avoid(&points);
        parts.push(line(stroke, points));
    }
    for (at, side, text) in &labels {
        words.at_side(text, Tone::Ink, place(at), *side);
    }
    parts.append(&mut words.parts);
    let title = drawing.title.render(locale);
    Some(Picture { title, width: size.0, height: size.1, parts, letters: Vec::new() })
}

fn label(shape: &DrawnShape, locale: &Locale) -> Option<(Point, LabelSide, String)> {
    match shape {
        DrawnShape::Label(at, side, text) if at.0.is_finite() && at.1.is_finite() => {
            Some((*at, *side, text.render(locale)))
        }
        _ => None,
    }
}

fn line(stroke: &Stroke, points: Vec<Point>) -> PictureElement {
    let tone = match stroke.ink {
        Ink::Body => Tone::Ink,
        Ink::Faint => Tone::Faint,
        Ink::Force => Tone::Curve(1),
        Ink::Motion => Tone::Curve(0),
        Ink::Result => Tone::Good,
        Ink::Danger => Tone::Bad,
    };
    let width = match stroke.part {
        strokes::StrokeRole::Hatch => 0.8,
        _ if stroke.ink == Ink::Faint => 1.0,
        _ => 1.6,
    };
    PictureElement::Line { points, tone, width, dash: LineStyle::Solid }
}
