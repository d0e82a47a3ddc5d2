//! Energies and power of each part in one motion, beside those of the equivalent system.

use dalembert_core::Worksheet;
use dalembert_mechanics::Real;
use dalembert_numerics::quadrature;

use super::{
    AttachedDamper, AttachedSpring, EquivalentSystem, LeverBar, LeverPosition, RollingSurface, TurningBody,
    body::Terms,
};
use crate::shared::inertia::{BodyShape, Inertia, Mass, RollingShape, RotorInertia};

/// Kinetic energy at one radian per second, potential energy at one radian of a linear motion, power at one radian per
/// second.
pub(super) fn energies<W: Worksheet>(system: &EquivalentSystem, terms: &Terms<W::Num>, sheet: W) {
    let number = |x: f64| W::Num::from(x);
    sheet.check(
        "kinetic energy of all parts at the speeds of one motion: ½ J_eq θ′²",
        number(kinetic(&system.body)),
        terms.inertia / 2.0,
    );
    let springs: f64 = system.springs.iter().map(stored).sum();
    let lifted = lifted(&system.body);
    sheet.check_sum(
        "energy in the springs and of the lifted weights in one displacement: ½ K_eq θ²",
        number(springs + lifted),
        terms.stiffness / 2.0,
        springs + lifted.abs(),
    );
    if let Some(damping) = terms.damping {
        let power: f64 = system
            .dampers
            .iter()
            .map(|damper| match *damper {
                AttachedDamper::Linear { coefficient, arm } => coefficient * arm * arm,
                AttachedDamper::Torsional { coefficient } => coefficient,
            })
            .sum();
        sheet.check("power of the dampers at one speed: C_eq θ′²", number(power), damping);
    }
}

/// The reduced values make the same natural frequency and the same rate of decay.
pub(super) fn at_point<W: Worksheet>(
    terms: &Terms<W::Num>,
    [mass, stiffness, damping]: [Option<W::Num>; 3],
    reference: W::Num,
    sheet: W,
) {
    // A unit displacement of the point is a rotation of 1/b.
    let turn = W::Num::from(1.0) / reference;
    for (what, reduced, own) in [
        ("kinetic energy at a unit speed of the reference point", mass, Some(terms.inertia)),
        ("potential energy at a unit displacement of the reference point", stiffness, Some(terms.stiffness)),
        ("power of the dampers at a unit speed of the reference point", damping, terms.damping),
    ] {
        if let (Some(reduced), Some(own)) = (reduced, own) {
            sheet.check(what, reduced / 2.0, own * turn.powi(2) / 2.0);
        }
    }
}

/// Kinetic energy at one radian per second.
fn kinetic(body: &TurningBody) -> f64 {
    let moving = |mass: f64, speed: f64| 0.5 * mass * speed * speed;
    match body {
        TurningBody::Lever { bar, masses, .. } => {
            let bar = match *bar {
                LeverBar::Light => 0.0,
                LeverBar::Uniform { mass, length, pivot } => {
                    let each = mass / length;
                    quadrature::integral(|x| moving(each, x), [-pivot, length - pivot], 1)
                }
                LeverBar::Given { inertia, .. } => 0.5 * inertia,
            };
            let masses = masses
                .iter()
                .map(|mass| moving(mass.mass, mass.distance) + 0.5 * mass.inertia.unwrap_or(0.0));
            bar + masses.sum::<f64>()
        }
        TurningBody::Rolling { mass, radius, shape, masses, .. } => {
            let turning = match *shape {
                RollingShape::Cylinder => moving(*mass, *radius) / 2.0,
                RollingShape::Ring => moving(*mass, *radius),
                RollingShape::Sphere => moving(*mass, *radius) * 2.0 / 5.0,
                RollingShape::Given { inertia } => 0.5 * inertia,
            };
            let cords: f64 = masses.iter().map(|mass| moving(mass.mass, mass.arm)).sum();
            moving(*mass, *radius) + turning + cords
        }
        TurningBody::Pulley { inertia, masses } => {
            let own = match *inertia {
                Inertia::Rotor(RotorInertia::Given { inertia }) => 0.5 * inertia,
                Inertia::Rotor(RotorInertia::Gyration { mass, radius }) => moving(mass, radius),
                Inertia::Rotor(RotorInertia::WeightMoment { weight_moment, gravity }) => {
                    0.5 * weight_moment / gravity
                }
                Inertia::Rotor(RotorInertia::Disc { mass, diameter }) => moving(mass, 0.5 * diameter) / 2.0,
                Inertia::Ring { mass, diameter } => moving(mass, 0.5 * diameter),
                Inertia::Shape { ref mass, ref shape, distance } => {
                    let mass = match *mass {
                        Mass::Mass { mass } => mass,
                        Mass::Weight { weight, gravity } => weight / gravity,
                    };
                    moving(mass, distance.unwrap_or(0.0)) + mass * around_centre(shape)
                }
            };
            own + masses.iter().map(|mass| moving(mass.mass, mass.arm)).sum::<f64>()
        }
    }
}

