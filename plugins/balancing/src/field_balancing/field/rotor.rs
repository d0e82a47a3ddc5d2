//! The rotor, what is demanded of it, and the trial weight to begin with.

use dalembert_core::{Inputs, MeasuredQuantity, Worksheet};
use dalembert_mechanics::balance;

use crate::shared::tolerance;

/// The rotor and the requirement.
#[derive(Clone, Debug, Inputs)]
pub struct Rotor {
    /// Mass of the rotor.
    #[input("m_R", "kg", positive)]
    pub mass: f64,
    /// Service speed.
    #[input("Ω", "rpm", positive)]
    pub speed: f64,
    /// Number of correction planes.
    /// The weight and the permissible unbalance are divided evenly among them.
    #[input(min = 1, max = 20)]
    pub planes: usize,
    /// Requirement.
    pub requirement: Requirement,
    /// Force of the trial weight over the weight that its plane carries.
    #[input("q", "%", positive, default = "10 %")]
    pub trial_share: f64,
    /// Gravity.
    /// Reference weight for the force of the trial weight.
    #[input("g", "m/s^2", positive, default = "9.81 m/s^2")]
    pub gravity: f64,
}

/// A demand on the balance of a rotor in its bearings.
#[derive(Clone, Debug, Inputs)]
pub enum Requirement {
    /// Balance quality grade
    /// ISO 21940-11, for the residual unbalance by the influence coefficients.
    Grade {
        /// Grade.
        /// Speed of the centre of mass: G 6.3 is 6.3 mm/s.
        #[input("G", "mm/s", positive, grade, default = "6.3 mm/s")]
        grade: f64,
    },
    /// Vibration limit
    /// Component at the speed of rotation, measured as the readings.
    Vibration {
        /// Limit.
        #[input("A_l", "um | mm/s | m/s^2 | 1", positive, kind = "Amplitude|Velocity|Acceleration|Ratio")]
        limit: MeasuredQuantity,
    },
}

/// The demands as numbers of a worksheet.
pub(super) enum Demand<N> {
    /// The residual unbalance of a plane is limited; what it was found from: grade, mass, speed.
    Unbalance { permissible: N, from: [N; 3] },
    /// Every reading is limited.
    Vibration { limit: N },
}

/// Writes what is demanded, and the trial weight to begin with.
pub(super) fn demand<W: Worksheet>(
    rotor: &Rotor,
    given: &RotorGiven<W>,
    radius: Option<W::Num>,
    sheet: W,
) -> Demand<W::Num> {
    let planes = rotor.planes as f64;
    let demand = match &given.requirement {
        RequirementGiven::Grade { grade } => {
            let (total, _) = tolerance::by_grade(*grade, given.mass, given.speed, sheet);
            let why = "The permissible unbalance, divided evenly among the planes";
            let permissible = sheet.step("U_p", "g*mm", total / planes, why);
            sheet.answer("permissible", "Permissible residual unbalance of a plane", permissible);
            let force = balance::centrifugal_force(permissible, given.speed);
            let what = "force of the permissible unbalance from mass, grade and speed";
            sheet.check(what, force, given.mass * *grade * given.speed / planes);
            Demand::Unbalance { permissible, from: [*grade, given.mass, given.speed] }
        }
        RequirementGiven::Vibration { limit } => Demand::Vibration { limit: *limit },
    };
    let load = (given.mass, given.gravity, given.speed);
    let unbalance = tolerance::trial_unbalance(given.trial_share, load, rotor.planes, sheet);
    sheet.answer("trial_unbalance", "Trial unbalance of a plane", unbalance);
    let force = balance::centrifugal_force(unbalance, given.speed);
    let carried = given.mass * given.gravity / planes;
    sheet.check("force of the trial weight over the weight carried", force / carried, given.trial_share);
    if let Some(radius) = radius {
        let mass = sheet.step("m_t", "g", unbalance / radius, "Trial weight at its radius");
        sheet.answer("trial_mass", "Trial mass by its force", mass);
        let force = balance::centrifugal_force(mass * radius, given.speed);
        sheet.check("force of the trial mass at its radius", force, carried * given.trial_share);
    }
    if let (Some(radius), Demand::Unbalance { permissible, from: [grade, mass, speed] }) = (radius, &demand) {
        let clear = tolerance::clear_trial_mass(*permissible, radius, sheet);
        sheet.answer("clear_trial_mass", "Trial mass by the tolerance", clear);
        let by_grade = *grade * *mass * 5.0 / planes;
        sheet.check("trial mass, radius and speed from the grade", clear * radius * *speed, by_grade);
    }
    demand
}
