//! Key decoding: from the bytes of a terminal to keys, mouse reports and pastes, as a pure state machine.
//!
//! It knows what xterm and its relatives send in raw mode: UTF-8, control characters, `ESC` as Alt, `CSI` and `SS3`
//! keys with modifiers, SGR mouse reports and bracketed paste. Everything else is dropped whole, so that an answer to
//! some program's question never ends up in a field as stray characters. No byte sequence can panic it, and none
//! can hold it for ever: see [`Decoder::patience`].
//!
//! Source: *XTerm Control Sequences* (ctlseqs), sections "C1 (8-Bit) Control Characters", "PC-Style Function Keys",
//! "Mouse Tracking", "Bracketed Paste Mode".

#[cfg(test)]
mod tests;

use std::time::Duration;

use ratatui::crossterm::event::{KeyCode, KeyEvent, KeyModifiers, MouseButton, MouseEvent, MouseEventKind};

/// The longest paste that is kept, in bytes.
pub const PASTE_LIMIT: usize = 8 * 1024 * 1024;
/// A lone `ESC` is the Escape key when nothing follows it for this long. A serial line of 9600 baud sends a byte a
/// millisecond.
pub const ESCAPE_PATIENCE: Duration = Duration::from_millis(25);
/// The rest of an answer to a question is dropped if it comes no later than this. Nobody types its beginning so fast.
pub const ANSWER_PATIENCE: Duration = Duration::from_millis(100);
/// A paste whose end never comes is over after this much silence.
pub const PASTE_PATIENCE: Duration = Duration::from_secs(2);

/// An act of the user, or of the terminal on their behalf.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum TerminalInput {
    /// A key was pressed or repeats; releases are not reported. A capital letter carries `SHIFT`; Ctrl with a letter
    /// has the small letter; Shift-Tab is `BackTab`.
    Key(KeyEvent),
    /// A mouse button, the wheel, or a drag; the cell is counted from zero.
    Mouse(MouseEvent),
    /// Pasted text as it came, control characters included; at most [`PASTE_LIMIT`] bytes.
    Paste(String),
    /// The terminal has this size now.
    Resize {
        /// Cells in a row.
        columns: u16,
        /// Rows.
        rows: u16,
    },
    /// The terminal has answered that it shows pictures.
    Graphics,
    /// The screen was lost (the program was suspended): draw again.
    Redraw,
    /// Something to tell the user that no screen of the model caused: a paste cut short, a thread that panicked.
    Notice(String),
}

/// Decodes a stream of bytes. Feed it with [`feed`](Self::feed); call [`settle`](Self::settle) when nothing more
/// came for [`patience`](Self::patience).
#[derive(Debug, Default)]
pub struct Decoder {
    state: DecoderState,
    /// The bytes of the sequence under way, or of the paste.
    held: Vec<u8>,
    /// The sequence under way began with two escapes.
    alt: bool,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum DecoderState {
    #[default]
    Ground,
    /// In a character of this many bytes.
    Utf8(usize),
    Escape,
    /// After `ESC O`.
    SingleShift,
    /// After `ESC [`.
    Control,
    /// The three raw bytes after `ESC [ M`, an old mouse report.
    OldMouse,
    /// The one letter after `ESC [ [`, a function key of the Linux console.
    Console,
    /// In an answer to a question (`OSC`, `DCS`, `SOS`, `PM`, `APC`), dropped up to its end.
    Answer,
    /// After an `ESC` in an answer.
    AnswerEscape,
    Paste,
    /// In a paste beyond its limit.
    PasteOverflow,
}

/// No control sequence that means something here is longer.
const LONGEST_SEQUENCE: usize = 64;
const PASTE_END: &[u8] = b"\x1b[201~";

impl Decoder {
    /// Takes the next bytes and appends what they mean.
    pub fn feed(&mut self, bytes: &[u8], inputs: &mut Vec<TerminalInput>) {
        for &byte in bytes {
            self.step(byte, inputs);
        }
    }

    /// The time to wait for more bytes before [`settle`](Self::settle); `None` when nothing is half said.
    pub fn patience(&self) -> Option<Duration> {
        match self.state {
            DecoderState::Ground => None,
            DecoderState::Paste | DecoderState::PasteOverflow => Some(PASTE_PATIENCE),
            DecoderState::Control if !self.held.is_empty() => Some(ANSWER_PATIENCE),
            DecoderState::Answer if self.held.len() > 1 => Some(ANSWER_PATIENCE),
            _ => Some(ESCAPE_PATIENCE),
        }
    }

