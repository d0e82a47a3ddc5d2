//! A body that falls on a spring: a block on a sprung pan, a package on its cushion.

use std::ops::ControlFlow;

use dalembert_core::{
    About, Analysis, Axis, Drawing, Exhibit, Inputs, Plot, Refusal, Series, Sketch, Text, Worksheet, register,
};
use dalembert_mechanics::{
    Real,
    vibration::transient::{
        LoadLaw, LoadSegment, Oscillator, OscillatorState, TransientMotion, TransientOutput,
    },
};
use dalembert_numerics::roots;

use crate::{
    shared::{
        free_motion::{DampedOscillator, WorkedFreeMotion, system},
        oscillator::{Elasticity, Mass, ViscousDamping, mass},
    },
    sources::{MERIAM, RAO, THOMSON},
};

/// Inputs: the falling body, its height, and the spring or cushion.
#[derive(Clone, Debug, Inputs)]
pub struct DropImpact {
    /// Falling body.
    pub body: Mass,
    /// Pan.
    /// Rests on the spring; the body stays on it. If omitted, a massless cushion.
    #[input("p")]
    pub pan: Option<Mass>,
    /// Spring.
    pub elasticity: Elasticity,
    /// Damping.
    pub damping: ViscousDamping,
    /// Drop.
    pub fall: Fall,
    /// Acceleration of gravity.
    #[input("g", "m/s^2", positive, default = "9.81 m/s^2", default_before = "9.80665 m/s^2")]
    pub gravity: f64,
    /// Times after the release.
    /// The distance fallen is computed at each of them.
    #[input("t", "s", nonnegative)]
    pub times: Vec<f64>,
}

/// Velocity of impact, or the drop height that gives it.
#[derive(Clone, Debug, Inputs)]
pub enum Fall {
    /// Height
    Height {
        /// Height of the fall.
        /// From rest to the pan or cushion.
        #[input("h", "m", nonnegative)]
        height: f64,
    },
    /// Speed at contact
    Speed {
        /// Speed at contact.
        #[input("v", "m/s", nonnegative)]
        speed: f64,
    },
}

register!(DropImpact);

impl Analysis for DropImpact {
    const ABOUT: About = About {
        id: "vibration/drop-impact",
        title: "Body dropped on a spring",
        topic: "Shock and impact",
        summary: "Maximum deflection, force and deceleration of a body that falls on a spring-mounted pan or on a cushion.",
        main: &["deflection", "force", "deceleration"],
        keywords: "drop fall package cushion pan impact deceleration g shock queda pacote embalagem prato impacto \
                   choque amortecida bloco desaceleração",
        sources: &[&RAO, &THOMSON, &MERIAM],
        cases: include_str!("../../cases/drop_impact.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &DropImpactGiven<W>, sheet: W) -> Result<(), Refusal> {
        let body = mass(&given.body, sheet);
        let gravity = given.gravity;
        let (speed, contact) = match &given.fall {
            FallGiven::Height { height } => {
                let why = ("Free-fall speed at contact", MERIAM.at("§2/2"));
                let speed = sheet.step("v", "m/s", (gravity * *height * 2.0).sqrt(), why);
                (speed, Some(*height))
            }
            FallGiven::Speed { speed } => (*speed, None),
        };
        let contact = contact.map(|height| {
            let why = ("Free-fall time", MERIAM.at("§2/2"));
            let time = sheet.step("t_c", "s", speed / gravity, why);
            sheet.check("time of the free fall from its height", (height * 2.0 / gravity).sqrt(), time);
            (height, time)
        });
        let (total, pan) = match &given.pan {
            None => (body, None),
            Some(pan) => {
                let pan = mass(pan, sheet);
                (sheet.step("m_t", "kg", body + pan, "Body and pan move together"), Some(pan))
            }
        };
        let system = system(Some(total), &given.elasticity, &given.damping, sheet)?;
        let stiffness = system.body.expect("the mass is known").stiffness;
        let start = match pan {
            None => speed,
            Some(_) => {
                let why = ("The body sticks to the pan: momentum is conserved", MERIAM.at("§3/12"));
                sheet.common_error("v₀", "the kinetic energy taken as conserved in the impact", || {
                    speed * (body / total).sqrt()
                });
                sheet.step("v₀", "m/s", body * speed / total, why)
            }
        };
        let why = "Additional static compression of the spring under the weight of the body";
        if pan.is_some() {
            sheet.common_error("δ_w", "the weight of the pan included", || total * gravity / stiffness);
        }
        let sag = sheet.step("δ_w", "mm", body * gravity / stiffness, why);
        sheet.check(
            "at contact the force missing in the spring is the weight of the body: ωₙ² δ = m g/m_t",
            system.natural.powi(2) * sag,
            body * gravity / total,
        );
        let pan_sag = pan.map(|pan| {
            let why = "Initial compression of the spring under the weight of the pan";
            sheet.step("δ_p", "mm", pan * gravity / stiffness, why)
        });

        let motion = TransientMotion::new(
            Oscillator { natural: system.natural.value(), ratio: system.ratio.value() },
            OscillatorState { displacement: 0.0, velocity: start.value() },
            &[LoadSegment { from: 0.0, law: LoadLaw::Line { start: sag.value(), slope: 0.0 } }],
        )
        .map_err(cannot)?;
        let free = WorkedFreeMotion::new(&system, sheet);
        let fall = Drop { body, pan, gravity, speed, sag, start, system, pan_sag, motion, free };
        sheet.answer("contact_speed", "Speed at contact", speed);
        if let Some((_, time)) = contact {
            sheet.answer("contact_time", "Instant of contact", time);
        }
        if pan.is_some() {
            sheet.answer("common_speed", "Speed of body and pan after impact", start);
        }
        sheet.answer("natural_frequency", "Natural frequency on the spring", system.natural);
        let largest = fall.largest(contact, sheet)?;
        let parting = fall.parting(sheet)?;
        fall.ways(&given.times, contact, parting, gravity, sheet)?;
        sheet.show(|| Exhibit::Plot(fall.plot(parting, largest)));
        sheet.show(|| Exhibit::Drawing(self.drawing()));
        Ok(())
    }
}

/// A drop, from the contact on.
struct Drop<N> {
    body: N,
    pan: Option<N>,
    gravity: N,
    speed: N,
    sag: N,
    start: N,
    system: DampedOscillator<N>,
    pan_sag: Option<N>,
    motion: TransientMotion,
    free: WorkedFreeMotion<N>,
}

impl<N: Real> Drop<N> {
    /// Deflection of the spring beyond its static equilibrium at a time after contact.
    fn deflection(&self, time: N) -> N {
        self.sag * (N::from(1.0) - self.free.release(time)) + self.start * self.free.impulse(time)
    }

