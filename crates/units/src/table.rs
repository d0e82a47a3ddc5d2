//! The units there are: one row a unit.

mod names;

use std::{borrow::Cow, f64::consts::TAU, sync::LazyLock};

use crate::{Dim, Scale, UnitMeaning};

pub(crate) use names::several;
pub use names::unit_of_two_words;

/// A unit symbol or name as a user may write it, prefix included.
pub(crate) struct Symbol {
    pub(crate) text: Cow<'static, str>,
    /// The symbol that a name stands for, `kN` for `kilonewtons`; that of a symbol is its text.
    pub(crate) stands_for: Cow<'static, str>,
    pub(crate) scale: Scale,
}

/// A unit with every way of writing it.
#[derive(Clone, Copy, Debug)]
pub struct Spelling {
    /// Symbols of the unit; the first is the usual one.
    pub symbols: &'static [&'static str],
    /// The prefixes that may stand before each of them.
    pub prefixes: &'static [&'static str],
    /// Names that are read as the first symbol.
    pub names: &'static [&'static str],
}

/// Every unit that can be read, in the order of its quantities. For a reference; what a text means is said by
/// [`unit`](crate::unit).
pub fn spellings() -> impl Iterator<Item = Spelling> {
    ROWS.iter().map(|row| Spelling {
        symbols: row.symbols,
        prefixes: row.prefixes,
        names: names::of_symbol(row.symbols[0]),
    })
}

/// The symbol written exactly so. Case matters: `mN` is no `MN`.
pub(crate) fn lookup(text: &str) -> Option<&'static Symbol> {
    let symbols = &*SYMBOLS;
    symbols.binary_search_by(|symbol| (*symbol.text).cmp(text)).ok().map(|at| &symbols[at])
}

/// Symbols that `text` may have been meant as: first those of the wanted dimension, where there is one, and
/// among them those that differ in case alone.
pub(crate) fn nearest(text: &str, wanted: Dim) -> Vec<&'static str> {
    let length = text.chars().count();
    if length > 12 {
        return Vec::new();
    }
    let mut found: Vec<_> = SYMBOLS
        .iter()
        .filter_map(|symbol| {
            let rank = if differ_in_case(text, &symbol.text) {
                0
            } else if length > 1 && is_one_step(text, &symbol.text) {
                1
            } else {
                return None;
            };
            let prefixed = matches!(symbol.text, Cow::Owned(_));
            let other = wanted != Dim::NONE && symbol.scale.dim != wanted;
            Some((other, rank, prefixed, &*symbol.text))
        })
        .collect();
    found.sort_unstable();
    found.into_iter().map(|(_, _, _, text)| text).collect()
}

/// The unit without a prefix, of a dimension, that `text` becomes by one letter more; `None` where there are several.
pub(crate) fn with_one_letter_more(text: &str, dim: Dim) -> Option<&'static str> {
    let longer = text.chars().count() + 1;
    let mut found = SYMBOLS.iter().filter(|symbol| {
        matches!(symbol.text, Cow::Borrowed(_))
            && symbol.text == symbol.stands_for
            && longer > 2
            && symbol.scale.dim == dim
            && symbol.text.chars().count() == longer
            && is_one_step(text, &symbol.text)
    });
    let first = found.next()?;
    found.next().is_none().then_some(&*first.text)
}

/// Every symbol, prefixes included, sorted.
#[cfg(test)]
pub(crate) fn all() -> &'static [Symbol] {
    &SYMBOLS
}

struct Row {
    /// The first is the usual one; the prefixes go with each.
    symbols: &'static [&'static str],
    prefixes: &'static [&'static str],
    scale: Scale,
}

const fn row(
    symbols: &'static [&'static str],
    prefixes: &'static [&'static str],
    mantissa: f64,
    ten: i16,
    dim: Dim,
) -> Row {
    Row { symbols, prefixes, scale: Scale { mantissa, ten, dim, sense: UnitMeaning::Plain } }
}

