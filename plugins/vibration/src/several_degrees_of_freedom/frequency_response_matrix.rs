//! Steady response of systems with many degrees of freedom to harmonic forces.

use dalembert_core::{
    About, Analysis, Axis, Cell, Column, Exhibit, Inputs, Name, Plot, Refusal, Series, Symbol, TableExhibit,
    Text, Worksheet, register,
};
use dalembert_mechanics::Real;
use nalgebra::{Complex, DVector};

use crate::{
    shared::{
        letters::of_row,
        system::{
            System, assemble,
            damping::{SystemDamping, in_modes},
            modes::find,
            picture,
        },
    },
    sources::{EWINS, RAO},
};

mod losses;
mod response;

use self::{
    losses::Losses,
    response::{SteadyResponse, by_modes, matrix},
};

/// Points of a curve.
const POINTS: usize = 480;

/// The system, the forces on it, and where and when it is examined.
#[derive(Clone, Debug, Inputs)]
pub struct FrequencyResponseMatrix {
    /// System.
    pub system: System,
    /// Damping.
    pub damping: SystemDamping,
    /// Loss factors of springs.
    /// Hysteretic damping, beside any other: the stiffness of such a spring is k(1 + iη).
    pub losses: Vec<SpringLoss>,
    /// Forces.
    /// All at the same frequency. A single force of 1 N gives a column of the frequency response matrix.
    #[input(min = 1)]
    pub forces: Vec<HarmonicForce>,
    /// Frequencies.
    /// At which the response is requested.
    #[input(table)]
    pub frequencies: Vec<OutputFrequency>,
    /// Observed coordinates.
    #[input(min = 1)]
    pub observed: Vec<Observed>,
    /// Quantity.
    pub quantity: Quantity,
    /// Maximum frequency of the curves.
    /// If omitted, slightly above the highest natural frequency.
    #[input("ω_e", "rad/s", positive)]
    pub highest: Option<f64>,
}

/// A spring of a chain whose material loses energy.
#[derive(Clone, Debug, Inputs)]
pub struct SpringLoss {
    /// Spring.
    /// Counted from the left: the spring before mass 1 is the first, that to the wall on the right the last.
    #[input(min = 1, max = 501)]
    pub spring: usize,
    /// Loss factor.
    #[input("η", "1", nonnegative)]
    pub loss_factor: f64,
}

/// A harmonic force F cos(ωt + φ).
#[derive(Clone, Debug, Inputs)]
pub struct HarmonicForce {
    /// Coordinate.
    #[input(min = 1, max = 500)]
    pub coordinate: usize,
    /// Amplitude.
    #[input("F", "N", nonnegative)]
    pub amplitude: f64,
    /// Phase.
    #[input("φ", "rad", default = "0 deg")]
    pub phase: f64,
}

/// A frequency that is asked for.
#[derive(Clone, Debug, Inputs)]
pub struct OutputFrequency {
    /// Frequency.
    #[input("ω", "Hz", nonnegative, default_before = "rad/s")]
    pub frequency: f64,
}

/// A coordinate that is examined.
#[derive(Clone, Debug, Inputs)]
pub struct Observed {
    /// Coordinate.
    #[input(min = 1, max = 500)]
    pub coordinate: usize,
}

/// Response quantity: displacement, velocity or acceleration.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum Quantity {
    /// Displacement (receptance for 1 N)
    Displacement,
    /// Velocity (mobility for 1 N)
    Velocity,
    /// Acceleration (accelerance for 1 N)
    Acceleration,
}

impl Quantity {
    fn unit(self) -> &'static str {
        match self {
            Quantity::Displacement => "m",
            Quantity::Velocity => "m/s",
            Quantity::Acceleration => "m/s^2",
        }
    }

    fn label(self) -> &'static str {
        match self {
            Quantity::Displacement => "displacement",
            Quantity::Velocity => "velocity",
            Quantity::Acceleration => "acceleration",
        }
    }

    /// (iω)ⁿ
    fn factor(self, frequency: f64) -> Complex<f64> {
        match self {
            Quantity::Displacement => Complex::ONE,
            Quantity::Velocity => Complex::new(0.0, frequency),
            Quantity::Acceleration => Complex::new(-frequency * frequency, 0.0),
        }
    }
}

