//! Plans as files: read, and written over what was in the file, with its comments.

use dalembert_core::{Text, file, study::StudyPlan};
use toml_edit::{DocumentMut, Item, Table};

/// Reads a plan.
///
/// # Errors
/// The part of the text that is no plan, with its line.
pub fn read(text: &str) -> Result<StudyPlan, Text> {
    let is_problem = text.parse::<DocumentMut>().is_ok_and(|document| document.contains_key("analysis"));
    if is_problem {
        return Err(
            "this is a problem file, not a study plan, which names its problem: problem = \"fan.toml\""
                .into(),
        );
    }
    toml::from_str(text).map_err(|error| {
        let why = Text::verbatim(error.message());
        match error.span() {
            Some(span) if span.end > 0 => {
                let line = file::line_of(text, span.start);
                Text::new("line {line}: {why}").with("line", line).with_text("why", why)
            }
            _ => why,
        }
    })
}

/// The text of a plan: what stands in `old`, with the keys that are otherwise now.
///
/// # Errors
/// A plan that cannot be written as TOML.
pub fn write(plan: &StudyPlan, old: &str) -> Result<String, Text> {
    let written = toml::to_string(plan).map_err(Text::verbatim)?;
    let Ok(mut document) = old.parse::<DocumentMut>() else { return Ok(written) };
    let Ok(new) = written.parse::<DocumentMut>() else { return Ok(written) };
    if document.is_empty() {
        return Ok(format!("{old}{written}"));
    }
    merge(document.as_table_mut(), new.as_table());
    let text = document.to_string();
    // Where the order of an unusual file stands in the way, the plan counts.
    let is_same = toml::from_str::<StudyPlan>(&text).is_ok_and(|read| read == *plan);
    Ok(if is_same { text } else { written })
}

/// Makes a table say what another does.
fn merge(old: &mut Table, new: &Table) {
    old.retain(|key, _| new.contains_key(key));
    for (key, value) in new {
        match (old.get_mut(key), value) {
            (Some(Item::ArrayOfTables(old)), Item::ArrayOfTables(new)) => {
                while old.len() > new.len() {
                    old.remove(old.len() - 1);
                }
                for (n, table) in new.iter().enumerate() {
                    match old.get_mut(n) {
                        Some(old) => merge(old, table),
                        None => old.push(table.clone()),
                    }
                }
            }
            (Some(Item::Value(old)), Item::Value(new)) => {
                let parsed =
                    |value: &toml_edit::Value| toml::from_str::<toml::Table>(&format!("value = {value}"));
                if parsed(old) != parsed(new) {
                    let mut new = new.clone();
                    *new.decor_mut() = old.decor().clone();
                    *old = new;
                }
            }
            (Some(old), new) => *old = new.clone(),
            (None, new) => drop(old.insert(key, new.clone())),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FAN: &str = "# Tolerances of a fan\nproblem = \"fan.toml\"\nanswers = [ \"amplitude\" ] # the main one\nsamples = 2000\nsampling = \"latin-hypercube\"\nseed = 1\n\n# of the motor\n[[vary]]\ninput = \"mass\"\ndistribution = \"normal\"\ndeviation = \"2 %\" # weighed\n";

    #[test]
    fn comments_outlive_a_change() {
        let mut plan = read(FAN).unwrap();
        assert_eq!(write(&plan, FAN).unwrap(), FAN);
        plan.samples = Some(4000);
        plan.vary.push(plan.vary[0].clone());
        plan.vary[1].input = Some("speed".into());
        let text = write(&plan, FAN).unwrap();
        assert_eq!(read(&text), Ok(plan.clone()));
        for kept in ["# Tolerances of a fan", "# the main one", "# of the motor", "# weighed", "4000"] {
            assert!(text.contains(kept), "{kept}: {text}");
        }
        plan.vary.clear();
        assert_eq!(read(&write(&plan, &text).unwrap()), Ok(plan.clone()));
        assert_eq!(read(&write(&plan, "").unwrap()), Ok(plan));
    }

    #[test]
    fn what_is_no_plan_is_refused_with_its_line() {
        let of = |text: &str| read(text).unwrap_err().english();
        assert!(
            of("problem = \"fan.toml\"\n[[vary]]\ninput = \"mass\"\nvalue = 3\n")
                .starts_with("line 4: unknown field `value`")
        );
        assert!(of("problem = \"fan.toml\"\nseed = one\n").starts_with("line 2: "));
        assert!(of("analysis = \"vibration/free-vibration\"\n").contains("problem file"));
        assert!(of("").contains("missing field `problem`"));
    }
}
