//! One file a subcommand.

pub(crate) mod check;
pub(crate) mod completions;
pub(crate) mod confirm;
pub(crate) mod field;
pub(crate) mod find;
pub(crate) mod grade;
pub(crate) mod info;
pub(crate) mod list;
pub(crate) mod man;
pub(crate) mod new;
pub(crate) mod optimise;
pub(crate) mod replay;
pub(crate) mod schema;
pub(crate) mod sensitivity;
pub(crate) mod serve;
pub(crate) mod settings;
pub(crate) mod show;
pub(crate) mod solve;
pub(crate) mod study;
pub(crate) mod tour;
pub(crate) mod variants;
pub(crate) mod verify;
pub(crate) mod workbench;
