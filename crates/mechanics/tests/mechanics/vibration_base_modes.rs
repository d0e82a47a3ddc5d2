//! Tests of `vibration::base_modes`.

use dalembert_mechanics::vibration::base_modes::*;

/// Fixed and free chain of equal links: `ω = 2√(k/m) sin((2j − 1)π/(2(2n + 1)))`.
#[test]
fn equal_links_have_their_closed_form() {
    let n = 7;
    let (masses, springs) = (vec![3.0; n], vec![12.0; n]);
    let modes = base_modes(&masses, &springs).unwrap();
    for (j, mode) in modes.iter().enumerate() {
        let angle = (2 * j + 1) as f64 * std::f64::consts::PI / (2 * (2 * n + 1)) as f64;
        assert!((mode.natural - 4.0 * angle.sin()).abs() < 1e-13);
        assert!(holzer_residual(&masses, &springs, mode.natural).abs() < 1e-12);
    }
    let mass: f64 = modes.iter().map(|mode| mode.participation.powi(2)).sum();
    assert!((mass - 21.0).abs() < 1e-12);
    for i in 0..n {
        let one: f64 = modes.iter().map(|mode| mode.participation * mode.shape[i]).sum();
        assert!((one - 1.0).abs() < 1e-12);
    }
}

#[test]
fn a_chain_without_springs_is_refused() {
    assert!(base_modes(&[1.0], &[]).is_err());
    assert!(base_modes(&[1.0], &[0.0]).is_err());
}
