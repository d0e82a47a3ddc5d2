//! Table of texts as users type them, with the quantity or the error that each must give.
// Long because it is the table of what people type.

use std::f64::consts::{PI, TAU};

use super::*;
use crate::{Dim, read_vector};

const LENGTH: [i8; 4] = [1, 0, 0, 0];
const FORCE: [i8; 4] = [1, 1, -2, 0];
const STRESS: [i8; 4] = [-1, 1, -2, 0];
const SPEED: [i8; 4] = [0, 0, -1, 1];

fn any(text: &str) -> Quantity {
    read_any(text).unwrap_or_else(|error| panic!("`{text}`: {error}"))
}

fn in_field(text: &str, default: &str, kind: Kind) -> Quantity {
    read_quantity(text, &unit(default).unwrap(), kind).unwrap_or_else(|error| panic!("`{text}`: {error}"))
}

fn refused(text: &str, default: &str, kind: Kind) -> String {
    match read_quantity(text, &unit(default).unwrap(), kind) {
        Ok(quantity) => panic!("`{text}` was read as {quantity:?}"),
        Err(error) => error.to_string(),
    }
}

#[test]
fn literals_are_exact() {
    #[rustfmt::skip]
    let cases: &[(&str, f64, [i8; 4])] = &[
        ("20.3 mm", 0.0203, LENGTH), ("20,3 mm", 0.0203, LENGTH), ("20.3mm", 0.0203, LENGTH), ("  20.3\u{a0}mm ", 0.0203, LENGTH),
        ("1\u{202f}000 mm", 1.0, LENGTH), ("12\u{2009}345\u{2009}678,5 mm", 12345.6785, LENGTH),
        ("20.3\u{202f}mm", 0.0203, LENGTH), ("20.3\u{2009}mm", 0.0203, LENGTH), ("+20.3 mm", 0.0203, LENGTH),
        ("-20.3 mm", -0.0203, LENGTH), ("−20.3 mm", -0.0203, LENGTH), (".5 m", 0.5, LENGTH), ("5. m", 5.0, LENGTH),
        ("0,125 m", 0.125, LENGTH), ("1,2345 m", 1.2345, LENGTH), ("1234,567 m", 1234.567, LENGTH), ("1.234 m", 1.234, LENGTH), ("3 in", 0.0762, LENGTH), ("12 ft", 3.6576, LENGTH),
        ("0.1 mm", 0.0001, LENGTH), ("7 µm", 7e-6, LENGTH), ("35 mil", 0.000889, LENGTH),
        ("1e-6 m", 1e-6, LENGTH), ("1E3 m", 1e3, LENGTH), ("1e−6 m", 1e-6, LENGTH), ("2.5e+2 m", 250.0, LENGTH),
        ("1.3×10⁻⁶ m", 1.3e-6, LENGTH), ("1.3 × 10⁻⁶ m", 1.3e-6, LENGTH), ("1.3x10^-6 m", 1.3e-6, LENGTH),
        ("1,3·10^−6 m", 1.3e-6, LENGTH), ("1.3*10**-6 m", 1.3e-6, LENGTH), ("4×10³ N", 4e3, FORCE),
        ("200 kN/mm^2", 2e11, STRESS), ("200 kN/mm2", 2e11, STRESS), ("200 kN/mm²", 2e11, STRESS), ("200 GPa", 2e11, STRESS),
        ("210 kN/(mm*mm)", 2.1e11, STRESS), ("7 kgf", 68.64655, FORCE), ("3 tf", 29419.95, FORCE),
        ("1.3e-6 m⁴", 1.3e-6, [4, 0, 0, 0]), ("130 cm^4", 1.3e-6, [4, 0, 0, 0]),
        ("52.08 N s / m", 52.08, [0, 1, -1, 0]), ("52,08 N·s/m", 52.08, [0, 1, -1, 0]), ("52.08 N*s*m^-1", 52.08, [0, 1, -1, 0]),
        ("3 kg/(m s)", 3.0, [-1, 1, -1, 0]), ("5 m/s/s", 5.0, [1, 0, -2, 0]), ("5 m/s²", 5.0, [1, 0, -2, 0]),
        ("5 m s⁻²", 5.0, [1, 0, -2, 0]), ("5 kg mm", 0.005, [1, 1, 0, 0]), ("72 g·mm", 7.2e-5, [1, 1, 0, 0]),
        ("8 N.m", 8.0, [2, 1, -2, 0]), ("8 kgf.m", 78.4532, [2, 1, -2, 0]), ("8 Nm", 8.0, [2, 1, -2, 0]),
        ("8 N·m/rad", 8.0, [2, 1, -2, -1]), ("10 1/s", 10.0, [0, 0, -1, 0]), ("10/s", 10.0, [0, 0, -1, 0]),
        ("2 g0", 19.6133, [1, 0, -2, 0]), ("2 gs", 19.6133, [1, 0, -2, 0]), ("2 g's", 19.6133, [1, 0, -2, 0]),
        ("12 %", 0.12, [0; 4]), ("12%", 0.12, [0; 4]), ("3 ‰", 0.003, [0; 4]), ("250 ppm", 250e-6, [0; 4]), ("0.06", 0.06, [0; 4]),
        ("12345678901234567890123 m", 12345678901234567890123.0, LENGTH), ("0.0000000000000000000000001 m", 1e-25, LENGTH),
        ("0 m", 0.0, LENGTH), ("0.000 mm", 0.0, LENGTH), ("0e999 m", 0.0, LENGTH), ("-0 m", 0.0, LENGTH),
    ];
    for &(text, si, [length, mass, time, angle]) in cases {
        let quantity = any(text);
        assert_eq!(quantity.si, si, "`{text}`");
        assert_eq!(quantity.unit.dim, Dim::new(length, mass, time, angle), "`{text}`");
    }
}

