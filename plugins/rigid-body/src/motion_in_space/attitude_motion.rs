//! Attitude after a time from the angular velocity, by integration of Euler parameters.

use std::f64::consts::TAU;

use dalembert_core::{
    About, Analysis, Axis, Exhibit, Ink, Inputs, Plot, Refusal, Series, Worksheet, register,
};
use dalembert_mechanics::{Real, Vector};
use dalembert_numerics::ode::{self, OdeFunction};
use nalgebra::{Matrix3, Rotation3, Vector3};

use crate::{
    shared::{
        attitude::{
            AttitudeInput, EulerSequence, FrameAxes, answer_representations, both, cross_matrix, matrix,
            parameter_rows, plain_angles, plain_parameters, row_times, rows_of,
        },
        flat,
        scene::{self, Scene},
    },
    sources::{SCHAUB, SHUSTER},
};

/// Rotation of a body whose angular velocity is known at every time.
///
/// `[BN]` changes components in N, which are fixed, into components in B, the axes of the body.
#[derive(Clone, Debug, Inputs)]
pub struct AttitudeMotion {
    /// Attitude at the start.
    pub attitude: AttitudeInput,
    /// Angular velocity: sum of terms.
    #[input(min = 1)]
    pub terms: Vec<RateTerm>,
    /// Components of the angular velocity in.
    #[input(default = "body")]
    pub axes: FrameAxes,
    /// Duration.
    #[input("t", "s", positive)]
    pub duration: f64,
    /// Euler angles to calculate.
    #[input(default = "zyx")]
    pub sequence: EulerSequence,
}

/// A term of the angular velocity.
#[derive(Clone, Debug, Inputs)]
pub struct RateTerm {
    /// Angular velocity.
    #[input("Ω", "rad/s")]
    pub rate: Vector3<f64>,
    /// Its time history.
    #[input(default = "constant")]
    pub course: RateHistory,
}

/// Time history of a term.
#[derive(Clone, Debug, Inputs)]
pub enum RateHistory {
    /// Constant
    Constant,
    /// Harmonic
    /// Times sin(pt + φ): a phase of 90° for a cosine.
    Harmonic {
        /// Angular frequency.
        #[input("p", "rad/s")]
        frequency: f64,
        /// Phase.
        #[input("φ", "deg", default = "0 deg")]
        phase: f64,
    },
    /// Proportional to the time
    Linear {
        /// Time at which it has the value above.
        #[input("t₁", "s", positive, default = "1 s")]
        time: f64,
    },
    /// Exponential decay
    /// Times e^(−t/τ).
    Decay {
        /// Time constant.
        #[input("τ", "s", positive)]
        constant: f64,
    },
}

register!(AttitudeMotion);

/// Samples of the plots.
const SAMPLES: usize = 240;
/// The allowed error of a step.
const TOLERANCE: f64 = 1e-13;
/// Difference of two integrations that is allowed.
const INTEGRATION_ERROR: f64 = 1e-9;
/// Steps of an integration.
const MOST_STEPS: usize = 40_000;
/// Time of the animation on the screen, s.
const SHOWN: f64 = 6.0;

