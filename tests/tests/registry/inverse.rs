//! Formulas of unknowns: where a given answer follows from an unknown through one path of operations, the working begins
//! with the formula of the unknown, and its solutions are all that there are.

use std::sync::Mutex;

use dalembert_core::{
    Answer, AnswerValue, Draft, Entry, Locale, Solution, Stop, cases, find, printer, registry,
    trace::Op,
    vary::{self, VariedInput},
};
use dalembert_plugins as _;
use dalembert_testkit::on_all_cores;
use itertools::Itertools as _;

#[test]
fn most_analyses_have_an_input_with_a_formula() {
    let found = Mutex::new(Vec::new());
    on_all_cores(registry(), |_, entry| {
        if let Some(formula) = invertible_pair(entry) {
            found.lock().expect("no worker panics").push(format!("{}: {formula}", entry.about.id));
        }
    });
    let mut found = found.into_inner().expect("no worker panics");
    found.sort();
    assert!(found.len() >= 80, "only {} analyses: {}", found.len(), found.join("\n"));
}

/// The formula of an input of the first case from one of its answers.
fn invertible_pair(entry: &Entry) -> Option<String> {
    let case = cases::cases(entry).ok()?.into_iter().find(|case| case.refused.is_none())?;
    let record = case.record(entry).ok()?;
    let solution = entry.solve(&record, &Stop::new()).ok()?;
    let pairs = vary::inputs(&record).into_iter().flat_map(|input| {
        let has_path = |answer: &&Answer| {
            answer.si().is_some_and(|si| si != 0.0) && paths(&solution, answer, &input.path) == Some(1)
        };
        let answers: Vec<Answer> = solution.answers.iter().filter(has_path).cloned().collect();
        answers.into_iter().map(move |answer| (input.clone(), answer))
    });
    pairs.take(3).find_map(|(input, answer)| formula_of(entry, &case.draft, &input, &answer))
}

/// Number of paths from an input to an answer; `None` where a numerical method lies between.
fn paths(solution: &Solution, answer: &Answer, input: &str) -> Option<usize> {
    let AnswerValue::Number(_, id) = answer.value else { return None };
    let mut paths = vec![Some(0usize); id as usize + 1];
    for at in 0..=id {
        let node = solution.trace.node(at);
        paths[at as usize] = match &node.op {
            Op::Given { path, .. } => Some(usize::from(path == input)),
            Op::Step(step) => solution.steps[*step].formula.and_then(|of| paths[of as usize]),
            _ => solution.trace.operands(at).iter().map(|of| paths[*of as usize]).sum(),
        };
    }
    paths[id as usize]
}

fn formula_of(entry: &Entry, draft: &Draft, input: &VariedInput, answer: &Answer) -> Option<String> {
    let shape = entry.shape();
    let (own, mut draft) = (input.measure.own_unit(), draft.clone());
    let mut ends = [0.7, 1.5].map(|share| own.value(share * input.si));
    ends.sort_by(f64::total_cmp);
    let name = own.ascii();
    draft.set(&shape, &input.path, &format!("? {:e} {name} .. {:e} {name}", ends[0], ends[1])).ok()?;
    let given = match answer.unit.coherent() {
        unit if unit == "1" => format!("{:e}", answer.si()?),
        unit => format!("{:e} {unit}", answer.si()?),
    };
    draft.give(&shape, &answer.name.to_string(), &given).ok()?;
    let solution = entry.solve(&draft.read(&shape).ok()?, &Stop::new()).ok()?;
    let determined = solution.determined.as_deref()?;
    if !determined.has_all() {
        return None;
    }
    let id = entry.about.id;
    assert!(solution.defects.is_empty(), "{id}: {:?}", solution.defects);
    assert!(solution.checks.iter().all(|check| check.passed), "{id}: {:?}", solution.checks);
    let is_it = |found: &Vec<f64>| (found[0] - input.si).abs() <= 1e-6 * input.si.abs();
    assert!(determined.solutions.iter().any(is_it), "{id}: {:?}, not {}", determined.solutions, input.si);
    Some(written(&solution, &Locale::english()))
}

/// The step of the unknown: symbol, formula, and what is said of it.
fn written(solution: &Solution, locale: &Locale) -> String {
    let determined = solution.determined.as_deref().expect("something is unknown");
    let name = &determined.unknowns[0].name;
    let (_, id) = solution.computed.iter().find(|(path, _)| path == name).expect("the unknown is a step");
    let step = solution.steps.iter().find(|step| step.result == *id).expect("the unknown is a step");
    let written = printer::step(solution, step, locale);
    format!("{} = {}: {}", written.symbol, written.formula, written.why)
}

