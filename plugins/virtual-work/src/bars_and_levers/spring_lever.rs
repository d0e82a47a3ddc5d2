//! An arm that turns about a pivot under a load and a spring: where it balances, and whether it stays there.

mod law;
mod picture;

use dalembert_core::{About, Analysis, Exhibit, Inputs, Refusal, Worksheet, register};
use dalembert_mechanics::Real;

pub use crate::shared::one_degree_of_freedom::Position;
use crate::shared::one_degree_of_freedom::PositionGiven;
use crate::{
    shared::equilibria::{
        Stability, WorkedEquilibrium, check_curvature, check_held, illustrative_angle, reactions, solved,
    },
    sources::{BEER, HIBBELER, RIUL},
};
use law::{Geometry, Height, PotentialLaw};

/// An arm on a pivot, loaded, and held by a spring.
///
/// The angle θ grows clockwise from the position of reference. One of stiffness, load and position is left out or
/// sought.
#[derive(Clone, Debug, Inputs)]
pub struct SpringLever {
    /// The arm at θ = 0.
    pub reference: ArmPosition,
    /// Load.
    pub load: ArmLoad,
    /// Spring.
    pub spring: ArmSpring,
    /// Position.
    pub position: Position,
}

/// Position of the arm at θ = 0; θ grows clockwise.
#[derive(Clone, Copy, Debug, Inputs)]
pub enum ArmPosition {
    /// Vertical, upwards
    Upright,
    /// Horizontal, to the right
    /// The load on the arm moves down as θ increases.
    Horizontal,
    /// Hanging
    Hanging,
    /// Inclined from the vertical position
    Tilted {
        /// Angle from the vertical (inverted) position, clockwise.
        #[input("φ₀", "deg", min = -360, max = 360)]
        tilt: f64,
    },
}

/// Load on the arm.
#[derive(Clone, Debug, Inputs)]
pub enum ArmLoad {
    /// Mass on the arm
    Mass {
        /// Mass.
        /// If left blank, it is computed from the position.
        #[input("m", "kg", positive)]
        mass: Option<f64>,
        /// Distance of its centre from the pivot.
        #[input("l", "m", positive)]
        arm: f64,
        /// Acceleration of gravity.
        #[input("g", "m/s^2", positive, default = "9.81 m/s^2")]
        gravity: f64,
    },
    /// Vertical force on the arm
    Force {
        /// Force, downwards.
        /// If left blank, it is computed from the position.
        #[input("P", "N", positive)]
        force: Option<f64>,
        /// Distance of its point from the pivot.
        #[input("l", "m", positive)]
        arm: f64,
    },
    /// Couple on the arm
    Couple {
        /// Couple, in the sense of θ.
        /// If left blank, it is computed from the position.
        #[input("M", "N*m")]
        couple: Option<f64>,
    },
}

/// Spring of the arm.
#[derive(Clone, Debug, Inputs)]
pub enum ArmSpring {
    /// Torsion spring at the pivot
    Torsion {
        /// Stiffness.
        /// If left blank, it is computed from the position.
        #[input("k", "N*m/rad", positive)]
        stiffness: Option<f64>,
        /// Angle at which the spring is untwisted.
        /// Zero if omitted.
        #[input("θ₀", "deg", min = -3600, max = 3600)]
        free: Option<f64>,
    },
    /// Spring on a cord around a drum
    /// The drum is fixed to the arm.
    Drum {
        /// Stiffness.
        /// If left blank, it is computed from the position.
        #[input("k", "N/m", positive)]
        stiffness: Option<f64>,
        /// Radius of the drum.
        #[input("a", "m", positive)]
        radius: f64,
        /// Angle at which the spring is unstretched.
        /// Zero if omitted.
        #[input("θ₀", "deg", min = -3600, max = 3600)]
        free: Option<f64>,
    },
    /// Spring between the arm and a fixed point
    Points {
        /// Stiffness.
        /// If left blank, it is computed from the position.
        #[input("k", "N/m", positive)]
        stiffness: Option<f64>,
        /// Distance of its end on the arm from the pivot.
        #[input("b", "m", positive)]
        on_arm: f64,
        /// Angle of that end from the line of the arm, clockwise.
        /// 180° on the other side of the pivot.
        #[input("γ", "deg", min = -360, max = 360, default = "0 deg")]
        on_arm_angle: f64,
        /// Distance of its fixed end from the pivot.
        #[input("d", "m", positive)]
        fixed: f64,
        /// Angle of the fixed end from the arm at θ = 0, clockwise.
        #[input("δ", "deg", min = -360, max = 360)]
        fixed_angle: f64,
        /// Unstretched.
        unstretched: FreeConfiguration,
    },
    /// Two springs, one on each side
    /// Perpendicular to the arm at θ = 0, unstretched there, and long enough to keep their direction.
    Sides {
        /// Stiffness of each.
        /// If left blank, it is computed from the position.
        #[input("k", "N/m", positive)]
        stiffness: Option<f64>,
        /// Distance from the pivot.
        #[input("a", "m", positive)]
        height: f64,
    },
}

