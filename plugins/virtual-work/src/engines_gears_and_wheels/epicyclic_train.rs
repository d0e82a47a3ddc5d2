//! Epicyclic gear trains: speeds by Willis's formula, torques by virtual power.

use std::f64::consts::FRAC_1_SQRT_2;

use dalembert_core::{
    About, Analysis, Exhibit, Ink, Inputs, Refusal, Sketch, Text, Worksheet, exhibit::Point as At, register,
};
use dalembert_mechanics::{
    Real,
    planar::{BodyPoint, PlanarError, PlanarJoint, RelativeCoordinate},
};

use crate::{
    shared::{
        built::{self, Built, BuiltMass, Link, Solved},
        works::symbol,
    },
    sources::{BEVAN, NORTON, SHIGLEY},
};

/// An epicyclic train with sun, ring and arm: one of them is fixed, one drives, the third is driven.
#[derive(Clone, Debug, Inputs)]
pub struct EpicyclicTrain {
    /// Gears.
    pub gears: Gears,
    /// Fixed member.
    pub fixed: Member,
    /// Driving member.
    pub driver: Member,
    /// Pinion that drives the driving member.
    /// It meshes with external teeth of the driving member and turns about a fixed axis.
    pub pinion: Option<Pinion>,
    /// Speed of the driving shaft.
    /// Speed of the pinion, if present.
    #[input("ω_in", "rpm", default = "1000 rpm")]
    pub speed: f64,
    /// Known torque.
    pub torque: KnownTorque,
}

/// The gears of the train.
#[derive(Clone, Debug, Inputs)]
pub enum Gears {
    /// Sun, planets, ring with internal teeth
    Simple {
        /// Teeth of the sun.
        #[input(min = 4, max = 10000)]
        sun: u32,
        /// Teeth of the ring.
        #[input(min = 6, max = 10000)]
        ring: u32,
    },
    /// Sun, compound planets, ring with internal teeth
    Compound {
        /// Teeth of the sun.
        #[input(min = 4, max = 10000)]
        sun: u32,
        /// Teeth of the planet on the sun.
        #[input(min = 4, max = 10000)]
        first: u32,
        /// Teeth of the planet on the ring.
        #[input(min = 4, max = 10000)]
        second: u32,
        /// Teeth of the ring.
        #[input(min = 6, max = 10000)]
        ring: u32,
    },
    /// Two suns, compound planets
    /// The second sun, with external teeth, takes the place of the ring.
    Suns {
        /// Teeth of the first sun.
        #[input(min = 4, max = 10000)]
        sun: u32,
        /// Teeth of the planet on the first sun.
        #[input(min = 4, max = 10000)]
        first: u32,
        /// Teeth of the planet on the second sun.
        #[input(min = 4, max = 10000)]
        second: u32,
        /// Teeth of the second sun.
        #[input(min = 4, max = 10000)]
        other: u32,
    },
}

/// A member of the train.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum Member {
    /// Sun
    Sun,
    /// Ring, or second sun
    Ring,
    /// Arm
    Arm,
}

/// A pinion outside of the train.
#[derive(Clone, Debug, Inputs)]
pub struct Pinion {
    /// Teeth of the pinion.
    #[input(min = 4, max = 10000)]
    pub pinion: u32,
    /// External teeth of the driving member.
    #[input(min = 4, max = 10000)]
    pub wheel: u32,
}

/// The torque that is known.
#[derive(Clone, Debug, Inputs)]
pub enum KnownTorque {
    /// Torque on the driving shaft
    Driving {
        /// Torque on the driving shaft.
        #[input("T_in", "N*m")]
        torque: f64,
    },
    /// Load on the driven member
    Load {
        /// Torque of the load on the driven member.
        #[input("T_out", "N*m")]
        torque: f64,
    },
}

register!(EpicyclicTrain);

