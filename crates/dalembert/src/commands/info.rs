//! `dalembert info`

use std::process::ExitCode;

use dalembert_core::{Language, Text, cases, registry};
use dalembert_report::{Block, Document, Line};
use dalembert_tui::glyphs::{Colors, Glyphs, PlotMarker};
use etcetera::BaseStrategy;

use crate::{console::Console, failure::Failure};

/// Shows what somebody who helps from afar asks for first.
pub(crate) fn run(console: &Console) -> Result<ExitCode, Failure> {
    let say = |words: &'static str| Text::from(words).render(&console.locale);
    let line = |label: &'static str, value: String| Line { label: say(label), value, ..Line::default() };
    let cases: usize =
        registry().iter().map(|entry| cases::cases(entry).map_or(0, |cases| cases.len())).sum();
    let state = etcetera::choose_base_strategy()
        .ok()
        .and_then(|base| base.state_dir())
        .map_or_else(|| "—".to_owned(), |folder| folder.join("dalembert").display().to_string());
    let program = vec![
        line("version", env!("CARGO_PKG_VERSION").into()),
        line("analyses", registry().len().to_string()),
        line("published cases", cases.to_string()),
        line(
            "language",
            match console.locale.language {
                Language::English => "en".into(),
                Language::Portuguese => "pt-BR".into(),
            },
        ),
        line("unsaved work is kept in", state),
    ];
    let terminal = vec![
        line("both ends are a terminal", say(if console.interactive { "yes" } else { "no" })),
        line("width", console.width.to_string()),
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
            "curves are drawn with",
            match console.capabilities.marker {
                PlotMarker::Braille => say("braille"),
                PlotMarker::HalfBlock => say("half blocks"),
                PlotMarker::Dot => say("dots"),
                PlotMarker::Ascii => "ASCII".into(),
            },
        ),
    ];
    console.print(Document {
        title: "dalembert".into(),
        blocks: vec![Block::Lines(program), Block::Heading(say("Terminal")), Block::Lines(terminal)],
    })?;
    Ok(ExitCode::SUCCESS)
}
