//! Tables of studies and of problems in Apache Parquet, read back with the library of its format.

use std::{
    fs::{self, File},
    path::Path,
    sync::Arc,
};

use itertools::zip_eq;
use parquet::{
    basic::{Repetition, Type as PhysicalType},
    data_type::DoubleType,
    file::{
        properties::WriterProperties,
        reader::{FileReader as _, SerializedFileReader},
        writer::SerializedFileWriter,
    },
    record::Field,
    schema::types::Type,
};
use serde_json::Value as Json;

use crate::study::{bytes, example, printed, refused};

/// A study with points that are refused.
const PLAN: [&str; 7] =
    ["fan.toml", "--vary", "mass=-10 kg..90 kg:9001", "--answers", "amplitude,phase", "--threads", "2"];

fn with<'a>(more: &[&'a str]) -> Vec<&'a str> {
    [&PLAN[..], more].concat()
}

/// The metadata of a file, its headings and its rows: numbers, and the reason of a refusal.
fn read(path: &Path) -> (Json, Vec<String>, Vec<(Vec<Option<f64>>, Option<String>)>) {
    let reader = SerializedFileReader::new(File::open(path).expect("a file")).expect("a Parquet file");
    let file = reader.metadata().file_metadata();
    let metadata = file.key_value_metadata().expect("metadata").iter().find(|pair| pair.key == "dalembert");
    let metadata = metadata.and_then(|pair| pair.value.as_deref()).expect("metadata of ours");
    let headings = file.schema_descr().columns().iter().map(|column| column.path().string()).collect();
    let row = |row: Result<parquet::record::Row, _>| {
        let row = row.expect("a row");
        let (mut numbers, mut refusal) = (Vec::new(), None);
        for (name, field) in row.get_column_iter() {
            match field {
                Field::Double(number) => numbers.push(Some(*number)),
                Field::Str(why) if name == "refusal" => refusal = Some(why.clone()),
                Field::Null if name == "refusal" => {}
                Field::Null => numbers.push(None),
                other => panic!("{name} is {other}"),
            }
        }
        (numbers, refusal)
    };
    let rows = reader.get_row_iter(None).expect("rows").map(row).collect();
    (serde_json::from_str(metadata).expect("JSON"), headings, rows)
}

#[test]
fn a_parquet_table_has_the_numbers_reasons_and_units_of_the_csv_table() {
    let folder = example();
    let summary = printed(folder.path(), &with(&["-o", "table.csv"]));
    assert_eq!(summary, printed(folder.path(), &with(&["-o", "table.parquet"])));
    assert!(!folder.path().join("table.parquet.csv").exists());
    let csv = String::from_utf8(bytes(folder.path(), "table.csv")).expect("UTF-8");
    let lines: Vec<&str> = csv.lines().collect();
    let (metadata, headings, rows) = read(&folder.path().join("table.parquet"));
    assert_eq!(headings.join(","), lines[3]);
    assert_eq!(metadata["plan"], lines[1].strip_prefix("# plan ").expect("a fingerprint"));
    assert_eq!(metadata["points"], 9001);
    let columns = serde_json::json!([
        { "name": "mass", "unit": "kg", "symbol": "m", "role": "input" },
        { "name": "amplitude", "unit": "mm", "role": "answer" },
        { "name": "phase", "unit": "deg", "role": "answer" },
    ]);
    assert_eq!(metadata["columns"], columns);
    for (line, (numbers, refusal)) in zip_eq(&lines[4..], &rows) {
        let cells: Vec<&str> = line.splitn(4, ',').collect();
        for (cell, number) in zip_eq(&cells[..3], numbers) {
            assert_eq!(cell.parse().ok().map(f64::to_bits), number.map(f64::to_bits), "{line}");
        }
        assert_eq!(refusal.as_deref().unwrap_or_default(), cells[3].trim_matches('"'), "{line}");
    }
    assert!(rows[0].1.as_deref().is_some_and(|why| why.starts_with("mass: must be above zero")), "{rows:?}");
}

#[test]
fn a_parquet_table_is_the_same_resumed_and_from_shards() {
    let folder = example();
    let summary = printed(folder.path(), &with(&["-o", "whole.parquet"]));
    let whole = bytes(folder.path(), "whole.parquet");
    printed(folder.path(), &with(&["-o", "rows.csv"]));
    let rows = bytes(folder.path(), "rows.csv");
    let at = folder.path();
    // Broken off among the rows, and between the last of them and the conversion.
    fs::write(at.join("broken.parquet.csv.part"), &rows[..rows.len() / 2]).expect("a file");
    assert_eq!(summary, printed(at, &with(&["-o", "broken.parquet"])));
    fs::write(at.join("late.parquet.csv"), &rows).expect("a file");
    assert_eq!(summary, printed(at, &with(&["-o", "late.parquet"])));
    for shard in ["1/3", "3/3", "2/3"] {
        printed(at, &with(&["-o", "parts.parquet", "--shard", shard]));
    }
    assert!(at.join("parts.parquet.shard-2-of-3.csv").exists());
    assert_eq!(summary, printed(at, &with(&["-o", "parts.parquet", "--merge"])));
    for name in ["broken.parquet", "late.parquet", "parts.parquet"] {
        assert!(whole == bytes(at, name), "{name} differs");
    }
    // Rows of another plan are not converted.
    fs::write(at.join("other.parquet.csv"), &rows).expect("a file");
    let (why, _) = refused(at, &with(&["-o", "other.parquet", "--seed", "7"]));
    assert!(why.contains("other.parquet.csv is of another plan"), "{why}");
}

