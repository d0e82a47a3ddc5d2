//! The words, symbols and units of motion along a line and of turning.

use dalembert_core::{Text, Worksheet};
use dalembert_mechanics::sdof;

use crate::sources::RAO;

/// Type of motion of the masses: translation or rotation.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum AbsorberMotion {
    Translation,
    Torsion,
}

impl AbsorberMotion {
    fn of<T>(self, translation: T, torsion: T) -> T {
        match self {
            AbsorberMotion::Translation => translation,
            AbsorberMotion::Torsion => torsion,
        }
    }

    pub(super) fn mass_unit(self) -> &'static str {
        self.of("kg", "kg*m^2")
    }

    pub(super) fn stiffness_unit(self) -> &'static str {
        self.of("N/m", "N*m/rad")
    }

    pub(super) fn determinant_unit(self) -> &'static str {
        self.of("N^2/m^2", "N^2*m^2/rad^2")
    }

    pub(super) fn unit(self) -> &'static str {
        self.of("mm", "rad")
    }

    pub(super) fn main_mass(self) -> &'static str {
        self.of("m", "J")
    }

    pub(super) fn main_stiffness(self) -> &'static str {
        self.of("k", "k_t")
    }

    pub(super) fn absorber_mass(self) -> &'static str {
        self.of("m_a", "J_a")
    }

    pub(super) fn absorber_stiffness(self) -> &'static str {
        self.of("k_a", "k_ta")
    }

    pub(super) fn before(self) -> &'static str {
        self.of("X₀", "θ₀")
    }

    pub(super) fn main_motion(self) -> &'static str {
        self.of("X", "θ")
    }

    pub(super) fn absorber_motion(self) -> &'static str {
        self.of("X_a", "θ_a")
    }

    /// Name and label of the mass of the absorber.
    pub(super) fn absorber_mass_answer(self) -> (&'static str, &'static str) {
        self.of(("absorber_mass", "Mass of the absorber"), ("absorber_inertia", "Inertia of the absorber"))
    }

    pub(super) fn tuned_mass(self) -> &'static str {
        self.of("Mass that tunes the absorber to the speed", "Inertia that tunes the absorber to the speed")
    }

    pub(super) fn mass_of_ratio(self) -> &'static str {
        self.of(
            "Mass of the absorber, from the mass ratio",
            "Inertia of the absorber, from the ratio of the inertias",
        )
    }

    pub(super) fn ratio(self) -> Text {
        Text::from(self.of("Mass ratio: absorber over machine", "Ratio of the inertias: absorber over rotor"))
    }

    /// The stiffness behind a natural frequency.
    pub(super) fn stiffness<W: Worksheet>(self, mass: W::Num, natural: W::Num, sheet: W) -> W::Num {
        sheet.step(
            self.main_stiffness(),
            self.stiffness_unit(),
            sdof::stiffness_from_natural_frequency(mass, natural),
            ("Stiffness that gives the main system its natural frequency", RAO.at("§2.2")),
        )
    }
}
