//! Shock response spectrum: the largest response of every oscillator to one shock of its base.

use std::f64::consts::PI;

use dalembert_core::{
    About, Analysis, Axis, Cell, Column, Exhibit, Inputs, Name, Plot, Refusal, Series, TableExhibit, Text,
    Worksheet, register,
};
use dalembert_mechanics::{
    Real,
    vibration::transient::{LoadSegment, Oscillator, OscillatorState, TransientMotion, TransientOutput},
};
use dalembert_numerics::quadrature::integral;

use crate::{
    shared::load::{self, AccelerationPoint, LoadHistory},
    sources::{CHOPRA, HARRIS, RAO},
};

/// The shock, the damping, and the frequencies that are examined.
#[derive(Clone, Debug, Inputs)]
pub struct ShockResponseSpectrum {
    /// Base shock.
    pub shock: Shock,
    /// Damping ratio of the oscillators.
    /// 0.05, Q = 10, unless stated otherwise.
    #[input("ζ", "1", nonnegative, default = "0.05")]
    pub ratio: f64,
    /// Quantity plotted.
    pub measure: SpectrumQuantity,
    /// Lowest frequency.
    #[input("f_min", "Hz", positive)]
    pub lowest: f64,
    /// Highest frequency.
    #[input("f_max", "Hz", positive)]
    pub highest: f64,
    /// Natural frequencies.
    /// The spectrum is computed at each of them.
    #[input("f", "Hz", positive)]
    pub frequencies: Vec<f64>,
}

/// Acceleration pulse of the base.
#[derive(Clone, Debug, Inputs)]
pub enum Shock {
    /// Pulse
    Pulse {
        /// Maximum acceleration.
        #[input("a₀", "m/s^2", positive)]
        acceleration: f64,
        /// Form.
        form: PulseForm,
    },
    /// Table
    /// Linear between the points, zero before the first and after the last.
    Table {
        /// Points.
        /// Increasing times; two points at the same time define a step.
        #[input(table)]
        points: Vec<AccelerationPoint>,
    },
}

/// The form of a pulse.
#[derive(Clone, Debug, Inputs)]
pub enum PulseForm {
    /// Half sine
    HalfSine {
        /// Duration.
        #[input("t_d", "s", positive)]
        duration: f64,
    },
    /// Rectangle
    Rectangle {
        /// Duration.
        #[input("t_d", "s", positive)]
        duration: f64,
    },
    /// Triangle
    Triangle {
        /// Duration.
        #[input("t_d", "s", positive)]
        duration: f64,
        /// Time of the peak.
        /// At the middle if omitted; the duration for a terminal-peak sawtooth.
        #[input("t_p", "s", nonnegative)]
        peak: Option<f64>,
    },
}

/// Response quantity of the plot.
#[derive(Clone, Debug, Inputs)]
pub enum SpectrumQuantity {
    /// Absolute acceleration
    Absolute,
    /// Pseudo-acceleration: relative displacement times ωₙ²
    Pseudo,
}

register!(ShockResponseSpectrum);

