//! Steady precession of a heavy top.

use std::f64::consts::TAU;

use dalembert_core::{
    About, Analysis, Axis, Exhibit, Ink, Inputs, Plot, Refusal, Series, Text, Worksheet, register,
};
use dalembert_mechanics::{
    Real, Vector,
    rigid::{self, top},
};
use nalgebra::{Rotation3, Vector3};

use crate::{
    shared::{
        scene::{self, Scene},
        top_body::{TopBody, TopMoments},
    },
    sources::{BEER, GOLDSTEIN},
};

/// A top whose axis keeps its angle to the vertical while it goes around it.
///
/// Precession φ about the vertical, θ from the upward vertical to the axis, spin ψ about the axis; all positive
/// counter-clockwise seen from the tip of their axis.
#[derive(Clone, Debug, Inputs)]
pub struct HeavyTop {
    /// The top.
    pub body: TopBody,
    /// Angle of the axis to the vertical.
    /// From the upward vertical: 90° with the axis level, more for a hanging top.
    #[input("θ", "deg", positive, below = 180)]
    pub nutation: f64,
    /// Given.
    pub motion: TopMotion,
}

/// Given rate of a steady motion.
#[derive(Clone, Debug, Inputs)]
pub enum TopMotion {
    /// Spin relative to the precessing axis
    Spin {
        /// Spin.
        /// Relative to the frame that precesses with the axis.
        #[input("ψ̇", "rad/s")]
        spin: f64,
    },
    /// Angular velocity about the axis
    AxialVelocity {
        /// Angular velocity about the axis.
        /// Spin plus the axial component of the precession, ψ̇ + φ̇ cos θ: constant for any motion of the axis.
        #[input("ω₃", "rad/s")]
        axial_velocity: f64,
    },
    /// The required precession
    Precession {
        /// Precession.
        #[input("φ̇", "rad/s")]
        precession: f64,
    },
}

register!(HeavyTop);

/// Below this `|cos θ|` the axis is level and the quadratic linear.
const LEVEL: f64 = 1e-12;

