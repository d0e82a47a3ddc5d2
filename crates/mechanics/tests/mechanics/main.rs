//! The mechanics held against published numbers, closed forms, second methods and scaling.

mod close;

mod absorber;
mod balance;
mod balance_many;
mod beam;
mod centres;
mod chain;
mod dimensions;
mod engine;
mod forced;
mod free_vibration;
mod friction;
mod gyroscope;
mod identification;
mod jet;
mod many_degrees;
mod models;
mod motion;
mod planar;
mod rigid;
mod rigid_body;
mod rigid_motion;
mod rolling;
mod sdof;
mod slider_crank;
mod spring;
mod supports;
mod sweep;
mod tops;
mod whirl;
mod work;