impl Analysis for EpicyclicTrain {
    const ABOUT: About = About {
        id: "virtual-work/epicyclic-train",
        title: "Epicyclic gear train",
        topic: "Engines, gears and wheels",
        summary: "Speeds of all members of an epicyclic train by Willis's formula, and driving, load and holding torques by virtual power.",
        main: &["ratio", "driven_speed", "holding_torque"],
        keywords: "trem epicicloidal planetário engrenagem sol coroa braço satélite Willis redutor torque de reação \
                   planetary gear epicyclic sun ring annulus arm carrier ratio",
        sources: &[&BEVAN, &SHIGLEY, &NORTON],
        cases: include_str!("../../cases/epicyclic_train.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &EpicyclicTrainGiven<W>, sheet: W) -> Result<(), Refusal> {
        if self.fixed == self.driver {
            return Err(Refusal::because(
                "the fixed member cannot drive: choose two different members of sun, ring and arm",
            ));
        }
        let driven = [Member::Sun, Member::Ring, Member::Arm]
            .into_iter()
            .find(|member| *member != self.fixed && *member != self.driver);
        let Some(driven) = driven else { return Err(Refusal::because("no member is left to be driven")) };
        let teeth = self.teeth();
        self.fits(teeth)?;
        let [sun, first, second, ring] = teeth;
        let found = |name: &'static str, value: f64| {
            sheet.numerical(
                symbol("z", name),
                "1",
                value,
                "Teeth, as given or as required by the centre distance",
            )
        };
        let (zs, zr) = (found("S", sun), found("R", ring));
        if first.fract() != 0.0 {
            sheet.warn(|| {
                Text::new("ring and sun differ by an odd number: planets of {planet} teeth cannot be cut; compound planets or shifted profiles are needed")
                    .with("planet", first)
            });
        }
        let value = if let Gears::Simple { .. } = self.gears {
            -(zs / zr)
        } else {
            let (z1, z2) = (found("P1", first), found("P2", second));
            let product = zs * z2 / (z1 * zr);
            if let Gears::Suns { .. } = self.gears { product } else { -product }
        };
        let why =
            "Ratio with the arm fixed: ring (or second sun) over sun; each external mesh reverses the sense";
        if let Gears::Simple { .. } = self.gears {
            sheet.common_error(
                "e",
                "the ratio of sun and planet used in place of that of sun and ring",
                || -(zs / first),
            );
        } else {
            let idler = || if let Gears::Suns { .. } = self.gears { zs / zr } else { -(zs / zr) };
            sheet.common_error("e", "the compound planet taken as an idler", idler);
        }
        let held = sheet.step("e", "1", value, (why, NORTON.at("ch. 9")));
        if driven_is_stuck(self.fixed, held.value()) {
            return Err(Refusal::because(
                "both suns have the same speed relative to the arm, so the arm cannot move while one is fixed: change a number of teeth",
            ));
        }
        // (ω_R − ω_A) = e (ω_S − ω_A): the speed of each member over that of the driver.
        let one = W::Num::from(1.0);
        let ratio = match (self.fixed, self.driver) {
            (Member::Sun, Member::Ring) => one / (one - held),
            (Member::Sun, _) => one - held,
            (Member::Ring, Member::Sun) => -(held / (one - held)),
            (Member::Ring, _) => -((one - held) / held),
            (Member::Arm, Member::Sun) => held,
            (Member::Arm, _) => one / held,
        };
        let why = match self.fixed {
            Member::Sun => "Willis, ω_R − ω_A = e (ω_S − ω_A), with the sun fixed: driven over driver",
            Member::Ring => "Willis, ω_R − ω_A = e (ω_S − ω_A), with the ring fixed: driven over driver",
            Member::Arm => "Willis, ω_R − ω_A = e (ω_S − ω_A), with the arm fixed: driven over driver",
        };
        if self.fixed != Member::Arm {
            let as_fixed_axes = || match (self.fixed, self.driver) {
                (Member::Ring, Member::Sun) | (Member::Sun, Member::Arm) => held,
                _ => one / held,
            };
            sheet.common_error("i", "the ratio of the train with its arm fixed used", as_fixed_axes);
        }
        let inner = sheet.step("i", "1", ratio, (why, SHIGLEY.at("ch. 9")));
        let (mut total, mut driver_speed) = (inner, given.speed);
        if let Some(pinion) = &self.pinion {
            let (small, large) = (found("p", f64::from(pinion.pinion)), found("w", f64::from(pinion.wheel)));
            let why = "The pinion turns the driving member in the opposite sense";
            driver_speed = sheet.step(symbol("ω", "d"), "rpm", -(given.speed * small / large), why);
            let why = "Speed of the driven member over that of the pinion";
            total = sheet.step(symbol("i", "p"), "1", -(inner * small / large), why);
        }
        sheet.answer("ratio", "Speed of the driven member over that of the driving shaft", total);
        let output =
            sheet.step(symbol("ω", "out"), "rpm", driver_speed * inner, "Speed of the driven member");
        sheet.answer("driven_speed", "Speed of the driven member", output);
        // The planet, for the bearings in it.
        let speed_of = |member: Member| {
            if member == self.driver {
                driver_speed
            } else if member == driven {
                output
            } else {
                W::Num::from(0.0)
            }
        };
        let arm = speed_of(Member::Arm);
        let size = first;
        let planet = sheet.numerical(symbol("z", "P"), "1", size, "Teeth of the planet on the sun");
        let against = if self.fixed == Member::Sun {
            let why = "Speed of the planet relative to the arm: it rolls on the fixed sun";
            sheet.common_error(
                symbol("ω", "P/A"),
                "the absolute speed of the planet taken, not that relative to the arm",
                || arm * zs / planet + arm,
            );
            let against = sheet.step(symbol("ω", "P/A"), "rpm", arm * zs / planet, why);
            sheet.answer("planet_speed", "Speed of the planet relative to the arm", against);
            against
        } else {
            let sun = speed_of(Member::Sun);
            let relative = if self.fixed == Member::Arm { sun } else { sun - arm };
            let why = "Speed of the planet relative to the arm: it meshes with the sun";
            if self.fixed != Member::Arm {
                sheet.common_error(
                    symbol("ω", "P/A"),
                    "the absolute speed of the planet taken, not that relative to the arm",
                    || arm - relative * zs / planet,
                );
            }
            let against = sheet.step(symbol("ω", "P/A"), "rpm", -(relative * zs / planet), why);
            sheet.answer("planet_speed", "Speed of the planet relative to the arm", against);
            against
        };
        let (input, load) = match given.torque {
            KnownTorqueGiven::Driving { torque } => {
                let why =
                    "Virtual power, T_in ω_in + T_out ω_out = 0: torque of the load on the driven member";
                (torque, sheet.step(symbol("T", "out"), "N*m", -(torque / total), (why, BEVAN.at("ch. 12"))))
            }
            KnownTorqueGiven::Load { torque } => {
                let why = "Virtual power, T_in ω_in + T_out ω_out = 0: torque on the driving shaft";
                (sheet.step(symbol("T", "in"), "N*m", -(torque * total), (why, BEVAN.at("ch. 12"))), torque)
            }
        };
        sheet.answer("driving_torque", "Torque on the driving shaft", input);
        sheet.answer("load_torque", "Torque of the load on the driven member", load);
        let on_driver = match &self.pinion {
            None => input,
            Some(_) => {
                let why = "Torque of the pinion on the driving member: the same virtual power";
                sheet.step(symbol("T", "d"), "N*m", -(load * inner), why)
            }
        };
        let why = "Equilibrium of the three torques on sun, ring and arm: holding torque of the fixed member";
        if self.pinion.is_some() {
            sheet.common_error(
                symbol("T", "fix"),
                "the torque on the pinion shaft taken for that on the driving member",
                || -(input + load),
            );
        }
        let holding = sheet.step(symbol("T", "fix"), "N*m", -(on_driver + load), (why, BEVAN.at("ch. 12")));
        sheet.answer("holding_torque", "Holding torque of the fixed member", holding);
        let power = sheet.step("P", "W", input * given.speed, "Power of the driving shaft");
        sheet.answer("power", "Power of the driving shaft", power);
        let (solved, links, hold) = self.built(teeth, on_driver.value()).map_err(built::refusal)?;
        sheet.verify(|| {
            let size = load.value().abs().max(on_driver.value().abs());
            sheet.check_sum(
                "the load from the Newton–Euler equations of every gear",
                load,
                solved.effort(0).into(),
                size,
            );
            let turned = solved.dynamics.coefficients[0][solved_index(links[self.driver as usize])][2];
            sheet.check("ratio of the speeds from the meshes of the gears", inner, (1.0 / turned).into());
            let driven_turns = output.value();
            let what = "speed of the driving member from the meshes, with that of the driven one";
            sheet.check(what, driver_speed, (driven_turns * turned).into());
            let coefficients = &solved.dynamics.coefficients[0];
            let (of_planet, of_arm) = (coefficients[links.len()][2], coefficients[solved_index(links[2])][2]);
            let what = "speed of the planet from the meshes, with that of the driven member";
            let size = driven_turns.abs() * (of_planet.abs() + of_arm.abs());
            sheet.check_sum(what, against, (driven_turns * (of_planet - of_arm)).into(), size);
            let what = "holding torque of the fixed member from the Newton–Euler equations of every gear";
            let size = load.value().abs() + on_driver.value().abs();
            sheet.check_sum(what, holding, solved.reaction(hold)[0].into(), size);
            let what = "power of the driving shaft and of the load on the driven member";
            sheet.check(what, power, -(load * output));
        });
        sheet.show(|| solved.works(0));
        let speeds = [Member::Sun, Member::Ring, Member::Arm].map(|member| speed_of(member).value());
        sheet.show(|| self.animation(teeth, speeds));
        Ok(())
    }
}

