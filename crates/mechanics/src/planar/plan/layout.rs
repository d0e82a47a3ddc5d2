//! Layout of the entries of the Jacobian in a flat array, and choice of the explicit coordinates.

#![expect(clippy::inline_always, reason = "what is not inlined is not compiled for the widest registers")]

use std::collections::VecDeque;

use super::super::{
    Equation, Frame, Measure, Point, Pose, System, Term,
    system::{gradient, pair, project},
};
use crate::Real;
use dalembert_numerics::simd::{SimdReal, SimdVector, WIDTH, widest};

/// The structure of a mechanism's equations, whatever its position.
///
/// Columns are scaled positions: `3 body + (0, 1, 2)` for `(x, y, θ · length)`. Entry 0 of the flat array takes what
/// belongs nowhere: entries by the ground and those that are always zero.
#[derive(Debug, Clone)]
pub(in super::super) struct Layout {
    /// Rows of the equations, each with its columns and their places in the flat array.
    pub(super) rows: Vec<Vec<(usize, usize)>>,
    /// Number of entries.
    pub(super) places: usize,
    /// The equations that give a coordinate, in the order in which they can be used: row, column, Jacobian entry.
    pub(super) explicit: Vec<(usize, usize, f64)>,
    /// The other rows.
    pub(super) loops: Vec<usize>,
    /// The largest constant Jacobian entry of each of them; zero where none is constant.
    constant: Vec<f64>,
    /// The columns that are not explicit.
    pub(in super::super) kept: Vec<usize>,
    /// The bodies whose angle is kept, and its number among the kept coordinates.
    turning: Vec<(usize, usize)>,
    /// The kept coordinates of origins: their number and column.
    moving: Vec<(usize, usize)>,
    kernels: Vec<Kernel>,
    /// Evaluation of the explicit coordinates, in order.
    settings: Vec<Setting>,
    bodies: usize,
    length: f64,
}

/// The numbers of a position, or of several side by side.
#[derive(Debug, Clone)]
pub(in super::super) struct Work<S = f64> {
    /// Positions `(x, y, θ)` of the bodies and, last, the ground.
    pub(in super::super) poses: Vec<Pose<S>>,
    /// Residual of each constraint equation.
    pub(in super::super) residuals: Vec<S>,
    /// The constants of the equations.
    pub(in super::super) sums: Vec<S>,
    /// The entries of the Jacobian, in the places of the layout and, behind, those of an order.
    pub(in super::super) jacobian: Vec<S>,
    /// The arms of the pins.
    arms: Vec<[S; 4]>,
}

/// The kept angles, by their body and their number, and the kept coordinates of origins, by number and column.
fn numbered(kept: &[usize]) -> [Vec<(usize, usize)>; 2] {
    let (turning, moving): (Vec<_>, Vec<_>) =
        kept.iter().copied().enumerate().partition(|(_, column)| column % 3 == 2);
    [turning.into_iter().map(|(number, column)| (column / 3, number)).collect(), moving]
}

/// One equation, or the two of a pin.
#[derive(Debug, Clone)]
enum Kernel {
    /// `B − A = 0` in both directions: row of the first, and the places of the entries by θ_A and θ_B of each.
    Pin { row: usize, points: [Point; 2], bodies: [usize; 2], places: [[usize; 2]; 2], is_loop: bool },
    /// Anything; its entries may be constant.
    General { row: usize, terms: Vec<(Term, [[usize; 3]; 2])>, is_constant: bool, is_loop: bool },
}

#[derive(Debug, Clone)]
enum Setting {
    /// The origin of a body, or one coordinate of it, from a pin whose first (0) or second (1) point it carries.
    Pin { kernel: usize, side: usize, parts: [bool; 2] },
    /// A coordinate from an equation.
    General { kernel: usize, column: usize, entry: f64 },
}

