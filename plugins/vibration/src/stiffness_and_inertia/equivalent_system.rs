//! A lever, a rolling body or a pulley with springs and dampers, as one inertia, one spring and one damper.

use dalembert_core::{
    About, Analysis, Axis, Exhibit, Inputs, Plot, Refusal, Series, Text, Worksheet, register,
};
use dalembert_mechanics::{Real, sdof};

use crate::{
    shared::{
        decay::damped_frequency_error,
        inertia::{Inertia, RollingShape},
    },
    sources::{KELLY, RAO},
};

mod body;
mod checks;
mod sketch;

use self::body::Terms;

/// A body that turns through a small angle, and what is attached to it.
#[derive(Clone, Debug, Inputs)]
pub struct EquivalentSystem {
    /// Body.
    pub body: TurningBody,
    /// Springs.
    pub springs: Vec<AttachedSpring>,
    /// Dampers.
    pub dampers: Vec<AttachedDamper>,
    /// Distance of a reference point.
    /// If given, mass, stiffness and damping are also reduced to that point. From the pivot, the ground or the axle.
    #[input("p", "m", positive)]
    pub reference: Option<f64>,
    /// Harmonic load.
    pub load: Option<HarmonicLoad>,
}

/// The body and its way of turning.
#[derive(Clone, Debug, Inputs)]
pub enum TurningBody {
    /// Lever on a pivot
    Lever {
        /// Bar.
        bar: LeverBar,
        /// Position of equilibrium.
        position: LeverPosition,
        /// Masses on the lever.
        masses: Vec<LeverMass>,
    },
    /// Rolling body
    /// It does not slip on the ground, or on a vertical cord.
    Rolling {
        /// Mass.
        #[input("m", "kg", positive)]
        mass: f64,
        /// Radius.
        #[input("r", "m", positive)]
        radius: f64,
        /// Shape.
        shape: RollingShape,
        /// Surface.
        surface: RollingSurface,
        /// Masses on cords.
        masses: Vec<CordMass>,
    },
    /// Pulley on a fixed axle
    Pulley {
        /// Inertia.
        inertia: Inertia,
        /// Masses on cords.
        masses: Vec<CordMass>,
    },
}

/// The bar of a lever.
#[derive(Clone, Debug, Inputs)]
pub enum LeverBar {
    /// Light
    Light,
    /// Uniform bar
    Uniform {
        /// Mass of the bar.
        #[input("m", "kg", positive)]
        mass: f64,
        /// Length of the bar.
        #[input("L", "m", positive)]
        length: f64,
        /// Distance of the pivot from one end.
        /// The other end lies on the side of the positive distances.
        #[input("e", "m", nonnegative, default = "0 m")]
        pivot: f64,
    },
    /// Moment of inertia given
    Given {
        /// Moment of inertia about the pivot.
        #[input("J_O", "kg*m^2", positive)]
        inertia: f64,
        /// Mass of the bar.
        #[input("m", "kg", positive)]
        mass: f64,
        /// Distance of the centre of mass from the pivot.
        /// Negative on the other side of the pivot.
        #[input("d", "m")]
        centre: f64,
    },
}

/// Position in which a lever is in equilibrium.
#[derive(Clone, Debug, Inputs)]
pub enum LeverPosition {
    /// Horizontal
    /// The springs balance the weights, which have no other effect.
    Horizontal,
    /// Hanging vertically
    /// The positive distances are below the pivot.
    Hanging {
        /// Gravity.
        #[input("g", "m/s^2", positive, default = "9.81 m/s^2")]
        gravity: f64,
    },
    /// Standing vertically
    /// The positive distances are above the pivot.
    Standing {
        /// Gravity.
        #[input("g", "m/s^2", positive, default = "9.81 m/s^2")]
        gravity: f64,
    },
}

/// A mass on a lever.
#[derive(Clone, Debug, Inputs)]
pub struct LeverMass {
    /// Mass.
    #[input("m", "kg", positive)]
    pub mass: f64,
    /// Distance from the pivot.
    /// Negative on the other side of the pivot.
    #[input("l", "m")]
    pub distance: f64,
    /// Moment of inertia about its centre.
    /// Omitted for a point mass.
    #[input("J_G", "kg*m^2", positive)]
    pub inertia: Option<f64>,
}

