//! Machines with one degree of freedom under weights, springs and constant forces: all equilibria, and whether they last.

use dalembert_core::{
    Axis, Exhibit, Plot, Refusal, Series, Sketch, TableExhibit, Text, Worksheet,
    exhibit::{Cell, Column},
};
use dalembert_mechanics::planar::{
    BodyPoint, InverseDynamics, Model, PlanarJoint, PlanarLoad, PlanarMechanism,
};
use dalembert_numerics::roots;

use crate::sources::{BEER, HIBBELER};

/// Steps of the scan for equilibria.
const STEPS: usize = 720;
/// The most equilibria that are answered.
const MOST: usize = 12;
/// Relative rounding error of a potential energy or curvature, over its largest value in the range.
const ROUNDING: f64 = 1e-11;

/// An equilibrium.
#[derive(Clone, Copy, Debug)]
pub(crate) struct WorkedEquilibrium {
    pub(crate) at: f64,
    pub(crate) energy: f64,
    pub(crate) curvature: f64,
    pub(crate) stability: Stability,
}

/// Stability of an equilibrium.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Stability {
    /// The potential energy is least: it comes back.
    Stable,
    /// It goes away.
    Unstable,
    /// `V″ = 0`: the second derivative cannot tell.
    Critical,
}

impl Stability {
    pub(crate) fn word(self) -> Text {
        Text::from(match self {
            Stability::Stable => "stable",
            Stability::Unstable => "unstable",
            Stability::Critical => "critical",
        })
    }

    fn answers(self) -> [(&'static str, &'static str); 2] {
        match self {
            Stability::Stable => [
                ("stable_angle", "Stable equilibrium"),
                ("stable_curvature", "Second derivative of the potential energy at the stable equilibrium"),
            ],
            Stability::Unstable => [
                ("unstable_angle", "Unstable equilibrium"),
                (
                    "unstable_curvature",
                    "Second derivative of the potential energy at the unstable equilibrium",
                ),
            ],
            Stability::Critical => [
                ("critical_angle", "Neutral (critical) equilibrium"),
                (
                    "critical_curvature",
                    "Second derivative of the potential energy at the critical equilibrium",
                ),
            ],
        }
    }
}

/// Finds and answers every equilibrium at an angle θ in a range. `terms` and `numbers` both give the potential
/// energy and its first two derivatives, as numbers of the worksheet (for the equilibrium of that number, counted
/// from 1) and as plain ones. With the equilibria come their curvatures.
pub(crate) fn answer_equilibria<W: Worksheet>(
    sheet: W,
    [from, to]: [f64; 2],
    terms: impl Fn(usize, W::Num) -> [W::Num; 3],
    numbers: impl Fn(f64) -> [f64; 3],
) -> Result<(Vec<WorkedEquilibrium>, Vec<W::Num>), Refusal> {
    if from >= to {
        return Err(Refusal::because(
            "the range of angles ends where it begins or before: write the smaller angle first",
        ));
    }
    let scan = (0..=STEPS).map(|n| numbers(from + (to - from) * n as f64 / STEPS as f64));
    let (mut lowest, mut highest, mut slope, mut curvature) =
        (f64::INFINITY, f64::NEG_INFINITY, 0.0f64, 0.0f64);
    for [v, first, second] in scan {
        if ![v, first, second].iter().all(|x| x.is_finite()) {
            return Err(Refusal::because(
                "the potential energy is not finite everywhere in the range of angles: choose a range without the singular position",
            ));
        }
        (lowest, highest) = (lowest.min(v), highest.max(v));
        (slope, curvature) = (slope.max(first.abs()), curvature.max(second.abs()));
    }
    if highest - lowest <= ROUNDING * highest.abs().max(lowest.abs()) {
        return Err(Refusal::because(
            "every position is an equilibrium: the potential energy is the same at all angles, and the equilibrium is neutral",
        ));
    }
    let zeros =
        roots::find_all(|at| numbers(at)[1], [from, to], STEPS, |_| std::ops::ControlFlow::Continue(()));
    let mut zeros = zeros.map_err(|_| Refusal::because("the search for equilibria did not converge"))?;
    // At an end of the range rounding may hide a zero.
    for end in [from, to] {
        let near = |zero: &f64| (zero - end).abs() <= 1e-9 * (to - from);
        if numbers(end)[1].abs() <= ROUNDING * slope && !zeros.iter().any(near) {
            zeros.push(end);
        }
    }
    zeros.sort_by(f64::total_cmp);
    sheet.keep_going()?;
    if zeros.is_empty() {
        let why = Text::new(
            "there is no equilibrium between {from} and {to}: write a wider range of angles, or other loads",
        );
        return Err(Refusal::NoAnswer(why.with_quantity("from", from, "deg").with_quantity("to", to, "deg")));
    }
    if zeros.len() > MOST {
        let why = Text::new("there are {number} equilibria in the range of angles: write a narrower one");
        return Err(Refusal::NoAnswer(why.with("number", zeros.len())));
    }
    let mut counts = [0; 3];
    let (mut list, mut bends) = (Vec::new(), Vec::new());
    for (row, at) in zeros.into_iter().enumerate() {
        let n = row + 1;
        let at = polished(at, &numbers);
        let at = if at.abs() <= 1e-12 * (to - from) { 0.0 } else { at };
        let [energy, _, second] = numbers(at);
        let stability = if second.abs() <= ROUNDING * curvature {
            Stability::Critical
        } else if second > 0.0 {
            Stability::Stable
        } else {
            Stability::Unstable
        };
        let angle = sheet.numerical(
            ("θ", n),
            "deg",
            at,
            (
                "Equilibrium, δV = 0: sign change of δV/δθ in the range, refined by Brent's method",
                HIBBELER.at("§11.6"),
            ),
        );
        let [_, first, bend] = terms(n, angle);
        let first = sheet.step(
            ("V′", n),
            "N*m",
            first,
            ("δV/δθ there: the total virtual work is zero", BEER.at("§10.2C")),
        );
        sheet.check_zero("the derivative of the potential energy is zero in equilibrium", first, slope);
        let words = match stability {
            Stability::Stable => "d²V/dθ² > 0: the potential energy is a minimum, the equilibrium is stable",
            Stability::Unstable => {
                "d²V/dθ² < 0: the potential energy is a maximum, the equilibrium is unstable"
            }
            Stability::Critical => "d²V/dθ² = 0: critical equilibrium, decided by higher derivatives",
        };
        let bend = sheet.step(("V″", n), "N*m/rad", bend, (words, BEER.at("§10.2D")));
        let count = &mut counts[stability as usize];
        *count += 1;
        let [(angle_key, angle_label), (curvature_key, curvature_label)] = stability.answers();
        sheet.answer((angle_key, *count), angle_label, angle);
        sheet.answer((curvature_key, *count), curvature_label, bend);
        list.push(WorkedEquilibrium { at, energy, curvature: second, stability });
        bends.push(bend);
    }
    let shown = list.clone();
    sheet.show(|| Exhibit::Plot(potential(&shown, [from, to], &numbers)));
    sheet.show(|| Exhibit::Table(table(&shown)));
    Ok((list, bends))
}

