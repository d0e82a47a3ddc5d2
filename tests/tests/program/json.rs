//! The program for other programs: results, errors and requests as JSON.

use std::{
    collections::{BTreeMap, BTreeSet},
    io::{BufRead as _, BufReader, Write as _},
    process::{Command, Output, Stdio},
};

use dalembert::request::{FailureKind, RequestedProblem, SolvedProblem, guarded};
use dalembert_core::{Entry, Language, cases, catalogue, find, registry};
use dalembert_plugins as _;
use dalembert_report::{RESULT_KEYS, RESULTS_SCHEMA};
use dalembert_testkit::on_all_cores;
use dalembert_tests::pty;
use itertools::Itertools as _;
use serde_json::{Map, Value as Json, json};

const FAN: &str = "vibration/rotating-unbalance";

/// Runs the program with a text on its standard input.
fn run(arguments: &[&str], input: &str) -> Output {
    let mut child =
        program(arguments).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the program runs");
    // A program that does not read its input to the end closes it.
    let _ = child.stdin.take().expect("the input is piped").write_all(input.as_bytes());
    child.wait_with_output().expect("the program ends")
}

fn program(arguments: &[&str]) -> Command {
    let mut command = Command::new(pty::program());
    command.args(arguments).stdin(Stdio::piped()).env("LC_ALL", "C.UTF-8");
    command.env("XDG_CONFIG_HOME", env!("CARGO_TARGET_TMPDIR"));
    command
}

fn requested(request: Json) -> Result<SolvedProblem, Vec<(String, String)>> {
    let Json::Object(request) = request else { panic!("a request is an object") };
    let errors = |failure: dalembert::request::RequestFailure| {
        assert_eq!(failure.kind, FailureKind::Input);
        failure.errors.into_iter().map(|error| (error.path, error.message)).collect()
    };
    RequestedProblem::read(&request, Language::English).map_err(errors)?.solve().map_err(errors)
}

fn result(request: Json) -> Json {
    requested(request).unwrap_or_else(|errors| panic!("{errors:?}")).json()
}

fn example(name: &str) -> String {
    let path = xtask::root().join("examples").join(name);
    std::fs::read_to_string(path).expect("the example is there")
}

/// Differences of a JSON from its schema, by the keywords that the schema of results uses.
fn faults(json: &Json, schema: &Json, all: &Json, path: &str, found: &mut Vec<String>) {
    if let Some(name) = schema["$ref"].as_str() {
        let name = name.strip_prefix("#/$defs/").expect("a definition of the schema");
        assert!(all["$defs"][name].is_object(), "there is no {name}");
        faults(json, &all["$defs"][name], all, path, found);
    }
    let types = match &schema["type"] {
        Json::Null => None,
        Json::Array(types) => Some(types.clone()),
        one => Some(vec![one.clone()]),
    };
    let is = |wanted: &Json| match wanted.as_str().expect("a text") {
        "null" => json.is_null(),
        "boolean" => json.is_boolean(),
        "string" => json.is_string(),
        "number" => json.is_number(),
        "integer" => json.is_u64() || json.is_i64(),
        "array" => json.is_array(),
        "object" => json.is_object(),
        other => panic!("unknown type {other}"),
    };
    if types.is_some_and(|types| !types.iter().any(is)) {
        found.push(format!("{path} is no {}: {json}", schema["type"]));
    }
    if let Some(values) = schema["enum"].as_array()
        && !values.contains(json)
    {
        found.push(format!("{path} = {json} is none of {values:?}"));
    }
    if schema.get("const").is_some_and(|value| value != json) {
        found.push(format!("{path} = {json} is not {}", schema["const"]));
    }
    if let (Some(least), Some(number)) = (schema["minimum"].as_f64(), json.as_f64())
        && number < least
    {
        found.push(format!("{path} = {number} is below {least}"));
    }
    if let Some(schemas) = schema["oneOf"].as_array() {
        let fits = |schema: &&Json| {
            let mut wrong = Vec::new();
            faults(json, schema, all, path, &mut wrong);
            wrong.is_empty()
        };
        if schemas.iter().filter(fits).count() != 1 {
            found.push(format!("{path} fits not one of the alternatives: {json}"));
        }
    }
    if let Json::Array(items) = json
        && schema["items"].is_object()
    {
        for (n, item) in items.iter().enumerate() {
            faults(item, &schema["items"], all, &format!("{path}[{n}]"), found);
        }
    }
    if let Json::Object(object) = json {
        for key in schema["required"].as_array().into_iter().flatten() {
            if !object.contains_key(key.as_str().expect("a text")) {
                found.push(format!("{path} has no {key}"));
            }
        }
        for (key, value) in object {
            let path = format!("{path}.{key}");
            match (schema["properties"].get(key), &schema["additionalProperties"]) {
                (Some(schema), _) => faults(value, schema, all, &path, found),
                (None, Json::Bool(false)) => found.push(format!("{path} is not in the schema")),
                (None, others @ Json::Object(_)) => faults(value, others, all, &path, found),
                (None, _) => {}
            }
        }
    }
}

