//! The command line, run as a user or a script runs it: what is printed, where, and with which exit status.

// Long because a command line has many commands, each of them run as it is typed.
use std::{
    fs,
    io::Write as _,
    path::{Path, PathBuf},
    process::{Command, Output, Stdio},
};

use dalembert_core::{
    Draft, Field, FieldLimit, Fields, Measure, Shape, cases, catalogue, draft::read_leaf, registry,
};
use dalembert_plugins as _;
use dalembert_testkit::on_all_cores;
use dalembert_tests::pty;
use serde_json::Value as Json;

const FAN: &str = "vibration/rotating-unbalance";

/// Runs the program without a terminal, in English unless the environment says otherwise.
fn run(arguments: &[&str], environment: &[(&str, &str)]) -> Output {
    let mut command = crate::program();
    command.args(arguments).envs(environment.iter().copied());
    command.output().expect("the program runs")
}

fn stdout(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).expect("what is printed is UTF-8")
}

fn stderr(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).expect("what is printed is UTF-8")
}

/// Runs the program with a text on its standard input.
fn run_with(arguments: &[&str], input: &[u8]) -> Output {
    let mut child = Command::new(pty::program())
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .env("LC_ALL", "C.UTF-8")
        .env("XDG_CONFIG_HOME", env!("CARGO_TARGET_TMPDIR"))
        .spawn()
        .expect("the program runs");
    // A program that does not read its input to the end closes it.
    let _ = child.stdin.take().expect("the input is piped").write_all(input);
    child.wait_with_output().expect("the program ends")
}

/// Output of a successful run.
fn printed(arguments: &[&str]) -> String {
    let output = run(arguments, &[]);
    assert_eq!(output.status.code(), Some(0), "{arguments:?}: {}", stderr(&output));
    let text = stdout(&output);
    assert!(!text.contains('\x1b'), "{arguments:?} prints control sequences");
    text
}

fn json(arguments: &[&str]) -> Json {
    serde_json::from_str(&printed(arguments)).expect("what is printed is JSON")
}

/// The error of a run that fails with this status; nothing else is printed.
fn refused(arguments: &[&str], status: i32) -> String {
    let output = run(arguments, &[]);
    let error = stderr(&output);
    assert_eq!(output.status.code(), Some(status), "{arguments:?}: {error}");
    assert!(!error.contains("panicked") && !error.contains('\x1b'), "{error}");
    assert!(!error.trim().is_empty());
    if status == 2 {
        assert_eq!(stdout(&output), "", "{arguments:?}");
    }
    error
}

/// A problem file with this text, in a folder that goes with the guard.
fn file(text: &[u8]) -> (tempfile::TempDir, String) {
    let folder = tempfile::tempdir().expect("there is a place for temporary files");
    let path = folder.path().join("problem.toml");
    fs::write(&path, text).expect("the folder is ours");
    let path = path.to_str().expect("the path is UTF-8").to_owned();
    (folder, path)
}

const PROBLEM: &str = r#"analysis = "vibration/rotating-unbalance"
title = "Fan of the paint shop"

[inputs]
mass = "40 kg"
unbalance = "0.1 kg*m"
speed = "1000 rpm"
support.stiffness = { stiffness = "451.389 kN/m" }
damping.ratio = { ratio = 0.0617 }

[show]
amplitude = "um"
"#;

/// The lines of a text from the one that begins so, up to a blank line.
fn part<'t>(text: &'t str, begin: &str) -> String {
    let lines: Vec<&'t str> = text
        .lines()
        .skip_while(|line| !line.starts_with(begin))
        .take_while(|line| !line.is_empty())
        .collect();
    assert!(!lines.is_empty(), "`{begin}` begins no line of\n{text}");
    lines.join("\n")
}

#[test]
fn without_a_terminal_a_worked_solution_is_printed() {
    let text = printed(&[]);
    assert!(text.starts_with("Rotating unbalance\n"), "{text}");
    assert!(text.contains("19.456 mm"));
    let (_folder, path) = file(PROBLEM.as_bytes());
    let text = printed(&[&path]);
    assert!(text.contains("Fan of the paint shop"), "{text}");
    // The file asks for micrometres.
    assert!(part(&text, "Answers").contains("µm"), "{text}");
    assert_eq!(text, printed(&["solve", &path]));
    assert_eq!(printed(&[FAN]), printed(&["solve", FAN]));
}

#[test]
fn analyses_are_listed() {
    let text = printed(&["list"]);
    let all = json(&["list", "--json"]);
    let all = all.as_array().unwrap();
    assert_eq!(all.len(), catalogue().len());
    for entry in catalogue() {
        assert!(text.contains(entry.about.id));
        assert!(all.iter().any(|json| json["id"] == entry.about.id && json["title"] == entry.about.title));
    }
    let fans = json(&["list", "--json", "ventilador", "fan"]);
    assert!(fans.as_array().unwrap().iter().any(|json| json["id"] == FAN), "{fans}");
    // The best match first, with the case that the words speak of.
    let found = printed(&["list", "struck", "meteorite"]);
    assert!(found.contains("rigid-body/free-axisymmetric") && found.contains("▸ Satellite"), "{found}");
    assert_eq!(json(&["list", "--json", "flywheel"])[0]["id"], "virtual-work/flywheel");
    assert_eq!(json(&["list", "--json", "no such thing"]), serde_json::json!([]));
    assert!(refused(&["list", "no such thing"], 2).contains("no such thing"));
}

#[test]
fn an_analysis_is_shown() {
    for entry in registry() {
        let id = entry.about.id;
        let shown = json(&["show", id, "--json"]);
        assert_eq!(shown["id"], id);
        for key in ["inputs", "answers", "sources", "cases"] {
            assert!(shown[key].as_array().is_some_and(|all| !all.is_empty()), "{id}: {key}");
        }
        let text = printed(&["show", id]);
        assert!(text.lines().count() < 1000, "{id}: what is described once is not described again");
        let words = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
        let joined = words(&text);
        for note in notes(&shown["inputs"]) {
            assert!(joined.contains(&words(&note)), "{id}: {note}");
        }
        for answer in shown["answers"].as_array().unwrap() {
            assert!(text.contains(answer["name"].as_str().unwrap()), "{id}: {answer}");
        }
    }
    let shown = json(&["show", FAN, "--json"]);
    let mass = &shown["inputs"][0];
    assert_eq!(
        (&mass["name"], &mass["unit"], &mass["quantity"]),
        (&"mass".into(), &"kg".into(), &"a mass".into())
    );
    assert_eq!(mass["min"], serde_json::json!({ "value": 0.0, "included": false }));
    let statement = shown["cases"][0]["statement"].as_str().expect("an exercise has a statement");
    assert!(statement.starts_with("A fan of 40 kg stands"), "{statement}");
    assert_eq!(shown["cases"][0]["asked"], serde_json::json!(["damping_ratio", "amplitude"]));
    let words = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(words(&printed(&["show", FAN])).contains(statement.trim_end_matches('.')));
    // The statement stands above the data.
    let solved = words(&printed(&["solve", FAN, "--case", "1"]));
    assert!(solved.find(statement) < solved.find("Given data") && solved.contains(statement), "{solved}");
    let text = printed(&["show", FAN]);
    insta::assert_snapshot!("show", text.lines().take(10).collect::<Vec<_>>().join("\n"));
    assert!(
        refused(&["show", "vibration/rotating-unbalence"], 2)
            .contains("did you mean `vibration/rotating-unbalance`")
    );
}

