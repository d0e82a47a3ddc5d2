//! Bounce and pitch of a rigid bar on two springs: a vehicle body, a machine frame.

use std::f64::consts::TAU;

use dalembert_core::{About, Analysis, Exhibit, Inputs, Refusal, Sketch, Text, Worksheet, register};
use dalembert_mechanics::{Real, vibration::modes::natural_modes};
use nalgebra::{DMatrix, DVector};

use crate::{
    shared::{
        oscillator::{Mass, MassGiven},
        system::{
            modes::{agreement, refusal},
            two_degrees,
        },
    },
    sources::RAO,
};

/// The bar and its springs.
#[derive(Clone, Debug, Inputs)]
pub struct BarOnTwoSprings {
    /// Mass of the bar.
    pub body: Mass,
    /// Moment of inertia about the centre of mass.
    pub inertia: BarInertia,
    /// Front spring.
    #[input("k_f", "N/m", positive)]
    pub front: f64,
    /// Rear spring.
    #[input("k_r", "N/m", positive)]
    pub rear: f64,
    /// Front spring ahead of the centre of mass.
    /// Negative if it is behind it.
    #[input("a", "m")]
    pub front_distance: f64,
    /// Rear spring behind the centre of mass.
    /// Negative if it is ahead of it.
    #[input("b", "m")]
    pub rear_distance: f64,
}

/// Rotational inertia of the bar.
#[derive(Clone, Debug, Inputs)]
pub enum BarInertia {
    /// Moment of inertia given
    Moment {
        /// Moment of inertia.
        #[input("J", "kg*m^2", positive)]
        moment: f64,
    },
    /// Radius of gyration given
    Radius {
        /// Radius of gyration.
        #[input("i", "m", positive)]
        radius: f64,
    },
    /// Slender uniform bar
    Slender {
        /// Length of the bar.
        #[input("L", "m", positive)]
        length: f64,
    },
}

register!(BarOnTwoSprings);

