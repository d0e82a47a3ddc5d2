//! Colours with fewer bits.

use ratatui::style::Color;

use super::Colors;

/// The nearest colour that `colors` has.
pub(super) fn reduce(color: Color, colors: Colors) -> Color {
    match (colors, color) {
        (Colors::None, _) => Color::Reset,
        (Colors::Indexed256, Color::Rgb(red, green, blue)) => Color::Indexed(indexed([red, green, blue])),
        (Colors::Sixteen, Color::Rgb(red, green, blue)) => nearest16([red, green, blue]),
        (Colors::Sixteen, Color::Indexed(index)) => nearest16(rgb(index)),
        (_, color) => color,
    }
}

/// The sixteen as xterm shows them by default; a user's palette differs, but keeps the hues.
const SIXTEEN: [(Color, [u8; 3]); 16] = [
    (Color::Black, [0, 0, 0]),
    (Color::Red, [205, 0, 0]),
    (Color::Green, [0, 205, 0]),
    (Color::Yellow, [205, 205, 0]),
    (Color::Blue, [0, 0, 238]),
    (Color::Magenta, [205, 0, 205]),
    (Color::Cyan, [0, 205, 205]),
    (Color::Gray, [229, 229, 229]),
    (Color::DarkGray, [127, 127, 127]),
    (Color::LightRed, [255, 0, 0]),
    (Color::LightGreen, [0, 255, 0]),
    (Color::LightYellow, [255, 255, 0]),
    (Color::LightBlue, [92, 92, 255]),
    (Color::LightMagenta, [255, 0, 255]),
    (Color::LightCyan, [0, 255, 255]),
    (Color::White, [255, 255, 255]),
];

/// The levels of the 6 × 6 × 6 cube, at index 16 + 36 r + 6 g + b.
const LEVELS: [u8; 6] = [0, 95, 135, 175, 215, 255];

fn nearest16(color: [u8; 3]) -> Color {
    SIXTEEN
        .iter()
        .min_by_key(|(_, candidate)| distance(color, *candidate))
        .map_or(Color::Reset, |(name, _)| *name)
}

/// The nearest of the cube and of the 24 greys behind it.
fn indexed(color: [u8; 3]) -> u8 {
    let level = |value: u8| (0..6_u8).min_by_key(|&i| LEVELS[usize::from(i)].abs_diff(value)).unwrap_or(0);
    let [red, green, blue] = color.map(level);
    let cube = 16 + 36 * red + 6 * green + blue;
    let mean = color.iter().map(|&value| u16::from(value)).sum::<u16>() / 3;
    let grey = 232 + (mean.saturating_sub(3) / 10).min(23) as u8;
    if distance(color, rgb(grey)) < distance(color, rgb(cube)) { grey } else { cube }
}

/// RGB value of a colour index of xterm.
pub(crate) fn rgb(index: u8) -> [u8; 3] {
    match index {
        0..16 => SIXTEEN[usize::from(index)].1,
        16..232 => {
            let cube = index - 16;
            [cube / 36, cube / 6 % 6, cube % 6].map(|level| LEVELS[usize::from(level)])
        }
        232.. => [8 + 10 * (index - 232); 3],
    }
}

/// Index of a colour that has one.
#[cfg(feature = "pixels")]
pub(crate) fn index_of(color: Color) -> Option<u8> {
    match color {
        Color::Indexed(index) => Some(index),
        named => SIXTEEN.iter().position(|(name, _)| *name == named).map(|at| at as u8),
    }
}

fn distance(a: [u8; 3], b: [u8; 3]) -> u32 {
    a.iter().zip(b).map(|(&a, b)| u32::from(a.abs_diff(b)).pow(2)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_index_is_its_own_nearest() {
        for index in 16..=255 {
            let found = indexed(rgb(index));
            assert_eq!(rgb(found), rgb(index), "{index}");
        }
        for (name, color) in SIXTEEN {
            assert_eq!(nearest16(color), name);
        }
    }

    #[test]
    fn colours_are_only_ever_reduced() {
        let orange = Color::Rgb(255, 135, 0);
        assert_eq!(reduce(orange, Colors::True), orange);
        assert_eq!(reduce(orange, Colors::Indexed256), Color::Indexed(208));
        assert_eq!(reduce(Color::Rgb(250, 10, 5), Colors::Sixteen), Color::LightRed);
        assert_eq!(reduce(Color::Indexed(21), Colors::Sixteen), Color::Blue);
        assert_eq!(reduce(Color::Red, Colors::Indexed256), Color::Red);
        assert_eq!(reduce(Color::Red, Colors::None), Color::Reset);
        assert_eq!(reduce(Color::Reset, Colors::Sixteen), Color::Reset);
    }
}