/// The help, defaults and datums of inputs, at whatever depth.
fn notes(json: &Json) -> Vec<String> {
    match json {
        Json::Object(object) => {
            let own = ["help", "default"].iter().filter_map(|key| object.get(*key)?.as_str());
            let own: Vec<String> = own.filter(|text| !text.is_empty()).map(str::to_owned).collect();
            own.into_iter().chain(object.values().flat_map(notes)).collect()
        }
        Json::Array(all) => all.iter().flat_map(notes).collect(),
        _ => Vec::new(),
    }
}

#[test]
fn json_of_a_solve_has_the_agreed_shape() {
    let solved = json(&["solve", FAN, "--case", "1", "--format", "json"]);
    let keys: Vec<&String> = solved.as_object().unwrap().keys().collect();
    assert_eq!(
        keys,
        [
            "format",
            "program",
            "analysis",
            "case",
            "statement",
            "units",
            "notes",
            "inputs",
            "answers",
            "unknowns",
            "definitions",
            "problems",
            "steps",
            "plots",
            "tables",
            "checks",
            "warnings",
            "refusal"
        ]
    );
    assert_eq!(solved["unknowns"], serde_json::json!({}));
    let plot = &solved["plots"][0];
    assert_eq!(plot["over"], serde_json::json!({ "input": "speed", "answer": null }));
    assert_eq!(plot["curves"][0]["of"], "amplitude");
    assert_eq!(solved["analysis"], FAN);
    assert_eq!(solved["refusal"], Json::Null);
    let amplitude = &solved["answers"]["amplitude"];
    assert_eq!(amplitude["shown"], "19.456 mm");
    assert_eq!((&amplitude["unit"], &amplitude["si_unit"]), (&"mm".into(), &"m".into()));
    assert!((amplitude["si"].as_f64().unwrap() - 0.0194564).abs() < 5e-8, "{amplitude}");
    assert!((amplitude["value"].as_f64().unwrap() - 19.4564).abs() < 5e-5, "{amplitude}");
    let lag = &solved["answers"]["phase"];
    assert_eq!((&lag["unit"], &lag["si_unit"]), (&"deg".into(), &"rad".into()));
    let [degrees, radians] = ["value", "si"].map(|key| lag[key].as_f64().unwrap());
    assert!((degrees.to_radians() - radians).abs() < 1e-15, "{lag}");
    let speed = &solved["inputs"]["speed"];
    assert_eq!((&speed["text"], &speed["unit"]), (&"1000 rpm".into(), &"rpm".into()));
    assert_eq!(speed["si_unit"], "rad/s");
    assert!((speed["value"].as_f64().unwrap() - 1000.0).abs() < 1e-12, "{speed}");
    assert!((speed["si"].as_f64().unwrap() - 104.71975511965978).abs() < 1e-9);
    assert_eq!(solved["inputs"]["support"]["text"], "cantilever");
    assert!(solved["checks"].as_array().unwrap().iter().all(|check| check["passed"] == true));
    for entry in registry() {
        // Each run begins the program anew: the first case of every analysis, and every eighth.
        let numbers = 1..=cases::cases(entry).unwrap().len();
        for number in numbers.filter(|number| number % 8 == 1) {
            let output =
                run(&["solve", entry.about.id, "--case", &number.to_string(), "--format", "json"], &[]);
            let solved: Json = serde_json::from_slice(&output.stdout).expect("a refusal is JSON too");
            let refusal = !solved["refusal"].is_null();
            assert_eq!(output.status.code(), Some(i32::from(refusal)), "{}, case {number}", entry.about.id);
            assert_eq!(solved["answers"].as_object().unwrap().is_empty(), refusal);
        }
    }
}

#[test]
fn an_input_is_set_by_its_former_path() {
    let set = |change: &str| {
        let output = run(&["solve", "balancing/field", "--case", "1", "--set", change], &[]);
        assert_eq!(output.status.code(), Some(0), "{change}: {}", stderr(&output));
        (stdout(&output), stderr(&output))
    };
    let (now, quiet) = set("measured.first[1].phase=31 deg");
    let (former, note) = set("measured.velocity.first[1].phase=31 deg");
    assert_eq!(now, former);
    assert_eq!(quiet, "");
    assert!(note.contains("measured.velocity.first[1].phase: read as measured.first[1].phase"), "{note}");
}

#[test]
fn inputs_units_and_digits_are_changed() {
    let solved = json(&["solve", FAN, "--case", "1", "--set", "speed=1500 rpm", "--format", "json"]);
    assert_eq!(solved["inputs"]["speed"]["text"], "1500 rpm");
    // r = 1.479, far above resonance: X = (m₀e/m) r²/√((1 − r²)² + (2ζr)²).
    assert_eq!(solved["answers"]["amplitude"]["shown"], "4.5535 mm");
    let change = "support.stiffness.stiffness=451,3889 kN/m";
    let other = json(&["solve", FAN, "--case", "1", "--set", change, "--format", "json"]);
    assert_eq!(other["inputs"]["support"]["text"], "stiffness");
    let shown = |more: &[&str]| {
        let arguments = [&["solve", FAN, "--format", "json"], more].concat();
        json(&arguments)["answers"]["amplitude"]["shown"].as_str().unwrap().to_owned()
    };
    assert_eq!(shown(&["--unit", "amplitude=um"]), "19456 µm");
    assert_eq!(shown(&["--digits", "3"]), "19.5 mm");
    assert_eq!(shown(&["--lang", "pt-BR"]), "19,456 mm");
    assert_eq!(shown(&["--unit", "amplitude=um", "--ascii"]), "19456 um");
    for (arguments, words) in [
        (["--unit", "amplitude=kg"], "write a unit like mm"),
        (["--unit", "transmitted_force=lb"], "lb is a mass: write `lbf`"),
        (["--unit", "amplitud=mm"], "did you mean `amplitude`"),
        (["--unit", "amplitude=mmm"], "mmm"),
        (["--unit", "amplitude"], "--unit amplitude=um"),
        (["--set", "mass"], "--set mass=\"40 kg\""),
        (["--set", "mas=4 kg"], "did you mean `mass`"),
        (["--set", "support=rope"], "rope"),
        (["--set", "masses[0].radius=1 m"], "masses"),
        (["--set", "support=@/no/such/file"], "@/no/such/file"),
        (["--case", "99"], "99"),
        (["--case", "0"], "0"),
        (["--digits", "40"], "40"),
        (["--format", "docx"], "docx"),
        (["--table", "plots"], "plots"),
    ] {
        let arguments = [
            &["solve", FAN, "--format", "csv"][..if arguments[0] == "--format" { 2 } else { 4 }],
            &arguments,
        ]
        .concat();
        assert!(refused(&arguments, 2).contains(words), "{arguments:?}: {}", refused(&arguments, 2));
    }
}

