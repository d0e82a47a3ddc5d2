//! Corrections in one plane, two, or more.

use dalembert_core::{Refusal, Text, Worksheet};
use dalembert_mechanics::{Real, balance};

use super::{CorrectionPlane, CorrectionPlaneGiven, Unbalance, by_pairs};
use crate::{
    shared::rotor::{self, CorrectionGiven, CorrectionMethod, Keys, Symbols},
    sources::RIUL,
};

/// A correction as found.
pub(super) struct Corrected<N> {
    pub unbalance: Unbalance<N>,
    pub mass_and_radius: Option<(f64, f64)>,
}

const SYMBOLS: Symbols =
    Symbols { size: "U_P", mass: "m_P", radius: "r_P", angle: "θ_P", other_angle: "θ′_P", weight: "W_P" };

const KEYS: Keys = Keys {
    size: ("correction", "Unbalance of the correction in plane"),
    mass: ("correction_mass", "Mass of the correction in plane"),
    radius: ("correction_radius", "Radius of the correction in plane"),
    angle: ("correction_angle", "Angle of the correction in plane"),
    other_angle: ("correction_other_angle", "Angle in the opposite sense of the correction in plane"),
    weight: ("correction_weight", "Weight of the correction in plane"),
};

const COINCIDENT: &str = "the correction planes are all at one position, so no corrections there can balance a couple; give them \
     different positions, or give one plane only";

pub(super) fn find<W: Worksheet>(
    masses: &[Unbalance<W::Num>],
    planes: &[CorrectionPlane],
    known: &[CorrectionPlaneGiven<W>],
    way: CorrectionMethod,
    gravity: W::Num,
    sheet: W,
) -> Result<Vec<Corrected<W::Num>>, Refusal> {
    let places: Vec<f64> = planes.iter().map(|plane| plane.position).collect();
    let spread = |of: &mut dyn Iterator<Item = f64>| {
        let (low, high) = of.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), z| (a.min(z), b.max(z)));
        high - low
    };
    let all = spread(&mut places.iter().copied().chain(masses.iter().map(|m| m.z.value())));
    if places.len() > 1 && spread(&mut places.iter().copied()) <= 1e-12 * all {
        return Err(Refusal::because(COINCIDENT));
    }
    let x: Vec<_> = masses.iter().map(|m| (m.x, m.z)).collect();
    let y: Vec<_> = masses.iter().map(|m| (m.y, m.z)).collect();
    let at: Vec<W::Num> = known.iter().map(|plane| plane.position).collect();
    let [x, y] = match at[..] {
        [_] => [(x, "U_Px"), (y, "U_Py")].map(|(masses, symbol)| {
            let sum = balance::single_plane_correction(masses.into_iter().map(|(u, _)| u));
            let why = ("The sum including the correction is zero", RIUL.at("eqs. 9–11"));
            vec![sheet.step((symbol, 1), "kg*mm", sum, why)]
        }),
        [a, b] => [(x, "U_Px"), (y, "U_Py")].map(|(masses, symbol)| {
            let why = ("Moments about plane 1 vanish", RIUL.at("eqs. 13–15"));
            let in_b = balance::correction_in_b(masses.iter().copied(), a, b);
            let in_b = sheet.step((symbol, 2), "kg*mm", in_b, why);
            let in_a = balance::correction_in_a(masses.iter().map(|(u, _)| *u), in_b);
            let in_a = sheet.step((symbol, 1), "kg*mm", in_a, ("Forces vanish", RIUL.at("eqs. 12, 20")));
            vec![in_a, in_b]
        }),
        _ => least(&at, [(x, ["U_Px", "ΣU_x", "M_x"]), (y, ["U_Py", "ΣU_y", "M_y"])], sheet),
    };
    let corrected: Vec<Corrected<W::Num>> = (x.into_iter().zip(y).zip(known).enumerate())
        .map(|(k, ((x, y), plane))| {
            let scale = masses.iter().map(Unbalance::size).sum();
            other_rules(masses, &at, k, (way, scale), sheet);
            rotor::correct(sheet, k + 1, &SYMBOLS, &KEYS, (x, y), &plane.correction, way, gravity, scale);
            let size = x.value().hypot(y.value());
            Corrected {
                unbalance: Unbalance { x, y, z: plane.position, placed: true },
                mass_and_radius: match plane.correction {
                    CorrectionGiven::Radius { radius } => Some((size / radius.value(), radius.value())),
                    CorrectionGiven::Mass { mass } => Some((mass.value(), size / mass.value())),
                    CorrectionGiven::Product {} => None,
                },
            }
        })
        .collect();
    left_over(masses, &corrected, sheet);
    let largest = masses.iter().map(Unbalance::size).fold(0.0, f64::max);
    let reach = corrected.iter().map(|c| c.unbalance.size()).fold(0.0, f64::max);
    if reach > 10.0 * largest {
        sheet.warn(|| {
            Text::new(
                "the planes are so close together that a correction is {times} times the largest unbalance",
            )
            .with("times", format!("{:.0}", reach / largest))
        });
    }
    Ok(corrected)
}

