//! Keys as text, as tests and replays write them.

use ratatui::crossterm::event::{KeyCode, KeyEvent, KeyModifiers};

/// Keys that have a name.
const NAMED: [(&str, KeyCode); 16] = [
    ("tab", KeyCode::Tab),
    ("enter", KeyCode::Enter),
    ("esc", KeyCode::Esc),
    ("bs", KeyCode::Backspace),
    ("del", KeyCode::Delete),
    ("ins", KeyCode::Insert),
    ("up", KeyCode::Up),
    ("down", KeyCode::Down),
    ("left", KeyCode::Left),
    ("right", KeyCode::Right),
    ("home", KeyCode::Home),
    ("end", KeyCode::End),
    ("pgup", KeyCode::PageUp),
    ("pgdn", KeyCode::PageDown),
    ("space", KeyCode::Char(' ')),
    ("lt", KeyCode::Char('<')),
];

/// What the letters before a name hold down, in the order in which they are written.
const MODIFIERS: [(&str, KeyModifiers); 3] =
    [("c", KeyModifiers::CONTROL), ("a", KeyModifiers::ALT), ("s", KeyModifiers::SHIFT)];

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
        match rest.strip_prefix('<').and_then(|named| named.split_once('>')) {
            Some((name, after)) => {
                keys.push(named(name).ok_or_else(|| format!("<{name}>"))?);
                rest = after;
            }
            None => {
                keys.push(KeyEvent::new(KeyCode::Char(character), KeyModifiers::NONE));
                rest = &rest[character.len_utf8()..];
            }
        }
    }
    Ok(keys)
}

/// How a key is written; empty for one that has no name.
pub fn written(key: KeyEvent) -> String {
    let base = match key.code {
        KeyCode::Char(' ') if key.modifiers.is_empty() => return " ".to_owned(),
        KeyCode::BackTab => "tab".to_owned(),
        KeyCode::F(n) => format!("f{n}"),
        code => match (NAMED.iter().find(|(_, named)| *named == code), code) {
            (Some((name, _)), _) => (*name).to_owned(),
            (None, KeyCode::Char(character)) => character.to_string(),
            (None, _) => return String::new(),
        },
    };
    let mut held = key.modifiers;
    if matches!(key.code, KeyCode::Char(_)) {
        // The character says it.
        held.remove(KeyModifiers::SHIFT);
    }
    held.set(KeyModifiers::SHIFT, held.contains(KeyModifiers::SHIFT) || key.code == KeyCode::BackTab);
    if base.chars().count() == 1 && held.is_empty() {
        return base;
    }
    let mut name = String::from("<");
    for (letter, _) in MODIFIERS.iter().filter(|(_, modifier)| held.contains(*modifier)) {
        name.extend([*letter, "-"]);
    }
    name + &base + ">"
}

fn named(name: &str) -> Option<KeyEvent> {
    let (mut modifiers, mut base) = (KeyModifiers::NONE, name);
    while let Some((modifier, rest)) =
        base.split_once('-').filter(|(modifier, rest)| modifier.len() == 1 && !rest.is_empty())
    {
        modifiers |= MODIFIERS.iter().find(|(letter, _)| *letter == modifier)?.1;
        base = rest;
    }
    let code = match NAMED.iter().find(|(name, _)| *name == base) {
        Some((_, KeyCode::Tab)) if modifiers.contains(KeyModifiers::SHIFT) => KeyCode::BackTab,
        Some((_, code)) => *code,
        None => match base.strip_prefix('f').and_then(|number| number.parse().ok()) {
            Some(number @ 1..=12) => KeyCode::F(number),
            _ => {
                let mut characters = base.chars();
                match (characters.next(), characters.next()) {
                    (Some(character), None) => KeyCode::Char(character),
                    _ => return None,
                }
            }
        },
    };
    Some(KeyEvent::new(code, modifiers))
}

#[cfg(test)]
mod tests {
    use super::*;

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
