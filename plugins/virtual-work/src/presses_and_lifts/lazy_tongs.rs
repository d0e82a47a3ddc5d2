//! Lazy tongs pinned to two supports on one line: reactions by letting a support go.

use std::f64::consts::PI;

use dalembert_core::{
    About, Analysis, Axis, Drawing, Exhibit, Ink, Inputs, Plot, Refusal, Series, Sketch, Text, Worksheet,
    register,
};
use dalembert_mechanics::{
    Real,
    planar::{
        BodyPoint, Driver, PlanarBody, PlanarJoint, PlanarLoad as Acting, PlanarMechanism, RelativeCoordinate,
    },
};

use crate::{
    shared::{
        equilibria::{down, solved, spread},
        figure::letter,
    },
    sources::{BEER, HIBBELER, RIUL},
};

/// Squares of crossed bars in a row between the supports A on the left and B on the right.
///
/// Each square has an upper and a lower hinge; neighbouring squares meet where their bars cross on the line AB.
#[derive(Clone, Debug, Inputs)]
pub struct LazyTongs {
    /// Squares.
    #[input(min = 1, max = 12)]
    pub squares: u32,
    /// Side of a square.
    #[input("l", "m", positive)]
    pub side: f64,
    /// Angle of the bars from the line AB.
    #[input("θ", "deg", positive, below = 90)]
    pub angle: f64,
    /// Loads.
    #[input(min = 1)]
    pub loads: Vec<HingeLoad>,
}

/// A vertical load at a hinge.
#[derive(Clone, Debug, Inputs)]
pub struct HingeLoad {
    /// Square, counted from A.
    #[input(min = 1, max = 12)]
    pub square: u32,
    /// Hinge.
    pub hinge: Hinge,
    /// Load, downwards.
    #[input("P", "N")]
    pub force: f64,
}

/// A hinge of a square.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum Hinge {
    /// Upper
    Upper,
    /// Lower
    Lower,
}

register!(LazyTongs);

