//! Tornado: a bar for each input, as long as an answer runs over it, the longest on top.

use dalembert_core::{Axis, Locale, Scale};

use super::{
    labels::width,
    letters,
    picture::{Anchor, LineStyle, Picture, PictureElement, Tone, WORDS},
    ruler::Ruler,
    ticks::Span,
};

const WIDTH: f64 = 640.0;
/// Width that the names of the inputs may take.
const MOST_NAMES: f64 = 280.0;
/// Height of a bar with the room above it.
const ROW: f64 = 24.0;
const BAR: f64 = 16.0;
const LINE: f64 = 1.5 * WORDS;
/// Letters across.
const ACROSS: usize = 50;
const MOST_NAME_LETTERS: usize = 30;

/// Range of an answer over an input.
#[derive(Clone, Debug, PartialEq)]
pub struct TornadoBar {
    /// Name of the input.
    pub name: String,
    /// The least and the largest value, in SI.
    pub ends: [f64; 2],
}

/// A tornado about a value, in SI, its bars from the top down; `None` where there is nothing to draw.
pub fn tornado(
    title: String,
    axis: &Axis,
    middle: f64,
    bars: &[TornadoBar],
    locale: &Locale,
) -> Option<Picture> {
    let mut ruler = Ruler::of_axis(axis, false);
    let ends = bars.iter().flat_map(|bar| bar.ends).chain([middle]).map(|end| ruler.value(end));
    ruler.span = Span::of(ends, Scale::Linear).filter(|_| !bars.is_empty())?.with_room();
    let names = bars.iter().map(|bar| width(&bar.name)).fold(0.0, f64::max);
    let (left, right) = (names.min(MOST_NAMES) + 24.0, WIDTH - 20.0);
    let (top, bottom) = (10.0, 18.0 + ROW * bars.len() as f64);
    let at = |place: f64| left + place * (right - left);
    let mut parts = Vec::new();
    let mut line = |x: f64, tone, width| {
        let points = vec![(x, top), (x, bottom)];
        parts.push(PictureElement::Line { points, tone, width, dash: LineStyle::Solid });
    };
    let ticks = ruler.span.ticks_that_fit(8, locale.style, |ticks| {
        let widest = ticks.ticks.iter().map(|tick| width(&tick.label)).fold(0.0, f64::max);
        (widest + 14.0) * ticks.ticks.len() as f64 <= right - left
    });
    for tick in &ticks.ticks {
        line(at(ruler.span.place(tick.at)?), Tone::Faint, 0.8);
    }
    line(at(ruler.of(middle)?), Tone::Ink, 1.2);
    let words = |at, anchor, text| PictureElement::Words { at, anchor, text, tone: Tone::Ink };
    for (n, bar) in bars.iter().enumerate() {
        let y = top + 8.0 + ROW * n as f64;
        let [from, to] = [at(ruler.of(bar.ends[0])?), at(ruler.of(bar.ends[1])?)];
        parts.push(PictureElement::Area {
            from: (from, y),
            to: (to, y + BAR),
            tone: Tone::Curve(0),
            opacity: 0.75,
        });
        let most = (MOST_NAMES / width("n")) as usize;
        parts.push(words((left - 10.0, y + 0.8 * BAR), Anchor::End, shortened(&bar.name, most)));
    }
    for tick in &ticks.ticks {
        let x = at(ruler.span.place(tick.at)?);
        parts.push(words((x, bottom + LINE), Anchor::Middle, tick.label.clone()));
    }
    let foot = (f64::midpoint(left, right), bottom + 2.0 * LINE);
    parts.push(words(foot, Anchor::Middle, ruler.title(ticks.ten, locale).whole()));
    let letters = in_letters(&title, &ruler, middle, bars, locale)?;
    Some(Picture { title, width: WIDTH, height: bottom + 2.0 * LINE + 10.0, parts, letters })
}

fn in_letters(
    title: &str,
    ruler: &Ruler<'_>,
    middle: f64,
    bars: &[TornadoBar],
    locale: &Locale,
) -> Option<Vec<String>> {
    let column = |si: f64| Some(((ruler.of(si)? * ACROSS as f64) as usize).min(ACROSS - 1));
    let names: Vec<String> = bars.iter().map(|bar| shortened(&bar.name, MOST_NAME_LETTERS)).collect();
    let margin = names.iter().map(|name| name.chars().count()).max().unwrap_or(0);
    let middle = column(middle)?;
    let mut lines = vec![title.to_owned()];
    for (name, bar) in names.iter().zip(bars) {
        let (from, to) = (column(bar.ends[0])?, column(bar.ends[1])?);
        let letter = |at: usize| match (at == middle, (from..=to).contains(&at)) {
            (true, _) => '|',
            (false, true) => '=',
            (false, false) => ' ',
        };
        let row: String = (0..ACROSS).map(letter).collect();
        lines.push(format!("  {name:<margin$}  {}", row.trim_end()));
    }
    let [from, to] = [ruler.span.from, ruler.span.to].map(|end| ruler.write(ruler.si(end), locale.style));
    lines.push(letters::foot(margin, ACROSS, &from, &to));
    Some(lines)
}

/// A name of at most so many letters.
fn shortened(name: &str, most: usize) -> String {
    if name.chars().count() <= most {
        return name.to_owned();
    }
    name.chars().take(most.saturating_sub(3)).collect::<String>().trim_end().to_owned() + "..."
}
