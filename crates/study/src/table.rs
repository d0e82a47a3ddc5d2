//! Rows of a study as CSV.
//!
//! Above the rows stand lines that begin with `#`, with the version of the program, the fingerprint of plan and problem
//! and the number of points, and the headings: `mass [kg],speed [rpm],amplitude [mm],refusal`. Numbers are in the units
//! of the headings, with the fewest digits that are read as the same number. A cell is empty where there is no answer;
//! the last column says why.

use dalembert_core::{
    Locale, Text,
    study::{Rows, Study, StudyPlan},
};
use sha2::{Digest as _, Sha256};

/// Heading of the column with the reasons.
const REFUSAL: &str = "refusal";

/// The fingerprint of a study: plan, problem and data files as texts, and the version of the program.
pub fn fingerprint(plan: &StudyPlan, problem: &str, data: &[String]) -> String {
    let mut hash = Sha256::new();
    let plan = format!("{plan:?}");
    for text in [env!("CARGO_PKG_VERSION"), &plan, problem].into_iter().chain(data.iter().map(String::as_str))
    {
        hash.update((text.len() as u64).to_le_bytes());
        hash.update(text);
    }
    hash.finalize().iter().take(16).fold(String::new(), |text, byte| text + &format!("{byte:02x}"))
}

/// The lines above the rows. `shard` is one of several, and how many there are.
pub fn header(study: &Study<'_>, fingerprint: &str, shard: Option<(u64, u64)>) -> String {
    let mut lines = format!(
        "# dalembert {} study\n# plan {fingerprint}\n# points {}\n",
        env!("CARGO_PKG_VERSION"),
        study.design.points()
    );
    if let Some((shard, of)) = shard {
        lines += &format!("# shard {shard} of {of}\n");
    }
    let headings: Vec<String> = headings(study).iter().map(|heading| quoted(heading)).collect();
    lines + &headings.join(",") + "\n"
}

/// The headings of the columns: inputs, answers, and the reasons of refusals.
pub fn headings(study: &Study<'_>) -> Vec<String> {
    let inputs = study.design.inputs.iter().map(|input| heading(&input.path, &input.unit.ascii()));
    let answers = study.answers.iter().map(|answer| heading(&answer.name.to_string(), &answer.unit.ascii()));
    inputs.chain(answers).chain([REFUSAL.to_owned()]).collect()
}

fn heading(name: &str, unit: &str) -> String {
    if unit.is_empty() { name.to_owned() } else { format!("{name} [{unit}]") }
}

/// A text as a cell, on one line.
fn quoted(text: &str) -> String {
    let text = text.replace(['\n', '\r'], " ");
    if text.contains([',', '"', '#']) { format!("\"{}\"", text.replace('"', "\"\"")) } else { text }
}

/// Appends rows to a text.
pub fn write_rows(text: &mut String, rows: &Rows, locale: &Locale) {
    let mut buffer = ryu::Buffer::new();
    for row in rows.iter() {
        for number in row.inputs.iter().chain(row.answers) {
            if number.is_finite() {
                let written = buffer.format_finite(*number);
                *text += written.strip_suffix(".0").unwrap_or(written);
            }
            text.push(',');
        }
        if let Some(why) = row.refusal {
            *text += &quoted(&why.render(locale));
        }
        text.push('\n');
    }
}

/// Row that was read back.
#[derive(Debug, Default)]
pub struct ReadRow {
    /// Inputs and answers; NaN where a cell is empty.
    pub numbers: Vec<f64>,
    /// Reason of a refusal.
    pub refusal: Option<Text>,
}

/// A reader of the rows below a header.
pub fn rows_of<R: std::io::Read>(rows: R) -> csv::Reader<R> {
    csv::ReaderBuilder::new().has_headers(false).buffer_capacity(1 << 16).from_reader(rows)
}

/// Reads a record of so many numbers and a reason; `None` where it is no such one.
pub fn read_row(record: &csv::StringRecord, numbers: usize, row: &mut ReadRow) -> Option<()> {
    if record.len() != numbers + 1 {
        return None;
    }
    row.numbers.clear();
    for cell in record.iter().take(numbers) {
        row.numbers.push(if cell.is_empty() { f64::NAN } else { cell.parse().ok()? });
    }
    row.refusal = Some(&record[numbers]).filter(|why| !why.is_empty()).map(Text::verbatim);
    Some(())
}
