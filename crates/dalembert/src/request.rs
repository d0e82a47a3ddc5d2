//! Requests of another program: a problem as JSON, solved as `dalembert solve` solves it.
//!
//! ```json
//! {"problem": "vibration/rotating-unbalance", "case": 1, "set": {"mass": "41 kg"}, "ask": ["rms_velocity"]}
//! ```
//!
//! `problem` is an id or a file, `problem_file` the text of a file. The other keys are the options of `dalembert solve`:
//! `case`, `set`, `let`, `ask`, `given`, `configuration`, `units`, `unit`, `digits`, `strict`; `lang` is the language, and
//! `only` the keys of the result that are wanted.

mod inputs;

use std::path::Path;

use dalembert_core::{Entry, Language, Locale, Record, Solution, Text, UnitSetting, nearest};
use dalembert_report::{Block, DocumentFormat, RESULT_KEYS, WorkedProblem, document, html_fragment, json_of};
use serde_json::{Map, Value as Json, json};

pub use dalembert_report::RequestError;

pub use self::inputs::NamedValue;
use crate::{
    commands::{list, schema, show, solve},
    console::Console,
    failure::Failure,
    problem::{self, LoadedProblem, ProblemOptions, ProblemSource},
    solving::{self, SolveOutcome},
};

/// The keys of a request.
const KEYS: [&str; 14] = [
    "problem",
    "problem_file",
    "case",
    "set",
    "let",
    "ask",
    "given",
    "configuration",
    "units",
    "unit",
    "digits",
    "strict",
    "lang",
    "only",
];

/// Failure of a request.
#[derive(Clone, Debug)]
pub struct RequestFailure {
    /// Kind of the failure.
    pub kind: FailureKind,
    /// Every error.
    pub errors: Vec<RequestError>,
}

/// Kind of a failure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FailureKind {
    /// The request, an input or a file is wrong.
    Input,
    /// The problem is well written but has no answer.
    Refusal,
    /// Fault of the program.
    Internal,
}

impl RequestFailure {
    pub(crate) fn of(failure: &Failure, locale: &Locale) -> Self {
        let kind = match failure {
            Failure::Refused(_) => FailureKind::Refusal,
            Failure::Fault(_) => FailureKind::Internal,
            _ => FailureKind::Input,
        };
        Self { kind, errors: failure.errors(locale) }
    }
}

/// A problem as it is asked for, its inputs understood.
#[derive(Debug)]
pub struct RequestedProblem {
    problem: LoadedProblem,
    locale: Locale,
    only: Option<Vec<String>>,
}

/// A problem and what came of it.
#[derive(Debug)]
pub struct SolvedProblem {
    requested: RequestedProblem,
    outcome: SolveOutcome,
}

impl RequestedProblem {
    /// Reads a request; `language` is that of a request which names none.
    ///
    /// # Errors
    /// Everything in it that is wrong.
    pub fn read(request: &Map<String, Json>, language: Language) -> Result<Self, RequestFailure> {
        let locale = locale(request, language);
        read(request, locale).map_err(|failure| RequestFailure::of(&failure, &locale))
    }

    /// Analysis of the problem.
    pub fn entry(&self) -> &'static Entry {
        self.problem.entry
    }

    /// Inputs as read.
    pub fn record(&self) -> &Record {
        &self.problem.record
    }

    /// Language and numbers.
    pub fn locale(&self) -> &Locale {
        &self.locale
    }

    /// Solves the problem.
    ///
    /// # Errors
    /// An input that only the analysis can judge, a unit that no answer has; a fault of the analysis. A refusal is an
    /// outcome.
    pub fn solve(self) -> Result<SolvedProblem, RequestFailure> {
        match solve::outcome(&self.problem) {
            Ok(outcome) => Ok(SolvedProblem { requested: self, outcome }),
            Err(failure) => Err(RequestFailure::of(&failure, &self.locale)),
        }
    }
}

impl SolvedProblem {
    /// The problem that was solved.
    pub fn requested(&self) -> &RequestedProblem {
        &self.requested
    }

    /// The solution, or why there is none.
    ///
    /// # Errors
    /// The refusal.
    pub fn solution(&self) -> Result<&Solution, RequestFailure> {
        self.outcome.as_ref().map_err(|why| {
            let error = RequestError {
                path: String::new(),
                message: why.render(&self.requested.locale),
                repair: None,
                line: None,
            };
            RequestFailure { kind: FailureKind::Refusal, errors: vec![error] }
        })
    }

    /// The same, for a report.
    pub fn worked(&self) -> WorkedProblem<'_> {
        self.requested.problem.worked(&self.outcome)
    }

    /// The result with the keys that the request wants.
    pub fn json(&self) -> Json {
        let RequestedProblem { only, locale, .. } = &self.requested;
        let wanted = |key: &str| only.as_ref().is_none_or(|only| only.iter().any(|wanted| wanted == key));
        json_of(&self.worked(), &wanted, locale)
    }
}

