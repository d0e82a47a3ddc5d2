//! What the panes of the bench say, as lines of text. Scrolling is their user's.

mod columns;
pub mod results;
pub mod sources;
pub mod table;
pub mod working;
mod wrap;

use ratatui::text::Line;

dalembert_core::messages!("../locales/widgets.pt-BR.ftl");

/// The lines of a pane, and at which of them its parts begin.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Page {
    /// The lines, none wider than was asked for.
    pub lines: Vec<Line<'static>>,
    /// The first line of each step or case.
    pub starts: Vec<usize>,
}
