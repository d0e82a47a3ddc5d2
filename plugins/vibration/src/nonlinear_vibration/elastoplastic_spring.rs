//! A mass on an elastic, perfectly plastic spring, under a sudden force or set in motion by a blow.

use std::f64::consts::{FRAC_PI_2, PI};

use dalembert_core::{
    About, Analysis, Axis, Drawing, Exhibit, Inputs, Plot, Refusal, Series, Sketch, Text, Worksheet, register,
};
use dalembert_mechanics::{Real, sdof};
use dalembert_numerics::quadrature;

use crate::{
    shared::oscillator::{Mass, mass},
    sources::{BIGGS, CHOPRA},
};

/// An undamped mass at rest on a spring whose force grows up to its yield force and stays there; it returns elastically.
#[derive(Clone, Debug, Inputs)]
pub struct ElastoplasticSpring {
    /// Mass.
    pub mass: Mass,
    /// Stiffness.
    /// Up to the yield force, and of the return.
    #[input("k", "N/m", positive)]
    pub stiffness: f64,
    /// Yield force.
    /// The largest force of the spring: the resistance of the structure.
    #[input("R", "N", positive)]
    pub yield_force: f64,
    /// Load.
    pub load: SuddenLoad,
}

/// The cause of the motion.
#[derive(Clone, Debug, Inputs)]
pub enum SuddenLoad {
    /// Constant force, suddenly applied
    Force {
        /// Force.
        #[input("F", "N", positive)]
        force: f64,
    },
    /// Initial velocity, from a blow
    Velocity {
        /// Initial velocity.
        #[input("v₀", "m/s", positive)]
        velocity: f64,
    },
}

register!(ElastoplasticSpring);

