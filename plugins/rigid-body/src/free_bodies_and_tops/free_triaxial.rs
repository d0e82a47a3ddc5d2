//! Any body on which no moment acts, by Jacobi's elliptic functions.

use std::f64::consts::{FRAC_PI_2, TAU};

use dalembert_core::{About, Analysis, Exhibit, Inputs, Refusal, Text, Worksheet, register};
use dalembert_mechanics::{
    Real, Vector,
    rigid::{
        self,
        torque_free::{FreeBody, FreeBodyError, Polhode},
    },
};
use nalgebra::{Matrix3, Rotation3, Unit, Vector3};

use crate::{
    shared::body::Shape,
    sources::{GOLDSTEIN, LANDAU},
};
use pictures::{components, herpolhode, poinsot, shown_time};

/// The body and how it was thrown.
///
/// The axes x, y and z are its principal axes at the centre of mass; fixed axes agree with them at the start.
#[derive(Clone, Debug, Inputs)]
pub struct FreeTriaxial {
    /// Principal moments of inertia.
    pub inertia: PrincipalInertia,
    /// Angular velocity at the start, principal axes.
    #[input("ω₀", "rad/s")]
    pub velocity: Vector3<f64>,
    /// Instant.
    /// If given, the angular velocity and attitude at this time after the start are also calculated.
    #[input("t", "s", nonnegative)]
    pub instant: Option<f64>,
}

/// Moments of inertia about the centre of mass, or their ratios.
#[derive(Clone, Debug, Inputs)]
pub enum PrincipalInertia {
    /// Moments of inertia
    Moments {
        /// Moment of inertia about x.
        #[input("I_x", "kg*m^2", positive)]
        x: f64,
        /// Moment of inertia about y.
        #[input("I_y", "kg*m^2", positive)]
        y: f64,
        /// Moment of inertia about z.
        #[input("I_z", "kg*m^2", positive)]
        z: f64,
    },
    /// Mass and radii of gyration
    Gyration {
        /// Mass.
        #[input("m", "kg", positive)]
        mass: f64,
        /// Radius of gyration about x.
        #[input("k_x", "m", positive)]
        x: f64,
        /// Radius of gyration about y.
        #[input("k_y", "m", positive)]
        y: f64,
        /// Radius of gyration about z.
        #[input("k_z", "m", positive)]
        z: f64,
    },
    /// Homogeneous box
    Cuboid {
        /// Mass.
        #[input("m", "kg", positive)]
        mass: f64,
        /// Edge along x.
        #[input("a", "mm", positive)]
        x: f64,
        /// Edge along y.
        #[input("b", "mm", positive)]
        y: f64,
        /// Edge along z.
        #[input("c", "mm", positive)]
        z: f64,
    },
    /// Another shape
    /// About its own axes through its centre of mass.
    Shape {
        /// Mass.
        #[input("m", "kg", positive)]
        mass: f64,
        /// Shape.
        shape: Shape,
    },
}

mod inertia;
mod pictures;

impl PrincipalInertia {
    /// The axes of the body, with the letters of what is given along them.
    fn letters(&self) -> [&'static str; 3] {
        match self {
            PrincipalInertia::Moments { .. } => ["x, I_x", "y, I_y", "z, I_z"],
            PrincipalInertia::Gyration { .. } => ["x, k_x", "y, k_y", "z, k_z, m"],
            PrincipalInertia::Cuboid { .. } => ["x, a", "y, b", "z, c, m"],
            PrincipalInertia::Shape { .. } => ["x", "y", "z, m"],
        }
    }
}

register!(FreeTriaxial);

const AXES: [&str; 3] = ["x", "y", "z"];

