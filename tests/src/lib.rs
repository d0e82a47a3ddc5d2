//! What the tests of the whole program share: a person before the screens, and a terminal for the program itself.

pub mod person;
pub mod pty;