    /// Nothing more came: a lone `ESC` is the Escape key, an open paste ends, a broken sequence is forgotten.
    pub fn settle(&mut self, inputs: &mut Vec<TerminalInput>) {
        let escape = || key(KeyCode::Esc, KeyModifiers::NONE);
        match self.state {
            DecoderState::Escape if self.alt => inputs.extend([escape(), escape()]),
            DecoderState::Escape => inputs.push(escape()),
            // What looked like the start of a sequence was Alt with that letter.
            DecoderState::Control if self.held.is_empty() => {
                inputs.push(key(KeyCode::Char('['), KeyModifiers::ALT));
            }
            DecoderState::SingleShift => inputs.push(typed('O', KeyModifiers::ALT)),
            DecoderState::Answer if self.held.len() == 1 => {
                inputs.push(typed(self.held[0].into(), KeyModifiers::ALT));
            }
            DecoderState::Paste => self.end_paste(inputs),
            _ => {}
        }
        self.ground();
    }

    fn step(&mut self, byte: u8, inputs: &mut Vec<TerminalInput>) {
        match self.state {
            DecoderState::Ground => self.begin(byte, KeyModifiers::NONE, inputs),
            DecoderState::Utf8(length) => {
                if byte & 0xC0 == 0x80 {
                    self.held.push(byte);
                    if self.held.len() == length {
                        self.end_character(inputs);
                    }
                } else {
                    // The character was cut off; this byte begins something else.
                    self.ground();
                    self.begin(byte, KeyModifiers::NONE, inputs);
                }
            }
            DecoderState::Escape => self.after_escape(byte, inputs),
            DecoderState::SingleShift => self.end_single_shift(byte, inputs),
            DecoderState::Control => self.in_control(byte, inputs),
            DecoderState::OldMouse => {
                self.held.push(byte);
                if self.held.len() == 3 {
                    self.ground();
                }
            }
            DecoderState::Console => {
                if let b'A'..=b'E' = byte {
                    inputs.push(key(KeyCode::F(1 + byte - b'A'), KeyModifiers::NONE));
                }
                self.ground();
            }
            DecoderState::Answer => match byte {
                // BEL, ST as one byte, CAN, SUB
                0x07 | 0x9C | 0x18 | 0x1A => self.ground(),
                0x1B => self.state = DecoderState::AnswerEscape,
                _ if self.held.len() < 2 => self.held.push(byte),
                _ => {}
            },
            DecoderState::AnswerEscape => {
                // `ESC \` ends the answer; any other escape ends it too, and begins something else.
                self.ground();
                if byte != b'\\' {
                    self.state = DecoderState::Escape;
                    self.after_escape(byte, inputs);
                }
            }
            DecoderState::Paste => {
                self.held.push(byte);
                if self.held.ends_with(PASTE_END) {
                    self.held.truncate(self.held.len() - PASTE_END.len());
                    self.end_paste(inputs);
                    self.ground();
                } else if self.held.len() >= PASTE_LIMIT + PASTE_END.len() {
                    let tail = self.held.split_off(PASTE_LIMIT);
                    self.end_paste(inputs);
                    inputs.push(TerminalInput::Notice(format!(
                        "pasted text is longer than {} MiB: only its beginning was taken",
                        PASTE_LIMIT / (1024 * 1024)
                    )));
                    self.held = tail;
                    self.state = DecoderState::PasteOverflow;
                }
            }
            DecoderState::PasteOverflow => {
                self.held.push(byte);
                if self.held.ends_with(PASTE_END) {
                    self.ground();
                } else if self.held.len() > 2 * PASTE_END.len() {
                    self.held.drain(..PASTE_END.len());
                }
            }
        }
    }

    /// The first byte of a key.
    fn begin(&mut self, byte: u8, modifiers: KeyModifiers, inputs: &mut Vec<TerminalInput>) {
        let control = modifiers | KeyModifiers::CONTROL;
        let input = match byte {
            0x1B => {
                self.state = DecoderState::Escape;
                return;
            }
            0x00 => key(KeyCode::Char(' '), control),
            b'\r' => key(KeyCode::Enter, modifiers),
            b'\t' => key(KeyCode::Tab, modifiers),
            0x08 | 0x7F => key(KeyCode::Backspace, modifiers),
            0x01..=0x1A => key(KeyCode::Char(char::from(byte - 1 + b'a')), control),
            // Ctrl with \ ] ^ _
            0x1C..=0x1F => key(KeyCode::Char(char::from(byte + 0x40)), control),
            0x20..=0x7E => typed(byte.into(), modifiers),
            0xC2..=0xF4 => {
                self.alt = modifiers.contains(KeyModifiers::ALT);
                self.held.clear();
                self.held.push(byte);
                self.state = DecoderState::Utf8(if byte < 0xE0 { 2 } else { 3 + usize::from(byte >= 0xF0) });
                return;
            }
            // Not UTF-8.
            0x80..=0xC1 | 0xF5..=0xFF => return,
        };
        inputs.push(input);
    }