impl Layout {
    pub(in super::super) fn new(system: &System) -> Self {
        let bodies = system.mechanism.bodies.len();
        let length = system.length;
        let shapes: Vec<Vec<(usize, Option<f64>)>> =
            system.equations.iter().map(|equation| shape(equation, length)).collect();
        let mut places = 1;
        let rows: Vec<Vec<(usize, usize)>> = shapes
            .iter()
            .map(|shape| {
                let place = |&(column, _): &(usize, Option<f64>)| {
                    places += 1;
                    (column, places - 1)
                };
                shape.iter().map(place).collect()
            })
            .collect();
        let place = |row: usize, frame: Frame, part: usize| {
            let column = frame.map(|body| 3 * body + part);
            rows[row].iter().find(|(at, _)| Some(*at) == column).map_or(0, |(_, place)| *place)
        };
        let mut kernels = Vec::new();
        let mut kernel_of = vec![0; rows.len()];
        let mut row = 0;
        while row < rows.len() {
            let kernel = match pin(&system.equations[row..]) {
                Some(points) => {
                    let of_row = |row| points.map(|point| place(row, point.on, 2));
                    let bodies = points.map(|point| point.on.unwrap_or(bodies));
                    kernel_of[row + 1] = kernels.len();
                    Kernel::Pin { row, points, bodies, places: [of_row(row), of_row(row + 1)], is_loop: true }
                }
                None => {
                    let of_term = |term: &Term| {
                        let of = |frame| [0, 1, 2].map(|part| place(row, frame, part));
                        (term.clone(), term.measure.bodies().map(of))
                    };
                    let terms = system.equations[row].terms.iter().map(of_term).collect();
                    let is_constant = shapes[row].iter().all(|(_, entry)| entry.is_some());
                    Kernel::General { row, terms, is_constant, is_loop: true }
                }
            };
            kernel_of[row] = kernels.len();
            row += if matches!(kernel, Kernel::Pin { .. }) { 2 } else { 1 };
            kernels.push(kernel);
        }
        let (explicit, kept) = explicit(&shapes, 3 * bodies);
        let mut is_loop = vec![true; rows.len()];
        let mut settings: Vec<Setting> = Vec::new();
        for &(row, column, entry) in &explicit {
            is_loop[row] = false;
            let kernel = kernel_of[row];
            match &kernels[kernel] {
                Kernel::Pin { bodies, .. } => {
                    let now = usize::from(bodies[1] == column / 3);
                    match settings.last_mut() {
                        Some(Setting::Pin { kernel: last, side, parts })
                            if *last == kernel && *side == now =>
                        {
                            parts[column % 3] = true;
                        }
                        _ => {
                            let parts = [0, 1].map(|part| column % 3 == part);
                            settings.push(Setting::Pin { kernel, side: now, parts });
                        }
                    }
                }
                Kernel::General { .. } => settings.push(Setting::General { kernel, column, entry }),
            }
        }
        for kernel in &mut kernels {
            match kernel {
                Kernel::Pin { row, is_loop: of_loop, .. } => *of_loop = is_loop[*row] || is_loop[*row + 1],
                Kernel::General { row, is_loop: of_loop, .. } => *of_loop = is_loop[*row],
            }
        }
        let loops: Vec<usize> = (0..rows.len()).filter(|&row| is_loop[row]).collect();
        let constant = |row: &usize| {
            let jacobian = shapes[*row].iter().filter_map(|(_, entry)| *entry);
            jacobian.fold(0.0f64, |most, entry| most.max(entry.abs()))
        };
        let constant = loops.iter().map(constant).collect();
        let [turning, moving] = numbered(&kept);
        Self {
            rows,
            places,
            explicit,
            loops,
            constant,
            kept,
            turning,
            moving,
            kernels,
            settings,
            bodies,
            length,
        }
    }

