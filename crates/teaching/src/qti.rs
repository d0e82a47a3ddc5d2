//! QTI 2.1: a content package with an item for each variant, whose interactions are numbers with a tolerance.
//!
//! IMS Question and Test Interoperability, *Assessment Test, Section and Item Information Model*, version 2.1 (2012), and
//! IMS Content Packaging 1.1.

use dalembert_core::{Locale, Text};
use dalembert_report::Block;

use crate::{
    Exercise, ExportFile, Variant,
    decimal::number,
    export::{Blank, blanks, escaped, identifier, svg},
    sheets::{question, title},
};

const QTI: &str = "http://www.imsglobal.org/xsd/imsqti_v2p1";
const PACKAGE: &str = "http://www.imsglobal.org/xsd/imscp_v1p1";
const INSTANCE: &str = "http://www.w3.org/2001/XMLSchema-instance";

/// Files of a package: the manifest, the items and their drawings.
pub fn package(
    exercise: &Exercise,
    variants: &[Variant],
    tolerance: f64,
    locale: &Locale,
) -> Vec<ExportFile> {
    let locale = &locale.at(exercise.entry.about.id);
    let (mut files, mut resources) = (Vec::new(), String::new());
    for variant in variants {
        let id = format!("item-{}", identifier(&variant.label));
        let item = format!("items/{id}.xml");
        let figure = svg(variant, locale).map(|text| ExportFile { path: format!("items/{id}.svg"), text });
        let picture =
            figure.as_ref().map_or_else(String::new, |file| format!("<file href=\"{}\"/>", file.path));
        resources += &format!(
            "<resource identifier=\"{id}\" type=\"imsqti_item_xmlv2p1\" href=\"{item}\"><file href=\"{item}\"/>{picture}\
             </resource>\n"
        );
        let name = figure.as_ref().map(|_| format!("{id}.svg"));
        files.push(ExportFile {
            path: item,
            text: self::item(exercise, variant, (&id, name.as_deref()), tolerance, locale),
        });
        files.extend(figure);
    }
    let id = identifier(exercise.entry.about.id);
    let manifest = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<manifest xmlns=\"{PACKAGE}\" xmlns:xsi=\"{INSTANCE}\" \
         xsi:schemaLocation=\"{PACKAGE} {PACKAGE}.xsd\" identifier=\"{id}\">\n<metadata>\n<schema>QTIv2.1 Package</schema>\n\
         <schemaversion>1.0.0</schemaversion>\n</metadata>\n<organizations/>\n<resources>\n{resources}</resources>\n\
         </manifest>\n"
    );
    files.insert(0, ExportFile { path: "imsmanifest.xml".to_owned(), text: manifest });
    files
}

fn item(
    exercise: &Exercise,
    variant: &Variant,
    (id, figure): (&str, Option<&str>),
    tolerance: f64,
    locale: &Locale,
) -> String {
    let blanks = blanks(exercise, variant, tolerance, locale);
    let (mut declarations, mut outcomes, mut fields) = (String::new(), String::new(), String::new());
    let (mut processing, mut feedback) = (String::new(), String::new());
    for (n, blank) in blanks.iter().enumerate() {
        let n = n + 1;
        declarations += &format!(
            "<responseDeclaration identifier=\"RESPONSE_{n}\" cardinality=\"single\" baseType=\"float\">\n\
             <correctResponse><value>{}</value></correctResponse>\n</responseDeclaration>\n",
            number(blank.value)
        );
        outcomes += &format!(
            "<outcomeDeclaration identifier=\"FEEDBACK_{n}\" cardinality=\"single\" baseType=\"identifier\"/>\n"
        );
        let unit = if blank.unit.is_empty() { String::new() } else { format!(" {}", escaped(&blank.unit)) };
        fields += &format!(
            "<p>{} = <textEntryInteraction responseIdentifier=\"RESPONSE_{n}\" expectedLength=\"12\"/>{unit}</p>\n",
            escaped(&blank.label)
        );
        processing += &condition(n, blank);
        feedback += &sentences(n, blank, locale);
    }
    let figure = figure.map_or_else(String::new, |name| {
        format!("<p><img src=\"{name}\" alt=\"{}\"/></p>\n", escaped("figure"))
    });
    let language = locale.language.tag();
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<assessmentItem xmlns=\"{QTI}\" xmlns:xsi=\"{INSTANCE}\" \
         xsi:schemaLocation=\"{QTI} {QTI}.xsd\" identifier=\"{id}\" title=\"{}\" xml:lang=\"{language}\" \
         adaptive=\"false\" timeDependent=\"false\">\n{declarations}\
         <outcomeDeclaration identifier=\"SCORE\" cardinality=\"single\" baseType=\"float\" normalMaximum=\"{}\">\n\
         <defaultValue><value>0</value></defaultValue>\n</outcomeDeclaration>\n{outcomes}<itemBody>\n{}{figure}{fields}\
         </itemBody>\n<responseProcessing>\n{processing}</responseProcessing>\n{feedback}</assessmentItem>\n",
        escaped(&title(exercise, variant, locale)),
        blanks.len(),
        body(&question(exercise, variant, locale)),
    )
}

