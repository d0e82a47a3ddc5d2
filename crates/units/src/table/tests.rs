//! Every symbol against values written down independently of the table: NIST SP 811 (2008), appendix B, and for
//! the angle products of π to 16 figures.

use super::*;
use crate::unit;

/// Symbol, SI value, exponents of m, kg, s, rad.
#[rustfmt::skip]
#[expect(clippy::approx_constant, reason = "written down independently of what the table uses")]
const VALUES: &[(&str, f64, [i8; 4])] = &[
    ("m", 1.0, [1, 0, 0, 0]),
    ("in", 0.0254, [1, 0, 0, 0]), ("inch", 0.0254, [1, 0, 0, 0]), ("inches", 0.0254, [1, 0, 0, 0]),
    ("pol", 0.0254, [1, 0, 0, 0]), ("polegada", 0.0254, [1, 0, 0, 0]), ("polegadas", 0.0254, [1, 0, 0, 0]),
    ("ft", 0.3048, [1, 0, 0, 0]), ("foot", 0.3048, [1, 0, 0, 0]), ("feet", 0.3048, [1, 0, 0, 0]),
    ("yd", 0.9144, [1, 0, 0, 0]), ("mi", 1609.344, [1, 0, 0, 0]), ("micron", 1e-6, [1, 0, 0, 0]),
    ("mil", 2.54e-5, [1, 0, 0, 0]), ("mils", 2.54e-5, [1, 0, 0, 0]), ("thou", 2.54e-5, [1, 0, 0, 0]),
    ("g", 0.001, [0, 1, 0, 0]), ("t", 1000.0, [0, 1, 0, 0]),
    ("tonne", 1000.0, [0, 1, 0, 0]), ("tonnes", 1000.0, [0, 1, 0, 0]),
    ("lb", 0.45359237, [0, 1, 0, 0]), ("lbm", 0.45359237, [0, 1, 0, 0]), ("lbs", 0.45359237, [0, 1, 0, 0]),
    ("oz", 0.028349523125, [0, 1, 0, 0]),
    ("slug", 14.593902937206, [0, 1, 0, 0]), ("slugs", 14.593902937206, [0, 1, 0, 0]),
    ("slinch", 175.126835246477, [0, 1, 0, 0]),
    ("short ton", 907.18474, [0, 1, 0, 0]), ("long ton", 1016.0469088, [0, 1, 0, 0]),
    ("short cwt", 45.359237, [0, 1, 0, 0]), ("long cwt", 50.80234544, [0, 1, 0, 0]),
    ("s", 1.0, [0, 0, 1, 0]), ("sec", 1.0, [0, 0, 1, 0]), ("min", 60.0, [0, 0, 1, 0]),
    ("h", 3600.0, [0, 0, 1, 0]), ("hr", 3600.0, [0, 0, 1, 0]),
    ("day", 86400.0, [0, 0, 1, 0]), ("days", 86400.0, [0, 0, 1, 0]),
    ("rad", 1.0, [0, 0, 0, 1]),
    ("deg", 0.0174532925199433, [0, 0, 0, 1]), ("°", 0.0174532925199433, [0, 0, 0, 1]),
    ("º", 0.0174532925199433, [0, 0, 0, 1]), ("degree", 0.0174532925199433, [0, 0, 0, 1]),
    ("degrees", 0.0174532925199433, [0, 0, 0, 1]), ("grau", 0.0174532925199433, [0, 0, 0, 1]),
    ("graus", 0.0174532925199433, [0, 0, 0, 1]),
    ("arcmin", 2.90888208665722e-4, [0, 0, 0, 1]), ("'", 2.90888208665722e-4, [0, 0, 0, 1]),
    ("′", 2.90888208665722e-4, [0, 0, 0, 1]),
    ("arcsec", 4.84813681109536e-6, [0, 0, 0, 1]), ("\"", 4.84813681109536e-6, [0, 0, 0, 1]),
    ("″", 4.84813681109536e-6, [0, 0, 0, 1]),
    ("rev", 6.28318530717959, [0, 0, 0, 1]), ("revs", 6.28318530717959, [0, 0, 0, 1]),
    ("r", 6.28318530717959, [0, 0, 0, 1]), ("rot", 6.28318530717959, [0, 0, 0, 1]),
    ("turn", 6.28318530717959, [0, 0, 0, 1]), ("turns", 6.28318530717959, [0, 0, 0, 1]),
    ("cycle", 6.28318530717959, [0, 0, 0, 1]), ("cycles", 6.28318530717959, [0, 0, 0, 1]),
    ("rpm", 0.10471975511966, [0, 0, -1, 1]), ("cpm", 0.10471975511966, [0, 0, -1, 1]),
    ("rps", 6.28318530717959, [0, 0, -1, 1]), ("cps", 6.28318530717959, [0, 0, -1, 1]),
    ("Hz", 6.28318530717959, [0, 0, -1, 1]),
    ("mph", 0.44704, [1, 0, -1, 0]), ("kph", 0.277777777777778, [1, 0, -1, 0]), ("fps", 0.3048, [1, 0, -1, 0]),
    ("ips", 0.0254, [1, 0, -1, 0]), ("knot", 0.514444444444444, [1, 0, -1, 0]),
    ("g0", 9.80665, [1, 0, -2, 0]), ("gn", 9.80665, [1, 0, -2, 0]), ("gs", 9.80665, [1, 0, -2, 0]),
    ("g's", 9.80665, [1, 0, -2, 0]), ("Gal", 0.01, [1, 0, -2, 0]),
    ("N", 1.0, [1, 1, -2, 0]), ("dyn", 1e-5, [1, 1, -2, 0]), ("gf", 0.00980665, [1, 1, -2, 0]),
    ("kp", 9.80665, [1, 1, -2, 0]), ("tf", 9806.65, [1, 1, -2, 0]),
    ("lbf", 4.4482216152605, [1, 1, -2, 0]), ("kip", 4448.2216152605, [1, 1, -2, 0]),
    ("kips", 4448.2216152605, [1, 1, -2, 0]), ("ozf", 0.278013850953781, [1, 1, -2, 0]),
    ("short tonf", 8896.443230521, [1, 1, -2, 0]), ("long tonf", 9964.01641818352, [1, 1, -2, 0]),
    ("Nm", 1.0, [2, 1, -2, 0]), ("Nmm", 0.001, [2, 1, -2, 0]), ("kgfm", 9.80665, [2, 1, -2, 0]),
    ("Ns", 1.0, [1, 1, -1, 0]), ("Nms", 1.0, [2, 1, -1, 0]), ("gmm", 1e-6, [1, 1, 0, 0]),
    ("J", 1.0, [2, 1, -2, 0]), ("erg", 1e-7, [2, 1, -2, 0]), ("cal", 4.184, [2, 1, -2, 0]),
    ("Wh", 3600.0, [2, 1, -2, 0]), ("Btu", 1055.05585262, [2, 1, -2, 0]), ("BTU", 1055.05585262, [2, 1, -2, 0]),
    ("W", 1.0, [2, 1, -3, 0]), ("hp", 745.699871582270, [2, 1, -3, 0]),
    ("cv", 735.49875, [2, 1, -3, 0]), ("CV", 735.49875, [2, 1, -3, 0]), ("PS", 735.49875, [2, 1, -3, 0]),
    ("Pa", 1.0, [-1, 1, -2, 0]), ("bar", 1e5, [-1, 1, -2, 0]), ("atm", 101325.0, [-1, 1, -2, 0]),
    ("mmHg", 133.322387415, [-1, 1, -2, 0]), ("psi", 6894.75729316836, [-1, 1, -2, 0]),
    ("ksi", 6894757.29316836, [-1, 1, -2, 0]), ("Msi", 6894757293.16836, [-1, 1, -2, 0]),
    ("psf", 47.8802589803358, [-1, 1, -2, 0]),
    ("L", 0.001, [3, 0, 0, 0]), ("l", 0.001, [3, 0, 0, 0]),
    ("P", 0.1, [-1, 1, -1, 0]), ("St", 1e-4, [2, 0, -1, 0]),
    ("%", 0.01, [0, 0, 0, 0]), ("‰", 0.001, [0, 0, 0, 0]), ("permil", 0.001, [0, 0, 0, 0]),
    ("ppm", 1e-6, [0, 0, 0, 0]), ("dB", 1.0, [0, 0, 0, 0]),
];

