//! Event location within a step: changes of sign, and the first of several margins to be used up.

use std::ops::ControlFlow;

use super::{Integrator, OdeSystem};
use crate::roots;

/// The places of a step between which a change of sign is searched for, in parts of it: just before its end too, since
/// where several numbers fall at once their signs are lost.
const PLACES: [f64; 7] = [1.0 / 6.0, 2.0 / 6.0, 3.0 / 6.0, 4.0 / 6.0, 5.0 / 6.0, 0.998, 1.0];
/// Two moments less than this part of a step apart are the same.
pub const SAME_TIME: f64 = 1e-9;
/// Halvings of the way from the begin to such a place in which a short rise is searched for.
const RISES: i32 = 24;

impl Integrator {
    /// Time of the first sign change, within the last step, of a function of time and state; a zero at the start of the
    /// step does not count.
    pub fn first_zero<P: OdeSystem>(
        &mut self,
        problem: &mut P,
        mut number: impl FnMut(&mut P, f64, &[f64]) -> f64,
    ) -> Option<f64> {
        let (before, end) = (self.before, self.time);
        let mut at = |this: &mut Self, time: f64| {
            let state = this.at(problem, time);
            number(problem, time, &state)
        };
        let mut from = (before, at(self, before));
        for time in places(before, end) {
            let here = (time, at(self, time));
            if from.1 * here.1 < 0.0 || (from.1 != 0.0 && here.1 == 0.0) {
                let on = |_| ControlFlow::Continue(());
                return roots::find(|time| at(self, time), [from.0, here.0], on).ok();
            }
            from = here;
        }
        None
    }

    /// Time and index of the first of several functions of time and state that falls through zero in the last step. A
    /// number that is not above `noise` at the begin has to rise above it before; one that falls below −`noise`
    /// without, has fallen at the begin.
    pub fn first_fall<P: OdeSystem>(
        &mut self,
        problem: &mut P,
        noise: f64,
        mut numbers: impl FnMut(&mut P, f64, &[f64], &mut Vec<f64>),
    ) -> Option<(f64, usize)> {
        let mut at = |this: &mut Self, time: f64, found: &mut Vec<f64>| {
            let state = this.at(problem, time);
            numbers(problem, time, &state, found);
        };
        // Of two falls close together the earlier one may lie between the places examined: look again up to the later.
        let mut first = None;
        let mut end = self.time;
        while let Some((time, index)) = self.falls(noise, end, &mut at) {
            first = Some((time, index));
            if time >= end - SAME_TIME * (end - self.before) {
                break;
            }
            end = time;
        }
        first
    }

    /// The first fall that is seen at some places of the last step up to a time.
    fn falls(
        &mut self,
        noise: f64,
        end: f64,
        at: &mut impl FnMut(&mut Self, f64, &mut Vec<f64>),
    ) -> Option<(f64, usize)> {
        let before = self.before;
        let (mut last, mut here) = (Vec::new(), Vec::new());
        at(self, before, &mut last);
        let mut from = before;
        for number in &mut last {
            *number = if *number > noise { *number } else { 0.0 };
        }
        for to in places(before, end) {
            at(self, to, &mut here);
            let mut first: Option<(f64, usize)> = None;
            for index in 0..last.len() {
                let mut found = Vec::new();
                let mut number = |time: f64| {
                    at(self, time, &mut found);
                    found[index]
                };
                let from = if last[index] > 0.0 && here[index] <= 0.0 {
                    Some(from)
                } else if last[index] == 0.0 && here[index] < -noise {
                    // It may have risen for a moment that is shorter than the part of the step.
                    let mut moments =
                        (1..RISES).map(|halvings| before + (to - before) * 0.5f64.powi(halvings));
                    moments.find(|&time| number(time) > noise)
                } else {
                    continue;
                };
                let zero =
                    |from| roots::find(number, [from, to], |_| ControlFlow::Continue(())).unwrap_or(to);
                let fallen = from.map_or(before, zero);
                if first.is_none_or(|(time, _)| fallen < time) {
                    first = Some((fallen, index));
                }
            }
            if first.is_some() {
                return first;
            }
            for (last, here) in last.iter_mut().zip(&here) {
                if *last != 0.0 || *here > noise {
                    *last = *here;
                }
            }
            from = to;
        }
        None
    }
}

/// The times of these places in a part of a step.
fn places(begin: f64, end: f64) -> [f64; 7] {
    PLACES.map(|part| if part == 1.0 { end } else { begin + part * (end - begin) })
}
