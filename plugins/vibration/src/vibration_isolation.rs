//! Mounts that keep the vibration of a machine from its floor, or a blow from what is packed.

use dalembert_core::{
    About, Analysis, Axis, Drawing, DrawnShape, Exhibit, Ink, Inputs, Plot, Refusal, Series, Text, Worksheet,
    register,
};
use dalembert_mechanics::{
    Real, sdof,
    vibration::isolation::{self, Shaking},
};

mod shock;

use crate::{
    oscillator::{Body, DampingGiven, Elasticity, Loss, Mass, Suspension, mass, plots::below, suspension},
    sources::{RAO, THOMSON},
};

/// What stands on the mounts, and what is asked of them.
#[derive(Clone, Debug, Inputs)]
pub struct VibrationIsolation {
    /// Machine.
    pub mass: Mass,
    /// Mass of the inertia block.
    /// A block under the machine moves with it: less motion, and the same force on the floor at the same static
    /// deflection.
    #[input("m_b", "kg", positive)]
    pub block: Option<f64>,
    /// Number of mounts.
    /// All equal, and each with its share of the weight.
    #[input(min = 1, max = 1000, default = "4")]
    pub mounts: u32,
    /// Gravity.
    #[input("g", "m/s^2", positive, default = "9.81 m/s^2", default_before = "9.80665 m/s^2")]
    pub gravity: f64,
    /// Question.
    pub question: Question,
}

/// What is asked of the mounts.
#[derive(Clone, Debug, Inputs)]
pub enum Question {
    /// Mounts for a required isolation
    Design {
        /// Required.
        required: Requirement,
        /// Damping ratio.
        #[input("ζ", "1", nonnegative, default = "0")]
        damping_ratio: f64,
        /// Speeds.
        speeds: Speeds,
        /// Disturbance.
        disturbance: Option<Disturbance>,
    },
    /// Isolation of given mounts
    Judge {
        /// Mounts.
        /// All of them together.
        elasticity: Elasticity,
        /// Damping.
        damping: MountDamping,
        /// Speeds.
        speeds: Speeds,
        /// Disturbance.
        disturbance: Option<Disturbance>,
        /// Required.
        /// The lowest speed at which these mounts reach it is answered.
        required: Option<Requirement>,
    },
    /// Mounts for a shock
    Shock {
        /// Arrival.
        arrival: shock::Arrival,
        /// Largest acceleration.
        /// What the machine stands.
        #[input("A", "m/s^2", positive)]
        acceleration: f64,
        /// Largest travel.
        /// What the mounts have room for.
        #[input("d", "m", positive)]
        travel: Option<f64>,
    },
}

/// How well the mounts must isolate.
#[derive(Clone, Debug, Inputs)]
pub enum Requirement {
    /// Largest transmissibility
    Transmissibility {
        /// Transmissibility.
        #[input("T", "1", positive, below = 1)]
        transmissibility: f64,
    },
    /// Least isolation
    Isolation {
        /// Isolation.
        /// The share of the force, or of the motion, that is kept away: 85 % for a transmissibility of 0.15.
        #[input("I", "%", positive, below = 100)]
        isolation: f64,
    },
}

/// What damps the mounts.
#[derive(Clone, Debug, Inputs)]
pub enum MountDamping {
    /// Damping ratio given
    Ratio {
        /// Damping ratio.
        /// Zero for no damping.
        #[input("ζ", "1", nonnegative)]
        ratio: f64,
    },
    /// Damping coefficient given
    Coefficient {
        /// Damping coefficient.
        /// Of all mounts together.
        #[input("c", "N*s/m", nonnegative)]
        coefficient: f64,
    },
}

/// The speeds at which the machine runs, or the frequencies at which the base shakes.
#[derive(Clone, Debug, Inputs)]
pub struct Speeds {
    /// Lowest speed.
    #[input("ω₁", "rad/s", positive)]
    pub lowest: f64,
    /// Highest speed.
    /// Where the machine runs at more than one.
    #[input("ω₂", "rad/s", positive)]
    pub highest: Option<f64>,
}

