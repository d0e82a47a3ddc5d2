//! Second methods to the answers of a free motion: its equation integrated, and the work of the damper.

use std::f64::consts::{LN_2, PI};

use dalembert_core::Worksheet;
use dalembert_mechanics::{Real, vibration::free::FreeMotion};
use dalembert_numerics::quadrature::integral;

use super::form::FreeResponse;

/// The most parts of a quadrature.
const PARTS: f64 = 4000.0;

/// The envelope at the start, from the motion an eighth of a cycle later, or as soon as it has fallen to `1/e`: near
/// critical damping a cycle is so long that nothing is left.
pub(super) fn amplitude<W: Worksheet>(form: &FreeResponse<W::Num>, motion: &FreeMotion, sheet: W) {
    let Some(size) = form.size() else { return };
    let rate = motion.damping_ratio * motion.natural_frequency;
    let time = (PI / 4.0 / motion.damped_frequency()).min(1.0 / rate.abs());
    if let Some(squared) = envelope_squared(motion, time) {
        let grown = (2.0 * rate * time).exp();
        sheet.check(
            "envelope at the start: from the motion a little later, by integration of its equation",
            size.powi(2),
            W::Num::from(squared * grown),
        );
    }
}

/// The displacement at the first turning point.
pub(super) fn turning<W: Worksheet>([time, displacement]: [W::Num; 2], motion: &FreeMotion, sheet: W) {
    if let Some([x, _]) = motion.integrated(time.value()) {
        sheet.check_sum(
            "displacement at the first turning point, by integration of the equation of motion",
            displacement,
            W::Num::from(x),
            size(motion, time.value()),
        );
    }
}

/// The time in which the envelope has fallen.
pub(super) fn settling_of_envelope<W: Worksheet>(time: W::Num, level: W::Num, motion: &FreeMotion, sheet: W) {
    if let Some(squared) = envelope_squared(motion, time.value()) {
        sheet.check(
            "envelope at its settling time, by integration of the equation of motion",
            W::Num::from(squared),
            level.powi(2),
        );
    }
}

/// The energy that is gone, by the work of the damper.
pub(super) fn energy_lost<W: Worksheet>(
    [start, lost]: [W::Num; 2],
    mass: W::Num,
    time: f64,
    motion: &FreeMotion,
    sheet: W,
) {
    let (natural, zeta) = (motion.natural_frequency, motion.damping_ratio);
    let parts = (2.0 * natural * time * (1.0 + 2.0 * zeta.abs())).ceil().max(1.0);
    if parts.is_nan() || parts > PARTS {
        return;
    }
    let squared_rate = |at: f64| motion.state(at)[1].powi(2);
    let work = 2.0 * zeta * natural * mass.value() * integral(squared_rate, [0.0, time], parts as u32);
    sheet.check_sum(
        "energy dissipated = work of the damper, ∫cv²dt by quadrature",
        lost,
        W::Num::from(work),
        start.value().max((start - lost).value()),
    );
}

/// The time to double, by the area of the phase plane that a bundle of motions covers (Liouville).
pub(super) fn doubling<W: Worksheet>(time: W::Num, motion: &FreeMotion, sheet: W) {
    let natural = motion.natural_frequency;
    let from = |displacement: f64, velocity: f64| {
        FreeMotion { displacement, velocity, ..*motion }.integrated(time.value())
    };
    if let (Some([x1, v1]), Some([x2, v2])) = (from(1.0, 0.0), from(0.0, natural)) {
        sheet.check_sum(
            "neighbouring motions cover four times the phase-plane area at the doubling time",
            W::Num::from((x1 * v2 - x2 * v1) / natural),
            W::Num::from((2.0 * LN_2).exp()),
            (x1 * v2 / natural).abs().max(4.0),
        );
    }
}

/// The square of the envelope that a motion has at a time.
fn envelope_squared(motion: &FreeMotion, time: f64) -> Option<f64> {
    let [x, v] = motion.integrated(time)?;
    let rate = motion.damping_ratio * motion.natural_frequency;
    Some(x * x + ((v + rate * x) / motion.damped_frequency()).powi(2))
}

/// The size of a motion at a time, or at its start.
fn size(motion: &FreeMotion, time: f64) -> f64 {
    let size = motion.displacement.abs() + motion.velocity.abs() / motion.natural_frequency;
    size * (-motion.damping_ratio * motion.natural_frequency * time).exp().max(1.0)
}
