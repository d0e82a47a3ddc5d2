//! Map: an answer over two inputs, a cell for each pair of their levels.

use dalembert_core::{Axis, Locale, Scale};

use super::{
    labels::width,
    letters,
    picture::{Anchor, Picture, PictureElement, Tone, WORDS},
    ruler::Ruler,
    ticks::Span,
};

const WIDTH: f64 = 640.0;
const INSIDE: f64 = 300.0;
const LINE: f64 = 1.5 * WORDS;
/// Width and room of the scale of colours.
const SCALE: f64 = 18.0;
const SCALE_ROOM: f64 = 120.0;
/// Steps of the scale of colours.
const STEPS: u8 = 24;
/// Letters of a cell.
const CELL: usize = 2;

/// Axis of a map: its name with the unit, and the level of each cell.
#[derive(Clone, Debug, PartialEq)]
pub struct MapAxis {
    /// Name of the input.
    pub name: String,
    /// Levels, ascending.
    pub levels: Vec<String>,
}

/// A map of values in SI, those of the second axis fastest, `None` in a cell without one; `None` where no cell has one.
pub fn map(
    title: String,
    [across, upwards]: [&MapAxis; 2],
    axis: &Axis,
    values: &[Option<f64>],
    locale: &Locale,
) -> Option<Picture> {
    let mut ruler = Ruler::of_axis(axis, false);
    ruler.span = Span::of(values.iter().flatten().map(|si| ruler.value(*si)), Scale::Linear)?;
    let (columns, rows) = (across.levels.len(), upwards.levels.len());
    let widest = |axis: &MapAxis| axis.levels.iter().map(|level| width(level)).fold(0.0, f64::max);
    let (left, top) = (widest(upwards) + 24.0, LINE + 8.0);
    let (right, bottom) = (WIDTH - SCALE_ROOM, top + INSIDE);
    let (wide, high) = ((right - left) / columns as f64, INSIDE / rows as f64);
    let mut parts = Vec::new();
    for (n, value) in values.iter().enumerate() {
        let Some(share) = value.and_then(|si| ruler.of(si)) else { continue };
        let (column, row) = ((n / rows) as f64, (n % rows) as f64);
        parts.push(PictureElement::Area {
            from: (left + column * wide, bottom - (row + 1.0) * high),
            to: (left + (column + 1.0) * wide, bottom - row * high),
            tone: tone(share),
            opacity: 1.0,
        });
    }
    let words =
        |at, anchor, text: &str| PictureElement::Words { at, anchor, text: text.to_owned(), tone: Tone::Ink };
    // As many levels are named as there is room for.
    let every = ((widest(across) + 12.0) / wide).ceil().max(1.0) as usize;
    for (n, level) in across.levels.iter().enumerate().step_by(every) {
        parts.push(words((left + (n as f64 + 0.5) * wide, bottom + LINE), Anchor::Middle, level));
    }
    let every = (LINE / high).ceil().max(1.0) as usize;
    for (n, level) in upwards.levels.iter().enumerate().step_by(every) {
        let y = bottom - (n as f64 + 0.5) * high + 0.35 * WORDS;
        parts.push(words((left - 6.0, y), Anchor::End, level));
    }
    parts.push(words((12.0, LINE - 4.0), Anchor::Start, &upwards.name));
    parts.push(words((f64::midpoint(left, right), bottom + 2.0 * LINE), Anchor::Middle, &across.name));
    let scale = right + 24.0;
    for n in 0..STEPS {
        let place = |n: u8| bottom - INSIDE * f64::from(n) / f64::from(STEPS);
        parts.push(PictureElement::Area {
            from: (scale, place(n + 1)),
            to: (scale + SCALE, place(n)),
            tone: tone(f64::from(n) / f64::from(STEPS - 1)),
            opacity: 1.0,
        });
    }
    let span = ruler.span;
    for (share, value) in [(0.0, span.from), (0.5, span.value(0.5)), (1.0, span.to)] {
        let y = bottom - share * INSIDE + 0.7 * share * WORDS;
        let text = ruler.write(ruler.si(value), locale.style);
        parts.push(words((scale + SCALE + 5.0, y), Anchor::Start, &text));
    }
    let letters = in_letters(&title, [across, upwards], &ruler, values, locale);
    Some(Picture { title, width: WIDTH, height: bottom + 2.0 * LINE + 10.0, parts, letters })
}

fn tone(share: f64) -> Tone {
    Tone::Scale((share.clamp(0.0, 1.0) * 255.0).round() as u8)
}

/// A digit for each cell: tenths of the range of the values.
fn in_letters(
    title: &str,
    [across, upwards]: [&MapAxis; 2],
    ruler: &Ruler<'_>,
    values: &[Option<f64>],
    locale: &Locale,
) -> Vec<String> {
    let (columns, rows) = (across.levels.len(), upwards.levels.len());
    let margin = upwards.levels.iter().map(|level| level.chars().count()).max().unwrap_or(0);
    let mut lines = vec![title.to_owned(), format!("  {}", upwards.name)];
    for (row, level) in upwards.levels.iter().enumerate().rev() {
        let digit = |column: usize| {
            let share = values[column * rows + row].and_then(|si| ruler.of(si));
            share.map_or_else(|| "  ".to_owned(), |share| format!(" {}", (share * 10.0).min(9.0) as u8))
        };
        let cells: String = (0..columns).map(digit).collect();
        lines.push(format!("  {level:>margin$} |{}", cells.trim_end()));
    }
    let end = |n: usize| across.levels.get(n).map_or("", String::as_str);
    lines.push(letters::foot(margin, CELL * columns, end(0), end(columns.saturating_sub(1))));
    lines.push(format!("  {}  {}", " ".repeat(margin), across.name));
    let write = |value: f64| ruler.write(ruler.si(value), locale.style);
    lines.push(format!(
        "  {}  0: {} … 9: {}",
        " ".repeat(margin),
        write(ruler.span.from),
        write(ruler.span.to)
    ));
    lines
}
