//! Screw jacks: a load on a screw, on a rhombus or on scissors that a screw draws together.

mod mechanism;

use dalembert_core::{
    About, Analysis, Axis, Exhibit, Ink, Inputs, Plot, Refusal, Series, Sketch, Text, Worksheet, register,
};
use dalembert_mechanics::Real;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

use crate::{
    shared::equilibria::{animation, solved, spread},
    sources::{BEER, HIBBELER, RIUL},
};

/// A jack and its screw.
#[derive(Clone, Debug, Inputs)]
pub struct ScrewJack {
    /// Frame.
    pub frame: JackFrame,
    /// Screw.
    /// If left blank, only the axial force is computed.
    pub screw: Option<Screw>,
    /// Find.
    pub sought: ScrewJackUnknown,
}

/// Member between load and screw.
#[derive(Clone, Debug, PartialEq, Inputs)]
pub enum JackFrame {
    /// The load rests on the screw
    Plain,
    /// Rhombus with the screw across
    Rhombus {
        /// Length of each link.
        #[input("L", "m", positive)]
        link: f64,
        /// Angle of the links from the horizontal.
        #[input("θ", "deg", positive, below = 90)]
        angle: f64,
    },
    /// Scissors with the screw between the feet
    Scissors {
        /// Stages.
        #[input(min = 1, max = 8)]
        stages: u32,
        /// Length of each bar.
        #[input("L", "m", positive)]
        link: f64,
        /// Angle of the bars from the horizontal.
        #[input("θ", "deg", positive, below = 90)]
        angle: f64,
    },
}

/// The screw and its friction.
#[derive(Clone, Debug, Inputs)]
pub struct Screw {
    /// Mean diameter of the thread.
    #[input("d", "m", positive)]
    pub diameter: f64,
    /// Lead.
    /// Travel of a nut per turn.
    #[input("ℓ", "m", positive)]
    pub lead: f64,
    /// Coefficient of friction in the thread.
    #[input("μ", "1", nonnegative)]
    pub friction: f64,
    /// Half the thread angle.
    /// Zero for a square thread, 15° for a trapezoidal one.
    #[input("λ", "deg", nonnegative, below = 60, default = "0 deg")]
    pub flank: f64,
    /// Threads.
    pub threads: Threads,
    /// Mean diameter of the collar.
    #[input("d_c", "m", nonnegative, default = "0 m")]
    pub collar_diameter: f64,
    /// Coefficient of friction in the collar.
    #[input("μ_c", "1", nonnegative, default = "0")]
    pub collar_friction: f64,
}

/// Number of nuts on the screw.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum Threads {
    /// One nut
    One,
    /// Two nuts, on a right-hand and a left-hand thread
    Two,
}

/// Unknown of the problem.
#[derive(Clone, Debug, Inputs)]
pub enum ScrewJackUnknown {
    /// Force and torque for a given load
    Effort {
        /// Load.
        #[input("P", "N", positive)]
        load: f64,
    },
    /// Load raised by a torque
    Load {
        /// Torque on the screw.
        #[input("M", "N*m", positive)]
        torque: f64,
    },
    /// Load balanced by an axial force
    Held {
        /// Axial force in the screw.
        #[input("T", "N", positive)]
        force: f64,
    },
}

register!(ScrewJack);

/// Torque per unit of axial force, in metres, and the angles of the thread.
struct Torques<N> {
    raise: N,
    lower: N,
    ideal: N,
    slope: N,
    friction: N,
}

