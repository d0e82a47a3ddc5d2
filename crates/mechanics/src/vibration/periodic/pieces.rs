//! The usual waves, of amplitude one, in pieces of their period.

use std::f64::consts::{PI, TAU};

use super::WaveSegment;

/// `1` for the first half of the period, `−1` for the second.
pub fn square() -> Vec<WaveSegment> {
    vec![straight(0.0, 0.5, 1.0, 1.0), straight(0.5, 1.0, -1.0, -1.0)]
}

/// From zero up to `1` at a quarter of the period, down to `−1` at three quarters, and back.
pub fn triangle() -> Vec<WaveSegment> {
    vec![straight(0.0, 0.25, 0.0, 1.0), straight(0.25, 0.75, 1.0, -1.0), straight(0.75, 1.0, -1.0, 0.0)]
}

/// From zero up to `1` over the period, then at once back to zero.
pub fn sawtooth() -> Vec<WaveSegment> {
    vec![straight(0.0, 1.0, 0.0, 1.0)]
}

/// The positive half of a sine; zero for the second half of the period.
pub fn half_rectified() -> Vec<WaveSegment> {
    vec![arch(0.0, 0.5, TAU), straight(0.5, 1.0, 0.0, 0.0)]
}

/// The positive half of a sine, again and again: one arch a period.
pub fn full_rectified() -> Vec<WaveSegment> {
    vec![arch(0.0, 1.0, PI)]
}

/// `1` for a share of the period, then zero.
pub fn pulse(share: f64) -> Vec<WaveSegment> {
    vec![straight(0.0, share, 1.0, 1.0), straight(share, 1.0, 0.0, 0.0)]
}

/// Straight lines through points `(share of the period, value)`, shares ascending in `[0, 1)`; the last point is
/// joined to the first one of the next period. Two points at one share are a jump. `None` for fewer than two points or
/// shares that do not ascend within the period.
pub fn polygon(points: &[(f64, f64)]) -> Option<Vec<WaveSegment>> {
    let (first, last) = (points.first()?, points.last()?);
    let within = points.iter().all(|(s, u)| (0.0..=1.0).contains(s) && u.is_finite());
    if points.len() < 2 || !within || points.windows(2).any(|pair| pair[0].0 > pair[1].0) {
        return None;
    }
    let mut pieces: Vec<WaveSegment> = Vec::with_capacity(points.len() + 1);
    let gap = first.0 + 1.0 - last.0;
    let at_end = if gap > 0.0 { last.1 + (first.1 - last.1) * (1.0 - last.0) / gap } else { first.1 };
    if first.0 > 0.0 {
        pieces.push(straight(0.0, first.0, at_end, first.1));
    }
    for pair in points.windows(2).filter(|pair| pair[1].0 > pair[0].0) {
        pieces.push(straight(pair[0].0, pair[1].0, pair[0].1, pair[1].1));
    }
    if last.0 < 1.0 {
        pieces.push(straight(last.0, 1.0, last.1, at_end));
    }
    Some(pieces)
}

fn straight(from: f64, to: f64, value: f64, end: f64) -> WaveSegment {
    let slope = if to > from { (end - value) / (to - from) } else { 0.0 };
    WaveSegment { from, to, value, slope, sine: 0.0, rate: 0.0 }
}

fn arch(from: f64, to: f64, rate: f64) -> WaveSegment {
    WaveSegment { from, to, value: 0.0, slope: 0.0, sine: 1.0, rate }
}
