//! Names of actions, places and keys as they are written in the settings.

use dalembert_core::{Text, nearest};
use ratatui::crossterm::event::{KeyCode, KeyModifiers};

use super::{Action, Key, Place};

impl Action {
    /// Its name in the settings. It never changes: people have it in their files.
    pub fn id(self) -> &'static str {
        match self {
            Action::Up => "up",
            Action::Down => "down",
            Action::Left => "left",
            Action::Right => "right",
            Action::PageUp => "page-up",
            Action::PageDown => "page-down",
            Action::First => "first",
            Action::Last => "last",
            Action::NextPane => "next-pane",
            Action::PreviousPane => "previous-pane",
            Action::Enter => "enter",
            Action::Back => "back",
            Action::Clear => "clear",
            Action::Toggle => "toggle",
            Action::NextTab => "next-tab",
            Action::PreviousTab => "previous-tab",
            Action::NextExhibit => "next-exhibit",
            Action::NextMarker => "next-marker",
            Action::ZoomIn => "zoom-in",
            Action::ZoomOut => "zoom-out",
            Action::ZoomAll => "zoom-all",
            Action::PanLeft => "pan-left",
            Action::PanRight => "pan-right",
            Action::NextSpread => "next-spread",
            Action::NextSpreadAcross => "next-spread-across",
            Action::UsualView => "usual-view",
            Action::ExportSeen => "export-seen",
            Action::Play => "play",
            Action::PreviousFrame => "previous-frame",
            Action::NextFrame => "next-frame",
            Action::TryByHand => "try-by-hand",
            Action::Reveal => "reveal",
            Action::Pin => "pin",
            Action::PinAnalysis => "pin-analysis",
            Action::Expand => "expand",
            Action::Nudge(..=-100) => "nudge-down-ten",
            Action::Nudge(-99..=-10) => "nudge-down",
            Action::Nudge(-9..=0) => "nudge-down-tenth",
            Action::Nudge(1..=9) => "nudge-up-tenth",
            Action::Nudge(10..=99) => "nudge-up",
            Action::Nudge(100..) => "nudge-up-ten",
            Action::NextUnit => "next-unit",
            Action::AddRow => "add-row",
            Action::DuplicateRow => "duplicate-row",
            Action::DeleteRow => "delete-row",
            Action::MoveRowUp => "move-row-up",
            Action::MoveRowDown => "move-row-down",
            Action::Undo => "undo",
            Action::Redo => "redo",
            Action::NextDisplayUnit => "unit-of-answer",
            Action::NextDigits => "digits-of-answer",
            Action::Copy => "copy",
            Action::Save => "save",
            Action::SaveAs => "save-as",
            Action::Export => "export",
            Action::Rename => "rename",
            Action::Open => "open",
            Action::Filter => "filter",
            Action::Language => "language",
            Action::Help => "help",
            Action::Palette => "palette",
            Action::Suspend => "suspend",
            Action::Redraw => "redraw",
            Action::Quit => "quit",
            Action::NextProblem => "next-problem",
            Action::CloseProblem => "close-problem",
            Action::Edit => "edit",
            Action::Theme => "theme",
            Action::Mouse => "mouse",
        }
    }
}

impl Place {
    /// Its name in the settings: `[keys.plot]`. No action has the same: both stand below `[keys]`.
    pub fn id(self) -> &'static str {
        match self {
            Place::Picker => "picker",
            Place::Filter => "filter-line",
            Place::Form => "inputs",
            Place::Edit => "field",
            Place::Pane => "results",
            Place::Working => "working",
            Place::Plot => "plot",
            Place::Drawing => "drawing",
            Place::List => "choices",
            Place::Prompt => "prompt",
            Place::Sheet => "sheet",
            Place::Help => "help-page",
            Place::Cells => "cells",
            Place::Cell => "cell",
        }
    }
}

/// Keys that are no characters, as they are written.
const NAMED: [(&str, KeyCode); 16] = [
    ("enter", KeyCode::Enter),
    ("esc", KeyCode::Esc),
    ("tab", KeyCode::Tab),
    ("backspace", KeyCode::Backspace),
    ("delete", KeyCode::Delete),
    ("insert", KeyCode::Insert),
    ("space", KeyCode::Char(' ')),
    ("up", KeyCode::Up),
    ("down", KeyCode::Down),
    ("left", KeyCode::Left),
    ("right", KeyCode::Right),
    ("home", KeyCode::Home),
    ("end", KeyCode::End),
    ("page-up", KeyCode::PageUp),
    ("page-down", KeyCode::PageDown),
    ("f1", KeyCode::F(1)),
];

/// Modifiers, as they are written before a key.
const MODIFIERS: [(&str, KeyModifiers); 3] =
    [("ctrl-", KeyModifiers::CONTROL), ("alt-", KeyModifiers::ALT), ("shift-", KeyModifiers::SHIFT)];

/// What a terminal sends for a letter with Ctrl: another key.
const SAME_BYTE: [(char, &str); 4] = [('i', "tab"), ('m', "enter"), ('h', "backspace"), ('[', "esc")];