/// With that member fixed nothing else can turn: `e = 1`.
fn driven_is_stuck(fixed: Member, held: f64) -> bool {
    fixed != Member::Arm && held == 1.0
}

fn solved_index(link: Link) -> usize {
    link.frame().unwrap_or(0)
}

impl EpicyclicTrain {
    /// Sun, planet on the sun, planet on the ring, ring.
    fn teeth(&self) -> [f64; 4] {
        match self.gears {
            Gears::Simple { sun, ring } => {
                let planet = (f64::from(ring) - f64::from(sun)) / 2.0;
                [f64::from(sun), planet, planet, f64::from(ring)]
            }
            Gears::Compound { sun, first, second, ring } => [sun, first, second, ring].map(f64::from),
            Gears::Suns { sun, first, second, other } => [sun, first, second, other].map(f64::from),
        }
    }

    /// Refuses gears that cannot be put together.
    fn fits(&self, [sun, planet, second, ring]: [f64; 4]) -> Result<(), Refusal> {
        let crowded = match self.gears {
            Gears::Simple { .. } => planet <= 0.0,
            Gears::Compound { .. } => ring <= second,
            Gears::Suns { .. } => false,
        };
        if crowded {
            return Err(Refusal::because(
                Text::new("a ring of {ring} teeth leaves no room for the planets around a sun of {sun} teeth: give the ring more teeth")
                    .with("ring", ring)
                    .with("sun", sun),
            ));
        }
        Ok(())
    }

