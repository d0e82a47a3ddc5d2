//! Unknown inputs found from given answers, on a small analysis with closed forms.

use dalembert_core::{
    About, Analysis, Determined, Draft, Entry, FieldError, Inputs, Locale, Refusal, Solution, SolveError,
    Source, Stop, Worksheet, file, printer, register, vary,
};
use dalembert_numerics::Real;
use itertools::Itertools as _;

/// A mass on a spring under a harmonic force, and a ball thrown.
#[derive(Clone, Debug, Inputs)]
pub struct Exercise {
    /// Mass.
    #[input("m", "kg", positive)]
    pub mass: f64,
    /// Stiffness.
    #[input("k", "N/m", positive)]
    pub stiffness: f64,
    /// Force amplitude.
    #[input("F", "N")]
    pub force: f64,
    /// Angular frequency of the force.
    #[input("ω", "rad/s", nonnegative)]
    pub speed: f64,
    /// Velocity of the ball.
    #[input("v", "m/s", nonnegative, default = "10 m/s")]
    pub velocity: f64,
    /// Angle of the throw.
    #[input("θ", "deg", default = "30 deg")]
    pub angle: f64,
    /// Number of springs.
    #[input("n", default = "1")]
    pub springs: u64,
}

static BOOK: Source = Source { short: "Book", full: "A book" };

const CASES: &str = r#"
[[case]]
name = "First"
source = "Book, 1.1"
seen = "book"
[case.inputs]
mass = "2 kg"
stiffness = "800 N/m"
force = "10 N"
speed = "10 rad/s"
[case.expect]
natural_frequency = "20 rad/s"
"#;

register!(Exercise);

impl Analysis for Exercise {
    const ABOUT: About = About {
        id: "test/exercise",
        title: "Exercise",
        topic: "Tests",
        summary: "An exercise.",
        main: &[],
        keywords: "",
        sources: &[&BOOK],
        cases: CASES,
    };

    fn solve<W: Worksheet>(&self, given: &ExerciseGiven<W>, sheet: W) -> Result<(), Refusal> {
        let natural = sheet.step("ω_n", "rad/s", (given.stiffness / given.mass).sqrt(), "Natural frequency");
        let dynamic = given.stiffness - given.mass * given.speed.powi(2);
        if dynamic.value() == 0.0 {
            return Err(Refusal::because("resonance without damping"));
        }
        let amplitude = sheet.step("X", "mm", given.force / dynamic, "Amplitude");
        let gravity = sheet.constant(9.81, &dalembert_units::unit("m/s^2").expect("it is a unit"));
        let range = given.velocity.powi(2) * (given.angle * W::Num::from(2.0)).sin() / gravity;
        let range = sheet.step("R", "m", range, "Range of the throw");
        let static_deflection =
            sheet.step("δ", "mm", given.mass * gravity / given.stiffness, "Static deflection");
        sheet.answer("natural_frequency", "Natural frequency", natural);
        sheet.answer("amplitude", "Amplitude", amplitude);
        sheet.answer("range", "Range", range);
        sheet.answer("static_deflection", "Static deflection", static_deflection);
        Ok(())
    }
}

fn entry() -> Entry {
    Entry::of::<Exercise>()
}

/// The problem of the first case with other inputs, definitions and given answers, as a file has them.
fn problem(tables: &str) -> Result<Solution, SolveError> {
    let text = format!("format = 2\nanalysis = \"test/exercise\"\n{tables}");
    let problem = file::parse(&text).expect("the file can be read");
    let record = problem.draft.read(&entry().shape()).map_err(SolveError::Fields)?;
    entry().solve(&record, &Stop::new())
}

/// The inputs of the first case but for those named.
fn inputs(changes: &[(&str, &str)]) -> String {
    let mut all = vec![("mass", "2 kg"), ("stiffness", "800 N/m"), ("force", "10 N"), ("speed", "10 rad/s")];
    for (name, text) in changes {
        all.retain(|(known, _)| known != name);
        all.push((name, text));
    }
    let lines = all.iter().map(|(name, text)| format!("{name} = \"{text}\"\n"));
    format!("[inputs]\n{}", lines.collect::<String>())
}

