//! Half a vehicle: a body on two suspensions, two wheels on their tyres.

use std::f64::consts::TAU;

use dalembert_core::{
    About, Analysis, Animation, Drawing, DrawnShape, Exhibit, Ink, Inputs, Refusal, Text, Worksheet, register,
};
use dalembert_mechanics::Real;
use nalgebra::DMatrix;

use crate::{
    shared::system::{
        Assembled,
        damping::{Damping, DampingGiven, in_modes},
        modal_properties::modal_properties,
        modes::{find, largest_one},
    },
    sources::RAO,
};

/// The vehicle, seen from the side.
#[derive(Clone, Debug, Inputs)]
pub struct HalfCar {
    /// Mass of the body.
    #[input("m", "kg", positive)]
    pub body: f64,
    /// Moment of inertia of the body in pitch.
    /// About its centre of mass.
    #[input("J", "kg*m^2", positive)]
    pub inertia: f64,
    /// Front axle.
    #[input("f")]
    pub front: Axle,
    /// Rear axle.
    #[input("r")]
    pub rear: Axle,
}

/// An axle: suspension, wheel and tyre.
#[derive(Clone, Debug, Inputs)]
pub struct Axle {
    /// Distance from the centre of mass of the body.
    #[input("l", "m", positive)]
    pub distance: f64,
    /// Stiffness of the suspension.
    #[input("k", "N/m", positive)]
    pub stiffness: f64,
    /// Damping of the suspension.
    #[input("c", "N*s/m", nonnegative)]
    pub damping: f64,
    /// Mass of wheel and axle.
    #[input("m_w", "kg", positive)]
    pub wheel: f64,
    /// Stiffness of the tyre.
    #[input("k_t", "N/m", positive)]
    pub tyre: f64,
}

register!(HalfCar);

impl Analysis for HalfCar {
    const ABOUT: About = About {
        id: "vibration/half-car",
        title: "Half-car model",
        topic: "Several degrees of freedom",
        summary: "Bounce, pitch and wheel hop of a vehicle seen from the side: natural frequencies, modes and damping ratios of four degrees of freedom.",
        keywords: "vehicle suspension wheel hop bounce pitch tyre ride four degrees veículo suspensão meio carro \
                   arfagem pneu roda salto quatro graus de liberdade",
        sources: &[&RAO],
        cases: include_str!("../../cases/half_car.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &HalfCarGiven<W>, sheet: W) -> Result<(), Refusal> {
        let (front, rear) = (&given.front, &given.rear);
        let base = sheet.step("l", "m", front.distance + rear.distance, "Wheelbase");
        let why = "Effective body mass at an axle that moves while the other is at rest: T = (m ẏ² + J θ̇²)/2 with y = (l_r u_f + l_f u_r)/l, θ = (u_r − u_f)/l";
        let own = |symbol: &'static str, distance: W::Num| {
            sheet.step(symbol, "kg", (given.body * distance.powi(2) + given.inertia) / base.powi(2), why)
        };
        let m11 = own("M₁₁", rear.distance);
        let m22 = own("M₂₂", front.distance);
        let m12 = sheet.step(
            "M₁₂",
            "kg",
            (given.body * front.distance * rear.distance - given.inertia) / base.powi(2),
            (
                "Inertia coupling of the two ends; zero if J = m l_f l_r: front and rear are then uncoupled",
                RAO.at("§5.5"),
            ),
        );
        let [m11, m12, m22] = [m11, m12, m22].map(Real::value);
        let [wf, wr] = [self.front.wheel, self.rear.wheel];
        let mass = DMatrix::from_row_slice(
            4,
            4,
            &[m11, m12, 0.0, 0.0, m12, m22, 0.0, 0.0, 0.0, 0.0, wf, 0.0, 0.0, 0.0, 0.0, wr],
        );
        let links = |front: f64, rear: f64, front_ground: f64, rear_ground: f64| {
            DMatrix::from_row_slice(
                4,
                4,
                &[
                    front,
                    0.0,
                    -front,
                    0.0,
                    0.0,
                    rear,
                    0.0,
                    -rear,
                    -front,
                    0.0,
                    front + front_ground,
                    0.0,
                    0.0,
                    -rear,
                    0.0,
                    rear + rear_ground,
                ],
            )
        };
        let stiffness = links(self.front.stiffness, self.rear.stiffness, self.front.tyre, self.rear.tyre);
        let damping = links(self.front.damping, self.rear.damping, 0.0, 0.0);
        let system = Assembled { mass, damping, stiffness, two: None, parallel: true };
        let found = find(&system, sheet)?;
        let damped = in_modes(
            &Damping::Dampers,
            &DampingGiven::Dampers {},
            &system.damping,
            &system.mass,
            &found.modes,
            sheet,
        )?;
        let shapes: Vec<Vec<f64>> =
            found.modes.shapes.column_iter().map(|shape| largest_one(shape.as_slice())).collect();
        for (mode, frequency) in found.frequencies.iter().enumerate() {
            sheet.answer(("frequency", mode + 1), "Natural frequency", *frequency);
            sheet.answer_list(
                ("mode", mode + 1),
                "Mode shape: body front, body rear, wheel front, wheel rear",
                "1",
                &shapes[mode],
            );
        }
        modal_properties(&system, &found, &damped, &shapes, sheet)?;
        sheet.show(|| {
            Exhibit::Drawing(Drawing { title: "The half-car".into(), shapes: self.shapes([0.0; 4]) })
        });
        for (mode, shape) in shapes.iter().enumerate() {
            sheet.show(|| {
                let frames = (0..24).map(|frame| {
                    let now = 0.12
                        * (self.front.distance + self.rear.distance)
                        * (TAU * f64::from(frame) / 24.0).cos();
                    self.shapes([0, 1, 2, 3].map(|row| shape[row] * now))
                });
                Exhibit::Animation(Animation::new(
                    Text::new("Mode {mode}").with("mode", mode + 1),
                    frames.collect(),
                    2.0,
                ))
            });
        }
        Ok(())
    }
}

impl HalfCar {
    /// The vehicle with the ends of its body and its wheels moved up by so much.
    fn shapes(&self, [front, rear, front_wheel, rear_wheel]: [f64; 4]) -> Vec<DrawnShape> {
        let (a, b) = (-self.front.distance, self.rear.distance);
        let size = b - a;
        let (road, axle, body) = (-0.6 * size, -0.35 * size, 0.0);
        let mut shapes = vec![DrawnShape::Ground((a - 0.2 * size, road), (b + 0.2 * size, road))];
        for (x, end, wheel) in [(a, front, front_wheel), (b, rear, rear_wheel)] {
            shapes.push(DrawnShape::Spring((x, road), (x, axle + wheel)));
            shapes.push(DrawnShape::Circle((x, axle + wheel), 0.06 * size, Ink::Body));
            shapes.push(DrawnShape::Spring((x - 0.04 * size, axle + wheel), (x - 0.04 * size, body + end)));
            shapes.push(DrawnShape::Damper((x + 0.04 * size, axle + wheel), (x + 0.04 * size, body + end)));
        }
        let middle = front + (rear - front) * -a / size;
        shapes.push(DrawnShape::Polyline(vec![(a - 0.1 * size, body), (b + 0.1 * size, body)], Ink::Faint));
        shapes.push(DrawnShape::Polyline(vec![(a, body + front), (b, body + rear)], Ink::Body));
        shapes.push(DrawnShape::Circle((0.0, body + middle), 0.02 * size, Ink::Result));
        shapes
    }
}