#[test]
fn a_worked_solution_is_written_in_every_format() {
    let text = printed(&["solve", FAN]);
    assert!(text.lines().all(|line| line.chars().count() <= 80), "{text}");
    insta::assert_snapshot!("answers", part(&text, "Answers"));
    insta::assert_snapshot!("first_step", part(&text, "1. "));
    let markdown = printed(&["solve", FAN, "--format", "markdown"]);
    assert!(markdown.starts_with("# Rotating unbalance\n"));
    assert!(markdown.contains("\n    k = 3 E I / L³\n"), "{markdown}");
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("fan.md");
    assert_eq!(printed(&["solve", FAN, "--format", "markdown", "-o", path.to_str().unwrap()]), "");
    // A file has its figures beside it.
    let written = fs::read_to_string(&path).unwrap();
    assert!(written.contains("](<fan-1.svg>)"), "{written}");
    assert!(fs::read_to_string(path.with_file_name("fan-1.svg")).unwrap().starts_with("<svg"));
    for line in markdown.lines() {
        assert!(written.contains(line), "{line}");
    }
    for (name, begins) in
        [("fan.html", "<!DOCTYPE html>"), ("fan.tex", "\\documentclass"), ("other.typ", "#set")]
    {
        let path = path.with_file_name(name);
        assert_eq!(printed(&["solve", FAN, "-o", path.to_str().unwrap()]), "");
        assert!(fs::read_to_string(&path).unwrap().starts_with(begins), "{name}");
    }
    assert!(
        refused(&["solve", FAN, "-o", "/no/such/folder/fan.txt"], 2)
            .contains("folder /no/such/folder not found")
    );
    for table in ["answers", "inputs", "steps", "checks", "plot-1"] {
        let csv = printed(&["solve", FAN, "--format", "csv", "--table", table, "--lang", "pt-BR"]);
        let lines: Vec<&str> = csv.split_terminator("\r\n").collect();
        assert!(lines.len() > 1, "{table}: {csv}");
        let columns = cells(lines[0]);
        assert!(lines.iter().all(|line| cells(line) == columns), "{table}: {csv}");
    }
    let answers = printed(&["solve", FAN, "--format", "csv", "--lang", "pt-BR"]);
    let amplitude = answers.lines().find(|line| line.starts_with("amplitude,")).unwrap();
    assert!(amplitude.contains(",19.456") && amplitude.contains(",mm,0.01945"), "{amplitude}");
}

/// The number of cells of a line.
fn cells(line: &str) -> usize {
    let mut quoted = false;
    1 + line
        .chars()
        .filter(|c| {
            quoted ^= *c == '"';
            *c == ',' && !quoted
        })
        .count()
}

#[test]
fn both_languages_and_ascii() {
    let portuguese = run(&["solve", FAN], &[("LANG", "pt_BR.UTF-8")]);
    assert!(stdout(&portuguese).contains("19,456 mm"));
    let overruled =
        run(&["solve", FAN, "--lang", "en"], &[("LC_ALL", "pt_BR.UTF-8"), ("LANG", "pt_BR.UTF-8")]);
    assert_eq!(stdout(&overruled), printed(&["solve", FAN]));
    assert_eq!(printed(&["--lang", "pt-BR", "solve", FAN]), stdout(&portuguese));
    assert!(stdout(&run(&["--help"], &[("LC_MESSAGES", "pt_BR")])).contains("Listar as análises"));
    on_all_cores(registry(), |n, entry| {
        for command in [vec!["solve"], vec!["show"], vec!["verify"]] {
            for language in ["en", "pt-BR"] {
                let arguments = [&command[..], &[entry.about.id, "--ascii", "--lang", language]].concat();
                let text = printed(&arguments);
                assert!(text.is_ascii(), "{arguments:?}: {:?}", text.lines().find(|line| !line.is_ascii()));
                if n % 4 != 0 || command == ["verify"] {
                    continue;
                }
                // Questions that are asked in words stay; what has no ASCII would become one more.
                let questions = printed(
                    &arguments[..arguments.len() - 3]
                        .iter()
                        .copied()
                        .chain(["--lang", language])
                        .collect::<Vec<_>>(),
                );
                assert_eq!(text.matches('?').count(), questions.matches('?').count(), "{arguments:?}");
            }
        }
    });
}

#[test]
fn every_published_answer_is_verified() {
    let verified = json(&["verify", "--json"]);
    let rows = verified["rows"].as_array().unwrap();
    let count = |verdict: &str| rows.iter().filter(|row| row["verdict"] == verdict).count();
    for verdict in ["agreed", "disputed", "differing"] {
        assert_eq!(verified[verdict], count(verdict));
    }
    assert_eq!(count("differing"), 0, "{verified:#}");
    let kinds = ["published", "closed form", "other program", "own earlier value", "refusal"];
    assert_eq!(verified["by_truth"].as_object().unwrap().keys().collect::<Vec<_>>(), kinds);
    for kind in kinds {
        let counted = &verified["by_truth"][kind];
        let count = |verdict: &str| {
            rows.iter().filter(|row| row["truth"] == kind && row["verdict"] == verdict).count()
        };
        assert_eq!(
            (&counted["agreed"], &counted["disputed"]),
            (&count("agreed").into(), &count("disputed").into())
        );
    }
    for row in rows {
        let keys: Vec<&String> = row.as_object().unwrap().keys().collect();
        let named =
            ["analysis", "case", "source", "truth", "seen", "answer", "printed", "ours", "verdict", "why"];
        assert_eq!(keys, named);
        assert_eq!(row["truth"] == "published", !row["seen"].is_null(), "{row}");
        assert!(row["verdict"] != "disputed" || row["why"] != "", "{row}");
    }
    let amplitude = rows.iter().find(|row| row["analysis"] == FAN && row["answer"] == "amplitude").unwrap();
    assert_eq!((&amplitude["printed"], &amplitude["verdict"]), (&"1.743 mm".into(), &"disputed".into()));
    let text = printed(&["verify"]);
    let total = format!("{} agreed, {} disputed, 0 differing", count("agreed"), count("disputed"));
    assert_eq!(text.lines().last(), Some(total.as_str()));
    // Nothing verified does not pass for verified.
    assert!(refused(&["verify", "no such thing"], 2).contains("no such thing"));
}

#[test]
fn a_schema_describes_every_problem_file() {
    for entry in registry() {
        let schema = json(&["schema", entry.about.id]);
        assert_eq!(schema["properties"]["analysis"]["const"], entry.about.id);
        let known = schema["properties"]["inputs"]["properties"].as_object().unwrap();
        assert_eq!(known.len(), entry.fields().len());
        for field in entry.fields() {
            assert!(known.contains_key(field.name), "{}: {}", entry.about.id, field.name);
        }
        references(&schema, &schema["$defs"]);
    }
    let schema = json(&["schema", FAN]);
    assert_eq!(schema["properties"]["inputs"]["properties"]["mass"]["exclusiveMinimum"], 0.0);
    assert!(refused(&["schema", "fan"], 2).contains("fan"));
}

/// Every `$ref` names a definition.
fn references(json: &Json, definitions: &Json) {
    match json {
        Json::Object(object) => {
            if let Some(name) = object.get("$ref") {
                let name = name
                    .as_str()
                    .and_then(|name| name.strip_prefix("#/$defs/"))
                    .expect("references stay in the schema");
                assert!(definitions[name].is_object(), "{name}");
            }
            object.values().for_each(|inner| references(inner, definitions));
        }
        Json::Array(all) => all.iter().for_each(|inner| references(inner, definitions)),
        _ => {}
    }
}

#[test]
fn the_other_subcommands_print_something() {
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        assert!(printed(&["completions", shell]).contains("dalembert"), "{shell}");
    }
    assert!(printed(&["man"]).starts_with(".ie"));
    assert!(printed(&["man", "solve"]).contains("\\-\\-set"));
    assert!(refused(&["man", "sove"], 2).contains("did you mean `solve`"));
    assert!(printed(&["info"]).contains(env!("CARGO_PKG_VERSION")));
    assert!(printed(&["--version"]).contains(env!("CARGO_PKG_VERSION")));
    for wrong in [
        &["--no-such-option"][..],
        &["solve"],
        &["completions", "csh"],
        &["--lang", "fr", "list"],
        &["fan.toml", "list"],
    ] {
        refused(wrong, 2);
    }
}

