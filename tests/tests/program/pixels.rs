//! Pictures in pixels, at terminals that answer whether they show them.

use std::time::Duration;

use dalembert_tests::{
    pictures::{Protocol, SentPicture, kitty_commands, pictures},
    pty::{self, KITTY, Launch, Pty, Signal},
};

/// The answers of foot.
const FOOT: &[u8] =
    b"\x1bP>|foot(1.16.2)\x1b\\\x1b[6;20;10t\x1b]11;rgb:2424/2424/2424\x1b\\\x1b]4;6;rgb:0d0d/cdcd/cdcd\x1b\\\x1b[?62;4;22c";
/// The answers of WezTerm, which knows all three protocols.
const WEZTERM: &[u8] = b"\x1b_Gi=31;OK\x1b\\\x1bP>|WezTerm 20240203-110809-5046fc22\x1b\\\x1b[6;20;10t\
      \x1b]11;rgb:0000/0000/0000\x1b\\\x1b]4;6;rgb:0d0d/cdcd/cdcd\x1b\\\x1b[?65;4;6;18;22c";
/// The first of the curves at these terminals.
const CYAN: [u8; 3] = [0x0d, 0xcd, 0xcd];
const FAN: &str = "vibration/rotating-unbalance";
/// Silence after which nothing more comes, of a program that is not optimised.
const REST: Duration = Duration::from_secs(1);
/// Deletes every picture of Kitty's.
const FORGET: &str = "\x1b_Ga=d,q=2,d=A\x1b\\";
/// Leaves the alternate screen.
const LEAVE: &str = "\x1b[?1049l";

/// The program with an analysis in front, 50 rows of 200 columns.
fn launch(analysis: &str) -> Launch {
    Launch::new(pty::program()).argument(analysis).size(50, 200)
}

/// The same at a terminal that answers at once, drawn and at rest.
fn at(answer: &[u8], analysis: &str) -> Pty {
    let pty = launch(analysis).answering(Duration::ZERO, answer).start();
    pty.expect("dalembert");
    pty.idle(REST);
    pty
}

fn has_braille(screen: &str) -> bool {
    screen.chars().any(|letter| ('\u{2801}'..='\u{28FF}').contains(&letter))
}

/// True if no cell holds what an answer is made of.
fn is_clean(screen: &str) -> bool {
    !["Gi=31", "rgb:", "kitty(", "foot(", ";20;10t", "62;"].iter().any(|part| screen.contains(part))
}

/// The middle of a curve, in pixels from the top, where it is drawn in full.
fn height(picture: &SentPicture, x: usize, color: [u8; 3]) -> Option<f64> {
    // Sixel has its colours in percent.
    let is_near = |pixel: [u8; 4]| pixel[3] == 255 && (0..3).all(|n| pixel[n].abs_diff(color[n]) <= 2);
    let rows: Vec<usize> = (0..picture.size.1).filter(|y| is_near(picture.pixel((x, *y)))).collect();
    (!rows.is_empty()).then(|| rows.iter().sum::<usize>() as f64 / rows.len() as f64)
}

/// The largest picture with a curve of this colour.
fn plot_of(sent: Vec<SentPicture>) -> SentPicture {
    let with_curve = sent.into_iter().filter(|sent| {
        let (width, _) = sent.size;
        (0..width).filter(|x| height(sent, *x, CYAN).is_some()).count() > width / 2
    });
    with_curve.max_by_key(|sent| sent.size).expect("a plot")
}

