//! Figures of a rotor: the rotor itself, its modes, and the diagrams over speed.

use std::{
    cell::OnceCell,
    f64::consts::{PI, TAU},
};

use dalembert_core::{
    Animation, Axis, Cell, Column, Drawing, Exhibit, Ink, Plot, Point, Series, Sketch, TableExhibit, Text,
    Worksheet,
};
use dalembert_mechanics::rotor::{
    Assembled, Complex, Rotor, SupportType,
    campbell::Campbell,
    critical::Critical,
    modes::{Spectrum, WhirlDirection, WhirlMode},
    response::{Orbit, unbalance_response},
};

use super::{RotorDynamics, Stations, in_words, stiffness_map};
use crate::shared::letters::{letter_of_row, of_row};

/// Data of the figures.
pub(super) struct RotorFigures<'a> {
    pub(super) problem: &'a RotorDynamics,
    pub(super) rotor: &'a Rotor,
    pub(super) all: &'a Assembled,
    pub(super) spectrum: &'a Spectrum,
    pub(super) criticals: &'a [Critical],
    pub(super) stations: &'a Stations,
}

/// The amplitude of a node along an axis.
type ComplexAmplitude = Complex<f64>;

/// A speed and the motion along x and y; none where it is unbounded.
type Sample = (f64, Option<[ComplexAmplitude; 2]>);

/// Critical speeds that are nearer to each other than this share of the highest speed have one label.
const ONE_LABEL: f64 = 0.04;
/// Speeds of the response.
const POINTS: u16 = 240;

/// Frames of an animation.
const FRAMES: usize = 24;

pub(super) fn show<'a, W: Worksheet>(
    shown: &RotorFigures<'_>,
    diagram: &impl Fn() -> Option<&'a Campbell>,
    finer: &impl Fn() -> Option<&'a Spectrum>,
    sheet: W,
) {
    sheet.show(|| Exhibit::Table(shown.modes(finer())));
    if diagram().is_some() {
        sheet.show(|| Exhibit::Plot(shown.campbell(diagram())));
    }
    sheet.verify(|| {
        if let Some(map) = stiffness_map::plot(shown.problem, shown.rotor) {
            sheet.show(|| Exhibit::Plot(map));
        }
    });
    if shown.stations.response.is_some() && !shown.problem.unbalances.is_empty() {
        let sweep = OnceCell::new();
        sheet.show(|| Exhibit::Plot(response(sweep.get_or_init(|| shown.sweep()))));
        sheet.show(|| Exhibit::Plot(phase(sweep.get_or_init(|| shown.sweep()))));
    }
    if !shown.rotor.is_conservative() {
        sheet.show(|| Exhibit::Plot(stability(diagram())));
    }
    sheet.show(|| Exhibit::Drawing(shown.sketch()));
    for (n, mode) in shown.spectrum.modes.iter().enumerate().take(6) {
        sheet.show(|| Exhibit::Animation(shown.animation(n + 1, mode)));
    }
}

