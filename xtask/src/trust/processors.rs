//! The program on processors without AVX and with AVX2 at most, as qemu emulates them, beside the processor of this machine.

use std::{
    process::{Command, Stdio},
    thread,
};

use anyhow::{Context, Result, ensure};
use serde_json::{Value as Json, json};

use super::{Outcome, shuffled};
use crate::{
    cargo::{Program, installed},
    docs::{array, text},
    server::Server,
};

const EMULATOR: &str = "qemu-x86_64";
/// Processors of qemu: the first has registers of 128 bits, the second AVX2.
const EMULATED: [&str; 2] = ["Nehalem", "Haswell"];
/// Largest relative difference of an answer.
const LIMIT: f64 = 1e-12;

/// Counts of a comparison.
#[derive(Debug, Default)]
struct Compared {
    numbers: u64,
    /// Numbers that differ in any bit.
    unlike: u64,
    failures: Vec<String>,
}

/// Compares the answers of so many cases, drawn by the seed.
pub(super) fn trial(program: &Program, times: u64, seed: u64) -> Result<Outcome> {
    ensure!(
        installed(Command::new(EMULATOR).arg("--version")),
        "{EMULATOR} is missing: Debian has it in `qemu-user`"
    );
    let mut cases = shuffled(cases(program)?, seed);
    cases.truncate(usize::try_from(times)?);
    let compared = thread::scope(|scope| {
        let cases = &cases;
        let on = |processor| scope.spawn(move || compared(program, processor, cases));
        let comparing = EMULATED.map(on);
        let compared = comparing.into_iter().map(|one| one.join().expect("a comparison does not panic"));
        compared.collect::<Result<Vec<_>>>()
    })?;
    let total = |count: fn(&Compared) -> u64| compared.iter().map(count).sum::<u64>();
    let (tried, unlike) = (total(|of| of.numbers), total(|of| of.unlike));
    let note = format!(
        "{} cases on {} of {EMULATOR} and on a machine with {}; {unlike} numbers differ in a bit",
        cases.len(),
        EMULATED.join(" and "),
        registers()
    );
    let failures: Vec<String> = compared.into_iter().flat_map(|of| of.failures).collect();
    Ok(Outcome { tried, failed: failures.len() as u64, failures, note })
}

/// The widest registers of this machine.
fn registers() -> &'static str {
    #[cfg(target_arch = "x86_64")]
    if is_x86_feature_detected!("avx512f") {
        return "AVX-512";
    } else if is_x86_feature_detected!("avx2") {
        return "AVX2";
    }
    "no AVX2"
}

/// Every case, as `id number`.
fn cases(program: &Program) -> Result<Vec<String>> {
    let mut server = Server::start(program, "en")?;
    let mut cases = Vec::new();
    for entry in array(&server.ask("list", &Json::Null)?) {
        let id = text(entry, "id");
        let shown = server.ask("show", &json!(id))?;
        cases.extend((1..=array(&shown["cases"]).len()).map(|case| format!("{id} {case}")));
    }
    Ok(cases)
}

/// Answers of cases on an emulated processor beside those of this machine.
fn compared(program: &Program, processor: &str, cases: &[String]) -> Result<Compared> {
    let mut emulated = Command::new(EMULATOR);
    // Warnings of the emulator are about what no program here asks for.
    emulated.args(["-cpu", processor]).arg(program.path()).args(["--lang", "en"]).stderr(Stdio::null());
    let mut servers = [Server::start(program, "en")?, Server::of(emulated)?];
    let mut compared = Compared::default();
    for case in cases {
        let (id, number) = case.split_once(' ').context("a case has an id and a number")?;
        let request = json!({ "problem": id, "case": number.parse::<u64>()? });
        // A case that is refused has no answers, here and there.
        let [here, there] = servers.each_mut().map(|server| {
            server.ask("solve", &request).map_or_else(|_| Vec::new(), |solved| answers(&solved))
        });
        if here.iter().map(|(name, _)| name).ne(there.iter().map(|(name, _)| name)) {
            compared.failures.push(format!("{case} on {processor}: other answers"));
            continue;
        }
        for ((name, one), (_, other)) in here.iter().zip(&there) {
            compared.numbers += 1;
            compared.unlike += u64::from(one.to_bits() != other.to_bits());
            if !alike(*one, *other) {
                compared.failures.push(format!("{case} on {processor}: {name} is {other:e}, here {one:e}"));
            }
        }
    }
    Ok(compared)
}

fn alike(one: f64, other: f64) -> bool {
    (one - other).abs() <= LIMIT * one.abs().max(other.abs())
}

/// Numbers of the answers of a result in SI, with their names.
fn answers(solved: &Json) -> Vec<(String, f64)> {
    let mut found = Vec::new();
    for (name, answer) in solved["answers"].as_object().into_iter().flatten() {
        numbers(name, &answer["si"], &mut found);
    }
    found
}

fn numbers(name: &str, value: &Json, found: &mut Vec<(String, f64)>) {
    match value {
        Json::Array(items) => items.iter().for_each(|item| numbers(name, item, found)),
        value => found.extend(value.as_f64().map(|number| (name.to_owned(), number))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_answers_and_their_difference() {
        let solved = json!({ "answers": {
            "F": { "si": [1.0, -2.0] }, "state": { "si": null }, "x": { "si": 3 },
        } });
        let expected = [("F", 1.0), ("F", -2.0), ("x", 3.0)].map(|(name, si)| (name.to_owned(), si));
        assert_eq!(answers(&solved), expected);
        assert!(alike(0.0, 0.0) && alike(1.0, 1.0 + 9e-13) && !alike(1.0, 1.0 + 2e-12) && !alike(0.0, 1e-30));
    }
}
