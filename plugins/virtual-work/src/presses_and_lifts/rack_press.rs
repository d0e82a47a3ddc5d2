//! A rack press: a handle turns a pinion that drives the ram by its rack.

use dalembert_core::{About, Analysis, Inputs, Refusal, Sketch, Worksheet, register};
use dalembert_mechanics::{
    Real,
    planar::{BodyPoint, Driver, PlanarBody, PlanarJoint, PlanarLoad, PlanarMechanism, RelativeCoordinate},
};
use std::f64::consts::TAU;

use crate::{
    shared::equilibria::{animation, solved},
    sources::{BEER, RIUL},
};

/// A handle, perhaps a pair of gears, a pinion and a rack.
#[derive(Clone, Debug, Inputs)]
pub struct RackPress {
    /// Length of the handle.
    #[input("R", "m", positive)]
    pub handle: f64,
    /// Pinion.
    pub pinion: Pinion,
    /// Turns of the handle per turn of the pinion.
    #[input("i", "1", positive, default = "1")]
    pub reduction: f64,
    /// Efficiency.
    #[input("η", "%", positive, fraction, max = 100, default = "100 %")]
    pub efficiency: f64,
    /// Find.
    pub sought: RackPressUnknown,
}

/// The size of the pinion.
#[derive(Clone, Debug, Inputs)]
pub enum Pinion {
    /// Pitch radius given
    Radius {
        /// Pitch radius.
        #[input("r", "m", positive)]
        radius: f64,
    },
    /// Module and number of teeth given
    Teeth {
        /// Module.
        #[input("m", "m", positive)]
        module: f64,
        /// Number of teeth.
        #[input("z", "1", positive)]
        teeth: f64,
    },
}

/// Unknown of the problem.
#[derive(Clone, Debug, Inputs)]
pub enum RackPressUnknown {
    /// Force of the ram
    Ram {
        /// Force on the handle, perpendicular to it.
        #[input("F", "N", positive)]
        handle: f64,
    },
    /// Force on the handle
    Handle {
        /// Force of the ram.
        #[input("Q", "N", positive)]
        ram: f64,
    },
}

register!(RackPress);

