//! Small oscillations of two pendulums, one hanging from the other.

use std::f64::consts::{FRAC_PI_2, TAU};

use dalembert_core::{About, Analysis, Exhibit, Inputs, Refusal, Sketch, Text, Worksheet, register};
use dalembert_mechanics::{Real, vibration::modes::natural_modes};
use nalgebra::DMatrix;

use crate::{
    shared::system::modes::refusal,
    sources::{MERIAM, RAO},
};

/// The pendulums and gravity.
#[derive(Clone, Debug, Inputs)]
pub struct DoublePendulum {
    /// Upper pendulum.
    #[input("1")]
    pub upper: UpperPendulum,
    /// Lower pendulum.
    #[input("2")]
    pub lower: LowerPendulum,
    /// Gravity.
    #[input("g", "m/s^2", positive, default = "9.81 m/s^2", default_before = "9.80665 m/s^2")]
    pub gravity: f64,
}

/// The pendulum that hangs from the fixed pivot.
#[derive(Clone, Debug, Inputs)]
pub enum UpperPendulum {
    /// Small mass on a light rod or string
    Bob {
        /// Mass.
        #[input("m", "kg", positive)]
        mass: f64,
        /// Length.
        #[input("l", "m", positive)]
        length: f64,
    },
    /// Slender uniform rod
    Rod {
        /// Mass.
        #[input("m", "kg", positive)]
        mass: f64,
        /// Length.
        #[input("l", "m", positive)]
        length: f64,
    },
    /// Body of any form
    Body {
        /// Mass.
        #[input("m", "kg", positive)]
        mass: f64,
        /// Distance from its pivot to the other pivot.
        #[input("l", "m", positive)]
        length: f64,
        /// Distance from its pivot to the centre of mass.
        /// On the line of the pivots, positive downwards.
        #[input("c", "m")]
        centre: f64,
        /// Moment of inertia about the centre of mass.
        #[input("J_G", "kg*m^2", nonnegative)]
        inertia: f64,
    },
}

/// The pendulum that hangs from the other one.
#[derive(Clone, Debug, Inputs)]
pub enum LowerPendulum {
    /// Small mass on a light rod or string
    Bob {
        /// Mass.
        #[input("m", "kg", positive)]
        mass: f64,
        /// Length.
        #[input("l", "m", positive)]
        length: f64,
    },
    /// Slender uniform rod
    Rod {
        /// Mass.
        #[input("m", "kg", positive)]
        mass: f64,
        /// Length.
        #[input("l", "m", positive)]
        length: f64,
    },
    /// Body of any form
    Body {
        /// Mass.
        #[input("m", "kg", positive)]
        mass: f64,
        /// Distance from its pivot to the centre of mass.
        #[input("c", "m", positive)]
        centre: f64,
        /// Moment of inertia about the centre of mass.
        #[input("J_G", "kg*m^2", nonnegative)]
        inertia: f64,
    },
}

register!(DoublePendulum);

/// Mass, distance of the centre of mass from the pivot, moment of inertia about the pivot.
type Inertia<N> = (N, N, N);

