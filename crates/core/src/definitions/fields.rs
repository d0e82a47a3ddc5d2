//! The fields that every problem has behind its own inputs: definitions, questions, given answers and configurations.

use std::{
    any::TypeId,
    borrow::Cow,
    collections::HashMap,
    sync::{Mutex, OnceLock, PoisonError},
};

use crate::{Field, Fields, Inputs, Record, Shape, Value};

/// The most definitions, and the most questions, of a problem.
const MOST: usize = 200;

/// The fields that every problem has behind its own inputs.
static FIELDS: [Field; 4] = [
    Field {
        label: "Definitions",
        help: "Quantities of your own, for formulas in inputs and questions: nu = 0.3, G = E/(2*(1+nu)).",
        ..field("let", || &Shape::Group(Fields(&|| &DEFINITION)))
    },
    Field {
        label: "Questions",
        help: "Formulas over inputs, answers and steps, answered like the rest: peak to peak = 2*X.",
        ..field("ask", || &Shape::Group(Fields(&|| &QUESTION)))
    },
    Field {
        label: "Given answers",
        help: "Known values of answers, or requirements, from which inputs written as ? are found: natural_frequency = 8.2 Hz.",
        ..field("given", || &Shape::Group(Fields(&|| &GIVEN)))
    },
    Field {
        label: "Configurations",
        help: "The same problem with some inputs changed, answered beside it: weighted, mass = m + 2 kg.",
        ..field("configuration", || &Shape::Group(Fields(&|| &CHANGE)))
    },
];

/// The names of the lists that every problem has behind its own inputs.
pub const COMMON_LISTS: [&str; 4] = ["let", "ask", "given", "configuration"];

static DEFINITION: [Field; 2] = [
    Field { label: "Name", help: "As formulas write it: nu, E_1, bolt.", ..text("name") },
    Field {
        label: "Value or formula",
        help: "12 g, or E/(2*(1+nu)) over other definitions and inputs.",
        ..text("formula")
    },
];

static QUESTION: [Field; 5] = [
    Field { label: "Quantity", help: "In words: peak to peak.", ..text("name") },
    Field {
        label: "Formula",
        help: "Over definitions, inputs, answers and steps: 2*X, c*(omega*X)^2/2.",
        ..text("formula")
    },
    Field {
        label: "Unit of the result",
        help: "The unit of the result; left out, that of its parts.",
        ..optional("unit")
    },
    Field {
        label: "Symbol",
        help: "The symbol in the worked solution; left out, Q and a number.",
        ..optional("symbol")
    },
    Field {
        label: "Key",
        help: "The name in files and on the command line; left out, made from the words.",
        ..optional("key")
    },
];

static GIVEN: [Field; 2] = [
    Field {
        label: "Answer",
        help: "The name of an answer or a question: natural_frequency.",
        ..text("name")
    },
    Field {
        label: "Value or requirement",
        help: "8.2 Hz; with its standard uncertainty, 8.2 Hz ± 0.05; for an optimum minimum or maximum, and limits, < 100 MPa.",
        ..text("value")
    },
];

static CHANGE: [Field; 3] = [
    Field { label: "Configuration", help: "A name of your own: weighted.", ..text("name") },
    Field {
        label: "Input",
        help: "The path of the input that differs: mass, masses[3].radius, a choice.",
        ..text("input")
    },
    Field {
        label: "Value or formula",
        help: "12 kg, or m + 2 kg over the inputs and definitions of the problem; an alternative by its name.",
        ..text("formula")
    },
];

const fn text(name: &'static str) -> Field {
    Field {
        name,
        label: "",
        help: "",
        symbol: "",
        default: None,
        default_before: None,
        kept_in: None,
        former: &[],
        shape: Shape::Text,
    }
}

const fn optional(name: &'static str) -> Field {
    Field { shape: Shape::Optional(|| &Shape::Text), ..text(name) }
}

const fn field(name: &'static str, item: fn() -> &'static Shape) -> Field {
    Field { shape: Shape::Rows { item, min: 0, most: MOST }, ..text(name) }
}

/// The shape of a whole problem: the inputs of an analysis, and the fields that every problem has.
pub(crate) const fn shape_of<A: Inputs>() -> Shape {
    Shape::Group(Fields(&fields_of::<A>))
}

/// The fields of linked problems with those that every problem has behind them.
pub(crate) fn with_common(own: &[Field]) -> &'static [Field] {
    own.iter().chain(&FIELDS).copied().collect::<Vec<Field>>().leak()
}

/// Returns true if fields are those of a whole problem.
pub(crate) fn are_of_problem(fields: &[Field]) -> bool {
    // No field of an analysis has this name: it is a keyword.
    fields.iter().any(|field| field.name == "let")
}

/// Number of fields before those that every problem has: the inputs of its analysis, and the problems linked to it.
pub fn own_fields(fields: &[Field]) -> usize {
    if are_of_problem(fields) { fields.len() - FIELDS.len() } else { fields.len() }
}

/// The inputs of a linked problem, where a value is them.
pub(crate) fn linked_problem(value: &Value) -> Option<&Record> {
    match value {
        Value::Group(inner) if are_of_problem(inner.fields) => Some(inner),
        _ => None,
    }
}

/// The linked problem that a path or a name is of, `fan` of `fan.mass`, and the rest of it; empty where it is of none.
pub fn within_problem<'p>(fields: &[Field], path: &'p str) -> (&'p str, &'p str) {
    let linked = path.split_once('.').filter(|(problem, _)| {
        let field = fields.iter().find(|field| field.name == *problem);
        field.is_some_and(|field| are_of_problem(field.shape.fields(None)))
    });
    linked.unwrap_or(("", path))
}

/// A record without the problems that are linked to it.
pub(crate) fn without_linked(record: &Record) -> Cow<'_, Record> {
    let is_problem = |value: &Value| linked_problem(value).is_some();
    if !record.values.iter().any(is_problem) {
        return Cow::Borrowed(record);
    }
    let own = |value: &Value| if is_problem(value) { Value::Absent } else { value.clone() };
    Cow::Owned(Record { values: record.values.iter().map(own).collect(), ..record.clone() })
}

/// One list for each analysis, made when it is first asked for.
fn fields_of<A: Inputs>() -> &'static [Field] {
    type Lists = Mutex<HashMap<TypeId, &'static [Field]>>;
    static LISTS: OnceLock<Lists> = OnceLock::new();
    let lists = LISTS.get_or_init(Lists::default);
    let mut lists = lists.lock().unwrap_or_else(PoisonError::into_inner);
    lists.entry(TypeId::of::<A>()).or_insert_with(|| with_common(A::SHAPE.fields(None)))
}