fn given(values: &[(&str, &str)]) -> String {
    let lines = values.iter().map(|(name, text)| format!("\"{name}\" = \"{text}\"\n"));
    format!("[given]\n{}", lines.collect::<String>())
}

fn found(solution: &Solution) -> &Determined {
    assert_eq!(solution.defects, [] as [String; 0]);
    assert!(solution.checks.iter().all(|check| check.passed), "{:?}", solution.checks);
    solution.determined.as_deref().expect("something was unknown")
}

fn close(found: f64, wanted: f64, share: f64) {
    assert!((found - wanted).abs() <= share * wanted.abs(), "{found} is not {wanted}");
}

fn errors(result: Result<Solution, SolveError>) -> Vec<String> {
    match result {
        Err(SolveError::Fields(errors)) => errors.iter().map(FieldError::to_string).collect(),
        Err(SolveError::Refused(refusal)) => vec![refusal.to_string()],
        Ok(_) => Vec::new(),
    }
}

#[test]
fn one_unknown_is_found_and_comes_first() {
    let solution = problem(&(inputs(&[("mass", "?")]) + &given(&[("natural_frequency", "5 Hz")])))
        .expect("it has a solution");
    let mass = 800.0 / (10.0 * std::f64::consts::PI).powi(2);
    let determined = found(&solution);
    assert_eq!(determined.solutions.len(), 1);
    close(determined.solutions[0][0], mass, 1e-11);
    assert_eq!(solution.answers[0].name.to_string(), "mass");
    close(solution.answers[0].si().unwrap(), mass, 1e-11);
    // A thousandth to a thousand times the mass of the first case.
    assert_eq!(determined.unknowns[0].range, [0.002, 2000.0]);
    assert!(solution.steps[0].why.english().starts_with(
        "Mass is unknown: its formula follows from Natural frequency = 5 Hz; all solutions from"
    ));
    assert!(solution.checks.iter().any(|check| check.what.english() == "Natural frequency is the given one"));
}

#[test]
fn an_assumed_range_is_widened_where_nothing_is_in_it() {
    for (frequency, range) in [(5e-3, [2e-6, 2e6]), (500.0, [2e-6, 2e6])] {
        let given = given(&[("natural_frequency", &format!("{frequency} Hz"))]);
        let solution = problem(&(inputs(&[("mass", "?")]) + &given)).expect("it has a solution");
        let determined = found(&solution);
        close(determined.solutions[0][0], 800.0 / (2.0 * std::f64::consts::PI * frequency).powi(2), 1e-9);
        for (found, wanted) in determined.unknowns[0].range.into_iter().zip_eq(range) {
            close(found, wanted, 1e-12);
        }
    }
    // A range that was typed is not.
    let typed = inputs(&[("mass", "? 1 kg .. 10 kg")]) + &given(&[("natural_frequency", "5 mHz")]);
    assert!(problem(&typed).is_err());
}

/// The first step: what was unknown, by its formula, and what is said of it.
fn first_step(solution: &Solution) -> (String, String) {
    let step = printer::step(solution, &solution.steps[0], &Locale::english());
    (format!("{} = {}", step.symbol, step.formula), step.why)
}

