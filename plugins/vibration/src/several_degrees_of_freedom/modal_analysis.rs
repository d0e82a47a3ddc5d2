//! Natural frequencies, modes and damping of systems with many degrees of freedom.

use dalembert_core::{
    About, Analysis, Axis, Cell, Column, Exhibit, Inputs, Plot, Refusal, Series, TableExhibit, Text,
    Worksheet, register,
};
use dalembert_mechanics::{
    Real,
    vibration::modes::{ComplexMode, complex_modes},
};
use nalgebra::{Complex, DMatrix, DVector};

mod checks;

use crate::{
    shared::system::{
        Assembled, System, assemble,
        damping::{Damping, ModalDamping, in_modes},
        modes::{self, Found, SHOWN, find, largest_one},
        picture,
    },
    sources::{EWINS, RAO},
};

/// So many modes are filmed.
const FILMED: usize = 4;

/// The system, its damping, and how its modes are to be written.
#[derive(Clone, Debug, Inputs)]
pub struct ModalAnalysis {
    /// System.
    pub system: System,
    /// Damping.
    pub damping: Damping,
    /// Mode normalisation.
    pub normalisation: Normalisation,
}

/// Normalisation of a mode shape.
#[derive(Clone, Copy, Debug, Inputs)]
pub enum Normalisation {
    /// Largest component is 1
    Largest,
    /// First entry is 1
    First,
    /// Last component is 1
    Last,
    /// Modal mass given
    ModalMass {
        /// Modal mass of every mode.
        #[input("μ₀", "kg", positive, default = "1 kg")]
        mass: f64,
    },
}

register!(ModalAnalysis);

