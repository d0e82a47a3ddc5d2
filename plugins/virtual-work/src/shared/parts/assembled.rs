//! The mechanism that its parts make.

use std::{f64::consts::TAU, ops::Range};

use dalembert_core::{Reference, Refusal, Text, Worksheet};
use dalembert_mechanics::planar::{
    self, GenevaWheel, InitialGuess, Model, PlanarError, Profile, RelativeCoordinate,
};
use nalgebra::Vector3;

use super::{
    Connection, ContourPoint, Drive, Driven, Follower, Joint, NamedLoad, Part, PartLoad, Point, Spot,
    pinned::{WrittenOut, named_drivers, named_loads},
};

/// The parts of a mechanism together, with the pins of its bodies written out and a name for each part.
pub(crate) struct Parts {
    pub(crate) gravity: Vector3<f64>,
    pub(crate) bodies: Vec<Part>,
    /// Those of the form, in its order, then the pins of bodies.
    pub(crate) points: Vec<Point>,
    /// Those of the form, in its order, then the pins of bodies.
    pub(crate) joints: Vec<Connection>,
    pub(crate) drivers: Vec<Drive>,
    pub(crate) loads: Vec<NamedLoad>,
}

impl Parts {
    /// The parts that the rows of a form describe.
    pub(crate) fn new(
        gravity: Vector3<f64>,
        (bodies, spots, joints): (&[Part], &[Spot], &[Connection]),
        drivers: &[Drive],
        loads: &[NamedLoad],
    ) -> Result<Self, Refusal> {
        let WrittenOut { bodies, points, joints } = WrittenOut::new(bodies, spots, joints)?;
        let drivers = named_drivers(drivers, &bodies, &points);
        let loads = named_loads(loads, (&bodies, &points, &joints));
        Ok(Self { gravity, bodies, points, joints, drivers, loads })
    }

    /// A point, from the centre of mass of its body.
    pub(crate) fn point(&self, reference: Reference) -> planar::BodyPoint {
        let spot = &self.points[reference.0];
        let on = spot.on;
        let origin = on.map_or(Vector3::zeros(), |body| self.bodies[body].centre);
        planar::BodyPoint { on, at: [spot.at.x - origin.x, spot.at.y - origin.y] }
    }

    pub(crate) fn along(&self, from: Reference, to: Reference, direction: f64) -> RelativeCoordinate {
        let direction = [direction.cos(), direction.sin()];
        RelativeCoordinate::Along { direction, from: self.point(from), to: self.point(to) }
    }

    pub(crate) fn distance(&self, from: Reference, to: Reference) -> RelativeCoordinate {
        RelativeCoordinate::Distance { from: self.point(from), to: self.point(to) }
    }

    /// The mechanism, and the rows of its joints: a joint of the form may stand for two of the mechanism.
    pub(crate) fn mechanism(&self) -> Result<(planar::PlanarMechanism, Vec<usize>), Refusal> {
        let bodies = self
            .bodies
            .iter()
            .map(|body| planar::PlanarBody { mass: body.mass, inertia: body.inertia })
            .collect();
        let (mut joints, mut rows) = (Vec::new(), Vec::new());
        for (row, connection) in self.joints.iter().enumerate() {
            for joint in self.joint(connection)? {
                joints.push(joint);
                rows.push(row);
            }
        }
        let drivers = self.drivers.iter().map(|drive| self.driver(&drive.what)).collect();
        let loads = self.loads.iter().map(|load| self.load(&load.load, &rows)).collect();
        let gravity = [self.gravity.x, self.gravity.y];
        Ok((planar::PlanarMechanism { bodies, joints, drivers, loads, gravity }, rows))
    }