#[test]
fn a_shell_is_offered_what_belongs_to_the_problem_on_the_line() {
    let offered = |words: &[&str]| -> Vec<String> {
        let words = [&["--", "dalembert"], words].concat();
        let output = run(&words, &[("DALEMBERT_COMPLETE", "fish")]);
        let lines = stdout(&output);
        lines.lines().map(|line| line.split('\t').next().unwrap_or(line).to_owned()).collect()
    };
    let (_folder, file) = file(b"format = 2\nanalysis = \"vibration/rotating-unbalance\"\n[inputs]\nmass = \"40 kg\"\nunbalance = \"0.1 kg*m\"\nspeed = \"900 rpm\"\nsupport.stiffness.stiffness = \"400 kN/m\"\ndamping.ratio.ratio = \"0.05\"\n");
    for (words, wanted, count) in [
        (&["solve", "vibration/rotating-u"][..], FAN, 1),
        (&["show", "vibration/rotating-u"], FAN, 1),
        (&["vibration/rotating-u"], FAN, 1),
        (&["solve", FAN, "--set", "support."], "support.cantilever.length=", 4),
        (&["solve", &file, "--set", "support."], "support.stiffness.stiffness=", 1),
        (&["solve", FAN, "--unit", "amplitude"], "amplitude=", 1),
        (&["find", FAN, "--input", "spe"], "speed", 1),
        (&["study", FAN, "--vary", "spe"], "speed=", 1),
        (&["study", FAN, "--answers", "natural"], "natural_frequency", 1),
        (&["study", FAN, "--sampling", "so"], "sobol", 1),
    ] {
        let offered = offered(words);
        assert!(offered.iter().any(|value| value == wanted), "{words:?}: {offered:?}");
        assert_eq!(offered.len(), count, "{words:?}: {offered:?}");
    }
    let offered = stdout(&run(
        &["--", "dalembert", "solve", "vibration/rotating-u"],
        &[("DALEMBERT_COMPLETE", "fish"), ("LANG", "pt_BR.UTF-8")],
    ));
    assert!(offered.contains("Desbalanceamento"), "{offered}");
}

#[test]
fn a_reader_that_leaves_is_no_failure() {
    let mut child = Command::new(pty::program())
        .args(["verify", "--json"])
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    assert_eq!(stderr(&output), "");
}

#[test]
fn a_problem_without_an_answer_is_refused_in_words() {
    let mut refusals = 0;
    for entry in registry() {
        for (n, case) in cases::cases(entry).unwrap().iter().enumerate() {
            if let Some(words) = &case.refused {
                refusals += 1;
                let error = refused(&["solve", entry.about.id, "--case", &(n + 1).to_string()], 1);
                assert!(error.to_lowercase().contains(&words.to_lowercase()), "{error}");
            }
        }
    }
    assert!(refusals > 0);
}

#[test]
fn wrong_problem_files_are_pointed_into() {
    let wrong = PROBLEM
        .replace("mass = \"40 kg\"", "mass = \"40 s\"")
        .replace("0.1 kg*m", "0.1 kgg*m")
        .replace("ratio = 0.0617", "ratio = -1");
    let (_folder, path) = file(wrong.as_bytes());
    let error = refused(&["solve", &path], 2);
    // All errors at once, each with its line and column.
    for words in [
        format!("{path}:5:9"),
        "a mass expected".into(),
        format!("{path}:6:18"),
        "did you mean `kg`".into(),
        format!("{path}:9:27"),
        "damping.ratio.ratio: must not be below zero".into(),
    ] {
        assert!(error.contains(&words), "{words} is missing in\n{error}");
    }
    let unknown = PROBLEM.replace("mass =", "mas =").replace("[show]", "[shaw]");
    let (_folder, path) = file(unknown.as_bytes());
    let error = refused(&["solve", &path], 2);
    assert!(error.contains("did you mean `mass`") && error.contains(&format!("{path}:5:1")), "{error}");
    assert!(error.contains("did you mean `show`"), "{error}");
}

#[test]
fn files_that_are_no_problem_are_refused_in_one_message() {
    let deep = format!("analysis = \"{FAN}\"\ninputs = {}1{}", "[".repeat(100_000), "]".repeat(100_000));
    let dotted = format!("analysis = \"{FAN}\"\n[inputs]\n{}x = 1", "a.".repeat(100_000));
    let long = PROBLEM.replace("40 kg", &"9".repeat(10_000_000));
    for (text, words) in [
        (&b"\x7fELF\x02\x01\x01\0\0\xff\xfe"[..], "not UTF-8"),
        (b"", "analysis"),
        (b"analysis =", ":1:"),
        (b"inputs = 3", "analysis"),
        (b"analysis = 3", "must be a text"),
        (b"analysis = \"vibration/rotating-unbalence\"", "did you mean `vibration/rotating-unbalance`"),
        (b"format = 99\nanalysis = \"x\"", "99"),
        (b"analysis = \"vibration/rotating-unbalance\"\n[inputs]\nmass = 1\nmass = 2", "duplicate key"),
        (deep.as_bytes(), "problem.toml"),
        (dotted.as_bytes(), "problem.toml"),
        (long.as_bytes(), "mass"),
        (b"analysis = \"\x1b[31m\"", ":1:"),
    ] {
        let (_folder, path) = file(text);
        let error = refused(&["solve", &path], 2);
        assert!(error.contains(words), "{words} is missing in\n{}", &error[..error.len().min(2000)]);
        assert!(error.len() < 4000, "{} bytes of error for {words}", error.len());
    }
    let (folder, path) = file(b"#");
    fs::File::options()
        .append(true)
        .open(&path)
        .and_then(|file| file.set_len(300 << 20))
        .expect("a hole of 300 MiB");
    assert!(refused(&["solve", &path], 2).contains("256 MiB"));
    assert!(refused(&["solve", folder.path().to_str().unwrap()], 2).contains("folder"));
    assert!(refused(&["solve", "no-such-file.toml"], 2).contains("not found: check"));
    assert!(refused(&["no-such-file.toml"], 2).contains("not found: check"));
    assert!(refused(&["solve", "/dev/null"], 2).contains("device"));
}

/// Nonsense for every field.
fn nonsense() -> Vec<(&'static str, String)> {
    vec![
        ("empty", String::new()),
        ("letters", "abc".into()),
        ("wrong dimension", "3 s^5".into()),
        ("wrong kind", "3 J/rad^2*kg".into()),
        ("two decimal marks", "1.000,5".into()),
        ("too large", "1e400".into()),
        ("not a number", "nan".into()),
        ("infinite", "inf".into()),
        ("control characters", "3\u{7}\u{1b}[31m".into()),
        ("invisible characters", "3\u{202e}".into()),
        ("10 MB", "9".repeat(10_000_000)),
    ]
}

