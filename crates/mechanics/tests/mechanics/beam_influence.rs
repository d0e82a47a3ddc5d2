//! Tests of `beam::influence`.

use dalembert_mechanics::beam::influence::*;

/// Own weight is a load at every place.
#[test]
fn own_weight_is_the_sum_of_its_parts() {
    let (span, c, parts) = (1.3, 0.6, 6000);
    let sum = |length: f64, at: &dyn Fn(f64) -> f64| {
        let step = length / f64::from(parts);
        (0..parts).map(|n| step * at((f64::from(n) + 0.5) * step)).sum::<f64>()
    };
    let close = |a: f64, b: f64| assert!((a - b).abs() < 1e-6 * b.abs(), "{a} is not {b}");
    for x in [0.2, 0.7, 1.1] {
        let ordered = |a: f64| (a.min(x), a.max(x));
        close(
            sum(span, &|a| simply_supported(1.0, span, ordered(a).0, ordered(a).1)),
            own_simply_supported(1.0, 1.0, span, x),
        );
        close(sum(span, &|a| cantilever(1.0, ordered(a).0, ordered(a).1)), own_cantilever(1.0, 1.0, span, x));
        let inner = sum(span, &|a| simply_supported(1.0, span, ordered(a).0, ordered(a).1));
        let outer = sum(c, &|u| overhang_of_inner_load(1.0, span, u, x));
        close(inner + outer, own_inside(1.0, 1.0, span, c, x));
    }
    let u = 0.35;
    let inner = sum(span, &|a| overhang_of_inner_load(1.0, span, u, a));
    let outer = sum(c, &|v| overhang(1.0, span, v.min(u), v.max(u)));
    close(inner + outer, own_overhang(1.0, 1.0, span, c, u));
}