/// Writes columns of numbers.
fn write(path: &Path, columns: &[(&str, Vec<f64>)]) {
    let field = |(name, _): &(&str, Vec<f64>)| {
        let field = Type::primitive_type_builder(name, PhysicalType::DOUBLE);
        Arc::new(field.with_repetition(Repetition::REQUIRED).build().expect("a column"))
    };
    let schema = Type::group_type_builder("measured").with_fields(columns.iter().map(field).collect());
    let properties = Arc::new(WriterProperties::builder().build());
    let file = File::create(path).expect("a file");
    let schema = Arc::new(schema.build().expect("a schema"));
    let mut writer = SerializedFileWriter::new(file, schema, properties).expect("a writer");
    let mut group = writer.next_row_group().expect("a group");
    for (_, numbers) in columns {
        let mut column = group.next_column().expect("a column").expect("a column");
        column.typed::<DoubleType>().write_batch(numbers, None, None).expect("numbers");
        column.close().expect("a column");
    }
    group.close().expect("a group");
    writer.close().expect("a file");
}

fn write_csv(path: &Path, columns: &[(&str, Vec<f64>)]) {
    let headings: Vec<&str> = columns.iter().map(|(name, _)| *name).collect();
    let mut text = headings.join(",") + "\n";
    for row in 0..columns[0].1.len() {
        let cells: Vec<String> = columns.iter().map(|(_, numbers)| numbers[row].to_string()).collect();
        text += &(cells.join(",") + "\n");
    }
    fs::write(path, text).expect("a file");
}

#[test]
fn a_plan_reads_points_and_measured_values_from_parquet() {
    let folder = example();
    let points = [("mass [g]", vec![40000.0, 41500.5]), ("speed [rpm]", vec![900.0, 951.25])];
    let young = [("E [GPa]", vec![198.0, 200.5, 203.0])];
    for (kind, write) in [("csv", write_csv as fn(&Path, &[(&str, Vec<f64>)])), ("parquet", write)] {
        write(&folder.path().join(format!("points.{kind}")), &points);
        write(&folder.path().join(format!("young.{kind}")), &young);
        let plan = format!(
            "problem = \"fan.toml\"\nanswers = [\"amplitude\"]\nsamples = 50\n[[vary]]\ntable = \"points.{kind}\"\n[[vary]]\ninput = \"support.cantilever.young\"\ndistribution = \"data\"\ndata = \"young.{kind}\"\n"
        );
        fs::write(folder.path().join(format!("{kind}.toml")), plan).expect("a plan");
        printed(folder.path(), &[&format!("{kind}.toml"), "-o", &format!("{kind}.csv")]);
    }
    let rows = |name: &str| {
        let table = String::from_utf8(bytes(folder.path(), name)).expect("UTF-8");
        table.lines().skip(3).map(str::to_owned).collect::<Vec<_>>()
    };
    assert_eq!(rows("csv.csv").len(), 101);
    assert_eq!(rows("csv.csv"), rows("parquet.csv"));
    write(&folder.path().join("points.parquet"), &[("mass [g]", vec![40000.0, f64::NAN])]);
    let (why, status) = refused(folder.path(), &["parquet.toml"]);
    assert!(why.contains("points.parquet: row 2: `mass [g]` is not a number") && status == Some(2), "{why}");
}

#[test]
fn a_table_of_a_problem_is_read_from_parquet_with_its_units() {
    let folder = example();
    let time: Vec<f64> = (0..300).map(|n| 5.0 * f64::from(n)).collect();
    let decay = |t: &f64| 1000.0 * (-t / 4000.0).exp() * (t / 80.0).cos();
    let measured = [("t [ms]", time.clone()), ("x [um]", time.iter().map(decay).collect())];
    write(&folder.path().join("decay.parquet"), &measured);
    write_csv(&folder.path().join("decay.csv"), &measured);
    let solved = |name: &str| {
        let table = format!("record.samples.samples=@{name}");
        let mut command = crate::program();
        command.current_dir(folder.path()).args(["solve", "vibration/decay-identification", "--set"]);
        let output = command.arg(table).args(["--format", "json"]).output().expect("the program runs");
        assert!(output.status.success(), "{name}: {}", String::from_utf8_lossy(&output.stderr));
        serde_json::from_slice::<Json>(&output.stdout).expect("JSON")["answers"].clone()
    };
    let answers = solved("decay.parquet");
    assert_eq!(answers, solved("decay.csv"));
    assert!(!answers.is_null());
}
