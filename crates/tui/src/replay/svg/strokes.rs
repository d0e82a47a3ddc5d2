//! Frames, blocks and braille, as paths.

use std::fmt::Write;

use ratatui::buffer::Cell;

use super::CELL;

/// The width of the lines of frames and of the dots of braille.
const LINE: f64 = 1.2;
const DOT: f64 = 2.6;
/// Positions of braille dots in a cell.
const DOTS_X: [f64; 2] = [2.5, 6.5];
const DOTS_Y: [f64; 4] = [3.0, 7.5, 12.0, 16.5];
/// The bits of a braille character, by column and row.
const BITS: [[u32; 4]; 2] = [[0x01, 0x02, 0x04, 0x40], [0x08, 0x10, 0x20, 0x80]];

/// The arms of a frame's character: up, right, down, left; and whether its corner is round.
fn arms(character: char) -> Option<([bool; 4], bool)> {
    let of = |up: u8, right: u8, down: u8, left: u8| [up > 0, right > 0, down > 0, left > 0];
    Some(match character {
        '─' | '━' => (of(0, 1, 0, 1), false),
        '│' | '┃' => (of(1, 0, 1, 0), false),
        '┌' => (of(0, 1, 1, 0), false),
        '┐' => (of(0, 0, 1, 1), false),
        '└' => (of(1, 1, 0, 0), false),
        '┘' => (of(1, 0, 0, 1), false),
        '╭' => (of(0, 1, 1, 0), true),
        '╮' => (of(0, 0, 1, 1), true),
        '╰' => (of(1, 1, 0, 0), true),
        '╯' => (of(1, 0, 0, 1), true),
        '├' => (of(1, 1, 1, 0), false),
        '┤' => (of(1, 0, 1, 1), false),
        '┬' => (of(0, 1, 1, 1), false),
        '┴' => (of(1, 1, 0, 1), false),
        '┼' => (of(1, 1, 1, 1), false),
        _ => return None,
    })
}

/// The part of a cell that a block fills: left, top, right, bottom, each from 0 to 1; and how densely.
fn block(character: char) -> Option<([f64; 4], f64)> {
    let eighth = |from: char| f64::from(u32::from(character) - u32::from(from)) / 8.0;
    Some(match character {
        '▀' => ([0.0, 0.0, 1.0, 0.5], 1.0),
        '▁'..='█' => ([0.0, 1.0 - eighth('▀'), 1.0, 1.0], 1.0),
        '▉'..='▏' => ([0.0, 0.0, 1.0 - eighth('█'), 1.0], 1.0),
        '▐' => ([0.5, 0.0, 1.0, 1.0], 1.0),
        '░' => ([0.0, 0.0, 1.0, 1.0], 0.25),
        '▒' => ([0.0, 0.0, 1.0, 1.0], 0.5),
        '▓' => ([0.0, 0.0, 1.0, 1.0], 0.75),
        _ => return None,
    })
}

/// Returns true if the symbol is drawn here.
pub(super) fn has(symbol: &str) -> bool {
    let mut characters = symbol.chars();
    matches!((characters.next(), characters.next()), (Some(c), None)
        if ('\u{2800}'..='\u{28ff}').contains(&c) || arms(c).is_some() || block(c).is_some())
}

/// Draws what is drawn of a run of cells of one paint.
pub(super) fn draw(run: &[&Cell], class: usize, (left, top): (f64, f64), body: &mut String) {
    let (mut lines, mut dots) = (String::new(), String::new());
    let mut at = 0;
    while at < run.len() {
        let x = left + at as f64 * CELL.0;
        let mut next = at + 1;
        if let Some(character) = run[at].symbol().chars().next().filter(|_| has(run[at].symbol())) {
            if let Some(([_, right, _, left], _)) = arms(character)
                && right
                && left
                && matches!(character, '─' | '━')
            {
                // One line for all that follow.
                while run.get(next).is_some_and(|cell| cell.symbol() == run[at].symbol()) {
                    next += 1;
                }
                let _ = write!(lines, "M{x} {}h{}", top + CELL.1 / 2.0, (next - at) as f64 * CELL.0);
            } else if let Some((arms, round)) = arms(character) {
                frame(arms, round, (x, top), &mut lines);
            } else if let Some(([from, above, to, below], density)) = block(character) {
                let _ = writeln!(
                    body,
                    "<rect class=\"t{class}\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"{}/>",
                    x + from * CELL.0,
                    top + above * CELL.1,
                    (to - from) * CELL.0,
                    (below - above) * CELL.1,
                    if density < 1.0 { format!(" opacity=\"{density}\"") } else { String::new() }
                );
            } else {
                braille(character, (x, top), &mut dots);
            }
        }
        at = next;
    }
    if !lines.is_empty() {
        let _ = writeln!(body, "<path class=\"s{class}\" stroke-width=\"{LINE}\" d=\"{lines}\"/>");
    }
    if !dots.is_empty() {
        let _ = writeln!(
            body,
            "<path class=\"s{class}\" stroke-width=\"{DOT}\" stroke-linecap=\"round\" d=\"{dots}\"/>"
        );
    }
}

fn frame([up, right, down, left]: [bool; 4], round: bool, (x, y): (f64, f64), lines: &mut String) {
    let (middle, centre) = (x + CELL.0 / 2.0, y + CELL.1 / 2.0);
    let across = if right { x + CELL.0 } else { x };
    let along = if down { y + CELL.1 } else { y };
    if round {
        let _ = write!(lines, "M{across} {centre}Q{middle} {centre} {middle} {along}");
        return;
    }
    if up || down {
        let (from, to) = (if up { y } else { centre }, if down { y + CELL.1 } else { centre });
        let _ = write!(lines, "M{middle} {from}V{to}");
    }
    if left || right {
        let (from, to) = (if left { x } else { middle }, if right { x + CELL.0 } else { middle });
        let _ = write!(lines, "M{from} {centre}H{to}");
    }
}

fn braille(character: char, (x, y): (f64, f64), dots: &mut String) {
    let pattern = u32::from(character) - 0x2800;
    for (column, bits) in BITS.iter().enumerate() {
        for (row, bit) in bits.iter().enumerate() {
            if pattern & bit != 0 {
                let _ = write!(dots, "M{} {}h0", x + DOTS_X[column], y + DOTS_Y[row]);
            }
        }
    }
}