impl RotorFigures<'_> {
    /// The modes at the speed, with the frequencies of a mesh twice as fine.
    fn modes(&self, finer: Option<&Spectrum>) -> TableExhibit {
        let column = |heading: &'static str, unit| Column { heading: heading.into(), unit };
        let row = |(n, mode): (usize, &WhirlMode)| {
            let fine = finer.and_then(|finer| finer.modes.get(n)).map(WhirlMode::frequency);
            let change = fine.map(|fine| fine / mode.frequency() - 1.0);
            let number = |x: Option<f64>| x.map_or(Cell::Empty, Cell::Number);
            vec![
                Cell::Text(Text::new("{n}").with("n", n + 1)),
                Cell::Number(mode.frequency()),
                Cell::Number(mode.frequency()),
                Cell::Number(mode.log_decrement()),
                Cell::Text(if self.spectrum.speed > 0.0 {
                    in_words(mode.direction())
                } else {
                    Text::from("–")
                }),
                number(fine),
                number(change),
            ]
        };
        TableExhibit {
            title: "Modes at this speed, and with twice as many elements".into(),
            columns: vec![
                column("mode", ""),
                column("ω", "rad/s"),
                column("f", "Hz"),
                column("δ", "1"),
                column("whirl", ""),
                column("f, finer mesh", "Hz"),
                column("change", "%"),
            ],
            rows: self.spectrum.modes.iter().enumerate().map(row).collect(),
            foot: Vec::new(),
        }
    }

    fn campbell(&self, diagram: Option<&Campbell>) -> Plot {
        let mut series = branches(diagram, "frequency[*]", WhirlMode::frequency);
        let (last, slope) = (self.problem.highest_speed, self.problem.slope);
        let top = series
            .iter()
            .flat_map(|series| series.points.iter())
            .map(|point| point.1)
            .filter(|y| y.is_finite())
            .fold(slope * self.problem.speed, f64::max);
        // Twice the speed is what a shaft that is not round excites.
        let orders = if slope == 1.0 { vec![1.0, 2.0] } else { vec![slope] };
        series.extend(orders.into_iter().map(|order| {
            let end = last.min(1.05 * top / order);
            let label = Text::new("{order}× speed").with_quantity("order", order, "1");
            Series::line(label, vec![(0.0, 0.0), (end, order * end)])
        }));
        let mut plot = Plot::new(
            "Campbell diagram",
            Axis::linear("speed", "rpm"),
            Axis::linear("damped natural frequency", "Hz"),
            series,
        )
        .over("speed");
        // Speeds too near each other for two labels share one.
        let near = |a: &Critical, b: &Critical| b.speed - a.speed < ONE_LABEL * last;
        let mut first = 1;
        for group in self.criticals.chunk_by(near) {
            let (end, mut label) =
                (first + group.len() - 1, Text::new("critical speed {n}").with("n", first));
            if group.len() > 1 {
                label = Text::new("critical speeds {first}–{last}").with("first", first).with("last", end);
            }
            for critical in group {
                plot = plot.mark(std::mem::take(&mut label), (critical.speed, slope * critical.speed));
            }
            first = end + 1;
        }
        plot
    }

    /// The response at the place that is asked for, at every speed.
    fn sweep(&self) -> Vec<Sample> {
        let unbalances = self.problem.unbalance_at(self.stations);
        let node = self.stations.response.unwrap_or(0);
        let lowest = self.problem.lowest_speed();
        (1..=POINTS)
            .map(|n| {
                let speed = lowest + (self.problem.highest_speed - lowest) * f64::from(n) / f64::from(POINTS);
                let response = unbalance_response(self.all, &unbalances, speed).ok();
                (speed, response.map(|response| [response[node][0], response[node][2]]))
            })
            .collect()
    }

    fn sketch(&self) -> Drawing {
        let mut sketch = Sketch::new("The rotor, with the places of its parts from the left end");
        let length: f64 = self.problem.segments.iter().map(|segment| segment.length).sum();
        let thickest = self.problem.segments.iter().map(|segment| segment.outer).fold(0.0, f64::max);
        self.shaft(&mut sketch, (length, thickest));
        let lowest = self.discs(&mut sketch, (length, thickest));
        let floor = lowest.min(-0.14 * length) - 0.06 * length;
        self.bearings(&mut sketch, (length, thickest), floor);
        for (unbalance, row) in self.problem.unbalances.iter().zip(1..) {
            let at = (unbalance.position, 1.2 * thickest);
            sketch.round(of_row(&["U", "α"], row), at, 0.012 * length, Ink::Danger);
        }
        let turn = |n: i32| {
            let (sin, cos) = (PI * (0.6 + 0.8 * f64::from(n) / 12.0)).sin_cos();
            (1.14 * length + 0.02 * length * cos, 0.07 * length * sin)
        };
        sketch.curve((0..12).map(turn).collect::<Vec<_>>(), Ink::Motion).motion(
            "Ω ≤ Ωₘₐₓ",
            turn(11),
            turn(12),
        );
        self.places(&mut sketch, length, floor - 0.07 * length);
        sketch.finish()
    }

    /// Segments end to end, with their diameters and lengths.
    fn shaft(&self, sketch: &mut Sketch, (length, thickest): (f64, f64)) {
        const LETTERED: usize = 6;
        sketch.axis((-0.05 * length, 0.0), (1.18 * length, 0.0));
        let mut from = 0.0;
        let few = self.problem.segments.len() <= LETTERED;
        for (segment, row) in self.problem.segments.iter().zip(1..) {
            let to = from + segment.length;
            let (left, right) = (segment.outer / 2.0, segment.outer_right.unwrap_or(segment.outer) / 2.0);
            sketch.body("", [(from, -left), (from, left), (to, right), (to, -right)]);
            if few {
                let mut letters = vec!["L", "D"];
                letters.extend(segment.outer_right.map(|_| "D_R"));
                letters.extend(segment.inner.map(|_| "d"));
                let share = if row == 1 { 0.5 } else { 0.4 };
                sketch.label(of_row(&letters, row), (from + share * segment.length, thickest / 2.0));
            }
            from = to;
        }
    }

    /// Discs with their letters; the height of the lowest edge.
    fn discs(&self, sketch: &mut Sketch, (length, thickest): (f64, f64)) -> f64 {
        let mut lowest = -thickest / 2.0;
        for ((disc, made), row) in self.problem.discs.iter().zip(&self.rotor.discs).zip(1..) {
            let (radius, half, letters): (f64, f64, &[&str]) = match disc.size {
                super::DiscSize::Geometry { outer, width, .. } => {
                    (outer / 2.0, width / 2.0, &["D_d", "d_d", "h"])
                }
                super::DiscSize::Inertia { .. } => {
                    let radius = if made.mass > 0.0 { (2.0 * made.polar / made.mass).sqrt() } else { 0.0 };
                    (radius.max(thickest), 0.01 * length, &["m_d", "I_d", "I_p"])
                }
            };
            sketch.mass("", (disc.position - half, -radius), (disc.position + half, radius));
            sketch.label(of_row(letters, row), (disc.position, radius));
            lowest = lowest.min(-radius);
        }
        lowest
    }

    /// A spring and a damper under each bearing that gives way, on a floor.
    fn bearings(&self, sketch: &mut Sketch, (length, thickest): (f64, f64), floor: f64) {
        for ((support, held), row) in self.problem.supports.iter().zip(&self.rotor.supports).zip(1..) {
            let z = support.position;
            match held.hold {
                SupportType::Bearing(_) => {
                    let [stiffness, damping] = match support.bearing {
                        super::Bearing::Isotropic { .. } => [of_row(&["k"], row), of_row(&["c"], row)],
                        super::Bearing::Orthotropic { .. } => {
                            [of_row(&["k_xx", "k_yy"], row), of_row(&["c_xx", "c_yy"], row)]
                        }
                        _ => ["K".into(), "C".into()],
                    };
                    sketch
                        .spring_and_damper(
                            (stiffness, damping),
                            (z, floor),
                            (z, -thickest / 2.0),
                            0.09 * length,
                        )
                        .bars([(z - 0.05 * length, -thickest / 2.0), (z + 0.05 * length, -thickest / 2.0)])
                        .ground((z - 0.07 * length, floor), (z + 0.07 * length, floor));
                }
                SupportType::Pinned => {
                    sketch.pin("", (z, -thickest / 2.0));
                }
                SupportType::Clamped => {
                    let half = thickest.max(0.05 * length);
                    sketch.ground((z, half), (z, -half));
                }
            }
        }
    }

    /// The places of discs, bearings and unbalances, as ordinates on one line; letters of one place together.
    fn places(&self, sketch: &mut Sketch, length: f64, level: f64) {
        let discs =
            self.problem.discs.iter().zip(1..).map(|(disc, row)| (disc.position, letter_of_row("z", row)));
        let supports = self
            .problem
            .supports
            .iter()
            .zip(1..)
            .map(|(held, row)| (held.position, letter_of_row("z_b", row)));
        let unbalances = self
            .problem
            .unbalances
            .iter()
            .zip(1..)
            .map(|(one, row)| (one.position, letter_of_row("z_u", row)));
        let mut places: Vec<(f64, Vec<String>)> = Vec::new();
        for (z, letter) in discs.chain(supports).chain(unbalances) {
            match places.iter_mut().find(|(other, _)| (other - z).abs() < 1e-6 * length) {
                Some((_, letters)) => letters.push(letter),
                None => places.push((z, vec![letter])),
            }
        }
        sketch.axis((0.0, level - 0.015 * length), (0.0, level + 0.04 * length)).vector(
            "z",
            (0.0, level),
            (1.08 * length, level),
            Ink::Faint,
        );
        for (z, letters) in places {
            sketch
                .axis((z, level), (z, level + 0.03 * length))
                .label(Text::verbatim(letters.join(", ")), (z, level));
        }
    }

    /// A mode: the centre line of the shaft seen from the side and a little from above.
    fn animation(&self, n: usize, mode: &WhirlMode) -> Animation {
        let length = self.all.positions.last().copied().unwrap_or(1.0);
        let largest = (0..self.all.nodes())
            .map(|node| mode.orbit(node).major)
            .fold(0.0, f64::max)
            .max(f64::MIN_POSITIVE);
        let size = 0.25 * length / largest;
        let place = |z: f64, x: f64, y: f64| (z + 0.35 * size * y, size * x + 0.15 * size * y);
        let at = |node: usize, angle: f64| {
            let turn = |part: ComplexAmplitude| part.re * angle.cos() - part.im * angle.sin();
            place(self.all.positions[node], turn(mode.shape[node][0]), turn(mode.shape[node][2]))
        };
        let orbits: Vec<Vec<Point>> = self
            .rotor
            .discs
            .iter()
            .map(|disc| disc.node)
            .chain(self.rotor.supports.iter().map(|support| support.node))
            .map(|node| (0..=24).map(|k| at(node, TAU * f64::from(k) / 24.0)).collect())
            .collect();
        let frame = |k: usize| {
            let angle = TAU * k as f64 / FRAMES as f64;
            let mut sketch = Sketch::default();
            sketch.axis((0.0, 0.0), (length, 0.0));
            for orbit in &orbits {
                sketch.curve(orbit.as_slice(), Ink::Faint);
            }
            for support in &self.rotor.supports {
                sketch.pin("", (self.all.positions[support.node], 0.0));
            }
            let line: Vec<Point> = (0..self.all.nodes()).map(|node| at(node, angle)).collect();
            sketch.curve(line, Ink::Motion);
            for disc in &self.rotor.discs {
                sketch.disc("", at(disc.node, angle), 0.015 * length);
            }
            sketch
        };
        let title = if self.spectrum.speed > 0.0 {
            Text::new("Mode {n} at {frequency}: it {direction}")
                .with_text("direction", in_words(mode.direction()))
        } else {
            Text::new("Mode {n} at {frequency}")
        };
        Sketch::animation(
            title.with("n", n).with_quantity("frequency", mode.frequency(), "Hz"),
            (0..FRAMES).map(frame),
            2.0,
        )
    }
}

