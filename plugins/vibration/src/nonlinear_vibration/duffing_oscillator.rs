//! A mass on a spring whose stiffness grows or falls with the square of the displacement.

use std::f64::consts::TAU;

use dalembert_core::{
    About, Analysis, Axis, Cell, Column, Exhibit, Inputs, Plot, Refusal, Series, TableExhibit, Text,
    Worksheet, register,
};
use dalembert_mechanics::{
    Real, sdof,
    vibration::duffing::{self, Duffing, DuffingResponse},
};

mod checks;

use crate::sources::{ABRAMOWITZ, NAYFEH, THOMSON};

/// Duffing's oscillator, free or forced.
#[derive(Clone, Debug, Inputs)]
pub struct DuffingOscillator {
    /// Mass.
    #[input("m", "kg", positive)]
    pub mass: f64,
    /// Stiffness at small displacements.
    #[input("k", "N/m", positive)]
    pub stiffness: f64,
    /// Cubic stiffness coefficient.
    /// The force of the spring is k x + h x³: positive for a hardening spring, negative for a softening one.
    #[input("h", "N/m^3")]
    pub cubic: f64,
    /// Motion.
    pub motion: DuffingMotion,
}

/// Type of motion: free or forced.
#[derive(Clone, Debug, Inputs)]
pub enum DuffingMotion {
    /// Free, released from rest
    Free {
        /// Amplitude.
        #[input("A", "m", positive, kind = "Amplitude")]
        amplitude: f64,
    },
    /// Forced vibration under a harmonic force, with viscous damping
    Forced {
        /// Damping coefficient.
        #[input("c", "N*s/m", positive)]
        damping: f64,
        /// Amplitude of the force.
        #[input("F", "N", positive)]
        force: f64,
        /// Frequency of the force.
        #[input("ω", "rad/s", positive)]
        frequency: f64,
    },
}

register!(DuffingOscillator);

impl Analysis for DuffingOscillator {
    const ABOUT: About = About {
        id: "vibration/duffing-oscillator",
        title: "Duffing oscillator",
        topic: "Nonlinear vibration",
        summary: "Exact free period, or forced amplitudes with backbone curve, jumps and stability, of a mass on a spring with a cubic term.",
        keywords: "nonlinear hardening softening jump backbone harmonic balance oscilador de Duffing não linear salto \
                   balanço harmônico mola cúbica",
        sources: &[&NAYFEH, &THOMSON, &ABRAMOWITZ],
        cases: include_str!("../../cases/duffing_oscillator.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &DuffingOscillatorGiven<W>, sheet: W) -> Result<(), Refusal> {
        let natural = sheet.step(
            "ω₀",
            "rad/s",
            sdof::natural_frequency(given.stiffness, given.mass),
            ("Natural frequency at small amplitudes", NAYFEH.at("§2.1")),
        );
        sheet.answer("natural_frequency", "Natural frequency at small amplitudes", natural);
        sheet.verify(|| {
            let small = Duffing { cubic: 0.0, ..self.undamped() }.free_period_by_quadrature(1.0);
            sheet.check(
                "period at small amplitudes by quadrature of dt = dx/v from the energy",
                W::Num::from(TAU / natural.value()),
                W::Num::from(small),
            );
        });
        match (&self.motion, &given.motion) {
            (DuffingMotion::Free { amplitude: a }, DuffingMotionGiven::Free { amplitude }) => {
                self.free(given, *a, *amplitude, sheet)
            }
            (
                DuffingMotion::Forced { damping: c, force: f, frequency: w },
                DuffingMotionGiven::Forced { damping, force, frequency },
            ) => {
                let oscillator = Duffing { damping: *c, ..self.undamped() };
                self.forced(given, &oscillator, [*f, *w], [*damping, *force, *frequency], sheet)
            }
            _ => unreachable!("what is given is made from what was typed"),
        }
    }
}

impl DuffingOscillator {
    fn undamped(&self) -> Duffing {
        Duffing { mass: self.mass, damping: 0.0, stiffness: self.stiffness, cubic: self.cubic }
    }

