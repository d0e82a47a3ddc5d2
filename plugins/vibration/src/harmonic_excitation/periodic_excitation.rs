//! A periodic force or base: its Fourier coefficients, the response to each harmonic, and all of them together.

use dalembert_core::{
    About, Analysis, Axis, Cell, Column, Drawing, Exhibit, Ink, Inputs, Plot, Refusal, Series, TableExhibit,
    Text, Worksheet, register, trace::ROUNDING,
};
use dalembert_mechanics::{
    Real, sdof,
    vibration::periodic::{self, ExcitationPath, PeriodicResponse, WaveSegment},
};

mod checks;
mod waveform;

use self::waveform::{Waveform, WaveformGiven};
use crate::{
    shared::oscillator::{
        Loss, is_one,
        motion::OscillatorMotion,
        parts::{BodyDamping, BodySprings, OscillatingBody, motion_of, suspension_of_body},
        plots, resisting_force,
    },
    sources::{RAO, THOMSON},
};

/// The most harmonics that are written out.
const WRITTEN: usize = 5;
/// The harmonics of a table that are written out, whether they vanish or not.
const OF_TABLE: u32 = 10;
/// The most harmonics that are added up.
const ADDED: u32 = 4000;

/// The oscillator and what shakes it periodically.
#[derive(Clone, Debug, Inputs)]
pub struct PeriodicExcitation {
    /// Inertia.
    /// Required for a force or torque; not required for base excitation if the natural frequency is known.
    pub mass: Option<OscillatingBody>,
    /// Springs.
    pub elasticity: BodySprings,
    /// Damping.
    pub damping: BodyDamping,
    /// Excitation.
    pub excitation: PeriodicWave,
    /// Wave.
    pub waveform: Waveform,
    /// Frequency of the wave.
    /// Once in a period.
    #[input("ω", "rad/s", positive)]
    pub frequency: f64,
    /// Time.
    /// From the start of a period of the steady-state motion; the displacement there is computed.
    #[input("t", "s", nonnegative)]
    pub time: Option<f64>,
}

/// Periodic excitation.
#[derive(Clone, Debug, Inputs)]
pub enum PeriodicWave {
    /// Force on the mass
    Force {
        /// Height of the wave.
        /// The value that the picture of the wave shows as one.
        #[input("F₀", "N", positive)]
        force: f64,
    },
    /// Motion of the base
    Base {
        /// Height of the wave.
        /// The value that the picture of the wave shows as one.
        #[input("Y", "m", positive)]
        height: f64,
    },
    /// Torque on the body
    /// For a rotation.
    Torque {
        /// Height of the wave.
        /// The value that the picture of the wave shows as one.
        #[input("T₀", "N*m", positive)]
        torque: f64,
    },
    /// Rotation of the base
    /// For a rotation.
    BaseRotation {
        /// Height of the wave.
        /// The value that the picture of the wave shows as one.
        #[input("Φ", "rad", positive)]
        height: f64,
    },
}

impl PeriodicWave {
    /// The motion that it is of.
    fn motion(&self) -> OscillatorMotion {
        match self {
            PeriodicWave::Force { .. } | PeriodicWave::Base { .. } => OscillatorMotion::Translation,
            PeriodicWave::Torque { .. } | PeriodicWave::BaseRotation { .. } => OscillatorMotion::Rotation,
        }
    }
}

register!(PeriodicExcitation);

