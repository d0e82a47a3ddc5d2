//! `dalembert confirm`

use std::{path::Path, process::ExitCode};

use dalembert_core::{Locale, Text};
use dalembert_report::{DocumentFormat, NoteSource, differences};
#[cfg(feature = "word")]
use dalembert_report::{DocxNote, docx_differences};
use dalembert_tui::files;

use crate::{
    arguments::Confirm,
    commands::solve,
    console::{Console, print},
    failure::Failure,
    problem::{self, ProblemSource},
};

/// A note as it was read.
enum Note {
    Text(String, DocumentFormat),
    #[cfg(feature = "word")]
    Word(DocxNote),
}

/// The note of a file, and its source.
fn read(path: &Path, in_note: &impl Fn(Text) -> Failure) -> Result<(NoteSource, Note), Failure> {
    #[cfg(feature = "word")]
    if path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("docx")) {
        let note = DocxNote::read(&files::read_bytes(path)?).map_err(in_note)?;
        return Ok((note.source.clone(), Note::Word(note)));
    }
    let format = DocumentFormat::of(path).filter(|format| *format != DocumentFormat::Text);
    let format = format.ok_or_else(|| {
        in_note("a note is HTML, LaTeX, Typst, Markdown or Word: .html, .tex, .typ, .md or .docx".into())
    })?;
    let text = files::read(path)?.text;
    Ok((NoteSource::of_note(&text).map_err(in_note)?, Note::Text(text, format)))
}

/// Solves the problem in a note again, and names each printed line that is not as computed.
pub(crate) fn run(confirm: &Confirm, console: &Console) -> Result<ExitCode, Failure> {
    let path = &confirm.note;
    let in_note = |why: Text| {
        Failure::input(Text::new("{file}: {why}").with("file", path.display()).with_text("why", why))
    };
    let (source, note) = read(path, &in_note)?;
    let problem = problem::of_file(path, &source.problem_file, &ProblemSource::named(""), console)?;
    let outcome = match solve::outcome(&problem)? {
        Ok(solution) if !source.answers.is_empty() => Ok(solve::working_of(&solution, &source.answers)?),
        outcome => outcome,
    };
    let mut locale = Locale::of(source.language);
    (locale.style.digits, locale.style.ascii) = (source.digits, source.ascii);
    let locale = locale.at(problem.entry.about.id);
    let on_paper = |format| solve::on_paper(&problem, &outcome, source.parts, format, locale, console);
    let (count, found) = match &note {
        Note::Text(text, format) => {
            let (document, locale) = on_paper(*format);
            differences(text, &document, *format, &locale)
        }
        #[cfg(feature = "word")]
        Note::Word(note) => docx_differences(note, &on_paper(DocumentFormat::Html).0),
    };
    let mut lines = Vec::new();
    if source.version != env!("CARGO_PKG_VERSION") {
        let text = Text::new("the note was written by dalembert {version}; this is {this}");
        lines.push(text.with("version", &source.version).with("this", env!("CARGO_PKG_VERSION")));
    }
    lines.extend(found.iter().map(|difference| {
        match &difference.printed {
            Some((line, printed)) => Text::new("line {line}: printed `{printed}`, computed `{computed}`")
                .with("line", line)
                .with("printed", printed)
                .with("computed", &difference.computed),
            None => Text::new("missing in the note: `{computed}`").with("computed", &difference.computed),
        }
    }));
    lines.push(if found.is_empty() {
        Text::new("confirmed: {count} lines of data, answers and working are as computed")
            .with("count", count)
    } else {
        Text::new("not confirmed: {found} of {count} lines of data, answers and working are not as computed")
            .with("found", found.len())
            .with("count", count)
    });
    for line in lines {
        print(&format!("{}\n", console.plain(&line.render(&console.locale))))?;
    }
    Ok(if found.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}
