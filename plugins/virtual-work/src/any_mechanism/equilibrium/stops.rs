//! Stops: cords, straps, buffers and contacts that limit how far a mechanism moves, and hold it by one side only.

use dalembert_core::{Inputs, Reference, Refusal, Text, Worksheet};
use dalembert_mechanics::{
    Real,
    planar::{Model, PlanarError, RelativeCoordinate, StopPosition, SweepSample},
};

use super::Differences;
use crate::{
    shared::parts::{Drive, Driven, PartReference, Parts},
    sources::BEER,
};

/// A limit of the motion. It transmits a force only where the mechanism presses against it.
#[derive(Clone, Debug, Inputs)]
pub struct Stop {
    /// Name.
    #[input(default = "")]
    pub name: String,
    /// Kind of stop.
    pub limit: Limit,
}

/// Kind and place of a stop.
#[derive(Clone, Debug, Inputs)]
pub enum Limit {
    /// Cord or strap: largest distance between two points
    Cord {
        /// From.
        #[input(rows = "points")]
        from: Reference,
        /// To.
        #[input(rows = "points")]
        to: Reference,
        /// Length.
        #[input("L_s", "mm", positive)]
        length: f64,
    },
    /// Buffer: smallest distance between two points
    Buffer {
        /// From.
        #[input(rows = "points")]
        from: Reference,
        /// To.
        #[input(rows = "points")]
        to: Reference,
        /// Distance.
        #[input("d_s", "mm", positive)]
        distance: f64,
    },
    /// Contact of a point with a straight edge, to the left of it
    Edge {
        /// Point of the edge.
        #[input(rows = "points")]
        guide: Reference,
        /// Direction of the edge, in the axes of its body.
        #[input("φ_s", "deg", default = "0 deg")]
        direction: f64,
        /// Point.
        #[input(rows = "points")]
        point: Reference,
    },
    /// Smallest angle of a body
    SmallestAngle {
        /// Body.
        #[input(rows = "bodies")]
        body: Reference,
        /// Body relative to which it turns.
        #[input(default = "ground")]
        against: PartReference,
        /// Angle.
        #[input("θ_s", "deg")]
        angle: f64,
    },
    /// Largest angle of a body
    LargestAngle {
        /// Body.
        #[input(rows = "bodies")]
        body: Reference,
        /// Body relative to which it turns.
        #[input(default = "ground")]
        against: PartReference,
        /// Angle.
        #[input("θ_s", "deg")]
        angle: f64,
    },
}

/// A stop as a limit of a measure: it holds `sign (c − limit) ≥ 0` by an effort of that sign along the measure c.
struct Unilateral<'a> {
    name: &'a str,
    measure: RelativeCoordinate,
    limit: f64,
    sign: f64,
}

/// A position in which the mechanism rests on a stop.
pub(super) struct StopContact<'a> {
    /// The name of the stop.
    pub(super) name: &'a str,
    pub(super) at: StopPosition,
    measure: RelativeCoordinate,
    limit: f64,
}

/// Stops of a mechanism with one coordinate.
pub(super) struct Limited<'a> {
    stops: Vec<Unilateral<'a>>,
}

impl<'a> Limited<'a> {
    pub(super) fn new(stops: &'a [Stop], parts: &Parts) -> Self {
        let stops = stops.iter().map(|stop| stop.unilateral(parts)).collect();
        Self { stops }
    }

    /// Returns true if no stop is passed.
    pub(super) fn permit(&self, system: &Model, positions: &[[f64; 3]]) -> bool {
        self.stops.iter().all(|stop| {
            let size = if stop.measure.is_angle() { 1.0 } else { system.size() };
            stop.sign * (system.value(&stop.measure, positions) - stop.limit) >= -1e-9 * size
        })
    }

    /// The positions in which the mechanism presses against a stop, and passes none.
    pub(super) fn contacts(
        &self,
        system: &Model,
        samples: &[SweepSample],
    ) -> Result<Vec<StopContact<'a>>, PlanarError> {
        let mut contacts = Vec::new();
        for stop in &self.stops {
            let there = system.stop_positions(samples, &stop.measure, stop.limit)?;
            let pressed =
                |at: &StopPosition| at.effort * stop.sign > 0.0 && self.permit(system, &at.positions);
            let (measure, limit) = (stop.measure, stop.limit);
            contacts.extend(there.into_iter().filter(pressed).map(|at| StopContact {
                name: stop.name,
                at,
                measure,
                limit,
            }));
        }
        Ok(contacts)
    }
}

