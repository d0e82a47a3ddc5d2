//! The unbalance of a rotor as it is, and the forces on its bearings.

use dalembert_core::{Cell, Column, Refusal, TableExhibit, Text, Worksheet};
use dalembert_mechanics::{
    Real,
    balance::{self, PlaneUnbalance, UnbalanceKind},
};

use super::{
    BearingPositions, BearingPositionsGiven, EquivalentPlanes, EquivalentPlanesGiven, Unbalance, by_pairs,
    corrections::Corrected,
};
use crate::{
    shared::rotor,
    sources::{ISO_TERMS, RIUL},
};

/// A component of all unbalances with their positions.
fn along<'u, N: Real + 'u>(
    all: impl IntoIterator<Item = &'u Unbalance<N>>,
    of: fn(&Unbalance<N>) -> N,
) -> Vec<(N, N)> {
    all.into_iter().map(|u| (of(u), u.z)).collect()
}

/// Resultant of the masses and their moment, about the origin where there is no better point.
pub(super) fn of_the_masses<W: Worksheet>(masses: &[Unbalance<W::Num>], reference: Option<W::Num>, sheet: W) {
    let [x, y] = [along(masses, |u| u.x), along(masses, |u| u.y)];
    let sum = |of: &[(W::Num, W::Num)]| balance::resultant(of.iter().map(|(u, _)| *u));
    let why = ("Resultant unbalance of the masses", RIUL.at("eq. 12"));
    let sizes = || masses.iter().map(|m| balance::magnitude(m.x, m.y));
    sheet.common_error("U_R", rotor::AS_NUMBERS, || W::Num::sum(sizes()));
    let resultant = sheet.step("U_R", "kg*mm", balance::magnitude(sum(&x), sum(&y)), why);
    let why = ("Moment of the masses", RIUL.at("eq. 13"));
    let moment = |of: &[(W::Num, W::Num)]| match reference {
        Some(reference) => balance::moment(of.iter().copied(), reference),
        None => W::Num::sum(of.iter().map(|(u, z)| *u * *z)),
    };
    sheet.common_error("M_R", rotor::MOMENTS_AS_NUMBERS, || moments_as_numbers(masses, reference));
    let moment = sheet.step("M_R", "kg*mm^2", balance::magnitude(moment(&x), moment(&y)), why);
    sheet.verify(|| {
        let (squared, scale) = by_pairs(masses, &|_| 1.0);
        let difference = resultant.value().powi(2) - squared;
        sheet.check_zero("the resultant by the law of cosines over all pairs", difference.into(), scale);
        let (squared, scale) = by_pairs(masses, &|u| u.z.value() - reference.map_or(0.0, Real::value));
        let difference = moment.value().powi(2) - squared;
        sheet.check_zero("the moment by the law of cosines over all pairs", difference.into(), scale);
    });
    sheet.answer("resultant", "Resultant unbalance of the masses", resultant);
    sheet.answer("moment", "Moment of unbalance of the masses", moment);
}

