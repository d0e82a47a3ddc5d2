//! Kinds of quantity: what a number is, beyond its dimension.

use crate::{Dim, Unit, UnitMeaning};

/// Kind of a quantity, finer than its dimension. Torque and energy share a dimension and are different kinds; so are an
/// angle and a ratio.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// A length.
    Length,
    /// A mass.
    Mass,
    /// A time.
    Time,
    /// A plane angle.
    Angle,
    /// An angular velocity; frequencies too, 1 Hz being 2π rad/s.
    AngularVelocity,
    /// An angular acceleration.
    AngularAcceleration,
    /// A velocity.
    Velocity,
    /// An acceleration.
    Acceleration,
    /// A force.
    Force,
    /// The moment of a force or of a couple.
    Torque,
    /// Work, heat or energy.
    Energy,
    /// Power.
    Power,
    /// Force over displacement; force over length too.
    Stiffness,
    /// Torque over angle.
    TorsionalStiffness,
    /// Force over velocity.
    Damping,
    /// Torque over angular velocity.
    TorsionalDamping,
    /// Stress, pressure or modulus of elasticity.
    Stress,
    /// An area.
    Area,
    /// A volume; a section modulus too.
    Volume,
    /// Second moment of area.
    SecondMoment,
    /// Mass over volume.
    Density,
    /// Mass over length.
    LinearDensity,
    /// Mass moment of inertia.
    MomentOfInertia,
    /// Mass times eccentricity.
    Unbalance,
    /// Displacement over force.
    Compliance,
    /// Modulus of elasticity times second moment of area.
    FlexuralRigidity,
    /// Linear momentum; impulse too.
    Momentum,
    /// Angular momentum.
    AngularMomentum,
    /// A pure number: a ratio, a level.
    Ratio,
    /// The amplitude of an oscillation, kept as its peak value: a length unless the unit says otherwise.
    Amplitude,
    /// Anything else: its dimension is that of the unit it is given with.
    Other,
}

struct Row {
    kind: Kind,
    dim: Dim,
    name: &'static str,
    /// To cycle through, SI first.
    units: &'static [&'static str],
    /// To show an answer in, from small to large.
    ladder: &'static [&'static str],
}

const fn row(
    kind: Kind,
    dim: Dim,
    name: &'static str,
    units: &'static [&'static str],
    ladder: &'static [&'static str],
) -> Row {
    Row { kind, dim, name, units, ladder }
}

