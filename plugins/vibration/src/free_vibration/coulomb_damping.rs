//! Free vibration with dry friction, alone or beside viscous damping.

use std::f64::consts::PI;

use dalembert_core::{
    About, Analysis, Axis, Drawing, Exhibit, Inputs, Plot, Refusal, Series, Sketch, Worksheet,
    exhibit::{Cell, Column, TableExhibit},
    register,
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
    shared::{
        decay::{DecayCount, DecayCountGiven},
        oscillator::{Mass, given_weight, mass},
    },
    sources::{GROVER, RAO},
};

mod steps;

/// A mass on a spring that rubs, how it starts, and what is asked of it.
#[derive(Clone, Debug, Inputs)]
pub struct CoulombDamping {
    /// Mass or weight.
    pub mass: Mass,
    /// Stiffness.
    #[input("k", "N/m", positive)]
    pub stiffness: f64,
    /// Friction.
    pub friction: FrictionForce,
    /// Static friction over kinetic friction.
    #[input("µₛ/µ", "1", min = 1, default = "1")]
    pub static_ratio: f64,
    /// Viscous damping in addition to friction.
    #[input("c", "N*s/m", nonnegative, default = "0 N*s/m")]
    pub damping: f64,
    /// Initial displacement.
    /// From the position in which the spring is unloaded.
    #[input("x₀", "m")]
    pub displacement: f64,
    /// Initial velocity.
    #[input("v₀", "m/s", default = "0 m/s")]
    pub velocity: f64,
    /// Time at which the motion is required.
    #[input("t", "s", nonnegative)]
    pub time: Option<f64>,
    /// Target amplitude of the decay.
    #[input("Xₐ", "m", positive)]
    pub fall: Option<f64>,
}

/// Friction force, or the coefficient that gives it.
#[derive(Clone, Debug, Inputs)]
pub enum FrictionForce {
    /// Friction force given
    Force {
        /// Friction force.
        #[input("F", "N", positive)]
        force: f64,
    },
    /// Coefficient of friction on a horizontal surface
    Coefficient {
        /// Coefficient of friction.
        #[input("µ", "1", positive)]
        coefficient: f64,
        /// Gravity.
        #[input("g", "m/s^2", positive, default = "9.81 m/s^2")]
        gravity: f64,
    },
    /// Coefficient of friction and normal force
    Normal {
        /// Coefficient of friction.
        #[input("µ", "1", positive)]
        coefficient: f64,
        /// Normal force.
        #[input("N", "N", positive)]
        normal: f64,
    },
    /// From the decrease of the amplitude
    Decay {
        /// First amplitude.
        #[input("X₁", "m", positive)]
        first_amplitude: f64,
        /// Last amplitude.
        #[input("X₂", "m", positive)]
        last_amplitude: f64,
        /// Counted quantity.
        counted: DecayCount,
        /// Gravity.
        /// For the coefficient of friction on a horizontal surface.
        #[input("g", "m/s^2", positive, default = "9.81 m/s^2")]
        gravity: f64,
    },
}

register!(CoulombDamping);

