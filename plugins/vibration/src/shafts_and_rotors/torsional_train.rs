//! A torsional train: discs on shafts, geared and branched, vibrating by itself and under harmonic torques.

use std::fmt::Display;

use dalembert_core::{
    About, Analysis, Exhibit, Inputs, Reason, Reference, Refusal, Symbol, Text, Worksheet, register,
};
use dalembert_mechanics::{
    Real, spring as kernel,
    vibration::torsional::{TorsionalMode, TrainError},
};

mod drawing;
mod exhibits;
mod forced;
mod reduced;

use self::reduced::{ReducedTrain, reduce};
use crate::{
    shared::{
        inertia::RotorInertia,
        spring::{Joined, torsional::TorsionalSpring},
    },
    sources::{BEVAN, DEN_HARTOG, RAO},
};

/// Discs, the shafts and gears between them, and what shakes them.
#[derive(Clone, Debug, Inputs)]
pub struct TorsionalTrain {
    /// Discs.
    /// Flywheels, rotors, gears, cranks. All are referred to the speed of the first one.
    #[input(min = 1)]
    pub discs: Vec<Disc>,
    /// Shafts.
    /// Without loops; several may start at one disc.
    #[input(min = 1)]
    pub shafts: Vec<Shaft>,
    /// Gears.
    pub gears: Vec<Gears>,
    /// Trial frequency.
    /// For the Holzer table; if omitted, the first natural frequency is used.
    #[input("ω", "rad/s", positive)]
    pub trial_frequency: Option<f64>,
    /// Harmonic torques.
    pub torques: Option<Torques>,
}

/// A disc.
#[derive(Clone, Debug, Inputs)]
pub struct Disc {
    /// Name.
    pub name: String,
    /// Inertia.
    pub inertia: TrainInertia,
}

/// The inertia of a disc.
#[derive(Clone, Debug, Inputs)]
pub enum TrainInertia {
    /// Of a rotor
    #[input(flatten)]
    Rotor(RotorInertia),
    /// Light: a gear or a joint of shafts without inertia
    Light,
    /// Fixed: a wall in which a shaft is clamped
    Held,
}

impl Disc {
    fn is_held(&self) -> bool {
        matches!(self.inertia, TrainInertia::Held)
    }
}

/// A shaft between two discs.
#[derive(Clone, Debug, Inputs)]
pub struct Shaft {
    /// From.
    #[input(rows = "discs")]
    pub from: Reference,
    /// To.
    #[input(rows = "discs")]
    pub to: Reference,
    /// Stiffness.
    /// A stepped shaft is a series combination of its segments, from the first disc to the second.
    pub stiffness: TorsionalSpring,
}

/// A pair of gears in mesh.
#[derive(Clone, Debug, Inputs)]
pub struct Gears {
    /// Driving gear.
    #[input(rows = "discs")]
    pub driving: Reference,
    /// Driven gear.
    #[input(rows = "discs")]
    pub driven: Reference,
    /// Speed of the driving gear over that of the driven one.
    /// Each shaft line is positive in its own direction of rotation.
    #[input("i", "1", positive)]
    pub ratio: f64,
}

/// Harmonic torques of one frequency, all in phase.
#[derive(Clone, Debug, Inputs)]
pub struct Torques {
    /// Frequency.
    #[input("ω_e", "rad/s", positive)]
    pub frequency: f64,
    /// Torques.
    #[input(min = 1)]
    pub torques: Vec<DiscTorque>,
}

/// A harmonic torque on a disc.
#[derive(Clone, Debug, Inputs)]
pub struct DiscTorque {
    /// Disc.
    #[input(rows = "discs")]
    pub disc: Reference,
    /// Amplitude.
    #[input("T", "N*m")]
    pub amplitude: f64,
}

register!(TorsionalTrain);

/// The most frequencies, nodes and amplitudes that are answers of their own; tables have all.
const MOST_FREQUENCIES: usize = 10;
const MOST_NODES: usize = 8;
const MOST_AMPLITUDES: usize = 12;

