//! Two pendulums coupled by a spring: rods or bobs, hanging or in a horizontal plane.

use std::f64::consts::TAU;

use dalembert_core::{About, Analysis, Exhibit, Inputs, Refusal, Sketch, Text, Worksheet, register};
use dalembert_mechanics::{Real, vibration::modes::natural_modes};
use nalgebra::{DMatrix, DVector};

use crate::{
    shared::system::{
        modes::{agreement, refusal},
        two_degrees,
    },
    sources::RAO,
};

/// The pendulums, their spring, and what pulls them back.
#[derive(Clone, Debug, Inputs)]
pub struct CoupledPendulums {
    /// First pendulum.
    #[input("1")]
    pub left: Pendulum,
    /// Second pendulum.
    #[input("2")]
    pub right: Pendulum,
    /// Stiffness of the spring between them.
    #[input("k", "N/m", positive)]
    pub spring: f64,
    /// Gravity along the pendulums at rest.
    /// Omit if they lie in a horizontal plane; negative if they are inverted.
    #[input("g", "m/s^2")]
    pub gravity: Option<f64>,
}

/// A pendulum.
#[derive(Clone, Debug, Inputs)]
pub enum Pendulum {
    /// Slender uniform rod, pivoted at its end
    Rod {
        /// Mass.
        #[input("m", "kg", positive)]
        mass: f64,
        /// Length.
        #[input("l", "m", positive)]
        length: f64,
        /// Distance of the spring from the pivot.
        #[input("a", "m", positive)]
        spring: f64,
    },
    /// Small mass on a light rod
    Bob {
        /// Mass.
        #[input("m", "kg", positive)]
        mass: f64,
        /// Length.
        #[input("l", "m", positive)]
        length: f64,
        /// Distance of the spring from the pivot.
        #[input("a", "m", positive)]
        spring: f64,
    },
}

register!(CoupledPendulums);

