//! Pictures in pixels, at terminals that answer whether they show them.

use std::{collections::BTreeMap, time::Duration};

use base64::{Engine, engine::general_purpose::STANDARD};
use dalembert_tests::pty::{self, KITTY, Launch, Pty};
use miniz_oxide::inflate::decompress_to_vec_zlib;

/// The answers of foot.
const FOOT: &[u8] = b"\x1bP>|foot(1.16.2)\x1b\\\x1b[6;20;10t\x1b]11;rgb:2424/2424/2424\x1b\\\x1b[?62;4;22c";
const FAN: &str = "vibration/rotating-unbalance";

/// A picture that was sent to Kitty: its cells, and its pixels with their size.
struct Sent {
    cells: (usize, usize),
    size: (usize, usize),
    pixels: Vec<u8>,
}

/// The program with an analysis in front, 40 rows of 140 columns, at a terminal that answers at once.
fn at(answer: &[u8], analysis: &str) -> Pty {
    let launch = Launch::new(pty::program()).argument(analysis).size(40, 140);
    let pty = launch.answering(Duration::ZERO, answer).start();
    pty.expect("dalembert");
    pty.idle(Duration::from_millis(400));
    pty
}

/// The values of control data such as `a=T,f=100`.
fn control(text: &str) -> BTreeMap<&str, &str> {
    text.split(',').filter_map(|pair| pair.split_once('=')).collect()
}

/// The commands of Kitty's protocol: control data and payload, its parts joined.
fn commands(raw: &[u8]) -> Vec<(String, String)> {
    let raw = String::from_utf8_lossy(raw);
    let mut commands: Vec<(String, String)> = Vec::new();
    for command in raw.split("\x1b_G").skip(1) {
        let command = command.split("\x1b\\").next().unwrap_or_default();
        let (data, payload) = command.split_once(';').unwrap_or((command, ""));
        match commands.last_mut() {
            Some((_, before)) if data.starts_with("m=") => *before += payload,
            _ => commands.push((data.to_owned(), payload.to_owned())),
        }
    }
    commands.retain(|(data, _)| !data.contains("a=q"));
    commands
}

/// The pictures among them.
fn pictures(raw: &[u8]) -> Vec<Sent> {
    let sent = commands(raw).into_iter().filter(|(data, _)| data.contains("a=T"));
    sent.map(|(data, payload)| {
        let values = control(&data);
        assert_eq!(values["f"], "100", "{data}");
        let number = |key: &str| values[key].parse().expect("a number");
        let png = STANDARD.decode(payload).expect("base64");
        assert_eq!(&png[..8], b"\x89PNG\r\n\x1a\n");
        let of = |at: usize| u32::from_be_bytes(png[at..at + 4].try_into().expect("four bytes")) as usize;
        let (size, mut at, mut data) = ((of(16), of(20)), 8, Vec::new());
        while at < png.len() {
            if &png[at + 4..at + 8] == b"IDAT" {
                data.extend_from_slice(&png[at + 8..at + 8 + of(at)]);
            }
            at += of(at) + 12;
        }
        let pixels = decompress_to_vec_zlib(&data).expect("zlib");
        assert_eq!(pixels.len(), size.1 * (size.0 + 1));
        Sent { cells: (number("c"), number("r")), size, pixels }
    })
    .collect()
}

fn has_braille(screen: &str) -> bool {
    screen.chars().any(|letter| ('\u{2801}'..='\u{28FF}').contains(&letter))
}

/// True if no cell holds what an answer is made of.
fn is_clean(screen: &str) -> bool {
    !["Gi=31", "rgb:", "kitty(", ";20;10t", "62;"].iter().any(|part| screen.contains(part))
}

#[test]
fn a_terminal_like_kitty_shows_every_problem_as_a_picture_of_its_own() {
    let mut seen: Vec<Vec<u8>> = Vec::new();
    for analysis in [FAN, "vibration/free-vibration", "virtual-work/four-bar"] {
        let pty = at(KITTY, analysis);
        let sent = pictures(&pty.raw());
        assert!(!sent.is_empty(), "{analysis}:\n{}", pty.screen());
        for Sent { cells, size, pixels } in &sent {
            assert_eq!(*size, (10 * cells.0, 20 * cells.1), "{analysis}");
            assert!(pixels.iter().filter(|pixel| **pixel > 0).count() > 200, "{analysis}: a blank picture");
            assert!(!seen.contains(pixels), "{analysis}: the picture of another problem");
        }
        assert!(!has_braille(&pty.screen()) && is_clean(&pty.screen()), "{analysis}:\n{}", pty.screen());
        seen.extend(sent.into_iter().map(|sent| sent.pixels));
    }
}

