//! A rod that strikes a rigid wall with its end, by the waves that run through it.

use dalembert_core::{
    About, Analysis, Axis, Exhibit, Ink, Inputs, Plot, Refusal, Series, Sketch, Text, Worksheet, register,
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
    /// If given, the force on the wall is also computed.
    #[input("A", "m^2", positive)]
    pub area: Option<f64>,
    /// Strength of the material.
    /// If given, the speed that reaches it is also computed.
    #[input("σ_y", "Pa", positive)]
    pub strength: Option<f64>,
}

register!(RodImpact);

impl Analysis for RodImpact {
    const ABOUT: About = About {
        id: "vibration/rod-impact",
        title: "Rod striking a wall",
        topic: "Shock and impact",
        summary: "Maximum stress, maximum shortening and contact time of a rod that strikes a rigid wall end-on, by wave propagation.",
        main: &["contact_time", "stress", "force"],
        keywords: "longitudinal impact wave stress collision bar choque impacto longitudinal barra onda tensão",
        sources: &[&TIMOSHENKO, &RAO],
        cases: include_str!("../../cases/rod_impact.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &RodImpactGiven<W>, sheet: W) -> Result<(), Refusal> {
        let RodImpactGiven { length, young, density, speed, .. } = *given;
        let wave =
            sheet.step("c", "m/s", (young / density).sqrt(), ("Wave speed along a rod", RAO.at("§8.3")));
        if speed.value() >= wave.value() {
            return Err(Refusal::because(
                "the rod is as fast as the waves in it, or faster: no elastic wave can stop it; write a smaller speed",
            ));
        }
        let strain = sheet.step(
            "ε",
            "1",
            speed / wave,
            "In a time dt the wave front brings a length c dt to rest, which shortens by v dt",
        );
        sheet.common_error(
            "σ",
            "the momentum balance made with the speed of the rod in place of that of the wave: ρv²",
            || density * speed.powi(2),
        );
        sheet.common_error("σ", "the kinetic energy per unit volume taken as the stress", || {
            density * speed.powi(2) / 2.0
        });
        let stress = sheet.step(
            "σ",
            "MPa",
            young * strain,
            ("Stress behind the wavefront: the maximum in the rod", TIMOSHENKO.at("ch. 5")),
        );
        sheet.common_error("t₁", "the speed of the rod used in place of that of the wave", || {
            length / speed
        });
        let whole = sheet.step(
            "t₁",
            "ms",
            length / wave,
            "The wavefront reaches the free end: the whole rod is at rest",
        );
        let shortening =
            sheet.step("δ", "mm", speed * whole, "Until then the free end has continued at its speed");
        sheet.common_error("t₂", "the rod treated as a mass on a spring: half a period taken", || {
            length / wave * std::f64::consts::PI
        });
        sheet.common_error("t₂", "the speed of the rod used in place of that of the wave", || {
            length * 2.0 / speed
        });
        let contact = sheet.step(
            "t₂",
            "ms",
            length * 2.0 / wave,
            "The reflected wave unloads the rod: it leaves the wall",
        );
        sheet.verify(|| {
            sheet.check(
                "initial kinetic energy equals the strain energy of the shortened rod, per unit volume",
                density * speed.powi(2) / 2.0,
                stress.powi(2) / (young * 2.0),
            );
            sheet.check(
                "the momentum per unit area is reversed by the stress at the wall during contact",
                density * length * speed * 2.0,
                stress * contact * impact::stress(0.0, 0.5 * (contact * wave / length).value()),
            );
            sheet.check(
                "the momentum per unit area is absorbed by the stress until the rod is at rest",
                density * length * speed,
                stress * whole,
            );
            sheet.check("maximum shortening: uniform strain in the whole rod", shortening, strain * length);
            let tau = (whole * wave / length).value();
            let moved = impact::displacement(1.0, tau) - impact::displacement(0.0, tau);
            sheet.check(
                "maximum shortening by d'Alembert's solution",
                shortening,
                length * speed / wave * moved,
            );
        });
        sheet.answer("wave_speed", "Wave speed", wave);
        sheet.answer("stress", "Maximum compressive stress", stress);
        sheet.answer("shortening", "Maximum shortening", shortening);
        sheet.answer("shortening_time", "Time to maximum shortening", whole);
        sheet.answer("contact_time", "Contact duration", contact);
        if let Some(area) = given.area {
            let force = sheet.step("F", "kN", stress * area, "Force on the wall during the contact");
            sheet.answer("force", "Force on the wall", force);
            sheet.check(
                "impulse of the wall: it reverses the momentum of the rod",
                force * contact,
                density * length * area * speed * 2.0,
            );
        }
        if let Some(strength) = given.strength {
            sheet.common_error("v_y", "the kinetic energy per unit volume set equal to the strength", || {
                (strength * 2.0 / density).sqrt()
            });
            let limit = sheet.step(
                "v_y",
                "m/s",
                strength / (young * density).sqrt(),
                ("Speed at which the stress reaches the strength of the material", TIMOSHENKO.at("ch. 5")),
            );
            sheet.answer("largest_speed", "Maximum velocity", limit);
            sheet.check(
                "kinetic energy at that speed is the strain energy at the strength, per unit volume",
                density * limit.powi(2) / 2.0,
                strength.powi(2) / (young * 2.0),
            );
            if speed.value() > limit.value() {
                sheet.warn(|| {
                    Text::new(
                        "the rod yields: the elastic stress would exceed the yield strength of the material",
                    )
                });
            }
        }
        if strain.value() > 0.02 {
            sheet.warn(|| {
                Text::new("the strain exceeds 2 %: this is beyond small deformations and the range of most materials")
            });
        }
        let numbers = (wave.value(), stress.value());
        sheet.show(|| Exhibit::Plot(self.free_end(numbers.0)));
        sheet.show(|| Exhibit::Plot(self.stress_at_the_middle(numbers)));
        sheet.show(Self::animation);
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
    fn animation() -> Exhibit {
        let frame = |n: u16| {
            let tau = 3.0 * f64::from(n) / 24.0;
            let place = |xi: f64| 5.0 * (xi - 0.15 * impact::displacement(xi, tau));
            let mut sketch = Sketch::default();
            sketch.ground((0.0, 1.0), (0.0, -1.0)).dimension("L", (0.0, -0.4), (5.0, -0.4), -2.0).motion(
                "v",
                (5.0, 0.8),
                (4.0, 0.8),
            );
            for part in 0..10 {
                let (from, to) = (f64::from(part) / 10.0, f64::from(part + 1) / 10.0);
                let loaded = impact::stress(0.5 * (from + to), tau) > 0.0;
                let ink = if loaded { Ink::Danger } else { Ink::Body };
                sketch.block("", (place(from), -0.4), (place(to), 0.4), ink);
            }
            sketch
        };
        Exhibit::Animation(Sketch::animation("The compressed part of the rod", (0..24).map(frame), 3.0))
    }
}
