//! Path independence: a plot and the answers do not contradict each other.

use std::{
    cell::RefCell,
    collections::{BTreeMap, BTreeSet},
    rc::Rc,
};

use dalembert_core::{
    Animation, AnswerValue, DrawnShape, Entry, Exhibit, Ink, Number, Over, Plot, Record, Scale, Series,
    Solution, Stop, vary,
};
use itertools::Itertools as _;

use crate::{problems::cases_of, some};

/// The points of a curve, and the frames of an animation, that are solved for.
const ABSCISSAS: usize = 14;
/// Of these the most that a direct solve may refuse: dead centres, the moment zero, the end of a range.
const REFUSED: usize = 2;
/// Error of an abscissa that was found as a root, of itself.
const FOUND: f64 = 1e-13;
/// The largest difference, relative to the largest ordinate of the curve.
const AGREEMENT: f64 = 1e-9;
/// The largest distance of the two edges of a spring, relative to the largest coordinate of a drawing.
const EDGES: f64 = 0.2;
/// A path no longer than this, in SI, is the rounding of a point at rest.
const STILL: f64 = 1e-9;
/// The largest ordinate of a curve that counts, over its median.
const PEAK: f64 = 1e3;
/// So much a curve is put off, to see that it is noticed.
const OFF: f64 = 1e-6;

/// Curves that cannot be compared, and plots that are compared with fewer digits, each with its reason.
#[derive(Clone, Copy, Debug, Default)]
pub struct Exceptions<'a> {
    /// Curves that have no input to be solved with, a line each: `analysis | title | curve | reason`, by the English
    /// sentences; `*` is any curve. A reason that begins with `sometimes` is that of problems that do not ask for the
    /// input, beside others that do.
    pub listed: &'a str,
    /// Plots whose points are computed in another way than the answers, with fewer digits.
    pub looser: &'a [Looser],
}

/// A plot that is compared with fewer digits.
#[derive(Clone, Copy, Debug)]
pub struct Looser {
    /// Id of the analysis.
    pub id: &'static str,
    /// English title of the plot.
    pub title: &'static str,
    /// The largest difference, relative to the largest ordinate of the curve.
    pub agreement: f64,
    /// The reason.
    pub reason: &'static str,
}

/// Analysis, title and curve.
type Key = (String, String, String);

/// Plots and animations by what they are over.
#[derive(Default)]
struct Met {
    named: BTreeSet<Key>,
    /// Of those that name an input, the ones that were compared with direct solves, and would not have been if they
    /// were off.
    held: BTreeSet<Key>,
    unnamed: BTreeSet<Key>,
    wrong: Vec<String>,
    /// The points and frames that were solved for.
    points: usize,
}

/// Paths of inputs and values in SI.
type Changes = Vec<(String, f64)>;

/// The answers of a solution that are numbers, by their names, with what of them is rounding alone: of a vector its
/// size and its components, `force.x`.
type Answers = BTreeMap<String, [f64; 2]>;

fn answers(solution: &Solution) -> Answers {
    let mut found = BTreeMap::new();
    for answer in &solution.answers {
        let name = answer.name.to_string();
        match answer.value {
            AnswerValue::Number(Number::Scalar(si), _) => {
                found.insert(name, [si, answer.noise]);
            }
            AnswerValue::Number(Number::Vector(si), _) => {
                for (axis, si) in ["x", "y", "z"].into_iter().zip_eq(si) {
                    found.insert(format!("{name}.{axis}"), [si, answer.noise]);
                }
                let size = si.iter().map(|x| x * x).sum::<f64>().sqrt();
                found.insert(name, [size, answer.noise]);
            }
            _ => {}
        }
    }
    found
}

/// Evenly spread over so many.
fn spread(count: usize, times: usize) -> impl Iterator<Item = usize> {
    let picked = count.min(ABSCISSAS * times);
    (0..picked).map(move |n| if picked == 1 { 0 } else { n * (count - 1) / (picked - 1) })
}

struct Problem<'a> {
    entry: &'a Entry,
    looser: &'a [Looser],
    times: usize,
    title: String,
    record: &'a Record,
    /// The answers of direct solves, `None` of refused ones: the curves of a problem ask for the same ones.
    solved: RefCell<BTreeMap<String, Option<Rc<Answers>>>>,
}

