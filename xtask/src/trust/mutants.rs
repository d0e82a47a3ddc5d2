//! Mutants of [cargo-mutants](https://mutants.rs): a draw of those of a crate, each judged by the tests of that crate.
//! A mutant that does not compile is replaced by the next one of the draw.

use std::{fmt::Write as _, fs, path::Path};

use anyhow::{Context, Result, ensure};
use serde::Deserialize;

use super::{Outcome, shuffled};
use crate::cargo::{cargo, copy_tracked, installed, output, target};

/// The quantile of the normal distribution that 2.5 % lie above.
const QUANTILE: f64 = 1.959_963_984_540_054;

/// Tests of a crate that judge its mutants.
struct Judge {
    /// Folder of the crate, which names it.
    folder: &'static str,
    /// Folders of the crates whose tests they are.
    tests: &'static [&'static str],
    /// Arguments of every `cargo test`.
    cargo: &'static [&'static str],
}

/// Name of a mutant, and what became of it.
#[derive(Debug, PartialEq)]
struct Verdict {
    name: String,
    summary: Summary,
}

/// The words of cargo-mutants.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq)]
enum Summary {
    Success,
    CaughtMutant,
    MissedMutant,
    Unviable,
    Failure,
    Timeout,
}

fn judge(row: &str) -> Result<Judge> {
    match row {
        "mutants-units" => {
            Ok(Judge { folder: "crates/units", tests: &["crates/units"], cargo: &["--tests"] })
        }
        "mutants-mechanics" => {
            Ok(Judge { folder: "crates/mechanics", tests: &["crates/mechanics"], cargo: &["--tests"] })
        }
        // Compiled as most crates are, in a quarter of the time.
        "mutants-core" => Ok(Judge {
            folder: "crates/core",
            tests: &["crates/core", "plugins/balancing"],
            cargo: &[
                "--tests",
                "--test=registry",
                "--config",
                "profile.dev.package.dalembert-core.opt-level=0",
            ],
        }),
        "mutants-balancing" => Ok(Judge {
            folder: "plugins/balancing",
            tests: &["plugins/balancing"],
            cargo: &["--test=registry"],
        }),
        _ => anyhow::bail!("{row} has no judge"),
    }
}

/// Draws mutants until so many that compile are judged, or none is left.
pub(super) fn trial(root: &Path, row: &str, times: u64, seed: u64) -> Result<Outcome> {
    ensure!(
        installed(cargo(root).args(["mutants", "--version"])),
        "cargo-mutants is missing: cargo install cargo-mutants --locked"
    );
    let judge = judge(row)?;
    let folder = target(root).join("mutants");
    let tree = folder.join("tree");
    copy_tracked(root, &tree)?;
    let names = shuffled(listed(&tree, judge.folder)?, seed);
    let mut verdicts: Vec<Verdict> = Vec::new();
    loop {
        let missing = usize::try_from(times)?.saturating_sub(viable(&verdicts).count());
        let rest = &names[verdicts.len()..];
        let drawn = &rest[..missing.min(rest.len())];
        if drawn.is_empty() {
            break;
        }
        verdicts.extend(judged(&tree, &folder, &judge, &names, drawn, seed)?);
    }
    ensure!(viable(&verdicts).count() > 0, "none of {} mutants compiles", names.len());
    Ok(outcome(&verdicts, names.len()))
}

fn viable(verdicts: &[Verdict]) -> impl Iterator<Item = &Verdict> {
    verdicts.iter().filter(|verdict| verdict.summary != Summary::Unviable)
}

fn package(folder: &str) -> String {
    format!("dalembert-{}", folder.rsplit('/').next().unwrap_or(folder))
}

