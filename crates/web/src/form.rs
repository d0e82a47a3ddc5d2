//! The lines of a form for a page.

use dalembert_core::{
    COMMON_LISTS, Locale, Shape, Symbol, Text,
    describe::{in_words, takes},
    form::{self, FormLine, Role},
    printer, within_problem,
};
use dalembert_report::{RequestError, typed};
use serde_json::{Value as Json, json};

use crate::problem::Problem;

/// The lines of the form of a problem, from top to bottom, each with its error and the texts to write instead.
pub(crate) fn lines(problem: &Problem, errors: &[RequestError], locale: &Locale) -> Vec<Json> {
    let lines = form::lines(&problem.shape, &problem.file.draft);
    lines
        .iter()
        .map(|shown| {
            let mut json = line(shown, problem, locale);
            // Definitions, questions and the like, which every problem has.
            let (_, inner) = within_problem(problem.shape.fields(None), &shown.path);
            if COMMON_LISTS.contains(&inner.split(['.', '[']).next().unwrap_or_default()) {
                json["common"] = true.into();
            }
            if let Some(error) = errors.iter().find(|error| error.path == shown.path) {
                json["error"] = json!({ "message": error.message, "repairs": problem.repairs(&error.path) });
            }
            json
        })
        .collect()
}

fn line(line: &FormLine, problem: &Problem, locale: &Locale) -> Json {
    let title = line.field.title().render(locale);
    let say = |words: &'static str| Text::from(words).render(locale);
    let mut json = json!({
        "path": line.path,
        "depth": line.depth,
        "label": line.number.map_or_else(|| title.clone(), |number| format!("{title} {number}")),
        "symbol": symbol(line, locale),
        "help": if line.number.is_none() { say(line.field.help) } else { String::new() },
        "optional": line.optional,
        "row": line.number,
    });
    match &line.role {
        Role::Leaf { shape, text } => {
            json["role"] = "text".into();
            json["text"] = form::in_language(text, shape, locale.style.decimal).into();
            json["takes"] =
                if line.number.is_none() { takes(line.field, locale) } else { in_words(shape, locale) }
                    .into();
            match shape.present() {
                Shape::Flag => {
                    let one = |name: &'static str| json!({ "name": name, "label": say(name) });
                    json["alternatives"] = ["yes", "no"].map(one).into_iter().collect();
                }
                Shape::Reference(list) => {
                    let list = match within_problem(problem.shape.fields(None), &line.path) {
                        ("", _) => list.to_owned(),
                        (of, _) => format!("{of}.{list}"),
                    };
                    let names = form::names(&problem.file.draft, &problem.shape, &list);
                    json["alternatives"] =
                        names.iter().map(|name| json!({ "name": name, "label": name })).collect();
                }
                _ => {}
            }
        }
        Role::Table { content } => {
            json["role"] = "table".into();
            json["text"] = typed(&problem.file.draft, &problem.shape, &line.path).into();
            json["takes"] = takes(line.field, locale).into();
            json["content"] = content.render(locale).into();
        }
        Role::Group { .. } => json["role"] = "group".into(),
        Role::Choice { variants, chosen } => {
            json["role"] = "choice".into();
            json["text"] = chosen.and_then(|at| variants.get(at)).map(|variant| variant.name).into();
            json["alternatives"] = variants
                .iter()
                .map(|variant| {
                    json!({ "name": variant.name, "label": say(variant.label), "help": say(variant.help) })
                })
                .collect();
        }
        Role::Rows { count } => {
            json["role"] = "rows".into();
            json["count"] = (*count).into();
            json["takes"] = takes(line.field, locale).into();
            if let Shape::Rows { min, most, .. } = line.field.shape.present() {
                json["least"] = min.into();
                json["most"] = most.into();
            }
        }
        Role::Absent => json["role"] = "absent".into(),
    }
    json
}

/// Symbol of the field, with the numbers of the rows that the line stands in.
fn symbol(line: &FormLine, locale: &Locale) -> String {
    if line.field.symbol.is_empty() {
        return String::new();
    }
    let rows = line.path.split('[').skip(1).filter_map(|part| part.split(']').next()?.parse().ok());
    printer::symbol_in(&rows.fold(Symbol::from(line.field.symbol), Symbol::row), locale.style)
}
