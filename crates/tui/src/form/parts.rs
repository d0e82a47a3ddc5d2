//! The parts of a problem file that have a tab: problems, configurations, linked files. One of them is on the screen.
//!
//! There is one draft of all. A configuration is seen as the inputs of its problem with its own texts in place of some; what
//! is typed there goes to its list.

use std::collections::HashSet;

use dalembert_core::{
    COMMON_LISTS, Draft, Entry, Field, Shape, Text, form::push_field, is_within, linked, normalised,
    within_problem,
};

use super::{Change, Form, FormLine, Role, lines};

/// A part of a problem file: a problem or a configuration.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FilePart {
    /// Name before its answers: `fan`, `weighted`, `fan.weighted`; empty for the problem of the file itself.
    pub name: String,
    /// Name of the problem whose inputs it has: `fan`; empty for that of the file itself.
    pub problem: String,
    /// Kind of part.
    pub role: PartRole,
}

/// Kind of a part of a problem file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PartRole {
    /// A problem.
    Problem,
    /// The configuration of that name.
    Configuration(String),
    /// The problem of a linked file, by its path from the folder of this one.
    File(&'static str),
    /// Definitions, questions and given answers over all problems.
    Shared,
}

impl FilePart {
    /// Title of its tab.
    pub fn title(&self) -> Text {
        match &self.role {
            PartRole::Problem if self.name.is_empty() => Text::new("Base problem"),
            PartRole::Shared => Text::new("All problems"),
            PartRole::File(file) => Text::verbatim(format!("@{file}")),
            PartRole::Problem | PartRole::Configuration(_) => Text::verbatim(&self.name),
        }
    }

    /// A path or a name of its problem as it is written from outside.
    pub(super) fn outside(&self, inner: &str) -> String {
        if self.problem.is_empty() { inner.to_owned() } else { format!("{}.{inner}", self.problem) }
    }
}

/// Place of the text of a line of the form.
#[derive(Clone, Debug)]
pub(super) enum Target {
    /// The leaf at a path.
    Leaf(String),
    /// A row of the list at a path, of a configuration that changes an input; `None` where it does not yet.
    Change { list: String, configuration: String, input: String, row: Option<usize> },
}

impl Target {
    /// Writes a text; an empty one gives an input of a configuration back to the problem.
    pub(super) fn write(&self, draft: &mut Draft, shape: &Shape, text: String) -> Option<()> {
        let Target::Change { list, configuration, input, row } = self else {
            let Target::Leaf(path) = self else { return None };
            return draft.write(shape, path, text).ok();
        };
        let (Draft::Rows(rows), _) = draft.at_mut(shape, list).ok()? else { return None };
        let of = |row: &Draft| cells(row)[0] == configuration.as_str();
        let whole = |[name, input, text]: [&str; 3]| {
            Draft::Group([name, input, text].map(|text| Draft::Leaf(text.to_owned())).to_vec())
        };
        match (*row, text.trim().is_empty()) {
            (None, true) => {}
            (Some(row), true) if rows.iter().filter(|row| of(row)).count() > 1 => drop(rows.remove(row)),
            // A configuration without a change stays.
            (Some(row), true) => *rows.get_mut(row)? = whole([configuration, "", ""]),
            (Some(row), false) => {
                let written = cells(rows.get(row)?)[1].to_owned();
                *rows.get_mut(row)? = whole([configuration, &written, &text]);
            }
            (None, false) => {
                let unused = rows.iter().position(|row| of(row) && cells(row)[1..] == ["", ""]);
                let new = whole([configuration, input, &text]);
                match unused {
                    Some(row) => rows[row] = new,
                    None => rows.insert(rows.iter().rposition(of).map_or(rows.len(), |last| last + 1), new),
                }
            }
        }
        Some(())
    }
}

/// Name, input and formula of a row of a configuration.
fn cells(row: &Draft) -> [&str; 3] {
    let cell = |at: usize| match row {
        Draft::Group(cells) => match cells.get(at) {
            Some(Draft::Leaf(text)) => text.trim(),
            _ => "",
        },
        _ => "",
    };
    [0, 1, 2].map(cell)
}