impl Problem<'_> {
    fn key(&self, title: &str, curve: &str) -> Key {
        (self.entry.about.id.to_owned(), title.to_owned(), curve.to_owned())
    }

    /// The answers with some inputs changed; `None` where the problem is refused, or an input is outside of its limits.
    fn solve(&self, changes: &Changes) -> Option<Rc<Answers>> {
        let direct = || {
            let change = |record: Record, (input, si): &(String, f64)| vary::changed(&record, input, *si);
            let record = changes.iter().try_fold(self.record.clone(), change).expect("the inputs are there");
            let inputs = vary::inputs(&record);
            if changes
                .iter()
                .any(|(path, si)| inputs.iter().any(|input| input.path == *path && !input.permits(*si)))
            {
                return None;
            }
            self.entry.solve(&record, &Stop::new()).ok().map(|solution| Rc::new(answers(&solution)))
        };
        self.solved.borrow_mut().entry(format!("{changes:?}")).or_insert_with(direct).clone()
    }

    /// The value of the input at which an answer is `x`; the one is nearly proportional to the other.
    fn input_at(&self, with: &Changes, input: &str, name: &str, x: f64) -> Option<f64> {
        let at = |si: f64| self.solve(&changed(with, input, si))?.get(name).map(|found| found[0]);
        let now = vary::inputs(self.record).into_iter().find(|known| known.path == input);
        let now = now.map_or(1.0, |known| known.si);
        let mut low = (now, at(now)?);
        let guess = if low.1 == 0.0 { now + x } else { now * x / low.1 };
        let mut high = (guess, at(guess)?);
        for _ in 0..30 {
            if (high.1 - x).abs() <= 1e-13 * x.abs() || high.1 == low.1 {
                break;
            }
            let next = high.0 + (x - high.1) * (high.0 - low.0) / (high.1 - low.1);
            low = std::mem::replace(&mut high, (next, at(next)?));
        }
        ((high.1 - x).abs() <= 1e-11 * x.abs().max(low.1.abs())).then_some(high.0)
    }

    fn plot(&self, plot: &Plot, met: &mut Met) {
        for (n, series) in plot.series.iter().enumerate() {
            let key = self.key(&plot.title.template, &series.label.template);
            if plot.over.is_none() || series.of.is_none() {
                met.unnamed.insert(key);
                continue;
            }
            met.named.insert(key.clone());
            let name =
                format!("{} ({}): {}, {}", key.0, self.title, plot.title.english(), series.label.english());
            let held = self.curve(plot, series);
            met.wrong.extend(held.as_ref().err().map(|why| format!("{name}: {why}")));
            let mut off = plot.clone();
            off.series[n].points.iter_mut().for_each(|(_, y)| *y *= 1.0 + OFF);
            // Of rounding alone nothing is noticed.
            met.points += held.as_ref().copied().unwrap_or_default();
            if held.is_ok_and(|points| points > 0) && self.curve(&off, &off.series[n]).is_err() {
                met.held.insert(key);
            }
        }
    }

    /// At how many points a curve is what a direct solve gives, or what is wrong with it.
    fn curve(&self, plot: &Plot, series: &Series) -> Result<usize, String> {
        let (Some(over), Some(of)) = (&plot.over, series.of.as_deref()) else { return Ok(0) };
        let reported = |n: usize| series.at.get(n).copied();
        let drawn = series.points.iter().enumerate().map(|(n, (x, y))| (*x, *y, reported(n)));
        let drawn: Vec<(f64, f64, Option<f64>)> =
            drawn.filter(|(x, y, _)| x.is_finite() && y.is_finite()).collect();
        let mut size = drawn.iter().fold(0.0, |size: f64, (_, y, _)| size.max(y.abs()));
        // Beside a resonance the rest of a curve is seen too.
        let mut sizes: Vec<f64> = drawn.iter().map(|(_, y, _)| y.abs()).collect();
        sizes.sort_by(f64::total_cmp);
        let median = sizes.get(sizes.len() / 2).copied().unwrap_or(0.0);
        if median > 0.0 {
            size = size.min(PEAK * median);
        }
        let width = drawn.iter().fold(0.0, |size: f64, (x, ..)| size.max(x.abs()));
        // A component is as exact as its vector.
        if let Some((vector, _)) = of.rsplit_once('.') {
            let of_it = |series: &&Series| series.of.as_deref().is_some_and(|of| of.starts_with(vector));
            let all = plot.series.iter().filter(of_it).flat_map(|series| &series.points);
            size = all.map(|(_, y)| y.abs()).filter(|y| y.is_finite()).fold(size, f64::max);
        }
        // A path is as large as it is long or high.
        if !series.at.is_empty() && plot.x.unit == plot.y.unit {
            size = size.max(width);
        }
        let of_this = |looser: &&Looser| {
            (looser.id, looser.title) == (self.entry.about.id, plot.title.template.as_ref())
        };
        let agreement = self.looser.iter().find(of_this).map_or(AGREEMENT, |looser| looser.agreement);
        let (mut refused, count) = (0, spread(drawn.len(), self.times).count());
        for (x, y, reported) in spread(drawn.len(), self.times).map(|n| drawn[n]) {
            let input = match &over.answer {
                None => Some(x),
                Some(_) if reported.is_some() => reported,
                Some(name) => self.input_at(&series.with, &over.input, name, x),
            };
            let direct = input.and_then(|input| self.direct(&series.with, over, input, (of, y)));
            let (Some(input), Some(direct)) = (input, direct) else {
                refused += 1;
                continue;
            };
            let [[at, around], [found, noise]] = direct;
            if reported.is_some() && (at - x).abs() > AGREEMENT * width.max(size).max(STILL) + around {
                return Err(format!(
                    "{x:e} at {} = {input:e}, where {:?} is {at:e}",
                    over.input, over.answer
                ));
            }
            // On a logarithmic axis every digit of a small ordinate is seen.
            let size = if plot.y.scale == Scale::Log { y.abs() } else { size };
            let off = (found - y).abs();
            let limit = agreement * size.max(if reported.is_some() { STILL } else { 0.0 }) + noise;
            // On a steep flank what a root that was found may be off by moves the answer.
            let moved = || {
                let beside = [1.0, -1.0].map(|way| input * (1.0 + way * FOUND));
                let beside = beside.map(|input| self.direct(&series.with, over, input, (of, y)));
                beside
                    .into_iter()
                    .flatten()
                    .fold(0.0f64, |most, [_, [other, _]]| most.max((other - found).abs()))
            };
            if off.is_nan() || off > limit && off > limit + moved() {
                let share = off / size;
                return Err(format!(
                    "{y:e} at {} = {input:e}, where {of} is {found:e}: {share:.1e}",
                    over.input
                ));
            }
        }
        // Of few points one may be refused; for comparison there may be curves of what cannot be at all.
        let most = (REFUSED * count / ABSCISSAS).max(1);
        let cannot_be = refused == count && !series.with.is_empty();
        if refused <= most || cannot_be {
            Ok(count - refused)
        } else {
            Err(format!("{refused} of {count} points are where a direct solve is refused"))
        }
    }

    /// Abscissa and ordinate by a direct solve with their rounding, NaN where an answer is missing. A curve may be
    /// drawn the other way round, of the input itself, or through all the answers of a name: the several amplitudes
    /// of one frequency.
    fn direct(
        &self,
        with: &Changes,
        over: &Over,
        input: f64,
        (of, drawn): (&str, f64),
    ) -> Option<[[f64; 2]; 2]> {
        let answers = self.solve(&changed(with, &over.input, input))?;
        let of_name = |name: &str| {
            if name == over.input { Some([input, 0.0]) } else { answers.get(name).copied() }
        };
        let ordinate = if let Some(name) = of.strip_suffix("[*]") {
            let is_row = |of: &str| of.strip_prefix(name).is_some_and(|rest| rest.starts_with('['));
            let rows = answers.iter().filter(|(of, _)| is_row(of)).map(|(_, found)| *found);
            rows.min_by(|a, b| (a[0] - drawn).abs().total_cmp(&(b[0] - drawn).abs()))
        } else if let Some(of) = of.strip_prefix('|').and_then(|of| of.strip_suffix('|')) {
            of_name(of).map(|[si, noise]| [si.abs(), noise])
        } else {
            of_name(of)
        };
        let abscissa = of_name(over.answer.as_deref().unwrap_or(&over.input));
        Some([abscissa, ordinate].map(|found| found.unwrap_or([f64::NAN; 2])))
    }

    fn animation(&self, animation: &Animation, met: &mut Met) {
        let key = self.key(&animation.title.template, "animation");
        let Some((input, values)) = &animation.over else {
            met.unnamed.insert(key);
            return;
        };
        met.named.insert(key);
        assert_eq!(
            values.len(),
            animation.frames.len(),
            "{}: {}",
            self.entry.about.id,
            animation.title.english()
        );
        for n in spread(values.len(), self.times) {
            let changed = vary::changed(self.record, input, values[n]).expect("the path is that of an input");
            let solution = self.entry.solve(&changed, &Stop::new());
            let direct =
                solution.iter().flat_map(|solution| &solution.exhibits).find_map(|other| match other {
                    Exhibit::Animation(other) if other.title.template == animation.title.template => {
                        other.frames.first()
                    }
                    _ => None,
                });
            let wrong = match direct {
                None => Some("has no animation".to_owned()),
                Some(direct) => differ(&animation.frames[n], direct),
            };
            if let Some(why) = wrong {
                let at = format!("frame {n}, {input} = {:e}", values[n]);
                met.wrong.push(format!(
                    "{} ({}): {}: {at}: {why}",
                    self.entry.about.id,
                    self.title,
                    animation.title.english()
                ));
                return;
            }
            met.points += 1;
            met.held.insert(self.key(&animation.title.template, "animation"));
        }
    }
}

