//! The panes of what was found: a file and a `mod` line each, see [`pane`](crate::pane).

mod answers;
pub mod check;
mod columns;
pub mod drawing;
pub mod plot;
pub mod reasons;
pub mod results;
pub mod sensitivity;
pub mod sources;
mod steps;
pub mod study;
pub mod table;
pub mod working;
pub(crate) mod wrap;

use dalembert_core::{Field, Locale, Shape, Text, inventory, is_within, vary};
use dalembert_units::Unit;

use crate::{
    keys::{KeyContext, KeyMap},
    pane::{Pane, PaneEntry, Ui},
    problem::Problem,
};

dalembert_core::messages!("../locales/widgets.pt-BR.ftl");

/// Every pane, as a problem begins with it, from left to right in the line of tabs.
pub fn all() -> Vec<Box<dyn Pane>> {
    let mut entries: Vec<&PaneEntry> = inventory::iter::<PaneEntry>().collect();
    entries.sort_by_key(|entry| entry.order);
    entries.into_iter().map(|entry| (entry.new)()).collect()
}

/// Every place where keys are typed, as the help and the settings list them.
pub fn places() -> Vec<KeyContext> {
    let mut places =
        vec![KeyContext::Picker, KeyContext::Filter, KeyContext::Form, KeyContext::Edit, KeyContext::Pane];
    places.extend(all().iter().map(|pane| pane.place()).filter(|place| matches!(place, KeyContext::Own(_))));
    places.extend([
        KeyContext::List,
        KeyContext::Prompt,
        KeyContext::Sheet,
        KeyContext::Help,
        KeyContext::Cells,
        KeyContext::Plan,
        KeyContext::Cell,
        KeyContext::Job,
        KeyContext::JobText,
    ]);
    places
}

impl Default for KeyMap {
    fn default() -> Self {
        KeyMap::of(&places())
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
                label = Some(field.title().render(locale));
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

/// In which unit a number is taken that is typed without one; `None` where there is no unit.
pub(crate) fn about_number(unit: &Unit, ui: &Ui<'_>) -> Option<Text> {
    let unit = unit.shown(ui.look.ascii);
    (!unit.is_empty()).then(|| Text::new("default unit {unit}").with("unit", &unit))
}

/// Takes the input that a pane begins with when it is turned to: the one under the cursor of the form, or the first.
/// True if it is another than before.
fn begun(begins: &mut String, problem: &Problem) -> bool {
    let (Some(line), Some(record)) = (problem.inputs.form.line(), problem.record()) else { return false };
    let inputs = vary::inputs(&record);
    let here = inputs.iter().find(|input| is_within(&input.path, &line.path)).or(inputs.first());
    let here = here.map_or_else(String::new, |input| input.path.clone());
    std::mem::replace(begins, here.clone()) != here
}
