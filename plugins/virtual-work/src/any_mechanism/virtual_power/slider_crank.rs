//! Compatibility of a given motion with the closure of a slider-crank.
//!
//! The crank turns about the origin at the angle θ_c, the rod makes the angle θ_r with the x axis, drawn from the
//! crank pin, and the slider moves along x. Crank, rod and slider are links 2, 3 and 4 of the course notes.

mod compared;
mod drawing;

use dalembert_core::{Exhibit, Inputs, Reference, Worksheet};
use dalembert_mechanics::{Real, Vector, slider_crank as loops};
use nalgebra::Vector3;

use self::compared::Compared;
use super::{MovingBodyGiven, VirtualPower, VirtualPowerGiven};
use crate::sources::SHIGLEY;

/// A slider-crank whose slider moves along x.
#[derive(Clone, Debug, Inputs)]
pub struct GivenSliderCrank {
    /// Geometry.
    pub geometry: Geometry,
    /// Angular velocity of the crank.
    #[input("ω_c", "rad/s")]
    pub crank_speed: f64,
    /// Rod.
    #[input(rows = "bodies")]
    pub rod: Reference,
    /// Slider.
    #[input(rows = "bodies")]
    pub slider: Reference,
}

/// Given angles or lengths of crank and connecting rod.
#[derive(Clone, Debug, Inputs)]
pub enum Geometry {
    /// Angles of crank and rod
    /// In line: the slider's line passes through the bearing of the crank. The lengths follow from the velocity of
    /// the slider.
    Angles {
        /// Angle of the crank.
        #[input("θ_c", "rad")]
        crank_angle: f64,
        /// Angle of the connecting rod.
        /// Negative where the rod slopes down towards the slider.
        #[input("θ_r", "rad")]
        rod_angle: f64,
    },
    /// Lengths and angle of the crank
    Lengths {
        /// Length of the crank.
        #[input("r", "m", positive)]
        crank: f64,
        /// Length of the rod.
        #[input("l", "m", positive)]
        rod: f64,
        /// Offset.
        /// Height of the slider's line above the bearing of the crank.
        #[input("e", "m", default = "0 mm")]
        offset: f64,
        /// Angle of the crank.
        #[input("θ_c", "rad")]
        crank_angle: f64,
        /// Angular acceleration of the crank.
        #[input("α_c", "rad/s^2", default = "0 rad/s^2")]
        crank_acceleration: f64,
    },
}

/// Sines and cosines below this are those of a dead centre or of a limit position.
const TOO_FLAT: f64 = 1e-9;

/// The mechanism that the geometry fixes.
#[derive(Clone, Copy)]
struct Loop<N> {
    crank: N,
    rod: N,
    crank_angle: N,
    rod_angle: N,
    crank_speed: N,
    rod_speed: N,
}

/// Writes down what the closure of the loop demands, warns of every given number that contradicts it, and draws the
/// mechanism.
pub(super) fn hold_against_closure<W: Worksheet>(
    problem: &VirtualPower,
    given: &VirtualPowerGiven<W>,
    mechanism: &GivenSliderCrank,
    given_mechanism: &GivenSliderCrankGiven<W>,
    sheet: W,
) {
    let (rod, slider) = (&given.bodies[mechanism.rod.0], &given.bodies[mechanism.slider.0]);
    let closed = match close_loop(given_mechanism, slider, sheet) {
        Ok(closed) => closed,
        Err(why) => return sheet.warn(|| why.into()),
    };
    let compared = compare(given_mechanism, closed, rod, slider, sheet);
    for it in compared.iter().filter(|it| it.contradicts()) {
        sheet.warn(|| it.warning());
    }
    if compared.iter().any(Compared::contradicts) {
        sheet.warn(|| {
            "the given vectors belong to no slider-crank of this geometry; the sum of powers holds for the vectors as they are".into()
        });
    }
    sheet.show(|| Exhibit::Table(compared::table(&compared)));
    let shape =
        (closed.crank.value(), closed.rod.value(), closed.crank_angle.value(), closed.rod_angle.value());
    sheet.show(|| Exhibit::Drawing(drawing::draw(problem, mechanism, shape)));
}

