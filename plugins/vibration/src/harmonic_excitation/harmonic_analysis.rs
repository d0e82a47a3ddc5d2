//! Harmonic analysis: the Fourier coefficients of a periodic curve from its ordinates.

use std::f64::consts::TAU;

use dalembert_core::{
    About, Analysis, Axis, Cell, Column, Drawing, Exhibit, Ink, Inputs, Plot, Refusal, Series, Sketch,
    TableExhibit, Text, Worksheet, register, trace::ROUNDING,
};
use dalembert_mechanics::{Real, sdof};
use dalembert_numerics::fourier;

use crate::sources::{GROVER, RAO};

/// Ordinates up to which the sums are written out term by term.
const WRITTEN: usize = 48;

/// A periodic curve, measured or calculated at equal intervals of its period.
#[derive(Clone, Debug, Inputs)]
pub struct HarmonicAnalysis {
    /// Ordinates.
    /// Of one period, at 0, T/N, 2T/N and so on; the ordinate at the end of the period is the first of the next one and is left out.
    pub ordinates: Ordinates,
    /// Number of harmonics.
    /// At most half the number of ordinates.
    #[input(min = 1, max = 100, default = "3")]
    pub harmonics: usize,
    /// Period.
    /// If given, the frequency of the first harmonic is also calculated.
    #[input("T", "s", positive)]
    pub period: Option<f64>,
}

/// Ordinates of one kind.
#[derive(Clone, Debug, Inputs)]
pub enum Ordinates {
    /// Numbers
    Numbers {
        /// Ordinate.
        #[input("y", "1")]
        values: Vec<f64>,
    },
    /// Displacements
    Displacements {
        /// Ordinate.
        #[input("y", "mm")]
        values: Vec<f64>,
    },
    /// Accelerations
    Accelerations {
        /// Ordinate.
        #[input("y", "m/s^2")]
        values: Vec<f64>,
    },
    /// Forces
    Forces {
        /// Ordinate.
        #[input("y", "N")]
        values: Vec<f64>,
    },
    /// Torques
    Torques {
        /// Ordinate.
        #[input("y", "N*m")]
        values: Vec<f64>,
    },
    /// Pressures
    Pressures {
        /// Ordinate.
        #[input("y", "kPa")]
        values: Vec<f64>,
    },
}

register!(HarmonicAnalysis);

