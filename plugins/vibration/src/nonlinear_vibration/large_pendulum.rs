//! A pendulum that swings far.

use std::f64::consts::{PI, TAU};

use dalembert_core::{
    About, Analysis, Animation, Axis, Exhibit, Ink, Inputs, Plot, Refusal, Series, Sketch, Worksheet,
    register,
};
use dalembert_mechanics::Real;
use dalembert_numerics::elliptic;

use crate::sources::{ABRAMOWITZ, NAYFEH, RAO};

/// A mass on a rod without mass, released at rest.
#[derive(Clone, Debug, Inputs)]
pub struct LargePendulum {
    /// Length.
    /// From the pivot to the mass; for a rigid body J/(m s), its equivalent length.
    #[input("L", "m", positive)]
    pub length: f64,
    /// Release angle.
    /// From the lowest position; at 180° it would remain at rest.
    #[input("θ₀", "deg", positive, below = 180)]
    pub amplitude: f64,
    /// Acceleration of gravity.
    #[input("g", "m/s^2", positive, default = "9.81 m/s^2")]
    pub gravity: f64,
    /// Instant.
    /// If given, the angle and the angular velocity at this time after release are also computed.
    #[input("t", "s", nonnegative)]
    pub instant: Option<f64>,
}

register!(LargePendulum);

