//! The largest response of a structure to a shaking base, from a response spectrum and the modes.

use std::f64::consts::PI;

use dalembert_core::{
    About, Analysis, Axis, Cell, Column, Drawing, Exhibit, Inputs, Plot, Refusal, Series, Symbol,
    TableExhibit, Text, Worksheet, register,
};
use dalembert_mechanics::{
    Real,
    vibration::{
        base_modes,
        random::{Resonance, modal_moment},
    },
};

mod combination;

use self::combination::combined;
use crate::{
    shared::{
        chain::{self, ChainMass, ChainMassGiven},
        continuous::{HALF_BEAM, beam},
        section::{Section, second_moment},
    },
    sources::{BEER, BIGGS, CHOPRA, RAO},
};

/// The structure, its damping and the spectrum of what shakes it.
#[derive(Clone, Debug, Inputs)]
pub struct ResponseSpectrum {
    /// Structure.
    pub structure: Structure,
    /// Damping ratio of every mode.
    /// Required only for the complete quadratic combination; the spectrum is that of this damping.
    #[input("ζ", "1", positive, below = 1, default = "0.05")]
    pub ratio: f64,
    /// Response spectrum of the motion of the base.
    pub spectrum: Demand,
}

/// Structure on the base.
#[derive(Clone, Debug, Inputs)]
pub enum Structure {
    /// Chain of masses
    Chain {
        /// Masses and springs.
        /// Starting from the base.
        #[input(min = 1)]
        links: Vec<ChainMass>,
    },
    /// Modes given
    Modes {
        /// Modes.
        #[input(min = 1)]
        modes: Vec<GivenMode>,
    },
    /// Simply supported beam, both supports with the same motion
    Beam {
        /// Span.
        #[input("L", "m", positive)]
        length: f64,
        /// Young's modulus.
        #[input("E", "Pa", positive)]
        young: f64,
        /// Section.
        section: Section,
        /// Mass per unit length.
        #[input("m̄", "kg/m", positive)]
        linear_mass: f64,
        /// Distance of the extreme fibre.
        /// From the neutral axis.
        #[input("c", "m", positive)]
        fibre: f64,
        /// Number of modes.
        /// Only the symmetric ones, 1, 3, 5 …, respond when both supports have the same motion.
        #[input(min = 1, max = 6)]
        modes: usize,
    },
}

/// A mode as a user knows it.
#[derive(Clone, Debug, Inputs)]
pub struct GivenMode {
    /// Natural frequency.
    #[input("f", "Hz", positive)]
    pub frequency: f64,
    /// Modal contribution at the observation point.
    /// Participation factor times mode shape, Γφ: the shares of all modes make one.
    #[input("Γφ", "1")]
    pub share: f64,
}

/// The largest response of one degree of freedom to the motion of the base, over its natural frequency.
#[derive(Clone, Debug, Inputs)]
pub enum Demand {
    /// The same displacement at every frequency
    Displacement {
        /// Spectral displacement.
        #[input("S_d", "m", positive)]
        displacement: f64,
    },
    /// The same pseudo-velocity at every frequency
    Velocity {
        /// Spectral pseudo-velocity.
        #[input("S_v", "m/s", positive)]
        velocity: f64,
    },
    /// The same pseudo-acceleration at every frequency
    Acceleration {
        /// Spectral pseudo-acceleration.
        #[input("S_a", "m/s^2", positive)]
        acceleration: f64,
    },
    /// Table of pseudo-acceleration
    Table {
        /// Points.
        #[input(table)]
        points: Vec<DemandPoint>,
        /// Interpolation.
        /// How the pseudo-acceleration is interpolated between two points.
        #[input(default = "linear-in-period", default_before = "log-log")]
        interpolation: Interpolation,
    },
}

/// Interpolation of a table of a response spectrum.
#[derive(Clone, Copy, Debug, Inputs)]
pub enum Interpolation {
    /// Linear in period
    LinearInPeriod,
    /// Linear in frequency
    LinearInFrequency,
    /// Linear in log-log scale
    LogLog,
}

/// A point of a response spectrum.
#[derive(Clone, Debug, Inputs)]
pub struct DemandPoint {
    /// Natural frequency.
    #[input("f", "Hz", positive)]
    pub frequency: f64,
    /// Spectral pseudo-acceleration.
    #[input("S_a", "m/s^2", positive)]
    pub acceleration: f64,
}

