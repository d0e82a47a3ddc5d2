//! Text of a document for Word: paragraphs, tables, equations and figures, one of them a line.

use dalembert_core::printer::WrittenStep;

use super::omml::{phantom, set, words_within};
use crate::{
    document::{Block, Document, DocumentTable, NamedValue, column_widths},
    figure::picture::Picture,
    math::{
        self,
        breaking::{lines, room_beside},
        prose::set_in_words,
        sides,
    },
    xml::escaped,
};

/// Namespaces of the parts.
pub(super) const NAMESPACES: &str = "xmlns:w=\"http://schemas.openxmlformats.org/wordprocessingml/2006/main\" \
     xmlns:m=\"http://schemas.openxmlformats.org/officeDocument/2006/math\" \
     xmlns:r=\"http://schemas.openxmlformats.org/officeDocument/2006/relationships\" \
     xmlns:wp=\"http://schemas.openxmlformats.org/drawingml/2006/wordprocessingDrawing\" \
     xmlns:a=\"http://schemas.openxmlformats.org/drawingml/2006/main\" \
     xmlns:pic=\"http://schemas.openxmlformats.org/drawingml/2006/picture\"";
/// Width of the text, in twentieths of a point: A4 with margins of 2.5 cm.
const TEXT: usize = 9072;
/// Room for a side of a formula, in ems.
const ROOM: f64 = 33.0;
/// English metric units of a pixel, of which there are 96 to the inch.
const EMU: f64 = 9525.0;
/// Height of a figure that fits a page with its caption, in these units: 22 cm.
const TALLEST: f64 = 7_920_000.0;

/// The part with the text.
pub(super) fn xml(document: &Document) -> String {
    let mut text = paragraph("Title", &words(&document.title));
    let mut figures = 0;
    for block in &document.blocks {
        text += &match block {
            Block::Heading(heading) => paragraph("Heading1", &prose(heading)),
            Block::Subheading(heading) => paragraph("Heading2", &prose(heading)),
            Block::Paragraph(sentences) => paragraph("Normal", &prose(sentences)),
            Block::Items(items) => {
                items.iter().map(|item| paragraph("ListBullet", &prose(item))).collect::<Vec<_>>().concat()
            }
            Block::TitleBlock(lines) => pairs(lines, true),
            Block::Lines(lines) => pairs(lines, false),
            Block::Step(number, step) => written_step(*number, step),
            Block::Table(table) => rows(table),
            Block::Figure(picture) => {
                figures += 1;
                figure(picture, figures)
            }
        };
    }
    format!(
        "<w:document {NAMESPACES}><w:body>\n{text}<w:sectPr><w:footerReference w:type=\"default\" r:id=\"footer1\"/>\
         <w:pgSz w:w=\"11906\" w:h=\"16838\"/><w:pgMar w:top=\"1417\" w:right=\"1417\" w:bottom=\"1417\" \
         w:left=\"1417\" w:header=\"708\" w:footer=\"708\" w:gutter=\"0\"/></w:sectPr></w:body></w:document>"
    )
}

fn words(text: &str) -> String {
    if text.is_empty() {
        return String::new();
    }
    format!("<w:r><w:t xml:space=\"preserve\">{}</w:t></w:r>", escaped(text))
}

/// Words and symbols among them.
fn prose(text: &str) -> String {
    set_in_words(text, words, |symbol| equation(&set(symbol)))
}

fn bold(text: &str) -> String {
    format!("<w:r><w:rPr><w:b/></w:rPr><w:t xml:space=\"preserve\">{}</w:t></w:r>", escaped(text))
}

fn paragraph(style: &str, content: &str) -> String {
    format!("{}\n", formed(style, "", content))
}

/// A paragraph with properties of its own.
fn formed(style: &str, properties: &str, content: &str) -> String {
    format!("<w:p><w:pPr><w:pStyle w:val=\"{style}\"/>{properties}</w:pPr>{content}</w:p>")
}

fn equation(formula: &str) -> String {
    format!("<m:oMath>{formula}</m:oMath>")
}

