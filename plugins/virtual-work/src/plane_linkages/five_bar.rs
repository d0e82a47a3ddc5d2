//! The five-bar linkage: two cranks on the frame and two rods that meet, with two degrees of freedom or geared to one.

use std::f64::consts::TAU;

use dalembert_core::{
    About, Analysis, Axis, Exhibit, Ink, Inputs, Plot, Refusal, Series, Text, Worksheet,
    exhibit::Point as At, register,
};
use dalembert_mechanics::{
    Real, Vector,
    planar::{BodyPoint, PlanarError, PlanarJoint},
};
use nalgebra::Vector3;

use crate::{
    shared::{
        built::{self, Built, BuiltMass, Range, Solved, Template, TemplateRange},
        dyad::{self, DyadPin},
        figure,
        kinematics::{self, Kinematics, Motion},
        works::{self, FIVE, FOUR, PointWork, RotatingLinkWork, THREE, plane, symbol},
    },
    sources::{NORTON, RIUL, SHIGLEY},
};

/// A five-bar linkage in one position.
///
/// The first crank (2) turns about the origin O, the second (5) about C on the x axis; A and B are their pins, P is
/// where the rods (3 and 4) meet. Angles are counter-clockwise from the frame.
#[derive(Clone, Debug, Inputs)]
pub struct FiveBar {
    /// Length of the first crank.
    #[input("a", "mm", positive)]
    pub first_crank: f64,
    /// Length of the first rod.
    #[input("b", "mm", positive)]
    pub first_rod: f64,
    /// Length of the second rod.
    #[input("c", "mm", positive)]
    pub second_rod: f64,
    /// Length of the second crank.
    #[input("e", "mm", positive)]
    pub second_crank: f64,
    /// Length of the frame.
    /// Between the fixed pins.
    #[input("d", "mm", positive)]
    pub frame: f64,
    /// Side on which the rods meet.
    pub apex: Apex,
    /// Angle of the first crank.
    #[input("θ_2", "deg", kept_in = "drawn")]
    pub first_angle: f64,
    /// Angle in the initial configuration.
    /// With gears the angle of the second crank is that of the drawn position; from there they turn it as the first
    /// crank turns. If omitted, it is drawn with the angle above.
    #[input("θ_d", "deg")]
    pub drawn: Option<f64>,
    /// Angle of the second crank.
    #[input("θ_5", "deg")]
    pub second_angle: f64,
    /// Cranks.
    pub cranks: CrankDrive,
    /// Find.
    pub unknown: FiveBarUnknown,
    /// Angular velocity of the first crank.
    /// Zero in statics.
    #[input("ω_2", "rad/s", default = "0 rad/s")]
    pub first_speed: f64,
    /// Angular acceleration of the first crank.
    #[input("α_2", "rad/s^2", default = "0 rad/s^2")]
    pub first_acceleration: f64,
}

/// On which side of the way from A to B the rods meet.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum Apex {
    /// To the left, looking from A to B
    Left,
    /// To the right, looking from A to B
    Right,
}

/// Drive of the cranks.
#[derive(Clone, Debug, Inputs)]
pub enum CrankDrive {
    /// Independent: two degrees of freedom
    Free {
        /// Angular velocity of the second crank.
        #[input("ω_5", "rad/s", default = "0 rad/s")]
        speed: f64,
        /// Angular acceleration of the second crank.
        #[input("α_5", "rad/s^2", default = "0 rad/s^2")]
        acceleration: f64,
    },
    /// Geared together: one degree of freedom
    Geared {
        /// Teeth of the gear on the first crank.
        #[input(min = 4, max = 10000)]
        first: u32,
        /// Teeth of the gear on the second crank.
        #[input(min = 4, max = 10000)]
        second: u32,
        /// Mesh.
        mesh: Mesh,
    },
}

/// Mesh of two gears: external or internal.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum Mesh {
    /// External teeth: opposite senses
    Outside,
    /// Through an idler or internal teeth: the same sense
    Same,
}

/// Unknown of the sum of virtual works.
#[derive(Clone, Debug, Inputs)]
pub enum FiveBarUnknown {
    /// Torques on the cranks
    Torques {
        /// Force at the common pin of the rods.
        #[input("F", "N", planar)]
        force: Vector3<f64>,
    },
    /// Force at the common pin of the rods
    Force {
        /// Torque on the first crank.
        #[input("T_2", "N*m")]
        first: f64,
        /// Torque on the second crank.
        #[input("T_5", "N*m")]
        second: f64,
    },
}

