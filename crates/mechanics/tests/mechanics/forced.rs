//! Motion from rest, isolation over a band, usable bands of instruments, periodic forces.

use std::f64::consts::{PI, TAU};

use dalembert_mechanics::sdof;
use dalembert_mechanics::vibration::instrument::{Reads, usable_ratios};
use dalembert_mechanics::vibration::isolation::{self, Shaking, worst_motion, worst_transmission};
use dalembert_mechanics::vibration::periodic::{self, ExcitationPath, PeriodicResponse, WaveSegment};
use dalembert_mechanics::vibration::transient_from_rest::{self, history};
use proptest::prelude::*;

use crate::close::{ROUNDING, close};

#[test]
fn resonance_grows_with_the_time_without_damping() {
    let drive = transient_from_rest::HarmonicDrive { frequency: 50.0, sine: 2e-4, cosine: 0.0 };
    for (t, x) in history(50.0, 0.0, drive, 10.0, 97).unwrap() {
        let angle = 50.0 * t;
        let exact = 1e-4 * (angle.sin() - angle * angle.cos());
        assert!((x - exact).abs() <= 1e-11 * 1e-4 * (1.0 + angle), "{t}: {x} is not {exact}");
    }
}

proptest! {
    /// A requirement is met exactly at the ratio found, and better at every higher one.
    #[test]
    fn isolation_from_the_ratio_on(transmissibility in 0.001f64..0.99, zeta in 0.0f64..1.5, more in 1.0f64..20.0) {
        let sum = isolation::isolating_sum(transmissibility, zeta);
        let ratio = isolation::isolating_ratio(transmissibility, sum);
        close(sdof::transmissibility(ratio, zeta), transmissibility, 1e-11);
        prop_assert!(sdof::transmissibility(ratio * more, zeta) <= transmissibility * (1.0 + 1e-11));
    }

    /// No speed of the band is worse than the one found.
    #[test]
    fn nothing_is_worse_than_the_worst(zeta in 0.01f64..1.2, low in 0.05f64..3.0, width in 0.0f64..5.0, share in 0.0f64..1.0) {
        let band = [low, low + width];
        let r = low + share * width;
        for shaking in [Shaking::Force, Shaking::Unbalance] {
            let strength = |r: f64| if shaking == Shaking::Force { 1.0 } else { r * r };
            let worst = worst_transmission(shaking, zeta, band).unwrap();
            let of = |r: f64| strength(r) * sdof::transmissibility(r, zeta);
            prop_assert!(of(r) <= of(worst) * (1.0 + 1e-9));
            let worst = worst_motion(shaking, zeta, band).unwrap();
            let of = |r: f64| strength(r) * sdof::magnification(r, zeta);
            prop_assert!(of(r) <= of(worst) * (1.0 + 1e-9));
        }
    }

    /// A ratio is in the usable set where the reading is within the error.
    #[test]
    fn usable_is_what_is_within_the_error(zeta in 0.0f64..1.5, error in 0.002f64..0.6, r in 0.01f64..30.0) {
        for reads in [Reads::Displacement, Reads::Acceleration] {
            let factor = match reads {
                Reads::Displacement => sdof::unbalance_magnification(r, zeta),
                Reads::Acceleration => sdof::magnification(r, zeta),
            };
            let off = (factor - 1.0).abs();
            if (off - error).abs() > 1e-9 {
                prop_assert_eq!(usable_ratios(reads, zeta, error).contains(r), off < error, "r = {}, off {}", r, off);
            }
        }
    }

    /// The exact motion has the mean square of all its harmonics, and the size of each of them.
    #[test]
    fn the_exact_motion_is_the_sum_of_its_harmonics(
        zeta in 0.02f64..6.0, ratio in 0.1f64..4.0, wave in 0usize..7, base in any::<bool>(),
    ) {
        let pieces = waves().swap_remove(wave);
        let drive = if base { ExcitationPath::Base } else { ExcitationPath::Force };
        let factor = |r: f64| if base { sdof::transmissibility(r, zeta) } else { sdof::magnification(r, zeta) };
        let steady = PeriodicResponse::new(&pieces, drive, zeta, TAU / ratio).unwrap();
        let mut square = periodic::mean(&pieces).powi(2);
        // A heavily damped base passes on harmonics up to 2ζ/r in full measure: what is left out falls as (2ζ/r)²/n³.
        let harmonics = 3000 + (200.0 * zeta / ratio) as u32;
        for n in 1..=harmonics {
            let (a, b) = periodic::harmonic(&pieces, n);
            square += 0.5 * (a.hypot(b) * factor(f64::from(n) * ratio)).powi(2);
        }
        close(steady.mean_square().unwrap(), square, 1e-8);
        let [largest, least] = steady.extremes().unwrap();
        for n in 0..97 {
            let x = steady.displacement(f64::from(n) / 97.0);
            prop_assert!(x <= largest + 1e-12 && x >= least - 1e-12, "{} is not within {} and {}", x, least, largest);
        }
    }
}

