//! Rotating masses, counterweights opposite the cranks, balance shafts.

use dalembert_core::{Refusal, Text, Worksheet};
use dalembert_mechanics::{
    Real,
    balance::{
        self,
        reciprocating::{self as engine, Piston, PistonMotion},
    },
};

use super::{
    ReciprocatingGiven, Shafts, checks,
    layout::Placed,
    orders::{self, Order, Pair},
};
use crate::{
    shared::rotor,
    sources::{BEVAN, DEN_HARTOG, NORTON},
};

/// Rotating force and couple, forward and backward, that a pair of balance shafts counteracts.
pub(super) struct RotatingExcitation<N> {
    pub force: Pair<N>,
    /// Sizes of the couples that turn forward and backward.
    pub couple: Option<[N; 2]>,
    /// The centrifugal force of what turns with the crank of each cylinder, less that of its counterweight.
    centrifugal: Vec<f64>,
}

/// An engine, cylinder by cylinder.
pub(super) struct CylinderEngine<'a, N> {
    pub cylinders: &'a [Placed<N>],
    pub pistons: &'a [Piston],
    pub motion: PistonMotion,
}

/// The forces that turn with the cranks: what is left of the first order, when counterweights take their part.
pub(super) fn rotating<W: Worksheet>(
    given: &ReciprocatingGiven<W>,
    cylinders: &[Placed<W::Num>],
    primary: &[W::Num],
    found: &[Order<W::Num>],
    about: Option<W::Num>,
    sheet: W,
) -> RotatingExcitation<W::Num> {
    let first = &found[0];
    let Some(counterweight) = &given.counterweight else {
        return with_rotating_masses(given, cylinders, first, about, sheet);
    };
    let masses = masses(counterweight.fraction, counterweight.radius, cylinders, sheet);
    let squared = given.speed.value().powi(2);
    let centrifugal: Vec<f64> = cylinders
        .iter()
        .zip(&masses)
        .map(|(c, mass)| {
            (c.rotating.value() * c.crank.value() - mass.value() * counterweight.radius.value()) * squared
        })
        .collect();
    let turned: f64 = cylinders
        .iter()
        .zip(&masses)
        .map(|(c, mass)| {
            (c.rotating.value() * c.crank.value() + mass.value() * counterweight.radius.value()) * squared
        })
        .sum();
    let left = sheet.step(
        "κ",
        "1",
        W::Num::from(1.0) - counterweight.fraction * 2.0,
        (
            "Residual fraction of the forward vector: the counterweights rotate with it, and it represents half of the reciprocating masses",
            DEN_HARTOG.at("ch. 5"),
        ),
    );
    let forward = first.force.forward.map(|x| left * x);
    let forward_size = first.force.forward_size * left.abs();
    let pair = Pair { forward, forward_size, ..first.force };
    let primary_force = || first.force.forward_size + first.force.backward_size;
    let unbalanced = || -counterweight.fraction + 1.0;
    sheet.common_error("F_res", "the residual force along the stroke taken as the maximum", || {
        primary_force() * unbalanced()
    });
    sheet.common_error("F_res", "the maxima along and across the stroke combined at right angles", || {
        primary_force() * (unbalanced().powi(2) + counterweight.fraction.powi(2)).sqrt()
    });
    let most = sheet.step(
        "F_res",
        "N",
        forward_size + pair.backward_size,
        "Maximum residual primary force with the counterweights",
    );
    let least = sheet.step(
        "F′_res",
        "N",
        (forward_size - pair.backward_size).abs(),
        "Minimum residual primary force with the counterweights",
    );
    sheet.answer("residual", "Maximum primary force with counterweights", most);
    sheet.answer("residual_min", "Minimum primary force with counterweights", least);
    sheet.verify(|| {
        let [[ax, ay], [bx, by]] = checks::semidiameters(1, cylinders, primary);
        let [x, y] = checks::turning(cylinders, centrifugal.iter().copied());
        checks::semi_axes(most, least, [[ax + x, ay + y], [bx - y, by + x]], first.scale + turned, sheet);
    });
    if let Some(angle) = given.angle {
        let [x, y] = orders::at(1, &pair, angle);
        let x = sheet.step("X_res", "N", x, "Upward residual at the crank angle");
        let y = sheet.step("Y_res", "N", y, "Transverse residual at the crank angle");
        let size = sheet.step("R_res", "N", balance::magnitude(x, y), "Residual at the crank angle");
        sheet.answer("residual_along", "Upward primary force with counterweights at the crank angle", x);
        sheet.answer("residual_across", "Transverse primary force with counterweights at the crank angle", y);
        sheet.answer("residual_at", "Primary force with counterweights at the crank angle", size);
        sheet.verify(|| {
            // Piston by piston and counterweight by counterweight.
            let (mut u, mut v) = (0.0, 0.0);
            for (c, k) in cylinders.iter().zip(primary) {
                let (k, crank) = (k.value(), angle.value() + c.throw.value());
                let along = k * (crank - c.line.value()).cos();
                u += along * c.line.value().cos() - counterweight.fraction.value() * k * crank.cos();
                v += along * c.line.value().sin() - counterweight.fraction.value() * k * crank.sin();
            }
            let what = "residual, summed over pistons and counterweights";
            sheet.check_sum(what, x, u.into(), first.scale);
            sheet.check_sum(what, y, v.into(), first.scale);
            sheet.check_sum(what, size, u.hypot(v).into(), first.scale);
        });
    }
    if let Some(couple) = &first.couple {
        let most = sheet.step(
            "C_res",
            "N*m",
            couple.forward_size * left.abs() + couple.backward_size,
            "Maximum residual primary couple with the counterweights",
        );
        sheet.answer("residual_couple", "Maximum primary couple with counterweights", most);
        sheet.verify(|| {
            let arm = |c: &Placed<W::Num>| c.position.value() - about.map_or(0.0, Real::value);
            let amounts = cylinders.iter().zip(primary).map(|(c, k)| *k * arm(c));
            let [[ax, ay], [bx, by]] = checks::semidiameters(1, cylinders, &amounts.collect::<Vec<_>>());
            let amounts = cylinders.iter().zip(&centrifugal).map(|(c, force)| force * arm(c));
            let [x, y] = checks::turning(cylinders, amounts);
            let least = (couple.forward_size * left.abs() - couple.backward_size).abs();
            let scale = (first.scale + turned) * first.reach;
            checks::semi_axes(most, least, [[ax + x, ay + y], [bx - y, by + x]], scale, sheet);
        });
    }
    let couple = first.couple.map(|couple| [couple.forward_size * left.abs(), couple.backward_size]);
    if first.force.forward_size.value() > 1e-9 * first.scale {
        best(first, sheet);
    }
    RotatingExcitation { force: pair, couple, centrifugal }
}

