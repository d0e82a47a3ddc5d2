//! Damping of the oscillations of a gyrocompass, and how long it takes to settle.

use std::f64::consts::TAU;

use dalembert_core::{Axis, Exhibit, Inputs, Plot, Refusal, Series, Worksheet};
use dalembert_mechanics::{Real, sdof};
use dalembert_numerics::{
    linalg,
    ode::{self, OdeFunction},
};
use nalgebra::DMatrix;

/// Damping of small oscillations about the settled direction.
#[derive(Clone, Debug, Inputs)]
pub struct CompassDamping {
    /// Damping.
    pub measure: CompassDampingMeasure,
    /// Deviation at the start, at rest.
    #[input("α_A", "deg", positive, below = 180)]
    pub start: f64,
    /// Deviation taken as settled.
    #[input("α_s", "deg", positive, default = "1 deg")]
    pub settled: f64,
}

/// Known quantity of the damping.
#[derive(Clone, Debug, Inputs)]
pub enum CompassDampingMeasure {
    /// Damping ratio
    Ratio {
        /// Damping ratio.
        #[input("ζ", "1", positive, below = 1)]
        ratio: f64,
    },
    /// Logarithmic decrement
    Decrement {
        /// Logarithmic decrement.
        #[input("δ_d", "1", positive)]
        decrement: f64,
    },
    /// Ratio of successive swings
    /// Of amplitudes on opposite sides, half a period apart.
    Swings {
        /// Later amplitude over the one before it.
        #[input("r", "1", positive, below = 1)]
        ratio: f64,
    },
    /// Viscous damping about the vertical
    /// For an axle held level.
    Viscous {
        /// Damping coefficient.
        #[input("c", "N*m*s/rad", positive)]
        coefficient: f64,
    },
}

/// Answers the damped oscillation with an undamped period; the transverse moment of inertia is that of a level axle.
pub(super) fn answer<W: Worksheet>(
    damping: &CompassDampingGiven<W>,
    period: W::Num,
    transverse: Option<W::Num>,
    sheet: W,
) -> Result<(), Refusal> {
    let natural = sheet.step(
        "ω₀",
        "rad/s",
        sdof::angular_frequency(period),
        "Angular frequency of small oscillations without damping",
    );
    let ratio = ratio(&damping.measure, natural, transverse, sheet)?;
    let damped = sheet.step(
        "ω_d",
        "rad/s",
        sdof::damped_frequency(natural, ratio),
        "Angular frequency with damping: α̈ + 2 ζ ω₀ α̇ + ω₀² α = 0",
    );
    let damped_period = sheet.step("T_d", "s", W::Num::from(TAU) / damped, "Damped period");
    let light = || ratio * TAU;
    sheet.common_error("δ_L", "logarithmic decrement of light damping, δ = 2πζ, used", light);
    let decrement = sheet.step(
        "δ_L",
        "1",
        sdof::decrement_from_damping_ratio(ratio),
        "Logarithmic decrement over a whole period",
    );
    let whole = || (-decrement).exp();
    sheet.common_error("r_s", "swings on opposite sides taken as a whole period apart", whole);
    let swings =
        sheet.step("r_s", "1", (-decrement / 2.0).exp(), "Ratio of successive swings, on opposite sides");
    sheet.answer("damping_ratio", "Damping ratio", ratio);
    sheet.answer("damped_period", "Damped period", damped_period);
    sheet.answer("decrement", "Logarithmic decrement", decrement);
    sheet.answer("swing_ratio", "Ratio of successive swings", swings);
    let (start, settled) = (damping.start, damping.settled);
    if settled.value() >= start.value() {
        return Err(Refusal::because(
            "the deviation at the start is not above that taken as settled: write a larger one at the start",
        ));
    }
    let root = (-ratio.powi(2) + 1.0).sqrt();
    let amplitude = sheet.step(
        "A",
        "deg",
        start / root,
        "Amplitude of the envelope A e^(−ζ ω₀ t), from rest at the deviation at the start",
    );
    let decadic = || (amplitude / settled).log10() / (ratio * natural);
    sheet.common_error("t_s", "log₁₀ used in place of the natural logarithm", decadic);
    let two_percent = || W::Num::from(4.0) / (ratio * natural);
    sheet.common_error("t_s", "the rule for settling to within 2%, 4/(ζω₀), used", two_percent);
    let time = sheet.step(
        "t_s",
        "s",
        (amplitude / settled).ln() / (ratio * natural),
        "Settling time: the envelope has come down to the deviation taken as settled",
    );
    sheet.answer("settling_time", "Settling time", time);
    let [zeta, w, a] = [ratio, natural, start].map(Real::value);
    sheet.verify(|| {
        check([zeta, w, a], [damped_period, decrement, swings], [amplitude, settled, time], sheet);
    });
    let (wd, end) = (damped.value(), time.value());
    sheet.show(|| {
        let at = |n: u16| 1.2 * end * f64::from(n) / 400.0;
        let envelope = |t: f64| a / (1.0 - zeta * zeta).sqrt() * (-zeta * w * t).exp();
        let swing = |t: f64| {
            let (sin, cos) = (wd * t).sin_cos();
            a * (-zeta * w * t).exp() * (cos + zeta * w / wd * sin)
        };
        let curve = |of: &dyn Fn(f64) -> f64| (0..=400).map(|n| (at(n), of(at(n)))).collect::<Vec<_>>();
        Exhibit::Plot(
            Plot::new(
                "Settling of the compass",
                Axis::linear("time", "s"),
                Axis::linear("deviation", "deg"),
                vec![Series::line("deviation", curve(&swing)), Series::line("envelope", curve(&envelope))],
            )
            .mark("settled", (end, envelope(end))),
        )
    });
    Ok(())
}

