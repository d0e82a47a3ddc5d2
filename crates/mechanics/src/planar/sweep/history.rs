//! Prediction of the tree coordinates from their derivatives at the last positions.

use crate::planar::tolerances::{HISTORY, MAX_STEP_GROWTH};
use dalembert_numerics::simd::SimdReal;

/// First and second derivatives of the tree coordinates by the value of the driver at the last positions, the newest
/// first.
///
/// A step integrates the polynomial that has the first derivatives of all positions and, as its derivatives, the second
/// ones: Hermite's interpolation by divided differences (J. Stoer, R. Bulirsch, *Introduction to Numerical Analysis*,
/// 3rd ed., §2.1.5). Its error is of the seventh order of the step where two positions came before, and that of
/// Taylor's series of second order where none did.
#[derive(Debug, Clone)]
pub(super) struct History<S> {
    /// The steps from each to the position after it.
    steps: [S; HISTORY],
    derivatives: [Vec<[S; 2]>; HISTORY],
    known: usize,
}

/// The weights of the divided differences in a step, the same for all coordinates.
pub(super) struct Weights<S> {
    known: usize,
    /// One over the last step, over the one before it, and over both.
    per: [S; 3],
    /// The integrals of the products that belong to the divided differences.
    integrals: [S; 6],
}

impl<S: SimdReal> History<S> {
    pub(super) fn new(tree: usize) -> Self {
        let zero = S::from(0.0);
        let derivatives = [(); HISTORY].map(|()| vec![[zero; 2]; tree]);
        Self { steps: [zero; HISTORY], derivatives, known: 0 }
    }

    /// Forgets all positions.
    pub(super) fn forget(&mut self) {
        self.known = 0;
    }

    /// Returns true if an earlier position is known.
    pub(super) fn is_known(&self) -> bool {
        self.known > 0
    }

    /// Adds the derivatives of the position from which a step was taken.
    pub(super) fn push(&mut self, step: S, derivatives: impl Iterator<Item = [S; 2]>) {
        self.steps.rotate_right(1);
        self.derivatives.rotate_right(1);
        self.steps[0] = step;
        for (place, derivatives) in self.derivatives[0].iter_mut().zip(derivatives) {
            *place = derivatives;
        }
        self.known = (self.known + 1).min(HISTORY);
    }

    /// The weights of a step `h` of the driver.
    #[inline(always)]
    pub(super) fn weights(&self, h: S) -> Weights<S> {
        let fits = |step: &S| {
            (0..S::COUNT).all(|lane| h.lane(lane).abs() <= MAX_STEP_GROWTH * step.lane(lane).abs())
        };
        let known = self.steps[..self.known].iter().take_while(|step| fits(step)).count();
        let [last, before] = self.steps;
        let (d, e) = (last, last + before);
        // A lane at the end of its values is at rest.
        let inverse = |x: S| x.each(|x| if x == 0.0 { 0.0 } else { 1.0 / x });
        // hⁿ/n, the integral of tⁿ⁻¹.
        let second = h * h / 2.0;
        let third = second * h * (2.0 / 3.0);
        let fourth = third * h * (3.0 / 4.0);
        let fifth = fourth * h * (4.0 / 5.0);
        let sixth = fifth * h * (5.0 / 6.0);
        Weights {
            known,
            per: [d, before, e].map(inverse),
            // Of 1, t, t², t² (t + d), t² (t + d)², t² (t + d)² (t + e).
            integrals: [
                h,
                second,
                third,
                fourth + d * third,
                fifth + d * (fourth * 2.0 + d * third),
                sixth + (d * 2.0 + e) * fifth + d * ((d + e * 2.0) * fourth + d * e * third),
            ],
        }
    }

    /// The predicted change of the tree coordinate of this number, m, from a position with these derivatives.
    #[inline(always)]
    pub(super) fn change(&self, number: usize, [v, a]: [S; 2], weights: &Weights<S>) -> S {
        let &Weights { known, per: [per_last, per_before, per_both], ref integrals } = weights;
        let mut change = v * integrals[0] + a * integrals[1];
        if known == 0 {
            return change;
        }
        // f01 is the divided difference of the present position and the last one, f001 that with the present
        // derivative, …
        let [v1, a1] = self.derivatives[0][number];
        let f01 = (v - v1) * per_last;
        let (f001, f011) = ((a - f01) * per_last, (f01 - a1) * per_last);
        let f0011 = (f001 - f011) * per_last;
        change = change + f001 * integrals[2] + f0011 * integrals[3];
        if known == 1 {
            return change;
        }
        let [v2, a2] = self.derivatives[1][number];
        let f12 = (v1 - v2) * per_before;
        let (f112, f122) = ((a1 - f12) * per_before, (f12 - a2) * per_before);
        let f1122 = (f112 - f122) * per_before;
        let f0112 = (f011 - f112) * per_both;
        let (f00112, f01122) = ((f0011 - f0112) * per_both, (f0112 - f1122) * per_both);
        change + f00112 * integrals[4] + (f00112 - f01122) * per_both * integrals[5]
    }
}
