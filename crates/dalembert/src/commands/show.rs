//! `dalembert show`

use std::process::ExitCode;

use dalembert_core::{
    ChildList, Entry, Field, FieldLimit, Locale, Measure, Shape, Stop, Text, Variant,
    cases::{self, Case, ComparisonRule, Seen},
    describe::takes,
    search,
    suggestions::{Suggestion, suggestions},
};
use dalembert_report::{Block, Document, NamedValue};
use dalembert_units as units;
use serde_json::{Map, Value as Json, json};

use crate::{
    arguments::Show,
    console::{Console, print_json},
    failure::Failure,
    problem,
    solving::guarded,
};

/// Shows what an analysis asks for, what it answers, its sources and its cases.
pub(crate) fn run(show: &Show, console: &Console) -> Result<ExitCode, Failure> {
    if show.json {
        print_json(&json(&show.id, &console.locale)?)?;
    } else {
        let entry = problem::analysis(&show.id)?;
        let (cases, locale) = (cases_of(entry)?, console.locale.at(entry.about.id));
        let (answers, questions) = promises(entry, &cases, &locale)?;
        console.print(document(entry, &cases, &answers, &questions, &locale))?;
    }
    Ok(ExitCode::SUCCESS)
}

/// An analysis for another program: inputs, answers, usual questions, sources, cases.
pub(crate) fn json(id: &str, locale: &Locale) -> Result<Json, Failure> {
    let entry = problem::analysis(id)?;
    let (cases, locale) = (cases_of(entry)?, locale.at(entry.about.id));
    let (answers, questions) = promises(entry, &cases, &locale)?;
    Ok(described(entry, &cases, &answers, &questions, &locale))
}

fn cases_of(entry: &Entry) -> Result<Vec<Case>, Failure> {
    cases::cases(entry).map_err(|why| Failure::Fault(format!("the cases of {}: {why}", entry.about.id)))
}

/// Something an analysis answers.
struct Promise {
    name: String,
    label: String,
    unit: units::Unit,
}

/// Answers and usual questions of all cases: an analysis has different ones for different alternatives.
fn promises(
    entry: &'static Entry,
    cases: &[Case],
    locale: &Locale,
) -> Result<(Vec<Promise>, Vec<Suggestion>), Failure> {
    let mut promises: Vec<Promise> = Vec::new();
    let mut questions: Vec<Suggestion> = Vec::new();
    for case in cases {
        let Ok(record) = case.record(entry) else { continue };
        let Ok(solution) = guarded(entry, || entry.solve(&record, &Stop::new()))? else { continue };
        for question in suggestions(entry, &solution) {
            if questions.iter().all(|known| known.key != question.key) {
                questions.push(question);
            }
        }
        for answer in solution.answers {
            // One of several stands for all.
            let name = answer.name.base;
            let name = if answer.name.rows[0] == 0 { name.to_owned() } else { format!("{name}[…]") };
            if !promises.iter().any(|promise| promise.name == name) {
                let label = Text::from(answer.label).render(locale);
                promises.push(Promise { name, label, unit: answer.unit });
            }
        }
    }
    Ok((promises, questions))
}

fn document(
    entry: &Entry,
    cases: &[Case],
    answers: &[Promise],
    questions: &[Suggestion],
    locale: &Locale,
) -> Document {
    let about = entry.about;
    let say = |words: &'static str| Text::from(words).render(locale);
    let mut inputs = Vec::new();
    Lister { locale, lines: &mut inputs, described: Described::default() }.fields(entry.fields(), "", 0);
    let begin = Text::new("`dalembert new {id}` writes a file in which these inputs are to be filled in.");
    let begin = begin.with("id", about.id);
    let answer = |promise: &Promise| NamedValue {
        label: promise.name.clone(),
        value: match promise.unit.pretty() {
            unit if unit.is_empty() => promise.label.clone(),
            unit => format!("{} [{unit}]", promise.label),
        },
        ..NamedValue::default()
    };
    let case = |(n, case): (usize, &Case)| {
        let texts = [&case.title(), &case.source, &case.statement, &case.note];
        let [name, source, statement, note] = texts.map(|text| text.render(locale));
        let seen = case.seen.map_or_else(String::new, |seen| format!(", {}", say(seen_in(seen))));
        let mut line = format!("{}: {name} — {source} ({}{seen})", n + 1, say(case.truth.name()));
        for text in [statement, note].iter().filter(|text| !text.is_empty()) {
            line += if line.ends_with(['?', '!']) { " " } else { ". " };
            line += text.trim_end_matches('.');
        }
        line
    };
    let question = |question: &Suggestion| NamedValue {
        label: format!("--ask {}", question.key),
        value: format!("{}: {}", question.title(locale), question.formula),
        ..NamedValue::default()
    };
    let mut blocks = vec![
        Block::Paragraph(about.id.to_owned()),
        Block::Paragraph(say(about.summary)),
        Block::Heading(say("Inputs")),
        Block::Lines(inputs),
        Block::Paragraph(begin.render(locale)),
        Block::Heading(say("Answers")),
        Block::Lines(answers.iter().map(answer).collect()),
    ];
    if !questions.is_empty() {
        blocks.push(Block::Heading(say("Usual questions")));
        blocks.push(Block::Lines(questions.iter().map(question).collect()));
    }
    blocks.extend([
        Block::Heading(say("Cases")),
        Block::Items(cases.iter().enumerate().map(case).collect()),
        Block::Heading(say("Sources")),
        Block::Items(
            about
                .sources
                .iter()
                .map(|source| format!("{}: {}", source.short_in(locale), source.full_in(locale)))
                .collect(),
        ),
    ]);
    Document { title: say(about.title), blocks }
}

