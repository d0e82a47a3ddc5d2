//! Texts made to fit.

use ratatui::{buffer::Buffer, layout::Rect, text::Line};
use unicode_width::{UnicodeWidthChar, UnicodeWidthStr};

use crate::look::{Appearance, Glyph};

/// Cells that a text takes.
pub(crate) fn width(text: &str) -> usize {
    text.width()
}

/// A text in at most `room` cells; what is cut off leaves a mark.
pub(crate) fn fit(text: &str, room: usize, look: &Appearance) -> String {
    if width(text) <= room {
        return text.to_owned();
    }
    if room == 0 {
        return String::new();
    }
    let mut kept = String::new();
    let mut cells = 0;
    for character in text.chars() {
        cells += character.width().unwrap_or(0);
        if cells > room - 1 {
            break;
        }
        kept.push(character);
    }
    while kept.ends_with([' ', ',']) {
        kept.pop();
    }
    kept + look.glyph(Glyph::Ellipsis)
}

/// A text in exactly `room` cells.
pub(crate) fn padded(text: &str, room: usize, look: &Appearance) -> String {
    let mut text = fit(text, room, look);
    let missing = room.saturating_sub(width(&text));
    text.extend(std::iter::repeat_n(' ', missing));
    text
}

/// A text in lines of at most `room` cells, broken between words; a longer word is broken where it must be.
pub(crate) fn wrapped(text: &str, room: usize) -> Vec<String> {
    let room = room.max(1);
    let mut lines = vec![String::new()];
    for word in text.split_whitespace() {
        let mut word = word.to_owned();
        loop {
            let line = lines.last_mut().expect("there is always a last line");
            let gap = usize::from(!line.is_empty());
            if width(line) + gap + width(&word) <= room {
                if gap == 1 {
                    line.push(' ');
                }
                line.push_str(&word);
                break;
            }
            if line.is_empty() {
                let at = broken_at(&word, room);
                let rest = word.split_off(at);
                line.push_str(&word);
                word = rest;
                if word.is_empty() {
                    break;
                }
            }
            lines.push(String::new());
        }
    }
    lines
}

/// At most so many of these lines; where some are left out, the last one shows a mark.
pub(crate) fn shortened(mut lines: Vec<String>, most: usize, room: usize, look: &Appearance) -> Vec<String> {
    if lines.len() > most {
        lines.truncate(most);
        if let Some(last) = lines.last_mut() {
            *last = fit(&format!("{last} {}", look.glyph(Glyph::Ellipsis)), room, look);
        }
    }
    lines
}

/// Break of a word: at least one character is kept.
fn broken_at(word: &str, room: usize) -> usize {
    let mut cells = 0;
    for (at, character) in word.char_indices() {
        cells += character.width().unwrap_or(0);
        if cells > room && at > 0 {
            return at;
        }
    }
    word.len()
}

/// Draws lines from the first that is shown.
pub(crate) fn draw_lines(lines: &[Line<'_>], first: usize, area: Rect, buffer: &mut Buffer) {
    for (y, line) in (area.y..area.bottom()).zip(lines.iter().skip(first)) {
        buffer.set_line(area.x, y, line, area.width);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_is_cut_without_a_mark() {
        let look = Appearance::default();
        assert_eq!(fit("amplitude", 9, &look), "amplitude");
        assert_eq!(fit("amplitude", 5, &look), "ampl…");
        assert_eq!(fit("to the end", 7, &look), "to the…");
        assert_eq!(fit("amplitude", 0, &look), "");
        assert_eq!(padded("X", 3, &look), "X  ");
        assert_eq!(fit("梁梁梁", 5, &look), "梁梁…");
        let lines = || vec!["one".to_owned(), "two".to_owned(), "three".to_owned()];
        assert_eq!(shortened(lines(), 2, 5, &look), ["one", "two …"]);
        assert_eq!(shortened(lines(), 3, 5, &look), lines());
    }

    #[test]
    fn words_stay_whole_where_they_can() {
        assert_eq!(
            wrapped("the largest steady-state amplitude", 12),
            ["the largest", "steady-state", "amplitude"]
        );
        assert_eq!(wrapped("abcdefghij", 4), ["abcd", "efgh", "ij"]);
        assert_eq!(wrapped("", 4), [""]);
        assert_eq!(wrapped("a 梁", 1), ["a", "梁"]);
    }
}
