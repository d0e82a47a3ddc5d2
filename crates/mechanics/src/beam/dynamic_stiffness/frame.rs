//! Plane frames of straight members, each uniform, by the same exact dynamic stiffness: they bend and they stretch.
//!
//! In any one system of units; `λ` is `ω²` in those units and `β = λ^¼`. Each member is cut into segments so short that
//! none of them resonates by itself with its ends held; joints come last among the unknowns, so that the matrix is
//! eliminated member by member (W. H. Wittrick and F. W. Williams, *Q. J. Mech. Appl. Math.* 24, 1971, pp. 263–284).

use nalgebra::{DMatrix, Vector2, Vector4};

use super::{
    Beam, BeamError, MOST_WAVES, SEGMENTS, Segment,
    search::Search,
    spans::{BENDING, INERTIA},
};
use dalembert_numerics::{
    gauss_legendre,
    linalg::{Elimination, LinalgError, SymmetricBand, lowest_modes},
};

mod matrix;

use self::matrix::{Envelope, FrameElimination};

/// A joint of a frame: where members meet, what holds it and what it carries.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FrameJoint {
    /// Place.
    pub at: [f64; 2],
    /// True for each of the two displacements and the rotation that is zero.
    pub held: [bool; 3],
    /// Springs to the ground against the two displacements and the rotation.
    pub springs: [f64; 3],
    /// Mass.
    pub mass: f64,
    /// Moment of inertia.
    pub inertia: f64,
}

/// A straight uniform member between two joints.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrameMember {
    /// Places of its joints in the list.
    pub joints: [usize; 2],
    /// True for each end that a hinge joins to its joint.
    pub hinged: [bool; 2],
    /// Bending stiffness `EI`.
    pub bending: f64,
    /// Stiffness along the axis, `EA`.
    pub axial: f64,
    /// Mass of each length.
    pub mass: f64,
    /// Shear flexibility `EI/(κ G A)`, a length squared; zero for Euler–Bernoulli.
    pub shear: f64,
    /// Rotary inertia `I/A`, a length squared; zero for Euler–Bernoulli.
    pub rotary: f64,
}

/// Members and joints.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// Joints.
    pub joints: Vec<FrameJoint>,
    /// Members.
    pub members: Vec<FrameMember>,
}

/// The shape of a vibration, largest displacement one.
#[derive(Clone, Debug, PartialEq)]
pub struct FrameShape {
    frame: Frame,
    lambda: f64,
    /// The unknowns that the shape was found with, of unit norm.
    unknowns: Vec<f64>,
    members: Vec<MemberShape>,
    /// Displacements and rotation of each joint.
    joints: Vec<[f64; 3]>,
}

/// The motion of a member: of the starts of its segments.
#[derive(Clone, Debug, PartialEq)]
struct MemberShape {
    /// Length of a segment.
    segment: f64,
    /// Displacements along the axis at both ends of each segment, and the state in bending at its start, forces over `EI`.
    starts: Vec<([f64; 2], Vector4<f64>)>,
}

/// An end of a segment: its unknowns, and the direction of the axis in them.
#[derive(Clone, Copy)]
struct End {
    unknowns: [Option<usize>; 3],
    direction: [f64; 2],
}

/// The unknowns of the frame cut into segments.
struct Layout {
    size: usize,
    /// The ends of the segments of each member: one more than segments.
    ends: Vec<Vec<End>>,
    joints: Vec<[Option<usize>; 3]>,
}

impl End {
    /// Displacements along the axis and across it and the rotation, of the unknowns.
    fn local(&self, x: &[f64]) -> [f64; 3] {
        let value = |n: usize| self.unknowns[n].map_or(0.0, |at| x[at]);
        let ([c, s], [u, v, turn]) = (self.direction, [value(0), value(1), value(2)]);
        [c * u + s * v, c * v - s * u, turn]
    }
}