    /// The largest deflection, force and deceleration.
    fn largest<W: Worksheet<Num = N>>(
        &self,
        contact: Option<(N, N)>,
        sheet: W,
    ) -> Result<Option<(f64, f64)>, Refusal> {
        let found = self
            .motion
            .extremes(TransientOutput::DISPLACEMENT, [0.0, f64::INFINITY])
            .map_err(cannot)?
            .largest;
        let natural = self.system.natural;
        // A motion that never turns has its largest value at no time.
        let turns = found.time > 0.0;
        let (after, deflection, by_recurrence) = if turns {
            let why = "Time from contact to maximum deflection: the first zero of the velocity";
            let after = sheet.numerical("τₘ", "s", found.time, why);
            let why = (
                "Maximum deflection from the static position of pan or cushion: a step of the weight and the velocity at contact",
                RAO.at("§4.5"),
            );
            let swing = || self.start / natural;
            if self.free.is_undamped() {
                sheet.common_error("yₘ", "the weight omitted during the compression", swing);
                if self.pan.is_some() {
                    sheet.common_error("yₘ", "the energy lost in the impact with the pan ignored", || {
                        self.sag + (self.sag.powi(2) + self.sag * self.speed.powi(2) / self.gravity).sqrt()
                    });
                }
            } else {
                sheet.common_error("yₘ", "the damping omitted", || {
                    self.sag + (self.sag.powi(2) + swing().powi(2)).sqrt()
                });
            }
            (Some(after), sheet.step("yₘ", "mm", self.deflection(after), why), found.value)
        } else {
            sheet.warn(|| {
                Text::new("the damping is so strong that the body approaches rest without oscillating: the maximum deflection is approached but never passed, and has no time")
            });
            let why = "Overdamped: the body approaches its rest position asymptotically, and the maximum deflection is that due to the weight";
            let ratio = self.system.ratio.value();
            // The slower of both motions falls to e⁻⁶⁰.
            let long =
                60.0 * (ratio + (ratio - 1.0).max(0.0).sqrt() * (ratio + 1.0).sqrt()) / natural.value();
            (None, sheet.step("yₘ", "mm", self.sag, why), self.motion.at(long).displacement)
        };
        sheet.verify(|| {
            if self.free.is_undamped() {
                sheet.check(
                    "maximum deflection by energy, δ + √(δ² + (v₀/ωₙ)²)",
                    self.sag + (self.sag.powi(2) + (self.start / natural).powi(2)).sqrt(),
                    deflection,
                );
            } else {
                sheet.check("maximum deflection by the exact recurrence", by_recurrence.into(), deflection);
            }
        });
        sheet.answer(
            "deflection",
            "Maximum deflection from the static position of the pan or cushion",
            deflection,
        );
        let mut since_contact = after;
        if let Some((height, fallen)) = contact {
            if let Some(after) = after {
                let why = "Time of maximum deflection, from the release";
                let time = sheet.step("tₘ", "s", fallen + after, why);
                sheet.answer("time_of_maximum", "Time of maximum deflection, from the release", time);
                since_contact = Some(time - fallen);
            }
            let why = "Total displacement of the body, from release to maximum deflection";
            let way = sheet.step("sₘ", "mm", height + deflection, why);
            sheet.answer("way", "Total displacement of the body", way);
            sheet.check_sum(
                "total distance: free fall in its time, plus the deflection by the exact recurrence",
                way - self.gravity * fallen.powi(2) / 2.0,
                by_recurrence.into(),
                way.value(),
            );
        }
        sheet.verify(|| {
            if let Some(since) = since_contact {
                let scale = self.sag.value() + (self.start / natural).value();
                let velocity = self.motion.at(since.value()).velocity / natural.value();
                // The time of a long fall takes digits from what is left after it.
                let time = since.value() + contact.map_or(0.0, |(_, fallen)| fallen.value());
                let error = f64::EPSILON * time * natural.value() * scale;
                let what = "the velocity is zero at the maximum deflection";
                sheet.check_residual(what, velocity.into(), scale, error);
            }
        });
        let stiffness = self.system.body.expect("the mass is known").stiffness;
        let output = TransientOutput::support(self.system.ratio.value());
        let support = self.motion.extremes(output, [0.0, f64::INFINITY]).map_err(cannot)?.largest.value;
        let reached = if self.free.is_undamped() {
            deflection
        } else {
            let why = "Maximum value of y + 2ζẏ/ωₙ, the force of spring and damper over the stiffness";
            sheet.numerical("y_F", "mm", support, why)
        };
        let pressed = self.pan_sag.map_or(reached, |pan| reached + pan);
        let why = "Maximum force of spring and damper on the ground";
        sheet.common_error("F_T", "the weight of the body added to the force of the spring", || {
            stiffness * pressed + self.body * self.gravity
        });
        if !self.free.is_undamped() {
            sheet.common_error(
                "F_T",
                "the damper omitted: the spring alone at its maximum deflection",
                || stiffness * self.pan_sag.map_or(deflection, |pan| deflection + pan),
            );
        }
        let force = sheet.step("F_T", "N", stiffness * pressed, why);
        let why = "Maximum deceleration: the force beyond the weight, over the mass";
        sheet.common_error("aₘ", "a constant deceleration over the deflection assumed", || {
            self.start.powi(2) / (deflection * 2.0)
        });
        if self.pan.is_some() {
            sheet.common_error("aₘ", "the force divided by the mass of the body alone", || {
                force / self.body - self.gravity
            });
        }
        let deceleration = sheet.step("aₘ", "m/s^2", natural.powi(2) * (reached - self.sag), why);
        sheet.answer("force", "Maximum force on the ground", force);
        sheet.answer("deceleration", "Maximum deceleration of the body", deceleration);
        let total = self.system.body.expect("the mass is known").mass;
        sheet.check_sum(
            "Newton's second law at the largest force: F_T − m_t g = m_t aₘ",
            force - total * self.gravity,
            total * deceleration,
            force.value().abs().max((total * self.gravity).value()),
        );
        if let Some(pan) = self.pan {
            let why = ("Energy lost in the impact", MERIAM.at("§3/12"));
            let energy = sheet.step(
                "ΔE",
                "J",
                self.body * self.speed.powi(2) / 2.0 - total * self.start.powi(2) / 2.0,
                why,
            );
            sheet.check_sum(
                "energy lost: that of the speed of approach in the reduced mass, m m_p v²/(2 m_t)",
                energy,
                self.body * pan * self.speed.powi(2) / (total * 2.0),
                (self.body * self.speed.powi(2)).value() / 2.0,
            );
            sheet.answer("energy_lost", "Energy lost in the impact", energy);
        }
        Ok(turns.then_some((found.time, found.value)))
    }

