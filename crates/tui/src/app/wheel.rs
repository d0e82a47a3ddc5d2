//! Turns of the wheel that waited together.

use crossterm::event::MouseEventKind;

use crate::terminal::TerminalInput;

/// Of the equal turns of the wheel that waited together no more than move a screenful: nobody counts the others, and
/// the next key does not wait for them.
pub(super) fn limit_wheel(mut inputs: Vec<TerminalInput>) -> Vec<TerminalInput> {
    const TURNS: usize = 10;
    let mut turns = 0;
    let mut last = None;
    inputs.retain(|input| {
        let turned = match input {
            TerminalInput::Mouse(event)
                if matches!(event.kind, MouseEventKind::ScrollUp | MouseEventKind::ScrollDown) =>
            {
                Some(*event)
            }
            _ => None,
        };
        turns = if turned.is_some() && turned == last { turns + 1 } else { 1 };
        last = turned;
        turns <= TURNS
    });
    inputs
}
