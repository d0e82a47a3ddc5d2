//! The closure of the pins by the motion of single bodies: what the equations of the joints must come to.

use dalembert_core::{Text, Worksheet};
use dalembert_mechanics::planar::{BodyPoint, Model, PlanarJoint, PlanarState};

/// Closure errors of the pins: maximum distance of the two points of a pin, and differences of their velocities and
/// accelerations; each with the magnitude of its terms.
pub(crate) fn pins(system: &Model, state: &PlanarState) -> [(f64, f64); 3] {
    let mut worst = rotation_sizes(system, state).map(|size| (0.0f64, size));
    for joint in &system.mechanism().joints {
        let &PlanarJoint::Pin { a, b } = joint else { continue };
        let [one, other] = [a, b].map(|point| system.point(point, state));
        let sizes = [a, b].map(|point| sizes(point, state));
        for (order, (gap, size)) in worst.iter_mut().enumerate() {
            let apart = (one[order][0] - other[order][0]).hypot(one[order][1] - other[order][1]);
            *gap = if apart.is_nan() { apart } else { gap.max(apart) };
            *size = size.max(sizes[0][order]).max(sizes[1][order]);
        }
    }
    worst
}

/// The sizes of what place, velocity and acceleration of a point are added up from.
fn sizes(point: BodyPoint, state: &PlanarState) -> [f64; 3] {
    let reach = point.at[0].hypot(point.at[1]);
    let Some(body) = point.on else { return [reach, 0.0, 0.0] };
    let ([x, y, _], [vx, vy, w]) = (state.positions[body], state.velocities[body]);
    let [ax, ay, turning] = state.accelerations[body];
    [x.hypot(y) + reach, vx.hypot(vy) + w.abs() * reach, ax.hypot(ay) + (turning.abs() + w * w) * reach]
}

/// Magnitudes of position, velocity and acceleration of points, wherever on the bodies they lie: a pin at rest closes
/// as well as the mechanism that turns about it.
pub(crate) fn rotation_sizes(system: &Model, state: &PlanarState) -> [f64; 3] {
    let arm = system.size();
    let fastest = state.velocities.iter().fold(0.0f64, |most, [.., w]| most.max(w.abs()));
    let hardest = state.accelerations.iter().fold(0.0f64, |most, [.., turning]| most.max(turning.abs()));
    [arm, fastest * arm, (hardest + fastest * fastest) * arm]
}

/// Holds angles, angular velocities and angular accelerations of the bodies to the closure of all pins. `errors` are
/// what each of the three may be off by, as numbers of the bodies; `driving` is the size of the accelerations that
/// balance where nothing moves.
pub(crate) fn check_pins<W: Worksheet>(
    system: &Model,
    state: &PlanarState,
    (errors, driving): ([f64; 3], f64),
    sheet: W,
) {
    let arm = system.size();
    let least = [0.0, 0.0, driving];
    let whats = [
        "the points that each pin joins coincide, with the angles of the bodies",
        "the points that each pin joins have the same velocity, with the angular velocities of the bodies",
        "the points that each pin joins have the same acceleration, with the angular accelerations of the bodies",
    ];
    for (order, (what, (gap, size))) in whats.into_iter().zip(pins(system, state)).enumerate() {
        sheet.check_residual(what, gap.into(), size.max(least[order]), errors[order] * arm);
    }
}

/// The acceleration that the weights, or the largest force in a joint, would give the mechanism by themselves.
pub(crate) fn driving(system: &Model, multipliers: &[f64]) -> f64 {
    let mechanism = system.mechanism();
    let [x, y] = mechanism.gravity;
    let forces = system.equations().iter().zip(multipliers);
    let forces = forces.filter(|(equation, _)| !equation.terms[0].measure.is_angle());
    let largest = forces.fold(0.0f64, |most, (_, force)| most.max(force.abs()));
    let mass: f64 = mechanism.bodies.iter().map(|body| body.mass).sum();
    x.hypot(y) + if mass > 0.0 { largest / mass } else { 0.0 }
}

/// Holds place, velocity and acceleration of a point to those of the nearest body beyond a pin, and what the point does
/// against the pin; nothing where its body has no pin. `errors` are what each may be off by.
pub(crate) fn check_point<W: Worksheet>(
    system: &Model,
    state: &PlanarState,
    (point, name): (BodyPoint, &str),
    shown: [[f64; 2]; 3],
    errors: [f64; 3],
    sheet: W,
) {
    let Some(body) = point.on else { return };
    let own = |end: BodyPoint| end.on == point.on;
    let beyond = system.mechanism().joints.iter().find_map(|joint| match *joint {
        PlanarJoint::Pin { a, b } if own(a) && !own(b) => Some((a, b)),
        PlanarJoint::Pin { a, b } if own(b) && !own(a) => Some((b, a)),
        _ => None,
    });
    let Some((here, there)) = beyond else { return };
    let (sin, cos) = state.positions[body][2].sin_cos();
    let [x, y] = [point.at[0] - here.at[0], point.at[1] - here.at[1]];
    let [x, y] = [cos * x - sin * y, sin * x + cos * y];
    let (w, turning) = (state.velocities[body][2], state.accelerations[body][2]);
    let against = [[x, y], [-w * y, w * x], [-turning * y - w * w * x, turning * x - w * w * y]];
    let end = system.point(there, state);
    let (reach, far) = (x.hypot(y), sizes(there, state));
    let rates = [reach, w.abs() * reach, (turning.abs() + w * w) * reach];
    let whats = [
        "position of {name} from the adjacent body, through their pin",
        "velocity of {name} from the adjacent body, through their pin",
        "acceleration of {name} from the adjacent body, through their pin",
    ];
    let least = rotation_sizes(system, state);
    let own = sizes(point, state);
    for (order, what) in whats.into_iter().enumerate() {
        let gap = [0, 1].map(|axis| end[order][axis] + against[order][axis] - shown[order][axis]);
        let size = far[order].max(own[order]).max(rates[order]).max(least[order]);
        let what = Text::new(what).with("name", name);
        sheet.check_residual(what, gap[0].hypot(gap[1]).into(), size, errors[order]);
    }
}
