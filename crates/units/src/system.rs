//! Systems of units: a coherent unit of every quantity, so that numbers can be put into a formula as they are.

use crate::{Dim, Kind, Unit, UnitMeaning, read::compose, table::LBF};

/// System of coherent units: three base units, and every other one a product of their powers without a factor.
///
/// Angles, frequencies and ratios are of no system: they stay in the unit they have.
///
/// ```
/// use dalembert_units::{UnitSystem, unit};
///
/// let stiffness = unit("kN/m")?;
/// assert_eq!(UnitSystem::InchPound.unit(&stiffness).ascii(), "lbf/in");
/// assert_eq!(UnitSystem::InchPound.unit(&unit("kg")?).ascii(), "lbf*s^2/in");
/// assert_eq!(UnitSystem::MillimetreTonne.unit(&unit("GPa")?).ascii(), "MPa");
/// # Ok::<(), dalembert_units::ReadError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum UnitSystem {
    /// Metre, kilogram, second.
    Si,
    /// Inch, pound-force, second; the mass is 1 lbf·s²/in.
    InchPound,
    /// Foot, slug, second; the force is the pound-force.
    FootSlug,
    /// Millimetre, tonne, second; the force is the newton, so it is mm·N·s too.
    MillimetreTonne,
}

/// Relative difference of two factors below which they are the same number, rounded in another order.
const ROUNDED: f64 = 1e-12;

impl UnitSystem {
    /// Every system.
    pub const ALL: [UnitSystem; 4] =
        [UnitSystem::Si, UnitSystem::InchPound, UnitSystem::FootSlug, UnitSystem::MillimetreTonne];

