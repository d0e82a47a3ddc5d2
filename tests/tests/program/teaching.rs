//! `dalembert variants` and `dalembert grade`, run as a teacher runs them.

use std::{
    fs,
    path::{Path, PathBuf},
    time::{Duration, Instant},
};

use serde_json::Value as Json;

fn data(name: &str) -> String {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("data/teaching").join(name).to_str().expect("UTF-8").to_owned()
}

fn run(arguments: &[&str]) -> (Option<i32>, String, String) {
    let output = crate::program().args(arguments).output().expect("the program runs");
    let text = |bytes| String::from_utf8(bytes).expect("what is printed is UTF-8");
    (output.status.code(), text(output.stdout), text(output.stderr))
}

fn printed(arguments: &[&str]) -> String {
    let (status, text, errors) = run(arguments);
    assert_eq!(status, Some(0), "{arguments:?}: {errors}");
    text
}

fn refused(arguments: &[&str]) -> String {
    let (status, text, errors) = run(arguments);
    assert_eq!((status, text.as_str()), (Some(2), ""), "{arguments:?}: {errors}");
    assert!(!errors.contains("panicked"), "{errors}");
    errors
}

#[test]
fn a_sheet_has_the_data_of_its_variant() {
    let fan = data("fan.toml");
    let text = printed(&["variants", &fan, "--seed", "7", "--count", "2"]);
    insta::assert_snapshot!("variants", text);
    assert_eq!(text, printed(&["variants", &fan, "--seed", "7", "--count", "2"]), "a seed is a sheet");
    assert_ne!(text, printed(&["variants", &fan, "--seed", "8", "--count", "2"]));
    // A student's sheet says whose it is.
    let one = printed(&["variants", &fan, "--student", "2023001"]);
    assert!(one.contains("variant 2023001"), "{one}");
    assert_ne!(one, printed(&["variants", &fan, "--student", "2023002"]).replace("2023002", "2023001"));
    let portuguese = printed(&["--lang", "pt-BR", "variants", &fan, "--student", "2023001"]);
    assert!(portuguese.contains("Determinar") && portuguese.contains("variante 2023001"), "{portuguese}");
}

#[test]
fn the_key_solves_the_sheet() {
    let fan = data("fan.toml");
    let csv = printed(&["variants", &fan, "--seed", "3", "--count", "3", "--format", "csv"]);
    let rows: Vec<Vec<&str>> = csv.lines().skip(1).map(|line| line.split(',').collect()).collect();
    assert_eq!(rows.len(), 9, "{csv}");
    let folder = tempfile::tempdir().expect("there is a place for temporary files");
    let out = folder.path().to_str().expect("UTF-8");
    for (format, extension) in [("md", "md"), ("html", "html"), ("tex", "tex"), ("typ", "typ")] {
        printed(&[
            "variants", &fan, "--seed", "3", "--count", "3", "--format", format, "--out", out, "--force",
        ]);
        for name in ["sheet-1", "worked-3", "key"] {
            assert!(folder.path().join(format!("{name}.{extension}")).exists(), "{name}.{extension}");
        }
    }
    assert_eq!(fs::read_to_string(folder.path().join("answers.csv")).unwrap(), csv);
    // The worked key shows the answers of the key.
    let worked = fs::read_to_string(folder.path().join("worked-2.md")).unwrap();
    for row in rows.iter().filter(|row| row[0] == "2") {
        let digits = &row[3][..row[3].len().min(4)];
        assert!(worked.contains(digits), "{row:?} in\n{worked}");
    }
    assert!(refused(&["variants", &fan, "--out", out]).contains("--force"));
}

