//! Laws of motion of a follower: lift over the cam angle, each as a fraction of its whole, with three derivatives.

use std::f64::consts::PI;

use dalembert_core::Inputs;
use dalembert_mechanics::Real;

/// Law of a rise or a return.
///
/// A return is the rise of the same law, subtracted from the lift at which it begins.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum MotionLaw {
    /// Uniform velocity
    Uniform,
    /// Parabolic: constant acceleration
    /// Constant acceleration over the first half, and the same deceleration over the second.
    Parabolic,
    /// Simple harmonic
    SimpleHarmonic,
    /// Cycloidal
    Cycloidal,
    /// 3-4-5 polynomial
    Polynomial345,
    /// 4-5-6-7 polynomial
    Polynomial4567,
    /// Modified trapezoidal acceleration
    ModifiedTrapezoid,
    /// Modified sinusoidal acceleration
    ModifiedSine,
    /// Double harmonic
    DoubleHarmonic,
    /// Half-cycloidal, accelerating
    /// From a dwell up to a velocity of twice the mean.
    HalfCycloidalStart,
    /// Half-cycloidal, decelerating
    /// From a velocity of twice the mean down to a dwell.
    HalfCycloidalEnd,
    /// Half-harmonic, accelerating
    HalfHarmonicStart,
    /// Half-harmonic, decelerating
    HalfHarmonicEnd,
}

/// Extremes of a law for a rise of 1 over a cam angle of 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Peaks {
    pub velocity: f64,
    pub acceleration: f64,
    /// Lowest acceleration, zero or negative.
    pub deceleration: f64,
    /// Largest magnitude of the jerk; none where the acceleration jumps within the stroke.
    pub jerk: Option<f64>,
}

