#![doc = include_str!("../README.md")]
//!
//! Numerical methods on `f64`: no mechanics, no text, no units, no input and no output.
//!
//! Every method refuses what has no answer with a typed error, and never returns NaN or infinity.
//!
//! | topic | modules |
//! |---|---|
//! | linear algebra | [`linalg`], [`givens`] |
//! | differential equations | [`ode`], with events and dense output |
//! | roots and extremes | [`roots`], [`nonlinear`], [`polynomial`], [`extremes`] |
//! | minimum under constraints | [`optimisation`] |
//! | quadrature, derivatives | [`quadrature`], [`gauss_legendre`], [`differentiation`] |
//! | Fourier coefficients | [`fourier`] |
//! | special functions | [`elementary`], [`elliptic`], [`bessel`] |
//! | sets of numbers | [`intervals`] |
//! | interval arithmetic, proven signs | [`enclosure`], [`signs`] |
//! | random numbers, points that fill a cube | [`random`], [`sampling`] |
//! | probability distributions | [`distribution`] |
//! | formulas for several samples at once | [`simd`] |

pub mod bessel;
pub mod differentiation;
pub mod distribution;
pub mod elementary;
pub mod elliptic;
pub mod enclosure;
pub mod extremes;
pub mod fourier;
pub mod gauss_legendre;
pub mod givens;
pub mod intervals;
pub mod linalg;
pub mod nonlinear;
pub mod ode;
pub mod optimisation;
pub mod polynomial;
pub mod quadrature;
pub mod random;
pub mod roots;
pub mod sampling;
pub mod signs;
pub mod simd;

mod real;

pub use real::{Real, Vector};
