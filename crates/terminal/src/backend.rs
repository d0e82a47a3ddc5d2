//! Backend that writes frames: crossterm's own backend, but for the cells, which cost a slow line as little as they
//! can.
//!
//! Between two cells only what differs is sent: the column alone within a row, a colour without the other one, all
//! attributes of a cell in one sequence. The sixteen colours every terminal has are sent as it knows them (30–37 and
//! 90–97, ECMA-48 8.3.117 and its common extension), not as places in a palette of 256, which an older terminal would
//! take for blinking.

use std::{
    fmt::{self, Display, Formatter},
    io::{self, Write},
};

use crossterm::{
    cursor::{MoveTo, MoveToColumn},
    queue,
    style::Print,
};
use ratatui::{
    backend::{Backend, ClearType, CrosstermBackend, WindowSize},
    buffer::Cell,
    layout::{Position, Size},
    style::{Color, Modifier},
};

/// Attributes by the number that switches each on.
const ATTRIBUTES: [(Modifier, u8); 9] = [
    (Modifier::BOLD, 1),
    (Modifier::DIM, 2),
    (Modifier::ITALIC, 3),
    (Modifier::UNDERLINED, 4),
    (Modifier::SLOW_BLINK, 5),
    (Modifier::RAPID_BLINK, 6),
    (Modifier::REVERSED, 7),
    (Modifier::HIDDEN, 8),
    (Modifier::CROSSED_OUT, 9),
];

/// Writes frames to `out`.
pub(super) struct MinimalBackend<W: Write> {
    crossterm: CrosstermBackend<W>,
    out: W,
}

/// Style of a cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Ink {
    foreground: Color,
    background: Color,
    attributes: Modifier,
}

/// Change from one ink to another: a control sequence, or nothing.
struct Change {
    from: Ink,
    to: Ink,
}

impl<W: Write + Clone> MinimalBackend<W> {
    pub(super) fn new(out: W) -> Self {
        Self { crossterm: CrosstermBackend::new(out.clone()), out }
    }
}

impl Ink {
    /// The ink of a terminal after a reset; every frame begins and ends with it.
    const PLAIN: Self =
        Self { foreground: Color::Reset, background: Color::Reset, attributes: Modifier::empty() };

    fn of(cell: &Cell) -> Self {
        Self { foreground: cell.fg, background: cell.bg, attributes: cell.modifier }
    }
}

impl Display for Change {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        if self.from == self.to {
            return Ok(());
        }
        // Attributes can be added one by one; bold and dim share the number that ends them, so all are ended at once.
        let reset = self.to == Ink::PLAIN || !self.to.attributes.contains(self.from.attributes);
        let from = if reset { Ink::PLAIN } else { self.from };
        let mut numbers = Vec::new();
        if reset && self.to != Ink::PLAIN {
            numbers.push("0".to_owned());
        }
        let added = self.to.attributes - from.attributes;
        numbers.extend(
            ATTRIBUTES.iter().filter(|(one, _)| added.contains(*one)).map(|(_, number)| number.to_string()),
        );
        if self.to.foreground != from.foreground {
            numbers.push(color(self.to.foreground, 30));
        }
        if self.to.background != from.background {
            numbers.push(color(self.to.background, 40));
        }
        write!(f, "\x1b[{}m", numbers.join(";"))
    }
}

/// The parameters of a colour; `ground` is 30 for what is written, 40 for what is behind it.
fn color(color: Color, ground: u8) -> String {
    let sixteen = |n: u8| if n < 8 { ground + n } else { ground + 60 + n - 8 }.to_string();
    match color {
        Color::Reset => (ground + 9).to_string(),
        Color::Black => sixteen(0),
        Color::Red => sixteen(1),
        Color::Green => sixteen(2),
        Color::Yellow => sixteen(3),
        Color::Blue => sixteen(4),
        Color::Magenta => sixteen(5),
        Color::Cyan => sixteen(6),
        Color::Gray => sixteen(7),
        Color::DarkGray => sixteen(8),
        Color::LightRed => sixteen(9),
        Color::LightGreen => sixteen(10),
        Color::LightYellow => sixteen(11),
        Color::LightBlue => sixteen(12),
        Color::LightMagenta => sixteen(13),
        Color::LightCyan => sixteen(14),
        Color::White => sixteen(15),
        Color::Indexed(index) => format!("{};5;{index}", ground + 8),
        Color::Rgb(red, green, blue) => format!("{};2;{red};{green};{blue}", ground + 8),
    }
}

impl<W: Write> Backend for MinimalBackend<W> {
    type Error = io::Error;