#[test]
fn arithmetic() {
    #[rustfmt::skip]
    let cases: &[(&str, f64, [i8; 4], &str)] = &[
        ("2*pi*50 rad/s", 100.0 * PI, SPEED, "rad/s"), ("2 pi 50 rad/s", 100.0 * PI, SPEED, "rad/s"), ("2π·50 rad/s", 100.0 * PI, SPEED, "rad/s"),
        ("2π rad", TAU, [0, 0, 0, 1], "rad"), ("π/6 rad", PI / 6.0, [0, 0, 0, 1], "rad"), ("100/(2 pi) Hz", 100.0, SPEED, "Hz"),
        ("1/2 in", 0.0127, LENGTH, "in"), ("1/4 in", 0.00635, LENGTH, "in"), ("5 1/2 in", 0.1397, LENGTH, "in"),
        ("1/2 N s/m", 0.5, [0, 1, -1, 0], "N*s/m"), ("3/4 kN/mm^2", 7.5e8, STRESS, "kN/mm^2"),
        ("(2 + 3) mm", 0.005, LENGTH, "mm"), ("2+3*4", 14.0, [0; 4], ""), ("(2+3)*4", 20.0, [0; 4], ""), ("12/4/3", 1.0, [0; 4], ""),
        ("12/4*3", 9.0, [0; 4], ""), ("10 - 4 - 3", 3.0, [0; 4], ""), ("2^3^2", 512.0, [0; 4], ""), ("-2^2", -4.0, [0; 4], ""), ("2^-1", 0.5, [0; 4], ""),
        ("2 * -3", -6.0, [0; 4], ""), ("2³", 8.0, [0; 4], ""), ("10⁻² m", 0.01, LENGTH, "m"), ("4^0.5", 2.0, [0; 4], ""),
        ("sqrt(2)", 2f64.sqrt(), [0; 4], ""), ("√2 m", 2f64.sqrt(), LENGTH, "m"), ("√(9) m", 3.0, LENGTH, "m"), ("3 sqrt(4) m", 6.0, LENGTH, "m"),
        ("sqrt(4 m^2)", 2.0, LENGTH, "m"), ("sqrt(40 kN/m / (10 kg))", 4000f64.sqrt(), [0, 0, -1, 0], "1/s"),
        ("1 m + 20 cm", 1.2, LENGTH, "m"), ("5 ft + 3 in", 1.6002, LENGTH, "ft"), ("1 m - 20 cm", 0.8, LENGTH, "m"), ("1 + 5 %", 1.05, [0; 4], ""),
        ("9.81*10 N", 98.1, FORCE, "N"), ("10 kg * 9.81 m/s^2", 98.1, FORCE, "kg*m/s^2"), ("5 N * 3 m", 15.0, [2, 1, -2, 0], "N*m"),
        ("2 m * 3 m", 6.0, [2, 0, 0, 0], "m^2"), ("(3 mm)^2", 9e-6, [2, 0, 0, 0], "mm^2"), ("(3 mm)²", 9e-6, [2, 0, 0, 0], "mm^2"),
        ("6 N/(2 m)", 3.0, [0, 1, -2, 0], "N/m"), ("6 N m/(2 rad s)", 3.0, [2, 1, -3, -1], "N*m/(rad*s)"), ("3 mm/(2 mm)", 1.5, [0; 4], ""),
        ("1/(0.5 s)", 2.0, [0, 0, -1, 0], "1/s"), ("10 N*m * 60 rpm", 20.0 * PI, [2, 1, -3, 1], "N*m*rpm"),
        ("1/2×10^3 N", 500.0, FORCE, "N"), ("2^3×10^2 N", 800.0, FORCE, "N"), ("1.5 x10⁻³ * 2 m", 0.003, LENGTH, "m"),
        ("30º5'", (30.0 + 5.0 / 60.0) * PI / 180.0, [0, 0, 0, 1], "°"),
        ("900 N/m*(0.8 m)^2", 576.0, [2, 1, -2, 0], "N*m"), ("2*4 N.m", 8.0, [2, 1, -2, 0], "N*m"), ("m/2", 0.5, LENGTH, "m"),
        // No dates.
        ("1000-2", 998.0, [0; 4], ""), ("2000-10-5", 1985.0, [0; 4], ""), ("1970-01", 1969.0, [0; 4], ""), ("12-01-01", 10.0, [0; 4], ""),
        ("2×10³ c/s", 4000.0 * PI, SPEED, "rps"), ("8. c/s", 16.0 * PI, SPEED, "rps"), ("½ c/s", PI, SPEED, "rps"),
        ("2*4×10³ N-m", 8e3, [2, 1, -2, 0], "N*m"),
        ("30°5'", (30.0 + 5.0 / 60.0) * PI / 180.0, [0, 0, 0, 1], "°"),
        ("30°15'", 30.25 * PI / 180.0, [0, 0, 0, 1], "°"), ("-30° 15' 36\"", -30.26 * PI / 180.0, [0, 0, 0, 1], "°"), ("90 deg/2", PI / 4.0, [0, 0, 0, 1], "deg"),
    ];
    for &(text, si, [length, mass, time, angle], written) in cases {
        let quantity = any(text);
        assert!((quantity.si - si).abs() <= 4e-16 * si.abs(), "`{text}`: {} or {si}", quantity.si);
        assert_eq!(quantity.unit.dim, Dim::new(length, mass, time, angle), "`{text}`");
        assert_eq!(quantity.unit.text, written, "`{text}`");
        assert_eq!(quantity.unit.factor, unit(written).unwrap().factor, "`{text}`");
    }
}