impl Analysis for ScrewJack {
    const ABOUT: About = About {
        id: "virtual-work/screw-jack",
        title: "Screw jack",
        topic: "Presses and lifts",
        summary: "Axial force and torque of a screw jack, a rhombus jack or a scissor jack, with friction, efficiency and self-locking.",
        main: &["raising_torque", "load", "axial_force", "efficiency"],
        keywords: "car jack scissor rhombus power screw lead thread friction self-locking efficiency macaco sanfona parafuso de \
                   potência passo rosca atrito autotravante rendimento",
        sources: &[&BEER, &HIBBELER, &RIUL],
        cases: include_str!("../../cases/screw_jack.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &ScrewJackGiven<W>, sheet: W) -> Result<(), Refusal> {
        let ratio = force_ratio(&given.frame, self.stages(), sheet);
        let torques = match &given.screw {
            Some(screw) => Some(self.torques(screw, sheet)?),
            None => None,
        };
        let over = |load: W::Num| ratio.map_or(load, |ratio| load * ratio);
        let (load, force) = match &given.sought {
            ScrewJackUnknownGiven::Effort { load } => {
                if let JackFrameGiven::Rhombus { angle, .. } | JackFrameGiven::Scissors { angle, .. } =
                    &given.frame
                {
                    let words = "the force in a link, P/(2 sin θ), taken for that in the screw";
                    sheet.common_error("T", words, || *load / (angle.sin() * 2.0));
                }
                let force = match ratio {
                    None => *load,
                    Some(_) => sheet.step(
                        "T",
                        "N",
                        over(*load),
                        ("Axial force in the screw, from P δy + T δx = 0", RIUL.at("eq. 3")),
                    ),
                };
                sheet.answer("axial_force", "Axial force in the screw", force);
                (*load, force)
            }
            ScrewJackUnknownGiven::Load { torque } => {
                let Some(torques) = &torques else {
                    return Err(Refusal::because("a torque needs a screw: write its diameter and lead"));
                };
                let force =
                    sheet.step("T", "N", *torque / torques.raise, "Axial force overcome by the torque");
                (self.carried(ratio, force, sheet), force)
            }
            ScrewJackUnknownGiven::Held { force } => (self.carried(ratio, *force, sheet), *force),
        };
        if let Some(torques) = &torques {
            self.answer_torques(given, torques, force, sheet);
        }
        let (plain_load, plain_force) = (load.value(), force.value());
        sheet.verify(|| {
            if let Some((mechanism, drawn)) = self.built(plain_load)
                && let Some(effort) = solved(&mechanism, &drawn)
            {
                sheet.check(
                    "the axial force from the Newton–Euler equations of every link",
                    W::Num::from(-effort.newton_euler[0]),
                    force,
                );
            }
        });
        if self.angle().is_some_and(|angle| angle < 5f64.to_radians()) {
            sheet.warn(|| {
                "the links are nearly horizontal: the axial force grows without bound near that position"
                    .into()
            });
        }
        if let Some(angle) = self.angle() {
            let input = match self.frame {
                JackFrame::Scissors { .. } => "frame.scissors.angle",
                _ => "frame.rhombus.angle",
            };
            let stages = self.stages();
            sheet.show(|| {
                let plot = force_over_angle(stages, plain_load, angle, plain_force);
                // Under another load than asked for, where a torque or a force tells the load.
                let is_asked = matches!(self.sought, ScrewJackUnknown::Effort { .. });
                Exhibit::Plot(if is_asked { plot.over(input) } else { plot })
            });
            let range = [(0.4 * angle).max(0.1), (1.3 * angle).min(1.4)];
            sheet.show(|| animation("The jack", (input, angle), range, |angle| self.frame_at(angle)));
        }
        Ok(())
    }
}

/// Axial force over load; none where the load stands on the screw.
fn force_ratio<W: Worksheet>(frame: &JackFrameGiven<W>, stages: f64, sheet: W) -> Option<W::Num> {
    let (JackFrameGiven::Rhombus { link, angle } | JackFrameGiven::Scissors { link, angle, .. }) = frame
    else {
        return None;
    };
    let rhombus = matches!(frame, JackFrameGiven::Rhombus { .. });
    let times = |value: W::Num, count: f64| if count == 1.0 { value } else { value * count };
    let rise = sheet.step(
        "y′",
        "m",
        times(*link * angle.cos(), if rhombus { 2.0 } else { stages }),
        if rhombus {
            "Upward virtual displacement of the load per unit δθ, from y = 2 L sin θ"
        } else {
            "Upward virtual displacement of the load per unit δθ, from y = n L sin θ"
        },
    );
    let near = sheet.step(
        "x′",
        "m",
        times(*link * angle.sin(), if rhombus { 2.0 } else { 1.0 }),
        if rhombus {
            "Virtual approach of the nuts per unit δθ, from x = 2 L cos θ"
        } else {
            "Virtual approach of the feet per unit δθ, from x = L cos θ"
        },
    );
    let height = sheet.step(
        "y",
        "m",
        times(*link * angle.sin(), if rhombus { 2.0 } else { stages }),
        "Height of the load",
    );
    sheet.answer("height", "Height of the load", height);
    sheet.verify(|| {
        let stages = if rhombus { 2.0 } else { stages };
        let what = "height of the load by Pythagoras, from the links and the width of the frame";
        let wide = *link * angle.cos() * stages;
        sheet.check(what, height.powi(2) + wide.powi(2), (*link * stages).powi(2));
    });
    let ratio = sheet.step(
        "i",
        "1",
        rise / near,
        "Ratio of axial force to load: displacement of the load over that of the screw",
    );
    sheet.answer("force_ratio", "Ratio of axial force to load", ratio);
    Some(ratio)
}

impl ScrewJack {
    fn stages(&self) -> f64 {
        match self.frame {
            JackFrame::Scissors { stages, .. } => f64::from(stages),
            JackFrame::Plain | JackFrame::Rhombus { .. } => 1.0,
        }
    }

