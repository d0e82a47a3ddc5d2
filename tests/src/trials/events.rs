//! Keys, mouse, pastes and sizes at random, and terminals of every kind, before the workbench in this process.

use std::{
    fs,
    panic::{AssertUnwindSafe, catch_unwind},
};

use dalembert_core::{Language, registry};
use dalembert_tui::{
    Msg,
    glyphs::{Capabilities, Colors, Environment, Glyphs},
    harness::Harness,
};
use itertools::iproduct;
use ratatui::{
    crossterm::event::{KeyCode, KeyEvent, KeyModifiers},
    style::Color,
};

use super::{Outcome, Random};

const WIDEST: u16 = 160;
const HIGHEST: u16 = 60;
/// Events between two frames.
const A_FRAME: u64 = 8;
/// Growth of the resident set over the second half, as a share, that is no leak.
const FLAT: f64 = 0.2;

fn workbench(size: (u16, u16)) -> Harness {
    Harness::new(registry(), size, Language::English, Capabilities::default())
}

/// Sends so many random events to one workbench after the other in one process: no panic, and memory stays flat.
pub(super) fn random(times: u64, seed: u64) -> Outcome {
    let mut outcome = Outcome { tried: times, ..Outcome::default() };
    let (mut bench, mut opened, mut half) = (workbench((80, 24)), 0_u64, 0);
    let mut random = Random::new(seed, 0);
    for event in 0..times {
        if event == times / 2 {
            half = resident_set();
        }
        // A session of some hundred events, then another problem.
        if event % 500 == 0 || bench.has_quit {
            opened += 1;
            bench = workbench((80, 24));
            let entry = random.one(registry());
            bench.begins(None, Some(entry));
        }
        let msg = message(&mut random);
        let shown = format!("{msg:?}");
        let done = catch_unwind(AssertUnwindSafe(|| {
            match msg {
                Msg::Resize(columns, rows) => bench.resizes(columns, rows),
                msg => bench.happens(msg),
            }
            if event % A_FRAME == 0 {
                bench.draws();
            }
        }));
        if done.is_err() {
            outcome.failures.push(format!("seed {seed}, event {event}: {shown} panics"));
            bench = workbench((80, 24));
        }
    }
    let end = resident_set();
    let growth = end as f64 / half.max(1) as f64 - 1.0;
    if times >= 100_000 && growth > FLAT {
        outcome.failures.push(format!("memory grows by {:.0} % over the second half", 100.0 * growth));
    }
    outcome.note = format!(
        "{opened} sessions; resident set {} MiB at half time, {} MiB in the end",
        half >> 20,
        end >> 20
    );
    outcome
}

fn message(random: &mut Random) -> Msg {
    let key = |code, modifiers| Msg::Key(KeyEvent::new(code, modifiers));
    let keys = [
        KeyCode::Enter,
        KeyCode::Esc,
        KeyCode::Tab,
        KeyCode::BackTab,
        KeyCode::Up,
        KeyCode::Down,
        KeyCode::Left,
        KeyCode::Right,
        KeyCode::PageUp,
        KeyCode::PageDown,
        KeyCode::Home,
        KeyCode::End,
        KeyCode::Delete,
        KeyCode::Backspace,
        KeyCode::F(1),
        KeyCode::F(5),
    ];
    match random.below(100) {
        0 => Msg::Resize(1 + random.below(250) as u16, 1 + random.below(80) as u16),
        1 => {
            Msg::Paste((random.one(&["1 mm", "\u{1b}[31m\u{202e}", "1\n2\n3", "a\tb", "漢字 🦀"])).to_owned())
        }
        2..=45 => key(random.one(&keys), KeyModifiers::NONE),
        46..=52 => key(KeyCode::Char((b'a' + random.below(26) as u8).into()), KeyModifiers::CONTROL),
        53..=57 => key(KeyCode::Char((b'0' + random.below(10) as u8).into()), KeyModifiers::ALT),
        _ => key(KeyCode::Char((b' ' + random.below(95) as u8).into()), KeyModifiers::NONE),
    }
}

/// Bytes of memory that this process has; 0 where the system has no `/proc`.
fn resident_set() -> u64 {
    const PAGE: u64 = 4096;
    let pages = fs::read_to_string("/proc/self/statm").ok();
    pages.and_then(|text| text.split_whitespace().nth(1)?.parse::<u64>().ok()).map_or(0, |pages| PAGE * pages)
}

