//! A plane mechanism of any shape, described by its parts: how it moves, what drives it, and what its joints carry.

mod centres;
mod equations;
mod joints;
mod loops;
mod pictures;
mod points;
mod transmission;
mod virtual_power;

use std::f64::consts::TAU;

use dalembert_core::{About, Analysis, Exhibit, Inputs, Reference, Refusal, Text, Worksheet, register};
use dalembert_mechanics::{
    Real,
    planar::{InverseDynamics, Model, PlanarError, PlanarState, SweepResult},
};
use nalgebra::Vector3;

use crate::{
    shared::parts::{Connection, Drive, Driven, NamedLoad, Part, Parts, Spot, closure},
    sources::{HAUG, NIKRAVESH, RIUL},
};

/// A mechanism in the plane, drawn in x and y.
///
/// Each body has axes of its own, in which its points are given; joints bring the points together. Angles and
/// couples are positive counter-clockwise.
#[derive(Clone, Debug, Inputs)]
pub struct Mechanism {
    /// Bodies.
    #[input(min = 1)]
    pub bodies: Vec<Part>,
    /// Points.
    pub points: Vec<Spot>,
    /// Joints.
    pub joints: Vec<Connection>,
    /// Drivers.
    /// One for each degree of freedom: what moves the mechanism, or holds it in place.
    pub drivers: Vec<Drive>,
    /// Loads.
    pub loads: Vec<NamedLoad>,
    /// Acceleration of gravity.
    #[input("g", "m/s^2", planar, default = "(0; -9.81) m/s^2")]
    pub gravity: Vector3<f64>,
    /// Points whose motion is computed.
    pub watched: Vec<WatchedPoint>,
    /// Points whose relative motion is computed.
    pub relative: Vec<RelativePoint>,
    /// Range of the first driver in the plots.
    #[input(default = "turn")]
    pub range: Range,
}

/// A point whose motion is asked for.
#[derive(Clone, Debug, Inputs)]
pub struct WatchedPoint {
    /// Point.
    #[input(rows = "points")]
    pub point: Reference,
}

/// A point whose motion relative to another is asked for.
#[derive(Clone, Debug, Inputs)]
pub struct RelativePoint {
    /// Point.
    #[input(rows = "points")]
    pub point: Reference,
    /// Relative to.
    #[input(rows = "points")]
    pub to: Reference,
}

/// The values that the first driver goes through.
#[derive(Clone, Debug, Inputs)]
pub enum Range {
    /// One revolution, or up to the limit positions
    Turn,
    /// Angles
    Angles {
        /// From.
        #[input("θ_a", "deg")]
        from: f64,
        /// To.
        #[input("θ_b", "deg")]
        to: f64,
    },
    /// Lengths
    Lengths {
        /// From.
        #[input("s_a", "mm")]
        from: f64,
        /// To.
        #[input("s_b", "mm")]
        to: f64,
    },
    /// This position only
    Nothing,
}

register!(Mechanism);

impl Analysis for Mechanism {
    const ABOUT: About = About {
        id: "virtual-work/mechanism",
        title: "Plane mechanism",
        topic: "Any mechanism",
        summary: "Motion, driving forces and torques by virtual power, and reactions of an arbitrary plane mechanism: bodies, joints, drivers and loads.",
        main: &["effort", "angular_velocity", "velocity", "angle", "position"],
        keywords: "cam gears rack came engrenagens cremalheira mecanismo plano barras manivela articulação \
                   virtual power potência virtual newton euler multibody linkage joints reactions six-bar gears \
                   cord slot spring geral build your own centro instantâneo instant centre kennedy diagrama \
                   polar hodógrafo hodograph shaking force trepidação ângulo de transmissão transmission angle \
                   instantaneous center of velocity kinetostatics cinetostática Geneva wheel cruz de malta",
        sources: &[&RIUL, &NIKRAVESH, &HAUG],
        cases: include_str!("../../cases/mechanism.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &MechanismGiven<W>, sheet: W) -> Result<(), Refusal> {
        let parts = self.parts()?;
        let (system, rows, positions) = parts.assembled(sheet)?;
        let refuse = |error: PlanarError| parts.refusal(&error, &rows);
        let mobility = system.mobility(&positions).map_err(refuse)?;
        let (state, dynamics) = system.kinetostatics(&positions).map_err(refuse)?;
        sheet.keep_going()?;
        let this = Solved { parts: &parts, rows: &rows, system: &system, state: &state, dynamics: &dynamics };
        let (angular, is_closed) = self.motion(&this, given, sheet);
        this.efforts(given, &angular, sheet);
        this.reactions(mobility.redundant.is_empty(), sheet);
        if !mobility.redundant.is_empty() {
            let mut named: Vec<&str> =
                mobility.redundant.iter().map(|joint| parts.joints[rows[*joint]].name.as_str()).collect();
            named.dedup();
            sheet.warn(|| {
                Text::new("redundant constraints at {joints}: the mechanism moves, but statics does not determine how the joints share their forces")
                    .with("joints", named.join(", "))
            });
        }
        let samples = self.through(&this, sheet)?;
        sheet.keep_going()?;
        if !is_closed {
            sheet.show(|| Exhibit::Table(this.table_of_constraints()));
            sheet.show(|| Exhibit::Table(this.table_of_velocity_equations()));
        }
        this.show(self, &samples, sheet);
        Ok(())
    }
}

/// A solved position.
struct Solved<'a> {
    parts: &'a Parts,
    /// The row of each joint.
    rows: &'a [usize],
    system: &'a Model,
    state: &'a PlanarState,
    dynamics: &'a InverseDynamics,
}

