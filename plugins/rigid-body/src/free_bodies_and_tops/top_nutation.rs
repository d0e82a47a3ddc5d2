//! Nutation of a heavy top released with any motion.

use std::f64::consts::TAU;

use dalembert_core::{
    About, Analysis, Axis, Exhibit, Ink, Inputs, Plot, Refusal, Series, Text, Worksheet, register,
};
use dalembert_mechanics::{
    Real,
    rigid::top::{self, Nutation, Top, TopError, Trace},
};
use nalgebra::{Rotation3, Vector3};

use crate::{
    shared::{
        scene::{self, Scene},
        top_body::TopBody,
    },
    sources::{BEER, GOLDSTEIN},
};

/// The top and the motion it is released with.
///
/// Precession φ about the vertical, θ from the upward vertical to the axis, spin ψ about the axis; all positive
/// counter-clockwise seen from the tip of their axis.
#[derive(Clone, Debug, Inputs)]
pub struct TopNutation {
    /// The top.
    pub body: TopBody,
    /// Angle of the axis to the vertical at the start.
    /// From the upward vertical: 90° with the axis level, more for a hanging top.
    #[input("θ₀", "deg", positive, below = 180)]
    pub nutation: f64,
    /// Angular velocity of the axis away from the vertical at the start.
    #[input("θ̇₀", "rad/s", default = "0 rad/s")]
    pub nutation_rate: f64,
    /// Precession at the start.
    /// Zero for a top released with its axis at rest.
    #[input("φ̇₀", "rad/s", default = "0 rad/s")]
    pub precession: f64,
    /// Given.
    pub spin: TopSpin,
    /// Instant.
    /// If given, the attitude at this time after the start is also calculated.
    #[input("t", "s", nonnegative)]
    pub instant: Option<f64>,
}

/// Known quantity of the spin.
#[derive(Clone, Debug, Inputs)]
pub enum TopSpin {
    /// Angular velocity about the axis
    AxialVelocity {
        /// Angular velocity about the axis.
        /// Spin plus the axial component of the precession, ψ̇ + φ̇ cos θ: constant for any motion of the axis.
        #[input("ω₃", "rad/s")]
        axial_velocity: f64,
    },
    /// Spin relative to the axis at the start
    Spin {
        /// Spin at the start.
        /// Relative to the frame that precesses with the axis.
        #[input("ψ̇₀", "rad/s")]
        spin: f64,
    },
}

/// Sine of an angle to the vertical below which the precession has few digits.
const NEAR_VERTICAL: f64 = 1e-3;

mod turned;

register!(TopNutation);

