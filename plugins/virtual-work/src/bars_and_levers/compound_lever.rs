//! Levers that drive one another through links: pliers, bolt cutters, chains of levers.

use dalembert_core::{
    About, Analysis, Drawing, Exhibit, Inputs, Refusal, Sketch, TableExhibit, Text, Worksheet,
    exhibit::{Cell, Column},
    register,
};
use dalembert_mechanics::{
    Real,
    planar::{
        BodyPoint, Driver, Effort, PlanarBody, PlanarJoint, PlanarLoad as Acting, PlanarMechanism,
        RelativeCoordinate,
    },
};

use crate::{
    shared::{equilibria::solved, figure::letter},
    sources::{BEER, HIBBELER, RIUL},
};

/// Levers numbered from 1, each driving the next one through a link, and the loads on them.
///
/// Arms are distances from the pivot of their lever, square to the line of the force; an arm and a force are positive
/// so that a positive force on a positive arm turns its lever the positive way. Only the ratios of the virtual turns
/// matter.
#[derive(Clone, Debug, Inputs)]
pub struct CompoundLever {
    /// Links from each lever to the next.
    /// None for a single lever.
    // The second method solves a dense system of three equations for each.
    #[input(most = 200)]
    pub links: Vec<LeverLink>,
    /// Loads.
    #[input(min = 1, most = 200)]
    pub loads: Vec<LeverLoad>,
    /// Find.
    pub sought: LeverUnknown,
}

/// The link from a lever to the next one.
#[derive(Clone, Debug, Inputs)]
pub struct LeverLink {
    /// Arm on the driving lever.
    #[input("b", "m")]
    pub driving: f64,
    /// Arm on the driven lever.
    /// Negative for the opposite sense of rotation.
    #[input("a", "m")]
    pub driven: f64,
}

/// A load on one of the levers.
#[derive(Clone, Debug, Inputs)]
pub struct LeverLoad {
    /// Name.
    pub name: String,
    /// Lever it acts on.
    #[input(min = 1, max = 50)]
    pub lever: u32,
    /// Kind.
    pub kind: LoadKind,
}

/// A force or a couple.
#[derive(Clone, Debug, Inputs)]
pub enum LoadKind {
    /// Force
    Force {
        /// Force.
        #[input("F", "N")]
        force: f64,
        /// Arm.
        #[input("c", "m")]
        arm: f64,
    },
    /// Couple
    Couple {
        /// Couple.
        #[input("M", "N*m")]
        couple: f64,
    },
}

/// Unknown that balances the loads.
#[derive(Clone, Debug, Inputs)]
pub enum LeverUnknown {
    /// Force on a lever
    Force {
        /// Lever it acts on.
        #[input(min = 1, max = 50)]
        lever: u32,
        /// Arm.
        #[input("c_P", "m")]
        arm: f64,
    },
    /// Couple on a lever
    Couple {
        /// Lever it acts on.
        #[input(min = 1, max = 50)]
        lever: u32,
    },
}

register!(CompoundLever);

