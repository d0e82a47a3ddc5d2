//! Answers of a terminal to the question whether it shows pictures.
//!
//! Sources: Kitty's *Terminal graphics protocol*, "Querying support and available transmission mediums"; *XTerm Control
//! Sequences*, "Send Device Attributes (Primary DA)", "Request XTVERSION", "Window manipulation", "Operating System
//! Commands".

use super::{Graphics, Protocol, TerminalColors};

/// The question: a picture of one pixel for Kitty's protocol, the name of the terminal, the size of a cell, the colours of
/// text, ground and the sixteen, and the device attributes, which every terminal answers and which come last.
pub const QUERY: &str = "\x1b_Gi=31,s=1,v=1,a=q,t=d,f=24;AAAA\x1b\\\x1b[>q\x1b[16t\x1b]10;?\x1b\\\x1b]11;?\x1b\\\
     \x1b]4;0;?;1;?;2;?;3;?;4;?;5;?;6;?;7;?;8;?;9;?;10;?;11;?;12;?;13;?;14;?;15;?\x1b\\\x1b[c";

/// The answers.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Answers {
    /// The first of the protocols that the terminal knows.
    pub protocol: Option<Protocol>,
    /// Pixels across a cell and down a cell.
    pub cell: Option<(u16, u16)>,
    /// Colours.
    pub colors: TerminalColors,
    /// The device attributes came: there is nothing more to wait for.
    pub complete: bool,
}

impl Answers {
    /// Answers among the bytes of a terminal; what is none is passed over.
    pub fn of(bytes: &[u8]) -> Self {
        let mut answers = Self::default();
        let mut rest = bytes;
        while let Some(at) = rest.iter().position(|byte| *byte == 0x1B) {
            rest = &rest[at + 1..];
            let Some((kind, inside)) = rest.split_first() else { break };
            match kind {
                b'[' => {
                    let Some(end) = inside.iter().position(|byte| (0x40..=0x7E).contains(byte)) else {
                        break;
                    };
                    answers.control(&inside[..end], inside[end]);
                    rest = &inside[end + 1..];
                }
                b'_' | b'P' | b']' => {
                    let Some(end) = inside.iter().position(|byte| [0x07, 0x1B].contains(byte)) else { break };
                    answers.string(*kind, &String::from_utf8_lossy(&inside[..end]));
                    rest = &inside[end..];
                }
                _ => {}
            }
        }
        answers
    }

    /// Means of a terminal with these answers to show pictures. `cell` is the size that the system reports, which is newer
    /// than the answer.
    pub fn graphics(self, cell: Option<(u16, u16)>) -> Option<Graphics> {
        Some(Graphics { protocol: self.protocol?, cell: cell.or(self.cell)?, colors: self.colors })
    }

    fn control(&mut self, parameters: &[u8], last: u8) {
        let parameters = String::from_utf8_lossy(parameters);
        match last {
            b'c' if parameters.starts_with('?') => {
                self.complete = true;
                self.knows(Protocol::Sixel, parameters.split(';').skip(1).any(|attribute| attribute == "4"));
            }
            b't' => {
                let numbers: Vec<u16> = parameters.split(';').filter_map(|text| text.parse().ok()).collect();
                if let [6, height, width] = numbers[..]
                    && is_sane((width, height))
                {
                    self.cell = Some((width, height));
                }
            }
            _ => {}
        }
    }

    /// Notes that the terminal knows a protocol, if it does.
    fn knows(&mut self, protocol: Protocol, known: bool) {
        self.protocol = self.protocol.into_iter().chain(known.then_some(protocol)).min();
    }

    fn string(&mut self, kind: u8, text: &str) {
        match kind {
            b'_' => self.knows(Protocol::Kitty, text.starts_with("Gi=31") && text.ends_with(";OK")),
            b'P' => {
                let is_known = [">|iTerm2", ">|WezTerm"].iter().any(|name| text.starts_with(name));
                self.knows(Protocol::Iterm2, is_known);
            }
            _ => {
                let mut parts = text.split(';');
                let (first, second) = (parts.next(), parts.next().unwrap_or_default());
                match first {
                    Some("10") => self.colors.foreground = color(second),
                    Some("11") => self.colors.background = color(second),
                    Some("4") => {
                        let slot = second.parse().ok().and_then(|n: usize| self.colors.sixteen.get_mut(n));
                        if let (Some(slot), Some(third)) = (slot, parts.next()) {
                            *slot = color(third);
                        }
                    }
                    _ => {}
                }
            }
        }
    }
}

