//! The exact frequencies and mode shapes, on a shaft without mass and on one with its own.

use dalembert_core::{Cell, Column, Exhibit, Refusal, TableExhibit, Text, Worksheet};
use dalembert_mechanics::{
    Real,
    beam::dynamic_stiffness::{Beam, BeamShape, BeamStation},
    vibration::lumped,
};

use super::{Lengths, NOT_FOUND, Shaft, coefficient};
use crate::{
    shared::continuous::{Sampled, shapes_plot},
    sources::{BLEVINS, RAO},
};

/// Highest frequency over the lowest that the influence coefficients still resolve.
const HIGHEST: f64 = 300.0;

/// The exact frequencies, the lowest first.
pub(super) struct Exact<N> {
    pub(super) modes: Vec<ExactMode<N>>,
}

/// An exact frequency and its mode shape.
pub(super) struct ExactMode<N> {
    pub(super) frequency: N,
    /// Deflections of the discs.
    pub(super) discs: Vec<f64>,
    /// Shape of the shaft where it has mass.
    line: Option<BeamShape>,
}

impl<N: Real> Exact<N> {
    /// Frequencies, critical speeds and the deflections of the discs.
    pub(super) fn table(&self) -> Exhibit {
        let count = self.modes[0].discs.len();
        let mut columns = vec![
            Column { heading: "mode".into(), unit: "1" },
            Column { heading: "frequency".into(), unit: "Hz" },
            Column { heading: "critical speed".into(), unit: "rpm" },
        ];
        columns
            .extend((1..=count).map(|n| Column { heading: Text::new("disc {n}").with("n", n), unit: "1" }));
        let row = |(n, mode): (u32, &ExactMode<N>)| {
            let speed = mode.frequency.value();
            let mut row = vec![Cell::Number(n.into()), Cell::Number(speed), Cell::Number(speed)];
            row.extend(mode.discs.iter().copied().map(Cell::Number));
            row
        };
        Exhibit::Table(TableExhibit {
            title: "Critical speeds and mode shapes".into(),
            columns,
            rows: (1..).zip(&self.modes).map(row).collect(),
            foot: Vec::new(),
        })
    }
}

