//! A train under harmonic torques.

use dalembert_core::{Cell, Column, Exhibit, Reason, Refusal, TableExhibit, Worksheet};
use dalembert_mechanics::{Real, vibration::torsional::TorsionalMode};

use super::{MOST_AMPLITUDES, ReducedTrain, Torques, TorquesGiven, TorsionalTrain, refusal, verbatim};
use crate::sources::DEN_HARTOG;

/// The steady amplitudes under harmonic torques; positive with the torques, negative against them.
pub(super) fn forced<W: Worksheet>(
    problem: &TorsionalTrain,
    reduced: &ReducedTrain<W::Num>,
    modes: &[TorsionalMode],
    torques: &Torques,
    given: &TorquesGiven<W>,
    sheet: W,
) -> Result<(), Refusal> {
    let frequency = given.frequency.value();
    let mut loads = vec![0.0; reduced.stations.len()];
    for torque in &torques.torques {
        let Some(station) = reduced.station_of[torque.disc.0] else {
            return Err(Refusal::because(
                "a torque acts on a fixed disc, so it excites nothing: write a disc that can rotate",
            ));
        };
        loads[station] += torque.amplitude * reduced.speed(torque.disc.0);
    }
    let amplitudes = reduced.train.steady(&loads, frequency).map_err(|error| refusal(&error))?;
    let why = (
        "Steady-state amplitude: equilibrium of each disc under its shaft torques, its inertia torque and the applied torque; negative where it moves against the torques",
        DEN_HARTOG.at("ch. 5"),
    );
    let mut table = Vec::new();
    // As they are answered, of the stations.
    let mut answered = amplitudes.clone();
    for (disc, station) in reduced.station_of.iter().enumerate() {
        let Some(station) = *station else { continue };
        let actual = amplitudes[station] * reduced.speed(disc);
        table.push((disc, actual));
        if table.len() <= MOST_AMPLITUDES {
            let why = if table.len() == 1 { Reason::from(why) } else { Reason::from("Similarly") };
            let found = sheet.numerical(("Θ", disc + 1), "rad", actual, why);
            sheet.answer(("amplitude", disc + 1), "Amplitude of disc", found);
            answered[station] = found.value() / reduced.speed(disc);
        }
    }
    sheet.verify(|| verify(reduced, modes, &loads, &answered, frequency, sheet));
    sheet.show(|| {
        let mut column = vec![Column { heading: "disc".into(), unit: "" }];
        column.push(Column { heading: "amplitude".into(), unit: "rad" });
        column.push(Column { heading: "amplitude".into(), unit: "deg" });
        Exhibit::Table(TableExhibit {
            title: "Amplitudes under the torques".into(),
            columns: column,
            rows: table
                .iter()
                .map(|&(disc, x)| {
                    vec![verbatim(&problem.discs[disc].name).into(), Cell::Number(x), Cell::Number(x)]
                })
                .collect(),
            foot: Vec::new(),
        })
    });
    Ok(())
}

fn verify<W: Worksheet>(
    reduced: &ReducedTrain<W::Num>,
    modes: &[TorsionalMode],
    loads: &[f64],
    amplitudes: &[f64],
    frequency: f64,
    sheet: W,
) {
    let square = frequency.powi(2);
    let inertias: Vec<f64> =
        reduced.stations.iter().map(|station| station.inertia.map_or(0.0, Real::value)).collect();
    let mut sum: f64 = loads.iter().sum();
    let mut size: f64 = loads.iter().map(|load| load.abs()).sum();
    for (inertia, amplitude) in inertias.iter().zip(amplitudes) {
        sum += inertia * square * amplitude;
        size += (inertia * square * amplitude).abs();
    }
    for link in &reduced.links {
        if let [Some(end), None] | [None, Some(end)] = link.ends {
            let torque = link.stiffness.value() * amplitudes[end];
            sum -= torque;
            size += torque.abs();
        }
    }
    sheet.check_zero("torques, inertia torques and wall torques sum to zero", W::Num::from(sum), size);

    // Light stations follow the others quasi-statically, so that the modes alone miss them.
    if inertias.iter().all(|inertia| *inertia > 0.0) {
        let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let mut summed = vec![0.0; amplitudes.len()];
        for mode in modes {
            let moved: Vec<f64> = mode.shape.iter().zip(&inertias).map(|(x, inertia)| x * inertia).collect();
            let modal = product(&mode.shape, loads)
                / (product(&mode.shape, &moved) * (mode.frequency.powi(2) - square));
            summed.iter_mut().zip(&mode.shape).for_each(|(sum, x)| *sum += modal * x);
        }
        let largest = amplitudes.iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
        let off = summed.iter().zip(amplitudes).fold(0.0, |off: f64, (a, b)| off.max((a - b).abs()));
        sheet.check_zero("the sum over all modes gives the same amplitudes", W::Num::from(off), largest);
    }
}
