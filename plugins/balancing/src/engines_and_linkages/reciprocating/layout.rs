//! From an arrangement to cylinders one by one.

use std::f64::consts::{PI, TAU};

use dalembert_core::{Point, Refusal, Text, Worksheet};
use dalembert_mechanics::{Real, balance::reciprocating as engine};

use super::{
    Arrangement, ArrangementGiven, CrankAngles, CrankAnglesGiven, EveryGiven, SpacingGiven, Strokes,
};
use crate::sources::{DEN_HARTOG, KHURMI};

/// A cylinder in its place.
pub(super) struct Placed<N> {
    /// Row in the list, 0 if all cylinders are alike.
    pub row: usize,
    pub mass: N,
    pub rotating: N,
    pub crank: N,
    pub rod: Option<N>,
    pub throw: N,
    pub line: N,
    pub position: N,
    /// True if the stroke is vertical.
    pub upright: bool,
}

/// A cylinder as it is drawn.
pub(super) struct View {
    pub crank: f64,
    pub rod: Option<f64>,
    pub line: f64,
    pub throw: f64,
    pub position: f64,
    pub rotating: bool,
}

impl View {
    /// The length of the rod; a usual one where it is taken as infinite.
    pub(super) fn reach(&self) -> f64 {
        self.rod.unwrap_or(3.5 * self.crank)
    }

    /// The crank pin, and the distance of the piston along its line.
    pub(super) fn pin_and_piston(&self) -> (Point, f64) {
        let angle = self.throw - self.line;
        let pin = (self.crank * self.throw.sin(), self.crank * self.throw.cos());
        let across = self.crank * angle.sin();
        (pin, self.crank * angle.cos() + (self.reach().powi(2) - across * across).max(0.0).sqrt())
    }

    pub(super) fn masses(&self) -> &'static str {
        if self.rotating { "m, m_r" } else { "m" }
    }

    pub(super) fn rod_letter(&self) -> &'static str {
        if self.rod.is_some() { "l" } else { "" }
    }
}

impl<N: Real> Placed<N> {
    /// The cylinder as it is drawn.
    pub(super) fn drawn(&self) -> View {
        View {
            crank: self.crank.value(),
            rod: self.rod.map(Real::value),
            line: self.line.value(),
            throw: self.throw.value(),
            position: self.position.value(),
            rotating: self.rotating.value() != 0.0,
        }
    }
}

