//! Free vibration with dry friction of a mass on a spring, or of a body on a torsional spring.

use std::f64::consts::PI;

use dalembert_core::{
    Axis, Exhibit, Plot, Refusal, Series, Worksheet,
    exhibit::{Cell, Column, TableExhibit},
};
use dalembert_mechanics::{
    Real, sdof,
    vibration::{
        forced_coulomb,
        free::FreeMotion,
        friction::{FrictionDecay, Rest},
    },
};

use crate::{
    shared::{decay::DecayCountGiven, oscillator::motion::OscillatorMotion},
    sources::RAO,
};

mod common_errors;
mod steps;

/// The units and symbols of a motion with friction.
#[derive(Clone, Copy)]
pub(crate) struct FrictionUnits {
    motion: OscillatorMotion,
    symbol: &'static str,
    speed_symbol: &'static str,
    first: &'static str,
    turned: &'static str,
    loss: &'static str,
    rest: &'static str,
    centre: &'static str,
    displacement: &'static str,
    velocity: &'static str,
}

/// The oscillator and what follows from its friction.
struct FrictionSystem<'t, N> {
    given: &'t FrictionOscillator<N>,
    units: FrictionUnits,
    /// `F/k`
    offset: N,
    /// `F_s/k`
    hold: N,
    /// Of the viscous part; `None` where there is none.
    zeta: Option<N>,
}

impl<N> FrictionSystem<'_, N> {
    /// Chooses what belongs to the motion of the body.
    fn of<T>(&self, translation: T, rotation: T) -> T {
        self.units.motion.of(translation, rotation)
    }
}

/// The oscillator, its friction, how it starts and what is asked of it. Of a rotation, `mass` is the moment of inertia,
/// and everything else is torsional.
pub(crate) struct FrictionOscillator<N> {
    pub(crate) motion: OscillatorMotion,
    pub(crate) mass: N,
    pub(crate) stiffness: N,
    pub(crate) natural: N,
    pub(crate) force: N,
    pub(crate) static_ratio: N,
    pub(crate) damping: N,
    pub(crate) displacement: N,
    pub(crate) velocity: N,
    pub(crate) time: Option<N>,
    pub(crate) fall: Option<N>,
}

/// Two amplitudes of a decay and what was counted between them.
pub(crate) struct FrictionFromDecay<'t, W: Worksheet> {
    pub(crate) first: W::Num,
    pub(crate) last: W::Num,
    pub(crate) counted: &'t DecayCountGiven<W>,
    pub(crate) stiffness: W::Num,
    pub(crate) damping: W::Num,
}

impl FrictionUnits {
    const TRANSLATION: FrictionUnits = FrictionUnits {
        motion: OscillatorMotion::Translation,
        symbol: "x",
        speed_symbol: "v",
        first: "X₁",
        turned: "x₁",
        loss: "ΔX",
        rest: "x_R",
        centre: "x_c",
        displacement: "mm",
        velocity: "m/s",
    };
    const ROTATION: FrictionUnits = FrictionUnits {
        motion: OscillatorMotion::Rotation,
        symbol: "θ",
        speed_symbol: "Ω",
        first: "Θ₁",
        turned: "θ₁",
        loss: "ΔΘ",
        rest: "θ_R",
        centre: "θ_c",
        displacement: "deg",
        velocity: "rad/s",
    };
}

/// The natural frequency, which friction does not change.
pub(crate) fn natural_frequency<W: Worksheet>(stiffness: W::Num, mass: W::Num, sheet: W) -> W::Num {
    let natural = sheet.step(
        "ωₙ",
        "rad/s",
        sdof::natural_frequency(stiffness, mass),
        ("Natural frequency: friction does not change it", RAO.at("§2.9")),
    );
    sheet.answer("natural_frequency", "Natural frequency", natural);
    natural
}

