//! `dalembert variants`

use std::{
    fs,
    path::{Path, PathBuf},
    process::ExitCode,
};

use dalembert_core::{Locale, Stop, Text};
use dalembert_report::{Document, DocumentFormat};
use dalembert_teaching::{
    Exercise, ExportFile, Generator, Variant, file_label, moodle, prairielearn, qti, seed_of, sheets,
};
use dalembert_tui::glyphs::filter_untrusted;
use dalembert_units::{self as units, Kind};

use crate::{
    arguments::{Variants, VariantsFormat},
    console::{Console, print},
    failure::Failure,
    output,
    problem::{self, LoadedProblem, ProblemSource},
    solving,
};

/// Draws variants and writes their sheets and keys.
pub(crate) fn run(asked: &Variants, console: &Console) -> Result<ExitCode, Failure> {
    let problem =
        problem::read(&ProblemSource { case: asked.case, ..ProblemSource::named(&asked.problem) }, console)?;
    let exercise = exercise(problem);
    let tolerance = tolerance(&asked.tolerance)?;
    let variants = solving::guarded(exercise.entry, || drawn(&exercise, asked, tolerance))??;
    let mut locale = console.locale.at(exercise.entry.about.id);
    let Some(folder) = &asked.out else {
        print(&alone(&exercise, &variants, asked, tolerance, console)?)?;
        return Ok(ExitCode::SUCCESS);
    };
    let files = match asked.format {
        VariantsFormat::Moodle => moodle::questions(&exercise, &variants, tolerance, &locale),
        VariantsFormat::Qti => qti::package(&exercise, &variants, tolerance, &locale),
        VariantsFormat::Prairielearn => {
            prairielearn::question_folder(&exercise, &variants, tolerance, &locale)
        }
        VariantsFormat::Csv => vec![answers(&exercise, &variants, &locale)],
        format => {
            let paper = paper(format);
            locale.style.ascii &= paper == DocumentFormat::Markdown;
            papers(&exercise, &variants, (paper, extension(format)), &locale)
        }
    };
    write(folder, &files, Path::new(&asked.problem), asked.force)?;
    let line = Text::new("{variants} variants, {files} files in {folder}")
        .with("variants", variants.len())
        .with("files", files.len())
        .with("folder", folder.display());
    print(&format!("{}\n", console.plain(&line.render(&locale))))?;
    Ok(ExitCode::SUCCESS)
}

/// A problem as an exercise.
pub(crate) fn exercise(problem: LoadedProblem) -> Exercise {
    Exercise {
        entry: problem.entry,
        title: problem.name,
        statement: problem.statement,
        draft: problem.draft,
        record: problem.record,
        units: problem.units,
        show: problem.show,
    }
}

/// A tolerance as it is typed, as a share; a number alone is in percent.
pub(crate) fn tolerance(text: &str) -> Result<f64, Failure> {
    let percent = units::unit("%").expect("percent is a unit");
    let read = units::read_quantity(text, &percent, Kind::Ratio).ok().map(|read| read.si);
    read.filter(|share| *share > 0.0 && *share <= 0.2).ok_or_else(|| {
        let why =
            Text::new("--tolerance {text}: write a share from above 0 to 20 %, as in --tolerance '0.5 %'");
        Failure::input(why.with("text", text))
    })
}

fn drawn(exercise: &Exercise, asked: &Variants, tolerance: f64) -> Result<Vec<Variant>, Failure> {
    let stop = Stop::new();
    let mut generator = Generator::new(exercise, tolerance, &stop).map_err(Failure::Input)?;
    if asked.student.is_empty() {
        return generator.variants(asked.seed, asked.count as usize, &stop).map_err(Failure::input);
    }
    asked.student.iter().map(|student| of_student(&mut generator, student, &stop)).collect()
}

