//! The plots, one at a time, with a cursor and zoom.

use dalembert_core::{Exhibit, Locale, Plot as Curves, Text};
use dalembert_report::{
    figure::{self, Seen, axes::PlotWindow},
    plot_csv,
};
use ratatui::{
    buffer::Buffer,
    crossterm::event::KeyCode,
    layout::{Position, Rect},
};

use super::reasons;
use crate::{
    intent::Intent,
    keys::{
        Action, KeyContext, PaneKeys,
        tables::{FIRST, LAST, LEFT, PAGE_DOWN_OR_SPACE, PAGE_UP, RIGHT, bind, shift, typed},
        turned,
    },
    pane::{Content, Gesture, Pane, Ui, register_pane},
    pixels::Picture,
    plot::{self, PlotState},
    problem::Problem,
};

/// Keys of the pane.
static KEYS: PaneKeys = PaneKeys {
    id: "plot",
    name: "Plot",
    table: &[&[
        bind(Action::Left, LEFT, "move the plot cursor left", ""),
        bind(Action::Right, RIGHT, "move the plot cursor right", ""),
        bind(Action::PageUp, PAGE_UP, "move the plot cursor far left", ""),
        bind(Action::PageDown, PAGE_DOWN_OR_SPACE, "move the plot cursor far right", ""),
        bind(Action::First, FIRST, "move the plot cursor to the start", ""),
        bind(Action::Last, LAST, "move the plot cursor to the end", ""),
        bind(Action::ZoomIn, &[typed('+'), typed('=')], "zoom in", "zoom"),
        bind(Action::ZoomOut, &[typed('-')], "zoom out", ""),
        bind(Action::ZoomAll, &[typed('0')], "full range", ""),
        bind(Action::PanLeft, &[typed('<'), shift(KeyCode::Left)], "pan left", "move"),
        bind(Action::PanRight, &[typed('>'), shift(KeyCode::Right)], "pan right", ""),
        bind(Action::NextSpread, &[typed('a')], "vertical axis: linear, logarithmic, dB", "log dB"),
        bind(Action::NextSpreadAcross, &[typed('x')], "horizontal axis: linear or logarithmic", ""),
        bind(Action::NextExhibit, &[typed('n')], "next plot or drawing", ""),
        bind(Action::NextMarker, &[typed('m')], "change curve markers", ""),
    ]],
};

/// The share of an axis that a key moves the cursor by.
const CURSOR_STEP: f64 = 0.01;
/// A share of an axis beyond any of its ends.
const FAR: f64 = 1e6;
/// The message about a key that would show more.
const ALL_SHOWN: &str = "full range is shown";
/// So much of the axis is shown after a zoom in.
const ZOOM: f64 = 0.5;
/// The share of the axis that is left after a notch of the wheel.
const NOTCH: f64 = 0.8;
/// The share of what is shown that a key moves it by.
const PAN: f64 = 0.25;

/// The pane of plots.
#[derive(Debug, Default)]
pub struct Plot {
    /// The plot that is shown, of several.
    at: usize,
    /// The cursor, and the part of the axis that is shown.
    state: PlotState,
}

register_pane!(Plot, 30);