    /// The same train put together from gears: sun, ring, arm; and the joint that holds the fixed member. That is pinned
    /// and held, the driven one is moved, and the torque on the driver is a load.
    fn built(
        &self,
        [sun, first, second, ring]: [f64; 4],
        torque: f64,
    ) -> Result<(Solved, [Link; 3], usize), PlanarError> {
        let mut it = Built::new([0.0; 2]);
        let internal = !matches!(self.gears, Gears::Suns { .. });
        let still = BuiltMass::default();
        let names = ["sun", "ring", "arm"];
        let links = names.map(|name| it.link(name, [0.0; 2], 0.0, still));
        let reach = 0.1;
        let planet = it.link("planet", [reach, 0.0], 0.0, still);
        for link in links {
            it.pin(BodyPoint::ground([0.0; 2]), link.point([0.0; 2]));
        }
        let [s, r, arm] = links;
        it.pin(arm.point([reach, 0.0]), planet.point([0.0; 2]));
        let carrier = arm.frame();
        it.join(PlanarJoint::Gears {
            a: s.frame(),
            b: planet.frame(),
            carrier,
            sizes: [sun, first],
            internal: false,
        });
        it.join(PlanarJoint::Gears {
            a: planet.frame(),
            b: r.frame(),
            carrier,
            sizes: [second, ring],
            internal,
        });
        let held = links[self.fixed as usize];
        let measure = |link: Link| RelativeCoordinate::Angle { of: link.frame(), against: None };
        let hold = it.join(PlanarJoint::Relation { terms: vec![(1.0, measure(held))], constant: Some(0.0) });
        if torque != 0.0 {
            it.couple("Torque on the driving member", links[self.driver as usize], torque);
        }
        let driven = (0..3).find(|member| *member != self.fixed as usize && *member != self.driver as usize);
        it.turn(links[driven.unwrap_or(0)], [0.0, 1.0, 0.0]);
        Ok((it.solve()?, links, hold))
    }

