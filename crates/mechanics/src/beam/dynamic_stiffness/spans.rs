//! Beams of several spans, each uniform, by the same exact dynamic stiffness (Euler–Bernoulli).
//!
//! In any one system of units: `EI w'''' − N w'' + (k − λ m) w = 0` in each span; `λ` is `ω²` in those units, and
//! `β = λ^¼`.

use nalgebra::{Matrix2, Vector2, Vector4};

use super::{Beam, BeamError, Chain, MOST_WAVES, Node, SEGMENTS, Segment, negatives, search::Search};
use dalembert_numerics::{
    gauss_legendre,
    linalg::{LinalgError, SymmetricBand, lowest_modes},
    roots,
};

/// A uniform part of the beam.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span {
    /// Length.
    pub length: f64,
    /// Bending stiffness `EI`.
    pub bending: f64,
    /// Mass of each length.
    pub mass: f64,
    /// Axial force, tension positive.
    pub axial: f64,
    /// Stiffness of the foundation for each length.
    pub foundation: f64,
}

/// Support and lumped elements at an end of a span.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SpanJoint {
    /// True if the deflection is zero (support).
    pub held: bool,
    /// True if the rotation is zero (clamp).
    pub clamped: bool,
    /// Spring to the ground.
    pub spring: f64,
    /// Rotation spring to the ground.
    pub turning_spring: f64,
    /// Force for a unit rotation, and moment for a unit deflection: the free edge of a plate has one.
    pub coupling: f64,
    /// Mass.
    pub mass: f64,
    /// Moment of inertia.
    pub inertia: f64,
}

/// Spans from left to right, and the joints at their ends: one more than spans.
#[derive(Clone, Debug, PartialEq)]
pub struct Spans {
    /// The spans.
    pub spans: Vec<Span>,
    /// The joints.
    pub joints: Vec<SpanJoint>,
}

/// The shape of a vibration, largest deflection one.
#[derive(Clone, Debug, PartialEq)]
pub struct SpanShape {
    beam: Spans,
    lambda: f64,
    starts: Vec<Start>,
}

/// Start of a segment, its span, and the state vector there, forces over `EI`.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Start {
    x: f64,
    span: usize,
    state: Vector4<f64>,
}

impl Span {
    /// The span with `EI` for unit.
    fn beam(&self) -> Beam {
        Beam {
            shear: 0.0,
            rotary: 0.0,
            axial: self.axial / self.bending,
            foundation: self.foundation / self.bending,
            stations: Vec::new(),
        }
    }

    fn lambda(&self, lambda: f64) -> f64 {
        lambda * self.mass / self.bending
    }
}

impl Spans {
    /// Length of the whole.
    pub fn length(&self) -> f64 {
        self.spans.iter().map(|span| span.length).sum()
    }

    /// The first `count` roots `β_n` above zero, ascending.
    ///
    /// # Errors
    /// All of [`BeamError`].
    pub fn roots(&self, count: usize) -> Result<Vec<f64>, BeamError> {
        self.check()?;
        let rigid = self.rigid_motions();
        let squeezed = self.spans.iter().fold(0.0f64, |most, span| most.max(-span.axial));
        if squeezed > 0.0 {
            // A little below zero, so that motions as a whole are not counted by rounding.
            let lambda = if rigid == 0 { 0.0 } else { -1e-6 * squeezed.min(1.0) };
            if self.count(lambda, SEGMENTS[0])? > 0 {
                return Err(BeamError::Buckled);
            }
        }
        let search = Search {
            count: |lambda: f64, angle: f64| self.count(lambda, angle),
            quotient: |beta: f64| Ok(self.unscaled(beta)?.rayleigh_quotient()),
            // A shape of several spans settles later.
            alone: 0.02,
        };
        search.roots(rigid, count)
    }

    /// Motions as a whole that nothing holds: none, one or two.
    pub fn rigid_motions(&self) -> usize {
        let stretched = self.spans.iter().any(|span| span.axial != 0.0);
        if self.spans.iter().any(|span| span.foundation > 0.0) {
            return 0;
        }
        let places = self.joints.iter().filter(|joint| joint.held || joint.spring > 0.0).count();
        let turns = stretched || self.joints.iter().any(|joint| joint.clamped || joint.turning_spring > 0.0);
        if places > 1 { 0 } else { usize::from(places == 0) + usize::from(!turns) }
    }