impl Analysis for CoulombDamping {
    const ABOUT: About = About {
        id: "vibration/coulomb-damping",
        title: "Free vibration with dry friction",
        topic: "Free vibration",
        summary: "Amplitude decrease, number of cycles, stopping time and position, and exact motion of a mass with dry friction; friction from a decay.",
        keywords: "coulomb friction dry damping linear decay rest position stop sliding block atrito seco \
                   amortecimento de coulomb decaimento linear parada",
        sources: &[&RAO, &GROVER],
        cases: include_str!("../../cases/coulomb_damping.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &CoulombDampingGiven<W>, sheet: W) -> Result<(), Refusal> {
        let mass = mass(&given.mass, sheet);
        let natural = sheet.step(
            "ωₙ",
            "rad/s",
            sdof::natural_frequency(given.stiffness, mass),
            ("Natural frequency: friction does not change it", RAO.at("§2.9")),
        );
        sheet.answer("natural_frequency", "Natural frequency", natural);
        let force = friction(given, mass, sheet)?;
        let offset = sheet.step(
            "f",
            "mm",
            force / given.stiffness,
            ("Friction shifts the equilibrium position to either side by F/k", RAO.at("§2.9")),
        );
        let hold = if self.static_ratio > 1.0 {
            sheet.step(
                "fₛ",
                "mm",
                given.static_ratio * offset,
                "At rest, static friction holds the mass up to this displacement",
            )
        } else {
            offset
        };
        sheet.answer("friction", "Friction force", force);
        sheet.answer("offset", "Half-width of the dead zone", hold);
        let zeta = (self.damping > 0.0).then(|| {
            sheet.step(
                "ζ",
                "1",
                sdof::damping_ratio(given.damping, given.stiffness, mass),
                ("Viscous damping ratio", RAO.at("§2.6")),
            )
        });
        let decay = FrictionDecay {
            motion: FreeMotion {
                natural_frequency: natural.value(),
                damping_ratio: zeta.map_or(0.0, Real::value),
                displacement: self.displacement,
                velocity: self.velocity,
            },
            offset: offset.value(),
            hold: hold.value(),
        };
        let rest = decay.rest();
        if rest.strokes == 0.0 {
            return Err(Refusal::because(
                "the spring does not overcome the friction at the start: the mass remains at rest; write a larger displacement, or a velocity",
            ));
        }
        let system = steps::CoulombSystem { mass, natural, force, offset, hold, zeta };
        let (position, first) = steps::to_rest(&system, given, &decay, &rest, sheet);
        if let Some(first) = first {
            let equivalent = sheet.step(
                "c_eq",
                "N*s/m",
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
                let step = W::Num::from(PI / 4.0) / natural;
                sheet.check(
                    "work of that damper in a cycle, summed over equal steps = friction force times the distance 4X",
                    equivalent * peak * step * squares,
                    force * first.amplitude * 4.0,
                );
            });
            sheet.answer(
                "equivalent_damping",
                "Equivalent viscous damping at the first amplitude",
                equivalent,
            );
            if let Some(asked) = given.fall {
                steps::fall(&system, asked, &first, &decay, sheet)?;
            }
        }
        if let Some(time) = given.time {
            steps::at_time(&system, given, [time, position], &decay, sheet);
        }
        sheet.show(|| Exhibit::Plot(history(&decay, &rest, self.time)));
        sheet.show(|| Exhibit::Plot(phase_plane(&decay, &rest)));
        sheet.show(|| Exhibit::Table(turning_points(&decay)));
        sheet.show(|| Exhibit::Drawing(drawing(self.damping > 0.0)));
        Ok(())
    }
}

