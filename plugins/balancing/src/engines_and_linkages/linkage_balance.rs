//! Force balance of a four-bar linkage or a slider-crank by two counterweights.

use std::f64::consts::TAU;

use dalembert_core::{
    About, Analysis, Axis, Cell, Column, Exhibit, Inputs, Plot, Refusal, Series, TableExhibit, Text,
    Worksheet, register,
};
use dalembert_mechanics::{
    Real,
    balance::{
        self,
        linkage::{Counterweight, Follower, LinkInertia, Linkage, Pose, Shaking},
    },
};
use dalembert_numerics::extremes::{self, Extreme};

use crate::sources::{BERKOF, NORTON};

mod counterweights;
mod links;
mod pictures;

use counterweights::{CRANK, ROCKER, ROD, counterweight};
use links::FrameLoads;

/// The linkage, its masses, and where counterweights may sit.
#[derive(Clone, Debug, Inputs)]
pub struct LinkageBalance {
    /// Mechanism.
    pub mechanism: LinkageInput,
    /// Speed of the crank.
    #[input("ω", "rpm", positive)]
    pub speed: f64,
    /// Radius of the counterweight of the crank.
    #[input("R_2", "mm", positive)]
    pub crank_radius: f64,
    /// Radius of the other counterweight.
    /// For the rocker, measured from its fixed pin; on a slider-crank for the rod, from the crank pin.
    #[input("R_c", "mm", positive)]
    pub other_radius: f64,
}

/// A linkage with a crank.
#[derive(Clone, Debug, Inputs)]
pub enum LinkageInput {
    /// Four-bar linkage
    FourBar {
        /// Crank.
        #[input("a", "mm", positive)]
        crank: f64,
        /// Coupler.
        #[input("b", "mm", positive)]
        coupler: f64,
        /// Rocker.
        #[input("c", "mm", positive)]
        rocker: f64,
        /// Frame.
        #[input("d", "mm", positive)]
        frame: f64,
        /// Loop closure.
        closing: Closing,
        /// Masses of the crank.
        #[input("2")]
        crank_body: LinkMassInput,
        /// Masses of the coupler.
        #[input("3")]
        coupler_body: LinkMassInput,
        /// Masses of the rocker.
        #[input("4")]
        rocker_body: LinkMassInput,
    },
    /// Slider-crank
    SliderCrank {
        /// Crank.
        #[input("a", "mm", positive)]
        crank: f64,
        /// Connecting rod.
        #[input("b", "mm", positive)]
        rod: f64,
        /// Height of the guide over the crank pivot.
        #[input("h", "mm", default = "0 mm")]
        offset: f64,
        /// Masses of the crank.
        #[input("2")]
        crank_body: LinkMassInput,
        /// Masses of the connecting rod.
        #[input("3")]
        rod_body: LinkMassInput,
        /// Mass of the slider.
        #[input("m_4", "kg", nonnegative)]
        slider: f64,
    },
}

/// The side on which the loop of a four-bar linkage closes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum Closing {
    /// Open loop
    Open,
    /// Crossed loop
    Crossed,
}

/// The mass of a link and where it is.
#[derive(Clone, Debug, Inputs)]
pub struct LinkMassInput {
    /// Mass.
    #[input("m", "kg", nonnegative)]
    pub mass: f64,
    /// Distance of the centre of mass from the first pin.
    /// The first pin of crank and rocker is the fixed one, that of the coupler is the crank pin.
    #[input("ρ", "mm", nonnegative)]
    pub distance: f64,
    /// Angle of the centre of mass from the line of the pins.
    #[input("δ", "deg", default = "0 deg")]
    pub offset: f64,
    /// Moment of inertia about the centre of mass.
    #[input("I", "kg*m^2", nonnegative, default = "0 kg*m^2")]
    pub inertia: f64,
}

register!(LinkageBalance);

/// Places over a turn at which the largest values are sought.
const PLACES: usize = 360;