    /// The shape of the vibration at a root.
    ///
    /// # Errors
    /// `TooSlender`; `NotConverged` where the shape is not a finite number.
    pub fn shape(&self, root: f64) -> Result<SpanShape, BeamError> {
        let mut shape = self.unscaled(root)?;
        let sampled = shape.along(16);
        let crest = sampled.into_iter().fold(0.0f64, |a, (_, w)| if w.abs() > a.abs() { w } else { a });
        shape.starts.iter_mut().for_each(|start| start.state /= crest);
        let finite = shape.starts.iter().all(|start| start.state.iter().all(|x| x.is_finite()));
        if finite { Ok(shape) } else { Err(BeamError::NotConverged) }
    }

    /// The lowest `λ` above zero with cubic finite elements, so many in each span: upper bounds.
    ///
    /// # Errors
    /// Those of [`lowest_modes`].
    pub fn finite_elements(&self, parts: usize, count: usize) -> Result<Vec<f64>, LinalgError> {
        // The number of each coordinate that is not held.
        let nodes = self.spans.len() * parts + 1;
        let mut size = 0;
        let mut number = Vec::with_capacity(2 * nodes);
        for node in 0..nodes {
            let joint = (node % parts == 0).then(|| self.joints[node / parts]);
            for held in joint.map_or([false, false], |joint| [joint.held, joint.clamped]) {
                number.push((!held).then_some(size));
                size += usize::from(!held);
            }
        }
        let mut stiffness = SymmetricBand::zeros(size, 3)?;
        let mut mass = SymmetricBand::zeros(size, 3)?;
        let mut add = |i: usize, j: usize, k: f64, m: f64| {
            if let (Some(i), Some(j)) = (number[i], number[j]) {
                let (row, column) = (i.max(j), i.min(j));
                stiffness.add(row, column, k);
                mass.add(row, column, m);
            }
        };
        for (s, span) in self.spans.iter().enumerate() {
            let h = span.length / parts as f64;
            let sizes = [1.0, h, 1.0, h];
            for part in 0..parts {
                let first = 2 * (s * parts + part);
                for i in 0..4 {
                    for j in 0..=i {
                        let size = sizes[i] * sizes[j];
                        let inertia = h / 420.0 * INERTIA[i][j] * size;
                        let k = span.bending / h.powi(3) * BENDING[i][j] * size
                            + span.axial / (30.0 * h) * TENSION[i][j] * size
                            + span.foundation * inertia;
                        add(first + i, first + j, k, span.mass * inertia);
                    }
                }
            }
        }
        for (n, joint) in self.joints.iter().enumerate() {
            let first = 2 * n * parts;
            add(first, first, joint.spring, joint.mass);
            add(first + 1, first + 1, joint.turning_spring, joint.inertia);
            add(first + 1, first, joint.coupling, 0.0);
        }
        let rigid = self.rigid_motions();
        let modes = lowest_modes(&stiffness, &mass, (rigid + count).min(size))?;
        Ok(modes.values.iter().skip(rigid).copied().collect())
    }

    /// Number of `λ` below this value (Wittrick–Williams count).
    fn count(&self, lambda: f64, angle: f64) -> Result<usize, BeamError> {
        let chain = self.chain(lambda, angle)?.0;
        let clamped: usize = chain.segments.iter().map(|segment| segment.clamped).sum();
        Ok(clamped + chain.pivots().iter().map(negatives).sum::<usize>())
    }

