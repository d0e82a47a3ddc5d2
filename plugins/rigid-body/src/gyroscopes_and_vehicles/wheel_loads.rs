//! Wheel loads of a vehicle in a turn, with the gyroscopic couples of its wheels and its engine.

mod limits;
mod pictures;
mod wheels;

use std::f64::consts::TAU;

use dalembert_core::{About, Analysis, Exhibit, Inputs, Refusal, Worksheet, register};
use dalembert_mechanics::{
    Real, Vector,
    rigid::{self, gyroscope},
};
use nalgebra::Vector3;

use crate::{
    shared::common_errors::AS_DISC,
    sources::{BEER, KHURMI},
};
use wheels::Wheel;

/// A vehicle with one or two axles on a curve, level or banked, and its turning parts.
///
/// The body does not lean on its springs. Of the body only the mass counts: the change of its own angular momentum in a
/// steady turn is neglected.
#[derive(Clone, Debug, Inputs)]
pub struct WheelLoads {
    /// Mass.
    #[input("m", "kg", positive)]
    pub mass: f64,
    /// Height of the centre of mass.
    /// Above the road, normal to it.
    #[input("h", "m", positive)]
    pub centre_height: f64,
    /// Track.
    /// Distance between the left and the right wheels; the gauge of a railway.
    #[input("w", "m", positive)]
    pub track: f64,
    /// Axles.
    pub layout: AxleLayout,
    /// Radius of the wheels.
    #[input("r", "m", positive)]
    pub wheel_radius: f64,
    /// Moment of inertia of the wheels.
    pub wheels: WheelInertia,
    /// Transverse moment of inertia of each pair of wheels.
    /// About an axis transverse to the axle. It matters only on a banked road, and little.
    #[input("I_t", "kg*m^2", positive)]
    pub transverse_inertia: Option<f64>,
    /// Engine or motors.
    pub engine: Option<GearedInertia>,
    /// Radius of the curve.
    /// Of the centre of mass.
    #[input("R", "m", positive)]
    pub radius: f64,
    /// Turn to.
    pub towards: TurnDirection,
    /// Bank.
    /// Angle of the road or the track, which falls to the inside; the superelevation of a railway.
    #[input("β", "rad", nonnegative, max = 1.2, default = "0 deg")]
    pub bank: f64,
    /// Speed.
    /// If omitted, only the limits are calculated.
    #[input("v", "m/s", nonnegative)]
    pub speed: Option<f64>,
    /// Friction coefficient.
    #[input("µ", "1", positive)]
    pub friction: Option<f64>,
    /// Acceleration of gravity.
    #[input("g", "m/s^2", positive, default = "9.81 m/s^2")]
    pub gravity: f64,
}

/// The axles and where the mass stands between them.
#[derive(Clone, Debug, Inputs)]
pub enum AxleLayout {
    /// Two axles, centre of mass in the middle
    TwoEqualAxles,
    /// Two axles, centre of mass given
    TwoAxles {
        /// Wheelbase.
        #[input("L", "m", positive)]
        wheelbase: f64,
        /// Distance of the centre of mass behind the front axle.
        #[input("c", "m")]
        behind_front: f64,
        /// Share of the overturning couple carried by the front axle.
        /// With four wheels on a rigid body it is indeterminate: one half if nothing is known, otherwise as distributed
        /// by the springs.
        #[input("ξ", "1", nonnegative, max = 1.0, default = "0.5")]
        front_share: f64,
    },
    /// One axle
    OneAxle,
}

