//! Readers and writers of foreign text, each as a function of any bytes: no panic, no number that is not finite, nothing
//! that drives a terminal. `cargo xtask fuzz` searches for bytes that break them; what it has found worth keeping is in
//! `tests/data/fuzz`, and read again by the tests.

use std::{path::Path, sync::LazyLock};

use dalembert_core::{
    Draft, Entry, Field, FieldError, Fields, Locale, Record, Shape, Solution, Stop, Text, Value, cases,
    draft, file, find_analysis, registry, uff,
};
use dalembert_plugins as _;
use dalembert_report::{DocumentFormat, Parts, WorkedProblem, document_without_figures, json, json_text};
use dalembert_tui::{glyphs::filter_untrusted, replay::Replay, settings, terminal::decode::Decoder};
use dalembert_units::{Kind, Unit, quantity_of, read_any, read_quantity, read_vector, unit, write_vector};

/// A reader or writer, and what it begins with.
pub struct Target {
    /// Name on the command line, and of the file of its corpus.
    pub name: &'static str,
    /// Longest input that is tried.
    pub longest: usize,
    /// The reader. It panics where what it read is wrong.
    pub read: fn(&[u8]),
    /// Sound inputs, to begin with.
    pub seeds: fn() -> Vec<Vec<u8>>,
}

/// Every target.
pub const TARGETS: [Target; 10] = [
    Target { name: "quantity", longest: 64, read: quantity, seeds: quantities },
    Target { name: "expression", longest: 96, read: expression, seeds: quantities },
    Target { name: "vector", longest: 96, read: vector, seeds: vectors },
    Target { name: "keys", longest: 64, read: keys, seeds: key_bytes },
    Target { name: "problem-file", longest: 4096, read: problem_file, seeds: problem_files },
    Target { name: "table", longest: 2048, read: table, seeds: tables },
    Target { name: "universal-file", longest: 4096, read: universal_file, seeds: universal_files },
    Target { name: "replay", longest: 1024, read: replay, seeds: replays },
    Target { name: "settings", longest: 1024, read: user_settings, seeds: all_settings },
    Target { name: "report", longest: 256, read: report, seeds: titles },
];

/// The target of a name.
#[must_use]
pub fn target(name: &str) -> Option<&'static Target> {
    TARGETS.iter().find(|target| target.name == name)
}

fn text(bytes: &[u8]) -> Option<&str> {
    std::str::from_utf8(bytes).ok()
}

/// Fields that quantities are typed in: the first byte chooses one.
static FIELDS: LazyLock<Vec<(Unit, Kind)>> = LazyLock::new(|| {
    [
        ("m", Kind::Length),
        ("deg", Kind::Angle),
        ("rad/s", Kind::AngularVelocity),
        ("1", Kind::Ratio),
        ("dB", Kind::Ratio),
        ("mm pp", Kind::Amplitude),
        ("N*m", Kind::Torque),
        ("kg*m^2", Kind::Other),
    ]
    .map(|(text, kind)| (unit(text).expect("it is a unit"), kind))
    .to_vec()
});

/// A quantity in a field: read to a finite number in that field's dimension, or refused at a place of the text.
fn quantity(bytes: &[u8]) {
    let Some((first, text)) = bytes.split_first().and_then(|(first, rest)| Some((first, text(rest)?))) else {
        return;
    };
    let (default, kind) = &FIELDS[usize::from(*first) % FIELDS.len()];
    match read_quantity(text, default, *kind) {
        Ok(quantity) => {
            assert!(quantity.si.is_finite(), "{text:?} is {}", quantity.si);
            assert!(quantity.last_place.is_finite() && quantity.last_place >= 0.0, "{text:?}");
        }
        Err(err) => {
            if let Some(span) = err.span() {
                assert!(text.get(span.clone()).is_some(), "{text:?}: {span:?} is no place of it");
            }
            assert!(!err.to_string().contains(char::is_control), "{text:?}: {err}");
        }
    }
}

