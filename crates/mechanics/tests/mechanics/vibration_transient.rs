//! Closed forms, and what no exact method may change.

use std::f64::consts::{PI, TAU};

use proptest::prelude::*;

use dalembert_mechanics::vibration::transient::*;

fn motion(natural: f64, ratio: f64, load: &[LoadSegment]) -> TransientMotion {
    TransientMotion::new(Oscillator { natural, ratio }, OscillatorState::default(), load)
        .expect("the load has an answer")
}

fn line(from: f64, start: f64, slope: f64) -> LoadSegment {
    LoadSegment { from, law: LoadLaw::Line { start, slope } }
}

fn half_sine(duration: f64) -> [LoadSegment; 2] {
    let law = LoadLaw::Sine { amplitude: 1.0, frequency: PI / duration };
    [LoadSegment { from: 0.0, law }, line(duration, 0.0, 0.0)]
}

fn close(ours: f64, expected: f64, scale: f64) {
    assert!((ours - expected).abs() <= 1e-12 * scale, "{ours} is not {expected}");
}

#[test]
fn a_step_overshoots_by_its_closed_form() {
    for ratio in [0.0, 0.05, 0.3, 0.7] {
        let peak = motion(3.0, ratio, &[line(0.0, 2.0, 0.0)])
            .extremes(TransientOutput::DISPLACEMENT, [0.0, f64::INFINITY])
            .unwrap()
            .largest;
        let damped = (1.0 - ratio * ratio).sqrt();
        close(peak.value, 2.0 * (1.0 + (-PI * ratio / damped).exp()), 2.0);
        close(peak.time, PI / (3.0 * damped), 1.0);
    }
}

#[test]
fn a_ramp_that_is_held_overshoots_by_its_closed_form() {
    for rise in [0.05, 0.4, 0.9, 2.7] {
        let load = [line(0.0, 0.0, 1.0 / rise), line(rise, 1.0, 0.0)];
        let peak =
            motion(TAU, 0.0, &load).extremes(TransientOutput::DISPLACEMENT, [0.0, f64::INFINITY]).unwrap();
        close(peak.largest.value, 1.0 + (PI * rise).sin().abs() / (PI * rise), 1.0);
    }
}

/// Undamped half-sine: the residual is `4 f t_d cos(π f t_d)/(1 − (2 f t_d)²)`; in resonance it is `π/2`.
#[test]
fn a_half_sine_leaves_its_closed_form() {
    for duration in [1e-3, 0.1, 0.31, 0.499_999_9, 0.5, 0.500_01, 0.81, 1.7, 12.3] {
        let residual = motion(TAU, 0.0, &half_sine(duration))
            .extremes(TransientOutput::DISPLACEMENT, [duration, f64::INFINITY])
            .unwrap()
            .farthest();
        let detuning = 1.0 - (2.0 * duration).powi(2);
        let expected = if detuning.abs() < 1e-9 {
            PI / 2.0
        } else {
            // cos(π d) over 1 − (2d)² without cancellation.
            let off = PI * (0.5 - duration);
            (4.0 * duration * off.sin() / ((1.0 - 2.0 * duration) * (1.0 + 2.0 * duration))).abs()
        };
        assert!((residual.value.abs() - expected).abs() < 2e-12, "{} is not {expected}", residual.value);
    }
}

#[test]
fn the_half_sine_amplifies_by_1_768_at_most() {
    let at = |part: f64| {
        motion(TAU, 0.0, &half_sine(part))
            .extremes(TransientOutput::DISPLACEMENT, [0.0, part])
            .unwrap()
            .largest
            .value
    };
    assert!((at(0.810_133_3) - 1.768_458).abs() < 1e-6);
}

#[test]
fn damping_passes_critical_without_a_jump() {
    for theta in [0.01, 0.3, 1.0, 7.0, 30.0] {
        let at = |ratio| UnitResponses::at(ratio, theta);
        for off in [1e-13, 1e-9, 1e-6] {
            for (a, b) in [(at(1.0), at(1.0 - off)), (at(1.0), at(1.0 + off))] {
                for (a, b) in [(a.release, b.release), (a.impulse, b.impulse), (a.ramp, b.ramp)] {
                    assert!((a - b).abs() <= 1e-12 + 10.0 * off, "{a} and {b} at {theta}");
                }
            }
        }
    }
}

