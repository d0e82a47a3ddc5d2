//! Angles and angular velocities of the bodies of a mechanism in closed form: driven cranks, pairs of bodies that close a
//! loop of pins, connecting rods of sliders and slotted levers, in the order in which they follow from each other.

use std::f64::consts::{PI, TAU};

use dalembert_core::{Reference, Text, Worksheet};
use dalembert_mechanics::{Real, Vector, planar::BodyFrame};
use nalgebra::Vector2;

use super::{Mechanism, MechanismGiven, Solved};
use crate::{
    shared::{
        parts::{Carrier, Connection, Drive, Driven, DrivenGiven, Joint, JointGiven, PartReference},
        works::{across, direction},
    },
    sources::{NORTON, SHIGLEY},
};

/// Below this sine a triangle of a loop is too flat for its angles by the law of cosines.
const FLAT: f64 = 1e-3;

/// A pin of a body: the joint, and its point on the body and on the other.
#[derive(Clone, Copy)]
struct Pinned {
    joint: usize,
    own: Reference,
    other: Reference,
}

/// A place with its velocity; none where it is fixed.
pub(super) type Moving<W> = (<W as Worksheet>::Vec, Option<<W as Worksheet>::Vec>);

/// A body whose angle is known, with a pin of it that has a place.
struct Settled<W: Worksheet> {
    angle: W::Num,
    speed: Option<W::Num>,
    pin: Reference,
    at: Moving<W>,
}

/// Closed forms of a mechanism, body by body.
pub(super) struct Loops<'a, 'g, W: Worksheet> {
    of: &'a Solved<'a>,
    problem: &'a Mechanism,
    given: &'g MechanismGiven<W>,
    sheet: W,
    runs: bool,
    links: usize,
    settled: Vec<Option<Settled<W>>>,
    /// The place of each pin that has one, by its joint.
    pins: Vec<Option<Moving<W>>>,
}

impl<'a, 'g, W: Worksheet> Loops<'a, 'g, W> {
    /// Works through the bodies that have a closed form.
    pub(super) fn worked(
        of: &'a Solved<'a>,
        problem: &'a Mechanism,
        given: &'g MechanismGiven<W>,
        sheet: W,
    ) -> Self {
        let runs = of.system.mechanism().drivers.iter().any(|driver| driver.velocity != 0.0);
        let bodies = of.parts.bodies.len();
        let mut this = Self {
            of,
            problem,
            given,
            sheet,
            runs,
            links: 0,
            settled: (0..bodies).map(|_| None).collect(),
            pins: vec![None; of.parts.joints.len()],
        };
        while this.crank() || this.pair() || this.rod() || this.lever() {}
        this
    }

    /// The angle and, in motion, the angular velocity of a body; none without a closed form.
    pub(super) fn body(&self, body: usize) -> Option<(W::Num, Option<W::Num>)> {
        self.settled[body].as_ref().map(|body| (body.angle, body.speed))
    }

    /// Returns true if every body has a closed form.
    pub(super) fn is_complete(&self) -> bool {
        self.settled.iter().all(Option::is_some)
    }

    fn is_settled(&self, part: BodyFrame) -> bool {
        part.is_none_or(|body| self.settled[body].is_some())
    }

    fn on(&self, point: Reference) -> BodyFrame {
        self.of.parts.points[point.0].on
    }

    /// Position of a point, as the constraint equations have it.
    fn drawn(&self, point: Reference) -> Vector2<f64> {
        let [at, ..] = self.of.system.point(self.of.parts.point(point), self.of.state);
        at.into()
    }

    /// The pins of a body.
    fn pins_of(&self, body: usize) -> Vec<Pinned> {
        let own = |(joint, connection): (usize, &Connection)| {
            let Joint::Pin { a, b } = connection.joint else { return None };
            match [self.on(a), self.on(b)].map(|on| on == Some(body)) {
                [true, false] => Some(Pinned { joint, own: a, other: b }),
                [false, true] => Some(Pinned { joint, own: b, other: a }),
                _ => None,
            }
        };
        self.of.parts.joints.iter().enumerate().filter_map(own).collect()
    }

    /// A pin of a body to what is settled.
    fn anchor(&self, body: usize) -> Option<Pinned> {
        self.pins_of(body).into_iter().find(|pin| self.is_settled(self.on(pin.other)))
    }

    fn unsettled(&self) -> Vec<usize> {
        (0..self.settled.len()).filter(|body| self.settled[*body].is_none()).collect()
    }