/// A unit of energy or power: what it makes is no torque.
const fn work(
    symbols: &'static [&'static str],
    prefixes: &'static [&'static str],
    mantissa: f64,
    ten: i16,
    dim: Dim,
) -> Row {
    Row { symbols, prefixes, scale: Scale { mantissa, ten, dim, sense: UnitMeaning::Energy } }
}

const PREFIXES: [(&str, i16); 13] = [
    ("p", -12),
    ("n", -9),
    ("µ", -6), // U+00B5, on keyboards
    ("μ", -6), // U+03BC, the Greek letter
    ("u", -6),
    ("m", -3),
    ("c", -2),
    ("d", -1),
    ("da", 1),
    ("h", 2),
    ("k", 3),
    ("M", 6),
    ("G", 9),
];

const SI: &[&str] = &["p", "n", "µ", "μ", "u", "m", "c", "d", "da", "h", "k", "M", "G"];
const SMALL: &[&str] = &["p", "n", "µ", "μ", "u", "m"];
const MICRO: &[&str] = &["µ", "μ", "u"];
const NONE: &[&str] = &[];

const VELOCITY: Dim = Dim::new(1, 0, -1, 0);
const ACCELERATION: Dim = Dim::new(1, 0, -2, 0);
const FORCE: Dim = Dim::new(1, 1, -2, 0);
const ENERGY: Dim = Dim::new(2, 1, -2, 0);
const POWER: Dim = Dim::new(2, 1, -3, 0);
const STRESS: Dim = Dim::new(-1, 1, -2, 0);
const SPEED: Dim = Dim::new(0, 0, -1, 1);
const VOLUME: Dim = Dim::new(3, 0, 0, 0);
const MOMENTUM: Dim = Dim::new(1, 1, -1, 0);
const ANGULAR_MOMENTUM: Dim = Dim::new(2, 1, -1, 0);
const UNBALANCE: Dim = Dim::new(1, 1, 0, 0);
const VISCOSITY: Dim = Dim::new(-1, 1, -1, 0);
const DIFFUSIVITY: Dim = Dim::new(2, 0, -1, 0);

/// The pound-force, exactly 0.453 592 37 kg × 9.806 65 m/s².
pub(crate) const LBF: f64 = 4.4482216152605;

