//! The damped absorber: tuned with a damper (Den Hartog), or untuned and viscous (Houdaille, Lanchester).

use dalembert_core::{About, Analysis, Exhibit, Inputs, Refusal, Text, Worksheet, register};
use dalembert_mechanics::{Real, sdof, vibration::absorber::DampedAbsorber as Kernel};

mod exhibits;
mod full;
mod optimum;

use self::full::{InFull, off_level};
use crate::{
    shared::{
        main_springs::{MainSprings, MainSpringsGiven},
        oscillator::{Mass, mass},
    },
    sources::{BROCK, DEN_HARTOG, NISHIHARA, RAO},
};

/// The main system and its absorber.
#[derive(Clone, Debug, Inputs)]
pub struct DampedAbsorber {
    /// Main system.
    pub main: Main,
    /// Damping ratio of the main system.
    /// By itself, without the absorber.
    #[input("ζ", "1", nonnegative, below = 1, default = "0")]
    pub main_damping: f64,
    /// Absorber.
    pub absorber: Absorber,
    /// Frequency at which the motion is requested.
    pub at: Option<Frequency>,
}

/// Given quantities of the main system.
#[derive(Clone, Debug, Inputs)]
pub enum Main {
    /// Only the mass ratio
    /// The results are ratios.
    Ratio {
        /// Mass of the absorber over the main mass.
        /// In torsion, inertia over inertia.
        #[input("μ", "1", positive)]
        ratio: f64,
    },
    /// Masses and springs
    Masses {
        /// Main mass.
        mass: Mass,
        /// Springs of the main mass.
        springs: MainSprings,
        /// Mass of the absorber.
        #[input("m_a", "kg", positive)]
        absorber: f64,
        /// Amplitude of the force.
        /// On the main mass; for the amplitudes.
        #[input("F₀", "N", positive)]
        force: Option<f64>,
    },
}

/// Type of absorber.
#[derive(Clone, Debug, Inputs)]
pub enum Absorber {
    /// Tuned by the fixed points (Den Hartog)
    FixedPoints,
    /// Tuned for the minimum peak
    LeastPeak,
    /// Tuning and damping given
    Given {
        /// Tuning.
        tuning: Tuning,
        /// Damping.
        damping: AbsorberDamping,
    },
    /// Viscous without spring (Houdaille), optimum damping
    Houdaille,
    /// Viscous without spring, damping given
    Viscous {
        /// Damping.
        damping: ViscousDamping,
    },
}

/// Spring of the absorber, or its tuning.
#[derive(Clone, Debug, Inputs)]
pub enum Tuning {
    /// Ratio of the natural frequencies
    Ratio {
        /// Natural frequency of the absorber over that of the main system.
        /// Each by itself.
        #[input("f", "1", positive)]
        ratio: f64,
    },
    /// Natural frequency of the absorber
    Frequency {
        /// Natural frequency of the absorber.
        /// On a fixed base.
        #[input("ω_a", "rad/s", positive)]
        frequency: f64,
    },
    /// Stiffness of the absorber
    Stiffness {
        /// Stiffness of the spring.
        #[input("k_a", "N/m", positive)]
        stiffness: f64,
    },
}

/// Damper of a tuned absorber. The two damping ratios differ by the tuning: mind which one a book prints.
#[derive(Clone, Debug, Inputs)]
pub enum AbsorberDamping {
    /// Damping ratio relative to the absorber
    /// ζ_a = c/(2 m_a ω_a).
    ByAbsorber {
        /// Damping ratio.
        #[input("ζ_a", "1", nonnegative)]
        ratio: f64,
    },
    /// Damping ratio relative to the main frequency
    /// γ = c/(2 m_a ω_m), as in Den Hartog.
    ByMain {
        /// Damping ratio.
        #[input("γ", "1", nonnegative)]
        ratio: f64,
    },
    /// Damping coefficient
    Coefficient {
        /// Damping coefficient.
        #[input("c_a", "N*s/m", nonnegative)]
        coefficient: f64,
    },
}