/// The wheels about their axles.
#[derive(Clone, Debug, Inputs)]
pub enum WheelInertia {
    /// Each wheel: moment of inertia
    EachWheel {
        /// Moment of inertia of a wheel.
        #[input("I_w", "kg*m^2", nonnegative)]
        inertia: f64,
    },
    /// Each wheel: mass and radius of gyration
    EachWheelGyration {
        /// Mass of a wheel.
        #[input("m_w", "kg", nonnegative)]
        mass: f64,
        /// Radius of gyration of a wheel.
        #[input("k", "m", nonnegative)]
        radius_of_gyration: f64,
    },
    /// Each pair with its axle: moment of inertia
    EachPair {
        /// Moment of inertia of a pair.
        #[input("I_w", "kg*m^2", nonnegative)]
        inertia: f64,
    },
    /// Each pair with its axle: mass and radius of gyration
    EachPairGyration {
        /// Mass of a pair.
        #[input("m_w", "kg", nonnegative)]
        mass: f64,
        /// Radius of gyration of a pair.
        #[input("k", "m", nonnegative)]
        radius_of_gyration: f64,
    },
}

/// Turning parts that are geared to the wheels.
#[derive(Clone, Debug, Inputs)]
pub struct GearedInertia {
    /// Moment of inertia.
    /// Of all parts that rotate at the same speed.
    #[input("I_e", "kg*m^2", nonnegative)]
    pub inertia: f64,
    /// Gear ratio.
    /// Engine speed divided by wheel speed.
    #[input("G", "1", nonnegative)]
    pub ratio: f64,
    /// Shaft and sense.
    pub shaft: EngineOrientation,
}

/// Orientation and sense of rotation of the engine shaft.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum EngineOrientation {
    /// Transverse, same sense as the wheels
    AcrossLikeWheels,
    /// Transverse, opposite to the wheels
    AcrossAgainstWheels,
    /// Longitudinal, clockwise seen from the front
    AlongClockwiseFromFront,
    /// Longitudinal, clockwise seen from the rear
    AlongClockwiseFromRear,
}

/// Left or right.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum TurnDirection {
    /// Left
    Left,
    /// Right
    Right,
}

register!(WheelLoads);

impl Analysis for WheelLoads {
    const ABOUT: About = About {
        id: "rigid-body/wheel-loads",
        title: "Wheel loads in a turn",
        topic: "Gyroscopes and vehicles",
        summary: "Loads on the wheels of a car, a trolley or a rail axle in a level or banked curve, with the gyroscopic couples of wheels and engine, and the speeds at which a wheel lifts or the vehicle slides.",
        main: &[
            "load_transfer",
            "gyroscopic_load",
            "front_outer_load",
            "rear_outer_load",
            "outer_load",
            "lifting_speed",
        ],
        keywords: "vehicle car automobile trolley wheels gyroscopic overturning limiting speed superelevation bank veículo automóvel rodas carga tombamento velocidade limite superelevação curva giroscópico",
        sources: &[&KHURMI, &BEER],
        cases: include_str!("../../cases/wheel_loads.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &WheelLoadsGiven<W>, sheet: W) -> Result<(), Refusal> {
        if let (AxleLayout::TwoEqualAxles | AxleLayout::OneAxle, Some(engine)) = (&self.layout, &self.engine)
            && engine.lies_along()
        {
            return Err(Refusal::because(
                "an engine along the vehicle shifts load between the axles: choose two axles with the centre of mass given, and write the wheelbase",
            ));
        }
        if let AxleLayout::TwoAxles { wheelbase, behind_front, .. } = self.layout
            && !(0.0..=wheelbase).contains(&behind_front)
        {
            return Err(Refusal::because(
                "the centre of mass is not between the axles, so the vehicle tips over at rest: write its distance behind the front axle, from zero to the wheelbase",
            ));
        }
        let inertia = self.wheel_inertia(given, sheet);
        if let Some(speed) = given.speed {
            self.loads_at(given, inertia, speed, sheet);
        }
        self.limits(given, inertia, sheet);
        let inertia = inertia.value();
        let constants = self.constants(inertia);
        let wheels = self.wheel_list();
        sheet.verify(|| self.check_limits(inertia, sheet));
        sheet.show(|| Exhibit::Plot(self.loads_over_speed(&constants, &wheels)));
        sheet.show(|| Exhibit::Drawing(self.rear_view(&constants, &wheels)));
        Ok(())
    }
}

const GEAR_SQUARED: &str = "gear ratio squared, as for the moment of inertia referred by kinetic energy";

impl GearedInertia {
    fn lies_along(&self) -> bool {
        matches!(
            self.shaft,
            EngineOrientation::AlongClockwiseFromFront | EngineOrientation::AlongClockwiseFromRear
        )
    }
}

/// The couples of a turn at a speed.
struct Couples<N> {
    /// Across the road: tilts the vehicle outwards.
    tilting: N,
    /// Presses on the front axle; none without an engine along the vehicle.
    pitching: Option<N>,
}

impl WheelLoads {
    fn axles(&self) -> f64 {
        if matches!(self.layout, AxleLayout::OneAxle) { 1.0 } else { 2.0 }
    }

