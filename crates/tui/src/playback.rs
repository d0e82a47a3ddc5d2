//! State of a session that is played.

/// State of a session that is played, as the line below the screen shows it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Playback {
    /// Everything takes the so-manieth part of its time.
    pub speed: f64,
    /// True while it stands.
    pub paused: bool,
    /// True for the tour: any key is the user's, and acts.
    pub is_tour: bool,
}
