//! Height of the load and length of the spring as functions of the angle of the arm.

use dalembert_core::{Refusal, Worksheet};
use dalembert_mechanics::Real;

use crate::shared::equilibria::{WorkedEquilibrium, answer_equilibria};

/// Geometry of the spring: `u = stretch²/2`, so that its energy is `k u`.
#[derive(Clone, Copy, Debug)]
pub(super) enum Geometry<N> {
    Torsion { free: Option<N> },
    Drum { radius: N, free: Option<N> },
    Points { on_arm: N, fixed: N, between: N, free: N },
    Sides { height: N },
}

/// The height of the load over that with a horizontal arm, as a part of its arm; or the angle against which a
/// couple works.
#[derive(Clone, Copy, Debug)]
pub(super) enum Height<N> {
    Upright,
    Horizontal,
    Hanging,
    Tilted(N),
    Couple,
}

/// `V = k u(θ) + M h(θ)`.
#[derive(Clone, Copy, Debug)]
pub(super) struct PotentialLaw<N> {
    pub(super) geometry: Geometry<N>,
    pub(super) height: Height<N>,
}

/// The length of a spring between points at `b` and `d` from a pivot that see each other under an angle there.
pub(super) fn length<N: Real>(b: N, d: N, angle: N) -> N {
    (b.powi(2) + d.powi(2) - b * d * angle.cos() * 2.0).sqrt()
}

/// Derivative with respect to the angle.
pub(super) fn rate<N: Real>(b: N, d: N, angle: N, length: N) -> N {
    b * d * angle.sin() / length
}

/// The slope of its slope.
fn bend<N: Real>(b: N, d: N, angle: N, length: N, rate: N) -> N {
    (b * d * angle.cos() - rate.powi(2)) / length
}

impl<N: Real> Height<N> {
    /// Direction of the load's motion (true for down) and its magnitude for its arm and δθ: `h′ = ∓ …`.
    pub(super) fn slope(&self, angle: N) -> (bool, N) {
        match self {
            Height::Upright => (true, angle.sin()),
            Height::Horizontal => (true, angle.cos()),
            Height::Hanging => (false, angle.sin()),
            Height::Tilted(tilt) => (true, (angle + *tilt).sin()),
            Height::Couple => (true, N::from(1.0)),
        }
    }

    fn bend(&self, angle: N) -> Option<(bool, N)> {
        match self {
            Height::Upright => Some((true, angle.cos())),
            Height::Horizontal => Some((false, angle.sin())),
            Height::Hanging => Some((false, angle.cos())),
            Height::Tilted(tilt) => Some((true, (angle + *tilt).cos())),
            Height::Couple => None,
        }
    }

    fn height(&self, angle: N) -> N {
        match self {
            Height::Upright => angle.cos(),
            Height::Horizontal => -angle.sin(),
            Height::Hanging => -angle.cos(),
            Height::Tilted(tilt) => (angle + *tilt).cos(),
            Height::Couple => -angle,
        }
    }
}

impl<N: Real> PotentialLaw<N> {
    pub(super) fn value(&self) -> PotentialLaw<f64> {
        let free = |free: Option<N>| free.map(Real::value);
        let geometry = match self.geometry {
            Geometry::Torsion { free: at } => Geometry::Torsion { free: free(at) },
            Geometry::Drum { radius, free: at } => Geometry::Drum { radius: radius.value(), free: free(at) },
            Geometry::Points { on_arm, fixed, between, free } => Geometry::Points {
                on_arm: on_arm.value(),
                fixed: fixed.value(),
                between: between.value(),
                free: free.value(),
            },
            Geometry::Sides { height } => Geometry::Sides { height: height.value() },
        };
        let height = match self.height {
            Height::Upright => Height::Upright,
            Height::Horizontal => Height::Horizontal,
            Height::Hanging => Height::Hanging,
            Height::Tilted(tilt) => Height::Tilted(tilt.value()),
            Height::Couple => Height::Couple,
        };
        PotentialLaw { geometry, height }
    }