/// The friction force.
fn friction<W: Worksheet>(given: &CoulombDampingGiven<W>, mass: W::Num, sheet: W) -> Result<W::Num, Refusal> {
    let why = ("Friction force", RAO.at("§2.9"));
    Ok(match &given.friction {
        FrictionForceGiven::Force { force } => *force,
        FrictionForceGiven::Coefficient { coefficient, gravity } => {
            let force = match given_weight(&given.mass, *gravity) {
                Some(weight) => *coefficient * weight,
                None => *coefficient * mass * *gravity,
            };
            sheet.step("F", "N", force, why)
        }
        FrictionForceGiven::Normal { coefficient, normal } => {
            sheet.step("F", "N", *coefficient * *normal, why)
        }
        FrictionForceGiven::Decay { first_amplitude: first, last_amplitude: last, counted, gravity } => {
            if given.damping.value() > 0.0 {
                return Err(Refusal::because(
                    "with viscous damping present, two amplitudes do not determine the friction: use the identification from a decay record, or write the friction force",
                ));
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
            let loss = sheet.step(
                "ΔX",
                "mm",
                (*first - *last) / cycles,
                ("Amplitude decrease per cycle: the same in each", RAO.at("§2.9")),
            );
            let force = sheet.step(
                "F",
                "N",
                given.stiffness * loss / 4.0,
                ("Amplitude decrease per cycle: 4F/k", RAO.at("§2.9")),
            );
            let weight = given_weight(&given.mass, *gravity).unwrap_or_else(|| mass * *gravity);
            let coefficient =
                sheet.step("µ", "1", force / weight, "Coefficient of friction on a horizontal surface");
            sheet.check(
                "the energy difference between the two amplitudes is the friction work over the path",
                given.stiffness * (first.powi(2) - last.powi(2)) / 2.0,
                coefficient * weight * cycles * (*first + *last) * 2.0,
            );
            sheet.answer("friction_coefficient", "Coefficient of friction", coefficient);
            force
        }
    })
}

/// The time that is drawn.
fn span(decay: &FrictionDecay, rest: &Rest, asked: Option<f64>) -> f64 {
    let motion = &decay.motion;
    let cycle = 2.0 * PI / motion.natural_frequency;
    let slow = cycle * (1.0 + 2.0 * motion.damping_ratio);
    let usual = rest.time.map_or(2.0 * slow, |time| (1.15 * time).max(0.6 * cycle).min(12.0 * cycle));
    asked.map_or(usual, |asked| if asked < 3.0 * usual { usual.max(1.1 * asked) } else { usual })
}

fn history(decay: &FrictionDecay, rest: &Rest, asked: Option<f64>) -> Plot {
    let span = span(decay, rest, asked);
    let at = |n: u16| {
        let time = span * f64::from(n) / 480.0;
        (time, decay.state(time)[0])
    };
    let mut series = vec![Series::line("x", (0..=480).map(at).collect()).of("displacement")];
    if let Some((turned, first)) = decay.first_turning()
        && decay.motion.damping_ratio < 1.0
    {
        let end = rest.time.unwrap_or(span).min(span);
        let envelope = |sign: f64| {
            (0..=100u16).map(move |n| {
                let time = turned + (end - turned) * f64::from(n) / 100.0;
                let strokes = (time - turned) / decay.half_period();
                (time, sign * decay.turning(first.abs(), strokes).abs())
            })
        };
        let gap = std::iter::once((f64::INFINITY, f64::INFINITY));
        series.push(Series::line("envelope", envelope(1.0).chain(gap).chain(envelope(-1.0)).collect()));
    }
    let mut plot = Plot::new(
        "Displacement against time",
        Axis::linear("time", "s"),
        Axis::linear("displacement", "mm"),
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

fn phase_plane(decay: &FrictionDecay, rest: &Rest) -> Plot {
    let span = span(decay, rest, None);
    let times: Vec<f64> = (0..=480u16).map(|n| span * f64::from(n) / 480.0).collect();
    let points = times.iter().map(|time| decay.state(*time)).map(|[x, v]| (x, v)).collect();
    Plot::new(
        "Phase plane: half-turns about the two shifted equilibrium positions",
        Axis::linear("displacement", "mm"),
        Axis::linear("velocity", "m/s"),
        vec![Series::line("motion", points).of("velocity").at(times)],
    )
    .over_answer("time", "displacement")
    .mark("start", (decay.motion.displacement, decay.motion.velocity))
    .mark("rest", (rest.position, 0.0))
}

/// The turning points one by one, up to forty.
fn turning_points(decay: &FrictionDecay) -> TableExhibit {
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
        columns: vec![column("stroke", "1"), column("time", "s"), column("displacement", "mm")],
        rows,
        foot: Vec::new(),
    }
}

fn drawing(damped: bool) -> Drawing {
    let mut sketch = Sketch::new("The mass on its spring, with friction");
    sketch
        .ground((-2.4, 1.2), (-2.4, -0.7))
        .ground((-2.4, -0.7), (2.0, -0.7))
        .spring("k", (-2.4, 0.3), (-0.7, 0.3))
        .mass("m", (-0.7, -0.7), (0.7, 0.7))
        .force("F", (1.6, -0.55), (0.75, -0.55))
        .motion("x", (0.0, 1.0), (0.9, 1.0));
    if damped {
        sketch.damper("c", (-2.4, -0.3), (-0.7, -0.3));
    }
    sketch.finish()
}