/// An expression of any dimension: both readers agree.
fn expression(bytes: &[u8]) {
    let Some(text) = text(bytes) else { return };
    let read = read_any(text);
    assert_eq!(quantity_of(text), read.as_ref().ok().cloned(), "{text:?}");
    if let Ok(quantity) = read {
        assert!(quantity.si.is_finite(), "{text:?} is {}", quantity.si);
    }
}

/// A vector: what is written is read as the same vector.
fn vector(bytes: &[u8]) {
    let Some(text) = text(bytes) else { return };
    static METRE: LazyLock<Unit> = LazyLock::new(|| unit("m").expect("it is a unit"));
    for count in [2, 3] {
        if let Ok(vector) = read_vector(text, &METRE, Kind::Length, count) {
            assert_eq!(vector.si.len(), 3, "{text:?}");
            assert!(vector.si.iter().all(|x| x.is_finite()), "{text:?}: {:?}", vector.si);
            let style = Locale::english().style;
            let written = write_vector(vector.si, &METRE, style);
            read_vector(&written, &METRE, Kind::Length, 3).unwrap_or_else(|err| panic!("{written:?}: {err}"));
        }
    }
}

/// Bytes of a terminal: the same inputs however they are cut in pieces, and nothing is held for ever.
fn keys(bytes: &[u8]) {
    let (mut whole, mut pieces) = (Vec::new(), Vec::new());
    let mut decoder = Decoder::default();
    decoder.feed(bytes, &mut whole);
    decoder.settle(&mut whole);
    assert!(decoder.patience().is_none(), "{bytes:?} is held");
    let mut decoder = Decoder::default();
    for byte in bytes {
        decoder.feed(&[*byte], &mut pieces);
    }
    decoder.settle(&mut pieces);
    assert_eq!(whole, pieces, "{bytes:?}");
}

/// A record without the mark of which units of its tables are assumed.
fn with_units_named(mut record: Record) -> Record {
    record.values = record.values.into_iter().map(named).collect();
    record
}

fn named(value: Value) -> Value {
    match value {
        Value::Table(mut table) => {
            table.assumed.clear();
            Value::Table(table)
        }
        Value::Group(fields) => Value::Group(with_units_named(fields)),
        Value::OneOf { variant, fields } => Value::OneOf { variant, fields: with_units_named(fields) },
        Value::Rows(rows) => Value::Rows(rows.into_iter().map(named).collect()),
        other => other,
    }
}

/// A problem file: read or refused at places of the text; what is read is written, and read again as the same problem.
fn problem_file(bytes: &[u8]) {
    let Some(text) = text(bytes) else { return };
    match file::parse(text) {
        Ok(problem) => {
            let written = file::write(&problem, text);
            let again = file::parse(&written).unwrap_or_else(|errors| panic!("{written}\n{errors:?}"));
            // A table whose units are assumed may be written with them, and is the same table.
            let read = |draft: &Draft| draft.read(&problem.entry.shape()).map(with_units_named);
            // What is refused is refused at the same inputs, in lines of the table that count a heading with its units.
            let paths =
                |errors: Vec<FieldError>| errors.into_iter().map(|error| error.path).collect::<Vec<_>>();
            let is_same = again.draft == problem.draft
                || read(&again.draft).map_err(paths) == read(&problem.draft).map_err(paths);
            assert!(is_same && file::write(&again, &written) == written, "{written}");
            if let Err(errors) = problem.draft.read(&problem.entry.shape()) {
                file::locate(text, &errors);
            }
        }
        Err(errors) => {
            assert!(!errors.is_empty());
            for span in errors.iter().filter_map(|error| error.span.clone()) {
                assert!(text.get(span.clone()).is_some(), "{span:?} is no place of {text:?}");
            }
        }
    }
}

/// Columns of a table of an analysis: times and values, say.
fn columns() -> &'static [Field] {
    static COLUMNS: LazyLock<&'static [Field]> = LazyLock::new(|| {
        let columns = registry().iter().find_map(|entry| columns_within(&entry.shape()));
        columns.expect("an analysis has a table")
    });
    *COLUMNS
}

