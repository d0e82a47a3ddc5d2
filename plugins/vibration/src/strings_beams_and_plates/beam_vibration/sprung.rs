//! Masses on springs along a beam: at each frequency a mass on its spring acts as one stiffness, which changes sign where it
//! resonates on a beam at rest.

use dalembert_mechanics::beam::dynamic_stiffness::{Beam, BeamError, BeamShape, Search};

/// A mass on a spring at a station of the beam, in units of the beam.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct SprungMass {
    /// Place of its station in the list.
    pub(super) station: usize,
    /// Mass over that of the beam.
    pub(super) mass: f64,
    /// Stiffness over `EI/L³`.
    pub(super) spring: f64,
}

/// A beam with masses on springs.
pub(super) struct SprungBeam<'a> {
    pub(super) beam: &'a Beam,
    pub(super) sprung: &'a [SprungMass],
}

/// The shape of a vibration of the beam, with the displacements of the masses on springs.
pub(super) struct SprungShape {
    pub(super) shape: BeamShape,
    /// Displacement of each mass.
    pub(super) masses: Vec<f64>,
}

impl SprungMass {
    /// Force of the spring on the beam against a unit deflection: `k λ m/(λ m − k)`.
    fn stiffness(&self, lambda: f64) -> f64 {
        let inertia = lambda * self.mass;
        self.spring * inertia / (inertia - self.spring)
    }
}

impl SprungBeam<'_> {
    /// The first `count` roots `β_n` above zero, ascending.
    pub(super) fn roots(&self, count: usize) -> Result<Vec<f64>, BeamError> {
        if self.sprung.is_empty() {
            return self.beam.roots(count);
        }
        // Refuses what the beam itself refuses.
        self.beam.roots(1)?;
        let search = Search {
            count: |lambda: f64, angle: f64| self.count_below(lambda, angle),
            quotient: |beta: f64| Ok(self.quotient(&self.shape(beta)?)),
            alone: 0.05,
        };
        search.roots(self.beam.rigid_motions(), count)
    }

    /// The beam with the stiffness of the masses on springs at this `λ`.
    fn loaded(&self, lambda: f64) -> Beam {
        let mut beam = self.beam.clone();
        for sprung in self.sprung {
            beam.stations[sprung.station].spring += sprung.stiffness(lambda);
        }
        beam
    }

    /// Number of `λ` below this value, with segments of at most this angle.
    fn count_below(&self, lambda: f64, angle: f64) -> Result<usize, BeamError> {
        let own = self.sprung.iter().filter(|sprung| lambda * sprung.mass > sprung.spring).count();
        Ok(own + self.loaded(lambda).count_below(lambda, angle)?)
    }

    /// A function of β that is zero at the roots and nowhere jumps.
    pub(super) fn characteristic(&self, beta: f64) -> Result<f64, BeamError> {
        let lambda = beta.powi(4);
        let poles: f64 = self
            .sprung
            .iter()
            .map(|sprung| {
                let gap = 1.0 - lambda * sprung.mass / sprung.spring;
                gap / (1.0 + gap.abs())
            })
            .product();
        Ok(self.loaded(lambda).characteristic(beta)? * poles)
    }

    /// The shape at a root.
    pub(super) fn shape(&self, root: f64) -> Result<SprungShape, BeamError> {
        let lambda = root.powi(4);
        let shape = self.loaded(lambda).shape(root)?;
        let masses = self.sprung.iter().map(|sprung| {
            let under = shape.state(self.beam.stations[sprung.station].at).deflection;
            under * sprung.spring / (sprung.spring - lambda * sprung.mass)
        });
        let masses: Vec<f64> = masses.collect();
        Ok(SprungShape { shape, masses })
    }

    /// Rayleigh's quotient of a shape: `λ` at a root.
    pub(super) fn quotient(&self, found: &SprungShape) -> f64 {
        if self.sprung.is_empty() {
            return found.shape.rayleigh_quotient();
        }
        let SprungShape { shape, masses } = found;
        let mut kinetic = shape.inertia_product(shape);
        let mut strain = shape.rayleigh_quotient() * kinetic;
        for (sprung, moved) in self.sprung.iter().zip(masses) {
            let under = shape.state(self.beam.stations[sprung.station].at).deflection;
            // What the shape holds in place of the spring and its mass, k w (w − z).
            strain += sprung.spring * ((moved - under).powi(2) - under * (under - moved));
            kinetic += sprung.mass * moved * moved;
        }
        strain / kinetic
    }

    /// Sum of mass times displacement times displacement of two shapes.
    pub(super) fn inertia_product(&self, a: &SprungShape, b: &SprungShape) -> f64 {
        let own = self.sprung.iter().zip(a.masses.iter().zip(&b.masses));
        a.shape.inertia_product(&b.shape) + own.map(|(sprung, (x, y))| sprung.mass * x * y).sum::<f64>()
    }
}
