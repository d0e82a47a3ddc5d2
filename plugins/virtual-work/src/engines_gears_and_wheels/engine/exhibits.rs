//! Plots and the table of the models.

use std::f64::consts::TAU;

use dalembert_core::{Axis, Cell, Column, Plot, Series, TableExhibit, Text, exhibit::Point};
use dalembert_mechanics::slider_crank::{
    CrankMotion,
    engine::{EngineCylinder as Kernel, Forces, PistonFormula},
};

use super::{
    Engine,
    cycle::{self, Turned},
    gas::GasCycle,
};

/// Points of a turn.
const POINTS: u32 = 180;

/// Data of the plots.
pub(super) struct View<'a> {
    pub engine: &'a Engine,
    pub kernel: &'a Kernel,
    pub crank: CrankMotion,
    /// Of the piston, where it is given in place of a speed.
    pub given_acceleration: Option<f64>,
    pub running: bool,
    /// The gas, where its whole cycle is known.
    pub gas: Option<&'a GasCycle>,
    /// The force on the piston at the crank angle, where there are forces.
    pub force: Option<f64>,
    pub cycle: Option<&'a Turned>,
}

impl View<'_> {
    /// Angles of a cycle, from its start.
    fn angles(&self) -> Vec<f64> {
        let turns = self.gas.map_or(1, |gas| u32::from(gas.diagram.turns()));
        (0..=POINTS * turns).map(|k| TAU * f64::from(k) / f64::from(POINTS)).collect()
    }

    pub(super) fn at(&self, angle: f64) -> (f64, Forces) {
        cycle::at(self.kernel, self.gas, CrankMotion { angle, acceleration: 0.0, ..self.crank })
    }

    fn curve(&self, label: &'static str, of: impl Fn(f64, &Forces) -> f64) -> Series {
        let point = |angle: f64| {
            let (gas, forces) = self.at(angle);
            (angle, of(gas, &forces))
        };
        Series::line(label, self.angles().into_iter().map(point).collect())
    }

    /// The same engine in all models that hold for it.
    fn all_models(&self) -> Vec<(&'static str, Kernel)> {
        let with = |model: PistonFormula| Kernel { model, ..self.kernel.clone() };
        let mut models = vec![("Exact", with(PistonFormula::Exact))];
        if self.kernel.offset == 0.0 {
            models.push(("Two terms", with(PistonFormula::TwoTerm)));
            let harmonics = match &self.kernel.model {
                PistonFormula::Harmonics(all) => PistonFormula::Harmonics(all.clone()),
                _ => PistonFormula::up_to(6, self.kernel.rod / self.kernel.crank),
            };
            models.push(("Harmonics", with(harmonics)));
        }
        models
    }

    /// Every model's motion, effort and moment at the crank angle.
    pub(super) fn models(&self) -> TableExhibit {
        let models = self.all_models();
        let mut columns = vec![Column { heading: "Quantity".into(), unit: "" }];
        columns.extend(models.iter().map(|(name, _)| Column { heading: (*name).into(), unit: "" }));
        let found: Vec<_> = models
            .iter()
            .map(|(_, kernel)| {
                let motion = kernel.motion(self.crank);
                let force = match self.gas {
                    Some(gas) => {
                        gas.force(self.crank.angle, motion.displacement / kernel.stroke(), motion.arm >= 0.0)
                    }
                    None => self.force.unwrap_or(0.0),
                };
                (motion, kernel.forces(self.crank, &motion, force))
            })
            .collect();
        let row = |name: &'static str, unit: &'static str, numbers: Vec<f64>| {
            let cell = |si: f64| Cell::Text(Text::new("{x}").with_quantity("x", si, unit));
            std::iter::once(Cell::from(name)).chain(numbers.into_iter().map(cell)).collect()
        };
        let mut rows: Vec<Vec<Cell>> = vec![
            row("Displacement of the piston", "mm", found.iter().map(|it| it.0.displacement).collect()),
            row("Velocity of the piston", "m/s", found.iter().map(|it| it.0.velocity).collect()),
            row("Acceleration of the piston", "m/s^2", found.iter().map(|it| it.0.acceleration).collect()),
            row("Angular velocity of the rod", "rad/s", found.iter().map(|it| it.0.rod_speed).collect()),
            row(
                "Angular acceleration of the rod",
                "rad/s^2",
                found.iter().map(|it| it.0.rod_acceleration).collect(),
            ),
        ];
        if self.force.is_some() {
            rows.push(row("Net piston effort", "N", found.iter().map(|it| it.1.effort).collect()));
            rows.push(row(
                "Turning moment on the crankshaft",
                "N*m",
                found.iter().map(|it| it.1.moment).collect(),
            ));
        }
        TableExhibit {
            title: "Motion and turning moment by all formulas".into(),
            columns,
            rows,
            foot: Vec::new(),
        }
    }

    /// Acceleration of the piston over a turn.
    pub(super) fn accelerations(&self) -> Plot {
        let curve = |(name, kernel): (&'static str, Kernel)| {
            let is_asked = kernel.model == self.kernel.model;
            let at = |k: u32| {
                let angle = TAU * f64::from(k) / f64::from(POINTS);
                let crank = CrankMotion { angle, acceleration: 0.0, ..self.crank };
                (angle, kernel.motion(crank).acceleration)
            };
            let series = Series::line(name, (0..=POINTS).map(at).collect());
            if is_asked { steady(series.of("acceleration")) } else { series }
        };
        Plot::new(
            "Acceleration of the piston at this speed",
            Axis::linear("Crank angle", "deg"),
            Axis::linear("Acceleration, towards the crank", "m/s^2"),
            self.all_models().into_iter().map(curve).collect(),
        )
        .over("angle")
    }

    /// Forces along the stroke.
    pub(super) fn efforts(&self) -> Plot {
        let net = self.curve("net effort", |_, forces| forces.effort);
        let (x, y) = (Axis::linear("Crank angle", "deg"), Axis::linear("Force towards the crank", "N"));
        if self.cycle.is_none() {
            let title = "Forces along the stroke without the gas force, which is known only at this angle";
            return Plot::new(title, x, y, vec![net]);
        }
        let mut series = Vec::new();
        if self.gas.is_some() {
            series.push(steady(self.curve("gas", |gas, _| gas).of("piston_force")));
            series.push(self.curve("inertia, weight and friction", |gas, forces| forces.effort - gas));
        }
        series.push(steady(net.of("effort")));
        Plot::new("Forces along the stroke over the cycle", x, y, series).over("angle")
    }

    /// The turning moment.
    pub(super) fn moments(&self) -> Plot {
        let curve = self.curve("turning moment", |_, forces| forces.moment);
        let (x, y) = (Axis::linear("Crank angle", "deg"), Axis::linear("Turning moment", "N*m"));
        let Some(turned) = self.cycle else {
            let title = "Turning moment without the gas, which is known only at this angle";
            return Plot::new(title, x, y, vec![curve]);
        };
        let series = vec![steady(curve.of("turning_moment"))];
        let angle = self.crank.angle.rem_euclid(turned.period);
        Plot::new("Turning moment over the cycle", x, y, series)
            .over("angle")
            .level("mean", turned.cycle.mean)
            .mark("at this angle", (angle, self.at(angle).1.moment))
    }

    /// The force at the crank pin in axes that turn with the crank.
    pub(super) fn crank_pin(&self) -> Plot {
        let points = self.loop_of(|forces| (-forces.radial, forces.tangential));
        Plot::new(
            "Force at the crank pin, in axes of the crank",
            Axis::linear("outward along the crank", "N"),
            Axis::linear("along its motion", "N"),
            vec![Series::line("over the cycle", points)],
        )
        .equal()
    }

    /// The force on the main bearings in axes of the frame.
    pub(super) fn bearing(&self) -> Plot {
        let points = self.loop_of(|forces| (forces.bearing[0], forces.bearing[1]));
        Plot::new(
            "Force on the main bearings, in axes of the frame",
            Axis::linear("along the stroke, towards the cylinder", "N"),
            Axis::linear("across the stroke", "N"),
            vec![Series::line("over the cycle", points)],
        )
        .equal()
    }

    fn loop_of(&self, of: impl Fn(&Forces) -> Point) -> Vec<Point> {
        self.angles().into_iter().map(|angle| of(&self.at(angle).1)).collect()
    }
}

/// A curve of the engine at a steady speed.
fn steady(series: Series) -> Series {
    series.with("motion.running.acceleration", 0.0)
}