/// The fraction with the least largest force: half, found again by a search.
fn best<W: Worksheet>(first: &Order<W::Num>, sheet: W) {
    let (p, q) = (first.force.forward_size.value(), first.force.backward_size.value());
    let how =
        "Fraction that minimises the maximum force: the counterweights cancel the forward rotating vector";
    let best = sheet.numerical("c_best", "1", 0.5, (how, DEN_HARTOG.at("ch. 5")));
    let why = "Maximum primary force at that fraction: the backward rotating vector alone";
    let least = sheet.step("F_best", "N", first.force.backward_size, why);
    sheet.answer("best_fraction", "Optimum balanced fraction of the reciprocating mass", best);
    sheet.answer("best_residual", "Maximum primary force at the optimum fraction", least);
    sheet.verify(|| {
        let largest = |c: f64| (1.0 - 2.0 * c).abs() * p + q;
        let grid = (0..=1000).map(|k| f64::from(k) / 1000.0);
        let searched = grid.map(|c| (largest(c), c)).min_by(|a, b| a.0.total_cmp(&b.0));
        let near = searched.map_or(0.5, |(_, c)| c);
        sheet.check("the smallest maximum force among a thousand fractions", best, near.into());
    });
}

const OF_BOTH: &str = "the balanced fraction taken of the rotating mass too";

