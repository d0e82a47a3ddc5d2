//! Half a vehicle: a body on two suspensions, two wheels on their tyres.

use std::f64::consts::TAU;

use dalembert_core::{About, Analysis, Exhibit, Inputs, Refusal, Sketch, Text, Worksheet, register};
use dalembert_mechanics::{Real, sdof};
use nalgebra::DMatrix;

use crate::{
    shared::system::{
        Assembled,
        damping::{SystemDamping, SystemDampingGiven, in_modes},
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
        main: &["frequency"],
        keywords: "vehicle suspension wheel hop bounce pitch tyre ride four degrees veículo suspensão meio carro \
                   arfagem pneu roda salto quatro graus de liberdade unsprung mass sprung mass massa não \
                   suspensa suspensão veicular",
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
        frequency_errors(given, sheet);
        let found = find(&system, sheet)?;
        let damped = in_modes(
            &SystemDamping::Dampers,
            &SystemDampingGiven::Dampers {},
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
            let mut sketch = self.sketch([0.0; 4]).titled("The half-car");
            let (front, rear) = (self.front.distance, self.rear.distance);
            let top = 0.28 * (front + rear);
            sketch.dimension("l_f", (-front, top), (0.0, top), 1.5).dimension(
                "l_r",
                (0.0, top),
                (rear, top),
                1.5,
            );
            Exhibit::Drawing(sketch.finish())
        });
        for (mode, shape) in shapes.iter().enumerate() {
            sheet.show(|| {
                let frames = (0..24).map(|frame| {
                    let now = 0.12
                        * (self.front.distance + self.rear.distance)
                        * (TAU * f64::from(frame) / 24.0).cos();
                    self.sketch([0, 1, 2, 3].map(|row| shape[row] * now))
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

/// Common errors in the natural frequencies: parts of the vehicle by themselves.
fn frequency_errors<W: Worksheet>(given: &HalfCarGiven<W>, sheet: W) {
    let (front, rear) = (&given.front, &given.rear);
    // The lower of two frequencies is that of the given mode, the higher one that of the next.
    let pair = |lowest: usize, what: &'static str, of: &dyn Fn() -> [W::Num; 2]| {
        let ends = |choose: fn(W::Num, W::Num) -> W::Num| {
            let [a, b] = of();
            choose(a, b)
        };
        sheet.common_error(("ω", lowest), what, || ends(Real::min));
        sheet.common_error(("ω", lowest + 1), what, || ends(Real::max));
    };
    let bounce_and_pitch = |[k_f, k_r]: [W::Num; 2]| {
        let pitch = k_f * front.distance.powi(2) + k_r * rear.distance.powi(2);
        [sdof::natural_frequency(k_f + k_r, given.body), sdof::natural_frequency(pitch, given.inertia)]
    };
    let in_series = |axle: &AxleGiven<W>| axle.stiffness * axle.tyre / (axle.stiffness + axle.tyre);
    pair(1, "the tyres taken as rigid, and bounce and pitch as uncoupled", &|| {
        bounce_and_pitch([front.stiffness, rear.stiffness])
    });
    pair(1, "the masses of the wheels neglected, and bounce and pitch taken as uncoupled", &|| {
        bounce_and_pitch([in_series(front), in_series(rear)])
    });
    pair(3, "the wheel taken on its tyre alone, without the suspension", &|| {
        [front, rear].map(|axle| sdof::natural_frequency(axle.tyre, axle.wheel))
    });
}

impl HalfCar {
    fn sketch(&self, [front, rear, front_wheel, rear_wheel]: [f64; 4]) -> Sketch {
        let (a, b) = (-self.front.distance, self.rear.distance);
        let size = b - a;
        let (road, axle) = (-0.85 * size, -0.55 * size);
        let mut sketch = Sketch::default();
        sketch.ground((a - 0.3 * size, road), (b + 0.3 * size, road));
        let ends = [
            (a, front, front_wheel, ["k_f", "c_f", "m_w_f", "k_t_f"]),
            (b, rear, rear_wheel, ["k_r", "c_r", "m_w_r", "k_t_r"]),
        ];
        for (x, end, wheel, [spring, damper, mass, tyre]) in ends {
            let hub = axle + wheel;
            sketch
                .spring(tyre, (x, road), (x, hub - 0.05 * size))
                .spring_and_damper((spring, damper), (x, hub + 0.05 * size), (x, end), 0.16 * size)
                .mass(mass, (x - 0.14 * size, hub - 0.05 * size), (x + 0.14 * size, hub + 0.05 * size));
        }
        // The body stands over the line from end to end, with a bonnet ahead of the cab.
        let level = |x: f64| front + (rear - front) * (x - a) / size;
        let outline = [
            (-0.14, 0.0),
            (-0.14, 0.1),
            (0.2, 0.13),
            (0.36, 0.28),
            (0.86, 0.28),
            (1.0, 0.13),
            (1.14, 0.12),
            (1.14, 0.0),
        ];
        let place = |(along, up): (f64, f64)| (a + along * size, level(a + along * size) + up * size);
        sketch
            .axis((a - 0.15 * size, 0.0), (b + 0.15 * size, 0.0))
            .body("", outline.map(place))
            .label("m, J", place((0.6, 0.2)))
            .mass_centre("G", (0.0, level(0.0) + 0.06 * size));
        sketch
    }
}
