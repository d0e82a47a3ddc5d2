//! Problem files: opening, saving, and what a crashed session left.

use std::path::{Path, PathBuf};

use dalembert_core::{Draft, FieldError, Text, file};

use crate::{
    dialog::{Answer, Dialog, Purpose},
    effect::Effect,
    files::{
        self, Before, Crashed, Fingerprint, LinkedTexts, Opened, faults, holds_data, is_same_file, shown,
    },
    intent::Intent,
    keys::{Action, KeyContext},
    model::Model,
    problem::{OpenFile, Problem},
};

/// Extension of problem files.
const ENDING: &str = "toml";

/// Saves the problem in its file, or asks for one.
pub(super) fn save(model: &mut Model) -> Vec<Intent> {
    if model.readonly && !model.is_replay {
        return vec![Intent::Refuse];
    }
    match model.bench.as_ref().and_then(|bench| bench.problem.document.file.as_ref()) {
        Some(file) => {
            let before = file.fingerprint.map_or(Before::Absent, Before::Was);
            write(model, file.path.clone(), before)
        }
        None => ask_path(model),
    }
}

/// Saves under another name, which must be free.
pub(super) fn save_as(model: &mut Model, path: PathBuf) -> Vec<Intent> {
    let path = if path.extension().is_none() { path.with_extension(ENDING) } else { path };
    let own = model
        .bench
        .as_ref()
        .and_then(|bench| bench.problem.document.file.as_ref())
        .filter(|file| file.path == path);
    let before = own.and_then(|file| file.fingerprint).map_or(Before::Absent, Before::Was);
    write(model, path, before)
}

/// Saves over whatever is there.
pub(super) fn overwrite(model: &mut Model, path: PathBuf) -> Vec<Intent> {
    write(model, path, Before::Whatever)
}

/// Asks for a path to save under.
pub(super) fn ask_path(model: &mut Model) -> Vec<Intent> {
    if model.readonly && !model.is_replay {
        return vec![Intent::Refuse];
    }
    let Some(bench) = &model.bench else { return Vec::new() };
    let proposed = match &bench.problem.document.file {
        Some(file) => file.path.display().to_string(),
        None => format!("{}.toml", bench.problem.entry().about.id.rsplit('/').next().unwrap_or("problem")),
    };
    vec![Intent::Show(Dialog::prompt(Purpose::SaveAs, proposed))]
}

/// Takes that the problem is in its file now, or asks what to do where it is not.
pub(super) fn saved(
    model: &mut Model,
    path: &Path,
    text: String,
    result: Result<Fingerprint, files::FileError>,
) -> Vec<Intent> {
    let changed = "{file} was changed by another program since it was opened.";
    let overwrite = ("overwrite", Answer::Overwrite(path.to_owned()));
    let rename = ("save under another name", Answer::SaveAs);
    let stay = ("stay", Answer::Cancel);
    match result {
        Ok(fingerprint) => {
            let after = std::mem::take(&mut model.after_save);
            for document in model.problems_mut().map(|bench| &mut bench.problem.document) {
                if let Some(file) = &document.file {
                    document.links.take(&file.path, path, &text);
                }
            }
            let Some(bench) = &mut model.bench else { return vec![Intent::SaveThen(after)] };
            let problem = &mut bench.problem;
            // Field mode saves on the way, and its keys stay in sight.
            let is_silent =
                bench.field.is_some() && problem.document.file.as_ref().is_some_and(|file| file.path == path);
            let before = problem.document.file.as_ref().and_then(|file| file.path.parent());
            if before != path.parent() {
                // What it links to lies beside it.
                problem.document.links = LinkedTexts::default();
            }
            problem.document.file =
                Some(OpenFile { path: path.to_owned(), text, fingerprint: Some(fingerprint) });
            problem.mark_saved();
            let said = Text::new("saved as {file}").with("file", shown(path));
            let said = (!is_silent).then_some(Intent::Say(said));
            let rest =
                [Intent::Do(Effect::Forget(problem.number)), Intent::FollowLinks, Intent::SaveThen(after)];
            said.into_iter().chain(rest).collect()
        }
        Err(files::FileError::Changed(_) | files::FileError::Removed(_)) => {
            let lose = "reload the file and lose the changes made here";
            ask(changed, path, vec![rename, (lose, Answer::Reload(path.to_owned())), overwrite, stay])
        }
        Err(files::FileError::Exists(_)) => {
            ask("{file} already exists.", path, vec![rename, overwrite, stay])
        }
        Err(error) => {
            let typed = path.display().to_string();
            vec![Intent::Show(Dialog::prompt_again(Purpose::SaveAs, typed, error.text()))]
        }
    }
}