    fn joint(&self, connection: &Connection) -> Result<Vec<planar::PlanarJoint>, Refusal> {
        let point = |reference: &Reference| self.point(*reference);
        Ok(match &connection.joint {
            Joint::Pin { a, b } => vec![planar::PlanarJoint::Pin { a: point(a), b: point(b) }],
            Joint::Slider { guide, direction, slides, angle } => vec![planar::PlanarJoint::Slider {
                guide: point(guide),
                direction: *direction,
                slides: point(slides),
                angle: *angle,
            }],
            Joint::Slot { guide, direction, pin, offset } => vec![planar::PlanarJoint::Slot {
                guide: point(guide),
                direction: *direction,
                pin: point(pin),
                offset: *offset,
            }],
            Joint::Weld { a, b, angle } => {
                vec![planar::PlanarJoint::Weld { a: point(a), b: point(b), angle: *angle }]
            }
            Joint::Rod { from, to, length } => {
                vec![planar::PlanarJoint::Rod { from: point(from), to: point(to), length: *length }]
            }
            Joint::Gears { a, b, carrier, size_a, size_b, internal } => vec![planar::PlanarJoint::Gears {
                a: a.frame(),
                b: b.frame(),
                carrier: carrier.frame(),
                sizes: [*size_a, *size_b],
                internal: *internal,
            }],
            Joint::Rolling { guide, direction, centre, radius, resting } => {
                let (guide, centre) = (point(guide), point(centre));
                let rolling =
                    planar::PlanarJoint::Rack { guide, direction: *direction, centre, radius: *radius };
                let held =
                    planar::PlanarJoint::Slot { guide, direction: *direction, pin: centre, offset: *radius };
                if *resting { vec![held, rolling] } else { vec![rolling] }
            }
            Joint::Cord { runs, drums } => vec![planar::PlanarJoint::Cord {
                runs: runs.iter().map(|run| [point(&run.from), point(&run.to)]).collect(),
                drums: drums
                    .iter()
                    .map(|drum| (drum.of.frame(), drum.against.frame(), drum.radius))
                    .collect(),
            }],
            Joint::Cam { cam, guide, direction, follower, lift } => {
                let points: Vec<[f64; 2]> = lift.iter().map(|point| [point.angle, point.lift]).collect();
                let profile = Profile::through(&points, Some(TAU)).ok_or_else(|| {
                    Refusal::because(
                        Text::new("the lift of the cam {name} needs at least three points with increasing angles within one revolution")
                            .with("name", &connection.name),
                    )
                })?;
                vec![planar::PlanarJoint::Cam {
                    follower: self.along(*guide, *follower, *direction),
                    cam: RelativeCoordinate::Angle { of: Some(cam.0), against: None },
                    profile,
                }]
            }
            Joint::Contour { centre, contour, follower } => {
                vec![self.contour(&connection.name, *centre, contour, follower)?]
            }
            Joint::Geneva { driver, wheel, carrier, slots, direction, pin } => {
                let geometry = geneva_wheel(*slots, *direction, *pin)
                    .ok_or_else(|| Refusal::because("a Geneva wheel has at least three slots"))?;
                vec![planar::PlanarJoint::Geneva {
                    driver: Some(driver.0),
                    wheel: Some(wheel.0),
                    carrier: carrier.frame(),
                    geometry,
                }]
            }
        })
    }

    /// A roller or a flat face on the contour of a cam: the pitch curve in polar coordinates of the cam, or the support
    /// function over the angle between face and cam.
    fn contour(
        &self,
        name: &str,
        centre: Reference,
        contour: &[ContourPoint],
        follower: &Follower,
    ) -> Result<planar::PlanarJoint, Refusal> {
        let refuse = |why: &'static str| Refusal::because(Text::new(why).with("name", name));
        let outline = outline(contour).ok_or_else(|| {
            refuse("the contour of the cam {name} needs at least three points with increasing angles within one revolution")
        })?;
        let cam = self.point(centre);
        let (follower, cam, profile) = match *follower {
            Follower::Roller { centre: roller, radius } => {
                let pitch = Profile::pitch_curve(&outline, radius).ok_or_else(|| {
                    refuse(
                        "the roller of {name} does not fit into the hollow of the contour: reduce its radius",
                    )
                })?;
                let (from, to) = (cam, self.point(roller));
                let distance = RelativeCoordinate::Distance { from, to };
                (distance, RelativeCoordinate::Bearing { from, to }, pitch)
            }
            Follower::FlatFace { point, normal } => {
                let support = Profile::support_function(&outline).ok_or_else(|| {
                    refuse("the contour of the cam {name} is hollow: a flat face does not touch it everywhere; use a roller")
                })?;
                let face = self.point(point);
                let direction = [-normal.cos(), -normal.sin()];
                let height = RelativeCoordinate::Along { direction, from: face, to: cam };
                let turned = RelativeCoordinate::Angle { of: face.on, against: cam.on };
                (height, turned, support.shifted(normal))
            }
        };
        Ok(planar::PlanarJoint::Cam { follower, cam, profile })
    }

