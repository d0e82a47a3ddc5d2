//! Lines cut to what can be seen of them.

/// The part of a straight line between two corners, the least and the largest coordinates; `None` where no part lies
/// there. Ends that lie inside stay what they were (Liang and Barsky, ACM Transactions on Graphics 3, 1984).
pub fn clipped(
    from: (f64, f64),
    to: (f64, f64),
    [least, most]: &[(f64, f64); 2],
) -> Option<((f64, f64), (f64, f64))> {
    let (across, down) = (to.0 - from.0, to.1 - from.1);
    let (mut first, mut last) = (0.0f64, 1.0f64);
    for (toward, room) in [
        (-across, from.0 - least.0),
        (across, most.0 - from.0),
        (-down, from.1 - least.1),
        (down, most.1 - from.1),
    ] {
        if toward == 0.0 {
            if room < 0.0 {
                return None;
            }
        } else if toward < 0.0 {
            first = first.max(room / toward);
        } else {
            last = last.min(room / toward);
        }
    }
    let at = |share: f64| (from.0 + across * share, from.1 + down * share);
    let ends = (if first > 0.0 { at(first) } else { from }, if last < 1.0 { at(last) } else { to });
    (first <= last).then_some(ends)
}
