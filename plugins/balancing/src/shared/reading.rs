//! Readings of a vibration: a displacement, a velocity, an acceleration, or the divisions of a scale.

use dalembert_core::{Inputs, MeasuredQuantity};

/// Reading of a sensor at a speed.
#[derive(Clone, Debug, Inputs)]
pub struct SensorReading {
    /// Amplitude.
    /// Of the component at the speed of rotation; all readings alike, peak, peak to peak or rms. A number without a unit
    /// stands for divisions or volts.
    #[input("A", "um | mm/s | m/s^2 | 1", nonnegative, kind = "Amplitude|Velocity|Acceleration|Ratio")]
    pub amplitude: MeasuredQuantity,
    /// Phase.
    /// As the instrument shows it.
    #[input("φ", "deg")]
    pub phase: f64,
    /// Speed.
    /// Where it is given, every run must have it in the same row.
    #[input("n", "rpm", positive)]
    pub speed: Option<f64>,
}
