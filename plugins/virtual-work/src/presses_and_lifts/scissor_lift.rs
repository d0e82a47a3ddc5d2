//! A scissor lift of one or more stages, raised by a cylinder between any two of its points.

mod mechanism;
mod picture;

use dalembert_core::{About, Analysis, Exhibit, Inputs, Refusal, Worksheet, register};
use dalembert_mechanics::Real;

use crate::{
    shared::equilibria::animation,
    sources::{BEER, HIBBELER, RIUL},
};

/// A table on crossed bars; its left joints stand above each other, its right ones slide.
///
/// The origin is the fixed foot on the left, x to the right, y up.
#[derive(Clone, Debug, Inputs)]
pub struct ScissorLift {
    /// Stages.
    #[input(min = 1, max = 10)]
    pub stages: u32,
    /// Length of each bar.
    #[input("L", "m", positive)]
    pub bar: f64,
    /// Angle of the bars from the horizontal.
    #[input("θ", "deg", positive, below = 90)]
    pub angle: f64,
    /// Weight of each bar.
    /// Uniform: it acts in the middle.
    #[input("G", "N", nonnegative, default = "0 N")]
    pub bar_weight: f64,
    /// Number of frames side by side, each with a cylinder.
    /// They share the load evenly.
    #[input(min = 1, max = 10)]
    pub frames: u32,
    /// Lower end of the cylinder.
    pub lower: CylinderEnd,
    /// Upper end of the cylinder.
    pub upper: CylinderEnd,
    /// Find.
    pub sought: ScissorLiftUnknown,
    /// Extension speed of the cylinder.
    /// If given, the speed of the table is also calculated.
    #[input("v", "m/s")]
    pub speed: Option<f64>,
}

/// A point of the lift.
#[derive(Clone, Debug, Inputs)]
pub enum CylinderEnd {
    /// On the ground
    Ground {
        /// Distance to the right of the fixed foot.
        #[input("x", "m")]
        x: f64,
        /// Height above the fixed foot.
        #[input("y", "m", default = "0 m")]
        y: f64,
    },
    /// On the table
    Table {
        /// Distance to the right of the left joint.
        #[input("x", "m")]
        x: f64,
        /// Height above the joints.
        #[input("y", "m", default = "0 m")]
        y: f64,
    },
    /// On a bar that rises to the right
    Rising {
        /// Stage, numbered from the bottom.
        #[input(min = 1, max = 10)]
        stage: u32,
        /// Distance from its lower end.
        #[input("d", "m")]
        distance: f64,
    },
    /// On a bar that rises to the left
    Falling {
        /// Stage, numbered from the bottom.
        #[input(min = 1, max = 10)]
        stage: u32,
        /// Distance from its lower end.
        #[input("d", "m")]
        distance: f64,
    },
}

/// Unknown of the problem.
#[derive(Clone, Debug, Inputs)]
pub enum ScissorLiftUnknown {
    /// Force of the cylinder
    Cylinder {
        /// Load on the table.
        #[input("W", "N", nonnegative)]
        load: f64,
    },
    /// Load on the table
    Load {
        /// Force of each cylinder.
        #[input("F", "N", positive)]
        cylinder: f64,
    },
}

register!(ScissorLift);

/// Position of a point and its virtual displacement for δθ; a zero displacement is omitted.
struct Place<N> {
    at: [N; 2],
    way: [Option<N>; 2],
}

