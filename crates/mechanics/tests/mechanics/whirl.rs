use std::f64::consts::TAU;

use dalembert_mechanics::whirl::{
    self, LimitedBy, WhirlError, permitted_speeds, permitted_stiffness, permitted_stiffness_at_damping,
    worst_speed,
};
use dalembert_mechanics::{beam, sdof, section};
use dalembert_numerics::intervals::IntervalSet;
use proptest::prelude::*;

use crate::close::{ROUNDING, close, found, printed};

const MASS: f64 = 250.0;
const UNBALANCE: f64 = 5e-3;
const CLEARANCE: f64 = 5e-3;

fn rpm(speed: f64) -> f64 {
    speed * TAU / 60.0
}

/// Diameter in mm of the solid steel shaft of list 08 with a stiffness: `k = 3EI/L³`, L = 2 m, E = 207 GPa.
fn shaft(stiffness: f64) -> f64 {
    let second_moment = stiffness / beam::cantilever(207e9, 1.0, 2.0);
    section::round_diameter(second_moment) * 1e3
}

#[test]
fn turbine_of_list_08_without_damping() {
    for (speeds, thin, thick) in
        [([rpm(480.0), rpm(7200.0)], 113.4, 439.9), ([rpm(600.0), rpm(6000.0)], 126.74, 401.6)]
    {
        let permitted = found(permitted_stiffness(MASS, UNBALANCE, CLEARANCE, speeds, 0.0));
        let (soft, stiff) = (permitted.soft.unwrap(), permitted.stiff.unwrap());
        let decimals = if thin == 126.74 { 2 } else { 1 };
        printed(shaft(soft.stiffness), thin, decimals);
        printed(shaft(stiff.stiffness), thick, 1);
        assert_eq!((soft.by, stiff.by), (LimitedBy::LowestSpeed, LimitedBy::HighestSpeed));
        assert_eq!([soft.speed, stiff.speed], speeds);
        let [lowest, highest] = speeds;
        close(soft.stiffness, whirl::soft_limit_undamped(MASS, UNBALANCE, CLEARANCE, lowest), ROUNDING);
        close(stiff.stiffness, whirl::stiff_limit_undamped(MASS, UNBALANCE, CLEARANCE, highest), ROUNDING);
        let diameters = permitted.set.map_ascending(shaft);
        assert!(diameters.contains(100.0) && !diameters.contains(300.0) && diameters.contains(450.0));
        assert_eq!(diameters.intervals().len(), 2);
        let same = found(permitted_stiffness_at_damping(MASS, UNBALANCE, CLEARANCE, speeds, 0.0));
        close(same.soft.unwrap().stiffness, soft.stiffness, ROUNDING);
        close(same.stiff.unwrap().stiffness, stiff.stiffness, ROUNDING);
    }
}

#[test]
fn turbine_of_list_08_with_thirty_per_cent_damping() {
    let speeds = [rpm(480.0), rpm(7200.0)];
    let permitted = found(permitted_stiffness(MASS, UNBALANCE, CLEARANCE, speeds, 0.30));
    assert_eq!((permitted.soft, permitted.stiff), (None, None));
    assert!(permitted.set.contains(0.0) && permitted.set.contains(1e300));
    assert_eq!(permitted.set.intervals().len(), 1);
    printed(UNBALANCE / MASS * sdof::peak_magnification(0.30) * 1e3, 0.0349, 4);
}

#[test]
fn printed_answer_of_list_08_took_the_ratio_for_a_coefficient() {
    let speeds = [rpm(7200.0); 2];
    let permitted = found(permitted_stiffness_at_damping(MASS, UNBALANCE, CLEARANCE, speeds, 0.3));
    let stiff = permitted.stiff.unwrap().stiffness;
    printed(shaft(stiff) * 1e-3, 0.44, 2);
    // To the first order the coefficient does nothing.
    close(stiff, whirl::stiff_limit_undamped(MASS, UNBALANCE, CLEARANCE, speeds[1]), 1e-6);
}

#[test]
fn the_limit_stops_being_active_where_the_peak_touches_the_clearance() {
    // e/(2ζ√(1 − ζ²)) = R at ζ = 0.02 for this clearance.
    let clearance = UNBALANCE / MASS * sdof::peak_magnification(0.02);
    let limited = |zeta: f64| found(permitted_stiffness(MASS, UNBALANCE, clearance, [10.0, 20.0], zeta));
    assert!(limited(0.02 * (1.0 - 1e-9)).stiff.is_some());
    assert!(limited(0.02 * (1.0 + 1e-9)).stiff.is_none());
    // Just before, the gap is that of the peak crossing the range: √(1 − 2ζ²) times the speeds.
    let edge = limited(0.02 * (1.0 - 1e-12));
    let ratio = 1.0 - 2.0 * 0.02 * 0.02;
    close(edge.soft.unwrap().stiffness, MASS * 100.0 * ratio, 1e-5);
    close(edge.stiff.unwrap().stiffness, MASS * 400.0 * ratio, 1e-5);
}

