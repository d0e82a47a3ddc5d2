//! Turns of the wheel and movements of the mouse that waited together.

use crossterm::event::MouseEventKind;

use crate::terminal::TerminalInput;

/// Of the equal turns of the wheel that waited together no more than move a screenful, and of movements that follow one
/// another the last: nobody counts the others, and the next key does not wait for them.
pub(super) fn limit_wheel(mut inputs: Vec<TerminalInput>) -> Vec<TerminalInput> {
    inputs.dedup_by(|next, before| {
        let both = is_moved(next) && is_moved(before);
        if both {
            std::mem::swap(next, before);
        }
        both
    });
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

/// Returns true for a movement of the mouse without a button.
pub(super) fn is_moved(input: &TerminalInput) -> bool {
    matches!(input, TerminalInput::Mouse(event) if event.kind == MouseEventKind::Moved)
}
