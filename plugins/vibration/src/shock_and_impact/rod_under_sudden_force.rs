//! A free rod that a constant force suddenly pushes at one end, by the waves that run through it.

use dalembert_core::{
    About, Analysis, Axis, Drawing, Exhibit, Inputs, Plot, Refusal, Series, Sketch, Text, Worksheet, register,
};
use dalembert_mechanics::{
    Real,
    vibration::impact::{free_rod_displacement, free_rod_modal_displacement},
};

use crate::{
    shared::section::{AxialSection, area},
    sources::{RAO, TIMOSHENKO},
};

/// The rod, the force on its end, and what is asked.
#[derive(Clone, Debug, Inputs)]
pub struct RodUnderSuddenForce {
    /// Length of the rod.
    #[input("L", "m", positive)]
    pub length: f64,
    /// Section.
    pub section: AxialSection,
    /// Young's modulus.
    #[input("E", "Pa", positive)]
    pub young: f64,
    /// Density.
    #[input("ρ", "kg/m^3", positive)]
    pub density: f64,
    /// Force.
    /// Constant from the start; it pushes one end along the axis of the rod, which nothing else holds.
    #[input("F", "N", positive)]
    pub force: f64,
    /// Time at which the motion is required.
    #[input("t", "s", nonnegative)]
    pub time: f64,
    /// Place at which the motion is required.
    /// Distance from the loaded end.
    #[input("x", "m", nonnegative, default = "0 m")]
    pub place: f64,
}

register!(RodUnderSuddenForce);

