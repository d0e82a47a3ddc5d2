//! Moments of inertia of a body of one shape, in axes through its centre of mass.

use dalembert_core::{Refusal, Worksheet};
use dalembert_mechanics::{Real, Vector, rigid::primitive::ShapeError};

use super::{ShapeGiven, common_errors::of_moment, shape::Described, working::MOMENTS};
use crate::sources::MERIAM;

/// Below this share of the larger one, two moments of inertia differ by rounding alone.
const EQUAL: f64 = 1e-12;

impl<W: Worksheet> ShapeGiven<W> {
    /// Writes down the principal moments of inertia `[Iₓ, I_y, I_z]` of a body of this shape, kg·m², about the axes of the
    /// shape through its centre of mass.
    ///
    /// # Errors
    /// Dimensions that make no shape; a shape whose axes are not principal ones.
    pub(crate) fn principal_moments(&self, mass: W::Num, sheet: W) -> Result<[W::Num; 3], Refusal> {
        let moments = self.moments(mass)?;
        Ok([0, 1, 2].map(|n| {
            let why = (
                "Principal moment of inertia of the shape, about its axis through G",
                MERIAM.at("table D/4"),
            );
            of_moment(self.described(), n, MOMENTS[n], [mass, self.length()], sheet);
            sheet.step(MOMENTS[n], "kg*m^2", moments[n], why)
        }))
    }

    /// Writes down the moment of inertia `I_a` of a body of this shape, kg·m², about its z axis, the axis of symmetry.
    ///
    /// # Errors
    /// As [`principal_moments`](Self::principal_moments); a shape whose moments about its x and y axes differ.
    pub(crate) fn axial(&self, mass: W::Num, sheet: W) -> Result<W::Num, Refusal> {
        let [x, y, z] = self.moments(mass)?;
        if (x.value() - y.value()).abs() > EQUAL * x.value().max(y.value()) {
            return Err(Refusal::because(
                "the moments of inertia of this shape about its x and y axes differ, so its z axis is no axis of symmetry: use a shape of revolution about z",
            ));
        }
        of_moment(self.described(), 2, "I_a", [mass, self.length()], sheet);
        let why = "Moment of inertia of the shape about its axis of symmetry";
        Ok(sheet.step("I_a", "kg*m^2", z, (why, MERIAM.at("table D/4"))))
    }

    /// Writes down the moment of inertia of a body of this shape, kg·m², about any axis through its centre of mass at right
    /// angles to its z axis, in a step of that symbol.
    ///
    /// # Errors
    /// As [`principal_moments`](Self::principal_moments).
    pub(crate) fn transverse(&self, mass: W::Num, symbol: &'static str, sheet: W) -> Result<W::Num, Refusal> {
        let [transverse, ..] = self.moments(mass)?;
        of_moment(self.described(), 0, symbol, [mass, self.length()], sheet);
        let why = "Moment of inertia of the shape about a transverse axis through G";
        Ok(sheet.step(symbol, "kg*m^2", transverse, (why, MERIAM.at("table D/4"))))
    }

    /// Writes down both moments of inertia: [`axial`](Self::axial), and [`transverse`](Self::transverse) in a step of that
    /// symbol.
    ///
    /// # Errors
    /// As [`axial`](Self::axial).
    pub(crate) fn axial_and_transverse(
        &self,
        mass: W::Num,
        symbol: &'static str,
        sheet: W,
    ) -> Result<[W::Num; 2], Refusal> {
        Ok([self.axial(mass, sheet)?, self.transverse(mass, symbol, sheet)?])
    }

    fn moments(&self, mass: W::Num) -> Result<[W::Num; 3], Refusal> {
        let shape = self.described();
        if let Described::Primitive(shape) = shape {
            shape.check().map_err(|error| {
                Refusal::because(match error {
                    ShapeError::Hollow { .. } => {
                        "the inner radius is not smaller than the outer radius: write the smaller one as the inner"
                    }
                    ShapeError::Torus { .. } => {
                        "the section of the torus is larger than its circle: make its radius smaller"
                    }
                })
            })?;
        }
        let inertia = shape.inertia(mass, self.length());
        if inertia.products.is_some_and(|products| products.iter().any(|product| product.value() != 0.0)) {
            return Err(Refusal::because(
                "the axes of this shape are not principal axes of inertia: calculate them by rigid-body/mass-properties",
            ));
        }
        Ok(inertia.moments)
    }

    /// The length of a rod between two points; else zero.
    fn length(&self) -> W::Num {
        match self.described() {
            Described::Between(from, to) => (to - from).magnitude(),
            _ => 0.0.into(),
        }
    }
}
