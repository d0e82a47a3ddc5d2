//! A geared train reduced to the speed of its first disc.

use std::collections::VecDeque;

use dalembert_core::{Refusal, Text, Worksheet};
use dalembert_mechanics::{
    Real, spring as kernel,
    vibration::torsional::{self, Train},
};

use super::{TorsionalTrain, TorsionalTrainGiven, TrainInertiaGiven};
use crate::{
    shared::spring::{Element, torsional::network},
    sources::BEVAN,
};

/// A train reduced to the speed of its first disc: meshing gears turn as one station.
pub(super) struct ReducedTrain<N> {
    /// The speed of each disc over that of the first; `None` where it is the same.
    pub(super) speeds: Vec<Option<N>>,
    /// The station of each disc; `None` for one that is held.
    pub(super) station_of: Vec<Option<usize>>,
    pub(super) stations: Vec<RigidDiscs<N>>,
    pub(super) links: Vec<ReducedShaft<N>>,
    /// The numbers of it.
    pub(super) train: Train,
}

/// Discs that turn as one.
pub(super) struct RigidDiscs<N> {
    pub(super) discs: Vec<usize>,
    /// Reduced; `None` for a light one.
    pub(super) inertia: Option<N>,
}

/// A shaft between two stations, or from one to a wall.
pub(super) struct ReducedShaft<N> {
    /// The stations at its first end and at its second; `None` for a wall.
    pub(super) ends: [Option<usize>; 2],
    /// The stiffness as it is.
    pub(super) element: Element<N>,
    /// Reduced.
    pub(super) stiffness: N,
}

/// Connection of two discs: a shaft, or a gear pair seen from either wheel.
#[derive(Clone, Copy)]
enum Joint {
    Shaft,
    Driving(usize),
    Driven(usize),
}

impl<N: Real> ReducedTrain<N> {
    /// The speed of a disc over that of the first.
    pub(super) fn speed(&self, disc: usize) -> f64 {
        self.speeds[disc].map_or(1.0, Real::value)
    }
}

/// Reduces a train, with the steps that lead there.
pub(super) fn reduce<W: Worksheet>(
    problem: &TorsionalTrain,
    given: &TorsionalTrainGiven<W>,
    sheet: W,
) -> Result<ReducedTrain<W::Num>, Refusal> {
    let count = problem.discs.len();
    let inertia = |disc: usize| {
        let symbol = ("J", disc + 1).into();
        match &given.discs[disc].inertia {
            TrainInertiaGiven::Rotor(rotor) => Some(rotor.moment(sheet, symbol)),
            TrainInertiaGiven::Light {} | TrainInertiaGiven::Held {} => None,
        }
    };
    let inertias: Vec<Option<W::Num>> = (0..count).map(inertia).collect();
    let elements =
        given.shafts.iter().enumerate().map(|(n, shaft)| network(&shaft.stiffness, sheet, &[n + 1]));
    let elements = elements.collect::<Result<Vec<_>, _>>()?;

    let walk = walk(problem)?;
    let mut speeds: Vec<Option<W::Num>> = vec![None; count];
    let mut station_of: Vec<Option<usize>> = vec![None; count];
    let mut stations: Vec<RigidDiscs<W::Num>> = Vec::new();
    for &(disc, from) in &walk {
        let geared = match from {
            Some((Joint::Shaft, up)) => {
                speeds[disc] = speeds[up];
                None
            }
            Some((Joint::Driving(pair), up)) => {
                let ratio = given.gears[pair].ratio;
                let speed = speeds[up].unwrap_or(W::Num::from(1.0)) / ratio;
                Some((up, speed))
            }
            Some((Joint::Driven(pair), up)) => {
                let ratio = given.gears[pair].ratio;
                Some((up, speeds[up].map_or(ratio, |speed| speed * ratio)))
            }
            None => None,
        };
        if let Some((up, speed)) = geared {
            let why = "Speed of the geared shaft over that of the first disc";
            // The square of the root is the ratio itself, in every inertia and stiffness that it reduces.
            let what = "the gear ratio not squared in the reduction";
            sheet.common_error(("n", disc + 1), what, || speed.sqrt());
            speeds[disc] = Some(sheet.step(("n", disc + 1), "1", speed, why));
            station_of[disc] = station_of[up];
        } else {
            station_of[disc] = Some(stations.len());
            stations.push(RigidDiscs { discs: Vec::new(), inertia: None });
        }
        if let Some(station) = station_of[disc] {
            stations[station].discs.push(disc);
        }
    }
    for station in &mut stations {
        let reduced = |disc: usize| {
            inertias[disc].map(|inertia| match speeds[disc] {
                None => inertia,
                Some(speed) => sheet.step(
                    ("J'", disc + 1),
                    "kg*m^2",
                    kernel::reflected_stiffness(inertia, speed),
                    (
                        "Reduced to the speed of the first disc: the kinetic energy is the same",
                        BEVAN.at("ch. 15"),
                    ),
                ),
            })
        };
        let parts: Vec<W::Num> = station.discs.iter().filter_map(|disc| reduced(*disc)).collect();
        station.inertia = match parts[..] {
            [] => None,
            [one] => Some(one),
            _ => {
                let symbol = ("J_g", station.discs[0] + 1);
                let unreduced = || W::Num::sum(station.discs.iter().filter_map(|disc| inertias[*disc]));
                sheet.common_error(symbol, "the moments of inertia added without being reduced", unreduced);
                let why = "Meshing gears rotate together: their reduced moments of inertia add up";
                Some(sheet.step(symbol, "kg*m^2", W::Num::sum(parts), why))
            }
        };
    }
    let mut links = Vec::new();
    for (n, element) in elements.into_iter().enumerate() {
        let [first, second] = problem.shafts[n].ends();
        let ends = [station_of[first], station_of[second]];
        let turning = if ends[0].is_some() { first } else { second };
        let stiffness = match speeds[turning] {
            None => element.stiffness,
            Some(speed) => sheet.step(
                ("k'", n + 1),
                "N*m/rad",
                kernel::reflected_stiffness(element.stiffness, speed),
                (
                    "Reduced to the speed of the first disc: the elastic energy is the same",
                    BEVAN.at("ch. 15"),
                ),
            ),
        };
        links.push(ReducedShaft { ends, element, stiffness });
    }
    let train = numbers(&stations, &links)?;
    Ok(ReducedTrain { speeds, station_of, stations, links, train })
}

