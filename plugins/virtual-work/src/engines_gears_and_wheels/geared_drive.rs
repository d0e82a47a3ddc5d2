//! A motor that moves a load through gears, with their efficiency in the direction in which power flows.

use dalembert_core::{
    About, Analysis, Axis, Drawing, Exhibit, Ink, Inputs, Plot, Refusal, Series, Sketch, Worksheet, register,
};
use dalembert_mechanics::Real;

use crate::sources::KHURMI;

/// A motor, a pair of gears or a train, and what they move.
///
/// Forward is the sense in which a hoist raises and a vehicle climbs; torques of the motor are positive in it.
#[derive(Clone, Debug, Inputs)]
pub struct GearedDrive {
    /// Inertia on the motor shaft.
    /// Of all that turns with the motor.
    #[input("I_m", "kg*m^2", nonnegative)]
    pub motor_inertia: f64,
    /// Gear ratio.
    /// Speed of the motor over that of the driven shaft.
    #[input("G", "1", positive)]
    pub ratio: f64,
    /// Efficiency of the gears.
    /// Power that leaves them over the power that enters, from the motor to the load or from the load to the motor.
    #[input("η", "%", positive, max = 100, default = "100 %")]
    pub efficiency: f64,
    /// Load.
    pub load: DrivenLoad,
    /// Motion.
    #[input(default = "rest")]
    pub motion: DriveMotion,
    /// Find.
    pub sought: DriveUnknown,
    /// Speed of the driven shaft.
    /// At which the power is required, and up to which the time from rest.
    #[input("ω_2", "rpm", positive)]
    pub speed: Option<f64>,
}

/// Load of the driven shaft.
#[derive(Clone, Debug, Inputs)]
pub enum DrivenLoad {
    /// Shaft with a torque
    Shaft {
        /// Inertia on the driven shaft.
        #[input("I_2", "kg*m^2", nonnegative)]
        inertia: f64,
        /// Torque of the load.
        /// On the driven shaft, positive against forward motion.
        #[input("T_2", "N*m", default = "0 N*m")]
        torque: f64,
    },
    /// Hoist: a mass on a drum
    Hoist {
        /// Mass.
        #[input("m", "kg", positive)]
        mass: f64,
        /// Radius of the drum.
        #[input("r", "m", positive)]
        radius: f64,
        /// Inertia on the shaft of the drum.
        #[input("I_2", "kg*m^2", nonnegative, default = "0 kg*m^2")]
        inertia: f64,
        /// Acceleration of gravity.
        #[input("g", "m/s^2", positive, default = "9.81 m/s^2")]
        gravity: f64,
    },
    /// Vehicle
    Vehicle {
        /// Mass of the vehicle.
        #[input("m", "kg", positive)]
        mass: f64,
        /// Radius of the wheels.
        #[input("r", "m", positive)]
        radius: f64,
        /// Inertia of the wheels.
        /// Of all wheels with their axles.
        #[input("I_2", "kg*m^2", nonnegative, default = "0 kg*m^2")]
        inertia: f64,
        /// Resistance.
        /// Against the motion: rolling and air.
        #[input("F_r", "N", nonnegative, default = "0 N")]
        resistance: f64,
        /// Slope of the road.
        /// Positive where forward is uphill.
        #[input("θ", "deg", above = -90, below = 90, default = "0 deg")]
        slope: f64,
        /// Acceleration of gravity.
        #[input("g", "m/s^2", positive, default = "9.81 m/s^2")]
        gravity: f64,
    },
}

/// Motion of the drive at the examined moment.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum DriveMotion {
    /// From rest
    Rest,
    /// Forward
    Forward,
    /// Backward
    Backward,
}

/// Acceleration or torque.
#[derive(Clone, Debug, Inputs)]
pub enum DriveUnknown {
    /// Acceleration under a motor torque
    Acceleration {
        /// Torque of the motor.
        #[input("T_m", "N*m")]
        torque: f64,
    },
    /// Motor torque for an acceleration
    Torque {
        /// Angular acceleration of the driven shaft.
        #[input("α_2", "rad/s^2", default = "0 rad/s^2")]
        acceleration: f64,
    },
}

