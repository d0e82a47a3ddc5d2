//! Placeholder until the reader is complete.
fn main() {}