/// True for a size that a cell can have.
pub(crate) fn is_sane((width, height): (u16, u16)) -> bool {
    (4..=128).contains(&width) && (6..=256).contains(&height)
}

/// `rgb:1e1e/1e1e/1e1e`, with one to four digits each.
fn color(text: &str) -> Option<[u8; 3]> {
    let mut parts = text.strip_prefix("rgb:")?.split('/').map(|part| {
        let most = (1u32 << (4 * part.len())).checked_sub(1).filter(|most| (1..=0xFFFF).contains(most))?;
        Some((u32::from_str_radix(part, 16).ok()? * 255 / most) as u8)
    });
    Some([parts.next()??, parts.next()??, parts.next()??])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn terminals_are_known_by_their_answers() {
        let kitty = Answers::of(
            b"\x1b_Gi=31;OK\x1b\\\x1bP>|kitty(0.36.4)\x1b\\\x1b[6;20;10t\x1b]11;rgb:1e1e/20/f\x07\x1b]4;1;rgb:cccc/0/0\x1b\\\x1b[?62;c",
        );
        assert_eq!(
            (kitty.protocol, kitty.complete, kitty.cell),
            (Some(Protocol::Kitty), true, Some((10, 20)))
        );
        assert_eq!(kitty.colors.background, Some([0x1e, 0x20, 0xff]));
        assert_eq!(kitty.colors.sixteen[1], Some([0xcc, 0, 0]));
        let protocol = |bytes: &[u8]| Answers::of(bytes).graphics(Some((8, 16))).map(|found| found.protocol);
        assert_eq!(protocol(b"\x1b_Gi=31;OK\x1b\\\x1b[?62;4c"), Some(Protocol::Kitty));
        // xterm as a VT340, and two that know others too: WezTerm and iTerm2.
        assert_eq!(protocol(b"\x1bP>|XTerm(388)\x1b\\\x1b[?63;1;2;4;6;9;15;22c"), Some(Protocol::Sixel));
        assert_eq!(
            protocol(b"\x1b_Gi=31;OK\x1b\\\x1bP>|WezTerm 20240203-110809-5046fc22\x1b\\\x1b[?65;4;6;18;22c"),
            Some(Protocol::Iterm2)
        );
        assert_eq!(
            protocol(b"\x1bP>|iTerm2 3.5.0\x1b\\\x1b[?64;1;2;4;6;17;18;21;22c"),
            Some(Protocol::Iterm2)
        );
        // A VT100, a terminal that knows the protocol but not this medium, and one that says nothing.
        assert_eq!(protocol(b"\x1b[?1;2c"), None);
        assert_eq!(protocol(b"\x1b_Gi=31;ENOENT:no such medium\x1b\\\x1b[?62;22c"), None);
        assert_eq!(protocol(b""), None);
    }

    #[test]
    fn keys_and_broken_answers_are_passed_over() {
        let typed = Answers::of(b"q\x1b[A\x1bx\x1b_Gi=31;OK\x1b\\\x1b\x1b[?62;4;22c");
        assert_eq!((typed.protocol, typed.complete), (Some(Protocol::Kitty), true));
        let whole = b"\x1b_Gi=31;OK\x1b\\\x1b]11;rgb:0/0/0\x07\x1b[6;20;10t\x1b[?62;4c";
        for cut in 0..whole.len() - 1 {
            assert!(!Answers::of(&whole[..cut]).complete, "{cut}");
        }
        // A size that no cell has is none.
        assert_eq!(Answers::of(b"\x1b[6;0;0t\x1b[?62;4c").graphics(None), None);
        assert_eq!(color("rgb:12345/0/0"), None);
        assert_eq!(color("rgb:/0/0"), None);
    }
}