impl Analysis for TopNutation {
    const ABOUT: About = About {
        id: "rigid-body/top-nutation",
        title: "Heavy top: nutation",
        topic: "Free bodies and tops",
        summary: "A heavy top released with any initial motion: limits and period of its nutation, mean precession, cusps, loops or waves, and the attitude at an instant.",
        main: &["highest", "lowest", "nutation_period", "mean_precession"],
        keywords: "gyroscope spinning top nutation cusp loop pião giroscópio nutação cúspide laço potencial efetivo",
        sources: &[&GOLDSTEIN, &BEER],
        cases: include_str!("../../cases/top_nutation.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &TopNutationGiven<W>, sheet: W) -> Result<(), Refusal> {
        let moments = given.body.moments(sheet)?;
        let Some(transverse) = moments.transverse else {
            return Err(Refusal::because(
                "nutation needs the transverse moment of inertia: give it about the fixed point or the centre of mass",
            ));
        };
        let (axial, couple) = (moments.axial, moments.couple);
        let (theta, theta_rate, phi_rate) = (given.nutation, given.nutation_rate, given.precession);
        let axial_velocity = match &given.spin {
            TopSpinGiven::AxialVelocity { axial_velocity } => *axial_velocity,
            TopSpinGiven::Spin { spin } => sheet.step(
                "ω₃",
                "rad/s",
                top::axial_velocity(*spin, phi_rate, theta),
                (
                    "Angular velocity about the axis: spin plus the component of the precession",
                    BEER.at("§18.3"),
                ),
            ),
        };
        if let TopSpinGiven::Spin { spin } = given.spin {
            sheet.common_error("H₃", "I_a multiplied by the spin alone, without the precession", || {
                axial * spin
            });
        }
        let own = sheet.step(
            "H₃",
            "kg*m^2/s",
            axial * axial_velocity,
            (
                "Angular momentum about the axis: the weight has no moment about it, so it is conserved",
                GOLDSTEIN.at("§5-7"),
            ),
        );
        let vertical = sheet.step(
            "H_z",
            "kg*m^2/s",
            transverse * phi_rate * theta.sin().powi(2) + own * theta.cos(),
            (
                "Angular momentum about the vertical: the weight has no moment about it either",
                GOLDSTEIN.at("§5-7"),
            ),
        );
        sheet.common_error("E", "the kinetic energy of the rotation about the axis included", || {
            let across = theta_rate.powi(2) + (phi_rate * theta.sin()).powi(2);
            (transverse * across + own * axial_velocity) / 2.0 + couple * theta.cos()
        });
        let energy = sheet.step(
            "E",
            "J",
            transverse * (theta_rate.powi(2) + (phi_rate * theta.sin()).powi(2)) / 2.0
                + couple * theta.cos(),
            (
                "Energy excluding that of the spin, ½ I_a ω₃², which is conserved separately; heights from the fixed point",
                GOLDSTEIN.at("§5-7"),
            ),
        );
        let body = Top { axial: axial.value(), transverse: transverse.value(), couple: couple.value() };
        let motion = body
            .released(self.nutation, self.nutation_rate, self.precession, axial_velocity.value())
            .map_err(refused)?;
        let trace = motion.trace();
        let [high, low] = motion.limits();
        let high = sheet.numerical(
            "θ₁",
            "deg",
            high,
            (
                "Highest position of the axis. There θ̇ = 0: with u = cos θ, (E − K u)(1 − u²) = (H_z − H₃ u)²/(2 I_t), a cubic in u",
                GOLDSTEIN.at("§5-7"),
            ),
        );
        if self.nutation_rate == 0.0 && self.precession == 0.0 {
            sheet.common_error("θ₂", "the nutation taken as that of a fast top", || {
                theta + transverse * couple * theta.sin() * 2.0 / own.powi(2)
            });
        }
        let low =
            sheet.numerical("θ₂", "deg", low, "Lowest position of the axis: the next zero of the cubic");
        let third = sheet.numerical(
            "u₃",
            "1",
            motion.third_zero(),
            "Third zero of the cubic, above 1, to which no real angle corresponds",
        );
        sheet.answer("highest", "Highest position of the axis, angle to the vertical", high);
        sheet.answer("lowest", "Lowest position of the axis, angle to the vertical", low);
        sheet.answer("third_zero", "Third zero of the cubic in cos θ", third);
        let [rate_high, rate_low] = motion.precession_at_limits();
        // Beside the vertical the quotient has few digits; the kernel keeps them.
        let rate_at = |symbol, angle: W::Num, by_kernel: f64, why: &'static str| {
            if angle.value().sin() > NEAR_VERTICAL {
                let rate = (vertical - own * angle.cos()) / (transverse * angle.sin().powi(2));
                sheet.step(symbol, "rad/s", rate, why)
            } else {
                sheet.numerical(symbol, "rad/s", by_kernel, why)
            }
        };
        let rate_high = rate_at(
            "φ̇₁",
            high,
            rate_high,
            match trace {
                Trace::Steady => "Precession: θ is constant, the top precesses steadily",
                Trace::Wave => {
                    "Precession at the highest position. It has the same sign at the lowest position: the axis traces waves"
                }
                Trace::Cusp => {
                    "Precession at the highest position. The axis is momentarily at rest there: it traces cusps"
                }
                Trace::Loop => {
                    "Precession at the highest position. It has the opposite sign at the lowest position: the axis traces loops"
                }
            },
        );
        let rate_low = rate_at("φ̇₂", low, rate_low, "Precession at the lowest position");
        sheet.answer(
            "precession_at_highest",
            match trace {
                Trace::Steady => "Precession (steady)",
                Trace::Wave => "Precession at the highest position: waves",
                Trace::Cusp => "Precession at the highest position: cusps",
                Trace::Loop => "Precession at the highest position: loops",
            },
            rate_high,
        );
        sheet.answer("precession_at_lowest", "Precession at the lowest position", rate_low);
        let argument_rate = sheet.step(
            "p",
            "rad/s",
            (couple * (third - low.cos()) / (transverse * 2.0)).sqrt(),
            "Rate of the elliptic-function argument: cos θ varies as sn²(p t) between its limits",
        );
        let quarter = sheet.numerical(
            "K_k",
            "1",
            motion.period() * argument_rate.value() / 2.0,
            Text::new("Complete elliptic integral of the first kind, of the modulus k = √((u₁ − u₂)/(u₃ − u₂)) = {k}")
                .with_quantity("k", motion.modulus(), "1"),
        );
        sheet.common_error("T_n", "the formula for fast tops, 2π I_t/(I_a ω₃), used", || {
            transverse * TAU / own.abs()
        });
        sheet.common_error("T_n", "a harmonic motion assumed, with the period π/p", || {
            W::Num::from(TAU) / (argument_rate * 2.0)
        });
        let period = sheet.step(
            "T_n",
            "s",
            quarter * 2.0 / argument_rate,
            "Period of the nutation: time from one lowest position to the next",
        );
        let frequency = sheet.step("f_n", "Hz", W::Num::from(TAU) / period, "Its frequency");
        let advance = sheet.numerical(
            "Δφ",
            "deg",
            motion.advance(),
            "Precession angle per nutation: φ̇ integrated over time, two elliptic integrals of the third kind",
        );
        sheet.common_error("Ω", "the steady precession of a fast top, m g l/(I_a ω₃), used", || {
            couple / own
        });
        sheet.common_error("Ω", "the mean of the precessions at the two limits taken", || {
            (rate_high + rate_low) / 2.0
        });
        let mean = sheet.step("Ω", "rad/s", advance / period, "Mean precession");
        sheet.answer("nutation_period", "Period of the nutation", period);
        sheet.answer("nutation_frequency", "Frequency of the nutation", frequency);
        sheet.answer("advance", "Precession angle per nutation", advance);
        sheet.answer("mean_precession", "Mean precession", mean);
        sheet.answer("axial_angular_momentum", "Angular momentum about the axis", own);
        sheet.answer("vertical_angular_momentum", "Angular momentum about the vertical", vertical);
        sheet.answer("energy", "Energy excluding that of the spin", energy);
        sheet.verify(|| {
            let (start, argument_rate) = (motion.at(0.0), argument_rate.value());
            for time in [period.value(), TAU / frequency.value()] {
                let end = motion.at(time);
                let off = (end.nutation - start.nutation)
                    .hypot((end.nutation_rate - start.nutation_rate) / argument_rate);
                sheet.check_zero("angle and its rate after one nutation", off.into(), 1.0);
            }
            let turned = motion.at(period.value()).precession;
            let about = 1.0 + turned.abs();
            let what = "precession after one nutation at its mean rate";
            sheet.check_sum(what, mean * period, turned.into(), about);
        });
        let shown = [high, low, third, advance].map(Real::value);
        self.check(&motion, body, [own, vertical, energy].map(Real::value), shown, sheet);
        for (limit, rate) in [(high, rate_high), (low, rate_low)] {
            let sin = limit.value().sin();
            // Through the vertical the axis goes on.
            if sin <= NEAR_VERTICAL {
                continue;
            }
            let largest = (own.value().powi(2) + vertical.value().powi(2)) / (2.0 * body.transverse);
            sheet.check_sum(
                "the energy at a limit, where all of it is in the precession and the height",
                transverse * (rate * limit.sin()).powi(2) / 2.0 + couple * limit.cos(),
                energy,
                body.couple + largest / sin.powi(2),
            );
        }
        if let Some(t) = self.instant {
            at_instant(&motion, t, body, [own, vertical, energy].map(Real::value), sheet);
        }
        let invariants = [own, vertical, energy].map(Real::value);
        sheet.show(|| Exhibit::Plot(self.potential(&motion, body, invariants)));
        sheet.show(|| Exhibit::Plot(over_time(&motion)));
        sheet.show(|| Exhibit::Plot(precession_over_time(&motion)));
        sheet.show(|| Exhibit::Plot(from_above(&motion)));
        sheet.show(|| self.animation(&motion));
        Ok(())
    }
}

