//! A bar whose ends slide in two guides at right angles, under its weight, forces at its ends and a spring.

use std::f64::consts::FRAC_PI_2;

use dalembert_core::{About, Analysis, Ink, Inputs, Refusal, Sketch, Worksheet, register};
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
        one_degree_of_freedom::{PotentialTerm, Shapes, SingleDofMachine, sine_error, spring, weight},
    },
    sources::{BEER, HIBBELER, RIUL},
};

/// A bar AB; A slides along the vertical guide, B along the horizontal one.
#[derive(Clone, Debug, Inputs)]
pub struct GuidedBar {
    /// End A.
    pub side: GuideSide,
    /// Length.
    #[input("L", "m", positive)]
    pub length: f64,
    /// Mass of the bar.
    /// Uniform: its weight acts in the middle.
    #[input("m", "kg", nonnegative)]
    pub mass: f64,
    /// Acceleration of gravity.
    #[input("g", "m/s^2", positive, default = "9.81 m/s^2")]
    pub gravity: f64,
    /// Vertical force at A, downwards.
    /// Enter 0 if there is none; leave it blank to find it from the position.
    #[input("P", "N")]
    pub force_a: Option<f64>,
    /// Horizontal force at B, towards the vertical guide.
    /// Enter 0 if there is none; leave it blank to find it from the position.
    #[input("F", "N")]
    pub force_b: Option<f64>,
    /// Spring.
    pub spring: GuidedSpring,
    /// Position.
    /// The angle θ is measured between the bar and the vertical guide.
    pub position: Position,
}

/// Side of A.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum GuideSide {
    /// Above the horizontal guide
    Above,
    /// Below the horizontal guide
    Below,
}

/// A spring on the bar that keeps its direction.
#[derive(Clone, Debug, Inputs)]
pub enum GuidedSpring {
    /// None
    None,
    /// Horizontal
    Horizontal {
        /// Stiffness.
        /// If left blank, it is computed from the position.
        #[input("k", "N/m", positive)]
        stiffness: Option<f64>,
        /// Distance of its end on the bar from A.
        #[input("c", "m", positive)]
        distance: f64,
        /// Angle at which the spring is unstretched.
        #[input("θ₀", "deg", min = -360, max = 360)]
        free: f64,
    },
    /// Vertical
    Vertical {
        /// Stiffness.
        /// If left blank, it is computed from the position.
        #[input("k", "N/m", positive)]
        stiffness: Option<f64>,
        /// Distance of its end on the bar from B.
        #[input("c", "m", positive)]
        distance: f64,
        /// Angle at which the spring is unstretched.
        #[input("θ₀", "deg", min = -360, max = 360)]
        free: f64,
    },
}

register!(GuidedBar);