/// 60 rpm = 1 rev/s = 1 Hz as an angular velocity = 2π rad/s, whatever the field shows.
#[test]
fn a_turn_a_second() {
    for text in [
        "60 rpm",
        "1 rev/s",
        "1 Hz",
        "6.283185307179586 rad/s",
        "360 deg/s",
        "360 °/s",
        "1 r/s",
        "60 r/min",
        "60 cpm",
        "6.283185307179586 1/s",
        "2 pi 1/s",
        "3600 rev/h",
    ] {
        for default in ["rpm", "rad/s", "Hz"] {
            let speed = in_field(text, default, Kind::AngularVelocity).si;
            assert!((speed / TAU - 1.0).abs() < 3e-16, "`{text}`: {speed}");
        }
    }
    assert_eq!(in_field("1000", "rpm", Kind::AngularVelocity).si, 1000.0 * TAU / 60.0);
    let power = in_field("10 N*m * 60 rpm", "W", Kind::Power).si;
    assert!((power - 20.0 * PI).abs() < 1e-13);
}

#[test]
fn a_missing_angle_is_accepted_and_a_wrong_one_is_not() {
    for (text, default, kind) in [
        ("5 N*m", "N*m/rad", Kind::TorsionalStiffness),
        ("5 N*m/rad", "N*m/rad", Kind::TorsionalStiffness),
        ("5 N*m*s", "N*m*s/rad", Kind::TorsionalDamping),
        ("5 1/s", "rad/s", Kind::AngularVelocity),
        ("5 1/s^2", "rad/s^2", Kind::AngularAcceleration),
        ("5 m*rad/s", "m/s", Kind::Velocity),
        ("5 J", "J", Kind::Energy),
        ("5 N*m", "J", Kind::Energy),
        ("5 rad", "deg", Kind::Angle),
    ] {
        assert_eq!(in_field(text, default, kind).si, 5.0, "`{text}`");
    }
    refused("5 N*m/rad", "N*m", Kind::Torque);
    refused("5 rad^2/s", "rad/s", Kind::AngularVelocity);
    refused("5 deg", "1", Kind::Ratio);
    refused("5 Hz", "1/(rad*s)", Kind::Other);
}

#[test]
fn the_wrong_kind_is_named_with_what_was_meant() {
    for (text, default, kind, words) in [
        (
            "10 kg",
            "N",
            Kind::Force,
            "`10 kg` is a mass; a force expected, e.g. in N; a weight is mass × g: write `9.81*10 N` or `10 kgf`",
        ),
        ("10 g", "kN", Kind::Force, "write `9.81*0.01 N` or `0.01 kgf`"),
        (
            "98.1 N",
            "kg",
            Kind::Mass,
            "`98.1 N` is a force; a mass expected, e.g. in kg; a mass is weight / g: write `98.1/9.81 kg`",
        ),
        ("10 lb", "N", Kind::Force, "write `10 lbf`"),
        ("2 g", "m/s^2", Kind::Acceleration, "write `2 g0`"),
        (
            "3 kJ",
            "N*m",
            Kind::Torque,
            "`3 kJ` is an energy; a torque expected, e.g. in N*m; write N·m for a torque: `3000 N*m`",
        ),
        ("2 W*s", "N*m", Kind::Torque, "is an energy"),
        ("20.3 mm", "kg", Kind::Mass, "`20.3 mm` is a length; a mass expected, e.g. in kg"),
        ("3 mm pp", "mm", Kind::Length, "belong to amplitudes"),
        (
            "3 mm/s rms",
            "mm",
            Kind::Amplitude,
            "`3 mm/s rms` is an amplitude in mm/s rms; an amplitude in mm expected",
        ),
        ("20 dB", "mm", Kind::Length, "is a level"),
        ("30 %", "deg", Kind::Angle, "slope"),
        ("6'", "m", Kind::Length, "write `6 ft`"),
        ("1/0.5 s", "rad/s", Kind::AngularVelocity, "`1/(0.5 s)`"),
        ("5 mm", "mm/s", Kind::Amplitude, "an amplitude in mm/s expected"),
        ("3 kg^3", "N", Kind::Force, "is a quantity in kg³"),
        ("20 dB", "rad", Kind::Other, "is a level"),
        ("5 s", "kN", Kind::Force, "e.g. in kN"),
    ] {
        let message = refused(text, default, kind);
        assert!(message.contains(words), "`{text}`: {message}");
    }
}

/// No intention is guessed where none is near.
#[test]
fn the_wrong_kind_has_no_hint_without_a_reason() {
    for (text, default, kind) in [
        ("20 mm", "N", Kind::Force),
        ("3 kg", "m", Kind::Length),
        ("7 ps", "m", Kind::Length),
        ("5 s", "deg", Kind::Angle),
        ("6 m/(2 rad)", "m", Kind::Length),
    ] {
        let message = refused(text, default, kind);
        assert!(message.ends_with(&format!("e.g. in {default}")), "`{text}`: {message}");
    }
}

/// A product of quantities is shown in the unit of its field, a number times a quantity in that of the quantity.
#[test]
fn the_unit_of_a_product() {
    for (text, default, kind, si, shown) in [
        ("10 N*m * 60 rpm", "W", Kind::Power, 20.0 * PI, "W"),
        ("2 kg * 3 m * 4 * 1 s^-2", "N", Kind::Force, 24.0, "N"),
        ("2*3 yd", "m", Kind::Length, 5.4864, "yd"),
        // The radians of an angular velocity drop out, of its root too.
        ("6 m/s / (3 rad/s)", "m", Kind::Length, 2.0, "m"),
        ("6 m^2/s / sqrt(9 m^2*(1 rad/s)^2)", "m", Kind::Length, 2.0, "m"),
    ] {
        let quantity = in_field(text, default, kind);
        assert!((quantity.si / si - 1.0).abs() < 1e-15, "`{text}`: {}", quantity.si);
        assert_eq!(quantity.unit.text, shown, "`{text}`");
    }
    let behind = any("mm*5.0");
    assert_eq!((behind.si, behind.last_place), (0.005, 1e-4));
}