impl Analysis for HeavyTop {
    const ABOUT: About = About {
        id: "rigid-body/heavy-top",
        title: "Heavy top: steady precession",
        topic: "Free bodies and tops",
        summary: "Slow and fast precession of a top under its weight, the required spin, the sleeping threshold, and the fast-top formula compared with the exact one.",
        main: &["slow_precession", "fast_precession", "first_order_precession", "spin"],
        keywords: "gyroscope spinning top precession sleeping pião giroscópio precessão rotação própria steady \
                   precession precessão regular Lagrange top",
        sources: &[&BEER, &GOLDSTEIN],
        cases: include_str!("../../cases/heavy_top.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &HeavyTopGiven<W>, sheet: W) -> Result<(), Refusal> {
        let moments = given.body.moments(sheet)?;
        let theta = given.nutation;
        let Some(transverse) = moments.transverse else {
            return self.to_first_order(given, &moments, sheet);
        };
        let TopMoments { axial, couple, .. } = moments;
        let threshold = sheet.step(
            "ω_s",
            "rad/s",
            top::sleeping_threshold(axial, transverse, couple),
            (
                "Minimum angular velocity about the axis with which the top stays upright: a sleeping top",
                GOLDSTEIN.at("§5-7"),
            ),
        );
        let level = self.nutation.cos().abs() < LEVEL;
        let mut other = None;
        let (spin, axial_velocity, precession) = match &given.motion {
            TopMotionGiven::Precession { precession } => {
                goes_around(*precession)?;
                if !level {
                    sheet.common_error("ψ̇", FAST_TOP, || couple / (axial * *precession));
                    sheet.common_error(
                        "ψ̇",
                        "the spin taken as the whole angular velocity about the axis",
                        || (transverse * *precession * theta.cos() + couple / *precession) / axial,
                    );
                }
                let spin = sheet.step(
                    "ψ̇",
                    "rad/s",
                    top::spin_for(axial, transverse, couple, *precession, theta),
                    ("Spin that maintains this precession: ΣM = Ω × H solved for it", BEER.at("§18.3")),
                );
                let velocity = self.axial_velocity(spin, *precession, theta, "ω₃", sheet);
                sheet.answer("spin", "Spin for this precession", spin);
                sheet.answer("axial_velocity", "Angular velocity about the axis", velocity);
                (spin, velocity, *precession)
            }
            TopMotionGiven::Spin { spin } => {
                let square = sheet.step(
                    "A",
                    "kg*m^2",
                    if level { W::Num::from(0.0) * axial } else { (transverse - axial) * theta.cos() },
                    (
                        "Steady precession: A φ̇² − H φ̇ + K = 0, with A = (I_t − I_a) cos θ and H = I_a ψ̇",
                        BEER.at("§18.3"),
                    ),
                );
                let (slow, fast) = self.roots(square, *spin, &moments, Rate::Spin, sheet)?;
                let slow_velocity = self.axial_velocity(*spin, slow, theta, "ω₃", sheet);
                sheet.answer("axial_velocity", "Angular velocity about the axis", slow_velocity);
                if let Some(fast) = fast {
                    let velocity = self.axial_velocity(*spin, fast, theta, "ω₃′", sheet);
                    sheet.answer(
                        "fast_axial_velocity",
                        "Angular velocity about the axis in fast precession",
                        velocity,
                    );
                    other = Some((velocity, fast));
                }
                (*spin, slow_velocity, slow)
            }
            TopMotionGiven::AxialVelocity { axial_velocity } => {
                if !level {
                    sheet.common_error(
                        "A",
                        "ω₃ taken as the spin relative to the precessing frame",
                        || (transverse - axial) * theta.cos(),
                    );
                }
                let square = sheet.step(
                    "A",
                    "kg*m^2",
                    if level { W::Num::from(0.0) * transverse } else { transverse * theta.cos() },
                    (
                        "Steady precession: A φ̇² − H φ̇ + K = 0, with A = I_t cos θ and H = I_a ω₃",
                        GOLDSTEIN.at("§5-7"),
                    ),
                );
                let (slow, _) = self.roots(square, *axial_velocity, &moments, Rate::Axial, sheet)?;
                let spin = sheet.step(
                    "ψ̇",
                    "rad/s",
                    *axial_velocity - slow * theta.cos(),
                    "Spin in slow precession: ω₃ less the axial component of the precession",
                );
                sheet.answer("spin", "Spin in slow precession", spin);
                (spin, *axial_velocity, slow)
            }
        };
        let lagrange = |velocity: W::Num, precession: W::Num| {
            let momentum = axial * velocity;
            let scale = (momentum.value() * precession.value()).abs()
                + transverse.value() * precession.value().powi(2)
                + couple.value();
            sheet.check_sum(
                "Lagrange's equation of θ with the angular momentum about the axis",
                transverse * theta.cos() * precession.powi(2) + couple,
                momentum * precession,
                scale,
            );
        };
        sheet.verify(|| {
            lagrange(axial_velocity, precession);
            if let Some((velocity, precession)) = other {
                lagrange(velocity, precession);
            }
        });
        self.beside_the_exact([spin, precession, theta], &moments, sheet);
        let period = sheet.step(
            "T_φ",
            "s",
            W::Num::from(TAU) / precession.abs(),
            "Time for one revolution of the axis about the vertical",
        );
        sheet.answer("precession_period", "Precession period", period);
        let ratio = sheet.step("r", "1", axial / transverse, "Ratio of the moments of inertia");
        sheet.common_error("ω_n", "the frequency of a fast top, I_a ω₃/I_t, used", || {
            ratio * axial_velocity
        });
        let nutation = sheet.step(
            "ω_n",
            "rad/s",
            top::nutation_frequency(ratio, axial_velocity, precession, theta),
            (
                "Angular frequency of small nutations about this motion: the second derivative of the effective potential",
                GOLDSTEIN.at("§5-7"),
            ),
        );
        sheet.answer("nutation_frequency", "Angular frequency of small nutations", nutation);
        sheet.answer("sleeping_threshold", "Minimum ω₃ of a sleeping top", threshold);
        sheet.verify(|| {
            // Beside the upright x″ = K x/I_t turned by the spin: two circles of one frequency at the threshold.
            let turning = axial * threshold / (transverse * 2.0);
            sheet.check(
                "equation of small circles about the vertical at the threshold",
                transverse * turning.powi(2) + couple,
                axial * threshold * turning,
            );
            let moments = [axial, transverse, couple].map(Real::value);
            self.small_nutations(moments, axial_velocity.value(), precession.value(), nutation, sheet);
        });
        sheet.verify(|| {
            let frame = W::Vec::from_components(
                W::Num::from(0.0),
                precession * theta.sin(),
                precession * theta.cos(),
            );
            let [_, across, along] = frame.components();
            let momentum = rigid::angular_momentum(
                [transverse, transverse, axial],
                W::Vec::from_components(W::Num::from(0.0), across, along + spin),
            );
            let weight = couple * theta.sin();
            sheet.check_zero(
                "the moment of the weight from the whole Ω × H about the fixed point",
                rigid::transport_rate(frame, momentum).components()[0] - weight,
                (momentum.value().norm() * precession.value().abs()).max(weight.value()),
            );
        });
        let plain = Plainly {
            axial: axial.value(),
            transverse: transverse.value(),
            couple: couple.value(),
            spin: spin.value(),
            precession: precession.value(),
        };
        sheet.show(|| Exhibit::Plot(self.over_spin(&plain)));
        sheet.show(|| self.animation(plain.precession, plain.spin));
        Ok(())
    }
}

const FAST_TOP: &str = "the formula for fast tops used";
const ONE_SINE: &str = "sin θ kept in the moment of the weight alone";

/// Unknown rate of the quadratic equation.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Rate {
    Spin,
    Axial,
}

