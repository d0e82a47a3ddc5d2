//! Bodies given by their pins, and names for what has none.

use dalembert_core::{Reference, Refusal, Text};
use dalembert_mechanics::planar::BodyFrame;
use nalgebra::Vector3;

use super::{
    Carrier, Connection, Drive, Driven, Follower, Joint, NamedLoad, Part, PartLoad, PartReference, Spot,
};

/// A point of a body or of the ground.
#[derive(Clone, Debug)]
pub(crate) struct Point {
    pub(crate) name: String,
    pub(crate) on: BodyFrame,
    /// Position in the axes of its body.
    pub(crate) at: Vector3<f64>,
}

/// The bodies, points and joints of a mechanism, with the pins of its bodies written out: rows of the form first.
pub(super) struct WrittenOut {
    pub(super) bodies: Vec<Part>,
    pub(super) points: Vec<Point>,
    pub(super) joints: Vec<Connection>,
}

impl WrittenOut {
    /// Gives each body its pins as points in its own axes, and joins those of different bodies at each point.
    pub(super) fn new(bodies: &[Part], spots: &[Spot], joints: &[Connection]) -> Result<Self, Refusal> {
        let mut bodies = bodies.to_vec();
        for body in &mut bodies {
            if body.name.is_empty() {
                body.name = joined(body.pins.iter().map(|pin| spots[pin.0].name.as_str()));
            }
        }
        let local = bodies.iter().map(|body| body.local_pins(spots)).collect::<Result<Vec<_>, _>>()?;
        let mut points: Vec<Point> = Vec::with_capacity(spots.len());
        for (row, spot) in spots.iter().enumerate() {
            let (on, at) = match &spot.on {
                Carrier::Ground => (None, spot.at),
                Carrier::Body { body } => (Some(body.0), spot.at),
                Carrier::Pins => {
                    let place = |body: usize| Some((body, bodies[body].place_of(row)?));
                    let (body, pin) = (0..bodies.len()).find_map(place).ok_or_else(|| {
                        Refusal::because(
                            Text::new("the point {name} is carried by nothing: put it on the ground or on a body, or list it among the pins of a body")
                                .with("name", &spot.name),
                        )
                    })?;
                    (Some(body), local[body][pin])
                }
            };
            points.push(Point { name: spot.name.clone(), on, at });
        }
        let mut joints = joints.to_vec();
        for joint in &mut joints {
            if joint.name.is_empty() {
                joint.name = joined(joint.joint.points().iter().map(|end| spots[end.0].name.as_str()));
            }
        }
        for (row, spot) in spots.iter().enumerate() {
            let owner = points[row].on;
            let listing = |body: &usize| Some(*body) != owner && bodies[*body].place_of(row).is_some();
            let others: Vec<usize> = (0..bodies.len()).filter(listing).collect();
            for &body in &others {
                let place = bodies[body].place_of(row).unwrap_or_default();
                let name = match others.len() {
                    1 => spot.name.clone(),
                    _ => format!("{} ({})", spot.name, bodies[body].name),
                };
                let (a, b) = (Reference(row), Reference(points.len()));
                points.push(Point { name: spot.name.clone(), on: Some(body), at: local[body][place] });
                joints.push(Connection { name, joint: Joint::Pin { a, b } });
            }
        }
        let ground_of = |spot: &Spot| (!matches!(spot.on, Carrier::Body { .. })).then_some(spot.at);
        for body in &mut bodies {
            let ends: Vec<_> = body.pins.iter().map(|pin| ground_of(&spots[pin.0])).collect();
            if let Some(Some(first)) = ends.first() {
                body.place.get_or_insert(*first);
                if let Some(Some(second)) = ends.get(1) {
                    body.angle = (second.y - first.y).atan2(second.x - first.x);
                }
            }
        }
        Ok(Self { bodies, points, joints })
    }
}

impl Part {
    /// Place of a point among its pins.
    fn place_of(&self, point: usize) -> Option<usize> {
        self.pins.iter().position(|pin| pin.0 == point)
    }

