//! The circle of a mode in the Nyquist plane, and what the frequencies round it say.

use std::f64::consts::{PI, TAU};

use nalgebra::{Complex, DMatrix, DVector};

use super::{
    DampingModel, MeasuredResponse, ModalError, ResponsePoint, beyond_rounding, check,
    minimise::{Minimum, minimise},
};
use dalembert_numerics::linalg;

/// A circle in the complex plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Circle {
    /// Centre.
    pub centre: Complex<f64>,
    /// Radius.
    pub radius: f64,
    /// Root mean square of the distances of the points from the circle, over its radius.
    pub misfit: f64,
}

/// A mode from the circle of its response.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CircleFit {
    /// The circle: of the receptance with hysteretic, of the mobility with viscous damping.
    pub circle: Circle,
    /// Natural frequency, rad/s.
    pub natural_frequency: f64,
    /// Damping ratio `ζ` with viscous, loss factor `η` with hysteretic damping.
    pub damping: f64,
    /// Size of the modal constant, 1/kg.
    pub modal_constant: f64,
    /// The frequencies a quarter of the circle before and after the natural one, rad/s.
    pub half_power: [f64; 2],
    /// The points of the circle at the natural frequency and at the half-power frequencies.
    pub marks: [Complex<f64>; 3],
    /// Largest and smallest damping from pairs of points, one below and one above the natural frequency; `None`
    /// without such a pair.
    pub damping_of_pairs: Option<[f64; 2]>,
    /// The slopes of the sum of squares of the angles: zero but for rounding.
    pub slopes: [f64; 3],
}

/// The circle through points in the complex plane, by least squares of `x² + y² + a x + b y + c`, which is linear in
/// its three unknowns; exact for three points.
///
/// # Errors
/// `TooFew` points, or `NoCircle` that they lie on.
pub fn fit_circle(points: &[Complex<f64>]) -> Result<Circle, ModalError> {
    if points.len() < 3 {
        return Err(ModalError::TooFew { have: points.len(), need: 3 });
    }
    let count = points.len() as f64;
    let mean = points.iter().map(|z| *z / count).sum::<Complex<f64>>();
    let size = points.iter().map(|z| (z - mean).norm()).fold(0.0, f64::max);
    if !(size.is_normal() && mean.norm().is_finite()) {
        return Err(ModalError::NoCircle);
    }
    // About their mean and over their size, so that nothing cancels.
    let reduced: Vec<Complex<f64>> = points.iter().map(|z| (z - mean) / size).collect();
    let a = DMatrix::from_fn(reduced.len(), 3, |i, j| [reduced[i].re, reduced[i].im, 1.0][j]);
    let b = DVector::from_fn(reduced.len(), |i, _| -reduced[i].norm_sqr());
    let solved = linalg::least_squares(&a, &b).map_err(|_| ModalError::NoCircle)?.x;
    let centre = Complex::new(-solved[0] / 2.0, -solved[1] / 2.0);
    let squared = centre.norm_sqr() - solved[2];
    if !(squared > 0.0 && squared < 1e12) {
        return Err(ModalError::NoCircle);
    }
    let radius = squared.sqrt();
    let off = reduced.iter().map(|z| ((z - centre).norm() / radius - 1.0).powi(2)).sum::<f64>() / count;
    Ok(Circle { centre: centre * size + mean, radius: radius * size, misfit: beyond_rounding(off.sqrt()) })
}