/// Names of all mutants of a crate.
fn listed(tree: &Path, folder: &str) -> Result<Vec<String>> {
    #[derive(Deserialize)]
    struct Listed {
        name: String,
    }
    let printed = output(cargo(tree).args([
        "mutants",
        "--no-config",
        "--list",
        "--json",
        "--package",
        &package(folder),
    ]))?;
    let listed: Vec<Listed> =
        serde_json::from_str(&printed).context("the list of cargo-mutants cannot be read")?;
    ensure!(!listed.is_empty(), "cargo-mutants lists no mutant of {folder}");
    Ok(listed.into_iter().map(|mutant| mutant.name).collect())
}

/// Judges the mutants of these names, of all that there are, in the copy of the tree, after the tests passed without any.
fn judged(
    tree: &Path,
    folder: &Path,
    judge: &Judge,
    all: &[String],
    names: &[String],
    seed: u64,
) -> Result<Vec<Verdict>> {
    // As if the others were caught before: filters by name let deleted fields pass (27.1).
    let report = folder.join("mutants.out");
    if report.exists() {
        fs::remove_dir_all(&report)?;
    }
    fs::create_dir_all(&report)?;
    let others: Vec<&str> = all.iter().filter(|name| !names.contains(name)).map(String::as_str).collect();
    fs::write(report.join("previously_caught.txt"), others.join("\n"))?;
    let tests: Vec<String> = judge.tests.iter().map(|folder| package(folder)).collect();
    let mut command = cargo(tree);
    command
        .args(["mutants", "--in-place", "--iterate", "--no-config"])
        .args(["--jobserver", "false", "--no-times", "--colors", "never"])
        .args(["--package", &package(judge.folder), "--test-package", &tests.join(",")])
        .arg("--output")
        .arg(folder)
        .args(judge.cargo.iter().map(|word| format!("--cargo-arg={word}")));
    command
        .env("CARGO_TARGET_DIR", folder.join("build"))
        // Property tests draw the same for each mutant, and learn nothing from the one before.
        .env("PROPTEST_RNG_SEED", seed.to_string())
        .env("PROPTEST_DISABLE_FAILURE_PERSISTENCE", "true")
        // Only what a mutant changes is compiled again, with the optimisation of every day: without it, the tests of the
        // kernels take longer than the compiler.
        .env("CARGO_INCREMENTAL", "1")
        // Optimised across the units of a crate, parts compiled before and after a change do not always link.
        .env("CARGO_PROFILE_DEV_LTO", "off")
        .env("CARGO_PROFILE_DEV_DEBUG", "false");
    // Its status is that of the mutants; what matters is what it writes.
    let _ = command.status().context("cargo-mutants cannot be run")?;
    let report = report.join("outcomes.json");
    let text = fs::read_to_string(&report)
        .with_context(|| format!("cargo-mutants wrote no {}", report.display()))?;
    let verdicts = verdicts(&text)?;
    for name in names {
        ensure!(verdicts.iter().any(|verdict| verdict.name == *name), "{name} was not judged");
    }
    ensure!(verdicts.len() == names.len(), "{} of {} were to be judged", names.len(), verdicts.len());
    Ok(verdicts)
}

/// Verdicts of `outcomes.json`.
fn verdicts(text: &str) -> Result<Vec<Verdict>> {
    #[derive(Deserialize)]
    struct Report {
        outcomes: Vec<Judged>,
    }
    #[derive(Deserialize)]
    struct Judged {
        scenario: Scenario,
        summary: Summary,
    }
    #[derive(Deserialize)]
    enum Scenario {
        Baseline,
        Mutant { name: String },
    }
    let report: Report = serde_json::from_str(text).context("outcomes.json cannot be read")?;
    let mut verdicts = Vec::new();
    let mut passed = false;
    for Judged { scenario, summary } in report.outcomes {
        match scenario {
            Scenario::Baseline => passed = summary == Summary::Success,
            Scenario::Mutant { name } => {
                let known = !matches!(summary, Summary::Success | Summary::Failure);
                ensure!(known, "{name} ended with {summary:?}");
                verdicts.push(Verdict { name, summary });
            }
        }
    }
    ensure!(passed, "the tests do not pass without a mutant: see mutants.out/log/baseline.log");
    Ok(verdicts)
}

