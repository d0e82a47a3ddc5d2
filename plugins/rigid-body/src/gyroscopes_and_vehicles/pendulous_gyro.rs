//! A spinning wheel in a frame that hangs from a fore-and-aft axis, on a vehicle in a turn.

use std::f64::consts::FRAC_PI_2;

use dalembert_core::{
    About, Analysis, Axis, Drawing, Exhibit, Inputs, Plot, Refusal, Series, Sketch, Worksheet, register,
};
use dalembert_mechanics::Real;
use nalgebra::Vector3;

use crate::{
    shared::{flat::into_page, gyro_rotor::GyroRotor},
    sources::{BEER, KHURMI},
};

/// A wheel whose centre lies on the axis about which its frame swings, with its axle across the vehicle when the frame is
/// upright.
///
/// The radius of the turn is large compared with the frame, and the rate of turn small compared with the speed of the
/// wheel.
#[derive(Clone, Debug, Inputs)]
pub struct PendulousGyro {
    /// Wheel.
    pub wheel: GyroRotor,
    /// Speed of the wheel.
    /// Relative to the frame. Left out where the wheel is given by its angular momentum.
    #[input("ω", "rad/s", positive)]
    pub spin: Option<f64>,
    /// Sense of the wheel.
    pub sense: WheelSense,
    /// Mass of the frame.
    #[input("m_f", "kg", positive)]
    pub frame: f64,
    /// Depth of its centre of mass.
    /// Of the frame, below the axis about which it swings.
    #[input("h", "m", positive)]
    pub depth: f64,
    /// Speed of the vehicle.
    #[input("v", "m/s", nonnegative)]
    pub speed: f64,
    /// Radius of the turn.
    #[input("R", "m", positive)]
    pub radius: f64,
    /// Acceleration of gravity.
    #[input("g", "m/s^2", positive, default = "9.81 m/s^2")]
    pub gravity: f64,
}

/// Sense of the wheel, compared with a road wheel of the vehicle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum WheelSense {
    /// As the road wheels roll
    AsRoadWheels,
    /// Opposite to the road wheels
    Opposite,
}

impl WheelSense {
    /// The sign of the outward moment of the gyroscopic couple.
    fn outward(self) -> f64 {
        match self {
            WheelSense::AsRoadWheels => -1.0,
            WheelSense::Opposite => 1.0,
        }
    }
}

register!(PendulousGyro);

impl Analysis for PendulousGyro {
    const ABOUT: About = About {
        id: "rigid-body/pendulous-gyro",
        title: "Pendulous gyroscope on a vehicle in a turn",
        topic: "Gyroscopes and vehicles",
        summary: "Inclination of a frame with a spinning wheel that hangs from a fore-and-aft axis, under the gyroscopic couple, the centrifugal force and the weight.",
        main: &["inclination", "gyroscopic_couple"],
        keywords: "pendulous gyro gyroscope pivoted frame gyro-wheel inclination turn vehicle giroscópio pendular quadro articulado \
                   inclinação curva veículo",
        sources: &[&KHURMI, &BEER],
        cases: include_str!("../../cases/pendulous_gyro.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &PendulousGyroGiven<W>, sheet: W) -> Result<(), Refusal> {
        let wheel = given.wheel.spinning(given.spin, sheet)?;
        let momentum = wheel.momentum;
        let rate = sheet.step("Ω", "rad/s", given.speed / given.radius, "Rate of turn");
        let gyroscopic = sheet.step(
            "C_g",
            "N*m",
            momentum * rate,
            (
                "Gyroscopic couple with the frame upright; at the inclination θ it is C_g cos θ",
                KHURMI.at("§14.3"),
            ),
        );
        let centrifugal = sheet.step(
            "C_c",
            "N*m",
            given.frame * given.speed.powi(2) / given.radius * given.depth,
            "Moment of the centrifugal force of the frame about the axis; at the inclination θ it is C_c cos θ",
        );
        let weight = sheet.step(
            "K",
            "N*m",
            given.frame * given.gravity * given.depth,
            "Moment of the weight of the frame with its arm level; at the inclination θ it is K sin θ",
        );
        let (moment, why) = match self.sense {
            WheelSense::AsRoadWheels => (
                centrifugal - gyroscopic,
                "Both together, outward: a wheel that turns as the road wheels pulls the lower end of the frame inward",
            ),
            WheelSense::Opposite => (
                centrifugal + gyroscopic,
                "Both together, outward: a wheel that turns against the road wheels drives the lower end of the frame outward",
            ),
        };
        let moment = sheet.step("C", "N*m", moment, (why, BEER.at("§18.3")));
        let constant = || (moment / weight).asin();
        sheet.common_error("θ", "couples assumed constant, not reduced by cos θ: sin θ = C/K", constant);
        sheet.common_error("θ", "small inclination assumed: tan θ replaced by θ", || moment / weight);
        if let Some(mass) = wheel.mass {
            let heavier = |of_frame: W::Num| of_frame * (given.frame + mass) / given.frame;
            let with_wheel = || (moment - centrifugal + heavier(centrifugal)).atan2(heavier(weight));
            sheet.common_error("θ", "mass of the wheel added to that of the frame", with_wheel);
        }
        let tilt = sheet.step(
            "θ",
            "deg",
            moment.atan2(weight),
            ("Inclination, positive with the lower end outward: C cos θ = K sin θ", KHURMI.at("ex. 14.16")),
        );
        sheet.answer("gyroscopic_couple", "Gyroscopic couple with the frame upright", gyroscopic);
        sheet.answer(
            "centrifugal_couple",
            "Moment of the centrifugal force with the frame upright",
            centrifugal,
        );
        sheet.answer("inclination", "Inclination of the frame, outward", tilt);
        if self.sense == WheelSense::AsRoadWheels {
            let against_weight = || weight * given.radius / momentum;
            let what = "gyroscopic couple set equal to the moment of the weight";
            sheet.common_error("v₀", what, against_weight);
            let upright = sheet.step(
                "v₀",
                "m/s",
                momentum / (given.frame * given.depth),
                "Speed of the vehicle at which the two couples are equal: the frame stays upright in any turn",
            );
            sheet.answer("upright_speed", "Speed at which the frame stays upright", upright);
            sheet.verify(|| {
                let what = "at that speed the centrifugal force of the frame has the moment of the gyroscopic couple";
                let rate = upright / given.radius;
                let force = given.frame * given.depth * upright * rate;
                sheet.check(what, force, momentum * rate);
            });
        }
        sheet.verify(|| self.check_moments(momentum.value(), tilt.value(), sheet));
        let shown = tilt.value();
        sheet.show(|| Exhibit::Plot(self.tilt_over_speed(momentum.value(), shown)));
        sheet.show(|| Exhibit::Drawing(self.sketch(shown)));
        Ok(())
    }
}

impl PendulousGyro {
    /// Holds the moments about the axis, as vectors, to the rate of change of the angular momentum. The vehicle turns to
    /// the left: x forward, y to the left, z up.
    fn check_moments<W: Worksheet>(&self, momentum: f64, tilt: f64, sheet: W) {
        let up = Vector3::z() * (self.speed / self.radius);
        let axle = Vector3::new(0.0, tilt.cos(), -tilt.sin());
        let arm = Vector3::new(0.0, -tilt.sin(), -tilt.cos()) * self.depth;
        let inward = Vector3::y() * (self.frame * self.speed.powi(2) / self.radius);
        let weight = Vector3::z() * (-self.frame * self.gravity);
        let spin = up.cross(&(axle * (-self.sense.outward() * momentum))).x;
        let turning = arm.cross(&inward).x;
        let what = "moments about the axis: that of the weight is the rate of change of the angular momentum of wheel and frame";
        let size = spin.abs() + turning.abs();
        sheet.check_sum(what, W::Num::from(arm.cross(&weight).x), W::Num::from(spin + turning), size);
    }