impl<W: Worksheet> FrictionFromDecay<'_, W> {
    /// The friction force, or torque, and the cycles between the two amplitudes.
    ///
    /// # Errors
    /// Viscous damping beside it; amplitudes that do not decrease.
    pub(crate) fn force(
        &self,
        motion: OscillatorMotion,
        symbol: &'static str,
        sheet: W,
    ) -> Result<(W::Num, W::Num), Refusal> {
        let Self { first, last, counted, stiffness, damping } = *self;
        if damping.value() > 0.0 {
            return Err(Refusal::because(motion.of(
                "with viscous damping present, two amplitudes do not determine the friction: use the identification from a decay record, or write the friction force",
                "with viscous damping present, two amplitudes do not determine the friction: write the friction torque",
            )));
        }
        if first.value() <= last.value() {
            return Err(Refusal::because("the last amplitude is not below the first one: exchange them"));
        }
        let cycles = match counted {
            DecayCountGiven::Cycles { cycles } => *cycles,
            DecayCountGiven::Amplitudes { amplitudes } => {
                sheet.step("N", "1", *amplitudes - 1.0, "Successive amplitudes are one cycle apart")
            }
        };
        let units = motion.of(FrictionUnits::TRANSLATION, FrictionUnits::ROTATION);
        let loss = sheet.step(
            units.loss,
            units.displacement,
            (first - last) / cycles,
            ("Amplitude decrease per cycle: the same in each", RAO.at("§2.9")),
        );
        let why = motion.of("Amplitude decrease per cycle: 4F/k", "Amplitude decrease per cycle: 4 T_f/k_t");
        let half = || stiffness * loss / 2.0;
        sheet.common_error(symbol, "the friction loss of a half-cycle used for a whole cycle", half);
        let force = sheet.step(symbol, motion.force_unit(), stiffness * loss / 4.0, (why, RAO.at("§2.9")));
        Ok((force, cycles))
    }
}

impl<N: Real> FrictionOscillator<N> {
    /// The motion to rest, and at the times that are asked.
    ///
    /// # Errors
    /// A spring that does not overcome the friction; a target amplitude that the motion does not reach.
    pub(crate) fn solve<W: Worksheet<Num = N>>(&self, sheet: W) -> Result<(), Refusal> {
        let Self { motion, mass, stiffness, natural, force, damping, .. } = *self;
        let units = motion.of(FrictionUnits::TRANSLATION, FrictionUnits::ROTATION);
        let (symbol, why) = motion.of(
            ("f", "Friction shifts the equilibrium position to either side by F/k"),
            ("θ_f", "Friction shifts the equilibrium position to either side by T_f/k_t"),
        );
        if self.static_ratio.value() > 1.0 {
            let held = || self.static_ratio * force / stiffness;
            sheet.common_error(symbol, "the static friction used in place of the kinetic one", held);
        }
        let offset = sheet.step(symbol, units.displacement, force / stiffness, (why, RAO.at("§2.9")));
        let hold = if self.static_ratio.value() > 1.0 {
            let (symbol, why) = motion.of(
                ("fₛ", "At rest, static friction holds the mass up to this displacement"),
                ("θₛ", "At rest, static friction holds the body up to this angle"),
            );
            sheet.step(symbol, units.displacement, self.static_ratio * offset, why)
        } else {
            offset
        };
        sheet.answer("friction", motion.of("Friction force", "Friction torque"), force);
        sheet.answer("offset", "Half-width of the sticking zone", hold);
        let zeta = (damping.value() > 0.0).then(|| {
            sheet.step(
                "ζ",
                "1",
                sdof::damping_ratio(damping, stiffness, mass),
                ("Viscous damping ratio", RAO.at("§2.6")),
            )
        });
        let decay = FrictionDecay {
            motion: FreeMotion {
                natural_frequency: natural.value(),
                damping_ratio: zeta.map_or(0.0, Real::value),
                displacement: self.displacement.value(),
                velocity: self.velocity.value(),
            },
            offset: offset.value(),
            hold: hold.value(),
        };
        let rest = decay.rest();
        if rest.strokes == 0.0 {
            return Err(Refusal::because(motion.of(
                "the spring does not overcome the friction at the start: the mass remains at rest; write a larger displacement, or a velocity",
                "the torsional spring does not overcome the friction at the start: the body remains at rest; write a larger angle, or an angular velocity",
            )));
        }
        let system = FrictionSystem { given: self, units, offset, hold, zeta };
        let (position, first) = steps::to_rest(&system, &decay, &rest, sheet);
        if let Some(first) = first {
            let over_speed = || force / (natural * first.amplitude);
            sheet.common_error("c_eq", "the friction force divided by the largest velocity", over_speed);
            let equivalent = sheet.step(
                "c_eq",
                motion.damping_unit(),
                forced_coulomb::equivalent_damping(force, natural, first.amplitude),
                (
                    "Viscous damping with the same energy loss per cycle at that amplitude; it increases as the amplitude decreases",
                    RAO.at("§3.8"),
                ),
            );
            sheet.verify(|| {
                // ∫ cẋ² dt of X cos ωt over a cycle; equal steps are exact for it.
                let squares = (0..8u8).map(|n| (PI / 4.0 * f64::from(n)).sin().powi(2)).sum::<f64>();
                let peak = (first.amplitude * natural).powi(2);
                let step = N::from(PI / 4.0) / natural;
                sheet.check(
                    motion.of(
                        "work of that damper in a cycle, summed over equal steps = friction force times the distance 4X",
                        "work of that damper in a cycle, summed over equal steps = friction torque times the angle 4Θ",
                    ),
                    equivalent * peak * step * squares,
                    force * first.amplitude * 4.0,
                );
            });
            sheet.answer(
                "equivalent_damping",
                "Equivalent viscous damping at the first amplitude",
                equivalent,
            );
            if let Some(asked) = self.fall {
                steps::fall(&system, asked, &first, &decay, sheet)?;
            }
        }
        if let Some(time) = self.time {
            steps::at_time(&system, [time, position], &decay, sheet);
        }
        let asked = self.time.map(Real::value);
        sheet.show(|| Exhibit::Plot(history(&decay, &rest, asked, units)));
        sheet.show(|| Exhibit::Plot(phase_plane(&decay, &rest, units)));
        sheet.show(|| Exhibit::Table(turning_points(&decay, units)));
        Ok(())
    }
}

