//! The inputs of a problem as a form: a [`Draft`] seen as lines, a cursor, and the changes that keys make.
// Long because every change of the inputs is here, with what takes it back.

mod edit;
mod fold;
mod nudge;
mod parts;
mod paste;
mod questions;

use std::{
    collections::{BTreeSet, HashMap},
    ops::Range,
};

use dalembert_core::{
    Draft, Entry, Shape, Value, ascii, draft,
    form::{self, in_next_unit, rows_mut, with_unit, written_unit},
    gravity, linked, within_problem,
};
use dalembert_units::{Decimal, Style, thousands, with_point, write_quantity, write_vector};

pub use dalembert_core::form::{BETWEEN, FormLine, Role, in_language, lines, settled};
pub use edit::{Edit, Sign};
pub use nudge::{digit_at, nudged};
pub use parts::{FilePart, PartRole};
pub use paste::Filled;

use crate::glyphs::filter_untrusted;

/// The longest text that is kept of one line, in characters.
pub const LONGEST: usize = 2_000;
/// So many changes can be taken back.
const MOST_UNDO: usize = 500;

/// A form.
#[derive(Clone, Debug)]
pub struct Form {
    /// Texts of the inputs.
    pub draft: Draft,
    /// The line of the cursor.
    pub cursor: usize,
    /// The field that is being typed in.
    pub edit: Option<Edit>,
    /// The sign that was the last key.
    pub sign: Option<Sign>,
    entry: &'static Entry,
    shape: Shape,
    undo: Vec<Snapshot>,
    redo: Vec<Snapshot>,
    /// Last change, so that a run of similar changes is undone together.
    last: Option<Change>,
    /// The field whose unit was changed last: from what text, and to what.
    converted: Option<Converted>,
    /// The number that has a digit chosen to be nudged, and how many places that is left of its last one.
    aim: Option<(String, u32)>,
    /// The alternatives that were left, by path and place, to come back to.
    left: HashMap<(String, usize), Draft>,
    /// The paths of rows of which the heading alone is shown.
    folded: BTreeSet<String>,
    /// The part of the file that is shown; `None` or one that is gone stands for the first.
    part: Option<FilePart>,
    /// The paths that the cursor was left at, by the names of parts.
    left_at: HashMap<String, String>,
}

/// A draft as it was, and the problems that it is of.
#[derive(Clone, Debug)]
struct Snapshot {
    entry: &'static Entry,
    draft: Draft,
}

/// A text in another unit than it was typed in: the quantity is that of the text as it was typed, however often its
/// unit is changed.
#[derive(Clone, Debug)]
struct Converted {
    path: String,
    typed: String,
    shown: String,
}

/// Type of the last change.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Change {
    Nudge(String),
    Unit(String),
    Other,
}

/// Row of a list: the list, the index of the row, and the number of rows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Row {
    /// The path of the list.
    pub list: String,
    /// Index, from 0; `None` on the heading of the list.
    pub at: Option<usize>,
}

impl Form {
    /// Gravity assumed for a line that leaves it out.
    pub fn gravity(&self, line: &FormLine) -> Option<String> {
        gravity::is_gravity(line.field).then(|| gravity::of(&self.draft, &self.shape, &line.path))?
    }

    /// A form for an analysis, filled in.
    pub fn new(entry: &'static Entry, draft: Draft) -> Self {
        Self {
            draft,
            cursor: 0,
            edit: None,
            sign: None,
            entry,
            shape: entry.shape(),
            undo: Vec::new(),
            redo: Vec::new(),
            last: None,
            converted: None,
            aim: None,
            left: HashMap::new(),
            folded: BTreeSet::new(),
            part: None,
            left_at: HashMap::new(),
        }
    }