impl Analysis for DoublePendulum {
    const ABOUT: About = About {
        id: "vibration/double-pendulum",
        title: "Double pendulum",
        topic: "Several degrees of freedom",
        summary: "Natural frequencies and modes of two pendulums, one hanging from the other: small masses, rods or bodies of any form.",
        main: &["frequency"],
        keywords: "pendulum two degrees compound crane hook load small oscillations pêndulo duplo composto dois \
                   graus de liberdade guindaste pequenas oscilações overhead crane ponte rolante",
        sources: &[&RAO, &MERIAM],
        cases: include_str!("../../cases/double_pendulum.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &DoublePendulumGiven<W>, sheet: W) -> Result<(), Refusal> {
        let (length, (m1, c1, j1)) = upper(&given.upper, sheet);
        let (m2, c2, j2) = lower(&given.lower, sheet);
        let gravity = given.gravity;
        let in_line = || j1 + m2 * (length + c2).powi(2);
        let what = "the lower pendulum taken in line with the upper one, its centre of mass at l₁ + c₂";
        sheet.common_error("M₁₁", what, in_line);
        let of_both = || j1 + m2 * length.powi(2) + j2;
        let what = "the moment of inertia of the lower pendulum counted for the upper angle too";
        sheet.common_error("M₁₁", what, of_both);
        let m11 = sheet.step(
            "M₁₁",
            "kg*m^2",
            j1 + m2 * length.powi(2),
            (
                "T = ½M₁₁θ₁'² + M₁₂θ₁'θ₂' + ½M₂₂θ₂'²: the lower mass goes along with the lower pivot",
                RAO.at("§5.2"),
            ),
        );
        let m12 = sheet.step(
            "M₁₂",
            "kg*m^2",
            m2 * length * c2,
            "For small angles cos(θ₁ − θ₂) = 1: the velocities of pivot and centre add",
        );
        let m22 = sheet.step("M₂₂", "kg*m^2", j2, "The lower pendulum rotates about its own pivot");
        let in_line = || (m1 * c1 + m2 * (length + c2)) * gravity;
        sheet.common_error("K₁₁", "the weight of the lower pendulum taken at its centre of mass", in_line);
        let at_joint = || (m1 + m2) * length * gravity;
        sheet.common_error("K₁₁", "the weight of the upper pendulum taken at the lower pivot", at_joint);
        let k11 = sheet.step(
            "K₁₁",
            "N*m/rad",
            (m1 * c1 + m2 * length) * gravity,
            "V = ½K₁₁θ₁² + ½K₂₂θ₂²: heights of the weights from the cosines of the angles with the vertical",
        );
        let k22 = sheet.step("K₂₂", "N*m/rad", m2 * c2 * gravity, "The weight of the lower pendulum");
        if k11.value() <= 0.0 {
            return Err(Refusal::because(
                "the upper pendulum is top-heavy and the lower one does not compensate for it: the rest position is unstable and there is no vibration",
            ));
        }
        let det = sheet.step(
            "Δ",
            "kg^2*m^4",
            m11 * m22 - m12.powi(2),
            ("Determinant of the masses", RAO.at("§5.3")),
        );
        let half = sheet.step(
            "s",
            "kg^2*m^4*rad^2/s^2",
            (m11 * k22 + m22 * k11) / 2.0,
            ("det(K − λM) = 0 is Δλ² − 2sλ + K₁₁K₂₂ = 0, with λ = ω²", RAO.at("§5.3")),
        );
        if !(det.value() > 0.0 && half.value() > 0.0) {
            return Err(Refusal::because(
                "the values of the pendulums differ too much for two frequencies: treat them as one pendulum",
            ));
        }
        // Under the root, s² − ΔK₁₁K₂₂ as a sum of squares.
        let upper = sheet.step(
            ("λ", 2),
            "rad^2/s^2",
            (half + (((m11 * k22 - m22 * k11) / 2.0).powi(2) + k11 * k22 * m12.powi(2)).sqrt()) / det,
            "Its larger root; under the sign s² − ΔK₁₁K₂₂, written as a sum of squares",
        );
        let lower = sheet.step(
            ("λ", 1),
            "rad^2/s^2",
            k11 * k22 / (det * upper),
            "The smaller root: the product of the two is K₁₁K₂₂/Δ",
        );
        let mut shapes = Vec::with_capacity(2);
        let mut ratios = Vec::new();
        for (n, square) in [(1, lower), (2, upper)] {
            let uncoupled = || {
                let [a, b] = [k11 / m11, k22 / m22];
                (if n == 1 { a.min(b) } else { a.max(b) }).sqrt()
            };
            sheet.common_error(("ω", n), "the coupling of the two pendulums neglected", uncoupled);
            if n == 1 {
                let single = || (gravity / (length + c2)).sqrt();
                sheet.common_error(("ω", n), "a simple pendulum of the whole length assumed", single);
            }
            let omega = sheet.step(("ω", n), "rad/s", square.sqrt(), ("Natural frequency", RAO.at("§5.3")));
            let frequency = sheet.step(("f", n), "Hz", omega, "In cycles per second");
            let period =
                sheet.step(("T", n), "s", W::Num::from(TAU) / omega, "Period: a full cycle of 2π over ω");
            // The row whose difference does not cancel.
            let first = (k11.value() - square.value() * m11.value()).abs() / k11.value();
            let second = (k22.value() - square.value() * m22.value()).abs() / k22.value();
            let (ratio, why) = if first >= second {
                (
                    (k11 - square * m11) / (square * m12),
                    "First row of (K − λM) φ = 0: angle of the lower pendulum over that of the upper",
                )
            } else {
                (
                    square * m12 / (k22 - square * m22),
                    "Second row of (K − λM) φ = 0: angle of the lower pendulum over that of the upper",
                )
            };
            let ratio = sheet.step(("r", n), "1", ratio, (why, RAO.at("§5.3")));
            sheet.answer(("frequency", n), "Natural frequency", frequency);
            sheet.answer(("angular_frequency", n), "Natural angular frequency", omega);
            sheet.answer(("period", n), "Period", period);
            sheet.answer(
                ("ratio", n),
                "Angle of the lower over that of the upper, both from the vertical",
                ratio,
            );
            sheet.verify(|| {
                sheet.check(
                    Text::new("mode {n}: potential energy over kinetic energy").with("n", n),
                    (k11 + k22 * ratio.powi(2)) / (m11 + m12 * ratio * 2.0 + m22 * ratio.powi(2)),
                    omega.powi(2),
                );
            });
            shapes.push(ratio.value());
            ratios.push(ratio);
        }
        let [mass, stiffness] = [[m11, m12, m22], [k11, W::Num::from(0.0), k22]]
            .map(|[a, b, d]| DMatrix::from_row_slice(2, 2, &[a.value(), b.value(), b.value(), d.value()]));
        let modes = natural_modes(&mass, &stiffness).map_err(refusal)?;
        sheet.verify(|| {
            sheet.check(
                "the modes are orthogonal with respect to the stiffness, K₁₁ + K₂₂ r₁ r₂ = 0",
                k22 * ratios[0] * ratios[1],
                -k11,
            );
            for (n, square) in [(1, lower), (2, upper)] {
                sheet.check(
                    Text::new("frequency {n} by the numerical eigenvalues of K and M").with("n", n),
                    W::Num::from(modes.squares[n - 1]),
                    square,
                );
            }
        });
        sheet.show(|| {
            let mut sketch = self.sketch([0.25, 0.5]).titled("The pendulums");
            self.letters([0.25, 0.5], &mut sketch);
            Exhibit::Drawing(sketch.finish())
        });
        for (mode, ratio) in (1..).zip(shapes) {
            sheet.show(|| {
                let largest = ratio.abs().max(1.0);
                let frames = (0..24).map(|frame| {
                    let now = 0.4 / largest * (TAU * f64::from(frame) / 24.0).cos();
                    self.sketch([now, ratio * now])
                });
                Exhibit::Animation(Sketch::animation(
                    Text::new("Mode {mode}").with("mode", mode),
                    frames,
                    2.0,
                ))
            });
        }
        Ok(())
    }
}

impl DoublePendulum {
    /// The places of the lower pivot and of the lower end, and which of them are bobs; the pendulums together are 4 long.
    fn places(&self, turns: [f64; 2]) -> ((f64, f64), (f64, f64), [bool; 2]) {
        let (l1, bob1) = match self.upper {
            UpperPendulum::Bob { length, .. } => (length, true),
            UpperPendulum::Rod { length, .. } | UpperPendulum::Body { length, .. } => (length, false),
        };
        let (l2, bob2) = match self.lower {
            LowerPendulum::Bob { length, .. } => (length, true),
            LowerPendulum::Rod { length, .. } => (length, false),
            LowerPendulum::Body { centre, .. } => (centre, true),
        };
        let scale = 4.0 / (l1 + l2);
        let from = |(x, y): (f64, f64), length: f64, turn: f64| {
            (x + scale * length * turn.sin(), y - scale * length * turn.cos())
        };
        let joint = from((0.0, 0.0), l1, turns[0]);
        (joint, from(joint, l2, turns[1]), [bob1, bob2])
    }

