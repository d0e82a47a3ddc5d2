//! A chain of bars that hangs from a pin and is pulled at its free end: one degree of freedom for each bar.

use dalembert_core::{
    About, Analysis, Drawing, Exhibit, Inputs, Refusal, Sketch, TableExhibit, Text, Worksheet,
    exhibit::{Cell, Column},
    register,
};
use dalembert_mechanics::{
    Real,
    planar::{BodyPoint, Driver, PlanarBody, PlanarJoint, PlanarLoad, PlanarMechanism, RelativeCoordinate},
};
use std::f64::consts::FRAC_PI_2;

use crate::{
    shared::{
        equilibria::{down, reactions, solved},
        figure::letter,
    },
    sources::{BEER, HIBBELER, RIUL},
};

/// Uniform bars hinged end to end, the first to a fixed pin, with forces at the free end.
#[derive(Clone, Debug, Inputs)]
pub struct HangingChain {
    /// Bars, from the pin to the free end.
    #[input(min = 1)]
    pub bars: Vec<Bar>,
    /// Vertical force at the free end, downwards.
    #[input("Q", "N", default = "0 N")]
    pub vertical: f64,
    /// Find.
    pub sought: ChainUnknown,
}

/// A bar of the chain.
#[derive(Clone, Debug, Inputs)]
pub struct Bar {
    /// Weight.
    /// Uniform: it acts in the middle.
    #[input("W", "N", nonnegative)]
    pub weight: f64,
    /// Length.
    #[input("l", "m", positive)]
    pub length: f64,
}

/// Unknown of the problem.
#[derive(Clone, Debug, Inputs)]
pub enum ChainUnknown {
    /// Angles under a horizontal force
    Angles {
        /// Horizontal force at the free end.
        #[input("F", "N")]
        force: f64,
    },
    /// Horizontal force for a given angle of a bar
    Force {
        /// Bar number, from the pin.
        #[input(min = 1, max = 30)]
        bar: u32,
        /// Its angle from the vertical.
        #[input("θ", "deg", above = -90, below = 90)]
        angle: f64,
    },
}

/// Bars whose letters have room in a drawing.
const MOST_NAMED: usize = 8;

register!(HangingChain);