/// Closed form: a fan of 40 kg on a cantilever of k = 3EI/L³ = 451.4 kN/m has ω_n = 106.23 rad/s, and an amplitude of
/// 20.3 mm at most, where ω = ω_n/√(1 − 2ζ²) with ζ = 0.0617. At twice ω_n the amplitude is 2.5 mm · 4/√(9 + (4ζ)²).
/// The axis goes to 2.5 ω_n.
#[test]
fn every_protocol_draws_the_resonance_where_it_is() {
    for (answer, protocol) in [(KITTY, Protocol::Kitty), (FOOT, Protocol::Sixel), (WEZTERM, Protocol::Iterm2)]
    {
        let mut pty = at(answer, FAN);
        pty.types("<a-3>");
        pty.idle(REST);
        let sent = pictures(&pty.raw());
        assert!(!sent.is_empty() && sent.iter().all(|sent| sent.protocol == protocol), "{protocol:?}");
        assert!(!has_braille(&pty.screen()) && is_clean(&pty.screen()), "{protocol:?}:\n{}", pty.screen());
        let plot = plot_of(sent);
        let (width, down) = plot.size;
        if let Some((columns, rows)) = plot.cells {
            assert_eq!(plot.size, (10 * columns, 20 * rows), "{protocol:?}");
        }
        let zeta: f64 = 0.0616939;
        let of_ratio = |ratio: f64| (ratio / 2.5 * (width as f64 - 1.0)).round() as usize;
        let at = |x: usize| height(&plot, x, CYAN).unwrap_or_else(|| panic!("{protocol:?}: no curve at {x}"));
        let peak = of_ratio(1.0 / (1.0 - 2.0 * zeta * zeta).sqrt());
        let highest = (peak - 20..=peak + 20).filter(|x| height(&plot, *x, CYAN).is_some()).min_by(|a, b| {
            let top = |x: usize| (0..down).find(|y| plot.pixel((x, *y))[..3] == CYAN || at(x) <= *y as f64);
            top(*a).cmp(&top(*b))
        });
        assert!(highest.is_some_and(|x| x.abs_diff(peak) <= 3), "{protocol:?}: {highest:?} for {peak}");
        // Without a speed there is no amplitude.
        let rise = |ratio: f64| at(0) - at(of_ratio(ratio));
        let wanted = 2.5 * 4.0 / (9.0 + (4.0 * zeta).powi(2)).sqrt() / 20.3;
        let found = rise(2.0) / rise(peak as f64 * 2.5 / (width as f64 - 1.0));
        assert!((found / wanted - 1.0).abs() < 0.03, "{protocol:?}: {found} for {wanted}");
        // A frame may have 60 kB; there were several.
        assert!(pty.count() < 60_000, "{protocol:?}: {} bytes", pty.count());
        // Whatever is on the screen stays as it is.
        let before = pty.count();
        std::thread::sleep(REST);
        assert_eq!(pty.count(), before, "{protocol:?}");
    }
}

#[test]
fn strokes_have_soft_edges_in_the_colours_of_the_theme() {
    let plot = plot_of(pictures(&at(KITTY, FAN).raw()));
    let degrees: std::collections::BTreeSet<u8> = plot
        .pixels
        .iter()
        .filter(|[r, g, b, a]| *a > 0 && [*r, *g, *b] == CYAN)
        .map(|pixel| pixel[3])
        .collect();
    assert!(degrees.contains(&255) && degrees.len() > 5, "{degrees:?}");
    // A theme with colours of its own has no cyan of the terminal's, and its own ground behind.
    let folder = settings("theme = \"light\"\n");
    let pty = launch(FAN).env("XDG_CONFIG_HOME", folder.path().to_str().expect("a readable path"));
    let pty = pty.env("COLORTERM", "truecolor").answering(Duration::ZERO, KITTY).start();
    pty.expect("dalembert");
    pty.idle(REST);
    let sent = pictures(&pty.raw());
    assert!(
        !sent.is_empty() && sent.iter().all(|sent| (0..sent.size.0).all(|x| height(sent, x, CYAN).is_none()))
    );
}

#[test]
fn every_problem_has_a_picture_of_its_own_and_words_stay_text() {
    let mut seen: Vec<SentPicture> = Vec::new();
    for analysis in [FAN, "vibration/free-vibration", "virtual-work/four-bar"] {
        let pty = at(KITTY, analysis);
        let sent = pictures(&pty.raw());
        assert!(!sent.is_empty(), "{analysis}:\n{}", pty.screen());
        for picture in sent {
            assert!(
                picture.pixels.iter().filter(|pixel| pixel[3] > 0).count() > 200,
                "{analysis}: a blank picture"
            );
            assert!(
                !seen.iter().any(|seen| seen.pixels == picture.pixels),
                "{analysis}: the picture of another"
            );
            seen.push(picture);
        }
        assert!(!has_braille(&pty.screen()), "{analysis}:\n{}", pty.screen());
    }
}