impl Analysis for RodUnderSuddenForce {
    const ABOUT: About = About {
        id: "vibration/rod-under-sudden-force",
        title: "Free rod under a sudden force",
        topic: "Shock and impact",
        summary: "Displacement of a free rod that a constant force suddenly pushes at one end, by wave propagation: velocity of the loaded end, return of the wave, stress, rigid-body motion.",
        main: &["displacement", "stress"],
        keywords: "free bar suddenly loaded one end constant force step longitudinal wave rigid-body motion free-free \
                   modes barra livre carregada subitamente força constante onda longitudinal movimento de corpo rígido",
        sources: &[&TIMOSHENKO, &RAO],
        cases: include_str!("../../cases/rod_under_sudden_force.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &RodUnderSuddenForceGiven<W>, sheet: W) -> Result<(), Refusal> {
        let RodUnderSuddenForceGiven { length, young, density, force, time, place, .. } = *given;
        if self.place > self.length {
            return Err(Refusal::because(
                "the place lies beyond the free end of the rod: write a distance not greater than its length",
            ));
        }
        let area = area(&given.section, sheet, "A".into())?;
        let wave =
            sheet.step("c", "m/s", (young / density).sqrt(), ("Wave speed along a rod", RAO.at("§8.3")));
        let stress = sheet.step(
            "σ",
            "MPa",
            force / area,
            "Compressive stress behind the wavefront: the maximum in the rod",
        );
        sheet.common_error(
            "v",
            "the rod treated as rigid: velocity of the centre of mass at that time",
            || force * time / (density * area * length),
        );
        let velocity = sheet.step(
            "v",
            "m/s",
            force * wave / (area * young),
            (
                "In a time dt the wavefront strains a length c dt by σ/E: velocity of the part behind it",
                TIMOSHENKO.at("ch. 5"),
            ),
        );
        let whole = sheet.step("t₁", "ms", length / wave, "The wavefront reaches the free end");
        let round = sheet.step(
            "t₂",
            "ms",
            length * 2.0 / wave,
            "The wave, reflected as tension, is back at the loaded end: the rod is without stress, and moves at 2v",
        );
        let mass = sheet.step("m", "kg", density * area * length, "Mass of the rod");
        sheet.verify(|| {
            sheet.check("stress behind a wavefront from the velocity, ρ c v", density * wave * velocity, stress);
            sheet.check(
                "impulse of the force until the wavefront reaches the free end = momentum of the rod, all of it at v",
                force * whole,
                mass * velocity,
            );
            sheet.check(
                "work of the force until then = kinetic energy + strain energy",
                force * velocity * whole,
                mass * velocity.powi(2) / 2.0 + stress.powi(2) / (young * 2.0) * area * length,
            );
            sheet.check(
                "impulse of the force until the wave is back = momentum of the rod, all of it at 2v",
                force * round,
                mass * velocity * 2.0,
            );
        });
        sheet.answer("wave_speed", "Wave speed", wave);
        sheet.answer("stress", "Maximum compressive stress", stress);
        sheet.answer("velocity", "Velocity of the loaded end until the wave returns", velocity);
        sheet.answer("transit_time", "Time for the wave to reach the free end", whole);
        sheet.answer("return_time", "Time until the wave returns", round);
        let centre = sheet.step(
            "u_G",
            "mm",
            force * time.powi(2) / (mass * 2.0),
            "Rigid-body motion: displacement of the centre of mass",
        );
        let displacement = displacement(given, [wave, velocity, round], sheet);
        let scales =
            Scales { length: length.value(), transit: whole.value(), unit: (velocity * whole).value() };
        sheet.verify(|| {
            let (xi, tau) = ((place / length).value(), (time / whole).value());
            sheet.check_sum(
                "displacement from the rigid-body motion and the sum of the free-free modes",
                displacement,
                velocity * whole * free_rod_modal_displacement(xi, tau),
                scales.unit * tau * (1.0 + tau),
            );
            sheet.check(
                "displacement of the centre of mass: mean of the displacements over the length",
                centre,
                velocity * whole * mean_displacement(tau),
            );
        });
        sheet.answer("centre_displacement", "Displacement of the centre of mass", centre);
        sheet.answer("displacement", "Displacement at that place and time", displacement);
        if (stress / young).value() > 0.02 {
            sheet.warn(|| {
                Text::new("the strain exceeds 2 %: this is beyond small deformations and the range of most materials")
            });
        }
        sheet.show(|| Exhibit::Plot(self.history(&scales, displacement.value())));
        sheet.show(|| Exhibit::Plot(self.along(&scales, displacement.value())));
        sheet.show(|| Exhibit::Drawing(self.drawing()));
        Ok(())
    }
}

/// The scales of the motion.
struct Scales {
    /// Length of the rod, m.
    length: f64,
    /// Time of the wave along the rod, s.
    transit: f64,
    /// Displacement of the loaded end until then, m.
    unit: f64,
}

/// The displacement at the asked place and time, by the waves that have passed.
fn displacement<W: Worksheet>(
    given: &RodUnderSuddenForceGiven<W>,
    [wave, velocity, round]: [W::Num; 3],
    sheet: W,
) -> W::Num {
    let RodUnderSuddenForceGiven { length, time, place, .. } = *given;
    let trips = (time.value() / round.value()).floor();
    let (lapse, before) = if trips > 0.0 {
        let why =
            "Round trips of the wave before that time: each leaves the rod without stress and faster by 2v";
        let trips = sheet.numerical("n", "1", trips, why);
        let lapse = sheet.step("τ", "ms", time - trips * round, "Time since the last of them");
        let why = "Displacement of the whole rod at the velocities that the round trips have left it";
        let before = velocity * (trips.powi(2) * round + trips * lapse * 2.0);
        (lapse, Some(sheet.step("u₀", "mm", before, why)))
    } else {
        (time, None)
    };
    let parts = [lapse - place / wave, lapse - (length * 2.0 - place) / wave];
    let passed: Vec<W::Num> = parts.into_iter().filter(|part| part.value() > 0.0).collect();
    let why = match (passed.len(), before) {
        (0, None) => {
            return sheet.numerical("u", "mm", 0.0, "The wavefront has not reached the place: it is at rest");
        }
        (0, Some(_)) => "The next wavefront has not reached the place",
        (1, _) => "After the wavefront has passed, the place moves faster by v",
        _ => "The reflected wave has passed too: faster by v once more",
    };
    let waves = (!passed.is_empty()).then(|| velocity * W::Num::sum(passed));
    if place.value() > 0.0 {
        sheet.common_error("u", "the travel time of the wave to the place omitted", || velocity * time);
    }
    if parts[1].value() > 0.0 || before.is_some() {
        sheet.common_error("u", "the reflections of the wave omitted", || velocity * (time - place / wave));
    }
    let value = W::Num::sum(before.into_iter().chain(waves));
    sheet.step("u", "mm", value, (why, TIMOSHENKO.at("ch. 5")))
}

/// The mean over the length of the displacements, which are linear between the ends and the wavefront.
fn mean_displacement(tau: f64) -> f64 {
    let folded = tau.rem_euclid(2.0);
    let front = folded.min(2.0 - folded);
    let at = |xi: f64| free_rod_displacement(xi, tau);
    0.5 * (front * (at(0.0) + at(front)) + (1.0 - front) * (at(front) + at(1.0)))
}

impl RodUnderSuddenForce {
    /// Displacements of place, ends and centre of mass over the time.
    fn history(&self, scales: &Scales, displacement: f64) -> Plot {
        let last = (1.2 * self.time).max(2.5 * scales.transit);
        let times = || (0..=240u16).map(|n| last * f64::from(n) / 240.0);
        let of = |xi: f64| -> Vec<(f64, f64)> {
            times().map(|t| (t, scales.unit * free_rod_displacement(xi, t / scales.transit))).collect()
        };
        let centre = times().map(|t| (t, 0.5 * scales.unit * (t / scales.transit).powi(2))).collect();
        Plot::new(
            "Displacement against time",
            Axis::linear("time", "ms"),
            Axis::linear("displacement", "mm"),
            vec![
                Series::line("loaded end", of(0.0)).of("displacement").with("place", 0.0),
                Series::line("free end", of(1.0)).of("displacement").with("place", self.length),
                Series::line("centre of mass", centre).of("centre_displacement"),
            ],
        )
        .over("time")
        .mark("at that place and time", (self.time, displacement))
    }

    /// Displacements along the rod at the asked time.
    fn along(&self, scales: &Scales, displacement: f64) -> Plot {
        let at = |n: u16| {
            let xi = f64::from(n) / 200.0;
            (xi * scales.length, scales.unit * free_rod_displacement(xi, self.time / scales.transit))
        };
        Plot::new(
            "Displacement along the rod",
            Axis::linear("distance from the loaded end", "m"),
            Axis::linear("displacement", "mm"),
            vec![Series::line("u", (0..=200).map(at).collect()).of("displacement")],
        )
        .over("place")
        .mark("at that place and time", (self.place, displacement))
    }
}

impl RodUnderSuddenForce {
    fn drawing(&self) -> Drawing {
        let x = -2.0 + 5.0 * (self.place / self.length).min(1.0);
        let mut sketch = Sketch::new("The free rod and the force on its end");
        sketch
            .mass("", (-2.0, -0.3), (3.0, 0.3))
            .force("F", (-3.4, 0.0), (-2.05, 0.0))
            .motion("u", (-1.8, 0.7), (-0.6, 0.7))
            .dimension("L", (-2.0, -0.3), (3.0, -0.3), -2.5);
        if x > -2.0 {
            sketch.dimension("x", (-2.0, -0.3), (x, -0.3), -1.0).axis((x, -0.4), (x, 0.4));
        }
        sketch.finish()
    }
}
