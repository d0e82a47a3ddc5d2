//! Notation of keys: on the screen, in the settings, and in replays and tests.

use dalembert_core::{Language, Locale, Text, nearest};
use ratatui::crossterm::event::{KeyCode, KeyEvent, KeyModifiers};

use super::Key;

/// A column of [`NAMED`] and [`MODIFIERS`].
#[derive(Clone, Copy, PartialEq, Eq)]
enum Notation {
    /// As a user reads it: `Ctrl-PgUp`.
    Screen,
    /// `ctrl-page-up`
    Settings,
    /// `<c-pgup>`
    Replay,
}

/// Keys that are no characters, in each [`Notation`].
const NAMED: [([&str; 3], KeyCode); 15] = [
    (["Enter", "enter", "enter"], KeyCode::Enter),
    (["Esc", "esc", "esc"], KeyCode::Esc),
    (["Tab", "tab", "tab"], KeyCode::Tab),
    (["Backspace", "backspace", "bs"], KeyCode::Backspace),
    (["Del", "delete", "del"], KeyCode::Delete),
    (["Insert", "insert", "ins"], KeyCode::Insert),
    (["Space", "space", "space"], KeyCode::Char(' ')),
    (["↑", "up", "up"], KeyCode::Up),
    (["↓", "down", "down"], KeyCode::Down),
    (["←", "left", "left"], KeyCode::Left),
    (["→", "right", "right"], KeyCode::Right),
    (["Home", "home", "home"], KeyCode::Home),
    (["End", "end", "end"], KeyCode::End),
    (["PgUp", "page-up", "pgup"], KeyCode::PageUp),
    (["PgDn", "page-down", "pgdn"], KeyCode::PageDown),
];

/// Keys with an arrow on them, in English and in Portuguese for a terminal without arrows.
const ARROWS: [(&str, KeyCode, [&str; 2]); 4] = [
    ("↑", KeyCode::Up, ["Up", "Cima"]),
    ("↓", KeyCode::Down, ["Down", "Baixo"]),
    ("←", KeyCode::Left, ["Left", "Esquerda"]),
    ("→", KeyCode::Right, ["Right", "Direita"]),
];

/// Modifiers of a key, in each [`Notation`].
const MODIFIERS: [([&str; 3], KeyModifiers); 3] = [
    (["Ctrl-", "ctrl-", "c-"], KeyModifiers::CONTROL),
    (["Alt-", "alt-", "a-"], KeyModifiers::ALT),
    (["Shift-", "shift-", "s-"], KeyModifiers::SHIFT),
];

/// Byte that a terminal sends for a letter with Ctrl, which is that of another key.
const SAME_BYTE: [(char, &str); 4] = [('i', "tab"), ('m', "enter"), ('h', "backspace"), ('[', "esc")];

impl Key {
    /// Name for display: `Ctrl-C`, `↑`, `Esc`.
    pub fn name(self, locale: &Locale) -> String {
        let portuguese = locale.language == Language::Portuguese;
        if let Some((arrow, _, names)) =
            ARROWS.iter().find(|(_, code, _)| *code == self.0).filter(|_| locale.style.ascii)
        {
            // `<` and `v` are keys of their own.
            return self.written(Notation::Screen).replace(arrow, names[usize::from(portuguese)]);
        }
        match (self.0, locale.language) {
            (KeyCode::Char(' '), Language::Portuguese) => {
                self.written(Notation::Screen).replace("Space", "Espaço")
            }
            (KeyCode::Char(character), _) if self.1.contains(KeyModifiers::CONTROL) => {
                Key(KeyCode::Char(character.to_ascii_uppercase()), self.1).written(Notation::Screen)
            }
            _ => self.written(Notation::Screen),
        }
    }

    /// Name in the settings; [`parse`](Self::parse) reads it.
    pub fn id(self) -> String {
        self.written(Notation::Settings)
    }

