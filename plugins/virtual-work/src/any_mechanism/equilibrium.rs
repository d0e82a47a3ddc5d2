//! Equilibrium positions of a plane mechanism of any shape, and their stability.

mod stops;

use dalembert_core::{
    About, Analysis, Axis, Cell, Column, Drawing, Exhibit, Ink, Inputs, Plot, Refusal, Series, Sketch,
    TableExhibit, Text, Worksheet, register,
};
use dalembert_mechanics::{
    Real,
    planar::{Equilibrium as Found, Model, PlanarError, Stability, SweepSample},
};
use nalgebra::{DMatrix, Vector3};

use self::stops::{Limited, Stop, StopContact};
use crate::{
    shared::parts::{Connection, Drive, Driven, NamedLoad, Part, Parts, Spot, verbatim},
    sources::{BEER, HAUG},
};

/// A mechanism in the plane that is left to its weights, springs and forces.
///
/// The coordinates say how it can move; their values are where the search begins. Loads with losses take no part.
#[derive(Clone, Debug, Inputs)]
pub struct Equilibrium {
    /// Bodies.
    #[input(min = 1)]
    pub bodies: Vec<Part>,
    /// Points.
    pub points: Vec<Spot>,
    /// Joints.
    pub joints: Vec<Connection>,
    /// Coordinates.
    /// One for each degree of freedom: the quantity free to vary.
    #[input(min = 1)]
    pub drivers: Vec<Drive>,
    /// Loads.
    pub loads: Vec<NamedLoad>,
    /// Acceleration of gravity.
    #[input("g", "m/s^2", planar, default = "(0; -9.81) m/s^2")]
    pub gravity: Vector3<f64>,
    /// Stops.
    /// Cords, buffers and contacts that limit the motion; found over a range of a single coordinate.
    pub stops: Vec<Stop>,
    /// Search region.
    pub search: Search,
}

/// Range of the search for an equilibrium.
#[derive(Clone, Debug, Inputs)]
pub enum Search {
    /// Between two angles of the single coordinate
    Angles {
        /// From.
        #[input("θ_a", "deg")]
        from: f64,
        /// To.
        #[input("θ_b", "deg")]
        to: f64,
    },
    /// Between two lengths of the single coordinate
    Lengths {
        /// From.
        #[input("s_a", "mm")]
        from: f64,
        /// To.
        #[input("s_b", "mm")]
        to: f64,
    },
    /// Near the given values of the coordinates
    Near,
}

register!(Equilibrium);

/// Steps of the search over a range.
const STEPS: usize = 180;

impl Analysis for Equilibrium {
    const ABOUT: About = About {
        id: "virtual-work/equilibrium",
        title: "Equilibrium of a mechanism",
        topic: "Any mechanism",
        summary: "All equilibrium positions of an arbitrary plane mechanism, from its potential energy, with their stability.",
        main: &["coordinate", "stop_coordinate", "stiffness", "stop_force"],
        keywords: "equilíbrio estabilidade energia potencial virtual work trabalho virtual stable unstable neutral mola peso potential energy springs hessian \
                   principle of virtual work conservative system stability of equilibrium princípio dos trabalhos virtuais equilíbrio estável instável indiferente",
        sources: &[&BEER, &HAUG],
        cases: include_str!("../../cases/equilibrium.toml"),
    };

