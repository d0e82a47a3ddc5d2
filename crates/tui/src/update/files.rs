//! Problem files: opening, saving, and what a crashed session left.

use std::path::{Path, PathBuf};

use dalembert_core::{
    Text,
    file::{self, Problem},
};

use super::{judged_later, list, problems};
use crate::{
    bench::{Bench, OpenFile},
    dialog::{After, Answer, Dialog, Purpose},
    files::{Before, Crashed, FileError, Fingerprint, Opened, holds_data, shown},
    glyphs::filter_untrusted,
    keys::{Action, Place},
    model::{Effect, Model},
};

/// How the name of a problem file ends.
const ENDING: &str = "toml";
/// So many faults of a file are listed.
const MOST_FAULTS: usize = 8;

/// Saves the problem in its file, or asks for one.
pub(super) fn save(model: &mut Model) -> Vec<Effect> {
    if model.readonly && !model.played {
        return refuse(model);
    }
    match model.bench.as_ref().and_then(|bench| bench.file.as_ref()) {
        Some(file) => {
            let before = file.fingerprint.map_or(Before::Absent, Before::Was);
            write(model, file.path.clone(), before)
        }
        None => ask_path(model),
    }
}

/// Saves under another name, which must be free.
pub(super) fn save_as(model: &mut Model, path: PathBuf) -> Vec<Effect> {
    let path = if path.extension().is_none() { path.with_extension(ENDING) } else { path };
    let own = model.bench.as_ref().and_then(|bench| bench.file.as_ref()).filter(|file| file.path == path);
    let before = own.and_then(|file| file.fingerprint).map_or(Before::Absent, Before::Was);
    write(model, path, before)
}

/// Saves over whatever is there.
pub(super) fn overwrite(model: &mut Model, path: PathBuf) -> Vec<Effect> {
    write(model, path, Before::Whatever)
}

/// Asks for a path to save under.
pub(super) fn ask_path(model: &mut Model) -> Vec<Effect> {
    if model.readonly && !model.played {
        return refuse(model);
    }
    let Some(bench) = &model.bench else { return Vec::new() };
    let proposed = match &bench.file {
        Some(file) => file.path.display().to_string(),
        None => format!("{}.toml", bench.entry.about.id.rsplit('/').next().unwrap_or("problem")),
    };
    model.dialog = Some(Dialog::prompt(Purpose::SaveAs, proposed));
    Vec::new()
}

pub(super) fn saved(
    model: &mut Model,
    path: &Path,
    text: String,
    result: Result<Fingerprint, FileError>,
) -> Vec<Effect> {
    match result {
        Ok(fingerprint) => {
            let Some(bench) = &mut model.bench else { return Vec::new() };
            bench.file = Some(OpenFile { path: path.to_owned(), text, fingerprint: Some(fingerprint) });
            bench.mark_saved();
            let effects = vec![Effect::Forget(bench.number)];
            model.say(Text::new("saved as {file}").with("file", shown(path)));
            effects
        }
        Err(FileError::Changed(_) | FileError::Removed(_)) => {
            ask(
                model,
                "{file} was changed by another program since it was opened.",
                path,
                vec![
                    ("save under another name", Answer::SaveAs),
                    ("reload the file and lose the changes made here", Answer::Reload(path.to_owned())),
                    ("overwrite", Answer::Overwrite(path.to_owned())),
                    ("stay", Answer::Cancel),
                ],
            );
            Vec::new()
        }
        Err(FileError::Exists(_)) => {
            ask(
                model,
                "{file} already exists.",
                path,
                vec![
                    ("save under another name", Answer::SaveAs),
                    ("overwrite", Answer::Overwrite(path.to_owned())),
                    ("stay", Answer::Cancel),
                ],
            );
            Vec::new()
        }
        Err(error) => {
            let typed = path.display().to_string();
            model.dialog = Some(Dialog::prompt_again(Purpose::SaveAs, typed, error.text()));
            Vec::new()
        }
    }
}