/// The mass of the counterweight of each cylinder. One that is for all of them is the first's.
fn masses<W: Worksheet>(
    fraction: W::Num,
    radius: W::Num,
    cylinders: &[Placed<W::Num>],
    sheet: W,
) -> Vec<W::Num> {
    let place = |c: &Placed<W::Num>| (c.throw.value(), c.position.value());
    let together = cylinders.iter().all(|c| place(c) == place(&cylinders[0]));
    let alike = cylinders[0].row == 0;
    let of_one = |c: &Placed<W::Num>| (c.rotating + fraction * c.mass) * c.crank;
    let of_both = |c: &Placed<W::Num>| fraction * (c.rotating + c.mass) * c.crank;
    let cite = BEVAN.at("ch. 14");
    if together {
        let product = if alike {
            of_one(&cylinders[0]) * cylinders.len() as f64
        } else {
            W::Num::sum(cylinders.iter().map(of_one))
        };
        let why = ("Rotating mass and the fraction of the reciprocating mass, at the crank pin", cite);
        sheet.common_error("U", OF_BOTH, || W::Num::sum(cylinders.iter().map(of_both)));
        let product = sheet.step("U", "kg*m", product, why);
        let mass = sheet.step("B", "kg", product / radius, ("Counterweight opposite the crank", cite));
        sheet.answer("counterweight_product", "Mass–radius product of the counterweight", product);
        sheet.answer("counterweight", "Mass of the counterweight", mass);
        let mut all = vec![W::Num::from(0.0); cylinders.len()];
        all[0] = mass;
        return all;
    }
    let listed = if alike { &cylinders[..1] } else { cylinders };
    let mut all = Vec::new();
    for c in listed {
        let why = ("Counterweight opposite its crank for one cylinder", cite);
        sheet.common_error(("B", c.row), OF_BOTH, || of_both(c) / radius);
        let mass = sheet.step(("B", c.row), "kg", of_one(c) / radius, why);
        sheet.answer(("counterweight", c.row), "Mass of the counterweight for one cylinder", mass);
        all.push(mass);
    }
    all.resize(cylinders.len(), all[0]);
    all
}

