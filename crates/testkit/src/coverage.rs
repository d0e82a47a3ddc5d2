//! Coverage: every answer is held by a second method, or its case file has the reason why not.

use std::{collections::BTreeMap, fmt::Write as _, sync::Mutex};

use dalembert_core::{
    Entry, Stop,
    coverage::{Coverage, CoverageStatus, coverage},
};

use crate::problems::on_all_cores;

/// Makes every answer of every case wrong by one part in a million: a check notices, or the case file has a reason. A
/// reason for an answer that is covered is a fault too. Returns the number of answers that are covered.
pub fn every_answer_is_covered_or_has_a_reason(entries: &[&'static Entry]) -> usize {
    let all = Mutex::new(BTreeMap::new());
    on_all_cores(entries, |_, entry| {
        let of_entry = coverage(entry, &Stop::new());
        let mut all = all.lock().expect("no analysis panics with the list");
        all.insert(entry.about.id, of_entry);
    });
    let all = all.into_inner().expect("no analysis panics with the list");
    let mut faults = String::new();
    let mut fault = |id: &str, words: &str| writeln!(faults, "{id}: {words}").expect("a String takes it");
    let mut covered = 0;
    for (id, of_entry) in &all {
        match of_entry {
            Err(why) => fault(id, why),
            Ok(answers) => {
                assert!(!answers.is_empty(), "{id} has no answers");
                covered +=
                    answers.iter().filter(|one| matches!(one.status, CoverageStatus::Covered(_))).count();
                for Coverage { answer, status, reason } in answers {
                    match (status, reason) {
                        (CoverageStatus::Uncovered, None) => {
                            fault(
                                id,
                                &format!("{answer}: no second method covers it, and no reason is given"),
                            );
                        }
                        (CoverageStatus::Uncovered, Some(_)) | (_, None) => {}
                        (status, Some(_)) => {
                            fault(id, &format!("{answer}: a reason is given, but it is held: {status:?}"));
                        }
                    }
                }
            }
        }
    }
    assert!(faults.is_empty(), "{faults}");
    covered
}