/// Input along the horizontal axis of the curves.
const ASKED: &str = "frequencies[1].frequency";

register!(FrequencyResponseMatrix);

impl Analysis for FrequencyResponseMatrix {
    const ABOUT: About = About {
        id: "vibration/frequency-response-matrix",
        title: "Frequency response of multi-degree-of-freedom systems",
        topic: "Several degrees of freedom",
        summary: "Receptance, mobility or accelerance of a chain or of given matrices: steady-state amplitudes and phases under harmonic forces on any masses.",
        main: &["frequency", "amplitude", "phase"],
        keywords: "frf receptance mobility accelerance harmonic forced steady state mdof matrix reciprocity Nyquist loss factor complex stiffness hysteretic rubber mount \
                   receptância mobilidade acelerância resposta em frequência harmônica regime permanente vários \
                   graus de liberdade matriz",
        sources: &[&RAO, &EWINS],
        cases: include_str!("../../cases/frequency_response_matrix.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &FrequencyResponseMatrixGiven<W>, sheet: W) -> Result<(), Refusal> {
        let system = assemble(&self.system, &given.system, sheet)?;
        let n = system.size();
        let all = self.forces.iter().map(|force| force.coordinate);
        if let Some(wrong) = all.chain(self.observed.iter().map(|row| row.coordinate)).find(|&at| at > n) {
            let why = Text::new("there is no coordinate {at}: the system has {n}");
            return Err(Refusal::because(why.with("at", wrong).with("n", n)));
        }
        if self.frequencies.len() > 50 || self.observed.len() > 50 {
            return Err(Refusal::because("at most 50 frequencies and 50 coordinates are computed at a time"));
        }
        let found = find(&system, sheet)?;
        let damped =
            in_modes(&self.damping, &given.damping, &system.damping, &system.mass, &found.modes, sheet)?;
        for (mode, frequency) in found.frequencies.iter().enumerate() {
            sheet.answer(("frequency", mode + 1), "Natural frequency", *frequency);
        }
        let listed: Vec<(usize, f64)> =
            self.losses.iter().map(|loss| (loss.spring, loss.loss_factor)).collect();
        let losses = Losses::of(&self.system, &listed)?;
        if let Some(losses) = &losses {
            losses.modal(&system.stiffness, &found, sheet);
        }
        let response =
            SteadyResponse { system: &system, damped: &damped, losses, force: self.force(n), found: &found };
        let mut table = Vec::new();
        for (place, asked) in self.frequencies.iter().enumerate() {
            sheet.keep_going()?;
            let motion = response.at(asked.frequency)?;
            let written = self.closed_form(place, asked.frequency, &response, given, sheet);
            let answered = self.write(place, asked.frequency, &motion, written, sheet);
            self.check(asked.frequency, &response, &answered, sheet);
            table.push((asked.frequency, motion));
        }
        self.exhibits(&response, &table, sheet);
        Ok(())
    }
}

/// The response of a coordinate as it is answered, by its parts and by amplitude and phase.
struct Answered {
    coordinate: usize,
    parts: Complex<f64>,
    polar: Complex<f64>,
}

impl FrequencyResponseMatrix {
    fn force(&self, n: usize) -> DVector<Complex<f64>> {
        let mut force = DVector::from_element(n, Complex::ZERO);
        for one in &self.forces {
            force[one.coordinate - 1] += Complex::from_polar(one.amplitude, one.phase);
        }
        force
    }

