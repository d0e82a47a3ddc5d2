use super::*;

/// Everything the bytes mean, with what is left at the end settled.
fn decode(bytes: &[u8]) -> Vec<TerminalInput> {
    let (mut decoder, mut inputs) = (Decoder::default(), Vec::new());
    decoder.feed(bytes, &mut inputs);
    decoder.settle(&mut inputs);
    assert_eq!(decoder.patience(), None, "settled");
    inputs
}

fn press(code: KeyCode, modifiers: KeyModifiers) -> Vec<TerminalInput> {
    vec![key(code, modifiers)]
}

#[test]
fn keys_of_xterm() {
    use KeyCode::{
        BackTab, Backspace, Char, Delete, Down, End, Enter, Esc, F, Home, Insert, PageDown, Tab, Up,
    };
    const NONE: KeyModifiers = KeyModifiers::NONE;
    const SHIFT: KeyModifiers = KeyModifiers::SHIFT;
    const ALT: KeyModifiers = KeyModifiers::ALT;
    const CTRL: KeyModifiers = KeyModifiers::CONTROL;
    for (bytes, code, modifiers) in [
        (&b"a"[..], Char('a'), NONE),
        (b"A", Char('A'), SHIFT),
        ("ç".as_bytes(), Char('ç'), NONE),
        ("Ω".as_bytes(), Char('Ω'), SHIFT),
        ("梁".as_bytes(), Char('梁'), NONE),
        ("🙂".as_bytes(), Char('🙂'), NONE),
        (b"\r", Enter, NONE),
        (b"\n", Char('j'), CTRL),
        (b"\t", Tab, NONE),
        (b"\x1b[Z", BackTab, SHIFT),
        (b"\x7f", Backspace, NONE),
        (b"\x08", Backspace, NONE),
        (b"\x03", Char('c'), CTRL),
        (b"\x1a", Char('z'), CTRL),
        (b"\x1c", Char('\\'), CTRL),
        (b"\x1f", Char('_'), CTRL),
        (b"\0", Char(' '), CTRL),
        (b"\x1b", Esc, NONE),
        (b"\x1bx", Char('x'), ALT),
        (b"\x1b\x01", Char('a'), ALT.union(CTRL)),
        ("\x1bé".as_bytes(), Char('é'), ALT),
        (b"\x1b\x7f", Backspace, ALT),
        (b"\x1b[", Char('['), ALT),
        (b"\x1b]", Char(']'), ALT),
        (b"\x1bO", Char('O'), ALT.union(SHIFT)),
        (b"\x1b[A", Up, NONE),
        (b"\x1bOB", Down, NONE),
        (b"\x1b[1;5A", Up, CTRL),
        (b"\x1b[1;2B", Down, SHIFT),
        (b"\x1b[1;7A", Up, ALT.union(CTRL)),
        (b"\x1b\x1b[A", Up, ALT),
        (b"\x1b[H", Home, NONE),
        (b"\x1b[1~", Home, NONE),
        (b"\x1b[8~", End, NONE),
        (b"\x1b[2~", Insert, NONE),
        (b"\x1b[3~", Delete, NONE),
        (b"\x1b[6;5~", PageDown, CTRL),
        (b"\x1bOP", F(1), NONE),
        (b"\x1b[[A", F(1), NONE),
        (b"\x1b[1;2R", F(3), SHIFT),
        (b"\x1b[15~", F(5), NONE),
        (b"\x1b[21~", F(10), NONE),
        (b"\x1b[24;2~", F(12), SHIFT),
        (b"\x1bOM", Enter, NONE),
        (b"\x1bOk", Char('+'), NONE),
        (b"\x1b[27;5;13~", Enter, CTRL),
        (b"\x1b[97;5u", Char('a'), CTRL),
    ] {
        assert_eq!(decode(bytes), press(code, modifiers), "{}", bytes.escape_ascii());
    }
}

