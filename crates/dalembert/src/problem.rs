//! The problem that the command line names: an analysis with the inputs of a case, or a file.

use std::{
    collections::BTreeMap,
    io,
    path::Path,
    sync::{Mutex, OnceLock, PoisonError},
};

use dalembert_core::{
    Draft, Entry, FieldError, Record, Shape, Statement, Text, UnitSetting,
    cases::{self, Case},
    file::{self, ProblemFile, TitleBlock},
    find, is_within,
};
use dalembert_report::{WorkedProblem, named_error as named, short, typed, with_file};
use dalembert_tui::{
    files::{self, FileError},
    form::point_of_thousands,
};
use serde_json::{Map, Value as Json};

use crate::{console::Console, failure::Failure, questions, snippet, solving::SolveOutcome, values};

/// The names that stand for the standard input.
const STDIN: [&str; 2] = ["-", "/dev/stdin"];

/// A problem with its inputs understood.
#[derive(Debug)]
pub(crate) struct LoadedProblem {
    /// Analysis of the problem.
    pub(crate) entry: &'static Entry,
    /// The name of the case, or the title of the file.
    pub(crate) name: Text,
    /// Publication of the case.
    pub(crate) source: Text,
    /// Remarks.
    pub(crate) note: Text,
    /// Statement of the exercise that it is; empty once inputs are changed.
    pub(crate) statement: Statement,
    /// Title block of its notes.
    pub(crate) title_block: TitleBlock,
    /// Notes on the reading of the inputs where the inputs do not show it.
    pub(crate) notes: Vec<Text>,
    /// Texts of the inputs.
    pub(crate) draft: Draft,
    /// Inputs as read.
    pub(crate) record: Record,
    /// Units of everything that is shown.
    pub(crate) units: UnitSetting,
    /// Units of answers: `(answer, unit)`.
    pub(crate) show: Vec<(String, String)>,
    /// Text of its file; empty for a case.
    pub(crate) text: String,
}

impl LoadedProblem {
    /// The problem with what came of it, for a report.
    pub(crate) fn worked<'p>(&'p self, outcome: &'p SolveOutcome) -> WorkedProblem<'p> {
        WorkedProblem {
            entry: self.entry,
            case: &self.name,
            source: &self.source,
            statement: &self.statement.text,
            note: &self.note,
            notes: &self.notes,
            draft: &self.draft,
            record: &self.record,
            outcome: outcome.as_ref(),
        }
    }

    /// Text of a problem file with these inputs, written over that of the file that it was read from.
    pub(crate) fn file_text(&self, draft: Draft) -> String {
        let problem = ProblemFile {
            entry: self.entry,
            title: self.name.english(),
            // It stands in the text that is written over.
            statement: Statement::default(),
            title_block: self.title_block.clone(),
            draft,
            units: self.units,
            show: self.show.clone(),
            notes: Vec::new(),
            files: Vec::new(),
        };
        file::write(&problem, &self.text)
    }
}

/// The analysis of an id.
pub(crate) fn analysis(id: &str) -> Result<&'static Entry, Failure> {
    find(id).ok_or_else(|| Failure::input(file::no_such_analysis(id)))
}

/// Source of a problem: file or analysis, case and changes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ProblemSource<'a> {
    /// The id of an analysis, the path of a file, or `-` for the standard input.
    pub(crate) named: &'a str,
    /// The published case to begin with.
    pub(crate) case: Option<u32>,
    /// The inputs to change.
    pub(crate) changes: &'a [String],
    /// The inputs to change after these, by their paths: texts, numbers, lists, tables.
    pub(crate) values: Option<&'a Map<String, Json>>,
    /// The definitions to add.
    pub(crate) define: &'a [String],
    /// The questions to add.
    pub(crate) ask: &'a [String],
    /// The given answers to add.
    pub(crate) given: &'a [String],
    /// The changed inputs of configurations to add.
    pub(crate) configuration: &'a [String],
    /// The options that inputs and given answers are of, as errors name them.
    pub(crate) options: ProblemOptions,
    /// True if a number without a unit is refused.
    pub(crate) strict: bool,
    /// The units of everything that is shown, in place of those of the problem.
    pub(crate) units: Option<UnitSetting>,
}

impl<'a> ProblemSource<'a> {
    /// A problem as it is.
    pub(crate) fn named(named: &'a str) -> Self {
        Self {
            named,
            case: None,
            changes: &[],
            values: None,
            define: &[],
            ask: &[],
            given: &[],
            configuration: &[],
            options: ProblemOptions::OF_SOLVE,
            strict: false,
            units: None,
        }
    }

