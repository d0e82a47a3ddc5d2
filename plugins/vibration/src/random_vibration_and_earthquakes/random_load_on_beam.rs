//! A uniform beam under a random load: root mean squares at a point, by its modes.

use std::f64::consts::PI;

use dalembert_core::{About, Analysis, Exhibit, Inputs, Refusal, Text, Worksheet, register};
use dalembert_mechanics::{
    Real,
    beam::dynamic_stiffness::{Beam, BeamError, BeamShape, BeamStation},
    vibration::random::{self, Resonance},
};
use dalembert_numerics::gauss_legendre;

mod mean_square;
mod pictures;
mod responses;

use self::responses::{LoadedBeam, LoadedMode};
use crate::{
    shared::{
        continuous::{LineMass, line_mass},
        section::{Profile, ProfileGiven, RoundSectionGiven, profile},
        spectral_density::{
            AccelerationDensity, AccelerationDensityGiven, ForceDensity, ForceDensityGiven, LineLoadDensity,
            LineLoadDensityGiven, Spectrum, UncorrelatedDensity, UncorrelatedDensityGiven,
        },
        support::{Restraint, Support},
    },
    sources::{CLOUGH, RAO},
};

/// The beam, its damping, its load and the place at which its response is found.
#[derive(Clone, Debug, Inputs)]
pub struct RandomLoadOnBeam {
    /// Length.
    #[input("L", "m", positive)]
    pub length: f64,
    /// Section.
    pub section: Profile,
    /// Young's modulus.
    #[input("E", "Pa", positive)]
    pub young: f64,
    /// Mass of the beam.
    pub mass: LineMass,
    /// Left end.
    pub left: Support,
    /// Right end.
    pub right: Support,
    /// Damping.
    pub damping: BeamDamping,
    /// Load.
    /// Stationary, Gaussian, zero mean.
    pub load: RandomBeamLoad,
    /// Place of the response.
    /// Distance from the left end.
    #[input("x", "m", nonnegative)]
    pub place: f64,
    /// Distance of the extreme fibre.
    /// From the neutral axis, for the bending stress. Omitted: half the depth of the section.
    #[input("c_f", "m", positive)]
    pub fibre: Option<f64>,
    /// Number of modes.
    #[input(min = 1, max = 20, default = "5")]
    pub modes: usize,
}

/// Damping of the beam.
#[derive(Clone, Debug, Inputs)]
pub enum BeamDamping {
    /// Damping ratio of every mode
    Ratio {
        /// Damping ratio.
        #[input("ζ", "1", nonnegative, default = "0.02")]
        ratio: f64,
    },
    /// Viscous damping along the beam
    Viscous {
        /// Damping coefficient per unit length.
        #[input("c̄", "N*s/m^2", nonnegative)]
        coefficient: f64,
    },
}

/// Load on the beam.
#[derive(Clone, Debug, Inputs)]
pub enum RandomBeamLoad {
    /// Force at a point
    Point {
        /// Distance from the left end.
        #[input("a", "m", nonnegative)]
        distance: f64,
        /// Power spectral density of the force.
        density: ForceDensity,
    },
    /// Uniform load
    /// The same at every point of the beam at the same time.
    Uniform {
        /// Power spectral density of the load per unit length.
        density: LineLoadDensity,
    },
    /// Distributed load without correlation between points
    /// Rain on the roof.
    Uncorrelated {
        /// Power spectral density of the force per unit length.
        /// That of the force on a length of the beam, over this length.
        density: UncorrelatedDensity,
    },
    /// Acceleration of the supports
    /// Both have the same motion; the responses are relative to it.
    Supports {
        /// Power spectral density of the acceleration.
        density: AccelerationDensity,
    },
}

register!(RandomLoadOnBeam);

