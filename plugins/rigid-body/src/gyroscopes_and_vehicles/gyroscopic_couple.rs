//! Gyroscopic couple of a rotor in a carrier that turns, and what it does to the carrier.

mod bearings;
mod effect;
mod pictures;

use std::f64::consts::TAU;

use dalembert_core::{About, Analysis, Inputs, Refusal, Worksheet, register};
use dalembert_mechanics::{
    Real, Vector,
    rigid::{self, gyroscope},
};
use nalgebra::Vector3;

use crate::{
    shared::{differences::second_slope, gyro_rotor::GyroRotor},
    sources::{BEER, IRODOV, KHURMI, MERIAM},
};

/// The rotor, how it spins, and how its carrier turns.
///
/// The axes go with the carrier: x forward, y to the left (port), z up. Vectors have components along them.
#[derive(Clone, Debug, Inputs)]
pub struct GyroscopicCouple {
    /// Carrier.
    pub carrier: RotorCarrier,
    /// Rotor.
    pub rotor: GyroRotor,
    /// Transverse moment of inertia of the rotor.
    /// About an axis through G transverse to the axle. It matters where the carrier turns about an axis that is not
    /// normal to the axle, and at the ends of a harmonic motion.
    #[input("I_t", "kg*m^2", positive)]
    pub transverse_inertia: Option<f64>,
    /// Speed of the rotor.
    /// Relative to the carrier.
    #[input("ω", "rad/s", nonnegative)]
    pub spin: f64,
    /// Sense of the rotor.
    pub sense: Sense,
    /// Seen from.
    /// Position of the viewer who looks along the axle and sees that sense.
    pub seen_from: Viewpoint,
    /// Motion of the carrier.
    pub motion: CarrierMotion,
    /// Bearings.
    pub bearings: Option<AxleBearings>,
}

/// Carrier of the rotor, on which the wording of the effect depends.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum RotorCarrier {
    /// Ship
    Ship,
    /// Aircraft
    Aircraft,
    /// Vehicle
    Vehicle,
    /// A frame
    Frame,
}

/// A sense of turning.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum Sense {
    /// Clockwise
    Clockwise,
    /// Counter-clockwise
    CounterClockwise,
}

/// Viewpoint of an observer along the axle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum Viewpoint {
    /// Behind: stern, tail, rear
    Behind,
    /// Ahead: bow, nose, front
    Ahead,
    /// The left-hand side, port
    Left,
    /// The right-hand side, starboard
    Right,
    /// Above
    Above,
    /// Below
    Below,
}

/// Rotation of the carrier, or the couple that causes it.
#[derive(Clone, Debug, Inputs)]
pub enum CarrierMotion {
    /// Steady turn
    SteadyTurn {
        /// Speed.
        #[input("v", "m/s", nonnegative)]
        speed: f64,
        /// Radius of the turn.
        #[input("R", "m", positive)]
        radius: f64,
        /// Turn to.
        towards: LeftOrRight,
    },
    /// Pitching at a given rate
    Pitching {
        /// Pitch angular velocity.
        #[input("ω_p", "rad/s", nonnegative)]
        rate: f64,
        /// Bow or nose.
        bow: Bow,
    },
    /// Rolling at a given rate
    Rolling {
        /// Roll angular velocity.
        #[input("ω_p", "rad/s", nonnegative)]
        rate: f64,
        /// Descending side.
        falling: LeftOrRight,
    },
    /// Pitching in simple harmonic motion
    HarmonicPitching {
        /// Amplitude.
        /// Half of the total oscillation.
        #[input("A", "rad", nonnegative)]
        amplitude: f64,
        /// Period.
        #[input("T", "s", positive)]
        period: f64,
        /// Bow or nose, in the middle of the oscillation.
        bow: Bow,
    },
    /// Rolling in simple harmonic motion
    HarmonicRolling {
        /// Amplitude.
        /// Half of the total oscillation.
        #[input("A", "rad", nonnegative)]
        amplitude: f64,
        /// Period.
        #[input("T", "s", positive)]
        period: f64,
        /// Descending side, at mid-position.
        falling: LeftOrRight,
    },
    /// Any angular velocity
    AnyPrecession {
        /// Angular velocity of the carrier.
        /// Components forward, to the left and up.
        #[input("Ω", "rad/s")]
        precession: Vector3<f64>,
    },
    /// Level axle supported at one end: precession due to the weight
    HeldAtOneEnd {
        /// Distance of G from the support.
        /// On the side of the spin vector, by the right-hand rule; negative on the other side.
        #[input("L", "m")]
        arm: f64,
        /// Acceleration of gravity.
        #[input("g", "m/s^2", nonnegative, default = "9.81 m/s^2")]
        gravity: f64,
    },
}

