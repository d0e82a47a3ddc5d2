//! Keys of a problem.
// Long because every action of a problem is distinguished here; what takes more than a few lines has a file beside it.

mod display;
mod pictures;
mod working;

use std::path::PathBuf;

use dalembert_core::{Draft, Shape, Text};
use dalembert_units::Decimal;
use ratatui::{
    crossterm::event::{KeyCode, KeyEvent, KeyModifiers},
    layout::Rect,
};
use tui_input::InputRequest;

use super::{
    ask, export, files, list, remembering, request,
    scroll::{bring_in, scroll, shown_lines},
    solve::{changed, is_working, kept, stop},
    too_long, type_in,
};
use crate::{
    bench::{Bench, Focus},
    dialog::{Choice, Chosen, Dialog, Purpose, Sheet},
    files::FileError,
    form::{self, Filled, Line, Role, Sign},
    glyphs::filter_untrusted,
    keys::{Action, Key, Place},
    layout,
    model::{Effect, Model},
    plot,
    tab::Tab,
    view,
};

/// The share of an axis that a key moves the cursor of a plot by.
const CURSOR_STEP: f64 = 0.01;
/// A share of an axis beyond any of its ends.
const FAR: f64 = 1e6;
/// What is said of a key that chooses where there is nothing to choose.
const NO_ALTERNATIVE: &str = "no options here";

pub(super) fn act(model: &mut Model, place: Place, action: Action) -> Vec<Effect> {
    match action {
        Action::Save => return files::save(model),
        Action::SaveAs => return files::ask_path(model),
        Action::Export => return export::ask_path(model, Purpose::Export),
        Action::ExportSeen => return export::ask_path(model, Purpose::ExportSeen),
        Action::Edit => return super::edit::begin(model),
        Action::NextTab => return turn(model, 1),
        Action::Play | Action::PreviousFrame | Action::NextFrame => {
            pictures::animation(model, action);
            return Vec::new();
        }
        Action::PreviousTab => return turn(model, -1),
        Action::Copy => return copy(model),
        // Where a text is typed the key ends that first.
        Action::Back if !place.is_text() && is_working(model) => return stop(model),
        Action::Rename => {
            let title = model.bench.as_ref().map_or_else(String::new, |bench| bench.title.clone());
            model.dialog = Some(Dialog::prompt(Purpose::Title, title));
            return Vec::new();
        }
        _ => {}
    }
    let Some(bench) = &mut model.bench else { return Vec::new() };
    match action {
        Action::NextPane | Action::PreviousPane => {
            bench.focus = match bench.focus {
                Focus::Form => Focus::Pane,
                Focus::Pane => Focus::Form,
            };
            Vec::new()
        }
        Action::Pin => {
            pin(model);
            Vec::new()
        }
        Action::TryByHand => {
            working::try_by_hand(model);
            Vec::new()
        }
        Action::Back if place == Place::Working && bench.reading.symbol.is_some() => {
            working::back(model);
            Vec::new()
        }
        // From an input that a symbol of the working led to.
        Action::Back
            if place == Place::Form && bench.tab == Tab::Working && bench.reading.symbol.is_some() =>
        {
            bench.focus = Focus::Pane;
            Vec::new()
        }
        Action::Expand => {
            bench.expanded = !bench.expanded;
            Vec::new()
        }
        // One step back from a pane that is alone: the others come back.
        Action::Back if bench.expanded && !place.is_text() && !has_cursor(bench) => {
            bench.expanded = false;
            Vec::new()
        }
        Action::Undo => after(model, |bench| bench.form.undo(), "nothing to undo"),
        Action::Redo => after(model, |bench| bench.form.redo(), "nothing to redo"),
        _ => match place {
            Place::Edit => edit(model, action),
            Place::Form => form(model, action),
            Place::Working if working::act(model, action) => Vec::new(),
            Place::Cells => ask::act(model, action),
            Place::Cell => ask::act_in_cell(model, action),
            _ => pane(model, action),
        },
    }
}

/// Gives the problem a title; an empty one takes it away.
pub(super) fn rename(model: &mut Model, title: &str) -> Vec<Effect> {
    let readonly = model.readonly;
    let Some(bench) = &mut model.bench else { return Vec::new() };
    title.clone_into(&mut bench.title);
    if readonly { Vec::new() } else { vec![kept(bench)] }
}

