//! The lines at the edges: what is worked on, what the field means, what keys do.

use dalembert_core::Text;
use ratatui::{
    buffer::Buffer,
    layout::{Position, Rect},
    text::{Line, Span},
    widgets::{Clear, Widget},
};

use super::{animation, form::computed, screen_of, word};
use crate::{
    bench::Bench,
    form::{self, PartRole, Role},
    glyphs::filter_untrusted,
    keys::{Action, Bound, KeyContext},
    layout,
    look::Glyph,
    model::{Model, Notice},
    pane::Content,
    panes::about_number,
    problem::Freshness,
    text::{fit, shortened, width, wrapped},
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
        let title = Text::from(bench.problem.entry().about.title).render(&model.locale);
        let name = bench.problem.name().render(&model.locale);
        spans.push(Span::styled(title.clone(), look.title()));
        // The only case of an exam problem has its title.
        if !name.is_empty() && name != title {
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
    let left_room = room.saturating_sub(right_room + 2);
    // Where there is no room for everything, the name of the program goes first, then that of the problem.
    let cells = |spans: &[Span<'_>]| spans.iter().map(Span::width).sum::<usize>();
    if cells(&spans) > left_room && spans.len() > 2 {
        spans.splice(..2, [Span::raw(" ")]);
    }
    if cells(&spans) > left_room && spans.len() > 2 {
        spans.truncate(2);
    }
    if cells(&spans) > left_room {
        let left: String = spans.iter().map(|span| span.content.as_ref()).collect();
        spans = vec![Span::styled(fit(&left, left_room, look), look.title())];
    }
    buffer.set_line(area.x, area.y, &Line::from(spans), area.width);
    let style = if model.shown_bench().is_some_and(|bench| bench.problem.is_unsaved()) {
        look.warning()
    } else {
        look.dim()
    };
    buffer.set_string(area.right().saturating_sub(width(&right) as u16 + 1), area.y, right, style);
}

/// Meaning of the field under the cursor, and the reading of its text.
pub(super) fn help(model: &Model, area: Rect, buffer: &mut Buffer) {
    if area.is_empty() {
        return;
    }
    let look = &model.look;
    let text = match model.shown_bench() {
        Some(bench) => match bench.place() {
            place if place.is_pane() => {
                let hints = bench.shown().about(&bench.problem, &model.ui(bench, bench.tab, Rect::ZERO));
                hints.iter().map(|hint| hint.render(&model.locale)).collect::<Vec<_>>().join("; ")
            }
            KeyContext::Cell => about_cell(model, bench),
            _ => about_field(model, bench),
        },
        None => String::new(),
    };
    let room = usize::from(area.width).saturating_sub(2);
    buffer.set_string(area.x + 1, area.y, fit(&text, room, look), look.dim());
}

/// The most useful keys, and a notice above them; on a low screen in place of them.
pub(super) fn footer(model: &Model, area: Rect, buffer: &mut Buffer) {
    footer_below(model, area, false, buffer);
}

/// The same below panes, one of which may have an animation.
pub(super) fn footer_below(model: &Model, area: Rect, has_animation: bool, buffer: &mut Buffer) {
    if area.is_empty() {
        return;
    }
    let room = usize::from(area.width).saturating_sub(2);
    if let Some(notice) = &model.notice {
        let covers_keys = covers_keys(model);
        let above = u16::from(!covers_keys);
        draw_notice(model, notice, Rect { y: area.y.saturating_sub(above), ..area }, buffer);
        if covers_keys {
            return;
        }
    }
    let look = &model.look;
    let mut line = Line::default();
    for hint in hints(model, model.place(), room, has_animation) {
        if !line.spans.is_empty() {
            line.push_span(Span::raw(" ".repeat(GAP)));
        }
        line.push_span(Span::styled(hint.keys, look.key()));
        line.push_span(Span::styled(format!(" {}", hint.name), look.dim()));
    }
    buffer.set_line(area.x + 1, area.y, &line, area.width.saturating_sub(1));
}

/// Returns true if a notice stands in place of the keys.
fn covers_keys(model: &Model) -> bool {
    model.notice.is_some() && !layout::has_help(screen_of(model))
}

/// Action of the hint at a place of the footer.
pub(super) fn action_at(model: &Model, area: Rect, at: Position) -> Option<Action> {
    if covers_keys(model) || !area.contains(at) {
        return None;
    }
    let mut offset = usize::from(at.x).checked_sub(usize::from(area.x) + 1)?;
    let room = usize::from(area.width).saturating_sub(2);
    for hint in hints(model, model.place(), room, animation(model).is_some()) {
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
fn hints(model: &Model, place: KeyContext, room: usize, has_animation: bool) -> Vec<Hint> {
    let written = |bound: &Bound| {
        let binding = bound.binding;
        let pair = pair(binding.action);
        let keys = match pair {
            Some((one, other)) => {
                let keys = [one, other].map(|action| model.key(place, action));
                keys.iter().filter(|key| !key.is_empty()).map(String::as_str).collect::<Vec<_>>().join(" ")
            }
            None => bound.keys.first().map_or_else(String::new, |key| key.name(&model.locale)),
        };
        let hint = match (place, binding.action) {
            (KeyContext::Form, Action::Back) => "list",
            _ => binding.hint,
        };
        Hint { action: binding.action, pair, keys, name: word(hint, model) }
    };
    let cells = |hint: &Hint| width(&hint.keys) + 1 + width(&hint.name);
    let shown = model.shown_bench();
    let in_picture = shown.is_some_and(|bench| bench.shown().content() == Content::Picture);
    let serves = |bound: &&Bound| match bound.binding.action {
        Action::Play | Action::PreviousFrame => has_animation,
        Action::ExportSeen => in_picture,
        Action::Copy | Action::Export => !in_picture,
        Action::Repair => shown.is_some_and(|bench| !bench.problem.repairs().is_empty()),
        Action::Statement => shown.is_some_and(|bench| bench.problem.statement().is_some()),
        Action::NextFilePart => shown.is_some_and(|bench| bench.problem.inputs.form.parts().len() > 1),
        Action::Toggle if place == KeyContext::Picker => model.chosen_exercise().is_some(),
        action if place.is_pane() => shown.is_none_or(|bench| bench.shown().serves(&bench.problem, action)),
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
    // The ways on and out are always seen, at the end.
    let is_way_out = |bound: &&Bound| match bound.binding.action {
        Action::Back | Action::Help | Action::Quit => true,
        Action::Enter => place.is_text(),
        _ => false,
    };
    let rank = |bound: &&Bound| match bound.binding.action {
        _ if is_way_out(bound) => 2,
        Action::Enter | Action::Repair | Action::NextPane | Action::NextTab => 0,
        _ => 1,
    };
    all.sort_by_key(rank);
    left -= all
        .iter()
        .filter(|bound| is_way_out(bound))
        .map(|bound| cells(&written(bound)) + GAP)
        .sum::<usize>()
        .min(left);
    let mut shown = Vec::new();
    for bound in all {
        let hint = written(bound);
        if !is_way_out(&bound) {
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
fn pair(action: Action) -> Option<(Action, Action)> {
    Some(match action {
        Action::Nudge(tenths) => (action, Action::Nudge(-tenths)),
        Action::ZoomIn => (action, Action::ZoomOut),
        Action::PanLeft => (action, Action::PanRight),
        Action::NextTab => (Action::PreviousTab, action),
        Action::NextFilePart => (Action::PreviousFilePart, action),
        Action::PreviousFrame => (action, Action::NextFrame),
        Action::Right => (Action::Left, action),
        Action::Left => (action, Action::Right),
        _ => return None,
    })
}

fn about_field(model: &Model, bench: &Bench) -> String {
    let form = &bench.problem.inputs.form;
    let say = |text: &'static str| Text::from(text).render(&model.locale);
    let key = |action| model.key(KeyContext::Form, action);
    let Some(line) = form.line() else {
        let lists = Text::new("{define} defines a quantity for all problems, {ask} asks for one over them");
        let lists = lists.with("define", key(Action::Define)).with("ask", key(Action::Ask));
        return lists.render(&model.locale);
    };
    let mut parts: Vec<String> = form.hindrance().map(say).into_iter().collect();
    if matches!(form.part().role, PartRole::File(_)) {
        let opens = Text::new("{key} opens it").with("key", key(Action::Enter));
        parts.push(opens.render(&model.locale));
    }
    if let Some(text) = form.text_of_problem(&line) {
        let text = if text.trim().is_empty() { say("empty") } else { filter_untrusted(&text).into_owned() };
        let before = Text::new("{text} in the problem itself, {key} returns to it");
        parts.push(before.with("text", text).with("key", key(Action::DeleteRow)).render(&model.locale));
    }
    if let [repair, ..] = &bench.problem.repairs()[..] {
        let said = Text::new("{key} writes {text}").with("text", repair);
        parts.push(said.with("key", model.key(bench.place(), Action::Repair)).render(&model.locale));
    }
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
            let edited = bench.problem.inputs.form.edit.as_ref().map(|edit| edit.input.value());
            let thousands = form::point_of_thousands(edited.unwrap_or(text), model.locale.style);
            // A number that is typed alone has a unit in the draft that is not on the screen.
            let typed = edited.is_some_and(|edited| edited != text);
            let doubtful = thousands.map(|number| {
                Text::new("{number} has a decimal mark and is read as {echo}; write thousands without one")
                    .with("number", number)
                    .with("echo", echo.as_ref().unwrap_or(text))
                    .render(&model.locale)
            });
            let read = if typed { Some(text.clone()) } else { echo.clone() };
            let read = read.or_else(|| computed(model, &line)).filter(|_| doubtful.is_none());
            let ui = model.ui(bench, bench.tab, Rect::ZERO);
            let unit =
                bench.problem.inputs.form.unit_of_number(&line).and_then(|unit| about_number(&unit, &ui));
            // The unit is seen whatever is cut.
            parts.extend(doubtful);
            parts.push(label);
            parts.extend(unit.map(|unit| unit.render(&model.locale)));
            parts.extend(read.map(|read| format!("= {read}")));
            parts.push(say(line.field.help));
        }
    }
    parts.retain(|part| !part.is_empty());
    parts.join(&format!(" {} ", model.look.glyph(Glyph::Dot)))
}

/// The form and the meaning of a text for the cell under the cursor of the pane.
fn about_cell(model: &Model, bench: &Bench) -> String {
    let about = bench.shown().about_cell(&bench.problem, &model.ui(bench, bench.tab, Rect::ZERO));
    let parts: Vec<String> = about.iter().map(|part| part.render(&model.locale)).collect();
    parts.join(&format!(" {} ", model.look.glyph(Glyph::Dot)))
}

fn file_name(model: &Model, bench: &Bench) -> String {
    let name = match &bench.problem.document.file {
        Some(file) => {
            let name = file.path.file_name().unwrap_or(file.path.as_os_str());
            filter_untrusted(&name.to_string_lossy()).replace('\n', "\u{FFFD}")
        }
        None if bench.problem.is_unsaved() => word("not saved", model),
        None => String::new(),
    };
    let solving = match bench.problem.found.state {
        _ if bench.is_working() => {
            let text = match model.progress {
                Some(percentage) => {
                    Text::new("solving, {percentage} % done; Esc cancels").with("percentage", percentage)
                }
                None => Text::new("solving; Esc cancels"),
            };
            format!("{}  ", text.render(&model.locale))
        }
        Freshness::Stopped => format!("{}  ", word("cancelled", model)),
        _ => String::new(),
    };
    let all = model.problems();
    let place =
        all.iter().position(|other| other.problem.number == bench.problem.number).map_or(0, |at| at + 1);
    let place = if all.len() > 1 { format!("{place}/{}  ", all.len()) } else { String::new() };
    let dot = if bench.problem.is_unsaved() {
        format!("{} ", model.look.glyph(Glyph::Full))
    } else {
        String::new()
    };
    format!("{solving}{place}{dot}{name}")
}
