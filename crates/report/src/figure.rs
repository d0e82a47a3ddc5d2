//! What plots and drawings are made of before they are drawn: pure numbers, for a screen or a file.

pub mod axes;
pub mod strokes;
pub mod ticks;