#[test]
fn a_shock_far_shorter_than_the_period_is_an_impulse() {
    let short = 1e-7;
    let load = [line(0.0, 1.0, 0.0), line(short, 0.0, 0.0)];
    let residual = motion(1.0, 0.0, &load)
        .extremes(TransientOutput::DISPLACEMENT, [0.0, f64::INFINITY])
        .unwrap()
        .largest;
    assert!((residual.value / short - 1.0).abs() < 1e-12, "{}", residual.value / short);
}

#[test]
fn an_exponential_at_a_root_of_the_oscillator_is_no_pole() {
    // ζ = 1.25: the roots are −0.5 and −2.
    let at = |rate: f64| {
        let load = [LoadSegment { from: 0.0, law: LoadLaw::Decay { amplitude: 1.0, rate } }];
        motion(1.0, 1.25, &load).at(3.0).displacement
    };
    let exact = 2.0 / 3.0 * (3.0 * (-1.5f64).exp() - ((-1.5f64).exp() - (-6.0f64).exp()) / 1.5);
    close(at(0.5), exact, 1.0);
    close(at(0.5 + 1e-9), exact, 1e4);
    close(at(0.5 + 2e-3), 0.5 * (at(0.5 + 1.9e-3) + at(0.5 + 2.1e-3)), 1e5);
}

#[test]
fn a_ramp_without_end_has_no_largest_value() {
    let load = [line(0.0, 0.0, 1.0)];
    assert_eq!(
        motion(1.0, 0.1, &load).extremes(TransientOutput::DISPLACEMENT, [0.0, f64::INFINITY]),
        Err(TransientError::Unbounded)
    );
}

proptest! {
    /// A piece cut in two moves as the whole one does.
    #[test]
    fn halving_steps_changes_nothing(
        ratio in 0.0..3.0f64, values in prop::collection::vec(-1.0..1.0f64, 3..8), step in 0.01..4.0f64,
    ) {
        let load = |parts: usize| {
            let mut pieces = Vec::new();
            for (n, pair) in values.windows(2).enumerate() {
                let slope = (pair[1] - pair[0]) / step;
                for part in 0..parts {
                    let into = step * part as f64 / parts as f64;
                    pieces.push(line(step * n as f64 + into, pair[0] + slope * into, slope));
                }
            }
            pieces.push(line(step * (values.len() - 1) as f64, 0.0, 0.0));
            pieces
        };
        let (whole, halved) = (motion(1.0, ratio, &load(1)), motion(1.0, ratio, &load(2)));
        for n in 0..40 {
            let time = step * values.len() as f64 * f64::from(n) / 30.0;
            let (a, b) = (whole.at(time), halved.at(time));
            prop_assert!((a.displacement - b.displacement).abs() <= 1e-12 * (1.0 + a.displacement.abs()));
            prop_assert!((a.velocity - b.velocity).abs() <= 1e-12 * (1.0 + a.velocity.abs()));
        }
    }

    /// The recurrence and Duhamel's integral agree under every kind of piece, and superpose.
    #[test]
    fn duhamel_and_the_recurrence_agree(
        ratio in 0.0..2.0f64, frequency in 0.05..5.0f64, rate in 0.05..5.0f64, end in 0.1..6.0f64, time in 0.1..20.0f64,
    ) {
        let sine = [LoadSegment { from: 0.0, law: LoadLaw::Sine { amplitude: 1.0, frequency } }, line(end, 0.0, 0.0)];
        let decay = [LoadSegment { from: 0.0, law: LoadLaw::Decay { amplitude: 0.7, rate } }, line(end, 0.3, -0.1)];
        for load in [&sine, &decay] {
            let motion = motion(1.0, ratio, load);
            let integral = motion.duhamel(time).unwrap();
            let ours = motion.at(time).displacement;
            prop_assert!((ours - integral).abs() <= 1e-11 * (1.0 + ours.abs()), "{ours} and {integral}");
        }
    }

    /// No value between the ends is beyond the extremes, and the extremes are reached.
    #[test]
    fn the_extremes_are_the_extremes(
        ratio in 0.0..1.5f64, values in prop::collection::vec(-1.0..1.0f64, 3..6), step in 0.1..9.0f64,
    ) {
        let load: Vec<LoadSegment> = values
            .windows(2)
            .enumerate()
            .map(|(n, pair)| line(step * n as f64, pair[0], (pair[1] - pair[0]) / step))
            .chain([line(step * (values.len() - 1) as f64, 0.0, 0.0)])
            .collect();
        let motion = motion(1.0, ratio, &load);
        let output = TransientOutput { displacement: 0.6, velocity: 0.8 };
        let found = motion.extremes(output, [0.0, f64::INFINITY]).unwrap();
        for n in 0..4000 {
            let value = motion.output(output, f64::from(n) * step * values.len() as f64 / 3000.0);
            prop_assert!(value <= found.largest.value + 1e-11 && value >= found.least.value - 1e-11);
        }
        prop_assert!((motion.output(output, found.largest.time) - found.largest.value).abs() < 1e-11);
        prop_assert!((motion.output(output, found.least.time) - found.least.value).abs() < 1e-11);
    }

    /// Without damping and load nothing is lost.
    #[test]
    fn energy_is_kept_without_damping(x in -1.0..1.0f64, v in -1.0..1.0f64, time in 0.0..200.0f64) {
        let initial = OscillatorState { displacement: x, velocity: v };
        let motion = TransientMotion::new(Oscillator { natural: 1.7, ratio: 0.0 }, initial, &[]).unwrap();
        let energy = |state: OscillatorState| state.velocity.powi(2) + (1.7 * state.displacement).powi(2);
        prop_assert!((energy(motion.at(time)) - energy(initial)).abs() <= 1e-12 * energy(initial));
    }
}

