//! The usual questions of each topic: where they are offered, what they come to, and how they are asked.

#![expect(clippy::unwrap_used, reason = "a test ends where its data fails")]

use std::{
    collections::{BTreeMap, BTreeSet},
    f64::consts::{PI, TAU},
    sync::Mutex,
};

use dalembert_core::{
    Draft, Entry, Locale, Number, Solution, Stop, cases, file, find, registry,
    suggestions::{Suggestion, labels, suggestions},
    trace::Op,
};
use dalembert_plugins as _;
use dalembert_testkit::on_all_cores;
use dalembert_tests::person::Person;
use dalembert_units::unit;

const FAN: &str = "vibration/rotating-unbalance";

/// A question, with the inputs and the solution of the first case that offers it.
struct Offer {
    question: Suggestion,
    draft: Draft,
    solution: Solution,
}

/// Every question that an analysis offers.
fn offered(entry: &'static Entry) -> Vec<Offer> {
    let mut found: Vec<Offer> = Vec::new();
    for case in cases::cases(entry).unwrap() {
        let Ok(record) = case.record(entry) else { continue };
        let Ok(solution) = entry.solve(&record, &Stop::new()) else { continue };
        for question in suggestions(entry, &solution) {
            if found.iter().all(|known| known.question.label != question.label) {
                found.push(Offer { question, draft: case.draft.clone(), solution: solution.clone() });
            }
        }
    }
    found
}

#[test]
fn every_question_is_answered_on_a_case_of_every_analysis_that_offers_it() {
    let seen: Mutex<BTreeMap<&str, usize>> = Mutex::default();
    on_all_cores(registry(), |_, entry| {
        for Offer { question, mut draft, solution } in offered(entry) {
            let (id, shape) = (entry.about.id, entry.shape());
            let line = format!("{id}: {} = {}", question.label, question.formula);
            question.ask(&mut draft, &shape, &Locale::english()).unwrap();
            let record = draft.read(&shape).unwrap_or_else(|errors| panic!("{line}: {errors:?}"));
            let asked = entry.solve(&record, &Stop::new()).unwrap();
            let answer = asked.answer(question.key).unwrap_or_else(|| panic!("{line}: {:?}", asked.warnings));
            let si = answer.si().unwrap();
            assert!(answer.asked && si.is_finite(), "{line}");
            // What is offered is what is answered, bit for bit, in its unit and without a warning.
            assert_eq!(si.to_bits(), question.si.to_bits(), "{line}");
            assert_eq!(answer.unit.ascii(), unit(question.unit).unwrap().ascii(), "{line}");
            assert_eq!(asked.warnings, solution.warnings, "{line}");
            assert_eq!((asked.answers.len(), asked.defects.len()), (solution.answers.len() + 1, 0), "{line}");
            // It is not offered a second time.
            assert!(suggestions(entry, &asked).iter().all(|again| again.key != question.key), "{line}");
            *seen.lock().unwrap().entry(id).or_default() += 1;
        }
    });
    let seen = seen.into_inner().unwrap();
    let questions: usize = seen.values().sum();
    println!("{} of {} analyses offer {questions} questions: {seen:?}", seen.len(), registry().len());
    assert!(seen.len() >= 95 && questions >= 400, "{} analyses, {questions} questions", seen.len());
}

/// Value, in SI, of an input or an answer of a solution.
fn value(solution: &Solution, name: &str) -> f64 {
    let given = solution.trace.nodes.iter().find_map(|node| match (&node.op, node.number) {
        (Op::Given { path, .. }, Number::Scalar(si)) if path == name => Some(si),
        _ => None,
    });
    given.or_else(|| solution.answer(name)?.si()).unwrap_or_else(|| panic!("{name} has a value"))
}

type Expected = fn(&dyn Fn(&str) -> f64) -> f64;

/// Mean of c v² over a cycle, at the midpoints of a thousand parts.
fn mean_dissipation(damping: f64, frequency: f64, amplitude: f64) -> f64 {
    let power =
        |n: i32| damping * (frequency * amplitude * ((f64::from(n) + 0.5) * TAU / 1000.0).sin()).powi(2);
    (0..1000).map(power).sum::<f64>() / 1000.0
}

fn magnification(ratio: f64, damping: f64) -> f64 {
    (1.0 - ratio * ratio).hypot(2.0 * damping * ratio).recip()
}