#[test]
fn every_symbol_has_its_published_value() {
    for &(symbol, value, [length, mass, time, angle]) in VALUES {
        let unit = unit(symbol).unwrap();
        let error = (unit.factor / value - 1.0).abs();
        assert!(
            error < 4e-15 || (error < 1e-13 && value.to_string().len() > 12),
            "{symbol}: {} or {value}",
            unit.factor
        );
        assert_eq!(unit.dim, Dim::new(length, mass, time, angle), "{symbol}");
        assert_eq!(unit.text, symbol);
    }
    let listed: Vec<_> = VALUES.iter().map(|&(symbol, ..)| symbol).collect();
    for symbol in ROWS.iter().flat_map(|row| row.symbols) {
        assert!(listed.contains(symbol), "`{symbol}` is in the table and has no published value here");
    }
}

#[test]
fn prefixes() {
    for (symbol, value) in [
        ("pm", 1e-12),
        ("nm", 1e-9),
        ("µm", 1e-6),
        ("μm", 1e-6),
        ("um", 1e-6),
        ("mm", 1e-3),
        ("cm", 1e-2),
        ("dm", 1e-1),
        ("dam", 1e1),
        ("hm", 1e2),
        ("km", 1e3),
        ("Mm", 1e6),
        ("Gm", 1e9),
        ("kg", 1.0),
        ("mg", 1e-6),
        ("µg", 1e-9),
        ("Mg", 1e3),
        ("ms", 1e-3),
        ("µs", 1e-6),
        ("mrad", 1e-3),
        ("kN", 1e3),
        ("daN", 10.0),
        ("MN", 1e6),
        ("mN", 1e-3),
        ("kgf", 9.80665),
        ("klbf", 4448.2216152605),
        ("GPa", 1e9),
        ("MPa", 1e6),
        ("hPa", 100.0),
        ("kJ", 1e3),
        ("kWh", 3.6e6),
        ("kcal", 4184.0),
        ("kW", 1e3),
        ("mbar", 100.0),
        ("mL", 1e-6),
        ("cP", 1e-3),
        ("cSt", 1e-6),
        ("kNm", 1e3),
        ("µin", 2.54e-8),
        ("kpsi", 6894757.293168361),
        ("kHz", 6283.185307179586),
        ("mGal", 1e-5),
    ] {
        assert_eq!(unit(symbol).unwrap().factor, value, "{symbol}");
    }
}