impl Analysis for FreeTriaxial {
    const ABOUT: About = About {
        id: "rigid-body/free-triaxial",
        title: "Free motion of any body",
        topic: "Free bodies and tops",
        summary: "Torque-free motion of a body with three different moments of inertia by Jacobi's elliptic functions: polhode, periods, flips about the intermediate axis, angular velocity and attitude at an instant.",
        main: &["growth_rate", "first_flip", "period", "velocity"],
        keywords: "torque-free Euler Jacobi Dzhanibekov tennis racket intermediate axis polhode herpolhode Poinsot eixo intermediário polódia herpolódia raquete",
        sources: &[&LANDAU, &GOLDSTEIN],
        cases: include_str!("../../cases/free_triaxial.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &FreeTriaxialGiven<W>, sheet: W) -> Result<(), Refusal> {
        let inertia = inertia::moments(&given.inertia, sheet)?;
        let velocity = given.velocity;
        let plain = inertia.map(Real::value);
        let start = velocity.value();
        let body = FreeBody::new(plain.into(), start).map_err(refused)?;
        if start == Vector3::zeros() {
            return Err(Refusal::because("the body does not turn: give an angular velocity"));
        }
        let omega = velocity.components();
        let doubled = sheet.step(
            "T",
            "J",
            W::Num::sum((0..3).map(|n| inertia[n] * omega[n].powi(2))) / 2.0,
            "Kinetic energy of rotation, which is conserved",
        );
        let momentum = sheet.step_vector(
            "H",
            "kg*m^2/s",
            rigid::angular_momentum(inertia, velocity),
            "Angular momentum about the centre of mass at the start, which is constant in fixed axes",
        );
        let size = sheet.step("H_G", "kg*m^2/s", momentum.magnitude(), "Its magnitude");
        sheet.answer("rotational_energy", "Kinetic energy of rotation", doubled);
        sheet.answer("angular_momentum", "Magnitude of the angular momentum", size);
        let order = body.order();
        let triaxial = order.map(|n| plain[n]).windows(2).all(|pair| pair[0] != pair[1]);
        if triaxial {
            let [a, b, c] = order.map(|n| inertia[n]);
            let about = omega[order[1]].abs();
            sheet.common_error(
                "λ",
                "the differences of the moments divided by the intermediate one",
                || ((b - a) * (c - b)).sqrt() / b * about,
            );
            sheet.common_error(
                "λ",
                "the formula for a rotation about the axis of an extreme moment used",
                || ((c - a) * (c - b) / (a * b)).sqrt() * about,
            );
            let growth = sheet.step(
                "λ",
                "1/s",
                ((b - a) * (c - b) / (a * c)).sqrt() * about,
                (
                    Text::new(
                        "Growth of a small disturbance of the rotation about {axis}, the intermediate axis, e^(λt)",
                    )
                    .with("axis", AXES[order[1]]),
                    LANDAU.at("§37"),
                ),
            );
            sheet.answer("growth_rate", "Growth rate near the intermediate axis", growth);
            sheet.verify(|| growing(plain, order, growth, start[order[1]], sheet));
            let [least, most] = if a.value() < c.value() { [a, c] } else { [c, a] };
            let slope = sheet.step(
                "κ_s",
                "1",
                ((most * (most - b)) / (least * (b - least))).sqrt(),
                (
                    "Separatrix planes, through the intermediate axis, from H² = 2 T I with the intermediate moment: angular velocity about the axis of minimum inertia over that about the axis of maximum inertia",
                    GOLDSTEIN.at("§5.6"),
                ),
            );
            sheet.answer("separatrix_slope", "Slope of the separatrix planes", slope);
            sheet.verify(|| {
                // A vector in such a plane, of length one about the axis of maximum inertia.
                let (momentum, energy) =
                    ((least * slope).powi(2) + most.powi(2), (least * slope.powi(2) + most) * b);
                sheet.check(
                    "H² = 2 T I with the intermediate moment, in a separatrix plane",
                    momentum,
                    energy,
                );
            });
        }
        match body.polhode() {
            Polhode::Permanent => {
                permanent(start, triaxial && start[order[1]] != 0.0, [doubled, size], sheet);
            }
            Polhode::Around(axis) => self.around(&body, axis, inertia, velocity, doubled, size, sheet),
            Polhode::Separatrix => {
                let argument_rate = body.argument_rate();
                let argument_rate = sheet.numerical(
                    "p",
                    "1/s",
                    argument_rate,
                    "H² = 2 T I with the intermediate moment: asymptotic motion along the separatrix, from one end of the intermediate axis to the other, once only, as tanh(p t)",
                );
                sheet.answer(
                    "separatrix_rate",
                    "Asymptotic rate towards the intermediate axis",
                    argument_rate,
                );
                sheet.verify(|| {
                    // At either end the body turns about the middle axis with all of H.
                    let end = size.value() / plain[order[1]];
                    growing(plain, order, argument_rate, end, sheet);
                });
                sheet.warn(|| {
                    "the motion is on the separatrix: the smallest disturbance determines what follows".into()
                });
            }
        }
        if let Some(t) = self.instant {
            at_instant(&body, plain.into(), t, sheet);
        }
        sheet.verify(|| {
            // Energy and angular momentum of the closed form, later on.
            let later = 0.37 * body.period().min(1.0 / start.norm());
            let velocity = body.velocity(later);
            let momentum = Vector3::from(plain).component_mul(&velocity);
            sheet.check(
                "kinetic energy a little later",
                W::Num::from(velocity.dot(momentum) / 2.0),
                W::Num::from(doubled.value()),
            );
            let fixed = body.attitude(later) * momentum;
            sheet.check_zero(
                "angular momentum in fixed axes a little later",
                W::Num::from((fixed - Vector3::from(plain).component_mul(&start)).norm()),
                size.value(),
            );
        });
        let shown = shown_time(&body, start);
        sheet.show(|| Exhibit::Plot(components(&body, shown)));
        sheet.show(|| Exhibit::Plot(herpolhode(&body, plain.into(), start, shown)));
        sheet.show(|| poinsot(&body, (plain.into(), self.inertia.letters()), start, shown));
        Ok(())
    }
}

impl FreeTriaxial {
    /// The periodic motion around the axis of the largest or the smallest moment.
    #[expect(clippy::too_many_arguments, reason = "the inputs and invariants of one motion")]
    fn around<W: Worksheet>(
        &self,
        body: &FreeBody,
        axis: usize,
        inertia: [W::Num; 3],
        velocity: W::Vec,
        energy: W::Num,
        momentum: W::Num,
        sheet: W,
    ) {
        let order = body.order();
        let ([i_a, i_b, i_c], [w_a, w_b, w_c]) =
            (order.map(|n| inertia[n]), order.map(|n| velocity.components()[n]));
        let ratio = sheet.step(
            "D",
            "kg*m^2",
            momentum.powi(2) / (energy * 2.0),
            (
                Text::new(if i_c.value() >= i_b.value() {
                    "H²/2T is above the intermediate moment: the polhode encircles {axis}, the axis of the largest moment"
                } else {
                    "H²/2T is below the intermediate moment: the polhode encircles {axis}, the axis of the smallest moment"
                })
                .with("axis", AXES[axis]),
                LANDAU.at("§37"),
            ),
        );
        sheet.answer("poinsot_moment", "H²/2T, to be compared with the intermediate moment", ratio);
        let why = |function: &'static str, n: usize| {
            (
                Text::new(
                    "Maximum ω_{axis}, from energy and angular momentum: ω_{axis} = ± A_{axis} {function} τ",
                )
                .with("axis", AXES[n])
                .with("function", function),
                LANDAU.at("§37"),
            )
        };
        const SIZES: [&str; 3] = ["A_x", "A_y", "A_z"];
        let [a, b, c] = order;
        let size_a = sheet.step(
            SIZES[a],
            "rad/s",
            (w_a.powi(2) + i_b * (i_c - i_b) / (i_a * (i_c - i_a)) * w_b.powi(2)).sqrt(),
            why("cn", a),
        );
        let size_b = sheet.step(
            SIZES[b],
            "rad/s",
            (w_b.powi(2) + i_a * (i_c - i_a) / (i_b * (i_c - i_b)) * w_a.powi(2)).sqrt(),
            why("sn", b),
        );
        let size_c = sheet.step(
            SIZES[c],
            "rad/s",
            (w_c.powi(2) + i_b * (i_b - i_a) / (i_c * (i_c - i_a)) * w_b.powi(2)).sqrt(),
            why("dn", c),
        );
        let argument_rate = sheet.step(
            "p",
            "rad/s",
            ((i_c - i_b) * (i_c - i_a) / (i_a * i_b)).sqrt() * size_c,
            ("Rate of the argument, τ = τ₀ + p t", LANDAU.at("§37")),
        );
        let modulus_squared = sheet.step(
            "k²",
            "1",
            i_a * (i_b - i_a) / (i_c * (i_c - i_b)) * (size_a / size_c).powi(2),
            ("Square of the modulus of the elliptic functions", LANDAU.at("§37")),
        );
        let (_, complement) = body.modulus();
        let quarter = sheet.numerical(
            "K",
            "1",
            body.period() * body.argument_rate() / 4.0,
            "Complete elliptic integral of the first kind of this modulus, by the arithmetic–geometric mean",
        );
        sheet.common_error("T_ω", "a harmonic motion assumed, with the period 2π/p", || {
            W::Num::from(TAU) / argument_rate
        });
        let period = sheet.step(
            "T_ω",
            "s",
            quarter * 4.0 / argument_rate,
            ("Period of the angular velocity in body axes, 4 K/p", LANDAU.at("§37")),
        );
        let half = sheet.step(
            "T_f",
            "s",
            period / 2.0,
            "Time between two sign changes along the intermediate axis: flips",
        );
        for (n, size) in [(a, size_a), (b, size_b), (c, size_c)] {
            sheet.answer(("amplitude", n + 1), LARGEST[n], size);
        }
        sheet.answer("pace", "Rate of the elliptic-function argument", argument_rate);
        sheet.answer("modulus_squared", "Square of the modulus", modulus_squared);
        sheet.answer("period", "Period of the angular velocity in body axes", period);
        sheet.answer("flip_interval", "Time between flips", half);
        if let Some(first) = body.first_flip() {
            sheet.common_error("t₁", "a quarter of the period taken as the time to the first flip", || {
                period / 4.0
            });
            let first = sheet.numerical(
                "t₁",
                "s",
                first,
                "First time at which the component along the intermediate axis is zero: sn τ = 0",
            );
            sheet.answer("first_flip", "Time until the first flip", first);
            sheet.verify(|| {
                sheet.check_zero(
                    "the component along the intermediate axis at that time",
                    W::Num::from(body.velocity(first.value())[b]),
                    size_b.value(),
                );
            });
        }
        let advance = sheet.numerical(
            "Δφ",
            "deg",
            body.advance(),
            (
                Text::new("Advance of the axis {axis} about the angular momentum in one period: H/I t and an elliptic integral of the third kind")
                    .with("axis", AXES[axis]),
                LANDAU.at("§37"),
            ),
        );
        sheet.answer("advance", "Precession angle per period", advance);
        let mean = sheet.step("Ω", "rad/s", advance / period, "Mean precession");
        sheet.answer("mean_precession", "Mean precession", mean);
        sheet.verify(|| {
            // Where sn τ is 0 and the other two are at their largest.
            let (h_a, h_c) = (i_a * size_a, i_c * size_c);
            sheet.check(
                "H² over 2T where the component along the intermediate axis is zero",
                (h_a.powi(2) + h_c.powi(2)) / (h_a * size_a + h_c * size_c),
                ratio,
            );
            sheet.check(
                "kinetic energy where sn τ is 1",
                i_b * size_b.powi(2) + i_c * size_c.powi(2) * (W::Num::from(1.0) - modulus_squared),
                energy * 2.0,
            );
            let start = body.velocity(0.0);
            let whole = body.velocity(period.value()) - start;
            let mut turned = -body.velocity(half.value());
            turned[c] = -turned[c];
            let error = f64::EPSILON * body.argument_rate() * body.period() * start.norm();
            for (what, off) in [
                ("angular velocity after one period", whole),
                ("angular velocity after half a period, transverse component reversed", turned - start),
            ] {
                sheet.check_residual(what, off.norm().into(), start.norm(), error);
            }
            let about = Vector3::from(inertia.map(Real::value)).component_mul(&start);
            if let Some(about) = Unit::try_new(about, 0.0) {
                let turned = Rotation3::from_axis_angle(&about, mean.value() * period.value());
                let off = body.attitude(period.value()).matrix() - turned.matrix();
                let error = f64::EPSILON * (advance.value().abs() + body.argument_rate() * body.period());
                let what = "the attitude after one period, a rotation about the angular momentum";
                sheet.check_residual(what, off.norm().into(), 1.0, error);
            }
        });
        sheet.verify(|| {
            sheet.check(
                "the rate of the argument by the numerical kernel",
                W::Num::from(body.argument_rate()),
                W::Num::from(argument_rate.value()),
            );
            // Equal weights over the period of the amplitude converge geometrically; near the separatrix slowly.
            if complement > 1e-4 {
                let k = |sine: f64| (1.0 - (1.0 - complement) * sine * sine).sqrt().recip();
                sheet.check(
                    "the complete integral by equal-weight quadrature",
                    W::Num::from(FRAC_PI_2 * mean_of(|angle| k(angle.sin()))),
                    quarter,
                );
                let (moments, period) = (inertia.map(Real::value), body.period());
                let [i_a, i_b, i_c] = order.map(|n| moments[n]);
                let rate = |angle: f64| {
                    let (sin, cos) = angle.sin_cos();
                    let (h_a, h_b) = (i_a * size_a.value() * cos, i_b * size_b.value() * sin);
                    let across = h_a * h_a + h_b * h_b;
                    (h_a * h_a / i_a + h_b * h_b / i_b) / across * momentum.value() * k(sin)
                };
                let even = |a: f64, b: f64| a / b > 1e-4 && b / a > 1e-4;
                if even(i_a * size_a.value(), i_b * size_b.value()) && i_c > 0.0 {
                    sheet.check(
                        "the precession angle per period by equal-weight quadrature",
                        W::Num::from(mean_of(rate) * period * FRAC_PI_2 / quarter.value()),
                        advance,
                    );
                }
            }
        });
    }
}