    fn driver(&self, what: &Driven) -> planar::Driver {
        match *what {
            Driven::Angle { body, ref against, value, velocity, acceleration, .. } => {
                let measure = RelativeCoordinate::Angle { of: Some(body.0), against: against.frame() };
                planar::Driver { measure, value, velocity, acceleration }
            }
            Driven::Position { from, to, direction, value, velocity, acceleration, .. } => {
                let measure = self.along(from, to, direction);
                planar::Driver { measure, value, velocity, acceleration }
            }
            Driven::Distance { from, to, value, velocity, acceleration, .. } => {
                planar::Driver { measure: self.distance(from, to), value, velocity, acceleration }
            }
        }
    }

    /// Relative coordinate along which a load acts; none for a force at a point and for friction.
    pub(crate) fn measure(&self, load: &PartLoad) -> Option<RelativeCoordinate> {
        match load {
            PartLoad::Couple { on: of, against, .. } | PartLoad::TorsionSpring { of, against, .. } => {
                Some(RelativeCoordinate::Angle { of: of.frame(), against: against.frame() })
            }
            PartLoad::Thrust { from, to, .. }
            | PartLoad::Spring { from, to, .. }
            | PartLoad::Damper { from, to, .. }
            | PartLoad::Gas { from, to, .. } => Some(self.distance(*from, *to)),
            PartLoad::Force { .. } | PartLoad::Friction { .. } => None,
        }
    }

    fn load(&self, load: &PartLoad, rows: &[usize]) -> planar::PlanarLoad {
        use planar::Effort;
        let effort = match *load {
            PartLoad::Force { at, force, ref axes } => {
                let (at, force) = (self.point(at), [force.x, force.y]);
                return planar::PlanarLoad::Force { at, force, turns_with: axes.frame() };
            }
            PartLoad::Friction { joint, coefficient, radius } => {
                let joint = rows.iter().position(|row| *row == joint.0).unwrap_or(usize::MAX);
                return planar::PlanarLoad::Friction { joint, coefficient, radius };
            }
            PartLoad::Couple { moment: constant, .. } | PartLoad::Thrust { force: constant, .. } => {
                Effort::Constant(constant)
            }
            PartLoad::Spring { stiffness, free, .. } | PartLoad::TorsionSpring { stiffness, free, .. } => {
                Effort::Spring { stiffness, free }
            }
            PartLoad::Damper { coefficient, .. } => Effort::Damper { coefficient },
            PartLoad::Gas { area, pressure, column, exponent, ambient, .. } => {
                Effort::Gas { area, pressure, column, exponent, ambient }
            }
        };
        let measure = self.measure(load).expect("every load but a force and friction has a measure");
        planar::PlanarLoad::Effort { measure, effort }
    }