    fn named(&self, reason: &'static str, body: usize) -> Text {
        Text::new(reason).with("name", &self.of.parts.bodies[body].name)
    }

    /// A point that was typed in the axes of its body, or of the ground.
    fn typed(&self, point: Reference) -> Option<W::Vec> {
        let given = self.given.points.get(point.0)?;
        (!matches!(self.problem.points[point.0].on, Carrier::Pins)).then_some(given.at)
    }

    /// The link from one point of a body to another: its length, and its angle in the axes of the body if not zero.
    fn link(&mut self, body: usize, from: Reference, to: Reference) -> (W::Num, Option<W::Num>) {
        self.links += 1;
        let n = self.links;
        let sheet = self.sheet;
        let [start, end] = [from, to].map(|point| self.of.parts.points[point.0].at);
        let plain = end - start;
        let of_length = self.named("Length of {name} between its pins", body);
        let of_angle = self.named("Angle of that line in the axes of {name}", body);
        let (Some(first), Some(second)) = (self.typed(from), self.typed(to)) else {
            let length = sheet.numerical(("l", n), "mm", plain.norm(), of_length);
            let angle = plain.y.atan2(plain.x);
            return (length, (angle != 0.0).then(|| sheet.numerical(("δ", n), "deg", angle, of_angle)));
        };
        let way = if start.norm() == 0.0 { second } else { second - first };
        let [x, y, _] = way.components();
        if plain.y == 0.0 && plain.x > 0.0 {
            return (sheet.step(("l", n), "mm", x, of_length), None);
        }
        let length = sheet.step(("l", n), "mm", way.magnitude(), of_length);
        (length, Some(sheet.step(("δ", n), "deg", y.atan2(x), of_angle)))
    }

    /// A point of the ground.
    fn ground(&self, point: Reference) -> W::Vec {
        let at = self.of.parts.points[point.0].at;
        let why = || Text::new("Position of {name}").with("name", &self.of.parts.points[point.0].name);
        self.typed(point).unwrap_or_else(|| self.sheet.numerical_vector(("g", point.0 + 1), "mm", at, why()))
    }

    /// The place and velocity of a pin between a settled part and another.
    fn place(&mut self, pin: Pinned) -> Moving<W> {
        if let Some(known) = self.pins[pin.joint] {
            return known;
        }
        let place = self.point(pin.other, pin.joint);
        self.pins[pin.joint] = Some(place);
        place
    }

    /// The place and velocity of a point of a settled part at a joint.
    fn point(&mut self, point: Reference, joint: usize) -> Moving<W> {
        let Some(body) = self.on(point) else { return (self.ground(point), None) };
        let settled = self.settled[body].as_ref().expect("the body of a place is settled");
        if settled.pin == point {
            return settled.at;
        }
        let name = &self.of.parts.joints[joint].name;
        self.along(body, point, (["r_J", "v_J"], joint + 1), name)
    }