impl Analysis for PeriodicExcitation {
    const ABOUT: About = About {
        id: "vibration/periodic-excitation",
        title: "Periodic force, torque or base",
        topic: "Harmonic excitation",
        summary: "Fourier coefficients of a periodic force, torque or base motion, and the steady-state response to each harmonic and to all of them.",
        main: &["largest", "rms", "displacement"],
        keywords: "fourier series square triangle sawtooth rectified cam harmonics spectrum série de fourier onda \
                   quadrada triangular dente de serra retificada came espectro",
        sources: &[&RAO, &THOMSON],
        cases: include_str!("../../cases/periodic_excitation.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &PeriodicExcitationGiven<W>, sheet: W) -> Result<(), Refusal> {
        let PeriodicExcitationGiven { mass, elasticity, damping, .. } = given;
        let motion = motion_of(mass.as_ref(), elasticity, damping, Some(self.excitation.motion()))?;
        let suspension = suspension_of_body(motion, mass.as_ref(), elasticity, damping, sheet)?;
        suspension.answer(sheet);
        let Loss::Viscous(zeta, _) = suspension.loss else {
            return Err(Refusal::because(
                "hysteretic damping has no equation of motion in the time domain: give the damping ratio of an equivalent viscous damper",
            ));
        };
        if let (Loss::Viscous(zeta, Some(damping)), Some(body)) = (suspension.loss, suspension.body) {
            let what = "damping coefficient by mass and natural frequency, 2ζmωₙ";
            sheet.check(what, damping, zeta * body.mass * suspension.natural * 2.0);
        }
        let pieces = self.waveform.pieces()?;
        let ratio = sheet.step(
            "r",
            "1",
            sdof::frequency_ratio(given.frequency, suspension.natural),
            "Frequency ratio of the first harmonic",
        );
        sheet.answer("frequency_ratio", "Frequency ratio of the first harmonic", ratio);
        refuse_resonance(&pieces, ratio.value(), zeta.value())?;
        let (excited, source, height) = match &given.excitation {
            PeriodicWaveGiven::Force { force } | PeriodicWaveGiven::Torque { torque: force } => {
                let body = suspension.body.ok_or_else(|| {
                    Refusal::because(motion.of(
                        "a force moves a mass: write the mass, or choose base excitation",
                        "a torque moves a moment of inertia: write it, or choose rotation of the base",
                    ))
                })?;
                let why = ("Static deflection under the height of the waveform", RAO.at("§4.2"));
                let (symbol, unit) = (motion.deflection(), motion.displacement_unit());
                let height = sheet.step(symbol, unit, *force / body.stiffness, why);
                (ExcitedSystem::Mass { stiffness: body.stiffness }, *force, height)
            }
            PeriodicWaveGiven::Base { height } | PeriodicWaveGiven::BaseRotation { height } => {
                (ExcitedSystem::Base, *height, *height)
            }
        };
        let system = ExcitedOscillator { motion, ratio, zeta, excited, height, source };
        system.mean(&given.waveform, &pieces, sheet);
        for (row, n) in written(&self.waveform, &pieces).into_iter().enumerate() {
            sheet.keep_going()?;
            system.harmonic(&given.waveform, &pieces, n, row, sheet);
        }
        let steady = PeriodicResponse::new(
            &pieces,
            system.drive(),
            zeta.value(),
            std::f64::consts::TAU / ratio.value(),
        );
        self.together(&system, &pieces, steady.as_ref(), given.time, sheet);
        system.spectrum(&pieces, given.frequency.value(), sheet);
        sheet.show(|| Exhibit::Drawing(self.drawing()));
        Ok(())
    }
}

impl PeriodicExcitation {
    /// The oscillator under its load, or on its moving base.
    fn drawing(&self) -> Drawing {
        let body = self.mass.as_ref().map_or_else(|| "m".into(), OscillatingBody::letters);
        let letters = [body, self.elasticity.letters().into()];
        match self.excitation {
            PeriodicWave::Force { .. } => plots::mass_spring_damper("F₀ f(ω t)", letters),
            PeriodicWave::Torque { .. } => plots::inertia_spring_damper("T₀ f(ω t)", letters),
            PeriodicWave::BaseRotation { .. } => plots::inertia_spring_damper("Φ f(ω t)", letters),
            PeriodicWave::Base { .. } => plots::supported("The mass on its base", letters)
                .block("", (-1.2, -1.9), (1.2, -1.5), Ink::Faint)
                .motion("y = Y f(ω t)", (1.6, -2.0), (1.6, -1.3))
                .finish(),
        }
    }
}

/// Parameters of the response to the harmonics.
struct ExcitedOscillator<N> {
    motion: OscillatorMotion,
    ratio: N,
    zeta: N,
    excited: ExcitedSystem<N>,
    /// Deflection at rest under the height of the wave, m.
    height: N,
    /// Height of the wave in its own unit.
    source: N,
}

/// System under excitation.
#[derive(Clone, Copy)]
enum ExcitedSystem<N> {
    /// The mass, on a spring of this stiffness.
    Mass { stiffness: N },
    /// The base.
    Base,
}

/// The harmonics that are written out: of a textbook's wave the first that are there, which its symmetry says. Of a table
/// the first of all: whether one of them vanishes would be left to the last places of what was typed.
fn written(waveform: &Waveform, pieces: &[WaveSegment]) -> Vec<u32> {
    if matches!(waveform, Waveform::Table { .. }) {
        return (1..=OF_TABLE).collect();
    }
    (1..=60).filter(|n| is_there(pieces, *n)).take(WRITTEN).collect()
}

fn is_there(pieces: &[WaveSegment], n: u32) -> bool {
    let (a, b) = periodic::harmonic(pieces, n);
    a.hypot(b) > 1e-9
}

/// Undamped, with a harmonic at the natural frequency.
fn refuse_resonance(pieces: &[WaveSegment], ratio: f64, zeta: f64) -> Result<(), Refusal> {
    let order = (1.0 / ratio).round();
    if zeta == 0.0 && order >= 1.0 && order <= f64::from(ADDED) && is_one(order * ratio) {
        let order = order as u32;
        if is_there(pieces, order) {
            return Err(Refusal::because(
                Text::new(
                    "without damping, harmonic {order} coincides with the natural frequency: the motion is unbounded, it grows with t",
                )
                .with("order", order),
            ));
        }
    }
    Ok(())
}

impl<N: Real> ExcitedOscillator<N> {
    fn drive(&self) -> ExcitationPath {
        match self.excited {
            ExcitedSystem::Mass { .. } => ExcitationPath::Force,
            ExcitedSystem::Base => ExcitationPath::Base,
        }
    }

