//! `dalembert solve`

use std::{
    ffi::OsStr,
    io::{self, Write as _},
    path::Path,
    process::ExitCode,
};

use dalembert_core::{Answer, Locale, Solution, Text, UnitSetting, nearest};
use dalembert_report::{
    Document, DocumentFormat, NoteSource, Parts, WorkedProblem, csv, csv_tables, document_of,
    document_without_figures, json, json_text, show_answers_in, text,
};
use dalembert_tui::glyphs::filter_untrusted;
use dalembert_units as units;

use crate::{
    arguments::{Format, OutputForm, Solve},
    console::{Console, print},
    failure::Failure,
    output,
    problem::{self, LoadedProblem, ProblemSource},
    solving,
};

/// Solves a problem and prints what came of it.
pub(crate) fn run(solve: &Solve, console: &Console) -> Result<ExitCode, Failure> {
    if let Some(output) = &solve.output {
        output::allowed(output, Path::new(&solve.problem), solve.force)?;
    }
    let asked = ProblemSource {
        case: solve.case,
        changes: &solve.set,
        define: &solve.define,
        ask: &solve.ask,
        given: &solve.given,
        configuration: &solve.configuration,
        strict: solve.strict,
        units: solve.units.as_deref().map(UnitSetting::read).transpose().map_err(Failure::input)?,
        ..ProblemSource::named(&solve.problem)
    };
    let mut problem = problem::read(&asked, console)?;
    for line in &solve.title_block {
        let (key, text) = line.split_once('=').ok_or_else(|| {
            let why = Text::new(
                "--title-block {line}: write a line and its text, as in --title-block author='A. Silva'",
            );
            Failure::input(why.with("line", line))
        })?;
        problem.title_block.set(key.trim(), text).map_err(Failure::input)?;
    }
    for asked in &solve.unit {
        let (answer, unit) = asked.split_once('=').ok_or_else(|| {
            let why = Text::new("--unit {asked}: write an answer and a unit, as in --unit amplitude=um");
            Failure::input(why.with("asked", asked))
        })?;
        problem.show.push((answer.trim().to_owned(), unit.trim().to_owned()));
    }
    let destination = Destination {
        problem: &solve.problem,
        form: &solve.form,
        path: solve.output.as_deref(),
        force: solve.force,
        digits: solve.digits,
        answers: &solve.answer,
    };
    let outcome = outcome(&problem)?;
    let outcome = match outcome {
        Ok(solution) if !solve.answer.is_empty() => Ok(working_of(&solution, &solve.answer)?),
        other => other,
    };
    write(&problem, &outcome, &destination, console)
}

/// The solution with the working of these answers alone; a name without a row is that of all its rows.
pub(crate) fn working_of(solution: &Solution, names: &[String]) -> Result<Solution, Failure> {
    let is_named = |answer: &Answer, name: &str| answer.name.is(name) || answer.name.base == name;
    for name in names {
        if !solution.answers.iter().any(|answer| is_named(answer, name)) {
            let known: Vec<String> = solution.answers.iter().map(|answer| answer.name.to_string()).collect();
            let why = match nearest(name, known.iter().map(String::as_str)) {
                Some(near) => {
                    Text::new("there is no answer `{name}`; did you mean `{near}`?").with("near", near)
                }
                None => Text::new("there is no answer `{name}`; write one of {known}")
                    .with("known", known.join(", ")),
            };
            return Err(Failure::input(why.with("name", name)));
        }
    }
    Ok(solution.working_of(|answer| names.iter().any(|name| is_named(answer, name))))
}

/// Destination of a worked solution.
pub(crate) struct Destination<'a> {
    /// The problem as it is named: its file is never written over.
    pub(crate) problem: &'a str,
    pub(crate) form: &'a OutputForm,
    /// The file to write; `None` for the screen.
    pub(crate) path: Option<&'a Path>,
    pub(crate) force: bool,
    pub(crate) digits: Option<u8>,
    /// Answers whose working alone is written; empty for all.
    pub(crate) answers: &'a [String],
}