    /// The chain of segments at one `λ`, and the span of each.
    fn chain(&self, lambda: f64, angle: f64) -> Result<(Chain, Vec<usize>), BeamError> {
        let mut of = Vec::new();
        let mut chain = Chain { segments: Vec::new(), nodes: Vec::new(), sizes: [0.0; 2] };
        let (mut left_over, mut x) = (Matrix2::zeros(), 0.0);
        for (n, joint) in self.joints.iter().enumerate() {
            let turning = joint.turning_spring - lambda * joint.inertia;
            let own =
                Matrix2::new(joint.spring - lambda * joint.mass, joint.coupling, joint.coupling, turning);
            let mut node = Node { stiffness: left_over + own, held: [joint.held, joint.clamped] };
            let Some(span) = self.spans.get(n) else {
                chain.nodes.push(node);
                break;
            };
            let beam = span.beam();
            let lambda = span.lambda(lambda);
            let wave = beam.largest_wave_number(lambda);
            if !(wave.is_finite() && wave * span.length <= MOST_WAVES) {
                return Err(BeamError::TooSlender(wave * span.length));
            }
            let parts = (span.length * wave / angle).ceil().max(1.0);
            let plain = beam.segment(lambda, span.length / parts);
            let segment = Segment {
                inverse: plain.inverse * span.bending,
                left: plain.left * span.bending,
                right: plain.right * span.bending,
                ..plain
            };
            let size = wave.max(span.length.recip());
            chain.sizes[0] = chain.sizes[0].max(span.bending * size.powi(3));
            chain.sizes[1] = chain.sizes[1].max(span.bending * size);
            for part in 0..parts as usize {
                node.stiffness += segment.left;
                chain.nodes.push(node);
                let start = x + span.length * part as f64 / parts;
                chain.segments.push(Segment { start, ..segment });
                of.push(n);
                node = Node { stiffness: segment.right, held: [false, false] };
            }
            left_over = segment.right;
            x += span.length;
        }
        chain.hold();
        Ok((chain, of))
    }

    fn unscaled(&self, root: f64) -> Result<SpanShape, BeamError> {
        let lambda = root.powi(4);
        let (chain, of) = self.chain(lambda, SEGMENTS[0])?;
        let displacements = chain.shape();
        let start = |((segment, ends), span): ((&Segment, &[Vector2<f64>]), &usize)| {
            let forces = segment.inverse * (ends[1] - segment.carry * ends[0]) / self.spans[*span].bending;
            let state = Vector4::new(ends[0].x, ends[0].y, forces.x, forces.y);
            Start { x: segment.start, span: *span, state }
        };
        let starts = chain.segments.iter().zip(displacements.windows(2)).zip(&of).map(start).collect();
        Ok(SpanShape { beam: self.clone(), lambda, starts })
    }

    fn check(&self) -> Result<(), BeamError> {
        let positive = |x: f64| x.is_finite() && x > 0.0;
        let spans = self.spans.iter().all(|span| {
            positive(span.length)
                && positive(span.bending)
                && positive(span.mass)
                && span.axial.is_finite()
                && span.foundation.is_finite()
        });
        let joints = self.joints.iter().all(|joint| {
            [joint.spring, joint.turning_spring, joint.mass, joint.inertia]
                .into_iter()
                .all(|x| x.is_finite() && x >= 0.0)
        });
        let fit = !self.spans.is_empty() && self.joints.len() == self.spans.len() + 1;
        if spans && joints && fit { Ok(()) } else { Err(BeamError::OutOfRange) }
    }
}

impl SpanShape {
    /// The deflection at `x` from the left end.
    pub fn deflection(&self, x: f64) -> f64 {
        self.state(x)[0]
    }

    /// Deflection, rotation, force and moment, the last two over `EI`.
    fn state(&self, x: f64) -> Vector4<f64> {
        let after = self.starts.partition_point(|start| start.x <= x);
        let start = &self.starts[after.saturating_sub(1)];
        let span = &self.beam.spans[start.span];
        span.beam().transfer(span.lambda(self.lambda), x - start.x) * start.state
    }

    /// Points where the deflection passes through zero, ascending; supports are not among them.
    pub fn nodes(&self) -> Vec<f64> {
        let mut place = 0.0;
        let mut held = Vec::new();
        for (n, joint) in self.beam.joints.iter().enumerate() {
            if joint.held {
                held.push(place);
            }
            place += self.beam.spans.get(n).map_or(0.0, |span| span.length);
        }
        let sampled: Vec<(f64, f64)> = self.along(8).into_iter().filter(|(_, w)| w.abs() > 1e-9).collect();
        let free = |pair: &&[(f64, f64)]| !held.iter().any(|at| pair[0].0 <= *at && *at <= pair[1].0);
        let crossing = |pair| roots::crossing(pair, |x| self.deflection(x));
        sampled.windows(2).filter(free).filter_map(crossing).collect()
    }