#[test]
fn no_symbol_means_two_things() {
    for pair in all().windows(2) {
        assert!(pair[0].text < pair[1].text, "`{}` comes from two rows", pair[0].text);
    }
}

/// Symbols that a prefix could be read into.
#[test]
fn the_usual_reading_wins() {
    for (symbol, value, dim) in [
        ("min", 60.0, Dim::TIME),
        ("ft", 0.3048, Dim::LENGTH),
        ("h", 3600.0, Dim::TIME),
        ("hp", 745.6998715822702, POWER),
        ("kp", 9.80665, FORCE),
        ("Pa", 1.0, STRESS),
        ("dyn", 1e-5, FORCE),
        ("mph", 0.44704, VELOCITY),
        ("gs", 9.80665, ACCELERATION),
        ("cal", 4.184, ENERGY),
        ("mil", 2.54e-5, Dim::LENGTH),
        ("mi", 1609.344, Dim::LENGTH),
        ("ppm", 1e-6, Dim::NONE),
        ("t", 1000.0, Dim::MASS),
        ("yd", 0.9144, Dim::LENGTH),
    ] {
        let unit = unit(symbol).unwrap();
        assert_eq!((unit.factor, unit.dim), (value, dim), "{symbol}");
    }
    // A prefix where nobody writes one is refused rather than read.
    for symbol in
        ["krpm", "kft", "kmin", "mdeg", "k%", "mdB", "klb", "ktf", "mm0", "cd", "pt", "TPa", "fm", "Kg", "KN"]
    {
        assert!(unit(symbol).is_err(), "{symbol}");
    }
}

#[test]
fn nearest_symbols() {
    for (typed, meant) in [
        ("Mpa", "MPa"),
        ("mpa", "MPa"),
        ("KN", "kN"),
        ("Kg", "kg"),
        ("hz", "Hz"),
        ("krpm", "rpm"),
        ("RPM", "rpm"),
        ("rmp", "rpm"),
        ("gpa", "GPa"),
        ("kgff", "kgf"),
        ("Lbf", "lbf"),
        ("degs", "deg"),
        ("Rad", "rad"),
    ] {
        let found = nearest(typed, Dim::NONE);
        assert!(found.contains(&meant), "{typed}: {found:?}");
    }
    assert_eq!(nearest("furlong", Dim::NONE), [""; 0]);
    assert_eq!(nearest(&"m".repeat(5000), Dim::NONE), [""; 0]);
}

#[test]
fn units_of_the_wanted_dimension_come_first() {
    assert_eq!(nearest("mmt", Dim::LENGTH).first(), Some(&"mm"));
    assert_eq!(nearest("mmt", Dim::LENGTH.powi(2) / Dim::TIME).first(), Some(&"mSt"));
}
