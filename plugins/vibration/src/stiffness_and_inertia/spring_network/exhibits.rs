//! Tables and plots of a network.

use dalembert_core::{Axis, Cell, Column, Plot, Series, TableExhibit, Text};
use dalembert_mechanics::{
    Real,
    vibration::network::{Network, SpringDamper},
};
use nalgebra::Complex;

use super::SpringNetwork;

impl SpringNetwork {
    fn name(&self, end: Option<usize>) -> Cell {
        end.map_or("ground".into(), |node| Text::new("{x}").with("x", &self.nodes[node].name).into())
    }

    /// Forces and deflections under the constant force.
    pub(super) fn table_at_rest<N: Real>(
        &self,
        displacements: &[f64],
        forces: &[(usize, N)],
    ) -> TableExhibit {
        let at = |end: Option<usize>| end.map_or(0.0, |node| displacements[node]);
        let row = |(n, force): &(usize, N)| {
            let [from, to] = self.ends(*n);
            vec![
                Cell::Text(Text::new((n + 1).to_string())),
                self.name(from),
                self.name(to),
                Cell::Number(force.value()),
                Cell::Number(at(from) - at(to)),
                Cell::Number(0.5 * force.value() * (at(from) - at(to))),
            ]
        };
        TableExhibit {
            title: "Force in each spring".into(),
            columns: vec![
                column("element", ""),
                column("from", ""),
                column("to", ""),
                column("force", "N"),
                column("deflection", "mm"),
                column("elastic energy", "J"),
            ],
            rows: forces.iter().map(row).collect(),
            foot: Vec::new(),
        }
    }

    /// Forces and deflections under the harmonic force.
    pub(super) fn table_excited(&self, system: &Network, omega: f64, moved: &[Complex<f64>]) -> TableExhibit {
        let at = |end: Option<usize>| end.map_or(Complex::ZERO, |node| moved[node]);
        let row = |(n, link): (usize, &SpringDamper)| {
            let deflection = at(link.ends[0]) - at(link.ends[1]);
            let force = deflection * Complex::new(link.stiffness, link.damping * omega);
            vec![
                Cell::Text(Text::new((n + 1).to_string())),
                self.name(link.ends[0]),
                self.name(link.ends[1]),
                Cell::Number(force.norm()),
                Cell::Number(-force.arg()),
                Cell::Number(deflection.norm()),
            ]
        };
        TableExhibit {
            title: "Force in each element under the harmonic force".into(),
            columns: vec![
                column("element", ""),
                column("from", ""),
                column("to", ""),
                column("amplitude of the force", "N"),
                column("phase lag", "deg"),
                column("amplitude of the deflection", "mm"),
            ],
            rows: system.links.iter().enumerate().map(row).collect(),
            foot: Vec::new(),
        }
    }

    /// Amplitude for each unit of force against frequency.
    pub(super) fn receptance(&self, system: &Network) -> Plot {
        let stiffness: f64 = system.links.iter().map(|link| link.stiffness).sum();
        let damping: f64 = system.links.iter().map(|link| link.damping).sum();
        let mass: f64 = system.masses.iter().sum();
        let own = if mass > 0.0 { (stiffness / mass).sqrt() } else { stiffness / damping };
        let usual = if own.is_finite() && own > 0.0 { own } else { 1.0 };
        let last = 2.5 * usual.max(self.frequency.map_or(0.0, |frequency| 0.6 * frequency));
        let forces = self.forces();
        // Large networks are drawn with fewer points, so that the plot costs no more than the rest.
        let points: u16 = if self.nodes.len() <= 12 { 150 } else { 50 };
        let at = |n: u16| {
            let frequency = last * f64::from(n) / f64::from(points);
            let amplitude =
                system.harmonic_response(&forces, frequency).map_or(f64::NAN, |x| x[self.loaded.0].norm());
            (frequency, amplitude / self.force)
        };
        Plot::new(
            "Receptance at the loaded node",
            Axis::linear("frequency", "rad/s"),
            Axis::log("receptance", "m/N"),
            vec![Series::line("X/F", (1..=points).map(at).collect()).of("amplitude").with("force", 1.0)],
        )
        .over("frequency")
    }
}

/// All roots of the free motion.
pub(super) fn roots_table(roots: &[Complex<f64>]) -> TableExhibit {
    let row = |root: &Complex<f64>| {
        vec![
            Cell::Number(root.re),
            Cell::Number(root.im),
            Cell::Number(root.norm()),
            Cell::Number(-root.re / root.norm()),
        ]
    };
    TableExhibit {
        title: "Exact roots s of the free vibration".into(),
        columns: vec![
            column("real part", "1/s"),
            column("imaginary part", "rad/s"),
            column("|s|", "rad/s"),
            column("ζ", "1"),
        ],
        rows: roots.iter().map(row).collect(),
        foot: Vec::new(),
    }
}

fn column(heading: &'static str, unit: &'static str) -> Column {
    Column { heading: heading.into(), unit }
}
