//! The machine-dynamics workbench with every analysis that comes with it.

use std::process::ExitCode;

use dalembert_plugins as _;

/// Memory of the static program: with that of musl, comparing the catalogue takes a third longer.
#[cfg(target_env = "musl")]
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

fn main() -> ExitCode {
    dalembert::main()
}
