//! Transmission functions of cams and intermittent mechanisms: one measure over another, with two derivatives.

use std::f64::consts::{PI, TAU};

use dalembert_numerics::linalg::{Elimination, SparseMatrix};

/// The function by which one measure follows another.
#[derive(Debug, Clone, PartialEq)]
pub enum TransmissionFunction {
    /// A cam: a table with splines between its points.
    Profile(Profile),
    /// A Geneva wheel: its angle over that of the driver.
    Geneva(GenevaWheel),
}

/// A function with two continuous derivatives, as a polynomial on each interval.
#[derive(Debug, Clone, PartialEq)]
pub struct Profile {
    /// The beginnings of the intervals, ascending, and the end of the last one.
    knots: Vec<f64>,
    /// The coefficients of each interval, of ascending powers of the distance from its beginning.
    pieces: Vec<[f64; 4]>,
    /// The period after which it repeats.
    period: Option<f64>,
}

/// An external Geneva wheel with radial slots, which the pin of a driver enters and leaves along the slot. The radius of the
/// pin's circle is the distance of the centres times `sin(π/n)`. R. L. Norton, *Design of Machinery*, 5th ed. (2012), §2.10;
/// F. Y. Chen, *Mechanics and Design of Cam Mechanisms* (1982).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GenevaWheel {
    slots: f64,
    /// Angle of the driver at which its pin lies on the line of centres, between them, rad.
    middle: f64,
}

impl TransmissionFunction {
    /// Value, first and second derivative.
    pub fn at(&self, x: f64) -> [f64; 3] {
        match self {
            TransmissionFunction::Profile(profile) => profile.at(x),
            TransmissionFunction::Geneva(wheel) => wheel.at(x),
        }
    }
}

impl GenevaWheel {
    /// A wheel with so many slots; `middle` is the angle of the driver, rad, at which its pin lies on the line of centres.
    ///
    /// None with fewer than three slots.
    pub fn new(slots: u32, middle: f64) -> Option<Self> {
        (slots >= 3 && middle.is_finite()).then(|| Self { slots: f64::from(slots), middle })
    }

    /// Angle of the driver on either side of the line of centres within which the pin is in a slot, `π/2 − π/n`, rad.
    pub fn engagement(&self) -> f64 {
        PI / 2.0 - PI / self.slots
    }

    /// Angle of the wheel, rad, over the angle of the driver, with its two derivatives. The wheel turns against the
    /// driver, `β = atan2(λ sin α, 1 − λ cos α)` with `λ = sin(π/n)`, and rests between two engagements.
    pub fn at(&self, driver: f64) -> [f64; 3] {
        let turns = ((driver - self.middle) / TAU).round();
        let angle = driver - self.middle - TAU * turns;
        let before = -TAU / self.slots * turns;
        if angle.abs() >= self.engagement() {
            return [before - (PI / self.slots).copysign(angle), 0.0, 0.0];
        }
        let ratio = (PI / self.slots).sin();
        let (sin, cos) = angle.sin_cos();
        let square = 1.0 - 2.0 * ratio * cos + ratio * ratio;
        let rate = ratio * (cos - ratio) / square;
        let second = -ratio * (1.0 - ratio * ratio) * sin / (square * square);
        [before - dalembert_numerics::elementary::atan2(ratio * sin, 1.0 - ratio * cos), -rate, -second]
    }
}

impl Profile {
    /// The natural cubic spline through points with ascending abscissae; outside of them it goes on as a line.
    /// With a period it closes on itself, and the points must lie within one period.
    ///
    /// None unless there are at least two points (three with a period), finite and ascending.
    pub fn through(points: &[[f64; 2]], period: Option<f64>) -> Option<Self> {
        let mut points = points.to_vec();
        if let Some(period) = period {
            let [x, y] = *points.first()?;
            if points.len() < 3 || points.last()?[0] >= x + period {
                return None;
            }
            points.push([x + period, y]);
        }
        let ascending = points.windows(2).all(|pair| pair[0][0] < pair[1][0]);
        if points.len() < 2 || !ascending || points.iter().flatten().any(|x| !x.is_finite()) {
            return None;
        }
        let second = second_derivatives(&points, period.is_some())?;
        let piece = |k: usize| {
            let ([x0, y0], [x1, y1]) = (points[k], points[k + 1]);
            let (h, s0, s1) = (x1 - x0, second[k], second[k + 1]);
            [y0, (y1 - y0) / h - h * (2.0 * s0 + s1) / 6.0, s0 / 2.0, (s1 - s0) / (6.0 * h)]
        };
        let pieces: Vec<[f64; 4]> = (0..points.len() - 1).map(piece).collect();
        let finite = pieces.iter().flatten().all(|x| x.is_finite());
        let knots = points.iter().map(|point| point[0]).collect();
        finite.then_some(Self { knots, pieces, period })
    }

    /// Value, first and second derivative.
    pub fn at(&self, x: f64) -> [f64; 3] {
        let first = self.knots[0];
        let x = self.period.map_or(x, |period| first + (x - first).rem_euclid(period));
        let last = self.knots[self.knots.len() - 1];
        let held = x.clamp(first, last);
        let piece = self.knots[1..self.knots.len() - 1].partition_point(|&knot| knot <= held);
        let [a, b, c, d] = self.pieces[piece];
        let h = held - self.knots[piece];
        let slope = b + h * (2.0 * c + h * 3.0 * d);
        let beyond = x - held;
        let bend = if beyond == 0.0 { 2.0 * c + 6.0 * d * h } else { 0.0 };
        [a + h * (b + h * (c + h * d)) + slope * beyond, slope, bend]
    }

