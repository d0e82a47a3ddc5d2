//! The load of a transient: its size, its pieces, and the steps and ramps that it is made of.

use dalembert_core::{Refusal, Worksheet};
use dalembert_mechanics::{
    Real,
    vibration::transient::{
        LoadLaw, LoadSegment, Oscillator, OscillatorState, TransientMotion, TransientOutput,
    },
};
use dalembert_numerics::quadrature::integral;

use super::{Excitation, ExcitationGiven, ForceSizeGiven, TorqueSizeGiven, cannot};
use crate::{
    shared::{
        free_motion::DampedOscillator,
        load::{self, LoadHistory, LoadHistoryGiven},
        oscillator::motion::OscillatorMotion,
    },
    sources::{RAO, THOMSON},
};

/// A load and the motion under it.
pub(super) struct LoadModel<N> {
    /// The displacement that the size of the load would hold: what the terms are multiples of.
    pub(super) size: Option<N>,
    /// Duration of a pulse.
    pub(super) duration: Option<N>,
    /// Terms of the superposition; `None` for a table.
    pub(super) terms: Option<Vec<LoadTerm<N>>>,
    /// The motion.
    pub(super) motion: TransientMotion,
    /// End of the load.
    pub(super) end: Option<f64>,
    /// True if the load remains at its final value.
    pub(super) is_held: bool,
    pieces: Vec<LoadSegment>,
}

/// A response that begins at a moment.
pub(super) struct LoadTerm<N> {
    /// Onset time; time zero if `None`.
    pub(super) onset: Option<N>,
    /// Unit load that it is the response to.
    pub(super) unit: Unit<N>,
    /// Weight of the unit response.
    pub(super) weight: Weight<N>,
    /// True if the term is subtracted.
    pub(super) negative: bool,
}

/// Unit load of a term.
pub(super) enum Unit<N> {
    /// A unit displacement at the start.
    Release,
    /// A unit velocity at the start.
    Impulse,
    /// A unit step.
    Step,
    /// A ramp of one a second.
    Ramp,
    /// A sine of that frequency, at that ratio to the natural one.
    Sine(N, N),
    /// An exponential of that time constant.
    Exponential(N),
    /// `1 − e^(−t/τ)` of that time constant.
    Rise(N),
    /// A versed sine of that frequency, at that ratio to the natural one.
    Versine(N, N),
    /// `t²/2` with `t` in seconds.
    Parabola,
}

/// A factor of a term.
pub(super) enum Weight<N> {
    One,
    Times(N),
    Over(N),
}

impl<N: Real> LoadModel<N> {
    /// Time of the last change of the law of the load.
    pub(super) fn last_change(&self) -> f64 {
        let last = self.pieces.last().map_or(0.0, |piece| match piece.law {
            LoadLaw::Decay { rate, .. } | LoadLaw::Rise { rate, .. } => piece.from + 3.0 / rate,
            LoadLaw::Line { slope, .. } if slope != 0.0 => piece.from + 1.0,
            _ => piece.from,
        });
        if last.is_finite() { last } else { 0.0 }
    }

    /// Area under a pulse, over that of the rectangle about it.
    pub(super) fn share(&self) -> Option<f64> {
        let (size, duration) = (self.size?.value(), self.duration?.value());
        let ends = self.pieces.iter().skip(1).map(|next| next.from).chain([duration]);
        let area = |(piece, end): (&LoadSegment, f64)| {
            integral(|time| piece.law.at(time - piece.from), [piece.from, end], 8)
        };
        Some(self.pieces.iter().zip(ends).map(area).sum::<f64>() / (size * duration))
    }

    /// Restoring displacement of spring and damper at a time, by the Duhamel integral over unit impulses.
    pub(super) fn by_impulses(&self, natural: f64, ratio: f64, time: f64) -> Option<f64> {
        let begun = self.motion.at(0.0);
        load::by_impulses(
            Oscillator { natural, ratio },
            begun,
            &self.pieces,
            TransientOutput::support(ratio),
            time,
        )
    }

    /// Returns true if the load or its rate is discontinuous at a time.
    pub(super) fn jumps_at(&self, time: f64) -> bool {
        self.pieces.iter().any(|piece| (piece.from - time).abs() <= 1e-9 * time)
    }
}

