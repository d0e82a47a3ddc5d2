//! The program as it is run: the command line, and the workbench in a pseudo-terminal.

mod cli;
mod faults;
mod replay;
mod study;
mod workbench;
mod workflows;