    fn angle(&self) -> Option<f64> {
        match self.frame {
            JackFrame::Plain => None,
            JackFrame::Rhombus { angle, .. } | JackFrame::Scissors { angle, .. } => Some(angle),
        }
    }

    /// The load that goes with an axial force.
    fn carried<W: Worksheet>(&self, ratio: Option<W::Num>, force: W::Num, sheet: W) -> W::Num {
        let load = sheet.step(
            "P",
            "N",
            ratio.map_or(force, |ratio| force / ratio),
            ("Load, from P δy + T δx = 0", RIUL.at("eq. 3")),
        );
        sheet.answer("load", "Load", load);
        load
    }

    fn torques<W: Worksheet>(&self, screw: &ScrewGiven<W>, sheet: W) -> Result<Torques<W::Num>, Refusal> {
        let slope = sheet.step(
            "α",
            "deg",
            screw.lead.atan2(screw.diameter * PI),
            ("Lead angle of the thread", BEER.at("§8.2B")),
        );
        let friction = sheet.step(
            "φ",
            "deg",
            screw.friction.atan2(screw.flank.cos()),
            ("Angle of friction on the flanks of the thread", BEER.at("§8.2B")),
        );
        if slope.value() + friction.value() >= FRAC_PI_2 * (1.0 - 1e-9) {
            return Err(Refusal::because(
                "lead angle and friction angle of the thread together reach 90°: the thread jams and no torque raises the load",
            ));
        }
        let nuts = |arm: W::Num| match self.screw.as_ref().map(|screw| screw.threads) {
            Some(Threads::Two) => arm * 2.0,
            _ => arm,
        };
        let collar = (screw.collar_diameter.value() * screw.collar_friction.value() != 0.0)
            .then(|| screw.collar_friction * screw.collar_diameter / 2.0);
        let with_collar = |arm: W::Num| collar.map_or(arm, |collar| arm + collar);
        let added = || with_collar(nuts(screw.diameter / 2.0 * (slope.tan() + friction.tan())));
        sheet.common_error("q", "tan α and tan φ added", added);
        let raise = sheet.step(
            "q",
            "mm",
            with_collar(nuts(screw.diameter / 2.0 * (slope + friction).tan())),
            ("Torque per unit axial force, raising", BEER.at("§8.2B")),
        );
        let subtracted = || with_collar(nuts(screw.diameter / 2.0 * (friction.tan() - slope.tan())));
        sheet.common_error("q₂", "tan α subtracted from tan φ", subtracted);
        if let Some(collar) = collar {
            let driven = || nuts(screw.diameter / 2.0 * (friction - slope).tan()) - collar;
            sheet.common_error("q₂", "the collar taken to help the load drive the screw", driven);
        }
        let lower = sheet.step(
            "q₂",
            "mm",
            with_collar(nuts(screw.diameter / 2.0 * (friction - slope).tan())),
            (
                "Torque per unit axial force, lowering; negative where the load drives the screw",
                BEER.at("§8.2B"),
            ),
        );
        let ideal = sheet.step(
            "q₀",
            "mm",
            nuts(screw.lead / TAU),
            ("Torque per unit axial force without friction: M δψ = T ℓ δψ/2π for each nut", RIUL.at("eq. 3")),
        );
        Ok(Torques { raise, lower, ideal, slope, friction })
    }

    fn answer_torques<W: Worksheet>(
        &self,
        given: &ScrewJackGiven<W>,
        torques: &Torques<W::Num>,
        force: W::Num,
        sheet: W,
    ) {
        let raise = match &given.sought {
            ScrewJackUnknownGiven::Load { torque } => *torque,
            _ => {
                let raise = sheet.step("M", "N*m", force * torques.raise, "Torque to raise the load");
                sheet.answer("raising_torque", "Torque to raise the load", raise);
                raise
            }
        };
        let lower = sheet.step("M₂", "N*m", force * torques.lower, "Torque to lower the load");
        let efficiency = sheet.step(
            "η",
            "%",
            torques.ideal / torques.raise,
            "Efficiency: torque without friction divided by the torque with friction",
        );
        sheet.answer("lowering_torque", "Torque to lower the load", lower);
        sheet.answer("efficiency", "Efficiency", efficiency);
        sheet.answer("lead_angle", "Lead angle of the thread", torques.slope);
        sheet.answer("friction_angle", "Angle of friction", torques.friction);
        if lower.value() < 0.0 {
            sheet.warn(|| {
                Text::new("the screw is not self-locking: when released, it turns back under the load")
            });
        }
        let Some(screw) = &given.screw else { return };
        sheet.verify(|| {
            let friction = screw.friction / screw.flank.cos();
            let thread = screw.diameter / 2.0 * (screw.lead + friction * screw.diameter * PI)
                / (screw.diameter * PI - friction * screw.lead);
            let nuts = if self.screw.as_ref().is_some_and(|screw| screw.threads == Threads::Two) {
                2.0
            } else {
                1.0
            };
            let all = thread * nuts + screw.collar_friction * screw.collar_diameter / 2.0;
            sheet.check("the raising torque from T d/2 (ℓ + π μ′ d)/(π d − μ′ ℓ)", all * force, raise);
            let round = screw.diameter * PI;
            let thread =
                screw.diameter / 2.0 * (friction * round - screw.lead) / (round + friction * screw.lead);
            let all = thread * nuts + screw.collar_friction * screw.collar_diameter / 2.0;
            let what = "the lowering torque from T d/2 (π μ′ d − ℓ)/(π d + μ′ ℓ)";
            let scale = force.value() * (screw.diameter.value() * nuts + screw.collar_diameter.value());
            sheet.check_sum(what, all * force, lower, scale);
            let what = "efficiency as the work done on the load per revolution over that of the torque";
            sheet.check(what, efficiency * raise * TAU, force * screw.lead * nuts);
        });
    }

