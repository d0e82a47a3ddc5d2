//! Transmission functions of cams and Geneva wheels, and the polar angle that a roller on a contour is measured by.

use std::f64::consts::{PI, TAU};

use dalembert_mechanics::planar::{BodyPoint, GenevaWheel, Pose, Profile, RelativeCoordinate};

/// First and second central differences of a function, of the fourth order.
fn differences(f: impl Fn(f64) -> f64, x: f64, h: f64) -> [f64; 2] {
    let [a, b, c, d, e] = [-2.0, -1.0, 0.0, 1.0, 2.0].map(|n| f(x + n * h));
    [(a - 8.0 * b + 8.0 * d - e) / (12.0 * h), (-a + 16.0 * b - 30.0 * c + 16.0 * d - e) / (12.0 * h * h)]
}

#[test]
fn a_geneva_wheel_turns_by_one_pitch_a_revolution_and_rests_between() {
    for slots in [3, 4, 5, 6, 8, 12] {
        let wheel = GenevaWheel::new(slots, 0.3).expect("a wheel with so many slots exists");
        let pitch = TAU / f64::from(slots);
        let dwell = |x: f64| wheel.at(0.3 + x);
        assert!((wheel.engagement() - (PI / 2.0 - PI / f64::from(slots))).abs() < 1e-15);
        assert!((dwell(PI)[0] - dwell(-PI)[0] + pitch).abs() < 1e-12);
        assert_eq!(dwell(wheel.engagement() + 0.01)[1..], [0.0, 0.0]);
        // Pin and slot enter each other without a jump of the velocity.
        let inside = dwell(wheel.engagement() - 1e-9);
        assert!((inside[0] + pitch / 2.0).abs() < 1e-8 && inside[1].abs() < 1e-8, "{slots}: {inside:?}");
        for n in -5..=5 {
            let angle = 0.3 + 0.9 * wheel.engagement() * f64::from(n) / 5.0 + TAU;
            let [first, second] = differences(|x| wheel.at(x)[0], angle, 1e-3);
            let [_, rate, change] = wheel.at(angle);
            assert!((first - rate).abs() < 1e-6 * (1.0 + rate.abs()), "{slots}: {first} {rate}");
            assert!((second - change).abs() < 1e-3 * (1.0 + change.abs()), "{slots}: {second} {change}");
        }
    }
    assert_eq!(GenevaWheel::new(2, 0.0), None);
}

/// An eccentric disc as a contour in polar coordinates about its shaft.
fn eccentric(radius: f64, eccentricity: f64, points: usize) -> Profile {
    let point = |n: usize| {
        let angle = TAU * n as f64 / points as f64;
        let across = eccentricity * angle.sin();
        [angle, eccentricity * angle.cos() + (radius * radius - across * across).sqrt()]
    };
    Profile::through(&(0..points).map(point).collect::<Vec<_>>(), Some(TAU)).expect("a closed contour")
}

#[test]
fn the_pitch_curve_of_a_disc_is_a_larger_disc_and_its_support_function_a_sine() {
    let (radius, eccentricity) = (30.0, 12.0);
    let contour = eccentric(radius, eccentricity, 180);
    let pitch = Profile::pitch_curve(&contour, 10.0).expect("the roller fits");
    let larger = eccentric(radius + 10.0, eccentricity, 180);
    let support = Profile::support_function(&contour).expect("the disc is convex");
    for n in 0..60 {
        let angle = TAU * f64::from(n) / 60.0 + 0.01;
        for order in 0..2 {
            let off = pitch.at(angle)[order] - larger.at(angle)[order];
            assert!(off.abs() < 1e-4, "pitch curve, derivative {order} at {angle}: {off}");
        }
        let off = support.at(angle)[0] - (radius + eccentricity * angle.cos());
        assert!(off.abs() < 1e-6, "support function at {angle}: {off}");
    }
}

#[test]
fn a_hollow_contour_has_no_flat_face_and_no_roller_larger_than_its_hollow() {
    let point = |n: usize| {
        let angle = TAU * n as f64 / 72.0;
        [angle, 40.0 + 8.0 * (3.0 * angle).cos()]
    };
    let lobes = Profile::through(&(0..72).map(point).collect::<Vec<_>>(), Some(TAU)).expect("closed");
    assert!(Profile::support_function(&lobes).is_none());
    assert!(Profile::pitch_curve(&lobes, 5.0).is_some());
    assert!(Profile::pitch_curve(&lobes, 60.0).is_none());
}

#[test]
fn the_polar_angle_of_a_point_changes_as_its_differences_do() {
    let measure = RelativeCoordinate::Bearing {
        from: BodyPoint::body(0, [0.02, -0.01]),
        to: BodyPoint::body(1, [0.05, 0.03]),
    };
    let start = [[0.1, -0.2, 0.4], [0.3, 0.25, -0.7]];
    let speed = [[0.5, -0.3, 2.0], [-0.7, 0.4, -1.5]];
    let poses =
        |time: f64| [0, 1].map(|body| Pose::new([0, 1, 2].map(|k| start[body][k] + time * speed[body][k])));
    let value = |time: f64| {
        let [from, to] = poses(time);
        measure.gradient([&from, &to]).value
    };
    let [from, to] = poses(0.0);
    let gradient = measure.gradient([&from, &to]);
    let rate: f64 = (0..3).map(|k| gradient.from[k] * speed[0][k] + gradient.to[k] * speed[1][k]).sum();
    let [first, second] = differences(value, 0.0, 1e-3);
    assert!((rate - first).abs() < 1e-8 * first.abs(), "{rate} {first}");
    // Nothing accelerates: the second derivative is the bias.
    let bias = measure.bias([&from, &to], speed);
    assert!((bias - second).abs() < 1e-6 * second.abs(), "{bias} {second}");
}
