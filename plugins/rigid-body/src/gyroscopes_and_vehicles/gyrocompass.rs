//! A gyrocompass: a rotor with a level axle on the turning Earth, which swings about the meridian.

mod damping;
mod level;
mod pendulous;

use std::f64::consts::{FRAC_PI_2, TAU};

use dalembert_core::{
    About, Analysis, Axis, Drawing, Exhibit, Ink, Inputs, Plot, Refusal, Series, Sketch, Worksheet, register,
};
use dalembert_mechanics::Real;

use crate::{
    shared::{flat::letters, gyro_rotor::GyroRotor},
    sources::{KIBBLE, SCHULER},
};
pub use damping::{CompassDamping, CompassDampingGiven, CompassDampingMeasure};

/// A rotor whose axle turns freely about the vertical, at a place on the Earth or on a vessel.
///
/// Deviations of the axle are from the meridian towards the west.
#[derive(Clone, Debug, Inputs)]
pub struct Gyrocompass {
    /// Rotor.
    pub rotor: GyroRotor,
    /// Speed of the rotor.
    /// In space, about its axle. Left out where the rotor is given by its angular momentum.
    #[input("ω", "rad/s", positive)]
    pub spin: Option<f64>,
    /// Support of the axle.
    pub support: AxleSupport,
    /// Latitude.
    /// Positive north of the equator.
    #[input("λ", "deg", min = -90, max = 90)]
    pub latitude: f64,
    /// Vessel.
    /// Left out for a compass at rest on the Earth.
    pub vessel: Option<Vessel>,
    /// Damping and settling.
    /// Left out for the undamped compass.
    pub damping: Option<CompassDamping>,
    /// Angular velocity of the Earth.
    #[input("Ω", "rad/s", positive, default = "7.2921e-5 rad/s")]
    pub earth: f64,
}

/// Support of the axle of a gyrocompass.
#[derive(Clone, Debug, Inputs)]
pub enum AxleSupport {
    /// Axle held level
    /// It turns in a level circle, and its inertia carries it past the meridian.
    Level {
        /// Transverse moment of inertia.
        /// Of all that turns about the vertical with the axle.
        #[input("I_t", "kg*m^2", positive)]
        transverse: f64,
        /// Initial deviation.
        /// Of the axle from its settled direction, where it is released from rest.
        #[input("α₀", "deg", min = 0, below = 180, default = "0 deg")]
        deviation: f64,
    },
    /// Pendulous
    /// The centre of mass lies below the support, and gravity makes the tilted axle precess. The inertia of rotor and
    /// frame is neglected beside the angular momentum.
    Pendulous {
        /// Suspended mass.
        #[input("m_s", "kg", positive)]
        mass: f64,
        /// Depth of the centre of mass.
        /// Below the support.
        #[input("l", "m", positive)]
        depth: f64,
        /// Acceleration of gravity.
        #[input("g", "m/s^2", positive, default = "9.81 m/s^2")]
        gravity: f64,
        /// Radius of the Earth.
        #[input("R_E", "m", positive, default = "6371 km")]
        radius: f64,
    },
}

/// Motion of the vessel that carries a compass.
#[derive(Clone, Debug, Inputs)]
pub struct Vessel {
    /// Speed.
    #[input("v", "m/s", nonnegative)]
    pub speed: f64,
    /// Course.
    /// From north, clockwise.
    #[input("C", "deg")]
    pub course: f64,
    /// Radius of the Earth.
    #[input("R_E", "m", positive, default = "6371 km")]
    pub radius: f64,
}

register!(Gyrocompass);