impl MotionLaw {
    /// Ends of the pieces on each of which the law is one formula.
    pub(super) fn breaks(self) -> &'static [f64] {
        match self {
            MotionLaw::Parabolic => &[0.0, 0.5, 1.0],
            MotionLaw::ModifiedTrapezoid => &[0.0, 0.125, 0.375, 0.625, 0.875, 1.0],
            MotionLaw::ModifiedSine => &[0.0, 0.125, 0.875, 1.0],
            _ => &[0.0, 1.0],
        }
    }

    /// The piece that holds at a place; the later one at an end.
    pub(super) fn piece(self, x: f64) -> usize {
        let breaks = self.breaks();
        breaks[1..breaks.len() - 1].iter().filter(|end| **end <= x).count()
    }

    /// Lift and its first three derivatives at the fraction `x` of the cam angle, by the formula of a piece. R. L. Norton,
    /// *Design of Machinery*, §8.3; J. J. Uicker, G. R. Pennock, J. E. Shigley, *Theory of Machines and Mechanisms*, ch. 5.
    pub(super) fn at<N: Real>(self, x: N, piece: usize) -> [N; 4] {
        let one = N::from(1.0);
        match self {
            MotionLaw::Uniform => [x, one, one * 0.0, one * 0.0],
            MotionLaw::Parabolic if piece == 0 => [x.powi(2) * 2.0, x * 4.0, one * 4.0, one * 0.0],
            MotionLaw::Parabolic => {
                let rest = one - x;
                [one - rest.powi(2) * 2.0, rest * 4.0, one * -4.0, one * 0.0]
            }
            MotionLaw::SimpleHarmonic => {
                let (sin, cos) = ((x * PI).sin(), (x * PI).cos());
                [(one - cos) / 2.0, sin * PI / 2.0, cos * PI * PI / 2.0, -(sin * PI.powi(3) / 2.0)]
            }
            MotionLaw::Cycloidal => {
                let turn = 2.0 * PI;
                let (sin, cos) = ((x * turn).sin(), (x * turn).cos());
                [x - sin / turn, one - cos, sin * turn, cos * turn * turn]
            }
            MotionLaw::Polynomial345 => [
                x.powi(3) * 10.0 - x.powi(4) * 15.0 + x.powi(5) * 6.0,
                x.powi(2) * 30.0 - x.powi(3) * 60.0 + x.powi(4) * 30.0,
                x * 60.0 - x.powi(2) * 180.0 + x.powi(3) * 120.0,
                one * 60.0 - x * 360.0 + x.powi(2) * 360.0,
            ],
            MotionLaw::Polynomial4567 => [
                x.powi(4) * 35.0 - x.powi(5) * 84.0 + x.powi(6) * 70.0 - x.powi(7) * 20.0,
                x.powi(3) * 140.0 - x.powi(4) * 420.0 + x.powi(5) * 420.0 - x.powi(6) * 140.0,
                x.powi(2) * 420.0 - x.powi(3) * 1680.0 + x.powi(4) * 2100.0 - x.powi(5) * 840.0,
                x * 840.0 - x.powi(2) * 5040.0 + x.powi(3) * 8400.0 - x.powi(4) * 4200.0,
            ],
            MotionLaw::ModifiedTrapezoid | MotionLaw::ModifiedSine if 2 * piece + 2 > self.breaks().len() => {
                // The second half is the first one, turned about the middle.
                let [lift, rate, second, third] = self.at(one - x, self.breaks().len() - 2 - piece);
                [one - lift, rate, -second, third]
            }
            MotionLaw::ModifiedTrapezoid => modified_trapezoid(x, piece),
            MotionLaw::ModifiedSine => modified_sine(x, piece),
            MotionLaw::DoubleHarmonic => {
                let (sin, cos) = ((x * PI).sin(), (x * PI).cos());
                let (sin2, cos2) = ((x * (2.0 * PI)).sin(), (x * (2.0 * PI)).cos());
                [
                    (one - cos) / 2.0 - (one - cos2) / 8.0,
                    sin * (PI / 2.0) - sin2 * (PI / 4.0),
                    (cos - cos2) * (PI * PI / 2.0),
                    (sin2 * 2.0 - sin) * (PI.powi(3) / 2.0),
                ]
            }
            MotionLaw::HalfCycloidalStart => {
                let (sin, cos) = ((x * PI).sin(), (x * PI).cos());
                [x - sin / PI, one - cos, sin * PI, cos * PI * PI]
            }
            MotionLaw::HalfCycloidalEnd => {
                let (sin, cos) = ((x * PI).sin(), (x * PI).cos());
                [x + sin / PI, one + cos, -(sin * PI), -(cos * PI * PI)]
            }
            MotionLaw::HalfHarmonicStart => {
                let half = PI / 2.0;
                let (sin, cos) = ((x * half).sin(), (x * half).cos());
                [one - cos, sin * half, cos * half * half, -(sin * half.powi(3))]
            }
            MotionLaw::HalfHarmonicEnd => {
                let half = PI / 2.0;
                let (sin, cos) = ((x * half).sin(), (x * half).cos());
                [sin, cos * half, -(sin * half * half), -(cos * half.powi(3))]
            }
        }
    }

    /// Extremes in closed form. R. L. Norton, *Design of Machinery*, table 8-3.
    pub(super) fn peaks(self) -> Peaks {
        let symmetric = |velocity: f64, acceleration: f64, jerk: Option<f64>| Peaks {
            velocity,
            acceleration,
            deceleration: -acceleration,
            jerk,
        };
        let (square, cube) = (PI * PI, PI * PI * PI);
        match self {
            MotionLaw::Uniform => symmetric(1.0, 0.0, Some(0.0)),
            MotionLaw::Parabolic => symmetric(2.0, 4.0, None),
            MotionLaw::SimpleHarmonic => symmetric(PI / 2.0, square / 2.0, Some(cube / 2.0)),
            MotionLaw::Cycloidal => symmetric(2.0, 2.0 * PI, Some(4.0 * square)),
            MotionLaw::Polynomial345 => symmetric(1.875, 10.0 / 3f64.sqrt(), Some(60.0)),
            MotionLaw::Polynomial4567 => symmetric(2.1875, 84.0 * 5f64.sqrt() / 25.0, Some(52.5)),
            MotionLaw::ModifiedTrapezoid => {
                let most = 8.0 * PI / (PI + 2.0);
                symmetric(2.0, most, Some(4.0 * PI * most))
            }
            MotionLaw::ModifiedSine => {
                let most = 4.0 * square / (PI + 4.0);
                symmetric(most / PI, most, Some(4.0 * PI * most))
            }
            MotionLaw::DoubleHarmonic => {
                let cos = (1.0 - 129f64.sqrt()) / 16.0;
                Peaks {
                    velocity: 3.0 * 3f64.sqrt() * PI / 8.0,
                    acceleration: 9.0 * square / 16.0,
                    deceleration: -square,
                    jerk: Some((1.0 - cos * cos).sqrt() * (1.0 - 4.0 * cos) * cube / 2.0),
                }
            }
            MotionLaw::HalfCycloidalStart => {
                Peaks { velocity: 2.0, acceleration: PI, deceleration: 0.0, jerk: Some(square) }
            }
            MotionLaw::HalfCycloidalEnd => {
                Peaks { velocity: 2.0, acceleration: 0.0, deceleration: -PI, jerk: Some(square) }
            }
            MotionLaw::HalfHarmonicStart => Peaks {
                velocity: PI / 2.0,
                acceleration: square / 4.0,
                deceleration: 0.0,
                jerk: Some(cube / 8.0),
            },
            MotionLaw::HalfHarmonicEnd => Peaks {
                velocity: PI / 2.0,
                acceleration: 0.0,
                deceleration: -square / 4.0,
                jerk: Some(cube / 8.0),
            },
        }
    }

    /// The three constants of velocity, acceleration and jerk as they are written.
    pub(super) fn constants(self) -> [&'static str; 3] {
        match self {
            MotionLaw::Uniform => ["1", "0", "0"],
            MotionLaw::Parabolic => ["2", "4", "∞"],
            MotionLaw::SimpleHarmonic => ["π/2", "π²/2", "π³/2"],
            MotionLaw::Cycloidal => ["2", "2π", "4π²"],
            MotionLaw::Polynomial345 => ["15/8", "10/√3", "60"],
            MotionLaw::Polynomial4567 => ["35/16", "84√5/25", "105/2"],
            MotionLaw::ModifiedTrapezoid => ["2", "8π/(π + 2)", "32π²/(π + 2)"],
            MotionLaw::ModifiedSine => ["4π/(π + 4)", "4π²/(π + 4)", "16π³/(π + 4)"],
            MotionLaw::DoubleHarmonic => ["3√3 π/8", "π²", "π³/2 √(1 − c²)(1 − 4c), c = (1 − √129)/16"],
            MotionLaw::HalfCycloidalStart | MotionLaw::HalfCycloidalEnd => ["2", "π", "π²"],
            MotionLaw::HalfHarmonicStart | MotionLaw::HalfHarmonicEnd => ["π/2", "π²/4", "π³/8"],
        }
    }

    /// The formula of the lift, in words of a step.
    pub(super) fn formula(self, piece: usize) -> &'static str {
        match self {
            MotionLaw::Uniform => "Lift as a fraction of the stroke, uniform velocity: y = x",
            MotionLaw::Parabolic if piece == 0 => {
                "Lift as a fraction of the stroke, constant acceleration over the first half: y = 2x²"
            }
            MotionLaw::Parabolic => {
                "Lift as a fraction of the stroke, constant deceleration over the second half: y = 1 − 2(1 − x)²"
            }
            MotionLaw::SimpleHarmonic => {
                "Lift as a fraction of the stroke, simple harmonic: y = (1 − cos πx)/2"
            }
            MotionLaw::Cycloidal => "Lift as a fraction of the stroke, cycloidal: y = x − sin(2πx)/(2π)",
            MotionLaw::Polynomial345 => {
                "Lift as a fraction of the stroke, 3-4-5 polynomial: y = 10x³ − 15x⁴ + 6x⁵"
            }
            MotionLaw::Polynomial4567 => {
                "Lift as a fraction of the stroke, 4-5-6-7 polynomial: y = 35x⁴ − 84x⁵ + 70x⁶ − 20x⁷"
            }
            MotionLaw::ModifiedTrapezoid => {
                "Lift as a fraction of the stroke, modified trapezoid: y″ is a sine on x < 1/8, constant to 3/8, a sine to 5/8, constant to 7/8 and a sine again"
            }
            MotionLaw::ModifiedSine => {
                "Lift as a fraction of the stroke, modified sine: y″ is C sin 4πx on x < 1/8, C cos(4π/3 (x − 1/8)) to 7/8, and a sine again"
            }
            MotionLaw::DoubleHarmonic => {
                "Lift as a fraction of the stroke, double harmonic: y = (1 − cos πx)/2 − (1 − cos 2πx)/8"
            }
            MotionLaw::HalfCycloidalStart => {
                "Lift as a fraction of the stroke, half-cycloidal from a dwell: y = x − sin(πx)/π"
            }
            MotionLaw::HalfCycloidalEnd => {
                "Lift as a fraction of the stroke, half-cycloidal to a dwell: y = x + sin(πx)/π"
            }
            MotionLaw::HalfHarmonicStart => {
                "Lift as a fraction of the stroke, half-harmonic from a dwell: y = 1 − cos(πx/2)"
            }
            MotionLaw::HalfHarmonicEnd => {
                "Lift as a fraction of the stroke, half-harmonic to a dwell: y = sin(πx/2)"
            }
        }
    }
}