/// Draws the list, a problem and its help in every size from 1×1 to 160×60, `times` of them.
pub(super) fn sizes(times: u64, seed: u64) -> Outcome {
    let mut outcome = Outcome::default();
    let mut random = Random::new(seed, 0);
    let screens = 3;
    let mut benches: Vec<Harness> = (0..screens).map(|_| workbench((80, 24))).collect();
    for bench in &mut benches[1..] {
        bench.begins(None, Some(random.one(registry())));
    }
    benches[2].happens(Msg::Key(KeyEvent::new(KeyCode::Char('?'), KeyModifiers::NONE)));
    let all = u64::from(WIDEST) * u64::from(HIGHEST) * screens;
    // A step that shares no factor with the number of sizes meets each of them once.
    for n in 0..times.min(all) {
        let at = n * 7919 % all;
        let (screen, size) = (at % screens, at / screens);
        let (columns, rows) = (1 + (size % u64::from(WIDEST)) as u16, 1 + (size / u64::from(WIDEST)) as u16);
        outcome.tried += 1;
        let bench = &mut benches[screen as usize];
        let drawn = catch_unwind(AssertUnwindSafe(|| {
            bench.resizes(columns, rows);
            let area = bench.draws().area;
            (area.width, area.height)
        }));
        match drawn {
            Ok(size) if size == (columns, rows) => {}
            Ok(size) => {
                outcome.failures.push(format!("{columns}×{rows}, screen {screen}: {size:?} are drawn"));
            }
            Err(_) => outcome.failures.push(format!("{columns}×{rows}, screen {screen}: panics")),
        }
    }
    outcome
}

/// Draws a problem on terminals of every `TERM`, locale and word about colours, `times` of them: only characters and
/// colours that the terminal has.
pub(super) fn terminals(times: u64, _seed: u64) -> Outcome {
    let terms = [
        "xterm",
        "xterm-256color",
        "xterm-kitty",
        "screen",
        "screen-256color",
        "tmux",
        "tmux-256color",
        "linux",
        "vt100",
        "vt220",
        "ansi",
        "rxvt",
        "rxvt-unicode-256color",
        "alacritty",
        "foot",
        "wezterm",
        "putty",
        "st-256color",
        "cygwin",
        "unknown",
        "",
    ];
    let locales =
        ["C", "POSIX", "C.UTF-8", "en_US.UTF-8", "pt_BR.UTF-8", "pt_BR.ISO-8859-1", "ja_JP.eucJP", ""];
    let colours = [None, Some("truecolor"), Some("24bit"), Some("")];
    let words = [None, Some("1"), Some("")];
    let mut outcome = Outcome::default();
    let owned = |text: &str| Some(text.to_owned());
    let all = iproduct!(terms, locales, colours, words).collect::<Vec<_>>();
    for n in 0..(times as usize).min(all.len()) {
        let (term, lang, colorterm, no_color) = all[n * 7919 % all.len()];
        let environment = Environment {
            term: owned(term),
            colorterm: colorterm.and_then(owned),
            no_color: no_color.and_then(owned),
            lc_all: None,
            lc_ctype: None,
            lang: owned(lang),
        };
        outcome.tried += 1;
        let capabilities = Capabilities::detect(&environment);
        let mut bench = Harness::new(registry(), (100, 30), Language::English, capabilities);
        bench.begins(None, Some(registry()[n % registry().len()]));
        let cells = &bench.draws().content;
        let foreign = |symbol: &str| capabilities.glyphs == Glyphs::Ascii && !symbol.is_ascii();
        if let Some(cell) = cells.iter().find(|cell| foreign(cell.symbol())) {
            outcome.failures.push(format!("TERM={term} LANG={lang}: draws {:?}", cell.symbol()));
        }
        let coloured = |cell: &ratatui::buffer::Cell| cell.fg != Color::Reset || cell.bg != Color::Reset;
        if capabilities.colors == Colors::None && cells.iter().any(coloured) {
            outcome.failures.push(format!("TERM={term} NO_COLOR={no_color:?}: draws in colour"));
        }
    }
    outcome
}