/// A mass that a cord moves along a line.
#[derive(Clone, Debug, Inputs)]
pub struct CordMass {
    /// Mass.
    #[input("m", "kg", positive)]
    pub mass: f64,
    /// Arm of the cord.
    /// Radius on the pulley; height above the ground on a rolling body.
    #[input("l", "m", positive)]
    pub arm: f64,
}

/// The surface under a rolling body.
#[derive(Clone, Debug, Inputs)]
pub enum RollingSurface {
    /// Flat ground or vertical cord
    Flat,
    /// Inside of a cylinder
    Trough {
        /// Radius of the surface.
        #[input("R", "m", positive)]
        radius: f64,
        /// Gravity.
        #[input("g", "m/s^2", positive, default = "9.81 m/s^2")]
        gravity: f64,
    },
}

/// A spring between the body and the frame.
#[derive(Clone, Debug, Inputs)]
pub enum AttachedSpring {
    /// Spring
    Linear {
        /// Stiffness.
        #[input("k", "N/m", positive)]
        stiffness: f64,
        /// Arm.
        /// From the pivot; radius on the pulley; height above the ground on a rolling body.
        #[input("a", "m")]
        arm: f64,
        /// Angle to the motion of its end.
        /// Omitted for a spring along the motion.
        #[input("α", "deg", min = -89.9, max = 89.9)]
        angle: Option<f64>,
    },
    /// Torsional spring
    Torsional {
        /// Torsional stiffness.
        #[input("k_t", "N*m/rad", positive)]
        stiffness: f64,
    },
}

/// A damper between the body and the frame.
#[derive(Clone, Debug, Inputs)]
pub enum AttachedDamper {
    /// Damper
    Linear {
        /// Damping coefficient.
        #[input("c", "N*s/m", positive)]
        coefficient: f64,
        /// Arm.
        /// From the pivot; radius on the pulley; height above the ground on a rolling body.
        #[input("b", "m")]
        arm: f64,
    },
    /// Torsional damper
    Torsional {
        /// Torsional damping coefficient.
        #[input("c_t", "N*m*s/rad", positive)]
        coefficient: f64,
    },
}

/// A harmonic force or moment on the body.
#[derive(Clone, Debug, Inputs)]
pub struct HarmonicLoad {
    /// Frequency of the load.
    #[input("ω", "rad/s", positive)]
    pub frequency: f64,
    /// Amplitude.
    pub amplitude: LoadAmplitude,
}

/// Amplitude of a harmonic load.
#[derive(Clone, Debug, Inputs)]
pub enum LoadAmplitude {
    /// Force
    Force {
        /// Amplitude of the force.
        #[input("F₀", "N", positive)]
        force: f64,
        /// Arm of the force.
        #[input("a_F", "m", positive)]
        arm: f64,
    },
    /// Moment
    Moment {
        /// Amplitude of the moment.
        #[input("M₀", "N*m", positive)]
        moment: f64,
    },
}

register!(EquivalentSystem);