    /// Moment of inertia of all wheels about their axles.
    fn wheel_inertia<W: Worksheet>(&self, given: &WheelLoadsGiven<W>, sheet: W) -> W::Num {
        let axles = self.axles();
        let all = match given.wheels {
            WheelInertiaGiven::EachWheel { inertia } => inertia * (2.0 * axles),
            WheelInertiaGiven::EachWheelGyration { mass, radius_of_gyration } => {
                mass * radius_of_gyration.powi(2) * (2.0 * axles)
            }
            WheelInertiaGiven::EachPair { inertia } => inertia * axles,
            WheelInertiaGiven::EachPairGyration { mass, radius_of_gyration } => {
                mass * radius_of_gyration.powi(2) * axles
            }
        };
        if let WheelInertiaGiven::EachWheelGyration { .. } | WheelInertiaGiven::EachPairGyration { .. } =
            given.wheels
        {
            sheet.common_error("I_W", AS_DISC, || all / 2.0);
        }
        sheet.step("I_W", "kg*m^2", all, "Moment of inertia of all wheels about their axles")
    }

    /// The couples, the forces and the loads at the given speed.
    fn loads_at<W: Worksheet>(&self, given: &WheelLoadsGiven<W>, inertia: W::Num, speed: W::Num, sheet: W) {
        let banked = self.bank != 0.0;
        let wheel_speed =
            sheet.step("ω_w", "rad/s", speed / given.wheel_radius, "Angular velocity of the wheels");
        let rate =
            sheet.step("Ω", "rad/s", speed / given.radius, "Angular velocity of the vehicle on its curve");
        let level = gyroscope::right_angled_couple(inertia, wheel_speed, rate);
        let wheels = match given.transverse_inertia {
            Some(transverse) if banked => {
                let own = (inertia - transverse * self.axles())
                    * rate.powi(2)
                    * given.bank.sin()
                    * given.bank.cos();
                level * given.bank.cos() - own
            }
            _ if banked => level * given.bank.cos(),
            _ => level,
        };
        let wheels = sheet.step(
            "C_W",
            "N*m",
            wheels,
            (
                "Gyroscopic couple of the wheels: it tilts the vehicle outwards, about its longitudinal axis",
                KHURMI.at("§14.9"),
            ),
        );
        sheet.answer("wheel_couple", "Gyroscopic couple of the wheels", wheels);
        let engine = self.engine_couple(given, wheel_speed, rate, sheet);
        let normal = if banked {
            given.mass * (given.gravity * given.bank.cos() + speed.powi(2) / given.radius * given.bank.sin())
        } else {
            given.mass * given.gravity
        };
        if banked {
            let upright = || given.mass * given.gravity / given.bank.cos();
            let what = "vertical equilibrium written with the wheel loads alone, the side force omitted";
            sheet.common_error("P", what, upright);
        }
        let normal = sheet.step("P", "N", normal, "Sum of the wheel loads, normal to the road");
        let side = if banked {
            given.mass * (speed.powi(2) / given.radius * given.bank.cos() - given.gravity * given.bank.sin())
        } else {
            given.mass * speed.powi(2) / given.radius
        };
        if banked {
            let level = || given.mass * speed.powi(2) / given.radius;
            let what = "whole centripetal force taken as the side force, as on a level road";
            sheet.common_error("S", what, level);
        }
        let side =
            sheet.step("S", "N", side, "Side force of the road, parallel to its surface, towards the inside");
        let overturning = sheet.step(
            "C_O",
            "N*m",
            side * given.centre_height,
            (
                "Overturning couple of the side force: the centrifugal force at the height h",
                KHURMI.at("§14.9"),
            ),
        );
        let couples = match engine {
            Some(engine) if self.engine.as_ref().is_some_and(GearedInertia::lies_along) => {
                Couples { tilting: wheels + overturning, pitching: Some(engine) }
            }
            Some(engine) => Couples { tilting: wheels + engine + overturning, pitching: None },
            None => Couples { tilting: wheels + overturning, pitching: None },
        };
        let half_track = || couples.tilting * 2.0 / given.track;
        sheet.common_error("ΔN", "half of the track taken as the arm of the couple of the loads", half_track);
        if let Some(pitching) = couples.pitching {
            let all = || (couples.tilting + pitching.abs()) / given.track;
            let what = "couple of the longitudinal engine, about another axis, added to the tilting couple";
            sheet.common_error("ΔN", what, all);
        }
        let transfer = sheet.step(
            "ΔN",
            "N",
            couples.tilting / given.track,
            "Load transfer from the inner to the outer side, sum of all wheels of a side",
        );
        let each = sheet.step(
            "N_g",
            "N",
            wheels / (given.track * self.axles()),
            ("Load on each outer wheel due to the couple of the wheels alone", BEER.at("§18.3")),
        );
        sheet.answer("side_force", "Side force of the road", side);
        sheet.answer("overturning_couple", "Overturning couple of the side force", overturning);
        sheet.answer("load_transfer", "Load transfer from the inner to the outer side", transfer);
        sheet.answer("gyroscopic_load", "Load on each outer wheel due to the couple of the wheels", each);
        let loads = self.wheel_loads(given, normal, transfer, couples.pitching, sheet);
        for (wheel, load) in &loads {
            sheet.answer(wheel.name, wheel.label, *load);
        }
        if loads.iter().any(|(_, load)| load.value() < 0.0) {
            sheet.warn(|| {
                "a wheel has lifted: the road cannot pull, and the loads are those that would keep it down".into()
            });
        }
        if let Some(friction) = self.friction
            && side.value().abs() > friction * normal.value()
        {
            sheet.warn(|| "the side force is above the friction: the vehicle slides at this speed".into());
        }
        sheet.verify(|| {
            self.check_by_rotation(inertia.value(), wheel_speed.value(), rate.value(), [wheels, each], sheet);
            if let Some(engine) = engine {
                self.check_engine(wheel_speed.value(), rate.value(), engine, sheet);
            }
            // The forces on the vehicle in the level and the upright direction, and at G about the road.
            let (sin, cos) = self.bank.sin_cos();
            let outwards = self.mass * speed.value().powi(2) / self.radius;
            let weight = self.mass * self.gravity;
            let size = outwards + weight;
            let what = "force of the road towards the centre of the curve";
            sheet.check_sum(what, side * cos + normal * sin, outwards.into(), size);
            sheet.check_sum("force of the road upwards", normal * cos - side * sin, weight.into(), size);
            let (out, up) = (-self.centre_height * sin, self.centre_height * cos);
            let what = "moments of centrifugal force and weight at G about the road";
            let moment = up * outwards + out * weight;
            sheet.check_sum(what, overturning, moment.into(), size * self.centre_height);
            // Axles that are alike are written once.
            let times = if matches!(self.layout, AxleLayout::TwoEqualAxles) { 2.0 } else { 1.0 };
            let sum = Real::sum(loads.iter().map(|(_, load)| *load)) * times;
            sheet.check("the wheel loads sum to the total", sum, normal);
            let outer = |(wheel, load): &(Wheel, W::Num)| if wheel.outer { *load } else { -*load };
            let moment = Real::sum(loads.iter().map(outer)) * times * given.track / 2.0;
            sheet.check_zero(
                "the moments of the wheel loads about the long axis balance the couples",
                moment - couples.tilting,
                self.mass * self.gravity * self.track,
            );
        });
    }

