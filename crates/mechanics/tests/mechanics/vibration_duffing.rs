//! Tests of `vibration::duffing`.

use std::f64::consts::TAU;

use dalembert_mechanics::vibration::duffing::*;

const HARD: Duffing = Duffing { mass: 1.0, damping: 0.4681399, stiffness: 8766.2, cubic: 46.752e6 };

/// Elliptic integral against quadrature of the energy, hardening and softening up to its limit.
#[test]
fn the_exact_period_is_that_of_the_energy() {
    for cubic in [-1.0, -0.3, 0.0, 0.5, 100.0] {
        let duffing = Duffing { mass: 2.0, damping: 0.0, stiffness: 3.0, cubic };
        for amplitude in [1e-6, 0.3, 1.0, 1.7] {
            let Some(period) = duffing.free_period(amplitude) else {
                assert!(cubic * amplitude * amplitude <= -3.0 || amplitude > 1.7);
                continue;
            };
            let other = duffing.free_period_by_quadrature(amplitude);
            assert!(
                (period / other - 1.0).abs() < 1e-10,
                "h = {cubic}, A = {amplitude}: {period} and {other}"
            );
        }
    }
    assert!(Duffing { mass: 1.0, damping: 0.0, stiffness: 1.0, cubic: -1.0 }.free_period(1.0).is_none());
}

/// The peak is the largest of a scan over frequencies.
#[test]
fn the_peak_of_the_first_harmonic() {
    for force in [0.125, 0.25] {
        let (largest, at) = HARD.peak(force).expect("a peak");
        let scan = (-2000..=2000).map(|n| at * (1.0 + 1e-8 * f64::from(n)));
        let found = scan
            .flat_map(|frequency| HARD.steady(force, frequency))
            .fold(0.0f64, |largest, one| largest.max(one.amplitude));
        assert!(found <= largest * (1.0 + 1e-9) && found > largest * (1.0 - 1e-6), "{found} and {largest}");
    }
}

/// Hardening and softening, far from a mass of one and with strong damping.
const STRONG: [(Duffing, f64); 2] = [
    (Duffing { mass: 2.3, damping: 12.0, stiffness: 900.0, cubic: 4e5 }, 7.0),
    (Duffing { mass: 0.6, damping: 3.0, stiffness: 250.0, cubic: -8e3 }, 3.0),
];

#[test]
fn the_response_has_its_peak_at_the_frequency_of_the_peak() {
    for (duffing, force) in STRONG {
        let (largest, at) = duffing.peak(force).expect("a peak");
        let of = |frequency: f64| {
            duffing.steady(force, frequency).iter().fold(0.0f64, |most, one| most.max(one.amplitude))
        };
        assert!((of(at) / largest - 1.0).abs() < 1e-10, "{} is not {largest}", of(at));
        for n in -300..=300 {
            assert!(of(at * (1.0 + 1e-3 * f64::from(n))) < largest * (1.0 + 1e-10), "{n}");
        }
    }
}

#[test]
fn at_both_frequencies_of_an_amplitude_the_force_is_balanced() {
    for (duffing, force) in STRONG {
        let (largest, _) = duffing.peak(force).expect("a peak");
        for share in [0.4, 0.7, 0.95] {
            let amplitude = share * largest;
            let [low, high] = duffing.frequencies_of(force, amplitude);
            let backbone = duffing.backbone(amplitude).expect("a backbone");
            assert!(low < backbone && low < high, "{low}, {backbone}, {high}");
            for frequency in [low, high] {
                let held = duffing.equivalent(amplitude) - duffing.mass * frequency * frequency;
                let needed = amplitude * held.hypot(duffing.damping * frequency);
                assert!((needed / force - 1.0).abs() < 1e-10, "{needed} is not {force}");
            }
        }
    }
}

/// At a jump the force is balanced, and the force that is needed does not change with the amplitude: `d(F²)/d(A²) = 0`.
#[test]
fn at_a_jump_the_response_has_a_vertical_tangent() {
    for (cubic, force) in [(4e5, 1.1), (-4e4, 0.9), (-2e4, 1.1)] {
        let duffing = Duffing { mass: 2.3, damping: 0.7, stiffness: 900.0, cubic };
        let jumps = duffing.jumps(force);
        assert_eq!(jumps.len(), 2);
        for (frequency, amplitude) in jumps {
            let soft = duffing.stiffness - duffing.mass * frequency * frequency;
            let (bent, loss) = (0.75 * cubic * amplitude * amplitude, duffing.damping * frequency);
            let needed = amplitude * (soft + bent).hypot(loss);
            assert!((needed / force - 1.0).abs() < 1e-10, "{needed} is not {force}");
            let slope = (soft + bent) * (soft + 3.0 * bent) + loss * loss;
            assert!(slope.abs() < 1e-9 * loss * loss, "{slope:e} of {:e}", loss * loss);
        }
    }
}

/// Every steady vibration satisfies its equation; between the jumps there are three and the middle one is unstable.
#[test]
fn between_the_jumps_there_are_three_vibrations() {
    let force = 0.25;
    let jumps = HARD.jumps(force);
    assert_eq!(jumps.len(), 2);
    let [up, down] = [jumps[0].0, jumps[1].0];
    for (share, count) in [(-0.2, 1), (0.01, 3), (0.5, 3), (0.99, 3), (1.2, 1)] {
        let frequency = up + share * (down - up);
        let steady = HARD.steady(force, frequency);
        assert_eq!(steady.len(), count, "at {frequency}");
        for one in &steady {
            let held = HARD.equivalent(one.amplitude) - HARD.mass * frequency * frequency;
            let needed = one.amplitude * held.hypot(HARD.damping * frequency);
            assert!((needed / force - 1.0).abs() < 1e-9);
        }
        if count == 3 {
            assert_eq!(steady.iter().map(|one| one.stable).collect::<Vec<_>>(), [true, false, true]);
        }
    }
}

/// The two harmonics, integrated over a hundred periods of the full equation, come back to themselves.
#[test]
fn two_harmonics_are_nearly_the_motion() {
    let (force, frequency) = (0.125, 85.0);
    let first = HARD.steady(force, frequency)[0];
    let both = HARD.two_harmonics(force, frequency, &first).expect("a balance");
    let acceleration = |t: f64, x: f64, v: f64| {
        force * (frequency * t).cos() - HARD.damping * v - HARD.stiffness * x - HARD.cubic * x * x * x
    };
    let [_, b, _, d] = both.coefficients;
    let (mut x, mut v) = (both.displacement(0.0), frequency * (b + 3.0 * d));
    let h = TAU / frequency / 400.0;
    for n in 0..400 * 5 {
        let t = h * f64::from(n);
        let (k1, l1) = (v, acceleration(t, x, v));
        let (k2, l2) = (v + h / 2.0 * l1, acceleration(t + h / 2.0, x + h / 2.0 * k1, v + h / 2.0 * l1));
        let (k3, l3) = (v + h / 2.0 * l2, acceleration(t + h / 2.0, x + h / 2.0 * k2, v + h / 2.0 * l2));
        let (k4, l4) = (v + h * l3, acceleration(t + h, x + h * k3, v + h * l3));
        x += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
        v += h / 6.0 * (l1 + 2.0 * l2 + 2.0 * l3 + l4);
    }
    let off = (x - both.displacement(0.0)).abs() / both.amplitude();
    assert!(off < 1e-4, "{off:e} after five periods");
}
