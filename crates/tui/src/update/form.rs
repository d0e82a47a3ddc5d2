//! Keys of the inputs.

use std::path::{Path, PathBuf};

use dalembert_core::{Draft, Field, Shape, Text, suggestions::Suggestion, table::TableOutline};
use dalembert_import::Sample;
use dalembert_units::Decimal;
use ratatui::crossterm::event::{KeyCode, KeyEvent, KeyModifiers};

use crate::{
    dialog::{Choice, Chosen, Dialog, DialogContent, ImportPreview, Purpose},
    effect::Effect,
    files::FileError,
    form::{self, Filled, Form, FormLine, PartRole, Role},
    glyphs::filter_untrusted,
    intent::Intent,
    keys::{Action, Key, KeyContext},
    layout::Focus,
    model::Model,
    problem::Problem,
};

/// The message about a key that chooses where there is nothing to choose.
const NO_ALTERNATIVE: &str = "no options here";

/// A key on the inputs.
pub(super) fn act(model: &mut Model, action: Action) -> Vec<Intent> {
    let page = isize::try_from(model.size.1.saturating_sub(6).max(1)).unwrap_or(1);
    let locale = model.locale;
    let Some(bench) = &mut model.bench else { return Vec::new() };
    if let Some(intents) = in_part(&bench.problem, action) {
        return intents;
    }
    let form = &mut bench.problem.inputs.form;
    match action {
        Action::DeleteRow if matches!(form.part().role, PartRole::Configuration(_)) => {
            return after(model, Form::take_back_change, "this configuration does not change this input");
        }
        Action::Up => form.step(-1),
        Action::Down => form.step(1),
        Action::PageUp => form.step(-page),
        Action::PageDown => form.step(page),
        Action::First => form.step(isize::MIN),
        Action::Last => form.step(isize::MAX),
        Action::Enter => return enter(model),
        Action::Clear if form.begin(Some(String::new()), locale.style.decimal) => {
            return vec![Intent::Changed];
        }
        Action::Left | Action::Right if form.aim(action == Action::Left) => {}
        Action::Clear => model.say("no text to replace here"),
        Action::Left => return after(model, |form| form.cycle(-1), NO_ALTERNATIVE),
        Action::Right => return after(model, |form| form.cycle(1), NO_ALTERNATIVE),
        Action::Toggle => {
            return after(model, Form::toggle, "Space has no effect on this field");
        }
        Action::Nudge(tenths) => {
            return after(model, |form| form.nudge(tenths), "+ and - change numbers only");
        }
        Action::Repair => return repair(model),
        Action::NextUnit if matches!(form.line(), Some(FormLine { role: Role::Table { .. }, .. })) => {
            let text =
                Text::new("the heading of the table gives its units, as in `[Hz]; [mm]`: {key} edits it");
            return Intent::say(text.with("key", model.key(KeyContext::Form, Action::Enter)));
        }
        Action::NextUnit => {
            return after(model, Form::next_unit, "no other unit available");
        }
        Action::FoldRow | Action::FoldRows => {
            let folds = if action == Action::FoldRow { form.fold_row() } else { form.fold_rows() };
            if !folds {
                model.say("no row to collapse here");
            }
        }
        Action::Import => return ask_import(model),
        Action::AddRow => return after(model, Form::add_row, "not in a list"),
        Action::Define => return after(model, |form| form.add_to("let"), ""),
        Action::Ask => return after(model, |form| form.add_to("ask"), ""),
        Action::Configure => {
            return after(model, Form::configure, "a configuration changes an input: select one");
        }
        Action::Unknown => {
            return after(model, Form::make_unknown, "only a quantity can be unknown");
        }
        Action::DuplicateRow => {
            return after(model, Form::duplicate_row, "no row selected");
        }
        Action::DeleteRow => return after(model, Form::delete_row, "no row selected"),
        Action::MoveRowUp => {
            return after(model, |form| form.move_row(-1), "the row is already at the end");
        }
        Action::MoveRowDown => {
            return after(model, |form| form.move_row(1), "the row is already at the end");
        }
        Action::Back => return vec![Intent::List],
        _ => {}
    }
    Vec::new()
}

