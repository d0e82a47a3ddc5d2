//! The moment of inertia of a body from the time that it takes to swing.

use std::f64::consts::TAU;

use dalembert_core::{About, Analysis, Exhibit, Inputs, Refusal, Symbol, Worksheet, register};
use dalembert_mechanics::{Real, vibration::swing};

use crate::{
    shared::{
        body_load::{MassOrWeight, MassOrWeightGiven},
        inertia::{self, Inertia},
    },
    sources::{ABRAMOWITZ, RAO, THOMSON},
};

mod compound;
mod hung;

use self::compound::{one_point, pendulum, period_over_distance, two_points};

/// Inputs of a swing test.
#[derive(Clone, Debug, Inputs)]
pub struct SwingTest {
    /// Test.
    pub test: Test,
    /// Gravity.
    #[input("g", "m/s^2", positive, default = "9.81 m/s^2")]
    pub gravity: f64,
}

/// Type of test: suspension of the body.
#[derive(Clone, Debug, Inputs)]
pub enum Test {
    /// About one point, centre of mass known
    /// A compound pendulum: a connecting rod on a knife edge.
    OnePoint {
        /// Body.
        body: MassOrWeight,
        /// From the point of suspension to the centre of mass.
        #[input("s", "m", positive)]
        distance: f64,
        /// Oscillations.
        swings: Swings,
        /// Amplitude of the oscillations.
        /// From the lowest position; omitted for small oscillations.
        #[input("θ₀", "deg", positive, below = 120)]
        amplitude: Option<f64>,
    },
    /// About two points, centre of mass unknown
    /// The two points and the centre of mass are collinear.
    TwoPoints {
        /// Body.
        body: MassOrWeight,
        /// Between the two points.
        #[input("L", "m", positive)]
        distance: f64,
        /// Position of the centre of mass.
        side: CentreSide,
        /// Oscillations about the first point.
        #[input("1")]
        first: Swings,
        /// Oscillations about the second point.
        #[input("2")]
        second: Swings,
        /// Amplitude of the oscillations.
        /// The same for both; omitted for small oscillations.
        #[input("θ₀", "deg", positive, below = 120)]
        amplitude: Option<f64>,
    },
    /// On two, three or more parallel wires
    /// Bifilar, trifilar: the body rotates about the vertical line through its centre of mass.
    Wires {
        /// Body.
        body: MassOrWeight,
        /// From the axis to the wires, at the body.
        #[input("r", "m", positive)]
        radius: f64,
        /// From the axis to the wires, at the top.
        /// Omit if the wires are vertical.
        #[input("R", "m", positive)]
        top: Option<f64>,
        /// Length of the wires.
        #[input("l", "m", positive)]
        length: f64,
        /// Oscillations.
        swings: Swings,
        /// Platform.
        /// Carries the body; omitted if the wires support the body itself.
        platform: Option<Platform>,
    },
    /// On a wire in torsion
    Torsion {
        /// Oscillations.
        swings: Swings,
        /// Wire.
        wire: Wire,
    },
    /// Oscillating by rolling in concave rails
    /// On its journals.
    Rails {
        /// Body.
        body: MassOrWeight,
        /// Radius of the journals.
        #[input("ρ", "m", positive)]
        journal: f64,
        /// Radius of the rails.
        #[input("R", "m", positive)]
        rails: f64,
        /// Oscillations.
        swings: Swings,
    },
    /// Rolling down inclined rails
    /// On its journals, from rest and without slipping.
    Incline {
        /// Body.
        body: MassOrWeight,
        /// Radius of the journals.
        #[input("ρ", "m", positive)]
        journal: f64,
        /// Slope of the rails.
        #[input("α", "deg", positive, below = 90)]
        slope: f64,
        /// Distance rolled.
        #[input("s", "m", positive)]
        distance: f64,
        /// Time taken.
        #[input("t", "s", positive)]
        time: f64,
    },
}

/// Measured periods.
#[derive(Clone, Debug, Inputs)]
pub enum Swings {
    /// Period given
    Period {
        /// Period.
        /// A complete oscillation.
        #[input("T", "s", positive)]
        period: f64,
    },
    /// Time of several oscillations
    Counted {
        /// Number of oscillations.
        /// Full oscillations (there and back).
        #[input(min = 1, max = 100000)]
        count: u32,
        /// Total time.
        #[input("t", "s", positive)]
        time: f64,
    },
}

/// Position of the centre of mass.
#[derive(Clone, Debug, Inputs)]
pub enum CentreSide {
    /// Between the two points
    Between,
    /// Beyond the second point
    /// Both points on one side of it, the second one nearer.
    Beyond,
}