/// Changes with one more.
fn changed(with: &Changes, input: &str, si: f64) -> Changes {
    with.iter().cloned().chain([(input.to_owned(), si)]).collect()
}

/// The numbers of a shape, and what it is.
fn numbers(shape: &DrawnShape) -> (&'static str, Vec<f64>) {
    let two = |a: &(f64, f64), b: &(f64, f64)| vec![a.0, a.1, b.0, b.1];
    match shape {
        DrawnShape::Polyline(points, _) => ("line", points.iter().flat_map(|&(x, y)| [x, y]).collect()),
        DrawnShape::Circle(at, radius, _) => ("circle", vec![at.0, at.1, *radius]),
        DrawnShape::Arc(at, radius, from, to, _) => ("arc", vec![at.0, at.1, *radius, *from, *to]),
        DrawnShape::Block(a, b, _) => ("block", two(a, b)),
        DrawnShape::Body(corners, _) => ("body", corners.iter().flat_map(|&(x, y)| [x, y]).collect()),
        DrawnShape::Disc(at, radius, _) => ("disc", vec![at.0, at.1, *radius]),
        DrawnShape::Pin(at) => ("pin", vec![at.0, at.1]),
        DrawnShape::HungPin(at) => ("hung pin", vec![at.0, at.1]),
        DrawnShape::Ground(a, b) => ("ground", two(a, b)),
        DrawnShape::Spring(a, b, _) => ("spring", two(a, b)),
        DrawnShape::Damper(a, b) => ("damper", two(a, b)),
        DrawnShape::Arrow(a, b, _) => ("arrow", two(a, b)),
        DrawnShape::Measure(a, b) => ("measure", two(a, b)),
        DrawnShape::Label(at, ..) => ("label", vec![at.0, at.1]),
        DrawnShape::Extent(a, b) => ("extent", two(a, b)),
    }
}