/// A steady motion in numbers.
struct Plainly {
    axial: f64,
    transverse: f64,
    couple: f64,
    spin: f64,
    precession: f64,
}

impl HeavyTop {
    /// Holds the frequency of small nutations to the slope of the effective potential beside the steady angle.
    fn small_nutations<W: Worksheet>(
        &self,
        [axial, transverse, couple]: [f64; 3],
        axial_velocity: f64,
        precession: f64,
        frequency: W::Num,
        sheet: W,
    ) {
        let (sine, cosine) = self.nutation.sin_cos();
        // Beside the vertical the potential is a small difference of large numbers.
        if sine < 0.05 {
            return;
        }
        let own = axial * axial_velocity;
        let vertical = transverse * precession * sine * sine + own * cosine;
        let slope = |off: f64| {
            let (sine, cosine) = (self.nutation + off).sin_cos();
            let across = (vertical - own * cosine) / (transverse * sine);
            (across * (own * sine * sine - (vertical - own * cosine) * cosine) / (sine * sine)
                - couple * sine)
                / transverse
        };
        let Ok(square) = rigid::numerical_rate(|off| Vector3::new(slope(off), 0.0, 0.0), sine) else {
            return;
        };
        let rates = (own / transverse).abs() + 2.0 * precession.abs();
        let lost = f64::EPSILON * rates.powi(2) / (sine * sine) * 1e3;
        sheet.check_residual(
            "square of the frequency from the slope of the effective potential",
            (frequency.value().powi(2) - square.x).into(),
            rates.powi(2),
            lost,
        );
    }

    fn axial_velocity<W: Worksheet>(
        &self,
        spin: W::Num,
        precession: W::Num,
        theta: W::Num,
        symbol: &'static str,
        sheet: W,
    ) -> W::Num {
        sheet.common_error(
            symbol,
            "the magnitude of ω taken in place of its component along the axis",
            || {
                (top::axial_velocity(spin, precession, theta).powi(2) + (precession * theta.sin()).powi(2))
                    .sqrt()
            },
        );
        sheet.step(
            symbol,
            "rad/s",
            top::axial_velocity(spin, precession, theta),
            ("Angular velocity about the axis: spin plus the component of the precession", BEER.at("§18.3")),
        )
    }