    /// Time of separation of the body from the pan or cushion, counted from contact; `None` if it stays.
    fn parting<W: Worksheet<Num = N>>(&self, sheet: W) -> Result<Option<N>, Refusal> {
        let output = TransientOutput::support(self.system.ratio.value());
        let limit = -self.pan_sag.map_or(0.0, Real::value);
        let found = self.motion.extremes(output, [0.0, f64::INFINITY]).map_err(cannot)?;
        let (top, bottom) = (found.largest.time, found.least);
        if bottom.value >= limit - 1e-9 * found.largest.value || bottom.time <= top {
            return Ok(None);
        }
        let force = |time: f64| self.motion.output(output, time) - limit;
        let Ok(time) = roots::find(force, [top, bottom.time], |_| ControlFlow::Continue(())) else {
            return Ok(None);
        };
        let why = "Time from contact until the body leaves the pan: the force between them is zero";
        let parting = sheet.numerical("τ_s", "s", time, why);
        sheet.check_zero("the force is zero then", force(parting.value()).into(), found.largest.value);
        sheet.answer("contact_duration", "Contact duration", parting);
        Ok(Some(parting))
    }

    /// Displacement of the body at the requested times.
    fn ways<W: Worksheet<Num = N>>(
        &self,
        times: &[N],
        contact: Option<(N, N)>,
        parting: Option<N>,
        gravity: N,
        sheet: W,
    ) -> Result<(), Refusal> {
        for (n, &time) in times.iter().enumerate() {
            let symbol = dalembert_core::Symbol::from("y").row(n + 1);
            let (height, fallen) = match contact {
                Some((height, fallen)) => (Some(height), fallen.value()),
                None => (None, 0.0),
            };
            if time.value() <= fallen {
                let why = ("Still in free fall", MERIAM.at("§2/2"));
                let way = sheet.step(symbol, "mm", gravity * time.powi(2) / 2.0, why);
                if let Some((height, fallen)) = contact.filter(|(_, fallen)| fallen.value() > 0.0) {
                    let what =
                        "distance in free fall: the drop height times the square of the fraction of its time";
                    sheet.check(what, way, height * (time / fallen).powi(2));
                }
                sheet.answer(("way_at", n + 1), "Displacement of the body at time", way);
                continue;
            }
            let after = match contact {
                Some((_, fallen)) => {
                    let symbol = dalembert_core::Symbol::from("τ").row(n + 1);
                    sheet.step(symbol, "s", time - fallen, "Time since the contact")
                }
                None => time,
            };
            if let Some(parting) = parting
                && after.value() > parting.value()
            {
                return Err(Refusal::because(
                    Text::new(
                        "the body has already left the pan or cushion {duration} after the contact: choose an earlier time",
                    )
                    .with_quantity("duration", parting.value(), "s"),
                ));
            }
            let why = "Displacement of the body: the fall plus the deflection";
            let deflection = self.deflection(after);
            let way = match height {
                Some(height) => sheet.step(symbol, "mm", height + deflection, why),
                None => sheet.step(symbol, "mm", deflection, "Deflection since the contact"),
            };
            sheet.verify(|| {
                let exact = self.motion.at(after.value()).displacement;
                let scale = self.sag.value() + (self.start / self.system.natural).value();
                let height = height.map_or(0.0, Real::value);
                let what = "distance travelled by the exact recurrence";
                sheet.check_sum(what, way, (height + exact).into(), scale + height);
            });
            sheet.answer(("way_at", n + 1), "Displacement of the body at time", way);
        }
        Ok(())
    }

