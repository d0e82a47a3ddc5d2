//! Problem files: TOML in, a [`Draft`] out, and back without losing a comment.
//!
//! ```toml
//! format = 2
//! analysis = "vibration/rotating-unbalance"
//! title = "Fan of the paint shop"
//!
//! [inputs]
//! mass = "40 kg"
//! ```

mod choice;
mod definitions;
mod format;
mod former;
mod linked;
mod places;
mod rows;
mod shorthand;
mod template;
mod title_block;
mod write;
pub use choice::{NamedInput, named_input};
pub use linked::{LinkedFile, ReadFile};
pub use places::{line_of, locate};
pub use template::template;
pub use title_block::TitleBlock;

use std::ops::Range;

use toml_edit::{Document, DocumentMut, Item, Table, TableLike, Value as Toml};

use self::write::{set_text, write_item};
pub use self::{format::Format, shorthand::ShortForm};
use crate::{
    Display, Draft, Entry, Field, LinkedProblem, Shape, Statement, Text, UnitSetting, describe, draft,
    find_analysis, path, registry, table,
};

/// The keys a problem file may have at the top.
const KEYS: [&str; 15] = [
    "format",
    "analysis",
    "title",
    "statement",
    "asked",
    "vary",
    "units",
    "let",
    "inputs",
    "problem",
    "configuration",
    "given",
    "ask",
    "show",
    title_block::TABLE,
];

/// The contents of a problem file.
#[derive(Clone, Debug)]
pub struct ProblemFile {
    /// Analysis of the problem.
    pub entry: &'static Entry,
    /// Title given by the user; may be empty.
    pub title: String,
    /// Statement of the exercise that the problem is.
    pub statement: Statement,
    /// Title block of its notes.
    pub title_block: TitleBlock,
    /// Texts of the inputs.
    pub draft: Draft,
    /// Units of everything that is shown.
    pub units: UnitSetting,
    /// Display of answers: `(answer, unit and digits)`, see [`Display`].
    pub show: Vec<(String, String)>,
    /// Notes on values that an older format left implicit and that were written out as that format has them.
    pub notes: Vec<Text>,
    /// The files that it links to, in the order in which they were read.
    pub files: Vec<LinkedFile>,
}

impl ProblemFile {
    /// States that the text of a linked file is that of a problem as it is open, with changes that are not saved.
    pub fn mark_unsaved(&mut self, path: &str) {
        for file in self.files.iter_mut().filter(|file| file.path == path) {
            let before = file.note();
            file.unsaved = true;
            for note in self.notes.iter_mut().filter(|note| **note == before) {
                *note = file.note();
            }
        }
    }
}

/// The errors and notes of reading a file of a format.
pub(crate) struct FileNotes {
    pub(crate) format: Format,
    pub(crate) errors: Vec<FileError>,
    pub(crate) notes: Vec<Text>,
    /// The place of the kind that a former alternative stands for, in what it holds.
    pub(crate) kind: Option<usize>,
}

impl FileNotes {
    /// Those of a text of the latest format, before it is read.
    pub(crate) fn latest() -> Self {
        Self { format: Format::LATEST, errors: Vec::new(), notes: Vec::new(), kind: None }
    }
}

/// Error of a problem file, with its position.
#[derive(Clone, Debug, PartialEq)]
pub struct FileError {
    /// Description of the error and of its repair.
    pub why: Text,
    /// The bytes of the file.
    pub span: Option<Range<usize>>,
}

/// Reads a problem file that links to no other. The inputs are taken as they are typed; [`Draft::read`] says what is wrong
/// with them, and [`locate`] where.
pub fn parse(text: &str) -> Result<ProblemFile, Vec<FileError>> {
    parse_with(text, &mut |_| Err("no other file can be read here".into()))
}

/// Reads a problem file and those that it links to, whose texts `read` gives by their paths from its folder.
pub fn parse_with(text: &str, read: &mut ReadFile<'_>) -> Result<ProblemFile, Vec<FileError>> {
    parse_open(text, &mut linked::Links { read, are_followed: true, open: Vec::new(), files: Vec::new() })
}

/// Reads a problem file alone: links to others stay as they are typed, and are errors of their inputs.
pub fn parse_unlinked(text: &str) -> Result<ProblemFile, Vec<FileError>> {
    let read: &mut ReadFile<'_> = &mut |_| Err("no other file can be read here".into());
    parse_open(text, &mut linked::Links { read, are_followed: false, open: Vec::new(), files: Vec::new() })
}