register!(ResponseSpectrum);

impl Analysis for ResponseSpectrum {
    const ABOUT: About = About {
        id: "vibration/response-spectrum",
        title: "Response spectrum analysis",
        topic: "Random vibration and earthquakes",
        summary: "Maximum displacement, acceleration or stress of a chain, of given modes or of a beam under base excitation, by ABS, SRSS and CQC.",
        main: &["deflection_srss", "displacement_srss", "base_force_srss", "stress_srss"],
        keywords: "earthquake seismic response spectrum modal combination srss cqc abs participation effective mass \
                   terremoto sismo espectro de resposta combinação modal participação massa efetiva",
        sources: &[&CHOPRA, &BIGGS],
        cases: include_str!("../../cases/response_spectrum.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &ResponseSpectrumGiven<W>, sheet: W) -> Result<(), Refusal> {
        let problem = Problem { demand: &given.spectrum, table: self.spectrum.table()?, ratio: given.ratio };
        match &self.structure {
            Structure::Chain { links } => {
                sheet.show(|| {
                    Exhibit::Drawing(chain::drawing(links).label(self.demand(), (-2.9, -0.15)).finish())
                });
            }
            Structure::Modes { .. } => {}
            Structure::Beam { section, .. } => sheet.show(|| Exhibit::Drawing(self.beam(section))),
        }
        match (&self.structure, &given.structure) {
            (_, StructureGiven::Chain { links }) => problem.chain(links, sheet),
            (_, StructureGiven::Modes { modes }) => problem.modes(modes, sheet),
            (
                Structure::Beam { modes, .. },
                StructureGiven::Beam { length, young, section, linear_mass, fibre, .. },
            ) => {
                let second_moment = second_moment(section, sheet, Symbol::from("I"))?;
                let beam = Beam {
                    length: *length,
                    young: *young,
                    second_moment,
                    linear_mass: *linear_mass,
                    fibre: *fibre,
                };
                problem.beam(&beam, *modes, sheet)
            }
            (_, StructureGiven::Beam { .. }) => unreachable!("what is given is made from the structure"),
        }
    }
}

impl ResponseSpectrum {
    /// The letter of the ordinate of the spectrum.
    fn demand(&self) -> &'static str {
        match self.spectrum {
            Demand::Displacement { .. } => "S_d",
            Demand::Velocity { .. } => "S_v",
            Demand::Acceleration { .. } | Demand::Table { .. } => "S_a",
        }
    }

    /// The beam on its moving supports, with the fibre whose stress is computed.
    fn beam(&self, section: &Section) -> Drawing {
        const WIDTH: f64 = 6.0;
        let mut sketch = beam("The beam on its moving supports", WIDTH);
        for x in [0.0, WIDTH] {
            sketch.pin("", (x, -HALF_BEAM)).motion("ÿ(t)", (x, -1.9), (x, -1.3));
        }
        section.label(&mut sketch, (0.35 * WIDTH, HALF_BEAM));
        sketch
            .label("m̄", (0.6 * WIDTH, HALF_BEAM))
            .dimension("c", (0.8 * WIDTH, 0.0), (0.8 * WIDTH, 2.0 * HALF_BEAM), 0.0)
            .label(self.demand(), (WIDTH, -1.9))
            .finish()
    }
}

/// Parameters shared by all structures.
struct Problem<'g, W: Worksheet> {
    demand: &'g DemandGiven<W>,
    table: Option<(&'g [DemandPoint], Interpolation)>,
    ratio: W::Num,
}

/// A simply supported beam.
struct Beam<N> {
    length: N,
    young: N,
    second_moment: N,
    linear_mass: N,
    fibre: N,
}

