//! Variables of MATLAB's files of version 5, which MATLAB, Octave and SciPy write by default.

mod elements;

use dalembert_core::{Text, study::DataColumn};

use self::elements::{Content, Variable, variables};
use crate::{
    numbers,
    part::{Part, number},
};

/// Variables that an error lists.
const MOST_LISTED: usize = 20;

/// The text of a table of so many columns from variables: `signal`, its columns `signal!1,3`, several vectors `t,x`,
/// fields of a structure `run.t,run.x`. Without any, the only matrix that has as many columns.
///
/// Errors: what is no such file; a variable that there is not, or that has no real numbers; several that may be meant.
pub(crate) fn table(bytes: &[u8], part: &Part, wanted: usize) -> Result<String, Text> {
    let variables = variables(bytes)?;
    let chosen: Vec<DataColumn> = match chosen(part)? {
        chosen if chosen.is_empty() => columns(only(&variables, wanted)?, &[])?,
        chosen => {
            let mut all = Vec::new();
            for (name, places) in &chosen {
                all.extend(columns(named(&variables, name)?, places)?);
            }
            all
        }
    };
    if chosen.len() != wanted {
        let why = Text::new(
            "{have} columns are chosen and the table takes {want}: name vectors or columns, as in `#t,x` or `#signal!1,3`; the file has {variables}",
        );
        let why = why.with("have", chosen.len()).with("want", wanted);
        return Err(why.with("variables", listed(&variables)));
    }
    numbers::text(&chosen)
}

/// Names with the numbers of their columns: digits behind a `!` belong to the name before.
fn chosen(part: &Part) -> Result<Vec<(&str, Vec<usize>)>, Text> {
    let mut chosen: Vec<(&str, Vec<usize>)> = Vec::new();
    for item in part.items() {
        match (item.split_once('!'), chosen.last_mut()) {
            (Some((name, column)), _) => chosen.push((name.trim(), vec![number(column)?])),
            (None, Some((_, columns)))
                if !columns.is_empty() && item.bytes().all(|byte| byte.is_ascii_digit()) =>
            {
                columns.push(number(item)?);
            }
            (None, _) => chosen.push((item, Vec::new())),
        }
    }
    Ok(chosen)
}

/// The variable that alone has as many columns as are wanted, and more than one row.
fn only(variables: &[Variable], wanted: usize) -> Result<&Variable, Text> {
    let fits = |variable: &&Variable| match &variable.content {
        Content::Numbers { rows, columns, .. } => *rows > 1 && *columns == wanted,
        Content::Other(_) => false,
    };
    let mut fitting = variables.iter().filter(fits);
    match (fitting.next(), fitting.next()) {
        (Some(variable), None) => Ok(variable),
        _ => {
            let why = Text::new(
                "name the variables of this file to take, as in `#signal` or `#t,x`: it has {variables}",
            );
            Err(why.with("variables", listed(variables)))
        }
    }
}

fn named<'v>(variables: &'v [Variable], name: &str) -> Result<&'v Variable, Text> {
    variables.iter().find(|variable| variable.name == name).ok_or_else(|| {
        Text::new("there is no variable `{name}`; this file has {variables}")
            .with("name", name)
            .with("variables", listed(variables))
    })
}

/// The chosen columns of a variable, or all; a row alone is a column.
fn columns(variable: &Variable, chosen: &[usize]) -> Result<Vec<DataColumn>, Text> {
    let name = &variable.name;
    let (rows, width, numbers) = match &variable.content {
        Content::Numbers { rows: 1, columns, numbers } => (*columns, 1, numbers),
        Content::Numbers { rows, columns, numbers } => (*rows, *columns, numbers),
        Content::Other(what) => {
            let why = Text::new("`{name}` is {what}: save it as a matrix of real numbers");
            return Err(why.with("name", name).with_text("what", *what));
        }
    };
    let all: Vec<usize> = (1..=width).collect();
    let places = if chosen.is_empty() { &all } else { chosen };
    let one = |at: &usize| {
        let from = (at - 1).checked_mul(rows).filter(|_| *at <= width);
        let column = from.and_then(|from| numbers.get(from..from + rows)).ok_or_else(|| {
            Text::new("`{name}` has {have} columns; column {last} is asked for")
                .with("name", name)
                .with("have", width)
                .with("last", at)
        })?;
        let name = if width == 1 { name.clone() } else { format!("{name} {at}") };
        Ok(DataColumn { name, unit: String::new(), numbers: column.to_vec() })
    };
    places.iter().map(one).collect()
}

/// Names and sizes of variables.
fn listed(variables: &[Variable]) -> String {
    let one = |variable: &Variable| match &variable.content {
        Content::Numbers { rows, columns, .. } => format!("`{}` {rows}×{columns}", variable.name),
        Content::Other(_) => format!("`{}`", variable.name),
    };
    let mut list: Vec<String> = variables.iter().take(MOST_LISTED).map(one).collect();
    if variables.len() > MOST_LISTED {
        list.push("…".to_owned());
    }
    list.join(", ")
}
