use std::f64::consts::PI;

use dalembert_mechanics::sdof;
use dalembert_mechanics::vibration::{
    decay_fit,
    forced_coulomb::{CoulombOscillator, CoulombResponse},
    free::FreeMotion,
    friction::FrictionDecay,
    jenkins::JenkinsOscillator,
};
use proptest::prelude::*;

use crate::close::{ROUNDING, close, printed};

/// Displacements and velocities compared with a share of their size at the start.
fn near(got: f64, want: f64, size: f64, share: f64) {
    assert!((got - want).abs() <= share * size, "{got} is not {want}, to {share:e} of {size}");
}

#[test]
fn release_with_four_dampings() {
    // Thomson, Vibration Theory and Applications, ex. 2.2-1: displacement after 0.09 s of a release from 1 in.
    let natural_frequency = (30.0f64 / 0.025_906_73).sqrt();
    for (damping_ratio, want, digits) in [(2.0, 0.4742, 4), (1.0, 0.18998, 5)] {
        let motion = FreeMotion { natural_frequency, damping_ratio, displacement: 1.0, velocity: 0.0 };
        printed(motion.state(0.09)[0], want, digits);
    }
}

#[test]
fn critically_damped_blow() {
    // x = v₀ t e^(−ωt): largest v₀/(eω) at 1/ω; no passage through rest.
    let motion = FreeMotion { natural_frequency: 10.0, damping_ratio: 1.0, displacement: 0.0, velocity: 1.0 };
    close(motion.first_turning().unwrap(), 0.1, ROUNDING);
    close(motion.state(0.1)[0], 0.1 / 1f64.exp(), ROUNDING);
    assert_eq!(motion.first_zero(), None);
}