/// In the order of [`Kind`], which decides what a dimension usually is: torque before energy, length before amplitude.
static ROWS: [Row; 30] = {
    const fn d(length: i8, mass: i8, time: i8, angle: i8) -> Dim {
        Dim::new(length, mass, time, angle)
    }
    [
        row(
            Kind::Length,
            Dim::LENGTH,
            "a length",
            &["m", "mm", "cm", "µm", "km", "in", "ft"],
            &["µm", "mm", "m", "km"],
        ),
        row(Kind::Mass, Dim::MASS, "a mass", &["kg", "g", "t", "lb", "slug"], &["g", "kg", "t"]),
        row(Kind::Time, Dim::TIME, "a time", &["s", "ms", "µs", "min", "h"], &["µs", "ms", "s"]),
        row(Kind::Angle, Dim::ANGLE, "an angle", &["rad", "deg", "mrad", "rev"], &["deg"]),
        row(
            Kind::AngularVelocity,
            d(0, 0, -1, 1),
            "an angular velocity",
            &["rad/s", "rpm", "Hz", "rev/s", "deg/s"],
            &["rad/s"],
        ),
        row(
            Kind::AngularAcceleration,
            d(0, 0, -2, 1),
            "an angular acceleration",
            &["rad/s^2", "rpm/s", "rev/s^2", "deg/s^2"],
            &["rad/s^2"],
        ),
        row(
            Kind::Velocity,
            d(1, 0, -1, 0),
            "a velocity",
            &["m/s", "mm/s", "km/h", "in/s", "ft/s"],
            &["mm/s", "m/s"],
        ),
        row(
            Kind::Acceleration,
            d(1, 0, -2, 0),
            "an acceleration",
            &["m/s^2", "g0", "mm/s^2", "in/s^2", "ft/s^2"],
            &["m/s^2"],
        ),
        row(
            Kind::Force,
            d(1, 1, -2, 0),
            "a force",
            &["N", "kN", "MN", "kgf", "tf", "lbf"],
            &["N", "kN", "MN"],
        ),
        row(
            Kind::Torque,
            d(2, 1, -2, 0),
            "a torque",
            &["N*m", "kN*m", "N*mm", "kgf*m", "lbf*in", "lbf*ft"],
            &["N*m", "kN*m", "MN*m"],
        ),
        row(
            Kind::Energy,
            d(2, 1, -2, 0),
            "an energy",
            &["J", "kJ", "MJ", "Wh", "kWh", "cal", "kcal"],
            &["J", "kJ", "MJ"],
        ),
        row(Kind::Power, d(2, 1, -3, 0), "a power", &["W", "kW", "MW", "hp", "cv"], &["W", "kW", "MW"]),
        row(
            Kind::Stiffness,
            d(0, 1, -2, 0),
            "a stiffness",
            &["N/m", "kN/m", "MN/m", "N/mm", "kgf/mm", "lbf/in"],
            &["N/m", "kN/m", "MN/m"],
        ),
        row(
            Kind::TorsionalStiffness,
            d(2, 1, -2, -1),
            "a torsional stiffness",
            &["N*m/rad", "kN*m/rad", "N*m/deg", "lbf*in/rad"],
            &["N*m/rad", "kN*m/rad", "MN*m/rad"],
        ),
        row(
            Kind::Damping,
            d(0, 1, -1, 0),
            "a damping coefficient",
            &["N*s/m", "kN*s/m", "N*s/mm", "lbf*s/in"],
            &["N*s/m", "kN*s/m", "MN*s/m"],
        ),
        row(
            Kind::TorsionalDamping,
            d(2, 1, -1, -1),
            "a torsional damping coefficient",
            &["N*m*s/rad", "kN*m*s/rad", "lbf*in*s/rad"],
            &["N*m*s/rad", "kN*m*s/rad"],
        ),
        row(
            Kind::Stress,
            d(-1, 1, -2, 0),
            "a stress",
            &["Pa", "kPa", "MPa", "GPa", "kN/mm^2", "kgf/cm^2", "bar", "psi"],
            &["Pa", "kPa", "MPa", "GPa"],
        ),
        row(
            Kind::Area,
            d(2, 0, 0, 0),
            "an area",
            &["m^2", "mm^2", "cm^2", "in^2", "ft^2"],
            &["mm^2", "cm^2", "m^2"],
        ),
        row(
            Kind::Volume,
            d(3, 0, 0, 0),
            "a volume",
            &["m^3", "mm^3", "cm^3", "L", "in^3", "ft^3"],
            &["mm^3", "cm^3", "m^3"],
        ),
        row(
            Kind::SecondMoment,
            d(4, 0, 0, 0),
            "a second moment of area",
            &["m^4", "mm^4", "cm^4", "in^4"],
            &["mm^4", "cm^4", "m^4"],
        ),
        row(
            Kind::Density,
            d(-3, 1, 0, 0),
            "a density",
            &["kg/m^3", "g/cm^3", "t/m^3", "lb/in^3", "lb/ft^3"],
            &["kg/m^3"],
        ),
        row(
            Kind::LinearDensity,
            d(-1, 1, 0, 0),
            "a mass per length",
            &["kg/m", "g/mm", "lb/ft", "lb/in"],
            &["kg/m"],
        ),
        row(
            Kind::MomentOfInertia,
            d(2, 1, 0, 0),
            "a moment of inertia",
            &["kg*m^2", "g*m^2", "kg*cm^2", "kg*mm^2", "lb*in^2", "lb*ft^2"],
            &["kg*mm^2", "kg*cm^2", "kg*m^2"],
        ),
        row(
            Kind::Unbalance,
            d(1, 1, 0, 0),
            "an unbalance",
            &["kg*m", "kg*mm", "g*mm", "g*cm", "oz*in"],
            &["g*mm", "kg*mm", "kg*m"],
        ),
        row(
            Kind::Compliance,
            d(0, -1, 2, 0),
            "a compliance",
            &["m/N", "mm/N", "µm/N", "mm/kN", "in/lbf"],
            &["µm/N", "mm/N", "m/N"],
        ),
        row(
            Kind::FlexuralRigidity,
            d(3, 1, -2, 0),
            "a flexural rigidity",
            &["N*m^2", "kN*m^2", "N*mm^2", "lbf*in^2"],
            &["N*m^2", "kN*m^2", "MN*m^2"],
        ),
        row(Kind::Momentum, d(1, 1, -1, 0), "a momentum", &["kg*m/s", "N*s", "lbf*s"], &["kg*m/s"]),
        row(
            Kind::AngularMomentum,
            d(2, 1, -1, 0),
            "an angular momentum",
            &["kg*m^2/s", "N*m*s", "lbf*in*s"],
            &["kg*m^2/s"],
        ),
        row(Kind::Ratio, Dim::NONE, "a ratio", &["1", "%", "dB"], &["1"]),
        row(
            Kind::Amplitude,
            Dim::LENGTH,
            "an amplitude",
            &["m", "mm", "µm", "mm pp", "µm pp", "mm rms", "mil pp", "in"],
            &["µm", "mm", "m"],
        ),
    ]
};