/// The variant of a student.
pub(crate) fn of_student(
    generator: &mut Generator<'_>,
    student: &str,
    stop: &Stop,
) -> Result<Variant, Failure> {
    let named = |why: Text| {
        Failure::input(Text::new("student {student}: {why}").with("student", student).with_text("why", why))
    };
    let found = generator.variants(seed_of(student), 1, stop).map_err(named)?;
    let first = found.into_iter().next().ok_or_else(|| Failure::Fault("no variant was drawn".to_owned()))?;
    Ok(Variant { label: student.trim().to_owned(), ..first })
}

/// Text of the whole where no folder is named.
fn alone(
    exercise: &Exercise,
    variants: &[Variant],
    asked: &Variants,
    tolerance: f64,
    console: &Console,
) -> Result<String, Failure> {
    let mut locale = console.locale.at(exercise.entry.about.id);
    Ok(match asked.format {
        VariantsFormat::Csv => sheets::answers_csv(exercise, variants, &locale),
        VariantsFormat::Moodle => moodle::questions(exercise, variants, tolerance, &locale).remove(0).text,
        VariantsFormat::Qti | VariantsFormat::Prairielearn => {
            return Err(Failure::input("this format is a folder of files; name the folder with --out"));
        }
        format => {
            let paper = paper(format);
            locale.style.ascii &= paper == DocumentFormat::Markdown;
            let sheets = variants.iter().map(|variant| sheets::sheet(exercise, variant, &locale));
            let all: Vec<Document> = sheets.chain([sheets::key(exercise, variants, &locale)]).collect();
            let whole = sheets::together(exercise.heading().render(&locale), all);
            paper.write(&whole.map(&|words| filter_untrusted(words).into_owned()), None, &locale)
        }
    })
}

fn paper(format: VariantsFormat) -> DocumentFormat {
    match format {
        VariantsFormat::Html => DocumentFormat::Html,
        VariantsFormat::Tex => DocumentFormat::Latex,
        VariantsFormat::Typ => DocumentFormat::Typst,
        _ => DocumentFormat::Markdown,
    }
}

fn extension(format: VariantsFormat) -> &'static str {
    match format {
        VariantsFormat::Html => "html",
        VariantsFormat::Tex => "tex",
        VariantsFormat::Typ => "typ",
        _ => "md",
    }
}

fn answers(exercise: &Exercise, variants: &[Variant], locale: &Locale) -> ExportFile {
    ExportFile { path: "answers.csv".to_owned(), text: sheets::answers_csv(exercise, variants, locale) }
}

/// Sheets, worked keys and the key with its CSV; figures stand beside them.
fn papers(
    exercise: &Exercise,
    variants: &[Variant],
    (paper, extension): (DocumentFormat, &str),
    locale: &Locale,
) -> Vec<ExportFile> {
    let mut files = Vec::new();
    let mut add = |document: Document, stem: &str| {
        let document = document.map(&|words| filter_untrusted(words).into_owned());
        let path = PathBuf::from(format!("{stem}.{extension}"));
        let written = paper.files(&document, &path, locale).unwrap_or_default();
        files.extend(written.into_iter().map(|(path, text)| ExportFile { path, text }));
    };
    for variant in variants {
        let label = file_label(&variant.label);
        add(sheets::sheet(exercise, variant, locale), &format!("sheet-{label}"));
        add(sheets::worked_key(exercise, variant, locale), &format!("worked-{label}"));
    }
    add(sheets::key(exercise, variants, locale), "key");
    files.push(answers(exercise, variants, locale));
    files
}

/// Writes files into a folder, which is made where it is not there; none of them where one may not be written.
fn write(folder: &Path, files: &[ExportFile], problem: &Path, force: bool) -> Result<(), Failure> {
    let paths: Vec<PathBuf> = files.iter().map(|file| folder.join(&file.path)).collect();
    for path in &paths {
        output::allowed(path, problem, force)?;
    }
    for (path, file) in paths.iter().zip(files) {
        if let Some(parent) = path.parent() {
            fs::create_dir_all(parent).map_err(|error| {
                let why = Text::new("{folder} cannot be made: {why}");
                Failure::input(why.with("folder", parent.display()).with("why", error))
            })?;
        }
        output::write(path, &file.text, force)?;
    }
    Ok(())
}