/// Survivors of all mutants that compile, `all` being those that were listed.
fn outcome(verdicts: &[Verdict], all: usize) -> Outcome {
    let count = |summary| verdicts.iter().filter(|verdict| verdict.summary == summary).count() as u64;
    let failures: Vec<String> = verdicts
        .iter()
        .filter(|verdict| verdict.summary == Summary::MissedMutant)
        .map(|verdict| verdict.name.clone())
        .collect();
    let (tried, failed) = (viable(verdicts).count() as u64, failures.len() as u64);
    let caught = tried - failed;
    let mut note = format!(
        "caught {caught} of {tried}, 95 % lower bound {:.1} %; drawn {} of {all}",
        100.0 * lower_bound(caught, tried),
        verdicts.len(),
    );
    for (number, words) in [
        (count(Summary::Unviable), "do not compile"),
        (count(Summary::Timeout), "were caught because the tests did not end"),
    ] {
        let _ = write!(note, ", {number} {words}");
    }
    Outcome { tried, failed, failures, note }
}

/// Lower end of Wilson's interval of 95 % for a share of which `hits` of `all` were met:
/// `(p + z²/2n − z √(p (1 − p)/n + z²/4n²)) / (1 + z²/n)`, zero for none of none. E. B. Wilson, *Probable inference, the law of
/// succession, and statistical inference*, J. Am. Stat. Assoc. 22 (1927) 209–212.
fn lower_bound(hits: u64, all: u64) -> f64 {
    if all == 0 {
        return 0.0;
    }
    let n = all as f64;
    let (p, square) = (hits as f64 / n, QUANTILE * QUANTILE);
    let spread = QUANTILE * (p * (1.0 - p) / n + square / (4.0 * n * n)).sqrt();
    ((p + square / (2.0 * n) - spread) / (1.0 + square / n)).max(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lower_bounds_published_by_newcombe() {
        // R. G. Newcombe, Statistics in Medicine 17 (1998) 857-872, table I, method 3.
        for (hits, all, expected) in [(81, 263, 0.2553), (15, 148, 0.0624), (0, 20, 0.0), (1, 29, 0.0061)] {
            let bound = lower_bound(hits, all);
            assert!((bound - expected).abs() < 5e-5, "{hits} of {all}: {bound}");
        }
        assert_eq!(lower_bound(0, 0), 0.0);
    }

    #[test]
    fn verdicts_of_a_report() {
        let mutant = |name: &str, summary: &str| {
            format!(
                r#"{{"scenario": {{"Mutant": {{"name": "{name}", "file": "a.rs"}}}}, "summary": "{summary}"}}"#
            )
        };
        let report = |baseline: &str, mutants: &[String]| {
            let baseline = format!(r#"{{"scenario": "Baseline", "summary": "{baseline}"}}"#);
            format!(r#"{{"outcomes": [{baseline}, {}], "caught": 1}}"#, mutants.join(", "))
        };
        let mutants = [
            mutant("a", "CaughtMutant"),
            mutant("b", "MissedMutant"),
            mutant("c", "Unviable"),
            mutant("d", "Timeout"),
        ];
        let read = verdicts(&report("Success", &mutants)).unwrap();
        let Outcome { tried, failed, failures, note } = outcome(&read, 9);
        assert_eq!((tried, failed, failures), (3, 1, vec!["b".to_owned()]));
        let expected = "caught 2 of 3, 95 % lower bound 20.8 %; drawn 4 of 9, 1 do not compile, \
             1 were caught because the tests did not end";
        assert_eq!(note, expected);
        assert!(verdicts(&report("Failure", &mutants)).unwrap_err().to_string().contains("baseline.log"));
        let odd = verdicts(&report("Success", &[mutant("e", "Failure")]));
        assert_eq!(odd.unwrap_err().to_string(), "e ended with Failure");
    }
}