    /// The roots of `A φ̇² − H φ̇ + K = 0`: slow and, unless the axis is level, fast.
    fn roots<W: Worksheet>(
        &self,
        square: W::Num,
        rate: W::Num,
        moments: &TopMoments<W::Num>,
        of: Rate,
        sheet: W,
    ) -> Result<(W::Num, Option<W::Num>), Refusal> {
        let TopMoments { axial, couple, .. } = *moments;
        if rate.value() == 0.0 && square.value() >= 0.0 {
            return Err(Refusal::because(
                "a top that does not spin has no steady precession: it falls; give a spin",
            ));
        }
        let least = (square.value() > 0.0).then(|| {
            sheet.step(
                if of == Rate::Spin { "ψ̇_min" } else { "ω₃_min" },
                "rad/s",
                (square * couple).sqrt() * 2.0 / axial,
                "Minimum rate for a steady precession at this angle: the discriminant H² − 4 A K is zero",
            )
        });
        let momentum = sheet.step("H", "kg*m^2/s", axial * rate, "Its angular momentum about the axis");
        let discriminant = top::discriminant(momentum, square, couple);
        if let Some(least) = least.filter(|_| discriminant.value() < 0.0) {
            let words = match of {
                Rate::Spin => {
                    "the top is too slow for a steady precession at this angle: its spin must be at least {least}"
                }
                Rate::Axial => {
                    "the top is too slow for a steady precession at this angle: ω₃ must be at least {least}"
                }
            };
            return Err(Refusal::because(Text::new(words).with_quantity("least", least.value(), "rad/s")));
        }
        let discriminant = sheet.step("Δ", "kg^2*m^4/s^2", discriminant, "Discriminant of the quadratic");
        let root = if momentum.value() < 0.0 { -discriminant.sqrt() } else { discriminant.sqrt() };
        let root = sheet.step("Q", "kg*m^2/s", root, "Its root, with the sign of H");
        sheet.common_error("φ̇₁", FAST_TOP, || couple / momentum);
        let slow = sheet.step(
            "φ̇₁",
            "rad/s",
            top::slow_precession(couple, momentum, root),
            "Slow precession: the root that stays finite when A vanishes",
        );
        sheet.answer("slow_precession", "Slow precession", slow);
        let fast = (square.value() != 0.0).then(|| {
            sheet
                .common_error("φ̇₂", "the weight neglected in the fast precession", || momentum / square);
            let fast = sheet.step(
                "φ̇₂",
                "rad/s",
                top::fast_precession(square, momentum, root),
                "Fast precession: the other root",
            );
            sheet.answer("fast_precession", "Fast precession", fast);
            fast
        });
        if let Some(least) = least {
            sheet.answer("least_rate", "Minimum rate for a steady precession", least);
            sheet.verify(|| {
                // The rate that a precession needs, (K + A φ̇²)/(I_a φ̇), is least where both terms are alike.
                let needed =
                    |precession: W::Num| (couple + square * precession.powi(2)) / (axial * precession);
                let best = (couple / square).sqrt();
                sheet.check("the rate required by the precession of minimum rate", needed(best), least);
                let beside = needed(best * 0.9).value().min(needed(best * 1.1).value());
                let more = (least.value() - beside).max(0.0);
                sheet.check_zero(
                    "a slightly slower or faster precession requires more",
                    more.into(),
                    least.value(),
                );
            });
        }
        sheet.verify(|| {
            for root in [Some(slow), fast].into_iter().flatten() {
                let terms = [square * root.powi(2), -(momentum * root), couple];
                let scale = terms.iter().map(|term| term.value().abs()).fold(0.0, f64::max);
                sheet.check_zero("the root substituted into the quadratic", W::Num::sum(terms), scale);
            }
        });
        Ok((slow, fast))
    }