impl Layout {
    /// The unknowns that stand together in a segment or a joint.
    fn groups(&self) -> impl Iterator<Item = [Option<usize>; 6]> {
        let segments = self.ends.iter().flat_map(|ends| ends.windows(2)).map(unknowns);
        segments.chain(self.joints.iter().map(|[x, y, turn]| [*x, *y, *turn, None, None, None]))
    }
}

impl FrameMember {
    /// The member with `EI` for unit.
    fn beam(&self) -> Beam {
        Beam { shear: self.shear, rotary: self.rotary, axial: 0.0, foundation: 0.0, stations: Vec::new() }
    }

    fn lambda(&self, lambda: f64) -> f64 {
        lambda * self.mass / self.bending
    }

    /// Wave number of the waves along the axis.
    fn along(&self, lambda: f64) -> f64 {
        (lambda * self.mass / self.axial).max(0.0).sqrt()
    }
}

impl Frame {
    /// Length and direction of a member.
    fn span(&self, member: &FrameMember) -> (f64, [f64; 2]) {
        let [from, to] = member.joints.map(|joint| self.joints[joint].at);
        let (x, y) = (to[0] - from[0], to[1] - from[1]);
        let length = x.hypot(y);
        (length, [x / length, y / length])
    }

    /// The first `count` roots `β_n` above zero, ascending.
    ///
    /// # Errors
    /// All of [`BeamError`] but `Buckled`.
    pub fn roots(&self, count: usize) -> Result<Vec<f64>, BeamError> {
        self.check()?;
        let rigid = self.rigid_motions()?;
        let search = Search {
            count: |lambda: f64, angle: f64| self.count(lambda, angle),
            quotient: |beta: f64| Ok(self.shape(beta, &[])?.rayleigh_quotient()),
            alone: 0.02,
        };
        search.roots(rigid, count)
    }

    /// Motions without deformation that nothing holds.
    ///
    /// # Errors
    /// `NotConverged` where the rank of the static stiffness is not found.
    pub fn rigid_motions(&self) -> Result<usize, BeamError> {
        let layout = self.layout(&vec![1; self.members.len()]);
        let (matrix, _) = self.stiffness(&layout, 0.0);
        let size = layout.size;
        if size == 0 {
            return Ok(0);
        }
        let full = matrix.full();
        let scale = |row: usize| full[(row, row)].abs().max(f64::MIN_POSITIVE).sqrt().recip();
        let even = DMatrix::from_fn(size, size, |i, j| full[(i, j)] * scale(i) * scale(j));
        Elimination::new(&even).map(|found| size - found.rank()).map_err(|_| BeamError::NotConverged)
    }

    /// The shapes of the vibrations at roots in ascending order; those of equal roots are independent.
    ///
    /// # Errors
    /// `TooSlender`; `NotConverged` where a shape is not a finite number.
    pub fn shapes(&self, roots: &[f64]) -> Result<Vec<FrameShape>, BeamError> {
        let mut shapes: Vec<FrameShape> = Vec::with_capacity(roots.len());
        for (n, root) in roots.iter().enumerate() {
            let equal = roots[..n].iter().rev().take_while(|other| *root / **other < 1.0 + 1e-7).count();
            let mut shape = self.shape(*root, &shapes[n - equal..])?;
            let crest = shape.crest();
            for member in &mut shape.members {
                for (along, state) in &mut member.starts {
                    for u in along {
                        *u /= crest;
                    }
                    *state /= crest;
                }
            }
            shape.joints.iter_mut().flatten().for_each(|u| *u /= crest);
            if !shape.joints.iter().flatten().all(|x| x.is_finite()) {
                return Err(BeamError::NotConverged);
            }
            shapes.push(shape);
        }
        Ok(shapes)
    }