#[test]
fn a_picture_is_sent_when_it_changes_and_hidden_without_that() {
    let mut pty = at(KITTY, FAN);
    pty.types("<a-3>");
    pty.idle(REST);
    // The plot has its cursor, away from the mark, and its readout.
    pty.types("<right><right><right><right>");
    pty.idle(REST);
    let before = pty.count();
    pty.types("<right>");
    pty.idle(REST);
    let sent = pictures(&pty.since(before));
    let is_strip = |sent: &SentPicture| sent.cells.is_some_and(|(columns, _)| columns <= 3);
    assert!(!sent.is_empty() && sent.iter().all(is_strip), "a cursor that moves is a strip");
    assert!(pty.since(before).len() < 3000, "{} bytes for a cursor", pty.since(before).len());
    let before = pty.count();
    pty.types("?");
    pty.expect("Keyboard shortcuts");
    pty.idle(REST);
    let commands = kitty_commands(&pty.since(before));
    assert!(commands.iter().any(|(data, _)| data.contains("a=d")), "{commands:?}");
    assert!(commands.iter().all(|(data, _)| !data.contains("a=T")), "{commands:?}");
    let before = pty.count();
    pty.types("<esc>");
    pty.expect("Mass of the machine");
    pty.idle(REST);
    let commands = kitty_commands(&pty.since(before));
    assert!(commands.iter().any(|(data, _)| data.contains("a=p")), "{commands:?}");
    assert!(pictures(&pty.since(before)).is_empty(), "what the terminal keeps was sent again");
    // Another size: everything is deleted, and sent for its new room.
    let before = pty.count();
    pty.resize(30, 110);
    pty.idle(REST);
    let since = String::from_utf8_lossy(&pty.since(before)).into_owned();
    assert!(since.find(FORGET) < since.find("a=T") && since.contains(FORGET), "{since:?}");
    for SentPicture { at, cells, .. } in pictures(&pty.since(before)) {
        let (columns, rows) = cells.expect("cells are sent");
        assert!(at.0 + columns <= 110 && at.1 + rows <= 30, "{at:?} {columns}×{rows}");
    }
}

#[test]
fn no_picture_outlives_the_program() {
    type End = fn(&mut Pty);
    let ends: [(&str, End); 5] = [
        ("a key", |pty| pty.types("<c-c>")),
        ("a panic", |pty| pty.types(":fault panic<enter>")),
        ("an abort", |pty| pty.types(":fault abort<enter>")),
        ("TERM", |pty| pty.signal(-1, Signal::TERM)),
        ("KILL", |pty| pty.signal(-1, Signal::KILL)),
    ];
    for (name, end) in ends {
        let pty = launch(FAN).env("DALEMBERT_FAULTS", "1").answering(Duration::ZERO, KITTY).start();
        let mut pty = pty;
        pty.expect("dalembert");
        pty.idle(REST);
        assert!(!pictures(&pty.raw()).is_empty(), "{name}");
        let before = pty.count();
        end(&mut pty);
        assert!(pty.exit_code().is_some(), "{name}");
        assert_eq!(pty.leftovers(), [""; 0], "{name}");
        let last = String::from_utf8_lossy(&pty.since(before)).into_owned();
        let (deleted, left) = (last.rfind(FORGET).expect(name), last.rfind(LEAVE).expect(name));
        assert!(deleted < left && !last[deleted..].contains("a=T"), "{name}");
    }
}

#[test]
fn no_picture_is_left_to_the_shell_while_the_program_is_suspended() {
    let launch = Launch::new(pty::program()).size(50, 200).under_shell();
    let mut pty = launch.answering(Duration::ZERO, KITTY).start();
    pty.expect("dalembert");
    pty.types(":quit<enter>");
    pty.expect("PTY$");
    pty.types(&format!("clear; \"$PROGRAM\" {FAN}<enter>"));
    pty.expect("dalembert");
    pty.idle(REST);
    assert!(!pictures(&pty.raw()).is_empty());
    let before = pty.count();
    pty.types("<c-z>");
    pty.expect("Stopped");
    pty.idle(REST);
    let since = String::from_utf8_lossy(&pty.since(before)).into_owned();
    assert!(since.contains(FORGET) && since.find(FORGET) < since.find(LEAVE), "{since:?}");
    let before = pty.count();
    pty.types("fg<enter>");
    pty.expect("dalembert");
    pty.idle(REST);
    assert!(!pictures(&pty.since(before)).is_empty(), "{}", pty.screen());
}

