//! Analyses: balancing.
