//! Days of people at the workbench, from the start of the program to the file they leave with. Each is worked at a
//! terminal by keys that the screen names, which are counted; what is on the screen is compared with numbers found here,
//! not to what was seen there once.
//!
//! The fan that is balanced in the field, in at most forty keys, stands in `field.rs`.

use std::{f64::consts::PI, fs, path::Path, time::Duration};

use dalembert_tests::pty::{self, Launch, Pty};
use dalembert_tui::keys::notation::keys_of;
use ratatui::crossterm::event::KeyCode;

/// Somebody who knows no key but those that the screen names.
struct Person {
    pty: Pty,
    keys: usize,
}

impl Person {
    /// Starts the program with arguments, in a folder for its files.
    fn at(arguments: &str, folder: &Path) -> Self {
        let script = format!("cd '{}' && \"$PROGRAM\" {arguments}; exit $?", folder.display());
        let pty = Launch::new(pty::program()).size(36, 120).in_script(&script).start();
        pty.expect("q quit");
        pty.idle(Duration::from_millis(200));
        Self { pty, keys: 0 }
    }

    /// Presses keys; digits, signs and decimal marks are not counted.
    fn types(&mut self, text: &str) -> &mut Self {
        let is_free = |code: KeyCode| matches!(code, KeyCode::Char('0'..='9' | '.' | ',' | '-' | '+' | '@'));
        let keys = keys_of(text).unwrap_or_else(|name| panic!("{name} is no key"));
        self.keys += keys.iter().filter(|key| !is_free(key.code)).count();
        self.pty.types(text);
        self
    }

    /// Writes what the problem gives, with its unit: nothing of it is counted.
    fn writes(&mut self, value: &str) -> &mut Self {
        self.pty.types(value);
        self
    }

    /// Presses keys that the footer names with these words.
    fn presses(&mut self, keys: &str, words: &str) -> &mut Self {
        self.pty.expect(words);
        let screen = self.pty.screen();
        let footer = screen.lines().rev().find(|line| !line.trim().is_empty()).unwrap_or_default();
        assert!(footer.contains(words), "`{words}` is not in the footer:\n{screen}");
        self.types(keys)
    }

    /// Presses keys that the help names with these words, after it was searched for them.
    fn finds(&mut self, keys: &str, words: &str) -> &mut Self {
        self.presses("?", "? help").types(words).sees(words).leave_help().types(keys)
    }

    /// Closes the help, whose search has the keys at first.
    fn leave_help(&mut self) -> &mut Self {
        for _ in 0..2 {
            if self.pty.screen().contains("Keyboard shortcuts") {
                self.types("<esc>");
                self.pty.idle(Duration::from_millis(100));
            }
        }
        self.sees("? help")
    }

    fn sees(&mut self, text: &str) -> &mut Self {
        self.pty.expect(text);
        self
    }

    /// Leaves, without saving where that is asked; the keys were no more than so many.
    fn leaves(mut self, most: usize) {
        self.presses("q", "q quit");
        if self.pty.sees("without saving", Duration::from_millis(500)) {
            self.types("<down><enter>");
        }
        assert_eq!((self.pty.exit_code(), self.pty.leftovers()), (Some(0), vec![]));
        assert!(self.keys <= most, "{} keys", self.keys);
    }
}