impl Analysis for ScissorLift {
    const ABOUT: About = About {
        id: "virtual-work/scissor-lift",
        title: "Scissor lift",
        topic: "Presses and lifts",
        summary: "Force of the cylinder of a scissor lift of any number of stages, or the load that it lifts, with lifting speed and forces in the pins.",
        main: &["cylinder_force", "load"],
        keywords: "hydraulic lift table platform cylinder stages plataforma pantográfica mesa elevadora tesoura cilindro \
                   hidráulico pistão",
        sources: &[&BEER, &HIBBELER, &RIUL],
        cases: include_str!("../../cases/scissor_lift.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &ScissorLiftGiven<W>, sheet: W) -> Result<(), Refusal> {
        for end in [&self.lower, &self.upper] {
            if let CylinderEnd::Rising { stage, .. } | CylinderEnd::Falling { stage, .. } = end
                && *stage > self.stages
            {
                return Err(Refusal::because(
                    "the cylinder is fixed to a stage that the lift does not have: choose a lower stage or more stages",
                ));
            }
        }
        let (length, theta, stages) = (given.bar, given.angle, f64::from(self.stages));
        let from = place(&self.lower, &given.lower, length, theta, self.stages);
        let to = place(&self.upper, &given.upper, length, theta, self.stages);
        let rows = [
            ("Δx", "Horizontal distance between the ends of the cylinder"),
            ("Δy", "Vertical distance between the ends of the cylinder"),
        ];
        let spans: Vec<W::Num> = [0, 1]
            .into_iter()
            .map(|axis| sheet.step(rows[axis].0, "m", to.at[axis] - from.at[axis], rows[axis].1))
            .collect();
        if spans.iter().all(|span| span.value() == 0.0) {
            return Err(Refusal::because(
                "both ends of the cylinder are at the same point: it has no length",
            ));
        }
        let length_of_cylinder = sheet.step(
            "c",
            "m",
            W::Num::sum(spans.iter().map(|span| span.powi(2))).sqrt(),
            "Length of the cylinder",
        );
        sheet.answer("cylinder_length", "Length of the cylinder", length_of_cylinder);
        let ways: Vec<W::Num> = [0, 1]
            .into_iter()
            .filter_map(|axis| {
                let way = difference(from.way[axis], to.way[axis])?;
                let way = sheet.step(["Δx′", "Δy′"][axis], "m", way, "Its virtual variation per δθ");
                Some(spans[axis] * way)
            })
            .collect();
        let stuck = || {
            Refusal::because(
                "in this position the length of the cylinder does not change with the height of the table (dead centre): no force lifts it",
            )
        };
        if ways.is_empty() {
            return Err(stuck());
        }
        let moved = || {
            let way = |axis: usize| difference(from.way[axis], to.way[axis]);
            W::Num::sum([0, 1].into_iter().filter_map(way).map(|way| way.powi(2))).sqrt()
        };
        sheet.common_error("c′", "the whole relative displacement of the ends taken", moved);
        let growth = sheet.step(
            "c′",
            "m",
            W::Num::sum(ways) / length_of_cylinder,
            "Virtual elongation of the cylinder per unit δθ: 2 c δc = 2 Δx δΔx + 2 Δy δΔy",
        );
        if growth.value().abs() < 1e-9 * length.value() {
            return Err(stuck());
        }
        let rise = sheet.step(
            "h′",
            "m",
            length * theta.cos() * stages,
            "Upward virtual displacement of the table per unit δθ, from h = n L sin θ",
        );
        let bars = (self.bar_weight > 0.0).then(|| {
            sheet.step(
                "U_G",
                "N*m",
                given.bar_weight * rise * stages,
                "Virtual work against the weights of the 2 n bars of a frame, whose mean rise is half that of the table",
            )
        });
        let reason = "The total virtual work of cylinder, load and weights of a frame is zero";
        let frames = f64::from(self.frames);
        let (force, load) = match &given.sought {
            ScissorLiftUnknownGiven::Cylinder { load } => {
                let share = if self.frames == 1 { *load } else { *load / frames };
                let work = bars.map_or(share * rise, |bars| share * rise + bars);
                let leaned = || share * length_of_cylinder / spans[1];
                sheet.common_error("F", "the load taken to rest on the inclined cylinder alone", leaned);
                let between_feet = || share * stages / theta.tan();
                sheet.common_error(
                    "F",
                    "the formula for a cylinder between the feet, nW/tan θ, used",
                    between_feet,
                );
                let force = sheet.step("F", "N", work / growth, (reason, RIUL.at("eq. 3")));
                sheet.answer("cylinder_force", "Force of each cylinder", force);
                (force, *load)
            }
            ScissorLiftUnknownGiven::Load { cylinder } => {
                let work = bars.map_or(*cylinder * growth, |bars| *cylinder * growth - bars);
                let load = if self.frames == 1 { work / rise } else { work / rise * frames };
                let leaned = || *cylinder * spans[1] / length_of_cylinder * frames;
                sheet.common_error("W", "the load taken to rest on the inclined cylinder alone", leaned);
                let between_feet = || *cylinder * theta.tan() / stages * frames;
                sheet.common_error(
                    "W",
                    "the formula for a cylinder between the feet, nW/tan θ, used",
                    between_feet,
                );
                let load = sheet.step("W", "N", load, (reason, RIUL.at("eq. 3")));
                sheet.answer("load", "Load on the table", load);
                (*cylinder, load)
            }
        };
        if force.value() < 0.0 || load.value() < 0.0 {
            sheet.warn(|| "the cylinder pulls: it becomes shorter as the table rises".into());
        }
        let height = sheet.step("h", "m", length * theta.sin() * stages, "Height of the table");
        let ratio = sheet.step("r", "1", rise / growth, "Displacement ratio, table over cylinder");
        sheet.answer("height", "Height of the table", height);
        sheet.answer("speed_ratio", "Displacement ratio, table over cylinder", ratio);
        sheet.verify(|| {
            let apart = length * theta.cos() * stages;
            let what = "height of the table by Pythagoras, from the bars and the distance between the feet";
            sheet.check(what, height.powi(2) + apart.powi(2), (length * stages).powi(2));
            let weightless = Self { bar_weight: 0.0, ..self.clone() };
            if let Some(effort) = weightless.solved(self.angle, 1.0) {
                let what = "displacement ratio, table over cylinder, as the force of the cylinder for a unit load, without weights of bars";
                sheet.check_sum(what, ratio, effort.newton_euler[0].into(), ratio.value().abs().max(1.0));
            }
        });
        if let Some(speed) = given.speed {
            let upward = || speed * spans[1] / length_of_cylinder;
            sheet.common_error("v_T", "the vertical component of the speed of the cylinder taken", upward);
            let table = sheet.step("v_T", "m/s", speed * ratio, "Speed of the table");
            sheet.answer("table_speed", "Speed of the table", table);
            sheet.verify(|| {
                let weights = given.bar_weight * (stages * frames);
                let what = "power of the cylinders and of what they lift";
                let size = force.value().abs() * frames * speed.value().abs();
                let lifted = (load + weights) * table;
                sheet.check_sum(what, force * frames * speed, lifted, size.max(lifted.value().abs()));
            });
        }
        let share = load.value() / frames;
        sheet.verify(|| {
            if let Some(effort) = self.solved(self.angle, share) {
                let size = force.value().abs().max(share.abs());
                sheet.check_sum(
                    "the force of the cylinder from the Newton–Euler equations of every bar",
                    force,
                    effort.newton_euler[0].into(),
                    size,
                );
            }
        });
        sheet.verify(|| {
            if let Some(table) = self.pins(share) {
                sheet.show(|| Exhibit::Table(table));
            }
        });
        let force = force.value();
        sheet.show(|| Exhibit::Plot(self.force_over_angle(share, force)));
        let range = [(0.4 * self.angle).max(0.08), (1.3 * self.angle).min(1.35)];
        sheet.show(|| animation("The lift", ("angle", self.angle), range, |angle| self.frame(angle)));
        Ok(())
    }
}

/// Position of an end of the cylinder and its virtual displacement for δθ.
fn place<W: Worksheet>(
    end: &CylinderEnd,
    given: &CylinderEndGiven<W>,
    length: W::Num,
    angle: W::Num,
    stages: u32,
) -> Place<W::Num> {
    let lifted = |below: u32, distance: W::Num| match below {
        0 => distance,
        below => length * f64::from(below) + distance,
    };
    let (sin, cos) = (angle.sin(), angle.cos());
    match (end, given) {
        (CylinderEnd::Ground { .. }, CylinderEndGiven::Ground { x, y }) => {
            Place { at: [*x, *y], way: [None, None] }
        }
        (CylinderEnd::Table { .. }, CylinderEndGiven::Table { x, y }) => {
            let all = length * f64::from(stages);
            Place { at: [*x, all * sin + *y], way: [None, Some(all * cos)] }
        }
        (CylinderEnd::Rising { stage, .. }, CylinderEndGiven::Rising { distance, .. }) => {
            let up = lifted(stage - 1, *distance);
            Place { at: [*distance * cos, up * sin], way: [Some(-(*distance * sin)), Some(up * cos)] }
        }
        (CylinderEnd::Falling { stage, .. }, CylinderEndGiven::Falling { distance, .. }) => {
            let (up, left) = (lifted(stage - 1, *distance), length - *distance);
            Place { at: [left * cos, up * sin], way: [Some(-(left * sin)), Some(up * cos)] }
        }
        _ => unreachable!("the given numbers are those of this end"),
    }
}

fn difference<N: Real>(from: Option<N>, to: Option<N>) -> Option<N> {
    match (from, to) {
        (Some(from), Some(to)) => Some(to - from),
        (Some(from), None) => Some(-from),
        (None, to) => to,
    }
}
