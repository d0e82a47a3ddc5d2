//! The file that a problem begins with: every input with its label, unit, limits and help as comments, empty or with the
//! values of a published case.
//!
//! Lines that start with `##` explain; those that start with `#` alone are inputs that may be left out.

use toml_edit::{DocumentMut, Value as Toml};

use super::{Format, ProblemFile, TitleBlock, definitions, write, write::text_of_lines};
use crate::{
    Draft, Entry, Field, Locale, Shape, Statement, Text, UnitSetting, Variant, cases::Case, describe,
    gravity, table,
};

/// The longest line of a comment, in characters.
const WIDTH: usize = 100;

/// The text of a new problem file of an analysis: with empty inputs of the first alternatives, or with those of a case.
pub fn template(entry: &'static Entry, case: Option<&Case>, locale: &Locale) -> String {
    let locale = &locale.at(entry.about.id);
    let mut writer = Writer { locale, text: String::new(), later: Vec::new() };
    let say = |words: &'static str| Text::from(words).render(locale);
    writer.comment(&say(entry.about.title), false);
    writer.comment(&say(entry.about.summary), false);
    writer.blank_line();
    let shape = entry.inputs();
    let draft = match case {
        Some(case) => {
            writer.comment(&case.source.render(locale), false);
            writer.comment(&case.statement.render(locale), false);
            writer.comment(&case.note.render(locale), false);
            case.draft.clone()
        }
        None => {
            let how = Text::new(
                "Write each value between its quotation marks, with its unit. Lines after a single # are optional.",
            );
            writer.comment(&how.render(locale), false);
            Draft::blank(&shape).with_first_alternatives(&shape)
        }
    };
    let title = case.map_or_else(String::new, |case| case.title().render(locale));
    if !entry.linked().is_empty() {
        // Of linked problems each is a table with an analysis of its own; an exam question is none.
        let problem = ProblemFile {
            entry,
            title,
            statement: Statement::default(),
            title_block: TitleBlock::default(),
            draft,
            units: UnitSetting::Auto,
            show: Vec::new(),
            notes: Vec::new(),
            files: Vec::new(),
        };
        writer.blank_line();
        return writer.text + &write(&problem, "");
    }
    writer.text += &format!(
        "format = {}\nanalysis = {}\ntitle = {}\n\n[inputs]\n",
        Format::LATEST as i64,
        quoted(entry.about.id),
        quoted(&title)
    );
    if let Draft::Group(drafts) = &draft {
        writer.table("inputs", "", entry.fields(), drafts, true);
    }
    if case.is_none() {
        writer.blank_line();
        let also = Text::new(
            "[let] has quantities of your own for formulas, [ask] questions of your own, [given] known answers from which inputs written as ? are found, [configuration.NAME] the same problem with some inputs changed, [show] units of answers; units = \"in-lbf-s\" above [inputs] shows everything in one system.",
        );
        writer.comment(&also.render(locale), false);
        return writer.text;
    }
    let Ok(mut document) = writer.text.parse::<DocumentMut>() else { return writer.text };
    definitions::write(document.as_table_mut(), &draft, &entry.shape());
    document.to_string()
}

/// A text in quotes.
fn quoted(text: &str) -> String {
    let value: Toml = if text.contains('\n') { text_of_lines(text) } else { text.into() };
    value.to_string().trim().to_owned()
}

/// A table or a list of tables that is written behind the keys of the table around it.
struct Later<'d> {
    path: String,
    field: &'static Field,
    /// The list, or the one table, with its fields.
    part: Part<'d>,
    /// True if its fields are explained.
    explained: bool,
    /// Comments of the choice that it belongs to.
    above: String,
}

enum Part<'d> {
    Rows(&'static Shape, &'d [Draft]),
    Table(&'static [Field], &'d [Draft]),
}

struct Writer<'l, 'd> {
    locale: &'l Locale,
    text: String,
    later: Vec<Later<'d>>,
}

