//! Tables as measuring programs write them: the unit of each column is found, asked for, or said to be assumed.

use dalembert_core::{Inputs, NumberTable, Value, draft};

/// A record of a motion.
#[derive(Clone, Debug, Inputs)]
struct Motion {
    /// Samples.
    #[input(table)]
    rows: Vec<Sample>,
}

/// A sample.
#[derive(Clone, Debug, Inputs)]
struct Sample {
    /// Time.
    #[input("t", "s")]
    time: f64,
    /// Displacement.
    #[input("x", "m", default_before = "mm")]
    displacement: f64,
}

/// Bodies on springs.
#[derive(Clone, Debug, Inputs)]
struct Chain {
    /// Links.
    #[input(table)]
    rows: Vec<Link>,
}

/// A body on a spring.
#[derive(Clone, Debug, Inputs)]
struct Link {
    /// Mass.
    #[input("m", "kg")]
    mass: f64,
    /// Stiffness.
    #[input("k", "N/m")]
    stiffness: f64,
}

/// A spectrum.
#[derive(Clone, Debug, Inputs)]
struct Spectrum {
    /// Lines.
    #[input(table)]
    rows: Vec<Tone>,
}

/// A line of a spectrum.
#[derive(Clone, Debug, Inputs)]
struct Tone {
    /// Frequency.
    #[input("f", "Hz")]
    frequency: f64,
    /// Amplitude ratio.
    #[input("T", "1")]
    ratio: f64,
    /// Phase.
    #[input("φ", "deg")]
    phase: f64,
}

fn read<T: Inputs>(text: &str) -> Result<NumberTable, String> {
    let field = &T::SHAPE.fields(None)[0];
    match draft::read_leaf(text, &field.shape, "rows") {
        Ok(Value::Table(table)) => Ok(table),
        Ok(other) => Err(format!("{other:?}")),
        Err(errors) => Err(errors.iter().map(|err| err.why.english()).collect::<Vec<_>>().join("; ")),
    }
}

fn rows(table: &NumberTable) -> Vec<&[f64]> {
    table.rows().collect()
}

fn units(table: &NumberTable) -> Vec<&str> {
    table.units.iter().map(|unit| &*unit.text).collect()
}

#[test]
fn the_unit_of_a_column_is_read_however_it_is_written() {
    let headings = [
        "t [ms],x [um]",
        "t (ms),x (um)",
        "t / ms,x / um",
        "t/ms,x/um",
        "t / (ms),x / (um)",
        "t_ms,x_um",
        "time_ms,x_rel_um",
        "time in ms,displacement in um",
        "tempo em ms,deslocamento em um",
        "time ms,displacement um",
        "ms,um",
        "t,x\nms,um",
        "t,x\n[ms],[um]",
        "t,x\n(ms),(um)",
        "Time,Channel 1\nms,um\n",
        "\"t / ms\",\"x / um\"",
        "\"t [ms]\";\"x [um]\"",
        "t [ms]\tx [um]",
        "t / ms\tx / um",
        "t [ms];x / um",
        "Time[ms],Displacement[um]",
        "Zeit in ms,Weg (rel.) / um",
        "Measured on Monday,by hand\nt / ms,x / um",
        "# t [ms], x [um]",
        "# a remark\n# time_ms,x_um",
        "% t / ms,x / um",
        "t (ms) [ms],x (H1) [um]",
        "x(t) time [ms],|x| [um]",
    ];
    for heading in headings {
        let table = read::<Motion>(&format!("{heading}\n0,1000\n10,500\n")).unwrap_or_else(|why| {
            panic!("{heading}: {why}");
        });
        assert_eq!(units(&table), ["ms", "um"], "{heading}");
        assert_eq!(rows(&table), [[0.0, 1e-3], [0.01, 5e-4]], "{heading}");
        assert_eq!(table.assumed, [false, false], "{heading}");
    }
    // With blanks between the columns.
    for heading in
        ["t / ms  x / um", "t / ms x / um", "t_ms x_um", "t (ms) x (um)", "t in ms x in um", "ms um"]
    {
        let table = read::<Motion>(&format!("{heading}\n0 1000\n10 500\n")).unwrap_or_else(|why| {
            panic!("{heading}: {why}");
        });
        assert_eq!(units(&table), ["ms", "um"], "{heading}");
        assert_eq!(rows(&table), [[0.0, 1e-3], [0.01, 5e-4]], "{heading}");
    }
}