impl Analysis for ShockResponseSpectrum {
    const ABOUT: About = About {
        id: "vibration/shock-response-spectrum",
        title: "Shock response spectrum",
        topic: "Shock and impact",
        summary: "Primary, residual and maximax spectrum of a pulse or a recorded shock, at given frequencies and over a range.",
        main: &["maximax", "largest", "largest_amplification"],
        keywords: "srs shock spectrum primary residual maximax half sine sawtooth pulse drop test espectro de \
                   resposta ao choque meio seno dente de serra pulso primário residual semi-senoidal",
        sources: &[&RAO, &HARRIS, &CHOPRA],
        cases: include_str!("../../cases/shock_response_spectrum.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &ShockResponseSpectrumGiven<W>, sheet: W) -> Result<(), Refusal> {
        if self.lowest >= self.highest {
            return Err(Refusal::because("the lowest frequency is not below the highest: write a range"));
        }
        let shock = self.pieces()?;
        let spectrum = Spectrum {
            shock: &shock,
            ratio: self.ratio,
            absolute: matches!(self.measure, SpectrumQuantity::Absolute),
        };
        let pulse = match &given.shock {
            ShockGiven::Pulse { acceleration, form } => Some((*acceleration, duration(form))),
            ShockGiven::Table { .. } => None,
        };
        if let (Some((acceleration, duration)), ShockGiven::Pulse { form, .. }) = (pulse, &given.shock) {
            let (change, why) = match form {
                PulseFormGiven::HalfSine { .. } => {
                    (acceleration * duration * 2.0 / PI, "Velocity change: area of the half-sine pulse")
                }
                PulseFormGiven::Rectangle { .. } => {
                    (acceleration * duration, "Velocity change: area of the rectangular pulse")
                }
                PulseFormGiven::Triangle { .. } => {
                    (acceleration * duration / 2.0, "Velocity change: area of the triangular pulse")
                }
            };
            if let PulseFormGiven::HalfSine { .. } = form {
                sheet.common_error("ΔV", "the root mean square of the pulse taken as its mean", || {
                    acceleration * duration / 2.0_f64.sqrt()
                });
            }
            let change = sheet.step("ΔV", "m/s", change, why);
            sheet.answer("velocity_change", "Velocity change", change);
            sheet.verify(|| {
                let what = "velocity change: integral of the acceleration piece by piece, by quadrature";
                sheet.check(what, change, W::Num::from(shock.area()));
            });
        }
        let mut asked = Vec::new();
        for (n, &frequency) in given.frequencies.iter().enumerate() {
            asked.push(self.at(frequency, n + 1, &spectrum, pulse, sheet)?);
        }
        let curve = spectrum.curve([self.lowest, self.highest], self.count(&shock), sheet)?;
        largest(&curve, &spectrum, pulse, sheet)?;
        sheet.show(|| Exhibit::Plot(plot(&curve, &asked)));
        sheet.show(|| Exhibit::Table(table(&curve)));
        Ok(())
    }
}

/// A shock as pieces, with the end that parts primary from residual.
struct Pieces {
    pieces: Vec<LoadSegment>,
    end: f64,
}

impl Pieces {
    /// Velocity change of the base.
    fn area(&self) -> f64 {
        let ends = self.pieces.iter().skip(1).map(|next| next.from).chain([self.end]);
        let of = |(piece, end): (&LoadSegment, f64)| {
            integral(|time| piece.law.at(time - piece.from), [piece.from, end], 8)
        };
        self.pieces.iter().zip(ends).map(of).sum()
    }
}

/// Parameters for one ordinate of the spectrum.
struct Spectrum<'s> {
    shock: &'s Pieces,
    ratio: f64,
    absolute: bool,
}

/// The spectrum at a frequency.
#[derive(Clone, Copy)]
struct Ordinate {
    frequency: f64,
    primary: f64,
    residual: f64,
    /// Times of the primary and residual maxima.
    times: [f64; 2],
}

impl Ordinate {
    fn maximax(&self) -> f64 {
        self.primary.max(self.residual)
    }
}

