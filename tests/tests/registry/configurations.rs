//! Configurations that replace parts of the inputs: choices, counts, vectors, rows and cells of tables.

use dalembert_core::{
    Answer, AnswerValue, Draft, Entry, Locale, Number, Record, Solution, Stop, Text, cases, file, find,
    title_of, vary,
};
use dalembert_plugins as _;
use dalembert_report::{WorkedProblem, document, text};
use itertools::{Itertools as _, zip_eq};

/// A case of an analysis, by its place, and the inputs that a configuration of it changes.
type Changed = (&'static str, usize, &'static [(&'static str, &'static str)]);

const CHANGED: [Changed; 13] = [
    // Another alternative, of one input and of several.
    ("vibration/rotating-unbalance", 0, &[("damping.ratio.ratio", "0.05")]),
    ("vibration/rotating-unbalance", 0, &[("support.stiffness.stiffness", "300 kN/m"), ("mass", "50 kg")]),
    (
        "vibration/rotating-unbalance",
        2,
        &[
            ("damping.between.least", "0.1"),
            ("damping.between.most", "0.2"),
            ("support.cantilever.length", "1.5 m"),
        ],
    ),
    // A formula in another alternative, over the inputs of the problem.
    ("vibration/rotating-unbalance", 2, &[("support.stiffness.stiffness", "m*(100 rad/s)^2")]),
    // An alternative without inputs.
    ("vibration/modal-analysis", 2, &[("normalisation", "largest")]),
    // Counts.
    ("balancing/splitting", 1, &[("task.split.places.around.count", "8")]),
    (
        "balancing/reciprocating",
        0,
        &[
            ("arrangement.radial.every.reciprocating", "0.55 kg"),
            ("arrangement.radial.every.throw.radius.radius", "45 mm"),
            ("arrangement.radial.every.rod", "145 mm"),
            ("arrangement.radial.count", "5"),
        ],
    ),
    // A vector, and one component of it.
    ("rigid-body/impulse", 1, &[("blows[1].strength.impulse.impulse", "(0; 0; -8) N*s")]),
    ("rigid-body/impulse", 1, &[("blows[1].strength.impulse.impulse.z", "-6 N*s")]),
    // A row more.
    (
        "balancing/splitting",
        3,
        &[("task.combine.weights[4].mass", "6 g"), ("task.combine.weights[4].angle", "200 deg")],
    ),
    // Cells of a table, and all of it.
    ("vibration/modal-analysis", 3, &[("system.matrices.entries[3].stiffness", "7 N/m")]),
    (
        "vibration/modal-analysis",
        3,
        &[("system.matrices.entries[1].mass", "2000 g"), ("system.matrices.entries[3].stiffness", "7")],
    ),
    ("vibration/modal-analysis", 3, &[("system.matrices.entries", "1; 1; 1 kg; 0; 2 N/m")]),
];

/// The problem of a case, and its draft.
fn problem(id: &str, case: usize) -> (&'static Entry, Draft) {
    let entry = find(id).unwrap_or_else(|| panic!("there is no {id}"));
    let cases = cases::cases(entry).unwrap_or_else(|why| panic!("{id}: {why}"));
    (entry, cases[case].draft.clone())
}

fn read(entry: &Entry, draft: &Draft) -> Record {
    let record = draft.read(&entry.shape());
    record.unwrap_or_else(|errors| panic!("{}: {}", entry.about.id, errors.iter().join("; ")))
}

fn solve(entry: &Entry, record: &Record) -> Solution {
    entry.solve(record, &Stop::new()).unwrap_or_else(|error| panic!("{}: {error}", entry.about.id))
}

