//! Springs: elastic elements and networks of them, as one number `k`.

use dalembert_core::{Inputs, Refusal, Worksheet};
use dalembert_mechanics::Real;

pub(crate) mod element;
pub(crate) mod shares;
mod single;
pub(crate) mod sketch;
pub mod torsional;

use self::element::{Build, SpringMotion};
pub(crate) use self::element::{Element, Joined, symbol};
pub use crate::shared::continuous::ShearModulus;
use crate::shared::section::{AxialSection, Section, ShaftSection};

/// Spring or elastic member under the load.
#[derive(Clone, Debug, Inputs)]
pub enum Spring {
    /// Stiffness given
    Stiffness {
        /// Stiffness.
        #[input("k", "N/m", positive)]
        stiffness: f64,
    },
    /// Equal springs side by side
    /// Mounts of a machine, for instance.
    Equal {
        /// Number of springs.
        #[input("n", "1", min = 1)]
        count: f64,
        /// Stiffness of each spring.
        #[input("k₁", "N/m", positive)]
        stiffness: f64,
    },
    /// Cantilever
    Cantilever {
        /// Length.
        /// From the clamp to the load; the part beyond the load does not bend.
        #[input("L", "m", positive)]
        length: f64,
        /// Young's modulus.
        #[input("E", "Pa", positive)]
        young: f64,
        /// Section.
        section: Section,
    },
    /// Simply supported beam
    SimplySupported {
        /// Span.
        #[input("L", "m", positive)]
        length: f64,
        /// Distance of the load from a support.
        /// The load is at midspan if this is omitted.
        #[input("a", "m", positive)]
        distance: Option<f64>,
        /// Young's modulus.
        #[input("E", "Pa", positive)]
        young: f64,
        /// Section.
        section: Section,
    },
    /// Beam clamped at both ends
    Clamped {
        /// Span.
        #[input("L", "m", positive)]
        length: f64,
        /// Distance of the load from a clamp.
        /// The load is at midspan if this is omitted.
        #[input("a", "m", positive)]
        distance: Option<f64>,
        /// Young's modulus.
        #[input("E", "Pa", positive)]
        young: f64,
        /// Section.
        section: Section,
    },
    /// Beam clamped at one end and pinned at the other
    ClampedPinned {
        /// Span.
        #[input("L", "m", positive)]
        length: f64,
        /// Distance of the load from the clamp.
        /// The load is at midspan if this is omitted.
        #[input("a", "m", positive)]
        distance: Option<f64>,
        /// Young's modulus.
        #[input("E", "Pa", positive)]
        young: f64,
        /// Section.
        section: Section,
    },
    /// Overhang of a simply supported beam
    Overhang {
        /// Span between the supports.
        #[input("L", "m", positive)]
        length: f64,
        /// Overhang.
        /// From the nearer support to the load.
        #[input("a", "m", positive)]
        overhang: f64,
        /// Young's modulus.
        #[input("E", "Pa", positive)]
        young: f64,
        /// Section.
        section: Section,
    },
    /// Fixed–guided column
    Column {
        /// Height.
        #[input("L", "m", positive)]
        length: f64,
        /// Young's modulus.
        #[input("E", "Pa", positive)]
        young: f64,
        /// Section.
        section: Section,
    },
    /// Bar in tension
    /// A stepped bar is a series combination of its segments.
    Bar {
        /// Length.
        #[input("L", "m", positive)]
        length: f64,
        /// Young's modulus.
        #[input("E", "Pa", positive)]
        young: f64,
        /// Section.
        section: AxialSection,
    },
    /// Tapered round bar in tension
    TaperedBar {
        /// Length.
        #[input("L", "m", positive)]
        length: f64,
        /// Young's modulus.
        #[input("E", "Pa", positive)]
        young: f64,
        /// Diameter at one end.
        #[input("d_a", "m", positive)]
        first_diameter: f64,
        /// Diameter at the other end.
        #[input("d_b", "m", positive)]
        second_diameter: f64,
    },
    /// Torsion bar with a lever
    TorsionBar {
        /// Length.
        #[input("L", "m", positive)]
        length: f64,
        /// Shear modulus.
        shear: ShearModulus,
        /// Section.
        section: ShaftSection,
        /// Lever.
        /// From the axis of the bar to the load; small angles.
        #[input("a", "m", positive)]
        lever: f64,
    },
    /// Helical spring
    Helical {
        /// Shear modulus.
        shear: ShearModulus,
        /// Diameter of the wire.
        #[input("d", "m", positive)]
        wire_diameter: f64,
        /// Mean diameter of the coils.
        #[input("D", "m", positive)]
        coil_diameter: f64,
        /// Active coils.
        #[input("n", "1", positive)]
        coils: f64,
    },
    /// From its deflection under a load
    Deflected {
        /// Load.
        #[input("F₁", "N", positive)]
        load: f64,
        /// Deflection.
        #[input("δ₁", "m", positive)]
        deflection: f64,
    },
    /// From the natural frequency of a mass on it
    Tuned {
        /// Mass on the spring.
        #[input("m₁", "kg", positive)]
        mass: f64,
        /// Natural frequency.
        #[input("ω₁", "rad/s", positive)]
        frequency: f64,
    },
    /// Leaf spring
    /// Semi-elliptic, with leaves cut from a plate of uniform strength; interleaf friction neglected.
    Leaf {
        /// Young's modulus.
        #[input("E", "Pa", positive)]
        young: f64,
        /// Leaves.
        #[input("n", "1", positive)]
        leaves: f64,
        /// Width of a leaf.
        #[input("b", "m", positive)]
        breadth: f64,
        /// Thickness of a leaf.
        #[input("t", "m", positive)]
        thickness: f64,
        /// Span.
        #[input("L", "m", positive)]
        span: f64,
    },
    /// Rubber pad in shear
    ShearPad {
        /// Shear modulus.
        shear: ShearModulus,
        /// Bonded area.
        #[input("A", "m^2", positive)]
        area: f64,
        /// Thickness.
        #[input("h", "m", positive)]
        thickness: f64,
    },
    /// Air spring
    Gas {
        /// Polytropic exponent.
        /// 1.4 for air and quick motions, 1 for slow ones.
        #[input("n", "1", positive, default = "1.4")]
        exponent: f64,
        /// Absolute pressure.
        #[input("p", "Pa", positive)]
        pressure: f64,
        /// Area of the piston.
        #[input("A", "m^2", positive)]
        area: f64,
        /// Volume of the gas.
        #[input("V", "m^3", positive)]
        volume: f64,
    },
    /// Taut string or cable under a transverse load
    TautString {
        /// Tension.
        #[input("T", "N", positive)]
        tension: f64,
        /// From the load to one end.
        #[input("a", "m", positive)]
        left: f64,
        /// From the load to the other end.
        #[input("b", "m", positive)]
        right: f64,
    },
    /// Pendulum: gravitational stiffness
    Pendulum {
        /// Suspended mass.
        #[input("m_p", "kg", positive)]
        mass: f64,
        /// Length.
        #[input("l", "m", positive)]
        length: f64,
        /// Gravity.
        #[input("g", "m/s^2", positive, default = "9.81 m/s^2")]
        gravity: f64,
    },
    /// Floating body
    Buoyancy {
        /// Density of the liquid.
        #[input("ρ", "kg/m^3", positive)]
        density: f64,
        /// Area of the waterline.
        #[input("A", "m^2", positive)]
        area: f64,
        /// Gravity.
        #[input("g", "m/s^2", positive, default = "9.81 m/s^2")]
        gravity: f64,
    },
    /// Liquid in a U-tube
    UTube {
        /// Density of the liquid.
        #[input("ρ", "kg/m^3", positive)]
        density: f64,
        /// Internal area of the tube.
        #[input("A", "m^2", positive)]
        area: f64,
        /// Gravity.
        #[input("g", "m/s^2", positive, default = "9.81 m/s^2")]
        gravity: f64,
    },
    /// Reflected through a lever
    /// The members stand side by side on the lever; small angles.
    Lever {
        /// Arm of the springs.
        /// From the pivot.
        #[input("a", "m", positive)]
        spring_arm: f64,
        /// Arm of the load.
        /// From the pivot.
        #[input("b", "m", positive)]
        load_arm: f64,
        /// Members.
        #[input(min = 1)]
        members: Vec<Spring>,
    },
    /// Inclined to the motion
    /// The members stand side by side; small motions, no load at rest.
    Inclined {
        /// Angle between springs and motion.
        #[input("α", "deg", min = -89.9, max = 89.9)]
        angle: f64,
        /// Members.
        #[input(min = 1)]
        members: Vec<Spring>,
    },
    /// Series: end to end
    /// Every member carries the whole force.
    Series {
        /// Members.
        #[input(min = 1)]
        members: Vec<Spring>,
    },
    /// Parallel: side by side
    /// All members have the same deflection.
    Parallel {
        /// Members.
        #[input(min = 1)]
        members: Vec<Spring>,
    },
}