/// Left or right.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum LeftOrRight {
    /// Left, port
    Left,
    /// Right, starboard
    Right,
}

/// Motion of the bow or the nose.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum Bow {
    /// Rising
    Rising,
    /// Falling
    Falling,
}

/// Two bearings that hold the axle.
#[derive(Clone, Debug, Inputs)]
pub struct AxleBearings {
    /// Distance of bearing A from G.
    /// A lies behind G; for a transverse axle on its right, for a vertical axle below. Negative where it lies on the
    /// other side.
    #[input("a", "m")]
    pub behind: f64,
    /// Distance of bearing B from G.
    /// B lies ahead of G; on its left, or above.
    #[input("b", "m")]
    pub ahead: f64,
    /// Acceleration of gravity.
    #[input("g", "m/s^2", nonnegative, default = "9.81 m/s^2")]
    pub gravity: f64,
}

register!(GyroscopicCouple);

impl Analysis for GyroscopicCouple {
    const ABOUT: About = About {
        id: "rigid-body/gyroscopic-couple",
        title: "Gyroscopic couple on a ship, an aircraft or a vehicle",
        topic: "Gyroscopes and vehicles",
        summary: "Couple on a spinning rotor whose carrier turns, pitches or rolls, its reaction on the carrier with the effect in words, and the bearing reactions.",
        keywords: "gyroscope gyroscopic ship aeroplane turbine propeller precession pitching rolling giroscópio giroscópico navio avião precessão arfagem balanço proa popa mancais",
        sources: &[&KHURMI, &BEER, &MERIAM, &IRODOV],
        cases: include_str!("../../cases/gyroscopic_couple.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &GyroscopicCoupleGiven<W>, sheet: W) -> Result<(), Refusal> {
        let (axial, mass) = given.rotor.inertia(sheet)?;
        let axle = sheet.step_vector(
            "u",
            "1",
            direction::<W>(self.spin_direction()),
            "Unit vector of the spin: away from the viewer if clockwise, towards the viewer if counter-clockwise",
        );
        let (precession, rate) = self.precession(given, axial, mass, sheet)?;
        let momentum = match given.transverse_inertia {
            Some(transverse) => sheet.step_vector(
                "H",
                "kg*m^2/s",
                gyroscope::momentum(axial, transverse, given.spin, axle, precession),
                (
                    "Angular momentum about G: due to the spin and to the rotation of the carrier",
                    BEER.at("§18.3"),
                ),
            ),
            None => sheet.step_vector(
                "H",
                "kg*m^2/s",
                axle * (axial * given.spin),
                ("Angular momentum of the spin", KHURMI.at("§14.3")),
            ),
        };
        let couple = sheet.step_vector(
            "M",
            "N*m",
            rigid::transport_rate(precession, momentum),
            (
                "Couple on the rotor: the components of H are constant in axes that turn with the carrier, so dH/dt = Ω × H",
                BEER.at("§18.2"),
            ),
        );
        let size = sheet.step("C", "N*m", couple.magnitude(), ("Gyroscopic couple", KHURMI.at("§14.3")));
        sheet.answer("precession_rate", "Angular velocity of the precession", rate);
        sheet.answer_vector("angular_momentum", "Angular momentum of the rotor", momentum);
        sheet.answer_vector("couple_on_rotor", "Couple on the rotor (forward, left, up)", couple);
        let harmonic = self.harmonic().is_some();
        let label = if harmonic { "Maximum gyroscopic couple" } else { "Gyroscopic couple" };
        sheet.answer("couple", label, size);
        if matches!(self.motion, CarrierMotion::HeldAtOneEnd { .. }) {
            self.check_fall(given, mass, axle, couple, sheet);
        } else {
            let reaction = sheet.step_vector(
                "M_R",
                "N*m",
                -couple,
                "Reaction of the rotor on its carrier: equal and opposite",
            );
            sheet.answer_vector("reaction", "Reaction couple on the carrier (forward, left, up)", reaction);
            effect::answer(self.carrier, reaction, size, sheet);
        }
        self.harmonic_answers(given, sheet);
        if let (Some(bearings), Some(given_bearings)) = (&self.bearings, &given.bearings) {
            let mass = mass.ok_or_else(|| {
                Refusal::because(
                    "the bearings also carry the weight of the rotor: write its mass, or 0 kg for the contribution of the couple alone",
                )
            })?;
            self.bearing_reactions(bearings, given, given_bearings, mass, axle, couple, sheet)?;
        }
        self.warn_of_oblique_axle(precession.value(), sheet);
        sheet.verify(|| {
            self.check_by_rotation(axial.value(), momentum.value(), precession.value(), couple, sheet);
        });
        let (couple, precession) = (couple.value(), precession.value());
        sheet.show(|| self.animation(couple, precession));
        if let Some(plot) = self.plot(size.value()) {
            sheet.show(|| plot);
        }
        Ok(())
    }
}

/// A fixed direction as a vector of the worksheet.
fn direction<W: Worksheet>(along: Vector3<f64>) -> W::Vec {
    W::Vec::from_components(along.x.into(), along.y.into(), along.z.into())
}

impl GyroscopicCouple {
    /// The unit vector of the spin, by the right-hand rule.
    fn spin_direction(&self) -> Vector3<f64> {
        let away = match self.seen_from {
            Viewpoint::Behind => Vector3::x(),
            Viewpoint::Ahead => -Vector3::x(),
            Viewpoint::Left => -Vector3::y(),
            Viewpoint::Right => Vector3::y(),
            Viewpoint::Above => -Vector3::z(),
            Viewpoint::Below => Vector3::z(),
        };
        if self.sense == Sense::Clockwise { away } else { -away }
    }