impl Analysis for AttitudeMotion {
    const ABOUT: About = About {
        id: "rigid-body/attitude-motion",
        title: "Attitude from the angular velocity",
        topic: "Motion in space",
        summary: "Attitude of a body after a time from its angular velocity as a function of time, by integration of Euler parameters: direction cosines, Euler angles, quaternion, Rodrigues parameters, and their time histories.",
        main: &["angular_velocity", "principal_angle", "principal_axis"],
        keywords: "attitude kinematics differential equations integration quaternion Euler parameters angular velocity Poisson strapdown rate gyro \
                   cinemática de atitude integração quatérnio velocidade angular equação de Poisson girômetro",
        sources: &[&SCHAUB, &SHUSTER],
        cases: include_str!("../../cases/attitude_motion.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &AttitudeMotionGiven<W>, sheet: W) -> Result<(), Refusal> {
        let start = rows_of(&self.attitude, &given.attitude, sheet)?;
        let c = matrix(start);
        sheet.keep_going()?;
        let times: Vec<f64> = (0..=SAMPLES).map(|n| self.duration * n as f64 / SAMPLES as f64).collect();
        let states = self.parameters(&c, &times)?;
        let end = states[SAMPLES];
        let scalar = sheet.numerical(
            "β₀′",
            "1",
            end.0,
            (
                "Scalar Euler parameter at the end: integral of β̇₀ = −ε · ω/2, with ω in components in B",
                SCHAUB.at("§3.5"),
            ),
        );
        let vector = sheet.numerical_vector(
            "ε′",
            "1",
            end.1,
            ("Vector part at the end: integral of ε̇ = (β₀ ω + ε × ω)/2", SCHAUB.at("§3.5")),
        );
        const SYMBOLS: [&str; 3] = ["b₁′", "b₂′", "b₃′"];
        let elements = parameter_rows::<W::Vec>(scalar, vector);
        let rows = [0, 1, 2].map(|n| {
            let why = ("Row of [BN] at the end", SCHAUB.at("§3.5"));
            sheet.step_vector(SYMBOLS[n], "1", elements[n], why)
        });
        self.angular_velocity(given, rows, sheet);
        answer_representations(rows, self.sequence, sheet);
        sheet.verify(|| self.check(&c, (scalar, vector), rows, sheet));
        sheet.show(|| Exhibit::Plot(self.angles_over_time(&times, &states)));
        sheet.show(|| Exhibit::Plot(self.parameters_over_time(&times, &states)));
        sheet.show(|| {
            scene::animation("The frames N and B", SHOWN, |part| {
                let at = states[(part * SAMPLES as f64).round() as usize];
                let mut scene = both(&matrix(parameter_rows(at.0, at.1)).transpose(), None);
                self.rates(at, &mut scene);
                scene
            })
        });
        Ok(())
    }
}

impl AttitudeMotion {
    /// The terms of the angular velocity as rotations about their own directions.
    fn rates(&self, (scalar, vector): (f64, Vector3<f64>), scene: &mut Scene) {
        let body = matrix(parameter_rows(scalar, vector)).transpose();
        for (term, row) in self.terms.iter().zip(1..) {
            let Some(along) = term.rate.try_normalize(0.0) else { continue };
            let along = if matches!(self.axes, FrameAxes::Body) { body * along } else { along };
            let letters: &[&'static str] = match term.course {
                RateHistory::Constant => &["Ω"],
                RateHistory::Harmonic { .. } => &["Ω", "p", "φ"],
                RateHistory::Linear { .. } => &["Ω", "t₁"],
                RateHistory::Decay { .. } => &["Ω", "τ"],
            };
            scene.turn(flat::of_row(letters, row), along * 0.75, along, 0.15, Ink::Motion);
        }
    }

    /// The angular velocity in components in the axes that it is given in.
    fn given_rate(&self, t: f64) -> Vector3<f64> {
        self.terms
            .iter()
            .map(|term| {
                let factor = match term.course {
                    RateHistory::Constant => 1.0,
                    RateHistory::Harmonic { frequency, phase } => (frequency * t + phase).sin(),
                    RateHistory::Linear { time } => t / time,
                    RateHistory::Decay { constant } => (-t / constant).exp(),
                };
                term.rate * factor
            })
            .sum()
    }