/// Meaning of a key that would change what is not of the part that is shown; `None` where it has its own.
fn in_part(problem: &Problem, action: Action) -> Option<Vec<Intent>> {
    let form = &problem.inputs.form;
    let of_problem = matches!(action, Action::Define | Action::Ask);
    let changes = matches!(
        action,
        Action::Enter
            | Action::Clear
            | Action::Left
            | Action::Right
            | Action::Nudge(_)
            | Action::NextUnit
            | Action::Toggle
            | Action::Import
            | Action::Repair
            | Action::Unknown
            | Action::AddRow
            | Action::DuplicateRow
            | Action::DeleteRow
            | Action::MoveRowUp
            | Action::MoveRowDown
            | Action::Configure
    ) || (of_problem && matches!(form.part().role, PartRole::File(_)));
    let why = form.hindrance().filter(|_| changes);
    match (form.part().role, action) {
        (PartRole::File(file), Action::Enter) => {
            let folder = problem.document.file.as_ref().and_then(|own| own.path.parent());
            Some(vec![Intent::Do(Effect::Open(folder.unwrap_or(Path::new("")).join(file)))])
        }
        (
            PartRole::Configuration(_),
            Action::Toggle
            | Action::Unknown
            | Action::AddRow
            | Action::DuplicateRow
            | Action::MoveRowUp
            | Action::MoveRowDown,
        ) => Some(Intent::say(why.unwrap_or("change this in the problem itself"))),
        _ => why.map(Intent::say),
    }
}

/// Writes what the error of the field under the cursor offers; of several texts one is chosen.
fn repair(model: &mut Model) -> Vec<Intent> {
    let Some(bench) = &mut model.bench else { return Vec::new() };
    let repairs = bench.problem.repairs();
    let form = &mut bench.problem.inputs.form;
    form.keep();
    let Some(FormLine { path, .. }) = form.line() else { return Vec::new() };
    match &repairs[..] {
        [] => Intent::say("no repair is suggested for this field"),
        [one] => {
            form.set(&path, one.clone(), Decimal::Point);
            vec![Intent::Changed]
        }
        _ => {
            let choice =
                |text: String| Choice { label: text.clone(), help: String::new(), value: Chosen::Text(text) };
            let options = repairs.into_iter().map(choice).collect();
            vec![Intent::Show(Dialog::Choice { path, options, chosen: 0 })]
        }
    }
}

