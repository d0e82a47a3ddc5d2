//! The problem outside of the program: in the user's editor, and when another program changes its file.

use std::path::Path;

use dalembert_core::{Text, file::ProblemFile};

use crate::{
    dialog::{Answer, Dialog, Editing},
    effect::Effect,
    files::{FileError, Opened, faults, shown},
    intent::Intent,
    model::{EditError, Model},
    problem::OpenFile,
};

/// Opens the problem in the user's editor: its file, or a copy where that says something else.
pub(super) fn begin(model: &mut Model) -> Vec<Intent> {
    if model.readonly {
        return vec![Intent::Refuse];
    }
    let Some(bench) = &mut model.bench else { return Vec::new() };
    bench.problem.inputs.form.keep();
    let own = bench
        .problem
        .document
        .file
        .as_ref()
        .filter(|file| !bench.problem.is_unsaved() && file.fingerprint.is_some());
    vec![Intent::Do(Effect::Edit(match own {
        Some(file) => Editing::Own(file.path.clone()),
        None => Editing::Text(bench.problem.as_text()),
    }))]
}

/// Takes what the editor left.
pub(super) fn edited(model: &mut Model, edited: Editing, result: Result<Opened, EditError>) -> Vec<Intent> {
    let opened = match result {
        Ok(opened) => opened,
        Err(EditError::Editor(command)) => {
            let why = "`{command}` failed: set $VISUAL or $EDITOR, or `editor` in the settings";
            return without(model, edited, Text::new(why).with("command", command));
        }
        Err(EditError::NoEditor(command)) => {
            let why = "`{command}` was not found: set $VISUAL or $EDITOR, or `editor` in the settings";
            return without(model, edited, Text::new(why).with("command", command));
        }
        Err(EditError::File(error)) => {
            model.report_error(error.text());
            return Vec::new();
        }
    };
    // A copy stands in a folder of its own: what it links to lies beside the file of the problem.
    let document = model.bench.as_ref().map(|bench| &bench.problem.document);
    let (path, linked) = match (&edited, document) {
        (Editing::Own(path), _) => (Some(path.as_path()), &opened.linked),
        (_, Some(document)) => (document.file.as_ref().map(|file| file.path.as_path()), &document.links),
        (_, None) => (None, &opened.linked),
    };
    match (model.parse(path, &opened.text, linked), edited) {
        (Ok(read), Editing::Own(path)) => reload(model, &path, read, opened, "{file} reloaded"),
        (Ok(read), Editing::Copy(path)) => {
            let mut intents = take_copy(model, read, opened.text);
            intents.push(Intent::Do(Effect::Remove(path)));
            intents
        }
        (Ok(_), Editing::Text(_)) => Vec::new(),
        (Err(errors), edited) => {
            let faults = faults(&opened.text, &errors, &model.locale).join("; ");
            let give_up = match &edited {
                Editing::Copy(path) => ("discard the edits", Answer::DropCopy(path.clone())),
                _ => ("keep the previous values", Answer::Cancel),
            };
            model.dialog = Some(Dialog::Ask {
                question: Text::new("The edited problem cannot be read. {faults}").with("faults", faults),
                answers: vec![("edit again", Answer::EditAgain(edited)), give_up],
                chosen: 0,
            });
            Vec::new()
        }
    }
}

/// Nothing was edited, and why.
fn without(model: &mut Model, edited: Editing, why: Text) -> Vec<Intent> {
    model.report_error(why);
    match edited {
        Editing::Copy(path) => vec![Intent::Do(Effect::Remove(path))],
        _ => Vec::new(),
    }
}