    fn end_character(&mut self, inputs: &mut Vec<TerminalInput>) {
        let modifiers = if self.alt { KeyModifiers::ALT } else { KeyModifiers::NONE };
        if let Some(character) = std::str::from_utf8(&self.held).ok().and_then(|text| text.chars().next())
            && !character.is_control()
        {
            inputs.push(typed(character, modifiers));
        }
        self.ground();
    }

    fn after_escape(&mut self, byte: u8, inputs: &mut Vec<TerminalInput>) {
        self.held.clear();
        match byte {
            b'[' => self.state = DecoderState::Control,
            b'O' => self.state = DecoderState::SingleShift,
            b']' | b'P' | b'X' | b'^' | b'_' => {
                self.held.push(byte);
                self.state = DecoderState::Answer;
            }
            // `ESC ESC [ A` is Alt with an arrow; a second lone escape is one more Escape key.
            0x1B if self.alt => inputs.push(key(KeyCode::Esc, KeyModifiers::NONE)),
            0x1B => self.alt = true,
            _ => {
                self.ground();
                self.begin(byte, KeyModifiers::ALT, inputs);
            }
        }
    }

    fn end_single_shift(&mut self, byte: u8, inputs: &mut Vec<TerminalInput>) {
        let modifiers = if self.alt { KeyModifiers::ALT } else { KeyModifiers::NONE };
        self.ground();
        let code = match byte {
            0x1B => {
                self.state = DecoderState::Escape;
                return;
            }
            b'M' => KeyCode::Enter,
            // The keypad in application mode: * + , - . / 0 … 9
            b'j'..=b'y' => KeyCode::Char(char::from(byte - 0x40)),
            _ => match letter_key(byte) {
                Some(code) => code,
                None => return,
            },
        };
        inputs.push(key(code, modifiers));
    }

    fn in_control(&mut self, byte: u8, inputs: &mut Vec<TerminalInput>) {
        match byte {
            b'[' if self.held.is_empty() => self.state = DecoderState::Console,
            b'M' if self.held.is_empty() => self.state = DecoderState::OldMouse,
            b'~' if self.held == b"200" => {
                self.held.clear();
                self.state = DecoderState::Paste;
            }
            0x40..=0x7E => {
                let parameters = std::mem::take(&mut self.held);
                inputs.extend(control_sequence(&parameters, byte, self.alt));
                self.ground();
            }
            0x20..=0x3F if self.held.len() < LONGEST_SEQUENCE => self.held.push(byte),
            // Longer than anything meant for us: keep dropping up to the final byte.
            0x20..=0x3F => {}
            0x1B => {
                self.ground();
                self.state = DecoderState::Escape;
            }
            _ => self.ground(),
        }
    }

    fn end_paste(&mut self, inputs: &mut Vec<TerminalInput>) {
        let text = String::from_utf8_lossy(&self.held);
        if !text.is_empty() {
            inputs.push(TerminalInput::Paste(text.into_owned()));
        }
        self.held = Vec::new();
    }

