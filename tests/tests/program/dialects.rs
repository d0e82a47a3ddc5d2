//! Files as other programs write them: each is read right, or refused with the repair and without its content.

use xtask::dialects::{Outcome, readings};

#[test]
fn every_dialect_is_right_or_refused() {
    let features: &[&str] = if cfg!(feature = "parquet") { &["parquet"] } else { &[] };
    let all = readings(&xtask::root(), &crate::program, features).expect("the files are there");
    let amiss: Vec<_> = all
        .iter()
        .filter(|reading| matches!(reading.outcome, Outcome::Amiss(_) | Outcome::Wrong(_)))
        .collect();
    assert!(amiss.is_empty(), "{amiss:#?}");
    let count = |outcome: Outcome| all.iter().filter(|reading| reading.outcome == outcome).count();
    assert!(count(Outcome::Right) >= 60 && count(Outcome::Refused) >= 30, "{} readings", all.len());
}
