//! Benchmark of reading and writing quantities: texts per second.
//!
//! Prints `name<TAB>figure<TAB>goal`, a row a line; `cargo xtask bench` makes a table of them.

use std::{hint::black_box, time::Instant};

use dalembert_units::{Kind, Style, read_any, read_quantity, unit, write_quantity};

const ROUNDS: u32 = 200_000;

fn main() {
    let mm = unit("mm").expect("mm is a unit");
    for text in [
        "20.3 mm",
        "20,3",
        "1000 rpm",
        "200 kN/mm^2",
        "52.08 N·s/m",
        "1.3×10⁻⁶ m⁴",
        "1/2 in",
        "2*pi*50 rad/s",
    ] {
        each(&format!("read `{text}`"), || {
            let _ = black_box(read_any(black_box(text)));
        });
    }
    each("read `20.3` in a field of mm", || {
        let _ = black_box(read_quantity(black_box("20.3"), &mm, Kind::Length));
    });
    let texts = ["20.3 mm", "1000 rpm", "200 kN/mm^2", "40 kg", "0.1 kg m", "1.2 m", "12 %", "5"];
    let start = Instant::now();
    for n in 0..1_000_000 {
        let _ = black_box(read_any(black_box(texts[n % texts.len()])));
    }
    println!("read 1 000 000 quantities\t{:.3} s\t< 1 s", start.elapsed().as_secs_f64());
    each("write `20.3 mm`", || {
        black_box(write_quantity(black_box(0.0203), &mm, Style::default()));
    });
}

fn each(name: &str, mut work: impl FnMut()) {
    let start = Instant::now();
    for _ in 0..ROUNDS {
        work();
    }
    let each = start.elapsed().as_secs_f64() / f64::from(ROUNDS);
    println!("{name}\t{:.0} ns\t", each * 1e9);
}
