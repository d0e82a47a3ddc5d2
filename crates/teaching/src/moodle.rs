//! Moodle XML: a Cloze question for each variant, whose blanks are numbers with a tolerance.
//!
//! A blank is `{1:NUMERICAL:=19.456:0.097#…~%0%-19.456:0.097#…}`: the right value, then the value of each common error for
//! no points, with the sentence that names it. All blanks of a question belong to one set of data.

use dalembert_core::{Locale, Text};
use dalembert_report::{Block, Document, html_fragment};

use crate::{
    Exercise, ExportFile, Variant, base64,
    decimal::number,
    export::{Blank, blanks, escaped, svg},
    sheets::{question, title, worked_key},
};

/// Name of the drawing within a question.
const FIGURE: &str = "figure.svg";

/// Questions of the variants in a category of their own, in one file.
pub fn questions(
    exercise: &Exercise,
    variants: &[Variant],
    tolerance: f64,
    locale: &Locale,
) -> Vec<ExportFile> {
    let locale = &locale.at(exercise.entry.about.id);
    // A slash would make a category within a category.
    let category = exercise.heading().render(locale).replace('/', "//");
    let mut text = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<quiz>\n<question type=\"category\">\n<category>\
         <text>$course$/top/{}</text></category>\n</question>\n",
        escaped(&category)
    );
    for variant in variants {
        text += &cloze(exercise, variant, tolerance, locale);
    }
    text += "</quiz>\n";
    vec![ExportFile { path: "moodle.xml".to_owned(), text }]
}

fn cloze(exercise: &Exercise, variant: &Variant, tolerance: f64, locale: &Locale) -> String {
    let figure = svg(variant, locale);
    let blocks: Vec<Block> = question(exercise, variant, locale)
        .into_iter()
        .filter(|block| !matches!(block, Block::Figure(_)))
        .collect();
    // Braces of a statement are no blanks.
    let mut body = html_fragment(&Document { title: String::new(), blocks });
    body = without_style(&body).replace('{', "&#123;").replace('}', "&#125;");
    if figure.is_some() {
        body += &format!("<p><img src=\"@@PLUGINFILE@@/{FIGURE}\" alt=\"{}\"/></p>\n", escaped("figure"));
    }
    for blank in blanks(exercise, variant, tolerance, locale) {
        let unit = if blank.unit.is_empty() { String::new() } else { format!(" {}", escaped(&blank.unit)) };
        body += &format!("<p>{} = {}{unit}</p>\n", escaped(&blank.label), field(&blank, locale));
    }
    let file = figure.map_or_else(String::new, |svg| {
        let data = base64::encoded(svg.as_bytes());
        format!("<file name=\"{FIGURE}\" path=\"/\" encoding=\"base64\">{data}</file>\n")
    });
    let working = html_fragment(&worked_key(exercise, variant, locale));
    format!(
        "<question type=\"cloze\">\n<name><text>{}</text></name>\n<questiontext format=\"html\">\n<text>{}</text>\n{file}\
         </questiontext>\n<generalfeedback format=\"html\">\n<text>{}</text>\n</generalfeedback>\n<penalty>0.3333333</penalty>\n\
         <hidden>0</hidden>\n</question>\n",
        escaped(&title(exercise, variant, locale)),
        literal(&body),
        literal(&without_style(&working)),
    )
}

/// A blank as Cloze writes it.
fn field(blank: &Blank, locale: &Locale) -> String {
    let right = Text::from("Correct").render(locale);
    let mut text =
        format!("{{1:NUMERICAL:={}:{}#{}", number(blank.value), number(blank.within), feedback(&right));
    for (value, why) in &blank.errors {
        let within = number(blank.within_of(*value));
        text += &format!("~%0%{}:{within}#{}", number(*value), feedback(why));
    }
    text + "}"
}

/// A sentence within a blank: what separates its parts is written as entities, which Moodle reads back.
fn feedback(words: &str) -> String {
    let mut text = String::new();
    for character in escaped(words).chars() {
        match character {
            '~' | '}' | '{' | '\\' => text += &format!("&#{};", u32::from(character)),
            _ => text.push(character),
        }
    }
    text
}

/// A text of HTML within XML.
fn literal(html: &str) -> String {
    format!("<![CDATA[{}]]>", html.replace("]]>", "]]&gt;"))
}

/// HTML without its style sheet and its empty heading: the platform has its own.
fn without_style(html: &str) -> String {
    let html = html.replace("<h1></h1>\n", "");
    match (html.find("<style>"), html.find("</style>\n")) {
        (Some(from), Some(to)) if from < to => html[..from].to_owned() + &html[to + "</style>\n".len()..],
        _ => html,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_blank_is_written_as_cloze() {
        let blank = Blank {
            name: "amplitude".into(),
            label: "Amplitude".into(),
            unit: "mm".into(),
            value: 19.456,
            within: 0.09728,
            errors: vec![(-19.456, "sign error".into()), (38.912, "a ~ {b} \\ #c".into())],
        };
        assert_eq!(
            field(&blank, &Locale::english()),
            "{1:NUMERICAL:=19.456:0.09728#Correct~%0%-19.456:0.09728#sign error~%0%38.912:0.19456#a &#126; \
             &#123;b&#125; &#92; #c}"
        );
    }
}