/// The stiffness `k` of a spring, N/m, with the steps that lead to it.
///
/// # Errors
/// A load outside its beam; a tube without a wall.
#[inline]
pub fn stiffness<W: Worksheet>(given: &SpringGiven<W>, sheet: W) -> Result<W::Num, Refusal> {
    single::stiffness(given, sheet, &[])
}

/// The stiffness of a network and of each of its parts, with the steps that lead to them.
///
/// # Errors
/// Those of [`stiffness`].
pub(crate) fn network<W: Worksheet>(
    given: &SpringGiven<W>,
    sheet: W,
    place: &[usize],
) -> Result<Element<W::Num>, Refusal> {
    let build = Build { motion: SpringMotion::Translation, place, label: label(given), sheet };
    let inside = |members: &[SpringGiven<W>]| {
        let row = |(n, member): (usize, &SpringGiven<W>)| network(member, sheet, &[place, &[n + 1]].concat());
        members.iter().enumerate().map(row).collect::<Result<Vec<_>, _>>()
    };
    match given {
        SpringGiven::Series { members } => Ok(build.series(inside(members)?)),
        SpringGiven::Parallel { members } => Ok(build.parallel(inside(members)?)),
        SpringGiven::Lever { spring_arm, load_arm, members } => {
            let members = inside(members)?;
            let why = "Displacement of the lever at the springs per displacement at the load";
            Ok(build.reflected_stiffness(*spring_arm / *load_arm, why, members))
        }
        SpringGiven::Inclined { angle, members } => {
            let members = inside(members)?;
            let why = "Part of the motion that the springs follow";
            Ok(build.reflected_stiffness(angle.cos(), why, members))
        }
        single => Ok(build.alone(single::stiffness(single, sheet, place)?)),
    }
}

