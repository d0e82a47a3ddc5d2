//! `dalembert serve --stdio`: JSON lines in and out, a request a line.
//!
//! `{"id": 1, "solve": {…}}` is answered by `{"id": 1, "result": {…}}`, or by `{"id": 1, "errors": [{"path", "message"}]}`
//! where it cannot be. Other requests are `report`, a solve with the `format` of a document; `new`, with the id and the
//! number of a case whose problem file is wanted; `list`, with words to search for; `show` and `schema`, with an id; and
//! `index`, the texts that a search compares. Whatever a line holds, the next one is read.

use std::{
    io::{self, BufRead, Read as _},
    process::ExitCode,
};

use dalembert_core::{Locale, Text, nearest};
use dalembert_report::errors_json;
use serde_json::{Map, Value as Json, json};

use crate::{
    commands::{list, new},
    console::Console,
    failure::Failure,
    request::{self, RequestFailure, RequestedProblem},
    solving,
};

/// The longest request, in bytes.
const LONGEST_LINE: usize = 16 << 20;

/// Kinds of requests.
const KINDS: [&str; 7] = ["solve", "report", "new", "list", "show", "schema", "index"];

/// Answers requests until the input ends.
pub(crate) fn run(console: &Console) -> Result<ExitCode, Failure> {
    match answer_all(&mut io::stdin().lock(), &mut io::stdout().lock(), &console.locale) {
        // The other program has left.
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(Failure::Output(error)),
        _ => Ok(ExitCode::SUCCESS),
    }
}

fn answer_all(requests: &mut dyn BufRead, replies: &mut dyn io::Write, locale: &Locale) -> io::Result<()> {
    while let Some(line) = read_line(requests)? {
        let reply = match line {
            Ok(line) if line.iter().all(u8::is_ascii_whitespace) => continue,
            Ok(line) => reply(&line, locale),
            Err(why) => failed(&Json::Null, &Failure::input(why), locale),
        };
        writeln!(replies, "{reply}")?;
        replies.flush()?;
    }
    Ok(())
}

/// The next line, or why it is not read; `None` at the end of the input.
fn read_line(requests: &mut dyn BufRead) -> io::Result<Option<Result<Vec<u8>, Text>>> {
    let mut line = Vec::new();
    (&mut *requests).take(LONGEST_LINE as u64 + 1).read_until(b'\n', &mut line)?;
    if line.len() <= LONGEST_LINE {
        return Ok(Some(line).filter(|line| !line.is_empty()).map(Ok));
    }
    while line.last() != Some(&b'\n') {
        line.clear();
        if (&mut *requests).take(LONGEST_LINE as u64).read_until(b'\n', &mut line)? == 0 {
            break;
        }
    }
    let why = Text::new("this request is longer than {most} MiB; send less in one line");
    Ok(Some(Err(why.with("most", LONGEST_LINE >> 20))))
}

/// The reply to a request.
fn reply(line: &[u8], locale: &Locale) -> Json {
    let request: Map<String, Json> = match serde_json::from_slice(line) {
        Ok(request) => request,
        Err(error) => {
            let why = Text::new("this line is no JSON object: {why}").with("why", error);
            return failed(&Json::Null, &Failure::input(why), locale);
        }
    };
    let id = request.get("id").cloned().unwrap_or_default();
    match solving::contained("this request", || answer(&request, locale)) {
        Ok(Ok(result)) => json!({ "id": id, "result": result }),
        Ok(Err(errors)) => with_id(&id, errors),
        Err(fault) => failed(&id, &fault, locale),
    }
}

fn answer(request: &Map<String, Json>, locale: &Locale) -> Result<Json, Json> {
    let errors = |failure: RequestFailure| errors_json(&failure.errors);
    let asked: Vec<(&str, &Json)> =
        request.iter().filter(|(key, _)| *key != "id").map(|(key, value)| (key.as_str(), value)).collect();
    match asked[..] {
        [("solve", Json::Object(problem))] => {
            let problem = RequestedProblem::read(problem, locale.language).map_err(errors)?;
            Ok(problem.solve().map_err(errors)?.json())
        }
        [("report", Json::Object(problem))] => request::reported(problem, locale.language).map_err(errors),
        [("new", Json::Object(of))] => {
            let case = of.get("case").and_then(Json::as_u64).map(|case| case as u32);
            let id = of.get("problem").and_then(Json::as_str).unwrap_or_default();
            new::text(id, case, locale).map(Json::String).map_err(|failure| failure.json(locale))
        }
        [("index", _)] => Ok(list::index()),
        [("list", words)] => Ok(list::json(&words_of(words), locale)),
        [("show", Json::String(id))] => request::described(id, locale.language).map_err(errors),
        [("schema", Json::String(id))] => request::schema_of(id, locale.language).map_err(errors),
        _ => Err(Failure::input(misunderstood(&asked)).json(locale)),
    }
}

/// The words of a search: one text or several.
fn words_of(words: &Json) -> Vec<String> {
    let texts = |all: &[Json]| all.iter().filter_map(Json::as_str).map(str::to_owned).collect();
    match words {
        Json::Array(all) => texts(all),
        one => texts(std::slice::from_ref(one)),
    }
}

fn misunderstood(asked: &[(&str, &Json)]) -> Text {
    let known = KINDS.join(", ");
    match asked {
        [(kind, _)] if KINDS.contains(kind) => Text::new(
            "write an object behind `solve`, `report` and `new`, and an id behind `show` and `schema`",
        ),
        [(kind, _)] => match nearest(kind, KINDS.into_iter()) {
            Some(near) => Text::new("there is no `{name}`; did you mean `{near}`?")
                .with("name", kind)
                .with("near", near),
            None => Text::new("there is no `{name}`; write one of {known}")
                .with("name", kind)
                .with("known", known),
        },
        _ => Text::new("a request has an `id` and one of {known}").with("known", known),
    }
}

fn failed(id: &Json, failure: &Failure, locale: &Locale) -> Json {
    with_id(id, failure.json(locale))
}

fn with_id(id: &Json, mut errors: Json) -> Json {
    json!({ "id": id, "errors": errors["errors"].take() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_that_is_too_long_is_skipped_and_named() {
        let mut input = vec![b'x'; 2 * LONGEST_LINE + 7];
        input.extend_from_slice(b"\n{\"id\": 7, \"show\": 3}\n");
        let mut replies = Vec::new();
        answer_all(&mut io::Cursor::new(input), &mut replies, &Locale::english()).unwrap();
        let replies: Vec<Json> = String::from_utf8(replies)
            .unwrap()
            .lines()
            .map(|line| serde_json::from_str(line).unwrap())
            .collect();
        assert_eq!(replies.len(), 2);
        assert_eq!((&replies[0]["id"], &replies[1]["id"]), (&Json::Null, &7.into()));
        let message = |reply: &Json| reply["errors"][0]["message"].as_str().unwrap_or_default().to_owned();
        assert!(message(&replies[0]).contains("longer than 16 MiB"), "{}", replies[0]);
        assert!(message(&replies[1]).contains("an id behind `show`"), "{}", replies[1]);
    }
}
