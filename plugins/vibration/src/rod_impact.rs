//! A rod that strikes a rigid wall with its end, by the waves that run through it.

use dalembert_core::{
    About, Analysis, Axis, DrawnShape, Exhibit, Film, Ink, Inputs, Plot, Refusal, Series, Text, Worksheet,
    register,
};
use dalembert_mechanics::{Real, vibration::impact};

use crate::sources::{RAO, TIMOSHENKO};

/// The rod and its speed.
#[derive(Clone, Debug, Inputs)]
pub struct RodImpact {
    /// Length of the rod.
    #[input("L", "m", positive)]
    pub length: f64,
    /// Young's modulus.
    #[input("E", "Pa", positive)]
    pub young: f64,
    /// Density.
    #[input("ρ", "kg/m^3", positive)]
    pub density: f64,
    /// Speed of the rod.
    /// Along its axis, against the wall.
    #[input("v", "m/s", positive)]
    pub speed: f64,
    /// Area of the section.
    /// Where it is given, the force on the wall is answered too.
    #[input("A", "m^2", positive)]
    pub area: Option<f64>,
    /// Largest stress of the material.
    /// Where it is given, the speed that reaches it is answered too.
    #[input("σ_y", "Pa", positive)]
    pub strength: Option<f64>,
}

register!(RodImpact);

impl Analysis for RodImpact {
    const ABOUT: About = About {
        id: "vibration/rod-impact",
        title: "Rod that strikes a wall",
        topic: "Shock and impact",
        summary: "Largest stress, largest shortening and time of contact of a rod that strikes a rigid wall with its end, by waves.",
        keywords: "longitudinal impact wave stress collision bar choque impacto longitudinal barra onda tensão",
        sources: &[&TIMOSHENKO, &RAO],
        cases: include_str!("../cases/rod_impact.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &RodImpactGiven<W>, sheet: W) -> Result<(), Refusal> {
        let RodImpactGiven { length, young, density, speed, .. } = *given;
        let wave =
            sheet.step("c", "m/s", (young / density).sqrt(), ("Speed of waves along a rod", RAO.at("§8.3")));
        if speed.value() >= wave.value() {
            return Err(Refusal::because(
                "the rod is as fast as the waves in it, or faster: no elastic wave can stop it; write a smaller speed",
            ));
        }
        let strain = sheet.step(
            "ε",
            "1",
            speed / wave,
            "In a time dt the front of the wave stops a length c dt, which shortens by v dt",
        );
        let stress = sheet.step(
            "σ",
            "MPa",
            young * strain,
            ("Stress behind the front of the wave: the largest in the rod", TIMOSHENKO.at("ch. 5")),
        );
        let whole = sheet.step(
            "t₁",
            "ms",
            length / wave,
            "The front reaches the free end: all of the rod is at rest",
        );
        let shortening =
            sheet.step("δ", "mm", speed * whole, "Until then the free end has gone on at its speed");
        let contact = sheet.step(
            "t₂",
            "ms",
            length * 2.0 / wave,
            "The wave comes back and unloads the rod: it leaves the wall",
        );
        sheet.verify(|| {
            sheet.check(
                "kinetic energy before is the strain energy of the shortened rod, for each volume",
                density * speed.powi(2) / 2.0,
                stress.powi(2) / (young * 2.0),
            );
            sheet.check(
                "the momentum for each area is turned round by the stress at the wall during the contact",
                density * length * speed * 2.0,
                stress * contact * impact::stress(0.0, 0.5 * (contact * wave / length).value()),
            );
            sheet.check(
                "the momentum for each area is taken by the stress until the rod is at rest",
                density * length * speed,
                stress * whole,
            );
            sheet.check("largest shortening: the same strain in all of the rod", shortening, strain * length);
            let tau = (whole * wave / length).value();
            let moved = impact::displacement(1.0, tau) - impact::displacement(0.0, tau);
            sheet.check(
                "largest shortening by d'Alembert's solution",
                shortening,
                length * speed / wave * moved,
            );
        });
        sheet.answer("wave_speed", "Wave speed", wave);
        sheet.answer("stress", "Largest compressive stress", stress);
        sheet.answer("shortening", "Largest shortening", shortening);
        sheet.answer("shortening_time", "Time to the largest shortening", whole);
        sheet.answer("contact_time", "Time of contact", contact);
        if let Some(area) = given.area {
            let force = sheet.step("F", "kN", stress * area, "Force on the wall during the contact");
            sheet.answer("force", "Force on the wall", force);
            sheet.check(
                "impulse of the wall: the momentum of the rod is turned round",
                force * contact,
                density * length * area * speed * 2.0,
            );
        }
        if let Some(strength) = given.strength {
            let limit = sheet.step(
                "v_y",
                "m/s",
                strength / (young * density).sqrt(),
                ("Speed at which the stress reaches that of the material", TIMOSHENKO.at("ch. 5")),
            );
            sheet.answer("largest_speed", "Largest speed", limit);
            sheet.check(
                "kinetic energy at that speed is the strain energy at the strength, for each volume",
                density * limit.powi(2) / 2.0,
                strength.powi(2) / (young * 2.0),
            );
            if speed.value() > limit.value() {
                sheet.warn(|| {
                    Text::new(
                        "the rod yields: the stress of an elastic rod would be above that of the material",
                    )
                });
            }
        }
        if strain.value() > 0.02 {
            sheet.warn(|| {
                Text::new("the strain is above 2 %: small deformations, and most materials, do not reach it")
            });
        }
        let numbers = (wave.value(), stress.value());
        sheet.show(|| Exhibit::Plot(self.free_end(numbers.0)));
        sheet.show(|| Exhibit::Plot(self.stress_at_the_middle(numbers)));
        sheet.show(Self::film);
        Ok(())
    }
}

impl RodImpact {
    /// Shortening against time, until the rod has left the wall.
    fn free_end(&self, wave: f64) -> Plot {
        let last = 3.0 * self.length / wave;
        let at = |n: u16| {
            let t = last * f64::from(n) / 300.0;
            let moved = |xi: f64| impact::displacement(xi, t * wave / self.length);
            (t, (moved(1.0) - moved(0.0)) * self.speed * self.length / wave)
        };
        Plot::new(
            "Shortening of the rod",
            Axis::linear("time", "ms"),
            Axis::linear("shortening", "mm"),
            vec![Series::line("shortening", (0..=300).map(at).collect())],
        )
        .mark("largest", (self.length / wave, self.speed * self.length / wave))
    }

