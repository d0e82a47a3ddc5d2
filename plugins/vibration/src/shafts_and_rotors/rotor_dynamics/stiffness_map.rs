//! The map of critical speeds over the stiffness of the bearings.

use dalembert_core::{Axis, Plot, Series, Text};
use dalembert_mechanics::rotor::{
    Rotor,
    stiffness_map::{Speeds, StiffnessMap},
};

use super::RotorDynamics;

/// Stiffnesses of the map.
const POINTS: u16 = 40;

/// The map reaches from the given stiffness over this number to the given one times it.
const REACH: f64 = 1e3;

/// The most modes of the map.
const MOST: usize = 4;

/// The critical speeds over the stiffness of the first bearing, the others in proportion to it; none where nothing
/// but rigid supports holds the rotor, or where the bearings push it away.
pub(super) fn plot(problem: &RotorDynamics, rotor: &Rotor) -> Option<Plot> {
    let mean = |of: [[f64; 2]; 2]| 0.5 * (of[0][0] + of[1][1]);
    let given = rotor.supports.iter().filter_map(|support| support.at(problem.speed));
    let given: Vec<f64> = given.map(|here| mean(here.stiffness)).collect();
    let first = *given.first()?;
    if !given.iter().all(|k| *k > 0.0) {
        return None;
    }
    let shares: Vec<f64> = given.iter().map(|k| k / first).collect();
    let modes = problem.modes.div_ceil(2).min(MOST);
    let map = StiffnessMap::new(rotor, &shares, modes, problem.highest_speed).ok()?;
    let at = |stiffness: f64| map.at(stiffness, problem.slope).ok();
    let steps = f64::from(POINTS - 1);
    let stiffnesses = (0..POINTS).map(|n| first * REACH.powf(2.0 * f64::from(n) / steps - 1.0));
    let points: Vec<(f64, Speeds)> = stiffnesses.filter_map(|k| Some((k, at(k)?))).collect();
    // Speeds rise with the stiffness: a line ends where it leaves the diagrams.
    let shown = |speed: &f64| *speed <= problem.highest_speed;
    let line = |words: &'static str, n: usize, of: fn(&Speeds) -> &Vec<f64>| {
        let speeds = points.iter().filter_map(|(k, speeds)| Some((*k, *of(speeds).get(n)?)));
        Series::line(Text::new(words).with("n", n + 1), speeds.filter(|(_, speed)| shown(speed)).collect())
    };
    let forward = (0..modes).map(|n| line("forward whirl, {n}", n, |speeds| &speeds.forward));
    let backward = (0..modes).map(|n| line("backward whirl, {n}", n, |speeds| &speeds.backward));
    let mut series: Vec<Series> = forward.chain(backward).collect();
    series.retain(|series| !series.points.is_empty());
    let here = at(first)?;
    let marked = here.forward.iter().chain(&here.backward).filter(|speed| shown(speed));
    let marked: Vec<(f64, f64)> = marked.map(|speed| (first, *speed)).collect();
    if series.is_empty() {
        return None;
    }
    if !marked.is_empty() {
        series.push(Series::dots("at the given stiffness", marked));
    }
    Some(Plot::new(
        "Undamped critical speeds against bearing stiffness",
        Axis::log("stiffness of the first bearing, the others in proportion", "N/m"),
        Axis::linear("critical speed", "rpm"),
        series,
    ))
}
