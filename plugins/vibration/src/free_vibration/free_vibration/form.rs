//! The free motion as textbooks write it, one form for each regime.

use std::f64::consts::PI;

use dalembert_core::Worksheet;
use dalembert_mechanics::{Real, sdof, vibration::free::FreeMotion};

use crate::{shared::decay::damped_frequency_error, sources::RAO};

/// The units and symbols of a motion along a line or about an axis.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) struct Units {
    pub(super) symbol: &'static str,
    pub(super) velocity_symbol: &'static str,
    pub(super) acceleration_symbol: &'static str,
    pub(super) displacement: &'static str,
    pub(super) velocity: &'static str,
    pub(super) acceleration: &'static str,
    pub(super) damping: &'static str,
}

impl Units {
    pub(super) const TRANSLATION: Units = Units {
        symbol: "x",
        velocity_symbol: "v",
        acceleration_symbol: "a",
        displacement: "mm",
        velocity: "m/s",
        acceleration: "m/s^2",
        damping: "N*s/m",
    };
    pub(super) const ROTATION: Units = Units {
        symbol: "θ",
        velocity_symbol: "Ω",
        acceleration_symbol: "α",
        displacement: "deg",
        velocity: "rad/s",
        acceleration: "rad/s^2",
        damping: "N*m*s/rad",
    };
}

/// `ζ²` this near to one counts as one: the double root then gives the motion to rounding.
const DOUBLE: f64 = 1e-12;

/// The free motion, by the roots of its characteristic equation.
pub(super) enum FreeResponse<N> {
    /// `x₀ cos ωₙt + B sin ωₙt`
    Harmonic { natural: N, x0: N, v0: N, b: N, size: N },
    /// `e^(−ζωₙt) (x₀ cos ω_d t + B sin ω_d t)`
    Oscillating { natural: N, zeta: N, damped: N, x0: N, v0: N, b: N, size: N },
    /// `(x₀ + B t) e^(−ζωₙt)`, `ζ = ±1`
    Double { natural: N, zeta: N, x0: N, v0: N, b: N },
    /// `C₁ e^(λ₁t) + C₂ e^(λ₂t)`
    Exponentials { natural: N, zeta: N, roots: [N; 2], shares: [N; 2] },
}

impl<N: Real> FreeResponse<N> {
    /// The form of a motion, with the steps that lead to its constants.
    pub(super) fn of<W: Worksheet<Num = N>>(
        natural: N,
        zeta: N,
        [x0, v0]: [N; 2],
        units: &Units,
        sheet: W,
    ) -> Self {
        let z = zeta.value();
        if z == 0.0 {
            let period = sheet.step(
                "T",
                "s",
                N::from(2.0) * PI / natural,
                ("Without damping the motion is harmonic; its period", RAO.at("§2.2")),
            );
            sheet.answer("period", "Period", period);
            let b = sheet.step(
                "B",
                units.displacement,
                v0 / natural,
                "Sine coefficient, from the initial velocity",
            );
            let size = sheet.step(
                "X",
                units.displacement,
                (x0.powi(2) + b.powi(2)).sqrt(),
                ("Amplitude: constant", RAO.at("§2.2")),
            );
            sheet.answer("amplitude", "Amplitude", size);
            return FreeResponse::Harmonic { natural, x0, v0, b, size };
        }
        if ((z - 1.0) * (z + 1.0)).abs() < DOUBLE {
            let b = sheet.step(
                "B",
                units.velocity,
                v0 + zeta * natural * x0,
                ("Critically damped, ζ = 1: a double root −ζωₙ, and the motion is (A + B t) e^(−ζωₙt) with A the initial displacement", RAO.at("§2.6")),
            );
            return FreeResponse::Double { natural, zeta, x0, v0, b };
        }
        if z.abs() < 1.0 {
            return Self::oscillating(natural, zeta, [x0, v0], units, sheet);
        }
        let one = N::from(1.0);
        let spread = (zeta.powi(2) - one).sqrt();
        let why = ("Overdamped, ζ > 1: two real roots, here the larger in magnitude", RAO.at("§2.6"));
        let product = ("The product of the roots is ωₙ²", RAO.at("§2.6"));
        // The root without cancellation first, the other from their product.
        let roots = if z > 0.0 {
            let fast = sheet.step("λ₂", "1/s", -natural * (zeta + spread), why);
            [sheet.step("λ₁", "1/s", natural.powi(2) / fast, product), fast]
        } else {
            let why = "Strongly negative damping, ζ < −1: two real roots, both positive; here the larger";
            let fast = sheet.step("λ₁", "1/s", natural * (spread - zeta), why);
            [fast, sheet.step("λ₂", "1/s", natural.powi(2) / fast, product)]
        };
        sheet.check("the sum of the roots is −2ζωₙ", roots[0] + roots[1], -(zeta * natural * 2.0));
        sheet.answer("slow_root", "Slower root", roots[0]);
        sheet.answer("fast_root", "Faster root", roots[1]);
        let share = (
            "Constant of the motion C₁ e^(λ₁t) + C₂ e^(λ₂t), from the initial displacement and velocity",
            RAO.at("§2.6"),
        );
        let first = sheet.step("C₁", units.displacement, (v0 - roots[1] * x0) / (roots[0] - roots[1]), share);
        let second = sheet.step(
            "C₂",
            units.displacement,
            (roots[0] * x0 - v0) / (roots[0] - roots[1]),
            "The other constant",
        );
        FreeResponse::Exponentials { natural, zeta, roots, shares: [first, second] }
    }