#[test]
fn a_class_is_graded() {
    let (fan, answers) = (data("fan.toml"), data("answers.csv"));
    let csv = printed(&["grade", &answers, "--problem", &fan, "--format", "csv"]);
    insta::assert_snapshot!("grade_csv", csv.replace("\r\n", "\n"));
    insta::assert_snapshot!("grade_text", printed(&["grade", &answers, "--problem", &fan]));
    let json: Json =
        serde_json::from_str(&printed(&["grade", &answers, "--problem", &fan, "--format", "json"])).unwrap();
    let class = json["class"].as_array().unwrap();
    assert_eq!(class.len(), 3);
    assert!(class.iter().all(|of| of["students"] == 5), "{json}");
    // No cell begins as a formula, the student's own among them.
    for line in csv.lines() {
        for cell in line.split(',') {
            let bare = cell.trim_start_matches('"');
            assert!(!bare.starts_with(['=', '+', '@']), "{cell} in {line}");
        }
    }
    let all =
        printed(&["grade", &answers, "--problem", &fan, "--format", "csv", "--weights", "sign-or-unit=0.25"]);
    assert!(all.lines().any(|line| line.contains("sign-or-unit,0.25")), "{all}");
}

#[test]
fn students_are_graded_by_their_own_variants() {
    let fan = data("fan.toml");
    let key = printed(&["variants", &fan, "--student", "ana", "--student", "bruno", "--format", "csv"]);
    let mut table = "student;answer;value\n".to_owned();
    for line in key.lines().skip(1) {
        let cells: Vec<&str> = line.split(',').collect();
        table += &format!("{};{};{} {}\n", cells[0], cells[1], cells[3], cells[4]);
    }
    let folder = tempfile::tempdir().expect("there is a place for temporary files");
    let path = folder.path().join("class.csv");
    fs::write(&path, &table).unwrap();
    let path = path.to_str().expect("UTF-8");
    let credit = |arguments: &[&str]| -> f64 {
        let json: Json = serde_json::from_str(&printed(arguments)).unwrap();
        json["students"].as_array().unwrap().iter().map(|of| of["points"].as_f64().unwrap()).sum()
    };
    let own = ["grade", path, "--problem", &fan, "--seed-column", "student", "--format", "json"];
    assert_eq!(credit(&own), 6.0, "{table}");
    // The variant of one is not that of the other.
    fs::write(path, table.replace("ana;", "x;").replace("bruno;", "ana;").replace("x;", "bruno;")).unwrap();
    assert!(credit(&own) < 3.0, "{}", credit(&own));
}

#[test]
fn hostile_cells_are_cells() {
    let fan = data("fan.toml");
    let folder = tempfile::tempdir().expect("there is a place for temporary files");
    let path = folder.path().join("hostile.csv");
    let deep = "(".repeat(5_000);
    let long = "9".repeat(1_000_000);
    let mut table = "student,answer,value\n".to_owned();
    for (n, value) in [
        "@/etc/passwd",
        "@fan.toml",
        "=HYPERLINK(1)",
        "1e999999 mm",
        "NaN mm",
        "inf",
        "sqrt(-1) mm",
        "1/0 mm",
        "2^2^2^2^2^2^2^2^2^2 mm",
        "± ± ±",
        "19 ± 1e300 mm",
        "± mm",
        "\u{202e}mm 91",
        "19.456 parsec",
        "{}",
        "%",
        &deep,
        &long,
    ]
    .into_iter()
    .enumerate()
    {
        table += &format!("s{n},amplitude,\"{value}\"\ns{n},\"{}\",1\n", "a".repeat(n * 50));
    }
    fs::write(&path, table).unwrap();
    let begun = Instant::now();
    let csv = printed(&["grade", path.to_str().expect("UTF-8"), "--problem", &fan, "--format", "csv"]);
    assert!(begun.elapsed() < Duration::from_mins(1));
    assert!(csv.lines().skip(1).all(|line| line.contains(",0,")), "{csv}");
    assert!(!csv.contains("root:"), "no file is read");
    assert!(csv.lines().all(|line| line.len() < 3_000), "no cell is repeated in full");
    for (text, why) in
        [("", "no column"), ("student,answer,value\n", "no row"), ("a,b\n1,2\n", "headings are a, b")]
    {
        fs::write(&path, text).unwrap();
        let errors = refused(&["grade", path.to_str().expect("UTF-8"), "--problem", &fan]);
        assert!(errors.contains(why), "{errors}");
    }
}