/// Text of a question in the elements that QTI has.
fn body(blocks: &[Block]) -> String {
    let mut text = String::new();
    for block in blocks {
        match block {
            Block::Paragraph(words) => text += &format!("<p>{}</p>\n", escaped(words)),
            Block::Heading(words) | Block::Subheading(words) => {
                text += &format!("<p><strong>{}</strong></p>\n", escaped(words));
            }
            Block::Lines(lines) => {
                let item = |line: &dalembert_report::NamedValue| {
                    let parts = [&line.label, &line.symbol, &line.value].map(|part| escaped(part));
                    let parts: Vec<String> = parts.into_iter().filter(|part| !part.is_empty()).collect();
                    format!("<li>{}</li>\n", parts.join(" "))
                };
                text += &format!("<ul>\n{}</ul>\n", lines.iter().map(item).collect::<String>());
            }
            _ => {}
        }
    }
    text
}

/// Comparison of a response with the right value and with those of common errors.
fn condition(n: usize, blank: &Blank) -> String {
    let equal = |value: f64, within: f64| {
        let within = number(within);
        format!(
            "<equal toleranceMode=\"absolute\" tolerance=\"{within} {within}\"><variable identifier=\"RESPONSE_{n}\"/>\
             <baseValue baseType=\"float\">{}</baseValue></equal>\n",
            number(value)
        )
    };
    let named = |at: usize| {
        format!(
            "<setOutcomeValue identifier=\"FEEDBACK_{n}\"><baseValue baseType=\"identifier\">F_{n}_{at}</baseValue>\
             </setOutcomeValue>\n"
        )
    };
    let mut text = format!(
        "<responseCondition>\n<responseIf>\n{}<setOutcomeValue identifier=\"SCORE\"><sum><variable identifier=\"SCORE\"/>\
         <baseValue baseType=\"float\">1</baseValue></sum></setOutcomeValue>\n{}</responseIf>\n",
        equal(blank.value, blank.within),
        named(0)
    );
    for (at, (value, _)) in blank.errors.iter().enumerate() {
        let (test, set) = (equal(*value, blank.within_of(*value)), named(at + 1));
        text += &format!("<responseElseIf>\n{test}{set}</responseElseIf>\n");
    }
    text + "</responseCondition>\n"
}

/// Sentences that are shown for a response.
fn sentences(n: usize, blank: &Blank, locale: &Locale) -> String {
    let right = Text::from("Correct").render(locale);
    let all = std::iter::once(&right).chain(blank.errors.iter().map(|(_, why)| why));
    all.enumerate()
        .map(|(at, words)| {
            format!(
                "<modalFeedback outcomeIdentifier=\"FEEDBACK_{n}\" identifier=\"F_{n}_{at}\" showHide=\"show\"><p>{}: {}\
                 </p></modalFeedback>\n",
                escaped(&blank.label),
                escaped(words)
            )
        })
        .collect::<Vec<_>>()
        .concat()
}