/// Parts of a draft, in the order of their tabs: one alone where there is nothing but a problem.
pub(super) fn parts(shape: &Shape, draft: &Draft) -> Vec<FilePart> {
    let fields = shape.fields(None);
    let part = |name: &str, role| FilePart { name: name.to_owned(), problem: name.to_owned(), role };
    let others = || fields.iter().filter(|field| is_problem(fields, field.name));
    let has_own =
        fields.iter().any(|field| !COMMON_LISTS.contains(&field.name) && !is_problem(fields, field.name));
    let mut found = Vec::new();
    if has_own || others().next().is_none() {
        found.push(part("", PartRole::Problem));
        add_configurations(shape, draft, &mut found);
    }
    for field in others() {
        match field.label.strip_prefix('@') {
            Some(file) => found.push(part(field.name, PartRole::File(file))),
            None => {
                found.push(part(field.name, PartRole::Problem));
                add_configurations(shape, draft, &mut found);
            }
        }
    }
    if !has_own && others().next().is_some() {
        found.push(part("", PartRole::Shared));
    }
    found
}

/// Adds the configurations of the last part.
fn add_configurations(shape: &Shape, draft: &Draft, found: &mut Vec<FilePart>) {
    let Some(problem) = found.last().cloned() else { return };
    for row in rows(shape, draft, &problem.outside("configuration")) {
        let configuration = cells(row)[0];
        let name = problem.outside(configuration);
        if !configuration.is_empty() && found.iter().all(|part| part.name != name) {
            let role = PartRole::Configuration(configuration.to_owned());
            found.push(FilePart { name, role, ..problem.clone() });
        }
    }
}

fn rows<'d>(shape: &Shape, draft: &'d Draft, list: &str) -> &'d [Draft] {
    match draft.at(shape, list) {
        Ok((Draft::Rows(rows), _)) => rows,
        _ => &[],
    }
}

/// Returns true if a field is a linked problem.
fn is_problem(fields: &[Field], name: &str) -> bool {
    within_problem(fields, &format!("{name}.")).0 == name
}

/// Lines of a part; those of a configuration have its texts.
pub(super) fn lines_of(shape: &Shape, draft: &Draft, part: &FilePart) -> Vec<FormLine> {
    let fields = shape.fields(None);
    let Draft::Group(drafts) = draft else { return Vec::new() };
    let mut found = Vec::new();
    if part.problem.is_empty() {
        for (field, draft) in fields.iter().zip(drafts).filter(|(field, _)| !is_problem(fields, field.name)) {
            push_field(field, draft, "", 0, &mut found);
        }
    } else if let Ok((inner, shape)) = draft.at(shape, &part.problem) {
        found = lines(&shape, inner);
        for line in &mut found {
            line.path = part.outside(&line.path);
        }
    }
    if let PartRole::Configuration(configuration) = &part.role {
        found.retain(|line| !COMMON_LISTS.iter().any(|list| is_within(&line.path, &part.outside(list))));
        let list = part.outside("configuration");
        let all = rows(shape, draft, &list);
        for (n, row) in all.iter().enumerate().filter(|(_, row)| cells(row)[0] == configuration.as_str()) {
            let [_, input, text] = cells(row);
            if let Some(line) = line_of(&mut found, &part.outside(input), input)
                && let Role::Leaf { text: shown, .. } = &mut line.role
            {
                text.clone_into(shown);
                line.changed = Some(format!("{list}[{}].formula", n + 1));
            }
        }
    }
    found
}

/// The line of the quantity at a path, or with a symbol that is its alone.
fn line_of<'l>(lines: &'l mut [FormLine], path: &str, symbol: &str) -> Option<&'l mut FormLine> {
    let at = lines.iter().position(|line| line.path == path).or_else(|| {
        let has_it =
            |line: &&FormLine| !symbol.is_empty() && normalised(line.field.symbol) == normalised(symbol);
        let mut all = lines.iter().filter(has_it);
        let only = all.next().filter(|_| all.next().is_none())?.path.clone();
        lines.iter().position(|line| line.path == only)
    });
    at.map(|at| &mut lines[at]).filter(|line| line.is_quantity())
}

impl Form {
    /// The parts of the file, in the order of their tabs.
    pub fn parts(&self) -> Vec<FilePart> {
        parts(&self.shape, &self.draft)
    }

    /// The part that is shown.
    pub fn part(&self) -> FilePart {
        let mut all = self.parts();
        let at = self.part.as_ref().and_then(|part| all.iter().position(|other| other == part));
        all.swap_remove(at.unwrap_or(0))
    }