#[test]
fn a_picture_is_sent_when_it_changes_and_hidden_without_that() {
    let mut pty = at(KITTY, FAN);
    pty.types(":plot<enter>");
    pty.idle(Duration::from_millis(300));
    // The plot has its cursor, and its readout.
    pty.types("<right>");
    pty.idle(Duration::from_millis(300));
    let before = pty.count();
    pty.types("<right>");
    pty.idle(Duration::from_millis(300));
    let sent = pictures(&pty.since(before));
    assert!(!sent.is_empty() && sent.iter().all(|sent| sent.cells.0 <= 3), "a cursor that moves is a strip");
    assert!(pty.since(before).len() < 3000, "{} bytes for a cursor", pty.since(before).len());
    let before = pty.count();
    pty.types("?");
    pty.expect("Keyboard shortcuts");
    pty.idle(Duration::from_millis(300));
    let deleted = commands(&pty.since(before)).iter().filter(|(data, _)| data.contains("a=d")).count();
    assert!(deleted > 0 && pictures(&pty.since(before)).is_empty());
    let before = pty.count();
    pty.types("<esc>");
    pty.idle(Duration::from_millis(300));
    let since = commands(&pty.since(before));
    assert!(since.iter().any(|(data, _)| data.contains("a=p")), "{since:?}");
    assert!(pictures(&pty.since(before)).is_empty(), "what the terminal keeps was sent again");
    // The end takes everything away, before the screen of the shell comes back.
    let before = pty.count();
    pty.types("<c-c>");
    assert_eq!((pty.exit_code(), pty.leftovers()), (Some(0), vec![]));
    let last = String::from_utf8_lossy(&pty.since(before)).into_owned();
    let (deleted, left) =
        (last.find("a=d,q=2,d=A").expect("deleted"), last.find("\x1b[?1049l").expect("left"));
    assert!(deleted < left);
}

#[test]
fn a_terminal_with_sixel_gets_sixel() {
    let pty = at(FOOT, "vibration/free-vibration");
    let raw = String::from_utf8_lossy(&pty.raw()).into_owned();
    let mut sizes = raw.split("q\"1;1;").skip(1).map(|rest| {
        let mut numbers = rest.split(['#', ';']).map(|number| number.parse::<usize>().expect("a number"));
        (numbers.next().expect("a width"), numbers.next().expect("a height"))
    });
    let (width, height) = sizes.next().expect("a picture");
    assert!(width % 10 == 0 && height % 20 == 0 && width > 300 && height > 100, "{width}×{height}");
    assert!(!raw.contains("\x1b_Ga=T") && !has_braille(&pty.screen()), "{}", pty.screen());
}

#[test]
fn a_terminal_that_answers_too_late_or_never_gets_braille_at_once() {
    for answer in [Some(Duration::from_millis(700)), None] {
        let launch = Launch::new(pty::program()).argument("vibration/free-vibration").size(40, 140);
        let pty = answer.map_or(launch.clone(), |after| launch.answering(after, KITTY)).start();
        pty.expect("dalembert");
        pty.idle(Duration::from_millis(900));
        let raw = pty.raw();
        let asked = raw.windows(3).position(|bytes| bytes == b"\x1b[c").expect("it asks") + 3;
        let drawn = raw.windows(8).position(|bytes| bytes == b"\x1b[?2026l").expect("it draws") + 8;
        let waited = pty.arrival(drawn).zip(pty.arrival(asked)).map(|(drawn, asked)| drawn - asked);
        // Nothing waits for an answer; a machine that is busy with a build takes its time.
        assert!(waited.is_some_and(|waited| waited < Duration::from_millis(500)), "{waited:?}");
        assert!(has_braille(&pty.screen()) && is_clean(&pty.screen()), "{}", pty.screen());
        assert_eq!(commands(&raw), [], "{answer:?}");
    }
}

#[test]
fn nothing_is_asked_over_ssh_in_ascii_or_where_pixels_are_off() {
    let asks = |launch: Launch| {
        let pty = launch.answering(Duration::ZERO, KITTY).start();
        pty.expect("dalembert");
        pty.idle(Duration::from_millis(300));
        (pty.raw().windows(4).any(|bytes| bytes == b"a=q,"), pictures(&pty.raw()).len())
    };
    let launch = || Launch::new(pty::program()).argument("vibration/free-vibration").size(40, 140);
    assert_eq!(asks(launch().env("SSH_CONNECTION", "192.0.2.1 50000 192.0.2.2 22")), (false, 0));
    assert_eq!(asks(launch().argument("--basic")), (false, 0));
    assert_eq!(asks(launch().env("LANG", "C")), (false, 0));
    let with = |setting: &str, launch: Launch| {
        let folder = tempfile::tempdir().expect("a folder");
        std::fs::create_dir(folder.path().join("dalembert")).expect("a folder");
        std::fs::write(folder.path().join("dalembert/settings.toml"), setting).expect("written");
        asks(launch.env("XDG_CONFIG_HOME", folder.path().to_str().expect("a readable path")))
    };
    assert_eq!(with("pixels = false\n", launch()), (false, 0));
    let (asked, pictures) = with("pixels = true\n", launch().env("SSH_TTY", "/dev/pts/1"));
    assert!(asked && pictures > 0, "{pictures} pictures where they were asked for");
}
