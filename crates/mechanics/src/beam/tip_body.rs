//! Free vibration of a uniform cantilever with a rigid body at its tip: bending in two planes, stretching and
//! torsion, coupled by what of the body stands beside the axis.
//!
//! The beam lies along `x` from the clamp to the tip; the motion of the tip is `(u_x, u_y, u_z, θ_x, θ_y, θ_z)`. Its
//! dynamic stiffness is exact, and the frequencies below a trial one are counted as in
//! [`dynamic_stiffness`](super::dynamic_stiffness). SI throughout.

use std::f64::consts::PI;

use nalgebra::{DMatrix, Matrix3, Matrix6, Vector3, Vector6};

use super::dynamic_stiffness::{Beam, BeamError, BeamStation};
use dalembert_numerics::linalg;

/// A cantilever.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cantilever {
    /// Length, m.
    pub length: f64,
    /// Mass of each length, kg/m.
    pub line_mass: f64,
    /// Stiffness along the axis `EA`, N.
    pub axial: f64,
    /// Torsional stiffness `GJ`, N·m².
    pub torsion: f64,
    /// Moment of inertia of each length about the axis `ρ I_p`, kg·m.
    pub polar: f64,
    /// Bending in the planes `xy` and `xz`.
    pub bending: [Bending; 2],
}

/// Bending in one plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bending {
    /// `EI`, N·m².
    pub stiffness: f64,
    /// Shear flexibility `EI/(κ G A L²)`; zero for Euler–Bernoulli.
    pub shear: f64,
    /// Rotary inertia `I/(A L²)`; zero for Euler–Bernoulli.
    pub rotary: f64,
}

/// A point of the body: its mass, kg, and where it stands from the tip, m.
pub type PointMass = (f64, Vector3<f64>);

/// A vibration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BeamMode {
    /// Frequency, rad/s.
    pub frequency: f64,
    /// Motion of the tip, rotations times the length, the largest one.
    pub tip: Vector6<f64>,
    /// Residual of the force balance at the tip, over the magnitude of the stiffness.
    pub residual: f64,
}

impl Cantilever {
    /// The first `count` vibrations.
    ///
    /// # Errors
    /// `OutOfRange` for data that are not positive and finite; others of [`BeamError`].
    pub fn modes(&self, body: &[PointMass], count: usize) -> Result<Vec<BeamMode>, BeamError> {
        let mass = self.mass_matrix(body)?;
        let unit = (self.bending[0].stiffness.min(self.bending[1].stiffness)
            / (self.line_mass * self.length.powi(4)))
        .sqrt();
        let mut frequencies: Vec<f64> = Vec::with_capacity(count);
        for n in 1..=count {
            let (mut low, mut high) = (frequencies.last().map_or(0.0, |last| last * (1.0 - 1e-11)), unit);
            high = high.max(2.0 * low);
            while self.count(&mass, high)? < n {
                low = high;
                high *= 1.5;
            }
            let mut rounds = 0;
            while high - low > 4.0 * f64::EPSILON * high {
                let middle = if low == 0.0 { high / 8.0 } else { 0.5 * (low + high) };
                rounds += 1;
                if rounds > 500 || middle < 1e-30 * unit {
                    return Err(BeamError::NotConverged);
                }
                if self.count(&mass, middle)? < n { low = middle } else { high = middle }
            }
            frequencies.push(0.5 * (low + high));
        }
        let mut modes = Vec::with_capacity(count);
        for n in 0..count {
            // Frequencies that fall together share their directions.
            let same = |m: &usize| (frequencies[*m] / frequencies[n] - 1.0).abs() < 1e-7;
            let together: Vec<usize> = (0..count).filter(same).collect();
            let shapes = self.shapes(&mass, frequencies[together[0]], together.len())?;
            let (tip, residual) = shapes[n - together[0]];
            modes.push(BeamMode { frequency: frequencies[n], tip, residual });
        }
        Ok(modes)
    }

    /// Frequencies below a trial one.
    fn count(&self, mass: &Matrix6<f64>, frequency: f64) -> Result<usize, BeamError> {
        let (mut stiffness, below) = self.tip(frequency)?;
        stiffness -= mass * frequency.powi(2);
        Ok(below + negatives(stiffness))
    }

    /// Stiffness at the tip, rotations times the length, and the frequencies below the trial one with the tip held.
    fn tip(&self, frequency: f64) -> Result<(Matrix6<f64>, usize), BeamError> {
        let mut stiffness = Matrix6::zeros();
        let mut below = 0;
        let length = self.length;
        let waves = [
            frequency * length * (self.line_mass / self.axial).sqrt(),
            frequency * length * (self.polar / self.torsion).sqrt(),
        ];
        if let Some(wave) = waves.into_iter().find(|wave| wave.is_nan() || *wave >= 1e4) {
            return Err(BeamError::TooSlender(wave));
        }
        let mut wave = |at: usize, whole: f64, beta: f64| {
            stiffness[(at, at)] = whole * if beta == 0.0 { 1.0 } else { beta / beta.tan() };
            below += (beta / PI).floor() as usize;
        };
        wave(0, self.axial / length, waves[0]);
        wave(3, self.torsion / length.powi(3), waves[1]);
        // Turning from y to x is positive about z; turning from z to x is negative about y.
        for (bending, deflection, rotation, sign) in
            [(self.bending[0], 1, 5, 1.0), (self.bending[1], 2, 4, -1.0)]
        {
            let lambda = self.line_mass * frequency.powi(2) * length.powi(4) / bending.stiffness;
            let (tip, held) = bending.beam().tip_stiffness(lambda)?;
            let scaled = tip * (bending.stiffness / length.powi(3));
            stiffness[(deflection, deflection)] = scaled[(0, 0)];
            stiffness[(rotation, rotation)] = scaled[(1, 1)];
            stiffness[(deflection, rotation)] = sign * scaled[(0, 1)];
            stiffness[(rotation, deflection)] = sign * scaled[(0, 1)];
            below += held;
        }
        Ok((stiffness, below))
    }

