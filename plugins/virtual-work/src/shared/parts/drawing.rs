//! The drawing of a mechanism.

use std::f64::consts::FRAC_PI_2;

use dalembert_core::{Ink, Reference, Sketch};
use dalembert_mechanics::planar::{BodyPoint, Model, PlanarState, Pose};

use super::{Joint, PartLoad, PartReference, Parts, verbatim};

impl Parts<'_> {
    /// The size of the drawing; that of the mechanism where all points are in one place.
    pub(crate) fn size(&self, system: &Model, state: &PlanarState) -> f64 {
        let all: Vec<(f64, f64)> =
            (0..self.points.len()).map(|row| place(system, self.point(Reference(row)), state)).collect();
        let extent = |of: fn(&(f64, f64)) -> f64| {
            let (low, high) = all.iter().map(of).fold((f64::MAX, f64::MIN), |(a, b), x| (a.min(x), b.max(x)));
            high - low
        };
        let largest = if all.is_empty() { 0.0 } else { extent(|p| p.0).max(extent(|p| p.1)) };
        if largest > 0.0 { largest } else { system.size() }
    }

    /// The bodies as lines through their points, and springs and rods between theirs.
    pub(crate) fn outline(&self, positions: &[[f64; 3]], ink: Ink, sketch: &mut Sketch) {
        let at = |reference: Reference| {
            let point = self.point(reference);
            let [x, y] = point.on.map_or(point.at, |body| Pose::new(positions[body]).point(point.at));
            (x, y)
        };
        for body in 0..self.bodies.len() {
            let carried = self.points.iter().enumerate().filter(|(_, spot)| spot.on.frame() == Some(body));
            let mut corners: Vec<(f64, f64)> = carried.map(|(row, _)| at(Reference(row))).collect();
            if corners.len() > 2 {
                corners.push(corners[0]);
            }
            if corners.len() > 1 {
                sketch.curve(corners, ink);
            }
        }
        for connection in self.joints {
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
        for load in self.loads {
            if let PartLoad::Spring { from, to, .. } = &load.load {
                sketch.spring("", at(*from), at(*to));
            }
        }
    }

    /// Bodies, joints and loads of a position.
    pub(crate) fn draw(&self, system: &Model, state: &PlanarState, size: f64, sketch: &mut Sketch) {
        let at = |reference: Reference| place(system, self.point(reference), state);
        sketch.size(size);
        for connection in self.joints {
            match &connection.joint {
                Joint::Slider { guide, direction, slides, .. }
                | Joint::Slot { guide, direction, pin: slides, .. }
                | Joint::Rolling { guide, direction, centre: slides, .. } => {
                    let turned = self.points[guide.0].on.frame().map_or(0.0, |body| state.positions[body][2]);
                    let (sin, cos) = (direction + turned).sin_cos();
                    let ((gx, gy), (px, py)) = (at(*guide), at(*slides));
                    let way = (px - gx) * cos + (py - gy) * sin;
                    let (low, high) = (way.min(0.0) - 0.1 * size, way.max(0.0) + 0.1 * size);
                    let along = |s: f64| (gx + s * cos, gy + s * sin);
                    let ink = if matches!(self.points[guide.0].on, PartReference::Ground) {
                        Ink::Faint
                    } else {
                        Ink::Body
                    };
                    sketch.curve([along(low), along(high)], ink);
                    match connection.joint {
                        Joint::Slider { .. } => {
                            sketch.slider("", (px, py), direction + turned);
                        }
                        Joint::Rolling { radius, .. } => {
                            let body = self.points[slides.0].on.frame();
                            let angle = body.map_or(0.0, |body| state.positions[body][2]) - FRAC_PI_2;
                            let rim = (px + radius * angle.cos(), py + radius * angle.sin());
                            sketch.circle((px, py), radius, Ink::Body).axis((px, py), rim);
                        }
                        _ => {}
                    }
                }
                _ => {}
            }
        }
        self.outline(&state.positions, Ink::Body, sketch);
        for (row, spot) in self.points.iter().enumerate() {
            let (name, point) = (verbatim(&spot.name), at(Reference(row)));
            match spot.on {
                PartReference::Ground => sketch.pin(name, point),
                PartReference::Body { .. } => sketch.joint(name, point),
            };
        }
        self.draw_loads(system, state, size, sketch);
    }

    fn draw_loads(&self, system: &Model, state: &PlanarState, size: f64, sketch: &mut Sketch) {
        let at = |reference: Reference| place(system, self.point(reference), state);
        let largest = self.loads.iter().fold(0.0f64, |most, load| match &load.load {
            PartLoad::Force { force, .. } => most.max(force.norm()),
            _ => most,
        });
        for load in self.loads {
            match &load.load {
                PartLoad::Force { at: point, force, axes } if largest > 0.0 => {
                    let turned = axes.frame().map_or(0.0, |body| state.positions[body][2]);
                    let (sin, cos) = turned.sin_cos();
                    let (x, y) = (force.x * cos - force.y * sin, force.x * sin + force.y * cos);
                    let tip = at(*point);
                    let scale = 0.25 * size / largest;
                    let tail = (tip.0 - scale * x, tip.1 - scale * y);
                    sketch.force("", tail, tip).label(verbatim(&load.name), tail);
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

/// Position of a point.
pub(crate) fn place(system: &Model, point: BodyPoint, state: &PlanarState) -> (f64, f64) {
    let [[x, y], ..] = system.point(point, state);
    (x, y)
}