fn enter(model: &mut Model) -> Vec<Intent> {
    let locale = model.locale;
    let Some(bench) = &mut model.bench else { return Vec::new() };
    let Some(FormLine { path, role, .. }) = bench.problem.inputs.form.line() else { return Vec::new() };
    match role {
        Role::Leaf { shape: Shape::Flag, .. } | Role::Absent => {
            return after(model, Form::toggle, "");
        }
        Role::Leaf { shape: Shape::Reference(list), text, .. } => {
            let names = bench.problem.inputs.form.names(list);
            let chosen = names.iter().position(|name| *name == text).unwrap_or(0);
            let options: Vec<Choice> = names
                .into_iter()
                .map(|name| {
                    let label = filter_untrusted(&name).into_owned();
                    Choice { label, help: String::new(), value: Chosen::Text(name) }
                })
                .collect();
            if options.is_empty() {
                bench.problem.inputs.form.begin(None, locale.style.decimal);
            } else {
                model.dialog = Some(Dialog::Choice { path, options, chosen });
            }
        }
        Role::Leaf { .. } => _ = bench.problem.inputs.form.begin(None, locale.style.decimal),
        Role::Table { .. } => {
            let text = match bench.problem.inputs.form.draft.at(&bench.problem.entry().shape(), &path) {
                Ok((Draft::Leaf(text), _)) => text.clone(),
                _ => String::new(),
            };
            model.dialog = Some(Dialog::Sheet(DialogContent::new(path, &text)));
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
        Role::Rows { .. } => return after(model, Form::add_row, ""),
        Role::Group { .. } => {
            if bench.problem.inputs.form.is_folded(&path) {
                bench.problem.inputs.form.fold_row();
            }
            bench.problem.inputs.form.step(1);
        }
    }
    Vec::new()
}

/// A key while a field is typed in.
pub(super) fn act_in_field(model: &mut Model, action: Action) -> Vec<Intent> {
    let Some(bench) = &mut model.bench else { return Vec::new() };
    match action {
        Action::Enter => {
            bench.problem.inputs.form.keep();
            return vec![Intent::FollowLinks];
        }
        Action::Back => {
            bench.problem.inputs.form.drop_edit();
            return vec![Intent::Changed];
        }
        Action::Repair => return repair(model),
        Action::Down | Action::Up => {
            bench.problem.inputs.form.keep();
            bench.problem.inputs.form.step(if action == Action::Down { 1 } else { -1 });
            return vec![Intent::FollowLinks];
        }
        _ => {}
    }
    Vec::new()
}

/// A key that changes a digit; a sign may turn out to be that of a number.
pub(super) fn nudge(model: &mut Model, key: KeyEvent, action: Action) -> Vec<Intent> {
    let sign = match Key::of(key) {
        Key(KeyCode::Char(sign @ ('+' | '-' | '−')), KeyModifiers::NONE) => {
            model.bench.as_ref().and_then(|bench| bench.problem.inputs.form.sign_typed(sign))
        }
        _ => None,
    };
    let intents = act(model, action);
    if let Some(bench) = &mut model.bench {
        bench.problem.inputs.form.sign = sign;
    }
    intents
}

/// Says which key serves on the field under the cursor, where no number is typed.
pub(super) fn instead_of_number(model: &Model) -> Vec<Intent> {
    let Some(bench) = &model.bench else { return Vec::new() };
    let form = &bench.problem.inputs.form;
    let (instead, action) = match form.line().map(|line| line.role) {
        Some(Role::Leaf { shape: Shape::Flag, .. }) => (Text::new("{key} changes it"), Action::Toggle),
        Some(Role::Leaf { shape: Shape::Reference(_), .. } | Role::Choice { .. }) => {
            (Text::new("{key} opens the options"), Action::Enter)
        }
        Some(Role::Table { .. }) => {
            let text = Text::new("{key} edits, paste replaces, {import} imports a file");
            (text.with("import", model.key(KeyContext::Form, Action::Import)), Action::Enter)
        }
        Some(Role::Absent) => (Text::new("{key} includes it"), Action::Toggle),
        Some(Role::Rows { .. }) => (Text::new("a list: {key} adds a row"), Action::AddRow),
        Some(Role::Group { .. }) => (Text::new("a heading: {key} goes to its fields"), Action::Enter),
        _ => return Vec::new(),
    };
    Intent::say(instead.with("key", model.key(KeyContext::Form, action)))
}

/// The cursor goes to the input at a path, and the keys with it.
pub(super) fn go_to(model: &mut Model, path: &str) -> Vec<Intent> {
    if let Some(bench) = &mut model.bench {
        bench.problem.inputs.form.go_to_nearest(path);
        bench.focus = Focus::Form;
    }
    Vec::new()
}

/// The cursor goes to the first input that is still empty, and the keys with it.
pub(super) fn go_to_missing(model: &mut Model) -> Vec<Intent> {
    let first = model.bench.as_ref().and_then(|bench| bench.problem.needed().next());
    first.map(|error| Intent::GoToInput(error.path.clone())).into_iter().collect()
}

/// Asks a usual question; where its formula has a number that is to be changed, the cursor goes to it.
pub(super) fn ask_usual(model: &mut Model, question: &Suggestion) -> Vec<Intent> {
    let locale = model.locale;
    let Some(bench) = &mut model.bench else { return Vec::new() };
    let locale = locale.at(bench.problem.entry().about.id);
    let Some(row) = bench.problem.inputs.form.ask_usual(question, &locale) else { return Vec::new() };
    if question.is_example {
        let said = "change the number in the formula to yours";
        return vec![Intent::Changed, Intent::GoToInput(format!("{row}.formula")), Intent::Say(said.into())];
    }
    let said = Text::new("asked: {question}").with("question", question.title(&locale));
    vec![Intent::Changed, Intent::Say(said)]
}

/// Takes what was typed in a table: its text, or the file that it names.
pub(super) fn take_table(model: &mut Model, path: &str, text: String) -> Vec<Intent> {
    match file_of_table(model, path, &text) {
        Some(effect) => vec![Intent::Do(effect)],
        None => after(model, |form| form.set(path, text, Decimal::Point), ""),
    }
}

/// The effect that reads the file that the text of a table names, as in `@measured.csv`; `None` for any other text.
fn file_of_table(model: &Model, field: &str, text: &str) -> Option<Effect> {
    let name = text.trim().strip_prefix('@').filter(|name| !name.contains('\n'))?;
    let columns = columns_of(model, field)?;
    Some(Effect::ReadTable { field: field.to_owned(), path: PathBuf::from(name.trim()), columns })
}

/// Columns of the table at a path; `None` where there is no table.
fn columns_of(model: &Model, path: &str) -> Option<&'static [Field]> {
    let bench = model.bench.as_ref()?;
    let (_, shape) = bench.problem.inputs.form.draft.at(&bench.problem.entry().shape(), path).ok()?;
    if let Shape::Table(columns) = shape.present() { Some(columns()) } else { None }
}

