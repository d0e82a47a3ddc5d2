//! Networks of springs and dampers along one line: nodes with masses, elements between them or to fixed ground.
//!
//! Stiffnesses in N/m, damping in N·s/m, masses in kg, frequencies in rad/s, forces in N.

use nalgebra::{Complex, DMatrix, DVector};

use dalembert_numerics::linalg::{self, LinalgError};

/// Reason for which a network has no answer.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum NetworkError {
    /// A node, counted from 0, is held by nothing, directly or through others.
    #[error("node {node} is held by nothing that resists this motion")]
    Loose {
        /// The node.
        node: usize,
    },
    /// The linear system has no answer within the range of numbers.
    #[error(transparent)]
    Linear(#[from] LinalgError),
}

/// A spring and a damper side by side between two nodes, counted from 0; `None` is fixed ground.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpringDamper {
    /// The nodes.
    pub ends: [Option<usize>; 2],
    /// Stiffness, N/m; zero for a damper alone.
    pub stiffness: f64,
    /// Damping, N·s/m; zero for a spring alone.
    pub damping: f64,
}

/// Nodes, their masses and the elements between them.
#[derive(Debug, Clone, PartialEq)]
pub struct Network {
    /// The mass of each node, kg; zero for a light one.
    pub masses: Vec<f64>,
    /// The elements.
    pub links: Vec<SpringDamper>,
}

impl Network {
    /// The displacements of the nodes under constant forces, N, one for each node, held by the springs alone, m.
    ///
    /// # Errors
    /// `Loose` where a node is not joined to ground by springs; `Linear`.
    pub fn at_rest(&self, forces: &[f64]) -> Result<Vec<f64>, NetworkError> {
        self.held_by(|link| link.stiffness > 0.0)?;
        let matrix = self.assembled(|link| link.stiffness);
        Ok(linalg::solve(&matrix, &DVector::from_column_slice(forces))?.x.as_slice().to_vec())
    }

    /// The complex amplitudes under forces `F cos ωt`, m; the masses count.
    ///
    /// # Errors
    /// `Loose` where a node is joined to ground neither by springs nor by dampers and has no mass; `Linear`, among
    /// them a singular matrix at an undamped resonance.
    pub fn harmonic_response(
        &self,
        forces: &[f64],
        frequency: f64,
    ) -> Result<Vec<Complex<f64>>, NetworkError> {
        let damping = self.assembled(|link| link.damping * frequency);
        let mut matrix = self.assembled(|link| link.stiffness).zip_map(&damping, Complex::new);
        for (node, mass) in self.masses.iter().enumerate() {
            matrix[(node, node)] -= mass * frequency.powi(2);
        }
        let right = DMatrix::from_iterator(forces.len(), 1, forces.iter().map(|force| Complex::from(*force)));
        Ok(linalg::solve_complex(&matrix, &right)?.as_slice().to_vec())
    }

    /// Driving-point stiffness of a node, with the other nodes free and `of` giving the stiffness of an element (real,
    /// or complex `k + iωc`): the other nodes are eliminated one by one, each leaving `kᵢkⱼ/Σk` between its neighbours
    /// (star–mesh transformation). No subtraction occurs, so nothing cancels.
    pub fn driving_point_stiffness(
        &self,
        node: usize,
        of: impl Fn(&SpringDamper) -> Complex<f64>,
    ) -> Complex<f64> {
        let n = self.masses.len();
        // Ground is the last node.
        let mut between = DMatrix::<Complex<f64>>::zeros(n + 1, n + 1);
        for link in &self.links {
            let [a, b] = link.ends.map(|end| end.unwrap_or(n));
            if a != b {
                between[(a, b)] += of(link);
                between[(b, a)] += of(link);
            }
        }
        for gone in (0..n).filter(|gone| *gone != node) {
            let sum: Complex<f64> = (0..=n).map(|other| between[(gone, other)]).sum();
            if sum == Complex::ZERO {
                continue;
            }
            for a in 0..=n {
                for b in (0..=n).filter(|b| *b != a) {
                    let through = between[(gone, a)] * (between[(gone, b)] / sum);
                    between[(a, b)] += through;
                }
            }
            for other in 0..=n {
                between[(gone, other)] = Complex::ZERO;
                between[(other, gone)] = Complex::ZERO;
            }
        }
        between[(node, n)]
    }

