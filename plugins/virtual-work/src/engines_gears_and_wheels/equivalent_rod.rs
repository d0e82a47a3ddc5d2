//! Two masses in place of a connecting rod, and the couple that corrects masses in its pins.

use std::f64::consts::TAU;

use dalembert_core::{
    About, Analysis, Drawing, Exhibit, Ink, Inputs, Refusal, Sketch, Text, Worksheet, register,
};
use dalembert_mechanics::{Real, slider_crank::equivalent};

use crate::sources::{BEVAN, KHURMI};

/// A rod with a pin at each end.
#[derive(Clone, Debug, Inputs)]
pub struct EquivalentRod {
    /// Mass of the rod.
    #[input("m", "kg", positive)]
    pub mass: f64,
    /// Length of the rod.
    /// Between its pins.
    #[input("l", "mm", positive)]
    pub length: f64,
    /// Given.
    pub known: RodData,
    /// Angular acceleration of the rod.
    /// For the couple that corrects masses at its pins.
    #[input("α", "rad/s^2")]
    pub acceleration: Option<f64>,
}

/// Centre of mass and moment of inertia, or oscillations that tell them.
#[derive(Clone, Debug, Inputs)]
pub enum RodData {
    /// Centre of mass and radius of gyration
    Gyration {
        /// Distance of the centre of mass from the gudgeon pin.
        #[input("a", "mm", positive)]
        distance: f64,
        /// Radius of gyration about the centre of mass.
        #[input("k", "mm", nonnegative)]
        radius: f64,
    },
    /// Centre of mass and moment of inertia
    Moment {
        /// Distance of the centre of mass from the gudgeon pin.
        #[input("a", "mm", positive)]
        distance: f64,
        /// Moment of inertia about the centre of mass.
        #[input("I_G", "kg*m^2", nonnegative)]
        inertia: f64,
    },
    /// Centre of mass and oscillation about the gudgeon pin
    Swung {
        /// Distance of the centre of mass from the gudgeon pin.
        #[input("a", "mm", positive)]
        distance: f64,
        /// Period of small oscillations about the gudgeon pin.
        #[input("τ_g", "s", positive)]
        period: f64,
        /// Acceleration of gravity.
        #[input("g", "m/s^2", positive, default = "9.81 m/s^2")]
        gravity: f64,
    },
    /// Oscillations about both pins
    SwungTwice {
        /// Period of small oscillations about the gudgeon pin.
        #[input("τ_g", "s", positive)]
        gudgeon: f64,
        /// Period of small oscillations about the crank pin.
        #[input("τ_c", "s", positive)]
        crank_pin: f64,
        /// Acceleration of gravity.
        #[input("g", "m/s^2", positive, default = "9.81 m/s^2")]
        gravity: f64,
    },
}

register!(EquivalentRod);

