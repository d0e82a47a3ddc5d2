//! Systems of units: over the registry, found from inputs, set on the command line, in files and in the workbench.

#![expect(clippy::unwrap_used, reason = "a test ends where its data fails")]

use std::{
    fs,
    path::Path,
    process::{Command, Stdio},
};

use dalembert_core::{Locale, Solution, Stop, Text, UnitSetting, file, registry};
use dalembert_plugins as _;
use dalembert_testkit::unit_systems;
use dalembert_tests::{person::Person, pty};
use dalembert_units::UnitSystem;

/// Thomson's oscillator in inches, pounds-force and seconds: m = 0.5 lbf·s²/in, driven at its natural frequency.
const OSCILLATOR: &str = r#"
format = 2
analysis = "vibration/harmonic-force"

[inputs]
mass.mass.mass = "0.5 slinch"
elasticity.stiffness.stiffness = "200 lbf/in"
damping.coefficient.coefficient = "6 lbf*s/in"
frequency = "20 rad/s"
excitation.force.force = "10 lbf"
"#;

fn with(text: &str, changes: &[(&str, &str)]) -> String {
    changes.iter().fold(text.to_owned(), |text, (before, after)| {
        assert!(text.contains(before), "{before}");
        text.replace(before, after)
    })
}

/// A problem file solved, in the units of the file.
fn solved(text: &str) -> Solution {
    let problem = file::parse(text).unwrap_or_else(|errors| panic!("{errors:?}\n{text}"));
    let shape = problem.entry.shape();
    let record = problem.draft.read(&shape).unwrap_or_else(|errors| panic!("{errors:?}"));
    let solution = problem.entry.solve(&record, &Stop::new()).unwrap();
    solution.in_units_of(problem.units, &problem.draft, &shape)
}

fn system(text: &str) -> Option<UnitSystem> {
    solved(text).units.map(|units| units.system)
}

fn shown(solution: &Solution, answer: &str) -> String {
    solution.answer(answer).unwrap().shown(&Locale::english().ascii(true))
}

/// Runs the program without a terminal: its output and what it says of an error.
fn run(arguments: &[&str]) -> (String, String) {
    let output = Command::new(pty::program())
        .args(arguments)
        .stdin(Stdio::null())
        .env("XDG_CONFIG_HOME", env!("CARGO_TARGET_TMPDIR"))
        .env("LC_ALL", "C.UTF-8")
        .output()
        .unwrap();
    let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).unwrap();
    (text(&output.stdout), text(&output.stderr))
}

/// The lines of a printed solution, with one space between words.
fn lines(printed: &str) -> Vec<String> {
    printed.lines().map(|line| line.split_whitespace().collect::<Vec<_>>().join(" ")).collect()
}

#[track_caller]
fn has(printed: &str, wanted: &[&str]) {
    let lines = lines(printed);
    for line in wanted {
        assert!(lines.iter().any(|known| known == line), "`{line}` is not in:\n{printed}");
    }
}

#[test]
fn every_solution_is_coherent_in_every_system() {
    let (units, substitutions) = unit_systems::every_solution_is_coherent_in_every_system(registry());
    assert!(units > 15_000 && substitutions > 10_000, "{units} units, {substitutions} substitutions");
}

#[test]
fn the_system_is_found_from_what_was_typed() {
    use UnitSystem::{FootSlug, InchPound};
    #[rustfmt::skip]
    let rows: [(&[(&str, &str)], Option<UnitSystem>); 13] = [
        (&[], Some(InchPound)),
        (&[("0.5 slinch", "0.5 lbf*s^2/in")], Some(InchPound)),
        // Pounds of mass beside forces.
        (&[("0.5 slinch", "193 lb")], Some(InchPound)),
        (&[("0.5 slinch", "193 lb"), ("/in\"", "/ft\"")], Some(FootSlug)),
        (&[("0.5 slinch", "6 slug"), ("/in\"", "/ft\"")], Some(FootSlug)),
        // Inches beside feet.
        (&[("200 lbf/in", "2400 lbf/ft")], Some(InchPound)),
        // No length at all.
        (&[("0.5 slinch", "193 lb"), ("damping.coefficient.coefficient = \"6 lbf*s/in\"", "damping.ratio.ratio = \"0.3\""),
           ("elasticity.stiffness.stiffness = \"200 lbf/in\"", "elasticity.natural-frequency.frequency = \"20 rad/s\"")], Some(InchPound)),
        // A zero says nothing.
        (&[("6 lbf*s/in", "0"), ("20 rad/s", "15 rad/s")], Some(InchPound)),
        // One metric unit, a number alone, a mixed unit.
        (&[("10 lbf", "10 N")], None),
        (&[("10 lbf", "10")], None),
        (&[("200 lbf/in", "20 kgf/in")], None),
        // A definition is an input.
        (&[("10 lbf", "F"), ("[inputs]", "[let]\nF = \"10 lbf\"\n\n[inputs]")], Some(InchPound)),
        (&[("10 lbf", "F"), ("[inputs]", "[let]\nF = \"45 N\"\n\n[inputs]")], None),
    ];
    for (changes, expected) in rows {
        assert_eq!(system(&with(OSCILLATOR, changes)), expected, "{changes:?}");
    }
    let metric = [("0.5 slinch", "0.5 t"), (" lbf/in", " N/mm"), (" lbf*s/in", " N*s/mm"), (" lbf", " N")];
    assert_eq!(system(&with(OSCILLATOR, &metric)), None);
}

