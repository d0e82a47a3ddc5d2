//! Every kind of input, nested three deep: from text to the struct, and back.

#![expect(clippy::unwrap_used, reason = "a test ends where its data fails")]

use dalembert_core::{
    Draft, FieldError, Inputs, Measure, Record, Reference, Shape, Value, Worksheet, draft, file,
};
use nalgebra::Vector3;

/// A machine with everything a form can ask for.
#[derive(Clone, Debug, PartialEq, Inputs)]
struct Machine {
    /// Name.
    name: String,
    /// Gravity.
    #[input("g", "m/s^2", default = "9.81 m/s^2")]
    gravity: f64,
    /// Bodies.
    #[input(min = 1)]
    bodies: Vec<Body>,
    /// Loads.
    loads: Vec<Load>,
    /// Support.
    support: Spring,
    /// Number of terms.
    #[input(min = 1, max = 20, default = "3")]
    terms: u32,
    /// Friction included.
    #[input(default = "no")]
    friction: bool,
    /// Largest amplitude.
    #[input("X", "mm", kind = "Amplitude", positive)]
    largest: Option<f64>,
    /// Measured points.
    #[input(table)]
    points: Vec<Point>,
}

/// A body.
#[derive(Clone, Debug, PartialEq, Inputs)]
struct Body {
    /// Name.
    name: String,
    /// Mass.
    #[input("m", "kg", positive)]
    mass: f64,
    /// Centre of mass.
    #[input("r_G", "m", planar)]
    centre: Vector3<f64>,
}

/// A load.
#[derive(Clone, Debug, PartialEq, Inputs)]
struct Load {
    /// The body it acts on.
    #[input(rows = "bodies")]
    body: Reference,
    /// Force.
    #[input("F", "N")]
    force: Vector3<f64>,
    /// Sense.
    sense: Sense,
}

/// A sense of rotation.
#[derive(Clone, Debug, PartialEq, Inputs)]
enum Sense {
    /// Clockwise
    Clockwise,
    /// Counter-clockwise
    CounterClockwise,
}

/// A spring, or springs of springs.
#[derive(Clone, Debug, PartialEq, Inputs)]
enum Spring {
    /// Stiffness given
    Stiffness {
        /// Stiffness.
        #[input("k", "N/m", positive)]
        stiffness: f64,
    },
    /// Springs in series
    Series {
        /// Members.
        #[input(min = 1)]
        members: Vec<Spring>,
    },
    /// Springs in parallel
    Parallel {
        /// Members.
        #[input(min = 1)]
        members: Vec<Spring>,
    },
}

/// A point.
#[derive(Clone, Debug, PartialEq, Inputs)]
struct Point {
    /// Frequency.
    #[input("f", "Hz")]
    frequency: f64,
    /// Amplitude.
    #[input("X", "mm")]
    amplitude: f64,
}

fn shape() -> Shape {
    Machine::SHAPE
}

fn filled() -> Draft {
    let mut draft = Draft::blank(&shape());
    for (path, text) in [
        ("name", "press"),
        ("bodies[1].name", "ram"),
        ("bodies[1].mass", "12 kg"),
        ("bodies[1].centre", "(1; 2) m"),
        ("bodies[2].name", "crank"),
        ("bodies[2].mass", "3,5 kg"),
        ("bodies[2].centre", "(10; 20) mm"),
        ("loads[1].body", "crank"),
        ("loads[1].force", "(1; 2; 3) kN"),
        ("loads[1].sense", "counter-clockwise"),
        ("support", "series"),
        ("support.series.members[1].parallel.members[1].stiffness.stiffness", "2 kN/m"),
        ("support.series.members[1].parallel.members[2].stiffness.stiffness", "3 kN/m"),
        ("support.series.members[2].stiffness.stiffness", "1000"),
        ("points", "f [Hz]; X [mm]\n1; 0,5\n2; 1,5"),
    ] {
        draft.set(&shape(), path, text).unwrap_or_else(|err| panic!("{path}: {err}"));
    }
    draft
}