impl Analysis for EquivalentSystem {
    const ABOUT: About = About {
        id: "vibration/equivalent-system",
        title: "Lever, rolling body or pulley",
        topic: "Stiffness and inertia",
        summary: "Equivalent inertia, stiffness and damping of a lever, a rolling body or a pulley with masses, springs and dampers; natural frequency, damping ratio, stability, amplitude under a harmonic load.",
        main: &["natural_frequency", "damping_ratio", "amplitude"],
        keywords: "equivalent system lever bar hinged pivot dashpot inverted pendulum rolling cylinder disc \
                   sphere trough pulley cord block generalized coordinate energy method critical damping \
                   stability sistema equivalente alavanca barra articulada pêndulo invertido cilindro rolando \
                   polia cabo amortecedor estabilidade single degree of freedom um grau de liberdade",
        sources: &[&RAO, &KELLY],
        cases: include_str!("../../cases/equivalent_system.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &EquivalentSystemGiven<W>, sheet: W) -> Result<(), Refusal> {
        let terms = body::terms(given, sheet)?;
        let Terms { inertia, stiffness, damping, .. } = terms;
        sheet.answer("inertia", "Equivalent moment of inertia", inertia);
        sheet.answer("stiffness", "Equivalent torsional stiffness", stiffness);
        if let Some(damping) = damping {
            sheet.answer("damping", "Equivalent torsional damping", damping);
        }
        sheet.verify(|| checks::energies(self, &terms, sheet));
        if let Some(reference) = given.reference {
            reduced(&terms, reference, sheet);
        }
        let natural = sheet.step(
            "ωₙ",
            "rad/s",
            sdof::natural_frequency(stiffness, inertia),
            ("Natural frequency without damping", RAO.at("§2.3")),
        );
        sheet.answer("natural_frequency", "Natural frequency", natural);
        stability(given, &terms, sheet);
        damped(given, &terms, natural, sheet);
        if let Some(load) = &given.load {
            forced(load, &terms, given.reference, natural, sheet)?;
        }
        let numbers = [inertia.value(), stiffness.value(), damping.map_or(0.0, Real::value)];
        sheet.show(|| Exhibit::Drawing(sketch::drawing(self)));
        self.show(numbers, sheet);
        Ok(())
    }
}

/// Mass, stiffness and damping at a point.
fn reduced<W: Worksheet>(terms: &Terms<W::Num>, reference: W::Num, sheet: W) {
    let square = reference.powi(2);
    let mass = sheet.step(
        "m_eq",
        "kg",
        terms.inertia / square,
        ("Equivalent mass at the reference point: the same kinetic energy, x = p θ", KELLY.at("ch. 2")),
    );
    let stiffness = sheet.step(
        "k_eq",
        "N/m",
        terms.stiffness / square,
        ("Equivalent stiffness at the reference point: the same potential energy", KELLY.at("ch. 2")),
    );
    sheet.answer("equivalent_mass", "Equivalent mass at the point", mass);
    sheet.answer("equivalent_stiffness", "Equivalent stiffness at the point", stiffness);
    let damping = terms.damping.map(|damping| {
        let why = ("Equivalent damping at the reference point: the same power", KELLY.at("ch. 2"));
        let damping = sheet.step("c_eq", "N*s/m", damping / square, why);
        sheet.answer("equivalent_damping", "Equivalent damping at the point", damping);
        damping
    });
    sheet.verify(|| checks::at_point(terms, [Some(mass), Some(stiffness), damping], reference, sheet));
}

/// The least stiffness of each spring with which the position is still stable.
fn stability<W: Worksheet>(given: &EquivalentSystemGiven<W>, terms: &Terms<W::Num>, sheet: W) {
    if terms.weights.is_none_or(|weights| weights.value() >= 0.0) {
        return;
    }
    for ((n, own), spring) in (1..).zip(&terms.springs).zip(&given.springs) {
        let others = terms.stiffness - *own;
        if others.value() >= 0.0 {
            continue;
        }
        let (symbol, unit, stiffness, own) = match spring {
            AttachedSpringGiven::Linear { stiffness, .. } => (("k_min", n), "N/m", *stiffness, *own),
            AttachedSpringGiven::Torsional { stiffness } => (("k_t,min", n), "N*m/rad", *stiffness, *own),
        };
        let least = sheet.step(
            symbol,
            unit,
            -others * stiffness / own,
            (
                Text::new(
                    "Least stiffness of spring {n} for stability: the equivalent stiffness is then zero",
                )
                .with("n", n),
                RAO.at("§2.3"),
            ),
        );
        sheet.answer(("least_stiffness", n), "Least stiffness for stability", least);
        sheet.check_zero(
            Text::new("no equivalent stiffness is left with the least stiffness of spring {n}").with("n", n),
            others + own * least / stiffness,
            others.value(),
        );
    }
}

/// Damping ratio and damped motion.
fn damped<W: Worksheet>(given: &EquivalentSystemGiven<W>, terms: &Terms<W::Num>, natural: W::Num, sheet: W) {
    let Terms { inertia, stiffness, .. } = *terms;
    let critical = sheet.step(
        "C_c",
        "N*m*s/rad",
        sdof::critical_damping(stiffness, inertia),
        ("Critical torsional damping: 2√(K_eq J_eq)", RAO.at("§2.6")),
    );
    sheet.answer("critical_damping", "Critical torsional damping", critical);
    sheet.check(
        "critical damping leaves one root: C_c² = 4 K_eq J_eq",
        critical.powi(2),
        stiffness * inertia * 4.0,
    );
    let Some(damping) = terms.damping else { return };
    let zeta = sheet.step("ζ", "1", damping / critical, ("Damping ratio", RAO.at("§2.6")));
    sheet.answer("damping_ratio", "Damping ratio", zeta);
    sheet.check("twice the rate of decay, 2ζωₙ, is C_eq/J_eq", zeta * natural * 2.0, damping / inertia);
    for ((n, own), damper) in (1..).zip(&terms.dampers).zip(&given.dampers) {
        let left = critical - (damping - *own);
        if own.value() == 0.0 || left.value() <= 0.0 {
            continue;
        }
        let (symbol, unit, coefficient) = match damper {
            AttachedDamperGiven::Linear { coefficient, .. } => (("c_c", n), "N*s/m", *coefficient),
            AttachedDamperGiven::Torsional { coefficient } => (("c_t,c", n), "N*m*s/rad", *coefficient),
        };
        let wanted = sheet.step(
            symbol,
            unit,
            left * coefficient / *own,
            (
                Text::new("Coefficient of damper {n} for critical damping, the others unchanged")
                    .with("n", n),
                RAO.at("§2.6"),
            ),
        );
        sheet.answer(("critical_coefficient", n), "Coefficient for critical damping", wanted);
        sheet.check(
            Text::new("with that coefficient of damper {n} the damping is critical").with("n", n),
            damping - *own + *own * wanted / coefficient,
            critical,
        );
    }
    if zeta.value() < 1.0 {
        let why = ("Frequency of the damped motion", RAO.at("§2.6"));
        damped_frequency_error("ω_d", natural, zeta, sheet);
        let frequency = sheet.step("ω_d", "rad/s", sdof::damped_frequency(natural, zeta), why);
        sheet.answer("damped_frequency", "Damped natural frequency", frequency);
        let rate = damping / (inertia * 2.0);
        sheet.check(
            "product of the roots −ζωₙ ± iω_d of the characteristic equation: K_eq/J_eq",
            frequency.powi(2) + rate.powi(2),
            stiffness / inertia,
        );
    } else {
        sheet.warn(|| {
            Text::new("the damping is not below the critical one: the body returns without oscillating")
        });
    }
}

/// The steady motion under the load.
fn forced<W: Worksheet>(
    load: &HarmonicLoadGiven<W>,
    terms: &Terms<W::Num>,
    reference: Option<W::Num>,
    natural: W::Num,
    sheet: W,
) -> Result<(), Refusal> {
    let Terms { inertia, stiffness, damping, .. } = *terms;
    let frequency = load.frequency;
    let moment = match &load.amplitude {
        LoadAmplitudeGiven::Moment { moment } => *moment,
        LoadAmplitudeGiven::Force { force, arm } => {
            sheet.step("M₀", "N*m", *force * *arm, "Amplitude of the moment of the force")
        }
    };
    if damping.is_none() && (frequency.value() / natural.value() - 1.0).abs() < 1e-10 {
        return Err(Refusal::because(
            "the load has the natural frequency and nothing damps the motion: it grows without limit; write another frequency or a damper",
        ));
    }
    let held = sheet.step(
        "D",
        "N*m/rad",
        stiffness - inertia * frequency.powi(2),
        ("Dynamic stiffness, of springs and inertia: K_eq − J_eq ω²", RAO.at("§3.4")),
    );
    let lost = damping.map_or(held * 0.0, |damping| damping * frequency);
    sheet.common_error("Θ", "the static rotation under the load taken", || moment / stiffness);
    if damping.is_some() {
        sheet.common_error("Θ", "the damping neglected", || moment / held.abs());
    }
    let amplitude = sheet.step(
        "Θ",
        "deg",
        moment / (held.powi(2) + lost.powi(2)).sqrt(),
        ("Angular amplitude of the steady motion", RAO.at("§3.4")),
    );
    let phase = sheet.step("φ", "deg", lost.atan2(held), ("Phase by which the motion lags", RAO.at("§3.4")));
    sheet.answer("amplitude", "Angular amplitude", amplitude);
    sheet.answer("phase", "Phase lag", phase);
    sheet.verify(|| {
        let size = moment.value();
        sheet.check_sum(
            "moment in phase with the motion: springs less inertia",
            moment * phase.cos(),
            amplitude * (stiffness - inertia * frequency.powi(2)),
            size,
        );
        sheet.check_sum(
            "moment a quarter of a cycle ahead of the motion: that of the dampers",
            moment * phase.sin(),
            amplitude * lost,
            size,
        );
    });
    if let Some(reference) = reference {
        let moved = sheet.step("X", "mm", amplitude * reference, "Amplitude of the reference point");
        sheet.answer("point_amplitude", "Amplitude of the point", moved);
        sheet.verify(|| {
            let square = reference.powi(2);
            let (m, k) = (inertia / square, stiffness / square);
            let c = damping.map_or(m * frequency * 0.0, |damping| damping / square);
            sheet.check(
                "amplitude of the point from the equivalent mass, stiffness and damping there",
                sdof::forced_amplitude(moment / reference, k, m, c, frequency),
                moved,
            );
        });
    }
    Ok(())
}

impl EquivalentSystem {
    /// Natural frequency over the stiffness of the first spring; amplitude over the frequency of the load.
    fn show<W: Worksheet>(&self, [inertia, stiffness, damping]: [f64; 3], sheet: W) {
        if let Some(AttachedSpring::Linear { stiffness: own, arm, angle }) = self.springs.first() {
            let square = (arm * angle.unwrap_or(0.0).cos()).powi(2);
            let rest = stiffness - own * square;
            sheet.show(|| {
                let at = |n: u16| 2.0 * own * f64::from(n) / 200.0;
                let point = |k: f64| {
                    let all = rest + k * square;
                    (all > 0.0).then(|| (k, (all / inertia).sqrt()))
                };
                let points = (1..=200).map(at).filter_map(point).collect();
                let plot = Plot::new(
                    "Natural frequency against the stiffness of the first spring",
                    Axis::linear("stiffness", "N/m"),
                    Axis::linear("natural frequency", "rad/s"),
                    vec![Series::line("ωₙ", points).of("natural_frequency")],
                );
                let here = (*own, (stiffness / inertia).sqrt());
                Exhibit::Plot(plot.mark("here", here).over("springs[1].linear.stiffness"))
            });
        }
        if let Some(load) = &self.load {
            let moment = match load.amplitude {
                LoadAmplitude::Force { force, arm } => force * arm,
                LoadAmplitude::Moment { moment } => moment,
            };
            sheet.show(|| {
                let natural = (stiffness / inertia).sqrt();
                let last = 2.5 * natural.max(0.5 * load.frequency);
                let point = |n: u16| {
                    let w = last * f64::from(n) / 400.0;
                    let resisting = (stiffness - inertia * w * w).hypot(damping * w);
                    (w, moment / resisting)
                };
                // An undamped resonance would hide the rest.
                let top = 20.0 * moment / stiffness;
                let points = (1..=400).map(point).filter(|point| point.1 < top).collect();
                let plot = Plot::new(
                    "Angular amplitude against the frequency of the load",
                    Axis::linear("frequency", "rad/s"),
                    Axis::linear("amplitude", "deg"),
                    vec![Series::line("Θ", points).of("amplitude")],
                );
                Exhibit::Plot(plot.over("load.frequency"))
            });
        }
    }
}