    fn free<W: Worksheet>(
        &self,
        given: &DuffingOscillatorGiven<W>,
        a: f64,
        amplitude: W::Num,
        sheet: W,
    ) -> Result<(), Refusal> {
        let oscillator = self.undamped();
        if self.cubic < 0.0 {
            let limit = sheet.step(
                "A_lim",
                "mm",
                (given.stiffness / -given.cubic).sqrt(),
                "Stability limit of a softening spring: beyond it the mass does not return",
            );
            sheet.answer("limit_amplitude", "Amplitude of zero restoring force", limit);
            sheet.check_zero(
                "at that amplitude the spring force is zero",
                given.stiffness * limit + given.cubic * limit.powi(3),
                self.stiffness * limit.value(),
            );
        }
        let Some(exact) = oscillator.free_period(a) else {
            return Err(Refusal::because(
                "at this amplitude the softening spring exerts no restoring force: choose an amplitude below √(k/|h|)",
            ));
        };
        let turn = sheet.step(
            "Ω",
            "rad/s",
            ((given.stiffness + given.cubic * amplitude.powi(2)) / given.mass).sqrt(),
            ("Frequency of the elliptic cosine that satisfies the equation", NAYFEH.at("§2.1")),
        );
        // agm(1, √(1 − κ²)), written out.
        let mut arithmetic = W::Num::from(1.0);
        let mut geometric = sheet.step(
            ("b", 1),
            "1",
            ((given.stiffness + given.cubic * amplitude.powi(2) / 2.0) / (given.mass * turn.powi(2))).sqrt(),
            (
                "√(1 − κ²), κ² = h A²/(2(k + h A²)); arithmetic–geometric mean of 1 and this",
                ABRAMOWITZ.at("§17.6"),
            ),
        );
        for n in 2..=12 {
            if (arithmetic.value() - geometric.value()).abs() <= 1e-15 * arithmetic.value() {
                break;
            }
            let mean = sheet.step(("a", n), "1", (arithmetic + geometric) / 2.0, "Arithmetic mean");
            geometric = sheet.step(("b", n), "1", (arithmetic * geometric).sqrt(), "Geometric mean");
            arithmetic = mean;
        }
        let period = sheet.step(
            "T",
            "s",
            W::Num::from(TAU) / (turn * arithmetic),
            ("Exact period: four quarter periods K(κ)/Ω", NAYFEH.at("§2.1")),
        );
        let frequency = sheet.step("ω", "rad/s", sdof::angular_frequency(period), "Exact frequency");
        sheet.verify(|| {
            sheet.check(
                "period by quadrature of dt = dx/v from the energy",
                W::Num::from(oscillator.free_period_by_quadrature(a)),
                W::Num::from(period.value()),
            );
        });
        sheet.answer("period", "Period", period);
        sheet.answer("frequency", "Frequency", frequency);
        if oscillator.backbone(a).is_some() {
            let balance = sheet.step(
                "ω′",
                "rad/s",
                ((given.stiffness + given.cubic * amplitude.powi(2) * 0.75) / given.mass).sqrt(),
                ("Harmonic balance with one term: x³ ≈ ¾ A³ cos ωt", NAYFEH.at("§2.3")),
            );
            let balance_period =
                sheet.step("T′", "s", W::Num::from(TAU) / balance, "Period by harmonic balance");
            let error = sheet.step(
                "ΔT",
                "%",
                (balance_period - period) / period,
                "Relative error of harmonic balance",
            );
            sheet.answer("balance_period", "Period by harmonic balance", balance_period);
            sheet.verify(|| checks::balance_period(&oscillator, a, balance_period, sheet));
            sheet.answer("balance_error", "Error of harmonic balance", error);
        }
        sheet.show(|| Exhibit::Plot(free_plot(&oscillator, a, exact)));
        sheet.show(|| Exhibit::Plot(backbone_plot(&oscillator, a, exact)));
        Ok(())
    }