    /// The pins in the axes of the body: the first at the origin, the second on x.
    fn local_pins(&self, spots: &[Spot]) -> Result<Vec<Vector3<f64>>, Refusal> {
        let refuse = |why: &'static str| Err(Refusal::because(Text::new(why).with("name", &self.name)));
        let pins: Vec<&Spot> = self.pins.iter().map(|pin| &spots[pin.0]).collect();
        for (place, pin) in self.pins.iter().enumerate() {
            if self.pins[..place].contains(pin) {
                return refuse("{name} lists a pin twice: each of its pins is another point");
            }
        }
        let in_ground_axes = |spot: &&Spot| !matches!(spot.on, Carrier::Body { .. });
        let positions = || pins.iter().map(|spot| spot.at).collect();
        let sketch: Option<Vec<Vector3<f64>>> = pins.iter().all(in_ground_axes).then(positions);
        let along = |x: f64| Vector3::new(x, 0.0, 0.0);
        match (pins.len(), &self.sides[..]) {
            (0 | 1, []) => Ok(vec![Vector3::zeros(); pins.len()]),
            (2, &[side]) => Ok(vec![Vector3::zeros(), along(side)]),
            (3, &[ab, bc, ca]) => {
                let x = (ab * ab + ca * ca - bc * bc) / (2.0 * ab);
                let square = ca * ca - x * x;
                if square < 0.0 {
                    return refuse(
                        "the three sides of {name} close no triangle: the longest exceeds the sum of the two others",
                    );
                }
                let side = sketch.as_deref().map_or(1.0, handedness);
                Ok(vec![Vector3::zeros(), along(ab), Vector3::new(x, side * square.sqrt(), 0.0)])
            }
            (_, []) => match sketch {
                Some(points) => from_sketch(&points).map_or_else(
                    || refuse("the first two pins of {name} are in one place: give their distance"),
                    Ok,
                ),
                None => refuse(
                    "the distances between the pins of {name} are missing: give them, or the positions of all its pins",
                ),
            },
            _ => refuse(
                "the number of distances of {name} does not fit its pins: one for two pins, three for three pins, none to take them from the positions",
            ),
        }
    }
}

impl Joint {
    /// Points of the form that it joins, in their order.
    fn points(&self) -> Vec<Reference> {
        match self {
            Joint::Pin { a, b }
            | Joint::Weld { a, b, .. }
            | Joint::Slider { guide: a, slides: b, .. }
            | Joint::Slot { guide: a, pin: b, .. }
            | Joint::Rod { from: a, to: b, .. }
            | Joint::Rolling { guide: a, centre: b, .. }
            | Joint::Cam { guide: a, follower: b, .. }
            | Joint::Contour { centre: a, follower: Follower::Roller { centre: b, .. }, .. }
            | Joint::Contour { centre: a, follower: Follower::FlatFace { point: b, .. }, .. } => {
                vec![*a, *b]
            }
            Joint::Cord { runs, .. } => runs.iter().flat_map(|run| [run.from, run.to]).collect(),
            Joint::Gears { .. } | Joint::Geneva { .. } => Vec::new(),
        }
    }
}

/// Names drivers after what they drive, where they have none.
pub(super) fn named_drivers(drivers: &[Drive], bodies: &[Part], points: &[Point]) -> Vec<Drive> {
    let name = |drive: &Drive| match &drive.what {
        Driven::Angle { body, .. } => bodies[body.0].name.clone(),
        Driven::Position { from, to, .. } | Driven::Distance { from, to, .. } => between(points, *from, *to),
    };
    let named = |drive: &Drive| {
        let own = if drive.name.is_empty() { name(drive) } else { drive.name.clone() };
        Drive { name: own, what: drive.what.clone() }
    };
    drivers.iter().map(named).collect()
}

/// Names loads after what they act on, where they have none.
pub(super) fn named_loads(
    loads: &[NamedLoad],
    (bodies, points, joints): (&[Part], &[Point], &[Connection]),
) -> Vec<NamedLoad> {
    let name = |load: &PartLoad| match load {
        PartLoad::Force { at, .. } => points[at.0].name.clone(),
        PartLoad::Couple { on: of, .. } | PartLoad::TorsionSpring { of, .. } => match of {
            PartReference::Ground => String::new(),
            PartReference::Body { body } => bodies[body.0].name.clone(),
        },
        PartLoad::Thrust { from, to, .. }
        | PartLoad::Spring { from, to, .. }
        | PartLoad::Damper { from, to, .. }
        | PartLoad::Gas { from, to, .. } => between(points, *from, *to),
        PartLoad::Friction { joint, .. } => joints[joint.0].name.clone(),
    };
    let named = |load: &NamedLoad| {
        let own = if load.name.is_empty() { name(&load.load) } else { load.name.clone() };
        NamedLoad { name: own, load: load.load.clone() }
    };
    loads.iter().map(named).collect()
}

fn between(points: &[Point], from: Reference, to: Reference) -> String {
    joined([from, to].iter().map(|end| points[end.0].name.as_str()))
}

/// `A–B–C`
fn joined<'n>(names: impl Iterator<Item = &'n str>) -> String {
    names.collect::<Vec<_>>().join("–")
}

/// 1 where three points follow each other counter-clockwise, −1 where clockwise.
fn handedness(points: &[Vector3<f64>]) -> f64 {
    let [a, b, c] = [points[0], points[1], points[2]];
    if (b - a).cross(&(c - a)).z < 0.0 { -1.0 } else { 1.0 }
}

/// Points in axes with the first at the origin and the second on x; none where these coincide.
fn from_sketch(points: &[Vector3<f64>]) -> Option<Vec<Vector3<f64>>> {
    let first = points[0];
    let way = points[1] - first;
    let length = way.norm();
    let [c, s] = if length > 0.0 { [way.x / length, way.y / length] } else { return None };
    let turned = |point: &Vector3<f64>| {
        let from = point - first;
        Vector3::new(c * from.x + s * from.y, c * from.y - s * from.x, 0.0)
    };
    Some(points.iter().map(turned).collect())
}
