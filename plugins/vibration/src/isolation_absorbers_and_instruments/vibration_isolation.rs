//! Mounts that keep the vibration of a machine from its floor, or a blow from what is packed.

use dalembert_core::{About, Analysis, Exhibit, Inputs, Refusal, Text, Worksheet, register};
use dalembert_mechanics::{
    Real, sdof,
    vibration::isolation::{self, Shaking},
};

mod pictures;
mod shock;

use crate::{
    shared::oscillator::{
        Elasticity, Loss, Mass, MassAndStiffness, Suspension, ViscousDamping, mass, suspension,
    },
    sources::{RAO, THOMSON},
};

/// Inputs: the machine, and the requirement on its mounts.
#[derive(Clone, Debug, Inputs)]
pub struct VibrationIsolation {
    /// Machine.
    pub mass: Mass,
    /// Mass of the inertia block.
    /// An inertia block under the machine moves with it: less motion, and the same force on the floor for the same
    /// static deflection.
    #[input("m_b", "kg", positive)]
    pub block: Option<f64>,
    /// Number of mounts.
    /// All equal, each carrying its share of the weight.
    #[input(min = 1, max = 1000, default = "4")]
    pub mounts: u32,
    /// Gravity.
    #[input("g", "m/s^2", positive, default = "9.81 m/s^2", default_before = "9.80665 m/s^2")]
    pub gravity: f64,
    /// Find.
    pub question: IsolationTask,
}

/// Quantity to compute of the mounts.
#[derive(Clone, Debug, Inputs)]
pub enum IsolationTask {
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
        /// Total of all mounts.
        elasticity: Elasticity,
        /// Damping.
        damping: ViscousDamping,
        /// Speeds.
        speeds: Speeds,
        /// Disturbance.
        disturbance: Option<Disturbance>,
        /// Required.
        /// The lowest speed at which these mounts reach it is computed.
        required: Option<Requirement>,
    },
    /// Mounts for a shock
    Shock {
        /// Arrival.
        arrival: shock::Arrival,
        /// Maximum acceleration.
        /// Permitted for the machine.
        #[input("A", "m/s^2", positive)]
        acceleration: f64,
        /// Maximum travel.
        /// Available space for the mounts.
        #[input("d", "m", positive)]
        travel: Option<f64>,
    },
}

/// Required isolation.
#[derive(Clone, Debug, Inputs)]
pub enum Requirement {
    /// Maximum transmissibility
    Transmissibility {
        /// Transmissibility.
        #[input("T", "1", positive, below = 1)]
        transmissibility: f64,
    },
    /// Minimum isolation
    Isolation {
        /// Isolation.
        /// The fraction of the force or motion that is not transmitted: 85 % for a transmissibility of 0.15.
        #[input("I_r", "%", positive, fraction, below = 100)]
        isolation: f64,
    },
}

/// The speeds at which the machine runs, or the frequencies at which the base shakes.
#[derive(Clone, Debug, Inputs)]
pub struct Speeds {
    /// Minimum speed.
    #[input("ω₁", "rad/s", positive)]
    pub lowest: f64,
    /// Maximum speed.
    /// For a machine that runs at more than one.
    #[input("ω₂", "rad/s", positive)]
    pub highest: Option<f64>,
}

