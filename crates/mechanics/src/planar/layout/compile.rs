//! Compilation of the constraint equations into a [`EquationLayout`].

use std::collections::VecDeque;

use super::{Assignment, EquationLayout, Explicit, Kernel};
use crate::planar::{BodyFrame, BodyPoint, ConstraintTerm, Equation, RelativeCoordinate};

impl EquationLayout {
    /// Compiles the equations, of which so many are of joints, for bodies in a mechanism of this size, m.
    pub(in super::super) fn new(
        equations: &[Equation],
        of_joints: usize,
        bodies: usize,
        length: f64,
    ) -> Self {
        let shapes: Vec<Vec<(usize, Option<f64>)>> =
            equations.iter().map(|equation| shape(equation, length)).collect();
        let mut entries = vec![0.0];
        let rows: Vec<Vec<(usize, usize)>> = shapes
            .iter()
            .map(|shape| {
                let place = |&(column, entry): &(usize, Option<f64>)| {
                    entries.push(entry.unwrap_or(0.0));
                    (column, entries.len() - 1)
                };
                shape.iter().map(place).collect()
            })
            .collect();
        let place = |row: usize, frame: BodyFrame, part: usize| {
            let column = frame.map(|body| 3 * body + part);
            rows[row].iter().find(|(at, _)| Some(*at) == column).map_or(0, |(_, place)| *place)
        };
        let mut kernels = Vec::new();
        let mut kernel_of = vec![0; rows.len()];
        let mut row = 0;
        while row < rows.len() {
            let kernel = match pin(&equations[row.min(of_joints)..of_joints]) {
                Some(points) => {
                    let of_row = |row| points.map(|point| place(row, point.on, 2));
                    let bodies = points.map(|point| point.on.unwrap_or(bodies));
                    kernel_of[row + 1] = kernels.len();
                    Kernel::Pin { row, points, bodies, places: [of_row(row), of_row(row + 1)], is_loop: true }
                }
                None => {
                    let of_term = |term: &ConstraintTerm| {
                        let of = |frame| [0, 1, 2].map(|part| place(row, frame, part));
                        (term.clone(), term.measure.bodies().map(of))
                    };
                    let terms = equations[row].terms.iter().map(of_term).collect();
                    let is_constant = shapes[row].iter().all(|(_, entry)| entry.is_some());
                    Kernel::General { row, terms, is_constant, is_loop: true }
                }
            };
            kernel_of[row] = kernels.len();
            row += if matches!(kernel, Kernel::Pin { .. }) { 2 } else { 1 };
            kernels.push(kernel);
        }
        let (explicit, tree) = explicit(&shapes, 3 * bodies);
        let mut is_loop = vec![true; rows.len()];
        let mut assignments: Vec<Assignment> = Vec::new();
        for &Explicit { row, column, entry } in &explicit {
            is_loop[row] = false;
            let kernel = kernel_of[row];
            match &kernels[kernel] {
                Kernel::Pin { bodies, .. } => {
                    let now = usize::from(bodies[1] == column / 3);
                    match assignments.last_mut() {
                        Some(Assignment::Pin { kernel: last, side, parts })
                            if *last == kernel && *side == now =>
                        {
                            parts[column % 3] = true;
                        }
                        _ => {
                            let parts = [0, 1].map(|part| column % 3 == part);
                            assignments.push(Assignment::Pin { kernel, side: now, parts });
                        }
                    }
                }
                Kernel::General { .. } => assignments.push(Assignment::General { kernel, column, entry }),
            }
        }
        for kernel in &mut kernels {
            match kernel {
                Kernel::Pin { row, is_loop: of_loop, .. } => *of_loop = is_loop[*row] || is_loop[*row + 1],
                Kernel::General { row, is_loop: of_loop, .. } => *of_loop = is_loop[*row],
            }
        }
        let loops: Vec<usize> = (0..rows.len()).filter(|&row| is_loop[row]).collect();
        let scale = |row: &usize| {
            let constant = shapes[*row].iter().filter_map(|(_, entry)| *entry);
            constant.fold(0.0f64, |most, entry| most.max(entry.abs()))
        };
        let mut is_constant: Vec<bool> = entries.iter().map(|entry| *entry != 0.0).collect();
        for kernel in &kernels {
            if let Kernel::General { row, is_constant: false, .. }
            | Kernel::General { row, is_loop: true, .. } = kernel
            {
                for (_, place) in &rows[*row] {
                    is_constant[*place] = false;
                }
            }
        }
        let [tree_angles, tree_origins] = numbered(&tree);
        Self {
            loop_scales: loops.iter().map(scale).collect(),
            rows,
            entries,
            is_constant,
            explicit,
            loops,
            tree,
            tree_angles,
            tree_origins,
            kernels,
            assignments,
            bodies,
            length,
        }
    }

