//! A bar on a pin, held by a cord that runs over a pulley above the pin to a hanging mass.

use std::f64::consts::FRAC_PI_2;

use dalembert_core::{About, Analysis, Inputs, Refusal, Sketch, Worksheet, register};
use dalembert_mechanics::{
    Real,
    planar::{BodyPoint, Driver, PlanarBody, PlanarJoint, PlanarMechanism, RelativeCoordinate},
};

pub use crate::shared::one_degree_of_freedom::Position;
use crate::shared::one_degree_of_freedom::PositionGiven;
use crate::{
    shared::{
        equilibria::down,
        one_degree_of_freedom::{PotentialTerm, Shapes, SingleDofMachine},
    },
    sources::{BEER, HIBBELER, RIUL},
};

/// A uniform bar, a cord over a small smooth pulley, a hanging mass.
#[derive(Clone, Debug, Inputs)]
pub struct BarAndCord {
    /// Mass of the bar.
    /// Uniform: its weight acts in the middle.
    #[input("M", "kg", positive)]
    pub bar: f64,
    /// Length of the bar.
    #[input("L", "m", positive)]
    pub length: f64,
    /// Distance of the cord's end from the pin, along the bar.
    #[input("b", "m", positive)]
    pub attachment: f64,
    /// Height of the pulley above the pin.
    #[input("h", "m", positive)]
    pub pulley: f64,
    /// Hanging mass.
    /// If left blank, it is computed from the position.
    #[input("m", "kg", positive)]
    pub mass: Option<f64>,
    /// Acceleration of gravity.
    #[input("g", "m/s^2", positive, default = "9.81 m/s^2")]
    pub gravity: f64,
    /// Position.
    /// The angle θ of the bar is measured upwards from the horizontal.
    pub position: Position,
}

register!(BarAndCord);

impl Analysis for BarAndCord {
    const ABOUT: About = About {
        id: "virtual-work/bar-and-cord",
        title: "Bar held by a cord over a pulley",
        topic: "Bars and levers",
        summary: "The hanging mass that holds a hinged bar at an angle, or all angles at which a mass holds it, and whether they are stable.",
        main: &["hanging_weight", "mass", "stable_angle", "unstable_angle"],
        keywords: "drawbridge counterweight pulley cord potential energy stability ponte levadiça contrapeso polia corda \
                   barra energia potencial estabilidade",
        sources: &[&HIBBELER, &BEER, &RIUL],
        cases: include_str!("../../cases/bar_and_cord.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &BarAndCordGiven<W>, sheet: W) -> Result<(), Refusal> {
        let bar = sheet.step("W", "N", given.bar * given.gravity, "Weight of the bar");
        let hanging =
            given.mass.map(|mass| sheet.step("P", "N", mass * given.gravity, "Weight of the hanging mass"));
        let lengths = [given.length, given.attachment, given.pulley];
        let parts = [
            PotentialTerm {
                name: "weight of the bar",
                load: Some(bar),
                rate: [
                    "y′_G",
                    "m",
                    "Upward virtual displacement of the centre of mass of the bar per unit δθ",
                ],
                symbol: ["W", "N"],
                answer: ["bar_weight", "Weight of the bar"],
            },
            PotentialTerm {
                name: "weight of the hanging mass",
                load: hanging,
                rate: ["y′_P", "m", "Upward virtual displacement of the hanging mass per unit δθ"],
                symbol: ["P", "N"],
                answer: ["hanging_weight", "Hanging weight for equilibrium"],
            },
        ];
        let machine =
            SingleDofMachine { shapes: self, lengths: &lengths, parts: &parts, joints: &["Pin of the bar"] };
        let balanced = machine.solve(&given.position, sheet, |loads, at| self.built(loads, at))?;
        if let Some(weight) = balanced.load {
            let mass = sheet.step("m", "kg", weight / given.gravity, "Hanging mass");
            sheet.answer("mass", "Hanging mass for equilibrium", mass);
            sheet.verify(|| {
                // The cord pulls along its line, whose arm about the pin is b h cos θ/s.
                let PositionGiven::Given { angle } = &given.position else { return };
                let (arm, height) =
                    (given.attachment * angle.cos(), given.pulley - given.attachment * angle.sin());
                let line = (arm.powi(2) + height.powi(2)).sqrt();
                let pull = mass * given.gravity * given.pulley * arm / line;
                let what = "the moment of the cord about the pin of the bar is that of its weight";
                sheet.check(what, pull, bar * given.length * angle.cos() / 2.0);
            });
            if mass.value() < 0.0 {
                sheet.warn(|| "the mass is negative: at this angle the cord would have to push".into());
            }
        }
        sheet
            .show(|| balanced.animation("The bar, its cord and its counterweight", 0.5, |at| self.frame(at)));
        Ok(())
    }
}

impl Shapes for BarAndCord {
    fn shapes<N: Real>(&self, lengths: &[N], angle: N) -> Vec<[N; 3]> {
        let s = cord(lengths, angle);
        let s1 = cord_rate(lengths, angle, s);
        rises(lengths, angle, s, s1)
    }

