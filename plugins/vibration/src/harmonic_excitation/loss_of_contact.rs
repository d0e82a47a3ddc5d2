//! Loss of contact of a body, a cam follower or a sprung wheel with what moves it up and down harmonically.

use std::f64::consts::TAU;

use dalembert_core::{
    About, Analysis, Axis, Drawing, Exhibit, Ink, Inputs, Plot, Refusal, Series, Sketch, Text, Worksheet,
    register,
};
use dalembert_mechanics::{Real, sdof};
use dalembert_numerics::roots;

use crate::sources::{NORTON, RAO};

/// Body on a moving surface, and the motion of that surface.
#[derive(Clone, Debug, Inputs)]
pub struct LossOfContact {
    /// Body in contact.
    pub body: ContactBody,
    /// Amplitude of the surface.
    /// Of the table, the follower or the road: zero to peak, unless the unit says otherwise.
    #[input("A", "m", positive, kind = "Amplitude")]
    pub amplitude: f64,
    /// Frequency at which the contact force is required.
    #[input("ω", "Hz", positive)]
    pub frequency: Option<f64>,
    /// Wavelength of the road.
    /// If given, speeds along it are also answered.
    #[input("λ", "m", positive)]
    pub wavelength: Option<f64>,
    /// Gravity.
    /// Zero for a follower that moves horizontally.
    #[input("g", "m/s^2", nonnegative, default = "9.81 m/s^2")]
    pub gravity: f64,
}

/// Body that the moving surface carries.
#[derive(Clone, Debug, Inputs)]
pub enum ContactBody {
    /// Body or follower
    Rigid {
        /// Mass.
        #[input("m", "kg", positive)]
        mass: f64,
        /// Spring that presses it on the surface.
        spring: Option<PreloadSpring>,
    },
    /// Sprung wheel
    Wheel {
        /// Mass of the wheel.
        #[input("m", "kg", positive)]
        mass: f64,
        /// Mass on the spring.
        #[input("M", "kg", positive)]
        sprung: f64,
        /// Stiffness.
        #[input("k", "N/m", positive)]
        stiffness: f64,
        /// Damping coefficient.
        #[input("c", "N*s/m", nonnegative)]
        damping: f64,
    },
}

/// A spring between the body and the frame.
#[derive(Clone, Debug, Inputs)]
pub struct PreloadSpring {
    /// Stiffness.
    #[input("k", "N/m", nonnegative)]
    pub stiffness: f64,
    /// Preload.
    /// Force of the spring at the lowest position of the body.
    #[input("F_p", "N", nonnegative)]
    pub preload: f64,
}

register!(LossOfContact);