impl Analysis for RandomLoadOnBeam {
    const ABOUT: About = About {
        id: "vibration/random-load-on-beam",
        title: "Random load on a beam",
        topic: "Random vibration and earthquakes",
        summary: "Root mean square of displacement, velocity, bending moment and bending stress at a point of a beam under a random force, distributed load or motion of its supports, by modal superposition.",
        main: &["displacement", "stress", "bending_moment"],
        keywords: "psd random vibration continuous beam white noise rain on the roof rms bending stress modal joint \
                   acceptance cross terms vibração aleatória viga ruído branco chuva no telhado valor eficaz tensão de \
                   flexão densidade espectral",
        sources: &[&RAO, &CLOUGH],
        cases: include_str!("../../cases/random_load_on_beam.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &RandomLoadOnBeamGiven<W>, sheet: W) -> Result<(), Refusal> {
        let place = self.fraction(self.place)?;
        let (area, second_moment) = profile(&given.section, 0, sheet)?;
        let line = line_mass(&given.mass, 0, area, sheet);
        let bending = sheet.step("EI", "N*m^2", given.young * second_moment, "Bending stiffness");
        let unit = sheet.step(
            "Ω",
            "rad/s",
            (bending / (line * given.length.powi(4))).sqrt(),
            ("The frequencies are multiples of √(EI/(m̄L⁴))", RAO.at("§8.5")),
        );
        let (spectrum, level) = self.excitation(given, sheet)?;
        let beam = self.beam(bending.value());
        if beam.rigid_motions() > 0 {
            return Err(Refusal::because(
                "the beam can move as a rigid body, and a random load moves it away without bound: add supports",
            ));
        }
        let roots = beam.roots(self.modes).map_err(refusal)?;
        let whole = Uniform { line, bending, unit, length: given.length, level };
        let mut modes = Vec::new();
        for (n, root) in (1..).zip(roots) {
            sheet.keep_going()?;
            let shape = beam.shape(root).map_err(refusal)?;
            modes.push(self.mode(given, (n, root), shape, &whole, sheet)?);
        }
        let largest = modes.iter().fold(0.0, |most: f64, mode| most.max(mode.factor.abs()));
        if largest < 1e-9 {
            return Err(Refusal::because(
                "the load does not excite these modes: place the force between the supports, or count more modes",
            ));
        }
        if !modes.iter().any(|mode| spectrum.reaches(mode.resonance.natural)) {
            sheet.warn(|| {
                Text::new(
                    "no natural frequency counted is inside the band of the load: no resonance is excited",
                )
            });
        }
        let loaded = LoadedBeam {
            modes: modes.into_iter().map(|mode| mode.at(place)).collect(),
            place,
            spectrum,
            coherent: !matches!(self.load, RandomBeamLoad::Uncorrelated { .. }),
            at_points: matches!(
                self.load,
                RandomBeamLoad::Point { .. } | RandomBeamLoad::Uncorrelated { .. }
            ),
            viscous: matches!(self.damping, BeamDamping::Viscous { .. }),
            unit_moment: bending / given.length.powi(2),
        };
        let moment = loaded.answers(sheet)?;
        if let (Some(moment), Some(fibre)) = (moment, half_depth(given)) {
            let why = "Root mean square of the bending stress at the extreme fibre";
            let stress = sheet.step("σ_b", "MPa", moment * fibre / second_moment, why);
            sheet.answer("stress", "Root mean square of the bending stress", stress);
            sheet.verify(|| {
                if let Some(square) = loaded.second_curvature() {
                    // Over the square of the length, the modal coordinates are curvatures.
                    let curvature = given.length * (square.sqrt() / self.length) / given.length.powi(2);
                    let what = "bending stress by the root mean square of the curvature, E c κ";
                    sheet.check(what, given.young * fibre * curvature, stress);
                }
            });
        }
        sheet.show(|| Exhibit::Drawing(self.drawing()));
        sheet.show(|| Exhibit::Plot(loaded.density_plot()));
        sheet.show(|| Exhibit::Plot(loaded.displacement_plot(self.length)));
        if loaded.bounded() {
            sheet.show(|| Exhibit::Plot(loaded.moment_plot(self.length)));
        }
        Ok(())
    }
}

/// The uniform beam and the level of a white load.
struct Uniform<N> {
    line: N,
    bending: N,
    unit: N,
    length: N,
    level: Option<N>,
}

impl RandomLoadOnBeam {
    /// A place over the length.
    fn fraction(&self, place: f64) -> Result<f64, Refusal> {
        let fraction = place / self.length;
        if fraction > 1.0 + 1e-9 {
            return Err(Refusal::because(
                "a place lies beyond the right end of the beam: write a distance not greater than its length",
            ));
        }
        Ok(fraction.min(1.0))
    }

    fn beam(&self, bending: f64) -> Beam {
        let end = |at: f64, support: &Support| {
            let Restraint { held, clamped, spring, turning_spring } = support.restraint(self.length, bending);
            BeamStation { at, held, clamped, spring, turning_spring, ..BeamStation::default() }
        };
        let stations = vec![end(0.0, &self.left), end(1.0, &self.right)];
        Beam { shear: 0.0, rotary: 0.0, axial: 0.0, foundation: 0.0, stations }
    }