    /// The lowest `λ` above zero with cubic finite elements, so many in each member: upper bounds (Euler–Bernoulli).
    ///
    /// # Errors
    /// Those of [`lowest_modes`].
    pub fn finite_elements(&self, parts: usize, count: usize) -> Result<Vec<f64>, LinalgError> {
        let layout = self.layout(&vec![parts; self.members.len()]);
        let mut stiffness = DMatrix::zeros(layout.size, layout.size);
        let mut mass = DMatrix::zeros(layout.size, layout.size);
        for (member, ends) in self.members.iter().zip(&layout.ends) {
            let h = self.span(member).0 / parts as f64;
            let sizes = [1.0, h, 1.0, h];
            let local = |matrix: &[[f64; 4]; 4], along: [f64; 2], factor: f64| {
                let mut all = [[0.0; 6]; 6];
                for (i, row) in matrix.iter().enumerate() {
                    for (j, entry) in row.iter().enumerate() {
                        all[i + i / 2 + 1][j + j / 2 + 1] = factor * entry * sizes[i] * sizes[j];
                    }
                }
                (all[0][0], all[3][3], all[0][3], all[3][0]) = (along[0], along[0], along[1], along[1]);
                all
            };
            let rod = member.axial / h;
            let k = local(&BENDING, [rod, -rod], member.bending / h.powi(3));
            let own = member.mass * h;
            let m = local(&INERTIA, [own / 3.0, own / 6.0], own / 420.0);
            for pair in ends.windows(2) {
                for (all, local) in [(&mut stiffness, &k), (&mut mass, &m)] {
                    for (row, column, value) in entries(local, pair) {
                        all[(row, column)] += value;
                    }
                }
            }
        }
        for (joint, unknowns) in self.joints.iter().zip(&layout.joints) {
            let inertias = [joint.mass, joint.mass, joint.inertia];
            for (n, unknown) in unknowns.iter().enumerate() {
                if let Some(at) = *unknown {
                    stiffness[(at, at)] += joint.springs[n];
                    mass[(at, at)] += inertias[n];
                }
            }
        }
        let rigid = self.rigid_motions().map_err(|_| LinalgError::NotConverged)?;
        let count = (rigid + count).min(layout.size);
        let modes = lowest_modes(&SymmetricBand::of(&stiffness)?, &SymmetricBand::of(&mass)?, count)?;
        Ok(modes.values.iter().skip(rigid).copied().collect())
    }

    /// Number of `λ` below this value (Wittrick–Williams count).
    fn count(&self, lambda: f64, angle: f64) -> Result<usize, BeamError> {
        let layout = self.layout(&self.parts(lambda, angle)?);
        let (matrix, clamped) = self.stiffness(&layout, lambda);
        Ok(clamped + matrix.pivots().iter().filter(|pivot| **pivot < 0.0).count())
    }

    /// Segments of each member, in which no wave turns through more than this angle.
    fn parts(&self, lambda: f64, angle: f64) -> Result<Vec<usize>, BeamError> {
        let of = |member: &FrameMember| {
            let bending = member.beam().largest_wave_number(member.lambda(lambda));
            let waves = bending.max(member.along(lambda)) * self.span(member).0;
            if waves.is_finite() && waves <= MOST_WAVES {
                return Ok((waves / angle).ceil().max(1.0) as usize);
            }
            Err(BeamError::TooSlender(waves))
        };
        self.members.iter().map(of).collect()
    }

    /// Numbers the unknowns: those inside of members first, those of joints last.
    fn layout(&self, parts: &[usize]) -> Layout {
        let mut size = 0;
        let mut next = |is_free: bool| {
            is_free.then(|| {
                size += 1;
                size - 1
            })
        };
        let mut inner = Vec::with_capacity(self.members.len());
        for (member, parts) in self.members.iter().zip(parts) {
            let first = next(member.hinged[0]);
            let between: Vec<[Option<usize>; 3]> =
                (1..*parts).map(|_| [(); 3].map(|()| next(true))).collect();
            inner.push((first, between, next(member.hinged[1])));
        }
        let turns = |at: usize| {
            let rigid =
                |member: &FrameMember| (0..2).any(|end| member.joints[end] == at && !member.hinged[end]);
            self.members.iter().any(rigid)
                || self.joints[at].springs[2] > 0.0
                || self.joints[at].inertia > 0.0
        };
        let mut joints = Vec::with_capacity(self.joints.len());
        for (at, joint) in self.joints.iter().enumerate() {
            let [x, y, turn] = joint.held;
            joints.push([next(!x), next(!y), next(!turn && turns(at))]);
        }
        let ends = self.members.iter().zip(inner).map(|(member, (first, between, last))| {
            let (_, direction) = self.span(member);
            let at_joint = |end: usize, hinge: Option<usize>| {
                let [x, y, turn] = joints[member.joints[end]];
                let turn = if member.hinged[end] { hinge } else { turn };
                End { unknowns: [x, y, turn], direction }
            };
            let between = between.into_iter().map(|unknowns| End { unknowns, direction: [1.0, 0.0] });
            std::iter::once(at_joint(0, first)).chain(between).chain([at_joint(1, last)]).collect()
        });
        Layout { ends: ends.collect(), joints: joints.clone(), size }
    }