/// Opens what was read as a problem, or says why it is none.
pub(super) fn opened(
    model: &mut Model,
    path: PathBuf,
    result: Result<Opened, files::FileError>,
) -> Vec<Intent> {
    let reloading = model.reloading.take().is_some_and(|reloaded| reloaded == path);
    let is_there = !matches!(result, Err(files::FileError::Missing(_) | files::FileError::Folder(_)));
    if holds_data(&path) && is_there {
        let title = Text::new("{file} holds data, not a problem").with("file", shown(&path));
        let how =
            Text::new("Open an analysis that has a table, move to it, and import the file there with {key}.")
                .with("key", model.key(KeyContext::Form, Action::Import));
        let lines = vec![how.render(&model.locale)];
        return vec![Intent::Show(Dialog::Message { title, lines }), Intent::Preview];
    }
    let opened = match result {
        Ok(opened) => opened,
        // A save writes the ending that is not typed.
        Err(files::FileError::Missing(_)) if path.extension().is_none() => {
            return vec![Intent::Do(Effect::Open(path.with_extension(ENDING)))];
        }
        Err(error) => {
            let typed = path.display().to_string();
            let again = Dialog::prompt_again(Purpose::Open, typed, error.text());
            return vec![Intent::Show(again), Intent::Preview];
        }
    };
    let read = match model.parse(Some(&path), &opened.text, &opened.linked) {
        Ok(read) => read,
        Err(errors) => {
            let title = Text::new("{file} cannot be opened as a problem").with("file", shown(&path));
            let lines = faults(&opened.text, &errors, &model.locale);
            return vec![Intent::Show(Dialog::Message { title, lines }), Intent::Preview];
        }
    };
    let mut problem = model.problem_of(read);
    let of_file = |problem: &Problem| {
        problem.document.file.as_ref().is_some_and(|file| is_same_file(&file.path, &path))
    };
    let open = model.problems().into_iter().map(|bench| &bench.problem).find(|problem| of_file(problem));
    let open = open.map(|problem| (problem.number, problem.is_unsaved()));
    problem.document.links = opened.linked;
    problem.document.file = Some(OpenFile { path, text: opened.text, fingerprint: Some(opened.fingerprint) });
    match open {
        None => {
            let notes = read_otherwise(&problem.inputs.notes);
            [Intent::Open(Box::new(problem))].into_iter().chain(notes.map(Intent::Say)).collect()
        }
        Some((number, true)) if !reloading => {
            model.dialog = None;
            let said = "this file is already open, with unsaved changes".into();
            vec![Intent::Bring(number), Intent::Say(said)]
        }
        Some((number, _)) => vec![Intent::Bring(number), Intent::Replace(Box::new(problem))],
    }
}

/// A message about how a file of an older format was read.
fn read_otherwise(notes: &[Text]) -> Option<Text> {
    let (note, more) = notes.split_first()?;
    if more.is_empty() {
        return Some(note.clone());
    }
    let said = Text::new("{note}; and {more} more of this kind").with_text("note", note.clone());
    Some(said.with("more", more.len()))
}

/// Has the files read that the problem links to, where an input links to one that is not read, or none is from where the
/// problem is now.
pub(super) fn follow_links(model: &Model) -> Vec<Intent> {
    let Some(problem) = model.bench.as_ref().map(|bench| &bench.problem) else { return Vec::new() };
    let (form, shape) = (&problem.inputs.form, problem.entry().shape());
    let is_link = |error: &FieldError| match form.draft.at(&shape, &error.path) {
        Ok((Draft::Leaf(text), _)) => text.contains('@'),
        _ => false,
    };
    let has_files = problem.entry().linked().iter().any(|linked| linked.file.is_some());
    let is_unread = has_files && problem.document.links.is_empty();
    match &problem.document.file {
        Some(file) if is_unread || problem.wrong().any(is_link) => {
            let (path, text) = (file.path.clone(), problem.as_text());
            vec![Intent::Do(Effect::ReadLinked { problem: problem.number, path, text })]
        }
        _ => Vec::new(),
    }
}

/// Takes the texts of the files that a problem links to.
pub(super) fn linked_read(model: &mut Model, number: u64, links: LinkedTexts) -> Vec<Intent> {
    match model.bench.as_mut().map(|bench| &mut bench.problem) {
        Some(problem) if problem.number == number => problem.document.links = links,
        _ => return Vec::new(),
    }
    read_linked(model)
}