impl Stop {
    fn unilateral<'a>(&'a self, parts: &Parts) -> Unilateral<'a> {
        let (measure, limit, sign) = match self.limit {
            Limit::Cord { from, to, length } => (parts.distance(from, to), length, -1.0),
            Limit::Buffer { from, to, distance } => (parts.distance(from, to), distance, 1.0),
            Limit::Edge { guide, direction, point } => {
                (parts.along(guide, point, direction + std::f64::consts::FRAC_PI_2), 0.0, 1.0)
            }
            Limit::SmallestAngle { body, ref against, angle } => {
                (RelativeCoordinate::Angle { of: Some(body.0), against: against.frame() }, angle, 1.0)
            }
            Limit::LargestAngle { body, ref against, angle } => {
                (RelativeCoordinate::Angle { of: Some(body.0), against: against.frame() }, angle, -1.0)
            }
        };
        Unilateral { name: &self.name, measure, limit, sign }
    }
}

impl StopContact<'_> {
    /// Answers the coordinate and the force of the stop.
    pub(super) fn answer<W: Worksheet>(&self, system: &Model, parts: &Parts, number: usize, sheet: W) {
        let drive = &parts.drivers[0];
        let named =
            |reason: &'static str| Text::new(reason).with("name", self.name).with("coordinate", &drive.name);
        let value = sheet.numerical(
            ("q_s", number),
            drive.what.unit(),
            self.at.value,
            named(
                "Value of {coordinate} where {name} is reached, and the loads press the mechanism against it",
            ),
        );
        sheet.answer(("stop_coordinate", number), "Coordinate at rest on the stop", value);
        sheet.row_label(("stop_coordinate", number), self.name);
        let unit = if self.measure.is_angle() { "N*m" } else { "N" };
        let why = named("Force or couple of {name}, by virtual work: Q δc = δV, Q = (dV/dm)/(dc/dm)");
        let effort = sheet.numerical(("Q_s", number), unit, self.at.effort.abs(), (why, BEER.at("§10.8")));
        sheet.answer(("stop_force", number), "Force of the stop", effort);
        sheet.row_label(("stop_force", number), self.name);
        let whole = if matches!(drive.what, Driven::Angle { .. }) { 1.0 } else { system.size() };
        sheet.verify(|| {
            let there = system.continue_to(&self.at.positions, &[value.value()]);
            let apart =
                there.map_or(f64::NAN, |there| system.value(&self.measure, &there.positions) - self.limit);
            let size = if self.measure.is_angle() { 1.0 } else { system.size() };
            let what = named("with that value, the closed mechanism lies at the limit of {name}");
            sheet.check_zero(what, apart.into(), size);
            self.check(system, 0.005 * whole, effort, sheet);
        });
    }

    /// The energy over the measure of the stop, by differences of both.
    fn check<W: Worksheet>(&self, system: &Model, step: f64, effort: W::Num, sheet: W) {
        let of = |function: &dyn Fn(&[[f64; 3]]) -> Option<f64>| -> Option<Differences> {
            let at = |steps: i32| {
                let value = self.at.value + f64::from(steps) * step;
                function(&system.continue_to(&self.at.positions, &[value]).ok()?.positions)
            };
            Some(Differences::new(&(-3..=3).map(at).collect::<Option<Vec<_>>>()?, step))
        };
        let energy = of(&|positions| system.potential(positions));
        let measure = of(&|positions| Some(system.value(&self.measure, positions)));
        if let (Some(energy), Some(measure)) = (energy, measure) {
            let force = (energy.slope / measure.slope).abs();
            let error = (energy.slope - energy.rough_slope) / (8.0 * measure.slope);
            let what = Text::new(
                "force of {name} from finite differences of the potential energy and of what it limits",
            );
            let apart = (effort.value() - force).into();
            sheet.check_residual(what.with("name", self.name), apart, 100.0 * force, error);
        }
    }
}

/// Refuses stops where there are several coordinates, or no range in which they are sought.
pub(super) fn refuse_several(stops: &[Stop], coordinates: &[Drive], searched: bool) -> Result<(), Refusal> {
    if !stops.is_empty() && (coordinates.len() > 1 || !searched) {
        return Err(Refusal::because(
            "stops are found over a range of a single coordinate: search between two values of it",
        ));
    }
    Ok(())
}