/// Exact factors are by definition (SI brochure; international yard and pound agreement of 1959; standard gravity of
/// the 3rd CGPM, 1901); derived ones are written as their definition.
static ROWS: &[Row] = &[
    // Length
    row(&["m"], SI, 1.0, 0, Dim::LENGTH),
    row(&["in"], MICRO, 254.0, -4, Dim::LENGTH),
    row(&["inch", "inches", "pol", "polegada", "polegadas"], NONE, 254.0, -4, Dim::LENGTH),
    row(&["ft", "foot", "feet"], NONE, 3048.0, -4, Dim::LENGTH),
    row(&["yd"], NONE, 9144.0, -4, Dim::LENGTH),
    row(&["mi"], NONE, 1609344.0, -3, Dim::LENGTH),
    row(&["mil", "mils", "thou"], NONE, 254.0, -7, Dim::LENGTH),
    row(&["micron"], NONE, 1.0, -6, Dim::LENGTH),
    // Mass
    row(&["g"], SI, 1.0, -3, Dim::MASS),
    row(&["t"], &["k", "M"], 1.0, 3, Dim::MASS),
    row(&["tonne", "tonnes"], NONE, 1.0, 3, Dim::MASS),
    row(&["lb", "lbm", "lbs"], NONE, 45359237.0, -8, Dim::MASS),
    row(&["oz"], NONE, 28349523125.0, -12, Dim::MASS),
    row(&["slug", "slugs"], NONE, LBF / 0.3048, 0, Dim::MASS),
    row(&["slinch"], NONE, LBF / 0.0254, 0, Dim::MASS),
    row(&["short ton"], NONE, 90718474.0, -5, Dim::MASS), // 2000 lb
    row(&["long ton"], NONE, 10160469088.0, -7, Dim::MASS), // 2240 lb
    row(&["short cwt"], NONE, 45359237.0, -6, Dim::MASS), // 100 lb
    row(&["long cwt"], NONE, 5080234544.0, -8, Dim::MASS), // 112 lb
    // Time
    row(&["s"], SMALL, 1.0, 0, Dim::TIME),
    row(&["sec"], NONE, 1.0, 0, Dim::TIME),
    row(&["min"], NONE, 60.0, 0, Dim::TIME),
    row(&["h", "hr"], NONE, 3600.0, 0, Dim::TIME),
    row(&["day", "days"], NONE, 86400.0, 0, Dim::TIME),
    // Angle
    row(&["rad"], SMALL, 1.0, 0, Dim::ANGLE),
    row(&["deg", "°", "º", "degree", "degrees", "grau", "graus"], NONE, TAU / 360.0, 0, Dim::ANGLE),
    row(&["arcmin", "'", "′"], NONE, TAU / 21600.0, 0, Dim::ANGLE),
    row(&["arcsec", "\"", "″"], NONE, TAU / 1296000.0, 0, Dim::ANGLE),
    row(&["rev", "revs", "r", "rot", "turn", "turns", "cycle", "cycles"], NONE, TAU, 0, Dim::ANGLE),
    // Speed of rotation and frequency: a cycle is 2π rad
    row(&["rpm", "cpm"], NONE, TAU / 60.0, 0, SPEED),
    row(&["rps", "cps"], NONE, TAU, 0, SPEED),
    row(&["Hz"], &["µ", "μ", "u", "m", "k", "M", "G"], TAU, 0, SPEED),
    // Velocity and acceleration
    row(&["mph"], NONE, 44704.0, -5, VELOCITY),
    row(&["kph"], NONE, 1.0 / 3600.0, 3, VELOCITY),
    row(&["fps"], NONE, 3048.0, -4, VELOCITY),
    row(&["ips"], NONE, 254.0, -4, VELOCITY),
    row(&["knot"], NONE, 1852.0 / 3600.0, 0, VELOCITY),
    row(&["g0", "gn", "gs", "g's"], NONE, 980665.0, -5, ACCELERATION),
    row(&["Gal"], &["m"], 1.0, -2, ACCELERATION),
    // Force
    row(&["N"], SI, 1.0, 0, FORCE),
    row(&["dyn"], NONE, 1.0, -5, FORCE),
    row(&["gf"], &["k"], 980665.0, -8, FORCE),
    row(&["kp"], NONE, 980665.0, -5, FORCE),
    row(&["tf"], NONE, 980665.0, -2, FORCE),
    row(&["lbf"], &["k"], 44482216152605.0, -13, FORCE),
    row(&["kip", "kips"], NONE, 44482216152605.0, -10, FORCE),
    row(&["ozf"], NONE, LBF / 16.0, 0, FORCE),
    row(&["short tonf"], NONE, 8896443230521.0, -9, FORCE), // 2000 lbf
    row(&["long tonf"], NONE, 996401641818352.0, -11, FORCE), // 2240 lbf
    // Torque, impulse and unbalance, as they are often written
    row(&["Nm"], &["µ", "μ", "u", "m", "c", "k", "M"], 1.0, 0, ENERGY),
    row(&["Nmm"], &["k"], 1.0, -3, ENERGY),
    row(&["kgfm"], NONE, 980665.0, -5, ENERGY),
    row(&["Ns"], &["m", "k"], 1.0, 0, MOMENTUM),
    row(&["Nms"], &["k"], 1.0, 0, ANGULAR_MOMENTUM),
    row(&["gmm"], &["k"], 1.0, -6, UNBALANCE),
    // Energy and power
    work(&["J"], SI, 1.0, 0, ENERGY),
    work(&["erg"], NONE, 1.0, -7, ENERGY),
    work(&["cal"], &["k", "M"], 4184.0, -3, ENERGY),
    work(&["Wh"], &["m", "k", "M", "G"], 3600.0, 0, ENERGY),
    work(&["Btu", "BTU"], NONE, 105505585262.0, -8, ENERGY),
    work(&["W"], SI, 1.0, 0, POWER),
    work(&["hp"], NONE, 550.0 * 0.3048 * LBF, 0, POWER),
    work(&["cv", "CV", "PS"], NONE, 73549875.0, -5, POWER),
    // Stress and pressure
    row(&["Pa"], SI, 1.0, 0, STRESS),
    row(&["bar"], &["µ", "μ", "u", "m", "d", "k", "M"], 1.0, 5, STRESS),
    row(&["atm"], NONE, 101325.0, 0, STRESS),
    row(&["mmHg"], NONE, 133322387415.0, -9, STRESS),
    row(&["psi"], &["k", "M"], LBF / 6.4516, 4, STRESS),
    row(&["ksi"], NONE, LBF / 6.4516, 7, STRESS),
    row(&["Msi"], NONE, LBF / 6.4516, 10, STRESS),
    row(&["psf"], NONE, LBF / (0.3048 * 0.3048), 0, STRESS),
    // Volume and viscosity
    row(&["L", "l"], &["µ", "μ", "u", "m", "c", "d", "h"], 1.0, -3, VOLUME),
    row(&["P"], &["m", "c"], 1.0, -1, VISCOSITY),
    row(&["St"], &["m", "c"], 1.0, -4, DIFFUSIVITY),
    // Pure numbers
    row(&["%"], NONE, 1.0, -2, Dim::NONE),
    row(&["‰", "permil"], NONE, 1.0, -3, Dim::NONE),
    row(&["ppm"], NONE, 1.0, -6, Dim::NONE),
    Row {
        symbols: &["dB"],
        prefixes: NONE,
        scale: Scale { mantissa: 1.0, ten: 0, dim: Dim::NONE, sense: UnitMeaning::Level },
    },
];