fn assert_valid(result: &Json, what: &str) {
    let schema: Json = serde_json::from_str(RESULTS_SCHEMA).expect("the schema is JSON");
    let mut found = Vec::new();
    faults(result, &schema, &schema, "", &mut found);
    assert!(found.is_empty(), "{what}: {found:#?}");
}

#[test]
fn the_validator_notices_what_is_wrong() {
    let right = result(json!({ "problem": FAN }));
    assert_valid(&right, FAN);
    let schema: Json = serde_json::from_str(RESULTS_SCHEMA).expect("the schema is JSON");
    let wrong = |change: &dyn Fn(&mut Json)| {
        let (mut changed, mut found) = (right.clone(), Vec::new());
        change(&mut changed);
        faults(&changed, &schema, &schema, "", &mut found);
        found.len()
    };
    assert_eq!(wrong(&|_| {}), 0);
    assert_eq!(wrong(&|json| json["more"] = 1.into()), 1);
    assert_eq!(wrong(&|json| json["format"] = 2.into()), 1);
    assert_eq!(wrong(&|json| json["units"] = "cgs".into()), 1);
    assert_eq!(wrong(&|json| json["steps"][0]["si"] = "12".into()), 1);
    assert_eq!(wrong(&|json| json["steps"][0]["number"] = 0.into()), 1);
    assert_eq!(wrong(&|json| json["plots"][0]["over"] = json!({ "input": "speed" })), 1);
    assert_eq!(wrong(&|json| json["answers"]["amplitude"] = json!({})), 6);
}

#[test]
fn results_are_as_their_schema_says() {
    let schema: Json = serde_json::from_str(RESULTS_SCHEMA).expect("the schema is JSON");
    let keys: BTreeSet<&str> =
        schema["properties"].as_object().expect("an object").keys().map(String::as_str).collect();
    assert_eq!(keys, BTreeSet::from(RESULT_KEYS));
    let printed = run(&["schema", "results"], "");
    assert_eq!(serde_json::from_slice::<Json>(&printed.stdout).unwrap(), schema);
    // Linked problems, exam questions among them, and every analysis.
    on_all_cores(catalogue(), |_, entry| {
        let solved = result(json!({ "problem": entry.about.id, "case": 1 }));
        assert_valid(&solved, entry.about.id);
        is_a_graph(&solved, entry.about.id);
        common_errors_are_written_as_results(&solved, entry.about.id);
    });
    for name in ["fan_on_bracket.toml", "mass_from_frequency.toml", "fan_questions.toml", "added_weight.toml"]
    {
        let solved = result(json!({ "problem_file": example(name), "lang": "pt-BR", "units": "in-lbf-s" }));
        assert_valid(&solved, name);
        is_a_graph(&solved, name);
        assert_eq!(solved["refusal"], Json::Null, "{name}");
    }
    let unknown = result(json!({ "problem_file": example("mass_from_frequency.toml") }));
    assert!(!unknown["unknowns"].as_object().expect("an object").is_empty(), "{unknown}");
}

