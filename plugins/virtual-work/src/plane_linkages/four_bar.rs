//! The four-bar linkage: torque, motion, instant centres, transmission angle, reactions.

mod pictures;

use dalembert_core::{About, Analysis, Inputs, Refusal, Text, Worksheet, register};
use dalembert_mechanics::{
    Real, Vector, four_bar as kernel,
    planar::{BodyPoint, PlanarError},
};
use nalgebra::Vector3;

use crate::{
    shared::{
        built::{self, Built, Link, Solved, Template},
        dyad::{self, DyadPin},
        kinematics::{self, Kinematics, Motion},
        linkage::Closing,
        works::{self, FOUR, LinkMass, RotatingLinkWork, THREE, TWO, Works, plane, symbol},
    },
    sources::{NORTON, RIUL, SHIGLEY},
};

/// A four-bar linkage in one position.
///
/// The crank turns about the origin O, the rocker about C on the x axis; A is the crank pin, B the pin of coupler
/// and rocker. Angles are counter-clockwise from the frame.
#[derive(Clone, Debug, Inputs)]
pub struct FourBar {
    /// Length of the crank.
    #[input("a", "mm", positive)]
    pub crank: f64,
    /// Length of the coupler.
    #[input("b", "mm", positive)]
    pub coupler: f64,
    /// Length of the rocker.
    #[input("c", "mm", positive)]
    pub rocker: f64,
    /// Length of the frame.
    /// Between the fixed pins.
    #[input("d", "mm", positive)]
    pub frame: f64,
    /// Closing of the loop.
    pub closing: Closing,
    /// Angle of the crank.
    #[input("θ_2", "deg")]
    pub angle: f64,
    /// Find.
    pub unknown: FourBarUnknown,
    /// Point of the coupler.
    pub point: Option<CouplerPoint>,
    /// Angular velocity of the crank.
    /// Zero in statics.
    #[input("ω_2", "rad/s", default = "0 rad/s")]
    pub speed: f64,
    /// Angular acceleration of the crank.
    #[input("α_2", "rad/s^2", default = "0 rad/s^2")]
    pub acceleration: f64,
    /// Mass of the crank.
    #[input("2")]
    pub crank_mass: Option<LinkMass>,
    /// Mass of the coupler.
    #[input("3")]
    pub coupler_mass: Option<LinkMass>,
    /// Mass of the rocker.
    #[input("4")]
    pub rocker_mass: Option<LinkMass>,
    /// Acceleration of gravity.
    /// Zero for a mechanism in a horizontal plane.
    #[input("g", "m/s^2", planar, default = "(0; -9.81) m/s^2")]
    pub gravity: Vector3<f64>,
}

/// Unknown of the virtual work.
#[derive(Clone, Debug, Inputs)]
pub enum FourBarUnknown {
    /// Torque on the crank
    Torque {
        /// Torque on the rocker.
        /// Positive counter-clockwise, as it acts on the rocker.
        #[input("T_4", "N*m", default = "0 N*m")]
        load: f64,
    },
    /// Torque on the rocker
    Load {
        /// Torque on the crank.
        /// Positive counter-clockwise.
        #[input("T_2", "N*m")]
        torque: f64,
    },
}

/// A point of the coupler and a force on it.
#[derive(Clone, Debug, Inputs)]
pub struct CouplerPoint {
    /// Distance from the crank pin along the coupler.
    #[input("p", "mm")]
    pub along: f64,
    /// Distance from the line of the pins, to its left.
    #[input("q", "mm", default = "0 mm")]
    pub across: f64,
    /// Force on it.
    #[input("F_P", "N", planar, default = "(0; 0) N")]
    pub force: Vector3<f64>,
}

/// Results in one position.
pub struct FourBarPosition<N> {
    angles: [N; 2],
    ratios: [N; 2],
    speeds: [N; 2],
    accelerations: [N; 2],
    /// Coupler point, m.
    place: Option<[f64; 2]>,
    torque: N,
    load: N,
}

