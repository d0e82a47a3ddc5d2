//! The rows: what each of them tries, how often, and by which program.

use std::{
    env, fs,
    path::Path,
    process::{Command, Stdio},
};

use anyhow::{Context, Result, ensure};

use super::{Outcome, mutants, processors, searched};
use crate::{
    cargo::{Program, cargo, output, run, target},
    docs,
};

/// A trial, and its size.
pub(super) struct Row {
    pub(super) name: &'static str,
    /// Description, without a stop at its end.
    pub(super) tried: &'static str,
    /// Number of things at full size.
    pub(super) times: u64,
    /// Runs it so often with a seed.
    pub(super) run: fn(root: &Path, row: &Row, times: u64, seed: u64) -> Result<Outcome>,
}

const FEW: u64 = 1_000_000;
const MANY: u64 = 100_000_000;

pub(super) const ROWS: [Row; 28] = [
    Row {
        name: "catalogue",
        tried: "answers of all cases beside those published, and their checks",
        times: 1,
        run: catalogue,
    },
    Row {
        name: "formulas",
        tried: "answers and steps beside arithmetic of 77 digits: all cases, random problems near each, and one input after \
            the other nearly zero; a formula fails that keeps fewer digits than its condition allows",
        times: 3,
        run: trial,
    },
    Row {
        name: "mutants-formulas",
        tried: "formulas of worked solutions with one operation made wrongly (sign, cofunction, degrees, operands interchanged) or \
            with a result negated, doubled or times 2π, in all cases where they occur: an answer published or a check notices",
        times: 30_000,
        run: trial,
    },
    Row {
        name: "simd",
        tried: "points of sweeps by SIMD and one by one, tests over the registry with so many times as many points",
        times: 10,
        run: simd,
    },
    Row {
        name: "processors",
        tried: "answers of cases on processors without AVX and with AVX2 at most, as qemu emulates them, beside those of this \
            machine: alike to 1e-12",
        times: 2_000,
        run: on_processors,
    },
    Row {
        name: "hostile-files",
        tried: "problem files with 16 kinds of random changes: solved with finite numbers, or refused, within 5 s",
        times: 20_000,
        run: trial,
    },
    Row {
        name: "hostile-arguments",
        tried: "command lines of words that do and do not belong there: they end with 0, 1 or 2 and print no control character",
        times: 2_000,
        run: trial,
    },
    Row {
        name: "kills",
        tried: "kills with -9 while a note is saved over another: the old file or the new one, whole",
        times: 5_000,
        run: trial,
    },
    Row {
        name: "system-calls",
        tried: "saves in which the nth openat, write, fsync, rename, fchmod, fchown, flock, statx or getrandom fails with one of seven errors",
        times: 630,
        run: trial,
    },
    Row {
        name: "events",
        tried: "random keys, pastes and sizes in one process: no panic, memory flat",
        times: FEW,
        run: trial,
    },
    Row {
        name: "sizes",
        tried: "list, problem and help in every size from 1×1 to 160×60",
        times: 28_800,
        run: trial,
    },
    Row {
        name: "terminals",
        tried: "a problem on terminals of 21 kinds, 8 locales and 12 words about colours: only characters and colours that they have",
        times: 2_016,
        run: trial,
    },
    Row {
        name: "terminal-faults",
        tried: "tests of faults at a pseudo-terminal (signals, hang-up, suspension, kills, slow lines, pastes), all of them so many times",
        times: 10,
        run: terminal_faults,
    },
    Row {
        name: "dialects",
        tried: "files of tables as other programs write them: read right, or refused with the repair",
        times: 1,
        run: dialects,
    },
    Row {
        name: "quantity",
        tried: "executions of the reader of quantities in a field, by libFuzzer",
        times: MANY,
        run: search,
    },
    Row {
        name: "expression",
        tried: "executions of the reader of expressions, by libFuzzer",
        times: MANY,
        run: search,
    },
    Row {
        name: "vector",
        tried: "executions of the reader of vectors, by libFuzzer",
        times: MANY,
        run: search,
    },
    Row { name: "keys", tried: "executions of the decoder of keys, by libFuzzer", times: MANY, run: search },
    Row {
        name: "problem-file",
        tried: "executions of the reader and writer of problem files, by libFuzzer",
        times: FEW,
        run: search,
    },
    Row {
        name: "table",
        tried: "executions of the readers of tables (text, WAV, MAT, spreadsheets, universal files), by libFuzzer",
        times: FEW,
        run: search,
    },
    Row {
        name: "universal-file",
        tried: "executions of the reader of universal files, by libFuzzer",
        times: FEW,
        run: search,
    },
    Row {
        name: "replay",
        tried: "executions of the reader of recorded sessions, by libFuzzer",
        times: FEW,
        run: search,
    },
    Row {
        name: "settings",
        tried: "executions of the reader of settings, by libFuzzer",
        times: FEW,
        run: search,
    },
    Row {
        name: "report",
        tried: "executions of the writers of HTML, LaTeX, Typst, Markdown and JSON with a hostile title, by libFuzzer",
        times: FEW,
        run: search,
    },
    Row {
        name: "mutants-units",
        tried: "mutants of units, drawn at random from those of cargo-mutants that compile, judged by its own tests, examples in the documentation left out",
        times: 300,
        run: mutants_of_a_crate,
    },
    Row {
        name: "mutants-mechanics",
        tried: "mutants of mechanics, drawn at random from those of cargo-mutants that compile, judged by its own tests, examples in the documentation left out",
        times: 300,
        run: mutants_of_a_crate,
    },
    Row {
        name: "mutants-core",
        tried: "mutants of core, drawn at random from those of cargo-mutants that compile, judged by its own tests and those of the \
            catalogue over balancing, examples in the documentation left out",
        times: 300,
        run: mutants_of_a_crate,
    },
    Row {
        name: "mutants-balancing",
        tried: "mutants of the balancing analyses, drawn at random from those of cargo-mutants that compile, judged by the tests \
            of the catalogue over this family",
        times: 300,
        run: mutants_of_a_crate,
    },
];