#[test]
fn an_answer_is_in_the_coherent_unit() {
    let solution = solved(OSCILLATOR);
    for (answer, expected) in [
        ("natural_frequency", "20 rad/s"),
        ("damping_ratio", "0.3"),
        ("amplitude", "0.083333 in"),
        ("phase", "90 deg"),
        ("velocity", "1.6667 in/s"),
        ("transmitted_force", "19.437 lbf"),
        ("work", "2.618 lbf*in"),
        ("power", "8.3333 lbf*in/s"),
    ] {
        let found = shown(&solution, answer);
        assert_eq!(found, expected, "{answer}");
    }
}

#[test]
fn an_answer_takes_the_customary_unit_that_all_inputs_of_its_dimension_have() {
    let one_plane = r#"
analysis = "balancing/field"
format = 2

[inputs]
phase = "lead"
angles = "with"
method = "least-squares"
[inputs.measured]
first = [{ amplitude = "4 mil", phase = "45 deg" }]
influence.runs.after = "taken-off"
influence.runs.runs = [{ plane = "1", mass = "4 oz", angle = "-20 deg", readings = [{ amplitude = "8 mil", phase = "145 deg" }] }]
"#;
    let mass = |text: &str| shown(&solved(text), "correction[1]");
    // Rao's example: 1.676 oz.
    assert_eq!(mass(one_plane), "1.6762 oz");
    let metric = with(one_plane, &[("4 oz", "113.398 g")]);
    assert!(mass(&metric).ends_with(" g"), "{}", mass(&metric));
    let set = with(one_plane, &[("format = 2", "format = 2\nunits = \"as-typed\"")]);
    assert!(mass(&set).ends_with(" g"), "{}", mass(&set));
}

#[test]
fn a_question_keeps_the_unit_that_it_asks_for() {
    let asks = "\n[ask]\nforce = { value = \"k*X\", unit = \"N\", key = \"chosen\" }\nother = { value = \"k*X\", key = \"free\" }\n";
    let solution = solved(&format!("{OSCILLATOR}{asks}"));
    assert_eq!(shown(&solution, "chosen"), "74.137 N");
    assert_eq!(shown(&solution, "free"), "16.667 lbf");
}

#[test]
fn a_file_keeps_its_setting() {
    for setting in UnitSetting::ALL {
        let set = with(OSCILLATOR, &[("\n[inputs]", &format!("units = \"{setting}\" # set\n\n[inputs]"))]);
        let problem = file::parse(&set).unwrap();
        assert_eq!(problem.units, setting);
        assert_eq!(file::write(&problem, &set), set);
        // Written into a file that has none: left out where it is the usual one.
        let written = file::write(&problem, OSCILLATOR);
        assert_eq!(file::parse(&written).unwrap().units, setting);
        assert_eq!(written == OSCILLATOR, setting == UnitSetting::Auto);
    }
    let renamed = with(OSCILLATOR, &[("\n[inputs]", "units = \"mm N s\"\n\n[inputs]")]);
    assert_eq!(system(&renamed), Some(UnitSystem::MillimetreTonne));
}

