//! The pages of an analysis: one that describes it, and one for each case with its worked solution and problem file.

use serde_json::Value as Json;

use super::{
    Files,
    html::{self, Frame, code, escaped, link, paragraph, section, table},
    inputs,
    words::Words,
};
use crate::docs::{EXAMS, array, text};

/// Number of figures on the page of an analysis; those of a case stand on its own page.
const FIGURES: usize = 2;

/// A case of an analysis.
pub(super) struct Case<'c> {
    /// Description, as `show` has it.
    pub(super) shown: &'c Json,
    /// Comparisons with its reference values, as `verify` has them.
    pub(super) comparisons: Vec<&'c Json>,
    /// Worked solution, a part of a page.
    pub(super) report: String,
    /// The problem solved, as `solve` has it.
    pub(super) solved: Json,
    /// Problem file.
    pub(super) file: String,
}

/// The pages and problem files of an analysis.
pub(super) fn of_analysis(
    shown: &Json,
    figures: &[Json],
    cases: &[Case<'_>],
    theory: &[(&str, &str)],
    solves: bool,
    words: &'static Words,
) -> Files {
    let id = text(shown, "id");
    let path = format!("{id}.html");
    let frame = Frame { path: &path, title: text(shown, "title"), words, translated: true };
    let mut files = vec![(path.clone(), frame.page(&described(shown, figures, cases, theory, &frame)))];
    for (n, case) in cases.iter().enumerate() {
        let path = of_case(id, n + 1);
        let title = format!("{}: {}", text(shown, "title"), text(case.shown, "title"));
        let frame = Frame { path: &path, title: &title, words, translated: true };
        files.push((path.clone(), frame.page(&solved(shown, case, n + 1, cases.len(), solves, words))));
        files.push((format!("{id}/{}.toml", n + 1), case.file.clone()));
    }
    files
}

/// Path of the page of a case, counted from 1.
pub(super) fn of_case(id: &str, number: usize) -> String {
    format!("{id}/{number}.html")
}

/// Content of the page that describes an analysis.
fn described(
    shown: &Json,
    figures: &[Json],
    cases: &[Case<'_>],
    theory: &[(&str, &str)],
    frame: &Frame<'_>,
) -> String {
    let words = frame.words;
    let [id, title, summary] = ["id", "title", "summary"].map(|key| text(shown, key));
    let is_exam = text(shown, "family") == EXAMS;
    let mut page = crumbs(shown, &frame.up());
    page += &format!("<h1>{}</h1>\n<p>{}</p>\n", escaped(title), code(id));
    page += &paragraph("summary", if is_exam { "" } else { summary });
    // An SVG is written by the program, and is HTML as it is.
    let figure = |figure: &Json| {
        let (svg, title) = (text(figure, "svg"), escaped(text(figure, "title")));
        format!("<figure>\n{svg}<figcaption>{title}</figcaption>\n</figure>\n")
    };
    let figures: String = figures.iter().take(FIGURES).map(figure).collect();
    page += &format!("<div class=\"figures\">\n{figures}</div>\n");
    if !is_exam {
        let headings = [words.input, words.symbol, words.meaning, words.values];
        page += &section(words.inputs, &table(&headings, &inputs::rows(&shown["inputs"], words)));
        let answer =
            |answer: &Json| vec![code(text(answer, "name")), cell(answer, "label"), cell(answer, "unit")];
        let answers: Vec<_> = array(&shown["answers"]).iter().map(answer).collect();
        page += &section(words.answers, &table(&[words.answer, words.meaning, words.unit], &answers));
    }
    let stem = id.rsplit('/').next().unwrap_or(id);
    let summary = |(n, case): (usize, &Case<'_>)| summarised(stem, n + 1, case, words);
    page += &section(words.cases, &cases.iter().enumerate().map(summary).collect::<String>());
    let question = |of: &Json| {
        vec![code(text(of, "key")), cell(of, "label"), code(text(of, "formula")), cell(of, "unit")]
    };
    let questions: Vec<_> = array(&shown["questions"]).iter().map(question).collect();
    let headings = [words.answer, words.meaning, words.formula, words.unit];
    page += &section(words.questions, &table(&headings, &questions));
    let documents = html::documents(&frame.up(), words);
    let theory: Vec<String> =
        theory.iter().map(|(page, title)| link(&format!("{documents}{page}"), title)).collect();
    page += &section(words.theory, &items(&theory));
    let source = |source: &Json| format!("{}: {}", cell(source, "short"), cell(source, "full"));
    page += &section(words.sources, &items(&array(&shown["sources"]).iter().map(source).collect::<Vec<_>>()));
    page + &section(words.keywords, &paragraph("keywords", text(shown, "keywords")))
}

/// A case on the page of its analysis.
fn summarised(stem: &str, number: usize, case: &Case<'_>, words: &Words) -> String {
    let Case { shown, comparisons, .. } = case;
    let title = link(&format!("{stem}/{number}.html"), text(shown, "title"));
    let mut part = format!("<h3 id=\"{number}\">{number}. {title}</h3>\n{}", origin(shown));
    part += &paragraph("statement", text(shown, "statement"));
    part += &paragraph("note", text(shown, "note"));
    part += &paragraph("", text(shown, "refused"));
    if !comparisons.is_empty() {
        let counts = ["agreed", "disputed", "differing"].into_iter().filter_map(|verdict| {
            let count = comparisons.iter().filter(|row| text(row, "verdict") == verdict).count();
            (count > 0).then(|| format!("{count} {}", words.verdict_of(verdict)))
        });
        let counts = counts.collect::<Vec<_>>().join(", ");
        part += &format!(
            "<details><summary>{counts}</summary>\n{}</details>\n",
            compared(comparisons, shown, words)
        );
    }
    let file = format!("{stem}/{number}.toml");
    part + &format!(
        "<p class=\"links\">{} · <a href=\"{file}\" download>{}</a></p>\n",
        link(&format!("{stem}/{number}.html"), words.worked),
        words.file
    )
}

/// Source of a case, and its kind.
fn origin(shown: &Json) -> String {
    let seen = match text(shown, "seen_in") {
        "" => String::new(),
        seen => format!(", {seen}"),
    };
    paragraph("source", &format!("{} ({}{seen})", text(shown, "source"), text(shown, "truth_name")))
}

/// Table of the reference values of a case.
fn compared(comparisons: &[&Json], shown: &Json, words: &Words) -> String {
    let row = |row: &&Json| {
        let verdict = text(row, "verdict");
        let why = match text(&shown["expect"][text(row, "answer")], "why") {
            "" => text(row, "why"),
            why => why,
        };
        let word = words.verdict_of(verdict);
        let verdict = if why.is_empty() {
            format!("<span class=\"{verdict}\">{word}</span>")
        } else {
            format!("<span class=\"{verdict}\">{word}</span>: {}", escaped(why))
        };
        vec![code(text(row, "answer")), cell(row, "printed"), cell(row, "ours"), verdict]
    };
    let rows: Vec<_> = comparisons.iter().map(row).collect();
    table(&[words.answer, words.printed, words.computed, words.verdict], &rows)
}

/// Content of the page of a case.
fn solved(shown: &Json, case: &Case<'_>, number: usize, count: usize, solves: bool, words: &Words) -> String {
    let id = text(shown, "id");
    let mut page = crumbs(shown, "../../");
    let others = [
        (number > 1).then(|| link(&format!("{}.html", number - 1), words.previous)),
        Some(link(&format!("../{}.html", id.rsplit('/').next().unwrap_or(id)), text(shown, "title"))),
        (number < count).then(|| link(&format!("{}.html", number + 1), words.next)),
    ];
    let others = others.into_iter().flatten().collect::<Vec<_>>().join(" · ");
    page += &format!("<p class=\"links\">{others}</p>\n");
    page += &format!(
        "<p>{} {number}/{count}. <a href=\"{number}.toml\" download>{}</a></p>\n",
        words.case, words.file
    );
    page += &format!(
        "<details><summary>{}</summary>\n<pre id=\"problem-file\">{}</pre>\n</details>\n",
        words.file_text,
        escaped(&case.file)
    );
    if solves {
        page += "<section id=\"solve\" data-up=\"../../\" hidden></section>\n";
    }
    page += &format!("<div id=\"worked\">\n{}</div>\n", case.report);
    page += &section(words.common_errors, &common_errors(&case.solved, words));
    page += &section(words.comparisons, &compared(&case.comparisons, case.shown, words));
    if solves { page + "<script src=\"../../solve.js\"></script>\n" } else { page }
}

/// Table of the errors that people commonly make in the steps of a solved problem, with what each gives.
fn common_errors(solved: &Json, words: &Words) -> String {
    let rows: Vec<_> = array(&solved["steps"])
        .iter()
        .flat_map(|step| array(&step["common_errors"]).iter().map(move |error| (step, error)))
        .map(|(step, error)| {
            vec![cell(step, "symbol"), cell(step, "result"), cell(error, "result"), cell(error, "what")]
        })
        .collect();
    table(&[words.symbol, words.computed, words.instead, words.error], &rows)
}

/// Family and topic, with links to them in the contents.
fn crumbs(shown: &Json, up: &str) -> String {
    let [family, name, topic] = ["family", "family_name", "topic"].map(|key| text(shown, key));
    let family_link = link(&format!("{up}index.html#{family}"), name);
    let topic =
        if topic.is_empty() || topic == name { String::new() } else { format!(" › {}", escaped(topic)) };
    format!("<p class=\"crumbs\">{family_link}{topic}</p>\n")
}

fn cell(json: &Json, key: &str) -> String {
    escaped(text(json, key))
}

/// A list of what is HTML.
fn items(items: &[String]) -> String {
    if items.is_empty() {
        return String::new();
    }
    let items = html::each(items, |item| format!("<li>{item}</li>\n"));
    format!("<ul>\n{items}</ul>\n")
}
