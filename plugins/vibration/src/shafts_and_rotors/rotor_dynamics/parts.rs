//! Inputs of the parts of a rotor.

use dalembert_core::{Inputs, Refusal, Worksheet};
use dalembert_mechanics::{
    Real,
    rotor::{Coefficients, SupportType, disc as formula},
};

use crate::sources::FRISWELL;

/// A piece of shaft.
#[derive(Clone, Debug, Inputs)]
pub struct ShaftSegment {
    /// Length of the segment.
    #[input("L", "m", positive)]
    pub length: f64,
    /// Outer diameter.
    #[input("D", "m", positive)]
    pub outer: f64,
    /// Outer diameter at the right end.
    /// Only for a tapered segment.
    #[input("D_R", "m", positive)]
    pub outer_right: Option<f64>,
    /// Inner diameter.
    /// Omit for a solid shaft.
    #[input("d", "m", nonnegative)]
    pub inner: Option<f64>,
}

/// Material of the shaft.
#[derive(Clone, Debug, Inputs)]
pub struct ShaftMaterial {
    /// Young's modulus.
    #[input("E", "Pa", positive, default = "210 GPa")]
    pub young: f64,
    /// Shear modulus.
    /// Also gives Poisson's ratio for the shear factor.
    #[input("G", "Pa", positive, default = "81 GPa")]
    pub shear: f64,
    /// Density.
    #[input("ρ", "kg/m^3", positive, default = "7850 kg/m^3")]
    pub density: f64,
    /// Internal damping.
    pub damping: InternalDamping,
}

/// Internal damping of the material, which rotates with the shaft.
#[derive(Clone, Debug, Inputs)]
pub enum InternalDamping {
    /// No internal damping
    None,
    /// Viscous internal damping
    Viscous {
        /// Coefficient of internal (rotating) damping.
        /// Stress E (ε + ηᵥ dε/dt).
        #[input("ηᵥ", "s", nonnegative)]
        coefficient: f64,
    },
    /// Hysteretic internal damping
    Hysteretic {
        /// Loss factor.
        #[input("ηₕ", "1", nonnegative, max = 1)]
        loss_factor: f64,
    },
}

/// A rigid disc on the shaft.
#[derive(Clone, Debug, Inputs)]
pub struct RotorDisc {
    /// Position.
    /// Distance from the left end of the shaft.
    #[input("z", "m", nonnegative)]
    pub position: f64,
    /// Size of the disc.
    pub size: DiscSize,
}

/// A disc by its geometry or by its inertia.
#[derive(Clone, Debug, Inputs)]
pub enum DiscSize {
    /// Diameters and width
    Geometry {
        /// Outer diameter of the disc.
        #[input("D_d", "m", positive)]
        outer: f64,
        /// Bore of the disc.
        /// The diameter of the shaft that runs through it.
        #[input("d_d", "m", nonnegative, default = "0 mm")]
        bore: f64,
        /// Width of the disc.
        #[input("h", "m", positive)]
        width: f64,
        /// Density of the disc.
        #[input("ρ_d", "kg/m^3", positive, default = "7850 kg/m^3")]
        density: f64,
    },
    /// Mass and moments of inertia
    Inertia {
        /// Mass of the disc.
        #[input("m_d", "kg", nonnegative)]
        mass: f64,
        /// Moment of inertia about a diameter.
        #[input("I_d", "kg*m^2", nonnegative)]
        diametral: f64,
        /// Moment of inertia about the axis.
        #[input("I_p", "kg*m^2", nonnegative)]
        polar: f64,
    },
}

/// A support of the shaft.
#[derive(Clone, Debug, Inputs)]
pub struct RotorSupport {
    /// Position.
    /// Distance from the left end of the shaft.
    #[input("z_b", "m", nonnegative)]
    pub position: f64,
    /// Bearing.
    pub bearing: Bearing,
}