#[test]
fn every_kind_of_field_refuses_nonsense() {
    static COLUMNS: &[Field] = &[Field {
        name: "mass",
        label: "Mass",
        help: "",
        symbol: "m",
        default: None,
        default_before: None,
        kept_in: None,
        former: &[],
        shape: Shape::Quantity(KILOGRAM),
    }];
    const KILOGRAM: Measure = Measure { min: FieldLimit::Excluding(0.0), ..Measure::in_unit("kg") };
    let any: &[&str] = &[];
    // What a text may be: anything that is one visible line.
    let words = &[
        "empty",
        "letters",
        "wrong dimension",
        "wrong kind",
        "two decimal marks",
        "too large",
        "not a number",
        "infinite",
        "invisible characters",
    ][..];
    for (kind, shape, permitted) in [
        ("quantity", Shape::Quantity(KILOGRAM), any),
        ("vector", Shape::Vector(KILOGRAM, 2), any),
        ("flag", Shape::Flag, any),
        ("count", Shape::Count { min: 1, max: 20 }, any),
        ("table", Shape::Table(Fields(&|| COLUMNS)), any),
        ("text", Shape::Text, words),
        ("reference", Shape::Reference("bodies"), &words[1..]),
    ] {
        for (what, text) in nonsense() {
            match read_leaf(&text, &shape, "masses[1].mass") {
                Ok(_) => assert!(permitted.contains(&what), "{kind} takes {what}"),
                Err(errors) => {
                    assert!(!permitted.contains(&what), "{kind} refuses {what}: {errors:?}");
                    assert!(errors.iter().all(|err| err.path == "masses[1].mass"), "{errors:?}");
                    let words = errors.iter().map(|err| err.why.english()).collect::<String>();
                    assert!((5..2000).contains(&words.len()), "{kind}, {what}: {words}");
                }
            }
        }
    }
    assert!(read_leaf("-3 kg", &Shape::Quantity(KILOGRAM), "mass").is_err());
    assert!(read_leaf("21", &Shape::Count { min: 1, max: 20 }, "teeth").is_err());
}

#[test]
fn nonsense_in_any_input_of_any_analysis_is_named() {
    for entry in registry() {
        let shape = entry.shape();
        let case = cases::first(entry).expect("every analysis has a case");
        let mut paths = Vec::new();
        case.record(entry).unwrap().leaves(&mut |path, _, _| paths.push(path.to_owned()));
        for path in paths {
            for (what, text) in nonsense() {
                let mut draft: Draft = case.draft.clone();
                let errors = match draft.set(&shape, &path, &text) {
                    Err(err) => vec![err],
                    Ok(()) => draft.read(&shape).err().unwrap_or_default(),
                };
                // Other rows may refer to a name that is changed: those are named instead.
                let about_it = errors.iter().all(|err| err.path.starts_with(&path) || !err.path.is_empty());
                assert!(about_it, "{}: {path}, {what}: {errors:?}", entry.about.id);
            }
        }
    }
}

#[test]
fn errors_name_field_value_and_repair() {
    for (value, repair) in [
        ("", "for example"),
        ("abc", "write"),
        ("40 s", "a mass expected"),
        ("40 N", "weight"),
        ("1.000,5 kg", "write"),
        ("-3 kg", "must be above zero"),
        ("1e400 kg", "below 1e300"),
        ("nan", "write"),
        ("3\u{7}", ""),
        ("4o kg", ""),
    ] {
        let error = refused(&["solve", FAN, "--case", "1", "--set", &format!("mass={value}")], 2);
        assert!(error.starts_with("error: mass"), "{error}");
        assert!(error.contains(repair), "{value}: {error}");
        assert!(value.contains('\u{7}') || error.contains(value), "{value}: {error}");
    }
    // Several at once.
    let error = refused(
        &["solve", FAN, "--case", "1", "--set", "mass=40 s", "--set", "speed=fast", "--set", "foo=1"],
        2,
    );
    assert_eq!(error.lines().count(), 3, "{error}");
}

#[test]
fn nothing_is_filled_in_silently() {
    let hoop = |format: &str| {
        format!("{format}analysis = \"rigid-body/rolling-stability\"\n[inputs]\nradius = \"0.3 m\"\n")
    };
    let (_folder, path) = file(hoop("format = 2\n").as_bytes());
    let error = refused(&["solve", &path], 2);
    assert!(error.contains("wheel: write one of disc, hoop, moments, radii"), "{error}");
    // An older file means what it meant, and reports it.
    let (_folder, path) = file(hoop("").as_bytes());
    let output = run(&["solve", &path], &[]);
    assert!(stderr(&output).contains("note: inputs.wheel omitted: disc"), "{}", stderr(&output));
    assert!(stdout(&output).contains("0.99045 m/s"), "{}", stdout(&output));
    let solved = json(&["solve", &path, "--format", "json"]);
    assert!(solved["notes"].to_string().contains("inputs.wheel omitted: disc"), "{solved}");
    // What is not set is not that of a published case.
    let set = ["--set", "wheel=hoop", "--set", "radius=0.3 m"];
    let error = refused(&[&["solve", "rigid-body/rolling-stability"], &set[..]].concat(), 2);
    assert!(error.contains("motion: write one of") && error.contains("--case 1"), "{error}");
    let error = refused(&["solve", FAN, "--set", "speed=1500 rpm"], 2);
    for path in ["mass", "unbalance", "support", "damping"] {
        assert!(error.lines().any(|line| line.starts_with(&format!("error: {path}:"))), "{path}: {error}");
    }
}

#[test]
fn numbers_without_a_unit_are_reported_or_refused() {
    let (_folder, path) = file(PROBLEM.replace("\"40 kg\"", "40").as_bytes());
    let output = run(&["solve", &path], &[]);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    assert_eq!(stderr(&output), "warning: mass = 40: no unit; kg assumed\n");
    assert!(stdout(&output).contains("mass = 40: no unit; kg assumed"), "{}", stdout(&output));
    let error = refused(&["solve", &path, "--strict"], 2);
    assert!(error.contains("mass: no unit; kg assumed") && error.contains("problem.toml:5:8"), "{error}");
    let set = ["solve", FAN, "--case", "1", "--set", "mass=1500"];
    assert_eq!(stderr(&run(&set, &[])), "warning: mass = 1500: no unit; kg assumed\n");
    assert!(refused(&[&set[..], &["--strict"]].concat(), 2).contains("mass = 1500: no unit"));
    // Published cases, a number that has no unit, and zero are as they should be.
    for id in [FAN, "rigid-body/rolling-stability", "virtual-work/mechanism"] {
        assert_eq!(stderr(&run(&["solve", id, "--strict"], &[])), "", "{id}");
    }
    let (_folder, path) = file(PROBLEM.as_bytes());
    assert_eq!(stderr(&run(&["solve", &path, "--strict"], &[])), "");
}

#[test]
fn a_comma_before_three_digits_is_refused_with_both_readings() {
    let solve = |value: &str, lang: &str| {
        run(&["solve", FAN, "--case", "1", "--lang", lang, "--set", &format!("mass={value}")], &[])
    };
    for (value, first, second) in [
        ("1,250 kg", "1250", "1.250"),
        ("12,345 kg", "12345", "12.345"),
        ("2*123,456 kg", "123456", "123.456"),
    ] {
        for lang in ["en", "pt-BR"] {
            let output = solve(value, lang);
            let error = stderr(&output);
            assert_eq!(output.status.code(), Some(2), "{value}: {error}");
            assert!(
                error.contains(&format!("`{first}`")) && error.contains(&format!("`{second}`")),
                "{value}: {error}"
            );
        }
    }
    for value in ["0,125 kg", "1,25 kg", "1,2500 kg", "1.250 kg", "1250,5 kg"] {
        let error = stderr(&solve(value, "en"));
        assert!(!error.contains("error"), "{value}: {error}");
    }
    // An older file keeps the decimal comma it had.
    let of = |format: &str| format!("{format}{}", PROBLEM.replace("40 kg", "1,250 kg"));
    let (_folder, path) = file(of("format = 2\n").as_bytes());
    assert!(refused(&["solve", &path], 2).contains("`1.250`"));
    let (_folder, path) = file(of("").as_bytes());
    let solved = json(&["solve", &path, "--format", "json"]);
    let mass = &solved["inputs"]["mass"];
    assert_eq!((&mass["si"], &mass["text"]), (&1.25.into(), &"1.250 kg".into()));
    assert!(solved["notes"].to_string().contains("1,250 kg: read as 1.250 kg"), "{solved}");
}

