//! A document in Typst; its figures are SVG files beside it, which Typst reads as they are.

use dalembert_core::{Language, Locale, printer::WrittenStep};

use crate::{
    PROGRAM,
    document::{Block, Document, DocumentTable, NamedValue, SHORT_TABLE, figure_name, is_heading},
    math::{
        self, Math,
        breaking::{room_beside, set_in_pieces},
        prose::set_in_words,
        sides,
    },
};

/// The document in Typst. Its figures are files that begin with `figures`; without that they are left out.
pub fn typst(document: &Document, figures: Option<&str>, locale: &Locale) -> String {
    let language = match locale.language {
        Language::English => "#set text(lang: \"en\")\n",
        Language::Portuguese => "#set text(lang: \"pt\", region: \"BR\")\n",
    };
    let mut text = format!(
        "#set document(title: {})\n#set page(margin: 2.5cm, footer: context [{} #h(1fr) \
         #counter(page).display(\"1 / 1\", both: true)])\n{language}{SIDE}\n= {}\n",
        string(&document.title),
        words(PROGRAM),
        words(&document.title)
    );
    let mut count = 0;
    for block in &document.blocks {
        text.push('\n');
        text += &match block {
            Block::Heading(heading) => format!("== {}\n", prose(heading)),
            Block::Subheading(heading) => format!("=== {}\n", prose(heading)),
            Block::Paragraph(sentences) => format!("{}\n", prose(sentences)),
            Block::Items(items) => {
                items.iter().map(|item| format!("- {}\n", prose(item))).collect::<Vec<_>>().concat()
            }
            Block::TitleBlock(lines) => {
                let cell =
                    |line: &NamedValue| format!("  [{}], [{}],\n", words(&line.label), words(&line.value));
                format!("#table(columns: 2,\n{})\n", lines.iter().map(cell).collect::<String>())
            }
            Block::Lines(lines) => pairs(lines),
            Block::Step(number, step) => written_step(*number, step),
            Block::Table(table) => rows(table),
            Block::Figure(picture) => {
                count += 1;
                match figures {
                    Some(stem) => format!(
                        "#figure(image({}, width: {:.0}%), caption: [{}])\n",
                        string(&figure_name(stem, count)),
                        (100.0 * TALLEST * picture.width / picture.height).min(100.0),
                        prose(&picture.title)
                    ),
                    None => String::new(),
                }
            }
        };
    }
    text
}

