//! Machines with one angle θ whose potential energy is a sum of loads times shapes, `V = Σ c f(θ)`: weights times
//! heights, stiffnesses times half the square of a stretch, forces times distances.

use dalembert_core::{Axis, Exhibit, Inputs, Plot, Refusal, Series, Sketch, Text, Worksheet};
use dalembert_mechanics::{Real, planar::PlanarMechanism};

use crate::{
    shared::equilibria::{
        Stability, WorkedEquilibrium, animation, answer_equilibria, check_curvature, check_held,
        illustrative_angle, reactions, solved, spread,
    },
    sources::{BEER, RIUL},
};

/// Position of the machine.
#[derive(Clone, Debug, Inputs)]
pub enum Position {
    /// All equilibrium positions in a range
    Sought {
        /// Minimum angle.
        #[input("θ_a", "deg", min = -3600, max = 3600)]
        from: f64,
        /// Maximum angle.
        #[input("θ_b", "deg", min = -3600, max = 3600)]
        to: f64,
    },
    /// At a given angle
    /// Leave one load or stiffness blank to solve for it; with none blank, the equilibrant couple is computed.
    Given {
        /// Angle.
        #[input("θ", "deg", min = -3600, max = 3600)]
        angle: f64,
    },
}

/// Position functions of the parts of a machine and their derivatives, in terms of its lengths and its angle.
pub(crate) trait Shapes {
    /// `f`, `f′` and `f″` of every part.
    fn shapes<N: Real>(&self, lengths: &[N], angle: N) -> Vec<[N; 3]>;

    /// The same with what is worth a line of its own written down, for the `n`th position.
    fn written<W: Worksheet>(
        &self,
        lengths: &[W::Num],
        angle: W::Num,
        n: usize,
        sheet: W,
    ) -> Vec<[W::Num; 3]> {
        let _ = (n, sheet);
        self.shapes(lengths, angle)
    }

    /// Declares the common errors in `f′` of the parts.
    fn common_errors<W: Worksheet>(&self, lengths: &[W::Num], angle: W::Num, sheet: W) {
        let _ = (lengths, angle, sheet);
    }
}

/// A load and what is said of it.
pub(crate) struct PotentialTerm<N> {
    /// Name in words.
    pub(crate) name: &'static str,
    /// The load; none where it is sought.
    pub(crate) load: Option<N>,
    /// Symbol, unit and words of `f′`.
    pub(crate) rate: [&'static str; 3],
    /// Symbol and unit of the load.
    pub(crate) symbol: [&'static str; 2],
    /// The key and the label of the answer where it is sought.
    pub(crate) answer: [&'static str; 2],
}

/// A machine: its shapes, its lengths, its loads.
pub(crate) struct SingleDofMachine<'a, S, N> {
    pub(crate) shapes: &'a S,
    pub(crate) lengths: &'a [N],
    pub(crate) parts: &'a [PotentialTerm<N>],
    /// The joints of the mechanism that is built, in their order, as the table of forces names them.
    pub(crate) joints: &'a [&'static str],
}

/// Results: equilibria, or the one position, and all loads.
pub(crate) struct Balanced<N> {
    pub(crate) list: Vec<WorkedEquilibrium>,
    /// The load that was sought.
    pub(crate) load: Option<N>,
    pub(crate) range: [f64; 2],
}

impl<N> Balanced<N> {
    /// The machine as it swings about its position by an angle to each side.
    pub(crate) fn animation(
        &self,
        title: &'static str,
        angle: f64,
        frame: impl Fn(f64) -> Sketch,
    ) -> Exhibit {
        let at = illustrative_angle(&self.list);
        let [from, to] = self.range;
        let range = [from.max(at - angle), to.min(at + angle)];
        animation(title, ("position.given.angle", at), range, frame)
    }
}

/// The weight of a body, written down where it has a mass.
pub(crate) fn weight<W: Worksheet>(mass: W::Num, gravity: W::Num, why: &'static str, sheet: W) -> W::Num {
    if mass.value() == 0.0 { W::Num::from(0.0) } else { sheet.step("W", "N", mass * gravity, why) }
}

impl<S: Shapes, N: Real> SingleDofMachine<'_, S, N> {
    /// Answers the equilibria, or the one load that is left out. `built` is the machine as a mechanism with all loads,
    /// held at an angle by a couple in the sense of θ.
    pub(crate) fn solve<W: Worksheet<Num = N>>(
        &self,
        position: &PositionGiven<W>,
        sheet: W,
        built: impl Fn(&[f64], f64) -> (PlanarMechanism, Vec<[f64; 3]>),
    ) -> Result<Balanced<N>, Refusal> {
        let sought: Vec<usize> = (0..self.parts.len()).filter(|&at| self.parts[at].load.is_none()).collect();
        match position {
            PositionGiven::Sought { from, to } => {
                let Some(loads) = self.parts.iter().map(|part| part.load).collect::<Option<Vec<N>>>() else {
                    return Err(Refusal::because(
                        "a load or stiffness is left blank: write it, 0 if there is none, or write the angle of equilibrium, from which the blank one is found",
                    ));
                };
                self.equilibria(&loads, [from.value(), to.value()], sheet, built)
            }
            PositionGiven::Given { angle } => match sought[..] {
                [] => self.held(*angle, sheet, built),
                [sought] => self.unknown(sought, *angle, sheet, built),
                _ => Err(Refusal::because(
                    "more than one load or stiffness is missing: the angle determines only one of them",
                )),
            },
        }
    }

