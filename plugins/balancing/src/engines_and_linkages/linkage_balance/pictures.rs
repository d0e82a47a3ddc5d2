//! The linkage in motion, with its counterweights.

use dalembert_core::{Animation, Ink, Point, Sketch, Text};
use dalembert_mechanics::balance::linkage::{Counterweight, Follower, LinkInertia, Linkage, Pose};

use super::PLACES;
use crate::shared::rotor::letter;

/// The linkage over a turn.
pub(super) fn animation(linkage: &Linkage, poses: &[Pose], counterweights: &[Counterweight]) -> Animation {
    let every = PLACES / 24;
    let size = match linkage.follower {
        Follower::Rocker { frame, .. } => frame + linkage.crank + linkage.coupler,
        Follower::Slider { .. } => linkage.crank + linkage.coupler,
    };
    let frame = |pose: &Pose| {
        let mut sketch = Sketch::default();
        sketch.size(size);
        draw(linkage, pose, counterweights, &mut sketch);
        sketch
    };
    Sketch::animation("The linkage with its counterweights", poses.iter().step_by(every).map(frame), 3.0)
}

fn draw(linkage: &Linkage, pose: &Pose, counterweights: &[Counterweight], sketch: &mut Sketch) {
    let [a, b, end] = pose.pins.map(|[x, y]| (x, y));
    let (o, unit) = ((0.0, 0.0), sketch.symbol());
    match linkage.follower {
        Follower::Slider { offset, mass } => {
            sketch
                .guide((b.0 - 5.0 * unit, b.1), (b.0 + 5.0 * unit, b.1))
                .slider("", b, 0.0)
                .label(if mass > 0.0 { "m₄" } else { "" }, (b.0, b.1 - 0.6 * unit));
            if offset != 0.0 {
                sketch.dimension("h", (b.0, 0.0), b, 3.0);
            }
        }
        Follower::Rocker { link, .. } => {
            sketch.link("c", b, end).dimension("d", o, end, -7.0);
            inertia(4, link, (end, b), -1.8, sketch);
        }
    }
    sketch.link("a", o, a).link("b", a, b);
    inertia(2, linkage.crank_link, (o, a), 3.0, sketch);
    inertia(3, linkage.coupler_link, (a, b), 1.8, sketch);
    sketch.pin("O₂", o).joint("A", a).joint("B", b).couple("ω", o, (1.8, 3.1), Ink::Motion);
    if let Follower::Rocker { .. } = linkage.follower {
        sketch.pin("O₄", end);
    }
    for c in counterweights {
        let from = match c.link {
            0 => o,
            1 => a,
            _ => end,
        };
        let at = away(from, c.distance, pose.angles[c.link] + c.angle);
        let name = if c.link == 0 { "R_2" } else { "R_c" };
        sketch.line(name, from, at, Ink::Result).round("", at, 0.15 * linkage.crank, Ink::Result);
    }
}

/// The mass of a link at its centre, from its first pin to its second, with the distance of the centre to that side of it.
fn inertia(number: usize, link: LinkInertia, (from, to): (Point, Point), side: f64, sketch: &mut Sketch) {
    if link.mass == 0.0 {
        return;
    }
    let along = (to.1 - from.1).atan2(to.0 - from.0);
    let centre = away(from, link.distance, along + link.offset);
    let rest = if link.inertia == 0.0 { String::new() } else { format!(", {}", letter("I", number)) };
    if link.distance != 0.0 {
        sketch.dimension(Text::verbatim(letter("ρ", number)), from, centre, side);
    }
    // A centre on the line of the pins, beyond the first one, is seen without an arc.
    if link.offset.sin().abs() > 1e-9 {
        sketch.axis(from, centre).angle(
            Text::verbatim(letter("δ", number)),
            from,
            along,
            along + link.offset,
        );
    }
    sketch.mass_centre(Text::verbatim(letter("m", number) + &rest), centre);
}

fn away((x, y): Point, length: f64, angle: f64) -> Point {
    (x + length * angle.cos(), y + length * angle.sin())
}