/// A half sine hundreds of periods long loads the spring almost as at rest: `1/(1 − r²)` and the ripple on it.
#[test]
fn a_slow_half_sine_is_found_in_its_middle() {
    let duration = 500.25;
    let found = motion(TAU, 0.0, &half_sine(duration))
        .extremes(TransientOutput::DISPLACEMENT, [0.0, duration])
        .unwrap();
    let r = 0.5 / duration;
    // The velocity is zero where Ωt = 2πj r/(1 + r); the peak is the one nearest to a quarter wave.
    let peak = (1..1000).map(|j| (TAU * f64::from(j) * r / (1.0 + r)).sin() / (1.0 - r)).fold(0.0, f64::max);
    close(found.largest.value, peak, 1.0);
}

proptest! {
    /// Twice the load and another load beside it: the motions add up.
    #[test]
    fn motions_add_up(
        ratio in 0.0..2.0f64, rate in 0.1..3.0f64, frequency in 0.1..3.0f64, end in 0.5..5.0f64, time in 0.0..20.0f64,
    ) {
        let one = [LoadSegment { from: 0.0, law: LoadLaw::Line { start: 1.0, slope: -0.3 } }, line(end, 0.0, 0.0)];
        let both = [LoadSegment { from: 0.0, law: LoadLaw::Line { start: 2.5, slope: -0.6 } }, line(end, 0.0, 0.0)];
        let step = [line(0.0, 0.5, 0.0), line(end, 0.0, 0.0)];
        let at = |load: &[LoadSegment]| motion(1.3, ratio, load).at(time).displacement;
        prop_assert!((2.0 * at(&one) + at(&step) - at(&both)).abs() <= 1e-12 * (1.0 + at(&both).abs()));
        // A sine and an exponential scale with their size.
        for law in [
            |size, _, frequency| LoadLaw::Sine { amplitude: size, frequency },
            |size, rate, _| LoadLaw::Decay { amplitude: size, rate },
        ] {
            let of = |size| at(&[LoadSegment { from: 0.0, law: law(size, rate, frequency) }]);
            prop_assert!((of(3.0) - 3.0 * of(1.0)).abs() <= 1e-12 * (1.0 + of(3.0).abs()));
        }
    }
}

