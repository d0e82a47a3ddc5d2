//! Theme of a terminal: styles by meaning, in the colours of a theme, and the few pictograms of the screens.

mod theme;

use std::borrow::Cow;

use dalembert_core::Ink;
use dalembert_terminal::{
    glyphs::{Capabilities, Colors, Glyphs, PlotMarker},
    pixels,
};
use ratatui::{
    buffer::Buffer,
    style::{Color, Modifier, Style},
};

use unicode_width::{UnicodeWidthChar, UnicodeWidthStr};

pub use self::theme::{Palette, Theme};

/// Appearance of screens on this terminal.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Appearance {
    /// True if only ASCII may be drawn.
    pub ascii: bool,
    /// The colours there are; without any, emphasis is bold, dim, underlined or reversed.
    pub colors: Colors,
    /// Colour theme.
    pub theme: Theme,
    /// For serial lines and screen readers: no frames around panes, and the cursor where the focus is.
    pub basic: bool,
    /// Pixels across a cell and down a cell, where pictures are shown in pixels instead of braille.
    pub pixels: Option<(u16, u16)>,
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
    /// Not as it was printed, and we say why: `≠`.
    Unequal,
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
    /// An animation that is held: `‖`.
    Held,
}

impl Appearance {
    /// The look of a terminal that can show this much.
    pub fn new(capabilities: &Capabilities) -> Self {
        let ascii = capabilities.glyphs == Glyphs::Ascii;
        Self { ascii, colors: capabilities.colors, ..Self::default() }
    }

    /// The finest marker in place of a wanted one: pixels for braille, ASCII where there is nothing else.
    pub fn marker(&self, wanted: PlotMarker) -> PlotMarker {
        match (self.ascii, self.pixels, wanted) {
            (true, ..) => PlotMarker::Ascii,
            (false, Some((across, down)), PlotMarker::Braille) => PlotMarker::Pixels { across, down },
            _ => wanted,
        }
    }

    /// The colour of strokes, where that of text is the theme's.
    pub fn stroke(&self, ink: pixels::Ink) -> pixels::Ink {
        match self.palette() {
            Some(palette) if ink.color == Color::Reset => pixels::Ink { color: palette.text, ..ink },
            _ => ink,
        }
    }

    /// Headings and titles.
    pub fn title(&self) -> Style {
        Style::new().add_modifier(Modifier::BOLD)
    }

    /// Style of secondary text: units, sources, notes, results of earlier inputs.
    pub fn dim(&self) -> Style {
        match self.palette() {
            // How dim `DIM` is, only the terminal knows; a theme promises its contrast.
            Some(palette) => Style::new().fg(palette.faint),
            None => Style::new().add_modifier(Modifier::DIM),
        }
    }

    /// Style of the focused element.
    pub fn focus(&self) -> Style {
        Style::new().add_modifier(Modifier::REVERSED)
    }

    /// Style of errors.
    pub fn error(&self) -> Style {
        self.colored(Color::Red, Modifier::BOLD)
    }

    /// Style of warnings.
    pub fn warning(&self) -> Style {
        self.colored(Color::Yellow, Modifier::BOLD)
    }

    /// Style of answers.
    pub fn answer(&self) -> Style {
        self.colored(Color::Green, Modifier::BOLD).add_modifier(Modifier::BOLD)
    }

    /// Symbols of formulas.
    pub fn symbol(&self) -> Style {
        self.colored(Color::Cyan, Modifier::empty())
    }

    /// Style of correct results.
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

    /// The curve of that place in a plot. Colours come again where there are more curves than [`curves`](Self::curves).
    pub fn series(&self, n: usize) -> Style {
        let colors = self.curve_colors();
        colors.get(n % colors.len().max(1)).map_or_else(Style::new, |color| Style::new().fg(*color))
    }

    /// Number of curves with distinct colours: one on a monochrome terminal.
    pub fn curves(&self) -> usize {
        self.curve_colors().len().max(1)
    }

    fn curve_colors(&self) -> &'static [Color] {
        // Blue and red of many terminals are too dark for a line of dots on black: the bright ones are taken, and the
        // text's own colour.
        const OWN: &[Color] =
            &[Color::Cyan, Color::LightMagenta, Color::Yellow, Color::Green, Color::LightRed, Color::Reset];
        match (self.colors, self.theme) {
            (Colors::None, _) | (_, Theme::None) => &[],
            _ => self.palette().map_or(OWN, |palette| palette.curves),
        }
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
            Glyph::Unequal => ("≠", "#"),
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

    /// Words as this terminal shows them: Greek letters by their names where there is nothing but ASCII.
    pub fn words<'a>(&self, text: &'a str) -> Cow<'a, str> {
        if self.ascii { Cow::Owned(dalembert_core::ascii(text)) } else { Cow::Borrowed(text) }
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

    /// Lays the ground of the theme under a finished frame, and gives its text to what has no colour of its own.
    pub fn ground(&self, buffer: &mut Buffer) {
        let Some(palette) = self.palette() else { return };
        for cell in &mut buffer.content {
            if cell.fg == Color::Reset {
                cell.fg = palette.text;
            }
            if cell.bg == Color::Reset {
                cell.bg = palette.ground;
            }
        }
    }

    /// The colours of the theme, where it has its own and there are any.
    fn palette(&self) -> Option<Palette> {
        self.theme.palette(self.colors)
    }

    /// `color` where there are colours, `otherwise` where there are none.
    fn colored(&self, color: Color, otherwise: Modifier) -> Style {
        match (self.colors, self.theme) {
            (Colors::None, _) | (_, Theme::None) => Style::new().add_modifier(otherwise),
            _ => Style::new().fg(self.palette().map_or(color, |palette| palette.of(color))),
        }
    }
}

#[cfg(test)]
mod tests;
