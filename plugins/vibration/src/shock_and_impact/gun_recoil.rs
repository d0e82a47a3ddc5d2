//! A gun that recoils freely on its spring and returns critically damped.

use std::{
    f64::consts::{E, PI},
    ops::ControlFlow,
};

use dalembert_core::{
    About, Analysis, Axis, Drawing, Exhibit, Inputs, Plot, Refusal, Series, Sketch, Worksheet, register,
};
use dalembert_mechanics::{Real, sdof, vibration::free::FreeMotion};
use dalembert_numerics::roots;

use crate::{
    shared::oscillator::{Mass, mass},
    sources::{GROVER, RAO},
};

/// The barrel, its recoil spring, and how far it recoils.
#[derive(Clone, Debug, Inputs)]
pub struct GunRecoil {
    /// Mass or weight of the recoiling parts.
    pub mass: Mass,
    /// Stiffness of the recoil spring.
    #[input("k", "N/m", positive)]
    pub stiffness: f64,
    /// Recoil.
    pub recoil: Recoil,
    /// Displacement up to which the return is timed.
    /// The return to the exact equilibrium position takes an infinite time.
    #[input("x₁", "m", positive)]
    pub remaining: f64,
}

/// Given quantity of the recoil.
#[derive(Clone, Debug, Inputs)]
pub enum Recoil {
    /// Recoil distance
    Distance {
        /// Recoil distance.
        #[input("R", "m", positive)]
        distance: f64,
    },
    /// Speed at the start of the recoil
    Speed {
        /// Speed at the start of the recoil.
        #[input("v₀", "m/s", positive)]
        speed: f64,
    },
}

register!(GunRecoil);