#[test]
fn a_point_before_three_digits_is_reported_where_the_language_has_the_comma() {
    let solve = |lang: &str, more: &[&str]| {
        let arguments = ["solve", FAN, "--case", "1", "--lang", lang, "--set", "speed=1.200 rpm"];
        run(&[&arguments, more].concat(), &[])
    };
    assert_eq!(stderr(&solve("en", &[])), "");
    let output = solve("pt-BR", &[]);
    assert_eq!(output.status.code(), Some(0));
    assert!(stderr(&output).contains("aviso: --set speed: 1.200"), "{}", stderr(&output));
    assert_eq!(solve("pt-BR", &["--strict"]).status.code(), Some(2));
}

/// As `solve` has it: the inputs that are not set are not those of a published case.
#[test]
fn what_is_set_is_all_that_a_question_knows() {
    let set = [
        "--set",
        "mass=100 kg",
        "--set",
        "unbalance=0.05 kg*m",
        "--set",
        "support.stiffness.stiffness=1 MN/m",
        "--set",
        "damping.ratio.ratio=0.05",
        "--set",
        "speed=900 rpm",
    ];
    let amplitude =
        json(&[&["solve", FAN, "--format", "json"], &set[..]].concat())["answers"]["amplitude"].clone();
    let typed = format!("amplitude={} m", amplitude["si"]);
    let answers = json(&[&["check", FAN, "--json", &typed], &set[..]].concat());
    assert_eq!(answers["answers"][0]["verdict"], "correct", "{answers}");
    let without_mass = &set[2..];
    for question in [
        vec!["check", FAN, "amplitude=1 mm"],
        vec!["sensitivity", FAN, "amplitude"],
        vec!["find", FAN, "speed", "amplitude<=1 mm", "--from", "100 rpm", "--to", "900 rpm"],
    ] {
        let error = refused(&[&question[..], without_mass].concat(), 2);
        assert!(error.contains("mass"), "{question:?}: {error}");
    }
    let found = printed(
        &[&["find", FAN, "speed", &typed, "--from", "800 rpm", "--to", "1000 rpm"], &set[..8]].concat(),
    );
    assert!(found.contains("900 rpm"), "{found}");
}

#[test]
fn a_problem_is_begun_filled_in_and_solved() {
    let empty = printed(&["new", FAN]);
    let (folder, path) = file(empty.as_bytes());
    let error = refused(&["solve", &path], 2);
    let missing = ["mass", "unbalance", "support.stiffness.stiffness", "damping.ratio.ratio", "speed"];
    for input in missing {
        assert!(error.contains(&format!("{input}: a value is needed")), "{input}: {error}");
    }
    assert_eq!(error.matches("a value is needed").count(), missing.len(), "{error}");
    let portuguese = printed(&["new", FAN, "--lang", "pt-BR"]);
    assert!(portuguese.contains("## Massa da máquina") && portuguese.contains("mass = \"\""), "{portuguese}");
    // Filled in, it is the case.
    let filled = folder.path().join("filled.toml");
    let filled = filled.to_str().unwrap();
    assert_eq!(printed(&["new", FAN, "--case", "2", "-o", filled]), "");
    assert_eq!(fs::read_to_string(filled).unwrap(), printed(&["new", FAN, "--case", "2"]));
    let answers = |solved: Json| solved["answers"].clone();
    assert_eq!(
        answers(json(&["solve", filled, "--format", "json"])),
        answers(json(&["solve", FAN, "--case", "2", "--format", "json"]))
    );
    // An existing file is written over only where that is said.
    assert!(refused(&["new", FAN, "-o", filled], 2).contains("already exists"));
    printed(&["new", FAN, "-o", filled, "--force"]);
    assert_eq!(fs::read_to_string(filled).unwrap(), empty);
    assert!(refused(&["new", FAN, "--case", "99"], 2).contains("has no case 99"));
    assert!(refused(&["new", "vibration/rotating-unbalence"], 2).contains("did you mean"));
}

#[test]
fn a_usual_question_is_listed_and_asked_by_its_name() {
    let id = "vibration/rotating-unbalance";
    let shown = printed(&["show", id]);
    let listed = part(&shown, "Usual questions");
    assert!(listed.contains("--ask peak_to_peak"), "{listed}");
    let questions = json(&["show", id, "--json"])["questions"].clone();
    let questions = questions.as_array().expect("it lists them");
    assert!(questions.len() > 20, "{questions:?}");
    assert_eq!(questions[0]["key"], "peak_to_peak");
    assert_eq!(questions[0]["formula"], "2*amplitude");
    // By its key, by its words, and by its words in Portuguese, beside a question with a formula.
    for name in ["rms_velocity", "Root mean square of the velocity"] {
        let solved = json(&["solve", id, "--ask", name, "--ask", "half=X/2", "--format", "json"]);
        let answers = solved["answers"].as_object().expect("it has answers");
        let asked: Vec<&String> =
            answers.iter().filter(|(_, answer)| answer["asked"] == true).map(|(name, _)| name).collect();
        assert_eq!(asked, ["half", "rms_velocity"], "{solved}");
    }
    let portuguese = printed(&["solve", id, "--lang", "pt-BR", "--ask", "Valor eficaz da velocidade"]);
    assert!(portuguese.contains("1440,7 mm/s"), "{portuguese}");
    let error = refused(&["solve", id, "--ask", "rms_velocty"], 2);
    assert!(error.contains("did you mean `rms_velocity`?"), "{error}");
    let error = refused(&["solve", id, "--ask", "colour"], 2);
    assert!(error.contains("as in --ask 'peak to peak=2*X', or one of peak_to_peak"), "{error}");
    // The inputs that are set count.
    let doubled =
        printed(&["solve", id, "--case", "1", "--set", "speed=500 rpm", "--ask", "unbalance_force"]);
    assert!(doubled.contains("274.16 N"), "{doubled}");
}

#[test]
fn a_problem_is_read_from_the_standard_input() {
    let solved = run_with(&["solve", "-"], PROBLEM.as_bytes());
    let (_folder, path) = file(PROBLEM.as_bytes());
    assert_eq!((solved.status.code(), stdout(&solved)), (Some(0), printed(&["solve", &path])));
    assert_eq!(stdout(&run_with(&["-"], PROBLEM.as_bytes())), printed(&[&path]));
    for (text, words) in [
        (PROBLEM.replace("40 kg", "40 s"), "<stdin>:5:"),
        (PROBLEM.replace("mass =", "mess ="), "<stdin>:5:"),
        ("analysis = ".to_owned(), "<stdin>:1:"),
        (String::new(), "<stdin>"),
    ] {
        let refused = run_with(&["solve", "-"], text.as_bytes());
        assert_eq!((refused.status.code(), stdout(&refused)), (Some(2), String::new()));
        assert!(stderr(&refused).contains(words), "{words}: {}", stderr(&refused));
    }
    let refused = run_with(&["solve", "-"], b"\xff\xfe");
    assert!(stderr(&refused).contains("<stdin> is not UTF-8"), "{}", stderr(&refused));
    let session = "size 80 24\ntype q\n";
    let (_folder, path) = file(session.as_bytes());
    assert_eq!(
        stderr(&run_with(&["replay", "-", "--headless"], session.as_bytes())),
        stderr(&run(&["replay", &path, "--headless"], &[]))
    );
}

