//! Bodies on wires and on rails.

use std::f64::consts::{PI, TAU};

use dalembert_core::{Drawing, Ink, Refusal, Sketch, Worksheet};
use dalembert_mechanics::{Real, vibration::swing};

use super::{Platform, PlatformGiven, Wire, WireGiven, inertia, period};
use crate::sources::{RAO, THOMSON};

/// Wires on which a body hangs.
pub(super) struct Wires<N> {
    /// From the axis to the wires at the body.
    pub(super) radius: N,
    /// From the axis to the wires at the top, where it differs.
    pub(super) top: Option<N>,
    pub(super) length: N,
    pub(super) gravity: N,
}

/// The moment of inertia of a body on wires.
pub(super) fn on_wires<W: Worksheet>(
    wires: &Wires<W::Num>,
    mass: W::Num,
    time: W::Num,
    platform: Option<&PlatformGiven<W>>,
    under: Option<&Platform>,
    sheet: W,
) -> Result<W::Num, Refusal> {
    let Wires { radius, top, length, gravity } = *wires;
    let height = match top {
        None => length,
        Some(top) => {
            if (top.value() - radius.value()).abs() >= length.value() {
                return Err(Refusal::because(
                    "the wires are too short to reach from one circle to the other: write a larger length",
                ));
            }
            let what = "the length of the inclined wires taken as the vertical distance";
            sheet.common_error("h", what, || length);
            sheet.step(
                "h",
                "mm",
                (length.powi(2) - (top - radius).powi(2)).sqrt(),
                "Vertical distance between the two ends of a wire",
            )
        }
    };
    let above = top.unwrap_or(radius);
    let why = ("The wires lean as the body turns and lift it: J ω² = m g r R/h", THOMSON.at("ch. 2"));
    let of = |weight: W::Num, time: W::Num| swing::on_wires(weight, radius, above, height, time);
    let (whole, inertia) = match (platform, under) {
        (Some(given), Some(under)) => {
            let empty = period(&given.swings, &under.swings, "0", sheet);
            let alone = sheet.step(
                "J₀",
                "kg*m^2",
                of(given.mass * gravity, empty),
                "Moment of inertia of the platform alone",
            );
            sheet.verify(|| {
                let lifted = lifted(radius.value(), above.value(), height.value());
                let stiffness = given.mass.value() * gravity.value() * lifted;
                sheet.check(
                    "period of the platform alone from its rise as it rotates",
                    W::Num::from((alone.value() / stiffness).sqrt() * TAU),
                    empty,
                );
            });
            let body_alone = || of(mass * gravity, time);
            sheet.common_error("J_s", "the weight of the platform omitted", body_alone);
            let both = sheet.step("J_s", "kg*m^2", of((mass + given.mass) * gravity, time), why);
            if alone.value() >= both.value() {
                return Err(Refusal::because(
                    "the moment of inertia of the platform with the body is not larger than that of the platform alone: check the periods",
                ));
            }
            sheet.answer("platform", "Moment of inertia of the platform", alone);
            let body_alone = || of(mass * gravity, time) - of(mass * gravity, empty);
            sheet.common_error("J", "the weight of the body alone taken with both periods", body_alone);
            let inertia = sheet.step("J", "kg*m^2", both - alone, "Contribution of the body to the platform");
            ((mass + given.mass, both), inertia)
        }
        _ => {
            let pendulum = || mass * length * swing::reduced_length(gravity, time);
            sheet.common_error("J", "the body taken as a pendulum of the length of the wires", pendulum);
            if top.is_some() {
                let upright = || swing::on_wires(mass * gravity, radius, radius, height, time);
                sheet.common_error("J", "the wires taken as vertical, with the radius at the body", upright);
            }
            let inertia = sheet.step("J", "kg*m^2", of(mass * gravity, time), why);
            ((mass, inertia), inertia)
        }
    };
    sheet.verify(|| {
        let (mass, inertia) = whole;
        let stiffness =
            mass.value() * gravity.value() * lifted(radius.value(), above.value(), height.value());
        sheet.check(
            "period from the rise of the body as it rotates",
            W::Num::from((inertia.value() / stiffness).sqrt() * TAU),
            time,
        );
    });
    Ok(inertia)
}

/// Twice the height by which a body on wires is lifted, over the square of the angle, as the angle goes to zero: by the
/// geometry of the wires at four angles, extrapolated.
fn lifted(below: f64, above: f64, height: f64) -> f64 {
    let at = |angle: f64| {
        let raised = 4.0 * below * above * (angle / 2.0).sin().powi(2);
        2.0 * raised / ((height + (height * height - raised).max(0.0).sqrt()) * angle * angle)
    };
    let step = 0.02 * (height / (below * above).sqrt()).min(1.0);
    let mut row: Vec<f64> = (0..4).map(|n| at(step / f64::from(1 << n))).collect();
    for level in 1..4 {
        let share = f64::from(1 << (2 * level));
        row = row.windows(2).map(|pair| (share * pair[1] - pair[0]) / (share - 1.0)).collect();
    }
    row[0]
}