    /// Amplitude and period of a harmonic motion.
    fn harmonic(&self) -> Option<(f64, f64)> {
        match self.motion {
            CarrierMotion::HarmonicPitching { amplitude, period, .. }
            | CarrierMotion::HarmonicRolling { amplitude, period, .. } => Some((amplitude, period)),
            _ => None,
        }
    }

    /// The angular velocity of the carrier, and its size.
    fn precession<W: Worksheet>(
        &self,
        given: &GyroscopicCoupleGiven<W>,
        axial: W::Num,
        mass: Option<W::Num>,
        sheet: W,
    ) -> Result<(W::Vec, W::Num), Refusal> {
        let largest = |amplitude: W::Num, period: W::Num| {
            let frequency = sheet.step(
                "p",
                "rad/s",
                W::Num::from(TAU) / period,
                "Angular frequency of the harmonic motion",
            );
            sheet.step(
                "ω_p",
                "rad/s",
                amplitude * frequency,
                ("Maximum angular velocity, in the middle of the oscillation", KHURMI.at("§14.7")),
            )
        };
        let (rate, along, why) = match (&self.motion, &given.motion) {
            (CarrierMotion::AnyPrecession { .. }, CarrierMotionGiven::AnyPrecession { precession }) => {
                let rate = sheet.step(
                    "ω_p",
                    "rad/s",
                    precession.magnitude(),
                    "Magnitude of the angular velocity of the carrier",
                );
                return Ok((*precession, rate));
            }
            (
                CarrierMotion::SteadyTurn { towards, .. },
                CarrierMotionGiven::SteadyTurn { speed, radius, .. },
            ) => {
                let rate = sheet.step(
                    "ω_p",
                    "rad/s",
                    *speed / *radius,
                    ("Angular velocity of the carrier on its curve", KHURMI.at("§14.6")),
                );
                let up = if *towards == LeftOrRight::Left { Vector3::z() } else { -Vector3::z() };
                (
                    rate,
                    up,
                    "Seen from above, a turn to the left is counter-clockwise: Ω points up; to the right, down",
                )
            }
            (CarrierMotion::Pitching { bow, .. }, CarrierMotionGiven::Pitching { rate, .. }) => {
                (*rate, pitch(*bow), PITCH)
            }
            (
                CarrierMotion::HarmonicPitching { bow, .. },
                CarrierMotionGiven::HarmonicPitching { amplitude, period, .. },
            ) => (largest(*amplitude, *period), pitch(*bow), PITCH),
            (CarrierMotion::Rolling { falling, .. }, CarrierMotionGiven::Rolling { rate, .. }) => {
                (*rate, roll(*falling), ROLL)
            }
            (
                CarrierMotion::HarmonicRolling { falling, .. },
                CarrierMotionGiven::HarmonicRolling { amplitude, period, .. },
            ) => (largest(*amplitude, *period), roll(*falling), ROLL),
            (_, CarrierMotionGiven::HeldAtOneEnd { arm, gravity }) => {
                let mass = mass.ok_or_else(|| {
                    Refusal::because("the weight makes the axle precess: write the mass of the rotor")
                })?;
                if self.spin == 0.0 {
                    return Err(Refusal::because(
                        "a rotor without spin falls and does not precess: write a speed above zero",
                    ));
                }
                if self.spin_direction().z != 0.0 {
                    return Err(Refusal::because(
                        "a vertical axle needs no couple to remain vertical: choose a viewpoint from which the axle is horizontal",
                    ));
                }
                let moment = sheet.step(
                    "M_W",
                    "N*m",
                    mass * *gravity * *arm,
                    "Moment of the weight about the support",
                );
                let rate = sheet.step(
                    "ω_p",
                    "rad/s",
                    gyroscope::precession_rate(moment, axial, given.spin),
                    ("The couple rotates H at the precession rate: M = I_a ω ω_p", KHURMI.at("§14.3")),
                );
                (rate, Vector3::z(), "The axle precesses about the vertical through its support")
            }
            _ => unreachable!("the given motion is the motion"),
        };
        let vector = sheet.step_vector("Ω", "rad/s", direction::<W>(along) * rate, why);
        Ok((vector, rate))
    }