    /// Two masses without damping under forces in phase, as a textbook writes them: Cramer's rule.
    fn closed_form<W: Worksheet>(
        &self,
        place: usize,
        frequency: f64,
        response: &SteadyResponse<'_, W::Num>,
        given: &FrequencyResponseMatrixGiven<W>,
        sheet: W,
    ) -> Option<[W::Num; 2]> {
        let ([m1, m2], [k11, k12, k22]) = response.system.two?;
        let in_phase = self.forces.iter().all(|force| force.phase == 0.0);
        if response.is_damped() || !in_phase || self.quantity != Quantity::Displacement {
            return None;
        }
        let row = |base: &'static str, at: usize| Symbol::from(base).row(place + 1).row(at);
        let frequency =
            sheet.numerical(("ω_t", place + 1), "rad/s", frequency, "From the table of frequencies");
        let square = frequency.powi(2);
        let z1 = sheet.step(
            row("Z", 1),
            "N/m",
            k11 - square * m1,
            ("Dynamic stiffness K₁₁ − ω²M₁", RAO.at("§5.6")),
        );
        let z2 = sheet.step(row("Z", 2), "N/m", k22 - square * m2, "Dynamic stiffness K₂₂ − ω²M₂");
        let determinant = sheet.step(
            ("Δ", place + 1),
            "N^2/m^2",
            z1 * z2 - k12.powi(2),
            "Determinant of K − ω²M; zero at a natural frequency",
        );
        let force = |at: usize| {
            let here = self.forces.iter().zip(&given.forces).filter(|(force, _)| force.coordinate == at);
            here.map(|(_, force)| force.amplitude).reduce(|sum, force| sum + force)
        };
        let solved = |own: W::Num, first: Option<W::Num>, second: Option<W::Num>| match (first, second) {
            (Some(first), Some(second)) => (own * first - k12 * second) / determinant,
            (Some(first), None) => own * first / determinant,
            (None, Some(second)) => -k12 * second / determinant,
            (None, None) => W::Num::from(0.0),
        };
        let why = ("Displacement in phase with the forces, by Cramer's rule", RAO.at("§5.6"));
        for (at, own) in [(1, z1), (2, z2)] {
            if let Some(force) = force(at) {
                sheet.common_error(row("Re", at), "the other mass taken as at rest", || force / own);
            }
        }
        let x1 = sheet.step(row("Re", 1), "m", solved(z2, force(1), force(2)), why);
        let x2 = sheet.step(row("Re", 2), "m", solved(z1, force(2), force(1)), why);
        Some([x1, x2])
    }

    fn write<W: Worksheet>(
        &self,
        place: usize,
        frequency: f64,
        motion: &DVector<Complex<f64>>,
        written: Option<[W::Num; 2]>,
        sheet: W,
    ) -> Vec<Answered> {
        let mut all = Vec::new();
        let unit = self.quantity.unit();
        for row in &self.observed {
            let at = row.coordinate;
            // A part that is rounding alone is zero; one that is −0 would turn the phase by a whole turn.
            let value = motion[at - 1] * self.quantity.factor(frequency);
            let size = value.norm();
            let clean = |part: f64| if part.abs() <= 1e-13 * size { 0.0 } else { part };
            let key = |name: &'static str| (name, place + 1, at);
            let symbol = |base: &'static str| Symbol::from(base).row(place + 1).row(at);
            let why = Text::new(
                "(K − ω²M + iωC) X = F at frequency {place}, coordinate {at}: the part in phase with cos ωt",
            );
            let why = why.with("place", place + 1).with("at", at);
            let real = match written {
                Some(both) => {
                    sheet.check(
                        Text::new("displacement {at} at frequency {place} by elimination")
                            .with("at", at)
                            .with("place", place + 1),
                        both[at - 1],
                        value.re.into(),
                    );
                    both[at - 1]
                }
                None => sheet.numerical(symbol("Re"), unit, clean(value.re), (why, RAO.at("§6.15"))),
            };
            let imaginary = sheet.numerical(
                symbol("Im"),
                unit,
                clean(value.im),
                "The component leading by 90°; a lag is negative",
            );
            let size = sheet.step(symbol("X"), unit, (real.powi(2) + imaginary.powi(2)).sqrt(), "Amplitude");
            sheet.answer(key("amplitude"), "Amplitude", size);
            let mut polar = Complex::ZERO;
            if size.value() > 0.0 {
                let principal = || (imaginary / real).atan2(W::Num::from(1.0));
                let what = "the principal value of the arctangent taken, the quadrant ignored";
                sheet.common_error(symbol("φ"), what, principal);
                let phase = sheet.step(symbol("φ"), "deg", imaginary.atan2(real), "Phase, ahead of cos ωt");
                sheet.answer(key("phase"), "Phase", phase);
                polar = Complex::from_polar(size.value(), phase.value());
            }
            sheet.answer(key("real"), "Real part", real);
            sheet.answer(key("imaginary"), "Imaginary part", imaginary);
            let parts = Complex::new(real.value(), imaginary.value());
            all.push(Answered { coordinate: at, parts, polar });
        }
        all
    }

