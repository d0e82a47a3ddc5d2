//! Capabilities of a terminal, from the environment alone, and reduction of a finished frame to them.
//!
//! Neither ratatui nor crossterm looks: with `LANG=C` or `TERM=vt100` they send the same braille and the same colours.
//! So every screen is drawn for the best terminal, and [`sweep`] reduces the finished buffer; no widget asks.

mod ascii;
mod colors;
mod untrusted;

use std::borrow::Cow;

use ratatui::buffer::Buffer;

use crate::system;

pub use ascii::ascii_sweep;
#[cfg(feature = "pixels")]
pub(crate) use colors::{index_of, rgb};
pub use untrusted::filter_untrusted;

/// The variables of the environment that say what the terminal is; an empty one is `None`.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Environment {
    /// `TERM`, the kind of terminal.
    pub term: Option<String>,
    /// `COLORTERM`: `truecolor` or `24bit`.
    pub colorterm: Option<String>,
    /// `NO_COLOR`: anything but the empty text asks for no colour (no-color.org).
    pub no_color: Option<String>,
    /// `LC_ALL`, which overrules the next.
    pub lc_all: Option<String>,
    /// `LC_CTYPE`, which overrules the next.
    pub lc_ctype: Option<String>,
    /// `LANG`, such as `pt_BR.UTF-8`.
    pub lang: Option<String>,
}

impl Environment {
    /// That of this process.
    pub fn of_process() -> Self {
        let get = |name| {
            let value = std::env::var_os(name).map(|value| value.to_string_lossy().into_owned());
            value.filter(|value| !value.is_empty()).or_else(|| system::usual(name).map(str::to_owned))
        };
        Self {
            term: get("TERM"),
            colorterm: get("COLORTERM"),
            no_color: get("NO_COLOR"),
            lc_all: get("LC_ALL"),
            lc_ctype: get("LC_CTYPE"),
            lang: get("LANG"),
        }
    }
}

/// The characters that can be shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Glyphs {
    /// Anything.
    #[default]
    Unicode,
    /// U+0020 to U+007E.
    Ascii,
}

/// The colours that can be shown, fewest first.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Colors {
    /// None: emphasis is by bold, underline and reverse video.
    None,
    /// The sixteen of the terminal's own palette.
    #[default]
    Sixteen,
    /// The 256 of xterm.
    Indexed256,
    /// 8 bits each of red, green and blue.
    True,
}

/// Marker of curves.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum PlotMarker {
    /// Eight dots a cell: the finest.
    #[default]
    Braille,
    /// Two blocks a cell, for a font without braille.
    HalfBlock,
    /// One `•` a cell.
    Dot,
    /// One `*` a cell.
    Ascii,
    /// As many dots as a cell has pixels, in a picture of its own.
    Pixels {
        /// Pixels across a cell.
        across: u16,
        /// Pixels down a cell.
        down: u16,
    },
}

/// Characters and colours that a terminal can show.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Capabilities {
    /// Characters.
    pub glyphs: Glyphs,
    /// Colours.
    pub colors: Colors,
    /// The marker to draw curves with, unless the user chose another.
    pub marker: PlotMarker,
}

impl Capabilities {
    /// The most that the environment promises.
    ///
    /// Characters: Unicode if the first of `LC_ALL`, `LC_CTYPE` and `LANG` that is set names UTF-8, unless `TERM` is a
    /// terminal with a fixed set of characters (the Linux console, the DEC terminals). Colours: those of `COLORTERM`
    /// and of the name of `TERM`; a terminal reduced to ASCII is trusted with no more than sixteen.
    pub fn detect(environment: &Environment) -> Self {
        let term = environment.term.as_deref().unwrap_or("dumb");
        let glyphs =
            if utf8(environment) && !fixed_characters(term) { Glyphs::Unicode } else { Glyphs::Ascii };
        let most = match glyphs {
            Glyphs::Unicode => Colors::True,
            Glyphs::Ascii => Colors::Sixteen,
        };
        let marker = match glyphs {
            Glyphs::Unicode => PlotMarker::Braille,
            Glyphs::Ascii => PlotMarker::Ascii,
        };
        Self { glyphs, colors: colors_of(environment, term).min(most), marker }
    }
}

/// Reduces a finished frame to what the terminal can show. Whatever a widget let through, no cell holds a control,
/// bidirectional or zero-width character afterwards.
pub fn sweep(buffer: &mut Buffer, capabilities: &Capabilities) {
    for cell in &mut buffer.content {
        let safe = filter_untrusted(cell.symbol());
        if matches!(safe, Cow::Owned(_)) || safe == "\n" {
            // One character: what a cell holds must not spill into the next.
            let shown = safe.chars().next().filter(|&character| character != '\n').unwrap_or(' ');
            cell.set_char(shown);
        }
    }
    if capabilities.glyphs == Glyphs::Ascii {
        ascii_sweep(buffer);
    }
    if capabilities.colors != Colors::True {
        for cell in &mut buffer.content {
            cell.fg = colors::reduce(cell.fg, capabilities.colors);
            cell.bg = colors::reduce(cell.bg, capabilities.colors);
        }
    }
}

fn utf8(environment: &Environment) -> bool {
    let Environment { lc_all, lc_ctype, lang, .. } = environment;
    let locale = lc_all.as_ref().or(lc_ctype.as_ref()).or(lang.as_ref());
    locale.is_some_and(|locale| {
        // language_TERRITORY.codeset@modifier
        let codeset = locale.split('@').next().unwrap_or_default().to_ascii_uppercase();
        codeset.ends_with("UTF-8") || codeset.ends_with("UTF8")
    })
}

fn fixed_characters(term: &str) -> bool {
    ["linux", "dumb", "ansi", "cons25", "sun"].contains(&term) || dec(term)
}

/// vt52, vt100, vt220 …
fn dec(term: &str) -> bool {
    term.strip_prefix("vt").is_some_and(|model| model.starts_with(|first: char| first.is_ascii_digit()))
}

fn colors_of(environment: &Environment, term: &str) -> Colors {
    if environment.no_color.is_some() || term == "dumb" || dec(term) {
        Colors::None
    } else if matches!(environment.colorterm.as_deref(), Some("truecolor" | "24bit")) {
        Colors::True
    } else if term.contains("256color") {
        Colors::Indexed256
    } else {
        Colors::Sixteen
    }
}

#[cfg(test)]
mod tests;