impl Analysis for TorsionalTrain {
    const ABOUT: About = About {
        id: "vibration/torsional-train",
        title: "Torsional train",
        topic: "Shafts and rotors",
        summary: "Natural frequencies, shapes and nodes of discs on shafts, geared or branched, the Holzer table, and the motion under harmonic torques.",
        main: &["frequency"],
        keywords: "torsional vibration Holzer rotor gear branched flywheel node crankshaft vibração torcional \
                   engrenagens volante nó eixo discos",
        sources: &[&BEVAN, &DEN_HARTOG, &RAO],
        cases: include_str!("../../cases/torsional_train.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &TorsionalTrainGiven<W>, sheet: W) -> Result<(), Refusal> {
        let reduced = reduce(self, given, sheet)?;
        let all = reduced.train.modes().map_err(|error| refusal(&error))?;
        sheet.keep_going()?;
        let rigid = usize::from(reduced.train.is_free());
        let modes = &all[rigid..];
        if modes.is_empty() {
            return Err(Refusal::because(
                "only one disc has inertia and it is unrestrained: it rotates freely and does not vibrate",
            ));
        }
        if rigid == 1 {
            sheet.numerical(
                "ω₀",
                "rad/s",
                0.0,
                "The train is unrestrained: it can rotate as a rigid body, with zero frequency and no twist",
            );
        }
        let frequencies = natural_frequencies(&reduced, modes, sheet);
        for (n, (frequency, mode)) in frequencies.iter().zip(modes).enumerate() {
            let counted = sheet.step(("fₙ", n + 1), "Hz", *frequency, "The same frequency in Hz");
            sheet.answer(("frequency", n + 1), "Natural frequency", counted);
            sheet.verify(|| verify_mode(&reduced, mode, *frequency, sheet));
        }
        let shapes: Vec<Vec<f64>> = modes.iter().map(|mode| self.actual(&reduced, mode)).collect();
        for (n, shape) in shapes.iter().take(frequencies.len()).enumerate() {
            sheet.answer_list(("mode", n + 1), "Amplitudes of mode", "1", shape);
        }
        if modes.windows(2).any(|pair| pair[1].frequency - pair[0].frequency <= 1e-9 * pair[1].frequency) {
            sheet.warn(|| {
                Text::new("some frequencies are equal: any linear combination of their mode shapes is also a mode shape of that frequency")
            });
        }
        let nodes = self.nodes(&reduced, modes);
        answer_nodes(&nodes, sheet);
        let trial = self.trial_frequency.unwrap_or(modes[0].frequency);
        if let Some(trial) = given.trial_frequency {
            residual(&reduced, trial, sheet);
        }
        if let (Some(torques), Some(torques_given)) = (&self.torques, &given.torques) {
            forced::forced(self, &reduced, &all, torques, torques_given, sheet)?;
        }
        sheet.show(|| Exhibit::Table(exhibits::frequencies(self, rigid == 1, modes, &shapes)));
        sheet.show(|| Exhibit::Table(exhibits::holzer(self, &reduced, trial)));
        if !nodes.is_empty() {
            sheet.show(|| Exhibit::Table(exhibits::nodes(self, &nodes)));
        }
        sheet.show(|| Exhibit::Plot(exhibits::residual(&reduced.train, modes)));
        let layout = drawing::Layout::of(self);
        sheet.show(|| Exhibit::Drawing(layout.drawing(self)));
        for (n, shape) in shapes.iter().take(3).enumerate() {
            sheet.show(|| Exhibit::Animation(layout.animation(self, n + 1, shape)));
        }
        Ok(())
    }
}

/// The natural frequencies that become answers: by their formulas for two and three discs in a free line, by
/// Holzer's method otherwise.
fn natural_frequencies<W: Worksheet>(
    reduced: &ReducedTrain<W::Num>,
    modes: &[TorsionalMode],
    sheet: W,
) -> Vec<W::Num> {
    if let Some(Line { inertias, stiffnesses }) = free_line(reduced, sheet) {
        match (&inertias[..], &stiffnesses[..]) {
            (&[first, second], &[k]) => {
                let natural = (k * (first + second) / (first * second)).sqrt();
                let why = ("Two discs on a shaft rotate in opposite directions", BEVAN.at("ch. 15"));
                let against = |inertia: W::Num| (k / inertia).sqrt();
                sheet.common_error(("ω", 1), "the second disc taken as fixed", || against(first));
                sheet.common_error(("ω", 1), "the first disc taken as fixed", || against(second));
                let together = "both discs taken to rotate together against the shaft";
                sheet.common_error(("ω", 1), together, || against(first + second));
                return vec![sheet.step(("ω", 1), "rad/s", natural, why)];
            }
            (&[first, second, third], &[k, l]) => {
                let linear = sheet.step(
                    "b",
                    "rad^2/s^2",
                    k / first + (k + l) / second + l / third,
                    ("The frequency equation of three discs is ω⁴ − b ω² + c = 0", BEVAN.at("ch. 15")),
                );
                let constant = sheet.step(
                    "c",
                    "rad^4/s^4",
                    k * l * (first + second + third) / (first * second * third),
                    "Its constant term",
                );
                let larger = sheet.step(
                    "λ₂",
                    "rad^2/s^2",
                    (linear + (linear.powi(2) - constant * 4.0).sqrt()) / 2.0,
                    "The larger root in ω²",
                );
                let outer = || {
                    let joined = kernel::series([k, l]);
                    (joined * (first + third) / (first * third)).sqrt()
                };
                sheet.common_error(("ω", 1), "the disc in the middle left out", outer);
                let held = "the disc in the middle taken as fixed";
                sheet.common_error(("ω", 1), held, || (k / first).min(l / third).sqrt());
                sheet.common_error(("ω", 2), held, || (k / first).max(l / third).sqrt());
                let lower = sheet.step(
                    ("ω", 1),
                    "rad/s",
                    (constant / larger).sqrt(),
                    "One node: the product of the roots is c",
                );
                return vec![lower, sheet.step(("ω", 2), "rad/s", larger.sqrt(), "Two nodes")];
            }
            _ => {}
        }
    }
    let why = (
        "By Holzer's method: at this trial frequency the residual torque at the last disc is zero",
        DEN_HARTOG.at("ch. 5"),
    );
    modes
        .iter()
        .take(MOST_FREQUENCIES)
        .enumerate()
        .map(|(n, mode)| {
            let why = if n == 0 { Reason::from(why) } else { Reason::from("Similarly") };
            sheet.numerical(("ω", n + 1), "rad/s", mode.frequency, why)
        })
        .collect()
}

/// Discs in one line and the shafts between them.
struct Line<N> {
    inertias: Vec<N>,
    stiffnesses: Vec<N>,
}

/// The moments of inertia and the stiffnesses between them of a train in one line that nothing holds, with shafts
/// joined that have no inertia between them, if there are two or three discs.
fn free_line<W: Worksheet>(reduced: &ReducedTrain<W::Num>, sheet: W) -> Option<Line<W::Num>> {
    if !reduced.train.is_chain() || !reduced.train.is_free() {
        return None;
    }
    let heavy = reduced.stations.iter().filter(|station| station.inertia.is_some()).count();
    if !(2..=3).contains(&heavy) {
        return None;
    }
    let (mut inertias, mut stiffnesses, mut between) = (Vec::new(), Vec::new(), Vec::new());
    let mut before = None;
    for &station in reduced.train.main_shaft() {
        if let Some(before) = before {
            let joins =
                |ends: [Option<usize>; 2]| ends.contains(&Some(before)) && ends.contains(&Some(station));
            between.push(reduced.links.iter().find(|link| joins(link.ends))?.stiffness);
        }
        before = Some(station);
        let Some(inertia) = reduced.stations[station].inertia else { continue };
        if !inertias.is_empty() {
            let joined = match between[..] {
                [one] => one,
                _ => {
                    let symbol = ("k_e", stiffnesses.len() + 1);
                    let parallel = || kernel::parallel(between.iter().copied());
                    sheet.common_error(symbol, "the shafts taken as springs in parallel", parallel);
                    sheet.step(
                        symbol,
                        "N*m/rad",
                        kernel::series(between.iter().copied()),
                        ("Shafts in series, without inertia between them", RAO.at("§1.7")),
                    )
                }
            };
            stiffnesses.push(joined);
        }
        between.clear();
        inertias.push(inertia);
    }
    Some(Line { inertias, stiffnesses })
}

/// The Holzer residual at the trial frequency.
fn residual<W: Worksheet>(reduced: &ReducedTrain<W::Num>, trial: W::Num, sheet: W) {
    let rows = reduced.train.holzer(trial.value());
    let (Some(last), size) = (rows.last(), rows.iter().map(|row| row.size).sum()) else {
        return;
    };
    let left = sheet.numerical(
        "T_r",
        "N*m",
        last.shaft_torque,
        (
            "Residual torque at the last disc at the trial frequency, with unit rotation (1 rad) of the first disc",
            DEN_HARTOG.at("ch. 5"),
        ),
    );
    let torques: f64 = rows.iter().map(|row| row.inertia_torque).sum();
    sheet.check_zero(
        "the inertia torques of the Holzer table add up to the residual",
        W::Num::from(left.value() - torques),
        size,
    );
    sheet.answer("residual_torque", "Residual torque at the trial frequency", left);
}

impl Shaft {
    fn ends(&self) -> [usize; 2] {
        [self.from.0, self.to.0]
    }
}

/// A node: where a shaft is at rest in a mode.
struct Node {
    mode: usize,
    shaft: usize,
    /// The part of the compliance of the shaft before it.
    share: f64,
    /// From the first end of the shaft, where its lengths are known.
    distance: Option<f64>,
    /// Length and compliance of each uniform part of the shaft, where they are known.
    parts: Vec<(f64, f64)>,
    /// Amplitudes at the ends of the shaft.
    ends: [f64; 2],
}

impl TorsionalTrain {
    /// The amplitudes of the discs as they are, the first one 1, or the largest where the first hardly moves.
    fn actual<N: Real>(&self, reduced: &ReducedTrain<N>, mode: &TorsionalMode) -> Vec<f64> {
        let amplitude = |disc: usize| {
            reduced.station_of[disc].map_or(0.0, |station| mode.shape[station] * reduced.speed(disc))
        };
        let amplitudes: Vec<f64> = (0..self.discs.len()).map(amplitude).collect();
        let largest =
            amplitudes.iter().fold(0.0, |largest: f64, x| if x.abs() > largest.abs() { *x } else { largest });
        let unit = if amplitudes[0].abs() > 1e-6 * largest.abs() { amplitudes[0] } else { largest };
        // What is left of the largest by rounding is zero.
        let clean = |x: f64| if x.abs() < 1e-12 * largest.abs() { 0.0 } else { x / unit };
        amplitudes.into_iter().map(clean).collect()
    }