/// Type and coefficients of a support. The force on the shaft is −k (x, y) − c (ẋ, ẏ).
#[derive(Clone, Debug, Inputs)]
pub enum Bearing {
    /// The same in every direction
    Isotropic {
        /// Stiffness.
        #[input("k", "N/m", nonnegative)]
        stiffness: f64,
        /// Damping coefficient.
        #[input("c", "N*s/m", nonnegative, default = "0 N*s/m")]
        damping: f64,
    },
    /// Different along x and y
    Orthotropic {
        /// Stiffness along x.
        #[input("k_xx", "N/m", nonnegative)]
        stiffness_x: f64,
        /// Stiffness along y.
        #[input("k_yy", "N/m", nonnegative)]
        stiffness_y: f64,
        /// Damping along x.
        #[input("c_xx", "N*s/m", nonnegative, default = "0 N*s/m")]
        damping_x: f64,
        /// Damping along y.
        #[input("c_yy", "N*s/m", nonnegative, default = "0 N*s/m")]
        damping_y: f64,
    },
    /// Eight coefficients
    Coefficients {
        /// Stiffness k_xx.
        #[input("k_xx", "N/m")]
        kxx: f64,
        /// Stiffness k_xy.
        /// Force along x due to motion along y.
        #[input("k_xy", "N/m")]
        kxy: f64,
        /// Stiffness k_yx.
        #[input("k_yx", "N/m")]
        kyx: f64,
        /// Stiffness k_yy.
        #[input("k_yy", "N/m")]
        kyy: f64,
        /// Damping c_xx.
        #[input("c_xx", "N*s/m", default = "0 N*s/m")]
        cxx: f64,
        /// Damping c_xy.
        #[input("c_xy", "N*s/m", default = "0 N*s/m")]
        cxy: f64,
        /// Damping c_yx.
        #[input("c_yx", "N*s/m", default = "0 N*s/m")]
        cyx: f64,
        /// Damping c_yy.
        #[input("c_yy", "N*s/m", default = "0 N*s/m")]
        cyy: f64,
    },
    /// Table of coefficients against speed
    Table {
        /// Rows of the table.
        /// In order of increasing speed, linear between rows; all requested speeds must lie within the table. A single
        /// row applies at all speeds.
        #[input(table)]
        rows: Vec<SpeedRow>,
    },
    /// Rigid, free to tilt
    Pinned,
    /// Rigid, not free to tilt
    Clamped,
}

/// The coefficients of a bearing at a speed.
#[derive(Clone, Debug, Inputs)]
pub struct SpeedRow {
    /// Speed for this row.
    #[input("Ω", "rpm", nonnegative)]
    pub speed: f64,
    /// Stiffness k_xx.
    #[input("k_xx", "N/m")]
    pub kxx: f64,
    /// Stiffness k_xy.
    #[input("k_xy", "N/m")]
    pub kxy: f64,
    /// Stiffness k_yx.
    #[input("k_yx", "N/m")]
    pub kyx: f64,
    /// Stiffness k_yy.
    #[input("k_yy", "N/m")]
    pub kyy: f64,
    /// Damping c_xx.
    #[input("c_xx", "N*s/m")]
    pub cxx: f64,
    /// Damping c_xy.
    #[input("c_xy", "N*s/m")]
    pub cxy: f64,
    /// Damping c_yx.
    #[input("c_yx", "N*s/m")]
    pub cyx: f64,
    /// Damping c_yy.
    #[input("c_yy", "N*s/m")]
    pub cyy: f64,
}

/// An unbalance.
#[derive(Clone, Debug, Inputs)]
pub struct RotorUnbalance {
    /// Position.
    /// Distance from the left end of the shaft.
    #[input("z_u", "m", nonnegative)]
    pub position: f64,
    /// Unbalance.
    /// Mass times its distance from the axis.
    #[input("U", "kg*m", nonnegative)]
    pub size: f64,
    /// Angle of the unbalance on the shaft.
    #[input("α", "deg", default = "0 deg")]
    pub angle: f64,
}

/// Beam theory of the shaft.
#[derive(Clone, Debug, Inputs)]
pub enum ShaftTheory {
    /// Timoshenko: bending and shear
    Timoshenko,
    /// Euler–Bernoulli: bending alone
    EulerBernoulli,
}

