//! Part of the operating system in files and processes: owners, permissions, who still runs.

#[cfg(unix)]
mod unix;
#[cfg(windows)]
#[expect(clippy::unnecessary_wraps, reason = "on Unix these functions can fail")]
mod windows;

#[cfg(unix)]
pub(super) use unix::*;
#[cfg(windows)]
pub(super) use windows::*;
