//! Measured points in order.

use dalembert_core::{Refusal, Text, Worksheet};

/// The points in the order of their frequencies, each once; says where that was not so.
pub(super) fn ordered<T: PartialEq, W: Worksheet>(
    mut points: Vec<(f64, T)>,
    sheet: W,
) -> Result<Vec<(f64, T)>, Refusal> {
    if points.windows(2).any(|pair| pair[0].0 > pair[1].0) {
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        sheet.warn(|| Text::new("the frequencies of the table are not in ascending order: they were sorted"));
    }
    let before = points.len();
    points.dedup_by(|a, b| a == b);
    let twice = before - points.len();
    if twice > 0 {
        sheet.warn(|| {
            Text::new("{count} points are repeated in the table with the same values: each is used once")
                .with("count", twice)
        });
    }
    if let Some(pair) = points.windows(2).find(|pair| pair[0].0 >= pair[1].0) {
        let why = Text::new(
            "the frequency {frequency} appears twice in the table: keep one point, or the mean, for each frequency",
        );
        return Err(Refusal::because(why.with_quantity("frequency", pair[0].0, "Hz")));
    }
    Ok(points)
}