    fn oscillating<W: Worksheet<Num = N>>(
        natural: N,
        zeta: N,
        [x0, v0]: [N; 2],
        units: &Units,
        sheet: W,
    ) -> Self {
        let why = if zeta.value() > 0.0 {
            (
                "Underdamped, ζ < 1: complex roots −ζωₙ ± i ω_d, a decaying oscillation with frequency",
                RAO.at("§2.6"),
            )
        } else {
            (
                "Negative damping, −1 < ζ < 0: complex roots −ζωₙ ± i ω_d, a growing oscillation of frequency",
                RAO.at("§2.6"),
            )
        };
        let one = N::from(1.0);
        damped_frequency_error("ω_d", natural, zeta, sheet);
        let damped = sheet.step("ω_d", "rad/s", sdof::damped_frequency(natural, zeta), why);
        let undamped = || N::from(2.0) * PI / natural;
        sheet.common_error("T_d", "the period without damping used", undamped);
        let period = sheet.step("T_d", "s", N::from(2.0) * PI / damped, "Period of the damped motion");
        let light = || zeta * 2.0 * PI;
        sheet.common_error("δ", "2π times the damping ratio taken, as for light damping", light);
        let decrement = sheet.step(
            "δ",
            "1",
            sdof::decrement_from_damping_ratio(zeta),
            ("Logarithmic decrement", RAO.at("§2.6.3")),
        );
        sheet.check("the decrement is ζ ωₙ T_d", zeta * natural * period, decrement);
        sheet.answer("damped_frequency", "Damped natural frequency", damped);
        sheet.answer("period", "Period", period);
        sheet.answer("decrement", "Logarithmic decrement", decrement);
        if zeta.value() > 0.0 {
            let light = || decrement * 2.0;
            sheet.common_error("ψ", "twice the decrement taken, as for light damping", light);
            let of_amplitude = || one - (-decrement).exp();
            sheet.common_error("ψ", "the loss of amplitude taken for that of energy", of_amplitude);
            let lost = sheet.step(
                "ψ",
                "%",
                N::from(1.0) - (-(decrement * 2.0)).exp(),
                (
                    "Fraction of the energy lost per cycle: the energy is proportional to the square of the amplitude",
                    RAO.at("§2.6.4"),
                ),
            );
            sheet.answer("energy_loss", "Energy lost per cycle", lost);
            let overshoot = sheet.step(
                "s",
                "%",
                (-(decrement / 2.0)).exp(),
                "Overshoot of a release from rest: fraction of the amplitude left after half a cycle",
            );
            sheet.answer("overshoot", "Overshoot of a release from rest", overshoot);
            sheet.verify(|| cycle(zeta, lost, overshoot, sheet));
        }
        let over_natural = || (v0 + zeta * natural * x0) / natural;
        sheet.common_error("B", "the natural frequency used in place of the damped one", over_natural);
        let b = sheet.step(
            "B",
            units.displacement,
            (v0 + zeta * natural * x0) / damped,
            ("Sine coefficient, from the initial displacement and velocity", RAO.at("§2.6")),
        );
        let size = sheet.step(
            "X",
            units.displacement,
            (x0.powi(2) + b.powi(2)).sqrt(),
            ("Initial amplitude of the envelope", RAO.at("§2.6")),
        );
        sheet.answer("amplitude", "Initial amplitude of the envelope", size);
        FreeResponse::Oscillating { natural, zeta, damped, x0, v0, b, size }
    }

