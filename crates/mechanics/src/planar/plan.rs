//! A mechanism compiled for repeated use: which coordinates follow from others without more ado, and the elimination
//! of its equations as a list of operations on a flat array.
//!
//! A constraint with a constant Jacobian entry by a coordinate, as that of a pin by the origin of a body, gives that
//! coordinate exactly: along a tree of such equations all origins follow from the angles. The other equations, one
//! pair for each loop, are eliminated with pivots chosen for few operations among those that are large in their row
//! (H. M. Markowitz; I. S. Duff, A. M. Erisman, J. K. Reid, *Direct Methods for Sparse Matrices*, ch. 7 and 9).

mod core;
mod layout;
mod order;

pub(super) use core::{Core, order};
pub(super) use layout::{Layout, Work};
pub(super) use order::{Conditioning, Order};
