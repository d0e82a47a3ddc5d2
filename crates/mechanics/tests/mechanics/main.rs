//! The mechanics held against published numbers, closed forms, second ways and scaling.

mod close;

mod absorber;
mod balance;
mod balance_many;
mod beam;
mod chain;
mod dimensions;
mod eigen;
mod engine;
mod forced;
mod free_vibration;
mod gyroscope;
mod identification;
mod intervals;
mod jet;
mod linalg;
mod many_degrees;
mod models;
mod motion;
mod ode;
mod planar;
mod polynomial;
mod real;
mod rigid;
mod rigid_body;
mod rigid_motion;
mod roots;
mod sdof;
mod slider_crank;
mod spring;
mod supports;
mod sweep;
mod tops;
mod whirl;
mod work;