/// Repairs suggested by messages are themselves valid texts of the meaning they promise.
#[test]
fn repairs_can_be_typed() {
    for (text, kind, si) in [
        ("9.81*10 N", Kind::Force, 98.1),
        ("10 kgf", Kind::Force, 98.0665),
        ("98.1/9.81 kg", Kind::Mass, 10.0),
        ("2 g0", Kind::Acceleration, 19.6133),
        ("(pi/2) rad", Kind::Angle, PI / 2.0),
        ("(N/m)*s * 2", Kind::Other, 2.0),
        ("2 N/(m*s)", Kind::Other, 2.0),
    ] {
        let default = kind.units().first().copied();
        let quantity = default.map_or_else(|| any(text), |default| in_field(text, default, kind));
        assert!((quantity.si - si).abs() < 1e-14 * si, "`{text}`: {}", quantity.si);
    }
}

#[test]
fn amplitudes_are_kept_as_peaks() {
    let rms = 3.0 * 2f64.sqrt() * 1e-3;
    for (text, si, shown) in [
        ("3 mm pp", 0.0015, "mm pp"),
        ("3 mm p-p", 0.0015, "mm pp"),
        ("3 mm pk-pk", 0.0015, "mm pp"),
        ("3 mm rms", rms, "mm rms"),
        ("3 mm RMS", rms, "mm rms"),
        ("3 mm pk", 0.003, "mm pk"),
        ("3 mm", 0.003, "mm"),
        ("3", 0.003, "mm"),
        ("2*1.5 mm pp", 0.0015, "mm pp"),
        ("20,3 mm pp", 0.01015, "mm pp"),
        ("3 pp", 0.0015, "mm pp"),
    ] {
        let amplitude = in_field(text, "mm", Kind::Amplitude);
        assert!((amplitude.si / si - 1.0).abs() < 2e-16, "`{text}`: {}", amplitude.si);
        assert_eq!(amplitude.unit.text, shown);
        assert_eq!(Kind::of(&amplitude.unit), if shown == "mm" { Kind::Length } else { Kind::Amplitude });
    }
    assert_eq!(in_field("3", "mm pp", Kind::Amplitude).si, 0.0015);
    assert!((in_field("7.1 mm/s rms", "mm/s", Kind::Amplitude).si - 0.010040916292848976).abs() < 1e-17);
    assert_eq!(in_field("3 mil pp", "µm pp", Kind::Amplitude).si, 3.81e-5);
}

#[test]
fn levels() {
    for (text, ratio) in [("20 dB", 10.0), ("0 dB", 1.0), ("-40 dB", 0.01), ("6 dB", 1.9952623149688795)] {
        let level = in_field(text, "1", Kind::Ratio);
        assert!((level.si / ratio - 1.0).abs() < 1e-15, "{text}");
        assert_eq!(level.unit.text, "dB");
    }
    let computed = in_field("2*10", "dB", Kind::Ratio);
    assert_eq!((computed.si, computed.last_place), (10.0, 0.0));
    assert!((any("20 dB").last_place - 10.0 * 10f64.ln() / 20.0).abs() < 1e-14);
    for text in [
        "2*10 dB",
        "3 dB + 3 dB",
        "20 dB/s",
        "2 m dB",
        "dB",
        "20 dB pp",
        "(2+3) dB",
        "3 rms",
        "3 % * dB",
        "20 dB dB",
        "20 dB^2",
    ] {
        assert!(read_any(text).is_err(), "{text}");
    }
}

#[test]
fn the_last_written_place() {
    for (text, place) in [
        ("1674.2 N*mm", 1e-4),
        ("8.37 kg", 0.01),
        ("82350 N*m", 1.0),
        ("7.200 kg", 0.001),
        ("1.3e-6 m^4", 1e-7),
        ("1.30×10⁻⁶ m⁴", 1e-8),
        ("12,4 mm", 1e-4),
        ("8.37×10³ N", 10.0),
        ("5 in", 0.0254),
        ("3.0 mm pp", 5e-5),
        ("0e77003 m", f64::MAX),
    ] {
        let found = any(text).last_place;
        assert!((found / place - 1.0).abs() < 1e-15, "`{text}`: {found}");
    }
    assert_eq!(any("2*3 m").last_place, 0.0);
}

#[test]
fn a_bare_number_takes_the_unit_of_the_field() {
    let quantity = in_field("20,3", "mm", Kind::Length);
    assert_eq!((quantity.si, &*quantity.unit.text, quantity.last_place), (0.0203, "mm", 1e-4));
    assert_eq!(in_field("1+2", "kN", Kind::Force).si, 3000.0);
    // π in a field of degrees: both readings are named.
    let message = refused("pi/2", "deg", Kind::Angle);
    assert!(message.contains("`(pi/2) rad`") && message.contains("`(pi/2) deg`"), "{message}");
    assert_eq!(in_field("pi/2", "rad", Kind::Angle).si, PI / 2.0);
    assert_eq!(in_field("3 mm/(2 mm)", "%", Kind::Ratio).si, 1.5);
    refused("3 mm/(2 mm)", "mm", Kind::Length);
}

#[test]
fn two_readings_are_refused_with_both() {
    for (text, first, second) in [
        ("1,250 kg", "1250", "1.250"),
        ("12,345", "12345", "12.345"),
        ("2 + 123,456 m", "123456", "123.456"),
        ("1.234,5 mm", "1234.5", "1.2345"),
        ("1,234.5 mm", "1234.5", "1.2345"),
        ("1,234,567 mm", "1234567", "1.234567"),
        ("1.234.567,8 mm", "1234567.8", "1.2345678"),
        ("12 34 mm", "1234", "12*34"),
        ("1 000 50 mm", "100050", "1 000*50"),
        ("5 ft 3 in", "5 ft + 3 in", "5 ft*3 in"),
        ("3 N/m s", "(3 N/m)*s", "3 N/(m*s)"),
        ("3 N/m*s", "(3 N/m)*s", "3 N/(m*s)"),
        ("3 N/m^2 s", "(3 N/m^2)*s", "3 N/(m^2*s)"),
        ("1/2 pi", "(1/2)*pi", "1/(2*pi)"),
        ("3 N/2 mm", "(3 N/2)*mm", "3 N/(2*mm)"),
        ("1.3×10-6 m", "1.3*10^-6", "1.3*10 - 6"),
        ("1,3x10-6 m4", "1,3*10^-6", "1,3*10 - 6"),
        ("12/4*3 pi", "(12/4*3)*pi", "12/(4*3*pi)"),
    ] {
        let message = refused(text, "m", Kind::Other);
        for reading in [first, second] {
            assert!(message.contains(&format!("`{reading}`")), "`{text}`: {message}");
            any(reading);
        }
    }
    for text in ["N/m s", "N/(m s) kg", "N/m*s", "m/s·kg"] {
        let message = unit(text).unwrap_err().to_string();
        assert!(message.contains("two ways"), "{message}");
    }
}