    /// The formula for fast tops, and how far it is off.
    fn beside_the_exact<W: Worksheet>(
        &self,
        [spin, precession, theta]: [W::Num; 3],
        moments: &TopMoments<W::Num>,
        sheet: W,
    ) {
        if spin.value() == 0.0 {
            return;
        }
        let first = self.first_order([spin, theta], moments, sheet);
        let error =
            sheet.step("ε", "%", (first - precession) / precession, "Relative error of the fast-top formula");
        sheet.answer("first_order_precession", "Precession by the fast-top formula", first);
        sheet.answer("first_order_error", "Error of the formula for fast tops", error);
        let error = error.value().abs();
        if error > 0.05 {
            sheet.warn(|| {
                Text::new("the top is not fast: the error of the fast-top formula is {error}")
                    .with_quantity("error", error, "%")
            });
        }
    }

    fn first_order<W: Worksheet>(
        &self,
        [spin, theta]: [W::Num; 2],
        moments: &TopMoments<W::Num>,
        sheet: W,
    ) -> W::Num {
        sheet.common_error("φ̇₀", ONE_SINE, || {
            top::first_order_precession(moments.couple * theta.sin(), moments.axial, spin)
        });
        sheet.step(
            "φ̇₀",
            "rad/s",
            top::first_order_precession(moments.couple, moments.axial, spin),
            (
                "Formula for fast tops: the moment K sin θ rotates the component I_a ψ̇ sin θ of the angular momentum, normal to the vertical; the angle cancels",
                BEER.at("§18.3"),
            ),
        )
    }

    /// Without the transverse moment of inertia only the formula for fast tops is left.
    fn to_first_order<W: Worksheet>(
        &self,
        given: &HeavyTopGiven<W>,
        moments: &TopMoments<W::Num>,
        sheet: W,
    ) -> Result<(), Refusal> {
        sheet
            .warn(|| "without the transverse moment of inertia only the fast-top formula can be used".into());
        let (spin, precession) = match &given.motion {
            TopMotionGiven::Spin { spin: rate } | TopMotionGiven::AxialVelocity { axial_velocity: rate } => {
                if rate.value() == 0.0 {
                    return Err(Refusal::because(
                        "a top that does not spin has no steady precession: it falls; give a spin",
                    ));
                }
                let precession = self.first_order([*rate, given.nutation], moments, sheet);
                sheet.answer("first_order_precession", "Precession by the fast-top formula", precession);
                (*rate, precession)
            }
            TopMotionGiven::Precession { precession } => {
                goes_around(*precession)?;
                sheet.common_error("ψ̇", ONE_SINE, || {
                    let weight = moments.couple * given.nutation.sin();
                    top::first_order_precession(weight, moments.axial, *precession)
                });
                let spin = sheet.step(
                    "ψ̇",
                    "rad/s",
                    top::first_order_precession(moments.couple, moments.axial, *precession),
                    "Spin for this precession, by the fast-top formula",
                );
                sheet.answer("spin", "Spin for this precession", spin);
                (spin, *precession)
            }
        };
        let period = sheet.step(
            "T_φ",
            "s",
            W::Num::from(TAU) / precession.abs(),
            "Time for one revolution of the axis about the vertical",
        );
        sheet.answer("precession_period", "Precession period", period);
        sheet.verify(|| {
            // The tip of H, at the radius H sin θ, is moved by the moment of the weight.
            let level = moments.axial * spin * given.nutation.sin();
            sheet.check(
                "the moment of the weight from the motion of the tip of H",
                level * precession,
                moments.couple * given.nutation.sin(),
            );
        });
        let (spin, precession) = (spin.value(), precession.value());
        sheet.show(|| self.animation(precession, spin));
        Ok(())
    }