/// The inertia of a disc.
pub(super) struct DiscInertia<N> {
    pub(super) mass: N,
    pub(super) diametral: N,
    pub(super) polar: N,
}

/// The inertia of a disc, written as steps where it is not given.
pub(super) fn disc<W: Worksheet>(
    given: &RotorDiscGiven<W>,
    n: usize,
    sheet: W,
) -> Result<DiscInertia<W::Num>, Refusal> {
    match &given.size {
        DiscSizeGiven::Inertia { mass, diametral, polar } => {
            Ok(DiscInertia { mass: *mass, diametral: *diametral, polar: *polar })
        }
        DiscSizeGiven::Geometry { outer, bore, width, density } => {
            if bore.value() >= outer.value() {
                return Err(Refusal::because(
                    "the bore of a disc is not below its outer diameter: write the larger one as the outer",
                ));
            }
            let squared = || *density * (*outer - *bore).powi(2) * *width * std::f64::consts::PI / 4.0;
            sheet.common_error(("m_d", n), "the square of the difference of the diameters taken", squared);
            let mass = sheet.step(
                ("m_d", n),
                "kg",
                formula::mass(*density, *outer, *bore, *width),
                "Mass of the disc",
            );
            let polar = sheet.step(
                ("I_p", n),
                "kg*m^2",
                formula::polar(mass, *outer, *bore),
                ("Moment of inertia of the disc about the axis", FRISWELL.at("app. 1")),
            );
            let about_face = || polar / 2.0 + mass * width.powi(2) / 3.0;
            let what = "the moment of inertia about a diameter of the face taken";
            sheet.common_error(("I_d", n), what, about_face);
            let diametral = sheet.step(
                ("I_d", n),
                "kg*m^2",
                formula::diametral(mass, polar, *width),
                ("Moment of inertia of the disc about a diameter", FRISWELL.at("app. 1")),
            );
            Ok(DiscInertia { mass, diametral, polar })
        }
    }
}

/// Mass of a segment, perhaps tapered: `m = ρ π L (D² + D D_R + D_R² − 3d²)/12`.
pub(super) fn segment_mass<W: Worksheet>(given: &ShaftSegmentGiven<W>, density: W::Num) -> W::Num {
    let area = match (given.outer_right, given.inner) {
        (None, None) => given.outer.powi(2),
        (None, Some(inner)) => given.outer.powi(2) - inner.powi(2),
        (Some(right), None) => (given.outer.powi(2) + given.outer * right + right.powi(2)) / 3.0,
        (Some(right), Some(inner)) => {
            (given.outer.powi(2) + given.outer * right + right.powi(2)) / 3.0 - inner.powi(2)
        }
    };
    density * area * given.length * std::f64::consts::PI / 4.0
}

impl Bearing {
    /// The bearing as the elements need it.
    pub(super) fn hold(&self) -> SupportType {
        let always = |coefficients| SupportType::Bearing(vec![(0.0, coefficients)]);
        match self {
            Bearing::Isotropic { stiffness, damping } => {
                always(Coefficients::isotropic(*stiffness, *damping))
            }
            Bearing::Orthotropic { stiffness_x, stiffness_y, damping_x, damping_y } => {
                always(Coefficients::orthotropic([*stiffness_x, *stiffness_y], [*damping_x, *damping_y]))
            }
            Bearing::Coefficients { kxx, kxy, kyx, kyy, cxx, cxy, cyx, cyy } => always(Coefficients {
                stiffness: [[*kxx, *kxy], [*kyx, *kyy]],
                damping: [[*cxx, *cxy], [*cyx, *cyy]],
            }),
            Bearing::Table { rows } => SupportType::Bearing(
                rows.iter()
                    .map(|row| {
                        let coefficients = Coefficients {
                            stiffness: [[row.kxx, row.kxy], [row.kyx, row.kyy]],
                            damping: [[row.cxx, row.cxy], [row.cyx, row.cyy]],
                        };
                        (row.speed, coefficients)
                    })
                    .collect(),
            ),
            Bearing::Pinned => SupportType::Pinned,
            Bearing::Clamped => SupportType::Clamped,
        }
    }
}