    /// The analysis, or the linked problems.
    pub fn entry(&self) -> &'static Entry {
        self.entry
    }

    /// Lines, without those of collapsed rows.
    pub fn lines(&self) -> Vec<FormLine> {
        let mut lines = self.all_lines();
        lines.retain(|line| !self.is_hidden(&line.path));
        lines
    }

    /// The line of the cursor.
    pub fn line(&self) -> Option<FormLine> {
        self.lines().into_iter().nth(self.cursor)
    }

    /// The cursor moved by so many lines.
    pub fn step(&mut self, by: isize) {
        let last = self.lines().len().saturating_sub(1);
        self.cursor = self.cursor.saturating_add_signed(by).min(last);
    }

    /// The cursor at the line of a path.
    pub fn go_to(&mut self, path: &str) {
        let path = &self.show_line(path).unwrap_or_else(|| path.to_owned());
        self.reveal(path);
        if let Some(at) = self.lines().iter().position(|line| line.path == *path) {
            self.cursor = at;
        }
    }

    /// The cursor at the line of a path, or of the innermost part of it that has one.
    pub fn go_to_nearest(&mut self, path: &str) {
        let ends = path.rmatch_indices(['.', '[']).map(|(at, _)| at);
        let found = [path.len()].into_iter().chain(ends).find_map(|end| self.show_line(&path[..end]));
        if let Some(path) = found {
            self.go_to(&path);
        }
    }

    /// Puts a text of a language in place of that of a field; a number alone keeps the unit that is there.
    pub fn set(&mut self, path: &str, text: String, decimal: Decimal) -> bool {
        let line = self.lines_of(&self.part()).into_iter().find(|line| line.path == path);
        let text = match line.map(|line| line.role) {
            Some(Role::Leaf { text: old, shape }) => {
                let shape = shape.present();
                let unit = written_unit(&old, &shape);
                with_unit(settled(text, &shape, decimal), unit.as_ref(), &shape)
            }
            _ => text,
        };
        self.write(Change::Other, path, text)
    }

    /// Writes the text of the line at a path.
    fn write(&mut self, what: Change, path: &str, text: String) -> bool {
        let target = self.target(path);
        self.change(what, |draft, shape| target.write(draft, shape, text))
    }

    /// Makes the quantity of the cursor unknown, of a vector its first component: it is found from given answers.
    pub fn make_unknown(&mut self) -> bool {
        let Some(line) = self.line() else { return false };
        let Role::Leaf { shape, .. } = &line.role else { return false };
        let path = &line.path;
        match shape.present() {
            Shape::Quantity(_) => self.write(Change::Other, path, "?".into()),
            Shape::Vector(..) => {
                self.change(Change::Other, |draft, shape| draft.set(shape, &format!("{path}.x"), "?").ok())
            }
            _ => false,
        }
    }

    /// Gives the value of an answer; the path of its row.
    pub fn give(&mut self, answer: &str, value: &str) -> Option<String> {
        self.change(Change::Other, |draft, shape| draft.give(shape, answer, value).ok());
        let Ok((Draft::Rows(rows), _)) = self.draft.at(&self.shape, "given") else { return None };
        let is_it = |row: &Draft| matches!(row, Draft::Group(parts) if parts.first() == Some(&Draft::Leaf(answer.to_owned())));
        rows.iter().position(is_it).map(|row| format!("given[{}].value", row + 1))
    }

    /// Puts a whole draft in place of this one.
    pub fn replace(&mut self, entry: &'static Entry, with: Draft) -> bool {
        self.edit = None;
        let before = self.exchange(Snapshot { entry, draft: with });
        let changed = before.draft != self.draft || !std::ptr::eq(before.entry, self.entry);
        if changed {
            self.remember(before, Change::Other);
        }
        self.step(0);
        changed
    }

    /// Takes the problems of linked files as they were read again, now and in what can be taken back.
    pub fn take_files(&mut self, read: (&'static Entry, &Draft)) {
        let taken = |snapshot: &Snapshot, all: bool| {
            let (entry, draft) = linked::with_files(snapshot.entry, &snapshot.draft, read, all);
            Snapshot { entry, draft }
        };
        for snapshot in self.undo.iter_mut().chain(&mut self.redo) {
            *snapshot = taken(snapshot, false);
        }
        let now = taken(&Snapshot { entry: self.entry, draft: self.draft.clone() }, true);
        self.exchange(now);
        self.step(0);
    }

    /// Puts another draft in place of this one, and answers this one.
    fn exchange(&mut self, with: Snapshot) -> Snapshot {
        let draft = std::mem::replace(&mut self.draft, with.draft);
        let entry = std::mem::replace(&mut self.entry, with.entry);
        self.shape = self.entry.shape();
        Snapshot { entry, draft }
    }

    /// Takes the last change back.
    pub fn undo(&mut self) -> bool {
        let Some(before) = self.undo.pop() else { return false };
        let now = self.swap(before);
        self.redo.push(now);
        true
    }

    /// Makes it again.
    pub fn redo(&mut self) -> bool {
        let Some(after) = self.redo.pop() else { return false };
        let now = self.swap(after);
        self.undo.push(now);
        true
    }

    /// Chooses an alternative of a one-of. Texts of fields that both have are kept, and the alternative that is left
    /// can be come back to.
    pub fn choose(&mut self, path: &str, to: usize) -> bool {
        let Ok((draft, shape)) = self.draft.at(&self.shape, path) else { return false };
        let Some(new) = form::alternative(&shape.present(), draft, to) else { return false };
        let old = draft.clone();
        let new = self.left.get(&(path.to_owned(), to)).cloned().unwrap_or(new);
        if let Draft::OneOf(from, _) = old {
            self.left.insert((path.to_owned(), from), old);
        }
        self.put(Change::Other, path, new)
    }

    /// Chooses the alternative, or the name, so many places further.
    pub fn cycle(&mut self, by: isize) -> bool {
        let Some(line) = self.line() else { return false };
        let next = |at: usize, of: usize| at.checked_add_signed(by).filter(|at| *at < of);
        match &line.role {
            Role::Choice { variants, chosen, .. } => {
                let to = chosen.map_or(Some(0), |at| next(at, variants.len()));
                to.is_some_and(|to| self.choose(&line.path, to))
            }
            Role::Leaf { shape: Shape::Reference(list), text, .. } => {
                let names = self.names(list);
                let at = names.iter().position(|name| name == text);
                let to = at.map_or(Some(0), |at| next(at, names.len()));
                to.and_then(|to| names.get(to).cloned())
                    .is_some_and(|name| self.set(&line.path, name, Decimal::Point))
            }
            Role::Leaf { shape: Shape::Flag, .. } => self.toggle(),
            _ => false,
        }
    }

    /// Turns a flag over, or puts an optional input in or out.
    pub fn toggle(&mut self) -> bool {
        let Some(line) = self.line() else { return false };
        match line.role {
            Role::Leaf { shape: Shape::Flag, ref text, .. } => {
                let on = matches!(draft::read_leaf(text, &Shape::Flag, ""), Ok(Value::Flag(true)));
                self.set(&line.path, if on { "no" } else { "yes" }.to_owned(), Decimal::Point)
            }
            Role::Absent => self.change(Change::Other, |draft, shape| form::put_in(draft, shape, &line.path)),
            _ if line.optional => self.leave_out(&line.path),
            _ => false,
        }
    }

    /// The names of the rows that a reference may name; their numbers where they have none.
    pub fn names(&self, list: &str) -> Vec<String> {
        form::names(&self.draft, &self.shape, &self.part().outside(list))
    }

    /// The innermost row that holds the line of the cursor.
    pub fn row(&self) -> Option<Row> {
        let line = self.line()?;
        if matches!(line.role, Role::Rows { .. }) {
            return Some(Row { list: line.path, at: None });
        }
        row_of(&line.path)
    }

    /// A row more, below that of the cursor or at the end of its list; the cursor goes to its first field.
    pub fn add_row(&mut self) -> bool {
        self.row().is_some_and(|row| self.add_row_at(&row))
    }

    /// A definition (`let`) or a question (`ask`) more, of the problem of the cursor; the cursor goes to its name.
    pub fn add_to(&mut self, list: &str) -> bool {
        let (list, _) = self.within_problem(list);
        self.add_row_at(&Row { list, at: None })
    }

    /// A configuration more, in which the input of the cursor is changed; the cursor goes to its name.
    pub fn configure(&mut self) -> bool {
        let is_input = |line: &FormLine| {
            matches!(line.role, Role::Leaf { .. } | Role::Choice { .. } | Role::Table { .. })
        };
        if !self.line().is_some_and(|line| is_input(&line)) {
            return false;
        }
        let (list, input) = self.within_problem("configuration");
        let mut row = String::new();
        let done = self.change(Change::Other, |draft, shape| {
            let Ok((Draft::Rows(rows), _)) = draft.at(shape, &list) else { return None };
            row = format!("{list}[{}]", rows.len() + 1);
            draft.set(shape, &format!("{row}.input"), &input).ok()
        });
        self.go_to(&format!("{row}.name"));
        done
    }

    /// The path of a list of the problem of the cursor, and that of the input of the cursor within it.
    fn within_problem(&self, list: &str) -> (String, String) {
        let path = self.line().map_or_else(|| self.part().problem + ".", |line| line.path);
        match within_problem(self.shape.fields(None), &path) {
            ("", input) => (list.to_owned(), input.to_owned()),
            (problem, input) => (format!("{problem}.{list}"), input.to_owned()),
        }
    }

    fn add_row_at(&mut self, row: &Row) -> bool {
        let mut path = String::new();
        self.left.clear();
        let done = self.change(Change::Other, |draft, shape| {
            let at = form::insert_row(draft, shape, &row.list, row.at.map(|at| at + 1))?;
            path = format!("{}[{}]", row.list, at + 1);
            Some(())
        });
        let from = row.at.map_or(usize::MAX, |at| at + 1);
        self.renumber(&row.list, |n| Some(if n >= from { n + 1 } else { n }));
        self.go_to(&path);
        if self.line().is_some_and(|line| matches!(line.role, Role::Group { .. })) {
            self.step(1);
        }
        done
    }

    /// A copy of the row of the cursor, below it.
    pub fn duplicate_row(&mut self) -> bool {
        let Some((list, at)) = self.row().and_then(|row| Some((row.list, row.at?))) else { return false };
        self.left.clear();
        let done = self.change(Change::Other, |draft, shape| {
            let (rows, list) = rows_mut(draft, shape, &list)?;
            let mut copy = rows.get(at)?.clone();
            if let Shape::Rows { item, .. } = list {
                copy.rename_among(rows, item());
            }
            rows.insert(at + 1, copy);
            Some(())
        });
        self.renumber(&list, |n| Some(if n > at { n + 1 } else { n }));
        self.go_to(&format!("{list}[{}]", at + 2));
        done
    }

    /// Deletes the row of the cursor; on an optional input, leaves it out.
    pub fn delete_row(&mut self) -> bool {
        if let Some(line) = self.line().filter(|line| line.optional) {
            return self.leave_out(&line.path);
        }
        let Some((list, at)) = self.row().and_then(|row| Some((row.list, row.at?))) else { return false };
        self.left.clear();
        let mut rest = 0;
        let done = self.change(Change::Other, |draft, shape| {
            let (rows, _) = rows_mut(draft, shape, &list)?;
            rows.get(at)?;
            rows.remove(at);
            rest = rows.len();
            Some(())
        });
        self.renumber(&list, |n| if n > at { Some(n - 1) } else { (n != at).then_some(n) });
        self.go_to(&if rest == 0 { list } else { format!("{list}[{}]", at.min(rest - 1) + 1) });
        self.step(0);
        done
    }

    /// Moves the row of the cursor so many places.
    pub fn move_row(&mut self, by: isize) -> bool {
        let Some((list, at)) = self.row().and_then(|row| Some((row.list, row.at?))) else { return false };
        let Some(to) = at.checked_add_signed(by) else { return false };
        let mut done = false;
        let rest = self.line().map(|line| line.path[format!("{list}[{}]", at + 1).len()..].to_owned());
        self.left.clear();
        // Rows that are alike change places too.
        self.change(Change::Other, |draft, shape| {
            let (rows, _) = rows_mut(draft, shape, &list)?;
            done = to < rows.len();
            done.then(|| rows.swap(at, to))
        });
        if done {
            self.renumber(&list, |n| {
                Some(if n == at {
                    to
                } else if n == to {
                    at
                } else {
                    n
                })
            });
            self.go_to(&format!("{list}[{}]{}", to + 1, rest.unwrap_or_default()));
        }
        done
    }

    /// Changes the last digit of the field under the cursor, or the one that was chosen, by so many tenths.
    pub fn nudge(&mut self, tenths: i64) -> bool {
        let Some((path, text)) = self.number() else { return false };
        let by = 10_i64.checked_pow(self.place_of_digit(&path)).and_then(|place| tenths.checked_mul(place));
        let Some(text) = by.and_then(|by| nudged(&text, by)) else { return false };
        // One more of 0,999 kg would be read in two ways.
        let text = if thousands(&text, ',').is_some() { with_point(&text).into_owned() } else { text };
        self.write(Change::Nudge(path.clone()), &path, text)
    }

    /// Chooses the digit at the left of the one that nudges change, or at its right; whether the field under the cursor
    /// is a number.
    pub fn aim(&mut self, left: bool) -> bool {
        let Some((path, text)) = self.number() else { return false };
        let now = self.place_of_digit(&path);
        let to = if left { now + 1 } else { now.saturating_sub(1) };
        if to == 0 || digit_at(&text, to).is_some() {
            self.aim = Some((path, to));
        }
        true
    }

    /// The bytes of the digit that was chosen in the text of a field.
    pub fn digit(&self, path: &str, text: &str) -> Option<Range<usize>> {
        let (_, place) = self.aim.as_ref().filter(|(aim, _)| aim == path)?;
        digit_at(text, *place)
    }

    fn place_of_digit(&self, path: &str) -> u32 {
        self.aim.as_ref().filter(|(aim, _)| aim == path).map_or(0, |(_, place)| *place)
    }

    /// Path and text of the field under the cursor, where it is a number with digits to change.
    fn number(&self) -> Option<(String, String)> {
        let FormLine { path, role: Role::Leaf { text, shape, .. }, .. } = self.line()? else { return None };
        if !matches!(shape, Shape::Quantity(_) | Shape::Count { .. }) {
            return None;
        }
        let exact = matches!(draft::read_leaf(&text, &shape, ""), Ok(Value::Quantity(value)) if value.last_place == 0.0);
        (!exact && nudged(&text, 10).is_some()).then_some((path, text))
    }

    /// Writes the field under the cursor in the next unit of its kind.
    pub fn next_unit(&mut self) -> bool {
        let Some(FormLine { path, role: Role::Leaf { text, shape, .. }, .. }) = self.line() else {
            return false;
        };
        let typed = match self.converted.take() {
            Some(last) if last.path == path && last.shown == text => last.typed,
            _ => text.clone(),
        };
        let Some(shown) = in_next_unit(&typed, &text, &shape) else { return false };
        self.converted = Some(Converted { path: path.clone(), typed, shown: shown.clone() });
        self.write(Change::Unit(path.clone()), &path, shown)
    }

    fn leave_out(&mut self, path: &str) -> bool {
        self.put(Change::Other, path, Draft::Absent)
    }

    /// Puts a part in place of that at a path.
    fn put(&mut self, what: Change, path: &str, part: Draft) -> bool {
        self.change(what, |draft, shape| {
            *draft.at_mut(shape, path).ok()?.0 = part;
            Some(())
        })
    }

    /// Changes the draft so that it can be taken back. `None` means that there was nothing to change.
    fn change(&mut self, what: Change, by: impl FnOnce(&mut Draft, &Shape) -> Option<()>) -> bool {
        let before = self.draft.clone();
        if by(&mut self.draft, &self.shape).is_none() || before == self.draft {
            return false;
        }
        self.draft.keep_first(&before, &self.shape);
        self.remember(Snapshot { entry: self.entry, draft: before }, what);
        true
    }

    fn remember(&mut self, before: Snapshot, what: Change) {
        self.redo.clear();
        if what == Change::Other || self.last.as_ref() != Some(&what) {
            if self.undo.len() == MOST_UNDO {
                self.undo.remove(0);
            }
            self.undo.push(before);
        }
        self.last = Some(what);
    }

    /// Puts the cursor where the two drafts differ first, of the part that is shown where it differs.
    fn swap(&mut self, with: Snapshot) -> Snapshot {
        self.edit = None;
        self.last = None;
        let (parts, shown) = (self.parts(), self.part());
        let lines = |form: &Self, part: &FilePart| form.lines_of(part);
        let before: Vec<_> = parts.iter().map(|part| lines(self, part)).collect();
        let old = self.exchange(with);
        let of = |part: &FilePart| parts.iter().position(|other| other == part).map(|at| &before[at]);
        let after = self.parts();
        let all =
            after.iter().filter(|part| **part == shown).chain(after.iter().filter(|part| **part != shown));
        let differs = |part: &FilePart| {
            let after = lines(self, part);
            let before = of(part).map_or(&[][..], Vec::as_slice);
            let at = after.iter().zip(before).position(|(after, before)| after != before);
            let at = at.or_else(|| (after.len() != before.len()).then(|| after.len().min(before.len())));
            at.map(|at| (part.clone(), after.get(at).map(|line| line.path.clone())))
        };
        let first = all.into_iter().find_map(differs);
        if let Some((part, path)) = first {
            self.show_part(&part);
            if let Some(path) = path {
                self.go_to(&path);
            }
        }
        self.step(0);
        old
    }
}

