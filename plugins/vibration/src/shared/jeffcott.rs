//! Support and stiffness of the shaft of an unbalanced rotor, shared by two analyses.

use dalembert_core::{Inputs, Sketch, Worksheet};
use dalembert_mechanics::{Real, beam, section};

mod speeds;

pub(crate) use self::speeds::{Whirl, pairs, permitted_speeds};
use crate::sources::{BEER, RAO};

/// Supports of the shaft, and position of the rotor.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum Mounting {
    /// Cantilever, rotor at its end
    Cantilever,
    /// Simply supported, rotor at midspan
    SimplySupported,
    /// Clamped at both ends, rotor at midspan
    Clamped,
    /// Clamped and pinned, rotor at midspan
    ClampedPinned,
}

/// The elastic shaft that a rotor sits on.
#[derive(Clone, Debug, Inputs)]
pub enum RotorShaft {
    /// Stiffness given
    Stiffness {
        /// Stiffness of the shaft at the rotor.
        #[input("k", "N/m", positive)]
        stiffness: f64,
    },
    /// Solid circular shaft
    Round {
        /// Mounting.
        mounting: Mounting,
        /// Length.
        /// Of the overhang where the rotor is at its end, of the span otherwise.
        #[input("L", "m", positive)]
        length: f64,
        /// Diameter.
        #[input("d", "m", positive)]
        diameter: f64,
        /// Young's modulus.
        #[input("E", "Pa", positive, default = "207 GPa")]
        young: f64,
    },
}

/// The stiffness `k` of a shaft at its rotor, with the steps that lead to it.
pub(crate) fn stiffness<W: Worksheet>(shaft: &RotorShaft, given: &RotorShaftGiven<W>, sheet: W) -> W::Num {
    match (shaft, given) {
        (RotorShaft::Round { mounting, .. }, RotorShaftGiven::Round { length, diameter, young, .. }) => {
            let moment = sheet.step(
                "I",
                "cm^4",
                section::round_second_moment(*diameter),
                ("Second moment of area of the shaft", BEER.at("app. A")),
            );
            let spread = || *young * moment * mounting.spread_load() / length.powi(3);
            sheet.common_error("k", "the deflection under a uniformly distributed load used", spread);
            sheet.step(
                "k",
                "MN/m",
                mounting.stiffness(*young, moment, *length),
                ("Stiffness of the shaft at the rotor", RAO.at("§1.7")),
            )
        }
        (_, RotorShaftGiven::Stiffness { stiffness }) => *stiffness,
        (RotorShaft::Stiffness { .. }, RotorShaftGiven::Round { .. }) => {
            unreachable!("what is given is made from the shaft")
        }
    }
}

/// Half the diameter of a drawn shaft.
const HALF: f64 = 0.09;

impl Mounting {
    /// Stiffness of the shaft at the rotor.
    pub(crate) fn stiffness<N: Real>(self, young: N, second_moment: N, length: N) -> N {
        match self {
            Mounting::Cantilever => beam::cantilever(young, second_moment, length),
            Mounting::SimplySupported => beam::simply_supported_middle(young, second_moment, length),
            Mounting::Clamped => beam::clamped_clamped_middle(young, second_moment, length),
            Mounting::ClampedPinned => beam::clamped_pinned_middle(young, second_moment, length),
        }
    }

    /// A load distributed uniformly over the length, over the deflection that it gives at the place of the rotor:
    /// `spread_load · EI/L³`.
    pub(crate) fn spread_load(self) -> f64 {
        match self {
            Mounting::Cantilever => 8.0,
            Mounting::SimplySupported => 384.0 / 5.0,
            Mounting::Clamped => 384.0,
            Mounting::ClampedPinned => 192.0,
        }
    }

    /// The largest bending moment of a force on the rotor.
    pub(crate) fn largest_moment<N: Real>(self, force: N, length: N) -> N {
        match self {
            Mounting::Cantilever => force * length,
            Mounting::SimplySupported => force * length / 4.0,
            Mounting::Clamped => force * length / 8.0,
            Mounting::ClampedPinned => force * length * 3.0 / 16.0,
        }
    }

    /// The largest bending stress over the deflection of the rotor: `stress_factor · E d/L²`.
    pub(crate) fn stress_factor(self) -> f64 {
        match self {
            Mounting::Cantilever => 1.5,
            Mounting::SimplySupported => 6.0,
            Mounting::Clamped => 12.0,
            Mounting::ClampedPinned => 72.0 / 7.0,
        }
    }

    /// The force of the more heavily loaded bearing.
    pub(crate) fn largest_reaction<N: Real>(self, force: N) -> N {
        match self {
            Mounting::Cantilever => force,
            Mounting::SimplySupported | Mounting::Clamped => force / 2.0,
            Mounting::ClampedPinned => force * 11.0 / 16.0,
        }
    }

    /// The shaft and what holds it, and the place of the rotor. Its diameter is drawn wider than it is.
    pub(crate) fn draw(self, sketch: &mut Sketch) -> f64 {
        let (left, right) = (-2.5, if self == Mounting::Cantilever { 1.5 } else { 2.5 });
        sketch.mass("", (left, -HALF), (right, HALF));
        match self {
            Mounting::SimplySupported => sketch.pin("", (left, -HALF)),
            _ => sketch.ground((left, 0.6), (left, -0.6)),
        };
        match self {
            Mounting::Cantilever => return 1.5,
            Mounting::Clamped => sketch.ground((right, -0.6), (right, 0.6)),
            Mounting::SimplySupported | Mounting::ClampedPinned => sketch.pin("", (right, -HALF)),
        };
        0.0
    }

    /// Dimension of the length under the shaft, and of the diameter across it.
    pub(crate) fn label(self, sketch: &mut Sketch, below: f64) {
        let right = if self == Mounting::Cantilever { 1.5 } else { 2.5 };
        sketch.dimension("L", (-2.5, -below), (right, -below), -1.0).dimension(
            "d",
            (-1.7, -HALF),
            (-1.7, HALF),
            0.0,
        );
    }
}
