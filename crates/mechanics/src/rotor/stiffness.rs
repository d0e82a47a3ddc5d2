//! The dynamic stiffness `D(λ) = λ²M + λ(C + ΩG) + K` of a rotor at a speed, factorised node by node.

use std::array::from_fn;

use nalgebra::{Complex, Matrix2};

use super::{Assembled, Coefficients, Plane, assembled::Bending};
use dalembert_numerics::linalg::ComplexBand;

type C = Complex<f64>;
/// The degrees of freedom of a node: deflection and slope in one plane, then in the other.
pub(super) type Node = [C; 4];
type Block = [[C; 4]; 4];

const ZERO: C = Complex::new(0.0, 0.0);

/// A linear combination of the matrices of a rotor at a speed.
#[derive(Clone, Copy)]
pub(super) struct Stiffness<'a> {
    rotor: &'a Assembled,
    powers: Powers,
    speed: f64,
    transposed: bool,
}

/// The same as blocks, a row of them for each node.
struct Blocks {
    diagonal: Vec<Block>,
    above: Vec<Block>,
    below: Vec<Block>,
}

/// Factors of the dynamic stiffness matrix.
struct Factors {
    pivots: Vec<Lu>,
    carried: Vec<Block>,
    below: Vec<Block>,
}

/// Coefficients of the matrices of a rotor: `λ²`, `λ` and `1`, or others.
#[derive(Clone, Copy)]
pub(super) struct Powers {
    pub(super) mass: C,
    pub(super) damping: C,
    pub(super) stiffness: C,
}

/// The most corrections of a solution.
const CORRECTIONS: usize = 12;

/// A correction below this share of the solution is rounding.
const SETTLED: f64 = 1e-13;

/// A solution whose last correction is not below this share is none.
const LOST: f64 = 1e-9;

impl<'a> Stiffness<'a> {
    pub(super) fn new(rotor: &'a Assembled, lambda: C, speed: f64) -> Self {
        let one = Complex::new(1.0, 0.0);
        Self::of(rotor, Powers { mass: lambda * lambda, damping: lambda, stiffness: one }, speed)
    }

    /// `a M + b (C + ΩG) + c K`.
    pub(super) fn of(rotor: &'a Assembled, powers: Powers, speed: f64) -> Self {
        Self { rotor, powers, speed, transposed: false }
    }

    /// Rows become columns.
    pub(super) fn transposed(self) -> Self {
        Self { transposed: !self.transposed, ..self }
    }

    /// Times a motion in which fixed degrees of freedom are at rest. The shaft acts through its deformations, so that a soft motion
    /// of a fine mesh keeps its digits.
    pub(super) fn times(&self, x: &[Node]) -> Vec<Node> {
        let Self { rotor, powers, speed, .. } = *self;
        let sign = if self.transposed { -1.0 } else { 1.0 };
        let plane =
            |p: usize| -> Vec<C> { x.iter().flat_map(|node| [node[2 * p], node[2 * p + 1]]).collect() };
        let planes = [plane(0), plane(1)];
        let mut sums = [vec![ZERO; 2 * x.len()], vec![ZERO; 2 * x.len()]];
        for p in 0..2 {
            let own = &planes[p];
            let mut add = |to: usize, image: Vec<C>, factor: C| {
                sums[to].iter_mut().zip(image).for_each(|(sum, part)| *sum += part * factor);
            };
            add(p, rotor.mass.product(own, ZERO), powers.mass);
            let direct = |element: &Bending, force: C| {
                force * (powers.stiffness * element.direct + powers.damping * element.viscous)
            };
            let one = Complex::new(1.0, 0.0);
            add(p, rotor.bent(own, ZERO, direct), one);
            if let Some(tension) = &rotor.tension {
                add(p, tension.product(own, ZERO), powers.stiffness);
            }
            // Of x on y and, with the other sign, of y on x.
            let turn = if p == 0 { -sign } else { sign };
            add(1 - p, rotor.gyroscopic.product(own, ZERO), powers.damping * (speed * turn));
            if rotor.internal {
                let cross = |element: &Bending, force: C| {
                    force * (powers.stiffness * (speed * element.viscous + element.hysteretic))
                };
                add(1 - p, rotor.bent(own, ZERO, cross), one * turn);
            }
        }
        let mut image: Vec<Node> = (0..x.len())
            .map(|n| [sums[0][2 * n], sums[0][2 * n + 1], sums[1][2 * n], sums[1][2 * n + 1]])
            .collect();
        for (node, here) in rotor.bearings(speed) {
            let [[xx, xy], [yx, yy]] = self.bearing(here);
            image[node][0] += xx * x[node][0] + xy * x[node][2];
            image[node][2] += yx * x[node][0] + yy * x[node][2];
        }
        image
    }

    fn bearing(&self, Coefficients { stiffness, damping }: Coefficients) -> [[C; 2]; 2] {
        from_fn(|i| {
            from_fn(|j| {
                let (row, column) = if self.transposed { (j, i) } else { (i, j) };
                self.powers.stiffness * stiffness[row][column] + self.powers.damping * damping[row][column]
            })
        })
    }

    /// The solution of `D x = b`, corrected until what [`times`](Self::times) leaves of `b` is rounding. Elimination
    /// goes node by node; where that meets a poor pivot, rows are exchanged among nodes. `None` where `D` is singular.
    pub(super) fn solve(&self, right: &[Node]) -> Option<Vec<Node>> {
        self.solver().solve(right)
    }