impl Analysis for ElastoplasticSpring {
    const ABOUT: About = About {
        id: "vibration/elastoplastic-spring",
        title: "Elastoplastic spring",
        topic: "Nonlinear vibration",
        summary: "Maximum displacement, permanent displacement, ductility and rebound of a mass on an elastic, perfectly plastic spring under a sudden force or a blow.",
        main: &["largest_displacement", "ductility", "permanent_displacement"],
        keywords: "elastic perfectly plastic elastoplastic yield ductility permanent set blast sudden force impulse resistance \
                   elastoplástica escoamento ductilidade deformação permanente explosão força súbita",
        sources: &[&BIGGS, &CHOPRA],
        cases: include_str!("../../cases/elastoplastic_spring.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &ElastoplasticSpringGiven<W>, sheet: W) -> Result<(), Refusal> {
        let mass = mass(&given.mass, sheet);
        let (k, resistance) = (given.stiffness, given.yield_force);
        let natural = sheet.step(
            "ωₙ",
            "rad/s",
            sdof::natural_frequency(k, mass),
            ("Natural frequency of the elastic spring", BIGGS.at("§2.2")),
        );
        let limit = sheet.step("y_e", "mm", resistance / k, ("Yield displacement", BIGGS.at("§2.7")));
        sheet.answer("natural_frequency", "Natural frequency, elastic", natural);
        sheet.answer("yield_displacement", "Yield displacement", limit);
        let load = LoadedSpring { mass, k, resistance, natural, limit };
        let motion = match given.load {
            SuddenLoadGiven::Force { force } => load.under_force(force, sheet)?,
            SuddenLoadGiven::Velocity { velocity } => load.after_blow(velocity, sheet),
        };
        sheet.answer("largest_displacement", "Maximum displacement", motion.largest);
        sheet.answer("largest_time", "Time of the maximum displacement", motion.at);
        if motion.yielding.is_some() {
            sheet.common_error("μ", "the permanent displacement used in place of the maximum one", || {
                (motion.largest - limit) / limit
            });
        }
        let ductility = sheet.step(
            "μ",
            "1",
            motion.largest / limit,
            ("Ductility ratio: maximum displacement over yield displacement", BIGGS.at("§2.7")),
        );
        sheet.answer("ductility", "Ductility ratio", ductility);
        if let Some(yielding) = motion.yielding {
            sheet.answer("yield_time", "Time at which the spring yields", yielding.from);
            if let Some(force) = motion.force {
                sheet.common_error("y_p", "the static displacement subtracted from the maximum one", || {
                    motion.largest - force / k
                });
            }
            let set = sheet.step(
                "y_p",
                "mm",
                motion.largest - limit,
                "Permanent displacement: what remains when the spring has returned elastically",
            );
            sheet.answer("permanent_displacement", "Permanent displacement", set);
            sheet.common_error("W_p", "the yield force multiplied by the whole displacement", || {
                resistance * motion.largest
            });
            if let Some(force) = motion.force {
                sheet.common_error("W_p", "the whole work of the load taken as dissipated", || {
                    force * motion.largest
                });
            }
            let lost = sheet.step("W_p", "J", resistance * set, "Energy dissipated in yielding");
            sheet.answer("dissipated_energy", "Energy dissipated in yielding", lost);
            sheet.verify(|| {
                // What the load did, less what the spring gives back.
                let work = match given.load {
                    SuddenLoadGiven::Force { force } => force * motion.largest,
                    SuddenLoadGiven::Velocity { velocity } => mass * velocity.powi(2) / 2.0,
                };
                let stored = resistance * limit / 2.0;
                let what = "energy dissipated: the work of the load less the elastic energy of the spring";
                sheet.check_sum(what, lost + stored, work, work.value());
                sheet.check_sum(
                    "permanent displacement from the dissipated energy",
                    set * resistance,
                    work - stored,
                    work.value(),
                );
            });
        }
        load.rebound(&motion, sheet);
        let shown = Shown {
            limit: limit.value(),
            natural: natural.value(),
            force: motion.force.map_or(0.0, Real::value),
            k: k.value(),
            start: match self.load {
                SuddenLoad::Force { .. } => 0.0,
                SuddenLoad::Velocity { velocity } => velocity,
            },
            yielding: motion.yielding.map(|yielding| [yielding.from.value(), yielding.speed.value()]),
            deceleration: motion.deceleration.map_or(0.0, Real::value),
            largest: [motion.at.value(), motion.largest.value()],
        };
        sheet.show(|| Exhibit::Plot(shown.motion()));
        sheet.show(|| Exhibit::Plot(shown.loop_of_force()));
        sheet.show(|| Exhibit::Drawing(drawing(matches!(self.load, SuddenLoad::Force { .. }))));
        Ok(())
    }
}

/// Parameters of the oscillator.
struct LoadedSpring<N> {
    mass: N,
    k: N,
    resistance: N,
    natural: N,
    limit: N,
}

/// The motion up to its maximum.
struct MotionToMaximum<N> {
    force: Option<N>,
    yielding: Option<Yielding<N>>,
    /// `(R − F)/m`, where the spring yields.
    deceleration: Option<N>,
    largest: N,
    at: N,
}

/// The beginning of yielding.
#[derive(Clone, Copy)]
struct Yielding<N> {
    /// Time.
    from: N,
    /// Velocity.
    speed: N,
}

impl<N: Real> LoadedSpring<N> {
    fn under_force<W: Worksheet<Num = N>>(&self, force: N, sheet: W) -> Result<MotionToMaximum<N>, Refusal> {
        if force.value() >= self.resistance.value() {
            return Err(Refusal::because(
                Text::new("the force is not below the yield force {resistance}: the mass is driven on without end; reduce the force")
                    .with_quantity("resistance", self.resistance.value(), "N"),
            ));
        }
        let rest = sheet.step(
            "y_s",
            "mm",
            force / self.k,
            ("Static displacement under the force", BIGGS.at("§2.3")),
        );
        if 2.0 * force.value() <= self.resistance.value() {
            let largest = sheet.step(
                "y_m",
                "mm",
                rest * 2.0,
                "Maximum displacement: the spring stays elastic, twice the static displacement",
            );
            let at = sheet.step("t_m", "s", N::from(PI) / self.natural, "Time of the maximum: half a period");
            sheet.verify(|| self.check_maximum(force, None, largest, at, sheet));
            return Ok(MotionToMaximum {
                force: Some(force),
                yielding: None,
                deceleration: None,
                largest,
                at,
            });
        }
        let from = sheet.step(
            "t_e",
            "s",
            (N::from(1.0) - self.limit / rest).acos() / self.natural,
            ("Time at which the spring yields: y_s (1 − cos ωₙt) = y_e", BIGGS.at("§2.7")),
        );
        sheet.common_error("v_e", "the elastic energy of the spring omitted from the energy balance", || {
            (force * self.limit * 2.0 / self.mass).sqrt()
        });
        let speed = sheet.step(
            "v_e",
            "m/s",
            rest * self.natural * (self.natural * from).sin(),
            ("Velocity there: y_s ωₙ sin ωₙt", BIGGS.at("§2.7")),
        );
        let motion = self.yielded(Some(force), Yielding { from, speed }, sheet);
        sheet.verify(|| self.check_maximum(force, motion.yielding, motion.largest, motion.at, sheet));
        Ok(motion)
    }

