//! The first rows of a file of a table, with its columns as they are understood.

use dalembert_core::{Text, table::TablePreview};
use dalembert_import::Sample;
use dalembert_units as units;
use ratatui::text::{Line, Span};

use crate::{
    dialog::ImportPreview,
    glyphs::filter_untrusted,
    look::Glyph,
    model::Model,
    text::{fit, width, wrapped},
};

/// Lines of a preview in so many columns of the screen.
pub(super) fn lines(model: &Model, preview: &ImportPreview, room: usize) -> Vec<Line<'static>> {
    let Some((_, table)) = &preview.read else { return to_choose_from(model, &preview.sample, room) };
    let mut lines = understood(model, table, room);
    let hint = Text::new(if table.fault.is_some() {
        "`#1,3` behind the name chooses columns, `#skip=2` leaves lines out"
    } else {
        "Enter takes this table; `#1,3` behind the name chooses columns, `#skip=2` leaves lines out"
    });
    let hint = wrapped(&hint.render(&model.locale), room);
    lines.extend(hint.into_iter().map(|text| Line::styled(text, model.look.dim())));
    lines
}

/// Names and units of the columns over the first rows.
fn understood(model: &Model, table: &TablePreview, room: usize) -> Vec<Line<'static>> {
    let locale = &model.locale;
    let names: Vec<String> =
        table.columns.iter().map(|column| Text::new(column.label).render(locale)).collect();
    let unit = |(unit, assumed): (&str, bool)| match (unit, assumed) {
        ("", _) => "-".to_owned(),
        (unit, true) => Text::new("{unit} assumed").with("unit", unit).render(locale),
        (unit, false) => unit.to_owned(),
    };
    let in_units: Vec<String> =
        table.columns.iter().map(|column| unit((&column.unit, column.assumed))).collect();
    let number = |x: &f64| if x.is_finite() { units::write_number(*x, locale.style) } else { "?".to_owned() };
    let rows: Vec<Vec<String>> = table.rows.iter().map(|row| row.iter().map(number).collect()).collect();
    let (mut all, count) = (vec![names, in_units], rows.len());
    all.extend(rows);
    let mut lines = aligned(model, &all, room);
    for (n, column) in table.columns.iter().enumerate() {
        if column.assumed
            && let Some(span) = lines.get_mut(1).and_then(|line| line.spans.get_mut(n))
        {
            span.style = model.look.warning();
        }
    }
    for line in lines.iter_mut().take(1) {
        line.style = model.look.title();
    }
    let total = Text::new("{rows} rows").with("rows", table.count).render(locale);
    let rest =
        if table.count > count { format!("{} {total}", model.look.glyph(Glyph::Ellipsis)) } else { total };
    lines.push(Line::styled(rest, model.look.dim()));
    if let Some(fault) = &table.fault {
        let text = filter_untrusted(&fault.render(locale)).into_owned();
        lines.extend(wrapped(&text, room).into_iter().map(|text| Line::styled(text, model.look.error())));
    }
    lines
}

/// Names of the columns over the first lines of the file.
fn to_choose_from(model: &Model, sample: &Sample, room: usize) -> Vec<Line<'static>> {
    if sample.rows.is_empty() {
        return Vec::new();
    }
    let cell = |cell: &String| filter_untrusted(cell).replace('\n', "\u{FFFD}");
    let mut all = vec![sample.columns.clone()];
    all.extend(sample.rows.iter().map(|row| row.iter().map(cell).collect()));
    let mut lines = aligned(model, &all, room);
    for line in lines.iter_mut().take(1) {
        line.style = model.look.title();
    }
    lines
}

/// Rows of cells in columns, each as wide as its widest cell.
fn aligned(model: &Model, rows: &[Vec<String>], room: usize) -> Vec<Line<'static>> {
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
    let most = (room / columns.max(1)).saturating_sub(2).max(1);
    let widest =
        |at: usize| rows.iter().filter_map(|row| row.get(at)).map(|cell| width(cell)).max().unwrap_or(0);
    let widths: Vec<usize> = (0..columns).map(|at| widest(at).min(most)).collect();
    let line = |row: &Vec<String>| {
        let cells = row.iter().zip(&widths).map(|(cell, wide)| {
            let cell = fit(cell, *wide, &model.look);
            let blanks = wide + 2 - width(&cell).min(*wide);
            Span::raw(cell + &" ".repeat(blanks))
        });
        Line::from(cells.collect::<Vec<_>>())
    };
    rows.iter().map(line).collect()
}
