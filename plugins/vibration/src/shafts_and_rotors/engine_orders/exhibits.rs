//! Tables, plots and the stars of phase vectors.

use std::f64::consts::{PI, TAU};

use dalembert_core::{
    Axis, Cell, Column, Drawing, Ink, Plot, Series, Sketch, TableExhibit, Text, exhibit::Level,
};
use dalembert_mechanics::{Real, vibration::crankshaft};

use super::{
    EngineOrders, Order, Torques, Vibration,
    critical::{self, Critical},
    firing::Cylinders,
    line::CrankshaftLine,
};

/// The most rays of the interference diagram and the most stars that are drawn.
const MOST_RAYS: usize = 8;
const MOST_STARS: usize = 6;

/// Data of the plots and tables.
pub(super) struct View<'a, N> {
    pub(super) problem: &'a EngineOrders,
    pub(super) line: &'a CrankshaftLine<N>,
    pub(super) cylinders: &'a Cylinders<N>,
    pub(super) vibrations: &'a [Vibration<N>],
    pub(super) orders: &'a [Order],
    /// Mode by mode, order by order.
    pub(super) sums: &'a [Vec<f64>],
    pub(super) criticals: &'a [Critical],
}

fn column(heading: &'static str, unit: &'static str) -> Column {
    Column { heading: heading.into(), unit }
}

fn mode_name(mode: usize) -> Text {
    Text::new("mode {mode}").with("mode", mode + 1)
}