impl Pane for Plot {
    fn name(&self) -> &'static str {
        "Plot"
    }

    fn place(&self) -> KeyContext {
        KeyContext::Own(&KEYS)
    }

    fn content(&self) -> Content {
        Content::Picture
    }

    fn is_useful(&self, problem: &Problem) -> bool {
        problem.plots().next().is_some()
    }

    fn draw(&self, problem: &Problem, ui: &Ui<'_>, room: Rect, buffer: &mut Buffer) -> Vec<Picture> {
        if ui.covered {
            reasons::hidden(problem, ui, room.width).draw(0, room, buffer);
            return Vec::new();
        }
        let Some((plot, pinned)) = problem.plot_at(self.at) else {
            reasons::draw_nothing(problem, ui, room, buffer);
            return Vec::new();
        };
        let room = reasons::draw_stale(problem, ui, room, buffer);
        let pictures = plot::render(plot, pinned, &self.marked(ui), ui.look, ui.locale, room, buffer);
        reasons::dim_stale(problem, ui, room, pictures, buffer)
    }

    /// Draws the plot after the one that is shown, as it is: keys act on the other one.
    fn draw_next(&self, problem: &Problem, ui: &Ui<'_>, room: Rect, buffer: &mut Buffer) -> Vec<Picture> {
        if ui.covered {
            reasons::hidden(problem, ui, room.width).draw(0, room, buffer);
            return Vec::new();
        }
        let next = turned(self.at, 1, self.pictures(problem));
        let Some((plot, pinned)) = problem.plot_at(next) else { return Vec::new() };
        let state = PlotState { marker: ui.marker, ..PlotState::default() };
        let pictures = plot::render(plot, pinned, &state, ui.look, ui.locale, room, buffer);
        reasons::dim_stale(problem, ui, room, pictures, buffer)
    }

    fn about(&self, problem: &Problem, ui: &Ui<'_>) -> Vec<Text> {
        let key = |action| ui.key(self.place(), action);
        let keys = ui.pair(self.place(), Action::Left, Action::Right);
        let cursor = Text::new("{keys} move the cursor").with("keys", keys);
        if self.state.view.window.is_some() {
            return vec![Text::new("{key} shows the full range").with("key", key(Action::ZoomAll)), cursor];
        }
        let marks = Text::new("{key} other markers").with("key", key(Action::NextMarker));
        let next = (self.pictures(problem) > 1)
            .then(|| Text::new("{key} next plot").with("key", key(Action::NextExhibit)));
        [cursor, marks].into_iter().chain(next).collect()
    }

    fn serves(&self, _: &Problem, action: Action) -> bool {
        action != Action::PanLeft || self.state.view.window.is_some()
    }

    fn act(&mut self, problem: &mut Problem, ui: &Ui<'_>, action: Action) -> Option<Vec<Intent>> {
        let plots = self.pictures(problem);
        let share = match action {
            Action::Left => -CURSOR_STEP,
            Action::Right => CURSOR_STEP,
            Action::PageUp => -10.0 * CURSOR_STEP,
            Action::PageDown => 10.0 * CURSOR_STEP,
            Action::First => -FAR,
            Action::Last => FAR,
            Action::ZoomIn
            | Action::ZoomOut
            | Action::ZoomAll
            | Action::PanLeft
            | Action::PanRight
            | Action::NextSpread
            | Action::NextSpreadAcross => return Some(self.look_otherwise(problem, action)),
            Action::NextMarker if ui.look.ascii => {
                let said = "in ASCII mode each curve has its own character; there are no other markers";
                return Some(Intent::say(said));
            }
            Action::NextMarker => return Some(vec![Intent::Mark(self.marked(ui).next_marker().marker)]),
            Action::NextExhibit if plots < 2 => return Some(Intent::say("no other plot")),
            Action::NextExhibit => {
                self.at = turned(self.at, 1, plots);
                // Another plot has another axis.
                self.state.view = PlotWindow::default();
                return Some(Vec::new());
            }
            Action::Back if self.state.cursor.is_some() => {
                self.state = self.state.without_cursor();
                return Some(Vec::new());
            }
            _ => return None,
        };
        if let Some((plot, _)) = problem.plot_at(self.at) {
            self.state = self.state.moved(plot, share);
        }
        Some(Vec::new())
    }

    fn copied(&self, problem: &Problem, ui: &Ui<'_>) -> String {
        let seen = problem.plot_at(self.at).filter(|_| !ui.covered);
        seen.and_then(|(plot, _)| plot::readout(plot, &self.state, ui.locale)).unwrap_or_default()
    }

    /// The curves are read under the pointer; a click sets the cursor, a drag moves it or, where part of the axis is
    /// shown, that part, and the wheel zooms about the pointer.
    fn mouse(&mut self, problem: &Problem, ui: &Ui<'_>, gesture: Gesture, at: Position) -> bool {
        let Some((plot, _)) = problem.plot_at(self.at) else { return false };
        let state = self.state;
        if gesture == Gesture::Leave {
            self.state = state.with_pointer(plot, None);
            return true;
        }
        let place = plot::place_at(plot, &state, ui.look, ui.locale, ui.area, at.x);
        let Some((place, cells)) = place else { return false };
        self.state = match gesture {
            Gesture::Drag(held) if state.view.window.is_some() => {
                state.panned(plot, (f64::from(held) - f64::from(at.x)) / f64::from(cells))
            }
            Gesture::Hover | Gesture::Leave => state.with_pointer(plot, Some(place)),
            Gesture::Press | Gesture::Drag(_) => state.with_cursor(plot, place),
            Gesture::WheelUp => state.zoomed_at(plot, place, NOTCH),
            Gesture::WheelDown => state.zoomed_at(plot, place, 1.0 / NOTCH),
        };
        gesture != Gesture::Hover || self.state.pointer.is_some()
    }

    fn pictures(&self, problem: &Problem) -> usize {
        problem.plots().count()
    }

    fn turn_to(&mut self, problem: &Problem, name: &str) {
        if let Some(at) = problem.first_of(name, |exhibit| matches!(exhibit, Exhibit::Plot(_))) {
            self.at = at;
            self.state.view = PlotWindow::default();
        }
    }

    fn shown(&self) -> usize {
        self.at
    }

    fn file_names(&self) -> (&'static str, &'static str) {
        ("plot", "enter a name ending in .svg or .csv")
    }

    fn hindrance(&self, problem: &Problem) -> Option<Text> {
        let covered = "covered until every step of the working is revealed; t ends that";
        problem.found.revealed.map(|_| covered.into())
    }

    fn file(&self, problem: &Problem, ending: &str, locale: &Locale) -> Option<String> {
        let (plot, pinned) = problem.plot_at(self.at)?;
        let seen = Seen { view: self.state.view, cursor: self.state.cursor, pinned };
        match ending {
            "csv" => plot_csv(plot, &seen, locale),
            "svg" => figure::plot(plot, &seen, locale).map(|picture| picture.svg()),
            _ => None,
        }
    }
}