#[test]
fn refusals_name_the_value_and_the_repair() {
    for (text, words) in [
        ("", "a value is needed, for example 20.3 m"),
        ("   ", "a value is needed"),
        ("abc", "unknown unit `abc`"),
        ("1970-01-01", "`1970-01-01` is not a number"),
        ("20.3 Mpa", "did you mean `MPa`"),
        // Behind an operator a name may be that of a definition.
        ("5*newtons", "unknown unit `newtons`: did you mean `N`"),
        ("10/second", "unknown unit `second`: did you mean `s`"),
        ("2 - metres", "unknown unit `metres`: did you mean `m`"),
        // Cycles stand behind a number alone.
        ("2*c/s", "unknown unit `c`"),
        ("2 N*c/s", "unknown unit `c`"),
        ("12 kg /", "is incomplete: a number or a unit expected"),
        ("12 *", "is incomplete"),
        ("(2 + 3", "a closing bracket expected"),
        ("2)", "unexpected `)`"),
        ("nan", "`nan` is not a number"),
        ("NaN m", "`NaN` is not a number"),
        ("inf", "`inf` is not a number"),
        ("-inf m", "`inf` is not a number"),
        ("1e400 m", "`1e400 m` is too large"),
        ("1e400*2 m", "`1e400` is too large"),
        ("-1e999999999999 m", "too large"),
        ("1e308 km", "too large"),
        ("1e-400 m", "too close to zero"),
        ("1e-320 pm", "too close to zero"),
        ("1e200*1e200 m", "`1e200*1e200` is too large"),
        ("1e-200*1e-200 m", "too close to zero"),
        ("10^400", "too large"),
        ("1/0 m", "`1/0` divides by zero"),
        ("1/(2-2) m", "divides by zero"),
        ("0^-1", "divides by zero"),
        ("(-8)^0.5", "not a real number"),
        ("sqrt(-1)", "`sqrt(-1)` is not a real number"),
        ("sqrt(4 m)", "square root of m is not a unit"),
        ("sqrt 2", "an opening bracket expected"),
        ("m", "`m` is not a number"),
        ("2 m + s", "is not a number"),
        ("1 m + 2 s", "a length and a time cannot be added"),
        ("5 - 3 mm", "a number without a unit and a length cannot be added"),
        ("1 N*m + 1 N*m/rad", "cannot be added"),
        ("0x10", "unknown unit `x`"),
        ("1_000 m", "unknown unit `_`"),
        ("١٢ m", "unexpected"),
        ("5 m^99", "unexpected `^99` after the unit"),
        ("5 m^2.5", "after the unit: an exponent"),
        ("2^(1 m)", "after the unit: an exponent"),
        ("5 ((m^12)^12)^12", "exponent"),
        ("5\u{7} m", "U+0007"),
        ("5 m\u{1b}[31m", "U+001B"),
        ("5\u{200b} m", "U+200B"),
        ("5\u{202e} m", "U+202E"),
        ("5\tm", "U+0009"),
        ("5 m; 3 m", "unexpected `;`"),
        ("5 1 m", "a gap between digits"),
        ("5 m 3", "unexpected `3`"),
        ("1'000 m", "a gap between digits"),
        ("5 m = 3", "unexpected `=`"),
        ("5 °C", "unknown unit `C`"),
    ] {
        let message = refused(text, "m", Kind::Other);
        assert!(message.contains(words), "`{text}`: {message}");
        assert!(!message.contains(char::is_control), "{message}");
    }
    for (text, limit) in
        [("1".repeat(201), "200"), ("(".repeat(10_000_000), "200"), (format!("{}1", "-".repeat(150)), "32")]
    {
        let message = refused(&text, "m", Kind::Length);
        assert!(message.contains(limit), "{message}");
    }
    assert!(read_quantity(&"√".repeat(199), &Unit::ONE, Kind::Other).is_err());
    assert!(read_quantity(&format!("{}2", "2^".repeat(90)), &Unit::ONE, Kind::Other).is_err());
    assert!(unit(&"(".repeat(90)).is_err());
    // 200 characters are read, whatever their length in bytes.
    assert_eq!(any(&format!("{}1", "+".repeat(20))).si, 1.0);
    assert_eq!(any(&format!("1{}", " µm".repeat(5))).unit.dim.length, 5);
}

#[test]
fn spans_point_at_the_fault() {
    for (text, part) in [
        ("  20.3 Mpa ", "Mpa"),
        ("5 + 1.2,3 m", "1.2,3"),
        ("3 N/m s", "3 N/m s"),
        (" 20.3 mm ", "20.3 mm"),
        ("5 µg $", "$"),
        ("5\u{7} kg", "\u{7}"),
        ("(2 + 1/0) kg", "1/0"),
        ("5 m^99", "^99"),
    ] {
        let error = read_quantity(text, &unit("kg").unwrap(), Kind::Mass).unwrap_err();
        assert_eq!(&text[error.span().unwrap()], part, "{error}");
    }
    assert_eq!(unit(" ((m^12)^12)^12").unwrap_err().span(), Some(1..15));
}

