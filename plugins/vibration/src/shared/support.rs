//! Supports of beams in bending.

use dalembert_core::{Inputs, Sketch};

use crate::shared::continuous::{HALF_BEAM, draw_support};

/// A support at an end of a beam or between its spans.
#[derive(Clone, Debug, Inputs)]
pub enum Support {
    /// Free
    Free,
    /// Pinned
    Pinned,
    /// Clamped
    Clamped,
    /// Guided: deflects without rotating
    Guided,
    /// Springs
    Springs {
        /// Transverse stiffness.
        #[input("k", "N/m", nonnegative)]
        transverse: Option<f64>,
        /// Rotational stiffness.
        #[input("k_t", "N*m/rad", nonnegative)]
        rotational: Option<f64>,
    },
}

/// A support as a kernel takes it, its springs in units of the beam.
pub(crate) struct Restraint {
    pub(crate) held: bool,
    pub(crate) clamped: bool,
    pub(crate) spring: f64,
    pub(crate) turning_spring: f64,
}

impl Support {
    /// The support over a length and a bending stiffness.
    pub(crate) fn restraint(&self, length: f64, bending: f64) -> Restraint {
        let (transverse, rotational) = match *self {
            Support::Springs { transverse, rotational } => (transverse, rotational),
            _ => (None, None),
        };
        Restraint {
            held: matches!(self, Support::Pinned | Support::Clamped),
            clamped: matches!(self, Support::Clamped | Support::Guided),
            spring: transverse.unwrap_or(0.0) * length.powi(3) / bending,
            turning_spring: rotational.unwrap_or(0.0) * length / bending,
        }
    }

    /// The support at the end of a drawn beam.
    pub(crate) fn draw(&self, sketch: &mut Sketch, x: f64, left_end: bool) {
        let held = matches!(self, Support::Pinned | Support::Clamped);
        let clamped = matches!(self, Support::Clamped | Support::Guided);
        let y = if clamped { 0.0 } else { -HALF_BEAM };
        draw_support(sketch, (held, clamped), (x, y), left_end);
        if let Support::Springs { transverse, rotational } = self {
            if transverse.is_some() {
                sketch.spring("k", (x, -1.0), (x, -HALF_BEAM)).ground((x - 0.3, -1.0), (x + 0.3, -1.0));
            }
            if rotational.is_some() {
                sketch.torsion_spring("k_t", (x, 0.0), 0.0);
            }
        }
    }
}