impl Analysis for CoupledPendulums {
    const ABOUT: About = About {
        id: "vibration/coupled-pendulums",
        title: "Coupled pendulums",
        topic: "Several degrees of freedom",
        summary: "Natural frequencies, amplitude ratios and beats of two rods or pendulums joined by a spring.",
        main: &["frequency", "beat_frequency"],
        keywords: "pendulum rods spring coupling beats two degrees pêndulos acoplados barras mola batimento dois \
                   graus de liberdade",
        sources: &[&RAO],
        cases: include_str!("../../cases/coupled_pendulums.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &CoupledPendulumsGiven<W>, sheet: W) -> Result<(), Refusal> {
        let of = |place: usize, pendulum: &PendulumGiven<W>| {
            let own_symbol = if place == 1 { "K₁₁" } else { "K₂₂" };
            let (inertia, lever, length, spring) = match pendulum {
                PendulumGiven::Rod { mass, length, spring } => {
                    let central = || *mass * length.powi(2) / 12.0;
                    let what = "the moment of inertia of the rod taken about its centre";
                    sheet.common_error(("J", place), what, central);
                    let at_middle = || *mass * (*length / 2.0).powi(2);
                    let what = "the mass of the rod taken as a point at its middle";
                    sheet.common_error(("J", place), what, at_middle);
                    let inertia = sheet.step(
                        ("J", place),
                        "kg*m^2",
                        *mass * length.powi(2) / 3.0,
                        "Moment of inertia of the rod about its pivot",
                    );
                    if let Some(gravity) = given.gravity {
                        let at_end = || given.spring * spring.powi(2) + *mass * *length * gravity;
                        sheet.common_error(own_symbol, "the weight of the rod taken at its end", at_end);
                    }
                    (inertia, *mass * *length / 2.0, *length, *spring)
                }
                PendulumGiven::Bob { mass, length, spring } => (
                    sheet.step(
                        ("J", place),
                        "kg*m^2",
                        *mass * length.powi(2),
                        "Moment of inertia of the small mass about the pivot",
                    ),
                    *mass * *length,
                    *length,
                    *spring,
                ),
            };
            let moment = |arm: W::Num| {
                let own = given.spring * arm.powi(2);
                match given.gravity {
                    Some(gravity) => own + lever * gravity,
                    None => own,
                }
            };
            sheet.common_error(own_symbol, "the spring taken at the end of the pendulum", || moment(length));
            let own = sheet.step(
                own_symbol,
                "N*m/rad",
                moment(spring),
                (
                    "Moment of spring and weight for a unit rotation of this pendulum, the other fixed",
                    RAO.at("§5.4"),
                ),
            );
            (inertia, own, spring)
        };
        let (first, k11, a1) = of(1, &given.left);
        let (second, k22, a2) = of(2, &given.right);
        let k12 = sheet.step(
            "K₁₂",
            "N*m/rad",
            -given.spring * a1 * a2,
            "Moment on one for a unit rotation of the other, transmitted by the spring",
        );
        let two = two_degrees::solve([first, second], [k11, k12, k22], "1", sheet)?;
        for (mode, frequency) in two.frequencies.iter().enumerate() {
            sheet.answer(("frequency", mode + 1), "Natural frequency", *frequency);
            if let Some(ratios) = two.ratios {
                sheet.answer(("ratio", mode + 1), "Angle of the second over that of the first", ratios[mode]);
            }
        }
        let [slow, fast] = two.frequencies;
        if slow.value() > 0.0 && fast.value() < 1.2 * slow.value() {
            let beat = sheet.step(
                "ω_b",
                "rad/s",
                fast - slow,
                ("The motion passes from one pendulum to the other and back: beats", RAO.at("§5.4")),
            );
            sheet.answer("beat_frequency", "Frequency of the beats", beat);
        }
        let mass = DMatrix::from_diagonal(&DVector::from_column_slice(&[first.value(), second.value()]));
        let stiffness = DMatrix::from_row_slice(2, 2, &[k11.value(), k12.value(), k12.value(), k22.value()]);
        let modes = natural_modes(&mass, &stiffness).map_err(refusal)?;
        sheet.verify(|| agreement(&two, &modes, sheet));
        sheet.show(|| {
            let mut sketch = self.sketch([0.0; 2]).titled("The pendulums and their spring");
            self.letters(&mut sketch);
            Exhibit::Drawing(sketch.finish())
        });
        for mode in 0..2 {
            let shape = [modes.shapes[(0, mode)], modes.shapes[(1, mode)]];
            let largest = shape[0].abs().max(shape[1].abs());
            sheet.show(|| {
                let frames = (0..24).map(|frame| {
                    let now = 0.35 / largest * (TAU * f64::from(frame) / 24.0).cos();
                    self.sketch(shape.map(|x| x * now))
                });
                Exhibit::Animation(Sketch::animation(
                    Text::new("Mode {mode}").with("mode", mode + 1),
                    frames,
                    2.0,
                ))
            });
        }
        Ok(())
    }
}

impl CoupledPendulums {
    /// Length, distance of the spring and whether there is a bob, of each pendulum; and their distance in the drawing.
    fn sizes(&self) -> ([(f64, f64, bool); 2], f64) {
        let sizes = [&self.left, &self.right].map(|pendulum| match pendulum {
            Pendulum::Rod { length, spring, .. } => (*length, *spring, false),
            Pendulum::Bob { length, spring, .. } => (*length, *spring, true),
        });
        let apart = 0.8 * sizes[0].0.max(sizes[1].0).max(sizes[0].1).max(sizes[1].1);
        (sizes, apart)
    }

    /// Masses, lengths and distances of the spring, at the outer side of each pendulum.
    fn letters(&self, sketch: &mut Sketch) {
        let (sizes, apart) = self.sizes();
        let letters = [(["m_1", "l_1", "a_1"], -1.0), (["m_2", "l_2", "a_2"], 1.0)];
        for (place, ((length, spring, bob), ([mass, whole, arm], side))) in
            sizes.into_iter().zip(letters).enumerate()
        {
            let x = apart * place as f64;
            sketch
                .dimension(arm, (x, 0.0), (x, -spring), 2.5 * side)
                .dimension(whole, (x, 0.0), (x, -length), 5.5 * side)
                .label(mass, (x, if bob { -length } else { -0.5 * length }));
        }
    }

    /// The pendulums turned by so much.
    fn sketch(&self, turns: [f64; 2]) -> Sketch {
        let (sizes, apart) = self.sizes();
        let mut sketch = Sketch::default();
        let mut ends = Vec::new();
        for (place, ((length, spring, bob), turn)) in sizes.into_iter().zip(turns).enumerate() {
            let x = apart * place as f64;
            let at = |distance: f64| (x + distance * turn.sin(), -distance * turn.cos());
            sketch.link("", (x, 0.0), at(length.max(spring))).hung_pin("", (x, 0.0));
            if bob {
                sketch.disc("", at(length), 0.06 * apart);
            }
            ends.push(at(spring));
        }
        sketch.spring("k", ends[0], ends[1]);
        sketch
    }
}