/// One position of the range.
struct Sample {
    /// The first driver.
    value: f64,
    state: PlanarState,
    /// The multiplier of each equation: those of the joints, then the effort of each driver.
    multipliers: Vec<f64>,
}

impl Mechanism {
    fn parts(&self) -> Result<Parts, Refusal> {
        let described = (&self.bodies[..], &self.points[..], &self.joints[..]);
        Parts::new(self.gravity, described, &self.drivers, &self.loads)
    }

    /// Answers the positions, velocities and accelerations of the bodies; returns their angular accelerations, and whether
    /// all of their angles have a closed form.
    fn motion<W: Worksheet>(
        &self,
        this: &Solved<'_>,
        given: &MechanismGiven<W>,
        sheet: W,
    ) -> (Vec<W::Num>, bool) {
        let mut closed = loops::Loops::worked(this, self, given, sheet);
        let mut angular = Vec::with_capacity(self.bodies.len());
        let mut shown = this.state.clone();
        let PlanarState { positions, velocities, accelerations } = this.state;
        for (body, part) in this.parts.bodies.iter().enumerate() {
            let row = body + 1;
            let named = |reason: &'static str| Text::new(reason).with("name", &part.name);
            let (known, speed) =
                closed.body(body).map_or((None, None), |(angle, speed)| (Some(angle), speed));
            let angle = known.unwrap_or_else(|| {
                let why = named("Angle of {name}: joint constraints, Φ(q) = 0, solved by Newton's method");
                let why = (why, NIKRAVESH.at("ch. 3"));
                sheet.numerical(("θ_c", row), "deg", positions[body][2], why)
            });
            sheet.answer(("angle", row), "Angle of the body", angle);
            sheet.row_label(("angle", row), &part.name);
            let speed = speed.unwrap_or_else(|| {
                let why =
                    named("Angular velocity of {name}, from the joint and driving constraints, Φ_q q̇ = −Φ_t");
                let why = (why, NIKRAVESH.at("ch. 3"));
                sheet.numerical(("ω_c", row), "rad/s", velocities[body][2], why)
            });
            sheet.answer(("angular_velocity", row), "Angular velocity of the body", speed);
            sheet.row_label(("angular_velocity", row), &part.name);
            let acceleration = sheet.numerical(
                ("α_c", row),
                "rad/s^2",
                accelerations[body][2],
                (named("Angular acceleration of {name}, from Φ_q q̈ = γ"), NIKRAVESH.at("ch. 3")),
            );
            sheet.answer(("angular_acceleration", row), "Angular acceleration of the body", acceleration);
            sheet.row_label(("angular_acceleration", row), &part.name);
            for (of_bodies, number) in [
                (&mut shown.positions, angle),
                (&mut shown.velocities, speed),
                (&mut shown.accelerations, acceleration),
            ] {
                of_bodies[body][2] = number.value();
            }
            angular.push(acceleration);
        }
        sheet.verify(|| closure::check_pins(this.system, &shown, ([0.0; 3], 0.0), sheet));
        this.watched(&self.watched, &mut closed, &shown, sheet);
        this.relative(&self.relative, sheet);
        this.sliding(sheet);
        (angular, closed.is_complete())
    }

    /// The mechanism over the range of its first driver, as far as it goes; nothing where no range is asked for.
    fn through<W: Worksheet>(&self, this: &Solved<'_>, sheet: W) -> Result<Vec<Sample>, Refusal> {
        const STEPS: usize = 120;
        let Some(first) = self.drivers.first() else { return Ok(Vec::new()) };
        let start = first.what.value();
        let turns = matches!(first.what, Driven::Angle { .. });
        let (from, to, closed) = match self.range {
            Range::Turn if turns => (start, start + TAU, true),
            Range::Angles { from, to } if turns => (from, to, false),
            Range::Lengths { from, to } if !turns => (from, to, false),
            _ => return Ok(Vec::new()),
        };
        let refuse = |error: PlanarError| this.parts.refusal(&error, this.rows);
        let one_way = |positions: &[[f64; 3]], from: f64, to: f64| -> Result<Vec<Sample>, Refusal> {
            sheet.keep_going()?;
            let values: Vec<f64> =
                (0..=STEPS).map(|step| from + (to - from) * step as f64 / STEPS as f64).collect();
            let mut swept = SweepResult::default();
            let end = this.system.sweep(positions, 0).map_err(refuse)?.over(&values, &mut swept);
            // A whole turn goes as far as the mechanism does, if it goes at all.
            if let Err(error) = end
                && !(closed && swept.reached() > 1 && matches!(error, PlanarError::Limit { .. }))
            {
                sheet.warn(|| {
                    let reached = swept.reached().checked_sub(1).map_or(from, |last| values[last]);
                    let Refusal::NoAnswer(why) = refuse(error) else { return Text::from("") };
                    Text::new("the plots end at {end}: {why}")
                        .with_quantity("end", reached, first.what.unit())
                        .with_text("why", why)
                });
            }
            let sample = |n: usize| Sample {
                value: values[n],
                state: swept.state(n),
                multipliers: swept.multipliers(n).to_vec(),
            };
            Ok((0..swept.reached()).map(sample).collect())
        };
        let positions = &this.state.positions;
        if !closed {
            let values: Vec<f64> = self.drivers.iter().map(|drive| drive.what.value()).collect();
            let there =
                this.system.continue_to(positions, &[&[from], &values[1..]].concat()).map_err(refuse)?;
            return one_way(&there.positions, from, to);
        }
        let forward = one_way(positions, from, to)?;
        if forward.last().is_some_and(|last| last.value > to - 1e-9) {
            return Ok(forward);
        }
        let mut backward = one_way(positions, from, from - TAU)?;
        backward.reverse();
        backward.pop();
        backward.extend(forward);
        Ok(backward)
    }
}
