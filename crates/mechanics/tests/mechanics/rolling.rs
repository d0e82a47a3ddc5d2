//! Discs, hoops and cones that roll: steady motions that stay, published limits, energy, and small oscillations.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use dalembert_mechanics::rigid::rolling::{
    Ended, Limits, Rolling, RollingError, cone_angular_velocity, cone_energy, least_rolling_speed,
    least_upright_spin, roll, steady_centre_radius, steady_precession_squared,
};

const GRAVITY: f64 = 9.81;
const ROUGH: Limits = Limits { flat: 0.01, friction: None };

fn disc(radius: f64) -> Rolling {
    let square = radius * radius;
    Rolling { mass: 1.0, radius, axial: 0.5 * square, transverse: 0.25 * square, gravity: GRAVITY }
}

fn hoop(radius: f64) -> Rolling {
    let square = radius * radius;
    Rolling { mass: 1.0, radius, axial: square, transverse: 0.5 * square, gravity: GRAVITY }
}

/// The angular velocity in the axes 123 of a steady motion.
fn steady(disc: &Rolling, angle: f64, circle: f64) -> (f64, [f64; 3]) {
    let moments = [disc.axial, disc.transverse];
    let squared = steady_precession_squared(disc.mass, disc.radius, moments, disc.gravity, angle, circle);
    let precession = squared.sqrt();
    (precession, [0.0, precession * angle.sin(), -precession * circle / disc.radius])
}

#[test]
fn a_steady_motion_stays_and_closes_its_circle() {
    for (body, degrees, circle) in [(disc(0.3), 70.0, 2.0), (hoop(0.25), 62.0, 0.9), (disc(0.1), 45.0, 0.05)]
    {
        let angle = f64::to_radians(degrees);
        let (precession, omega) = steady(&body, angle, circle);
        let rolled = roll(&body, [angle, 0.3], omega, &ROUGH, (TAU / precession, 9), &|| false).unwrap();
        assert_eq!(rolled.ended, Ended::Time);
        for moment in &rolled.moments {
            assert!((moment.inclination - angle).abs() < 1e-10, "{degrees}°: {}", moment.inclination);
            assert!((moment.normal - GRAVITY).abs() < 1e-9);
            let [along, across] = moment.friction;
            assert!(along.abs() < 1e-9 && (across - circle * precession * precession).abs() < 1e-9);
        }
        let end = rolled.moments.last().unwrap();
        assert!(end.contact[0].hypot(end.contact[1]) < 1e-9 * circle.max(1.0));
        // Half-way the contact is across the circle on the floor.
        let across = rolled.moments[4].contact;
        let floor = circle + body.radius * angle.cos();
        assert!((across[0].hypot(across[1]) - 2.0 * floor).abs() < 1e-9);
        // The inverse questions.
        let moments = [body.axial, body.transverse];
        let found = steady_centre_radius(1.0, body.radius, moments, GRAVITY, angle, precession);
        assert!((found - circle).abs() < 1e-12);
        let angles = body.steady_inclinations(circle, precession);
        assert!(angles.iter().any(|found| (found - angle).abs() < 1e-12), "{angles:?}");
    }
}

/// A thin hoop on a circle much larger than itself leans like `tan λ = 2 v²/(g a)`.
#[test]
fn a_hoop_on_a_large_circle() {
    let (lean, circle) = (0.2_f64, 1e7);
    let (precession, _) = steady(&hoop(0.3), FRAC_PI_2 - lean, circle);
    let speed = precession * circle;
    assert!((lean.tan() / (2.0 * speed * speed / (GRAVITY * circle)) - 1.0).abs() < 1e-8);
}

