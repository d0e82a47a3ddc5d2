//! How long the program takes from its start to its first frame in a terminal of 50 rows of 200 columns.
//!
//! Measures the binary that the variable `DALEMBERT` names. Prints `name<TAB>figure<TAB>goal`, a row a line;
//! `cargo xtask bench` makes a table of them.

use std::{
    env,
    process::{Command, Stdio},
    thread,
    time::{Duration, Instant},
};

use dalembert_tests::pty::{Launch, PATIENCE};

const ROUNDS: usize = 20;

/// A word of the first frame.
const FRAME: &[u8] = b"unbalance";

fn main() {
    let program =
        env::var_os("DALEMBERT").expect("DALEMBERT names the built program: run `cargo xtask bench start`");
    let first_frame = median(|| {
        let start = Instant::now();
        let pty = Launch::new(&program).size(50, 200).start();
        while !pty.raw().windows(FRAME.len()).any(|bytes| bytes == FRAME) {
            assert!(start.elapsed() < PATIENCE, "no first frame:\n{}", pty.screen());
            thread::sleep(Duration::from_micros(100));
        }
        start.elapsed()
    });
    let version = median(|| {
        let start = Instant::now();
        let status = Command::new(&program).arg("--version").stdout(Stdio::null()).status();
        assert!(status.is_ok_and(|status| status.success()), "the program cannot be run");
        start.elapsed()
    });
    println!("start to first frame, 200×50\t{:.1} ms\t< 20 ms", first_frame * 1e3);
    println!("start to the end of --version\t{:.1} ms\t", version * 1e3);
}

/// Seconds.
fn median(mut run: impl FnMut() -> Duration) -> f64 {
    let mut times: Vec<f64> = (0..ROUNDS).map(|_| run().as_secs_f64()).collect();
    times.sort_by(f64::total_cmp);
    times[ROUNDS / 2]
}