/// `ẍ = ω²(u − x) − 2ζωẋ` under every law of the load, the rates by central differences of eighth order.
#[test]
fn every_law_of_the_load_satisfies_the_equation_of_motion() {
    let initial = OscillatorState { displacement: 0.37, velocity: -0.83 };
    for law in [
        LoadLaw::Line { start: 0.7, slope: -0.4 },
        LoadLaw::Sine { amplitude: 1.6, frequency: 2.1 },
        LoadLaw::Decay { amplitude: 1.4, rate: 0.6 },
        LoadLaw::Rise { size: 1.7, rate: 0.6 },
        LoadLaw::Versine { size: 1.9, frequency: 2.1 },
        LoadLaw::Parabola { start: 0.6, slope: -0.3, bend: 0.21 },
    ] {
        for ratio in [0.0, 0.3, 1.7] {
            let oscillator = Oscillator { natural: 1.3, ratio };
            let motion =
                TransientMotion::new(oscillator, initial, &[LoadSegment { from: 0.0, law }]).unwrap();
            for time in [0.2, 1.1, 2.9, 6.4] {
                let step = 0.02;
                let rate = |of: fn(OscillatorState) -> f64| {
                    let pair = |n: f64| of(motion.at(time + n * step)) - of(motion.at(time - n * step));
                    (672.0 * pair(1.0) - 168.0 * pair(2.0) + 32.0 * pair(3.0) - 3.0 * pair(4.0))
                        / (840.0 * step)
                };
                let here = motion.at(time);
                let pull = law.at(time) - here.displacement;
                let acceleration = 1.69 * pull - 2.6 * ratio * here.velocity;
                for (ours, theirs) in [
                    (here.velocity, rate(|state| state.displacement)),
                    (acceleration, rate(|state| state.velocity)),
                ] {
                    assert!((ours - theirs).abs() < 1e-8, "{law:?}, {ratio}, {time}: {ours} is not {theirs}");
                }
            }
        }
    }
}

#[test]
fn closed_forms_as_a_worked_solution_writes_them_are_the_motion() {
    let (natural, frequency, constant): (f64, f64, f64) = (2.3, 3.1, 1.7);
    for ratio in [0.0_f64, 0.3, 1.0, 2.4] {
        for time in [0.13_f64, 0.9, 2.7, 6.1] {
            let damped = natural * (1.0 - ratio * ratio).sqrt();
            let [slow, fast] = [closed::slow_rate(natural, ratio), closed::fast_rate(natural, ratio)];
            let [release, impulse] = if ratio == 0.0 {
                [closed::release_undamped(natural, time), closed::impulse_undamped(natural, time)]
            } else if ratio < 1.0 {
                [
                    closed::release_underdamped(natural, ratio, damped, time),
                    closed::impulse_underdamped(natural, ratio, damped, time),
                ]
            } else if ratio == 1.0 {
                [closed::release_critical(natural, time), closed::impulse_critical(natural, time)]
            } else {
                [closed::release_overdamped(slow, fast, time), closed::impulse_overdamped(slow, fast, time)]
            };
            let free = |displacement: f64, velocity: f64| {
                let initial = OscillatorState { displacement, velocity };
                TransientMotion::new(Oscillator { natural, ratio }, initial, &[])
                    .unwrap()
                    .at(time)
                    .displacement
            };
            close(release, free(1.0, 0.0), 1.0);
            close(impulse, free(0.0, 1.0), 1.0);
            let under = |law: LoadLaw| {
                motion(natural, ratio, &[LoadSegment { from: 0.0, law }]).at(time).displacement
            };
            let detuned = frequency / natural;
            for (written, theirs) in [
                (
                    closed::ramp(natural, ratio, time, release, impulse),
                    under(LoadLaw::Line { start: 0.0, slope: 1.0 }),
                ),
                (
                    closed::sine(frequency, detuned, ratio, time, release, impulse),
                    under(LoadLaw::Sine { amplitude: 1.0, frequency }),
                ),
                (
                    closed::cosine(frequency, detuned, ratio, time, release, impulse),
                    1.0 - release - 2.0 * under(LoadLaw::Versine { size: 1.0, frequency }),
                ),
                (
                    closed::exponential(constant, natural, ratio, time, release, impulse),
                    under(LoadLaw::Decay { amplitude: 1.0, rate: 1.0 / constant }),
                ),
                (
                    closed::parabola(natural, ratio, time, release, impulse),
                    under(LoadLaw::Parabola { start: 0.0, slope: 0.0, bend: 1.0 }),
                ),
            ] {
                close(written, theirs, 10.0);
            }
            if ratio == 0.0 {
                let undamped = closed::sine_undamped(frequency, detuned, time, impulse);
                close(undamped, under(LoadLaw::Sine { amplitude: 1.0, frequency }), 1.0);
            }
        }
    }
}

