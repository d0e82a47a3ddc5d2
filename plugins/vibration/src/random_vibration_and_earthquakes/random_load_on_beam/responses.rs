//! Responses at a place of the beam: sums of modes with their cross terms.

use dalembert_core::{Refusal, Text, Worksheet};
use dalembert_mechanics::{Real, beam::dynamic_stiffness::BeamShape, vibration::random::Resonance};

use super::mean_square::ModalSum;
use crate::{
    shared::spectral_density::{Spectrum, zero_crossings},
    sources::RAO,
};

/// A mode under its load, with its values at the place of the response.
pub(super) struct LoadedMode<N> {
    pub(super) n: usize,
    pub(super) natural: N,
    pub(super) resonance: Resonance,
    /// Force on the mode over its mass for a load of one.
    pub(super) amplitude: f64,
    /// Root mean square of the modal coordinate under white noise.
    pub(super) white: Option<N>,
    pub(super) deflection: f64,
    /// Over one over the square of the length.
    pub(super) curvature: f64,
    pub(super) shape: BeamShape,
}

/// The modes of a beam under a load.
pub(super) struct LoadedBeam<N> {
    pub(super) modes: Vec<LoadedMode<N>>,
    /// Place of the response over the length.
    pub(super) place: f64,
    pub(super) spectrum: Spectrum,
    /// False where the load has no correlation between points.
    pub(super) coherent: bool,
    /// True for a load whose forces on the modes do not become smaller with their number.
    pub(super) at_points: bool,
    pub(super) viscous: bool,
    /// `EI/L²`.
    pub(super) unit_moment: N,
}

/// Names of a response in the working.
struct Names {
    total: &'static str,
    alone: &'static str,
    cross: &'static str,
    unit: &'static str,
    squared: &'static str,
    why: &'static str,
}

const DISPLACEMENT: Names = Names {
    total: "σ_w",
    alone: "w_Σ",
    cross: "C_w",
    unit: "mm",
    squared: "mm^2",
    why: "Root mean square of the displacement",
};
const VELOCITY: Names = Names {
    total: "σ_v",
    alone: "v_Σ",
    cross: "C_v",
    unit: "mm/s",
    squared: "mm^2/s^2",
    why: "Root mean square of the velocity",
};
const MOMENT: Names = Names {
    total: "σ_M",
    alone: "M_Σ",
    cross: "C_M",
    unit: "N*m",
    squared: "N^2*m^2",
    why: "Root mean square of the bending moment",
};

impl<N: Real> LoadedBeam<N> {
    /// Returns true if velocity and bending moment have a finite mean square: under white forces at points and
    /// viscous damping every mode contributes as much as the first one.
    pub(super) fn bounded(&self) -> bool {
        !(matches!(self.spectrum, Spectrum::White(_)) && self.viscous && self.at_points)
    }

