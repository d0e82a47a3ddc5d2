use dalembert_terminal::glyphs::sweep;
use itertools::Itertools as _;
use ratatui::layout::Rect;

use super::*;

#[test]
fn what_is_left_out_is_seen_to_be() {
    let look = Appearance::default();
    assert_eq!(look.shortened("amplitude", 9), "amplitude");
    assert_eq!(look.shortened("amplitude", 5), "ampl…");
    assert_eq!(look.shortened("at this speed", 4), "at…");
    assert_eq!(look.shortened("梁の振動", 4), "梁…");
    assert_eq!(look.shortened("x", 0), "");
    assert_eq!(Appearance { ascii: true, ..look }.shortened("amplitude", 5), "ampl~");
}

#[test]
fn without_colours_nothing_is_coloured_and_still_tells_apart() {
    let look = Appearance { colors: Colors::None, ..Appearance::default() };
    for style in [look.error(), look.warning(), look.answer(), look.focus(), look.key(), look.border(true)] {
        assert_eq!((style.fg, style.bg), (None, None));
        assert_ne!(style, Style::new());
    }
    assert_ne!(look.border(true), look.border(false));
}

/// Red, green and blue, those of a terminal's palette as xterm shows them.
fn channels(color: Color) -> [u8; 3] {
    match color {
        Color::Rgb(red, green, blue) => [red, green, blue],
        Color::Indexed(index @ 16..232) => {
            let level = |n: u8| [0, 95, 135, 175, 215, 255][usize::from(n % 6)];
            [level((index - 16) / 36), level((index - 16) / 6), level(index - 16)]
        }
        Color::Indexed(index @ 232..) => [8 + 10 * (index - 232); 3],
        Color::Black => [0, 0, 0],
        Color::Red => [205, 0, 0],
        Color::Green => [0, 205, 0],
        Color::Yellow => [205, 205, 0],
        Color::Blue => [0, 0, 238],
        Color::Magenta => [205, 0, 205],
        Color::Cyan => [0, 205, 205],
        Color::Gray => [229, 229, 229],
        Color::DarkGray => [127, 127, 127],
        Color::LightRed => [255, 0, 0],
        Color::LightGreen => [0, 255, 0],
        Color::LightYellow => [255, 255, 0],
        Color::LightBlue => [92, 92, 255],
        Color::LightMagenta => [255, 0, 255],
        Color::LightCyan => [0, 255, 255],
        Color::White => [255, 255, 255],
        other => panic!("{other} is no fixed colour"),
    }
}

/// The relative luminance of WCAG 2.2.
fn luminance(color: Color) -> f64 {
    let [red, green, blue] = channels(color).map(|channel| {
        let share = f64::from(channel) / 255.0;
        if share <= 0.04045 { share / 12.92 } else { ((share + 0.055) / 1.055).powf(2.4) }
    });
    0.2126 * red + 0.7152 * green + 0.0722 * blue
}

/// The contrast of WCAG 2.2, from 1 to 21.
fn contrast(a: Color, b: Color) -> f64 {
    let (a, b) = (luminance(a), luminance(b));
    (a.max(b) + 0.05) / (a.min(b) + 0.05)
}

#[test]
fn contrast_is_that_of_the_guidelines() {
    assert!((contrast(Color::Rgb(0, 0, 0), Color::Rgb(255, 255, 255)) - 21.0).abs() < 1e-9);
    // The example that passes by a hair: #767676 on white.
    assert!((contrast(Color::Rgb(0x76, 0x76, 0x76), Color::Rgb(255, 255, 255)) - 4.54).abs() < 0.005);
}

#[test]
fn every_text_of_a_theme_stands_out_from_its_ground() {
    let themes =
        [(Theme::Dark, 4.5), (Theme::Light, 4.5), (Theme::HighContrast, 7.0), (Theme::Presenter, 7.0)];
    for (theme, least) in themes {
        for colors in [Colors::True, Colors::Indexed256, Colors::Sixteen] {
            // Sixteen colours are those of the light theme.
            let least = if (theme, colors) == (Theme::Presenter, Colors::Sixteen) { 4.5 } else { least };
            let look = Appearance { colors, theme, ..Appearance::default() };
            let inks = [Ink::Body, Ink::Faint, Ink::Force, Ink::Motion, Ink::Result, Ink::Danger];
            let mut styles = vec![
                look.title(),
                look.dim(),
                look.focus(),
                look.error(),
                look.warning(),
                look.answer(),
                look.symbol(),
                look.good(),
                look.key(),
                look.border(true),
                look.border(false),
            ];
            styles.extend((0..8).map(|n| look.series(n)));
            styles.extend(inks.map(|ink| look.ink(ink)));
            let mut buffer = Buffer::empty(Rect::new(0, 0, styles.len() as u16, 1));
            for (x, style) in (0..).zip(&styles) {
                buffer.set_string(x, 0, "x", *style);
            }
            look.ground(&mut buffer);
            sweep(&mut buffer, &Capabilities { colors, ..Capabilities::default() });
            for (cell, style) in buffer.content.iter().zip_eq(styles) {
                assert!(!cell.modifier.contains(Modifier::DIM));
                let found = contrast(cell.fg, cell.bg);
                assert!(found >= least, "{theme:?} in {colors:?}: {found:.2} of {cell:?} for {style:?}");
            }
        }
    }
}

#[test]
fn a_terminal_without_colours_stays_without_them_in_every_theme() {
    for theme in Theme::ALL {
        let look = Appearance { colors: Colors::None, theme, ..Appearance::default() };
        let mut buffer = Buffer::empty(Rect::new(0, 0, 2, 1));
        buffer.set_string(0, 0, "x", look.error());
        let before = buffer.clone();
        look.ground(&mut buffer);
        assert_eq!((&before, look.error().fg), (&buffer, None));
    }
}

/// The colour that is shown for a style, as a terminal of xterm's colours on black shows it.
fn shown(look: &Appearance, style: Style) -> (Color, Color) {
    let mut buffer = Buffer::empty(Rect::new(0, 0, 1, 1));
    buffer.set_string(0, 0, "x", style);
    look.ground(&mut buffer);
    sweep(&mut buffer, &Capabilities { colors: look.colors, ..Capabilities::default() });
    let or = |color, otherwise| if color == Color::Reset { otherwise } else { color };
    (or(buffer[(0, 0)].fg, Color::Gray), or(buffer[(0, 0)].bg, Color::Black))
}

#[test]
fn curves_of_one_plot_are_no_shades_of_one_another() {
    for theme in [Theme::Terminal, Theme::Dark, Theme::Light, Theme::HighContrast, Theme::Presenter] {
        for colors in [Colors::True, Colors::Indexed256, Colors::Sixteen] {
            let look = Appearance { colors, theme, ..Appearance::default() };
            assert!(look.curves() >= 4, "{theme:?} in {colors:?}");
            let curves: Vec<(Color, Color)> =
                (0..look.curves()).map(|n| shown(&look, look.series(n))).collect();
            for (n, (color, ground)) in curves.iter().enumerate() {
                let found = contrast(*color, *ground);
                assert!(found >= 4.5, "{theme:?} in {colors:?}: {found:.2} of {color:?}");
                for (other, _) in &curves[..n] {
                    let apart: f64 = channels(*color)
                        .iter()
                        .zip_eq(channels(*other))
                        .map(|(a, b)| (f64::from(*a) - f64::from(b)).powi(2))
                        .sum();
                    assert!(apart.sqrt() >= 80.0, "{theme:?} in {colors:?}: {color:?} and {other:?}");
                }
            }
        }
    }
}