impl<'d> Writer<'_, 'd> {
    /// The keys of a table whose header stands above, then the tables and lists within it.
    fn table(
        &mut self,
        path: &str,
        key: &str,
        fields: &'static [Field],
        drafts: &'d [Draft],
        explained: bool,
    ) {
        let before = std::mem::take(&mut self.later);
        self.fields(path, key, fields, drafts, explained);
        for later in std::mem::replace(&mut self.later, before) {
            self.part(later);
        }
    }

    fn part(&mut self, later: Later<'d>) {
        let Later { path, field, part, explained, above } = later;
        self.blank_line();
        self.text += &above;
        if explained {
            self.explain(field, false);
        }
        match part {
            Part::Table(fields, drafts) => {
                self.text += &format!("[{path}]\n");
                self.table(&path, "", fields, drafts, explained);
            }
            Part::Rows(item, []) => {
                self.text += &format!("# [[{path}]]\n");
                self.left_out("", item, explained);
            }
            Part::Rows(item, rows) => {
                for (n, row) in rows.iter().enumerate() {
                    if n > 0 {
                        self.blank_line();
                    }
                    self.text += &format!("[[{path}]]\n");
                    self.row(&path, item, row, explained && n == 0);
                }
            }
        }
    }

    fn row(&mut self, path: &str, item: &'static Shape, row: &'d Draft, explained: bool) {
        match (item.present(), row) {
            (Shape::Group(fields), Draft::Group(drafts)) => {
                self.table(path, "", fields(), drafts, explained);
            }
            (Shape::OneOf(variants), Draft::OneOf(at, fields)) => {
                let Some(variant) = variants().get(*at) else { return };
                if explained {
                    self.alternatives(variants(), false);
                }
                match ((variant.fields)(), &**fields) {
                    ([], _) | (_, Draft::Leaf(_)) => self.text += &format!("{} = {{}}\n", variant.name),
                    (fields, Draft::Group(drafts)) if is_written(fields, drafts) => {
                        self.table(path, &format!("{}.", variant.name), fields, drafts, explained);
                    }
                    (fields, Draft::Group(drafts)) => {
                        let path = format!("{path}.{}", variant.name);
                        self.text += &format!("[{path}]\n");
                        self.table(&path, "", fields, drafts, explained);
                    }
                    _ => {}
                }
            }
            _ => {}
        }
    }

    fn fields(
        &mut self,
        path: &str,
        above: &str,
        fields: &'static [Field],
        drafts: &'d [Draft],
        explained: bool,
    ) {
        for (field, draft) in fields.iter().zip(drafts) {
            let key = format!("{above}{}", field.name);
            let shape = match field.shape {
                Shape::Optional(inner) => *inner(),
                shape => shape,
            };
            if let (Shape::Rows { item, .. }, Draft::Rows(rows)) = (shape, draft)
                && !is_inline(item())
            {
                let path = format!("{path}.{key}");
                if explained || !rows.is_empty() {
                    let (part, above) = (Part::Rows(item(), rows), String::new());
                    self.later.push(Later { path, field, part, explained, above });
                }
                continue;
            }
            if is_left_out(field, draft) {
                if explained {
                    self.explain(field, true);
                    let text = field.default.unwrap_or_default();
                    let form = if shape.is_leaf() && !matches!(shape, Shape::Table(_)) {
                        quoted(text)
                    } else {
                        describe::form(&shape)
                    };
                    self.text += &format!("# {key} = {form}\n");
                }
                continue;
            }
            if let (Shape::OneOf(variants), Draft::OneOf(at, inner)) = (shape, draft)
                && let (Some(variant), Draft::Group(inner)) = (variants().get(*at), &**inner)
                && let chosen @ [_, ..] = (variant.fields)()
                && !is_written(chosen, inner)
            {
                let path = format!("{path}.{key}.{}", variant.name);
                let (part, above) = (Part::Table(chosen, inner), String::new());
                self.later.push(Later { path, field, part, explained, above });
                continue;
            }
            let (start, later) = (self.text.len(), self.later.len());
            if explained {
                self.explain(field, false);
            }
            let end = self.text.len();
            self.value(path, &key, &shape, draft, explained);
            if self.text.len() == end
                && let Some(first) = self.later.get_mut(later)
            {
                first.above.insert_str(0, self.text[start..].trim_start());
                self.text.truncate(start);
            }
        }
    }

    /// The value of a field under a key with dots.
    fn value(&mut self, path: &str, key: &str, shape: &Shape, draft: &'d Draft, explained: bool) {
        match (shape, draft) {
            (Shape::Table(columns), Draft::Leaf(text)) if text.is_empty() => {
                self.text += &format!("{key} = {}\n", quoted(&format!("{}\n", table::heading(columns()))));
            }
            (_, Draft::Leaf(text)) => self.text += &format!("{key} = {}\n", quoted(text)),
            (Shape::Group(fields), Draft::Group(drafts)) => {
                self.fields(path, &format!("{key}."), fields(), drafts, explained);
            }
            (Shape::OneOf(variants), Draft::OneOf(at, fields)) => {
                let Some(variant) = variants().get(*at) else { return };
                match ((variant.fields)(), &**fields) {
                    ([], _) => self.text += &format!("{key} = {}\n", quoted(variant.name)),
                    (fields, Draft::Group(drafts)) => {
                        self.fields(path, &format!("{key}.{}.", variant.name), fields, drafts, explained);
                    }
                    _ => {}
                }
            }
            (Shape::Rows { .. }, Draft::Rows(_)) => self.text += &format!("{key} = {}\n", inline(draft)),
            _ => {}
        }
    }

    /// The lines of a value that is left out, as comments; what may be left out within it is not repeated.
    fn left_out(&mut self, above: &str, shape: &Shape, explained: bool) {
        match shape {
            Shape::Optional(inner) => self.left_out(above, inner(), explained),
            Shape::Group(fields) => {
                for field in fields() {
                    if explained {
                        self.explain(field, matches!(field.shape, Shape::Optional(_)));
                    }
                    let key = format!("{above}{}", field.name);
                    match field.shape {
                        Shape::Group(_) => self.left_out(&format!("{key}."), &field.shape, explained),
                        Shape::Table(_) | Shape::OneOf(_) | Shape::Rows { .. } => {
                            self.text += &format!("# {key} = {}\n", describe::form(&field.shape));
                        }
                        _ => {
                            let text = quoted(field.default.unwrap_or_default());
                            self.text += &format!("# {key} = {text}\n");
                        }
                    }
                }
            }
            Shape::OneOf(variants) => {
                self.alternatives(variants(), false);
                if let Some(variant) = variants().first() {
                    let fields = (variant.fields)();
                    if fields.is_empty() {
                        self.text += &format!("# {above}{} = {{}}\n", variant.name);
                    } else {
                        let group = Shape::Group(variant.fields);
                        self.left_out(&format!("{above}{}.", variant.name), &group, explained);
                    }
                }
            }
            _ => {}
        }
    }

    /// The comment of a field: label, symbol, unit, limits, default, help; the alternatives of a choice, the columns of a
    /// table.
    fn explain(&mut self, field: &'static Field, optional: bool) {
        self.blank_line();
        let say = |words: &'static str| Text::from(words).render(self.locale);
        let symbol = if field.symbol.is_empty() { String::new() } else { format!(" {}", field.symbol) };
        let shape = field.shape.present();
        let mut words = format!("{}{symbol}: {}", say(field.label), describe::in_words(&shape, self.locale));
        if let Some(default) = describe::default_of(field) {
            words = format!("{words}, {}", default.render(self.locale));
        }
        if optional && field.default.is_none() {
            words = format!("{words}, {}", say("or nothing"));
        }
        let help = say(field.help);
        self.comment(&words, false);
        self.comment(&help, false);
        self.inside(&shape);
    }

    fn inside(&mut self, shape: &Shape) {
        match shape {
            Shape::OneOf(variants) => self.alternatives(variants(), true),
            Shape::Table(columns) => {
                for column in columns() {
                    let say = |words: &'static str| Text::from(words).render(self.locale);
                    let help = say(column.help);
                    let help = if help.is_empty() { help } else { format!(". {help}") };
                    let words = describe::in_words(&column.shape, self.locale);
                    let line = format!("{}: {}: {words}{help}", column.name, say(column.label));
                    self.comment(&line, true);
                }
            }
            Shape::Rows { item, .. } if is_inline(item()) => {
                let words = describe::in_words(item(), self.locale);
                self.comment(&format!("{words}: {}", describe::form(shape)), true);
            }
            _ => {}
        }
    }

    /// A line for each alternative, in the form in which it is written.
    fn alternatives(&mut self, variants: &'static [Variant], of_field: bool) {
        for variant in variants {
            let label = Text::from(variant.label).render(self.locale);
            let form = if of_field { describe::form_of(variant) } else { variant.name.to_owned() };
            let help = Text::from(variant.help).render(self.locale);
            let help = if help.is_empty() { help } else { format!(". {help}") };
            self.comment(&format!("{form}: {label}{help}"), true);
        }
    }

    /// Lines of a comment of at most [`WIDTH`] characters.
    fn comment(&mut self, words: &str, indented: bool) {
        let words: String = words.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
        let (first, next) = if indented { ("##   ", "##       ") } else { ("## ", "## ") };
        let (mut line, mut empty) = (first.to_owned(), true);
        for word in words.split_whitespace() {
            if !empty && line.chars().count() + 1 + word.chars().count() > WIDTH {
                self.text += &format!("{line}\n");
                (line, empty) = (next.to_owned(), true);
            }
            if !empty {
                line.push(' ');
            }
            line += word;
            empty = false;
        }
        if !empty {
            self.text += &format!("{line}\n");
        }
    }

    fn blank_line(&mut self) {
        if !self.text.is_empty() && !self.text.ends_with("\n\n") && !self.text.ends_with("]\n") {
            self.text.push('\n');
        }
    }
}

