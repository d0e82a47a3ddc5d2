//! Relative coordinates of a mechanism: lengths and angles, their gradients and their quadratic velocity terms.
//!
//! A joint holds measures constant, a driver prescribes one, a spring stretches one, and an effort works along one. For
//! a measure `m(q)` of the positions q, the effort conjugate to it does the power `Q ṁ` (virtual power), and acts on
//! the bodies as `Q ∂m/∂q`; its acceleration is `m̈ = (∂m/∂q) q̈ + b` with `b` quadratic in the velocities.

use crate::Real;

/// A body, counted from 0, or the ground.
pub type BodyFrame = Option<usize>;

/// A point fixed to a body, in the axes of the body and from its origin, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BodyPoint {
    /// The body that carries it.
    pub on: BodyFrame,
    /// The position in the axes of the body.
    pub at: [f64; 2],
}

impl BodyPoint {
    /// A point of the ground.
    pub fn ground(at: [f64; 2]) -> Self {
        Self { on: None, at }
    }

    /// A point of a body.
    pub fn body(body: usize, at: [f64; 2]) -> Self {
        Self { on: Some(body), at }
    }
}

/// A length or an angle of a mechanism.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RelativeCoordinate {
    /// The angle of a body against another, `θ_of − θ_against`, rad. Turns are counted.
    Angle {
        /// The body that turns.
        of: BodyFrame,
        /// The body against which its angle is taken.
        against: BodyFrame,
    },
    /// The distance of a point from another in a fixed direction, `u · (B − A)`, m.
    Component {
        /// Unit vector u.
        direction: [f64; 2],
        /// A.
        from: BodyPoint,
        /// B.
        to: BodyPoint,
    },
    /// The distance of a point from another in a direction that turns with the body of the first, `u(θ_A) · (B − A)`,
    /// m.
    Along {
        /// Unit vector u in the axes of the body that carries A.
        direction: [f64; 2],
        /// A.
        from: BodyPoint,
        /// B.
        to: BodyPoint,
    },
    /// The distance of two points, `|B − A|`, m.
    Distance {
        /// A.
        from: BodyPoint,
        /// B.
        to: BodyPoint,
    },
    /// The polar angle of a point about another in the axes of the body that carries that one, rad; within one turn.
    Bearing {
        /// A.
        from: BodyPoint,
        /// B.
        to: BodyPoint,
    },
}

/// The pose of a body: its origin, and its angle with cosine and sine.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pose<S> {
    /// Origin, m.
    pub x: S,
    /// Origin, m.
    pub y: S,
    /// Angle, rad.
    pub angle: S,
    cos: S,
    sin: S,
}

/// The value of a measure and its derivatives with respect to the positions `x`, `y`, `θ` of two bodies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gradient<S> {
    /// The measure itself.
    pub value: S,
    /// For the body it is taken from.
    pub from: [S; 3],
    /// For the body it is taken to.
    pub to: [S; 3],
}

impl<S: Real> Pose<S> {
    /// A body with its origin and angle.
    #[inline(always)]
    pub fn new([x, y, angle]: [S; 3]) -> Self {
        Self { x, y, angle, cos: angle.cos(), sin: angle.sin() }
    }

    /// The same body with another angle, of which cosine and sine are known.
    #[inline(always)]
    pub(super) fn turn(&mut self, angle: S, [cos, sin]: [S; 2]) {
        (self.angle, self.cos, self.sin) = (angle, cos, sin);
    }

    /// The ground.
    #[inline(always)]
    pub fn ground() -> Self {
        let zero = S::from(0.0);
        Self { x: zero, y: zero, angle: zero, cos: S::from(1.0), sin: zero }
    }

    /// A vector of the body in the axes of the ground.
    #[inline(always)]
    pub fn turned(&self, [x, y]: [f64; 2]) -> [S; 2] {
        [self.cos * x - self.sin * y, self.sin * x + self.cos * y]
    }

    /// A point of the body.
    #[inline(always)]
    pub fn point(&self, at: [f64; 2]) -> [S; 2] {
        let [x, y] = self.turned(at);
        [self.x + x, self.y + y]
    }
}