fn columns_within(shape: &Shape) -> Option<&'static [Field]> {
    let among = |fields: &'static [Field]| fields.iter().find_map(|field| columns_within(&field.shape));
    match shape {
        Shape::Table(columns) => Some(columns()),
        Shape::Group(fields) => among(fields()),
        Shape::OneOf(variants) => variants().iter().find_map(|variant| among((variant.fields)())),
        Shape::Optional(inner) => columns_within(inner()),
        Shape::Rows { item, .. } => columns_within(item()),
        _ => None,
    }
}

/// A file of numbers: a table of finite numbers, a fault at a cell, or an error that shows one cell at most.
fn table(bytes: &[u8]) {
    let Some((first, rest)) = bytes.split_first() else { return };
    let name = ["a.csv", "a.txt", "a.wav", "a.mat", "a.xlsx", "a.uff"][usize::from(*first) % 6];
    match dalembert_import::table(Path::new(name), rest.to_vec(), None, columns()) {
        // Words of a text, which may be names, are left for the reader of an input.
        Ok(text) => {
            if let Ok(Value::Table(table)) = draft::read_leaf(&text, &Shape::Table(Fields(&columns)), "") {
                assert!(table.rows().flatten().all(|number| number.is_finite()), "{text:?}");
            }
        }
        Err(why) => {
            let why = why.english();
            assert!(why.len() < 4096, "{} bytes of error", why.len());
        }
    }
}

/// A universal file: functions and what was skipped; their tables are finite.
fn universal_file(bytes: &[u8]) {
    let (functions, skipped) = uff::functions(bytes);
    assert!(functions.len() + skipped.len() <= bytes.len());
    let _ = uff::table(bytes, columns(), None);
}

/// A recorded session: read, or refused at one of its lines.
fn replay(bytes: &[u8]) {
    let Some(text) = text(bytes) else { return };
    if let Err(unreadable) = Replay::read(text) {
        assert!((1..=text.lines().count()).contains(&unreadable.line), "{unreadable}");
    }
}

/// Settings: taken or faulted, line by line.
fn user_settings(bytes: &[u8]) {
    let Some(text) = text(bytes) else { return };
    let (_, faults) = settings::parse(text);
    for fault in faults {
        // The end of a text is in the line behind its last line feed.
        assert!((1..=text.split('\n').count()).contains(&fault.line), "line {} of {text:?}", fault.line);
    }
}

/// A problem that is solved once.
static SOLVED: LazyLock<(&'static Entry, Draft, Record, Solution)> = LazyLock::new(|| {
    let entry = find_analysis("vibration/gun-recoil").expect("it is registered");
    let case = cases::first(entry).expect("it has a case");
    let record = case.record(entry).expect("its case is read");
    let solution = entry.solve(&record, &Stop::new()).expect("its case is solved");
    (entry, case.draft.clone(), record, solution)
});

/// A title in every format: nothing of it drives a terminal, or is more than text in the format.
fn report(bytes: &[u8]) {
    let Some(title) = text(bytes) else { return };
    let (entry, draft, record, solution) = &*SOLVED;
    let (title, none) = (Text::verbatim(title.to_owned()), Text::verbatim(String::new()));
    let worked = WorkedProblem {
        entry,
        case: &title,
        source: &none,
        statement: &none,
        note: &title,
        notes: &[],
        draft,
        record,
        outcome: Ok(solution),
    };
    let locale = Locale::english();
    let document = document_without_figures(&worked, Parts::default(), &locale)
        .map(&|words| filter_untrusted(words).into_owned());
    for format in
        [DocumentFormat::Html, DocumentFormat::Latex, DocumentFormat::Typst, DocumentFormat::Markdown]
    {
        let written = format.write(&document, None, &locale);
        assert!(!written.contains(|c: char| c != '\n' && c.is_control()), "{format:?}");
        assert!(!written.contains("<script>alert"), "{format:?}");
    }
    let json = json_text(&json(&worked, &locale));
    assert!(!json.contains(|c: char| c != '\n' && c.is_control()));
}

fn owned(texts: &[&str]) -> Vec<Vec<u8>> {
    texts.iter().map(|text| text.as_bytes().to_vec()).collect()
}