    /// The density of the load, and the level of a white one.
    fn excitation<W: Worksheet>(
        &self,
        given: &RandomLoadOnBeamGiven<W>,
        sheet: W,
    ) -> Result<(Spectrum, Option<W::Num>), Refusal> {
        let spectrum = match &self.load {
            RandomBeamLoad::Point { density, .. } => density.spectrum(),
            RandomBeamLoad::Uniform { density } => density.spectrum(),
            RandomBeamLoad::Uncorrelated { density } => density.spectrum(),
            RandomBeamLoad::Supports { density } => density.spectrum(),
        }?;
        let white = match &given.load {
            RandomBeamLoadGiven::Point { density: ForceDensityGiven::White { level }, .. } => {
                Some(("N^2*s/rad", *level))
            }
            RandomBeamLoadGiven::Uniform { density: LineLoadDensityGiven::White { level } } => {
                Some(("N^2*s/m^2/rad", *level))
            }
            RandomBeamLoadGiven::Uncorrelated { density: UncorrelatedDensityGiven::White { level } } => {
                Some(("N^2*s/m/rad", *level))
            }
            RandomBeamLoadGiven::Supports { density: AccelerationDensityGiven::White { level } } => {
                Some(("m^2/s^3/rad", *level))
            }
            _ => None,
        };
        let level = white
            .map(|(unit, level)| sheet.step("S₀", unit, level, "The density per rad/s: 1 Hz is 2π rad/s"));
        Ok((spectrum, level))
    }

    /// The frequency, damping, mass and load of a mode.
    fn mode<W: Worksheet>(
        &self,
        given: &RandomLoadOnBeamGiven<W>,
        (n, root): (usize, f64),
        shape: BeamShape,
        whole: &Uniform<W::Num>,
        sheet: W,
    ) -> Result<ExcitedMode<W::Num>, Refusal> {
        let why = ("Root of the frequency equation of the beam on its supports", RAO.at("§8.5"));
        let beta = sheet.numerical(("β", n), "1", root, why);
        let text = Text::new("Natural frequency {n}").with("n", n);
        let half_waves = || W::Num::from((n as f64 * PI).powi(2)) * whole.unit;
        sheet.common_error(("ω", n), "the frequencies of a simply supported beam used", half_waves);
        let natural = sheet.step(("ω", n), "rad/s", beta.powi(2) * whole.unit, text);
        let frequency = sheet.step(("f_n", n), "Hz", natural, "In cycles per second");
        sheet.answer(("frequency", n), "Natural frequency", frequency);
        sheet.verify(|| {
            sheet.check(
                Text::new("mode shape {n}: strain energy over kinetic energy is ω²").with("n", n),
                whole.bending / (whole.line * whole.length.powi(4)) * shape.rayleigh_quotient(),
                natural.powi(2),
            );
        });
        let ratio = match given.damping {
            BeamDampingGiven::Ratio { ratio } => ratio,
            BeamDampingGiven::Viscous { coefficient } => {
                let why = ("Damping ratio of the mode: c̄/(2m̄ωₙ)", CLOUGH.at("§19-4"));
                sheet.step(("ζ", n), "1", coefficient / (whole.line * natural * 2.0), why)
            }
        };
        if ratio.value() == 0.0 {
            return Err(Refusal::because(
                "without damping a random excitation makes the motion grow without bound, as √t: give a damping ratio",
            ));
        }
        let why = "Mean square of the mode shape along the beam, its largest deflection one";
        let mean = sheet.numerical(("μ", n), "1", shape.inertia_product(&shape), why);
        let why = ("Modal mass", CLOUGH.at("§19-3"));
        let mass = sheet.step(("M", n), "kg", whole.line * whole.length * mean, why);
        let resonance = Resonance { natural: natural.value(), ratio: ratio.value() };
        let load = self.participation(given, n, &shape, whole, mass, sheet)?;
        let coordinate = |square: W::Num| {
            // A load without correlation has no sign.
            load.per_mass
                .map_or_else(|| (square / (whole.line * mass)).sqrt(), |factor| square.sqrt() * factor)
        };
        let white = whole.level.map(|level| {
            let why = (
                "Root mean square of the modal coordinate under white noise, with the sign of the load on the mode",
                RAO.at("ch. 14"),
            );
            let value = coordinate(random::white_displacement(level, natural, ratio));
            sheet.step(("q", n), "mm", value, why)
        });
        Ok(ExcitedMode {
            n,
            natural,
            resonance,
            shape,
            factor: load.factor,
            amplitude: load.amplitude,
            white,
        })
    }