/// A student works the fan by hand: nothing is given away, a right answer is confirmed, a wrong one is not, and what
/// follows from it reports it; then the working is read up to where it went wrong, and that is corrected.
#[test]
fn homework_is_tried_by_hand_and_checked() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut student = Person::at("vibration/rotating-unbalance", folder.path());
    student.sees("19.456");
    student.presses("t", "t solve by hand").presses("]]]]", "[ ] tabs");
    student.sees("stays hidden");
    assert!(!student.pty.screen().contains("19.456"), "{}", student.pty.screen());
    // ωₙ = √(3 E I / L³ / m), by hand to four digits.
    let natural = (3.0 * 200e9 * 1.3e-6 / 1.2_f64.powi(3) / 40.0).sqrt();
    student.types(&format!("<down><down><down>{natural:.1}<enter>"));
    student.sees(&format!("= {natural:.2} rad/s"));
    // ζ from another formula, and the amplitude that it leads to.
    student.types("<down><down>0.707<enter>").sees("Incorrect");
    let ratio = 1000.0 * PI / 30.0 / natural;
    let amplitude = 0.1 / 40.0 * ratio * ratio / (1.0 - ratio * ratio).hypot(2.0 * 0.707 * ratio) * 1e3;
    student.types(&format!("<home>{amplitude:.3}<enter>")).sees("consistent with your earlier answer to");
    // The working, as far as the step that was missed, and no farther.
    student.presses("[[[", "[ ] tabs").sees("k = ?");
    student.types("    ").sees("= 8.12").sees("ζ = ?");
    assert!(!student.pty.screen().contains("0.061694"), "{}", student.pty.screen());
    student.types("]]]<down><down><down><down><down>0.0617<enter>").sees("= 0.061694");
    // With the last answer the exercise is done, and the list of exercises reports it.
    let amplitude = 0.1 / 40.0 * ratio * ratio / (1.0 - ratio * ratio).hypot(2.0 * 0.061694 * ratio) * 1e3;
    student.types(&format!("<home>{amplitude:.2}<enter>")).sees("all required answers are correct");
    student.types("t<esc><esc>").sees("Exercise lists");
    let screen = student.pty.screen();
    let lists = screen.lines().find(|line| line.contains("Exercise lists")).unwrap_or_default();
    assert!(lists.contains(" 1/"), "{screen}");
    student.types("<esc>").sees("q quit");
    student.leaves(50);
}

/// A lecturer shows what resonance is: a result is pinned, the speed is raised before everybody's eyes, the working
/// is uncovered step by step, modes move, and the students' language is a key away.
#[test]
fn a_lecturer_demonstrates_live() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut lecturer = Person::at("vibration/rotating-unbalance", folder.path());
    lecturer.sees("19.456");
    // Raised ten rpm at a key; the difference to the pinned result is beside every answer that moved.
    lecturer.types("<end>").finds("c", "compare").types("<s-up><s-up>").sees("1020 rpm");
    let r = 1020.0 * PI / 30.0 / (3.0 * 200e9 * 1.3e-6 / 1.2_f64.powi(3) / 40.0).sqrt();
    let zeta: f64 = 0.061694;
    let amplitude = 0.1 / 40.0 * r * r / (1.0 - r * r).hypot(2.0 * zeta * r) * 1e3;
    lecturer.sees(&format!("{amplitude:.3}"));
    lecturer.sees(&format!("{:+.3} mm", amplitude - 19.456)[..5]);
    // Nothing is given away before its turn.
    lecturer.presses("t]", "t solve by hand").sees("k = ?");
    assert!(!lecturer.pty.screen().contains("451.39"), "{}", lecturer.pty.screen());
    lecturer.types(" ").sees("451.39 kN/m").sees("ωₙ = ?").types("t").sees("106.23 rad/s");
    lecturer.leaves(20);

    let mut lecturer = Person::at("vibration/modal-analysis", folder.path());
    lecturer.types("]]]n").sees("Drawing 2/5");
    // It begins held at the given position.
    lecturer.presses("<space>", "Space animation");
    let first = lecturer.pty.screen();
    assert!((0..100).any(|_| {
        std::thread::sleep(Duration::from_millis(20));
        lecturer.pty.screen() != first
    }));
    // Held, it is at rest.
    lecturer.types("<space>");
    lecturer.pty.idle(Duration::from_millis(300));
    let held = (lecturer.pty.count(), lecturer.pty.screen());
    std::thread::sleep(Duration::from_millis(500));
    assert_eq!((lecturer.pty.count(), lecturer.pty.screen()), held);
    lecturer.types("L").sees("Dados de entrada").types("L").sees("Inputs");
    lecturer.leaves(12);
}

