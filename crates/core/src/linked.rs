//! Linked problems: several problems of one file that feed each other, as one analysis whose inputs are theirs.
//!
//! The inputs of each stand in a group of its name, `fan.mass`, and its answers have the name before them,
//! `fan.amplitude`. A problem of another file is one of them, under the name of that file.

use std::sync::{Mutex, PoisonError};

use crate::{About, Entry, Field, Fields, Shape, definitions::with_common, intern::intern};

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
