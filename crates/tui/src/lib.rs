//! TODO

pub mod files;
pub mod glyphs;
pub mod terminal;
