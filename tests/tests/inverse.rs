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
    println!("{}", found.join("\n"));
    assert!(found.len() >= 1, "only {} analyses: {}", found.len(), found.join("\n"));
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
    pairs.take(4).find_map(|(input, answer)| formula_of(entry, &case.draft, &input, &answer))
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
    Some(written(&solution))
}

/// The step of the unknown: symbol, formula, and what is said of it.
fn written(solution: &Solution) -> String {
    let determined = solution.determined.as_deref().expect("something is unknown");
    let name = &determined.unknowns[0].name;
    let (_, id) = solution.computed.iter().find(|(path, _)| path == name).expect("the unknown is a step");
    let step = solution.steps.iter().find(|step| step.result == *id).expect("the unknown is a step");
    let written = printer::step(solution, step, &Locale::english());
    format!(
        "{} = {} | {} | {} | {}",
        written.symbol, written.formula, written.substitution, written.result, written.why
    )
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

#[test]
fn survey() {
    let questions: &[(&str, &[(&str, &str)], (&str, &str))] = &[
        ("vibration/rotating-unbalance", &[("mass", "?")], ("natural_frequency", "8.2 Hz")),
        ("vibration/rotating-unbalance", &[("unbalance", "?")], ("amplitude", "1 mm")),
        (
            "vibration/free-vibration",
            &[("oscillator.translation.mass.mass.mass", "5 kg"), ("oscillator.translation.stiffness", "?")],
            ("natural_frequency", "40 rad/s"),
        ),
        (
            "vibration/free-vibration",
            &[("oscillator.translation.damping.coefficient.coefficient", "?")],
            ("decrement", "0.5"),
        ),
        ("vibration/harmonic-force", &[("damping.coefficient.coefficient", "?")], ("amplitude", "20 mm")),
        (
            "vibration/harmonic-force",
            &[
                ("mass.weight.weight", "9.81 N"),
                ("mass.weight.gravity", "9.81 m/s^2"),
                ("elasticity.stiffness.stiffness", "400 N/m"),
                ("frequency", "20 rad/s"),
                ("excitation.force.force", "10 N"),
                ("damping.coefficient.coefficient", "?"),
            ],
            ("amplitude", "25 mm"),
        ),
        ("vibration/drop-impact", &[("elasticity.stiffness.stiffness", "?")], ("deflection", "200 mm")),
        ("vibration/drop-impact", &[("fall.height.height", "?")], ("force", "6 kN")),
        ("vibration/gun-recoil", &[("stiffness", "?")], ("speed", "24 m/s")),
        ("virtual-work/scotch-yoke", &[("angle", "?")], ("position", "40 mm")),
        ("virtual-work/scissor-lift", &[("angle", "? 1 deg .. 89 deg")], ("height", "0.7 m")),
        ("virtual-work/toggle-press", &[("angle", "? 1 deg .. 60 deg")], ("thrust", "5 kN")),
        (
            "virtual-work/screw-jack",
            &[("frame.scissors.angle", "? 5 deg .. 85 deg")],
            ("axial_force", "20 kN"),
        ),
        ("rigid-body/two-wheeler-lean", &[("motion.speed.speed", "?")], ("lean", "45 deg")),
        ("balancing/tolerance", &[("mass", "?")], ("permissible", "40000 g*mm")),
        ("vibration/equivalent-stiffness", &[], ("stiffness", "1 N/m")),
    ];
    for (id, inputs, given) in questions {
        let result = std::panic::catch_unwind(|| {
            let solution = solved(id, inputs, *given);
            let determined = solution.determined.as_deref().unwrap();
            println!(
                "{id} {given:?} all={} {:?}\n    {}",
                determined.has_all(),
                determined.solutions,
                written(&solution)
            );
            for step in &solution.steps {
                let step = printer::step(&solution, step, &Locale::english());
                println!(
                    "        {} = {} = {} = {}  ({})",
                    step.symbol, step.formula, step.substitution, step.result, step.why
                );
            }
            for check in solution.checks.iter().filter(|check| !check.passed) {
                println!("FAILED {check:?}");
            }
        });
        if result.is_err() {
            println!("{id} {given:?} PANIC");
        }
    }
}