impl TopNutation {
    fn check<W: Worksheet>(
        &self,
        motion: &Nutation,
        body: Top,
        [own, vertical, energy]: [f64; 3],
        [high, low, third, shown_advance]: [f64; 4],
        sheet: W,
    ) {
        sheet.verify(|| {
            let scale = energy.abs().max(body.couple);
            for limit in [high, low] {
                let (sin, cos) = limit.sin_cos();
                let across = vertical - own * cos;
                let left = 2.0 * body.transverse * (energy - body.couple * cos) * sin * sin;
                sheet.check_zero(
                    "the limit substituted into the cubic",
                    W::Num::from(left - across * across),
                    2.0 * body.transverse * scale + vertical * vertical + own * own,
                );
            }
            // The zeros of the cubic sum up to its second coefficient.
            let sum = high.cos() + low.cos() + third;
            let expected = energy / body.couple + own * own / (2.0 * body.transverse * body.couple);
            sheet.check_zero(
                "the sum of the three zeros, E/K + H₃²/(2 I_t K)",
                W::Num::from(sum - expected),
                expected.abs().max(1.0),
            );
            let start = motion.at(0.0);
            sheet.check_zero(
                "the angle at the start by the elliptic functions",
                W::Num::from(start.nutation - self.nutation),
                self.nutation.max(1e-3),
            );
            if let Some([advance, error]) = by_equal_weights(motion, body, own, vertical) {
                sheet.check_residual(
                    "the precession angle per nutation by equal-weight quadrature",
                    (advance - shown_advance).into(),
                    advance.abs().max(motion.period() * motion.precession_at_limits()[1].abs()),
                    error,
                );
            }
        });
    }

