//! The worked solution as a file, with its figures.

use std::path::{Path, PathBuf};

use dalembert_core::{Locale, Text, cases::Case};
use dalembert_report::{Paper, Worked, document};
use dalembert_units::Style;

use crate::{
    bench::{Bench, State},
    dialog::{Answer, Dialog, Purpose},
    files::{Before, FileError, shown},
    glyphs::filter_untrusted,
    model::{Effect, Model},
};

/// Asks for the file of the worked solution; its ending says what is written.
pub(super) fn ask_path(model: &mut Model) -> Vec<Effect> {
    if let Some(why) = hindrance(model) {
        model.complain(why);
        return Vec::new();
    }
    let Some(bench) = &model.bench else { return Vec::new() };
    let proposed = match &bench.file {
        Some(file) => file.path.with_extension("html").display().to_string(),
        None => format!("{}.html", bench.entry.about.id.rsplit('/').next().unwrap_or("solution")),
    };
    model.dialog = Some(Dialog::prompt(Purpose::Export, proposed));
    Vec::new()
}

/// Writes the worked solution.
pub(super) fn write(model: &mut Model, path: PathBuf, before: Before) -> Vec<Effect> {
    if let Some(why) = hindrance(model) {
        model.complain(why);
        return Vec::new();
    }
    let Some(bench) = &model.bench else { return Vec::new() };
    let path = if path.extension().is_none() { path.with_extension("html") } else { path };
    let files = Paper::of(&path).and_then(|paper| files(bench, paper, &path, &model.locale));
    match files {
        Some(files) => vec![Effect::Export { files, before }],
        None => {
            let why = "write a name that ends in .html, .tex, .typ, .md or .txt".into();
            model.dialog = Some(Dialog::prompt_again(Purpose::Export, path.display().to_string(), why));
            Vec::new()
        }
    }
}

/// Says where the worked solution is, or what stands in its way.
pub(super) fn written(model: &mut Model, path: &Path, result: Result<(), FileError>) -> Vec<Effect> {
    match result {
        Ok(()) => model.say(Text::new("the worked solution is in {file}").with("file", shown(path))),
        Err(FileError::Exists(_)) => {
            model.dialog = Some(Dialog::Ask {
                question: Text::new("{file} exists already.").with("file", shown(path)),
                answers: vec![
                    ("write under another name", Answer::ExportAs),
                    ("write over it", Answer::ExportOver(path.to_owned())),
                    ("stay", Answer::Cancel),
                ],
                chosen: 0,
            });
        }
        Err(error) => {
            let typed = path.display().to_string();
            model.dialog = Some(Dialog::prompt_again(Purpose::Export, typed, error.text()));
        }
    }
    Vec::new()
}

/// Why nothing can be exported now.
fn hindrance(model: &Model) -> Option<Text> {
    let bench = model.bench.as_ref()?;
    if model.readonly {
        Some("nothing is saved: the program was started read-only".into())
    } else if bench.found.state != State::Current || bench.found.solution.is_none() {
        Some("there is no solution of these inputs to export".into())
    } else {
        None
    }
}

fn files(bench: &Bench, paper: Paper, path: &Path, locale: &Locale) -> Option<Vec<(PathBuf, String)>> {
    let record = bench.form.draft.read(&bench.entry.shape()).ok()?;
    let problem = bench.problem();
    let unchanged = |case: &&Case| bench.title.is_empty() && case.draft == bench.form.draft;
    let case = bench.origin.as_ref().filter(unchanged);
    let worked = Worked {
        entry: bench.entry,
        case: &problem.title,
        source: case.map_or("", |case| case.source.as_str()),
        note: case.map_or("", |case| case.note.as_str()),
        draft: &bench.form.draft,
        record: &record,
        outcome: Ok(bench.found.solution.as_ref()?),
    };
    // Paper knows every character, whatever the screen does.
    let locale = Locale { style: Style { ascii: false, ..locale.style }, ..*locale };
    let document = document(&worked, &locale).map(&|words| filter_untrusted(words).into_owned());
    let files = paper.files(&document, path, &locale)?;
    Some(files.into_iter().map(|(name, text)| (path.with_file_name(name), text)).collect())
}