    /// Symbol and unit of the wave.
    fn wave(&self) -> (&'static str, &'static str) {
        match self.excited {
            ExcitedSystem::Mass { .. } => (self.motion.of("F", "T"), self.motion.force_unit()),
            ExcitedSystem::Base => (self.motion.of("Y", "Φ"), self.motion.displacement_unit()),
        }
    }

    /// Motion over static deflection at a harmonic.
    fn factor<S: Real>(&self, ratio: S, zeta: S) -> S {
        match self.excited {
            ExcitedSystem::Mass { .. } => sdof::magnification(ratio, zeta),
            ExcitedSystem::Base => sdof::transmissibility(ratio, zeta),
        }
    }

    fn lag<S: Real>(&self, ratio: S, zeta: S) -> S {
        match self.excited {
            ExcitedSystem::Mass { .. } => sdof::phase_lag_from_ratios(ratio, zeta),
            ExcitedSystem::Base => sdof::transmissibility_phase(ratio, zeta),
        }
    }

    /// The mean of the motion: the deflection at rest under the mean of the wave.
    fn mean<W: Worksheet<Num = N>>(&self, wave: &WaveformGiven<W>, pieces: &[WaveSegment], sheet: W) {
        let mean = periodic::mean(pieces);
        let offset = wave.mean(self.motion, self.height, mean, sheet);
        sheet.check_zero(
            "mean of the wave from its pieces",
            N::from(offset.value() / self.height.value() - mean),
            1.0,
        );
        sheet.answer("mean", self.motion.of("Mean displacement", "Mean angle"), offset);
    }

