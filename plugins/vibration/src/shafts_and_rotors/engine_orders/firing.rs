//! Firing angles of the cylinders, and the mass of the line on which each acts.

use std::f64::consts::PI;

use dalembert_core::{Refusal, Text, Worksheet};
use dalembert_mechanics::Real;

use super::{CrankshaftCranks, EngineOrders, EngineOrdersGiven, Firing, FiringGiven, WorkingCycle};
use crate::sources::DEN_HARTOG;

/// The most cranks of an engine.
const MOST_CRANKS: usize = 24;

/// The cylinders of an engine.
pub(super) struct Cylinders<N> {
    /// Cylinder by cylinder.
    pub(super) each: Vec<FiringCylinder<N>>,
    /// Number of cranks.
    pub(super) cranks: usize,
    /// True if each crank has a cylinder of its own, in order.
    pub(super) one_to_a_crank: bool,
}

/// A cylinder.
pub(super) struct FiringCylinder<N> {
    /// The mass of the line that is its crank, counted from 0.
    pub(super) mass: usize,
    /// Firing angle.
    pub(super) angle: N,
}

impl<N: Real> Cylinders<N> {
    /// The firing angles as numbers.
    pub(super) fn values(&self) -> Vec<f64> {
        self.each.iter().map(|one| one.angle.value()).collect()
    }
}

/// The firing angles, with the steps that lead to them.
pub(super) fn cylinders<W: Worksheet>(
    problem: &EngineOrders,
    given: &EngineOrdersGiven<W>,
    sheet: W,
) -> Result<Cylinders<W::Num>, Refusal> {
    let front = problem.front.len();
    let (each, cranks) = match (&problem.firing, &given.firing) {
        (Firing::Even { order }, _) => {
            let places = places(order)?;
            let (turn, why) = match problem.cycle {
                WorkingCycle::Four => (4.0 * PI, "A four-stroke cylinder fires once every two revolutions"),
                WorkingCycle::Two => (2.0 * PI, "A two-stroke cylinder fires once per revolution"),
            };
            let turn = sheet.numerical("ψ_z", "deg", turn, why);
            let interval = sheet.step(
                "Δψ",
                "deg",
                turn / places.len() as f64,
                "Crank angle from one firing to the next",
            );
            let each: Vec<FiringCylinder<W::Num>> = places
                .iter()
                .enumerate()
                .map(|(cylinder, place)| FiringCylinder {
                    mass: front + cylinder,
                    angle: sheet.step(
                        ("ψ", cylinder + 1),
                        "deg",
                        interval * *place as f64,
                        ("Firing angle, by the place in the firing order", DEN_HARTOG.at("ch. 5")),
                    ),
                })
                .collect();
            let count = each.len();
            (each, count)
        }
        (Firing::Angles { cylinders }, FiringGiven::Angles { cylinders: angles }) => {
            let each: Vec<FiringCylinder<W::Num>> = cylinders
                .iter()
                .zip(angles)
                .map(|(cylinder, given)| FiringCylinder {
                    mass: front + cylinder.crank as usize - 1,
                    angle: given.angle,
                })
                .collect();
            let most = cylinders.iter().map(|cylinder| cylinder.crank as usize).max().unwrap_or(0);
            (each, most)
        }
        _ => (Vec::new(), 0),
    };
    if each.len() > 2 * MOST_CRANKS {
        return Err(Refusal::because("there are more than 48 cylinders: write fewer"));
    }
    let cranks = match &problem.cranks {
        CrankshaftCranks::Alike { .. } => cranks,
        CrankshaftCranks::Each { cranks: listed } if listed.len() < cranks => {
            return Err(Refusal::because(
                Text::new("a cylinder acts on crank {crank}, but there are only {count}: write more cranks or another number")
                    .with("crank", cranks)
                    .with("count", listed.len()),
            ));
        }
        CrankshaftCranks::Each { cranks: listed } => listed.len(),
    };
    let one_to_a_crank = matches!(problem.firing, Firing::Even { .. });
    Ok(Cylinders { each, cranks, one_to_a_crank })
}

/// The place of each cylinder in a firing order, counted from 0.
fn places(order: &str) -> Result<Vec<usize>, Refusal> {
    let numbers: Vec<&str> =
        order.split(|c: char| !c.is_ascii_digit()).filter(|part| !part.is_empty()).collect();
    let count = numbers.len();
    if count == 0 || count > MOST_CRANKS {
        return Err(Refusal::because(
            "the firing order contains no cylinder, or more than 24: write the numbers of the cylinders, such as 1-3-4-2",
        ));
    }
    let mut places = vec![usize::MAX; count];
    for (place, number) in numbers.iter().enumerate() {
        let free = number.parse::<usize>().ok().and_then(|n| places.get_mut(n.checked_sub(1)?));
        match free {
            Some(free) if *free == usize::MAX => *free = place,
            _ => {
                return Err(Refusal::because(
                    Text::new("the firing order of {count} cylinders does not include {number}: write each number from 1 on once")
                        .with("count", count)
                        .with("number", *number),
                ));
            }
        }
    }
    Ok(places)
}