impl Analysis for BarOnTwoSprings {
    const ABOUT: About = About {
        id: "vibration/bar-on-two-springs",
        title: "Bar on two springs",
        topic: "Free vibration",
        summary: "Natural frequencies of bounce and pitch of a rigid body on two springs, and the nodes about which it oscillates.",
        main: &["frequency"],
        keywords: "bounce pitch vehicle car body two degrees coupling node oscillation centre veículo arfagem \
                   quique barra duas molas centro de oscilação dois graus de liberdade",
        sources: &[&RAO],
        cases: include_str!("../../cases/bar_on_two_springs.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &BarOnTwoSpringsGiven<W>, sheet: W) -> Result<(), Refusal> {
        if self.front_distance + self.rear_distance <= 0.0 {
            return Err(Refusal::because(
                "the rear spring is not behind the front one, so pitch is unrestrained; write distances whose sum is above zero",
            ));
        }
        let mass = match &given.body {
            MassGiven::Mass { mass } => *mass,
            MassGiven::Weight { weight, gravity } => {
                sheet.step("m", "kg", *weight / *gravity, "Mass of this weight")
            }
        };
        let moment = match &given.inertia {
            BarInertiaGiven::Moment { moment } => *moment,
            BarInertiaGiven::Radius { radius } => {
                let disc = || mass * radius.powi(2) / 2.0;
                sheet.common_error("J", "the radius of gyration taken as the radius of a solid disc", disc);
                sheet.step("J", "kg*m^2", mass * radius.powi(2), "Moment of inertia about the centre of mass")
            }
            BarInertiaGiven::Slender { length } => {
                let about_end = || mass * length.powi(2) / 3.0;
                sheet.common_error("J", "the moment of inertia about the end of the rod taken", about_end);
                sheet.step(
                    "J",
                    "kg*m^2",
                    mass * length.powi(2) / 12.0,
                    "Moment of inertia of a slender uniform bar about its centre",
                )
            }
        };
        let (front, rear, a, b) = (given.front, given.rear, given.front_distance, given.rear_distance);
        let up = sheet.step(
            "K₁₁",
            "N/m",
            front + rear,
            ("Force on the bar for a unit displacement of its centre of mass", RAO.at("§5.5")),
        );
        let mixed = sheet.step(
            "K₁₂",
            "N/rad",
            rear * b - front * a,
            "Moment for that displacement, and force for a unit rotation that lowers the front",
        );
        let middle = || (front + rear) * ((a + b) / 2.0).powi(2);
        sheet.common_error("K₂₂", "both arms taken as half the distance between the springs", middle);
        let turning =
            sheet.step("K₂₂", "N*m/rad", front * a.powi(2) + rear * b.powi(2), "Moment for a unit rotation");
        let carried = || [front * (a + b) / (mass * b), rear * (a + b) / (mass * a)].map(Real::sqrt);
        let what = "each spring taken alone with the mass that it carries at rest";
        sheet.common_error(("ω", 1), what, || carried()[0].min(carried()[1]));
        sheet.common_error(("ω", 2), what, || carried()[0].max(carried()[1]));
        let two = two_degrees::solve([mass, moment], [up, mixed, turning], "rad/m", sheet)?;
        for (mode, frequency) in two.frequencies.iter().enumerate() {
            sheet.answer(("frequency", mode + 1), "Natural frequency", *frequency);
        }
        let mut nodes = [None; 2];
        match two.ratios {
            Some(ratios) => {
                for (mode, ratio) in ratios.into_iter().enumerate() {
                    if ratio.value() == 0.0 {
                        continue;
                    }
                    let elastic_centre = || mixed / up;
                    let what = "the elastic centre of the springs taken as the node";
                    sheet.common_error(("x", mode + 1), what, elastic_centre);
                    let node = sheet.step(
                        ("x", mode + 1),
                        "m",
                        -W::Num::from(1.0) / ratio,
                        ("Node: the point behind the centre of mass that remains at rest, y + θx = 0", RAO.at("§5.5")),
                    );
                    sheet.answer(("node", mode + 1), "Node behind the centre of mass", node);
                    nodes[mode] = Some(node);
                }
            }
            None => sheet.warn(|| {
                Text::new(
                    "both springs resist a displacement of the centre of mass without a moment: bounce and pitch are uncoupled",
                )
            }),
        }
        if let [Some(first), Some(second)] = nodes {
            // The two nodes are centre of oscillation and of suspension to each other.
            sheet.check(
                "the product of the distances of the two nodes is the square of the radius of gyration",
                -(first * second),
                moment / mass,
            );
        }
        let matrices = (
            DMatrix::from_diagonal(&DVector::from_column_slice(&[mass.value(), moment.value()])),
            DMatrix::from_row_slice(2, 2, &[up.value(), mixed.value(), mixed.value(), turning.value()]),
        );
        let modes = natural_modes(&matrices.0, &matrices.1).map_err(refusal)?;
        sheet.verify(|| agreement(&two, &modes, sheet));
        sheet.show(|| {
            let mut sketch = self.sketch([0.0; 2]).titled("The bar on its springs");
            sketch.dimension("a", (-self.front_distance, 0.0), (0.0, 0.0), 3.0).dimension(
                "b",
                (0.0, 0.0),
                (self.rear_distance, 0.0),
                3.0,
            );
            let low = -0.2 * (self.front_distance + self.rear_distance);
            match self.body {
                Mass::Mass { .. } => sketch.label("m", (0.0, 0.0)),
                Mass::Weight { .. } => sketch.force("W", (0.0, 0.0), (0.0, low)),
            };
            let end = (-self.front_distance, 0.0);
            match self.inertia {
                BarInertia::Moment { .. } => sketch.label("J", (0.5 * self.rear_distance, 0.0)),
                BarInertia::Radius { .. } => sketch.label("i", (0.5 * self.rear_distance, 0.0)),
                BarInertia::Slender { .. } => sketch.dimension("L", end, (self.rear_distance, 0.0), 5.0),
            };
            Exhibit::Drawing(sketch.finish())
        });
        for mode in 0..2 {
            let (y, turn) = (modes.shapes[(0, mode)], modes.shapes[(1, mode)]);
            let ends = [y - turn * self.front_distance, y + turn * self.rear_distance];
            let largest = ends[0].abs().max(ends[1].abs());
            sheet.show(|| {
                let frames = (0..24).map(|frame| {
                    let swing = 0.15 * (self.front_distance + self.rear_distance) / largest;
                    let now = swing * (TAU * f64::from(frame) / 24.0).cos();
                    self.sketch(ends.map(|end| end * now))
                });
                Exhibit::Animation(Sketch::animation(
                    Text::new("Mode {mode}").with("mode", mode + 1),
                    frames,
                    2.0,
                ))
            });
        }
        Ok(())
    }
}

impl BarOnTwoSprings {
    /// The bar with its ends moved up by so much.
    fn sketch(&self, ends: [f64; 2]) -> Sketch {
        let (a, b) = (self.front_distance, self.rear_distance);
        let size = a + b;
        let low = -0.5 * size;
        let middle = ends[0] + (ends[1] - ends[0]) * a / size;
        let mut sketch = Sketch::default();
        sketch
            .ground((-a - 0.15 * size, low), (b + 0.15 * size, low))
            .spring("k_f", (-a, low), (-a, ends[0]))
            .spring("k_r", (b, low), (b, ends[1]))
            .axis((-a, 0.0), (b, 0.0))
            .bars([(-a, ends[0]), (b, ends[1])])
            .mass_centre("G", (0.0, middle));
        sketch
    }
}