#[test]
fn upright_discs_stay_upright_above_their_limits_alone() {
    let radius = 0.3;
    for (body, rolls, spins) in [
        (disc(radius), (GRAVITY * radius / 3.0).sqrt(), (GRAVITY / (1.25 * radius)).sqrt()),
        (hoop(radius), (GRAVITY * radius / 4.0).sqrt(), (GRAVITY / (1.5 * radius)).sqrt()),
    ] {
        let moments = [body.axial, body.transverse];
        assert!((least_rolling_speed(1.0, radius, moments, GRAVITY) - rolls).abs() < 1e-12);
        assert!((least_upright_spin(1.0, radius, body.transverse, GRAVITY) - spins).abs() < 1e-12);
        for (factor, stays) in [(0.9, false), (1.1, true)] {
            for omega in [[0.0, 0.0, -factor * rolls / radius], [0.0, factor * spins, 0.0]] {
                assert_eq!(body.tilting_stiffness(FRAC_PI_2, [omega[1], omega[2]]) > 0.0, stays);
                let from = [FRAC_PI_2 + 1e-4, 0.0];
                let rolled = roll(&body, from, omega, &ROUGH, (6.0, 61), &|| false).unwrap();
                let most =
                    rolled.moments.iter().map(|m| (m.inclination - FRAC_PI_2).abs()).fold(0.0, f64::max);
                assert_eq!(most < 1e-2, stays, "{factor} {omega:?}: {most}");
            }
        }
    }
}

/// A small push makes the angle of a steady motion swing with `√K`.
#[test]
fn small_oscillations_have_the_period_of_their_stiffness() {
    let body = disc(0.3);
    let angle = f64::to_radians(70.0);
    let (_, [_, second, third]) = steady(&body, angle, 2.0);
    let rate = body.tilting_stiffness(angle, [second, third]).sqrt();
    // After a whole number of half swings the angle is back, with the velocity turned each time.
    let push = 1e-5;
    let rolled = roll(&body, [angle, 0.0], [push, second, third], &ROUGH, (4.5 * TAU / rate, 10), &|| false);
    for (n, moment) in rolled.unwrap().moments.iter().enumerate() {
        let sign = if n % 2 == 0 { 1.0 } else { -1.0 };
        assert!((moment.omega[0] - sign * push).abs() < 1e-3 * push, "{n}: {}", moment.omega[0]);
        assert!((moment.inclination - angle).abs() < 1e-3 * push / rate);
    }
}

/// Any motion keeps its energy, and its mirror image is the motion of the mirrored start.
#[test]
fn energy_is_kept_and_motions_have_their_mirror_images() {
    let body = disc(0.01);
    let start = [f64::to_radians(89.0), 0.0];
    let spin = 10.0 * PI;
    let omega = [0.0, spin * start[0].sin(), spin * start[0].cos()];
    let rolled = roll(&body, start, omega, &ROUGH, (0.5, 51), &|| false).unwrap();
    assert!(rolled.energy_drift() < 1e-12, "{}", rolled.energy_drift());
    let end = rolled.moments.last().unwrap();
    assert!((end.contact[0] - -0.0025969231036030).abs() < 1e-13, "{}", end.contact[0]);
    assert!((end.contact[1] - 0.0020049470207618).abs() < 1e-13, "{}", end.contact[1]);
    let mirrored = roll(&body, start, omega.map(|x| -x), &ROUGH, (0.5, 51), &|| false).unwrap();
    let other = mirrored.moments.last().unwrap();
    assert!((other.contact[0] + end.contact[0]).abs() < 1e-14);
    assert!((other.contact[1] - end.contact[1]).abs() < 1e-14);
}

/// A disc released on its edge falls about the tangent at the contact; it leaves the floor where
/// `0.2 + 2.4 sin² θ = 1.6 sin θ₀ sin θ`, and slips before that on a floor that is not rough enough.
#[test]
fn a_falling_disc_lifts_off_or_slips() {
    let body = disc(0.1);
    let start = f64::to_radians(80.0);
    let rolled = roll(&body, [start, 0.0], [0.0; 3], &ROUGH, (2.0, 21), &|| false).unwrap();
    assert_eq!(rolled.ended, Ended::Lifts);
    let s = start.sin();
    let lifts = (1.6 * s + (2.56 * s * s - 1.92).sqrt()) / 4.8;
    let end = rolled.moments.last().unwrap();
    assert!((end.inclination.sin() - lifts).abs() < 1e-11);
    assert!((end.omega[0].powi(2) - 1.6 * GRAVITY / 0.1 * (s - lifts)).abs() < 1e-8);
    let smooth = Limits { friction: Some(0.2), ..ROUGH };
    let rolled = roll(&body, [start, 0.0], [0.0; 3], &smooth, (2.0, 21), &|| false).unwrap();
    assert_eq!(rolled.ended, Ended::Slips);
    let end = rolled.moments.last().unwrap();
    assert!((end.friction[1].abs() / end.normal - 0.2).abs() < 1e-9);
}

