//! A rigid body as a user describes it: put together from parts, or known by its inertia.

use dalembert_core::{Inputs, Refusal, Text};
use dalembert_mechanics::rigid::{
    BodyError, MassProperties,
    primitive::{Anchor, Extent, ShapeError},
};
use nalgebra::{Matrix3, Rotation3, Unit, Vector3};

use super::shape::Shape;

/// A rigid body, in a frame Oxyz fixed in it.
#[derive(Clone, Debug, Inputs)]
pub enum Body {
    /// Composed of parts
    Parts {
        /// Parts.
        #[input(min = 1)]
        parts: Vec<BodyPart>,
    },
    /// Defined by its inertia matrix
    Matrix {
        /// Mass.
        #[input("m_0", "kg", positive)]
        mass: f64,
        /// Position of the centre of mass G.
        #[input("r_0", "m", default = "(0; 0; 0) m")]
        centre: Vector3<f64>,
        /// Moments of inertia Iₓ, I_y, I_z.
        #[input("I_0", "kg*m^2")]
        moments: Vector3<f64>,
        /// Products of inertia I_yz, I_zx, I_xy.
        /// I_xy = ∫ xy dm; in the inertia matrix they appear with a minus sign.
        #[input("P_0", "kg*m^2", default = "(0; 0; 0) kg*m^2")]
        products: Vector3<f64>,
        /// Taken about.
        about: TakenAbout,
    },
    /// Defined by its radii of gyration
    Radii {
        /// Mass.
        #[input("m_0", "kg", positive)]
        mass: f64,
        /// Position of the centre of mass G.
        #[input("r_0", "m", default = "(0; 0; 0) m")]
        centre: Vector3<f64>,
        /// Radii of gyration about the axes through G.
        /// Iₓ = m kₓ², and so on; the axes are principal ones.
        #[input("k", "m")]
        radii: Vector3<f64>,
    },
}

/// The point that an inertia matrix is taken about.
#[derive(Clone, Debug, Inputs)]
pub enum TakenAbout {
    /// The centre of mass
    MassCentre,
    /// Another point
    Point {
        /// Position of the point.
        #[input("r_A", "m", default = "(0; 0; 0) m")]
        point: Vector3<f64>,
    },
}

/// A part of a body: a shape with a mass, in its place.
#[derive(Clone, Debug, Inputs)]
pub struct BodyPart {
    /// Name.
    pub name: String,
    /// Shape.
    pub shape: Shape,
    /// Amount.
    pub amount: Amount,
    /// Position of the reference point.
    #[input("r", "m", default = "(0; 0; 0) m")]
    pub position: Vector3<f64>,
    /// Reference point.
    #[input(default = "origin")]
    pub reference: ReferencePoint,
    /// Direction of the axes of the shape.
    #[input(default = "same")]
    pub direction: ShapeOrientation,
    /// It is.
    #[input(default = "material")]
    pub presence: Presence,
}

/// Mass of a part, or its density per length, area or volume.
#[derive(Clone, Debug, Inputs)]
pub enum Amount {
    /// Mass
    Mass {
        /// Mass.
        #[input("m", "kg", positive)]
        mass: f64,
    },
    /// Mass per length
    PerLength {
        /// Mass per length.
        #[input("μ", "kg/m", positive)]
        density: f64,
    },
    /// Mass per area
    PerArea {
        /// Mass per area.
        #[input("σ", "kg/m^2", positive)]
        density: f64,
    },
    /// Density
    PerVolume {
        /// Density.
        #[input("ρ", "kg/m^3", positive)]
        density: f64,
    },
}

/// The point of a shape whose position is given.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum ReferencePoint {
    /// The origin of its own axes
    /// As defined for the shape: the apex of a cone, the centre of a sphere, of a plate or of a circle.
    Origin,
    /// Its centre of mass
    MassCentre,
    /// Its near end
    /// Where its own z axis enters it; where an arc begins.
    NearEnd,
    /// Its far end
    /// Where its own z axis leaves it; where an arc ends.
    FarEnd,
    /// Its corner
    /// The corner with the smallest coordinates in its own axes.
    Corner,
}

/// Orientation of the axes of a shape in the frame of the body.
#[derive(Clone, Debug, Inputs)]
pub enum ShapeOrientation {
    /// Along x, y and z
    Same,
    /// Its z axis along
    /// For shapes of revolution and rods; other shapes are rotated there through the smallest angle.
    Axis {
        /// Any vector along the axis.
        #[input("e", "1")]
        axis: Vector3<f64>,
    },
    /// Its z axis along one vector, its x axis towards another
    Axes {
        /// Any vector along its z axis.
        #[input("e", "1")]
        axis: Vector3<f64>,
        /// Any vector on the side of its x axis.
        #[input("e′", "1")]
        side: Vector3<f64>,
    },
    /// Rotated about an axis
    Turned {
        /// Any vector along the axis.
        #[input("e", "1")]
        axis: Vector3<f64>,
        /// Angle, positive by the right-hand rule.
        #[input("χ", "rad")]
        angle: f64,
    },
    /// Euler angles
    /// Rotated about z by φ, then about the new x axis by θ, then about the new z axis by ψ.
    Euler {
        /// Precession.
        #[input("φ", "rad", default = "0 deg")]
        precession: f64,
        /// Nutation.
        #[input("θ", "rad", default = "0 deg")]
        nutation: f64,
        /// Spin.
        #[input("ψ", "rad", default = "0 deg")]
        spin: f64,
    },
}