impl Analysis for RackPress {
    const ABOUT: About = About {
        id: "virtual-work/rack-press",
        title: "Rack press",
        topic: "Presses and lifts",
        summary: "Ram force of a rack press from the force on its handle, or vice versa, with the stroke per revolution.",
        main: &["ram", "mechanical_advantage"],
        keywords: "arbor press rack and pinion handle mechanical advantage prensa de cremalheira pinhão alavanca manual vantagem \
                   mecânica",
        sources: &[&BEER, &RIUL],
        cases: include_str!("../../cases/rack_press.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &RackPressGiven<W>, sheet: W) -> Result<(), Refusal> {
        if let Pinion::Teeth { teeth, .. } = self.pinion
            && (teeth.fract() != 0.0 || teeth < 4.0)
        {
            return Err(Refusal::because("a pinion must have a whole number of teeth, at least 4"));
        }
        let radius = match &given.pinion {
            PinionGiven::Radius { radius } => *radius,
            PinionGiven::Teeth { module, teeth } => {
                let outer = || *module * (*teeth + 2.0) / 2.0;
                sheet.common_error("r", "the outer radius of the pinion used", outer);
                sheet.step("r", "mm", *module * *teeth / 2.0, "Pitch radius of the pinion")
            }
        };
        let handle = sheet.step(
            "s′",
            "m",
            given.handle,
            "Virtual displacement of the hand for a unit rotation δψ of the handle",
        );
        let turn = if self.reduction == 1.0 { radius } else { radius / given.reduction };
        let ram = sheet.step(
            "x′",
            "mm",
            turn,
            "Virtual displacement of the ram per unit δψ: its rack rolls on the pinion",
        );
        let ratio = sheet.step(
            "k",
            "1",
            handle / ram,
            "Ideal force ratio: displacement of the hand over that of the ram",
        );
        let lossless = self.efficiency == 1.0;
        let reason = (
            "The virtual work of the hand, less the losses, balances that of the ram: η F δs = Q δx",
            RIUL.at("eq. 3"),
        );
        let (force, press) = match &given.sought {
            RackPressUnknownGiven::Ram { handle } => {
                let ideal = *handle * ratio;
                let press =
                    sheet.step("Q", "N", if lossless { ideal } else { ideal * given.efficiency }, reason);
                sheet.answer("ram", "Force of the ram", press);
                (*handle, press)
            }
            RackPressUnknownGiven::Handle { ram } => {
                let ideal = *ram / ratio;
                let force =
                    sheet.step("F", "N", if lossless { ideal } else { ideal / given.efficiency }, reason);
                sheet.answer("handle", "Force on the handle", force);
                (force, *ram)
            }
        };
        let advantage =
            sheet.step("a", "1", press / force, "Mechanical advantage: ratio of ram force to handle force");
        let stroke = sheet.step("X", "mm", ram * TAU, "Travel of the ram per turn of the handle");
        let hand = || force * given.handle;
        sheet.common_error("M", "the torque of the hand on the handle taken", hand);
        let tooth = sheet.step("M", "N*m", press * radius, "Torque on the pinion");
        sheet.answer("mechanical_advantage", "Mechanical advantage", advantage);
        sheet.answer("stroke", "Travel of the ram per turn of the handle", stroke);
        sheet.answer("pinion_torque", "Torque on the pinion", tooth);
        let radius = radius.value();
        sheet.verify(|| {
            let (mechanism, drawn) = self.built(radius, press.value());
            if let Some(effort) = solved(&mechanism, &drawn) {
                let torque = W::Num::from(effort.newton_euler[0]);
                let ideal = force * given.handle * given.efficiency;
                sheet.check("the torque of the hand, less the losses, from the Newton–Euler equations of handle, pinion and rack", torque, ideal);
                let what = "the torque on the pinion from the Newton–Euler equations, through the gears";
                sheet.check(what, tooth, W::Num::from(effort.newton_euler[0] * self.reduction));
            }
            let what = "the mechanical advantage from the displacements of hand and ram in one turn, and the losses";
            sheet.check(what, advantage * stroke, given.handle * given.efficiency * TAU);
        });
        sheet.show(|| animation("The press", ("", 0.5), [-0.6, 1.2], |angle| self.frame(radius, angle)));
        Ok(())
    }
}

impl RackPress {
    /// Handle, pinion and rack; the gears between handle and pinion keep the sense of the turn.
    fn built(&self, radius: f64, press: f64) -> (PlanarMechanism, Vec<[f64; 3]>) {
        let ground = BodyPoint::ground([0.0; 2]);
        let beside = BodyPoint::ground([2.0 * radius, 0.0]);
        let ram = BodyPoint::body(2, [0.0; 2]);
        let upwards = std::f64::consts::FRAC_PI_2;
        let mechanism = PlanarMechanism {
            bodies: vec![PlanarBody::default(); 3],
            joints: vec![
                PlanarJoint::Pin { a: ground, b: BodyPoint::body(0, [0.0; 2]) },
                PlanarJoint::Pin { a: ground, b: BodyPoint::body(1, [0.0; 2]) },
                PlanarJoint::Gears {
                    a: Some(0),
                    b: Some(1),
                    carrier: None,
                    sizes: [1.0, self.reduction],
                    internal: true,
                },
                PlanarJoint::Slider { guide: beside, direction: upwards, slides: ram, angle: 0.0 },
                PlanarJoint::Rack {
                    guide: BodyPoint::body(2, [-radius, 0.0]),
                    direction: upwards,
                    centre: BodyPoint::body(1, [0.0; 2]),
                    radius,
                },
            ],
            drivers: vec![Driver {
                measure: RelativeCoordinate::Angle { of: Some(0), against: None },
                value: 0.0,
                velocity: 0.0,
                acceleration: 0.0,
            }],
            loads: vec![PlanarLoad::Force { at: ram, force: [0.0, -press], turns_with: None }],
            gravity: [0.0; 2],
        };
        (mechanism, vec![[0.0; 3], [0.0; 3], [2.0 * radius, 0.0, 0.0]])
    }

    fn frame(&self, radius: f64, angle: f64) -> Sketch {
        let r = radius;
        let length = self.handle.min(8.0 * r);
        let end = (-length * angle.cos(), length * angle.sin());
        let down = r * (angle + 0.6) / self.reduction;
        let (top, bottom) = (3.0 * r - down, -3.5 * r - down);
        let across = (end.0 - length * 0.35 * angle.sin(), end.1 - length * 0.35 * angle.cos());
        let mut sketch = Sketch::default();
        sketch
            .size(12.0 * r)
            .ground((-2.0 * r, -6.5 * r), (4.0 * r, -6.5 * r))
            .gear("", (0.0, 0.0), r, -angle)
            .link("R", (0.0, 0.0), end)
            .mass("", (1.25 * r, bottom), (1.9 * r, top));
        for tooth in 0..12 {
            let y = bottom + (f64::from(tooth) + 0.5) * (top - bottom) / 12.0;
            sketch.bars([(r, y), (1.25 * r, y)]);
        }
        for side in [-1.0, 1.0] {
            let wall = [(2.1 * r, side * 1.5 * r - r), (2.1 * r, side * 1.5 * r + r)];
            sketch.ground(wall[0], wall[1]);
        }
        sketch.dimension("r", (0.0, 0.0), (0.0, -r), 0.0).pin("", (0.0, 0.0)).force("F", end, across).force(
            "Q",
            (1.4 * r, bottom),
            (1.4 * r, bottom - 1.5 * r),
        );
        sketch
    }
}
