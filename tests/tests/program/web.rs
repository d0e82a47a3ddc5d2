//! The page that solves: text in, JSON out, as `crates/web` gives it to JavaScript.

use dalembert::request::RequestedProblem;
use dalembert_core::{Entry, Language, Locale, cases, catalogue, file, find};
use dalembert_plugins as _;
use dalembert_testkit::on_all_cores;
use serde_json::{Map, Value as Json, json};

const FAN: &str = "vibration/rotating-unbalance";

/// One problem in so many is taken of all: the handbook compares each of them in a browser.
const ONE_IN: usize = 5;

/// The problem file of a published case, counted from 1.
fn published(id: &str, number: usize, locale: &Locale) -> String {
    let entry = find(id).expect("the analysis is there");
    let cases = cases::cases(entry).expect("cases are right");
    file::template(entry, cases.get(number - 1), locale)
}

/// Some of the problems, of every family and exams among them.
fn some() -> Vec<&'static Entry> {
    catalogue().iter().step_by(ONE_IN).copied().collect()
}

fn fan() -> String {
    published(FAN, 1, &Locale::english())
}

fn read(text: &str) -> Json {
    serde_json::from_str(text).expect("a page is given JSON")
}

fn opened(file: &str) -> Json {
    read(&dalembert_web::opened(file, "en"))
}

fn changed(page: &Json, change: &Json) -> Json {
    let file = page["file"].as_str().expect("a page has its file");
    read(&dalembert_web::changed(file, &change.to_string(), "en"))
}

fn line<'p>(page: &'p Json, path: &str) -> &'p Json {
    let lines = page["form"].as_array().expect("a page has a form");
    lines.iter().find(|line| line["path"] == path).unwrap_or_else(|| panic!("no line {path}"))
}

fn texts<'p>(all: &'p Json, key: &'p str) -> impl Iterator<Item = &'p str> {
    all.as_array().into_iter().flatten().filter_map(move |one| one[key].as_str())
}

#[test]
fn a_page_computes_what_another_program_is_given() {
    on_all_cores(&some(), |_, entry| {
        for language in [Language::English, Language::Portuguese] {
            let text = published(entry.about.id, 1, &Locale::of(language));
            let Json::Object(request) = json!({ "problem_file": text }) else { panic!("an object") };
            let given = match RequestedProblem::read(&request, language).and_then(RequestedProblem::solve) {
                Ok(solved) => solved.json().to_string(),
                Err(failure) => panic!("{}: {:?}", entry.about.id, failure.errors),
            };
            assert!(dalembert_web::solved(&text, language.tag()) == given, "{}", entry.about.id);
        }
    });
}

#[test]
fn the_form_of_every_problem_writes_the_problem_again() {
    on_all_cores(&some(), |_, entry| {
        let text = published(entry.about.id, 1, &Locale::english());
        let page = opened(&text);
        assert_eq!(page["errors"], json!([]), "{}", entry.about.id);
        let before: Json = read(&dalembert_web::solved(&text, "en"));
        // The last text that can be typed, as it is: with its own text nothing is changed.
        let typed = page["form"].as_array().expect("a form");
        let typed = typed.iter().rev().find(|line| line["role"] == "text" && line["text"] != "");
        let Some(typed) = typed else { return };
        let change = json!({ "do": "write", "path": typed["path"], "text": typed["text"] });
        let page = changed(&page, &change);
        let file = page["file"].as_str().expect("the change is made");
        let after: Json = read(&dalembert_web::solved(file, "en"));
        assert_eq!(after["answers"], before["answers"], "{}: {change}", entry.about.id);
    });
}

#[test]
fn wrong_inputs_are_named_with_value_and_repair() {
    let page = opened(&fan());
    let wrong = |path: &str, text: &str| {
        let page = changed(&page, &json!({ "do": "write", "path": path, "text": text }));
        assert_eq!(page["html"], Json::Null, "{path} = {text}");
        assert_eq!(page["answers"], json!([]));
        let error = &line(&page, path)["error"];
        (error["message"].as_str().unwrap_or_default().to_owned(), error["repairs"].clone())
    };
    let (message, repairs) = wrong("mass", "40 kgg");
    assert!(message.contains("mass = 40 kgg") && message.contains("kg"), "{message}");
    assert_eq!(repairs, json!(["40 kg"]));
    let (message, _) = wrong("mass", "3 m");
    assert!(message.contains("mass = 3 m"), "{message}");
    let (message, _) = wrong("mass", "-3 kg");
    assert!(message.contains("must be above zero; you wrote -3 kg"), "{message}");
    let (message, _) = wrong("speed", "");
    assert!(message.contains("speed") && !message.is_empty(), "{message}");
    let error =
        read(&dalembert_web::opened("format = 2\nanalysis = \"vibration/rotating-unbalence\"\n", "en"));
    let message = error["errors"][0]["message"].as_str().expect("an error");
    assert!(message.contains("rotating-unbalance"), "{message}");
    assert_eq!(error["errors"][0]["line"], 2);
}