    fn draw<'a, I>(&mut self, cells: I) -> io::Result<()>
    where
        I: Iterator<Item = (u16, u16, &'a Cell)>,
    {
        let mut ink = Ink::PLAIN;
        // Where the terminal's cursor is. What a wide cell did to it is not relied on.
        let mut cursor: Option<(u16, u16)> = None;
        for (x, y, cell) in cells {
            match cursor {
                Some(at) if at == (x, y) => {}
                Some((_, row)) if row == y => queue!(self.out, MoveToColumn(x))?,
                _ => queue!(self.out, MoveTo(x, y))?,
            }
            let to = Ink::of(cell);
            write!(self.out, "{}", Change { from: ink, to })?;
            queue!(self.out, Print(cell.symbol()))?;
            ink = to;
            cursor = Some((x + 1, y));
        }
        write!(self.out, "{}", Change { from: ink, to: Ink::PLAIN })
    }

    fn hide_cursor(&mut self) -> io::Result<()> {
        self.crossterm.hide_cursor()
    }

    fn show_cursor(&mut self) -> io::Result<()> {
        self.crossterm.show_cursor()
    }

    fn get_cursor_position(&mut self) -> io::Result<Position> {
        self.crossterm.get_cursor_position()
    }

    fn set_cursor_position<P: Into<Position>>(&mut self, position: P) -> io::Result<()> {
        self.crossterm.set_cursor_position(position)
    }

    fn clear(&mut self) -> io::Result<()> {
        self.crossterm.clear()
    }

    fn clear_region(&mut self, region: ClearType) -> io::Result<()> {
        self.crossterm.clear_region(region)
    }

    fn size(&self) -> io::Result<Size> {
        self.crossterm.size()
    }

    fn window_size(&mut self) -> io::Result<WindowSize> {
        self.crossterm.window_size()
    }

    fn flush(&mut self) -> io::Result<()> {
        Backend::flush(&mut self.crossterm)
    }
}

#[cfg(test)]
mod tests {
    use ratatui::{Terminal, style::Style};

    use super::*;
    use crate::session::FrameBytes;

    const COLORS: [Color; 9] = [
        Color::Reset,
        Color::Black,
        Color::Green,
        Color::Gray,
        Color::DarkGray,
        Color::LightGreen,
        Color::White,
        Color::Indexed(200),
        Color::Rgb(1, 20, 255),
    ];

    /// The name of a colour in vt100.
    fn seen(color: Color) -> vt100::Color {
        match color {
            Color::Reset => vt100::Color::Default,
            Color::Black => vt100::Color::Idx(0),
            Color::Green => vt100::Color::Idx(2),
            Color::Gray => vt100::Color::Idx(7),
            Color::DarkGray => vt100::Color::Idx(8),
            Color::LightGreen => vt100::Color::Idx(10),
            Color::White => vt100::Color::Idx(15),
            Color::Indexed(index) => vt100::Color::Idx(index),
            Color::Rgb(red, green, blue) => vt100::Color::Rgb(red, green, blue),
            other => panic!("{other} is not among those tried"),
        }
    }

    #[test]
    fn a_terminal_shows_the_cells_of_every_frame() {
        let attributes =
            [Modifier::BOLD, Modifier::DIM, Modifier::ITALIC, Modifier::UNDERLINED, Modifier::REVERSED];
        let (columns, rows) = (40, 12);
        let bytes = FrameBytes::default();
        let mut screen = vt100::Parser::new(rows, columns, 0);
        let viewport = ratatui::Viewport::Fixed(ratatui::layout::Rect::new(0, 0, columns, rows));
        let options = ratatui::TerminalOptions { viewport };
        let mut terminal = Terminal::with_options(MinimalBackend::new(bytes.clone()), options).unwrap();
        // A generator of no quality serves (Numerical Recipes, 2nd edition, section 7.1).
        let mut state = 1u32;
        let mut below = |n: u32| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 16) % n
        };
        for frame in 0..200 {
            let mut wanted = None;
            terminal
                .draw(|drawn| {
                    let buffer = drawn.buffer_mut();
                    for at in buffer.area.positions() {
                        // Runs of one style, as screens have them; most cells stay from frame to frame.
                        if below(4) > 0 {
                            let letter = b'a' + (u32::from(at.x + at.y) % 26) as u8;
                            buffer[at].set_char(char::from(letter));
                            continue;
                        }
                        let mut on: Modifier = attributes.into_iter().filter(|_| below(3) == 0).collect();
                        // vt100 knows bold or dim, not both.
                        if on.contains(Modifier::BOLD) {
                            on -= Modifier::DIM;
                        }
                        let style = Style::new()
                            .fg(COLORS[below(9) as usize])
                            .bg(COLORS[below(9) as usize])
                            .add_modifier(on);
                        buffer[at].set_char(char::from(b'A' + below(26) as u8)).set_style(style);
                    }
                    wanted = Some(buffer.clone());
                })
                .unwrap();
            screen.process(&std::mem::take(&mut *bytes.0.borrow_mut()));
            let wanted = wanted.unwrap();
            for at in wanted.area.positions() {
                let (cell, shown) = (&wanted[at], screen.screen().cell(at.y, at.x).unwrap());
                assert_eq!(shown.contents(), cell.symbol(), "{at} of frame {frame}");
                assert_eq!(shown.fgcolor(), seen(cell.fg), "{at} of frame {frame}");
                assert_eq!(shown.bgcolor(), seen(cell.bg), "{at} of frame {frame}");
                let on = [shown.bold(), shown.dim(), shown.italic(), shown.underline(), shown.inverse()];
                assert_eq!(on, attributes.map(|one| cell.modifier.contains(one)), "{at} of frame {frame}");
            }
        }
    }

    #[test]
    fn a_change_of_ink_is_one_short_sequence() {
        let plain = Ink::PLAIN;
        let bold = Ink { attributes: Modifier::BOLD, ..plain };
        let green = Ink { foreground: Color::Green, ..bold };
        let dim = Ink { attributes: Modifier::DIM, ..plain };
        for (from, to, sequence) in [
            (plain, plain, ""),
            (plain, bold, "\x1b[1m"),
            (bold, green, "\x1b[32m"),
            (green, bold, "\x1b[39m"),
            (green, dim, "\x1b[0;2m"),
            (green, plain, "\x1b[m"),
        ] {
            assert_eq!(Change { from, to }.to_string(), sequence);
        }
    }
}