/// A key that changes a digit; a sign may turn out to be that of a number.
pub(super) fn nudge(model: &mut Model, key: KeyEvent, action: Action) -> Vec<Effect> {
    let sign = match Key::of(key) {
        Key(KeyCode::Char(sign @ ('+' | '-' | '−')), KeyModifiers::NONE) => {
            model.bench.as_ref().and_then(|bench| bench.form.sign_typed(sign))
        }
        _ => None,
    };
    let effects = act(model, Place::Form, action);
    if let Some(bench) = &mut model.bench {
        bench.form.sign = sign;
    }
    effects
}

/// A digit on a field of numbers begins a new text, with the sign that was typed just before.
pub(super) fn begin_by_typing(model: &mut Model, key: KeyEvent, sign: Option<Sign>) -> Vec<Effect> {
    let Some(bench) = &mut model.bench else { return Vec::new() };
    let begins = Key::of(key).begins_a_number();
    let Some(request @ InputRequest::InsertChar(_)) = request(key).filter(|_| begins) else {
        return Vec::new();
    };
    let (instead, action) = match bench.form.line().map(|line| line.role) {
        Some(Role::Leaf { shape: Shape::Flag, .. }) => (Text::new("{key} changes it"), Action::Toggle),
        Some(Role::Leaf { shape: Shape::Reference(list), .. }) if !bench.form.names(list).is_empty() => {
            (Text::new("{key} opens the options"), Action::Enter)
        }
        Some(Role::Choice { .. }) => (Text::new("{key} opens the options"), Action::Enter),
        Some(Role::Table { .. }) => {
            let text = Text::new("{key} edits, paste replaces, {import} imports a file");
            (text.with("import", model.key(Place::Form, Action::Import)), Action::Enter)
        }
        Some(Role::Absent) => (Text::new("{key} includes it"), Action::Toggle),
        Some(Role::Leaf { .. }) => {
            let sign = sign.and_then(|sign| bench.form.take_back(sign));
            bench.form.begin(Some(String::new()));
            let sign = sign.map(InputRequest::InsertChar);
            return type_in(model, &sign.into_iter().chain([request]).collect::<Vec<_>>());
        }
        _ => return Vec::new(),
    };
    model.say(instead.with("key", model.key(Place::Form, action)));
    Vec::new()
}

/// What reads the file that the text of a table names, as in `@measured.csv`; `None` for any other text.
pub(super) fn file_of_table(model: &Model, field: &str, text: &str) -> Option<Effect> {
    let name = text.trim().strip_prefix('@').filter(|name| !name.contains('\n'))?;
    let bench = model.bench.as_ref()?;
    let (_, shape) = bench.form.draft.at(&bench.entry.shape(), field).ok()?;
    let Shape::Table(columns) = shape.present() else { return None };
    Some(Effect::ReadTable { field: field.to_owned(), path: PathBuf::from(name.trim()), columns: columns() })
}

/// The file of a table takes the place of its text.
pub(super) fn table_read(model: &mut Model, field: &str, result: Result<String, FileError>) -> Vec<Effect> {
    let asked = match &mut model.dialog {
        Some(Dialog::Prompt { purpose: Purpose::Import, error, .. }) => Some(error),
        _ => None,
    };
    match (result, asked) {
        (Ok(text), asked) => {
            if asked.is_some() {
                model.dialog = None;
            }
            after(
                model,
                |bench| bench.form.set(field, text, Decimal::Point),
                "the table already contains this file",
            )
        }
        // The path stays there to be corrected.
        (Err(err), Some(error)) => {
            *error = Some(err.text());
            Vec::new()
        }
        (Err(err), None) => {
            model.complain(err.text());
            Vec::new()
        }
    }
}

