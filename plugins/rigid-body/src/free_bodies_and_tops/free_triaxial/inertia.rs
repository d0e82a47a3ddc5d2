//! Principal moments of inertia of a free body.

use dalembert_core::{Refusal, Worksheet};
use dalembert_mechanics::{Real, rigid};

use super::PrincipalInertiaGiven;
use crate::shared::common_errors::AS_DISC;

/// Writes down the principal moments of inertia, kg·m².
///
/// # Errors
/// A shape whose axes are not principal ones.
pub(super) fn moments<W: Worksheet>(
    inertia: &PrincipalInertiaGiven<W>,
    sheet: W,
) -> Result<[W::Num; 3], Refusal> {
    const SYMBOLS: [&str; 3] = ["I_x", "I_y", "I_z"];
    Ok(match inertia {
        PrincipalInertiaGiven::Moments { x, y, z } => [*x, *y, *z],
        PrincipalInertiaGiven::Gyration { mass, x, y, z } => {
            let radii = [*x, *y, *z];
            std::array::from_fn(|n| {
                sheet.common_error(SYMBOLS[n], AS_DISC, || rigid::disc_axial_inertia(*mass, radii[n]));
                sheet.step(
                    SYMBOLS[n],
                    "kg*m^2",
                    rigid::moment_by_gyration(*mass, radii[n]),
                    "Principal moment of inertia from its radius of gyration",
                )
            })
        }
        PrincipalInertiaGiven::Cuboid { mass, x, y, z } => {
            let edges = [*x, *y, *z];
            std::array::from_fn(|n| {
                let [b, c] = [edges[(n + 1) % 3], edges[(n + 2) % 3]];
                sheet.common_error(
                    SYMBOLS[n],
                    "the moment of inertia taken about an edge of the body",
                    || *mass * (b.powi(2) + c.powi(2)) / 3.0,
                );
                sheet.step(
                    SYMBOLS[n],
                    "kg*m^2",
                    *mass * (b.powi(2) + c.powi(2)) / 12.0,
                    "Principal moment of inertia of a homogeneous box",
                )
            })
        }
        PrincipalInertiaGiven::Shape { mass, shape } => shape.principal_moments(*mass, sheet)?,
    })
}