    /// Both branches against the spin.
    fn over_spin(&self, at: &Plainly) -> Plot {
        let square = (at.transverse - at.axial) * self.nutation.cos();
        let square = if self.nutation.cos().abs() < LEVEL { 0.0 } else { square };
        let least = 2.0 * (square.max(0.0) * at.couple).sqrt() / at.axial;
        let spin = at.spin.abs();
        let most = (2.0 * spin).max(2.0 * least);
        let from = if least > 0.0 { least } else { most / 20.0 };
        let sign = if at.spin < 0.0 { -1.0 } else { 1.0 };
        let (mut slow, mut fast, mut first) = (Vec::new(), Vec::new(), Vec::new());
        for n in 0..=200 {
            // Denser near the threshold, where the branches meet as a parabola does.
            let spin = from + (most - from) * (f64::from(n) / 200.0).powi(2);
            let momentum = at.axial * spin;
            let root = top::discriminant(momentum, square, at.couple).max(0.0).sqrt();
            slow.push((spin, sign * top::slow_precession(at.couple, momentum, root)));
            if square > 0.0 {
                fast.push((spin, sign * top::fast_precession(square, momentum, root)));
            }
            first.push((spin, sign * top::first_order_precession(at.couple, at.axial, spin)));
        }
        // The fast branch as far as the slow one and this top leave it room.
        let most = slow.iter().fold(at.precession.abs(), |most: f64, (_, slow)| most.max(slow.abs()));
        fast.retain(|(_, fast)| fast.abs() <= 3.0 * most);
        let mut series = vec![Series::line("slow", slow).of("slow_precession")];
        if !fast.is_empty() {
            series.push(Series::line("fast", fast).of("fast_precession"));
        }
        series.push(Series::line("fast-top formula", first).of("first_order_precession"));
        let plot = Plot::new(
            "Precession against spin at this angle",
            Axis::linear("spin of the top", "rad/s"),
            Axis::linear("precession", "rad/s"),
            series,
        )
        .over("motion.spin.spin")
        .mark("this top", (spin, at.precession));
        if least > 0.0 { plot.band("too slow", 0.0, least, false) } else { plot }
    }

    /// The top on its way around the vertical.
    fn animation(&self, precession: f64, spin: f64) -> Exhibit {
        let (around, about) = (precession.signum(), spin.signum());
        scene::animation("The top in steady precession", 4.0, |part| {
            let turn = Rotation3::from_axis_angle(&Vector3::z_axis(), around * TAU * part)
                * Rotation3::from_axis_angle(&Vector3::x_axis(), self.nutation)
                * Rotation3::from_axis_angle(&Vector3::z_axis(), about * 3.0 * TAU * part);
            let axis = turn * Vector3::z();
            let mut scene = Scene::new();
            scene.circle(Vector3::z() * axis.z * 1.2, Vector3::z(), 1.2 * axis.xy().norm(), Ink::Faint);
            scene.line([Vector3::zeros(), Vector3::z() * 1.3 * axis.z.signum()], Ink::Faint);
            self.body.draw(&turn, 0.9, &mut scene);
            let spin = match self.motion {
                TopMotion::AxialVelocity { .. } => "ω₃",
                _ => "ψ̇",
            };
            scene.line([axis * 0.9, axis * 1.25], Ink::Faint);
            scene.turn(spin, axis * 1.15, axis * about, 0.14, Ink::Motion);
            scene.turn("φ̇", Vector3::z() * 1.15, Vector3::z() * around, 0.14, Ink::Motion);
            scene.angle("θ", Vector3::zeros(), [Vector3::z(), axis], 0.55);
            scene.label(axis * 0.63, "G");
            scene.arrow(axis * 0.63, Vector3::z() * -0.55, Ink::Force, "m g");
            scene
        })
    }
}

/// Refuses a steady precession of zero.
fn goes_around<N: Real>(precession: N) -> Result<(), Refusal> {
    if precession.value() == 0.0 {
        return Err(Refusal::because(
            "a top whose axis does not precess falls: the precession must not be zero",
        ));
    }
    Ok(())
}
