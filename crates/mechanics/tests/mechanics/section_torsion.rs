//! Tests of `section::torsion`.

use dalembert_mechanics::section::torsion;

#[test]
fn by_the_table_of_timoshenko_and_goodier() {
    for (ratio, coefficient) in [(1.0, 0.1406), (1.5, 0.196), (2.0, 0.229), (3.0, 0.263), (10.0, 0.312)] {
        assert!((torsion::rectangle(ratio, 1.0) / ratio - coefficient).abs() < 6e-4);
        assert!((torsion::rectangle(1.0, ratio) / ratio - coefficient).abs() < 6e-4);
    }
    assert!((torsion::rectangle(1.0, 1.0) - 0.140_577_014_955_15).abs() < 1e-12);
}