fn parse_open(text: &str, links: &mut linked::Links<'_, '_>) -> Result<ProblemFile, Vec<FileError>> {
    let document = document(text)?;
    let root = document.as_table();
    let mut errors = Vec::new();
    check_keys(root, &KEYS, &mut errors);
    let format = Format::of(root).map_err(|error| vec![error])?;
    let has_others = root.contains_key("problem") && !root.contains_key("analysis");
    let main = match analysis_of(root) {
        _ if has_others => None,
        Ok(entry) => Some(entry),
        Err(why) => {
            errors.insert(0, FileError { why, span: span(root, "analysis") });
            return Err(errors);
        }
    };
    let mut reading = FileNotes { format, errors, notes: Vec::new(), kind: None };
    let mut show = read_show(root, &mut reading.errors);
    let (entry, draft) = problem_of(root, main, &mut show, links, &mut reading);
    let FileNotes { mut errors, mut notes, .. } = reading;
    let title = text_at(root, "title", &mut errors).unwrap_or_default();
    let statement = Statement::of(root).unwrap_or_else(|(key, why)| {
        errors.push(FileError { why, span: span(root, key) });
        Statement::default()
    });
    let title_block = TitleBlock::read(root, &mut errors);
    let units = units_of(root, &mut errors)
        .unwrap_or_else(|| format::left_out_units(format, &draft, &entry.shape(), &mut notes));
    let files = if links.open.is_empty() { std::mem::take(&mut links.files) } else { Vec::new() };
    notes.extend(files.iter().map(LinkedFile::note));
    let problem = ProblemFile { entry, title, statement, title_block, draft, units, show, notes, files };
    if errors.is_empty() { Ok(problem) } else { Err(errors) }
}

/// The analysis that a table names.
fn analysis_of(table: &dyn TableLike) -> Result<&'static Entry, Text> {
    match table.get("analysis").map(Item::as_str) {
        Some(Some(id)) => find_analysis(id).ok_or_else(|| no_such_analysis(id)),
        Some(None) => Err(Text::new("the analysis must be a text such as \"vibration/rotating-unbalance\"")),
        None => Err(Text::new("the analysis is not named; write analysis = \"family/name\" at the top")),
    }
}

/// Display of answers, `[show]`.
fn read_show(table: &dyn TableLike, errors: &mut Vec<FileError>) -> Vec<(String, String)> {
    let mut show = Vec::new();
    match table.get("show").map(|item| (item, item.as_table_like())) {
        Some((_, Some(table))) => {
            for (answer, item) in table.iter() {
                let display = item.as_str().ok_or_else(|| Text::from("a unit must be a text such as \"mm\""));
                match display.and_then(|display| Display::read(display).map(|_| display)) {
                    Ok(display) => show.push((answer.to_owned(), display.to_owned())),
                    Err(why) => errors.push(FileError { why, span: item.span() }),
                }
            }
        }
        Some((item, None)) => errors.push(FileError {
            why: "`show` is a table of answers and their units, as in [show] amplitude = \"mm; 6 digits\""
                .into(),
            span: item.span(),
        }),
        None => {}
    }
    show
}

/// Returns true if a text is a problem file, however wrong its inputs may be.
pub fn is_problem(text: &str) -> bool {
    let has = |key| Document::parse(text).is_ok_and(|document| document.as_table().contains_key(key));
    has("analysis") || has("problem")
}

