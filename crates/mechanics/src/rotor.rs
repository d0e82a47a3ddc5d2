//! Lateral vibration of rotors by finite elements: shaft, discs, bearings, unbalances, gyroscopic action.
//!
//! The shaft axis is `z` and the shaft spins from `x` to `y` at the speed `Ω`. Every node moves sideways by `x` and
//! `y` and tilts by the slopes `φ = dx/dz` and `ψ = dy/dz`. In each of the two planes the shaft has the same
//! matrices, so they are kept once ([`Plane`]); rotation couples the planes:
//!
//! `M ü + Ω G v̇ + C u̇ + K u + (Ω Hᵥ + Hₕ) v = f_x`, `M v̈ − Ω G u̇ + C v̇ + K v − (Ω Hᵥ + Hₕ) u = f_y`
//!
//! with `u = (x₁, φ₁, x₂, φ₂, …)` and `v` alike, `G` the polar inertia on the slopes, `Hᵥ` and `Hₕ` the circulatory
//! matrices of internal viscous and hysteretic damping, and the bearings in `C` and `K`.
//!
//! Nelson and McVaugh, J. Eng. Ind. 98 (1976) 593–600; Zorzi and Nelson, J. Eng. Power 99 (1977) 71–76; Friswell,
//! Penny, Garvey and Lees, *Dynamics of Rotating Machines*, ch. 5 and 6.
//!
//! ```
//! use dalembert_mechanics::rotor::{
//!     critical,
//!     element::{BeamTheory, Material, ShaftElement},
//!     modes::ReducedRotor,
//!     *,
//! };
//!
//! // A disc of 10 kg in the middle of a shaft of 30 mm and 1 m, whose own mass is next to nothing, on two rigid bearings.
//! let material = Material { young: 200e9, shear: 77e9, density: 1e-6, viscous_damping: 0.0, loss_factor: 0.0 };
//! let element = ShaftElement { length: 0.5, outer: [0.03; 2], inner: [0.0; 2], material };
//! let rotor = Rotor {
//!     elements: vec![element; 2],
//!     theory: BeamTheory::EulerBernoulli,
//!     tension: 0.0,
//!     discs: vec![RigidDisc { node: 1, mass: 10.0, diametral: 0.02, polar: 0.04 }],
//!     supports: [0, 2].map(|node| BearingSupport { node, hold: SupportType::Pinned }).to_vec(),
//! };
//! let assembled = Assembled::new(&rotor)?;
//! let criticals = critical::direct(&ReducedRotor::new(&assembled, 2, &[0.0])?, 1.0, 1000.0)?;
//! // The critical speed is √(48 E I/(m L³)) with I = π d⁴/64.
//! let jeffcott = (48.0 * 200e9 * (std::f64::consts::PI * 0.03_f64.powi(4) / 64.0) / 10.0).sqrt();
//! assert!((criticals.found[0].speed / jeffcott - 1.0).abs() < 1e-9);
//! # Ok::<(), RotorError>(())
//! ```

pub mod campbell;
pub mod critical;
pub mod disc;
pub mod element;
pub mod mesh;
pub mod modes;
pub mod overhung;
pub mod response;
pub mod stiffness_map;

mod assembled;
mod basis;
mod plane;
mod stiffness;

pub use assembled::Assembled;
pub use nalgebra::Complex;
pub use plane::Plane;

use dalembert_numerics::linalg::LinalgError;

/// A rotor as finite elements.
#[derive(Debug, Clone, PartialEq)]
pub struct Rotor {
    /// The shaft, from left to right; element `n` lies between the nodes `n` and `n + 1`.
    pub elements: Vec<element::ShaftElement>,
    /// Beam theory of the shaft: with or without shear deformation.
    pub theory: element::BeamTheory,
    /// Axial tension of the shaft, N; negative for compression.
    pub tension: f64,
    /// Rigid discs.
    pub discs: Vec<RigidDisc>,
    /// Supports of the shaft.
    pub supports: Vec<BearingSupport>,
}

/// A rigid disc at a node.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RigidDisc {
    /// The node.
    pub node: usize,
    /// Mass, kg.
    pub mass: f64,
    /// Moment of inertia about a diameter, kg·m².
    pub diametral: f64,
    /// Moment of inertia about the axis, kg·m².
    pub polar: f64,
}

/// Support of the shaft at a node.
#[derive(Debug, Clone, PartialEq)]
pub struct BearingSupport {
    /// The node.
    pub node: usize,
    /// Type and coefficients of the support.
    pub hold: SupportType,
}

/// Type and coefficients of a support.
#[derive(Debug, Clone, PartialEq)]
pub enum SupportType {
    /// Bearing: its coefficients at one or more speeds (rad/s), ascending; linear between them, constant beyond.
    Bearing(Vec<(f64, Coefficients)>),
    /// No sideways motion.
    Pinned,
    /// No sideways motion and no tilt.
    Clamped,
}

/// The linear coefficients of a bearing: force on the shaft `−k (x, y) − c (ẋ, ẏ)`.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Coefficients {
    /// Stiffness `[[kxx, kxy], [kyx, kyy]]`, N/m.
    pub stiffness: [[f64; 2]; 2],
    /// Damping `[[cxx, cxy], [cyx, cyy]]`, N·s/m.
    pub damping: [[f64; 2]; 2],
}

