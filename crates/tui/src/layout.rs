//! Layout of a screen by its size.

use ratatui::layout::{Constraint, Layout, Margin, Rect};

/// From so many columns on there is a third column, for pictures.
const THREE_COLUMNS: u16 = 140;
/// From so many columns on inputs and results stand side by side.
const TWO_COLUMNS: u16 = 64;
/// From so many rows on there are frames, and a line of help.
const ROOMY: u16 = 12;
/// Rows of a plot that may stand beside others.
const ROOMY_PLOT: u16 = 18;
/// Rows below the tabs of problems and configurations at least.
const BELOW_PARTS: u16 = 3;
/// Columns of the narrowest column of inputs.
const FORM: u16 = 38;

/// The part of the screen that the keys act on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Focus {
    /// The inputs.
    #[default]
    Form,
    /// The panes.
    Pane,
}

/// The parts of the screen of a problem.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Areas {
    /// The line at the top.
    pub title: Rect,
    /// The tabs of problems and configurations; empty where there is one problem alone.
    pub parts: Rect,
    /// The inputs, where they are shown.
    pub form: Option<Rect>,
    /// Results, where they are shown.
    pub pane: Option<Rect>,
    /// Plot above drawing, where they have a column of their own.
    pub picture: Option<Rect>,
    /// The line about the field under the cursor; empty where there is no room.
    pub help: Rect,
    /// The line of keys.
    pub footer: Rect,
}

/// The parts of a screen: title, body, help, footer.
pub fn frame(area: Rect) -> [Rect; 4] {
    let roomy = u16::from(area.height >= ROOMY);
    let footer = u16::from(area.height >= 4);
    Layout::vertical([
        Constraint::Length(u16::from(area.height >= 2)),
        Constraint::Min(0),
        Constraint::Length(roomy),
        Constraint::Length(footer),
    ])
    .areas(area)
}

/// The parts of the screen of a problem, which may have several with tabs; what has the focus takes the whole of it where
/// it is `expanded`.
pub fn bench(area: Rect, focus: Focus, expanded: bool, has_parts: bool) -> Areas {
    let [title, body, help, footer] = frame(area);
    let rows = u16::from(has_parts && body.height > BELOW_PARTS);
    let [parts, body] = Layout::vertical([Constraint::Length(rows), Constraint::Min(0)]).areas(body);
    let areas = Areas { title, parts, form: None, pane: None, picture: None, help, footer };
    if body.width >= THREE_COLUMNS && !expanded {
        let form = (body.width * 5 / 16).clamp(44, 60);
        let [form, pane, picture] =
            Layout::horizontal([Constraint::Length(form), Constraint::Fill(1), Constraint::Fill(1)])
                .areas(body);
        return Areas { form: Some(form), pane: Some(pane), picture: Some(picture), ..areas };
    }
    if body.width >= TWO_COLUMNS && !expanded {
        let form = (body.width * 2 / 5).max(FORM.min(body.width / 2));
        let [form, pane] = Layout::horizontal([Constraint::Length(form), Constraint::Fill(1)]).areas(body);
        return Areas { form: Some(form), pane: Some(pane), ..areas };
    }
    match focus {
        Focus::Form => Areas { form: Some(body), ..areas },
        Focus::Pane => Areas { pane: Some(body), ..areas },
    }
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

/// Results above the worked solution, where both are shown.
pub fn stack(pane: Rect, lines_of_results: usize) -> [Rect; 2] {
    let wanted = u16::try_from(lines_of_results).unwrap_or(u16::MAX).saturating_add(2);
    let most = pane.height / 2;
    Layout::vertical([Constraint::Length(wanted.min(most)), Constraint::Fill(1)]).areas(pane)
}

/// The plot, below it the next of several where there is room, below both the drawing.
pub fn pictures(picture: Rect, plots: usize, has_drawing: bool) -> [Rect; 3] {
    let two = plots > 1 && picture.height >= (2 + u16::from(has_drawing)) * ROOMY_PLOT;
    let drawing = match (plots, has_drawing) {
        (0, true) => picture.height,
        (_, true) if two => picture.height / 3,
        (_, true) => picture.height * 2 / 5,
        (_, false) => 0,
    };
    let second = if two { (picture.height - drawing) / 2 } else { 0 };
    Layout::vertical([Constraint::Fill(1), Constraint::Length(second), Constraint::Length(drawing)])
        .areas(picture)
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
