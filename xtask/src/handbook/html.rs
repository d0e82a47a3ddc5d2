//! Frame of a page: head, links to the other pages, search, and the parts that pages are made of.

use super::words::Words;
pub(super) use crate::docs::escaped;

/// Frame of a page.
pub(super) struct Frame<'f> {
    /// Path from the folder of the language.
    pub(super) path: &'f str,
    pub(super) title: &'f str,
    pub(super) words: &'static Words,
    /// The page stands in the other language too.
    pub(super) translated: bool,
}

impl Frame<'_> {
    /// Way from the page to the folder of its language: `../` for each folder that it lies in.
    pub(super) fn up(&self) -> String {
        up(self.path)
    }

    /// The page with this content.
    pub(super) fn page(&self, content: &str) -> String {
        let Frame { path, title, words, translated } = self;
        let up = self.up();
        let documents = documents(&up, words);
        let other = Words::ALL.into_iter().filter(|other| other.language != words.language).map(|other| {
            let page = if *translated { path } else { "index.html" };
            let (language, name) = (other.language, other.name);
            format!("<a lang=\"{language}\" href=\"{up}../{language}/{page}\">{name}</a>")
        });
        let links = [
            (format!("{documents}guide.html"), words.guide),
            (format!("{documents}problem-files.html"), words.problem_files),
            (format!("{documents}units.html"), words.units),
            (format!("{documents}glossary.html"), words.glossary),
        ];
        let links = links.iter().map(|(address, name)| link(address, name)).chain(other);
        let links = links.collect::<Vec<_>>().join("\n");
        let index = if *path == "index.html" { "<script src=\"search-index.js\"></script>\n" } else { "" };
        format!(
            "<!DOCTYPE html>\n<html lang=\"{language}\">\n<head>\n<meta charset=\"utf-8\">\n\
             <meta name=\"viewport\" content=\"width=device-width\">\n<title>{title} · d’Alembert</title>\n\
             <link rel=\"stylesheet\" href=\"{up}style.css\">\n</head>\n<body>\n<header>\n\
             <a class=\"home\" href=\"{up}index.html\">{handbook}</a>\n\
             <form class=\"search\" action=\"{up}index.html\" hidden>\
             <input type=\"search\" name=\"q\" placeholder=\"{search}\" aria-label=\"{search}\"></form>\n\
             <nav>\n{links}\n</nav>\n</header>\n<main>\n{content}</main>\n{index}\
             <script src=\"{up}search.js\"></script>\n</body>\n</html>\n",
            language = words.language,
            title = escaped(title),
            handbook = words.handbook,
            search = words.search,
        )
    }
}

/// Way from a page to the folder of its language.
pub(super) fn up(path: &str) -> String {
    "../".repeat(path.matches('/').count())
}

/// Way to the documents, which are written in one language.
pub(super) fn documents(up: &str, words: &Words) -> String {
    if words.has_documents { up.to_owned() } else { format!("{up}../en/") }
}

/// The page above the languages.
pub(super) fn languages() -> String {
    let links = Words::ALL.map(|words| {
        let (language, handbook, about) = (words.language, words.handbook, words.about);
        format!("<li lang=\"{language}\"><a href=\"{language}/index.html\">{handbook}</a><br>{about}</li>\n")
    });
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width\">\n<title>d’Alembert</title>\n\
         <link rel=\"stylesheet\" href=\"en/style.css\">\n</head>\n<body>\n<main>\n<h1>d’Alembert</h1>\n<ul>\n{}</ul>\n\
         </main>\n</body>\n</html>\n",
        links.concat()
    )
}

/// A link.
pub(super) fn link(address: &str, words: &str) -> String {
    format!("<a href=\"{address}\">{}</a>", escaped(words))
}

/// A heading and what stands under it; nothing where there is nothing.
pub(super) fn section(heading: &str, content: &str) -> String {
    if content.is_empty() { String::new() } else { format!("<h2>{heading}</h2>\n{content}") }
}

/// A table that scrolls in its own box where it is wider than the page. Cells are HTML.
pub(super) fn table(headings: &[&str], rows: &[Vec<String>]) -> String {
    if rows.is_empty() {
        return String::new();
    }
    let headings = each(headings, |heading| format!("<th>{heading}</th>"));
    let row = |cells: &Vec<String>| {
        let cells = each(cells, |cell| format!("<td>{cell}</td>"));
        format!("<tr>{cells}</tr>\n")
    };
    let rows = each(rows, row);
    format!(
        "<div class=\"wide\"><table>\n<thead><tr>{headings}</tr></thead>\n<tbody>\n{rows}</tbody>\n</table></div>\n"
    )
}

/// Texts of the items, one after the other.
pub(super) fn each<T>(items: &[T], write: impl Fn(&T) -> String) -> String {
    items.iter().map(write).collect::<Vec<_>>().concat()
}

/// Paragraphs of a text; nothing for none.
pub(super) fn paragraph(class: &str, text: &str) -> String {
    if text.is_empty() { String::new() } else { format!("<p class=\"{class}\">{}</p>\n", escaped(text)) }
}

/// Code.
pub(super) fn code(text: &str) -> String {
    format!("<code>{}</code>", escaped(text))
}