    /// Answers of a harmonic motion alone: its maximum angular acceleration.
    fn harmonic_answers<W: Worksheet>(&self, given: &GyroscopicCoupleGiven<W>, sheet: W) {
        let (CarrierMotionGiven::HarmonicPitching { amplitude, period, .. }
        | CarrierMotionGiven::HarmonicRolling { amplitude, period, .. }) = &given.motion
        else {
            return;
        };
        let acceleration = sheet.step(
            "α",
            "rad/s^2",
            *amplitude * (W::Num::from(TAU) / *period).powi(2),
            ("Maximum angular acceleration, at the ends of the oscillation", KHURMI.at("§14.7")),
        );
        sheet.answer("angular_acceleration", "Maximum angular acceleration of the carrier", acceleration);
        let swing = |t: f64| amplitude.value() * (TAU * t / period.value()).cos();
        sheet.verify(|| {
            let Some(found) = second_slope(swing, period.value()) else { return };
            let what = "second difference quotient of the angle at the end of the swing";
            sheet.check(what, acceleration, (-found).into());
        });
        let pitching = matches!(self.motion, CarrierMotion::HarmonicPitching { .. });
        if let Some(transverse) = given.transverse_inertia
            && (pitching || self.spin_direction().x == 0.0)
            && !(pitching && self.spin_direction().y != 0.0)
        {
            let couple = sheet.step(
                "C_α",
                "N*m",
                transverse * acceleration,
                "Couple that accelerates and decelerates the rotor with its carrier, maximum where the gyroscopic couple is zero",
            );
            sheet.answer("inertia_couple", "Maximum inertia couple, at the ends of the oscillation", couple);
            sheet.verify(|| {
                // What the angular momentum about the axis of the swing changes by, where it is zero.
                let momentum = |t: f64| {
                    let rate = rigid::numerical_rate(|s| Vector3::x() * swing(t + s), period.value());
                    rate.unwrap_or_default() * transverse.value()
                };
                let Ok(change) = rigid::numerical_rate(momentum, period.value()) else { return };
                let what = "difference quotient of the angular momentum about the axis of the swing";
                sheet.check(what, couple, (-change.x).into());
            });
        }
    }

