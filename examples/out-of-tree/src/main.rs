//! A laboratory's own workbench: all that dalembert brings, and an analysis of its own beside it.
//!
//! Naming the bundle links its analyses; leave the line out for a program with yours alone.

use std::process::ExitCode;

use dalembert_plugins as _;
use laboratory as _;

fn main() -> ExitCode {
    dalembert::main()
}