    /// The dynamic stiffness, and the number of frequencies below `λ` of segments with their ends held.
    fn stiffness(&self, layout: &Layout, lambda: f64) -> (Envelope, usize) {
        let mut matrix = Envelope::zeros(layout.size, layout.groups());
        let mut clamped = 0;
        for (member, ends) in self.members.iter().zip(&layout.ends) {
            let parts = ends.len() - 1;
            let length = self.span(member).0 / parts as f64;
            let segment = member.beam().segment(member.lambda(lambda), length);
            clamped += parts * segment.clamped;
            let along = rod(member.axial, member.along(lambda), length);
            let local = local(&segment, member.bending, along);
            for pair in ends.windows(2) {
                for (row, column, value) in entries(&local, pair) {
                    if column <= row {
                        matrix.add(row, column, value);
                    }
                }
            }
        }
        for (joint, unknowns) in self.joints.iter().zip(&layout.joints) {
            let inertias = [joint.mass, joint.mass, joint.inertia];
            for (n, unknown) in unknowns.iter().enumerate() {
                if let Some(at) = *unknown {
                    matrix.add(at, at, joint.springs[n] - lambda * inertias[n]);
                }
            }
        }
        (matrix, clamped)
    }

    /// The shape next to a trial root, orthogonal to others of the same root.
    fn shape(&self, root: f64, others: &[FrameShape]) -> Result<FrameShape, BeamError> {
        let lambda = root.powi(4);
        let layout = self.layout(&self.parts(lambda, SEGMENTS[0])?);
        let (matrix, _) = self.stiffness(&layout, lambda);
        let factors = FrameElimination::of(&matrix);
        // A start without symmetry; four rounds leave nothing of other shapes.
        let turn = 0.7 + others.len() as f64;
        let mut x: Vec<f64> = (0..layout.size).map(|row| 0.4 + (turn * (row as f64 + 1.0)).sin()).collect();
        for _ in 0..4 {
            factors.solve(&mut x);
            for other in others.iter().filter(|other| other.unknowns.len() == layout.size) {
                let shared: f64 = x.iter().zip(&other.unknowns).map(|(a, b)| a * b).sum();
                x.iter_mut().zip(&other.unknowns).for_each(|(x, own)| *x -= shared * own);
            }
            let size = x.iter().map(|x| x * x).sum::<f64>().sqrt();
            for x in &mut x {
                *x /= size;
            }
        }
        let members = self.members.iter().zip(&layout.ends).map(|(member, ends)| {
            let length = self.span(member).0 / (ends.len() - 1) as f64;
            let segment = member.beam().segment(member.lambda(lambda), length);
            let start = |pair: &[End]| {
                let (from, to) = (pair[0].local(&x), pair[1].local(&x));
                let (near, far) = (Vector2::new(from[1], from[2]), Vector2::new(to[1], to[2]));
                let forces = segment.inverse * (far - segment.carry * near);
                ([from[0], to[0]], Vector4::new(near.x, near.y, forces.x, forces.y))
            };
            MemberShape { segment: length, starts: ends.windows(2).map(start).collect() }
        });
        let value = |unknown: Option<usize>| unknown.map_or(0.0, |at| x[at]);
        let joints = layout.joints.iter().map(|unknowns| unknowns.map(value)).collect();
        Ok(FrameShape { frame: self.clone(), lambda, members: members.collect(), joints, unknowns: x })
    }

