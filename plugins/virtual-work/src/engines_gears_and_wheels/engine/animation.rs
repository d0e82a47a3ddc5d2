//! The engine in motion, with its forces.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use dalembert_core::{Exhibit, Ink, Point, Sketch};
use dalembert_mechanics::slider_crank::{engine::Forces, piston};

use super::{Gas, Throw, exhibits::View};
use crate::shared::figure;

const FRAMES: u32 = 24;

/// An animation where the forces are known over the cycle or there are none; otherwise the engine at its crank angle.
pub(super) fn show(view: &View<'_>) -> Exhibit {
    let here = view.force.map(|force| {
        let mut motion = view.kernel.motion(view.crank);
        if let Some(acceleration) = view.given_acceleration {
            motion.acceleration = acceleration;
        }
        view.kernel.forces(view.crank, &motion, force)
    });
    let start = view.crank.angle.rem_euclid(2.0 * TAU);
    if view.force.is_some() && view.cycle.is_none() {
        let size = here.as_ref().map_or(0.0, largest);
        let sketch = frame(view, start, here.as_ref(), size);
        return Exhibit::Drawing(sketch.titled("The engine at this crank angle, with its forces").finish());
    }
    let period = view.cycle.map_or(TAU, |turned| turned.period);
    let at: Vec<(f64, Option<Forces>)> = (0..FRAMES)
        .map(|k| {
            let angle = start + period * f64::from(k) / f64::from(FRAMES);
            (angle, view.cycle.map(|_| view.at(angle).1))
        })
        .collect();
    // The same wherever the animation begins, and beside the corners of the gas: where rounding decides between two forces.
    let sides = (0..4 * FRAMES).map(|k| period * (f64::from(k) + 0.4) / f64::from(4 * FRAMES));
    let size = match view.cycle {
        Some(_) => sides.map(|angle| largest(&view.at(angle).1)).fold(0.0, f64::max),
        None => 0.0,
    };
    let frames = at.iter().map(|(angle, forces)| frame(view, *angle, forces.as_ref(), size));
    let angles = at.iter().map(|(angle, _)| *angle).collect();
    let title = if view.cycle.is_some() {
        "The engine over its cycle, with its forces"
    } else {
        "The engine over one revolution"
    };
    Exhibit::Animation(Sketch::animation(title, frames, 3.0 * period / TAU).over("angle", angles))
}

fn largest(forces: &Forces) -> f64 {
    forces.effort.abs().max(forces.bearing[0].hypot(forces.bearing[1])).max(forces.guide.abs())
}

fn frame(view: &View<'_>, angle: f64, forces: Option<&Forces>, size: f64) -> Sketch {
    let kernel = view.kernel;
    let (r, l, e) = (kernel.crank, kernel.rod, kernel.offset);
    // The stroke along x of the formulas, turned until the weight points down.
    let upright = view.engine.upright();
    let (sin, cos) = if upright == FRAC_PI_2 { (1.0, 0.0) } else { upright.sin_cos() };
    let to = |(x, y): Point| (x * cos - y * sin, x * sin + y * cos);
    let obliquity = piston::obliquity_with_offset(r, l, e, angle);
    let pin = (r * angle.cos(), r * angle.sin());
    let gudgeon = (piston::position(r, l, angle, obliquity), e);
    let half = 0.35 * r;
    let far = piston::farthest(r, l, e);
    let (low, high) = (far - 2.0 * r - half, far + 1.6 * half);
    let (o, a, b) = ((0.0, 0.0), to(pin), to(gudgeon));
    let wall = e - 1.2 * half;
    let mut sketch = Sketch::default();
    sketch
        .size(far + r + 1.6 * half)
        .circle(o, r, Ink::Faint)
        .curve([(low, e + 1.2 * half), (high, e + 1.2 * half), (high, wall), (low, wall)].map(to), Ink::Faint)
        .body(
            if view.engine.reciprocating > 0.0 { "m_R" } else { "" },
            [(-half, -half), (half, -half), (half, half), (-half, half)]
                .map(|(x, y)| to((gudgeon.0 + x, e + y))),
        )
        .link("r", o, a)
        .link("l", a, b)
        .axis(o, to((0.8 * r, 0.0)))
        .angle("θ", o, upright, upright + angle.rem_euclid(TAU))
        .pin("O", o)
        .joint("A", a)
        .joint("P", b);
    if has_bore(&view.engine.gas) {
        sketch.dimension("D", to((high, wall)), to((high, e + 1.2 * half)), -2.0);
    }
    if let Throw::Stroke { .. } = view.engine.throw {
        sketch.dimension("S", to((far - 2.0 * r, wall)), to((far, wall)), -2.0);
    }
    if e != 0.0 {
        sketch.dimension("e", to((low, 0.0)), to((low, e)), 0.0);
    }
    if view.engine.friction.is_some_and(|friction| friction > 0.0) {
        // Against the motion, beside the piston; the crank turns forward.
        let way = if angle.rem_euclid(TAU) < PI { 1.0 } else { -1.0 };
        let beside = |along: f64| to((gudgeon.0 + way * along * half, e + 0.8 * half));
        sketch.force("F_f", beside(-1.0), beside(1.0));
    }
    if view.running {
        let speed = if view.crank.speed == 0.0 { 1.0 } else { view.crank.speed };
        figure::turning(&mut sketch, o, ("ω", speed), ("", 0.0));
    }
    if kernel.rod_mass > 0.0 {
        let part = kernel.rod_centre / l;
        let centre = (pin.0 + part * (gudgeon.0 - pin.0), pin.1 + part * (gudgeon.1 - pin.1));
        sketch.mass_centre("G", to(centre));
    }
    let Some(forces) = forces.filter(|_| size > 0.0) else { return sketch };
    let scale = 1.3 * r / size;
    let arrows = [
        (gudgeon, (-forces.effort, 0.0), "F_P"),
        (gudgeon, (0.0, forces.guide), "F_N"),
        (pin, (forces.bearing[0], forces.bearing[1]), "F_A"),
    ];
    for (tail, (x, y), name) in arrows {
        let (x, y) = (scale * x, scale * y);
        if x.hypot(y) >= 0.02 * r {
            sketch.force(name, to(tail), to((tail.0 + x, tail.1 + y)));
        }
    }
    sketch
}

/// True where the force is that of pressures on a piston of a known bore.
fn has_bore(gas: &Gas) -> bool {
    match gas {
        Gas::Nothing | Gas::Force { .. } | Gas::Balancing { .. } => false,
        Gas::Pressures { .. }
        | Gas::Expansion { .. }
        | Gas::Cycle { .. }
        | Gas::Stroke { .. }
        | Gas::Angle { .. } => true,
    }
}
