//! tests

pub mod pty;
