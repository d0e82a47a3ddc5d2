//! The flywheel and what the engine drives.

use dalembert_core::{Inputs, Refusal, Worksheet};
use dalembert_mechanics::Real;

use super::motion::PistonState;
use crate::shared::flywheel::FlywheelInertia;

/// The flywheel and the load.
#[derive(Clone, Debug, Inputs)]
pub struct EngineLoad {
    /// Inertia of the flywheel.
    pub inertia: FlywheelInertia,
    /// Resisting load.
    pub resisting: Resisting,
}

/// Load on the engine.
#[derive(Clone, Debug, Inputs)]
pub enum Resisting {
    /// Torque
    Torque {
        /// Resisting torque.
        #[input("T_R", "N*m")]
        torque: f64,
    },
    /// Power at this speed
    Power {
        /// Power.
        #[input("P", "kW")]
        power: f64,
    },
}

/// The angular acceleration of the flywheel at the crank angle. `works` is the turning moment by the virtual works of all
/// loads, and the size of what it is added up from.
pub(super) fn acceleration<W: Worksheet>(
    given: &EngineLoadGiven<W>,
    moving: &PistonState<W::Num>,
    moment: W::Num,
    works: Option<[f64; 2]>,
    sheet: W,
) -> Result<(), Refusal> {
    let inertia = given.inertia.moment(sheet);
    let torque = match &given.resisting {
        ResistingGiven::Torque { torque } => *torque,
        ResistingGiven::Power { power } => {
            let Some(speed) = moving.speed else {
                return Err(Refusal::because(
                    "a power determines the resisting torque only for a running engine: give the torque, or the speed",
                ));
            };
            sheet.step("T_R", "N*m", *power / speed, "Torque that absorbs the power at this speed")
        }
    };
    let acceleration = sheet.step(
        "α_F",
        "rad/s^2",
        (moment - torque) / inertia,
        "Angular acceleration of the flywheel, from the excess of the turning moment over the resistance",
    );
    sheet.answer("flywheel_acceleration", "Angular acceleration of the flywheel", acceleration);
    if let Some([by_works, size]) = works {
        sheet.verify(|| {
            let what = "virtual work of all loads, of the resistance and of the inertia of the flywheel";
            let size = size.max(torque.value().abs());
            sheet.check_sum(what, inertia * acceleration + torque, by_works.into(), size);
        });
    }
    Ok(())
}