impl Analysis for LinkageBalance {
    const ABOUT: About = About {
        id: "balancing/linkage-balance",
        title: "Force balance of a linkage",
        topic: "Engines and linkages",
        summary: "Counterweights that eliminate the shaking force of a four-bar linkage or a slider-crank, and their effect on shaking moment and torque.",
        main: &[
            "crank_mass",
            "crank_unbalance",
            "crank_angle",
            "rocker_mass",
            "rocker_unbalance",
            "rocker_angle",
        ],
        keywords: "balanceamento de mecanismos quatro barras biela-manivela contrapeso força de trepidação momento torque \
                   berkof lowen four-bar slider-crank shaking force shaking moment counterweight",
        sources: &[&BERKOF, &NORTON],
        cases: include_str!("../../cases/linkage_balance.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &LinkageBalanceGiven<W>, sheet: W) -> Result<(), Refusal> {
        let linkage = self.linkage();
        let poses = self.poses(&linkage)?;
        let before: Vec<Shaking> = poses.iter().map(|pose| linkage.shaking(pose, &[])).collect();
        let force_before = largest(&before, size);
        if force_before == 0.0 {
            return Err(Refusal::because(
                "no moving link has a mass, so there is no shaking force; give a mass to at least one",
            ));
        }
        sheet.keep_going()?;
        let counterweights = match &given.mechanism {
            LinkageInputGiven::FourBar {
                crank,
                coupler,
                rocker,
                crank_body,
                coupler_body,
                rocker_body,
                ..
            } => {
                let (two, three, four) = (crank_body, coupler_body, rocker_body);
                let carried = three.mass * *crank;
                let why = (
                    "Crank: its own moment and the part of the coupler that moves with the crank pin",
                    BERKOF.at(""),
                );
                let along = (three.distance / *coupler) * three.offset.cos();
                let own = two.mass * two.distance * two.offset.cos();
                let x = -(own + carried * (-along + 1.0));
                let halves = "half of the mass of the coupler taken at each of its pins";
                sheet.common_error("U_2x", halves, || -(own + carried / 2.0));
                let exchanged = "the shares of the coupler at its two pins interchanged";
                sheet.common_error("U_2x", exchanged, || -(own + carried * along));
                let x = sheet.step("U_2x", "kg*mm", x, why);
                let across = (three.distance / *coupler) * three.offset.sin();
                let y = -(two.mass * two.distance * two.offset.sin() - carried * across);
                let y = sheet.step("U_2y", "kg*mm", y, why);
                let on_crank = counterweight(sheet, 0, (x, y), given.crank_radius, &CRANK);
                let why = (
                    "Rocker: its own moment and the part of the coupler that moves with the rocker pin",
                    BERKOF.at(""),
                );
                let carried = three.mass * three.distance * (*rocker / *coupler);
                let own = four.mass * four.distance * four.offset.cos();
                let x = -(own + carried * three.offset.cos());
                sheet.common_error("U_4x", halves, || -(own + three.mass * *rocker / 2.0));
                sheet.common_error("U_4x", exchanged, || -(own + three.mass * *rocker * (-along + 1.0)));
                let x = sheet.step("U_4x", "kg*mm", x, why);
                let y = -(four.mass * four.distance * four.offset.sin() + carried * three.offset.sin());
                let y = sheet.step("U_4y", "kg*mm", y, why);
                [on_crank, counterweight(sheet, 2, (x, y), given.other_radius, &ROCKER)]
            }
            LinkageInputGiven::SliderCrank { crank, rod, crank_body, rod_body, slider, .. } => {
                let (two, three) = (crank_body, rod_body);
                let why =
                    "Rod: its counterweight brings the centre of mass of rod and slider to the crank pin";
                let x = -(three.mass * three.distance * three.offset.cos() + *slider * *rod);
                let x = sheet.step("U_3x", "kg*mm", x, (why, BERKOF.at("")));
                let y = -(three.mass * three.distance * three.offset.sin());
                let y = sheet.step("U_3y", "kg*mm", y, (why, BERKOF.at("")));
                let on_rod = counterweight(sheet, 1, (x, y), given.other_radius, &ROD);
                let added = balance::correction_mass(x, y, given.other_radius);
                let why =
                    ("Crank: its own moment and that of the masses carried at the crank pin", BERKOF.at(""));
                let hanging = three.mass + *slider + added;
                let own = two.mass * two.distance * two.offset.cos();
                let x = -(own + hanging * *crank);
                let turning = || three.mass * (*rod - three.distance) / *rod;
                let what = "only the part of the rod at the crank pin counted, as for rotating masses";
                sheet.common_error("U_2x", what, || -(own + turning() * *crank));
                let what = "the rotating part of the rod and half of the reciprocating masses counted";
                sheet.common_error("U_2x", what, || {
                    let sliding = three.mass * three.distance / *rod + *slider;
                    -(own + (turning() + sliding / 2.0) * *crank)
                });
                let x = sheet.step("U_2x", "kg*mm", x, why);
                let y = -(two.mass * two.distance * two.offset.sin());
                let y = sheet.step("U_2y", "kg*mm", y, why);
                [counterweight(sheet, 0, (x, y), given.crank_radius, &CRANK), on_rod]
            }
        };
        let after: Vec<Shaking> = poses.iter().map(|pose| linkage.shaking(pose, &counterweights)).collect();
        let effort: f64 = linkage_effort(&linkage, &counterweights, self.speed);
        sheet.verify(|| {
            let still = after[0].first_moment;
            let wander = after
                .iter()
                .map(|s| (s.first_moment[0] - still[0]).hypot(s.first_moment[1] - still[1]))
                .fold(0.0, f64::max);
            let speed = self.speed * self.speed;
            sheet.check_zero("the centre of mass remains at rest", wander.into(), effort / speed);
            self.check_torque(&linkage, &poses, &before, sheet);
            let gap = |s: &Shaking| {
                let [crank, _, _, follower] = s.joints;
                let along = |k: usize| crank[k] + follower[k] + s.force[k];
                along(0).hypot(along(1))
            };
            let gaps = largest(&before, gap).max(largest(&after, gap));
            let most = before.iter().chain(&after).flat_map(|s| s.joints).map(|[x, y]| x.hypot(y));
            let what = "the forces of the frame on crank and output link equal the reversed shaking force";
            sheet.check_zero(what, gaps.into(), most.fold(effort, f64::max));
        });
        let found = |symbol, unit, si, why: &'static str| {
            sheet.numerical(symbol, unit, si, (why, NORTON.at("ch. 12")))
        };
        let why_force = "Maximum shaking force over a revolution";
        let weights = [&[], counterweights.as_slice()];
        // The largest of a number before and after, and the same by the equations of all links at the crank angle of each.
        let most = |of: &dyn Fn(&Shaking) -> f64| {
            let largest = |(with, all)| self.largest(&linkage, with, all, of);
            [(weights[0], before.as_slice()), (weights[1], after.as_slice())].map(largest)
        };
        let again = |what: &'static str,
                     found: [W::Num; 2],
                     at: [Extreme; 2],
                     reach: f64,
                     of: &dyn Fn(&FrameLoads) -> f64| {
            sheet.verify(|| {
                for ((found, at), with) in found.into_iter().zip(at).zip(weights) {
                    let Some(pose) = linkage.pose(at.time, self.speed) else { continue };
                    let Some(loads) = links::frame_loads(&linkage, &pose, with, self.speed) else { continue };
                    let scale = (effort * reach).max(at.value);
                    let error = f64::EPSILON * loads.growth * scale;
                    sheet.check_residual(what, (found.value() - of(&loads)).into(), scale, error);
                }
            });
        };
        let at = most(&size);
        let first = found("F_before", "N", at[0].value, why_force);
        let last = left(&linkage, &poses, &counterweights, &after, effort, sheet);
        sheet.answer("shaking_force", "Maximum shaking force before", first);
        sheet.answer("shaking_force_after", "Maximum shaking force after", last);
        sheet.verify(|| sheet.check_zero("no shaking force is left", last.value().into(), effort));
        let what = "shaking force at that angle by the Newton–Euler equations of all links";
        again(what, [first, last], at, 1.0, &|loads| loads.force[0].hypot(loads.force[1]));
        let why_moment = "Maximum shaking moment about the crank pivot over a revolution";
        let reach = linkage.crank + linkage.coupler;
        let at = most(&|s| s.moment.abs());
        let [first, last] = [("M_before", at[0]), ("M_after", at[1])]
            .map(|(symbol, at)| found(symbol, "N*m", at.value, why_moment));
        let what = "shaking moment at that angle by the Newton–Euler equations of all links";
        again(what, [first, last], at, reach, &|loads| loads.moment.abs());
        sheet.answer("shaking_moment", "Maximum shaking moment before", first);
        sheet.answer("shaking_moment_after", "Maximum shaking moment after", last);
        let why_torque = "Maximum crank torque over a revolution";
        let at = most(&|s| s.torque.abs());
        let [first, last] = [("T_before", at[0]), ("T_after", at[1])]
            .map(|(symbol, at)| found(symbol, "N*m", at.value, why_torque));
        let what = "torque at that angle by the Newton–Euler equations of all links";
        again(what, [first, last], at, reach, &|loads| loads.torque.abs());
        sheet.answer("torque", "Maximum crank torque before", first);
        sheet.answer("torque_after", "Maximum crank torque after", last);
        if last.value() > 1.05 * first.value() {
            sheet.warn(|| {
                Text::new("the maximum torque with the counterweights is {times} times its initial value")
                    .with("times", format!("{:.1}", last.value() / first.value()))
            });
        }
        let names = match self.mechanism {
            LinkageInput::FourBar { .. } => FOUR_BAR_JOINTS,
            LinkageInput::SliderCrank { .. } => SLIDER_CRANK_JOINTS,
        };
        for (joint, [label, before, after]) in names.into_iter().enumerate() {
            let of = move |s: &Shaking| s.joints[joint][0].hypot(s.joints[joint][1]);
            let why = |when: &'static str| {
                let why = Text::new(
                    "Maximum force over a revolution, {when}: {joint}, from the equilibrium of each link",
                );
                (why.with_text("when", when).with_text("joint", label), NORTON.at("ch. 11"))
            };
            let at = most(&of);
            let first = sheet.numerical(("P_before", joint + 1), "N", at[0].value, why("before"));
            let last = sheet.numerical(("P_after", joint + 1), "N", at[1].value, why("after"));
            sheet.answer(("joint_force", joint + 1), before, first);
            sheet.answer(("joint_force_after", joint + 1), after, last);
            let what = "force in a joint at that angle by the Newton–Euler equations of all links";
            again(what, [first, last], at, 1.0, &|on| on.joints[joint][0].hypot(on.joints[joint][1]));
        }
        sheet.show(|| Exhibit::Table(joint_forces(names, &before, &after)));
        for (title, label, unit, arm, of) in [
            ("Shaking force", "Force", "N", 1.0, size as fn(&Shaking) -> f64),
            ("Shaking moment about the crank pivot", "Moment", "N*m", reach, |s| s.moment),
            ("Torque on the crank", "Torque", "N*m", reach, |s| s.torque),
        ] {
            sheet.show(|| {
                // What is left of forces and moments that balance is rounding, and is drawn as none.
                let least = ROUNDING * effort * arm;
                let seen = |value: f64| if value.abs() <= least { 0.0 } else { value };
                let curve = |all: &[Shaking]| {
                    let points = all.iter().chain([&all[0]]).enumerate();
                    points.map(|(n, s)| (TAU * n as f64 / PLACES as f64, seen(of(s)))).collect::<Vec<_>>()
                };
                Exhibit::Plot(Plot::new(
                    title,
                    Axis::linear("Crank angle", "deg"),
                    Axis::linear(label, unit),
                    vec![Series::line("before", curve(&before)), Series::line("after", curve(&after))],
                ))
            });
        }
        sheet.show(|| Exhibit::Animation(pictures::animation(&linkage, &poses, &counterweights)));
        Ok(())
    }
}