/// Asks for the file of the table under the cursor, or of the only one there is.
fn ask_import(model: &mut Model) -> Vec<Effect> {
    let Some(bench) = &mut model.bench else { return Vec::new() };
    let is_table = |line: &Line| matches!(line.role, Role::Table { .. });
    let tables: Vec<Line> = bench.form.lines().into_iter().filter(is_table).collect();
    let under_cursor = bench.form.line().filter(is_table);
    match (under_cursor, tables.as_slice()) {
        (None, []) => model.say("this problem has no table of numbers; choose a table option first"),
        (None, [_, _, ..]) => model.say("several tables: move to one of them first"),
        (table, all) => {
            if let Some(line) = table.or(all.first().cloned()) {
                bench.form.go_to(&line.path);
            }
            model.dialog = Some(Dialog::prompt_asking(Purpose::Import, "@"));
        }
    }
    Vec::new()
}

/// Reads the file that was asked for; the path stays where it is typed until that is done.
pub(super) fn import(model: &mut Model, typed: &str) -> Vec<Effect> {
    let named = format!("@{}", typed.trim_start_matches('@').trim());
    let field = model.bench.as_ref().and_then(|bench| bench.form.line()).map(|line| line.path);
    model.dialog = Some(Dialog::prompt_asking(Purpose::Import, &named));
    match field.and_then(|field| file_of_table(model, &field, &named)) {
        Some(effect) if named.len() > 1 => vec![effect],
        _ => {
            model.dialog = Some(Dialog::prompt_again(Purpose::Import, named, "enter a file name".into()));
            Vec::new()
        }
    }
}

/// A text pasted on a field takes its place.
pub(super) fn paste(model: &mut Model, text: &str) -> Vec<Effect> {
    let decimal = model.locale.style.decimal;
    let Some(bench) = &mut model.bench else { return Vec::new() };
    match bench.form.line().map(|line| (line.path, line.role)) {
        Some((path, Role::Table { .. })) => {
            if let Some(effect) = file_of_table(model, &path, text) {
                return vec![effect];
            }
            let mut sheet = Sheet::new(path.clone(), "");
            sheet.insert(text);
            after(model, |bench| bench.form.set(&path, sheet.text(), Decimal::Point), "")
        }
        Some((_, role)) if !matches!(role, Role::Leaf { .. }) || text.trim().contains(['\n', '\r', '\t']) => {
            match bench.form.fill(text, decimal) {
                Some(filled) => reported_filled(model, filled),
                None => paste_on_field(model, text),
            }
        }
        _ => paste_on_field(model, text),
    }
}

/// Says what a pasted block filled, and what of it could not be taken.
fn reported_filled(model: &mut Model, filled: Filled) -> Vec<Effect> {
    let mut said = vec![match filled.rows {
        1 => Text::new("one row filled"),
        rows => Text::new("{rows} rows filled").with("rows", rows),
    }];
    if filled.heading {
        said.push("first line skipped (heading)".into());
    }
    if filled.cells > 0 {
        said.push(Text::new("ignored, beyond the last field of a row: {cells}").with("cells", filled.cells));
    }
    if filled.lines > 0 {
        said.push(Text::new("ignored, lines at the end: {lines}").with("lines", filled.lines));
    }
    let text = said
        .into_iter()
        .reduce(|text, more| Text::new("{text}; {more}").with_text("text", text).with_text("more", more))
        .unwrap_or_else(|| Text::from(""));
    let effects = if filled.changed { changed(model) } else { Vec::new() };
    if filled.cells + filled.lines > 0 {
        model.complain(text);
    } else {
        model.say(text);
    }
    effects
}

/// A text as the one line of the field under the cursor.
fn paste_on_field(model: &mut Model, text: &str) -> Vec<Effect> {
    let decimal = model.locale.style.decimal;
    let Some(bench) = &mut model.bench else { return Vec::new() };
    match bench.form.line().map(|line| (line.path, line.role)) {
        Some((path, Role::Leaf { .. })) => {
            let (line, cut) = form::as_line(text);
            if cut {
                model.complain(too_long());
            }
            after(model, |bench| bench.form.set(&path, line, decimal), "")
        }
        _ => Vec::new(),
    }
}

/// Changes the form and solves; says `nothing` where there was nothing to change.
fn after(model: &mut Model, change: impl FnOnce(&mut Bench) -> bool, nothing: &'static str) -> Vec<Effect> {
    let Some(bench) = &mut model.bench else { return Vec::new() };
    if change(bench) {
        return changed(model);
    }
    if !nothing.is_empty() {
        model.say(nothing);
    }
    Vec::new()
}