/// Prints what came of a problem, or writes it to a file.
pub(crate) fn write(
    problem: &LoadedProblem,
    outcome: &solving::SolveOutcome,
    to: &Destination<'_>,
    console: &Console,
) -> Result<ExitCode, Failure> {
    let mut locale = console.locale.at(problem.entry.about.id);
    locale.style.digits = to.digits.unwrap_or(locale.style.digits);
    let worked = problem.worked(outcome);
    let parts = to.form.parts.map_or(Parts::Full, Parts::from);
    let paper = match format(to.form, to.path) {
        Format::Text => DocumentFormat::Text,
        Format::Markdown => DocumentFormat::Markdown,
        Format::Html => DocumentFormat::Html,
        Format::Latex => DocumentFormat::Latex,
        Format::Typst => DocumentFormat::Typst,
        #[cfg(feature = "word")]
        Format::Docx => {
            put_word(problem, outcome, parts, to, locale, console)?;
            return status(&worked, console);
        }
        Format::Json | Format::Csv if to.form.parts.is_some() => {
            return Err(Failure::input(
                "--parts chooses what a text or a note has; JSON and CSV have all of it: leave out --parts",
            ));
        }
        Format::Json => {
            put(to, &json_text(&json(&worked, &locale)))?;
            return status(&worked, console);
        }
        Format::Csv => {
            put(to, &spreadsheet(&worked, &to.form.table, &locale)?)?;
            return status(&worked, console);
        }
    };
    if paper == DocumentFormat::Text {
        let document = document_without_figures(&worked, parts, &locale).under(&problem.title_block, &locale);
        put(to, &text(&document.map(&|words| console.plain(words)), console.width))?;
        return status(&worked, console);
    }
    let (document, locale) = on_paper(problem, outcome, parts, paper, locale, console);
    let source = NoteSource::new(problem.file_text(problem.draft.clone()), to.answers, parts, &locale);
    match to.path {
        None => print(&source.append_to(paper.write(&document, None, &locale), paper))?,
        Some(path) => {
            let files = source.files(paper, &document, path, &locale).unwrap_or_default();
            let files: Vec<_> =
                files.into_iter().map(|(name, text)| (path.with_file_name(name), text)).collect();
            for (file, _) in &files {
                output::allowed(file, Path::new(to.problem), to.force)?;
            }
            for (file, text) in &files {
                output::write(file, text, to.force)?;
            }
        }
    }
    status(&worked, console)
}

/// Writes the document of Word into a file; to print it is an error, since it is no text.
#[cfg(feature = "word")]
fn put_word(
    problem: &LoadedProblem,
    outcome: &solving::SolveOutcome,
    parts: Parts,
    to: &Destination<'_>,
    locale: Locale,
    console: &Console,
) -> Result<(), Failure> {
    let path = to.path.ok_or_else(|| {
        Failure::input("a document of Word is no text to print: name its file, as in --output note.docx")
    })?;
    let (document, locale) = on_paper(problem, outcome, parts, DocumentFormat::Html, locale, console);
    let source = NoteSource::new(problem.file_text(problem.draft.clone()), to.answers, parts, &locale);
    let bytes = dalembert_report::docx(&document, &source, &locale).map_err(Failure::input)?;
    output::write(path, bytes, to.force)
}

/// The document of parts of a problem in a format, and the locale that it is written in.
pub(crate) fn on_paper(
    problem: &LoadedProblem,
    outcome: &solving::SolveOutcome,
    parts: Parts,
    paper: DocumentFormat,
    mut locale: Locale,
    console: &Console,
) -> (Document, Locale) {
    // Formulas are set as mathematics, of which ASCII has none; LaTeX is ASCII but for accents anyway.
    let is_set = paper != DocumentFormat::Markdown;
    locale.style.ascii &= !is_set;
    let plain =
        |words: &str| if is_set { filter_untrusted(words).into_owned() } else { console.plain(words) };
    let document = document_of(&problem.worked(outcome), parts, &locale);
    (document.under(&problem.title_block, &locale).map(&plain), locale)
}