/// What shakes the machine.
#[derive(Clone, Debug, Inputs)]
pub enum Disturbance {
    /// Force of constant amplitude
    Force {
        /// Amplitude of the force.
        #[input("F₀", "N", positive)]
        force: f64,
    },
    /// Rotating unbalance
    Unbalance {
        /// Unbalance.
        /// The eccentric mass times its eccentricity.
        #[input("m₀e", "kg*m", positive)]
        unbalance: f64,
    },
    /// Piston
    Piston {
        /// Mass that goes up and down.
        #[input("m₀", "kg", positive)]
        mass: f64,
        /// Stroke.
        /// Twice the radius of the crank.
        #[input("s", "m", positive)]
        stroke: f64,
    },
}

register!(VibrationIsolation);

impl Analysis for VibrationIsolation {
    const ABOUT: About = About {
        id: "vibration/vibration-isolation",
        title: "Vibration and shock isolation",
        topic: "Isolation, absorbers and instruments",
        summary: "Stiffness and static deflection of mounts for a required isolation over a band of speeds, the isolation of given mounts, and mounts for a shock.",
        keywords: "isolator mount transmissibility inertia block static deflection drop packaging isolamento isolador \
                   coxim calço transmissibilidade bloco de inércia deflexão estática choque",
        sources: &[&RAO, &THOMSON],
        cases: include_str!("../cases/vibration_isolation.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &VibrationIsolationGiven<W>, sheet: W) -> Result<(), Refusal> {
        let machine = mass(&given.mass, sheet);
        let mass = match given.block {
            Some(block) => sheet.step("m_t", "kg", machine + block, "Mass on the mounts: machine and block"),
            None => machine,
        };
        let mounts = Mounts { mass, count: f64::from(self.mounts), gravity: given.gravity };
        match &given.question {
            QuestionGiven::Design { required, damping_ratio, speeds, disturbance } => {
                mounts.design(required, *damping_ratio, speeds, disturbance.as_ref(), sheet)
            }
            QuestionGiven::Judge { elasticity, damping, speeds, disturbance, required } => {
                let damping = match damping {
                    MountDampingGiven::Ratio { ratio } => DampingGiven::Ratio { ratio: *ratio },
                    MountDampingGiven::Coefficient { coefficient } => {
                        DampingGiven::Coefficient { coefficient: *coefficient }
                    }
                };
                let suspension = suspension(Some(mass), elasticity, &damping, sheet)?;
                mounts.judge(&suspension, required.as_ref(), speeds, disturbance.as_ref(), sheet)
            }
            QuestionGiven::Shock { arrival, acceleration, travel } => {
                shock::solve(&mounts, arrival, *acceleration, *travel, sheet)
            }
        }
    }
}

/// The mounts and what stands on them.
#[derive(Clone, Copy)]
struct Mounts<N> {
    mass: N,
    count: f64,
    gravity: N,
}

/// Mounts that are known: what the machine does on them.
struct Known<N> {
    natural: N,
    stiffness: N,
    damping: N,
    zeta: N,
}

/// The speeds of the machine.
struct Band<N> {
    ratios: [f64; 2],
    speeds: [N; 2],
    natural: N,
}

impl<N: Real> Band<N> {
    /// The speed of a ratio that a kernel found in the band, and that ratio, written down: an end of the band, or
    /// what `within` writes.
    fn at<W: Worksheet<Num = N>>(
        &self,
        found: f64,
        [speed, ratio]: [&'static str; 2],
        within: impl FnOnce() -> N,
        sheet: W,
    ) -> (N, N) {
        match self.ratios.iter().position(|end| *end == found) {
            Some(end) => {
                let why = "Frequency ratio at the worst speed";
                (self.speeds[end], sheet.step(ratio, "1", self.speeds[end] / self.natural, why))
            }
            None => {
                let ratio = within();
                (sheet.step(speed, "rpm", ratio * self.natural, "Worst speed, within the band"), ratio)
            }
        }
    }
}

impl<N: Real> Mounts<N> {
    /// The softest need: mounts that reach the requirement at the lowest speed, and so at every higher one.
    fn design<W: Worksheet<Num = N>>(
        &self,
        required: &RequirementGiven<W>,
        zeta: N,
        speeds: &SpeedsGiven<W>,
        disturbance: Option<&DisturbanceGiven<W>>,
        sheet: W,
    ) -> Result<(), Refusal> {
        let transmissibility = wanted(required, sheet);
        let ratio = required_ratio(transmissibility, zeta, sheet);
        let natural = sheet.step(
            "ωₙ",
            "rad/s",
            speeds.lowest / ratio,
            ("Highest natural frequency: the lowest speed is the worst, for above it the transmissibility falls", RAO.at("§9.10")),
        );
        let stiffness = sheet.step(
            "k",
            "N/m",
            sdof::stiffness_from_natural_frequency(self.mass, natural),
            ("Largest stiffness of all mounts together", RAO.at("§2.2")),
        );
        let why = ("Damping coefficient of all mounts together", RAO.at("§2.6"));
        let damping = sheet.step("c", "N*s/m", sdof::damping_from_ratio(zeta, stiffness, self.mass), why);
        sheet.answer("required_ratio", "Frequency ratio needed", ratio);
        let known = Known { natural, stiffness, damping, zeta };
        self.answer(&known, sheet);
        self.assess(&known, Some(transmissibility), speeds, disturbance, sheet)
    }