#[test]
fn units() {
    for (text, pretty, ascii, factor) in [
        ("kN/mm^2", "kN/mm²", "kN/mm^2", 1e9),
        ("kN/mm2", "kN/mm²", "kN/mm^2", 1e9),
        ("N·m", "N·m", "N*m", 1.0),
        ("N m", "N·m", "N*m", 1.0),
        ("N.m", "N·m", "N*m", 1.0),
        ("N*m**2", "N·m²", "N*m^2", 1.0),
        ("kg mm", "kg·mm", "kg*mm", 1e-3),
        ("m s^-2", "m·s⁻²", "m*s^-2", 1.0),
        ("m s⁻²", "m·s⁻²", "m*s^-2", 1.0),
        ("m^(-2)", "m⁻²", "m^-2", 1.0),
        ("1/s", "1/s", "1/s", 1.0),
        ("1 / s", "1/s", "1/s", 1.0),
        ("N*m/(rad s)", "N·m/(rad·s)", "N*m/(rad*s)", 1.0),
        ("(N m)/rad", "(N·m)/rad", "(N*m)/rad", 1.0),
        ("deg", "°", "deg", TAU / 360.0),
        ("º", "°", "deg", TAU / 360.0),
        ("N*m/deg", "N·m/°", "N*m/deg", 360.0 / TAU),
        ("um", "µm", "um", 1e-6),
        ("μm", "µm", "um", 1e-6),
        ("‰", "‰", "permil", 1e-3),
        ("mm pp", "mm pp", "mm pp", 5e-4),
        ("mm/s  rms", "mm/s rms", "mm/s rms", 2f64.sqrt() * 1e-3),
        ("1", "", "", 1.0),
        ("", "", "", 1.0),
        (" ", "", "", 1.0),
        ("g's", "g's", "g's", 9.80665),
    ] {
        let read = unit(text).unwrap_or_else(|error| panic!("`{text}`: {error}"));
        assert_eq!((read.pretty().as_str(), read.ascii().as_str()), (pretty, ascii), "`{text}`");
        assert!((read.factor / factor - 1.0).abs() < 3e-16, "`{text}`: {}", read.factor);
        for again in [unit(&read.pretty()).unwrap(), unit(&read.ascii()).unwrap()] {
            assert_eq!(
                (again.factor, again.dim, again.sense),
                (read.factor, read.dim, read.sense),
                "`{text}`"
            );
        }
    }
    for text in [
        "2 m", "1 m", "1*m", "m+s", "m^", "m^x", "(m", "m)", "m//s", "/s", "*m", "m/", "m^2.5", "m^13",
        "pi m", "m m\u{7}",
    ] {
        assert!(unit(text).is_err(), "{text}");
    }
}

#[test]
fn kinds_of_units() {
    for (text, kind) in [
        ("N*m", Kind::Torque),
        ("kgf*m", Kind::Torque),
        ("J", Kind::Energy),
        ("kWh", Kind::Energy),
        ("W*s", Kind::Energy),
        ("W", Kind::Power),
        ("J/s", Kind::Power),
        ("J/m", Kind::Force),
        ("N*m/rad", Kind::TorsionalStiffness),
        ("Hz", Kind::AngularVelocity),
        ("1/s", Kind::AngularVelocity),
        ("mm", Kind::Length),
        ("mm pp", Kind::Amplitude),
        ("dB", Kind::Ratio),
        ("%", Kind::Ratio),
        ("deg", Kind::Angle),
        ("g*mm", Kind::Unbalance),
        ("oz*in", Kind::Unbalance),
        ("kg*m^2", Kind::MomentOfInertia),
        ("m^4", Kind::SecondMoment),
        ("mm/N", Kind::Compliance),
        ("psi", Kind::Stress),
        ("N*s", Kind::Momentum),
        ("N*m*s", Kind::AngularMomentum),
        ("N*m*s/rad", Kind::TorsionalDamping),
        ("kg^3", Kind::Other),
        ("1/m", Kind::Other),
    ] {
        assert_eq!(Kind::of(&unit(text).unwrap()), kind, "{text}");
    }
}

