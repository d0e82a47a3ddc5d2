//! Masses, and moments of inertia of discs, rotors and bodies of known shape, as one number.

use dalembert_core::{Inputs, Refusal, Symbol, Worksheet};
use dalembert_mechanics::Real;

use crate::sources::RAO;

/// Mass, given directly or by the weight.
#[derive(Clone, Debug, Inputs)]
pub enum Mass {
    /// Mass given
    Mass {
        /// Mass.
        #[input("m", "kg", positive)]
        mass: f64,
    },
    /// Weight given
    Weight {
        /// Weight.
        #[input("W", "N", positive)]
        weight: f64,
        /// Gravity.
        #[input("g", "m/s^2", positive, default = "9.81 m/s^2", default_before = "9.80665 m/s^2")]
        gravity: f64,
    },
}

/// Body that moves along a line.
#[derive(Clone, Debug, Inputs)]
pub enum TranslatingBody {
    /// Mass or weight
    #[input(flatten)]
    Mass(Mass),
    /// Body that rolls without slipping
    /// Springs, dampers and forces act at its centre.
    Rolling {
        /// Mass or weight.
        mass: Mass,
        /// Shape.
        shape: RollingShape,
        /// Radius.
        /// Required only if the moment of inertia is given.
        #[input("r", "m", positive)]
        radius: Option<f64>,
    },
}

/// The shape of a rolling body.
#[derive(Clone, Debug, Inputs)]
pub enum RollingShape {
    /// Solid cylinder or disc
    Cylinder,
    /// Thin ring or tube
    Ring,
    /// Solid sphere
    Sphere,
    /// Moment of inertia given
    Given {
        /// Moment of inertia about the centre.
        #[input("J_G", "kg*m^2", positive)]
        inertia: f64,
    },
}

/// The moment of inertia of a rotor about its axis.
#[derive(Clone, Debug, Inputs)]
pub enum RotorInertia {
    /// Moment of inertia given
    Given {
        /// Moment of inertia.
        /// About the axis of rotation.
        #[input("J", "kg*m^2", positive)]
        inertia: f64,
    },
    /// Mass and radius of gyration
    Gyration {
        /// Mass.
        #[input("m", "kg", positive)]
        mass: f64,
        /// Radius of gyration.
        #[input("κ", "m", positive)]
        radius: f64,
    },
    /// Weight times the square of the radius of gyration
    WeightMoment {
        /// Weight times the square of the radius of gyration.
        /// W R² of older books, with the weight as a force: lbf·ft².
        #[input("WR²", "N*m^2", positive)]
        weight_moment: f64,
        /// Gravity.
        #[input("g", "m/s^2", positive, default = "9.81 m/s^2")]
        gravity: f64,
    },
    /// Solid disc
    Disc {
        /// Mass.
        #[input("m", "kg", positive)]
        mass: f64,
        /// Diameter.
        #[input("D", "m", positive)]
        diameter: f64,
    },
}

/// The moment of inertia of a body about its axis of rotation.
#[derive(Clone, Debug, Inputs)]
pub enum Inertia {
    /// Of a rotor
    #[input(flatten)]
    Rotor(RotorInertia),
    /// Ring
    /// All of its mass at one radius.
    Ring {
        /// Mass.
        #[input("m", "kg", positive)]
        mass: f64,
        /// Mean diameter.
        #[input("D", "m", positive)]
        diameter: f64,
    },
    /// Rod, plate, sphere, cylinder
    /// About its centre of mass, or about a parallel axis.
    Shape {
        /// Mass or weight.
        mass: Mass,
        /// Shape.
        #[input("b")]
        shape: BodyShape,
        /// Distance from the axis to the centre.
        /// Omitted for an axis through the centre of mass; half the length for the end of a rod.
        #[input("d", "m", positive)]
        distance: Option<f64>,
    },
}