#[test]
fn a_value_alone_is_set_as_the_only_input_of_an_alternative() {
    let solve = |damping: &str| run(&["solve", FAN, "--case", "1", "--set", damping], &[]);
    let full = solve("damping.ratio.ratio=0.05");
    for damping in ["damping=0.05", "damping.ratio=0.05"] {
        let solved = solve(damping);
        assert_eq!(stdout(&solved), stdout(&full), "{damping}");
        assert!(stderr(&solved).contains("note: damping"), "{}", stderr(&solved));
    }
    let error = refused(&["solve", FAN, "--case", "1", "--set", "support.cantilever=1"], 2);
    assert!(error.contains("name one of them: support.cantilever.length"), "{error}");
}

#[test]
fn no_file_is_written_over_unasked() {
    let (folder, path) = file(PROBLEM.as_bytes());
    let at = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let text = |name: &str| fs::read_to_string(at(name)).unwrap();
    fs::write(at("other.toml"), PROBLEM).unwrap();
    for force in [&[][..], &["--force"]] {
        let error = refused(&[&["solve", &path, "-o", &path], force].concat(), 2);
        assert!(error.contains("is the problem itself"), "{error}");
        let error = refused(&[&["solve", &path, "-o", &at("other.toml")], force].concat(), 2);
        assert!(error.contains("is a problem file"), "{error}");
    }
    assert_eq!((text("problem.toml").as_str(), text("other.toml").as_str()), (PROBLEM, PROBLEM));
    fs::write(at("notes.txt"), "notes").unwrap();
    assert!(refused(&["solve", &path, "-o", &at("notes.txt")], 2).contains("--force"));
    assert_eq!(text("notes.txt"), "notes");
    printed(&["solve", &path, "-o", &at("notes.txt"), "--force"]);
    assert!(text("notes.txt").contains("Fan of the paint shop"));
    // Nor a figure beside the report.
    fs::write(at("p-1.svg"), "mine").unwrap();
    assert!(refused(&["solve", &path, "-o", &at("p.md")], 2).contains("p-1.svg"));
    assert_eq!((text("p-1.svg").as_str(), Path::new(&at("p.md")).exists()), ("mine", false));
    printed(&["solve", &path, "-o", &at("p.md"), "--force"]);
    assert!(text("p-1.svg").starts_with("<svg"));
}

#[test]
fn of_many_errors_the_first_hundred_are_reported() {
    let problem = |rows: usize, mass: &str| {
        let row = format!(
            "[[inputs.masses]]\nmass = \"{mass}\"\nradius = \"1 m\"\nangle = \"0 deg\"\nposition = \"0 m\"\n"
        );
        format!(
            "format = 2\nanalysis = \"balancing/two-plane\"\n[inputs]\nplane_b = \"1 m\"\n{}",
            row.repeat(rows)
        )
    };
    let (_folder, path) = file(problem(1000, "1 kgg").as_bytes());
    let error = refused(&["solve", &path], 2);
    assert_eq!(error.lines().filter(|line| line.starts_with("error: ")).count(), 100, "{error}");
    assert!(error.contains("masses[1].mass") && error.contains("more errors"), "{error}");
    let (_folder, path) = file(problem(1001, "1 kg").as_bytes());
    let error = refused(&["solve", &path], 2);
    assert!(error.contains("1001 rows: at most 1000 are accepted here"), "{error}");
    let links = vec!["{ driving = \"1 m\", driven = \"2 m\" }"; 10_000].join(", ");
    let text = format!("format = 2\nanalysis = \"virtual-work/compound-lever\"\ninputs.links = [{links}]\n");
    let (_folder, path) = file(text.as_bytes());
    assert!(refused(&["solve", &path], 2).contains("10000 rows: at most 200 are accepted here"));
}

#[test]
fn what_a_file_asks_to_be_shown_is_read_or_refused() {
    for (line, why) in [
        ("show = \"x\"", "`show` is a table"),
        ("show = []", "`show` is a table"),
        ("show = 3", "`show` is a table"),
        ("show.amplitude = \"mm; 0 digits\"", "`0 digits`: write from 1 to 17 digits"),
        ("show.amplitude = \"99 digits\"", "`99 digits`: write from 1 to 17 digits"),
        ("show.amplitude = \"mmm\"", "unknown unit `mmm`"),
        ("format = \"zzz\"", "this is not a format"),
        ("format = -1", "this is not a format"),
        ("format = 1.5", "this is not a format"),
    ] {
        let text = format!("{line}\n{}", PROBLEM.split("\n[show]").next().unwrap());
        let (_folder, path) = file(text.as_bytes());
        let error = refused(&["solve", &path], 2);
        assert!(error.contains(why) && error.contains("problem.toml:1:"), "{line}: {error}");
    }
}

#[test]
fn no_character_of_a_title_drives_a_terminal_through_json() {
    let title = "\\u009b31m\\u202e\\u200b\\U000E0001";
    let (_folder, path) = file(PROBLEM.replace("Fan of the paint shop", title).as_bytes());
    let text = printed(&["solve", &path, "--format", "json"]);
    assert!(text.contains(r"\u009b31m\u202e\u200b\udb40\udc01"), "{text}");
    let solved: Json = serde_json::from_str(&text).unwrap();
    assert_eq!(solved["case"], "\u{9b}31m\u{202e}\u{200b}\u{e0001}");
}

#[test]
fn a_table_is_read_from_a_file() {
    let Some((entry, path)) = first_table() else { return };
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("no-such-data.csv");
    let error = refused(&["solve", entry, "--set", &format!("{path}=@{}", data.display())], 2);
    assert!(error.contains("no-such-data.csv"), "{error}");
    let folder = tempfile::tempdir().unwrap();
    let data: PathBuf = folder.path().join("data.csv");
    fs::File::create(&data).unwrap().write_all(b"one; two; three; four; five\nwords\n").unwrap();
    let error = refused(&["solve", entry, "--set", &format!("{path}=@{}", data.display())], 2);
    assert!(error.contains("line 2"), "{error}");
}

/// An analysis that asks for a table, and where.
fn first_table() -> Option<(&'static str, &'static str)> {
    let present = |shape: Shape| if let Shape::Optional(inner) = shape { *inner() } else { shape };
    registry().iter().find_map(|entry| {
        let field = entry.fields().iter().find(|field| matches!(present(field.shape), Shape::Table(_)))?;
        Some((entry.about.id, field.name))
    })
}

#[test]
fn round_numbers_beside_those_of_a_case_leave_no_check_failed() {
    let torsion =
        ["discs[2].inertia.given.inertia=1.3 kg*m^2", "shafts[1].stiffness.stiffness.stiffness=777 N*m/rad"];
    let top = |nutation| [nutation, "body.mass=0.4 kg"];
    for (id, case, changes) in [
        ("vibration/torsional-train", "11", &torsion[..]),
        ("rigid-body/top-nutation", "6", &top("nutation=0.01 deg")),
        ("rigid-body/top-nutation", "6", &top("nutation=0.001 deg")),
        ("vibration/bar-on-two-springs", "2", &["rear=500.0000000000001 N/m"]),
        ("vibration/rotor-dynamics", "25", &["elements=6"]),
        ("vibration/rotor-dynamics", "25", &["elements=6", "speed=6000 rpm"]),
        ("vibration/rotor-dynamics", "25", &["elements=40", "theory=euler-bernoulli"]),
    ] {
        let mut arguments = vec!["solve", id, "--case", case];
        arguments.extend(changes.iter().flat_map(|change| ["--set", change]));
        let solved = run(&arguments, &[]);
        assert!(solved.status.success(), "{arguments:?}: {}", stderr(&solved));
    }
}

