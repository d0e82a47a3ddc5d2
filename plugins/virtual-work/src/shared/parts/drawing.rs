//! The drawing of a mechanism.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use dalembert_core::{Ink, Reference, Sketch};
use dalembert_mechanics::planar::{BodyFrame, Model, Pose, Profile};

use super::{
    Connection, Follower, Joint, PartLoad, Parts,
    assembled::{geneva_wheel, outline},
    verbatim,
};

impl Parts {
    /// The size of the drawing; that of the mechanism where all points are in one place.
    pub(crate) fn size(&self, system: &Model, positions: &[[f64; 3]]) -> f64 {
        let all: Vec<(f64, f64)> =
            (0..self.points.len()).map(|row| self.place(Reference(row), positions)).collect();
        let extent = |of: fn(&(f64, f64)) -> f64| {
            let (low, high) = all.iter().map(of).fold((f64::MAX, f64::MIN), |(a, b), x| (a.min(x), b.max(x)));
            high - low
        };
        let largest = if all.is_empty() { 0.0 } else { extent(|p| p.0).max(extent(|p| p.1)) };
        if largest > 0.0 { largest } else { system.size() }
    }

    /// Position of a point.
    pub(crate) fn place(&self, point: Reference, positions: &[[f64; 3]]) -> (f64, f64) {
        let point = self.point(point);
        let [x, y] = point.on.map_or(point.at, |body| Pose::new(positions[body]).point(point.at));
        (x, y)
    }

    /// The bodies as lines through their points, and springs and rods between theirs.
    pub(crate) fn outline(&self, positions: &[[f64; 3]], ink: Ink, sketch: &mut Sketch) {
        let at = |reference: Reference| self.place(reference, positions);
        for body in 0..self.bodies.len() {
            let carried = self.points.iter().enumerate().filter(|(_, spot)| spot.on == Some(body));
            let mut corners: Vec<(f64, f64)> = carried.map(|(row, _)| at(Reference(row))).collect();
            if corners.len() > 2 {
                corners.push(corners[0]);
            }
            if corners.len() > 1 {
                sketch.curve(corners, ink);
            }
        }
        for connection in &self.joints {
            match &connection.joint {
                Joint::Rod { from, to, .. } => {
                    sketch.curve([at(*from), at(*to)], ink);
                }
                Joint::Cord { runs, .. } => runs.iter().for_each(|run| {
                    sketch.cord([at(run.from), at(run.to)]);
                }),
                _ => {}
            }
        }
        for load in &self.loads {
            if let PartLoad::Spring { from, to, .. } = &load.load {
                sketch.spring("", at(*from), at(*to));
            }
        }
    }

    /// Bodies, joints and loads of a position, with their letters.
    pub(crate) fn draw(&self, positions: &[[f64; 3]], size: f64, sketch: &mut Sketch) {
        let at = |reference: Reference| self.place(reference, positions);
        sketch.size(size);
        for connection in &self.joints {
            match &connection.joint {
                Joint::Slider { guide, direction, slides, .. }
                | Joint::Slot { guide, direction, pin: slides, .. }
                | Joint::Rolling { guide, direction, centre: slides, .. } => {
                    let turned = self.points[guide.0].on.map_or(0.0, |body| positions[body][2]);
                    let (sin, cos) = (direction + turned).sin_cos();
                    let ((gx, gy), (px, py)) = (at(*guide), at(*slides));
                    let way = (px - gx) * cos + (py - gy) * sin;
                    let (low, high) = (way.min(0.0) - 0.1 * size, way.max(0.0) + 0.1 * size);
                    let along = |s: f64| (gx + s * cos, gy + s * sin);
                    let ink = if self.points[guide.0].on.is_none() { Ink::Faint } else { Ink::Body };
                    sketch.curve([along(low), along(high)], ink);
                    match connection.joint {
                        Joint::Slider { .. } => {
                            sketch.slider("", (px, py), direction + turned);
                        }
                        Joint::Rolling { radius, .. } => {
                            let body = self.points[slides.0].on;
                            let angle = body.map_or(0.0, |body| positions[body][2]) - FRAC_PI_2;
                            let rim = (px + radius * angle.cos(), py + radius * angle.sin());
                            sketch.circle((px, py), radius, Ink::Body).axis((px, py), rim);
                        }
                        _ => {}
                    }
                }
                Joint::Contour { centre, contour, follower } => {
                    let body = self.points[centre.0].on;
                    let turned = body.map_or(0.0, |body| positions[body][2]);
                    let (x, y) = at(*centre);
                    let corner = |[angle, radius]: [f64; 2]| {
                        (x + radius * (angle + turned).cos(), y + radius * (angle + turned).sin())
                    };
                    if let Some(outline) = outline(contour) {
                        sketch.curve(corners_of(&outline).map(corner).collect::<Vec<_>>(), Ink::Body);
                    }
                    if let Follower::Roller { centre, radius } = follower {
                        sketch.circle(at(*centre), *radius, Ink::Body);
                    }
                }
                Joint::Geneva { driver, wheel, carrier, slots, pin, .. } => {
                    let centres = [driver, wheel].map(|body| self.bearing(body.0, carrier.frame()));
                    let [angle, turned] = [driver, wheel].map(|body| positions[body.0][2]);
                    if let [Some(driver), Some(wheel)] = centres {
                        let assembled = self.slot_angle(connection, positions).unwrap_or(turned);
                        draw_geneva([at(driver), at(wheel)], (*slots, assembled, angle + pin), sketch);
                    }
                }
                _ => {}
            }
        }
        self.outline(positions, Ink::Body, sketch);
        for (row, spot) in self.points.iter().enumerate() {
            // Pins of several bodies lie on each other under the first of their names; a point described in place has no
            // letter.
            let point = at(Reference(row));
            let lies_on = |before: usize| {
                let other = at(Reference(before));
                (other.0 - point.0).hypot(other.1 - point.1) < 1e-6 * size
            };
            if spot.name.contains('(') || (0..row).any(lies_on) {
                continue;
            }
            let name = verbatim(&spot.name);
            match spot.on {
                None => sketch.pin(name, point),
                Some(_) => sketch.joint(name, point),
            };
        }
        self.draw_loads(positions, size, sketch);
        self.letters(positions, size, sketch);
    }

