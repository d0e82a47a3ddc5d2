//! Tables of numbers from the files of other programs: a spreadsheet written by openpyxl, one by odfpy, text in several
//! encodings. Each is right or refused.

use std::{f64::consts::PI, fs, path::Path, process::Output};

use serde_json::Value as Json;

/// Folder of the spreadsheets. In each stands the receptance of 2 kg on 80 kN/m and 40 N·s/m; in `arm.xlsx` it is in the
/// second sheet, under a title, and beside a column of words.
const TABLES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/data/tables/");
const ANALYSIS: &str = "vibration/frequency-response-identification";

fn solve(file: &str, format: &[&str]) -> Output {
    let set = format!("measurement.table.points=@{file}");
    crate::program().args(["solve", ANALYSIS, "--set", &set]).args(format).output().expect("the program runs")
}

#[track_caller]
fn assert_is_the_arm(file: &str) {
    let output = solve(file, &["--format", "json"]);
    let why = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{file}: {why}");
    let solved: Json = serde_json::from_slice(&output.stdout).expect("JSON");
    let answer = |name: &str| solved["answers"][name]["si"].as_f64().unwrap_or_else(|| panic!("no {name}"));
    for (name, expected) in
        [("natural_frequency", (80e3_f64 / 2.0).sqrt()), ("stiffness", 80e3), ("mass", 2.0)]
    {
        let found = answer(name);
        assert!((found / expected - 1.0).abs() < 1e-4, "{file}: {name} {found} in place of {expected}");
    }
}

#[track_caller]
fn assert_refused(file: &str, words: &[&str]) {
    let output = solve(file, &[]);
    let error = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{file}: {error}");
    for word in words {
        assert!(error.contains(word), "{file}: no `{word}` in {error}");
    }
}

#[test]
fn spreadsheets_are_read_by_sheet_and_column() {
    for part in ["arm.xlsx#Run 1!A,C", "arm.xlsx#'Run 1'!A3:A16,C3:C16", "arm.ods", "arm.ods#Run 1!A:B"] {
        assert_is_the_arm(&format!("{TABLES}{part}"));
    }
}

#[test]
fn what_a_spreadsheet_cannot_give_is_refused_by_its_cell() {
    for (part, words) in [
        ("arm.xlsx#Run 1", &["3 columns"][..]),
        ("arm.xlsx#Nope", &["`Nope`", "`Run 1`"]),
        ("arm.xlsx#Faults!A:B", &["B3", "`Faults`", "error"]),
        ("arm.xlsx#Faults!A,D", &["D2", "date"]),
        ("arm.xlsx#Far", &["A1 to XFD1", "choose columns"]),
        ("arm.xlsx#Run 1!C:A", &["`C:A`", "A:C"]),
        ("arm.xlsx#Notes!F:G", &["nothing", "`Notes`"]),
    ] {
        assert_refused(&format!("{TABLES}{part}"), words);
    }
}

/// The rows of the arm, with a decimal comma, words that are not ASCII, and a column between.
fn text() -> String {
    let rows = [20.0, 24.0, 28.0, 30.0, 31.0, 32.0, 33.0, 36.0, 44.0].map(|hertz: f64| {
        let w = 2.0 * PI * hertz;
        let receptance = 1e3 / (80e3 - 2.0 * w * w).hypot(40.0 * w);
        format!("{hertz};{};{receptance:.9}\r\n", hertz / 10.0).replace('.', ",")
    });
    "Braço, medição de maio\r\nFrequência [Hz];t [s];Receptância [mm/N]\r\n".to_owned() + &rows.concat()
}

#[test]
fn text_of_any_encoding_is_read() {
    let folder = tempfile::tempdir().expect("a folder");
    let text = text();
    let marked = format!("\u{FEFF}{text}");
    let latin = text.chars().map(|c| u8::try_from(u32::from(c)).expect("Latin-1")).collect();
    let utf16 = |bytes_of: fn(u16) -> [u8; 2]| marked.encode_utf16().flat_map(bytes_of).collect();
    for (name, bytes) in [
        ("utf8.csv", text.clone().into_bytes()),
        ("marked.csv", marked.clone().into_bytes()),
        ("excel-unicode.txt", utf16(u16::to_le_bytes)),
        ("big-endian.txt", utf16(u16::to_be_bytes)),
        ("windows-1252.csv", latin),
    ] {
        let path = folder.path().join(name);
        fs::write(&path, bytes).expect("written");
        assert_is_the_arm(&format!("{}#1,3", path.display()));
    }
}

#[test]
fn an_error_prints_nothing_else_of_the_file() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = |name: &str, bytes: &[u8]| {
        let path = folder.path().join(name);
        fs::write(&path, bytes).expect("written");
        path.display().to_string()
    };
    let secret = at("secret.csv", b"Hz; m/N\n20; 1e-5\nsecret 1; hidden\n30; 2e-5 kept\n");
    let output = solve(&secret, &[]);
    let error = String::from_utf8_lossy(&output.stderr);
    assert!(!output.status.success() && !error.contains("1e-5"), "{error}");
    assert_refused(&at("picture.csv", b"\x89PNG\r\n\x1A\n\0\0\0\rIHDR"), &["not a text file"]);
    assert_refused(&at("broken.xlsx", b"PK\x03\x04 no more"), &["cannot be read"]);
    let short = at("short.csv", b"t; a; x\n20; 1; 2\n30; 1\n");
    assert_refused(&format!("{short}#1,3"), &["line 3", "column 3"]);
    assert_refused(&format!("{short}#0"), &["`#0`"]);
    assert!(Path::new(&short).exists());
}