/// The time that is drawn.
fn span(decay: &FrictionDecay, rest: &Rest, asked: Option<f64>) -> f64 {
    let motion = &decay.motion;
    let cycle = 2.0 * PI / motion.natural_frequency;
    let slow = cycle * (1.0 + 2.0 * motion.damping_ratio);
    let usual = rest.time.map_or(2.0 * slow, |time| (1.15 * time).max(0.6 * cycle).min(12.0 * cycle));
    asked.map_or(usual, |asked| if asked < 3.0 * usual { usual.max(1.1 * asked) } else { usual })
}

fn history(decay: &FrictionDecay, rest: &Rest, asked: Option<f64>, units: FrictionUnits) -> Plot {
    let span = span(decay, rest, asked);
    let at = |n: u16| {
        let time = span * f64::from(n) / 480.0;
        (time, decay.state(time)[0])
    };
    let mut series = vec![Series::line(units.symbol, (0..=480).map(at).collect()).of("displacement")];
    if let Some((turned, first)) = decay.first_turning()
        && decay.motion.damping_ratio < 1.0
    {
        let end = rest.time.unwrap_or(span).min(span);
        let envelope = (0..=100u16).map(|n| {
            let time = turned + (end - turned) * f64::from(n) / 100.0;
            let strokes = (time - turned) / decay.half_period();
            (time, decay.turning(first.abs(), strokes).abs())
        });
        series.push(Series::line("envelope", envelope.collect()).with_reflection());
    }
    let mut plot = Plot::new(
        units.motion.of("Displacement against time", "Angle against time"),
        Axis::linear("time", "s"),
        Axis::linear(units.motion.of("displacement", "angle"), units.displacement),
        series,
    )
    .over("time")
    .level("limit of the sticking zone", decay.hold)
    .level("limit of the sticking zone", -decay.hold);
    if let Some(time) = rest.time.filter(|time| *time <= span) {
        plot = plot.mark("rest", (time, rest.position));
    }
    if let Some(time) = asked.filter(|time| *time <= span) {
        plot = plot.mark("at the requested time", (time, decay.state(time)[0]));
    }
    plot
}

fn phase_plane(decay: &FrictionDecay, rest: &Rest, units: FrictionUnits) -> Plot {
    let span = span(decay, rest, None);
    let times: Vec<f64> = (0..=480u16).map(|n| span * f64::from(n) / 480.0).collect();
    let points = times.iter().map(|time| decay.state(*time)).map(|[x, v]| (x, v)).collect();
    Plot::new(
        "Phase plane: half-turns about the two shifted equilibrium positions",
        Axis::linear(units.motion.of("displacement", "angle"), units.displacement),
        Axis::linear(units.motion.of("velocity", "angular velocity"), units.velocity),
        vec![Series::line("motion", points).of("velocity").at(times)],
    )
    .over_answer("time", "displacement")
    .mark("start", (decay.motion.displacement, decay.motion.velocity))
    .mark("rest", (rest.position, 0.0))
}

/// The turning points one by one, up to forty.
fn turning_points(decay: &FrictionDecay, units: FrictionUnits) -> TableExhibit {
    let column = |heading: &'static str, unit| Column { heading: heading.into(), unit };
    let mut rows = Vec::new();
    if let Some((turned, first)) = decay.first_turning() {
        let more = if first.abs() <= decay.hold || decay.motion.damping_ratio >= 1.0 {
            0.0
        } else {
            decay.strokes_from(first, decay.hold).min(40.0)
        };
        let mut stroke = 0.0;
        while stroke <= more {
            let time = turned + if stroke > 0.0 { stroke * decay.half_period() } else { 0.0 };
            rows.push([stroke, time, decay.turning(first, stroke)].map(Cell::Number).to_vec());
            stroke += 1.0;
        }
    }
    TableExhibit {
        title: "Turning points".into(),
        columns: vec![
            column("stroke", "1"),
            column("time", "s"),
            column(units.motion.of("displacement", "angle"), units.displacement),
        ],
        rows,
        foot: Vec::new(),
    }
}
