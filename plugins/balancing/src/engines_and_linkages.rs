//! Engines and linkages.

pub mod linkage_balance;
pub mod locomotive;
pub mod reciprocating;