impl Spectrum<'_> {
    /// The motion relative to the base of an oscillator of that frequency.
    fn motion(&self, frequency: f64) -> Result<TransientMotion, Refusal> {
        let oscillator = Oscillator { natural: frequency, ratio: self.ratio };
        let pieces = load::scaled(&self.shock.pieces, -1.0 / (frequency * frequency));
        TransientMotion::new(oscillator, OscillatorState::default(), &pieces).map_err(cannot)
    }

    fn output(&self) -> TransientOutput {
        if self.absolute { TransientOutput::support(self.ratio) } else { TransientOutput::DISPLACEMENT }
    }

    fn at(&self, frequency: f64) -> Result<Ordinate, Refusal> {
        let motion = self.motion(frequency)?;
        let end = self.shock.end;
        let primary = motion.extremes(self.output(), [0.0, end]).map_err(cannot)?.farthest();
        let residual = motion.extremes(self.output(), [end, f64::INFINITY]).map_err(cannot)?.farthest();
        let size = frequency * frequency;
        Ok(Ordinate {
            frequency,
            primary: primary.value.abs() * size,
            residual: residual.value.abs() * size,
            times: [primary.time, residual.time],
        })
    }

    /// Primary and residual of an ordinate by the integral over impulses. `None` where that is too much.
    fn by_impulses(&self, ordinate: &Ordinate) -> Option<[f64; 2]> {
        let oscillator = Oscillator { natural: ordinate.frequency, ratio: self.ratio };
        let at = |time| {
            load::by_impulses(oscillator, OscillatorState::default(), &self.shock.pieces, self.output(), time)
        };
        let [primary, residual] = ordinate.times;
        Some([at(primary)?.abs(), at(residual)?.abs()])
    }

    /// Distance of a frequency from the peak of the spectrum, relative to the frequency, by differences of sixth order,
    /// and the bound of its rounding error; `None` where it has no peak there. The step is relative to the frequency;
    /// it must be short enough for its sixth power to vanish.
    fn off_level(&self, frequency: f64, step: f64) -> Option<[f64; 2]> {
        let at = |n: f64| self.at(frequency * (1.0 + n * step)).map(|ordinate| ordinate.maximax()).ok();
        let here = at(0.0)?;
        let [mut slope, mut bend] = [0.0, -490.0 * here];
        for (n, odd, even) in [(1.0, 45.0, 270.0), (2.0, -9.0, -27.0), (3.0, 1.0, 2.0)] {
            let [right, left] = [at(n)?, at(-n)?];
            slope += odd * (right - left);
            bend += even * (right + left);
        }
        let bend = bend / (180.0 * step * step);
        (bend < 0.0).then(|| [slope / (60.0 * step) / bend, 1e-14 * here / (step * bend)])
    }

    /// The spectrum at frequencies of equal ratios.
    fn curve<W: Worksheet>(
        &self,
        [from, to]: [f64; 2],
        count: usize,
        sheet: W,
    ) -> Result<Vec<Ordinate>, Refusal> {
        let step = (to / from).ln() / (count - 1) as f64;
        (0..count)
            .map(|n| {
                sheet.keep_going()?;
                let frequency = if n + 1 == count { to } else { from * (step * n as f64).exp() };
                self.at(frequency)
            })
            .collect()
    }

    /// Returns true if the same one of primary and residual is the larger over the span of the differences and a little
    /// beyond.
    fn is_smooth(&self, frequency: f64, step: f64) -> bool {
        let residual = |n: f64| {
            self.at(frequency * (1.0 + n * step)).is_ok_and(|ordinate| ordinate.residual > ordinate.primary)
        };
        let here = residual(0.0);
        [-4.0, -2.0, 2.0, 4.0].into_iter().all(|n| residual(n) == here)
    }

    /// The frequency of the largest ordinate between two, by Newton's steps on differences of sixth order from a start
    /// between them, and the step of the last differences; `None` where the spectrum has a corner there. Shorter steps
    /// follow as long as rounding lets them: they leave out a corner near by.
    fn peak(&self, [below, start, above]: [f64; 3]) -> Option<[f64; 2]> {
        let newton = |mut frequency: f64, step: f64| {
            for _ in 0..6 {
                let [off, rounding] = self.off_level(frequency, step)?;
                frequency *= 1.0 - off;
                if !(below..=above).contains(&frequency) {
                    return None;
                }
                if off.abs() < 1e-7 {
                    return Some((frequency, rounding.abs()));
                }
            }
            None
        };
        let mut found = [newton(start, 4e-3)?.0, 4e-3];
        for step in [1e-3, 2.5e-4] {
            match newton(found[0], step) {
                Some((frequency, rounding)) if rounding < 1e-9 => found = [frequency, step],
                _ => break,
            }
        }
        Some(found)
    }
}

