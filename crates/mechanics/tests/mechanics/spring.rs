use dalembert_mechanics::{section, spring};

use crate::close::{ROUNDING, close};

#[test]
fn bar_and_shaft_by_their_strain_energy() {
    // A pull F stores F²L/(2EA) = F²/(2k); a torque T stores T²L/(2GJ).
    let (pull, torque) = (1300.0, 17.0);
    let k = spring::axial(70e9, 3e-4, 1.7);
    close(pull * pull / (2.0 * k), pull * pull * 1.7 / (2.0 * 70e9 * 3e-4), ROUNDING);
    let polar = section::round_polar_moment(0.02);
    let k = spring::torsional(80e9, polar, 0.6);
    close(torque / k, torque * 0.6 / (80e9 * polar), ROUNDING);
}

#[test]
fn helical_spring_by_the_twist_of_its_wire() {
    // Torque F D/2 over the length π D n, deflection = twist × D/2.
    let (shear, d, coil, n) = (79.3e9, 0.002, 0.018, 11.0);
    let wire = spring::torsional(shear, section::round_polar_moment(d), std::f64::consts::PI * coil * n);
    close(spring::helical(shear, d, coil, n), wire / (coil / 2.0).powi(2), ROUNDING);
}

#[test]
fn equal_springs_side_by_side_and_end_to_end() {
    close(spring::parallel([5.0, 7.0, 11.0]), 23.0, ROUNDING);
    close(spring::series([5.0; 4]), 1.25, ROUNDING);
    close(spring::series([6.0, 3.0]), 2.0, ROUNDING);
    // Cut into n pieces, a spring is n times as stiff.
    close(spring::series(vec![9.0 * 400.0; 9]), 400.0, ROUNDING);
    close(spring::series([1e3, 1e12]), 1e3, 1e-8);
}
