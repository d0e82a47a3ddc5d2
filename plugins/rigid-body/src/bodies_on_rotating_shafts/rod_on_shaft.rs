//! A slender rod welded at its middle to a turning shaft, at an angle.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use dalembert_core::{
    About, Analysis, Axis, Drawing, Exhibit, Ink, Inputs, Plot, Refusal, Series, Sketch, Worksheet, register,
};
use dalembert_mechanics::{Real, Vector, rigid};
use nalgebra::Vector3;

use crate::sources::{BEER, IRODOV, RIUL};

/// The rod and the shaft that it is welded to.
///
/// The axes Gxyz have their origin in the middle of the rod and turn with the shaft: y along the shaft, the rod in
/// the plane xy, falling towards +x. XYZ are fixed, and the same at shaft angle zero. The axes x′ and y′ lie along
/// the rod and across it, in the same plane.
#[derive(Clone, Debug, Inputs)]
pub struct RodOnShaft {
    /// Mass of the rod.
    #[input("m", "kg", positive)]
    pub mass: f64,
    /// Half the length of the rod.
    /// The rod is 2b long and welded at its middle.
    #[input("b", "m", positive)]
    pub half_length: f64,
    /// Angle of the rod.
    pub inclination: Inclination,
    /// Angular velocity of the shaft.
    #[input("ω", "rad/s")]
    pub speed: f64,
    /// Angular acceleration of the shaft.
    #[input("α", "rad/s^2", default = "0 rad/s^2")]
    pub acceleration: f64,
    /// Angle of the shaft.
    /// From the fixed axes to the axes rotating with the shaft, about y.
    #[input("φ", "rad", default = "0 deg")]
    pub shaft_angle: f64,
}

/// From where the angle of the rod is measured.
#[derive(Clone, Debug, Inputs)]
pub enum Inclination {
    /// Measured from the horizontal
    FromHorizontal {
        /// Angle to the horizontal.
        #[input("β", "rad")]
        angle: f64,
    },
    /// Measured from the shaft
    FromShaft {
        /// Angle to the shaft.
        #[input("β", "rad")]
        angle: f64,
    },
}

register!(RodOnShaft);