fn written_step(number: usize, step: &WrittenStep) -> String {
    let source = if step.source.is_empty() { String::new() } else { format!(" ({})", step.source) };
    let mut text = paragraph(
        "Step",
        &format!("{}{}{}", bold(&format!("{number}.")), prose(&format!(" {}", step.why)), words(&source)),
    );
    let symbol = math::symbols(&step.symbol);
    let room = room_beside(&symbol, ROOM);
    let lead = format!("{}{}", set(&symbol), words_within(" = "));
    let hidden = [phantom(&set(&symbol)), words_within(" = ")].concat();
    let mut equations = Vec::new();
    for (n, side) in sides(step).iter().enumerate() {
        for (line, formula) in lines(side, room).iter().enumerate() {
            let lead = match (n, line) {
                (0, 0) => lead.clone(),
                (_, 0) => hidden.clone(),
                _ => phantom(&lead),
            };
            equations.push(format!("{lead}{}", set(formula)));
        }
    }
    let last = equations.len().saturating_sub(1);
    let broken = equations.iter().enumerate().map(|(n, formula)| {
        let end = if n < last { "<m:r><w:br/></m:r>" } else { "" };
        equation(&format!("{formula}{end}"))
    });
    text += &paragraph(
        "Formula",
        &format!(
            "<m:oMathPara><m:oMathParaPr><m:jc m:val=\"left\"/></m:oMathParaPr>{}</m:oMathPara>",
            broken.collect::<Vec<_>>().concat()
        ),
    );
    if !step.terms.is_empty() {
        let terms = step.terms.iter().map(|(term, value)| {
            row(&[
                cell(TEXT / 4, "", &equation(&set(&math::symbols(term))), false),
                cell(TEXT / 4, "", &words(value), true),
            ])
        });
        text += &table(&[TEXT / 4; 2], "", &terms.collect::<Vec<_>>().concat());
    }
    text
}

/// Names with values.
fn pairs(lines: &[NamedValue], is_framed: bool) -> String {
    let widths =
        if is_framed { [TEXT * 3 / 10, 0, TEXT * 7 / 10] } else { [TEXT / 2, TEXT / 8, TEXT * 3 / 8] };
    let each = lines.iter().map(|line| {
        let indent = match line.depth {
            0 => String::new(),
            depth => format!("<w:ind w:left=\"{}\"/>", 227 * depth),
        };
        let symbol = match line.symbol.as_str() {
            "" => String::new(),
            symbol => equation(&set(&math::symbols(symbol))),
        };
        let label = cell(widths[0], &indent, &prose(&line.label), false);
        let symbol = if is_framed { String::new() } else { cell(widths[1], "", &symbol, false) };
        row(&[label, symbol, cell(widths[2], "", &words(&line.value), false)])
    });
    let widths: Vec<usize> = widths.into_iter().filter(|width| *width > 0).collect();
    let frame = if is_framed { BORDERS } else { "" };
    table(&widths, frame, &each.collect::<Vec<_>>().concat())
}

const BORDERS: &str = "<w:tblBorders><w:top w:val=\"single\" w:sz=\"4\"/><w:left w:val=\"single\" w:sz=\"4\"/><w:bottom \
     w:val=\"single\" w:sz=\"4\"/><w:right w:val=\"single\" w:sz=\"4\"/><w:insideH w:val=\"single\" w:sz=\"4\"/><w:insideV \
     w:val=\"single\" w:sz=\"4\"/></w:tblBorders>";
const RULES: &str = "<w:tblBorders><w:top w:val=\"single\" w:sz=\"4\"/><w:bottom w:val=\"single\" w:sz=\"4\"/></w:tblBorders>";