/// Writes a problem over the text of its file, in the latest format, keeping comments, order and everything that has
/// not changed.
pub fn write(problem: &ProblemFile, over: &str) -> String {
    let mut document: DocumentMut = over.parse().unwrap_or_default();
    let root = document.as_table_mut();
    Format::LATEST.write(root);
    let linked = problem.entry.linked();
    let main = if linked.is_empty() {
        Some(problem.entry)
    } else {
        linked.iter().find(|problem| problem.name.is_empty()).map(|problem| problem.entry)
    };
    if let Some(main) = main {
        set_text(root, "analysis", main.about.id);
    }
    if !problem.title.is_empty() || root.contains_key("title") {
        set_text(root, "title", &problem.title);
    }
    problem.title_block.write(root);
    if problem.units != UnitSetting::Auto || root.contains_key("units") {
        set_text(root, "units", &problem.units.to_string());
    }
    if let Some(main) = main {
        let inputs = root.entry("inputs").or_insert_with(|| Item::Table(Table::new()));
        write_item(inputs, &problem.draft, &main.inputs());
    }
    linked::write(root, problem.entry, &problem.draft);
    definitions::write(root, &problem.draft, &problem.entry.shape());
    for (answer, unit) in &problem.show {
        let is_here =
            root.get("show").and_then(Item::as_table_like).is_some_and(|show| show.contains_key(answer));
        match linked::place_of_answer(root, problem.entry, answer).filter(|_| !is_here) {
            Some((table, answer)) => write_shown(table, answer, unit),
            None => write_shown(root, answer, unit),
        }
    }
    document.to_string()
}

/// Writes the display of an answer into the `[show]` of a table; an empty one takes it out.
fn write_shown(table: &mut dyn TableLike, answer: &str, unit: &str) {
    if !unit.is_empty() && !table.contains_key("show") {
        table.insert("show", Item::Table(Table::new()));
    }
    match table.get_mut("show").and_then(Item::as_table_like_mut) {
        Some(show) if unit.is_empty() => {
            show.remove(answer);
        }
        Some(show) => set_text(show, answer, unit),
        None => {}
    }
}

/// The error for an id that is no analysis, with the one of that name in another family, or the nearest one.
pub fn no_such_analysis(id: &str) -> Text {
    let known = || registry().iter().map(|entry| entry.about.id);
    let name = |id: &str| id.rsplit('/').next().unwrap_or_default().to_lowercase().replace('_', "-");
    let of_name = known().find(|other| name(other) == name(id));
    match of_name.or_else(|| path::nearest(id, known())) {
        Some(near) => {
            Text::new("there is no analysis `{id}`; did you mean `{near}`?").with("id", id).with("near", near)
        }
        None => Text::new("there is no analysis `{id}`; see `dalembert list`").with("id", id),
    }
}

/// The TOML document of a text, or where it is not TOML.
pub(crate) fn document(text: &str) -> Result<Document<&str>, Vec<FileError>> {
    Document::parse(text).map_err(|err| {
        let key = err.span().and_then(|span| text.get(span)).unwrap_or_default().to_owned();
        let why = match err.message() {
            "duplicate key" => Text::new("duplicate key `{key}`: keep one of the two").with("key", key),
            nested if nested.contains("recurse") => {
                Text::new("the file is nested too deeply to be a problem file")
            }
            // The words of the TOML reader.
            other => Text::new(other.to_owned()),
        };
        vec![FileError { why, span: err.span() }]
    })
}

/// Entry and draft of the problems of a table: the inputs of the analysis `main`, the problems under `problem`, those of
/// linked files, and the tables of definitions and questions beside them.
fn problem_of(
    root: &Table,
    main: Option<&'static Entry>,
    show: &mut Vec<(String, String)>,
    links: &mut linked::Links<'_, '_>,
    reading: &mut FileNotes,
) -> (&'static Entry, Draft) {
    let no_inputs = Item::Table(Table::new());
    let main = main.map(|entry| {
        let inputs = root.get("inputs").unwrap_or(&no_inputs);
        (entry, draft_of(inputs, &entry.inputs(), "inputs", reading))
    });
    let mut others = linked::problems(root, show, reading);
    let common = definitions::lists(root, reading);
    let drafts = main.iter().map(|(_, draft)| draft).chain(others.iter().map(|(_, draft)| draft));
    let files = linked::files(drafts.chain(&common), links, reading);
    others.extend(files);
    linked::check_names(main.as_ref().map(|(entry, _)| *entry), &others, reading);
    let (entry, mut draft) = linked::together(main, others);
    definitions::put(&mut draft, &entry.shape(), common);
    (entry, draft)
}

/// Draft of a case: a problem of an analysis, which links to no other.
pub(crate) fn case_of(root: &Table, entry: &Entry, reading: &mut FileNotes) -> Draft {
    let no_inputs = Item::Table(Table::new());
    let mut draft = draft_of(root.get("inputs").unwrap_or(&no_inputs), &entry.inputs(), "inputs", reading);
    definitions::read(root, &entry.shape(), &mut draft, reading);
    draft
}