    /// Residual of the force balance at the tip for this tip motion at a frequency, over the magnitude of the
    /// stiffness.
    ///
    /// # Errors
    /// As for [`Cantilever::modes`].
    pub fn left_over(
        &self,
        body: &[PointMass],
        frequency: f64,
        tip: &Vector6<f64>,
    ) -> Result<f64, BeamError> {
        let inertia = self.mass_matrix(body)? * frequency.powi(2);
        let (stiffness, _) = self.tip(frequency)?;
        let size = stiffness.norm() + inertia.norm();
        Ok(((stiffness - inertia) * tip).norm() / (size * tip.norm()))
    }

    /// The directions of the tip that no force holds, so many of them, and what is left of the forces.
    fn shapes(
        &self,
        mass: &Matrix6<f64>,
        frequency: f64,
        count: usize,
    ) -> Result<Vec<(Vector6<f64>, f64)>, BeamError> {
        let (stiffness, _) = self.tip(frequency)?;
        let whole = stiffness - mass * frequency.powi(2);
        let matrix = DMatrix::from_fn(6, 6, |i, j| whole[(i, j)]);
        let eigen = linalg::symmetric_eigen(&matrix).map_err(|_| BeamError::NotConverged)?;
        let mut order: Vec<usize> = (0..6).collect();
        order.sort_by(|&a, &b| eigen.values[a].abs().total_cmp(&eigen.values[b].abs()));
        let direction = |column: &usize| Vector6::from_fn(|row, _| eigen.vectors[(row, *column)]);
        let mut shapes: Vec<Vector6<f64>> = order.iter().take(count).map(direction).collect();
        part(&mut shapes);
        let size = stiffness.norm() + (mass * frequency.powi(2)).norm();
        let scaled = |shape: Vector6<f64>| {
            let largest = shape.iter().fold(0.0f64, |a, b| if b.abs() > a.abs() { *b } else { a });
            (shape / largest, (whole * shape).norm() / (size * shape.norm()))
        };
        Ok(shapes.into_iter().map(scaled).collect())
    }

    /// `T = ½ Σ m |v + θ × r|²` as a matrix, rotations times the length.
    fn mass_matrix(&self, body: &[PointMass]) -> Result<Matrix6<f64>, BeamError> {
        let positive = |x: f64| x.is_finite() && x > 0.0;
        let beam = [self.length, self.line_mass, self.axial, self.torsion, self.polar];
        let bending = self.bending.map(|bending| bending.stiffness);
        let points = body.iter().all(|(m, r)| positive(*m) && r.iter().all(|x| x.is_finite()));
        if !(points && beam.into_iter().chain(bending).all(positive)) {
            return Err(BeamError::OutOfRange);
        }
        let mut mass = Matrix6::zeros();
        for (m, r) in body {
            let cross = (r / self.length).cross_matrix();
            let mut add = |row: usize, column: usize, block: Matrix3<f64>| {
                let mut view = mass.fixed_view_mut::<3, 3>(row, column);
                view += block * *m;
            };
            add(0, 0, Matrix3::identity());
            add(0, 3, -cross);
            add(3, 0, cross);
            add(3, 3, -cross * cross);
        }
        Ok(mass)
    }
}

impl Bending {
    fn beam(&self) -> Beam {
        let clamp = BeamStation { held: true, clamped: true, ..BeamStation::default() };
        let tip = BeamStation { at: 1.0, ..BeamStation::default() };
        Beam {
            shear: self.shear,
            rotary: self.rotary,
            axial: 0.0,
            foundation: 0.0,
            stations: vec![clamp, tip],
        }
    }
}

/// Of directions that may be mixed at will, those of which each has a motion of its own that the others have not:
/// deflections along y, then along z, before all others.
fn part(shapes: &mut [Vector6<f64>]) {
    let mut done = 0;
    for row in [1, 2, 0, 3, 4, 5] {
        let best =
            (done..shapes.len()).max_by(|&a, &b| shapes[a][row].abs().total_cmp(&shapes[b][row].abs()));
        let Some(best) = best else { return };
        if shapes[best][row].abs() <= 1e-6 * shapes[best].norm() || shapes.len() == 1 {
            continue;
        }
        shapes.swap(done, best);
        let pivot = shapes[done] / shapes[done][row];
        for (n, shape) in shapes.iter_mut().enumerate() {
            let share = shape[row];
            if n != done {
                *shape -= pivot * share;
            }
        }
        done += 1;
    }
}

/// Negative eigenvalues of a symmetric matrix, by its pivots.
fn negatives(mut a: Matrix6<f64>) -> usize {
    let mut count = 0;
    for k in 0..6 {
        // The largest of the pivots that are left keeps the elimination stable where one vanishes.
        let best = (k..6).max_by(|&i, &j| a[(i, i)].abs().total_cmp(&a[(j, j)].abs())).unwrap_or(k);
        a.swap_rows(k, best);
        a.swap_columns(k, best);
        let pivot = a[(k, k)];
        count += usize::from(pivot < 0.0);
        if pivot == 0.0 {
            continue;
        }
        for i in k + 1..6 {
            let multiple = a[(i, k)] / pivot;
            for j in k + 1..6 {
                a[(i, j)] -= multiple * a[(k, j)];
            }
        }
    }
    count
}