/// Writes the size of the load and gathers what it is made of.
pub(super) fn model<W: Worksheet>(
    excitation: &Excitation,
    given: &ExcitationGiven<W>,
    system: &DampedOscillator<W::Num>,
    sheet: W,
) -> Result<LoadModel<W::Num>, Refusal> {
    let (natural, motion) = (system.natural.value(), system.motion);
    let start = |state: OscillatorState, pieces: Vec<LoadSegment>| {
        let oscillator = Oscillator { natural, ratio: system.ratio.value() };
        TransientMotion::new(oscillator, state, &pieces).map(|motion| (motion, pieces)).map_err(cannot)
    };
    let stiffness = || system.body.map(|body| body.stiffness).ok_or_else(|| massless(motion));
    match (excitation, given) {
        (Excitation::Force { course, .. }, ExcitationGiven::Force { size, course: course_given }) => {
            let force = match size {
                ForceSizeGiven::Largest { force } => *force,
                ForceSizeGiven::Impulse { impulse } => from_impulse(motion, *impulse, course_given, sheet)?,
            };
            let why = ("Static displacement under the maximum force", RAO.at("§4.6"));
            let size = sheet.step("δ", "mm", force / stiffness()?, why);
            of_course(size, size.value(), course, course_given, system, start, sheet)
        }
        (Excitation::Torque { course, .. }, ExcitationGiven::Torque { size, course: course_given }) => {
            let torque = match size {
                TorqueSizeGiven::Largest { torque } => *torque,
                TorqueSizeGiven::Impulse { impulse } => from_impulse(motion, *impulse, course_given, sheet)?,
            };
            let why = ("Static angle under the maximum torque", RAO.at("§4.6"));
            let size = sheet.step("θ_st", "rad", torque / stiffness()?, why);
            of_course(size, size.value(), course, course_given, system, start, sheet)
        }
        (
            Excitation::BaseAcceleration { course, .. } | Excitation::BaseRotation { course, .. },
            ExcitationGiven::BaseAcceleration { acceleration, course: course_given }
            | ExcitationGiven::BaseRotation { acceleration, course: course_given },
        ) => {
            let why = motion.of(
                "The mass relative to the base moves as under the force −m ÿ: static displacement under its maximum value",
                "The body relative to the base rotates as under the torque −J α: static angle under its maximum value",
            );
            let (symbol, unit) = (motion.deflection(), motion.displacement_unit());
            let size = -(*acceleration / system.natural.powi(2));
            let size = sheet.step(symbol, unit, size, (why, THOMSON.at("§4.2")));
            of_course(size, size.value(), course, course_given, system, start, sheet)
        }
        (Excitation::ForceTable { points }, _) => {
            let points: Vec<_> = points.iter().map(|point| (point.time, point.force)).collect();
            let table = load::table(&points)?;
            let pieces = load::scaled(&table.pieces, 1.0 / stiffness()?.value());
            Ok(of_table(start(OscillatorState::default(), pieces)?, table.end))
        }
        (Excitation::TorqueTable { points }, _) => {
            let points: Vec<_> = points.iter().map(|point| (point.time, point.torque)).collect();
            let table = load::table(&points)?;
            let pieces = load::scaled(&table.pieces, 1.0 / stiffness()?.value());
            Ok(of_table(start(OscillatorState::default(), pieces)?, table.end))
        }
        (Excitation::BaseTable { points }, _) => {
            let points: Vec<_> = points.iter().map(|point| (point.time, point.acceleration)).collect();
            let table = load::table(&points)?;
            let pieces = load::scaled(&table.pieces, -1.0 / (natural * natural));
            Ok(of_table(start(OscillatorState::default(), pieces)?, table.end))
        }
        (_, ExcitationGiven::Impulse { impulse } | ExcitationGiven::AngularImpulse { impulse }) => {
            let mass = system.body.ok_or_else(|| massless(motion))?.mass;
            let why = motion.of(
                "The impulse instantaneously gives the mass its momentum",
                "The angular impulse instantaneously gives the body its angular momentum",
            );
            let (symbol, unit) = motion.of(("v₀", "m/s"), ("Ω₀", "rad/s"));
            let velocity = sheet.step(symbol, unit, *impulse / mass, (why, RAO.at("§4.5")));
            let state = OscillatorState { displacement: 0.0, velocity: velocity.value() };
            Ok(free(start(state, Vec::new())?, vec![LoadTerm::new(Unit::Impulse).times(velocity)]))
        }
        (
            _,
            ExcitationGiven::Initial { displacement, velocity }
            | ExcitationGiven::InitialRotation { angle: displacement, rate: velocity },
        ) => {
            let state = OscillatorState { displacement: displacement.value(), velocity: velocity.value() };
            if state == OscillatorState::default() {
                return Err(Refusal::because(
                    "without an initial displacement or velocity nothing moves: write at least one of them",
                ));
            }
            let mut terms = Vec::new();
            if state.displacement != 0.0 {
                terms.push(LoadTerm::new(Unit::Release).times(*displacement));
            }
            if state.velocity != 0.0 {
                terms.push(LoadTerm::new(Unit::Impulse).times(*velocity));
            }
            Ok(free(start(state, Vec::new())?, terms))
        }
        _ => unreachable!("what is given is made from the excitation"),
    }
}

