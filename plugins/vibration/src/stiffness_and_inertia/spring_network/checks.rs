//! Second methods to how a network moves: the energies of its springs and masses, and the power of its dampers.

use dalembert_core::Worksheet;
use dalembert_mechanics::{
    Real,
    vibration::network::{Network, SpringDamper},
};
use dalembert_numerics::linalg::ComplexLu;
use nalgebra::{Complex, DMatrix};

/// Sums over masses, dampers and springs for a motion of all nodes: `Σ m|x|²`, `Σ c|Δx|²` and `Σ k|Δx|²`.
struct Sums {
    inertia: f64,
    damping: f64,
    stiffness: f64,
}

fn sums(system: &Network, moved: &[Complex<f64>]) -> Sums {
    let over = |of: fn(&SpringDamper) -> f64| {
        let part = |link: &SpringDamper| {
            let [from, to] = link.ends.map(|end| end.map_or(Complex::ZERO, |node| moved[node]));
            of(link) * (from - to).norm_sqr()
        };
        system.links.iter().map(part).sum()
    };
    Sums {
        inertia: system.masses.iter().zip(moved).map(|(mass, x)| mass * x.norm_sqr()).sum(),
        damping: over(|link| link.damping),
        stiffness: over(|link| link.stiffness),
    }
}

/// Twice the energy of the springs where a unit displacement of the node moves the other ones along; `None` where the
/// springs do not hold all nodes.
pub(super) fn elastic(system: &Network, node: usize) -> Option<f64> {
    let mut unit = vec![0.0; system.masses.len()];
    unit[node] = 1.0;
    let moved: Vec<Complex<f64>> = system.at_rest(&unit).ok()?.into_iter().map(Complex::from).collect();
    Some(sums(system, &moved).stiffness / moved[node].norm_sqr())
}

/// The network with its dampers in the place of its springs: velocities instead of displacements.
pub(super) fn dampers_alone(system: &Network) -> Network {
    let links =
        system.links.iter().map(|link| SpringDamper { stiffness: link.damping, damping: 0.0, ..*link });
    Network { masses: system.masses.clone(), links: links.collect() }
}

/// Displayed results of the harmonic motion of the loaded node.
pub(super) struct NodeResponse<N> {
    pub(super) force: N,
    pub(super) amplitude: N,
    pub(super) lag: N,
    pub(super) storage: N,
    pub(super) loss: N,
    pub(super) dynamic: N,
    pub(super) factor: Option<N>,
}

/// Holds the harmonic motion to the power of the dampers and to the energies of springs and masses.
pub(super) fn harmonic_response<W: Worksheet>(
    system: &Network,
    omega: f64,
    moved: &[Complex<f64>],
    shown: &NodeResponse<W::Num>,
    sheet: W,
) {
    let Sums { inertia, damping, stiffness } = sums(system, moved);
    let (held, taken) = (stiffness - omega.powi(2) * inertia, omega * damping);
    let whole = shown.force * shown.amplitude;
    let size = whole.value().max(stiffness + omega.powi(2) * inertia);
    // The products of the equations of the nodes with their motions are summed up.
    let error = f64::EPSILON * moved.len() as f64 * size;
    sheet.check_residual(
        "the power of the force equals the power dissipated by the dampers",
        W::Num::from(whole.value() * shown.lag.value().sin() - taken),
        whole.value(),
        error,
    );
    sheet.check_sum(
        "the force component in phase with the motion balances spring and inertia forces, F X cos φ = Σ k|Δx|² − ω² Σ m|x|²",
        whole * shown.lag.cos(),
        held.into(),
        size,
    );
    let square = shown.amplitude.powi(2);
    sheet.check_sum(
        "real part of the dynamic stiffness from the energies of springs and masses",
        shown.storage * square,
        held.into(),
        size,
    );
    sheet.check_residual(
        "imaginary part of the dynamic stiffness from the power of the dampers",
        W::Num::from((shown.loss * square).value() - taken),
        whole.value(),
        error,
    );
    sheet.check(
        "the squares of the real and imaginary parts of the dynamic stiffness sum to the square of its magnitude",
        shown.storage.powi(2) + shown.loss.powi(2),
        shown.dynamic.powi(2),
    );
    if let Some(factor) = shown.factor {
        sheet.check_zero(
            "the loss factor is the tangent of the phase lag",
            factor * shown.lag.cos() - shown.lag.sin(),
            1.0,
        );
    }
}