    /// Puts the equations that are not explicit, and the kept coordinates, into another order.
    pub(in super::super) fn rearrange(&mut self, loops: &[usize], kept: &[usize]) {
        self.constant = loops.iter().map(|&row| self.constant[row]).collect();
        self.loops = loops.iter().map(|&row| self.loops[row]).collect();
        self.kept = kept.iter().map(|&number| self.kept[number]).collect();
        [self.turning, self.moving] = numbered(&self.kept);
    }

    /// Room for the numbers of a position.
    pub(in super::super) fn work<S: SimdReal>(&self, system: &System) -> Work<S> {
        let zero = S::from(0.0);
        let mut jacobian = vec![zero; self.places];
        for (row, equation) in system.equations.iter().enumerate() {
            for (column, entry) in shape(equation, self.length) {
                let place =
                    self.rows[row].iter().find(|(at, _)| *at == column).map_or(0, |(_, place)| *place);
                jacobian[place] = S::from(entry.unwrap_or(0.0));
            }
        }
        Work {
            poses: vec![Pose::ground(); self.bodies + 1],
            residuals: vec![zero; self.rows.len()],
            sums: system.equations.iter().map(|equation| S::from(equation.sum.unwrap_or(0.0))).collect(),
            jacobian,
            arms: vec![[zero; 4]; self.kernels.len()],
        }
    }

    /// The position with these kept coordinates: poses, residuals and Jacobian.
    #[inline(always)]
    pub(in super::super) fn set<S: SimdReal>(&self, kept: &[S], work: &mut Work<S>) {
        self.turn(kept, &mut work.poses);
        for &(number, column) in &self.moving {
            self.put(column, kept[number], work);
        }
        for setting in &self.settings {
            match *setting {
                Setting::Pin { kernel, side, parts } => {
                    let Kernel::Pin { points: [a, b], bodies, .. } = self.kernels[kernel] else { continue };
                    let [ax, ay] = work.poses[bodies[0]].turned(a.at);
                    let [bx, by] = work.poses[bodies[1]].turned(b.at);
                    work.arms[kernel] = [ax, ay, bx, by];
                    let other = work.poses[bodies[1 - side]];
                    let (dx, dy) = if side == 1 { (ax - bx, ay - by) } else { (bx - ax, by - ay) };
                    let moved = &mut work.poses[bodies[side]];
                    if parts[0] {
                        moved.x = other.x + dx;
                    }
                    if parts[1] {
                        moved.y = other.y + dy;
                    }
                }
                Setting::General { kernel, column, entry } => {
                    let Kernel::General { row, terms, .. } = &self.kernels[kernel] else { continue };
                    self.put(column, S::from(0.0), work);
                    let left = S::sum(terms.iter().map(|(term, _)| value(term, &work.poses)));
                    self.put(column, (work.sums[*row] - left) / entry, work);
                }
            }
        }
    }

    /// The kept angles, with cosines and sines: those of several bodies at once where positions come one by one.
    #[inline(always)]
    fn turn<S: SimdReal>(&self, kept: &[S], poses: &mut [Pose<S>]) {
        let per_length = 1.0 / self.length;
        if S::COUNT > 1 {
            for &(body, number) in &self.turning {
                let angle = kept[number] * per_length;
                poses[body].turn(angle, [angle.cos(), angle.sin()]);
            }
            return;
        }
        for bodies in self.turning.chunks(WIDTH) {
            let angle = |lane: usize| bodies.get(lane).map_or(0.0, |(_, number)| kept[*number].value());
            let angles = SimdVector::of(|lane| angle(lane) * per_length);
            let (cos, sin) = widest(
                #[inline(always)]
                || (angles.cos(), angles.sin()),
            );
            for (lane, (body, _)) in bodies.iter().enumerate() {
                let direction = [S::from(cos.0[lane]), S::from(sin.0[lane])];
                poses[*body].turn(S::from(angles.0[lane]), direction);
            }
        }
    }