impl Analysis for RodOnShaft {
    const ABOUT: About = About {
        id: "rigid-body/rod-on-shaft",
        title: "Slender rod welded to a rotating shaft",
        topic: "Bodies on rotating shafts",
        summary: "Angular momentum of an inclined rod that rotates with a shaft, its rate of change, and the couple that the shaft exerts.",
        main: &["couple", "angular_momentum"],
        keywords: "rod shaft couple weld haste eixo binário soldada inclinada momento angular exemplo 4",
        sources: &[&RIUL, &BEER, &IRODOV],
        cases: include_str!("../../cases/rod_on_shaft.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &RodOnShaftGiven<W>, sheet: W) -> Result<(), Refusal> {
        let zero = W::Num::from(0.0);
        // The parts of a unit vector along the rod on the shaft and on the horizontal.
        let (along_shaft, across_shaft, twice) = match given.inclination {
            InclinationGiven::FromHorizontal { angle } => (angle.sin(), angle.cos(), (angle * 2.0).sin()),
            InclinationGiven::FromShaft { angle } => (angle.cos(), angle.sin(), (angle * 2.0).sin()),
        };
        let short = || rigid::rod_inertia(given.mass, given.half_length);
        sheet.common_error("I", "half of the length inserted as the length of the rod in mL²/12", short);
        let about_end = || given.mass * (given.half_length * 2.0).powi(2) / 3.0;
        sheet.common_error("I", "moment of inertia of the rod taken about one end, mL²/3", about_end);
        let inertia = sheet.step(
            "I",
            "kg*m^2",
            rigid::rod_inertia_half_length(given.mass, given.half_length),
            ("Transverse moment of inertia of the rod, I_y′ = I_z′; along it, Iₓ′ = 0", RIUL.at("eq. 4.2")),
        );
        sheet.step(
            "ωₓ′",
            "rad/s",
            -(given.speed * along_shaft),
            ("Component of the angular velocity along the rod", RIUL.at("eq. 4.3")),
        );
        let omega_across = sheet.step(
            "ω_y′",
            "rad/s",
            given.speed * across_shaft,
            ("Component of the angular velocity transverse to the rod", RIUL.at("eq. 4.3")),
        );
        let across = sheet.step(
            "H_y′",
            "kg*m^2/s",
            inertia * omega_across,
            ("Angular momentum in the axes of the rod: only ω_y′ contributes", RIUL.at("eqs. 4.1, 4.4")),
        );
        let momentum = sheet.step_vector(
            "H_G",
            "kg*m^2/s",
            W::Vec::from_components(across * along_shaft, across * across_shaft, zero),
            ("Angular momentum in the axes rotating with the shaft", RIUL.at("eq. 4.6")),
        );
        let size = sheet.step("H", "kg*m^2/s", across.abs(), "Magnitude of the angular momentum");
        let axial = sheet.step(
            "H_y",
            "kg*m^2/s",
            across * across_shaft,
            "Component of the angular momentum along the shaft",
        );
        let axes = sheet.step_vector(
            "Ω",
            "rad/s",
            W::Vec::from_components(zero, given.speed, zero),
            ("The axes xyz rotate with the shaft", RIUL.at("eq. 4.7")),
        );
        let across_rate = inertia * given.acceleration * across_shaft;
        let seen = sheet.step_vector(
            "Ḣ_rel",
            "N*m",
            W::Vec::from_components(across_rate * along_shaft, across_rate * across_shaft, zero),
            ("Rate of change relative to axes rotating with the shaft", RIUL.at("eqs. 4.9, 47")),
        );
        let turned = sheet.step_vector(
            "Ḣ_turn",
            "N*m",
            rigid::transport_rate(axes, momentum),
            ("Transport term Ω × H", RIUL.at("eq. 4.7")),
        );
        let couple = sheet.step_vector(
            "M_G",
            "N*m",
            seen + turned,
            ("Couple that the shaft exerts on the rod: ΣM = dH/dt", RIUL.at("eqs. 4.10, 4.11")),
        );
        let closed_with = |inertia: W::Num| -(inertia * given.speed.powi(2) * twice / 2.0);
        let short = || closed_with(rigid::rod_inertia(given.mass, given.half_length));
        sheet.common_error("M_z", "half of the length inserted as the length of the rod in mL²/12", short);
        let about_end = || closed_with(given.mass * (given.half_length * 2.0).powi(2) / 3.0);
        sheet.common_error("M_z", "moment of inertia of the rod taken about one end, mL²/3", about_end);
        let at_centres = || closed_with(given.mass * (given.half_length / 2.0).powi(2));
        sheet.common_error("M_z", "centrifugal force of each half applied at its own midpoint", at_centres);
        let at_ends = || closed_with(given.mass * given.half_length.powi(2));
        sheet.common_error("M_z", "mass of the rod taken as two particles at its ends", at_ends);
        let closed = sheet.step(
            "M_z",
            "N*m",
            -(given.mass * given.half_length.powi(2) * given.speed.powi(2) * twice / 6.0),
            ("The couple that tilts the shaft, in closed form", RIUL.at("eq. 4.11")),
        );
        let fixed_momentum = sheet.step_vector(
            "H_XYZ",
            "kg*m^2/s",
            rigid::to_fixed_axes(rigid::Axis::Y, given.shaft_angle, momentum),
            "Components of the angular momentum in the fixed axes",
        );
        let fixed_couple = sheet.step_vector(
            "M_XYZ",
            "N*m",
            rigid::to_fixed_axes(rigid::Axis::Y, given.shaft_angle, couple),
            "Components of the couple in the fixed axes",
        );
        let transverse = || inertia * given.speed.powi(2) / 2.0;
        let what = "½Iω² used with the moment of inertia of the rod about a transverse axis";
        sheet.common_error("T", what, transverse);
        let energy = sheet.step(
            "T",
            "J",
            rigid::rotational_energy(axes, momentum),
            ("Kinetic energy: G is at rest", BEER.at("§18.1C")),
        );
        sheet.answer("inertia", "Transverse moment of inertia of the rod", inertia);
        sheet.answer_vector(
            "angular_momentum",
            "Angular momentum about the midpoint, axes of the shaft",
            momentum,
        );
        sheet.answer("angular_momentum_size", "Magnitude of the angular momentum", size);
        sheet.answer("axial_angular_momentum", "Angular momentum along the shaft", axial);
        sheet.answer_vector("relative_rate", "(dH/dt) relative to the axes of the shaft", seen);
        sheet.answer_vector("transport_rate", "Ω × H", turned);
        sheet.answer_vector("couple", "Couple on the rod, axes of the shaft", couple);
        sheet.answer("tilting_couple", "Couple on the rod about z", closed);
        sheet.answer_vector(
            "fixed_angular_momentum",
            "Angular momentum about the midpoint, fixed axes",
            fixed_momentum,
        );
        sheet.answer_vector("fixed_couple", "Couple on the rod, fixed axes", fixed_couple);
        sheet.answer("kinetic_energy", "Kinetic energy", energy);
        if twice.value().abs() < 1e-12 {
            sheet.warn(|| {
                "at this angle the shaft is a principal axis of the rod: no couple is needed to keep the rod there".into()
            });
        }
        sheet.verify(|| {
            let scale = inertia.value() * (self.speed.powi(2) + self.acceleration.abs());
            sheet.check_zero("Ω × H and −(1/6) m b² ω² sin 2β", turned.components()[2] - closed, scale);
            sheet.check_zero(
                "the component along the shaft is the inertia about the shaft times ω",
                axial - inertia * across_shaft.powi(2) * given.speed,
                axial.value(),
            );
            sheet.check(
                "the kinetic energy from the inertia about the shaft",
                energy,
                inertia * (across_shaft * given.speed).powi(2) / 2.0,
            );
            self.check_by_rotation(sheet, fixed_momentum, fixed_couple);
        });
        sheet.show(|| Exhibit::Drawing(self.rod_and_shaft(closed.value())));
        sheet.show(|| Exhibit::Plot(self.couple_over_angle(closed.value())));
        Ok(())
    }
}

impl RodOnShaft {
    /// A second method: the whole inertia tensor of the rod in fixed axes, with the rod turned to where it is at each
    /// time, times the angular velocity; and the difference quotient of that product in time.
    fn check_by_rotation<W: Worksheet>(&self, sheet: W, momentum: W::Vec, couple: W::Vec) {
        let elevation = self.elevation();
        let momentum_at = |t: f64| {
            let angle = self.shaft_angle + (self.speed + self.acceleration * t / 2.0) * t;
            let level = elevation.cos();
            let direction = Vector3::new(level * angle.cos(), -elevation.sin(), -level * angle.sin());
            let omega = Vector3::y() * (self.speed + self.acceleration * t);
            rigid::rod_tensor(self.mass, 2.0 * self.half_length, direction)
                .map_or_else(|_| Vector3::repeat(f64::NAN), |tensor| tensor * omega)
        };
        let inertia = rigid::rod_inertia_half_length(self.mass, self.half_length);
        sheet.check_zero(
            "the angular momentum from the inertia tensor of the rotated rod",
            W::Num::from((momentum_at(0.0) - momentum.value()).norm()),
            inertia * self.speed.abs(),
        );
        let period = (TAU / self.speed.abs()).min((TAU / self.acceleration.abs()).sqrt());
        let period = if period.is_finite() { period } else { 1.0 };
        let Ok(rate) = rigid::numerical_rate(momentum_at, period) else { return };
        sheet.check_zero(
            "the couple from the difference quotient of that angular momentum",
            W::Num::from((rate - couple.value()).norm()),
            inertia * (self.speed.abs() * TAU / period + self.acceleration.abs()),
        );
    }

