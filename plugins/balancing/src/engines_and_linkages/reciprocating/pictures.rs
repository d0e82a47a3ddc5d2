//! Drawings of an engine.

use std::f64::consts::TAU;

use dalembert_core::{
    Animation, Axis, Cell, Column, Drawing, Ink, Plot, Point, Series, Sketch, TableExhibit, Text,
    trace::ROUNDING,
};
use dalembert_mechanics::{
    Real,
    balance::reciprocating::{self as engine, Piston, PistonMotion},
};

use super::{layout::View, orders::Order};
use crate::shared::views::dial;

const POINTS: u32 = 240;

fn over_a_turn(
    pistons: &[Piston],
    motion: PistonMotion,
    about: f64,
    axis: usize,
    couple: bool,
) -> Vec<Point> {
    let reach = pistons.iter().map(|p| (p.position - about).abs()).fold(0.0, f64::max);
    let scale = pistons.iter().map(|p| p.amplitude).sum::<f64>() * if couple { reach } else { 1.0 };
    let at = |k: u32| {
        let angle = TAU * f64::from(k) / f64::from(POINTS);
        let (force, moment) = engine::shaking(pistons, motion, about, angle);
        let value = if couple { moment[axis] } else { force[axis] };
        (angle, if value.abs() < 1e-12 * scale { 0.0 } else { value })
    };
    (0..=POINTS).map(at).collect()
}

fn curves(pistons: &[Piston], motion: PistonMotion, about: f64, couple: bool) -> Vec<Series> {
    let curve = |label: &'static str, motion, axis| {
        Series::line(label, over_a_turn(pistons, motion, about, axis, couple))
    };
    let mut series = Vec::new();
    if motion == PistonMotion::OneTerm {
        series.push(curve("upward, primary", motion, 0));
    } else {
        series.push(curve("upward, exact motion", PistonMotion::Exact, 0));
        series.push(curve("upward, two terms", PistonMotion::TwoTerms, 0));
    }
    if pistons.iter().any(|p| p.line.sin().abs() > ROUNDING) {
        let motion = if motion == PistonMotion::OneTerm { motion } else { PistonMotion::Exact };
        series.push(curve("across", motion, 1));
    }
    series
}

/// The shaking force over a turn.
pub(super) fn forces(pistons: &[Piston], motion: PistonMotion, about: f64) -> Plot {
    let x = Axis::linear("Crank angle", "deg");
    let y = Axis::linear("Shaking force", "N");
    Plot::new("Shaking force over a revolution", x, y, curves(pistons, motion, about, false))
}

/// The shaking couple over a turn.
pub(super) fn couples(pistons: &[Piston], motion: PistonMotion, about: f64) -> Plot {
    let x = Axis::linear("Crank angle", "deg");
    let y = Axis::linear("Shaking moment", "N*m");
    Plot::new("Shaking moment over a revolution", x, y, curves(pistons, motion, about, true))
}

/// The way of the tip of the force over a turn: across to the right, upward up.
pub(super) fn ellipse(pistons: &[Piston], motion: PistonMotion, about: f64) -> Drawing {
    let size: f64 = pistons.iter().map(|p| p.amplitude).sum();
    let size = if size > 0.0 { size } else { 1.0 };
    let tips: Vec<Point> = (0..=POINTS)
        .map(|k| {
            let angle = TAU * f64::from(k) / f64::from(POINTS);
            let ([up, across], _) = engine::shaking(pistons, motion, about, angle);
            (across / size, up / size)
        })
        .collect();
    dial("Polar diagram of the shaking force (one revolution)")
        .curve(tips, Ink::Force)
        .label("Σ m r ω²", (0.0, 1.0))
        .finish()
}

/// Orders, with their forward and backward vectors.
pub(super) fn table<N: Real>(found: &[Order<N>]) -> TableExhibit {
    let column = |heading: &'static str, unit| Column { heading: heading.into(), unit };
    let with_couples = found.iter().any(|order| order.couple.is_some());
    let mut columns = vec![
        column("order", "1"),
        column("force forward", "N"),
        column("force backward", "N"),
        column("maximum force", "N"),
    ];
    if with_couples {
        columns.extend([
            column("couple forward", "N*m"),
            column("couple backward", "N*m"),
            column("maximum couple", "N*m"),
        ]);
    }
    let row = |order: &Order<N>| -> Vec<Cell> {
        let clean = |x: f64, scale: f64| if x < 1e-12 * scale { 0.0 } else { x };
        let [p, q] =
            [order.force.forward_size, order.force.backward_size].map(|x| clean(x.value(), order.scale));
        let mut cells: Vec<Cell> = vec![f64::from(order.number).into(), p.into(), q.into(), (p + q).into()];
        if let Some(couple) = &order.couple {
            let [m, n] = [couple.forward_size, couple.backward_size].map(Real::value);
            cells.extend([m.into(), n.into(), (m + n).into()]);
        }
        cells
    };
    let rows = found.iter().map(row).collect();
    TableExhibit { title: "Orders of the shaking force".into(), columns, rows, foot: Vec::new() }
}