impl Analysis for GuidedBar {
    const ABOUT: About = About {
        id: "virtual-work/guided-bar",
        title: "Bar in two guides",
        topic: "Bars and levers",
        summary: "Equilibria and stability of a bar whose ends slide in guides at right angles, or the force or stiffness for a given angle.",
        main: &["force_b", "stable_angle", "unstable_angle", "stiffness"],
        keywords: "ladder sliding rod collars spring potential energy stability escada barra guias cursores mola \
                   energia potencial estabilidade elliptic trammel double slider elipsógrafo",
        sources: &[&HIBBELER, &BEER, &RIUL],
        cases: include_str!("../../cases/guided_bar.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &GuidedBarGiven<W>, sheet: W) -> Result<(), Refusal> {
        let weight = weight(given.mass, given.gravity, "Weight of the bar", sheet);
        let mut lengths = vec![given.length];
        let mut parts = vec![
            PotentialTerm {
                name: "weight of the bar",
                load: Some(weight),
                rate: ["y′_G", "m", "Upward virtual displacement of the centre of mass per unit δθ"],
                symbol: ["W", "N"],
                answer: ["weight", "Weight of the bar"],
            },
            PotentialTerm {
                name: "force at A",
                load: given.force_a,
                rate: ["y′_A", "m", "Upward virtual displacement of A per unit δθ"],
                symbol: ["P", "N"],
                answer: ["force_a", "Vertical force at A"],
            },
            PotentialTerm {
                name: "force at B",
                load: given.force_b,
                rate: ["x′_B", "m", "Virtual displacement of B per unit δθ, away from the vertical guide"],
                symbol: ["F", "N"],
                answer: ["force_b", "Horizontal force at B"],
            },
        ];
        if let GuidedSpringGiven::Horizontal { stiffness, distance, free }
        | GuidedSpringGiven::Vertical { stiffness, distance, free } = &given.spring
        {
            lengths.extend([*distance, *free]);
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
            joints: &["Guide of A", "Guide of B"],
        };
        let balanced = machine.solve(&given.position, sheet, |loads, at| self.built(loads, at))?;
        sheet.show(|| balanced.animation("The bar in its guides", 0.5, |at| self.frame(at)));
        Ok(())
    }
}

impl Shapes for GuidedBar {
    fn shapes<N: Real>(&self, lengths: &[N], angle: N) -> Vec<[N; 3]> {
        let (sin, cos) = (angle.sin(), angle.cos());
        let up = |height: N| match self.side {
            GuideSide::Above => [height * cos, -(height * sin), -(height * cos)],
            GuideSide::Below => [-(height * cos), height * sin, height * cos],
        };
        let length = lengths[0];
        let mut shapes = vec![up(length / 2.0), up(length), [length * sin, length * cos, -(length * sin)]];
        match self.spring {
            GuidedSpring::None => {}
            GuidedSpring::Horizontal { .. } => {
                let (c, free) = (lengths[1], lengths[2]);
                shapes.push(spring([c * sin, c * cos, -(c * sin)], c * free.sin()));
            }
            GuidedSpring::Vertical { .. } => {
                let (c, free) = (lengths[1], lengths[2]);
                shapes.push(spring([c * cos, -(c * sin), -(c * cos)], c * free.cos()));
            }
        }
        shapes
    }

    fn common_errors<W: Worksheet>(&self, lengths: &[W::Num], angle: W::Num, sheet: W) {
        if let GuidedSpring::Horizontal { .. } = self.spring {
            sine_error([lengths[1], lengths[2], angle], sheet);
        }
    }
}

impl GuidedBar {
    fn sign(&self) -> f64 {
        if self.side == GuideSide::Above { 1.0 } else { -1.0 }
    }

    /// The bar as a mechanism; its axis runs from A to B.
    fn built(&self, loads: &[f64], at: f64) -> (PlanarMechanism, Vec<[f64; 3]>) {
        let (length, sign) = (self.length, self.sign());
        let point = |s: f64| BodyPoint::body(0, [s, 0.0]);
        let measure = match self.side {
            GuideSide::Above => RelativeCoordinate::Angle { of: Some(0), against: None },
            GuideSide::Below => RelativeCoordinate::Angle { of: None, against: Some(0) },
        };
        let corner = BodyPoint::ground([0.0; 2]);
        let mut acting = vec![
            down(point(length / 2.0), loads[0]),
            down(point(0.0), loads[1]),
            PlanarLoad::Force { at: point(length), force: [-loads[2], 0.0], turns_with: None },
        ];
        match self.spring {
            GuidedSpring::None => {}
            GuidedSpring::Horizontal { distance, free, .. } => acting.push(PlanarLoad::Effort {
                measure: RelativeCoordinate::Component {
                    direction: [1.0, 0.0],
                    from: corner,
                    to: point(distance),
                },
                effort: Effort::Spring { stiffness: loads[3], free: distance * free.sin() },
            }),
            GuidedSpring::Vertical { distance, free, .. } => acting.push(PlanarLoad::Effort {
                measure: RelativeCoordinate::Component {
                    direction: [0.0, sign],
                    from: corner,
                    to: point(length - distance),
                },
                effort: Effort::Spring { stiffness: loads[3], free: distance * free.cos() },
            }),
        }
        let mechanism = PlanarMechanism {
            bodies: vec![PlanarBody::default()],
            joints: vec![
                PlanarJoint::Slot { guide: corner, direction: FRAC_PI_2, pin: point(0.0), offset: 0.0 },
                PlanarJoint::Slot { guide: corner, direction: 0.0, pin: point(length), offset: 0.0 },
            ],
            drivers: vec![Driver { measure, value: at - FRAC_PI_2, velocity: 0.0, acceleration: 0.0 }],
            loads: acting,
            gravity: [0.0; 2],
        };
        (mechanism, vec![[0.0, sign * length * at.cos(), sign * (at - FRAC_PI_2)]])
    }