#[test]
fn vectors() {
    for (text, si, len) in [
        ("(300; 200) m/s", [300.0, 200.0, 0.0], 2),
        ("(300; 200; 0) m/s", [300.0, 200.0, 0.0], 3),
        ("300; 200 m/s", [300.0, 200.0, 0.0], 2),
        ("300; 200", [300.0, 200.0, 0.0], 2),
        ("[3; −2,5; 1e3] mm/s", [0.003, -0.0025, 1.0], 3),
        ("(300 mm/s; 200 m/s; 1 m/s)", [0.3, 200.0, 1.0], 3),
        ("(300; 200 m/s)", [300.0, 200.0, 0.0], 2),
        ("(2*3; (1+1)/4) m/s", [6.0, 0.5, 0.0], 2),
        ("(300 i + 200 j) m/s", [300.0, 200.0, 0.0], 2),
        ("(−300 i − 200 j + 1e-3 k) m/s", [-300.0, -200.0, 0.001], 3),
        ("(1.5×10⁻³ i - 10^-2 k) m/s", [0.0015, 0.0, -0.01], 3),
        ("300i-200j", [300.0, -200.0, 0.0], 2),
        ("3 j + 10 k m/s", [0.0, 3.0, 10.0], 3),
        ("-2i + 3j m/s", [-2.0, 3.0, 0.0], 2),
        ("(3 j + 10 k) m/s", [0.0, 3.0, 10.0], 3),
        ("3 m/s i + 4 mm/s j", [3.0, 0.004, 0.0], 2),
        ("3 i m/s + 4 j m/s", [3.0, 4.0, 0.0], 2),
        ("{80i - 60j} m/s", [80.0, -60.0, 0.0], 2),
        ("(300, 200) m/s", [300.0, 200.0, 0.0], 2),
        ("(1, 1, 2) m/s", [1.0, 1.0, 2.0], 3),
        ("(1,1,2) m/s", [1.0, 1.0, 2.0], 3),
        ("[0, 0, 1]", [0.0, 0.0, 1.0], 3),
        ("1, 1, 2 m/s", [1.0, 1.0, 2.0], 3),
        ("(1 m/s, 20 mm/s)", [1.0, 0.02, 0.0], 2),
        ("(1,5 i + 2,5 j) m/s", [1.5, 2.5, 0.0], 2),
        ("(1,5) i + 2 j", [1.5, 2.0, 0.0], 2),
        ("5 m/s @ 90 deg", [0.0, 5.0, 0.0], 2),
        ("5 @ 180°", [-5.0, 0.0, 0.0], 2),
        ("5 m/s ∠ -90 deg", [0.0, -5.0, 0.0], 2),
        ("5 m/s@2*pi rad", [5.0, 0.0, 0.0], 2),
        ("(j) m/s", [0.0, 1.0, 0.0], 2),
        ("(3 i - j) m/s", [3.0, -1.0, 0.0], 2),
        ("(2*3 i - 2*2 j) m/s", [6.0, -4.0, 0.0], 2),
        ("0 m/s", [0.0; 3], 3),
        ("0", [0.0; 3], 3),
    ] {
        let default = unit("m/s").unwrap();
        let vector = read_vector(text, &default, Kind::Velocity, 3)
            .unwrap_or_else(|error| panic!("`{text}`: {error}"));
        assert_eq!((vector.si, vector.len), (si, len), "`{text}`");
    }
    let vector = read_vector("(1.25; 2) mm", &unit("m").unwrap(), Kind::Length, 3).unwrap();
    assert_eq!((vector.last_place, &*vector.unit.text), (1e-3, "mm"));
    let zero = read_vector("(3; 4) m", &unit("m").unwrap(), Kind::Length, 2).unwrap();
    assert_eq!((zero.si, zero.len), ([3.0, 4.0, 0.0], 2));
    for (text, len, words) in [
        (
            "(1; 2; 3; 4) m/s",
            3,
            "4 components are written where 2 or 3 are expected: write them as in `(3; 4; 0) m/s`",
        ),
        ("(1; 2; 3) m/s", 2, "3 components are written where 2 are expected"),
        ("(i + 2 k) m/s", 2, "3 components"),
        ("5 m/s", 3, "1 component is written"),
        ("(1,1, 2) m/s", 3, "write `(1; 1; 2) m/s` or `(1,1; 2) m/s`"),
        ("(1, 2, 3, 4) m/s", 3, "4 components"),
        ("(1,2,3,4) m/s", 3, "4 components"),
        ("1,5 m/s", 3, "1 component is written"),
        ("5 m/s @ 30", 2, "write `5 m/s @ 30 deg` or `5 m/s @ 30 rad`"),
        ("5 m/s @", 2, "an angle expected"),
        ("5 m/s @ 3 m", 2, "an angle expected"),
        ("5 m @ 30 deg", 2, "a velocity expected"),
        ("(1 m/s i + 2 m/s j m/s)", 3, "one unit expected"),
        ("(1; 2) m", 3, "a length; a velocity expected"),
        ("(1 m/s; 2) m/s", 3, "with some components only"),
        ("(1 m/s; 2; 3)", 3, "with some components only"),
        ("(1; ; 3) m/s", 3, "a component expected"),
        ("(1 i + 2 i) m/s", 3, "each axis once"),
        ("(2 + 1 i) m/s", 3, "a component along i, j or k expected"),
        ("(1; nan) m/s", 3, "`nan` is not a number"),
        ("(1; 1e400) m/s", 3, "too large"),
        ("(1; 2", 3, "closing bracket"),
        ("", 3, "a value is needed, for example (3; 4; 0) m/s"),
        ("", 2, "a value is needed, for example (3; 4) m/s"),
    ] {
        let message = read_vector(text, &unit("m/s").unwrap(), Kind::Velocity, len).unwrap_err().to_string();
        assert!(message.contains(words), "`{text}`: {message}");
    }
    let long = "1;".repeat(1000);
    assert!(matches!(read_vector(&long, &Unit::ONE, Kind::Ratio, 3), Err(ReadError::TooLong { limit: 600 })));
}

#[test]
fn counts() {
    assert_eq!(read_count(" 12 ").unwrap(), 12);
    assert_eq!(read_count("0").unwrap(), 0);
    for text in ["", "-1", "+1", "1.5", "1e3", "1 000", "one", "99999999999999999999", "١", "3 m", "1\u{7}"]
    {
        assert!(read_count(text).is_err(), "{text}");
    }
}

#[test]
fn vectors_by_magnitude_and_angle() {
    let newton = unit("N").unwrap();
    for text in ["80 lbf @ 330 deg", "80 lbf ∠ 330°", "80 lbf@-30 deg"] {
        let vector =
            read_vector(text, &newton, Kind::Force, 2).unwrap_or_else(|error| panic!("`{text}`: {error}"));
        let lbf = 4.4482216152605;
        assert!((vector.si[0] - 40.0 * 3f64.sqrt() * lbf).abs() < 1e-12, "`{text}`: {vector:?}");
        assert!((vector.si[1] + 40.0 * lbf).abs() < 1e-12, "`{text}`: {vector:?}");
        assert_eq!((vector.len, &*vector.unit.text), (2, "lbf"));
    }
    // A vector as it is shown is read again, with its brackets and without.
    let style = crate::Style { digits: 17, ..crate::Style::default() };
    let shown = crate::write_vector([0.0, 3.0, -10.5], &unit("rad/s").unwrap(), style);
    for text in [shown.clone(), shown.replace(['(', ')'], "")] {
        let again = read_vector(&text, &unit("rad/s").unwrap(), Kind::AngularVelocity, 3).unwrap();
        assert_eq!(again.si, [0.0, 3.0, -10.5], "`{text}`");
    }
}