/// The residues at `−s₁` and `−s₂`, and the particular solution.
#[test]
fn a_strongly_damped_motion_is_the_sum_over_its_poles() {
    let (natural, rate, frequency): (f64, f64, f64) = (1.3, 0.6, 2.1);
    for ratio in [2.6_f64, 13.0, 60.0] {
        let fast = natural * (ratio + f64::sqrt(ratio * ratio - 1.0));
        let slow = natural * natural / fast;
        let between = fast - slow;
        for time in [0.02_f64, 0.1, 0.3, 0.7, 2.1, 9.0] {
            let at = |law: LoadLaw| {
                motion(natural, ratio, &[LoadSegment { from: 0.0, law }]).at(time).displacement
            };
            let [slowly, quickly] = [(-slow * time).exp() / between, (-fast * time).exp() / between];
            let decay = (-rate * time).exp() / ((slow - rate) * (fast - rate)) + slowly / (rate - slow)
                - quickly / (rate - fast);
            close(at(LoadLaw::Decay { amplitude: 1.0, rate }), natural * natural * decay, 1.0);
            let (detuning, damping) =
                (natural * natural - frequency * frequency, 2.0 * ratio * natural * frequency);
            let (sin, cos) = (frequency * time).sin_cos();
            let sine = (detuning * sin - damping * cos) / (detuning * detuning + damping * damping)
                + frequency * slowly / (slow * slow + frequency * frequency)
                - frequency * quickly / (fast * fast + frequency * frequency);
            close(at(LoadLaw::Sine { amplitude: 1.0, frequency }), natural * natural * sine, 1.0);
        }
    }
}

/// A swing that dies out on a load that rises: its first peak stays the largest, in every unit of time.
#[test]
fn a_swing_on_a_rising_load_peaks_alike_at_every_frequency() {
    let largest = |natural: f64| {
        let initial = OscillatorState { displacement: -1.2, velocity: 6.0 * natural };
        let oscillator = Oscillator { natural, ratio: 0.1 };
        let motion = TransientMotion::new(oscillator, initial, &[line(0.0, 0.0, natural / 6.0)]).unwrap();
        let end = 24.0 / natural;
        let peak = motion.extremes(TransientOutput::DISPLACEMENT, [0.0, end]).unwrap().largest;
        for n in 0..=4000 {
            let value = motion.at(end * f64::from(n) / 4000.0).displacement;
            assert!(value <= peak.value + 1e-12, "{value} is above {peak:?}");
        }
        [peak.value, peak.time * natural]
    };
    let [value, time] = largest(1.0);
    for natural in [0.4, 6.0, 250.0] {
        let [ours, at] = largest(natural);
        close(ours, value, value);
        assert!((at - time).abs() < 1e-9, "{at} is not {time}");
    }
}

#[test]
fn no_value_under_any_law_is_beyond_the_extremes() {
    let initial = OscillatorState { displacement: 0.37, velocity: -0.83 };
    let output = TransientOutput { displacement: 0.6, velocity: 0.8 };
    for law in [
        LoadLaw::Sine { amplitude: 1.6, frequency: 2.1 },
        LoadLaw::Decay { amplitude: 1.4, rate: 0.6 },
        LoadLaw::Rise { size: 1.7, rate: 0.6 },
        LoadLaw::Versine { size: 1.9, frequency: 2.1 },
        LoadLaw::Parabola { start: 0.6, slope: -0.3, bend: 0.21 },
    ] {
        let oscillator = Oscillator { natural: 1.3, ratio: 0.05 };
        let motion = TransientMotion::new(oscillator, initial, &[LoadSegment { from: 0.0, law }]).unwrap();
        let found = motion.extremes(output, [0.0, 9.0]).unwrap();
        for n in 0..=4000 {
            let value = motion.output(output, 9.0 * f64::from(n) / 4000.0);
            assert!(value <= found.largest.value + 1e-12, "{law:?}: {value} is above {:?}", found.largest);
            assert!(value >= found.least.value - 1e-12, "{law:?}: {value} is below {:?}", found.least);
        }
        for extreme in [found.least, found.largest] {
            close(motion.output(output, extreme.time), extreme.value, 1.0);
        }
    }
}
