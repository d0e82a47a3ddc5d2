//! The drawing of a mechanism.

use std::f64::consts::FRAC_PI_2;

use dalembert_core::{DrawnShape, Ink, Reference};
use dalembert_mechanics::planar::{Model, Point, Pose, State};

use super::{Carrier, Joint, Load, Parts, verbatim};

impl Parts<'_> {
    /// The size of the drawing; that of the mechanism where all points are in one place.
    pub(crate) fn size(&self, system: &Model, state: &State) -> f64 {
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
    pub(crate) fn outline(&self, positions: &[[f64; 3]], ink: Ink) -> Vec<DrawnShape> {
        let at = |reference: Reference| {
            let point = self.point(reference);
            let [x, y] = point.on.map_or(point.at, |body| Pose::new(positions[body]).point(point.at));
            (x, y)
        };
        let own = |body: usize| {
            let carried =
                self.points.iter().enumerate().filter(move |(_, spot)| spot.on.frame() == Some(body));
            let mut corners: Vec<(f64, f64)> = carried.map(|(row, _)| at(Reference(row))).collect();
            if corners.len() > 2 {
                corners.push(corners[0]);
            }
            corners
        };
        let bodies = (0..self.bodies.len()).map(own).filter(|corners| corners.len() > 1);
        let bodies = bodies.map(|corners| DrawnShape::Polyline(corners, ink));
        let springs = self.loads.iter().filter_map(|load| match &load.load {
            Load::Spring { from, to, .. } => Some(DrawnShape::Spring(at(*from), at(*to))),
            _ => None,
        });
        let lines = self.joints.iter().flat_map(|connection| match &connection.joint {
            Joint::Rod { from, to, .. } => vec![DrawnShape::Polyline(vec![at(*from), at(*to)], ink)],
            Joint::Cord { runs, .. } => runs
                .iter()
                .map(|run| DrawnShape::Polyline(vec![at(run.from), at(run.to)], Ink::Faint))
                .collect(),
            _ => Vec::new(),
        });
        bodies.chain(lines).chain(springs).collect()
    }

    /// Bodies, joints and loads of a position.
    pub(crate) fn draw(&self, system: &Model, state: &State, size: f64, shapes: &mut Vec<DrawnShape>) {
        let at = |reference: Reference| place(system, self.point(reference), state);
        let small = 0.015 * size;
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
                    let ink = if matches!(self.points[guide.0].on, Carrier::Ground) {
                        Ink::Faint
                    } else {
                        Ink::Body
                    };
                    shapes.push(DrawnShape::Polyline(vec![along(low), along(high)], ink));
                    match connection.joint {
                        Joint::Slider { .. } => {
                            let (w, h) = (2.5 * small, 1.7 * small);
                            let corner = |x: f64, y: f64| (px + x * cos - y * sin, py + x * sin + y * cos);
                            let corners = [(-w, -h), (w, -h), (w, h), (-w, h), (-w, -h)];
                            let corners = corners.map(|(x, y)| corner(x, y));
                            shapes.push(DrawnShape::Polyline(corners.into(), Ink::Body));
                        }
                        Joint::Rolling { radius, .. } => {
                            let body = self.points[slides.0].on.frame();
                            let angle = body.map_or(0.0, |body| state.positions[body][2]) - FRAC_PI_2;
                            let rim = (px + radius * angle.cos(), py + radius * angle.sin());
                            shapes.push(DrawnShape::Circle((px, py), radius, Ink::Body));
                            shapes.push(DrawnShape::Polyline(vec![(px, py), rim], Ink::Faint));
                        }
                        _ => {}
                    }
                }
                _ => {}
            }
        }
        shapes.extend(self.outline(&state.positions, Ink::Body));
        for (row, spot) in self.points.iter().enumerate() {
            let point = at(Reference(row));
            match spot.on {
                Carrier::Ground => shapes.push(DrawnShape::Pin(point)),
                Carrier::Body { .. } => shapes.push(DrawnShape::Circle(point, 0.5 * small, Ink::Body)),
            }
        }
        self.draw_loads(system, state, size, shapes);
    }

    fn draw_loads(&self, system: &Model, state: &State, size: f64, shapes: &mut Vec<DrawnShape>) {
        let at = |reference: Reference| place(system, self.point(reference), state);
        let largest = self.loads.iter().fold(0.0f64, |most, load| match &load.load {
            Load::Force { force, .. } => most.max(force.norm()),
            _ => most,
        });
        for load in self.loads {
            match &load.load {
                Load::Force { at: point, force, axes } if largest > 0.0 => {
                    let turned = axes.frame().map_or(0.0, |body| state.positions[body][2]);
                    let (sin, cos) = turned.sin_cos();
                    let (x, y) = (force.x * cos - force.y * sin, force.x * sin + force.y * cos);
                    let tip = at(*point);
                    let scale = 0.25 * size / largest;
                    let tail = (tip.0 - scale * x, tip.1 - scale * y);
                    shapes.push(DrawnShape::Arrow(tail, tip, Ink::Force));
                    shapes.push(DrawnShape::Label(tail, verbatim(&load.name)));
                }
                Load::Damper { from, to, .. } | Load::Gas { from, to, .. } => {
                    shapes.push(DrawnShape::Damper(at(*from), at(*to)));
                }
                Load::Thrust { from, to, .. } => {
                    shapes.push(DrawnShape::Arrow(at(*from), at(*to), Ink::Force));
                }
                _ => {}
            }
        }
    }
}

/// Position of a point.
pub(crate) fn place(system: &Model, point: Point, state: &State) -> (f64, f64) {
    let [[x, y], ..] = system.point(point, state);
    (x, y)
}