fn form(model: &mut Model, action: Action) -> Vec<Effect> {
    let page = isize::try_from(model.size.1.saturating_sub(6).max(1)).unwrap_or(1);
    let Some(bench) = &mut model.bench else { return Vec::new() };
    let form = &mut bench.form;
    match action {
        Action::Up => form.step(-1),
        Action::Down => form.step(1),
        Action::PageUp => form.step(-page),
        Action::PageDown => form.step(page),
        Action::First => form.step(isize::MIN),
        Action::Last => form.step(isize::MAX),
        Action::Enter => return enter(model),
        Action::Clear if form.begin(Some(String::new())) => return changed(model),
        Action::Left | Action::Right if form.aim(action == Action::Left) => {}
        Action::Clear => model.say("no text to replace here"),
        Action::Left => return after(model, |bench| bench.form.cycle(-1), NO_ALTERNATIVE),
        Action::Right => return after(model, |bench| bench.form.cycle(1), NO_ALTERNATIVE),
        Action::Toggle => {
            return after(model, |bench| bench.form.toggle(), "Space has no effect on this field");
        }
        Action::Nudge(tenths) => {
            return after(model, |bench| bench.form.nudge(tenths), "+ and - change numbers only");
        }
        Action::NextUnit => {
            return after(model, |bench| bench.form.next_unit(), "no other unit available");
        }
        Action::FoldRow | Action::FoldRows => {
            let folds = if action == Action::FoldRow { form.fold_row() } else { form.fold_rows() };
            if !folds {
                model.say("no row to collapse here");
            }
        }
        Action::Import => return ask_import(model),
        Action::AddRow => return after(model, |bench| bench.form.add_row(), "not in a list"),
        Action::DuplicateRow => {
            return after(model, |bench| bench.form.duplicate_row(), "no row selected");
        }
        Action::DeleteRow => return after(model, |bench| bench.form.delete_row(), "no row selected"),
        Action::MoveRowUp => {
            return after(model, |bench| bench.form.move_row(-1), "the row is already at the end");
        }
        Action::MoveRowDown => {
            return after(model, |bench| bench.form.move_row(1), "the row is already at the end");
        }
        Action::Back => return list::come_back(model),
        _ => {}
    }
    Vec::new()
}

fn enter(model: &mut Model) -> Vec<Effect> {
    let locale = model.locale;
    let Some(bench) = &mut model.bench else { return Vec::new() };
    let Some(Line { path, role, .. }) = bench.form.line() else { return Vec::new() };
    match role {
        Role::Leaf { shape: Shape::Flag, .. } | Role::Absent => {
            return after(model, |bench| bench.form.toggle(), "");
        }
        Role::Leaf { shape: Shape::Reference(list), text, .. } => {
            let names = bench.form.names(list);
            let chosen = names.iter().position(|name| *name == text).unwrap_or(0);
            let options: Vec<Choice> = names
                .into_iter()
                .map(|name| {
                    let label = filter_untrusted(&name).into_owned();
                    Choice { label, help: String::new(), value: Chosen::Text(name) }
                })
                .collect();
            if options.is_empty() {
                bench.form.begin(None);
            } else {
                model.dialog = Some(Dialog::Choice { path, options, chosen });
            }
        }
        Role::Leaf { .. } => _ = bench.form.begin(None),
        Role::Table { .. } => {
            let text = match bench.form.draft.at(&bench.entry.shape(), &path) {
                Ok((Draft::Leaf(text), _)) => text.clone(),
                _ => String::new(),
            };
            model.dialog = Some(Dialog::Sheet(Sheet::new(path, &text)));
        }
        Role::Choice { variants, chosen } => {
            let options = variants
                .iter()
                .enumerate()
                .map(|(at, variant)| Choice {
                    label: Text::from(variant.label).render(&locale),
                    help: Text::from(variant.help).render(&locale),
                    value: Chosen::Alternative(at),
                })
                .collect();
            model.dialog = Some(Dialog::Choice { path, options, chosen: chosen.unwrap_or(0) });
        }
        Role::Rows { .. } => return after(model, |bench| bench.form.add_row(), ""),
        Role::Group { .. } => {
            if bench.form.is_folded(&path) {
                bench.form.fold_row();
            }
            bench.form.step(1);
        }
    }
    Vec::new()
}

