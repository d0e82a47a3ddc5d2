//! Analyses: rigid-body.