impl Analysis for HangingChain {
    const ABOUT: About = About {
        id: "virtual-work/hanging-chain",
        title: "Hanging chain of bars",
        topic: "Bars and levers",
        summary: "Angles of a chain of hinged bars pulled at its free end, with the stability in each degree of freedom, or the force for a given angle.",
        main: &["angle", "force"],
        keywords: "several degrees of freedom Hessian linked bars cadeia de barras articuladas vários graus de liberdade Hessiana \
                   estabilidade",
        sources: &[&BEER, &HIBBELER, &RIUL],
        cases: include_str!("../../cases/hanging_chain.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &HangingChainGiven<W>, sheet: W) -> Result<(), Refusal> {
        if self.bars.len() > 30 {
            return Err(Refusal::because("the chain has more than 30 bars: write fewer"));
        }
        // Each weight pulls at every bar above it: the pull on a bar is half its own weight and all below it.
        let mut pulls = Vec::new();
        for row in 0..self.bars.len() {
            let own = given.bars[row].weight / 2.0;
            let under = given.bars[row + 1..].iter().map(|bar| bar.weight).chain([given.vertical]);
            let under = under.filter(|pull| pull.value() != 0.0);
            let weights = || given.bars.iter().map(|bar| bar.weight);
            let above = || W::Num::sum([own].into_iter().chain(weights().take(row)).chain([given.vertical]));
            let halves =
                || W::Num::sum(weights().skip(row).map(|weight| weight / 2.0).chain([given.vertical]));
            sheet.common_error(
                ("G", row + 1),
                "the weights of the bars above counted in place of those below",
                above,
            );
            sheet.common_error(("G", row + 1), "half the weight of each bar below counted", halves);
            pulls.push(sheet.step(
                ("G", row + 1),
                "N",
                W::Num::sum([own].into_iter().chain(under)),
                "Downward force on the bar, half its own weight plus everything below it: its virtual work is −G l sin θ δθ",
            ));
        }
        let force = match (&self.sought, &given.sought) {
            (_, ChainUnknownGiven::Angles { force }) => *force,
            (ChainUnknown::Force { bar, .. }, ChainUnknownGiven::Force { angle, .. }) => {
                let Some(pull) = pulls.get(*bar as usize - 1) else {
                    let why = Text::new("bar {bar} does not exist: the chain has {bars}");
                    return Err(Refusal::NoAnswer(why.with("bar", bar).with("bars", self.bars.len())));
                };
                let force = sheet.step(
                    "F",
                    "N",
                    *pull * angle.tan(),
                    ("Horizontal force, from a virtual rotation of this bar alone: F l cos θ − G l sin θ = 0", RIUL.at("eq. 3")),
                );
                sheet.answer("force", "Horizontal force at the free end", force);
                force
            }
            _ => unreachable!("what is given is made from what is sought"),
        };
        let mut angles = Vec::new();
        let mut bends = Vec::new();
        let (mut across, mut depth) = (Vec::new(), Vec::new());
        for (row, (bar, pull)) in given.bars.iter().zip(&pulls).enumerate() {
            let n = row + 1;
            if force.value() == 0.0 && pull.value() == 0.0 {
                let why = Text::new("no force pulls on bar {bar}: every angle is an equilibrium");
                return Err(Refusal::NoAnswer(why.with("bar", n)));
            }
            let angle = sheet.step(
                ("θ", n),
                "deg",
                force.atan2(*pull),
                (
                    "Angle from the vertical: δU = (F l cos θ − G l sin θ) δθ = 0 for a virtual rotation of this bar alone, tan θ = F/G",
                    RIUL.at("eq. 3"),
                ),
            );
            sheet.answer(("angle", n), "Angle of bar from the vertical", angle);
            bends.push(sheet.step(
                ("H", n),
                "N*m/rad",
                bar.length * (*pull * angle.cos() + force * angle.sin()),
                (
                    "∂²V/∂θ²: V is a sum with one angle in each term, so the Hessian is diagonal; positive for a stable equilibrium",
                    BEER.at("§10.2D"),
                ),
            ));
            sheet.verify(|| {
                let tension = (pull.powi(2) + force.powi(2)).sqrt();
                let what = Text::new(
                    "second derivative for bar {bar} as that of a pendulum, its length times the pull on it",
                );
                sheet.check(what.with("bar", n), bends[row], bar.length * tension);
            });
            across.push(bar.length * angle.sin());
            depth.push(bar.length * angle.cos());
            angles.push(angle);
        }
        for (row, bend) in bends.iter().enumerate() {
            sheet.answer(("curvature", row + 1), "Second derivative of the potential energy for bar", *bend);
        }
        let x = sheet.step(
            "x",
            "m",
            W::Num::sum(across),
            "Distance of the free end from the vertical through the pin",
        );
        let y = sheet.step("y", "m", W::Num::sum(depth), "Depth of the free end below the pin");
        let all = given.bars.iter().map(|bar| bar.weight).chain([given.vertical]);
        let pin = sheet.step(
            "R_y",
            "N",
            W::Num::sum(all.filter(|pull| pull.value() != 0.0).collect::<Vec<_>>()),
            "Upward reaction of the pin: all weights and the vertical force",
        );
        sheet.answer("end_across", "Distance of the free end from the vertical through the pin", x);
        sheet.answer("end_depth", "Depth of the free end below the pin", y);
        sheet.answer("pin_vertical", "Upward reaction of the pin", pin);
        sheet.verify(|| self.check_moments(given, force, &angles, [x, y], sheet));
        let plain: Vec<f64> = angles.iter().map(|angle| angle.value()).collect();
        let (force, weight) = (force.value(), pin.value());
        sheet.verify(|| {
            // A bar whose angle was given is held at that.
            let mut held = plain.clone();
            if let ChainUnknown::Force { bar, angle } = self.sought {
                held[bar as usize - 1] = angle;
            }
            let (mechanism, drawn) = self.built(force, &held);
            let names: Vec<Text> =
                (1..=plain.len()).map(|bar| Text::new("Upper end of bar {bar}").with("bar", bar)).collect();
            if let Some(table) = reactions(&mechanism, &drawn, &names) {
                sheet.show(|| table);
            }
            if let Some(effort) = solved(&mechanism, &drawn) {
                for (row, couple) in effort.newton_euler.iter().enumerate() {
                    sheet.check_zero(
                        "no effort is needed to hold the bar there, from the Newton–Euler equations of every body",
                        W::Num::from(*couple),
                        self.bars[row].length * (force.abs() + weight.abs()),
                    );
                }
                sheet.check_zero(
                    "the upward reaction of the pin from the Newton–Euler equations",
                    W::Num::from(effort.multipliers[1] - weight),
                    force.abs() + weight.abs(),
                );
            }
        });
        sheet.show(|| Exhibit::Table(self.table(&plain)));
        sheet.show(|| Exhibit::Drawing(self.drawing(force, &plain)));
        Ok(())
    }
}

impl HangingChain {
    /// Holds the moments of all weights and forces about the pin to zero, with the places counted from the free end.
    fn check_moments<W: Worksheet>(
        &self,
        given: &HangingChainGiven<W>,
        force: W::Num,
        angles: &[W::Num],
        [x, y]: [W::Num; 2],
        sheet: W,
    ) {
        let mut lower = x;
        let mut moments = vec![given.vertical * x];
        for (bar, angle) in given.bars.iter().zip(angles).rev() {
            let half = bar.length * angle.sin() / 2.0;
            moments.push(bar.weight * (lower - half));
            lower = lower - half * 2.0;
        }
        let length: f64 = self.bars.iter().map(|bar| bar.length).sum();
        let loads = self.vertical.abs() + self.bars.iter().map(|bar| bar.weight).sum::<f64>();
        let what = "moments of the weights and of the forces on the whole chain about its pin";
        let size = length * (force.value().abs() + loads);
        sheet.check_sum(what, force * y, W::Num::sum(moments), size);
    }