#[test]
fn what_cannot_be_varied_is_refused_in_words() {
    let fan = fs::read_to_string(data("fan.toml")).unwrap();
    let folder = tempfile::tempdir().expect("there is a place for temporary files");
    let path = folder.path().join("fan.toml");
    let path = path.to_str().expect("UTF-8");
    let of = |from: &str, to: &str| {
        fs::write(path, fan.replace(from, to)).unwrap();
        refused(&["variants", path, "--count", "3"])
    };
    assert!(of("mass = \"30 kg .. 60 kg : 1 kg\"", "masse = \"30 kg\"").contains("did you mean `mass`"));
    assert!(of("30 kg .. 60 kg : 1 kg", "30 kg .. 60 N : 1 kg").contains("vary.mass"));
    assert!(of("30 kg .. 60 kg : 1 kg", "30 kg .. 60 kg : 0 kg").contains("does not lead"));
    assert!(of("30 kg .. 60 kg : 1 kg", "-60 kg; -50 kg").contains("vary.mass"));
    // Three masses of 39 kg to 41 kg alone are too near to each other.
    let (before, rest) = fan.split_once("[vary]").expect("ranges are declared");
    let (_, after) = rest.split_once("[inputs]").expect("inputs follow");
    fs::write(path, format!("{before}[vary]\nmass = \"39 kg .. 41 kg : 1 kg\"\n[inputs]{after}")).unwrap();
    let few = refused(&["variants", path, "--count", "3"]);
    assert!(few.contains("0 of 3 variants") && few.contains("less than 2 %"), "{few}");
    assert!(refused(&["variants", &data("fan.toml"), "--tolerance", "50 %"]).contains("--tolerance"));
    assert!(refused(&["variants", &data("fan.toml"), "--format", "qti"]).contains("--out"));
    let weights = ["grade", &data("answers.csv"), "--problem", &data("fan.toml"), "--weights", "right=2"];
    assert!(refused(&weights).contains("right=2"));
}

#[test]
fn platforms_are_given_files() {
    let fan = data("fan.toml");
    let folder = tempfile::tempdir().expect("there is a place for temporary files");
    let write = |format: &str| -> Vec<PathBuf> {
        let out = folder.path().join(format);
        let to = out.to_str().expect("UTF-8");
        printed(&["variants", &fan, "--seed", "5", "--count", "2", "--format", format, "--out", to]);
        let mut found = Vec::new();
        let mut open = vec![out];
        while let Some(path) = open.pop() {
            if path.is_dir() {
                open.extend(fs::read_dir(&path).unwrap().map(|entry| entry.unwrap().path()));
            } else {
                found.push(path);
            }
        }
        found.sort();
        found
    };
    let moodle = fs::read_to_string(&write("moodle")[0]).unwrap();
    assert_eq!(moodle.matches("<question type=\"cloze\">").count(), 2);
    assert_eq!(moodle.matches("{1:NUMERICAL:=").count(), 6, "{moodle}");
    assert!(moodle.contains("~%0%") && moodle.contains("encoding=\"base64\""));
    let names = |files: &[PathBuf]| -> Vec<String> {
        files.iter().map(|path| path.file_name().unwrap().to_string_lossy().into_owned()).collect()
    };
    let qti = write("qti");
    assert_eq!(
        names(&qti),
        ["imsmanifest.xml", "item-v-1.svg", "item-v-1.xml", "item-v-2.svg", "item-v-2.xml"]
    );
    assert_eq!(names(&write("prairielearn")), ["info.json", "question.html", "server.py"]);
}
