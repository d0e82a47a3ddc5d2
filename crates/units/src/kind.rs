//! Kinds of quantity: what a number is, beyond its dimension.

use crate::{Dim, Sense, Unit};

/// What a quantity is. Torque and energy share a dimension and are different kinds; so are an angle and a ratio.
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
#[expect(clippy::enum_glob_use, reason = "one row for each of its variants")]
static ROWS: [Row; 30] = {
    use Kind::*;
    const fn d(length: i8, mass: i8, time: i8, angle: i8) -> Dim {
        Dim::new(length, mass, time, angle)
    }
    [
        row(
            Length,
            Dim::LENGTH,
            "a length",
            &["m", "mm", "cm", "µm", "km", "in", "ft"],
            &["µm", "mm", "m", "km"],
        ),
        row(Mass, Dim::MASS, "a mass", &["kg", "g", "t", "lb", "slug"], &["g", "kg", "t"]),
        row(Time, Dim::TIME, "a time", &["s", "ms", "µs", "min", "h"], &["µs", "ms", "s"]),
        row(Angle, Dim::ANGLE, "an angle", &["rad", "deg", "mrad", "rev"], &["deg"]),
        row(
            AngularVelocity,
            d(0, 0, -1, 1),
            "an angular velocity",
            &["rad/s", "rpm", "Hz", "rev/s", "deg/s"],
            &["rad/s"],
        ),
        row(
            AngularAcceleration,
            d(0, 0, -2, 1),
            "an angular acceleration",
            &["rad/s^2", "rpm/s", "rev/s^2", "deg/s^2"],
            &["rad/s^2"],
        ),
        row(
            Velocity,
            d(1, 0, -1, 0),
            "a velocity",
            &["m/s", "mm/s", "km/h", "in/s", "ft/s"],
            &["mm/s", "m/s"],
        ),
        row(
            Acceleration,
            d(1, 0, -2, 0),
            "an acceleration",
            &["m/s^2", "g0", "mm/s^2", "in/s^2", "ft/s^2"],
            &["m/s^2"],
        ),
        row(Force, d(1, 1, -2, 0), "a force", &["N", "kN", "MN", "kgf", "tf", "lbf"], &["N", "kN", "MN"]),
        row(
            Torque,
            d(2, 1, -2, 0),
            "a torque",
            &["N*m", "kN*m", "N*mm", "kgf*m", "lbf*in", "lbf*ft"],
            &["N*m", "kN*m", "MN*m"],
        ),
        row(
            Energy,
            d(2, 1, -2, 0),
            "an energy",
            &["J", "kJ", "MJ", "Wh", "kWh", "cal", "kcal"],
            &["J", "kJ", "MJ"],
        ),
        row(Power, d(2, 1, -3, 0), "a power", &["W", "kW", "MW", "hp", "cv"], &["W", "kW", "MW"]),
        row(
            Stiffness,
            d(0, 1, -2, 0),
            "a stiffness",
            &["N/m", "kN/m", "MN/m", "N/mm", "kgf/mm", "lbf/in"],
            &["N/m", "kN/m", "MN/m"],
        ),
        row(
            TorsionalStiffness,
            d(2, 1, -2, -1),
            "a torsional stiffness",
            &["N*m/rad", "kN*m/rad", "N*m/deg", "lbf*in/rad"],
            &["N*m/rad", "kN*m/rad", "MN*m/rad"],
        ),
        row(
            Damping,
            d(0, 1, -1, 0),
            "a damping coefficient",
            &["N*s/m", "kN*s/m", "N*s/mm", "lbf*s/in"],
            &["N*s/m", "kN*s/m", "MN*s/m"],
        ),
        row(
            TorsionalDamping,
            d(2, 1, -1, -1),
            "a torsional damping coefficient",
            &["N*m*s/rad", "kN*m*s/rad", "lbf*in*s/rad"],
            &["N*m*s/rad", "kN*m*s/rad"],
        ),
        row(
            Stress,
            d(-1, 1, -2, 0),
            "a stress",
            &["Pa", "kPa", "MPa", "GPa", "kN/mm^2", "kgf/cm^2", "bar", "psi"],
            &["Pa", "kPa", "MPa", "GPa"],
        ),
        row(
            Area,
            d(2, 0, 0, 0),
            "an area",
            &["m^2", "mm^2", "cm^2", "in^2", "ft^2"],
            &["mm^2", "cm^2", "m^2"],
        ),
        row(
            Volume,
            d(3, 0, 0, 0),
            "a volume",
            &["m^3", "mm^3", "cm^3", "L", "in^3", "ft^3"],
            &["mm^3", "cm^3", "m^3"],
        ),
        row(
            SecondMoment,
            d(4, 0, 0, 0),
            "a second moment of area",
            &["m^4", "mm^4", "cm^4", "in^4"],
            &["mm^4", "cm^4", "m^4"],
        ),
        row(
            Density,
            d(-3, 1, 0, 0),
            "a density",
            &["kg/m^3", "g/cm^3", "t/m^3", "lb/in^3", "lb/ft^3"],
            &["kg/m^3"],
        ),
        row(
            LinearDensity,
            d(-1, 1, 0, 0),
            "a mass per length",
            &["kg/m", "g/mm", "lb/ft", "lb/in"],
            &["kg/m"],
        ),
        row(
            MomentOfInertia,
            d(2, 1, 0, 0),
            "a moment of inertia",
            &["kg*m^2", "g*m^2", "kg*cm^2", "kg*mm^2", "lb*in^2", "lb*ft^2"],
            &["kg*mm^2", "kg*cm^2", "kg*m^2"],
        ),
        row(
            Unbalance,
            d(1, 1, 0, 0),
            "an unbalance",
            &["kg*m", "kg*mm", "g*mm", "g*cm", "oz*in"],
            &["g*mm", "kg*mm", "kg*m"],
        ),
        row(
            Compliance,
            d(0, -1, 2, 0),
            "a compliance",
            &["m/N", "mm/N", "µm/N", "mm/kN", "in/lbf"],
            &["µm/N", "mm/N", "m/N"],
        ),
        row(
            FlexuralRigidity,
            d(3, 1, -2, 0),
            "a flexural rigidity",
            &["N*m^2", "kN*m^2", "N*mm^2", "lbf*in^2"],
            &["N*m^2", "kN*m^2", "MN*m^2"],
        ),
        row(Momentum, d(1, 1, -1, 0), "a momentum", &["kg*m/s", "N*s", "lbf*s"], &["kg*m/s"]),
        row(
            AngularMomentum,
            d(2, 1, -1, 0),
            "an angular momentum",
            &["kg*m^2/s", "N*m*s", "lbf*in*s"],
            &["kg*m^2/s"],
        ),
        row(Ratio, Dim::NONE, "a ratio", &["1", "%", "dB"], &["1"]),
        row(
            Amplitude,
            Dim::LENGTH,
            "an amplitude",
            &["m", "mm", "µm", "mm pp", "µm pp", "mm rms", "mil pp", "in"],
            &["µm", "mm", "m"],
        ),
    ]
};

impl Kind {
    /// The usual kind of what is written in `unit`: N·m is a torque, J an energy, `mm pp` an amplitude.
    ///
    /// 1/s counts as an angular velocity and a unit that fits no kind is [`Kind::Other`].
    pub fn of(unit: &Unit) -> Kind {
        match unit.sense {
            Sense::Energy => return Kind::Energy,
            Sense::Peak | Sense::PeakToPeak | Sense::Rms => return Kind::Amplitude,
            Sense::Plain | Sense::Level => {}
        }
        ROWS.iter()
            .find(|row| row.dim == unit.dim)
            .or_else(|| ROWS.iter().find(|row| row.dim.agrees(unit.dim) && unit.dim.angle == 0))
            .map_or(Kind::Other, |row| row.kind)
    }

    /// Its dimension; `None` for [`Kind::Other`].
    pub fn dim(self) -> Option<Dim> {
        self.row().map(|row| row.dim)
    }

    /// Its name as a noun phrase: `"a length"`, `"an angular velocity"`.
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
