//! What an xterm sends for a key.

/// The bytes for text with names of keys; see [`Pty::types`](super::Pty::types).
pub(super) fn bytes_of(text: &str) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut rest = text;
    while let Some((plain, after)) = rest.split_once('<') {
        let (name, after) =
            after.split_once('>').expect("the name of a key ends with `>`; write <lt> for `<`");
        bytes.extend_from_slice(plain.as_bytes());
        bytes.extend(key(name));
        rest = after;
    }
    bytes.extend_from_slice(rest.as_bytes());
    bytes
}

fn key(name: &str) -> Vec<u8> {
    let (mut modifiers, mut base) = (0, name);
    while let Some((modifier, rest)) =
        base.split_once('-').filter(|(modifier, rest)| modifier.len() == 1 && !rest.is_empty())
    {
        modifiers |= match modifier {
            "s" => 1,
            "a" => 2,
            "c" => 4,
            _ => panic!("`{name}` is no key"),
        };
        base = rest;
    }
    let letter = |last: char| match modifiers {
        0 => format!("\x1b[{last}"),
        _ => format!("\x1b[1;{}{last}", modifiers + 1),
    };
    let number = |code: u8| match modifiers {
        0 => format!("\x1b[{code}~"),
        _ => format!("\x1b[{code};{}~", modifiers + 1),
    };
    let sequence = match base {
        "lt" => "<".to_owned(),
        "enter" => "\r".to_owned(),
        "tab" if modifiers == 1 => "\x1b[Z".to_owned(),
        "tab" => "\t".to_owned(),
        "esc" => "\x1b".to_owned(),
        "space" if modifiers == 4 => "\0".to_owned(),
        "space" => " ".to_owned(),
        "bs" => "\x7f".to_owned(),
        "up" => letter('A'),
        "down" => letter('B'),
        "right" => letter('C'),
        "left" => letter('D'),
        "home" => letter('H'),
        "end" => letter('F'),
        "ins" => number(2),
        "del" => number(3),
        "pgup" => number(5),
        "pgdn" => number(6),
        _ if base.len() > 1 && base.starts_with('f') => match base[1..].parse() {
            Ok(n @ 1..=4_u8) if modifiers == 0 => format!("\x1bO{}", char::from(b'P' + n - 1)),
            Ok(n @ 1..=4) => letter(char::from(b'P' + n - 1)),
            Ok(n @ 5..=12) => number([15, 17, 18, 19, 20, 21, 23, 24][usize::from(n) - 5]),
            _ => panic!("`{name}` is no key"),
        },
        _ => {
            let mut characters = base.chars();
            let (Some(character), None) = (characters.next(), characters.next()) else {
                panic!("`{name}` is no key")
            };
            let plain = match modifiers & 4 {
                0 => character.to_string(),
                _ => char::from(character.to_ascii_uppercase() as u8 & 0x1F).to_string(),
            };
            if modifiers & 2 == 0 { plain } else { format!("\x1b{plain}") }
        }
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