/// A side of an equation behind its symbol: its lines are broken where it says, and aligned behind the equals sign. Lines of
/// formulas are as high as their fractions, and as far apart as those of words.
const SIDE: &str = "\
#let side(symbol, formula) = context {
  set text(top-edge: \"bounds\", bottom-edge: \"bounds\")
  let lead = [#symbol $=$ ]
  block(above: 0.8em, below: 0.8em, par(leading: 0.8em, hanging-indent: measure(lead).width, lead + formula))
}
";

/// Height of a figure that still fits a page with its caption, as a part of the width of the text.
const TALLEST: f64 = 1.4;

/// Room for a side of a formula, in ems.
const ROOM: f64 = 35.0;

fn pairs(lines: &[NamedValue]) -> String {
    let cells = lines.iter().enumerate().map(|(at, line)| {
        let symbol = if line.symbol.is_empty() {
            String::new()
        } else {
            format!("${}$", set(&math::symbols(&line.symbol)))
        };
        let with = kept_with(lines, at);
        format!(
            "  [#h({}em);{}], [{symbol}], [{}],{with}\n",
            line.depth,
            prose(&line.label),
            words(&line.value)
        )
    });
    let cells = cells.collect::<String>();
    kept(lines.len(), &format!("table(columns: 4, stroke: none, inset: 3pt,\n{cells})"))
}

/// Last cell of a line, of no width: headings and the first of their lines share one that no page parts.
fn kept_with(lines: &[NamedValue], at: usize) -> String {
    if at > 0 && is_heading(lines, at - 1) {
        return String::new();
    }
    let headings = (at..lines.len()).take_while(|at| is_heading(lines, *at)).count();
    if headings == 0 {
        return " [],".to_owned();
    }
    format!(" table.cell(rowspan: {}, breakable: false)[],", headings + 1)
}

/// A side of a formula, in pieces between which a line may end.
fn side(formula: &Math, room: f64) -> String {
    let terms = set_in_pieces(formula, room, |piece, is_behind_another| {
        let before = if is_behind_another { "\"\" " } else { "" };
        format!("#box($display({before}{})$)", set(piece))
    });
    terms.concat().join("#sym.zws;")
}

fn written_step(number: usize, step: &WrittenStep) -> String {
    let source = if step.source.is_empty() { String::new() } else { format!(" ({})", words(&step.source)) };
    let mut text = format!(
        "#block(sticky: true)[*{number}.* {}{source}]\n#block(breakable: false, inset: (left: 2em))[\n",
        prose(&step.why)
    );
    let symbol = math::symbols(&step.symbol);
    let room = room_beside(&symbol, ROOM);
    let symbol = set(&symbol);
    for (n, formula) in sides(step).iter().enumerate() {
        let left = if n == 0 { format!("${symbol}$") } else { format!("#hide(${symbol}$)") };
        text += &format!("  #side[{left}][{}]\n", side(formula, room));
    }
    text += "]\n";
    if !step.terms.is_empty() {
        let cells = step
            .terms
            .iter()
            .map(|(term, value)| format!("  [${}$], [{}],\n", set(&math::symbols(term)), words(value)));
        text += &format!(
            "#table(columns: 2, align: (left, right), stroke: none,\n{})\n",
            cells.collect::<String>()
        );
    }
    text
}

fn rows(table: &DocumentTable) -> String {
    let cells = |row: &[String]| {
        let cells: Vec<String> = (0..table.columns.len())
            .map(|at| format!("[{}]", prose(row.get(at).map_or("", String::as_str))))
            .collect();
        cells.join(", ")
    };
    let sides: Vec<&str> = (0..table.columns.len())
        .map(|at| if table.numeric.get(at) == Some(&true) { "right" } else { "left" })
        .collect();
    let title = match table.title.as_str() {
        "" => String::new(),
        title => format!("#block(sticky: true)[*{}*]\n", prose(title)),
    };
    let foot = if table.foot.is_empty() {
        String::new()
    } else {
        format!("  table.hline(),\n  {},\n", cells(&table.foot))
    };
    let body = table.rows.iter().map(|row| format!("  {},\n", cells(row))).collect::<Vec<_>>().concat();
    // The comma after the only side makes a list of it.
    let set = format!(
        "table(columns: {}, align: ({},), stroke: none, inset: 3pt,\n  table.header({}),\n  table.hline(),\n{body}{foot})",
        table.columns.len(),
        sides.join(", "),
        cells(&table.columns)
    );
    format!("{title}{}", kept(table.rows.len(), &set))
}

/// A table, on one page if it is short.
fn kept(rows: usize, table: &str) -> String {
    if rows <= SHORT_TABLE { format!("#block(breakable: false, {table})\n") } else { format!("#{table}\n") }
}

/// A formula, to stand within `$`.
fn set(formula: &Math) -> String {
    match formula {
        Math::Row(parts) => parts.iter().map(set).collect::<Vec<_>>().join(" "),
        Math::Number(digits) if digits.contains(',') => string(digits),
        Math::Number(digits) => digits.clone(),
        Math::Upright(text) => match text.as_str() {
            "sin" | "cos" | "tan" | "arcsin" | "arccos" | "arctan" | "exp" | "ln" => text.clone(),
            _ => string(text),
        },
        Math::Symbol(base, index) => {
            let base = match (base.chars().next(), base.chars().count()) {
                (Some(letter), 1) if letter.is_alphabetic() => base.clone(),
                _ => format!("italic({})", string(base)),
            };
            format!("{base}{}", lowered(index))
        }
        Math::Operator(sign) => match sign {
            '+' | '−' | '=' | '×' | '·' | '≤' | '≥' | '<' | '>' | '±' | '∑' | '…' => {
                sign.to_string()
            }
            other => string(&other.to_string()),
        },
        Math::Gap => "thin".to_owned(),
        Math::Fraction(top, bottom) => format!("frac({}, {})", set(top), set(bottom)),
        Math::Root(degree, of) if degree.is_empty() => format!("sqrt({})", set(of)),
        Math::Root(degree, of) => format!("root({}, {})", string(degree), set(of)),
        Math::Power(base, power) => format!("{}^({})", set(base), string(power)),
        Math::Index(base, index) => format!("{}{}", set(base), lowered(index)),
        Math::Brackets('|', inner) => format!("abs({})", set(inner)),
        Math::Brackets('[', inner) => format!("[{}]", set(inner)),
        Math::Brackets(_, inner) => format!("({})", set(inner)),
    }
}

fn lowered(index: &str) -> String {
    if index.is_empty() { String::new() } else { format!("_({})", string(index)) }
}

/// A text between quotation marks.
fn string(text: &str) -> String {
    let mut out = String::from('"');
    for character in text.chars() {
        match character {
            '"' | '\\' => out.extend(['\\', character]),
            '\n' | '\r' | '\t' => out.push(' '),
            _ => out.push(character),
        }
    }
    out.push('"');
    out
}

/// Words on one line, and symbols among them.
fn prose(text: &str) -> String {
    set_in_words(text, words, |symbol| format!("${}$", set(symbol)))
}

/// Words on one line, without anything that would be taken for markup.
fn words(text: &str) -> String {
    let mut out = String::new();
    for character in text.chars() {
        match character {
            '\\' | '#' | '$' | '*' | '_' | '`' | '<' | '>' | '@' | '~' | '[' | ']' | '/' | '"' | '\'' => {
                out.extend(['\\', character]);
            }
            // A line that begins with one of these, or with a number and a point, would be a list or a heading.
            '-' | '+' | '=' | '.' if out.chars().all(|before| before.is_ascii_digit()) => {
                out.extend(['\\', character]);
            }
            '\n' | '\r' | '\t' => out.push(' '),
            _ => out.push(character),
        }
    }
    out
}
