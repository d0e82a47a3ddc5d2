//! Days of people at the workbench, from the start of the program to the file they leave with. Each is worked at a
//! terminal; what is on the screen is compared with numbers found here, not to what was seen there once.
//!
//! The fan that is balanced in the field stands in `workbench.rs`.

use std::{f64::consts::PI, fs, path::Path, time::Duration};

use dalembert_tests::pty::{self, Launch, Pty};

/// The program on an analysis, in a folder for its files.
fn at_work(id: &str, folder: &Path) -> Pty {
    let script = format!("cd '{}' && \"$PROGRAM\" {id}; exit $?", folder.display());
    let pty = Launch::new(pty::program()).size(36, 120).in_script(&script).start();
    pty.expect("Inputs");
    pty.idle(Duration::from_millis(200));
    pty
}

/// Leaves, without saving where that is asked.
fn leaves(pty: &mut Pty) {
    pty.types("q");
    if pty.sees("without saving", Duration::from_millis(500)) {
        pty.types("<down><enter>");
    }
    assert_eq!((pty.exit_code(), pty.leftovers()), (Some(0), vec![]));
}

/// A student works the fan by hand: nothing is given away, a right answer is confirmed, a wrong one is not, and what
/// follows from it reports it; then the working is read up to where it went wrong, and that is corrected.
#[test]
fn homework_is_tried_by_hand_and_checked() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut pty = at_work("vibration/rotating-unbalance", folder.path());
    pty.expect("19.456");
    pty.types("t]]]]");
    pty.expect("stays hidden");
    assert!(!pty.screen().contains("19.456"), "{}", pty.screen());
    // ωₙ = √(3 E I / L³ / m), by hand to four digits.
    let natural = (3.0 * 200e9 * 1.3e-6 / 1.2_f64.powi(3) / 40.0).sqrt();
    pty.types(&format!("<down><down><down>{natural:.1}<enter>"));
    pty.expect(&format!("= {natural:.2} rad/s"));
    // ζ from another formula, and the amplitude that it leads to.
    pty.types("<down><down>0.707<enter>");
    pty.expect("Incorrect");
    let ratio = 1000.0 * PI / 30.0 / natural;
    let amplitude = 0.1 / 40.0 * ratio * ratio / (1.0 - ratio * ratio).hypot(2.0 * 0.707 * ratio) * 1e3;
    pty.types(&format!("<home>{amplitude:.3}<enter>"));
    pty.expect("consistent with your earlier answer to");
    // The working, as far as the step that was missed, and no farther.
    pty.types("[[[");
    pty.expect("k = ?");
    pty.types("    ");
    pty.expect("= 8.12");
    pty.expect("ζ = ?");
    assert!(!pty.screen().contains("0.061694"), "{}", pty.screen());
    pty.types("]]]<down><down><down><down><down>0.0617<enter>");
    pty.expect("= 0.061694");
    // With the last answer the exercise is done, and the list of exercises reports it.
    let amplitude = 0.1 / 40.0 * ratio * ratio / (1.0 - ratio * ratio).hypot(2.0 * 0.061694 * ratio) * 1e3;
    pty.types(&format!("<home>{amplitude:.2}<enter>"));
    pty.expect("all required answers are correct");
    pty.types("t<esc><esc>");
    pty.expect("Exercise lists");
    let screen = pty.screen();
    let lists = screen.lines().find(|line| line.contains("Exercise lists")).unwrap_or_default();
    assert!(lists.contains(" 1/"), "{screen}");
    pty.types("<esc>");
    pty.expect("q quit");
    leaves(&mut pty);
}

