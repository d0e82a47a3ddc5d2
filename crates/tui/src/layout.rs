//! Layout of a screen by its size.

use ratatui::layout::{Constraint, Layout, Margin, Rect};

/// From so many columns on the list of analyses has something beside it.
const TWO_COLUMNS: u16 = 64;
/// From so many rows on there are frames, and a line of help.
const ROOMY: u16 = 12;
/// Rows below the tabs of problems and configurations at least.
const BELOW_PARTS: u16 = 3;

/// The part of the screen that the keys act on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Focus {
    /// The inputs.
    #[default]
    Form,
    /// The panes.
    Pane,
}

/// Returns true if a screen has a line of help above the footer.
pub fn has_help(area: Rect) -> bool {
    area.height >= ROOMY
}

/// The parts of a screen: title, body, help, footer.
pub fn frame(area: Rect) -> [Rect; 4] {
    let roomy = u16::from(has_help(area));
    let footer = u16::from(area.height >= 4);
    Layout::vertical([
        Constraint::Length(u16::from(area.height >= 2)),
        Constraint::Min(0),
        Constraint::Length(roomy),
        Constraint::Length(footer),
    ])
    .areas(area)
}

/// The parts of the screen of a problem: title, the tabs of its parts where it `has_parts`, body, help, footer.
pub fn bench(area: Rect, has_parts: bool) -> [Rect; 5] {
    let [title, body, help, footer] = frame(area);
    let rows = u16::from(has_parts && body.height > BELOW_PARTS);
    let [parts, body] = Layout::vertical([Constraint::Length(rows), Constraint::Min(0)]).areas(body);
    [title, parts, body, help, footer]
}

/// The list of analyses and what is shown of the chosen one, which may have no room.
pub fn picker(body: Rect) -> (Rect, Option<Rect>) {
    if body.width >= TWO_COLUMNS {
        let list = (body.width * 9 / 20).clamp(30, 52);
        let [list, preview] = Layout::horizontal([Constraint::Length(list), Constraint::Fill(1)]).areas(body);
        (list, Some(preview))
    } else if body.height >= 20 {
        let [list, preview] = Layout::vertical([Constraint::Fill(1), Constraint::Fill(1)]).areas(body);
        (list, Some(preview))
    } else {
        (body, None)
    }
}

/// Returns true if there is room for a frame.
pub fn framed(area: Rect) -> bool {
    area.height >= 3 && area.width >= 16
}

/// Area inside the frame of an area.
pub fn inside(area: Rect) -> Rect {
    if framed(area) {
        area.inner(Margin::new(2, 1))
    } else {
        Rect { height: area.height.saturating_sub(1), y: area.y + u16::from(area.height > 0), ..area }
    }
}