/// Returns true if a field of a draft is not written: it is optional, or the gravity of the problem.
fn is_left_out(field: &Field, draft: &Draft) -> bool {
    match draft {
        Draft::Absent => true,
        Draft::Leaf(text) => {
            text.is_empty() && (matches!(field.shape, Shape::Optional(_)) || gravity::is_gravity(field))
        }
        Draft::Rows(rows) => rows.is_empty(),
        _ => false,
    }
}

/// Returns true if a table of these fields has a line of its own.
fn is_written(fields: &'static [Field], drafts: &[Draft]) -> bool {
    fields.iter().zip(drafts).any(|(field, draft)| {
        !is_left_out(field, draft)
            && match (field.shape.present(), draft) {
                (Shape::Group(fields), Draft::Group(drafts)) => is_written(fields(), drafts),
                _ => true,
            }
    })
}

/// Returns true if a list of such items is written on one line.
fn is_inline(item: &Shape) -> bool {
    match item {
        Shape::Rows { item, .. } => is_inline(item()),
        item => item.is_leaf(),
    }
}

/// A list on one line.
fn inline(draft: &Draft) -> String {
    match draft {
        Draft::Rows(rows) => format!("[{}]", rows.iter().map(inline).collect::<Vec<_>>().join(", ")),
        Draft::Leaf(text) => quoted(text),
        _ => String::new(),
    }
}
