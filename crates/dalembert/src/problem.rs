//! The problem that the command line names: an analysis with the inputs of a case, or a file.

use std::path::Path;

use dalembert_core::{Draft, Entry, FieldError, Record, Shape, Text, cases, file, find};
use dalembert_tui::files::{self, FileError};

use crate::{console::Console, failure::Failure, snippet};

/// The longest value that an error repeats in full, in characters.
const LONGEST_VALUE: usize = 60;

/// A problem with its inputs understood.
#[derive(Debug)]
pub(crate) struct Problem {
    /// Its analysis.
    pub(crate) entry: &'static Entry,
    /// The name of the case, or the title of the file.
    pub(crate) name: Text,
    /// Where the case was printed.
    pub(crate) source: Text,
    /// Remarks.
    pub(crate) note: Text,
    /// What was typed.
    pub(crate) draft: Draft,
    /// What was understood.
    pub(crate) record: Record,
    /// Units of answers: `(answer, unit)`.
    pub(crate) show: Vec<(String, String)>,
}

/// The analysis of an id.
pub(crate) fn analysis(id: &str) -> Result<&'static Entry, Failure> {
    find(id).ok_or_else(|| Failure::input(file::no_such_analysis(id)))
}

/// Reads a problem by the id of its analysis or the path of its file, with some inputs changed.
pub(crate) fn read(
    named: &str,
    case: Option<u32>,
    changes: &[String],
    console: &Console,
) -> Result<Problem, Failure> {
    match find(named) {
        Some(entry) => of_analysis(entry, case, changes),
        None => {
            let path = Path::new(named);
            if looks_like_an_id(named) && !path.exists() {
                return Err(Failure::input(file::no_such_analysis(named)));
            }
            if case.is_some() {
                return Err(Failure::input("a problem file has no cases; leave out --case"));
            }
            of_file(path, changes, console)
        }
    }
}

/// Whether a name that is no file was meant as the id of an analysis.
pub(crate) fn looks_like_an_id(named: &str) -> bool {
    let words =
        |part: &str| part.starts_with(|c: char| c.is_ascii_lowercase()) && !part.contains(['.', '/', '~']);
    named.split_once('/').is_some_and(|(family, name)| words(family) && words(name))
}

fn of_analysis(entry: &'static Entry, case: Option<u32>, changes: &[String]) -> Result<Problem, Failure> {
    let cases = cases::cases(entry)
        .map_err(|why| Failure::Fault(format!("the cases of {}: {why}", entry.about.id)))?;
    let number = case.unwrap_or(1);
    let have = cases.len();
    let Some(case) = cases.into_iter().nth(number as usize - 1) else {
        let why = Text::new("{id} has no case {number}; it has cases 1 to {have}");
        return Err(Failure::input(why.with("id", entry.about.id).with("number", number).with("have", have)));
    };
    let shape = entry.shape();
    let mut draft = case.draft.clone();
    let mut errors = change(&mut draft, &shape, changes);
    let record =
        draft.read(&shape).map_err(|found| errors.extend(found.iter().map(|err| named(err, &draft, &shape))));
    match record {
        Ok(record) if errors.is_empty() => Ok(Problem {
            entry,
            // With other inputs it is no longer the published problem.
            name: if changes.is_empty() { case.title() } else { Text::from("") },
            source: if changes.is_empty() { case.source } else { Text::from("") },
            note: if changes.is_empty() { case.note } else { Text::from("") },
            draft,
            record,
            show: Vec::new(),
        }),
        _ => Err(Failure::Input(errors)),
    }
}

fn of_file(path: &Path, changes: &[String], console: &Console) -> Result<Problem, Failure> {
    let text = files::read(path)?.text;
    let problem = file::parse(&text).map_err(|errors| {
        let places = errors.into_iter().map(|err| (err.why, err.span)).collect::<Vec<_>>();
        Failure::InFile(snippet::show(path, &text, &places, console))
    })?;
    let shape = problem.entry.shape();
    let mut draft = problem.draft;
    let errors = change(&mut draft, &shape, changes);
    if !errors.is_empty() {
        return Err(Failure::Input(errors));
    }
    let record = draft.read(&shape).map_err(|errors| {
        let (mut elsewhere, mut places) = (Vec::new(), Vec::new());
        for err in &errors {
            if changes
                .iter()
                .any(|change| change.split_once('=').is_some_and(|(path, _)| path.trim() == err.path))
            {
                elsewhere.push(named(err, &draft, &shape));
            } else {
                let why =
                    Text::new("{path}: {why}").with("path", &err.path).with_text("why", err.why.clone());
                places.push((why, snippet::span(&text, err, &typed(&draft, &shape, &err.path))));
            }
        }
        if places.is_empty() {
            Failure::Input(elsewhere)
        } else {
            Failure::InFile(snippet::show(path, &text, &places, console))
        }
    })?;
    Ok(Problem {
        entry: problem.entry,
        name: Text::verbatim(problem.title),
        source: Text::from(""),
        note: Text::from(""),
        draft,
        record,
        show: problem.show,
    })
}

/// Makes the changes of `--set`, and says what is wrong with those that cannot be made.
fn change(draft: &mut Draft, shape: &Shape, changes: &[String]) -> Vec<Text> {
    let mut errors = Vec::new();
    for change in changes {
        let Some((path, value)) = change.split_once('=') else {
            errors.push(
                Text::new("--set {change}: write a path and a value, as in --set mass=\"40 kg\"")
                    .with("change", short(change)),
            );
            continue;
        };
        let path = path.trim();
        match from_file(draft, shape, path, value) {
            Ok(text) => {
                let before = draft.clone();
                match draft.set(shape, path, text.as_deref().unwrap_or(value)) {
                    Ok(()) => draft.keep_first(&before, shape),
                    Err(err) => errors
                        .push(Text::new("--set {path}: {why}").with("path", path).with_text("why", err.why)),
                }
            }
            Err(err) => errors.push(Text::new("--set {path}: {why}").with("path", path).with("why", err)),
        }
    }
    errors
}

/// The text of the file that `@name` asks for, where a table stands.
fn from_file(draft: &Draft, shape: &Shape, path: &str, value: &str) -> Result<Option<String>, FileError> {
    let Some(name) = value.strip_prefix('@') else { return Ok(None) };
    let mut draft = draft.clone();
    // Writing first makes the rows and alternatives on the way.
    let columns = draft.set(shape, path, "").ok().and_then(|()| match draft.at(shape, path) {
        Ok((_, shape)) => match shape.present() {
            Shape::Table(columns) => Some(columns()),
            _ => None,
        },
        Err(_) => None,
    });
    match columns {
        Some(columns) => files::read_table(Path::new(name), columns).map(Some),
        None => Ok(None),
    }
}

/// An error with the value that was typed.
fn named(err: &FieldError, draft: &Draft, shape: &Shape) -> Text {
    let value = typed(draft, shape, &err.path);
    let text =
        if value.is_empty() { Text::new("{path}: {why}") } else { Text::new("{path} = {value}: {why}") };
    text.with("path", &err.path).with("value", short(&value)).with_text("why", err.why.clone())
}

fn typed(draft: &Draft, shape: &Shape, path: &str) -> String {
    match draft.at(shape, path) {
        Ok((Draft::Leaf(text), _)) => text.clone(),
        _ => String::new(),
    }
}

/// A value on one line of an error.
fn short(value: &str) -> String {
    let mut line: String =
        value.chars().take(LONGEST_VALUE).map(|c| if c == '\n' { ' ' } else { c }).collect();
    if value.chars().nth(LONGEST_VALUE).is_some() {
        line.push('…');
    }
    line
}