/// A lecture is recorded, given captions in the file and played before the class: no caption covers the keys of the
/// workbench, and any key hands the keyboard over.
#[test]
fn a_lecture_is_recorded_and_played_before_the_class() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut lecturer = Person::at("vibration/rotating-unbalance --record lesson.replay", folder.path());
    lecturer.sees("19.456");
    lecturer.presses("<end>", "+ - adjust").types("+++").sees("1003 rpm").presses("]]", "[ ] tabs");
    lecturer.leaves(10);
    let path = folder.path().join("lesson.replay");
    let text = fs::read_to_string(&path).expect("it was recorded");
    let (head, keys) = text.split_once("type ").expect("keys were recorded");
    fs::write(&path, format!("{head}caption Close to resonance.\npause\ntype {keys}caption\n"))
        .expect("written");
    let mut class = Person::at("replay lesson.replay --speed 5", folder.path());
    class.sees("Close to resonance.").sees("Space continues").sees("1000 rpm").sees("q quit");
    class.types("<space>").sees("1003 rpm").sees("keyboard is active again");
    assert!(!class.pty.screen().contains("Close to resonance."), "{}", class.pty.screen());
    class.leaves(2);
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
    let mut engineer = Person::at("vibration/frequency-response-identification", folder.path());
    engineer.presses("<enter><down><enter>", "Enter edit").sees("Table of the freq").types("<down>");
    engineer.pty.paste("@measured.csv");
    engineer.sees("12 rows").types("<enter>").sees("12 rows ·");
    // Half the square root of k/m over itself is the damping ratio: c/(2√(k m)) = 0.05, and ωₙ = 200 rad/s.
    let has = |pty: &Pty| pty.sees(" 200 ", pty::PATIENCE) && pty.screen().contains(" 0.05 ");
    assert!(has(&engineer.pty), "{}", engineer.pty.screen());
    engineer.types("<up><enter><down><enter>").sees("complex").types("<down><down>");
    engineer.pty.paste("@measured.uff");
    engineer.sees("24 rows").types("<enter>").sees("24 rows ·");
    let hertz = format!("{:.3}", (ARM.2 / ARM.0).sqrt() / 2.0 / PI);
    engineer.sees(&hertz).finds("X", "export").sees(".html");
    engineer.types("<enter>").sees("worked solution written to");
    let page = fs::read_to_string(folder.path().join("frequency-response-identification.html"))
        .expect("the report is there");
    for words in [&hertz, "<svg", "80000", "Nyquist"] {
        assert!(page.contains(words), "{words} is not in the report");
    }
    engineer.leaves(25);
}

/// The shaft of a turbine's rotor is sized so that it never touches: without damping only shafts far below or far
/// above their critical speeds serve; a study shows how the limit follows the clearance, and one shaft is judged.
#[test]
fn a_shaft_is_sized_under_a_clearance() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut designer = Person::at("vibration/shaft-clearance", folder.path());
    designer.presses("<down><down><enter><up><enter>", "Enter edit").sees("Undamped");
    // |X| = e r²/|1 − r²| reaches the clearance R at ωₙ² = ω²(R ∓ e)/R; a cantilever has k = 3 E π d⁴/(64 L³).
    let (mass, eccentricity, length, young) = (250.0, 5e-3 / 250.0, 2.0_f64, 207e9);
    let diameter = |speed: f64, side: f64, clearance: f64| {
        let natural = (speed * PI / 30.0_f64).powi(2) * (clearance + side * eccentricity) / clearance;
        let second_moment = mass * natural * length.powi(3) / 3.0 / young;
        (64.0 * second_moment / PI).powf(0.25) * 1e3
    };
    let shown = |diameter: f64| format!("{diameter:.2}").trim_end_matches('0').to_owned();
    for (speed, side) in [(480.0, -1.0), (7200.0, 1.0)] {
        designer.sees(&format!("{} mm", shown(diameter(speed, side, 5e-3))));
    }
    // A study begins with the input under the cursor, here the clearance, and shows the curves of the main answer.
    designer
        .presses("<up><tab>", "Tab see results")
        .presses("[[", "[ ] tabs")
        .sees("Study")
        .sees("Radial clearance");
    designer.types("<tab>");
    designer.types("<end><space><enter>").writes("70 mm").types("<enter>");
    designer.presses("]]", "[ ] tabs").sees("Critical speed of the shaft to be");
    let stiffness = 3.0 * young * PI * 0.07_f64.powi(4) / 64.0 / length.powi(3);
    designer.sees(&format!("{:.2}", (stiffness / mass).sqrt() * 30.0 / PI));
    designer.presses("s", "s save").writes("shaft.toml").types("<enter>").sees("saved as");
    let path = folder.path().join("shaft.toml");
    assert!(fs::read_to_string(&path).expect("the file is there").contains("70 mm"));
    designer.leaves(40);
}