    /// The effective potential `(H_z − H₃ cos θ)²/(2 I_t sin²θ) + K cos θ` beside the energy.
    fn potential(&self, motion: &Nutation, body: Top, [own, vertical, energy]: [f64; 3]) -> Plot {
        let [high, low] = motion.limits();
        let margin = (0.6 * (low - high)).max(0.1);
        let (from, to) = ((high - margin).max(0.01), (low + margin).min(std::f64::consts::PI - 0.01));
        let at = |theta: f64| {
            let (sin, cos) = theta.sin_cos();
            ((vertical - own * cos) / sin).powi(2) / (2.0 * body.transverse) + body.couple * cos
        };
        let points = (0..=240).map(|n| from + (to - from) * f64::from(n) / 240.0).map(|x| (x, at(x)));
        Plot::new(
            "Effective potential against the angle of the axis",
            Axis::linear("angle to the vertical", "deg"),
            Axis::linear("energy", "J"),
            vec![Series::line("effective potential", points.collect())],
        )
        .level("energy", energy)
        .mark("highest", (high, at(high.max(1e-6))))
        .mark("lowest", (low, at(low.min(std::f64::consts::PI - 1e-6))))
    }
}

fn at_instant<W: Worksheet>(motion: &Nutation, t: f64, body: Top, invariants: [f64; 3], sheet: W) {
    let [own, vertical, energy] = invariants;
    let at = motion.at(t);
    let theta = sheet.numerical(
        "θ",
        "deg",
        at.nutation,
        ("cos θ = u₂ + (u₁ − u₂) sn² p(t − t₂), from the lowest position on", GOLDSTEIN.at("§5-7")),
    );
    let theta_rate = sheet.numerical("θ̇", "rad/s", at.nutation_rate, "Its rate of change");
    let phi = sheet.numerical(
        "φ",
        "deg",
        at.precession,
        "Precession since the start, by elliptic integrals of the third kind",
    );
    let phi_rate =
        sheet.numerical("φ̇", "rad/s", at.precession_rate, "Its rate of change, (H_z − H₃ cos θ)/(I_t sin²θ)");
    let psi = sheet.numerical(
        "ψ",
        "deg",
        at.spin,
        "Spin since the start: ω₃ t less the contributions of the precession",
    );
    sheet.answer("angle", "Angle to the vertical at the instant", theta);
    sheet.answer("angle_rate", "Its rate of change at the instant", theta_rate);
    sheet.answer("precession_angle", "Precession since the start", phi);
    sheet.answer("precession_rate", "Precession at the instant", phi_rate);
    sheet.answer("spin_angle", "Spin since the start", psi);
    sheet.verify(|| {
        let [angle, angle_rate, rate] = [theta, theta_rate, phi_rate].map(Real::value);
        let (sin, cos) = angle.sin_cos();
        let kinetic = body.transverse * (angle_rate.powi(2) + (rate * sin).powi(2)) / 2.0;
        // At the vertical φ̇ has no value.
        if sin > 1e-4 {
            sheet.check_zero(
                "energy at the instant is that at the start",
                W::Num::from(kinetic + body.couple * cos - energy),
                energy.abs().max(body.couple) + kinetic + own * own / body.transverse,
            );
        }
        let scale = (vertical.abs() + own.abs()).max(f64::MIN_POSITIVE);
        sheet.check_zero(
            "the angular momentum about the vertical is that at the start",
            W::Num::from(if sin > 1e-4 {
                body.transverse * rate * sin * sin + own * cos - vertical
            } else {
                0.0
            }),
            scale,
        );
        turned::check(motion, body, t, [own, vertical], [theta, theta_rate, phi, psi], sheet);
    });
}