    fn after_blow<W: Worksheet<Num = N>>(&self, velocity: N, sheet: W) -> MotionToMaximum<N> {
        let elastic = sheet.step(
            "y_s",
            "mm",
            velocity / self.natural,
            "Amplitude of the elastic vibration with this velocity",
        );
        let momentum = self.mass * velocity;
        if elastic.value() <= self.limit.value() {
            let largest = sheet.step("y_m", "mm", elastic, "Maximum displacement: the spring stays elastic");
            let at = sheet.step(
                "t_m",
                "s",
                N::from(FRAC_PI_2) / self.natural,
                "Time of the maximum: a quarter of a period",
            );
            sheet.verify(|| {
                let swept = elastic * (N::from(1.0) - (self.natural * at).cos()) / self.natural;
                sheet.check("impulse of the spring up to the maximum", self.k * swept, momentum);
                let energy = self.k * largest.powi(2) / 2.0;
                sheet.check(
                    "kinetic energy at the start, in the spring at the maximum",
                    energy,
                    momentum * velocity / 2.0,
                );
            });
            return MotionToMaximum { force: None, yielding: None, deceleration: None, largest, at };
        }
        let from = sheet.step(
            "t_e",
            "s",
            (self.limit / elastic).asin() / self.natural,
            "Time at which the spring yields: v₀/ωₙ sin ωₙt = y_e",
        );
        let speed =
            sheet.step("v_e", "m/s", velocity * (self.natural * from).cos(), "Velocity there: v₀ cos ωₙt");
        let motion = self.yielded(None, Yielding { from, speed }, sheet);
        sheet.verify(|| {
            let swept = elastic * (N::from(1.0) - (self.natural * from).cos()) / self.natural;
            let impulse = self.k * swept + self.resistance * (motion.at - from);
            sheet.check("impulse of the spring up to the maximum", impulse, momentum);
            let energy = self.resistance * (motion.largest - self.limit / 2.0);
            sheet.check(
                "kinetic energy at the start, in the spring at the maximum",
                energy,
                momentum * velocity / 2.0,
            );
        });
        motion
    }

    /// The plastic part of the motion: a constant deceleration.
    fn yielded<W: Worksheet<Num = N>>(
        &self,
        force: Option<N>,
        yielding: Yielding<N>,
        sheet: W,
    ) -> MotionToMaximum<N> {
        let deceleration = match force {
            Some(force) => (self.resistance - force) / self.mass,
            None => self.resistance / self.mass,
        };
        let why = ("Deceleration while the spring yields", BIGGS.at("§2.7"));
        let deceleration = sheet.step("a_p", "m/s^2", deceleration, why);
        if let Some(force) = force {
            sheet.common_error("y_m", "the spring assumed to stay elastic", || force * 2.0 / self.k);
        }
        let largest = sheet.step(
            "y_m",
            "mm",
            self.limit + yielding.speed.powi(2) / (deceleration * 2.0),
            ("Maximum displacement, after yielding", BIGGS.at("§2.7")),
        );
        let elastic = if force.is_some() { PI } else { FRAC_PI_2 };
        sheet.common_error("t_m", "the time of the maximum of an elastic spring taken", || {
            N::from(elastic) / self.natural
        });
        let at = sheet.step(
            "t_m",
            "s",
            yielding.from + yielding.speed / deceleration,
            ("Time of the maximum displacement", BIGGS.at("§2.7")),
        );
        MotionToMaximum { force, yielding: Some(yielding), deceleration: Some(deceleration), largest, at }
    }

    /// Work and impulse up to the maximum under a force.
    fn check_maximum<W: Worksheet<Num = N>>(
        &self,
        force: N,
        yielding: Option<Yielding<N>>,
        largest: N,
        at: N,
        sheet: W,
    ) {
        let elastic = yielding.map_or(at, |yielding| yielding.from);
        let held = yielding.map_or(N::from(0.0), |yielding| self.resistance * (at - yielding.from));
        let swept = force * (elastic - (self.natural * elastic).sin() / self.natural);
        let size = (force * at).value();
        sheet.check_sum(
            "impulse of the force and of the spring up to the maximum",
            swept + held,
            force * at,
            size,
        );
        let stored = match yielding {
            Some(_) => self.resistance * (largest - self.limit / 2.0),
            None => self.k * largest.powi(2) / 2.0,
        };
        sheet.check("work of the force up to the maximum, in the spring", stored, force * largest);
    }