    /// Ready for several right sides.
    pub(super) fn solver(&self) -> Solver<'a> {
        let blocks = self.blocks();
        Solver { of: *self, factors: blocks.factors(), blocks }
    }

    fn blocks(&self) -> Blocks {
        let Self { rotor, powers, speed, .. } = *self;
        let sign = if self.transposed { -1.0 } else { 1.0 };
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
                    block[i][j + 2] = cross * sign;
                    block[i + 2][j] = -cross * sign;
                }
            }
            block
        };
        let mut diagonal: Vec<Block> =
            (0..rotor.nodes()).map(|n| block(&|plane: &Plane| plane.diagonal[n])).collect();
        for (node, here) in rotor.bearings(speed) {
            let bearing = self.bearing(here);
            for i in 0..2 {
                for j in 0..2 {
                    diagonal[node][2 * i][2 * j] += bearing[i][j];
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
        Blocks { diagonal, above, below }
    }

    /// The largest term of each row of a product, for one degree of freedom of the nodes.
    pub(super) fn row_sizes(&self, x: &[Node], freedom: usize) -> Vec<f64> {
        let largest = |block: &Block, x: &Node| {
            block[freedom].iter().zip(x).map(|(a, x)| (a * x).norm()).fold(0.0, f64::max)
        };
        let Blocks { diagonal, above, below } = self.blocks();
        (0..x.len())
            .map(|n| {
                let mut size = largest(&diagonal[n], &x[n]);
                if n > 0 {
                    size = size.max(largest(&below[n - 1], &x[n - 1]));
                }
                if n + 1 < x.len() {
                    size = size.max(largest(&above[n], &x[n + 1]));
                }
                size
            })
            .collect()
    }
}

impl Blocks {
    /// Factors without exchange of nodes; `None` where a pivot is exactly singular.
    fn factors(&self) -> Option<Factors> {
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
        Some(Factors { pivots, carried, below: self.below.clone() })
    }
}

/// A matrix that is ready to be solved.
pub(super) struct Solver<'a> {
    of: Stiffness<'a>,
    blocks: Blocks,
    factors: Option<Factors>,
}

impl Solver<'_> {
    pub(super) fn solve(&self, right: &[Node]) -> Option<Vec<Node>> {
        if self.size(right) == 0.0 {
            return Some(right.to_vec());
        }
        let quick = |right: &[Node]| Some(self.factors.as_ref()?.solve(right));
        self.corrected(right, quick).or_else(|| self.corrected(right, |right| self.with_exchange(right)))
    }

    fn corrected(&self, right: &[Node], solve: impl Fn(&[Node]) -> Option<Vec<Node>>) -> Option<Vec<Node>> {
        let mut x = solve(right)?;
        let mut last = f64::INFINITY;
        for _ in 0..CORRECTIONS {
            let mut left = self.of.times(&x);
            for (left, right) in left.iter_mut().flatten().zip(right.iter().flatten()) {
                *left = right - *left;
            }
            let change = solve(&left)?;
            let size = self.size(&change) / self.size(&x);
            // Also where it is not a number.
            let shrinks = size < 0.5 * last;
            if !shrinks {
                break;
            }
            for (x, change) in x.iter_mut().flatten().zip(change.iter().flatten()) {
                *x += change;
            }
            last = size;
            if size < SETTLED {
                break;
            }
        }
        (last < LOST).then_some(x)
    }

    /// The largest deflection, slopes times the mean length of an element among them.
    fn size(&self, x: &[Node]) -> f64 {
        let unit = self.unit();
        let of = |node: &Node| {
            node[0].norm().max(node[2].norm()).max(unit * node[1].norm()).max(unit * node[3].norm())
        };
        x.iter().map(of).fold(0.0, f64::max)
    }

    fn unit(&self) -> f64 {
        let positions = &self.of.rotor.positions;
        positions.last().map_or(1.0, |length| length / positions.len() as f64)
    }

    /// By elimination with exchange of rows, in rotations times the length of an element.
    fn with_exchange(&self, right: &[Node]) -> Option<Vec<Node>> {
        let unit = self.unit();
        let scale = [1.0, 1.0 / unit, 1.0, 1.0 / unit];
        let mut band = ComplexBand::zeros(4 * right.len(), 7, 7).ok()?;
        let mut put = |row: usize, column: usize, block: &Block| {
            for i in 0..4 {
                for j in 0..4 {
                    band.add(4 * row + i, 4 * column + j, block[i][j] * (scale[i] * scale[j]));
                }
            }
        };
        for (n, block) in self.blocks.diagonal.iter().enumerate() {
            put(n, n, block);
        }
        for (n, (above, below)) in self.blocks.above.iter().zip(&self.blocks.below).enumerate() {
            put(n, n + 1, above);
            put(n + 1, n, below);
        }
        let scaled =
            |x: &[Node]| -> Vec<Node> { x.iter().map(|node| from_fn(|i| node[i] * scale[i])).collect() };
        let mut x: Vec<C> = scaled(right).into_iter().flatten().collect();
        band.solve(&mut x).ok()?;
        let nodes: Vec<Node> = x.chunks_exact(4).map(|node| from_fn(|i| node[i])).collect();
        Some(scaled(&nodes))
    }
}

impl Factors {
    fn solve(&self, right: &[Node]) -> Vec<Node> {
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
