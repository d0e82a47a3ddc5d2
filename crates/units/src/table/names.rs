//! Names of units written out, in English and Portuguese, and symbols with several meanings.

use std::borrow::Cow;

use super::{Row, Symbol, prefixed, prefixes_of};

/// Names that are read as a symbol of a row.
struct Entry {
    /// The first symbol of the row.
    symbol: &'static str,
    names: &'static [&'static str],
    /// The prefixes of the row, written out, may stand before them.
    with_prefixes: bool,
}

const fn plain(symbol: &'static str, names: &'static [&'static str]) -> Entry {
    Entry { symbol, names, with_prefixes: false }
}

const fn prefixable(symbol: &'static str, names: &'static [&'static str]) -> Entry {
    Entry { symbol, names, with_prefixes: true }
}

/// Prefixes written out, with their letters.
const PREFIX_NAMES: [(&str, &str); 16] = [
    ("nano", "n"),
    ("micro", "µ"),
    ("micrô", "µ"),
    ("milli", "m"),
    ("mili", "m"),
    ("milí", "m"),
    ("centi", "c"),
    ("centí", "c"),
    ("deci", "d"),
    ("decí", "d"),
    ("hecto", "h"),
    ("kilo", "k"),
    ("quilo", "k"),
    ("quilô", "k"),
    ("mega", "M"),
    ("giga", "G"),
];

/// Names of the rows.
static NAMES: &[Entry] = &[
    prefixable("m", &["metre", "metres", "meter", "meters", "metro", "metros"]),
    plain("ft", &["pés"]),
    plain("yd", &["yard", "yards", "jarda", "jardas"]),
    plain("mi", &["mile", "miles", "milha", "milhas"]),
    plain("micron", &["microns", "mícron", "mícrons"]),
    prefixable("g", &["gram", "grams", "gramme", "grammes", "grama", "gramas"]),
    plain("t", &["tonelada", "toneladas", "metric ton", "metric tons"]),
    plain("lb", &["pound", "pounds", "libra", "libras"]),
    plain("oz", &["ounce", "ounces", "onça", "onças"]),
    plain("short ton", &["short tons", "US ton", "US tons"]),
    plain("long ton", &["long tons", "UK ton", "UK tons", "imperial ton", "imperial tons"]),
    prefixable("s", &["second", "seconds", "segundo", "segundos"]),
    plain("sec", &["secs", "seg"]),
    plain("min", &["mins", "minute", "minutes", "minuto", "minutos"]),
    plain("h", &["hrs", "hour", "hours", "hora", "horas"]),
    plain("day", &["dia", "dias"]),
    prefixable("rad", &["radian", "radians", "radiano", "radianos"]),
    plain("rev", &["revolution", "revolutions", "volta", "voltas", "rotações", "ciclo", "ciclos"]),
    plain("rps", &["c/s", "c/sec"]),
    plain("rpm", &["c/min"]),
    prefixable("Hz", &["hertz"]),
    plain("kph", &["kmh", "kmph"]),
    plain("knot", &["knots", "nós"]),
    prefixable("N", &["newton", "newtons"]),
    plain("dyn", &["dyne", "dynes", "dina", "dinas"]),
    plain("lbf", &["pound-force", "pounds-force", "libra-força", "libras-força"]),
    plain("ozf", &["ounce-force", "onça-força"]),
    prefixable("gf", &["gram-force", "grams-force", "grama-força", "gramas-força"]),
    plain("kp", &["kilopond", "kiloponds"]),
    plain("tf", &["tonne-force", "tonnes-force", "tonelada-força", "toneladas-força"]),
    plain("short tonf", &["short tonsf"]),
    plain("long tonf", &["long tonsf"]),
    prefixable("J", &["joule", "joules"]),
    prefixable("W", &["watt", "watts"]),
    plain("hp", &["horsepower"]),
    prefixable("Pa", &["pascal", "pascals"]),
    plain("Msi", &["msi"]),
    plain("L", &["litre", "litres", "liter", "liters", "litro", "litros"]),
    plain("%", &["percent"]),
];

/// The names of the unit with this first symbol.
pub(super) fn of_symbol(symbol: &str) -> &'static [&'static str] {
    NAMES.iter().find(|entry| entry.symbol == symbol).map_or(&[], |entry| entry.names)
}

/// The names of a row, those with prefixes included.
pub(super) fn written_out(row: &'static Row) -> Vec<Symbol> {
    let Some(entry) = NAMES.iter().find(|entry| entry.symbol == row.symbols[0]) else { return Vec::new() };
    let mut found = Vec::new();
    for &name in entry.names {
        let stands_for = Cow::Borrowed(entry.symbol);
        found.push(Symbol { text: name.into(), stands_for, scale: row.scale });
        for (letter, ten) in prefixes_of(row).filter(|_| entry.with_prefixes) {
            for (prefix, _) in PREFIX_NAMES.iter().filter(|(_, short)| *short == letter) {
                // In Portuguese the sound stays: milissegundos, milirradianos.
                let doubled = if matches!(name, "segundo" | "segundos" | "radiano" | "radianos") {
                    &name[..1]
                } else {
                    ""
                };
                found.push(Symbol {
                    text: format!("{prefix}{doubled}{name}").into(),
                    stands_for: format!("{letter}{}", entry.symbol).into(),
                    scale: prefixed(row.scale, ten),
                });
            }
        }
    }
    found
}

/// First words of units of two.
const FIRST_WORDS: [&str; 6] = ["short", "long", "metric", "US", "UK", "imperial"];
/// Second words of units of two, the longer before those they begin with.
const SECOND_WORDS: [&str; 5] = ["tonsf", "tonf", "tons", "ton", "cwt"];

/// The unit of two words that a text begins with, as `long ton`.
pub fn unit_of_two_words(text: &str) -> Option<&str> {
    let first = FIRST_WORDS.iter().find(|word| text.starts_with(**word))?;
    let rest = text[first.len()..].strip_prefix(' ')?;
    let second = SECOND_WORDS.iter().find(|word| rest.starts_with(**word))?;
    let ended = !rest[second.len()..].starts_with(char::is_alphabetic);
    ended.then(|| &text[..first.len() + 1 + second.len()])
}

/// Symbols that stand for several units, with the spellings of these.
const SEVERAL: &[(&[&str], &[&str])] = &[
    (&["ton", "tons"], &["short ton", "long ton", "t", "short tonf", "long tonf", "tf"]),
    (&["tonf", "tonsf", "ton-force", "tons-force"], &["short tonf", "long tonf", "tf"]),
    (&["cwt"], &["short cwt", "long cwt"]),
    (&["kgm"], &["kg*m", "kgf*m"]),
    (&["ftlb", "ftlbs", "lbft"], &["ft*lbf", "ft*lb"]),
    (&["ftlbf", "lbfft"], &["ft*lbf"]),
    (&["inlb", "inlbs", "lbin"], &["in*lbf", "in*lb"]),
    (&["inlbf", "lbfin"], &["in*lbf"]),
];

/// Units that a symbol with several meanings may stand for; none for any other.
pub(crate) fn several(symbol: &str) -> &'static [&'static str] {
    SEVERAL.iter().find(|(symbols, _)| symbols.contains(&symbol)).map_or(&[], |(_, meant)| meant)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::unit;

    /// Every name is read as its symbol, prefixes included, and is shown as it.
    #[test]
    fn a_name_is_its_symbol() {
        for (name, symbol) in [
            ("grams", "g"),
            ("gramas", "g"),
            ("kilograms", "kg"),
            ("quilogramas", "kg"),
            ("milímetros", "mm"),
            ("quilômetros", "km"),
            ("micrometres", "µm"),
            ("kilonewtons", "kN"),
            ("megapascals", "MPa"),
            ("kilohertz", "kHz"),
            ("milissegundos", "ms"),
            ("quilogramas-força", "kgf"),
            ("quilogramas/metros", "kg/m"),
            ("newtons-metros", "N*m"),
            ("pounds-force", "lbf"),
            ("c/s", "rps"),
            ("short tons/in", "short ton/in"),
        ] {
            assert_eq!(unit(name).unwrap(), unit(symbol).unwrap(), "{name}");
        }
        assert!(unit("milisegundos").is_err());
        for entry in NAMES {
            for name in entry.names {
                assert_eq!(unit(name).unwrap(), unit(entry.symbol).unwrap(), "{name}");
            }
        }
    }

    #[test]
    fn each_meaning_can_be_typed() {
        for (symbols, meant) in SEVERAL {
            for symbol in *symbols {
                assert!(unit(symbol).is_err(), "{symbol}");
            }
            for text in *meant {
                assert!(unit(text).is_ok(), "{text}");
            }
        }
    }
}
