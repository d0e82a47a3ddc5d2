//! Causes of wrong answers: those of the course's own errors, and of a part of the corpus of student errors.

use std::path::Path;

use dalembert_core::{Stop, cases, check, find};
use dalembert_tests::errors::{corpus, tally};

/// Analysis, case counted from 1, answer, what was written, and words of the cause that comes first.
const OF_THE_COURSE: [(&str, usize, &str, &str, &str); 18] = [
    ("virtual-work/virtual-power", 1, "torque", "82350 N*m", "−45 000 W instead of the −450 000 W"),
    ("virtual-work/virtual-power", 1, "torque", "102600 N*m", "sign error in the term I_G₁ α₁"),
    ("virtual-work/virtual-power", 1, "torque", "82750 N*m", "computing P_Fi₁"),
    ("vibration/rotating-unbalance", 1, "amplitude", "1.743 mm", "assumed ζ = 0.707"),
    ("vibration/rotating-unbalance", 1, "damping_ratio", "0.0616", "light damping"),
    ("vibration/rotating-unbalance", 1, "damping_ratio", "0.707", "assumes 0.707"),
    ("vibration/rotating-unbalance", 1, "worst_speed", "1014.4 rpm", "another answer: Natural frequency"),
    (
        "vibration/rotating-unbalance",
        1,
        "stiffness",
        "7222.2 kN/m",
        "Simply supported beam in place of Cantilever",
    ),
    (
        "vibration/rotating-unbalance",
        1,
        "amplitude",
        "20.3 mm",
        "given value: Maximum steady-state amplitude",
    ),
    ("vibration/rotating-unbalance", 1, "transmitted_force", "8782 N", "the term (c ω)² omitted"),
    (
        "vibration/shaft-clearance",
        1,
        "diameters",
        "≥ 0.44 m",
        "the damping ratio in place of the coefficient",
    ),
    ("vibration/shaft-clearance", 1, "diameters", "440 mm", "the damping ratio in place of the coefficient"),
    ("vibration/shaft-clearance", 3, "diameters", "0.44 m", "one limit or one part of the set only"),
    ("vibration/shaft-clearance", 3, "diameters", ">= 440 mm", "one limit or one part of the set only"),
    ("vibration/beam-and-springs", 1, "mass", "910.17 kg", "incorrectly copied stiffness"),
    ("vibration/beam-and-springs", 1, "damping", "350660 N*s/m", "The decay ratio 15:1 was not used"),
    ("vibration/beam-and-springs", 1, "transmissibility", "1.001", "Follows from ζ = 12"),
    ("balancing/two-plane", 1, "mass_a", "5.531 kg", "measured from the other end of: Position of plane B"),
];

#[test]
fn the_errors_of_the_course_have_their_cause_first() {
    for (id, case, answer, typed, words) in OF_THE_COURSE {
        let entry = find(id).unwrap();
        let record = cases::cases(entry).unwrap()[case - 1].record(entry).unwrap();
        let solution = entry.solve(&record, &Stop::new()).unwrap();
        let typed = [(answer.to_owned(), typed.to_owned())];
        let causes = check::causes(entry, &record, &solution, &typed, &Stop::new(), None);
        let first = causes.first().and_then(|(_, causes)| causes.first());
        let first = first.map_or_else(String::new, |cause| cause.text(&solution).english());
        assert!(first.contains(words), "{id} {typed:?}: {first}");
    }
}

#[test]
fn most_errors_of_the_corpus_have_their_cause_first() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("data/errors");
    let all = corpus(&folder);
    let errors: usize = all.iter().map(|problem| problem.errors.len()).sum();
    assert!(errors > 800, "{errors}");
    let sample: Vec<_> = all.into_iter().step_by(6).collect();
    let mut log = String::new();
    let [singles, _] = tally(&sample, 6, &|_| 1.0, &mut log);
    assert!(singles.made > 80, "{singles:?}");
    assert!(singles.right_share() > 65.0, "{singles:?}\n{log}");
}