    /// The sum over modes or poles against the dynamic stiffness.
    fn check<W: Worksheet>(
        &self,
        frequency: f64,
        response: &SteadyResponse<'_, W::Num>,
        answered: &[Answered],
        sheet: W,
    ) {
        let SteadyResponse { damped, force, found, losses, .. } = response;
        if let Some(losses) = losses {
            let matrices = response.matrices();
            sheet.verify(|| {
                let Ok((motion, error)) = losses.real_response(matrices, force, frequency) else { return };
                let factor = self.quantity.factor(frequency);
                let off = answered.iter().flat_map(|one| {
                    let other = motion[one.coordinate - 1] * factor;
                    [(one.parts - other).norm(), (one.polar - other).norm()]
                });
                let size = motion.iter().map(|x| x.norm()).fold(0.0, f64::max) * factor.norm();
                let what =
                    "the response from twice as many real equations, in phase and a quarter of a cycle ahead";
                sheet.check_residual(what, off.fold(0.0, f64::max).into(), size, error * factor.norm());
            });
            return;
        }
        sheet.verify(|| {
            let Some(sum) = by_modes(damped, force, found, frequency) else { return };
            let factor = self.quantity.factor(frequency);
            let off = answered.iter().flat_map(|one| {
                let by_modes = sum[one.coordinate - 1] * factor;
                [(one.parts - by_modes).norm(), (one.polar - by_modes).norm()]
            });
            let off = off.fold(0.0, f64::max);
            // What is left between two resonances is compared with the size of the terms that cancel there.
            let terms = found.modes.shapes.column_iter().zip(&found.modes.squares).enumerate();
            let size = terms
                .map(|(mode, (shape, square))| {
                    let pull: Complex<f64> = shape.iter().zip(force.iter()).map(|(phi, f)| f * *phi).sum();
                    let stiffness =
                        Complex::new(square - frequency * frequency, damped.decay(mode) * frequency);
                    pull.norm() * shape.amax() / stiffness.norm()
                })
                .fold(0.0, f64::max);
            sheet.check_zero("the response as a sum over the modes", off.into(), size * factor.norm());
        });
    }

