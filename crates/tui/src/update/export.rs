//! The worked solution as a file, with its figures; and the plot or drawing that is seen.

use std::path::{Path, PathBuf};

use dalembert_core::{Locale, Text, cases::Case};
use dalembert_report::{
    Paper, Worked, document,
    figure::{self, Seen},
    plot_csv,
};
use dalembert_units::Style;
use ratatui::layout::Rect;

use crate::{
    bench::{Bench, State},
    dialog::{Answer, Dialog, Purpose},
    files::{Before, FileError, shown},
    glyphs::filter_untrusted,
    layout,
    model::{Effect, Model},
    tab::Tab,
};

/// Asks for the file of what is exported; its ending says what is written.
pub(super) fn ask_path(model: &mut Model, purpose: Purpose) -> Vec<Effect> {
    if model.readonly && !model.played {
        return super::files::refuse(model);
    }
    if let Some(why) = hindrance(model, purpose) {
        model.complain(why);
        return Vec::new();
    }
    let Some(bench) = &model.bench else { return Vec::new() };
    let name = bench.entry.about.id.rsplit('/').next().unwrap_or("solution");
    let proposed = match (&bench.file, purpose, picture(model)) {
        (_, Purpose::ExportSeen, Some(tab)) => {
            let kind = if tab == Tab::Plot { "plot" } else { "drawing" };
            let number = bench.place_of_shown(tab).map_or_else(String::new, |(n, _)| format!("-{n}"));
            let stem = bench.file.as_ref().and_then(|file| file.path.file_stem());
            let stem = stem.map_or(name.into(), |stem| stem.to_string_lossy());
            let name = format!("{stem}-{kind}{number}.svg");
            let beside =
                bench.file.as_ref().map(|file| file.path.with_file_name(&name).display().to_string());
            beside.unwrap_or(name)
        }
        (Some(file), ..) => file.path.with_extension("html").display().to_string(),
        (None, ..) => format!("{name}.html"),
    };
    model.dialog = Some(Dialog::prompt(purpose, proposed));
    Vec::new()
}

/// Writes what is exported.
pub(super) fn write(model: &mut Model, purpose: Purpose, path: PathBuf, before: Before) -> Vec<Effect> {
    if model.readonly {
        return super::files::refuse(model);
    }
    if let Some(why) = hindrance(model, purpose) {
        model.complain(why);
        return Vec::new();
    }
    let Some(bench) = &model.bench else { return Vec::new() };
    let ending = if purpose == Purpose::ExportSeen { "svg" } else { "html" };
    let path = if path.extension().is_none() { path.with_extension(ending) } else { path };
    // Paper knows every character, whatever the screen does.
    let style = Style { ascii: false, ..model.locale.style };
    let locale = Locale { style, ..model.locale };
    let (files, why) = match (purpose, picture(model)) {
        (Purpose::ExportSeen, Some(tab)) => {
            let why = if tab == Tab::Plot {
                "enter a name ending in .svg or .csv"
            } else {
                "enter a name ending in .svg"
            };
            (seen(bench, tab, &path, &locale).map(|text| vec![(path.clone(), text)]), why)
        }
        _ => (
            Paper::of(&path).and_then(|paper| files(bench, paper, &path, &locale)),
            "enter a name ending in .html, .tex, .typ, .md or .txt",
        ),
    };
    match files {
        Some(files) => vec![Effect::Export { files, before }],
        None => {
            model.dialog = Some(Dialog::prompt_again(purpose, path.display().to_string(), why.into()));
            Vec::new()
        }
    }
}

/// Says where it is, or what stands in its way.
pub(super) fn written(model: &mut Model, path: &Path, result: Result<(), FileError>) -> Vec<Effect> {
    let purpose = if Paper::of(path).is_some() { Purpose::Export } else { Purpose::ExportSeen };
    match result {
        Ok(()) => {
            let said = match purpose {
                Purpose::ExportSeen => Text::new("plot or drawing written to {file}"),
                _ => Text::new("worked solution written to {file}"),
            };
            model.say(said.with("file", shown(path)));
        }
        Err(FileError::Exists(_)) => {
            model.dialog = Some(Dialog::Ask {
                question: Text::new("{file} already exists.").with("file", shown(path)),
                answers: vec![
                    ("write under another name", Answer::ExportAs(purpose)),
                    ("overwrite", Answer::ExportOver(purpose, path.to_owned())),
                    ("stay", Answer::Cancel),
                ],
                chosen: 0,
            });
        }
        Err(error) => {
            let typed = path.display().to_string();
            model.dialog = Some(Dialog::prompt_again(purpose, typed, error.text()));
        }
    }
    Vec::new()
}

/// Why nothing can be exported now.
fn hindrance(model: &Model, purpose: Purpose) -> Option<Text> {
    let bench = model.bench.as_ref()?;
    if bench.found.state != State::Current || bench.found.solution.is_none() {
        return Some("no solution to export for these inputs".into());
    }
    if purpose != Purpose::ExportSeen {
        return None;
    }
    match picture(model) {
        None => Some("no plot or drawing on the screen".into()),
        Some(Tab::Plot) if bench.reading.revealed.is_some() => {
            Some("covered until every step of the working is revealed; t ends that".into())
        }
        Some(_) => None,
    }
}

/// The tab of the picture that is seen: the chosen one, or the first beside it.
fn picture(model: &Model) -> Option<Tab> {
    let bench = model.bench.as_ref()?;
    let (columns, rows) = model.size;
    let beside = layout::bench(Rect::new(0, 0, columns, rows), bench.focus, bench.expanded).picture.is_some();
    let all = [Tab::Plot, Tab::Drawing];
    all.into_iter()
        .find(|tab| bench.exhibits_of(*tab) > 0 && (bench.tab == *tab))
        .or_else(|| all.into_iter().find(|tab| bench.exhibits_of(*tab) > 0 && beside))
}

fn seen(bench: &Bench, tab: Tab, path: &Path, locale: &Locale) -> Option<String> {
    let ending = path.extension()?.to_str()?.to_ascii_lowercase();
    let picture = if tab == Tab::Plot {
        let (plot, pinned) = bench.shown_plot()?;
        let seen = Seen { view: bench.plot_state.view, cursor: bench.plot_state.cursor, pinned };
        if ending == "csv" {
            return plot_csv(plot, &seen, locale);
        }
        figure::plot(plot, &seen, locale)
    } else {
        figure::drawing(&*bench.drawing_seen()?, locale)
    };
    picture.filter(|_| ending == "svg").map(|picture| picture.svg())
}

fn files(bench: &Bench, paper: Paper, path: &Path, locale: &Locale) -> Option<Vec<(PathBuf, String)>> {
    let record = bench.form.draft.read(&bench.entry.shape()).ok()?;
    let unchanged = |case: &&Case| bench.title.is_empty() && case.draft == bench.form.draft;
    let case = bench.origin.as_ref().filter(unchanged);
    let title = case.map_or_else(|| Text::verbatim(&bench.title), Case::title);
    let none = Text::from("");
    let worked = Worked {
        entry: bench.entry,
        case: &title,
        source: case.map_or(&none, |case| &case.source),
        note: case.map_or(&none, |case| &case.note),
        notes: &bench.notes,
        draft: &bench.form.draft,
        record: &record,
        outcome: Ok(bench.found.solution.as_ref()?),
    };
    let document = document(&worked, locale).map(&|words| filter_untrusted(words).into_owned());
    let files = paper.files(&document, path, locale)?;
    Some(files.into_iter().map(|(name, text)| (path.with_file_name(name), text)).collect())
}