fn transmissibility(ratio: f64, damping: f64) -> f64 {
    1.0_f64.hypot(2.0 * damping * ratio) * magnification(ratio, damping)
}

/// One analysis of each question, and what it comes to there, from the numbers of the solution.
const EXPECTED: &[(&str, &str, Expected)] = &[
    ("rotating-unbalance", "Peak-to-peak displacement", |q| q("amplitude") * 2.0),
    ("periodic-excitation", "Peak-to-peak displacement", |q| q("largest") - q("least")),
    ("rotating-unbalance", "Root mean square of the displacement", |q| q("amplitude") * 0.5_f64.sqrt()),
    ("rotating-unbalance", "Amplitude of the velocity", |q| q("amplitude") * q("speed")),
    ("base-excitation", "Root mean square of the velocity", |q| {
        q("amplitude") * q("frequency") * 0.5_f64.sqrt()
    }),
    ("whirling-shaft", "Amplitude of the acceleration", |q| q("amplitude") * q("speed.given.speed").powi(2)),
    ("equivalent-damping", "Amplitude of the inertia force", |q| {
        q("frequency").powi(2) * q("amplitude") * q("mass.mass.mass")
    }),
    ("base-excitation", "Amplitude of the spring force", |q| q("relative_amplitude") * q("stiffness")),
    ("rotating-unbalance", "Amplitude of the damper force", |q| q("speed") * q("damping") * q("amplitude")),
    ("beam-and-springs", "Energy dissipated per cycle", |q| {
        mean_dissipation(q("damping"), q("excitation.frequency"), q("amplitude")) * TAU
            / q("excitation.frequency")
    }),
    ("beam-and-springs", "Mean power dissipated", |q| {
        mean_dissipation(q("damping"), q("excitation.frequency"), q("amplitude"))
    }),
    ("equivalent-damping", "Mean power dissipated", |q| q("energy") / (TAU / q("frequency"))),
    ("forced-coulomb", "Energy dissipated per cycle by friction", |q| {
        4.0 * q("exact_amplitude") * q("friction")
    }),
    ("friction-damper", "Maximum energy of the spring", |q| 0.5 * q("stiffness") * q("amplitude").powi(2)),
    ("friction-damper", "Maximum kinetic energy", |q| {
        0.5 * q("mass.mass.mass") * (q("amplitude") * q("frequency")).powi(2)
    }),
    ("piecewise-spring", "Maximum kinetic energy", |q| 0.5 * q("mass") * q("largest_speed").powi(2)),
    ("harmonic-force", "Static displacement under the amplitude of the force", |q| {
        q("force") / q("stiffness")
    }),
    ("beam-and-springs", "Magnification factor", |q| {
        q("amplitude") / (q("excitation.force") / q("stiffness"))
    }),
    ("harmonic-force", "Transmissibility of the force", |q| {
        (1.0 + (2.0 * q("damping_ratio") * q("frequency_ratio")).powi(2)).sqrt() * q("magnification")
    }),
    ("rotating-unbalance", "Amplitude of the unbalance force", |q| q("speed").powi(2) * q("unbalance")),
    ("rotating-unbalance", "Transmissibility of the unbalance force", |q| {
        transmissibility(q("frequency_ratio"), q("damping_ratio"))
    }),
    ("rotating-unbalance", "Amplitude over the ratio of unbalance to mass", |q| {
        q("frequency_ratio").powi(2) * magnification(q("frequency_ratio"), q("damping_ratio"))
    }),
    ("vibration-isolation", "Transmitted force on each mount", |q| {
        q("transmitted_force") / (q("stiffness") / q("stiffness_each"))
    }),
    ("rotating-unbalance", "Transmitted force on each of four mounts", |q| q("transmitted_force") * 0.25),
    ("whirling-shaft", "Force on each of two bearings", |q| q("shaft_force") * 0.5),
    ("rotating-unbalance", "Mean stress due to the transmitted force, section of 100 mm²", |q| {
        q("transmitted_force") * 1e4
    }),
    ("rotating-unbalance", "Bending moment at the clamp", |q| {
        q("support.cantilever.length") * q("amplitude") * q("stiffness")
    }),
    ("rotating-unbalance", "Bending stress at the clamp, section modulus of 10 cm³", |q| {
        q("support.cantilever.length") * q("amplitude") * q("stiffness") * 1e5
    }),
    ("rotating-unbalance", "Period of the natural vibration", |q| TAU * (q("mass") / q("stiffness")).sqrt()),
    ("mass-on-shaft", "Period of the transverse vibration", |q| {
        TAU * (q("body.mass.mass") / q("transverse_stiffness")).sqrt()
    }),
    ("half-car", "Period of the first mode", |q| TAU / q("frequency[1]")),
    ("half-car", "Ratio of the second natural frequency to the first", |q| {
        q("frequency[2]") / q("frequency[1]")
    }),
    ("rigid-body/heavy-top", "Period of the small oscillations", |q| TAU / q("nutation_frequency")),
    ("rotating-unbalance", "Damped natural frequency", |q| {
        (q("stiffness") / q("mass") - (0.5 * q("damping") / q("mass")).powi(2)).sqrt()
    }),
    ("rotating-unbalance", "Logarithmic decrement", |q| {
        q("damping_ratio") * q("natural_frequency") * TAU
            / (q("stiffness") / q("mass") - (0.5 * q("damping") / q("mass")).powi(2)).sqrt()
    }),
    ("rotating-unbalance", "Quality factor", |q| (q("stiffness") * q("mass")).sqrt() / q("damping")),
    ("rotating-unbalance", "Time constant of the decay", |q| 2.0 * q("mass") / q("damping")),
    ("rotating-unbalance", "Critical damping", |q| 2.0 * (q("stiffness") * q("mass")).sqrt()),
    ("equivalent-stiffness", "Critical torsional damping", |q| {
        2.0 * (q("torsional_stiffness") * q("inertia")).sqrt()
    }),
    ("spring-network", "Compliance", |q| q("stiffness").recip()),
    ("rotating-unbalance", "Weight", |q| 9.81 * q("mass")),
    ("rotating-unbalance", "Static deflection under the weight", |q| 9.81 / q("natural_frequency").powi(2)),
    ("free-vibration", "Kinetic energy at that time", |q| 0.5 * q("mass") * q("velocity").powi(2)),
    ("free-vibration", "Energy of the spring at that time", |q| {
        0.5 * q("stiffness") * q("displacement").powi(2)
    }),
    ("gun-recoil", "Equivalent static force", |q| q("stiffness") * q("distance")),
    ("shock-response-spectrum", "Equivalent static force on a mass of 1 kg", |q| q("largest")),
    ("drop-impact", "Maximum force over the weight", |q| q("force") / (9.81 * q("body.mass.mass"))),
    ("drop-impact", "Maximum deceleration over gravity", |q| q("deceleration") / 9.81),
    ("drop-impact", "Kinetic energy before the shock", |q| {
        9.81 * q("body.mass.mass") * q("fall.height.height")
    }),
    ("rod-impact", "Maximum strain", |q| q("stress") / q("young")),
    ("random-response", "3σ velocity", |q| q("velocity") + 2.0 * q("velocity")),
    ("random-response", "Root mean square of the spring force", |q| {
        q("displacement") * q("elasticity.stiffness.stiffness")
    }),
    ("random-response", "3σ force on the support", |q| q("support_force") * 3.0),
    ("periodic-excitation", "Crest factor of the displacement", |q| {
        q("largest").abs().max(q("least").abs()) / q("rms")
    }),
    ("vibration-absorber", "Natural frequency of the absorber", |q| {
        (q("absorber_stiffness") / q("absorber_mass")).sqrt()
    }),
    ("vibration-absorber", "Amplitude of the force in the absorber's spring", |q| {
        q("problem.translation.excitation.force.force")
    }),
    ("damped-absorber", "Amplitude of the force in the absorber's spring", |q| {
        q("stroke") * q("absorber_stiffness")
    }),
    ("large-pendulum", "Frequency", |q| TAU / q("period")),
    ("rigid-body/free-triaxial", "Frequency", |q| TAU / q("period")),
    ("large-pendulum", "Maximum speed of the bob", |q| {
        (2.0 * q("gravity") * q("length") * (1.0 - q("amplitude").cos())).sqrt()
    }),
    ("piecewise-spring", "Maximum acceleration", |q| q("largest_force") / q("mass")),
    ("rotor-dynamics", "First critical speed over running speed", |q| q("critical_speed[1]") / q("speed")),
    ("shaft-clearance", "Clearance left at the maximum amplitude", |q| {
        q("clearance") - q("largest_amplitude")
    }),
    ("balancing/two-plane", "Centrifugal force of the correction at this speed", |q| {
        q("unbalance_a") * q("speed").powi(2)
    }),
    ("balancing/single-plane", "Centrifugal force of the correction at 1000 rpm", |q| {
        q("unbalance") * (1000.0 * PI / 30.0).powi(2)
    }),
    ("balancing/two-plane", "Centrifugal force of the second correction at this speed", |q| {
        q("unbalance_b") * q("speed").powi(2)
    }),
    ("balancing/two-plane", "Centrifugal force of the second correction at 1000 rpm", |q| {
        q("unbalance_b") * (1000.0 * PI / 30.0).powi(2)
    }),
    ("balancing/tolerance", "Rotating force of the permissible unbalance at bearing A", |q| {
        q("permissible_a") * q("speed").powi(2)
    }),
    ("balancing/tolerance", "Rotating force of the permissible unbalance at bearing B", |q| {
        q("permissible_b") * q("speed").powi(2)
    }),
    ("balancing/linkage-balance", "Shaking moment after over before", |q| {
        q("shaking_moment_after") / q("shaking_moment")
    }),
    ("balancing/reciprocating", "Secondary force over primary force", |q| q("force[2]") / q("force[1]")),
    ("balancing/locomotive", "Range of the wheel load", |q| 2.0 * q("hammer_blow")),
    ("rigid-body/spinning-disc-on-arm", "Angular momentum of the rotation", |q| {
        0.5 * q("mass") * q("radius").powi(2) * q("spin")
    }),
    ("rigid-body/spinning-disc-on-arm", "Kinetic energy of the rotation", |q| {
        0.25 * q("mass") * (q("radius") * q("spin")).powi(2)
    }),
    ("rigid-body/rod-on-shaft", "Force of the couple on two bearings 1 m apart", |q| {
        q("tilting_couple").abs()
    }),
    ("rigid-body/rolling-cone", "Time of one revolution", |q| TAU / q("known.precession.precession")),
    ("rigid-body/wheel-loads", "Centripetal acceleration", |q| q("speed").powi(2) / q("radius")),
    ("rigid-body/steady-rolling", "Kinetic energy of the translation", |q| {
        0.5 * q("mass") * q("speed").powi(2)
    }),
    ("rigid-body/impulse", "Kinetic energy after over before", |q| {
        1.0 + q("energy_change") / q("energy_before")
    }),
    ("rigid-body/momentum", "Share of the rotation in the kinetic energy", |q| {
        1.0 - q("translation_energy") / q("kinetic_energy")
    }),
    ("virtual-work/equivalent-rod", "Moment of inertia about the centre of mass", |q| {
        q("mass") * q("radius_of_gyration").powi(2)
    }),
    ("virtual-work/slider-crank", "Instantaneous power at the crank", |q| q("torque") * q("speed")),
    ("virtual-work/mechanism", "Instantaneous power of the first driver", |q| {
        q("effort[1]") * q("drivers[1].what.angle.velocity")
    }),
    ("virtual-work/engine", "Maximum over mean turning moment", |q| q("greatest_moment") / q("mean_moment")),
    ("virtual-work/slider-crank", "Mean shear stress in a pin of 10 mm diameter, double shear", |q| {
        q("crank_pin_force") / (2.0 * 25e-6 * PI)
    }),
    ("virtual-work/screw-jack", "Mean stress in a section of 100 mm²", |q| q("axial_force") / 1e-4),
    ("virtual-work/scissor-lift", "Pressure in a cylinder of 50 mm bore", |q| {
        q("cylinder_force") / (625e-6 * PI)
    }),
    ("virtual-work/rhombus", "Mass with this weight", |q| q("load") / q("gravity")),
    ("virtual-work/epicyclic-train", "Holding torque over driving torque", |q| {
        q("holding_torque") / q("driving_torque")
    }),
    ("virtual-work/flywheel", "Speed at the radius of gyration", |q| {
        q("speed") * q("sought.fluctuation.inertia.gyration.radius")
    }),
    ("virtual-work/flywheel", "Hoop stress of a thin steel rim of that radius", |q| {
        7850.0 * (q("speed") * q("sought.fluctuation.inertia.gyration.radius")).powi(2)
    }),
    ("virtual-work/flywheel", "Energy fluctuation over kinetic energy", |q| 2.0 * q("fluctuation")),
];

