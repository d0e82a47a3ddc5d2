//! Damping coefficient and damping ratio from each other.

use dalembert_core::Worksheet;
use dalembert_mechanics::{Real, sdof};

use super::form::Units;
use crate::sources::RAO;

pub(super) fn critical_damping<W: Worksheet>(
    stiffness: W::Num,
    mass: W::Num,
    units: Units,
    sheet: W,
) -> W::Num {
    let critical = sheet.step(
        "c_c",
        units.damping,
        sdof::critical_damping(stiffness, mass),
        ("Critical damping: the minimum damping for which the motion does not oscillate", RAO.at("§2.6")),
    );
    sheet.answer("critical_damping", "Critical damping", critical);
    critical
}

pub(super) fn ratio_of<W: Worksheet>(
    coefficient: W::Num,
    critical: W::Num,
    stiffness: W::Num,
    mass: W::Num,
    sheet: W,
) -> W::Num {
    let zeta = sheet.step(
        "ζ",
        "1",
        coefficient / critical,
        ("Damping ratio: damping over critical damping", RAO.at("§2.6")),
    );
    sheet.check(
        "the square of the damping is 4 ζ² k m",
        coefficient.powi(2),
        stiffness * mass * zeta.powi(2) * 4.0,
    );
    zeta
}

pub(super) fn coefficient_of<W: Worksheet>(zeta: W::Num, critical: W::Num, units: Units, sheet: W) {
    let symbol = if units == Units::ROTATION { "cₜ" } else { "c" };
    let damping = sheet.step(symbol, units.damping, zeta * critical, ("Damping coefficient", RAO.at("§2.6")));
    sheet.answer("damping", "Damping coefficient", damping);
}