/// The draft with its inputs changed as those of a configuration.
fn changed(entry: &Entry, draft: &Draft, changes: &[(&str, &str)]) -> Draft {
    let (shape, mut draft) = (entry.shape(), draft.clone());
    for (path, text) in changes {
        let text = text.replace("m*(100 rad/s)^2", "400 kN/m");
        match path.strip_prefix("system.matrices.entries[") {
            // A table is one text: its cells are those of the lines below the units.
            Some(cell) => {
                let (row, column) = cell.split_once("].").expect("a cell");
                let column =
                    ["row", "column", "mass", "damping", "stiffness"].iter().position(|of| *of == column);
                let Ok((Draft::Leaf(table), _)) = draft.at(&shape, "system.matrices.entries") else {
                    panic!("a table")
                };
                let row: usize = row.parse().expect("a row");
                let mut lines: Vec<Vec<String>> =
                    table.lines().map(|line| line.split(';').map(str::to_owned).collect()).collect();
                lines[row][column.expect("a column")] = text;
                let table = lines.iter().map(|cells| cells.join("; ")).join("\n");
                draft.set(&shape, "system.matrices.entries", &table).expect("a table");
            }
            None => draft.set(&shape, path, &text).unwrap_or_else(|error| panic!("{path}: {error}")),
        }
    }
    draft
}

/// A draft with a configuration of it.
fn configured(entry: &Entry, draft: &Draft, changes: &[(&str, &str)]) -> Draft {
    let (shape, mut draft) = (entry.shape(), draft.clone());
    for (path, text) in changes {
        draft.configure(&shape, &format!("other.{path}"), text).expect("a configuration");
    }
    draft
}

fn numbers(answer: &Answer) -> Vec<f64> {
    match &answer.value {
        AnswerValue::Number(Number::Scalar(si), _) => vec![*si],
        AnswerValue::Number(Number::Vector(si), _) => si.to_vec(),
        AnswerValue::List(all) => all.clone(),
        AnswerValue::Set(..) => Vec::new(),
    }
}

#[test]
fn a_configuration_is_the_problem_with_its_inputs_changed() {
    let mut compared = 0;
    for (id, case, changes) in CHANGED {
        let (entry, draft) = problem(id, case);
        let name = format!("{id} {changes:?}");
        let (base, wanted) = (
            solve(entry, &read(entry, &draft)),
            solve(entry, &read(entry, &changed(entry, &draft, changes))),
        );
        let record = read(entry, &configured(entry, &draft, changes));
        let solution = solve(entry, &record);
        assert_eq!(
            (solution.defects.len(), solution.answers.len()),
            (0, base.answers.len() + wanted.answers.len()),
            "{name}"
        );
        for answer in base.answers.iter().chain(&wanted.answers) {
            let is_other = wanted.answers.iter().any(|other| std::ptr::eq(other, answer));
            let outside = if is_other { format!("other.{}", answer.name) } else { answer.name.to_string() };
            let found = solution.answer(&outside).unwrap_or_else(|| panic!("{name}: there is no {outside}"));
            for (found, wanted) in zip_eq(numbers(found), numbers(answer)) {
                let size = wanted.abs().max(1e-12);
                assert!((found - wanted).abs() <= 1e-12 * size, "{name}: {outside}: {found}, not {wanted}");
                compared += 1;
            }
        }
        let differs = |answer: &Answer| {
            base.answer(&answer.name.to_string()).is_none_or(|other| numbers(other) != numbers(answer))
        };
        assert!(wanted.answers.iter().any(differs), "{name} changes nothing");
        assert!(solution.checks.iter().all(|check| check.passed), "{name}");
        plain_is_worked(entry, &record, &solution, &name);
    }
    assert!(compared > 150, "{compared}");
}