/// Motions of B, A and B relative to A, and of the coupler point.
struct FourBarMotions<W: Worksheet> {
    pins: [Motion<W>; 3],
    p: Option<Motion<W>>,
}

register!(FourBar);

/// The rocker stands at a dead centre below this turn for a unit turn of the crank.
const DEAD: f64 = 1e-9;

impl Analysis for FourBar {
    const ABOUT: About = About {
        id: "virtual-work/four-bar",
        title: "Four-bar linkage",
        topic: "Plane linkages",
        summary: "Torque on crank or rocker of a four-bar linkage, at rest or in motion with masses, by virtual work; coupler curve, instant centres, transmission angle, reactions.",
        main: &["torque", "rocker_speed", "coupler_angle", "rocker_angle"],
        keywords: "quadrilátero articulado quatro barras mecanismo manivela balancim acoplador curva do \
                   acoplador grashof ângulo de transmissão centro instantâneo vantagem mecânica torque four bar \
                   linkage crank rocker coupler curve fourbar force analysis kinematic analysis análise \
                   cinemática análise de forças instantaneous center of velocity",
        sources: &[&RIUL, &NORTON, &SHIGLEY],
        cases: include_str!("../../cases/four_bar.toml"),
    };
    const SIMD: bool = true;

    #[inline(always)]
    fn solve<W: Worksheet>(&self, given: &FourBarGiven<W>, sheet: W) -> Result<(), Refusal> {
        let found = self.efforts(given, sheet)?;
        let moves = works::moves(given.speed, given.acceleration);
        sheet.answer("coupler_angle", "Angle of the coupler", found.angles[0]);
        sheet.answer("rocker_angle", "Angle of the rocker", found.angles[1]);
        sheet.answer("coupler_ratio", "Ratio of angular velocities, coupler to crank", found.ratios[0]);
        sheet.answer("rocker_ratio", "Ratio of angular velocities, rocker to crank", found.ratios[1]);
        if moves {
            sheet.answer("coupler_speed", "Angular velocity of the coupler", found.speeds[0]);
            sheet.answer("rocker_speed", "Angular velocity of the rocker", found.speeds[1]);
            let label = "Angular acceleration of the coupler";
            sheet.answer("coupler_acceleration", label, found.accelerations[0]);
            let label = "Angular acceleration of the rocker";
            sheet.answer("rocker_acceleration", label, found.accelerations[1]);
        }
        match self.unknown {
            FourBarUnknown::Torque { .. } => sheet.answer("torque", "Torque on the crank", found.torque),
            FourBarUnknown::Load { .. } => sheet.answer("load", "Torque on the rocker", found.load),
        }
        sheet.keep_going()?;
        let between = (found.angles[1] - found.angles[0]).cos().abs().acos();
        let why = ("Transmission angle: the acute angle between coupler and rocker", NORTON.at("ch. 3"));
        let of_crank = || (found.angles[1] - given.angle).cos().abs().acos();
        sheet.common_error("μ", "the angle between crank and rocker taken", of_crank);
        let of_coupler = || (found.angles[0] - given.angle).cos().abs().acos();
        sheet.common_error("μ", "the angle between crank and coupler taken", of_coupler);
        let between = sheet.step("μ", "deg", between, why);
        sheet.answer("transmission_angle", "Transmission angle", between);
        sheet.verify(|| {
            self.check_transmission(given, between, sheet);
            if between.value() < 40f64.to_radians() {
                sheet.warn(|| {
                    Text::new("the transmission angle is {angle}: below 40° force transmission is poor and the joint forces are large")
                        .with_quantity("angle", between.value(), "deg")
                });
            }
        });
        self.instant_centres(given, &found, sheet);
        self.limits(given, sheet);
        sheet.keep_going()?;
        let motions = if moves { Some(self.kinematics(given, &found, sheet)) } else { None };
        sheet.keep_going()?;
        let [coupler, rocker] = found.angles.map(Real::value);
        let (solved, [o, a, b, c]) = self.built([coupler, rocker], &found).map_err(built::refusal)?;
        works::reaction(
            ["O", "Ox", "Oy"],
            ("crank_bearing_force", "Force in the fixed pin of the crank"),
            (&solved, o),
            sheet,
        );
        works::reaction(
            ["A", "Ax", "Ay"],
            ("crank_pin_force", "Force in the crank pin"),
            (&solved, a),
            sheet,
        );
        works::reaction(
            ["B", "Bx", "By"],
            ("rocker_pin_force", "Force in the pin of coupler and rocker"),
            (&solved, b),
            sheet,
        );
        works::reaction(
            ["C", "Cx", "Cy"],
            ("rocker_bearing_force", "Force in the fixed pin of the rocker"),
            (&solved, c),
            sheet,
        );
        sheet.verify(|| {
            let effort = match self.unknown {
                FourBarUnknown::Torque { .. } => found.torque,
                FourBarUnknown::Load { .. } => found.load,
            };
            solved.check_effort(0, effort, sheet);
            if let Some((kinematics, motions)) = &motions {
                self.check_motions(kinematics, motions, &solved);
            }
            let force = self.point.as_ref().map_or([0.0; 2], |point| [point.force.x, point.force.y]);
            works::check_balance(
                &[solved.reaction(o), solved.reaction(c), force],
                solved.inertia_resultant(),
                sheet,
            );
            let lengths = kernel::FourBar {
                frame: self.frame,
                crank: self.crank,
                coupler: self.coupler,
                rocker: self.rocker,
            };
            let branch = match self.closing {
                Closing::Open => kernel::Branch::Open,
                Closing::Crossed => kernel::Branch::Crossed,
            };
            let links = lengths.links(self.angle, branch);
            for (n, link, what) in [
                (0, links.coupler, "rotation of the coupler from the derivatives of the loop equation"),
                (1, links.rocker, "rotation of the rocker from the derivatives of the loop equation"),
            ] {
                let size = links.coupler.first.abs().max(links.rocker.first.abs());
                sheet.check_sum(what, found.ratios[n], link.first.into(), size);
            }
            if moves {
                let (w, alpha) = (self.speed, self.acceleration);
                let of = |link: dalembert_mechanics::linkage::LinkRotation<f64>| {
                    link.first * alpha + link.second * w * w
                };
                let size = of(links.coupler).abs().max(of(links.rocker).abs()).max(w * w);
                for (n, link, what) in [
                    (
                        0,
                        links.coupler,
                        "angular acceleration of the coupler from the derivatives of the loop equation",
                    ),
                    (
                        1,
                        links.rocker,
                        "angular acceleration of the rocker from the derivatives of the loop equation",
                    ),
                ] {
                    sheet.check_sum(what, found.accelerations[n], of(link).into(), size);
                }
            }
        });
        sheet.show(|| solved.works(0));
        self.show(sheet);
        Ok(())
    }
}

