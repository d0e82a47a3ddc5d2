//! Plays a session in the terminal, as fast as a user would.

use std::{
    collections::VecDeque,
    time::{Duration, Instant},
};

use dalembert_core::Text;
use ratatui::crossterm::event::{KeyCode, KeyEvent};

use super::{Act, Replay, key_to_tab};
use crate::{
    model::{Model, Msg},
    panes,
    playback::Playback,
    problem::Freshness,
};

/// Between the characters of a text.
const CHARACTER: Duration = Duration::from_millis(70);
/// After a key that leads somewhere: time to see where.
const KEY: Duration = Duration::from_millis(350);
/// `wait solved` waits no longer.
const PATIENCE: Duration = Duration::from_secs(30);
/// A session that is paused looks again after so long, which a key does before.
const STANDING: Duration = Duration::from_hours(1);
/// A key of the speed makes it so many times as large or small, within these limits.
const FASTER: f64 = 1.5;
const SPEEDS: (f64, f64) = (0.01, 100.0);

/// A session on its way.
#[derive(Debug)]
pub(crate) struct Player {
    steps: VecDeque<Step>,
    playback: Playback,
    due: Instant,
    /// Since when everything is to be solved first.
    waiting: Option<Instant>,
}

#[derive(Debug)]
enum Step {
    Key(KeyEvent),
    Paste(String),
    /// The keys to the pane of a name, so many at most.
    Tab(String, usize),
    Wait(Duration),
    UntilSolved,
    Pause,
    Caption(Text),
}

impl Player {
    /// Begins now; everything takes the `speed`-th part of its time.
    pub(crate) fn new(replay: Replay, speed: f64, is_tour: bool) -> Self {
        let steps = replay.acts.into_iter().flat_map(|(_, act)| match act {
            Act::Type(keys) => keys.into_iter().map(Step::Key).collect(),
            Act::Paste(text) => vec![Step::Paste(text)],
            Act::Tab(name) => vec![Step::Tab(name, panes::all().len() + 2)],
            Act::Wait(time) => vec![Step::Wait(time)],
            Act::UntilSolved => vec![Step::UntilSolved],
            Act::Pause => vec![Step::Pause],
            Act::Caption(text) => vec![Step::Caption(text)],
            // The window is the user's; a picture of it is hers as well, and what it shows she sees.
            Act::Resize(..) | Act::Picture(_) | Act::Expect(_) => Vec::new(),
        });
        let playback = Playback { speed, paused: false, is_tour };
        Self { steps: steps.collect(), playback, due: Instant::now() + KEY, waiting: None }
    }

    /// State to be shown.
    pub(crate) fn playback(&self) -> Playback {
        self.playback
    }

    /// Time of the next action; `None` at the end.
    pub(crate) fn due(&self) -> Option<Instant> {
        if self.playback.paused {
            return Some(Instant::now() + STANDING);
        }
        (!self.steps.is_empty() || self.waiting.is_some()).then_some(self.due)
    }

    /// Takes a key that steers: Space stops and goes on, as do Enter, → and Page Down where it stands, `+` and `-` change the
    /// speed. False for any other key, and for every key of a tour.
    pub(crate) fn takes(&mut self, key: KeyEvent) -> bool {
        let Playback { speed, paused, is_tour } = &mut self.playback;
        match key.code {
            _ if *is_tour => return false,
            KeyCode::Char(' ') => *paused = !*paused,
            KeyCode::Enter | KeyCode::Right | KeyCode::PageDown if *paused => *paused = false,
            KeyCode::Char('+' | '=') => *speed = (*speed * FASTER).min(SPEEDS.1),
            KeyCode::Char('-') => *speed = (*speed / FASTER).max(SPEEDS.0),
            _ => return false,
        }
        true
    }