#[test]
fn eccentricity_larger_than_the_clearance_forbids_every_soft_shaft() {
    let clearance = 0.5 * UNBALANCE / MASS;
    for zeta in [0.0, 0.3, 0.9, 1.0, 3.0] {
        let permitted = found(permitted_stiffness(MASS, UNBALANCE, clearance, [50.0, 90.0], zeta));
        assert_eq!(permitted.soft, None);
        assert!(!permitted.set.contains(0.0));
        let stiff = permitted.stiff.unwrap();
        close(stiff.stiffness, whirl::stiff_limit(MASS, UNBALANCE, clearance, 90.0, zeta), 1e-10);
    }
    // Equal to it: only no stiffness at all, where the rotor turns about its centre of mass.
    let permitted = found(permitted_stiffness(2.0, 2e-3, 1e-3, [50.0, 90.0], 0.0));
    assert!(permitted.set.contains(0.0) && !permitted.set.contains(1e-9));
    let permitted = found(permitted_stiffness_at_damping(2.0, 2e-3, 1e-3, [50.0, 90.0], 0.0));
    assert!(permitted.set.contains(0.0) && !permitted.set.contains(1e-9));
    // Without a peak the amplitude only tends to the eccentricity, so nothing is forbidden.
    let permitted = found(permitted_stiffness(2.0, 2e-3, 1e-3, [50.0, 90.0], 0.9));
    assert_eq!(permitted.stiff, None);
}

#[test]
fn from_rest_no_shaft_is_soft_enough() {
    let permitted = found(permitted_stiffness(MASS, UNBALANCE, CLEARANCE, [0.0, 100.0], 0.0));
    assert!(permitted.set.contains(0.0) && !permitted.set.contains(1.0));
    let standing = found(permitted_stiffness(MASS, UNBALANCE, CLEARANCE, [0.0, 0.0], 0.0));
    assert_eq!(standing.stiff, None);
    let balanced = found(permitted_stiffness(MASS, 0.0, CLEARANCE, [0.0, 100.0], 0.0));
    assert_eq!(balanced.stiff, None);
}

#[test]
fn a_peak_within_the_range_can_limit_a_fixed_coefficient() {
    let (mass, unbalance, clearance, damping) = (2.0, 2e-3, 4e-3, 20.0);
    let permitted = found(permitted_stiffness_at_damping(mass, unbalance, clearance, [10.0, 300.0], damping));
    let soft = permitted.soft.unwrap();
    assert_eq!(soft.by, LimitedBy::Peak);
    // There the peak amplitude of that very rotor is the clearance.
    let zeta = sdof::damping_ratio(damping, soft.stiffness, mass);
    close(unbalance / mass * sdof::peak_magnification(zeta), clearance, ROUNDING);
    let at = sdof::natural_frequency(soft.stiffness, mass) * sdof::unbalance_peak_ratio(zeta);
    close(soft.speed, at, ROUNDING);
}

#[test]
fn whirl_amplitude_is_that_of_an_unbalance() {
    let (k, c, w) = (3e4, 70.0, 88.0);
    let (r, zeta) = (w / sdof::natural_frequency(k, 2.0), sdof::damping_ratio(c, k, 2.0));
    let amplitude = whirl::whirl_amplitude(1e-4, r, zeta);
    close(amplitude, sdof::unbalance_amplitude(2e-4, k, 2.0, c, w), ROUNDING);
    // At the critical speed e/(2ζ), far above it e.
    close(whirl::whirl_amplitude(1e-4, 1.0, 0.05), 1e-3, ROUNDING);
    close(whirl::whirl_amplitude(1e-4, 1e6, 0.05), 1e-4, 1e-10);
}

