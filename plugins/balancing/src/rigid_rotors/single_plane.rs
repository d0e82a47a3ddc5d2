//! Eccentric masses in one plane, and the mass that balances them.

use dalembert_core::{About, Analysis, Exhibit, Ink, Inputs, Refusal, Text, Worksheet, register};
use dalembert_mechanics::{Real, balance};

use crate::{
    shared::{
        rotor::letter,
        rotor::{self, Angles, Correction, CorrectionGiven, CorrectionMethod, Keys, Symbols},
        views::{self, ListedUnbalance},
    },
    sources::{MABIE, NORTON, RIUL},
};

/// The eccentric masses of a disc, and what balances them.
#[derive(Clone, Debug, Inputs)]
pub struct SinglePlane {
    /// Eccentric masses.
    #[input(min = 1)]
    pub masses: Vec<PlaneMass>,
    /// Angle convention.
    pub angles: Angles,
    /// Correction.
    pub correction: Correction,
    /// Correction method.
    pub way: CorrectionMethod,
    /// Gravity.
    /// Only turns masses into weights; the balance does not depend on it.
    #[input("g", "m/s^2", positive, default = "9.81 m/s^2")]
    pub gravity: f64,
    /// Speed.
    /// For the rotating force before balancing.
    #[input("ω", "rpm", positive)]
    pub speed: Option<f64>,
}

/// A mass of a disc that is not on the axis.
#[derive(Clone, Debug, Inputs)]
pub struct PlaneMass {
    /// Quantity given.
    pub amount: MassOrWeight,
    /// Radius.
    #[input("r", "mm", nonnegative)]
    pub radius: f64,
    /// Angle.
    /// The answers use the same sense.
    #[input("θ", "deg")]
    pub angle: f64,
}

/// A mass, or its weight.
#[derive(Clone, Debug, Inputs)]
pub enum MassOrWeight {
    /// Mass
    Mass {
        /// Mass.
        #[input("m", "kg", positive)]
        mass: f64,
    },
    /// Weight
    Weight {
        /// Weight.
        #[input("W", "N", positive)]
        weight: f64,
    },
}

register!(SinglePlane);

const SYMBOLS: Symbols =
    Symbols { size: "U_c", mass: "m_c", radius: "r_c", angle: "θ_c", other_angle: "θ′_c", weight: "W_c" };

const KEYS: Keys = Keys {
    size: ("unbalance", "Unbalance of the correction"),
    mass: ("mass", "Mass of the correction"),
    radius: ("radius", "Radius of the correction"),
    angle: ("angle", "Angle of the correction"),
    other_angle: ("other_angle", "Angle of the correction in the opposite sense"),
    weight: ("weight", "Weight of the correction"),
};

