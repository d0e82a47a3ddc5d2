//! Rotors balanced in the field, step by step, by what the screen offers alone: from a blank job to the report.
//!
//! The machine is simulated here: it shows readings of its true unbalance and of the weights that the program asks for.

use std::{f64::consts::PI, fs, path::Path, time::Duration};

use dalembert_core::nalgebra::Complex;
use dalembert_tests::pty::{self, Launch, Pty};
use dalembert_tui::keys::notation::keys_of;
use itertools::zip_eq;
use ratatui::crossterm::event::KeyCode;

/// A machine of so many planes and as many sensors; its instrument counts phase as a lag.
struct Machine {
    /// Influence of the planes on the sensors, mm/s per gram and degrees of lead.
    influence: Vec<Vec<(f64, f64)>>,
    /// Unbalances, grams and degrees from the mark with the rotation.
    unbalance: Vec<(f64, f64)>,
    /// Weights that are mounted.
    weights: Vec<Complex<f64>>,
}

fn polar((size, degrees): (f64, f64)) -> Complex<f64> {
    Complex::from_polar(size, degrees.to_radians())
}

impl Machine {
    fn fan() -> Self {
        Self {
            influence: vec![vec![(0.12, -35.0), (0.04, -60.0)], vec![(0.035, -50.0), (0.10, -42.0)]],
            unbalance: vec![(62.0, 140.0), (35.0, 255.0)],
            weights: vec![Complex::ZERO; 2],
        }
    }

    fn exhauster() -> Self {
        Self {
            influence: vec![vec![(0.08, -70.0)]],
            unbalance: vec![(90.0, 200.0)],
            weights: vec![Complex::ZERO],
        }
    }

    /// Readings as they are typed: amplitude and lag, rounded as an instrument does.
    fn readings(&self) -> Vec<String> {
        let of = |row: &Vec<(f64, f64)>| {
            let parts = zip_eq(zip_eq(row, &self.unbalance), &self.weights);
            let sum: Complex<f64> =
                parts.map(|((alpha, heavy), on)| polar(*alpha) * (polar(*heavy) + on)).sum();
            let lag = (-sum.arg().to_degrees()).rem_euclid(360.0);
            format!("{:.2}@{:.0}", sum.norm(), lag)
        };
        self.influence.iter().map(of).collect()
    }

    /// The mass that balances a plane, and its angle.
    fn wanted(&self, plane: usize) -> (f64, f64) {
        let (mass, angle) = self.unbalance[plane];
        (mass, (angle + 180.0).rem_euclid(360.0))
    }
}

/// A technician at the screen: types, counts keys, and believes what is written there.
struct Technician {
    pty: Pty,
    keys: usize,
}

impl Technician {
    fn at(arguments: &str, folder: &Path, (rows, columns): (u16, u16)) -> Self {
        let script = format!("cd '{}' && \"$PROGRAM\" {arguments}; exit $?", folder.display());
        Self { pty: Launch::new(pty::program()).size(rows, columns).in_script(&script).start(), keys: 0 }
    }

    /// Types, and counts every key that is no digit, sign or decimal mark.
    fn types(&mut self, text: &str) -> &mut Self {
        let is_free = |code: KeyCode| matches!(code, KeyCode::Char('0'..='9' | '.' | ',' | '-' | '+'));
        let keys = keys_of(text).unwrap_or_else(|name| panic!("{name} is no key"));
        self.keys += keys.iter().filter(|key| !is_free(key.code)).count();
        self.pty.types(text);
        self
    }

    fn sees(&mut self, text: &str) -> &mut Self {
        self.pty.expect(text);
        self
    }

    /// Types the readings of the machine and goes on.
    fn reads(&mut self, machine: &Machine) -> &mut Self {
        for reading in machine.readings() {
            self.types(&format!("{reading}<enter>"));
        }
        self
    }

    /// Mounts what the screen asks for in a plane, a little aside, as hands do.
    fn mounts(&mut self, machine: &mut Machine, plane: usize) -> (f64, f64) {
        let screen = self.pty.screen();
        let before = format!("{} {}: ", if screen.contains("Plano ") { "Plano" } else { "Plane" }, plane + 1);
        let order = screen.split(&before).nth(1).unwrap_or_else(|| panic!("no order for {plane}:\n{screen}"));
        let mut numbers =
            order.split(|c: char| !c.is_ascii_digit() && c != '.' && c != ',').filter(|x| !x.is_empty());
        let mut number = || numbers.next().and_then(|x| x.replace(',', ".").parse().ok()).expect("a number");
        let asked: (f64, f64) = (number(), number());
        machine.weights[plane] += polar((asked.0 * 0.96, asked.1 + 1.0));
        asked
    }