/// Results in one position.
pub struct FiveBarPosition<N> {
    angles: [N; 2],
    second_angle: N,
    /// Angular velocities and angular accelerations of both cranks and both rods, in motion.
    turning: Option<[[N; 2]; 4]>,
    /// Common pin of the rods, m.
    place: [f64; 2],
    /// On the first and on the second crank; geared, the one on the first alone.
    torques: [Option<N>; 2],
    force: [N; 2],
}

register!(FiveBar);

/// Two displacements are parallel below this sine.
const DEAD: f64 = 1e-9;

impl Analysis for FiveBar {
    const ABOUT: About = About {
        id: "virtual-work/five-bar",
        title: "Five-bar linkage",
        topic: "Plane linkages",
        summary: "Holding torques of a five-bar linkage with two driven cranks, or geared to one degree of freedom, for a force at the common pin of its rods, by virtual work; or the force from the torques.",
        main: &["first_torque", "second_torque", "first_rod_angle", "second_rod_angle"],
        keywords: "mecanismo de cinco barras dois graus de liberdade engrenado robô paralelo jacobiano five-bar geared \
                   parallel robot Jacobian two degrees of freedom",
        sources: &[&RIUL, &NORTON, &SHIGLEY],
        cases: include_str!("../../cases/five_bar.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &FiveBarGiven<W>, sheet: W) -> Result<(), Refusal> {
        let found = self.efforts(given, sheet)?;
        sheet.answer("first_rod_angle", "Angle of the first rod", found.angles[0]);
        sheet.answer("second_rod_angle", "Angle of the second rod", found.angles[1]);
        match self.unknown {
            FiveBarUnknown::Torques { .. } => {
                if let Some(torque) = found.torques[0] {
                    sheet.answer("first_torque", "Torque on the first crank", torque);
                }
                if let Some(torque) = found.torques[1] {
                    sheet.answer("second_torque", "Torque on the second crank", torque);
                }
            }
            FiveBarUnknown::Force { .. } => {
                sheet.answer("force_x", "Force at the common pin of the rods, along x", found.force[0]);
                sheet.answer("force_y", "Force at the common pin of the rods, along y", found.force[1]);
            }
        }
        let motions = found.turning.map(|turning| self.kinematics(given, (&found, turning), sheet));
        let force = found.force.map(Real::value);
        let angles = found.angles.map(Real::value);
        let (solved, joints) = self.built(angles, force).map_err(built::refusal)?;
        let forces = joints.map(|joint| solved.reaction(joint));
        works::reaction(
            ["O", "Ox", "Oy"],
            ("first_bearing_force", "Force in the fixed pin of the first crank"),
            (&solved, joints[0]),
            sheet,
        );
        works::reaction(
            ["C", "Cx", "Cy"],
            ("second_bearing_force", "Force in the fixed pin of the second crank"),
            (&solved, joints[1]),
            sheet,
        );
        sheet.verify(|| {
            if let (Some((of, [a, b, p])), Some(turning)) = (&motions, found.turning) {
                of.check(&kinematics::A, *a, &solved, 0, [self.first_crank, 0.0]);
                of.check(&kinematics::B, *b, &solved, 1, [self.second_crank, 0.0]);
                of.check(&kinematics::P, *p, &solved, 2, [self.first_rod, 0.0]);
                of.check_rotation(FIVE, turning[1].into(), &solved, 1);
                of.check_rotation(THREE, turning[2].into(), &solved, 2);
                of.check_rotation(FOUR, turning[3].into(), &solved, 3);
            }
            for (driver, torque) in found.torques.into_iter().enumerate() {
                if let Some(torque) = torque {
                    solved.check_effort(driver, torque, sheet);
                }
            }
            if let CrankDrive::Free { .. } = self.cranks {
                works::check_balance(&[forces[0], forces[1], force], solved.inertia_resultant(), sheet);
            }
        });
        sheet.show(|| solved.works(0));
        if let CrankDrive::Free { .. } = self.cranks {
            sheet.show(|| solved.works(1));
        }
        self.show(sheet);
        Ok(())
    }
}

impl Template for FiveBar {
    type Found<N: Real> = FiveBarPosition<N>;