fn response(sweep: &[Sample]) -> Plot {
    let curve = |value: fn(Orbit) -> f64| {
        let at = |&(speed, motion): &Sample| {
            (speed, motion.map_or(f64::INFINITY, |[x, y]| value(Orbit::of(x, y))))
        };
        sweep.iter().map(at).collect()
    };
    Plot::new(
        "Unbalance response, zero to peak",
        Axis::linear("speed", "rpm"),
        Axis::log("semi-axes of the orbit", "um"),
        vec![
            Series::line("semi-major axis", curve(|orbit| orbit.major)).of("response_major"),
            Series::line("semi-minor axis", curve(|orbit| orbit.minor.abs())).of("|response_minor|"),
        ],
    )
    .over("speed")
}

fn phase(sweep: &[Sample]) -> Plot {
    let at = |&(speed, motion): &Sample| (speed, motion.map_or(f64::INFINITY, |[x, _]| x.arg()));
    Plot::new(
        "Phase of the unbalance response along x",
        Axis::linear("speed", "rpm"),
        Axis::linear("phase ahead of the mark", "deg"),
        vec![Series::line("φ", sweep.iter().map(at).collect()).of("response_phase")],
    )
    .over("speed")
}

/// A curve for each mode, named by its whirl at the highest speed.
fn branches(diagram: Option<&Campbell>, answer: &'static str, value: fn(&WhirlMode) -> f64) -> Vec<Series> {
    let Some(diagram) = diagram else { return Vec::new() };
    let branch = |(n, branch): (usize, &Vec<Option<WhirlMode>>)| {
        let points = diagram
            .speeds
            .iter()
            .zip(branch)
            .map(|(&speed, mode)| (speed, mode.as_ref().map_or(f64::INFINITY, value)));
        let whirl = match branch.iter().rev().flatten().next()?.direction() {
            WhirlDirection::Forward => "forward",
            WhirlDirection::Backward => "backward",
            WhirlDirection::Mixed => "mixed",
            WhirlDirection::Planar => "in a plane",
        };
        let label = Text::new("mode {n}, {whirl}").with("n", n + 1).with_text("whirl", whirl);
        Some(Series::line(label, points.collect()).of(answer))
    };
    diagram.branches.iter().enumerate().filter_map(branch).collect()
}

/// Logarithmic decrement of a mode; zero if it is within the rounding error of the eigenvalue.
fn decrement(mode: &WhirlMode) -> f64 {
    let decrement = mode.log_decrement();
    if decrement.abs() > 1e-12 { decrement } else { 0.0 }
}

fn stability(diagram: Option<&Campbell>) -> Plot {
    Plot::new(
        "Stability map",
        Axis::linear("speed", "rpm"),
        Axis::linear("logarithmic decrement", "1"),
        branches(diagram, "log_decrement[*]", decrement),
    )
    .over("speed")
    .level("limit of stability, δ = 0", 0.0)
}
