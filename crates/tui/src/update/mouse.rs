//! What the mouse does.

use ratatui::crossterm::event::MouseEvent;

use crate::model::{Effect, Model};

pub(super) fn happened(_model: &mut Model, _event: MouseEvent) -> Vec<Effect> {
    Vec::new()
}