fn read(draft: &Draft) -> Record {
    draft.read(&shape()).unwrap_or_else(|errors| panic!("{errors:?}"))
}

fn errors_of(path: &str, text: &str) -> Vec<FieldError> {
    let mut draft = filled();
    draft.set(&shape(), path, text).unwrap();
    draft.read(&shape()).err().unwrap_or_default()
}

#[test]
fn a_draft_becomes_the_struct() {
    let machine = Machine::read_all(&Value::Group(read(&filled()))).unwrap();
    assert_eq!(machine.gravity, 9.81);
    assert_eq!(machine.bodies[1].mass, 3.5);
    assert_eq!(machine.bodies[1].centre, Vector3::new(0.01, 0.02, 0.0));
    assert_eq!(machine.loads[0].body, Reference(1));
    assert_eq!(machine.loads[0].force, Vector3::new(1e3, 2e3, 3e3));
    assert_eq!(machine.loads[0].sense, Sense::CounterClockwise);
    assert_eq!((machine.terms, machine.friction, machine.largest), (3, false, None));
    let given = |stiffness| Spring::Stiffness { stiffness };
    let parallel = Spring::Parallel { members: vec![given(2e3), given(3e3)] };
    assert_eq!(machine.support, Spring::Series { members: vec![parallel, given(1e3)] });
    assert_eq!(machine.points[1].amplitude, 1.5e-3);
    assert!((machine.points[0].frequency - std::f64::consts::TAU).abs() < 1e-15);
}

#[test]
fn a_record_gives_its_texts_back() {
    let record = read(&filled());
    assert_eq!(read(&Draft::of_record(&record)).values, record.values);
}

#[test]
fn a_quantity_anywhere_can_be_varied() {
    let mut machine = Machine::read_all(&Value::Group(read(&filled()))).unwrap();
    *machine.slot(&[2, 1, 1]).unwrap() = 7.0;
    assert_eq!(machine.bodies[1].mass, 7.0);
    // support → series → members → second → stiffness given → stiffness
    *machine.slot(&[4, 1, 0, 1, 0, 0]).unwrap() = 5.0;
    let Spring::Series { members } = &machine.support else { panic!("the support is a series") };
    assert_eq!(members[1], Spring::Stiffness { stiffness: 5.0 });
    *machine.slot(&[3, 0, 1, 2]).unwrap() = -1.0;
    assert_eq!(machine.loads[0].force.z, -1.0);
    for nowhere in [&[0][..], &[2, 9, 1], &[4, 0, 0], &[99], &[]] {
        assert!(machine.slot(nowhere).is_none(), "{nowhere:?}");
    }
}

#[test]
fn every_error_names_its_field() {
    let mut draft = filled();
    for (path, text) in
        [("bodies[1].mass", "-3 kg"), ("loads[1].body", "crnk"), ("terms", "21"), ("friction", "maybe")]
    {
        draft.set(&shape(), path, text).unwrap();
    }
    let errors: Vec<String> = draft.read(&shape()).unwrap_err().iter().map(ToString::to_string).collect();
    assert_eq!(
        errors,
        [
            "bodies[1].mass: must be above zero; you wrote -3 kg",
            "terms: 21 is outside the limits; enter an integer from 1 to 20",
            "friction: `maybe` is neither yes nor no",
            "loads[1].body: there is no `crnk`; did you mean `crank`?",
        ]
    );
}