/// Holds a root to the shape of its motion: with `m = Σ m|x|²`, `c = Σ c|Δx|²` and `k = Σ k|Δx|²` of the shape it is a root
/// of `m s² + c s + k`.
pub(super) fn free<W: Worksheet>(system: &Network, root: Complex<f64>, ratio: Option<W::Num>, sheet: W) {
    let Some((shape, error)) = shape(system, root) else { return };
    let Sums { inertia, damping, stiffness } = sums(system, &shape);
    let terms = [root * root * inertia, root * damping, Complex::from(stiffness)];
    let size: f64 = terms.iter().map(|term| term.norm()).sum();
    let left: Complex<f64> = terms.iter().sum();
    sheet.check_residual(
        "for the mode shape, the frequency satisfies m s² + c s + k = 0, summed over all elements",
        W::Num::from(left.norm() / size),
        1.0,
        error,
    );
    if let Some(ratio) = ratio {
        sheet.check_residual(
            "damping ratio from the mode shape, c/2√(k m) summed over all elements",
            ratio - damping / (2.0 * (stiffness * inertia).sqrt()),
            1.0,
            error,
        );
    }
}

/// The shape of the free motion whose root is next to this one, by inverse iteration, and what the last turn changed in it.
fn shape(system: &Network, root: Complex<f64>) -> Option<(Vec<Complex<f64>>, f64)> {
    let count = system.masses.len();
    let beside = root * Complex::new(1.0 + 1e-7, 1e-7);
    let mut damping = DMatrix::<Complex<f64>>::zeros(count, count);
    let mut matrix = damping.clone();
    let masses = system.masses.iter().map(|mass| Complex::from(*mass));
    let masses = DMatrix::from_diagonal(&nalgebra::DVector::from_iterator(count, masses));
    let add = |matrix: &mut DMatrix<Complex<f64>>, link: &SpringDamper, value: Complex<f64>| {
        for end in link.ends.into_iter().flatten() {
            matrix[(end, end)] += value;
        }
        if let [Some(a), Some(b)] = link.ends {
            matrix[(a, b)] -= value;
            matrix[(b, a)] -= value;
        }
    };
    for link in &system.links {
        add(&mut damping, link, link.damping.into());
        add(&mut matrix, link, link.stiffness + beside * link.damping);
    }
    matrix += &masses * (beside * beside);
    let factors = ComplexLu::new(&matrix).ok()?;
    // No symmetry of the network makes a shape orthogonal to this one.
    let mut shape = DMatrix::from_fn(count, 1, |n, _| Complex::new(1.0, 0.1) / (1.0 + 0.3 * n as f64));
    let mut velocity = &shape * beside;
    let (mut largest, mut change) = (0, f64::INFINITY);
    for turn in 0..5 {
        // (s² M + s C + K) x = 0 as a problem of the first order in x and s x.
        let right = -(&masses * &velocity + (&damping + &masses * beside) * &shape);
        let next = factors.solve(&right).ok()?;
        let rate = &shape + &next * beside;
        if turn < 3 {
            let sizes = |n: &usize| next[*n].norm();
            largest = (0..count).max_by(|p, q| sizes(p).total_cmp(&sizes(q)))?;
        }
        let unit = next[largest].inv();
        let next = next * unit;
        change = (&next - &shape).iter().fold(0.0, |worst: f64, x| worst.max(x.norm()));
        (shape, velocity) = (next, rate * unit);
    }
    change.is_finite().then(|| (shape.as_slice().to_vec(), change + f64::EPSILON * count as f64))
}