proptest! {
    /// The motion does not know where ζ = 1 is.
    #[test]
    fn the_motion_is_smooth_through_critical_damping(
        w in 0.1..100.0f64, x0 in -1.0..1.0f64, v in -1.0..1.0f64, y in 0.0..12.0f64, e in 9.0..15.0f64,
    ) {
        let at = |damping_ratio: f64| {
            FreeMotion { natural_frequency: w, damping_ratio, displacement: x0, velocity: v * w }.state(y / w)
        };
        let step = 10f64.powf(-e);
        let size = x0.abs() + v.abs();
        let [below, here, above] = [1.0 - step, 1.0, 1.0 + step].map(at);
        for (order, scale) in [(0, size), (1, size * w), (2, size * w * w)] {
            near(below[order], here[order], scale, 1e-8);
            near(above[order], here[order], scale, 1e-8);
        }
    }

    /// The one formula against the equation of motion, series by series, at any damping.
    #[test]
    fn the_motion_solves_its_equation(
        w in 0.1..100.0f64, z in -0.3..6.0f64, x0 in -1.0..1.0f64, v in -1.0..1.0f64, y in 0.0..8.0f64,
    ) {
        let motion = FreeMotion { natural_frequency: w, damping_ratio: z, displacement: x0, velocity: v * w };
        let [x, speed] = motion.integrated(y / w).unwrap();
        let [got, got_speed, _] = motion.state(y / w);
        let size = (x0.abs() + v.abs()) * (-z * y).exp().max(1.0);
        near(got, x, size, 1e-11);
        near(got_speed, speed, size * w * (1.0 + z.abs()), 1e-11);
    }

    /// Zeros and turning points are the first, and are what they are called.
    #[test]
    fn first_zero_and_first_turning(z in 0.0..3.0f64, x0 in -1.0..1.0f64, v in -2.0..2.0f64) {
        let motion = FreeMotion { natural_frequency: 1.0, damping_ratio: z, displacement: x0, velocity: v };
        for (order, time) in [(0, motion.first_zero()), (1, motion.first_turning())] {
            let last = time.unwrap_or(30.0).min(30.0);
            let mut sign = 0.0f64;
            for n in 1..400 {
                let value = motion.state(last * f64::from(n) / 400.0)[order];
                if value.abs() > 1e-9 {
                    prop_assert!(sign == 0.0 || sign == value.signum(), "there is an earlier one");
                    sign = value.signum();
                }
            }
            if let Some(time) = time {
                near(motion.state(time)[order], 0.0, x0.abs() + v.abs(), 1e-9);
            }
        }
    }

    #[test]
    fn it_has_settled_and_not_before(z in 0.01..3.0f64, x0 in 0.1..1.0f64, v in -2.0..2.0f64, p in 0.001..0.5f64) {
        let motion = FreeMotion { natural_frequency: 1.0, damping_ratio: z, displacement: x0, velocity: v };
        let level = p * x0;
        let settled = motion.settling_time(level).unwrap();
        if settled > 0.0 {
            near(motion.state(settled)[0].abs(), level, level, 1e-8);
        }
        for n in 1..2000 {
            prop_assert!(motion.state(settled + 0.02 * f64::from(n))[0].abs() <= level * (1.0 + 1e-8));
        }
    }

    #[test]
    fn decrement_there_and_back(z in 1e-6..0.999f64) {
        close(sdof::damping_ratio_from_decrement(sdof::decrement_from_damping_ratio(z)), z, 1e-12);
    }

    /// With friction: marching through the equation of motion meets the strokes; the energy is friction's work.
    #[test]
    fn friction_stroke_by_stroke(
        x0 in -20.0..20.0f64, v in -20.0..20.0f64, z in 0.0..1.5f64, extra in 1.0..1.5f64, y in 0.0..30.0f64,
    ) {
        let motion = FreeMotion { natural_frequency: 3.0, damping_ratio: z, displacement: x0, velocity: 3.0 * v };
        let decay = FrictionDecay { motion, offset: 1.0, hold: extra };
        // A turning point on the very edge of rest may fall on either side of it.
        let rest = decay.rest();
        prop_assume!((rest.position.abs() - extra).abs() > 1e-6);
        let [x, speed] = decay.step_by_step(y / 3.0).unwrap();
        let [got, got_speed] = decay.state(y / 3.0);
        near(got, x, 40.0, 1e-8);
        near(got_speed, speed, 120.0, 1e-8);
        prop_assert!(rest.position.abs() <= extra * (1.0 + 1e-9));
        if z == 0.0 {
            prop_assert!(rest.time.is_some());
        }
    }

    #[test]
    fn friction_takes_the_energy(x0 in 1.5..40.0f64) {
        let motion = FreeMotion { natural_frequency: 2.0, damping_ratio: 0.0, displacement: x0, velocity: 0.0 };
        let decay = FrictionDecay { motion, offset: 1.0, hold: 1.0 };
        let rest = decay.rest();
        let mut way = 0.0;
        let mut stroke = 0.0;
        while stroke < rest.strokes {
            way += (decay.turning(x0, stroke + 1.0) - decay.turning(x0, stroke)).abs();
            stroke += 1.0;
        }
        // ½kx₀² = ½kx² + F·way, over k.
        near(x0 * x0 / 2.0, rest.position.powi(2) / 2.0 + way, x0 * x0, 1e-12);
    }

    /// Den Hartog's motion: the force works what friction takes, and with little friction nothing is left of it.
    #[test]
    fn forced_friction_closes_its_energy(r in 0.05..3.0f64, share in 0.01..0.9999f64) {
        let excited = CoulombOscillator { ratio: r, deflection: 1.0, offset: share };
        match excited.steady() {
            CoulombResponse::Sliding { amplitude, .. } => {
                near(excited.sliding_work(), 4.0 * share * amplitude, amplitude, 1e-9);
                near(excited.sliding_at(0.0), amplitude, amplitude, 1e-9);
                near(excited.sliding_at(1.0), -amplitude, amplitude, 1e-9);
            }
            CoulombResponse::Stopping { amplitude, slides } => {
                let work: f64 = slides.iter().map(|slide| excited.work(slide)).sum();
                let way: f64 = slides.iter().map(|slide| (slide.end - slide.start).abs()).sum();
                // Each turning point is steady to 1e-12 of the static deflection.
                near(work, share * way, way + 1e-3, 1e-8);
                prop_assert!(way > 0.0 && slides.len() >= 2, "{slides:?}");
                prop_assert!(way >= 4.0 * (amplitude * (1.0 - 1e-9) - 1e-12));
            }
            other => prop_assert_eq!(other, CoulombResponse::Unbounded),
        }
    }

    /// The fit of both finds what made the turning points.
    #[test]
    fn the_fit_of_a_decay_finds_its_damping(z in 0.002..0.1f64, f in 0.001..0.02f64) {
        let motion = FreeMotion { natural_frequency: 1.0, damping_ratio: z, displacement: 1.0, velocity: 0.0 };
        let decay = FrictionDecay { motion, offset: f, hold: f };
        let strokes = decay.rest().strokes.min(24.0) as u32;
        let points: Vec<(f64, f64)> = (0..strokes)
            .map(|n| (f64::from(n) / 2.0, decay.turning(1.0, f64::from(n)).abs()))
            .collect();
        prop_assume!(points.len() > 6);
        let fits = decay_fit::fit(&points).unwrap();
        close(sdof::damping_ratio_from_decrement(fits.both.decrement), z, 1e-6);
        close(fits.both.loss / fits.both.decrement * (fits.both.decrement / 4.0).tanh(), f, 1e-6);
        prop_assert!(fits.both.scatter <= fits.viscous.scatter && fits.both.scatter <= fits.friction.scatter);
    }

    /// The first harmonic of the element in closed form and by summation.
    #[test]
    fn the_element_by_summation(amplitude in 1.01..50.0f64) {
        let oscillator = JenkinsOscillator {
            mass: 1.0, damping: 0.0, stiffness: 0.0, element: 2.0, slip_force: 2.0, force: 1.0,
        };
        let [k, h] = oscillator.harmonic(amplitude);
        let [sum_k, sum_h] = oscillator.harmonic_by_summation(amplitude);
        close(sum_k, k, 1e-8);
        close(sum_h, h, 1e-8);
    }
}