impl Analysis for Gyrocompass {
    const ABOUT: About = About {
        id: "rigid-body/gyrocompass",
        title: "Gyrocompass",
        topic: "Gyroscopes and vehicles",
        summary: "Period of a gyrocompass about the meridian, directing couple, damping and settling time, tilt and Schuler tuning of a pendulous one, and its deviation on a moving vessel.",
        main: &["period", "deviation", "damping_ratio"],
        keywords: "gyrocompass gyro compass meridian north-seeking Schuler tuning 84.4 min steaming speed error latitude Earth rotation \
                   bússola giroscópica girocompasso agulha giroscópica meridiano norte rotação da Terra erro de velocidade",
        sources: &[&KIBBLE, &SCHULER],
        cases: include_str!("../../cases/gyrocompass.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &GyrocompassGiven<W>, sheet: W) -> Result<(), Refusal> {
        let rotor = given.rotor.spinning(given.spin, sheet)?;
        let momentum = if rotor.axial.is_some() {
            sheet.step("h_s", "kg*m^2/s", rotor.momentum, "Angular momentum of the rotor about its axle")
        } else {
            rotor.momentum
        };
        let rates = Rates::work(given, sheet)?;
        let (plotted, period) = match &given.support {
            AxleSupportGiven::Level { transverse, deviation } => {
                level::answer(momentum, *transverse, *deviation, rates.horizontal, sheet)?
            }
            AxleSupportGiven::Pendulous { mass, depth, gravity, radius } => {
                let weight = sheet.step(
                    "B",
                    "N*m",
                    *mass * *gravity * *depth,
                    "Moment of the weight about the support with the axle upright",
                );
                let pendulum = pendulous::Pendulum {
                    momentum,
                    weight,
                    mass: *mass,
                    depth: *depth,
                    gravity: *gravity,
                    radius: *radius,
                };
                pendulum.answer(&rates, sheet)
            }
        };
        if let Some(damping) = &given.damping {
            let transverse = match &given.support {
                AxleSupportGiven::Level { transverse, .. } => Some(*transverse),
                AxleSupportGiven::Pendulous { .. } => None,
            };
            damping::answer(damping, period, transverse, sheet)?;
        }
        if self.vessel.is_none() {
            sheet.show(|| Exhibit::Plot(self.over_latitude(&plotted)));
        }
        let settled = rates.deviation.map_or(0.0, Real::value);
        let released = match self.support {
            AxleSupport::Level { deviation, .. } => settled + deviation,
            AxleSupport::Pendulous { .. } => settled,
        };
        sheet.show(|| Exhibit::Drawing(self.sketch(settled, released)));
        Ok(())
    }
}

/// The angular velocity of the level plane at the place.
struct Rates<N> {
    /// Horizontal component, along which the compass settles, rad/s.
    horizontal: N,
    /// Vertical component, upwards, rad/s.
    vertical: N,
    /// Angle of the horizontal component from north to the west, where there is a vessel, rad.
    deviation: Option<N>,
}

/// A horizontal component that is smaller than this part of the whole is none.
const POLE: f64 = 1e-9;

impl<N: Real> Rates<N> {
    fn work<W: Worksheet<Num = N>>(given: &GyrocompassGiven<W>, sheet: W) -> Result<Self, Refusal> {
        let (sin, cos) = (given.latitude.sin(), given.latitude.cos());
        if cos.value() <= POLE {
            return Err(Refusal::because(
                "at a pole the axis of the Earth is vertical and every direction leads along a meridian: write a latitude between −90° and 90°",
            ));
        }
        // An axle that is held level is not tilted by the vertical component.
        let tilts = matches!(given.support, AxleSupportGiven::Pendulous { .. });
        let upwards =
            |rate: N, why: &'static str| if tilts { sheet.step("Ω_v", "rad/s", rate, why) } else { rate };
        let Some(vessel) = &given.vessel else {
            let horizontal = sheet.step(
                "Ω_h",
                "rad/s",
                given.earth * cos,
                (
                    "Horizontal component of the angular velocity of the Earth, to the north",
                    KIBBLE.at("ch. 9"),
                ),
            );
            let why = "Vertical component of the angular velocity of the Earth, upwards";
            let vertical = upwards(given.earth * sin, why);
            return Ok(Self { horizontal, vertical, deviation: None });
        };
        let north = sheet.step("v_N", "m/s", vessel.speed * vessel.course.cos(), "Velocity to the north");
        let east = sheet.step("v_E", "m/s", vessel.speed * vessel.course.sin(), "Velocity to the east");
        let about = sheet.step(
            "Ω₁",
            "rad/s",
            given.earth + east / (vessel.radius * cos),
            "Angular velocity of Earth and vessel about the axis of the Earth",
        );
        let along = sheet.step("Ω_N", "rad/s", about * cos, "Its horizontal component, to the north");
        let of_parallel = || north / (vessel.radius * cos);
        sheet.common_error("Ω_W", "radius of the parallel used for the motion to the north", of_parallel);
        let west = sheet.step(
            "Ω_W",
            "rad/s",
            north / vessel.radius,
            "The way to the north turns the level plane about the west",
        );
        let horizontal = sheet.step(
            "Ω_h",
            "rad/s",
            (along.powi(2) + west.powi(2)).sqrt(),
            "Angular velocity of the level plane: horizontal component",
        );
        let size = (given.earth + vessel.speed / vessel.radius).value();
        if horizontal.value() <= POLE * size {
            return Err(Refusal::because(
                "the vessel runs to the west as fast as the Earth turns to the east: no direction is left to the compass; write a lower speed",
            ));
        }
        let vertical = upwards(about * sin, "Vertical component, upwards");
        let deviation = sheet.step(
            "δ",
            "deg",
            west.atan2(along),
            (
                "The axle settles along the horizontal component: deviation from north to the west",
                SCHULER.at("§2"),
            ),
        );
        sheet.answer("deviation", "Deviation due to the speed, to the west", deviation);
        sheet.verify(|| {
            // The horizontal component is the vertical crossed with the velocity in space, over the radius.
            let (over_ground, ground) = (vessel.speed, vessel.radius * given.earth * cos);
            let what = "the axle is normal to the velocity of the vessel in space";
            let across = over_ground * (vessel.course + deviation).cos();
            let size = (over_ground + ground).value();
            sheet.check_sum(what, across, ground * deviation.sin(), size);
        });
        Ok(Self { horizontal, vertical, deviation: Some(deviation) })
    }
}

/// The period shown in the plot, and a period at another latitude with its level and vertical angular velocities.
struct Plotted<'a> {
    answer: &'static str,
    here: f64,
    at: Box<dyn Fn([f64; 2]) -> f64 + 'a>,
}