    fn leaves(mut self) {
        self.pty.types("<c-c>");
        if self.pty.sees("without saving", Duration::from_millis(500)) {
            self.pty.types("<down><enter>");
        }
        assert_eq!((self.pty.exit_code(), self.pty.leftovers()), (Some(0), vec![]));
    }
}

fn is_near((mass, angle): (f64, f64), (wanted, at): (f64, f64)) -> bool {
    let apart = (angle - at + 180.0).rem_euclid(360.0) - 180.0;
    (mass - wanted).abs() < 0.05 * wanted && apart.abs() < 3.0
}

#[test]
fn a_fan_is_balanced_in_two_planes_from_blank_to_report_in_forty_keys() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut fan = Machine::fan();
    let mut job = Technician::at("field", folder.path(), (24, 80));
    job.sees("The job").types("fan<enter>").sees("1 one").types("2").sees("1 mm/s").types("1");
    job.types("1480<enter>180<enter>400<enter>").sees("grade G").types("1<enter>");
    job.sees("Next: instrument").types("<enter>").sees("fan.toml").types("<enter>").sees("saved as");
    job.types("1112").sees("lag").types("<enter>").sees("as found");
    job.reads(&fan).sees("H1").types("<enter>").sees("Proposed");
    for plane in 0..2 {
        let angle = 90 * plane;
        fan.weights[plane] = polar((25.0, f64::from(angle as u32)));
        job.sees(&format!("Trial run, plane {}", plane + 1)).types(&format!("25@{angle}<enter>"));
        job.reads(&fan).sees("changed the").types("<enter>");
        fan.weights[plane] = Complex::ZERO;
    }
    job.sees("Take every trial weight off");
    for plane in 0..2 {
        let asked = job.mounts(&mut fan, plane);
        assert!(is_near(asked, fan.wanted(plane)), "plane {plane}: {asked:?}");
    }
    job.types("<enter>").sees("Check run 1").reads(&fan).sees("Requirement met").types("<enter>");
    job.sees("Write the report").types("<enter>").sees("fan.html").types("<enter>").sees("written to");
    assert!(job.keys <= 40, "{} keys", job.keys);
    job.leaves();
    let report = fs::read_to_string(folder.path().join("fan.html")).expect("the report is written");
    assert!(
        report.contains("fan") && report.contains("Residual unbalance"),
        "the report lacks the residual unbalance"
    );
}

#[test]
fn an_exhauster_of_one_plane_is_trimmed_until_its_vibration_limit_is_met() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut exhauster = Machine::exhauster();
    let mut job = Technician::at("field exhauster.toml", folder.path(), (24, 80));
    job.sees("The job").types("<enter>").types("11").sees("1 mm/s").types("1");
    job.types("1750<enter>60<enter>300<enter>").types("2").sees("Limit").types("0.1<enter>");
    job.types("<enter>").sees("saved as").types("1112<enter>").sees("as found");
    job.reads(&exhauster).sees("H1").types("<enter>").sees("Proposed: 5.84 g");
    // A trial weight that is too small is found out, and a larger one mounted.
    exhauster.weights[0] = polar((10.0, 45.0));
    job.types("10@45<enter>").reads(&exhauster).sees("by only");
    exhauster.weights[0] = polar((40.0, 45.0));
    job.types("<up><up><up>").types("40@45<enter>").types("<up><up>").reads(&exhauster);
    job.sees("44 %.").types("<enter>");
    exhauster.weights[0] = Complex::ZERO;
    job.sees("mount");
    let asked = job.mounts(&mut exhauster, 0);
    assert!(is_near(asked, exhauster.wanted(0)), "{asked:?}");
    job.types("<enter>").sees("Check run 1").reads(&exhauster).sees("not met yet").types("<enter>");
    job.sees("Leave everything on the rotor");
    job.mounts(&mut exhauster, 0);
    job.types("<enter>").sees("Check run 2").reads(&exhauster).sees("Requirement met").types("<enter>");
    job.sees("Write the report");
    job.leaves();
    let left = exhauster.weights[0] + polar(exhauster.unbalance[0]);
    assert!(left.norm() < 2.0, "{} g are left", left.norm());
}