/// Problems of an exam question, without their inputs.
pub(crate) fn exam_problems(root: &Table) -> Result<Vec<LinkedProblem>, Text> {
    let table = root.get("problem").and_then(Item::as_table_like).ok_or("there is no [problem.NAME]")?;
    let problem = |(name, item): (&str, &Item)| {
        let table = item.as_table_like().ok_or("a problem is a table")?;
        Ok(LinkedProblem::new(name, analysis_of(table)?, None))
    };
    table.iter().map(problem).collect()
}

/// Draft of an exam question: linked problems alone, which link to no file.
pub(crate) fn exam_of(root: &Table, reading: &mut FileNotes) -> Draft {
    let read: &mut ReadFile<'_> = &mut |_| Err("no other file can be read here".into());
    let mut links = linked::Links { read, are_followed: true, open: Vec::new(), files: Vec::new() };
    problem_of(root, None, &mut Vec::new(), &mut links, reading).1
}

/// Draft of an item of a file, in the shape of the inputs.
pub(crate) fn draft_of(item: &Item, shape: &Shape, path: &str, reading: &mut FileNotes) -> Draft {
    let full = shorthand::in_full(item, shape);
    let item = full.as_ref().unwrap_or(item);
    if let Shape::OneOf(variants) = shape
        && let Some((at, field, value)) = choice::value_alone(item, variants(), path, reading)
    {
        let path = format!("{path}.{}.{}", variants()[at].name, field.name);
        let only = draft_of(value, &field.shape, &path, reading);
        return Draft::OneOf(at, Box::new(Draft::Group(vec![only])));
    }
    let mut fail = |why: Text, span: Option<Range<usize>>| {
        reading.errors.push(FileError {
            why: Text::new("{path}: {why}").with("path", path).with_text("why", why),
            span,
        });
        Draft::blank(shape)
    };
    match shape {
        Shape::Optional(inner) => draft_of(item, inner(), path, reading),
        Shape::Group(fields) => match item.as_table_like() {
            Some(table) => {
                check_inputs(table, fields(), &mut reading.errors);
                let Draft::Group(mut drafts) = Draft::blank(shape) else { return Draft::Absent };
                for (field, draft) in fields().iter().zip(&mut drafts) {
                    let path = format!("{path}.{}", field.name);
                    match table.get(field.name) {
                        Some(item) => *draft = former::draft_of_field(item, field, &path, reading),
                        None => format::left_out(draft, field, &path, reading),
                    }
                }
                Draft::Group(drafts)
            }
            None => {
                let why = Text::new("a table of inputs is needed here, written {form}");
                fail(why.with("form", describe::form(shape)), item.span())
            }
        },
        // No alternative is chosen: `Draft::read` asks for one.
        Shape::OneOf(_) if item.as_table_like().is_some_and(TableLike::is_empty) => Draft::Absent,
        Shape::OneOf(variants) => {
            if item.as_str().is_some_and(|text| text.trim_start().starts_with('?')) {
                let why = Text::new("a choice cannot be unknown: write one of {known}");
                return fail(why.with("known", describe::forms_of(variants())), item.span());
            }
            let names = || variants().iter().map(|variant| variant.name);
            let (name, fields) = match (item.as_str(), item.as_table_like()) {
                (Some(name), _) => (name, None),
                (None, Some(table)) if table.len() == 1 => match table.iter().next() {
                    Some((name, fields)) => (name, Some(fields)),
                    None => ("", None),
                },
                _ => return fail(choice::needed(variants()), item.span()),
            };
            match names().position(|known| known == name) {
                Some(at) => match fields {
                    Some(fields) => {
                        let group = Shape::Group(variants()[at].fields);
                        Draft::OneOf(
                            at,
                            Box::new(draft_of(fields, &group, &format!("{path}.{name}"), reading)),
                        )
                    }
                    None => {
                        let mut draft = Draft::alternative(shape, at);
                        format::left_out_fields(&mut draft, shape, path, reading);
                        draft
                    }
                },
                None => {
                    let former = variants()
                        .iter()
                        .enumerate()
                        .find_map(|(at, variant)| Some((at, former::place(variant.former, name)?, fields?)));
                    let Some((at, place, fields)) = former else {
                        return fail(choice::unknown(name, variants()), item.span());
                    };
                    let group = Shape::Group(variants()[at].fields);
                    let now = format!("{path}.{}", variants()[at].name);
                    let inner =
                        former::draft_of(fields, &group, [&format!("{path}.{name}"), &now], place, reading);
                    Draft::OneOf(at, Box::new(inner))
                }
            }
        }
        Shape::Rows { item: inner, most, .. } => {
            let have = match item {
                Item::ArrayOfTables(tables) => tables.len(),
                _ => item.as_array().map_or(0, toml_edit::Array::len),
            };
            if have > *most {
                return fail(draft::too_many_rows(have, *most), item.span());
            }
            let rows: Vec<Item> = match item {
                Item::ArrayOfTables(tables) => tables.iter().cloned().map(Item::Table).collect(),
                _ => match item.as_array() {
                    Some(array) => array.iter().cloned().map(Item::Value).collect(),
                    None => {
                        let why = Text::new("a list is needed here, written {form}");
                        return fail(why.with("form", describe::form(shape)), item.span());
                    }
                },
            };
            let rows = rows.iter().enumerate();
            Draft::Rows(
                rows.map(|(n, row)| draft_of(row, inner(), &format!("{path}[{}]", n + 1), reading)).collect(),
            )
        }
        Shape::Table(columns) => match rows::table_text(item, columns()) {
            Ok(text) => {
                let text = reading
                    .kind
                    .and_then(|at| table::with_units_of_kind(&text, columns(), at))
                    .unwrap_or(text);
                Draft::Leaf(format::table_text(text, columns(), path, reading))
            }
            Err((why, span)) => fail(why, span),
        },
        Shape::Vector(..) => match item.as_value() {
            Some(Toml::Array(components)) => {
                let text = rows::in_brackets(components);
                Draft::Leaf(format::with_decimal_commas(text, shape, path, reading))
            }
            Some(value) => Draft::Leaf(format::with_decimal_commas(plain(value), shape, path, reading)),
            None => fail(one_value(shape), item.span()),
        },
        _ => match item.as_value() {
            Some(value @ (Toml::String(_) | Toml::Integer(_) | Toml::Float(_) | Toml::Boolean(_))) => {
                let text = format::with_decimal_commas(plain(value), shape, path, reading);
                Draft::Leaf(former::with_unit(text, shape, reading.kind))
            }
            _ => fail(one_value(shape), item.span()),
        },
    }
}