impl Kind {
    /// Every kind but [`Kind::Other`].
    pub fn all() -> impl Iterator<Item = Kind> {
        ROWS.iter().map(|row| row.kind)
    }

    /// The usual kind of what is written in `unit`: N·m is a torque, J an energy, `mm pp` an amplitude.
    ///
    /// 1/s counts as an angular velocity and a unit that fits no kind is [`Kind::Other`].
    pub fn of(unit: &Unit) -> Kind {
        match unit.sense {
            UnitMeaning::Energy => return Kind::Energy,
            UnitMeaning::Peak | UnitMeaning::PeakToPeak | UnitMeaning::Rms => return Kind::Amplitude,
            UnitMeaning::Plain | UnitMeaning::Level => {}
        }
        Kind::of_dim(unit.dim)
    }

    /// The usual kind of a dimension: m²·kg·s⁻² is a torque, s⁻¹ an angular velocity.
    pub fn of_dim(dim: Dim) -> Kind {
        ROWS.iter()
            .find(|row| row.dim == dim)
            .or_else(|| ROWS.iter().find(|row| row.dim.agrees(dim) && dim.angle == 0))
            .map_or(Kind::Other, |row| row.kind)
    }

    /// Dimension of the kind; `None` for [`Kind::Other`].
    pub fn dim(self) -> Option<Dim> {
        self.row().map(|row| row.dim)
    }

    /// Name as a noun phrase: `"a length"`, `"an angular velocity"`.
    pub fn name(self) -> &'static str {
        self.row().map_or("another quantity", |row| row.name)
    }

    /// Units worth cycling through, the SI unit first. Empty for [`Kind::Other`].
    pub fn units(self) -> &'static [&'static str] {
        self.row().map_or(&[], |row| row.units)
    }

    /// Units worth showing an answer in, from small to large.
    pub(crate) fn ladder(self) -> &'static [&'static str] {
        self.row().map_or(&[], |row| row.ladder)
    }

    fn row(self) -> Option<&'static Row> {
        ROWS.get(self as usize)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::unit;

    #[test]
    fn rows_are_in_the_order_of_the_kinds() {
        for (n, row) in ROWS.iter().enumerate() {
            assert_eq!(row.kind as usize, n, "{}", row.name);
            assert_eq!(row.kind.name(), row.name);
        }
        assert_eq!(Kind::Other as usize, ROWS.len());
        assert_eq!(Kind::Other.dim(), None);
        assert!(Kind::Other.units().is_empty());
    }

    #[test]
    fn units_start_with_si_and_ladders_rise() {
        for row in &ROWS {
            assert!((3..=8).contains(&row.units.len()), "{}", row.name);
            assert_eq!(unit(row.units[0]).unwrap().factor, 1.0, "{}", row.name);
            let factors: Vec<_> = row.ladder.iter().map(|text| unit(text).unwrap().factor).collect();
            assert!(factors.is_sorted() && !factors.is_empty(), "{}", row.name);
        }
    }
}