/// The joints, in the order of [`Shaking::joints`]: their force, before the counterweights and after them.
const FOUR_BAR_JOINTS: [[&str; 3]; 4] = [
    PIVOT_OF_CRANK,
    CRANK_PIN,
    ["Force in the coupler pin", "Force in the coupler pin before", "Force in the coupler pin after"],
    [
        "Force in the pivot of the rocker",
        "Force in the pivot of the rocker before",
        "Force in the pivot of the rocker after",
    ],
];

const SLIDER_CRANK_JOINTS: [[&str; 3]; 4] = [
    PIVOT_OF_CRANK,
    CRANK_PIN,
    [
        "Force in the pin of the slider",
        "Force in the pin of the slider before",
        "Force in the pin of the slider after",
    ],
    ["Force of the guide", "Force of the guide before", "Force of the guide after"],
];

const PIVOT_OF_CRANK: [&str; 3] = [
    "Force in the pivot of the crank",
    "Force in the pivot of the crank before",
    "Force in the pivot of the crank after",
];

const CRANK_PIN: [&str; 3] =
    ["Force in the crank pin", "Force in the crank pin before", "Force in the crank pin after"];

/// Share of the forces that cancel below which what is left of them is rounding.
const ROUNDING: f64 = 1e-12;

/// The largest force in each joint over a turn.
fn joint_forces(names: [[&'static str; 3]; 4], before: &[Shaking], after: &[Shaking]) -> TableExhibit {
    let most = |all: &[Shaking], joint: usize| {
        Cell::Number(largest(all, |s| s.joints[joint][0].hypot(s.joints[joint][1])))
    };
    TableExhibit {
        title: "Maximum joint forces".into(),
        columns: vec![
            Column { heading: "Joint".into(), unit: "" },
            Column { heading: "before".into(), unit: "N" },
            Column { heading: "after".into(), unit: "N" },
        ],
        rows: (0..4)
            .map(|joint| vec![Cell::Text(names[joint][0].into()), most(before, joint), most(after, joint)])
            .collect(),
        foot: Vec::new(),
    }
}

impl LinkMassInput {
    fn link(&self) -> LinkInertia {
        LinkInertia { mass: self.mass, distance: self.distance, offset: self.offset, inertia: self.inertia }
    }
}

impl LinkageBalance {
    fn linkage(&self) -> Linkage {
        match &self.mechanism {
            LinkageInput::FourBar {
                crank,
                coupler,
                rocker,
                frame,
                closing,
                crank_body,
                coupler_body,
                rocker_body,
            } => Linkage {
                crank: *crank,
                coupler: *coupler,
                crank_link: crank_body.link(),
                coupler_link: coupler_body.link(),
                follower: Follower::Rocker {
                    frame: *frame,
                    length: *rocker,
                    crossed: *closing == Closing::Crossed,
                    link: rocker_body.link(),
                },
            },
            LinkageInput::SliderCrank { crank, rod, offset, crank_body, rod_body, slider } => Linkage {
                crank: *crank,
                coupler: *rod,
                crank_link: crank_body.link(),
                coupler_link: rod_body.link(),
                follower: Follower::Slider { offset: *offset, mass: *slider },
            },
        }
    }

    /// The places over a turn.
    fn poses(&self, linkage: &Linkage) -> Result<Vec<Pose>, Refusal> {
        let place = |n: usize| {
            let angle = TAU * n as f64 / PLACES as f64;
            linkage.pose(angle, self.speed).ok_or_else(|| {
                Refusal::because(
                    Text::new("the loop does not close at the crank angle {angle}, so the crank cannot rotate fully; make it shorter, or the coupler longer")
                        .with_quantity("angle", angle, "deg"),
                )
            })
        };
        (0..PLACES).map(place).collect()
    }

    /// The torque before, where the loop is best determined, against the change of the kinetic energy about there.
    fn check_torque<W: Worksheet>(&self, linkage: &Linkage, poses: &[Pose], before: &[Shaking], sheet: W) {
        let best = (0..poses.len()).max_by(|a, b| poses[*a].transmission.total_cmp(&poses[*b].transmission));
        let Some(best) = best else { return };
        let step = 0.005;
        let energy = |n: f64| {
            let pose = linkage.pose(poses[best].angles[0] + n * step, self.speed)?;
            Some(linkage.shaking(&pose, &[]).energy)
        };
        // Central differences of the eighth order.
        let weights = [4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0];
        let mut slope = 0.0;
        for (n, weight) in (1..).map(f64::from).zip(weights) {
            let (Some(ahead), Some(behind)) = (energy(n), energy(-n)) else { return };
            slope += weight * (ahead - behind) / step;
        }
        let scale = before.iter().map(|s| s.energy.max(s.torque.abs())).fold(0.0, f64::max);
        let difference = before[best].torque - slope;
        sheet.check_zero(
            "the torque is the change of the kinetic energy with the angle",
            difference.into(),
            scale,
        );
    }
}

fn size(shaking: &Shaking) -> f64 {
    shaking.force[0].hypot(shaking.force[1])
}

fn largest(all: &[Shaking], of: impl Fn(&Shaking) -> f64) -> f64 {
    all.iter().map(of).fold(0.0, f64::max)
}

impl LinkageBalance {
    /// Maximum of a load over a revolution, refined from samples.
    fn largest(
        &self,
        linkage: &Linkage,
        counterweights: &[Counterweight],
        all: &[Shaking],
        of: impl Fn(&Shaking) -> f64,
    ) -> Extreme {
        // One place beyond the turn, so that each has two neighbours.
        let places: Vec<f64> = (0..=all.len() + 1).map(|n| TAU * n as f64 / all.len() as f64).collect();
        let values: Vec<f64> = (0..places.len()).map(|n| of(&all[n % all.len()])).collect();
        let at = |angle: f64| {
            let pose = linkage.pose(angle, self.speed);
            pose.map_or(0.0, |pose| of(&linkage.shaking(&pose, counterweights)))
        };
        extremes::largest_about(at, &places, &values).unwrap_or(Extreme { time: 0.0, value: 0.0 })
    }
}

/// Residual shaking force at its maximum: the force of the linkage itself and that of its counterweights.
fn left<W: Worksheet>(
    linkage: &Linkage,
    poses: &[Pose],
    counterweights: &[Counterweight],
    after: &[Shaking],
    effort: f64,
    sheet: W,
) -> W::Num {
    let worst = (0..after.len()).max_by(|a, b| size(&after[*a]).total_cmp(&size(&after[*b]))).unwrap_or(0);
    let own = linkage.shaking(&poses[worst], &[]).force;
    let weightless = |link: LinkInertia| LinkInertia { mass: 0.0, inertia: 0.0, ..link };
    let follower = match linkage.follower {
        Follower::Rocker { frame, length, crossed, link } => {
            Follower::Rocker { frame, length, crossed, link: weightless(link) }
        }
        Follower::Slider { offset, .. } => Follower::Slider { offset, mass: 0.0 },
    };
    let (crank_link, coupler_link) = (weightless(linkage.crank_link), weightless(linkage.coupler_link));
    let bare = Linkage { crank_link, coupler_link, follower, ..*linkage };
    let added = bare.shaking(&poses[worst], counterweights).force;
    let names = [["F_x", "W_x"], ["F_y", "W_y"]];
    let [x, y] = [0, 1].map(|axis| {
        // What is rounding beside the forces that cancel is none.
        let (one, other) = (own[axis], added[axis]);
        let other = if (one + other).abs() < 1e-9 * effort { -one } else { other };
        let why = "Force of the moving links on the frame, at the crank angle of maximum residual force";
        let one = sheet.numerical(names[axis][0], "N", one, why);
        one + sheet.numerical(names[axis][1], "N", other, "Force of the counterweights at that crank angle")
    });
    let why = ("Maximum shaking force over a revolution", NORTON.at("ch. 12"));
    sheet.step("F_after", "N", balance::magnitude(x, y), why)
}

/// The size of the forces that cancel: all masses with their reach at the speed of the crank.
fn linkage_effort(linkage: &Linkage, counterweights: &[Counterweight], speed: f64) -> f64 {
    let (a, b) = (linkage.crank, linkage.coupler);
    let third = match linkage.follower {
        Follower::Rocker { length, link, .. } => link.mass * link.distance + counterweights[1].mass * length,
        Follower::Slider { mass, .. } => mass * (a + b),
    };
    let own = linkage.crank_link.mass * linkage.crank_link.distance
        + linkage.coupler_link.mass * (a + linkage.coupler_link.distance)
        + third;
    let added: f64 = counterweights.iter().map(|c| c.mass * (a + c.distance)).sum();
    (own + added) * speed * speed
}