#[test]
fn changes_without_a_case_begin_with_nothing() {
    let error = refused(&["solve", "rigid-body/heavy-top", "--set", "body.mass=1 kg"], 2);
    for said in ["body.distance: a value is needed", "motion: write one of spin", "--case 1 starts from"] {
        assert!(error.contains(said), "{said}: {error}");
    }
}

#[test]
fn a_wanted_answer_is_found_on_the_command_line() {
    let asked = ["find", FAN, "--input", "mass", "--answer", "natural_frequency=12 Hz"];
    let mass = 3.0 * 200e9 * 1.3e-6 / 1.2f64.powi(3) / (24.0 * std::f64::consts::PI).powi(2);
    let found = json(&[&asked[..], &["--json"]].concat());
    let values = found["unknowns"]["mass"]["value"].as_array().expect("a value for each solution");
    assert_eq!(values.len(), 1);
    assert!((values[0].as_f64().unwrap() / mass - 1.0).abs() < 1e-9, "{values:?} and {mass}");
    assert_eq!(found["unknowns"]["mass"]["all"], true);
    let text = printed(&asked);
    for said in
        ["Mass of the machine for", "= 12 Hz", "mass = 79.4", "these are all solutions in the range: m = "]
    {
        assert!(text.contains(said), "{said}: {text}");
    }
    // An amplitude is reached below the resonance and above it.
    let asked = ["find", FAN, "--case", "1", "--input", "speed", "--answer", "amplitude=10 mm"];
    let text = printed(&[&asked[..], &["--from", "500 rpm", "--to", "3000 rpm", "--lang", "pt-BR"]].concat());
    assert_eq!(text.matches("speed = ").count(), 2, "{text}");
    assert!(text.contains("para") && text.contains("busca em 401 pontos"), "{text}");
    for (wrong, status, said) in [
        (
            ["--input", "mass", "--answer", "natural_frequency"],
            2,
            "--answer natural_frequency: write an answer",
        ),
        (["--input", "mas", "--answer", "natural_frequency=12 Hz"], 2, "--input mas: "),
        (["--input", "mass", "--answer", "frequency=12 Hz"], 2, "no answer `frequency`"),
        (["--input", "mass", "--answer", "natural_frequency=12 kg"], 2, "an angular velocity expected"),
        (["--input", "mass", "--answer", "stiffness=1 N/m"], 2, "does not depend on what is unknown"),
        (["--input", "unbalance", "--answer", "amplitude=900 km"], 1, "the answer lies between"),
    ] {
        let error = refused(&[&["find", FAN][..], &wrong].concat(), status);
        assert!(error.contains(said), "{wrong:?}: {error}");
    }
    refused(&[&asked[..], &["--from", "500 rpm"]].concat(), 2);
}

#[test]
fn an_unknown_is_found_on_the_command_line() {
    let asked = ["solve", FAN, "--case", "1", "--set", "mass=?", "--given", "natural_frequency=12 Hz"];
    let solved = json(&[&asked[..], &["--format", "json"]].concat());
    // m = k/(2π fₙ)² with k = 3 E I/L³.
    let mass = 3.0 * 200e9 * 1.3e-6 / 1.2f64.powi(3) / (24.0 * std::f64::consts::PI).powi(2);
    let found = solved["unknowns"]["mass"]["value"].as_array().expect("a value for each solution");
    assert_eq!(found.len(), 1);
    assert!((found[0].as_f64().unwrap() / mass - 1.0).abs() < 1e-9, "{found:?} and {mass}");
    assert_eq!(solved["unknowns"]["mass"]["unit"], "kg");
    assert_eq!(solved["inputs"]["mass"]["text"], "?");
    assert_eq!(solved["inputs"]["mass"]["value"], found[0]);
    assert_eq!(solved["answers"]["mass"]["asked"], true);
    let said = refused(&["solve", FAN, "--case", "1", "--set", "mass=?", "--given", "natural_frequency"], 2);
    assert!(said.contains("write an answer and its value"), "{said}");
}

#[test]
fn configurations_and_linked_problems_are_solved_on_the_command_line() {
    let given = ["natural_frequency=8.2 Hz", "weighted.natural_frequency=7.9 Hz"];
    let mut arguments = vec!["solve", FAN, "--case", "1", "--set", "mass=?"];
    arguments.extend([
        "--set",
        "support=stiffness",
        "--set",
        "support.stiffness.stiffness=? 10 kN/m .. 10 MN/m",
    ]);
    arguments.extend(["--set", "damping=ratio", "--set", "damping.ratio.ratio=0.05"]);
    arguments.extend(["--configuration", "weighted.mass=m + 2 kg"]);
    arguments.extend(given.iter().flat_map(|given| ["--given", given]));
    let solved = json(&[&arguments[..], &["--format", "json"]].concat());
    let value =
        |name: &str| solved["answers"][name]["si"].as_f64().unwrap_or_else(|| panic!("{name}: {solved:#}"));
    let mass = 2.0 / ((8.2f64 / 7.9).powi(2) - 1.0);
    assert!((value("mass") / mass - 1.0).abs() < 1e-9, "{}", value("mass"));
    assert!((value("weighted.natural_frequency") / (std::f64::consts::TAU * 7.9) - 1.0).abs() < 1e-9);

    let file = xtask::root().join("examples/fan_on_bracket.toml");
    let file = file.to_str().unwrap();
    // Doubled mass: frequencies by √(1/2).
    let frequency = |changes: &[&str]| {
        let solved = json(&[&["solve", file, "--format", "json"], changes].concat());
        solved["answers"]["bracket.natural_frequency"]["si"].as_f64().unwrap()
    };
    let ratio = frequency(&["--set", "fan.mass=80 kg"]) / frequency(&[]);
    assert!((ratio * 2f64.sqrt() - 1.0).abs() < 1e-12, "{ratio}");
    let asked =
        json(&["solve", file, "--format", "json", "--ask", "fan.peak to peak=2*X", "--let", "fan.bolt=24 g"]);
    let [peak, amplitude] =
        ["fan.peak_to_peak", "fan.amplitude"].map(|name| asked["answers"][name]["si"].as_f64());
    assert_eq!(peak, amplitude.map(|amplitude| 2.0 * amplitude));
    // One sheet in every format and language, with the heading of each problem.
    for (format, heading) in [
        ("text", "fan.weighted\n~"),
        ("markdown", "### fan.weighted"),
        ("html", "<h3>fan.weighted</h3>"),
        ("latex", "\\subsubsection*{fan.weighted}"),
        ("typst", "=== fan.weighted"),
    ] {
        for language in ["en", "pt-BR"] {
            let text = printed(&["solve", file, "--format", format, "--lang", language]);
            assert!(text.contains(heading), "{format}: {text}");
        }
    }
    let schema = json(&["schema", "linked-problems"]);
    assert!(schema["properties"]["problem"].is_object(), "{schema:#}");
}