#[test]
fn every_question_comes_to_its_closed_form() {
    let mut seen: BTreeSet<&str> = BTreeSet::new();
    let mut offers: BTreeMap<&str, Vec<Offer>> = BTreeMap::new();
    for (id, label, expected) in EXPECTED {
        let id = if id.contains('/') { (*id).to_owned() } else { format!("vibration/{id}") };
        let entry = find(&id).unwrap_or_else(|| panic!("{id} is linked"));
        let offers = offers.entry(entry.about.id).or_insert_with(|| offered(entry));
        let offer = offers.iter().find(|offer| offer.question.label == *label);
        let Offer { question, solution, .. } = offer.unwrap_or_else(|| panic!("{id} offers {label}"));
        let expected = expected(&|name| value(solution, name));
        let difference = (question.si - expected).abs() / expected.abs();
        assert!(difference < 1e-9, "{id}: {label} = {} = {}, not {expected}", question.formula, question.si);
        seen.insert(label);
    }
    let all: BTreeSet<&str> = labels().collect();
    assert_eq!(seen, all);
}

/// The lines of the list of questions, without its frame.
fn listed(person: &mut Person) -> Vec<String> {
    let screen = person.sees();
    screen.lines().filter(|line| line.contains(" = ")).map(str::to_owned).collect()
}