/// Another program changed the file of the problem: it is read again, unless that would lose something.
pub(super) fn changed_on_disk(
    model: &mut Model,
    path: &Path,
    result: Result<Opened, FileError>,
) -> Vec<Intent> {
    let Some(bench) = &model.bench else { return Vec::new() };
    let Some(open) = bench.problem.document.file.as_ref().filter(|file| file.path == path) else {
        return Vec::new();
    };
    let opened = match result {
        // What it held is not known after a crash; a save asks then.
        Ok(opened) if open.fingerprint.is_none_or(|known| known == opened.fingerprint) => return Vec::new(),
        Ok(opened) => opened,
        Err(FileError::Missing(_)) => {
            let gone = Text::new("{file} no longer exists; saving creates it again");
            model.report_error(gone.with("file", shown(path)));
            return Vec::new();
        }
        Err(error) => {
            model.report_error(error.text());
            return Vec::new();
        }
    };
    if bench.problem.is_unsaved() || bench.problem.inputs.form.edit.is_some() || model.dialog.is_some() {
        let question = Text::new("{file} was changed by another program since it was opened.");
        let question = question.with("file", shown(path));
        if model.dialog.is_some() {
            // What lies over the screen is not pushed aside: a save asks, if it is forgotten.
            model.report_error(question);
        } else {
            let answers = vec![
                ("keep this version", Answer::Cancel),
                ("reload the file and lose the changes made here", Answer::Reload(path.to_owned())),
            ];
            model.dialog = Some(Dialog::Ask { question, answers, chosen: 0 });
        }
        return Vec::new();
    }
    match model.parse(Some(path), &opened.text, &opened.linked) {
        Ok(read) => reload(model, path, read, opened, "{file} was changed by another program and reloaded"),
        Err(errors) => {
            let faults = faults(&opened.text, &errors, &model.locale);
            let why = Text::new("{file} was changed by another program and cannot be read: {why}");
            let first = faults.into_iter().next().unwrap_or_default();
            model.report_error(why.with("file", shown(path)).with("why", first));
            Vec::new()
        }
    }
}

/// The file says something else now; what is examined stays where it is.
fn reload(
    model: &mut Model,
    path: &Path,
    read: ProblemFile,
    opened: Opened,
    said: &'static str,
) -> Vec<Intent> {
    let Some(bench) = &model.bench else { return Vec::new() };
    let unchanged =
        bench.problem.document.file.as_ref().is_some_and(|file| file.fingerprint == Some(opened.fingerprint));
    if unchanged {
        model.say("no changes");
        return Vec::new();
    }
    let intent = if read.entry.about.id == bench.problem.entry().about.id {
        take(model, read);
        if let Some(bench) = &mut model.bench {
            bench.problem.document.links = opened.linked;
            bench.problem.document.file = Some(OpenFile {
                path: path.to_owned(),
                text: opened.text,
                fingerprint: Some(opened.fingerprint),
            });
            bench.problem.mark_saved();
        }
        Intent::Changed
    } else {
        Intent::Opened(path.to_owned(), opened)
    };
    vec![intent, Intent::Say(Text::new(said).with("file", shown(path)))]
}

/// Replaces the problem by an edited copy, not saved yet; it can be undone.
fn take_copy(model: &mut Model, read: ProblemFile, text: String) -> Vec<Intent> {
    let Some(bench) = &model.bench else { return Vec::new() };
    let before = bench.problem.as_file();
    if (&before.title, &before.title_block, &before.draft, before.units, &before.show)
        == (&read.title, &read.title_block, &read.draft, read.units, &read.show)
        && before.entry.about.id == read.entry.about.id
    {
        model.say("no changes");
        return Vec::new();
    }
    let file = bench.problem.document.file.clone().map(|file| OpenFile { text: text.clone(), ..file });
    let intent = if read.entry.about.id == bench.problem.entry().about.id {
        take(model, read);
        if let Some(bench) = &mut model.bench {
            (bench.problem.document.file, bench.problem.document.commented) = (file, text);
        }
        Intent::Changed
    } else {
        let mut other = model.problem_of(read);
        other.mark_unsaved();
        (other.document.file, other.document.commented) = (file, text);
        Intent::Replace(Box::new(other))
    };
    vec![intent, Intent::Say("edited problem loaded, not saved yet".into())]
}

/// Puts what was read in the place of what is there, as a change that can be taken back.
fn take(model: &mut Model, read: ProblemFile) {
    let read = model.problem_of(read);
    if let Some(bench) = &mut model.bench {
        let document = &mut bench.problem.document;
        (document.title, document.origin) = (read.document.title, read.document.origin);
        (document.units, document.show) = (read.document.units, read.document.show);
        document.title_block = read.document.title_block;
        (document.linked, bench.problem.inputs.notes) = (read.document.linked, read.inputs.notes);
        bench.problem.inputs.form.replace(read.inputs.form.entry(), read.inputs.form.draft);
    }
}