    fn check(&self) -> Result<(), BeamError> {
        let positive = |x: f64| x.is_finite() && x > 0.0;
        let sound = |x: f64| x.is_finite() && x >= 0.0;
        let members = self.members.iter().all(|member| {
            member.joints.iter().all(|joint| *joint < self.joints.len())
                && positive(self.span(member).0)
                && [member.bending, member.axial, member.mass].into_iter().all(positive)
                && [member.shear, member.rotary].into_iter().all(sound)
        });
        let joints = self
            .joints
            .iter()
            .all(|joint| joint.springs.into_iter().chain([joint.mass, joint.inertia]).all(sound));
        if members && joints && !self.members.is_empty() { Ok(()) } else { Err(BeamError::OutOfRange) }
    }
}

impl FrameShape {
    /// Displacements and rotation of a joint.
    pub fn joint(&self, joint: usize) -> [f64; 3] {
        self.joints[joint]
    }

    /// Displacement of a point of a member, a share of its length from its first joint.
    pub fn displacement(&self, member: usize, share: f64) -> [f64; 2] {
        let (length, [c, s]) = self.frame.span(&self.frame.members[member]);
        let Motion { along, state, .. } = self.motion(member, share * length);
        [c * along - s * state[0], s * along + c * state[0]]
    }

    /// Rayleigh's quotient: twice the strain energy over twice the kinetic energy at unit frequency. At a root it is `λ`.
    pub fn rayleigh_quotient(&self) -> f64 {
        let (mut strain, mut kinetic) = (0.0, 0.0);
        for (n, x, weight) in self.points() {
            let member = &self.frame.members[n];
            let Motion { along, stretch, state } = self.motion(n, x);
            strain += weight
                * (member.bending * (state[3].powi(2) + member.shear * state[2].powi(2))
                    + member.axial * stretch.powi(2));
            kinetic +=
                weight * member.mass * (along.powi(2) + state[0].powi(2) + member.rotary * state[1].powi(2));
        }
        for (joint, [x, y, turn]) in self.frame.joints.iter().zip(&self.joints) {
            let [kx, ky, kt] = joint.springs;
            strain += kx * x * x + ky * y * y + kt * turn * turn;
            kinetic += joint.mass * (x * x + y * y) + joint.inertia * turn * turn;
        }
        strain / kinetic
    }

    /// Sum of mass times displacement times displacement of two shapes: zero where they belong to different roots.
    pub fn inertia_product(&self, other: &FrameShape) -> f64 {
        let parts =
            |shape: &FrameShape| shape.members.iter().map(|member| member.starts.len()).sum::<usize>();
        let finer = if parts(self) >= parts(other) { self } else { other };
        let mut sum: f64 = finer
            .points()
            .map(|(n, x, weight)| {
                let member = &self.frame.members[n];
                let (a, b) = (self.motion(n, x), other.motion(n, x));
                weight
                    * member.mass
                    * (a.along * b.along + a.state[0] * b.state[0] + member.rotary * a.state[1] * b.state[1])
            })
            .sum();
        for (n, joint) in self.frame.joints.iter().enumerate() {
            let (a, b) = (self.joints[n], other.joints[n]);
            sum += joint.mass * (a[0] * b[0] + a[1] * b[1]) + joint.inertia * a[2] * b[2];
        }
        sum
    }

    /// The motion of a section of a member.
    fn motion(&self, member: usize, x: f64) -> Motion {
        let (shape, member) = (&self.members[member], &self.frame.members[member]);
        let at = ((x / shape.segment).floor().max(0.0) as usize).min(shape.starts.len() - 1);
        let ([near, far], start) = &shape.starts[at];
        let rest = x - at as f64 * shape.segment;
        let state = member.beam().transfer(member.lambda(self.lambda), rest) * start;
        let k = member.along(self.lambda);
        let (sin, cos) = (k * shape.segment).sin_cos();
        if sin == 0.0 {
            let slope = (far - near) / shape.segment;
            return Motion { along: near + slope * rest, stretch: slope, state };
        }
        let other = (far - near * cos) / sin;
        let (s, c) = (k * rest).sin_cos();
        Motion { along: near * c + other * s, stretch: k * (other * c - near * s), state }
    }

