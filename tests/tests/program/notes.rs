//! Calculation notes: title block, problem file within, and `dalembert confirm`.

use std::{
    fs,
    io::{Cursor, Read as _, Write as _},
    path::Path,
    process::Output,
};

const TITLE_BLOCK: &str = "\
[title_block]
project = \"Paint shop -- roof\" # A & B
author = \"A. Silva\"
date = 2026-11-29
revision = 3

";

fn run(folder: &Path, arguments: &[&str]) -> Output {
    crate::program().current_dir(folder).args(arguments).output().expect("the program runs")
}

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&[&output.stdout[..], &output.stderr[..]].concat()).into_owned()
}

/// Writes a note, and gives its text.
fn written(folder: &Path, note: &str, arguments: &[&str]) -> String {
    let output = run(folder, &[&["solve"], arguments, &["--output", note]].concat());
    assert!(output.status.success(), "{arguments:?}: {}", said(&output));
    fs::read_to_string(folder.join(note)).expect("a note")
}

/// A problem file of the fan, with this title block.
fn with_title_block(folder: &Path, block: &str) {
    let template = run(folder, &["new", "vibration/rotating-unbalance", "--case", "1"]);
    let template = String::from_utf8(template.stdout).expect("a problem file");
    fs::write(folder.join("fan.toml"), template.replace("[inputs]", &format!("{block}[inputs]")))
        .expect("a file");
}

#[test]
fn a_note_of_every_format_is_confirmed_and_a_changed_answer_is_found() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    let problems: [(&str, &[&str], [&str; 2]); 4] = [
        ("vibration/rotating-unbalance", &["--unit", "amplitude=um"], ["19456", "19465"]),
        ("vibration/rotating-unbalance", &["--digits", "8", "--answer", "amplitude"], ["19.456", "19.465"]),
        ("balancing/two-plane", &["--lang", "pt-BR"], ["7,1996", "7,1969"]),
        ("exam/toggle-press-with-flywheel", &["--units", "in-lbf-s"], ["lbf", "N"]),
    ];
    for (n, (problem, options, [right, wrong])) in problems.into_iter().enumerate() {
        for ending in ["html", "tex", "typ", "md"] {
            let note = format!("note{n}-{ending}.{ending}");
            let text = written(folder, &note, &[&[problem], options].concat());
            let output = run(folder, &["confirm", &note]);
            assert!(output.status.success(), "{problem}, {ending}: {}", said(&output));
            assert!(said(&output).starts_with("confirmed: "), "{}", said(&output));
            // The problem file within stays as it is: what is printed above it is changed.
            let (printed, source) = text.split_at(text.find("problem file of dalembert").expect("a source"));
            assert!(printed.contains(right), "{right} in {problem}, {ending}");
            fs::write(folder.join(&note), printed.replace(right, wrong) + source).expect("a note");
            let output = run(folder, &["confirm", &note]);
            assert_eq!(output.status.code(), Some(1), "{problem}, {ending}: {}", said(&output));
            assert!(said(&output).contains("not confirmed: "), "{}", said(&output));
            assert!(said(&output).contains(wrong), "{}", said(&output));
        }
    }
}