impl Analysis for LazyTongs {
    const ABOUT: About = About {
        id: "virtual-work/lazy-tongs",
        title: "Lazy tongs",
        topic: "Presses and lifts",
        summary: "Reactions at the two supports of a row of crossed bars under vertical loads, each found by releasing its support.",
        main: &["reaction_a_along", "reaction_b_along", "reaction_a_up", "reaction_b_up"],
        keywords: "pantograph crossed bars support reaction virtual displacement tesoura articulada pantógrafo barras cruzadas \
                   reação de apoio",
        sources: &[&BEER, &HIBBELER, &RIUL],
        cases: include_str!("../../cases/lazy_tongs.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &LazyTongsGiven<W>, sheet: W) -> Result<(), Refusal> {
        if let Some(load) = self.loads.iter().find(|load| load.square > self.squares) {
            let why = Text::new("square {square} does not exist: there are {squares}");
            return Err(Refusal::NoAnswer(why.with("square", load.square).with("squares", self.squares)));
        }
        let (side, angle, squares) = (given.side, given.angle, f64::from(self.squares));
        let rise = sheet.step(
            "y′",
            "m",
            side * angle.cos(),
            "B released along the line: virtual displacement δy/δθ of the upper hinges, from y = l sin θ; the lower ones move down by the same amount",
        );
        let near = sheet.step(
            "x′_B",
            "m",
            side * angle.sin() * (2.0 * squares),
            "Virtual approach of B to A per unit δθ, from x_B = 2 n l cos θ",
        );
        let works: Vec<W::Num> = self
            .loads
            .iter()
            .zip(&given.loads)
            .enumerate()
            .map(|(row, (load, this))| {
                let work = this.force * rise;
                let work = if load.hinge == Hinge::Upper { work } else { -work };
                let growing = || work * f64::from(2 * load.square - 1);
                let words = "the rise of the hinge taken in proportion to its distance from A";
                sheet.common_error(("U", row + 1), words, growing);
                sheet.step(("U", row + 1), "N*m", work, "Virtual work against the load per unit δθ")
            })
            .collect();
        let upper = || W::Num::sum(given.loads.iter().map(|load| load.force)) * rise / near;
        sheet.common_error("X_B", "all hinges taken to rise, including the lower ones", upper);
        let along = sheet.step(
            "X_B",
            "N",
            W::Num::sum(works.iter().copied()) / near,
            (
                "Reaction of B towards A: the total virtual work of reaction and loads is zero",
                RIUL.at("eq. 3"),
            ),
        );
        let span =
            sheet.step("x_B", "m", side * angle.cos() * (2.0 * squares), "Distance between the supports");
        let turned: Vec<W::Num> = self
            .loads
            .iter()
            .zip(&given.loads)
            .enumerate()
            .map(|(row, (load, this))| {
                let place = f64::from(2 * load.square - 1);
                let x = side * angle.cos();
                let end = || this.force * side * angle.cos() * f64::from(2 * load.square);
                sheet.common_error(("V", row + 1), "the load taken to act at the end of its square", end);
                let x = if load.square == 1 { x } else { x * place };
                sheet.step(
                    ("V", row + 1),
                    "N*m",
                    this.force * x,
                    "B released upwards: virtual work against the load when the whole linkage rotates about A by δφ",
                )
            })
            .collect();
        let shared = || W::Num::sum(given.loads.iter().map(|load| load.force)) / 2.0;
        sheet.common_error("Y_B", "the loads shared equally by the two supports", shared);
        let up = sheet.step(
            "Y_B",
            "N",
            W::Num::sum(turned.iter().copied()) / span,
            (
                "Reaction of B upwards: the sum of Y_B x_B δφ and the virtual work of the loads is zero",
                RIUL.at("eq. 3"),
            ),
        );
        let all = given.loads.iter().map(|load| load.force).collect::<Vec<_>>();
        let other = sheet.step(
            "Y_A",
            "N",
            W::Num::sum(all.iter().copied()) - up,
            "Reaction of A upwards: both supports carry all loads",
        );
        let opposite =
            sheet.step("X_A", "N", along, "Reaction of A towards B, equal and opposite to that of B");
        sheet.answer("reaction_b_along", "Reaction of B towards A", along);
        sheet.answer("reaction_b_up", "Reaction of B upwards", up);
        sheet.answer("reaction_a_up", "Reaction of A upwards", other);
        sheet.answer("reaction_a_along", "Reaction of A towards B", opposite);
        sheet.verify(|| {
            let (mechanism, drawn) = self.built();
            if let Some(effort) = solved(&mechanism, &drawn) {
                let size = self.loads.iter().map(|load| load.force.abs()).sum::<f64>();
                sheet.check_sum(
                    "the reaction of B along the line from the Newton–Euler equations of every bar",
                    along,
                    (-effort.newton_euler[0]).into(),
                    size * (1.0 + 1.0 / self.angle.tan()),
                );
                sheet.check_sum(
                    "the reaction of B upwards from the Newton–Euler equations of every bar",
                    up,
                    effort.newton_euler[1].into(),
                    size * (1.0 + 1.0 / self.angle.tan()),
                );
                sheet.check_sum(
                    "the reaction of A upwards from the Newton–Euler equations of both bars that end there",
                    other,
                    (effort.multipliers[1] + effort.multipliers[3]).into(),
                    size * (1.0 + 1.0 / self.angle.tan()),
                );
            }
        });
        if self.angle < 5f64.to_radians() {
            sheet.warn(|| "the tongs are nearly fully extended: the support reactions grow without bound near that position".into());
        }
        let along = along.value();
        sheet.show(|| Exhibit::Plot(self.reaction_over_angle(along)));
        sheet.show(|| Exhibit::Drawing(self.drawing()));
        Ok(())
    }
}

impl LazyTongs {
    /// First the bars from A to the first square, upper and lower, then the pairs of long bars that cross between
    /// squares, falling and rising, then the bars from the last square to B.
    fn built(&self) -> (PlanarMechanism, Vec<[f64; 3]>) {
        let (n, l, angle) = (self.squares as usize, self.side, self.angle);
        let (wide, high) = (l * angle.cos(), l * angle.sin());
        let on = |body: usize, s: f64| BodyPoint::body(body, [s, 0.0]);
        let a = BodyPoint::ground([0.0; 2]);
        let mut drawn = vec![[0.0, 0.0, angle], [0.0, 0.0, -angle]];
        let mut joints = vec![PlanarJoint::Pin { a, b: on(0, 0.0) }, PlanarJoint::Pin { a, b: on(1, 0.0) }];
        // The bar and the place on it that ends at the upper and lower hinge of the square.
        let (mut upper, mut lower) = (on(0, l), on(1, l));
        let mut uppers = vec![upper];
        let mut lowers = vec![lower];
        for square in 1..n {
            let x = (2 * square - 1) as f64 * wide;
            let (falling, rising) = (drawn.len(), drawn.len() + 1);
            drawn.push([x, high, -angle]);
            drawn.push([x, -high, angle]);
            joints.push(PlanarJoint::Pin { a: upper, b: on(falling, 0.0) });
            joints.push(PlanarJoint::Pin { a: lower, b: on(rising, 0.0) });
            joints.push(PlanarJoint::Pin { a: on(falling, l), b: on(rising, l) });
            (upper, lower) = (on(rising, 2.0 * l), on(falling, 2.0 * l));
            uppers.push(upper);
            lowers.push(lower);
        }
        let x = (2 * n - 1) as f64 * wide;
        let (from_above, from_below) = (drawn.len(), drawn.len() + 1);
        drawn.push([x, high, -angle]);
        drawn.push([x, -high, angle]);
        joints.push(PlanarJoint::Pin { a: upper, b: on(from_above, 0.0) });
        joints.push(PlanarJoint::Pin { a: lower, b: on(from_below, 0.0) });
        joints.push(PlanarJoint::Pin { a: on(from_above, l), b: on(from_below, l) });
        let b = on(from_above, l);
        let driver = |direction: [f64; 2], value: f64| Driver {
            measure: RelativeCoordinate::Component { direction, from: a, to: b },
            value,
            velocity: 0.0,
            acceleration: 0.0,
        };
        let loads: Vec<Acting> = self
            .loads
            .iter()
            .map(|load| {
                let at = load.square as usize - 1;
                down(if load.hinge == Hinge::Upper { uppers[at] } else { lowers[at] }, load.force)
            })
            .collect();
        let mechanism = PlanarMechanism {
            bodies: vec![PlanarBody::default(); drawn.len()],
            joints,
            drivers: vec![driver([1.0, 0.0], 2.0 * n as f64 * wide), driver([0.0, 1.0], 0.0)],
            loads,
            gravity: [0.0; 2],
        };
        (mechanism, drawn)
    }