impl Analysis for CompoundLever {
    const ABOUT: About = About {
        id: "virtual-work/compound-lever",
        title: "Chain of levers",
        topic: "Bars and levers",
        summary: "Force or couple that balances the loads on levers connected in series, from the ratios of their virtual displacements.",
        main: &["force", "couple", "mechanical_advantage"],
        keywords: "pliers bolt cutter compound lever chain mechanical advantage alicate corta-vergalhão tesoura alavancas \
                   compostas vantagem mecânica",
        sources: &[&BEER, &HIBBELER, &RIUL],
        cases: include_str!("../../cases/compound_lever.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &CompoundLeverGiven<W>, sheet: W) -> Result<(), Refusal> {
        let turns = self.turns(given, sheet)?;
        let turn_of = |lever: u32| -> Result<Option<W::Num>, Refusal> {
            let at = lever as usize;
            if at == 1 {
                return Ok(None);
            }
            turns.get(at.wrapping_sub(2)).copied().map(Some).ok_or_else(|| {
                let why = Text::new(
                    "lever {lever} does not exist: with {links} links there are levers 1 to {last}",
                );
                Refusal::NoAnswer(
                    why.with("lever", lever)
                        .with("links", self.links.len())
                        .with("last", self.links.len() + 1),
                )
            })
        };
        let turned = |moment: W::Num, lever: u32| -> Result<W::Num, Refusal> {
            Ok(turn_of(lever)?.map_or(moment, |turn| moment * turn))
        };
        let mut works = Vec::new();
        for (row, (load, this)) in self.loads.iter().zip(&given.loads).enumerate() {
            let moment = match &this.kind {
                LoadKindGiven::Force { force, arm } => *force * *arm,
                LoadKindGiven::Couple { couple } => *couple,
            };
            let words =
                Text::new("Virtual work of {name}, for a unit rotation of lever 1").with("name", &load.name);
            works.push(sheet.step(("U", row + 1), "N*m", turned(moment, load.lever)?, words));
        }
        let size = works.iter().fold(0.0f64, |most, work| most.max(work.value().abs()));
        let total = match works[..] {
            [only] => only,
            _ => sheet.step("ΣU", "N*m", W::Num::sum(works.iter().copied()), "Virtual work of all loads"),
        };
        let moments = || {
            W::Num::sum(given.loads.iter().map(|load| match &load.kind {
                LoadKindGiven::Force { force, arm } => *force * *arm,
                LoadKindGiven::Couple { couple } => *couple,
            }))
        };
        let reason = ("The total virtual work is zero", RIUL.at("eq. 3"));
        let still = || {
            Refusal::because(
                "the sought force has no virtual displacement: its arm or a ratio of the links is zero, so it cannot balance anything",
            )
        };
        let (value, way) = match &given.sought {
            LeverUnknownGiven::Force { arm, .. } => {
                let LeverUnknown::Force { lever, .. } = self.sought else {
                    unreachable!("the sought one is this one")
                };
                let way = sheet.step(
                    "δs",
                    "m",
                    turned(*arm, lever)?,
                    "Virtual displacement of the unknown force, for a unit rotation of lever 1",
                );
                if way.value() == 0.0 {
                    return Err(still());
                }
                if !self.links.is_empty() {
                    sheet.common_error(
                        "P",
                        "all moments balanced as on one lever, without the ratios of the links",
                        || -moments() / *arm,
                    );
                }
                let force = sheet.step("P", "N", -total / way, reason);
                sheet.answer("force", "Equilibrant force", force);
                (force, way)
            }
            LeverUnknownGiven::Couple { .. } => {
                let LeverUnknown::Couple { lever } = self.sought else {
                    unreachable!("the sought one is this one")
                };
                let way = match turn_of(lever)? {
                    Some(turn) => turn,
                    None => W::Num::from(1.0),
                };
                if way.value() == 0.0 {
                    return Err(still());
                }
                let couple = if lever == 1 { -total } else { -total / way };
                if !self.links.is_empty() {
                    sheet.common_error(
                        "M_P",
                        "all moments balanced as on one lever, without the ratios of the links",
                        || -moments(),
                    );
                }
                let couple = sheet.step("M_P", "N*m", couple, reason);
                sheet.answer("couple", "Equilibrant couple", couple);
                (couple, way)
            }
        };
        let mut advantage = None;
        if let (LeverUnknownGiven::Force { .. }, [only]) = (&given.sought, &given.loads[..])
            && let LoadKindGiven::Force { force, .. } = &only.kind
            && force.value() != 0.0
        {
            let ratio =
                sheet.step("r", "1", (value / *force).abs(), "Mechanical advantage: ratio of the two forces");
            sheet.answer("mechanical_advantage", "Mechanical advantage", ratio);
            advantage = Some((ratio, force.value()));
        }
        sheet.verify(|| {
            if let Some(effort) = self.built().and_then(|(mechanism, drawn)| solved(&mechanism, &drawn)) {
                sheet.check_zero(
                    "the balance from the Newton–Euler equations of every lever and link",
                    W::Num::from((effort.newton_euler[0] - value.value()) * way.value()),
                    size,
                );
                if let Some((ratio, force)) = advantage {
                    let by_them = W::Num::from((effort.newton_euler[0] / force).abs());
                    sheet.check("the mechanical advantage from the Newton–Euler equations", ratio, by_them);
                }
            }
        });
        let plain: Vec<f64> = works.iter().map(|work| work.value()).collect();
        let of_sought = -total.value();
        sheet.show(|| Exhibit::Table(self.table(&plain, of_sought)));
        sheet.show(|| Exhibit::Drawing(self.schematic().drawing()));
        Ok(())
    }
}

/// Length of a drawn link over that of the levers.
const SHORT: f64 = 0.35;

impl CompoundLever {
    /// The turns of the levers from the second one on, for a unit turn of the first.
    fn turns<W: Worksheet>(&self, given: &CompoundLeverGiven<W>, sheet: W) -> Result<Vec<W::Num>, Refusal> {
        let mut turns: Vec<W::Num> = Vec::new();
        for (row, link) in given.links.iter().enumerate() {
            if link.driven.value() == 0.0 {
                let why = Text::new("link {link} meets lever {lever} at its pivot: write a non-zero arm");
                return Err(Refusal::NoAnswer(why.with("link", row + 1).with("lever", row + 2)));
            }
            let ratio = link.driving / link.driven;
            let turn = match turns.last() {
                None => ratio,
                Some(before) => *before * ratio,
            };
            if let Some(before) = turns.last() {
                sheet.common_error(("φ", row + 2), "the ratios of the links added, not multiplied", || {
                    *before + ratio
                });
            }
            turns.push(sheet.step(
                ("φ", row + 2),
                "1",
                turn,
                (
                    "Virtual rotation of the lever for a unit rotation of lever 1: both ends of the link have the same displacement, b δφ = a δφ′",
                    BEER.at("§10.1C"),
                ),
            ));
        }
        Ok(turns)
    }

