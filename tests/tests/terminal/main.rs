//! The workbench before a user: what is typed or clicked, and the screens that follow.

mod asking;
mod branches;
mod causes;
mod data_entry;
mod exercises;
mod field;
mod first_screen;
mod importing;
mod keys;
mod mouse;
mod new_files;
mod panes;
mod parts;
mod picker;
mod problem_files;
mod screens;
mod search;
mod sensitivities;
mod settings;
mod studies;
mod typing;
mod widgets;