    /// Returns true if inputs are changed.
    fn changes_inputs(&self) -> bool {
        !self.changes.is_empty() || self.values.is_some_and(|values| !values.is_empty())
    }
}

/// Options of the command line that change inputs and give answers.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ProblemOptions {
    /// The option of an input.
    pub(crate) input: &'static str,
    /// The option of a given answer.
    pub(crate) given: &'static str,
    /// Form of a given answer, with an example.
    pub(crate) given_form: &'static str,
}

impl ProblemOptions {
    /// Those of `dalembert solve`.
    pub(crate) const OF_SOLVE: Self = Self {
        input: "--set",
        given: "--given",
        given_form: "write an answer and its value, as in --given 'natural_frequency=8.2 Hz'",
    };
    /// Those of a request of another program.
    pub(crate) const OF_REQUEST: Self = Self { input: "set", given: "given", ..Self::OF_SOLVE };
}

/// Reads a problem, and says on the error stream how its inputs were read where that does not stand in them.
pub(crate) fn read(asked: &ProblemSource<'_>, console: &Console) -> Result<LoadedProblem, Failure> {
    let named = asked.named;
    match find(named) {
        Some(entry) => of_analysis(entry, asked, console),
        None => {
            let path = Path::new(named);
            if looks_like_an_id(named) && !path.exists() {
                return Err(Failure::input(file::no_such_analysis(named)));
            }
            if asked.case.is_some() {
                return Err(Failure::input("a problem file has no cases; leave out --case"));
            }
            let text = text_of(named)?;
            of_file(shown_path(named), &text, asked, console)
        }
    }
}

/// Returns true if a name that is no file was meant as the id of an analysis.
pub(crate) fn looks_like_an_id(named: &str) -> bool {
    let words =
        |part: &str| part.starts_with(|c: char| c.is_ascii_lowercase()) && !part.contains(['.', '/', '~']);
    named.split_once('/').is_some_and(|(family, name)| words(family) && words(name))
}

fn of_analysis(
    entry: &'static Entry,
    asked: &ProblemSource<'_>,
    console: &Console,
) -> Result<LoadedProblem, Failure> {
    let case = match asked.case {
        // With some inputs set and none to begin with, the others would be those of another problem.
        None if asked.changes_inputs() => None,
        number => Some(case(entry, number.unwrap_or(1))?),
    };
    let shape = entry.shape();
    let base = case.as_ref().map_or_else(|| Draft::blank(&shape), |case| case.draft.clone());
    let mut draft = base.clone();
    let mut errors = change(&mut draft, &shape, asked, console);
    if errors.is_empty() {
        errors =
            questions::ask_usual(&mut draft, entry, asked.units.unwrap_or_default(), asked.ask, console)?;
    }
    let mut is_incomplete = false;
    let record = draft.read(&shape).map_err(|found| {
        is_incomplete = found.iter().any(|err| typed(&draft, &shape, &err.path).is_empty());
        errors.extend(found.iter().map(|err| named(err, &draft, &shape)));
    });
    let of_case = base.without_unit(&shape);
    let bare = draft.without_unit(&shape).into_iter().filter(|err| !of_case.contains(err));
    let notes: Vec<Text> = bare.map(|err| named(&err, &draft, &shape)).collect();
    if asked.strict {
        errors.extend(notes.iter().cloned());
    }
    // With other inputs it is no longer the published problem.
    let published = case.filter(|_| !asked.changes_inputs());
    let none = || Text::from("");
    match record {
        Ok(record) if errors.is_empty() => Ok(LoadedProblem {
            entry,
            name: published.as_ref().map_or_else(none, Case::title),
            source: published.as_ref().map_or_else(none, |case| case.source.clone()),
            statement: published.as_ref().map(Case::exercise).unwrap_or_default(),
            title_block: TitleBlock::default(),
            note: published.map_or_else(none, |case| case.note),
            notes: reported(notes, "warning: {words}", console),
            draft,
            record,
            units: asked.units.unwrap_or_default(),
            show: Vec::new(),
            text: String::new(),
        }),
        _ => {
            if is_incomplete && asked.case.is_none() {
                errors.push(
                    "inputs that are not set stay empty; --case 1 starts from the first published case"
                        .into(),
                );
            }
            Err(Failure::Input(errors))
        }
    }
}

