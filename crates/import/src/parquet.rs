//! Columns of numbers of Parquet files.

use bytes::Bytes;
use dalembert_core::{Text, study::DataColumn};
use parquet::{
    basic::Type as PhysicalType,
    errors::ParquetError,
    file::reader::{FileReader as _, SerializedFileReader},
    record::Field,
};

use crate::{
    numbers,
    part::{Part, number as place_number},
};

/// The text of a table of so many columns: the chosen ones by number or name, or all.
pub(crate) fn table(bytes: Vec<u8>, part: &Part, wanted: usize) -> Result<String, Text> {
    let all = parquet_columns(bytes)?;
    let listed = || {
        let names: Vec<String> = all.iter().map(|column| format!("`{}`", column.heading())).collect();
        names.join(", ")
    };
    let place = |item: &str| {
        let by_name = all.iter().position(|column| column.name == item || column.heading() == item);
        let by_number = || place_number(item).ok().map(|n| n - 1).filter(|at| *at < all.len());
        by_name.or_else(by_number).ok_or_else(|| {
            Text::new("there is no column `{name}`; this file has {columns}")
                .with("name", item)
                .with("columns", listed())
        })
    };
    let mut chosen: Vec<usize> = part.items().map(place).collect::<Result<_, _>>()?;
    if chosen.is_empty() {
        if all.len() > wanted {
            let why = Text::new(
                "this file has {have} columns of numbers and the table {want}: name the columns to take, as in `#1,2`; it has {columns}",
            );
            return Err(why.with("have", all.len()).with("want", wanted).with("columns", listed()));
        }
        chosen = (0..all.len()).collect();
    }
    numbers::text(&chosen.into_iter().map(|at| all[at].clone()).collect::<Vec<_>>())
}

/// The columns of numbers of a Parquet file under their headings, `mass [kg]`; columns of texts are left out.
///
/// # Errors
/// Why the file cannot be read, with the row of a cell without a number.
pub fn parquet_columns(bytes: Vec<u8>) -> Result<Vec<DataColumn>, Text> {
    let broken = |error: ParquetError| Text::verbatim(error);
    let reader = SerializedFileReader::new(Bytes::from(bytes)).map_err(broken)?;
    let schema = reader.metadata().file_metadata().schema_descr();
    let is_text =
        |physical| matches!(physical, PhysicalType::BYTE_ARRAY | PhysicalType::FIXED_LEN_BYTE_ARRAY);
    let mut columns: Vec<Option<DataColumn>> = schema
        .columns()
        .iter()
        .map(|column| (!is_text(column.physical_type())).then(|| DataColumn::headed(&column.path().string())))
        .collect();
    for (n, row) in (1..).zip(reader.get_row_iter(None).map_err(broken)?) {
        let row = row.map_err(broken)?;
        for ((name, field), column) in row.get_column_iter().zip(&mut columns) {
            let Some(column) = column else { continue };
            let number = number(field).filter(|number| number.is_finite()).ok_or_else(|| {
                Text::new("row {row}: `{column}` is not a number").with("row", n).with("column", name)
            })?;
            column.numbers.push(number);
        }
    }
    Ok(columns.into_iter().flatten().collect())
}

fn number(field: &Field) -> Option<f64> {
    match field {
        Field::Double(number) => Some(*number),
        Field::Float(number) => Some(f64::from(*number)),
        Field::Byte(number) => Some(f64::from(*number)),
        Field::Short(number) => Some(f64::from(*number)),
        Field::Int(number) => Some(f64::from(*number)),
        Field::Long(number) => Some(*number as f64),
        Field::UByte(number) => Some(f64::from(*number)),
        Field::UShort(number) => Some(f64::from(*number)),
        Field::UInt(number) => Some(f64::from(*number)),
        Field::ULong(number) => Some(*number as f64),
        _ => None,
    }
}
