//! Torsional vibration of an engine: which orders of the cylinders' torques meet which natural frequency.

use dalembert_core::{About, Analysis, Exhibit, Inputs, Reason, Refusal, Symbol, Text, Worksheet, register};
use dalembert_mechanics::{
    Real,
    vibration::{crankshaft, torsional::TorsionalMode},
};

mod critical;
mod drawing;
mod exhibits;
mod firing;
mod line;

use self::{
    critical::Critical,
    firing::Cylinders,
    line::{CrankshaftLine, ThrowStiffness},
};
use crate::{
    shared::{inertia::Inertia, spring::torsional::TorsionalSpring},
    sources::{DEN_HARTOG, KER_WILSON},
};

/// The engine, what it drives, and its torques.
#[derive(Clone, Debug, Inputs)]
pub struct EngineOrders {
    /// Cycle.
    pub cycle: WorkingCycle,
    /// Firing.
    pub firing: Firing,
    /// Cranks.
    pub cranks: CrankshaftCranks,
    /// In front of the cranks.
    /// Damper, pulley, pump: starting from the free end.
    #[input("f")]
    pub front: Vec<Attached>,
    /// Behind the cranks.
    /// Flywheel, coupling, driven machine: starting from the engine, all referred to the crankshaft speed.
    #[input("r")]
    pub rear: Vec<Attached>,
    /// Torques of a cylinder.
    /// Harmonics of the torque on one crank; all cylinders have the same.
    pub torques: Torques,
    /// Minimum speed.
    #[input("n_a", "rpm", positive)]
    pub lowest: f64,
    /// Maximum speed.
    #[input("n_b", "rpm", positive)]
    pub highest: f64,
    /// Modes considered.
    /// Starting from the lowest.
    #[input(min = 1, max = 4, default = "2")]
    pub modes: u32,
    /// Damping.
    /// Without it the amplitude at a critical speed is unbounded.
    pub damping: Option<CrankshaftDamping>,
    /// Diameter of the crankshaft.
    /// The smallest diameter that transmits the torque within the shear stress limit.
    #[input("d", "m", positive)]
    pub diameter: Option<f64>,
}

/// Working cycle: two- or four-stroke.
#[derive(Clone, Debug, Inputs)]
pub enum WorkingCycle {
    /// Four strokes
    /// Each cylinder fires once every two revolutions: half orders too.
    Four,
    /// Two strokes
    /// Each cylinder fires once per revolution: integer orders only.
    Two,
}

/// Firing angles or firing order.
#[derive(Clone, Debug, Inputs)]
pub enum Firing {
    /// At even intervals
    /// One cylinder to each crank.
    Even {
        /// Firing order.
        /// The numbers of the cylinders from the free end, such as 1-5-3-6-2-4.
        order: String,
    },
    /// At given angles
    /// For unequal intervals, and for V engines with two cylinders per crank.
    Angles {
        /// Cylinders.
        #[input(min = 1)]
        cylinders: Vec<FiringAngle>,
    },
}

/// Firing angle of a cylinder.
#[derive(Clone, Debug, Inputs)]
pub struct FiringAngle {
    /// Crank.
    /// Counted from the free end.
    #[input(min = 1, max = 24)]
    pub crank: u32,
    /// Firing angle.
    /// Crank angle since the first cylinder fired.
    #[input("ψ", "deg", nonnegative)]
    pub angle: f64,
}

/// The cranks.
#[derive(Clone, Debug, Inputs)]
pub enum CrankshaftCranks {
    /// All equal
    Alike {
        /// Moment of inertia of a crank.
        /// Crank throw, big end, and half of the reciprocating mass, at the crank radius.
        #[input("J_c", "kg*m^2", positive)]
        inertia: f64,
        /// Stiffness between two cranks.
        throw: ThrowStiffness,
    },
    /// One by one
    Each {
        /// Cranks.
        #[input(min = 1)]
        cranks: Vec<Crank>,
    },
}