/// Forces on the bearings of the masses alone and with the corrections.
pub(super) fn bearing_forces<W: Worksheet>(
    masses: &[Unbalance<W::Num>],
    corrections: Option<&[Corrected<W::Num>]>,
    known: &BearingPositions,
    bearings: &BearingPositionsGiven<W>,
    gravity: W::Num,
    reference: W::Num,
    sheet: W,
) {
    let speed = bearings.speed;
    let moment = |of| balance::moment(along(masses, of), reference);
    let couple = balance::centrifugal_force(balance::magnitude(moment(|u| u.x), moment(|u| u.y)), speed);
    sheet.common_error("C", rotor::MOMENTS_AS_NUMBERS, || {
        balance::centrifugal_force(moments_as_numbers(masses, Some(reference)), speed)
    });
    let other_point = |what: &'static str, point: W::Num| {
        sheet.common_error("C", what, || {
            let moment = |of| balance::moment(along(masses, of), point);
            balance::centrifugal_force(balance::magnitude(moment(|u| u.x), moment(|u| u.y)), speed)
        });
    };
    other_point("the moments taken about the first bearing", bearings.first);
    other_point(rotor::ABOUT_THE_ORIGIN, W::Num::from(0.0));
    let couple = sheet.step("C", "N*m", couple, ("Rotating couple of the masses", RIUL.at("eq. 13")));
    sheet.answer("couple", "Rotating couple of the masses", couple);
    sheet.verify(|| {
        let (squared, scale) = by_pairs(masses, &|u| u.z.value() - reference.value());
        let spun = speed.value().powi(4);
        let what = "square of the couple by the law of cosines over all pairs";
        sheet.check_sum(what, couple.powi(2), (squared * spun).into(), scale * spun);
    });
    let mut all: Vec<&Unbalance<W::Num>> = masses.iter().collect();
    let mut last = forces(&all, bearings, &BEFORE, sheet);
    if let Some(corrections) = corrections {
        all.extend(corrections.iter().map(|c| &c.unbalance));
        last = forces(&all, bearings, &AFTER, sheet);
    }
    let Some(rotor) = &bearings.rotor else { return };
    let weight = sheet.step("W_G", "N", rotor.mass * gravity, "Weight of the rotor");
    let span = bearings.second - bearings.first;
    let [on_first, on_second] = [
        ("P_I", weight * (bearings.second - rotor.centre) / span, "The weight's share on the first bearing"),
        ("P_J", weight * (rotor.centre - bearings.first) / span, "The weight's share on the second bearing"),
    ]
    .map(|(symbol, share, why)| sheet.step(symbol, "N", share, why));
    let largest = |symbol, share: W::Num, force: W::Num| {
        let why = "The force turns: at its worst it adds to the load of the weight";
        sheet.common_error(symbol, "the weight and the rotating force combined at right angles", || {
            (share.powi(2) + force.powi(2)).sqrt()
        });
        sheet.step(symbol, "N", share.abs() + force, why)
    };
    let first = largest("R_I", on_first, last[0]);
    let second = largest("R_J", on_second, last[1]);
    sheet.answer("load_first", "Maximum load on the first bearing including the weight", first);
    sheet.answer("load_second", "Maximum load on the second bearing including the weight", second);
    sheet.verify(|| {
        for (load, other) in [(first, bearings.second), (second, bearings.first)] {
            let arm = |z: W::Num| (z - other).value();
            let moment = |of: fn(&Unbalance<W::Num>) -> W::Num| -> f64 {
                all.iter().map(|u| of(u).value() * arm(u.z)).sum()
            };
            let turning = moment(|u| u.x).hypot(moment(|u| u.y)) * speed.value().powi(2);
            let resting = weight.value() * arm(rotor.centre).abs();
            let size: f64 = all.iter().map(|u| u.size() * arm(u.z).abs()).sum();
            sheet.check_sum(
                "moments about the other bearing of the weight and of the masses, where they add up",
                load * span.abs(),
                (resting + turning).into(),
                resting + size * speed.value().powi(2),
            );
        }
    });
    let lifted = [(on_first, last[0]), (on_second, last[1])];
    if lifted.iter().any(|(share, force)| force.value() > share.value().abs()) {
        sheet.warn(|| {
            Text::new(
                "the rotating force exceeds the weight on a bearing: the journal lifts once per revolution",
            )
        });
    }
    let between = (rotor.centre.value() - known.first) * (rotor.centre.value() - known.second) <= 0.0;
    if !between {
        sheet.warn(|| Text::new("the centre of mass is not between the bearings: the rotor overhangs"));
    }
}

/// Labels and symbols of the force on a bearing.
struct Written {
    symbol: &'static str,
    why: &'static str,
    key: &'static str,
    label: &'static str,
}

/// The forces on the two bearings before balancing.
const BEFORE: [Written; 2] = [
    Written {
        symbol: "F_I",
        why: "Rotating force of the masses on the first bearing",
        key: "bearing_first",
        label: "Rotating force on the first bearing",
    },
    Written {
        symbol: "F_J",
        why: "Rotating force of the masses on the second bearing",
        key: "bearing_second",
        label: "Rotating force on the second bearing",
    },
];

/// The same after it.
const AFTER: [Written; 2] = [
    Written {
        symbol: "F′_I",
        why: "Rotating force on the first bearing after balancing",
        key: "bearing_first_after",
        label: "Rotating force on the first bearing after balancing",
    },
    Written {
        symbol: "F′_J",
        why: "Rotating force on the second bearing after balancing",
        key: "bearing_second_after",
        label: "Rotating force on the second bearing after balancing",
    },
];

