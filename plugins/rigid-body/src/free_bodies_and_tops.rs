//! Free bodies and tops.

pub mod free_axisymmetric;
pub mod free_triaxial;
pub mod heavy_top;
pub mod top_nutation;
