use std::f64::consts::{PI, SQRT_2};

use dalembert_numerics::{
    Real,
    enclosure::{Enclosure, Jet},
    signs::{Sign, SignedPart, signs},
};
use itertools::zip_eq;
use proptest::prelude::*;

fn square(jet: Jet) -> Jet {
    jet.powi(2)
}

/// A function by name: of numbers, and of enclosures.
type Function = (&'static str, fn(f64) -> f64, fn(Jet) -> Jet);

const FUNCTIONS: [Function; 14] = [
    ("sin", |x| x.sin(), Jet::sin),
    ("cos", |x| x.cos(), Jet::cos),
    ("tan", |x| x.tan(), Jet::tan),
    ("asin", |x| x.asin(), Jet::asin),
    ("acos", |x| x.acos(), Jet::acos),
    ("exp", |x| x.exp(), Jet::exp),
    ("ln", |x| x.ln(), Jet::ln),
    ("log10", |x| x.log10(), Jet::log10),
    ("sinh", |x| x.sinh(), Jet::sinh),
    ("cosh", |x| x.cosh(), Jet::cosh),
    ("tanh", |x| x.tanh(), Jet::tanh),
    ("sqrt", |x| x.sqrt(), |x| x.root(2)),
    ("fifth root", |x| Real::root(x, 5), |x| x.root(5)),
    ("minus cube", |x| x.powi(-3), |x| x.powi(-3)),
];

proptest! {
    #[test]
    fn functions_are_within_their_enclosures(from in -12.0..12.0f64, width in 0.0..9.0f64, share in 0.0..1.0f64) {
        let (to, x) = (from + width, from + width * share);
        let x = x.min(to);
        for (name, number, enclosed) in FUNCTIONS {
            let (jet, value) = (enclosed(Jet::variable([from, to])), number(x));
            if value.is_finite() {
                prop_assert!(jet.value.low <= value && value <= jet.value.high, "{name} at {x}: {value} and {jet:?}");
                // The derivative by a central difference, to its error.
                let step = 1e-5 * x.abs().max(1e-2);
                let slope = (number(x + step) - number(x - step)) / (2.0 * step);
                let ends = enclosed(Jet::variable([x - step, x + step])).slope;
                let slack = 1e-9 * (1.0 + slope.abs()) / step.min(1.0) * 1e-3;
                if slope.is_finite() && jet.value.is_defined && !ends.is_none() {
                    prop_assert!(ends.low - slack <= slope && slope <= ends.high + slack, "{name}' at {x}: {slope} and {ends:?}");
                }
            } else {
                prop_assert!(!jet.value.is_defined, "{name} at {x}: {jet:?}");
            }
        }
    }

    #[test]
    fn operations_are_within_their_enclosures(
        a in -5.0..5.0f64, b in -5.0..5.0f64, widths in (0.0..2.0f64, 0.0..2.0f64), shares in (0.0..1.0f64, 0.0..1.0f64),
    ) {
        let (x, y) = (a + widths.0 * shares.0, b + widths.1 * shares.1);
        let (p, q) = (Enclosure::new(a, a + widths.0), Enclosure::new(b, b + widths.1));
        for (name, enclosed, value) in [
            ("+", p + q, x + y),
            ("-", p - q, x - y),
            ("*", p * q, x * y),
            ("/", p / q, x / y),
            ("atan2", p.atan2(q), y.atan2(x).mul_add(0.0, x.atan2(y))),
            ("max", p.max(q), x.max(y)),
            ("pow", p.abs().pow(q), x.abs().powf(y)),
        ] {
            let slack = 1e-15 * value.abs();
            prop_assert!(enclosed.low - slack <= value && value <= enclosed.high + slack, "{x} {name} {y}: {value} and {enclosed:?}");
        }
    }
}

#[test]
fn enclosures_of_points_are_a_few_last_places_wide() {
    for (name, number, enclosed) in FUNCTIONS {
        let x = 0.7;
        let value = enclosed(Jet::variable([x, x])).value;
        assert!(value.contains(number(x)), "{name}");
        assert!(value.high - value.low < 2e-14 * number(x).abs(), "{name}: {value:?}");
    }
}

/// The only parts are `signs`, with the zeros of these places between them.
fn assert_crossings(parts: &[SignedPart], expected: &[f64]) {
    let crossings: Vec<&SignedPart> = parts.iter().filter(|part| part.sign == Sign::Crossing).collect();
    assert_eq!(crossings.len(), expected.len(), "{parts:?}");
    for (part, zero) in zip_eq(crossings, expected) {
        assert!(part.from <= *zero && *zero <= part.to, "{part:?} and {zero}");
        assert!(part.to - part.from <= 1e-12 * zero.abs(), "{part:?}");
    }
}

#[test]
fn zeros_are_enclosed_and_all_there_are() {
    let parts = signs(&mut |x| square(Jet::variable(x)) - Jet::constant(2.0), [-3.0, 3.0]);
    assert_crossings(&parts, &[-SQRT_2, SQRT_2]);
    let of = |parts: &[SignedPart]| parts.iter().map(|part| part.sign).collect::<Vec<_>>();
    use Sign::{Above, Below, Crossing};
    assert_eq!(of(&parts), [Above, Crossing, Below, Crossing, Above]);
    let parts = signs(&mut |x| Jet::variable(x).sin(), [1.0, 1e3]);
    let zeros: Vec<f64> = (1..=318).map(|n| f64::from(n) * PI).collect();
    assert_crossings(&parts, &zeros);
    assert!(parts.iter().all(|part| part.sign != Sign::Undecided));
}

/// Two zeros closer together than any scan of a few hundred points would see.
#[test]
fn neighbouring_zeros_are_separated() {
    let (a, b) = (0.612_345, 0.612_346);
    let parts = signs(
        &mut |x| (Jet::variable(x) - Jet::constant(a)) * (Jet::variable(x) - Jet::constant(b)),
        [1e-3, 1e3],
    );
    assert_crossings(&parts, &[a, b]);
}

#[test]
fn a_zero_that_is_only_touched_is_undecided() {
    let parts = signs(&mut |x| square(Jet::variable(x) - Jet::constant(0.3)), [0.0, 1.0]);
    let undecided: Vec<&SignedPart> = parts.iter().filter(|part| part.sign == Sign::Undecided).collect();
    assert_eq!(undecided.len(), 1, "{parts:?}");
    assert!(undecided[0].from < 0.3 && 0.3 < undecided[0].to && undecided[0].to - undecided[0].from < 1e-6);
}

#[test]
fn a_part_without_a_value_is_undefined() {
    let parts = signs(&mut |x| Jet::variable(x).root(2) - Jet::constant(1.0), [-1.0, 4.0]);
    assert_eq!(parts[0].sign, Sign::Undefined);
    assert!(parts[0].to.abs() < 1e-9, "{parts:?}");
    assert_crossings(&parts, &[1.0]);
}
