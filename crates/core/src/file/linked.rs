//! Problems that feed problems: several in one file, `[problem.fan]`, and those of other files, `"@beam.toml:stiffness"`.

use sha2::{Digest as _, Sha256};
use toml_edit::{Item, Table, TableLike};

use super::{
    FileError, FileNotes, ProblemFile, analysis_of, check_keys, definitions, draft_of, read_show, set_text,
    write_item,
};
use crate::{COMMON_LISTS, Draft, Entry, LinkedProblem, Text, linked};

/// The keys of one of several problems of a file.
const KEYS: [&str; 8] = ["analysis", "title", "let", "inputs", "given", "ask", "configuration", "show"];
/// The most files that are linked behind one another.
const DEEPEST: usize = 16;
/// The longest file that is linked, in bytes.
const LONGEST: usize = 1 << 20;

/// Reads the text of a linked file, by its path from the folder of the first one.
pub type ReadFile<'f> = dyn FnMut(&str) -> Result<String, Text> + 'f;

/// A file that another one links to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LinkedFile {
    /// Path from the folder of the first file.
    pub path: String,
    /// Text that was read.
    pub text: String,
    /// True if that is the text of a problem as it is open, with changes that are not saved.
    pub unsaved: bool,
}

impl LinkedFile {
    /// The note on it in reports: path and SHA-256 of the text that was read.
    pub fn note(&self) -> Text {
        let digest = Sha256::digest(self.text.as_bytes());
        let digits = digest.iter().fold(String::new(), |digits, byte| digits + &format!("{byte:02x}"));
        let note = if self.unsaved {
            "linked file {file} as it is open, with unsaved changes, SHA-256 {digest}"
        } else {
            "linked file {file}, SHA-256 {digest}"
        };
        Text::new(note).with("file", &self.path).with("digest", digits)
    }
}

/// The linked files of a file on the way to it, and the reader of their texts.
pub(super) struct Links<'f, 'r> {
    pub(super) read: &'r mut ReadFile<'f>,
    /// False where links stay as they are typed.
    pub(super) are_followed: bool,
    /// Files that are being read, outermost first.
    pub(super) open: Vec<String>,
    pub(super) files: Vec<LinkedFile>,
}

/// Problems of a file under `[problem.NAME]`, with their drafts.
pub(super) fn problems(
    root: &Table,
    show: &mut Vec<(String, String)>,
    reading: &mut FileNotes,
) -> Vec<(LinkedProblem, Draft)> {
    let Some(item) = root.get("problem") else { return Vec::new() };
    let Some(table) = item.as_table_like() else {
        let why = "`problem` holds named problems, as in [problem.fan]";
        reading.errors.push(FileError { why: why.into(), span: item.span() });
        return Vec::new();
    };
    table.iter().filter_map(|(name, item)| problem(name, item, show, reading)).collect()
}

fn problem(
    name: &str,
    item: &Item,
    show: &mut Vec<(String, String)>,
    reading: &mut FileNotes,
) -> Option<(LinkedProblem, Draft)> {
    let mut fail = |why: Text| {
        reading.errors.push(FileError { why, span: item.span() });
    };
    if !linked::is_problem_name(name) {
        fail(
            Text::new("`{name}` is no name of a problem: write letters, digits and _, a letter first")
                .with("name", name),
        );
        return None;
    }
    let Some(table) = item.as_table_like() else {
        fail(
            Text::new("problem.{name}: a table with an analysis is needed, as in [problem.{name}]")
                .with("name", name),
        );
        return None;
    };
    let entry = match analysis_of(table) {
        Ok(entry) => entry,
        Err(why) => {
            let span = table.get("analysis").unwrap_or(item).span();
            let why = Text::new("problem.{name}: {why}").with("name", name).with_text("why", why);
            reading.errors.push(FileError { why, span });
            return None;
        }
    };
    check_keys(table, &KEYS, &mut reading.errors);
    let no_inputs = Item::Table(Table::new());
    let inputs = table.get("inputs").unwrap_or(&no_inputs);
    let mut draft = draft_of(inputs, &entry.inputs(), &format!("problem.{name}.inputs"), reading);
    definitions::read(table, &entry.shape(), &mut draft, reading);
    let shown = read_show(table, &mut reading.errors);
    show.extend(shown.into_iter().map(|(answer, display)| (format!("{name}.{answer}"), display)));
    Some((LinkedProblem::new(name, entry, None), draft))
}

