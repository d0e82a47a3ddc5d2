//! Tests of writing quantities, and of reading them back.

use super::*;
use crate::{read_any, read_quantity, read_vector, with_point};

const SCREEN: Style = Style { digits: 5, decimal: Decimal::Point, ascii: false };
const COMMA: Style = Style { decimal: Decimal::Comma, ..SCREEN };
const ASCII: Style = Style { ascii: true, ..SCREEN };

fn digits(digits: u8) -> Style {
    Style { digits, ..SCREEN }
}

#[test]
fn numbers() {
    for (value, style, text) in [
        (451.388888, SCREEN, "451.39"),
        (451388.888, SCREEN, "4.5139×10⁵"),
        (451388.888, ASCII, "4.5139e5"),
        (451388.888, COMMA, "4,5139×10⁵"),
        (106.2285, SCREEN, "106.23"),
        (0.1, SCREEN, "0.1"),
        (0.1 + 0.2, digits(17), "0.30000000000000004"),
        (0.001, SCREEN, "0.001"),
        (0.00099999, SCREEN, "9.9999×10⁻⁴"),
        (0.000999999, SCREEN, "0.001"),
        (99999.4, SCREEN, "99999"),
        (99999.6, SCREEN, "1×10⁵"),
        (12345.0, digits(3), "12300"),
        (1.3e-6, SCREEN, "1.3×10⁻⁶"),
        (-1.3e-6, SCREEN, "−1.3×10⁻⁶"),
        (-1.3e-6, ASCII, "-1.3e-6"),
        (-0.5, ASCII, "-0.5"),
        (0.0, SCREEN, "0"),
        (-0.0, SCREEN, "0"),
        (10.0, SCREEN, "10"),
        (2.5, digits(1), "2"),
        (3.5, digits(1), "4"),
        (0.05, digits(0), "0.05"),
        (1e300, SCREEN, "1×10³⁰⁰"),
        (1.0 / 3.0, Style { digits: 255, ..SCREEN }, "0.33333333333333331"),
        (f64::NAN, SCREEN, "undefined"),
        (f64::NEG_INFINITY, SCREEN, "−infinite"),
    ] {
        assert_eq!(write_number(value, style), text);
    }
}

#[test]
fn quantities() {
    for (text, style, written) in [
        ("451388.888 N/m", SCREEN, "4.5139×10⁵ N/m"),
        ("451.388888 kN/m", SCREEN, "451.39 kN/m"),
        ("20.3 mm", SCREEN, "20.3 mm"),
        ("20.3 mm", COMMA, "20,3 mm"),
        ("30 deg", SCREEN, "30°"),
        ("30 deg", ASCII, "30 deg"),
        ("30 °/s", SCREEN, "30 °/s"),
        ("12 %", SCREEN, "12 %"),
        ("-8 N m", SCREEN, "−8 N·m"),
        ("-8 N m", ASCII, "-8 N*m"),
        ("1000 rpm", SCREEN, "1000 rpm"),
        ("7 µm", ASCII, "7 um"),
        ("0.06", SCREEN, "0.06"),
        ("20 dB", SCREEN, "20 dB"),
        ("3 mm pp", SCREEN, "3 mm pp"),
        ("1,3 m4", SCREEN, "1.3 m⁴"),
        ("3 in", digits(16), "3 in"),
    ] {
        let quantity = read_any(text).unwrap();
        assert_eq!(write_quantity(quantity.si, &quantity.unit, style), written);
    }
    assert_eq!(write_quantity(0.0, &unit("dB").unwrap(), SCREEN), "0");
    assert_eq!(write_quantity(std::f64::consts::TAU, &unit("rpm").unwrap(), SCREEN), "60 rpm");
}

#[test]
fn vectors() {
    let speed = unit("m/s").unwrap();
    assert_eq!(write_vector([300.0, 200.0, 0.0], &speed, SCREEN), "(300 i + 200 j) m/s");
    assert_eq!(write_vector([-300.0, 0.0, -0.5], &speed, SCREEN), "(−300 i − 0.5 k) m/s");
    assert_eq!(write_vector([-300.0, 0.0, -0.5], &speed, ASCII), "(-300 i - 0.5 k) m/s");
    assert_eq!(write_vector([0.0; 3], &speed, SCREEN), "0 m/s");
    assert_eq!(write_vector([0.0203, 0.0, 0.0], &unit("mm").unwrap(), COMMA), "(20,3 i) mm");
    assert_eq!(write_components(&[300.0, 200.0, 0.0], &speed, SCREEN), "(300; 200; 0) m/s");
    assert_eq!(write_components(&[0.3, -0.2], &unit("mm").unwrap(), COMMA), "(300; −200) mm");
}

/// The coherent unit is written with the symbol that its kind has, and with base units where it has none.
#[test]
fn coherent_units() {
    for (text, coherent) in [
        ("lbf", "N"),
        ("kN rms", "N"),
        ("mm pp", "m"),
        ("mm/s rms", "m/s"),
        ("kWh", "J"),
        ("kgf*m", "N*m"),
        ("rpm", "rad/s"),
        ("1/min", "1/s"),
        ("deg", "rad"),
        ("N*m/deg", "N*m/rad"),
        ("psi", "Pa"),
        ("L", "m^3"),
        ("g^3", "kg^3"),
        ("1/mm", "1/m"),
        ("t*mm/h^3", "kg*m/s^3"),
        ("mm/s/deg", "m/(s*rad)"),
        ("dB", "1"),
        ("%", "1"),
        ("", "1"),
    ] {
        assert_eq!(unit(text).unwrap().coherent(), coherent, "{text}");
    }
}