impl Template for FourBar {
    type Found<N: Real> = FourBarPosition<N>;

    #[inline(always)]
    fn efforts<W: Worksheet>(
        &self,
        given: &FourBarGiven<W>,
        sheet: W,
    ) -> Result<FourBarPosition<W::Num>, Refusal> {
        let moves = works::moves(given.speed, given.acceleration);
        let crank = RotatingLinkWork::crank(given.angle, given.speed, given.acceleration);
        let arm = works::direction::<W>(given.angle) * given.crank;
        let arm = sheet.step_vector(symbol("r", "2"), "mm", arm, "Crank, from O to A");
        let fixed = plane::<W>(given.frame, 0.0.into());
        let pin = works::moving("A", works::fixed(), arm, crank, moves, sheet);
        let supports = [
            DyadPin { name: "A", at: arm, moving: Some(pin) },
            DyadPin { name: "C", at: fixed, moving: None },
        ];
        let lengths = [given.coupler, given.rocker];
        let open = self.closing == Closing::Open;
        let pair = dyad::two_bars("AC", supports, lengths, [THREE, FOUR], open, sheet)?;
        let ratios = pair.turns("h", [Some(pin.shift), None]);
        let [coupler, rocker] = pair.motion(supports, ratios, given.speed, moves);
        let mut works = Works::new(given.gravity, moves, sheet);
        works.link(TWO, given.crank_mass.as_ref(), given.crank, works::fixed(), crank);
        works.link(THREE, given.coupler_mass.as_ref(), given.coupler, pin, coupler);
        works.link(FOUR, given.rocker_mass.as_ref(), given.rocker, works::fixed(), rocker);
        let mut place = None;
        if let Some(this) = &given.point {
            let along = works::direction::<W>(coupler.angle);
            let arm = along * this.along + works::across::<W>(along) * this.across;
            let why = "From the crank pin to the point of the coupler";
            let arm = sheet.step_vector(symbol("r", "P"), "mm", arm, why);
            if !this.force.is_zero() {
                let moving = works::moving("P", pin, arm, coupler, false, sheet);
                works.force("P", this.force, moving.shift);
            }
            let at = supports[0].at.value() + arm.value();
            place = Some([at.x, at.y]);
        }
        let (torque, load) = match given.unknown {
            FourBarUnknownGiven::Torque { load } => {
                works.couple(FOUR, load, rocker.ratio);
                let sum = works.sum();
                let why = "Torque: the total virtual work is zero, T_2 δθ_2 + ΣδW = 0";
                (sheet.step(symbol("T", "2"), "N*m", -sum, (why, RIUL.at("eq. 5"))), load)
            }
            FourBarUnknownGiven::Load { torque } => {
                if rocker.ratio.holds(|ratio| ratio.abs() < DEAD) {
                    return Err(Refusal::because(
                        "crank and coupler are collinear and the rocker reverses: no torque on the rocker can balance one on the crank; rotate the crank slightly",
                    ));
                }
                works.driving(torque);
                let sum = works.sum();
                let why = "Torque on the rocker: the total virtual work is zero, T_4 h_4 + ΣδW = 0";
                let load =
                    sheet.step(symbol("T", "4"), "N*m", -(sum / rocker.ratio), (why, RIUL.at("eq. 5")));
                (torque, load)
            }
        };
        Ok(FourBarPosition {
            angles: pair.angles,
            ratios,
            speeds: [coupler.speed, rocker.speed],
            accelerations: [coupler.acceleration, rocker.acceleration],
            place,
            torque,
            load,
        })
    }
}

