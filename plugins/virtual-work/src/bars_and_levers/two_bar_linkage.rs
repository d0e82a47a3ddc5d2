//! Two equal bars: one turns about a fixed pin, the other's far end slides level with it.

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
        one_degree_of_freedom::{PotentialTerm, Shapes, SingleDofMachine, spring, weight},
    },
    sources::{BEER, HIBBELER, RIUL},
};

/// Bars AB and BC of the same length; A is fixed, C slides on the level of A.
#[derive(Clone, Debug, Inputs)]
pub struct TwoBarLinkage {
    /// Joint B between the bars.
    pub knee: Knee,
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
    /// Vertical force at the joint B, downwards.
    /// Enter 0 if there is none; leave it blank to find it from the position.
    #[input("Q", "N")]
    pub force_b: Option<f64>,
    /// Horizontal force at C, away from A.
    /// Enter 0 if there is none; leave it blank to find it from the position.
    #[input("F", "N")]
    pub force_c: Option<f64>,
    /// Spring between A and C.
    pub spring: EndSpring,
    /// Position.
    /// The angle θ of each bar is measured from the line AC.
    pub position: Position,
}

/// Side of the joint between the bars.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum Knee {
    /// Below the line AC
    Below,
    /// Above the line AC
    Above,
}

/// A spring between the ends.
#[derive(Clone, Debug, Inputs)]
pub enum EndSpring {
    /// None
    None,
    /// Spring
    Spring {
        /// Stiffness.
        /// If left blank, it is computed from the position.
        #[input("k", "N/m", positive)]
        stiffness: Option<f64>,
        /// Angle at which the spring is unstretched.
        #[input("θ₀", "deg", min = -360, max = 360)]
        free: f64,
    },
}

register!(TwoBarLinkage);

impl Analysis for TwoBarLinkage {
    const ABOUT: About = About {
        id: "virtual-work/two-bar-linkage",
        title: "Two bars with a sliding end",
        topic: "Bars and levers",
        summary: "Equilibria and stability of two equal hinged bars with a sliding end, or the force or stiffness for a given angle.",
        main: &["stable_angle", "force_b", "force_c", "stiffness"],
        keywords: "two-member linkage hinged bars roller spring virtual displacement angle barras articuladas rolete mola \
                   deslocamento virtual ângulo",
        sources: &[&HIBBELER, &BEER, &RIUL],
        cases: include_str!("../../cases/two_bar_linkage.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &TwoBarLinkageGiven<W>, sheet: W) -> Result<(), Refusal> {
        let weight = weight(given.mass, given.gravity, "Weight of each bar", sheet);
        let mut lengths = vec![given.length];
        let mut parts = vec![
            PotentialTerm {
                name: "weights of the bars",
                load: Some(weight),
                rate: [
                    "y′_G",
                    "m",
                    "Sum of the upward virtual displacements of the two centres of mass per unit δθ",
                ],
                symbol: ["W", "N"],
                answer: ["weight", "Weight of each bar"],
            },
            PotentialTerm {
                name: "force at B",
                load: given.force_b,
                rate: ["y′_B", "m", "Upward virtual displacement of B per unit δθ"],
                symbol: ["Q", "N"],
                answer: ["force_b", "Vertical force at B"],
            },
            PotentialTerm {
                name: "force at C",
                load: given.force_c,
                rate: ["x′_C", "m", "Virtual displacement of C towards A per unit δθ"],
                symbol: ["F", "N"],
                answer: ["force_c", "Horizontal force at C"],
            },
        ];
        if let EndSpringGiven::Spring { stiffness, free } = &given.spring {
            lengths.push(*free);
            parts.push(PotentialTerm {
                name: "spring",
                load: *stiffness,
                rate: ["u′", "m^2", "Extension of the spring times its virtual change per unit δθ"],
                symbol: ["k", "N/m"],
                answer: ["stiffness", "Stiffness of the spring"],
            });
        }
        let machine = SingleDofMachine {
            shapes: self,
            lengths: &lengths,
            parts: &parts,
            joints: &["Pin A", "Joint B", "Guide of C"],
        };
        let balanced = machine.solve(&given.position, sheet, |loads, at| self.built(loads, at))?;
        sheet.show(|| balanced.animation("The two bars", 0.4, |at| self.frame(at)));
        Ok(())
    }
}

impl Shapes for TwoBarLinkage {
    fn shapes<N: Real>(&self, lengths: &[N], angle: N) -> Vec<[N; 3]> {
        let (l, sin, cos) = (lengths[0], angle.sin(), angle.cos());
        let rise = match self.knee {
            Knee::Above => [l * sin, l * cos, -(l * sin)],
            Knee::Below => [-(l * sin), -(l * cos), l * sin],
        };
        let mut shapes = vec![rise, rise, [-(l * cos * 2.0), l * sin * 2.0, l * cos * 2.0]];
        if matches!(self.spring, EndSpring::Spring { .. }) {
            shapes.push(spring(
                [l * cos * 2.0, -(l * sin * 2.0), -(l * cos * 2.0)],
                l * lengths[1].cos() * 2.0,
            ));
        }
        shapes
    }
}

impl TwoBarLinkage {
    fn sign(&self) -> f64 {
        if self.knee == Knee::Above { 1.0 } else { -1.0 }
    }