    /// The moment of the weight about the support is the couple Ω × H.
    fn check_fall<W: Worksheet>(
        &self,
        given: &GyroscopicCoupleGiven<W>,
        mass: Option<W::Num>,
        axle: W::Vec,
        couple: W::Vec,
        sheet: W,
    ) {
        if let (CarrierMotionGiven::HeldAtOneEnd { arm, gravity }, Some(mass)) = (&given.motion, mass) {
            let zero = W::Num::from(0.0);
            sheet.verify(|| {
                sheet.check_vector(
                    "the moment of the weight about the support",
                    (axle * *arm).cross(W::Vec::from_components(zero, zero, -(mass * *gravity))),
                    couple,
                );
            });
        }
    }

    /// Without the transverse moment of inertia an oblique axle is only known in part.
    fn warn_of_oblique_axle<W: Worksheet>(&self, precession: Vector3<f64>, sheet: W) {
        let size = precession.norm();
        let along = Vector::dot(precession, self.spin_direction()).abs();
        let across = Vector::cross(precession, self.spin_direction()).norm();
        if self.transverse_inertia.is_none() && along > 1e-9 * size && across > 1e-9 * size {
            sheet.warn(|| {
                "the carrier turns about an axis that is not normal to the axle: without the transverse moment of inertia the term (I_a − I_t) Ω² sin θ cos θ of the couple is missing".into()
            });
        }
    }

    /// A second method: the whole tensor, turned with the rotor by finite rotations, times its angular velocity, and the
    /// difference quotient of that product in time. A transverse moment of inertia that is not known has no part in
    /// the couple that is answered: that of a sphere has none.
    fn check_by_rotation<W: Worksheet>(
        &self,
        axial: f64,
        momentum: Vector3<f64>,
        precession: Vector3<f64>,
        couple: W::Vec,
        sheet: W,
    ) {
        let axle = self.spin_direction();
        let tensor = gyroscope::symmetric_tensor(axial, self.transverse_inertia.unwrap_or(axial), axle);
        let period = TAU / precession.norm();
        let period = if period.is_finite() { period } else { 1.0 };
        // The spin leaves the tensor of a symmetric rotor as it is: it need not be followed.
        let momentum_at = |t: f64| {
            let carrier = nalgebra::Rotation3::from_scaled_axis(precession * t);
            rigid::turned(&tensor, &carrier) * (precession + carrier * axle * self.spin)
        };
        let Ok(rate) = rigid::numerical_rate(momentum_at, period) else { return };
        sheet.check_zero(
            "the couple from the difference quotient of R I Rᵀ ω",
            W::Num::from((rate - couple.value()).norm()),
            (momentum.norm() + axial * precession.norm()) * TAU / period + couple.value().norm(),
        );
    }
}

const PITCH: &str = "When the bow rises, Ω points to the right; when it falls, to the left";
const ROLL: &str =
    "When the right-hand side descends, Ω points forward; when the left-hand side descends, backward";

/// Direction of the angular velocity of a pitching carrier.
fn pitch(bow: Bow) -> Vector3<f64> {
    if bow == Bow::Rising { -Vector3::y() } else { Vector3::y() }
}

/// Direction of the angular velocity of a rolling carrier.
fn roll(falling: LeftOrRight) -> Vector3<f64> {
    if falling == LeftOrRight::Right { Vector3::x() } else { -Vector3::x() }
}