impl Analysis for SinglePlane {
    const ABOUT: About = About {
        id: "balancing/single-plane",
        title: "Balancing in one plane",
        topic: "Rigid rotors",
        summary: "The mass, or the hole, that balances eccentric masses of a disc: static balancing.",
        main: &["unbalance"],
        keywords: "balanceamento estático um plano disco massa de correção furação static balancing disc counterweight drilling eq. 6 11",
        sources: &[&RIUL, &NORTON, &MABIE],
        cases: include_str!("../../cases/single_plane.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &SinglePlaneGiven<W>, sheet: W) -> Result<(), Refusal> {
        let products: Vec<f64> = self.masses.iter().map(|m| m.amount.mass(self.gravity) * m.radius).collect();
        let scale = products.iter().sum::<f64>();
        if scale == 0.0 {
            return Err(Refusal::because(
                "every mass is on the axis, so there is no unbalance; give at least one of them a radius",
            ));
        }
        let mut before: Option<W::Num> = None;
        let mut unbalances = Vec::new();
        for (n, m) in (1..).zip(&given.masses) {
            let mass = match m.amount {
                MassOrWeightGiven::Mass { mass } => mass,
                MassOrWeightGiven::Weight { weight } => {
                    sheet.step(("m", n), "kg", weight / given.gravity, "Mass of the weight")
                }
            };
            let angle = match (self.angles, before) {
                (Angles::Successive, Some(before)) => {
                    sheet.step(("φ", n), "deg", before + m.angle, "Angle from the mark")
                }
                _ => m.angle,
            };
            before = Some(angle);
            unbalances.push((n, mass, m.radius, angle));
        }
        let along = |component: fn(W::Num, W::Num, W::Num) -> W::Num, symbol, why: &'static str| {
            let each = unbalances.iter();
            let each =
                each.map(|&(n, m, r, angle)| sheet.step((symbol, n), "kg*mm", component(m, r, angle), why));
            each.collect::<Vec<W::Num>>()
        };
        let x = along(balance::component_x, "U_x", "Unbalance of each mass along x");
        let y = along(balance::component_y, "U_y", "Unbalance of each mass along y");
        let why = ("The sum including the correction is zero", RIUL.at("eqs. 9–11"));
        let in_x = sheet.step("U_cx", "kg*mm", balance::single_plane_correction(x.iter().copied()), why);
        let in_y = sheet.step("U_cy", "kg*mm", balance::single_plane_correction(y.iter().copied()), why);
        let correction = (in_x, in_y);
        let as_numbers = || W::Num::sum(unbalances.iter().map(|&(_, mass, radius, _)| mass * radius));
        sheet.common_error((SYMBOLS.size, 0), rotor::AS_NUMBERS, as_numbers);
        if let CorrectionGiven::Radius { .. } = given.correction {
            let what = "the masses themselves added as vectors, their radii ignored";
            sheet.common_error((SYMBOLS.mass, 0), what, || {
                let sum = |of: fn(W::Num) -> W::Num| {
                    W::Num::sum(unbalances.iter().map(|&(_, mass, _, angle)| mass * of(angle)))
                };
                balance::magnitude(sum(W::Num::cos), sum(W::Num::sin))
            });
        }
        rotor::correct(
            sheet,
            0,
            &SYMBOLS,
            &KEYS,
            correction,
            &given.correction,
            self.way,
            given.gravity,
            scale,
        );
        let size = balance::magnitude(in_x, in_y);
        if size.value() <= 1e-12 * scale {
            sheet.warn(|| Text::new("the masses balance each other; no correction is needed"));
        }
        let force = given.speed.map(|speed| {
            let why = ("Rotating force before balancing", RIUL.at("eq. 7"));
            sheet.common_error("F", rotor::AS_NUMBERS, || balance::centrifugal_force(as_numbers(), speed));
            let force = sheet.step("F", "N", balance::centrifugal_force(size, speed), why);
            sheet.answer("force_before", "Rotating force before balancing", force);
            (force.value(), speed.value())
        });
        let angles: Vec<f64> = unbalances.iter().map(|(_, _, _, angle)| angle.value()).collect();
        sheet.verify(|| {
            // The law of cosines over all pairs knows nothing of the axes x and y.
            let mut squared = 0.0;
            for (u, a) in products.iter().zip(&angles) {
                squared += products.iter().zip(&angles).map(|(v, b)| u * v * (a - b).cos()).sum::<f64>();
            }
            sheet.check_zero(
                "the magnitude by the law of cosines over all pairs",
                (size.value().powi(2) - squared).into(),
                scale * scale,
            );
            if let Some((force, speed)) = force {
                let scale = scale * speed.powi(2);
                sheet.check_zero(
                    "the rotating force by the law of cosines over all pairs of forces",
                    (force.powi(2) - squared * speed.powi(4)).into(),
                    scale * scale,
                );
            }
            let left = |axis: fn(f64) -> f64, correction: f64| {
                let masses = products.iter().zip(&angles).map(|(u, a)| u * axis(*a)).sum::<f64>();
                W::Num::from(masses + correction)
            };
            sheet.check_zero("no force is left along x", left(f64::cos, in_x.value()), scale);
            sheet.check_zero("no force is left along y", left(f64::sin, in_y.value()), scale);
        });
        let shown = || self.shown(&angles, (in_x.value(), in_y.value()), &given.correction);
        sheet.show(|| Exhibit::Table(views::table(&shown(), false)));
        sheet.show(|| Exhibit::Drawing(views::polar(&shown(), self.speed.map(|_| "ω"))));
        sheet.show(|| Exhibit::Drawing(views::force_polygon(&shown())));
        Ok(())
    }
}

impl SinglePlane {
    fn shown<W: Worksheet>(
        &self,
        angles: &[f64],
        (x, y): (f64, f64),
        correction: &CorrectionGiven<W>,
    ) -> Vec<ListedUnbalance> {
        let masses = self.masses.iter().zip(angles).zip(1..).map(|((m, angle), n)| {
            let mass = m.amount.mass(self.gravity);
            ListedUnbalance {
                name: Text::new("mass {n}").with("n", n),
                label: letter("m", n),
                polar: format!("{} {} ∠ {}", letter(m.amount.symbol(), n), letter("r", n), letter("θ", n)),
                place: String::new(),
                mass_and_radius: Some((mass, m.radius)),
                unbalance: (mass * m.radius * angle.cos(), mass * m.radius * angle.sin()),
                position: 0.0,
                ink: Ink::Force,
            }
        });
        let size = x.hypot(y);
        let correction = ListedUnbalance {
            name: "Correction".into(),
            label: "c".into(),
            polar: match correction {
                CorrectionGiven::Product {} => "c".into(),
                CorrectionGiven::Radius { .. } | CorrectionGiven::Mass { .. } => "m_c r_c".into(),
            },
            place: String::new(),
            mass_and_radius: match correction {
                CorrectionGiven::Radius { radius } => Some((size / radius.value(), radius.value())),
                CorrectionGiven::Mass { mass } => Some((mass.value(), size / mass.value())),
                CorrectionGiven::Product {} => None,
            },
            unbalance: (x, y),
            position: 0.0,
            ink: Ink::Result,
        };
        masses.chain([correction]).collect()
    }
}

impl MassOrWeight {
    fn symbol(&self) -> &'static str {
        match self {
            MassOrWeight::Mass { .. } => "m",
            MassOrWeight::Weight { .. } => "W",
        }
    }

    fn mass(&self, gravity: f64) -> f64 {
        match self {
            MassOrWeight::Mass { mass } => *mass,
            MassOrWeight::Weight { weight } => weight / gravity,
        }
    }
}