impl Analysis for LossOfContact {
    const ABOUT: About = About {
        id: "vibration/loss-of-contact",
        title: "Loss of contact",
        topic: "Harmonic excitation",
        summary: "Frequency, speed and amplitude at which a body on a vibrating table, a cam follower with a spring, or a sprung wheel on a wavy road loses contact; contact force over a cycle.",
        main: &["lost_frequency", "lost_speed", "lost_amplitude", "least_force"],
        keywords: "loss of contact lift-off jump follower jump cam speed vibrating table piston block wavy road wheel hop \
                   contact force preload perda de contato salto do seguidor came mesa vibratória estrada ondulada roda",
        sources: &[&NORTON, &RAO],
        cases: include_str!("../../cases/loss_of_contact.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &LossOfContactGiven<W>, sheet: W) -> Result<(), Refusal> {
        let contact = match &given.body {
            ContactBodyGiven::Rigid { mass, spring } => rigid(*mass, spring.as_ref(), given, sheet)?,
            ContactBodyGiven::Wheel { mass, sprung, stiffness, damping } => {
                wheel([*mass, *sprung, *stiffness, *damping], given, sheet)?
            }
        };
        let lost = contact.lost;
        sheet.answer("lost_frequency", "Frequency at which contact is lost", lost);
        if let Some(wavelength) = given.wavelength {
            let speed = sheet.step(
                "v_c",
                "km/h",
                lost * wavelength / TAU,
                "Speed along the road: one wavelength in each cycle",
            );
            sheet.answer("lost_speed", "Speed at which contact is lost", speed);
            sheet.check(
                "time of a wavelength at that speed: a period",
                wavelength / speed * lost,
                TAU.into(),
            );
        }
        if let Some(frequency) = given.frequency {
            self.at(frequency, given, &contact, sheet);
        }
        sheet.show(|| Exhibit::Plot(self.plot(&contact)));
        sheet.show(|| Exhibit::Drawing(self.drawing()));
        Ok(())
    }
}

/// The contact force: its mean, and the frequency at which its least value is zero.
struct Contact<N> {
    mean: N,
    /// Contact force at the lowest position, at rest.
    still: N,
    lost: N,
}

fn rigid<W: Worksheet>(
    mass: W::Num,
    spring: Option<&PreloadSpringGiven<W>>,
    given: &LossOfContactGiven<W>,
    sheet: W,
) -> Result<Contact<W::Num>, Refusal> {
    let weight = mass * given.gravity;
    let still = spring.map_or(weight, |spring| weight + spring.preload);
    if still.value() <= 0.0 {
        return Err(Refusal::because(
            "nothing presses the body on the surface: write a preload of the spring, or the gravity",
        ));
    }
    let still = sheet.step(
        "N_s",
        "N",
        still,
        "Contact force at the lowest position, at rest: weight, and preload of the spring",
    );
    let mean = match spring {
        None => still,
        Some(spring) => {
            let force = still + spring.stiffness * given.amplitude;
            sheet.step(
                "N₀",
                "N",
                force,
                "Contact force in the middle of the stroke: the spring is compressed by A",
            )
        }
    };
    let own = mean / (mass * given.amplitude);
    let square = spring.map_or(own, |spring| own + spring.stiffness / mass);
    let why = (
        "At the top the surface accelerates downwards with A ω²; the contact force N₀ + k A − m A ω² is zero there",
        NORTON.at("ch. 15"),
    );
    if let Some(spring) = spring {
        sheet.common_error("ω_c", "the spring omitted: the weight alone taken", || {
            (given.gravity / given.amplitude).sqrt()
        });
        sheet.common_error("ω_c", "the compression of the spring by the motion omitted", || {
            (still / (mass * given.amplitude)).sqrt()
        });
        sheet.common_error("ω_c", "the natural frequency of mass and spring taken", || {
            sdof::natural_frequency(spring.stiffness, mass)
        });
    }
    let lost = sheet.step("ω_c", "Hz", square.sqrt(), why);
    sheet.verify(|| {
        let held = spring.map_or(mean, |spring| mean + spring.stiffness * given.amplitude);
        let inertia = mass * lost.powi(2) * given.amplitude;
        sheet.check(
            "inertia force at the top at that frequency: all that presses the body down",
            inertia,
            held,
        );
    });
    Ok(Contact { mean, still, lost })
}

/// Amplitude of the contact force of a wheel over that of the road: real and imaginary part.
fn wheel_force([mass, sprung, stiffness, damping]: [f64; 4], frequency: f64) -> f64 {
    let square = frequency * frequency;
    let (held, lost) = (stiffness - sprung * square, damping * frequency);
    // The sprung mass over the road: (k + icω)/(k − Mω² + icω).
    let size = held * held + lost * lost;
    let (real, imaginary) =
        ((stiffness * held + lost * lost) / size, (lost * held - stiffness * lost) / size);
    square * (mass + sprung * real).hypot(sprung * imaginary)
}

fn wheel<W: Worksheet>(
    parts: [W::Num; 4],
    given: &LossOfContactGiven<W>,
    sheet: W,
) -> Result<Contact<W::Num>, Refusal> {
    let [mass, sprung, stiffness, damping] = parts;
    let numbers = parts.map(Real::value);
    if given.gravity.value() == 0.0 {
        return Err(Refusal::because("a wheel without weight does not press on the road: write the gravity"));
    }
    let mean = sheet.step(
        "N₀",
        "N",
        (mass + sprung) * given.gravity,
        "Mean contact force: the weight of both masses",
    );
    let natural = sheet.step(
        "ωₙ",
        "rad/s",
        sdof::natural_frequency(stiffness, sprung),
        ("Natural frequency of the mass on the spring", RAO.at("§3.6")),
    );
    sheet.answer("natural_frequency", "Natural frequency", natural);
    sheet.check(
        "the maximum kinetic energy equals the maximum elastic energy",
        sprung * natural.powi(2),
        stiffness,
    );
    let excess = |w: f64| wheel_force(numbers, w) * given.amplitude.value() - mean.value();
    let Some(found) = first_crossing(excess, natural.value()) else {
        return Err(Refusal::because(
            "the wheel keeps contact at all frequencies that can be examined: check masses, stiffness and amplitude",
        ));
    };
    sheet.common_error("ω_c", "both masses assumed to follow the road", || {
        (given.gravity / given.amplitude).sqrt()
    });
    sheet.common_error("ω_c", "the sprung mass assumed at rest and the damping omitted", || {
        ((stiffness + mean / given.amplitude) / mass).sqrt()
    });
    let lost = sheet.numerical(
        "ω_c",
        "Hz",
        found,
        (
            "Lowest frequency at which the amplitude of the contact force, ω² A|m + M(k + icω)/(k − Mω² + icω)|, is N₀",
            RAO.at("§3.6"),
        ),
    );
    sheet.verify(|| {
        // By the force of spring and damper on the wheel: relative motion Z = A M ω²/(k − Mω² + icω).
        let square = lost.powi(2);
        let (held, loss) = (stiffness - sprung * square, damping * lost);
        let size = (held.powi(2) + loss.powi(2)).sqrt();
        let relative = given.amplitude * sprung * square / size;
        let lag = loss.atan2(held);
        let pushed = (stiffness.powi(2) + loss.powi(2)).sqrt() * relative;
        let turned = loss.atan2(stiffness) - lag;
        let inertia = mass * square * given.amplitude;
        let real = inertia + pushed * turned.cos();
        let amplitude = (real.powi(2) + (pushed * turned.sin()).powi(2)).sqrt();
        sheet.check(
            "amplitude of the contact force from spring, damper and inertia of the wheel",
            amplitude,
            mean,
        );
    });
    Ok(Contact { mean, still: mean, lost })
}

/// The lowest frequency at which a function that is negative at rest passes through zero.
fn first_crossing(excess: impl Fn(f64) -> f64, natural: f64) -> Option<f64> {
    let (mut low, mut value) = (0.0, excess(0.0));
    let mut high = natural / 200.0;
    for _ in 0..4000 {
        let next = excess(high);
        if next >= 0.0 {
            return roots::crossing(&[(low, value), (high, next)], &excess);
        }
        (low, value) = (high, next);
        // Fine about the resonance, which may be sharp; coarser far above it.
        high *= if high < 4.0 * natural { 1.004 } else { 1.05 };
        if !high.is_finite() {
            return None;
        }
    }
    None
}

impl LossOfContact {
    /// Contact force at the frequency that is asked for, and the amplitude at which contact is lost there.
    fn at<W: Worksheet>(
        &self,
        frequency: W::Num,
        given: &LossOfContactGiven<W>,
        contact: &Contact<W::Num>,
        sheet: W,
    ) {
        let square = frequency.powi(2);
        let mean = contact.mean;
        let unit = match &given.body {
            ContactBodyGiven::Rigid { mass, spring } => {
                let inertia = *mass * square;
                let unit = spring.as_ref().map_or(inertia, |spring| inertia - spring.stiffness);
                let why = "Amplitude of the contact force for each metre of the surface: inertia less stiffness, m ω² − k";
                sheet.step("D", "N/m", unit, why)
            }
            ContactBodyGiven::Wheel { mass, sprung, stiffness, damping } => {
                let (held, loss) = (*stiffness - *sprung * square, *damping * frequency);
                let size = held.powi(2) + loss.powi(2);
                let real = *mass + *sprung * (*stiffness * held + loss.powi(2)) / size;
                let imaginary = *sprung * (loss * held - *stiffness * loss) / size;
                let unit = square * (real.powi(2) + imaginary.powi(2)).sqrt();
                let why = "Amplitude of the contact force for each metre of the road: ω²|m + M(k + icω)/(k − Mω² + icω)|";
                sheet.common_error("D", "both masses assumed to follow the road", || {
                    (*mass + *sprung) * square
                });
                sheet.common_error("D", "the sprung mass assumed at rest", || {
                    sdof::dynamic_stiffness(*stiffness, *mass, *damping, frequency)
                });
                sheet.step("D", "N/m", unit, why)
            }
        };
        let dynamic = sheet.step("N_d", "N", unit * given.amplitude, "Amplitude of the contact force");
        let size = match dynamic.value() {
            value if value < 0.0 => -dynamic,
            _ => dynamic,
        };
        if let ContactBodyGiven::Rigid { spring: Some(_), .. } = &given.body {
            sheet.common_error("N_min", "the contact force at the lowest position taken as the mean", || {
                contact.still - size
            });
        }
        let least = sheet.step("N_min", "N", mean - size, "Least contact force; below zero, contact is lost");
        let largest = sheet.step("N_max", "N", mean + size, "Largest contact force while contact lasts");
        sheet.answer("least_force", "Least contact force", least);
        sheet.answer("largest_force", "Largest contact force", largest);
        let numbers = self.amplitude_of_force(frequency.value());
        sheet.verify(|| {
            let scale = mean.value() + size.value();
            let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
            for n in 0..4 {
                let phase = TAU * f64::from(n) / 4.0;
                let force = mean.value() + numbers * phase.sin();
                (low, high) = (low.min(force), high.max(force));
            }
            sheet.check_sum("least contact force of a cycle", least, low.into(), scale);
            sheet.check_sum("largest contact force of a cycle", largest, high.into(), scale);
        });
        // A larger stroke compresses the spring by more at the top, twice the amplitude.
        let loss = match &given.body {
            ContactBodyGiven::Rigid { spring: Some(spring), .. } => unit - spring.stiffness,
            _ => unit,
        };
        if loss.value() > 0.0 {
            if let ContactBodyGiven::Rigid { spring: Some(_), .. } = &given.body {
                sheet.common_error("A_c", "the spring omitted: the weight alone taken", || {
                    given.gravity / square
                });
                sheet.common_error("A_c", "the mean contact force of the given amplitude used", || {
                    mean / unit
                });
            }
            let most = sheet.step(
                "A_c",
                "mm",
                contact.still / loss,
                ("Amplitude at which contact is lost at this frequency", NORTON.at("ch. 15")),
            );
            sheet.answer("lost_amplitude", "Amplitude at which contact is lost", most);
            sheet.verify(|| {
                let held = match &given.body {
                    ContactBodyGiven::Rigid { spring: Some(spring), .. } => spring.stiffness * most,
                    _ => contact.still * 0.0,
                };
                let what = "least contact force with that amplitude";
                sheet.check_sum(what, contact.still + held, unit * most, (unit * most).value());
            });
        }
        if least.value() < 0.0 {
            sheet.warn(|| Text::new("at this frequency contact is lost in each cycle: the forces are those of a surface that would hold the body"));
        }
    }