/// Output format: by name, else by the extension of the file.
pub(crate) fn format(form: &OutputForm, path: Option<&Path>) -> Format {
    form.format.unwrap_or_else(|| {
        let path = path.unwrap_or(Path::new(""));
        match (DocumentFormat::of(path), path.extension().and_then(OsStr::to_str)) {
            (Some(DocumentFormat::Markdown), _) => Format::Markdown,
            (Some(DocumentFormat::Html), _) => Format::Html,
            (Some(DocumentFormat::Latex), _) => Format::Latex,
            (Some(DocumentFormat::Typst), _) => Format::Typst,
            #[cfg(feature = "word")]
            (_, Some("docx")) => Format::Docx,
            (_, Some("json")) => Format::Json,
            (_, Some("csv")) => Format::Csv,
            _ => Format::Text,
        }
    })
}

/// Writes a text to the file that is asked for, or prints it.
fn put(to: &Destination<'_>, text: &str) -> Result<(), Failure> {
    match to.path {
        Some(path) => output::write(path, text, to.force),
        None => print(text),
    }
}

/// Prints the worked solution of a problem on the screen.
pub(crate) fn print_worked(problem: &LoadedProblem, console: &Console) -> Result<ExitCode, Failure> {
    let outcome = outcome(problem)?;
    let worked = problem.worked(&outcome);
    console.print(document_without_figures(&worked, Parts::Full, &console.locale))?;
    status(&worked, console)
}

/// Solves a problem, with answers in the units of the problem.
pub(crate) fn outcome(problem: &LoadedProblem) -> Result<solving::SolveOutcome, Failure> {
    let outcome = solving::solve(problem.entry, &problem.record)?;
    let Ok(solution) = outcome else { return Ok(outcome) };
    let mut solution = solution.in_units_of(problem.units, &problem.draft, &problem.entry.shape());
    show_answers_in(&mut solution, &problem.show).map_err(Failure::input)?;
    Ok(Ok(solution))
}

fn spreadsheet(worked: &WorkedProblem<'_>, table: &str, locale: &Locale) -> Result<String, Failure> {
    csv(worked, table, locale).ok_or_else(|| {
        let why = Text::new("there is no table `{table}`; write one of {known}");
        Failure::input(why.with("table", table).with("known", csv_tables(worked).join(", ")))
    })
}

/// 1 for a refusal, a failed check or a defect, each of which is said on standard error.
fn status(worked: &WorkedProblem<'_>, console: &Console) -> Result<ExitCode, Failure> {
    let solution = worked.outcome.map_err(|why| Failure::Refused(why.clone()))?;
    let complaints = complaints(solution, &console.locale.at(worked.entry.about.id));
    for line in &complaints {
        // Nobody is left to read it when the error stream itself is closed.
        let _ = writeln!(io::stderr(), "{}", console.plain(line));
    }
    Ok(if complaints.is_empty() { ExitCode::SUCCESS } else { ExitCode::from(1) })
}

/// Warnings about a solution, one per line.
fn complaints(solution: &Solution, locale: &Locale) -> Vec<String> {
    let number = |x: f64| units::write_number(x, units::Style { digits: 2, ..locale.style });
    let failed = solution.checks.iter().filter(|check| !check.passed).map(|check| {
        Text::new("check failed: {what}: relative difference {residual}, limit {limit}")
            .with_text("what", check.what.clone())
            .with("residual", number(check.residual))
            .with("limit", number(check.limit))
    });
    let faults =
        solution.defects.iter().map(|defect| Text::new("internal error: {what}").with("what", defect));
    failed.chain(faults).map(|line| line.render(locale)).collect()
}

#[cfg(test)]
mod tests {
    use dalembert_core::{Check, Sides};

    use super::*;

    #[test]
    fn a_failed_check_is_said_with_its_size() {
        let mut solution = Solution::default();
        let check = |residual: f64| Check {
            what: "force by energy".into(),
            residual,
            limit: 1e-9,
            passed: residual <= 1e-9,
            sides: Sides::Plain,
        };
        solution.checks.push(check(1e-12));
        assert_eq!(complaints(&solution, &Locale::english()), Vec::<String>::new());
        solution.checks.push(check(0.25));
        let said = complaints(&solution, &Locale::english());
        assert_eq!(said.len(), 1);
        assert!(said[0].contains("force by energy") && said[0].contains("0.25"), "{}", said[0]);
    }
}