/// Sign of a part: added or removed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum Presence {
    /// Material
    Material,
    /// A hole
    /// Its mass is subtracted from the rest.
    Hole,
}

impl Body {
    /// Mass, centre of mass and inertia about it, held against what a body can be.
    ///
    /// # Errors
    /// A refusal that names the part.
    pub fn properties(&self) -> Result<MassProperties, Refusal> {
        let whole = match self {
            Body::Parts { parts } => {
                let parts = parts.iter().map(BodyPart::properties).collect::<Result<Vec<_>, _>>()?;
                MassProperties::composite(&parts).map_err(|error| refused(&error, "this body"))?
            }
            Body::Matrix { mass, centre, moments, products, about } => {
                let tensor = MassProperties::tensor(*moments, *products);
                let point = match about {
                    TakenAbout::MassCentre => *centre,
                    TakenAbout::Point { point } => *point,
                };
                MassProperties::from_inertia_about(point, tensor, *mass, *centre)
            }
            Body::Radii { mass, centre, radii } => MassProperties {
                mass: *mass,
                centre: *centre,
                inertia: Matrix3::from_diagonal(&(radii.component_mul(radii) * *mass)),
            },
        };
        whole.check().map_err(|error| refused(&error, "this body"))?;
        Ok(whole)
    }
}

impl BodyPart {
    /// Mass, centre of mass and inertia about it in the frame of the body; negative for a hole.
    ///
    /// # Errors
    /// A refusal that names the part.
    pub fn properties(&self) -> Result<MassProperties, Refusal> {
        self.shape.check().map_err(|error| self.misshapen(&error))?;
        let mass = match (&self.amount, self.shape.extent()) {
            (Amount::Mass { mass }, _) => *mass,
            (Amount::PerLength { density }, Extent::Length(extent))
            | (Amount::PerArea { density }, Extent::Area(extent))
            | (Amount::PerVolume { density }, Extent::Volume(extent)) => density * extent,
            _ => return Err(self.wrong_measure()),
        };
        let centre = self.shape.to_centre(self.reference.anchor()).ok_or_else(|| self.without_point())?;
        let own = MassProperties { mass, centre, inertia: self.shape.tensor(mass) };
        let there = own.turned(&self.rotation()?).moved(self.position + self.middle());
        there.check().map_err(|error| refused_part(&error, &self.name))?;
        Ok(match self.presence {
            Presence::Material => there,
            Presence::Hole => there.taken_away(),
        })
    }

    /// The middle of a rod between two points, where these are counted from the position; else nothing.
    pub(super) fn middle(&self) -> Vector3<f64> {
        match (self.shape.ends(), self.reference) {
            (Some((from, to)), ReferencePoint::Origin) => (from + to) / 2.0,
            _ => Vector3::zeros(),
        }
    }

    /// From the own axes of the shape to the frame of the body.
    ///
    /// # Errors
    /// A refusal that names the part.
    pub fn rotation(&self) -> Result<Rotation3<f64>, Refusal> {
        // What is left of terms that cancel is nothing: axes along those of the body are so exactly.
        let clean = |x: f64| {
            let whole = x.round();
            if (x - whole).abs() < 1e-15 { whole + 0.0 } else { x }
        };
        Ok(Rotation3::from_matrix_unchecked(self.direction()?.matrix().map(clean)))
    }

    fn direction(&self) -> Result<Rotation3<f64>, Refusal> {
        if let Some((from, to)) = self.shape.ends() {
            if !matches!(self.direction, ShapeOrientation::Same) {
                return Err(named(
                    "the two ends of {name} define its direction: leave that along x, y and z",
                    &self.name,
                ));
            }
            return Ok(ShapeOrientation::z_along(self.unit(to - from)?));
        }
        match &self.direction {
            ShapeOrientation::Same => Ok(Rotation3::identity()),
            ShapeOrientation::Axis { axis } => Ok(ShapeOrientation::z_along(self.unit(*axis)?)),
            ShapeOrientation::Axes { axis, side } => {
                let (z, side) = (self.unit(*axis)?, self.unit(*side)?);
                let x = side - z * z.dot(&side);
                if x.norm() < 1e-9 {
                    return Err(named(
                        "the two vectors for the axes of {name} lie along one line: give another for the own x axis",
                        &self.name,
                    ));
                }
                let x = x.normalize();
                Ok(Rotation3::from_matrix_unchecked(Matrix3::from_columns(&[x, z.cross(&x), z])))
            }
            ShapeOrientation::Turned { axis, angle } => {
                Ok(Rotation3::from_axis_angle(&Unit::new_unchecked(self.unit(*axis)?), *angle))
            }
            ShapeOrientation::Euler { precession, nutation, spin } => {
                let about = |axis, angle| Rotation3::from_axis_angle(&axis, angle);
                Ok(about(Vector3::z_axis(), *precession)
                    * about(Vector3::x_axis(), *nutation)
                    * about(Vector3::z_axis(), *spin))
            }
        }
    }