#[test]
fn a_job_goes_on_where_it_was_interrupted_and_opens_in_the_workbench() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut fan = Machine::fan();
    let mut job = Technician::at("field fan.toml", folder.path(), (24, 80));
    job.sees("The job")
        .types("fan<enter>21")
        .types("1480<enter>180<enter>400<enter>1<enter><enter>")
        .sees("saved as");
    job.leaves();
    let mut job = Technician::at("field fan.toml", folder.path(), (24, 80));
    job.sees("Instrument and angles").types("1112<enter>").sees("as found").reads(&fan).types("<enter>");
    fan.weights[0] = polar((25.0, 0.0));
    job.sees("Trial run, plane 1").types("25@0<enter>").reads(&fan).sees("changed the").types("<enter>");
    job.sees("Trial run, plane 2");
    job.leaves();
    // In the middle of a page too, and in the other language.
    let mut job = Technician::at("--lang pt-BR field fan.toml", folder.path(), (24, 80));
    fan.weights = vec![Complex::ZERO, polar((25.0, 90.0))];
    job.sees("Medição de teste, plano 2").sees("Tire a massa de teste");
    job.types("25@90<enter>");
    job.reads(&fan).sees("mudou a vibração").types("<enter>").sees("Tire todas as massas de teste");
    fan.weights = vec![Complex::ZERO; 2];
    for plane in 0..2 {
        let asked = job.mounts(&mut fan, plane);
        assert!(is_near(asked, fan.wanted(plane)), "plane {plane}: {asked:?}");
    }
    job.leaves();
    // The same file is an ordinary problem.
    let mut job = Technician::at("fan.toml", folder.path(), (36, 120));
    job.sees("Inputs").sees("Correction mass in plane 1");
    job.types(":field balancing<enter>").sees("Take every trial weight off");
    job.leaves();
}

/// A job is recorded in field mode, whose file dialog is typed again when it is played, and nothing is written then.
#[test]
fn a_job_is_recorded_and_played_again() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut job = Technician::at("field --record job.replay", folder.path(), (24, 80));
    job.sees("The job").types("fan<enter>21").types("1480<enter>180<enter>400<enter>").sees("grade G");
    job.types("1<enter>")
        .sees("Next: instrument")
        .types("<enter>")
        .sees("fan.toml")
        .types("<enter>")
        .sees("saved as");
    job.types("1112").sees("lag");
    job.leaves();
    let text = fs::read_to_string(folder.path().join("job.replay")).expect("it was recorded");
    assert!(text.starts_with("screen 80x24\nlanguage en\nlook colour\nfield\n"), "{text}");
    fs::remove_file(folder.path().join("fan.toml")).expect("it was saved");
    let mut replay = std::process::Command::new(pty::program());
    replay.args(["--lang", "en", "replay", "job.replay", "--headless"]).current_dir(folder.path());
    let played = replay.output().expect("the program runs");
    let screen = String::from_utf8_lossy(&played.stdout).into_owned();
    assert!(played.status.success(), "{screen}{}", String::from_utf8_lossy(&played.stderr));
    assert!(screen.contains("Instrument and angles") && screen.contains("lag"), "{screen}");
    assert!(!folder.path().join("fan.toml").exists(), "a replay writes nothing");
    // A job with a name of its own is one when it is played, too.
    let mut job = Technician::at("field exhauster.toml --record named.replay", folder.path(), (24, 80));
    job.sees("The job").types("<enter>");
    job.leaves();
    let text = fs::read_to_string(folder.path().join("named.replay")).expect("it was recorded");
    assert!(text.contains("\nfield exhauster.toml\n"), "{text}");
}

/// The correction is the opposite of the unbalance: what the tests above rest on.
#[test]
fn the_machine_is_at_rest_with_the_wanted_weights() {
    let mut fan = Machine::fan();
    for plane in 0..2 {
        fan.weights[plane] = polar(fan.wanted(plane));
    }
    assert!(fan.readings().iter().all(|reading| reading.starts_with("0.00")), "{:?}", fan.readings());
    assert!((polar((1.0, 180.0)).arg() - PI).abs() < 1e-12);
}
