//! The sketch of the slider-crank.

use dalembert_core::{Drawing, Ink, Reference, Sketch, Text, exhibit::Point as At};
use nalgebra::Vector3;

use super::{super::MovingPoint, GivenSliderCrank, VirtualPower};

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
    let mut sketch = Sketch::new("The slider-crank with given velocities and forces");
    sketch
        .circle(o, crank, Ink::Faint)
        .guide((0.0, b.1), (b.0 + 4.0 * size, b.1))
        .slider("", b, 0.0)
        .bars([o, a, b])
        .pin("O", o)
        .joint("A", a)
        .joint("B", b)
        .mass_centre("G", g);
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
        &[(g, velocity(mechanism.rod), "V_G".into()), (b, velocity(mechanism.slider), "V_B".into())],
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
