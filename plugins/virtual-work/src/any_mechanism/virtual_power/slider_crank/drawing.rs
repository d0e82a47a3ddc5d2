//! The sketch of the slider-crank.

use dalembert_core::{Drawing, Ink, Reference, Sketch, Text, exhibit::Point as At};
use nalgebra::Vector3;

use super::{super::MovingPoint, GivenSliderCrank, VirtualPower};
use crate::shared::figure::letter;

/// The mechanism with the velocities that were given and the forces on rod and slider; arrows of each kind are in
/// scale with each other.
pub(super) fn draw(
    problem: &VirtualPower,
    mechanism: &GivenSliderCrank,
    (crank, rod, crank_angle, rod_angle): (f64, f64, f64, f64),
) -> Drawing {
    let a = (crank * crank_angle.cos(), crank * crank_angle.sin());
    let b = (a.0 + rod * rod_angle.cos(), a.1 + rod * rod_angle.sin());
    let g = (f64::midpoint(a.0, b.0), f64::midpoint(a.1, b.1));
    let size = 0.12 * crank.max(0.4 * rod);
    let o = (0.0, 0.0);
    let letters = |body: Reference| {
        let of = &problem.bodies[body.0];
        let given = [("m", of.mass), ("I_G", of.inertia)];
        let given = given.iter().filter(|(_, value)| *value != 0.0);
        let words: Vec<String> = given.map(|(symbol, _)| letter(symbol, body.0 + 1)).collect();
        Text::verbatim(words.join(", "))
    };
    let mut sketch = Sketch::new("The slider-crank with given velocities and forces");
    sketch
        .axis(o, (0.9 * crank, 0.0))
        .guide((b.0 - 3.0 * size, b.1), (b.0 + 5.0 * size, b.1))
        .slider("", b, 0.0)
        .link("r", o, a)
        .link("l", a, b)
        .axis(a, (a.0 + 0.6 * rod, a.1))
        .angle("θ_c", o, 0.0, crank_angle)
        .angle("θ_r", a, rod_angle, 0.0)
        .pin("O", o)
        .joint("A", a)
        .joint("B", b)
        .mass_centre(letters(mechanism.rod), g)
        .label(letters(mechanism.slider), (b.0, b.1 - 0.3 * size));
    let way = |speed: f64| if speed > 0.0 { (1.8, 3.1) } else { (3.1, 1.8) };
    if mechanism.crank_speed != 0.0 {
        sketch.couple("ω_c", o, way(mechanism.crank_speed), Ink::Motion);
    }
    let turns = problem.bodies[mechanism.rod.0].angular_velocity;
    if turns != 0.0 {
        sketch.couple(Text::verbatim(letter("ω", mechanism.rod.0 + 1)), g, way(turns), Ink::Motion);
    }
    let velocity = |body: Reference| problem.bodies[body.0].velocity;
    let mut arrows = |arrows: &[(At, Vector3<f64>, Text)], ink: Ink| {
        let largest = arrows.iter().fold(0.0f64, |most, (_, vector, _)| most.max(vector.norm()));
        for (tail, vector, name) in arrows.iter().filter(|(_, vector, _)| vector.norm() > 0.0) {
            let arrow = vector * (5.0 * size / largest);
            let head = (tail.0 + arrow.x, tail.1 + arrow.y);
            sketch.vector(name.clone(), *tail, head, ink);
        }
    };
    arrows(
        &[
            (g, velocity(mechanism.rod), Text::verbatim(letter("V_G", mechanism.rod.0 + 1))),
            (b, velocity(mechanism.slider), Text::verbatim(letter("V_G", mechanism.slider.0 + 1))),
        ],
        Ink::Motion,
    );
    let forces: Vec<(At, Vector3<f64>, Text)> = problem
        .forces
        .iter()
        .filter_map(|force| {
            let MovingPoint::MassCentre { body } = force.point else { return None };
            let at = if body == mechanism.slider { b } else { g };
            let known = body == mechanism.slider || body == mechanism.rod;
            known.then(|| (at, force.force, Text::new("{x}").with("x", &force.name)))
        })
        .collect();
    arrows(&forces, Ink::Force);
    sketch.finish()
}
