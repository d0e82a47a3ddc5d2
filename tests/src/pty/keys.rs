//! Byte sequences that an xterm sends for keys.

use dalembert_tui::keys::notation::keys_of;
use ratatui::crossterm::event::{KeyCode, KeyEvent, KeyModifiers};

/// The bytes for text with names of keys; see [`Pty::types`](super::Pty::types).
pub(super) fn bytes_of(text: &str) -> Vec<u8> {
    let keys = keys_of(text).unwrap_or_else(|name| panic!("{name} is no key"));
    keys.into_iter().flat_map(bytes_of_key).collect()
}

fn bytes_of_key(key: KeyEvent) -> Vec<u8> {
    let held = |modifier, worth: u8| if key.modifiers.contains(modifier) { worth } else { 0 };
    let modifiers =
        held(KeyModifiers::SHIFT, 1) + held(KeyModifiers::ALT, 2) + held(KeyModifiers::CONTROL, 4);
    let letter = |last: char| match modifiers {
        0 => format!("\x1b[{last}"),
        _ => format!("\x1b[1;{}{last}", modifiers + 1),
    };
    let number = |code: u8| match modifiers {
        0 => format!("\x1b[{code}~"),
        _ => format!("\x1b[{code};{}~", modifiers + 1),
    };
    let sequence = match key.code {
        KeyCode::Enter => "\r".to_owned(),
        KeyCode::BackTab => "\x1b[Z".to_owned(),
        KeyCode::Tab => "\t".to_owned(),
        KeyCode::Esc => "\x1b".to_owned(),
        KeyCode::Char(' ') if modifiers == 4 => "\0".to_owned(),
        KeyCode::Backspace => "\x7f".to_owned(),
        KeyCode::Up => letter('A'),
        KeyCode::Down => letter('B'),
        KeyCode::Right => letter('C'),
        KeyCode::Left => letter('D'),
        KeyCode::Home => letter('H'),
        KeyCode::End => letter('F'),
        KeyCode::Insert => number(2),
        KeyCode::Delete => number(3),
        KeyCode::PageUp => number(5),
        KeyCode::PageDown => number(6),
        KeyCode::F(n @ 1..=4) if modifiers == 0 => format!("\x1bO{}", char::from(b'P' + n - 1)),
        KeyCode::F(n @ 1..=4) => letter(char::from(b'P' + n - 1)),
        KeyCode::F(n @ 5..=12) => number([15, 17, 18, 19, 20, 21, 23, 24][usize::from(n) - 5]),
        KeyCode::Char(character) => {
            let plain = match modifiers & 4 {
                0 => character.to_string(),
                _ => char::from(character.to_ascii_uppercase() as u8 & 0x1F).to_string(),
            };
            if modifiers & 2 == 0 { plain } else { format!("\x1b{plain}") }
        }
        other => panic!("no terminal sends {other}"),
    };
    sequence.into_bytes()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_are_written_as_an_xterm_sends_them() {
        for (text, bytes) in [
            ("a<lt>b", &b"a<b"[..]),
            ("<down><enter>", b"\x1b[B\r"),
            ("<c-c><s-tab><f1><f12>", b"\x03\x1b[Z\x1bOP\x1b[24~"),
            ("<c-right><s-f5><a-x><c-s-up>", b"\x1b[1;5C\x1b[15;2~\x1bx\x1b[1;6A"),
            ("<c-->", b"\x0d"),
        ] {
            assert_eq!(bytes_of(text), bytes, "{text}");
        }
    }
}