    /// The place and velocity of a point of a settled body, with their symbols.
    fn along(
        &mut self,
        body: usize,
        point: Reference,
        ([r, v], row): ([&'static str; 2], usize),
        name: &str,
    ) -> Moving<W> {
        let settled = self.settled[body].as_ref().expect("the body of a place is settled");
        let (angle, speed, base, (start, moves)) = (settled.angle, settled.speed, settled.pin, settled.at);
        let (length, offset) = self.link(body, base, point);
        let angle = offset.map_or(angle, |offset| angle + offset);
        let sheet = self.sheet;
        let arm = direction::<W>(angle) * length;
        let why = Text::new("Position of {name}").with("name", name);
        let at = sheet.step_vector((r, row), "mm", start + arm, why);
        let velocity = speed.map(|speed| {
            let turned = across::<W>(arm) * speed;
            let velocity = moves.map_or(turned, |moves| moves + turned);
            let why = Text::new("Velocity of {name}: ω × r along its body").with("name", name);
            sheet.step_vector((v, row), "m/s", velocity, (why, SHIGLEY.at("ch. 3")))
        });
        (at, velocity)
    }

    /// Position and, in motion, velocity of a point that is asked for, if its body has a closed form.
    pub(super) fn watched(&mut self, point: Reference, row: usize) -> Option<Moving<W>> {
        let body = self.on(point)?;
        let settled = self.settled[body].as_ref()?;
        let name = self.of.parts.points[point.0].name.clone();
        if settled.pin != point {
            return Some(self.along(body, point, (["r_P", "v_P"], row), &name));
        }
        let (at, velocity) = settled.at;
        let named = |reason: &'static str| Text::new(reason).with("name", &name);
        let at = self.sheet.step_vector(("r_P", row), "mm", at, named("Position of {name}"));
        let velocity =
            velocity.map(|v| self.sheet.step_vector(("v_P", row), "m/s", v, named("Velocity of {name}")));
        Some((at, velocity))
    }

    /// Settles a body at an angle of one of its lines, which is at `offset` in its axes, with whole turns as the drawn
    /// position has them; returns the angle of the line.
    fn settle(
        &mut self,
        body: usize,
        (line, offset): (W::Num, Option<W::Num>),
        (pin, at): (Reference, Moving<W>),
        why: &'static str,
    ) -> W::Num {
        let angle = offset.map_or(line, |offset| line - offset);
        let turns = ((self.of.state.positions[body][2] - angle.value()) / TAU).round();
        let sheet = self.sheet;
        let angle = if turns == 0.0 {
            angle
        } else {
            let words = self.named("Whole turns of {name} from its initial angle", body);
            angle + sheet.numerical(("Δθ", body + 1), "deg", turns * TAU, words)
        };
        let why = (self.named(why, body), NORTON.at("ch. 4"));
        let angle = sheet.step(("θ_c", body + 1), "deg", angle, why);
        self.settled[body] = Some(Settled { angle, speed: None, pin, at });
        offset.map_or(angle, |offset| angle + offset)
    }

    /// Writes the angular velocity of a body that is settled.
    fn turn(&mut self, body: usize, value: W::Num, why: &'static str) -> W::Num {
        let why = (self.named(why, body), SHIGLEY.at("ch. 3"));
        let speed = self.sheet.step(("ω_c", body + 1), "rad/s", value, why);
        if let Some(settled) = &mut self.settled[body] {
            settled.speed = Some(speed);
        }
        speed
    }

    /// A body that a driver turns against what is settled.
    fn crank(&mut self) -> bool {
        let driven = |(n, drive): (usize, &Drive)| match &drive.what {
            Driven::Angle { body, against: PartReference::Ground, .. } => Some((n, body.0)),
            _ => None,
        };
        let drivers: Vec<(usize, usize)> =
            self.of.parts.drivers.iter().enumerate().filter_map(driven).collect();
        for (n, body) in drivers {
            if self.settled[body].is_some() {
                continue;
            }
            let (Some(pin), DrivenGiven::Angle { value, velocity, .. }) =
                (self.anchor(body), &self.given.drivers[n].what)
            else {
                continue;
            };
            let at = self.place(pin);
            self.settle(body, (*value, None), (pin.own, at), "Angle of {name}, that of its driver");
            if self.runs {
                self.turn(body, *velocity, "Angular velocity of {name}, that of its driver");
            }
            return true;
        }
        false
    }

    /// Two bodies that are pinned to what is settled and to each other: the triangle of their lengths.
    fn pair(&mut self) -> bool {
        for one in self.unsettled() {
            let Some(first) = self.anchor(one) else { continue };
            for knee in self.pins_of(one) {
                let Some(two) = self.on(knee.other) else { continue };
                if self.settled[two].is_some() || knee.joint == first.joint {
                    continue;
                }
                if let Some(second) = self.anchor(two)
                    && second.joint != first.joint
                    && self.close([one, two], [first, second], knee)
                {
                    return true;
                }
            }
        }
        false
    }

    fn close(&mut self, [one, two]: [usize; 2], [first, second]: [Pinned; 2], knee: Pinned) -> bool {
        let (p, q, b) = (self.drawn(first.own), self.drawn(second.own), self.drawn(knee.own));
        let (span, near, far) = (q - p, b - p, b - q);
        let side = span.perp(&near);
        let sines = [side / (span.norm() * near.norm()), near.perp(&far) / (near.norm() * far.norm())];
        if sines.iter().any(|sine| !sine.is_finite() || sine.abs() < FLAT) {
            return false;
        }
        let (start, end) = (self.place(first), self.place(second));
        let (near, turned) = self.link(one, first.own, knee.own);
        let (far, tilted) = self.link(two, second.own, knee.other);
        let (sheet, n) = (self.sheet, knee.joint + 1);
        let [from, to] = [first, second].map(|pin| self.of.parts.joints[pin.joint].name.as_str());
        let why = Text::new("From {from} to {to}").with("from", from).with("to", to);
        let span = sheet.step_vector(("d", n), "mm", end.0 - start.0, why);
        let [x, y, _] = span.components();
        let line = sheet.step(("γ", n), "deg", y.atan2(x), "Angle of that line");
        let distance = span.magnitude();
        let cosine = (near.powi(2) + distance.powi(2) - far.powi(2)) / (near * distance * 2.0);
        let why = self.named("Law of cosines: angle between that line and {name}", one);
        let angle = sheet.step(("ψ", n), "deg", cosine.acos(), (why, NORTON.at("ch. 4")));
        let angle = if side > 0.0 { line + angle } else { line - angle };
        let words = "Angle of {name}: loop of pins closed by the triangle of its lengths";
        let line = self.settle(one, (angle, turned), (first.own, start), words);
        let why = self.named("Vector of {name} from its first pin", one);
        let reach = sheet.step_vector(("ρ", n), "mm", direction::<W>(line) * near, why);
        let why = self.named("Vector of {name}, which closes the loop", two);
        let other = sheet.step_vector(("σ", n), "mm", reach - span, why);
        let [x, y, _] = other.components();
        self.settle(two, (y.atan2(x), tilted), (second.own, end), words);
        if let Some([a, b]) = self.common_velocity([start.1, end.1], [reach, other])
            && let Some(apart) = difference::<W>([start.1, end.1])
        {
            for (body, reach) in [(one, reach), (two, other)] {
                sheet.common_error(
                    ("ω_c", body + 1),
                    "the whole velocity of the driving pin divided by the length of the link",
                    || apart.magnitude() / reach.magnitude(),
                );
            }
            let words = "Angular velocity of {name}: both bodies give their pin the same velocity";
            self.turn(one, a, words);
            self.turn(two, b, words);
        }
        true
    }

    /// The angular velocities of two bars to a common pin, from the velocities of their other ends.
    fn common_velocity(&self, ends: [Option<W::Vec>; 2], [one, two]: [W::Vec; 2]) -> Option<[W::Num; 2]> {
        let apart = difference::<W>(ends)?;
        let first = -(apart.dot(two)) / across::<W>(one).dot(two);
        let second = apart.dot(one) / across::<W>(two).dot(one);
        Some([first, second])
    }

    /// A body from a settled pin to a slider on a line of the ground.
    fn rod(&mut self) -> bool {
        for rod in self.unsettled() {
            let Some(start) = self.anchor(rod) else { continue };
            for end in self.pins_of(rod) {
                let Some(slider) = self.on(end.other) else { continue };
                if end.joint == start.joint || self.settled[slider].is_some() {
                    continue;
                }
                if self.guided(rod, slider, [start, end]) {
                    return true;
                }
            }
        }
        false
    }

    fn guided(&mut self, rod: usize, slider: usize, [start, end]: [Pinned; 2]) -> bool {
        let joints = &self.of.parts.joints;
        let Some((row, guide)) =
            joints.iter().enumerate().find_map(|(row, connection)| match connection.joint {
                // The pin of the rod is the point that slides.
                Joint::Slider { guide, slides, .. }
                    if self.on(guide).is_none()
                        && self.on(slides) == Some(slider)
                        && self.of.parts.points[slides.0].at == self.of.parts.points[end.other.0].at =>
                {
                    Some((row, guide))
                }
                _ => None,
            })
        else {
            return false;
        };
        let JointGiven::Slider { direction: along, angle: kept, .. } = self.given.joints[row].joint else {
            return false;
        };
        let way = self.drawn(end.own) - self.drawn(start.own);
        let ahead = Vector2::new(along.value().cos(), along.value().sin()).dot(&way) / way.norm();
        if !ahead.is_finite() || ahead.abs() < FLAT {
            return false;
        }
        let at = self.place(start);
        let (length, turned) = self.link(rod, start.own, end.own);
        let (sheet, n) = (self.sheet, end.joint + 1);
        let left = across::<W>(direction::<W>(along));
        let why = Text::new("Distance of the line of {name} to the left of the pin")
            .with("name", &joints[row].name);
        let height = sheet.step(("h", n), "mm", (self.ground(guide) - at.0).dot(left), why);
        let leans = (height / length).asin();
        let leans = if ahead > 0.0 { along + leans } else { along + (W::Num::from(PI) - leans) };
        let words = "Angle of {name}: its end is on the line of the slider";
        let line = self.settle(rod, (leans, turned), (start.own, at), words);
        let why = self.named("Vector of {name} from its first pin", rod);
        let reach = sheet.step_vector(("ρ", n), "mm", direction::<W>(line) * length, why);
        let name = joints[end.joint].name.as_str();
        let why = Text::new("Position of {name}").with("name", name);
        let end_at = sheet.step_vector(("r_J", n), "mm", at.0 + reach, why);
        let velocity = at.1.map(|velocity| {
            let value = -(velocity.dot(left)) / across::<W>(reach).dot(left);
            let words = "Angular velocity of {name}: its end has no velocity across the line of the slider";
            sheet.common_error(
                ("ω_c", rod + 1),
                "the whole velocity of the driving pin divided by the length of the link",
                || velocity.magnitude() / length,
            );
            let speed = self.turn(rod, value, words);
            let why = Text::new("Velocity of {name}: ω × r along its body").with("name", name);
            let value = velocity + across::<W>(reach) * speed;
            sheet.step_vector(("v_J", n), "m/s", value, (why, SHIGLEY.at("ch. 3")))
        });
        self.pins[end.joint] = Some((end_at, velocity));
        let words = "Angle of {name}, that of its guide";
        self.settle(slider, (along + kept, None), (end.other, (end_at, velocity)), words);
        if self.runs {
            let why = self.named("Angular velocity of {name}: it translates along its guide", slider);
            let speed = sheet.numerical(("ω_c", slider + 1), "rad/s", 0.0, why);
            if let Some(settled) = &mut self.settled[slider] {
                settled.speed = Some(speed);
            }
        }
        true
    }

    /// A lever whose slot goes through its own settled pin, with a settled pin in it.
    fn lever(&mut self) -> bool {
        for lever in self.unsettled() {
            let Some(pivot) = self.anchor(lever) else { continue };
            let slots: Vec<(usize, Reference, Reference, f64)> = self
                .of
                .parts
                .joints
                .iter()
                .enumerate()
                .filter_map(|(row, connection)| match connection.joint {
                    Joint::Slot { guide, direction, pin, offset }
                        if offset == 0.0
                            && self.on(guide) == Some(lever)
                            && self.is_settled(self.on(pin)) =>
                    {
                        Some((row, guide, pin, direction))
                    }
                    _ => None,
                })
                .collect();
            for (row, guide, pin, slope) in slots {
                let points = &self.of.parts.points;
                let across_line = points[guide.0].at - points[pivot.own.0].at;
                let off = across_line.y * slope.cos() - across_line.x * slope.sin();
                if off.abs() > 1e-12 * self.of.system.size() {
                    continue;
                }
                self.slotted(lever, pivot, (row, pin));
                return true;
            }
        }
        false
    }

    fn slotted(&mut self, lever: usize, pivot: Pinned, (row, pin): (usize, Reference)) {
        let start = self.place(pivot);
        let end = self.point(pin, row);
        let sheet = self.sheet;
        let n = row + 1;
        let name = self.of.parts.joints[row].name.as_str();
        let why = Text::new("From the pivot to the pin in {name}").with("name", name);
        let span = sheet.step_vector(("d", n), "mm", end.0 - start.0, why);
        let [x, y, _] = span.components();
        let JointGiven::Slot { direction: slope, .. } = self.given.joints[row].joint else {
            unreachable!("the given numbers are those of this problem")
        };
        let line = self.of.state.positions[lever][2] + slope.value();
        let behind = span.value().x * line.cos() + span.value().y * line.sin() < 0.0;
        let angle = y.atan2(x) - slope;
        let angle = if behind { angle + PI } else { angle };
        let words = "Angle of {name}: its slot goes through the pin";
        self.settle(lever, (angle, None), (pivot.own, start), words);
        if let Some(apart) = difference::<W>([end.1, start.1]) {
            let value = apart.dot(across::<W>(span)) / span.dot(span);
            self.turn(lever, value, "Angular velocity of {name}: velocity of the pin across the slot");
        }
    }
}

/// The velocity of one place relative to another; none where both are fixed.
fn difference<W: Worksheet>(ends: [Option<W::Vec>; 2]) -> Option<W::Vec> {
    match ends {
        [Some(p), Some(q)] => Some(p - q),
        [Some(p), None] => Some(p),
        [None, Some(q)] => Some(-q),
        [None, None] => None,
    }
}
