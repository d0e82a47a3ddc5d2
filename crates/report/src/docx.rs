//! A document for Word: an Office Open XML package (ECMA-376) of few parts, with formulas as equations of Word, figures as
//! metafiles, and the problem file of a note as a custom XML part.

mod body;
mod omml;
mod read;

use std::io::{Cursor, Write as _};

use dalembert_core::{Locale, Text};
use zip::{CompressionMethod, DateTime, ZipWriter, write::SimpleFileOptions};

pub use self::read::{DocxNote, docx_differences};
use crate::{Document, DocumentFormat, NoteSource, PROGRAM, figure::emf::emf, xml::escaped};

/// Part with the text of the document.
const DOCUMENT: &str = "word/document.xml";
/// Part with the problem file of a note.
const SOURCE: &str = "customXml/item1.xml";
/// Namespace of the problem file.
const SOURCE_NAMESPACE: &str = "urn:dalembert:problem-file";

const CONTENT_TYPES: &str = r#"<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types"><Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/><Default Extension="xml" ContentType="application/xml"/><Default Extension="emf" ContentType="image/x-emf"/><Override PartName="/word/document.xml" ContentType="application/vnd.openxmlformats-officedocument.wordprocessingml.document.main+xml"/><Override PartName="/word/styles.xml" ContentType="application/vnd.openxmlformats-officedocument.wordprocessingml.styles+xml"/><Override PartName="/word/settings.xml" ContentType="application/vnd.openxmlformats-officedocument.wordprocessingml.settings+xml"/><Override PartName="/word/numbering.xml" ContentType="application/vnd.openxmlformats-officedocument.wordprocessingml.numbering+xml"/><Override PartName="/word/footer1.xml" ContentType="application/vnd.openxmlformats-officedocument.wordprocessingml.footer+xml"/><Override PartName="/customXml/itemProps1.xml" ContentType="application/vnd.openxmlformats-officedocument.customXmlProperties+xml"/><Override PartName="/docProps/core.xml" ContentType="application/vnd.openxmlformats-package.core-properties+xml"/></Types>"#;

const STYLES: &str = include_str!("docx/styles.xml");
const NUMBERING: &str = include_str!("docx/numbering.xml");

/// Begin of the types of relationships.
const TYPES: &str = "http://schemas.openxmlformats.org/officeDocument/2006/relationships";

/// The document as a file of Word, with its problem file.
///
/// # Errors
/// A package that cannot be written: it is too large.
pub fn docx(document: &Document, source: &NoteSource, locale: &Locale) -> Result<Vec<u8>, Text> {
    package(document, source, locale)
        .map_err(|error| Text::new("the document cannot be written: {why}").with("why", error))
}

