//! Figures in letters of fixed pitch.

use dalembert_core::{Locale, Plot};

use super::axes::Axes;

/// Letters across a figure, and lines of it.
const ACROSS: usize = 60;
const LINES: usize = 12;
/// Letters of one point at a place, of a few, and of many.
const POINTS: [char; 3] = ['.', 'o', '@'];
/// Points that are many.
const MANY: usize = 5;

/// Separate points as letters, the ends of the axes as numbers.
pub(super) fn of_points(plot: &Plot, locale: &Locale) -> Vec<String> {
    let Some(axes) = Axes::of(plot) else { return Vec::new() };
    let mut counts = [[0; ACROSS]; LINES];
    let place = |share: f64, count: usize| ((share * count as f64) as usize).min(count - 1);
    for (x, y) in plot.series.iter().flat_map(|series| &series.points) {
        if let (Some(across), Some(up)) = (axes.x.of(*x), axes.y.of(*y)) {
            counts[LINES - 1 - place(up, LINES)][place(across, ACROSS)] += 1;
        }
    }
    let ends = [axes.y.span.to, axes.y.span.from].map(|end| axes.y.write(axes.y.si(end), locale.style));
    let margin = ends.iter().map(|end| end.chars().count()).max().unwrap_or(0);
    let mut lines = vec![plot.title.render(locale)];
    for (n, row) in counts.iter().enumerate() {
        let end = match n {
            0 => &ends[0],
            _ if n + 1 == LINES => &ends[1],
            _ => "",
        };
        let row: String = row.iter().map(|count| letter(*count)).collect();
        lines.push(format!("  {end:>margin$} |{}", row.trim_end()));
    }
    let [from, to] = [axes.x.span.from, axes.x.span.to].map(|end| axes.x.write(axes.x.si(end), locale.style));
    lines.push(foot(margin, ACROSS, &from, &to));
    lines
}

/// The line below a figure: the ends of its horizontal axis.
pub(super) fn foot(margin: usize, across: usize, from: &str, to: &str) -> String {
    let between = across.saturating_sub(from.chars().count() + to.chars().count());
    format!("  {}  {from}{}{to}", " ".repeat(margin), " ".repeat(between.max(1)))
}

fn letter(count: usize) -> char {
    match count {
        0 => ' ',
        1 => POINTS[0],
        _ if count < MANY => POINTS[1],
        _ => POINTS[2],
    }
}