    /// The key of a name such as `g`, `ctrl-s`, `f5`, `shift-up`.
    pub fn parse(name: &str) -> Result<Self, Text> {
        let key = read(name, Notation::Settings).map_err(|rest| unknown(name, rest))?;
        match key {
            Key(KeyCode::Char(character), modifiers)
                if character != ' ' && modifiers.contains(KeyModifiers::SHIFT) =>
            {
                let upper = character.to_uppercase().to_string();
                Err(Text::new("`{key}`: Shift is part of a character; write `{upper}`")
                    .with("key", name)
                    .with("upper", upper))
            }
            Key(KeyCode::Char(character), modifiers) if modifiers.contains(KeyModifiers::CONTROL) => {
                let small = character.to_ascii_lowercase();
                match SAME_BYTE.iter().find(|(letter, _)| *letter == small) {
                    Some((_, other)) => {
                        Err(Text::new("a terminal sends `{other}` for `{key}`: write `{other}`")
                            .with("other", *other)
                            .with("key", name))
                    }
                    None => Ok(Key(KeyCode::Char(small), modifiers)),
                }
            }
            key => Ok(key),
        }
    }

    fn written(self, notation: Notation) -> String {
        let (code, held) = match self.0 {
            KeyCode::BackTab => (KeyCode::Tab, self.1 | KeyModifiers::SHIFT),
            code => (code, self.1),
        };
        let held = MODIFIERS.iter().filter(|(_, modifier)| held.contains(*modifier));
        let held: String = held.map(|(names, _)| names[notation as usize]).collect();
        held + &match (NAMED.iter().find(|(_, named)| *named == code), code) {
            (Some((names, _)), _) => names[notation as usize].to_owned(),
            (None, KeyCode::Char(character)) => character.to_string(),
            (None, KeyCode::F(number)) if notation != Notation::Screen => format!("f{number}"),
            (None, other) => other.to_string(),
        }
    }
}

/// The keys of a text. Names in angle brackets are keys: `<enter> <tab> <esc> <space> <bs> <del> <ins> <up> <down>
/// <left> <right> <home> <end> <pgup> <pgdn> <f1>`…`<f12>`, with `c-`, `s-`, `a-` for Ctrl, Shift, Alt (`<c-c>`,
/// `<s-tab>`, `<a-up>`), and `<lt>` for `<` itself. Fails with the name that is no key.
///
/// ```
/// use dalembert_tui::keys::notation::{keys_of, written};
///
/// let keys = keys_of("<end><del>1500 rpm<enter>").unwrap();
/// assert_eq!(keys.len(), 11);
/// assert_eq!(keys.into_iter().map(written).collect::<String>(), "<end><del>1500 rpm<enter>");
/// assert_eq!(keys_of("<return>"), Err("<return>".to_owned()));
/// ```
pub fn keys_of(text: &str) -> Result<Vec<KeyEvent>, String> {
    let mut keys = Vec::new();
    let mut rest = text;
    while let Some(character) = rest.chars().next() {
        let (key, after) = match rest.strip_prefix('<').and_then(|named| named.split_once('>')) {
            Some(("lt", after)) => (Key(KeyCode::Char('<'), KeyModifiers::NONE), after),
            Some((name, after)) => (read(name, Notation::Replay).map_err(|_| format!("<{name}>"))?, after),
            None => (Key(KeyCode::Char(character), KeyModifiers::NONE), &rest[character.len_utf8()..]),
        };
        keys.push(KeyEvent::new(key.0, key.1));
        rest = after;
    }
    Ok(keys)
}

/// Notation of a key in a text; [`keys_of`] reads it.
pub fn written(event: KeyEvent) -> String {
    match Key::of(event) {
        Key(KeyCode::Char('<'), KeyModifiers::NONE) => "<lt>".to_owned(),
        Key(KeyCode::Char(character), KeyModifiers::NONE) => character.to_string(),
        key => format!("<{}>", key.written(Notation::Replay)),
    }
}

/// The key of a name, or what of the name is no key.
fn read(name: &str, notation: Notation) -> Result<Key, &str> {
    let (mut held, mut rest) = (KeyModifiers::NONE, name);
    while let Some((after, modifier)) = MODIFIERS.iter().find_map(|(names, modifier)| {
        Some((rest.strip_prefix(names[notation as usize])?, modifier)).filter(|(after, _)| !after.is_empty())
    }) {
        held |= *modifier;
        rest = after;
    }
    let named = NAMED.iter().find(|(names, _)| names[notation as usize].eq_ignore_ascii_case(rest));
    let mut characters = rest.chars();
    let code = match (named, characters.next(), characters.as_str()) {
        (Some((_, code)), ..) => *code,
        (None, Some(character), "") if !character.is_control() && character != ' ' => {
            KeyCode::Char(character)
        }
        (None, Some('f' | 'F'), number) => match number.parse() {
            Ok(number @ 1..=12) => KeyCode::F(number),
            _ => return Err(rest),
        },
        _ => return Err(rest),
    };
    Ok(match code {
        KeyCode::Tab if held.contains(KeyModifiers::SHIFT) => {
            Key(KeyCode::BackTab, held.difference(KeyModifiers::SHIFT))
        }
        code => Key(code, held),
    })
}

