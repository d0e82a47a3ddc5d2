//! Compound pendulums: about one point, and about two.

use std::f64::consts::{PI, TAU};

use dalembert_core::{Axis, Drawing, Plot, Refusal, Series, Sketch, Text, Worksheet};
use dalembert_mechanics::{Real, vibration::swing};

use super::CentreSide;
use crate::sources::RAO;

/// About one point: the moment of inertia about the centre of mass, and the radius of gyration.
pub(super) fn one_point<W: Worksheet>(
    mass: W::Num,
    distance: W::Num,
    period: W::Num,
    gravity: W::Num,
    sheet: W,
) -> Result<(W::Num, W::Num), Refusal> {
    let reduced = sheet.step(
        "λ",
        "mm",
        swing::reduced_length(gravity, period),
        ("Length of the simple pendulum of equal period: T² = 4π² λ/g", RAO.at("§2.3")),
    );
    sheet.answer(
        "reduced_length",
        "Length of the equivalent simple pendulum, to the centre of percussion",
        reduced,
    );
    if reduced.value() <= distance.value() {
        return Err(Refusal::because(
            "the period is that of a simple pendulum shorter than the distance to the centre of mass, which is impossible: write a longer period or a smaller distance",
        ));
    }
    let simple = || mass * reduced.powi(2);
    sheet.common_error("J_O", "the body taken as a simple pendulum of the equivalent length", simple);
    let point = || mass * distance.powi(2);
    sheet.common_error("J_O", "the body taken as a point mass at its centre", point);
    let about = sheet.step(
        "J_O",
        "kg*m^2",
        mass * distance * reduced,
        ("Moment of inertia about the point of suspension, from λ = J_O/(m s)", RAO.at("§2.3")),
    );
    sheet.answer("inertia_about_pivot", "Moment of inertia about the point of suspension", about);
    let inertia = sheet.step(
        "J",
        "kg*m^2",
        about - mass * distance.powi(2),
        "Parallel-axis theorem: the moment of inertia about the centre of mass is smaller by m s²",
    );
    let gyration = (inertia / mass).sqrt();
    sheet.verify(|| {
        let swings = ((gyration.powi(2) + distance.powi(2)) / (gravity * distance)).sqrt() * TAU;
        sheet.check("the radius of gyration reproduces the period", swings, period);
    });
    if inertia.value() < 0.02 * about.value() {
        sheet.warn(|| {
            Text::new("the moment of inertia is a small difference of large values: errors of distance and period are amplified; suspend the body closer to its centre of mass")
        });
    }
    Ok((inertia, gyration))
}

/// Centre of mass and inertia from the periods about two points of suspension.
pub(super) struct Centre<N> {
    pub(super) inertia: N,
    pub(super) gyration: N,
    /// Of the centre of mass from the two points.
    pub(super) distances: [N; 2],
}

