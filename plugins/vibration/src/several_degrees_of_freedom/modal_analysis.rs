//! Natural frequencies, modes and damping of systems with many degrees of freedom.

use dalembert_core::{
    About, Analysis, Axis, Cell, Column, Exhibit, Inputs, Plot, Refusal, Series, TableExhibit, Text,
    Worksheet, register,
};
use nalgebra::DMatrix;

use crate::{
    shared::system::{
        self, Assembled, System, assemble,
        damping::{ModalDamping, SystemDamping, in_modes},
        modal_properties::modal_properties,
        modes::{SHOWN, WorkedModes, find, largest_one},
        picture,
    },
    sources::{EWINS, RAO},
};

mod banded;

/// So many modes are filmed.
const FILMED: usize = 4;
/// The most numbers of a mode shape that are listed and drawn.
const LISTED: usize = 500;

/// The system, its damping, and how its modes are to be written.
#[derive(Clone, Debug, Inputs)]
pub struct ModalAnalysis {
    /// System.
    pub system: System,
    /// Damping.
    pub damping: SystemDamping,
    /// Mode normalisation.
    pub normalisation: Normalisation,
}

/// Normalisation of a mode shape.
#[derive(Clone, Copy, Debug, Inputs)]
pub enum Normalisation {
    /// Largest component is 1
    Largest,
    /// First component is 1
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
        main: &["frequency"],
        keywords: "mdof eigenvalue eigenvector natural frequencies modes chain string matrices complex modes \
                   Rayleigh proportional damping autovalor autovetor frequências naturais modos de vibração \
                   cadeia massas molas corda matrizes amortecimento vários graus de liberdade systems with two \
                   degrees of freedom principal coordinates modal coordinates normal modes sistemas com dois \
                   graus de liberdade coordenadas principais coordenadas modais semi-definite system \
                   unrestrained semidefinido orthogonality of modes ortogonalidade",
        sources: &[&RAO, &EWINS],
        cases: include_str!("../../cases/modal_analysis.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &ModalAnalysisGiven<W>, sheet: W) -> Result<(), Refusal> {
        if let Some(system) = system::banded::banded(&self.system)?
            && self.solve_banded(given, &system, sheet)?
        {
            return Ok(());
        }
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
        modal_properties(&system, &found, &damped, &shapes, sheet)?;
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
        found: &WorkedModes<W::Num>,
        damped: &ModalDamping,
        shapes: &[Vec<f64>],
        sheet: W,
    ) {
        let n = system.size();
        sheet.show(|| Exhibit::Drawing(picture::at_rest(&self.system, &[])));
        sheet.show(|| Exhibit::Plot(plot_of_shapes(shapes)));
        for (mode, shape) in shapes.iter().enumerate().take(FILMED) {
            sheet.show(|| Exhibit::Animation(picture::mode(&self.system, mode + 1, &largest_one(shape))));
        }
        sheet.show(|| {
            let decays = (damped.any() && damped.proportional).then(|| damped.decays());
            let squares = &found.modes.squares[..n.min(100)];
            Exhibit::Table(table_of_frequencies(squares, decays.as_deref()))
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

/// The mode shapes over the coordinates, every so many of them where there are more than can be drawn.
fn plot_of_shapes(shapes: &[Vec<f64>]) -> Plot {
    let series = shapes.iter().take(FILMED).enumerate().map(|(mode, shape)| {
        let largest = largest_one(shape);
        let every = largest.len().div_ceil(LISTED);
        let points = largest.iter().enumerate().step_by(every);
        let points = points.map(|(row, x)| ((row + 1) as f64, *x)).collect();
        Series::line(Text::new("mode {mode}").with("mode", mode + 1), points)
    });
    Plot::new(
        "Mode shapes, largest component = 1",
        Axis::linear("coordinate", "1"),
        Axis::linear("amplitude over the maximum amplitude", "1"),
        series.collect(),
    )
}

/// The natural frequencies, with the damping ratios where 2ζω of the modes is given.
fn table_of_frequencies(squares: &[f64], decays: Option<&[f64]>) -> TableExhibit {
    let column = |heading: &'static str, unit| Column { heading: heading.into(), unit };
    let mut columns = vec![column("mode", "1"), column("ω", "rad/s"), column("f", "Hz")];
    columns.extend(decays.map(|_| column("ζ", "1")));
    let rows = squares.iter().enumerate().map(|(mode, square)| {
        let frequency = square.sqrt();
        let mut row = vec![Cell::Number((mode + 1) as f64), frequency.into(), frequency.into()];
        let ratio = |decay: f64| if frequency > 0.0 { (decay / frequency / 2.0).into() } else { Cell::Empty };
        row.extend(decays.map(|decays| ratio(decays[mode])));
        row
    });
    TableExhibit { title: "Natural frequencies".into(), columns, rows: rows.collect(), foot: Vec::new() }
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
