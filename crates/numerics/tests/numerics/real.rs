use dalembert_numerics::{Real, Vector};
use nalgebra::Vector3;

use crate::close::{ROUNDING, close};

/// Every method by its name in the trait, not by the inherent one of the same name.
fn identities<S: Real>(x: S) -> [f64; 8] {
    [
        x.root(2).powi(2).value(),
        x.root(3).powi(3).value(),
        x.root(4).powi(4).value(),
        x.root(5).powi(5).value(),
        x.ln().exp().value(),
        (-x).abs().value(),
        (x.sin() / x.cos() / x.tan() * x).value(),
        (S::sum([x, x, x]) / 3.0).value(),
    ]
}

#[test]
fn plain_numbers_are_real() {
    for x in [0.3, 1.0, 7.25] {
        for ours in identities(x) {
            close(ours, x, ROUNDING);
        }
    }
    let angle = Real::atan2(Real::sin(2.5), Real::cos(2.5));
    close(angle, 2.5, ROUNDING);
    close(Real::asin(0.3) + Real::acos(0.3), std::f64::consts::FRAC_PI_2, ROUNDING);
    assert_eq!(<f64 as Real>::sum([]), 0.0);
}

#[test]
fn plain_vectors_are_vectors() {
    let (a, b) = (Vector3::new(1.0, 2.0, 3.0), Vector3::new(-2.0, 0.5, 4.0));
    assert_eq!(Vector::dot(a, b), 11.0);
    assert_eq!(Vector::cross(a, b), Vector3::new(6.5, -10.0, 4.5));
    close(Vector::magnitude(a), 14f64.sqrt(), ROUNDING);
    assert_eq!(<Vector3<f64> as Vector>::sum([a, b, -b]), a);
    let [x, y, z] = a.components();
    assert_eq!(<Vector3<f64> as Vector>::from_components(x, y, z).value(), a);
}