impl Key {
    /// The key of a name such as `g`, `ctrl-s`, `f5`, `shift-up`.
    pub fn parse(name: &str) -> Result<Self, Text> {
        let (mut modifiers, mut rest) = (KeyModifiers::NONE, name);
        while let Some((prefix, modifier)) =
            MODIFIERS.iter().find(|(prefix, _)| rest.len() > prefix.len() && rest.starts_with(prefix))
        {
            modifiers |= *modifier;
            rest = &rest[prefix.len()..];
        }
        let code = code_of(rest).ok_or_else(|| unknown(name, rest))?;
        match code {
            KeyCode::Char(character) if character != ' ' && modifiers.contains(KeyModifiers::SHIFT) => {
                let upper = character.to_uppercase().to_string();
                Err(Text::new("`{key}`: Shift is part of a character; write `{upper}`")
                    .with("key", name)
                    .with("upper", upper))
            }
            KeyCode::Char(character) if modifiers.contains(KeyModifiers::CONTROL) => {
                let small = character.to_ascii_lowercase();
                match SAME_BYTE.iter().find(|(letter, _)| *letter == small) {
                    Some((_, other)) => Err(Text::new("a terminal sends `{other}` for `{key}`: write that")
                        .with("other", *other)
                        .with("key", name)),
                    None => Ok(Key(KeyCode::Char(small), modifiers)),
                }
            }
            KeyCode::Tab if modifiers.contains(KeyModifiers::SHIFT) => {
                Ok(Key(KeyCode::BackTab, modifiers.difference(KeyModifiers::SHIFT)))
            }
            _ => Ok(Key(code, modifiers)),
        }
    }

    /// Its name in the settings; [`parse`](Self::parse) reads it.
    pub fn id(self) -> String {
        let (code, shift) = match self.0 {
            KeyCode::BackTab => (KeyCode::Tab, KeyModifiers::SHIFT),
            code => (code, KeyModifiers::NONE),
        };
        let modifiers = self.1 | shift;
        let mut id: String = MODIFIERS
            .iter()
            .filter(|(_, modifier)| modifiers.contains(*modifier))
            .map(|(prefix, _)| *prefix)
            .collect();
        id += &match (NAMED.iter().find(|(_, named)| *named == code), code) {
            (Some((name, _)), _) => (*name).to_owned(),
            (None, KeyCode::Char(character)) => character.to_string(),
            (None, KeyCode::F(number)) => format!("f{number}"),
            (None, other) => other.to_string().to_lowercase(),
        };
        id
    }

    /// Whether it writes a character where text is typed.
    pub fn is_text(self) -> bool {
        matches!(self.0, KeyCode::Char(_)) && self.1.difference(KeyModifiers::SHIFT).is_empty()
    }
}

fn code_of(name: &str) -> Option<KeyCode> {
    if let Some((_, code)) = NAMED.iter().find(|(known, _)| known.eq_ignore_ascii_case(name)) {
        return Some(*code);
    }
    let mut characters = name.chars();
    match (characters.next(), characters.as_str()) {
        (Some('f' | 'F'), digits @ ("2" | "3" | "4" | "5" | "6" | "7" | "8" | "9" | "10" | "11" | "12")) => {
            digits.parse().ok().map(KeyCode::F)
        }
        (Some(character), "") if !character.is_control() && character != ' ' => {
            Some(KeyCode::Char(character))
        }
        _ => None,
    }
}

fn unknown(name: &str, rest: &str) -> Text {
    match nearest(rest, NAMED.iter().map(|(known, _)| *known)) {
        Some(near) => Text::new("`{key}` is no key; did you mean `{near}`?")
            .with("key", name)
            .with("near", format!("{}{near}", &name[..name.len() - rest.len()])),
        None => {
            Text::new("`{key}` is no key; write a character, or `ctrl-s`, `f5`, `shift-up`").with("key", name)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_key_of_the_tables_is_written_and_read_again() {
        for binding in Place::ALL.into_iter().flat_map(Place::bindings) {
            for key in binding.keys {
                assert_eq!(Key::parse(&key.id()), Ok(*key), "{}", key.id());
            }
        }
    }

    #[test]
    fn what_no_terminal_sends_is_refused_with_what_to_write() {
        let why = |name| Key::parse(name).map_err(|why| why.english());
        assert_eq!(why("shift-g"), Err("`shift-g`: Shift is part of a character; write `G`".into()));
        assert_eq!(why("ctrl-i"), Err("a terminal sends `tab` for `ctrl-i`: write that".into()));
        assert_eq!(
            why("ctrl-pagedown"),
            Err("`ctrl-pagedown` is no key; did you mean `ctrl-page-down`?".into())
        );
        assert_eq!(why("ctrl-S"), Ok(Key(KeyCode::Char('s'), KeyModifiers::CONTROL)));
        assert_eq!(why("-"), Ok(Key(KeyCode::Char('-'), KeyModifiers::NONE)));
        assert_eq!(why("alt--"), Ok(Key(KeyCode::Char('-'), KeyModifiers::ALT)));
    }
}