fn quantities() -> Vec<Vec<u8>> {
    owned(&[
        " 20.3 mm",
        "!1,250 kg",
        "\"1 200 rpm",
        "#50 %",
        "$-20 dB",
        "%3 mm pp",
        "&2*pi*50 rad/s",
        "'sqrt(2)*5 kN·m",
        "(1/2 in",
        "\x001.3×10⁻⁶ m⁴",
        "5 ft 3 in",
        "30°",
        "3 N/(m*s)",
        "2^-3 m",
        "(2 + 3)*4 m",
        "45 sin(30 deg)",
        "1e-400",
    ])
}

fn vectors() -> Vec<Vec<u8>> {
    owned(&[
        "(300; 200) m/s",
        "(1, 2, 3) mm",
        "(300 i + 200 j - k) m",
        "80 ft @ 330 deg",
        "0",
        "3 m ∠ 30°",
        "1 mm; 2 in",
    ])
}

fn key_bytes() -> Vec<Vec<u8>> {
    owned(&[
        "aé漢\r\t\x7f",
        "\x1b[A\x1b[1;5C\x1bOP\x1b[15~",
        "\x1b[<0;12;7M\x1b[<0;12;7m",
        "\x1b[200~pasted\x1b[201~",
        "\x1b[M !!",
        "\x1b[[A",
        "\x1b]11;rgb:0/0/0\x07",
        "\x1b_Gi=31;OK\x1b\\",
        "\x1b\x1b[A",
        "\x1b[I\x1b[O\x1b[97;5u",
    ])
}

fn problem_files() -> Vec<Vec<u8>> {
    let first = registry().iter().filter_map(|entry| {
        let problem = file::parse(&format!("format = 2\nanalysis = \"{}\"\n", entry.about.id)).ok()?;
        let draft = cases::first(entry)?.draft.clone();
        Some(file::write(&file::ProblemFile { draft, ..problem }, "").into_bytes())
    });
    first.filter(|text| text.len() < 4096).collect()
}

fn tables() -> Vec<Vec<u8>> {
    owned(&[
        " t,x\n0,1\n0.1,2\n",
        "!t [s];x [mm]\n0,0;1,5\n0,1;2,5\n",
        "\"\u{feff}a\tb\n1\t2\n",
        "#Model,MSO\n\n0 1\n1 2\n",
    ])
}

fn universal_files() -> Vec<Vec<u8>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/data/tables");
    let found = std::fs::read_dir(folder)
        .into_iter()
        .flatten()
        .flatten()
        .filter_map(|entry| std::fs::read(entry.path()).ok());
    let mut seeds: Vec<Vec<u8>> =
        found.filter(|bytes| uff::is_universal(bytes) && bytes.len() < 4096).collect();
    seeds.push(b"    -1\n    58\nFRF\n\n\n\n\n    4         1    0         0 A  1   3 A  1   3\n         5         2         1  0.0  0.1  0.0\n".to_vec());
    seeds
}

fn replays() -> Vec<Vec<u8>> {
    owned(&[
        "screen 80 24\nlanguage en\nlook colour\nopen vibration/gun-recoil\ntype abc<enter>\nwait 200\nexpect Recoil\n",
        "field\npaste \"1 mm\"\nresize 60 20\ntab 2\npause 1s\ncaption words\npicture a.svg\n",
    ])
}

fn all_settings() -> Vec<Vec<u8>> {
    owned(&[
        "language = \"pt-BR\"\nunits = \"inch\"\ntheme = \"light\"\n",
        "[keys]\nsave = \"ctrl-s\"\nquit = [\"q\", \"ctrl-q\"]\n",
    ])
}

fn titles() -> Vec<Vec<u8>> {
    owned(&[
        "Recoil of a gun",
        "<script>alert(1)</script>",
        "\\input{/etc/passwd} $x$ ^^5c",
        "#import \"x\" #read(\"y\") *b*",
        "\u{9b}31m \u{202e} \u{200b}",
        "| a | b |\n|---|",
        "[x](javascript:alert(1)) `code`",
        "=cmd|' /C calc'!A0",
        "& < > \" ' % _ ~ {",
    ])
}
