//! Systems of units: over the registry, found from inputs, set on the command line, in files and in the workbench.

use dalembert_core::registry;
use dalembert_plugins as _;
use dalembert_testkit::unit_systems;

#[test]
fn every_solution_is_coherent_in_every_system() {
    let (units, substitutions) = unit_systems::every_solution_is_coherent_in_every_system(registry());
    assert!(units > 15_000 && substitutions > 10_000, "{units} units, {substitutions} substitutions");
}
