//! A plot and the answers do not contradict each other: every curve that is over an input, and every animation, is at each of
//! its points what a direct solve with that input gives. What cannot be over an input stands in `plots/listed.txt` with
//! the reason.

use std::collections::BTreeSet;

use dalembert_core::{Entry, registry};
use dalembert_plugins as _;
use dalembert_testkit::path_independence::{self, Exceptions, Looser};
use dalembert_tests::times;

const LOOSER: [Looser; 3] = [
    Looser {
        id: "vibration/rotor-dynamics",
        title: "Campbell diagram",
        agreement: 1e-7,
        reason: "the modes of the diagrams are those of the reduced rotor; the answers are refined on the whole one",
    },
    Looser {
        id: "vibration/rotor-dynamics",
        title: "Stability map",
        agreement: 1e-7,
        reason: "as the Campbell diagram",
    },
    Looser {
        id: "virtual-work/motion",
        title: "Energy",
        agreement: 1e-7,
        reason: "the steps hold the error of the work beside the energies of the motion, of which it may be a small part",
    },
];

const EXCEPTIONS: Exceptions<'_> = Exceptions { listed: include_str!("plots/listed.txt"), looser: &LOOSER };

/// All cases of a family. `least` is how many curves and animations have to name their input.
fn held((name, least): (&str, usize)) {
    let entries: Vec<&Entry> = registry().iter().copied().filter(|entry| entry.family() == name).collect();
    // One solve of a rotor takes as long as all of other analyses; one case in seven has all its plots.
    let chosen =
        |id: &str, case: usize| id != "vibration/rotor-dynamics" || times() > 1 || case.is_multiple_of(7);
    let named = path_independence::every_curve_over_an_input_is_what_a_direct_solve_gives(
        &entries,
        &EXCEPTIONS,
        chosen,
        times(),
    );
    assert!(named >= least, "{name}: {named} curves name their input");
}

const FAMILIES: [(&str, usize); 4] =
    [("balancing", 2), ("rigid-body", 55), ("vibration", 66), ("virtual-work", 75)];

#[test]
fn every_family_is_held() {
    let families: BTreeSet<&str> = registry().iter().map(|entry| entry.family()).collect();
    assert_eq!(families, FAMILIES.iter().map(|(family, _)| *family).collect());
}

#[test]
fn balancing() {
    held(FAMILIES[0]);
}

#[test]
fn rigid_body() {
    held(FAMILIES[1]);
}

#[test]
fn vibration() {
    held(FAMILIES[2]);
}

#[test]
fn virtual_work() {
    held(FAMILIES[3]);
}
