//! The inertia of a whole body on a worksheet.

use dalembert_core::Worksheet;
use dalembert_mechanics::{Real, rigid::MassProperties};
use nalgebra::Matrix3;

use crate::{
    shared::body::matrix_times,
    sources::{BEER, RIUL},
};

/// Moments and products of inertia about G as numbers of a worksheet.
pub(crate) struct WorkedInertia<W: Worksheet> {
    moments: [W::Num; 3],
    /// I_yz, I_zx, I_xy; `None` where the product is zero.
    products: [Option<W::Num>; 3],
}

impl<W: Worksheet> WorkedInertia<W> {
    /// Brings in the tensor about G in the axes used.
    pub(crate) fn found(tensor: &Matrix3<f64>, sheet: W) -> Self {
        let largest = tensor.amax();
        let moments = MassProperties::moments(tensor);
        // What rounding leaves of a product is none.
        let products =
            MassProperties::products(tensor).map(|x| if x.abs() > 1e-14 * largest { x } else { 0.0 });
        let moment = |symbol: &'static str, si: f64| {
            sheet.numerical(
                symbol,
                "kg*m^2",
                si,
                ("Moment of inertia of the body about G", BEER.at("§18.1A")),
            )
        };
        let product = |symbol: &'static str, si: f64| {
            let why = ("Product of inertia of the body about G, such as I_xy = ∫ xy dm", BEER.at("§18.1A"));
            (si != 0.0).then(|| sheet.numerical(symbol, "kg*m^2", si, why))
        };
        Self {
            moments: [moment("Iₓ", moments.x), moment("I_y", moments.y), moment("I_z", moments.z)],
            products: [product("I_yz", products.x), product("I_zx", products.y), product("I_xy", products.z)],
        }
    }

    /// `I u`: `(Iₓ uₓ − I_xy u_y − I_zx u_z) i + …`.
    pub(crate) fn times(&self, vector: W::Vec) -> W::Vec {
        let products = self.products.map(|product| product.unwrap_or_else(|| 0.0.into()));
        matrix_times(self.moments, products, vector)
    }

    /// The largest moment, as a plain number.
    pub(crate) fn size(&self) -> f64 {
        self.moments.iter().map(|moment| moment.value().abs()).fold(0.0, f64::max)
    }

    /// Angular momentum about G, in a step.
    pub(crate) fn momentum(&self, omega: W::Vec, sheet: W) -> W::Vec {
        sheet.step_vector(
            "H_G",
            "kg*m^2/s",
            self.times(omega),
            ("Angular momentum about G", RIUL.at("eqs. 45–46")),
        )
    }
}