/// Configuration in which a spring between points is unstretched.
#[derive(Clone, Debug, Inputs)]
pub enum FreeConfiguration {
    /// At a given angle of the arm
    Angle {
        /// Angle of the arm.
        #[input("θ₀", "deg", min = -3600, max = 3600, default = "0 deg")]
        angle: f64,
    },
    /// At a given length
    Length {
        /// Unstretched length.
        #[input("s₀", "m", nonnegative)]
        length: f64,
    },
}

register!(SpringLever);

impl Analysis for SpringLever {
    const ABOUT: About = About {
        id: "virtual-work/spring-lever",
        title: "Arm with a spring",
        topic: "Bars and levers",
        summary: "All equilibria of a loaded arm restrained by a spring, with their stability; or the load or stiffness for a given angle.",
        main: &[
            "stable_angle",
            "critical_stiffness",
            "critical_mass",
            "critical_force",
            "stiffness",
            "mass",
            "holding_couple",
        ],
        keywords: "lever torsion spring drum disc weight inverted pendulum potential energy stability equilibrium critical \
                   alavanca mola de torção tambor disco pêndulo invertido energia potencial estabilidade equilíbrio",
        sources: &[&BEER, &HIBBELER, &RIUL],
        cases: include_str!("../../cases/spring_lever.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &SpringLeverGiven<W>, sheet: W) -> Result<(), Refusal> {
        let height = match &given.reference {
            ArmPositionGiven::Upright {} => Height::Upright,
            ArmPositionGiven::Horizontal {} => Height::Horizontal,
            ArmPositionGiven::Hanging {} => Height::Hanging,
            ArmPositionGiven::Tilted { tilt } => Height::Tilted(*tilt),
        };
        let height = if matches!(given.load, ArmLoadGiven::Couple { .. }) { Height::Couple } else { height };
        let moment = load_moment(&given.load, sheet);
        let (stiffness, geometry) = spring(&given.spring, sheet);
        let law = PotentialLaw { geometry, height };
        let numbers = law.value();
        match &given.position {
            PositionGiven::Sought { from, to } => {
                let (Some(k), Some(moment)) = (stiffness, moment) else {
                    return Err(Refusal::because(
                        "load or stiffness is missing: write it, or write the angle at which the arm is to be in equilibrium",
                    ));
                };
                let range = [from.value(), to.value()];
                let (list, bends) = law.equilibria(k, moment, range, sheet)?;
                self.critical(given, k, moment, &law, sheet);
                sheet.verify(|| {
                    check_held(sheet, &list, moment.value().abs(), |at| {
                        Some(self.built(&numbers, k.value(), moment.value(), at))
                    });
                    for (one, bend) in list.iter().zip(&bends) {
                        let machine = self.built(&numbers, k.value(), moment.value(), one.at);
                        let size = numbers.size(k.value(), moment.value(), one.at);
                        check_curvature(sheet, *bend, size, &machine);
                    }
                    let (mechanism, drawn) =
                        self.built(&numbers, k.value(), moment.value(), illustrative_angle(&list));
                    if let Some(table) = reactions(&mechanism, &drawn, &["Pivot".into()]) {
                        sheet.show(|| table);
                    }
                });
                self.show(&numbers, k.value(), Some(moment.value()), range, &list, sheet);
            }
            PositionGiven::Given { angle } => {
                let (k, moment) = self.at_angle(given, &law, stiffness, moment, *angle, sheet)?;
                let at = angle.value();
                let [energy, _, curvature] = numbers.potential(k, moment, at);
                let here = WorkedEquilibrium { at, energy, curvature, stability: Stability::Critical };
                let range = [at.min(0.0) - 0.5, at.max(0.0) + 0.5];
                self.show(&numbers, k, None, range, &[here], sheet);
            }
        }
        Ok(())
    }
}

/// The load about the pivot with a horizontal arm, where it is known.
fn load_moment<W: Worksheet>(load: &ArmLoadGiven<W>, sheet: W) -> Option<W::Num> {
    let words = "Moment of the load about the pivot with the arm horizontal";
    match load {
        ArmLoadGiven::Mass { mass, arm, gravity } => {
            let weight = sheet.step("W", "N", (*mass)? * *gravity, "Weight");
            Some(sheet.step("M", "N*m", weight * *arm, words))
        }
        ArmLoadGiven::Force { force, arm } => Some(sheet.step("M", "N*m", (*force)? * *arm, words)),
        ArmLoadGiven::Couple { couple } => *couple,
    }
}

/// The stiffness of the spring, where it is known, and how the spring is stretched.
fn spring<W: Worksheet>(spring: &ArmSpringGiven<W>, sheet: W) -> (Option<W::Num>, Geometry<W::Num>) {
    match spring {
        ArmSpringGiven::Torsion { stiffness, free } => (*stiffness, Geometry::Torsion { free: *free }),
        ArmSpringGiven::Drum { stiffness, radius, free } => {
            (*stiffness, Geometry::Drum { radius: *radius, free: *free })
        }
        ArmSpringGiven::Sides { stiffness, height } => (*stiffness, Geometry::Sides { height: *height }),
        ArmSpringGiven::Points { stiffness, on_arm, on_arm_angle, fixed, fixed_angle, unstretched } => {
            let between = sheet.step(
                "ψ₀",
                "deg",
                *on_arm_angle - *fixed_angle,
                "Angle at the pivot between the two ends of the spring at θ = 0; at θ it is θ + ψ₀",
            );
            let free = match unstretched {
                FreeConfigurationGiven::Length { length } => *length,
                FreeConfigurationGiven::Angle { angle } => sheet.step(
                    "s₀",
                    "mm",
                    law::length(*on_arm, *fixed, *angle + between),
                    "Unstretched length, by the law of cosines",
                ),
            };
            (*stiffness, Geometry::Points { on_arm: *on_arm, fixed: *fixed, between, free })
        }
    }
}

impl SpringLever {
    /// The one number that is left out, or the couple that holds the arm, at a given angle.
    fn at_angle<W: Worksheet>(
        &self,
        given: &SpringLeverGiven<W>,
        law: &PotentialLaw<W::Num>,
        stiffness: Option<W::Num>,
        moment: Option<W::Num>,
        angle: W::Num,
        sheet: W,
    ) -> Result<(f64, f64), Refusal> {
        let [energy, unit, second] = law.unit_spring(1, angle, sheet);
        if let Geometry::Sides { height } = law.geometry {
            let small = || height.powi(2) * angle * 2.0;
            sheet.common_error("u′", "the stretch and its arm taken as at small angles", small);
        }
        let unit = sheet.step(
            "u′",
            if matches!(law.geometry, Geometry::Torsion { .. }) { "rad" } else { "mm^2" },
            unit,
            "Extension of the spring times its virtual change per unit δθ: the couple of the spring is k u′",
        );
        let (down, drop) = law.height.slope(angle);
        let (mut held, mut hung) = (W::Num::from(0.0), None);
        let (k, moment) = match (stiffness, moment) {
            (None, None) => {
                return Err(Refusal::because(
                    "both load and stiffness are missing: the angle determines only one of them",
                ));
            }
            (Some(k), Some(moment)) => {
                let couple = sheet.step(
                    "T",
                    "N*m",
                    if down { k * unit - moment * drop } else { k * unit + moment * drop },
                    ("Equilibrant couple on the arm, in the sense of θ: T δθ plus the virtual work of spring and load is zero", RIUL.at("eq. 3")),
                );
                sheet.answer("holding_couple", "Equilibrant couple on the arm", couple);
                held = couple;
                (k, moment)
            }
            (Some(k), None) => {
                if drop.value().abs() < 1e-12 {
                    return Err(Refusal::because(
                        "at this angle the arm is vertical: the load does no work and cannot be determined",
                    ));
                }
                let spring = k * unit;
                let moment = if down { spring / drop } else { -spring / drop };
                let words = ("Load whose virtual work balances that of the spring", BEER.at("§10.1C"));
                let moment = match &given.load {
                    ArmLoadGiven::Mass { arm, gravity, .. } => {
                        let weight = sheet.step("W", "N", moment / *arm, words);
                        let mass = sheet.step("m", "kg", weight / *gravity, "Mass of that weight");
                        sheet.answer("mass", "Mass for equilibrium at this angle", mass);
                        hung = Some(mass.value() * gravity.value() * arm.value());
                        weight * *arm
                    }
                    ArmLoadGiven::Force { arm, .. } => {
                        let force = sheet.step("P", "N", moment / *arm, words);
                        sheet.answer("force", "Force for equilibrium at this angle", force);
                        force * *arm
                    }
                    ArmLoadGiven::Couple { .. } => {
                        let couple = sheet.step("M", "N*m", moment, words);
                        sheet.answer("couple", "Couple for equilibrium at this angle", couple);
                        couple
                    }
                };
                (k, moment)
            }
            (None, Some(moment)) => {
                if unit.value() == 0.0 {
                    return Err(Refusal::because(
                        "at this angle the spring is unstretched or its force passes through the pivot: the stiffness cannot be determined",
                    ));
                }
                let load = moment * drop;
                let k = if down { load / unit } else { -load / unit };
                let unit_of =
                    if matches!(law.geometry, Geometry::Torsion { .. }) { "N*m/rad" } else { "N/m" };
                let k = sheet.step(
                    "k",
                    unit_of,
                    k,
                    (
                        "Stiffness for which the virtual work of the spring equals that of the load",
                        BEER.at("§10.1C"),
                    ),
                );
                sheet.answer("stiffness", "Stiffness for equilibrium at this angle", k);
                if k.value() < 0.0 {
                    sheet.warn(|| {
                        "the stiffness is negative: at this angle load and spring turn the arm in the same sense".into()
                    });
                }
                (k, moment)
            }
        };
        let bend = sheet.step(
            "V″",
            "N*m/rad",
            law.with_load(k, moment, angle, [energy, unit, second])[2],
            (
                "Second derivative of the potential energy: positive at a stable equilibrium",
                BEER.at("§10.2D"),
            ),
        );
        sheet.answer("curvature", "Second derivative of the potential energy", bend);
        let (k, moment) = (k.value(), moment.value());
        sheet.verify(|| {
            let hung = hung.unwrap_or(moment);
            let (mechanism, drawn) = self.built(&law.value(), k, hung, angle.value());
            if let Some(table) = reactions(&mechanism, &drawn, &["Pivot".into()]) {
                sheet.show(|| table);
            }
            if let Some(effort) = solved(&mechanism, &drawn) {
                let size = moment.abs().max((k * unit.value()).abs());
                let by_them = W::Num::from(-effort.newton_euler[0]);
                sheet.check_sum("the holding couple from the Newton–Euler equations", held, by_them, size);
            }
            let size = law.value().size(k, moment, angle.value());
            check_curvature(sheet, bend, size, &(mechanism, drawn));
        });
        Ok((k, moment))
    }