impl Analysis for LargePendulum {
    const ABOUT: About = About {
        id: "vibration/large-pendulum",
        title: "Pendulum of large amplitude",
        topic: "Nonlinear vibration",
        summary: "Exact period and motion of a pendulum at any amplitude, compared with the small-angle value and the series.",
        main: &["period", "angle"],
        keywords: "nonlinear elliptic integral pêndulo grandes amplitudes não linear período simple pendulum \
                   large amplitudes pêndulo simples",
        sources: &[&NAYFEH, &RAO, &ABRAMOWITZ],
        cases: include_str!("../../cases/large_pendulum.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &LargePendulumGiven<W>, sheet: W) -> Result<(), Refusal> {
        let LargePendulumGiven { length, amplitude, gravity, instant, .. } = given;
        let small = sheet.step(
            "ω₀",
            "rad/s",
            (*gravity / *length).sqrt(),
            ("Angular frequency of small oscillations", RAO.at("§2.3")),
        );
        let small_period = sheet.step(
            "T₀",
            "s",
            W::Num::from(TAU) / small,
            "Period of small oscillations, independent of the amplitude",
        );
        let modulus = sheet.step(
            "κ",
            "1",
            (*amplitude / 2.0).sin(),
            ("Modulus of the elliptic integral of the quarter period", NAYFEH.at("§2.1")),
        );
        // agm(1, cos θ₀/2), written out: it doubles its digits with every line.
        let mut arithmetic = W::Num::from(1.0);
        let mut geometric = sheet.step(
            ("b", 1),
            "1",
            (*amplitude / 2.0).cos(),
            "Arithmetic–geometric mean of 1 and cos(θ₀/2)",
        );
        for n in 2..=9 {
            if (arithmetic.value() - geometric.value()).abs() <= 1e-15 {
                break;
            }
            let mean = sheet.step(("a", n), "1", (arithmetic + geometric) / 2.0, "Arithmetic mean");
            geometric = sheet.step(("b", n), "1", (arithmetic * geometric).sqrt(), "Geometric mean");
            arithmetic = mean;
        }
        sheet.common_error("T", "the series in the amplitude cut after its first correction", || {
            small_period * (W::Num::from(1.0) + amplitude.powi(2) / 16.0)
        });
        let period = sheet.step(
            "T",
            "s",
            small_period / arithmetic,
            ("Period: that of small oscillations over the mean", ABRAMOWITZ.at("§17.6")),
        );
        sheet.common_error("ΔT", "the difference taken relative to the small-angle period", || {
            (period - small_period) / small_period
        });
        let excess =
            sheet.step("ΔT", "%", (period - small_period) / period, "Deficit of the small-angle value");
        let series = sheet.step(
            "T₂",
            "s",
            small_period
                * (W::Num::from(1.0) + amplitude.powi(2) / 16.0 + amplitude.powi(4) * (11.0 / 3072.0)),
            ("First terms of the series in the amplitude", NAYFEH.at("§2.1")),
        );
        sheet.common_error("Ω", "the harmonic motion of small oscillations assumed", || *amplitude * small);
        let fastest = sheet.step(
            "Ω",
            "rad/s",
            small * modulus * 2.0,
            "Angular velocity at the lowest position, from ½ L² Ω² = g L (1 − cos θ₀)",
        );
        sheet.verify(|| {
            sheet.check(
                "period by quadrature of dt = dθ/θ′, with sin(θ/2) = κ sin φ and tan φ = sinh u",
                W::Num::from(quadrature(self.amplitude, small.value())),
                period,
            );
            sheet.check(
                "angular velocity at the lowest position from the loss of height",
                (*gravity / *length * (W::Num::from(1.0) - amplitude.cos()) * 2.0).sqrt(),
                fastest,
            );
            // K = π/2 (1 + κ²/4 + 9κ⁴/64 + …), and κ² = θ₀²/4 − θ₀⁴/48 + ….
            let square = amplitude.powi(2) / 4.0 - amplitude.powi(4) / 48.0;
            let terms = [W::Num::from(1.0), square / 4.0, amplitude.powi(4) * (9.0 / 1024.0)];
            sheet.check(
                "series in the amplitude from that of the elliptic integral in the modulus",
                W::Num::from(TAU) / small * W::Num::sum(terms),
                series,
            );
        });
        sheet.answer("period", "Period", period);
        sheet.answer("small_angle_period", "Period of small oscillations", small_period);
        sheet.answer("shortfall", "Deficit of the small-angle period", excess);
        sheet.answer("series_period", "Period by the series", series);
        sheet.answer("largest_angular_velocity", "Maximum angular velocity", fastest);
        if let (Some(t), Some(instant)) = (self.instant, instant) {
            let (angle, rate) = self.motion(t);
            sheet.common_error("θ", "the harmonic motion of small oscillations assumed", || {
                *amplitude * (small * *instant).cos()
            });
            sheet.common_error("θ", "a harmonic motion with the exact period assumed", || {
                *amplitude * (W::Num::from(TAU) * *instant / period).cos()
            });
            let angle = sheet.numerical(
                "θ",
                "deg",
                angle,
                ("sin(θ/2) = κ sn(K(κ) + ω₀ t), with Jacobi's function sn", ABRAMOWITZ.at("§16.4")),
            );
            sheet.common_error("θ′", "the harmonic motion of small oscillations assumed", || {
                -(*amplitude * small * (small * *instant).sin())
            });
            let rate = sheet.numerical("θ′", "rad/s", rate, "θ′ = 2 κ ω₀ cn(K(κ) + ω₀ t)");
            sheet.check_zero(
                "energy at the instant is that at the start",
                rate.powi(2) / 2.0 - *gravity / *length * (angle.cos() - amplitude.cos()),
                fastest.value().powi(2),
            );
            let turns = sheet.step("n", "1", *instant / period, "Elapsed periods");
            sheet.answer("angle", "Angle at the instant", angle);
            sheet.answer("angular_velocity", "Angular velocity at the instant", rate);
            sheet.answer("swings", "Periods until the instant", turns);
        }
        let (period, small_period) = (period.value(), small_period.value());
        sheet.show(|| Exhibit::Plot(self.swing(period, small_period)));
        sheet.show(|| Exhibit::Plot(self.period_over_amplitude(period)));
        sheet.show(|| Exhibit::Animation(self.animation(period)));
        Ok(())
    }
}

impl LargePendulum {
    /// Angle and angular velocity, from rest at the amplitude.
    fn motion(&self, time: f64) -> (f64, f64) {
        let (modulus, small) = ((self.amplitude / 2.0).sin(), (self.gravity / self.length).sqrt());
        let quarter = elliptic::complete(modulus);
        // The same instant of the first period: the argument stays small.
        let (sn, cn, _) = elliptic::jacobi(quarter + (small * time).rem_euclid(4.0 * quarter), modulus);
        (2.0 * (modulus * sn).clamp(-1.0, 1.0).asin(), 2.0 * modulus * small * cn)
    }