/// The plain reading gives the bits of the worked one, with the inputs as they are and with one of them varied.
fn plain_is_worked(entry: &Entry, record: &Record, solution: &Solution, name: &str) {
    let scalar = |answer: &&Answer| matches!(answer.value, AnswerValue::Number(Number::Scalar(_), _));
    let names: Vec<String> =
        solution.answers.iter().filter(scalar).map(|answer| answer.name.to_string()).collect();
    let wanted: Vec<&str> = names.iter().map(String::as_str).collect();
    let inputs = vary::inputs(record);
    let input = inputs.iter().find(|input| entry.prepare(record, &[&input.path], &wanted).is_ok());
    let Some(input) = input else { return };
    let mut plain = entry.prepare(record, &[&input.path], &wanted).expect("the plain reading");
    for share in [1.0, 1.0001] {
        let (si, mut row) = (input.si * share, vec![f64::NAN; wanted.len()]);
        plain.sweep(&[si], &mut row, &Stop::new()).expect("the answers");
        let worked = solve(entry, &vary::changed(record, &input.path, si).expect("a varied input"));
        for (name_of, found) in zip_eq(&wanted, &row) {
            let worked = worked.answer(name_of).and_then(Answer::si).expect("a number");
            assert_eq!(found.to_bits(), worked.to_bits(), "{name}: {name_of} with {} = {si}", input.path);
        }
    }
}

const FILE: &str = r#"format = 2
analysis = "rigid-body/impulse"

[inputs]
body.parts.parts = [{ name = "plate", shape.rectangular-plate = { a = "0.5 m", b = "0.3 m" }, amount.mass.mass = "12 kg" }]

[[inputs.blows]]
name = "blow"
point = ["0.25 m", "0.15 m", "0 m"]
strength.impulse.impulse = "(0; 0; -4) N*s"

[configuration.harder]
"blows[1].strength.impulse.impulse" = [0, 0, "-8 N*s"]

[configuration.disc]
"body.parts.parts[1].shape.disc.radius" = "0.2 m"

[ask]
ratio = "harder.centre_velocity.z/centre_velocity.z"
"#;

#[test]
fn a_file_has_lists_and_choices_in_configurations() {
    let problem = file::parse(FILE).expect("it is read");
    let written = file::write(&problem, FILE);
    assert!(written.ends_with(&FILE[FILE.find("[configuration").expect("a table")..]), "{written}");
    let solution = solve(problem.entry, &read(problem.entry, &problem.draft));
    let ratio = solution.answer("ratio").and_then(Answer::si).expect("a number");
    assert!((ratio - 2.0).abs() < 1e-12, "{ratio}");
    // A disc of the same mass has the same velocity of its centre, and other angular velocities.
    let of = |name: &str| solution.answer(name).map_or_else(|| panic!("there is no {name}"), numbers);
    assert_eq!(of("disc.centre_velocity"), of("centre_velocity"));
    // ω = r × J/(m r²/4) about the diameters.
    let wanted = [-4.0 * 0.15 / (12.0 * 0.01), 4.0 * 0.25 / (12.0 * 0.01)];
    for (found, wanted) in zip_eq(&of("disc.angular_velocity")[..2], wanted) {
        assert!((found - wanted).abs() < 1e-9, "{found} {wanted}");
    }
}