impl Analysis for GunRecoil {
    const ABOUT: About = About {
        id: "vibration/gun-recoil",
        title: "Recoil and critically damped return",
        topic: "Shock and impact",
        summary: "Speed or distance of a recoil on a spring, the dashpot that returns it without oscillation, and the duration of both.",
        main: &["distance", "total_time", "critical_damping"],
        keywords: "gun barrel dashpot critical damping return time cannon canhão recuo amortecimento crítico",
        sources: &[&RAO, &GROVER],
        cases: include_str!("../../cases/gun_recoil.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &GunRecoilGiven<W>, sheet: W) -> Result<(), Refusal> {
        let mass = mass(&given.mass, sheet);
        let natural = sheet.step(
            "ωₙ",
            "rad/s",
            sdof::natural_frequency(given.stiffness, mass),
            ("Natural frequency without damping", RAO.at("§2.2")),
        );
        let (distance, speed) = match &given.recoil {
            RecoilGiven::Distance { distance } => {
                sheet.common_error("v₀", "the elastic energy of the spring taken as kR²", || {
                    *distance * natural * 2.0_f64.sqrt()
                });
                sheet.common_error("v₀", "the dashpot assumed to act in the recoil too", || {
                    *distance * natural * E
                });
                let speed = sheet.step(
                    "v₀",
                    "m/s",
                    *distance * natural,
                    "The dashpot does not act in recoil: the amplitude of the harmonic motion is v₀/ωₙ",
                );
                (*distance, speed)
            }
            RecoilGiven::Speed { speed } => {
                sheet.common_error("R", "the elastic energy of the spring taken as kR²", || {
                    *speed / (natural * 2.0_f64.sqrt())
                });
                sheet.common_error("R", "the dashpot assumed to act in the recoil too", || {
                    *speed / (natural * E)
                });
                let distance = sheet.step(
                    "R",
                    "m",
                    *speed / natural,
                    "The dashpot does not act in recoil: the amplitude of the harmonic motion is v₀/ωₙ",
                );
                (distance, *speed)
            }
        };
        sheet.check(
            "the kinetic energy at the start is the energy of the spring at the end of the recoil",
            mass * speed.powi(2) / 2.0,
            given.stiffness * distance.powi(2) / 2.0,
        );
        let share = given.remaining.value() / distance.value();
        if share >= 1.0 {
            return Err(Refusal::because(
                "the displacement at which the return time is taken is not below the recoil: write a smaller one",
            ));
        }
        let critical = sheet.step(
            "c_c",
            "N*s/m",
            sdof::critical_damping(given.stiffness, mass),
            ("Critical damping: the fastest return without oscillation", RAO.at("§2.6")),
        );
        sheet.common_error("t₁", "the dashpot assumed to act in the recoil too", || {
            W::Num::from(1.0) / natural
        });
        let out =
            sheet.step("t₁", "s", W::Num::from(PI) / (natural * 2.0), "Recoil time: a quarter of the period");
        let back = sheet.numerical(
            "t₂",
            "s",
            return_angle(share) / natural.value(),
            (
                "Return time, by solving x₁ = R (1 + ωₙt) e^(−ωₙt): with critical damping, from rest",
                RAO.at("§2.6"),
            ),
        );
        let angle = natural * back;
        sheet.check(
            "the motion is at x₁ at that time",
            distance * (W::Num::from(1.0) + angle) * (-angle).exp(),
            given.remaining,
        );
        let motion = FreeMotion {
            natural_frequency: natural.value(),
            damping_ratio: 1.0,
            displacement: distance.value(),
            velocity: 0.0,
        };
        sheet.verify(|| {
            if let Some([there, _]) = motion.integrated(back.value()) {
                sheet.check(
                    "the same by integration of the equation of motion",
                    given.remaining,
                    W::Num::from(there),
                );
            }
        });
        sheet.common_error("t", "the return assumed undamped: a quarter of the period again", || out * 2.0);
        let total = sheet.step("t", "s", out + back, "Recoil and return together");
        sheet.answer("natural_frequency", "Natural frequency", natural);
        sheet.answer("speed", "Speed at the start of the recoil", speed);
        sheet.answer("distance", "Recoil distance", distance);
        sheet.verify(|| {
            sheet.check("with critical damping both roots equal −c/2m = −ωₙ", critical / (mass * 2.0), natural);
            let since = total.value() - PI / 2.0 / natural.value();
            if let Some([there, _]) = motion.integrated(since) {
                sheet.check(
                    "displacement at the end of recoil and return, by integration of the return after a quarter period",
                    W::Num::from(there),
                    given.remaining,
                );
            }
        });
        sheet.answer("critical_damping", "Critical damping", critical);
        sheet.answer("recoil_time", "Recoil time", out);
        sheet.answer("return_time", "Return time", back);
        sheet.answer("total_time", "Recoil and return", total);
        let times = [out.value(), total.value()];
        sheet.show(|| Exhibit::Plot(history(&motion, times)));
        sheet.show(|| Exhibit::Drawing(self.drawing()));
        Ok(())
    }
}

/// The `y > 0` with `(1 + y) e^(−y)` equal to a share below one.
fn return_angle(share: f64) -> f64 {
    // ln of it, so that tiny shares are well behaved: y − ln(1 + y) = −ln share, between its bounds.
    let log = -share.ln();
    let ends = [log, (log + (2.0 * log).sqrt()) * (1.0 + 1e-9)];
    roots::find(|y| y - y.ln_1p() - log, ends, |_| ControlFlow::Continue(())).unwrap_or(f64::NAN)
}

fn history(motion: &FreeMotion, [out, total]: [f64; 2]) -> Plot {
    let recoil = |t: f64| motion.displacement * (motion.natural_frequency * t).sin();
    let at = |n: u16| {
        let t = 1.2 * total * f64::from(n) / 400.0;
        (t, if t < out { recoil(t) } else { motion.state(t - out)[0] })
    };
    Plot::new(
        "Displacement against time",
        Axis::linear("time", "s"),
        Axis::linear("displacement", "mm"),
        vec![Series::line("x", (0..=400).map(at).collect())],
    )
    .mark("end of the recoil", (out, motion.displacement))
    .mark("end of the timed return", (total, motion.state(total - out)[0]))
}

impl GunRecoil {
    /// The barrel before firing, its recoil and the return to the last distance.
    fn drawing(&self) -> Drawing {
        let mut sketch = Sketch::new("The barrel on its recoil spring (distances not to scale)");
        sketch
            .ground((-2.8, 0.9), (-2.8, -0.9))
            .spring("k", (-2.8, 0.35), (-0.9, 0.35))
            .damper("c_c", (-2.8, -0.35), (-0.9, -0.35))
            .mass(self.mass.letter(), (-0.9, -0.6), (0.6, 0.6))
            .mass("", (0.6, -0.2), (2.4, 0.2))
            .axis((-0.9, 0.6), (-0.9, 1.4))
            .dimension("x₁", (-1.3, 0.9), (-0.9, 0.9), 0.0);
        match self.recoil {
            Recoil::Distance { .. } => sketch.dimension("R", (-2.1, 1.3), (-0.9, 1.3), 0.0),
            Recoil::Speed { .. } => sketch.motion("v₀", (0.3, 0.9), (-0.6, 0.9)),
        };
        sketch.motion("x", (0.6, -0.9), (-0.3, -0.9)).finish()
    }
}