    fn equilibria<W: Worksheet<Num = N>>(
        &self,
        loads: &[N],
        range: [f64; 2],
        sheet: W,
        built: impl Fn(&[f64], f64) -> (PlanarMechanism, Vec<[f64; 3]>),
    ) -> Result<Balanced<N>, Refusal> {
        let lengths: Vec<f64> = self.lengths.iter().map(|length| length.value()).collect();
        let plain: Vec<f64> = loads.iter().map(|load| load.value()).collect();
        let (list, bends) = answer_equilibria(
            sheet,
            range,
            |n, angle| total(loads, &self.shapes.written(self.lengths, angle, n, sheet)),
            |angle| total(&plain, &self.shapes.shapes(&lengths, angle)),
        )?;
        sheet.verify(|| {
            for (one, bend) in list.iter().zip(&bends) {
                let shapes = self.shapes.shapes(&lengths, one.at);
                let scale = size(&plain, &shapes);
                check_held(sheet, std::slice::from_ref(one), scale, |at| Some(built(&plain, at)));
                check_curvature(sheet, *bend, scale + bent(&plain, &shapes), &built(&plain, one.at));
            }
            self.show_joints(&built(&plain, illustrative_angle(&list)), sheet);
        });
        Ok(Balanced { list, load: None, range })
    }

    /// The shapes, their slopes, and the virtual work of every known load over δθ, `−c f′`.
    fn works<W: Worksheet<Num = N>>(&self, angle: N, sheet: W) -> (Vec<[N; 3]>, Vec<N>, Vec<N>) {
        let shapes = self.shapes.written(self.lengths, angle, 1, sheet);
        self.shapes.common_errors(self.lengths, angle, sheet);
        let rates: Vec<N> = self
            .parts
            .iter()
            .zip(&shapes)
            .map(|(part, shape)| {
                let [symbol, unit, words] = part.rate;
                let idle = part.load.is_some_and(|load| load.value() == 0.0);
                if idle { shape[1] } else { sheet.step(symbol, unit, shape[1], words) }
            })
            .collect();
        let works = self.parts.iter().zip(&rates).enumerate().filter_map(|(n, (part, rate))| {
            let load = part.load?;
            (load.value() != 0.0).then(|| {
                sheet.step(
                    ("U", n + 1),
                    "N*m",
                    -(load * *rate),
                    Text::new("Virtual work per unit δθ: {load}").with_text("load", part.name),
                )
            })
        });
        let works = works.collect();
        (shapes, rates, works)
    }