/// Form in which a published answer was seen, in words.
pub(crate) fn seen_in(seen: Seen) -> &'static str {
    match seen {
        Seen::Book => "seen in print",
        Seen::Companion => "seen in the output of a companion",
        Seen::Site => "seen on a page that quotes it",
        Seen::Recalled => "from memory",
    }
}

/// Groups and alternatives that were described, and where: what several inputs share, or what contains itself, is
/// described once. A single input is as short as the hint to where it stands.
#[derive(Default)]
struct Described(Vec<(ChildList, String)>);

impl Described {
    /// Path at which the child list of the shape was described; if it was not yet, it is recorded at `path`.
    fn before(&mut self, shape: &Shape, path: &str) -> Option<String> {
        let child_list = shape.child_list()?;
        let known = self.0.iter().find(|(known, _)| child_list.parts > 1 && *known == child_list);
        let first = known.map(|(_, first)| first.clone());
        if first.is_none() {
            self.0.push((child_list, path.to_owned()));
        }
        first
    }
}

/// Writes fields as lines, each with its key and what may stand there.
struct Lister<'l> {
    locale: &'l Locale,
    lines: &'l mut Vec<NamedValue>,
    described: Described,
}

impl Lister<'_> {
    fn say(&self, words: &'static str) -> String {
        Text::from(words).render(self.locale)
    }

    fn line(&mut self, depth: usize, label: String, value: String) {
        self.lines.push(NamedValue { depth, label, value, ..NamedValue::default() });
    }

    fn fields(&mut self, fields: &'static [Field], above: &str, depth: usize) {
        for field in fields {
            let mut value = takes(field, self.locale);
            let symbol = if field.symbol.is_empty() { String::new() } else { format!(" {}", field.symbol) };
            let label = self.say(field.label);
            let path = format!("{above}{}", field.name);
            let (shape, path) = inner(field.shape, path);
            let first = self.described.before(&shape, &path);
            if let Some(first) = &first {
                let like = Text::new("as in {field}").with("field", first.as_str());
                value = format!("{value}, {}", like.render(self.locale));
            }
            self.line(depth, field.name.to_owned(), format!("{label}{symbol}: {value}"));
            if !field.help.is_empty() {
                self.line(depth, String::new(), self.say(field.help));
            }
            if first.is_none() {
                self.inside(&shape, &path, depth + 1);
            }
        }
    }

    fn inside(&mut self, shape: &Shape, path: &str, depth: usize) {
        match shape {
            Shape::Group(fields) | Shape::Table(fields) => self.fields(fields(), &format!("{path}."), depth),
            Shape::OneOf(variants) => {
                for variant in variants() {
                    self.line(depth, variant.name.to_owned(), self.say(variant.label));
                    if !variant.help.is_empty() {
                        self.line(depth, String::new(), self.say(variant.help));
                    }
                    self.fields((variant.fields)(), &format!("{path}.{}.", variant.name), depth + 1);
                }
            }
            _ => {}
        }
    }
}

fn described(
    entry: &Entry,
    cases: &[Case],
    answers: &[Promise],
    questions: &[Suggestion],
    locale: &Locale,
) -> Json {
    let about = entry.about;
    let say = |words: &'static str| Text::from(words).render(locale);
    let case = |case: &Case| {
        let expected = |expected: &cases::Expected| {
            let (how, why, computed) = match &expected.how {
                ComparisonRule::ToTheLastPlace => ("to the last place", String::new(), None),
                ComparisonRule::Computed => ("to the last place, and to four digits", String::new(), None),
                ComparisonRule::Within(_, why) => ("within", why.render(locale), None),
                ComparisonRule::Disputed { why, computed } => {
                    ("disputed", why.render(locale), Some(computed))
                }
            };
            let printed = &expected.printed;
            let held = json!({ "printed": printed, "held": how, "why": why, "ours": computed });
            (expected.answer.clone(), held)
        };
        json!({
            "name": case.name,
            "title": case.title().render(locale),
            "source": case.source.render(locale),
            "truth": case.truth.name(),
            "truth_name": say(case.truth.name()),
            "seen": case.seen.map(Seen::name),
            "seen_in": case.seen.map(|seen| say(seen_in(seen))),
            "statement": case.statement.render(locale),
            "asked": case.asked,
            "note": case.note.render(locale),
            "expect": case.expect.iter().map(expected).collect::<Map<_, _>>(),
            "refused": case.refused,
        })
    };
    let answer = |promise: &Promise| json!({ "name": promise.name, "label": promise.label, "unit": promise.unit.ascii() });
    let question = |question: &Suggestion| {
        json!({
            "key": question.key,
            "label": question.title(locale),
            "formula": question.formula,
            "unit": question.unit,
        })
    };
    json!({
        "id": about.id,
        "family": entry.family(),
        "family_name": search::family(entry.family()).render(locale),
        "topic": say(about.topic),
        "keywords": about.keywords,
        "title": say(about.title),
        "summary": say(about.summary),
        "inputs": fields(entry.fields(), locale, "", &mut Described::default()),
        "answers": answers.iter().map(answer).collect::<Vec<_>>(),
        "questions": questions.iter().map(question).collect::<Vec<_>>(),
        "sources": about.sources.iter().map(|source| json!({ "short": source.short, "full": source.full })).collect::<Vec<_>>(),
        "cases": cases.iter().map(case).collect::<Vec<_>>(),
    })
}

