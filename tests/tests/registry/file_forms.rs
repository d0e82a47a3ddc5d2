//! Forms in which a problem file writes its inputs, and refusals that show them.

use dalembert_core::{
    Entry, Locale, Shape, Stop, Text, cases, describe, draft::leaf_text, file, find, registry,
};
use dalembert_plugins as _;
use itertools::zip_eq;

const FAN: &str = "vibration/rotating-unbalance";

/// A file of an analysis with these inputs.
fn of(analysis: &str, inputs: &str) -> String {
    format!("format = 2\nanalysis = \"{analysis}\"\n[inputs]\n{inputs}\n")
}

/// The first error of a file.
fn refusal(analysis: &str, inputs: &str) -> String {
    let text = of(analysis, inputs);
    match file::parse(&text) {
        Ok(_) => panic!("read:\n{text}"),
        Err(errors) => {
            assert!(errors.iter().all(|error| error.span.is_some()), "{errors:?}");
            errors[0].why.english()
        }
    }
}

fn fan(damping: &str) -> String {
    let rest = "mass = \"40 kg\"\nunbalance = \"0.1 kg*m\"\nspeed = \"1000 rpm\"\nsupport.stiffness.stiffness = \"451 kN/m\"";
    of(FAN, &format!("{rest}\n{damping}"))
}

/// Answers of a file, and the notes on its reading.
fn solved(text: &str) -> (String, Vec<String>) {
    let problem = file::parse(text).unwrap_or_else(|errors| panic!("{errors:?}\n{text}"));
    let record =
        problem.draft.read(&problem.entry.shape()).unwrap_or_else(|errors| panic!("{errors:?}\n{text}"));
    let solution = problem.entry.solve(&record, &Stop::new()).expect("there is an answer");
    (format!("{:?}", solution.answers), problem.notes.iter().map(Text::english).collect())
}

/// The tables of numbers of an analysis at the top of its inputs or of an alternative, in the first case that has one.
fn tables(entry: &'static Entry) -> Vec<(String, Vec<String>, Vec<Vec<String>>, cases::Case)> {
    let mut found = Vec::new();
    for case in cases::cases(entry).expect("the cases can be read") {
        let record = case.record(entry).expect("the case can be read");
        record.leaves(&mut |path, field, value| {
            let Shape::Table(columns) = field.shape.present() else { return };
            let text = leaf_text(value);
            let mut lines = text.lines();
            let Some(heading) = lines.next() else { return };
            let units: Vec<&str> = heading.split("; ").map(|unit| unit.trim_matches(['[', ']'])).collect();
            let rows = lines.map(|line| {
                zip_eq(line.split("; "), &units)
                    .map(|(number, unit)| format!("{number} {unit}").trim().to_owned())
                    .collect()
            });
            let names = columns().iter().map(|column| column.name.to_owned()).collect();
            found.push((path.to_owned(), names, rows.collect(), case.clone()));
        });
    }
    found
}

#[test]
fn rows_with_names_lists_of_cells_and_text_are_one_table() {
    let mut tested = 0;
    for entry in registry() {
        let shape = entry.shape();
        for (path, names, rows, case) in tables(entry).into_iter().take(2) {
            let quoted = |text: &str| format!("{text:?}");
            let cells =
                |row: &Vec<String>| row.iter().map(|cell| quoted(cell)).collect::<Vec<_>>().join(", ");
            let named = |row: &Vec<String>| {
                let cells = zip_eq(&names, row).map(|(name, cell)| format!("{name} = {}", quoted(cell)));
                format!("{{ {} }}", cells.collect::<Vec<_>>().join(", "))
            };
            let lines = rows.iter().map(|row| row.join("; ")).collect::<Vec<_>>().join("\n");
            let join = |rows: Vec<String>| format!("[{}]", rows.join(", "));
            let forms = [
                quoted(&lines),
                join(rows.iter().map(|row| format!("[{}]", cells(row))).collect()),
                join(rows.iter().map(named).collect()),
            ];
            let read = forms.map(|form| {
                // Only the table is written: the rest of the draft is that of the case.
                if path.contains('[') {
                    return None;
                }
                let text = of(entry.about.id, &format!("{path} = {form}"));
                let problem =
                    file::parse(&text).unwrap_or_else(|errors| panic!("{path}: {errors:?}\n{text}"));
                let (table, _) = problem.draft.at(&shape, &path).expect("it was written");
                let mut draft = case.draft.clone();
                let (place, _) = draft.at_mut(&shape, &path).expect("the case has it");
                *place = table.clone();
                Some(format!("{:?}", draft.read(&shape)))
            });
            assert!(read.iter().all(|record| *record == read[0]), "{}: {path}", entry.about.id);
            tested += usize::from(read[0].as_ref().is_some_and(|read| read.starts_with("Ok")));
        }
    }
    assert!(tested >= 10, "{tested}");
}