    fn written<W: Worksheet>(
        &self,
        lengths: &[W::Num],
        angle: W::Num,
        n: usize,
        sheet: W,
    ) -> Vec<[W::Num; 3]> {
        let s = sheet.step(
            ("s", n),
            "m",
            cord(lengths, angle),
            "Length of the cord between bar and pulley, by the law of cosines",
        );
        let attachment = lengths[1];
        sheet.common_error(("s′", n), "the cord taken as perpendicular to the bar", || -attachment);
        sheet.common_error(("s′", n), "the cord taken as vertical", || -(attachment * angle.cos()));
        let s1 = sheet.step(
            ("s′", n),
            "m",
            cord_rate(lengths, angle, s),
            "Its virtual elongation per δθ, equal to the rise of the hanging mass: 2 s δs = −2 b h cos θ δθ",
        );
        rises(lengths, angle, s, s1)
    }
}

/// The length of the cord between bar and pulley.
fn cord<N: Real>(lengths: &[N], angle: N) -> N {
    let [b, h] = [lengths[1], lengths[2]];
    (b.powi(2) + h.powi(2) - b * h * angle.sin() * 2.0).sqrt()
}

fn cord_rate<N: Real>(lengths: &[N], angle: N, s: N) -> N {
    -(lengths[1] * lengths[2] * angle.cos() / s)
}

/// The heights of the centre of mass of the bar and of the hanging mass, with their derivatives.
fn rises<N: Real>(lengths: &[N], angle: N, s: N, s1: N) -> Vec<[N; 3]> {
    let [l, b, h] = [lengths[0], lengths[1], lengths[2]];
    let (sin, cos) = (angle.sin(), angle.cos());
    vec![[l / 2.0 * sin, l / 2.0 * cos, -(l / 2.0 * sin)], [s, s1, (b * h * sin - s1.powi(2)) / s]]
}

impl BarAndCord {
    fn built(&self, loads: &[f64], at: f64) -> (PlanarMechanism, Vec<[f64; 3]>) {
        let bar = |s: f64| BodyPoint::body(0, [s, 0.0]);
        let block = BodyPoint::body(1, [0.0; 2]);
        // The pulley is a point; the mass hangs beside the bar, from a point at the same height.
        let side = -0.2 * self.pulley;
        let (over, above) = (BodyPoint::ground([0.0, self.pulley]), BodyPoint::ground([side, self.pulley]));
        let mechanism = PlanarMechanism {
            bodies: vec![PlanarBody::default(); 2],
            joints: vec![
                PlanarJoint::Pin { a: BodyPoint::ground([0.0; 2]), b: bar(0.0) },
                PlanarJoint::Slider { guide: above, direction: FRAC_PI_2, slides: block, angle: 0.0 },
                PlanarJoint::Cord {
                    runs: vec![[over, bar(self.attachment)], [above, block]],
                    drums: Vec::new(),
                },
            ],
            drivers: vec![Driver {
                measure: RelativeCoordinate::Angle { of: Some(0), against: None },
                value: at,
                velocity: 0.0,
                acceleration: 0.0,
            }],
            loads: vec![down(bar(self.length / 2.0), loads[0]), down(block, loads[1])],
            gravity: [0.0; 2],
        };
        (mechanism, vec![[0.0, 0.0, at], [side, 0.0, 0.0]])
    }

    fn frame(&self, angle: f64) -> Sketch {
        let (l, b, h) = (self.length, self.attachment, self.pulley);
        let on = |s: f64| (s * angle.cos(), s * angle.sin());
        let s = (on(b).0).hypot(h - on(b).1);
        let level = h - 0.4 * h - ((b + h) - s) * 0.4;
        let middle = on(l / 2.0);
        // The bar is a plate, as that of a bridge.
        let (along, thick) = (on(l), 0.03 * l);
        let across = (-thick * angle.sin(), thick * angle.cos());
        let deck = [(0.0, 0.0), along, (along.0 - across.0, along.1 - across.1), (-across.0, -across.1)];
        let mut sketch = Sketch::default();
        sketch
            .size(l.max(1.1 * h))
            .axis((0.0, 0.0), (1.1 * l, 0.0))
            .body("", deck)
            .dimension("h", (0.0, 0.0), (0.0, h), 8.0)
            .mass_centre("M", middle)
            .pin("", (0.0, 0.0))
            .pulley("", (-0.06 * h, h), 0.06 * h)
            .bars([on(b), (0.0, h)])
            .bars([(-0.12 * h, h), (-0.12 * h, level)])
            .particle("m", (-0.12 * h, level))
            .angle("θ", (0.0, 0.0), 0.0, angle)
            .force("W", middle, (middle.0, middle.1 - 0.3 * h));
        if b == l {
            sketch.dimension("b, L", (0.0, 0.0), on(l), -2.0);
        } else {
            sketch.dimension("b", (0.0, 0.0), on(b), -2.0).dimension("L", (0.0, 0.0), on(l), -5.0);
        }
        sketch
    }
}
