//! A document as one HTML page that needs nothing else: figures inline, formulas as MathML, no scripts.

use dalembert_core::{Locale, printer::WrittenStep};

use crate::{
    PROGRAM,
    document::{Block, Document, DocumentTable, NamedValue, SHORT_TABLE, is_heading},
    math::{
        self, Math,
        breaking::{room_beside, set_in_pieces},
        closing,
        prose::set_in_words,
        sides,
    },
    xml::escaped,
};

const STYLE: &str = "\
:root { color-scheme: light dark }
body { max-width: 48rem; margin: 2rem auto; padding: 0 1rem; font: 1rem/1.5 Georgia, serif }
h1, h2 { line-height: 1.2 }
table { border-collapse: collapse; margin: .8rem 0 }
th, td { padding: .15rem .7rem .15rem 0; text-align: left; vertical-align: top; font-weight: normal }
table.rows th { border-bottom: 1px solid; font-weight: bold }
table.rows tfoot td { border-top: 1px solid; font-weight: bold }
.number { text-align: right }
h4 { margin: 1.2rem 0 0; font-size: 1em } h4 + table { margin-top: .2rem }
figure { margin: 1.2rem 0 }
figure svg { max-width: 100%; height: auto }
.source { opacity: .7 }
table.title-block { border: 1px solid }
table.title-block th, table.title-block td { border-bottom: 1px solid; padding: .15rem .7rem }
h2, h3, h4, tr.heads, p:has(+ .formula) { break-after: avoid }
@page { margin: 2cm; @bottom-left { content: \"PROGRAM\" } @bottom-right { content: counter(page) \" / \" counter(pages) } }
@media screen and (max-width: 46rem) { table.rows { display: block; overflow-x: auto } table:not(.rows) td, li, p { overflow-wrap: anywhere } }
@media print { body { max-width: none; margin: 0 } .formula, figure, tr, .short { break-inside: avoid } figure svg { max-height: 23cm } }
";

/// The rules of the formulas of a step: symbol, equals sign, and a side whose lines are broken before its signs, first
/// between its terms. A side that is broken otherwise on a narrow page is there twice.
const STYLE_OF_FORMULAS: &str = "\
.formula { display: grid; grid-template-columns: max-content max-content minmax(0, 1fr); gap: .5em .25em; \
align-items: baseline; margin: .4rem 0 1rem 2rem }
.formula .term { display: inline-flex; flex-wrap: wrap; align-items: baseline; max-width: 100% }
.formula .narrow { display: none }
@media screen and (max-width: 46rem) { .formula { margin-left: .5rem; font-size: .9em } \
.formula .wide { display: none } .formula .narrow { display: block } }
";
/// Room for a side of a formula on a page of A4 and on a phone, in ems.
const ROOM: f64 = 33.0;
const NARROW_ROOM: f64 = 19.0;

/// The rules of a fragment, for it alone: the page around it has its own.
const STYLE_OF_FRAGMENT: &str = "\
.dalembert { max-width: 48rem }
.dalembert table { border-collapse: collapse; margin: .8rem 0 }
.dalembert th, .dalembert td { padding: .15rem .7rem .15rem 0; text-align: left; vertical-align: top }
.dalembert tbody th { font-weight: normal }
.dalembert table.rows thead th { border-bottom: 1px solid }
.dalembert table.rows tfoot td { border-top: 1px solid; font-weight: bold }
.dalembert .number { text-align: right }
.dalembert figure svg { max-width: 100%; height: auto }
.dalembert .source { opacity: .7 }
";

/// The document as a part of another HTML page: a notebook.
pub fn html_fragment(document: &Document) -> String {
    let blocks: String = document.blocks.iter().map(block).collect();
    format!(
        "<div class=\"dalembert\">\n<style>\n{STYLE_OF_FRAGMENT}{STYLE_OF_FORMULAS}</style>\n<h1>{}</h1>\n{blocks}</div>\n",
        escaped(&document.title)
    )
}

/// The document as an HTML page.
pub fn html(document: &Document, locale: &Locale) -> String {
    let language = locale.language.tag();
    let title = escaped(&document.title);
    let blocks: String = document.blocks.iter().map(block).collect();
    let style = STYLE.replace("PROGRAM", PROGRAM);
    format!(
        "<!DOCTYPE html>\n<html lang=\"{language}\">\n<head>\n<meta charset=\"utf-8\"/>\n<meta \
         name=\"viewport\" content=\"width=device-width\"/>\n<title>{title}</title>\n<style>\n{style}{STYLE_OF_FORMULAS}</style>\n\
         </head>\n<body>\n<h1>{title}</h1>\n{blocks}</body>\n</html>\n"
    )
}

fn block(block: &Block) -> String {
    match block {
        Block::Heading(words) => format!("<h2>{}</h2>\n", prose(words)),
        Block::Subheading(words) => format!("<h3>{}</h3>\n", prose(words)),
        Block::Paragraph(words) => format!("<p>{}</p>\n", prose(words)),
        Block::Items(items) => {
            let items =
                items.iter().map(|item| format!("<li>{}</li>\n", prose(item))).collect::<Vec<_>>().concat();
            format!("<ul>\n{items}</ul>\n")
        }
        Block::TitleBlock(lines) => {
            format!("<table class=\"title-block\">\n<tbody>\n{}</tbody>\n</table>\n", pairs(lines))
        }
        Block::Lines(lines) => {
            format!("<table>\n<tbody>\n{}</tbody>\n</table>\n", pairs(lines))
        }
        Block::Step(number, step) => written_step(*number, step),
        Block::Table(table) => rows(table),
        Block::Figure(picture) => format!(
            "<figure>\n{}<figcaption>{}</figcaption>\n</figure>\n",
            picture.svg(),
            prose(&picture.title)
        ),
    }
}

/// Names with values; a heading stays beside the first of its lines.
fn pairs(lines: &[NamedValue]) -> String {
    let row = |(at, line): (usize, &NamedValue)| pair(line, is_heading(lines, at));
    lines.iter().enumerate().map(row).collect::<Vec<_>>().concat()
}

fn pair(line: &NamedValue, is_heading: bool) -> String {
    let symbol = if line.symbol.is_empty() { String::new() } else { inline(&math::symbols(&line.symbol)) };
    let indent = match line.depth {
        0 => String::new(),
        depth => format!(" style=\"padding-left: {}em\"", 1.2 * depth as f64),
    };
    let heads = if is_heading { " class=\"heads\"" } else { "" };
    format!(
        "<tr{heads}><th{indent}>{}</th><td>{symbol}</td><td>{}</td></tr>\n",
        prose(&line.label),
        escaped(&line.value)
    )
}

/// Words and symbols among them.
fn prose(text: &str) -> String {
    set_in_words(text, escaped, inline)
}

fn inline(formula: &Math) -> String {
    format!("<math>{}</math>", mathml(formula))
}

/// A side of a formula, in pieces between which a line may end.
fn side(formula: &Math, room: f64) -> String {
    let terms = set_in_pieces(formula, room, |piece, is_behind_another| {
        let set = mathml(piece);
        let set = if is_behind_another { set.replacen("<mo>", "<mo form=\"infix\">", 1) } else { set };
        format!("<math displaystyle=\"true\">{set}</math>")
    });
    let terms = terms.iter().map(|pieces| match pieces.as_slice() {
        [whole] => whole.clone(),
        pieces => format!("<span class=\"term\">{}</span>", pieces.concat()),
    });
    terms.collect::<Vec<_>>().join("<wbr/>")
}

fn written_step(number: usize, step: &WrittenStep) -> String {
    let source = if step.source.is_empty() {
        String::new()
    } else {
        format!(" <span class=\"source\">({})</span>", escaped(&step.source))
    };
    let mut text = format!("<p><b>{number}.</b> {}{source}</p>\n", prose(&step.why));
    let symbol = math::symbols(&step.symbol);
    let rooms = [ROOM, NARROW_ROOM].map(|room| room_beside(&symbol, room));
    text += "<div class=\"formula\">\n";
    for (n, formula) in sides(step).iter().enumerate() {
        let symbol = if n == 0 { inline(&symbol) } else { String::new() };
        let [wide, narrow] = rooms.map(|room| side(formula, room));
        text += &format!("<span>{symbol}</span><span><math><mo>=</mo></math></span>");
        text += &if wide == narrow {
            format!("<span>{wide}</span>\n")
        } else {
            format!("<span class=\"wide\">{wide}</span><span class=\"narrow\">{narrow}</span>\n")
        };
    }
    text += "</div>\n";
    if !step.terms.is_empty() {
        let terms = step.terms.iter().map(|(term, value)| {
            format!(
                "<tr><td>{}</td><td class=\"number\">{}</td></tr>\n",
                inline(&math::symbols(term)),
                escaped(value)
            )
        });
        text += &format!("<table>\n<tbody>\n{}</tbody>\n</table>\n", terms.collect::<String>());
    }
    text
}

fn rows(table: &DocumentTable) -> String {
    let number = |at: usize| if table.numeric.get(at) == Some(&true) { " class=\"number\"" } else { "" };
    let row = |cells: &[String], tag: &str| {
        let cells = (0..table.columns.len()).map(|at| {
            format!("<{tag}{}>{}</{tag}>", number(at), prose(cells.get(at).map_or("", String::as_str)))
        });
        format!("<tr>{}</tr>\n", cells.collect::<String>())
    };
    let caption =
        if table.title.is_empty() { String::new() } else { format!("<h4>{}</h4>\n", prose(&table.title)) };
    let short = if table.rows.len() <= SHORT_TABLE { " short" } else { "" };
    let foot = if table.foot.is_empty() {
        String::new()
    } else {
        format!("<tfoot>\n{}</tfoot>\n", row(&table.foot, "td"))
    };
    format!(
        "{caption}<table class=\"rows{short}\">\n<thead>\n{}</thead>\n<tbody>\n{}</tbody>\n{foot}</table>\n",
        row(&table.columns, "th"),
        table.rows.iter().map(|cells| row(cells, "td")).collect::<String>()
    )
}

/// A formula in MathML, without the element around it.
fn mathml(formula: &Math) -> String {
    // Every child of a fraction, a root or a power must be one element.
    let one = |part: &Math| format!("<mrow>{}</mrow>", mathml(part));
    match formula {
        Math::Row(parts) => parts.iter().map(mathml).collect(),
        Math::Number(digits) => format!("<mn>{}</mn>", escaped(digits)),
        Math::Upright(words) => format!("<mtext>{}</mtext>", escaped(words)),
        Math::Symbol(base, index) if index.is_empty() => format!("<mi>{}</mi>", escaped(base)),
        Math::Symbol(base, index) => {
            format!("<msub><mi>{}</mi><mtext>{}</mtext></msub>", escaped(base), escaped(index))
        }
        Math::Operator(bracket @ ('(' | ')' | '[' | ']')) => format!("<mo stretchy=\"false\">{bracket}</mo>"),
        Math::Operator(sign) => format!("<mo>{}</mo>", escaped(&sign.to_string())),
        Math::Gap => "<mspace width=\"0.2em\"/>".to_owned(),
        Math::Fraction(top, bottom) => format!("<mfrac>{}{}</mfrac>", one(top), one(bottom)),
        Math::Root(degree, of) if degree.is_empty() => format!("<msqrt>{}</msqrt>", mathml(of)),
        Math::Root(degree, of) => format!("<mroot>{}<mn>{}</mn></mroot>", one(of), escaped(degree)),
        Math::Power(base, power) => format!("<msup>{}<mn>{}</mn></msup>", one(base), escaped(power)),
        Math::Index(base, index) => format!("<msub>{}<mtext>{}</mtext></msub>", one(base), escaped(index)),
        Math::Brackets(open, inner) => {
            let close = closing(*open);
            format!("<mrow><mo>{open}</mo>{}<mo>{close}</mo></mrow>", mathml(inner))
        }
    }
}