    /// The bars from their upper ends, every one held at its angle.
    fn built(&self, force: f64, angles: &[f64]) -> (PlanarMechanism, Vec<[f64; 3]>) {
        let on = |body: usize, s: f64| BodyPoint::body(body, [s, 0.0]);
        let mut joints = Vec::new();
        let mut drivers = Vec::new();
        let mut loads = Vec::new();
        let mut drawn = Vec::new();
        let (mut upper, mut place) = (BodyPoint::ground([0.0; 2]), [0.0, 0.0]);
        for (body, (bar, angle)) in self.bars.iter().zip(angles).enumerate() {
            joints.push(PlanarJoint::Pin { a: upper, b: on(body, 0.0) });
            drivers.push(Driver {
                measure: RelativeCoordinate::Angle { of: Some(body), against: None },
                value: angle - FRAC_PI_2,
                velocity: 0.0,
                acceleration: 0.0,
            });
            loads.push(down(on(body, bar.length / 2.0), bar.weight));
            drawn.push([place[0], place[1], angle - FRAC_PI_2]);
            place = [place[0] + bar.length * angle.sin(), place[1] - bar.length * angle.cos()];
            upper = on(body, bar.length);
        }
        loads.push(PlanarLoad::Force { at: upper, force: [force, -self.vertical], turns_with: None });
        let bodies = vec![PlanarBody::default(); drawn.len()];
        (PlanarMechanism { bodies, joints, drivers, loads, gravity: [0.0; 2] }, drawn)
    }

    fn table(&self, angles: &[f64]) -> TableExhibit {
        let column = |heading: &'static str, unit: &'static str| Column { heading: heading.into(), unit };
        let (mut x, mut y) = (0.0, 0.0);
        let rows = self.bars.iter().zip(angles).enumerate().map(|(row, (bar, angle))| {
            x += bar.length * angle.sin();
            y += bar.length * angle.cos();
            vec![Cell::Text(Text::new("{x}").with("x", row + 1)), (*angle).into(), x.into(), y.into()]
        });
        TableExhibit {
            title: "The bars and their lower ends".into(),
            columns: vec![
                column("Bar", ""),
                column("Angle", "deg"),
                column("Horizontal distance", "m"),
                column("Depth", "m"),
            ],
            rows: rows.collect(),
            foot: Vec::new(),
        }
    }

    fn drawing(&self, force: f64, angles: &[f64]) -> Drawing {
        let size: f64 = self.bars.iter().map(|bar| bar.length).sum();
        let mut points = vec![(0.0, 0.0)];
        for (bar, angle) in self.bars.iter().zip(angles) {
            let (x, y) = points[points.len() - 1];
            points.push((x + bar.length * angle.sin(), y - bar.length * angle.cos()));
        }
        let end = points[points.len() - 1];
        let mut sketch = Sketch::new("The chain in equilibrium");
        sketch
            .ground((0.2 * size, 0.0), (-0.2 * size, 0.0))
            .axis((0.0, 0.0), (0.0, -size))
            .joint("", (0.0, 0.0));
        // Of a long chain the letters would lie over each other.
        let word = |symbol: &str, row: usize| {
            if self.bars.len() > MOST_NAMED { Text::default() } else { Text::verbatim(letter(symbol, row)) }
        };
        for (row, pair) in (1..).zip(points.windows(2)) {
            sketch.link(word("l", row), pair[0], pair[1]);
            let (x, y) = (f64::midpoint(pair[0].0, pair[1].0), f64::midpoint(pair[0].1, pair[1].1));
            sketch.joint("", pair[1]).force(word("W", row), (x, y), (x, y - 0.12 * size));
        }
        if force != 0.0 {
            sketch.force("F", end, (end.0 + 0.25 * size * force.signum(), end.1));
        }
        sketch.finish()
    }
}