impl FourBar {
    fn moves(&self) -> bool {
        self.speed != 0.0 || self.acceleration != 0.0
    }

    /// Velocities and accelerations of A, of B, of B relative to A, and of the coupler point.
    fn kinematics<W: Worksheet>(
        &self,
        given: &FourBarGiven<W>,
        found: &FourBarPosition<W::Num>,
        sheet: W,
    ) -> (Kinematics<W>, FourBarMotions<W>) {
        let link = |n: usize| RotatingLinkWork {
            angle: found.angles[n],
            ratio: found.ratios[n],
            speed: found.speeds[n],
            acceleration: found.accelerations[n],
        };
        let crank = RotatingLinkWork::crank(given.angle, given.speed, given.acceleration);
        let of = Kinematics::new(given.speed, given.acceleration, given.crank, sheet);
        let (coupler, rocker) = (link(0), link(1));
        let a = of.about(&kinematics::A, crank.reach::<W>(given.crank), crank);
        let b = of.about(&kinematics::B, rocker.reach::<W>(given.rocker), rocker);
        let ba = of.about(&kinematics::B_RELATIVE_TO_A, coupler.reach::<W>(given.coupler), coupler);
        let p = given.point.as_ref().map(|point| {
            let along = works::direction::<W>(coupler.angle);
            let arm = along * point.along + works::across::<W>(along) * point.across;
            of.beyond(&kinematics::P, Some(a), arm, coupler)
        });
        (of, FourBarMotions { pins: [b, a, ba], p })
    }