impl<W: Worksheet> Problem<'_, W> {
    /// The spectral displacement of mode `n`, counted from 1.
    fn displacement(&self, natural: W::Num, n: usize, sheet: W) -> Result<W::Num, Refusal> {
        let (value, why) = match self.demand {
            DemandGiven::Displacement { displacement } => return Ok(*displacement),
            DemandGiven::Velocity { velocity } => {
                (*velocity / natural, "Spectral displacement of this mode from the pseudo-velocity")
            }
            DemandGiven::Acceleration { acceleration } => (
                *acceleration / natural.powi(2),
                "Spectral displacement of this mode from the pseudo-acceleration",
            ),
            DemandGiven::Table { .. } => {
                let (points, interpolation) = self.table.expect("a table was given");
                let acceleration = interpolated(points, interpolation, natural, n, sheet)?;
                (
                    acceleration / natural.powi(2),
                    "Spectral displacement of this mode from the pseudo-acceleration",
                )
            }
        };
        Ok(sheet.step(Symbol::from("S_d").row(n), "mm", value, (why, CHOPRA.at("§6.6"))))
    }

    fn chain(&self, links: &[ChainMassGiven<W>], sheet: W) -> Result<(), Refusal> {
        let modes = chain::modes(links, sheet)?;
        let naturals: Vec<W::Num> = modes.iter().map(|mode| mode.natural).collect();
        let mut spectral = Vec::new();
        for (n, natural) in naturals.iter().enumerate() {
            spectral.push(self.displacement(*natural, n + 1, sheet)?);
        }
        let correlations = self.correlations(&naturals, sheet);
        let mut moved = Vec::new();
        for i in 0..links.len() {
            let mut parts = Vec::new();
            for (n, mode) in modes.iter().enumerate() {
                let why = ("Maximum displacement of this mass in this mode, Γφ S_d", CHOPRA.at("§13.8"));
                let symbol = Symbol::from("x").row(n + 1).row(i + 1);
                parts.push(sheet.step(symbol, "mm", mode.shares[i] * spectral[n], why));
            }
            let all = combined(&parts, &correlations, ["x_A", "x_S", "x_C"], "mm", Some(i + 1), sheet);
            sheet.answer(("displacement_abs", i + 1), "Displacement, sum of absolute values, mass", all.abs);
            sheet.answer(
                ("displacement_srss", i + 1),
                "Displacement, root of the sum of squares, mass",
                all.srss,
            );
            sheet.answer(
                ("displacement_cqc", i + 1),
                "Displacement, complete quadratic combination, mass",
                all.cqc,
            );
            moved.push(parts);
        }
        let last = links.len() - 1;
        let ends = modes
            .iter()
            .zip(&spectral)
            .map(|(mode, s)| (mode.natural.value(), (mode.shares[last].value() * s.value()).abs()));
        let ends: Vec<_> = ends.collect();
        sheet.show(|| Exhibit::Plot(lines("Maximum displacement of the last mass in each mode", ends)));
        let mut shears = Vec::new();
        for (n, mode) in modes.iter().enumerate() {
            let why = (
                "Maximum force on the base in this mode: its effective mass times its pseudo-acceleration",
                CHOPRA.at("§13.2"),
            );
            let mass = sheet.numerical(
                Symbol::from("m*").row(n + 1),
                "kg",
                mode.numbers.participation.powi(2),
                ("Effective mass of this mode, Γ²Σmφ²", CHOPRA.at("§13.2")),
            );
            let shear = mass * mode.natural.powi(2) * spectral[n];
            shears.push(sheet.step(Symbol::from("V").row(n + 1), "N", shear, why));
        }
        let all = combined(&shears, &correlations, ["V_A", "V_S", "V_C"], "N", None, sheet);
        sheet.answer("base_force_abs", "Force on the base, sum of absolute values", all.abs);
        sheet.answer("base_force_srss", "Force on the base, root of the sum of squares", all.srss);
        sheet.answer("base_force_cqc", "Force on the base, complete quadratic combination", all.cqc);
        sheet.verify(|| {
            // The force of the first spring is the force on the base.
            let total: f64 = modes[0].masses.iter().sum();
            let highest = naturals.iter().fold(0.0, |highest: f64, natural| highest.max(natural.value()));
            for (n, (shear, first)) in shears.iter().zip(&moved[0]).enumerate() {
                let spring = links[0].stiffness.value() * first.value();
                let scale = shear.value().abs().max(spring.abs()).max(f64::MIN_POSITIVE);
                let off = W::Num::from(shear.value() - spring);
                // What is left of the equations of a mode is rounding beside the largest eigenvalue.
                let participation = modes[n].numbers.participation;
                let error = f64::EPSILON * links.len() as f64 * highest.powi(2) * total.sqrt();
                let what = "force on the base of a mode, as the force of the first spring";
                sheet.check_residual(what, off, scale, error * participation * spectral[n].value());
            }
            chain::check_motions(links, &modes, &moved, sheet);
        });
        Ok(())
    }

    fn modes(&self, modes: &[GivenModeGiven<W>], sheet: W) -> Result<(), Refusal> {
        let naturals: Vec<W::Num> = modes.iter().map(|mode| mode.frequency).collect();
        let mut parts = Vec::new();
        for (n, mode) in modes.iter().enumerate() {
            let spectral = self.displacement(mode.frequency, n + 1, sheet)?;
            let why = ("Maximum displacement of the point in this mode, Γφ S_d", CHOPRA.at("§13.8"));
            parts.push(sheet.step(Symbol::from("x").row(n + 1), "mm", mode.share * spectral, why));
        }
        let correlations = self.correlations(&naturals, sheet);
        let sizes: Vec<_> = naturals.iter().zip(&parts).map(|(w, x)| (w.value(), x.value().abs())).collect();
        sheet.show(|| Exhibit::Plot(lines("Maximum displacement of each mode", sizes)));
        let all = combined(&parts, &correlations, ["x_A", "x_S", "x_C"], "mm", None, sheet);
        sheet.answer("displacement_abs", "Displacement, sum of absolute values", all.abs);
        sheet.answer("displacement_srss", "Displacement, root of the sum of squares", all.srss);
        sheet.answer("displacement_cqc", "Displacement, complete quadratic combination", all.cqc);
        let total: f64 = modes.iter().map(|mode| mode.share.value()).sum();
        if !(0.9..=1.1).contains(&total) {
            sheet.warn(|| {
                Text::new("the contributions of the modes sum to {total}, not to one: modes are missing, or Γ and φ do not correspond")
                    .with_quantity("total", total, "1")
            });
        }
        Ok(())
    }

    fn beam(&self, beam: &Beam<W::Num>, count: usize, sheet: W) -> Result<(), Refusal> {
        let Beam { length, young, second_moment, linear_mass, fibre } = *beam;
        let (mut naturals, mut deflections, mut stresses) = (Vec::new(), Vec::new(), Vec::new());
        for n in 0..count {
            let half_waves = (2 * n + 1) as f64;
            let row = |base: &'static str| Symbol::from(base).row(2 * n + 1);
            let why = ("Natural frequency of the mode with this number of half waves", RAO.at("§8.5"));
            let wave = sheet.step(
                row("β"),
                "rad/m",
                W::Num::from(half_waves) * PI / length,
                "Half waves over the span, as an angle per unit length",
            );
            let natural = wave.powi(2) * (young * second_moment / linear_mass).sqrt();
            let natural = sheet.step(row("ω"), "rad/s", natural, why);
            let frequency = sheet.step(row("f"), "Hz", natural, "The same in Hz");
            sheet.answer(("frequency", 2 * n + 1), "Natural frequency", frequency);
            let spectral = self.displacement(natural, 2 * n + 1, sheet)?;
            let sign = if n % 2 == 0 { 1.0 } else { -1.0 };
            let why = (
                "Modal contribution to the midspan motion when both supports move: 4/(βL), with the sign of sin(βL/2)",
                BIGGS.at("ch. 6"),
            );
            let share = sheet.step(row("Γφ"), "1", W::Num::from(4.0 * sign) / (wave * length), why);
            sheet.verify(|| {
                // Γ = ∫φ/∫φ², by the rule of midpoints, exact for these sines but for O(1/N²) of a smooth sum.
                let parts = 4000;
                let sine = |i: usize| (half_waves * PI * (i as f64 + 0.5) / f64::from(parts)).sin();
                let (mut first, mut second) = (0.0, 0.0);
                for i in 0..parts as usize {
                    first += sine(i);
                    second += sine(i).powi(2);
                }
                // The midpoint rule of a half sine is too large by this factor.
                let step = half_waves * PI / f64::from(2 * parts);
                let participation = first / second * step.sin() / step;
                let what = "modal participation factor by quadrature of the mode shape, Γ = ∫φ dx/∫φ² dx";
                sheet.check(what, (sign * participation).into(), share);
            });
            let why = ("Maximum deflection of the middle in this mode, Γφ S_d", BIGGS.at("ch. 6"));
            let deflection = sheet.step(row("y"), "mm", share * spectral, why);
            let why =
                ("Bending stress at midspan in this mode: E c times the curvature β²y", BEER.at("§4.4"));
            let stress = sheet.step(row("σ"), "MPa", young * fibre * wave.powi(2) * deflection, why);
            sheet.verify(|| {
                // Inertia forces like sin βx bend a beam on two supports by 1/β² of them, and its deflection by 1/β⁴.
                let inertia = linear_mass * natural.powi(2) * share * spectral;
                sheet.check(
                    "modal deflection: the beam carries its inertia forces, E I β⁴ y = m̄ ω² Γφ S_d",
                    young * second_moment * wave.powi(4) * deflection,
                    inertia,
                );
                sheet.check(
                    "bending stress from the moment of the inertia forces at the middle",
                    inertia / wave.powi(2) * fibre / second_moment,
                    stress,
                );
            });
            naturals.push(natural);
            deflections.push(deflection);
            stresses.push(stress);
        }
        let correlations = self.correlations(&naturals, sheet);
        let (length, largest) = (length.value(), deflections.iter().map(|one| one.value().abs()).collect());
        sheet.show(|| Exhibit::Plot(shapes(length, largest)));
        let all = combined(&deflections, &correlations, ["y_A", "y_S", "y_C"], "mm", None, sheet);
        sheet.answer("deflection_abs", "Midspan deflection, sum of absolute values", all.abs);
        sheet.answer("deflection_srss", "Midspan deflection, root of the sum of squares", all.srss);
        sheet.answer("deflection_cqc", "Midspan deflection, complete quadratic combination", all.cqc);
        let all = combined(&stresses, &correlations, ["σ_A", "σ_S", "σ_C"], "MPa", None, sheet);
        sheet.answer("stress_abs", "Bending stress, sum of absolute values", all.abs);
        sheet.answer("stress_srss", "Bending stress, root of the sum of squares", all.srss);
        sheet.answer("stress_cqc", "Bending stress, complete quadratic combination", all.cqc);
        Ok(())
    }

    /// The correlation of every two modes, written and compared with that of white noise.
    fn correlations(&self, naturals: &[W::Num], sheet: W) -> Vec<Vec<W::Num>> {
        let n = naturals.len();
        let mut all = vec![vec![W::Num::from(1.0); n]; n];
        for i in 0..n {
            for j in i + 1..n {
                let why = "Ratio of the two natural frequencies";
                let ratio =
                    sheet.step(Symbol::from("r").row(i + 1).row(j + 1), "1", naturals[j] / naturals[i], why);
                let why = ("Correlation of the two modes", CHOPRA.at("§13.7"));
                let value = base_modes::correlation(self.ratio, self.ratio, ratio);
                let value = sheet.step(Symbol::from("ρ").row(i + 1).row(j + 1), "1", value, why);
                sheet.verify(|| {
                    let mode =
                        |of: usize| Resonance { natural: naturals[of].value(), ratio: self.ratio.value() };
                    let moment = |r, s| modal_moment(mode(r), mode(s), 0, [0.0, f64::INFINITY]);
                    if let (Some(cross), Some(first), Some(second)) =
                        (moment(i, j), moment(i, i), moment(j, j))
                    {
                        let size = (first.value * second.value).sqrt();
                        let what = "correlation of the two modes under white noise, by partial fractions";
                        let scale = (cross.scale / size).max(1.0);
                        sheet.check_zero(what, (cross.value / size - value.value()).into(), scale);
                    }
                });
                all[i][j] = value;
                all[j][i] = value;
            }
        }
        if n > 1 {
            sheet.show(|| Exhibit::Table(table(&all)));
        }
        all
    }
}