#[test]
fn a_value_alone_stands_for_the_only_input_of_an_alternative() {
    let (expected, notes) = solved(&fan("damping.ratio.ratio = \"0.05\""));
    assert!(notes.is_empty(), "{notes:?}");
    for damping in
        ["damping = \"0.05\"", "damping = 0.05", "damping.ratio = 0.05", "damping = { ratio = \"0.05\" }"]
    {
        let (answers, notes) = solved(&fan(damping));
        assert_eq!(answers, expected, "{damping}");
        assert!(notes.len() == 1 && notes[0].ends_with("read as inputs.damping.ratio.ratio"), "{notes:?}");
    }
    let (answers, notes) = solved(&fan("damping = \"5 %\""));
    assert!(answers.contains("Scalar(0.05)") && notes.len() == 1, "{answers}: {notes:?}");
    let (expected, _) = solved(&fan("damping.coefficient.coefficient = \"500 N*s/m\""));
    assert_eq!(solved(&fan("damping = \"500 N*s/m\"")).0, expected);
    // A formula or an unknown is for the alternative whose only input has the name of the choice, and formulas name it so.
    let full =
        "[let]\nk = \"15 lbf/in\"\ntwice = \"2*oscillator.translation.stiffness.stiffness.stiffness\"\n";
    let release = |stiffness: &str, lets: &str| {
        let rest = "oscillator.translation.mass.mass.mass = \"5 kg\"\noscillator.translation.damping.ratio.ratio = \"0.1\"\noscillator.translation.displacement = \"1 mm\"";
        let inputs = format!("oscillator.translation.{stiffness} = \"2*k\"\n{rest}\n{lets}");
        solved(&of("vibration/free-vibration", &inputs))
    };
    let (expected, notes) = release("stiffness.stiffness.stiffness", full);
    assert!(notes.is_empty(), "{notes:?}");
    let (answers, notes) =
        release("stiffness", &full.replace(".stiffness.stiffness.stiffness", ".stiffness"));
    assert_eq!(answers, expected);
    assert!(notes.len() == 1 && notes[0].ends_with("stiffness.stiffness.stiffness"), "{notes:?}");
    // What several alternatives take, or none, is refused with all of them.
    let refused = refusal(FAN, "damping = \"5 kg\"");
    assert!(
        refused.contains("one alternative is needed here: { ratio = { ratio = \"…\" } }; { "),
        "{refused}"
    );
}

#[test]
fn a_choice_is_saved_in_full() {
    let text = fan("damping = \"0.05\"   # assumed");
    let problem = file::parse(&text).expect("it is read");
    let saved = file::write(&problem, &text);
    assert_eq!(file::parse(&saved).expect("it is read").notes.len(), 0, "{saved}");
    assert_eq!(solved(&saved).0, solved(&text).0);
}

#[test]
fn a_refusal_of_a_form_shows_the_form() {
    for (inputs, words) in [
        ("mass = { value = 40 }", "one value is needed here, written \"… kg\""),
        (
            "support.cantilever = \"1.2 m\"",
            "a table of inputs is needed here, written { length = \"… m\", young = \"… Pa\", section = { ",
        ),
        (
            "support = [1, 2]",
            "one alternative is needed here: { stiffness = { … } }; { equal = { … } }; { cantilever = { … } }",
        ),
        (
            "support.series.members = \"two\"",
            "a list is needed here, written [{ stiffness = { stiffness = \"… N/m\" } }, …]",
        ),
        ("damping = \"light\"", "there is no `light`; write one of { ratio = { ratio = \"…\" } }; "),
        ("mas = \"40 kg\"", "there is no `mas`; did you mean `mass`?"),
        ("omega = \"1000 rpm\"", "there is no `omega`; did you mean `speed`?"),
        ("m = \"40 kg\"", "did you mean `mass`"),
        ("young = \"200 GPa\"", "did you mean `support.cantilever.young`"),
    ] {
        let refused = refusal(FAN, inputs);
        assert!(refused.contains(words), "{inputs}: {refused}");
    }
    let table = "vibration/frequency-response-identification";
    let refused = refusal(table, "measurement.table.points = { frequency = 1 }");
    assert!(refused.contains("rows { frequency = \"… Hz\", receptance = \"… m/N\" }"), "{refused}");
    let entry = find(FAN).expect("it is linked");
    let mut draft = dalembert_core::Draft::blank(&entry.shape());
    let set = |draft: &mut dalembert_core::Draft, path: &str, text: &str| {
        draft.set(&entry.shape(), path, text).expect_err("it is refused").to_string()
    };
    let refused = set(&mut draft, "support.cantilever", "1.2 m");
    assert!(
        refused.contains("name one of them: support.cantilever.length, support.cantilever.young"),
        "{refused}"
    );
    let refused = set(&mut draft, "support.series.members.stiffness", "1 N/m");
    assert!(refused.contains("support.series.members[1].stiffness"), "{refused}");
}