/// A trial of the package of tests, built as the tests are, in a folder of its own: what random keys save is there.
fn trial(root: &Path, row: &Row, times: u64, seed: u64) -> Result<Outcome> {
    let program = Program::built(root, root)?;
    run(cargo(root).args(["build", "--quiet", "--workspace", "--bin", "trial"]))?;
    let folder = target(root).join("trust").join(row.name);
    fs::create_dir_all(&folder).with_context(|| format!("{} cannot be made", folder.display()))?;
    let mut command =
        Command::new(program.path().with_file_name(format!("trial{}", env::consts::EXE_SUFFIX)));
    for variable in ["HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_STATE_HOME", "XDG_CACHE_HOME"] {
        command.env(variable, &folder);
    }
    command.current_dir(&folder).arg(row.name).args([
        "--times",
        &times.to_string(),
        "--seed",
        &seed.to_string(),
    ]);
    // Its panics are caught by the trial, and printed by the standard library.
    command.env("DALEMBERT_BIN", program.path()).env("RUST_BACKTRACE", "0");
    let printed = output(&mut command)?;
    fs::remove_dir_all(&folder)?;
    serde_json::from_str(printed.trim())
        .with_context(|| format!("{} prints no outcome:\n{printed}", row.name))
}

fn search(root: &Path, row: &Row, times: u64, seed: u64) -> Result<Outcome> {
    searched(root, row.name, times, seed)
}

fn mutants_of_a_crate(root: &Path, row: &Row, times: u64, seed: u64) -> Result<Outcome> {
    mutants::trial(root, row.name, times, seed)
}

fn on_processors(root: &Path, _: &Row, times: u64, seed: u64) -> Result<Outcome> {
    processors::trial(&Program::built(root, root)?, times, seed)
}

fn catalogue(root: &Path, _: &Row, _: u64, _: u64) -> Result<Outcome> {
    let counts = docs::json(&Program::built(root, root)?, &["verify", "--json"])?;
    let count =
        |name: &str| counts[name].as_u64().with_context(|| format!("`verify --json` counts no {name}"));
    let (agreed, disputed, differing) = (count("agreed")?, count("disputed")?, count("differing")?);
    let note =
        format!("{agreed} agreed, {disputed} were printed wrongly, for the reasons recorded with them");
    Ok(Outcome { tried: agreed + disputed + differing, failed: differing, failures: Vec::new(), note })
}

/// Tests of a package, and how many passed and failed of them.
fn tested(command: &mut Command) -> Result<[u64; 2]> {
    let done = command.stdout(Stdio::piped()).output().context("cargo cannot be run")?;
    let printed = String::from_utf8_lossy(&done.stdout).into_owned();
    let mut counts = [0, 0];
    for line in printed.lines().filter(|line| line.starts_with("test result:")) {
        for (count, word) in counts.iter_mut().zip([" passed", " failed"]) {
            let number =
                line.split_once(word).and_then(|(before, _)| before.rsplit(' ').next()?.parse::<u64>().ok());
            *count += number.context("a result of tests has no counts")?;
        }
    }
    ensure!(counts[0] + counts[1] > 0, "no test was run:\n{printed}");
    Ok(counts)
}

fn simd(root: &Path, _: &Row, times: u64, seed: u64) -> Result<Outcome> {
    let [passed, failed] = tested(
        cargo(root)
            .args(["test", "--package", "dalembert-tests", "--test", "registry", "--", "simd"])
            .env("DALEMBERT_TIMES", times.to_string())
            .env("PROPTEST_RNG_SEED", seed.to_string()),
    )?;
    let note = format!("{passed} tests passed and {failed} failed with {times} times as many points");
    Ok(Outcome { tried: (passed + failed) * times, failed, failures: Vec::new(), note })
}

fn terminal_faults(root: &Path, _: &Row, times: u64, _: u64) -> Result<Outcome> {
    let (mut tried, mut failed, mut failures) = (0, 0, Vec::new());
    for run in 1..=times {
        let counts = tested(cargo(root).args([
            "test",
            "--package",
            "dalembert-tests",
            "--test",
            "program",
            "--",
            "faults::",
        ]))?;
        tried += counts.iter().sum::<u64>();
        failed += counts[1];
        if counts[1] > 0 {
            failures.push(format!("run {run}: {} tests", counts[1]));
        }
    }
    Ok(Outcome { tried, failed, failures, note: format!("{times} runs of all tests") })
}

fn dialects(root: &Path, _: &Row, _: u64, _: u64) -> Result<Outcome> {
    let [passed, failed] = tested(cargo(root).args([
        "test",
        "--package",
        "dalembert-tests",
        "--test",
        "program",
        "--",
        "dialects::",
    ]))?;
    let note = "each test reads the whole corpus; `cargo xtask dialects` prints it".to_owned();
    Ok(Outcome { tried: passed + failed, failed, failures: Vec::new(), note })
}
