//! Plots and drawings as pictures for paper and pages, and what they share with the screen: [`axes`], [`ticks`],
//! [`strokes`] are pure numbers.

pub mod axes;
mod labels;
pub mod picture;
mod plotted;
mod sketched;
pub mod strokes;
pub mod ticks;

use dalembert_core::{Exhibit, Locale};

use self::picture::Picture;

/// An exhibit as a picture; of a film, its first frame. `None` for a table, and where there is nothing to draw.
pub fn figure(exhibit: &Exhibit, locale: &Locale) -> Option<Picture> {
    match exhibit {
        Exhibit::Table(_) => None,
        Exhibit::Plot(plot) => plotted::picture(plot, locale),
        Exhibit::Drawing(_) | Exhibit::Film(_) => {
            let drawing = exhibit.sketch(0)?;
            sketched::picture(&drawing, locale)
        }
    }
}