#[test]
fn data_out_of_place_are_named() {
    let call = |mass, unbalance, clearance, speeds, zeta| {
        let ratio = permitted_stiffness(mass, unbalance, clearance, speeds, zeta).unwrap_err();
        let coefficient =
            permitted_stiffness_at_damping(mass, unbalance, clearance, speeds, zeta).unwrap_err();
        assert_eq!(format!("{ratio:?}"), format!("{coefficient:?}"));
        ratio
    };
    assert_eq!(call(0.0, 1.0, 1.0, [1.0, 2.0], 0.1), WhirlError::Mass(0.0));
    assert_eq!(call(1.0, -1.0, 1.0, [1.0, 2.0], 0.1), WhirlError::Unbalance(-1.0));
    assert_eq!(call(1.0, 1.0, 0.0, [1.0, 2.0], 0.1), WhirlError::Clearance(0.0));
    assert_eq!(call(1.0, 1.0, 1.0, [1.0, 2.0], -0.1), WhirlError::Damping(-0.1));
    let crossed = WhirlError::Speeds { lowest: 2.0, highest: 1.0 };
    assert_eq!(call(1.0, 1.0, 1.0, [2.0, 1.0], 0.1), crossed);
    assert!(matches!(call(1.0, 1.0, 1.0, [1.0, f64::NAN], 0.1), WhirlError::Speeds { .. }));
    assert_eq!(call(1.0, 1.0, 1.0, [1.0, 1e200], 0.1), WhirlError::OutOfRange);
    assert_eq!(worst_speed(-1.0, 1.0, 0.0, [0.0, 1.0]), Err(WhirlError::Stiffness(-1.0)));
}

#[derive(Debug, Clone, Copy)]
struct Rotor {
    mass: f64,
    unbalance: f64,
    clearance: f64,
    speeds: [f64; 2],
}

fn rotors() -> impl Strategy<Value = Rotor> {
    // Eccentricities from a thousandth of the clearance to twice the clearance.
    (0.1..500.0, 1e-5..1e-2, -3.0..0.3, 0.0..600.0, 0.0..600.0).prop_map(
        |(mass, clearance, decades, lowest, width)| {
            let eccentricity = clearance * 10f64.powf(decades);
            Rotor { mass, clearance, unbalance: mass * eccentricity, speeds: [lowest, lowest + width] }
        },
    )
}

/// Holds a permitted set to amplitudes found by scanning stiffness and speed.
fn scanned(
    rotor: Rotor,
    damping: impl Fn(f64) -> f64,
    set: &IntervalSet,
    stiffnesses: impl IntoIterator<Item = f64>,
) -> Result<(), TestCaseError> {
    let Rotor { mass, unbalance, clearance, speeds: [lowest, highest] } = rotor;
    for k in stiffnesses {
        let c = damping(k);
        let amplitude = |w: f64| sdof::unbalance_amplitude(unbalance, k, mass, c, w);
        let (worst, _) = found(worst_speed(k, mass, c, [lowest, highest]));
        let largest = (0..=500)
            .map(|i| lowest + (highest - lowest) * f64::from(i) / 500.0)
            .map(amplitude)
            .fold(0.0, f64::max);
        let at_worst = amplitude(worst);
        prop_assert!(largest <= at_worst * (1.0 + 1e-9), "the scan finds {largest} above {at_worst}");
        if set.contains(k) {
            prop_assert!(at_worst <= clearance * (1.0 + 1e-7), "k = {k} is not clear: {at_worst}");
        } else {
            prop_assert!(at_worst >= clearance * (1.0 - 1e-7), "k = {k} is clear: {at_worst}");
        }
    }
    Ok(())
}