    /// Residuals and Jacobian of the position that was set.
    #[inline(always)]
    pub(in super::super) fn measure<S: SimdReal>(&self, work: &mut Work<S>) {
        let per_length = 1.0 / self.length;
        for (index, kernel) in self.kernels.iter().enumerate() {
            match kernel {
                Kernel::Pin { row, points: [a, b], bodies, places: [x, y], is_loop } => {
                    if *is_loop {
                        let (pa, pb) = (&work.poses[bodies[0]], &work.poses[bodies[1]]);
                        let ([ax, ay], [bx, by]) = (pa.turned(a.at), pb.turned(b.at));
                        work.arms[index] = [ax, ay, bx, by];
                        work.residuals[*row] = pb.x + bx - pa.x - ax;
                        work.residuals[row + 1] = pb.y + by - pa.y - ay;
                    }
                    let [ax, ay, bx, by] = work.arms[index];
                    work.jacobian[x[0]] = ay * per_length;
                    work.jacobian[x[1]] = -by * per_length;
                    work.jacobian[y[0]] = -ax * per_length;
                    work.jacobian[y[1]] = bx * per_length;
                }
                // What gives a coordinate holds, and its entries are what they were.
                Kernel::General { is_constant: true, is_loop: false, .. } => {}
                Kernel::General { row, terms, .. } => {
                    for place in terms.iter().flat_map(|(_, places)| places.iter().flatten()) {
                        work.jacobian[*place] = S::from(0.0);
                    }
                    let mut left = S::from(0.0);
                    for (term, places) in terms {
                        let gradient = gradient(&term.measure, &work.poses);
                        let (value, rate) = match &term.profile {
                            Some(profile) => (
                                gradient.value.each(|x| profile.at(x)[0]),
                                gradient.value.each(|x| profile.at(x)[1]),
                            ),
                            None => (gradient.value, S::from(1.0)),
                        };
                        left = left + value * term.weight;
                        let factor = rate * term.weight;
                        for (places, part) in places.iter().zip([gradient.from, gradient.to]) {
                            let turn = part[2] * per_length;
                            for (place, part) in places.iter().zip([part[0], part[1], turn]) {
                                work.jacobian[*place] = work.jacobian[*place] + factor * part;
                            }
                        }
                    }
                    work.residuals[*row] = left - work.sums[*row];
                }
            }
        }
    }

    /// The accelerations of the left sides when no body accelerates, with the signs changed.
    #[inline(always)]
    pub(in super::super) fn bend<S: SimdReal>(&self, work: &Work<S>, velocities: &[[S; 3]], out: &mut [S]) {
        for (index, kernel) in self.kernels.iter().enumerate() {
            match kernel {
                Kernel::Pin { row, bodies: [a, b], .. } => {
                    let [ax, ay, bx, by] = work.arms[index];
                    let (wa, wb) = (velocities[*a][2], velocities[*b][2]);
                    let (wa, wb) = (wa * wa, wb * wb);
                    out[*row] = bx * wb - ax * wa;
                    out[row + 1] = by * wb - ay * wa;
                }
                Kernel::General { row, is_constant: true, .. } => out[*row] = S::from(0.0),
                Kernel::General { row, terms, .. } => {
                    let of_term = |(term, _): &(Term, _)| {
                        let poses = pair(&term.measure, &work.poses);
                        let [from, to] = term.measure.bodies();
                        let velocity = |frame: Frame| velocities[frame.unwrap_or(self.bodies)];
                        let bias = term.measure.bias(poses, [velocity(from), velocity(to)]);
                        let Some(profile) = &term.profile else { return bias * term.weight };
                        let gradient = term.measure.gradient(poses);
                        let rate = project(&term.measure, &gradient, velocities);
                        let [first, second] =
                            [1, 2].map(|n: usize| gradient.value.each(|x| profile.at(x)[n]));
                        (first * bias + second * rate * rate) * term.weight
                    };
                    out[*row] = -S::sum(terms.iter().map(of_term));
                }
            }
        }
    }

    /// The equations that are not explicit.
    pub(in super::super) fn loops(&self) -> &[usize] {
        &self.loops
    }

