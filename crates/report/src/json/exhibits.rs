//! Plots and tables as data, in the units in which they are shown.

use dalembert_core::{Axis, Band, Cell, Level, Locale, Mark, Plot, Scale, Series, TableExhibit};
use dalembert_units::{self as units, Unit};
use serde_json::{Map, Value as Json, json};

use super::written;

/// A plot: what it is over, its axes, the drawn points of its curves, and what is named in it.
pub(super) fn plot(plot: &Plot, locale: &Locale) -> Json {
    let (x, y) = (unit_of(plot.x.unit), unit_of(plot.y.unit));
    let curve = |series: &Series| {
        let with: Map<String, Json> =
            series.with.iter().map(|(input, si)| (input.clone(), json!(si))).collect();
        json!({
            "label": series.label.render(locale),
            "of": series.of,
            "with": with,
            "joined": series.joined,
            "x": series.points.iter().map(|(at, _)| x.value(*at)).collect::<Vec<_>>(),
            "y": series.points.iter().map(|(_, at)| y.value(*at)).collect::<Vec<_>>(),
        })
    };
    let mark = |mark: &Mark| json!({ "label": mark.label.render(locale), "x": x.value(mark.at.0), "y": y.value(mark.at.1) });
    let band = |band: &Band| {
        json!({
            "label": band.label.render(locale),
            "from": x.value(band.from),
            "to": x.value(band.to),
            "permitted": band.permitted,
        })
    };
    let level = |level: &Level| json!({ "label": level.label.render(locale), "y": y.value(level.y) });
    json!({
        "title": plot.title.render(locale),
        "over": plot.over.as_ref().map(|over| json!({ "input": over.input, "answer": over.answer })),
        "x": axis(&plot.x, locale),
        "y": axis(&plot.y, locale),
        "curves": plot.series.iter().map(curve).collect::<Vec<_>>(),
        "marks": plot.marks.iter().map(mark).collect::<Vec<_>>(),
        "bands": plot.bands.iter().map(band).collect::<Vec<_>>(),
        "levels": plot.levels.iter().map(level).collect::<Vec<_>>(),
    })
}

fn axis(axis: &Axis, locale: &Locale) -> Json {
    let scale = match axis.scale {
        Scale::Linear => "linear",
        Scale::Log => "log",
    };
    json!({ "label": axis.label.render(locale), "unit": written(&unit_of(axis.unit)), "scale": scale })
}

/// A table by its columns: heading, unit, cells from top to bottom.
pub(super) fn table(table: &TableExhibit, locale: &Locale) -> Json {
    let column = |(at, column): (usize, &dalembert_core::Column)| {
        let unit = unit_of(column.unit);
        let cell = |row: &Vec<Cell>| match row.get(at) {
            None | Some(Cell::Empty) => Json::Null,
            Some(Cell::Number(si)) => json!(unit.value(*si)),
            Some(Cell::Text(text)) => text.render(locale).into(),
        };
        json!({
            "heading": column.heading.render(locale),
            "unit": written(&unit),
            "cells": table.rows.iter().map(cell).collect::<Vec<_>>(),
            "foot": cell(&table.foot),
        })
    };
    json!({
        "title": table.title.render(locale),
        "columns": table.columns.iter().enumerate().map(column).collect::<Vec<_>>(),
    })
}

fn unit_of(text: &str) -> Unit {
    units::unit(text).unwrap_or(Unit::ONE)
}