    fn unit(&self, vector: Vector3<f64>) -> Result<Vector3<f64>, Refusal> {
        // Scaled first, so that the square of a component neither overflows nor vanishes.
        let largest = vector.amax();
        if vector.iter().all(|x| x.is_finite()) && largest > 0.0 {
            Ok((vector / largest).normalize())
        } else {
            Err(named(
                "the direction of {name} has no length: write any vector along it, such as (1; 0; 0)",
                &self.name,
            ))
        }
    }

    fn misshapen(&self, error: &ShapeError) -> Refusal {
        named(
            match error {
                ShapeError::Hollow { .. } => {
                    "the inner radius of {name} is not smaller than its outer radius: write the smaller one as the inner"
                }
                ShapeError::Torus { .. } => {
                    "the section of the torus {name} is larger than its circle: make its radius smaller"
                }
            },
            &self.name,
        )
    }

    pub(super) fn wrong_measure(&self) -> Refusal {
        named(
            match self.shape.extent() {
                Extent::Point => "{name} has neither length, area nor volume: give its mass",
                Extent::Length(_) => "{name} is a line: give its mass or its mass per length",
                Extent::Area(_) => "{name} is a surface: give its mass or its mass per area",
                Extent::Volume(_) => "{name} is solid: give its mass or its density",
            },
            &self.name,
        )
    }

    pub(super) fn without_point(&self) -> Refusal {
        named(
            match self.reference {
                ReferencePoint::Corner => {
                    "{name} has no corner to be placed by: use the origin of its own axes or its centre of mass"
                }
                _ => {
                    "{name} has no ends to be placed by: use the origin of its own axes or its centre of mass"
                }
            },
            &self.name,
        )
    }
}

impl ReferencePoint {
    pub(super) fn anchor(self) -> Anchor {
        match self {
            ReferencePoint::Origin => Anchor::Origin,
            ReferencePoint::MassCentre => Anchor::MassCentre,
            ReferencePoint::NearEnd => Anchor::NearEnd,
            ReferencePoint::FarEnd => Anchor::FarEnd,
            ReferencePoint::Corner => Anchor::Corner,
        }
    }
}

impl ShapeOrientation {
    /// The shortest turn that lays z along a unit vector; half a turn about x where that is −z.
    fn z_along(axis: Vector3<f64>) -> Rotation3<f64> {
        Rotation3::rotation_between(&Vector3::z(), &axis).unwrap_or_else(|| {
            Rotation3::from_matrix_unchecked(Matrix3::from_diagonal(&Vector3::new(1.0, -1.0, -1.0)))
        })
    }
}

/// A sentence about a part, by its name.
fn named(why: &'static str, name: &str) -> Refusal {
    Refusal::NoAnswer(Text::new(why).with("name", name))
}

/// Message for numbers that are not those of a body, in the words of the form; `whose` is a sentence part such as "the
/// body".
pub(crate) fn refused(error: &BodyError, whose: &'static str) -> Refusal {
    Refusal::NoAnswer(reported(error).with_text("name", whose))
}

fn refused_part(error: &BodyError, name: &str) -> Refusal {
    Refusal::NoAnswer(reported(error).with("name", name))
}

fn reported(error: &BodyError) -> Text {
    let written = |axis: &[f64; 3]| format!("({:.3}; {:.3}; {:.3})", axis[0], axis[1], axis[2]);
    match error {
        BodyError::NotFinite => {
            Text::new("the masses or dimensions of {name} are too large for any body: check their units")
        }
        BodyError::Mass(mass) => Text::new("with its holes {name} would have a mass of {mass}: make them smaller")
            .with_quantity("mass", *mass, "kg"),
        BodyError::NotSymmetric => Text::new("the inertia matrix of {name} is not symmetric"),
        BodyError::Negative { axis, moment } => {
            Text::new("the moment of inertia of {name} about the axis {axis} through its centre of mass would be {moment}, and none is negative: check its moments, products and holes")
                .with("axis", written(axis))
                .with_quantity("moment", *moment, "kg*m^2")
        }
        BodyError::Triangle { axis, moment, others } => {
            Text::new("the moment of inertia of {name} about the principal axis {axis} would be {moment}, more than the {others} of the other two together, which violates the triangle inequality: check its moments and products")
                .with("axis", written(axis))
                .with_quantity("moment", *moment, "kg*m^2")
                .with_quantity("others", *others, "kg*m^2")
        }
        BodyError::NoInertia { axis } => {
            Text::new("{name} has no moment of inertia about the axis {axis}: nothing resists its rotation there; give it a thickness")
                .with("axis", written(axis))
        }
        BodyError::Direction => Text::new("a direction of {name} has no length: write any vector along it"),
    }
}
