//! How much each input matters for an answer: bars, the most influential first.

use dalembert_core::{
    Locale, Solution, Text,
    sensitivity::{Influence, Sensitivity},
};
use dalembert_units::{Unit, write_number, write_quantity};
use ratatui::{
    style::Style,
    text::{Line, Span},
};
use unicode_width::UnicodeWidthStr;

use super::{Page, check::typed_in, columns::padded, results, wrap};
use crate::{
    ask::Ask,
    glyphs::filter_untrusted,
    look::{Glyph, Look},
    tab::Tab,
};

/// Cells of a tolerance.
const TOLERANCE: usize = 6;
/// Cells that bars have at least, where labels can be shortened for them.
const BAR: usize = 6;
/// Cells of the change for 1 %.
const CHANGE: usize = 8;

/// The influences on the chosen answer; the page starts at each input.
pub fn page(solution: &Solution, ask: &Ask, focused: bool, look: &Look, locale: &Locale, width: u16) -> Page {
    let cells = usize::from(width).max(1);
    let locale = &locale.ascii(look.ascii);
    let mut page = Page::default();
    let (answers, at) = ask.sensitivity.answers(solution);
    let Some(answer) = answers.get(at) else { return page };
    let title = format!("{} {} {}", look.glyph(Glyph::Left), answer.label(locale), look.glyph(Glyph::Right));
    let title = format!("{title}  {}", answer.shown(locale));
    page.lines.extend(wrap::words(&title, cells).into_iter().map(|line| Line::styled(line, look.title())));
    let found = match &ask.sensitivity.found {
        None => {
            let state = if ask.waits(Tab::Sensitivity) { "solving" } else { "cancelled" };
            page.lines.push(Line::styled(Text::new(state).render(locale), look.dim()));
            return page;
        }
        Some(Err(error)) => {
            page.lines.extend(results::refusal(None, error, look, locale, width));
            return page;
        }
        Some(Ok(found)) => found,
    };
    let sorted = ask.sensitivity.sorted();
    let label = sorted.iter().map(|one| one.input.label.render(locale).width()).max().unwrap_or(0);
    let room = cells.saturating_sub(CHANGE + TOLERANCE + 6);
    let label = label.min((cells * 2 / 5).min(room.saturating_sub(BAR)).max(8));
    let bar = room.saturating_sub(label);
    let columns = Columns { label, bar, cells };
    // What is changed by degrees is distinguished from what is changed by shares.
    let step =
        if sorted.iter().any(|one| one.input.step_text() != "1 %") { "for +1 % or +1°" } else { "for +1 %" };
    let left = columns.label + columns.bar + CHANGE + 4;
    let heading =
        format!("{:>left$}  {}", Text::new(step).render(locale), Text::new("± tol.").render(locale));
    page.lines.push(Line::styled(look.shortened(&plus_minus(&heading, look), cells), look.dim()));
    let most =
        sorted.iter().map(|one| one.change(found.value).abs()).filter(|x| x.is_finite()).fold(0.0, f64::max);
    for (n, one) in sorted.iter().enumerate() {
        page.starts.push(page.lines.len());
        let under_cursor = n == ask.sensitivity.cursor.min(sorted.len() - 1);
        let row = Row { one, found, most, under_cursor: focused && under_cursor, ask };
        page.lines.push(row.line(&columns, look, locale));
        if focused && under_cursor {
            row.details(&answer.unit, &columns, look, locale, &mut page.lines);
        }
    }
    page.lines.push(Line::default());
    if ask.waits(Tab::Sensitivity) {
        page.lines.push(Line::styled(Text::new("solving").render(locale), look.dim()));
        return page;
    }
    let written = |si: f64, digits| {
        write_quantity(si, &answer.unit, locale.digits(digits).style).replace(' ', "\u{A0}")
    };
    let together = Text::new(
        "all tolerances: {least} to {most} in the worst case, ± {likely} as root-sum-square (independent)",
    )
    .with("least", written(found.spread.worst[0], 4))
    .with("most", written(found.spread.worst[1], 4))
    .with("likely", written(found.spread.likely, 3));
    let together = plus_minus(&together.render(locale), look);
    page.lines.extend(wrap::words(&together, cells).into_iter().map(Line::from));
    page
}

/// `±`, also where there is no such sign.
fn plus_minus(text: &str, look: &Look) -> String {
    if look.ascii { text.replace('±', "+/-") } else { text.to_owned() }
}