/// A crank.
#[derive(Clone, Debug, Inputs)]
pub struct Crank {
    /// Moment of inertia.
    #[input("J", "kg*m^2", positive)]
    pub inertia: f64,
    /// Stiffness of the shaft to the next crank.
    /// Omit for the last crank.
    #[input("k", "N*m/rad", positive)]
    pub stiffness: Option<f64>,
}

/// Inertia that rotates with the crankshaft.
#[derive(Clone, Debug, Inputs)]
pub struct Attached {
    /// Name.
    pub name: String,
    /// Moment of inertia.
    pub inertia: Inertia,
    /// Shaft towards the engine.
    /// From the middle of the nearest crank, or from the previous part.
    pub shaft: TorsionalSpring,
}

/// Harmonic torques of a cylinder.
#[derive(Clone, Debug, Inputs)]
pub enum Torques {
    /// Torques unknown
    /// Only the sums of the phase vectors.
    Unknown {
        /// Maximum order.
        #[input(min = 1, max = 24, default = "12")]
        highest: u32,
    },
    /// Amplitudes of the torque
    Given {
        /// Harmonics.
        #[input(table)]
        harmonics: Vec<TorqueHarmonic>,
    },
    /// Amplitudes of the tangential pressure
    /// The tangential force at the crankpin over the area of the piston.
    Pressure {
        /// Bore.
        #[input("B", "m", positive)]
        bore: f64,
        /// Stroke.
        #[input("S", "m", positive)]
        stroke: f64,
        /// Harmonics.
        #[input(table)]
        harmonics: Vec<PressureHarmonic>,
    },
}

/// A harmonic of the torque.
#[derive(Clone, Debug, Inputs)]
pub struct TorqueHarmonic {
    /// Order.
    #[input("n", "1", positive)]
    pub order: f64,
    /// Amplitude.
    #[input("T", "N*m", nonnegative)]
    pub torque: f64,
}

/// A harmonic of the tangential pressure.
#[derive(Clone, Debug, Inputs)]
pub struct PressureHarmonic {
    /// Order.
    #[input("n", "1", positive)]
    pub order: f64,
    /// Amplitude.
    #[input("p", "Pa", nonnegative)]
    pub pressure: f64,
}

/// Damping of the vibration.
#[derive(Clone, Debug, Inputs)]
pub enum CrankshaftDamping {
    /// Damping ratio given
    /// The same for every mode.
    Ratio {
        /// Damping ratio.
        #[input("ζ", "1", positive, below = 1)]
        ratio: f64,
    },
    /// Dynamic magnifier given
    /// Amplitude at resonance over the equilibrium amplitude.
    Magnifier {
        /// Dynamic magnifier.
        #[input("M", "1", above = 0.5)]
        magnifier: f64,
    },
    /// Damping at the cranks
    Cranks {
        /// Damping coefficient of a cylinder.
        /// Torque over angular velocity of the vibration.
        #[input("c", "N*m*s/rad", positive)]
        coefficient: f64,
    },
}

register!(EngineOrders);

/// The most critical speeds that are worked out; the table has all of them.
const WORKED: usize = 6;