/// A common error has another number than its step, written in the same unit.
fn common_errors_are_written_as_results(solved: &Json, what: &str) {
    let result = |of: &Json| of["result"].as_str().expect("a text").to_owned();
    let unit = |result: &str| result.split_once(' ').map(|(_, unit)| unit.to_owned());
    for step in solved["steps"].as_array().expect("a list") {
        let right = result(step);
        for error in step["common_errors"].as_array().into_iter().flatten() {
            let wrong = result(error);
            assert_ne!(right, wrong, "{what}: {step}");
            assert_eq!(unit(&right), unit(&wrong), "{what}: {step}");
            assert_eq!([&step["unit"], &step["si_unit"]], [&error["unit"], &error["si_unit"]], "{what}");
        }
    }
}

/// Steps come from steps before them and from inputs that are there, and an answer has the number of its step.
fn is_a_graph(solved: &Json, what: &str) {
    let steps = solved["steps"].as_array().expect("a list");
    for (n, step) in (1..).zip(steps) {
        assert_eq!(step["number"], n, "{what}");
        for from in step["from_steps"].as_array().expect("a list") {
            assert!(from.as_u64().expect("a number") < n, "{what}: step {n} comes from {from}");
        }
        let operands = step["from_steps"].as_array().expect("a list").len()
            + step["from_inputs"].as_array().expect("a list").len();
        let is_found = step["formula"] == "";
        assert!(!is_found || operands <= 1, "{what}: step {n} has operands and no formula");
        for path in
            step["from_inputs"].as_array().expect("a list").iter().map(|path| path.as_str().expect("a text"))
        {
            let is_there =
                ["inputs", "definitions", "unknowns"].iter().any(|list| solved[list].get(path).is_some());
            assert!(is_there || is_part(solved, path), "{what}: step {n} comes from {path}");
        }
    }
    for (name, answer) in solved["answers"].as_object().expect("an object") {
        if let Some(step) = answer["step"].as_u64() {
            assert_eq!(steps[step as usize - 1]["si"], answer["si"], "{what}: {name}");
        }
    }
    for plot in solved["plots"].as_array().expect("a list") {
        for curve in plot["curves"].as_array().expect("a list") {
            assert_eq!(
                curve["x"].as_array().expect("a list").len(),
                curve["y"].as_array().expect("a list").len(),
                "{what}"
            );
        }
    }
    for table in solved["tables"].as_array().expect("a list") {
        let rows: BTreeSet<usize> = table["columns"]
            .as_array()
            .expect("a list")
            .iter()
            .map(|column| column["cells"].as_array().expect("a list").len())
            .collect();
        assert!(rows.len() <= 1, "{what}: {table}");
    }
}

/// True of a component of a vector, a cell of a table, or an input that a configuration or another problem has.
fn is_part(solved: &Json, path: &str) -> bool {
    let inputs = solved["inputs"].as_object().expect("an object");
    inputs.keys().any(|known| dalembert_core::is_within(path, known) || path.ends_with(&format!(".{known}")))
}