    /// Points of integration: member, place along it, weight.
    fn points(&self) -> impl Iterator<Item = (usize, f64, f64)> {
        self.members.iter().enumerate().flat_map(|(n, member)| {
            let length = member.segment;
            (0..member.starts.len()).flat_map(move |at| {
                gauss_legendre::points(1)
                    .map(move |(part, weight)| (n, length * (at as f64 + part), length * weight))
            })
        })
    }

    /// The largest displacement, with the sign of its larger part.
    fn crest(&self) -> f64 {
        let mut crest = 0.0f64;
        for n in 0..self.members.len() {
            for at in 0..=24u8 {
                let [x, y] = self.displacement(n, f64::from(at) / 24.0);
                let size = x.hypot(y);
                if size > crest.abs() * (1.0 + 1e-9) {
                    crest = size.copysign(if x.abs() > y.abs() { x } else { y });
                }
            }
        }
        crest
    }
}

/// Displacement along the axis, its derivative, and the state in bending.
struct Motion {
    along: f64,
    stretch: f64,
    state: Vector4<f64>,
}

/// Stiffness of a segment along its axis: at an end, and between the ends.
fn rod(axial: f64, wave: f64, length: f64) -> [f64; 2] {
    let angle = wave * length;
    let plain = axial / length;
    if angle == 0.0 { [plain, -plain] } else { [plain * angle / angle.tan(), -plain * angle / angle.sin()] }
}

/// Stiffness of a segment in the order of its two ends: along, across, rotation.
fn local(segment: &Segment, bending: f64, along: [f64; 2]) -> [[f64; 6]; 6] {
    let mut all = [[0.0; 6]; 6];
    (all[0][0], all[3][3], all[0][3], all[3][0]) = (along[0], along[0], along[1], along[1]);
    for i in 0..2 {
        for j in 0..2 {
            all[i + 1][j + 1] = bending * segment.left[(i, j)];
            all[i + 4][j + 4] = bending * segment.right[(i, j)];
            all[i + 1][j + 4] = -bending * segment.inverse[(i, j)];
            all[j + 4][i + 1] = -bending * segment.inverse[(i, j)];
        }
    }
    all
}

/// The unknowns of the two ends of a segment.
fn unknowns(pair: &[End]) -> [Option<usize>; 6] {
    let ([a, b, c], [d, e, f]) = (pair[0].unknowns, pair[1].unknowns);
    [a, b, c, d, e, f]
}

/// A matrix of a segment for the unknowns of its ends: `Tᵀ K T`, where `T` turns the displacements of each end.
fn in_unknowns(matrix: &[[f64; 6]; 6], pair: &[End]) -> [[f64; 6]; 6] {
    let mut all = *matrix;
    for (at, end) in [0, 3].into_iter().zip(pair) {
        let [c, s] = end.direction;
        for row in &mut all {
            let [along, across] = [row[at], row[at + 1]];
            (row[at], row[at + 1]) = (c * along - s * across, s * along + c * across);
        }
        for column in 0..6 {
            let [along, across] = [all[at][column], all[at + 1][column]];
            (all[at][column], all[at + 1][column]) = (c * along - s * across, s * along + c * across);
        }
    }
    all
}

/// The entries of a matrix of a segment in that of the frame: row, column and value.
fn entries(matrix: &[[f64; 6]; 6], pair: &[End]) -> impl Iterator<Item = (usize, usize, f64)> {
    let (unknowns, matrix) = (unknowns(pair), in_unknowns(matrix, pair));
    (0..36).filter_map(move |n| Some((unknowns[n / 6]?, unknowns[n % 6]?, matrix[n / 6][n % 6])))
}