fn edit(model: &mut Model, action: Action) -> Vec<Effect> {
    let Some(bench) = &mut model.bench else { return Vec::new() };
    match action {
        Action::Enter => bench.form.keep(),
        Action::Back => {
            bench.form.drop_edit();
            return changed(model);
        }
        Action::Down | Action::Up => {
            bench.form.keep();
            bench.form.step(if action == Action::Down { 1 } else { -1 });
        }
        _ => {}
    }
    Vec::new()
}

fn pane(model: &mut Model, action: Action) -> Vec<Effect> {
    let height = isize::try_from(shown_lines(model)).unwrap_or(1).max(1);
    let Some(bench) = &mut model.bench else { return Vec::new() };
    let in_plot = bench.tab == Tab::Plot;
    match action {
        Action::NextDisplayUnit | Action::NextDigits => return display::change(model, action),
        Action::Up | Action::Down if bench.tab == Tab::Results && bench.reading.answer.is_some() => {
            display::step(model, if action == Action::Up { -1 } else { 1 });
        }
        Action::Back if bench.tab == Tab::Results && bench.reading.answer.is_some() => {
            bench.reading.answer = None;
        }
        Action::Back => {
            if has_cursor(bench) {
                bench.plot_state = bench.plot_state.without_cursor();
            } else {
                bench.focus = Focus::Form;
            }
        }
        Action::Left if in_plot => pictures::move_cursor(bench, -CURSOR_STEP),
        Action::Right if in_plot => pictures::move_cursor(bench, CURSOR_STEP),
        Action::PageUp if in_plot => pictures::move_cursor(bench, -10.0 * CURSOR_STEP),
        Action::PageDown if in_plot => pictures::move_cursor(bench, 10.0 * CURSOR_STEP),
        Action::First if in_plot => pictures::move_cursor(bench, -FAR),
        Action::Last if in_plot => pictures::move_cursor(bench, FAR),
        Action::ZoomIn
        | Action::ZoomOut
        | Action::ZoomAll
        | Action::PanLeft
        | Action::PanRight
        | Action::NextSpread
        | Action::NextSpreadAcross => pictures::look_otherwise(model, action),
        Action::Left | Action::Right | Action::Up | Action::Down | Action::UsualView
            if bench.tab == Tab::Drawing =>
        {
            pictures::go_round(model, action);
        }
        Action::NextMarker if model.look.ascii => {
            model.say("in ASCII mode each curve has its own character; there are no other markers");
        }
        Action::NextMarker => {
            bench.plot_state = bench.plot_state.next_marker();
            model.marker = bench.plot_state.marker;
        }
        Action::NextExhibit if bench.exhibits_of(bench.tab) < 2 => {
            model.say(if in_plot { "no other plot" } else { "no other drawing" });
        }
        Action::NextExhibit => match bench.tab {
            Tab::Plot => {
                bench.plot = pictures::next(bench.plot, bench.plots().count());
                // Another plot has another axis.
                bench.plot_state =
                    plot::State { view: dalembert_report::figure::axes::View::default(), ..bench.plot_state };
            }
            Tab::Drawing => {
                bench.drawing = pictures::next(bench.drawing, bench.drawings().count());
                bench.view = None;
            }
            _ => {}
        },
        Action::Enter if bench.tab == Tab::Sources => return load_case(model),
        Action::Enter if bench.place() == Place::Pane => {
            let said = Text::new("nothing to open here: {key} loads a case in Sources");
            model.say(said.with("key", model.key(Place::Pane, Action::Enter)));
        }
        Action::Up | Action::Down if bench.tab == Tab::Sources => {
            let last = bench.cases.len().saturating_sub(1);
            bench.case =
                if action == Action::Up { bench.case.saturating_sub(1) } else { (bench.case + 1).min(last) };
            reveal_case(model);
        }
        Action::Up => scroll(model, -1),
        Action::Down => scroll(model, 1),
        Action::PageUp => scroll(model, -height),
        Action::PageDown | Action::Reveal => scroll(model, height),
        Action::First => scroll(model, isize::MIN),
        Action::Last => scroll(model, isize::MAX),
        _ => {}
    }
    Vec::new()
}