    /// Amplitude of the contact force at a frequency, whatever its sign.
    fn amplitude_of_force(&self, frequency: f64) -> f64 {
        let square = frequency * frequency;
        let unit = match &self.body {
            ContactBody::Rigid { mass, spring } => {
                (mass * square - spring.as_ref().map_or(0.0, |spring| spring.stiffness)).abs()
            }
            ContactBody::Wheel { mass, sprung, stiffness, damping } => {
                wheel_force([*mass, *sprung, *stiffness, *damping], frequency)
            }
        };
        unit * self.amplitude
    }

    /// The least contact force over the frequency.
    fn plot<N: Real>(&self, contact: &Contact<N>) -> Plot {
        let lost = contact.lost.value();
        let last = 1.4 * lost.max(self.frequency.unwrap_or(0.0));
        let mean = contact.mean.value();
        let at = |n: u16| {
            let w = last * f64::from(n.max(1)) / 300.0;
            (w, mean - self.amplitude_of_force(w))
        };
        Plot::new(
            "Least contact force against frequency",
            Axis::linear("frequency", "Hz"),
            Axis::linear("least contact force", "N"),
            vec![Series::line("N_min", (1..=300).map(at).collect()).of("least_force")],
        )
        .mark("contact is lost", (lost, 0.0))
        .over("frequency")
    }

