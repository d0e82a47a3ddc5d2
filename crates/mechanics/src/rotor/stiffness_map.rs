//! Critical speeds over the stiffness of the bearings.
//!
//! The bearings are alike in all directions and nothing is damped; then every whirl is a circle, and one plane tells
//! it: `(K + k B − ω² (M ∓ G/s)) v = 0` with `ω = s Ω`, the upper sign for whirl with the spin. The shaft is
//! condensed to the deflections at its bearings and its lowest shapes with the bearings held (R. R. Craig and
//! M. C. C. Bampton, AIAA J. 6 (1968), 1313–1319): as good for soft bearings as for stiff ones.

use nalgebra::{DMatrix, DVector};

use super::{Assembled, BearingSupport, Rotor, RotorError, SupportType, basis::project, modes::ReducedRotor};
use dalembert_numerics::linalg;

/// Relative error allowed for the square of a frequency.
const SHARE: f64 = 1e-6;

/// Critical speeds over stiffness.
#[derive(Debug, Clone, PartialEq)]
pub struct StiffnessMap {
    /// Of the shaft on its bearings' deflections, the bearings left out.
    stiffness: DMatrix<f64>,
    mass: DMatrix<f64>,
    gyroscopic: DMatrix<f64>,
    /// The stiffness of each bearing for a unit of the varied one; their deflections are the first coordinates.
    bearings: Vec<f64>,
    count: usize,
}

/// The critical speeds at a stiffness, rad/s, ascending.
#[derive(Debug, Clone, PartialEq)]
pub struct Speeds {
    /// Of whirl with the spin.
    pub forward: Vec<f64>,
    /// Of whirl against the spin.
    pub backward: Vec<f64>,
}

impl StiffnessMap {
    /// Condenses a rotor. `shares` are the stiffnesses of its bearings, in their order among the supports, for a unit
    /// of the one that is varied; the speeds sought lie up to `highest`, rad/s.
    ///
    /// # Errors
    /// `Value`, `Node`; `Buckled` where the rotor can move with its bearings held; `Rigid` where nothing then moves;
    /// `Linalg`.
    pub fn new(rotor: &Rotor, shares: &[f64], count: usize, highest: f64) -> Result<Self, RotorError> {
        let is_bearing = |support: &&BearingSupport| matches!(support.hold, SupportType::Bearing(_));
        let (bearings, fixed): (Vec<BearingSupport>, Vec<BearingSupport>) =
            rotor.supports.iter().cloned().partition(|support| is_bearing(&support));
        let free = Assembled::new(&Rotor { supports: fixed.clone(), ..rotor.clone() })?;
        let mut places: Vec<(usize, f64)> = Vec::new();
        for (support, share) in bearings.iter().zip(shares) {
            match places.iter_mut().find(|(node, _)| *node == support.node) {
                Some((_, sum)) => *sum += share,
                None if free.fixed.contains(&(2 * support.node)) => {}
                None => places.push((support.node, *share)),
            }
        }
        let pins = places.iter().map(|(node, _)| BearingSupport { node: *node, hold: SupportType::Pinned });
        let held = Rotor { supports: fixed.into_iter().chain(pins).collect(), ..rotor.clone() };
        let held = Assembled::new(&held)?;
        let factors = held.stiffness.factors(0.0).ok_or(RotorError::Buckled)?;
        let reduced = ReducedRotor::to_within(&held, count + 4, &[0.0, highest], SHARE, &|| false)?;
        let mut shapes: Vec<DVector<f64>> = Vec::new();
        for (node, _) in &places {
            let mut unit = DVector::zeros(2 * rotor.nodes());
            unit[2 * node] = 1.0;
            let mut load = -free.shaft_times(&unit);
            for freedom in &held.fixed {
                load[*freedom] = 0.0;
            }
            shapes.push(unit + factors.solve(&load));
        }
        shapes.extend(reduced.shapes_of_one_plane());
        let images: Vec<DVector<f64>> = shapes.iter().map(|shape| free.shaft_times(shape)).collect();
        let shapes = DMatrix::from_columns(&shapes);
        Ok(Self {
            stiffness: shapes.tr_mul(&DMatrix::from_columns(&images)),
            mass: project(&free.mass, &shapes),
            gyroscopic: project(&free.gyroscopic, &shapes),
            bearings: places.into_iter().map(|(_, share)| share).collect(),
            count,
        })
    }

    /// The lowest critical speeds of both whirls on bearings of this stiffness, N/m, at the slope `s` of the line.
    ///
    /// # Errors
    /// `Linalg`, also where the rotor is not stable at rest.
    pub fn at(&self, stiffness: f64, slope: f64) -> Result<Speeds, RotorError> {
        let mut held = self.stiffness.clone();
        for (n, share) in self.bearings.iter().enumerate() {
            held[(n, n)] += share * stiffness;
        }
        let speeds = |sign: f64| -> Result<Vec<f64>, RotorError> {
            let inertia = &self.mass - &self.gyroscopic * (sign / slope);
            // The inertia may be negative in a shape; the stiffness never is.
            let inverse = linalg::generalised_eigenvalues(&inertia, &held)?;
            let positive = inverse.iter().rev().copied().take_while(|value| *value > 0.0);
            Ok(positive.take(self.count).map(|value| 1.0 / (value.sqrt() * slope)).collect())
        };
        Ok(Speeds { forward: speeds(1.0)?, backward: speeds(-1.0)? })
    }
}
