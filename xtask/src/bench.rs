//! `cargo xtask bench`: what the program costs, beside its goals.
//!
//! The measuring programs stand in `tests/benches` and `crates/units/benches`; each prints rows of
//! `name<TAB>figure<TAB>goal`, the goal perhaps empty. Figures depend on the machine, ratios hardly.

use std::path::Path;

use anyhow::{Result, bail, ensure};

use crate::cargo::{cargo, output, run as run_command, target};

/// A part that can be measured alone: its name, and the package and target that measure it.
const PARTS: [(&str, &str, &str); 13] = [
    ("plain", "dalembert-tests", "plain"),
    ("units", "dalembert-units", "read"),
    ("solve", "dalembert-tests", "solve"),
    ("keys", "dalembert-tests", "keys"),
    ("study", "dalembert-tests", "study"),
    ("large", "dalembert-tests", "large"),
    ("tui", "dalembert-tests", "tui"),
    ("balance", "dalembert-mechanics", "balance"),
    ("linkages", "dalembert-mechanics", "linkages"),
    ("modal", "dalembert-mechanics", "modal"),
    ("rigid", "dalembert-mechanics", "rigid"),
    ("rotor", "dalembert-mechanics", "rotor"),
    ("mechanism", "dalembert-mechanics", "mechanism"),
];

/// Measures the named parts, or all of them, and prints one table.
pub fn run(root: &Path, parts: &[&str]) -> Result<()> {
    for part in parts {
        if !PARTS.iter().any(|(name, ..)| name == part) {
            let known: Vec<&str> = PARTS.iter().map(|(name, ..)| *name).collect();
            bail!("`{part}` cannot be measured; write one of {}", known.join(", "));
        }
    }
    let chosen = PARTS.iter().filter(|(name, ..)| parts.is_empty() || parts.contains(name));
    let mut rows = Vec::new();
    for (name, package, bench) in chosen {
        let mut command = cargo(root);
        command.args(["bench", "--package", package, "--bench", bench]);
        if *name == "tui" {
            run_command(cargo(root).args(["build", "--release", "--package", "dalembert"]))?;
            command.env("DALEMBERT", target(root).join("release/dalembert"));
        }
        let printed = output(&mut command)?;
        let found: Vec<Row> = printed.lines().filter_map(Row::read).collect();
        ensure!(!found.is_empty(), "the bench {bench} of {package} printed no figures");
        rows.extend(found);
    }
    print!("{}", table(&rows));
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