#[test]
fn what_is_wrong_with_a_configuration_is_named() {
    let rows: &[(&str, usize, &[(&str, &str)], &str)] = &[
        (
            "vibration/rotating-unbalance",
            0,
            &[("suport.stiffness.stiffness", "1 N/m")],
            "did you mean `support`?",
        ),
        (
            "vibration/rotating-unbalance",
            0,
            &[("support.stifness.stiffness", "1 N/m")],
            "did you mean `stiffness`?",
        ),
        ("vibration/rotating-unbalance", 0, &[("support", "springs")], "there is no `springs`"),
        (
            "vibration/rotating-unbalance",
            0,
            &[("support", "stiffness")],
            "support.stiffness.stiffness: a value is needed",
        ),
        (
            "vibration/rotating-unbalance",
            0,
            &[("support.stiffness.stiffness", "-1 N/m")],
            "must be above zero",
        ),
        (
            "vibration/rotating-unbalance",
            0,
            &[("support.stiffness.stiffness", "1 kg")],
            "a stiffness expected",
        ),
        (
            "vibration/rotating-unbalance",
            0,
            &[("support.stiffness.stiffness", "?")],
            "only an input of the problem itself",
        ),
        (
            "vibration/rotating-unbalance",
            0,
            &[("support.stiffness.stiffness", "mass*(1 rad/s)")],
            "a stiffness expected",
        ),
        ("vibration/rotating-unbalance", 0, &[("support.cantilever", "1 m")], "is chosen already"),
        (
            "balancing/splitting",
            1,
            &[("task.split.places.around.count", "2")],
            "enter an integer from 3 to 1000",
        ),
        (
            "balancing/splitting",
            1,
            &[("task.split.places.around.count", "?")],
            "only a quantity can be unknown",
        ),
        ("balancing/splitting", 3, &[("task.combine.weights[6].mass", "6 g")], "the next is 4"),
        (
            "balancing/splitting",
            3,
            &[("task.combine.weights[4].mass", "6 g")],
            "weights[4].angle: a value is needed",
        ),
        ("rigid-body/impulse", 1, &[("blows[1].strength.impulse.impulse", "(1; 2) kg")], "kg"),
        (
            "vibration/modal-analysis",
            3,
            &[("system.matrices.entries[3]", "7 N/m")],
            "name a cell of the table",
        ),
        ("vibration/modal-analysis", 3, &[("system.matrices.entries[9].mass", "7 kg")], "there are 3 rows"),
        ("vibration/modal-analysis", 3, &[("system.matrices.entries[1].mass", "7 m")], "`7 m` is a length"),
    ];
    for (id, case, changes, words) in rows {
        let (entry, draft) = problem(id, *case);
        let record = configured(entry, &draft, changes).read(&entry.shape());
        let why = match record {
            Err(errors) => errors.iter().join("; "),
            Ok(record) => match entry.solve(&record, &Stop::new()) {
                Err(error) => error.to_string(),
                Ok(_) => String::new(),
            },
        };
        assert!(why.contains(words) && why.contains("configuration[1]."), "{id} {changes:?}: {why:?}");
    }
}

#[test]
fn given_data_name_the_inputs_of_a_configuration() {
    let (entry, draft) = problem("vibration/rotating-unbalance", 0);
    let changes = [("m", "50 kg"), ("support.stiffness.stiffness", "300 kN/m")];
    let draft = configured(entry, &draft, &changes);
    let record = read(entry, &draft);
    let solution = solve(entry, &record);
    let none = Text::default();
    let worked = WorkedProblem {
        entry,
        case: &none,
        source: &none,
        statement: &none,
        note: &none,
        notes: &[],
        draft: &draft,
        record: &record,
        outcome: Ok(&solution),
    };
    for (locale, lines) in [
        (Locale::english(), ["Configuration other: Mass of the machine", "Configuration other: Stiffness"]),
        (Locale::portuguese(), ["Configuração other: Massa da máquina", "Configuração other: Rigidez"]),
    ] {
        let page = text(&document(&worked, &locale), 200);
        for line in lines {
            let found = page.lines().find(|found| found.contains(line));
            let found = found.unwrap_or_else(|| panic!("{line} is missing in\n{page}"));
            assert!(found.contains("50 kg") || found.contains("300 kN/m"), "{found}");
        }
        assert!(page.lines().any(|line| line.contains(lines[0]) && line.contains(" m ")), "{page}");
    }
}

#[test]
fn an_input_is_called_by_its_label() {
    let rows = [
        ("vibration/rotating-unbalance", "mass", "Mass of the machine"),
        ("vibration/rotating-unbalance", "support", "Support"),
        ("balancing/splitting", "task.combine.weights[4].mass", "Weight 4"),
        ("rigid-body/impulse", "blows[1].point.z", "Position of the struck point 1 z"),
        ("vibration/modal-analysis", "system.matrices.entries[3].stiffness", "Stiffness 3"),
    ];
    for (id, path, title) in rows {
        let (entry, _) = problem(id, 0);
        assert_eq!(
            title_of(&entry.shape(), path).map(|title| title.english()).as_deref(),
            Some(title),
            "{path}"
        );
    }
    let (entry, _) = problem("vibration/rotating-unbalance", 0);
    assert!(title_of(&entry.shape(), "massa").is_none());
}