    /// The load on a mode over its mass.
    fn participation<W: Worksheet>(
        &self,
        given: &RandomLoadOnBeamGiven<W>,
        n: usize,
        shape: &BeamShape,
        whole: &Uniform<W::Num>,
        mass: W::Num,
        sheet: W,
    ) -> Result<Participation<W::Num>, Refusal> {
        let (symbol, why) = (("p", n), "Force on the mode over its mass, for a load of one");
        let mean = || {
            let parts = 8 + 2 * n;
            let mean = gauss_legendre::integral(parts, |xi| shape.state(xi).deflection);
            let why = "Mean of the mode shape along the beam";
            let value = sheet.numerical(("Γ", n), "1", mean, why);
            sheet.verify(|| {
                // Momentum of the whole beam: its inertia is carried by the shear forces at its ends.
                let (left, right) = (shape.state(0.0).force, shape.state(1.0).force);
                let by_ends = (left - right) / shape.rayleigh_quotient();
                let what = Text::new("mean of mode shape {n} by the shear forces at its ends").with("n", n);
                sheet.check_sum(what, value, by_ends.into(), 1.0);
            });
            value
        };
        let (factor, per_mass) = match given.load {
            RandomBeamLoadGiven::Uncorrelated { .. } => {
                let amplitude = (whole.line * mass).value().sqrt().recip();
                return Ok(Participation { factor: 1.0, amplitude, per_mass: None });
            }
            RandomBeamLoadGiven::Point { .. } => {
                let RandomBeamLoad::Point { distance, .. } = self.load else {
                    unreachable!("what is given is made from the load")
                };
                let here = shape.state(self.fraction(distance)?).deflection;
                let here = sheet.numerical(("φ_a", n), "1", here, "Mode shape at the force");
                (here, sheet.step(symbol, "1/kg", here / mass, why))
            }
            RandomBeamLoadGiven::Uniform { .. } => {
                let mean = mean();
                (mean, sheet.step(symbol, "m/kg", mean * whole.length / mass, why))
            }
            RandomBeamLoadGiven::Supports { .. } => {
                let mean = mean();
                let why = "Inertia force on the mode over its mass, for an acceleration of one";
                (mean, sheet.step(symbol, "1", mean * whole.line * whole.length / mass, why))
            }
        };
        Ok(Participation { factor: factor.value(), amplitude: per_mass.value(), per_mass: Some(per_mass) })
    }
}

/// Effect of a load on a mode.
struct Participation<N> {
    /// Without dimension: zero where the mode is not excited.
    factor: f64,
    /// Force on the mode over its mass for a load of one.
    amplitude: f64,
    /// The same with its sign in the working; none where the load has no correlation.
    per_mass: Option<N>,
}

/// A mode under its load.
struct ExcitedMode<N> {
    n: usize,
    natural: N,
    resonance: Resonance,
    shape: BeamShape,
    factor: f64,
    amplitude: f64,
    /// Root mean square of the modal coordinate under white noise.
    white: Option<N>,
}

impl<N> ExcitedMode<N> {
    /// The mode with its values at the place of the response.
    fn at(self, place: f64) -> LoadedMode<N> {
        let state = self.shape.state(place);
        LoadedMode {
            n: self.n,
            natural: self.natural,
            resonance: self.resonance,
            amplitude: self.amplitude,
            white: self.white,
            deflection: state.deflection,
            curvature: state.moment,
            shape: self.shape,
        }
    }
}

/// The distance of the extreme fibre, where it is known.
fn half_depth<W: Worksheet>(given: &RandomLoadOnBeamGiven<W>) -> Option<W::Num> {
    if let Some(fibre) = given.fibre {
        return Some(fibre);
    }
    match given.section {
        ProfileGiven::Given { .. } => None,
        ProfileGiven::Round(
            RoundSectionGiven::Round { diameter: depth } | RoundSectionGiven::Tube { outer: depth, .. },
        )
        | ProfileGiven::Rectangle { height: depth, .. } => Some(depth / 2.0),
    }
}

fn refusal(err: BeamError) -> Refusal {
    Refusal::because(match err {
        BeamError::TooSlender(_) => {
            "the beam is so slender that its bending cannot be resolved: count fewer modes"
        }
        _ => {
            "the frequencies cannot be found: the springs at the ends differ too much from the stiffness of the beam"
        }
    })
}