/// The first difference of two sketches.
fn differ(one: &[DrawnShape], other: &[DrawnShape]) -> Option<String> {
    if one.len() != other.len() {
        return Some(format!("{} shapes for {}", one.len(), other.len()));
    }
    // Paths, lines of the ground and the window are drawn for the whole range.
    let still = |shape: &&DrawnShape| {
        matches!(
            shape,
            DrawnShape::Polyline(_, Ink::Faint | Ink::Motion)
                | DrawnShape::Ground(..)
                | DrawnShape::Extent(..)
        )
    };
    let moving =
        |all: &[DrawnShape]| all.iter().filter(|shape| !still(shape)).map(numbers).collect::<Vec<_>>();
    let [one, other] = [one, other].map(moving);
    if one.len() != other.len() {
        return Some(format!("{} shapes that move for {}", one.len(), other.len()));
    }
    let size = other.iter().flat_map(|(_, at)| at).fold(0.0, |size: f64, x| size.max(x.abs()));
    one.iter().zip_eq(&other).find_map(|((what, a), (as_what, b))| {
        // All frames together choose the side of a name, and a spring has its name at the edge of that side.
        let apart = if *what == "label" { EDGES } else { AGREEMENT };
        let same = what == as_what
            && a.len() == b.len()
            && a.iter().zip_eq(b).all(|(a, b)| (a - b).abs() <= apart * size);
        (!same).then(|| format!("{what} {a:?} for {as_what} {b:?}"))
    })
}