    /// The elastic return from the maximum to the minimum.
    fn rebound<W: Worksheet<Num = N>>(&self, motion: &MotionToMaximum<N>, sheet: W) {
        let top = if motion.yielding.is_some() { self.resistance } else { self.k * motion.largest };
        let excess = motion.force.map_or(top, |force| top - force);
        if motion.yielding.is_some() {
            sheet.common_error("y_r", "the permanent displacement ignored in the rebound", || {
                motion.force.map_or(-motion.largest, |force| force * 2.0 / self.k - motion.largest)
            });
        }
        let least = sheet.step(
            "y_r",
            "mm",
            motion.largest - excess * 2.0 / self.k,
            "Minimum of the rebound: the return is elastic, about the position at which spring and load are in equilibrium",
        );
        let at = sheet.step(
            "t_r",
            "s",
            motion.at + N::from(PI) / self.natural,
            "Time of the minimum: half a period of the elastic spring later",
        );
        sheet.answer("rebound_displacement", "Minimum displacement of the rebound", least);
        sheet.answer("rebound_time", "Time of the minimum displacement", at);
        sheet.verify(|| {
            let (excess, k, mass) = (excess.value(), self.k.value(), self.mass.value());
            let way = motion.largest.value() - least.value();
            // Net work on the way back: the excess of the spring force falls linearly.
            let size = excess * way;
            let what = "no velocity at the minimum: net work of spring and load on the return";
            sheet.check_residual(
                what,
                N::from(excess * way - k * way * way / 2.0),
                size,
                size * f64::EPSILON,
            );
            let time = quadrature::integral(
                |angle| {
                    // From the maximum by way/2 (1 − cos φ).
                    let gone = way / 2.0 * (1.0 - angle.cos());
                    let speed = (2.0 * gone * (excess - k * gone / 2.0).max(0.0) / mass).sqrt();
                    way / 2.0 * angle.sin() / speed
                },
                [0.0, PI],
                16,
            );
            sheet.check("time of the return by quadrature of dt = dy/v", at - motion.at, time.into());
        });
    }
}

/// Numbers of the plots.
struct Shown {
    limit: f64,
    natural: f64,
    force: f64,
    k: f64,
    start: f64,
    yielding: Option<[f64; 2]>,
    deceleration: f64,
    largest: [f64; 2],
}

impl Shown {
    /// Displacement and spring force at a time.
    fn at(&self, time: f64) -> [f64; 2] {
        let [at, largest] = self.largest;
        let rest = self.force / self.k;
        if time > at {
            // The elastic return.
            let top = self.k * largest.min(self.limit);
            let middle = largest - (top - self.force) / self.k;
            let y = middle + (largest - middle) * (self.natural * (time - at)).cos();
            return [y, top - self.k * (largest - y)];
        }
        match self.yielding {
            Some([from, speed]) if time > from => {
                let t = time - from;
                [self.limit + speed * t - self.deceleration * t * t / 2.0, self.k * self.limit]
            }
            _ => {
                let (sin, cos) = (self.natural * time).sin_cos();
                let y = rest * (1.0 - cos) + self.start / self.natural * sin;
                [y, self.k * y]
            }
        }
    }

    fn times(&self) -> impl Iterator<Item = f64> {
        let last = self.largest[0] + 1.5 * PI / self.natural;
        (0..=400).map(move |n| last * f64::from(n) / 400.0)
    }

    fn motion(&self) -> Plot {
        let points = self.times().map(|time| (time, self.at(time)[0])).collect();
        Plot::new(
            "Displacement against time",
            Axis::linear("time", "s"),
            Axis::linear("displacement", "mm"),
            vec![Series::line("y", points)],
        )
        .level("yield displacement", self.limit)
        .mark("maximum", (self.largest[0], self.largest[1]))
    }

    fn loop_of_force(&self) -> Plot {
        let points = self.times().map(|time| self.at(time).into()).collect();
        Plot::new(
            "Force of the spring against displacement",
            Axis::linear("displacement", "mm"),
            Axis::linear("force of the spring", "N"),
            vec![Series::line("R", points)],
        )
    }
}

fn drawing(is_force: bool) -> Drawing {
    let mut sketch = Sketch::new("The mass on its spring");
    sketch
        .ground((-2.0, -0.7), (-2.0, 0.7))
        .spring("k, R", (-2.0, 0.0), (-0.5, 0.0))
        .mass("m", (-0.5, -0.5), (0.5, 0.5))
        .motion("y", (-0.5, 0.8), (0.3, 0.8));
    if is_force {
        sketch.force("F", (0.5, 0.0), (1.4, 0.0));
    } else {
        sketch.motion("v₀", (0.5, 0.0), (1.4, 0.0));
    }
    sketch.finish()
}
