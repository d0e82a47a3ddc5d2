//! Tests of `section::shear`.

use dalembert_mechanics::section::shear;

#[test]
fn a_tube_is_between_the_solid_and_the_thin_one() {
    for poisson in [0.0, 0.3, 0.5] {
        assert!((shear::tube(poisson, 0.0) - shear::round(poisson)).abs() < 1e-15);
        assert!((shear::tube(poisson, 1.0) - shear::thin_round_tube(poisson)).abs() < 1e-15);
    }
}