/// The lengths, angles and angular velocities of the closed loop, or why it does not close.
fn close_loop<W: Worksheet>(
    given: &GivenSliderCrankGiven<W>,
    slider: &MovingBodyGiven<W>,
    sheet: W,
) -> Result<Loop<W::Num>, &'static str> {
    let crank_speed = given.crank_speed;
    match given.geometry {
        GeometryGiven::Angles { crank_angle, rod_angle } => {
            let (rise, fall) = (crank_angle.value().sin(), -rod_angle.value().sin());
            let flat = rise.abs().min(fall.abs()).min(crank_angle.value().cos().abs()) < TOO_FLAT;
            if flat || rise * fall < 0.0 {
                return Err(
                    "with these angles the in-line loop does not close, or is at a dead centre: the given motion could not be checked against it",
                );
            }
            let rod_speed = sheet.step(
                "ω_r",
                "rad/s",
                loops::rod_speed_in_line(crank_angle, rod_angle, crank_speed),
                ("Angular velocity of the rod from loop closure, in-line mechanism", SHIGLEY.at("ch. 3")),
            );
            let [slider_speed, _, _] = slider.velocity.components();
            let crank = loops::crank_from_slider_velocity(slider_speed, crank_angle, rod_angle, crank_speed);
            if !(crank.value().is_finite() && crank.value() > 0.0) {
                return Err(
                    "no crank of positive length gives the slider the given velocity at these angles",
                );
            }
            let crank = sheet.step(
                "r",
                "m",
                crank,
                ("Length of the crank, from the velocity of the slider", SHIGLEY.at("ch. 3")),
            );
            let rod = sheet.step(
                "l",
                "m",
                -(crank * crank_angle.sin() / rod_angle.sin()),
                "Length of the rod from loop closure, in-line mechanism",
            );
            Ok(Loop { crank, rod, crank_angle, rod_angle, crank_speed, rod_speed })
        }
        GeometryGiven::Lengths { crank, rod, offset, crank_angle, .. } => {
            let sine = (offset.value() - crank.value() * crank_angle.value().sin()) / rod.value();
            if sine.abs() > 1.0 - TOO_FLAT {
                return Err(
                    "the rod does not reach the slider's line at this crank angle, or is perpendicular to it: the given motion could not be checked against loop closure",
                );
            }
            let rod_angle = sheet.step(
                "θ_r",
                "deg",
                loops::rod_angle(crank, rod, offset, crank_angle),
                ("Angle of the rod from loop closure", SHIGLEY.at("ch. 2")),
            );
            let rod_speed = sheet.step(
                "ω_r",
                "rad/s",
                loops::rod_speed(crank, rod, crank_angle, rod_angle, crank_speed),
                ("Angular velocity of the rod from loop closure", SHIGLEY.at("ch. 3")),
            );
            Ok(Loop { crank, rod, crank_angle, rod_angle, crank_speed, rod_speed })
        }
    }
}