    /// Given mounts.
    fn judge<W: Worksheet<Num = N>>(
        &self,
        suspension: &Suspension<N>,
        required: Option<&RequirementGiven<W>>,
        speeds: &SpeedsGiven<W>,
        disturbance: Option<&DisturbanceGiven<W>>,
        sheet: W,
    ) -> Result<(), Refusal> {
        let (Some(Body { stiffness, .. }), Loss::Viscous(zeta, Some(damping))) =
            (suspension.body, suspension.loss)
        else {
            unreachable!("the mass is given and the damping is viscous")
        };
        let known = Known { natural: suspension.natural, stiffness, damping, zeta };
        self.answer(&known, sheet);
        let wanted = required.map(|required| {
            let transmissibility = wanted(required, sheet);
            let ratio = required_ratio(transmissibility, zeta, sheet);
            let why = ("Lowest speed at which the mounts isolate as required", RAO.at("§9.10"));
            let least = sheet.step("ω_min", "rpm", ratio * known.natural, why);
            sheet.answer("required_ratio", "Frequency ratio needed", ratio);
            sheet.answer("least_speed", "Lowest speed with the required isolation", least);
            sheet.check(
                "transmissibility at the lowest speed, from the dynamic stiffness",
                (stiffness.powi(2) + (damping * least).powi(2)).sqrt()
                    / sdof::dynamic_stiffness(stiffness, self.mass, damping, least),
                transmissibility,
            );
            transmissibility
        });
        self.assess(&known, wanted, speeds, disturbance, sheet)
    }

    /// Natural frequency, stiffness and static deflection.
    fn answer<W: Worksheet<Num = N>>(&self, known: &Known<N>, sheet: W) {
        let deflection = sheet.step(
            "δ_st",
            "mm",
            self.gravity / known.natural.powi(2),
            ("Static deflection under the weight, k δ_st = m g", RAO.at("§2.2")),
        );
        sheet.check("the mounts carry the weight", known.stiffness * deflection, self.mass * self.gravity);
        sheet.answer("mass", "Mass on the mounts", self.mass);
        sheet.answer("natural_frequency", "Natural frequency", known.natural);
        sheet.answer("stiffness", "Stiffness of all mounts together", known.stiffness);
        self.answer_each(known.stiffness, sheet);
        sheet.answer("static_deflection", "Static deflection", deflection);
    }