impl<W: Worksheet> Shaft<'_, W> {
    /// The exact frequencies of the discs on a shaft without mass, the lowest held by matrix iteration.
    pub(super) fn lumped(
        &self,
        influence: &[Vec<W::Num>],
        [dunkerley, rayleigh, improved]: [W::Num; 3],
        sheet: W,
    ) -> Result<Exact<W::Num>, Refusal> {
        let (rows, masses) = self.numbers(influence);
        let all = lumped::modes(&rows, &masses).map_err(|_| Refusal::because(NOT_FOUND))?;
        let lowest = all[0].frequency;
        let frequency = sheet.numerical(
            ("ω", 1),
            "Hz",
            lowest,
            (
                "Exact: 1/ω² is the largest eigenvalue of the product of influence coefficients and masses",
                RAO.at("§6.4"),
            ),
        );
        let rounds = lumped::matrix_iteration(&rows, &masses, 5000);
        let [Some(first), Some(last)] = [rounds.first(), rounds.last()].map(Option::<&_>::cloned) else {
            return Err(Refusal::because(NOT_FOUND));
        };
        sheet.verify(|| {
            let squares: f64 = all.iter().map(|mode| mode.frequency.powi(-2)).sum();
            sheet.check(
                "Dunkerley: the sum of the squared periods of all modes gives the same value",
                W::Num::from(squares.sqrt().recip()),
                dunkerley,
            );
            sheet.check(
                "Rayleigh: the first step of matrix iteration, from equal deflections",
                W::Num::from(first.frequency),
                rayleigh,
            );
            if let Some(second) = rounds.get(1) {
                sheet.check(
                    "Rayleigh, improved: the second step of matrix iteration",
                    W::Num::from(second.frequency),
                    improved,
                );
            }
            sheet.check(
                "matrix iteration starting from equal deflections converges to the exact frequency",
                W::Num::from(last.frequency),
                frequency,
            );
        });
        let mut modes = vec![ExactMode { frequency, discs: last.shape, line: None }];
        for (n, mode) in (1..).zip(&all).skip(1) {
            if mode.frequency > HIGHEST * lowest {
                sheet.warn(|| {
                    Text::new(
                        "the highest frequencies are more than three hundred times the lowest and are left out: discs near a bearing or of negligible mass",
                    )
                });
                break;
            }
            let why =
                "Higher frequency: the next eigenvalue of the product of influence coefficients and masses";
            let frequency = sheet.numerical(("ω", n), "Hz", mode.frequency, (why, RAO.at("§6.4")));
            sheet.verify(|| {
                let omega = frequency.value();
                let scale = all.iter().map(|other| (omega / other.frequency).powi(2).max(1.0)).product();
                sheet.check_zero(
                    "determinant of the frequency equation at this frequency",
                    W::Num::from(lumped::frequency_determinant(&rows, &masses, omega)),
                    scale,
                );
            });
            modes.push(ExactMode { frequency, discs: mode.shape.clone(), line: None });
        }
        Ok(Exact { modes })
    }

    /// The mode shapes over the length: of a shaft without mass, its deflections under the inertia forces of the discs.
    pub(super) fn modes_plot(&self, exact: &Exact<W::Num>) -> Exhibit {
        let (bending, lengths, length) = (self.bending.value(), self.lengths_value(), self.length.value());
        let under_discs = |mode: &ExactMode<W::Num>, place: f64| -> f64 {
            let discs = self.places.iter().zip(&self.masses).zip(&mode.discs);
            discs
                .map(|((at, mass), w)| mass.value() * w * coefficient(bending, [place, at.value()], lengths))
                .sum()
        };
        let sampled = |(n, mode): (usize, &ExactMode<W::Num>)| {
            let mut shape = Sampled::new(n, length, |xi| match &mode.line {
                Some(line) => line.state(xi).deflection,
                None => under_discs(mode, xi * length),
            });
            let crest = shape.points.iter().fold(0.0f64, |a, (_, w)| if w.abs() > a.abs() { *w } else { a });
            shape.points.iter_mut().for_each(|(_, w)| *w /= crest);
            shape
        };
        shapes_plot(&(1..).zip(&exact.modes).map(sampled).collect::<Vec<_>>())
    }

    /// The exact frequencies of the discs on a shaft with its mass, as many as there are discs.
    pub(super) fn distributed(&self, line: W::Num, sheet: W) -> Result<Exact<W::Num>, Refusal> {
        let beam = self.beam(Some(line.value()));
        let roots = beam
            .roots(self.masses.len())
            .or_else(|_| beam.roots(1))
            .map_err(|_| Refusal::because(NOT_FOUND))?;
        let mut modes = Vec::new();
        for (n, root) in (1..).zip(roots) {
            let shape = beam.shape(root).map_err(|_| Refusal::because(NOT_FOUND))?;
            let why = if n == 1 {
                "Exact: lowest root of the dynamic stiffness of the shaft, including its mass and the discs"
            } else {
                "Higher root of the dynamic stiffness"
            };
            let beta = sheet.numerical(("β", n), "1", root, (why, BLEVINS.at("ch. 8")));
            let why = if n == 1 { "Exact lowest frequency" } else { "Higher frequency" };
            let frequency = sheet.step(
                ("ω", n),
                "Hz",
                beta.powi(2) * (self.bending / (line * self.length.powi(4))).sqrt(),
                (why, RAO.at("§8.5")),
            );
            sheet.verify(|| {
                sheet.check(
                    "strain energy over kinetic energy of the exact mode shape reproduces the root",
                    W::Num::from(shape.rayleigh_quotient()),
                    beta.powi(4),
                );
            });
            let length = self.length.value();
            let discs = self.places.iter().map(|place| shape.state(place.value() / length).deflection);
            modes.push(ExactMode { frequency, discs: discs.collect(), line: Some(shape) });
        }
        Ok(Exact { modes })
    }

    /// The shaft as a beam, with its discs where the mass of the shaft per unit length is given.
    pub(super) fn beam(&self, with_discs: Option<f64>) -> Beam {
        let length = self.length.value();
        let at = |at: f64| BeamStation { at, ..BeamStation::default() };
        let mut stations = match self.lengths_value() {
            Lengths::Span(_) => {
                vec![BeamStation { held: true, ..at(0.0) }, BeamStation { held: true, ..at(1.0) }]
            }
            Lengths::Cantilever(_) => vec![BeamStation { held: true, clamped: true, ..at(0.0) }, at(1.0)],
            Lengths::Overhang(span, _) => {
                vec![
                    BeamStation { held: true, ..at(0.0) },
                    BeamStation { held: true, ..at(span / length) },
                    at(1.0),
                ]
            }
        };
        if let Some(line) = with_discs {
            for (place, mass) in self.places.iter().zip(&self.masses) {
                let xi = place.value() / length;
                let near = stations.iter().position(|station| (station.at - xi).abs() <= 1e-9);
                let index = near.unwrap_or_else(|| {
                    let index = stations.partition_point(|station| station.at < xi);
                    stations.insert(index, at(xi));
                    index
                });
                stations[index].mass += mass.value() / (line * length);
            }
        }
        Beam { shear: 0.0, rotary: 0.0, axial: 0.0, foundation: 0.0, stations }
    }

    /// Influence coefficients and masses as plain numbers.
    fn numbers(&self, influence: &[Vec<W::Num>]) -> (Vec<Vec<f64>>, Vec<f64>) {
        let plain = |row: &Vec<W::Num>| row.iter().map(|a| a.value()).collect();
        (influence.iter().map(plain).collect(), self.masses.iter().map(|mass| mass.value()).collect())
    }

    pub(super) fn iteration(&self, influence: &[Vec<W::Num>]) -> Exhibit {
        let (rows, masses) = self.numbers(influence);
        let rounds = lumped::matrix_iteration(&rows, &masses, 6);
        let mut columns = vec![
            Column { heading: "round".into(), unit: "1" },
            Column { heading: "frequency".into(), unit: "Hz" },
        ];
        columns.extend(
            (1..=self.masses.len())
                .map(|n| Column { heading: Text::new("disc {n}").with("n", n), unit: "1" }),
        );
        let row = |(n, round): (usize, lumped::Round)| {
            let mut row = vec![Cell::Number(n as f64), Cell::Number(round.frequency)];
            row.extend(round.shape.into_iter().map(Cell::Number));
            row
        };
        Exhibit::Table(TableExhibit {
            title: "Matrix iteration from equal deflections".into(),
            columns,
            rows: (1..).zip(rounds).map(row).collect(),
            foot: Vec::new(),
        })
    }
}
