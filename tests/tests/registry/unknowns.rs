//! Unknown inputs and given answers: a round trip over the registry, and questions in which known and unknown change
//! places.

use dalembert_core::{
    Answer, Determined, Draft, Entry, Solution, Stop, cases, file, find, printer, registry,
};
use dalembert_plugins as _;
use dalembert_testkit::{on_all_cores, unknowns};
use itertools::Itertools as _;

use crate::{number, solved};

/// A question: the first case of an analysis with other inputs, some of them unknown, and the answers that are given.
struct Question {
    id: &'static str,
    inputs: &'static [(&'static str, &'static str)],
    given: &'static [(&'static str, &'static str)],
    /// Every solution in the range, in the units of the unknowns, where a formula gives it; else that of a scan counts.
    solutions: &'static [&'static [&'static str]],
}

const fn question(
    id: &'static str,
    inputs: &'static [(&'static str, &'static str)],
    given: &'static [(&'static str, &'static str)],
    solutions: &'static [&'static [&'static str]],
) -> Question {
    Question { id, inputs, given, solutions }
}

static QUESTIONS: [Question; 38] = [
    // k = m ω².
    question(
        "vibration/free-vibration",
        &[
            ("oscillator.translation.mass.mass.mass", "5 kg"),
            ("oscillator.translation.stiffness.stiffness.stiffness", "?"),
        ],
        &[("natural_frequency", "40 rad/s")],
        &[&["8000 N/m"]],
    ),
    question(
        "vibration/free-vibration",
        &[("oscillator.translation.damping.coefficient.coefficient", "?")],
        &[("decrement", "0.5")],
        &[],
    ),
    question(
        "vibration/free-vibration",
        &[("oscillator.translation.velocity", "? 0 m/s .. 20 m/s")],
        &[("maximum", "100 mm")],
        &[],
    ),
    // m = c_c/(2 ω), k = ω c_c/2.
    question(
        "vibration/free-vibration",
        &[
            ("oscillator.translation.mass.mass.mass", "?"),
            ("oscillator.translation.stiffness.stiffness.stiffness", "?"),
        ],
        &[("natural_frequency", "20 rad/s"), ("critical_damping", "400 N*s/m")],
        &[&["10 kg", "4000 N/m"]],
    ),
    question("vibration/harmonic-force", &[("frequency", "?")], &[("amplitude", "2 mm")], &[]),
    // At resonance X = F/(c ω).
    question(
        "vibration/harmonic-force",
        &[
            ("mass.weight.weight", "9.81 N"),
            ("mass.weight.gravity", "9.81 m/s^2"),
            ("elasticity.stiffness.stiffness", "400 N/m"),
            ("frequency", "20 rad/s"),
            ("excitation.force.force", "10 N"),
            ("damping.coefficient.coefficient", "?"),
        ],
        &[("amplitude", "25 mm")],
        &[&["20 N*s/m"]],
    ),
    question(
        "vibration/harmonic-force",
        &[("excitation.force.force", "?")],
        &[("transmitted_force", "200 N")],
        &[],
    ),
    question(
        "vibration/harmonic-force",
        &[("elasticity.stiffness.stiffness", "?"), ("damping.coefficient.coefficient", "?")],
        &[("amplitude", "2.5 mm"), ("phase", "60 deg")],
        &[],
    ),
    question("vibration/base-excitation", &[("base.road.speed", "?")], &[("amplitude", "150 mm")], &[]),
    question(
        "vibration/base-excitation",
        &[("elasticity.static-deflection.deflection", "?")],
        &[("acceleration", "8 m/s^2")],
        &[],
    ),
    question("vibration/drop-impact", &[("fall.height.height", "?")], &[("force", "6 kN")], &[]),
    question(
        "vibration/drop-impact",
        &[("elasticity.stiffness.stiffness", "?")],
        &[("deflection", "200 mm")],
        &[],
    ),
    question(
        "vibration/logarithmic-decrement",
        &[("decay.amplitudes.amplitudes.amplitude_ratio", "?")],
        &[("damping_ratio", "0.1")],
        &[],
    ),
    question(
        "vibration/whirling-shaft",
        &[("shaft.round.diameter", "?")],
        &[("critical_speed", "1500 rpm")],
        &[],
    ),
    question("vibration/whirling-shaft", &[("speed.given.speed", "?")], &[("amplitude", "20 mm")], &[]),
    question(
        "vibration/vibration-absorber",
        &[("problem.translation.absorber.stroke.stroke", "?")],
        &[("absorber_mass", "20 kg")],
        &[],
    ),
    // v = ω x.
    question(
        "vibration/gun-recoil",
        &[("mass.mass.mass", "600 kg"), ("recoil.distance.distance", "1.2 m"), ("stiffness", "?")],
        &[("speed", "24 m/s")],
        &[&["240 kN/m"]],
    ),
    question("vibration/large-pendulum", &[("amplitude", "? 1 deg .. 179 deg")], &[("period", "3.5 s")], &[]),
    question("vibration/large-pendulum", &[("length", "?")], &[("period", "2 s")], &[]),
    // The fundamental frequency of a bar of a rectangular section is proportional to its height.
    question(
        "vibration/beam-vibration",
        &[("section.rectangle.height", "?")],
        &[("frequency[1]", "10 Hz")],
        &[],
    ),
    question(
        "vibration/string-rod-shaft",
        &[("body.string.tension", "?")],
        &[("frequency[1]", "440 Hz")],
        &[],
    ),
    question("vibration/coupled-pendulums", &[("spring", "?")], &[("frequency[2]", "50 rad/s")], &[]),
    question("vibration/rotating-unbalance", &[("speed", "?")], &[("amplitude", "5 mm")], &[]),
    question(
        "vibration/rotating-unbalance",
        &[("mass", "?"), ("unbalance", "?")],
        &[("natural_frequency", "8.2 Hz"), ("amplitude", "1 mm")],
        &[],
    ),
    question("virtual-work/slider-crank", &[("angle", "?")], &[("slider_position", "0.3 m")], &[]),
    question("virtual-work/slider-crank", &[("speed", "?")], &[("slider_velocity", "-3 m/s")], &[]),
    question("virtual-work/toggle-press", &[("angle", "? 1 deg .. 60 deg")], &[("thrust", "5 kN")], &[]),
    question(
        "virtual-work/screw-jack",
        &[("frame.scissors.angle", "? 5 deg .. 85 deg")],
        &[("axial_force", "20 kN")],
        &[],
    ),
    // h = 1.4 m sin θ.
    question(
        "virtual-work/scissor-lift",
        &[("angle", "? 1 deg .. 89 deg")],
        &[("height", "0.7 m")],
        &[&["30 deg"]],
    ),
    // x = r cos θ, twice in a turn.
    question(
        "virtual-work/scotch-yoke",
        &[("angle", "?")],
        &[("position", "40 mm")],
        &[&["-60 deg"], &["60 deg"]],
    ),
    question("virtual-work/scotch-yoke", &[("speed", "?")], &[("acceleration", "50 m/s^2")], &[]),
    question(
        "virtual-work/flywheel",
        &[("sought.fluctuation.inertia.gyration.mass", "?")],
        &[("fluctuation", "1 %")],
        &[],
    ),
    // The couple is proportional to the road speed.
    question(
        "rigid-body/gyroscopic-couple",
        &[("motion.steady-turn.speed", "?")],
        &[("couple", "30 kN*m")],
        &[],
    ),
    question("rigid-body/wheel-loads", &[("speed", "?")], &[("front_inner_load", "3 kN")], &[]),
    question("rigid-body/two-wheeler-lean", &[("motion.speed.speed", "?")], &[("lean", "45 deg")], &[]),
    question("rigid-body/edge-mill", &[("speed.shaft.speed", "?")], &[("crushing_force", "5 kN")], &[]),
    question("rigid-body/heavy-top", &[("motion.spin.spin", "?")], &[("slow_precession", "4 rad/s")], &[]),
    // U = G m.
    question("balancing/tolerance", &[("mass", "?")], &[("permissible", "40000 g*mm")], &[]),
];

/// Points of the scan that counts the solutions: ten times those of the search.
const SCAN: usize = 4000;

#[test]
fn an_input_is_found_back_from_an_answer() {
    let found = unknowns::an_input_is_found_back_from_an_answer(registry());
    assert!(found >= 110, "only {found} analyses were examined");
}

#[test]
fn known_and_unknown_change_places() {
    on_all_cores(&QUESTIONS, |_, question| {
        let entry = find(question.id).unwrap_or_else(|| panic!("there is no {}", question.id));
        let name = format!("{} {:?} {:?}", question.id, question.inputs, question.given);
        let solution = solve(entry, question).unwrap_or_else(|why| panic!("{name}: {why}"));
        assert!(solution.checks.iter().all(|check| check.passed), "{name}: {:?}", solution.checks);
        let determined = solution.determined.as_deref().expect("something is unknown");
        for given in &determined.givens {
            let share = (given.reached - given.given).abs() / given.given.abs();
            assert!(share <= 1e-9, "{name}: {} is missed by {share:e}", given.name);
        }
        if !question.solutions.is_empty() {
            assert_eq!(
                determined.solutions.len(),
                question.solutions.len(),
                "{name}: {:?}",
                determined.solutions
            );
            for (found, wanted) in determined.solutions.iter().zip_eq(question.solutions) {
                for (found, wanted) in found.iter().zip_eq(*wanted) {
                    let wanted = dalembert_units::read_any(wanted).expect("a quantity").si;
                    assert!((found - wanted).abs() <= 1e-9 * wanted.abs(), "{name}: {found}, not {wanted}");
                }
            }
        }
        if let [unknown] = &determined.unknowns[..] {
            let scanned = scan(entry, determined);
            let found: Vec<f64> = determined.solutions.iter().map(|solution| solution[0]).collect();
            assert_eq!(found.len(), scanned.len(), "{name}: {found:?}, and by a scan {scanned:?}");
            for (found, scanned) in found.iter().zip_eq(&scanned) {
                let width = unknown.range[1] - unknown.range[0];
                assert!(
                    (found - scanned).abs() <= 1e-6 * width.min(scanned.abs()),
                    "{name}: {found}, {scanned}"
                );
            }
        } else {
            assert_eq!(determined.solutions.len(), 1, "{name}: {:?}", determined.solutions);
        }
    });
}

/// A plate of 12 kg that a blow strikes: v = J/m, and about its diameters ω = (r × J)/I.
const STRUCK: &str = r#"format = 2
analysis = "rigid-body/impulse"

[inputs]
body.parts.parts = [{ name = "plate", shape.rectangular-plate = { a = "0.5 m", b = "0.3 m" }, amount.mass.mass = "12 kg" }]

[[inputs.blows]]
name = "blow"
point = ["0.25 m", "0.15 m", "0 m"]
strength.impulse.impulse = ["0 N*s", "0 N*s", "?"]

[ask]
v = "centre_velocity.z"

[given]
v = "-0.5 m/s"
"#;

/// The solution of a file with another text for the impulse, and other tables behind it.
fn struck(impulse: &str, tables: &str) -> Result<Solution, String> {
    let text = STRUCK.replace("[\"0 N*s\", \"0 N*s\", \"?\"]", impulse);
    let text = if tables.is_empty() {
        text
    } else {
        format!("{}{tables}", &text[..text.find("[ask]").expect("a table")])
    };
    let problem =
        file::parse(&text).map_err(|errors| errors.iter().map(|error| error.why.english()).join("; "))?;
    let written = file::write(&problem, &text);
    let line = text.lines().find(|line| line.starts_with("strength")).expect("the impulse");
    assert!(written.contains(line), "{written}");
    let record = problem.draft.read(&problem.entry.shape()).map_err(|errors| errors.iter().join("; "))?;
    problem.entry.solve(&record, &Stop::new()).map_err(|error| error.to_string())
}

#[test]
fn a_component_of_a_vector_is_found() {
    for impulse in [
        r#"["0 N*s", "0 N*s", "?"]"#,
        r#""(0; 0; ?) N*s""#,
        r#""(0, 0, ?) N*s""#,
        r#""0 i + ? k""#,
        r#""? k N*s""#,
        r#""(0; 0; ? -3 N*s) ""#,
        r#""(0; 0; ? -100 .. 100) N*s""#,
        r#""(0 N*s; 0 N*s; ? -100 .. 100 N*s)""#,
        r#""0 i + ? -100 .. 100 k N*s""#,
    ] {
        let solution = struck(impulse, "").unwrap_or_else(|why| panic!("{impulse}: {why}"));
        let determined = solution.determined.as_deref().expect("a component was unknown");
        let [found] = determined.solutions.iter().flatten().copied().collect_vec()[..] else {
            panic!("{impulse}: {:?}", determined.solutions)
        };
        assert!((found + 6.0).abs() < 1e-9, "{impulse}: {found}");
        assert_eq!(determined.unknowns[0].name, "blows[1].strength.impulse.impulse.z");
        assert_eq!(determined.unknowns[0].label.english(), "Impulse 1 z");
        let answer = solution.answer("blows[1].strength.impulse.impulse.z").and_then(Answer::si);
        assert_eq!(answer, Some(found), "{impulse}");
        assert!(solution.checks.iter().all(|check| check.passed), "{impulse}");
        assert_eq!(solution.defects, [] as [String; 0], "{impulse}");
        let steps = solution.steps.iter().take(2).map(|step| printer::symbol(&step.symbol)).collect_vec();
        assert_eq!(steps, ["J_z₁", "J₁"], "{impulse}");
    }
    // Two components from two answers.
    let two = "[ask]\nv_x = \"centre_velocity.x\"\nv_z = \"centre_velocity.z\"\n[given]\nv_x = \"2 m/s\"\nv_z = \"-0.5 m/s\"\n";
    let solution = struck(r#""(?; 0; ?) N*s""#, two).expect("it has a solution");
    let found = &solution.determined.as_deref().expect("two were unknown").solutions;
    assert_eq!(found.len(), 1);
    for (found, wanted) in found[0].iter().zip_eq([24.0, -6.0]) {
        assert!((found - wanted).abs() < 1e-8, "{found} {wanted}");
    }
}

#[test]
fn what_is_wrong_with_an_unknown_component_is_named() {
    for (impulse, words) in [
        (r#""?""#, "name the unknown components of a vector, as in (?; 0; 3) m/s"),
        (r#""? N*s""#, "name the unknown components"),
        (r#""(0; 0; 0; ?) N*s""#, "name the unknown components"),
        (r#""? @ 30 deg""#, "an unknown is a component of a vector"),
        (r#""3 i - ? k""#, "an unknown component stands alone"),
        (r#""(0; 0; 2*?) N*s""#, "an unknown component stands alone"),
        (r#""(0; 0; ? 3 kg) N*s""#, "a unit with some components only"),
        (r#""(0; 0; ? 3 .. 1) N*s""#, "the range of an unknown ascends"),
        (r#""(0; ?; ?) N*s""#, "more unknowns (2) than given answers (1)"),
        (r#""(0; 0; ? 0 .. 1) N*s""#, "no Impulse 1 z from 0 N·s to 1 N·s"),
    ] {
        let why = struck(impulse, "").expect_err(impulse);
        assert!(why.contains(words), "{impulse}: {why}");
    }
    let entry = find("balancing/splitting").expect("it is there");
    let mut draft = cases::cases(entry).expect("cases")[1].draft.clone();
    let why = draft.set(&entry.shape(), "task", "?").expect_err("a choice").to_string();
    assert!(why.contains("a choice cannot be unknown: write one of split, combine"), "{why}");
    draft.set(&entry.shape(), "task.split.places.around.count", "?").expect("a text");
    let why = draft.read(&entry.shape()).expect_err("a count").iter().join("; ");
    assert!(why.contains("only a quantity can be unknown"), "{why}");
    let file = "analysis = \"balancing/splitting\"\n[inputs]\ntask = \"?\"\n";
    let why = file::parse(file).expect_err("a choice").iter().map(|error| error.why.english()).join("; ");
    assert!(why.contains("a choice cannot be unknown"), "{why}");
}

#[test]
fn a_component_is_set_by_its_path() {
    let problem = file::parse(STRUCK).expect("it is read");
    let (shape, mut draft) = (problem.entry.shape(), problem.draft);
    let path = "blows[1].strength.impulse.impulse";
    for (component, text, whole) in [
        ("", "(0; 0; -4) N*s", "(0; 0; -4) N*s"),
        (".y", "3", "(0 N*s; 3 N*s; -4 N*s)"),
        (".x", "2 kN*s", "(2 kN*s; 3 N*s; -4 N*s)"),
        (".z", "?", "(2 kN*s; 0.003 kN*s; ?)"),
    ] {
        draft.set(&shape, &format!("{path}{component}"), text).expect("a component");
        assert_eq!(draft.at(&shape, path).expect("a vector").0, &Draft::Leaf(whole.into()));
    }
    draft.set(&shape, &format!("{path}.y"), "?").expect_err("what is unknown already cannot be read");
    assert!(draft.set(&shape, &format!("{path}.w"), "3").is_err());
}

fn solve(entry: &Entry, question: &Question) -> Result<Solution, String> {
    let shape = entry.shape();
    let mut draft: Draft = cases::first(entry).ok_or("there is no case")?.draft;
    for (path, text) in question.inputs {
        draft.set(&shape, path, text).map_err(|err| err.to_string())?;
    }
    for (answer, value) in question.given {
        draft.give(&shape, answer, value).map_err(|err| err.to_string())?;
    }
    let record = draft.read(&shape).map_err(|errors| errors.iter().join("; "))?;
    entry.solve(&record, &Stop::new()).map_err(|err| err.to_string())
}

/// Every value of the range at which the answer passes through the given one, by bisection between neighbours.
fn scan(entry: &Entry, determined: &Determined) -> Vec<f64> {
    let (unknown, given) = (&determined.unknowns[0], &determined.givens[0]);
    let mut reading = entry
        .prepare(&determined.record, &[&unknown.name], &[&given.name])
        .expect("the problem has an answer");
    let mut residual = |x: f64| {
        let mut answer = [f64::NAN];
        reading.sweep(&[x], &mut answer, &Stop::new()).expect("nobody stops it");
        answer[0] - given.given
    };
    let [from, to] = unknown.range;
    let place = |n: usize| {
        let share = n as f64 / SCAN as f64;
        if from > 0.0 { from * (to / from).powf(share) } else { from + (to - from) * share }
    };
    let mut found = Vec::new();
    let (mut low, mut below) = (from, residual(from));
    for n in 1..=SCAN {
        let (high, above) = (place(n), residual(place(n)));
        if below * above < 0.0 {
            let (mut a, mut b) = (low, high);
            for _ in 0..200 {
                let middle = f64::midpoint(a, b);
                if residual(middle) * below > 0.0 { a = middle } else { b = middle }
            }
            // A pole changes the sign too.
            if residual(a).abs() < 1e-6 * given.given.abs() {
                found.push(a);
            }
        }
        (low, below) = (high, above);
    }
    found
}

/// The angle at which the piston of a slider-crank is fastest: its acceleration is zero there, of which no share is zero.
#[test]
fn an_answer_may_be_given_as_zero() {
    for (crank, rod) in [(50.0, 150.0), (60.0, 180.0), (40.0, 130.0)] {
        let solution = solved(&format!(
            r#"
format = 2
analysis = "virtual-work/slider-crank"

[inputs]
crank = "{crank} mm"
rod = "{rod} mm"
angle = "? 50 deg .. 100 deg"
unknown.torque.force = "0 N"
speed = "1 rad/s"

[given]
slider_acceleration = "0 m/s^2"
"#
        ));
        assert!(solution.checks.iter().all(|check| check.passed), "crank {crank} mm, rod {rod} mm");
        // x = r cos θ + √(l² − r² sin² θ) has no second derivative there.
        let angle = number(&solution, "angle");
        let x = |angle: f64| crank * angle.cos() + (rod * rod - (crank * angle.sin()).powi(2)).sqrt();
        let h = 1e-3;
        let second = (x(angle + h) - 2.0 * x(angle) + x(angle - h)) / (h * h);
        assert!(second.abs() < 1e-4 * crank, "{second} mm/rad² with a crank of {crank} mm");
    }
}
