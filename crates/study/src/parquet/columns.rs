//! Columns of Parquet files.
//!
//! The columns of a table are named by the headings of its CSV file and hold doubles, null where there is no answer; the
//! last one holds the reasons of refusals. The metadata `dalembert` of the file is a JSON object with the version of the
//! program, the fingerprint of the plan, the number of points, and name, unit, symbol and role of each column.

use std::{fs::File, path::Path, sync::Arc};

use dalembert_core::{Text, study::DataColumn};
use parquet::{
    basic::{Compression, LogicalType, Repetition, Type as PhysicalType},
    data_type::{ByteArray, ByteArrayType, DoubleType},
    errors::ParquetError,
    file::{metadata::KeyValue, properties::WriterProperties, writer::SerializedFileWriter},
    schema::types::Type,
};
use serde_json::json;

use super::rows_of;
use crate::{
    StudyError,
    output::Run,
    table::{self, ReadRow},
};

/// Key of the metadata of a file.
const METADATA: &str = "dalembert";
/// Rows of a row group.
const GROUP: usize = 1 << 17;

/// The columns of numbers of a Parquet file under their headings, `mass [kg]`; columns of texts are left out.
///
/// # Errors
/// Why the file cannot be read, with the row of a cell without a number.
pub fn read(path: &Path) -> Result<Vec<DataColumn>, Text> {
    dalembert_import::parquet_columns(std::fs::read(path).map_err(Text::verbatim)?)
}

/// Converts the [rows](rows_of) of a table that are whole, and takes their CSV file away.
///
/// # Errors
/// A file that cannot be read or written, or is of another plan.
pub fn write(run: &Run<'_>, table: &Path) -> Result<(), StudyError> {
    let rows = rows_of(table);
    let mut part = table.as_os_str().to_owned();
    part.push(".part");
    let file = File::create(&part).map_err(StudyError::of_file(&part))?;
    let failed = |error: ParquetError| StudyError::of_file(&part)(std::io::Error::other(error));
    let mut table_writer = TableWriter::new(run, file).map_err(failed)?;
    let mut written = Ok(());
    run.rows(&rows, None, &mut |row| {
        if written.is_ok() {
            written = table_writer.push(row);
        }
    })?;
    written.and_then(|()| table_writer.finish()).map_err(failed)?;
    std::fs::rename(&part, table).map_err(StudyError::of_file(table))?;
    std::fs::remove_file(&rows).map_err(StudyError::of_file(&rows))
}

/// Rows on their way into a file.
struct TableWriter {
    writer: SerializedFileWriter<File>,
    /// The numbers of the present group, a column each, NaN where there is none.
    numbers: Vec<Vec<f64>>,
    refusals: Vec<Option<String>>,
}

impl TableWriter {
    fn new(run: &Run<'_>, file: File) -> Result<Self, ParquetError> {
        let mut headings = table::headings(run.study);
        let refusal = headings.pop().unwrap_or_default();
        let mut fields = Vec::new();
        for heading in &headings {
            let field = Type::primitive_type_builder(heading, PhysicalType::DOUBLE);
            fields.push(Arc::new(field.with_repetition(Repetition::OPTIONAL).build()?));
        }
        let reason = Type::primitive_type_builder(&refusal, PhysicalType::BYTE_ARRAY)
            .with_repetition(Repetition::OPTIONAL)
            .with_logical_type(Some(LogicalType::String));
        fields.push(Arc::new(reason.build()?));
        let schema = Type::group_type_builder("study").with_fields(fields).build()?;
        let properties = WriterProperties::builder()
            .set_created_by(format!("dalembert {}", env!("CARGO_PKG_VERSION")))
            .set_compression(Compression::SNAPPY)
            .set_key_value_metadata(Some(vec![KeyValue::new(METADATA.to_owned(), metadata(run))]))
            .build();
        Ok(Self {
            writer: SerializedFileWriter::new(file, Arc::new(schema), Arc::new(properties))?,
            numbers: vec![Vec::new(); headings.len()],
            refusals: Vec::new(),
        })
    }

    fn push(&mut self, row: &ReadRow) -> Result<(), ParquetError> {
        for (column, number) in self.numbers.iter_mut().zip(&row.numbers) {
            column.push(*number);
        }
        self.refusals.push(row.refusal.as_ref().map(Text::english));
        if self.refusals.len() == GROUP { self.write_group() } else { Ok(()) }
    }

    fn write_group(&mut self) -> Result<(), ParquetError> {
        let mut group = self.writer.next_row_group()?;
        for column in &mut self.numbers {
            let levels: Vec<i16> = column.iter().map(|number| i16::from(number.is_finite())).collect();
            column.retain(|number| number.is_finite());
            let mut writer = group.next_column()?.ok_or_else(missing)?;
            writer.typed::<DoubleType>().write_batch(column, Some(&levels), None)?;
            writer.close()?;
            column.clear();
        }
        let levels: Vec<i16> = self.refusals.iter().map(|why| i16::from(why.is_some())).collect();
        let reasons: Vec<ByteArray> =
            self.refusals.drain(..).flatten().map(|why| ByteArray::from(why.into_bytes())).collect();
        let mut writer = group.next_column()?.ok_or_else(missing)?;
        writer.typed::<ByteArrayType>().write_batch(&reasons, Some(&levels), None)?;
        writer.close()?;
        group.close()?;
        Ok(())
    }

    fn finish(mut self) -> Result<(), ParquetError> {
        if !self.refusals.is_empty() {
            self.write_group()?;
        }
        let file = self.writer.into_inner()?;
        file.sync_all()?;
        Ok(())
    }
}

fn missing() -> ParquetError {
    ParquetError::General("a row group has fewer columns than its schema".to_owned())
}

/// Version, plan and columns as JSON.
fn metadata(run: &Run<'_>) -> String {
    let inputs = run.study.design.inputs.iter().map(|input| {
        json!({ "name": input.path, "unit": input.unit.ascii(), "symbol": input.symbol, "role": "input" })
    });
    let answers = run.study.answers.iter().map(
        |answer| json!({ "name": answer.name.to_string(), "unit": answer.unit.ascii(), "role": "answer" }),
    );
    let columns: Vec<_> = inputs.chain(answers).collect();
    json!({
        "version": env!("CARGO_PKG_VERSION"),
        "plan": run.fingerprint,
        "points": run.study.design.points(),
        "columns": columns,
    })
    .to_string()
}