/// A pasted text as one line of a field: without controls, line breaks as spaces, at most [`LONGEST`] characters.
/// The second says whether something was cut off.
pub fn as_line(pasted: &str) -> (String, bool) {
    let mut characters = filter_untrusted(&pasted.chars().take(2 * LONGEST).collect::<String>())
        .trim()
        .chars()
        .map(|character| if character == '\n' { ' ' } else { character })
        .filter(|character| *character != '\u{FFFD}')
        .collect::<Vec<_>>();
    let cut = characters.len() > LONGEST || pasted.len() > 8 * LONGEST;
    characters.truncate(LONGEST);
    (characters.into_iter().collect(), cut)
}

/// Interpretation of a text, where it is not obvious: `= 104.72 rad/s`.
pub fn echo(text: &str, shape: &Shape, style: Style) -> Option<String> {
    match (draft::read_leaf(text, shape, "").ok()?, shape) {
        (Value::Quantity(quantity), Shape::Quantity(measure)) => {
            let shown = write_quantity(quantity.si, &measure.of(&quantity.unit).own_unit(), style);
            // The same number with its unit written in another way says nothing new.
            let number = |text: &str| {
                let end = text.find(|c: char| !(c.is_ascii_digit() || ".,-−".contains(c)));
                text[..end.unwrap_or(text.len())].replace('-', "−").replace(',', ".")
            };
            let has_unit = text.contains(|c: char| c.is_alphabetic() || "°%'\"".contains(c));
            let says_more = !has_unit && shown.contains(' ') || number(&shown) != number(text.trim_start());
            (says_more || point_of_thousands(text, style).is_some()).then_some(shown)
        }
        (Value::Vector(vector), Shape::Vector(..)) => {
            let shown = write_vector(vector.si, &vector.unit, style);
            (squeezed(&shown) != squeezed(text)).then_some(shown)
        }
        _ => None,
    }
}