register!(GearedDrive);

/// The drive reduced to its two shafts.
#[derive(Clone, Copy)]
struct Reduced {
    motor: f64,
    ratio: f64,
    efficiency: f64,
    inertia: f64,
    /// Torque of the load without what opposes the motion.
    torque: f64,
    /// Torque of what opposes the motion.
    resistance: f64,
}

impl Reduced {
    fn load(&self, forward: f64) -> f64 {
        self.torque + forward * self.resistance
    }

    /// Acceleration of the driven shaft in a direction of motion, and whether the motor drives the load.
    fn acceleration(&self, torque: f64, forward: f64) -> (f64, bool) {
        let of = |gain: f64| {
            (self.ratio * gain * torque - self.load(forward))
                / (self.inertia + self.ratio * self.ratio * self.motor * gain)
        };
        let driven = of(self.efficiency);
        let passed = self.inertia * driven + self.load(forward);
        if passed * forward >= 0.0 { (driven, true) } else { (of(1.0 / self.efficiency), false) }
    }
}

impl Analysis for GearedDrive {
    const ABOUT: About = About {
        id: "virtual-work/geared-drive",
        title: "Geared drive",
        topic: "Engines, gears and wheels",
        summary: "Acceleration of a shaft, hoist or vehicle that a motor drives through gears, or the motor torque for it, with the gear efficiency by the direction of power; gear ratio of the maximum acceleration.",
        main: &["acceleration", "best_ratio", "torque", "power"],
        keywords: "geared system hoist winding drum vehicle efficiency of gears overrunning driving equivalent inertia reflected inertia \
                   acionamento redutor rendimento guincho veículo inércia equivalente relação de transmissão aceleração",
        sources: &[&KHURMI],
        cases: include_str!("../../cases/geared_drive.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &GearedDriveGiven<W>, sheet: W) -> Result<(), Refusal> {
        let GearedDriveGiven { motor_inertia, ratio, efficiency, .. } = *given;
        let shaft = shaft(&given.load, sheet);
        let reduced = Reduced {
            motor: self.motor_inertia,
            ratio: self.ratio,
            efficiency: self.efficiency,
            inertia: shaft.inertia.value(),
            torque: shaft.torque.map_or(0.0, Real::value),
            resistance: shaft.resistance.map_or(0.0, Real::value),
        };
        if reduced.inertia == 0.0 && reduced.motor == 0.0 {
            return Err(Refusal::because(
                "nothing has inertia: write that of the motor shaft or of the load",
            ));
        }
        let (forward, drives) = self.flow(&reduced)?;
        let load = shaft.load(forward, sheet);
        let gain = if drives { efficiency } else { W::Num::from(1.0) / efficiency };
        let words = if drives {
            "Inertia referred to the driven shaft: the motor drives the load, and the gears pass on the part η"
        } else {
            "Inertia referred to the driven shaft: the load drives the motor, and the gears take 1/η"
        };
        let cite = KHURMI.at("ch. 3");
        let on_motor = || shaft.inertia / ratio.powi(2) + motor_inertia;
        sheet.common_error("I_e", "the inertias referred to the motor shaft", on_motor);
        let total =
            sheet.step("I_e", "kg*m^2", shaft.inertia + ratio.powi(2) * motor_inertia * gain, (words, cite));
        let (torque, acceleration) = match given.sought {
            DriveUnknownGiven::Acceleration { torque } => {
                let why = ("Angular acceleration of the driven shaft", cite);
                let sum = ratio * gain * torque;
                let sum = load.map_or(sum, |load| sum - load);
                let acceleration = sheet.step("α_2", "rad/s^2", sum / total, why);
                sheet.answer("acceleration", "Acceleration of the driven shaft", acceleration);
                (torque, acceleration)
            }
            DriveUnknownGiven::Torque { acceleration } => {
                let why = ("Motor torque for that acceleration", cite);
                let sum = total * acceleration;
                let sum = load.map_or(sum, |load| sum + load);
                let torque = sheet.step("T_m", "N*m", sum / (ratio * gain), why);
                sheet.answer("torque", "Motor torque", torque);
                (torque, acceleration)
            }
        };
        let fast = sheet.step("α_m", "rad/s^2", ratio * acceleration, "Angular acceleration of the motor");
        sheet.answer("motor_acceleration", "Acceleration of the motor", fast);
        if let Some(radius) = shaft.radius {
            let linear = sheet.step("a", "m/s^2", radius * acceleration, "Acceleration of the mass");
            sheet.answer("linear_acceleration", "Acceleration of the mass", linear);
            sheet.check(
                "accelerations of the mass and of the motor by the radius and the ratio",
                linear * ratio,
                fast * radius,
            );
        }
        let passed = shaft.inertia * acceleration;
        let why = "Torque of the gears on the driven shaft";
        sheet.common_error(
            "T_g",
            "the motor torque times the ratio taken, the inertia of the motor neglected",
            || ratio * gain * torque,
        );
        let passed = sheet.step("T_g", "N*m", load.map_or(passed, |load| passed + load), why);
        sheet.answer("gear_torque", "Torque of the gears, driven shaft", passed);
        sheet.verify(|| {
            // Equation of motion of the motor shaft alone, with the loss in the gears.
            let before = ratio * (torque - motor_inertia * fast);
            let size = (ratio * torque).value().abs() + (ratio * motor_inertia * fast).value().abs();
            let what = if drives {
                "power that leaves the gears: η of what the motor gives beyond its own inertia"
            } else {
                "power that reaches the motor and its inertia: η of what the load gives to the gears"
            };
            let (out, enters) = if drives { (passed, before) } else { (before, passed) };
            sheet.check_sum(what, out, efficiency * enters, size + passed.value().abs());
            let what = "acceleration of the motor from its own shaft";
            let own = torque - passed / (ratio * gain);
            sheet.check_sum(what, motor_inertia * fast, own, size / self.ratio);
        });
        if let Some(speed) = given.speed {
            sheet.common_error("P", "the power on the driven shaft taken", || passed * speed);
            let power = sheet.step("P", "kW", torque * ratio * speed, "Power of the motor at that speed");
            sheet.answer("power", "Power of the motor at that speed", power);
            sheet.check_sum(
                "power of the gears and of the inertia of the motor shaft",
                power,
                (passed / gain + ratio * motor_inertia * fast) * speed,
                (torque * ratio * speed).value().abs() + (passed * speed).value().abs(),
            );
            if acceleration.value() * forward > 0.0 {
                let why = "Time from rest up to that speed";
                let time = sheet.step("t", "s", speed / acceleration.abs(), why);
                sheet.answer("time", "Time from rest up to that speed", time);
                sheet.check(
                    "angle turned meanwhile, from the mean speed",
                    acceleration.abs() * time.powi(2),
                    speed * time,
                );
            }
        }
        if let DriveUnknownGiven::Acceleration { torque } = given.sought
            && drives
            && torque.value() * forward > 0.0
            && reduced.motor > 0.0
        {
            best_ratio(given, &shaft, (torque, load), sheet);
        }
        sheet.show(|| Exhibit::Plot(self.over_ratio(&reduced, forward, torque.value())));
        sheet.show(|| Exhibit::Drawing(self.drawing()));
        Ok(())
    }
}

/// Ratio of the maximum acceleration of the driven shaft.
fn best_ratio<W: Worksheet>(
    given: &GearedDriveGiven<W>,
    shaft: &Shaft<W::Num>,
    (torque, load): (W::Num, Option<W::Num>),
    sheet: W,
) {
    let GearedDriveGiven { motor_inertia, efficiency, .. } = *given;
    let share = shaft.inertia / (motor_inertia * efficiency);
    let value = match load {
        None => share.sqrt(),
        Some(load) => {
            let half = load / (efficiency * torque);
            half + (half.powi(2) + share).sqrt()
        }
    };
    if value.value() <= 0.0 {
        return;
    }
    let why =
        ("Gear ratio of the maximum acceleration of the driven shaft, from dα₂/dG = 0", KHURMI.at("ch. 3"));
    let best = sheet.step("G_o", "1", value, why);
    sheet.answer("best_ratio", "Gear ratio of maximum acceleration", best);
    sheet.verify(|| {
        let total = shaft.inertia + best.powi(2) * motor_inertia * efficiency;
        let sum = best * efficiency * torque;
        let sum = load.map_or(sum, |load| sum - load);
        let what = "the acceleration does not change with the ratio there";
        sheet.check_sum(
            what,
            efficiency * torque * total,
            sum * best * motor_inertia * efficiency * 2.0,
            (efficiency * torque * total).value().abs(),
        );
    });
}

/// The driven shaft as numbers of a worksheet.
struct Shaft<N> {
    inertia: N,
    /// Torque of the load.
    torque: Option<N>,
    /// Torque against the motion.
    resistance: Option<N>,
    radius: Option<N>,
}

impl<N: Real> Shaft<N> {
    /// Torque of the load in a direction of motion; none where it is nothing.
    fn load<W: Worksheet<Num = N>>(&self, forward: f64, sheet: W) -> Option<N> {
        match (self.torque, self.resistance) {
            (torque, None) => torque,
            (torque, Some(resistance)) => {
                let against = if forward < 0.0 { -resistance } else { resistance };
                let why = "Torque of the load in this direction of motion";
                Some(sheet.step("T_2", "N*m", torque.map_or(against, |torque| torque + against), why))
            }
        }
    }
}

/// Inertia and torques of the load at the driven shaft.
fn shaft<W: Worksheet>(load: &DrivenLoadGiven<W>, sheet: W) -> Shaft<W::Num> {
    match *load {
        DrivenLoadGiven::Shaft { inertia, torque } => {
            let torque = (torque.value() != 0.0).then_some(torque);
            Shaft { inertia, torque, resistance: None, radius: None }
        }
        DrivenLoadGiven::Hoist { mass, radius, inertia, gravity } => {
            let why = "Inertia at the driven shaft, with that of the mass";
            let inertia = sheet.step("I", "kg*m^2", inertia + mass * radius.powi(2), why);
            let torque = sheet.step("T_2", "N*m", mass * gravity * radius, "Torque of the weight");
            Shaft { inertia, torque: Some(torque), resistance: None, radius: Some(radius) }
        }
        DrivenLoadGiven::Vehicle { mass, radius, inertia, resistance, slope, gravity } => {
            let why = "Inertia at the driven shaft, with that of the mass";
            let inertia = sheet.step("I", "kg*m^2", inertia + mass * radius.powi(2), why);
            let torque = (slope.value() != 0.0).then(|| {
                let why = "Torque of the weight on the slope";
                sheet.step("T_s", "N*m", mass * gravity * slope.sin() * radius, why)
            });
            let resistance = (resistance.value() > 0.0)
                .then(|| sheet.step("T_r", "N*m", resistance * radius, "Torque of the resistance to motion"));
            Shaft { inertia, torque, resistance, radius: Some(radius) }
        }
    }
}

impl GearedDrive {
    /// The direction of motion, 1 forward, and whether the motor drives the load.
    fn flow(&self, reduced: &Reduced) -> Result<(f64, bool), Refusal> {
        let asked = match self.motion {
            DriveMotion::Forward => Some(1.0),
            DriveMotion::Backward => Some(-1.0),
            DriveMotion::Rest => None,
        };
        match self.sought {
            DriveUnknown::Acceleration { torque } => {
                let directions = asked.map_or(vec![1.0, -1.0], |one| vec![one]);
                let found = directions.into_iter().find_map(|forward| {
                    let (acceleration, drives) = reduced.acceleration(torque, forward);
                    (asked.is_some() || acceleration * forward > 0.0).then_some((forward, drives))
                });
                found.ok_or_else(|| {
                    Refusal::because(
                        "the drive stays at rest under this torque: write another torque, or choose the direction in which it moves",
                    )
                })
            }
            DriveUnknown::Torque { acceleration } => {
                let forward = match asked {
                    Some(forward) => forward,
                    None if acceleration == 0.0 => {
                        return Err(Refusal::because(
                            "without acceleration nothing leaves its rest: choose the direction of the motion",
                        ));
                    }
                    None => acceleration.signum(),
                };
                let passed = reduced.inertia * acceleration + reduced.load(forward);
                Ok((forward, passed * forward >= 0.0))
            }
        }
    }