    fn swing(&self, period: f64, small_period: f64) -> Plot {
        let times = (0..=300).map(|n| 2.0 * period * f64::from(n) / 300.0);
        let exact = times.clone().map(|t| (t, self.motion(t).0)).collect();
        let small = times.map(|t| (t, self.amplitude * (TAU * t / small_period).cos())).collect();
        Plot::new(
            "Angle against time",
            Axis::linear("time", "s"),
            Axis::linear("angle", "deg"),
            vec![Series::line("exact", exact).of("angle"), Series::line("as for small angles", small)],
        )
        .over("instant")
    }

    fn period_over_amplitude(&self, period: f64) -> Plot {
        let small = TAU * (self.length / self.gravity).sqrt();
        let at = |n: u32| {
            let amplitude = PI * f64::from(n) / 181.0;
            (amplitude, small / elliptic::agm(1.0, (amplitude / 2.0).cos()))
        };
        Plot::new(
            "Period against amplitude",
            Axis::linear("amplitude", "deg"),
            Axis::linear("period", "s"),
            vec![Series::line("T", (0..=180).map(at).collect()).of("period")],
        )
        .over("amplitude")
        .mark("at this amplitude", (self.amplitude, period))
        .level("small oscillations", small)
    }

    fn animation(&self, period: f64) -> Animation {
        const FRAMES: u32 = 24;
        let frame = |n: u32| {
            let (angle, _) = self.motion(period * f64::from(n) / f64::from(FRAMES));
            let end = (angle.sin(), -angle.cos());
            let swing = (-PI / 2.0 - self.amplitude, self.amplitude - PI / 2.0);
            let mut sketch = Sketch::default();
            sketch
                .arc((0.0, 0.0), 1.0, swing, Ink::Faint)
                .axis((0.0, 0.0), (0.0, -1.0))
                .link("", (0.0, 0.0), end)
                .hung_pin("", (0.0, 0.0))
                .disc("", end, 0.08)
                .line("L", (0.0, 0.0), end, Ink::Body)
                .angle("θ", (0.0, 0.0), -PI / 2.0, angle - PI / 2.0)
                .axis((0.0, 0.0), (1.15 * self.amplitude.sin(), -1.15 * self.amplitude.cos()))
                .label("θ₀", (1.15 * self.amplitude.sin(), -1.15 * self.amplitude.cos()));
            sketch
        };
        Sketch::animation("The oscillation", (0..FRAMES).map(frame), 2.0)
    }
}

/// `T = (4/ω₀) ∫₀^{π/2} dφ/√(1 − κ² sin²φ) = (4/ω₀) ∫₀^∞ du/√(1 + k′² sinh²u)` with `tan φ = sinh u` and
/// `k′ = cos(θ₀/2)`, as good near the top as for small swings.
fn quadrature(amplitude: f64, small: f64) -> f64 {
    const STEP: f64 = 0.05;
    // The integrand, smooth and even in u, falls as 2 e^(−u)/k′: the trapezoidal rule has every digit.
    let complement = (amplitude / 2.0).cos();
    let last = (40.0 - complement.ln()) / STEP;
    let at = |n: u32| 1.0f64.hypot(complement * (STEP * f64::from(n)).sinh()).recip();
    4.0 / small * STEP * (0.5 + (1..=last as u32).map(at).sum::<f64>())
}