/// The worked solution of a request, as a document in the `format` that it names, or its figures alone, each with title
/// and SVG.
///
/// # Errors
/// Everything in the request that is wrong. A refusal is a document too.
pub fn reported(request: &Map<String, Json>, language: Language) -> Result<Json, RequestFailure> {
    let mut request = request.clone();
    let format = request.remove("format").unwrap_or_default();
    let solved = RequestedProblem::read(&request, language)?.solve()?;
    let locale = solved.requested.locale;
    let document = document(&solved.worked(), &locale);
    let write = |format: DocumentFormat| Json::from(format.write(&document, None, &locale));
    Ok(match format.as_str() {
        Some("html") => write(DocumentFormat::Html),
        Some("html_fragment") => html_fragment(&document).into(),
        Some("latex") => write(DocumentFormat::Latex),
        Some("markdown") => write(DocumentFormat::Markdown),
        Some("text") => write(DocumentFormat::Text),
        Some("figures") => document.blocks.iter().filter_map(figure).collect(),
        _ => {
            let why = Text::new("format = {value}: write one of {known}").with("path", "format");
            let known = "html, html_fragment, latex, markdown, text, figures";
            let failure = Failure::input(why.with("value", format).with("known", known));
            return Err(RequestFailure::of(&failure, &locale));
        }
    })
}

/// The figure that a block is.
fn figure(block: &Block) -> Option<Json> {
    match block {
        Block::Figure(picture) => Some(json!({ "title": picture.title, "svg": picture.svg() })),
        _ => None,
    }
}

/// The analyses of a search, the best match first; all without words.
pub fn listed(words: &[String], language: Language) -> Json {
    list::json(words, &locale(&Map::new(), language))
}

/// Inputs, answers, questions, sources and cases of an analysis.
///
/// # Errors
/// There is no such analysis.
pub fn described(id: &str, language: Language) -> Result<Json, RequestFailure> {
    let locale = locale(&Map::new(), language);
    show::json(id, &locale).map_err(|failure| RequestFailure::of(&failure, &locale))
}

/// JSON Schema of the problem file of an analysis, of linked problems, or of results.
///
/// # Errors
/// There is no such analysis.
pub fn schema_of(id: &str, language: Language) -> Result<Json, RequestFailure> {
    let locale = locale(&Map::new(), language);
    schema::json(id, &locale).map_err(|failure| RequestFailure::of(&failure, &locale))
}

/// Runs what may panic by a fault of the program, which becomes a failure that names the place.
///
/// # Errors
/// The panic.
pub fn guarded<T>(what: &str, run: impl FnOnce() -> T) -> Result<T, RequestFailure> {
    solving::contained(what, run).map_err(|failure| RequestFailure::of(&failure, &Locale::english()))
}

/// Language and numbers of a request.
pub(crate) fn locale(request: &Map<String, Json>, language: Language) -> Locale {
    let language = request.get("lang").and_then(Json::as_str).map_or(language, Language::of);
    let mut locale = Locale::of(language);
    if let Some(digits @ 1..=17) = request.get("digits").and_then(Json::as_u64) {
        locale.style.digits = digits as u8;
    }
    locale
}

fn read(request: &Map<String, Json>, locale: Locale) -> Result<RequestedProblem, Failure> {
    let mut keys = Keys { request, errors: Vec::new() };
    keys.are_known();
    let named = keys.text("problem");
    let text = keys.text("problem_file");
    if named.is_some() == text.is_some() {
        keys.errors
            .push("name one of `problem`, an id or a file, and `problem_file`, the text of a file".into());
    }
    if named.is_some_and(problem::is_standard_input) {
        keys.errors
            .push("requests stand on standard input: send the text of a file as `problem_file`".into());
    }
    let case = keys.whole("case", 1, u64::from(u32::MAX)).map(|case| case as u32);
    keys.whole("digits", 1, 17);
    let language = keys.text("lang");
    if let Some(language) = language.filter(|language| Language::of_tag(language).is_none()) {
        keys.errors.push(Text::new("lang {language}: write en or pt-BR").with("language", language));
    }
    let strict = match request.get("strict") {
        None | Some(Json::Null) => false,
        Some(Json::Bool(strict)) => *strict,
        Some(other) => keys.wrong("strict", other, "true or false"),
    };
    let (define, ask) = (keys.pairs("let"), keys.pairs("ask"));
    let (given, configuration) = (keys.pairs("given"), keys.pairs("configuration"));
    let values = keys.object("set");
    let units = keys.text("units").map(UnitSetting::read).transpose().map_err(Failure::input)?;
    let unit = keys.units();
    let only = keys.keys_of_result();
    if !keys.errors.is_empty() {
        return Err(Failure::Input(keys.errors));
    }
    let asked = ProblemSource {
        case,
        values,
        define: &define,
        ask: &ask,
        given: &given,
        configuration: &configuration,
        options: ProblemOptions::OF_REQUEST,
        strict,
        units,
        ..ProblemSource::named(named.unwrap_or_default())
    };
    let console = Console::of_program(locale);
    let mut problem = match text {
        Some(text) => problem::of_file(Path::new("problem_file"), text, &asked, &console)?,
        None => problem::read(&asked, &console)?,
    };
    let locale = locale.at(problem.entry.about.id);
    problem.show.extend(unit);
    Ok(RequestedProblem { problem, locale, only })
}

