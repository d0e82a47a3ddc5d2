//! Keys of field mode: lines are answered, pages follow one another, the job is saved on the way.

use dalembert_core::Text;

use crate::{
    dialog::{Dialog, Purpose},
    field::{self, ANALYSIS, FieldLine, FieldMode, FieldPage, Go, LineKind, TypedLine},
    intent::Intent,
    keys::Action,
    model::{Model, Screen},
    problem::Problem,
    text_entry::TextEntry,
};

/// The longest name of a proposed file.
const LONGEST_NAME: usize = 40;

/// Field mode of the job that is shown, or of a blank one.
pub(super) fn begin(model: &mut Model) -> Vec<Intent> {
    let style = model.locale.style;
    let is_shown = model.screen == Screen::Bench;
    if let Some(bench) = model.bench.as_mut().filter(|_| is_shown && model.field.is_none()) {
        bench.problem.inputs.form.keep();
        if let Some(field) = FieldMode::of(&bench.problem, None, style) {
            bench.field = Some(field);
            return Vec::new();
        }
    }
    let entry = model.listings.iter().map(|listing| listing.entry).find(|entry| entry.about.id == ANALYSIS);
    let Some(entry) = entry else {
        model.field = None;
        return Intent::report_error("there is no analysis of field balancing in this program");
    };
    model.field.get_or_insert(None);
    let problem = Problem::new(entry, String::new(), field::blank(entry), model.cases_of(entry));
    vec![Intent::Open(Box::new(problem))]
}

/// Field mode of a problem that is opened, where it is to begin with one.
pub(super) fn wanted(model: &mut Model, problem: &Problem) -> Option<FieldMode> {
    let path = model.field.take()?;
    let field = FieldMode::of(problem, path, model.locale.style);
    if field.is_none() {
        model.report_error("field mode needs a problem of field balancing; this is another one");
    }
    field
}

/// Does what a key means on a page.
pub(super) fn act(model: &mut Model, action: Action) -> Vec<Intent> {
    match action {
        Action::Enter => enter(model),
        Action::Up => step(model, -1),
        Action::Down => step(model, 1),
        Action::First => step(model, isize::MIN),
        Action::Last => step(model, isize::MAX),
        Action::Left => turn(model, -1),
        Action::Right => turn(model, 1),
        Action::PageUp => turn_page(model, -1),
        Action::PageDown => turn_page(model, 1),
        Action::Back => back(model),
        Action::Save => settled(model, |_| vec![Intent::Save]),
        Action::Export => settled(model, |_| vec![Intent::AskPath(Purpose::Export)]),
        Action::Workbench => settled(model, leave),
        Action::Undo => undo(model),
        _ => Vec::new(),
    }
}

/// A digit chooses an option, and the next line is asked for.
pub(super) fn by_digit(model: &mut Model, character: char) -> Vec<Intent> {
    let Some(at) = character.to_digit(10).and_then(|digit| (digit as usize).checked_sub(1)) else {
        return Vec::new();
    };
    let intents = choose(model, |_| Some(at));
    if !intents.is_empty() {
        go_on(model);
    }
    intents
}

/// Chooses an option of the line under the cursor, by the place of the one that is chosen now.
fn choose(model: &mut Model, which: impl FnOnce(Option<usize>) -> Option<usize>) -> Vec<Intent> {
    let Some((problem, field)) = parts(model) else { return Vec::new() };
    let Some(FieldLine { kind: LineKind::Choice(choice, options), .. }) = field.shown(problem) else {
        return Vec::new();
    };
    let at = which(field::option(problem, choice)).filter(|at| *at < options.len());
    match at {
        Some(at) if field::choose(problem, choice, at) => {
            field.fault = None;
            vec![Intent::Changed]
        }
        _ => Vec::new(),
    }
}

fn parts(model: &mut Model) -> Option<(&mut Problem, &mut FieldMode)> {
    let bench = model.bench.as_mut()?;
    Some((&mut bench.problem, bench.field.as_mut()?))
}

/// The option before or after the chosen one.
fn turn(model: &mut Model, by: isize) -> Vec<Intent> {
    choose(model, |at| at.map_or(Some(0), |at| at.checked_add_signed(by)))
}

fn enter(model: &mut Model) -> Vec<Intent> {
    let Some((problem, field)) = parts(model) else { return Vec::new() };
    let Some(line) = field.shown(problem) else { return Vec::new() };
    match line.kind {
        LineKind::Go(to) => go(model, to),
        LineKind::Choice(choice, options) if field::option(problem, choice).is_none() => {
            // Nothing is chosen for the user: a convention taken in silence puts weights at wrong angles.
            field.fault = Some(match options.len() {
                2 => "choose 1 or 2".into(),
                last => Text::new("choose 1 to {last}").with("last", last),
            });
            Vec::new()
        }
        LineKind::Choice(..) => {
            go_on(model);
            Vec::new()
        }
        _ => settled(model, |model| {
            go_on(model);
            Vec::new()
        }),
    }
}

