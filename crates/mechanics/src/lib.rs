#![doc = include_str!("../README.md")]
//!
//! The mechanics itself: numbers in SI, no text, no units, no input and no output.
//!
//! Two kinds of function live here. A *closed formula* is generic over [`Real`] or [`Vector`] and is written in
//! the shape of the textbook, since a worked solution prints it as written; it checks nothing. A *numerical
//! kernel* works on `f64`, refuses what has no answer with a typed error, and never returns NaN or infinity.
//!
//! | topic | modules |
//! |---|---|
//! | balancing of rotors, engines and linkages | [`balance`] |
//! | beams and cross-sections | [`beam`], [`section`] |
//! | springs, and how they combine | [`spring`] |
//! | plane linkages by formulas | [`four_bar`], [`slider_crank`], [`linkage`] |
//! | plane mechanisms of any shape | [`planar`] |
//! | virtual work and virtual power | [`work`] |
//! | rigid bodies in space | [`rigid`] |
//! | one degree of freedom | [`sdof`] |
//! | many degrees of freedom, random and nonlinear vibration | [`vibration`] |
//! | parameters from measurements | [`identification`] |
//! | rotors: Jeffcott, finite elements | [`whirl`], [`rotor`] |

pub mod balance;
pub mod beam;
pub mod four_bar;
pub mod identification;
pub mod linkage;
pub mod planar;
pub mod rigid;
pub mod rotor;
pub mod sdof;
pub mod section;
pub mod slider_crank;
pub mod spring;
pub mod vibration;
pub mod whirl;
pub mod work;

pub use dalembert_numerics::{Real, Vector};