    /// The largest residual of the equations that are not explicit, each in parts of the largest entry of its row, of those that never
    /// change where there are such; not a number where a residual is not.
    #[inline(always)]
    pub(in super::super) fn open<S: SimdReal>(&self, work: &Work<S>) -> S {
        let mut open = S::from(0.0);
        for (&row, &constant) in self.loops.iter().zip(&self.constant) {
            let mut residual = work.residuals[row].abs();
            if constant > 0.0 {
                residual = residual * (1.0 / constant);
            } else {
                let mut most = S::from(0.0);
                for (_, place) in &self.rows[row] {
                    most = most.with(work.jacobian[*place].abs(), f64::max);
                }
                residual =
                    residual.with(
                        most,
                        |residual, most| if most > 0.0 || residual.is_nan() { residual / most } else { 0.0 },
                    );
            }
            open = open.with(
                residual,
                |open, residual| if residual > open || residual.is_nan() { residual } else { open },
            );
        }
        open
    }

    #[inline(always)]
    fn put<S: SimdReal>(&self, column: usize, value: S, work: &mut Work<S>) {
        let pose = &mut work.poses[column / 3];
        match column % 3 {
            0 => pose.x = value,
            1 => pose.y = value,
            _ => *pose = Pose::new([pose.x, pose.y, value / self.length]),
        }
    }
}

#[inline(always)]
fn value<S: SimdReal>(term: &Term, poses: &[Pose<S>]) -> S {
    let value = gradient(&term.measure, poses).value;
    term.profile.as_ref().map_or(value, |profile| value.each(|x| profile.at(x)[0])) * term.weight
}

/// The two points of a pin, if these equations begin with those of one.
fn pin(equations: &[Equation]) -> Option<[Point; 2]> {
    let component = |equation: &Equation, along: [f64; 2]| match equation.terms[..] {
        [Term { weight: 1.0, measure: Measure::Component { direction, from, to }, profile: None }]
            if direction == along && from.on != to.on && equation.sum == Some(0.0) =>
        {
            Some([from, to])
        }
        _ => None,
    };
    let [x, y, ..] = equations else { return None };
    let points = component(x, [1.0, 0.0])?;
    (component(y, [0.0, 1.0])? == points).then_some(points)
}

/// The columns of an equation in ascending order, and their Jacobian entries where these are constant.
fn shape(equation: &Equation, length: f64) -> Vec<(usize, Option<f64>)> {
    let mut shape: Vec<(usize, Option<f64>)> = Vec::new();
    let mut add = |frame: Frame, part: usize, entry: Option<f64>| {
        let Some(body) = frame else { return };
        if entry == Some(0.0) {
            return;
        }
        let column = 3 * body + part;
        match shape.iter_mut().find(|(at, _)| *at == column) {
            Some((_, known)) => *known = known.zip(entry).map(|(a, b)| a + b),
            None => shape.push((column, entry)),
        }
    };
    for Term { weight, measure, profile } in &equation.terms {
        let constant = |entry: f64| profile.is_none().then_some(weight * entry);
        let arm = |point: Point| if point.at == [0.0, 0.0] { Some(0.0) } else { None };
        match *measure {
            Measure::Angle { of, against } => {
                add(of, 2, constant(1.0 / length));
                add(against, 2, constant(-1.0 / length));
            }
            Measure::Component { direction: [ux, uy], from, to } => {
                for (part, u) in [ux, uy].into_iter().enumerate() {
                    if u != 0.0 {
                        add(from.on, part, constant(-u));
                        add(to.on, part, constant(u));
                    }
                }
                add(from.on, 2, arm(from));
                add(to.on, 2, arm(to));
            }
            Measure::Along { direction: [ux, uy], from, to } => {
                for (part, u) in [ux, uy].into_iter().enumerate() {
                    let u = if from.on.is_none() { Some(u) } else { None };
                    if u != Some(0.0) {
                        add(from.on, part, None);
                        add(to.on, part, u.and_then(constant));
                    }
                }
                add(from.on, 2, None);
                add(to.on, 2, if to.on == from.on { None } else { arm(to) });
            }
            Measure::Distance { from, to } => {
                for part in 0..3 {
                    add(from.on, part, None);
                    add(to.on, part, None);
                }
            }
        }
    }
    shape.sort_unstable_by_key(|(column, _)| *column);
    shape
}

