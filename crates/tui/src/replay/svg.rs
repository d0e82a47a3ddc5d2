//! A screen as SVG.
//!
//! Nothing depends on the reader's fonts but the shapes of letters: every run of text is as long as its cells, and
//! frames, blocks and braille are drawn, not written.

mod strokes;

use std::fmt::Write;

use ratatui::{
    buffer::{Buffer, Cell},
    style::{Color, Modifier},
};
use unicode_width::UnicodeWidthStr;

/// A cell, in pixels.
const CELL: (f64, f64) = (9.0, 19.0);
/// Around the screen.
const MARGIN: f64 = 12.0;
/// Baseline of letters, from the top of their line.
const BASELINE: f64 = 14.0;
/// Background and text.
const GROUND: &str = "#15181e";
const TEXT: &str = "#d6dae1";
/// Text that may be passed over: that of a dark theme, its light halved with the ground's.
const DIM: f64 = 0.58;

/// Paint of a cell. Two cells of one paint need one element.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Paint {
    text: String,
    ground: Option<String>,
    bold: bool,
    underlined: bool,
}

/// The picture of a screen.
pub(super) fn screen(buffer: &Buffer) -> String {
    let (columns, rows) = (buffer.area.width, buffer.area.height);
    let (width, height) =
        (f64::from(columns) * CELL.0 + 2.0 * MARGIN, f64::from(rows) * CELL.1 + 2.0 * MARGIN);
    let mut classes: Vec<Paint> = Vec::new();
    let mut body = String::new();
    for row in 0..rows {
        let cells: Vec<&Cell> = (0..columns).map(|column| &buffer[(column, row)]).collect();
        draw_row(&cells, row, &mut classes, &mut body);
    }
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" \
         height=\"{height}\">\n<style>\ntext{{font:15px ui-monospace,'DejaVu Sans Mono',Menlo,Consolas,monospace;\
         white-space:pre}}\npath{{fill:none}}\n"
    );
    for (at, paint) in classes.iter().enumerate() {
        let colour = &paint.text;
        let bold = if paint.bold { ";font-weight:bold" } else { "" };
        let line = if paint.underlined { ";text-decoration:underline" } else { "" };
        let _ = writeln!(svg, ".t{at}{{fill:{colour}{bold}{line}}}.s{at}{{stroke:{colour}}}");
    }
    let _ = write!(
        svg,
        "</style>\n<rect width=\"{width}\" height=\"{height}\" rx=\"8\" fill=\"{GROUND}\"/>\n\
         <g transform=\"translate({MARGIN} {MARGIN})\">\n{body}</g>\n</svg>\n"
    );
    svg
}

/// Runs of one paint: their ground, their letters, their strokes.
fn draw_row(cells: &[&Cell], row: u16, classes: &mut Vec<Paint>, body: &mut String) {
    let top = f64::from(row) * CELL.1;
    let mut from = 0;
    while from < cells.len() {
        let paint = Paint::of(cells[from]);
        let mut to = from + 1;
        while to < cells.len() && Paint::of(cells[to]) == paint {
            to += 1;
        }
        let run = &cells[from..to];
        let left = from as f64 * CELL.0;
        if let Some(ground) = &paint.ground {
            let _ = writeln!(
                body,
                "<rect x=\"{left}\" y=\"{top}\" width=\"{}\" height=\"{}\" fill=\"{ground}\"/>",
                run.len() as f64 * CELL.0,
                CELL.1
            );
        }
        let lettered = Paint { ground: None, ..paint };
        let class = match classes.iter().position(|known| *known == lettered) {
            Some(at) => at,
            None => {
                classes.push(lettered);
                classes.len() - 1
            }
        };
        draw_letters(run, class, (left, top), body);
        strokes::draw(run, class, (left, top), body);
        from = to;
    }
}

/// The letters of a run, in pieces between wider gaps and between what is drawn by strokes.
fn draw_letters(run: &[&Cell], class: usize, (left, top): (f64, f64), body: &mut String) {
    let blank = |cell: &Cell| cell.symbol().trim().is_empty() || strokes::has(cell.symbol());
    let mut at = 0;
    while at < run.len() {
        if blank(run[at]) {
            at += 1;
            continue;
        }
        let begin = at;
        let mut end = at + 1;
        while at < run.len() {
            if !blank(run[at]) {
                at += run[at].symbol().width().max(1);
                end = at.min(run.len());
            } else if run[at].symbol() == " " && run.get(at + 1).is_some_and(|next| !blank(next)) {
                at += 1;
            } else {
                break;
            }
        }
        let text: String = run[begin..end].iter().map(|cell| escaped(cell.symbol())).collect();
        let _ = writeln!(
            body,
            "<text class=\"t{class}\" x=\"{}\" y=\"{}\" textLength=\"{}\">{text}</text>",
            left + begin as f64 * CELL.0,
            top + BASELINE,
            (end - begin) as f64 * CELL.0
        );
    }
}