#[test]
fn an_unknown_has_the_formula_that_the_answer_leads_back_to() {
    // Unknown, given answer, formula, solutions, and what is said of its branches.
    type Solutions = Vec<f64>;
    let root = |x: f64| x.sqrt();
    let cases: [(&str, &str, (&str, &str), &str, Solutions, &str); 8] = [
        ("mass", "?", ("natural_frequency", "20 rad/s"), "m = k / ω_n²", vec![2.0], ""),
        ("stiffness", "?", ("natural_frequency", "5 rad/s"), "k = m ω_n²", vec![50.0], ""),
        ("stiffness", "?", ("static_deflection", "9.81 mm"), "k = m 9.81 m/s² / δ", vec![2000.0], ""),
        ("force", "? -1 kN .. 1 kN", ("amplitude", "10 mm"), "F = (k − m ω²) X", vec![6.0], ""),
        ("stiffness", "? 1 N/m .. 1 kN/m", ("amplitude", "50 mm"), "k = F / X + m ω²", vec![400.0], ""),
        (
            "speed",
            "? 0 .. 100 rad/s",
            ("amplitude", "25 mm"),
            "ω = √((k − F / X) / m)",
            vec![root(200.0)],
            "",
        ),
        (
            "velocity",
            "? 0 .. 50 m/s",
            ("range", "8 m"),
            "v = √(9.81 m/s² R / sin(2 θ))",
            vec![root(8.0 * 9.81 / root(0.75))],
            "",
        ),
        (
            "angle",
            "? 0 .. 90 deg",
            ("range", "5 m"),
            "θ = arcsin(9.81 m/s² R / v²) / 2",
            vec![0.4905f64.asin() / 2.0, (std::f64::consts::PI - 0.4905f64.asin()) / 2.0],
            "with the angles of the arcsine",
        ),
    ];
    for (input, text, answer, formula, solutions, branches) in cases {
        let solution = problem(&(inputs(&[(input, text)]) + &given(&[answer]))).expect("it has a solution");
        let determined = found(&solution);
        assert!(determined.has_all(), "{input} from {answer:?}");
        let found: Vec<f64> = determined.solutions.iter().map(|one| one[0]).collect();
        found.iter().zip_eq(solutions).for_each(|(found, wanted)| close(*found, wanted, 1e-12));
        let (written, why) = first_step(&solution);
        assert_eq!(written, formula, "{input} from {answer:?}");
        assert!(why.contains("its formula follows from") && why.contains("all solutions from"), "{why}");
        assert!(why.contains(branches), "{why}");
        assert_eq!(why.contains(" with "), !branches.is_empty(), "{why}");
        let what = "by its formula is the solution of the search";
        assert!(solution.checks.iter().any(|check| check.what.english().ends_with(what)));
    }
}

#[test]
fn both_signs_of_a_root_are_solutions_where_the_range_has_them() {
    let text = inputs(&[("speed", "10 rad/s")])
        + "[let]\noffset = \"? -3 m .. 3 m\"\n[ask]\ndistance = \"sqrt(offset^2 + (1 m)^2)\"\n"
        + &given(&[("distance", "2 m")]);
    let solution = problem(&text).expect("it has solutions");
    let determined = found(&solution);
    assert!(determined.has_all());
    let solutions: Vec<f64> = determined.solutions.iter().map(|one| one[0]).collect();
    solutions.iter().zip_eq([-(3f64.sqrt()), 3f64.sqrt()]).for_each(|(found, x)| close(*found, x, 1e-12));
    let (written, why) = first_step(&solution);
    assert!(written.starts_with("offset = −√("), "{written}");
    assert!(why.contains("with both signs of the root: 2"), "{why}");
}

#[test]
fn a_formula_stands_behind_the_steps_that_it_needs() {
    // The stiffness is a formula of two definitions; it is a step once, before that of the mass.
    let text = inputs(&[("mass", "?"), ("stiffness", "2*a + b")])
        + "[let]\na = \"300 N/m\"\nb = \"2*c\"\nc = \"100 N/m\"\n"
        + &given(&[("natural_frequency", "20 rad/s")]);
    let solution = problem(&text).expect("it has a solution");
    assert!(found(&solution).has_all());
    let steps: Vec<String> = solution.steps.iter().map(|step| printer::symbol(&step.symbol)).collect();
    assert_eq!(steps[..4], ["b", "k", "m", "ω_n"], "{steps:?}");
    assert_eq!(steps.iter().filter(|symbol| *symbol == "k").count(), 1);
    close(found(&solution).solutions[0][0], 2.0, 1e-12);
}