    /// The stiffness of one mount.
    fn answer_each<W: Worksheet<Num = N>>(&self, stiffness: N, sheet: W) {
        let each =
            sheet.step("k₁", "N/m", stiffness / self.count, "Stiffness of each mount: they share the load");
        sheet.answer("stiffness_each", "Stiffness of each mount", each);
    }

    /// Transmissibility over the speeds, and what the disturbance does.
    fn assess<W: Worksheet<Num = N>>(
        &self,
        known: &Known<N>,
        required: Option<N>,
        speeds: &SpeedsGiven<W>,
        disturbance: Option<&DisturbanceGiven<W>>,
        sheet: W,
    ) -> Result<(), Refusal> {
        let lowest = speeds.lowest;
        let highest = speeds.highest.unwrap_or(lowest);
        if highest.value() < lowest.value() {
            return Err(Refusal::because(
                "the lowest speed is above the highest one: write the smaller speed as the lowest",
            ));
        }
        let zeta = known.zeta.value();
        let band = [lowest, highest].map(|speed| speed.value() / known.natural.value());
        let unbounded = || {
            Refusal::because(
                "without damping, the motion grows without bound at the natural frequency, which lies within the \
                 speeds: write some damping, or softer mounts",
            )
        };
        let worst = isolation::worst_transmission(Shaking::Force, zeta, band).ok_or_else(unbounded)?;
        let band = Band { ratios: band, speeds: [lowest, highest], natural: known.natural };
        let peak = || {
            let why = ("Frequency ratio of the largest transmissibility", RAO.at("§3.6"));
            sheet.step("r", "1", isolation::transmissibility_peak_ratio(known.zeta), why)
        };
        let (speed, ratio) = band.at(worst, ["ω_T", "r"], peak, sheet);
        let transmissibility = sheet.step(
            "TR",
            "1",
            sdof::transmissibility(ratio, known.zeta),
            ("Largest transmissibility within the speeds", RAO.at("§9.10")),
        );
        sheet.check(
            "transmissibility from the dynamic stiffness",
            (known.stiffness.powi(2) + (known.damping * speed).powi(2)).sqrt()
                / sdof::dynamic_stiffness(known.stiffness, self.mass, known.damping, speed),
            transmissibility,
        );
        if required.is_some_and(|required| transmissibility.value() > required.value() * (1.0 + 1e-9)) {
            sheet.warn(|| Text::new("these mounts do not isolate as required within these speeds"));
        }
        let kept =
            sheet.step("I", "%", W::Num::from(1.0) - transmissibility, "Isolation: what does not pass");
        sheet.answer("frequency_ratio", "Frequency ratio", ratio);
        sheet.answer("transmissibility", "Transmissibility", transmissibility);
        sheet.answer("isolation", "Isolation", kept);
        if transmissibility.value() > 1.0 {
            sheet.warn(|| {
                Text::new(
                    "the mounts amplify within these speeds: they isolate only from √2 times the natural frequency on",
                )
            });
        }
        if let Some(disturbance) = disturbance {
            let worst = (worst, speed, ratio);
            self.disturbed(disturbance, known, &band, worst, sheet).ok_or_else(unbounded)?;
        }
        let numbers = (known.natural.value(), zeta);
        let (level, band) = (required.map(Real::value), [lowest.value(), highest.value()]);
        sheet.show(|| {
            let plot = over_speed(numbers, level, band);
            // Of a range of speeds the answer is the largest transmissibility.
            Exhibit::Plot(if band[0] == band[1] { plot.over("question.judge.speeds.lowest") } else { plot })
        });
        sheet.show(|| Exhibit::Drawing(drawing()));
        Ok(())
    }