    /// The finite roots `s` of `det(M s² + C s + K) = 0`, ascending by real part and then by imaginary part: the
    /// network moves by itself as `e^(st)`. Light nodes only raise the degree through their dampers.
    ///
    /// With `s = σ + 1/µ` and `A = K + σC + σ²M` the problem is `µ² A x + µ (C + 2σM) x + M x = 0`, whose companion
    /// needs no inverse of `M`; infinite roots are at `µ = 0`.
    ///
    /// # Errors
    /// `Loose` where a node has neither mass nor anything that holds it; `Linear`.
    pub fn roots(&self) -> Result<Vec<Complex<f64>>, NetworkError> {
        self.held_by(|link| link.stiffness > 0.0 || link.damping > 0.0)?;
        let n = self.masses.len();
        let stiffness = self.assembled(|link| link.stiffness);
        let damping = self.assembled(|link| link.damping);
        let masses = DMatrix::from_diagonal(&DVector::from_column_slice(&self.masses));
        let shift = self.scale();
        let shifted = &stiffness + &damping * shift + &masses * shift.powi(2);
        let complex = |matrix: &DMatrix<f64>| matrix.map(Complex::from);
        let factors = linalg::ComplexLu::new(&complex(&shifted))?;
        let inverse_times = |right: &DMatrix<f64>| -> Result<DMatrix<f64>, LinalgError> {
            Ok(factors.solve(&complex(right))?.map(|entry| entry.re))
        };
        // µ in units of 1/σ: both blocks of the companion are pure numbers.
        let first = inverse_times(&((&damping + &masses * (2.0 * shift)) * shift))?;
        let second = inverse_times(&(&masses * shift.powi(2)))?;
        let mut companion = DMatrix::zeros(2 * n, 2 * n);
        companion.view_mut((0, 0), (n, n)).copy_from(&-first);
        companion.view_mut((0, n), (n, n)).copy_from(&-second);
        companion.view_mut((n, 0), (n, n)).fill_with_identity();
        let count = self.degree();
        let mut values = linalg::complex_eigenvalues(&companion)?;
        values.sort_by(|p, q| q.norm().total_cmp(&p.norm()));
        let mut roots: Vec<Complex<f64>> =
            values.into_iter().take(count).map(|value| (Complex::from(1.0) + value.inv()) * shift).collect();
        roots.retain(|root| root.re.is_finite() && root.im.is_finite());
        roots.sort_by(|p, q| p.re.total_cmp(&q.re).then(p.im.total_cmp(&q.im)));
        Ok(roots)
    }

    /// The number of finite roots: the degree of the determinant, two for each mass and one for each way in which
    /// the light nodes are joined by dampers.
    fn degree(&self) -> usize {
        // Light nodes in groups joined by dampers; a group counts once for each node unless it floats, where one less.
        let n = self.masses.len();
        let heavy = self.masses.iter().filter(|mass| **mass > 0.0).count();
        let mut group: Vec<usize> = (0..n).collect();
        let fixed = |end: Option<usize>| end.is_none_or(|node| self.masses[node] > 0.0);
        for _ in 0..n {
            for link in self.links.iter().filter(|link| link.damping > 0.0) {
                if let [Some(a), Some(b)] = link.ends
                    && !fixed(link.ends[0])
                    && !fixed(link.ends[1])
                {
                    let low = group[a].min(group[b]);
                    group[a] = low;
                    group[b] = low;
                }
            }
        }
        let light = (0..n).filter(|node| self.masses[*node] == 0.0);
        let grounded = |of: usize| {
            self.links.iter().filter(|link| link.damping > 0.0).any(|link| {
                let inside = |end: Option<usize>| end.is_some_and(|node| !fixed(end) && group[node] == of);
                inside(link.ends[0]) && fixed(link.ends[1]) || inside(link.ends[1]) && fixed(link.ends[0])
            })
        };
        let damped: usize =
            light.clone().map(|node| usize::from(group[node] != node || grounded(node))).sum();
        2 * heavy + damped
    }

    /// A typical rate of the network, 1/s.
    fn scale(&self) -> f64 {
        let sum = |of: fn(&SpringDamper) -> f64| self.links.iter().map(of).sum::<f64>();
        let (stiffness, damping) = (sum(|link| link.stiffness), sum(|link| link.damping));
        let mass: f64 = self.masses.iter().sum();
        let scale = match (mass > 0.0, stiffness > 0.0) {
            (true, true) => (stiffness / mass).sqrt(),
            (true, false) => damping / mass,
            (false, _) => stiffness / damping,
        };
        if scale.is_finite() && scale > 0.0 { scale } else { 1.0 }
    }

    fn assembled(&self, of: impl Fn(&SpringDamper) -> f64) -> DMatrix<f64> {
        let n = self.masses.len();
        let mut matrix = DMatrix::zeros(n, n);
        for link in &self.links {
            let value = of(link);
            for end in link.ends.into_iter().flatten() {
                matrix[(end, end)] += value;
            }
            if let [Some(a), Some(b)] = link.ends {
                matrix[(a, b)] -= value;
                matrix[(b, a)] -= value;
            }
        }
        matrix
    }

    fn held_by(&self, counts: impl Fn(&SpringDamper) -> bool) -> Result<(), NetworkError> {
        let mut held = vec![false; self.masses.len()];
        for _ in 0..self.masses.len() {
            for link in self.links.iter().filter(|link| counts(link)) {
                let fixed = |end: Option<usize>| end.is_none_or(|node| held[node]);
                if fixed(link.ends[0]) || fixed(link.ends[1]) {
                    for end in link.ends.into_iter().flatten() {
                        held[end] = true;
                    }
                }
            }
        }
        match held.iter().position(|held| !held) {
            None => Ok(()),
            Some(node) => Err(NetworkError::Loose { node }),
        }
    }
}
