//! The dynamic stiffness `D(λ) = λ²M + λ(C + ΩG) + K` of a rotor at a speed, factorised node by node.

use std::array::from_fn;

use nalgebra::{Complex, Matrix2};

use super::{Assembled, Coefficients, Plane};

type C = Complex<f64>;
/// The freedoms of a node: deflection and slope in one plane, then in the other.
pub(super) type Node = [C; 4];
type Block = [[C; 4]; 4];

const ZERO: C = Complex::new(0.0, 0.0);

/// The dynamic stiffness at one `λ` and one speed.
pub(super) struct Stiffness {
    diagonal: Vec<Block>,
    above: Vec<Block>,
    below: Vec<Block>,
}

/// Its factors.
pub(super) struct Factors {
    pivots: Vec<Lu>,
    carried: Vec<Block>,
    below: Vec<Block>,
}

/// What stands before the matrices of a rotor: `λ²`, `λ`, and `1`, or their derivatives by `λ`.
#[derive(Clone, Copy)]
struct Powers {
    mass: C,
    damping: C,
    stiffness: C,
}

impl Stiffness {
    pub(super) fn new(rotor: &Assembled, lambda: C, speed: f64) -> Self {
        Self::of(
            rotor,
            Powers { mass: lambda * lambda, damping: lambda, stiffness: Complex::new(1.0, 0.0) },
            speed,
        )
    }

    /// `D′(λ) = 2λM + C + ΩG`.
    pub(super) fn derivative(rotor: &Assembled, lambda: C, speed: f64) -> Self {
        Self::of(
            rotor,
            Powers { mass: lambda * 2.0, damping: Complex::new(1.0, 0.0), stiffness: ZERO },
            speed,
        )
    }

    fn of(rotor: &Assembled, powers: Powers, speed: f64) -> Self {
        let block = |pick: &dyn Fn(&Plane) -> Matrix2<f64>| -> Block {
            let (mass, gyroscopic, stiffness) =
                (pick(&rotor.mass), pick(&rotor.gyroscopic), pick(&rotor.stiffness));
            let (viscous, hysteretic) = if rotor.internal {
                (pick(&rotor.viscous), pick(&rotor.hysteretic))
            } else {
                (Matrix2::zeros(), Matrix2::zeros())
            };
            let mut block = [[ZERO; 4]; 4];
            for i in 0..2 {
                for j in 0..2 {
                    let direct = powers.mass * mass[(i, j)]
                        + powers.damping * viscous[(i, j)]
                        + powers.stiffness * stiffness[(i, j)];
                    let cross = powers.damping * (speed * gyroscopic[(i, j)])
                        + powers.stiffness * (speed * viscous[(i, j)] + hysteretic[(i, j)]);
                    block[i][j] = direct;
                    block[i + 2][j + 2] = direct;
                    block[i][j + 2] = cross;
                    block[i + 2][j] = -cross;
                }
            }
            block
        };
        let mut diagonal: Vec<Block> =
            (0..rotor.nodes()).map(|n| block(&|plane: &Plane| plane.diagonal[n])).collect();
        for (node, Coefficients { stiffness, damping }) in rotor.bearings(speed) {
            for i in 0..2 {
                for j in 0..2 {
                    diagonal[node][2 * i][2 * j] +=
                        powers.stiffness * stiffness[i][j] + powers.damping * damping[i][j];
                }
            }
        }
        let above: Vec<Block> =
            (0..rotor.nodes() - 1).map(|n| block(&|plane: &Plane| plane.above[n])).collect();
        // Below the diagonal each of the four parts of a block is transposed for itself.
        let below = above
            .iter()
            .map(|above| from_fn(|i| from_fn(|j| above[2 * (i / 2) + j % 2][2 * (j / 2) + i % 2])))
            .collect();
        Self { diagonal, above, below }
    }

    pub(super) fn times(&self, x: &[Node]) -> Vec<Node> {
        (0..x.len())
            .map(|n| {
                let mut sum = product(&self.diagonal[n], &x[n]);
                if n > 0 {
                    add(&mut sum, &product(&self.below[n - 1], &x[n - 1]));
                }
                if n + 1 < x.len() {
                    add(&mut sum, &product(&self.above[n], &x[n + 1]));
                }
                sum
            })
            .collect()
    }

    /// The largest term of each row of a product, for one freedom of the nodes.
    pub(super) fn row_sizes(&self, x: &[Node], freedom: usize) -> Vec<f64> {
        let largest = |block: &Block, x: &Node| {
            block[freedom].iter().zip(x).map(|(a, x)| (a * x).norm()).fold(0.0, f64::max)
        };
        (0..x.len())
            .map(|n| {
                let mut size = largest(&self.diagonal[n], &x[n]);
                if n > 0 {
                    size = size.max(largest(&self.below[n - 1], &x[n - 1]));
                }
                if n + 1 < x.len() {
                    size = size.max(largest(&self.above[n], &x[n + 1]));
                }
                size
            })
            .collect()
    }

