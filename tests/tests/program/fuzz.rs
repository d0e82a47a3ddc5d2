//! Readers and writers of foreign text: what they begin with, and what the search for faults has found worth keeping.

use std::{fs, path::Path};

use dalembert_tests::fuzz::TARGETS;
use xtask::fuzz::corpus;

#[test]
fn what_was_found_is_read_without_a_fault() {
    for target in TARGETS {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("data/fuzz/{}.jsonl", target.name));
        let lines = fs::read_to_string(&path).unwrap_or_else(|err| panic!("{}: {err}", path.display()));
        let (seeds, found) =
            ((target.seeds)(), corpus(&lines).unwrap_or_else(|err| panic!("{}: {err}", path.display())));
        assert!(!seeds.is_empty() && !found.is_empty(), "{} has nothing to read", target.name);
        for bytes in seeds.iter().chain(&found) {
            (target.read)(bytes);
        }
    }
}