proptest! {
    #[test]
    fn permitted_set_by_scanning_with_a_ratio(
        rotor in rotors(), zeta in prop_oneof![Just(0.0), 0.0..0.2, 0.0..1.5], parts in prop::collection::vec(0.0..2.0f64, 20),
    ) {
        let Rotor { mass, unbalance, clearance, speeds } = rotor;
        let permitted = found(permitted_stiffness(mass, unbalance, clearance, speeds, zeta));
        let largest = mass * speeds[1].powi(2) * 3.0;
        let near = [permitted.soft, permitted.stiff]
            .into_iter()
            .flatten()
            .flat_map(|limit| [0.999, 1.001].map(|factor| factor * limit.stiffness));
        let stiffnesses = parts.iter().map(|part| part.powi(3) / 8.0 * largest + 1e-9).chain(near);
        scanned(rotor, |k| sdof::damping_from_ratio(zeta, k, mass), &permitted.set, stiffnesses)?;
        for limit in [permitted.soft, permitted.stiff].into_iter().flatten() {
            if limit.speed > 0.0 && limit.stiffness > 0.0 {
                let c = sdof::damping_from_ratio(zeta, limit.stiffness, mass);
                let amplitude = sdof::unbalance_amplitude(unbalance, limit.stiffness, mass, c, limit.speed);
                close(amplitude, clearance, 1e-6);
            }
        }
        if let Some(stiff) = permitted.stiff {
            let formula = whirl::stiff_limit(mass, unbalance, clearance, speeds[1], zeta);
            close(stiff.stiffness, formula, 1e-8);
        }
        if let Some(soft) = permitted.soft {
            let formula = whirl::soft_limit(mass, unbalance, clearance, speeds[0], zeta);
            prop_assert!((soft.stiffness - formula).abs() <= 1e-9 * mass * speeds[0].powi(2));
        }
    }

    #[test]
    fn permitted_set_by_scanning_with_a_coefficient(
        rotor in rotors(), strength in prop_oneof![Just(0.0), 0.0..1.2], parts in prop::collection::vec(0.0..2.0f64, 20),
    ) {
        let Rotor { mass, unbalance, clearance, speeds } = rotor;
        // Nothing is forbidden from the strength 1 on.
        let damping = strength * unbalance / clearance * speeds[1];
        let permitted =
            found(permitted_stiffness_at_damping(mass, unbalance, clearance, speeds, damping));
        prop_assert_eq!(permitted.stiff.is_none(), strength >= 1.0);
        let largest = mass * speeds[1].powi(2) * 3.0;
        let near = [permitted.soft, permitted.stiff]
            .into_iter()
            .flatten()
            .flat_map(|limit| [0.999, 1.001].map(|factor| factor * limit.stiffness));
        let stiffnesses = parts.iter().map(|part| part.powi(3) / 8.0 * largest + 1e-9).chain(near);
        scanned(rotor, |_| damping, &permitted.set, stiffnesses)?;
        for limit in [permitted.soft, permitted.stiff].into_iter().flatten() {
            if limit.speed > 0.0 && limit.stiffness > 0.0 {
                let amplitude =
                    sdof::unbalance_amplitude(unbalance, limit.stiffness, mass, damping, limit.speed);
                close(amplitude, clearance, 1e-6);
            }
        }
    }

    #[test]
    fn any_numbers_are_answered_or_refused(
        mass in any::<f64>(), unbalance in any::<f64>(), clearance in any::<f64>(),
        speeds in [any::<f64>(), any::<f64>()], damping in any::<f64>(),
    ) {
        let speeds = [speeds[0].abs().min(speeds[1].abs()), speeds[0].abs().max(speeds[1].abs())];
        let (mass, unbalance, clearance, damping) =
            (mass.abs(), unbalance.abs(), clearance.abs(), damping.abs());
        for permitted in [
            permitted_stiffness(mass, unbalance, clearance, speeds, damping),
            permitted_stiffness_at_damping(mass, unbalance, clearance, speeds, damping),
        ]
        .into_iter()
        .flatten()
        {
            for limit in [permitted.soft, permitted.stiff].into_iter().flatten() {
                prop_assert!(limit.stiffness.is_finite() && limit.speed.is_finite());
            }
        }
    }

    #[test]
    fn permitted_speeds_by_scanning(
        natural in 1.0..1e4f64, share in 0.01..1.6f64, zeta in prop_oneof![Just(0.0), 0.001..1.5f64],
        parts in prop::collection::vec(0.001..4.0f64, 20),
    ) {
        let permitted = found(permitted_speeds(natural, share, 1.0, zeta));
        let near = [permitted.below, permitted.above]
            .into_iter()
            .flatten()
            .flat_map(|speed| [0.999, 1.001].map(|factor| factor * speed));
        for speed in parts.iter().map(|part| part * natural).chain(near) {
            let amplitude = whirl::whirl_amplitude(share, speed / natural, zeta);
            if (amplitude - 1.0).abs() > 1e-9 {
                prop_assert_eq!(permitted.set.contains(speed), amplitude < 1.0, "{} {}", speed, amplitude);
            }
        }
        for speed in [permitted.below, permitted.above].into_iter().flatten() {
            close(whirl::whirl_amplitude(share, speed / natural, zeta), 1.0, 1e-6);
        }
        if let (Some(below), Some(above), true) = (permitted.below, permitted.above, zeta > 0.0) {
            close(whirl::speed_below(natural, share, zeta), below, 1e-9);
            close(whirl::speed_above(natural, share, zeta), above, 1e-6);
        }
        if let (Some(below), Some(above), true) = (permitted.below, permitted.above, zeta == 0.0) {
            close(whirl::speed_below_undamped(natural, share, 1.0), below, 1e-9);
            close(whirl::speed_above_undamped(natural, share, 1.0), above, 1e-6);
        }
    }

    #[test]
    fn eccentricity_and_whirl_are_inverses(e in 1e-6..1e-2f64, r in 0.05..20.0f64, zeta in 0.0..1.5f64) {
        prop_assume!((r - 1.0).abs() > 1e-3 || zeta > 1e-3);
        let amplitude = whirl::whirl_amplitude(e, r, zeta);
        close(whirl::eccentricity_from_amplitude(amplitude, r, zeta), e, 1e-10);
    }
}