impl ShockResponseSpectrum {
    fn pieces(&self) -> Result<Pieces, Refusal> {
        let built = match &self.shock {
            Shock::Pulse { acceleration, form } => {
                let course = match *form {
                    PulseForm::HalfSine { duration } => LoadHistory::HalfSine { duration },
                    PulseForm::Rectangle { duration } => LoadHistory::Rectangular { duration },
                    PulseForm::Triangle { duration, peak } => LoadHistory::Triangular { duration, peak },
                };
                course.pieces(*acceleration)?
            }
            Shock::Table { points } => {
                let points: Vec<_> = points.iter().map(|point| (point.time, point.acceleration)).collect();
                if points.iter().all(|point| point.1 == 0.0) {
                    return Err(Refusal::because(
                        "all accelerations in the table are zero: there is no shock",
                    ));
                }
                load::table(&points)?
            }
        };
        let end = built.end.expect("a pulse and a table end");
        Ok(Pieces { pieces: built.pieces, end })
    }

    /// Number of plotted frequencies: fewer for long records, which cost more at each.
    fn count(&self, shock: &Pieces) -> usize {
        let cycles = (self.highest * shock.end / (2.0 * PI)).max(1.0);
        let work = shock.pieces.len() as f64 + cycles;
        (4_000.0 / work).clamp(48.0, 96.0) as usize
    }

    /// The spectrum at an asked frequency.
    fn at<W: Worksheet>(
        &self,
        frequency: W::Num,
        n: usize,
        spectrum: &Spectrum<'_>,
        pulse: Option<(W::Num, W::Num)>,
        sheet: W,
    ) -> Result<Ordinate, Refusal> {
        let row = |base: &'static str| dalembert_core::Symbol::from(base).row(n);
        let ordinate = spectrum.at(frequency.value())?;
        let why = (
            "Maximum response during the shock: the motion is exact over each piece of the shock, its peaks are where its rate is zero",
            HARRIS.at("ch. 8"),
        );
        let primary = sheet.numerical(row("S_p"), "m/s^2", ordinate.primary, why);
        let why = "Maximum response after the shock, from the free motion starting at its end";
        let residual = sheet.numerical(row("S_r"), "m/s^2", ordinate.residual, why);
        let (larger, why) = if ordinate.primary >= ordinate.residual {
            (primary, "The maximax is the larger one: the primary")
        } else {
            (residual, "The maximax is the larger one: the residual")
        };
        let maximax = sheet.step(row("S"), "m/s^2", larger, why);
        sheet.answer(("primary", n), "Primary at frequency", primary);
        sheet.answer(("residual", n), "Residual at frequency", residual);
        sheet.answer(("maximax", n), "Maximax at frequency", maximax);
        let integrals = spectrum.by_impulses(&ordinate);
        sheet.verify(|| {
            let Some(integrals) = integrals else { return };
            let what = [
                "primary, by Duhamel's integral up to its instant",
                "residual, by Duhamel's integral up to its instant",
            ];
            for ((what, shown), other) in what.into_iter().zip([primary, residual]).zip(integrals) {
                sheet.check_zero(what, W::Num::from(shown.value() - other), ordinate.maximax());
            }
        });
        let motion = spectrum.motion(frequency.value())?;
        sheet.verify(|| {
            let end = spectrum.shock.end;
            let size = frequency.value().powi(2);
            for time in [ordinate.times[0], end] {
                if let Some(integral) = motion.duhamel(time) {
                    let x = motion.at(time).displacement;
                    let scale = ordinate.maximax() / size;
                    sheet.check_zero(
                        "relative displacement by Duhamel's integral",
                        (x - integral).into(),
                        scale,
                    );
                }
            }
        });
        if let Some((acceleration, duration)) = pulse {
            let why = "Duration over the natural period";
            let cycles = sheet.step(row("n"), "1", duration * frequency / (2.0 * PI), why);
            let why = ("Amplification: the spectrum over the maximum base acceleration", RAO.at("§4.6"));
            let amplification = sheet.step(row("A"), "1", maximax / acceleration, why);
            sheet.answer(("amplification", n), "Amplification at frequency", amplification);
            sheet.verify(|| {
                if let Some([one, other]) = integrals {
                    let what = "amplification, by the integrals over unit impulses";
                    sheet.check(what, amplification, W::Num::from(one.max(other) / acceleration.value()));
                }
                if self.ratio == 0.0
                    && let Some([closed_primary, closed_residual]) = self.closed(cycles.value())
                {
                    let size = acceleration.value();
                    let scale = ordinate.maximax();
                    let what = "primary without damping, from its closed form";
                    sheet.check_zero(what, (ordinate.primary - closed_primary * size).into(), scale);
                    let what = "residual without damping, from its closed form";
                    sheet.check_zero(what, (ordinate.residual - closed_residual * size).into(), scale);
                }
            });
        }
        Ok(ordinate)
    }

