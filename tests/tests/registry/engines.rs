//! The numbers of other programs, frozen in `tests/engines`: each row is solved and compared with what they found.

#![expect(clippy::unwrap_used, reason = "a test ends where its data fails")]

use itertools::Itertools as _;
use std::{
    collections::{BTreeMap, BTreeSet},
    fs,
    path::Path,
};

use dalembert_core::{AnswerValue, Number, Stop, file};
use dalembert_plugins as _;
use toml_edit::{DocumentMut, Item, Table, Value};

/// The programs, and how many numbers each of them holds at least.
const PROGRAMS: [(&str, usize); 7] = [
    ("Exudyn", 18),
    ("MuJoCo", 72),
    ("ROSS", 98),
    ("SciPy", 468),
    ("hsbalance", 66),
    ("mpmath", 452),
    ("pylinkage", 82),
];

/// Minimum number of numbers, analyses and families that other programs cover together.
const NUMBERS: usize = 1256;
const ANALYSES: usize = 51;
const FAMILIES: [&str; 4] = ["balancing", "rigid-body", "vibration", "virtual-work"];

/// The largest error that a number may be given relative to its size: one that grows by a hundredth always fails.
const LOOSEST: f64 = 1e-4;

#[test]
fn other_programs_find_the_same() {
    let mut found = Found::default();
    let mut files: Vec<_> = fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("engines"))
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .collect();
    files.sort();
    for path in files.iter().filter(|path| path.extension().is_some_and(|ending| ending == "toml")) {
        let document: DocumentMut = fs::read_to_string(path).unwrap().parse().unwrap();
        let program = document["program"].as_str().unwrap();
        for key in ["version", "python", "script"] {
            assert!(
                document[key].as_str().is_some_and(|text| !text.is_empty()),
                "{}: no {key}",
                path.display()
            );
        }
        let script = path.with_file_name(document["script"].as_str().unwrap());
        assert!(script.is_file(), "{} not found", script.display());
        for row in document["row"].as_array_of_tables().unwrap() {
            found.hold(program, row);
        }
    }
    assert!(found.differing.is_empty(), "{}", found.differing.join("\n"));
    for (program, least) in PROGRAMS {
        let held = found.numbers.remove(program).unwrap_or_default();
        assert!(held >= least, "{program} holds {held} numbers; it held {least}");
        found.total += held;
    }
    assert!(found.numbers.is_empty(), "programs without a least number of numbers: {:?}", found.numbers);
    assert!(found.total >= NUMBERS, "{} numbers in all", found.total);
    assert!(found.analyses.len() >= ANALYSES, "{} analyses in all", found.analyses.len());
    let families: BTreeSet<_> = found.analyses.iter().filter_map(|id| id.split('/').next()).collect();
    assert!(families.iter().eq(FAMILIES.iter()), "the families are {families:?}");
}

/// Counts of compared numbers.
#[derive(Default)]
struct Found {
    /// Number of compared numbers of each program.
    numbers: BTreeMap<String, usize>,
    total: usize,
    analyses: BTreeSet<String>,
    differing: Vec<String>,
}

impl Found {
    /// Solves a row and compares what the program found.
    fn hold(&mut self, program: &str, row: &Table) {
        let (analysis, name) = (row["analysis"].as_str().unwrap(), row["name"].as_str().unwrap());
        let inputs = row["inputs"].as_table().unwrap();
        let of = format!("{program}: {analysis}, {name}\n{inputs}");
        self.analyses.insert(analysis.to_owned());
        let mut written = DocumentMut::new();
        written["format"] = Item::Value(Value::from(2));
        written["analysis"] = Item::Value(Value::from(analysis));
        written["inputs"] = Item::Table(inputs.clone());
        let problem = file::parse(&written.to_string()).unwrap_or_else(|errors| panic!("{of}{errors:?}"));
        let record =
            problem.draft.read(&problem.entry.shape()).unwrap_or_else(|errors| panic!("{of}{errors:?}"));
        let solution =
            problem.entry.solve(&record, &Stop::new()).unwrap_or_else(|refusal| panic!("{of}{refusal}"));
        for check in solution.checks.iter().filter(|check| !check.passed) {
            self.differing.push(format!(
                "{of}the check `{}` failed: {:e}",
                check.what.english(),
                check.residual
            ));
        }
        let answers = row["answers"].as_table().unwrap();
        assert!(!answers.is_empty(), "{of}holds nothing");
        for (key, answer) in answers {
            let answer = answer.as_inline_table().unwrap();
            let (theirs, within) = (numbers(&answer["si"]), float(&answer["within"]));
            let Some(ours) = solution.answer(key) else {
                self.differing.push(format!("{of}{key} is no answer"));
                continue;
            };
            let ours = match &ours.value {
                AnswerValue::Number(Number::Scalar(number), _) => vec![*number],
                AnswerValue::Number(Number::Vector(vector), _) => vector.to_vec(),
                AnswerValue::List(list) => list.clone(),
                AnswerValue::Set(..) => panic!("{of}{key} is a set"),
            };
            let size = theirs.iter().map(|number| number * number).sum::<f64>().sqrt();
            assert!(
                within > 0.0 && within <= LOOSEST * size,
                "{of}{key}: {within:e} holds nothing of {size}"
            );
            *self.numbers.entry(program.to_owned()).or_default() += theirs.len();
            let same = ours.len() == theirs.len()
                && ours.iter().zip_eq(&theirs).all(|(ours, theirs)| (ours - theirs).abs() <= within);
            if !same {
                self.differing
                    .push(format!("{of}{key} is {ours:?}; {program} found {theirs:?}, right to {within:e}"));
            }
        }
    }
}

/// A number, or the components of a vector.
fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().map_or_else(|| vec![float(value)], |array| array.iter().map(float).collect())
}

fn float(value: &Value) -> f64 {
    value.as_float().unwrap()
}