#[test]
fn coefficients_of_the_tables() {
    let all = waves();
    for n in 1..=9u32 {
        let m = f64::from(n);
        let odd = if n % 2 == 1 { 1.0 } else { 0.0 };
        let even = 1.0 - odd;
        let size = |wave: usize| {
            let (a, b) = periodic::harmonic(&all[wave], n);
            a.hypot(b)
        };
        let near = |wave: usize, expected: f64| {
            assert!(
                (size(wave) - expected).abs() < 1e-14,
                "wave {wave}, n = {n}: {} is not {expected}",
                size(wave)
            );
        };
        near(0, odd * 4.0 / (PI * m));
        near(1, odd * 8.0 / (PI * m).powi(2));
        near(2, 1.0 / (PI * m));
        near(3, if n == 1 { 0.5 } else { even * 2.0 / (PI * (m * m - 1.0)) });
        near(4, 4.0 / (PI * (4.0 * m * m - 1.0)));
        near(5, 2.0 * (0.3 * PI * m).sin().abs() / (PI * m));
    }
}

#[test]
fn undamped_square_wave_in_closed_form() {
    // About the deflection of each half period the motion is a cosine: x = 1 − cos(ω_n(t − T/4))/cos(ω_n T/4).
    let ratio = 0.3;
    let steady = PeriodicResponse::new(&periodic::square(), ExcitationPath::Force, 0.0, TAU / ratio).unwrap();
    for n in 0..50 {
        let share = f64::from(n) / 100.0;
        let exact = 1.0 - (TAU / ratio * (share - 0.25)).cos() / (TAU / ratio / 4.0).cos();
        assert!((steady.displacement(share) - exact).abs() < 1e-12);
        assert!((steady.displacement(share + 0.5) + exact).abs() < 1e-12);
    }
    // The third harmonic at the natural frequency: no steady motion.
    assert!(PeriodicResponse::new(&periodic::square(), ExcitationPath::Force, 0.0, TAU * 3.0).is_none());
}

#[test]
fn damping_through_one_changes_nothing_suddenly() {
    let pieces = periodic::triangle();
    let at = |zeta: f64| {
        PeriodicResponse::new(&pieces, ExcitationPath::Base, zeta, 5.0).unwrap().displacement(0.4)
    };
    for step in [1e-12, 1e-9, 1e-6] {
        close(at(1.0 + step), at(1.0), 2.0 * step + ROUNDING);
        close(at(1.0 - step), at(1.0), 2.0 * step + ROUNDING);
    }
}

fn waves() -> Vec<Vec<WaveSegment>> {
    vec![
        periodic::square(),
        periodic::triangle(),
        periodic::sawtooth(),
        periodic::half_rectified(),
        periodic::full_rectified(),
        periodic::pulse(0.3),
        periodic::polygon(&[(0.1, 0.0), (0.3, 2.0), (0.3, -1.0), (0.8, 0.5)]).expect("the shares ascend"),
    ]
}

#[test]
fn a_slow_wave_is_followed_at_rest() {
    // Far below the natural frequency the mean square is that of the wave: 1/3 of a triangle, 1/2 of arches.
    for zeta in [0.3, 1.0, 20.0] {
        let triangle =
            PeriodicResponse::new(&periodic::triangle(), ExcitationPath::Force, zeta, 1e6).unwrap();
        close(triangle.mean_square().unwrap(), 1.0 / 3.0, 1e-3 * zeta);
        let arches =
            PeriodicResponse::new(&periodic::full_rectified(), ExcitationPath::Force, zeta, 1e6).unwrap();
        close(arches.mean_square().unwrap(), 0.5, 1e-3 * zeta);
    }
    // Undamped it would ring through a million radians.
    assert!(
        PeriodicResponse::new(&periodic::triangle(), ExcitationPath::Force, 0.0, 1e6 + 1.0)
            .is_none_or(|s| s.mean_square().is_none())
    );
}