    /// Primary and residual amplification without damping, for `n = t_d/T`; `None` where there is no closed form.
    fn closed(&self, n: f64) -> Option<[f64; 2]> {
        let Shock::Pulse { form, .. } = &self.shock else { return None };
        if !(1e-3..1e3).contains(&n) {
            return None;
        }
        match form {
            PulseForm::Rectangle { .. } => {
                let primary = if n >= 0.5 { 2.0 } else { 1.0 - (2.0 * PI * n).cos() };
                Some([primary, 2.0 * (PI * n).sin().abs()])
            }
            PulseForm::HalfSine { .. } if (n - 0.5).abs() > 1e-3 => {
                // r = Ω/ωₙ. The velocity is zero where Ωt = 2πj r/(1 + r) or 2πj r/(1 − r).
                let r = 0.5 / n;
                let at = |angle: f64| (angle.sin() - r * (angle / r).sin()).abs() / (1.0 - r * r).abs();
                let turns =
                    |first: f64| (1..).map(move |j| f64::from(j) * first).take_while(|turn| *turn <= PI);
                let primary = turns(2.0 * PI * r / (1.0 + r))
                    .chain(turns((2.0 * PI * r / (1.0 - r)).abs()))
                    .chain([PI])
                    .map(at)
                    .fold(0.0, f64::max);
                let residual = 4.0 * n * (PI * n).cos() / (1.0 - 4.0 * n * n);
                Some([primary, residual.abs()])
            }
            _ => None,
        }
    }
}

/// The largest ordinate over the range.
fn largest<W: Worksheet>(
    curve: &[Ordinate],
    spectrum: &Spectrum<'_>,
    pulse: Option<(W::Num, W::Num)>,
    sheet: W,
) -> Result<(), Refusal> {
    // The first of those that rounding alone tells apart.
    let top = curve.iter().map(Ordinate::maximax).fold(0.0, f64::max);
    let Some(at) = curve.iter().position(|ordinate| ordinate.maximax() >= top * (1.0 - 1e-9)) else {
        return Ok(());
    };
    let level = |n: usize| curve.get(n).is_some_and(|other| other.maximax() >= top * (1.0 - 1e-9));
    let peak = if at == 0 || at + 1 == curve.len() || level(at + 1) {
        None
    } else {
        spectrum.peak([at - 1, at, at + 1].map(|n| curve[n].frequency))
    };
    let largest = match peak {
        Some([frequency, _]) => spectrum.at(frequency)?,
        None => curve[at],
    };
    let why = match peak {
        Some(_) => "Maximum ordinate of the spectrum over the range, where its slope is zero",
        None => "Maximum ordinate of the spectrum among the plotted frequencies",
    };
    let largest_value = sheet.numerical("Sₘ", "m/s^2", largest.maximax(), why);
    sheet.answer("largest", "Maximum ordinate over the range", largest_value);
    if let Some((acceleration, _)) = pulse {
        let why = ("Maximum amplification over the range", RAO.at("§4.6"));
        let sudden = || W::Num::from(2.0);
        sheet.common_error("Aₘ", "the factor 2 of an undamped system under a sudden load taken", sudden);
        let amplification = sheet.step("Aₘ", "1", largest_value / acceleration, why);
        sheet.answer("largest_amplification", "Maximum amplification over the range", amplification);
        sheet.verify(|| {
            if let Some([one, other]) = spectrum.by_impulses(&largest) {
                let what = "maximum amplification, by Duhamel's integral";
                sheet.check(what, amplification, W::Num::from(one.max(other) / acceleration.value()));
            }
        });
    }
    sheet.verify(|| {
        if let Some([one, other]) = spectrum.by_impulses(&largest) {
            let what = "maximum ordinate, by Duhamel's integral up to its instant";
            sheet.check(what, largest_value, W::Num::from(one.max(other)));
        }
    });
    if let Some([frequency, step]) = peak {
        let frequency = sheet.numerical("fₘ", "Hz", frequency, "Its natural frequency");
        sheet.answer("largest_frequency", "Natural frequency of the maximum ordinate", frequency);
        if let Some((_, duration)) = pulse {
            let why = "Duration over the natural period, at the maximum ordinate";
            let cycles = sheet.step("nₘ", "1", duration * frequency / (2.0 * PI), why);
            sheet.answer("largest_duration_ratio", "Duration over the natural period there", cycles);
        }
        sheet.verify(|| {
            let beside = |part: f64| {
                spectrum.at(frequency.value() * part).map_or(f64::INFINITY, |ordinate| ordinate.maximax())
            };
            let higher = beside(0.99).max(beside(1.01)) - largest.maximax();
            let what = "the spectrum is lower on both sides of its maximum ordinate";
            sheet.check_zero(what, higher.max(0.0).into(), largest.maximax());
            // With a longer step there is a corner near by, which differences do not see.
            if step < 1e-3
                && spectrum.is_smooth(frequency.value(), step)
                && let Some([off, rounding]) = spectrum.off_level(frequency.value(), 0.7 * step)
            {
                let what = "the slope of the spectrum is zero at its maximum ordinate";
                sheet.check_residual(what, off.into(), 1.0, rounding);
            }
        });
    } else if at == 0 || at + 1 == curve.len() {
        sheet.warn(|| {
            Text::new("the maximum ordinate is at an end of the range: the spectrum may be higher beyond it")
        });
    }
    Ok(())
}