    /// The angle of the rod to the horizontal, rad.
    fn elevation(&self) -> f64 {
        match self.inclination {
            Inclination::FromHorizontal { angle } => angle,
            Inclination::FromShaft { angle } => FRAC_PI_2 - angle,
        }
    }

    fn couple_over_angle(&self, couple: f64) -> Plot {
        let (Inclination::FromHorizontal { angle } | Inclination::FromShaft { angle }) = self.inclination;
        let most = self.mass * self.half_length.powi(2) * self.speed.powi(2) / 6.0;
        let (from, to) = (angle.min(0.0), angle.max(FRAC_PI_2));
        let at = |n: u16| {
            let angle = from + (to - from) * f64::from(n) / 180.0;
            (angle, -most * (2.0 * angle).sin())
        };
        let input = match self.inclination {
            Inclination::FromHorizontal { .. } => "inclination.from-horizontal.angle",
            Inclination::FromShaft { .. } => "inclination.from-shaft.angle",
        };
        Plot::new(
            "Couple on the rod against its angle",
            Axis::linear("angle of the rod", "deg"),
            Axis::linear("couple about z", "N*m"),
            vec![Series::line("M_z", (0..=180).map(at).collect()).of("tilting_couple")],
        )
        .over(input)
        .mark("at this angle", (angle, couple))
    }