/// Damper of a viscous absorber.
#[derive(Clone, Debug, Inputs)]
pub enum ViscousDamping {
    /// Damping ratio relative to the main frequency
    /// γ = c/(2 m_a ω_m).
    ByMain {
        /// Damping ratio.
        #[input("γ", "1", positive)]
        ratio: f64,
    },
    /// Damping coefficient
    Coefficient {
        /// Damping coefficient.
        #[input("c_a", "N*s/m", positive)]
        coefficient: f64,
    },
}

/// A frequency.
#[derive(Clone, Debug, Inputs)]
pub enum Frequency {
    /// Over the natural frequency
    Ratio {
        /// Frequency over the natural frequency of the main system.
        #[input("g", "1", positive)]
        ratio: f64,
    },
    /// Frequency given
    Given {
        /// Frequency.
        #[input("ω", "rad/s", positive)]
        frequency: f64,
    },
}

register!(DampedAbsorber);

impl Analysis for DampedAbsorber {
    const ABOUT: About = About {
        id: "vibration/damped-absorber",
        title: "Damped vibration absorber",
        topic: "Isolation, absorbers and instruments",
        summary: "Optimum tuning and damping of an absorber by the fixed points and for the minimum peak, of a viscous absorber without spring, and the response before and after.",
        main: &["peak", "magnification", "absorber_stiffness", "absorber_damping"],
        keywords: "tuned mass damper TMD Den Hartog Houdaille Lanchester optimum fixed points invariant points minimax \
                   absorvedor dinâmico amortecido amortecedor de massa sintonizado ótimo pontos fixos invariantes",
        sources: &[&DEN_HARTOG, &BROCK, &NISHIHARA, &RAO],
        cases: include_str!("../../cases/damped_absorber.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &DampedAbsorberGiven<W>, sheet: W) -> Result<(), Refusal> {
        let system = system(given, sheet)?;
        let chosen = match &given.absorber {
            AbsorberGiven::FixedPoints {} => {
                let classic = optimum::fixed_points(&system, sheet);
                optimum::least_peak(&system, sheet);
                classic
            }
            AbsorberGiven::LeastPeak {} => {
                let best = optimum::least_peak(&system, sheet).ok_or_else(no_peaks)?;
                optimum::fixed_points(&system, sheet);
                best
            }
            AbsorberGiven::Houdaille {} => optimum::viscous(&system, sheet)?,
            AbsorberGiven::Given { tuning, damping } => {
                let chosen = system.tuned(tuning, damping, sheet)?;
                optimum::fixed_points(&system, sheet);
                optimum::least_peak(&system, sheet);
                chosen
            }
            AbsorberGiven::Viscous { damping } => {
                let chosen = system.viscous(damping, sheet)?;
                optimum::viscous(&system, sheet).ok();
                chosen
            }
        };
        sheet.keep_going()?;
        assess(&system, &chosen, given.at.as_ref(), sheet)
    }
}

/// The main system, in ratios and in full where it is known.
struct AbsorberSystem<N> {
    ratio: N,
    zeta: N,
    body: Option<DampedMass<N>>,
}

/// Body with all parameters known.
struct DampedMass<N> {
    stiffness: N,
    natural: N,
    absorber: N,
    force: Option<N>,
}

/// Tuning and damping of an absorber: `f` is missing where it has no spring.
struct Chosen<N> {
    tuning: Option<N>,
    damping: N,
}

/// Common errors of the damping.
const OWN_FREQUENCY: &str = "the natural frequency of the absorber used in place of that of the main system";
const MAIN_MASS: &str = "the mass of the main system used in place of that of the absorber";

fn no_peaks() -> Refusal {
    Refusal::because(
        "the main system is so heavily damped that its response with this absorber has no peaks to equalise: write a smaller damping ratio, or a heavier absorber",
    )
}

fn needs_masses() -> Refusal {
    Refusal::because(
        "a stiffness, a damping coefficient or a frequency needs masses and springs of the main system: write them, or \
         give ratios",
    )
}

fn system<W: Worksheet>(given: &DampedAbsorberGiven<W>, sheet: W) -> Result<AbsorberSystem<W::Num>, Refusal> {
    let (ratio, body) = match &given.main {
        MainGiven::Ratio { ratio } => (*ratio, None),
        MainGiven::Masses { mass: main, springs, absorber, force } => {
            let mass = mass(main, sheet);
            let why = ("Natural frequency of the main system, without the absorber", RAO.at("§2.2"));
            let (stiffness, natural) = match springs {
                MainSpringsGiven::Stiffness { stiffness } => {
                    (*stiffness, sheet.step("ω_m", "rad/s", sdof::natural_frequency(*stiffness, mass), why))
                }
                MainSpringsGiven::NaturalFrequency { frequency } => {
                    let why = ("Stiffness that gives the main system its natural frequency", RAO.at("§2.2"));
                    let stiffness = sdof::stiffness_from_natural_frequency(mass, *frequency);
                    (sheet.step("k", "N/m", stiffness, why), *frequency)
                }
            };
            let ratio = sheet.step("μ", "1", *absorber / mass, "Mass ratio: absorber over main mass");
            (ratio, Some(DampedMass { stiffness, natural, absorber: *absorber, force: *force }))
        }
    };
    if !(1e-6..=1e6).contains(&ratio.value()) {
        return Err(Refusal::because(
            "the mass ratio of the absorber is not between 0.000001 and 1000000, where an absorber means something",
        ));
    }
    Ok(AbsorberSystem { ratio, zeta: given.main_damping, body })
}

impl<N: Real> AbsorberSystem<N> {
    fn kernel(&self, chosen: &Chosen<N>) -> Kernel {
        Kernel {
            mass_ratio: self.ratio.value(),
            main_damping: self.zeta.value(),
            tuning: chosen.tuning.map_or(0.0, Real::value),
            damping: chosen.damping.value(),
        }
    }

