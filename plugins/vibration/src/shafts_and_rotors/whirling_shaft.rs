//! Whirl of an unbalanced rotor on a flexible shaft (the Jeffcott rotor) at one speed, on the way to it, and the
//! speeds to stay away from.

use std::f64::consts::{FRAC_1_SQRT_2, PI};

use dalembert_core::{
    About, Analysis, Axis, Drawing, Exhibit, Ink, Inputs, Plot, Refusal, Series, Sketch, Text, Worksheet,
    register,
};
use dalembert_mechanics::{Real, sdof, whirl};

mod forces;
mod limit;

use crate::{
    shared::jeffcott::{Mounting, RotorShaft, stiffness},
    sources::{RAO, SARKAR},
};

/// The rotor, its shaft and its speed.
#[derive(Clone, Debug, Inputs)]
pub struct WhirlingShaft {
    /// Mass of the rotor.
    #[input("m", "kg", positive)]
    pub mass: f64,
    /// Rotor unbalance.
    pub imbalance: Imbalance,
    /// Shaft.
    pub shaft: RotorShaft,
    /// Damping.
    pub damping: WhirlDamping,
    /// Speed.
    pub speed: ShaftSpeed,
    /// Shaft orientation.
    pub axis: ShaftAxis,
    /// Limit.
    /// If given, the speeds that satisfy it are also computed.
    pub limit: Option<WhirlLimit>,
}

/// Eccentricity of the centre of mass, or the unbalance that gives it.
#[derive(Clone, Debug, Inputs)]
pub enum Imbalance {
    /// Eccentricity given
    Eccentricity {
        /// Eccentricity.
        /// Distance of the centre of mass of the rotor from the shaft axis.
        #[input("e", "m", positive)]
        eccentricity: f64,
    },
    /// Unbalance given
    Unbalance {
        /// Unbalance.
        /// Mass of the rotor times the distance of its centre of mass from the axis.
        #[input("m₀e", "kg*m", positive)]
        unbalance: f64,
    },
}

/// Damping of the whirl.
#[derive(Clone, Debug, Inputs)]
pub enum WhirlDamping {
    /// Undamped
    Undamped,
    /// Damping ratio given
    Ratio {
        /// Damping ratio.
        #[input("ζ", "1", nonnegative)]
        ratio: f64,
    },
    /// Damping coefficient given
    /// Of the resistance of the surroundings at the rotor.
    Coefficient {
        /// Damping coefficient.
        #[input("c", "N*s/m", nonnegative)]
        coefficient: f64,
    },
    /// From the maximum whirl amplitude at any speed
    LargestAmplitude {
        /// Maximum whirl amplitude.
        #[input("Aₘₐₓ", "m", positive, kind = "Amplitude")]
        amplitude: f64,
    },
}

/// Speed of the shaft.
#[derive(Clone, Debug, Inputs)]
pub enum ShaftSpeed {
    /// Speed given
    Given {
        /// Speed of the shaft.
        #[input("ω", "rad/s", positive)]
        speed: f64,
    },
    /// Multiple of the critical speed
    Multiple {
        /// Speed over critical speed.
        /// 1 stands for the critical speed itself.
        #[input("r", "1", positive)]
        ratio: f64,
    },
}

/// Orientation of the shaft, which decides whether the weight of the rotor bends it.
#[derive(Clone, Debug, Inputs)]
pub enum ShaftAxis {
    /// Vertical, or weight neglected
    Vertical,
    /// Horizontal, the weight bends the shaft
    Horizontal {
        /// Acceleration of gravity.
        #[input("g", "m/s^2", positive, default = "9.81 m/s^2")]
        gravity: f64,
    },
}

/// Limit of the whirl.
#[derive(Clone, Debug, Inputs)]
pub enum WhirlLimit {
    /// Maximum whirl amplitude
    Amplitude {
        /// Maximum permitted whirl amplitude.
        #[input("R", "m", positive, kind = "Amplitude")]
        amplitude: f64,
    },
    /// Maximum bending stress of the shaft
    /// Including that due to the weight.
    Stress {
        /// Maximum permitted stress.
        #[input("σ_R", "Pa", positive)]
        stress: f64,
    },
    /// Maximum force of the whirl on the bearings
    /// On all bearings together, without the weight.
    Force {
        /// Maximum permitted force.
        #[input("F_R", "N", positive)]
        force: f64,
    },
}

