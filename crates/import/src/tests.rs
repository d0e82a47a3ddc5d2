use std::path::Path;

use dalembert_core::{Field, Inputs, Shape};

use crate::{Sample, table};

/// A point of a motion.
#[derive(Clone, Debug, Inputs)]
struct Motion {
    /// Time.
    #[input("t", "s")]
    time: f64,
    /// Displacement.
    #[input("x", "mm")]
    displacement: f64,
}

/// Columns of a table of times and displacements.
pub(crate) fn fields() -> &'static [Field] {
    match Motion::SHAPE {
        Shape::Group(fields) => fields(),
        _ => &[],
    }
}

fn refusal(name: &str, bytes: &[u8], part: Option<&str>) -> String {
    match table(Path::new(name), bytes.to_vec(), part, fields()) {
        Ok(text) => panic!("{name} is read: {text}"),
        Err(why) => why.english(),
    }
}

#[test]
fn formats_that_are_not_read_are_named_with_the_repair() {
    let hdf: &[u8] = b"\x89HDF\r\n\x1A\n and so on";
    for (name, bytes, words) in [
        ("run.mat", hdf, "-v7"),
        ("run.h5", hdf, "HDF5"),
        ("run.mat", b"\0\0\0\0 version 4", "-v7"),
        ("run.xls", b"\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1", ".xlsx"),
        ("run.csv.gz", b"\x1F\x8B\x08", "unpack"),
        ("run.zip", b"PK\x03\x04\x14", "unpack"),
        ("run.wav", b"ID3 no sound", "WAV"),
        ("run.csv", b" \r\n", "empty"),
    ] {
        let why = refusal(name, bytes, None);
        assert!(why.contains(words), "{name}: {why}");
    }
}

#[test]
fn lines_to_skip_are_of_files_with_lines() {
    let why = refusal("run.uff", b"    -1\n    58\n", Some("skip=3"));
    assert!(why.contains("this file has none"), "{why}");
}

#[test]
fn a_sample_has_the_columns_to_choose_from() {
    let text = b"Run 3\nt [s];a [g];x [mm]\n0;1,5;2\n0,1;1,6;3\n";
    let sample = Sample::of(Path::new("run.csv"), text, None, 2);
    assert_eq!(sample.columns, ["1", "2", "3"]);
    assert_eq!(sample.rows, [["t [s]", "a [g]", "x [mm]"], ["0", "1,5", "2"]]);
    assert_eq!(Sample::of(Path::new("users.txt"), b"root:x:0\n", None, 2), Sample::default());
}