/// Every row with each of its prefixes and names, sorted by text; built once, some 1000 of them.
static SYMBOLS: LazyLock<Vec<Symbol>> = LazyLock::new(|| {
    let mut symbols = Vec::new();
    for row in ROWS {
        for &text in row.symbols {
            symbols.push(Symbol { text: text.into(), stands_for: text.into(), scale: row.scale });
            for (prefix, ten) in prefixes_of(row) {
                let text: Cow<'static, str> = format!("{prefix}{text}").into();
                symbols.push(Symbol { stands_for: text.clone(), text, scale: prefixed(row.scale, ten) });
            }
        }
        for name in names::written_out(row) {
            symbols.push(name);
        }
    }
    symbols.sort_unstable_by(|a, b| a.text.cmp(&b.text));
    symbols
});

/// The prefixes of a row with their powers of ten.
fn prefixes_of(row: &Row) -> impl Iterator<Item = (&'static str, i16)> {
    PREFIXES.iter().copied().filter(|(prefix, _)| row.prefixes.contains(prefix))
}

fn prefixed(scale: Scale, ten: i16) -> Scale {
    Scale { ten: scale.ten + ten, ..scale }
}

/// Returns true if the texts differ by one letter inserted, omitted, changed, or swapped with the next.
fn is_one_step(a: &str, b: &str) -> bool {
    fn equal((x, y): &(char, char)) -> bool {
        x == y
    }
    let head: usize = a.chars().zip(b.chars()).take_while(equal).map(|(x, _)| x.len_utf8()).sum();
    let (a, b) = (&a[head..], &b[head..]);
    let tail: usize = a.chars().rev().zip(b.chars().rev()).take_while(equal).map(|(x, _)| x.len_utf8()).sum();
    let (a, b) = (&a[..a.len() - tail], &b[..b.len() - tail]);
    match (a.chars().count(), b.chars().count()) {
        (2, 2) => a.chars().eq(b.chars().rev()),
        (m, n) => m.max(n) == 1,
    }
}

fn differ_in_case(a: &str, b: &str) -> bool {
    a.chars().flat_map(char::to_lowercase).eq(b.chars().flat_map(char::to_lowercase))
}

#[cfg(test)]
mod tests;
