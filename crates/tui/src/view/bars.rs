//! The lines at the edges: what is worked on, what the field means, what keys do.

use dalembert_core::{Exhibit, Text, check};
use dalembert_units::Unit;
use ratatui::{
    buffer::Buffer,
    layout::{Position, Rect},
    text::{Line, Span},
    widgets::{Clear, Widget},
};

use super::{
    animation,
    text::{fit, shortened, width, wrapped},
    word,
};
use crate::{
    bench::{Bench, CellOf, State},
    form::{self, Role},
    glyphs::filter_untrusted,
    keys::{Action, Bound, Place},
    look::Glyph,
    model::{Model, Notice},
    tab::Tab,
};

/// Lines of the longest notice.
const MOST_NOTICE: usize = 4;
/// Cells between two keys.
const GAP: usize = 2;

/// The name of the program, the analysis, the problem and its file.
pub(super) fn title(model: &Model, area: Rect, buffer: &mut Buffer) {
    let look = &model.look;
    let mut spans = vec![Span::styled(" dalembert", look.title())];
    let mut right = if model.readonly { word("read-only", model) } else { String::new() };
    if let Some(bench) = model.shown_bench() {
        let gap = format!(" {} ", look.glyph(Glyph::Closed));
        spans.push(Span::styled(gap.clone(), look.dim()));
        spans.push(Span::styled(Text::from(bench.entry.about.title).render(&model.locale), look.title()));
        let name = bench.name().render(&model.locale);
        if !name.is_empty() {
            spans.push(Span::styled(gap, look.dim()));
            spans.push(Span::raw(filter_untrusted(&name).into_owned()));
        }
        let file = file_name(model, bench);
        right += if right.is_empty() || file.is_empty() { "" } else { "  " };
        right += &file;
    }
    let room = usize::from(area.width);
    let right_room = width(&right).min(room / 2);
    let right = fit(&right, right_room, look);
    let left: String = spans.iter().map(|span| span.content.as_ref()).collect();
    let left_room = room.saturating_sub(right_room + 2);
    if width(&left) > left_room {
        spans = vec![Span::styled(fit(&left, left_room, look), look.title())];
    }
    buffer.set_line(area.x, area.y, &Line::from(spans), area.width);
    let style = if model.shown_bench().is_some_and(Bench::is_unsaved) { look.warning() } else { look.dim() };
    buffer.set_string(area.right().saturating_sub(width(&right) as u16 + 1), area.y, right, style);
}

/// What the field under the cursor means and how its text is read.
pub(super) fn help(model: &Model, area: Rect, buffer: &mut Buffer) {
    if area.is_empty() {
        return;
    }
    let look = &model.look;
    let text = match model.shown_bench() {
        Some(bench) => match bench.place() {
            place if place.is_pane() => about_pane(model, bench),
            Place::Cell => about_cell(model, bench),
            _ => about_field(model, bench),
        },
        None => String::new(),
    };
    let room = usize::from(area.width).saturating_sub(2);
    buffer.set_string(area.x + 1, area.y, fit(&text, room, look), look.dim());
}

/// A notice, or the most useful keys.
pub(super) fn footer(model: &Model, area: Rect, buffer: &mut Buffer) {
    if area.is_empty() {
        return;
    }
    let room = usize::from(area.width).saturating_sub(2);
    if let Some(notice) = &model.notice {
        draw_notice(model, notice, area, buffer);
        return;
    }
    let look = &model.look;
    let mut line = Line::default();
    for hint in hints(model, model.place(), room) {
        if !line.spans.is_empty() {
            line.push_span(Span::raw(" ".repeat(GAP)));
        }
        line.push_span(Span::styled(hint.keys, look.key()));
        line.push_span(Span::styled(format!(" {}", hint.name), look.dim()));
    }
    buffer.set_line(area.x + 1, area.y, &line, area.width.saturating_sub(1));
}

/// What the hint does that is drawn at a place of the footer.
pub(super) fn action_at(model: &Model, area: Rect, at: Position) -> Option<Action> {
    if model.notice.is_some() || !area.contains(at) {
        return None;
    }
    let mut offset = usize::from(at.x).checked_sub(usize::from(area.x) + 1)?;
    for hint in hints(model, model.place(), usize::from(area.width).saturating_sub(2)) {
        let cells = width(&hint.keys) + 1 + width(&hint.name);
        if offset < cells {
            // Of two keys side by side each does its own.
            let first = hint.keys.split(' ').next().map_or(0, width);
            return Some(match hint.pair {
                Some((one, _)) if offset < first => one,
                Some((_, other)) if offset > first && offset < width(&hint.keys) => other,
                _ => hint.action,
            });
        }
        offset = offset.checked_sub(cells + GAP)?;
    }
    None
}

