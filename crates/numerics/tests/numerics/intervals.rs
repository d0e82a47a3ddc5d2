use std::ops::Bound::{self, Excluded, Included, Unbounded};

use dalembert_numerics::intervals::{Interval, IntervalSet};
use proptest::prelude::*;

fn set(lower: Bound<f64>, upper: Bound<f64>) -> IntervalSet {
    IntervalSet::interval(lower, upper)
}

#[test]
fn ends_belong_or_not() {
    let half_open = set(Included(1.0), Excluded(2.0));
    assert!(half_open.contains(1.0) && half_open.contains(1.5) && !half_open.contains(2.0));
    let other = set(Excluded(1.0), Included(2.0));
    assert!(!other.contains(1.0) && other.contains(2.0));
    let ray = set(Excluded(0.0), Unbounded);
    assert!(
        !ray.contains(0.0)
            && !ray.contains(-0.0)
            && ray.contains(f64::MIN_POSITIVE)
            && ray.contains(f64::MAX)
    );
    for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert!(!IntervalSet::all().contains(x));
    }
}

#[test]
fn a_single_number_and_nothing() {
    let point = set(Included(3.0), Included(3.0));
    assert!(point.contains(3.0) && !point.contains(3.0000001));
    for nothing in [
        set(Included(3.0), Excluded(3.0)),
        set(Excluded(3.0), Included(3.0)),
        set(Included(4.0), Included(3.0)),
    ] {
        assert!(nothing.is_none());
        assert_eq!(nothing, IntervalSet::none());
    }
    let holed = point.complement();
    assert!(!holed.contains(3.0) && holed.intervals().len() == 2);
    assert!(holed.union(&point).is_all());
}

#[test]
fn touching_intervals_become_one() {
    let joined = set(Included(0.0), Excluded(1.0)).union(&set(Included(1.0), Included(2.0)));
    assert_eq!(joined, set(Included(0.0), Included(2.0)));
    let parted = set(Included(0.0), Excluded(1.0)).union(&set(Excluded(1.0), Included(2.0)));
    assert!(!parted.contains(1.0));
    let ends: Vec<Interval> = parted.intervals().collect();
    assert_eq!(
        ends,
        [
            Interval { lower: Included(0.0), upper: Excluded(1.0) },
            Interval { lower: Excluded(1.0), upper: Included(2.0) },
        ]
    );
    assert_eq!(set(Included(0.0), Included(f64::INFINITY)), set(Included(-0.0), Unbounded));
}

#[test]
fn mapping_keeps_open_ends_open() {
    let doubled = set(Excluded(1.0), Included(2.0)).union(&set(Included(8.0), Unbounded));
    let roots = doubled.map_ascending(f64::cbrt);
    let expected = set(Excluded(1.0), Included(2f64.cbrt())).union(&set(Included(2.0), Unbounded));
    assert_eq!(roots, expected);
}

type Ends = (Bound<f64>, Bound<f64>);

fn ends() -> impl Strategy<Value = Bound<f64>> {
    // Few values, so that ends often meet.
    let number = (0..6).prop_map(f64::from);
    prop_oneof![number.clone().prop_map(Included), number.prop_map(Excluded), Just(Unbounded),]
}

fn sets() -> impl Strategy<Value = (Vec<Ends>, IntervalSet)> {
    prop::collection::vec((ends(), ends()), 0..4).prop_map(|pieces| {
        let whole = pieces
            .iter()
            .map(|&(lower, upper)| set(lower, upper))
            .fold(IntervalSet::none(), |whole, piece| whole.union(&piece));
        (pieces, whole)
    })
}

fn within(pieces: &[Ends], x: f64) -> bool {
    use std::ops::RangeBounds;
    pieces.iter().any(|piece| piece.contains(&x))
}

proptest! {
    #[test]
    fn algebra_of_sets((pieces, a) in sets(), (others, b) in sets()) {
        for i in -2..14 {
            let x = f64::from(i) / 2.0;
            let (in_a, in_b) = (within(&pieces, x), within(&others, x));
            prop_assert_eq!(a.contains(x), in_a);
            prop_assert_eq!(a.union(&b).contains(x), in_a || in_b);
            prop_assert_eq!(a.intersection(&b).contains(x), in_a && in_b);
            prop_assert_eq!(a.complement().contains(x), !in_a);
        }
        prop_assert_eq!(a.complement().complement(), a.clone());
        prop_assert_eq!(a.union(&b), b.union(&a));
        prop_assert_eq!(a.union(&a), a.clone());
        prop_assert!(a.union(&a.complement()).is_all());
        prop_assert!(a.intersection(&a.complement()).is_none());
        let again = a.intervals().fold(IntervalSet::none(), |set, part| {
            set.union(&IntervalSet::interval(part.lower, part.upper))
        });
        prop_assert_eq!(again, a);
    }
}
