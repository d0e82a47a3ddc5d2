//! Linked problems: several problems of one file that feed each other, as one analysis whose inputs are theirs.
//!
//! The inputs of each stand in a group of its name, `fan.mass`, and its answers have the name before them,
//! `fan.amplitude`. A problem of another file is one of them, under the name of that file.

use std::sync::{Mutex, PoisonError};

use crate::{
    About, COMMON_LISTS, Draft, Entry, Field, Fields, Shape, Text, definitions::with_common, intern::intern,
};

/// One of several linked problems.
#[derive(Clone, Copy, Debug)]
pub struct LinkedProblem {
    /// Name before its inputs and answers; empty for the problem that a file is of, to which others are linked.
    pub name: &'static str,
    /// Analysis.
    pub entry: &'static Entry,
    /// File that it is read from, where it is not the file of the others.
    pub file: Option<&'static str>,
}

/// The id of all linked problems that are not linked to a problem of an analysis.
pub const ID: &str = "linked-problems";

impl LinkedProblem {
    fn is(&self, other: &LinkedProblem) -> bool {
        let of = |problem: &LinkedProblem| (problem.name, problem.entry.about.id, problem.file);
        of(self) == of(other)
    }

    /// A problem among linked ones.
    pub(crate) fn new(name: &str, entry: &'static Entry, file: Option<&str>) -> Self {
        Self { name: intern(name), entry, file: file.map(intern) }
    }
}

/// Returns true if a word may be the name of one of several problems.
pub fn is_problem_name(name: &str) -> bool {
    name.chars().next().is_some_and(char::is_alphabetic)
        && name.chars().all(|c| c.is_alphanumeric() || c == '_')
        && !COMMON_LISTS.contains(&name)
        && name != "inputs"
}

/// Reason for which a problem cannot be added under a name to those of an entry.
///
/// # Errors
/// A word that is no name, or that of another problem.
pub fn check_name(entry: &Entry, name: &str) -> Result<(), Text> {
    if !is_problem_name(name) {
        let why = "`{name}` is no name of a problem: write letters, digits and _, a letter first";
        return Err(Text::new(why).with("name", name));
    }
    if entry.linked().iter().any(|problem| problem.name == name) {
        let why = "two linked problems are called `{name}`: give one of them another name";
        return Err(Text::new(why).with("name", name));
    }
    Ok(())
}

/// A name for a problem of an analysis, from its id: `rotating_unbalance`.
pub fn usual_name(entry: &Entry) -> String {
    let id = entry.about.id;
    id.rsplit('/').next().unwrap_or(id).replace('-', "_")
}

/// The problem of an entry that has no name, `None` where each has one.
pub fn unnamed(entry: &'static Entry) -> Option<&'static Entry> {
    match entry.linked() {
        [] => Some(entry),
        linked => linked.iter().find(|problem| problem.name.is_empty()).map(|problem| problem.entry),
    }
}

/// The same problems with a name for the one that has none: its inputs and lists are those of `[problem.NAME]` then.
pub fn named(entry: &'static Entry, draft: &Draft, name: &str) -> (&'static Entry, Draft) {
    let (Some(main), Draft::Group(all)) = (unnamed(entry), draft) else { return (entry, draft.clone()) };
    let own = main.inputs().fields(None).len();
    let lists = all.len().saturating_sub(COMMON_LISTS.len());
    let (inputs, others) = all[..lists].split_at(own.min(lists));
    let main_draft = Draft::Group(inputs.iter().chain(&all[lists..]).cloned().collect());
    let linked = entry.linked().iter().filter(|problem| !problem.name.is_empty()).copied();
    let problems: Vec<LinkedProblem> =
        [LinkedProblem::new(name, main, None)].into_iter().chain(linked).collect();
    let no_lists = vec![Draft::Rows(Vec::new()); COMMON_LISTS.len()];
    let drafts = [main_draft].into_iter().chain(others.iter().cloned()).chain(no_lists);
    (self::entry(&problems), Draft::Group(drafts.collect()))
}

/// The same named problems with a blank one more, behind those of the file itself.
pub fn with_problem(
    entry: &'static Entry,
    draft: &Draft,
    name: &str,
    of: &'static Entry,
) -> (&'static Entry, Draft) {
    let Draft::Group(all) = draft else { return (entry, draft.clone()) };
    let (mut problems, mut all) = (entry.linked().to_vec(), all.clone());
    let at = problems.iter().position(|problem| problem.file.is_some()).unwrap_or(problems.len());
    problems.insert(at, LinkedProblem::new(name, of, None));
    all.insert(at, Draft::blank(&of.shape()));
    (self::entry(&problems), Draft::Group(all))
}

/// The same problems without the one of a name, where another one is left.
pub fn without(entry: &'static Entry, draft: &Draft, name: &str) -> Option<(&'static Entry, Draft)> {
    let Draft::Group(all) = draft else { return None };
    let (mut problems, mut all, main) = (entry.linked().to_vec(), all.clone(), unnamed(entry));
    let at = problems.iter().position(|problem| problem.name == name && !name.is_empty())?;
    let own = problems.iter().filter(|problem| problem.file.is_none()).count();
    if own < 2 {
        return None;
    }
    let inputs = main.map_or(0, |main| main.inputs().fields(None).len());
    let named = at - usize::from(main.is_some());
    problems.remove(at);
    all.remove(inputs + named);
    let is_alone = problems.len() == 1 && main.is_some();
    let entry = main.filter(|_| is_alone).unwrap_or_else(|| self::entry(&problems));
    Some((entry, Draft::Group(all)))
}

/// The same problems with linked files as another reading of them has them: those that are there, or with `all` every one
/// that was read.
pub fn with_files(
    entry: &'static Entry,
    draft: &Draft,
    (read, read_draft): (&'static Entry, &Draft),
    all: bool,
) -> (&'static Entry, Draft) {
    let Draft::Group(parts) = draft else { return (entry, draft.clone()) };
    let is_file = |problem: &&LinkedProblem| problem.file.is_some();
    let part_of =
        |of: &Entry, draft: &Draft, name: &str| draft.at(&of.shape(), name).map(|(part, _)| part.clone());
    let main = unnamed(entry);
    let inputs = main.map_or(0, |main| main.inputs().fields(None).len());
    let lists = parts.len().saturating_sub(COMMON_LISTS.len());
    let own = entry.linked().iter().filter(|problem| problem.file.is_none() && !problem.name.is_empty());
    let own = own.filter_map(|problem| Some((*problem, part_of(entry, draft, problem.name).ok()?)));
    let read_files = || {
        let files = read.linked().iter().filter(is_file);
        files.filter_map(|problem| Some((*problem, part_of(read, read_draft, problem.name).ok()?)))
    };
    let files: Vec<(LinkedProblem, Draft)> = if all {
        read_files().collect()
    } else {
        let known = entry.linked().iter().filter(is_file);
        let renewed = |problem: &LinkedProblem| {
            let same =
                read_files().find(|(other, _)| (other.name, other.file) == (problem.name, problem.file));
            same.or_else(|| Some((*problem, part_of(entry, draft, problem.name).ok()?)))
        };
        known.filter_map(renewed).collect()
    };
    let (problems, drafts): (Vec<LinkedProblem>, Vec<Draft>) = own.chain(files).unzip();
    let parts = parts[..inputs.min(lists)].iter().chain(&drafts).chain(&parts[lists..]).cloned();
    let draft = Draft::Group(parts.collect());
    match main {
        Some(main) if problems.is_empty() => (main, draft),
        main => {
            let main = main.map(|main| LinkedProblem::new("", main, None));
            (self::entry(&main.into_iter().chain(problems).collect::<Vec<_>>()), draft)
        }
    }
}

/// The entry of linked problems; one for each list, made when it is first asked for.
pub(crate) fn entry(problems: &[LinkedProblem]) -> &'static Entry {
    static KNOWN: Mutex<Vec<&'static Entry>> = Mutex::new(Vec::new());
    let mut known = KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
    let is_same = |entry: &&&'static Entry| {
        let linked = entry.linked();
        linked.len() == problems.len() && linked.iter().zip(problems).all(|(a, b)| a.is(b))
    };
    if let Some(entry) = known.iter().find(is_same) {
        return entry;
    }
    let problems: &'static [LinkedProblem] = problems.to_vec().leak();
    let made: &'static Entry = Box::leak(Box::new(of(problems)));
    known.push(made);
    made
}

