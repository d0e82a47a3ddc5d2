//! Calculation notes: title block, problem file within, and `dalembert confirm`.

use std::{fs, path::Path, process::Output};

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
        (&["confirm", "fan.toml"], "a note is HTML, LaTeX, Typst or Markdown"),
    ] {
        let output = run(folder, arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {}", said(&output));
        assert!(said(&output).contains(words), "{arguments:?}: {}", said(&output));
    }
}
