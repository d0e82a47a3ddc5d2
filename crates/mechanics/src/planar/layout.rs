//! The compiled constraint equations: which coordinates are explicit, and the evaluation of the others with their
//! Jacobian in a flat array.
//!
//! A constraint with a constant Jacobian entry by a coordinate, as that of a pin by the origin of a body, gives that
//! coordinate exactly: along a tree of such *explicit* equations all origins follow from the angles. What remains are
//! the *tree coordinates*, which no explicit equation gives, and the *loop equations*, one pair for each closed chain.

mod compile;

use super::{
    BodyFrame, BodyPoint, ConstraintTerm, Equation, Pose,
    measure::{gradient, pair, rate},
};
use crate::Real;
use dalembert_numerics::simd::{SimdReal, SimdVector, WIDTH, widest};

/// The structure of a mechanism's equations, the same in every position.
///
/// Columns are scaled coordinates, `3 body + (0, 1, 2)` for `(x, y, θ · size)`. Place 0 of the flat array takes what
/// belongs nowhere: entries by the ground and those that are always zero.
#[derive(Debug, Clone)]
pub(super) struct EquationLayout {
    /// The Jacobian by rows: of each equation its columns with their places in the flat array.
    pub(super) rows: Vec<Vec<(usize, usize)>>,
    /// The entries that are constant, in their places; zero elsewhere.
    entries: Vec<f64>,
    /// Of each place, whether its entry is one of these and not evaluated.
    is_constant: Vec<bool>,
    /// The explicit equations, in the order in which they can be used.
    pub(super) explicit: Vec<Explicit>,
    /// The rows of the loop equations.
    pub(super) loops: Vec<usize>,
    /// The largest constant Jacobian entry of each loop equation; zero where none is constant.
    loop_scales: Vec<f64>,
    /// The columns of the tree coordinates.
    pub(super) tree: Vec<usize>,
    /// The bodies whose angle is a tree coordinate, and its number among these.
    tree_angles: Vec<(usize, usize)>,
    /// The tree coordinates of origins: their number and column.
    tree_origins: Vec<(usize, usize)>,
    kernels: Vec<Kernel>,
    /// The explicit coordinates, in order, by the equations that give them.
    assignments: Vec<Assignment>,
    bodies: usize,
    length: f64,
}

/// An equation that gives a coordinate.
#[derive(Debug, Clone, Copy)]
pub(super) struct Explicit {
    pub(super) row: usize,
    pub(super) column: usize,
    /// The constant Jacobian entry.
    entry: f64,
}

/// A position, or several in the lanes of `S`, with the constraints there.
#[derive(Debug, Clone)]
pub(super) struct Position<S = f64> {
    /// Poses of the bodies and, last, of the ground.
    pub(super) poses: Vec<Pose<S>>,
    /// The residuals of the loop equations, by row; those of explicit equations are not kept up.
    pub(super) residuals: Vec<S>,
    /// The constant terms of the equations, by row.
    pub(super) constants: Vec<S>,
    /// The entries of the Jacobian in their places.
    pub(super) jacobian: Vec<S>,
    /// The arms of both points of each pin, from the origins of their bodies, in the axes of the ground.
    arms: Vec<[S; 4]>,
}

/// One equation, or the two of a pin.
#[derive(Debug, Clone)]
enum Kernel {
    /// `B − A = 0` in both directions: row of the first, and the places of the entries by θ_A and θ_B of each.
    Pin { row: usize, points: [BodyPoint; 2], bodies: [usize; 2], places: [[usize; 2]; 2], is_loop: bool },
    /// Anything; its entries may be constant.
    General { row: usize, terms: Vec<(ConstraintTerm, [[usize; 3]; 2])>, is_constant: bool, is_loop: bool },
}

/// The use of an explicit equation.
#[derive(Debug, Clone)]
enum Assignment {
    /// The origin of a body, or one coordinate of it, from a pin whose first (0) or second (1) point it carries.
    Pin { kernel: usize, side: usize, parts: [bool; 2] },
    /// A coordinate from an equation.
    General { kernel: usize, column: usize, entry: f64 },
}

impl EquationLayout {
    /// The number of places in the flat array.
    pub(super) fn places(&self) -> usize {
        self.entries.len()
    }

    /// The entry in a place, if it is the same in every position and never written.
    pub(super) fn constant(&self, place: usize) -> Option<f64> {
        self.is_constant[place].then_some(self.entries[place])
    }