#[test]
fn a_usual_question_is_asked_by_one_key_in_the_results() {
    let mut person = Person::at(80, 24).opens(FAN);
    person.types("<tab>a");
    let offered = listed(&mut person);
    assert!(offered[0].contains("Peak-to-peak displacement = 38.913 mm"), "{offered:?}");
    assert!(offered[2].contains("Amplitude of the velocity = 2037.5 mm/s"), "{offered:?}");
    // The formula of the chosen one stands below.
    person.types("<down><down>");
    assert!(person.sees().contains("speed*amplitude"), "{}", person.sees());
    person.types("<enter>");
    let screen = person.sees();
    assert!(screen.contains("asked: Amplitude of the velocity"), "{screen}");
    assert!(screen.lines().any(|line| line.contains("velocity") && line.contains("2037.5")), "{screen}");
    // It is in the file, and no more in the list.
    let kept = person.kept.values().next().cloned().unwrap();
    let row = "\"Amplitude of the velocity\" = { value = \"speed*amplitude\", unit = \"mm/s\", symbol = \"V_X\", key = \"velocity_amplitude\" }";
    assert!(kept.contains(row), "{kept}");
    person.types("a");
    assert!(listed(&mut person).iter().all(|line| !line.contains("Amplitude of the velocity")));
    // It is taken back like any change.
    person.types("<esc>z");
    assert!(!person.sees().contains("2037.5"), "{}", person.sees());
}