    fn reaction_over_angle(&self, along: f64) -> Plot {
        let at = |angle: f64| (angle, along * self.angle.tan() / angle.tan());
        Plot::new(
            "Reaction along the line against the angle of the bars",
            Axis::linear("angle of the bars", "deg"),
            Axis::linear("reaction towards the other support", "N"),
            vec![
                Series::line("X_B", spread([(0.3 * self.angle).max(0.05), PI / 2.0], 300).map(at).collect())
                    .of("reaction_b_along"),
            ],
        )
        .over("angle")
        .mark("at this angle", (self.angle, along))
    }

    fn drawing(&self) -> Drawing {
        let (l, n) = (self.side, self.squares);
        let (wide, high) = (l * self.angle.cos(), l * self.angle.sin());
        let mut sketch = Sketch::new("The tongs between their supports");
        for square in 0..n {
            let x = f64::from(2 * square) * wide;
            sketch
                .bars([(x, 0.0), (x + wide, high), (x + 2.0 * wide, 0.0), (x + wide, -high), (x, 0.0)])
                .joint("", (x + wide, high))
                .joint("", (x + wide, -high));
            if square > 0 {
                sketch.joint("", (x, 0.0));
            }
        }
        sketch.axis((0.0, 0.0), (2.0 * wide, 0.0)).angle("θ", (0.0, 0.0), 0.0, self.angle).line(
            "l",
            (0.0, 0.0),
            (wide, -high),
            Ink::Body,
        );
        sketch.pin("A", (0.0, 0.0)).pin("B", (f64::from(2 * n) * wide, 0.0));
        for (row, load) in self.loads.iter().enumerate() {
            let x = f64::from(2 * load.square - 1) * wide;
            let y = if load.hinge == Hinge::Upper { high } else { -high };
            let way = -0.7 * l * load.force.signum();
            let tail = if load.hinge == Hinge::Upper { (x, y - way) } else { (x, y) };
            let name = Text::verbatim(letter("P", row + 1));
            sketch.edge(name, tail, (tail.0, tail.1 + way), Ink::Force);
        }
        sketch.finish()
    }
}