    /// The response whose share in each mode is given.
    pub(super) fn sum(&self, share: impl Fn(&LoadedMode<N>) -> f64, power: u8) -> ModalSum<'_> {
        let modes = self.modes.iter().map(|mode| (mode.resonance, mode.amplitude * share(mode))).collect();
        ModalSum { spectrum: &self.spectrum, modes, coherent: self.coherent, power }
    }

    /// Returns true if the beam is deflected at the place.
    pub(super) fn moves(&self) -> bool {
        self.is_above(|mode| mode.deflection)
    }

    /// Returns true if a share of the modes is above rounding.
    fn is_above(&self, share: impl Fn(&LoadedMode<N>) -> f64) -> bool {
        let most = self.modes.iter().fold(0.0, |most: f64, mode| most.max(mode.amplitude.abs()));
        self.modes.iter().any(|mode| (mode.amplitude * share(mode)).abs() > 1e-9 * most)
    }

    /// Writes the responses; the bending moment, where there is one.
    pub(super) fn answers<W: Worksheet<Num = N>>(&self, sheet: W) -> Result<Option<N>, Refusal> {
        let bends = self.is_above(|mode| mode.curvature);
        if !self.moves() && !bends {
            return Err(Refusal::because(
                "the beam is neither deflected nor bent at this place: choose another place",
            ));
        }
        let coordinates = self.coordinates(sheet)?;
        if self.moves() {
            self.motion(&coordinates, sheet)?;
        }
        if !self.bounded() {
            sheet.warn(|| {
                Text::new(
                    "under white noise with viscous damping the velocity and the bending moment have no finite mean square: they grow with the number of modes; give a damping ratio or a band",
                )
            });
            return Ok(None);
        }
        if !bends {
            return Ok(None);
        }
        let why = "Curvature of the mode shape at the place, over 1/L²";
        let shape = |mode: &LoadedMode<N>| sheet.numerical(("κ", mode.n), "1", mode.curvature, why);
        let parts: Vec<N> = self
            .modes
            .iter()
            .zip(&coordinates)
            .map(|(mode, coordinate)| self.unit_moment * shape(mode) * *coordinate)
            .collect();
        let unit = self.unit_moment.value();
        let sum = self.sum(|mode| mode.curvature * unit, 0);
        let moment = total(&parts, &sum, &MOMENT, sheet)?;
        sheet.answer("bending_moment", "Root mean square of the bending moment", moment);
        let shares = shares(&parts, moment);
        sheet.answer_list("moment_shares", "Shares of the modes, bending moment", "%", &shares);
        let last = shares.iter().rev().take(2).fold(0.0, |most: f64, share| most.max(*share));
        if last > 0.01 && shares.len() > 1 {
            sheet.warn(|| {
                Text::new(
                    "the last modes still contribute {share} of the mean square bending moment: count more modes",
                )
                .with_quantity("share", last, "%")
            });
        }
        Ok(Some(moment))
    }

    /// The root mean square of each modal coordinate, with the sign of its load.
    fn coordinates<W: Worksheet<Num = N>>(&self, sheet: W) -> Result<Vec<N>, Refusal> {
        let one = |(place, mode): (usize, &LoadedMode<N>)| {
            if let Some(white) = mode.white {
                return Ok(white);
            }
            sheet.keep_going()?;
            let value = self.sum(|_| 1.0, 0).alone(place)?.sqrt().copysign(mode.amplitude);
            let why = (
                "Root mean square of the modal coordinate, from the integral of |H|²S, with the sign of the load on the mode",
                RAO.at("ch. 14"),
            );
            Ok(sheet.numerical(("q", mode.n), "mm", value, why))
        };
        self.modes.iter().enumerate().map(one).collect()
    }

    /// Displacement, velocity and rate of zero crossings.
    fn motion<W: Worksheet<Num = N>>(&self, coordinates: &[N], sheet: W) -> Result<(), Refusal> {
        let why = "Mode shape at the place of the response";
        let shapes: Vec<N> =
            self.modes.iter().map(|mode| sheet.numerical(("φ", mode.n), "1", mode.deflection, why)).collect();
        let parts: Vec<N> = shapes.iter().zip(coordinates).map(|(shape, q)| *shape * *q).collect();
        let displacement = total(&parts, &self.sum(|mode| mode.deflection, 0), &DISPLACEMENT, sheet)?;
        sheet.answer("displacement", "Root mean square of the displacement", displacement);
        sheet.answer_list(
            "displacement_shares",
            "Shares of the modes, displacement",
            "%",
            &shares(&parts, displacement),
        );
        if !self.bounded() {
            return Ok(());
        }
        let speeds = self.sum(|_| 1.0, 2);
        let mut parts = Vec::new();
        for (place, (mode, shape)) in self.modes.iter().zip(&shapes).enumerate() {
            let speed = if mode.white.is_some() {
                let why = "Root mean square of the modal velocity under white noise";
                sheet.step(("q̇", mode.n), "mm/s", mode.natural * coordinates[place], why)
            } else {
                let value = speeds.alone(place)?.sqrt().copysign(mode.amplitude);
                let why = "Root mean square of the modal velocity, from the integral of ω²|H|²S";
                sheet.numerical(("q̇", mode.n), "mm/s", value, why)
            };
            parts.push(*shape * speed);
        }
        let velocity = total(&parts, &self.sum(|mode| mode.deflection, 2), &VELOCITY, sheet)?;
        sheet.answer("velocity", "Root mean square of the velocity", velocity);
        let moment = |power| self.sum(|mode| mode.deflection, power).second();
        zero_crossings([displacement, velocity], moment, sheet);
        Ok(())
    }

    /// The mean square of the curvature times the square of the length by the second method, m².
    pub(super) fn second_curvature(&self) -> Option<f64> {
        self.sum(|mode| mode.curvature, 0).second()
    }
}

/// The root of a sum of modes with their cross terms.
fn total<W: Worksheet>(
    parts: &[W::Num],
    sum: &ModalSum<'_>,
    names: &Names,
    sheet: W,
) -> Result<W::Num, Refusal> {
    sheet.keep_going()?;
    if parts.len() > 1 {
        let sizes = || W::Num::sum(parts.iter().map(|part| part.abs()));
        sheet.common_error(names.total, "the root mean squares of the modes added as numbers", sizes);
        let signed = || W::Num::sum(parts.iter().copied()).abs();
        sheet.common_error(names.total, "the responses of the modes added with their signs", signed);
        sheet.common_error(names.total, "the first mode alone counted", || parts[0].abs());
    }
    let squares = W::Num::sum(parts.iter().map(|part| part.powi(2))).sqrt();
    let (value, size) = if !sum.coherent || parts.len() == 1 {
        (sheet.step(names.total, names.unit, squares, (names.why, RAO.at("ch. 14"))), squares.value().powi(2))
    } else {
        let why = "Root of the sum of the squares of the modes, each alone";
        let alone = sheet.step(names.alone, names.unit, squares, why);
        let modes = sum.modes.clone();
        let without =
            ModalSum { modes, spectrum: sum.spectrum, coherent: false, power: sum.power }.value()?;
        let cross = (sum.value()? - without).max(-without);
        let why = "Cross terms: what every two modes have in common, from the integral of H₁H₂*S";
        let cross = sheet.numerical(names.cross, names.squared, cross, why);
        let value = (alone.powi(2) + cross).sqrt();
        let value = sheet.step(names.total, names.unit, value, (names.why, RAO.at("ch. 14")));
        (value, without + cross.value().abs())
    };
    sheet.verify(|| {
        if let Some(second) = sum.second() {
            let what = Text::new("{what} by the integral of the whole response over the frequency")
                .with_text("what", names.why);
            sheet.check_sum(what, value.powi(2), second.into(), size);
        }
    });
    Ok(value)
}

/// The mean square of each mode alone, over the whole.
fn shares<N: Real>(parts: &[N], total: N) -> Vec<f64> {
    parts.iter().map(|part| (part.value() / total.value()).powi(2)).collect()
}