    /// `x(t)`.
    pub(super) fn displacement(&self, t: N) -> N {
        match *self {
            FreeResponse::Harmonic { natural, x0, b, .. } => {
                x0 * (natural * t).cos() + b * (natural * t).sin()
            }
            FreeResponse::Oscillating { natural, zeta, damped, x0, b, .. } => {
                (-(zeta * natural * t)).exp() * (x0 * (damped * t).cos() + b * (damped * t).sin())
            }
            FreeResponse::Double { natural, zeta, x0, b, .. } => (x0 + b * t) * (-(zeta * natural * t)).exp(),
            FreeResponse::Exponentials { roots, shares, .. } => {
                shares[0] * (roots[0] * t).exp() + shares[1] * (roots[1] * t).exp()
            }
        }
    }

    /// `v(t)`.
    pub(super) fn velocity(&self, t: N) -> N {
        match *self {
            FreeResponse::Harmonic { natural, x0, v0, .. } => {
                v0 * (natural * t).cos() - natural * x0 * (natural * t).sin()
            }
            FreeResponse::Oscillating { natural, zeta, damped, x0, v0, b, .. } => {
                (-(zeta * natural * t)).exp()
                    * (v0 * (damped * t).cos() - (damped * x0 + zeta * natural * b) * (damped * t).sin())
            }
            FreeResponse::Double { natural, zeta, v0, b, .. } => {
                (v0 - zeta * natural * b * t) * (-(zeta * natural * t)).exp()
            }
            FreeResponse::Exponentials { roots, shares, .. } => {
                shares[0] * roots[0] * (roots[0] * t).exp() + shares[1] * roots[1] * (roots[1] * t).exp()
            }
        }
    }

    /// `ẍ(t)`, with the square of each root.
    pub(super) fn second_derivative(&self, t: N) -> N {
        match *self {
            FreeResponse::Harmonic { natural, x0, b, .. } => {
                -(natural.powi(2) * x0 * (natural * t).cos()) - natural.powi(2) * b * (natural * t).sin()
            }
            FreeResponse::Oscillating { natural, zeta, damped, x0, b, .. } => {
                let rate = zeta * natural;
                let (cosine, sine) = ((damped * t).cos(), (damped * t).sin());
                (-(rate * t)).exp()
                    * ((rate.powi(2) - damped.powi(2)) * (x0 * cosine + b * sine)
                        + rate * damped * 2.0 * (x0 * sine - b * cosine))
            }
            FreeResponse::Double { natural, zeta, x0, b, .. } => {
                let rate = zeta * natural;
                (rate.powi(2) * (x0 + b * t) - rate * b * 2.0) * (-(rate * t)).exp()
            }
            FreeResponse::Exponentials { roots, shares, .. } => {
                shares[0] * roots[0].powi(2) * (roots[0] * t).exp()
                    + shares[1] * roots[1].powi(2) * (roots[1] * t).exp()
            }
        }
    }

    /// Size of the oscillation at the start, where there is one.
    pub(super) fn size(&self) -> Option<N> {
        match *self {
            FreeResponse::Oscillating { size, .. } | FreeResponse::Harmonic { size, .. } => Some(size),
            _ => None,
        }
    }

    /// Records the common error of the largest displacement.
    pub(super) fn maximum_errors<W: Worksheet<Num = N>>(&self, sheet: W) {
        let FreeResponse::Oscillating { natural, x0, v0, .. } = *self else { return };
        let undamped = || (x0.powi(2) + (v0 / natural).powi(2)).sqrt();
        sheet.common_error("Xₘₐₓ", "the damping neglected", undamped);
    }