#[test]
fn a_wrong_setting_is_named_with_its_place() {
    let wrong = with(OSCILLATOR, &[("\n[inputs]", "units = \"cgs\"\n\n[inputs]")]);
    let errors = file::parse(&wrong).unwrap_err();
    assert_eq!(errors.len(), 1);
    assert_eq!(
        errors[0].why.english(),
        "`cgs` is no system of units; write one of auto, SI, in-lbf-s, ft-slug-s, mm-t-s, as-typed"
    );
    assert_eq!(&wrong[errors[0].span.clone().unwrap()], "\"cgs\"");
}

#[test]
fn the_schema_knows_the_settings() {
    let (printed, _) = run(&["schema", "vibration/harmonic-force"]);
    let schema: serde_json::Value = serde_json::from_str(&printed).unwrap();
    let known = serde_json::json!(["auto", "SI", "in-lbf-s", "ft-slug-s", "mm-t-s", "as-typed"]);
    assert_eq!(schema["properties"]["units"]["enum"], known);
}

/// A file of the first format is shown as it was.
#[test]
fn a_file_of_the_first_format_keeps_its_units() {
    let first = with(OSCILLATOR, &[("format = 2\n", "")]);
    let problem = file::parse(&first).unwrap();
    assert_eq!(problem.units, UnitSetting::AsTyped);
    let notes: Vec<String> = problem.notes.iter().map(Text::english).collect();
    let note = "units omitted: as-typed assumed, the default of files without `format = 2`";
    assert!(notes.iter().any(|known| known == note), "{notes:?}");
    assert_eq!(shown(&solved(&first), "amplitude"), "2.1167 mm");
    assert_eq!(file::parse(&file::write(&problem, &first)).unwrap().units, UnitSetting::AsTyped);
    // Where there is no difference there is nothing to say.
    let metric = with(&first, &[("10 lbf", "10 N")]);
    assert_eq!(file::parse(&metric).unwrap().units, UnitSetting::Auto);
}

/// A cantilever with k = 3EI/L³, of which each number on the page can be put into the formula.
#[test]
fn a_printed_page_follows_the_system_that_is_asked_for() {
    let fan = ["solve", "vibration/rotating-unbalance", "--ascii", "--units"];
    for (units, wanted) in [
        (
            "in-lbf-s",
            &[
                "Units: in*lbf*s",
                "Mass of the machine m = 40 kg = 0.22841 lbf*s^2/in",
                "Stiffness of the support 2577.5 lbf/in",
                "= 3 * 2.9008e7 lbf/in^2 * 3.1233 in^4 / (47.244 in)^3",
                "= sqrt(2577.5 lbf/in / 0.22841 lbf*s^2/in)",
                "Force transmitted to the foundation 1988.9 lbf",
            ][..],
        ),
        (
            "mm-t-s",
            &[
                "Stiffness of the support 451.39 N/mm",
                "= 3 * 2e5 N/mm^2 * 1.3e6 mm^4 / (1200 mm)^3",
                "Mass of the machine m = 40 kg = 0.04 t",
            ],
        ),
        (
            "SI",
            &[
                "Stiffness of the support 4.5139e5 N/m",
                "Young's modulus E = 200 kN/mm^2 = 2e11 Pa",
                "Amplitude at this speed 0.019456 m",
            ],
        ),
        ("ft-slug-s", &["Stiffness of the support 30930 lbf/ft", "Amplitude at this speed 0.063833 ft"]),
    ] {
        let (printed, said) = run(&[&fan[..], &[units]].concat());
        assert_eq!(said, "");
        has(&printed, wanted);
        // Speeds stay in the unit that the analysis gives them.
        has(&printed, &["Peak-response speed 1018.3 rpm", "Speed of the machine omega = 1000 rpm"]);
    }
    let (found, _) = run(&["solve", "vibration/harmonic-force", "--case", "1", "--ascii"]);
    has(
        &found,
        &["Units: in*lbf*s, found from the inputs", "Weight W = 193.0443 lbf", "Amplitude 0.083333 in"],
    );
    let (typed, _) =
        run(&["solve", "vibration/harmonic-force", "--case", "1", "--units", "as-typed", "--ascii"]);
    has(&typed, &["Amplitude 2.1167 mm"]);
    assert!(!typed.contains("Units:"), "{typed}");
    let (_, said) = run(&[&fan[..], &["cgs"]].concat());
    assert!(said.contains("`cgs` is no system of units"), "{said}");
    let (portuguese, _) = run(&["solve", "vibration/harmonic-force", "--case", "1", "--lang", "pt-BR"]);
    has(&portuguese, &["Unidades: in·lbf·s, reconhecidas nos dados"]);
}