    fn ground(&mut self) {
        self.state = DecoderState::Ground;
        self.alt = false;
        self.held.clear();
    }
}

/// A `CSI` sequence: its parameter bytes and its final byte.
fn control_sequence(parameters: &[u8], last: u8, alt: bool) -> Option<TerminalInput> {
    if let Some(report) = parameters.strip_prefix(b"<") {
        return mouse(report, last);
    }
    let mut numbers = parameters.split(|&byte| byte == b';');
    let first = number(numbers.next()?)?;
    // Kitty's protocol writes `modifiers:kind`, with 3 for a release.
    let mut second = numbers.next().unwrap_or_default().split(|&byte| byte == b':');
    let state = number(second.next()?)?.max(1) - 1;
    if second.next() == Some(b"3") {
        return None;
    }
    let mut modifiers = modifiers(state);
    modifiers.set(KeyModifiers::ALT, modifiers.contains(KeyModifiers::ALT) || alt);
    let code = match last {
        b'Z' => return Some(key(KeyCode::BackTab, modifiers | KeyModifiers::SHIFT)),
        // F3 with a modifier; with none it is an answer about the cursor.
        b'R' if first != 1 || state == 0 => return None,
        b'~' if first == 27 => return codepoint(number(numbers.next()?)?, modifiers),
        b'u' => return codepoint(first, modifiers),
        b'~' => match first {
            1 | 7 => KeyCode::Home,
            2 => KeyCode::Insert,
            3 => KeyCode::Delete,
            4 | 8 => KeyCode::End,
            5 => KeyCode::PageUp,
            6 => KeyCode::PageDown,
            11..=15 => KeyCode::F(first as u8 - 10),
            17..=21 => KeyCode::F(first as u8 - 11),
            23..=26 => KeyCode::F(first as u8 - 12),
            28 | 29 => KeyCode::F(first as u8 - 13),
            31..=34 => KeyCode::F(first as u8 - 14),
            _ => return None,
        },
        _ if first <= 1 => letter_key(last)?,
        _ => return None,
    };
    Some(key(code, modifiers))
}

/// The keys that `CSI` and `SS3` name by one letter.
fn letter_key(letter: u8) -> Option<KeyCode> {
    Some(match letter {
        b'A' => KeyCode::Up,
        b'B' => KeyCode::Down,
        b'C' => KeyCode::Right,
        b'D' => KeyCode::Left,
        b'H' => KeyCode::Home,
        b'F' => KeyCode::End,
        b'P'..=b'S' => KeyCode::F(1 + letter - b'P'),
        _ => return None,
    })
}

/// A key named by its character (modifyOtherKeys, `CSI … u`).
fn codepoint(code: u32, modifiers: KeyModifiers) -> Option<TerminalInput> {
    Some(match code {
        9 if modifiers.contains(KeyModifiers::SHIFT) => key(KeyCode::BackTab, modifiers),
        9 => key(KeyCode::Tab, modifiers),
        13 => key(KeyCode::Enter, modifiers),
        27 => key(KeyCode::Esc, modifiers),
        8 | 127 => key(KeyCode::Backspace, modifiers),
        // Kitty's private numbers for keys without a character.
        0xE000..=0xF8FF => return None,
        _ => match char::from_u32(code) {
            Some(character) if !character.is_control() => typed(character, modifiers),
            _ => return None,
        },
    })
}

/// An SGR report, `CSI < button ; column ; row M`, or `m` for a release. Cells count from one.
fn mouse(report: &[u8], last: u8) -> Option<TerminalInput> {
    let mut numbers = report.split(|&byte| byte == b';').map(number);
    let (button, column, row) = (numbers.next()??, numbers.next()??, numbers.next()??);
    let which = match button & 3 {
        0 => MouseButton::Left,
        1 => MouseButton::Middle,
        _ => MouseButton::Right,
    };
    let (wheel, motion) = (button & 64 != 0, button & 32 != 0);
    let kind = match (last, wheel, motion, button & 3) {
        (b'M', true, _, 0) => MouseEventKind::ScrollUp,
        (b'M', true, _, 1) => MouseEventKind::ScrollDown,
        (b'M', true, _, 2) => MouseEventKind::ScrollLeft,
        (b'M', true, _, _) => MouseEventKind::ScrollRight,
        (b'M', false, true, 3) => MouseEventKind::Moved,
        (b'M', false, true, _) => MouseEventKind::Drag(which),
        (b'M', false, false, 0..=2) => MouseEventKind::Down(which),
        (b'm', false, false, 0..=2) => MouseEventKind::Up(which),
        _ => return None,
    };
    Some(TerminalInput::Mouse(MouseEvent {
        kind,
        column: u16::try_from(column.saturating_sub(1)).ok()?,
        row: u16::try_from(row.saturating_sub(1)).ok()?,
        modifiers: modifiers(button >> 2 & 7),
    }))
}

/// Bits 1 Shift, 2 Alt, 4 Ctrl, the order xterm uses for keys and, from bit 2 on, for the mouse.
fn modifiers(bits: u32) -> KeyModifiers {
    let mut modifiers = KeyModifiers::NONE;
    modifiers.set(KeyModifiers::SHIFT, bits & 1 != 0);
    modifiers.set(KeyModifiers::ALT, bits & 2 != 0);
    modifiers.set(KeyModifiers::CONTROL, bits & 4 != 0);
    modifiers
}

/// A parameter; an empty one is zero, one that is no number or too large makes the sequence meaningless.
fn number(digits: &[u8]) -> Option<u32> {
    digits.iter().try_fold(0_u32, |value, &byte| {
        byte.is_ascii_digit().then_some(())?;
        value.checked_mul(10)?.checked_add(u32::from(byte - b'0'))
    })
}

fn typed(character: char, mut modifiers: KeyModifiers) -> TerminalInput {
    modifiers.set(KeyModifiers::SHIFT, character.is_uppercase());
    key(KeyCode::Char(character), modifiers)
}

fn key(code: KeyCode, modifiers: KeyModifiers) -> TerminalInput {
    TerminalInput::Key(KeyEvent::new(code, modifiers))
}
