//! A draft as lines: what a form shows from top to bottom.

use crate::{Draft, Field, Shape, Text, Variant, table::TableOutline};

/// A line of a form.
#[derive(Clone, Debug)]
pub struct FormLine {
    /// Path in the draft: `masses[2].radius`.
    pub path: String,
    /// Nesting depth.
    pub depth: u16,
    /// The field it belongs to.
    pub field: &'static Field,
    /// Row number, on the first line of a row.
    pub number: Option<usize>,
    /// True if the field is optional.
    pub optional: bool,
    /// Path of the text that a configuration has in place of that of the problem.
    pub changed: Option<String>,
    /// Role of the line.
    pub role: Role,
}

/// Role of a line.
#[derive(Clone, Debug)]
pub enum Role {
    /// One text.
    Leaf {
        /// Shape of the value.
        shape: Shape,
        /// Text typed.
        text: String,
    },
    /// A table, as a text of many lines.
    Table {
        /// Rows and units; number of lines where it cannot be read.
        content: Text,
    },
    /// The heading of fields that belong together; of a row, with its texts.
    Group {
        /// The texts of the row.
        summary: String,
    },
    /// One of several alternatives.
    Choice {
        /// The alternatives.
        variants: &'static [Variant],
        /// The chosen one; `None` where none is chosen yet.
        chosen: Option<usize>,
    },
    /// The heading of a list.
    Rows {
        /// Number of rows.
        count: usize,
    },
    /// Optional inputs that are left out.
    Absent,
}

impl FormLine {
    /// Returns true if it is a quantity.
    pub fn is_quantity(&self) -> bool {
        matches!(&self.role, Role::Leaf { shape, .. } if matches!(shape.present(), Shape::Quantity(_)))
    }

    /// Returns true if what is said of a path is said of this line.
    pub fn stands_at(&self, path: &str) -> bool {
        self.changed.as_deref().unwrap_or(&self.path) == path
    }
}

impl PartialEq for FormLine {
    fn eq(&self, other: &Self) -> bool {
        let same_role = match (&self.role, &other.role) {
            (Role::Leaf { text: a, .. }, Role::Leaf { text: b, .. }) => a == b,
            (Role::Choice { chosen: a, .. }, Role::Choice { chosen: b, .. }) => a == b,
            (Role::Rows { count: a }, Role::Rows { count: b }) => a == b,
            (Role::Table { content: a }, Role::Table { content: b }) => a == b,
            // The lines of the row follow, and tell.
            (Role::Group { .. }, Role::Group { .. }) | (Role::Absent, Role::Absent) => true,
            _ => false,
        };
        same_role && self.path == other.path
    }
}

/// The lines of a draft.
pub fn lines(shape: &Shape, draft: &Draft) -> Vec<FormLine> {
    let mut lines = Vec::new();
    if let (Shape::Group(fields), Draft::Group(drafts)) = (shape, draft) {
        push_fields(fields(), drafts, "", 0, &mut lines);
    }
    lines
}

fn push_fields(
    fields: &'static [Field],
    drafts: &[Draft],
    path: &str,
    depth: u16,
    lines: &mut Vec<FormLine>,
) {
    for (field, draft) in fields.iter().zip(drafts) {
        push_field(field, draft, path, depth, lines);
    }
}

/// Pushes the lines of a field of the group at a path.
pub fn push_field(field: &'static Field, draft: &Draft, path: &str, depth: u16, lines: &mut Vec<FormLine>) {
    let path = if path.is_empty() { field.name.to_owned() } else { format!("{path}.{}", field.name) };
    let (number, optional, role) = (None, false, Role::Absent);
    push(FormLine { path, depth, field, number, optional, changed: None, role }, &field.shape, draft, lines);
}

/// Pushes the line, with the role that the draft gives it, and the lines below it.
fn push(mut line: FormLine, shape: &Shape, draft: &Draft, lines: &mut Vec<FormLine>) {
    let (path, depth, field) = (line.path.clone(), line.depth, line.field);
    match (shape, draft) {
        (Shape::Optional(inner), Draft::Absent) if inner().is_leaf() => {
            line.optional = true;
            push(line, inner(), &Draft::Leaf(String::new()), lines);
        }
        (Shape::Optional(_), Draft::Absent) => lines.push(FormLine { optional: true, ..line }),
        (Shape::Optional(inner), _) => {
            line.optional = true;
            push(line, inner(), draft, lines);
        }
        (Shape::Group(fields), Draft::Group(drafts)) => {
            let summary = if line.number.is_some() { summary(draft) } else { String::new() };
            lines.push(FormLine { role: Role::Group { summary }, ..line });
            // The inputs of a file that a linked one links to are its own.
            if field.label.starts_with('@') {
                return;
            }
            push_fields(fields(), drafts, &path, depth + 1, lines);
        }
        (Shape::OneOf(variants), Draft::OneOf(chosen, inner)) => {
            let variants = variants();
            lines.push(FormLine { role: Role::Choice { variants, chosen: Some(*chosen) }, ..line });
            if let (Some(variant), Draft::Group(drafts)) = (variants.get(*chosen), &**inner) {
                push_fields(
                    (variant.fields)(),
                    drafts,
                    &format!("{path}.{}", variant.name),
                    depth + 1,
                    lines,
                );
            }
        }
        (Shape::OneOf(variants), _) => {
            lines.push(FormLine { role: Role::Choice { variants: variants(), chosen: None }, ..line });
        }
        (Shape::Rows { item, .. }, Draft::Rows(rows)) => {
            lines.push(FormLine { role: Role::Rows { count: rows.len() }, ..line });
            for (n, row) in rows.iter().enumerate() {
                let path = format!("{path}[{}]", n + 1);
                let number = Some(n + 1);
                let (depth, optional, role) = (depth + 1, false, Role::Absent);
                let line = FormLine { path, depth, field, number, optional, changed: None, role };
                push(line, item(), row, lines);
            }
        }
        (Shape::Table(columns), Draft::Leaf(text)) => {
            let content =
                TableOutline::of(text, columns()).map_or_else(|| lines_of(text), |table| table.text());
            lines.push(FormLine { role: Role::Table { content }, ..line });
        }
        (_, Draft::Leaf(text)) => {
            lines.push(FormLine { role: Role::Leaf { shape: *shape, text: text.clone() }, ..line });
        }
        _ => lines.push(line),
    }
}

/// Number of lines of a text.
fn lines_of(text: &str) -> Text {
    match text.lines().filter(|line| !line.trim().is_empty()).count() {
        1 => "one line".into(),
        lines => Text::new("{count} lines").with("count", lines),
    }
}

/// Separator between the texts of a row.
pub const BETWEEN: &str = " · ";

/// The texts of a row, beside each other.
pub fn summary(draft: &Draft) -> String {
    fn collect<'d>(draft: &'d Draft, texts: &mut Vec<&'d str>) {
        match draft {
            Draft::Leaf(text) if !text.trim().is_empty() && !text.contains('\n') => texts.push(text.trim()),
            Draft::Group(all) | Draft::Rows(all) => all.iter().for_each(|inner| collect(inner, texts)),
            Draft::OneOf(_, inner) => collect(inner, texts),
            Draft::Leaf(_) | Draft::Absent => {}
        }
    }
    let mut texts = Vec::new();
    collect(draft, &mut texts);
    texts.join(BETWEEN)
}
