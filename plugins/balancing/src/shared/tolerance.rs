//! Permissible residual unbalance of a grade, and the trial weight for a rotor.

use dalembert_core::Worksheet;
use dalembert_mechanics::Real;

use crate::sources::{BRUEL_KJAER, ISO_TOLERANCES, WOWK};

/// The permissible unbalance of a rotor by a balance quality grade, and over the mass.
pub(crate) fn by_grade<W: Worksheet>(
    grade: W::Num,
    mass: W::Num,
    speed: W::Num,
    sheet: W,
) -> (W::Num, W::Num) {
    let why = ("The centre of mass moves at the speed of the grade", ISO_TOLERANCES.at(""));
    let displacement = sheet.step("e_per", "µm", grade / speed, why);
    (whole(displacement, mass, sheet), displacement)
}

/// The permissible unbalance of a rotor by its specific unbalance.
pub(crate) fn whole<W: Worksheet>(displacement: W::Num, mass: W::Num, sheet: W) -> W::Num {
    sheet.step("U_per", "g*mm", displacement * mass, ("Specific unbalance times mass", ISO_TOLERANCES.at("")))
}

/// The unbalance whose force is a share of the weight that one of so many planes carries.
pub(crate) fn trial_unbalance<W: Worksheet>(
    share: W::Num,
    (mass, gravity, speed): (W::Num, W::Num, W::Num),
    planes: usize,
    sheet: W,
) -> W::Num {
    let unbalance = share * mass * gravity * (1.0 / planes as f64) / speed.powi(2);
    let why = match planes {
        1 => "Its force is that share of the weight",
        2 => "Its force is that share of half the weight",
        _ => "Its force is that share of the weight that a plane carries",
    };
    sheet.step("U_t", "g*mm", unbalance, (why, WOWK.at("")))
}

/// The trial mass that shows clearly: five times the permissible unbalance of its plane, at a radius.
pub(crate) fn clear_trial_mass<W: Worksheet>(permissible: W::Num, radius: W::Num, sheet: W) -> W::Num {
    let why = (
        "Five to ten times the permissible unbalance of the plane shows clearly; five is taken",
        BRUEL_KJAER.at(""),
    );
    sheet.step("m_5", "g", permissible * 5.0 / radius, why)
}
