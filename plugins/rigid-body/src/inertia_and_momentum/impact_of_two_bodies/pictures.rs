//! Velocities over the coefficient of restitution, and a sketch of the bodies.

use dalembert_core::{Axis, Drawing, Plot, Series, Sketch};

use super::ImpactTarget;

/// Numbers that the plot is drawn from.
pub(super) struct Numbers {
    /// Velocities along the line of impact, m/s.
    pub before: [f64; 2],
    /// Masses, kg; infinite for a wall.
    pub masses: [f64; 2],
    pub restitution: f64,
}

/// Velocities after the impact against the coefficient of restitution.
pub(super) fn over_restitution(numbers: &Numbers) -> Plot {
    let [first, second] = numbers.masses;
    let reduced = 1.0 / (1.0 / first + 1.0 / second);
    let after = |e: f64| {
        let impulse = (1.0 + e) * reduced * (numbers.before[0] - numbers.before[1]);
        [numbers.before[0] - impulse / first, numbers.before[1] + impulse / second]
    };
    let curve = |body: usize| (0..=40).map(|n| f64::from(n) / 40.0).map(|e| (e, after(e)[body])).collect();
    let mut series = vec![Series::line("v_A", curve(0)).of("velocity_a")];
    if second.is_finite() {
        series.push(Series::line("v_B", curve(1)).of("velocity_b"));
    }
    Plot::new(
        "Velocities after the impact against the coefficient of restitution",
        Axis::linear("coefficient of restitution", "1"),
        Axis::linear("velocity along the line of impact", "m/s"),
        series,
    )
    .over("outcome.separate.restitution")
    .mark("this impact", (numbers.restitution, after(numbers.restitution)[0]))
}

/// The bodies at the impact, with their velocities before.
pub(super) fn sketch(target: &ImpactTarget, before: [[f64; 2]; 2]) -> Drawing {
    let fastest = before.iter().flatten().fold(0.0, |most: f64, v| most.max(v.abs()));
    let arrow = |at: (f64, f64), [n, t]: [f64; 2]| (at.0 + 1.2 * n / fastest, at.1 + 1.2 * t / fastest);
    let mut sketch = Sketch::new("The bodies at the impact, with their velocities before");
    let a = (-0.5, 0.0);
    sketch.disc("A", a, 0.5).motion("u_A", a, arrow(a, before[0]));
    match target {
        ImpactTarget::Free { .. } => {
            let b = (0.5, 0.0);
            sketch.axis((-2.2, 0.0), (2.2, 0.0)).disc("B", b, 0.5).motion("u_B", b, arrow(b, before[1]));
        }
        ImpactTarget::Wall => {
            sketch.axis((-2.2, 0.0), (0.0, 0.0)).ground((0.0, 1.2), (0.0, -1.2));
        }
        ImpactTarget::Hinged { .. } => {
            let point = (0.1, 0.0);
            sketch
                .axis((-2.2, 0.0), (1.2, 0.0))
                .body("", [(0.0, 2.0), (0.2, 2.0), (0.2, -0.6), (0.0, -0.6)])
                .pin("O", (0.1, 2.0))
                .dimension("r", (0.1, 2.0), point, -2.5)
                .motion("u_B", point, arrow(point, before[1]));
        }
    }
    sketch.finish()
}