    fn drawing(&self) -> Drawing {
        let mut sketch = Sketch::new("The body on the moving surface");
        match &self.body {
            ContactBody::Rigid { spring, .. } => {
                sketch.mass("m", (-0.6, 0.0), (0.6, 0.9)).mass("", (-1.4, -0.15), (1.4, 0.0)).motion(
                    "A sin(ω t)",
                    (1.8, -0.5),
                    (1.8, 0.5),
                );
                if spring.is_some() {
                    sketch.ground((0.5, 2.3), (-0.5, 2.3)).spring("k, F_p", (0.0, 2.3), (0.0, 0.9));
                }
            }
            ContactBody::Wheel { .. } => {
                let wave = |n: u8| {
                    let x = -2.4 + 4.8 * f64::from(n) / 48.0;
                    (x, 0.15 * (TAU * x / 2.4).cos() - 0.15)
                };
                sketch
                    .curve((0..=48).map(wave).collect::<Vec<_>>(), Ink::Body)
                    .disc("m", (0.0, 0.45), 0.45)
                    .spring_and_damper(("k", "c"), (0.0, 0.45), (0.0, 1.8), 0.35)
                    .mass("M", (-0.8, 1.8), (0.8, 2.5))
                    .motion("v", (1.1, 2.1), (1.9, 2.1));
            }
        }
        sketch.finish()
    }
}