    fn efforts<W: Worksheet>(
        &self,
        given: &FiveBarGiven<W>,
        sheet: W,
    ) -> Result<FiveBarPosition<W::Num>, Refusal> {
        let zero = W::Num::from(0.0);
        let crank =
            |angle: W::Num| RotatingLinkWork { angle, ratio: 1.0.into(), speed: zero, acceleration: zero };
        let arm = works::direction::<W>(given.first_angle) * given.first_crank;
        let arm = sheet.step_vector(symbol("r", "2"), "mm", arm, "First crank, from O to A");
        let gear = self.gear(sheet);
        let turned = match (gear, given.drawn) {
            (Some(gear), Some(drawn)) => {
                let why = "Angle of the second crank, rotated by the gears from the initial configuration";
                sheet.step("θ′_5", "deg", given.second_angle + gear * (given.first_angle - drawn), why)
            }
            _ => given.second_angle,
        };
        let other = works::direction::<W>(turned) * given.second_crank;
        let other = sheet.step_vector(symbol("r", "5"), "mm", other, "Second crank, from C to B");
        let a = works::moving("A", works::fixed(), arm, crank(given.first_angle), false, sheet);
        let b = works::moving("B", works::fixed(), other, crank(turned), false, sheet);
        let end = plane::<W>(given.frame, zero) + other;
        let end = sheet.step_vector(symbol("s", "B"), "mm", end, "B, from the origin");
        let supports = [
            DyadPin { name: "A", at: arm, moving: Some(a) },
            DyadPin { name: "B", at: end, moving: Some(b) },
        ];
        let lengths = [given.first_rod, given.second_rod];
        let left = self.apex == Apex::Left;
        let pair = dyad::two_bars("AB", supports, lengths, [THREE, FOUR], left, sheet)?;
        // Each crank turned by itself.
        let [by_first, by_first_of_second] = pair.turns("h′", [Some(a.shift), None]);
        let [by_second_of_first, by_second] = pair.turns("h″", [None, Some(b.shift)]);
        let bar = |ratio: W::Num, n: usize| RotatingLinkWork {
            angle: pair.angles[n],
            ratio,
            speed: zero,
            acceleration: zero,
        };
        let first: PointWork<W> = works::moving("P2", a, pair.reach[0], bar(by_first, 0), false, sheet);
        let second: PointWork<W> = works::moving("P5", b, pair.reach[1], bar(by_second, 1), false, sheet);
        sheet.verify(|| {
            let what = "the other rod moves the common pin in the same way";
            sheet.check_vector(what, works::across::<W>(pair.reach[1]) * by_first_of_second, first.shift);
            sheet.check_vector(what, works::across::<W>(pair.reach[0]) * by_second_of_first, second.shift);
        });
        let turning = self.moves().then(|| {
            let [speed, acceleration] = self.second_motion(given, gear, sheet);
            let rods = [(THREE, by_first, by_second_of_first), (FOUR, by_first_of_second, by_second)];
            let speeds = rods.map(|(rod, first, second)| {
                let why = || Text::new("Angular velocity of link {n}: by both cranks").with("n", rod.link);
                let sum = first * given.first_speed + second * speed;
                sheet.step(symbol("ω", rod.link), "rad/s", sum, (why, SHIGLEY.at("ch. 3")))
            });
            let crank = |name: &'static str, arm: W::Vec, [speed, acceleration]: [W::Num; 2]| {
                let value = works::across::<W>(arm) * acceleration - arm * speed.powi(2);
                let why = || Text::new("Acceleration of {point}").with("point", name);
                let value = sheet.step_vector(symbol("a", name), "m/s^2", value, (why, SHIGLEY.at("ch. 4")));
                DyadPin { name, at: arm, moving: Some(PointWork { shift: arm, acceleration: value }) }
            };
            let first = [given.first_speed, given.first_acceleration];
            let ends = [crank("A", arm, first), crank("B", other, [speed, acceleration])];
            let rods = pair.accelerations(ends, speeds);
            [first, [speed, acceleration], [speeds[0], rods[0]], [speeds[1], rods[1]]]
        });
        let place = pair.at.value();
        let found = |torques, force| FiveBarPosition {
            angles: pair.angles,
            second_angle: turned,
            turning,
            place: [place.x, place.y],
            torques,
            force,
        };
        match (&given.unknown, gear) {
            (&FiveBarUnknownGiven::Torques { force }, Some(gear)) => {
                let why = "Displacement of P for δθ_2 = 1: by the first crank and, through the gears, by the second";
                let shift = first.shift + second.shift * gear;
                let shift = sheet.step_vector(symbol("u", "P"), "mm", shift, (why, SHIGLEY.at("ch. 3")));
                let why = "Torque on the first crank: T_2 δθ_2 + F · u_P = 0";
                sheet.common_error(
                    symbol("T", "2"),
                    "the magnitudes of force and displacement multiplied, without the angle between them",
                    || -(force.magnitude() * shift.magnitude()),
                );
                let torque =
                    sheet.step(symbol("T", "2"), "N*m", -(force.dot(shift)), (why, RIUL.at("eq. 1")));
                let [x, y, _] = force.components();
                Ok(found([Some(torque), None], [x, y]))
            }
            (&FiveBarUnknownGiven::Torques { force }, None) => {
                let why = "Torque on the first crank, the second fixed: T_2 δθ_2 + F · u_P2 = 0";
                let whole = |shift: W::Vec| -(force.magnitude() * shift.magnitude());
                sheet.common_error(
                    symbol("T", "2"),
                    "the magnitudes of force and displacement multiplied, without the angle between them",
                    || whole(first.shift),
                );
                let one =
                    sheet.step(symbol("T", "2"), "N*m", -(force.dot(first.shift)), (why, RIUL.at("eq. 1")));
                let why = "Torque on the second crank, the first fixed: T_5 δθ_5 + F · u_P5 = 0";
                sheet.common_error(
                    symbol("T", "5"),
                    "the magnitudes of force and displacement multiplied, without the angle between them",
                    || whole(second.shift),
                );
                let two =
                    sheet.step(symbol("T", "5"), "N*m", -(force.dot(second.shift)), (why, RIUL.at("eq. 1")));
                let [x, y, _] = force.components();
                Ok(found([Some(one), Some(two)], [x, y]))
            }
            (FiveBarUnknownGiven::Force { .. }, Some(_)) => Err(Refusal::because(
                "the gears leave one degree of freedom: one torque cannot determine both components of the force; give the force and choose the torque as unknown",
            )),
            (&FiveBarUnknownGiven::Force { first: t2, second: t5 }, None) => {
                let (one, two) = (first.shift, second.shift);
                let sine = Vector::cross(one.value(), two.value()).z;
                if sine.abs() <= DEAD * one.value().norm() * two.value().norm() {
                    return Err(Refusal::because(
                        "both cranks move the point P along the same line: the torques do not determine the force perpendicular to it; rotate a crank slightly",
                    ));
                }
                let ([ux, uy, _], [wx, wy, _]) = (one.components(), two.components());
                let why = "Determinant of the two displacements of P";
                let det = sheet.step("Δ", "mm^2", ux * wy - uy * wx, why);
                let why = "T_2 + F · u_P2 = 0 and T_5 + F · u_P5 = 0, solved for the force along x";
                let x = sheet.step(symbol("F", "x"), "N", (t5 * uy - t2 * wy) / det, (why, RIUL.at("eq. 1")));
                let why = "The same two equations, solved for the force along y";
                let y = sheet.step(symbol("F", "y"), "N", (t2 * wx - t5 * ux) / det, (why, RIUL.at("eq. 1")));
                Ok(found([Some(t2), Some(t5)], [x, y]))
            }
        }
    }
}