/// The spectrum, with its ordinates at the asked frequencies.
fn plot(curve: &[Ordinate], asked: &[Ordinate]) -> Plot {
    let line = |label: &'static str, of: fn(&Ordinate) -> f64| {
        let answer = Name::from((label, 1));
        Series::line(label, curve.iter().map(|ordinate| (ordinate.frequency, of(ordinate))).collect())
            .of(answer)
    };
    let lines = vec![
        line("maximax", Ordinate::maximax),
        line("primary", |ordinate| ordinate.primary),
        line("residual", |ordinate| ordinate.residual),
    ];
    let plot = Plot::new(
        "Shock response spectrum",
        Axis::log("natural frequency", "Hz"),
        Axis::linear("maximum acceleration", "m/s^2"),
        lines,
    )
    .over("frequencies[1]");
    // The first of them is the input that the curves are over, whose own points are marked.
    asked
        .iter()
        .skip(1)
        .fold(plot, |plot, ordinate| plot.mark_on("maximax", (ordinate.frequency, ordinate.maximax())))
}

/// The spectrum in numbers, about a dozen rows of it.
fn table(curve: &[Ordinate]) -> TableExhibit {
    let column = |heading: &'static str, unit| Column { heading: heading.into(), unit };
    let every = (curve.len() / 12).max(1);
    let row = |ordinate: &Ordinate| {
        vec![
            Cell::Number(ordinate.frequency),
            Cell::Number(ordinate.primary),
            Cell::Number(ordinate.residual),
            Cell::Number(ordinate.maximax()),
        ]
    };
    TableExhibit {
        title: "Shock response spectrum in numbers".into(),
        columns: vec![
            column("natural frequency", "Hz"),
            column("primary", "m/s^2"),
            column("residual", "m/s^2"),
            column("maximax", "m/s^2"),
        ],
        rows: curve.iter().step_by(every).map(row).collect(),
        foot: Vec::new(),
    }
}

fn duration<W: Worksheet>(form: &PulseFormGiven<W>) -> W::Num {
    match form {
        PulseFormGiven::HalfSine { duration }
        | PulseFormGiven::Rectangle { duration }
        | PulseFormGiven::Triangle { duration, .. } => *duration,
    }
}

fn cannot<E>(_: E) -> Refusal {
    Refusal::because(
        "these numbers are too large or too small for the motion to be computed: check their units",
    )
}
