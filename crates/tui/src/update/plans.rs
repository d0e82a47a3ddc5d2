//! The file of the plan of a study: read, and written for the command line.

use std::path::{Path, PathBuf};

use dalembert_core::{FieldError, Text, find};
use dalembert_study::plans;

use crate::{
    dialog::{Answer, Dialog, Purpose},
    effect::Effect,
    files::{Before, FileError, Fingerprint, Opened, is_same_file, shown},
    intent::Intent,
    keys::{Action, KeyContext},
    model::Model,
    problem::{OpenFile, Problem},
};

/// Writes the plan to its file, or asks for one.
pub(super) fn save(model: &Model) -> Vec<Intent> {
    let file = model.bench.as_ref().and_then(|bench| bench.pane(bench.tab_of_plan()?).plan_file());
    match file.and_then(|file| Some((file.path.clone(), file.fingerprint?))) {
        Some((path, fingerprint)) => vec![Intent::Export(Purpose::SavePlan, path, Before::Was(fingerprint))],
        None => vec![Intent::AskPath(Purpose::SavePlan)],
    }
}

/// Asks for the file of a plan: beside the problem, unless the user says otherwise.
pub(super) fn ask_path(model: &Model, purpose: Purpose) -> Vec<Intent> {
    let Some(bench) = &model.bench else { return Vec::new() };
    let problem = bench.problem.document.file.as_ref().map(|file| &file.path);
    if purpose == Purpose::OpenPlan {
        let folder = problem.and_then(|path| path.parent()).filter(|folder| !folder.as_os_str().is_empty());
        let folder = folder.map_or_else(String::new, |folder| format!("{}/", folder.display()));
        return vec![Intent::Show(Dialog::prompt_asking(purpose, &folder))];
    }
    if model.readonly {
        return vec![Intent::Refuse];
    }
    if let Err(why) = text(model, Path::new("")) {
        return vec![Intent::Complain(why)];
    }
    let id = bench.problem.entry().about.id;
    let stem = problem.and_then(|path| path.file_stem()).map(|stem| stem.to_string_lossy().into_owned());
    let name = stem.unwrap_or_else(|| id.rsplit('/').next().unwrap_or(id).replace('-', "_"));
    let name = format!("{name}_study.toml");
    let path = problem.map_or_else(|| PathBuf::from(&name), |path| path.with_file_name(&name));
    vec![Intent::Show(Dialog::prompt(purpose, path.display().to_string()))]
}

/// Writes the plan to a file.
pub(super) fn write(model: &Model, path: PathBuf, before: Before) -> Vec<Intent> {
    if model.readonly {
        return vec![Intent::Refuse];
    }
    let path = if path.extension().is_none() { path.with_extension("toml") } else { path };
    match text(model, &path) {
        Ok(text) => vec![Intent::Do(Effect::SavePlan { path, text, before })],
        Err(why) => vec![Intent::Complain(why)],
    }
}

/// The text of the plan in a file at a path.
fn text(model: &Model, path: &Path) -> Result<String, Text> {
    let nothing = || Text::new("nothing to show here");
    let bench = model.bench.as_ref().ok_or_else(nothing)?;
    let pane = bench.pane(bench.tab_of_plan().ok_or_else(nothing)?);
    let mut plan = pane.plan(&bench.problem).map_err(|errors| {
        let FieldError { path, why, .. } =
            errors.into_iter().next().unwrap_or_else(|| FieldError::new("", ""));
        Text::new("study plan not written: {path}: {why}").with("path", path).with_text("why", why)
    })?;
    let save = model.key(KeyContext::Form, Action::Save);
    plan.problem = name_of(&bench.problem, path).ok_or_else(|| {
        Text::new("save the problem first ({key}): a study plan names the file of its problem")
            .with("key", save)
    })?;
    plans::write(&plan, pane.plan_file().map_or("", |file| &file.text))
}