/// The problems of the files that formulas of drafts link to, `@beam.toml:stiffness`.
pub(super) fn files<'d>(
    drafts: impl IntoIterator<Item = &'d Draft>,
    links: &mut Links<'_, '_>,
    reading: &mut FileNotes,
) -> Vec<(LinkedProblem, Draft)> {
    let mut named = Vec::new();
    if !links.are_followed {
        return Vec::new();
    }
    for draft in drafts {
        leaves(draft, &mut |text| {
            for link in links_in(text) {
                if !named.contains(&link) {
                    named.push(link);
                }
            }
        });
    }
    let mut found: Vec<(LinkedProblem, Draft)> = Vec::new();
    for file in named {
        let fail = |why: Text| FileError { why, span: None };
        let name = linked::name_of_file(&file);
        match read(&file, links) {
            Ok(problem) => {
                let note = |note| Text::new("{file}: {note}").with("file", &file).with_text("note", note);
                reading.notes.extend(problem.notes.into_iter().map(note));
                found.push((LinkedProblem::new(&name, problem.entry, Some(&file)), problem.draft));
            }
            Err(why) => {
                let why = Text::new("{file}: {why}").with("file", format!("@{file}")).with_text("why", why);
                reading.errors.push(fail(why));
            }
        }
    }
    found
}

/// The problem of a linked file.
fn read(file: &str, links: &mut Links<'_, '_>) -> Result<ProblemFile, Text> {
    let folder = links.open.last().and_then(|open| open.rsplit_once('/')).map(|(folder, _)| folder);
    let path = normal(folder, file);
    if let Some(start) = links.open.iter().position(|open| *open == path) {
        let circle: Vec<&str> =
            links.open[start..].iter().map(String::as_str).chain([path.as_str()]).collect();
        return Err(Text::new("the files link to each other in a circle: {circle}")
            .with("circle", circle.join(" → ")));
    }
    if links.open.len() >= DEEPEST {
        return Err(Text::new("more than {most} files are linked behind one another").with("most", DEEPEST));
    }
    let text = (links.read)(&path)?;
    if text.len() > LONGEST {
        return Err("the file is larger than 1 MiB: it is no problem file".into());
    }
    if !super::is_problem(&text) {
        return Err("this is no problem file: only problem files can be linked".into());
    }
    links.open.push(path.clone());
    let problem = super::parse_open(&text, links);
    links.open.pop();
    if links.files.iter().all(|known| known.path != path) {
        links.files.push(LinkedFile { path, text, unsaved: false });
    }
    problem.map_err(|errors| errors.into_iter().next().map_or_else(Text::default, |error| error.why))
}

/// A path from a folder, without steps up and down.
fn normal(folder: Option<&str>, file: &str) -> String {
    let mut parts: Vec<&str> = Vec::new();
    let absolute = file.starts_with('/');
    let from = folder.filter(|_| !absolute).unwrap_or("");
    for part in from.split('/').chain(file.split(['/', '\\'])) {
        match part {
            "" | "." => {}
            ".." if parts.last().is_some_and(|last| *last != "..") => {
                parts.pop();
            }
            part => parts.push(part),
        }
    }
    format!("{}{}", if absolute { "/" } else { "" }, parts.join("/"))
}

fn leaves(draft: &Draft, visit: &mut dyn FnMut(&str)) {
    match draft {
        Draft::Leaf(text) => visit(text),
        Draft::Group(all) | Draft::Rows(all) => all.iter().for_each(|inner| leaves(inner, visit)),
        Draft::OneOf(_, inner) => leaves(inner, visit),
        Draft::Absent => {}
    }
}

/// The files that a text links to.
fn links_in(text: &str) -> Vec<String> {
    let links = text.split('@').skip(1).filter_map(|rest| {
        let (file, _) = rest.split_once(':')?;
        let is_path =
            !file.is_empty() && !file.contains(|c: char| c.is_whitespace() || "()*+,;\"".contains(c));
        is_path.then(|| file.to_owned())
    });
    links.collect()
}

/// Reports names of linked problems that are those of inputs or of another problem.
pub(super) fn check_names(
    main: Option<&'static Entry>,
    others: &[(LinkedProblem, Draft)],
    reading: &mut FileNotes,
) {
    let own = main.map_or(&[][..], |entry| entry.inputs().fields(None));
    for (n, (problem, _)) in others.iter().enumerate() {
        let name = problem.name;
        let is_input =
            own.iter().any(|field| field.name == name) || COMMON_LISTS.contains(&name) || name == "inputs";
        let why = if is_input {
            Text::new("`{name}` is the name of an input: give the linked problem another name")
        } else if others[..n].iter().any(|(before, _)| before.name == name) {
            Text::new("two linked problems are called `{name}`: give one of them another name")
        } else {
            continue;
        };
        reading.errors.push(FileError { why: why.with("name", name), span: None });
    }
}