impl RelativeCoordinate {
    /// The bodies between which it is taken: from, to.
    #[inline(always)]
    pub fn bodies(&self) -> [BodyFrame; 2] {
        match *self {
            RelativeCoordinate::Angle { of, against } => [against, of],
            RelativeCoordinate::Component { from, to, .. }
            | RelativeCoordinate::Along { from, to, .. }
            | RelativeCoordinate::Distance { from, to }
            | RelativeCoordinate::Bearing { from, to } => [from.on, to.on],
        }
    }

    /// True for an angle, in rad, rather than a length, in m.
    pub fn is_angle(&self) -> bool {
        matches!(self, RelativeCoordinate::Angle { .. } | RelativeCoordinate::Bearing { .. })
    }

    /// True if it changes with the place of its points, so that an effort along it is a force rather than a couple alone.
    pub fn has_line(&self) -> bool {
        !matches!(self, RelativeCoordinate::Angle { .. })
    }

    /// The value and its derivative, with the poses of the bodies it is taken from and to.
    ///
    /// The derivative of a distance is not finite where the points coincide.
    #[inline(always)]
    pub fn gradient<S: Real>(&self, [from_pose, to_pose]: [&Pose<S>; 2]) -> Gradient<S> {
        let zero = S::from(0.0);
        // A unit force along u at a point of a body, as the force and its moment about the body's origin.
        let along = |[ux, uy]: [S; 2], [rx, ry]: [S; 2]| [ux, uy, rx * uy - ry * ux];
        match *self {
            RelativeCoordinate::Angle { .. } => Gradient {
                value: to_pose.angle - from_pose.angle,
                from: [zero, zero, S::from(-1.0)],
                to: [zero, zero, S::from(1.0)],
            },
            RelativeCoordinate::Component { direction, from, to } => {
                let u = [S::from(direction[0]), S::from(direction[1])];
                let (a, b) = (from_pose.turned(from.at), to_pose.turned(to.at));
                let d = between(from_pose, a, to_pose, b);
                Gradient { value: dot(u, d), from: opposite(along(u, a)), to: along(u, b) }
            }
            RelativeCoordinate::Along { direction, from, to } => {
                let u = from_pose.turned(direction);
                let (a, b) = (from_pose.turned(from.at), to_pose.turned(to.at));
                let d = between(from_pose, a, to_pose, b);
                let [fx, fy, moment] = opposite(along(u, a));
                let turning = u[0] * d[1] - u[1] * d[0];
                Gradient { value: dot(u, d), from: [fx, fy, moment + turning], to: along(u, b) }
            }
            RelativeCoordinate::Distance { from, to } => {
                let (a, b) = (from_pose.turned(from.at), to_pose.turned(to.at));
                let d = between(from_pose, a, to_pose, b);
                let length = (d[0].powi(2) + d[1].powi(2)).sqrt();
                let u = [d[0] / length, d[1] / length];
                Gradient { value: length, from: opposite(along(u, a)), to: along(u, b) }
            }
            RelativeCoordinate::Bearing { from, to } => {
                let (a, b) = (from_pose.turned(from.at), to_pose.turned(to.at));
                let d = between(from_pose, a, to_pose, b);
                let square = d[0].powi(2) + d[1].powi(2);
                let across = [-d[1] / square, d[0] / square];
                let [fx, fy, moment] = opposite(along(across, a));
                Gradient {
                    value: d[1].atan2(d[0]) - from_pose.angle,
                    from: [fx, fy, moment - 1.0],
                    to: along(across, b),
                }
            }
        }
    }