/// `∫ φ̇ dt` over a nutation with `u = u₂ + (u₁ − u₂) sin²χ`; not where the axis comes near the vertical, or the period
/// near infinity. With it the error of its rounding: beside the vertical, `H_z − H₃ u` and `1 − u²` are small
/// differences of numbers near each other.
fn by_equal_weights(motion: &Nutation, body: Top, own: f64, vertical: f64) -> Option<[f64; 2]> {
    const POINTS: u32 = 4000;
    let [high, low] = motion.limits();
    let (upper, lower, third) = (high.cos(), low.cos(), motion.third_zero());
    let even = |a: f64, b: f64| a > 1e-3 * b;
    let fair = even(1.0 - upper, 1.0 - lower)
        && even(1.0 + lower, 1.0 + upper)
        && even(third - upper, third - lower);
    let at = |n: u32| {
        let sine = (std::f64::consts::PI * f64::from(n) / f64::from(POINTS)).sin().powi(2);
        let u = lower + (upper - lower) * sine;
        let across = body.transverse * (1.0 - u * u);
        let argument_rate = (body.couple * (third - u) / (2.0 * body.transverse)).sqrt();
        let rate = (vertical - own * u) / across;
        let lost = (vertical.abs() + own.abs()) / across
            + rate.abs() * (2.0 / (1.0 - u * u) + third.abs() / (third - u));
        [rate / argument_rate, f64::EPSILON * lost / argument_rate]
    };
    let part = std::f64::consts::PI / f64::from(POINTS);
    fair.then(|| (0..POINTS).map(at).fold([0.0; 2], |[a, b], [x, y]| [a + x * part, b + y * part]))
}

fn refused(error: TopError) -> Refusal {
    Refusal::because(match error {
        TopError::Vertical => {
            "the axis starts on the vertical, where precession is not defined: start slightly off it"
        }
        TopError::Asymptotic => {
            "the axis approaches the vertical asymptotically: change the spin or the initial state a little"
        }
        TopError::Body | TopError::NotFinite => {
            "the motion exceeds the numerical range: check the magnitudes of the inputs"
        }
    })
}