/// Name of the type of an element.
fn label<W: Worksheet>(given: &SpringGiven<W>) -> &'static str {
    match given {
        SpringGiven::Equal { .. } => "equal springs",
        SpringGiven::Stiffness { .. } | SpringGiven::Deflected { .. } | SpringGiven::Tuned { .. } => "spring",
        SpringGiven::Cantilever { .. } => "cantilever",
        SpringGiven::SimplySupported { .. } => "simply supported beam",
        SpringGiven::Clamped { .. } => "clamped beam",
        SpringGiven::ClampedPinned { .. } => "clamped and pinned beam",
        SpringGiven::Overhang { .. } => "overhang",
        SpringGiven::Column { .. } => "column",
        SpringGiven::Bar { .. } => "bar",
        SpringGiven::TaperedBar { .. } => "tapered bar",
        SpringGiven::TorsionBar { .. } => "torsion bar",
        SpringGiven::Helical { .. } => "helical spring",
        SpringGiven::Leaf { .. } => "leaf spring",
        SpringGiven::ShearPad { .. } => "rubber pad",
        SpringGiven::Gas { .. } => "air spring",
        SpringGiven::TautString { .. } => "taut string",
        SpringGiven::Pendulum { .. } => "pendulum",
        SpringGiven::Buoyancy { .. } => "buoyancy",
        SpringGiven::UTube { .. } => "liquid column",
        SpringGiven::Lever { .. } => "through a lever",
        SpringGiven::Inclined { .. } => "inclined",
        SpringGiven::Series { .. } => "in series",
        SpringGiven::Parallel { .. } => "in parallel",
    }
}