fn one_value(shape: &Shape) -> Text {
    Text::new("one value is needed here, written {form}").with("form", describe::form(shape))
}

/// Every key is that of an input.
fn check_inputs(table: &dyn TableLike, fields: &'static [Field], errors: &mut Vec<FileError>) {
    for (key, item) in table.iter().filter(|(key, _)| !fields.iter().any(|field| field.name == *key)) {
        let span = table.key(key).and_then(toml_edit::Key::span).or_else(|| item.span());
        errors.push(FileError { why: path::unknown_input("", key, fields).why, span });
    }
}

fn check_keys(table: &dyn TableLike, known: &[&str], errors: &mut Vec<FileError>) {
    for (key, item) in table.iter() {
        if !known.contains(&key) {
            let span = table.key(key).and_then(toml_edit::Key::span).or_else(|| item.span());
            errors.push(FileError { why: path::unknown("", key, known.iter().copied()).why, span });
        }
    }
}

fn span(table: &Table, key: &str) -> Option<Range<usize>> {
    table.get(key).and_then(Item::span)
}

fn text_at(table: &Table, key: &str, errors: &mut Vec<FileError>) -> Option<String> {
    let item = table.get(key)?;
    if item.as_str().is_none() {
        let why = Text::new("`{key}` must be a text in quotes").with("key", key);
        errors.push(FileError { why, span: item.span() });
    }
    item.as_str().map(str::to_owned)
}

/// The setting of units of a file; `None` where it is left out.
fn units_of(table: &Table, errors: &mut Vec<FileError>) -> Option<UnitSetting> {
    let text = text_at(table, "units", errors)?;
    let read = UnitSetting::read(&text).map_err(|why| {
        errors.push(FileError { why, span: span(table, "units") });
    });
    read.ok()
}

/// A value without quotes and comments.
fn plain(value: &Toml) -> String {
    match value {
        Toml::String(text) => text.value().clone(),
        other => other.clone().decorated("", "").to_string(),
    }
}
