//! The terminal workbench: pick a problem, edit its inputs, and see the answers change.
//!
//! A [`Model`] holds everything; [`update`] changes it by a [`Msg`] and answers with [`Effect`]s, plain values that
//! the run loop carries out; [`view`] draws it. So a test types keys and reads the screen, without a terminal.

mod app;
pub mod ask;
pub mod bench;
pub mod dialog;
pub mod effect;
pub mod field;
pub mod files;
pub mod form;
pub mod harness;
pub mod intent;
pub mod keys;
pub mod layout;
pub mod model;
mod palette;
pub mod pane;
pub mod panes;
pub mod picker;
pub mod playback;
pub mod problem;
pub mod remembered;
pub mod replay;
pub mod settings;
pub mod solver;
mod text;
pub mod text_entry;
pub mod typed;
mod update;
mod view;

pub use app::{Options, run};
pub use dalembert_plot::{drawing, look, plot};
pub use dalembert_terminal::{self as terminal, glyphs, pixels};
pub use effect::Effect;
pub use model::{Model, Msg};
pub use update::{start, update};
pub use view::{seen_panes, tempo, view};

dalembert_core::messages!("../locales/pt-BR.ftl");