/// The file of a table is shown before it takes the place of the text.
pub(super) fn table_read(
    model: &mut Model,
    field: &str,
    path: &Path,
    result: Result<String, FileError>,
    sample: Sample,
) -> Vec<Intent> {
    let Some(columns) = columns_of(model, field) else { return Vec::new() };
    let is_asked = matches!(model.dialog, Some(Dialog::Prompt { purpose: Purpose::Import, .. }));
    let read = result.map_err(|err| err.text()).and_then(|text| ImportPreview::of(text, columns));
    let typed = format!("@{}", path.display());
    let (read, error) = match read {
        Ok(read) => (Some(read), None),
        // The path stays there to be corrected.
        Err(error) if is_asked && sample.rows.is_empty() => {
            model.dialog = Some(Dialog::prompt_again(Purpose::Import, typed, error));
            return Vec::new();
        }
        Err(error) if sample.rows.is_empty() => {
            model.report_error(error);
            return Vec::new();
        }
        Err(error) => (None, Some(error)),
    };
    let preview = ImportPreview { typed, field: field.to_owned(), read, sample };
    model.dialog = Some(Dialog::preview(preview, error));
    Vec::new()
}

/// The text of a file takes the place of that of a table.
pub(super) fn replace_table(model: &mut Model, field: &str, text: String) -> Vec<Intent> {
    let outline = columns_of(model, field).and_then(|columns| TableOutline::of(&text, columns));
    let mut intents =
        after(model, |form| form.set(field, text, Decimal::Point), "the table already contains this file");
    if let (Some(outline), [Intent::Changed]) = (outline, &intents[..]) {
        intents.push(Intent::Say(match outline.assumed.as_str() {
            "" => outline.text(),
            _ => Text::new("{table}: no unit in the heading").with_text("table", outline.text()),
        }));
    }
    intents
}

/// Asks for the file of the table under the cursor, or of the only one there is. The line opens without a table too:
/// what is typed behind `@` is a path, and never keys of the form.
fn ask_import(model: &mut Model) -> Vec<Intent> {
    let Some(bench) = &mut model.bench else { return Vec::new() };
    model.dialog = Some(match table_to_fill(&mut bench.problem.inputs.form) {
        Ok(_) => Dialog::prompt_asking(Purpose::Import, "@"),
        Err(why) => Dialog::prompt_again(Purpose::Import, "@".into(), why.into()),
    });
    Vec::new()
}

/// Path of the table under the cursor, or of the only one there is, to which the cursor goes.
fn table_to_fill(form: &mut Form) -> Result<String, &'static str> {
    let is_table = |line: &FormLine| matches!(line.role, Role::Table { .. });
    if let Some(line) = form.line().filter(is_table) {
        return Ok(line.path);
    }
    let mut tables = form.lines().into_iter().filter(is_table);
    match (tables.next(), tables.next()) {
        (None, _) => Err("this problem has no table of numbers; choose a table option first"),
        (_, Some(_)) => Err("several tables: move to one of them first"),
        (Some(line), None) => {
            form.go_to(&line.path);
            Ok(line.path)
        }
    }
}