#[test]
fn an_unknown_on_two_paths_is_found_by_the_search() {
    // The amplitude at a stiffness that is 100/s² of the mass: F/(m (100 − ω²)) by two paths.
    let text =
        inputs(&[("mass", "?"), ("stiffness", "400*mass/(1 s)^2")]) + &given(&[("amplitude", "10 mm")]);
    let solution = problem(&text).expect("it has a solution");
    let determined = found(&solution);
    assert!(!determined.has_all());
    close(determined.solutions[0][0], 10.0 / 300.0 / 0.01, 1e-9);
    assert!(first_step(&solution).1.contains("found from Amplitude"), "{}", first_step(&solution).1);
}

#[test]
fn every_solution_in_the_range_is_found() {
    // A range of 7 m of a throw with 10 m/s: a low and a high angle.
    let solution =
        problem(&(inputs(&[("angle", "?")]) + &given(&[("range", "7 m")]))).expect("it has solutions");
    let low = (7.0f64 * 9.81 / 100.0).asin() / 2.0;
    let high = std::f64::consts::FRAC_PI_2 - low;
    let solutions: Vec<f64> = found(&solution).solutions.iter().map(|one| one[0]).collect();
    // A whole turn has each of them twice.
    let wanted = [low - std::f64::consts::PI, high - std::f64::consts::PI, low, high];
    assert_eq!(solutions.len(), 4, "{solutions:?}");
    solutions.iter().zip_eq(wanted).for_each(|(found, wanted)| close(*found, wanted, 1e-11));
    assert!(
        solution
            .warnings
            .iter()
            .any(|text| text.english().starts_with("4 solutions in the range searched: (1)"))
    );

    let narrow = inputs(&[("angle", "? 0 .. 45 deg")]) + &given(&[("range", "7 m")]);
    let solution = problem(&narrow).expect("it has a solution");
    assert_eq!(found(&solution).solutions.len(), 1);
    close(found(&solution).solutions[0][0], low, 1e-11);
    assert_eq!(solution.warnings, []);
}

#[test]
fn a_value_that_is_only_touched_is_found() {
    // The farthest throw: sin 2θ = 1.
    let range = format!("{} m", 100.0 / 9.81);
    let text = inputs(&[("angle", "? 0 .. 80 deg")]) + &given(&[("range", &range)]);
    let solution = problem(&text).expect("it has a solution");
    assert_eq!(found(&solution).solutions.len(), 1);
    close(found(&solution).solutions[0][0], std::f64::consts::FRAC_PI_4, 1e-4);
}

#[test]
fn a_pole_is_no_solution() {
    // The amplitude F/(k − mω²) changes its sign at k = 200 N/m by a pole; it is 50 mm at 400 N/m alone.
    let text = inputs(&[("stiffness", "? 1 N/m .. 1 kN/m")]) + &given(&[("amplitude", "50 mm")]);
    let solution = problem(&text).expect("it has a solution");
    assert_eq!(found(&solution).solutions.len(), 1);
    close(found(&solution).solutions[0][0], 400.0, 1e-11);
}

#[test]
fn several_unknowns_are_found_together() {
    let text = inputs(&[("mass", "?"), ("stiffness", "?"), ("force", "? 1 N .. 1 kN")])
        + &given(&[("natural_frequency", "40 rad/s"), ("amplitude", "5 mm"), ("k*F", "6 kN^2/m")])
        + "[ask]\n\"k*F\" = \"k*F\"\n";
    let solution = problem(&text).expect("it has a solution");
    // k = 1600 m, F = 0.005 (k − 100 m) = 7.5 m, k F = 12000 m² = 6e6.
    let mass = 500f64.sqrt();
    let determined = found(&solution);
    assert_eq!(determined.solutions.len(), 1, "{:?}", determined.solutions);
    for (found, wanted) in determined.solutions[0].iter().zip_eq([mass, 1600.0 * mass, 7.5 * mass]) {
        close(*found, wanted, 1e-8);
    }
    let names: Vec<String> = solution.answers.iter().take(3).map(|answer| answer.name.to_string()).collect();
    assert_eq!(names, ["mass", "stiffness", "force"]);
}

