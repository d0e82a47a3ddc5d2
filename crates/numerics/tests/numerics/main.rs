//! Numerical methods compared with closed forms, published values, second methods and scaling.

mod close;

mod distribution;
mod eigen;
mod enclosure;
mod extremes;
mod givens;
mod intervals;
mod linalg;
mod nonlinear;
mod ode;
mod polynomial;
mod real;
mod roots;
mod sampling;
mod sparse;