    /// The pitch curve of a cam for a roller: the distance of the roller's centre from the centre of the cam over its polar
    /// angle. `outline` is the distance of the cam's contour over the polar angle, m, with the period 2π; `roller` the
    /// radius of the roller, m. R. L. Norton, *Design of Machinery*, 5th ed. (2012), §8.6.
    ///
    /// None where the roller does not fit into a hollow of the contour.
    pub fn pitch_curve(outline: &Self, roller: f64) -> Option<Self> {
        let at = |angle: f64| {
            let [radius, rate, _] = outline.at(angle);
            let (sin, cos) = angle.sin_cos();
            // The outward normal of the contour.
            let normal = [radius * cos + rate * sin, radius * sin - rate * cos];
            let length = normal[0].hypot(normal[1]);
            let [x, y] =
                [radius * cos + roller * normal[0] / length, radius * sin + roller * normal[1] / length];
            [x, y]
        };
        let polar = |angle: f64| {
            let [x, y] = at(angle);
            let turned = dalembert_numerics::elementary::atan2(y, x) - angle;
            [angle + turned - TAU * (turned / TAU).round(), x.hypot(y)]
        };
        Self::through(&Self::around(outline, polar)?, Some(TAU))
    }

    /// The support function of a convex cam: the distance of a flat face from the centre of the cam over the direction of the
    /// face's normal. `outline` as for [`pitch_curve`](Profile::pitch_curve).
    ///
    /// None where the contour is hollow: a flat face does not touch it there.
    pub fn support_function(outline: &Self) -> Option<Self> {
        let tangent = |angle: f64| {
            let [radius, rate, _] = outline.at(angle);
            let turned = -dalembert_numerics::elementary::atan2(rate, radius);
            [angle + turned, radius * radius / radius.hypot(rate)]
        };
        Self::through(&Self::around(outline, tangent)?, Some(TAU))
    }

    /// The same function of an argument that is smaller by so much: `g(x) = f(x + by)`.
    #[must_use]
    pub fn shifted(mut self, by: f64) -> Self {
        self.knots.iter_mut().for_each(|knot| *knot -= by);
        self
    }

    /// Points of a closed curve derived from another, at equal angles and at the points that define it; none unless they
    /// ascend.
    fn around(outline: &Self, point: impl Fn(f64) -> [f64; 2]) -> Option<Vec<[f64; 2]>> {
        const PARTS: usize = 16;
        let angles = outline.knots.windows(2).flat_map(|ends| {
            let step = (ends[1] - ends[0]) / PARTS as f64;
            (0..PARTS).map(move |n| ends[0] + step * n as f64)
        });
        let points: Vec<[f64; 2]> = angles.map(point).collect();
        let first = points.first()?[0];
        let ascends = points.windows(2).all(|pair| pair[0][0] < pair[1][0]);
        (ascends && points.last()?[0] < first + TAU).then_some(points)
    }

    /// The integral from the first point.
    pub fn integral(&self, x: f64) -> f64 {
        let whole = |[a, b, c, d]: [f64; 4], h: f64| h * (a + h * (b / 2.0 + h * (c / 3.0 + h * d / 4.0)));
        let (first, last) = (self.knots[0], self.knots[self.knots.len() - 1]);
        let up_to = |x: f64| -> f64 {
            let held = x.clamp(first, last);
            let inside: f64 = self
                .knots
                .windows(2)
                .zip(&self.pieces)
                .map(|(ends, &piece)| whole(piece, held.clamp(ends[0], ends[1]) - ends[0]))
                .sum();
            let [value, slope, _] = self.at(held);
            inside + (x - held) * (value + slope * (x - held) / 2.0)
        };
        match self.period {
            Some(period) => {
                let turns = ((x - first) / period).floor();
                turns * up_to(last) + up_to(x - turns * period)
            }
            None => up_to(x),
        }
    }
}

/// The second derivatives of the cubic spline at its points (de Boor, *A Practical Guide to Splines*, ch. IV).
fn second_derivatives(points: &[[f64; 2]], closed: bool) -> Option<Vec<f64>> {
    let n = points.len();
    let width = |k: usize| points[k + 1][0] - points[k][0];
    let slope = |k: usize| (points[k + 1][1] - points[k][1]) / width(k);
    let mut b = vec![0.0; n];
    let inner = (1..n - 1).map(|k| {
        b[k] = 6.0 * (slope(k) - slope(k - 1));
        vec![(k - 1, width(k - 1)), (k, 2.0 * (width(k - 1) + width(k))), (k + 1, width(k))]
    });
    let inner: Vec<_> = inner.collect();
    let [first, end] = if closed {
        let last = n - 2;
        b[0] = 6.0 * (slope(0) - slope(last));
        [
            vec![(0, 2.0 * (width(last) + width(0))), (1, width(0)), (last, width(last))],
            vec![(0, 1.0), (n - 1, -1.0)],
        ]
    } else {
        [vec![(0, 1.0)], vec![(n - 1, 1.0)]]
    };
    let rows = [first].into_iter().chain(inner).chain([end]).collect();
    Elimination::of_sparse(&SparseMatrix::new(n, rows)).ok()?.solve(&b).ok()
}