/// A key of the footer.
struct Hint {
    action: Action,
    /// The actions of two keys side by side.
    pair: Option<(Action, Action)>,
    keys: String,
    name: String,
}

/// A message to the user, at the foot of the screen and as far up as it needs.
fn draw_notice(model: &Model, notice: &Notice, foot: Rect, buffer: &mut Buffer) {
    let look = &model.look;
    let style = if notice.wrong { look.error() } else { look.good() };
    let text = filter_untrusted(&notice.text.render(&model.locale)).into_owned();
    let room = usize::from(foot.width).saturating_sub(2);
    let mut lines = wrapped(&text, room);
    if !notice.detail.is_empty() {
        lines.extend(wrapped(&filter_untrusted(&notice.detail), room));
    }
    let most = usize::from(buffer.area.height / 2).clamp(1, MOST_NOTICE);
    let lines = shortened(lines, most, room, look);
    let rows = lines.len() as u16;
    let area = Rect { y: foot.bottom().saturating_sub(rows), height: rows, ..foot };
    Clear.render(area, buffer);
    for (y, line) in (area.y..area.bottom()).zip(lines) {
        buffer.set_string(area.x + 1, y, line, style);
    }
}

/// As many keys of a place as there is room for; the way on is always among them: the help, or that out of a dialog.
fn hints(model: &Model, place: Place, room: usize) -> Vec<Hint> {
    let written = |bound: &Bound| {
        let binding = bound.binding;
        let pair = pair(binding.action, place);
        let keys = match pair {
            Some((one, other)) => {
                let keys = [one, other].map(|action| model.key(place, action));
                keys.iter().filter(|key| !key.is_empty()).map(String::as_str).collect::<Vec<_>>().join(" ")
            }
            None => bound.keys.first().map_or_else(String::new, |key| key.name(&model.locale)),
        };
        Hint { action: binding.action, pair, keys, name: word(binding.hint, model) }
    };
    let cells = |hint: &Hint| width(&hint.keys) + 1 + width(&hint.name);
    let has_animation = animation(model).is_some();
    let in_tab = |tab: Tab| model.shown_bench().is_some_and(|bench| bench.tab == tab);
    let is_picture = in_tab(Tab::Plot) || in_tab(Tab::Drawing);
    let on_choice = model
        .shown_bench()
        .is_some_and(|bench| matches!(bench.cell(), Some(CellOf::Study(cell)) if cell.is_choice()));
    let serves = |bound: &&Bound| match bound.binding.action {
        Action::Play | Action::PreviousFrame => has_animation,
        Action::Toggle if place == Place::Cells => in_tab(Tab::Check),
        Action::Left if place == Place::Cells => !in_tab(Tab::Check),
        Action::Enter if place == Place::Cells => !on_choice,
        Action::Toggle if place == Place::Picker => model.chosen_exercise().is_some(),
        Action::ExportSeen => is_picture,
        Action::Copy | Action::Export => !is_picture,
        Action::Left if place == Place::Drawing => {
            let sketch = model.shown_bench().and_then(|bench| bench.sketch());
            matches!(sketch, Some(Exhibit::Scene(_)))
        }
        Action::Reveal => model.shown_bench().is_some_and(|bench| bench.reading.revealed.is_some()),
        Action::Enter if place == Place::Working => {
            model.shown_bench().is_some_and(|bench| bench.reading.symbol.is_some())
        }
        Action::PanLeft => model.shown_bench().is_some_and(|bench| bench.plot_state.view.window.is_some()),
        _ => true,
    };
    let has_hint = |bound: &&Bound| !bound.binding.hint.is_empty() && !bound.keys.is_empty();
    let mut all: Vec<&Bound> = Vec::new();
    for bound in model.keys.bindings(place).iter().filter(has_hint).filter(serves) {
        // A place's own key comes before one that it shares.
        if all.iter().all(|earlier| earlier.binding.action != bound.binding.action) {
            all.push(bound);
        }
    }
    let mut left = room + GAP;
    let has_help = all.iter().any(|bound| bound.binding.action == Action::Help);
    let always = if has_help { Action::Help } else { Action::Back };
    left -= all
        .iter()
        .filter(|bound| bound.binding.action == always)
        .map(|bound| cells(&written(bound)) + GAP)
        .sum::<usize>()
        .min(left);
    let mut shown = Vec::new();
    for bound in all {
        let hint = written(bound);
        if bound.binding.action != always {
            if cells(&hint) + GAP > left {
                continue;
            }
            left -= cells(&hint) + GAP;
        }
        shown.push(hint);
    }
    shown
}