    /// Rayleigh's quotient: twice the strain energy, that of axial force, foundation and joints included, over twice
    /// the kinetic energy at unit frequency. At a root it is `λ`.
    pub fn rayleigh_quotient(&self) -> f64 {
        let (mut strain, mut kinetic) = (0.0, 0.0);
        for (x, weight, span) in self.points() {
            let state = self.state(x);
            let span = &self.beam.spans[span];
            strain += weight
                * (span.bending * state[3].powi(2)
                    + span.axial * state[1].powi(2)
                    + span.foundation * state[0].powi(2));
            kinetic += weight * span.mass * state[0].powi(2);
        }
        self.at_joints(|joint, x| {
            let state = self.state(x);
            let (w, turn) = (state[0], state[1]);
            strain +=
                joint.spring * w * w + 2.0 * joint.coupling * w * turn + joint.turning_spring * turn * turn;
            kinetic += joint.mass * w * w + joint.inertia * turn * turn;
        });
        strain / kinetic
    }

    /// `∫ m w v dx + Σ (m w v + J w' v')` of two shapes: zero where they belong to different roots.
    pub fn inertia_product(&self, other: &SpanShape) -> f64 {
        // The finer of the two divisions: no product is then of too high a degree.
        let finer = if self.starts.len() >= other.starts.len() { self } else { other };
        let inside = |(x, weight, span): (f64, f64, usize)| {
            weight * self.beam.spans[span].mass * self.deflection(x) * other.deflection(x)
        };
        let mut sum: f64 = finer.points().map(inside).sum();
        self.at_joints(|joint, x| {
            let (a, b) = (self.state(x), other.state(x));
            sum += joint.mass * a[0] * b[0] + joint.inertia * a[1] * b[1];
        });
        sum
    }

    fn at_joints(&self, mut look: impl FnMut(&SpanJoint, f64)) {
        let mut x = 0.0;
        for (n, joint) in self.beam.joints.iter().enumerate() {
            look(joint, x);
            x += self.beam.spans.get(n).map_or(0.0, |span| span.length);
        }
    }

    /// Start, length and span of each segment.
    fn segments(&self) -> impl Iterator<Item = (f64, f64, usize)> {
        let ends = self.starts.iter().skip(1).map(|start| start.x).chain([self.beam.length()]);
        self.starts.iter().zip(ends).map(|(start, end)| (start.x, end - start.x, start.span))
    }

    /// Points of integration, their weights and spans.
    fn points(&self) -> impl Iterator<Item = (f64, f64, usize)> {
        self.segments().flat_map(|(x, length, span)| {
            gauss_legendre::points(1).map(move |(part, weight)| (x + length * part, length * weight, span))
        })
    }

    /// Deflections at equal parts of each segment.
    fn along(&self, parts: usize) -> Vec<(f64, f64)> {
        let inside = self
            .segments()
            .flat_map(|(x, length, _)| (0..parts).map(move |n| x + length * n as f64 / parts as f64));
        inside.chain([self.beam.length()]).map(|x| (x, self.deflection(x))).collect()
    }
}

/// Bending stiffness of an element over `EI/h³`, rotations over `h`.
pub(super) const BENDING: [[f64; 4]; 4] =
    [[12.0, 6.0, -12.0, 6.0], [6.0, 4.0, -6.0, 2.0], [-12.0, -6.0, 12.0, -6.0], [6.0, 2.0, -6.0, 4.0]];

/// Stiffness by tension over `N/(30h)`.
const TENSION: [[f64; 4]; 4] =
    [[36.0, 3.0, -36.0, 3.0], [3.0, 4.0, -3.0, -1.0], [-36.0, -3.0, 36.0, -3.0], [3.0, -1.0, -3.0, 4.0]];

/// Mass over `m h/420`.
pub(super) const INERTIA: [[f64; 4]; 4] = [
    [156.0, 22.0, 54.0, -13.0],
    [22.0, 4.0, 13.0, -3.0],
    [54.0, 13.0, 156.0, -22.0],
    [-13.0, -3.0, -22.0, 4.0],
];