impl Analysis for EquivalentRod {
    const ABOUT: About = About {
        id: "virtual-work/equivalent-rod",
        title: "Equivalent masses of a connecting rod",
        topic: "Engines, gears and wheels",
        summary: "Two masses dynamically equivalent to a connecting rod, the masses at its two pins, and the correction couple.",
        main: &["first_mass", "second_mass", "second_distance"],
        keywords: "biela massas equivalentes sistema dinamicamente equivalente conjugado de correção raio de giração pêndulo \
                   dynamically equivalent two-mass system correction couple connecting rod radius of gyration swing period",
        sources: &[&BEVAN, &KHURMI],
        cases: include_str!("../../cases/equivalent_rod.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &EquivalentRodGiven<W>, sheet: W) -> Result<(), Refusal> {
        let (mass, length) = (given.mass, given.length);
        let (near, radius) = self.inertia(given, sheet)?;
        let far = sheet.step("b", "mm", length - near, "Distance of the centre of mass from the crank pin");
        if far.value() <= 0.0 {
            return Err(Refusal::because(
                Text::new("the centre of mass lies beyond the crank pin: its distance must be below the length of the rod, {length}")
                    .with_quantity("length", self.length, "mm"),
            ));
        }
        let pendulum = sheet.step(
            "L",
            "mm",
            equivalent::pendulum_length(radius, near),
            "Length of the simple pendulum equivalent to the rod about the gudgeon pin",
        );
        let cite = KHURMI.at("ch. 15");
        sheet.common_error("b′", "the length of the pendulum, from the gudgeon pin, taken", || pendulum);
        let conjugate = sheet.step(
            "b′",
            "mm",
            equivalent::conjugate_distance(radius, near),
            (
                "With one mass at the gudgeon pin, the other is beyond the centre of mass where a b′ = k²",
                cite,
            ),
        );
        let words = "the length of the rod used in place of the distance between the masses";
        sheet.common_error("m₁", words, || mass * conjugate / length);
        let first = sheet.step(
            "m₁",
            "kg",
            equivalent::share(mass, near, conjugate),
            ("Mass at the gudgeon pin: total mass and centre of mass are preserved", cite),
        );
        sheet.common_error("m₂", words, || mass * near / length);
        let second =
            sheet.step("m₂", "kg", equivalent::share(mass, conjugate, near), ("The other mass", cite));
        let gudgeon = sheet.step(
            "m_g",
            "kg",
            equivalent::share(mass, near, far),
            ("Mass at the gudgeon pin when the other is at the crank pin", cite),
        );
        let crank_pin =
            sheet.step("m_c", "kg", equivalent::share(mass, far, near), ("Mass at the crank pin", cite));
        let pins = || mass * near * far;
        sheet.common_error("ΔI", "the rod taken as a uniform bar, m l²/12", || {
            mass * length.powi(2) / 12.0 - pins()
        });
        sheet.common_error("ΔI", "the moment of inertia of the rod about its gudgeon pin used", || {
            mass * (radius.powi(2) + near.powi(2)) - pins()
        });
        let missing = sheet.step(
            "ΔI",
            "kg*m^2",
            equivalent::missing_inertia(mass, radius, near, far),
            (
                "Moment-of-inertia deficit of masses at the two pins; negative for an excess",
                BEVAN.at("ch. 12"),
            ),
        );
        sheet.answer("second_distance", "Distance of the second mass from the centre of mass", conjugate);
        sheet.answer("first_mass", "Mass at the gudgeon pin of the equivalent rod", first);
        sheet.answer("second_mass", "Second mass of the equivalent rod", second);
        sheet.answer("gudgeon_mass", "Mass at the gudgeon pin, with the other at the crank pin", gudgeon);
        sheet.answer("crank_pin_mass", "Mass at the crank pin", crank_pin);
        sheet.answer("missing_inertia", "Moment-of-inertia deficit of masses at the pins", missing);
        sheet.answer("pendulum_length", "Length of the equivalent pendulum about the gudgeon pin", pendulum);
        if let Some(acceleration) = given.acceleration {
            let couple = sheet.step(
                "C",
                "N*m",
                -(missing * acceleration),
                ("Couple to be added to the inertia of masses at the pins", BEVAN.at("ch. 12")),
            );
            sheet.answer("correction_couple", "Correction couple", couple);
            sheet.verify(|| {
                let again = mass * near * (length - pendulum) * acceleration;
                let scale = mass.value() * near.value() * (length.value() + pendulum.value());
                let what = "the correction couple as m a (l − L) α";
                sheet.check_zero(what, couple - again, scale * acceleration.value());
            });
        }
        sheet.verify(|| {
            check_swings(given, near, radius, sheet);
            let own = match given.known {
                RodDataGiven::Moment { inertia, .. } => inertia,
                _ => mass * radius.powi(2),
            };
            sheet.check("the two masses add up to the mass of the rod", first + second, mass);
            let what = "the two masses have the same centre of mass as the rod";
            sheet.check_zero(what, first * near - second * conjugate, (mass * near).value());
            let both = first * near.powi(2) + second * conjugate.powi(2);
            sheet.check("the two masses have the same moment of inertia as the rod", both, own);
            let pins = gudgeon * near.powi(2) + crank_pin * far.powi(2);
            let what = "moment of inertia of the rod as that of the masses at the pins plus the difference";
            sheet.check_zero(what, pins + missing - own, own.value() + pins.value());
        });
        let places = [near.value(), far.value(), conjugate.value()];
        sheet.show(|| Exhibit::Drawing(drawing(self, places)));
        Ok(())
    }
}

impl EquivalentRod {
    /// Distance of the centre of mass from the gudgeon pin, and radius of gyration.
    fn inertia<W: Worksheet>(
        &self,
        given: &EquivalentRodGiven<W>,
        sheet: W,
    ) -> Result<(W::Num, W::Num), Refusal> {
        let pendulum = |symbol, period: W::Num, gravity: W::Num| {
            let why = "Length of the simple pendulum of this period";
            sheet.step(symbol, "mm", gravity * (period / TAU).powi(2), why)
        };
        let named = |radius: W::Num| {
            let radius = sheet.step("k", "mm", radius, "Radius of gyration about the centre of mass");
            sheet.answer("radius_of_gyration", "Radius of gyration about the centre of mass", radius);
            radius
        };
        match given.known {
            RodDataGiven::Gyration { distance, radius } => Ok((distance, radius)),
            RodDataGiven::Moment { distance, inertia } => {
                Ok((distance, named((inertia / given.mass).sqrt())))
            }
            RodDataGiven::Swung { distance, period, gravity } => {
                let length = pendulum("L_g", period, gravity);
                if length.value() < distance.value() {
                    return Err(too_fast());
                }
                Ok((distance, named((distance * (length - distance)).sqrt())))
            }
            RodDataGiven::SwungTwice { gudgeon, crank_pin, gravity } => {
                let first = pendulum("L_g", gudgeon, gravity);
                let second = pendulum("L_c", crank_pin, gravity);
                let span = given.length;
                let (over, sum) = (second - span, first + second - span * 2.0);
                let part = span.value() * over.value() / sum.value();
                if !(part > 0.0 && part < span.value()) {
                    return Err(Refusal::because(
                        "no rod of this length has these two periods: its centre of mass would be beyond a pin; check periods and length",
                    ));
                }
                let why =
                    "Both oscillations give the same radius of gyration: a (L_g − a) = (l − a)(L_c − l + a)";
                sheet.common_error(
                    "a",
                    "the rod divided in proportion to the lengths of the two pendulums",
                    || span * first / (first + second),
                );
                let distance = sheet.step("a", "mm", span * over / sum, why);
                sheet.answer("centre", "Distance of the centre of mass from the gudgeon pin", distance);
                if first.value() < distance.value() {
                    return Err(too_fast());
                }
                Ok((distance, named((distance * (first - distance)).sqrt())))
            }
        }
    }
}

/// Holds centre of mass and radius of gyration to the periods of the rod as a compound pendulum.
fn check_swings<W: Worksheet>(given: &EquivalentRodGiven<W>, near: W::Num, radius: W::Num, sheet: W) {
    let swing = |arm: W::Num, period: W::Num, gravity: W::Num, what: &'static str| {
        let found = ((radius.powi(2) + arm.powi(2)) / (gravity * arm)).sqrt() * TAU;
        sheet.check(what, found, period);
    };
    let about_gudgeon = "period of the rod as a compound pendulum about the gudgeon pin";
    match given.known {
        RodDataGiven::Swung { period, gravity, .. } => swing(near, period, gravity, about_gudgeon),
        RodDataGiven::SwungTwice { gudgeon, crank_pin, gravity } => {
            swing(near, gudgeon, gravity, about_gudgeon);
            let what = "period of the rod as a compound pendulum about the crank pin";
            swing(given.length - near, crank_pin, gravity, what);
        }
        RodDataGiven::Gyration { .. } | RodDataGiven::Moment { .. } => {}
    }
}