    fn nodes<N: Real>(&self, reduced: &ReducedTrain<N>, modes: &[TorsionalMode]) -> Vec<Node> {
        let mut nodes = Vec::new();
        for (mode, found) in modes.iter().enumerate() {
            for (shaft, link) in reduced.links.iter().enumerate() {
                let [Some(first), Some(second)] = link.ends else { continue };
                let ends = [found.shape[first], found.shape[second]];
                if ends[0] * ends[1] >= 0.0 || ends.iter().any(|end| end.abs() < 1e-12) {
                    continue;
                }
                let share = ends[0] / (ends[0] - ends[1]);
                let parts =
                    parts(&self.shafts[shaft].stiffness, &link.element.joined, link.element.stiffness);
                let distance = parts.as_deref().map(|parts| along(parts, share));
                let parts = parts.unwrap_or_default();
                nodes.push(Node { mode: mode + 1, shaft, share, distance, parts, ends });
            }
        }
        nodes
    }
}

/// Two more ways to a frequency.
fn verify_mode<W: Worksheet>(
    reduced: &ReducedTrain<W::Num>,
    mode: &TorsionalMode,
    frequency: W::Num,
    sheet: W,
) {
    let at = |end: Option<usize>| end.map_or(0.0, |station| mode.shape[station]);
    let elastic: f64 = reduced
        .links
        .iter()
        .map(|link| link.stiffness.value() * (at(link.ends[0]) - at(link.ends[1])).powi(2))
        .sum();
    let inertia = |station: &reduced::RigidDiscs<W::Num>| station.inertia.map_or(0.0, Real::value);
    let kinetic: f64 =
        reduced.stations.iter().zip(&mode.shape).map(|(station, x)| inertia(station) * x.powi(2)).sum();
    // Twists of stiff shafts are small differences of amplitudes, and a part of the train that is hardly coupled
    // to the others makes the residual steep: both show how many digits they have.
    let twist_error: f64 = reduced
        .links
        .iter()
        .map(|link| {
            let (a, b) = (at(link.ends[0]), at(link.ends[1]));
            2.0 * link.stiffness.value() * (a - b).abs() * (a.abs() + b.abs())
        })
        .sum();
    let square = frequency.value().powi(2);
    sheet.check_residual(
        "elastic energy over kinetic energy of the mode shape is ω²",
        (elastic / kinetic - square).into(),
        square,
        f64::EPSILON * twist_error / kinetic,
    );
    if reduced.stations.len() <= 8 {
        let residual = |by: f64| reduced.train.residual(frequency.value() * (1.0 + by));
        let places = 4.0 * f64::EPSILON;
        sheet.check_residual(
            "the Holzer residual vanishes at the natural frequency",
            residual(0.0).into(),
            1.0,
            (residual(places) - residual(-places)).abs(),
        );
    }
}

/// Length and compliance of each uniform part of a shaft, where it is made of such.
fn parts<N: Real>(shaft: &TorsionalSpring, joined: &Joined<N>, stiffness: N) -> Option<Vec<(f64, f64)>> {
    match (shaft, joined) {
        (TorsionalSpring::Shaft { length, .. }, _) => Some(vec![(*length, 1.0 / stiffness.value())]),
        (TorsionalSpring::Series { members }, Joined::Series(elements)) => {
            let inner = members
                .iter()
                .zip(elements)
                .map(|(shaft, element)| parts(shaft, &element.joined, element.stiffness));
            inner.collect::<Option<Vec<_>>>().map(|parts| parts.concat())
        }
        _ => None,
    }
}

/// The distance at which a share of the compliance is used up.
fn along(parts: &[(f64, f64)], share: f64) -> f64 {
    let mut left = share * parts.iter().map(|(_, compliance)| compliance).sum::<f64>();
    let mut distance = 0.0;
    for &(length, compliance) in parts {
        if left <= compliance {
            return distance + length * left / compliance;
        }
        left -= compliance;
        distance += length;
    }
    distance
}

/// The compliance of a shaft up to a distance from its first end.
fn compliance(parts: &[(f64, f64)], distance: f64) -> f64 {
    let mut left = distance;
    let mut sum = 0.0;
    for &(length, compliance) in parts {
        sum += compliance * (left / length).clamp(0.0, 1.0);
        left -= length;
    }
    sum
}

fn answer_nodes<W: Worksheet>(nodes: &[Node], sheet: W) {
    let (mut of_mode, mut first) = ((0, 0), true);
    for node in nodes.iter().filter(|node| node.mode <= MOST_FREQUENCIES).take(MOST_NODES) {
        of_mode = if of_mode.0 == node.mode { (node.mode, of_mode.1 + 1) } else { (node.mode, 1) };
        let Some(distance) = node.distance else { continue };
        let place = Symbol::from("z").row(node.mode).row(of_mode.1);
        let why = "Node of the shaft, from its first end: the amplitude falls from one end to the other as the \
                   compliance adds up";
        let why = if std::mem::take(&mut first) { why } else { "Similarly" };
        let distance = sheet.numerical(place, "m", distance, why);
        let [first, second] = node.ends;
        let before = compliance(&node.parts, distance.value());
        let after = compliance(&node.parts, f64::INFINITY) - before;
        sheet.check_zero(
            "both sides of the node are twisted by the same torque",
            W::Num::from(first * after + second * before),
            (first.abs() + second.abs()) * (before + after),
        );
        sheet.answer(
            ("node", node.mode, of_mode.1),
            "Node from the first end of its shaft; mode, node",
            distance,
        );
    }
}

/// Message for a refusal of the kernel.
fn refusal(error: &TrainError) -> Refusal {
    Refusal::because(match error {
        TrainError::Massless | TrainError::Empty => {
            "no disc has a moment of inertia: write at least one that has"
        }
        TrainError::TooMany => "there are more than 200 discs: join some of them",
        TrainError::Resonance => {
            "the frequency of the torques equals a natural frequency of the train: without damping the motion grows without bound and there is no steady state"
        }
        TrainError::NotFinite
        | TrainError::Ends { .. }
        | TrainError::Loop { .. }
        | TrainError::Apart { .. } => {
            "the moments of inertia and stiffnesses lead to numbers that cannot be represented: write realistic ones"
        }
    })
}

/// The name of a station: those of its discs.
fn station_name(problem: &TorsionalTrain, discs: &[usize]) -> impl Display {
    discs.iter().map(|disc| problem.discs[*disc].name.as_str()).collect::<Vec<_>>().join(" + ")
}

/// A name as it was typed.
fn verbatim(name: impl Display) -> Text {
    Text::new("{x}").with("x", name)
}