/// Takes the text of the line under the cursor, where it was changed, and does something then.
fn settled(model: &mut Model, then: impl FnOnce(&mut Model) -> Vec<Intent>) -> Vec<Intent> {
    let style = model.locale.style;
    let Some((problem, field)) = parts(model) else { return Vec::new() };
    let mut intents = Vec::new();
    if let Some(line) = field.shown(problem).filter(|line| line.is_text() && field.input.is_changed()) {
        match TypedLine::read(problem, &line, field.input.value(), style) {
            Ok(typed) => {
                field::take(problem, typed);
                intents.push(Intent::Changed);
            }
            Err(why) => {
                field.fault = Some(why);
                // What is typed next takes its place; an arrow keeps it.
                let original = field.input.original().to_owned();
                field.input = TextEntry::selected(field.input.value()).begun_from(original);
                return Vec::new();
            }
        }
        let at = field.line;
        field.go_to(problem, at, style);
    }
    intents.extend(then(model));
    intents
}

/// Goes to the next line that is to be answered, or to the way on.
fn go_on(model: &mut Model) {
    let style = model.locale.style;
    let Some((problem, field)) = parts(model) else { return };
    let line = field.shown(problem);
    let is_open = line.is_some_and(|line| line.required && !field::is_answered(problem, &line));
    if is_open {
        field.fault = Some("a value is needed here".into());
        return;
    }
    let next = field.next_line(problem);
    field.go_to(problem, next, style);
}

/// Moves the cursor by so many lines.
fn step(model: &mut Model, by: isize) -> Vec<Intent> {
    settled(model, |model| {
        let style = model.locale.style;
        let Some((problem, field)) = parts(model) else { return Vec::new() };
        let last = field.lines(problem).len().saturating_sub(1);
        let line = field.line.saturating_add_signed(by).min(last);
        field.go_to(problem, line, style);
        Vec::new()
    })
}

/// The way on from a page.
fn go(model: &mut Model, to: Go) -> Vec<Intent> {
    match to {
        Go::Report => vec![Intent::AskPath(Purpose::Export)],
        Go::Workbench => leave(model),
        Go::Next | Go::End => {
            let style = model.locale.style;
            let Some((problem, field)) = parts(model) else { return Vec::new() };
            let open = |line: &FieldLine| line.required && !field::is_answered(problem, line);
            if let Some(line) = field.lines(problem).iter().position(open) {
                field.go_to(problem, line, style);
                field.fault = Some("this is still to be answered".into());
                return Vec::new();
            }
            let from = field.page;
            let all = field.pages(problem);
            let at = all.iter().position(|page| *page == from).unwrap_or(0);
            let next = if to == Go::End { all.len() - 1 } else { (at + 1).min(all.len() - 1) };
            field.turn_to(problem, all[next], style);
            save(model, from)
        }
    }
}

/// Saves the job on the way: in its file, or in one that is proposed once.
fn save(model: &mut Model, left: FieldPage) -> Vec<Intent> {
    // What a session that is played types in a dialog is typed in none of its own.
    let (readonly, is_replay) = (model.readonly, model.is_replay);
    let Some((problem, field)) = parts(model) else { return Vec::new() };
    match (&problem.document.file, field.path.take()) {
        (Some(_), _) | (_, Some(_)) if readonly => Vec::new(),
        _ if readonly && !is_replay => Vec::new(),
        (Some(_), _) if !problem.is_unsaved() => Vec::new(),
        (Some(_), _) => vec![Intent::Save],
        (None, Some(path)) => vec![Intent::SaveAs(path)],
        (None, None) if left == FieldPage::Job => {
            let proposed = format!("{}.toml", file_name(&problem.document.title));
            vec![Intent::Show(Dialog::prompt(Purpose::SaveAs, proposed))]
        }
        (None, None) => Vec::new(),
    }
}

/// A name of a file for a rotor: its letters and digits.
fn file_name(title: &str) -> String {
    let letters = title.to_lowercase().chars().take(LONGEST_NAME).collect::<String>();
    let words: Vec<&str> =
        letters.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty()).collect();
    if words.is_empty() { "field-balancing".to_owned() } else { words.join("-") }
}

/// The page before or after; not beyond one that is not complete.
fn turn_page(model: &mut Model, by: isize) -> Vec<Intent> {
    settled(model, |model| {
        let style = model.locale.style;
        let Some((problem, field)) = parts(model) else { return Vec::new() };
        let all = field.pages(problem);
        let at = all.iter().position(|page| *page == field.page).unwrap_or(0);
        if by > 0 && !field::is_complete(problem, field.page) {
            return Intent::say("answer what is asked on this page first");
        }
        let Some(page) = at.checked_add_signed(by).and_then(|at| all.get(at)) else { return Vec::new() };
        field.turn_to(problem, *page, style);
        Vec::new()
    })
}

/// The text as it was; else the page before, and from the first the list.
fn back(model: &mut Model) -> Vec<Intent> {
    let style = model.locale.style;
    let Some((problem, field)) = parts(model) else { return Vec::new() };
    let is_text = field.shown(problem).is_some_and(|line| line.is_text());
    if is_text && field.input.is_changed() {
        let line = field.line;
        field.go_to(problem, line, style);
        return Vec::new();
    }
    if field.page == FieldPage::Job {
        return vec![Intent::List];
    }
    turn_page(model, -1)
}

/// From field mode to the problem in the workbench.
fn leave(model: &mut Model) -> Vec<Intent> {
    if let Some(bench) = &mut model.bench {
        bench.field = None;
    }
    let said = Text::new("`:field` comes back to the job, step by step");
    vec![Intent::Say(said)]
}

fn undo(model: &mut Model) -> Vec<Intent> {
    let Some((problem, _)) = parts(model) else { return Vec::new() };
    if problem.inputs.form.undo() { vec![Intent::Changed] } else { Intent::say("nothing to undo") }
}