/// A mode by the circle fit: the receptance of a hysteretic, the mobility of a viscous mode is a circle, moved by
/// what other modes add. Round it the angle from the natural frequency is `θ = 2 arctan u` with
/// `u = (ω² − ω_n²)/(ηω_n²)` or `u = (ω² − ω_n²)/(2ζω_nω)`; natural frequency, damping and the direction of the
/// diameter follow by least squares of the angles. Ewins, 2nd ed., §4.3.3.
///
/// # Errors
/// All of [`ModalError`].
pub fn circle_fit(
    points: &[ResponsePoint],
    response: MeasuredResponse,
    model: DampingModel,
) -> Result<CircleFit, ModalError> {
    check(points, 3)?;
    let plane: Vec<Complex<f64>> = points
        .iter()
        .map(|point| {
            let receptance = response.receptance(*point);
            match model {
                DampingModel::Hysteretic => receptance,
                DampingModel::Viscous => receptance * Complex::new(0.0, point.0),
            }
        })
        .collect();
    let circle = fit_circle(&plane)?;
    let angles: Vec<f64> = plane.iter().map(|z| (z - circle.centre).arg()).collect();

    // The start: the natural frequency where the response is largest, the damping from the sweep about it.
    let largest = (0..plane.len())
        .max_by(|&i, &j| plane[i].norm().total_cmp(&plane[j].norm()))
        .ok_or(ModalError::NoCircle)?;
    let reference = points[largest].0;
    let sweep = |i: usize, j: usize| -> Option<f64> {
        let turned = wrapped(angles[j] - angles[i]).abs();
        let between = (points[j].0 - points[i].0).abs() / reference;
        (turned > 1e-9 && between > 0.0).then(|| between / (turned / 2.0).tan().abs().max(1e-9))
    };
    let neighbours = [largest.checked_sub(1), Some(largest + 1).filter(|n| *n < points.len())];
    let width = neighbours
        .into_iter()
        .flatten()
        .filter_map(|n| sweep(largest, n))
        .fold(f64::INFINITY, f64::min)
        .clamp(1e-6, 1.0);
    let start = |detune: f64, widen: f64| [1.0 + detune * width, width * widen, 0.0];

    // u = (x − p/x)/g with viscous and (x² − p)/g with hysteretic damping, x = ω/ω_reference.
    let sweep_of = |x: f64, [p, g, _]: &[f64; 3]| -> (f64, [f64; 2]) {
        match model {
            DampingModel::Viscous => ((x - p / x) / g, [-1.0 / (x * g), -(x - p / x) / g.powi(2)]),
            DampingModel::Hysteretic => ((x * x - p) / g, [-1.0 / g, -(x * x - p) / g.powi(2)]),
        }
    };
    let towards = angles[largest];
    let rows = |parameters: &[f64; 3]| -> Vec<(f64, [f64; 3])> {
        let row = |(point, angle): (&ResponsePoint, &f64)| {
            let (u, [du_dp, du_dg]) = sweep_of(point.0 / reference, parameters);
            // Clockwise from the direction of the diameter.
            let model = towards + parameters[2] - 2.0 * u.atan();
            let slope = -2.0 / (1.0 + u * u);
            (wrapped(model - angle), [slope * du_dp, slope * du_dg, 1.0])
        };
        points.iter().zip(&angles).map(row).collect()
    };
    // Another start is tried only where the first leaves more than some degrees.
    let enough = |minimum: &Minimum<3>| minimum.squares < 2e-3 * points.len() as f64;
    let mut best: Option<Minimum<3>> = None;
    for start in [start(0.0, 1.0), start(0.0, 2.0), start(0.3, 1.0), start(-0.3, 1.0), start(0.0, 0.4)] {
        let Ok(found) = minimise(start, PI, rows) else { continue };
        let sound = found.parameters[0] > 0.0 && found.parameters[1] > 0.0;
        if sound && best.as_ref().is_none_or(|best| found.squares < best.squares) {
            best = Some(found);
        }
        if best.as_ref().is_some_and(enough) {
            break;
        }
    }
    let best = best.ok_or(ModalError::NotAMode)?;
    let [p, g, turn] = best.parameters;
    let natural = p.sqrt();
    let damping = match model {
        DampingModel::Viscous => g / (2.0 * natural),
        DampingModel::Hysteretic => g / p,
    };
    // The quarters of the circle: u = ∓1.
    let half_power = match model {
        DampingModel::Viscous => {
            let root = (g * g / 4.0 + p).sqrt();
            [p / (root + g / 2.0), root + g / 2.0]
        }
        DampingModel::Hysteretic => [(p - g).max(0.0).sqrt(), (p + g).sqrt()],
    };
    let at = |angle: f64| circle.centre + Complex::from_polar(circle.radius, towards + turn + angle);
    let diameter = 2.0 * circle.radius;
    // Hysteretic: 2R = A/(ηω_n²); viscous: 2R = A/(2ζω_n).
    let modal_constant = match model {
        DampingModel::Viscous => diameter * g * reference,
        DampingModel::Hysteretic => diameter * g * reference.powi(2),
    };
    let fit = CircleFit {
        circle,
        natural_frequency: natural * reference,
        damping,
        modal_constant,
        half_power: half_power.map(|x| x * reference),
        marks: [at(0.0), at(PI / 2.0), at(-PI / 2.0)],
        damping_of_pairs: of_pairs(points, &angles, natural * reference, towards + turn, model),
        slopes: best.slopes,
    };
    if [fit.natural_frequency, fit.damping, fit.modal_constant].iter().all(|x| x.is_finite()) {
        Ok(fit)
    } else {
        Err(ModalError::NotAMode)
    }
}

/// The damping of each pair of points, one below and one above the natural frequency, as the largest and smallest:
/// `η = (ω_a² − ω_b²)/(ω_n²(t_a + t_b))` and `ζ = (ω_a² − ω_b²)/(2ω_n(ω_a t_a + ω_b t_b))` with
/// `t = tan(θ/2)`. Ewins, 2nd ed., §4.3.3.
fn of_pairs(
    points: &[ResponsePoint],
    angles: &[f64],
    natural: f64,
    direction: f64,
    model: DampingModel,
) -> Option<[f64; 2]> {
    let half_tangents: Vec<(f64, f64)> = points
        .iter()
        .zip(angles)
        .map(|(point, angle)| (point.0, (wrapped(angle - direction) / 2.0).tan().abs()))
        // Near the far side of the circle the angle says nothing.
        .filter(|(_, tangent)| *tangent > 1e-3 && *tangent < 4.0)
        .collect();
    let below: Vec<_> = half_tangents.iter().filter(|(w, _)| *w < natural).collect();
    let above: Vec<_> = half_tangents.iter().filter(|(w, _)| *w > natural).collect();
    // A few on each side are enough, and keep long tables quick.
    let near = 8;
    let mut range: Option<[f64; 2]> = None;
    for (wb, tb) in below.iter().rev().take(near) {
        for (wa, ta) in above.iter().take(near) {
            let of = match model {
                DampingModel::Viscous => (wa * wa - wb * wb) / (2.0 * natural * (wa * ta + wb * tb)),
                DampingModel::Hysteretic => (wa * wa - wb * wb) / (natural * natural * (ta + tb)),
            };
            range = Some(range.map_or([of, of], |[least, most]| [least.min(of), most.max(of)]));
        }
    }
    range
}

/// An angle within half a turn of zero.
fn wrapped(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round()
}