#[test]
fn a_document_of_word_is_confirmed_and_a_changed_answer_is_found() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    with_title_block(folder, TITLE_BLOCK);
    let problems: [(&str, &[&str]); 3] = [
        ("fan.toml", &["--digits", "8"]),
        ("balancing/two-plane", &["--lang", "pt-BR", "--parts", "answers"]),
        ("exam/toggle-press-with-flywheel", &["--units", "in-lbf-s"]),
    ];
    for (n, (problem, options)) in problems.into_iter().enumerate() {
        let note = format!("note{n}.docx");
        let output = run(folder, &[&["solve", problem], options, &["--output", &note]].concat());
        assert!(output.status.success(), "{problem}: {}", said(&output));
        let output = run(folder, &["confirm", &note]);
        assert!(output.status.success() && said(&output).starts_with("confirmed: "), "{}", said(&output));
    }
    // Word writes the text of a document on one line, and its parts in another order.
    let bytes = fs::read(folder.join("note0.docx")).expect("a note");
    for (change, status) in [("", 0), ("19.45645", 1)] {
        let note = repacked(&bytes, &|name, text| match name {
            "word/document.xml" if change.is_empty() => text.replace('\n', ""),
            "word/document.xml" => {
                assert!(text.contains(change), "{change} stands in the note");
                text.replace(change, "19.46545")
            }
            _ => text,
        });
        fs::write(folder.join("saved.docx"), note).expect("a note");
        let output = run(folder, &["confirm", "saved.docx"]);
        assert_eq!(output.status.code(), Some(status), "{}", said(&output));
    }
    let output = run(folder, &["solve", "fan.toml", "--format", "docx"]);
    assert!(said(&output).contains("a document of Word is no text to print"), "{}", said(&output));
    fs::write(folder.join("fake.docx"), "PK no archive").expect("a file");
    let output = run(folder, &["confirm", "fake.docx"]);
    assert_eq!(output.status.code(), Some(2), "{}", said(&output));
    assert!(said(&output).contains("the file is no document of Word"), "{}", said(&output));
}

/// An archive with its texts changed, last one first.
fn repacked(bytes: &[u8], change: &impl Fn(&str, String) -> String) -> Vec<u8> {
    let mut archive = zip::ZipArchive::new(Cursor::new(bytes)).expect("an archive");
    let mut changed = zip::ZipWriter::new(Cursor::new(Vec::new()));
    for n in (0..archive.len()).rev() {
        let mut file = archive.by_index(n).expect("a file");
        let (name, mut content) = (file.name().expect("a name").into_owned(), Vec::new());
        file.read_to_end(&mut content).expect("its content");
        let content = match String::from_utf8(content) {
            Ok(text) => change(&name, text).into_bytes(),
            Err(other) => other.into_bytes(),
        };
        changed.start_file(name, zip::write::SimpleFileOptions::default()).expect("a file");
        changed.write_all(&content).expect("its content");
    }
    changed.finish().expect("an archive").into_inner()
}

#[test]
fn a_note_has_the_parts_that_are_chosen() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    let headings = |text: &str| -> Vec<String> {
        text.lines().filter_map(|line| line.strip_prefix("## ")).map(str::to_owned).collect()
    };
    for (language, parts, wanted) in [
        ("en", "statement", &["Given data"][..]),
        ("en", "answers", &["Given data", "Answers", "Checks"]),
        ("pt-BR", "statement", &["Dados"]),
        ("pt-BR", "answers", &["Dados", "Respostas", "Verificações"]),
    ] {
        let note = format!("{language}-{parts}.md");
        let options = ["vibration/rotating-unbalance", "--lang", language, "--parts", parts];
        let text = written(folder, &note, &options);
        assert_eq!(headings(&text), wanted, "{text}");
        let answer = if language == "en" { "19.456" } else { "19,456" };
        assert_eq!(text.contains(answer), parts == "answers", "{text}");
        assert!(text.contains("]("), "the drawing stands beside the data: {text}");
        let output = run(folder, &["confirm", &note]);
        assert!(output.status.success(), "{language}, {parts}: {}", said(&output));
    }
    let full = written(folder, "full.md", &["vibration/rotating-unbalance", "--parts", "full"]);
    let default = written(folder, "default.md", &["vibration/rotating-unbalance"]);
    assert_eq!(full.replace("full-", "default-"), default);
    // What is to be found is not on the sheet.
    let unknown = ["vibration/rotating-unbalance", "--case", "1", "--parts", "statement"];
    let unknown =
        [&unknown[..], &["--set", "mass=? 20 kg .. 60 kg", "--given", "amplitude=19.3 mm"]].concat();
    let sheet = written(folder, "unknown.md", &unknown);
    let printed = sheet.split("<!--").next().unwrap_or_default();
    assert!(printed.contains("machine m: ? 20 kg .. 60 kg\n") && printed.contains("19.3 mm"), "{sheet}");
    let output = run(folder, &[&["solve"], &unknown[..], &["--parts", "full"]].concat());
    assert!(said(&output).contains("used multiple times"), "{}", said(&output));
    let output =
        run(folder, &["solve", "vibration/rotating-unbalance", "--parts", "answers", "--format", "json"]);
    assert_eq!(output.status.code(), Some(2), "{}", said(&output));
    assert!(said(&output).contains("leave out --parts"), "{}", said(&output));
}

