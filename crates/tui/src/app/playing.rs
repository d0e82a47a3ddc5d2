//! A session that is played in the run loop, until it ends or a key takes over.

use super::Runtime;
use crate::{
    dialog::After,
    model::{Model, Msg},
    terminal::TerminalInput,
};

/// Notice at the end of a replay, and of the tour.
const ENDED: &str = "replay ended: the keyboard is active again; the replay is read-only";
const TOURED: &str = "end of the tour: the keyboard is yours";

impl Runtime {
    /// The next thing that the session does, and whether the screen changes otherwise. A key that does not steer takes
    /// over, and does no more; in a tour it acts.
    pub(super) fn play(&mut self, model: &mut Model, inputs: &mut Vec<TerminalInput>) -> (Option<Msg>, bool) {
        let Some(player) = &mut self.player else { return (None, false) };
        let is_tour = player.playback().is_tour;
        let mut stopped = false;
        inputs.retain(|input| match input {
            TerminalInput::Key(key) if !stopped && player.takes(*key) => false,
            TerminalInput::Key(_) | TerminalInput::Paste(_) => {
                stopped = true;
                is_tour
            }
            _ => true,
        });
        if stopped || player.due().is_none() {
            self.hand_over(model, stopped);
            return (None, true);
        }
        let before = (model.playback, model.caption.clone());
        let msg = player.next(model);
        model.playback = Some(player.playback());
        (msg, before != (model.playback, model.caption.clone()))
    }

    /// The keys are the user's from now on: after a tour so is what it has left.
    pub(super) fn hand_over(&mut self, model: &mut Model, stopped: bool) {
        let is_tour = self.player.take().is_some_and(|player| player.playback().is_tour);
        (model.is_replay, model.after_save) = (false, After::Stay);
        (model.playback, model.caption) = (None, None);
        if is_tour {
            model.readonly = false;
            for bench in model.bench.iter_mut().chain(&mut model.others) {
                bench.problem.mark_saved();
            }
        }
        model.say(match (is_tour, stopped) {
            (true, _) => TOURED,
            (false, true) => "replay stopped: the keyboard is active again; the replay is read-only",
            (false, false) => ENDED,
        });
    }
}
