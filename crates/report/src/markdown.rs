//! A document in Markdown (CommonMark with pipe tables).

use dalembert_core::printer::WrittenStep;

use crate::document::{Block, Document, DocumentTable, NamedValue, figure_name};

/// The document in Markdown. Formulas stand in code blocks, so that nothing in them is taken for markup.
/// Figures are links to files that begin with `figures`; without that they are left out.
pub fn markdown(document: &Document, figures: Option<&str>) -> String {
    let mut text = String::new();
    let mut count = 0;
    if !document.title.is_empty() {
        text += &format!("# {}\n", escaped(&document.title));
    }
    for block in &document.blocks {
        if matches!(block, Block::Figure(_)) && figures.is_none() {
            continue;
        }
        if !text.is_empty() {
            text.push('\n');
        }
        text += &match block {
            Block::Heading(heading) => format!("## {}\n", escaped(heading)),
            Block::Subheading(heading) => format!("### {}\n", escaped(heading)),
            Block::Paragraph(words) => format!("{}\n", escaped(words)),
            Block::Items(items) => {
                items.iter().map(|item| format!("- {}\n", escaped(item))).collect::<Vec<_>>().concat()
            }
            Block::TitleBlock(lines) | Block::Lines(lines) => lines.iter().map(pair).collect(),
            Block::Step(number, step) => written_step(*number, step),
            Block::Table(table) => pipes(table),
            Block::Figure(picture) => {
                count += 1;
                let name = figure_name(figures.unwrap_or_default(), count);
                format!("![{}](<{name}>)\n", escaped(&picture.title))
            }
        };
    }
    text
}

fn pair(line: &NamedValue) -> String {
    let indent = "  ".repeat(line.depth);
    let symbol = if line.symbol.is_empty() { String::new() } else { format!(" {}", escaped(&line.symbol)) };
    let value = if line.value.is_empty() { String::new() } else { format!(": {}", escaped(&line.value)) };
    format!("{indent}- {}{symbol}{value}\n", escaped(&line.label))
}

fn written_step(number: usize, step: &WrittenStep) -> String {
    let source = if step.source.is_empty() { String::new() } else { format!(" ({})", escaped(&step.source)) };
    let mut text = format!("**{number}.** {}{source}\n\n", escaped(&step.why));
    let blank = " ".repeat(crate::wrap::columns(&step.symbol));
    let sides = [&step.formula, &step.substitution, &step.result];
    for (n, side) in sides.into_iter().filter(|side| !side.is_empty()).enumerate() {
        text += &format!("    {} = {side}\n", if n == 0 { &step.symbol } else { &blank });
    }
    if !step.terms.is_empty() {
        text.push('\n');
        text += "| | |\n|---|--:|\n";
        for (term, value) in &step.terms {
            text += &format!("| {} | {} |\n", escaped(term), escaped(value));
        }
    }
    text
}

fn pipes(table: &DocumentTable) -> String {
    let mut text = String::new();
    if !table.title.is_empty() {
        text += &format!("**{}**\n\n", escaped(&table.title));
    }
    let row = |cells: &[String], mark: &str| {
        let cells = (0..table.columns.len()).map(|at| match cells.get(at) {
            Some(cell) if !cell.is_empty() => format!(" {mark}{}{mark} |", escaped(cell)),
            _ => "  |".to_owned(),
        });
        format!("|{}\n", cells.collect::<String>())
    };
    text += &row(&table.columns, "");
    let rules =
        (0..table.columns.len()).map(|at| if table.numeric.get(at) == Some(&true) { "--:|" } else { "---|" });
    text += &format!("|{}\n", rules.collect::<String>());
    text.extend(table.rows.iter().map(|cells| row(cells, "")));
    if !table.foot.is_empty() {
        text += &row(&table.foot, "**");
    }
    text
}

/// Words on one line, without anything that Markdown or HTML would take for markup.
fn escaped(words: &str) -> String {
    let mut text = String::with_capacity(words.len());
    for character in words.chars() {
        match character {
            '\n' | '\r' => text.push(' '),
            '&' => text.push_str("&amp;"),
            '\\' | '`' | '*' | '_' | '[' | ']' | '<' | '>' | '|' | '#' | '~' => {
                text.extend(['\\', character]);
            }
            _ => text.push(character),
        }
    }
    // A sentence that begins like an item of a list.
    match text.split_once(['.', ')']) {
        Some((number, rest))
            if !number.is_empty()
                && number.bytes().all(|byte| byte.is_ascii_digit())
                && (rest.is_empty() || rest.starts_with(' ')) =>
        {
            text.insert(number.len(), '\\');
            text
        }
        _ if text.starts_with(['-', '+']) => format!("\\{text}"),
        _ => text,
    }
}