    fn frame_at(&self, angle: f64) -> Sketch {
        let (sin, cos) = angle.sin_cos();
        let mut sketch = Sketch::default();
        match self.frame {
            JackFrame::Plain => {}
            JackFrame::Rhombus { link: l, .. } => {
                let (wide, high) = (l * cos, l * sin);
                let corners = [(0.0, 0.0), (wide, high), (0.0, 2.0 * high), (-wide, high)];
                let top = 2.0 * high;
                thread(sketch.size(2.4 * l), (-1.2 * wide, 1.3 * wide), high, 0.05 * l);
                sketch
                    .ground((-0.5 * l, -0.1 * l), (0.5 * l, -0.1 * l))
                    .mass("", (-0.3 * l, -0.1 * l), (0.3 * l, 0.0))
                    .mass("", (-0.3 * l, top), (0.3 * l, top + 0.1 * l))
                    .bars([corners.as_slice(), &corners[..1]].concat())
                    .dimension("L", corners[3], corners[2], 2.0)
                    .axis(corners[3], corners[1])
                    .angle("θ", corners[3], 0.0, angle);
                for corner in corners {
                    sketch.joint("", corner);
                }
                sketch
                    .force("T", (wide, high), (wide - 0.4 * l, high))
                    .force("", (0.0, top + 0.5 * l), (0.0, top + 0.1 * l))
                    .label("P", (0.0, top + 0.5 * l));
            }
            JackFrame::Scissors { stages, link: l, .. } => {
                let (wide, high) = (l * cos, l * sin);
                let top = f64::from(stages) * high;
                thread(sketch.size(1.6 * l), (-0.15 * l, 1.3 * wide), 0.0, 0.05 * l);
                sketch
                    .ground((-0.15 * l, -0.15 * l), (1.2 * l, -0.15 * l))
                    .dimension("L", (0.0, 0.0), (wide, high), -2.0)
                    .angle("θ", (0.0, 0.0), 0.0, angle);
                for stage in 0..stages {
                    let y = f64::from(stage) * high;
                    sketch
                        .bars([(0.0, y), (wide, y + high)])
                        .bars([(wide, y), (0.0, y + high)])
                        .joint("", (wide / 2.0, y + high / 2.0))
                        .joint("", (wide, y))
                        .joint("", (0.0, y));
                }
                sketch
                    .bars([(-0.1 * l, top), (1.1 * l, top)])
                    .force("T", (wide, 0.0), (wide - 0.35 * l, 0.0))
                    .force("", (wide / 2.0, top + 0.45 * l), (wide / 2.0, top + 0.05 * l))
                    .label("P", (wide / 2.0, top + 0.45 * l));
            }
        }
        sketch
    }
}

/// A screw along a level line, with its thread across it.
fn thread(sketch: &mut Sketch, (from, to): (f64, f64), y: f64, half: f64) {
    sketch.bars([(from, y), (to, y)]);
    let pitch = 2.0 * half;
    let turns = ((to - from) / pitch) as u32;
    for turn in 1..turns {
        let x = from + f64::from(turn) * pitch;
        sketch.curve([(x - half / 2.0, y - half), (x + half / 2.0, y + half)], Ink::Faint);
    }
}

fn force_over_angle(stages: f64, load: f64, angle: f64, force: f64) -> Plot {
    let at = |angle: f64| (angle, stages * load / angle.tan());
    Plot::new(
        "Axial force against the angle of the links",
        Axis::linear("angle of the links", "deg"),
        Axis::linear("axial force", "kN"),
        vec![
            Series::line("T", spread([(0.3 * angle).max(0.05), 1.5], 300).map(at).collect())
                .of("axial_force"),
        ],
    )
    .mark("at this angle", (angle, force))
}