fn rows(of: &DocumentTable) -> String {
    let count = of.columns.len().max(1);
    let letters = column_widths(of, 80.0);
    let all: f64 = letters.iter().sum::<f64>() + 2.0 * letters.len() as f64;
    let scale = TEXT as f64 / all.max(80.0);
    let mut widths: Vec<usize> = letters.iter().map(|width| ((width + 2.0) * scale) as usize).collect();
    widths.resize(count, TEXT / count);
    let line = |cells: &[String], set: fn(&str) -> String| {
        let cells = (0..count).map(|at| {
            let text = cells.get(at).map_or("", String::as_str);
            cell(widths[at], "", &set(text), of.numeric.get(at) == Some(&true))
        });
        cells.collect::<Vec<_>>()
    };
    let head = line(&of.columns, bold);
    let mut all = format!("<w:tr><w:trPr><w:cantSplit/><w:tblHeader/></w:trPr>{}</w:tr>", head.concat());
    all += &of.rows.iter().map(|cells| row(&line(cells, prose))).collect::<Vec<_>>().concat();
    if !of.foot.is_empty() {
        all += &row(&line(&of.foot, bold));
    }
    let title = if of.title.is_empty() { String::new() } else { paragraph("TableTitle", &prose(&of.title)) };
    title + &table(&widths, RULES, &all)
}

/// A table, and a paragraph behind it: two tables that touch would be one.
fn table(widths: &[usize], borders: &str, rows: &str) -> String {
    let columns = widths.iter().map(|width| format!("<w:gridCol w:w=\"{width}\"/>"));
    format!(
        "<w:tbl><w:tblPr><w:tblW w:w=\"{}\" w:type=\"dxa\"/>{borders}<w:tblLayout w:type=\"fixed\"/></w:tblPr>\
         <w:tblGrid>{}</w:tblGrid>\n{rows}</w:tbl>\n{}",
        widths.iter().sum::<usize>(),
        columns.collect::<Vec<_>>().concat(),
        paragraph("Cell", "")
    )
}

fn row(cells: &[String]) -> String {
    format!("<w:tr><w:trPr><w:cantSplit/></w:trPr>{}</w:tr>\n", cells.concat())
}

fn cell(width: usize, properties: &str, content: &str, is_number: bool) -> String {
    let side = if is_number { "<w:jc w:val=\"right\"/>" } else { "" };
    format!(
        "<w:tc><w:tcPr><w:tcW w:w=\"{width}\" w:type=\"dxa\"/></w:tcPr>{}</w:tc>",
        formed("Cell", &format!("{properties}{side}"), content)
    )
}

fn figure(picture: &Picture, number: usize) -> String {
    // Twentieths of a point are 635 units.
    let scale = (TEXT as f64 * 635.0 / (picture.width * EMU)).min(TALLEST / (picture.height * EMU)).min(1.0);
    let [wide, high] = [picture.width, picture.height].map(|length| (length * EMU * scale).round());
    let title = escaped(&picture.title);
    let drawing = format!(
        "<w:r><w:drawing><wp:inline distT=\"0\" distB=\"0\" distL=\"0\" distR=\"0\"><wp:extent cx=\"{wide}\" \
         cy=\"{high}\"/><wp:docPr id=\"{number}\" name=\"figure {number}\" descr=\"{title}\"/><a:graphic><a:graphicData \
         uri=\"http://schemas.openxmlformats.org/drawingml/2006/picture\"><pic:pic><pic:nvPicPr><pic:cNvPr \
         id=\"{number}\" name=\"figure{number}.emf\"/><pic:cNvPicPr/></pic:nvPicPr><pic:blipFill><a:blip \
         r:embed=\"figure{number}\"/><a:stretch><a:fillRect/></a:stretch></pic:blipFill><pic:spPr><a:xfrm><a:off x=\"0\" \
         y=\"0\"/><a:ext cx=\"{wide}\" cy=\"{high}\"/></a:xfrm><a:prstGeom prst=\"rect\"><a:avLst/></a:prstGeom>\
         </pic:spPr></pic:pic></a:graphicData></a:graphic></wp:inline></w:drawing></w:r>"
    );
    format!(
        "{}\n{}",
        formed("Normal", "<w:keepNext/>", &drawing),
        paragraph("Caption", &prose(&picture.title))
    )
}
