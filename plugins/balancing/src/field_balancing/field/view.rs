//! The rotor as it is seen: rotation, mark and sensors, for pictures and for spots on the rotor.

use dalembert_core::{Inputs, Refusal, Text, Worksheet};
use dalembert_mechanics::{Real, balance};
use nalgebra::Complex;
use std::f64::consts::{FRAC_PI_2, TAU};

use super::{WeightSense, readings::WorkedReading};

/// The rotor as it is seen.
#[derive(Clone, Debug, Inputs)]
pub struct RotorView {
    /// Rotation.
    /// As seen from the drive end.
    pub rotation: Rotation,
    /// Viewed from.
    pub end: RotorEnd,
    /// Angle of the reference mark.
    /// On the scale of the weights: zero where that scale begins at the mark.
    #[input("θ_m", "deg", default = "0 deg")]
    pub mark: f64,
    /// Sensors.
    /// One for each reading of the initial run, in the same order; omit them where their positions are not needed.
    #[input("ψ")]
    pub sensors: Vec<SensorPosition>,
}

/// The sense of rotation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum Rotation {
    /// Clockwise
    Clockwise,
    /// Counter-clockwise
    Counterclockwise,
}

/// The end from which a rotor is seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum RotorEnd {
    /// Drive end
    Drive,
    /// Opposite end
    Opposite,
}

/// The place of a sensor around the shaft.
#[derive(Clone, Debug, Inputs)]
pub struct SensorPosition {
    /// Angle of the sensor.
    /// From the pickup of the mark, in the direction of rotation.
    #[input("ψ", "deg", default = "0 deg")]
    pub angle: f64,
}

impl RotorView {
    /// The direction on the screen of an angle on the scale of the weights, rad counter-clockwise from the right: the scale
    /// begins at the top.
    pub(super) fn on_screen(&self, angles: WeightSense, angle: f64) -> f64 {
        let turns_clockwise = (self.rotation == Rotation::Clockwise) == (self.end == RotorEnd::Drive);
        let grows_clockwise = turns_clockwise == (angles == WeightSense::With);
        if grows_clockwise { FRAC_PI_2 - angle } else { FRAC_PI_2 + angle }
    }

    /// The same of a vector by its components on the scale.
    pub(super) fn seen(&self, angles: WeightSense, vector: Complex<f64>) -> Complex<f64> {
        Complex::from_polar(vector.norm(), self.on_screen(angles, vector.arg()))
    }
}

/// Writes where each sensor sees the shaft come nearest: the high spots, on the scale of the weights.
///
/// # Errors
/// Sensors that are not as many as the readings.
pub(super) fn high_spots<W: Worksheet>(
    view: &RotorView,
    given: &RotorViewGiven<W>,
    (first, opposed, angles): (&[WorkedReading<W::Num>], bool, WeightSense),
    sheet: W,
) -> Result<(), Refusal> {
    if !view.sensors.is_empty() && view.sensors.len() != first.len() {
        return Err(Refusal::because(
            Text::new(
                "{have} sensor positions are given and {want} readings in the initial run; enter one for each, or none",
            )
            .with("have", view.sensors.len())
            .with("want", first.len()),
        ));
    }
    for (n, (reading, sensor)) in (1..).zip(first.iter().zip(&given.sensors)) {
        if reading.amplitude.value() == 0.0 {
            continue;
        }
        let phase = if opposed { -reading.phase } else { reading.phase };
        let with = angles == WeightSense::With;
        let place = if with { given.mark + sensor.angle + phase } else { given.mark - sensor.angle + phase };
        let why = "High spot: the phase from the mark, turned to where the sensor is";
        let spot = sheet.step(("θ_h", n), "deg", balance::marked_angle(place), why);
        sheet.answer(("high_spot", n), "High spot under sensor", spot);
        sheet.verify(|| {
            // When the reading peaks, the mark has gone on from its pickup by the phase; the spot is then at the sensor.
            let mark = if with { -phase } else { phase };
            let from_mark = if with { spot - given.mark } else { given.mark - spot };
            let apart = mark + from_mark - sensor.angle;
            let turns = (apart.value() / TAU).round();
            sheet.check_zero(
                "the high spot is at the sensor when the reading peaks",
                apart - TAU * turns,
                TAU,
            );
        });
    }
    Ok(())
}

/// Writes the physical direction of a weight: its angle from the mark in the direction of rotation.
pub(super) fn from_mark<W: Worksheet>(
    given: &RotorViewGiven<W>,
    angles: WeightSense,
    (plane, angle): (usize, W::Num),
    sheet: W,
) {
    let apart = if angles == WeightSense::With { angle - given.mark } else { given.mark - angle };
    let why = "From the mark in the direction of rotation, whichever way the scale of the weights goes";
    let from = sheet.step(("θ_r", plane), "deg", balance::marked_angle(apart), why);
    sheet.answer(
        ("from_mark", plane),
        "Angle of the correction from the mark, with the rotation, plane",
        from,
    );
    sheet.verify(|| {
        let again = if angles == WeightSense::With { given.mark + from } else { given.mark - from };
        let apart = again - angle;
        let turns = (apart.value() / TAU).round();
        sheet.check_zero("mark and angle from it give the angle on the scale", apart - TAU * turns, TAU);
    });
}