impl Analysis for ModalAnalysis {
    const ABOUT: About = About {
        id: "vibration/modal-analysis",
        title: "Modal analysis",
        topic: "Several degrees of freedom",
        summary: "Natural frequencies, mode shapes, modal masses, participation and damping ratios of a chain, of masses on a string, or of given matrices.",
        keywords: "mdof eigenvalue eigenvector natural frequencies modes chain string matrices complex modes Rayleigh \
                   proportional damping autovalor autovetor frequências naturais modos de vibração cadeia massas \
                   molas corda matrizes amortecimento vários graus de liberdade",
        sources: &[&RAO, &EWINS],
        cases: include_str!("../../cases/modal_analysis.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &ModalAnalysisGiven<W>, sheet: W) -> Result<(), Refusal> {
        let system = assemble(&self.system, &given.system, sheet)?;
        let found = find(&system, sheet)?;
        sheet.keep_going()?;
        let damped =
            in_modes(&self.damping, &given.damping, &system.damping, &system.mass, &found.modes, sheet)?;
        let shapes = self.normalised(&found.modes.shapes)?;
        for (mode, frequency) in found.frequencies.iter().enumerate() {
            sheet.answer(("frequency", mode + 1), "Natural frequency", *frequency);
        }
        for (mode, shape) in shapes.iter().enumerate() {
            sheet.answer_list(("mode", mode + 1), "Mode shape", "1", shape);
            let nodes = if system.parallel { nodes(shape) } else { Vec::new() };
            if !nodes.is_empty() {
                sheet.answer_list(("nodes", mode + 1), "Nodes (position in mass spacings)", "1", &nodes);
            }
        }
        masses(&system, &found, &shapes, sheet);
        if damped.any() && damped.proportional {
            ratios(&found, &damped, sheet);
        } else if damped.any() {
            complex(&system, &damped, &found, sheet)?;
        }
        self.exhibits(&system, &found, &damped, &shapes, sheet);
        Ok(())
    }
}

/// Nodes of a mode shape of masses in a row: 2.5 is half way from the second mass to the third.
fn nodes(shape: &[f64]) -> Vec<f64> {
    let still = 1e-9 * shape.iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
    let mut nodes = Vec::new();
    for (row, x) in shape.iter().enumerate() {
        let place = (row + 1) as f64;
        if x.abs() <= still {
            nodes.push(place);
        } else if let Some(next) = shape.get(row + 1)
            && next.abs() > still
            && x * next < 0.0
        {
            nodes.push(place + x / (x - next));
        }
    }
    nodes
}

/// Modal masses and, where the coordinates are parallel, the share of each mode in a motion of the ground.
pub(crate) fn masses<W: Worksheet>(
    system: &Assembled<W::Num>,
    found: &Found<W::Num>,
    shapes: &[Vec<f64>],
    sheet: W,
) {
    let unit = DVector::from_element(system.size(), 1.0);
    let total = unit.dot(&(&system.mass * &unit));
    let mut effective_sum = 0.0;
    for (mode, frequency) in found.frequencies.iter().enumerate() {
        let shape = DVector::from_column_slice(&shapes[mode]);
        let momenta = &system.mass * &shape;
        let mass = sheet.found(
            ("μ", mode + 1),
            "kg",
            shape.dot(&momenta),
            ("Modal mass φᵀMφ, for the chosen normalisation", RAO.at("§6.11")),
        );
        sheet.answer(("modal_mass", mode + 1), "Modal mass", mass);
        if frequency.value() > 0.0 {
            let stiffness = sheet.step(
                ("κ", mode + 1),
                "N/m",
                frequency.powi(2) * mass,
                ("Modal stiffness φᵀKφ = ω²φᵀMφ", RAO.at("§6.11")),
            );
            sheet.answer(("modal_stiffness", mode + 1), "Modal stiffness", stiffness);
            sheet.verify(|| checks::stiffness(system, &shape, mode + 1, stiffness, sheet));
        }
        if system.parallel {
            let excitation = unit.dot(&momenta);
            let nothing = excitation.abs() <= 1e-12 * momenta.lp_norm(1);
            let excited = sheet.found(
                ("L", mode + 1),
                "kg",
                if nothing { 0.0 } else { excitation },
                "Excitation by uniform motion of the ground at all springs: φᵀM1",
            );
            let effective = sheet.step(
                ("m_e", mode + 1),
                "kg",
                excited.powi(2) / mass,
                "Effective mass: the part of the total mass that moves with the ground in this mode",
            );
            effective_sum += effective.value();
            sheet.answer(("effective_mass", mode + 1), "Effective mass", effective);
        }
    }
    if system.parallel && found.frequencies.len() == system.size() {
        sheet.check("the effective masses add up to the total mass", effective_sum.into(), total.into());
    }
}

/// Damping ratios where the damping leaves the modes alone.
pub(crate) fn ratios<W: Worksheet>(found: &Found<W::Num>, damped: &ModalDamping, sheet: W) {
    let mut shown = Vec::new();
    for (mode, frequency) in found.frequencies.iter().enumerate() {
        if frequency.value() == 0.0 {
            continue;
        }
        let decay = sheet.found(
            ("γ", mode + 1),
            "1/s",
            damped.decay(mode),
            ("Damping of the mode φᵀCφ/φᵀMφ: C does not couple the modes, so the mode shapes are unchanged", RAO.at("§6.15")),
        );
        let ratio = sheet.step(
            ("ζ", mode + 1),
            "1",
            decay / *frequency / 2.0,
            ("Damping ratio of the mode", RAO.at("§6.15")),
        );
        sheet.answer(("damping_ratio", mode + 1), "Damping ratio", ratio);
        if ratio.value() < 1.0 {
            let one = W::Num::from(1.0);
            let natural = *frequency;
            let frequency = sheet.step(
                ("ω_d", mode + 1),
                "rad/s",
                *frequency * (one - ratio.powi(2)).sqrt(),
                ("Frequency of the free damped vibration", RAO.at("§2.6")),
            );
            sheet.answer(("damped_frequency", mode + 1), "Damped frequency", frequency);
            shown.push((mode + 1, [natural, ratio, frequency].map(Real::value)));
        } else {
            sheet.warn(|| {
                Text::new("mode {mode} is overdamped: it returns without oscillating").with("mode", mode + 1)
            });
        }
    }
    sheet.verify(|| {
        // The roots of the whole damped system, one after another.
        if let Ok(all) = complex_modes(&found.modes, &damped.physical)
            && found.modes.squares[0] > 0.0
        {
            for (mode, numbers) in shown {
                checks::root(numbers, mode, &all, sheet);
            }
            let lowest =
                all.iter().filter(|mode| mode.root.im > 0.0).map(ComplexMode::natural).reduce(f64::min);
            if let (Some(lowest), true) = (lowest, damped.decay(0) < 1.99 * found.modes.squares[0].sqrt()) {
                sheet.check_zero(
                    "the lowest root of det(λ²M + λC + K) = 0 lies at the lowest natural frequency",
                    (lowest - found.modes.squares[0].sqrt()).into(),
                    found.modes.squares[found.modes.squares.len() - 1].sqrt(),
                );
            }
        }
    });
}

/// Complex modes, for damping that couples the modes.
pub(crate) fn complex<W: Worksheet>(
    system: &Assembled<W::Num>,
    damping: &ModalDamping,
    found: &Found<W::Num>,
    sheet: W,
) -> Result<(), Refusal> {
    sheet.warn(|| {
        Text::new(
            "the damping couples the modes without damping: the masses no longer pass through rest together, and the \
             damped modes are complex",
        )
    });
    let all = complex_modes(&found.modes, &damping.physical).map_err(modes::refusal)?;
    let mut oscillations = 0;
    for (at, mode) in all.iter().take(SHOWN).enumerate() {
        let size = mode.natural();
        if size <= 1e-9 * all[all.len() - 1].natural() {
            continue;
        }
        let place = at + 1;
        let real = sheet.found(
            ("Re λ", place),
            "1/s",
            mode.root.re,
            ("Root of det(λ²M + λC + K) = 0, from the first-order state equations", EWINS.at("ch. 2")),
        );
        if mode.root.im <= 0.0 {
            sheet.answer(("decay_rate", place), "Root without oscillation", real);
            continue;
        }
        oscillations += 1;
        let damped = sheet.found(
            ("ω_d", place),
            "rad/s",
            mode.root.im,
            "Its imaginary part: frequency of the damped motion",
        );
        let natural = sheet.step(
            ("|λ|", place),
            "rad/s",
            (real.powi(2) + damped.powi(2)).sqrt(),
            "Its modulus: natural frequency of the damped mode",
        );
        let ratio = sheet.step(("ζ", place), "1", -real / natural, "Damping ratio of the damped mode");
        sheet.answer(("complex_frequency", place), "Natural frequency of the damped mode", natural);
        sheet.answer(("damped_frequency", place), "Damped frequency", damped);
        sheet.answer(("damping_ratio", place), "Damping ratio", ratio);
        sheet.verify(|| {
            let shown = [natural, ratio, damped].map(Real::value);
            let fastest = all[all.len() - 1].natural();
            checks::complex((system, damping), shown, (place, mode), fastest, sheet);
        });
        let lead = mode
            .shape
            .iter()
            .copied()
            .fold(None, |best: Option<Complex<f64>>, x| match best {
                Some(best) if x.norm() <= best.norm() * (1.0 + 1e-9) => Some(best),
                _ => Some(x),
            })
            .unwrap_or(Complex::ONE);
        // What does not move but for rounding has no phase.
        let relative = mode.shape.iter().map(|x| x / lead);
        let relative: Vec<Complex<f64>> =
            relative.map(|x| if x.norm() > 1e-10 { x } else { Complex::ZERO }).collect();
        let sizes: Vec<f64> = relative.iter().map(|x| x.norm()).collect();
        let phases: Vec<f64> = relative.iter().map(|x| x.arg()).collect();
        sheet.answer_list(("amplitudes", place), "Amplitudes of the damped mode", "1", &sizes);
        sheet.answer_list(("phases", place), "Phases of the damped mode", "deg", &phases);
    }
    // The roots of a polynomial sum up to its second coefficient: −tr M⁻¹C.
    sheet.verify(|| {
        let sum: f64 =
            all.iter().map(|mode| if mode.root.im > 0.0 { 2.0 * mode.root.re } else { mode.root.re }).sum();
        let trace = damping.matrix.trace();
        sheet.check("the sum of all roots is −tr(M⁻¹C)", (-sum).into(), trace.into());
    });
    if oscillations == 0 {
        sheet.warn(|| Text::new("every mode is overdamped: the system returns without oscillating"));
    }
    Ok(())
}

impl ModalAnalysis {
    /// The mode shapes in the chosen size.
    fn normalised(&self, shapes: &DMatrix<f64>) -> Result<Vec<Vec<f64>>, Refusal> {
        let zero = |at: &'static str| {
            let why = Text::new(
                "the {at} coordinate is a node of mode {mode}: it cannot be set to 1; choose another mode normalisation",
            );
            move |mode: usize| Refusal::because(why.clone().with_text("at", at).with("mode", mode + 1))
        };
        (0..shapes.ncols().min(SHOWN))
            .map(|mode| {
                let shape = shapes.column(mode);
                let shape = shape.as_slice();
                let largest = shape.iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
                let over = |entry: f64, at: &'static str| {
                    if entry.abs() <= 1e-9 * largest {
                        return Err(zero(at)(mode));
                    }
                    Ok(shape.iter().map(|x| x / entry).collect())
                };
                match self.normalisation {
                    Normalisation::Largest => Ok(largest_one(shape)),
                    Normalisation::First => over(shape[0], "first"),
                    Normalisation::Last => over(shape[shape.len() - 1], "last"),
                    Normalisation::ModalMass { mass } => {
                        let lead = largest_one(shape);
                        let sign = if (lead[0] * shape[0]) < 0.0 { -1.0 } else { 1.0 };
                        Ok(shape.iter().map(|x| sign * mass.sqrt() * x).collect())
                    }
                }
            })
            .collect()
    }

    fn exhibits<W: Worksheet>(
        &self,
        system: &Assembled<W::Num>,
        found: &Found<W::Num>,
        damped: &ModalDamping,
        shapes: &[Vec<f64>],
        sheet: W,
    ) {
        let n = system.size();
        sheet.show(|| Exhibit::Drawing(picture::at_rest(&self.system)));
        sheet.show(|| {
            let points = |shape: &Vec<f64>| {
                let largest = largest_one(shape);
                largest.iter().enumerate().map(|(row, x)| ((row + 1) as f64, *x)).collect()
            };
            let series = shapes.iter().take(FILMED).enumerate();
            Exhibit::Plot(Plot::new(
                "Mode shapes, largest component = 1",
                Axis::linear("coordinate", "1"),
                Axis::linear("amplitude over the maximum amplitude", "1"),
                series
                    .map(|(mode, shape)| {
                        Series::line(Text::new("mode {mode}").with("mode", mode + 1), points(shape))
                    })
                    .collect(),
            ))
        });
        for (mode, shape) in shapes.iter().enumerate().take(FILMED) {
            sheet.show(|| Exhibit::Animation(picture::mode(&self.system, mode + 1, &largest_one(shape))));
        }
        sheet.show(|| {
            let column = |heading: &'static str, unit| Column { heading: heading.into(), unit };
            let mut columns = vec![column("mode", "1"), column("ω", "rad/s"), column("f", "Hz")];
            let ratios = damped.any() && damped.proportional;
            if ratios {
                columns.push(column("ζ", "1"));
            }
            let rows = (0..n.min(100)).map(|mode| {
                let frequency = found.modes.squares[mode].sqrt();
                let mut row = vec![Cell::Number((mode + 1) as f64), frequency.into(), frequency.into()];
                if ratios {
                    row.push(if frequency > 0.0 {
                        (damped.decay(mode) / frequency / 2.0).into()
                    } else {
                        Cell::Empty
                    });
                }
                row
            });
            Exhibit::Table(TableExhibit {
                title: "Natural frequencies".into(),
                columns,
                rows: rows.collect(),
                foot: Vec::new(),
            })
        });
        if n <= 12 {
            for (title, unit, matrix) in [
                ("Mass matrix M", "kg", &system.mass),
                ("Damping matrix C", "N*s/m", &damped.physical),
                ("Stiffness matrix K", "N/m", &system.stiffness),
            ] {
                if matrix.iter().any(|entry| *entry != 0.0) {
                    sheet.show(|| Exhibit::Table(table(title, unit, matrix)));
                }
            }
        }
    }
}

fn table(title: &'static str, unit: &'static str, matrix: &DMatrix<f64>) -> TableExhibit {
    let number = |n: usize| Text::new(n.to_string());
    TableExhibit {
        title: title.into(),
        columns: (1..=matrix.ncols()).map(|n| Column { heading: number(n), unit }).collect(),
        rows: matrix.row_iter().map(|row| row.iter().map(|entry| Cell::Number(*entry)).collect()).collect(),
        foot: Vec::new(),
    }
}