pub(super) fn opened(model: &mut Model, path: PathBuf, result: Result<Opened, FileError>) -> Vec<Effect> {
    let reloading = model.reloading.take().is_some_and(|reloaded| reloaded == path);
    let is_there = !matches!(result, Err(FileError::Missing(_) | FileError::Folder(_)));
    if holds_data(&path) && is_there {
        let title = Text::new("{file} holds data, not a problem").with("file", shown(&path));
        let how =
            Text::new("Open an analysis that has a table, move to it, and import the file there with {key}.")
                .with("key", model.key(Place::Form, Action::Import));
        model.dialog = Some(Dialog::Message { title, lines: vec![how.render(&model.locale)] });
        return list::preview(model);
    }
    let opened = match result {
        Ok(opened) => opened,
        // A save writes the ending that is not typed.
        Err(FileError::Missing(_)) if path.extension().is_none() => {
            return vec![Effect::Open(path.with_extension(ENDING))];
        }
        Err(error) => {
            let typed = path.display().to_string();
            model.dialog = Some(Dialog::prompt_again(Purpose::Open, typed, error.text()));
            return list::preview(model);
        }
    };
    match file::parse(&opened.text) {
        Ok(problem) => {
            let mut bench = bench_of(model, problem);
            let of_file = |bench: &&Bench| bench.file.as_ref().is_some_and(|file| file.path == path);
            let open =
                model.problems().into_iter().find(of_file).map(|bench| (bench.number, bench.is_unsaved()));
            bench.file = Some(OpenFile { path, text: opened.text, fingerprint: Some(opened.fingerprint) });
            match open {
                None => {
                    let notes = bench.notes.clone();
                    let effects = problems::open(model, bench);
                    tell(model, &notes);
                    effects
                }
                Some((number, unsaved)) => {
                    let mut effects = problems::bring(model, number);
                    if unsaved && !reloading {
                        model.dialog = None;
                        model.say("this file is already open, with unsaved changes");
                    } else {
                        effects.extend(problems::replace(model, bench));
                    }
                    effects
                }
            }
        }
        Err(errors) => {
            let title = Text::new("{file} cannot be opened as a problem").with("file", shown(&path));
            let lines = faults(model, &opened.text, &errors);
            model.dialog = Some(Dialog::Message { title, lines });
            list::preview(model)
        }
    }
}

/// Says how a file of an older format was read.
fn tell(model: &mut Model, notes: &[Text]) {
    match notes {
        [] => {}
        [note] => model.say(note.clone()),
        [note, more @ ..] => {
            let said = Text::new("{note}; and {more} more of this kind").with_text("note", note.clone());
            model.say(said.with("more", more.len()));
        }
    }
}

/// What is wrong with the text of a problem, each with its line.
pub(super) fn faults(model: &Model, text: &str, errors: &[file::FileError]) -> Vec<String> {
    let line = |span: &Option<std::ops::Range<usize>>| {
        let at = span.as_ref()?.start.min(text.len());
        Some(1 + text.get(..at)?.matches('\n').count())
    };
    let mut lines: Vec<String> = errors
        .iter()
        .take(MOST_FAULTS)
        .map(|error| {
            let text = match line(&error.span) {
                Some(line) => Text::new("line {line}: {why}").with("line", line),
                None => Text::new("{why}"),
            };
            filter_untrusted(&text.with_text("why", error.why.clone()).render(&model.locale)).into_owned()
        })
        .collect();
    if errors.len() > MOST_FAULTS {
        let more = Text::new("and {more} more").with("more", errors.len() - MOST_FAULTS);
        lines.push(more.render(&model.locale));
    }
    lines
}