fn unknown(name: &str, rest: &str) -> Text {
    let known = NAMED.iter().map(|(names, _)| names[Notation::Settings as usize]);
    match nearest(rest, known) {
        Some(near) => Text::new("`{key}` is not a key; did you mean `{near}`?")
            .with("key", name)
            .with("near", format!("{}{near}", &name[..name.len() - rest.len()])),
        None => Text::new("`{key}` is not a key; write a character, or `ctrl-s`, `f5`, `shift-up`")
            .with("key", name),
    }
}

#[cfg(test)]
mod tests {
    use super::{
        super::{
            KeyContext,
            tables::{ctrl, plain, shift, typed},
        },
        *,
    };
    use crate::panes::places;

    #[test]
    fn every_key_of_the_tables_is_written_and_read_again() {
        for binding in places().into_iter().flat_map(KeyContext::bindings) {
            for key in binding.keys {
                assert_eq!(Key::parse(&key.id()), Ok(*key), "{}", key.id());
                let text = written(KeyEvent::new(key.0, key.1));
                let read: Vec<Key> = keys_of(&text).expect("a key").into_iter().map(Key::of).collect();
                assert_eq!(read, [*key], "{text}");
            }
        }
    }

    #[test]
    fn what_no_terminal_sends_is_refused_with_what_to_write() {
        let why = |name| Key::parse(name).map_err(|why| why.english());
        assert_eq!(why("shift-g"), Err("`shift-g`: Shift is part of a character; write `G`".into()));
        assert_eq!(why("ctrl-i"), Err("a terminal sends `tab` for `ctrl-i`: write `tab`".into()));
        assert_eq!(
            why("ctrl-pagedown"),
            Err("`ctrl-pagedown` is not a key; did you mean `ctrl-page-down`?".into())
        );
        assert_eq!(why("ctrl-S"), Ok(Key(KeyCode::Char('s'), KeyModifiers::CONTROL)));
        assert_eq!(why("-"), Ok(Key(KeyCode::Char('-'), KeyModifiers::NONE)));
        assert_eq!(why("alt--"), Ok(Key(KeyCode::Char('-'), KeyModifiers::ALT)));
        assert!(why("f13").is_err() && why(" ").is_err() && why("").is_err());
    }

    #[test]
    fn keys_are_named_as_they_are_printed() {
        for (key, name) in [
            (ctrl('c'), "Ctrl-C"),
            (shift(KeyCode::Up), "Shift-↑"),
            (typed(' '), "Space"),
            (plain(KeyCode::F(1)), "F1"),
            (plain(KeyCode::BackTab), "Shift-Tab"),
        ] {
            assert_eq!(key.name(&Locale::english()), name);
        }
        assert_eq!(typed(' ').name(&Locale::portuguese()), "Espaço");
        let ascii = Locale::english().ascii(true);
        assert_eq!(
            [shift(KeyCode::Up), plain(KeyCode::Left)].map(|key| key.name(&ascii)),
            ["Shift-Up", "Left"]
        );
    }

    #[test]
    fn what_is_written_is_read_again() {
        for text in [
            "a<lt>b",
            "<down><enter> <c-space>",
            "<c-c><s-tab><f1><f12>",
            "<c-right><a-x><c-s-up><a-+>",
            "<c-->",
            "ωθ√",
        ] {
            let keys = keys_of(text).expect("every name is a key");
            assert_eq!(keys.into_iter().map(written).collect::<String>(), text);
        }
    }

    #[test]
    fn an_angle_that_is_not_closed_is_itself() {
        let keys = keys_of("<").expect("a character");
        assert_eq!(keys, [KeyEvent::new(KeyCode::Char('<'), KeyModifiers::NONE)]);
    }
}
