//! Extrapolation of the coordinates from the preceding positions.

#![expect(clippy::inline_always, reason = "what is not inlined is not compiled for the widest registers")]

use dalembert_numerics::simd::SimdReal;

/// So many positions before the present one are made use of.
const BEFORE: usize = 2;
/// A step this much longer than the one before it is foretold without that one.
const LONGER: f64 = 2.0;

/// First and second derivatives of the kept coordinates at the positions before, the last one first.
///
/// A step integrates the polynomial that has the first derivatives of all positions and, as its derivatives, the second ones:
/// Hermite's interpolation by divided differences (J. Stoer, R. Bulirsch, *Introduction to Numerical Analysis*, 3rd ed.,
/// §2.1.5). Its error is of the seventh order of the step where two positions came before, and that of Taylor's series
/// of second order where none did.
#[derive(Debug, Clone)]
pub(super) struct Past<S> {
    /// The steps from each to the position after it.
    steps: [S; BEFORE],
    derivatives: [Vec<[S; 2]>; BEFORE],
    known: usize,
}

/// Weights of the divided differences in a step, the same for all coordinates.
pub(super) struct Weights<S> {
    known: usize,
    /// One over the last step, over the one before it, and over both.
    per: [S; 3],
    /// The integrals of the products that belong to the divided differences.
    integrals: [S; 6],
}

impl<S: SimdReal> Past<S> {
    pub(super) fn new(kept: usize) -> Self {
        let zero = S::from(0.0);
        let derivatives = [(); BEFORE].map(|()| vec![[zero; 2]; kept]);
        Self { steps: [zero; BEFORE], derivatives, known: 0 }
    }

    pub(super) fn forget(&mut self) {
        self.known = 0;
    }

    /// Takes the derivatives of a position that a step led away from.
    pub(super) fn push(&mut self, step: S, derivatives: impl Iterator<Item = [S; 2]>) {
        self.steps.rotate_right(1);
        self.derivatives.rotate_right(1);
        self.steps[0] = step;
        for (place, derivatives) in self.derivatives[0].iter_mut().zip(derivatives) {
            *place = derivatives;
        }
        self.known = (self.known + 1).min(BEFORE);
    }

    #[inline(always)]
    pub(super) fn weights(&self, h: S) -> Weights<S> {
        let fits = |step: &S| (0..S::COUNT).all(|lane| h.lane(lane).abs() <= LONGER * step.lane(lane).abs());
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

    /// Change of a coordinate over a step, from its derivatives.
    #[inline(always)]
    pub(super) fn change(&self, number: usize, [v, a]: [S; 2], weights: &Weights<S>) -> S {
        let &Weights { known, per: [per_last, per_before, per_both], ref integrals } = weights;
        let mut change = v * integrals[0] + a * integrals[1];
        if known == 0 {
            return change;
        }
        // f01 is the divided difference of the present position and the last one, f001 that with the present derivative, …
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