/// Asks what becomes of the work of sessions that ended without saving.
pub(super) fn crashed(model: &mut Model, sessions: Vec<Crashed>) {
    let Some(newest) = sessions.first() else { return };
    let minutes = newest.kept.elapsed().map_or(0, |past| past.as_secs() / 60);
    let question = match sessions.len() {
        1 => {
            let name = match &newest.original {
                Some(path) => shown(path),
                None => name_of(model, newest),
            };
            Text::new(
                "The previous session ended {minutes} min ago without saving {name}; it can be recovered.",
            )
            .with("name", name)
        }
        count => {
            let names: Vec<String> = sessions.iter().map(|crashed| name_of(model, crashed)).collect();
            Text::new("The previous session ended {minutes} min ago without saving {count} problems ({names}); they can be recovered.")
                .with("count", count)
                .with("names", names.join("; "))
        }
    };
    model.dialog = Some(Dialog::Ask {
        question: question.with("minutes", minutes),
        answers: vec![
            ("recover", Answer::Restore(sessions.clone())),
            ("ask again at the next start", Answer::Cancel),
            ("discard", Answer::Forget(sessions)),
        ],
        chosen: 0,
    });
}

/// Takes up the work of crashed sessions, the newest last; it is unsaved.
pub(super) fn restore(model: &mut Model, sessions: Vec<Crashed>) -> Vec<Effect> {
    let mut effects = Vec::new();
    let (mut restored, mut unread) = (0, false);
    for crashed in sessions.into_iter().rev() {
        let Ok(problem) = file::parse(&crashed.text) else {
            unread = true;
            continue;
        };
        let mut bench = bench_of(model, problem);
        // What the file holds now is not known: saving asks before it writes over it.
        bench.file = crashed.original.clone().map(|path| OpenFile {
            path,
            text: crashed.text.clone(),
            fingerprint: None,
        });
        bench.mark_unsaved();
        let before = model.bench.as_ref().map(|bench| bench.number);
        effects.extend(problems::open(model, bench));
        if model.bench.as_ref().map(|bench| bench.number) == before {
            // There is no room for more, which is said; what is left is offered at the next start.
            return effects;
        }
        if !model.readonly {
            effects.push(Effect::Discard(crashed));
        }
        restored += 1;
    }
    match restored {
        _ if unread => {
            model.complain("the work of the previous session cannot be read; its file is left unchanged");
        }
        0 | 1 => model.say("work of the previous session recovered, not saved yet"),
        count => model.say(
            Text::new("{count} problems of the previous session recovered, not saved yet; b shows the next")
                .with("count", count),
        ),
    }
    effects
}

/// What crashed work is called: its file, or its title and its analysis.
fn name_of(model: &Model, crashed: &Crashed) -> String {
    match (&crashed.original, file::parse(&crashed.text)) {
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

/// Says why nothing is saved.
pub(super) fn refuse(model: &mut Model) -> Vec<Effect> {
    model.after_save = After::Stay;
    model.complain("not saved: the program is read-only");
    Vec::new()
}

/// The text of a problem goes to a file, with its comments.
fn write(model: &mut Model, path: PathBuf, before: Before) -> Vec<Effect> {
    if model.readonly {
        return refuse(model);
    }
    let Some(bench) = &mut model.bench else { return Vec::new() };
    bench.form.keep();
    let text = file::write(&bench.problem(), bench.text());
    vec![Effect::Save { path, text, before }]
}

pub(super) fn bench_of(model: &Model, problem: Problem) -> Bench {
    let cases = judged_later(model, problem.entry);
    // A file that has the name of a case as its title holds that case, or held it before a change.
    let named = cases.iter().map(|judged| &judged.case).find(|case| case.name == problem.title).cloned();
    let title = if named.is_some() { String::new() } else { problem.title };
    let mut bench = Bench::new(problem.entry, title, problem.draft, cases);
    bench.origin = named;
    (bench.show, bench.notes) = (problem.show, problem.notes);
    bench
}

fn ask(model: &mut Model, question: &'static str, path: &Path, answers: Vec<(&'static str, Answer)>) {
    let question = Text::new(question).with("file", shown(path));
    model.dialog = Some(Dialog::Ask { question, answers, chosen: 0 });
}
