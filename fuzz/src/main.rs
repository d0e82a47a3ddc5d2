//! One program for all targets: `DALEMBERT_FUZZ` names the one that libFuzzer calls.

#![no_main]

#[path = "../../tests/src/fuzz.rs"]
mod fuzz;

use std::{env, fs, path::Path, sync::LazyLock};

use fuzz::Target;
use libfuzzer_sys::fuzz_target;

static TARGET: LazyLock<&'static Target> = LazyLock::new(|| {
    let name = env::var("DALEMBERT_FUZZ").unwrap_or_default();
    fuzz::target(&name).unwrap_or_else(|| panic!("DALEMBERT_FUZZ={name}: no such target"))
});

fuzz_target!(
    init: {
        if let Some(folder) = env::var_os("DALEMBERT_SEEDS") {
            for (number, seed) in (TARGET.seeds)().into_iter().enumerate() {
                fs::write(Path::new(&folder).join(format!("seed-{number}")), seed).expect("the seed is written");
            }
        }
    },
    |bytes: &[u8]| (TARGET.read)(bytes)
);