    /// The deflection until the body leaves, or for two periods.
    fn plot(&self, parting: Option<N>, largest: Option<(f64, f64)>) -> Plot {
        let period = std::f64::consts::TAU / self.system.natural.value();
        let last = parting.map_or(2.0 * period, Real::value).max(1.2 * largest.map_or(0.0, |(time, _)| time));
        let at = |n: u16| {
            let time = last * f64::from(n) / 400.0;
            (time, self.motion.at(time).displacement)
        };
        let plot = Plot::new(
            "Deflection after the contact",
            Axis::linear("time since the contact", "s"),
            Axis::linear("deflection", "mm"),
            vec![Series::line("y", (0..=400).map(at).collect())],
        )
        .level("static equilibrium position", self.sag.value());
        match largest {
            Some(largest) => plot.mark("largest", largest),
            None => plot,
        }
    }
}

impl DropImpact {
    fn drawing(&self) -> Drawing {
        let mut sketch = Sketch::new("The body above its spring");
        sketch
            .ground((-1.0, -1.5), (1.0, -1.5))
            .spring(self.elasticity.letters(), (-0.4, -1.5), (-0.4, -0.4))
            .damper("c", (0.4, -1.5), (0.4, -0.4))
            .mass(self.body.letter(), (-0.7, 1.0), (0.7, 1.7));
        let top = if let Some(pan) = &self.pan {
            sketch.mass("", (-0.8, -0.4), (0.8, -0.15)).label(
                match pan {
                    Mass::Mass { .. } => "m_p",
                    Mass::Weight { .. } => "W_p",
                },
                (-0.8, -0.3),
            );
            -0.15
        } else {
            sketch.bars([(-0.8, -0.4), (0.8, -0.4)]);
            -0.4
        };
        match self.fall {
            Fall::Height { .. } => sketch.dimension("h", (0.9, top), (0.9, 1.0), 0.0),
            Fall::Speed { .. } => sketch.motion("v", (0.0, 1.0), (0.0, 0.3)),
        };
        sketch.finish()
    }
}

fn cannot<E>(_: E) -> Refusal {
    Refusal::because(
        "these numbers are too large or too small for the motion to be computed: check their units",
    )
}
