//! Analyses by virtual work and virtual power.

pub mod a_frame;
pub mod bar_and_cord;
mod built;
pub mod compound_lever;
mod dyad;
pub mod engine;
pub mod epicyclic_train;
mod equilibria;
pub mod equilibrium;
pub mod equivalent_rod;
pub mod five_bar;
pub mod flywheel;
pub mod four_bar;
pub mod guided_bar;
pub mod hanging_chain;
pub mod lazy_tongs;
pub mod mechanism;
mod one_freedom;
pub mod parts;
pub mod quick_return;
pub mod rack_press;
pub mod rhombus;
pub mod roberval_balance;
pub mod rolling_disc;
pub mod scissor_lift;
pub mod scotch_yoke;
pub mod screw_jack;
pub mod six_bar;
pub mod slider_crank;
mod sources;
pub mod spring_lever;
pub mod toggle_press;
pub mod two_bar_linkage;
pub mod virtual_power;
pub mod works;

dalembert_core::messages!("../locales/pt-BR.ftl");
