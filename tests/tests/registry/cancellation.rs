//! Formulas beside arithmetic of 77 digits. `cargo xtask trust formulas` compares them at many random points, and near singular ones.

use dalembert_plugins as _;
use dalembert_testkit::cancellation::compared;
use dalembert_tests::chosen;

#[test]
fn formulas_keep_the_digits_that_their_condition_allows() {
    let compared = compared(&chosen(), 1, &[], 0);
    let faults: Vec<String> = compared
        .faults
        .iter()
        .map(|(name, (count, first))| format!("{name}: {count} times; {first}"))
        .collect();
    println!(
        "{} solutions, {} numbers, {} explained",
        compared.solutions, compared.numbers, compared.explained
    );
    assert!(compared.numbers > 10 * compared.solutions, "{} numbers", compared.numbers);
    assert!(faults.is_empty(), "{} formulas\n{}", faults.len(), faults.join("\n"));
}