register!(WhirlingShaft);

impl Analysis for WhirlingShaft {
    const ABOUT: About = About {
        id: "vibration/whirling-shaft",
        title: "Whirl of a rotor on a flexible shaft",
        topic: "Shafts and rotors",
        summary: "Critical speed, whirl amplitude and phase, bearing force and bending stress of an unbalanced rotor, and the speeds to avoid.",
        main: &["critical_speed", "amplitude", "bearing_force"],
        keywords: "jeffcott laval rotor critical speed whirling unbalance shaft stress run-up forbidden band velocidade \
                   crítica rodopio turbilhonamento precessão eixo flexível rotor desbalanceado faixa proibida \
                   critical speeds of shafts whirling of shafts velocidades críticas de eixos",
        sources: &[&RAO, &SARKAR],
        cases: include_str!("../../cases/whirling_shaft.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &WhirlingShaftGiven<W>, sheet: W) -> Result<(), Refusal> {
        let eccentricity = match &given.imbalance {
            ImbalanceGiven::Eccentricity { eccentricity } => *eccentricity,
            ImbalanceGiven::Unbalance { unbalance } => sheet.step(
                "e",
                "mm",
                *unbalance / given.mass,
                ("Distance of the centre of mass from the axis", RAO.at("§9.5")),
            ),
        };
        let k = stiffness(&self.shaft, &given.shaft, sheet);
        let natural = sheet.step(
            "ωₙ",
            "rpm",
            sdof::natural_frequency(k, given.mass),
            ("Critical speed: the natural frequency of the rotor on its shaft", RAO.at("§9.5")),
        );
        let zeta = damping_ratio(given, k, eccentricity, sheet)?;
        let (speed, ratio) = match &given.speed {
            ShaftSpeedGiven::Given { speed } => {
                let ratio = sheet.step("r", "1", sdof::frequency_ratio(*speed, natural), "Frequency ratio");
                (*speed, ratio)
            }
            ShaftSpeedGiven::Multiple { ratio } => {
                (sheet.step("ω", "rpm", *ratio * natural, "Speed of the shaft"), *ratio)
            }
        };
        let damped = zeta.filter(|zeta| zeta.value() > 0.0);
        if damped.is_none() && ratio.value() == 1.0 {
            return Err(Refusal::because(
                "without damping, the whirl at the critical speed grows without bound, in proportion to the time: \
                 there is no steady state",
            ));
        }
        sheet.answer("critical_speed", "Critical speed", natural);
        if let Some(zeta) = zeta {
            sheet.answer("damping_ratio", "Damping ratio", zeta);
        }
        let rotor = Rotor { mass: given.mass, eccentricity, stiffness: k, natural, damping_ratio: damped };
        let amplitude = whirl_at(&rotor, speed, ratio, sheet);
        forces::forces(self, given, &rotor, amplitude, sheet);
        run_up(&rotor, ratio, amplitude, sheet);
        if let ShaftAxisGiven::Horizontal { .. } = &given.axis {
            let secondary = sheet.step(
                "ω_g",
                "rpm",
                natural / 2.0,
                "Secondary critical speed of a horizontal shaft: with the weight, the unbalance produces two pulses per revolution",
            );
            sheet.answer("secondary_critical_speed", "Secondary critical speed (gravity), 2×", secondary);
        }
        let limit = match &given.limit {
            Some(limit) => Some(limit::speeds(self, given, limit, &rotor, sheet)?),
            None => None,
        };
        if zeta.map_or(0.0, Real::value) < 0.05 && (ratio.value() - 1.0).abs() < 0.05 {
            sheet.warn(|| {
                Text::new(
                    "the shaft turns within 5 % of its critical speed with little damping: small errors of mass, \
                     stiffness or speed change the amplitude greatly",
                )
            });
        }
        if let RotorShaft::Round { length, .. } = self.shaft
            && amplitude.value() > 0.1 * length
        {
            sheet.warn(|| {
                Text::new(
                    "the whirl amplitude exceeds a tenth of the shaft length: the deflections are not small, and no shaft withstands this",
                )
            });
        }
        let numbers = rotor.numbers();
        let at = (speed.value(), amplitude.value());
        sheet.show(|| Exhibit::Plot(amplitude_over_speed(numbers, at, limit.as_ref())));
        sheet.show(|| Exhibit::Plot(phase_over_speed(numbers, at.0)));
        sheet.show(|| Exhibit::Drawing(self.vectors(numbers, at)));
        Ok(())
    }
}

/// The rotor as numbers of the worksheet.
#[derive(Clone, Copy)]
struct Rotor<N> {
    mass: N,
    eccentricity: N,
    stiffness: N,
    natural: N,
    /// `None` without damping.
    damping_ratio: Option<N>,
}

impl<N: Real> Rotor<N> {
    /// Natural frequency, eccentricity, damping ratio.
    fn numbers(&self) -> [f64; 3] {
        [self.natural.value(), self.eccentricity.value(), self.damping_ratio.map_or(0.0, Real::value)]
    }
}

/// The damping ratio; `None` for an undamped rotor.
fn damping_ratio<W: Worksheet>(
    given: &WhirlingShaftGiven<W>,
    stiffness: W::Num,
    eccentricity: W::Num,
    sheet: W,
) -> Result<Option<W::Num>, Refusal> {
    Ok(match &given.damping {
        WhirlDampingGiven::Undamped {} => None,
        WhirlDampingGiven::Ratio { ratio } => Some(*ratio),
        WhirlDampingGiven::Coefficient { coefficient } => Some(sheet.step(
            "ζ",
            "1",
            sdof::damping_ratio(*coefficient, stiffness, given.mass),
            ("Damping ratio: damping over critical damping", RAO.at("§2.6")),
        )),
        WhirlDampingGiven::LargestAmplitude { amplitude } => {
            let peak = sheet.step(
                "Λₘₐₓ",
                "1",
                *amplitude / eccentricity,
                "Maximum whirl amplitude as a multiple of the eccentricity",
            );
            let zeta = sdof::damping_ratio_from_peak(peak).ok_or_else(|| {
                Refusal::because(
                    "the largest whirl amplitude is not above the eccentricity, so no damping gives a peak at a \
                     finite speed: write a larger amplitude",
                )
            })?;
            let light = || W::Num::from(0.5) / peak;
            sheet.common_error("ζ", "the formula for light damping, ζ = 1/(2Λ), used", light);
            let zeta = sheet.step(
                "ζ",
                "1",
                zeta,
                ("The peak is e/(2ζ√(1 − ζ²)), a quadratic equation in ζ²; its smaller root", RAO.at("§3.7")),
            );
            sheet.check(
                "substituting ζ reproduces the given peak amplitude",
                sdof::peak_magnification(zeta),
                peak,
            );
            Some(zeta)
        }
    })
}

/// Common error of the amplitude.
const OF_CENTRE: &str = "the distance of the centre of mass from the bearing axis used";

/// Amplitude and phase at the speed.
fn whirl_at<W: Worksheet>(rotor: &Rotor<W::Num>, speed: W::Num, ratio: W::Num, sheet: W) -> W::Num {
    let Rotor { mass, eccentricity, stiffness, .. } = *rotor;
    let one = W::Num::from(1.0);
    let (amplitude, phase, damping) = match rotor.damping_ratio {
        Some(zeta) => {
            let of_centre = || eccentricity * sdof::transmissibility(ratio, zeta);
            sheet.common_error("A", OF_CENTRE, of_centre);
            let amplitude = sheet.step(
                "A",
                "mm",
                whirl::whirl_amplitude(eccentricity, ratio, zeta),
                ("Whirl amplitude: the deflection of the shaft at the rotor", RAO.at("§9.5")),
            );
            let phase = sheet.step(
                "φ",
                "deg",
                sdof::phase_lag_from_ratios(ratio, zeta),
                ("The deflection lags the direction of the centre of mass by", RAO.at("§9.5")),
            );
            (amplitude, phase, Some(sdof::damping_from_ratio(zeta, stiffness, mass)))
        }
        None => {
            let of_centre = || eccentricity / (one - ratio.powi(2)).abs();
            sheet.common_error("A", OF_CENTRE, of_centre);
            let amplitude = sheet.step(
                "A",
                "mm",
                eccentricity * ratio.powi(2) / (one - ratio.powi(2)).abs(),
                ("Whirl amplitude: the deflection of the shaft at the rotor", RAO.at("§9.5")),
            );
            let (lag, how) = if ratio.value() < 1.0 {
                (
                    0.0,
                    "Below the critical speed, undamped: the centre of mass lies on the outside, in line with the deflection",
                )
            } else {
                (
                    PI,
                    "Above the critical speed, undamped: the centre of mass lies on the inside, opposite to the deflection",
                )
            };
            (amplitude, sheet.numerical("φ", "deg", lag, how), None)
        }
    };
    sheet.verify(|| {
        let inertia = mass * eccentricity * speed.powi(2);
        sheet.check(
            "amplitude from the dynamic stiffness",
            match damping {
                Some(damping) => {
                    sdof::unbalance_amplitude(mass * eccentricity, stiffness, mass, damping, speed)
                }
                None => inertia / (stiffness - mass * speed.powi(2)).abs(),
            },
            amplitude,
        );
        sheet.check_zero(
            "forces along the deflection: spring force minus inertia force = m e ω² cos φ",
            (stiffness - mass * speed.powi(2)) * amplitude - inertia * phase.cos(),
            inertia.value() + (stiffness * amplitude).value(),
        );
        if let Some(damping) = damping {
            sheet.check_zero(
                "forces perpendicular to the deflection: damping force = m e ω² sin φ",
                damping * speed * amplitude - inertia * phase.sin(),
                inertia.value(),
            );
        }
    });
    sheet.answer("frequency_ratio", "Speed over critical speed", ratio);
    sheet.answer("amplitude", "Whirl amplitude", amplitude);
    sheet.answer("phase", "Lag of the deflection behind the centre of mass", phase);
    amplitude
}

/// The largest steady amplitude at any speed up to that of the shaft.
fn run_up<W: Worksheet>(rotor: &Rotor<W::Num>, ratio: W::Num, amplitude: W::Num, sheet: W) {
    let Some(zeta) = rotor.damping_ratio else {
        if ratio.value() > 1.0 {
            sheet.warn(|| {
                Text::new(
                    "the shaft passes its critical speed before reaching its running speed, and without damping the amplitude there grows without bound, in proportion to time: run through it quickly",
                )
            });
        }
        return;
    };
    if zeta.value() >= FRAC_1_SQRT_2 {
        return;
    }
    let forced = || rotor.natural * sdof::magnification_peak_ratio(zeta);
    sheet.common_error("ωₘₐₓ", "the peak of the response to a constant force used", forced);
    let free = || sdof::damped_frequency(rotor.natural, zeta);
    sheet.common_error("ωₘₐₓ", "the frequency of the damped free vibration used", free);
    let worst = sheet.step(
        "ωₘₐₓ",
        "rpm",
        rotor.natural * sdof::unbalance_peak_ratio(zeta),
        ("Speed of maximum steady-state whirl amplitude", RAO.at("§3.7")),
    );
    let resonance = || rotor.eccentricity / (zeta * 2.0);
    sheet.common_error("Aₘₐₓ", "the amplitude at r = 1, e/(2ζ), used", resonance);
    let largest = sheet.step(
        "Aₘₐₓ",
        "mm",
        rotor.eccentricity * sdof::peak_magnification(zeta),
        ("Maximum steady-state whirl at any speed", RAO.at("§3.7")),
    );
    sheet.check(
        "the maximum whirl from the whirl amplitude at its speed",
        whirl::whirl_amplitude(rotor.eccentricity, worst / rotor.natural, zeta),
        largest,
    );
    sheet.answer("worst_speed", "Speed of maximum whirl amplitude", worst);
    sheet.answer("largest_amplitude", "Maximum whirl amplitude at any speed", largest);
    if ratio.value() * rotor.natural.value() > worst.value() && largest.value() > 3.0 * amplitude.value() {
        sheet.warn(|| {
            Text::new("a slow run-up reaches {largest} at {speed}; a fast one reaches less")
                .with_quantity("largest", largest.value(), "mm")
                .with_quantity("speed", worst.value(), "rpm")
        });
    }
}

/// The last speed of the plots.
fn last_speed(natural: f64, speed: f64) -> f64 {
    (1.15 * speed).max(2.5 * natural)
}

fn amplitude_over_speed(
    [natural, eccentricity, zeta]: [f64; 3],
    at: (f64, f64),
    limit: Option<&limit::Limited>,
) -> Plot {
    let last = last_speed(natural, at.0);
    let point = |speed: f64| (speed, whirl::whirl_amplitude(eccentricity, speed / natural, zeta));
    // Equal steps, and finer ones about the peak.
    let mut speeds: Vec<f64> = (1..=300).map(|n| last * f64::from(n) / 300.0).collect();
    speeds.extend((-60..=60).map(|n| natural * (1.0 + f64::from(n) / 60.0 * (4.0 * zeta).clamp(0.05, 0.5))));
    speeds.retain(|speed| *speed > 0.0 && *speed <= last);
    speeds.sort_by(f64::total_cmp);
    let mut plot = Plot::new(
        "Whirl amplitude against speed",
        Axis::linear("speed of the shaft", "rpm"),
        Axis::log("whirl amplitude", "mm"),
        vec![Series::line("A", speeds.into_iter().map(point).collect()).of("amplitude")],
    )
    .over("speed.given.speed")
    .level("eccentricity", eccentricity)
    .mark("at this speed", at);
    if let Some(limit) = limit {
        plot = plot.level("limit", limit.amplitude);
        for (from, to) in &limit.permitted {
            plot = plot.band("permitted", *from, *to, true);
        }
    }
    plot
}

fn phase_over_speed([natural, _, zeta]: [f64; 3], at: f64) -> Plot {
    let last = last_speed(natural, at);
    let point = |n: u16| {
        let speed = last * f64::from(n) / 400.0;
        (speed, sdof::phase_lag_from_ratios(speed / natural, zeta))
    };
    Plot::new(
        "Lag of the deflection against speed",
        Axis::linear("speed of the shaft", "rpm"),
        Axis::linear("lag", "deg"),
        vec![Series::line("φ", (0..=400).map(point).collect()).of("phase")],
    )
    .over("speed.given.speed")
    .mark("at this speed", (at, sdof::phase_lag_from_ratios(at / natural, zeta)))
}

impl WhirlingShaft {
    /// The shaft from its side, and the rotor along its axis.
    fn vectors(&self, [natural, eccentricity, zeta]: [f64; 3], (speed, amplitude): (f64, f64)) -> Drawing {
        let lag = sdof::phase_lag_from_ratios(speed / natural, zeta);
        // The longer of the two arrows has the length 1.6; the shorter one stays visible.
        let longer = amplitude.max(eccentricity);
        let [a, e] = [amplitude, eccentricity].map(|length| 1.6 * (length / longer).max(0.5));
        // The centre of mass is ahead of the deflection by the lag, in the sense of the rotation.
        let origin = (5.4, 0.0);
        let w = (origin.0 + a, 0.0);
        let g = (w.0 + e * lag.cos(), e * lag.sin());
        let mut sketch = Sketch::new(
            "The shaft, and its section (not to scale): bearing centre O, shaft centre W, centre of mass G",
        );
        let mounting = match &self.shaft {
            RotorShaft::Round { mounting, .. } => *mounting,
            RotorShaft::Stiffness { .. } => Mounting::SimplySupported,
        };
        let x = mounting.draw(&mut sketch);
        match &self.shaft {
            RotorShaft::Round { .. } => mounting.label(&mut sketch, 1.2),
            RotorShaft::Stiffness { .. } => {
                sketch.label("k", (-1.4, 0.0));
            }
        }
        let unbalance = match self.imbalance {
            Imbalance::Eccentricity { .. } => "e",
            Imbalance::Unbalance { .. } => "m₀e = m e",
        };
        sketch
            .mass("", (x - 0.35, -0.8), (x + 0.35, 0.8))
            .label("m", (x, 0.8))
            .circle(origin, a, Ink::Faint)
            .circle(w, 1.2, Ink::Body)
            .motion("", origin, w)
            .edge(unbalance, w, g, Ink::Danger)
            .label("G", g)
            .label("O", origin)
            .label("W", w)
            .couple("ω", w, (0.6, 1.9), Ink::Motion);
        sketch.finish()
    }
}
