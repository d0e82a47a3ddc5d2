//! The mass of the connecting rod.

use std::f64::consts::TAU;

use dalembert_core::{Inputs, Refusal, Text, Worksheet};
use dalembert_mechanics::{
    Real,
    slider_crank::{
        engine::{self, PistonFormula},
        equivalent,
    },
};

use super::motion::{Lengths, PistonState};
use crate::sources::{BEVAN, KHURMI};

/// Mass distribution of the connecting rod.
#[derive(Clone, Debug, Inputs)]
pub enum RodMass {
    /// Massless
    /// Or counted with the reciprocating mass.
    Massless,
    /// A rigid body
    Body {
        /// Mass of the rod.
        #[input("m", "kg", positive)]
        mass: f64,
        /// Position of its centre of mass.
        centre: Centre,
        /// Its moment of inertia.
        inertia: RodInertia,
    },
    /// Masses at its two pins
    Pins {
        /// Mass at the gudgeon pin.
        #[input("m_g", "kg", nonnegative)]
        gudgeon: f64,
        /// Mass at the crank pin.
        #[input("m_c", "kg", nonnegative)]
        crank_pin: f64,
    },
}

/// Position of the centre of mass.
#[derive(Clone, Debug, Inputs)]
pub enum Centre {
    /// From the crank pin
    CrankPin {
        /// Distance from the crank pin.
        #[input("c", "mm", nonnegative)]
        distance: f64,
    },
    /// From the gudgeon pin
    GudgeonPin {
        /// Distance from the gudgeon pin.
        #[input("d", "mm", nonnegative)]
        distance: f64,
    },
}

/// The moment of inertia of the rod.
#[derive(Clone, Debug, Inputs)]
pub enum RodInertia {
    /// Radius of gyration
    Gyration {
        /// Radius of gyration about the centre of mass.
        #[input("k_G", "mm", nonnegative)]
        radius: f64,
    },
    /// Moment of inertia
    Moment {
        /// Moment of inertia about the centre of mass.
        #[input("I_G", "kg*m^2", nonnegative)]
        inertia: f64,
    },
    /// Inertia of masses at the two pins
    /// The rod then needs no correction couple.
    Pins,
    /// Oscillation about a pin
    /// Of the rod alone, hung on that pin.
    Swung {
        /// Pin.
        pin: SwingPin,
        /// Period of small oscillations.
        #[input("τ", "s", positive)]
        period: f64,
    },
}

/// The pin on which a rod is hung to swing.
#[derive(Clone, Copy, Debug, Inputs)]
pub enum SwingPin {
    /// Gudgeon pin, small end
    Gudgeon,
    /// Crank pin, big end
    Crank,
}

/// The rod as masses in its pins and what they lack.
pub(super) struct Masses<N> {
    pub mass: N,
    /// Distance of the centre of mass from the crank pin.
    pub centre: N,
    pub inertia: N,
    pub at_gudgeon: N,
    pub at_pin: N,
    /// Moment of inertia that the masses in the pins lack; none where there is nothing to correct.
    pub missing: Option<N>,
}

pub(super) fn masses<W: Worksheet>(
    problem: &RodMass,
    given: &RodMassGiven<W>,
    rod: W::Num,
    gravity: W::Num,
    sheet: W,
) -> Result<Option<Masses<W::Num>>, Refusal> {
    match (problem, given) {
        (
            RodMass::Pins { gudgeon, crank_pin },
            RodMassGiven::Pins { gudgeon: at_gudgeon, crank_pin: at_pin },
        ) => {
            if gudgeon + crank_pin == 0.0 {
                return Ok(None);
            }
            let mass = sheet.step("m", "kg", *at_gudgeon + *at_pin, "Mass of the rod");
            let centre = *at_gudgeon * rod / mass;
            let centre = sheet.step("c", "mm", centre, "Distance of its centre of mass from the crank pin");
            let inertia = mass * centre * (rod - centre);
            let inertia = sheet.step("I_G", "kg*m^2", inertia, "Moment of inertia of two masses at the pins");
            Ok(Some(Masses {
                mass,
                centre,
                inertia,
                at_gudgeon: *at_gudgeon,
                at_pin: *at_pin,
                missing: None,
            }))
        }
        (_, RodMassGiven::Body { mass, centre, inertia }) => {
            let mass = *mass;
            let (centre, other) = match centre {
                CentreGiven::CrankPin { distance } => {
                    let why = "Distance of the rod's centre of mass from the gudgeon pin";
                    (*distance, sheet.step("d", "mm", rod - *distance, why))
                }
                CentreGiven::GudgeonPin { distance } => {
                    let why = "Distance of the rod's centre of mass from the crank pin";
                    (sheet.step("c", "mm", rod - *distance, why), *distance)
                }
            };
            if centre.value() < 0.0 || other.value() < 0.0 {
                return Err(Refusal::because(
                    Text::new(
                        "the centre of mass of the rod lies beyond its pins: its distance must not be above the length of the rod, {rod}",
                    )
                    .with_quantity("rod", rod.value(), "mm"),
                ));
            }
            let cite = KHURMI.at("ch. 15");
            let why = "Share of the rod's mass at the gudgeon pin, keeping the centre of mass unchanged";
            sheet.common_error("m_g", "half of the mass of the rod placed at each pin", || mass / 2.0);
            let at_gudgeon = sheet.step("m_g", "kg", equivalent::share(mass, other, centre), (why, cite));
            let why = "Share of the rod's mass at the crank pin";
            sheet.common_error("m_c", "half of the mass of the rod placed at each pin", || mass / 2.0);
            let at_pin = sheet.step("m_c", "kg", equivalent::share(mass, centre, other), (why, cite));
            let (inertia, missing) = match inertia {
                RodInertiaGiven::Gyration { radius } => {
                    let inertia = mass * radius.powi(2);
                    (sheet.step("I_G", "kg*m^2", inertia, "Moment of inertia of the rod"), true)
                }
                RodInertiaGiven::Moment { inertia } => (*inertia, true),
                RodInertiaGiven::Pins { .. } => {
                    let inertia = mass * centre * other;
                    let why = "Moment of inertia of two masses at the pins";
                    (sheet.step("I_G", "kg*m^2", inertia, why), false)
                }
                RodInertiaGiven::Swung { period, .. } => {
                    let from_crank = matches!(
                        problem,
                        RodMass::Body { inertia: RodInertia::Swung { pin: SwingPin::Crank, .. }, .. }
                    );
                    let arm = if from_crank { centre } else { other };
                    (swung(mass, arm, *period, gravity, sheet)?, true)
                }
            };
            let missing = missing.then(|| {
                sheet.step(
                    "ΔI",
                    "kg*m^2",
                    equivalent::missing_inertia_from(inertia, mass, centre, other),
                    (
                        "Moment-of-inertia deficit of the two masses; negative for an excess",
                        BEVAN.at("ch. 12"),
                    ),
                )
            });
            Ok(Some(Masses { mass, centre, inertia, at_gudgeon, at_pin, missing }))
        }
        _ => Ok(None),
    }
}