impl Demand {
    /// The table of pseudo-acceleration and its interpolation.
    fn table(&self) -> Result<Option<(&[DemandPoint], Interpolation)>, Refusal> {
        let Demand::Table { points, interpolation } = self else { return Ok(None) };
        let ascend = points.windows(2).all(|pair| pair[0].frequency < pair[1].frequency);
        if points.len() < 2 || !ascend {
            return Err(Refusal::because(
                "the table of the spectrum needs at least two points, with frequencies that ascend and values above zero",
            ));
        }
        Ok(Some((points, *interpolation)))
    }
}

/// The pseudo-acceleration of mode `n`, counted from 1, between two rows of the table.
fn interpolated<W: Worksheet>(
    points: &[DemandPoint],
    interpolation: Interpolation,
    natural: W::Num,
    n: usize,
    sheet: W,
) -> Result<W::Num, Refusal> {
    let omega = natural.value();
    let above = points.partition_point(|point| point.frequency <= omega);
    let symbol = Symbol::from("S_a").row(n);
    let said = |words: &'static str, row: usize| Text::new(words).with("row", row + 1);
    match above.checked_sub(1) {
        Some(row) if points[row].frequency == omega => {
            let why = said("Pseudo-acceleration of this mode: row {row} of the spectrum", row);
            return Ok(sheet.numerical(symbol, "m/s^2", points[row].acceleration, why));
        }
        Some(_) if above < points.len() => {}
        _ => {
            return Err(Refusal::because(
                Text::new("the table of the spectrum does not reach {frequency}: add points for every mode")
                    .with_quantity("frequency", omega, "Hz"),
            ));
        }
    }
    let row = |at: usize, frequency: &'static str, acceleration: &'static str| {
        let why = said("Frequency of row {row} of the spectrum", at);
        let frequency = sheet.numerical(Symbol::from(frequency).row(n), "Hz", points[at].frequency, why);
        let why = said("Pseudo-acceleration of row {row} of the spectrum", at);
        let acceleration =
            sheet.numerical(Symbol::from(acceleration).row(n), "m/s^2", points[at].acceleration, why);
        (frequency, acceleration)
    };
    let (f_l, s_l) = row(above - 1, "f_l", "S_l");
    let (f_u, s_u) = row(above, "f_u", "S_u");
    let (value, why) = match interpolation {
        Interpolation::LinearInPeriod => {
            let period = |symbol: &'static str, frequency: W::Num, why: &'static str| {
                sheet.step(Symbol::from(symbol).row(n), "s", W::Num::from(2.0 * PI) / frequency, why)
            };
            let here = period("T", natural, "Period of this mode");
            let t_l = period("T_l", f_l, "Period of the row below it in frequency");
            let t_u = period("T_u", f_u, "Period of the row above it in frequency");
            (
                s_l + (s_u - s_l) * (here - t_l) / (t_u - t_l),
                "Pseudo-acceleration of this mode, linear in period between two rows",
            )
        }
        Interpolation::LinearInFrequency => (
            s_l + (s_u - s_l) * (natural - f_l) / (f_u - f_l),
            "Pseudo-acceleration of this mode, linear in frequency between two rows",
        ),
        Interpolation::LogLog => (
            s_l * ((natural / f_l).ln() / (f_u / f_l).ln() * (s_u / s_l).ln()).exp(),
            "Pseudo-acceleration of this mode, linear on log–log axes between two rows",
        ),
    };
    Ok(sheet.step(symbol, "m/s^2", value, why))
}