    /// One harmonic: its coefficient, and what the oscillator makes of it.
    fn harmonic<W: Worksheet<Num = N>>(
        &self,
        wave: &WaveformGiven<W>,
        pieces: &[WaveSegment],
        n: u32,
        row: usize,
        sheet: W,
    ) {
        let index = n as usize;
        let (a, b) = periodic::harmonic(pieces, n);
        // What is left of the pieces that cancel is zero.
        let added: f64 = pieces
            .iter()
            .map(|piece| piece.value.abs() + (piece.slope * (piece.to - piece.from)).abs())
            .sum();
        let (a, b) = if a.hypot(b) <= ROUNDING * added { (0.0, 0.0) } else { (a, b) };
        let source = wave.amplitude(self.source, n, (a, b), self.wave(), sheet);
        sheet.check_zero(
            "coefficient of the harmonic from the pieces of the wave",
            N::from(source.value() / self.source.value() - a.hypot(b)),
            1.0,
        );
        let symbol = (self.motion.of("X", "Θ"), index);
        // What a table does not contain moves nothing, not even in resonance; the lag of the first is an answer.
        if (a, b) == (0.0, 0.0) && row > 0 {
            let amplitude = match self.excited {
                ExcitedSystem::Mass { stiffness } => source / stiffness,
                ExcitedSystem::Base => source,
            };
            let why = "No response: this harmonic is absent from the wave";
            let amplitude = sheet.step(symbol, self.motion.displacement_unit(), amplitude, why);
            sheet.answer(("harmonic", index), "Amplitude of harmonic", amplitude);
            return;
        }
        let ratio = sheet.step(("r", index), "1", self.ratio * f64::from(n), "Its frequency ratio");
        let (amplitude, why) = match self.excited {
            ExcitedSystem::Mass { stiffness } => (
                source / stiffness * self.factor(ratio, self.zeta),
                ("Response to this harmonic: magnified static deflection", RAO.at("§4.2")),
            ),
            ExcitedSystem::Base => (
                source * self.factor(ratio, self.zeta),
                ("Response to this harmonic: transmitted motion of the base", RAO.at("§4.2")),
            ),
        };
        match self.excited {
            ExcitedSystem::Mass { stiffness } => {
                sheet.common_error(symbol, "the transmissibility used", || {
                    source / stiffness * sdof::transmissibility(ratio, self.zeta)
                });
            }
            ExcitedSystem::Base => {
                sheet.common_error(symbol, "the magnification factor for a force on the mass used", || {
                    source * sdof::magnification(ratio, self.zeta)
                });
            }
        }
        let amplitude = sheet.step(symbol, self.motion.displacement_unit(), amplitude, why);
        let why = ("Its lag behind this harmonic of the wave", RAO.at("§4.2"));
        let lag = sheet.step(("φ", index), "deg", self.lag(ratio, self.zeta), why);
        sheet.answer(("harmonic", index), "Amplitude of harmonic", amplitude);
        if row == 0 {
            sheet.answer("phase", "Phase lag of the first of them", lag);
        }
        sheet.verify(|| {
            let ([in_phase, across], size) = resisting_force([ratio, self.zeta], amplitude, lag);
            let [drive, ahead] = match self.excited {
                ExcitedSystem::Mass { stiffness } => [source / stiffness, N::from(0.0)],
                ExcitedSystem::Base => [source, source * self.zeta * ratio * 2.0],
            };
            let what = Text::new("harmonic {n}: equation of motion, component in phase with the wave")
                .with("n", n as usize);
            sheet.check_sum(what, in_phase, drive, size);
            let what = Text::new("harmonic {n}: equation of motion, quadrature component (90° ahead)");
            let what = what.with("n", n as usize);
            match self.excited {
                ExcitedSystem::Mass { .. } => sheet.check_zero(what, across, size),
                ExcitedSystem::Base => sheet.check_sum(what, across, ahead, size),
            }
        });
    }