    /// The plane of the shaft and the rod, drawn with the rod two units long.
    fn rod_and_shaft(&self, couple: f64) -> Drawing {
        let (sin, cos) = self.elevation().sin_cos();
        let mut sketch = Sketch::new("The rod in the plane rotating with the shaft");
        sketch
            .link("", (0.0, -1.5), (0.0, 1.5))
            .bearing("", (0.0, -1.3), FRAC_PI_2)
            .axis((-1.5, 0.0), (1.5, 0.0))
            .label("x", (1.5, 0.0))
            .label("y", (0.0, 1.5))
            .link("m", (-cos, sin), (0.0, 0.0))
            .link("", (0.0, 0.0), (cos, -sin))
            .label("A", (-cos, sin))
            .label("B", (cos, -sin))
            .dimension("b", (0.0, 0.0), (cos, -sin), -2.5)
            .joint("G", (0.0, 0.0));
        if self.speed != 0.0 {
            let (low, high) = ((0.0, 0.9), (0.0, 1.35));
            let (tail, head) = if self.speed > 0.0 { (low, high) } else { (high, low) };
            sketch.motion("ω", tail, head);
        }
        if self.acceleration != 0.0 {
            let along = 0.4 * self.acceleration.signum();
            sketch.motion("α", (0.12, 0.95 - along / 2.0), (0.12, 0.95 + along / 2.0));
        }
        let length = 0.9 * cos * self.speed.signum();
        if self.speed != 0.0 && cos.abs() > 1e-9 {
            sketch.vector("H_G", (0.0, 0.0), (length * sin, length * cos), Ink::Result);
        }
        // The couple is about z, which points at the viewer; so the shaft turns by φ from left to right before it.
        if couple != 0.0 {
            let turn = if couple > 0.0 { (3.6, 5.6) } else { (5.6, 3.6) };
            sketch.couple("M_z", (0.0, 0.0), turn, Ink::Force);
        }
        let around = |n: i32| {
            let (across, up) = (PI + PI * f64::from(n) / 12.0).sin_cos();
            (0.3 * up, 0.08 * across - 0.9)
        };
        sketch.curve((0..=12).map(around).collect::<Vec<_>>(), Ink::Faint).label("φ", (0.3, -0.9));
        match self.inclination {
            Inclination::FromHorizontal { angle } => sketch.angle("β", (0.0, 0.0), 0.0, -angle),
            Inclination::FromShaft { angle } => sketch.angle("β", (0.0, 0.0), -FRAC_PI_2, angle - FRAC_PI_2),
        };
        sketch.finish()
    }
}
