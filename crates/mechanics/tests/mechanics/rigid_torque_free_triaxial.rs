//! Tests of `rigid::torque_free::triaxial`.

use dalembert_mechanics::rigid::torque_free::{FreeBody, FreeBodyError};
use nalgebra::Vector3;

#[test]
fn a_body_must_be_one() {
    let new = |a, b, c| FreeBody::new(Vector3::new(a, b, c), Vector3::new(1.0, 2.0, 3.0)).map(|_| ());
    assert_eq!(new(1.0, 2.0, 3.5), Err(FreeBodyError::Triangle { axis: 2 }));
    assert_eq!(new(1.0, -2.0, 3.0), Err(FreeBodyError::Moment { axis: 1 }));
    assert_eq!(new(1.0, 2.0, 3.0), Ok(()));
}
