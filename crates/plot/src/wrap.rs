//! Words in lines of a given width.

use unicode_width::{UnicodeWidthChar, UnicodeWidthStr};

use crate::look::Appearance;

/// Words in lines of at most `width` cells. A word that is longer is broken; a no-break space holds words together.
pub fn words(text: &str, width: usize) -> Vec<String> {
    let width = width.max(1);
    let mut lines = Vec::new();
    for paragraph in text.lines() {
        let mut line = String::new();
        for word in paragraph.split([' ', '\t']).filter(|word| !word.is_empty()) {
            let gap = usize::from(!line.is_empty());
            if line.width() + gap + word.width() <= width {
                line += &" ".repeat(gap);
                line += word;
                continue;
            }
            if !line.is_empty() {
                lines.push(std::mem::take(&mut line));
            }
            let mut pieces = broken(word, width);
            line = pieces.pop().unwrap_or_default();
            lines.extend(pieces);
        }
        lines.push(line);
    }
    lines.into_iter().map(|line| line.replace('\u{A0}', " ")).collect()
}

/// Words in at most `most` lines of at most `width` cells; what is left over is cut, and an ellipsis reports it.
pub fn title(text: &str, width: usize, most: usize, look: &Appearance) -> Vec<String> {
    let mut lines = words(text, width);
    if lines.len() > most {
        let rest = lines.split_off(most.saturating_sub(1)).join(" ");
        lines.push(look.shortened(&rest, width));
    }
    lines
}

/// The height of a picture from which on its title may take so many rows.
const TITLE_ROWS: [(u16, usize); 3] = [(16, 3), (11, 2), (0, 1)];

/// Rows that a title may take of a picture of this height.
pub fn title_rows(height: u16) -> usize {
    TITLE_ROWS.iter().find(|(least, _)| height >= *least).map_or(1, |(_, rows)| *rows)
}

/// The height of a picture that has so many rows for the title, and so many below it.
pub(crate) fn height_with_title(rows: usize, below: u16) -> u16 {
    let least = TITLE_ROWS.iter().find(|(_, most)| *most <= rows).map_or(0, |(least, _)| *least);
    below.saturating_add(rows as u16).max(least)
}

/// A word in pieces of at most `width` cells.
pub fn broken(word: &str, width: usize) -> Vec<String> {
    let mut pieces: Vec<String> = vec![String::new()];
    let mut cells = 0;
    for c in word.chars() {
        let wide = c.width().unwrap_or(0);
        if cells + wide > width && cells > 0 {
            pieces.push(String::new());
            cells = 0;
        }
        cells += wide;
        if let Some(piece) = pieces.last_mut() {
            piece.push(c);
        }
    }
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_wrapped_and_none_is_lost() {
        let text = "the largest amplitude is not above m₀e/m, so no damping gives a peak";
        for width in 1..80 {
            let lines = words(text, width);
            assert!(lines.iter().all(|line| line.width() <= width), "{width}");
            let whole: String = lines.concat().split_whitespace().collect();
            assert_eq!(whole, text.split_whitespace().collect::<String>(), "{width}");
        }
        assert_eq!(words("one two three", 7), ["one two", "three"]);
        assert_eq!(words("unbreakable", 4), ["unbr", "eaka", "ble"]);
        let look = Appearance::default();
        assert_eq!(title("one two three", 7, 2, &look), ["one two", "three"]);
        assert_eq!(title("one two three", 7, 1, &look), ["one tw…"]);
        assert_eq!(title("one two three four", 7, 2, &look), ["one two", "three…"]);
    }
}
