//! Velocities over the coefficient of restitution, and a sketch of the bodies.

use std::f64::consts::FRAC_PI_2;

use dalembert_core::{Axis, Drawing, Ink, Plot, Point, Series, Sketch};

use super::{
    ImpactOfTwoBodies, ImpactTarget, ImpactVelocity,
    hinged::{HingedBody, HingedTarget},
};

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
pub(super) fn sketch(problem: &ImpactOfTwoBodies, before: [[f64; 2]; 2]) -> Drawing {
    let fastest = before.iter().flatten().fold(0.0, |most: f64, v| most.max(v.abs()));
    let along = |[n, t]: [f64; 2]| (1.2 * n / fastest, 1.2 * t / fastest);
    let mut sketch = Sketch::new("The bodies at the impact, with their velocities before");
    let a = (-0.5, 0.0);
    sketch.disc("m_A", a, 0.5);
    velocity(&mut sketch, &problem.velocity, ["u_A", "w_A", "s_A", "φ_A"], a, along(before[0]));
    match &problem.target {
        ImpactTarget::Free { velocity: second, .. } => {
            let b = (0.5, 0.0);
            sketch.axis((-2.2, 0.0), (2.2, 0.0)).disc("m_B", b, 0.5);
            velocity(&mut sketch, second, ["u_B", "w_B", "s_B", "φ_B"], b, along(before[1]));
        }
        ImpactTarget::Wall => {
            sketch.axis((-2.2, 0.0), (0.0, 0.0)).ground((0.0, 1.2), (0.0, -1.2));
        }
        ImpactTarget::Hinged { body } => hinged(&mut sketch, body, before[1][0].signum()),
    }
    sketch.finish()
}

/// The velocity of a body, with the letters that it is given by.
fn velocity(
    sketch: &mut Sketch,
    given: &ImpactVelocity,
    [normal, speed, tangential, angle]: [&'static str; 4],
    (x, y): (f64, f64),
    (n, t): (f64, f64),
) {
    match given {
        ImpactVelocity::Direct { .. } => {
            // From outside, so that the arrow ends on the ball.
            let edge = x - 0.5 * n.signum();
            sketch.motion(normal, (edge - n, y), (edge, y));
        }
        ImpactVelocity::Oblique { .. } => {
            sketch.motion(speed, (x, y), (x + n, y + t)).angle(angle, (x, y), 0.0, t.atan2(n));
        }
        ImpactVelocity::Components { .. } => {
            sketch.motion(normal, (x, y), (x + n, y)).motion(tangential, (x, y), (x, y + t));
        }
    }
}

/// The body on its pin, hit at a distance from it.
fn hinged(sketch: &mut Sketch, target: &HingedTarget, sense: f64) {
    let (pin, point): (Point, Point) = ((0.1, 2.0), (0.1, 0.0));
    let scale = 2.0 / target.arm;
    sketch.axis((-2.2, 0.0), (1.6, 0.0));
    let below = |length: f64| (0.1, 2.0 - (length * scale).clamp(0.2, 4.0));
    match target.kind {
        HingedBody::Rod { length, .. } => {
            let end = below(length);
            sketch.body("", [(0.0, 2.0), (0.2, 2.0), (0.2, end.1), (0.0, end.1)]).label("M", (0.2, 1.4));
            sketch.dimension("L", pin, end, 4.0);
        }
        HingedBody::Bob { length, .. } => {
            let end = below(length);
            sketch.link("", pin, end).disc("M", end, 0.35).dimension("L", pin, end, 5.0);
        }
        HingedBody::RadiusOfGyration { centre, .. } | HingedBody::MomentOfInertia { centre, .. } => {
            let letters = match target.kind {
                HingedBody::RadiusOfGyration { .. } => "M, k_O",
                _ => "M, I_O",
            };
            let end = (point.1 - 0.6).min(below(centre).1 - 0.3);
            sketch
                .body("", [(0.0, 2.0), (0.35, 1.0), (0.2, end), (0.0, end)])
                .label(letters, (0.3, 1.2))
                .mass_centre("G", below(centre))
                .dimension("h", pin, below(centre), 4.0);
        }
    }
    sketch.hung_pin("O", pin).dimension("r", pin, point, -2.5);
    if target.speed != 0.0 {
        let turn =
            if sense > 0.0 { (FRAC_PI_2 + 2.2, FRAC_PI_2 + 4.2) } else { (FRAC_PI_2 + 4.2, FRAC_PI_2 + 2.2) };
        sketch.couple("ω₀", pin, turn, Ink::Motion);
    }
}