/// Holds the velocities against the loop, and the accelerations too where any are given.
fn compare<W: Worksheet>(
    given_mechanism: &GivenSliderCrankGiven<W>,
    closed: Loop<W::Num>,
    given_rod: &MovingBodyGiven<W>,
    given_slider: &MovingBodyGiven<W>,
    sheet: W,
) -> Vec<Compared> {
    let Loop { crank, rod, crank_angle, rod_angle, crank_speed, rod_speed } = closed;
    let mut compared = vec![Compared::scalar(
        "angular velocity of the rod",
        "rad/s",
        given_rod.angular_velocity.value(),
        rod_speed.value(),
        crank_speed.value().abs(),
    )];
    let velocity = sheet.step(
        "v_s",
        "m/s",
        loops::slider_velocity(crank, rod, crank_angle, rod_angle, crank_speed, rod_speed),
        ("Velocity of the slider that closes the loop", SHIGLEY.at("ch. 3")),
    );
    let (r, w, theta) = (crank.value(), crank_speed.value(), crank_angle.value());
    let (outward, onward) =
        (Vector3::new(theta.cos(), theta.sin(), 0.0), Vector3::new(-theta.sin(), theta.cos(), 0.0));
    let natural = r * w.abs();
    let (pin_velocity, slider_velocity) = (onward * (r * w), Vector3::x() * velocity.value());
    compared.push(Compared::along_x(
        "velocity of the slider",
        "m/s",
        given_slider.velocity.value(),
        velocity.value(),
        natural,
    ));
    // The centre of mass of a straight rod lies on it: its velocity tells where, and with that its acceleration.
    let along = slider_velocity - pin_velocity;
    let part = if along == Vector3::zeros() {
        0.5
    } else {
        (given_rod.velocity.value() - pin_velocity).dot(along) / along.norm_squared()
    };
    compared.push(Compared::vector(
        "velocity of the rod's centre of mass, in magnitude",
        "m/s",
        given_rod.velocity.value(),
        pin_velocity + along * part,
        natural,
    ));
    let still = given_rod.acceleration.value() == Vector3::zeros()
        && given_slider.acceleration.value() == Vector3::zeros()
        && given_rod.angular_acceleration.value() == 0.0;
    if still {
        return compared; // A problem of statics: its velocities are virtual.
    }
    let (crank_acceleration, rod_acceleration) =
        angular_accelerations(given_rod.angular_acceleration, given_mechanism, closed, &mut compared, sheet);
    let acceleration = sheet.step(
        "a_s",
        "m/s^2",
        loops::slider_acceleration(
            crank,
            rod,
            crank_angle,
            rod_angle,
            crank_speed,
            rod_speed,
            crank_acceleration,
            rod_acceleration,
        ),
        ("Acceleration of the slider from loop closure", SHIGLEY.at("ch. 4")),
    );
    let natural = r * w * w;
    let pin_acceleration = onward * (r * crank_acceleration.value()) - outward * natural;
    let slider_acceleration = Vector3::x() * acceleration.value();
    compared.push(Compared::along_x(
        "acceleration of the slider",
        "m/s^2",
        given_slider.acceleration.value(),
        acceleration.value(),
        natural,
    ));
    compared.push(Compared::vector(
        "acceleration of the rod's centre of mass, in magnitude",
        "m/s^2",
        given_rod.acceleration.value(),
        pin_acceleration + (slider_acceleration - pin_acceleration) * part,
        natural,
    ));
    compared
}

/// Those of crank and rod: where the lengths are given, that of the rod follows from the crank's; where only angles
/// are, the other way round.
fn angular_accelerations<W: Worksheet>(
    given_rod_acceleration: W::Num,
    given_mechanism: &GivenSliderCrankGiven<W>,
    closed: Loop<W::Num>,
    compared: &mut Vec<Compared>,
    sheet: W,
) -> (W::Num, W::Num) {
    let Loop { crank, rod, crank_angle, rod_angle, crank_speed, rod_speed } = closed;
    match given_mechanism.geometry {
        GeometryGiven::Angles { .. } => {
            let crank_acceleration = sheet.step(
                "α_c",
                "rad/s^2",
                (crank * crank_speed.powi(2) * crank_angle.sin() + rod * rod_speed.powi(2) * rod_angle.sin()
                    - rod * given_rod_acceleration * rod_angle.cos())
                    / (crank * crank_angle.cos()),
                ("Angular acceleration of the crank corresponding to that of the rod", SHIGLEY.at("ch. 4")),
            );
            (crank_acceleration, given_rod_acceleration)
        }
        GeometryGiven::Lengths { crank_acceleration, .. } => {
            let rod_acceleration = sheet.step(
                "α_r",
                "rad/s^2",
                loops::rod_acceleration(
                    crank,
                    rod,
                    crank_angle,
                    rod_angle,
                    crank_speed,
                    rod_speed,
                    crank_acceleration,
                ),
                ("Angular acceleration of the rod from loop closure", SHIGLEY.at("ch. 4")),
            );
            compared.push(Compared::scalar(
                "angular acceleration of the rod",
                "rad/s^2",
                given_rod_acceleration.value(),
                rod_acceleration.value(),
                crank_speed.value().powi(2),
            ));
            (crank_acceleration, rod_acceleration)
        }
    }
}