    /// The acceleration when no body accelerates: the part of `m̈` that is quadratic in the velocities.
    #[inline(always)]
    pub fn bias<S: Real>(&self, poses: [&Pose<S>; 2], velocities: [[S; 3]; 2]) -> S {
        let [from_pose, to_pose] = poses;
        let [from_velocity, to_velocity] = velocities;
        let (wa, wb) = (from_velocity[2], to_velocity[2]);
        let points = |from: BodyPoint, to: BodyPoint| {
            let (a, b) = (from_pose.turned(from.at), to_pose.turned(to.at));
            let inward = [a[0] * wa.powi(2) - b[0] * wb.powi(2), a[1] * wa.powi(2) - b[1] * wb.powi(2)];
            (a, b, inward)
        };
        let relative = |a: [S; 2], b: [S; 2]| {
            [
                to_velocity[0] - b[1] * wb - from_velocity[0] + a[1] * wa,
                to_velocity[1] + b[0] * wb - from_velocity[1] - a[0] * wa,
            ]
        };
        match *self {
            RelativeCoordinate::Angle { .. } => S::from(0.0),
            RelativeCoordinate::Component { direction, from, to } => {
                let (_, _, inward) = points(from, to);
                dot([S::from(direction[0]), S::from(direction[1])], inward)
            }
            RelativeCoordinate::Along { direction, from, to } => {
                let u = from_pose.turned(direction);
                let (a, b, inward) = points(from, to);
                let (d, v) = (between(from_pose, a, to_pose, b), relative(a, b));
                let across = u[0] * v[1] - u[1] * v[0];
                dot(u, inward) + across * wa * 2.0 - dot(u, d) * wa.powi(2)
            }
            RelativeCoordinate::Distance { from, to } => {
                let (a, b, inward) = points(from, to);
                let (d, v) = (between(from_pose, a, to_pose, b), relative(a, b));
                let length = (d[0].powi(2) + d[1].powi(2)).sqrt();
                let u = [d[0] / length, d[1] / length];
                let across = u[0] * v[1] - u[1] * v[0];
                dot(u, inward) + across.powi(2) / length
            }
            RelativeCoordinate::Bearing { from, to } => {
                let (a, b, inward) = points(from, to);
                let (d, v) = (between(from_pose, a, to_pose, b), relative(a, b));
                let square = d[0].powi(2) + d[1].powi(2);
                let across = |x: [S; 2]| (d[0] * x[1] - d[1] * x[0]) / square;
                across(inward) - across(v) * dot(d, v) / square * 2.0
            }
        }
    }
}

/// The poses of the bodies and, last, of the ground.
pub(super) fn poses(positions: &[[f64; 3]]) -> Vec<Pose<f64>> {
    positions.iter().map(|&position| Pose::new(position)).chain([Pose::ground()]).collect()
}

/// The poses of the bodies between which a measure is taken, among those of all bodies and, last, of the ground.
#[inline(always)]
pub(super) fn pair<'a, S>(measure: &RelativeCoordinate, poses: &'a [Pose<S>]) -> [&'a Pose<S>; 2] {
    let ground = poses.len() - 1;
    let [from, to] = measure.bodies();
    [&poses[from.unwrap_or(ground)], &poses[to.unwrap_or(ground)]]
}

/// [`RelativeCoordinate::gradient`] with the poses of all bodies and the ground.
#[inline(always)]
pub(super) fn gradient<S: Real>(measure: &RelativeCoordinate, poses: &[Pose<S>]) -> Gradient<S> {
    measure.gradient(pair(measure, poses))
}

/// [`RelativeCoordinate::bias`] with the poses of all bodies and the ground, and the velocities of the bodies.
pub(super) fn bias(measure: &RelativeCoordinate, poses: &[Pose<f64>], velocities: &[[f64; 3]]) -> f64 {
    let [from_velocity, to_velocity] =
        measure.bodies().map(|frame| frame.map_or([0.0; 3], |body| velocities[body]));
    measure.bias(pair(measure, poses), [from_velocity, to_velocity])
}

/// The velocity `(∂m/∂q) q̇` of a measure, from the velocities of the bodies.
#[inline(always)]
pub(super) fn rate<S: Real>(
    measure: &RelativeCoordinate,
    gradient: &Gradient<S>,
    velocities: &[[S; 3]],
) -> S {
    let dot = |[ax, ay, aw]: [S; 3], [bx, by, bw]: [S; 3]| ax * bx + ay * by + aw * bw;
    let of = |frame: BodyFrame, part: [S; 3]| frame.map_or(S::from(0.0), |body| dot(part, velocities[body]));
    let [from, to] = measure.bodies();
    of(from, gradient.from) + of(to, gradient.to)
}

#[inline(always)]
fn opposite<S: Real>([x, y, moment]: [S; 3]) -> [S; 3] {
    [-x, -y, -moment]
}

/// From A to B.
#[inline(always)]
fn between<S: Real>(from: &Pose<S>, a: [S; 2], to: &Pose<S>, b: [S; 2]) -> [S; 2] {
    [to.x + b[0] - from.x - a[0], to.y + b[1] - from.y - a[1]]
}

#[inline(always)]
fn dot<S: Real>(a: [S; 2], b: [S; 2]) -> S {
    a[0] * b[0] + a[1] * b[1]
}