#[test]
fn whatever_is_typed_is_read_or_refused() {
    let long = "9".repeat(10_000_000);
    let texts = [
        "",
        " ",
        "abc",
        "3 furlong",
        "1,2.3",
        "1e400",
        "nan",
        "inf",
        "\u{1b}[31m",
        "3 kg\u{202e}",
        "--",
        &long,
    ];
    for path in
        ["gravity", "bodies[1].mass", "bodies[1].centre", "loads[1].force", "terms", "friction", "points"]
    {
        // A row of two numbers is what a table asks for; a gravity that is left out has a default.
        let is_right = |text: &str| match path {
            "points" => text == "1,2.3",
            "gravity" => text.trim().is_empty(),
            _ => false,
        };
        for text in texts.into_iter().filter(|text| !is_right(text)) {
            let errors = errors_of(path, text);
            assert!(!errors.is_empty(), "{path} takes {:?}", &text[..text.len().min(20)]);
            assert!(errors.iter().all(|err| err.path == path), "{path}: {errors:?}");
            assert!(
                errors.iter().all(|err| err.to_string().len() < 2_000),
                "{path}: the message is too long"
            );
        }
    }
    for (path, text) in [("bodies[1].mass", "3 N"), ("loads[1].force", "(1; 2; 3) kg"), ("gravity", "9.81 m")]
    {
        assert!(!errors_of(path, text).is_empty(), "{path} takes {text}");
    }
}

/// The points of a table that is typed or pasted.
fn points_of(text: &str) -> Result<Vec<[f64; 2]>, Vec<FieldError>> {
    let mut draft = filled();
    draft.set(&shape(), "points", text).unwrap();
    let machine = Machine::read_all(&Value::Group(draft.read(&shape())?))?;
    Ok(machine.points.iter().map(|point| [point.frequency, point.amplitude]).collect())
}

#[test]
fn a_heading_gives_each_column_its_unit() {
    let wanted = vec![[2.0, 1.5e-3], [3.0, 2.5e-3]];
    for text in [
        "w [rad/s]; X [mm]\n2; 1.5\n3; 2.5",
        "w [rad/s]\tX (mean) [mm]\n2\t1,5\n3\t2,5",
        "w [rad/s],X [mm]\n2,1.5\n3,2.5",
        "# a remark\n\nw (rad/(s)); X (mm)\n2; 1,5\n3; 2,5\n",
        "\"w [rad/s]\",\"X, mean [mm]\"\n2,\"1,5\"\n\"3\",\"2,5\"",
        "w [rad/s];X [mm]\n\"2\";\"1,5\"\n\"3\";\"2,5\"",
    ] {
        assert_eq!(points_of(text), Ok(wanted.clone()), "{text}");
    }
    let faults = points_of("w [rad/s]; X [kg]\n2; 1\nthree; 2\n4").unwrap_err();
    let reported: Vec<String> = faults.iter().map(|err| err.why.english()).collect();
    assert!(reported.iter().any(|why| why.contains("kg")), "{reported:?}");
    assert!(reported.iter().any(|why| why.starts_with("line 3: ")), "{reported:?}");
    assert!(reported.iter().any(|why| why.starts_with("line 4: ")), "{reported:?}");
    // One cell too many is reported as such, whatever other marks stand in its line.
    let faults = points_of("2; 1,5e-3\n3; 1,1e-4; 7").unwrap_err();
    let reported = faults[0].why.english();
    assert!(reported.starts_with("line 2: 3 columns separated by semicolons"), "{reported}");
}