/// The moment of inertia about the centre of mass of a rod that swings about a pin at a distance from it.
fn swung<W: Worksheet>(
    mass: W::Num,
    arm: W::Num,
    period: W::Num,
    gravity: W::Num,
    sheet: W,
) -> Result<W::Num, Refusal> {
    if gravity.value() == 0.0 {
        return Err(Refusal::because(
            "without gravity no rod swings: write the acceleration of gravity at which the period was measured",
        ));
    }
    if arm.value() == 0.0 {
        return Err(Refusal::because(
            "the rod does not swing about a pin at its centre of mass: choose the other pin",
        ));
    }
    let why = "Length of the simple pendulum of this period";
    let pendulum = sheet.step("L", "mm", gravity * (period / TAU).powi(2), why);
    if pendulum.value() < arm.value() {
        return Err(Refusal::because(
            "the rod swings faster than a simple pendulum with all its mass at the centre of mass: check the period and the distance",
        ));
    }
    let why = "Moment of inertia of the rod, of which L is the length of the equivalent pendulum";
    let inertia = sheet.step("I_G", "kg*m^2", mass * arm * (pendulum - arm), why);
    sheet.answer("rod_inertia", "Moment of inertia of the rod about G", inertia);
    sheet.verify(|| {
        let about = inertia + mass * arm.powi(2);
        let found = (about / (mass * gravity * arm)).sqrt() * TAU;
        sheet.check("period of the rod as a compound pendulum", found, period);
    });
    Ok(inertia)
}

/// The inertia force of the rod, `m a_G`, from the accelerations of its ends.
pub(super) fn inertia_force<W: Worksheet>(
    rod: &Masses<W::Num>,
    lengths: &Lengths<W::Num>,
    moving: &PistonState<W::Num>,
    kernel: &engine::EngineCylinder,
    sheet: W,
) {
    let (Some(speed), Some(piston)) = (moving.speed, moving.acceleration) else { return };
    let (angle, crank) = (moving.angle, lengths.crank);
    let why = "The acceleration of the centre of mass is interpolated between those of the two pins: towards the crank";
    let part = sheet.step(
        "χ",
        "1",
        rod.centre / lengths.rod,
        "Fraction of the rod length from the crank pin to its centre of mass",
    );
    let rest = || W::Num::from(1.0) - part;
    let pin = crank * speed.powi(2);
    let (along, across) = match moving.turning {
        Some(alpha) => {
            (pin * angle.cos() + crank * alpha * angle.sin(), pin * angle.sin() - crank * alpha * angle.cos())
        }
        None => (pin * angle.cos(), pin * angle.sin()),
    };
    let along = sheet.step("a_x", "m/s^2", rest() * along + part * piston, why);
    let across =
        sheet.step("a_y", "m/s^2", rest() * across, "Transverse to the stroke, towards the line of stroke");
    let size = rod.mass * (along.powi(2) + across.powi(2)).sqrt();
    sheet.common_error("F_C", "the whole rod taken to move with the piston", || rod.mass * piston.abs());
    let force = sheet.step("F_C", "N", size, ("Inertia force of the rod", KHURMI.at("ch. 15")));
    sheet.answer("rod_inertia_force", "Inertia force of the rod", force);
    sheet.verify(|| rod_force(moving, kernel, force, sheet));
}

/// The inertia force of the rod as what its two pins exert on it, where nothing but inertia acts.
fn rod_force<W: Worksheet>(
    moving: &PistonState<W::Num>,
    rod: &engine::EngineCylinder,
    force: W::Num,
    sheet: W,
) {
    if rod.model != PistonFormula::Exact {
        return;
    }
    let crank = moving.crank();
    let inert = engine::EngineCylinder { gravity: [0.0; 2], friction: 0.0, ..rod.clone() };
    let Ok(reactions) = inert.reactions(crank, 0.0) else { return };
    let [x, y] = [0, 1].map(|axis| reactions.gudgeon_pin[axis] - reactions.crank_pin[axis]);
    let natural = rod.crank * (crank.speed.powi(2) + crank.acceleration.abs());
    let fastest = moving.acceleration.map_or(natural, |piston| piston.value().abs().max(natural));
    let size = (rod.rod_mass + rod.reciprocating) * fastest + reactions.gudgeon_pin[1].abs();
    let what = "inertia force of the rod as the force exerted by its pins, from the Newton–Euler equations";
    sheet.check_sum(what, force, x.hypot(y).into(), size);
}
