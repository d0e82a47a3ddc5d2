//! Colours: those of the terminal's own palette, or fixed ones whose contrast is known.

use dalembert_terminal::glyphs::Colors;
use ratatui::style::Color;

/// A choice of colours.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Theme {
    /// In the sixteen colours of the terminal's own palette, on its own ground.
    #[default]
    Terminal,
    /// Light on dark.
    Dark,
    /// Dark on light.
    Light,
    /// Bright on black, as far apart as can be.
    HighContrast,
    /// Near black on white, for a projector.
    Presenter,
    /// Without colours: bold, dim, underlined, reversed.
    None,
}

/// The colours of a theme that has its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Palette {
    /// The ground.
    pub ground: Color,
    /// Text.
    pub text: Color,
    /// Secondary text.
    pub faint: Color,
    /// Wrong.
    pub red: Color,
    /// Doubtful.
    pub yellow: Color,
    /// Right, and what was asked for.
    pub green: Color,
    /// Symbols, keys, what has the focus.
    pub cyan: Color,
    /// Forces.
    pub magenta: Color,
    /// Curves, one after the other: no two alike.
    pub curves: &'static [Color],
}

impl Theme {
    /// Every theme.
    pub const ALL: [Theme; 6] =
        [Theme::Terminal, Theme::Dark, Theme::Light, Theme::HighContrast, Theme::Presenter, Theme::None];

    /// Id in the settings.
    pub fn id(self) -> &'static str {
        match self {
            Theme::Terminal => "terminal",
            Theme::Dark => "dark",
            Theme::Light => "light",
            Theme::HighContrast => "high-contrast",
            Theme::Presenter => "presenter",
            Theme::None => "none",
        }
    }

    /// Name for display.
    pub fn name(self) -> &'static str {
        match self {
            Theme::Terminal => "the terminal's own colours",
            Theme::Dark => "dark",
            Theme::Light => "light",
            Theme::HighContrast => "high contrast",
            Theme::Presenter => "presenter, for a projector",
            Theme::None => "no colour",
        }
    }

    /// Palette in the available colours, where the theme defines one.
    pub fn palette(self, colors: Colors) -> Option<Palette> {
        match (self, colors) {
            (Theme::Terminal | Theme::None, _) | (_, Colors::None) => None,
            // The nearest of sixteen is often a grey: these are chosen.
            (Theme::Dark, Colors::Sixteen) => Some(DARK_OF_SIXTEEN),
            (Theme::Light | Theme::Presenter, Colors::Sixteen) => Some(LIGHT_OF_SIXTEEN),
            (Theme::HighContrast, Colors::Sixteen) => Some(HIGH_CONTRAST_OF_SIXTEEN),
            (Theme::Dark, _) => Some(DARK),
            (Theme::Light, _) => Some(LIGHT),
            (Theme::HighContrast, _) => Some(HIGH_CONTRAST),
            (Theme::Presenter, _) => Some(PRESENTER),
        }
    }
}

impl Palette {
    /// Colour that replaces one of the terminal's palette.
    pub fn of(&self, color: Color) -> Color {
        match color {
            Color::Red => self.red,
            Color::Yellow => self.yellow,
            Color::Green => self.green,
            Color::Cyan => self.cyan,
            Color::Magenta => self.magenta,
            other => other,
        }
    }
}

const fn rgb(red: u8, green: u8, blue: u8) -> Color {
    Color::Rgb(red, green, blue)
}

const DARK: Palette = Palette {
    ground: rgb(18, 18, 20),
    text: rgb(222, 222, 222),
    faint: rgb(158, 158, 158),
    red: rgb(255, 125, 125),
    yellow: rgb(240, 200, 80),
    green: rgb(110, 215, 110),
    cyan: rgb(95, 210, 220),
    magenta: rgb(230, 140, 230),
    curves: &[
        rgb(60, 220, 220),
        rgb(230, 140, 230),
        rgb(240, 200, 80),
        rgb(110, 215, 110),
        rgb(130, 150, 255),
        rgb(255, 110, 110),
    ],
};

const LIGHT: Palette = Palette {
    ground: rgb(255, 255, 255),
    text: rgb(20, 20, 20),
    faint: rgb(90, 90, 90),
    red: rgb(180, 0, 20),
    yellow: rgb(110, 75, 0),
    green: rgb(0, 95, 20),
    cyan: rgb(0, 80, 95),
    magenta: rgb(135, 0, 135),
    curves: &[
        rgb(0, 110, 130),
        rgb(135, 0, 135),
        rgb(110, 75, 0),
        rgb(0, 95, 20),
        rgb(40, 40, 220),
        rgb(180, 0, 20),
    ],
};

const HIGH_CONTRAST: Palette = Palette {
    ground: rgb(0, 0, 0),
    text: rgb(255, 255, 255),
    faint: rgb(215, 215, 215),
    red: rgb(255, 150, 150),
    yellow: rgb(255, 255, 0),
    green: rgb(95, 255, 95),
    cyan: rgb(0, 255, 255),
    magenta: rgb(255, 165, 255),
    curves: &[
        rgb(0, 255, 255),
        rgb(255, 165, 255),
        rgb(255, 255, 0),
        rgb(95, 255, 95),
        rgb(160, 200, 255),
        rgb(255, 150, 150),
    ],
};

/// A projector washes colours out: of each only as much is left as black needs not.
const PRESENTER: Palette = Palette {
    ground: rgb(255, 255, 255),
    text: rgb(0, 0, 0),
    faint: rgb(48, 48, 48),
    red: rgb(135, 0, 0),
    yellow: rgb(80, 45, 0),
    green: rgb(0, 70, 0),
    cyan: rgb(0, 50, 95),
    magenta: rgb(95, 0, 95),
    curves: &[
        rgb(0, 80, 95),
        rgb(130, 0, 130),
        rgb(90, 30, 0),
        rgb(0, 90, 0),
        rgb(20, 20, 190),
        rgb(170, 0, 0),
    ],
};

const DARK_OF_SIXTEEN: Palette = Palette {
    ground: Color::Black,
    text: Color::Gray,
    faint: Color::DarkGray,
    red: Color::LightRed,
    yellow: Color::LightYellow,
    green: Color::LightGreen,
    cyan: Color::LightCyan,
    magenta: Color::LightMagenta,
    curves: &[
        Color::LightCyan,
        Color::LightMagenta,
        Color::LightYellow,
        Color::LightGreen,
        Color::LightRed,
        Color::Gray,
    ],
};

/// Greens, yellows and cyans are too bright to be read on white.
const LIGHT_OF_SIXTEEN: Palette = Palette {
    ground: Color::White,
    text: Color::Black,
    faint: Color::Black,
    red: Color::Red,
    yellow: Color::Magenta,
    green: Color::Blue,
    cyan: Color::Blue,
    magenta: Color::Magenta,
    curves: &[Color::Blue, Color::Magenta, Color::Red, Color::Black],
};

/// Reds and blues are too dark to be read well on black.
const HIGH_CONTRAST_OF_SIXTEEN: Palette = Palette {
    ground: Color::Black,
    text: Color::White,
    faint: Color::Gray,
    red: Color::LightYellow,
    yellow: Color::LightYellow,
    green: Color::LightGreen,
    cyan: Color::LightCyan,
    magenta: Color::Yellow,
    curves: &[Color::LightCyan, Color::LightYellow, Color::LightGreen, Color::White],
};
