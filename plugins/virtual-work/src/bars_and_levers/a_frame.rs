//! Two ladders leaning against each other on a smooth floor, held at their feet or by a rope.

use std::f64::consts::FRAC_PI_2;

use dalembert_core::{
    About, Analysis, Axis, Drawing, Exhibit, Ink, Inputs, Plot, Refusal, Series, Sketch, Worksheet, register,
};
use dalembert_mechanics::{
    Real,
    planar::{BodyPoint, Driver, PlanarBody, PlanarJoint, PlanarMechanism, RelativeCoordinate},
};

use crate::{
    shared::equilibria::{down, solved, spread},
    sources::{BEER, HIBBELER, RIUL},
};

/// Two equal uniform ladders hinged at the top.
#[derive(Clone, Debug, Inputs)]
pub struct AFrame {
    /// Length of each ladder.
    #[input("L", "m", positive)]
    pub length: f64,
    /// Weight of each ladder.
    #[input("W", "N", nonnegative)]
    pub weight: f64,
    /// Load at the hinge.
    #[input("Q", "N", nonnegative, default = "0 N")]
    pub load: f64,
    /// Restraint of the feet.
    pub held: FootRestraint,
    /// Find.
    pub sought: AFrameUnknown,
}

/// Restraint of the feet against sliding apart.
#[derive(Clone, Copy, Debug, PartialEq, Inputs)]
pub enum FootRestraint {
    /// Horizontal forces at the feet
    Feet,
    /// A rope between the ladders
    Rope {
        /// Attachment point, from the hinge, as a fraction of the length.
        #[input("s", "1", positive, max = 1)]
        part: f64,
    },
}

/// Unknown of the problem.
#[derive(Clone, Debug, Inputs)]
pub enum AFrameUnknown {
    /// Force at a given angle
    Force {
        /// Angle of each ladder from the vertical.
        #[input("θ", "deg", positive, below = 90)]
        angle: f64,
    },
    /// Equilibrium angle for a given force
    Angle {
        /// Force at each foot, or tension of the rope.
        #[input("T", "N", positive)]
        force: f64,
    },
}

register!(AFrame);

impl Analysis for AFrame {
    const ABOUT: About = About {
        id: "virtual-work/a-frame",
        title: "Step ladder",
        topic: "Bars and levers",
        summary: "Force at the feet or tension of the rope of two ladders leaning against each other, or the equilibrium angle for a given force.",
        main: &["force", "friction", "angle"],
        keywords: "A-frame trestle step ladder rope tie escada dupla cavalete corda tirante força nos pés",
        sources: &[&BEER, &HIBBELER, &RIUL],
        cases: include_str!("../../cases/a_frame.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &AFrameGiven<W>, sheet: W) -> Result<(), Refusal> {
        if self.weight == 0.0 && self.load == 0.0 {
            return Err(Refusal::because("neither ladders nor hinge are loaded: write a weight or a load"));
        }
        let AFrameGiven { length, weight, load, held, sought, .. } = given;
        let spread_part = |x: W::Num| match held {
            FootRestraintGiven::Feet {} => x,
            FootRestraintGiven::Rope { part } => x * *part,
        };
        let reason =
            "The total virtual work of weights, load and holding force is zero: 2 W δy_G + Q δy + T δx = 0";
        let (angle, force) = match sought {
            AFrameUnknownGiven::Force { angle } => {
                let fall = sheet.step(
                    "y′",
                    "m",
                    *length * angle.sin(),
                    "Downward virtual displacement of the hinge per unit δθ, from y = L cos θ; that of each centre of mass is half of it",
                );
                let apart = sheet.step(
                    "x′",
                    "m",
                    spread_part(*length * angle.cos()) * 2.0,
                    "Virtual increase of the restrained distance per unit δθ",
                );
                if let FootRestraint::Feet = self.held {
                    let leaning = || (*weight + *load / 2.0) * angle.tan();
                    sheet.common_error(
                        "T",
                        "the force of the floor on a foot taken along the ladder, as in a two-force member",
                        leaning,
                    );
                }
                let force =
                    sheet.step("T", "N", (*weight + *load) * fall / apart, (reason, RIUL.at("eq. 3")));
                match self.held {
                    FootRestraint::Feet => sheet.answer("force", "Force at each foot", force),
                    FootRestraint::Rope { .. } => sheet.answer("force", "Tension of the rope", force),
                }
                (*angle, force)
            }
            AFrameUnknownGiven::Angle { force } => {
                if let FootRestraint::Feet = self.held {
                    let leaning = || *force / (*weight + *load / 2.0);
                    sheet.common_error(
                        "tan θ",
                        "the force of the floor on a foot taken along the ladder, as in a two-force member",
                        leaning,
                    );
                }
                let slope = sheet.step(
                    "tan θ",
                    "1",
                    spread_part(*force * 2.0) / (*weight + *load),
                    (reason, RIUL.at("eq. 3")),
                );
                let angle = sheet.step(
                    "θ",
                    "deg",
                    slope.atan2(W::Num::from(1.0)),
                    "Angle of each ladder from the vertical",
                );
                sheet.answer("angle", "Angle of each ladder from the vertical", angle);
                (angle, *force)
            }
        };
        let floor = sheet.step("N", "N", *weight + *load / 2.0, "Force of the floor on each foot");
        sheet.answer("floor_force", "Force of the floor on each foot", floor);
        let friction = matches!(self.held, FootRestraint::Feet).then(|| {
            let friction =
                sheet.step("μ", "1", force / floor, "Coefficient of friction required at the feet");
            sheet.answer("friction", "Coefficient of friction required at the feet", friction);
            friction
        });
        sheet.verify(|| {
            let arm = match held {
                FootRestraintGiven::Feet {} => *length * angle.cos(),
                FootRestraintGiven::Rope { part } => *length * angle.cos() * *part,
            };
            let moment = floor * *length * angle.sin() - *weight * *length * angle.sin() / 2.0;
            sheet.check("the force from the moments on one ladder about the hinge", moment / arm, force);
            let (mechanism, drawn) = self.built(angle.value());
            if let Some(effort) = solved(&mechanism, &drawn) {
                let found = W::Num::from(-effort.newton_euler[0]);
                sheet.check("the force from the Newton–Euler equations of every body", found, force);
                let floor_by_them = W::Num::from(effort.multipliers[3]);
                sheet.check("the force of the floor from the Newton–Euler equations", floor_by_them, floor);
                if let Some(friction) = friction {
                    let leaning = W::Num::from(-effort.newton_euler[0] / effort.multipliers[3]);
                    let what = "the coefficient of friction from the direction of the force on a foot, by the Newton–Euler equations";
                    sheet.check(what, leaning, friction);
                }
            }
        });
        if angle.value() > 80f64.to_radians() {
            sheet.warn(|| {
                "the ladders are nearly horizontal: a small sliding greatly changes the force".into()
            });
        }
        let (at, size) = (angle.value(), force.value());
        sheet.show(|| Exhibit::Plot(self.force_over_angle(at, size)));
        sheet.show(|| Exhibit::Drawing(self.drawing(at)));
        Ok(())
    }
}

impl AFrame {
    fn part(&self) -> f64 {
        match self.held {
            FootRestraint::Feet => 1.0,
            FootRestraint::Rope { part } => part,
        }
    }

