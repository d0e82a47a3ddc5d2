//! The program without its analyses: a binary links those it wants and calls [`main`].