struct Columns {
    label: usize,
    bar: usize,
    cells: usize,
}

struct Row<'a> {
    one: &'a Influence,
    found: &'a Sensitivity,
    /// The largest change of all.
    most: f64,
    under_cursor: bool,
    ask: &'a Ask,
}

impl Row<'_> {
    fn line(&self, columns: &Columns, look: &Look, locale: &Locale) -> Line<'static> {
        let pointer = if self.under_cursor { look.glyph(Glyph::Pointer) } else { " " };
        let label = look.shortened(&self.one.input.label.render(locale), columns.label);
        let change = self.one.change(self.found.value);
        let relative = change / self.found.value.abs();
        let shown = if self.found.value == 0.0 || !relative.is_finite() {
            look.glyph(Glyph::Ellipsis).to_owned()
        } else {
            let sign = if relative > 0.0 { "+" } else { "" };
            format!("{sign}{} %", write_number(100.0 * relative, locale.digits(2).style))
        };
        let share = if self.most > 0.0 && change.is_finite() { change.abs() / self.most } else { 0.0 };
        let full = (share * columns.bar as f64).round() as usize;
        let glyph = match (look.ascii, change < 0.0) {
            (true, true) => "-",
            (true, false) => "+",
            (false, true) => "▒",
            (false, false) => "█",
        };
        let style = if change < 0.0 { look.series(1) } else { look.series(0) };
        let mut line = Line::from(vec![
            Span::styled(format!("{pointer} "), look.border(self.under_cursor)),
            Span::styled(
                padded(&label, columns.label),
                if self.under_cursor { look.title() } else { Style::new() },
            ),
            Span::raw("  "),
            Span::styled(padded(&glyph.repeat(full), columns.bar), style),
            Span::raw(format!("{}{shown}  ", " ".repeat(CHANGE.saturating_sub(shown.width())))),
        ]);
        match self.ask.edit.as_ref().filter(|_| self.under_cursor) {
            Some(input) => line.extend(typed_in(input, TOLERANCE)),
            None => {
                let typed = self.ask.sensitivity.text(&self.one.input.path);
                let (text, style) = match typed.trim() {
                    "" => (self.one.input.step_text().to_owned(), look.dim()),
                    typed => (filter_untrusted(typed).into_owned(), Style::new()),
                };
                let style = if self.under_cursor { look.focus() } else { style };
                line.push_span(Span::styled(padded(&look.shortened(&text, TOLERANCE), TOLERANCE), style));
            }
        }
        line
    }

    /// What is said of the input under the cursor.
    fn details(
        &self,
        answer: &Unit,
        columns: &Columns,
        look: &Look,
        locale: &Locale,
        lines: &mut Vec<Line<'static>>,
    ) {
        let mut say = |text: Text, style: Style| {
            lines.extend(wrap::hanging(vec![Span::raw("    ")], &text.render(locale), style, columns.cells));
        };
        let (one, value) = (self.one, self.found.value);
        let elasticity = one.elasticity(value);
        if elasticity.is_finite() {
            let elasticity = write_number(elasticity, locale.digits(4).style);
            say(Text::new("elasticity {elasticity}").with("elasticity", elasticity), look.dim());
        }
        if one.derivative.is_finite() {
            let number =
                write_number(one.derivative * one.input.unit.factor / answer.factor, locale.digits(4).style);
            say(
                Text::new("derivative {number} {unit}").with("number", number).with("unit", one.unit(answer)),
                look.dim(),
            );
        }
        let written = |x: f64| {
            if x.is_finite() {
                write_quantity(x, answer, locale.style)
            } else {
                look.glyph(Glyph::Ellipsis).to_owned()
            }
        };
        let sides = Text::new("with −{step}: {less}; with +{step}: {more}")
            .with("step", one.input.step_text())
            .with("less", written(one.sides[0]))
            .with("more", written(one.sides[1]));
        say(sides, look.dim());
        if one.has_kink(value) {
            say(Text::new("asymmetric effect"), look.warning());
        }
        if let Some(why) = &one.refused {
            say(Text::new("no answer on one side: {why}").with_text("why", why.clone()), look.warning());
        }
        let typed = self.ask.sensitivity.text(&one.input.path);
        if let Err(why) = one.input.tolerance(typed)
            && !typed.trim().is_empty()
        {
            say(why, look.error());
        }
    }
}