/// As many nutations as bring the axis once around, within reason.
fn shown_time(motion: &Nutation) -> f64 {
    let nutations = (TAU / motion.advance().abs()).ceil().clamp(3.0, 12.0);
    nutations * motion.period()
}

fn over_time(motion: &Nutation) -> Plot {
    let shown = 3.0 * motion.period();
    let points = (0..=240).map(|n| shown * f64::from(n) / 240.0).map(|t| (t, motion.at(t).nutation));
    let [high, low] = motion.limits();
    Plot::new(
        "Angle of the axis to the vertical",
        Axis::linear("time", "s"),
        Axis::linear("angle to the vertical", "deg"),
        vec![Series::line("θ", points.collect()).of("angle")],
    )
    .over("instant")
    .level("highest", high)
    .level("lowest", low)
}

fn precession_over_time(motion: &Nutation) -> Plot {
    let shown = 3.0 * motion.period();
    let times = (0..=240).map(|n| shown * f64::from(n) / 240.0);
    Plot::new(
        "Precession angle",
        Axis::linear("time", "s"),
        Axis::linear("angle about the vertical", "deg"),
        vec![
            Series::line("φ", times.clone().map(|t| (t, motion.at(t).precession)).collect())
                .of("precession_angle"),
            Series::line("mean", times.map(|t| (t, motion.advance() * t / motion.period())).collect()),
        ],
    )
    .over("instant")
}

/// The tip of the axis on the unit sphere.
fn tips(motion: &Nutation, parts: u32) -> Vec<Vector3<f64>> {
    let shown = shown_time(motion);
    (0..=parts).map(|n| tip(motion, shown * f64::from(n) / f64::from(parts)).1).collect()
}

/// Attitude and tip of the axis at a time.
fn tip(motion: &Nutation, time: f64) -> (Rotation3<f64>, Vector3<f64>) {
    let at = motion.at(time);
    let turn = Rotation3::from_axis_angle(&Vector3::z_axis(), at.precession)
        * Rotation3::from_axis_angle(&Vector3::x_axis(), at.nutation);
    (turn, turn * Vector3::z())
}

fn from_above(motion: &Nutation) -> Plot {
    Plot::new(
        "Tip of the axis, seen from above",
        Axis::linear("tip along X", "1"),
        Axis::linear("tip along Y", "1"),
        vec![Series::line("tip of a unit axis", tips(motion, 400).into_iter().map(|p| (p.x, p.y)).collect())],
    )
    .equal()
}

impl TopNutation {
    fn animation(&self, motion: &Nutation) -> Exhibit {
        let shown = shown_time(motion);
        let trace = tips(motion, 160);
        scene::animation("Motion of the axis and path of its tip", 8.0, |part| {
            let (turn, axis) = tip(motion, shown * part);
            let mut scene = Scene::new();
            for limit in motion.limits() {
                scene.circle(Vector3::z() * limit.cos(), Vector3::z(), limit.sin(), Ink::Faint);
            }
            scene.line([Vector3::zeros(), Vector3::z() * 1.25], Ink::Faint);
            scene.line(trace.iter().copied(), Ink::Motion);
            self.body.draw(&turn, 0.75, &mut scene);
            scene.line([axis * 0.75, axis], Ink::Body);
            // The letters of the start go on with what they are the start of.
            scene.angle("θ₀", Vector3::zeros(), [Vector3::z(), axis], 0.45);
            let spin = match self.spin {
                TopSpin::AxialVelocity { .. } => "ω₃",
                TopSpin::Spin { .. } => "ψ̇₀",
            };
            scene.turn(spin, axis * 0.95, axis, 0.12, Ink::Motion);
            scene.turn("φ̇₀", Vector3::z() * 1.15, Vector3::z(), 0.12, Ink::Motion);
            let level = Vector3::z().cross(&axis).try_normalize(0.0).unwrap_or_else(Vector3::x);
            scene.line([Vector3::zeros(), level * 0.5], Ink::Faint);
            scene.turn("θ̇₀", level * 0.4, level, 0.12, Ink::Motion);
            scene
        })
    }
}