    /// Compressive stress at the wall and at the middle against time.
    fn stress_at_the_middle(&self, (wave, stress): (f64, f64)) -> Plot {
        let last = 3.0 * self.length / wave;
        let line = |xi: f64| {
            let at = |n: u16| {
                let t = last * f64::from(n) / 300.0;
                (t, stress * impact::stress(xi, t * wave / self.length))
            };
            (0..=300).map(at).collect()
        };
        Plot::new(
            "Compressive stress",
            Axis::linear("time", "ms"),
            Axis::linear("compressive stress", "MPa"),
            vec![Series::line("at the wall", line(0.0)), Series::line("at the middle", line(0.5))],
        )
    }

    /// The rod and its loaded part, the shortening enlarged.
    fn film() -> Exhibit {
        let frame = |n: u16| {
            let tau = 3.0 * f64::from(n) / 24.0;
            let place = |xi: f64| 5.0 * (xi - 0.15 * impact::displacement(xi, tau));
            let mut shapes = vec![DrawnShape::Ground((0.0, 1.0), (0.0, -1.0))];
            for part in 0..10 {
                let (from, to) = (f64::from(part) / 10.0, f64::from(part + 1) / 10.0);
                let loaded = impact::stress(0.5 * (from + to), tau) > 0.0;
                let ink = if loaded { Ink::Danger } else { Ink::Body };
                shapes.push(DrawnShape::Block((place(from), -0.4), (place(to), 0.4), ink));
            }
            shapes
        };
        Exhibit::Film(Film::new("The loaded part of the rod", (0..24).map(frame).collect(), 3.0))
    }
}