    /// The gyroscopic couple of the engine. Across: positive where it tilts outwards. Along: positive where it presses
    /// on the front axle.
    fn engine_couple<W: Worksheet>(
        &self,
        given: &WheelLoadsGiven<W>,
        wheel_speed: W::Num,
        rate: W::Num,
        sheet: W,
    ) -> Option<W::Num> {
        let (engine, given_engine) = (self.engine.as_ref()?, given.engine.as_ref()?);
        let spin =
            sheet.step("ω_e", "rad/s", given_engine.ratio * wheel_speed, "Angular velocity of the engine");
        let level = gyroscope::right_angled_couple(given_engine.inertia, spin, rate);
        let couple = if self.bank == 0.0 { level } else { level * given.bank.cos() };
        let couple = if self.engine_sign() > 0.0 { couple } else { -couple };
        let why = match engine.shaft {
            EngineOrientation::AcrossLikeWheels => {
                "Gyroscopic couple of the engine, which adds to that of the wheels"
            }
            EngineOrientation::AcrossAgainstWheels => {
                "Gyroscopic couple of the engine, which is subtracted from that of the wheels"
            }
            _ if self.engine_sign() > 0.0 => {
                "Gyroscopic couple of the engine: in this turn it loads the front axle and unloads the rear one"
            }
            _ => {
                "Gyroscopic couple of the engine: in this turn it loads the rear axle and unloads the front one"
            }
        };
        let squared = || couple * given_engine.ratio;
        sheet.common_error("C_E", GEAR_SQUARED, squared);
        let couple = sheet.step("C_E", "N*m", couple, (why, KHURMI.at("§14.9")));
        sheet.answer("engine_couple", "Gyroscopic couple of the engine", couple);
        Some(couple)
    }