/// About two points: where the centre of mass is, and the moment of inertia about it.
pub(super) fn two_points<W: Worksheet>(
    mass: W::Num,
    distance: W::Num,
    periods: [W::Num; 2],
    side: &CentreSide,
    gravity: W::Num,
    sheet: W,
) -> Result<Centre<W::Num>, Refusal> {
    let reduced = |row: usize| {
        sheet.step(
            ("λ", row),
            "mm",
            swing::reduced_length(gravity, periods[row - 1]),
            ("Length of the simple pendulum of equal period", RAO.at("§2.3")),
        )
    };
    let (first, second) = (reduced(1), reduced(2));
    let length = distance.value();
    let rest = match side {
        CentreSide::Between => 2.0 * length - first.value() - second.value(),
        CentreSide::Beyond => 2.0 * length - first.value() + second.value(),
    };
    if rest.abs() <= 1e-9 * length {
        return Err(Refusal::because(
            "the two points are conjugate like those of a reversible pendulum: every centre of mass between them fits, choose other points",
        ));
    }
    let [near, far] = match side {
        CentreSide::Between => {
            let shared = || distance * first / (first + second);
            let what = "the distance divided in proportion to the equivalent lengths";
            sheet.common_error(("h", 1), what, shared);
            let near = sheet.step(
                ("h", 1),
                "mm",
                swing::centre_between(distance, first, second),
                "From the first point to the centre of mass: h₁² − λ₁ h₁ = h₂² − λ₂ h₂ = −κ², with h₁ + h₂ = L",
            );
            [near, sheet.step(("h", 2), "mm", distance - near, "From the second point to the centre of mass")]
        }
        CentreSide::Beyond => {
            let far = sheet.step(
                ("h", 1),
                "mm",
                swing::centre_beyond(distance, first, second),
                "From the first point to the centre of mass beyond the second point: h₁² − λ₁ h₁ = h₂² − λ₂ h₂ = −κ², with h₁ − h₂ = L",
            );
            [far, sheet.step(("h", 2), "mm", far - distance, "From the second point to the centre of mass")]
        }
    };
    let inside = near.value() > 0.0 && far.value() > 0.0;
    if !inside || first.value() <= near.value() {
        return Err(Refusal::because(
            "no centre of mass on this side fits the two periods: check whether it is between the points or beyond the second one",
        ));
    }
    sheet.answer("centre", "Centre of mass from the first point", near);
    let about = || mass * near * first;
    sheet.common_error("J", "the moment of inertia about the first point taken", about);
    let simple = || mass * near.powi(2);
    sheet.common_error("J", "the body taken as a point mass at its centre", simple);
    let inertia = sheet.step(
        "J",
        "kg*m^2",
        mass * near * (first - near),
        "Moment of inertia about the centre of mass: m κ² = m h₁ (λ₁ − h₁)",
    );
    sheet.check_zero(
        "the oscillation about the second point gives the same moment of inertia",
        inertia - mass * far * (second - far),
        (mass * far * second).value().abs() + (mass * near * first).value().abs(),
    );
    let gyration = (inertia / mass).sqrt();
    sheet.verify(|| {
        let swings = ((gyration.powi(2) + far.powi(2)) / (gravity * far)).sqrt() * TAU;
        sheet.check_zero(
            "the radius of gyration reproduces the second period",
            swings - periods[1],
            periods[1].value() * (1.0 + length / rest.abs()),
        );
    });
    if rest.abs() < 0.05 * length {
        sheet.warn(|| {
            Text::new("the two periods are almost those of a reversible pendulum: small errors in them shift the centre of mass greatly")
        });
    }
    Ok(Centre { inertia, gyration, distances: [near, far] })
}

/// The period against the distance of the point of suspension from the centre of mass.
pub(super) fn period_over_distance(gyration: f64, gravity: f64, marks: &[(&'static str, f64, f64)]) -> Plot {
    let farthest = marks.iter().fold(0.0, |farthest: f64, mark| farthest.max(mark.1));
    let last = 3.0 * gyration.max(farthest);
    let at = |n: u32| {
        let distance = last * f64::from(n) / 300.0;
        (distance, 2.0 * PI * ((gyration.powi(2) + distance.powi(2)) / (gravity * distance)).sqrt())
    };
    let shortest = 2.0 * PI * (2.0 * gyration / gravity).sqrt();
    let points = (1..=300).map(at).filter(|(_, period)| *period < 4.0 * shortest).collect();
    let plot = Plot::new(
        "Period against the distance of the point of suspension from the centre of mass",
        Axis::linear("distance", "mm"),
        Axis::linear("period", "s"),
        vec![Series::line("T", points)],
    );
    marks
        .iter()
        .fold(plot, |plot, (label, distance, period)| plot.mark(*label, (*distance, *period)))
        .mark("minimum period", (gyration, shortest))
}

/// The body with its points of suspension, at heights over G in parts of the first, and the letters of its mass and of a distance.
pub(super) fn pendulum(
    points: &[(&'static str, f64)],
    mass: &'static str,
    (letter, from, to): (&'static str, f64, f64),
) -> Drawing {
    let mut sketch = Sketch::new("The body and its points of suspension");
    let at = |height: f64| (0.0, height.clamp(-1.1, 1.1));
    sketch
        .body("", [(-0.25, 1.3), (0.25, 1.3), (0.45, -1.2), (-0.45, -1.2)])
        .mass_centre("G", (0.0, 0.0))
        .label(mass, (0.42, -0.9))
        .dimension(letter, at(from), at(to), if from > to { 5.5 } else { -5.5 });
    for (name, height) in points {
        sketch.hung_pin(Text::new("{x}").with("x", name), at(*height));
    }
    sketch.finish()
}