/// A zero of `V′` to the last digit, by Newton's method.
fn polished(at: f64, numbers: impl Fn(f64) -> [f64; 3]) -> f64 {
    let [_, slope, curvature] = numbers(at);
    let better = at - slope / curvature;
    if better.is_finite() && numbers(better)[1].abs() < slope.abs() { better } else { at }
}

/// Holds the virtual work to the equations of Newton and Euler: at every equilibrium the holding couple is zero.
pub(crate) fn check_held<W: Worksheet>(
    sheet: W,
    list: &[WorkedEquilibrium],
    scale: f64,
    built: impl Fn(f64) -> Option<(PlanarMechanism, Vec<[f64; 3]>)>,
) {
    for equilibrium in list {
        let effort = built(equilibrium.at).and_then(|(mechanism, drawn)| solved(&mechanism, &drawn));
        if let Some(effort) = effort {
            sheet.check_zero(
                "no holding effort is needed there, from the Newton–Euler equations of every body",
                W::Num::from(effort.newton_euler[0]),
                scale,
            );
        }
    }
}

/// Holds the curvature of the potential energy to the growth of the couple that holds the bodies, from their virtual
/// motion and the accelerations that go with it.
pub(crate) fn check_curvature<W: Worksheet>(
    sheet: W,
    curvature: W::Num,
    scale: f64,
    (mechanism, drawn): &(PlanarMechanism, Vec<[f64; 3]>),
) {
    let stiffness = || {
        let system = Model::new(mechanism, drawn).ok()?;
        system.stiffness(&system.assemble(drawn).ok()?).ok()
    };
    if let Some(stiffness) = stiffness() {
        sheet.check_sum(
            "the second derivative of the potential energy as the rate of the virtual power of all loads",
            curvature,
            stiffness[(0, 0)].into(),
            scale,
        );
    }
}

/// The efforts and reactions of a mechanism that is at rest; none where it does not determine them.
pub(crate) fn solved(mechanism: &PlanarMechanism, drawn: &[[f64; 3]]) -> Option<InverseDynamics> {
    let system = Model::new(mechanism, drawn).ok()?;
    let (_, dynamics) = system.kinetostatics(&system.assemble(drawn).ok()?).ok()?;
    Some(dynamics)
}