impl<N: Real> View<'_, N> {
    fn is_major(&self, order: f64) -> bool {
        crankshaft::is_major(order, &self.cylinders.values())
    }

    fn torque(&self, order: &Order) -> Option<f64> {
        match &self.problem.torques {
            Torques::Unknown { .. } => None,
            Torques::Given { .. } => Some(order.amplitude),
            Torques::Pressure { bore, stroke, .. } => {
                Some(order.amplitude * PI * bore.powi(2) / 4.0 * stroke / 2.0)
            }
        }
    }

    /// All critical speeds of the range.
    pub(super) fn criticals(&self) -> TableExhibit {
        let row = |critical: &Critical| {
            let vibration = &self.vibrations[critical.mode];
            let stiffness = vibration.frequency.value().powi(2) * vibration.inertia.value();
            let equilibrium = self.torque(&critical.order).map(|torque| torque * critical.sum / stiffness);
            let magnifier = critical::magnifier(self.problem, self.cylinders, vibration);
            let steady = equilibrium.zip(magnifier).map(|(equilibrium, magnifier)| equilibrium * magnifier);
            let number = |x: Option<f64>| x.map_or(Cell::Empty, Cell::Number);
            vec![
                Cell::Text(Text::new((critical.mode + 1).to_string())),
                Cell::Number(critical.order.order),
                if self.is_major(critical.order.order) { "major".into() } else { Cell::Empty },
                Cell::Number(critical.speed),
                Cell::Number(critical.sum),
                number(self.torque(&critical.order)),
                number(equilibrium),
                number(steady),
            ]
        };
        TableExhibit {
            title: "Critical speeds in the range".into(),
            columns: vec![
                column("mode", ""),
                column("order", "1"),
                column("kind", ""),
                column("speed", "rpm"),
                column("sum of phasors", "1"),
                column("torque of a cylinder", "N*m"),
                column("equilibrium amplitude", "deg"),
                column("amplitude", "deg"),
            ],
            rows: self.criticals.iter().map(row).collect(),
            foot: Vec::new(),
        }
    }

    /// Sums of the phase vectors by order.
    pub(super) fn phase_sums(&self) -> TableExhibit {
        let mut columns = vec![column("order", "1"), column("kind", "")];
        columns.extend((0..self.sums.len()).map(|mode| Column { heading: mode_name(mode), unit: "1" }));
        let row = |(at, order): (usize, &Order)| {
            let mut row = vec![
                Cell::Number(order.order),
                if self.is_major(order.order) { "major".into() } else { Cell::Empty },
            ];
            row.extend(self.sums.iter().map(|sums| Cell::Number(sums[at])));
            row
        };
        TableExhibit {
            title: "Sums of the phase vectors".into(),
            columns,
            rows: self.orders.iter().enumerate().map(row).collect(),
            foot: Vec::new(),
        }
    }

    /// The masses, the stiffnesses between them, and their amplitudes.
    pub(super) fn masses(&self) -> TableExhibit {
        let mut columns = vec![column("mass", ""), column("J", "kg*m^2"), column("k to the next", "N*m/rad")];
        columns.extend((0..self.vibrations.len()).map(|mode| Column { heading: mode_name(mode), unit: "1" }));
        let row = |at: usize| {
            let stiffness = self.line.stiffnesses.get(at).map_or(Cell::Empty, |k| Cell::Number(k.value()));
            let name = self.line.names[at].clone();
            let mut row = vec![Cell::Text(name), Cell::Number(self.line.inertias[at].value()), stiffness];
            row.extend(self.vibrations.iter().map(|one| Cell::Number(one.shape[at].value())));
            row
        };
        TableExhibit {
            title: "Masses and their amplitudes".into(),
            columns,
            rows: (0..self.line.inertias.len()).map(row).collect(),
            foot: Vec::new(),
        }
    }

    /// Bars of the sums of the phase vectors.
    pub(super) fn bars(&self) -> Plot {
        let series = self.sums.iter().enumerate().map(|(mode, sums)| {
            // The bars of several modes stand side by side.
            let aside = 0.06 * (mode as f64 - (self.sums.len() - 1) as f64 / 2.0);
            let bar = |(order, sum): (&Order, &f64)| {
                let at = order.order + aside;
                [(at, 0.0), (at, *sum), (at, f64::INFINITY)]
            };
            Series::line(mode_name(mode), self.orders.iter().zip(sums).flat_map(bar).collect())
        });
        Plot::new(
            "Sums of the phase vectors against the order",
            Axis::linear("order", "1"),
            Axis::linear("sum of the phasors", "1"),
            series.collect(),
        )
    }

    /// The orders that matter most in the range, worst first.
    fn worst_orders(&self, most: usize) -> Vec<f64> {
        let mut orders: Vec<f64> = Vec::new();
        for critical in critical::worst(self.criticals, 2 * most) {
            if !orders.contains(&critical.order.order) && orders.len() < most {
                orders.push(critical.order.order);
            }
        }
        orders.sort_by(f64::total_cmp);
        orders
    }

    /// Natural frequencies and the frequencies of the orders against the speed.
    pub(super) fn interference(&self) -> Plot {
        let (low, high) = (self.problem.lowest, self.problem.highest);
        let mut rays = self.worst_orders(MOST_RAYS);
        if rays.is_empty() {
            let major = self.orders.iter().map(|order| order.order).filter(|order| self.is_major(*order));
            rays = major.take(MOST_RAYS).collect();
        }
        let top = self.vibrations.iter().map(|one| one.frequency.value()).fold(0.0, f64::max) * 1.2;
        let end = 1.15 * high;
        let mut series: Vec<Series> = rays
            .iter()
            .map(|order| {
                let last = end.min(top / order);
                let label = Text::new("order {order}").with_quantity("order", *order, "1");
                Series::line(label, vec![(0.0, 0.0), (last, order * last)])
            })
            .collect();
        let meet = self.criticals.iter().filter(|critical| rays.contains(&critical.order.order));
        let dots = meet.map(|critical| (critical.speed, critical.speed * critical.order.order)).collect();
        series.push(Series::dots("critical speeds", dots));
        let mut plot = Plot::new(
            "Interference diagram",
            Axis::linear("speed", "rpm"),
            Axis::linear("frequency", "Hz"),
            series,
        )
        .band("range of speeds", low, high, true);
        plot.levels.extend(
            self.vibrations
                .iter()
                .enumerate()
                .map(|(mode, one)| Level { label: mode_name(mode), y: one.frequency.value() }),
        );
        plot
    }

    /// Amplitudes along the line, mass by mass.
    pub(super) fn shapes(&self) -> Plot {
        let series = self.vibrations.iter().enumerate().map(|(mode, one)| {
            let points = one.shape.iter().enumerate().map(|(at, x)| ((at + 1) as f64, x.value())).collect();
            Series::line(mode_name(mode), points)
        });
        Plot::new(
            "Amplitudes along the line",
            Axis::linear("mass number from the free end", "1"),
            Axis::linear("amplitude relative to that of the first mass", "1"),
            series.collect(),
        )
        .level("at rest", 0.0)
    }

    /// Amplitude of the first mass against the speed, for the orders that matter most.
    pub(super) fn response(&self) -> Plot {
        const POINTS: u16 = 240;
        let orders: Vec<&Order> = {
            let worst = self.worst_orders(5);
            self.orders.iter().filter(|order| worst.contains(&order.order)).collect()
        };
        let (low, high) = (self.problem.lowest, self.problem.highest);
        let mut series = Vec::new();
        for order in orders {
            let torque = self.torque(order).unwrap_or(1.0);
            let modes: Vec<(f64, f64, f64, [f64; 2])> = self
                .vibrations
                .iter()
                .filter_map(|one| {
                    let magnifier = critical::magnifier(self.problem, self.cylinders, one)?;
                    let vector = self.cylinders.vector(order.order, one);
                    Some((one.frequency.value(), magnifier, one.inertia.value(), vector))
                })
                .collect();
            let at = |n: u16| {
                let speed = low + (high - low) * f64::from(n) / f64::from(POINTS);
                let frequency = order.order * speed;
                let (mut re, mut im) = (0.0, 0.0);
                for &(natural, magnifier, inertia, [x, y]) in &modes {
                    let (a, b) = (natural.powi(2) - frequency.powi(2), natural * frequency / magnifier);
                    let size = torque / (inertia * (a * a + b * b));
                    re += size * (x * a - y * b);
                    im -= size * (x * b + y * a);
                }
                (speed, re.hypot(im))
            };
            let label = Text::new("order {order}").with_quantity("order", order.order, "1");
            series.push(Series::line(label, (0..=POINTS).map(at).collect()));
        }
        Plot::new(
            "Amplitude of the first mass against the speed",
            Axis::linear("speed", "rpm"),
            Axis::linear("amplitude", "deg"),
            series,
        )
    }

    /// The stars of the first orders in the first mode, with their resultants.
    pub(super) fn stars(&self) -> Drawing {
        let mut orders = self.worst_orders(MOST_STARS);
        if orders.is_empty() {
            orders = self.orders.iter().take(MOST_STARS).map(|order| order.order).collect();
        }
        let Some(vibration) = self.vibrations.first() else {
            return Sketch::new("Phase-vector star diagrams").finish();
        };
        let mut sketch = Sketch::new(
            "Phase-vector star diagrams in the first mode; the sum as a fraction of the total length",
        );
        let beta = |mass: usize| vibration.shape[mass].value();
        let largest =
            self.cylinders.each.iter().fold(f64::MIN_POSITIVE, |most, one| most.max(beta(one.mass).abs()));
        let all: f64 = self.cylinders.each.iter().map(|one| beta(one.mass).abs()).sum();
        for (n, order) in orders.iter().enumerate() {
            let centre = (3.0 * (n % 3) as f64, -3.2 * (n / 3) as f64);
            let point = |x: f64, y: f64| (centre.0 + x, centre.1 + y);
            sketch
                .circle(centre, 1.0, Ink::Faint)
                .caption(Text::new("order {order}").with_quantity("order", *order, "1"), point(0.0, -1.4));
            for (k, one) in self.cylinders.each.iter().enumerate() {
                let (length, turn) = (beta(one.mass) / largest, (order * one.angle.value()) % TAU);
                // The first cylinder points upwards, the others are turned on clockwise.
                let end = point(length * turn.sin(), length * turn.cos());
                sketch.force(Text::new((k + 1).to_string()), centre, end);
            }
            let [x, y] = self.cylinders.vector(*order, vibration);
            if all > 0.0 && x.hypot(y) > 1e-9 * all {
                sketch.vector("", centre, point(y / all, x / all), Ink::Danger);
            }
        }
        sketch.finish()
    }
}