/// The half waves of the modes, each as large as it becomes.
fn shapes(length: f64, largest: Vec<f64>) -> Plot {
    let shape = |(n, largest): (usize, f64)| {
        let half_waves = 2 * n + 1;
        let at = |i: u16| {
            let share = f64::from(i) / 200.0;
            (share * length, largest * (half_waves as f64 * PI * share).sin())
        };
        Series::line(Text::new("{count} half waves").with("count", half_waves), (0..=200).map(at).collect())
    };
    Plot::new(
        "Maximum deflection of each mode",
        Axis::linear("along the beam", "m"),
        Axis::linear("deflection", "mm"),
        largest.into_iter().enumerate().map(shape).collect(),
    )
}

/// The largest displacement of each mode over its frequency.
fn lines(title: &'static str, modes: Vec<(f64, f64)>) -> Plot {
    let line = |(n, (frequency, size)): (usize, (f64, f64))| {
        let label = Text::new("mode {place}").with("place", n + 1);
        Series::line(label, vec![(frequency, 0.0), (frequency, size)])
    };
    Plot::new(
        title,
        Axis::linear("natural frequency", "Hz"),
        Axis::linear("displacement", "mm"),
        modes.into_iter().enumerate().map(line).collect(),
    )
}

fn table<N: Real>(correlations: &[Vec<N>]) -> TableExhibit {
    let column = |n: usize| Column { heading: Text::new("mode {place}").with("place", n + 1), unit: "1" };
    TableExhibit {
        title: "Correlation of the modes".into(),
        columns: (0..correlations.len()).map(column).collect(),
        rows: correlations
            .iter()
            .map(|row| row.iter().map(|value| Cell::Number(value.value())).collect())
            .collect(),
        foot: Vec::new(),
    }
}
