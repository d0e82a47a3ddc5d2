//! Plots and drawings of machines in the cells of a terminal.
//!
//! A [`Plot`](dalembert_core::Plot) or [`Drawing`](dalembert_core::Drawing) is plain data; [`plot::render`] and
//! [`drawing::render`] draw it into a buffer of any size, in braille, blocks, dots or ASCII, or give back its strokes in
//! pixels where [`look::Appearance`] has the size of a cell. Axes, ticks and strokes are those of the same figure on
//! paper (`dalembert_report::figure`). Nothing here reads keys or holds a screen: what a user has set on a plot is a
//! value, [`plot::PlotState`].
//!
//! ```
//! use dalembert_core::{Axis, Locale, Plot, Series};
//! use dalembert_plot::{
//!     look::Appearance,
//!     plot::{self, PlotState},
//! };
//! use ratatui::{buffer::Buffer, layout::Rect};
//!
//! let points = (0..=200).map(|n| f64::from(n) / 100.0).map(|t| (t, 0.01 * (6.0 * t).cos())).collect();
//! let series = vec![Series::line("Displacement", points)];
//! let motion = Plot::new("Free vibration", Axis::linear("t", "s"), Axis::linear("x", "mm"), series);
//!
//! let area = Rect::new(0, 0, 60, 16);
//! let mut buffer = Buffer::empty(area);
//! let state = PlotState::default().moved(&motion, 0.0);
//! plot::render(&motion, None, &state, &Appearance::default(), &Locale::english(), area, &mut buffer);
//!
//! let title: String = (0..14).map(|x| buffer[(x, 0)].symbol()).collect();
//! assert_eq!(title, "Free vibration");
//! assert_eq!(plot::readout(&motion, &state, &Locale::english()).unwrap(), "t = 1 s   Displacement = 9.6017 mm");
//! ```

pub mod dial;
pub mod drawing;
pub mod look;
pub mod plot;
pub mod wrap;

dalembert_core::messages!("../locales/pt-BR.ftl");