impl Plot {
    /// The cursor, and the part of the axis that is shown.
    pub fn state(&self) -> PlotState {
        self.state
    }

    fn marked(&self, ui: &Ui<'_>) -> PlotState {
        PlotState { marker: ui.marker, ..self.state }
    }

    /// Another part of the plot, or its values spread in another way; what cannot be done is said.
    fn look_otherwise(&mut self, problem: &Problem, action: Action) -> Vec<Intent> {
        let state = self.state;
        let Some((plot, _)): Option<(&Curves, _)> = problem.plot_at(self.at) else { return Vec::new() };
        let (to, otherwise) = match action {
            Action::ZoomIn => (state.zoomed(plot, ZOOM), "already at the limit of the zoom"),
            Action::ZoomOut => (state.zoomed(plot, 1.0 / ZOOM), ALL_SHOWN),
            Action::ZoomAll => (state.windowed(None), ALL_SHOWN),
            Action::PanLeft if state.view.window.is_some() => {
                (state.panned(plot, -PAN), "start of the range")
            }
            Action::PanRight if state.view.window.is_some() => (state.panned(plot, PAN), "end of the range"),
            Action::NextSpread | Action::NextSpreadAcross => {
                let next = match action {
                    Action::NextSpread => state.next_spread(plot),
                    _ => state.next_spread_across(plot),
                };
                next.map_or_else(|why| (state, why), |to| (to, ""))
            }
            _ => (state, ALL_SHOWN),
        };
        self.state = to;
        if to == state { Intent::say(otherwise) } else { Vec::new() }
    }
}