/// The moment of inertia of a body on a torsion wire.
pub(super) fn on_torsion_wire<W: Worksheet>(
    time: W::Num,
    given: &WireGiven<W>,
    wire: &Wire,
    sheet: W,
) -> Result<W::Num, Refusal> {
    let (inertia, stiffness) = match (given, wire) {
        (WireGiven::Added { inertia: added, swings }, Wire::Added { swings: own, .. }) => {
            let added = inertia::moment_of_inertia(added, sheet, "J_a".into());
            let longer = period(swings, own, "a", sheet);
            if longer.value() <= time.value() {
                return Err(Refusal::because(
                    "the period with the added inertia is not longer than without it: check which is which",
                ));
            }
            let why = (
                "The stiffness is the same: J/T² = (J + J_a)/T_a², so that J follows from the two periods",
                RAO.at("§2.3"),
            );
            let unsquared = || added * time / (longer - time);
            sheet.common_error("J", "the periods used in place of their squares", unsquared);
            let separate = || added * (time / longer).powi(2);
            sheet.common_error("J", "the second period taken as that of the added inertia alone", separate);
            let total = || added * longer.powi(2) / (longer.powi(2) - time.powi(2));
            sheet.common_error("J", "the added inertia included in the result", total);
            let inertia =
                sheet.step("J", "kg*m^2", added * time.powi(2) / (longer.powi(2) - time.powi(2)), why);
            let both = (inertia + added) * (4.0 * PI * PI) / longer.powi(2);
            (inertia, both)
        }
        (WireGiven::Reference { inertia: known, swings }, Wire::Reference { swings: own, .. }) => {
            let known = inertia::moment_of_inertia(known, sheet, "J_k".into());
            let other = period(swings, own, "k", sheet);
            let why = "The stiffness is the same: the moments of inertia are proportional to the squares of the periods";
            let inertia = sheet.step("J", "kg*m^2", known * (time / other).powi(2), why);
            (inertia, known * (4.0 * PI * PI) / other.powi(2))
        }
        (WireGiven::Stiffness { stiffness }, _) => {
            let why = ("Torsional pendulum: T² = 4π² J/k_t", RAO.at("§2.3"));
            let inertia = sheet.step("J", "kg*m^2", *stiffness * time.powi(2) / (4.0 * PI * PI), why);
            (inertia, *stiffness)
        }
        _ => return Err(Refusal::because("the properties of the wire are missing: write them")),
    };
    let stiffness = if matches!(wire, Wire::Stiffness { .. }) {
        stiffness
    } else {
        let stiffness = sheet.step("k_t", "N*m/rad", stiffness, "Torsional stiffness of the wire");
        sheet.answer("stiffness", "Torsional stiffness of the wire", stiffness);
        stiffness
    };
    sheet.verify(|| {
        sheet.check(
            "period of the body on the stiffness of the wire",
            (inertia / stiffness).sqrt() * TAU,
            time,
        );
    });
    Ok(inertia)
}

/// A body on wires that stand at `top` times its radius above.
pub(super) fn wires(top: f64, mass: &'static str) -> Drawing {
    Sketch::new("The body on its wires")
        .ground((1.4, 2.0), (-1.4, 2.0))
        .axis((0.0, 2.2), (0.0, -0.6))
        .link("", (-top, 2.0), (-1.0, 0.0))
        .link("l", (top, 2.0), (1.0, 0.0))
        .mass(mass, (-1.2, -0.3), (1.2, 0.0))
        .dimension("r", (0.0, 0.0), (1.0, 0.0), 2.0)
        .dimension("R", (0.0, 2.0), (top, 2.0), 2.5)
        .arc((0.0, -0.5), 0.4, (PI, TAU), Ink::Motion)
        .finish()
}

/// A body on a torsion wire.
pub(super) fn torsion() -> Drawing {
    Sketch::new("The body on the wire")
        .ground((0.8, 2.0), (-0.8, 2.0))
        .link("k_t", (0.0, 2.0), (0.0, 0.0))
        .mass("", (-1.0, -0.4), (1.0, 0.0))
        .arc((0.0, -0.6), 0.5, (PI, TAU), Ink::Motion)
        .finish()
}

/// A journal in a hollow rail.
pub(super) fn rails(mass: &'static str) -> Drawing {
    let (turn, reach) = (0.35f64, 1.7);
    let at = (reach * turn.sin(), 2.0 - reach * turn.cos());
    Sketch::new("The journal on the concave rail")
        .arc((0.0, 2.0), 2.0, (1.15 * PI, 1.85 * PI), Ink::Body)
        .line("R", (0.0, 2.0), (0.0, 0.0), Ink::Faint)
        .axis((0.0, 2.0), at)
        .circle(at, 0.75, Ink::Faint)
        .disc("", at, 0.3)
        .dimension("ρ", at, (at.0 + 0.21, at.1 + 0.21), 0.0)
        .label(mass, (at.0, at.1 + 0.75))
        .finish()
}

/// A journal on an inclined rail.
pub(super) fn incline(mass: &'static str) -> Drawing {
    let at = (1.905, 0.985);
    let angle = (1.0f64 / 3.0).atan();
    Sketch::new("The journal on the inclined rail")
        .ground((0.0, 0.0), (3.0, 1.0))
        .axis((0.0, 0.0), (3.0, 0.0))
        .circle(at, 0.75, Ink::Faint)
        .disc("", at, 0.3)
        .dimension("ρ", at, (at.0 + 0.21, at.1 + 0.21), 0.0)
        .label(mass, (at.0, at.1 + 0.75))
        .motion("s", (1.6, 1.2), (0.7, 0.9))
        .arc((0.0, 0.0), 1.0, (0.0, angle), Ink::Faint)
        .label("α", ((angle / 2.0).cos(), (angle / 2.0).sin()))
        .finish()
}