/// The case that a question about a problem begins with, where its own options change inputs too: the first where no input
/// is set. With inputs set and none to begin with, the others would be those of another problem.
pub(crate) fn first_case(named: &str, case: Option<u32>, set: &[String]) -> Option<u32> {
    case.or_else(|| find(named).filter(|_| set.is_empty()).map(|_| 1))
}

/// The published case of a number, counted from 1.
pub(crate) fn case(entry: &'static Entry, number: u32) -> Result<Case, Failure> {
    // Another program asks for the same case again and again: they are read once.
    static KNOWN: Mutex<BTreeMap<&str, Vec<Case>>> = Mutex::new(BTreeMap::new());
    let mut known = KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
    if !known.contains_key(entry.about.id) {
        let cases = cases::cases(entry)
            .map_err(|why| Failure::Fault(format!("the cases of {}: {why}", entry.about.id)))?;
        known.insert(entry.about.id, cases);
    }
    let cases = known.get(entry.about.id).map_or(&[][..], Vec::as_slice);
    let have = cases.len();
    cases.get(number as usize - 1).cloned().ok_or_else(|| {
        let why = Text::new("{id} has no case {number}; it has cases 1 to {have}");
        Failure::input(why.with("id", entry.about.id).with("number", number).with("have", have))
    })
}

/// The text of a file, or of the standard input.
pub(crate) fn text_of(named: &str) -> Result<String, Failure> {
    // It can be read once, and a study asks for it as its plan and as its problem.
    static STANDARD_INPUT: OnceLock<String> = OnceLock::new();
    if !is_standard_input(named) {
        return Ok(files::read(Path::new(named))?.text);
    }
    if let Some(text) = STANDARD_INPUT.get() {
        return Ok(text.clone());
    }
    let text = files::read_from(io::stdin().lock(), shown_path(named))?.text;
    Ok(STANDARD_INPUT.get_or_init(|| text).clone())
}

/// The path of a file as messages name it.
fn shown_path(named: &str) -> &Path {
    Path::new(if is_standard_input(named) { "<stdin>" } else { named })
}

/// Returns true if a name stands for the standard input.
pub(crate) fn is_standard_input(named: &str) -> bool {
    STDIN.contains(&named)
}

/// The problem of a text; `path` is that of its file as messages name it, from whose folder it links to others.
pub(crate) fn of_file(
    path: &Path,
    text: &str,
    asked: &ProblemSource<'_>,
    console: &Console,
) -> Result<LoadedProblem, Failure> {
    let mut read = |linked: &str| files::read_linked(path, linked);
    let problem = file::parse_with(text, &mut read).map_err(|errors| {
        let places = errors.into_iter().map(|err| (err.why, err.span)).collect::<Vec<_>>();
        Failure::InFile(snippet::show(path, text, &places, console))
    })?;
    let (shape, units) = (problem.entry.shape(), asked.units.unwrap_or(problem.units));
    let mut draft = problem.draft;
    let mut errors = change(&mut draft, &shape, asked, console);
    if errors.is_empty() {
        errors = questions::ask_usual(&mut draft, problem.entry, units, asked.ask, console)?;
    }
    if !errors.is_empty() {
        return Err(Failure::Input(errors));
    }
    let bare = draft.without_unit(&shape);
    let record = draft.read(&shape);
    let errors = match &record {
        Err(errors) => errors.as_slice(),
        Ok(_) if asked.strict => bare.as_slice(),
        Ok(_) => &[],
    };
    let is_set = |err: &FieldError| {
        let mut paths = asked.changes.iter().filter_map(|change| change.split_once('='));
        let mut values = asked.values.into_iter().flat_map(Map::keys);
        paths.any(|(path, _)| path.trim() == err.path) || values.any(|path| is_within(&err.path, path))
    };
    let (set, in_file): (Vec<&FieldError>, Vec<&FieldError>) = errors.iter().partition(|err| is_set(err));
    if !in_file.is_empty() {
        let typed = |err: &FieldError| typed(&draft, &shape, &err.path);
        return Err(Failure::InFile(snippet::show_fields(path, text, &in_file, &typed, console)));
    }
    match record {
        Ok(record) if set.is_empty() => Ok(LoadedProblem {
            entry: problem.entry,
            name: Text::verbatim(problem.title),
            source: Text::from(""),
            note: Text::from(""),
            statement: problem.statement,
            title_block: problem.title_block,
            notes: {
                let bare = bare.iter().map(|err| named(err, &draft, &shape)).collect();
                let mut notes = reported(problem.notes, "note: {words}", console);
                notes.extend(reported(bare, "warning: {words}", console));
                notes
            },
            draft,
            record,
            units,
            show: problem.show,
            text: text.to_owned(),
        }),
        _ => Err(Failure::Input(set.into_iter().map(|err| named(err, &draft, &shape)).collect())),
    }
}

