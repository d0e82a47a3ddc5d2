//! The analyses for a page in a browser: text in, JSON out.
//!
//! A page holds the text of a problem file and nothing else of the problem. [`opened`] gives its form, its errors, its
//! answers and the worked solution; [`changed`] the same after a change of one input; [`checked`] the verdict on answers
//! that a reader typed; [`solved`] the result that `dalembert serve` gives for the same text. Compiled for
//! `wasm32-unknown-unknown`, the crate exports them to JavaScript.

mod change;
#[cfg(target_family = "wasm")]
pub mod exports;
mod form;
mod problem;

// An analysis is there because its crate is linked.
use dalembert_plugins as _;

use dalembert_core::{Answer, Language, Locale, Stop, check, registry};
use dalembert_report::{
    CheckedAnswer, RequestError, checked_answers, document, errors_json, html_fragment, json,
};
use serde_json::{Map, Value as Json, json};

use self::{
    change::Change,
    problem::{Problem, SolvedProblem},
};

/// The result of a problem file, as the schema of results describes it, or `{"format", "errors"}`.
pub fn solved(problem_file: &str, language: &str) -> String {
    let locale = locale(language);
    let solved = Problem::read(problem_file, &locale)
        .and_then(|problem| Ok(json(&problem.solve(&locale)?.worked(), &locale)));
    solved.unwrap_or_else(|errors| errors_json(&errors)).to_string()
}

/// Form and solution of a problem file: `{"file", "id", "form", "errors", "answers", "refusal", "html"}`.
///
/// `form` is the lines of the form, `errors` what is wrong with the inputs, each with texts to write instead; `html` is the
/// worked solution, and is null where there are errors.
pub fn opened(problem_file: &str, language: &str) -> String {
    let locale = locale(language);
    match Problem::read(problem_file, &locale) {
        Ok(problem) => page(&problem, &locale),
        Err(errors) => failed(&errors),
    }
    .to_string()
}

/// The same after a change of the form: `{"do", "path", "text"}`, see `change.rs`. A change that cannot be made is an error,
/// and the problem stays as it is.
pub fn changed(problem_file: &str, change: &str, language: &str) -> String {
    let locale = locale(language);
    let changed = Problem::read(problem_file, &locale).and_then(|mut problem| {
        let change: Change = serde_json::from_str(change).map_err(|why| vec![error(why)])?;
        change.apply(&mut problem, &locale)?;
        Ok(problem)
    });
    match changed {
        Ok(problem) => page(&problem, &locale),
        Err(errors) => failed(&errors),
    }
    .to_string()
}

/// Verdicts on typed answers, an object of names and texts: `{"answers": […]}`, each as `dalembert check` gives it, with
/// its lines of text; or `{"errors"}`.
pub fn checked(problem_file: &str, answers: &str, language: &str) -> String {
    let locale = locale(language);
    let checked = Problem::read(problem_file, &locale).and_then(|problem| {
        let typed: Map<String, Json> = serde_json::from_str(answers).map_err(|why| vec![error(why)])?;
        Ok(verdicts(&problem.solve(&locale)?, &typed, &locale))
    });
    match checked {
        Ok(verdicts) => json!({ "answers": verdicts }),
        Err(errors) => failed(&errors),
    }
    .to_string()
}

/// Number of analyses that are linked: none where the constructors of the module have not run.
pub fn analyses() -> usize {
    registry().len()
}

fn locale(language: &str) -> Locale {
    Locale::of(Language::of(language))
}

/// A request that a page does not make.
fn error(why: impl std::fmt::Display) -> RequestError {
    RequestError { path: String::new(), message: why.to_string(), repair: None, line: None }
}

fn failed(errors: &[RequestError]) -> Json {
    json!({ "errors": errors.iter().map(RequestError::json).collect::<Vec<_>>() })
}

fn page(problem: &Problem, locale: &Locale) -> Json {
    let locale = &locale.at(problem.file.entry.about.id);
    let solved = problem.solve(locale);
    let errors = solved.as_ref().err().map_or(&[][..], Vec::as_slice);
    let solution = solved.as_ref().ok().and_then(|solved| solved.outcome.as_ref().ok());
    let refusal = solved.as_ref().ok().and_then(|solved| solved.outcome.as_ref().err());
    json!({
        "file": problem.text(),
        "id": problem.file.entry.about.id,
        "form": form::lines(problem, errors, locale),
        "errors": errors.iter().map(RequestError::json).collect::<Vec<_>>(),
        "answers": solution.into_iter().flat_map(|of| &of.answers).map(|one| answer(one, locale)).collect::<Vec<_>>(),
        "refusal": refusal.map(|why| why.render(locale)),
        "html": solved.as_ref().ok().map(|solved| html_fragment(&document(&solved.worked(), locale))),
    })
}

fn answer(answer: &Answer, locale: &Locale) -> Json {
    json!({
        "name": answer.name.to_string(),
        "label": answer.label(locale),
        "shown": answer.shown(locale),
        "example": if answer.si().is_some() { answer.unit.pretty() } else { check::example(answer) },
    })
}

fn verdicts(solved: &SolvedProblem<'_>, typed: &Map<String, Json>, locale: &Locale) -> Vec<Json> {
    let Ok(solution) = &solved.outcome else { return Vec::new() };
    let locale = &locale.at(solved.problem.file.entry.about.id);
    let text = |(name, text): (&String, &Json)| Some((name.clone(), text.as_str()?.trim().to_owned()));
    let typed: Vec<(String, String)> =
        typed.iter().filter_map(text).filter(|(_, text)| !text.is_empty()).collect();
    let entry = solved.problem.file.entry;
    let causes = check::causes(entry, &solved.record, solution, &typed, &Stop::new(), None);
    let verdict = |checked: &CheckedAnswer| {
        let mut verdict = checked.json(solution, locale);
        verdict["lines"] = checked.lines(solution, false, locale).into();
        verdict
    };
    checked_answers(solution, &typed, &causes).iter().map(verdict).collect()
}