/// Equations that give a coordinate each, in an order in which they use only what is known, and the columns that
/// remain: row, column and Jacobian entry.
///
/// Angles come first. An origin is found from a pin whose other body is known; where nothing leads on, a coordinate of
/// the equation with fewest unknown ones is kept.
fn explicit(shapes: &[Vec<(usize, Option<f64>)>], columns: usize) -> (Vec<(usize, usize, f64)>, Vec<usize>) {
    let mut explicit = Vec::new();
    let mut used = vec![false; shapes.len()];
    // A column is settled once it is explicit or an explicit equation needs it.
    let mut settled = vec![false; columns];
    for (row, shape) in shapes.iter().enumerate() {
        let angles = shape.iter().all(|(column, entry)| column % 3 == 2 && entry.is_some());
        let best = shape
            .iter()
            .filter(|(column, entry)| !settled[*column] && entry.is_some_and(|entry| entry != 0.0))
            .max_by(|a, b| a.1.unwrap_or(0.0).abs().total_cmp(&b.1.unwrap_or(0.0).abs()));
        if let (true, Some(&(column, Some(entry)))) = (angles, best) {
            explicit.push((row, column, entry));
            used[row] = true;
            for (column, _) in shape {
                settled[*column] = true;
            }
        }
    }
    let is_explicit: Vec<usize> = explicit.iter().map(|(_, column, _)| *column).collect();
    let mut kept: Vec<usize> =
        (0..columns / 3).map(|body| 3 * body + 2).filter(|column| !is_explicit.contains(column)).collect();
    let mut known: Vec<bool> = (0..columns).map(|column| column % 3 == 2).collect();
    // The rows that know each column, and how many unknown ones each row has.
    let mut rows_of: Vec<Vec<usize>> = vec![Vec::new(); columns];
    let mut unknown = vec![0; shapes.len()];
    for (row, shape) in shapes.iter().enumerate() {
        let constant =
            shape.iter().all(|&(column, entry)| column % 3 == 2 || entry.is_some_and(|entry| entry != 0.0));
        if constant && !used[row] {
            for &(column, _) in shape.iter().filter(|(column, _)| column % 3 < 2) {
                rows_of[column].push(row);
                unknown[row] += 1;
            }
        }
    }
    // First come, first served: so the tree is as flat as it can be.
    let mut ready: VecDeque<usize> = (0..shapes.len()).filter(|&row| unknown[row] == 1).collect();
    loop {
        let next = ready.pop_front().or_else(|| {
            // Nothing leads on: of the equation with fewest unknown columns all but one are kept.
            let open = (0..shapes.len()).filter(|&row| unknown[row] > 0);
            open.min_by_key(|&row| unknown[row])
        });
        let Some(row) = next else { break };
        let mut left: Vec<(usize, f64)> = shapes[row]
            .iter()
            .filter(|(column, _)| !known[*column])
            .map(|&(column, entry)| (column, entry.unwrap_or(0.0)))
            .collect();
        left.sort_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
        for &(column, _) in &left {
            known[column] = true;
            for &other in &rows_of[column] {
                unknown[other] -= 1;
                if unknown[other] == 1 {
                    ready.push_back(other);
                }
            }
        }
        if let Some((column, entry)) = left.pop() {
            kept.extend(left.iter().map(|(column, _)| *column));
            explicit.push((row, column, entry));
        }
    }
    kept.extend((0..columns).filter(|&column| !known[column]));
    kept.sort_unstable();
    (explicit, kept)
}
