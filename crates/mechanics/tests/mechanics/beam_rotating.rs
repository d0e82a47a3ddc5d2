//! Tests of `beam::rotating`.

use dalembert_mechanics::beam::rotating::*;
use itertools::Itertools as _;

/// Wright, Smith, Thresher and Wang (1982): uniform blade, no hub.
#[test]
fn frequencies_of_wright() {
    for (speed, printed) in [
        (0.0, [3.5160, 22.0345, 61.6972]),
        (1.0, [3.6816, 22.1810, 61.8418]),
        (2.0, [4.1373, 22.6149, 62.2732]),
        (5.0, [6.4495, 25.4461, 65.2050]),
        (10.0, [11.2023, 33.6404, 74.6493]),
        (12.0, [13.1702, 37.6031, 79.6145]),
    ] {
        let blade = Rotating { speed, hub: 0.0, tip: 0.0 };
        for (lambda, printed) in blade.ritz(20, 3).unwrap().lambdas.iter().zip_eq(printed) {
            assert!((lambda.sqrt() - printed).abs() < 0.6e-4, "{speed}: {} {printed}", lambda.sqrt());
        }
    }
}

#[test]
fn moments_balance_as_energies_do() {
    for (speed, hub, tip) in [(0.0, 0.0, 0.5), (3.0, 0.5, 0.0), (12.0, 2.0, 1.0), (40.0, 0.1, 0.0)] {
        let blade = Rotating { speed, hub, tip };
        let ritz = blade.ritz(24, 4).unwrap();
        for (lambda, shape) in ritz.lambdas.iter().zip_eq(&ritz.shapes) {
            let gap = blade.moment_balance(shape) / lambda - 1.0;
            assert!(gap.abs() < 1e-9, "{blade:?}: {gap:e}");
        }
    }
}

/// At great speed the blade is a string that turns: `λ → n(2n − 1) η²` without a hub.
#[test]
fn a_fast_blade_is_a_string() {
    let blade = Rotating { speed: 300.0, hub: 0.0, tip: 0.0 };
    let lambdas = blade.ritz(40, 2).unwrap().lambdas;
    for (lambda, string) in lambdas.iter().zip_eq([1.0, 6.0]) {
        let gap = lambda / 9e4 / string - 1.0;
        assert!(gap > 0.0 && gap < 0.03, "{gap}");
    }
    // Southwell: the shape at rest bounds the first frequency from above, rest and string from below.
    let slow = Rotating { speed: 4.0, hub: 0.0, tip: 0.0 };
    let rest = Rotating { speed: 0.0, ..slow }.ritz(20, 1).unwrap();
    let lambda = slow.ritz(20, 1).unwrap().lambdas[0];
    assert!(lambda < rest.lambdas[0] + 16.0 * slow.southwell(&rest.shapes[0]));
    assert!(lambda > rest.lambdas[0] + 16.0);
}