/// Excitation of the machine.
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
        /// Reciprocating mass.
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
        summary: "Stiffness and static deflection of mounts for a required isolation over a speed range, the isolation of given mounts, and mounts for a shock.",
        main: &["stiffness", "stiffness_each", "transmissibility", "static_deflection"],
        keywords: "isolator mount transmissibility inertia block static deflection drop packaging isolamento \
                   isolador coxim calço transmissibilidade bloco de inércia deflexão estática choque vibration \
                   isolation isolation of vibrations isolamento de vibrações machine foundation block foundation \
                   fundação de máquina",
        sources: &[&RAO, &THOMSON],
        cases: include_str!("../../cases/vibration_isolation.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &VibrationIsolationGiven<W>, sheet: W) -> Result<(), Refusal> {
        let machine = mass(&given.mass, sheet);
        let mass = match given.block {
            Some(block) => sheet.step("m_t", "kg", machine + block, "Mass on the mounts: machine and block"),
            None => machine,
        };
        let mounts = Mounts { mass, count: f64::from(self.mounts), gravity: given.gravity };
        sheet.show(|| Exhibit::Drawing(self.drawing()));
        match &given.question {
            IsolationTaskGiven::Design { required, damping_ratio, speeds, disturbance } => {
                mounts.design(required, *damping_ratio, speeds, disturbance.as_ref(), sheet)
            }
            IsolationTaskGiven::Judge { elasticity, damping, speeds, disturbance, required } => {
                let suspension = suspension(Some(mass), elasticity, &damping.given(), sheet)?;
                mounts.answer_isolation(&suspension, required.as_ref(), speeds, disturbance.as_ref(), sheet)
            }
            IsolationTaskGiven::Shock { arrival, acceleration, travel } => {
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
                let why = "Frequency ratio at the worst-case speed";
                (self.speeds[end], sheet.step(ratio, "1", self.speeds[end] / self.natural, why))
            }
            None => {
                let ratio = within();
                (sheet.step(speed, "rpm", ratio * self.natural, "Worst-case speed, within the range"), ratio)
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
        if let Some(highest) = speeds.highest {
            sheet.common_error("ωₙ", "the highest speed used in place of the lowest", || highest / ratio);
        }
        let natural = sheet.step(
            "ωₙ",
            "rad/s",
            speeds.lowest / ratio,
            ("Highest natural frequency: the lowest speed is the worst case, since the transmissibility falls above it", RAO.at("§9.10")),
        );
        let stiffness = sheet.step(
            "k",
            "N/m",
            sdof::stiffness_from_natural_frequency(self.mass, natural),
            ("Maximum total stiffness of the mounts", RAO.at("§2.2")),
        );
        let why = ("Total damping coefficient of the mounts", RAO.at("§2.6"));
        let damping = sheet.step("c", "N*s/m", sdof::damping_from_ratio(zeta, stiffness, self.mass), why);
        sheet.answer("required_ratio", "Required frequency ratio", ratio);
        let known = Known { natural, stiffness, damping, zeta };
        self.answer(&known, sheet);
        self.assess(&known, Some(transmissibility), speeds, disturbance, sheet)
    }

    /// Given mounts.
    fn answer_isolation<W: Worksheet<Num = N>>(
        &self,
        suspension: &Suspension<N>,
        required: Option<&RequirementGiven<W>>,
        speeds: &SpeedsGiven<W>,
        disturbance: Option<&DisturbanceGiven<W>>,
        sheet: W,
    ) -> Result<(), Refusal> {
        let (Some(MassAndStiffness { stiffness, .. }), Loss::Viscous(zeta, Some(damping))) =
            (suspension.body, suspension.loss)
        else {
            unreachable!("the mass is given and the damping is viscous")
        };
        let known = Known { natural: suspension.natural, stiffness, damping, zeta };
        self.answer(&known, sheet);
        let wanted = required.map(|required| {
            let transmissibility = wanted(required, sheet);
            let ratio = required_ratio(transmissibility, zeta, sheet);
            let why = ("Minimum speed at which the mounts provide the required isolation", RAO.at("§9.10"));
            let least = sheet.step("ω_min", "rpm", ratio * known.natural, why);
            sheet.answer("required_ratio", "Required frequency ratio", ratio);
            sheet.answer("least_speed", "Minimum speed with the required isolation", least);
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
        let on_one = || self.gravity / known.natural.powi(2) * self.count;
        sheet.common_error("δ_st", "the whole weight taken to rest on one mount", on_one);
        let deflection = sheet.step(
            "δ_st",
            "mm",
            self.gravity / known.natural.powi(2),
            ("Static deflection under the weight, k δ_st = m g", RAO.at("§2.2")),
        );
        sheet.check("the mounts carry the weight", known.stiffness * deflection, self.mass * self.gravity);
        sheet.answer("mass", "Mass on the mounts", self.mass);
        sheet.answer("natural_frequency", "Natural frequency", known.natural);
        sheet.answer("stiffness", "Total stiffness of the mounts", known.stiffness);
        self.answer_each(known.stiffness, sheet);
        sheet.answer("static_deflection", "Static deflection", deflection);
    }

    /// The stiffness of one mount.
    fn answer_each<W: Worksheet<Num = N>>(&self, stiffness: N, sheet: W) {
        sheet.common_error("k₁", "the mounts taken as springs in series", || stiffness * self.count);
        let each = sheet.step(
            "k₁",
            "N/m",
            stiffness / self.count,
            "Stiffness of each mount: the load is shared equally",
        );
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
                "without damping, the motion grows without bound at the natural frequency, which lies within the speed range: write some damping, or softer mounts",
            )
        };
        let worst = isolation::worst_transmission(Shaking::Force, zeta, band).ok_or_else(unbounded)?;
        let band = Band { ratios: band, speeds: [lowest, highest], natural: known.natural };
        let peak = || {
            let why = ("Frequency ratio at maximum transmissibility", RAO.at("§3.6"));
            let of_motion = || sdof::magnification_peak_ratio(known.zeta);
            sheet.common_error("r", "the frequency ratio of the largest magnification used", of_motion);
            sheet.common_error("r", "the largest value assumed at the natural frequency", || N::from(1.0));
            sheet.step("r", "1", isolation::transmissibility_peak_ratio(known.zeta), why)
        };
        let (speed, ratio) = band.at(worst, ["ω_T", "r"], peak, sheet);
        let magnification = || sdof::magnification(ratio, known.zeta);
        sheet.common_error("TR", "the magnification used in place of the transmissibility", magnification);
        let undamped = || N::from(1.0) / (N::from(1.0) - ratio.powi(2)).abs();
        sheet.common_error("TR", "the damping of the mounts neglected", undamped);
        let transmissibility = sheet.step(
            "TR",
            "1",
            sdof::transmissibility(ratio, known.zeta),
            ("Maximum transmissibility within the speed range", RAO.at("§9.10")),
        );
        sheet.check(
            "transmissibility from the dynamic stiffness",
            (known.stiffness.powi(2) + (known.damping * speed).powi(2)).sqrt()
                / sdof::dynamic_stiffness(known.stiffness, self.mass, known.damping, speed),
            transmissibility,
        );
        if required.is_some_and(|required| transmissibility.value() > required.value() * (1.0 + 1e-9)) {
            sheet.warn(|| {
                Text::new("these mounts do not provide the required isolation within this speed range")
            });
        }
        let kept =
            sheet.step("I", "%", W::Num::from(1.0) - transmissibility, "Isolation: the part not transmitted");
        sheet.answer("frequency_ratio", "Frequency ratio", ratio);
        sheet.answer("transmissibility", "Transmissibility", transmissibility);
        sheet.answer("isolation", "Isolation", kept);
        if transmissibility.value() > 1.0 {
            sheet.warn(|| {
                Text::new(
                    "the mounts amplify within this speed range: they isolate only above √2 times the natural frequency",
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
            let plot = pictures::over_speed(numbers, level, band);
            // Of a range of speeds the answer is the largest transmissibility.
            Exhibit::Plot(if band[0] == band[1] { plot.over("question.judge.speeds.lowest") } else { plot })
        });
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
                let how = "Frequency ratio at maximum force: the slope of r² TR is zero there";
                let ratio = sheet.numerical("r_F", "1", worst, how);
                let (u, a) = (worst * worst, 4.0 * zeta.value() * zeta.value());
                let terms = [a * u * u * u, 2.0 * a * (a - 2.0) * u * u, (4.0 * a - 2.0) * u, 2.0];
                let scale = terms.iter().map(|term| term.abs()).sum();
                sheet.check_zero(
                    "the slope of the force is zero at that speed",
                    N::from(terms.iter().sum()),
                    scale,
                );
                ratio
            };
            let (speed, ratio) = band.at(worst, ["ω_F", "r_F"], peak, sheet);
            (worst, speed, ratio)
        };
        let (_, speed, ratio) = loudest;
        let springs = || force_at(speed) * sdof::magnification(ratio, zeta);
        sheet.common_error("F_T", "the force of the dampers omitted", springs);
        let scalars = || springs() * (zeta * ratio * 2.0 + 1.0);
        sheet.common_error("F_T", "the forces of springs and dampers added as if in phase", scalars);
        let transmitted = sheet.step(
            "F_T",
            "N",
            force_at(speed) * sdof::transmissibility(ratio, zeta),
            ("Maximum force on the floor", RAO.at("§9.10")),
        );
        sheet.answer("transmitted_force", "Force on the floor", transmitted);
        let Known { stiffness, damping, .. } = *known;
        sheet.check(
            "force on the floor: spring and damper forces for the motion of the machine",
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
                sheet.step("r_X", "1", ratio, ("Frequency ratio at maximum amplitude", RAO.at("§3.7")))
            };
            let (speed, ratio) = band.at(worst, ["ω_X", "r_X"], peak, sheet);
            (worst, speed, ratio)
        };
        let amplitude = match shaking {
            Shaking::Force => strength / known.stiffness * sdof::magnification(ratio, zeta),
            Shaking::Unbalance => strength / self.mass * sdof::unbalance_magnification(ratio, zeta),
        };
        let why = ("Maximum amplitude of the machine", RAO.at("§3.7"));
        let over = || match shaking {
            Shaking::Force => strength / known.stiffness,
            Shaking::Unbalance => strength / self.mass,
        };
        let transmitted = || over() * sdof::transmissibility(ratio, zeta);
        sheet.common_error("X", "the transmissibility used for the amplitude of the machine", transmitted);
        if shaking == Shaking::Unbalance {
            let constant = || over() * sdof::magnification(ratio, zeta);
            sheet.common_error("X", "the magnification of a force of constant amplitude used", constant);
        }
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
        RequirementGiven::Isolation { isolation } => sheet.step(
            "T",
            "1",
            W::Num::from(1.0) - *isolation,
            "Maximum transmissibility: the part that may be transmitted",
        ),
    }
}