    fn unknown<W: Worksheet<Num = N>>(
        &self,
        sought: usize,
        angle: N,
        sheet: W,
        built: impl Fn(&[f64], f64) -> (PlanarMechanism, Vec<[f64; 3]>),
    ) -> Result<Balanced<N>, Refusal> {
        let (shapes, rates, works) = self.works(angle, sheet);
        let part = &self.parts[sought];
        let rate = rates[sought];
        let extent = (shapes[sought][0].value().abs() + shapes[sought][2].value().abs()) * 1e-12;
        if rate.value().abs() <= extent {
            let why =
                Text::new("at this angle {load} does no virtual work: equilibrium does not determine it");
            return Err(Refusal::NoAnswer(why.with("load", part.symbol[0])));
        }
        if works.is_empty() {
            return Err(Refusal::because("all known loads are zero: write down a load"));
        }
        let [symbol, unit] = part.symbol;
        let load = sheet.step(
            symbol,
            unit,
            N::sum(works) / rate,
            ("The total virtual work of all loads is zero", RIUL.at("eq. 3")),
        );
        sheet.answer(part.answer[0], part.answer[1], load);
        let loads: Vec<N> = self.parts.iter().map(|part| part.load.unwrap_or(load)).collect();
        let (here, bend) = here(&loads, &shapes, angle, sheet);
        let lengths: Vec<f64> = self.lengths.iter().map(|length| length.value()).collect();
        let plain: Vec<f64> = loads.iter().map(|load| load.value()).collect();
        sheet.verify(|| {
            let shapes = self.shapes.shapes(&lengths, angle.value());
            let scale = size(&plain, &shapes);
            check_held(sheet, std::slice::from_ref(&here), scale, |at| Some(built(&plain, at)));
            let machine = built(&plain, angle.value());
            check_curvature(sheet, bend, scale + bent(&plain, &shapes), &machine);
            self.show_joints(&machine, sheet);
        });
        let range = around(angle.value());
        sheet.show(|| Exhibit::Plot(self.load_over_angle(sought, &plain, &lengths, angle.value(), range)));
        Ok(Balanced { list: vec![here], load: Some(load), range })
    }

    fn held<W: Worksheet<Num = N>>(
        &self,
        angle: N,
        sheet: W,
        built: impl Fn(&[f64], f64) -> (PlanarMechanism, Vec<[f64; 3]>),
    ) -> Result<Balanced<N>, Refusal> {
        let (shapes, _, works) = self.works(angle, sheet);
        if works.is_empty() {
            return Err(Refusal::because("all known loads are zero: write down a load"));
        }
        let couple = sheet.step(
            "T",
            "N*m",
            -N::sum(works),
            (
                "Equilibrant couple on the bar, in the sense of θ: T δθ plus the virtual work of all loads is zero",
                RIUL.at("eq. 3"),
            ),
        );
        sheet.answer("holding_couple", "Equilibrant couple of the machine", couple);
        let loads: Vec<N> = self.parts.iter().filter_map(|part| part.load).collect();
        let (here, bend) = here(&loads, &shapes, angle, sheet);
        let lengths: Vec<f64> = self.lengths.iter().map(|length| length.value()).collect();
        let plain: Vec<f64> = loads.iter().map(|load| load.value()).collect();
        sheet.verify(|| {
            let machine = built(&plain, angle.value());
            self.show_joints(&machine, sheet);
            let shapes = self.shapes.shapes(&lengths, angle.value());
            let scale = size(&plain, &shapes);
            check_curvature(sheet, bend, scale + bent(&plain, &shapes), &machine);
            if let Some(effort) = solved(&machine.0, &machine.1) {
                sheet.check_sum(
                    "the holding couple from the Newton–Euler equations of every body",
                    couple,
                    effort.newton_euler[0].into(),
                    scale,
                );
            }
        });
        Ok(Balanced { list: vec![here], load: None, range: around(angle.value()) })
    }

