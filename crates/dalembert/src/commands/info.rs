//! `dalembert info`

use std::{path::Path, process::ExitCode};

use dalembert_core::{Text, cases, registry};
use dalembert_report::{Block, Document, NamedValue};
use dalembert_tui::{
    files,
    glyphs::{Colors, Glyphs, PlotMarker},
};

use crate::{Set, console::Console, failure::Failure};

/// Shows what somebody who helps from afar asks for first.
pub(crate) fn run(set: &Set, console: &Console) -> Result<ExitCode, Failure> {
    let say = |words: &'static str| Text::from(words).render(&console.locale);
    let line =
        |label: &'static str, value: String| NamedValue { label: say(label), value, ..NamedValue::default() };
    let cases: usize =
        registry().iter().map(|entry| cases::cases(entry).map_or(0, |cases| cases.len())).sum();
    let kept = files::autosave_path();
    let there = |path: &Path| if path.exists() { "found" } else { "not found" };
    let place = |label: &'static str, path: Option<&Path>| {
        let value =
            path.map_or_else(|| "—".to_owned(), |path| format!("{} ({})", path.display(), say(there(path))));
        line(label, value)
    };
    let mut lines = vec![
        place("settings", set.path.as_deref()),
        place("history", files::remembered_path().as_deref()),
        place("own lists of exercises", files::sets_path().as_deref()),
        place("backup of unsaved work", kept.as_deref()),
    ];
    lines.extend(
        set.faults.iter().map(|fault| line("ignored settings", fault.text().render(&console.locale))),
    );
    for (path, faults) in files::sets_path().map_or_else(Vec::new, |folder| files::sets(&folder).1) {
        lines.extend(
            faults.iter().map(|fault| {
                line("ignored exercises", fault.text_in(path.display()).render(&console.locale))
            }),
        );
    }
    let program = vec![
        line("version", env!("CARGO_PKG_VERSION").into()),
        line("analyses", registry().len().to_string()),
        line("number of published cases", cases.to_string()),
        line("language", console.locale.language.tag().into()),
    ];
    let terminal = vec![
        line("both ends are a terminal", say(if console.interactive { "yes" } else { "no" })),
        line("terminal width", console.width.to_string()),
        line(
            "characters",
            match console.capabilities.glyphs {
                Glyphs::Unicode => "Unicode".into(),
                Glyphs::Ascii => "ASCII".into(),
            },
        ),
        line(
            "colours",
            match console.capabilities.colors {
                Colors::None => say("none"),
                Colors::Sixteen => "16".into(),
                Colors::Indexed256 => "256".into(),
                Colors::True => "16777216".into(),
            },
        ),
        line(
            "curve markers",
            match console.capabilities.marker {
                // Whether there are pixels is asked of the terminal, which this command does not.
                PlotMarker::Braille | PlotMarker::Pixels { .. } => say("braille"),
                PlotMarker::HalfBlock => say("half blocks"),
                PlotMarker::Dot => say("dots"),
                PlotMarker::Ascii => "ASCII".into(),
            },
        ),
    ];
    console.print(Document {
        title: "dalembert".into(),
        blocks: vec![
            Block::Lines(program),
            Block::Heading(say("Files and folders")),
            Block::Lines(lines),
            Block::Heading(say("Terminal")),
            Block::Lines(terminal),
        ],
    })?;
    Ok(ExitCode::SUCCESS)
}