    /// The pin of a body on its carrier.
    fn bearing(&self, body: usize, carrier: BodyFrame) -> Option<Reference> {
        self.joints.iter().find_map(|connection| match connection.joint {
            Joint::Pin { a, b } => match [a, b].map(|end| self.points[end.0].on) {
                [on, other] if on == carrier && other == Some(body) => Some(a),
                [on, other] if on == Some(body) && other == carrier => Some(b),
                _ => None,
            },
            _ => None,
        })
    }

    /// The direction of a slot of a Geneva wheel from its centre.
    fn slot_angle(&self, connection: &Connection, positions: &[[f64; 3]]) -> Option<f64> {
        let Joint::Geneva { driver, carrier, slots, direction, pin, .. } = &connection.joint else {
            return None;
        };
        let carried = carrier.frame().map_or(0.0, |body| positions[body][2]);
        let geometry = geneva_wheel(*slots, *direction, *pin)?;
        Some(direction + carried + PI + geometry.at(positions[driver.0][2] - carried)[0])
    }

    fn draw_loads(&self, positions: &[[f64; 3]], size: f64, sketch: &mut Sketch) {
        let at = |reference: Reference| self.place(reference, positions);
        let largest = self.loads.iter().fold(0.0f64, |most, load| match &load.load {
            PartLoad::Force { force, .. } => most.max(force.norm()),
            _ => most,
        });
        for load in &self.loads {
            match &load.load {
                PartLoad::Force { at: point, force, axes } if largest > 0.0 => {
                    let turned = axes.frame().map_or(0.0, |body| positions[body][2]);
                    let (sin, cos) = turned.sin_cos();
                    let (x, y) = (force.x * cos - force.y * sin, force.x * sin + force.y * cos);
                    let tip = at(*point);
                    let scale = 0.25 * size / largest;
                    let tail = (tip.0 - scale * x, tip.1 - scale * y);
                    sketch.force("", tail, tip);
                    if load.name != self.points[point.0].name {
                        sketch.label(verbatim(&load.name), tail);
                    }
                }
                PartLoad::Damper { from, to, .. } | PartLoad::Gas { from, to, .. } => {
                    sketch.damper("", at(*from), at(*to));
                }
                PartLoad::Thrust { from, to, .. } => {
                    sketch.force("", at(*from), at(*to));
                }
                _ => {}
            }
        }
    }
}

/// A Geneva wheel with its slots and the arm of its driver, from the centres of driver and wheel, the number of slots, the
/// direction of one of them and that of the arm.
fn draw_geneva([driver, wheel]: [(f64, f64); 2], (slots, slot, arm): (u32, f64, f64), sketch: &mut Sketch) {
    let distance = (wheel.0 - driver.0).hypot(wheel.1 - driver.1);
    let half = PI / f64::from(slots);
    let (rim, inner, crank) = (distance * half.cos(), distance * (1.0 - half.sin()), distance * half.sin());
    let away =
        |(x, y): (f64, f64), radius: f64, angle: f64| (x + radius * angle.cos(), y + radius * angle.sin());
    sketch.circle(wheel, rim, Ink::Body);
    for n in 0..slots {
        let angle = slot + 2.0 * half * f64::from(n);
        sketch.line("", away(wheel, inner, angle), away(wheel, rim, angle), Ink::Faint);
    }
    let pin = away(driver, crank, arm);
    sketch.curve([driver, pin], Ink::Body).joint("", pin);
}

/// The contour of a cam at equal angles, closed.
fn corners_of(outline: &Profile) -> impl Iterator<Item = [f64; 2]> {
    const PARTS: usize = 72;
    (0..=PARTS).map(|n| TAU * n as f64 / PARTS as f64).map(|angle| [angle, outline.at(angle)[0]])
}