#[test]
fn a_universal_file_that_is_pasted_is_a_table() {
    let axis = |kind: i64, unit: &str| format!("{kind:10}    0    0    0 NONE                 {unit:<20}\n");
    let file = |ordinate: i64, unit: &str| {
        let dof = "    4         0    0         0       NONE         5   3       NONE         1   3\n";
        format!(
            "    -1\n    58\nDeflection\nNONE\nNONE\nNONE\nNONE\n{dof}{:10}{:10}{:10}  1.00000E+00  5.00000E-01  \
             0.00000E+00\n{}{}{}{}  1.50000E+00  2.50000E+00\n    -1\n",
            2,
            2,
            1,
            axis(18, "Hz"),
            axis(ordinate, unit),
            axis(0, "NONE"),
            axis(0, "NONE"),
        )
    };
    let hertz = std::f64::consts::TAU;
    assert_eq!(points_of(&file(8, "mm")), Ok(vec![[hertz, 1.5e-3], [1.5 * hertz, 2.5e-3]]));
    // Without a unit of its own the SI is assumed.
    assert_eq!(points_of(&file(8, "NONE")), Ok(vec![[hertz, 1.5], [1.5 * hertz, 2.5]]));
    let why = points_of(&file(12, "m/s^2")).unwrap_err()[0].to_string();
    assert!(why.contains("line 1: the function is in m/s^2"), "{why}");
}

#[test]
fn an_optional_input_comes_and_goes() {
    let mut draft = filled();
    draft.set(&shape(), "largest", "3 mm").unwrap();
    assert_eq!(Machine::read_all(&Value::Group(read(&draft))).unwrap().largest, Some(3e-3));
    draft.set(&shape(), "largest", "").unwrap();
    assert_eq!(*read(&draft).get("largest").unwrap(), Value::Absent);
}

/// A wheel.
#[derive(Clone, Debug, PartialEq, Inputs)]
struct Wheel {
    /// Its shape.
    shape: Sense,
    /// Seen from.
    #[input(default = "counter-clockwise")]
    seen: Sense,
    /// Radii.
    #[input("r", "mm", most = 2)]
    radii: Vec<f64>,
    /// Place.
    #[input("p", "m")]
    place: Vector3<f64>,
}

#[test]
fn a_choice_is_made_or_declared() {
    let shape = Wheel::SHAPE;
    let mut draft = Draft::blank(&shape);
    draft.set(&shape, "place", "(1; 2; 3) m").unwrap();
    let errors = draft.read(&shape).unwrap_err();
    assert_eq!(errors.len(), 1);
    assert_eq!(errors[0].to_string(), "shape: write one of clockwise, counter-clockwise");
    draft.set(&shape, "shape", "clockwise").unwrap();
    let wheel = Wheel::read_all(&Value::Group(draft.read(&shape).unwrap())).unwrap();
    assert_eq!((wheel.shape, wheel.seen), (Sense::Clockwise, Sense::CounterClockwise));
    // A form shows what it chooses.
    let begun = Draft::blank(&shape).with_first_alternatives(&shape);
    assert_eq!(begun.at(&shape, "shape").unwrap().0, draft.at(&shape, "shape").unwrap().0);
}

#[test]
fn a_list_takes_no_more_rows_than_it_declares() {
    let shape = Wheel::SHAPE;
    let mut draft = Draft::blank(&shape);
    for row in 1..=2 {
        draft.set(&shape, &format!("radii[{row}]"), "1 mm").unwrap();
    }
    let error = draft.set(&shape, "radii[3]", "1 mm").unwrap_err();
    assert_eq!(error.to_string(), "radii[3]: 3 rows: at most 2 are accepted here");
}

#[test]
fn numbers_without_a_unit_are_found() {
    let shape = Wheel::SHAPE;
    let mut draft = Draft::blank(&shape);
    for (path, text) in [("radii[1]", "2*pi"), ("radii[2]", "0"), ("place", "(1; 2; 3)")] {
        draft.set(&shape, path, text).unwrap();
    }
    let found: Vec<String> = draft.without_unit(&shape).iter().map(ToString::to_string).collect();
    assert_eq!(found, ["radii[1]: no unit; mm assumed", "place: no unit; m assumed"]);
    for (path, text) in [("radii[1]", "2 mm"), ("place", "(0; 0; 0)")] {
        draft.set(&shape, path, text).unwrap();
    }
    assert_eq!(draft.without_unit(&shape), []);
}