fn forces<W: Worksheet>(
    all: &[&Unbalance<W::Num>],
    bearings: &BearingPositionsGiven<W>,
    written: &[Written; 2],
    sheet: W,
) -> [W::Num; 2] {
    let (first, second) = (bearings.first, bearings.second);
    let x = || along(all.iter().copied(), |u| u.x);
    let y = || along(all.iter().copied(), |u| u.y);
    let in_first = balance::magnitude(
        balance::equivalent_in_first(x(), first, second),
        balance::equivalent_in_first(y(), first, second),
    );
    let in_second = balance::magnitude(
        balance::equivalent_in_second(x(), first, second),
        balance::equivalent_in_second(y(), first, second),
    );
    wrong_forces(all, bearings, written, sheet);
    let [one, other] = [(&written[0], in_first), (&written[1], in_second)].map(|(written, size)| {
        let force = balance::centrifugal_force(size, bearings.speed);
        sheet.step(written.symbol, "N", force, (written.why, RIUL.at("eqs. 7, 13")))
    });
    sheet.answer(written[0].key, written[0].label, one);
    sheet.answer(written[1].key, written[1].label, other);
    sheet.verify(|| {
        // The resultant at the middle of the bearings is shared evenly, the moment about the middle is a couple of both.
        let span = second.value() - first.value();
        let middle = first.value() + span / 2.0;
        let spun = bearings.speed.value().powi(2);
        let halves = |of: fn(&Unbalance<W::Num>) -> W::Num| {
            let sum: f64 = all.iter().map(|u| of(u).value()).sum();
            let moment: f64 = all.iter().map(|u| of(u).value() * (u.z.value() - middle)).sum();
            [sum / 2.0 - moment / span, sum / 2.0 + moment / span]
        };
        let (x, y) = (halves(|u| u.x), halves(|u| u.y));
        let scale: f64 = all.iter().map(|u| u.size() * (0.5 + ((u.z.value() - middle) / span).abs())).sum();
        for (bearing, force) in [one, other].into_iter().enumerate() {
            sheet.check_sum(
                "half of the resultant, and the couple about the middle of the bearings",
                force,
                (x[bearing].hypot(y[bearing]) * spun).into(),
                scale * spun,
            );
        }
    });
    sheet.verify(|| {
        // The bearings together carry the resultant.
        let scale: f64 = all.iter().map(|u| u.size()).sum();
        for of in [x(), y()] {
            let both = balance::equivalent_in_first(of.iter().copied(), first, second)
                + balance::equivalent_in_second(of.iter().copied(), first, second);
            let span = (second.value() - first.value()).abs();
            let reach = of.iter().map(|(_, z)| (z.value() - first.value()).abs()).fold(span, f64::max);
            let resultant = balance::resultant(of.iter().map(|(u, _)| *u));
            sheet.check_zero(
                "the bearings together carry the resultant",
                both - resultant,
                scale * reach / span,
            );
        }
    });
    [one, other]
}

/// Declares the rules by which people find other forces on the bearings.
fn wrong_forces<W: Worksheet>(
    all: &[&Unbalance<W::Num>],
    bearings: &BearingPositionsGiven<W>,
    written: &[Written; 2],
    sheet: W,
) {
    let (first, second, speed) = (bearings.first, bearings.second, bearings.speed);
    let sizes = || all.iter().map(|u| (balance::magnitude(u.x, u.y), u.z));
    let what = "the forces of the masses added as numbers, their angles ignored";
    sheet.common_error(written[0].symbol, what, || {
        balance::centrifugal_force(balance::equivalent_in_first(sizes(), first, second).abs(), speed)
    });
    sheet.common_error(written[1].symbol, what, || {
        balance::centrifugal_force(balance::equivalent_in_second(sizes(), first, second).abs(), speed)
    });
    sheet.verify(|| {
        let size = |of: &dyn Fn(Vec<(W::Num, W::Num)>) -> W::Num| {
            let [x, y] = [along(all.iter().copied(), |u| u.x), along(all.iter().copied(), |u| u.y)];
            balance::magnitude(of(x), of(y))
        };
        let half = size(&|of| balance::resultant(of.into_iter().map(|(u, _)| u))) / 2.0;
        let middle = (first + second) / 2.0;
        let couple = size(&|of| balance::moment(of, middle)) / (second - first).abs();
        let scale: f64 = all.iter().map(|u| u.size()).sum();
        for (what, wrong) in [
            ("half of the resultant force taken on each bearing, the couple ignored", half),
            ("only the couple about the midpoint of the bearings taken, the resultant ignored", couple),
        ] {
            // What cancels leaves rounding.
            if wrong.value() > 1e-9 * scale {
                for bearing in written {
                    let wrong = || balance::centrifugal_force(wrong, speed);
                    sheet.common_error(bearing.symbol, what, wrong);
                }
            }
        }
    });
}

