//! Rotation angles of a top, by quadrature over `χ`, with `cos θ = u₂ + (u₁ − u₂) sin² χ`.

use std::f64::consts::{FRAC_PI_2, PI};

use dalembert_core::Worksheet;
use dalembert_mechanics::{
    Real,
    rigid::top::{Nutation, Top},
};
use dalembert_numerics::quadrature;

use super::NEAR_VERTICAL;

/// The time, `∫ φ̇ dt` and `∫ φ̇ cos θ dt`, and what rounding may do to the second of them.
type Sums = [f64; 4];

/// Holds time, precession and spin at an instant to the quadrature.
pub(super) fn check<W: Worksheet>(
    motion: &Nutation,
    body: Top,
    t: f64,
    [own, vertical]: [f64; 2],
    [theta, theta_rate, phi, psi]: [W::Num; 4],
    sheet: W,
) {
    let [high, low] = motion.limits();
    let (lower, third) = (low.cos(), motion.third_zero());
    let (above, below) = (2.0 * (high / 2.0).sin().powi(2), 2.0 * (low / 2.0).cos().powi(2));
    let range = 2.0 - above - below;
    if range < 1e-6 || high.sin().min(low.sin()) < NEAR_VERTICAL {
        return;
    }
    let argument_rate = |u: f64| (body.couple * (third - u) / (2.0 * body.transverse)).sqrt();
    let at = |chi: f64| -> Sums {
        let (sin, cos) = chi.sin_cos();
        let u = lower + range * sin * sin;
        let squared = (above + range * cos * cos) * (below + range * sin * sin);
        let across = body.transverse * squared;
        let rate = (vertical - own * u) / across;
        let lost =
            (vertical.abs() + own.abs()) / across + rate.abs() * (2.0 / squared + third.abs() / (third - u));
        [1.0, rate, rate * u, f64::EPSILON * lost].map(|x| x / argument_rate(u))
    };
    // Along χ, which grows by π in a nutation: sin 2χ and cos 2χ follow of cos θ and its rate.
    let along = |theta: f64, rate: f64| {
        let (sin, u) = theta.sin_cos();
        let double = f64::atan2(-sin * rate / argument_rate(u), range - 2.0 * (u - lower));
        (double / 2.0).rem_euclid(PI)
    };
    let first = motion.at(0.0);
    let start = along(first.nutation, first.nutation_rate);
    let end = along(theta.value(), theta_rate.value());
    // At a limit the rates have peaks as narrow as the axis is near the vertical, or the third zero near the limit.
    let third_near = ((third - high.cos()) / range).sqrt();
    let halvings =
        [low.sin(), high.sin().min(third_near)].map(|near| (8.0 / near.min(1.0)).log2().ceil() as i32);
    let sum = |at: &_, ends, parts| sum(at, ends, halvings, parts);
    let turned = |parts: u32| -> Sums {
        let whole = sum(&at, [0.0, PI], parts);
        let rest = if end >= start {
            sum(&at, [start, end], parts)
        } else {
            add(sum(&at, [start, PI], parts), sum(&at, [0.0, end], parts), 1.0)
        };
        let times = ((t - rest[0]) / whole[0]).round();
        add(rest, whole, times)
    };
    let (coarse, fine) = (turned(2), turned(4));
    let axial_velocity = own / body.axial;
    let spin = axial_velocity * t - fine[2];
    let size = axial_velocity.abs() * t + phi.value().abs();
    for (what, off, scale, lost, of) in [
        ("time to that angle by quadrature over the nutation", fine[0] - t, t.max(motion.period()), 0.0, 0),
        ("precession as the integral of its rate", fine[1] - phi.value(), size, fine[3], 1),
        ("spin as the integral of its rate", spin - psi.value(), size, fine[3], 2),
    ] {
        sheet.check_residual(what, off.into(), scale, lost + (fine[of] - coarse[of]).abs());
    }
}

fn add(a: Sums, b: Sums, times: f64) -> Sums {
    std::array::from_fn(|n| a[n] + times * b[n])
}

/// The integrals between two values of `χ`, in intervals that halve towards each quarter of a turn.
fn sum(at: &impl Fn(f64) -> Sums, [from, to]: [f64; 2], [low, high]: [i32; 2], parts: u32) -> Sums {
    let mut ends = vec![from, to];
    for (quarter, halvings) in [(0.0, low), (FRAC_PI_2, high), (PI, low)] {
        ends.push(quarter);
        for n in 1..=halvings {
            let off = FRAC_PI_2 * 0.5f64.powi(n);
            ends.extend([quarter - off, quarter + off]);
        }
    }
    ends.retain(|chi| (from..=to).contains(chi));
    ends.sort_by(f64::total_cmp);
    let over = |of: usize| {
        let each =
            ends.windows(2).map(|pair| quadrature::integral(|chi| at(chi)[of], [pair[0], pair[1]], parts));
        each.sum()
    };
    std::array::from_fn(over)
}
