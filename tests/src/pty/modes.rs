//! The modes of the line and of the screen, and what a program leaves of them.

use std::{
    collections::BTreeMap,
    thread,
    time::{Duration, Instant},
};

use rustix::termios::{Termios, tcgetattr};

use super::Pty;

const SOON: Duration = Duration::from_secs(2);

/// State of the terminal before the program.
pub(super) struct Before {
    pub(super) termios: Termios,
    pub(super) modes: Vec<String>,
}

impl Pty {
    /// State that the program left changed: modes of the line, of the screen, of the mouse; empty if it restored all. A
    /// shell that has the terminal again sets its own modes a moment later, and has 2 s for it.
    pub fn leftovers(&self) -> Vec<String> {
        let end = Instant::now() + SOON;
        loop {
            let left = self.changed();
            if left.is_empty() || Instant::now() > end {
                return left;
            }
            thread::sleep(Duration::from_millis(5));
        }
    }

    /// Differences from the state before the program.
    fn changed(&self) -> Vec<String> {
        let now = self.termios();
        let was = &self.before.termios;
        let mut left = self.modes();
        left.retain(|mode| !self.before.modes.contains(mode));
        for (name, now, was) in [
            ("input modes", now.input_modes.bits(), was.input_modes.bits()),
            ("output modes", now.output_modes.bits(), was.output_modes.bits()),
            ("control modes", now.control_modes.bits(), was.control_modes.bits()),
            ("local modes", now.local_modes.bits(), was.local_modes.bits()),
        ] {
            if now != was {
                left.push(format!("{name}: {was:#x} became {now:#x}"));
            }
        }
        left
    }

    /// The private modes (`CSI ? … h`) that are on, and the cursor if it is hidden.
    pub(super) fn modes(&self) -> Vec<String> {
        let modes = private_modes(&self.seen.output().raw);
        let on = modes.into_iter().filter_map(|(mode, on)| match mode {
            25 => (!on).then(|| "hidden cursor".to_owned()),
            _ => on.then(|| format!("mode {mode}")),
        });
        on.collect()
    }

    pub(super) fn termios(&self) -> Termios {
        tcgetattr(&self.line).expect("the line has modes")
    }
}

/// The last word on every private mode in a stream of bytes.
fn private_modes(raw: &[u8]) -> BTreeMap<u16, bool> {
    let mut modes = BTreeMap::new();
    for part in String::from_utf8_lossy(raw).split("\x1b[?").skip(1) {
        let end = part.find(|c: char| !c.is_ascii_digit() && c != ';').unwrap_or(part.len());
        let on = match part[end..].chars().next() {
            Some('h') => true,
            Some('l') => false,
            _ => continue,
        };
        modes.extend(part[..end].split(';').filter_map(|mode| Some((mode.parse().ok()?, on))));
    }
    modes
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pty::Launch;

    #[test]
    fn the_last_word_on_a_mode_counts() {
        let modes = private_modes(b"\x1b[?1049h\x1b[?25l text \x1b[?1000;1006h\x1b[?1049l\x1b[?2026$p");
        assert_eq!(
            modes.into_iter().collect::<Vec<_>>(),
            [(25, false), (1000, true), (1006, true), (1049, false)]
        );
    }

    #[test]
    fn a_program_that_leaves_modes_on_is_found_out() {
        let mut pty =
            Launch::new("unused").in_script("printf '\\033[?1049h\\033[?25l'; stty -echo; exit 3").start();
        assert_eq!(pty.exit_code(), Some(3));
        let left = pty.leftovers();
        assert_eq!(left.len(), 3, "{left:?}");
        assert!(
            left[0] == "hidden cursor" && left[1] == "mode 1049" && left[2].starts_with("local modes"),
            "{left:?}"
        );
    }
}
