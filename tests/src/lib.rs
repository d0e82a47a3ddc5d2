//! Helpers of the tests of the whole program: a user before the screens, and a terminal for the program itself.

pub mod person;
pub mod pty;

/// Multiplier of the number of random tests over the registry: `DALEMBERT_TIMES`, as `cargo xtask soak nets` sets it.
#[must_use]
pub fn times() -> usize {
    let times = std::env::var("DALEMBERT_TIMES").ok();
    times.map_or(1, |text| text.parse().unwrap_or_else(|_| panic!("DALEMBERT_TIMES is a number: {text}")))
}