impl FiveBar {
    fn moves(&self) -> bool {
        let second = match self.cranks {
            CrankDrive::Free { speed, acceleration } => speed != 0.0 || acceleration != 0.0,
            CrankDrive::Geared { .. } => false,
        };
        self.first_speed != 0.0 || self.first_acceleration != 0.0 || second
    }

    /// Angular velocity and angular acceleration of the second crank.
    fn second_motion<W: Worksheet>(
        &self,
        given: &FiveBarGiven<W>,
        gear: Option<W::Num>,
        sheet: W,
    ) -> [W::Num; 2] {
        match (&given.cranks, gear) {
            (&CrankDriveGiven::Free { speed, acceleration }, _) => [speed, acceleration],
            (_, gear) => {
                let gear = gear.unwrap_or_else(|| W::Num::from(0.0));
                let why = "Angular velocity of the second crank, by the gears";
                let speed = sheet.step(symbol("ω", "5"), "rad/s", gear * given.first_speed, why);
                let why = "Angular acceleration of the second crank, by the gears";
                let value = gear * given.first_acceleration;
                [speed, sheet.step(symbol("α", "5"), "rad/s^2", value, why)]
            }
        }
    }

    /// Angular velocities and accelerations, and the motion of A, B and P.
    fn kinematics<W: Worksheet>(
        &self,
        given: &FiveBarGiven<W>,
        (found, turning): (&FiveBarPosition<W::Num>, [[W::Num; 2]; 4]),
        sheet: W,
    ) -> (Kinematics<W>, [Motion<W>; 3]) {
        let [_, [second, bent], first_rod, second_rod] = turning;
        if let CrankDrive::Geared { .. } = self.cranks {
            sheet.answer("second_speed", "Angular velocity of the second crank", second);
            sheet.answer("second_acceleration", "Angular acceleration of the second crank", bent);
        }
        sheet.answer("first_rod_speed", "Angular velocity of the first rod", first_rod[0]);
        sheet.answer("second_rod_speed", "Angular velocity of the second rod", second_rod[0]);
        sheet.answer("first_rod_acceleration", "Angular acceleration of the first rod", first_rod[1]);
        sheet.answer("second_rod_acceleration", "Angular acceleration of the second rod", second_rod[1]);
        let link = |angle: W::Num, [speed, acceleration]: [W::Num; 2]| {
            RotatingLinkWork::crank(angle, speed, acceleration)
        };
        let crank = link(given.first_angle, turning[0]);
        let other = link(found.second_angle, turning[1]);
        let rod = link(found.angles[0], first_rod);
        let speed = turning[0][0].abs() + second.abs();
        let acceleration = turning[0][1].abs() + bent.abs();
        let length =
            if self.first_crank < self.second_crank { given.second_crank } else { given.first_crank };
        let of = Kinematics::new(speed, acceleration, length, sheet);
        let a = of.about(&kinematics::A, crank.reach::<W>(given.first_crank), crank);
        let b = of.about(&kinematics::B, other.reach::<W>(given.second_crank), other);
        let (arm, _) = rod.reach::<W>(given.first_rod);
        let p = of.beyond(&kinematics::P, Some(a), arm, rod);
        (of, [a, b, p])
    }

