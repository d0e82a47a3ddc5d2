//! Common errors in moments of inertia that several analyses write down.

use dalembert_core::{Symbol, Worksheet};
use dalembert_mechanics::{Real, rigid};

/// Error with a radius of gyration.
pub(crate) const AS_DISC: &str = "the radius of gyration used as the radius of a disc, ½ m k²";

/// Declares the errors in the moment of inertia of a disc about its axis, the next step of a symbol.
pub(crate) fn of_disc<W: Worksheet>(symbol: impl Into<Symbol>, mass: W::Num, radius: W::Num, sheet: W) {
    let symbol = symbol.into();
    sheet.common_error(symbol, "the moment of inertia of the disc taken about a diameter", || {
        rigid::disc_diametral_inertia(mass, radius)
    });
    sheet.common_error(symbol, "the whole mass of the disc taken at its rim", || mass * radius.powi(2));
}