    /// The key in files and on the command line: `in-lbf-s`.
    pub fn key(self) -> &'static str {
        match self {
            UnitSystem::Si => "SI",
            UnitSystem::InchPound => "in-lbf-s",
            UnitSystem::FootSlug => "ft-slug-s",
            UnitSystem::MillimetreTonne => "mm-t-s",
        }
    }

    /// Name for the screen: `in·lbf·s`, or in ASCII `in*lbf*s`.
    pub fn name(self, ascii: bool) -> String {
        self.key().replace('-', if ascii { "*" } else { "·" })
    }

    /// The system that a text names: `in-lbf-s`, `in·lbf·s`, `ft lbf s`, `mm-N-s`, `SI`; the order of the units does not
    /// matter.
    pub fn named(text: &str) -> Option<Self> {
        let text = text.to_ascii_lowercase();
        let mut parts: Vec<&str> =
            text.split(|c: char| !c.is_alphanumeric()).filter(|part| !part.is_empty()).collect();
        parts.sort_unstable();
        Some(match parts[..] {
            ["si"] | ["kg", "m", "s"] | ["m", "n", "s"] => UnitSystem::Si,
            ["in", "lbf" | "lb", "s"] => UnitSystem::InchPound,
            ["ft", "s", "slug"] | ["ft", "lbf" | "lb", "s"] => UnitSystem::FootSlug,
            ["mm", "s", "t"] | ["mm", "n", "s"] => UnitSystem::MillimetreTonne,
            _ => return None,
        })
    }

    /// The SI value of the coherent unit of a dimension.
    pub fn factor(self, dim: Dim) -> f64 {
        let (length, mass) = match self {
            UnitSystem::Si => (1.0, 1.0),
            UnitSystem::InchPound => (0.0254, LBF / 0.0254),
            UnitSystem::FootSlug => (0.3048, LBF / 0.3048),
            UnitSystem::MillimetreTonne => (1e-3, 1e3),
        };
        f64::powi(length, dim.length.into()) * f64::powi(mass, dim.mass.into())
    }

    /// Returns true if a unit is coherent in the system, however it is written: `lbf*s^2/in` and `slinch` are.
    pub fn has(self, unit: &Unit) -> bool {
        let factor = self.factor(unit.dim);
        matches!(unit.sense, UnitMeaning::Plain | UnitMeaning::Energy)
            && (unit.factor - factor).abs() <= ROUNDED * factor
    }

    /// Returns true if a unit is coherent and written with the symbols of the system: `kN/m` is no unit of mm·t·s, though
    /// it is 1 N/mm.
    pub fn writes(self, unit: &Unit) -> bool {
        let symbols: &[&str] = match self {
            UnitSystem::Si => &["m", "kg", "N", "Pa", "J", "W"],
            UnitSystem::InchPound => &["in", "lbf", "psi"],
            UnitSystem::FootSlug => &["ft", "slug", "lbf", "psf"],
            UnitSystem::MillimetreTonne => &["mm", "t", "N", "MPa", "mJ"],
        };
        let mut words = unit.text.split(|c: char| !c.is_alphabetic()).filter(|word| !word.is_empty());
        self.has(unit) && words.all(|word| ["s", "rad"].contains(&word) || symbols.contains(&word))
    }

    /// The unit of the system for what is measured in `unit`. An angle, a frequency or a ratio keeps its unit, as does
    /// what is measured per hertz: `m^2/Hz` is `in^2/Hz`. An amplitude is its peak value.
    pub fn unit(self, unit: &Unit) -> Unit {
        let Dim { length, mass, time, angle } = unit.dim;
        if length == 0 && mass == 0 && (angle != 0 || time == 0) || self.writes(unit) {
            return unit.clone();
        }
        let per_hertz = unit.text.strip_suffix("/Hz").and_then(|over| crate::unit(over).ok());
        if let Some(over) = per_hertz {
            let text = format!("{}/Hz", self.unit(&over).text);
            return crate::unit(&text).unwrap_or_else(|_| unit.clone());
        }
        let text = self.text(unit.dim, unit.sense, unit.text.contains('/'));
        match crate::unit(&text) {
            // An energy stays one where it is written as a torque would be.
            Ok(found) if unit.sense == UnitMeaning::Energy => Unit { sense: unit.sense, ..found },
            Ok(found) => found,
            Err(_) => unit.clone(),
        }
    }

    /// The unit of the system of a dimension, with radians for the angle.
    pub fn of_dim(self, dim: Dim) -> Unit {
        crate::unit(&self.text(dim, UnitMeaning::Plain, false)).unwrap_or(Unit::ONE)
    }

    /// The unit of a dimension, written: by its own name, as a mass with lengths, or as a force with lengths and times.
    fn text(self, dim: Dim, sense: UnitMeaning, is_quotient: bool) -> String {
        let stress = dim == Dim::new(-1, 1, -2, 0) && !is_quotient;
        match self {
            UnitSystem::Si if sense == UnitMeaning::Energy => return "J".into(),
            UnitSystem::Si => {
                let kind = Kind::of_dim(dim);
                if let (Some(first), true) = (kind.units().first(), kind.dim() == Some(dim)) {
                    return (*first).into();
                }
            }
            UnitSystem::InchPound if stress => return "psi".into(),
            UnitSystem::MillimetreTonne if stress => return "MPa".into(),
            _ => {}
        }
        let (length, force, mass) = match self {
            UnitSystem::Si => ("m", "N", Some("kg")),
            UnitSystem::InchPound => ("in", "lbf", None),
            UnitSystem::FootSlug => ("ft", "lbf", Some("slug")),
            UnitSystem::MillimetreTonne => ("mm", "N", Some("t")),
        };
        let powers = match mass {
            Some(mass) if dim.time == 0 => {
                [(mass, dim.mass), (length, dim.length), ("s", 0), ("rad", dim.angle)]
            }
            _ => [
                (force, dim.mass),
                (length, dim.length.saturating_sub(dim.mass)),
                ("s", dim.time.saturating_add(dim.mass.saturating_mul(2))),
                ("rad", dim.angle),
            ],
        };
        let powers: Vec<(&str, i8)> = powers.into_iter().filter(|(_, power)| *power != 0).collect();
        compose(&powers)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::unit;

    /// A unit of each quantity, and the unit of it in each system, as textbooks write it.
    #[test]
    fn every_quantity_has_its_unit_in_every_system() {
        #[rustfmt::skip]
        let rows = [
            // a unit      SI             in·lbf·s         ft·slug·s        mm·t·s
            ("cm",         ["m",          "in",            "ft",            "mm"]),
            ("lb",         ["kg",         "lbf*s^2/in",    "slug",          "t"]),
            ("ms",         ["s",          "s",             "s",             "s"]),
            ("km/h",       ["m/s",        "in/s",          "ft/s",          "mm/s"]),
            ("g0",         ["m/s^2",      "in/s^2",        "ft/s^2",        "mm/s^2"]),
            ("kgf",        ["N",          "lbf",           "lbf",           "N"]),
            ("kN*m",       ["N*m",        "lbf*in",        "lbf*ft",        "N*mm"]),
            ("kJ",         ["J",          "lbf*in",        "lbf*ft",        "N*mm"]),
            ("hp",         ["W",          "lbf*in/s",      "lbf*ft/s",      "N*mm/s"]),
            ("kgf/mm",     ["N/m",        "lbf/in",        "lbf/ft",        "N/mm"]),
            ("N*m/deg",    ["N*m/rad",    "lbf*in/rad",    "lbf*ft/rad",    "N*mm/rad"]),
            ("kN*s/m",     ["N*s/m",      "lbf*s/in",      "lbf*s/ft",      "N*s/mm"]),
            ("kN*m*s/rad", ["N*m*s/rad",  "lbf*in*s/rad",  "lbf*ft*s/rad",  "N*mm*s/rad"]),
            ("GPa",        ["Pa",         "psi",           "lbf/ft^2",      "MPa"]),
            ("kN/m^2",     ["Pa",         "lbf/in^2",      "lbf/ft^2",      "N/mm^2"]),
            ("cm^2",       ["m^2",        "in^2",          "ft^2",          "mm^2"]),
            ("L",          ["m^3",        "in^3",          "ft^3",          "mm^3"]),
            ("cm^4",       ["m^4",        "in^4",          "ft^4",          "mm^4"]),
            ("g/cm^3",     ["kg/m^3",     "lbf*s^2/in^4",  "slug/ft^3",     "t/mm^3"]),
            ("lb/yd",      ["kg/m",       "lbf*s^2/in^2",  "slug/ft",       "t/mm"]),
            ("kg*cm^2",    ["kg*m^2",     "lbf*in*s^2",    "slug*ft^2",     "t*mm^2"]),
            ("g*mm",       ["kg*m",       "lbf*s^2",       "slug*ft",       "t*mm"]),
            ("um/N",       ["m/N",        "in/lbf",        "ft/lbf",        "mm/N"]),
            ("kN*m^2",     ["N*m^2",      "lbf*in^2",      "lbf*ft^2",      "N*mm^2"]),
            ("kN*s",       ["kg*m/s",     "lbf*s",         "lbf*s",         "N*s"]),
            ("kN*m*s",     ["kg*m^2/s",   "lbf*in*s",      "lbf*ft*s",      "N*mm*s"]),
            ("cP",         ["N*s/m^2",    "lbf*s/in^2",    "lbf*s/ft^2",    "N*s/mm^2"]),
            ("mm^2/s^4/Hz", ["m^2/s^4/Hz", "in^2/s^4/Hz",  "ft^2/s^4/Hz",   "mm^2/s^4/Hz"]),
            ("kN^2/Hz",    ["N^2/Hz",     "lbf^2/Hz",      "lbf^2/Hz",      "N^2/Hz"]),
            ("mil pp",     ["m",          "in",            "ft",            "mm"]),
            // What is of no system.
            ("deg",        ["deg",        "deg",           "deg",           "deg"]),
            ("rpm",        ["rpm",        "rpm",           "rpm",           "rpm"]),
            ("Hz",         ["Hz",         "Hz",            "Hz",            "Hz"]),
            ("%",          ["%",          "%",             "%",             "%"]),
            ("dB",         ["dB",         "dB",            "dB",            "dB"]),
        ];
        for (text, expected) in rows {
            let written = unit(text).unwrap();
            for (n, system) in UnitSystem::ALL.into_iter().enumerate() {
                let expected: &str = expected[n];
                let found = system.unit(&written);
                assert_eq!(found.ascii(), expected, "{text} in {}", system.key());
                assert_eq!(found.dim, unit(expected).unwrap().dim, "{text} in {}", system.key());
                if expected != text && !expected.ends_with("/Hz") {
                    let factor = system.factor(found.dim);
                    assert!((found.factor / factor - 1.0).abs() < 1e-14, "{text} in {}", system.key());
                }
                // A unit of the system stays as it is written.
                assert_eq!(system.unit(&found), found, "{text} in {}", system.key());
            }
        }
    }

    #[test]
    fn a_unit_of_the_system_stays_as_it_is_written() {
        for (system, text) in [
            (UnitSystem::Si, "N*s"),
            (UnitSystem::Si, "N/m^2"),
            (UnitSystem::InchPound, "lbf/in^2"),
            (UnitSystem::FootSlug, "psf"),
            (UnitSystem::MillimetreTonne, "mJ"),
        ] {
            assert_eq!(system.unit(&unit(text).unwrap()).text, text);
        }
        assert!(UnitSystem::InchPound.unit(&unit("kWh").unwrap()).sense == UnitMeaning::Energy);
    }

    #[test]
    fn a_system_is_named_in_any_order() {
        for system in UnitSystem::ALL {
            assert_eq!(UnitSystem::named(system.key()), Some(system));
            assert_eq!(UnitSystem::named(&system.name(false)), Some(system));
            assert_eq!(UnitSystem::named(&system.name(true)), Some(system));
        }
        let others = [
            ("mm-N-s", UnitSystem::MillimetreTonne),
            ("lbf in s", UnitSystem::InchPound),
            ("si", UnitSystem::Si),
        ];
        for (text, system) in others {
            assert_eq!(UnitSystem::named(text), Some(system));
        }
        assert_eq!(UnitSystem::named("cm-g-s"), None);
        assert_eq!(UnitSystem::named(""), None);
    }
}