/// Kinetic energy of a body of one kilogram that rotates about its centre by one radian per second: the mean of that
/// of its points.
fn around_centre(shape: &BodyShape) -> f64 {
    // Of points spread evenly from −1/2 to 1/2 of a length.
    let spread = |length: f64| quadrature::integral(|x| 0.5 * (x * length).powi(2), [-0.5, 0.5], 1);
    // Of a circular area about its centre, and of a ball about a diameter.
    let disc = |d: f64| quadrature::integral(|x| 0.5 * (0.5 * x * d).powi(2) * 2.0 * x, [0.0, 1.0], 1);
    let ball = |d: f64| {
        quadrature::integral(|x| 2.0 / 3.0 * 0.5 * (0.5 * x * d).powi(2) * 3.0 * x * x, [0.0, 1.0], 1)
    };
    match *shape {
        BodyShape::Rod { length } => spread(length),
        BodyShape::Plate { length, width } => spread(length) + spread(width),
        BodyShape::Disc { diameter } => disc(diameter),
        BodyShape::Ring { diameter } => 0.125 * diameter * diameter,
        BodyShape::Cylinder { diameter, length } => 0.5 * disc(diameter) + spread(length),
        BodyShape::Sphere { diameter } => ball(diameter),
        BodyShape::Gyration { radius } => 0.5 * radius * radius,
    }
}

/// Energy of a spring at one radian.
fn stored(spring: &AttachedSpring) -> f64 {
    match *spring {
        AttachedSpring::Linear { stiffness, arm, angle } => {
            let stretched = arm * angle.unwrap_or(0.0).cos();
            0.5 * stiffness * stretched * stretched
        }
        AttachedSpring::Torsional { stiffness } => 0.5 * stiffness,
    }
}

/// Energy of the weights at one radian, of their heights to the second order.
fn lifted(body: &TurningBody) -> f64 {
    match body {
        TurningBody::Lever { bar, position, masses } => {
            let downwards = match *position {
                LeverPosition::Horizontal => return 0.0,
                LeverPosition::Hanging { gravity } => gravity,
                LeverPosition::Standing { gravity } => -gravity,
            };
            let bar = match *bar {
                LeverBar::Light => 0.0,
                LeverBar::Uniform { mass, length, pivot } => {
                    // The parts on either side of the pivot.
                    let each = mass / length;
                    0.5 * each * ((length - pivot).powi(2) - pivot.powi(2))
                }
                LeverBar::Given { mass, centre, .. } => mass * centre,
            };
            let all = bar + masses.iter().map(|mass| mass.mass * mass.distance).sum::<f64>();
            0.5 * downwards * all
        }
        TurningBody::Rolling {
            mass,
            radius,
            surface: RollingSurface::Trough { radius: large, gravity },
            ..
        } => {
            // The centre moves by r on a circle of radius R − r: it rises by r²/(2(R − r)).
            mass * gravity * radius * radius / (2.0 * (large - radius))
        }
        TurningBody::Rolling { .. } | TurningBody::Pulley { .. } => 0.0,
    }
}