    /// Table and line spectrum of the harmonics.
    fn spectrum<W: Worksheet<Num = N>>(&self, pieces: &[WaveSegment], frequency: f64, sheet: W) {
        let (ratio, zeta, height, source) =
            (self.ratio.value(), self.zeta.value(), self.height.value(), self.source.value());
        let lines: Vec<(u32, f64)> = (1..=20)
            .map(|n| {
                let (a, b) = periodic::harmonic(pieces, n);
                (n, a.hypot(b))
            })
            .collect();
        let there = |line: &&(u32, f64)| line.1 > 1e-9;
        sheet.show(|| {
            let column = |heading: &'static str, unit| Column { heading: heading.into(), unit };
            let row = |(n, share): &(u32, f64)| {
                let r = f64::from(*n) * ratio;
                let numbers = [
                    f64::from(*n),
                    f64::from(*n) * frequency,
                    share * source,
                    r,
                    self.factor(r, zeta),
                    share * height * self.factor(r, zeta),
                    self.lag(r, zeta),
                ];
                numbers.map(Cell::Number).to_vec()
            };
            Exhibit::Table(TableExhibit {
                title: "Harmonics of the wave and of the motion".into(),
                columns: vec![
                    column("n", "1"),
                    column("frequency", "Hz"),
                    column("wave", self.wave().1),
                    column("frequency ratio", "1"),
                    column("magnification", "1"),
                    column("motion", self.motion.displacement_unit()),
                    column("phase lag", "deg"),
                ],
                rows: lines.iter().filter(there).take(10).map(row).collect(),
                foot: Vec::new(),
            })
        });
        sheet.show(|| {
            let stem = |(n, share): &(u32, f64)| {
                let at = f64::from(*n) * frequency;
                let height = share * height * self.factor(f64::from(*n) * ratio, zeta);
                [(at, 0.0), (at, height), (at, f64::INFINITY)]
            };
            Exhibit::Plot(Plot::new(
                "Line spectrum of the motion",
                Axis::linear("frequency", "Hz"),
                Axis::linear("amplitude", self.motion.displacement_unit()),
                vec![Series::line(self.motion.of("X", "Θ"), lines.iter().flat_map(stem).collect())],
            ))
        });
        let (own, here) = (zeta, ratio);
        match self.excited {
            ExcitedSystem::Mass { .. } => plots::force_families(here, move |_| own, None, sheet),
            ExcitedSystem::Base => {
                sheet.show(|| Exhibit::Plot(plots::transmissibility_family(here, move |_| own)));
            }
        }
    }
}

/// The sum of the squares of the harmonics of the motion, halved, in units of the deflection at rest; and whether the
/// harmonics left out are too small to matter.
fn parseval<N: Real>(system: &ExcitedOscillator<N>, pieces: &[WaveSegment]) -> (f64, bool) {
    let (ratio, zeta) = (system.ratio.value(), system.zeta.value());
    let most = (40_000 / pieces.len().max(1) as u32).clamp(20, ADDED);
    let mut sum = periodic::mean(pieces).powi(2);
    let mut late = 0.0;
    for n in 1..=most {
        let (a, b) = periodic::harmonic(pieces, n);
        let square = 0.5 * (a.hypot(b) * system.factor(f64::from(n) * ratio, zeta)).powi(2);
        sum += square;
        if n > most / 2 {
            late += square;
        }
    }
    // Coefficients fall at least as 1/n, so what is left out is at most as much as the second half.
    (sum, late < 1e-11 * sum)
}

impl PeriodicExcitation {
    /// Root mean square, extremes, displacement at a time, and the motion over two periods.
    fn together<W: Worksheet>(
        &self,
        system: &ExcitedOscillator<W::Num>,
        pieces: &[WaveSegment],
        steady: Option<&PeriodicResponse>,
        time: Option<W::Num>,
        sheet: W,
    ) {
        let (height, motion) = (system.height, system.motion);
        let unit = motion.displacement_unit();
        let whole = steady.and_then(|steady| Some((steady, steady.mean_square()?, steady.extremes()?)));
        let Some((steady, square, [largest, least])) = whole else {
            sheet.warn(|| {
                Text::new("the total motion of all harmonics is omitted: it cannot be computed exactly")
            });
            return;
        };
        let mean = || periodic::mean(pieces);
        // Order, amplitude over the deflection at rest, and lag.
        let harmonics = || {
            let (ratio, zeta) = (system.ratio.value(), system.zeta.value());
            written(&self.waveform, pieces).into_iter().map(move |n| {
                let (a, b) = periodic::harmonic(pieces, n);
                let r = f64::from(n) * ratio;
                (n, a.hypot(b) * system.factor(r, zeta), b.atan2(a) + system.lag(r, zeta))
            })
        };
        let first = || harmonics().next().map_or(f64::NAN, |(_, amplitude, _)| amplitude);
        let how = "Root mean square over the static deflection, of the exact motion: piece by piece, closed over a period";
        let share = sheet.numerical("q_rms", "1", square.sqrt(), (how, RAO.at("§4.3")));
        sheet.common_error(motion.of("x_rms", "θ_rms"), "the first harmonic alone taken", || {
            height * (first() / 2.0_f64.sqrt())
        });
        let rms = sheet.step(
            motion.of("x_rms", "θ_rms"),
            unit,
            height * share,
            motion.of("Root mean square of the displacement", "Root mean square of the angle"),
        );
        sheet.verify(|| {
            let (sum, whole) = parseval(system, pieces);
            if whole {
                sheet.check(
                    "mean square of the exact motion = half the sum of the squares of all harmonics",
                    (rms / height).powi(2),
                    W::Num::from(sum),
                );
            }
        });
        let why = "Maximum displacement of the exact motion, over the static deflection";
        let largest = sheet.numerical("q_max", "1", largest, (why, RAO.at("§4.3")));
        let least = sheet.numerical(
            "q_min",
            "1",
            least,
            "Minimum displacement of the exact motion, over the static deflection",
        );
        let symbol = motion.of("x_max", "θ_max");
        sheet.common_error(symbol, "the mean and the first harmonic alone taken", || {
            height * (mean() + first())
        });
        sheet.common_error(
            symbol,
            "the amplitudes of the first few harmonics added without their phases",
            || height * (mean() + harmonics().map(|(_, amplitude, _)| amplitude).sum::<f64>()),
        );
        let largest =
            sheet.step(symbol, unit, height * largest, motion.of("Maximum displacement", "Maximum angle"));
        let least = sheet.step(
            motion.of("x_min", "θ_min"),
            unit,
            height * least,
            motion.of("Minimum displacement", "Minimum angle"),
        );
        sheet.answer(
            "rms",
            motion.of("Root mean square of the displacement", "Root mean square of the angle"),
            rms,
        );
        sheet.answer("largest", motion.of("Maximum displacement", "Maximum angle"), largest);
        sheet.answer("least", motion.of("Minimum displacement", "Minimum angle"), least);
        let circle = checks::Circle {
            zeta: system.zeta.value(),
            angle: std::f64::consts::TAU / system.ratio.value(),
            drive: system.drive(),
            pieces,
        };
        sheet.verify(|| {
            let shown = [largest, least].map(|x| x.value() / height.value());
            checks::extremes(&circle, steady, shown, sheet);
        });
        let period = std::f64::consts::TAU / self.frequency;
        if let Some(time) = time {
            let share = (time.value() / period).fract();
            let why = "Displacement of the exact motion at that time, over the static deflection";
            let at = sheet.numerical("q", "1", steady.displacement(share), (why, RAO.at("§4.3")));
            let label = motion.of("Displacement at that time", "Angle at that time");
            sheet.common_error(motion.displacement(), "the mean and the first harmonic alone taken", || {
                let at = |(n, amplitude, late): (u32, f64, f64)| {
                    amplitude * (std::f64::consts::TAU * f64::from(n) * share - late).cos()
                };
                height * (mean() + harmonics().next().map_or(f64::NAN, at))
            });
            let x = sheet.step(motion.displacement(), unit, height * at, label);
            sheet.answer("displacement", label, x);
            sheet.verify(|| checks::displacement(&circle, share, x.value() / height.value(), sheet));
        }
        let height = height.value();
        sheet.show(|| {
            let shares = || (0..=240u16).map(|n| f64::from(n) / 120.0);
            let harmonics: Vec<(u32, f64, f64)> = harmonics().collect();
            let mean = mean();
            let few = |s: f64| -> f64 {
                let of = |(n, amplitude, late): &(u32, f64, f64)| {
                    amplitude * (std::f64::consts::TAU * f64::from(*n) * s - late).cos()
                };
                mean + harmonics.iter().map(of).sum::<f64>()
            };
            let curve = |of: &dyn Fn(f64) -> f64| shares().map(|s| (s * period, height * of(s))).collect();
            Exhibit::Plot(Plot::new(
                "Steady-state motion over two periods",
                Axis::linear("time", "s"),
                Axis::linear(motion.of("displacement", "angle"), unit),
                vec![
                    Series::line("exact", curve(&|s| steady.displacement(s))),
                    Series::line("sum of the listed harmonics", curve(&few)),
                    Series::line("at rest under the wave", curve(&|s| drive_at(pieces, s))),
                ],
            ))
        });
    }
}

fn drive_at(pieces: &[WaveSegment], share: f64) -> f64 {
    let share = share - share.floor();
    pieces.iter().rev().find(|piece| piece.from <= share).map_or(0.0, |piece| {
        let since = share - piece.from;
        piece.value + piece.slope * since + piece.sine * (piece.rate * since).sin()
    })
}