/// The cylinders of an arrangement.
pub(super) fn cylinders<W: Worksheet>(
    known: &Arrangement,
    given: &ArrangementGiven<W>,
    sheet: W,
) -> Result<Vec<Placed<W::Num>>, Refusal> {
    let zero = W::Num::from(0.0);
    match (known, given) {
        (Arrangement::Cylinders { .. }, ArrangementGiven::Cylinders { cylinders }) => Ok((1..)
            .zip(cylinders)
            .map(|(row, c)| Placed {
                row,
                mass: c.reciprocating,
                rotating: c.rotating,
                crank: c.radius,
                rod: c.rod,
                throw: c.throw,
                line: c.line,
                position: c.position,
                upright: c.line.value() == 0.0,
            })
            .collect()),
        (
            Arrangement::Inline { count, cranks, .. },
            ArrangementGiven::Inline { every, spacing, cranks: turned, .. },
        ) => {
            let positions = positions(spacing, *count, sheet)?;
            let throws = throws(cranks, turned, *count, &[0.0], 0.0, &positions, sheet)?;
            Ok(spread(every, &[zero], &throws, &positions, zero, zero, sheet))
        }
        (
            Arrangement::Banks { banks, count, cranks, between: angle, split: twist, .. },
            ArrangementGiven::Banks { every, between, spacing, cranks: turned, split, offset, .. },
        ) => {
            let positions = positions(spacing, *count, sheet)?;
            let middle = (*banks - 1) as f64 / 2.0;
            let lines: Vec<W::Num> = (0..*banks)
                .map(|bank| {
                    let why = "Direction of the bank, evenly about the vertical";
                    sheet.step(("ψ", bank + 1), "deg", *between * (bank as f64 - middle), why)
                })
                .collect();
            let plain: Vec<f64> = (0..*banks).map(|bank| angle * (bank as f64 - middle)).collect();
            let throws = throws(cranks, turned, *count, &plain, *twist, &positions, sheet)?;
            Ok(spread(every, &lines, &throws, &positions, *split, *offset, sheet))
        }
        (
            Arrangement::Boxer { count, cranks, .. },
            ArrangementGiven::Boxer { every, pitch, cranks: turned, .. },
        ) => {
            let positions: Vec<W::Num> = (0..*count).map(|pair| *pitch * (2 * pair) as f64).collect();
            let half = W::Num::from(PI);
            let throws = throws(cranks, turned, *count, &[0.0, PI], PI, &positions, sheet)?;
            Ok(spread(every, &[zero, half], &throws, &positions, half, *pitch, sheet))
        }
        (Arrangement::Radial { count, .. }, ArrangementGiven::Radial { every, .. }) => {
            let why = "Direction of the cylinder, equally spaced over 360°";
            let lines: Vec<W::Num> = (0..*count)
                .map(|k| sheet.step(("ψ", k + 1), "deg", W::Num::from(TAU) * k as f64 / *count as f64, why))
                .collect();
            Ok(spread(every, &lines, &[zero], &[zero], zero, zero, sheet))
        }
        (
            Arrangement::Opposed { count, cranks, .. },
            ArrangementGiven::Opposed { every, spacing, cranks: turned, lead, .. },
        ) => {
            let positions = positions(spacing, *count, sheet)?;
            let throws = throws(cranks, turned, *count, &[0.0], 0.0, &positions, sheet)?;
            let why = "The second crank, on the far side, with its lead";
            let split = sheet.step("δ′", "deg", *lead + PI, why);
            Ok(spread(every, &[zero, PI.into()], &throws, &positions, split, zero, sheet))
        }
        _ => unreachable!("the inputs and their numbers are of one arrangement"),
    }
}

/// Cylinders that are all alike, bank by bank.
fn spread<W: Worksheet>(
    every: &EveryGiven<W>,
    lines: &[W::Num],
    throws: &[W::Num],
    positions: &[W::Num],
    split: W::Num,
    offset: W::Num,
    sheet: W,
) -> Vec<Placed<W::Num>> {
    let crank = every.throw.radius(sheet);
    let mut all = Vec::new();
    for (bank, line) in lines.iter().enumerate() {
        for (throw, position) in throws.iter().zip(positions) {
            let moved = |from: W::Num, by: W::Num| {
                if bank == 0 || by.value() == 0.0 { from } else { from + by * bank as f64 }
            };
            all.push(Placed {
                row: 0,
                mass: every.reciprocating,
                rotating: every.rotating,
                crank,
                rod: every.rod,
                throw: moved(*throw, split),
                line: *line,
                position: moved(*position, offset),
                upright: lines.len() == 1 || line.value() == 0.0,
            });
        }
    }
    all
}

fn positions<W: Worksheet>(
    spacing: &SpacingGiven<W>,
    count: usize,
    sheet: W,
) -> Result<Vec<W::Num>, Refusal> {
    match spacing {
        SpacingGiven::Pitch { .. } if count == 1 => Ok(vec![0.0.into()]),
        SpacingGiven::Pitch { pitch } => Ok((0..count)
            .map(|k| {
                let place = match k {
                    0 => 0.0.into(),
                    1 => *pitch,
                    _ => *pitch * k as f64,
                };
                sheet.step(("z", k + 1), "mm", place, "Positions, counted from the first crank")
            })
            .collect()),
        SpacingGiven::Positions { positions } if positions.len() == count => Ok(positions.clone()),
        SpacingGiven::Positions { positions } => Err(number("positions", positions.len(), count)),
    }
}