/// Every disc that is not held, each after the one that it hangs on and with what joins them.
type Walk = Vec<(usize, Option<(Joint, usize)>)>;

fn walk(problem: &TorsionalTrain) -> Result<Walk, Refusal> {
    let name = |disc: usize| problem.discs[disc].name.clone();
    let count = problem.discs.len();
    let mut joined: Vec<Vec<(usize, Joint, usize)>> = vec![Vec::new(); count];
    for (n, shaft) in problem.shafts.iter().enumerate() {
        let [a, b] = shaft.ends();
        if a == b {
            return Err(Refusal::because(
                Text::new("a shaft joins {disc} to itself: write two different discs").with("disc", name(a)),
            ));
        }
        if problem.discs[a].is_held() && problem.discs[b].is_held() {
            return Err(Refusal::because(
                Text::new("{first} and {second} are both fixed: omit the shaft between them")
                    .with("first", name(a))
                    .with("second", name(b)),
            ));
        }
        joined[a].push((b, Joint::Shaft, n));
        joined[b].push((a, Joint::Shaft, n));
    }
    for (n, pair) in problem.gears.iter().enumerate() {
        let (a, b) = (pair.driving.0, pair.driven.0);
        for disc in [a, b] {
            if problem.discs[disc].is_held() {
                return Err(Refusal::because(
                    Text::new(
                        "{disc} is fixed, so it cannot be geared to another: let it rotate or omit the gears",
                    )
                    .with("disc", name(disc)),
                ));
            }
        }
        if a == b {
            return Err(Refusal::because(
                Text::new("{disc} is geared to itself: write two different discs").with("disc", name(a)),
            ));
        }
        let id = problem.shafts.len() + n;
        joined[a].push((b, Joint::Driving(n), id));
        joined[b].push((a, Joint::Driven(n), id));
    }
    let turning = |disc: &usize| !problem.discs[*disc].is_held();
    let Some(first) = (0..count).find(turning) else {
        return Err(Refusal::because("all discs are fixed: let at least one rotate"));
    };
    let mut reached = vec![false; count];
    reached[first] = true;
    let mut walk: Walk = Vec::new();
    let mut waiting = VecDeque::from([(first, None, usize::MAX)]);
    while let Some((disc, from, along)) = waiting.pop_front() {
        walk.push((disc, from));
        for &(other, joint, id) in &joined[disc] {
            if id == along || problem.discs[other].is_held() {
                continue;
            }
            if reached[other] {
                return Err(Refusal::because(
                    Text::new("shafts and gears form a closed loop at {disc}, which is not allowed in a train; join parallel shafts into one")
                        .with("disc", name(other)),
                ));
            }
            reached[other] = true;
            waiting.push_back((other, Some((joint, disc)), id));
        }
    }
    match (0..count).filter(turning).find(|disc| !reached[*disc]) {
        None => Ok(walk),
        Some(apart) => Err(Refusal::because(
            Text::new("{disc} is not joined to {first} by shafts or gears that can rotate: join it or analyse it separately")
                .with("disc", name(apart))
                .with("first", name(first)),
        )),
    }
}

fn numbers<N: Real>(stations: &[RigidDiscs<N>], links: &[ReducedShaft<N>]) -> Result<Train, Refusal> {
    let inertias: Vec<f64> =
        stations.iter().map(|station| station.inertia.map_or(0.0, Real::value)).collect();
    let mut walls = vec![0.0; stations.len()];
    let mut shafts = Vec::new();
    for link in links {
        let stiffness = link.stiffness.value();
        match link.ends {
            [Some(a), Some(b)] => shafts.push(torsional::TrainShaft { ends: [a, b], stiffness }),
            [Some(end), None] | [None, Some(end)] => walls[end] += stiffness,
            [None, None] => {}
        }
    }
    Train::new(&inertias, &walls, &shafts).map_err(|error| super::refusal(&error))
}