    /// The parts, each with whether something is said on its tab of one of these paths.
    pub fn parts_at<'p>(&self, paths: impl Iterator<Item = &'p str>) -> Vec<(FilePart, bool)> {
        let mut parts: Vec<(FilePart, bool)> = self.parts().into_iter().map(|part| (part, false)).collect();
        let changes = |(part, _): &(FilePart, bool)| -> HashSet<String> {
            match part.role {
                PartRole::Configuration(_) => {
                    self.lines_of(part).into_iter().filter_map(|line| line.changed).collect()
                }
                _ => HashSet::new(),
            }
        };
        let mut changed: Option<Vec<HashSet<String>>> = None;
        for path in paths {
            let changed = changed.get_or_insert_with(|| parts.iter().map(changes).collect());
            let problem = within_problem(self.shape.fields(None), path).0;
            let at = changed.iter().position(|paths| paths.contains(path));
            if let Some((_, is_said)) = match at {
                Some(at) => parts.get_mut(at),
                None => parts.iter_mut().find(|(part, _)| part.problem == problem),
            } {
                *is_said = true;
            }
        }
        parts
    }

    /// Shows a part. The cursor stays on the same input, or goes to where it was left.
    pub fn show_part(&mut self, part: &FilePart) {
        let shown = self.part();
        if shown == *part {
            return;
        }
        let path = self.line().map(|line| line.path);
        if let Some(path) = &path {
            self.left_at.insert(shown.name, path.clone());
        }
        self.part = Some(part.clone());
        (self.cursor, self.last, self.aim) = (0, None, None);
        let before = self.left_at.get(&part.name).cloned();
        for path in before.iter().chain(&path) {
            if let Some(at) = self.lines().iter().position(|line| line.path == *path) {
                self.cursor = at;
            }
        }
    }

    /// Shows the part so many tabs further; whether there is another.
    pub fn turn_part(&mut self, by: isize) -> bool {
        let (all, shown) = (self.parts(), self.part());
        let at = all.iter().position(|part| *part == shown).unwrap_or(0);
        let next = (at as isize + by).rem_euclid(all.len() as isize) as usize;
        self.show_part(&all[next]);
        next != at
    }

    /// Shows the part that has a line for a path: the present one, or the first other. A path of a configuration,
    /// `weighted.mass`, is of its own; answers the path of the line.
    pub(super) fn show_line(&mut self, path: &str) -> Option<String> {
        let shown = self.part();
        let all = [shown.clone()].into_iter().chain(self.parts().into_iter().filter(|part| *part != shown));
        let all: Vec<FilePart> = all.collect();
        for part in &all {
            if let Some(line) =
                self.lines_of(part).into_iter().find(|line| line.path == path || line.stands_at(path))
            {
                self.show_part(part);
                return Some(line.path);
            }
        }
        all.iter().filter(|part| matches!(part.role, PartRole::Configuration(_))).find_map(|part| {
            let path = part.outside(path.strip_prefix(&part.name)?.strip_prefix('.')?);
            self.lines_of(part).iter().any(|line| line.path == path).then(|| {
                self.show_part(part);
                path
            })
        })
    }

    /// Analysis of the part that is shown, among linked problems.
    pub fn analysis(&self) -> Option<&'static Entry> {
        let part = self.part();
        if self.entry.linked().is_empty() || part.role == PartRole::Shared {
            return None;
        }
        self.entry.linked().iter().find(|of| of.name == part.problem).map(|of| of.entry)
    }

    /// Reason for which nothing is changed on the line of the cursor.
    pub fn hindrance(&self) -> Option<&'static str> {
        match self.part().role {
            PartRole::File(_) => Some("the inputs of a linked file are changed in that file"),
            PartRole::Configuration(_) if !self.line().is_some_and(|line| line.is_quantity()) => {
                Some("a configuration changes quantities: change this in the problem itself")
            }
            _ => None,
        }
    }

    /// Gives the input of the cursor back to the problem of the configuration.
    pub fn take_back_change(&mut self) -> bool {
        let Some(line) = self.line().filter(|line| line.changed.is_some()) else { return false };
        let target = self.target(&line.path);
        let done = self.change(Change::Other, |draft, shape| target.write(draft, shape, String::new()));
        self.step(0);
        done
    }

    /// Text of the problem itself, where a configuration changes the input of the cursor.
    pub fn text_of_problem(&self, line: &FormLine) -> Option<String> {
        line.changed.as_ref()?;
        match self.draft.at(&self.shape, &line.path) {
            Ok((Draft::Leaf(text), _)) => Some(text.clone()),
            _ => None,
        }
    }

    /// The name that formulas have for the value of a line: `weighted.mass`.
    pub fn name_of(&self, line: &FormLine) -> String {
        let part = self.part();
        match (&line.changed, line.path.strip_prefix(&part.outside(""))) {
            (Some(_), Some(inner)) => format!("{}.{inner}", part.name),
            _ => line.path.clone(),
        }
    }

    /// Begins a configuration of the problem that is shown, or shows the one of that name.
    ///
    /// # Errors
    /// A name that is none, or a part that is no problem of this file.
    pub fn begin_configuration(&mut self, name: &str) -> Result<bool, Text> {
        let part = self.part();
        if !matches!(part.role, PartRole::Problem | PartRole::Configuration(_)) {
            return Err(Text::new("a configuration is of a problem of this file: turn to its tab first"));
        }
        if !linked::is_problem_name(name) {
            return Err(Text::new("a name of letters and digits is needed, for example weighted"));
        }
        let list = part.outside("configuration");
        let outside = part.outside(name);
        if let Some(known) = self.parts().into_iter().find(|part| part.name == outside) {
            self.show_part(&known);
            return Ok(false);
        }
        let row = [name, "", ""].map(|text| Draft::Leaf(text.to_owned())).to_vec();
        let done = self.change(Change::Other, |draft, shape| {
            match draft.at_mut(shape, &list).ok()? {
                (Draft::Rows(rows), _) => rows.push(Draft::Group(row)),
                _ => return None,
            }
            Some(())
        });
        if let Some(part) = self.parts().into_iter().find(|part| part.name == outside) {
            self.show_part(&part);
        }
        Ok(done)
    }

    /// Removes the configuration or the linked problem that is shown; whether it can be.
    pub fn remove_part(&mut self) -> bool {
        let part = self.part();
        match &part.role {
            PartRole::Configuration(configuration) => {
                let list = part.outside("configuration");
                let problem = |other: &FilePart| other.problem == part.problem;
                if let Some(problem) = self.parts().into_iter().find(problem) {
                    self.show_part(&problem);
                }
                self.change(Change::Other, |draft, shape| {
                    let (Draft::Rows(rows), _) = draft.at_mut(shape, &list).ok()? else { return None };
                    rows.retain(|row| cells(row)[0] != configuration.as_str());
                    Some(())
                })
            }
            PartRole::Problem => match linked::without(self.entry, &self.draft, &part.problem) {
                Some((entry, draft)) => self.replace(entry, draft),
                None => false,
            },
            PartRole::File(_) | PartRole::Shared => false,
        }
    }

    /// Lines of a part, those of collapsed rows among them, without empty lists of definitions and questions.
    pub(super) fn lines_of(&self, part: &FilePart) -> Vec<FormLine> {
        let mut lines = lines_of(&self.shape, &self.draft, part);
        let is_empty = |line: &FormLine| matches!(line.role, Role::Rows { count: 0 });
        let is_common = |line: &FormLine| COMMON_LISTS.contains(&line.field.name);
        lines.retain(|line| !is_empty(line) || !is_common(line));
        lines
    }

    /// Place of the text of the line at a path, of the part that is shown.
    pub(super) fn target(&self, path: &str) -> Target {
        let part = self.part();
        let PartRole::Configuration(configuration) = &part.role else { return Target::Leaf(path.to_owned()) };
        let list = part.outside("configuration");
        let line = self.lines_of(&part).into_iter().find(|line| line.path == path);
        let Some(line) = line.filter(FormLine::is_quantity) else { return Target::Leaf(path.to_owned()) };
        let row = line.changed.and_then(|changed| {
            let number =
                changed.strip_prefix(&list)?.strip_prefix('[')?.split(']').next()?.parse::<usize>().ok()?;
            number.checked_sub(1)
        });
        let input = path.strip_prefix(&part.outside("")).unwrap_or(path).to_owned();
        Target::Change { list, configuration: configuration.clone(), input, row }
    }
}