impl Gyrocompass {
    fn over_latitude(&self, plotted: &Plotted<'_>) -> Plot {
        let sign = if self.latitude < 0.0 { -1.0 } else { 1.0 };
        let most = (1.1 * self.latitude.abs()).max(1.4).min(0.5 * (FRAC_PI_2 + self.latitude.abs()));
        let at = |n: u16| {
            let latitude = most * f64::from(n) / 160.0 * sign;
            let (sin, cos) = latitude.sin_cos();
            (latitude, (plotted.at)([self.earth * cos, self.earth * sin]))
        };
        Plot::new(
            "Period against latitude",
            Axis::linear("latitude", "deg"),
            Axis::linear("period", "s"),
            vec![Series::line("T", (0..=160).map(at).collect()).of(plotted.answer)],
        )
        .over("latitude")
        .mark("at this latitude", (self.latitude, plotted.here))
    }
}

impl Gyrocompass {
    /// The compass from above, and the earth from its side with the place of the compass.
    fn sketch(&self, settled: f64, released: f64) -> Drawing {
        let mut sketch = Sketch::new("The compass from above, and its place on the earth");
        self.seen_from_above(&mut sketch, settled, released);
        // The earth: its axis upright, the latitude from the equator to the place.
        let (x, y, radius) = (3.3, 0.0, 1.0);
        let (sin, cos) = self.latitude.sin_cos();
        let place = (x + radius * cos, y + radius * sin);
        let out = (place.0 + 0.45 * cos, place.1 + 0.45 * sin);
        sketch
            .circle((x, y), radius, Ink::Body)
            .axis((x - 1.2, y), (x + 1.2, y))
            .link("", (x, y - 1.3), (x, y + 1.15))
            .motion("Ω", (x, y + 1.0), (x, y + 1.5))
            .axis((x, y), out)
            .angle("λ", (x, y), 0.0, self.latitude)
            .joint("", place);
        let radius_known = matches!(self.support, AxleSupport::Pendulous { .. }) || self.vessel.is_some();
        if radius_known {
            sketch.line("R_E", (x, y), (x - radius * 0.7, y + radius * 0.714), Ink::Faint);
        }
        sketch.finish()
    }

    fn seen_from_above(&self, sketch: &mut Sketch, settled: f64, released: f64) {
        let at = |angle: f64, length: f64| (-length * angle.sin(), length * angle.cos());
        let (tip, tail) = (at(released, 1.0), at(released, -1.0));
        let across = |along: f64, side: f64| {
            let ((x, y), (u, v)) = (at(released, along), at(released + TAU / 4.0, side));
            (x + u, y + v)
        };
        let letters = match self.support {
            AxleSupport::Level { .. } => letters(&[self.rotor.letters(), "I_t"]),
            AxleSupport::Pendulous { .. } => letters(&[self.rotor.letters(), "m_s"]),
        };
        sketch
            .axis((0.0, -1.3), (0.0, 1.5))
            .label("N", (0.0, 1.5))
            .circle((0.0, 0.0), 1.1, Ink::Faint)
            .bars([tail, tip])
            .body("", [across(-0.1, -0.6), across(0.1, -0.6), across(0.1, 0.6), across(-0.1, 0.6)])
            .label(letters, across(-0.1, -0.6))
            .motion("ω", tip, at(released, 1.45))
            .motion("Ω_h", (0.0, 0.0), at(settled, 0.8));
        if !self.rotor.radius_letter().is_empty() {
            sketch.dimension(self.rotor.radius_letter(), across(0.1, 0.0), across(0.1, 0.6), 1.0);
        }
        if settled.abs() > 0.02 {
            sketch.angle("δ", (0.0, 0.0), FRAC_PI_2, FRAC_PI_2 + settled);
        }
        if let AxleSupport::Level { .. } = self.support {
            sketch.angle("α₀", (0.0, 0.0), FRAC_PI_2 + settled, FRAC_PI_2 + released);
        }
        if let AxleSupport::Pendulous { .. } = self.support {
            // The weight hangs below the axle: seen from its end.
            let (x, y) = (1.6, -0.2);
            sketch
                .circle((x, y), 0.3, Ink::Body)
                .link("", (x, y), (x, y - 0.9))
                .disc("", (x, y - 0.9), 0.12)
                .dimension("l", (x, y), (x, y - 0.9), 2.5);
        }
        if let Some(vessel) = &self.vessel {
            let (sin, cos) = vessel.course.sin_cos();
            sketch.motion("v", (0.0, 0.0), (1.4 * sin, 1.4 * cos)).angle(
                "C",
                (0.0, 0.0),
                FRAC_PI_2,
                FRAC_PI_2 - vessel.course,
            );
        }
    }
}
