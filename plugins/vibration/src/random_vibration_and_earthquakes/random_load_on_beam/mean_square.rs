//! Mean squares of the modes of a beam under one spectral density.

use dalembert_core::Refusal;
use dalembert_mechanics::vibration::random::{Resonance, integrate, integrate_about, relative_squared};

use crate::shared::spectral_density::{Spectrum, not_found};

/// A response of the beam: the share of each mode in it, for a load of one.
pub(super) struct ModalSum<'a> {
    pub(super) spectrum: &'a Spectrum,
    /// The modes, with their shares.
    pub(super) modes: Vec<(Resonance, f64)>,
    /// False where the load excites each mode independently of the others.
    pub(super) coherent: bool,
    /// Power of the frequency: two for the velocity.
    pub(super) power: u8,
}

impl ModalSum<'_> {
    /// The spectral density of the response.
    pub(super) fn density(&self, omega: f64) -> f64 {
        let squared = if self.coherent {
            relative_squared(&self.modes, omega)
        } else {
            self.modes.iter().map(|(mode, share)| mode.receptance(omega).norm_sqr() * share * share).sum()
        };
        squared * omega.powi(self.power.into()) * self.spectrum.at(omega)
    }

    /// The mean square by adaptive integration.
    pub(super) fn integral(&self) -> Result<f64, Refusal> {
        let points = self.spectrum.breaks(self.modes.iter().map(|(mode, _)| *mode));
        integrate(|omega| self.density(omega), &points).map_err(not_found)
    }

    /// The mean square by partial fractions where the density is a level.
    pub(super) fn closed(&self) -> Option<f64> {
        if self.coherent {
            return self.spectrum.partial_fractions(&self.modes, self.power).map(|sum| sum.value);
        }
        self.modes.chunks(1).map(|mode| Some(self.spectrum.partial_fractions(mode, self.power)?.value)).sum()
    }

    /// The mean square by the faster of the two.
    pub(super) fn value(&self) -> Result<f64, Refusal> {
        self.closed().map_or_else(|| self.integral(), Ok)
    }

    /// The mean square in the way that is not that of `value`; `None` where there is none.
    pub(super) fn second(&self) -> Option<f64> {
        if self.closed().is_some() {
            return self.integral().ok();
        }
        let mut points = self.spectrum.breaks(self.modes.iter().map(|(mode, _)| *mode));
        if points.iter().any(|point| point.is_infinite()) {
            return None;
        }
        points.sort_by(f64::total_cmp);
        points.dedup();
        let (first, _) = self.modes.first()?;
        let about = [first.natural, first.natural * first.ratio];
        Some(integrate_about(|omega| self.density(omega), &points, about))
    }

    /// The mean square of one mode alone.
    pub(super) fn alone(&self, mode: usize) -> Result<f64, Refusal> {
        let modes = vec![self.modes[mode]];
        ModalSum { modes, spectrum: self.spectrum, ..*self }.value()
    }
}
