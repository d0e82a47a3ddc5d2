//! Symbols, units and words of one degree of freedom: of a translation, or of a rotation.

/// Type of motion of the body: translation or rotation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum OscillatorMotion {
    Translation,
    Rotation,
}

impl OscillatorMotion {
    /// Chooses what belongs to this motion.
    pub(crate) fn of<T>(self, translation: T, rotation: T) -> T {
        match self {
            OscillatorMotion::Translation => translation,
            OscillatorMotion::Rotation => rotation,
        }
    }

    pub(crate) fn force_unit(self) -> &'static str {
        self.of("N", "N*m")
    }

    pub(crate) fn displacement_unit(self) -> &'static str {
        self.of("mm", "rad")
    }

    pub(crate) fn velocity_unit(self) -> &'static str {
        self.of("mm/s", "rad/s")
    }

    pub(crate) fn damping_unit(self) -> &'static str {
        self.of("N*s/m", "N*m*s/rad")
    }

    /// Symbol and unit of the stiffness.
    pub(crate) fn stiffness(self) -> (&'static str, &'static str) {
        self.of(("k", "N/m"), ("k_t", "N*m/rad"))
    }

    /// Symbol of the damping coefficient.
    pub(crate) fn damping(self) -> &'static str {
        self.of("c", "c_t")
    }

    /// Symbol of the displacement.
    pub(crate) fn displacement(self) -> &'static str {
        self.of("x", "θ")
    }

    /// Symbol of the static deflection.
    pub(crate) fn deflection(self) -> &'static str {
        self.of("δ", "θ_st")
    }
}