const LARGEST: [&str; 3] = [
    "Maximum component of the angular velocity along x",
    "Maximum component of the angular velocity along y",
    "Maximum component of the angular velocity along z",
];

/// The mean of a function over a turn.
fn mean_of(function: impl Fn(f64) -> f64) -> f64 {
    const POINTS: u32 = 4000;
    let at = |n: u32| function(4.0 * FRAC_PI_2 * f64::from(n) / f64::from(POINTS));
    (0..POINTS).map(at).sum::<f64>() / f64::from(POINTS)
}

/// Holds a rate of growth beside a rotation about the middle axis to Euler's equations: of what grows, along the polhode
/// through that axis, the rate needs no moment.
fn growing<W: Worksheet>(inertia: [f64; 3], [a, b, c]: [usize; 3], rate: W::Num, about: f64, sheet: W) {
    let moments = Vector3::from(inertia);
    let off = [1.0, -1.0].map(|sign| {
        let mut beside = Vector3::zeros();
        beside[a] = ((inertia[c] - inertia[b]) * inertia[c]).abs().sqrt();
        beside[c] = sign * ((inertia[b] - inertia[a]) * inertia[a]).abs().sqrt();
        let mut whole = beside;
        whole[b] = about;
        let mut moment =
            moments.component_mul(&beside) * rate.value() + whole.cross(moments.component_mul(&whole));
        moment[b] = 0.0;
        (moment.norm(), moments.amax() * about.abs() * beside.norm())
    });
    let [(one, scale), (other, _)] = off;
    sheet.check_zero("Euler's equations for a growing disturbance", one.min(other).into(), scale);
}