    /// `u`, `u′` and `u″` at an angle, with the lengths of a spring between points.
    fn spring(&self, angle: N, lengths: Option<[N; 3]>) -> [N; 3] {
        let from = |free: Option<N>| free.map_or(angle, |free| angle - free);
        match (self.geometry, lengths) {
            (Geometry::Torsion { free }, _) => {
                let twist = from(free);
                [twist.powi(2) / 2.0, twist, N::from(1.0)]
            }
            (Geometry::Drum { radius, free }, _) => {
                let turn = from(free);
                [(radius * turn).powi(2) / 2.0, radius.powi(2) * turn, radius.powi(2)]
            }
            (Geometry::Sides { height }, _) => [
                (height * angle.sin()).powi(2),
                height.powi(2) * angle.sin() * angle.cos() * 2.0,
                height.powi(2) * (angle * 2.0).cos() * 2.0,
            ],
            (Geometry::Points { free, .. }, Some([s, s1, s2])) => {
                [(s - free).powi(2) / 2.0, (s - free) * s1, s1.powi(2) + (s - free) * s2]
            }
            (Geometry::Points { .. }, None) => unreachable!("a spring between points comes with its lengths"),
        }
    }

    /// The same, with the lengths of a spring between points written down for the `n`th equilibrium.
    pub(super) fn unit_spring<W: Worksheet<Num = N>>(&self, n: usize, angle: N, sheet: W) -> [N; 3] {
        let lengths = match self.geometry {
            Geometry::Points { on_arm, fixed, between, .. } => {
                let at = angle + between;
                let s = sheet.step(
                    ("s", n),
                    "mm",
                    length(on_arm, fixed, at),
                    "Length of the spring, by the law of cosines",
                );
                sheet.common_error(("s′", n), "the spring taken as perpendicular to the arm", || on_arm);
                let s1 = sheet.step(
                    ("s′", n),
                    "mm",
                    rate(on_arm, fixed, at, s),
                    "Its virtual variation per δθ: 2 s δs = 2 b d sin(θ + ψ₀) δθ",
                );
                let s2 =
                    sheet.step(("s″", n), "mm", bend(on_arm, fixed, at, s, s1), "Derivative of that change");
                Some([s, s1, s2])
            }
            _ => None,
        };
        self.spring(angle, lengths)
    }

    /// `V`, `dV/dθ` and `d²V/dθ²` from `u`, `u′` and `u″`.
    pub(super) fn with_load(&self, k: N, moment: N, angle: N, [u, u1, u2]: [N; 3]) -> [N; 3] {
        let torsion = matches!(self.geometry, Geometry::Torsion { .. });
        let (down, slope) = self.height.slope(angle);
        let couple = matches!(self.height, Height::Couple);
        let load = if couple { moment } else { moment * slope };
        let first = if down { k * u1 - load } else { k * u1 + load };
        let spring = if torsion { k } else { k * u2 };
        let second = match self.height.bend(angle) {
            None => spring,
            Some((true, bend)) => spring - moment * bend,
            Some((false, bend)) => spring + moment * bend,
        };
        [k * u + moment * self.height.height(angle), first, second]
    }

    /// Finds and answers all equilibria in a range.
    pub(super) fn equilibria<W: Worksheet<Num = N>>(
        &self,
        k: N,
        moment: N,
        range: [f64; 2],
        sheet: W,
    ) -> Result<(Vec<WorkedEquilibrium>, Vec<N>), Refusal> {
        let numbers = self.value();
        answer_equilibria(
            sheet,
            range,
            |n, angle| self.with_load(k, moment, angle, self.unit_spring(n, angle, sheet)),
            |angle| numbers.potential(k.value(), moment.value(), angle),
        )
    }
}

impl PotentialLaw<f64> {
    /// `u`, `u′` and `u″`.
    pub(super) fn plain_spring(&self, angle: f64) -> [f64; 3] {
        let lengths = match self.geometry {
            Geometry::Points { on_arm, fixed, between, .. } => {
                let at = angle + between;
                let s = length(on_arm, fixed, at);
                let s1 = rate(on_arm, fixed, at, s);
                Some([s, s1, bend(on_arm, fixed, at, s, s1)])
            }
            _ => None,
        };
        self.spring(angle, lengths)
    }

    /// The size of what the couples and their growth are added up from.
    pub(super) fn size(&self, k: f64, moment: f64, angle: f64) -> f64 {
        let [_, first, second] = self.plain_spring(angle);
        k.abs() * first.abs().max(second.abs()) + moment.abs()
    }

    /// `V`, `dV/dθ` and `d²V/dθ²`.
    pub(super) fn potential(&self, k: f64, moment: f64, angle: f64) -> [f64; 3] {
        self.with_load(k, moment, angle, self.plain_spring(angle))
    }
}
