use ratatui::{
    layout::Rect,
    style::{Color, Style},
};

use super::*;

fn environment(term: &str, lang: &str, colorterm: &str, no_color: &str) -> Environment {
    let some = |value: &str| (!value.is_empty()).then(|| value.to_owned());
    Environment {
        term: some(term),
        lang: some(lang),
        colorterm: some(colorterm),
        no_color: some(no_color),
        ..Environment::default()
    }
}

/// Eight terminals, three languages, four ways to speak of colour. Written out by what each part promises, not by
/// calling the parts of the detection.
#[test]
fn ninety_six_environments() {
    use Colors::{Indexed256, None, Sixteen, True};
    // Colours in a UTF-8 locale: nothing said, 256 said, true said; and whether UTF-8 is believed.
    let terminals = [
        ("xterm-256color", [Indexed256, Indexed256, True], true),
        ("screen-256color", [Indexed256, Indexed256, True], true),
        ("tmux-256color", [Indexed256, Indexed256, True], true),
        ("xterm", [Sixteen, Sixteen, True], true),
        ("linux", [Sixteen, Sixteen, Sixteen], false),
        ("vt100", [None, None, None], false),
        ("dumb", [None, None, None], false),
        ("", [None, None, None], false),
    ];
    let mut seen = 0;
    for (term, colors, believed) in terminals {
        for (lang, utf8) in [("en_US.UTF-8", true), ("C", false), ("pt_BR.ISO-8859-1", false)] {
            for (says, colorterm, no_color) in [
                (Some(0), "", ""),
                (Some(1), "yes", ""),
                (Some(2), "truecolor", ""),
                (Option::None, "truecolor", "1"),
            ] {
                let found = Capabilities::detect(&environment(term, lang, colorterm, no_color));
                let unicode = utf8 && believed;
                let expected =
                    says.map_or(
                        None,
                        |says: usize| if unicode { colors[says] } else { colors[says].min(Sixteen) },
                    );
                let place = format!("TERM={term} LANG={lang} COLORTERM={colorterm} NO_COLOR={no_color}");
                assert_eq!(found.colors, expected, "{place}");
                assert_eq!(found.glyphs == Glyphs::Unicode, unicode, "{place}");
                assert_eq!(found.marker == PlotMarker::Braille, unicode, "{place}");
                seen += 1;
            }
        }
    }
    assert_eq!(seen, 96);
}

#[test]
fn the_first_locale_variable_that_is_set_counts() {
    let glyphs = |lc_all: &str, lc_ctype: &str, lang: &str| {
        let some = |value: &str| (!value.is_empty()).then(|| value.to_owned());
        let environment = Environment {
            lc_all: some(lc_all),
            lc_ctype: some(lc_ctype),
            ..environment("xterm", lang, "", "")
        };
        Capabilities::detect(&environment).glyphs
    };
    assert_eq!(glyphs("C", "", "en_US.UTF-8"), Glyphs::Ascii);
    assert_eq!(glyphs("", "C.UTF-8", "C"), Glyphs::Unicode);
    assert_eq!(glyphs("", "", "ca_ES.utf8@valencia"), Glyphs::Unicode);
    assert_eq!(glyphs("", "", ""), Glyphs::Ascii);
}

/// Every character the screens, the printer of formulas and the two languages use.
const OURS: &str = "─│┌┐└┘├┤┬┴┼━┃╭╮╰╯═║╔╗╚╝·•×÷±−∓≈≃≠≡≤≥≪≫√∑Σ∏∫∂∇Δ∞°′″→←↑↓⇒↔⟂∥∠∈∪∩∅…–—‘’“”«»\
    αβγδεζηθικλμνξοπρστυφϕχψωΓΔΘΛΞΠΣΦΨΩµẋẍẏÿżẇ\
    ₀₁₂₃₄₅₆₇₈₉₊₋ₐₑᵢⱼₖₙₓᵣ⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻ᵀⁿª\
    áàâãéêíóôõúçÁÀÂÃÉÊÍÓÔÕÚÇüº▶▸◀▲▼●○■□◆◇█▓▒░▀▄▌▐▁▂▃▄▅▆▇✓✗⎡⎢⎣⎤⎥⎦⎛⎜⎝⎞⎟⎠★⚠";

#[test]
fn every_character_of_ours_has_a_stand_in_that_reads() {
    let poor: String =
        OURS.chars().filter(|c| matches!(ascii::stand_in(*c), '?') && !c.is_whitespace()).collect();
    assert_eq!(poor, "");
    for (glyph, ascii) in [('·', '*'), ('×', 'x'), ('²', '2'), ('₃', '3'), ('ω', 'w'), ('─', '-'), ('┌', '+')]
    {
        assert_eq!(ascii::stand_in(glyph), ascii, "{glyph}");
    }
}

#[test]
fn an_ascii_frame_holds_nothing_else() {
    let mut buffer = Buffer::empty(Rect::new(0, 0, 64, 1));
    // The planes with characters that text has; beyond them every character is the same to it.
    for start in (0..0x2_0000).step_by(64) {
        for (cell, code) in buffer.content.iter_mut().zip(start..) {
            cell.set_char(char::from_u32(code).unwrap_or(' '));
        }
        sweep(&mut buffer, &Capabilities { glyphs: Glyphs::Ascii, ..Capabilities::default() });
        for cell in &buffer.content {
            assert!(
                matches!(cell.symbol().as_bytes(), [0x20..=0x7E]),
                "{:?} after {start:#x}",
                cell.symbol()
            );
        }
    }
}

#[test]
fn a_braille_curve_keeps_its_height() {
    let drawn: String = "⠉⠊⡠⣀⠀⣿⢸".chars().map(ascii::stand_in).collect();
    assert_eq!(drawn, "''..  #:".replace("  ", " "));
}

#[test]
fn a_unicode_frame_keeps_its_characters_and_loses_what_drives_a_terminal() {
    let mut buffer = Buffer::empty(Rect::new(0, 0, 5, 1));
    buffer.set_string(0, 0, "ωθ̈", Style::new().fg(Color::Rgb(255, 0, 0)));
    buffer[(2, 0)].set_symbol("\x1b[31m");
    buffer[(3, 0)].set_symbol("\u{202E}");
    buffer[(4, 0)].set_symbol("\n");
    sweep(&mut buffer, &Capabilities::default());
    let shown: Vec<&str> = buffer.content.iter().map(ratatui::buffer::Cell::symbol).collect();
    assert_eq!(shown, ["ω", "θ̈", "\u{FFFD}", " ", " "]);
    assert_eq!(buffer[(0, 0)].fg, Color::LightRed);
}