    /// Euler parameters at the times, by integration.
    fn parameters(&self, c: &Matrix3<f64>, times: &[f64]) -> Result<Vec<(f64, Vector3<f64>)>, Refusal> {
        let (scalar, vector) = plain_parameters(c);
        let mut problem = OdeFunction {
            rates: |t: f64, state: &[f64], rates: &mut [f64]| {
                let (scalar, vector) = (state[0], Vector3::new(state[1], state[2], state[3]));
                let omega = self.given_rate(t);
                // In components in N the body turns on the other side.
                let (rate, across) = match self.axes {
                    FrameAxes::Body => (-vector.dot(omega), vector.cross(omega)),
                    FrameAxes::Fixed => (-vector.dot(omega), omega.cross(vector)),
                };
                let turned = (omega * scalar + across) / 2.0;
                rates.copy_from_slice(&[rate / 2.0, turned.x, turned.y, turned.z]);
            },
            relative: TOLERANCE,
            absolute: TOLERANCE,
        };
        let start = [scalar, vector.x, vector.y, vector.z];
        let states = ode::states(&mut problem, &start, times, MOST_STEPS).map_err(|_| too_fast())?;
        let found: Vec<_> =
            states.iter().map(|state| (state[0], Vector3::new(state[1], state[2], state[3]))).collect();
        if found.len() == times.len() { Ok(found) } else { Err(too_fast()) }
    }

    /// Answers the angular velocity at the end.
    fn angular_velocity<W: Worksheet>(&self, given: &AttitudeMotionGiven<W>, rows: [W::Vec; 3], sheet: W) {
        let t = given.duration;
        let terms = given.terms.iter().map(|term| match &term.course {
            RateHistoryGiven::Constant { .. } => term.rate,
            RateHistoryGiven::Harmonic { frequency, phase } => term.rate * (*frequency * t + *phase).sin(),
            RateHistoryGiven::Linear { time } => term.rate * (t / *time),
            RateHistoryGiven::Decay { constant } => term.rate * (-t / *constant).exp(),
        });
        let (here, there, symbols) = match self.axes {
            FrameAxes::Body => ("Angular velocity at the end, in B", FrameAxes::Fixed, ["ω_B", "ω_N"]),
            FrameAxes::Fixed => ("Angular velocity at the end, in N", FrameAxes::Body, ["ω_N", "ω_B"]),
        };
        let known = sheet.step_vector(symbols[0], "rad/s", W::Vec::sum(terms), here);
        let (other, why) = match there {
            FrameAxes::Fixed => {
                (row_times(known, rows), "Angular velocity at the end, in N: [BN]ᵀ times that in B")
            }
            FrameAxes::Body => {
                let [x, y, z] = rows.map(|row| row.dot(known));
                (W::Vec::from_components(x, y, z), "Angular velocity at the end, in B: [BN] times that in N")
            }
        };
        let other = sheet.step_vector(symbols[1], "rad/s", other, why);
        let (body, fixed) = if there == FrameAxes::Fixed { (known, other) } else { (other, known) };
        sheet.answer_vector("angular_velocity", "Angular velocity at the end, in B", body);
        sheet.answer_vector("angular_velocity_fixed", "Angular velocity at the end, in N", fixed);
        sheet.verify(|| {
            let plain = self.given_rate(self.duration);
            let size: f64 = self.terms.iter().map(|term| term.rate.norm()).sum();
            sheet.check_zero("the angular velocity at the end", (known.value() - plain).norm().into(), size);
            let rotation = Rotation3::from_matrix_unchecked(matrix(rows));
            let off = rotation.transform_vector(&fixed.value()) - body.value();
            sheet.check_zero("its components in B, by [BN] times those in N", off.norm().into(), size);
        });
    }