/// First half of the modified trapezoid: sine, constant, sine.
fn modified_trapezoid<N: Real>(x: N, piece: usize) -> [N; 4] {
    const TURN: f64 = 4.0 * PI;
    let most = N::from(8.0 * PI / (PI + 2.0));
    let flat = most / TURN;
    let first = flat * (0.125 - 1.0 / TURN);
    match piece {
        0 => {
            let (sin, cos) = ((x * TURN).sin(), (x * TURN).cos());
            let one = N::from(1.0);
            [flat * (x - sin / TURN), flat * (one - cos), most * sin, most * cos * TURN]
        }
        1 => {
            let gone = x - 0.125;
            [first + flat * gone + most * gone.powi(2) / 2.0, flat + most * gone, most, most * 0.0]
        }
        _ => {
            let gone = x - 0.375;
            let (sin, cos) = ((gone * TURN).sin(), (gone * TURN).cos());
            let before = first + flat / 4.0 + most / 32.0;
            let one = N::from(1.0);
            [
                before + (flat + most / 4.0) * gone + flat / TURN * (one - cos),
                flat + most / 4.0 + flat * sin,
                most * cos,
                -(most * sin * TURN),
            ]
        }
    }
}

/// First half of the modified sine: a quick sine, then a slow one.
fn modified_sine<N: Real>(x: N, piece: usize) -> [N; 4] {
    const TURN: f64 = 4.0 * PI;
    let most = N::from(4.0 * PI * PI / (PI + 4.0));
    let flat = most / TURN;
    if piece == 0 {
        let (sin, cos) = ((x * TURN).sin(), (x * TURN).cos());
        let one = N::from(1.0);
        return [flat * (x - sin / TURN), flat * (one - cos), most * sin, most * cos * TURN];
    }
    const SLOW: f64 = TURN / 3.0;
    let gone = x - 0.125;
    let (sin, cos) = ((gone * SLOW).sin(), (gone * SLOW).cos());
    let first = flat * (0.125 - 1.0 / TURN);
    let one = N::from(1.0);
    [
        first + flat * gone + most / (SLOW * SLOW) * (one - cos),
        flat + most / SLOW * sin,
        most * cos,
        -(most * sin * SLOW),
    ]
}