    /// Positions of the pivots with every lever level and every link upright.
    fn pivots(&self) -> Vec<[f64; 2]> {
        let drop = self.size();
        let mut pivots = vec![[0.0, 0.0]];
        for link in &self.links {
            let [x, y] = pivots[pivots.len() - 1];
            pivots.push([x + link.driving - link.driven, y - drop]);
        }
        pivots
    }

    fn size(&self) -> f64 {
        let in_links = self.links.iter().flat_map(|link| [link.driving.abs(), link.driven.abs()]);
        let in_loads = self.loads.iter().map(|load| match load.kind {
            LoadKind::Force { arm, .. } => arm.abs(),
            LoadKind::Couple { .. } => 0.0,
        });
        let sought = match self.sought {
            LeverUnknown::Force { arm, .. } => arm.abs(),
            LeverUnknown::Couple { .. } => 0.0,
        };
        let largest = in_links.chain(in_loads).chain([sought]).fold(0.0, f64::max);
        if largest > 0.0 { largest } else { 1.0 }
    }

    /// Level levers, upright rods, and vertical forces; driven by what is sought.
    fn built(&self) -> Option<(PlanarMechanism, Vec<[f64; 3]>)> {
        let pivots = self.pivots();
        let drop = self.size();
        let on = |lever: usize, arm: f64| BodyPoint::body(lever, [arm, 0.0]);
        let turn = |lever: u32| RelativeCoordinate::Angle { of: Some(lever as usize - 1), against: None };
        let mut joints: Vec<PlanarJoint> = pivots
            .iter()
            .enumerate()
            .map(|(lever, &at)| PlanarJoint::Pin { a: BodyPoint::ground(at), b: on(lever, 0.0) })
            .collect();
        for (lever, link) in self.links.iter().enumerate() {
            joints.push(PlanarJoint::Rod {
                from: on(lever, link.driving),
                to: on(lever + 1, link.driven),
                length: drop,
            });
        }
        let loads = self.loads.iter().map(|load| match load.kind {
            LoadKind::Force { force, arm } => {
                Acting::Force { at: on(load.lever as usize - 1, arm), force: [0.0, force], turns_with: None }
            }
            LoadKind::Couple { couple } => {
                Acting::Effort { measure: turn(load.lever), effort: Effort::Constant(couple) }
            }
        });
        let (measure, value) = match self.sought {
            LeverUnknown::Force { lever, arm } => {
                let pivot = pivots.get(lever as usize - 1)?;
                let to = on(lever as usize - 1, arm);
                let measure = RelativeCoordinate::Component {
                    direction: [0.0, 1.0],
                    from: BodyPoint::ground(*pivot),
                    to,
                };
                (measure, 0.0)
            }
            LeverUnknown::Couple { lever } => (turn(lever), 0.0),
        };
        let mechanism = PlanarMechanism {
            bodies: vec![PlanarBody::default(); pivots.len()],
            joints,
            drivers: vec![Driver { measure, value, velocity: 0.0, acceleration: 0.0 }],
            loads: loads.collect(),
            gravity: [0.0; 2],
        };
        Some((mechanism, pivots.into_iter().map(|[x, y]| [x, y, 0.0]).collect()))
    }