/// A rotation about a principal axis goes on for ever, about the middle one only in theory.
fn permanent<W: Worksheet>(
    start: Vector3<f64>,
    about_the_middle: bool,
    [energy, momentum]: [W::Num; 2],
    sheet: W,
) {
    let speed = sheet.numerical(
        "ω_p",
        "rad/s",
        start.norm(),
        "H is parallel to ω: the body is in permanent rotation about a principal axis",
    );
    sheet.answer("permanent_speed", "Angular velocity of the permanent rotation", speed);
    sheet.check("twice the kinetic energy as H ω", momentum * speed, energy * 2.0);
    if about_the_middle {
        sheet.warn(|| {
            "the body rotates exactly about the axis of the intermediate moment, where the smallest disturbance grows".into()
        });
    }
}

fn at_instant<W: Worksheet>(body: &FreeBody, inertia: Vector3<f64>, t: f64, sheet: W) {
    let velocity = sheet.numerical_vector(
        "ω",
        "rad/s",
        body.velocity(t),
        (
            "Angular velocity at the instant, principal axes: A cn τ, A sn τ and A dn τ with their signs",
            LANDAU.at("§37"),
        ),
    );
    sheet.answer_vector("velocity", "Angular velocity at the instant, principal axes", velocity);
    let attitude = body.attitude(t);
    let fixed = sheet.numerical_vector(
        "ω_XYZ",
        "rad/s",
        attitude * body.velocity(t),
        "The same in fixed axes, by the attitude of the body",
    );
    sheet.answer_vector("fixed_velocity", "Angular velocity at the instant, fixed axes", fixed);
    const AXES: [(&str, &str, &str); 3] = [
        ("x_axis", "e_x", "Principal axis x at the instant, fixed axes"),
        ("y_axis", "e_y", "Principal axis y at the instant, fixed axes"),
        ("z_axis", "e_z", "Principal axis z at the instant, fixed axes"),
    ];
    let mut axes = Matrix3::zeros();
    for (n, (name, symbol, label)) in AXES.into_iter().enumerate() {
        let axis = sheet.numerical_vector(
            symbol,
            "1",
            attitude.matrix().column(n).into_owned(),
            "Attitude: nutation from the axial component of H, precession by the integral of the third kind",
        );
        sheet.answer_vector(name, label, axis);
        axes.set_column(n, &axis.value());
    }
    sheet.verify(|| {
        let period = body.period().min(TAU / body.velocity(0.0).norm());
        let speed = body.velocity(0.0).norm();
        let Ok(rate) = rigid::numerical_rate(|time| body.velocity(t + time), period) else { return };
        let now = velocity.value();
        let moment = inertia.component_mul(&rate) + now.cross(inertia.component_mul(&now));
        // Times are good to rounding: a difference quotient over a short part of a long time is not better.
        let late = 1.0 + 1e-4 * t / period;
        sheet.check_zero(
            "Euler's equations with zero moment, by difference quotients",
            W::Num::from(moment.norm()),
            inertia.amax() * speed * speed * late,
        );
        for side in [Vector3::new(0.6, 0.0, 0.8), Vector3::new(0.0, 0.8, 0.6)] {
            let Ok(rate) = rigid::numerical_rate(|time| body.attitude(t + time) * side, period) else {
                return;
            };
            sheet.check_zero(
                "the attitude from its rate: the difference quotient of R compared with ω × R",
                W::Num::from((rate - fixed.value().cross(axes * side)).norm()),
                speed * late,
            );
        }
    });
}

fn refused(error: FreeBodyError) -> Refusal {
    Refusal::because(match error {
        FreeBodyError::Triangle { axis } => Text::new(
            "the triangle inequality excludes a moment of inertia I_{axis} that is larger than the sum of the other two: check the moments",
        )
        .with("axis", AXES[axis]),
        FreeBodyError::Moment { axis } => {
            Text::new("the moment of inertia I_{axis} is out of range").with("axis", AXES[axis])
        }
        FreeBodyError::NotFinite => {
            "the motion exceeds the numerical range: check the magnitudes of the inputs".into()
        }
    })
}