impl Paint {
    fn of(cell: &Cell) -> Self {
        let (mut text, mut ground) =
            (rgb(cell.fg), (cell.bg != Color::Reset).then(|| rgb(cell.bg)).flatten());
        if cell.modifier.contains(Modifier::REVERSED) {
            let back = ground.or_else(|| hex(GROUND));
            ground = text.or_else(|| hex(TEXT));
            text = back;
        }
        let mut text = text.or_else(|| hex(TEXT)).unwrap_or_default();
        if cell.modifier.contains(Modifier::DIM) {
            let behind = ground.or_else(|| hex(GROUND)).unwrap_or_default();
            text = std::array::from_fn(|at| {
                (f64::from(text[at]) * DIM + f64::from(behind[at]) * (1.0 - DIM)).round() as u8
            });
        }
        let written = |[red, green, blue]: [u8; 3]| format!("#{red:02x}{green:02x}{blue:02x}");
        Paint {
            text: written(text),
            ground: ground.map(written),
            bold: cell.modifier.contains(Modifier::BOLD),
            underlined: cell.modifier.contains(Modifier::UNDERLINED),
        }
    }
}

/// The sixteen of a dark theme; `None` is the theme's own text.
fn rgb(color: Color) -> Option<[u8; 3]> {
    hex(match color {
        Color::Black => "#22262e",
        Color::Red => "#e5707a",
        Color::Green => "#8fc379",
        Color::Yellow => "#e0bb70",
        Color::Blue => "#6ea8ee",
        Color::Magenta => "#c792e0",
        Color::Cyan => "#5fc2ce",
        Color::Gray => "#b6bdc9",
        Color::DarkGray => "#717a89",
        Color::LightRed => "#f08d95",
        Color::LightGreen => "#a9d896",
        Color::LightYellow => "#f0d190",
        Color::LightBlue => "#92c0f7",
        Color::LightMagenta => "#dab1ee",
        Color::LightCyan => "#85dae3",
        Color::White => "#f2f4f8",
        Color::Rgb(red, green, blue) => return Some([red, green, blue]),
        Color::Reset | Color::Indexed(_) => return None,
    })
}

fn hex(text: &str) -> Option<[u8; 3]> {
    let number = u32::from_str_radix(text.strip_prefix('#')?, 16).ok()?;
    let [_, red, green, blue] = number.to_be_bytes();
    Some([red, green, blue])
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

#[cfg(test)]
mod tests {
    use ratatui::{layout::Rect, style::Style};

    use super::*;

    fn drawn(width: u16, paint: impl Fn(&mut Buffer)) -> String {
        let mut buffer = Buffer::empty(Rect::new(0, 0, width, 1));
        paint(&mut buffer);
        screen(&buffer)
    }

    #[test]
    fn text_is_as_long_as_its_cells() {
        let svg = drawn(20, |buffer| {
            buffer.set_string(2, 0, "a < b  c", Style::new());
        });
        assert!(svg.contains("x=\"18\" y=\"14\" textLength=\"45\">a &lt; b</text>"), "{svg}");
        assert!(svg.contains("x=\"81\" y=\"14\" textLength=\"9\">c</text>"), "{svg}");
    }

    #[test]
    fn reversed_text_has_the_ground_of_text() {
        let svg = drawn(4, |buffer| {
            buffer.set_string(0, 0, "ab", Style::new().add_modifier(Modifier::REVERSED));
        });
        assert!(svg.contains(&format!("width=\"18\" height=\"19\" fill=\"{TEXT}\"")), "{svg}");
        assert!(svg.contains(&format!(".t0{{fill:{GROUND}}}")), "{svg}");
    }

    #[test]
    fn frames_and_braille_are_drawn() {
        let svg = drawn(4, |buffer| {
            buffer.set_string(0, 0, "╭─⠁", Style::new());
        });
        assert!(!svg.contains("<text"), "{svg}");
        assert!(svg.contains("<path"), "{svg}");
    }
}