/// Shape of a body, and direction of the axis in it.
#[derive(Clone, Debug, Inputs)]
pub enum BodyShape {
    /// Slender rod, axis across it
    Rod {
        /// Length.
        #[input("L", "m", positive)]
        length: f64,
    },
    /// Rectangular plate, axis normal to it
    Plate {
        /// Length.
        #[input("a", "m", positive)]
        length: f64,
        /// Width.
        #[input("b", "m", positive)]
        width: f64,
    },
    /// Disc or solid cylinder, its own axis
    Disc {
        /// Diameter.
        #[input("D", "m", positive)]
        diameter: f64,
    },
    /// Thin ring, axis normal to it
    Ring {
        /// Mean diameter.
        #[input("D", "m", positive)]
        diameter: f64,
    },
    /// Solid cylinder, axis across it
    Cylinder {
        /// Diameter.
        #[input("D", "m", positive)]
        diameter: f64,
        /// Length.
        #[input("L", "m", positive)]
        length: f64,
    },
    /// Solid sphere
    Sphere {
        /// Diameter.
        #[input("D", "m", positive)]
        diameter: f64,
    },
    /// Radius of gyration given
    Gyration {
        /// Radius of gyration.
        /// About the axis through the centre of mass.
        #[input("κ_G", "m", positive)]
        radius: f64,
    },
}

/// The mass, kg.
pub(crate) fn mass<W: Worksheet>(given: &MassGiven<W>, sheet: W) -> W::Num {
    match given {
        MassGiven::Mass { mass } => *mass,
        MassGiven::Weight { weight, gravity } => {
            sheet.step("m", "kg", *weight / *gravity, "Mass of this weight")
        }
    }
}

/// The weight, where it is given and is that under this gravity. With two values of gravity in one problem it is not.
pub(crate) fn given_weight<W: Worksheet>(given: &MassGiven<W>, gravity: W::Num) -> Option<W::Num> {
    match given {
        MassGiven::Weight { weight, gravity: weighed } if weighed.value() == gravity.value() => Some(*weight),
        _ => None,
    }
}

impl<W: Worksheet> RollingShapeGiven<W> {
    /// The moment of inertia about the centre, kg·m², written as `J_G` where it is not given.
    pub(crate) fn about_centre(&self, [mass, radius]: [W::Num; 2], sheet: W) -> W::Num {
        let square = mass * radius.powi(2);
        let (inertia, why) = match self {
            RollingShapeGiven::Cylinder {} => {
                (square / 2.0, "Moment of inertia of a solid cylinder about its centre")
            }
            RollingShapeGiven::Ring {} => (square, "Moment of inertia of a thin ring about its centre"),
            RollingShapeGiven::Sphere {} => {
                (square * 0.4, "Moment of inertia of a solid sphere about its centre")
            }
            RollingShapeGiven::Given { inertia } => return *inertia,
        };
        let contact = || inertia + square;
        sheet.common_error("J_G", "the moment of inertia about the point of contact taken", contact);
        sheet.step("J_G", "kg*m^2", inertia, why)
    }
}

impl<W: Worksheet> TranslatingBodyGiven<W> {
    /// The mass that moves along the line, kg; of a rolling body, with what its rotation adds.
    ///
    /// # Errors
    /// A moment of inertia without the radius.
    pub(crate) fn mass(&self, sheet: W) -> Result<W::Num, Refusal> {
        let (body, shape, radius) = match self {
            TranslatingBodyGiven::Mass(body) => return Ok(mass(body, sheet)),
            TranslatingBodyGiven::Rolling { mass, shape, radius } => (mass, shape, radius),
        };
        let own = mass(body, sheet);
        let equivalent = match (shape, radius) {
            (RollingShapeGiven::Cylinder {}, _) => own * 1.5,
            (RollingShapeGiven::Ring {}, _) => own * 2.0,
            (RollingShapeGiven::Sphere {}, _) => own * 1.4,
            (RollingShapeGiven::Given { inertia }, Some(radius)) => own + *inertia / radius.powi(2),
            (RollingShapeGiven::Given { .. }, None) => {
                return Err(Refusal::because(
                    "what the moment of inertia adds to the mass of a rolling body depends on its radius: write the radius",
                ));
            }
        };
        let why = (
            "Equivalent mass of the body that rolls, m + J_G/r²: its kinetic energy over half the square of its velocity",
            RAO.at("§1.8"),
        );
        sheet.common_error("m_eq", "the kinetic energy of the rotation neglected", || own);
        let contact = || equivalent + own;
        let what = "the translation added to the rotation about the point of contact";
        sheet.common_error("m_eq", what, contact);
        let equivalent = sheet.step("m_eq", "kg", equivalent, why);
        sheet.verify(|| {
            // About the point of contact, of a body with a radius of one.
            let (share, radius) = match (shape, radius) {
                (RollingShapeGiven::Cylinder {}, _) => (0.5, 1.0),
                (RollingShapeGiven::Ring {}, _) => (1.0, 1.0),
                (RollingShapeGiven::Sphere {}, _) => (0.4, 1.0),
                (RollingShapeGiven::Given { inertia }, radius) => {
                    let radius = radius.map_or(1.0, Real::value);
                    (inertia.value() / own.value() / (radius * radius), radius)
                }
            };
            let about = own.value() * radius * radius * (1.0 + share);
            sheet.check(
                "equivalent mass by the moment of inertia about the point of contact, J_C/r²",
                W::Num::from(about / (radius * radius)),
                equivalent,
            );
        });
        Ok(equivalent)
    }
}