    fn solve<W: Worksheet>(&self, _: &EquilibriumGiven<W>, sheet: W) -> Result<(), Refusal> {
        let parts = self.parts()?;
        let (system, rows, positions) = parts.assembled(sheet)?;
        let refuse = |error: PlanarError| parts.refusal(&error, &rows);
        let turns = matches!(self.drivers[0].what, Driven::Angle { .. });
        let range = match self.search {
            Search::Near => None,
            _ if self.drivers.len() > 1 => {
                return Err(Refusal::because(
                    "with several coordinates a range cannot be searched: search near the values of the coordinates",
                ));
            }
            Search::Angles { from, to } if turns => Some([from, to]),
            Search::Lengths { from, to } if !turns => Some([from, to]),
            _ => {
                return Err(Refusal::because(
                    "the range does not match the coordinate: an angle requires angles, a length or a distance requires lengths",
                ));
            }
        };
        stops::refuse_several(&self.stops, &self.drivers, range.is_some())?;
        let limited = Limited::new(&self.stops, &parts);
        let (samples, mut found) = match range {
            None => (Vec::new(), vec![system.equilibrium_near(&positions).map_err(refuse)?]),
            Some(range) => {
                let samples = system.samples(&positions, range, STEPS).map_err(refuse)?;
                sheet.keep_going()?;
                let found = system.equilibria(&samples).map_err(refuse)?;
                (samples, found)
            }
        };
        let short = match (range, samples.last()) {
            (Some([_, to]), Some(last)) if (last.value - to).abs() > 1e-9 * to.abs().max(1.0) => {
                Some(last.value)
            }
            _ => None,
        };
        if let Some(end) = short {
            sheet.warn(|| {
                Text::new("the mechanism does not move beyond {end}: nothing was searched beyond it")
                    .with_quantity("end", end, self.drivers[0].what.unit())
            });
        }
        found.retain(|here| limited.permit(&system, &here.positions));
        let contacts = limited.contacts(&system, &samples).map_err(refuse)?;
        if found.is_empty() && contacts.is_empty() {
            return Err(Refusal::because(
                "there is no equilibrium in this range: the holding effort does not change sign; search a wider one",
            ));
        }
        for (number, here) in (1..).zip(&found) {
            sheet.keep_going()?;
            parts.answer(&system, here, number, sheet);
        }
        for (number, here) in (1..).zip(&contacts) {
            here.answer(&system, &parts, number, sheet);
        }
        sheet.show(|| Exhibit::Table(parts.table_of_equilibria(&found, &contacts)));
        if !samples.is_empty() {
            parts.show_energy(&system, &samples, (&found, &contacts), sheet);
        }
        sheet.show(|| Exhibit::Drawing(parts.positions_of_equilibrium(&system, &found, &contacts)));
        Ok(())
    }
}

impl Equilibrium {
    fn parts(&self) -> Result<Parts, Refusal> {
        let described = (&self.bodies[..], &self.points[..], &self.joints[..]);
        Parts::new(self.gravity, described, &self.drivers, &self.loads)
    }
}

