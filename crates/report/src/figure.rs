//! Plots and drawings as pictures for paper and pages, and what they share with the screen: [`axes`], [`ticks`],
//! [`strokes`] are pure numbers.

pub mod axes;
#[cfg(feature = "word")]
pub(crate) mod emf;
mod labels;
mod letters;
pub mod map;
pub mod picture;
mod plotted;
pub mod ruler;
mod sketched;
pub mod strokes;
pub mod ticks;
pub mod tornado;

use dalembert_core::{Drawing, Exhibit, Locale, Plot};

use self::{axes::PlotWindow, picture::Picture};

/// View of a plot, as set on a screen: window, cursor, hidden curves.
#[derive(Clone, Copy, Debug, Default)]
pub struct Seen<'a> {
    /// Visible window.
    pub view: PlotWindow,
    /// Position of the cursor: a value of `x` in SI.
    pub cursor: Option<f64>,
    /// One of the same axes, whose curves lie under those of the plot.
    pub pinned: Option<&'a Plot>,
}

/// An exhibit as a picture; of what moves, its first frame, and of a scene in space, its usual side. `None` for a table,
/// and where there is nothing to draw.
pub fn figure(exhibit: &Exhibit, locale: &Locale) -> Option<Picture> {
    match exhibit {
        Exhibit::Plot(plot) => self::plot(plot, &Seen::default(), locale),
        _ => drawing(&*exhibit.sketch(0)?, locale),
    }
}

/// A plot as it is examined.
pub fn plot(plot: &Plot, seen: &Seen<'_>, locale: &Locale) -> Option<Picture> {
    plotted::picture(plot, seen, locale)
}

/// Separate points, with letters for a screen of fixed pitch.
pub fn scatter(plot: &Plot, locale: &Locale) -> Option<Picture> {
    let picture = self::plot(plot, &Seen::default(), locale)?;
    Some(Picture { letters: letters::of_points(plot, locale), ..picture })
}

/// A drawing.
pub fn drawing(drawing: &Drawing, locale: &Locale) -> Option<Picture> {
    sketched::picture(drawing, locale)
}
