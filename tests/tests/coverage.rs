//! Every answer is held by a second method, or its case file says why not.

use std::{
    collections::BTreeMap,
    fmt::Write as _,
    sync::{
        Mutex,
        atomic::{AtomicUsize, Ordering},
    },
    thread,
};

use dalembert_core::{
    Stop,
    coverage::{Coverage, Standing, coverage},
    registry,
};
use dalembert_plugins as _;

#[test]
fn every_answer_is_covered_or_has_a_reason() {
    let only = std::env::var("DALEMBERT_ONLY").ok();
    let entries: Vec<_> = registry()
        .iter()
        .filter(|entry| only.as_deref().is_none_or(|id| entry.about.id.starts_with(id)))
        .collect();
    assert!(!entries.is_empty(), "no analysis is {only:?}");
    let (all, next) = (Mutex::new(BTreeMap::new()), AtomicUsize::new(0));
    thread::scope(|scope| {
        for _ in 0..thread::available_parallelism().map_or(1, std::num::NonZero::get) {
            scope.spawn(|| {
                while let Some(entry) = entries.get(next.fetch_add(1, Ordering::Relaxed)) {
                    let of_entry = coverage(entry, &Stop::new());
                    let mut all = all.lock().expect("no analysis panics with the list");
                    all.insert(entry.about.id, of_entry);
                }
            });
        }
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
                covered += answers.iter().filter(|one| matches!(one.standing, Standing::Covered(_))).count();
                for Coverage { answer, standing, reason } in answers {
                    match (standing, reason) {
                        (Standing::Uncovered, None) => {
                            fault(
                                id,
                                &format!("{answer}: no second method covers it, and no reason is given"),
                            );
                        }
                        (Standing::Uncovered, Some(_)) | (_, None) => {}
                        (standing, Some(_)) => {
                            fault(id, &format!("{answer}: a reason is given, but it is held: {standing:?}"));
                        }
                    }
                }
            }
        }
    }
    assert!(faults.is_empty(), "{faults}");
    assert!(covered > 0, "nothing is covered");
}
