//! Validation of a mechanism: finite numbers, and references to bodies and joints that exist.

use crate::planar::{BodyFrame, PlanarError, PlanarJoint, PlanarLoad, PlanarMechanism, RelativeCoordinate};

/// Refuses the first number or reference of a mechanism that is not valid; `guess` has a position for each body.
pub(in super::super) fn check(mechanism: &PlanarMechanism, guess: &[[f64; 3]]) -> Result<(), PlanarError> {
    let bodies = mechanism.bodies.len();
    let number = |what: &'static str, index: usize| PlanarError::Number { what, index };
    for (index, body) in mechanism.bodies.iter().enumerate() {
        let good = |x: f64| x.is_finite() && x >= 0.0;
        let placed = guess.get(index).is_some_and(|at| at.iter().all(|x| x.is_finite()));
        if !(good(body.mass) && good(body.inertia) && placed) {
            return Err(number("body", index));
        }
    }
    if mechanism.gravity.iter().any(|x| !x.is_finite()) {
        return Err(number("the acceleration of gravity, body", 0));
    }
    let frame = |what: &'static str, index: usize, frame: BodyFrame| match frame {
        Some(body) if body >= bodies => Err(PlanarError::NoSuchBody { what, index, body, bodies }),
        _ => Ok(()),
    };
    let measured = |what: &'static str, index: usize, measure: &RelativeCoordinate| {
        let finite = match *measure {
            RelativeCoordinate::Angle { .. } => true,
            RelativeCoordinate::Component { direction, from, to }
            | RelativeCoordinate::Along { direction, from, to } => {
                direction.iter().chain(&from.at).chain(&to.at).all(|x| x.is_finite())
            }
            RelativeCoordinate::Distance { from, to } | RelativeCoordinate::Bearing { from, to } => {
                from.at.iter().chain(&to.at).all(|x| x.is_finite())
            }
        };
        if !finite {
            return Err(number(what, index));
        }
        measure.bodies().into_iter().try_for_each(|body| frame(what, index, body))
    };
    for (index, joint) in mechanism.joints.iter().enumerate() {
        for equation in joint.equations() {
            for term in &equation.terms {
                measured("joint", index, &term.measure)?;
                if !term.weight.is_finite() {
                    return Err(number("joint", index));
                }
            }
            if equation.constant.is_some_and(|constant| !constant.is_finite()) {
                return Err(number("joint", index));
            }
        }
        if let PlanarJoint::Rod { length, .. } = joint
            && *length <= 0.0
        {
            return Err(number("joint", index));
        }
    }
    for (index, driver) in mechanism.drivers.iter().enumerate() {
        measured("driver", index, &driver.measure)?;
        if ![driver.value, driver.velocity, driver.acceleration].iter().all(|x| x.is_finite()) {
            return Err(number("driver", index));
        }
    }
    for (index, load) in mechanism.loads.iter().enumerate() {
        match load {
            PlanarLoad::Force { at, force, turns_with } => {
                frame("load", index, at.on)?;
                frame("load", index, *turns_with)?;
                if force.iter().chain(&at.at).any(|x| !x.is_finite()) {
                    return Err(number("load", index));
                }
            }
            PlanarLoad::Effort { measure, .. } => measured("load", index, measure)?,
            PlanarLoad::Friction { joint, coefficient, radius } => {
                let good = |x: f64| x.is_finite() && x >= 0.0;
                if *joint >= mechanism.joints.len() || !good(*coefficient) || !good(*radius) {
                    return Err(number("load", index));
                }
            }
        }
    }
    Ok(())
}
