//! Gyroscopic couple of a rotor in a carrier that turns, and what it does to the carrier.

mod bearings;
mod effect;
mod pictures;
mod precession;

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
    /// Relative to the carrier. Left out where the rotor is given by its angular momentum.
    #[input("ω", "rad/s", nonnegative)]
    pub spin: Option<f64>,
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
    /// Vertical curve: loop, pull-out of a dive, crest
    /// The carrier is level at the moment.
    VerticalCurve {
        /// Speed.
        #[input("v", "m/s", nonnegative)]
        speed: f64,
        /// Radius of the curve.
        #[input("R", "m", positive)]
        radius: f64,
        /// Bow or nose.
        /// Rising at the bottom of a loop or a dip, falling at the top of a crest.
        bow: Bow,
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
    /// Gimbal
    /// A control-moment gyro: the axle is held in a gimbal, which turns in the carrier.
    Gimbal {
        /// Angular velocity of the gimbal.
        #[input("ω_g", "rad/s", nonnegative)]
        rate: f64,
        /// Any vector along the axis of the gimbal.
        /// The gimbal turns about it by the right-hand rule. Components forward, to the left and up.
        #[input("e_g", "1", default = "(0; 0; 1)")]
        axis: Vector3<f64>,
        /// Gimbal angle.
        /// By which the gimbal has turned the axle from the position given by the sense and the viewpoint.
        #[input("γ", "deg", default = "0 deg")]
        angle: f64,
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
        summary: "Couple on a spinning rotor whose carrier or gimbal turns, pitches or rolls, its reaction on the carrier with the effect in words, and the bearing reactions.",
        main: &["couple", "reaction", "bearing_a", "bearing_b"],
        keywords: "gyroscope gyroscopic ship aeroplane turbine propeller precession pitching rolling loop \
                   pull-out dive control-moment gyro CMG gimbal giroscópio giroscópico navio avião precessão \
                   arfagem balanço proa popa mancais looping mergulho cardã conjugado giroscópico",
        sources: &[&KHURMI, &BEER, &MERIAM, &IRODOV],
        cases: include_str!("../../cases/gyroscopic_couple.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &GyroscopicCoupleGiven<W>, sheet: W) -> Result<(), Refusal> {
        let rotor = given.rotor.spinning(given.spin, sheet)?;
        let mass = rotor.mass;
        let axle = self.axle(given, sheet)?;
        let (precession, rate) = self.precession(given, axle, &rotor, sheet)?;
        let oblique = is_oblique(axle.value(), precession.value());
        let transverse = match given.transverse_inertia {
            None if oblique => given.rotor.transverse(sheet)?,
            transverse => transverse,
        };
        let momentum = match transverse {
            Some(transverse) => {
                let along = match rotor.axial {
                    Some(axial) => rotor.momentum + (axial - transverse) * axle.dot(precession),
                    None if oblique => {
                        return Err(Refusal::because(
                            "the carrier turns about an axis that is not normal to the axle, where the transverse moment of inertia counts together with that about the axle: give the rotor by its moment of inertia and speed, or leave the transverse moment of inertia out",
                        ));
                    }
                    None => rotor.momentum,
                };
                sheet.step_vector(
                    "H",
                    "kg*m^2/s",
                    precession * transverse + axle * along,
                    (
                        "Angular momentum about G: due to the spin and to the rotation of the carrier",
                        BEER.at("§18.3"),
                    ),
                )
            }
            None => sheet.step_vector(
                "H",
                "kg*m^2/s",
                axle * rotor.momentum,
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
        if oblique {
            let product = || rotor.momentum * rate;
            let what = "couple taken as H times Ω, without the sine of the angle between them";
            sheet.common_error("C", what, product);
        }
        if let (Some(transverse), Some(axial)) = (transverse, rotor.axial) {
            if oblique {
                let of_spin = || (precession.cross(axle) * rotor.momentum).magnitude();
                let what = "angular momentum due to the rotation of the carrier omitted";
                sheet.common_error("C", what, of_spin);
            } else {
                let of_transverse = || transverse * rotor.momentum / axial * rate;
                let what = "transverse moment of inertia used for the angular momentum of the spin";
                sheet.common_error("C", what, of_transverse);
            }
        }
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
        if transverse.is_none() && oblique {
            sheet.warn(|| {
                "the carrier turns about an axis that is not normal to the axle: without the transverse moment of inertia the term (I_a − I_t) Ω² sin θ cos θ of the couple is missing".into()
            });
        }
        sheet.verify(|| {
            self.check_by_rotation(
                [rotor.axial, transverse].map(|moment| moment.map(Real::value)),
                rotor.momentum.value(),
                axle.value(),
                precession.value(),
                couple,
                sheet,
            );
        });
        let spin = axle.value() * rotor.momentum.value();
        let (couple, precession) = (couple.value(), precession.value());
        sheet.show(|| self.animation(spin, couple, precession));
        if let Some(plot) = self.plot(size.value()) {
            sheet.show(|| plot);
        }
        Ok(())
    }
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

    /// Answers of a harmonic motion alone: its maximum angular acceleration.
    fn harmonic_answers<W: Worksheet>(&self, given: &GyroscopicCoupleGiven<W>, sheet: W) {
        let (CarrierMotionGiven::HarmonicPitching { amplitude, period, .. }
        | CarrierMotionGiven::HarmonicRolling { amplitude, period, .. }) = &given.motion
        else {
            return;
        };
        let average = || *amplitude * TAU * 4.0 / period.powi(2);
        let what = "average angular acceleration over a quarter of a period used in place of the maximum";
        sheet.common_error("α", what, average);
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

    /// A second method: the whole tensor, turned with the rotor by finite rotations, times its angular velocity, and the
    /// difference quotient of that product in time. A transverse moment of inertia that is not known has no part in
    /// the couple that is answered: that of a sphere has none. Nor has one about the axle that is not known.
    fn check_by_rotation<W: Worksheet>(
        &self,
        [axial, transverse]: [Option<f64>; 2],
        momentum: f64,
        axle: Vector3<f64>,
        precession: Vector3<f64>,
        couple: W::Vec,
        sheet: W,
    ) {
        let transverse = transverse.or(axial).unwrap_or(0.0);
        let tensor = gyroscope::symmetric_tensor(axial.unwrap_or(transverse), transverse, axle);
        let period = TAU / precession.norm();
        let period = if period.is_finite() { period } else { 1.0 };
        // The spin leaves the tensor of a symmetric rotor as it is: it need not be followed.
        let momentum_at = |t: f64| {
            let carrier = nalgebra::Rotation3::from_scaled_axis(precession * t);
            rigid::turned(&tensor, &carrier) * precession + carrier * axle * momentum
        };
        let Ok(rate) = rigid::numerical_rate(momentum_at, period) else { return };
        sheet.check_zero(
            "the couple from the difference quotient of R I Rᵀ ω",
            W::Num::from((rate - couple.value()).norm()),
            (momentum + tensor.amax() * precession.norm()) * TAU / period + couple.value().norm(),
        );
    }
}

/// Returns true if the carrier turns about an axis that is neither along the axle nor normal to it.
fn is_oblique(axle: Vector3<f64>, precession: Vector3<f64>) -> bool {
    let size = precession.norm();
    let along = Vector::dot(precession, axle).abs();
    let across = Vector::cross(precession, axle).norm();
    along > 1e-9 * size && across > 1e-9 * size
}