#[test]
fn a_refusal_and_a_bad_input_are_data() {
    let refused = registry().iter().find_map(|entry| {
        let cases = cases::cases(entry).unwrap();
        cases.iter().position(|case| case.refused.is_some()).map(|at| (entry.about.id, at + 1))
    });
    let (id, case) = refused.expect("a case is refused");
    let solved = result(json!({ "problem": id, "case": case }));
    assert_valid(&solved, id);
    assert!(solved["refusal"].is_string(), "{solved}");
    let output = run(&["solve", FAN, "--case", "1", "--set", "mas=3 kg", "--format", "json"], "");
    assert_eq!(output.status.code(), Some(2));
    let errors: Json = serde_json::from_slice(&output.stdout).unwrap();
    let error = json!({ "path": "mas", "message": "--set mas: there is no `mas`; did you mean `mass`?", "repair": "mass" });
    assert_eq!(errors, json!({ "format": 1, "errors": [error] }));
    assert!(String::from_utf8(output.stderr).unwrap().starts_with("error: --set mas:"));
    // By the name of the file that is not written then.
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("x.json");
    let output = run(&["solve", FAN, "--set", "mass=3 kg", "-o", file.to_str().unwrap()], "");
    let errors: Json = serde_json::from_slice(&output.stdout).unwrap();
    assert!(
        errors["errors"].as_array().expect("a list").iter().any(|error| error["path"] == "speed"),
        "{errors}"
    );
    assert!(!file.exists());
    // So is a command line that is none.
    let output = run(&["solve", FAN, "--case", "0", "--format", "json"], "");
    let errors: Json = serde_json::from_slice(&output.stdout).unwrap();
    assert!(errors["errors"][0]["message"].as_str().expect("a text").contains("'0' for '--case"), "{errors}");
    // An error of a file has its line.
    let text = example("fan.toml").replace("mass = \"40 kg\"", "mass = \"40 km\"");
    let line = 1 + text.lines().position(|line| line.contains("40 km")).unwrap();
    let output = run(&["solve", "-", "--format", "json"], &text);
    let errors: Json = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!((&errors["errors"][0]["path"], &errors["errors"][0]["line"]), (&"mass".into(), &line.into()));
}

#[test]
fn a_problem_is_read_from_standard_input() {
    let text = example("fan.toml");
    let [dash, device] = ["-", "/dev/stdin"].map(|name| run(&["solve", name, "--format", "json"], &text));
    assert_eq!(device.status.code(), Some(0), "{device:?}");
    assert_eq!(dash.stdout, device.stdout);
    let find = ["find", "-", "--input", "mass", "--answer", "natural_frequency=8.2 Hz", "--json"];
    let found: Json = serde_json::from_slice(&run(&find, &text).stdout).unwrap();
    assert!(found["unknowns"]["mass"]["value"].is_array(), "{found}");
    let study = ["study", "-", "--vary", "speed=600..1800 rpm:5", "--answers", "amplitude", "--json"];
    let output = run(&study, &text);
    let found: Json =
        serde_json::from_slice(&output.stdout).unwrap_or_else(|error| panic!("{error}: {output:?}"));
    assert_eq!(found["points"], 5);
}

#[test]
fn numbers_lists_and_tables_are_values() {
    let text = result(json!({ "problem": FAN, "set": {
        "mass": "40 kg", "unbalance": "0.1 kg*m", "speed": "100 rad/s",
        "support.stiffness.stiffness": "451389 N/m", "damping.ratio.ratio": "0.0617",
    } }));
    let numbers = result(json!({ "problem": FAN, "set": {
        "mass": 40, "unbalance": 0.1, "speed": 1e2, "support": { "stiffness": 451389.0 }, "damping": 0.0617,
    } }));
    assert_eq!(text["answers"], numbers["answers"]);
    assert_eq!(numbers["notes"], json!([]));
    // A text without a unit is still reported.
    let bare = result(json!({ "problem": FAN, "case": 1, "set": { "mass": "40" } }));
    assert_eq!(bare["notes"], json!(["mass = 40: no unit; kg assumed"]));
    // Every leaf of the first case as JSON in place of its text: the same answers.
    on_all_cores(registry(), |_, entry| {
        let solved = result(json!({ "problem": entry.about.id, "case": 1 }));
        let values = as_numbers(entry, &solved);
        let again = requested(json!({ "problem": entry.about.id, "case": 1, "set": values }));
        let again = again.unwrap_or_else(|errors| panic!("{}: {errors:?}", entry.about.id)).json();
        for (name, answer) in solved["answers"].as_object().expect("an object") {
            let near = near(&answer["si"], &again["answers"][name]["si"]);
            assert!(near, "{}: {name}: {} {}", entry.about.id, answer["si"], again["answers"][name]["si"]);
        }
    });
}