/// The problem as a plan at a path names it: its file from there, or the analysis of which it is the first case.
fn name_of(problem: &Problem, plan: &Path) -> Option<String> {
    if let Some(file) = &problem.document.file {
        let folder = |path: &Path| std::path::absolute(path).ok()?.parent().map(Path::to_owned);
        let of_problem = std::path::absolute(&file.path).unwrap_or_else(|_| file.path.clone());
        let name = folder(plan).and_then(|folder| of_problem.strip_prefix(folder).ok().map(Path::to_owned));
        return Some(name.unwrap_or(of_problem).display().to_string());
    }
    let origin = problem.document.origin.as_ref().filter(|case| case.draft == problem.inputs.form.draft)?;
    let first = problem.cases.first().filter(|first| first.case.draft == origin.draft);
    first.map(|_| problem.entry().about.id.to_owned())
}

/// Says where the plan is, or what stands in its way.
pub(super) fn saved(
    model: &mut Model,
    path: PathBuf,
    text: String,
    result: Result<Fingerprint, FileError>,
) -> Vec<Intent> {
    match result {
        Ok(fingerprint) => {
            let Some(bench) = &mut model.bench else { return Vec::new() };
            let said = if bench.problem.document.file.is_some() && bench.problem.is_unsaved() {
                Text::new("study plan written to {file}; the problem has unsaved changes: save it too")
            } else {
                Text::new("study plan written to {file}; run it by `dalembert study {file}`")
            };
            let said = said.with("file", shown(&path));
            let Ok(plan) = plans::read(&text) else { return Intent::say(said) };
            if let Some(tab) = bench.tab_of_plan() {
                let file = OpenFile { path, text, fingerprint: Some(fingerprint) };
                bench.panes[tab.0].take_plan(&mut bench.problem, &plan, file);
            }
            vec![Intent::Ask, Intent::Say(said)]
        }
        Err(error @ (FileError::Exists(_) | FileError::Changed(_) | FileError::Removed(_))) => {
            vec![Intent::Show(Dialog::Ask {
                question: error.text(),
                answers: vec![
                    ("write under another name", Answer::ExportAs(Purpose::SavePlan)),
                    ("overwrite", Answer::ExportOver(Purpose::SavePlan, path)),
                    ("stay", Answer::Cancel),
                ],
                chosen: 0,
            })]
        }
        Err(error) => {
            let typed = path.display().to_string();
            vec![Intent::Show(Dialog::prompt_again(Purpose::SavePlan, typed, error.text()))]
        }
    }
}

/// Takes the plan of a file, or asks again.
pub(super) fn read(model: &mut Model, path: PathBuf, result: Result<Opened, FileError>) -> Vec<Intent> {
    let again = |why: Text| {
        let typed = path.display().to_string();
        vec![Intent::Show(Dialog::prompt_again(Purpose::OpenPlan, typed, why))]
    };
    let opened = match result {
        Ok(opened) => opened,
        Err(error) => return again(error.text()),
    };
    let plan = match plans::read(&opened.text) {
        Ok(plan) => plan,
        Err(why) => return again(why),
    };
    let Some(bench) = &mut model.bench else { return Vec::new() };
    let Some(tab) = bench.tab_of_plan() else { return Vec::new() };
    let problem = &mut bench.problem;
    let is_own = match &problem.document.file {
        Some(file) => is_same_file(&file.path, &path.with_file_name(&plan.problem)),
        None => find(&plan.problem).is_some_and(|entry| entry.about.id == problem.entry().about.id),
    };
    let said = if is_own {
        Text::new("study plan {file} read").with("file", shown(&path))
    } else {
        Text::new("the plan is of {problem}; it is shown for the problem that is open")
            .with("problem", &plan.problem)
    };
    let file = OpenFile { path, text: opened.text, fingerprint: Some(opened.fingerprint) };
    bench.panes[tab.0].take_plan(problem, &plan, file);
    let said = if is_own { Intent::Say(said) } else { Intent::Complain(said) };
    vec![Intent::Turn(tab), Intent::Ask, said]
}