/// Stars of the cranks, one for each order, turning at the order's speed.
pub(super) fn stars(pistons: &[Piston], orders: &[u8]) -> Animation {
    const FRAMES: u32 = 24;
    let frame = |k: u32| {
        let turned = TAU * f64::from(k) / f64::from(FRAMES);
        let mut sketch = Sketch::default();
        for (n, order) in orders.iter().enumerate() {
            let (h, centre) = (f64::from(*order), (2.8 * n as f64, 0.0));
            sketch.circle(centre, 1.0, Ink::Faint).axis((centre.0, -1.1), (centre.0, 1.1));
            for (piston, number) in pistons.iter().zip(1..) {
                let angle = h * (turned + piston.throw - piston.line) + piston.line;
                let at = |radius: f64| (centre.0 + radius * angle.sin(), radius * angle.cos());
                // Arrows that fall on one another are distinguished by the distance of their numbers.
                let out = 1.2 + 0.14 * f64::from((number - 1) / 4);
                sketch.force("", centre, at(1.0)).caption(Text::new(number.to_string()), at(out));
            }
            sketch.caption(Text::new("order {n}").with("n", order), (centre.0, -1.6));
        }
        sketch
    };
    Sketch::animation("Crank star diagrams by order", (0..FRAMES).map(frame), 4.0)
}

/// The engine at its first dead centre: cylinders along the shaft from the side, or those about one point of it along the
/// shaft. The letters stand at the first cylinder; `along` is the symbol of the distance to the next one.
pub(super) fn engine(cylinders: &[View], along: &'static str) -> Drawing {
    let first = &cylinders[0];
    let is_line = cylinders.iter().all(|one| (one.line - first.line).sin().abs() < 1e-9)
        && cylinders.iter().any(|one| one.position != first.position);
    if is_line { from_the_side(cylinders, along) } else { along_the_shaft(cylinders) }
}

fn from_the_side(cylinders: &[View], along: &'static str) -> Drawing {
    let mut sketch = Sketch::new("The engine from the side");
    let ends =
        cylinders.iter().fold((f64::MAX, f64::MIN), |(a, b), one| (a.min(one.position), b.max(one.position)));
    let height = cylinders.iter().map(|one| one.crank + one.reach()).fold(0.0, f64::max);
    // The shaft is drawn as long as the engine is high, whatever the pitch.
    let scale = 1.4 * height / (ends.1 - ends.0);
    let at = |position: f64| scale * (position - ends.0);
    let half = 0.08 * height;
    sketch.size(1.6 * height).link("", (-3.0 * half, 0.0), (at(ends.1) + 3.0 * half, 0.0));
    for end in [-2.0 * half, at(ends.1) + 2.0 * half] {
        sketch.bearing("", (end, 0.0), 0.0);
    }
    for (n, one) in cylinders.iter().enumerate() {
        let (x, ((_, pin), piston)) = (at(one.position), one.pin_and_piston());
        let [r, l] = if n == 0 { ["r", one.rod_letter()] } else { [""; 2] };
        sketch.link(r, (x, 0.0), (x, pin)).link(l, (x, pin), (x, piston)).joint("", (x, pin)).mass(
            if n == 0 { one.masses() } else { "" },
            (x - half, piston - half),
            (x + half, piston + half),
        );
    }
    if let [first, second, ..] = cylinders {
        let level = height + 2.0 * half;
        sketch.dimension(along, (at(first.position), level), (at(second.position), level), 0.0);
    }
    sketch.couple("ω", (at(ends.1) + 3.0 * half, 0.0), (-1.2, 1.2), Ink::Motion).finish()
}

fn along_the_shaft(cylinders: &[View]) -> Drawing {
    let mut sketch = Sketch::new("The engine along its shaft");
    let height = cylinders.iter().map(|one| one.crank + one.reach()).fold(0.0, f64::max);
    let half = 0.08 * height;
    sketch.size(2.0 * height);
    let up = std::f64::consts::FRAC_PI_2;
    let mut lines: Vec<f64> = Vec::new();
    for one in cylinders {
        if lines.iter().any(|line| (line - one.line).abs() < 1e-9) {
            continue;
        }
        let (pin, piston) = one.pin_and_piston();
        let (sin, cos) = one.line.sin_cos();
        let on = |along: f64, across: f64| (along * sin + across * cos, along * cos - across * sin);
        let [r, l] = if lines.is_empty() { ["r", one.rod_letter()] } else { [""; 2] };
        let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
        let corners = corners.map(|(along, across)| on(piston + along * half, across * half));
        sketch
            .axis((0.0, 0.0), on(1.1 * height, 0.0))
            .link(r, (0.0, 0.0), pin)
            .body(if lines.is_empty() { one.masses() } else { "" }, corners)
            .link(l, pin, on(piston, 0.0))
            .joint("", pin);
        lines.push(one.line);
    }
    if let [first, second] = lines[..] {
        sketch.angle("γ", (0.0, 0.0), up - second.max(first), up - second.min(first));
    }
    sketch.pin("O", (0.0, 0.0)).couple("ω", (0.0, 0.0), (4.4, 3.3), Ink::Motion).finish()
}