/// The same notes, said on the error stream.
fn reported(notes: Vec<Text>, template: &'static str, console: &Console) -> Vec<Text> {
    for note in &notes {
        console.notify(template, note);
    }
    notes
}

/// Makes the changes of `--let`, `--ask`, `--given`, `--configuration` and `--set`, and says what is wrong with those that cannot be made.
fn change(draft: &mut Draft, shape: &Shape, asked: &ProblemSource<'_>, console: &Console) -> Vec<Text> {
    let mut errors = Vec::new();
    type Add = fn(&mut Draft, &Shape, &str, &str) -> Result<(), FieldError>;
    let added: [(&str, &[String], Add, &str); 4] = [
        ("--let", asked.define, Draft::define, "write a name and a formula, as in --let nu=0.3"),
        ("--ask", asked.ask, Draft::ask, "write a name and a formula, as in --ask 'peak to peak=2*X'"),
        (asked.options.given, asked.given, Draft::give, asked.options.given_form),
        (
            "--configuration",
            asked.configuration,
            Draft::configure,
            "write a changed input and its value, as in --configuration 'weighted.mass=m + 2 kg'",
        ),
    ];
    for (flag, texts, add, form) in added {
        // A question without a formula is one of the usual ones, which are known once the problem is read.
        for text in texts.iter().filter(|text| flag != "--ask" || text.contains('=')) {
            let added = match text.split_once('=') {
                Some((name, formula)) => add(draft, shape, name, formula).map_err(|err| err.why),
                None => Err(form.into()),
            };
            if let Err(why) = added {
                let error = Text::new("{flag} {text}: {why}").with("flag", flag).with("text", short(text));
                errors.push(error.with_text("why", why));
            }
        }
    }
    let wrong = |path: &str| {
        let text = Text::new("{flag} {text}: {why}").with("flag", asked.options.input).with("text", path);
        // A sentence about an input has its path, for another program.
        text.with("path", path)
    };
    for change in asked.changes {
        let Some((path, value)) = change.split_once('=') else {
            errors.push(
                Text::new("--set {change}: write a path and a value, as in --set mass=\"40 kg\"")
                    .with("change", short(change)),
            );
            continue;
        };
        if let Err(error) = set(draft, shape, path.trim(), value, console) {
            errors.push(wrong(&error.path).with_text("why", error.why));
        }
        if let Some(number) = point_of_thousands(value, console.locale.style) {
            let why = Text::new(
                "{number} has a decimal mark and is read as a decimal; write thousands without one",
            );
            let why = why.with("number", number);
            if asked.strict {
                errors.push(wrong(path.trim()).with_text("why", why));
            } else {
                console.notify("warning: {words}", &wrong(path.trim()).with_text("why", why));
            }
        }
    }
    for (path, value) in asked.values.into_iter().flatten() {
        let mut one = |draft: &mut Draft, path: &str, text: &str| set(draft, shape, path, text, console);
        let faults = values::write(draft, shape, path, value, &mut one);
        errors.extend(faults.into_iter().map(|error| wrong(&error.path).with_text("why", error.why)));
    }
    errors
}

/// Writes the text of one input, or that of the file that it names.
fn set(
    draft: &mut Draft,
    shape: &Shape,
    path: &str,
    text: &str,
    console: &Console,
) -> Result<(), FieldError> {
    let named = file::named_input(shape, path, text);
    if let Some(named) = &named {
        console.notify("note: {words}", &named.note);
    }
    let (path, text) = named.as_ref().map_or((path, text), |now| (&now.path, &now.text));
    let wrong = |why: Text| FieldError::new(path, why);
    let from_file = from_file(draft, shape, path, text).map_err(|error| wrong(Text::verbatim(error)))?;
    let before = draft.clone();
    // Notes name the file, without the folders of a machine.
    let from_file =
        from_file.map(|read| with_file(&read, text.rsplit(['/', '\\', '@']).next().unwrap_or(text)));
    draft.set(shape, path, from_file.as_deref().unwrap_or(text)).map_err(|error| wrong(error.why))?;
    draft.keep_first(&before, shape);
    Ok(())
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