    /// Across: +1 like the wheels. Along: +1 where the couple presses on the front axle. Clockwise from the front the
    /// spin points backward; in a turn to the left Ω × H then points right, its reaction left, which lowers the nose.
    fn engine_sign(&self) -> f64 {
        let left = self.towards == TurnDirection::Left;
        match self.engine.as_ref().map(|engine| engine.shaft) {
            None => 0.0,
            Some(EngineOrientation::AcrossLikeWheels) => 1.0,
            Some(EngineOrientation::AcrossAgainstWheels) => -1.0,
            Some(EngineOrientation::AlongClockwiseFromFront) => {
                if left {
                    1.0
                } else {
                    -1.0
                }
            }
            Some(EngineOrientation::AlongClockwiseFromRear) => {
                if left {
                    -1.0
                } else {
                    1.0
                }
            }
        }
    }

    /// The load of each wheel.
    fn wheel_loads<W: Worksheet>(
        &self,
        given: &WheelLoadsGiven<W>,
        normal: W::Num,
        transfer: W::Num,
        pitching: Option<W::Num>,
        sheet: W,
    ) -> Vec<(Wheel, W::Num)> {
        let wheels = self.wheel_list();
        let (front, rear, front_transfer, rear_transfer) = match given.layout {
            AxleLayoutGiven::TwoAxles { wheelbase, behind_front, front_share } => {
                let front = normal * (wheelbase - behind_front) / wheelbase;
                let front = match pitching {
                    Some(couple) => front + couple / wheelbase,
                    None => front,
                };
                let equal = || match pitching {
                    Some(couple) => normal / 2.0 + couple / wheelbase,
                    None => normal / 2.0,
                };
                sheet.common_error("P_f", "weight divided equally between the axles", equal);
                let front =
                    sheet.step("P_f", "N", front, "Load of the front axle: moments about the rear one");
                let rear = sheet.step("P_r", "N", normal - front, "Load of the rear axle");
                let shifted =
                    sheet.step("ΔN_f", "N", transfer * front_share, "Load transfer at the front axle");
                (front, rear, shifted, transfer - shifted)
            }
            AxleLayoutGiven::TwoEqualAxles { .. } => {
                let axle = normal / 2.0;
                (axle, axle, transfer / 2.0, transfer / 2.0)
            }
            AxleLayoutGiven::OneAxle { .. } => (normal, normal, transfer, transfer),
        };
        wheels
            .into_iter()
            .map(|wheel| {
                let (axle, shifted) =
                    if wheel.front { (front, front_transfer) } else { (rear, rear_transfer) };
                let load = if wheel.outer { axle / 2.0 + shifted } else { axle / 2.0 - shifted };
                let halved = || if wheel.outer { (axle + shifted) / 2.0 } else { (axle - shifted) / 2.0 };
                let what = "load transfer divided between the inner and the outer wheel";
                sheet.common_error(wheel.symbol, what, halved);
                let load = sheet.step(wheel.symbol, "N", load, wheel.label);
                (wheel, load)
            })
            .collect()
    }

