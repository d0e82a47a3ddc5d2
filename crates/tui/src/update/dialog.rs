//! Keys of what lies over a screen.

use std::path::PathBuf;

use dalembert_core::Text;
use dalembert_units::Decimal;
use ratatui::crossterm::event::{KeyCode, KeyEvent, KeyModifiers};

use super::with_shown;
use crate::{
    dialog::{After, Answer, Chosen, Dialog, Purpose},
    effect::Effect,
    files::Before,
    glyphs::filter_untrusted,
    intent::Intent,
    keys::{Action, KeyContext},
    model::Model,
    palette::{self, matching_actions},
    problem::Freshness,
    solver::{Job, Work},
    terminal::Fault,
    view,
};

pub(super) fn act(model: &mut Model, action: Action) -> Vec<Intent> {
    let page = usize::from(model.size.1.saturating_sub(4).max(1));
    let longest = view::longest_scroll_of_help(model);
    match (action, &mut model.dialog) {
        (Action::Back, _) => close(model),
        (Action::GiveUp, _) => {
            model.dialog = None;
            Vec::new()
        }
        (Action::Enter, _) => enter(model),
        (_, Some(Dialog::Help { scroll, .. })) => {
            let last = longest;
            *scroll = match action {
                Action::Up => scroll.saturating_sub(1),
                Action::Down => (*scroll + 1).min(last),
                Action::PageUp => scroll.saturating_sub(page),
                Action::PageDown => (*scroll + page).min(last),
                Action::First => 0,
                Action::Last => last,
                _ => *scroll,
            };
            Vec::new()
        }
        (Action::Up | Action::Down, Some(Dialog::Prompt { input, error, names, preview, .. })) => {
            if let Some(text) = names.next(input.value(), action == Action::Down) {
                input.replace(text);
                (*error, *preview) = (None, None);
            }
            Vec::new()
        }
        _ => {
            choose(model, action);
            Vec::new()
        }
    }
}

/// Keys in a text of many lines.
pub(super) fn edit_sheet(model: &mut Model, key: KeyEvent) {
    let Some(Dialog::Sheet(sheet)) = &mut model.dialog else { return };
    match key.code {
        KeyCode::Char(character) if key.modifiers.difference(KeyModifiers::SHIFT).is_empty() => {
            sheet.insert(character.encode_utf8(&mut [0; 4]));
        }
        KeyCode::Tab => sheet.insert("\t"),
        KeyCode::Enter => sheet.insert("\n"),
        KeyCode::Backspace => sheet.delete_before(),
        KeyCode::Delete => sheet.delete_here(),
        KeyCode::Up => sheet.step(-1, 0),
        KeyCode::Down => sheet.step(1, 0),
        KeyCode::Left => sheet.step(0, -1),
        KeyCode::Right => sheet.step(0, 1),
        KeyCode::PageUp => sheet.step(-10, 0),
        KeyCode::PageDown => sheet.step(10, 0),
        KeyCode::Home => sheet.step(0, isize::MIN),
        KeyCode::End => sheet.step(0, isize::MAX),
        _ => {}
    }
}

/// Follows an answer to a question.
fn answer(model: &mut Model, answer: Answer) -> Vec<Intent> {
    match answer {
        Answer::Cancel => {
            model.after_save = After::Stay;
            Vec::new()
        }
        Answer::SaveThen(after) => vec![Intent::SaveThen(after)],
        Answer::DiscardThen(after) => vec![Intent::Discard(after)],
        Answer::Overwrite(path) => vec![Intent::Overwrite(path)],
        Answer::SaveAs => vec![Intent::AskPath(Purpose::SaveAs)],
        Answer::ExportAs(purpose) => vec![Intent::AskPath(purpose)],
        Answer::ExportOver(purpose, path) => vec![Intent::Export(purpose, path, Before::Whatever)],
        Answer::Reload(path) => {
            model.after_save = After::Stay;
            model.reloading = Some(path.clone());
            vec![Intent::Do(Effect::Open(path))]
        }
        Answer::Restore(crashed) => vec![Intent::Restore(crashed)],
        Answer::Theme(theme) => {
            model.look.theme = theme;
            Vec::new()
        }
        Answer::EditAgain(file) => vec![Intent::Do(Effect::Edit(file))],
        Answer::DropCopy(path) => vec![Intent::Do(Effect::Remove(path))],
        Answer::Forget(sessions) => sessions.into_iter().map(Effect::Discard).map(Intent::Do).collect(),
    }
}

/// Closes a dialog without an answer; what was typed in a table is kept.
pub(super) fn close(model: &mut Model) -> Vec<Intent> {
    match model.dialog.take() {
        Some(Dialog::Sheet(sheet)) => vec![Intent::TakeTable(sheet.path.clone(), sheet.text())],
        Some(Dialog::Prompt { .. } | Dialog::Ask { .. }) => {
            model.after_save = After::Stay;
            Vec::new()
        }
        _ => Vec::new(),
    }
}