#[test]
fn a_number_of_a_usual_question_is_changed_to_ones_own() {
    let mut person = Person::at(120, 40).opens(FAN);
    person.types("<tab>a");
    for _ in 0..40 {
        if person.sees().contains("transmitted_force/4") {
            break;
        }
        person.types("<down>");
    }
    person.types("<enter>");
    assert!(person.sees().contains("change the number in the formula"), "{}", person.sees());
    // The cursor stands on the formula.
    person.types("<enter><end><bs>6<enter>");
    let screen = person.sees();
    assert!(screen.contains("transmitted_force/6") && screen.contains("1474.5"), "{screen}");
}

#[test]
fn the_last_of_the_list_is_a_question_of_ones_own() {
    let mut person = Person::at(120, 40).opens(FAN);
    person.types("<tab>a<end><enter>");
    person.types("<enter>double<down>").types("<enter>2*X<enter>");
    let screen = person.sees();
    assert!(screen.lines().any(|line| line.contains("double") && line.contains("38.913")), "{screen}");
}

#[test]
fn questions_show_no_number_that_is_to_be_found() {
    let mut person = Person::at(100, 40).opens(FAN);
    person.types("t<tab>a");
    let screen = person.sees();
    assert!(screen.contains("Peak-to-peak displacement") && !screen.contains("38.913"), "{screen}");
}