    /// Acceleration of the driven shaft over the gear ratio, under the same motor torque.
    fn over_ratio(&self, reduced: &Reduced, forward: f64, torque: f64) -> Plot {
        let at = |n: u16| {
            let ratio = self.ratio * f64::from(n) / 40.0;
            (ratio, Reduced { ratio, ..*reduced }.acceleration(torque, forward).0)
        };
        let series = Series::line("α_2", (4..=120).map(at).collect());
        let by_torque = matches!(self.sought, DriveUnknown::Acceleration { .. });
        let series = if by_torque { series.of("acceleration") } else { series };
        let plot = Plot::new(
            "Acceleration of the driven shaft against the gear ratio",
            Axis::linear("gear ratio", "1"),
            Axis::linear("acceleration of the driven shaft", "rad/s^2"),
            vec![series],
        );
        let plot = if by_torque && self.motion != DriveMotion::Rest { plot.over("ratio") } else { plot };
        plot.mark("at this ratio", (self.ratio, reduced.acceleration(torque, forward).0))
    }

    fn drawing(&self) -> Drawing {
        let mut sketch = Sketch::new("The motor, the gears and the load");
        let small = 0.5;
        sketch
            .mass("I_m", (-3.2, -0.5), (-2.0, 0.5))
            .link("", (-2.0, 0.0), (-small, 0.0))
            .gear("", (0.0, 0.0), small, 0.0)
            .gear("", (0.0, -1.9), 1.4, 0.1)
            .couple("T_m", (-3.6, 0.0), (0.6, 5.0), Ink::Force);
        match self.load {
            DrivenLoad::Shaft { torque, .. } => {
                sketch.link("", (1.4, -1.9), (2.4, -1.9)).mass("I_2", (2.4, -2.6), (3.4, -1.2));
                if torque != 0.0 {
                    sketch.couple("T_2", (3.8, -1.9), (2.6, -1.8), Ink::Force);
                }
            }
            DrivenLoad::Hoist { inertia, .. } => {
                sketch
                    .link("", (1.4, -1.9), (2.4, -1.9))
                    .disc("", (3.0, -1.9), 0.6)
                    .dimension("r", (3.0, -1.9), (3.0, -1.3), 0.0)
                    .label(if inertia == 0.0 { "" } else { "I_2" }, (3.6, -1.9))
                    .cord([(3.6, -1.9), (3.6, -3.6)])
                    .mass("m", (3.3, -4.2), (3.9, -3.6));
            }
            DrivenLoad::Vehicle { inertia, resistance, slope, .. } => {
                if resistance != 0.0 {
                    sketch.force("F_r", (4.9, -1.9), (4.1, -1.9));
                }
                if slope != 0.0 {
                    sketch.axis((2.0, -2.7), (4.6, -2.7 - 2.6 * slope.tan())).angle(
                        "θ",
                        (2.0, -2.7),
                        -slope,
                        0.0,
                    );
                }
                sketch
                    .link("", (1.4, -1.9), (2.4, -1.9))
                    .disc(if inertia == 0.0 { "" } else { "I_2" }, (3.2, -1.9), 0.8)
                    .line("r", (3.2, -1.9), (3.2, -2.7), Ink::Faint)
                    .mass("m", (2.6, -1.1), (3.8, -0.6))
                    .ground((2.0, -2.7), (4.6, -2.7));
            }
        }
        sketch.finish()
    }
}