/// The entry of a problem with those that are linked to it, and the draft of them all.
pub(super) fn together(
    main: Option<(&'static Entry, Draft)>,
    others: Vec<(LinkedProblem, Draft)>,
) -> (&'static Entry, Draft) {
    let mut problems: Vec<LinkedProblem> = Vec::new();
    let mut drafts: Vec<Draft> = Vec::new();
    if let Some((entry, draft)) = main {
        if others.is_empty() {
            return (entry, draft);
        }
        problems.push(LinkedProblem::new("", entry, None));
        let Draft::Group(all) = draft else { return (entry, draft) };
        drafts.extend(all.into_iter().take(entry.inputs().fields(None).len()));
    }
    for (problem, draft) in others {
        problems.push(problem);
        drafts.push(draft);
    }
    (linked::entry(&problems), Draft::Group(drafts))
}

/// Moves what a file says of its problem to the table of the linked problem that it is now, with its comments.
fn name_problem(root: &mut Table, entry: &Entry) {
    let Some(analysis) = root.get("analysis").and_then(Item::as_str) else { return };
    let is_it = |problem: &&LinkedProblem| problem.file.is_none() && problem.entry.about.id == analysis;
    let Some(name) = entry.linked().iter().find(is_it).map(|problem| problem.name) else { return };
    let mut table = Table::new();
    for key in KEYS.into_iter().filter(|key| *key != "title") {
        if let Some((key, mut item)) = root.remove_entry(key) {
            unplace(&mut item);
            table.insert_formatted(&key, item);
        }
    }
    table.decor_mut().set_prefix("\n");
    if let Some(problems) = tables_of_problems(root) {
        problems.insert(name, Item::Table(table));
    }
}

/// Lets tables stand where their key does, and no more where they stood.
fn unplace(item: &mut Item) {
    match item {
        Item::Table(table) => {
            table.set_position(None);
            table.iter_mut().for_each(|(_, item)| unplace(item));
        }
        Item::ArrayOfTables(tables) => {
            for table in tables.iter_mut() {
                table.set_position(None);
                table.iter_mut().for_each(|(_, item)| unplace(item));
            }
        }
        _ => {}
    }
}

fn tables_of_problems(root: &mut Table) -> Option<&mut dyn TableLike> {
    let problems = root.entry("problem").or_insert_with(|| {
        let mut table = Table::new();
        table.set_implicit(true);
        Item::Table(table)
    });
    problems.as_table_like_mut()
}

/// Writes the linked problems of a draft that have no file of their own into the tables of a file; those that are gone are
/// taken out.
pub(super) fn write(root: &mut Table, entry: &Entry, draft: &Draft) {
    if !entry.linked().is_empty() && entry.linked().iter().all(|problem| !problem.name.is_empty()) {
        name_problem(root, entry);
    }
    let own: Vec<&LinkedProblem> =
        entry.linked().iter().filter(|problem| !problem.name.is_empty() && problem.file.is_none()).collect();
    if let Some(problems) = root.get_mut("problem").and_then(Item::as_table_like_mut) {
        definitions::keep_only(problems, &|name| own.iter().any(|problem| problem.name == name));
        if problems.is_empty() {
            root.remove("problem");
        }
    }
    for problem in own {
        let Ok((draft, _)) = draft.at(&entry.shape(), problem.name) else { continue };
        let Some(problems) = tables_of_problems(root) else { return };
        if !problems.contains_key(problem.name) {
            problems.insert(problem.name, Item::Table(Table::new()));
        }
        let Some(table) = problems.get_mut(problem.name).and_then(Item::as_table_mut) else { continue };
        set_text(table, "analysis", problem.entry.about.id);
        let inputs = table.entry("inputs").or_insert_with(|| Item::Table(Table::new()));
        write_item(inputs, draft, &problem.entry.inputs());
        definitions::write(table, draft, &problem.entry.shape());
    }
}

/// The table of the linked problem that an answer is of, and the name of the answer within it; `None` where it is of the
/// problem of the file itself or of another file.
pub(super) fn place_of_answer<'d, 'a>(
    root: &'d mut Table,
    entry: &Entry,
    answer: &'a str,
) -> Option<(&'d mut dyn TableLike, &'a str)> {
    let (name, rest) = answer.split_once('.')?;
    entry.linked().iter().find(|problem| problem.name == name && problem.file.is_none())?;
    let problem = root.get_mut("problem")?.as_table_like_mut()?.get_mut(name)?;
    Some((problem.as_table_like_mut()?, rest))
}

/// The item of the inputs of a problem that a path leads to, and the rest of the path.
pub(super) fn place<'d, 'p>(root: &'d Table, path: &'p str) -> Option<(&'d dyn TableLike, &'p str)> {
    let (name, rest) = path.split_once('.')?;
    let problem = root.get("problem")?.as_table_like()?.get(name)?;
    Some((problem.as_table_like()?, rest))
}