/// Reads the file that was asked for; the path stays where it is typed until that is done.
pub(super) fn import(model: &mut Model, typed: &str) -> Vec<Intent> {
    let named = format!("@{}", typed.trim_start_matches('@').trim());
    let Some(bench) = &mut model.bench else { return Vec::new() };
    let read = match table_to_fill(&mut bench.problem.inputs.form) {
        Ok(_) if named.len() == 1 => Err("enter a file name"),
        Ok(field) => file_of_table(model, &field, &named).ok_or("enter a file name"),
        Err(why) => Err(why),
    };
    match read {
        Ok(effect) => {
            model.dialog = Some(Dialog::prompt_asking(Purpose::Import, &named));
            vec![Intent::Do(effect)]
        }
        Err(why) => {
            model.dialog = Some(Dialog::prompt_again(Purpose::Import, named, why.into()));
            Vec::new()
        }
    }
}

/// A text pasted on a field takes its place.
pub(super) fn paste(model: &mut Model, text: &str) -> Vec<Intent> {
    let decimal = model.locale.style.decimal;
    let Some(bench) = &mut model.bench else { return Vec::new() };
    if let Some(why) = bench.problem.inputs.form.hindrance() {
        return Intent::say(why);
    }
    if matches!(bench.problem.inputs.form.part().role, PartRole::Configuration(_)) {
        return paste_on_field(model, text);
    }
    match bench.problem.inputs.form.line().map(|line| (line.path, line.role)) {
        Some((path, Role::Table { .. })) => {
            if let Some(effect) = file_of_table(model, &path, text) {
                return vec![Intent::Do(effect)];
            }
            let mut sheet = DialogContent::new(path.clone(), "");
            sheet.insert(text);
            after(model, |form| form.set(&path, sheet.text(), Decimal::Point), "")
        }
        Some((_, role)) if !matches!(role, Role::Leaf { .. }) || text.trim().contains(['\n', '\r', '\t']) => {
            match bench.problem.inputs.form.fill(text, decimal) {
                Some(filled) => reported_filled(model, filled),
                None => paste_on_field(model, text),
            }
        }
        _ => paste_on_field(model, text),
    }
}

/// Says what a pasted block filled, and what of it could not be taken.
fn reported_filled(model: &mut Model, filled: Filled) -> Vec<Intent> {
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
    let effects = if filled.changed { vec![Intent::Changed] } else { Vec::new() };
    if filled.cells + filled.lines > 0 {
        model.report_error(text);
    } else {
        model.say(text);
    }
    effects
}

/// A text as the one line of the field under the cursor.
fn paste_on_field(model: &mut Model, text: &str) -> Vec<Intent> {
    let decimal = model.locale.style.decimal;
    let Some(bench) = &mut model.bench else { return Vec::new() };
    match bench.problem.inputs.form.line().map(|line| (line.path, line.role)) {
        Some((path, Role::Leaf { .. })) => {
            let (line, cut) = form::as_line(text);
            if cut {
                model.report_error(too_long());
            }
            after(model, |form| form.set(&path, line, decimal), "")
        }
        _ => Vec::new(),
    }
}

/// The message about a pasted text that is too long for a field.
pub(super) fn too_long() -> Text {
    Text::new("pasted text truncated: a line takes at most {most} characters").with("most", form::LONGEST)
}

/// Changes the inputs; says `nothing` where there was nothing to change.
pub(super) fn after(
    model: &mut Model,
    change: impl FnOnce(&mut Form) -> bool,
    nothing: &'static str,
) -> Vec<Intent> {
    let Some(bench) = &mut model.bench else { return Vec::new() };
    match change(&mut bench.problem.inputs.form) {
        true => vec![Intent::Changed],
        false if nothing.is_empty() => Vec::new(),
        false => Intent::say(nothing),
    }
}
