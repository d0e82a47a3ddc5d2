//! Four equal bars, hung up by one corner, with a spring across.

use std::f64::consts::FRAC_PI_2;

use dalembert_core::{About, Analysis, Inputs, Refusal, Sketch, Worksheet, register};
use dalembert_mechanics::{
    Real,
    planar::{
        BodyPoint, Driver, Effort, PlanarBody, PlanarJoint, PlanarLoad, PlanarMechanism, RelativeCoordinate,
    },
};

pub use crate::shared::one_degree_of_freedom::Position;
use crate::{
    shared::{
        equilibria::down,
        figure,
        one_degree_of_freedom::{PotentialTerm, Shapes, SingleDofMachine, sine_error, spring, weight},
    },
    sources::{BEER, HIBBELER, RIUL},
};

/// A rhombus of four bars, hung up by its upper corner.
#[derive(Clone, Debug, Inputs)]
pub struct Rhombus {
    /// Length of each bar.
    #[input("L", "m", positive)]
    pub length: f64,
    /// Mass of each bar.
    /// Uniform: its weight acts in the middle.
    #[input("m", "kg", nonnegative)]
    pub mass: f64,
    /// Acceleration of gravity.
    #[input("g", "m/s^2", positive, default = "9.81 m/s^2")]
    pub gravity: f64,
    /// Load at the lower corner.
    /// Enter 0 if there is none; leave it blank to find it from the position.
    #[input("Q", "N")]
    pub load: Option<f64>,
    /// Direction of the spring.
    pub across: Across,
    /// Stiffness of the spring.
    /// If left blank, it is computed from the position.
    #[input("k", "N/m", positive)]
    pub stiffness: Option<f64>,
    /// Angle at which the spring is unstretched.
    #[input("θ₀", "deg", min = -360, max = 360)]
    pub free: f64,
    /// Position.
    /// The angle θ of each bar is measured from the vertical.
    pub position: Position,
}

/// Corners that the spring joins.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum Across {
    /// Between the corners at the sides
    Sides,
    /// Between the upper and the lower corner
    Height,
}

register!(Rhombus);

impl Analysis for Rhombus {
    const ABOUT: About = About {
        id: "virtual-work/rhombus",
        title: "Rhombus with a spring",
        topic: "Bars and levers",
        summary: "Equilibria and stability of a hanging rhombus of four bars with a spring across, or the load or stiffness for a given angle.",
        main: &["load", "stable_angle", "stiffness"],
        keywords: "four bars diamond pantograph hanging frame spring losango pantógrafo quatro barras mola estabilidade",
        sources: &[&BEER, &HIBBELER, &RIUL],
        cases: include_str!("../../cases/rhombus.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &RhombusGiven<W>, sheet: W) -> Result<(), Refusal> {
        let weight = weight(given.mass, given.gravity, "Weight of each bar", sheet);
        let lengths = [given.length, given.free];
        let parts = [
            PotentialTerm {
                name: "weights of the bars",
                load: Some(weight),
                rate: [
                    "y′_G",
                    "m",
                    "Sum of the upward virtual displacements of the four centres of mass per unit δθ",
                ],
                symbol: ["W", "N"],
                answer: ["weight", "Weight of each bar"],
            },
            PotentialTerm {
                name: "load at the lower corner",
                load: given.load,
                rate: ["y′_D", "m", "Upward virtual displacement of the lower corner per unit δθ"],
                symbol: ["Q", "N"],
                answer: ["load", "Load at the lower corner"],
            },
            PotentialTerm {
                name: "spring",
                load: given.stiffness,
                rate: ["u′", "m^2", "Extension of the spring times its virtual change per unit δθ"],
                symbol: ["k", "N/m"],
                answer: ["stiffness", "Stiffness of the spring"],
            },
        ];
        let machine = SingleDofMachine {
            shapes: self,
            lengths: &lengths,
            parts: &parts,
            joints: &[
                "Upper corner, left bar",
                "Upper corner, right bar",
                "Left corner",
                "Right corner",
                "Lower corner",
            ],
        };
        let balanced = machine.solve(&given.position, sheet, |loads, at| self.built(loads, at))?;
        sheet.show(|| balanced.animation("The rhombus", 0.4, |at| self.frame(at)));
        Ok(())
    }
}

impl Shapes for Rhombus {
    fn shapes<N: Real>(&self, lengths: &[N], angle: N) -> Vec<[N; 3]> {
        let (l, free, sin, cos) = (lengths[0], lengths[1], angle.sin(), angle.cos());
        let (wide, high) = (l * sin * 2.0, l * cos * 2.0);
        let stretch = match self.across {
            Across::Sides => spring([wide, high, -wide], l * free.sin() * 2.0),
            Across::Height => spring([high, -wide, -high], l * free.cos() * 2.0),
        };
        vec![[-(l * cos * 4.0), l * sin * 4.0, l * cos * 4.0], [-high, wide, high], stretch]
    }