    /// The turn of the second crank for a turn of the first, where they are geared.
    fn gear<W: Worksheet>(&self, sheet: W) -> Option<W::Num> {
        let CrankDrive::Geared { first, second, mesh } = self.cranks else { return None };
        let why = "Teeth, as given";
        let z2 = sheet.numerical(symbol("z", "2"), "1", f64::from(first), why);
        let z5 = sheet.numerical(symbol("z", "5"), "1", f64::from(second), why);
        let why = "Virtual rotation of the second crank for δθ_2 = 1, by the gears";
        let ratio = z2 / z5;
        let ratio = if mesh == Mesh::Outside { -ratio } else { ratio };
        Some(sheet.step(symbol("h", "5"), "1", ratio, (why, SHIGLEY.at("ch. 7"))))
    }

    /// The same mechanism put together from its lengths, and its fixed pins.
    fn built(&self, angles: [f64; 2], force: [f64; 2]) -> Result<(Solved, [usize; 2]), PlanarError> {
        let mut it = Built::new([0.0; 2]);
        let [a, b] = self.pins();
        let (still, fixed) = (BuiltMass::default(), [self.frame, 0.0]);
        let two = it.link("first crank", [0.0; 2], self.first_angle, still);
        let five = it.link("second crank", fixed, self.second(), still);
        let three = it.link("first rod", a, angles[0], still);
        let four = it.link("second rod", b, angles[1], still);
        let joints = [
            it.pin(BodyPoint::ground([0.0; 2]), two.point([0.0; 2])),
            it.pin(BodyPoint::ground(fixed), five.point([0.0; 2])),
        ];
        it.pin(two.point([self.first_crank, 0.0]), three.point([0.0; 2]));
        it.pin(five.point([self.second_crank, 0.0]), four.point([0.0; 2]));
        let tip = three.point([self.first_rod, 0.0]);
        it.pin(tip, four.point([self.second_rod, 0.0]));
        if force != [0.0; 2] {
            it.force("Force at the common pin of the rods", tip, force);
        }
        it.turn(two, [self.first_angle, self.first_speed, self.first_acceleration]);
        match self.cranks {
            CrankDrive::Free { speed, acceleration } => {
                it.turn(five, [self.second(), speed, acceleration]);
            }
            CrankDrive::Geared { first, second, mesh } => {
                it.join(PlanarJoint::Gears {
                    a: two.frame(),
                    b: five.frame(),
                    carrier: None,
                    sizes: [f64::from(first), f64::from(second)],
                    internal: mesh == Mesh::Same,
                });
            }
        }
        Ok((it.solve()?, joints))
    }

    fn pins(&self) -> [[f64; 2]; 2] {
        let a = built::away([0.0; 2], self.first_crank, self.first_angle);
        [a, built::away([self.frame, 0.0], self.second_crank, self.second())]
    }

