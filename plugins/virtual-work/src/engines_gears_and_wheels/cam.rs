//! Cam and follower: motion program, contact, profile, force and torque.

mod contact;
mod follower;
mod law;
mod load;
mod motion;
mod pictures;
mod program;

use dalembert_core::{About, Analysis, Exhibit, Inputs, Refusal, Worksheet, register};

use self::{
    follower::CamFollower,
    load::FollowerLoad,
    pictures::View,
    program::{Motion, MotionProgram},
};
use crate::sources::{KHURMI, NORTON, SHIGLEY};

/// A disc cam that turns at a constant speed, and its follower.
///
/// Cam angles are measured from the start of the program; a cam with a translating follower turns counter-clockwise below it.
#[derive(Clone, Debug, Inputs)]
pub struct Cam {
    /// Motion of the follower.
    pub program: MotionProgram,
    /// Speed of the cam.
    /// Left out, the motion is answered per radian of the cam.
    #[input("ω", "rpm", positive)]
    pub speed: Option<f64>,
    /// Cam angle.
    /// At which motion, contact and force are required.
    #[input("θ", "deg")]
    pub angle: Option<f64>,
    /// Follower.
    #[input(default = "motion")]
    pub follower: CamFollower,
    /// Force on the follower.
    pub load: Option<FollowerLoad>,
}

register!(Cam);

impl Analysis for Cam {
    const ABOUT: About = About {
        id: "virtual-work/cam",
        title: "Cam and follower",
        topic: "Engines, gears and wheels",
        summary: "Lift, velocity, acceleration and jerk of a motion program, pressure angle, radius of curvature and profile of a disc cam with a knife-edge, roller, flat-faced or oscillating follower, and the force and torque.",
        main: &[
            "lift",
            "base_radius",
            "pressure_angle",
            "rise_pressure_angle",
            "rise_acceleration",
            "rise_velocity",
            "jump_speed",
        ],
        keywords: "came seguidor ressalto cam follower SVAJ rise dwell return fall outstroke cycloidal simple harmonic parabolic 3-4-5 \
                   4-5-6-7 polynomial modified trapezoid modified sine pressure angle undercutting base circle prime \
                   circle flat-faced roller oscillating jerk ângulo de pressão cicloidal camo excêntrico",
        sources: &[&NORTON, &SHIGLEY, &KHURMI],
        cases: include_str!("../../cases/cam.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &CamGiven<W>, sheet: W) -> Result<(), Refusal> {
        let course = self.program.course()?;
        self.follower.fits(&course)?;
        let sizes = motion::sizes(&given.program);
        motion::peaks(given.speed, &course, &sizes, sheet);
        motion::jumps(&course, sheet);
        let outline = follower::outline(&self.follower, &given.follower, &course, sheet)?;
        let position = match given.angle {
            Some(angle) => Some(motion::at(angle, given.speed, &course, &sizes, sheet)?),
            None => None,
        };
        let pressure = match (&position, &outline) {
            (Some(position), Some(outline)) => contact::at(position, outline, &course, sheet),
            _ => None,
        };
        let steepest = outline.as_ref().and_then(|outline| contact::extremes(outline, &course, sheet));
        let load = match &given.load {
            Some(load) => {
                let at = (position.as_ref(), outline.as_ref(), pressure);
                Some(load::solve(load, given.speed, &course, at, sheet)?)
            }
            None => None,
        };
        let view = View {
            course: &course,
            speed: self.speed,
            angle: self.angle,
            outline: outline.as_ref().map(follower::Outline::numbers),
            load,
        };
        if let Some(outline) = view.outline {
            let asked = self.angle.and_then(|angle| course.at(angle));
            let shown: Option<Motion> =
                asked.or(steepest.map(|found| found.motion)).or_else(|| course.at(0.0));
            if let Some(shown) = shown {
                sheet.show(|| Exhibit::Drawing(view.drawing(&outline, &shown)));
            }
        }
        sheet.show(|| Exhibit::Drawing(view.diagram()));
        sheet.show(|| Exhibit::Table(motion::table(&course, self.speed)));
        // Built only where somebody looks.
        let count = 4 + usize::from(steepest.is_some()) + 2 * usize::from(view.load.is_some());
        for n in 0..count {
            sheet.show(|| Exhibit::Plot(view.plots().swap_remove(n)));
        }
        Ok(())
    }
}