    /// Force on the floor and motion of the machine, each at its worst speed.
    fn disturbed<W: Worksheet<Num = N>>(
        &self,
        disturbance: &DisturbanceGiven<W>,
        known: &Known<N>,
        band: &Band<N>,
        passing: (f64, N, N),
        sheet: W,
    ) -> Option<()> {
        let zeta = known.zeta;
        let (shaking, strength) = match disturbance {
            DisturbanceGiven::Force { force } => (Shaking::Force, *force),
            DisturbanceGiven::Unbalance { unbalance } => (Shaking::Unbalance, *unbalance),
            DisturbanceGiven::Piston { mass, stroke } => {
                let why = "Unbalance of the piston: its mass times half the stroke";
                (Shaking::Unbalance, sheet.step("m₀e", "kg*m", *mass * *stroke / 2.0, why))
            }
        };
        let force_at = |speed: N| match shaking {
            Shaking::Force => strength,
            Shaking::Unbalance => strength * speed.powi(2),
        };
        // Where two of the worst speeds are the same, it is written once.
        let worst = isolation::worst_transmission(shaking, zeta.value(), band.ratios)?;
        let loudest = if worst == passing.0 {
            passing
        } else {
            let peak = || {
                let how = "Frequency ratio of the largest force: the slope of r² TR is zero there";
                let ratio = sheet.found("r_F", "1", worst, how);
                let (u, a) = (worst * worst, 4.0 * zeta.value() * zeta.value());
                let terms = [a * u * u * u, 2.0 * a * (a - 2.0) * u * u, (4.0 * a - 2.0) * u, 2.0];
                let scale = terms.iter().map(|term| term.abs()).sum();
                sheet.check_zero("the slope of the force is zero there", N::from(terms.iter().sum()), scale);
                ratio
            };
            let (speed, ratio) = band.at(worst, ["ω_F", "r_F"], peak, sheet);
            (worst, speed, ratio)
        };
        let (_, speed, ratio) = loudest;
        let transmitted = sheet.step(
            "F_T",
            "N",
            force_at(speed) * sdof::transmissibility(ratio, zeta),
            ("Largest force on the floor", RAO.at("§9.10")),
        );
        sheet.answer("transmitted_force", "Force on the floor", transmitted);
        let Known { stiffness, damping, .. } = *known;
        sheet.check(
            "force on the floor: that of springs and dampers in the motion of the machine",
            sdof::forced_amplitude(force_at(speed), stiffness, self.mass, damping, speed)
                * (stiffness.powi(2) + (damping * speed).powi(2)).sqrt(),
            transmitted,
        );
        let worst = isolation::worst_motion(shaking, zeta.value(), band.ratios)?;
        let (_, speed, ratio) = if worst == loudest.0 {
            loudest
        } else {
            let peak = || {
                let ratio = match shaking {
                    Shaking::Force => sdof::magnification_peak_ratio(zeta),
                    Shaking::Unbalance => sdof::unbalance_peak_ratio(zeta),
                };
                sheet.step("r_X", "1", ratio, ("Frequency ratio of the largest amplitude", RAO.at("§3.7")))
            };
            let (speed, ratio) = band.at(worst, ["ω_X", "r_X"], peak, sheet);
            (worst, speed, ratio)
        };
        let amplitude = match shaking {
            Shaking::Force => strength / known.stiffness * sdof::magnification(ratio, zeta),
            Shaking::Unbalance => strength / self.mass * sdof::unbalance_magnification(ratio, zeta),
        };
        let why = ("Largest amplitude of the machine", RAO.at("§3.7"));
        let amplitude = sheet.step("X", "mm", amplitude, why);
        sheet.check(
            "amplitude from the dynamic stiffness",
            sdof::forced_amplitude(force_at(speed), known.stiffness, self.mass, known.damping, speed),
            amplitude,
        );
        sheet.answer("amplitude", "Amplitude of the machine", amplitude);
        Some(())
    }
}

/// The transmissibility that is required.
fn wanted<W: Worksheet>(required: &RequirementGiven<W>, sheet: W) -> W::Num {
    match required {
        RequirementGiven::Transmissibility { transmissibility } => *transmissibility,
        RequirementGiven::Isolation { isolation } => {
            sheet.step("T", "1", W::Num::from(1.0) - *isolation, "Largest transmissibility: what may pass")
        }
    }
}

/// The frequency ratio from which the transmissibility is the required one or less.
fn required_ratio<W: Worksheet>(transmissibility: W::Num, zeta: W::Num, sheet: W) -> W::Num {
    let ratio = if zeta.value() == 0.0 {
        sheet.step(
            "r_T",
            "1",
            isolation::isolating_ratio_undamped(transmissibility),
            ("Frequency ratio needed, from T = 1/(r² − 1)", RAO.at("§9.10")),
        )
    } else {
        let sum = sheet.step(
            "b",
            "1",
            isolation::isolating_sum(transmissibility, zeta),
            "The transmissibility is T where r⁴ − 2b r² = 1/T² − 1",
        );
        sheet.step(
            "r_T",
            "1",
            isolation::isolating_ratio(transmissibility, sum),
            ("Frequency ratio needed: the positive root", RAO.at("§9.10")),
        )
    };
    sheet.check(
        "the transmissibility at that ratio is the required one",
        sdof::transmissibility(ratio, zeta),
        transmissibility,
    );
    ratio
}

/// Transmissibility against speed for several dampings, with the speeds of the machine shaded.
fn over_speed((natural, zeta): (f64, f64), required: Option<f64>, [lowest, highest]: [f64; 2]) -> Plot {
    let last = (1.25 * highest).max(2.5 * natural);
    let curve = |zeta: f64| -> Vec<(f64, f64)> {
        let at = |n: u16| last * f64::from(n) / 150.0;
        (0..=150)
            .map(at)
            .map(|speed| (speed, below(sdof::transmissibility(speed / natural, zeta), 100.0)))
            .collect()
    };
    let mut series = vec![Series::line("these mounts", curve(zeta)).of("transmissibility")];
    series.extend([0.05, 0.2, 0.5].map(|zeta| {
        let line = Series::line(Text::new("ζ = {ratio}").with_quantity("ratio", zeta, "1"), curve(zeta));
        line.of("transmissibility").with("question.judge.damping.ratio.ratio", zeta)
    }));
    let plot = Plot::new(
        "Transmissibility against speed",
        Axis::linear("speed", "rpm"),
        Axis::log("transmissibility", "1"),
        series,
    );
    let plot = if highest > lowest {
        plot.band("speeds of the machine", lowest, highest, true)
    } else {
        plot.mark("speed of the machine", (lowest, sdof::transmissibility(lowest / natural, zeta)))
    };
    match required {
        Some(required) => plot.level("required", required),
        None => plot,
    }
}

/// The machine on its mounts.
fn drawing() -> Drawing {
    let mount = |x: f64| {
        [
            DrawnShape::Spring((x - 0.15, -1.5), (x - 0.15, -0.6)),
            DrawnShape::Damper((x + 0.2, -1.5), (x + 0.2, -0.6)),
        ]
    };
    let mut shapes = vec![DrawnShape::Ground((-1.6, -1.5), (1.6, -1.5))];
    shapes.extend(mount(-0.9));
    shapes.extend(mount(0.9));
    shapes.extend([
        DrawnShape::Block((-1.3, -0.6), (1.3, -0.2), Ink::Faint),
        DrawnShape::Block((-0.8, -0.2), (0.8, 0.7), Ink::Body),
        DrawnShape::Label((0.0, 0.25), Text::from("m")),
        DrawnShape::Arrow((1.6, -0.4), (1.6, 0.4), Ink::Motion),
        DrawnShape::Label((1.7, 0.4), Text::from("X")),
        DrawnShape::Arrow((0.0, -1.6), (0.0, -2.3), Ink::Force),
        DrawnShape::Label((0.1, -2.3), Text::from("F_T")),
    ]);
    Drawing { title: "The machine on its mounts".into(), shapes }
}