/// Solves at the points of every plot and at the frames of every animation: a curve that is over an input, and an
/// animation, are at each of these points what a direct solve with that input gives. What names no input must be
/// listed among the exceptions, and a list without use is a fault too. `chosen` leaves cases out, by the analysis and
/// the place of the case; `times` many times as many points are solved for. Returns the number of curves and
/// animations that name their input.
pub fn every_curve_over_an_input_is_what_a_direct_solve_gives(
    entries: &[&'static Entry],
    exceptions: &Exceptions<'_>,
    chosen: impl Fn(&str, usize) -> bool,
    times: usize,
) -> usize {
    some(entries);
    let mut met = Met::default();
    for entry in entries {
        for (n, case) in cases_of(entry).into_iter().enumerate() {
            if !chosen(entry.about.id, n) {
                continue;
            }
            let Ok(record) = case.record(entry) else { continue };
            let Ok(solution) = entry.solve(&record, &Stop::new()) else { continue };
            // Plots are of the problem with its unknowns found.
            let found = solution.determined.as_deref().map(|determined| determined.record.clone());
            let record = found.unwrap_or(record);
            let title = case.title().english();
            let looser = exceptions.looser;
            let problem =
                Problem { entry, looser, times, title, record: &record, solved: RefCell::default() };
            for exhibit in &solution.exhibits {
                match exhibit {
                    Exhibit::Plot(plot) => problem.plot(plot, &mut met),
                    Exhibit::Animation(animation) => problem.animation(animation, &mut met),
                    Exhibit::Scene(scene) if scene.frames.len() > 1 => {
                        met.unnamed.insert(problem.key(&scene.title.template, "animation"));
                    }
                    Exhibit::Scene(_) | Exhibit::Table(_) | Exhibit::Drawing(_) => {}
                }
            }
        }
    }
    println!("{} curves and animations held at {} points", met.named.len(), met.points);
    let wrong = [met.wrong.clone(), unlisted(&met, exceptions.listed, entries)].concat();
    assert!(wrong.is_empty(), "{} wrong:\n{}", wrong.len(), wrong.join("\n"));
    met.named.len()
}

/// Curves that are neither named nor listed, or both.
fn unlisted(met: &Met, list: &str, entries: &[&'static Entry]) -> Vec<String> {
    let mut listed: BTreeMap<Key, &str> = BTreeMap::new();
    let of_these =
        |line: &&str| entries.iter().any(|entry| line.starts_with(&format!("{}/", entry.family())));
    for line in list.lines().filter(of_these) {
        let parts: Vec<&str> = line.split(" | ").collect();
        let [id, title, curve, reason] = parts[..] else {
            panic!("`{line}` is not `analysis | title | curve | reason`");
        };
        assert!(reason.len() > 10, "`{line}` has no reason");
        let key = (id.to_owned(), title.to_owned(), curve.to_owned());
        assert!(listed.insert(key, reason).is_none(), "`{line}` stands there twice");
    }
    let of = |key: &Key| {
        let any = (key.0.clone(), key.1.clone(), "*".to_owned());
        [key.clone(), any].into_iter().find(|key| listed.contains_key(key))
    };
    let missing = met.unnamed.iter().filter(|key| of(key).is_none());
    let missing = missing.map(|key| (key, "names no input and answer, and is not listed"));
    let used: BTreeSet<Key> = met.unnamed.iter().filter_map(of).collect();
    let stale = listed.keys().filter(|key| !used.contains(key));
    let stale = stale.map(|key| (key, "is listed, and not found or names its input"));
    let idle = met
        .named
        .difference(&met.held)
        .map(|key| (key, "is never compared with a direct solve that notices it"));
    let twice =
        met.named.iter().filter(|key| of(key).is_some_and(|of| !listed[&of].starts_with("sometimes")));
    let twice = twice.map(|key| (key, "names its input, and is listed"));
    let all = missing.chain(stale).chain(idle).chain(twice);
    all.map(|((id, title, curve), why)| format!("{id} | {title} | {curve} | {why}")).collect()
}