/// The frequency ratio from which the transmissibility is the required one or less.
fn required_ratio<W: Worksheet>(transmissibility: W::Num, zeta: W::Num, sheet: W) -> W::Num {
    let ratio = if zeta.value() == 0.0 {
        sheet.step(
            "r_T",
            "1",
            isolation::isolating_ratio_undamped(transmissibility),
            ("Required frequency ratio, from T = 1/(r² − 1)", RAO.at("§9.10")),
        )
    } else {
        let sum = sheet.step(
            "b",
            "1",
            isolation::isolating_sum(transmissibility, zeta),
            "The transmissibility is T where r⁴ − 2b r² = 1/T² − 1",
        );
        let undamped = || isolation::isolating_ratio_undamped(transmissibility);
        sheet.common_error("r_T", "the damping of the mounts neglected", undamped);
        let of_motion = || {
            let half = W::Num::from(1.0) - zeta.powi(2) * 2.0;
            let rest = W::Num::from(1.0) / transmissibility.powi(2) - 1.0;
            (half + (half.powi(2) + rest).sqrt()).sqrt()
        };
        sheet.common_error("r_T", "the magnification set equal to the required transmissibility", of_motion);
        sheet.step(
            "r_T",
            "1",
            isolation::isolating_ratio(transmissibility, sum),
            ("Required frequency ratio: the positive root", RAO.at("§9.10")),
        )
    };
    sheet.check(
        "the transmissibility at that ratio is the required one",
        sdof::transmissibility(ratio, zeta),
        transmissibility,
    );
    ratio
}
