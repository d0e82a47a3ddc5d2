//! Motion of the points that are asked for, and sliding along guides and slots.

use dalembert_core::{Symbol, Text, Worksheet};
use dalembert_mechanics::{
    Real, Vector,
    planar::{BodyPoint, PlanarJoint, PlanarState, RelativeCoordinate},
};
use nalgebra::Vector3;

use super::{RelativePoint, Solved, WatchedPoint, loops::Loops};
use crate::{
    shared::{
        built::turned,
        kinematics::AT_REST,
        parts::{Joint, closure},
        works::{across, direction},
    },
    sources::{NORTON, SHIGLEY},
};

/// A vector of a point that is asked for by magnitude and direction: names, labels, unit and words.
struct Polar {
    size: [&'static str; 2],
    angle: [&'static str; 2],
    symbols: [&'static str; 2],
    unit: &'static str,
    words: [&'static str; 2],
}

const VELOCITY: Polar = Polar {
    size: ["speed", "Speed of the point"],
    angle: ["velocity_angle", "Direction of the velocity"],
    symbols: ["|v_P|", "θ_v"],
    unit: "m/s",
    words: ["Speed of {name}", "Direction of the velocity of {name}, from x"],
};
const ACCELERATION: Polar = Polar {
    size: ["acceleration_size", "Magnitude of the acceleration"],
    angle: ["acceleration_angle", "Direction of the acceleration"],
    symbols: ["|a_P|", "θ_a"],
    unit: "m/s^2",
    words: ["Magnitude of the acceleration of {name}", "Direction of the acceleration of {name}, from x"],
};
const RELATIVE_VELOCITY: Polar = Polar {
    size: ["relative_speed", "Relative speed of the point"],
    angle: ["relative_velocity_angle", "Direction of the relative velocity"],
    symbols: ["|v_FQ|", "θ_vFQ"],
    unit: "m/s",
    words: ["Relative speed of {name}", "Direction of the relative velocity of {name}, from x"],
};
const RELATIVE_ACCELERATION: Polar = Polar {
    size: ["relative_acceleration_size", "Magnitude of relative acceleration"],
    angle: ["relative_acceleration_angle", "Direction of relative acceleration"],
    symbols: ["|a_FQ|", "θ_aFQ"],
    unit: "m/s^2",
    words: [
        "Magnitude of the relative acceleration of {name}",
        "Direction of the relative acceleration of {name}, from x",
    ],
};

fn vector([x, y]: [f64; 2]) -> Vector3<f64> {
    Vector3::new(x, y, 0.0)
}

impl Solved<'_> {
    /// Answers position, velocity and acceleration of the points that are asked for, and their motion relative to others.
    pub(super) fn watched<W: Worksheet>(
        &self,
        watched: &[WatchedPoint],
        closed: &mut Loops<'_, '_, W>,
        shown: &PlanarState,
        sheet: W,
    ) {
        for (row, watched) in (1..).zip(watched) {
            let name = &self.parts.points[watched.point.0].name;
            let point = self.parts.point(watched.point);
            let [position, velocity, acceleration] = self.system.point(point, self.state);
            let named = |reason: &'static str| Text::new(reason).with("name", name);
            let (place, rate) = closed.watched(watched.point, row).unzip();
            let at = place.unwrap_or_else(|| {
                sheet.numerical_vector(("r_P", row), "mm", vector(position), named("Position of {name}"))
            });
            sheet.answer_vector(("position", row), "Position of the point", at);
            sheet.row_label(("position", row), name);
            let velocity = rate.flatten().unwrap_or_else(|| {
                sheet.numerical_vector(("v_P", row), "m/s", vector(velocity), named("Velocity of {name}"))
            });
            sheet.answer_vector(("velocity", row), "Velocity of the point", velocity);
            sheet.row_label(("velocity", row), name);
            self.polar(&VELOCITY, (row, name), velocity, sheet);
            let acceleration = sheet.numerical_vector(
                ("a_P", row),
                "m/s^2",
                vector(acceleration),
                named("Acceleration of {name}"),
            );
            sheet.answer_vector(("acceleration", row), "Acceleration of the point", acceleration);
            sheet.row_label(("acceleration", row), name);
            self.polar(&ACCELERATION, (row, name), acceleration, sheet);
            sheet.verify(|| {
                let shown_of_point = [at, velocity, acceleration].map(|of| [of.value().x, of.value().y]);
                let point = (point, name.as_str());
                closure::check_point(self.system, shown, point, shown_of_point, [0.0; 3], sheet);
            });
        }
    }

    /// Answers the motion of points relative to others.
    pub(super) fn relative<W: Worksheet>(&self, pairs: &[RelativePoint], sheet: W) {
        for (row, pair) in (1..).zip(pairs) {
            let [name, other] = [pair.point, pair.to].map(|point| self.parts.points[point.0].name.as_str());
            let points = [pair.to, pair.point].map(|point| self.parts.point(point));
            self.relative_to(row, &format!("{name}/{other}"), points, sheet);
        }
    }

    fn relative_to<W: Worksheet>(&self, row: usize, name: &str, [from, to]: [BodyPoint; 2], sheet: W) {
        let named = |reason: &'static str| Text::new(reason).with("name", name);
        let [start, of_velocity, of_acceleration] = self.system.point(from, self.state);
        let [_, velocity, acceleration] = self.system.point(to, self.state);
        let why = named("Velocity of the first point of {name}");
        let velocity = sheet.numerical_vector(("v_F", row), "m/s", vector(velocity), why);
        let why = named("Acceleration of the first point of {name}");
        let acceleration = sheet.numerical_vector(("a_F", row), "m/s^2", vector(acceleration), why);
        let why = named("Velocity of the second point of {name}");
        let other = sheet.numerical_vector(("v_Q", row), "m/s", vector(of_velocity), why);
        let why = (named("Velocity of {name}: v_F − v_Q"), SHIGLEY.at("ch. 3"));
        let relative = sheet.step_vector(("v_FQ", row), "m/s", velocity - other, why);
        sheet.answer_vector(("relative_velocity", row), "Relative velocity of the point", relative);
        sheet.row_label(("relative_velocity", row), name);
        self.polar(&RELATIVE_VELOCITY, (row, name), relative, sheet);
        let why = named("Acceleration of the second point of {name}");
        let other = sheet.numerical_vector(("a_Q", row), "m/s^2", vector(of_acceleration), why);
        let why = (named("Acceleration of {name}: a_F − a_Q"), SHIGLEY.at("ch. 4"));
        let bent = sheet.step_vector(("a_FQ", row), "m/s^2", acceleration - other, why);
        sheet.answer_vector(("relative_acceleration", row), "Relative acceleration of the point", bent);
        sheet.row_label(("relative_acceleration", row), name);
        self.polar(&RELATIVE_ACCELERATION, (row, name), bent, sheet);
        sheet.verify(|| {
            let [end, ..] = self.system.point(to, self.state);
            let way = [end[0] - start[0], end[1] - start[1]];
            let [_, fast, hard] = closure::rotation_sizes(self.system, self.state);
            let [[vx, vy, _], [ax, ay, _]] = [relative.components(), bent.components()];
            if let Some(body) = self.common_body([from, to]) {
                let [_, _, w] = self.state.velocities[body];
                let [_, _, alpha] = self.state.accelerations[body];
                let what = "relative velocity of {name} on one body is ω × r, along x";
                sheet.check_sum(named(what), vx, (-w * way[1]).into(), fast);
                let what = "relative velocity of {name} on one body is ω × r, along y";
                sheet.check_sum(named(what), vy, (w * way[0]).into(), fast);
                let by_rotation = [-alpha * way[1] - w * w * way[0], alpha * way[0] - w * w * way[1]];
                let what = "relative acceleration of {name} on one body is α × r − ω² r, along x";
                sheet.check_sum(named(what), ax, by_rotation[0].into(), hard);
                let what = "relative acceleration of {name} on one body is α × r − ω² r, along y";
                sheet.check_sum(named(what), ay, by_rotation[1].into(), hard);
            } else {
                let measure = |u: [f64; 2]| RelativeCoordinate::Component { direction: u, from, to };
                let rates = [[1.0, 0.0], [0.0, 1.0]].map(|u| self.system.rate(&measure(u), self.state));
                let what = "relative velocity of {name} as the rate of its distance along x";
                sheet.check_sum(named(what), vx, rates[0].into(), fast);
                let what = "relative velocity of {name} as the rate of its distance along y";
                sheet.check_sum(named(what), vy, rates[1].into(), fast);
            }
        });
    }

    /// A body that both points belong to, themselves or through pins.
    fn common_body(&self, [from, to]: [BodyPoint; 2]) -> Option<usize> {
        let bodies = |point: BodyPoint| {
            let beyond = self.system.mechanism().joints.iter().filter_map(move |joint| match *joint {
                PlanarJoint::Pin { a, b } if a == point => b.on,
                PlanarJoint::Pin { a, b } if b == point => a.on,
                _ => None,
            });
            point.on.into_iter().chain(beyond)
        };
        bodies(from).find(|body| bodies(to).any(|other| other == *body))
    }

    /// Answers a vector by magnitude and, if it is not at rest, by direction.
    fn polar<W: Worksheet>(&self, of: &Polar, (row, name): (usize, &str), value: W::Vec, sheet: W) {
        let [_, fast, hard] = closure::rotation_sizes(self.system, self.state);
        let scale = if of.unit == "m/s" { fast } else { hard };
        if value.value().norm() <= AT_REST * scale {
            return;
        }
        let named = |reason: &'static str| Text::new(reason).with("name", name);
        let size =
            sheet.step(Symbol::from((of.symbols[0], row)), of.unit, value.magnitude(), named(of.words[0]));
        sheet.answer((of.size[0], row), of.size[1], size);
        sheet.row_label((of.size[0], row), name);
        let [x, y, _] = value.components();
        let angle = sheet.step((of.symbols[1], row), "deg", y.atan2(x), named(of.words[1]));
        sheet.answer((of.angle[0], row), of.angle[1], angle);
        sheet.row_label((of.angle[0], row), name);
        sheet.verify(|| {
            let what = named("{name}: magnitude and direction make up the vector");
            sheet.check_vector(what, direction::<W>(angle) * size, value);
        });
    }

    /// Answers the sliding along each slider and slot of a mechanism that moves, with the Coriolis acceleration where the
    /// guide belongs to a body.
    pub(super) fn sliding<W: Worksheet>(&self, sheet: W) {
        let rates = self.state.velocities.iter().chain(&self.state.accelerations);
        if rates.flatten().all(|rate| *rate == 0.0) {
            return;
        }
        for (row, connection) in (1..).zip(&self.parts.joints) {
            let (guide, angle, slides) = match connection.joint {
                Joint::Slider { guide, direction, slides, .. } => (guide, direction, slides),
                Joint::Slot { guide, direction, pin, .. } => (guide, direction, pin),
                _ => continue,
            };
            let points = [self.parts.point(guide), self.parts.point(slides)];
            self.slides((row, &connection.name), points, angle, sheet);
        }
    }

    fn slides<W: Worksheet>(
        &self,
        (row, name): (usize, &str),
        [guide, slides]: [BodyPoint; 2],
        angle: f64,
        sheet: W,
    ) {
        let named = |reason: &'static str| Text::new(reason).with("name", name);
        let [place, velocity, acceleration] = self.system.point(slides, self.state);
        let pose = |body: usize| self.state.positions[body];
        let under = BodyPoint {
            on: guide.on,
            at: guide.on.map_or(place, |body| {
                let [x, y, turn] = pose(body);
                turned([place[0] - x, place[1] - y], -turn)
            }),
        };
        let [_, of_guide, bend_of_guide] = self.system.point(under, self.state);
        let line = angle + guide.on.map_or(0.0, |body| pose(body)[2]);
        let line = vector([line.cos(), line.sin()]);
        let along = sheet.numerical_vector(("ê", row), "1", line, named("Unit vector along {name}"));
        let why = named("Velocity of what slides in {name}");
        let mut relative = sheet.numerical_vector(("v_C", row), "m/s", vector(velocity), why);
        let why = named("Acceleration of what slides in {name}");
        let mut bent = sheet.numerical_vector(("a_C", row), "m/s^2", vector(acceleration), why);
        if guide.on.is_some() {
            let why = named("Velocity of the point of the guide of {name} that is under it");
            relative = relative - sheet.numerical_vector(("v_U", row), "m/s", vector(of_guide), why);
            let why = named("Acceleration of the point of the guide of {name} that is under it");
            bent = bent - sheet.numerical_vector(("a_U", row), "m/s^2", vector(bend_of_guide), why);
        }
        let why = (named("Velocity of slip along {name}"), NORTON.at("ch. 6"));
        let slip = sheet.step(("v_s", row), "m/s", relative.dot(along), why);
        sheet.answer(("slip_velocity", row), "Velocity of slip", slip);
        sheet.row_label(("slip_velocity", row), name);
        let why = (named("Acceleration of slip along {name}"), NORTON.at("ch. 7"));
        let slips = sheet.step(("a_s", row), "m/s^2", bent.dot(along), why);
        sheet.answer(("slip_acceleration", row), "Acceleration of slip", slips);
        sheet.row_label(("slip_acceleration", row), name);
        let coriolis = guide.on.map(|body| {
            let why = named("Angular velocity of the guide of {name}");
            let turning = sheet.numerical(("ω_g", row), "rad/s", self.state.velocities[body][2], why);
            let why =
                (named("Coriolis acceleration in {name}, 2 ω v_s, perpendicular to it"), NORTON.at("ch. 7"));
            let coriolis = sheet.step(("a_c", row), "m/s^2", turning * slip * 2.0, why);
            sheet.answer(("coriolis_acceleration", row), "Coriolis acceleration", coriolis);
            sheet.row_label(("coriolis_acceleration", row), name);
            coriolis
        });
        sheet.verify(|| {
            let [_, fast, hard] = closure::rotation_sizes(self.system, self.state);
            let measure =
                RelativeCoordinate::Along { direction: [angle.cos(), angle.sin()], from: guide, to: slides };
            let rate = self.system.rate(&measure, self.state);
            let what = "velocity of slip as the rate of the distance along {name}";
            sheet.check_sum(named(what), slip, rate.into(), fast);
            let coriolis = coriolis.unwrap_or_else(|| W::Num::from(0.0));
            let what = "acceleration across {name} is the Coriolis acceleration";
            sheet.check_sum(named(what), bent.dot(across::<W>(along)), coriolis, hard);
            let what =
                "acceleration of slip and Coriolis acceleration make up the relative acceleration in {name}";
            sheet.check_sum(named(what), slips.powi(2) + coriolis.powi(2), bent.dot(bent), hard.powi(2));
        });
    }
}
