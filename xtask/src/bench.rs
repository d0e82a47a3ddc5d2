//! `cargo xtask bench`: what the program costs, beside its goals.
//!
//! The measuring programs stand in `tests/benches` and `crates/units/benches`; each prints rows of
//! `name<TAB>figure<TAB>goal`, the goal perhaps empty. Figures depend on the machine, ratios hardly.

use std::path::Path;

use anyhow::{Result, bail, ensure};

use crate::cargo::{cargo, output, run as run_command, target};

/// A part that can be measured alone.
struct Part {
    name: &'static str,
    package: &'static str,
    /// The target that measures it.
    bench: &'static str,
    /// The commands of the program that reach what is measured, or come nearest to it.
    reached_by: &'static str,
}

const PARTS: [Part; 14] = [
    part("plain", "dalembert-tests", "plain", "dalembert study; Python: dalembert.sweep"),
    part("units", "dalembert-units", "read", "dalembert solve, and every key in the workbench"),
    part("solve", "dalembert-tests", "solve", "dalembert solve ANALYSIS"),
    part("keys", "dalembert-tests", "keys", "dalembert, a key in a field of any analysis"),
    part("causes", "dalembert-tests", "causes", "dalembert check, and a wrong answer in Check"),
    part("study", "dalembert-tests", "study", "dalembert study PLAN"),
    part(
        "large",
        "dalembert-tests",
        "large",
        "dalembert solve, dalembert optimise; a table is read by @FILE",
    ),
    part("tui", "dalembert-tests", "tui", "dalembert"),
    part(
        "balance",
        "dalembert-mechanics",
        "balance",
        "the kernel alone; dalembert study reaches the like through balancing/two-plane",
    ),
    part(
        "linkages",
        "dalembert-mechanics",
        "linkages",
        "the formulas alone; dalembert study reaches them through virtual-work/slider-crank and four-bar",
    ),
    part(
        "modal",
        "dalembert-mechanics",
        "modal",
        "dalembert solve vibration/modal-analysis, frequency-response-matrix, rayleigh-damping",
    ),
    part("rigid", "dalembert-mechanics", "rigid", "dalembert solve rigid-body/motion"),
    part("rotor", "dalembert-mechanics", "rotor", "dalembert solve vibration/rotor-dynamics"),
    part("mechanism", "dalembert-mechanics", "mechanism", "dalembert solve virtual-work/mechanism"),
];

const fn part(
    name: &'static str,
    package: &'static str,
    bench: &'static str,
    reached_by: &'static str,
) -> Part {
    Part { name, package, bench, reached_by }
}

/// Measures the named parts, or all of them, and prints a table of each with the commands that reach it.
pub fn run(root: &Path, parts: &[&str]) -> Result<()> {
    for part in parts {
        if !PARTS.iter().any(|known| known.name == *part) {
            let known: Vec<&str> = PARTS.iter().map(|known| known.name).collect();
            bail!("`{part}` cannot be measured; write one of {}", known.join(", "));
        }
    }
    let chosen = PARTS.iter().filter(|part| parts.is_empty() || parts.contains(&part.name));
    for Part { name, package, bench, reached_by } in chosen {
        let mut command = cargo(root);
        command.args(["bench", "--package", package, "--bench", bench]);
        if *name == "tui" {
            run_command(cargo(root).args(["build", "--release", "--package", "dalembert"]))?;
            command.env("DALEMBERT", target(root).join("release/dalembert"));
        }
        let printed = output(&mut command)?;
        let found: Vec<Row> = printed.lines().filter_map(Row::read).collect();
        ensure!(!found.is_empty(), "the bench {bench} of {package} printed no figures");
        print!("{name}: {reached_by}\n\n{}\n", table(&found));
    }
    Ok(())
}

#[derive(Debug, PartialEq)]
struct Row {
    name: String,
    figure: String,
    goal: String,
}

impl Row {
    fn read(line: &str) -> Option<Self> {
        let mut cells = line.split('\t').map(str::to_owned);
        Some(Row { name: cells.next()?, figure: cells.next()?, goal: cells.next()? })
    }
}

fn table(rows: &[Row]) -> String {
    let heading = Row { name: "what".to_owned(), figure: "measured".to_owned(), goal: "goal".to_owned() };
    let width = |cell: fn(&Row) -> &str| {
        rows.iter().chain([&heading]).map(|row| cell(row).chars().count()).max().unwrap_or_default()
    };
    let (name, figure) = (width(|row| &row.name), width(|row| &row.figure));
    let mut text = String::new();
    for row in [&heading].into_iter().chain(rows) {
        let line = format!("{:<name$}  {:>figure$}  {}", row.name, row.figure, row.goal);
        text += line.trim_end();
        text.push('\n');
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_become_a_table() {
        let printed = "    Running benches\nsweep\t2.85 ns\t\nagainst by hand\t1.1 ×\t≤ 2.5 ×\n";
        let rows: Vec<Row> = printed.lines().filter_map(Row::read).collect();
        assert_eq!(
            table(&rows),
            "what             measured  goal\nsweep             2.85 ns\nagainst by hand     1.1 ×  ≤ 2.5 ×\n"
        );
    }
}
