//! The page with the list of all analyses, and what its search compares.

use serde_json::{Map, Value as Json, json};

use super::{
    html::{self, Frame, escaped, link},
    words::Words,
};
use crate::docs::{EXAMS, array, by_topic, text};

/// The analyses by family and topic, below the search.
pub(super) fn page(listed: &[Json], theory: &[(&str, &str)], words: &'static Words) -> String {
    let frame = Frame { path: "index.html", title: words.handbook, words, translated: true };
    let mut page = format!(
        "<h1>{}</h1>\n<p>{}</p>\n<ol id=\"results\"></ol>\n<p id=\"nothing\" hidden>{}</p>\n<div id=\"contents\">\n",
        words.handbook, words.about, words.nothing
    );
    let documents = html::documents("", words);
    let theory = html::each(theory, |(page, title)| {
        format!("<li>{}</li>\n", link(&format!("{documents}{page}"), title))
    });
    for (family, topics) in by_topic(listed) {
        let id =
            topics.first().and_then(|(_, entries)| entries.first()).map_or("", |entry| text(entry, "family"));
        page += &format!("<h2 id=\"{id}\">{}</h2>\n", escaped(family));
        for (topic, entries) in topics {
            if !topic.is_empty() && topic != family {
                page += &format!("<h3>{}</h3>\n", escaped(topic));
            }
            let items: String = entries.into_iter().map(item).collect();
            page += &format!("<ul class=\"analyses\">\n{items}</ul>\n");
        }
    }
    page += &format!("<h2>{}</h2>\n<ul>\n{theory}</ul>\n</div>\n", words.theory);
    frame.page(&page)
}

fn item(entry: &Json) -> String {
    let [id, title, summary] = ["id", "title", "summary"].map(|key| text(entry, key));
    let about = if text(entry, "family") == EXAMS { "" } else { summary };
    format!("<li>{}<br>{}</li>\n", link(&format!("{id}.html"), title), escaped(about))
}

/// The texts that the search compares and what it shows of an analysis, as a script of two constants.
pub(super) fn search_index(index: &Json, listed: &[Json], cases: &[&[String]]) -> String {
    let titles = listed.iter().zip(cases).map(|(entry, cases)| {
        let about = if text(entry, "family") == EXAMS { "" } else { text(entry, "summary") };
        (
            text(entry, "id").to_owned(),
            json!({ "title": text(entry, "title"), "summary": about, "cases": cases }),
        )
    });
    let titles: Map<String, Json> = titles.collect();
    debug_assert_eq!(array(&index["analyses"]).len(), titles.len(), "the index is of what is listed");
    format!("const SEARCH_INDEX = {index};\nconst SEARCH_TITLES = {};\n", Json::Object(titles))
}