    /// The linkage with A in the origin and C to the right; each bar's axis runs from A towards C.
    fn built(&self, loads: &[f64], at: f64) -> (PlanarMechanism, Vec<[f64; 3]>) {
        let (l, sign) = (self.length, self.sign());
        let first = |s: f64| BodyPoint::body(0, [s, 0.0]);
        let second = |s: f64| BodyPoint::body(1, [s, 0.0]);
        let pin = BodyPoint::ground([0.0; 2]);
        let measure = match self.knee {
            Knee::Above => RelativeCoordinate::Angle { of: Some(0), against: None },
            Knee::Below => RelativeCoordinate::Angle { of: None, against: Some(0) },
        };
        let mut acting = vec![
            down(first(l / 2.0), loads[0]),
            down(second(l / 2.0), loads[0]),
            down(first(l), loads[1]),
            PlanarLoad::Force { at: second(l), force: [loads[2], 0.0], turns_with: None },
        ];
        if let EndSpring::Spring { free, .. } = self.spring {
            acting.push(PlanarLoad::Effort {
                measure: RelativeCoordinate::Component { direction: [1.0, 0.0], from: pin, to: second(l) },
                effort: Effort::Spring { stiffness: loads[3], free: 2.0 * l * free.cos() },
            });
        }
        let mechanism = PlanarMechanism {
            bodies: vec![PlanarBody::default(); 2],
            joints: vec![
                PlanarJoint::Pin { a: pin, b: first(0.0) },
                PlanarJoint::Pin { a: first(l), b: second(0.0) },
                PlanarJoint::Slot { guide: pin, direction: 0.0, pin: second(l), offset: 0.0 },
            ],
            drivers: vec![Driver { measure, value: at, velocity: 0.0, acceleration: 0.0 }],
            loads: acting,
            gravity: [0.0; 2],
        };
        let drawn = vec![[0.0, 0.0, sign * at], [l * at.cos(), sign * l * at.sin(), -sign * at]];
        (mechanism, drawn)
    }

    fn frame(&self, angle: f64) -> Sketch {
        let (l, sign) = (self.length, self.sign());
        let (a, b, c) = ((0.0, 0.0), (l * angle.cos(), sign * l * angle.sin()), (2.0 * l * angle.cos(), 0.0));
        let mut sketch = Sketch::default();
        sketch.size(2.2 * l);
        let unit = sketch.symbol();
        sketch.guide((5.0 * unit, 0.0), (2.2 * l, 0.0)).slider("", c, 0.0).axis(a, (8.0 * unit, 0.0));
        if matches!(self.spring, EndSpring::Spring { .. }) {
            sketch.spring("k", a, c);
        }
        sketch.link("L", a, b).bars([b, c]).pin("A", a).joint("B", b).joint("C", c).angle(
            "θ",
            a,
            0.0,
            sign * angle,
        );
        if self.mass > 0.0 {
            for x in [0.5, 1.5] {
                sketch.mass_centre("m", (x * b.0, b.1 / 2.0));
                sketch.force("W", (x * b.0, b.1 / 2.0), (x * b.0, b.1 / 2.0 - 0.25 * l));
            }
        }
        if self.force_b != Some(0.0) {
            sketch.force("Q", b, (b.0, b.1 - 0.3 * l));
        }
        if self.force_c != Some(0.0) {
            sketch.force("F", (c.0 + 2.4 * unit, 0.0), (c.0 + 0.4 * l, 0.0));
        }
        sketch
    }
}