impl Analysis for EngineOrders {
    const ABOUT: About = About {
        id: "vibration/engine-orders",
        title: "Torsional vibration of an engine",
        topic: "Shafts and rotors",
        summary: "Natural frequencies of crankshaft and driven machine, sums of the phase vectors of each order, critical speeds with their amplitudes and torques.",
        main: &["frequency", "critical_speeds", "amplitude", "stress"],
        keywords: "torsional vibration crankshaft diesel engine firing order phase vector star harmonic order critical speed \
                   Holzer Carter Ker Wilson vibração torcional virabrequim motor ordem de ignição velocidade crítica harmônico",
        sources: &[&DEN_HARTOG, &KER_WILSON],
        cases: include_str!("../../cases/engine_orders.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &EngineOrdersGiven<W>, sheet: W) -> Result<(), Refusal> {
        if self.lowest >= self.highest {
            return Err(Refusal::because(
                "the lowest speed is not below the highest one: write the smaller one as the lowest",
            ));
        }
        let cylinders = firing::cylinders(self, given, sheet)?;
        let line = line::line(self, given, &cylinders, sheet)?;
        let all = line.train.modes().map_err(|error| line::refusal(&error))?;
        sheet.keep_going()?;
        let elastic = &all[1..];
        if elastic.is_empty() {
            return Err(Refusal::because(
                "a single crank rotates freely and does not vibrate: write a flywheel or another crank",
            ));
        }
        let vibrations: Vec<Vibration<W::Num>> = elastic
            .iter()
            .take(self.modes as usize)
            .enumerate()
            .map(|(n, mode)| vibration(n + 1, mode, &line, &cylinders, sheet))
            .collect();
        let orders = self.orders()?;
        let sums: Vec<Vec<f64>> = vibrations
            .iter()
            .map(|vibration| orders.iter().map(|order| cylinders.sum(order.order, vibration)).collect())
            .collect();
        for (n, sums) in sums.iter().enumerate() {
            sheet.answer_list(("phase_sums", n + 1), "Sums of the phase vectors by order", "1", sums);
        }
        let angles = cylinders.values();
        let major: Vec<f64> = orders
            .iter()
            .map(|order| order.order)
            .filter(|order| crankshaft::is_major(*order, &angles))
            .collect();
        if !major.is_empty() {
            sheet.answer_list("major_orders", "Major orders: all cylinders push together", "1", &major);
        }
        let criticals = self.criticals(&vibrations, &orders, &sums);
        let count = sheet.numerical(
            "N",
            "1",
            criticals.len() as f64,
            "Critical speeds between the lowest and the highest speed: an order coincides with a natural frequency",
        );
        sheet.answer("critical_speeds", "Number of critical speeds in the range", count);
        for (row, critical) in critical::worst(&criticals, WORKED).into_iter().enumerate() {
            critical::work(given, &line, &cylinders, &vibrations, critical, row + 1, sheet);
        }
        if self.damping.is_none() && !matches!(self.torques, Torques::Unknown { .. }) {
            sheet.warn(|| {
                Text::new(
                    "without damping the amplitude at a critical speed is unbounded: it grows with time; the equilibrium amplitude is given instead",
                )
            });
        }
        // Where the node of the mode, of amplitude one, lies between the cylinders, their work cancels.
        let is_dangerous = |critical: &&Critical| {
            critical.mode == 0 && major.contains(&critical.order.order) && critical.sum.abs() > 1e-9
        };
        let dangerous = criticals.iter().find(is_dangerous);
        if let Some(critical) = dangerous {
            sheet.warn(|| {
                Text::new("the major order {order} of the first mode is critical at {speed}, within the range of speeds")
                    .with("order", critical.order.order)
                    .with_quantity("speed", critical.speed, "rpm")
            });
        }
        let view = exhibits::View {
            problem: self,
            line: &line,
            cylinders: &cylinders,
            vibrations: &vibrations,
            orders: &orders,
            sums: &sums,
            criticals: &criticals,
        };
        sheet.show(|| Exhibit::Table(view.criticals()));
        sheet.show(|| Exhibit::Table(view.phase_sums()));
        sheet.show(|| Exhibit::Table(view.masses()));
        sheet.show(|| Exhibit::Plot(view.bars()));
        sheet.show(|| Exhibit::Plot(view.interference()));
        sheet.show(|| Exhibit::Plot(view.shapes()));
        if self.damping.is_some() && !matches!(self.torques, Torques::Unknown { .. }) && !criticals.is_empty()
        {
            sheet.show(|| Exhibit::Plot(view.response()));
        }
        let cranks = line.inertias.len() - self.front.len() - self.rear.len();
        sheet.show(|| Exhibit::Drawing(drawing::crankshaft(self, cranks)));
        sheet.show(|| Exhibit::Drawing(view.stars()));
        Ok(())
    }
}

/// A harmonic of the torque of a cylinder.
#[derive(Clone, Copy)]
struct Order {
    order: f64,
    /// Amplitude of its tangential pressure, Pa, or of its torque, N·m; one where it is unknown.
    amplitude: f64,
}

/// A mode of the line.
struct Vibration<N> {
    frequency: N,
    /// Amplitudes of the masses; the first one is 1.
    shape: Vec<N>,
    /// Amplitudes of the cranks, cylinder by cylinder.
    arms: Vec<N>,
    /// `Σ J β²`.
    inertia: N,
}

impl EngineOrders {
    /// The orders that are examined, ascending.
    fn orders(&self) -> Result<Vec<Order>, Refusal> {
        let step = match self.cycle {
            WorkingCycle::Four => 0.5,
            WorkingCycle::Two => 1.0,
        };
        let mut orders: Vec<Order> = match &self.torques {
            Torques::Unknown { highest } => {
                let count = (f64::from(*highest) / step) as u32;
                (1..=count).map(|n| Order { order: step * f64::from(n), amplitude: 1.0 }).collect()
            }
            Torques::Given { harmonics } => {
                let order = |row: &TorqueHarmonic| Order { order: row.order, amplitude: row.torque };
                harmonics.iter().map(order).collect()
            }
            Torques::Pressure { harmonics, .. } => {
                let order = |row: &PressureHarmonic| Order { order: row.order, amplitude: row.pressure };
                harmonics.iter().map(order).collect()
            }
        };
        if orders.len() > 100 {
            return Err(Refusal::because("there are more than 100 orders: omit the highest ones"));
        }
        let whole = |order: &Order| {
            let parts = order.order / step;
            (parts - parts.round()).abs() < 1e-9 && parts < 1e4
        };
        if !orders.iter().all(whole) {
            return Err(Refusal::because(match self.cycle {
                WorkingCycle::Four => {
                    "an order of a four-stroke engine is a multiple of one half: write orders such as 0.5, 1 or 4.5"
                }
                WorkingCycle::Two => {
                    "an order of a two-stroke engine is a whole number: write orders such as 1, 2 or 6"
                }
            }));
        }
        orders.sort_by(|a, b| a.order.total_cmp(&b.order));
        if orders.windows(2).any(|pair| pair[1].order - pair[0].order < 1e-6) {
            return Err(Refusal::because("an order appears twice in the table: write each order once"));
        }
        Ok(orders)
    }

