//! A disc or hoop that rolls, as a user describes it.

use dalembert_core::{Inputs, Worksheet};
use dalembert_mechanics::{Real, rigid};

use crate::shared::common_errors;

/// A body of revolution that touches the floor with one circle about its centre.
#[derive(Clone, Debug, Inputs)]
pub enum Wheel {
    /// Thin disc
    Disc,
    /// Thin hoop
    Hoop,
    /// Moments of inertia given
    /// Through the centre of mass, which is the centre of the circle.
    Moments {
        /// About its axis.
        #[input("I_a", "kg*m^2", positive)]
        axial: f64,
        /// About a diameter.
        #[input("I_t", "kg*m^2", positive)]
        transverse: f64,
    },
    /// Radii of gyration given
    Radii {
        /// About its axis.
        #[input("k_a", "m", positive)]
        axial: f64,
        /// About a diameter.
        #[input("k_t", "m", positive)]
        transverse: f64,
    },
}

/// The moments of inertia `[I_a, I_t]` of a wheel; `I_a` is written down if the motion depends on it.
pub(crate) fn moments<W: Worksheet>(
    wheel: &WheelGiven<W>,
    mass: W::Num,
    radius: W::Num,
    needs_axial: bool,
    sheet: W,
) -> [W::Num; 2] {
    let reason = ["Moment of inertia about the axis", "Moment of inertia about a diameter"];
    let moments = match *wheel {
        WheelGiven::Disc {} => {
            [rigid::disc_axial_inertia(mass, radius), rigid::disc_diametral_inertia(mass, radius)]
        }
        WheelGiven::Hoop {} => [mass * radius.powi(2), mass * radius.powi(2) / 2.0],
        WheelGiven::Moments { axial, transverse } => return [axial, transverse],
        WheelGiven::Radii { axial, transverse } => [mass * axial.powi(2), mass * transverse.powi(2)],
    };
    match *wheel {
        WheelGiven::Disc {} => {
            let about_contact = || rigid::parallel_axis(moments[0], mass, radius);
            let what =
                "moment of inertia of the disc taken about a parallel axis through the point of contact";
            sheet.common_error("I_a", what, about_contact);
            common_errors::of_disc("I_a", mass, radius, sheet);
            let axial = || moments[0];
            let what = "moment of inertia of the disc about its axis taken for that about a diameter";
            sheet.common_error("I_t", what, axial);
        }
        WheelGiven::Hoop {} => {
            let about_contact = || rigid::parallel_axis(moments[0], mass, radius);
            let what =
                "moment of inertia of the hoop taken about a parallel axis through the point of contact";
            sheet.common_error("I_a", what, about_contact);
            let disc = || rigid::disc_axial_inertia(mass, radius);
            sheet.common_error("I_a", "moment of inertia of a solid disc used for the hoop", disc);
            let disc = || rigid::disc_diametral_inertia(mass, radius);
            sheet.common_error("I_t", "moment of inertia of a solid disc used for the hoop", disc);
        }
        WheelGiven::Radii { .. } => {
            sheet.common_error("I_a", common_errors::AS_DISC, || moments[0] / 2.0);
        }
        WheelGiven::Moments { .. } => {}
    }
    let axial = if needs_axial { sheet.step("I_a", "kg*m^2", moments[0], reason[0]) } else { moments[0] };
    [axial, sheet.step("I_t", "kg*m^2", moments[1], reason[1])]
}

impl Wheel {
    /// The letters of what is given of it, after the mass.
    pub fn letters(&self) -> &'static str {
        match self {
            Wheel::Disc | Wheel::Hoop => "m",
            Wheel::Moments { .. } => "m, I_a, I_t",
            Wheel::Radii { .. } => "m, k_a, k_t",
        }
    }
}