/// Declares the rules by which people find another correction in plane `k`, counted from 0, of one plane or of two.
fn other_rules<W: Worksheet>(
    masses: &[Unbalance<W::Num>],
    at: &[W::Num],
    k: usize,
    found: (CorrectionMethod, f64),
    sheet: W,
) {
    let (size, angle) = ((SYMBOLS.size, k + 1), (SYMBOLS.angle, k + 1));
    let declare = |what: &'static str, part: &dyn Fn(W::Num, W::Num) -> W::Num| {
        let along =
            |of: fn(&Unbalance<W::Num>) -> W::Num| -W::Num::sum(masses.iter().map(|m| part(of(m), m.z)));
        rotor::by_another_rule(sheet, (size, angle), found, what, || (along(|m| m.x), along(|m| m.y)));
    };
    let sizes = || masses.iter().map(|m| balance::magnitude(m.x, m.y));
    match *at {
        [_] => sheet.common_error(size, rotor::AS_NUMBERS, || W::Num::sum(sizes())),
        [a, b] => {
            declare(rotor::HALF_EACH, &|u, _| u / 2.0);
            if k == 0 {
                declare(rotor::WITHOUT_THE_OTHER, &|u, _| u);
                return;
            }
            declare(rotor::ABOUT_THE_ORIGIN, &|u, z| u * z / (b - a));
            sheet.common_error(size, rotor::MOMENTS_AS_NUMBERS, || {
                let arms = masses.iter().map(|m| (m.z - a).abs());
                W::Num::sum(sizes().zip(arms).map(|(u, arm)| u * arm)) / (b - a).abs()
            });
        }
        _ => {
            let what = "an equal share of the resultant balanced in each plane, the moments ignored";
            declare(what, &|u, _| u / at.len() as f64);
        }
    }
}

/// The corrections with the least sum of squares, direction by direction.
fn least<W: Worksheet>(
    at: &[W::Num],
    directions: [(Vec<(W::Num, W::Num)>, [&'static str; 3]); 2],
    sheet: W,
) -> [Vec<W::Num>; 2] {
    let count = at.len() as f64;
    let mean = W::Num::sum(at.iter().copied()) / count;
    let mean = sheet.step("z̄", "mm", mean, "Mean position of the correction planes");
    let spread = W::Num::sum(at.iter().map(|z| (*z - mean).powi(2)));
    let spread = sheet.step("S", "mm^2", spread, "Sum of squares of their distances from it");
    directions.map(|(masses, [symbol, force, moment])| {
        let sum = balance::resultant(masses.iter().map(|(u, _)| *u));
        let sum = sheet.step(force, "kg*mm", sum, "Resultant of the masses");
        let why = "Moment of the masses about the mean position of the planes";
        let moment = sheet.step(moment, "kg*mm^2", balance::moment(masses, mean), why);
        let each = (1..).zip(at).map(|(k, z)| {
            let formula = balance::least_correction(sum, moment, count, *z - mean, spread);
            let why = "Each plane takes an equal share of the force and a share of the couple proportional to its distance: least sum of squares";
            sheet.step((symbol, k), "kg*mm", formula, why)
        });
        each.collect()
    })
}

/// Residual force and couple, and the corrections from both equations at once.
fn left_over<W: Worksheet>(masses: &[Unbalance<W::Num>], corrected: &[Corrected<W::Num>], sheet: W) {
    let added = || corrected.iter().map(|c| &c.unbalance);
    let everything = || masses.iter().chain(added());
    if let [plane] = corrected {
        let moment = |of: fn(&Unbalance<W::Num>) -> W::Num| {
            balance::moment(masses.iter().map(|m| (of(m), m.z)), plane.unbalance.z)
        };
        let couple = balance::magnitude(moment(|m| m.x), moment(|m| m.y));
        let why = "Moment of the masses about the plane: a couple that one plane cannot balance";
        let couple = sheet.step("M_c", "kg*mm^2", couple, why);
        sheet.answer("couple_left", "Residual moment of unbalance", couple);
        sheet.verify(|| {
            let (squared, scale) = by_pairs(masses, &|u| (u.z - plane.unbalance.z).value());
            let what = "square of the residual moment by the law of cosines over all pairs";
            sheet.check_sum(what, couple.powi(2), squared.into(), scale);
        });
        let scale: f64 =
            masses.iter().map(|m| m.size() * (m.z.value() - plane.unbalance.z.value()).abs()).sum();
        if couple.value() > 1e-12 * scale {
            sheet.warn(|| Text::new("one plane balances the force only; a rotating couple remains"));
        }
    }
    sheet.verify(|| {
        let force: f64 = everything().map(Unbalance::size).sum();
        let origin = corrected[0].unbalance.z.value();
        let reach = everything().map(|u| (u.z.value() - origin).abs()).fold(0.0, f64::max);
        for of in [(|u| u.x) as fn(&Unbalance<W::Num>) -> W::Num, |u| u.y] {
            sheet.check_zero("no force is left", balance::resultant(everything().map(of)), force);
            if corrected.len() < 2 {
                continue;
            }
            let left: f64 = everything().map(|u| of(u).value() * (u.z.value() - origin)).sum();
            sheet.check_zero("no couple is left", left.into(), force * reach);
        }
        if corrected.len() < 2 {
            return;
        }
        let rotor: Vec<_> = masses.iter().map(Unbalance::plain).collect();
        let planes: Vec<f64> = added().map(|u| u.z.value()).collect();
        let Ok(again) = balance::balance_planes(&rotor, &planes) else { return };
        for (u, again) in added().zip(again) {
            for (ours, again) in u.plain().components.into_iter().zip(again) {
                let difference = ours - again;
                sheet.check_zero("the correction from both equations at once", difference.into(), force);
            }
        }
    });
}