#[test]
fn drafts_are_apart_by_their_texts() {
    let draft = filled();
    let apart = |changes: &[(&str, &str)]| {
        let mut other = draft.clone();
        for (path, text) in changes {
            other.set(&shape(), path, text).unwrap();
        }
        draft.apart(&other)
    };
    assert_eq!(apart(&[]), 0);
    assert_eq!(apart(&[("bodies[1].mass", "")]), 1);
    assert_eq!(apart(&[("largest", "3 mm")]), 1);
    assert_eq!(apart(&[("bodies[1].mass", ""), ("bodies[2].mass", "")]), 2);
    assert!(apart(&[("support", "parallel")]) > 1);
    assert!(apart(&[("bodies[3].mass", "1 kg")]) > 1);
}

#[test]
fn paths_that_lead_nowhere_are_named() {
    let mut draft = filled();
    for (path, why) in [
        ("bodys[1].mass", "did you mean `bodies`?"),
        ("bodies[4].mass", "there are 2 rows; the next is 3"),
        ("bodies[0].mass", "rows count from 1"),
        ("bodies.mass", "name a row"),
        ("support.spring.k", "there is no `spring`"),
        ("bodies", "name one of them"),
    ] {
        let err = draft.set(&shape(), path, "1").unwrap_err().to_string();
        assert!(err.contains(why), "{path}: {err}");
    }
}

#[test]
fn a_leaf_is_read_as_it_is_typed() {
    let mass = Body::SHAPE.fields(None)[1].shape;
    assert!(
        matches!(draft::read_leaf("2 t", &mass, "mass").unwrap(), Value::Quantity(quantity) if quantity.si == 2e3)
    );
    assert!(draft::read_leaf("2 m", &mass, "mass").is_err());
}

#[test]
fn text_that_is_no_problem_file_is_refused_with_its_place() {
    for (text, why) in [
        ("analysis = 3", "must be a text"),
        ("title = \"x\"", "the analysis is not named"),
        ("analysis = \"no/such\"", "there is no analysis `no/such`"),
        ("analysis = \"a\"\nanalysis = \"b\"", "duplicate key `analysis`"),
        ("a = [[[[[[", ""),
    ] {
        let errors = file::parse(text).unwrap_err();
        assert!(errors[0].why.english().contains(why), "{text}: {}", errors[0].why.english());
    }
    let deep = format!("a = {}{}", "[".repeat(100_000), "]".repeat(100_000));
    assert!(file::parse(&deep).is_err());
}

/// The derive is generic over worksheets: this need only compile.
#[expect(dead_code, reason = "a check of types")]
fn lifted<W: Worksheet>(given: &MachineGiven<W>) -> W::Num {
    match &given.support {
        SpringGiven::Stiffness { stiffness } => *stiffness,
        SpringGiven::Series { members } | SpringGiven::Parallel { members } => match &members[0] {
            SpringGiven::Stiffness { stiffness } => *stiffness * given.bodies[0].mass,
            _ => given.gravity,
        },
    }
}

/// Fields may have the names that the derived code uses for itself.
#[derive(Clone, Debug, PartialEq, Inputs)]
struct Names {
    /// First.
    #[input("1")]
    first: Pair,
    /// Rest.
    #[input("a", "m")]
    rest: f64,
    /// Path.
    #[input("b", "m")]
    path: f64,
    /// Fields.
    #[input("c", "m")]
    fields: f64,
}

/// A pair.
#[derive(Clone, Debug, PartialEq, Inputs)]
struct Pair {
    /// Value.
    #[input("x", "m")]
    value: f64,
    /// Field path.
    #[input("y", "m")]
    field_path: f64,
    /// Errors.
    #[input("z", "m")]
    errors: Option<f64>,
    /// Lift.
    #[input("t", "m")]
    lift: f64,
}