type Begun = (TransientMotion, Vec<LoadSegment>);

fn of_table<N>((motion, pieces): Begun, end: Option<f64>) -> LoadModel<N> {
    LoadModel { size: None, duration: None, terms: None, motion, end, is_held: false, pieces }
}

fn free<N>((motion, pieces): Begun, terms: Vec<LoadTerm<N>>) -> LoadModel<N> {
    LoadModel { size: None, duration: None, terms: Some(terms), motion, end: None, is_held: false, pieces }
}

fn of_course<W: Worksheet>(
    size: W::Num,
    value: f64,
    course: &LoadHistory,
    given: &LoadHistoryGiven<W>,
    system: &DampedOscillator<W::Num>,
    start: impl Fn(OscillatorState, Vec<LoadSegment>) -> Result<Begun, Refusal>,
    sheet: W,
) -> Result<LoadModel<W::Num>, Refusal> {
    let built = course.pieces(value)?;
    let (motion, pieces) = start(OscillatorState::default(), built.pieces)?;
    let duration = match given {
        LoadHistoryGiven::Rectangular { duration }
        | LoadHistoryGiven::Triangular { duration, .. }
        | LoadHistoryGiven::HalfSine { duration }
        | LoadHistoryGiven::VersedSine { duration }
        | LoadHistoryGiven::Parabola { duration, .. } => Some(*duration),
        _ => None,
    };
    let is_held = matches!(
        course,
        LoadHistory::Step | LoadHistory::RampStep { .. } | LoadHistory::ExponentialRise { .. }
    );
    let terms = terms(given, system, sheet);
    Ok(LoadModel { size: Some(size), duration, terms: Some(terms), motion, end: built.end, is_held, pieces })
}

/// Terms of a time history as a superposition.
fn terms<W: Worksheet>(
    given: &LoadHistoryGiven<W>,
    system: &DampedOscillator<W::Num>,
    sheet: W,
) -> Vec<LoadTerm<W::Num>> {
    match given {
        LoadHistoryGiven::Step {} => vec![LoadTerm::new(Unit::Step)],
        LoadHistoryGiven::Ramp { rise } => vec![LoadTerm::new(Unit::Ramp).over(*rise)],
        LoadHistoryGiven::RampStep { rise } => {
            vec![LoadTerm::new(Unit::Ramp).over(*rise), LoadTerm::new(Unit::Ramp).over(*rise).less(*rise)]
        }
        LoadHistoryGiven::Exponential { constant } => vec![LoadTerm::new(Unit::Exponential(*constant))],
        LoadHistoryGiven::Rectangular { duration } => {
            vec![LoadTerm::new(Unit::Step), LoadTerm::new(Unit::Step).less(*duration)]
        }
        LoadHistoryGiven::Triangular { duration, peak } => {
            let peak = match peak {
                Some(peak) => *peak,
                None => sheet.step("t_p", "s", *duration / 2.0, "The peak is at the middle of the pulse"),
            };
            triangle(*duration, peak)
        }
        LoadHistoryGiven::HalfSine { duration } => {
            let why = "Frequency of the sine of which the pulse is one half-wave";
            let frequency = sheet.step("Ω", "rad/s", W::Num::from(std::f64::consts::PI) / *duration, why);
            let ratio = sheet.step("r", "1", frequency / system.natural, "Frequency ratio of that sine");
            let sine = || LoadTerm::new(Unit::Sine(frequency, ratio));
            vec![sine(), sine().after(*duration)]
        }
        LoadHistoryGiven::VersedSine { duration } => {
            let why = "Frequency of the cosine of which the pulse is one wave";
            let frequency = sheet.step("Ω", "rad/s", W::Num::from(std::f64::consts::TAU) / *duration, why);
            let ratio = sheet.step("r", "1", frequency / system.natural, "Frequency ratio of that cosine");
            let versine = || LoadTerm::new(Unit::Versine(frequency, ratio));
            vec![versine(), versine().less(*duration)]
        }
        LoadHistoryGiven::ExponentialRise { constant } => vec![LoadTerm::new(Unit::Rise(*constant))],
        LoadHistoryGiven::Parabola { duration, constant, linear, quadratic } => {
            parabola(*duration, [*constant, *linear, *quadratic])
        }
    }
}