    /// Answers the critical load and stiffness, if θ = 0 is an equilibrium under any load.
    fn critical<W: Worksheet>(
        &self,
        given: &SpringLeverGiven<W>,
        k: W::Num,
        moment: W::Num,
        law: &PotentialLaw<W::Num>,
        sheet: W,
    ) {
        let numbers = law.value();
        let [_, slope, bend] = numbers.plain_spring(0.0);
        if !matches!(law.height, Height::Upright) || slope != 0.0 || bend <= 0.0 {
            return;
        }
        let bend = match &law.geometry {
            Geometry::Points { on_arm, fixed, between, .. } => {
                let rate = law::rate(*on_arm, *fixed, *between, law::length(*on_arm, *fixed, *between));
                sheet.common_error("s′₀", "the spring taken as perpendicular to the arm", || *on_arm);
                sheet.step("s′₀", "mm", rate, "Derivative of the spring length at θ = 0").powi(2)
            }
            Geometry::Torsion { .. } => W::Num::from(1.0),
            Geometry::Drum { radius, .. } => radius.powi(2),
            Geometry::Sides { height } => height.powi(2) * 2.0,
        };
        let unit = if matches!(law.geometry, Geometry::Torsion { .. }) { "N*m/rad" } else { "N/m" };
        let words = (
            "Stiffness at which d²V/dθ² = 0 at θ = 0: a larger stiffness holds the arm vertical",
            BEER.at("§10.2D"),
        );
        let torsion = matches!(law.geometry, Geometry::Torsion { .. });
        let critical = sheet.step("k_c", unit, if torsion { moment } else { moment / bend }, words);
        sheet.answer(
            "critical_stiffness",
            "Critical stiffness of the vertical (inverted) position",
            critical,
        );
        let words = "Load at which d²V/dθ² = 0 at θ = 0: with a smaller load the vertical (inverted) position is stable";
        let held = if torsion { k } else { k * bend };
        // The load at which the restoring couple of the spring grows no faster than that of the load.
        let limit = |load: W::Num| {
            sheet.verify(|| {
                let [_, _, left] = numbers.potential(k.value(), load.value(), 0.0);
                let what = "the second derivative of the potential energy at θ = 0 with the critical load";
                sheet.check_zero(what, left.into(), load.value());
            });
        };
        match &given.load {
            ArmLoadGiven::Mass { arm, gravity, .. } => {
                let mass = sheet.step("m_c", "kg", held / (*gravity * *arm), words);
                sheet.answer("critical_mass", "Critical mass of the vertical (inverted) position", mass);
                limit(mass * *gravity * *arm);
            }
            ArmLoadGiven::Force { arm, .. } => {
                let force = sheet.step("P_c", "N", held / *arm, words);
                sheet.answer("critical_force", "Critical force of the vertical (inverted) position", force);
                limit(force * *arm);
            }
            ArmLoadGiven::Couple { .. } => {}
        }
        sheet.verify(|| {
            let [_, _, left] = numbers.potential(critical.value(), moment.value(), 0.0);
            sheet.check_zero(
                "the second derivative of the potential energy at θ = 0 with the critical stiffness",
                W::Num::from(left),
                moment.value(),
            );
        });
    }

    fn show<W: Worksheet>(
        &self,
        numbers: &PotentialLaw<f64>,
        k: f64,
        moment: Option<f64>,
        range: [f64; 2],
        list: &[WorkedEquilibrium],
        sheet: W,
    ) {
        let arm = match &self.load {
            ArmLoad::Mass { arm, .. } | ArmLoad::Force { arm, .. } => Some(*arm),
            ArmLoad::Couple { .. } => None,
        };
        sheet.show(|| Exhibit::Plot(picture::load_over_angle(numbers, k, arm, moment, range)));
        let at = illustrative_angle(list);
        sheet.show(|| self.animation(at, range));
    }
}