    /// The mechanism, assembled in the drawn position and taken from there to the values of its drivers by continuation.
    ///
    /// The drawn position fixes how gears mesh, how far wheels have rolled, how long cords are, and on which side a
    /// linkage is assembled.
    pub(crate) fn assembled<W: Worksheet>(
        &self,
        sheet: W,
    ) -> Result<(Model, Vec<usize>, Vec<[f64; 3]>), Refusal> {
        if self.bodies.is_empty() {
            return Err(Refusal::because("no body is given: write down at least one"));
        }
        let (mut mechanism, rows) = self.mechanism()?;
        let values: Vec<f64> = mechanism.drivers.iter().map(|driver| driver.value).collect();
        for (driver, drive) in mechanism.drivers.iter_mut().zip(&self.drivers) {
            driver.value = drive.what.drawn();
        }
        let mut angles: Vec<f64> = self.bodies.iter().map(|body| body.angle).collect();
        for driver in &mechanism.drivers {
            if let RelativeCoordinate::Angle { of: Some(body), against: None } = driver.measure {
                angles[body] = driver.value;
            }
        }
        let refuse = |error: PlanarError| self.refusal(&error, &rows);
        // The origin of a body is its centre of mass here, and of its own axes in the form.
        let origin = |(body, angle): (&Part, &f64)| {
            let [sin, cos] = [angle.sin(), angle.cos()];
            let centre = body.centre;
            let at = body.place?;
            Some([at.x + cos * centre.x - sin * centre.y, at.y + sin * centre.x + cos * centre.y])
        };
        let origins: Vec<Option<[f64; 2]>> = self.bodies.iter().zip(&angles).map(origin).collect();
        let InitialGuess { positions: guess, undetermined, assumed, ambiguous } =
            Model::initial_guess(&mechanism, &angles, &origins).map_err(refuse)?;
        let names = |bodies: &[usize]| -> String {
            bodies.iter().map(|body| self.bodies[*body].name.as_str()).collect::<Vec<_>>().join(", ")
        };
        if !undetermined.is_empty() {
            return Err(Refusal::because(
                Text::new("joints and drivers do not determine the position of {names}: give it")
                    .with("names", names(&undetermined)),
            ));
        }
        if !assumed.is_empty() {
            sheet.warn(|| {
                Text::new(
                    "joints and drivers do not determine the position: give the position of {names}; an arbitrary one is assumed",
                )
                .with("names", names(&assumed))
            });
        }
        if !ambiguous.is_empty() {
            sheet.warn(|| {
                Text::new(
                    "with these angles it can also be assembled on another side: give the position of {names}, or check in the drawing that this is the intended side",
                )
                .with("names", names(&ambiguous))
            });
        }
        let system = Model::new(&mechanism, &guess).map_err(refuse)?;
        let positions = system.assemble(&guess).map_err(refuse)?;
        if self.drivers.iter().all(|drive| drive.what.drawn() == drive.what.value()) {
            return Ok((system, rows, positions));
        }
        let (system, positions) = system.with_drivers_at(&positions, &values).map_err(refuse)?;
        Ok((system, rows, positions))
    }
}

/// The contour of a cam as a closed curve, radius over angle.
pub(super) fn outline(contour: &[ContourPoint]) -> Option<Profile> {
    let points: Vec<[f64; 2]> = contour.iter().map(|point| [point.angle, point.radius]).collect();
    Profile::through(&points, Some(TAU))
}

/// A Geneva wheel from the direction of the line of centres and the angle of the pin on its driver.
pub(super) fn geneva_wheel(slots: u32, direction: f64, pin: f64) -> Option<GenevaWheel> {
    GenevaWheel::new(slots, direction - pin)
}

/// The joints of the mechanism that the joint in a row of the form stands for, with the rows of all in ascending order.
pub(crate) fn owners(rows: &[usize], row: usize) -> Range<usize> {
    rows.partition_point(|of| *of < row)..rows.partition_point(|of| *of <= row)
}

/// Reaction of the joint in a row of the form on its second point: the force along x and y, or across a line or along a
/// rod; the couple. What is below that part of the largest effort, or of the largest weight, is rounding alone, and zero.
pub(crate) fn carried(
    system: &Model,
    rows: &[usize],
    row: usize,
    multipliers: &[f64],
    rounding: f64,
) -> [Option<f64>; 3] {
    let mut carried = [None; 3];
    let mechanism = system.mechanism();
    let gravity = mechanism.gravity[0].hypot(mechanism.gravity[1]);
    let weights = mechanism.bodies.iter().map(|body| body.mass * gravity);
    let largest = multipliers.iter().map(|x| x.abs()).chain(weights).fold(0.0, f64::max);
    for (joint, equation) in
        owners(rows, row).flat_map(|joint| system.equations_of(joint).map(move |equation| (joint, equation)))
    {
        let meets = matches!(
            mechanism.joints.get(joint),
            Some(planar::PlanarJoint::Pin { .. } | planar::PlanarJoint::Weld { .. })
        );
        let place = match system.equations()[equation].terms[0].measure {
            RelativeCoordinate::Angle { .. } => 2,
            _ => usize::from(meets && carried[0].is_some()),
        };
        let effort = multipliers[equation];
        carried[place].get_or_insert(if effort.abs() > rounding * largest { effort } else { 0.0 });
    }
    carried
}