/// The moments of the masses about a point, or the origin, added without their directions.
fn moments_as_numbers<N: Real>(masses: &[Unbalance<N>], about: Option<N>) -> N {
    let arm = |z: N| about.map_or(z, |about| z - about).abs();
    N::sum(masses.iter().map(|m| balance::magnitude(m.x, m.y) * arm(m.z)))
}

/// The unbalance reported in two planes, and as a static and a couple part.
pub(super) fn equivalent<W: Worksheet>(
    masses: &[Unbalance<W::Num>],
    known: &EquivalentPlanes,
    planes: &EquivalentPlanesGiven<W>,
    sheet: W,
) -> Result<(), Refusal> {
    if known.first == known.second {
        return Err(Refusal::because(
            "the two planes for the equivalent unbalance are the same plane; give them different positions",
        ));
    }
    let scale: f64 = masses.iter().map(Unbalance::size).sum();
    let (first, second) = (planes.first, planes.second);
    let in_first = "Equivalent unbalance in the first plane";
    let in_second = "Equivalent unbalance in the second plane";
    let [x, y] = [("U_1x", "U_2x", along(masses, |u| u.x)), ("U_1y", "U_2y", along(masses, |u| u.y))].map(
        |(symbol_first, symbol_second, all)| {
            let one = balance::equivalent_in_first(all.iter().copied(), first, second);
            let other = balance::equivalent_in_second(all.iter().copied(), first, second);
            (
                sheet.step(symbol_first, "kg*mm", one, (in_first, ISO_TERMS.at(""))),
                sheet.step(symbol_second, "kg*mm", other, (in_second, ISO_TERMS.at(""))),
            )
        },
    );
    let reported = |(size_symbol, angle_symbol): (&'static str, &'static str),
                    (size_key, angle_key): (&'static str, &'static str),
                    (size_label, angle_label): (&'static str, &'static str),
                    (x, y): (W::Num, W::Num)| {
        let size = sheet.step(size_symbol, "kg*mm", balance::magnitude(x, y), (size_label, ISO_TERMS.at("")));
        sheet.answer(size_key, size_label, size);
        if size.value() <= 1e-12 * scale {
            return [x, y];
        }
        rotor::quadrant_ignored(sheet, angle_symbol, (x, y));
        let angle = sheet.step(angle_symbol, "deg", balance::marked_direction(x, y), angle_label);
        sheet.answer(angle_key, angle_label, angle);
        [size * angle.cos(), size * angle.sin()]
    };
    let one = reported(
        ("U_I", "θ_I"),
        ("equivalent_first", "equivalent_first_angle"),
        (in_first, "Angle of the equivalent unbalance in the first plane"),
        (x.0, y.0),
    );
    let other = reported(
        ("U_II", "θ_II"),
        ("equivalent_second", "equivalent_second_angle"),
        (in_second, "Angle of the equivalent unbalance in the second plane"),
        (x.1, y.1),
    );
    rotor::parts_of_sizes(sheet, ["U_s", "U_k", "θ_s"], || {
        [(x.0, y.0), (x.1, y.1)].map(|(x, y)| (balance::magnitude(x, y), balance::marked_direction(x, y)))
    });
    sheet.common_error("θ_k", rotor::REVERSED, || balance::marked_direction(x.1 - x.0, y.1 - y.0));
    let fixed = reported(
        ("U_s", "θ_s"),
        ("static_part", "static_angle"),
        ("Static component, equal in both planes", "Angle of the static component"),
        (balance::static_part(x.0, x.1), balance::static_part(y.0, y.1)),
    );
    let couple = reported(
        ("U_k", "θ_k"),
        ("couple_part", "couple_angle"),
        (
            "Couple component, in the first plane and opposite in the second",
            "Angle of the couple component in the first plane",
        ),
        (balance::couple_part(x.0, x.1), balance::couple_part(y.0, y.1)),
    );
    sheet.verify(|| {
        for (axis, of) in [along(masses, |u| u.x), along(masses, |u| u.y)].into_iter().enumerate() {
            let sum = balance::resultant(of.iter().map(|(u, _)| *u));
            let size = one[axis].value().abs() + other[axis].value().abs();
            sheet.check_sum(
                "the sum of the unbalances in both planes is the total",
                one[axis] + other[axis],
                sum,
                scale + size,
            );
            let moment = balance::moment(of.iter().copied(), first);
            let reach = of.iter().map(|(_, z)| (z.value() - first.value()).abs()).fold(0.0, f64::max);
            sheet.check_sum(
                "the unbalance in the second plane has the moment of all masses about the first",
                other[axis] * (second - first),
                moment,
                scale * reach,
            );
            sheet.check_sum(
                "static and couple component in the first plane",
                fixed[axis] + couple[axis],
                one[axis],
                size,
            );
            sheet.check_sum(
                "static and couple component in the second plane",
                fixed[axis] - couple[axis],
                other[axis],
                size,
            );
        }
    });
    Ok(())
}

