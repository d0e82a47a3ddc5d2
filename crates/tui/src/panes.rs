//! What the panes of the bench say, as lines of text. Scrolling is their user's.

pub mod check;
mod columns;
pub mod results;
pub mod sensitivity;
pub mod sources;
pub mod study;
pub mod table;
pub mod working;
pub(crate) mod wrap;

use dalembert_core::{Field, Locale, Shape, Text};
use ratatui::text::Line;

dalembert_core::messages!("../locales/widgets.pt-BR.ftl");

/// The lines of a pane, and at which of them its parts begin.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Page {
    /// The lines, none wider than was asked for.
    pub lines: Vec<Line<'static>>,
    /// The first line of each step or case.
    pub starts: Vec<usize>,
}

impl Page {
    /// The part that a line belongs to. After the last part an empty line follows.
    pub fn part_at(&self, line: usize) -> Option<usize> {
        let part = self.starts.iter().rposition(|start| *start <= line)?;
        let own = self.lines.get(self.starts[part]..=line)?;
        own.iter().all(|line| line.width() > 0).then_some(part)
    }
}

/// The label of the field at a path, in the language, after the rows that it stands in: `Masses 1, Radius` for
/// `masses[1].radius`. A component of a vector keeps its own part behind it: `Position x`. `None` where the path names
/// no field.
pub fn label_of(shape: &Shape, path: &str, locale: &Locale) -> Option<String> {
    let mut shape = *shape;
    let mut rows = String::new();
    let mut label: Option<String> = None;
    for part in path.split(['.', '[']) {
        while let Shape::Optional(inner) = shape {
            shape = *inner();
        }
        let field = |fields: &'static [Field]| fields.iter().find(|field| field.name == part);
        match shape {
            Shape::Group(fields) | Shape::Table(fields) => {
                let field = field(fields())?;
                label = Some(Text::new(field.label).render(locale));
                shape = field.shape;
            }
            Shape::OneOf(variants) => {
                let variant = variants().iter().find(|variant| variant.name == part)?;
                label = Some(Text::new(variant.label).render(locale));
                shape = Shape::Group(variant.fields);
            }
            Shape::Rows { item, .. } => {
                let row = part.strip_suffix(']')?;
                rows += &match label.take() {
                    Some(label) if rows.is_empty() => format!("{label} {row}"),
                    Some(label) => format!(", {label} {row}"),
                    None => format!(" {row}"),
                };
                shape = *item();
            }
            Shape::Vector(measure, _) => {
                label = Some(format!("{} {part}", label?));
                shape = Shape::Quantity(measure);
            }
            _ => return None,
        }
    }
    match (rows.is_empty(), label) {
        (true, label) => label,
        (false, None) => Some(rows),
        (false, Some(label)) => Some(format!("{rows}, {label}")),
    }
}
