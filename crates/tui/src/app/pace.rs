//! Pace of animations: what they may send, and the frames that are left out.

use std::time::Duration;

use crate::terminal;

/// Bytes a second that animations may send: on this machine, and where a line lies between.
const ANIMATION_BYTES: (f64, f64) = (64e3, 8e3);
/// The same on this machine for pictures in pixels: 60 kB a frame, 25 times a second.
const PICTURE_BYTES: f64 = 1.5e6;
/// Of the time of a line that is slower still, and of that of the drawing, animations take at most one part of so many.
const ANIMATION_SHARE: u32 = 4;

/// The pace that a terminal allows.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pace {
    is_remote: bool,
    /// Bytes a second of the line, where it is slow.
    line: Option<f64>,
}

impl Pace {
    /// That of standard output.
    pub(super) fn of_line(is_remote: bool) -> Self {
        Self { is_remote, line: terminal::line_rate() }
    }

    /// The time from a frame to the next: its tempo, or more where sending or drawing takes long.
    pub(super) fn time_to_next(
        self,
        tempo: Duration,
        (bytes, took): (usize, Duration),
        in_pixels: bool,
    ) -> Duration {
        let rate = match (self.is_remote, in_pixels) {
            (true, _) => ANIMATION_BYTES.1,
            (false, false) => ANIMATION_BYTES.0,
            (false, true) => PICTURE_BYTES,
        };
        let rate = self.line.map_or(rate, |line| rate.min(line / f64::from(ANIMATION_SHARE)));
        tempo.max(Duration::from_secs_f64(bytes as f64 / rate)).max(took * ANIMATION_SHARE)
    }
}

/// Frames to go on by after a time: pictures in pixels leave out what they are too late for.
pub(super) fn steps(tempo: Duration, elapsed: Duration, in_pixels: bool) -> u32 {
    let frames = elapsed.as_secs_f64() / tempo.as_secs_f64();
    if in_pixels { frames.clamp(1.0, 100.0) as u32 } else { 1 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pictures_that_are_late_leave_frames_out() {
        let (tempo, none) = (Duration::from_millis(40), Duration::ZERO);
        let local = Pace { is_remote: false, line: None };
        // A frame of 60 kB keeps the pace of 25 a second; one of 180 kB takes the time of three, and is followed by the third.
        assert_eq!(local.time_to_next(tempo, (60_000, none), true), tempo);
        let late = local.time_to_next(tempo, (180_000, none), true);
        assert_eq!((late, steps(tempo, late, true)), (Duration::from_millis(120), 3));
        // Braille over ssh shows every frame, only later.
        let remote = Pace { is_remote: true, line: None };
        let late = remote.time_to_next(tempo, (1600, none), false);
        assert_eq!((late, steps(tempo, late, false)), (Duration::from_millis(200), 1));
        // On a line of 9600 baud a quarter is theirs; drawing has a quarter of the time at most.
        let serial = Pace { line: Some(960.0), ..remote };
        assert_eq!(serial.time_to_next(tempo, (240, none), false), Duration::from_secs(1));
        assert_eq!(
            local.time_to_next(tempo, (0, Duration::from_millis(30)), true),
            Duration::from_millis(120)
        );
    }
}
