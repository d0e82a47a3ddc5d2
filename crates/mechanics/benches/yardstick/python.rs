//! Other programs on the same work in the same run: ratios to them are what can be compared between machines.

use std::process::Command;

/// The numbers that a Python script prints, one a line; `None` where Python, or what it imports, is not installed.
pub(crate) fn figures<const N: usize>(script: &str) -> Option<[f64; N]> {
    let output = Command::new("python3").args(["-c", script]).output().ok()?;
    let figures: Vec<f64> =
        String::from_utf8(output.stdout).ok()?.lines().filter_map(|line| line.parse().ok()).collect();
    figures.try_into().ok()
}
