use std::f64::consts::PI;
use std::ops::ControlFlow;

use dalembert_numerics::roots::{RootError, find, find_all};
use proptest::prelude::*;

use crate::close::{close, found};

fn go_on(_: f64) -> ControlFlow<()> {
    ControlFlow::Continue(())
}

#[test]
fn known_zeros() {
    close(found(find(|x| x * x - 2.0, [0.0, 2.0], go_on)), 2f64.sqrt(), 1e-13);
    // Dottie's number and the first mode of a cantilever, cos x cosh x = −1.
    close(found(find(|x| x.cos() - x, [0.0, 1.0], go_on)), 0.739_085_133_215_160_6, 1e-13);
    close(found(find(|x| x.cos() * x.cosh() + 1.0, [1.0, 3.0], go_on)), 1.875_104_068_711_961_2, 1e-13);
    // Flat zeros, where interpolation alone would crawl.
    close(found(find(|x| (x - 1.0).powi(9), [0.0, 3.0], go_on)), 1.0, 1e-12);
    assert!(found(find(|x| x.powi(3), [-1.0, 2.0], go_on)).abs() < 1e-12);
    assert_eq!(found(find(|x| x, [0.0, 2.0], go_on)), 0.0);
    assert_eq!(found(find(|x| x - 2.0, [0.0, 2.0], go_on)), 2.0);
}

#[test]
fn far_from_one() {
    for exponent in [-250, -100, 100, 150] {
        let root = 10f64.powi(exponent);
        close(found(find(|x| x / root - 1.0, [0.0, 7.0 * root], go_on)), root, 1e-13);
    }
}

#[test]
fn what_is_no_zero_is_refused() {
    let jump = find(|x| if x < 0.3 { -1.0 } else { 1.0 }, [0.0, 1.0], go_on);
    assert!(matches!(jump, Err(RootError::Discontinuity { at }) if (at - 0.3).abs() < 1e-12));
    let pole = find(|x| 1.0 / (x - 0.3), [0.0, 1.0], go_on);
    assert!(matches!(pole, Err(RootError::Discontinuity { at }) if (at - 0.3).abs() < 1e-12));
    assert_eq!(find(|x| x * x + 1.0, [0.0, 1.0], go_on), Err(RootError::NotBracketed { from: 0.0, to: 1.0 }));
    assert_eq!(find(f64::sqrt, [-1.0, 1.0], go_on), Err(RootError::NotFinite { at: -1.0 }));
    for (from, to) in [(1.0, 0.0), (1.0, 1.0), (0.0, f64::INFINITY)] {
        assert_eq!(find(|x| x, [from, to], go_on), Err(RootError::Range { from, to }));
    }
    assert!(matches!(find(|x| x, [f64::NAN, 1.0], go_on), Err(RootError::Range { .. })));
}

#[test]
fn the_observer_stops_the_search() {
    let mut seen = 0;
    let stopped = find(
        |x| x.cos() - x,
        [0.0, 1.0],
        |_| {
            seen += 1;
            if seen == 3 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        },
    );
    assert_eq!((stopped, seen), (Err(RootError::Stopped), 3));
    assert_eq!(find_all(f64::sin, [1.0, 50.0], 1000, |_| ControlFlow::Break(())), Err(RootError::Stopped));
}

#[test]
fn all_zeros_and_no_poles() {
    let zeros = found(find_all(f64::sin, [1.0, 50.0], 1000, go_on));
    assert_eq!(zeros.len(), 15);
    for (i, zero) in zeros.iter().enumerate() {
        close(*zero, PI * (i + 1) as f64, 1e-13);
    }
    // tan has as many poles as zeros; zeros on the points of the scan count once.
    assert_eq!(found(find_all(f64::tan, [1.0, 10.0], 977, go_on)).len(), 3);
    assert_eq!(found(find_all(|x| x * (x - 1.0), [-1.0, 2.0], 30, go_on)).len(), 2);
    assert_eq!(found(find_all(|x| x - 4.0, [0.0, 4.0], 5, go_on)), [4.0]);
    assert_eq!(find_all(|x| x, [0.0, 4.0], 0, go_on), Err(RootError::Range { from: 0.0, to: 4.0 }));
}

proptest! {
    #[test]
    fn every_bracketed_zero_is_found(root in -100.0..100.0f64, below in 0.01..50.0, above in 0.01..50.0, bend in 0.0..3.0) {
        let f = |x: f64| (x - root) * (1.0 + bend * (x - root).powi(2)) * (0.1 * (x - root)).exp();
        let zero = found(find(f, [root - below, root + above], go_on));
        prop_assert!((zero - root).abs() <= 1e-13 * root.abs() + 1e-15);
    }
}