impl<W: Worksheet> BodyShapeGiven<W> {
    /// The square of the radius of gyration about the centre, m², and whose moment of inertia it gives.
    fn square(&self) -> (W::Num, &'static str) {
        match *self {
            BodyShapeGiven::Rod { length } => {
                (length.powi(2) / 12.0, "Moment of inertia of a slender rod about its centre")
            }
            BodyShapeGiven::Plate { length, width } => (
                (length.powi(2) + width.powi(2)) / 12.0,
                "Moment of inertia of a rectangular plate about the normal through its centre",
            ),
            BodyShapeGiven::Disc { diameter } => {
                (diameter.powi(2) / 8.0, "Moment of inertia of a solid disc about its axis")
            }
            BodyShapeGiven::Ring { diameter } => {
                (diameter.powi(2) / 4.0, "Moment of inertia of a ring about its axis")
            }
            BodyShapeGiven::Cylinder { diameter, length } => (
                diameter.powi(2) / 16.0 + length.powi(2) / 12.0,
                "Moment of inertia of a solid cylinder about a diameter through its centre",
            ),
            BodyShapeGiven::Sphere { diameter } => {
                (diameter.powi(2) / 10.0, "Moment of inertia of a solid sphere about its centre")
            }
            BodyShapeGiven::Gyration { radius } => {
                (radius.powi(2), "Moment of inertia from the radius of gyration")
            }
        }
    }

    /// Records the common errors of the moment of inertia about the centre.
    fn errors(&self, mass: W::Num, sheet: W, symbol: Symbol) {
        let own = |what: &'static str, square: &dyn Fn() -> W::Num| {
            sheet.common_error(symbol, what, || mass * square());
        };
        match *self {
            BodyShapeGiven::Rod { length } => {
                own("the moment of inertia about the end of the rod taken", &|| length.powi(2) / 3.0);
            }
            BodyShapeGiven::Plate { length, width } => {
                let corner = || (length.powi(2) + width.powi(2)) / 3.0;
                own("the moment of inertia about a corner of the plate taken", &corner);
            }
            BodyShapeGiven::Disc { diameter } => {
                own("the moment of inertia of a ring taken for the solid disc", &|| diameter.powi(2) / 4.0);
                own("the moment of inertia about a diameter of the disc taken", &|| diameter.powi(2) / 16.0);
            }
            BodyShapeGiven::Ring { diameter } => {
                own("the moment of inertia of a solid disc taken for the ring", &|| diameter.powi(2) / 8.0);
            }
            BodyShapeGiven::Cylinder { diameter, length } => {
                own("the moment of inertia about the axis of the cylinder taken", &|| diameter.powi(2) / 8.0);
                own("the cylinder taken as a slender rod", &|| length.powi(2) / 12.0);
                let end = || diameter.powi(2) / 16.0 + length.powi(2) / 3.0;
                own("the moment of inertia about the end of the cylinder taken", &end);
            }
            BodyShapeGiven::Sphere { diameter } => {
                own("the moment of inertia of a disc taken for the sphere", &|| diameter.powi(2) / 8.0);
                own("the moment of inertia of a hollow sphere taken for the solid one", &|| {
                    diameter.powi(2) / 6.0
                });
            }
            BodyShapeGiven::Gyration { radius } => {
                own("the radius of gyration taken as the radius of a solid disc", &|| radius.powi(2) / 2.0);
            }
        }
    }
}