    /// The angle at which the spring is unstretched.
    fn free(&self) -> f64 {
        match self.spring {
            GuidedSpring::None => 0.0,
            GuidedSpring::Horizontal { free, .. } | GuidedSpring::Vertical { free, .. } => free,
        }
    }

    fn frame(&self, angle: f64) -> Sketch {
        let (l, sign) = (self.length, self.sign());
        let (a, b) = ((0.0, sign * l * angle.cos()), (l * angle.sin(), 0.0));
        let on = |s: f64| (b.0 * s, a.1 * (1.0 - s));
        let mut sketch = Sketch::default();
        sketch.size(1.3 * l);
        let unit = sketch.symbol();
        let (end, free) = (sign * 1.15 * l, self.free());
        if free != 0.0 {
            // The end of the bar at B where the spring is free.
            let (x, y) = (l * free.sin(), sign * l * free.cos());
            sketch.line("θ₀", (x, 0.0), (0.7 * x, 0.3 * y), Ink::Faint);
        }
        sketch
            .guide((0.0, end.max(0.0)), (0.0, end.min(0.0)))
            .guide((0.0, 0.0), (1.15 * l, 0.0))
            .slider("", a, FRAC_PI_2)
            .slider("", b, 0.0)
            .bars([a, b])
            .dimension("L", a, b, 4.0 * sign)
            .angle("θ", a, -sign * FRAC_PI_2, (-a.1).atan2(b.0))
            .joint("A", a)
            .joint("B", b);
        if self.mass > 0.0 {
            let (x, y) = on(0.5);
            sketch.mass_centre("m", (x, y)).force("W", (x, y), (x, y - 0.25 * l));
        }
        if self.force_a != Some(0.0) {
            let tail = (a.0, a.1 + 0.3 * l);
            sketch.force("", tail, (a.0, a.1 + 0.06 * l)).label("P", tail);
        }
        if self.force_b != Some(0.0) {
            let tail = (b.0 + 0.3 * l, b.1);
            sketch.force("", tail, (b.0 + 0.08 * l, b.1)).label("F", tail);
        }
        match self.spring {
            GuidedSpring::None => {}
            GuidedSpring::Horizontal { distance, .. } => {
                let (end, wall) = (on(distance / l), 1.2 * distance + 0.2 * l);
                sketch
                    .ground((wall, end.1 - 2.0 * unit), (wall, end.1 + 2.0 * unit))
                    .spring("k", (wall, end.1), end)
                    .dimension("c", a, end, -2.0 * sign);
            }
            GuidedSpring::Vertical { distance, .. } => {
                let (end, wall) = (on(1.0 - distance / l), sign * 1.3 * l.max(distance));
                let reach = 2.0 * unit * sign;
                sketch
                    .ground((end.0 + reach, wall), (end.0 - reach, wall))
                    .spring("k", (end.0, wall), end)
                    .dimension("c", b, end, -2.0 * sign);
            }
        }
        sketch
    }
}
