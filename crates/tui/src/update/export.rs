//! The worked solution as a file, with its figures; and the plot or drawing that is seen.
//!
//! A document of Word is written where the feature `word` is on.

use std::path::{Path, PathBuf};

use dalembert_core::{Locale, Text, cases::Case};
use dalembert_report::{Document, DocumentFormat, NoteSource, Parts, WorkedProblem, document};
use dalembert_units::Style;

use crate::{
    dialog::{Answer, Dialog, Purpose},
    effect::Effect,
    files::{Before, FileError, shown},
    glyphs::filter_untrusted,
    intent::Intent,
    model::Model,
    pane::Tab,
    problem::{Freshness, Problem},
    view,
};

/// Reports that a name is none of a worked solution.
const NOTES: &str = if cfg!(feature = "word") {
    "enter a name ending in .html, .tex, .typ, .md, .docx or .txt"
} else {
    "enter a name ending in .html, .tex, .typ, .md or .txt"
};

/// Asks for the file of what is exported; its ending says what is written.
pub(super) fn ask_path(model: &Model, purpose: Purpose) -> Vec<Intent> {
    if model.readonly && !model.is_replay {
        return vec![Intent::Refuse];
    }
    if let Some(why) = hindrance(model, purpose) {
        return vec![Intent::Complain(why)];
    }
    let Some(bench) = &model.bench else { return Vec::new() };
    let name = bench.problem.entry().about.id.rsplit('/').next().unwrap_or("solution");
    let file = bench.problem.document.file.as_ref().map(|file| &file.path);
    let proposed = match (file, purpose, picture(model)) {
        (_, Purpose::ExportSeen, Some(tab)) => {
            let (kind, _) = bench.pane(tab).file_names();
            let number = bench.place_of_shown(tab).map_or_else(String::new, |(n, _)| format!("-{n}"));
            let stem = file.and_then(|path| path.file_stem());
            let stem = stem.map_or(name.into(), |stem| stem.to_string_lossy());
            let name = format!("{stem}-{kind}{number}.svg");
            file.map_or_else(|| name.clone(), |path| path.with_file_name(&name).display().to_string())
        }
        (Some(path), ..) => path.with_extension("html").display().to_string(),
        (None, ..) => format!("{name}.html"),
    };
    vec![Intent::Show(Dialog::prompt(purpose, proposed))]
}

/// Writes what is exported.
pub(super) fn write(model: &Model, purpose: Purpose, path: PathBuf, before: Before) -> Vec<Intent> {
    if model.readonly {
        return vec![Intent::Refuse];
    }
    if let Some(why) = hindrance(model, purpose) {
        return vec![Intent::Complain(why)];
    }
    let Some(bench) = &model.bench else { return Vec::new() };
    let ending = if purpose == Purpose::ExportSeen { "svg" } else { "html" };
    let path = if path.extension().is_none() { path.with_extension(ending) } else { path };
    // Paper knows every character, whatever the screen does.
    let style = Style { ascii: false, ..model.locale.style };
    let locale = Locale { style, ..model.locale };
    let (files, why) = match (purpose, picture(model)) {
        (Purpose::ExportSeen, Some(tab)) => {
            let pane = bench.pane(tab);
            let ending = path.extension().and_then(|ending| ending.to_str()).map(str::to_ascii_lowercase);
            let text = ending.and_then(|ending| pane.file(&bench.problem, &ending, &locale));
            (text.map(|text| vec![(path.clone(), text.into_bytes())]), pane.file_names().1.into())
        }
        _ => match files(&bench.problem, &path, &locale) {
            Ok(files) => (files, NOTES.into()),
            Err(why) => (None, why),
        },
    };
    match files {
        Some(files) => vec![Intent::Do(Effect::Export { files, before })],
        None => vec![Intent::Show(Dialog::prompt_again(purpose, path.display().to_string(), why))],
    }
}

