//! Firing orders as they are typed.

use dalembert_core::{Draft, Solution, Stop, cases, find};

/// Two cylinders that fire in this order.
fn fired(order: &str) -> Result<Solution, String> {
    let entry = find("vibration/engine-orders").unwrap();
    let cases = cases::cases(entry).unwrap();
    let case = cases.iter().find(|case| case.name == "Two cylinders vibrating in antiphase").unwrap();
    let mut draft = Draft::of_record(&case.record(entry).unwrap());
    draft.set(&entry.shape(), "firing.even.order", order).unwrap();
    let record = draft.read(&entry.shape()).map_err(|errors| format!("{errors:?}"))?;
    entry.solve(&record, &Stop::new()).map_err(|err| err.to_string())
}

#[test]
fn a_firing_order_is_a_permutation() {
    let wanted = fired("1-2").unwrap().answers;
    for order in ["1, 2", " 1 2 ", "1;2"] {
        assert_eq!(fired(order).unwrap().answers, wanted, "{order}");
    }
    assert!(fired("2-1").is_ok());
    for wrong in ["1-1", "1-3", "0-1", "99999999999999999999999-1"] {
        let refused = fired(wrong).unwrap_err();
        assert!(refused.contains("write each number from 1 on once"), "{wrong}: {refused}");
    }
    assert!(fired("").is_err());
}