#[test]
fn a_table_from_a_file_is_named_with_its_units_and_first_rows() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    let row = |n: u32| {
        let time = f64::from(n) * 0.01;
        let x = (-0.5 * time).exp() * (12.5 * time).cos();
        format!("{};{}\n", 1e3 * time, 1e3 * x)
    };
    let rows: String = (0..300).map(row).collect::<Vec<_>>().concat();
    fs::create_dir(folder.join("data")).expect("a folder");
    fs::write(folder.join("data/run.csv"), format!("t [ms];x [um]\n{rows}")).expect("a table");
    let set = "record.samples.samples=@data/run.csv";
    let problem = ["vibration/decay-identification", "--case", "1", "--set", set];
    for ending in ["md", "html"] {
        let text = written(folder, &format!("run.{ending}"), &problem);
        let units = if ending == "md" { ["\\[ms\\]", "\\[µm\\]"] } else { ["[ms]", "[µm]"] };
        for words in ["300 rows from run.csv", "the first 5 of 300 rows"].into_iter().chain(units) {
            assert!(text.contains(words), "{words}: {text}");
        }
        assert!(!text.contains("data/run.csv"), "the folder is that of one machine");
        let output = run(folder, &["confirm", &format!("run.{ending}")]);
        assert!(output.status.success(), "{}", said(&output));
    }
}

#[test]
fn a_title_block_is_printed_and_kept() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    with_title_block(folder, TITLE_BLOCK);
    for (ending, line) in [
        ("html", "<th>Prepared by</th><td></td><td>A. Silva</td>"),
        ("tex", "{}Prepared by & A. Silva"),
        ("typ", "[Prepared by], [A. Silva]"),
        ("md", "- Revision: 3"),
    ] {
        let note = format!("fan-{ending}.{ending}");
        let text = written(folder, &note, &["fan.toml"]);
        assert!(text.contains(line), "{ending}: {text}");
        // Comments of the problem file stand in the note too.
        assert!(text.contains("[title_block]") && text.contains("revision = 3"), "{ending}: {text}");
        assert!(run(folder, &["confirm", &note]).status.success());
    }
    let changed = written(folder, "other.md", &["fan.toml", "--title-block", "checker=B. Souza"]);
    assert!(
        changed.contains("- Checked by: B. Souza") && changed.contains("- Date: 2026-11-29"),
        "{changed}"
    );
    assert!(run(folder, &["confirm", "other.md"]).status.success());
}

#[test]
fn what_is_wrong_with_a_title_block_or_a_note_is_named() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    with_title_block(folder, &TITLE_BLOCK.replace("author", "autor"));
    fs::write(folder.join("plain.md"), "# Fan\n").expect("a file");
    for (arguments, words) in [
        (&["solve", "fan.toml"][..], "a title block has no `autor`; did you mean `author`?"),
        (&["solve", "vibration/rotating-unbalance", "--title-block", "author"], "write a line and its text"),
        (&["confirm", "plain.md"], "the note holds no problem file"),
        (&["confirm", "fan.toml"], "a note is HTML, LaTeX, Typst, Markdown or Word"),
    ] {
        let output = run(folder, arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {}", said(&output));
        assert!(said(&output).contains(words), "{arguments:?}: {}", said(&output));
    }
}
