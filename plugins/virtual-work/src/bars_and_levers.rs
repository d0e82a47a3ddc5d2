//! Bars and levers.

pub mod a_frame;
pub mod bar_and_cord;
pub mod compound_lever;
pub mod guided_bar;
pub mod hanging_chain;
pub mod rhombus;
pub mod roberval_balance;
pub mod spring_lever;
pub mod two_bar_linkage;