#[test]
fn a_unit_is_chosen_for_a_family_of_answers() {
    let train = ["solve", "vibration/torsional-train", "--case", "1", "--format", "json"];
    let units = |more: &[&str]| {
        let (printed, said) = run(&[&train[..], more].concat());
        let json: serde_json::Value = serde_json::from_str(&printed).unwrap_or_else(|_| panic!("{said}"));
        ["frequency[1]", "frequency[2]", "node[1][1]", "node[2][1]", "node[2][2]"]
            .map(|answer| json["answers"][answer]["unit"].as_str().unwrap_or("none").to_owned())
    };
    assert_eq!(units(&[]), ["Hz", "Hz", "in", "in", "in"]);
    assert_eq!(units(&["--unit", "node=mm"]), ["Hz", "Hz", "mm", "mm", "mm"]);
    assert_eq!(units(&["--unit", "node[2]=ft"]), ["Hz", "Hz", "in", "ft", "ft"]);
    // The closer name wins, wherever it stands.
    let closer =
        ["--unit", "node[2][1]=m", "--unit", "node[2]=ft", "--unit", "node=mm", "--unit", "length=cm"];
    assert_eq!(units(&closer), ["Hz", "Hz", "mm", "m", "ft"]);
    // A word, and a quantity.
    assert_eq!(units(&["--unit", "natural=rpm"]), ["rpm", "rpm", "in", "in", "in"]);
    assert_eq!(units(&["--unit", "angular velocity=rad/s"]), ["rad/s", "rad/s", "in", "in", "in"]);
    assert_eq!(units(&["--unit", "length=yd"]), ["Hz", "Hz", "yd", "yd", "yd"]);
}

#[test]
fn a_unit_that_fits_no_answer_is_refused_with_the_answers() {
    let fan = ["solve", "vibration/rotating-unbalance", "--unit"];
    for (asked, wanted) in [
        ("amplitude=N", "amplitude cannot be shown in N; write a unit like mm"),
        ("force=mm", "none of the answers of `force` can be shown in mm: transmitted_force (N)"),
        ("warmth=K", "no answer `warmth`; use one of amplitude, "),
    ] {
        let (printed, said) = run(&[&fan[..], &[asked]].concat());
        assert_eq!(printed, "", "{asked}");
        assert!(said.contains(wanted), "{asked}: {said}");
    }
}

#[test]
fn the_workbench_goes_through_the_systems() {
    let mut person = Person::at(120, 40).opens("vibration/rotating-unbalance");
    let mut seen = |keys: &str| person.types(keys).sees().split_whitespace().collect::<Vec<_>>().join(" ");
    for (keys, system, stiffness) in [
        ("", None, "451.39 kN/m"),
        ("V", Some("Units: SI"), "4.5139×10⁵ N/m"),
        ("V", Some("Units: in·lbf·s"), "2577.5 lbf/in"),
        ("V", Some("Units: ft·slug·s"), "30930 lbf/ft"),
        ("V", Some("Units: mm·t·s"), "451.39 N/mm"),
        ("V", None, "451.39 kN/m"),
        ("V", None, "451.39 kN/m"),
    ] {
        let screen = seen(keys);
        assert!(screen.contains(stiffness), "{stiffness}: {screen}");
        assert_eq!(screen.contains("Units:"), system.is_some(), "{screen}");
        assert!(system.is_none_or(|system| screen.contains(system)), "{screen}");
    }
    // US customary units are found.
    let found = Person::in_portuguese(120, 40).opens("vibration/piecewise-spring").sees();
    assert!(found.contains("Unidades: in·lbf·s, reconhecidas nos dados"), "{found}");
}

#[test]
fn the_workbench_saves_the_setting() {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("units.toml");
    fs::write(&path, OSCILLATOR).unwrap();
    let mut person = Person::at(120, 40).opens_file(&path);
    assert!(person.sees().contains("Units: in·lbf·s, found from the inputs"), "{}", person.sees());
    person.types("V").types("s");
    assert!(fs::read_to_string(&path).unwrap().contains("units = \"SI\"\n"));
    let again = Person::at(120, 40).opens_file(&path).sees();
    assert!(again.contains("Units: SI") && again.contains("0.0021167 m"), "{again}");
}