#[test]
fn a_mass_in_place_of_a_force_is_named_with_the_unit_meant() {
    for (text, words) in [
        (
            "m [kg]; k [lb/in]\n2; 300\n",
            "the heading gives lb/in for Stiffness; lb is a mass: write `lbf/in`",
        ),
        ("m [lbf]; k [N/m]\n2; 300\n", "the heading gives lbf for Mass; lbf is a force: write `lb`"),
        ("m in kg; k in lb/in\n2; 300\n", "such as [lbf/in]"),
        ("m; k\n2 kg; 300 kg/cm\n", "write `300 kgf/cm`"),
    ] {
        let why = read::<Chain>(text).expect_err(text);
        assert!(why.contains(words), "{text}: {why}");
        assert!(
            read::<Chain>(
                &text.replace("lb/in", "lbf/in").replace("kg/cm", "kgf/cm").replace("[lbf];", "[lb];")
            )
            .is_ok()
        );
    }
    // Names of units are read, and a word of a heading stays a word.
    assert_eq!(units(&read::<Chain>("m [libras]; k [N/m]\n2; 3\n").unwrap()), ["lb", "N/m"]);
    assert_eq!(rows(&read::<Motion>("ciclos de voltas [ms]; x [um]\n2; 3\n").unwrap()), [[0.002, 3e-6]]);
}

#[test]
fn a_letter_that_is_the_symbol_of_a_quantity_is_not_its_unit() {
    for heading in
        ["m; k", "M; K", "mass m; stiffness k", "h; g", "m / m_0; k", "m_min; k_in", "m; k_N", "m_r; N"]
    {
        let table = read::<Chain>(&format!("{heading}\n2; 300\n")).unwrap_or_else(|why| {
            panic!("{heading}: {why}");
        });
        assert_eq!(rows(&table), [[2.0, 300.0]], "{heading}");
        assert_eq!(table.assumed, [true, true], "{heading}: nothing says the units");
    }
    for heading in
        ["f; T; N", "F; r; psi", "f_n; T_d; phi_min", "frequency; bar; phase of turning", "a; b; c"]
    {
        let table = read::<Spectrum>(&format!("{heading}\n2; 3; 90\n")).unwrap_or_else(|why| {
            panic!("{heading}: {why}");
        });
        assert_eq!(units(&table)[0], "Hz", "{heading}");
        assert_eq!(rows(&table)[0][1], 3.0, "{heading}");
        // A ratio has no unit to be assumed.
        assert_eq!(table.assumed, [true, false, true], "{heading}");
    }
    let table = read::<Spectrum>("f [rpm]; T [-]; phase / rad\n60; 3; 1\n").unwrap();
    assert_eq!(units(&table), ["rpm", "", "rad"]);
    let table = read::<Spectrum>("f; T; phase\nkHz; 1; deg\n2; 3; 90\n").unwrap();
    assert_eq!(units(&table)[0], "kHz");
    assert_eq!(table.assumed, [false; 3]);
    let table = read::<Spectrum>("f; T; phase\nHz; -; -\n2; 3; 90\n").unwrap();
    assert_eq!(table.assumed, [false, false, true]);
}

#[test]
fn a_unit_that_is_not_used_is_an_error_that_names_it() {
    for (heading, word) in [
        ("t [kg]; x", "kg"),
        ("t / kg; x", "kg"),
        ("t_kg; x", "kg"),
        ("time in kg; x", "kg"),
        ("t; x / V (mm)", ""),
        ("t (ms); x under 5 kN", "kN"),
        ("t-ms; x", "ms"),
        ("t{ms}; x{mm}", "ms"),
        ("t_ms_raw; x", "ms"),
        ("t / s; x_mm / um", "mm"),
        ("t [msec]; x [mm]", "msec"),
        ("time HZ; x", ""),
        ("t; x MM", "MM"),
        ("t [s]; x\n[ms]; [mm]", "ms"),
        ("t; x; of the rig in ms", "ms"),
    ] {
        let found = read::<Motion>(&format!("{heading}\n0; 1\n1; 2\n"));
        match found {
            Err(why) => assert!(why.contains(word), "{heading}: {why}"),
            Ok(table) => assert!(word.is_empty(), "{heading} is read in {:?}", units(&table)),
        }
    }
    // What stands for a missing number is no heading.
    assert!(read::<Motion>("t [s]; x [mm]\nNaN; NaN\n1; 2").is_err());
    // Nor is a row with a word in it.
    assert!(read::<Motion>("t [s]; x [mm]\n1; two\n1; 2").is_err());
}

#[test]
fn a_column_without_a_unit_is_said_to_be_assumed() {
    for text in
        ["0; 1\n1; 2", "t; x\n0; 1\n1; 2", "Time; Volts\n0; 1\n1; 2", "acc_g; x\n0;1\n1;2", "# run 7\n1; 2"]
    {
        assert_eq!(read::<Motion>(text).unwrap().assumed, [true, true], "{text}");
    }
    // Cells with units of their own, and zeros, need no heading.
    assert_eq!(read::<Motion>("1 ms; 0\n2 ms; 3 mm").unwrap().assumed, [false, false]);
    assert_eq!(read::<Motion>("1 ms; 0\n2 ms; 3").unwrap().assumed, [false, true]);
    assert_eq!(read::<Motion>("t [ms]; x\n1; 2").unwrap().assumed, [false, true]);
    // What is written of a table has its units.
    let table = read::<Motion>("1; 2").unwrap();
    let again = read::<Motion>(&draft::leaf_text(&Value::Table(table.clone()))).unwrap();
    assert_eq!((rows(&again), &again.assumed), (rows(&table), &vec![false, false]));
}