/// A lecturer shows what resonance is: a result is pinned, the speed is raised before everybody's eyes, the working
/// is uncovered step by step, modes move, and the students' language is a key away.
#[test]
fn a_lecturer_demonstrates_live() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut pty = at_work("vibration/rotating-unbalance", folder.path());
    pty.expect("19.456");
    // Raised ten rpm at a key; the difference to the pinned result is beside every answer that moved.
    pty.types("<end>c<s-up><s-up>");
    pty.expect("1020 rpm");
    let r = 1020.0 * PI / 30.0 / (3.0 * 200e9 * 1.3e-6 / 1.2_f64.powi(3) / 40.0).sqrt();
    let zeta: f64 = 0.061694;
    let amplitude = 0.1 / 40.0 * r * r / (1.0 - r * r).hypot(2.0 * zeta * r) * 1e3;
    pty.expect(&format!("{amplitude:.3}"));
    pty.expect(&format!("{:+.3} mm", amplitude - 19.456)[..5]);
    // Nothing is given away before its turn.
    pty.types("t]");
    pty.expect("k = ?");
    assert!(!pty.screen().contains("451.39"), "{}", pty.screen());
    pty.types(" ");
    pty.expect("451.39 kN/m");
    pty.expect("ωₙ = ?");
    pty.types("t");
    pty.expect("106.23 rad/s");
    leaves(&mut pty);

    let mut pty = at_work("vibration/modal-analysis", folder.path());
    pty.types("]]]n");
    pty.expect("Drawing 2/5");
    // It begins held at the given position.
    pty.types("p");
    let first = pty.screen();
    assert!((0..100).any(|_| {
        std::thread::sleep(Duration::from_millis(20));
        pty.screen() != first
    }));
    // Held, it is at rest.
    pty.types("p");
    pty.idle(Duration::from_millis(300));
    let held = (pty.count(), pty.screen());
    std::thread::sleep(Duration::from_millis(500));
    assert_eq!((pty.count(), pty.screen()), held);
    pty.types("L");
    pty.expect("Dados de entrada");
    pty.types("L");
    pty.expect("Inputs");
    leaves(&mut pty);
}

/// A mass of 2 kg on 80 kN/m and 40 N·s/m, measured twice: as a table in a text file and as a universal file.
const ARM: (f64, f64, f64) = (2.0, 40.0, 80e3);

/// The receptance at so many rad/s.
fn receptance(speed: f64) -> (f64, f64) {
    let (mass, damping, stiffness) = ARM;
    let (real, imaginary) = (stiffness - mass * speed * speed, damping * speed);
    let square = real * real + imaginary * imaginary;
    (real / square, -imaginary / square)
}

fn text_file() -> String {
    let speeds = [100.0, 150.0, 180.0, 190.0, 195.0, 199.0, 203.0, 207.0, 212.0, 220.0, 250.0, 300.0];
    let rows = speeds.map(|speed| {
        let (real, imaginary) = receptance(speed);
        format!("{speed}; {:.6e}\n", real.hypot(imaginary))
    });
    "frequency [rad/s]; receptance [m/N]\n".to_owned() + &rows.concat()
}

/// Dataset 58, in text, 20 Hz to 43 Hz.
fn universal_file() -> String {
    const COUNT: u32 = 24;
    /// As Fortran writes it.
    fn fortran(x: f64) -> String {
        let text = format!("{x:.5e}");
        let (mantissa, exponent) = text.split_once('e').expect("an exponent");
        let exponent: i32 = exponent.parse().expect("a number");
        let sign = if exponent < 0 { '-' } else { '+' };
        format!("{:>13}", format!("{mantissa}E{sign}{:02}", exponent.abs()))
    }
    let axis = |kind: u32, unit: &str| format!("{kind:10}    0    0    0 NONE                 {unit:<20}\n");
    let parts: Vec<f64> = (0..COUNT)
        .flat_map(|n| {
            let (real, imaginary) = receptance((20.0 + f64::from(n)) * 2.0 * PI);
            [real, imaginary]
        })
        .collect();
    let lines = parts.chunks(6).map(|six| six.iter().map(|x| fortran(*x)).collect::<String>() + "\n");
    let axes = [axis(18, "Hz"), axis(8, "m"), axis(13, "N"), axis(0, "NONE")].concat();
    format!(
        "    -1\n    58\nFRF of the arm\nNONE\nNONE\nNONE\nNONE\n\
             4         0    0         0       NONE         5   3       NONE         1   3\n\
         {:10}{COUNT:10}{:10}{}{}{}\n{axes}{}    -1\n",
        5,
        1,
        fortran(20.0),
        fortran(1.0),
        fortran(0.0),
        lines.collect::<String>()
    )
}