    /// Letters of what is given at the driving member.
    fn driving_letters(&self) -> &'static str {
        match self.torque {
            KnownTorque::Driving { .. } => "ω_in, T_in",
            KnownTorque::Load { .. } => "ω_in",
        }
    }

    /// The train turning: pitch circles with a mark on each.
    fn animation(
        &self,
        [sun, first, second, ring]: [f64; 4],
        [sun_speed, ring_speed, arm_speed]: [f64; 3],
    ) -> Exhibit {
        const FRAMES: usize = 24;
        let driver_speed = match self.driver {
            Member::Sun => sun_speed,
            Member::Ring => ring_speed,
            Member::Arm => arm_speed,
        };
        let pinion = self.pinion.as_ref().map(|pinion| {
            let (small, large) = (f64::from(pinion.pinion), f64::from(pinion.wheel));
            (pinion, small / large, -driver_speed * large / small)
        });
        let fastest = pinion.iter().map(|(.., speed)| *speed).chain([sun_speed, ring_speed, arm_speed]);
        let fastest = fastest.fold(0.0, |most: f64, speed| most.max(speed.abs()));
        let outside = matches!(self.gears, Gears::Suns { .. });
        // Pitch radii with the axes one apart: the modules of the two meshes may differ.
        let axes = 1.0;
        let one = axes / (sun + first);
        let two = if outside { axes / (second + ring) } else { axes / (ring - second) };
        let planet_speed = |frame: f64| frame * (arm_speed - (sun_speed - arm_speed) * sun / first);
        let frame = |n: usize| {
            // One turn of the fastest member over the animation.
            let time =
                if fastest > 0.0 { std::f64::consts::TAU / fastest * n as f64 / FRAMES as f64 } else { 0.0 };
            let (o, centre) = ((0.0, 0.0), At::from(built::away([0.0; 2], axes, arm_speed * time)));
            let mut sketch = Sketch::default();
            let (rim, hub) = (ring * two, sun * one);
            sketch.gear("", o, rim, ring_speed * time).gear("", o, hub, sun_speed * time).gear(
                "",
                centre,
                first * one,
                planet_speed(time),
            );
            if second != first {
                sketch.gear("", centre, second * two, planet_speed(time));
            }
            let teeth = |name: &str, teeth: f64| Text::verbatim(format!("{name}, z = {teeth}"));
            let planet = if second == first {
                teeth("P", first)
            } else {
                Text::verbatim(format!("P, z = {first}, {second}"))
            };
            // The name of the outer member stands below, where no arm is at the beginning.
            sketch
                .link("A", o, centre)
                .pin("", o)
                .joint("", centre)
                .caption(teeth("S", sun), (0.0, 0.5 * hub))
                .label(planet, (centre.0, centre.1 + 0.5 * first * one))
                .label(teeth(if outside { "S₂" } else { "R" }, ring), (0.0, -rim));
            let radius = match self.driver {
                Member::Sun => hub,
                Member::Ring => rim,
                Member::Arm => axes,
            };
            // The shaft that drives: that of the member, or of the pinion in mesh with the wheel on it, outside of all others.
            let (middle, radius, speed) = match pinion {
                None => (o, radius, driver_speed),
                Some((pinion, share, speed)) => {
                    let wheel = 1.1 * rim.max(axes + first.max(second) * one);
                    let (middle, small) = ((-wheel * (1.0 + share), 0.0), wheel * share);
                    sketch
                        .gear("", middle, small, speed * time)
                        .pin("", middle)
                        .caption(
                            Text::verbatim(format!("z = {}", pinion.pinion)),
                            (middle.0, middle.1 + 0.5 * small),
                        )
                        .gear("", o, wheel, driver_speed * time)
                        .label(
                            Text::verbatim(format!("z = {}", pinion.wheel)),
                            (wheel * FRAC_1_SQRT_2, wheel * FRAC_1_SQRT_2),
                        );
                    (middle, small, speed)
                }
            };
            let (start, way) =
                (if pinion.is_some() { 2.6 } else { 3.6 }, 0.5 * if speed < 0.0 { -1.0 } else { 1.0 });
            let at = |angle: f64| At::from(built::away(middle.into(), 1.12 * radius, angle));
            let bent: Vec<At> = (0..=8).map(|n| at(start + way * f64::from(n) / 8.0)).collect();
            sketch.curve(bent, Ink::Motion).vector(
                self.driving_letters(),
                at(start + 0.8 * way),
                at(start + way),
                Ink::Motion,
            );
            sketch
        };
        Exhibit::Animation(Sketch::animation("The epicyclic train", (0..FRAMES).map(frame), 4.0))
    }
}