/// The numbers among the inputs of a case, in the units in which a number alone is taken.
fn as_numbers(entry: &Entry, solved: &Json) -> Map<String, Json> {
    let described =
        dalembert::request::described(entry.about.id, Language::English).expect("the analysis is there");
    let mut units = BTreeMap::new();
    collect_units(&described["inputs"], "", &mut units);
    let plain = |path: &str| {
        let parts = path.split('[').map(|part| part.split_once(']').map_or(part, |(_, rest)| rest));
        parts.collect::<Vec<_>>().concat()
    };
    let inputs = solved["inputs"].as_object().expect("an object");
    let number = |(path, input): (&String, &Json)| {
        // A formula stays one.
        let is_typed = input["text"].as_str()?.starts_with(|c: char| c.is_ascii_digit() || c == '-');
        let own = units.get(&plain(path)).filter(|_| is_typed)?;
        (input["unit"] == **own).then(|| (path.clone(), input["value"].clone()))
    };
    inputs.iter().filter_map(number).filter(|(_, value)| value.is_number() || value.is_array()).collect()
}

fn collect_units(fields: &Json, above: &str, units: &mut BTreeMap<String, String>) {
    for field in fields.as_array().into_iter().flatten() {
        collect_unit(field, &format!("{above}{}", field["name"].as_str().expect("a text")), units);
    }
}

fn collect_unit(shape: &Json, path: &str, units: &mut BTreeMap<String, String>) {
    if let (Some(unit), false) = (shape["unit"].as_str(), shape.get("others").is_some()) {
        units.insert(path.to_owned(), unit.to_owned());
    }
    collect_units(&shape["fields"], &format!("{path}."), units);
    if shape["item"].is_object() {
        collect_unit(&shape["item"], path, units);
    }
    for alternative in shape["alternatives"].as_array().into_iter().flatten() {
        collect_units(
            &alternative["fields"],
            &format!("{path}.{}.", alternative["name"].as_str().expect("a text")),
            units,
        );
    }
}

/// True of numbers that agree but for the rounding of a unit.
fn near(one: &Json, other: &Json) -> bool {
    match (one, other) {
        (Json::Array(one), Json::Array(other)) => {
            one.len() == other.len() && one.iter().zip_eq(other).all(|(one, other)| near(one, other))
        }
        (Json::Number(one), Json::Number(other)) => {
            let (one, other) = (one.as_f64().expect("a number"), other.as_f64().expect("a number"));
            (one - other).abs() <= 1e-6 * one.abs().max(1e-6)
        }
        _ => one == other,
    }
}

#[test]
fn a_list_is_the_whole_list() {
    let mass = |mass: f64, angle: &str| json!({ "amount": { "mass": { "mass": mass } }, "radius": 30, "angle": angle, "position": "20 mm" });
    let solved = |masses: Json| {
        let set = json!({ "masses": masses });
        result(json!({ "problem": "balancing/known-masses", "case": 1, "set": set }))
    };
    let two = solved(json!([mass(9.0, "60 deg"), mass(6.0, "210 deg")]));
    let rows = |solved: &Json| {
        (1..9).take_while(|n| solved["inputs"].get(format!("masses[{n}].radius")).is_some()).count()
    };
    assert_eq!(rows(&two), 2);
    assert_eq!(two["inputs"]["masses[2].radius"]["text"], "30 mm");
    assert_eq!(rows(&solved(json!([mass(9.0, "60 deg")]))), 1);
    // One row by its path leaves the others.
    let set = json!({ "masses[1]": { "radius": 31.5 } });
    let changed = result(json!({ "problem": "balancing/known-masses", "case": 1, "set": set }));
    assert_eq!(changed["inputs"]["masses[1].radius"]["text"], "31.5 mm");
    assert!(rows(&changed) >= 2, "{changed}");
}