impl<W: Worksheet> RotorInertiaGiven<W> {
    /// The moment of inertia, kg·m², written as the step `symbol` where it is not given.
    #[inline]
    pub(crate) fn moment(&self, sheet: W, symbol: Symbol) -> W::Num {
        let (inertia, why) = match *self {
            RotorInertiaGiven::Given { inertia } => return inertia,
            RotorInertiaGiven::Gyration { mass, radius } => {
                let disc = || mass * radius.powi(2) / 2.0;
                let what = "the radius of gyration taken as the radius of a solid disc";
                sheet.common_error(symbol, what, disc);
                (mass * radius.powi(2), "Moment of inertia from the radius of gyration")
            }
            RotorInertiaGiven::WeightMoment { weight_moment, gravity } => {
                (weight_moment / gravity, "Moment of inertia: the weight over gravity is the mass")
            }
            RotorInertiaGiven::Disc { mass, diameter } => {
                let ring = || mass * diameter.powi(2) / 4.0;
                sheet.common_error(symbol, "the moment of inertia of a ring taken for the solid disc", ring);
                let across = || mass * diameter.powi(2) / 16.0;
                let what = "the moment of inertia about a diameter of the disc taken";
                sheet.common_error(symbol, what, across);
                (mass * diameter.powi(2) / 8.0, "Moment of inertia of a solid disc about its axis")
            }
        };
        sheet.step(symbol, "kg*m^2", inertia, why)
    }
}

/// The moment of inertia, kg·m², written as the step `symbol` where it is not given.
#[inline]
pub fn moment_of_inertia<W: Worksheet>(given: &InertiaGiven<W>, sheet: W, symbol: Symbol) -> W::Num {
    match given {
        InertiaGiven::Rotor(rotor) => rotor.moment(sheet, symbol),
        InertiaGiven::Ring { mass, diameter } => {
            let inertia = *mass * diameter.powi(2) / 4.0;
            let disc = || *mass * diameter.powi(2) / 8.0;
            sheet.common_error(symbol, "the moment of inertia of a solid disc taken for the ring", disc);
            sheet.step(symbol, "kg*m^2", inertia, "Moment of inertia of a ring about its axis")
        }
        InertiaGiven::Shape { mass: body, shape, distance } => {
            let mass = mass(body, sheet);
            let (square, centred) = shape.square();
            match distance {
                None => {
                    shape.errors(mass, sheet, symbol);
                    sheet.step(symbol, "kg*m^2", mass * square, centred)
                }
                Some(distance) => {
                    sheet.common_error(symbol, "the parallel-axis term omitted", || mass * square);
                    let point = || mass * distance.powi(2);
                    sheet.common_error(symbol, "the body taken as a point mass at its centre", point);
                    if let BodyShapeGiven::Rod { length } = *shape {
                        let twice = || mass * (length.powi(2) / 3.0 + distance.powi(2));
                        let what = "the parallel-axis term added to the moment of inertia about the end";
                        sheet.common_error(symbol, what, twice);
                    }
                    let why =
                        "Moment of inertia by the parallel-axis theorem: that about the centre, and m d²";
                    sheet.step(symbol, "kg*m^2", mass * (square + distance.powi(2)), why)
                }
            }
        }
    }
}

impl Mass {
    /// The letter of the mass, or how it follows from the weight.
    pub(crate) fn letter(&self) -> &'static str {
        match self {
            Mass::Mass { .. } => "m",
            Mass::Weight { .. } => "m = W/g",
        }
    }
}

impl TranslatingBody {
    /// The letter of the mass, or how it follows from the weight.
    pub(crate) fn letter(&self) -> &'static str {
        match self {
            TranslatingBody::Mass(mass) | TranslatingBody::Rolling { mass, .. } => mass.letter(),
        }
    }
}

impl RotorInertia {
    /// The letters of what is given.
    pub(crate) fn letters(&self) -> &'static [&'static str] {
        match self {
            RotorInertia::Given { .. } => &["J"],
            RotorInertia::Gyration { .. } => &["m", "κ"],
            RotorInertia::WeightMoment { .. } => &["WR²"],
            RotorInertia::Disc { .. } => &["m", "D"],
        }
    }
}

impl Inertia {
    /// The letters of what is given.
    pub(crate) fn letters(&self) -> &'static [&'static str] {
        match self {
            Inertia::Rotor(rotor) => rotor.letters(),
            Inertia::Ring { .. } => &["m", "D"],
            Inertia::Shape { mass, .. } => match mass {
                Mass::Mass { .. } => &["m"],
                Mass::Weight { .. } => &["W"],
            },
        }
    }
}