    /// Holds the motions of the points to those of the mechanism put together.
    fn check_motions<W: Worksheet>(&self, of: &Kinematics<W>, motions: &FourBarMotions<W>, solved: &Solved) {
        let [b, a, _] = motions.pins;
        of.check_relative(["B", "A", "BA"], motions.pins);
        of.check(&kinematics::A, a, solved, 0, [self.crank, 0.0]);
        of.check(&kinematics::B, b, solved, 2, [self.rocker, 0.0]);
        if let (Some(motion), Some(point)) = (motions.p, &self.point) {
            of.check(&kinematics::P, motion, solved, 1, [point.along, point.across]);
        }
    }

    /// The transmission angle by the law of cosines, in the triangle of coupler, rocker and the diagonal.
    fn check_transmission<W: Worksheet>(&self, given: &FourBarGiven<W>, between: W::Num, sheet: W) {
        let (a, b, c, d) = (given.crank, given.coupler, given.rocker, given.frame);
        let diagonal = a.powi(2) + d.powi(2) - a * d * given.angle.cos() * 2.0;
        let wide = (b.powi(2) + c.powi(2) - diagonal).abs();
        let scale = (self.crank + self.frame).powi(2) + (self.coupler + self.rocker).powi(2);
        let what = "transmission angle by the law of cosines, from the diagonal of the linkage";
        sheet.check_sum(what, b * c * between.cos() * 2.0, wide, scale);
    }

    /// Instant centres, at the intersections of the lines of the links: a graphical check of the velocity ratios.
    fn instant_centres<W: Worksheet>(
        &self,
        given: &FourBarGiven<W>,
        found: &FourBarPosition<W::Num>,
        sheet: W,
    ) {
        let [coupler, rocker] = found.ratios;
        if rocker.holds(|rocker| rocker.abs() > DEAD) {
            let advantage = rocker.abs();
            let advantage = W::Num::from(1.0) / advantage;
            let why = "Mechanical advantage: ratio of rocker torque to crank torque, neglecting masses";
            let advantage = sheet.step("MA", "1", advantage, (why, NORTON.at("ch. 6")));
            sheet.answer("mechanical_advantage", "Mechanical advantage", advantage);
        }
        if rocker.holds(|rocker| (rocker - 1.0).abs() > DEAD) {
            let centre = rocker * given.frame / (rocker - 1.0);
            let why = "Instant centre 24, on the line of the frame: x ω_2 = (x − d) ω_4";
            let centre = sheet.step(symbol("x", "I24"), "mm", centre, (why, SHIGLEY.at("ch. 3")));
            sheet.answer("instant_centre_24", "Instant centre 24 on the line of the frame, from O", centre);
            sheet.verify(|| {
                let (crank_pin, coupler_angle) =
                    (built::away([0.0; 2], self.crank, self.angle), found.angles[0].value());
                let height = crank_pin[1] * coupler_angle.cos()
                    - (crank_pin[0] - centre.value()) * coupler_angle.sin();
                sheet.check_zero(
                    "instant centre 24 is on the line of the coupler",
                    height.into(),
                    self.crank + centre.value().abs(),
                );
            });
        }
        if coupler.holds(|coupler| coupler.abs() > DEAD) {
            let distance = given.crank / coupler.abs();
            let why = "Distance of the crank pin from instant centre 13: a ω_2 = |I13 A| ω_3";
            let distance = sheet.step(symbol("ρ", "I13"), "mm", distance, (why, SHIGLEY.at("ch. 3")));
            sheet.answer("instant_centre_13", "Distance of the crank pin from instant centre 13", distance);
            sheet.verify(|| {
                // The lines of crank and rocker meet there: both sides are the distance of the crank pin from the rocker's.
                let (two, four) = (given.angle, found.angles[1]);
                let left = distance * (four - two).sin().abs();
                let right = (given.frame * four.sin() - given.crank * (four - two).sin()).abs();
                let what = "instant centre 13 is on the lines of crank and rocker";
                sheet.check_sum(what, left, right, self.frame + self.crank);
            });
        }
    }