/// The forces in the joints of a machine that is at rest, each on the second of its parts, by Newton and Euler.
/// Sliding joints are those of the ground.
pub(crate) fn reactions(mechanism: &PlanarMechanism, drawn: &[[f64; 3]], names: &[Text]) -> Option<Exhibit> {
    let effort = solved(mechanism, drawn)?;
    let mut left = effort.multipliers.iter().copied();
    let mut rows = Vec::new();
    for (joint, name) in mechanism.joints.iter().zip(names) {
        let efforts: Vec<f64> = left.by_ref().take(joint.equations().len()).collect();
        let [x, y] = match (joint, &efforts[..]) {
            (PlanarJoint::Pin { .. }, &[x, y]) => [x, y],
            (
                &PlanarJoint::Slot { direction, .. } | &PlanarJoint::Slider { direction, .. },
                &[across, ..],
            ) => [-across * direction.sin(), across * direction.cos()],
            _ => continue,
        };
        let size = x.hypot(y);
        let tidy = |part: f64| Cell::Number(if part.abs() <= 1e-12 * size { 0.0 } else { part });
        rows.push(vec![Cell::Text(name.clone()), tidy(x), tidy(y), Cell::Number(size)]);
    }
    let column = |heading: &'static str, unit: &'static str| Column { heading: heading.into(), unit };
    Some(Exhibit::Table(TableExhibit {
        title: "Forces in the joints".into(),
        columns: vec![
            column("Joint", ""),
            column("Horizontal", "N"),
            column("Vertical", "N"),
            column("Size", "N"),
        ],
        rows,
        foot: Vec::new(),
    }))
}

/// A downward force.
pub(crate) fn down(at: BodyPoint, force: f64) -> PlanarLoad {
    PlanarLoad::Force { at, force: [0.0, -force], turns_with: None }
}

/// Angles of an animation that swings through a range and back, beginning with the present one.
fn swing(present: f64, [from, to]: [f64; 2]) -> Vec<f64> {
    const FRAMES: u32 = 24;
    let (middle, half) = (f64::midpoint(from, to), (to - from) / 2.0);
    let phase = ((present - middle) / half).clamp(-1.0, 1.0).asin();
    (0..FRAMES)
        .map(|n| middle + half * (phase + std::f64::consts::TAU * f64::from(n) / f64::from(FRAMES)).sin())
        .collect()
}

/// A machine that swings through a range of angles and back; `input` is the path of the angle, empty where that is
/// sought.
pub(crate) fn animation(
    title: &'static str,
    (input, present): (&'static str, f64),
    range: [f64; 2],
    frame: impl Fn(f64) -> Sketch,
) -> Exhibit {
    let angles = swing(present, range);
    let frames = angles.iter().copied().map(frame);
    Exhibit::Animation(Sketch::animation(title, frames, 3.0).over(input, angles))
}

/// Evenly spread numbers, both ends included.
pub(crate) fn spread([from, to]: [f64; 2], steps: u32) -> impl Iterator<Item = f64> {
    (0..=steps).map(move |n| from + (to - from) * f64::from(n) / f64::from(steps))
}

/// The angle most worth drawing: the first stable equilibrium that is not the origin, else the first.
pub(crate) fn illustrative_angle(list: &[WorkedEquilibrium]) -> f64 {
    let stable = list.iter().find(|one| one.stability == Stability::Stable && one.at != 0.0);
    stable.or(list.first()).map_or(0.0, |one| one.at)
}

fn potential(list: &[WorkedEquilibrium], range: [f64; 2], numbers: impl Fn(f64) -> [f64; 3]) -> Plot {
    let curve = spread(range, 360).map(|at| (at, numbers(at)[0])).collect();
    let plot = Plot::new(
        "Potential energy and its equilibria",
        Axis::linear("angle", "deg"),
        Axis::linear("potential energy", "J"),
        vec![Series::line("V", curve)],
    );
    list.iter().fold(plot, |plot, one| plot.mark(one.stability.word(), (one.at, one.energy)))
}

fn table(list: &[WorkedEquilibrium]) -> TableExhibit {
    let column = |heading: &'static str, unit: &'static str| Column { heading: heading.into(), unit };
    TableExhibit {
        title: "Equilibria in the range".into(),
        columns: vec![
            column("Angle", "deg"),
            column("Potential energy", "J"),
            column("Second derivative", "N*m/rad"),
            column("Equilibrium", ""),
        ],
        rows: list
            .iter()
            .map(|one| {
                vec![
                    Cell::Number(one.at),
                    Cell::Number(one.energy),
                    Cell::Number(one.curvature),
                    Cell::Text(one.stability.word()),
                ]
            })
            .collect(),
        foot: Vec::new(),
    }
}