#[test]
fn a_dialog_over_a_picture_in_cells_writes_over_it() {
    for answer in [FOOT, WEZTERM] {
        let mut pty = at(answer, FAN);
        let areas: Vec<_> = pictures(&pty.raw());
        let before = pty.count();
        pty.types("?");
        pty.expect("Keyboard shortcuts");
        pty.idle(REST);
        assert!(pictures(&pty.since(before)).is_empty());
        // As many cells as the pictures had are written again.
        let cells: usize =
            areas.iter().map(|sent| sent.size.0 / 10 * sent.size.1 / 20).max().expect("a picture");
        assert!(pty.since(before).len() >= cells, "{} bytes over {cells} cells", pty.since(before).len());
        let before = pty.count();
        pty.types("<esc>");
        pty.expect("Mass of the machine");
        pty.idle(REST);
        assert!(!pictures(&pty.since(before)).is_empty() && !has_braille(&pty.screen()), "{}", pty.screen());
    }
}

#[test]
fn a_terminal_that_answers_too_late_or_never_gets_braille_at_once() {
    for answer in [Some(Duration::from_millis(700)), None] {
        let launch = launch("vibration/free-vibration");
        let pty = answer.map_or(launch.clone(), |after| launch.answering(after, KITTY)).start();
        pty.expect("dalembert");
        pty.idle(Duration::from_millis(900));
        let raw = pty.raw();
        let asked = raw.windows(3).position(|bytes| bytes == b"\x1b[c").expect("it asks") + 3;
        let drawn = raw.windows(8).position(|bytes| bytes == b"\x1b[?2026l").expect("it draws") + 8;
        let waited = pty.arrival(drawn).and_then(|drawn| Some(drawn - pty.arrival(asked)?));
        // Nothing waits for an answer; a machine that is busy with a build takes its time.
        assert!(waited.is_some_and(|waited| waited < Duration::from_millis(500)), "{waited:?}");
        assert!(has_braille(&pty.screen()) && is_clean(&pty.screen()), "{}", pty.screen());
        assert_eq!(kitty_commands(&raw), [], "{answer:?}");
    }
}

#[test]
fn a_broken_answer_is_neither_shown_nor_takes_keys_away() {
    let broken: [&[u8]; 4] = [
        b"\x1b_Gi=31;EINVAL:what\x1b\\\x1b]11;rgb:zz/0/0\x07\x1b[6;0;0t\x1b[?62;",
        b"\x1bP>|kitty(0.36",
        b"\x1b]4;1;rgb:cccc/0000/0000;2;rgb:\xff\xfe\xfd\x1b[99999999999999999999;4c",
        b"\x1b_G\x1b_G\x1b_Gi=31;OK\x1b\x1b\x18\x1b[?4;4;4;4",
    ];
    for answer in broken {
        let mut pty = at(answer, FAN);
        let screen = pty.screen();
        assert!(is_clean(&screen) && screen.contains("dalembert"), "{}:\n{screen}", answer.escape_ascii());
        pty.types(":alive");
        pty.expect(":alive");
        assert!(is_clean(&pty.screen()), "{}:\n{}", answer.escape_ascii(), pty.screen());
    }
}

fn settings(text: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::create_dir(folder.path().join("dalembert")).expect("a folder");
    std::fs::write(folder.path().join("dalembert/settings.toml"), text).expect("written");
    folder
}

#[test]
fn nothing_is_asked_over_ssh_in_ascii_or_where_pixels_are_off() {
    let asks = |launch: Launch| {
        let pty = launch.answering(Duration::ZERO, KITTY).start();
        pty.expect("dalembert");
        pty.idle(REST);
        (pty.raw().windows(4).any(|bytes| bytes == b"a=q,"), pictures(&pty.raw()).len())
    };
    let launch = || launch("vibration/free-vibration");
    assert_eq!(asks(launch().env("SSH_CONNECTION", "192.0.2.1 50000 192.0.2.2 22")), (false, 0));
    assert_eq!(asks(launch().argument("--basic")), (false, 0));
    assert_eq!(asks(launch().env("LANG", "C")), (false, 0));
    let with = |text: &str, launch: Launch| {
        let folder = settings(text);
        asks(launch.env("XDG_CONFIG_HOME", folder.path().to_str().expect("a readable path")))
    };
    assert_eq!(with("pixels = false\n", launch()), (false, 0));
    let (asked, pictures) = with("pixels = true\n", launch().env("SSH_TTY", "/dev/pts/1"));
    assert!(asked && pictures > 0, "{pictures} pictures where they were asked for");
}