#[test]
fn mouse_reports_count_from_zero_and_never_underflow() {
    let report = |kind, column, row, modifiers| {
        vec![TerminalInput::Mouse(MouseEvent { kind, column, row, modifiers })]
    };
    let none = KeyModifiers::NONE;
    assert_eq!(decode(b"\x1b[<0;3;7M"), report(MouseEventKind::Down(MouseButton::Left), 2, 6, none));
    assert_eq!(decode(b"\x1b[<2;3;7m"), report(MouseEventKind::Up(MouseButton::Right), 2, 6, none));
    assert_eq!(decode(b"\x1b[<33;3;7M"), report(MouseEventKind::Drag(MouseButton::Middle), 2, 6, none));
    assert_eq!(decode(b"\x1b[<81;1;1M"), report(MouseEventKind::ScrollDown, 0, 0, KeyModifiers::CONTROL));
    assert_eq!(decode(b"\x1b[<0;0;0M"), report(MouseEventKind::Down(MouseButton::Left), 0, 0, none));
    assert_eq!(decode(b"\x1b[<0;99999999999;1M"), []);
    assert_eq!(decode(b"\x1b[<0;70000;1M"), []);
}

#[test]
fn answers_of_the_terminal_are_dropped_whole() {
    for answer in [
        &b"\x1b[?62;22c"[..],
        b"\x1b[12;40R",
        b"\x1b[1;1R",
        b"\x1b[0n",
        b"\x1b[?2026;2$y",
        b"\x1b[I",
        b"\x1b[O",
        b"\x1b]11;rgb:1e1e/1e1e/1e1e\x07",
        b"\x1b]11;rgb:1e1e/1e1e/1e1e\x1b\\",
        b"\x1bP>|XTerm(388)\x1b\\",
        b"\x1b_Gi=31;OK\x1b\\",
        b"\x1b[8;24;80t",
        b"\x1b[M !!",
        b"\x1b[201~",
        b"\x1b[97;1:3u",
    ] {
        let mut followed = answer.to_vec();
        followed.push(b'k');
        assert_eq!(
            decode(&followed),
            press(KeyCode::Char('k'), KeyModifiers::NONE),
            "{}",
            answer.escape_ascii()
        );
    }
}

#[test]
fn where_the_bytes_are_cut_does_not_matter() {
    let stream = "q\x1b[1;5Aé\x1bOP\x1b[200~two\nlines \x1b[A\x1b[201~\x1b[<0;5;5M\x1b]0;t\x07\x1b\x1b[B🙂\r"
        .as_bytes();
    let whole = decode(stream);
    assert_eq!(whole.len(), 9);
    for cut in 0..stream.len() {
        let (mut decoder, mut inputs) = (Decoder::default(), Vec::new());
        decoder.feed(&stream[..cut], &mut inputs);
        decoder.feed(&stream[cut..], &mut inputs);
        decoder.settle(&mut inputs);
        assert_eq!(inputs, whole, "cut at {cut}");
    }
}

#[test]
fn every_escape_of_a_held_key_counts() {
    for count in 1..6 {
        assert_eq!(decode(&vec![0x1B; count]).len(), count);
    }
}

#[test]
fn an_open_paste_ends_with_silence_and_the_keys_live_on() {
    let (mut decoder, mut inputs) = (Decoder::default(), Vec::new());
    decoder.feed(b"\x1b[200~mass = 3 kg", &mut inputs);
    assert_eq!((decoder.patience(), &inputs[..]), (Some(PASTE_PATIENCE), &[][..]));
    decoder.settle(&mut inputs);
    decoder.feed(b"k", &mut inputs);
    assert_eq!(
        inputs,
        [TerminalInput::Paste("mass = 3 kg".into()), key(KeyCode::Char('k'), KeyModifiers::NONE)]
    );
}

