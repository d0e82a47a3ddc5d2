//! Weight and mass confused: the numbers that people take for the acceleration of gravity.

use dalembert_units::Unit;

/// Units that are mixed up with others in countries that use them.
const CUSTOMARY: [&str; 7] = ["in", "ft", "lb", "slug", "oz", "psi", "mil"];
/// Gravity in m/s², each with its prior: a factor of ten is rather a decimal point.
const WEIGHTS: [(f64, f64); 2] = [(4.5, 9.81), (0.4, 10.0)];
/// Gravity in ft/s² and in/s².
const CUSTOMARY_WEIGHTS: [(f64, f64); 4] = [(3.0, 32.174), (1.5, 32.2), (3.0, 386.09), (1.5, 386.4)];

/// True for the name of a unit of the customary system.
pub(super) fn is_customary(unit: &str) -> bool {
    CUSTOMARY.iter().any(|name| unit.contains(name) && !unit.contains("min"))
}

/// Numbers that people take for the acceleration of gravity beside a mass in this unit, each with its prior.
pub(super) fn weights(unit: &Unit) -> &'static [(f64, f64)] {
    if is_customary(&unit.ascii()) { &CUSTOMARY_WEIGHTS } else { &WEIGHTS }
}
