//! Texts at the edge of what is read: the longest ones, the deepest nesting, zeros, and brackets inside of brackets.

use dalembert_units::{Kind, ReadError, read_any, read_quantity, read_vector, unit};

/// Value in SI of a text of any dimension.
fn si(text: &str) -> f64 {
    read_any(text).unwrap_or_else(|error| panic!("`{text}`: {error}")).si
}

/// 200 characters are read in a field, 100 in a unit and 600 in a vector, whatever their length in bytes.
#[test]
fn the_longest_texts() {
    assert_eq!(si(&format!("{}2", "0".repeat(199))), 2.0);
    assert_eq!(si(&format!("  2{}m  ", "\u{a0}".repeat(198))), 2.0);
    assert!(matches!(read_any(&"0".repeat(201)), Err(ReadError::TooLong { limit: 200 })));
    assert_eq!(unit(&format!("m{}m", " ".repeat(98))).unwrap().dim.length, 2);
    assert!(matches!(unit(&format!("m{}m", " ".repeat(99))), Err(ReadError::TooLong { limit: 100 })));
    let metre = unit("m").unwrap();
    let vector = read_vector(&format!("(1;{}2) m", " ".repeat(593)), &metre, Kind::Length, 2).unwrap();
    assert_eq!(vector.si, [1.0, 2.0, 0.0]);
    let long = read_vector(&format!("(1;{}2) m", " ".repeat(594)), &metre, Kind::Length, 2);
    assert!(matches!(long, Err(ReadError::TooLong { limit: 600 })));
}

/// Brackets, roots, powers and signs nest to 31, and those of both in one text are counted together.
#[test]
fn the_deepest_nesting() {
    for (open, close, most) in [
        ("-", "", 31),
        ("+", "", 31),
        ("(", ")", 31),
        ("√", "", 31),
        ("1^", "", 31),
        ("sqrt(", ")", 15),
        ("(-", ")", 15),
        ("2*(", ")", 31),
        ("1+(", ")", 31),
    ] {
        let text = |times: usize| format!("{}1{}", open.repeat(times), close.repeat(times));
        assert!(read_any(&text(most)).is_ok(), "{}", text(most));
        let refused = read_any(&text(most + 1)).unwrap_err();
        assert!(matches!(refused, ReadError::TooDeep { limit: 32, .. }), "{}: {refused}", text(most + 1));
        assert_eq!(
            refused.to_string().split(':').next(),
            Some("more than 32 nested brackets, roots, powers and signs")
        );
    }
    let brackets = |times: usize| format!("{}m{}", "(".repeat(times), ")".repeat(times));
    assert_eq!(unit(&brackets(31)).unwrap().dim.length, 1);
    assert!(matches!(unit(&brackets(32)), Err(ReadError::TooDeep { limit: 32, .. })));
    assert!(matches!(unit(&format!("s/{}", brackets(32))), Err(ReadError::TooDeep { limit: 32, .. })));
}

/// Zero is a number: its powers, roots, products and sums are, and only a division by it is not.
#[test]
fn zeros() {
    for (text, value) in [
        ("0^0", 1.0),
        ("0^2", 0.0),
        ("0²", 0.0),
        ("(0 m)^2", 0.0),
        ("2^0", 1.0),
        ("sqrt(0)", 0.0),
        ("√0 m", 0.0),
        ("sqrt(0 m^2)", 0.0),
        ("0*5 m", 0.0),
        ("5*0 m", 0.0),
        ("5 m*0", 0.0),
        ("0/5 m", 0.0),
        ("0 m/(2 s)", 0.0),
        ("3 - 3", 0.0),
        ("0 m + 0 mm", 0.0),
        ("2*(3-3) m", 0.0),
        ("-0", 0.0),
    ] {
        assert_eq!(si(text), value, "`{text}`");
    }
    for text in ["5/0 m", "5/(0 m)", "0/0", "0^-2", "(0 m)^-1", "5/(2-2)"] {
        let refused = read_any(text).unwrap_err();
        assert!(matches!(refused, ReadError::DivisionByZero { .. }), "`{text}`: {refused}");
    }
}

/// One unit in the last written place of a level, as a ratio: a difference of 0.1 dB is a factor of 10^(0.1/20).
#[test]
fn the_last_written_place_of_a_level() {
    for (text, decibels, place) in [("20.5 dB", 20.5, 0.1), ("-6 dB", -6.0, 1.0), ("3.01 dB", 3.01, 0.01)] {
        let level = read_any(text).unwrap();
        let ratio = 10f64.powf(decibels / 20.0);
        assert!((level.si / ratio - 1.0).abs() < 1e-15, "{text}: {}", level.si);
        // d(10^(L/20)) = 10^(L/20) ln(10)/20 dL
        let expected = ratio * 10f64.ln() / 20.0 * place;
        assert!((level.last_place / expected - 1.0).abs() < 1e-14, "{text}: {}", level.last_place);
    }
}

/// Brackets inside of a vector hold the marks between its components together.
#[test]
fn brackets_inside_of_vectors() {
    let metre = unit("m").unwrap();
    for (text, si) in [
        ("((1+1)/2; 3*(2-1)) m", [1.0, 3.0, 0.0]),
        ("((1 + 2) i - (5 - 1) j) m", [3.0, -4.0, 0.0]),
        ("(1 + 2) i - (5 - 1) j", [3.0, -4.0, 0.0]),
        ("(sqrt(4), 2*(1,5 + 0,5), 3)", [2.0, 4.0, 3.0]),
        ("[(1+2); 2; (3)] m", [3.0, 2.0, 3.0]),
        ("{(1+2); 2} m", [3.0, 2.0, 0.0]),
    ] {
        let read =
            read_vector(text, &metre, Kind::Length, 3).unwrap_or_else(|error| panic!("`{text}`: {error}"));
        assert_eq!(read.si, si, "`{text}`");
    }
    for text in ["(1; 2] m", "[1; 2) m", "(1; 2", "1; 2)", "((1; 2) m"] {
        assert!(read_vector(text, &metre, Kind::Length, 3).is_err(), "{text}");
    }
}

/// Feet and inches are recognized by both marks and two numbers, in a field of a length alone.
#[test]
fn feet_and_inches_need_both_marks() {
    let [metre, degree] = ["m", "deg"].map(|text| unit(text).unwrap());
    let hint = |text: &str| read_quantity(text, &metre, Kind::Length).unwrap_err().to_string();
    assert!(hint("3'6\"").ends_with("write `3 ft + 6 in`"), "{}", hint("3'6\""));
    for text in ["3'6", "-3'6\"", "3'\"", "'6\"", "x'6\"", "3'x\"", "3'6m\""] {
        assert!(!hint(text).contains("ft +"), "{}", hint(text));
    }
    // 3'6" of arc is 3/60 + 6/3600 degrees, which is written with its degrees.
    let arc = read_quantity("0°3'6\"", &degree, Kind::Angle).unwrap();
    assert!((arc.si - (3.0 / 60.0 + 6.0 / 3600.0_f64).to_radians()).abs() < 1e-17);
    let error = read_quantity("3'6\"", &degree, Kind::Angle).unwrap_err().to_string();
    assert!(!error.contains("ft"), "{error}");
    for (text, written) in [("6'", "`6 ft`"), ("6′", "`6 ft`"), ("7\"", "`7 in`"), ("7″", "`7 in`")] {
        assert!(hint(text).contains(written), "{}", hint(text));
    }
}