    /// Masses and lengths beside the pendulums.
    fn letters(&self, turns: [f64; 2], sketch: &mut Sketch) {
        let (joint, end, _) = self.places(turns);
        let middle = |a: (f64, f64), b: (f64, f64)| (f64::midpoint(a.0, b.0), f64::midpoint(a.1, b.1));
        sketch.dimension("l_1", (0.0, 0.0), joint, 4.0);
        match self.upper {
            UpperPendulum::Bob { .. } => sketch.label("m_1", joint),
            UpperPendulum::Rod { .. } => sketch.label("m_1", middle((0.0, 0.0), joint)),
            UpperPendulum::Body { .. } => sketch.label("m_1, J_G_1, c_1", middle((0.0, 0.0), joint)),
        };
        match self.lower {
            LowerPendulum::Bob { .. } => sketch.dimension("l_2", joint, end, 4.0).label("m_2", end),
            LowerPendulum::Rod { .. } => {
                sketch.dimension("l_2", joint, end, 4.0).label("m_2", middle(joint, end))
            }
            LowerPendulum::Body { .. } => sketch.dimension("c_2", joint, end, 4.0).label("m_2, J_G_2", end),
        };
    }

    /// The pendulums turned by so much.
    fn sketch(&self, turns: [f64; 2]) -> Sketch {
        let (joint, end, [bob1, bob2]) = self.places(turns);
        let mut sketch = Sketch::default();
        sketch
            .axis((0.0, 0.0), (0.0, -4.0))
            .link("", (0.0, 0.0), joint)
            .link("", joint, end)
            .hung_pin("", (0.0, 0.0))
            .axis(joint, (joint.0, joint.1 - 1.6))
            .angle("θ₁", (0.0, 0.0), -FRAC_PI_2, turns[0] - FRAC_PI_2)
            .angle("θ₂", joint, -FRAC_PI_2, turns[1] - FRAC_PI_2);
        if bob1 {
            sketch.disc("", joint, 0.2);
        } else {
            sketch.joint("", joint);
        }
        if bob2 {
            sketch.disc("", end, 0.2);
        }
        sketch
    }
}

/// Distance of the two pivots, and the inertia of the upper pendulum.
fn upper<W: Worksheet>(given: &UpperPendulumGiven<W>, sheet: W) -> (W::Num, Inertia<W::Num>) {
    match given {
        UpperPendulumGiven::Bob { mass, length } => (*length, bob(1, *mass, *length, sheet)),
        UpperPendulumGiven::Rod { mass, length } => (*length, rod(1, *mass, *length, sheet)),
        UpperPendulumGiven::Body { mass, length, centre, inertia } => {
            (*length, body(1, *mass, *centre, *inertia, sheet))
        }
    }
}

/// The inertia of the lower pendulum.
fn lower<W: Worksheet>(given: &LowerPendulumGiven<W>, sheet: W) -> Inertia<W::Num> {
    match given {
        LowerPendulumGiven::Bob { mass, length } => bob(2, *mass, *length, sheet),
        LowerPendulumGiven::Rod { mass, length } => rod(2, *mass, *length, sheet),
        LowerPendulumGiven::Body { mass, centre, inertia } => body(2, *mass, *centre, *inertia, sheet),
    }
}

fn bob<W: Worksheet>(n: usize, mass: W::Num, length: W::Num, sheet: W) -> Inertia<W::Num> {
    let why = "Moment of inertia of the small mass about the pivot";
    (mass, length, sheet.step(("J", n), "kg*m^2", mass * length.powi(2), why))
}

fn rod<W: Worksheet>(n: usize, mass: W::Num, length: W::Num, sheet: W) -> Inertia<W::Num> {
    let why = ("Moment of inertia of the rod about its pivot", MERIAM.at("app. D"));
    let central = || mass * length.powi(2) / 12.0;
    sheet.common_error(("J", n), "the moment of inertia of the rod taken about its centre", central);
    let at_middle = || mass * (length / 2.0).powi(2);
    sheet.common_error(("J", n), "the mass of the rod taken as a point at its middle", at_middle);
    let inertia = sheet.step(("J", n), "kg*m^2", mass * length.powi(2) / 3.0, why);
    (mass, sheet.step(("c", n), "m", length / 2.0, "The centre of mass of the rod is at its middle"), inertia)
}

fn body<W: Worksheet>(n: usize, mass: W::Num, centre: W::Num, inertia: W::Num, sheet: W) -> Inertia<W::Num> {
    let why = ("Moment of inertia about the pivot, by the parallel-axis theorem", MERIAM.at("app. B"));
    (mass, centre, sheet.step(("J", n), "kg*m^2", inertia + mass * centre.powi(2), why))
}