    /// A second method to the couple of the wheels: the difference quotient of the angular momentum of the tilted pair,
    /// turned as a whole. In a turn to the left the axle points left, and down on a bank.
    fn check_by_rotation<W: Worksheet>(
        &self,
        inertia: f64,
        spin: f64,
        rate: f64,
        [couple, load]: [W::Num; 2],
        sheet: W,
    ) {
        let axle = Vector3::new(0.0, self.bank.cos(), -self.bank.sin());
        let transverse = self.transverse_inertia.map_or(inertia, |transverse| transverse * self.axles());
        let tensor = gyroscope::symmetric_tensor(inertia, transverse, axle);
        let about = Vector3::z() * rate;
        let momentum_at = |t: f64| {
            let vehicle = nalgebra::Rotation3::from_scaled_axis(about * t);
            rigid::turned(&tensor, &vehicle) * (about + vehicle * axle * spin)
        };
        let period = if rate > 0.0 { TAU / rate } else { 1.0 };
        let Ok(derivative) = rigid::numerical_rate(momentum_at, period) else { return };
        // The couple on the wheels is about the backward direction.
        sheet.check_zero(
            "the couple of the wheels from the difference quotient of R I Rᵀ ω",
            W::Num::from(-derivative.x - couple.value()),
            Vector::value(momentum_at(0.0)).norm() * TAU / period,
        );
        sheet.check_zero(
            "moments of the loads from the couple of the wheels from the same difference quotient",
            W::Num::from(-derivative.x - load.value() * self.track * self.axles()),
            Vector::value(momentum_at(0.0)).norm() * TAU / period,
        );
    }

    /// The same for the engine: across, about the long axis of the vehicle; along, about the axis across the road.
    fn check_engine<W: Worksheet>(&self, wheel_speed: f64, rate: f64, couple: W::Num, sheet: W) {
        let Some(engine) = &self.engine else { return };
        let across = Vector3::new(0.0, self.bank.cos(), -self.bank.sin());
        let (axle, about) = if engine.lies_along() { (Vector3::x(), across) } else { (across, Vector3::x()) };
        let momentum = engine.inertia * engine.ratio * wheel_speed;
        let at = |t: f64| nalgebra::Rotation3::from_scaled_axis(Vector3::z() * (rate * t)) * axle * momentum;
        let Ok(change) = rigid::numerical_rate(at, TAU / rate) else { return };
        let what = "couple of the engine from the difference quotient of its angular momentum";
        sheet.check_sum(
            what,
            couple.abs(),
            nalgebra::Matrix::dot(&change, &about).abs().into(),
            momentum * rate,
        );
    }
}
