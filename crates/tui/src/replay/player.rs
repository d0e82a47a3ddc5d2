//! Plays a session in the terminal, as fast as a user would.

use std::{
    collections::VecDeque,
    time::{Duration, Instant},
};

use ratatui::crossterm::event::{KeyCode, KeyEvent};

use super::{Act, Replay, key_to_tab};
use crate::{
    model::{Model, Msg},
    panes,
    problem::Freshness,
};

/// Between the characters of a text.
const CHARACTER: Duration = Duration::from_millis(70);
/// After a key that leads somewhere: time to see where.
const KEY: Duration = Duration::from_millis(350);
/// `wait solved` waits no longer.
const PATIENCE: Duration = Duration::from_secs(30);

/// A session on its way.
#[derive(Debug)]
pub(crate) struct Player {
    steps: VecDeque<Step>,
    speed: f64,
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
}

impl Player {
    /// Begins now; everything takes the `speed`-th part of its time.
    pub(crate) fn new(replay: Replay, speed: f64) -> Self {
        let steps = replay.acts.into_iter().flat_map(|(_, act)| match act {
            Act::Type(keys) => keys.into_iter().map(Step::Key).collect(),
            Act::Paste(text) => vec![Step::Paste(text)],
            Act::Tab(name) => vec![Step::Tab(name, panes::all().len() + 2)],
            Act::Wait(time) => vec![Step::Wait(time)],
            Act::UntilSolved => vec![Step::UntilSolved],
            // The window is the user's; a picture of it is hers as well, and what it shows she sees.
            Act::Resize(..) | Act::Picture(_) | Act::Expect(_) => Vec::new(),
        });
        Self { steps: steps.collect(), speed, due: Instant::now() + KEY, waiting: None }
    }

    /// Time of the next action; `None` at the end.
    pub(crate) fn due(&self) -> Option<Instant> {
        (!self.steps.is_empty() || self.waiting.is_some()).then_some(self.due)
    }

    /// The next thing, if it is due.
    pub(crate) fn next(&mut self, model: &Model) -> Option<Msg> {
        let now = Instant::now();
        if now < self.due {
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
        };
        self.due = now + pause.div_f64(self.speed);
        msg
    }
}