impl Analysis for HarmonicAnalysis {
    const ABOUT: About = About {
        id: "vibration/harmonic-analysis",
        title: "Harmonic analysis of a periodic curve",
        topic: "Harmonic excitation",
        summary: "Fourier coefficients, amplitudes and phases of the harmonics of a curve from its ordinates at equal intervals: a turning moment, a pressure, a cam lift, a measured vibration.",
        main: &["amplitude", "phase"],
        keywords: "fourier coefficients numerical harmonic analysis ordinates periodic curve turning moment diagram spectrum rms \
                   análise harmônica coeficientes de fourier ordenadas espectro valor eficaz",
        sources: &[&RAO, &GROVER],
        cases: include_str!("../../cases/harmonic_analysis.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &HarmonicAnalysisGiven<W>, sheet: W) -> Result<(), Refusal> {
        let (ordinates, unit) = given.ordinates.values();
        let count = ordinates.len();
        if count < 3 {
            return Err(Refusal::because(
                "a harmonic requires at least three ordinates in the period: add some",
            ));
        }
        if 2 * self.harmonics > count {
            return Err(Refusal::because(
                Text::new("{count} ordinates determine {most} harmonics at most: ask for fewer, or give more ordinates")
                    .with("count", count)
                    .with("most", count / 2),
            ));
        }
        if let Some(period) = given.period {
            let why =
                ("Frequency of the first harmonic; that of the n-th is n times as large", RAO.at("§1.11"));
            let frequency = sheet.step("ω₁", "Hz", sdof::angular_frequency(period), why);
            sheet.answer("frequency", "Frequency of the first harmonic", frequency);
        }
        let values: Vec<f64> = ordinates.iter().map(|ordinate| ordinate.value()).collect();
        let why = ("Mean: the sum of the ordinates over their number", RAO.at("§1.11"));
        let mean = if count <= WRITTEN {
            sheet.common_error(
                "y_m",
                "the midpoint between the largest and the smallest ordinate taken as the mean",
                || {
                    let of = |choose: fn(W::Num, W::Num) -> W::Num| {
                        ordinates.iter().copied().fold(ordinates[0], choose)
                    };
                    (of(W::Num::max) + of(W::Num::min)) / 2.0
                },
            );
            sheet.step("y_m", unit, W::Num::sum(ordinates.iter().copied()) / count as f64, why)
        } else {
            sheet.numerical("y_m", unit, values.iter().sum::<f64>() / count as f64, why)
        };
        sheet.answer("mean", "Mean", mean);
        let mut harmonics = Vec::new();
        for n in 1..=self.harmonics {
            sheet.keep_going()?;
            harmonics.push(harmonic(ordinates, &values, n, unit, sheet));
        }
        let square = W::Num::from(values.iter().map(|y| y * y).sum::<f64>() / count as f64);
        let why = "Root mean square of the ordinates";
        let rms = sheet.numerical("y_rms", unit, square.value().sqrt(), why);
        sheet.answer("rms", "Root mean square", rms);
        sheet.verify(|| {
            // Parseval: all harmonics together have the mean square of the ordinates.
            let all = (1..=count / 2).map(|n| {
                let (a, b) = fourier::harmonic_by_recursion(&values, n);
                (a * a + b * b) / (fourier::factor(count, n) * count as f64)
            });
            let what = "mean square of the ordinates: the square of the mean, and half the squares of the amplitudes of all harmonics";
            sheet.check(what, rms.powi(2), (mean.powi(2).value() + all.sum::<f64>()).into());
        });
        let plain: Vec<(f64, f64)> = harmonics.iter().map(|(a, b)| (a.value(), b.value())).collect();
        let mean = mean.value();
        sheet.show(|| Exhibit::Plot(curve(&values, mean, &plain, unit)));
        sheet.show(|| table(&plain, unit, self.period));
        sheet.show(|| Exhibit::Drawing(drawing(&values)));
        Ok(())
    }
}

impl<W: Worksheet> OrdinatesGiven<W> {
    /// The ordinates, and the unit of what follows from them.
    fn values(&self) -> (&[W::Num], &'static str) {
        match self {
            OrdinatesGiven::Numbers { values } => (values, "1"),
            OrdinatesGiven::Displacements { values } => (values, "mm"),
            OrdinatesGiven::Accelerations { values } => (values, "m/s^2"),
            OrdinatesGiven::Forces { values } => (values, "N"),
            OrdinatesGiven::Torques { values } => (values, "N*m"),
            OrdinatesGiven::Pressures { values } => (values, "kPa"),
        }
    }
}

/// Coefficients, amplitude and phase of a harmonic.
fn harmonic<W: Worksheet>(
    ordinates: &[W::Num],
    values: &[f64],
    n: usize,
    unit: &'static str,
    sheet: W,
) -> (W::Num, W::Num) {
    let count = values.len();
    const COSINE: &str =
        "Cosine coefficient: 2/N Σ y_j cos (360° n (j − 1)/N); of the last harmonic, n = N/2, half as much";
    const SINE: &str = "Sine coefficient: 2/N Σ y_j sin (360° n (j − 1)/N)";
    let coefficient = |symbol: &'static str, factor: &dyn Fn(usize) -> f64, found: f64, why: &'static str| {
        let why = (why, RAO.at("§1.11"));
        if count > WRITTEN {
            return sheet.numerical((symbol, n), unit, found, why);
        }
        let terms = ordinates.iter().enumerate().map(|(j, y)| (*y, factor(j)));
        let terms = terms.filter(|(_, factor)| *factor != 0.0).map(|(y, factor)| {
            if factor == 1.0 {
                y
            } else if factor == -1.0 {
                -y
            } else {
                y * factor
            }
        });
        sheet.common_error(
            (symbol, n),
            "the first ordinate taken at T/N and not at the start of the period",
            || {
                let terms = ordinates.iter().zip(1..).map(|(y, place)| *y * factor(place % count));
                W::Num::sum(terms) * fourier::factor(count, n)
            },
        );
        sheet.step((symbol, n), unit, W::Num::sum(terms) * fourier::factor(count, n), why)
    };
    let found = fourier::harmonic(values, n);
    let a = coefficient("a", &|j| fourier::cosine_and_sine(count, n, j).0, found.0, COSINE);
    let b = coefficient("b", &|j| fourier::cosine_and_sine(count, n, j).1, found.1, SINE);
    let why = ("Amplitude of the harmonic", RAO.at("§1.11"));
    sheet.common_error(("A", n), "the root mean square of the harmonic taken as its amplitude", || {
        ((a.powi(2) + b.powi(2)) / 2.0).sqrt()
    });
    let amplitude = sheet.step(("A", n), unit, (a.powi(2) + b.powi(2)).sqrt(), why);
    sheet.answer(("cosine", n), "Cosine coefficient of harmonic", a);
    sheet.answer(("sine", n), "Sine coefficient of harmonic", b);
    sheet.answer(("amplitude", n), "Amplitude of harmonic", amplitude);
    let size: f64 = values.iter().map(|y| y.abs()).sum::<f64>() * fourier::factor(count, n);
    // Of a harmonic that is not there the phase is rounding.
    if amplitude.value() > 1e-12 * size {
        let why = ("Phase: the harmonic is A cos (nωt − φ)", RAO.at("§1.11"));
        // What is left of ordinates that cancel is zero.
        let exact = |x: W::Num| if x.value().abs() <= ROUNDING * size { W::Num::from(0.0) } else { x };
        let phase = sheet.step(("φ", n), "deg", exact(b).atan2(exact(a)), why);
        sheet.answer(("phase", n), "Phase of harmonic", phase);
        sheet.verify(|| {
            let what = Text::new("harmonic {n}: cosine coefficient from amplitude and phase").with("n", n);
            sheet.check_sum(what, amplitude * phase.cos(), a, size);
            let what = Text::new("harmonic {n}: sine coefficient from amplitude and phase").with("n", n);
            sheet.check_sum(what, amplitude * phase.sin(), b, size);
        });
    }
    sheet.verify(|| {
        let (by_a, by_b) = fourier::harmonic_by_recursion(values, n);
        let what = Text::new("harmonic {n}: cosine coefficient by Goertzel's recursion").with("n", n);
        sheet.check_sum(what, a, by_a.into(), size);
        let what = Text::new("harmonic {n}: sine coefficient by Goertzel's recursion").with("n", n);
        sheet.check_sum(what, b, by_b.into(), size);
    });
    (a, b)
}

/// The ordinates, and the sum of the mean and the harmonics, over a period.
fn curve(values: &[f64], mean: f64, harmonics: &[(f64, f64)], unit: &'static str) -> Plot {
    const STEPS: usize = 360;
    let angle = |j: usize, of: usize| TAU * j as f64 / of as f64;
    let sum = |angle: f64| {
        let term = |(n, (a, b)): (usize, &(f64, f64))| {
            let (sin, cos) = ((n + 1) as f64 * angle).sin_cos();
            a * cos + b * sin
        };
        mean + harmonics.iter().enumerate().map(term).sum::<f64>()
    };
    let given = (0..=values.len()).map(|j| (angle(j, values.len()), values[j % values.len()])).collect();
    let made = (0..=STEPS).map(|j| (angle(j, STEPS), sum(angle(j, STEPS)))).collect();
    Plot::new(
        "Ordinates and the sum of the harmonics",
        Axis::linear("fraction of the period as an angle", "deg"),
        Axis::linear("ordinate", unit),
        vec![Series::line("ordinates", given), Series::line("mean and harmonics", made)],
    )
}

fn table(harmonics: &[(f64, f64)], unit: &'static str, period: Option<f64>) -> Exhibit {
    let column = |heading: &'static str, unit| Column { heading: heading.into(), unit };
    let mut columns = vec![column("n", "1")];
    if period.is_some() {
        columns.push(column("frequency", "Hz"));
    }
    columns.extend([
        column("cosine coefficient", unit),
        column("sine coefficient", unit),
        column("amplitude", unit),
        column("phase", "deg"),
    ]);
    let row = |(n, (a, b)): (usize, &(f64, f64))| {
        let n = (n + 1) as f64;
        let frequency = period.map(|period| n * TAU / period);
        let numbers = [*a, *b, a.hypot(*b), b.atan2(*a)];
        std::iter::once(n).chain(frequency).chain(numbers).map(Cell::Number).collect()
    };
    Exhibit::Table(TableExhibit {
        title: "Harmonics of the curve".into(),
        columns,
        rows: harmonics.iter().enumerate().map(row).collect(),
        foot: Vec::new(),
    })
}

/// The ordinates over one period, as a book draws them.
fn drawing(values: &[f64]) -> Drawing {
    const WIDTH: f64 = 4.0;
    let most = values.iter().fold(0.0, |most: f64, y| most.max(y.abs())).max(f64::MIN_POSITIVE);
    let point = |j: usize| {
        let y = values[j % values.len()] / most;
        (WIDTH * j as f64 / values.len() as f64, y)
    };
    let mut sketch = Sketch::new("Ordinates of one period");
    sketch.line("", (0.0, 0.0), (WIDTH, 0.0), Ink::Faint);
    // More ordinates than these would be a grey field.
    if values.len() <= WRITTEN {
        for j in 0..values.len() {
            let (x, y) = point(j);
            sketch.line("", (x, 0.0), (x, y), Ink::Faint);
        }
        let (x, y) = point(1);
        sketch.label("y_2", (x, y));
    }
    let curve: Vec<(f64, f64)> = (0..=values.len()).map(point).collect();
    sketch.curve(curve, Ink::Body).dimension("T", (0.0, 0.0), (WIDTH, 0.0), -0.4).finish()
}
