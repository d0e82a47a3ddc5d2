//! Tables and plots of a train.

use dalembert_core::{Axis, Cell, Column, Plot, Series, TableExhibit, Text};
use dalembert_mechanics::{
    Real,
    vibration::torsional::{TorsionalMode, Train},
};

use super::{Node, ReducedTrain, TorsionalTrain, station_name, verbatim};

fn column(heading: &'static str, unit: &'static str) -> Column {
    Column { heading: heading.into(), unit }
}

/// All frequencies, with the amplitudes of the discs as they are.
pub(super) fn frequencies(
    problem: &TorsionalTrain,
    rigid: bool,
    modes: &[TorsionalMode],
    shapes: &[Vec<f64>],
) -> TableExhibit {
    let shown = problem.discs.len().min(8);
    let mut columns = vec![column("mode", ""), column("frequency", "Hz"), column("per minute", "cpm")];
    columns.extend(
        problem.discs[..shown].iter().map(|disc| Column { heading: verbatim(&disc.name), unit: "1" }),
    );
    let mut rows = Vec::new();
    if rigid {
        let mut row: Vec<Cell> = vec!["rigid-body rotation".into(), Cell::Number(0.0), Cell::Number(0.0)];
        row.resize(columns.len(), Cell::Empty);
        rows.push(row);
    }
    for (n, (mode, shape)) in modes.iter().zip(shapes).enumerate() {
        let frequency = Cell::Number(mode.frequency);
        let mut row = vec![Cell::Text(Text::new((n + 1).to_string())), frequency.clone(), frequency];
        row.extend(shape[..shown].iter().map(|x| Cell::Number(*x)));
        rows.push(row);
    }
    TableExhibit {
        title: "Natural frequencies and amplitudes of the discs".into(),
        columns,
        rows,
        foot: Vec::new(),
    }
}

/// The Holzer table at a trial frequency.
pub(super) fn holzer<N: Real>(
    problem: &TorsionalTrain,
    reduced: &ReducedTrain<N>,
    frequency: f64,
) -> TableExhibit {
    let lines = reduced.train.holzer(frequency);
    let stiffness = |from: usize, to: usize| {
        let joins = |ends: [Option<usize>; 2]| ends.contains(&Some(from)) && ends.contains(&Some(to));
        reduced.links.iter().find(|link| joins(link.ends)).map(|link| link.stiffness.value())
    };
    let rows = lines.iter().enumerate().map(|(at, line)| {
        let station = &reduced.stations[line.disc];
        let inertia = station.inertia.map_or(0.0, Real::value);
        let mut row = vec![
            verbatim(station_name(problem, &station.discs)).into(),
            Cell::Number(inertia),
            Cell::Number(inertia * frequency.powi(2)),
            Cell::Number(line.amplitude),
            Cell::Number(line.inertia_torque),
            Cell::Number(line.shaft_torque),
        ];
        match lines.get(at + 1).and_then(|next| stiffness(line.disc, next.disc)) {
            Some(stiffness) => row.extend([Cell::Number(stiffness), Cell::Number(line.twist)]),
            None => row.extend([Cell::Empty, Cell::Empty]),
        }
        row
    });
    TableExhibit {
        title: Text::new("Holzer table at {frequency}, all reduced to the speed of the first disc")
            .with_quantity("frequency", frequency, "rad/s"),
        columns: vec![
            column("disc", ""),
            column("J", "kg*m^2"),
            column("J ω²", "N*m/rad"),
            column("θ", "rad"),
            column("J ω² θ", "N*m"),
            column("Σ J ω² θ", "N*m"),
            column("k", "N*m/rad"),
            column("Σ J ω² θ / k", "rad"),
        ],
        rows: rows.collect(),
        foot: Vec::new(),
    }
}

/// Table of the nodes of the shafts.
pub(super) fn nodes(problem: &TorsionalTrain, nodes: &[Node]) -> TableExhibit {
    let name = |disc: usize| Cell::Text(verbatim(&problem.discs[disc].name));
    let row = |node: &Node| {
        let [from, to] = problem.shafts[node.shaft].ends();
        vec![
            Cell::Text(Text::new(node.mode.to_string())),
            name(from),
            name(to),
            node.distance.map_or(Cell::Empty, Cell::Number),
            Cell::Number(node.share),
        ]
    };
    TableExhibit {
        title: "Nodes of the shafts".into(),
        columns: vec![
            column("mode", ""),
            column("shaft from", ""),
            column("to", ""),
            column("distance of the node", "m"),
            column("part of the compliance", "%"),
        ],
        rows: nodes.iter().map(row).collect(),
        foot: Vec::new(),
    }
}

/// The Holzer residual against the trial frequency.
pub(super) fn residual(train: &Train, modes: &[TorsionalMode]) -> Plot {
    let shown = &modes[..modes.len().min(5)];
    let last = 1.15 * shown.last().map_or(1.0, |mode| mode.frequency);
    let at = |n: u16| {
        let frequency = last * f64::from(n) / 400.0;
        (frequency, train.residual(frequency))
    };
    Plot::new(
        "Holzer residual torque against trial frequency",
        Axis::linear("trial frequency", "rad/s"),
        Axis::linear("residual torque / sum of all inertia torques", "1"),
        vec![
            Series::line("residual", (1..=400).map(at).collect()),
            Series::dots("natural frequencies", shown.iter().map(|mode| (mode.frequency, 0.0)).collect()),
        ],
    )
    .level("zero residual", 0.0)
}