#[test]
fn a_paste_is_cut_at_its_limit_with_a_notice() {
    let paste = |length: usize| [b"\x1b[200~", &vec![b'x'; length][..], b"\x1b[201~k"].concat();
    let at = |length: usize| {
        let inputs = decode(&paste(length));
        let [TerminalInput::Paste(text), rest @ ..] = &inputs[..] else { panic!("no paste: {length}") };
        (text.len(), rest.len(), rest.last().cloned())
    };
    let last = Some(key(KeyCode::Char('k'), KeyModifiers::NONE));
    assert_eq!(at(PASTE_LIMIT), (PASTE_LIMIT, 1, last.clone()));
    assert_eq!(at(PASTE_LIMIT + 1), (PASTE_LIMIT, 2, last.clone()));
    assert_eq!(at(2 * PASTE_LIMIT + 12345), (PASTE_LIMIT, 2, last));
}

#[test]
fn a_paste_may_hold_anything_but_its_end() {
    assert_eq!(
        decode(b"\x1b[200~a\x1b[31m\x03\xff\x1b[20\x1b[201~"),
        [TerminalInput::Paste("a\x1b[31m\x03\u{FFFD}\x1b[20".into())]
    );
    assert_eq!(decode(b"\x1b[200~\x1b[201~"), []);
}

/// A million random bytes, rich in what begins sequences, cut at random: no panic, nothing held for ever, no control
/// character as a key, and the next key is always read.
#[test]
fn no_bytes_stall_it() {
    let mut state = 0x9E37_79B9_7F4A_7C15_u64;
    let mut random = move |below: u64| {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        state % below
    };
    let rich = b"\x1b\x1b\x1b[[[OPX]^_<;;:?~MmRuZA0123456789\x07\x9b\x9c\xc3\xf0\xff\0 ";
    for _ in 0..20_000 {
        let bytes: Vec<u8> = (0..50)
            .map(|_| match random(3) {
                0 => random(256) as u8,
                _ => rich[random(rich.len() as u64) as usize],
            })
            .collect();
        let mut inputs = decode(&bytes);
        for input in &inputs {
            if let TerminalInput::Key(KeyEvent { code: KeyCode::Char(character), .. }) = input {
                assert!(!character.is_control(), "{}", bytes.escape_ascii());
            }
        }
        inputs.clear();
        let mut decoder = Decoder::default();
        decoder.feed(&bytes, &mut inputs);
        decoder.settle(&mut inputs);
        inputs.clear();
        decoder.feed(b"k", &mut inputs);
        assert_eq!(inputs, press(KeyCode::Char('k'), KeyModifiers::NONE), "{}", bytes.escape_ascii());
    }
}

#[test]
fn an_answer_that_comes_in_parts_is_dropped_and_one_that_never_ends_keeps_no_later_key() {
    for answer in [
        &b"\x1b_Gi=31;OK\x1b\\"[..],
        b"\x1bP>|kitty(0.36.4)\x1b\\",
        b"\x1b]11;rgb:24/24/24\x07",
        b"\x1b[6;20;10t",
    ] {
        for cut in 3..answer.len() {
            let (mut decoder, mut inputs) = (Decoder::default(), Vec::new());
            decoder.feed(&answer[..cut], &mut inputs);
            assert!(decoder.patience() >= Some(ESCAPE_PATIENCE), "{} {cut}", answer.escape_ascii());
            decoder.feed(&answer[cut..], &mut inputs);
            decoder.feed(b"x", &mut inputs);
            assert_eq!(
                inputs,
                press(KeyCode::Char('x'), KeyModifiers::NONE),
                "{} {cut}",
                answer.escape_ascii()
            );
            // Nothing more came.
            let mut broken = Decoder::default();
            broken.feed(&answer[..cut], &mut inputs);
            inputs.clear();
            broken.settle(&mut inputs);
            broken.feed(b"x", &mut inputs);
            assert_eq!(
                inputs,
                press(KeyCode::Char('x'), KeyModifiers::NONE),
                "{} {cut}",
                answer.escape_ascii()
            );
        }
        let mut decoder = Decoder::default();
        decoder.feed(&answer[..4], &mut Vec::new());
        assert_eq!(decoder.patience(), Some(ANSWER_PATIENCE), "{}", answer.escape_ascii());
    }
}