    /// A second method: Poisson's equation for the nine direction cosines, and a rotation about a fixed axis.
    fn check<W: Worksheet>(
        &self,
        start: &Matrix3<f64>,
        (scalar, vector): (W::Num, W::Vec),
        rows: [W::Vec; 3],
        sheet: W,
    ) {
        let found = matrix(rows);
        let length = (scalar.value().powi(2) + vector.value().norm_squared()).sqrt();
        sheet.check_residual(
            "the length of the Euler parameters at the end, less 1",
            (length - 1.0).into(),
            1.0,
            INTEGRATION_ERROR,
        );
        let mut problem = OdeFunction {
            rates: |t: f64, state: &[f64], rates: &mut [f64]| {
                let c = Matrix3::from_column_slice(state);
                let omega = cross_matrix(self.given_rate(t));
                let rate = match self.axes {
                    FrameAxes::Body => -omega * c,
                    FrameAxes::Fixed => -c * omega,
                };
                rates.copy_from_slice(rate.as_slice());
            },
            relative: TOLERANCE,
            absolute: TOLERANCE,
        };
        let states = ode::states(&mut problem, start.as_slice(), &[0.0, self.duration], MOST_STEPS)
            .unwrap_or_default();
        if let Some(state) = states.last() {
            let off = found - Matrix3::from_column_slice(state);
            sheet.check_residual(
                "[BN] at the end by integration of Poisson's equation, dC/dt = −[ω×] C",
                off.amax().into(),
                1.0,
                INTEGRATION_ERROR,
            );
        }
        if self.terms.iter().all(|term| matches!(term.course, RateHistory::Constant)) {
            let turned = Rotation3::from_scaled_axis(-self.given_rate(0.0) * self.duration);
            let other = match self.axes {
                FrameAxes::Body => turned.matrix() * start,
                FrameAxes::Fixed => start * turned.matrix(),
            };
            sheet.check_residual(
                "[BN] at the end by one rotation about the constant angular velocity",
                (found - other).amax().into(),
                1.0,
                INTEGRATION_ERROR,
            );
        }
    }

    /// Euler angles while the body turns.
    fn angles_over_time(&self, times: &[f64], states: &[(f64, Vector3<f64>)]) -> Plot {
        let mut curves: [Vec<(f64, f64)>; 3] = Default::default();
        for (t, state) in times.iter().zip(states) {
            let found = plain_angles(self.sequence, &matrix(parameter_rows(state.0, state.1)));
            let angles = found.angles.map(|angle| if found.gimbal_lock { f64::INFINITY } else { angle });
            curves.iter_mut().zip(angles).for_each(|(curve, angle)| push(curve, *t, angle, TAU / 2.0));
        }
        let [first, second, third] = curves;
        Plot::new(
            "Euler angles against time",
            Axis::linear("Time", "s"),
            Axis::linear("Euler angle", "deg"),
            vec![
                Series::line("θ₁", first).of("euler_angle[1]"),
                Series::line("θ₂", second).of("euler_angle[2]"),
                Series::line("θ₃", third).of("euler_angle[3]"),
            ],
        )
        .over("duration")
    }

    /// Euler parameters while the body turns, of the set with β₀ ≥ 0.
    fn parameters_over_time(&self, times: &[f64], states: &[(f64, Vector3<f64>)]) -> Plot {
        let mut curves: [Vec<(f64, f64)>; 4] = Default::default();
        for (t, (scalar, vector)) in times.iter().zip(states) {
            let sign = if *scalar < 0.0 { -1.0 } else { 1.0 };
            let parts = [*scalar, vector.x, vector.y, vector.z];
            curves.iter_mut().zip(parts).for_each(|(curve, part)| push(curve, *t, part * sign, 0.5));
        }
        let [zero, one, two, three] = curves;
        Plot::new(
            "Euler parameters against time",
            Axis::linear("Time", "s"),
            Axis::linear("Euler parameter", "1"),
            vec![
                Series::line("β₀", zero).of("euler_parameter_scalar"),
                Series::line("β₁", one).of("euler_parameter_vector.x"),
                Series::line("β₂", two).of("euler_parameter_vector.y"),
                Series::line("β₃", three).of("euler_parameter_vector.z"),
            ],
        )
        .over("duration")
    }
}

/// Adds a point to a curve, broken where it jumps by more than a gap.
fn push(curve: &mut Vec<(f64, f64)>, t: f64, y: f64, gap: f64) {
    if let Some((before, last)) = curve.last().copied()
        && (last - y).abs() > gap
    {
        curve.push((f64::midpoint(before, t), f64::INFINITY));
    }
    curve.push((t, y));
}

fn too_fast() -> Refusal {
    Refusal::because(
        "the rotation is too fast to be integrated over this duration: write a shorter one, or a lower angular velocity",
    )
}