fn number(what: &'static str, found: usize, wanted: usize) -> Refusal {
    Refusal::because(
        Text::new("{found} {what} given for {wanted} cranks; give one for each crank")
            .with("found", found)
            .with_text("what", what)
            .with("wanted", wanted),
    )
}

/// Crank angles as given, or from the firing order, or the best. `lines` are the directions of the banks.
fn throws<W: Worksheet>(
    cranks: &CrankAngles,
    given: &CrankAnglesGiven<W>,
    count: usize,
    lines: &[f64],
    split: f64,
    positions: &[W::Num],
    sheet: W,
) -> Result<Vec<W::Num>, Refusal> {
    let pistons = count * lines.len();
    let interval = |strokes: &Strokes| match strokes {
        Strokes::Four => 2.0 * TAU / pistons as f64,
        Strokes::Two => TAU / pistons as f64,
    };
    match (cranks, given) {
        (_, CrankAnglesGiven::Angles { angles }) if angles.len() == count => Ok(angles.clone()),
        (_, CrankAnglesGiven::Angles { angles }) => Err(number("crank angles", angles.len(), count)),
        (CrankAngles::Firing { order, strokes }, _) => {
            let turns = turns(order, pistons)?;
            let interval = interval(strokes);
            // A cylinder is at its top, φ + θ = ψ, when it fires.
            let angle = |piston: usize| lines[piston / count] - interval * turns[piston] as f64;
            for piston in count..pistons {
                let (pin, bank) = (piston % count, piston / count);
                let off = (angle(piston) - angle(pin) - split * bank as f64).rem_euclid(TAU);
                if off.min(TAU - off) > 1e-6 {
                    return Err(Refusal::because(
                        Text::new(
                            "the firing order {order} contradicts the arrangement: cylinders {one} and {other} share one crank, which would need two angles; change the order, the bank angle or the splay angle, or give crank angles",
                        )
                        .with("order", order.trim())
                        .with("one", pin + 1)
                        .with("other", piston + 1),
                    ));
                }
            }
            let why = ("Cylinders fire one after another at equal angles", KHURMI.at("ch. 22"));
            let step = sheet.step("Δ", "deg", W::Num::from(interval), why);
            Ok((0..count)
                .map(|pin| {
                    let back = step * turns[pin] as f64;
                    let whole = (interval * turns[pin] as f64 / TAU - 1e-9).ceil().max(0.0) * TAU;
                    let from = W::Num::from(whole + lines[0]);
                    let angle = if turns[pin] == 0 { from } else { from - back };
                    sheet.step(
                        ("φ", pin + 1),
                        "deg",
                        angle,
                        "Crank at top dead centre when its cylinder fires",
                    )
                })
                .collect())
        }
        (CrankAngles::Best { strokes }, _) => {
            if lines.len() > 1 || count > 8 {
                return Err(Refusal::because(
                    "the best order is searched for engines in line of up to eight cylinders; give the firing order or the crank angles",
                ));
            }
            let interval = interval(strokes);
            let angles: Vec<f64> =
                (0..count).map(|k| (interval * k as f64 + 1e-9).rem_euclid(TAU) - 1e-9).collect();
            let places: Vec<f64> = positions.iter().map(|z| z.value()).collect();
            let best = engine::best_order(&places, &angles);
            let best: Vec<W::Num> = (1..)
                .zip(best)
                .map(|(row, angle)| {
                    let why = ("Crank order with the minimum primary couple", DEN_HARTOG.at("ch. 5"));
                    let angle = sheet.step(("φ", row), "deg", angle.into(), why);
                    sheet.answer(("crank", row), "Crank angle", angle);
                    angle
                })
                .collect();
            sheet.verify(|| {
                let found: Vec<f64> = best.iter().map(|angle| angle.value()).collect();
                even_and_best(&found, interval, &places, sheet);
            });
            Ok(best)
        }
        _ => unreachable!("the inputs and their numbers are of one kind"),
    }
}