#[test]
fn a_number_alone_keeps_its_unit_in_the_language_of_the_page() {
    let text = published(FAN, 1, &Locale::portuguese());
    let change = json!({ "do": "write", "path": "mass", "text": "41,5" });
    let page = read(&dalembert_web::changed(&text, &change.to_string(), "pt-BR"));
    assert_eq!(line(&page, "mass")["text"], "41,5 kg");
    assert!(page["file"].as_str().expect("a file").contains("mass = \"41.5 kg\""));
}

#[test]
fn alternatives_keep_what_they_have_in_common() {
    let page = opened(&fan());
    let choice = line(&page, "damping");
    assert!(texts(&choice["alternatives"], "name").any(|name| name == "coefficient"), "{choice}");
    let page = changed(&page, &json!({ "do": "choose", "path": "damping", "text": "coefficient" }));
    assert_eq!(line(&page, "damping")["text"], "coefficient");
    let coefficient = line(&page, "damping.coefficient.coefficient");
    assert!(coefficient["error"]["message"].is_string(), "{coefficient}");
    let change = json!({ "do": "write", "path": "damping.coefficient.coefficient", "text": "300" });
    let page = changed(&page, &change);
    assert_eq!(page["errors"], json!([]));
    assert_eq!(line(&page, "damping.coefficient.coefficient")["text"], "300 N*s/m");
    let error = changed(&page, &json!({ "do": "choose", "path": "damping", "text": "coeficient" }));
    let message = error["errors"][0]["message"].as_str().expect("an error");
    assert!(message.contains("did you mean `coefficient`"), "{message}");
}

#[test]
fn rows_are_added_and_taken_out() {
    let page = opened(&fan());
    let page = changed(&page, &json!({ "do": "add", "path": "ask" }));
    let page = changed(&page, &json!({ "do": "write", "path": "ask[1].name", "text": "twice" }));
    let page = changed(&page, &json!({ "do": "write", "path": "ask[1].formula", "text": "2*amplitude" }));
    assert!(texts(&page["answers"], "name").any(|name| name == "twice"), "{}", page["answers"]);
    let page = changed(&page, &json!({ "do": "take-out", "path": "ask", "row": 1 }));
    assert!(texts(&page["answers"], "name").all(|name| name != "twice"), "{}", page["answers"]);
    let error = changed(&page, &json!({ "do": "take-out", "path": "ask", "row": 1 }));
    assert_eq!(error["errors"][0]["path"], "ask");
}

#[test]
fn own_answers_are_checked_as_on_the_command_line() {
    let checked = |typed: &str| {
        let typed: Map<String, Json> = [("stiffness".to_owned(), typed.into())].into_iter().collect();
        let reply = dalembert_web::checked(&fan(), &Json::Object(typed).to_string(), "en");
        read(&reply)["answers"][0].clone()
    };
    // 3 E I/L³ of the cantilever: 200 kN/mm², 1.3·10⁻⁶ m⁴, 1.2 m.
    assert_eq!(checked("451.39 kN/m")["verdict"], "correct");
    let wrong = checked("150.46 kN/m");
    assert_eq!(wrong["verdict"], "incorrect");
    let cause = wrong["causes"][0]["text"].as_str().expect("a cause");
    assert!(cause.contains("the factor 3 omitted"), "{wrong}");
    let lines: Vec<&str> = wrong["lines"].as_array().into_iter().flatten().filter_map(Json::as_str).collect();
    assert_eq!(lines[0], "stiffness = 150.46 kN/m: incorrect");
    assert!(lines[2].trim() == cause, "{lines:?}");
    assert_eq!(checked("far")["verdict"], "unreadable");
}

#[test]
fn a_refusal_is_shown_with_its_reason() {
    let page = opened(&fan());
    let page = changed(&page, &json!({ "do": "choose", "path": "damping", "text": "between" }));
    let page = changed(&page, &json!({ "do": "write", "path": "damping.between.least", "text": "0.3" }));
    let page = changed(&page, &json!({ "do": "write", "path": "damping.between.most", "text": "0.1" }));
    let refusal = page["refusal"].as_str().expect("a refusal");
    assert!(refusal.contains("exchange them"), "{refusal}");
    assert!(page["html"].as_str().expect("a page").contains("exchange them"));
}