#[test]
fn a_table_is_rows_or_columns() {
    let points: Vec<[f64; 2]> = (8..30)
        .map(|n| f64::from(n) / 2.0)
        .map(|f| [f, 1e-6 / ((1.0 - (f / 10.0).powi(2)).powi(2) + 0.01).sqrt()])
        .collect();
    let solved = |points: Json| {
        let set = json!({ "measurement": { "table": { "points": points } } });
        requested(json!({ "problem": "vibration/frequency-response-identification", "set": set }))
    };
    let answers = |points: Json| solved(points).unwrap_or_else(|errors| panic!("{errors:?}")).json();
    let by_rows = answers(json!(points));
    assert_valid(&by_rows, "identification");
    let column = |at: usize| points.iter().map(|row| row[at]).collect::<Vec<_>>();
    let by_columns = answers(json!({ "frequency": column(0), "receptance": column(1) }));
    let named =
        |row: &[f64; 2]| json!({ "frequency": row[0], "receptance": format!("{} um/N", row[1] * 1e6) });
    let by_names = answers(points.iter().map(named).collect());
    let text = points.iter().map(|[f, h]| format!("{f} Hz; {h} m/N")).collect::<Vec<_>>().join("\n");
    let typed = answers(json!(text));
    assert!(by_rows["answers"].as_object().expect("an object").len() > 3, "{by_rows}");
    assert_eq!(by_rows["answers"], by_columns["answers"]);
    assert_eq!(by_rows["answers"], typed["answers"]);
    for (name, answer) in by_rows["answers"].as_object().expect("an object") {
        assert!(near(&answer["si"], &by_names["answers"][name]["si"]), "{name}: {answer}");
    }
    assert!(by_rows["notes"].as_array().expect("a list").is_empty(), "{by_rows}");
    let wrong = |points: Json| solved(points).unwrap_err().remove(0).1;
    assert!(wrong(json!({ "frequenc": [1, 2] })).contains("there is no `frequenc`"));
    assert!(
        wrong(json!({ "frequency": [1, 2], "receptance": [1] })).contains("has 1 numbers and the first 2")
    );
    assert!(wrong(json!({ "frequency": [1, 2] })).contains("a list of numbers is needed for each column"));
}