    fn tilt_over_speed(&self, momentum: f64, tilt: f64) -> Plot {
        let most = if self.speed > 0.0 { 2.0 * self.speed } else { 20.0 };
        let at = |n: u16| {
            let speed = most * f64::from(n) / 120.0;
            let moment =
                (self.frame * self.depth * speed + self.sense.outward() * momentum) * speed / self.radius;
            (speed, (moment / (self.frame * self.gravity * self.depth)).atan())
        };
        Plot::new(
            "Inclination against the speed of the vehicle",
            Axis::linear("speed of the vehicle", "m/s"),
            Axis::linear("inclination, outward", "deg"),
            vec![Series::line("θ", (0..=120).map(at).collect()).of("inclination")],
        )
        .over("speed")
        .mark("at this speed", (self.speed, tilt))
    }
}

impl PendulousGyro {
    /// The frame from behind: the wheel on its axle, the weight below, and the centre of the turn at the left.
    fn sketch(&self, tilt: f64) -> Drawing {
        let (sin, cos) = tilt.sin_cos();
        let point = |across: f64, up: f64| (across * cos - up * sin, across * sin + up * cos);
        let centre = point(0.0, -1.1);
        let tip = if self.sense.outward() < 0.0 { -1.25 } else { 1.25 };
        let mut sketch = Sketch::new("The frame from behind, in a turn to the left");
        sketch
            .axis((0.0, 0.0), (0.0, 1.2))
            .body("", [point(-0.16, -0.8), point(0.16, -0.8), point(0.16, 0.8), point(-0.16, 0.8)])
            .label(self.wheel.letters(), point(0.16, 0.7))
            .bars([point(-0.7, 0.0), point(-0.16, 0.0)])
            .bars([point(0.16, 0.0), point(0.7, 0.0)])
            .bars([point(-0.7, 0.0), point(-0.7, -1.1), point(0.7, -1.1), point(0.7, 0.0)])
            .motion("ω", point(0.56 * tip, 0.0), point(tip, 0.0))
            .joint("O", (0.0, 0.0))
            .mass_centre("G", centre)
            .dimension("h", (0.0, 0.0), centre, 9.0)
            .force("m_f g", centre, (centre.0, centre.1 - 0.6))
            .axis((-2.6, 0.2), (-2.6, 1.2))
            .dimension("R", (-2.6, 1.2), (0.0, 1.2), 0.0)
            .angle("θ", (0.0, 0.0), -FRAC_PI_2, -FRAC_PI_2 + tilt);
        if let GyroRotor::Disc { .. } = self.wheel {
            sketch.dimension(self.wheel.radius_letter(), point(0.16, 0.0), point(0.16, 0.8), -1.5);
        }
        into_page(&mut sketch, "v", (1.3, 0.7), 0.12);
        sketch.finish()
    }
}