#[test]
fn more_given_answers_than_unknowns_are_fitted_by_least_squares() {
    // δ = g/ωₙ²: the two given values contradict each other a little.
    let text = inputs(&[("mass", "?")])
        + &given(&[("natural_frequency", "20 rad/s ± 0.1"), ("static_deflection", "24 mm ± 0.5 mm")]);
    let solution = problem(&text).expect("it has a solution");
    let determined = found(&solution);
    let (mass, error) = (determined.solutions[0][0], determined.unknowns[0].uncertainty.unwrap());
    // The gradient of the weighted sum of squares vanishes.
    let residuals = [((800.0 / mass).sqrt() - 20.0) / 0.1, (mass * 9.81 / 800.0 - 0.024) / 0.0005];
    let rates = [-0.5 * (800.0 / mass).sqrt() / mass / 0.1, 9.81 / 800.0 / 0.0005];
    let gradient = residuals[0] * rates[0] + residuals[1] * rates[1];
    assert!(gradient.abs() < 1e-5, "{gradient}");
    close(error, 1.0 / rates[0].hypot(rates[1]), 1e-6);
    // The uncertainty of one unknown from one answer: 2 m σ/ωₙ.
    let text = inputs(&[("mass", "?")]) + &given(&[("natural_frequency", "20 rad/s ± 0.1")]);
    let solution = problem(&text).expect("it has a solution");
    close(found(&solution).unknowns[0].uncertainty.unwrap(), 2.0 * 2.0 * 0.1 / 20.0, 1e-6);
}

#[test]
fn a_definition_may_be_unknown_and_a_question_given() {
    let text = "[let]\nd = \"? 1 mm .. 1 m\"\nrho = \"7850 kg/m^3\"\n".to_owned()
        + &inputs(&[("mass", "rho*pi/6*d^3")])
        + &given(&[("twice", "40 rad/s")])
        + "[ask]\n\"twice the frequency\" = { value = \"2*omega_n\", key = \"twice\" }\n";
    let solution = problem(&text).expect("it has a solution");
    close(found(&solution).solutions[0][0], (6.0 * 2.0 / 7850.0 / std::f64::consts::PI).cbrt(), 1e-11);
    assert_eq!(solution.answers[0].name.to_string(), "d");
    let in_words = text.replace("\"twice\" =", "\"twice the frequency\" =");
    assert_eq!(found(&problem(&in_words).expect("it has a solution")).solutions, found(&solution).solutions);
}

#[test]
fn an_unknown_follows_the_other_inputs_in_a_sweep() {
    let text = inputs(&[("mass", "?")]) + &given(&[("natural_frequency", "20 rad/s")]);
    let problem =
        file::parse(&format!("analysis = \"test/exercise\"\n{text}")).expect("the file can be read");
    let record = problem.draft.read(&entry().shape()).expect("the inputs are right");
    assert!(vary::inputs(&record).iter().all(|input| input.path != "mass"), "what is unknown is not varied");
    let wanted = ["mass", "natural_frequency", "static_deflection"];
    let mut reading = entry().prepare(&record, &["stiffness"], &wanted).expect("it can be prepared");
    let mut answers = [0.0; 6];
    reading.sweep(&[400.0, 1600.0], &mut answers, &Stop::new()).expect("nobody stops it");
    for (row, stiffness) in answers.chunks(3).zip_eq([400.0, 1600.0]) {
        close(row[0], stiffness / 400.0, 1e-11);
        close(row[1], 20.0, 1e-11);
        close(row[2], 9.81 / 400.0, 1e-11);
    }
}