    /// All critical speeds of the range, mode by mode.
    fn criticals<N: Real>(
        &self,
        vibrations: &[Vibration<N>],
        orders: &[Order],
        sums: &[Vec<f64>],
    ) -> Vec<Critical> {
        let mut criticals = Vec::new();
        for (mode, vibration) in vibrations.iter().enumerate() {
            for (order, sum) in orders.iter().zip(&sums[mode]) {
                let speed = vibration.frequency.value() / order.order;
                let slack = 1e-9 * speed;
                if speed >= self.lowest - slack && speed <= self.highest + slack {
                    let stiffness = vibration.frequency.value().powi(2) * vibration.inertia.value();
                    let severity = order.amplitude * sum / stiffness;
                    criticals.push(Critical { mode, order: *order, speed, sum: *sum, severity });
                }
            }
        }
        criticals
    }
}

/// A mode as it is worked: frequency, amplitudes, inertia, nodes, and two more ways to the frequency.
fn vibration<W: Worksheet>(
    n: usize,
    mode: &TorsionalMode,
    line: &CrankshaftLine<W::Num>,
    cylinders: &Cylinders<W::Num>,
    sheet: W,
) -> Vibration<W::Num> {
    let holzer = (
        "By Holzer's method: at this frequency the residual torque at the last mass is zero",
        DEN_HARTOG.at("ch. 5"),
    );
    let why = if n == 1 { Reason::from(holzer) } else { Reason::from("Similarly") };
    let frequency = sheet.numerical(("ω", n), "rad/s", mode.frequency, why);
    let counted = sheet.step(("fₙ", n), "Hz", frequency, "The same frequency in Hz");
    sheet.answer(("frequency", n), "Natural frequency", counted);
    let largest =
        mode.shape.iter().fold(0.0, |largest: f64, x| if x.abs() > largest.abs() { *x } else { largest });
    let first = mode.shape[0];
    let unit = if first.abs() > 1e-6 * largest.abs() { first } else { largest };
    let shape: Vec<f64> = mode.shape.iter().map(|x| x / unit).collect();
    sheet.answer_list(("mode", n), "Amplitudes of mode", "1", &shape);
    let amplitude = |(i, x): (usize, &f64)| {
        let why = if i == 0 {
            "Amplitude of the first mass, the reference for all others"
        } else {
            "From Holzer's table: amplitude of the previous mass, minus the twist between them"
        };
        let [first, last] = line.cranks;
        let symbol = match i {
            _ if i < first => Symbol { of: "f", ..Symbol::from("β") }.row(n).row(i + 1),
            _ if i > last => Symbol { of: "r", ..Symbol::from("β") }.row(n).row(i - last),
            _ => Symbol::from("β").row(n).row(i - first + 1),
        };
        sheet.numerical(symbol, "1", *x, why)
    };
    let terms: Vec<W::Num> = shape.iter().enumerate().map(amplitude).collect();
    let kinetic = line.inertias.iter().zip(&terms).map(|(inertia, beta)| *inertia * beta.powi(2));
    let rigid = || W::Num::sum(line.inertias.iter().copied());
    sheet.common_error(("J_m", n), "the moments of inertia added as if all amplitudes were 1", rigid);
    let linear = || W::Num::sum(line.inertias.iter().zip(&terms).map(|(inertia, beta)| *inertia * *beta));
    sheet.common_error(("J_m", n), "the amplitudes not squared", linear);
    let inertia = sheet.step(
        ("J_m", n),
        "kg*m^2",
        W::Num::sum(kinetic),
        "Inertia of the mode: a disc at the first mass with the same kinetic energy",
    );
    sheet.verify(|| {
        let twist = |(i, stiffness): (usize, &W::Num)| *stiffness * (terms[i] - terms[i + 1]).powi(2);
        sheet.check(
            "elastic energy over kinetic energy of the mode shape is ω²",
            W::Num::sum(line.stiffnesses.iter().enumerate().map(twist)) / inertia,
            frequency.powi(2),
        );
        if line.inertias.len() <= 16 {
            let left = W::Num::from(line.train.residual(mode.frequency));
            sheet.check_zero("the Holzer residual vanishes at the natural frequency", left, 1.0);
        }
    });
    let nodes: Vec<f64> = shape
        .windows(2)
        .enumerate()
        .filter(|(_, ends)| ends[0] * ends[1] < 0.0)
        .map(|(i, ends)| (i + 1) as f64 + ends[0] / (ends[0] - ends[1]))
        .collect();
    if !nodes.is_empty() {
        sheet.answer_list(("nodes", n), "Nodes from the free end (position in mass spacings)", "1", &nodes);
    }
    // Where several cylinders share a crank, each has its amplitude by a name of its own.
    let of_cylinder = |(k, one): (usize, &firing::FiringCylinder<W::Num>)| {
        let beta = terms[one.mass];
        if cylinders.one_to_a_crank {
            return beta;
        }
        let why = "Amplitude of the crank on which the cylinder works";
        sheet.step(Symbol::from("α").row(n).row(k + 1), "1", beta, why)
    };
    let arms = cylinders.each.iter().enumerate().map(of_cylinder).collect();
    Vibration { frequency, shape: terms, arms, inertia }
}

impl<N: Real> Cylinders<N> {
    /// The sum of the phase vectors of an order in a mode.
    fn sum(&self, order: f64, vibration: &Vibration<N>) -> f64 {
        let [x, y] = self.vector(order, vibration);
        x.hypot(y)
    }

    fn vector(&self, order: f64, vibration: &Vibration<N>) -> [f64; 2] {
        let each = self.each.iter().zip(&vibration.arms).map(|(one, beta)| (beta.value(), one.angle.value()));
        crankshaft::phase_vectors(order, each)
    }
}