/// Reads the linked files of the shown problem again, where they are not as they were read: one that is open was changed
/// there, or closed.
pub(super) fn read_linked(model: &mut Model) -> Vec<Intent> {
    let Some(problem) = model.bench.as_ref().map(|bench| &bench.problem) else { return Vec::new() };
    let document = &problem.document;
    if document.links.is_empty() {
        return Vec::new();
    }
    let path = document.file.as_ref().map(|file| file.path.as_path());
    match model.parse(path, &problem.as_text(), &document.links) {
        Ok(read) if read.files == document.linked => Vec::new(),
        Ok(read) => {
            if let Some(bench) = &mut model.bench {
                bench.problem.take_files(read);
            }
            vec![Intent::Changed]
        }
        Err(errors) => {
            let why = errors.into_iter().next().map_or_else(Text::default, |error| error.why);
            Intent::report_error(why)
        }
    }
}

/// Asks what becomes of the work of sessions that ended without saving.
pub(super) fn crashed(model: &Model, sessions: Vec<Crashed>) -> Vec<Intent> {
    let Some(newest) = sessions.first() else { return Vec::new() };
    let ended = match newest.kept.elapsed().map_or(0, |past| past.as_secs() / 60) {
        0 => Text::new("just now"),
        minutes => Text::new("{minutes} min ago").with("minutes", minutes),
    };
    let question = match sessions.len() {
        1 => {
            let name = match &newest.original {
                Some(path) => shown(path),
                None => name_of(model, newest),
            };
            Text::new("The previous session ended {ended} without saving {name}; it can be recovered.")
                .with("name", name)
        }
        count => {
            let names: Vec<String> = sessions.iter().map(|crashed| name_of(model, crashed)).collect();
            Text::new("The previous session ended {ended} without saving {count} problems ({names}); they can be recovered.")
                .with("count", count)
                .with("names", names.join("; "))
        }
    };
    vec![Intent::Show(Dialog::Ask {
        question: question.with_text("ended", ended),
        answers: vec![
            ("recover", Answer::Restore(sessions.clone())),
            ("ask again at the next start", Answer::Cancel),
            ("discard", Answer::Forget(sessions)),
        ],
        chosen: 0,
    })]
}

/// Takes up the work of crashed sessions, the newest last; it is unsaved.
pub(super) fn restore(model: &Model, sessions: Vec<Crashed>) -> Vec<Intent> {
    let mut intents = Vec::new();
    let (mut restored, mut unread) = (0, false);
    let room = model.room();
    for crashed in sessions.into_iter().rev() {
        // Where a linked file is gone, the error is that of the input.
        let read = model.parse(crashed.original.as_deref(), &crashed.text, &crashed.linked);
        let Ok(read) = read.or_else(|_| file::parse_unlinked(&crashed.text)) else {
            unread = true;
            continue;
        };
        let mut problem = model.problem_of(read);
        problem.document.links = crashed.linked.clone();
        // What the file holds now is not known: saving asks before it writes over it.
        problem.document.file = crashed.original.clone().map(|path| OpenFile {
            path,
            text: crashed.text.clone(),
            fingerprint: None,
        });
        problem.mark_unsaved();
        intents.push(Intent::Open(Box::new(problem)));
        if restored == room {
            // There is no room for more, which is said; what is left is offered at the next start.
            return intents;
        }
        if !model.readonly {
            intents.push(Intent::Do(Effect::Discard(crashed)));
        }
        restored += 1;
    }
    intents.push(match restored {
        _ if unread => Intent::Complain(
            "the work of the previous session cannot be read; its file is left unchanged".into(),
        ),
        0 | 1 => Intent::Say("work of the previous session recovered, not saved yet".into()),
        count => Intent::Say(
            Text::new("{count} problems of the previous session recovered, not saved yet; b shows the next")
                .with("count", count),
        ),
    });
    intents
}

/// Name of recovered work: its file, or its title and its analysis.
fn name_of(model: &Model, crashed: &Crashed) -> String {
    match (&crashed.original, file::parse_unlinked(&crashed.text)) {
        (Some(path), _) => shown(Path::new(path.file_name().unwrap_or(path.as_os_str()))),
        (None, Ok(problem)) => {
            let analysis = Text::from(problem.entry.about.title).render(&model.locale);
            match problem.title.as_str() {
                "" => analysis,
                title => format!("{analysis}, {title}"),
            }
        }
        (None, Err(_)) => Text::from("a problem without a file").render(&model.locale),
    }
}

/// The text of a problem goes to a file, with its comments.
fn write(model: &mut Model, path: PathBuf, before: Before) -> Vec<Intent> {
    if model.readonly {
        return vec![Intent::Refuse];
    }
    let Some(bench) = &mut model.bench else { return Vec::new() };
    let problem = &mut bench.problem;
    problem.inputs.form.keep();
    let text = problem.as_text();
    vec![Intent::Do(Effect::Save { path, text, before })]
}

fn ask(question: &'static str, path: &Path, answers: Vec<(&'static str, Answer)>) -> Vec<Intent> {
    let question = Text::new(question).with("file", shown(path));
    vec![Intent::Show(Dialog::Ask { question, answers, chosen: 0 })]
}