fn package(
    document: &Document,
    source: &NoteSource,
    locale: &Locale,
) -> Result<Vec<u8>, zip::result::ZipError> {
    let language = locale.language.tag();
    let title = escaped(&document.title);
    let figures: Vec<Vec<u8>> = document.pictures().map(emf).collect();
    let mut parts: Vec<(String, Vec<u8>)> = Vec::new();
    let mut part = |name: &str, text: &str| {
        let xml = format!("<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\"?>\n{text}");
        parts.push((name.to_owned(), xml.into_bytes()));
    };
    part("[Content_Types].xml", CONTENT_TYPES);
    part(
        "_rels/.rels",
        &relationships(&[
            (format!("{TYPES}/officeDocument"), DOCUMENT.to_owned()),
            (
                "http://schemas.openxmlformats.org/package/2006/relationships/metadata/core-properties"
                    .to_owned(),
                "docProps/core.xml".to_owned(),
            ),
        ]),
    );
    part(
        "docProps/core.xml",
        &format!(
            "<cp:coreProperties xmlns:cp=\"http://schemas.openxmlformats.org/package/2006/metadata/core-properties\" \
             xmlns:dc=\"http://purl.org/dc/elements/1.1/\"><dc:title>{title}</dc:title>\
             <dc:language>{language}</dc:language></cp:coreProperties>"
        ),
    );
    part(DOCUMENT, &body::xml(document));
    let own =
        ["styles", "settings", "numbering"].map(|name| (format!("{TYPES}/{name}"), format!("{name}.xml")));
    let mut linked = own.to_vec();
    linked.push((format!("{TYPES}/footer"), "footer1.xml".to_owned()));
    linked.push((format!("{TYPES}/customXml"), format!("../{SOURCE}")));
    let media = (1..=figures.len()).map(|n| (format!("{TYPES}/image"), format!("media/figure{n}.emf")));
    linked.extend(media);
    part("word/_rels/document.xml.rels", &relationships(&linked));
    part("word/styles.xml", &STYLES.replace("LANGUAGE", language));
    part("word/numbering.xml", NUMBERING);
    part(
        "word/settings.xml",
        &format!(
            "<w:settings {}><w:compat><w:compatSetting w:name=\"compatibilityMode\" \
             w:uri=\"http://schemas.microsoft.com/office/word\" w:val=\"15\"/></w:compat><m:mathPr>\
             <m:mathFont m:val=\"Cambria Math\"/><m:brkBin m:val=\"before\"/><m:defJc m:val=\"left\"/></m:mathPr>\
             </w:settings>",
            body::NAMESPACES
        ),
    );
    part("word/footer1.xml", &footer());
    part(
        SOURCE,
        &format!(
            "<source xmlns=\"{SOURCE_NAMESPACE}\">{}</source>",
            source_text(source).lines().map(escaped).collect::<Vec<_>>().join("\n")
        ),
    );
    part(
        "customXml/itemProps1.xml",
        &format!(
            "<ds:datastoreItem ds:itemID=\"{{5B1C6C3E-4F0D-4E7B-9B1C-DA1E3BE27000}}\" \
             xmlns:ds=\"http://schemas.openxmlformats.org/officeDocument/2006/customXml\"><ds:schemaRefs>\
             <ds:schemaRef ds:uri=\"{SOURCE_NAMESPACE}\"/></ds:schemaRefs></ds:datastoreItem>"
        ),
    );
    part(
        "customXml/_rels/item1.xml.rels",
        &relationships(&[(format!("{TYPES}/customXmlProps"), "itemProps1.xml".to_owned())]),
    );
    parts.extend(figures.into_iter().zip(1..).map(|(emf, n)| (format!("word/media/figure{n}.emf"), emf)));
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    // The same document is the same bytes.
    let options = SimpleFileOptions::default()
        .compression_method(CompressionMethod::Deflated)
        .last_modified_time(DateTime::default());
    for (name, bytes) in parts {
        archive.start_file(name, options)?;
        archive.write_all(&bytes)?;
    }
    Ok(archive.finish()?.into_inner())
}

/// The problem file of a note, with its options before it.
fn source_text(source: &NoteSource) -> String {
    source.append_to(String::new(), DocumentFormat::Latex)
}

/// Relationships, each with the name of its target as its id: `figure1` of `media/figure1.emf`.
fn relationships(linked: &[(String, String)]) -> String {
    let each = linked.iter().map(|(kind, target)| {
        let name = target.rsplit('/').next().unwrap_or_default();
        let id = name.split('.').next().unwrap_or_default();
        format!("<Relationship Id=\"{id}\" Type=\"{kind}\" Target=\"{target}\"/>")
    });
    format!(
        "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">{}</Relationships>",
        each.collect::<Vec<_>>().concat()
    )
}

/// Foot of a page: program and version, page of pages.
fn footer() -> String {
    let field =
        |name: &str| format!("<w:fldSimple w:instr=\" {name} \"><w:r><w:t>1</w:t></w:r></w:fldSimple>");
    format!(
        "<w:ftr {}><w:p><w:pPr><w:pStyle w:val=\"Footer\"/></w:pPr><w:r><w:t>{PROGRAM}</w:t></w:r><w:r><w:tab/></w:r>\
         {}<w:r><w:t xml:space=\"preserve\"> / </w:t></w:r>{}</w:p></w:ftr>",
        body::NAMESPACES,
        field("PAGE"),
        field("NUMPAGES")
    )
}