    /// A given spring and damper.
    fn tuned<W: Worksheet<Num = N>>(
        &self,
        tuning: &TuningGiven<W>,
        damping: &AbsorberDampingGiven<W>,
        sheet: W,
    ) -> Result<Chosen<N>, Refusal> {
        let why = ("Tuning: absorber frequency over main-system frequency, uncoupled", DEN_HARTOG.at("§3.3"));
        let tuning = match tuning {
            TuningGiven::Ratio { ratio } => *ratio,
            TuningGiven::Frequency { frequency } => {
                let body = self.body.as_ref().ok_or_else(needs_masses)?;
                sheet.step("f", "1", *frequency / body.natural, why)
            }
            TuningGiven::Stiffness { stiffness } => {
                let body = self.body.as_ref().ok_or_else(needs_masses)?;
                let own = sdof::natural_frequency(*stiffness, body.absorber);
                let own = sheet.step(
                    "ω_a",
                    "rad/s",
                    own,
                    ("Natural frequency of the absorber by itself", RAO.at("§2.2")),
                );
                sheet.step("f", "1", own / body.natural, why)
            }
        };
        let damping = match damping {
            AbsorberDampingGiven::ByMain { ratio } => *ratio,
            AbsorberDampingGiven::ByAbsorber { ratio } => sheet.step(
                "γ",
                "1",
                tuning * *ratio,
                "Damping ratio relative to the main frequency, c/(2 m_a ω_m) = f ζ_a",
            ),
            AbsorberDampingGiven::Coefficient { coefficient } => {
                if let Some(body) = &self.body {
                    let by_own = || *coefficient / (body.absorber * tuning * body.natural * 2.0);
                    sheet.common_error("γ", OWN_FREQUENCY, by_own);
                }
                self.by_main(*coefficient, sheet)?
            }
        };
        Ok(Chosen { tuning: Some(tuning), damping })
    }