    /// Both ladders from the hinge downwards; the hinge stays on the line of symmetry.
    fn built(&self, at: f64) -> (PlanarMechanism, Vec<[f64; 3]>) {
        let l = self.length;
        let on = |body: usize, s: f64| BodyPoint::body(body, [s, 0.0]);
        let floor = BodyPoint::ground([0.0; 2]);
        let mechanism = PlanarMechanism {
            bodies: vec![PlanarBody::default(); 2],
            joints: vec![
                PlanarJoint::Pin { a: on(0, 0.0), b: on(1, 0.0) },
                PlanarJoint::Slot { guide: floor, direction: FRAC_PI_2, pin: on(0, 0.0), offset: 0.0 },
                PlanarJoint::Slot { guide: floor, direction: 0.0, pin: on(0, l), offset: 0.0 },
                PlanarJoint::Slot { guide: floor, direction: 0.0, pin: on(1, l), offset: 0.0 },
            ],
            drivers: vec![Driver {
                measure: RelativeCoordinate::Component {
                    direction: [1.0, 0.0],
                    from: on(0, self.part() * l),
                    to: on(1, self.part() * l),
                },
                value: 2.0 * self.part() * l * at.sin(),
                velocity: 0.0,
                acceleration: 0.0,
            }],
            loads: vec![
                down(on(0, l / 2.0), self.weight),
                down(on(1, l / 2.0), self.weight),
                down(on(0, 0.0), self.load),
            ],
            gravity: [0.0; 2],
        };
        let top = l * at.cos();
        (mechanism, vec![[0.0, top, -FRAC_PI_2 - at], [0.0, top, at - FRAC_PI_2]])
    }

    fn force_over_angle(&self, at: f64, force: f64) -> Plot {
        let held = |angle: f64| (angle, (self.weight + self.load) * angle.tan() / (2.0 * self.part()));
        Plot::new(
            "Holding force against the angle of the ladders",
            Axis::linear("angle from the vertical", "deg"),
            Axis::linear("holding force", "N"),
            vec![Series::line("T", spread([0.0, 1.4], 280).map(held).collect()).of("force")],
        )
        .over("sought.force.angle")
        .mark("at this angle", (at, force))
    }

    fn drawing(&self, at: f64) -> Drawing {
        let l = self.length;
        let (top, foot) = (l * at.cos(), l * at.sin());
        let on = |s: f64, side: f64| (side * s * foot, top * (1.0 - s));
        let mut sketch = Sketch::new("The step ladder");
        sketch
            .ground((-1.3 * foot, 0.0), (1.3 * foot, 0.0))
            .axis((0.0, 0.0), (0.0, top))
            .link("", on(1.0, -1.0), (0.0, top))
            .link("", on(1.0, 1.0), (0.0, top))
            .dimension("L", (0.0, top), on(1.0, 1.0), 2.0)
            .joint("", (0.0, top))
            .angle("θ", (0.0, top), -FRAC_PI_2, at - FRAC_PI_2);
        for side in [-1.0, 1.0] {
            if self.weight > 0.0 {
                let (x, y) = on(0.5, side);
                sketch.force("W", (x, y), (x, y - 0.2 * l));
            }
            if self.held == FootRestraint::Feet {
                let (x, y) = on(1.0, side);
                sketch
                    .force("", (x + side * 0.3 * l, y), (x + side * 0.05 * l, y))
                    .label("T", (x + side * 0.3 * l, y));
            }
        }
        if self.load > 0.0 {
            sketch.force("", (0.0, top + 0.3 * l), (0.0, top + 0.03 * l)).label("Q", (0.0, top + 0.3 * l));
        }
        if let FootRestraint::Rope { part } = self.held {
            sketch.line("T", on(part, -1.0), on(part, 1.0), Ink::Result);
        }
        sketch.finish()
    }
}