#[test]
fn what_cannot_be_found_is_said_with_its_reason() {
    let mass = inputs(&[("mass", "?")]);
    for (text, wanted) in [
        (mass.clone(), "mass: more unknowns (1) than given answers (0): give another answer"),
        (inputs(&[]) + &given(&[("range", "7 m")]), "given[1].name: nothing is unknown: write ?"),
        (
            mass.clone() + &given(&[("range", "7 m")]),
            "given[1].name: Range does not depend on what is unknown",
        ),
        (
            mass.clone() + &given(&[("frequency", "7 Hz")]),
            "no answer `frequency` with a single number; the answers are natural_frequency, amplitude",
        ),
        (
            mass.clone() + &given(&[("natural_frequency", "7 kg")]),
            "given[1].value: `7 kg` is a mass; an angular velocity expected",
        ),
        (
            mass.clone() + &given(&[("natural_frequency", "1 mHz")]),
            "the answer lies between 100.66 mHz (at 2000 kg)",
        ),
        (inputs(&[("angle", "?")]) + &given(&[("range", "70 m")]), "(at 45°)"),
        (
            inputs(&[("mass", "? 10 kg .. 1 kg")]) + &given(&[("natural_frequency", "1 Hz")]),
            "the range of an unknown ascends",
        ),
        (
            inputs(&[("mass", "? -1 kg .. 1 kg")]) + &given(&[("natural_frequency", "1 Hz")]),
            "mass: must be above zero",
        ),
        (
            inputs(&[("springs", "?")]) + &given(&[("natural_frequency", "1 Hz")]),
            "springs: only a quantity can be unknown",
        ),
        (
            "[let]\nd = \"?\"\n".to_owned() + &mass + &given(&[("range", "1 m"), ("amplitude", "1 mm")]),
            "let[1].formula: write a range",
        ),
        (
            inputs(&[("mass", "?"), ("stiffness", "?")])
                + &given(&[
                    ("natural_frequency", "20 rad/s"),
                    ("static_deflection", &format!("{} mm", 9810.0 / 400.0)),
                ]),
            "do not determine mass, stiffness separately",
        ),
        (
            inputs(&[("mass", "?"), ("stiffness", "?")])
                + &given(&[("natural_frequency", "20 rad/s"), ("static_deflection", "30 mm")]),
            "no solution in the ranges searched; the nearest: Natural frequency = ",
        ),
    ] {
        let errors = errors(problem(&text));
        assert!(errors.iter().any(|error| error.contains(wanted)), "{text}: {errors:?}");
    }
}

#[test]
fn given_answers_are_written_as_they_were_read() {
    let text = "format = 2\nanalysis = \"test/exercise\"\n\n".to_owned()
        + &inputs(&[
            ("mass", "? 1 kg .. 9 kg"),
            ("velocity", "10 m/s"),
            ("angle", "30 deg"),
            ("springs", "1"),
        ])
        + "\n[given] # measured\nnatural_frequency = \"8.2 Hz ± 0.05\"\n";
    let problem = file::parse(&text).expect("the file can be read");
    assert_eq!(file::write(&problem, &text), text);
    let mut typed = Draft::blank(&entry().shape());
    typed.give(&entry().shape(), "natural_frequency", "8.2 Hz").expect("it can be given");
    typed.give(&entry().shape(), "natural_frequency", "8.3 Hz").expect("it can be given another value");
    let (rows, _) = typed.at(&entry().shape(), "given").expect("given answers are a list");
    assert!(matches!(rows, Draft::Rows(rows) if rows.len() == 1));
}

#[test]
fn a_value_computed_forwards_is_found_backwards() {
    // Masses over five decades, by an answer that falls and one that has a pole.
    for n in 0..40 {
        let mass = 0.003 * 1.4f64.powi(n);
        let forwards = problem(&inputs(&[("mass", &format!("{mass} kg"))])).expect("it has an answer");
        for name in ["natural_frequency", "amplitude", "static_deflection"] {
            let answer = forwards.answer(name).unwrap();
            let value = format!("{} {}", answer.unit.value(answer.si().unwrap()), answer.unit.ascii());
            let text = inputs(&[("mass", "?")]) + &given(&[(name, &value)]);
            let solution = problem(&text).unwrap_or_else(|error| panic!("{name} = {value}: {error}"));
            assert_eq!(found(&solution).solutions.len(), 1, "{name} = {value}");
            close(found(&solution).solutions[0][0], mass, 1e-7);
        }
    }
}