/// Reason for which a rotor model is refused or has no answer.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum RotorError {
    /// A number is not finite or an element has no length, stiffness or mass.
    #[error("{what} is {value}, which makes no rotor; it must be positive and finite")]
    Value {
        /// Name of the quantity.
        what: &'static str,
        /// Value, SI.
        value: f64,
    },
    /// A disc, bearing or unbalance stands at a node that is not there.
    #[error("node {node} is not on the shaft, which has nodes 0 to {last}")]
    Node {
        /// The node.
        node: usize,
        /// The last node.
        last: usize,
    },
    /// Compression beyond buckling, or bearings that push the shaft away more than it resists.
    #[error("the rotor is statically unstable: it buckles or its bearings push it away")]
    Buckled,
    /// All degrees of freedom are fixed, or their masses too small or too large for numbers.
    #[error("no node can move; take more elements between the supports, or masses that numbers can hold")]
    Rigid,
    /// An undamped rotor driven at its natural frequency.
    #[error("the response at {speed} rad/s grows without bound: an undamped critical speed")]
    Unbounded {
        /// The speed, rad/s.
        speed: f64,
    },
    /// Somebody asked to stop.
    #[error("cancelled")]
    Stopped,
    /// A decomposition failed.
    #[error(transparent)]
    Linalg(#[from] LinalgError),
}

impl Coefficients {
    /// The same stiffness `k` and damping `c` in every direction.
    pub fn isotropic(k: f64, c: f64) -> Self {
        Self::orthotropic([k, k], [c, c])
    }

    /// Different stiffness and damping along `x` and `y`, uncoupled.
    pub fn orthotropic(k: [f64; 2], c: [f64; 2]) -> Self {
        Self { stiffness: [[k[0], 0.0], [0.0, k[1]]], damping: [[c[0], 0.0], [0.0, c[1]]] }
    }

    /// Returns true if `kxy` and `kyx` are equal but for the rounding of a change of units.
    fn is_symmetric(&self) -> bool {
        let [[_, xy], [yx, _]] = self.stiffness;
        (xy - yx).abs() <= 4.0 * f64::EPSILON * xy.abs().max(yx.abs())
    }

    fn between(self, other: Self, share: f64) -> Self {
        let mix = |a: [[f64; 2]; 2], b: [[f64; 2]; 2]| {
            [0, 1].map(|i| [0, 1].map(|j| a[i][j] + share * (b[i][j] - a[i][j])))
        };
        Self { stiffness: mix(self.stiffness, other.stiffness), damping: mix(self.damping, other.damping) }
    }
}

impl BearingSupport {
    /// A bearing whose coefficients do not depend on speed.
    pub fn bearing(node: usize, coefficients: Coefficients) -> Self {
        Self { node, hold: SupportType::Bearing(vec![(0.0, coefficients)]) }
    }

    /// Returns true if the coefficients do not depend on speed.
    pub fn is_constant(&self) -> bool {
        !matches!(&self.hold, SupportType::Bearing(table) if table.len() > 1)
    }

    /// The coefficients of a bearing at a speed; `None` for a rigid support.
    pub fn at(&self, speed: f64) -> Option<Coefficients> {
        let SupportType::Bearing(table) = &self.hold else { return None };
        let after = table.iter().position(|(here, _)| *here > speed);
        Some(match after {
            None => table.last()?.1,
            Some(0) => table[0].1,
            Some(n) => {
                let ((a, left), (b, right)) = (table[n - 1], table[n]);
                left.between(right, (speed - a) / (b - a))
            }
        })
    }
}

impl Rotor {
    /// The number of nodes.
    pub fn nodes(&self) -> usize {
        self.elements.len() + 1
    }

    /// Distances of the nodes from the left end, m.
    pub fn positions(&self) -> Vec<f64> {
        let mut at = 0.0;
        std::iter::once(0.0)
            .chain(self.elements.iter().map(|element| {
                at += element.length;
                at
            }))
            .collect()
    }

    /// Returns true if nothing dissipates or feeds energy and no bearing depends on speed: natural frequencies are then
    /// those of a Hermitian problem and critical speeds can be found directly.
    pub fn is_conservative(&self) -> bool {
        self.is_undamped() && self.supports.iter().all(BearingSupport::is_constant)
    }

    /// Returns true if nothing dissipates or feeds energy at any speed: then no mode grows or decays.
    pub fn is_undamped(&self) -> bool {
        let undamped = |here: &Coefficients| here.is_symmetric() && here.damping == [[0.0; 2]; 2];
        !self.has_internal_damping() && self.coefficients().all(undamped)
    }

    /// Returns true if nothing can feed energy at any speed: every bearing has a symmetric positive semidefinite
    /// stiffness and a damping that only dissipates, and the shaft has no rotating damping. The total energy then never
    /// rises, and without compression no motion grows.
    pub fn cannot_grow(&self) -> bool {
        !self.has_internal_damping()
            && self.tension >= 0.0
            && self
                .coefficients()
                .all(|here| here.is_symmetric() && pulls(here.stiffness) && pulls(here.damping))
    }

    fn has_internal_damping(&self) -> bool {
        self.elements
            .iter()
            .any(|element| element.material.viscous_damping != 0.0 || element.material.loss_factor != 0.0)
    }

    /// Every row of every bearing table.
    fn coefficients(&self) -> impl Iterator<Item = &Coefficients> {
        let rows = |support| match support {
            &BearingSupport { hold: SupportType::Bearing(ref table), .. } => table.as_slice(),
            _ => &[],
        };
        self.supports.iter().flat_map(rows).map(|(_, here)| here)
    }
}

/// Returns true if the symmetric part of a matrix is positive semidefinite.
fn pulls([[xx, xy], [yx, yy]]: [[f64; 2]; 2]) -> bool {
    let cross = 0.5 * (xy + yx);
    xx >= 0.0 && yy >= 0.0 && cross * cross <= xx * yy
}