fn too_fast() -> Refusal {
    Refusal::because(
        "the rod swings faster than a simple pendulum with all its mass at the centre of mass: check the period and the distance",
    )
}

/// The rod with its centre of mass, the masses in its pins, and the second mass of the equivalent rod.
fn drawing(rod: &EquivalentRod, [near, far, conjugate]: [f64; 3]) -> Drawing {
    let length = near + far;
    let size = 0.05 * length;
    let second = (near + conjugate.min(3.0 * length), 0.0);
    let mut sketch = Sketch::new("The rod and its equivalent masses");
    let (inertia, gyration) = match rod.known {
        RodData::Gyration { radius, .. } => ("G, m", Some(radius)),
        RodData::Moment { .. } => ("G, m, I_G", None),
        _ => ("G, m", None),
    };
    if let Some(radius) = gyration {
        sketch.dimension("k", (near, 0.0), (near + radius, 0.0), -7.0);
    }
    sketch
        .axis((length, 0.0), second)
        .body("", [(0.0, 0.5 * size), (length, 0.8 * size), (length, -0.8 * size), (0.0, -0.5 * size)])
        .disc("m₁", (0.0, 0.0), size)
        .disc("", (length, 0.0), 1.3 * size)
        .mass_centre(inertia, (near, 0.0))
        .round("m₂", second, 0.7 * size, Ink::Result)
        .dimension("a", (0.0, 0.0), (near, 0.0), 5.0)
        .dimension("l", (0.0, 0.0), (length, 0.0), -10.0)
        .caption("gudgeon pin", (0.0, -2.5 * size))
        .caption("crank pin", (length, -2.5 * size))
        .finish()
}