/// At rest it needs `|F|/N = 0.8 sin θ cos θ/(1 − 0.8 cos² θ)`; tilting fast enough it does not press at all.
#[test]
fn a_disc_that_cannot_roll_slips_or_lifts_off_at_once() {
    let (body, angle) = (disc(0.1), f64::to_radians(80.0));
    let (sin, cos) = angle.sin_cos();
    let pressed = 1.0 - 0.8 * cos * cos;
    let needed = 0.8 * sin * cos / pressed;
    let with = |tilting: f64, limits: &Limits| {
        roll(&body, [angle, 0.0], [tilting, 0.0, 0.0], limits, (2.0, 21), &|| false).unwrap()
    };
    let at_rest = |part: f64| with(0.0, &Limits { friction: Some(part * needed), ..ROUGH });
    let smooth = at_rest(1.0 - 1e-9);
    assert_eq!((smooth.ended, smooth.moments.len()), (Ended::Slips, 1));
    assert!((smooth.moments[0].demand() - needed).abs() < 1e-12);
    let rougher = at_rest(1.01);
    assert_eq!(rougher.ended, Ended::Slips);
    assert!(rougher.moments.last().unwrap().time > 0.0);
    let lifting = (GRAVITY * pressed / (0.1 * sin)).sqrt();
    let fast = with(-lifting * (1.0 + 1e-9), &ROUGH);
    assert_eq!((fast.ended, fast.moments.len(), fast.demand), (Ended::Lifts, 1, None));
    assert!(with(-lifting * (1.0 - 1e-3), &ROUGH).moments.len() > 1);
}

/// Euler's disc: with its centre at rest `φ̇² = 4 g/(r sin θ)`.
#[test]
fn a_disc_about_its_centre_at_rest_has_one_inclination() {
    let radius = 0.07;
    for degrees in [8.0, 31.0, 74.0] {
        let angle = f64::to_radians(degrees);
        let precession = (4.0 * GRAVITY / (radius * angle.sin())).sqrt();
        let angles = disc(radius).steady_inclinations(0.0, precession);
        assert_eq!(angles.len(), 1, "{angles:?}");
        assert!((angles[0] - angle).abs() < 1e-12, "{} is not {angle}", angles[0]);
    }
}

#[test]
fn what_cannot_roll_is_refused() {
    let body = disc(0.1);
    let refused = |body: &Rolling, angle: f64, duration: f64| {
        roll(body, [angle, 0.0], [0.0; 3], &ROUGH, (duration, 3), &|| false).unwrap_err()
    };
    assert_eq!(refused(&body, 0.001, 1.0), RollingError::Input);
    assert_eq!(refused(&body, 1.0, f64::NAN), RollingError::Input);
    assert_eq!(refused(&Rolling { axial: 0.0, ..body }, 1.0, 1.0), RollingError::Input);
}

/// L. D. Landau, E. M. Lifshitz, Mechanics, §32, problem 7, against the energy from the moments through the apex.
#[test]
fn the_energy_of_a_rolling_cone() {
    let (mass, height, angle, precession) = (3.0, 0.4, f64::to_radians(25.0), 2.2);
    let radius = height * f64::tan(angle);
    let axial = 0.3 * mass * radius * radius;
    let transverse = 0.6 * mass * (radius * radius / 4.0 + height * height);
    let omega = cone_angular_velocity(precession, angle);
    let energy = 0.5 * (axial * (omega * angle.cos()).powi(2) + transverse * (omega * angle.sin()).powi(2));
    assert!((cone_energy(mass, height, precession, angle) - energy).abs() < 1e-14);
    assert!((energy - 0.8898382827794568).abs() < 1e-13);
}
