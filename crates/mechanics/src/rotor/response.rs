//! The steady response of a rotor to its unbalance.

use nalgebra::Complex;

use super::{
    Assembled, Coefficients, RotorError,
    stiffness::{Node, Stiffness},
};

/// An unbalance at a node: mass times eccentricity, and its angle from `x` in the turning shaft.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unbalance {
    /// The node.
    pub node: usize,
    /// Mass times eccentricity, kg·m.
    pub size: f64,
    /// Angle, rad.
    pub angle: f64,
}

/// The ellipse `x = Re(X e^{iωt})`, `y = Re(Y e^{iωt})`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Orbit {
    /// Half of the long axis: the largest deflection, zero to peak, m.
    pub major: f64,
    /// Half of the short axis, positive for forward whirl (from `x` to `y`), negative for backward, m.
    pub minor: f64,
    /// Angle of the long axis from `x`, in `(−π/2, π/2]`, rad.
    pub inclination: f64,
}

impl Orbit {
    /// The orbit of two complex amplitudes.
    pub fn of(x: Complex<f64>, y: Complex<f64>) -> Self {
        let i = Complex::new(0.0, 1.0);
        let (forward, backward) = ((x + i * y) / 2.0, (x - i * y).conj() / 2.0);
        let (f, b) = (forward.norm(), backward.norm());
        let mut inclination = 0.5 * (forward.arg() + backward.arg());
        if f == 0.0 || b == 0.0 {
            inclination = 0.0;
        }
        if inclination > std::f64::consts::FRAC_PI_2 {
            inclination -= std::f64::consts::PI;
        } else if inclination <= -std::f64::consts::FRAC_PI_2 {
            inclination += std::f64::consts::PI;
        }
        Self { major: f + b, minor: f - b, inclination }
    }
}

/// Complex amplitudes `[x, φ, y, ψ]` of every node under unbalances at a speed (rad/s): `x = Re(X e^{iΩt})`.
///
/// # Errors
/// `Unbounded` at a critical speed without damping; `Node`.
pub fn unbalance_response(
    rotor: &Assembled,
    unbalances: &[Unbalance],
    speed: f64,
) -> Result<Vec<[Complex<f64>; 4]>, RotorError> {
    let force = forces(rotor, unbalances, speed)?;
    let unbounded = RotorError::Unbounded { speed };
    let dynamic = Stiffness::new(rotor, Complex::new(0.0, speed), speed);
    let response = dynamic.solve(&force).ok_or(unbounded)?;
    // At rest the work of the force equals the elastic energy; near an undamped resonance it falls far behind it.
    let work = force.iter().flatten().zip(response.iter().flatten()).map(|(a, b)| a.conj() * b);
    let (work, energy) = (work.sum::<Complex<f64>>().norm(), elastic_energy(rotor, &response));
    let fine = response.iter().flatten().all(|x| x.re.is_finite() && x.im.is_finite());
    if !fine || (energy > 1e9 * work && work > 0.0) { Err(unbounded) } else { Ok(response) }
}

/// Relative residual of a response: the largest unbalanced nodal force over the largest of the forces that should
/// cancel there.
///
/// # Errors
/// `Node`.
pub fn residual(
    rotor: &Assembled,
    unbalances: &[Unbalance],
    speed: f64,
    response: &[[Complex<f64>; 4]],
) -> Result<f64, RotorError> {
    let force = forces(rotor, unbalances, speed)?;
    let carried = Stiffness::new(rotor, Complex::new(0.0, speed), speed).times(response);
    let elastic = Stiffness::new(rotor, Complex::new(0.0, 0.0), 0.0);
    let size = |freedom: usize| {
        let sizes = elastic.row_sizes(response, freedom).into_iter().fold(0.0, f64::max);
        force.iter().map(|node| node[freedom].norm()).fold(sizes, f64::max)
    };
    let worst = (0..4).map(|freedom| {
        let left = carried.iter().zip(&force).map(|(a, b)| (a[freedom] - b[freedom]).norm());
        left.fold(0.0, f64::max) / size(freedom).max(f64::MIN_POSITIVE)
    });
    Ok(worst.fold(0.0, f64::max))
}

/// Twice the strain energy of shaft and bearings in an amplitude.
fn elastic_energy(rotor: &Assembled, amplitude: &[Node]) -> f64 {
    let mut energy = 0.0;
    let mut form =
        |factor: f64, a: Complex<f64>, b: Complex<f64>| energy += factor * (a.re * b.re + a.im * b.im);
    for (n, node) in amplitude.iter().enumerate() {
        for (i, j) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            for plane in [0, 2] {
                form(rotor.stiffness.diagonal[n][(i, j)], node[plane + i], node[plane + j]);
                if let Some(next) = amplitude.get(n + 1) {
                    form(2.0 * rotor.stiffness.above[n][(i, j)], node[plane + i], next[plane + j]);
                }
            }
        }
    }
    for (node, Coefficients { stiffness, .. }) in rotor.bearings(0.0) {
        for (i, j) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            form(stiffness[i][j], amplitude[node][2 * i], amplitude[node][2 * j]);
        }
    }
    energy
}

/// The forces of unbalances, those on degrees of freedom that do not move left out.
fn forces(rotor: &Assembled, unbalances: &[Unbalance], speed: f64) -> Result<Vec<Node>, RotorError> {
    let zero = Complex::new(0.0, 0.0);
    let mut force: Vec<Node> = vec![[zero; 4]; rotor.nodes()];
    for unbalance in unbalances {
        let last = force.len() - 1;
        let node = force.get_mut(unbalance.node).ok_or(RotorError::Node { node: unbalance.node, last })?;
        let turning = Complex::from_polar(unbalance.size * speed * speed, unbalance.angle);
        node[0] += turning;
        node[2] += Complex::new(turning.im, -turning.re);
    }
    for &freedom in &rotor.fixed {
        for plane in [0, 2] {
            force[freedom / 2][plane + freedom % 2] = zero;
        }
    }
    Ok(force)
}