/// Whether the keys act on a plot that has a cursor.
fn has_cursor(bench: &Bench) -> bool {
    bench.place() == Place::Plot && bench.plot_state.cursor.is_some()
}

/// Compares with the present result from now on, or no more.
fn pin(model: &mut Model) {
    let Some(bench) = &mut model.bench else { return };
    if bench.pinned.take().is_some() {
        model.say("comparison off");
    } else if bench.is_stale() || bench.found.solution.is_none() {
        model.say("no result to pin: solve the problem first");
    } else {
        bench.pinned.clone_from(&bench.found.solution);
        let key = model.key(Place::Form, Action::Pin);
        let said = "result pinned: later answers show the difference from it; {key} unpins it";
        model.say(Text::new(said).with("key", key));
    }
}

fn turn(model: &mut Model, by: isize) -> Vec<Effect> {
    let Some(bench) = &mut model.bench else { return Vec::new() };
    let tabs = bench.tabs();
    let at = tabs.iter().position(|tab| *tab == bench.tab).unwrap_or(0);
    let tab = tabs[(at as isize + by).rem_euclid(tabs.len() as isize) as usize];
    show_tab(model, tab)
}

/// Shows a tab, and what it needs to be found out first.
pub(super) fn show_tab(model: &mut Model, tab: Tab) -> Vec<Effect> {
    let Some(bench) = &mut model.bench else { return Vec::new() };
    bench.tab = tab;
    let (columns, rows) = model.size;
    if layout::bench(Rect::new(0, 0, columns, rows), bench.focus, bench.expanded || model.look.basic)
        .pane
        .is_none()
    {
        bench.focus = Focus::Pane;
    }
    if bench.tab == Tab::Sources && !bench.judging {
        bench.judging = true;
        return vec![Effect::Judge(bench.entry)];
    }
    ask::turn_to(model)
}

pub(super) fn load_case(model: &mut Model) -> Vec<Effect> {
    let undo = model.key(Place::Form, Action::Undo);
    let Some(bench) = &mut model.bench else { return Vec::new() };
    let Some(case) = bench.cases.get(bench.case).map(|judged| judged.case.clone()) else { return Vec::new() };
    let untouched = !bench.is_unsaved() && bench.file.is_none();
    let said = Text::new("{case} loaded; {key} restores the previous inputs").with_text("case", case.title());
    let said = said.with("key", undo);
    bench.form.replace(case.draft.clone());
    bench.title.clear();
    bench.origin = Some(case);
    if untouched {
        bench.mark_saved();
    }
    model.say(said);
    let mut effects = changed(model);
    effects.extend(remembering::opened(model));
    effects
}

/// Scrolls so that the chosen case is seen from its first line.
pub(super) fn reveal_case(model: &mut Model) {
    let case = model.bench.as_ref().map_or(0, |bench| bench.case);
    bring_in(model, case);
}

fn copy(model: &mut Model) -> Vec<Effect> {
    let Some(bench) = &model.bench else { return Vec::new() };
    if bench.is_stale() {
        model.complain("not copied: the results shown are for other inputs");
        return Vec::new();
    }
    let text = match Bench::nth(bench.plots(), bench.plot) {
        Some(plot) if bench.tab == Tab::Plot && bench.reading.revealed.is_none() => {
            plot::readout(plot, &bench.plot_state, &model.locale).unwrap_or_default()
        }
        _ if bench.tab.is_picture() => String::new(),
        _ => {
            let page = view::page(model, bench, bench.tab, 100);
            page.lines.iter().map(|line| format!("{line}").trim_end().to_owned() + "\n").collect()
        }
    };
    if text.trim().is_empty() {
        let said = Text::new("no text to copy here; {key} exports the plot or drawing");
        model.say(said.with("key", model.key(Place::Plot, Action::ExportSeen)));
        return Vec::new();
    }
    model.say("copied");
    vec![Effect::Copy(text)]
}