/// A response that was measured is read from both kinds of file, gives the body it was measured on, and goes into a
/// report.
#[test]
fn a_measured_response_is_imported_identified_and_exported() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("measured.csv"), text_file()).expect("written");
    fs::write(folder.path().join("measured.uff"), universal_file()).expect("written");
    let mut pty = at_work("vibration/frequency-response-identification", folder.path());
    pty.types("<enter><down><enter>");
    pty.expect("Table of the freq");
    pty.types("<down>");
    pty.paste("@measured.csv");
    pty.expect("13 lines");
    // Half the square root of k/m over itself is the damping ratio: c/(2√(k m)) = 0.05, and ωₙ = 200 rad/s.
    assert!(pty.sees(" 200 ", pty::PATIENCE) && pty.screen().contains(" 0.05 "), "{}", pty.screen());
    pty.types("<up><enter><down><enter>");
    pty.expect("complex");
    pty.types("<down><down>");
    pty.paste("@measured.uff");
    pty.expect("26 lines");
    let hertz = format!("{:.3}", (ARM.2 / ARM.0).sqrt() / 2.0 / PI);
    pty.expect(&hertz);
    pty.types("X");
    pty.expect(".html");
    pty.types("<enter>");
    pty.expect("worked solution written to");
    let page = fs::read_to_string(folder.path().join("frequency-response-identification.html"))
        .expect("the report is there");
    for words in [&hertz, "<svg", "80000", "Nyquist"] {
        assert!(page.contains(words), "{words} is not in the report");
    }
    leaves(&mut pty);
}

/// The shaft of a turbine's rotor is sized so that it never touches: without damping only shafts far below or far
/// above their critical speeds serve, and one of them is judged.
#[test]
fn a_shaft_is_sized_under_a_clearance() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut pty = at_work("vibration/shaft-clearance", folder.path());
    pty.types("<down><down><enter><up><enter>");
    pty.expect("Undamped");
    // |X| = e r²/|1 − r²| reaches the clearance R at ωₙ² = ω²(R ∓ e)/R; a cantilever has k = 3 E π d⁴/(64 L³).
    let (mass, clearance, eccentricity, length, young) = (250.0, 5e-3, 5e-3 / 250.0, 2.0_f64, 207e9);
    for (speed, side) in [(480.0, -1.0), (7200.0, 1.0)] {
        let natural = (speed * PI / 30.0_f64).powi(2) * (clearance + side * eccentricity) / clearance;
        let second_moment = mass * natural * length.powi(3) / 3.0 / young;
        let diameter = (64.0 * second_moment / PI).powf(0.25) * 1e3;
        let shown = format!("{diameter:.2}");
        pty.expect(&format!("{} mm", shown.trim_end_matches('0')));
    }
    pty.types("<end><space><enter>70 mm<enter>");
    pty.expect("Critical speed of the shaft to be");
    let stiffness = 3.0 * young * PI * 0.07_f64.powi(4) / 64.0 / length.powi(3);
    pty.expect(&format!("{:.2}", (stiffness / mass).sqrt() * 30.0 / PI));
    let path = folder.path().join("shaft.toml");
    pty.types(&format!("s{}<enter>", path.display()));
    pty.expect("saved as");
    pty.types("q");
    assert_eq!(pty.exit_code(), Some(0));
    assert!(fs::read_to_string(&path).expect("the file is there").contains("70 mm"));
}