    /// The next thing, if it is due; a caption and a pause change the screen alone.
    pub(crate) fn next(&mut self, model: &mut Model) -> Option<Msg> {
        let now = Instant::now();
        if self.playback.paused || now < self.due {
            return None;
        }
        if let Some(since) = self.waiting {
            let solving = model
                .bench
                .as_ref()
                .is_some_and(|bench| matches!(bench.problem.found.state, Freshness::Solving(_)));
            if solving && since.elapsed() < PATIENCE {
                self.due = now + CHARACTER;
                return None;
            }
            self.waiting = None;
        }
        let (msg, pause) = match self.steps.pop_front()? {
            Step::Key(key) => {
                let pause = if matches!(key.code, KeyCode::Char(_)) { CHARACTER } else { KEY };
                (Some(Msg::Key(key)), pause)
            }
            Step::Paste(text) => (Some(Msg::Paste(text)), KEY),
            Step::Tab(name, most) => match key_to_tab(model, &name).filter(|_| most > 0) {
                Some(key) => {
                    self.steps.push_front(Step::Tab(name, most - 1));
                    (Some(Msg::Key(key)), CHARACTER)
                }
                None => (None, KEY),
            },
            Step::Wait(time) => (None, time),
            Step::UntilSolved => {
                self.waiting = Some(now);
                (None, Duration::ZERO)
            }
            Step::Pause => {
                self.playback.paused = true;
                (None, Duration::ZERO)
            }
            Step::Caption(text) => {
                model.caption = Some(text).filter(|text| !text.is_empty());
                (None, Duration::ZERO)
            }
        };
        self.due = now + pause.div_f64(self.playback.speed);
        msg
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::keys::notation::keys_of;

    fn player(session: &str, is_tour: bool) -> Player {
        Player::new(Replay::read(session).expect("a session"), 100.0, is_tour)
    }

    fn key(name: &str) -> KeyEvent {
        keys_of(name).expect("a key")[0]
    }

    /// Everything that is due within a second, with the captions.
    fn played(player: &mut Player, model: &mut Model) -> String {
        let (mut done, start) = (String::new(), Instant::now());
        while start.elapsed() < Duration::from_secs(1) {
            let caption = model.caption.clone();
            if let Some(Msg::Key(key)) = player.next(model) {
                done += &crate::keys::notation::written(key);
            }
            if model.caption != caption {
                done += &format!("({})", model.caption.as_ref().map_or_else(String::new, Text::english));
            }
            std::thread::sleep(Duration::from_micros(200));
        }
        done
    }

    fn model() -> Model {
        let look = crate::look::Appearance::default();
        Model::new(&[], dalembert_core::Language::English, look, crate::plot::Marker::Braille)
    }

    #[test]
    fn a_session_stands_at_its_pauses_until_a_key_lets_it_go_on() {
        let mut model = model();
        let mut player = player("type a\ncaption The peak.\npause\ncaption\ntype b\n", false);
        assert_eq!(played(&mut player, &mut model), "a(The peak.)");
        assert!(player.playback().paused && player.due().is_some());
        assert!(player.takes(key("<pgdn>")));
        assert_eq!(played(&mut player, &mut model), "()b");
        assert_eq!(player.due(), None, "the end");
    }

    #[test]
    fn keys_steer_a_replay_and_none_a_tour() {
        let mut replay = player("type a\n", false);
        for (name, speed, paused) in
            [("+", 150.0_f64.min(100.0), false), ("-", 100.0 / 1.5, false), ("<space>", 100.0 / 1.5, true)]
        {
            assert!(replay.takes(key(name)), "{name}");
            assert!((replay.playback().speed - speed).abs() < 1e-9, "{name}: {:?}", replay.playback());
            assert_eq!(replay.playback().paused, paused, "{name}");
        }
        assert!(!replay.takes(key("x")), "any other key takes over");
        let mut tour = player("type a\n", true);
        assert!([" ", "+", "-", "x"].iter().all(|_| !tour.takes(key("<space>"))));
        assert!(!tour.takes(key("+")) && !tour.takes(key("x")));
    }
}