#[test]
fn fields_may_have_any_name() {
    let mut draft = Draft::blank(&Names::SHAPE);
    let typed = [
        ("first.value", "1 m"),
        ("first.field_path", "2 m"),
        ("first.lift", "3 m"),
        ("rest", "4 m"),
        ("path", "5 m"),
        ("fields", "6 m"),
    ];
    for (path, text) in typed {
        draft.set(&Names::SHAPE, path, text).unwrap();
    }
    let mut names = Names::read_all(&Value::Group(draft.read(&Names::SHAPE).unwrap())).unwrap();
    let pair = Pair { value: 1.0, field_path: 2.0, errors: None, lift: 3.0 };
    assert_eq!(names, Names { first: pair, rest: 4.0, path: 5.0, fields: 6.0 });
    *names.slot(&[0, 3]).unwrap() = 7.0;
    assert_eq!(names.first.lift, 7.0);
}

#[test]
fn a_table_is_saved_with_the_units_it_was_read_in() {
    for text in
        ["1; 0.5\n2; 1.5", "# by hand\nf; X\n1; 0.5\n2; 1.5", "1,0.5\n2,1.5", "f [Hz]; X\n1; 0.5\n2; 1.5"]
    {
        let Shape::Table(columns) = shape().fields(None)[8].shape else { panic!("the points are a table") };
        let saved = dalembert_core::table::with_units(text, columns()).unwrap();
        assert_eq!(points_of(&saved), points_of(text), "{saved}");
        assert_eq!(dalembert_core::table::with_units(&saved, columns()), None, "{saved}");
    }
}

/// A flywheel.
#[derive(Clone, Debug, Inputs)]
pub struct Flywheel {
    /// Coefficient of fluctuation.
    #[input("C_s", "%", positive, fraction, max = 50)]
    pub fluctuation: f64,
    /// Scatter.
    #[input("p", "%", nonnegative)]
    pub scatter: f64,
}

#[test]
fn a_fraction_is_written_as_a_number_or_in_per_cent() {
    let fields = Flywheel::SHAPE.fields(None);
    let read = |field: usize, text: &str| match draft::read_leaf(text, &fields[field].shape, "x") {
        Ok(Value::Quantity(quantity)) => Ok(quantity.si),
        Ok(other) => Err(format!("{other:?}")),
        Err(errors) => Err(errors[0].why.english()),
    };
    for (text, si) in
        [("0.05", 0.05), ("5", 0.05), ("5 %", 0.05), ("0.5 %", 0.005), ("0.5", 0.5), ("50", 0.5)]
    {
        assert_eq!(read(0, text), Ok(si), "{text}");
    }
    assert_eq!(read(0, "0.6"), Err("must be 0.5 or less; you wrote 0.6".to_owned()));
    assert_eq!(read(0, "60"), Err("must be 50 % or less; you wrote 60".to_owned()));
    assert_eq!(read(0, "0"), Err("must be above zero; you wrote 0".to_owned()));
    assert_eq!(read(1, "5"), Ok(0.05));
    let why = read(1, "0.05").unwrap_err();
    assert!(why.contains("write `5 %` or `0.05 %`"), "{why}");
}

#[test]
fn a_balance_quality_grade_is_written_with_its_letter_too() {
    let grade = Shape::Quantity(Measure { grade: true, ..Measure::in_unit("mm/s") });
    for text in ["2.5", "G2.5", "G 2.5", "G2,5", "g 2.5", "G 2.5 mm/s"] {
        let Ok(Value::Quantity(read)) = draft::read_leaf(text, &grade, "") else { panic!("{text}") };
        assert!((read.si - 0.0025).abs() < 1e-15, "{text}: {}", read.si);
    }
    for text in ["G", "G 2.5 in/s", "G-2.5", "2.5 G"] {
        assert!(draft::read_leaf(text, &grade, "").is_err(), "{text}");
    }
    let speed = Shape::Quantity(Measure::in_unit("mm/s"));
    assert!(draft::read_leaf("G2.5", &speed, "").is_err());
}