/// A number of a text that a reader with a decimal comma may take for thousands, as `1.500`. It is read as a decimal
/// number: files have points.
pub fn point_of_thousands(text: &str, style: Style) -> Option<&str> {
    match style.decimal {
        Decimal::Point => None,
        Decimal::Comma => thousands(text, '.'),
    }
}

/// A text as it compares: however it is spaced, and whichever way powers and products are written.
fn squeezed(text: &str) -> String {
    text.chars()
        .filter(|character| !character.is_whitespace() && *character != '^')
        .map(|character| match character {
            '·' | '×' => '*',
            '−' => '-',
            ',' => '.',
            other => ascii::power(other).unwrap_or(other),
        })
        .collect()
}

/// The innermost row of a path: `masses[2].radius` gives `masses` and 1.
fn row_of(path: &str) -> Option<Row> {
    let open = path.rfind('[')?;
    let row: usize = path[open + 1..].split(']').next()?.parse().ok()?;
    Some(Row { list: path[..open].to_owned(), at: Some(row.checked_sub(1)?) })
}

#[cfg(test)]
mod tests {
    use dalembert_core::Measure;

    use super::*;

    fn quantity(unit: &'static str) -> Shape {
        Shape::Quantity(Measure::in_unit(unit))
    }

    #[test]
    fn a_reading_is_echoed_where_the_text_does_not_say_it() {
        for (text, unit, echoed) in [
            ("1000 rpm", "rad/s", Some("104.72 rad/s")),
            ("1000", "rad/s", Some("1000 rad/s")),
            ("2*pi*50 rad/s", "rad/s", Some("314.16 rad/s")),
            ("20.3 mm", "m", Some("0.0203 m")),
            ("40 kg", "kg", None),
            ("40kg", "kg", None),
            ("0,1 kg*m", "kg*m", None),
            ("10 m/s^2", "m/s^2", None),
            ("30 deg", "deg", None),
            ("1,500 rpm", "rpm", None),
            ("1.500 rpm", "rpm", Some("1.5 rpm")),
            ("0,500 m", "m", Some("0.5 m")),
            ("nothing", "kg", None),
        ] {
            assert_eq!(echo(text, &quantity(unit), Style::default()).as_deref(), echoed, "{text}");
        }
    }

    #[test]
    fn pastes_become_one_line() {
        assert_eq!(as_line("  20.3\r\n mm\u{7}\t "), ("20.3  mm".to_owned(), false));
        let (line, cut) = as_line(&"9".repeat(1_000_000));
        assert_eq!((line.len(), cut), (LONGEST, true));
    }

    #[test]
    fn the_innermost_row_counts() {
        assert_eq!(row_of("a[2].b[3].c"), Some(Row { list: "a[2].b".into(), at: Some(2) }));
        assert_eq!(row_of("mass"), None);
    }
}