/// Platform that carries the body.
#[derive(Clone, Debug, Inputs)]
pub struct Platform {
    /// Mass of the platform.
    #[input("m₀", "kg", positive)]
    pub mass: f64,
    /// Oscillations of the empty platform.
    #[input("0")]
    pub swings: Swings,
}

/// Torsional stiffness of the wire, or the test with an added inertia that determines it.
#[derive(Clone, Debug, Inputs)]
pub enum Wire {
    /// Stiffness given
    Stiffness {
        /// Torsional stiffness.
        #[input("k_t", "N*m/rad", positive)]
        stiffness: f64,
    },
    /// Known inertia added
    /// The body is oscillated again with it.
    Added {
        /// Added inertia.
        #[input("a")]
        inertia: Inertia,
        /// Oscillations with it.
        #[input("a")]
        swings: Swings,
    },
    /// Known body in its place
    Reference {
        /// Inertia of the known body.
        #[input("k")]
        inertia: Inertia,
        /// Oscillations of the known body alone.
        #[input("k")]
        swings: Swings,
    },
}

register!(SwingTest);

impl Analysis for SwingTest {
    const ABOUT: About = About {
        id: "vibration/swing-test",
        title: "Moment of inertia from an oscillation test",
        topic: "Stiffness and inertia",
        summary: "Moment of inertia from the period on a knife edge, about two points, on wires, on a torsion wire, or rolling on rails.",
        main: &["inertia", "centre"],
        keywords: "compound pendulum bifilar trifilar suspension torsion pendulum connecting rod radius of \
                   gyration momento de inércia ensaio de oscilação pêndulo composto bifilar trifilar pêndulo de \
                   torção biela physical pendulum pêndulo físico",
        sources: &[&RAO, &THOMSON, &ABRAMOWITZ],
        cases: include_str!("../../cases/swing_test.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &SwingTestGiven<W>, sheet: W) -> Result<(), Refusal> {
        let gravity = given.gravity;
        match (&given.test, &self.test) {
            (
                TestGiven::OnePoint { body, distance, swings, amplitude },
                Test::OnePoint { swings: own, .. },
            ) => {
                let mass = mass(body, gravity, sheet);
                let period = period(swings, own, "", sheet);
                let period = small(period, *amplitude, 1, sheet);
                let (inertia, gyration) = one_point(mass, *distance, period, gravity, sheet)?;
                let (s, g, gyration) = (distance.value(), gravity.value(), gyration.value());
                sheet.show(|| {
                    Exhibit::Plot(period_over_distance(gyration, g, &[("measured", s, period.value())]))
                });
                sheet.show(|| Exhibit::Drawing(pendulum(&[("O", 1.0)], self.mass_letter(), ("s", 1.0, 0.0))));
                answer(inertia, mass, sheet);
            }
            (
                TestGiven::TwoPoints { body, distance, first, second, amplitude, .. },
                Test::TwoPoints { first: own, second: other, side, .. },
            ) => {
                let mass = mass(body, gravity, sheet);
                let first = small(period(first, own, "1", sheet), *amplitude, 1, sheet);
                let second = small(period(second, other, "2", sheet), *amplitude, 2, sheet);
                let found = two_points(mass, *distance, [first, second], side, gravity, sheet)?;
                let marks = [
                    ("first point", found.distances[0].value(), first.value()),
                    ("second point", found.distances[1].value(), second.value()),
                ];
                let (gyration, g) = (found.gyration.value(), gravity.value());
                sheet.show(|| Exhibit::Plot(period_over_distance(gyration, g, &marks)));
                let share = found.distances[1].value() / found.distances[0].value();
                let second = if matches!(side, CentreSide::Between) { -share } else { share };
                sheet.show(|| {
                    Exhibit::Drawing(pendulum(
                        &[("1", 1.0), ("2", second)],
                        self.mass_letter(),
                        ("L", 1.0, second),
                    ))
                });
                answer(found.inertia, mass, sheet);
            }
            (
                TestGiven::Wires { body, radius, top, length, swings, platform },
                Test::Wires { swings: own, platform: under, .. },
            ) => {
                let mass = mass(body, gravity, sheet);
                let period = period(swings, own, "", sheet);
                let wires = hung::Wires { radius: *radius, top: *top, length: *length, gravity };
                let inertia = hung::on_wires(&wires, mass, period, platform.as_ref(), under.as_ref(), sheet)?;
                sheet.show(|| Exhibit::Drawing(hung::wires(self.leaning(), self.mass_letter())));
                answer(inertia, mass, sheet);
            }
            (TestGiven::Torsion { swings, wire }, Test::Torsion { swings: own, wire: kind }) => {
                let period = period(swings, own, "", sheet);
                let inertia = hung::on_torsion_wire(period, wire, kind, sheet)?;
                sheet.answer("inertia", "Moment of inertia about the axis of the wire", inertia);
                sheet.show(|| Exhibit::Drawing(hung::torsion()));
            }
            (TestGiven::Rails { body, journal, rails, swings }, Test::Rails { swings: own, .. }) => {
                let mass = mass(body, gravity, sheet);
                if journal.value() >= rails.value() {
                    return Err(Refusal::because(
                        "the journals are not smaller than the curvature radius of the rails: write a larger rail radius",
                    ));
                }
                let period = period(swings, own, "", sheet);
                let reduced = || swing::reduced_length(gravity, period);
                let contact = || journal.powi(2) * reduced() / (*rails - *journal);
                sheet.common_error("κ²", "the radius of gyration about the point of contact taken", contact);
                let turned = || {
                    let path = *rails - *journal;
                    (*journal / *rails).powi(2) * path * (reduced() - path)
                };
                let what =
                    "the rotation of the body taken relative to the line of centres, not to the ground";
                sheet.common_error("κ²", what, turned);
                let full = || journal.powi(2) * (reduced() / *rails - 1.0);
                let what = "the radius of the surface taken as that of the path of the centre";
                sheet.common_error("κ²", what, full);
                let square = sheet.step(
                    "κ²",
                    "cm^2",
                    swing::on_hollow_rails(gravity, *journal, *rails, period),
                    ("The journal rolls without slipping: T² = 4π² (R − ρ)(1 + κ²/ρ²)/g", RAO.at("§2.3")),
                );
                let inertia = rolled(mass, square, sheet)?;
                sheet.verify(|| {
                    // Centre at the angle β: its speed is (R − ρ) β′ and the body turns by (R − ρ) β/ρ.
                    let path = *rails - *journal;
                    let moving = mass * path.powi(2) + inertia * (path / *journal).powi(2);
                    let raised = mass * gravity * path;
                    sheet.check(
                        "period from the kinetic and the potential energy",
                        (moving / raised).sqrt() * TAU,
                        period,
                    );
                });
                sheet.show(|| Exhibit::Drawing(hung::rails(self.mass_letter())));
                answer(inertia, mass, sheet);
            }
            (TestGiven::Incline { body, journal, slope, distance, time }, _) => {
                let mass = mass(body, gravity, sheet);
                let mean_speed = || *distance / time.powi(2);
                sheet.common_error("a", "the mean velocity divided by the time", mean_speed);
                let acceleration = sheet.step(
                    "a",
                    "m/s^2",
                    *distance * 2.0 / time.powi(2),
                    "Acceleration of the centre, from rest: s = a t²/2",
                );
                let contact = || journal.powi(2) * gravity * slope.sin() / acceleration;
                sheet.common_error("κ²", "the radius of gyration about the point of contact taken", contact);
                let square = sheet.step(
                    "κ²",
                    "cm^2",
                    journal.powi(2) * (gravity * slope.sin() / acceleration - 1.0),
                    "Rolling without slipping: a = g sin α/(1 + κ²/ρ²)",
                );
                let inertia = rolled(mass, square, sheet)?;
                sheet.verify(|| {
                    let fast = acceleration * *time;
                    let kinetic = mass * fast.powi(2) / 2.0 + inertia * (fast / *journal).powi(2) / 2.0;
                    sheet.check(
                        "kinetic energy at the end is the work of the weight",
                        kinetic,
                        mass * gravity * *distance * slope.sin(),
                    );
                });
                sheet.show(|| Exhibit::Drawing(hung::incline(self.mass_letter())));
                answer(inertia, mass, sheet);
            }
            _ => {}
        }
        Ok(())
    }
}

/// Answers the moment of inertia, and the radius of gyration with it.
fn answer<W: Worksheet>(inertia: W::Num, mass: W::Num, sheet: W) {
    sheet.answer("inertia", "Moment of inertia about the centre of mass", inertia);
    let gyration = sheet.step("κ", "mm", (inertia / mass).sqrt(), "Radius of gyration");
    sheet.answer("radius_of_gyration", "Radius of gyration", gyration);
}

/// The mass of the body.
fn mass<W: Worksheet>(given: &MassOrWeightGiven<W>, gravity: W::Num, sheet: W) -> W::Num {
    given.mass(gravity, sheet, "m", "Mass of the weight")
}

/// The period, as it was measured.
fn period<W: Worksheet>(given: &SwingsGiven<W>, own: &Swings, of: &'static str, sheet: W) -> W::Num {
    match (given, own) {
        (SwingsGiven::Counted { time }, Swings::Counted { count, .. }) => sheet.step(
            Symbol { of, ..Symbol::from("T") },
            "s",
            *time / f64::from(*count),
            "Period: the time over the number of oscillations",
        ),
        (SwingsGiven::Period { period }, _) => *period,
        (SwingsGiven::Counted { time }, Swings::Period { .. }) => *time,
    }
}

/// The period of small swings, from that of swings of an amplitude.
fn small<W: Worksheet>(period: W::Num, amplitude: Option<W::Num>, row: usize, sheet: W) -> W::Num {
    let Some(amplitude) = amplitude else { return period };
    // The mean does not depend on which period it corrects: it is written once.
    let mean = if row == 1 { mean(amplitude, sheet) } else { mean_alone(amplitude, sheet) };
    let small = sheet.step(
        ("T_s", row),
        "s",
        period * mean,
        (
            "Period of small oscillations: large ones take 1/agm(1, cos θ₀/2) times as long",
            ABRAMOWITZ.at("§17.6"),
        ),
    );
    sheet.verify(|| {
        // The quarter of a swing by equal weights, which converge geometrically.
        const POINTS: u32 = 400;
        let modulus = (amplitude.value() / 2.0).sin();
        let at = |n: u32| {
            (1.0 - (modulus * (TAU * f64::from(n) / f64::from(POINTS)).sin()).powi(2)).sqrt().recip()
        };
        let longer = (0..POINTS).map(at).sum::<f64>() / f64::from(POINTS);
        sheet.check("period of the large-amplitude oscillation by quadrature", small * longer, period);
    });
    small
}

/// The arithmetic–geometric mean of 1 and cos(θ₀/2), written out.
fn mean<W: Worksheet>(amplitude: W::Num, sheet: W) -> W::Num {
    let mut arithmetic = W::Num::from(1.0);
    let why = "Arithmetic–geometric mean of 1 and cos(θ₀/2)";
    let mut geometric = sheet.step(("b", 1), "1", (amplitude / 2.0).cos(), why);
    for n in 2..=7 {
        if (arithmetic.value() - geometric.value()).abs() <= 1e-15 {
            break;
        }
        let next = sheet.step(("a", n), "1", (arithmetic + geometric) / 2.0, "Arithmetic mean");
        geometric = sheet.step(("b", n), "1", (arithmetic * geometric).sqrt(), "Geometric mean");
        arithmetic = next;
    }
    arithmetic
}

/// The same mean as one number.
fn mean_alone<W: Worksheet>(amplitude: W::Num, sheet: W) -> W::Num {
    let (mut arithmetic, mut geometric) = (1.0, (amplitude.value() / 2.0).cos());
    for _ in 0..6 {
        (arithmetic, geometric) = (f64::midpoint(arithmetic, geometric), (arithmetic * geometric).sqrt());
    }
    sheet.numerical("a", "1", arithmetic, "The same mean as for the first point")
}

/// The moment of inertia of a body that rolls, about its axis.
fn rolled<W: Worksheet>(mass: W::Num, square: W::Num, sheet: W) -> Result<W::Num, Refusal> {
    if square.value() <= 0.0 {
        return Err(Refusal::because(
            "the body would roll faster than a body without inertia: the time is too short for these rails",
        ));
    }
    Ok(sheet.step("J", "kg*m^2", mass * square, "Moment of inertia about the axis of rolling"))
}

impl SwingTest {
    /// The letter of the mass, or of the weight.
    fn mass_letter(&self) -> &'static str {
        match &self.test {
            Test::OnePoint { body, .. }
            | Test::TwoPoints { body, .. }
            | Test::Wires { body, .. }
            | Test::Rails { body, .. }
            | Test::Incline { body, .. } => match body {
                MassOrWeight::Mass { .. } => "m",
                MassOrWeight::Weight { .. } => "W",
            },
            Test::Torsion { .. } => "",
        }
    }

    /// Inward inclination of the wires at the top, relative to the radius at the body.
    fn leaning(&self) -> f64 {
        match &self.test {
            Test::Wires { radius, top: Some(top), .. } => (top / radius).clamp(0.2, 2.0),
            _ => 1.0,
        }
    }
}
