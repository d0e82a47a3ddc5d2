//! The inputs of a problem as another program names them.

use dalembert_core::Shape;
use dalembert_report::inputs;

use super::RequestedProblem;
use crate::values::shape_at;

/// An input of a problem as it is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NamedValue {
    /// Path: `masses[1].radius`.
    pub path: String,
    /// Label in the language of the request.
    pub label: String,
    /// Symbol in formulas; may be empty.
    pub symbol: String,
    /// Kind: a quantity by its name, `a mass`; `choice`, `vector`, `table`, `count`, `flag`, `text`, `reference`.
    pub kind: &'static str,
    /// The unit of a number alone; empty where there is none. Of a table, those of its columns.
    pub units: Vec<String>,
    /// The text of the input; of a choice, the name of the alternative.
    pub text: String,
    /// Names of the alternatives of a choice, and of the columns of a table.
    pub names: Vec<&'static str>,
}

impl RequestedProblem {
    /// The inputs in the order of the form, each with its text. Those of alternatives that are not chosen are none.
    pub fn inputs(&self) -> Vec<NamedValue> {
        let problem = &self.problem;
        let shape = problem.entry.shape();
        let lines = inputs(&problem.draft, &problem.record, None, &self.locale);
        let described =
            lines.into_iter().filter(|line| line.value.is_some() && !line.is_common).filter_map(|line| {
                let (kind, units, names) = described(&shape_at(&problem.draft, &shape, &line.path)?)?;
                let (path, label, symbol, text) = (line.path, line.label, line.symbol, line.typed);
                Some(NamedValue { path, label, symbol, kind, units, text, names })
            });
        described.collect()
    }
}

fn described(shape: &Shape) -> Option<(&'static str, Vec<String>, Vec<&'static str>)> {
    let unit = |shape: &Shape| {
        let unit = shape.measure().map_or_else(String::new, |measure| measure.meant("1").own_unit().ascii());
        if unit.is_empty() { "1".to_owned() } else { unit }
    };
    Some(match shape {
        Shape::Quantity(measure) => (measure.kind().name(), vec![unit(shape)], Vec::new()),
        Shape::Vector(..) => ("vector", vec![unit(shape)], Vec::new()),
        Shape::OneOf(variants) => {
            ("choice", Vec::new(), variants().iter().map(|variant| variant.name).collect())
        }
        Shape::Table(columns) => {
            let units = columns().iter().map(|column| unit(&column.shape)).collect();
            ("table", units, columns().iter().map(|column| column.name).collect())
        }
        Shape::Count { .. } => ("count", Vec::new(), Vec::new()),
        Shape::Flag => ("flag", Vec::new(), Vec::new()),
        Shape::Text => ("text", Vec::new(), Vec::new()),
        Shape::Reference(_) => ("reference", Vec::new(), Vec::new()),
        Shape::Group(_) | Shape::Rows { .. } | Shape::Optional(_) => return None,
    })
}