    fn common_errors<W: Worksheet>(&self, lengths: &[W::Num], angle: W::Num, sheet: W) {
        if let Across::Sides = self.across {
            sine_error([lengths[0] * 2.0, lengths[1], angle], sheet);
        }
    }
}

impl Rhombus {
    /// Upper left, upper right, lower left and lower right bar, each from its upper end, in the lower corner of
    /// which a pin slides in a vertical slot.
    fn built(&self, loads: &[f64], at: f64) -> (PlanarMechanism, Vec<[f64; 3]>) {
        let l = self.length;
        let bar = |body: usize, s: f64| BodyPoint::body(body, [s, 0.0]);
        let top = BodyPoint::ground([0.0; 2]);
        let mut acting: Vec<PlanarLoad> = (0..4).map(|body| down(bar(body, l / 2.0), loads[0])).collect();
        acting.push(down(bar(2, l), loads[1]));
        let (measure, free) = match self.across {
            Across::Sides => (
                RelativeCoordinate::Component { direction: [1.0, 0.0], from: bar(0, l), to: bar(1, l) },
                self.free.sin(),
            ),
            Across::Height => (
                RelativeCoordinate::Component { direction: [0.0, -1.0], from: top, to: bar(2, l) },
                self.free.cos(),
            ),
        };
        acting.push(PlanarLoad::Effort {
            measure,
            effort: Effort::Spring { stiffness: loads[2], free: 2.0 * l * free },
        });
        let mechanism = PlanarMechanism {
            bodies: vec![PlanarBody::default(); 4],
            joints: vec![
                PlanarJoint::Pin { a: top, b: bar(0, 0.0) },
                PlanarJoint::Pin { a: top, b: bar(1, 0.0) },
                PlanarJoint::Pin { a: bar(0, l), b: bar(2, 0.0) },
                PlanarJoint::Pin { a: bar(1, l), b: bar(3, 0.0) },
                PlanarJoint::Pin { a: bar(2, l), b: bar(3, l) },
                PlanarJoint::Slot { guide: top, direction: FRAC_PI_2, pin: bar(2, l), offset: 0.0 },
            ],
            drivers: vec![Driver {
                measure: RelativeCoordinate::Angle { of: Some(1), against: None },
                value: at - FRAC_PI_2,
                velocity: 0.0,
                acceleration: 0.0,
            }],
            loads: acting,
            gravity: [0.0; 2],
        };
        let (wide, high) = (l * at.sin(), -l * at.cos());
        let drawn = vec![
            [0.0, 0.0, -FRAC_PI_2 - at],
            [0.0, 0.0, at - FRAC_PI_2],
            [-wide, high, at - FRAC_PI_2],
            [wide, high, -FRAC_PI_2 - at],
        ];
        (mechanism, drawn)
    }

    fn frame(&self, angle: f64) -> Sketch {
        let l = self.length;
        let (wide, high) = (l * angle.sin(), l * angle.cos());
        let (top, left, right, low) = ((0.0, 0.0), (-wide, -high), (wide, -high), (0.0, -2.0 * high));
        let mut sketch = Sketch::default();
        sketch.size(2.4 * l).axis(top, (0.0, -2.2 * l));
        match self.across {
            Across::Sides => sketch.spring("k", left, right),
            Across::Height => sketch.spring("k", top, low),
        };
        if self.free != 0.0 {
            let down = -FRAC_PI_2;
            sketch.axis(top, figure::away(top, 0.8 * l, down - self.free)).angle(
                "θ₀",
                top,
                down - self.free,
                down,
            );
        }
        if self.mass != 0.0 {
            sketch.mass_centre("m", (-wide / 2.0, -1.5 * high));
        }
        sketch
            .bars([top, left, low, right])
            .link("L", top, right)
            .hung_pin("", top)
            .joint("", left)
            .joint("", right)
            .joint("", low)
            .angle("θ", top, -FRAC_PI_2, angle - FRAC_PI_2);
        if self.load != Some(0.0) {
            sketch.force("Q", low, (0.0, low.1 - 0.4 * l));
        }
        sketch
    }
}