    /// A position that has not been evaluated yet, with the constant terms of these equations.
    pub(super) fn position<S: SimdReal>(&self, equations: &[Equation]) -> Position<S> {
        let zero = S::from(0.0);
        Position {
            poses: vec![Pose::ground(); self.bodies + 1],
            residuals: vec![zero; self.rows.len()],
            constants: equations.iter().map(|equation| S::from(equation.constant.unwrap_or(0.0))).collect(),
            jacobian: self.entries.iter().map(|&entry| S::from(entry)).collect(),
            arms: vec![[zero; 4]; self.kernels.len()],
        }
    }

    /// Poses, residuals and Jacobian for these tree coordinates, m.
    #[inline(always)]
    pub(super) fn evaluate<S: SimdReal>(&self, tree: &[S], position: &mut Position<S>) {
        self.place(tree, position);
        self.constrain(position);
    }

    /// The poses of all bodies, from the tree coordinates along the explicit equations.
    #[inline(always)]
    fn place<S: SimdReal>(&self, tree: &[S], position: &mut Position<S>) {
        self.turn(tree, &mut position.poses);
        for &(number, column) in &self.tree_origins {
            self.set_column(column, tree[number], position);
        }
        for assignment in &self.assignments {
            match *assignment {
                Assignment::Pin { kernel, side, parts } => {
                    let Kernel::Pin { points: [a, b], bodies, .. } = self.kernels[kernel] else { continue };
                    let [ax, ay] = position.poses[bodies[0]].turned(a.at);
                    let [bx, by] = position.poses[bodies[1]].turned(b.at);
                    position.arms[kernel] = [ax, ay, bx, by];
                    let other = position.poses[bodies[1 - side]];
                    let (dx, dy) = if side == 1 { (ax - bx, ay - by) } else { (bx - ax, by - ay) };
                    let moved = &mut position.poses[bodies[side]];
                    if parts[0] {
                        moved.x = other.x + dx;
                    }
                    if parts[1] {
                        moved.y = other.y + dy;
                    }
                }
                Assignment::General { kernel, column, entry } => {
                    let Kernel::General { row, terms, .. } = &self.kernels[kernel] else { continue };
                    self.set_column(column, S::from(0.0), position);
                    let left = S::sum(terms.iter().map(|(term, _)| value(term, &position.poses)));
                    self.set_column(column, (position.constants[*row] - left) / entry, position);
                }
            }
        }
    }

    /// The angles among the tree coordinates, with cosines and sines: of several bodies at once where positions come
    /// one by one.
    #[inline(always)]
    fn turn<S: SimdReal>(&self, tree: &[S], poses: &mut [Pose<S>]) {
        let per_length = 1.0 / self.length;
        if S::COUNT > 1 {
            for &(body, number) in &self.tree_angles {
                let angle = tree[number] * per_length;
                poses[body].turn(angle, [angle.cos(), angle.sin()]);
            }
            return;
        }
        for bodies in self.tree_angles.chunks(WIDTH) {
            let angle = |lane: usize| bodies.get(lane).map_or(0.0, |(_, number)| tree[*number].value());
            let angles = SimdVector::of(|lane| angle(lane) * per_length);
            let (cos, sin) = widest(
                #[inline(always)]
                || (angles.cos(), angles.sin()),
            );
            for (lane, (body, _)) in bodies.iter().enumerate() {
                let direction = [S::from(cos.0[lane]), S::from(sin.0[lane])];
                poses[*body].turn(S::from(angles.0[lane]), direction);
            }
        }
    }

    /// Residuals and Jacobian from the poses.
    #[inline(always)]
    fn constrain<S: SimdReal>(&self, position: &mut Position<S>) {
        let per_length = 1.0 / self.length;
        for (index, kernel) in self.kernels.iter().enumerate() {
            match kernel {
                Kernel::Pin { row, points: [a, b], bodies, places: [x, y], is_loop } => {
                    if *is_loop {
                        let (pa, pb) = (&position.poses[bodies[0]], &position.poses[bodies[1]]);
                        let ([ax, ay], [bx, by]) = (pa.turned(a.at), pb.turned(b.at));
                        position.arms[index] = [ax, ay, bx, by];
                        position.residuals[*row] = pb.x + bx - pa.x - ax;
                        position.residuals[row + 1] = pb.y + by - pa.y - ay;
                    }
                    let [ax, ay, bx, by] = position.arms[index];
                    position.jacobian[x[0]] = ay * per_length;
                    position.jacobian[x[1]] = -by * per_length;
                    position.jacobian[y[0]] = -ax * per_length;
                    position.jacobian[y[1]] = bx * per_length;
                }
                // An explicit equation holds, and its entries are constant.
                Kernel::General { is_constant: true, is_loop: false, .. } => {}
                Kernel::General { row, terms, .. } => {
                    for place in terms.iter().flat_map(|(_, places)| places.iter().flatten()) {
                        position.jacobian[*place] = S::from(0.0);
                    }
                    let mut left = S::from(0.0);
                    for (term, places) in terms {
                        let gradient = gradient(&term.measure, &position.poses);
                        let (value, rate) = match &term.function {
                            Some(function) => (
                                gradient.value.each(|x| function.at(x)[0]),
                                gradient.value.each(|x| function.at(x)[1]),
                            ),
                            None => (gradient.value, S::from(1.0)),
                        };
                        left = left + value * term.weight;
                        let factor = rate * term.weight;
                        for (places, part) in places.iter().zip([gradient.from, gradient.to]) {
                            let turn = part[2] * per_length;
                            for (place, part) in places.iter().zip([part[0], part[1], turn]) {
                                position.jacobian[*place] = position.jacobian[*place] + factor * part;
                            }
                        }
                    }
                    position.residuals[*row] = left - position.constants[*row];
                }
            }
        }
    }

