//! What things look like: styles by meaning, in the sixteen colours of the person's own palette, and the few
//! pictograms of the screens.

use dalembert_core::Ink;
use ratatui::style::{Color, Modifier, Style};

use unicode_width::{UnicodeWidthChar, UnicodeWidthStr};

use crate::glyphs::{Capabilities, Colors, Glyphs};

/// How a screen looks on this terminal.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Look {
    /// Whether nothing outside ASCII may be drawn.
    pub ascii: bool,
    /// The colours there are; without any, emphasis is bold, dim, underlined or reversed.
    pub colors: Colors,
}

/// A pictogram of one cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Glyph {
    /// Points at the line that has the focus: `▸`.
    Pointer,
    /// A group that is folded: `▸`.
    Closed,
    /// A group that is open: `▾`.
    Open,
    /// Something not saved, something that is on: `●`.
    Full,
    /// Something that is off: `○`.
    Hollow,
    /// Right: `✓`.
    Good,
    /// Wrong: `✗`.
    Bad,
    /// Doubtful: `!`.
    Warning,
    /// An entry of a list: `•`.
    Bullet,
    /// Something was left out here: `…`.
    Ellipsis,
    /// More above: `▲`.
    Up,
    /// More below: `▼`.
    Down,
    /// More to the left: `◀`.
    Left,
    /// More to the right: `▶`.
    Right,
    /// Between two things of a line: `·`.
    Dot,
    /// A line down the side: `│`.
    Bar,
    /// A line across: `─`.
    Rule,
    /// A film that is held: `‖`.
    Held,
}

impl Look {
    /// The look of a terminal that can show this much.
    pub fn new(capabilities: &Capabilities) -> Self {
        Self { ascii: capabilities.glyphs == Glyphs::Ascii, colors: capabilities.colors }
    }

    /// Headings and titles.
    pub fn title(&self) -> Style {
        Style::new().add_modifier(Modifier::BOLD)
    }

    /// What may be passed over: units, sources, notes, results of earlier inputs.
    pub fn dim(&self) -> Style {
        Style::new().add_modifier(Modifier::DIM)
    }

    /// What the keys act on.
    pub fn focus(&self) -> Style {
        Style::new().add_modifier(Modifier::REVERSED)
    }

    /// What is wrong.
    pub fn error(&self) -> Style {
        self.colored(Color::Red, Modifier::BOLD)
    }

    /// What is doubtful.
    pub fn warning(&self) -> Style {
        self.colored(Color::Yellow, Modifier::BOLD)
    }

    /// What was asked for.
    pub fn answer(&self) -> Style {
        self.colored(Color::Green, Modifier::BOLD).add_modifier(Modifier::BOLD)
    }

    /// Symbols of formulas.
    pub fn symbol(&self) -> Style {
        self.colored(Color::Cyan, Modifier::empty())
    }

    /// What was found right.
    pub fn good(&self) -> Style {
        self.colored(Color::Green, Modifier::empty())
    }

    /// The names of keys.
    pub fn key(&self) -> Style {
        self.colored(Color::Cyan, Modifier::BOLD)
    }

    /// The frame of a pane.
    pub fn border(&self, focused: bool) -> Style {
        if focused { self.colored(Color::Cyan, Modifier::BOLD) } else { self.dim() }
    }

    /// The curve of that place in a plot.
    pub fn series(&self, n: usize) -> Style {
        const COLORS: [Color; 6] =
            [Color::Cyan, Color::Magenta, Color::Yellow, Color::Green, Color::Blue, Color::Red];
        self.colored(COLORS[n % COLORS.len()], Modifier::empty())
    }

    /// The lines of a drawing.
    pub fn ink(&self, ink: Ink) -> Style {
        match ink {
            Ink::Body => Style::new(),
            Ink::Faint => self.dim(),
            Ink::Force => self.colored(Color::Magenta, Modifier::BOLD),
            Ink::Motion => self.colored(Color::Cyan, Modifier::empty()),
            Ink::Result => self.colored(Color::Green, Modifier::BOLD),
            Ink::Danger => self.colored(Color::Red, Modifier::BOLD),
        }
    }

    /// The pictogram, one cell wide.
    pub fn glyph(&self, glyph: Glyph) -> &'static str {
        let (unicode, ascii) = match glyph {
            Glyph::Pointer | Glyph::Closed => ("▸", ">"),
            Glyph::Open => ("▾", "v"),
            Glyph::Full => ("●", "*"),
            Glyph::Hollow => ("○", "o"),
            Glyph::Good => ("✓", "+"),
            Glyph::Bad => ("✗", "x"),
            Glyph::Warning => ("!", "!"),
            Glyph::Bullet => ("•", "*"),
            Glyph::Ellipsis => ("…", "~"),
            Glyph::Up => ("▲", "^"),
            Glyph::Down => ("▼", "v"),
            Glyph::Left => ("◀", "<"),
            Glyph::Right => ("▶", ">"),
            Glyph::Dot => ("·", "-"),
            Glyph::Bar => ("│", "|"),
            Glyph::Rule => ("─", "-"),
            Glyph::Held => ("‖", "="),
        };
        if self.ascii { ascii } else { unicode }
    }

    /// The text in no more than `width` cells; where something is left out, it ends with an ellipsis.
    pub fn shortened(&self, text: &str, width: usize) -> String {
        if text.width() <= width {
            return text.to_owned();
        }
        let mut room = width.saturating_sub(1);
        let kept = text.chars().take_while(|c| {
            let cells = c.width().unwrap_or(0);
            let fits = cells <= room;
            room = room.saturating_sub(cells);
            fits
        });
        let mut shown: String = kept.collect();
        if width > 0 {
            shown.truncate(shown.trim_end().len());
            shown += self.glyph(Glyph::Ellipsis);
        }
        shown
    }

    /// `color` where there are colours, `otherwise` where there are none.
    fn colored(&self, color: Color, otherwise: Modifier) -> Style {
        match self.colors {
            Colors::None => Style::new().add_modifier(otherwise),
            _ => Style::new().fg(color),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_left_out_is_seen_to_be() {
        let look = Look::default();
        assert_eq!(look.shortened("amplitude", 9), "amplitude");
        assert_eq!(look.shortened("amplitude", 5), "ampl…");
        assert_eq!(look.shortened("at this speed", 4), "at…");
        assert_eq!(look.shortened("梁の振動", 4), "梁…");
        assert_eq!(look.shortened("x", 0), "");
        assert_eq!(Look { ascii: true, ..look }.shortened("amplitude", 5), "ampl~");
    }

    #[test]
    fn without_colours_nothing_is_coloured_and_still_tells_apart() {
        let look = Look { colors: Colors::None, ..Look::default() };
        for style in
            [look.error(), look.warning(), look.answer(), look.focus(), look.key(), look.border(true)]
        {
            assert_eq!((style.fg, style.bg), (None, None));
            assert_ne!(style, Style::new());
        }
        assert_ne!(look.border(true), look.border(false));
    }
}