/// The two actions whose keys a hint shows side by side.
fn pair(action: Action, place: Place) -> Option<(Action, Action)> {
    Some(match action {
        Action::Nudge(tenths) => (action, Action::Nudge(-tenths)),
        Action::ZoomIn => (action, Action::ZoomOut),
        Action::PanLeft => (action, Action::PanRight),
        Action::NextTab => (Action::PreviousTab, action),
        Action::PreviousFrame => (action, Action::NextFrame),
        Action::Right if place == Place::Working => (Action::Left, action),
        Action::Left if matches!(place, Place::Cells | Place::Drawing) => (action, Action::Right),
        _ => return None,
    })
}

fn about_field(model: &Model, bench: &Bench) -> String {
    let Some(line) = bench.form.line() else { return String::new() };
    let say = |text: &'static str| Text::from(text).render(&model.locale);
    let key = |action| model.key(Place::Form, action);
    let mut parts = Vec::new();
    let label = say(line.field.label);
    match &line.role {
        Role::Choice { variants, chosen } => match chosen.and_then(|at| variants.get(at)) {
            Some(variant) => parts.extend([format!("{label}: {}", say(variant.label)), say(variant.help)]),
            None => {
                let choose = Text::new("{key} opens the options").with("key", key(Action::Enter));
                parts.extend([label, choose.render(&model.locale)]);
            }
        },
        Role::Rows { .. } => {
            let add = Text::new("{key} adds a row").with("key", key(Action::AddRow)).render(&model.locale);
            parts.extend([label, say(line.field.help), add]);
        }
        Role::Group { .. } if line.number.is_some() => {
            let keys =
                Text::new("{add} add, {copy} duplicate, {delete} delete, {down} {up} move, {fold} collapse")
                    .with("add", key(Action::AddRow))
                    .with("copy", key(Action::DuplicateRow))
                    .with("delete", key(Action::DeleteRow))
                    .with("down", key(Action::MoveRowDown))
                    .with("up", key(Action::MoveRowUp))
                    .with("fold", key(Action::FoldRow));
            parts.extend([label, keys.render(&model.locale)]);
        }
        Role::Table { .. } => {
            // What is meant by it stands in full over the table when it is edited.
            parts.extend([
                label,
                Text::new("{key} edits, paste replaces, {import} imports a file")
                    .with("key", key(Action::Enter))
                    .with("import", key(Action::Import))
                    .render(&model.locale),
                say(line.field.help),
            ]);
        }
        Role::Absent => parts.extend([
            label,
            say(line.field.help),
            Text::new("{key} includes it").with("key", key(Action::Toggle)).render(&model.locale),
        ]),
        Role::Group { .. } => parts.extend([label, say(line.field.help)]),
        Role::Leaf { shape, text } => {
            let echo = form::echo(text, shape, model.locale.style);
            let edited = bench.form.edit.as_ref().map(|edit| edit.input.value());
            let thousands = form::point_of_thousands(edited.unwrap_or(text), model.locale.style);
            // A number that is typed alone has a unit in the draft that is not on the screen.
            let typed = edited.is_some_and(|edited| edited != text);
            parts.extend(match thousands {
                Some(number) => Some(
                    Text::new(
                        "{number} has a decimal mark and is read as {echo}; write thousands without one",
                    )
                    .with("number", number)
                    .with("echo", echo.as_ref().unwrap_or(text))
                    .render(&model.locale),
                ),
                None => if typed { Some(text) } else { echo.as_ref() }.map(|read| format!("= {read}")),
            });
            parts.extend(bench.form.unit_of_number(&line).and_then(|unit| number_alone(model, &unit)));
            parts.push(label);
            parts.push(say(line.field.help));
        }
    }
    parts.retain(|part| !part.is_empty());
    parts.join(&format!(" {} ", model.look.glyph(Glyph::Dot)))
}

/// In which unit a number is taken that is typed without one. It comes first: the end of a line may be cut.
fn number_alone(model: &Model, unit: &Unit) -> Option<String> {
    let unit = unit.shown(model.look.ascii);
    let said = Text::new("default unit {unit}").with("unit", &unit);
    (!unit.is_empty()).then(|| said.render(&model.locale))
}