/// Whatever is typed is read or refused: no panic, no endless loop, nothing that is not finite.
#[test]
fn any_text_is_read_or_refused() {
    const PIECES: &[&str] = &[
        "1", "2.5", "0", "9", "12", "1e", "1e9", "e-6", "e", ".", ",", "-", "−", "+", "*", "/", "^", "**",
        "(", ")", "[", "]", ";", " ", "\u{a0}", "pi", "π", "sqrt", "sqrt(", "√", "m", "mm", "kg", "N", "rad",
        "rpm", "°", "'", "\"", "dB", "%", "pp", " pp", " rms", "²", "⁻¹", "⁻", "×10", "x10", "10", "i", "j",
        "k", " i", "g's", "g0", "·", "nan", "inf", "µ", "é", "漢", "\u{200b}", "\0", "½", "١", "🦀", "1/2",
        "s",
    ];
    let bares = ["m", "deg", "rad/s", "1", "dB", "mm pp", "N*m"].map(|text| unit(text).unwrap());
    let kinds = [
        Kind::Length,
        Kind::Angle,
        Kind::AngularVelocity,
        Kind::Ratio,
        Kind::Ratio,
        Kind::Amplitude,
        Kind::Torque,
    ];
    let mut state: u64 = 2026;
    let mut random = |below: usize| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as usize % below
    };
    let mut read = 0;
    for _ in 0..15_000 {
        let text: String = (0..=random(12)).map(|_| PIECES[random(PIECES.len())]).collect();
        let n = random(bares.len());
        assert_eq!(quantity_of(&text), read_any(&text).ok());
        for result in [read_quantity(&text, &bares[n], kinds[n]), read_any(&text)] {
            match result {
                Ok(quantity) => {
                    read += 1;
                    assert!(
                        quantity.si.is_finite() && quantity.last_place.is_finite(),
                        "`{text}`: {quantity:?}"
                    );
                    assert!(
                        quantity.unit.factor.is_finite() && quantity.unit.factor > 0.0,
                        "`{text}`: {quantity:?}"
                    );
                    let again = unit(&quantity.unit.text).unwrap_or_else(|error| panic!("`{text}`: {error}"));
                    assert!(
                        (again.factor / quantity.unit.factor - 1.0).abs() < 1e-14,
                        "`{text}`: {quantity:?}"
                    );
                    assert_eq!(again.dim, quantity.unit.dim, "`{text}`");
                }
                Err(error) => {
                    let message = error.to_string();
                    assert!(!message.contains(char::is_control), "{message:?}");
                    if let Some(span) = error.span() {
                        assert!(text.get(span).is_some(), "`{text}`: {error:?}");
                    }
                }
            }
        }
        match read_vector(&text, &bares[n], kinds[n], 2 + n % 2) {
            Ok(vector) => assert!(vector.si.iter().all(|component| component.is_finite()), "`{text}`"),
            Err(error) => {
                if let Some(span) = error.span() {
                    assert!(text.get(span).is_some(), "`{text}`: {error:?}");
                }
            }
        }
        let _ = (unit(&text), read_count(&text));
    }
    assert!(read > 300, "only {read} of the texts were quantities");
}

/// The quick way for a literal and its unit, and the arithmetic, read the same.
#[test]
fn both_ways_read_the_same() {
    for text in [
        "20.3 mm",
        "1.3×10⁻⁶ m⁴",
        "200 kN/mm2",
        "-5 N.m/(rad s)",
        "3 in",
        "7,2 g·mm",
        "2 g's",
        "8 kgf/cm^2",
        "12 %",
        "1e-3 1/s",
        "9 m/s/s",
    ] {
        let quick = any(text);
        let slow = expression::evaluate(Cursor::new(text, 0..text.len())).unwrap();
        let other = si(slow.amount, slow.unit.as_ref().unwrap()).0;
        assert!((other / quick.si - 1.0).abs() < 3e-16, "`{text}`: {other} or {}", quick.si);
        assert_eq!(slow.unit.unwrap().dim, quick.unit.dim, "`{text}`");
    }
}

#[test]
fn feet_and_inches_and_a_letter_left_out_are_refused_with_what_to_write() {
    let (metre, radian) = (unit("m").unwrap(), unit("rad").unwrap());
    for (typed, written) in
        [("3'6\"", "3 ft + 6 in"), ("3' 6.5\"", "3 ft + 6.5 in"), ("5′ 11 1/2″", "5 ft + 11 1/2 in")]
    {
        let error = read_quantity(typed, &metre, Kind::Length).unwrap_err().to_string();
        assert!(error.ends_with(&format!("write `{written}`")), "{typed}: {error}");
        assert!(read_quantity(written, &metre, Kind::Length).is_ok(), "{written}");
    }
    let length = read_quantity("3 ft + 6 in", &metre, Kind::Length).unwrap();
    assert!((length.si - 3.5 * 0.3048).abs() < 1e-15);
    let error = read_quantity("7 dg", &radian, Kind::Angle).unwrap_err().to_string();
    assert!(error.ends_with("did you mean `7 deg`?"), "{error}");
    let error = read_quantity("3 kg", &metre, Kind::Length).unwrap_err().to_string();
    assert!(!error.contains("did you mean"), "{error}");
}

#[test]
fn a_decimal_comma_is_taken_back() {
    for (text, comma) in [
        ("20.3 mm", "20,3 mm"),
        ("1.3e-6 m^4", "1,3e-6 m^4"),
        ("(0.5; -.25) m/s", "(0,5; -,25) m/s"),
        ("2.5*pi*50 rad/s", "2,5*pi*50 rad/s"),
        ("9/6", "9/6"),
        ("2 .. 3 mm", "2 .. 3 mm"),
    ] {
        assert_eq!(with_comma(text), comma);
        assert_eq!(with_point(comma), text);
    }
}

/// Only what is one number with one comma is taken for a decimal comma.
#[test]
fn a_comma_that_is_no_decimal_mark_stays() {
    for text in ["1,234.5 m", "1.234,5 m", "1,234,567 m", "atan2(1, 2)", "1, 2", ",", "2, and 3"] {
        assert_eq!(with_point(text), text);
    }
    assert_eq!(with_point("(1,250; -0,5) m, 2,5"), "(1.250; -0.5) m, 2.5");
}