/// Without counterweights the rotating masses add to the forward vector.
fn with_rotating_masses<W: Worksheet>(
    given: &ReciprocatingGiven<W>,
    cylinders: &[Placed<W::Num>],
    first: &Order<W::Num>,
    about: Option<W::Num>,
    sheet: W,
) -> RotatingExcitation<W::Num> {
    if cylinders.iter().all(|c| c.rotating.value() == 0.0) {
        let couple = first.couple.map(|couple| [couple.forward_size, couple.backward_size]);
        return RotatingExcitation { force: first.force, couple, centrifugal: vec![0.0; cylinders.len()] };
    }
    let alike = cylinders[0].row == 0;
    let mut strengths: Vec<W::Num> = Vec::new();
    for c in cylinders {
        let strength = match strengths.first() {
            Some(same) if alike => *same,
            _ => {
                let value = engine::primary_amplitude(c.rotating, c.crank, given.speed);
                sheet.step(("K_r", c.row), "N", value, "Centrifugal force of the rotating mass of a cylinder")
            }
        };
        strengths.push(strength);
    }
    let sum = |of: fn(W::Num) -> W::Num, arm: Option<W::Num>| {
        W::Num::sum(cylinders.iter().zip(&strengths).map(|(c, k)| match arm {
            Some(about) => *k * (c.position - about) * of(c.throw),
            None => *k * of(c.throw),
        }))
    };
    let why = "Sum over the rotating masses";
    let x = sheet.step("R_x", "N", sum(W::Num::cos, None), why);
    let y = sheet.step("R_y", "N", sum(W::Num::sin, None), why);
    sheet.common_error("R", "the centrifugal forces of all cylinders added as numbers", || {
        W::Num::sum(strengths.iter().copied())
    });
    let force = sheet.step("R", "N", balance::magnitude(x, y), "Force that turns with the crankshaft");
    sheet.answer("rotating_force", "Force of the rotating masses", force);
    let centrifugal: Vec<f64> = strengths.iter().map(|k| k.value()).collect();
    sheet.verify(|| by_angles(force, cylinders, &centrifugal, sheet));
    let mut all = None;
    if let (true, Some(pair)) = (about.is_some(), &first.couple) {
        let x = sheet.step("S_x", "N*m", sum(W::Num::cos, about), why);
        let y = sheet.step("S_y", "N*m", sum(W::Num::sin, about), why);
        let why = "Couple that turns with the crankshaft";
        let couple = sheet.step("S", "N*m", balance::magnitude(x, y), why);
        sheet.answer("rotating_couple", "Couple of the rotating masses", couple);
        sheet.verify(|| {
            let about = about.map_or(0.0, Real::value);
            let arms = cylinders.iter().zip(&centrifugal).map(|(c, k)| k * (c.position.value() - about));
            by_angles(couple, cylinders, &arms.collect::<Vec<_>>(), sheet);
        });
        let [mx, my] = pair.forward;
        all = Some([balance::magnitude(mx + x, my + y), pair.backward_size]);
    }
    let [px, py] = first.force.forward;
    let (px, py) = (px + x, py + y);
    let force = Pair { forward: [px, py], forward_size: balance::magnitude(px, py), ..first.force };
    RotatingExcitation { force, couple: all, centrifugal }
}

/// Holds the size of a sum of vectors along the cranks to the angles of the cranks from the first one.
fn by_angles<W: Worksheet>(size: W::Num, cylinders: &[Placed<W::Num>], amounts: &[f64], sheet: W) {
    let all = amounts.iter().zip(cylinders).map(|(amount, c)| (*amount, c.throw.value()));
    let (again, scale) = rotor::along_first(&all.collect::<Vec<_>>());
    let what = "resultant by components along the first crank and across it";
    sheet.check_sum(what, size, again.into(), scale);
}