/// Close to the largest friction, too, a mass at rest leaves when the pull is the friction, and comes to rest opposite.
#[test]
fn a_mass_leaves_its_rest_when_the_pull_is_the_friction() {
    for (ratio, offset) in [(0.3, 0.97), (0.6, 0.9), (0.6, 0.995), (1.7, 0.97), (2.3, 0.99), (0.13, 0.995)] {
        let excited = CoulombOscillator { ratio, deflection: 1.0, offset };
        let CoulombResponse::Stopping { amplitude, slides } = excited.steady() else {
            panic!("{ratio}, {offset}: no stops")
        };
        assert_eq!(slides.len(), 2);
        for slide in slides {
            near((ratio * slide.from).cos() - slide.start, slide.direction * offset, 1.0, 1e-9);
            let [position, velocity] = excited.sliding_from(&slide, slide.until);
            near(velocity, 0.0, 1.0, 1e-9);
            near(position, slide.end, 1.0, 1e-9);
            near(slide.start, -slide.direction * amplitude, 1.0, 1e-9);
            near(slide.end, slide.direction * amplitude, 1.0, 1e-9);
            assert!(slide.until > slide.from);
        }
    }
}

#[test]
fn the_peak_of_an_oscillator_with_a_friction_element() {
    // Guillen and Pierre (1999) read off their curve: 209 rad/s, 15 µm.
    let oscillator = JenkinsOscillator {
        mass: 944.6,
        damping: 7700.0,
        stiffness: 24e6,
        element: 24e6,
        slip_force: 246.048,
        force: 123.024,
    };
    let peak = oscillator.peak().unwrap();
    printed(peak.amplitude * 1e6, 15.0, 1);
    printed(peak.frequency, 209.2, 1);
    // At its own frequency the response has the amplitude of the peak.
    close(*oscillator.amplitudes(peak.frequency).last().unwrap(), peak.amplitude, 1e-6);
    // Nowhere is it higher.
    for n in 1..300u32 {
        let amplitudes = oscillator.amplitudes(f64::from(n));
        assert!(amplitudes.iter().all(|amplitude| *amplitude <= peak.amplitude * (1.0 + 1e-9)));
    }
}

#[test]
fn strokes_of_a_block() {
    // Tse, Morse and Hinkle: f = 1/16 of the first amplitude; half a cycle takes an eighth, and after 8 it rests.
    let motion =
        FreeMotion { natural_frequency: 34.029, damping_ratio: 0.0, displacement: -1.0, velocity: 0.0 };
    let decay = FrictionDecay { motion, offset: 0.0625, hold: 0.0625 };
    let rest = decay.rest();
    assert_eq!(rest.strokes, 8.0);
    close(rest.time.unwrap(), 8.0 * PI / 34.029, ROUNDING);
    assert!(rest.position.abs() < 1e-12);
}