    /// Factors without exchange of nodes; `None` where a pivot is exactly singular.
    pub(super) fn factors(self) -> Option<Factors> {
        let nodes = self.diagonal.len();
        let mut pivots = Vec::with_capacity(nodes);
        let mut carried: Vec<Block> = Vec::with_capacity(nodes - 1);
        for n in 0..nodes {
            let mut pivot = self.diagonal[n];
            if n > 0 {
                subtract_product(&mut pivot, &self.below[n - 1], &carried[n - 1]);
            }
            let pivot = Lu::new(pivot)?;
            if let Some(above) = self.above.get(n) {
                let mut columns = *above;
                pivot.solve(&mut columns);
                carried.push(columns);
            }
            pivots.push(pivot);
        }
        Some(Factors { pivots, carried, below: self.below })
    }
}

impl Factors {
    pub(super) fn solve(&self, right: &[Node]) -> Vec<Node> {
        let mut x: Vec<Node> = Vec::with_capacity(right.len());
        for (n, right) in right.iter().enumerate() {
            let mut here = *right;
            if n > 0 {
                let before = product(&self.below[n - 1], &x[n - 1]);
                for (a, b) in here.iter_mut().zip(before) {
                    *a -= b;
                }
            }
            let mut column = here.map(|x| [x]);
            self.pivots[n].solve(&mut column);
            x.push(column.map(|[x]| x));
        }
        for n in (0..x.len() - 1).rev() {
            let after = product(&self.carried[n], &x[n + 1]);
            for (a, b) in x[n].iter_mut().zip(after) {
                *a -= b;
            }
        }
        x
    }
}

/// Triangular factors of a block with exchange of rows.
struct Lu {
    factors: Block,
    order: [usize; 4],
    inverse: [C; 4],
}

impl Lu {
    fn new(mut a: Block) -> Option<Self> {
        let mut order = [0, 1, 2, 3];
        let mut inverse = [ZERO; 4];
        // Rows are compared by their share of their own largest entry: deflections and slopes differ in unit.
        let mut sizes = a.map(|row| row.iter().map(C::norm_sqr).fold(0.0, f64::max));
        for k in 0..4 {
            let share = |i: usize| a[i][k].norm_sqr() / sizes[i].max(f64::MIN_POSITIVE);
            let best = (k..4).max_by(|&i, &j| share(i).total_cmp(&share(j)))?;
            a.swap(k, best);
            order.swap(k, best);
            sizes.swap(k, best);
            if a[k][k].norm_sqr() == 0.0 || !a[k][k].re.is_finite() || !a[k][k].im.is_finite() {
                return None;
            }
            inverse[k] = a[k][k].inv();
            let pivot = a[k];
            for row in a.iter_mut().skip(k + 1) {
                let factor = row[k] * inverse[k];
                row[k] = factor;
                for j in k + 1..4 {
                    row[j] -= factor * pivot[j];
                }
            }
        }
        Some(Self { factors: a, order, inverse })
    }

    fn solve<const N: usize>(&self, columns: &mut [[C; N]; 4]) {
        let mut x = self.order.map(|row| columns[row]);
        for i in 1..4 {
            for j in 0..i {
                let (factor, before) = (self.factors[i][j], x[j]);
                for (a, b) in x[i].iter_mut().zip(before) {
                    *a -= factor * b;
                }
            }
        }
        for i in (0..4).rev() {
            for j in i + 1..4 {
                let (factor, after) = (self.factors[i][j], x[j]);
                for (a, b) in x[i].iter_mut().zip(after) {
                    *a -= factor * b;
                }
            }
            for a in &mut x[i] {
                *a *= self.inverse[i];
            }
        }
        *columns = x;
    }
}

fn product(a: &Block, x: &Node) -> Node {
    a.map(|row| row[0] * x[0] + row[1] * x[1] + row[2] * x[2] + row[3] * x[3])
}

fn add(a: &mut Node, b: &Node) {
    for (a, b) in a.iter_mut().zip(b) {
        *a += b;
    }
}

/// `a −= b c`
fn subtract_product(a: &mut Block, b: &Block, c: &Block) {
    for (row, left) in a.iter_mut().zip(b) {
        for (factor, right) in left.iter().zip(c) {
            for (a, c) in row.iter_mut().zip(right) {
                *a -= factor * c;
            }
        }
    }
}
