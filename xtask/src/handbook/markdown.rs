//! Documents in Markdown as bodies of pages: headings with anchors, formulas as MathML, links to where things stand in the
//! handbook.

use std::collections::BTreeSet;

use anyhow::{Result, ensure};
use pulldown_cmark::{CowStr, Event, HeadingLevel, LinkType, Options, Parser, Tag, TagEnd, html};
use pulldown_latex::{RenderConfig, Storage, config::DisplayMode, mathml::push_mathml};

use super::html::escaped;

/// A document as a part of a page.
pub(super) struct Body {
    /// Heading of the document.
    pub(super) title: String,
    /// Content.
    pub(super) html: String,
    /// Ids of analyses that the document names as code.
    pub(super) named: BTreeSet<String>,
}

/// The body of a document. `linked` gives the address of a link, or nothing for what is not in the handbook; `analysis` that
/// of an id.
///
/// # Errors
/// A formula that cannot be read.
pub(super) fn body(
    text: &str,
    linked: &dyn Fn(&str) -> Option<String>,
    analysis: &dyn Fn(&str) -> Option<String>,
) -> Result<Body> {
    let options = Options::ENABLE_TABLES | Options::ENABLE_MATH;
    let events: Vec<Event> = Parser::new_ext(text, options).collect();
    let (mut title, mut named, mut written) = (String::new(), BTreeSet::new(), Vec::new());
    let mut outside = Vec::new();
    let mut is_linked = false;
    for (n, event) in events.iter().enumerate() {
        match event {
            Event::Start(Tag::Heading { level, id: None, classes, attrs }) => {
                let words = words(&events[n + 1..]);
                if title.is_empty() && *level == HeadingLevel::H1 {
                    title.clone_from(&words);
                }
                let id = Some(CowStr::from(anchor(&words)));
                let (classes, attrs) = (classes.clone(), attrs.clone());
                written.push(Event::Start(Tag::Heading { level: *level, id, classes, attrs }));
            }
            Event::Start(Tag::Link { dest_url, title, id, .. }) => {
                let found =
                    if dest_url.contains("://") { Some(dest_url.to_string()) } else { linked(dest_url) };
                is_linked = found.is_some();
                outside.push(found.is_none());
                if let Some(address) = found {
                    written.push(Event::Start(Tag::Link {
                        link_type: LinkType::Inline,
                        dest_url: address.into(),
                        title: title.clone(),
                        id: id.clone(),
                    }));
                }
            }
            Event::End(TagEnd::Link) => {
                is_linked = false;
                if outside.pop() != Some(true) {
                    written.push(event.clone());
                }
            }
            Event::Code(words) => match analysis(words) {
                Some(address) if !is_linked => {
                    named.insert(words.to_string());
                    let link = format!("<a href=\"{address}\"><code>{}</code></a>", escaped(words));
                    written.push(Event::InlineHtml(link.into()));
                }
                _ => written.push(event.clone()),
            },
            Event::InlineMath(formula) => {
                written.push(Event::InlineHtml(mathml(formula, DisplayMode::Inline)?.into()));
            }
            Event::DisplayMath(formula) => {
                let formula = mathml(formula, DisplayMode::Block)?;
                written.push(Event::InlineHtml(format!("<span class=\"formula\">{formula}</span>").into()));
            }
            Event::Start(Tag::Table(_)) => {
                written.extend([Event::Html("<div class=\"wide\">".into()), event.clone()]);
            }
            Event::End(TagEnd::Table) => written.extend([event.clone(), Event::Html("</div>\n".into())]),
            other => written.push(other.clone()),
        }
    }
    let mut html = String::new();
    html::push_html(&mut html, written.into_iter());
    Ok(Body { title, html, named })
}

/// The words of a heading.
fn words(events: &[Event<'_>]) -> String {
    let inside = events.iter().take_while(|event| !matches!(event, Event::End(TagEnd::Heading(_))));
    let words = inside.filter_map(|event| match event {
        Event::Text(words) | Event::Code(words) => Some(words.as_ref()),
        _ => None,
    });
    words.collect()
}

/// The anchor of a heading, as GitHub and others make it.
pub(super) fn anchor(heading: &str) -> String {
    let words = heading.to_lowercase().replace(' ', "-");
    words.chars().filter(|c| c.is_alphanumeric() || *c == '-' || *c == '_').collect()
}

fn mathml(formula: &str, display_mode: DisplayMode) -> Result<String> {
    let storage = Storage::new();
    let mut text = String::new();
    let config = RenderConfig { display_mode, ..RenderConfig::default() };
    push_mathml(&mut text, pulldown_latex::Parser::new(formula, &storage), config)?;
    ensure!(!text.contains("<merror"), "the formula {formula} cannot be read");
    Ok(text)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn links_formulas_and_ids_lead_where_they_stand_in_the_handbook() {
        let text = "# Two planes\n\nSee [units](units.md#length), [code](../src/x.rs) and `balancing/two-plane`: $x^2$.\n\n\
                    | a |\n|---|\n| 1 |\n";
        let linked = |address: &str| address.strip_prefix("units.md").map(|rest| format!("units.html{rest}"));
        let analysis = |id: &str| (id == "balancing/two-plane").then(|| format!("{id}.html"));
        let body = body(text, &linked, &analysis).unwrap();
        assert_eq!(body.title, "Two planes");
        assert!(body.named.contains("balancing/two-plane"));
        for part in [
            "<h1 id=\"two-planes\">",
            "<a href=\"units.html#length\">units</a>, code and <a href=\"balancing/two-plane.html\"><code>",
            "<msup>",
            "<div class=\"wide\"><table>",
        ] {
            assert!(body.html.contains(part), "{part} in {}", body.html);
        }
        assert!(super::body("$\\nosuchcommand$", &linked, &analysis).is_err());
    }

    #[test]
    fn every_formula_of_the_theory_is_written() {
        let theory = crate::root().join("docs/theory");
        let mut formulas = 0;
        for entry in std::fs::read_dir(theory).unwrap() {
            let path = entry.unwrap().path();
            if path.extension().is_some_and(|extension| extension == "md") {
                let text = std::fs::read_to_string(&path).unwrap();
                let html = body(&text, &|_| None, &|_| None)
                    .unwrap_or_else(|error| panic!("{}: {error:#}", path.display()))
                    .html;
                formulas += html.matches("<math").count();
            }
        }
        assert!(formulas > 1000, "only {formulas} formulas");
    }
}