    /// Square of the envelope at a state: `x² + ((v + ζωₙ x)/ω_d)²`, once the motion oscillates.
    pub(super) fn radius_squared(&self, [x, v]: [N; 2]) -> N {
        match *self {
            FreeResponse::Oscillating { natural, zeta, damped, .. } => {
                x.powi(2) + ((v + zeta * natural * x) / damped).powi(2)
            }
            FreeResponse::Harmonic { natural, .. } => x.powi(2) + (v / natural).powi(2),
            FreeResponse::Double { .. } | FreeResponse::Exponentials { .. } => N::from(f64::NAN),
        }
    }

    /// Displacement, velocity and acceleration at the asked time, written down.
    pub(super) fn state<W: Worksheet<Num = N>>(&self, t: N, units: &Units, sheet: W) -> [N; 3] {
        let [x, v, a] = [units.symbol, units.velocity_symbol, units.acceleration_symbol];
        self.errors(t, units, sheet);
        let x = sheet.step(
            x,
            units.displacement,
            self.displacement(t),
            ("Displacement at the requested time", RAO.at("§2.6")),
        );
        let v = sheet.step(v, units.velocity, self.velocity(t), "Velocity at that time: its derivative");
        let acceleration = match *self {
            FreeResponse::Harmonic { natural, .. } => -(natural.powi(2) * x),
            FreeResponse::Oscillating { natural, zeta, .. }
            | FreeResponse::Double { natural, zeta, .. }
            | FreeResponse::Exponentials { natural, zeta, .. } => {
                -(natural.powi(2) * x) - zeta * natural * v * 2.0
            }
        };
        let a = sheet.step(
            a,
            units.acceleration,
            acceleration,
            "Acceleration at that time, from the equation of motion",
        );
        [x, v, a]
    }

    /// Records the common errors of displacement and velocity at the asked time.
    fn errors<W: Worksheet<Num = N>>(&self, t: N, units: &Units, sheet: W) {
        let (x, v) = (units.symbol, units.velocity_symbol);
        match *self {
            FreeResponse::Harmonic { natural, size, .. } => {
                let what = "the motion assumed to start at its maximum, without a phase angle";
                sheet.common_error(x, what, || size * (natural * t).cos());
                sheet.common_error(v, what, || -(size * natural * (natural * t).sin()));
            }
            FreeResponse::Oscillating { natural, zeta, damped, x0, v0, b, size } => {
                let undamped = FreeResponse::Harmonic { natural, x0, v0, b: v0 / natural, size };
                sheet.common_error(x, "the damping neglected", || undamped.displacement(t));
                sheet.common_error(v, "the damping neglected", || undamped.velocity(t));
                let decay = || (-(zeta * natural * t)).exp();
                let at_natural = || decay() * (x0 * (natural * t).cos() + b * (natural * t).sin());
                sheet.common_error(x, "the natural frequency used in place of the damped one", at_natural);
                let rate = || decay() * damped * (b * (damped * t).cos() - x0 * (damped * t).sin());
                sheet.common_error(v, "the exponential not differentiated", rate);
            }
            FreeResponse::Double { .. } | FreeResponse::Exponentials { .. } => {}
        }
    }

    /// The envelope at a time, where there is one.
    pub(super) fn envelope<W: Worksheet<Num = N>>(&self, t: N, units: &Units, sheet: W) -> Option<N> {
        let FreeResponse::Oscillating { natural, zeta, x0, size, .. } = *self else { return None };
        let from_start = || x0.abs() * (-(zeta * natural * t)).exp();
        sheet.common_error("X_t", "the envelope assumed to start at the initial displacement", from_start);
        let envelope = size * (-(zeta * natural * t)).exp();
        Some(sheet.step(
            "X_t",
            units.displacement,
            envelope,
            ("Envelope at the requested time", RAO.at("§2.6")),
        ))
    }

    /// Time at which the envelope has decayed to a level.
    pub(super) fn settling_of_envelope<W: Worksheet<Num = N>>(&self, level: N, sheet: W) -> Option<N> {
        let FreeResponse::Oscillating { natural, zeta, size, .. } = *self else { return None };
        let rule = || N::from(4.0) / (zeta * natural);
        sheet.common_error("tₑ", "the rule of thumb for the settling time used, 4/(ζωₙ)", rule);
        let decimal = || (size / level).log10() / (zeta * natural);
        sheet.common_error("tₑ", "the logarithm to base 10 used in place of the natural one", decimal);
        let time = (size / level).ln() / (zeta * natural);
        Some(sheet.step(
            "tₑ",
            "s",
            time,
            "Time for the envelope to decay to the fraction p of the maximum displacement",
        ))
    }