    fn forced<W: Worksheet>(
        &self,
        given: &DuffingOscillatorGiven<W>,
        oscillator: &Duffing,
        [f, w]: [f64; 2],
        [damping, force, frequency]: [W::Num; 3],
        sheet: W,
    ) -> Result<(), Refusal> {
        let steady = oscillator.steady(f, w);
        if steady.is_empty() {
            return Err(Refusal::because(
                "no steady-state vibration was found: these values differ too much in magnitude; check the units of h and F",
            ));
        }
        for (n, one) in (1..).zip(&steady) {
            let how = if one.stable {
                "Root of the balance of the first harmonic; stable: a larger amplitude requires a larger force"
            } else {
                "Root of the balance of the first harmonic; unstable: a larger amplitude requires a smaller force, so it jumps away"
            };
            let amplitude = sheet.numerical(("A", n), "mm", one.amplitude, (how, NAYFEH.at("§4.1")));
            let held =
                given.stiffness - given.mass * frequency.powi(2) + given.cubic * amplitude.powi(2) * 0.75;
            // Near resonance the force is a small difference of spring and inertia.
            sheet.verify(|| {
                let size =
                    (self.stiffness + self.mass * w * w + 0.75 * self.cubic.abs() * one.amplitude.powi(2))
                        * one.amplitude;
                sheet.check_zero(
                    "spring, inertia and damper balance the force",
                    (held.powi(2) + (damping * frequency).powi(2)).sqrt() * amplitude - force,
                    size.max(f),
                );
            });
            sheet.answer(("amplitude", n), "Amplitude of the first harmonic", amplitude);
            let lag = sheet.numerical(("φ", n), "deg", one.lag, "The motion lags the force by");
            sheet.answer(("phase", n), "Phase lag", lag);
            sheet.verify(|| {
                let size =
                    (self.stiffness + self.mass * w * w + 0.75 * self.cubic.abs() * one.amplitude.powi(2))
                        * one.amplitude;
                sheet.check_zero(
                    "spring and inertia forces are balanced by the force component in phase with the motion",
                    held * amplitude - force * lag.cos(),
                    size.max(f),
                );
                sheet.check_sum(
                    "work of the force in a cycle = work of the damper, πFA sin φ = πcωA²",
                    force * lag.sin(),
                    damping * frequency * amplitude,
                    size.max(f),
                );
            });
            if let Some(both) = oscillator.two_harmonics(f, w, one) {
                let [_, third] = both.amplitudes();
                let largest = sheet.numerical(
                    ("X", n),
                    "mm",
                    both.amplitude(),
                    (
                        "Maximum displacement with the third harmonic also balanced, by Newton's method",
                        NAYFEH.at("§2.3"),
                    ),
                );
                sheet.answer(
                    ("largest_displacement", n),
                    "Maximum displacement with the third harmonic",
                    largest,
                );
                let third = sheet.numerical(("A‴", n), "mm", third, "Amplitude of the third harmonic");
                sheet.answer(("third_harmonic", n), "Amplitude of the third harmonic", third);
                sheet.verify(|| {
                    checks::two_harmonics(oscillator, [f, w], one.amplitude, &both, [largest, third], sheet);
                });
            }
        }
        if steady.len() > 1 {
            sheet.warn(|| {
                Text::new(
                    "three steady-state vibrations are possible at this frequency: which of the two stable ones occurs depends on how it was reached",
                )
            });
        }
        let peak = oscillator.peak(f);
        if let Some((_, _)) = peak {
            let rest = given.stiffness - damping.powi(2) / (given.mass * 4.0);
            let reach = force.powi(2) * given.mass / damping.powi(2);
            let largest = sheet.step(
                "A_p",
                "mm",
                (reach * 2.0 / (rest + (rest.powi(2) + given.cubic * reach * 3.0).sqrt())).sqrt(),
                (
                    "Maximum amplitude at any frequency, where both frequencies of an amplitude meet: ¾hA⁴ + (k − c²/4m)A² = F²m/c²",
                    NAYFEH.at("§4.1"),
                ),
            );
            let at = sheet.step(
                "ω_p",
                "rad/s",
                ((given.stiffness + given.cubic * largest.powi(2) * 0.75
                    - damping.powi(2) / (given.mass * 2.0))
                    / given.mass)
                    .sqrt(),
                "Its frequency, close to the backbone curve",
            );
            let held = given.stiffness + given.cubic * largest.powi(2) * 0.75 - given.mass * at.powi(2);
            sheet.check(
                "the largest amplitude satisfies the balance of forces",
                (held.powi(2) + (damping * at).powi(2)).sqrt() * largest,
                force,
            );
            sheet.answer("peak_amplitude", "Maximum amplitude at any frequency", largest);
            sheet.answer("peak_frequency", "Frequency of maximum amplitude", at);
        } else {
            sheet.warn(|| {
                Text::new("the response has no maximum amplitude at a frequency above zero: the softening spring loses its restoring force, or the damping is too strong")
            });
        }
        let jumps = oscillator.jumps(f);
        for (n, (at, amplitude)) in (1..).zip(&jumps) {
            let at = sheet.numerical(
                ("ω_J", n),
                "rad/s",
                *at,
                "Vertical tangent of the response curve: jump of the amplitude",
            );
            sheet.answer(("jump_frequency", n), "Frequency of a jump", at);
            let amplitude =
                sheet.numerical(("A_J", n), "mm", *amplitude, "Amplitude at which the jump occurs");
            sheet.answer(("jump_amplitude", n), "Amplitude before the jump", amplitude);
            sheet.verify(|| {
                let hardening = given.cubic * amplitude.powi(2) * 0.75;
                let held = given.stiffness - given.mass * at.powi(2) + hardening;
                let damped = (damping * at).powi(2);
                sheet.check(
                    "at the jump, the spring, inertia and damping forces balance the applied force",
                    (held.powi(2) + damped) * amplitude.powi(2),
                    force.powi(2),
                );
                sheet.check_zero(
                    "at the jump a small change of the amplitude needs no change of the force",
                    held * (held + hardening * 2.0) + damped,
                    damped.value(),
                );
            });
        }
        sheet.show(|| Exhibit::Plot(response_plot(oscillator, f, (w, &steady), &jumps)));
        sheet.show(|| Exhibit::Table(table(&steady)));
        Ok(())
    }
}

fn free_plot(oscillator: &Duffing, amplitude: f64, period: f64) -> Plot {
    let motion = duffing::free_motion(oscillator, amplitude, period, 200);
    let cosine = motion.iter().map(|(t, _)| (*t, amplitude * (TAU * t / period).cos())).collect();
    Plot::new(
        "Displacement over one period",
        Axis::linear("time", "s"),
        Axis::linear("displacement", "mm"),
        vec![Series::line("x", motion), Series::line("cosine of the same period", cosine)],
    )
}

fn backbone_plot(oscillator: &Duffing, amplitude: f64, period: f64) -> Plot {
    let amplitudes = (1..=200).map(|n| 2.0 * amplitude * f64::from(n) / 200.0);
    let exact: Vec<_> =
        amplitudes.clone().filter_map(|a| Some((TAU / oscillator.free_period(a)?, a))).collect();
    let given = exact.iter().map(|(_, a)| *a).collect();
    let balance = amplitudes.filter_map(|a| Some((oscillator.backbone(a)?, a))).collect();
    Plot::new(
        "Backbone: frequency of the free vibration against its amplitude",
        Axis::linear("frequency", "rad/s"),
        Axis::linear("amplitude", "mm"),
        vec![
            Series::line("exact", exact).of("motion.free.amplitude").at(given),
            Series::line("harmonic balance", balance),
        ],
    )
    .over_answer("motion.free.amplitude", "frequency")
    .mark("at this amplitude", (TAU / period, amplitude))
}

fn response_plot(
    oscillator: &Duffing,
    force: f64,
    (at, steady): (f64, &[DuffingResponse]),
    jumps: &[(f64, f64)],
) -> Plot {
    let natural = (oscillator.stiffness / oscillator.mass).sqrt();
    let peak = oscillator.peak(force);
    let reference = peak.map_or(natural, |peak| peak.1);
    let last = 1.4 * reference.max(natural).max(at);
    let first = 0.3 * reference.min(natural).min(at);
    let largest =
        peak.map_or_else(|| steady.iter().fold(0.0, |a: f64, one| a.max(one.amplitude)), |peak| peak.0);
    // Along the amplitude the curve is single-valued on each side of the backbone.
    let amplitude = |n: u32| largest * (std::f64::consts::FRAC_PI_2 * f64::from(n) / 400.0).sin();
    let side = |side: usize| {
        let point = |n: u32| (oscillator.frequencies_of(force, amplitude(n))[side], amplitude(n));
        let inside = |(w, _): &(f64, f64)| w.is_finite() && (first..=last).contains(w);
        (1..=400).map(point).filter(inside).collect::<Vec<_>>()
    };
    let backbone = (0..=200).map(|n| largest * 1.1 * f64::from(n) / 200.0);
    let backbone = backbone
        .filter_map(|a| Some((oscillator.backbone(a)?, a)))
        .filter(|(w, _)| (first..=last).contains(w));
    let mut plot = Plot::new(
        "Amplitude against frequency",
        Axis::linear("frequency of the force", "rad/s"),
        Axis::linear("amplitude", "mm"),
        vec![
            Series::line("below the backbone", side(0)).of("amplitude[*]"),
            Series::line("above the backbone", side(1)).of("amplitude[*]"),
            Series::line("backbone", backbone.collect()),
            Series::dots("at this frequency", steady.iter().map(|one| (at, one.amplitude)).collect())
                .of("amplitude[*]"),
        ],
    )
    .over("motion.forced.frequency");
    for jump in jumps {
        plot = plot.mark("jump", *jump);
    }
    plot
}

fn table(steady: &[DuffingResponse]) -> TableExhibit {
    let row = |one: &DuffingResponse| {
        let word = if one.stable { "stable" } else { "unstable" };
        vec![Cell::from(one.amplitude), Cell::from(one.lag), Cell::from(word)]
    };
    TableExhibit {
        title: "Steady-state vibrations at this frequency".into(),
        columns: vec![
            Column { heading: "amplitude".into(), unit: "mm" },
            Column { heading: "phase lag".into(), unit: "deg" },
            Column { heading: "stability".into(), unit: "" },
        ],
        rows: steady.iter().map(row).collect(),
        foot: Vec::new(),
    }
}