/// The damping ratio.
fn ratio<W: Worksheet>(
    measure: &CompassDampingMeasureGiven<W>,
    natural: W::Num,
    transverse: Option<W::Num>,
    sheet: W,
) -> Result<W::Num, Refusal> {
    let by_decrement = |decrement: W::Num| {
        let light = || decrement / TAU;
        sheet.common_error("ζ", "the formula for light damping, ζ = δ/(2π), used", light);
        let why = "Damping ratio from the logarithmic decrement";
        sheet.step("ζ", "1", sdof::damping_ratio_from_decrement(decrement), why)
    };
    Ok(match measure {
        CompassDampingMeasureGiven::Ratio { ratio } => {
            sheet.step("ζ_d", "1", *ratio * W::Num::from(1.0), "Damping ratio, as given")
        }
        CompassDampingMeasureGiven::Decrement { decrement } => by_decrement(*decrement),
        CompassDampingMeasureGiven::Swings { ratio } => {
            let half = || -ratio.ln();
            sheet.common_error("δ_d", "swings on opposite sides taken as a whole period apart", half);
            let decadic = || -ratio.log10() * 2.0;
            sheet.common_error("δ_d", "log₁₀ used in place of the natural logarithm", decadic);
            let why = "Logarithmic decrement: two swings make up a period";
            by_decrement(sheet.step("δ_d", "1", -ratio.ln() * 2.0, why))
        }
        CompassDampingMeasureGiven::Viscous { coefficient } => {
            let Some(transverse) = transverse else {
                return Err(Refusal::because(
                    "a pendulous compass is not damped about the vertical alone: give the damping ratio, the decrement or the ratio of successive swings",
                ));
            };
            let why = "Damping ratio: c = 2 ζ I_t ω₀";
            let ratio = sheet.step("ζ", "1", *coefficient / (transverse * natural * 2.0), why);
            if ratio.value() >= 1.0 {
                return Err(Refusal::because(
                    "with this damping the axle is overdamped and approaches its settled direction without oscillation: write a smaller coefficient",
                ));
            }
            ratio
        }
    })
}

/// The roots of the characteristic equation, and the motion by integration.
fn check<W: Worksheet>(
    [zeta, w, start]: [f64; 3],
    [period, decrement, swings]: [W::Num; 3],
    [amplitude, settled, time]: [W::Num; 3],
    sheet: W,
) {
    let matrix = DMatrix::from_row_slice(2, 2, &[0.0, 1.0, -1.0, -2.0 * zeta]);
    if let Ok(values) = linalg::complex_eigenvalues(&matrix)
        && let Some(root) = values.iter().find(|value| value.im > 0.0)
    {
        sheet.check("the damped period from the characteristic roots", period, (TAU / (root.im * w)).into());
        sheet.check(
            "the logarithmic decrement from the characteristic roots",
            decrement,
            (-TAU * root.re / root.im).into(),
        );
        let other = (amplitude.value() / settled.value()).ln() / (-root.re * w);
        sheet.check("the settling time from the characteristic roots", time, other.into());
    }
    let mut problem = OdeFunction {
        rates: |_: f64, state: &[f64], rates: &mut [f64]| {
            rates.copy_from_slice(&[state[1], -2.0 * zeta * state[1] - state[0]]);
        },
        relative: 1e-13,
        absolute: 1e-15 * start,
    };
    let half = period.value() * w / 2.0;
    if let Ok(states) = ode::states(&mut problem, &[start, 0.0], &[0.0, half], 100_000)
        && let Some(end) = states.last()
    {
        let what = "the ratio of successive swings by integration over half a damped period";
        sheet.check_residual(what, (swings.value() + end[0] / start).into(), 1.0, 1e-11);
    }
}