/// A parabola: step, ramp and `t²/2` at its start, and those that take it away at its end.
fn parabola<N: Real>(duration: N, [constant, linear, quadratic]: [N; 3]) -> Vec<LoadTerm<N>> {
    let begun = [constant, linear / duration, quadratic * 2.0 / duration.powi(2)];
    let ended = [
        constant + linear + quadratic,
        (linear + quadratic * 2.0) / duration,
        quadratic * 2.0 / duration.powi(2),
    ];
    let units = [|| Unit::Step, || Unit::Ramp, || Unit::Parabola];
    let terms = |sizes: [N; 3]| {
        let all = sizes.into_iter().zip(units).filter(|(size, _)| size.value() != 0.0);
        all.map(|(size, unit)| LoadTerm::new(unit()).times(size)).collect::<Vec<_>>()
    };
    let off = terms(ended).into_iter().map(|term| term.less(duration));
    terms(begun).into_iter().chain(off).collect()
}

/// A triangle: ramps that begin at its corners.
fn triangle<N: Real>(duration: N, peak: N) -> Vec<LoadTerm<N>> {
    if peak.value() == 0.0 {
        return vec![
            LoadTerm::new(Unit::Step),
            LoadTerm { negative: true, ..LoadTerm::new(Unit::Ramp).over(duration) },
            LoadTerm::new(Unit::Ramp).over(duration).after(duration),
        ];
    }
    let rise = LoadTerm::new(Unit::Ramp).over(peak);
    if peak.value() >= duration.value() {
        return vec![
            rise,
            LoadTerm::new(Unit::Ramp).over(duration).less(duration),
            LoadTerm::new(Unit::Step).less(duration),
        ];
    }
    vec![
        rise,
        LoadTerm::new(Unit::Ramp).times(duration / (peak * (duration - peak))).less(peak),
        LoadTerm::new(Unit::Ramp).over(duration - peak).after(duration),
    ]
}

/// The largest force of a pulse whose impulse is known.
fn from_impulse<W: Worksheet>(
    motion: OscillatorMotion,
    impulse: W::Num,
    course: &LoadHistoryGiven<W>,
    sheet: W,
) -> Result<W::Num, Refusal> {
    let (force, why) = match course {
        LoadHistoryGiven::Rectangular { duration } => {
            (impulse / *duration, "Maximum of the load: the impulse is the area of the rectangle, F₀t_d")
        }
        LoadHistoryGiven::Triangular { duration, .. } => (
            impulse * 2.0 / *duration,
            "Maximum of the load: the impulse is the area of the triangle, F₀t_d/2",
        ),
        LoadHistoryGiven::HalfSine { duration } => (
            impulse * std::f64::consts::PI / (*duration * 2.0),
            "Maximum of the load: the impulse is the area of the half sine, 2F₀t_d/π",
        ),
        LoadHistoryGiven::Exponential { constant } => {
            (impulse / *constant, "Maximum of the load: the impulse is the area under the exponential, F₀τ")
        }
        LoadHistoryGiven::VersedSine { duration } => (
            impulse * 2.0 / *duration,
            "Maximum of the load: the impulse is the area of the versed sine, half that of its rectangle",
        ),
        LoadHistoryGiven::Parabola { duration, constant, linear, quadratic } => {
            let share = *constant + *linear / 2.0 + *quadratic / 3.0;
            if share.value() <= 0.0 {
                return Err(Refusal::because(
                    "the area under this parabola is not positive, and gives no maximum for an impulse: give the maximum, or other coefficients",
                ));
            }
            let why = "Maximum of the load: the impulse is the area under the parabola, (a₀ + a₁/2 + a₂/3) of its rectangle";
            (impulse / (*duration * share), why)
        }
        LoadHistoryGiven::Step {}
        | LoadHistoryGiven::Ramp { .. }
        | LoadHistoryGiven::RampStep { .. }
        | LoadHistoryGiven::ExponentialRise { .. } => {
            return Err(Refusal::because(
                "a sustained load has no finite impulse: give its maximum, or choose a pulse",
            ));
        }
    };
    Ok(sheet.step(motion.of("F₀", "T₀"), motion.force_unit(), force, why))
}

fn massless(motion: OscillatorMotion) -> Refusal {
    Refusal::because(motion.of(
        "a force moves a mass: give the mass in addition to the natural frequency",
        "a torque moves a moment of inertia: give it in addition to the natural frequency",
    ))
}

impl<N: Real> LoadTerm<N> {
    fn new(unit: Unit<N>) -> Self {
        Self { onset: None, unit, weight: Weight::One, negative: false }
    }
    fn times(self, factor: N) -> Self {
        Self { weight: Weight::Times(factor), ..self }
    }
    fn over(self, divisor: N) -> Self {
        Self { weight: Weight::Over(divisor), ..self }
    }
    fn after(self, onset: N) -> Self {
        Self { onset: Some(onset), ..self }
    }
    fn less(self, onset: N) -> Self {
        Self { negative: true, ..self.after(onset) }
    }
}
