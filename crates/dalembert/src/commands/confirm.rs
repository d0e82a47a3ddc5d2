//! `dalembert confirm`

use std::process::ExitCode;

use dalembert_core::{Locale, Text};
use dalembert_report::{DocumentFormat, NoteSource, differences};
use dalembert_tui::files;

use crate::{
    arguments::Confirm,
    commands::solve,
    console::{Console, print},
    failure::Failure,
    problem::{self, ProblemSource},
};

/// Solves the problem in a note again, and names each printed line that is not as computed.
pub(crate) fn run(confirm: &Confirm, console: &Console) -> Result<ExitCode, Failure> {
    let path = &confirm.note;
    let in_note = |why: Text| {
        Failure::input(Text::new("{file}: {why}").with("file", path.display()).with_text("why", why))
    };
    let format = DocumentFormat::of(path).filter(|format| *format != DocumentFormat::Text);
    let format = format.ok_or_else(|| {
        in_note("a note is HTML, LaTeX, Typst or Markdown: .html, .tex, .typ or .md".into())
    })?;
    let note = files::read(path)?.text;
    let source = NoteSource::of_note(&note).map_err(in_note)?;
    let problem = problem::of_file(path, &source.problem_file, &ProblemSource::named(""), console)?;
    let outcome = match solve::outcome(&problem)? {
        Ok(solution) if !source.answers.is_empty() => Ok(solve::working_of(&solution, &source.answers)?),
        outcome => outcome,
    };
    let mut locale = Locale::of(source.language);
    (locale.style.digits, locale.style.ascii) = (source.digits, source.ascii);
    let locale = locale.at(problem.entry.about.id);
    let (document, locale) = solve::on_paper(&problem, &problem.worked(&outcome), format, locale, console);
    let (count, found) = differences(&note, &document, format, &locale);
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