/// Says where it is, or what stands in its way.
pub(super) fn written(path: &Path, result: Result<(), FileError>) -> Vec<Intent> {
    let purpose = if is_note(path) { Purpose::Export } else { Purpose::ExportSeen };
    match result {
        Ok(()) => {
            let said = match purpose {
                Purpose::ExportSeen => Text::new("plot or drawing written to {file}"),
                _ => Text::new("worked solution written to {file}"),
            };
            Intent::say(said.with("file", shown(path)))
        }
        Err(FileError::Exists(_)) => vec![Intent::Show(Dialog::Ask {
            question: Text::new("{file} already exists.").with("file", shown(path)),
            answers: vec![
                ("write under another name", Answer::ExportAs(purpose)),
                ("overwrite", Answer::ExportOver(purpose, path.to_owned())),
                ("stay", Answer::Cancel),
            ],
            chosen: 0,
        })],
        Err(error) => {
            let typed = path.display().to_string();
            vec![Intent::Show(Dialog::prompt_again(purpose, typed, error.text()))]
        }
    }
}

/// Reason for which nothing can be exported now.
fn hindrance(model: &Model, purpose: Purpose) -> Option<Text> {
    let bench = model.bench.as_ref()?;
    let found = &bench.problem.found;
    if found.state != Freshness::Current || found.solution.is_none() {
        return Some("no solution to export for these inputs".into());
    }
    if purpose != Purpose::ExportSeen {
        return None;
    }
    match picture(model) {
        None => Some("no plot or drawing on the screen".into()),
        Some(tab) => bench.pane(tab).hindrance(&bench.problem),
    }
}

/// The pane of the picture that is seen: the chosen one, or the first beside it.
fn picture(model: &Model) -> Option<Tab> {
    let bench = model.bench.as_ref()?;
    let areas = view::areas_of(model, bench, bench.focus);
    let has_picture = |tab: &Tab| bench.pane(*tab).pictures(&bench.problem) > 0;
    let is_seen = |tab: &Tab| areas.area_of(*tab).is_some();
    [bench.tab].into_iter().chain(bench.all_tabs().filter(is_seen)).find(has_picture)
}

/// True for the name of a worked solution, by its ending.
fn is_note(path: &Path) -> bool {
    is_word(path) || DocumentFormat::of(path).is_some()
}

/// True for the name of a document of Word, where one can be written.
fn is_word(path: &Path) -> bool {
    cfg!(feature = "word") && path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("docx"))
}

/// The worked solution as files, the note itself first; `None` without a solution, and of a name that is none of a note.
fn files(problem: &Problem, path: &Path, locale: &Locale) -> Result<Option<Vec<(PathBuf, Vec<u8>)>>, Text> {
    let Some(document) = document_of(problem, locale) else { return Ok(None) };
    let source = NoteSource::new(problem.as_text(), &[], Parts::Full, locale);
    #[cfg(feature = "word")]
    if is_word(path) {
        let bytes = dalembert_report::docx(&document, &source, locale)?;
        return Ok(Some(vec![(path.to_owned(), bytes)]));
    }
    let files = DocumentFormat::of(path).and_then(|paper| source.files(paper, &document, path, locale));
    let beside = |(name, text): (String, String)| (path.with_file_name(name), text.into_bytes());
    Ok(files.map(|files| files.into_iter().map(beside).collect()))
}

/// The document of the worked solution; `None` without one.
fn document_of(problem: &Problem, locale: &Locale) -> Option<Document> {
    let record = problem.inputs.form.draft.read(&problem.entry().shape()).ok()?;
    let unchanged =
        |case: &&Case| problem.document.title.is_empty() && case.draft == problem.inputs.form.draft;
    let case = problem.document.origin.as_ref().filter(unchanged);
    let title = case.map_or_else(|| Text::verbatim(&problem.document.title), Case::title);
    let none = Text::from("");
    let worked = WorkedProblem {
        entry: problem.entry(),
        case: &title,
        source: case.map_or(&none, |case| &case.source),
        statement: case.map_or(&none, |case| &case.statement),
        note: case.map_or(&none, |case| &case.note),
        notes: &problem.inputs.notes,
        draft: &problem.inputs.form.draft,
        record: &record,
        outcome: Ok(problem.found.solution.as_ref()?),
    };
    let document = document(&worked, locale).under(&problem.document.title_block, locale);
    Some(document.map(&|words| filter_untrusted(words).into_owned()))
}