#[test]
fn indices() {
    assert_eq!(superscript(-1234567890), "⁻¹²³⁴⁵⁶⁷⁸⁹⁰");
    assert_eq!(subscript(1234567890), "₁₂₃₄₅₆₇₈₉₀");
}

#[test]
fn the_unit_an_engineer_would_choose() {
    for (si, kind, text) in [
        (0.0203, Kind::Length, "mm"),
        (1.2, Kind::Length, "m"),
        (-3e-5, Kind::Length, "µm"),
        (2e-9, Kind::Length, "µm"),
        (1500.0, Kind::Force, "kN"),
        (-450.0, Kind::Force, "N"),
        (2e11, Kind::Stress, "GPa"),
        (451388.9, Kind::Stiffness, "kN/m"),
        (1.3e-6, Kind::SecondMoment, "cm^4"),
        (0.1, Kind::Unbalance, "kg*mm"),
        (0.5, Kind::Angle, "deg"),
        (100.0, Kind::AngularVelocity, "rad/s"),
        (0.06, Kind::Ratio, ""),
        (0.0, Kind::Length, "m"),
        (5.0, Kind::Other, ""),
        (2.06e6, Kind::Power, "MW"),
        (0.99999999, Kind::Length, "m"),
    ] {
        assert_eq!(best_unit(si, kind).text, text, "{si} {kind:?}");
    }
}

/// Every unit of every kind reads, has the dimension of its kind, and takes a number there and back:
/// to the digits shown, and bit for bit at 17 digits.
#[test]
fn what_is_written_can_be_read() {
    let mut state: u64 = 42;
    let mut random = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let size = 1.0 + (state >> 12) as f64 / (1u64 << 52) as f64;
        size * 10f64.powi((state >> 7) as i32 % 12) * if state & 64 == 0 { 1.0 } else { -1.0 }
    };
    let extra = [
        "g's", "′", "″", "º", "‰", "mil pp", "mm/s rms", "kN/mm2", "N.m", "lbf ft", "kg/(m s)", "m s⁻²",
        "Wh", "oz in",
    ];
    let all = KINDS
        .iter()
        .flat_map(|&kind| kind.units().iter().chain(kind.ladder()).map(move |text| (kind, *text)));
    let all: Vec<_> = all.chain(extra.map(|text| (Kind::Other, text))).collect();
    for (kind, text) in all {
        let unit = unit(text).unwrap();
        if let Some(dim) = kind.dim() {
            assert_eq!(unit.dim, dim, "{text}");
        }
        let kind = if kind == Kind::Other && unit.sense == UnitMeaning::PeakToPeak
            || unit.sense == UnitMeaning::Rms
        {
            Kind::Amplitude
        } else {
            kind
        };
        for n in 0..12 {
            let si = random();
            for style in [SCREEN, COMMA, ASCII, Style { ascii: true, ..COMMA }] {
                for places in [1, 3, 5, 12, 17] {
                    let style = Style { digits: places, ..style };
                    let si = if unit.sense == UnitMeaning::Level { si.abs() } else { si };
                    let shown = write_quantity(si, &unit, style);
                    let read = read_quantity(&with_point(&shown), &unit, kind)
                        .unwrap_or_else(|error| panic!("{shown}: {error}"));
                    if unit.sense == UnitMeaning::Level {
                        let level = 20.0 * (read.si / si).log10();
                        assert!(
                            level.abs() <= 0.5 * 10f64.powi(3 - i32::from(places)) + 1e-12,
                            "{si} {shown}"
                        );
                    } else if places == 17 {
                        assert_eq!(read.si, si, "{shown} ({n})");
                    } else {
                        let half = 0.5 * 10f64.powi(1 - i32::from(places));
                        assert!((read.si / si - 1.0).abs() <= half * (1.0 + 1e-9), "{si}: {shown}");
                        assert_eq!(write_quantity(read.si, &unit, style), shown);
                    }
                }
                let vector = [si, 0.0, -2.0 * si];
                for shown in [
                    write_vector(vector, &unit, digits_of(style)),
                    write_components(&vector, &unit, digits_of(style)),
                ] {
                    if unit.sense == UnitMeaning::Level {
                        continue;
                    }
                    let read = read_vector(&shown, &unit, kind, 3)
                        .unwrap_or_else(|error| panic!("{shown}: {error}"));
                    assert_eq!(read.si, vector, "{shown}");
                }
            }
        }
    }
}

fn digits_of(style: Style) -> Style {
    Style { digits: 17, ..style }
}

const KINDS: [Kind; 31] = [
    Kind::Length,
    Kind::Mass,
    Kind::Time,
    Kind::Angle,
    Kind::AngularVelocity,
    Kind::AngularAcceleration,
    Kind::Velocity,
    Kind::Acceleration,
    Kind::Force,
    Kind::Torque,
    Kind::Energy,
    Kind::Power,
    Kind::Stiffness,
    Kind::TorsionalStiffness,
    Kind::Damping,
    Kind::TorsionalDamping,
    Kind::Stress,
    Kind::Area,
    Kind::Volume,
    Kind::SecondMoment,
    Kind::Density,
    Kind::LinearDensity,
    Kind::MomentOfInertia,
    Kind::Unbalance,
    Kind::Compliance,
    Kind::FlexuralRigidity,
    Kind::Momentum,
    Kind::AngularMomentum,
    Kind::Ratio,
    Kind::Amplitude,
    Kind::Other,
];
