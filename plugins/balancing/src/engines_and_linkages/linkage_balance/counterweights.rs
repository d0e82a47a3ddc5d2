//! Mass, angle and mass–radius product of a counterweight.

use dalembert_core::Worksheet;
use dalembert_mechanics::{
    Real,
    balance::{self, linkage::Counterweight},
};

use crate::shared::rotor;

/// Names of a counterweight: symbols and answers.
pub(super) struct Names {
    symbols: [&'static str; 3],
    size: (&'static str, &'static str),
    angle: (&'static str, &'static str),
    mass: (&'static str, &'static str),
}

pub(super) const CRANK: Names = Names {
    symbols: ["U_2", "ψ_2", "M_2"],
    size: ("crank_unbalance", "Mass–radius product of the counterweight of the crank"),
    angle: ("crank_angle", "Angle of the counterweight from the crank"),
    mass: ("crank_mass", "Mass of the counterweight of the crank"),
};

pub(super) const ROCKER: Names = Names {
    symbols: ["U_4", "ψ_4", "M_4"],
    size: ("rocker_unbalance", "Mass–radius product of the counterweight of the rocker"),
    angle: ("rocker_angle", "Angle of the counterweight from the rocker"),
    mass: ("rocker_mass", "Mass of the counterweight of the rocker"),
};

pub(super) const ROD: Names = Names {
    symbols: ["U_3", "ψ_3", "M_3"],
    size: ("rod_unbalance", "Mass–radius product of the counterweight of the rod"),
    angle: ("rod_angle", "Angle of the counterweight from the rod"),
    mass: ("rod_mass", "Mass of the counterweight of the rod"),
};

pub(super) fn counterweight<W: Worksheet>(
    sheet: W,
    link: usize,
    (x, y): (W::Num, W::Num),
    radius: W::Num,
    names: &Names,
) -> Counterweight {
    let [size_symbol, angle_symbol, mass_symbol] = names.symbols;
    let size =
        sheet.step(size_symbol, "kg*mm", balance::magnitude(x, y), "Counterweight mass–radius product");
    sheet.answer(names.size.0, names.size.1, size);
    let mut angle = 0.0;
    if size.value() > 0.0 {
        let why = "Angle of the counterweight on its link";
        let what = "the counterweight placed in the direction of the unbalance itself";
        sheet.common_error(angle_symbol, what, || balance::marked_direction(-x, -y));
        rotor::quadrant_ignored(sheet, angle_symbol, (x, y));
        let turned = sheet.step(angle_symbol, "deg", balance::marked_direction(x, y), why);
        sheet.answer(names.angle.0, names.angle.1, turned);
        angle = turned.value();
    }
    let mass = sheet.step(mass_symbol, "kg", size / radius, "Mass at the given radius");
    sheet.answer(names.mass.0, names.mass.1, mass);
    Counterweight { link, mass: mass.value(), distance: radius.value(), angle }
}