    /// The second crank's angle: geared, it has turned with the first from the drawn position; free, it is as given.
    fn second(&self) -> f64 {
        let follow = match self.cranks {
            CrankDrive::Free { .. } => 0.0,
            CrankDrive::Geared { first, second, mesh } => {
                let ratio = f64::from(first) / f64::from(second);
                if mesh == Mesh::Outside { -ratio } else { ratio }
            }
        };
        self.second_angle + follow * (self.first_angle - self.drawn.unwrap_or(self.first_angle))
    }

    /// The linkage when the first crank has gone to another angle.
    fn turned_to(&self, angle: f64) -> Self {
        Self { first_angle: angle, drawn: self.drawn.or(Some(self.first_angle)), ..self.clone() }
    }

    fn show<W: Worksheet>(&self, sheet: W) {
        let at = |angle: f64| self.turned_to(angle);
        let closes = |angle: f64| {
            let [[ax, ay], [bx, by]] = at(angle).pins();
            let distance = (bx - ax).hypot(by - ay);
            distance < self.first_rod + self.second_rod && distance > (self.first_rod - self.second_rod).abs()
        };
        let range = Range::about(self.first_angle, closes);
        let cycle = TemplateRange::new(range, "first_angle", at);
        if let FiveBarUnknown::Torques { .. } = self.unknown {
            sheet.show(|| {
                let torque = |n: usize| cycle.curve(|found| found.torques[n].unwrap_or(f64::INFINITY));
                let mut series = vec![Series::line("first crank", torque(0)).of("first_torque")];
                if let CrankDrive::Free { .. } = self.cranks {
                    series.push(Series::line("second crank", torque(1)).of("second_torque"));
                }
                Exhibit::Plot(
                    Plot::new(
                        Text::from("Torques over one revolution of the first crank"),
                        Axis::linear("Angle of the first crank", "deg"),
                        Axis::linear("Torque", "N*m"),
                        series,
                    )
                    .over("first_angle"),
                )
            });
        }
        let path = || {
            let [x, y] = [0, 1].map(|axis| cycle.curve(|found| found.place[axis]));
            x.into_iter().zip(y).map(|((_, x), (_, y))| (x, y)).collect::<Vec<_>>()
        };
        sheet.show(|| {
            Exhibit::Plot(
                Plot::new(
                    "Path of the common pin of the rods",
                    Axis::linear("x", "mm"),
                    Axis::linear("y", "mm"),
                    vec![Series::line("path", path())],
                )
                .equal(),
            )
        });
        sheet.show(|| {
            built::animation(
                "The five-bar linkage",
                ("first_angle", self.first_angle),
                range,
                self.first_crank.max(self.second_crank) + self.first_rod.max(self.second_rod),
                |angle, sketch| {
                    let there = at(angle);
                    let found = there.plain()?;
                    let [a, b, place] = [there.pins()[0], there.pins()[1], found.place].map(At::from);
                    let (o, fixed) = ((0.0, 0.0), (there.frame, 0.0));
                    if let CrankDrive::Geared { first, second, mesh: Mesh::Outside } = there.cranks {
                        let part = there.frame * f64::from(first) / f64::from(first + second);
                        sketch.circle(o, part, Ink::Faint).circle(fixed, there.frame - part, Ink::Faint);
                    }
                    let unit = sketch.symbol();
                    let second = (b.1 - fixed.1).atan2(b.0 - fixed.0);
                    sketch
                        .link("a", o, a)
                        .link("b", a, place)
                        .link("c", place, b)
                        .link("e", b, fixed)
                        .line("d", o, fixed, Ink::Faint)
                        .pin("O₂", o)
                        .pin("O₅", fixed)
                        .joint("A", a)
                        .joint("B", b)
                        .joint("P", place)
                        .axis(fixed, (fixed.0 + 6.0 * unit, 0.0))
                        .angle("θ₂", o, 0.0, angle.rem_euclid(TAU))
                        .angle("θ₅", fixed, 0.0, second.rem_euclid(TAU));
                    let torques = match there.unknown {
                        FiveBarUnknown::Force { first, second } => [first, second],
                        FiveBarUnknown::Torques { .. } => [0.0; 2],
                    };
                    figure::turning(sketch, o, ("ω₂", there.first_speed), ("T₂", torques[0]));
                    figure::turning(sketch, fixed, ("", 0.0), ("T₅", torques[1]));
                    built::forces(sketch, &[("F", place, found.force)], 0.5 * there.frame);
                    Some(())
                },
            )
        });
    }
}