/// A pair of shafts that turns against the two vectors of an order.
pub(super) fn shafts<W: Worksheet>(
    which: Shafts,
    speed: W::Num,
    engine: &CylinderEngine<'_, W::Num>,
    found: &[Order<W::Num>],
    first: &RotatingExcitation<W::Num>,
    about: Option<W::Num>,
    sheet: W,
) -> Result<(), Refusal> {
    let (order, n): (_, u8) = match which {
        Shafts::First => (found.first(), 1),
        Shafts::Second => (found.get(1), 2),
    };
    let Some(order) = order else {
        return Err(Refusal::because(
            "balance shafts at twice the speed need the secondary forces; give the length of the rod",
        ));
    };
    let (force, couple) = if n == 1 {
        (first.force, first.couple)
    } else {
        (order.force, order.couple.map(|couple| [couple.forward_size, couple.backward_size]))
    };
    let scale: f64 = engine.pistons.iter().map(|p| p.amplitude).sum();
    let small = 1e-9 * scale;
    let speed =
        if n == 1 { speed } else { sheet.step("Ω", "rpm", speed * f64::from(n), "Speed of the shafts") };
    let cite = NORTON.at("ch. 14");
    let vectors = [
        (
            ("shaft_forward", "Mass–radius product of the shaft rotating with the crank"),
            ("shaft_forward_angle", "Angle of its mass when the crank angle is 0, forward shaft"),
            ["U_f", "η_f"],
            (force.forward, force.forward_size),
        ),
        (
            ("shaft_backward", "Mass–radius product of the shaft rotating against the crank"),
            ("shaft_backward_angle", "Angle of its mass when the crank angle is 0, backward shaft"),
            ["U_b", "η_b"],
            (force.backward, force.backward_size),
        ),
    ];
    let mut any = false;
    for (size_of, angle_of, [size, angle], ([x, y], force)) in vectors {
        if force.value() <= small {
            continue;
        }
        any = true;
        let why = ("Its centrifugal force equals the vector to be cancelled", cite);
        let product = sheet.step(size, "kg*mm", force / speed.powi(2), why);
        sheet.answer(size_of.0, size_of.1, product);
        let why = "Counterweight mass, opposite to the vector";
        let angle = sheet.step(angle, "deg", balance::marked_direction(-x, -y), why);
        sheet.answer(angle_of.0, angle_of.1, angle);
        sheet.verify(|| {
            // At the crank angle 0 the shaft's force and the vector are gone along both directions.
            let pull = product.value() * speed.value().powi(2);
            sheet.check_sum(
                "residual vertical component of the vector is zero",
                x,
                (-(pull * angle.value().cos())).into(),
                scale,
            );
            sheet.check_sum(
                "residual transverse component of the vector is zero",
                y,
                (-(pull * angle.value().sin())).into(),
                scale,
            );
        });
    }
    if any {
        if let (Some(couple), Some(about), 2) = (&order.couple, about, n) {
            let [px, py] = force.forward;
            let [mx, my] = couple.forward;
            if force.forward_size.value() > small {
                let arm = (mx * px + my * py) / force.forward_size.powi(2);
                let why = "Axial position of the resultant force, where the balance shafts are placed";
                let place = sheet.step("z_s", "mm", about + arm, why);
                sheet.answer("shaft_position", "Position of the balance shafts along the engine", place);
                sheet.verify(|| {
                    let [mx, my] = checks::couple(2, 1.0, engine.pistons, engine.motion, place.value());
                    let part = (mx * px.value() + my * py.value()) / force.forward_size.value();
                    let reach = order.reach + (place - about).value().abs();
                    let what = "couple of the pistons about the shafts, in phase with their force";
                    sheet.check_zero(what, part.into(), scale * reach);
                });
            }
        }
        return Ok(());
    }
    for (sign, couple, symbol, key, label) in [
        (
            1.0,
            couple.map(|[forward, _]| forward),
            "D_f",
            "shaft_couple_forward",
            "Mass–radius–distance product of the two masses of the shaft rotating with the crank",
        ),
        (
            -1.0,
            couple.map(|[_, backward]| backward),
            "D_b",
            "shaft_couple_backward",
            "Mass–radius–distance product of the two masses of the shaft rotating against the crank",
        ),
    ] {
        let Some(couple) = couple.filter(|couple| couple.value() > small * order.reach) else { continue };
        any = true;
        let why = ("Two masses opposite each other make a couple as large as the vector it cancels", cite);
        let product = sheet.step(symbol, "kg*m^2", couple / speed.powi(2), why);
        sheet.answer(key, label, product);
        sheet.verify(|| {
            let about = about.map_or(0.0, Real::value);
            let [mut x, mut y] = checks::couple(n, sign, engine.pistons, engine.motion, about);
            let arms = engine.cylinders.iter().zip(&first.centrifugal);
            let arms = arms.map(|(c, force)| force * (c.position.value() - about));
            if n == 1 && sign > 0.0 {
                let [u, v] = checks::turning(engine.cylinders, arms.clone());
                (x, y) = (x + u, y + v);
            }
            let scale = scale * order.reach + arms.map(f64::abs).sum::<f64>();
            let what = "couple of the shaft's masses, and the Fourier integral of the pistons' couples";
            sheet.check_sum(what, product * speed.powi(2), x.hypot(y).into(), scale);
        });
    }
    if !any {
        sheet.warn(|| {
            Text::new(
                "there is neither a force nor a couple of this order, so the shafts need no masses for it",
            )
        });
    }
    Ok(())
}