    /// The first passage through rest; only asked where there is one.
    pub(super) fn first_zero<W: Worksheet<Num = N>>(&self, sheet: W) -> N {
        let why = "First passage through the equilibrium position";
        let time = match *self {
            FreeResponse::Harmonic { natural, x0, b, .. } => turn(phase(x0, b, sheet), natural),
            FreeResponse::Oscillating { damped, x0, b, .. } => turn(phase(x0, b, sheet), damped),
            FreeResponse::Double { x0, b, .. } => -(x0 / b),
            FreeResponse::Exponentials { roots, shares, .. } => {
                (-(shares[1] / shares[0])).ln() / (roots[0] - roots[1])
            }
        };
        if let FreeResponse::Harmonic { natural: w, .. } | FreeResponse::Oscillating { damped: w, .. } = *self
        {
            sheet.common_error("t₀", "a quarter of a period taken", || N::from(PI) / w / 2.0);
        }
        sheet.step("t₀", "s", time, why)
    }

    /// The first turning point; only asked where there is one.
    pub(super) fn first_turning<W: Worksheet<Num = N>>(&self, sheet: W) -> N {
        let why = "First instant at which the velocity is zero";
        let time = match *self {
            FreeResponse::Harmonic { natural, x0, v0, .. } => {
                turn(phase_of_velocity(v0, -(natural * x0), sheet), natural)
            }
            FreeResponse::Oscillating { natural, zeta, damped, x0, v0, b, .. } => {
                turn(phase_of_velocity(v0, -(damped * x0 + zeta * natural * b), sheet), damped)
            }
            FreeResponse::Double { natural, zeta, v0, b, .. } => v0 / (zeta * natural * b),
            FreeResponse::Exponentials { roots, shares, .. } => {
                (-(shares[1] * roots[1] / (shares[0] * roots[0]))).ln() / (roots[0] - roots[1])
            }
        };
        if let FreeResponse::Harmonic { natural: w, .. } | FreeResponse::Oscillating { damped: w, .. } = *self
        {
            sheet.common_error(("t", 1), "a quarter of a period taken", || N::from(PI) / w / 2.0);
        }
        sheet.step(("t", 1), "s", time, why)
    }
}

/// The phase `φ` that makes `a cos y + b sin y = R sin(y + φ)`.
fn phase<W: Worksheet>(a: W::Num, b: W::Num, sheet: W) -> W::Num {
    sheet.step(
        "φ",
        "rad",
        a.atan2(b),
        "Written as R sin(ωt + φ), it is zero where ωt + φ is a multiple of π; here φ",
    )
}

/// The phase of the velocity, likewise.
fn phase_of_velocity<W: Worksheet>(a: W::Num, b: W::Num, sheet: W) -> W::Num {
    sheet.step("φᵥ", "rad", a.atan2(b), "The velocity written in the same form; its phase")
}

/// The first time at which `y + φ`, `y = ωt > 0`, is a multiple of `π`.
fn turn<N: Real>(phase: N, frequency: N) -> N {
    match phase.value() {
        PI => N::from(PI) / frequency,
        0.0..PI => (N::from(PI) - phase) / frequency,
        _ => -phase / frequency,
    }
}

/// A release from rest: what is left of it half a cycle later and after a whole one.
fn cycle<W: Worksheet>(zeta: W::Num, lost: W::Num, overshoot: W::Num, sheet: W) {
    let motion =
        FreeMotion { natural_frequency: 1.0, damping_ratio: zeta.value(), displacement: 1.0, velocity: 0.0 };
    let half = PI / motion.damped_frequency();
    if let Some([across, _]) = motion.integrated(half) {
        sheet.check_sum(
            "a release from rest: the displacement half a cycle later, by integration of the equation of motion",
            overshoot,
            W::Num::from(-across),
            1.0,
        );
    }
    if let Some([x, v]) = motion.integrated(2.0 * half) {
        sheet.check_sum(
            "a release from rest: the energy a cycle later, by integration of the equation of motion",
            W::Num::from(1.0) - lost,
            W::Num::from(x * x + v * v),
            1.0,
        );
    }
}