#[test]
fn requests_are_answered_line_by_line() {
    let mut child = program(&["serve", "--stdio"]).stdout(Stdio::piped()).spawn().expect("the program runs");
    let mut requests = child.stdin.take().expect("the input is piped");
    let mut replies = BufReader::new(child.stdout.take().unwrap()).lines();
    let mut ask = |line: &str| -> Json {
        writeln!(requests, "{line}").unwrap();
        serde_json::from_str(&replies.next().unwrap().unwrap()).unwrap()
    };
    // The example of the guide.
    for speed in [900, 1000, 1100] {
        let problem = json!({ "problem": FAN, "case": 1, "set": { "speed": format!("{speed} rpm") } });
        let reply = ask(&json!({ "id": speed, "solve": problem }).to_string());
        assert_eq!(reply["id"], speed);
        assert_eq!(reply["result"]["inputs"]["speed"]["text"], format!("{speed} rpm"));
        assert!(reply["result"]["answers"]["amplitude"]["value"].is_number());
    }
    let message = |reply: &Json| reply["errors"][0]["message"].as_str().unwrap_or_default().to_owned();
    let broken = ask("{\"id\": 3, \"solve\":");
    assert_eq!(broken["id"], Json::Null);
    assert!(message(&broken).starts_with("this line is no JSON object"), "{broken}");
    let wrong = ask(r#"{"id": 4, "solve": {"problem": "vibration/rotating-unbalanc"}}"#);
    assert!(message(&wrong).contains("did you mean `vibration/rotating-unbalance`"), "{wrong}");
    let wrong = ask(r#"{"id": 5, "sole": {}}"#);
    assert_eq!(wrong["errors"][0]["repair"], "solve", "{wrong}");
    let wrong = ask(r#"{"id": 6, "solve": {"problem": "-"}}"#);
    assert!(message(&wrong).contains("problem_file"), "{wrong}");
    let only = ask(&json!({ "id": 7, "solve": { "problem": FAN, "only": ["answers"], "lang": "pt-BR", "ask": ["rms_velocity", "twice=2*X"] } }).to_string());
    let keys: Vec<&String> = only["result"].as_object().expect("an object").keys().collect();
    assert_eq!(keys, ["answers"]);
    assert_eq!(only["result"]["answers"]["amplitude"]["shown"], "19,456 mm");
    assert!(
        only["result"]["answers"]
            .as_object()
            .expect("an object")
            .values()
            .any(|answer| answer["asked"] == true)
    );
    assert_eq!(ask(r#"{"id": 8, "list": "flywheel"}"#)["result"][0]["id"], "virtual-work/flywheel");
    let shown = ask(&json!({ "id": 9, "show": FAN }).to_string());
    assert_eq!(shown["result"]["inputs"][0]["name"], "mass");
    assert_eq!(ask(r#"{"id": 10, "schema": "results"}"#)["result"]["$id"], "urn:dalembert:results:1");
    let file = ask(&json!({ "id": 11, "solve": { "problem_file": example("fan.toml") } }).to_string());
    assert!(file["result"]["answers"]["amplitude"].is_object(), "{file}");
    let wrong =
        ask(&json!({ "id": 12, "solve": { "problem": FAN, "unit": { "amplitude": 3 } } }).to_string());
    assert_eq!(wrong["errors"][0]["path"], "unit", "{wrong}");
    let report =
        ask(&json!({ "id": 13, "report": { "problem": FAN, "case": 1, "format": "html_fragment" } })
            .to_string());
    let report = report["result"].as_str().expect("a text");
    assert!(report.starts_with("<div class=\"dalembert\">") && report.contains("19.456 mm"), "{report}");
    let figures = ask(&json!({ "id": 14, "report": { "problem": FAN, "format": "figures" } }).to_string());
    assert!(figures["result"][0]["svg"].as_str().is_some_and(|svg| svg.starts_with("<svg")), "{figures}");
    let wrong = ask(&json!({ "id": 15, "report": { "problem": FAN, "format": "pdf" } }).to_string());
    assert_eq!(wrong["errors"][0]["path"], "format", "{wrong}");
    let file = ask(&json!({ "id": 16, "new": { "problem": FAN, "case": 1 } }).to_string());
    let solved = ask(&json!({ "id": 17, "solve": { "problem_file": file["result"] } }).to_string());
    assert_eq!(solved["result"]["answers"]["amplitude"]["shown"], "19.456 mm");
    // Of an exam question too, whose file holds linked problems.
    let exam = "exam/toggle-press-with-flywheel";
    let file = ask(&json!({ "id": 19, "new": { "problem": exam, "case": 1 } }).to_string());
    let mut answers =
        |problem: Json| ask(&json!({ "id": 20, "solve": problem }).to_string())["result"]["answers"].clone();
    let of_file = answers(json!({ "problem_file": file["result"] }));
    assert!(of_file.as_object().is_some_and(|answers| answers.len() > 9), "{of_file}");
    assert_eq!(of_file, answers(json!({ "problem": exam, "case": 1 })));
    let index = ask(r#"{"id": 18, "index": true}"#);
    let of_fan = index["result"]["analyses"].as_array().expect("a list").iter().find(|one| one["id"] == FAN);
    assert!(
        of_fan
            .is_some_and(|one| one["names"].as_str().is_some_and(|names| names.contains("desbalanceamento")))
    );
    drop(requests);
    assert_eq!(child.wait().unwrap().code(), Some(0));
}

#[test]
fn a_panic_is_a_failure_that_names_its_place() {
    assert!(find(FAN).is_some());
    let failure = guarded("a test", || panic!("on purpose")).map(|()| "nothing").unwrap_err();
    assert_eq!(failure.kind, FailureKind::Internal);
    let message = &failure.errors[0].message;
    assert!(message.contains("a test panicked at") && message.ends_with("on purpose"), "{message}");
}
