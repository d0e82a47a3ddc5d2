//! The machine-dynamics workbench with every analysis that comes with it.

use std::process::ExitCode;

use dalembert_plugins as _;

fn main() -> ExitCode {
    dalembert::main()
}