fn choose(model: &mut Model, action: Action) {
    let offers = match &model.dialog {
        Some(Dialog::Palette { input, .. }) => matching_actions(model, input.value()).len(),
        _ => 0,
    };
    let (chosen, count) = match &mut model.dialog {
        Some(Dialog::Palette { chosen, .. }) => (chosen, offers),
        Some(Dialog::Choice { chosen, options, .. }) => (chosen, options.len()),
        Some(Dialog::Ask { chosen, answers, .. }) => (chosen, answers.len()),
        _ => return,
    };
    let last = count.saturating_sub(1);
    *chosen = match action {
        Action::Up => chosen.saturating_sub(1),
        Action::Down => (*chosen + 1).min(last),
        Action::First => 0,
        Action::Last => last,
        _ => *chosen,
    };
}

fn enter(model: &mut Model) -> Vec<Intent> {
    match model.dialog.take() {
        Some(Dialog::Palette { input, chosen }) => command(model, input.value(), chosen),
        Some(Dialog::Choice { path, options, chosen }) => {
            let Some(bench) = &mut model.bench else { return Vec::new() };
            let done = match options.into_iter().nth(chosen).map(|choice| choice.value) {
                Some(Chosen::Question(question)) => return vec![Intent::AskUsual(question)],
                Some(Chosen::OwnQuestion) => {
                    bench.go_to(KeyContext::Form);
                    return vec![Intent::Press(KeyContext::Form, Action::Ask)];
                }
                Some(Chosen::Analysis(name, entry)) => return vec![Intent::LinkProblem(name, entry)],
                Some(Chosen::OfPane(what)) => {
                    return with_shown(model, |pane, problem, _| pane.chosen(problem, &what))
                        .unwrap_or_default();
                }
                Some(Chosen::Alternative(at)) => bench.problem.inputs.form.choose(&path, at),
                Some(Chosen::Text(text)) => bench.problem.inputs.form.set(&path, text, Decimal::Point),
                None => false,
            };
            if done { vec![Intent::Changed] } else { Vec::new() }
        }
        Some(Dialog::Ask { answers, chosen, .. }) => match answers.into_iter().nth(chosen) {
            Some((_, given)) => answer(model, given),
            None => Vec::new(),
        },
        Some(Dialog::Prompt { purpose, input, preview, .. }) => {
            let typed = input.value().trim();
            match purpose {
                Purpose::Title => vec![Intent::Rename(typed.to_owned())],
                Purpose::LinkedProblem => vec![Intent::BeginProblem(typed.to_owned())],
                Purpose::Configuration => vec![Intent::BeginConfiguration(typed.to_owned())],
                _ if typed.is_empty() => {
                    let error = "enter a file name".into();
                    vec![Intent::Show(Dialog::prompt_again(purpose, String::new(), error))]
                }
                Purpose::SaveAs => vec![Intent::SaveAs(PathBuf::from(typed))],
                Purpose::Export | Purpose::ExportSeen | Purpose::SavePlan => {
                    vec![Intent::Export(purpose, PathBuf::from(typed), Before::Absent)]
                }
                Purpose::Open => vec![Intent::Do(Effect::Open(PathBuf::from(typed)))],
                Purpose::Import => match preview.and_then(|preview| preview.confirmed(typed)) {
                    Some((field, text)) => vec![Intent::ReplaceTable(field, text)],
                    None => vec![Intent::Import(typed.to_owned())],
                },
                Purpose::OpenPlan => vec![Intent::Do(Effect::ReadPlan(PathBuf::from(typed)))],
            }
        }
        _ => Vec::new(),
    }
}

/// A line of the palette.
fn command(model: &mut Model, typed: &str, chosen: usize) -> Vec<Intent> {
    if let Some(kind) = typed.trim().strip_prefix("fault ").filter(|_| model.faults) {
        return match kind.parse::<Fault>() {
            Ok(fault)
                if fault.belongs_to_solver()
                    && model.shown_bench().is_some_and(|bench| bench.shown().place().has_cells()) =>
            {
                vec![Intent::Await(Work::Fault(fault))]
            }
            Ok(fault) if fault.belongs_to_solver() => {
                let generation = model.next_generation();
                if let Some(bench) = &mut model.bench {
                    bench.problem.found.state = Freshness::Solving(generation);
                }
                vec![Intent::Do(Effect::Solve(Job { generation, work: Work::Fault(fault) }))]
            }
            Ok(fault) => vec![Intent::Do(Effect::Fault(fault))],
            Err(why) => Intent::report_error(Text::new("{text}").with("text", why)),
        };
    }
    if let Some((action, words)) = palette::command(typed).filter(|_| model.shown_bench().is_some()) {
        return vec![match action {
            Action::BeginConfiguration => Intent::BeginConfiguration(words.to_owned()),
            _ => Intent::BeginProblem(words.to_owned()),
        }];
    }
    let offers = matching_actions(model, typed);
    let Some((place, action)) = offers.get(chosen).map(|(place, bound)| (*place, bound.binding.action))
    else {
        let shown = filter_untrusted(typed).chars().take(60).collect::<String>();
        return Intent::report_error(Text::new("unknown command `{typed}`").with("typed", shown));
    };
    if let Some(bench) = &mut model.bench
        && !bench.go_to(place)
    {
        return Intent::say("nothing to show here");
    }
    vec![Intent::Press(place, action)]
}