/// The kinds of unbalance before and after, by the names of ISO 21940-2.
pub(super) fn kinds<N: Real>(
    masses: &[Unbalance<N>],
    corrections: Option<&[Corrected<N>]>,
    centre: Option<f64>,
    reference: f64,
) -> TableExhibit {
    let column = |heading: &'static str, unit| Column { heading: heading.into(), unit };
    let row = |name: &'static str, all: Vec<PlaneUnbalance>| -> Vec<Cell> {
        let kind = match (balance::kind(&all, centre.unwrap_or(reference), 1e-9), centre) {
            (UnbalanceKind::Balanced, _) => "balanced",
            (UnbalanceKind::Couple, _) => "couple unbalance",
            (UnbalanceKind::Dynamic, _) => "dynamic unbalance",
            (UnbalanceKind::Static, Some(_)) => "static unbalance",
            (UnbalanceKind::QuasiStatic, Some(_)) => "quasi-static unbalance",
            (UnbalanceKind::Static | UnbalanceKind::QuasiStatic, None) => "static or quasi-static unbalance",
        };
        let all_sizes: f64 = all.iter().map(|u| u.components[0].hypot(u.components[1])).sum();
        let sum = |axis: usize| all.iter().map(|u| u.components[axis]).sum::<f64>();
        let moment =
            |axis: usize| all.iter().map(|u| u.components[axis] * (u.position - reference)).sum::<f64>();
        let reach = all.iter().map(|u| (u.position - reference).abs()).fold(0.0, f64::max);
        let clean = |x: f64, scale: f64| if x < 1e-12 * scale { 0.0 } else { x };
        vec![
            name.into(),
            kind.into(),
            clean(sum(0).hypot(sum(1)), all_sizes).into(),
            clean(moment(0).hypot(moment(1)), all_sizes * reach).into(),
        ]
    };
    let before: Vec<PlaneUnbalance> = masses.iter().map(Unbalance::plain).collect();
    let mut rows = Vec::new();
    if let Some(corrections) = corrections {
        let after = before.iter().copied().chain(corrections.iter().map(|c| c.unbalance.plain())).collect();
        rows.push(row("with the corrections", after));
    }
    rows.insert(0, row("the masses", before));
    TableExhibit {
        title: "Kind of unbalance".into(),
        columns: vec![
            column("", ""),
            column("kind", ""),
            column("|Σ U|", "kg*mm"),
            column("|Σ U (z − z₀)|", "kg*mm^2"),
        ],
        rows,
        foot: Vec::new(),
    }
}
