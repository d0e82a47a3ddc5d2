//! Signs that the figures of linkages share: masses of links, speeds and torques of cranks, forces on sliders.

use dalembert_core::{Ink, Sketch, Text, exhibit::Point as At};
use dalembert_units::subscript;

use super::works::LinkMass;

/// A symbol of a part with a number: `m₃`.
pub(crate) fn letter(symbol: &str, number: usize) -> String {
    format!("{symbol}{}", subscript(number))
}

/// The mass of a link at its centre, from the first pin of the link to its second, with the lengths and angles that place
/// it. Its distance is drawn at the side that the shift of a dimension says.
pub(crate) fn link_mass(
    sketch: &mut Sketch,
    number: usize,
    mass: Option<&LinkMass>,
    (from, to): (At, At),
    shift: f64,
) {
    let word = |symbol: &str| Text::verbatim(letter(symbol, number));
    let along = (to.1 - from.1).atan2(to.0 - from.0);
    match mass {
        Some(&LinkMass::Uniform { mass }) if mass != 0.0 => {
            sketch.mass_centre(word("m"), (f64::midpoint(from.0, to.0), f64::midpoint(from.1, to.1)));
        }
        None | Some(LinkMass::Uniform { .. }) => {}
        Some(&LinkMass::Given { mass, distance, offset, inertia }) => {
            let centre = away(from, distance, along + offset);
            if offset != 0.0 {
                sketch.axis(from, centre).angle(word("δ"), from, along, along + offset);
            }
            if distance != 0.0 {
                sketch.dimension(word("ρ"), from, centre, shift);
            }
            let inertia = if inertia == 0.0 { String::new() } else { format!(", {}", letter("I", number)) };
            if mass != 0.0 {
                sketch.mass_centre(Text::verbatim(letter("m", number) + &inertia), centre);
            }
        }
    }
}

/// The speed of a crank and the torque on it, as arrows round its bearing; what is zero is not drawn.
pub(crate) fn turning(
    sketch: &mut Sketch,
    bearing: At,
    (speed_symbol, speed): (&'static str, f64),
    (torque_symbol, torque): (&'static str, f64),
) {
    let arrow = |low: f64, high: f64, value: f64| if value > 0.0 { (low, high) } else { (high, low) };
    if speed != 0.0 {
        sketch.couple(speed_symbol, bearing, arrow(1.8, 3.1, speed), Ink::Motion);
    }
    if torque != 0.0 {
        sketch.couple(torque_symbol, bearing, arrow(3.4, 4.3, torque), Ink::Force);
    }
}

/// A force on a slider along its way, at the side to which it leaves the box visible: it pulls from the edge or
/// pushes at it.
pub(crate) fn on_slider(
    sketch: &mut Sketch,
    name: &'static str,
    at: At,
    (force, direction): (f64, f64),
    length: f64,
) {
    let half = 2.4 * sketch.symbol();
    let (near, far) = (away(at, half, direction), away(at, half + length, direction));
    if force > 0.0 {
        sketch.force(name, near, far);
    } else if force < 0.0 {
        // The name of a force that pushes stands at its free end.
        sketch.force("", far, near).label(name, far);
    }
}

/// The ends of the way of a slider, from its positions over a cycle; those that are not finite are left out.
pub(crate) fn way(positions: &[(f64, f64)]) -> (f64, f64) {
    let positions = positions.iter().map(|(_, at)| *at).filter(|at| at.is_finite());
    positions.fold((f64::MAX, f64::MIN), |(low, high), at| (low.min(at), high.max(at)))
}

/// The point so far from another, in a direction.
pub(crate) fn away((x, y): At, length: f64, angle: f64) -> At {
    (x + length * angle.cos(), y + length * angle.sin())
}