fn of(problems: &'static [LinkedProblem]) -> Entry {
    let main = problems.iter().find(|problem| problem.name.is_empty());
    let groups: Vec<Field> = problems.iter().filter(|problem| !problem.name.is_empty()).map(group).collect();
    let own = main.map_or(&[][..], |main| main.entry.inputs().fields(None));
    let inputs: &'static [Field] = own.iter().chain(&groups).copied().collect::<Vec<Field>>().leak();
    let shape = |fields: &'static [Field]| -> Shape {
        let list: &'static (dyn Fn() -> &'static [Field] + Sync) = Box::leak(Box::new(move || fields));
        Shape::Group(Fields(list))
    };
    let about = match main {
        Some(main) => main.entry.about,
        None => Box::leak(Box::new(about(problems))),
    };
    Entry::of_linked(about, [shape(inputs), shape(with_common(inputs))], problems)
}

/// The group of the inputs of a problem.
fn group(problem: &LinkedProblem) -> Field {
    Field {
        name: problem.name,
        label: problem.file.map_or(problem.name, |file| intern(&format!("@{file}"))),
        help: problem.entry.about.title,
        symbol: "",
        default: None,
        default_before: None,
        kept_in: None,
        former: &[],
        shape: problem.entry.shape(),
    }
}

fn about(problems: &'static [LinkedProblem]) -> About {
    let mut sources = Vec::new();
    for source in problems.iter().flat_map(|problem| problem.entry.about.sources) {
        if !sources.contains(source) {
            sources.push(*source);
        }
    }
    About {
        id: ID,
        title: "Linked problems",
        topic: "Linked problems",
        summary: "Several problems that feed each other.",
        main: &[],
        keywords: "",
        sources: sources.leak(),
        cases: "",
    }
}

/// The name of the problem of a linked file: that of the file without its folder and ending.
pub(crate) fn name_of_file(file: &str) -> String {
    let name = file.rsplit(['/', '\\']).next().unwrap_or(file);
    let stem = name.strip_suffix(".toml").unwrap_or(name);
    stem.chars().map(|c| if c.is_alphanumeric() { c } else { '_' }).collect()
}

/// File and name of a link such as `@beam.toml:stiffness`.
pub(crate) fn file_link(text: &str) -> Option<(&str, &str)> {
    text.strip_prefix('@')?.rsplit_once(':')
}

/// Problem of an input of an entry, and its path within it.
pub(crate) fn problem_of<'e, 'p>(entry: &'e Entry, path: &'p str) -> (&'e Entry, &'p str) {
    let named = entry.linked().iter().find_map(|problem| {
        let rest = path.strip_prefix(problem.name)?.strip_prefix('.')?;
        (!problem.name.is_empty()).then(|| problem_of(problem.entry, rest))
    });
    let main = || entry.linked().iter().find(|problem| problem.name.is_empty());
    named.unwrap_or_else(|| main().map_or((entry, path), |problem| problem_of(problem.entry, path)))
}