/// Every form that is shown is TOML, with its dots filled in.
#[test]
fn forms_are_well_formed() {
    for entry in registry() {
        for field in entry.fields() {
            let form = describe::form(&field.shape);
            let filled = form.replace(", …", "").replace("{ … }", "{}");
            assert!(
                format!("x = {filled}").parse::<toml_edit::DocumentMut>().is_ok(),
                "{}: {form}",
                entry.about.id
            );
            assert!(!describe::in_words(&field.shape, &Locale::portuguese()).is_empty());
        }
    }
}

const MECHANISM: &str = "virtual-work/mechanism";

/// A slider-crank in the shorter forms of its lists.
const SHORT: &str = r#"points = { O = "ground (0; 0)", A = "(30; 20) mm", B = "(150; 0) mm" }
bodies = { crank = ["O; A", "40 mm"], rod = ["A; B", "(120) mm"] }
joints = [{ name = "slot", joint.slot = { guide = "O", pin = "rod (120; 0) mm" } }]
drivers = [{ name = "motor", what.angle = { body = "crank", value = "30 deg", velocity = "10 rad/s" } }]
watched = ["B"]
"#;

/// The same with every body, point and pin written out.
const LONG: &str = r#"bodies = [{ name = "crank", angle = "30 deg" }, { name = "rod", angle = "-10 deg" }]
points = [
 { name = "O", on = "ground", at = "(0; 0) mm" },
 { name = "A", on.body.body = "crank", at = "(40; 0) mm" },
 { name = "B", on.body.body = "rod", at = "(120; 0) mm" },
 { name = "O1", on.body.body = "crank", at = "(0; 0) mm" },
 { name = "A1", on.body.body = "rod", at = "(0; 0) mm" },
]
joints = [
 { name = "slot", joint.slot = { guide = "O", pin = "B" } },
 { name = "O", joint.pin = { a = "O", b = "O1" } },
 { name = "A", joint.pin = { a = "A", b = "A1" } },
]
drivers = [{ name = "motor", what.angle = { body = "crank", against = "ground", value = "30 deg", velocity = "10 rad/s" } }]
watched = [{ point = "B" }]
"#;

#[test]
fn a_mechanism_in_short_is_the_mechanism_written_out() {
    let (short, notes) = solved(&of(MECHANISM, SHORT));
    let (long, _) = solved(&of(MECHANISM, LONG));
    // Nodes and rounding are those of each file.
    let values = |text: &str| {
        let quoted =
            text.split("Scalar(").skip(1).filter_map(|rest| rest.split(')').next()?.parse::<f64>().ok());
        quoted.collect::<Vec<f64>>()
    };
    assert!(notes.is_empty(), "{notes:?}");
    let pairs: Vec<(f64, f64)> = zip_eq(values(&short), values(&long)).collect();
    assert!(
        pairs.len() > 8 && pairs.iter().all(|(a, b)| (a - b).abs() <= 1e-9 * b.abs().max(1e-3)),
        "{pairs:?}"
    );
}

#[test]
fn saving_keeps_the_short_forms_of_what_was_not_changed() {
    let text = of(MECHANISM, SHORT);
    let problem = file::parse(&text).expect("it can be read");
    let shape = problem.entry.shape();
    let mut draft = problem.draft.clone();
    draft.set(&shape, "bodies[1].sides[1]", "50 mm").expect("there is such an input");
    let saved = file::write(&file::ProblemFile { draft, ..problem }, &text);
    for kept in ["O = \"ground (0; 0)\"", "watched = [\"B\"]", "pin = \"rod (120; 0) mm\""] {
        assert!(saved.contains(kept), "{kept} in\n{saved}");
    }
    let again = file::parse(&saved).expect("what is saved can be read");
    let crank = again.draft.at(&shape, "bodies[1].sides[1]").expect("there is such an input");
    assert_eq!(format!("{:?}", crank.0), "Leaf(\"50 mm\")");
}

#[test]
fn a_point_in_place_on_nothing_is_refused_where_it_stands() {
    let text = of(MECHANISM, &SHORT.replace("rod (120; 0) mm", "rot (120; 0) mm"));
    let problem = file::parse(&text).expect("its form is right");
    let errors = problem.draft.read(&problem.entry.shape()).expect_err("there is no such body");
    let [error] = &errors[..] else { panic!("{errors:?}") };
    assert_eq!(error.path, "joints[1].joint.slot.pin");
    assert!(error.why.english().contains("`rod`"), "{}", error.why.english());
}
