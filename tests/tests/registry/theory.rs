//! Every step of a worked solution has its section of the theory, in `docs/theory/derivations.toml`.

use std::{collections::BTreeSet, sync::Mutex};

use dalembert_core::{Locale, printer, registry};
use dalembert_plugins as _;
use dalembert_testkit::{SolvedCase, for_each_problem, on_all_cores};
use dalembert_tests::chosen;
use xtask::handbook::Derivations;

#[test]
fn every_step_of_every_case_has_its_derivation() {
    let derivations = Derivations::read(&xtask::root()).unwrap_or_else(|error| panic!("{error:#}"));
    let english = Locale::english();
    let faults = Mutex::new(BTreeSet::new());
    on_all_cores(&chosen(), |_, entry| {
        let id = entry.about.id;
        let mut open: BTreeSet<&str> = derivations.beginnings(id).map(|(_, beginning)| beginning).collect();
        let mut met = BTreeSet::new();
        for_each_problem(&[*entry], |SolvedCase { solution, .. }| {
            for step in &solution.steps {
                let title = printer::step(solution, step, &english).why;
                match derivations.of_step(id, &title) {
                    Some((_, beginning)) => drop(open.remove(beginning)),
                    None => drop(met.insert(format!("{id}: no section derives the step {title:?}"))),
                }
            }
        });
        met.extend(open.iter().map(|beginning| format!("{id}: no step has the beginning {beginning:?}")));
        faults.lock().expect("no panic while it is held").extend(met);
    });
    let mut faults = faults.into_inner().expect("no panic while it was held");
    let unknown = derivations.analyses().filter(|id| registry().iter().all(|entry| entry.about.id != *id));
    faults.extend(unknown.map(|id| format!("{id}: there is no such analysis")));
    assert!(faults.is_empty(), "{faults:#?}");
}