impl Parts {
    /// The unit of the stiffness of a coordinate.
    fn of_stiffness(&self, driver: usize) -> &'static str {
        match self.drivers[driver].what {
            Driven::Angle { .. } => "N*m/rad",
            Driven::Position { .. } | Driven::Distance { .. } => "N/m",
        }
    }

    fn answer<W: Worksheet>(&self, system: &Model, here: &Found, number: usize, sheet: W) {
        let (mut shown, mut lowest) = (Vec::new(), None);
        for (driver, drive) in self.drivers.iter().enumerate() {
            // One coordinate has many equilibria, many coordinates have one.
            let row = if self.drivers.len() > 1 { driver + 1 } else { number };
            let value = sheet.numerical(
                ("q", row),
                drive.what.unit(),
                here.values[driver],
                (
                    Text::new(
                        "Value of {name} where the virtual work of all loads is zero, δW = −dV/dq δq = 0",
                    )
                    .with("name", &drive.name),
                    BEER.at("§10.8"),
                ),
            );
            sheet.answer(("coordinate", row), "Coordinate at equilibrium", value);
            sheet.row_label(("coordinate", row), &drive.name);
            let stiffness = sheet.numerical(
                ("V″", row),
                self.of_stiffness(driver),
                here.stiffness[(driver, driver)],
                (
                    Text::new(
                        "Second derivative of the potential energy with respect to {name}: {stability}",
                    )
                    .with("name", &drive.name)
                    .with_text("stability", named(here.stability)),
                    BEER.at("§10.9"),
                ),
            );
            sheet.answer(("stiffness", row), "Second derivative of the potential energy", stiffness);
            sheet.row_label(("stiffness", row), &drive.name);
            shown.push([value.value(), stiffness.value()]);
        }
        if self.drivers.len() > 1 {
            let why = "Lowest eigenvalue of the matrix of second derivatives, scaled to a diagonal of ones: positive in a stable equilibrium";
            let found = sheet.numerical("λ_1", "1", here.lowest, why);
            sheet.answer("lowest_eigenvalue", "Lowest eigenvalue of the second derivatives", found);
            lowest = Some(found);
        }
        sheet.verify(|| self.check(system, here, &shown, sheet));
        if let Some(lowest) = lowest {
            sheet.verify(|| check_eigenvalue(&here.stiffness, lowest, sheet));
        }
    }

    /// The first and second differences of the potential energy itself, about the values and for the second derivatives
    /// that are shown.
    fn check<W: Worksheet>(&self, system: &Model, here: &Found, shown: &[[f64; 2]], sheet: W) {
        for (driver, drive) in self.drivers.iter().enumerate() {
            let whole = if matches!(drive.what, Driven::Angle { .. }) { 0.02 } else { 0.02 * system.size() };
            let energies = |step: f64| -> Option<Vec<f64>> {
                let energy = |steps: f64| {
                    let mut values: Vec<f64> = shown.iter().map(|[value, _]| *value).collect();
                    values[driver] += steps * step;
                    system.potential(&system.continue_to(&here.positions, &values).ok()?.positions)
                };
                [-3.0, -2.0, -1.0, 0.0, 1.0, 2.0, 3.0].into_iter().map(energy).collect()
            };
            // Near a singular position the energy bends too sharply for the first step.
            let steps = [whole, whole / 4.0, whole / 16.0];
            let mut tried =
                steps.into_iter().filter_map(|step| Some(Differences::new(&energies(step)?, step)));
            let (mut found, mut next) = (None, tried.next());
            while let Some(differences) = next {
                next = if differences.is_resolved() { None } else { tried.next() };
                found = Some(differences);
            }
            let Some(Differences { step, slope, bend, rough_slope, rough_bend, most }) = found else {
                continue;
            };
            // Differences of the sixth order are good to 10⁻⁷ of the energies, or to what the next term changed.
            let name = |what: &'static str| Text::new(what).with("name", &drive.name);
            let slack = 100.0;
            sheet.check_residual(
                name("the derivative of the potential energy with respect to {name} is zero"),
                slope.into(),
                slack * most / step,
                (slope - rough_slope) / 8.0,
            );
            sheet.check_residual(
                name("finite differences of the potential energy reproduce the second derivative with respect to {name}"),
                (bend - shown[driver][1]).into(),
                slack * most / (step * step),
                (bend - rough_bend) / 8.0,
            );
        }
    }

    fn table_of_equilibria(&self, found: &[Found], contacts: &[StopContact<'_>]) -> TableExhibit {
        let mut columns = vec![Column { heading: "Equilibrium".into(), unit: "" }];
        for drive in &self.drivers {
            columns.push(Column { heading: verbatim(&drive.name), unit: drive.what.unit() });
        }
        columns.push(Column { heading: "Stability".into(), unit: "" });
        let row = |(number, here): (usize, &Found)| {
            let number = Cell::Text(verbatim(number));
            let values = here.values.iter().map(|value| Cell::Number(*value));
            [number].into_iter().chain(values).chain([Cell::Text(named(here.stability))]).collect()
        };
        let on_stop = |(number, here): (usize, &StopContact<'_>)| {
            let held = Text::new("held by {name}").with("name", here.name);
            vec![Cell::Text(verbatim(number)), Cell::Number(here.at.value), Cell::Text(held)]
        };
        TableExhibit {
            title: "Positions of equilibrium".into(),
            columns,
            rows: (1..).zip(found).map(row).chain((found.len() + 1..).zip(contacts).map(on_stop)).collect(),
            foot: Vec::new(),
        }
    }

    fn show_energy<W: Worksheet>(
        &self,
        system: &Model,
        samples: &[SweepSample],
        (found, contacts): (&[Found], &[StopContact<'_>]),
        sheet: W,
    ) {
        let axis = || Axis::linear(verbatim(&self.drivers[0].name), self.drivers[0].what.unit());
        let energies: Option<Vec<(f64, f64)>> =
            samples.iter().map(|sample| Some((sample.value, sample.potential?))).collect();
        if let Some(energies) = energies {
            sheet.show(|| {
                let marked = found.iter().fold(
                    Plot::new(
                        "Potential energy",
                        axis(),
                        Axis::linear("Potential energy", "J"),
                        vec![Series::line("V", energies.clone())],
                    ),
                    |plot, here| match system.potential(&here.positions) {
                        Some(energy) => plot.mark(named(here.stability), (here.values[0], energy)),
                        None => plot,
                    },
                );
                Exhibit::Plot(contacts.iter().fold(marked, |plot, here| {
                    match system.potential(&here.at.positions) {
                        Some(energy) => plot.mark(verbatim(here.name), (here.at.value, energy)),
                        None => plot,
                    }
                }))
            });
        }
        sheet.show(|| {
            let efforts = samples.iter().map(|sample| (sample.value, sample.effort)).collect();
            let (label, unit) = match self.drivers[0].what {
                Driven::Angle { .. } => ("Torque", "N*m"),
                _ => ("Force", "N"),
            };
            let plot = Plot::new(
                "Equilibrant force or torque of the mechanism",
                axis(),
                Axis::linear(label, unit),
                vec![Series::line("dV/dm", efforts)],
            )
            .level("0", 0.0);
            Exhibit::Plot(
                found.iter().fold(plot, |plot, here| plot.mark(named(here.stability), (here.values[0], 0.0))),
            )
        });
    }

    /// The bodies where they come to rest, each equilibrium in its ink.
    fn positions_of_equilibrium(
        &self,
        system: &Model,
        found: &[Found],
        contacts: &[StopContact<'_>],
    ) -> Drawing {
        let mut sketch = Sketch::new("Positions of equilibrium");
        for here in found {
            let ink = match here.stability {
                Stability::Stable => Ink::Result,
                Stability::Unstable => Ink::Danger,
                Stability::Neutral => Ink::Body,
            };
            self.outline(&here.positions, ink, &mut sketch);
        }
        for here in contacts {
            self.outline(&here.at.positions, Ink::Result, &mut sketch);
        }
        // One of them with its letters: the first that the mechanism comes to by itself.
        let stable = found.iter().find(|here| here.stability == Stability::Stable);
        if let Some(here) = stable.or(found.first()) {
            self.draw(&here.positions, self.size(system, &here.positions), &mut sketch);
        }
        sketch.finish()
    }
}

/// First and second differences of energies about a position.
struct Differences {
    step: f64,
    /// Of the sixth order.
    slope: f64,
    bend: f64,
    /// Of the fourth.
    rough_slope: f64,
    rough_bend: f64,
    /// The largest difference of the energies, or what of them rounding leaves.
    most: f64,
}

impl Differences {
    /// Of seven energies in equal steps.
    fn new(e: &[f64], step: f64) -> Self {
        let (square, middle) = (step * step, e[3]);
        let [one, two, three] = [1, 2, 3].map(|k| (e[3 + k] - e[3 - k], e[3 + k] + e[3 - k]));
        Self {
            step,
            slope: (three.0 - 9.0 * two.0 + 45.0 * one.0) / (60.0 * step),
            bend: (2.0 * three.1 - 27.0 * two.1 + 270.0 * one.1 - 490.0 * middle) / (180.0 * square),
            rough_slope: (8.0 * one.0 - two.0) / (12.0 * step),
            rough_bend: (16.0 * one.1 - two.1 - 30.0 * middle) / (12.0 * square),
            most: e.iter().fold(0.0f64, |most, x| most.max((x - middle).abs()).max(1e-7 * x.abs())),
        }
    }

    /// Returns true if the next order of differences changes little.
    fn is_resolved(&self) -> bool {
        (self.bend - self.rough_bend).abs() <= 1e-4 * self.most / (self.step * self.step)
    }
}

/// Holds the lowest eigenvalue of the second derivatives, scaled to a diagonal of ones, to the law of inertia: less
/// anything below it the matrix is positive definite, less anything above it it is not.
fn check_eigenvalue<W: Worksheet>(stiffness: &DMatrix<f64>, eigenvalue: W::Num, sheet: W) {
    let scale = |k: usize| match stiffness[(k, k)] {
        0.0 => 1.0,
        diagonal => diagonal.abs().sqrt(),
    };
    let (rows, columns) = stiffness.shape();
    let scaled = DMatrix::from_fn(rows, columns, |row, column| {
        stiffness[(row, column)] / (scale(row) * scale(column))
    });
    let bound = scaled.row_iter().map(|row| row.iter().map(|x| x.abs()).sum::<f64>()).fold(0.0, f64::max);
    let is_definite =
        |shift: f64| is_positive_definite(&scaled - DMatrix::from_diagonal_element(rows, columns, shift));
    let (mut below, mut above) = (-2.0 * bound, 2.0 * bound);
    for _ in 0..60 {
        let middle = f64::midpoint(below, above);
        *(if is_definite(middle) { &mut below } else { &mut above }) = middle;
    }
    let what = "lowest eigenvalue by Sylvester's law of inertia, where the matrix of second derivatives ceases to be positive definite";
    sheet.check_sum(what, eigenvalue, f64::midpoint(below, above).into(), bound);
}

/// Returns true if all pivots of a symmetric matrix are positive.
fn is_positive_definite(mut left: DMatrix<f64>) -> bool {
    let order = left.nrows();
    (0..order).all(|pivot| {
        let of_pivot = left[(pivot, pivot)];
        for row in pivot + 1..order {
            let part = left[(row, pivot)] / of_pivot;
            for column in pivot + 1..order {
                left[(row, column)] -= part * left[(pivot, column)];
            }
        }
        of_pivot > 0.0
    })
}

fn named(stability: Stability) -> Text {
    match stability {
        Stability::Stable => "stable",
        Stability::Unstable => "unstable",
        Stability::Neutral => "neutral",
    }
    .into()
}