/// Holds cranks that were searched for to even firing, and to the couple that no exchange of two of them lessens.
fn even_and_best<W: Worksheet>(angles: &[f64], interval: f64, places: &[f64], sheet: W) {
    let from_even = angles.iter().map(|angle| angle - interval * (angle / interval).round());
    sheet.check_zeros("cranks at whole intervals of firing", from_even, interval);
    let middle = places.iter().sum::<f64>() / places.len() as f64;
    let couple = |angles: &[f64]| {
        let part = |of: fn(f64) -> f64| -> f64 {
            angles.iter().zip(places).map(|(angle, z)| (z - middle) * of(*angle)).sum()
        };
        part(f64::cos).hypot(part(f64::sin))
    };
    let (least, mut less) = (couple(angles), 0.0f64);
    for one in 1..angles.len() {
        for other in one + 1..angles.len() {
            let mut exchanged = angles.to_vec();
            exchanged.swap(one, other);
            less = less.max(least - couple(&exchanged));
        }
    }
    let reach = places.iter().map(|z| (z - middle).abs()).sum();
    sheet.check_zero("no exchange of two cranks lessens the primary couple", less.into(), reach);
}

/// Position of each cylinder in the firing order, from the first: the inverse of the firing order.
fn turns(order: &str, pistons: usize) -> Result<Vec<usize>, Refusal> {
    let fault = |text: Text| Err(Refusal::because(text.with("order", order.trim()).with("count", pistons)));
    let words = order.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| !word.is_empty());
    let mut turns = vec![None; pistons];
    for (fired, word) in words.enumerate() {
        let place = word.parse::<usize>().ok().and_then(|n| n.checked_sub(1)).and_then(|n| turns.get_mut(n));
        match place {
            Some(place @ None) => *place = Some(fired),
            Some(Some(_)) => {
                return fault(
                    Text::new(
                        "the firing order {order} names cylinder {word} twice; name each of the {count} cylinders once",
                    )
                    .with("word", word),
                );
            }
            None => {
                return fault(
                    Text::new(
                        "the firing order {order} names {word}, but the cylinders are 1 to {count}; name each of them once",
                    )
                    .with("word", word),
                );
            }
        }
    }
    match turns.into_iter().collect::<Option<Vec<usize>>>() {
        Some(turns) => Ok(turns),
        None => fault(Text::new(
            "the firing order {order} does not name all cylinders; name each of the {count} cylinders once, such as 1-3-4-2",
        )),
    }
}

/// The point about which couples are reported; none for cylinders all in one plane.
pub(super) fn reference<W: Worksheet>(
    cylinders: &[Placed<W::Num>],
    given: Option<W::Num>,
    sheet: W,
) -> Option<W::Num> {
    if given.is_some() {
        return given;
    }
    let by_place =
        |a: &&Placed<W::Num>, b: &&Placed<W::Num>| a.position.value().total_cmp(&b.position.value());
    let first = cylinders.iter().min_by(by_place)?.position;
    let last = cylinders.iter().max_by(by_place)?.position;
    if first.value() == last.value() {
        return None;
    }
    let why = "Reference point for moments: midway between the first and the last cylinder";
    sheet.common_error("z₀", "the moments taken about the first cylinder", || first);
    Some(sheet.step("z₀", "mm", (first + last) / 2.0, why))
}

/// The amplitude `m r ω²` of every cylinder.
pub(super) fn amplitudes<W: Worksheet>(cylinders: &[Placed<W::Num>], speed: W::Num, sheet: W) -> Vec<W::Num> {
    let mut last: Option<W::Num> = None;
    let each = cylinders.iter().map(|c| match last {
        Some(same) if c.row == 0 => same,
        _ => {
            let why = ("Amplitude of the primary force of a cylinder", DEN_HARTOG.at("ch. 5"));
            let value = engine::primary_amplitude(c.mass, c.crank, speed);
            sheet.common_error(("K_I", c.row), "the rotating mass counted as a reciprocating one", || {
                engine::primary_amplitude(c.mass + c.rotating, c.crank, speed)
            });
            *last.insert(sheet.step(("K_I", c.row), "N", value, why))
        }
    });
    each.collect()
}