    /// The same with the loop equations and the tree coordinates in another order, given by their present numbers.
    pub(in super::super) fn rearranged(&self, loops: &[usize], tree: &[usize]) -> Self {
        let tree: Vec<usize> = tree.iter().map(|&number| self.tree[number]).collect();
        let [tree_angles, tree_origins] = numbered(&tree);
        Self {
            loop_scales: loops.iter().map(|&row| self.loop_scales[row]).collect(),
            loops: loops.iter().map(|&row| self.loops[row]).collect(),
            tree,
            tree_angles,
            tree_origins,
            ..self.clone()
        }
    }
}

/// The angles among the tree coordinates, by their body and their number, and the others, by number and column.
fn numbered(tree: &[usize]) -> [Vec<(usize, usize)>; 2] {
    let (angles, origins): (Vec<_>, Vec<_>) =
        tree.iter().copied().enumerate().partition(|(_, column)| column % 3 == 2);
    [angles.into_iter().map(|(number, column)| (column / 3, number)).collect(), origins]
}

/// The two points of a pin, if these equations of joints begin with those of one.
fn pin(equations: &[Equation]) -> Option<[BodyPoint; 2]> {
    let component = |equation: &Equation, along: [f64; 2]| match equation.terms[..] {
        [
            ConstraintTerm {
                weight: 1.0,
                measure: RelativeCoordinate::Component { direction, from, to },
                function: None,
            },
        ] if direction == along && from.on != to.on && equation.constant == Some(0.0) => Some([from, to]),
        _ => None,
    };
    let [x, y, ..] = equations else { return None };
    let points = component(x, [1.0, 0.0])?;
    (component(y, [0.0, 1.0])? == points).then_some(points)
}

/// The columns of an equation in ascending order, and their Jacobian entries where these are constant.
fn shape(equation: &Equation, length: f64) -> Vec<(usize, Option<f64>)> {
    let mut shape: Vec<(usize, Option<f64>)> = Vec::new();
    let mut add = |frame: BodyFrame, part: usize, entry: Option<f64>| {
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
    for ConstraintTerm { weight, measure, function } in &equation.terms {
        let constant = |entry: f64| function.is_none().then_some(weight * entry);
        let arm = |point: BodyPoint| if point.at == [0.0, 0.0] { Some(0.0) } else { None };
        match *measure {
            RelativeCoordinate::Angle { of, against } => {
                add(of, 2, constant(1.0 / length));
                add(against, 2, constant(-1.0 / length));
            }
            RelativeCoordinate::Component { direction: [ux, uy], from, to } => {
                for (part, u) in [ux, uy].into_iter().enumerate() {
                    if u != 0.0 {
                        add(from.on, part, constant(-u));
                        add(to.on, part, constant(u));
                    }
                }
                add(from.on, 2, arm(from));
                add(to.on, 2, arm(to));
            }
            RelativeCoordinate::Along { direction: [ux, uy], from, to } => {
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
            RelativeCoordinate::Distance { from, to } | RelativeCoordinate::Bearing { from, to } => {
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

/// The explicit equations, in an order in which they use only what is known, and the columns that remain.
///
/// Angles come first. An origin follows from a pin whose other body is known; where no equation has one unknown alone,
/// a coordinate of the equation with fewest unknowns becomes a tree coordinate.
fn explicit(shapes: &[Vec<(usize, Option<f64>)>], columns: usize) -> (Vec<Explicit>, Vec<usize>) {
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
            explicit.push(Explicit { row, column, entry });
            used[row] = true;
            for (column, _) in shape {
                settled[*column] = true;
            }
        }
    }
    let is_explicit: Vec<usize> = explicit.iter().map(|explicit: &Explicit| explicit.column).collect();
    let mut tree: Vec<usize> =
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
            // No equation has one unknown: of the equation with fewest unknown columns all but one are tree.
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
            tree.extend(left.iter().map(|(column, _)| *column));
            explicit.push(Explicit { row, column, entry });
        }
    }
    tree.extend((0..columns).filter(|&column| !known[column]));
    tree.sort_unstable();
    (explicit, tree)
}