    /// A given viscous damper.
    fn viscous<W: Worksheet<Num = N>>(
        &self,
        damping: &ViscousDampingGiven<W>,
        sheet: W,
    ) -> Result<Chosen<N>, Refusal> {
        let damping = match damping {
            ViscousDampingGiven::ByMain { ratio } => *ratio,
            ViscousDampingGiven::Coefficient { coefficient } => self.by_main(*coefficient, sheet)?,
        };
        Ok(Chosen { tuning: None, damping })
    }

    fn by_main<W: Worksheet<Num = N>>(&self, coefficient: N, sheet: W) -> Result<N, Refusal> {
        let body = self.body.as_ref().ok_or_else(needs_masses)?;
        let ratio = coefficient / (body.absorber * body.natural * 2.0);
        let by_main_mass = || coefficient * self.ratio / (body.absorber * body.natural * 2.0);
        sheet.common_error("γ", MAIN_MASS, by_main_mass);
        Ok(sheet.step("γ", "1", ratio, "Damping ratio relative to the main frequency, c/(2 m_a ω_m)"))
    }
}

/// The absorber in full, its peak and its stroke, and its motion at a frequency.
fn assess<W: Worksheet>(
    system: &AbsorberSystem<W::Num>,
    chosen: &Chosen<W::Num>,
    at: Option<&FrequencyGiven<W>>,
    sheet: W,
) -> Result<(), Refusal> {
    let kernel = system.kernel(chosen);
    let mut full = None;
    if let Some(body) = &system.body {
        let mut spring = None;
        if let Some(tuning) = chosen.tuning {
            let own = tuning * body.natural;
            let own = sheet.step("ω_a", "rad/s", own, "Natural frequency of the chosen absorber by itself");
            let stiffness = sdof::stiffness_from_natural_frequency(body.absorber, own);
            let by_main = || sdof::stiffness_from_natural_frequency(body.absorber, body.natural);
            let what = "the absorber tuned to the natural frequency of the main system";
            sheet.common_error("k_a", what, by_main);
            let stiffness = sheet.step("k_a", "N/m", stiffness, ("Its stiffness", RAO.at("§2.2")));
            sheet.answer("absorber_stiffness", "Stiffness of the absorber", stiffness);
            let by_own = || chosen.damping * body.absorber * own * 2.0;
            sheet.common_error("c_a", OWN_FREQUENCY, by_own);
            spring = Some(stiffness);
        }
        let damping = chosen.damping * body.absorber * body.natural * 2.0;
        let by_main_mass = || damping / system.ratio;
        sheet.common_error("c_a", MAIN_MASS, by_main_mass);
        let damping = sheet.step("c_a", "N*s/m", damping, "Damping coefficient of the absorber, 2 m_a ω_m γ");
        sheet.answer("absorber_damping", "Damping coefficient of the absorber", damping);
        let masses = InFull::of(body, system.zeta.value(), spring.map_or(0.0, Real::value), damping.value());
        sheet.verify(|| {
            let [main, relative] = masses.motion(body.stiffness.value(), body.natural.value());
            let [by_ratios, stroke] = [kernel.magnification(1.0), kernel.relative_motion(1.0)];
            let size = by_ratios.max(stroke);
            if size.is_finite() {
                let what = "main-mass motion at its natural frequency, from the full equations with spring and damper";
                sheet.check_sum(what, W::Num::from(main), W::Num::from(by_ratios), size);
                let what = "absorber motion at that frequency, from the full equations with spring and damper";
                sheet.check_sum(what, W::Num::from(relative), W::Num::from(stroke), size);
            }
        });
        full = Some(masses);
    }
    if kernel.damping == 0.0 && kernel.main_damping == 0.0 {
        sheet.warn(|| {
            Text::new("there is no damping: at both resonances the motion grows with time without bound, and there is no peak")
        });
    } else {
        peak(system, &kernel, full.as_ref(), sheet);
    }
    if let Some(at) = at {
        motion_at(system, chosen, &kernel, at, sheet)?;
    }
    let marked = kernel.largest_peak().filter(|peak| peak.height < 1e4);
    let natural = system.body.as_ref().map(|body| body.natural.value());
    let input = if natural.is_some() { "at.given.frequency" } else { "at.ratio.ratio" };
    sheet.show(|| Exhibit::Plot(exhibits::response(&kernel, natural, marked).over(input)));
    sheet.show(|| Exhibit::Plot(exhibits::stroke(&kernel, natural).over(input)));
    sheet.show(|| Exhibit::Plot(exhibits::family(&kernel).over("at.ratio.ratio")));
    sheet.show(|| Exhibit::Drawing(exhibits::drawing(chosen.tuning.is_some())));
    Ok(())
}

/// The largest motions over all frequencies.
fn peak<W: Worksheet>(system: &AbsorberSystem<W::Num>, kernel: &Kernel, full: Option<&InFull>, sheet: W) {
    let Some(peak) = kernel.largest_peak() else {
        sheet.warn(|| {
            Text::new("the response of the main system has no peak: it is largest at frequency zero")
        });
        return;
    };
    let ratio = sheet.numerical(
        "gₚ",
        "1",
        peak.ratio,
        "Frequency ratio of the highest peak: the response has zero slope there",
    );
    let height = sheet.numerical("Hₚ", "1", peak.height, "Maximum magnification with the chosen absorber");
    sheet.verify(|| {
        let [main, _] = optimum::equations(kernel, peak.ratio);
        sheet.check(
            "magnification at the peak from the equations of both masses",
            W::Num::from(main),
            height,
        );
    });
    sheet.answer("peak", "Maximum magnification with the chosen absorber", height);
    sheet.answer("peak_ratio", "Frequency ratio of the highest peak with the chosen absorber", ratio);
    sheet.verify(|| {
        if let Some([off, error]) = off_level(|g| kernel.magnification(g), ratio.value()) {
            sheet.check_residual("the slope of the response is zero at the peak", off.into(), 1.0, error);
        }
    });
    let before = kernel.main_damping;
    if before > 0.0 && before < 0.5f64.sqrt() {
        let why = ("Maximum magnification without the absorber", RAO.at("§3.4"));
        let before = sheet.step("H₀", "1", sdof::peak_magnification(system.zeta), why);
        sheet.answer("peak_before", "Maximum magnification without the absorber", before);
        sheet.check(
            "without the absorber: the magnification where the slope of the response is zero",
            sdof::magnification(sdof::magnification_peak_ratio(system.zeta), system.zeta),
            before,
        );
    } else if before == 0.0 {
        sheet.warn(|| {
            Text::new(
                "without the absorber and without damping, the amplitude at resonance grows without bound",
            )
        });
    }
    let relative = kernel.largest_relative_motion();
    let stroke = relative.map(|relative| {
        let how = "Maximum relative motion of the absorber, over the static deflection of the main mass";
        let stroke = sheet.numerical("Sₚ", "1", relative.height, how);
        sheet.verify(|| {
            let [_, found] = optimum::equations(kernel, relative.ratio);
            sheet.check("relative motion from the equations of both masses", W::Num::from(found), stroke);
        });
        sheet.answer("stroke_ratio", "Maximum relative motion over the static deflection", stroke);
        (stroke, relative.ratio)
    });
    if let Some((body, force)) = system.body.as_ref().and_then(|body| Some((body, body.force?))) {
        let still = sheet.step(
            "X_st",
            "mm",
            force / body.stiffness,
            ("Static deflection under the force", RAO.at("§3.3")),
        );
        let largest = sheet.step("Xₚ", "mm", height * still, "Maximum amplitude of the main mass");
        sheet.answer("amplitude", "Maximum amplitude of the main mass", largest);
        let motion = |ratio: f64| {
            full.map(|masses| masses.motion(force.value(), ratio * body.natural.value())).unwrap_or_default()
        };
        sheet.verify(|| {
            let [main, _] = motion(peak.ratio);
            let what = "amplitude of the main mass at the peak, from the equations of motion in full";
            sheet.check(what, largest, W::Num::from(main));
        });
        if let Some((stroke, at)) = stroke {
            let stroke = sheet.step(
                "Yₚ",
                "mm",
                stroke * still,
                "Maximum stroke of the absorber: clearance required on each side",
            );
            sheet.answer("stroke", "Maximum stroke of the absorber", stroke);
            sheet.verify(|| {
                let [_, relative] = motion(at);
                let what = "stroke of the absorber, from the full equations of motion";
                sheet.check(what, stroke, W::Num::from(relative));
            });
        }
    }
}

/// The motion at one frequency.
fn motion_at<W: Worksheet>(
    system: &AbsorberSystem<W::Num>,
    chosen: &Chosen<W::Num>,
    kernel: &Kernel,
    at: &FrequencyGiven<W>,
    sheet: W,
) -> Result<(), Refusal> {
    let ratio = match at {
        FrequencyGiven::Ratio { ratio } => *ratio,
        FrequencyGiven::Given { frequency } => {
            let body = system.body.as_ref().ok_or_else(needs_masses)?;
            let why = "Frequency over the natural frequency of the main system";
            sheet.step("g", "1", *frequency / body.natural, why)
        }
    };
    if kernel.relative_motion(ratio.value()) > 1e12 {
        return Err(Refusal::because(
            "there is no damping and this frequency is a resonance: the motion grows with time without bound",
        ));
    }
    let (one, square) = (W::Num::from(1.0), ratio.powi(2));
    let (zeta, gamma) = (system.zeta, chosen.damping);
    let spring = match chosen.tuning {
        Some(tuning) => tuning.powi(2) - square,
        None => -square,
    };
    let why = ("Absorber by itself at this frequency, f² − g²", DEN_HARTOG.at("§3.3"));
    let spring = sheet.step("A", "1", spring, why);
    let why = ("Its damper", DEN_HARTOG.at("§3.3"));
    let damper = sheet.step("B", "1", gamma * ratio * 2.0, why);
    let real = spring * (one - square) - zeta * gamma * square * 4.0;
    let real = match chosen.tuning {
        Some(tuning) => real - system.ratio * tuning.powi(2) * square,
        None => real,
    };
    let why = ("Determinant of the equations of both masses: real part", DEN_HARTOG.at("§3.3"));
    let real = sheet.step("C", "1", real, why);
    let imaginary = ratio * 2.0 * (zeta * spring + gamma * (one - (one + system.ratio) * square));
    let why = ("Imaginary part", DEN_HARTOG.at("§3.3"));
    let imaginary = sheet.step("D", "1", imaginary, why);
    let size = real.powi(2) + imaginary.powi(2);
    let why = ("Magnification of the main mass at this frequency", DEN_HARTOG.at("§3.3"));
    let main = sheet.step("H", "1", ((spring.powi(2) + damper.powi(2)) / size).sqrt(), why);
    let why = ("Relative motion of the absorber, over the static deflection", DEN_HARTOG.at("§3.3"));
    let absolute = || {
        let held = chosen.tuning.map_or(W::Num::from(0.0), |tuning| tuning.powi(4));
        ((held + damper.powi(2)) / size).sqrt()
    };
    let what = "the absolute motion of the absorber taken in place of the relative one";
    sheet.common_error("S", what, absolute);
    let relative = sheet.step("S", "1", square / size.sqrt(), why);
    sheet.verify(|| {
        let [again, moved] = optimum::equations(kernel, ratio.value());
        let what = "magnification at this frequency from the equations of both masses";
        sheet.check_zero(what, W::Num::from(again) - main, main.value().max(relative.value()));
        sheet.check("relative motion from the equations of both masses", W::Num::from(moved), relative);
    });
    sheet.answer("magnification", "Magnification at this frequency", main);
    sheet.answer("relative_motion", "Relative motion at this frequency over the static deflection", relative);
    Ok(())
}