/// What is to be typed in the cell of a tab.
fn about_cell(model: &Model, bench: &Bench) -> String {
    let (Some(solution), Some(cell)) = (&bench.found.solution, bench.cell()) else { return String::new() };
    let (form, what) = match &cell {
        CellOf::Answer(name) => {
            let Some(answer) = solution.answer(name) else { return String::new() };
            let form = match answer.si() {
                Some(_) => number_alone(model, &answer.unit),
                None => {
                    let said =
                        Text::new("write it as in `{example}`").with("example", check::example(answer));
                    Some(said.render(&model.locale))
                }
            };
            (form, answer.title())
        }
        CellOf::Tolerance(path) => {
            let sorted = bench.ask.sensitivity.sorted();
            let Some(one) = sorted.iter().find(|one| one.input.path == *path) else { return String::new() };
            let form = Text::new("tolerance of an input, such as 2 %").render(&model.locale);
            (Some(form), one.input.label.clone())
        }
        CellOf::Study(cell) => {
            let unit = bench.subject().and_then(|subject| bench.ask.study.unit(*cell, &subject));
            let form = match unit {
                Some(unit) => number_alone(model, &unit),
                None => Some(Text::new("a whole number").render(&model.locale)),
            };
            (form, cell.name())
        }
    };
    let parts: Vec<String> = form.into_iter().chain([what.render(&model.locale)]).collect();
    parts.join(&format!(" {} ", model.look.glyph(Glyph::Dot)))
}

fn about_pane(model: &Model, bench: &Bench) -> String {
    let several = bench.exhibits_of(bench.tab) > 1;
    let key = |action| model.key(bench.place(), action);
    let pair = |one, other| format!("{} {}", key(one), key(other));
    let cursor = || Text::new("{keys} move the cursor").with("keys", pair(Action::Left, Action::Right));
    let display =
        |text: Text| text.with("unit", key(Action::NextDisplayUnit)).with("digits", key(Action::NextDigits));
    let marks = || Text::new("{key} other markers").with("key", key(Action::NextMarker));
    let next = |text: Text| text.with("key", key(Action::NextExhibit));
    let hints: Vec<Text> = match bench.tab {
        Tab::Plot if bench.plot_state.view.window.is_some() => {
            vec![Text::new("{key} shows the full range").with("key", key(Action::ZoomAll)), cursor()]
        }
        Tab::Plot if several => vec![cursor(), marks(), next(Text::new("{key} next plot"))],
        Tab::Plot => vec![cursor(), marks()],
        Tab::Drawing if several => vec![next(Text::new("{key} next drawing"))],
        Tab::Sources => {
            vec![
                Text::new("{keys} choose a case; {enter} loads it")
                    .with("keys", pair(Action::Up, Action::Down))
                    .with("enter", key(Action::Enter)),
            ]
        }
        Tab::Check => vec!["value with unit, e.g. 19.5 mm; checked as you type".into()],
        Tab::Sensitivity => {
            vec![
                Text::new("{keys} another answer; type a tolerance of the input, such as 2 %")
                    .with("keys", pair(Action::Left, Action::Right)),
            ]
        }
        Tab::Study => vec!["also shown in Plot, with cursor and zoom".into()],
        Tab::Results if bench.reading.answer.is_some() => {
            vec![
                display(Text::new("{keys} select the answer; {unit} unit, {digits} digits"))
                    .with("keys", pair(Action::Up, Action::Down)),
            ]
        }
        Tab::Results => vec![display(Text::new("{unit} unit of an answer, {digits} digits"))],
        Tab::Working | Tab::Drawing | Tab::Table => Vec::new(),
    };
    hints.iter().map(|hint| hint.render(&model.locale)).collect::<Vec<_>>().join("; ")
}

fn file_name(model: &Model, bench: &Bench) -> String {
    let name = match &bench.file {
        Some(file) => {
            let name = file.path.file_name().unwrap_or(file.path.as_os_str());
            filter_untrusted(&name.to_string_lossy()).replace('\n', "\u{FFFD}")
        }
        None if bench.is_unsaved() => word("not saved", model),
        None => String::new(),
    };
    let solving = match bench.found.state {
        _ if bench.is_working() => format!("{}  ", word("solving; Esc cancels", model)),
        State::Stopped => format!("{}  ", word("cancelled", model)),
        _ => String::new(),
    };
    let all = model.problems();
    let place = all.iter().position(|other| other.number == bench.number).map_or(0, |at| at + 1);
    let place = if all.len() > 1 { format!("{place}/{}  ", all.len()) } else { String::new() };
    let dot = if bench.is_unsaved() { format!("{} ", model.look.glyph(Glyph::Full)) } else { String::new() };
    format!("{solving}{place}{dot}{name}")
}
