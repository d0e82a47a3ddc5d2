//! Analyses: virtual-work.