#[test]
fn questions_are_in_portuguese() {
    let mut person = Person::in_portuguese(100, 40).opens(FAN);
    person.types("<tab>a<down><down><enter>");
    let screen = person.sees();
    assert!(screen.contains("perguntado: Amplitude da velocidade"), "{screen}");
    assert!(screen.contains("2037,5"), "{screen}");
}

/// A bracket and the fan on it, in US customary units.
const LINKED: &str = r#"format = 2
[problem.bracket]
analysis = "vibration/equivalent-stiffness"
[problem.bracket.inputs]
motion.translation.springs.cantilever = { length = "20 in", young = "30e6 psi", section.rectangle = { breadth = "2.5 in", height = "0.5 in" } }
motion.translation.load.mass.mass = "fan.mass"
motion.translation.spring_masses = []
[problem.fan]
analysis = "vibration/rotating-unbalance"
[problem.fan.inputs]
mass = "0.25 lbf*s^2/in"
unbalance = "0.01 lbf*s^2"
support.stiffness.stiffness = "bracket.stiffness"
damping.ratio.ratio = "0.05"
speed = "1500 rpm"
"#;

#[test]
fn each_of_linked_problems_has_its_questions_in_its_units() {
    let problem = file::parse(LINKED).unwrap();
    let (entry, shape) = (problem.entry, problem.entry.shape());
    let solved = |draft: &Draft| entry.solve(&draft.read(&shape).unwrap(), &Stop::new()).unwrap();
    let solution = solved(&problem.draft).in_units_of(problem.units, &problem.draft, &shape);
    let offered = suggestions(entry, &solution);
    let of = |problem: &str| offered.iter().filter(|question| question.problem == problem).count();
    assert!(of("bracket") >= 2 && of("fan") >= 10, "{} {}", of("bracket"), of("fan"));
    for question in &offered {
        let mut draft = problem.draft.clone();
        let row = question.ask(&mut draft, &shape, &Locale::english()).unwrap();
        assert!(row.starts_with(&format!("{}.ask[1]", question.problem)), "{row}");
        let asked = solved(&draft);
        let answer = asked.answer(&question.name()).unwrap_or_else(|| panic!("{}", question.name()));
        assert_eq!(answer.si().unwrap().to_bits(), question.si.to_bits(), "{}", question.name());
        assert_eq!((answer.problem, asked.warnings.len()), (question.problem, 0));
        let again = suggestions(entry, &asked);
        assert!(again.iter().all(|again| again.name() != question.name()));
    }
    // 2 X of the fan, and m r² X/m₀e; a stress and a displacement in inches and pounds.
    let question =
        |name: &str| offered.iter().find(|question| question.is(name, &Locale::english())).unwrap();
    let peak = question("fan.peak_to_peak");
    assert_eq!((peak.unit, peak.formula.as_str()), ("in", "2*amplitude"));
    assert_eq!(peak.title(&Locale::english()), "fan: Peak-to-peak displacement");
    assert_eq!(question("fan: Weight").unit, "lbf");
    // The weight with the gravity of those units.
    let weight = 0.25 * 32.2 * 12.0 * unit("lbf").unwrap().factor;
    assert!((question("fan: Weight").si / weight - 1.0).abs() < 1e-12);
    assert!((peak.si - 2.0 * solution.answer("fan.amplitude").unwrap().si().unwrap()).abs() < 1e-15);
}

#[test]
fn a_usual_question_of_a_linked_problem_is_asked_by_one_key() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("fan.toml");
    std::fs::write(&path, LINKED).unwrap();
    let mut person = Person::at(120, 40);
    person.types("<esc>o<c-u>").types(path.to_str().unwrap()).types("<enter>");
    person.types("<tab>a");
    for _ in 0..60 {
        if person.sees().contains("2*amplitude") {
            break;
        }
        person.types("<down>");
    }
    person.types("<enter>");
    let screen = person.sees();
    assert!(screen.contains("asked: fan: Peak-to-peak displacement"), "{screen}");
    let kept = person.kept.values().next().cloned().unwrap();
    let (before, row) = kept.split_once("[problem.fan.ask]").unwrap_or_else(|| panic!("{kept}"));
    assert!(
        row.contains("\"Peak-to-peak displacement\" = { value = \"2*amplitude\", unit = \"in\""),
        "{kept}"
    );
    assert!(!before.contains("Peak-to-peak"), "{kept}");
}