    /// The crank angles at which the linkage comes to an end, if it does.
    fn limits<W: Worksheet>(&self, given: &FourBarGiven<W>, sheet: W) {
        let (a, b, c, d) = (given.crank, given.coupler, given.rocker, given.frame);
        let cosine = |reach: W::Num| (a.powi(2) + d.powi(2) - reach.powi(2)) / (a * d * 2.0);
        if self.crank + self.frame > self.coupler + self.rocker {
            let why =
                ("Maximum angle of the crank: coupler and rocker collinear (extended)", NORTON.at("ch. 4"));
            let limit = sheet.step(symbol("θ", "max"), "deg", cosine(b + c).acos(), why);
            sheet.answer("largest_angle", "Maximum angle of the crank, from the frame", limit);
            sheet.verify(|| {
                let reach = (a * limit.sin()).powi(2) + (a * limit.cos() - d).powi(2);
                let what =
                    "coupler and rocker, collinear, span the distance from the crank pin at its maximum angle";
                sheet.check_sum(what, reach, (b + c).powi(2), (self.crank + self.frame).powi(2));
            });
        }
        if (self.crank - self.frame).abs() < (self.coupler - self.rocker).abs() {
            let why =
                ("Minimum angle of the crank: coupler and rocker collinear (folded)", NORTON.at("ch. 4"));
            let limit = sheet.step(symbol("θ", "min"), "deg", cosine(b - c).acos(), why);
            sheet.answer("least_angle", "Minimum angle of the crank, from the frame", limit);
        }
    }

    /// The same mechanism put together from its lengths, and its pins O, A, B, C.
    fn built<N: Real>(
        &self,
        [coupler, rocker]: [f64; 2],
        found: &FourBarPosition<N>,
    ) -> Result<(Solved, [usize; 4]), PlanarError> {
        let mut it = Built::new([self.gravity.x, self.gravity.y]);
        let (pin, fixed) = (built::away([0.0; 2], self.crank, self.angle), [self.frame, 0.0]);
        let mass = |mass: &Option<LinkMass>, length: f64| LinkMass::built(mass.as_ref(), length);
        let two: Link = it.link("crank", [0.0; 2], self.angle, mass(&self.crank_mass, self.crank));
        let three = it.link("coupler", pin, coupler, mass(&self.coupler_mass, self.coupler));
        let four = it.link("rocker", fixed, rocker, mass(&self.rocker_mass, self.rocker));
        let joints = [
            it.pin(BodyPoint::ground([0.0; 2]), two.point([0.0; 2])),
            it.pin(two.point([self.crank, 0.0]), three.point([0.0; 2])),
            it.pin(three.point([self.coupler, 0.0]), four.point([self.rocker, 0.0])),
            it.pin(BodyPoint::ground(fixed), four.point([0.0; 2])),
        ];
        if let Some(point) = self.point.as_ref().filter(|point| point.force != Vector3::zeros()) {
            let force = [point.force.x, point.force.y];
            it.force("Force on the point of the coupler", three.point([point.along, point.across]), force);
        }
        match self.unknown {
            FourBarUnknown::Torque { load } => {
                if load != 0.0 {
                    it.couple("Torque on the rocker", four, load);
                }
                it.turn(two, [self.angle, self.speed, self.acceleration]);
            }
            FourBarUnknown::Load { torque } => {
                if torque != 0.0 {
                    it.couple("Torque on the crank", two, torque);
                }
                it.turn(four, [rocker, found.speeds[1].value(), found.accelerations[1].value()]);
            }
        }
        Ok((it.solve()?, joints))
    }
}