fn solved(id: &str, inputs: &[(&str, &str)], given: (&str, &str)) -> Solution {
    let entry = find(id).unwrap_or_else(|| panic!("there is no {id}"));
    let shape = entry.shape();
    let mut draft = cases::first(entry).expect("there is a case").draft;
    for (path, text) in inputs {
        draft.set(&shape, path, text).unwrap_or_else(|err| panic!("{id}: {err}"));
    }
    draft.give(&shape, given.0, given.1).unwrap_or_else(|err| panic!("{id}: {err}"));
    let record = draft.read(&shape).unwrap_or_else(|errors| panic!("{id}: {}", errors.iter().join("; ")));
    entry.solve(&record, &Stop::new()).unwrap_or_else(|err| panic!("{id}: {err}"))
}

/// Unknowns of published problems by their formulas: what is asked, the first step, and the solutions by a closed form.
#[test]
fn unknowns_have_the_formulas_of_textbooks() {
    type Inputs = &'static [(&'static str, &'static str)];
    let tau = std::f64::consts::TAU;
    let stiffness = 3.0 * 200e9 * 1.3e-6 / 1.2f64.powi(3);
    let ratio_squared = (1000.0 * tau / 60.0).powi(2) * 40.0 / stiffness;
    let unbalance = 0.001 * 40.0 * (1.0 - ratio_squared).hypot(0.1 * ratio_squared.sqrt()) / ratio_squared;
    let at_resonance: Inputs = &[
        ("mass.weight.weight", "9.81 N"),
        ("mass.weight.gravity", "9.81 m/s^2"),
        ("elasticity.stiffness.stiffness", "400 N/m"),
        ("frequency", "20 rad/s"),
        ("excitation.force.force", "10 N"),
        ("damping.coefficient.coefficient", "?"),
    ];
    let lean = (9.81f64 * 50.0 / (3.5 / (250.0 * 0.3 * 0.6) + 1.0)).sqrt();
    let sixty = tau / 6.0;
    let questions: [(&str, Inputs, (&str, &str), &str, Vec<f64>); 8] = [
        (
            "vibration/rotating-unbalance",
            &[("mass", "?")],
            ("natural_frequency", "8.2 Hz"),
            "m = k / ωₙ²",
            vec![stiffness / (8.2 * tau).powi(2)],
        ),
        (
            "vibration/rotating-unbalance",
            &[("damping.ratio.ratio", "0.05"), ("unbalance", "?")],
            ("amplitude", "1 mm"),
            "m₀e = ",
            vec![unbalance],
        ),
        (
            "vibration/free-vibration",
            &[
                ("oscillator.translation.mass.mass.mass", "5 kg"),
                ("oscillator.translation.stiffness.stiffness.stiffness", "?"),
            ],
            ("natural_frequency", "40 rad/s"),
            "k = m ωₙ²",
            vec![8000.0],
        ),
        // At resonance X = F/(c ω).
        ("vibration/harmonic-force", at_resonance, ("amplitude", "25 mm"), "c = ", vec![20.0]),
        (
            "vibration/gun-recoil",
            &[("stiffness", "?")],
            ("speed", "24 m/s"),
            "k = m (v₀ / R)²",
            vec![600.0 * (24f64 / 1.3).powi(2)],
        ),
        (
            "rigid-body/two-wheeler-lean",
            &[("motion.speed.speed", "?")],
            ("lean", "45 deg"),
            "v = √(g R tan θ / (I / (m r h) + 1))",
            vec![lean],
        ),
        (
            "virtual-work/scissor-lift",
            &[("angle", "? 1 deg .. 89 deg")],
            ("height", "0.7 m"),
            "θ = arcsin(h / L)",
            vec![tau / 12.0],
        ),
        (
            "virtual-work/scotch-yoke",
            &[("angle", "?")],
            ("position", "40 mm"),
            "θ_2 = −arccos(x / r)",
            vec![-sixty, sixty],
        ),
    ];
    for (id, inputs, given, formula, solutions) in questions {
        let solution = solved(id, inputs, given);
        let determined = solution.determined.as_deref().expect("something is unknown");
        assert!(determined.has_all(), "{id} {given:?}");
        for (found, wanted) in determined.solutions.iter().zip_eq(&solutions) {
            assert!((found[0] - wanted).abs() <= 1e-12 * wanted.abs(), "{id}: {found:?}, not {wanted}");
        }
        let step = written(&solution, &Locale::english());
        assert!(step.starts_with(formula), "{id}: {step}");
        assert!(step.contains("all solutions from"), "{id}: {step}");
        assert!(written(&solution, &Locale::portuguese()).contains("todas as soluções de"), "{id}");
        assert!(solution.defects.is_empty(), "{id}: {:?}", solution.defects);
        assert!(solution.checks.iter().all(|check| check.passed), "{id}: {:?}", solution.checks);
    }
}