/// The keys of a request, and what is wrong with them.
struct Keys<'r> {
    request: &'r Map<String, Json>,
    errors: Vec<Text>,
}

impl<'r> Keys<'r> {
    fn are_known(&mut self) {
        for key in self.request.keys().filter(|key| !KEYS.contains(&key.as_str())) {
            self.errors.push(unknown(key, &KEYS));
        }
    }

    fn get(&self, key: &str) -> Option<&'r Json> {
        self.request.get(key).filter(|value| !value.is_null())
    }

    /// Reports a value of another type.
    fn wrong<T: Default>(&mut self, key: &'static str, value: &Json, want: &'static str) -> T {
        let text = Text::new("{key} = {value}: {want} is needed here").with("key", key).with("path", key);
        let shown: String = value.to_string().chars().take(60).collect();
        self.errors.push(text.with("value", shown).with_text("want", want));
        T::default()
    }

    fn text(&mut self, key: &'static str) -> Option<&'r str> {
        match self.get(key)? {
            Json::String(text) => Some(text),
            other => self.wrong(key, other, "a text"),
        }
    }

    fn whole(&mut self, key: &'static str, least: u64, most: u64) -> Option<u64> {
        let value = self.get(key)?;
        match value.as_u64().filter(|number| (least..=most).contains(number)) {
            Some(number) => Some(number),
            None if most == 17 => self.wrong(key, value, "a whole number from 1 to 17"),
            None => self.wrong(key, value, "a whole number, counted from 1,"),
        }
    }

    fn object(&mut self, key: &'static str) -> Option<&'r Map<String, Json>> {
        match self.get(key)? {
            Json::Object(object) => Some(object),
            other => self.wrong(key, other, "an object of names and values"),
        }
    }

    /// An object of names and texts, or a list of texts, as options of the command line: `nu=0.3`. Objects within are
    /// named behind a point.
    fn pairs(&mut self, key: &'static str) -> Vec<String> {
        match self.get(key) {
            None => Vec::new(),
            Some(Json::Array(all)) if all.iter().all(Json::is_string) => {
                all.iter().filter_map(Json::as_str).map(str::to_owned).collect()
            }
            Some(Json::Object(all)) => {
                let mut found = Vec::new();
                flatten("", all, &mut found);
                found
            }
            Some(other) => self.wrong(key, other, "an object of names and texts"),
        }
    }

    /// Units of answers.
    fn units(&mut self) -> Vec<(String, String)> {
        let mut units = Vec::new();
        for (answer, unit) in self.object("unit").into_iter().flatten() {
            match unit.as_str() {
                Some(unit) => units.push((answer.clone(), unit.to_owned())),
                None => self.wrong("unit", unit, "a text"),
            }
        }
        units
    }

    fn keys_of_result(&mut self) -> Option<Vec<String>> {
        let value = self.get("only")?;
        let Json::Array(all) = value else {
            return self.wrong("only", value, "a list of keys of the result");
        };
        let keys: Vec<String> = all.iter().map(|key| key.as_str().unwrap_or_default().to_owned()).collect();
        for key in keys.iter().filter(|key| !RESULT_KEYS.contains(&key.as_str())) {
            self.errors.push(unknown(key, &RESULT_KEYS));
        }
        Some(keys)
    }
}

fn flatten(above: &str, all: &Map<String, Json>, found: &mut Vec<String>) {
    for (name, value) in all {
        match value {
            Json::Object(inner) => flatten(&format!("{above}{name}."), inner, found),
            Json::String(text) => found.push(format!("{above}{name}={text}")),
            other => found.push(format!("{above}{name}={other}")),
        }
    }
}

fn unknown(key: &str, known: &[&str]) -> Text {
    match nearest(key, known.iter().copied()) {
        Some(near) => Text::new("there is no `{name}`; did you mean `{near}`?").with("near", near),
        None => Text::new("there is no `{name}`; write one of {known}").with("known", known.join(", ")),
    }
    .with("name", key)
    .with("path", key)
}