    /// The quadratic velocity terms `γ` of `Φ_q q̈ = γ`, by row: minus the accelerations of the left sides when no body
    /// accelerates. The velocities are those of the bodies and, last, of the ground.
    #[inline(always)]
    pub(super) fn quadratic_velocity_terms<S: SimdReal>(
        &self,
        position: &Position<S>,
        velocities: &[[S; 3]],
        terms_by_row: &mut [S],
    ) {
        for (index, kernel) in self.kernels.iter().enumerate() {
            match kernel {
                Kernel::Pin { row, bodies: [a, b], .. } => {
                    let [ax, ay, bx, by] = position.arms[index];
                    let (wa, wb) = (velocities[*a][2], velocities[*b][2]);
                    let (wa, wb) = (wa * wa, wb * wb);
                    terms_by_row[*row] = bx * wb - ax * wa;
                    terms_by_row[row + 1] = by * wb - ay * wa;
                }
                Kernel::General { row, is_constant: true, .. } => terms_by_row[*row] = S::from(0.0),
                Kernel::General { row, terms, .. } => {
                    let of_term = |(term, _): &(ConstraintTerm, _)| {
                        let poses = pair(&term.measure, &position.poses);
                        let [from, to] = term.measure.bodies();
                        let velocity = |frame: BodyFrame| velocities[frame.unwrap_or(self.bodies)];
                        let bias = term.measure.bias(poses, [velocity(from), velocity(to)]);
                        let Some(function) = &term.function else { return bias * term.weight };
                        let gradient = term.measure.gradient(poses);
                        let rate = rate(&term.measure, &gradient, velocities);
                        let [first, second] =
                            [1, 2].map(|n: usize| gradient.value.each(|x| function.at(x)[n]));
                        (first * bias + second * rate * rate) * term.weight
                    };
                    terms_by_row[*row] = -S::sum(terms.iter().map(of_term));
                }
            }
        }
    }

    /// The largest residual of the loop equations, m: each over the largest entry of its row, of the constant ones
    /// where there are such; not a number where a residual is not.
    #[inline(always)]
    pub(super) fn largest_residual<S: SimdReal>(&self, position: &Position<S>) -> S {
        let mut largest = S::from(0.0);
        for (&row, &scale) in self.loops.iter().zip(&self.loop_scales) {
            let mut residual = position.residuals[row].abs();
            if scale > 0.0 {
                residual = residual * (1.0 / scale);
            } else {
                let mut most = S::from(0.0);
                for (_, place) in &self.rows[row] {
                    most = most.with(position.jacobian[*place].abs(), f64::max);
                }
                residual =
                    residual.with(
                        most,
                        |residual, most| if most > 0.0 || residual.is_nan() { residual / most } else { 0.0 },
                    );
            }
            largest = largest.with(residual, |largest, residual| {
                if residual > largest || residual.is_nan() { residual } else { largest }
            });
        }
        largest
    }

    /// Sets the scaled coordinate of a column.
    #[inline(always)]
    fn set_column<S: SimdReal>(&self, column: usize, value: S, position: &mut Position<S>) {
        let pose = &mut position.poses[column / 3];
        match column % 3 {
            0 => pose.x = value,
            1 => pose.y = value,
            _ => *pose = Pose::new([pose.x, pose.y, value / self.length]),
        }
    }
}

/// The value of a term, its weight included.
#[inline(always)]
fn value<S: SimdReal>(term: &ConstraintTerm, poses: &[Pose<S>]) -> S {
    let value = gradient(&term.measure, poses).value;
    term.function.as_ref().map_or(value, |function| value.each(|x| function.at(x)[0])) * term.weight
}
