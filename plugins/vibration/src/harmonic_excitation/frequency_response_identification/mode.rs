//! A mode as it is identified, and the kind of its damping.

use dalembert_core::Inputs;
use dalembert_mechanics::identification::modal::DampingModel;

/// Damping model of the mode.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum DampingKind {
    /// Viscous: mobility circle
    Viscous,
    /// Hysteretic: the circle is that of the receptance
    Hysteretic,
}

/// A mode as one method reads it.
#[derive(Clone, Copy)]
pub(super) struct IdentifiedMode<N> {
    pub(super) natural: N,
    pub(super) damping_ratio: N,
    pub(super) constant: N,
}

impl DampingKind {
    pub(super) fn model(self) -> DampingModel {
        match self {
            DampingKind::Viscous => DampingModel::Viscous,
            DampingKind::Hysteretic => DampingModel::Hysteretic,
        }
    }
}