    fn show_joints<W: Worksheet>(&self, (mechanism, drawn): &(PlanarMechanism, Vec<[f64; 3]>), sheet: W) {
        let names: Vec<Text> = self.joints.iter().map(|name| Text::from(*name)).collect();
        if let Some(table) = reactions(mechanism, drawn, &names) {
            sheet.show(|| table);
        }
    }

    fn load_over_angle(
        &self,
        sought: usize,
        loads: &[f64],
        lengths: &[f64],
        at: f64,
        range: [f64; 2],
    ) -> Plot {
        let part = &self.parts[sought];
        let most = 6.0 * loads[sought].abs();
        let load = |angle: f64| {
            let shapes = self.shapes.shapes(lengths, angle);
            let others: f64 =
                (0..loads.len()).filter(|&n| n != sought).map(|n| loads[n] * shapes[n][1]).sum();
            let load = -others / shapes[sought][1];
            (angle, if load.abs() <= most { load } else { f64::INFINITY })
        };
        Plot::new(
            "Equilibrium load against the angle",
            Axis::linear("angle", "deg"),
            Axis::linear(part.answer[1], part.symbol[1]),
            vec![Series::line(part.symbol[0], spread(range, 300).map(load).collect()).of(part.answer[0])],
        )
        .over("position.given.angle")
        .mark("at this angle", (at, loads[sought]))
    }
}

/// This position, with its curvature answered.
fn here<W: Worksheet>(
    loads: &[W::Num],
    shapes: &[[W::Num; 3]],
    angle: W::Num,
    sheet: W,
) -> (WorkedEquilibrium, W::Num) {
    let [energy, _, bend] = total(loads, shapes);
    let words =
        ("Second derivative of the potential energy: positive at a stable equilibrium", BEER.at("§10.2D"));
    let bend = sheet.step("V″", "N*m/rad", bend, words);
    sheet.answer("curvature", "Second derivative of the potential energy", bend);
    let here = WorkedEquilibrium {
        at: angle.value(),
        energy: energy.value(),
        curvature: bend.value(),
        stability: if bend.value() > 0.0 { Stability::Stable } else { Stability::Unstable },
    };
    (here, bend)
}

/// `V`, `V′` and `V″`. Loads of zero are left out.
fn total<N: Real>(loads: &[N], shapes: &[[N; 3]]) -> [N; 3] {
    [0, 1, 2].map(|order| {
        let terms = loads.iter().zip(shapes).filter(|(load, _)| load.value() != 0.0);
        N::sum(terms.map(|(load, shape)| *load * shape[order]))
    })
}

/// The size of the virtual works.
fn size(loads: &[f64], shapes: &[[f64; 3]]) -> f64 {
    loads.iter().zip(shapes).map(|(load, shape)| (load * (shape[0].abs() + shape[1].abs())).abs()).sum()
}

/// The size of what the curvature is added up from.
fn bent(loads: &[f64], shapes: &[[f64; 3]]) -> f64 {
    loads.iter().zip(shapes).map(|(load, shape)| (load * shape[2]).abs()).sum()
}

/// A range about an angle, within the quadrant that it stands in.
fn around(at: f64) -> [f64; 2] {
    let quarter = std::f64::consts::FRAC_PI_2;
    let from = (at / quarter).floor() * quarter;
    [from + 0.02, from + quarter - 0.02]
}

/// Half the square of a stretch, and its first two derivatives, from the measure and its derivatives.
pub(crate) fn spring<N: Real>([x, x1, x2]: [N; 3], free: N) -> [N; 3] {
    let stretch = x - free;
    [stretch.powi(2) / 2.0, stretch * x1, x1.powi(2) + stretch * x2]
}

/// Declares the common error in `u′` of a spring measured by a reach times the sine of the angle.
pub(crate) fn sine_error<W: Worksheet>([reach, free, angle]: [W::Num; 3], sheet: W) {
    sheet.common_error(
        "u′",
        "the sine of the change of angle used in place of the change of the sine",
        || reach.powi(2) * (angle - free).sin() * angle.cos(),
    );
}