    fn exhibits<W: Worksheet>(
        &self,
        response: &SteadyResponse<'_, W::Num>,
        table: &[(f64, DVector<Complex<f64>>)],
        sheet: W,
    ) {
        let SteadyResponse { system, found, .. } = response;
        sheet.show(|| {
            let load = |(force, row): (&HarmonicForce, usize)| (force.coordinate, of_row(&["F", "φ"], row));
            let loads: Vec<_> = self.forces.iter().zip(1..).map(load).collect();
            Exhibit::Drawing(picture::at_rest(&self.system, &loads))
        });
        let asked = self.frequencies.iter().map(|asked| asked.frequency).fold(0.0, f64::max);
        let natural = found.modes.squares.last().map_or(0.0, |square| square.sqrt());
        let last = self.highest.unwrap_or_else(|| 1.3 * asked.max(natural));
        if !(last > 0.0 && last.is_finite()) {
            return;
        }
        let grid: Vec<f64> = (1..=POINTS).map(|point| last * point as f64 / POINTS as f64).collect();
        let mut curves = Vec::new();
        for row in self.observed.iter().take(4) {
            let Some(curve) = response.curve(row.coordinate - 1, &grid) else { return };
            let curve: Vec<Complex<f64>> =
                curve.into_iter().zip(&grid).map(|(x, w)| x * self.quantity.factor(*w)).collect();
            curves.push((row.coordinate, Text::new("coordinate {at}").with("at", row.coordinate), curve));
        }
        let answer = |name: &'static str, coordinate: usize| Name::from((name, 1, coordinate));
        let line = |name: &'static str, of: fn(&Complex<f64>) -> f64| {
            let series = curves.iter().map(|(coordinate, label, curve)| {
                let points = grid.iter().copied().zip(curve.iter().map(of)).collect();
                Series::line(label.clone(), points).of(answer(name, *coordinate))
            });
            series.collect::<Vec<_>>()
        };
        let (label, unit) = (self.quantity.label(), self.quantity.unit());
        sheet.show(|| {
            let mut plot = Plot::new(
                "Amplitude against frequency",
                Axis::linear("frequency", "Hz"),
                Axis::log(label, unit),
                line("amplitude", |x| x.norm()),
            )
            .over(ASKED);
            for (frequency, motion) in table {
                let row = self.observed[0].coordinate;
                let size = (motion[row - 1] * self.quantity.factor(*frequency)).norm();
                plot = plot.mark("at this frequency", (*frequency, size));
            }
            Exhibit::Plot(plot)
        });
        sheet.show(|| {
            Exhibit::Plot(
                Plot::new(
                    "Phase against frequency",
                    Axis::linear("frequency", "Hz"),
                    Axis::linear("phase", "deg"),
                    line("phase", |x| x.arg()),
                )
                .over(ASKED),
            )
        });
        if response.is_damped() {
            sheet.show(|| {
                let series = curves.iter().map(|(coordinate, label, curve)| {
                    let line = Series::line(label.clone(), curve.iter().map(|x| (x.re, x.im)).collect());
                    let line = line.at(grid.clone());
                    // The abscissa is of the first.
                    if *coordinate == curves[0].0 { line.of(answer("imaginary", *coordinate)) } else { line }
                });
                Exhibit::Plot(
                    Plot::new(
                        "Nyquist plot",
                        Axis::linear("real part", unit),
                        Axis::linear("imaginary part", unit),
                        series.collect(),
                    )
                    .equal()
                    .over_answer(ASKED, answer("real", curves[0].0)),
                )
            });
        }
        if let (Some((frequency, _)), true) = (table.first(), system.size() <= 8)
            && let Some(matrix) = matrix(response, *frequency)
        {
            sheet.verify(|| {
                let off = (&matrix - matrix.transpose()).iter().map(|x| x.norm()).fold(0.0, f64::max);
                let size = matrix.iter().map(|x| x.norm()).fold(0.0, f64::max);
                sheet.check_zero("reciprocity: Hᵢⱼ = Hⱼᵢ", off.into(), size);
            });
            sheet.show(|| {
                Exhibit::Table(TableExhibit {
                    title: "Receptances |Hᵢⱼ| at the first frequency".into(),
                    columns: (1..=matrix.ncols())
                        .map(|column| Column { heading: Text::new(column.to_string()), unit: "m/N" })
                        .collect(),
                    rows: matrix
                        .row_iter()
                        .map(|row| row.iter().map(|entry| Cell::Number(entry.norm())).collect())
                        .collect(),
                    foot: Vec::new(),
                })
            });
        }
    }
}