    fn table(&self, works: &[f64], of_sought: f64) -> TableExhibit {
        let row = |name: Text, work: f64| vec![Cell::Text(name), Cell::Number(work)];
        let known = self
            .loads
            .iter()
            .zip(works)
            .map(|(load, &work)| row(Text::new("{x}").with("x", &load.name), work));
        TableExhibit {
            title: "Virtual work for a unit rotation of lever 1".into(),
            columns: vec![
                Column { heading: "Load".into(), unit: "" },
                Column { heading: "Virtual work".into(), unit: "N*m" },
            ],
            rows: known.chain([row("Unknown".into(), of_sought)]).collect(),
            foot: Vec::new(),
        }
    }

    /// The same levers with arms whose squares are in the proportions of theirs: a short arm beside a long one is still seen.
    fn schematic(&self) -> Self {
        let (size, mut it) = (self.size(), self.clone());
        let shown = |arm: &mut f64| *arm = arm.signum() * (size * arm.abs()).sqrt();
        for link in &mut it.links {
            shown(&mut link.driving);
            shown(&mut link.driven);
        }
        for load in &mut it.loads {
            if let LoadKind::Force { arm, .. } = &mut load.kind {
                shown(arm);
            }
        }
        if let LeverUnknown::Force { arm, .. } = &mut it.sought {
            shown(arm);
        }
        it
    }

    fn drawing(&self) -> Drawing {
        let size = self.size();
        // The links are drawn short: any length is as good, and arms are what counts.
        let pivots: Vec<[f64; 2]> = self.pivots().into_iter().map(|[x, y]| [x, SHORT * y]).collect();
        let mut sketch = Sketch::new("The levers, horizontal, with vertical links (not to scale)");
        let place =
            |lever: u32, arm: f64| pivots.get((lever as usize).wrapping_sub(1)).map(|[x, y]| (x + arm, *y));
        for (lever, &[x, y]) in pivots.iter().enumerate() {
            let number = lever + 1;
            let mut arms = vec![0.0];
            arms.extend(self.links.get(lever).map(|link| link.driving));
            arms.extend(
                lever.checked_sub(1).and_then(|before| self.links.get(before)).map(|link| link.driven),
            );
            arms.extend(self.loads.iter().filter(|load| load.lever as usize == number).filter_map(|load| {
                match load.kind {
                    LoadKind::Force { arm, .. } => Some(arm),
                    LoadKind::Couple { .. } => None,
                }
            }));
            if let LeverUnknown::Force { lever, arm } = self.sought
                && lever as usize == number
            {
                arms.push(arm);
            }
            let ends = arms.iter().fold([0.0f64, 0.0f64], |[low, high], arm| [low.min(*arm), high.max(*arm)]);
            sketch.bars([(x + ends[0], y), (x + ends[1], y)]).pin(Text::new("{x}").with("x", number), (x, y));
        }
        for (lever, link) in self.links.iter().enumerate() {
            let ([x, y], [next_x, next_y]) = (pivots[lever], pivots[lever + 1]);
            let (from, to) = ((x + link.driving, y), (next_x + link.driven, next_y));
            let word = |symbol: &str| Text::verbatim(letter(symbol, lever + 1));
            sketch
                .bars([from, to])
                .joint("", from)
                .joint("", to)
                .dimension(word("b"), (x, y), from, 2.0 * link.driving.signum())
                .dimension(word("a"), (next_x, next_y), to, 2.0 * link.driven.signum());
        }
        for (row, load) in (1..).zip(&self.loads) {
            let LoadKind::Force { force, arm } = load.kind else { continue };
            let Some(at) = place(load.lever, arm) else { continue };
            let up = 0.2 * size * force.signum();
            let tail = (at.0, at.1 - up);
            let pivot = (at.0 - arm, at.1);
            let name = format!("{} {}", letter("F", row), load.name);
            sketch
                .dimension(Text::verbatim(letter("c", row)), pivot, at, -2.0 * arm.signum())
                .force("", tail, at)
                .label(Text::verbatim(name.trim_end()), tail);
        }
        if let LeverUnknown::Force { lever, arm } = self.sought
            && let Some(at) = place(lever, arm)
        {
            sketch.dimension("c_P", (at.0 - arm, at.1), at, -2.0 * arm.signum()).force(
                "P",
                at,
                (at.0, at.1 + 0.2 * size),
            );
        }
        sketch.finish()
    }
}