/// The shape that has a child list, below what may be left out or repeated, and its path.
fn inner(shape: Shape, path: String) -> (Shape, String) {
    match shape {
        Shape::Optional(shape) => inner(*shape(), path),
        Shape::Rows { item, .. } => inner(*item(), format!("{path}[n]")),
        _ => (shape, path),
    }
}

/// Fields for another program.
fn fields(list: &'static [Field], locale: &Locale, above: &str, described: &mut Described) -> Json {
    let field = |field: &Field| {
        let mut json = json!({
            "name": field.name,
            "label": field.title().render(locale),
            "help": Text::from(field.help).render(locale),
            "symbol": field.symbol,
            "default": field.default,
            "takes": takes(field, locale),
        });
        let shape = shape(&field.shape, locale, &format!("{above}{}", field.name), described);
        if let (Json::Object(json), Json::Object(shape)) = (&mut json, shape) {
            json.extend(shape);
        }
        json
    };
    list.iter().map(field).collect()
}

/// A shape for another program; `like` is the path where its child list is described.
fn shape(shape: &Shape, locale: &Locale, path: &str, described: &mut Described) -> Json {
    if let Some(first) = described.before(shape, path) {
        let kind = match shape {
            Shape::OneOf(_) => "one-of",
            Shape::Table(_) => "table",
            _ => "group",
        };
        return json!({ "kind": kind, "like": first });
    }
    let limit = |limit: FieldLimit| match limit {
        FieldLimit::None => Json::Null,
        FieldLimit::Including(value) => json!({ "value": value, "included": true }),
        FieldLimit::Excluding(value) => json!({ "value": value, "included": false }),
    };
    match shape {
        Shape::Quantity(measure) => {
            let mut quantity = json!({
                "kind": "quantity",
                "quantity": measure.kind().name(),
                "unit": measure.own_unit().ascii(),
                "min": limit(measure.min),
                "max": limit(measure.max),
            });
            if !measure.others.is_empty() {
                let other = |other: &Measure| json!({ "quantity": other.kind().name(), "unit": other.own_unit().ascii() });
                quantity["others"] = measure.others.iter().map(other).collect();
            }
            quantity
        }
        Shape::Vector(measure, len) => json!({
            "kind": "vector",
            "components": len,
            "quantity": measure.kind().name(),
            "unit": measure.own_unit().ascii(),
        }),
        Shape::Text => json!({ "kind": "text" }),
        Shape::Flag => json!({ "kind": "flag" }),
        Shape::Count { min, max } => json!({ "kind": "count", "min": min, "max": max }),
        Shape::OneOf(variants) => {
            let variant = |variant: &Variant| {
                json!({
                    "name": variant.name,
                    "label": Text::from(variant.label).render(locale),
                    "help": Text::from(variant.help).render(locale),
                    "fields": fields((variant.fields)(), locale, &format!("{path}.{}.", variant.name), described),
                })
            };
            json!({ "kind": "one-of", "alternatives": variants().iter().map(variant).collect::<Vec<_>>() })
        }
        Shape::Group(inner) => {
            json!({ "kind": "group", "fields": fields(inner(), locale, &format!("{path}."), described) })
        }
        Shape::Rows { item, min, most } => {
            json!({ "kind": "rows", "min": min, "most": most, "item": self::shape(item(), locale, &format!("{path}[n]"), described) })
        }
        Shape::Table(columns) => {
            json!({ "kind": "table", "columns": fields(columns(), locale, &format!("{path}."), described) })
        }
        Shape::Reference(list) => json!({ "kind": "reference", "rows": list }),
        Shape::Optional(inner) => {
            let mut json = self::shape(inner(), locale, path, described);
            if let Json::Object(json) = &mut json {
                json.insert("optional".into(), true.into());
            }
            json
        }
    }
}
