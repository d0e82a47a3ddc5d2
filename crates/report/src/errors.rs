//! Errors of a problem as people and other programs read them: path, sentence with value and repair, line.

use dalembert_core::{Arg, Draft, FieldError, Locale, Shape, Text};
use serde_json::{Value as Json, json};

/// Version of the schema of errors: `{"format", "errors": [{"path", "message", "repair", "line"}]}`.
const ERRORS_FORMAT: u32 = 1;

/// The longest value that an error repeats in full, in characters.
const LONGEST_VALUE: usize = 60;

/// `{"format", "errors"}`.
pub fn errors_json(errors: &[RequestError]) -> Json {
    json!({ "format": ERRORS_FORMAT, "errors": errors.iter().map(RequestError::json).collect::<Vec<_>>() })
}

/// Error of a request, for another program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RequestError {
    /// Path of the input; empty where it is about none.
    pub path: String,
    /// The whole sentence, with value and repair.
    pub message: String,
    /// The name that was probably meant, where there is one.
    pub repair: Option<String>,
    /// Line of the problem file, counted from 1.
    pub line: Option<usize>,
}

impl RequestError {
    /// The error that a sentence states, with the line of the file that it stands in.
    pub fn of(text: &Text, line: Option<usize>, locale: &Locale) -> Self {
        let argument = |name| argument(text, name).map(str::to_owned);
        Self {
            path: argument("path").unwrap_or_default(),
            message: text.render(locale),
            repair: argument("near"),
            line,
        }
    }

    /// The error for another program.
    pub fn json(&self) -> Json {
        let mut error = json!({ "path": self.path, "message": self.message });
        if let Some(repair) = &self.repair {
            error["repair"] = repair.as_str().into();
        }
        if let Some(line) = self.line {
            error["line"] = line.into();
        }
        error
    }
}

/// The argument of a sentence, or of one within it.
fn argument<'t>(text: &'t Text, wanted: &str) -> Option<&'t str> {
    let own = text.args.iter().find_map(|(name, value)| match value {
        Arg::Verbatim(value) if *name == wanted => Some(value.as_str()),
        _ => None,
    });
    own.or_else(|| {
        text.args.iter().find_map(|(_, value)| match value {
            Arg::Text(inner) => argument(inner, wanted),
            _ => None,
        })
    })
}

/// An error with the value that was typed. Of a table nothing is printed: it may be the content of a file.
pub fn named_error(err: &FieldError, draft: &Draft, shape: &Shape) -> Text {
    let mut value = typed(draft, shape, &err.path);
    if value.contains('\n') {
        value.clear();
    }
    let text =
        if value.is_empty() { Text::new("{path}: {why}") } else { Text::new("{path} = {value}: {why}") };
    text.with("path", &err.path).with("value", short(&value)).with_text("why", err.why.clone())
}

/// The text of the leaf at a path; empty where there is none.
pub fn typed(draft: &Draft, shape: &Shape, path: &str) -> String {
    match draft.at(shape, path) {
        Ok((Draft::Leaf(text), _)) => text.clone(),
        _ => String::new(),
    }
}

/// A value on one line of an error.
pub fn short(value: &str) -> String {
    let mut line: String =
        value.chars().take(LONGEST_VALUE).map(|c| if c == '\n' { ' ' } else { c }).collect();
    if value.chars().nth(LONGEST_VALUE).is_some() {
        line.push('…');
    }
    line
}
