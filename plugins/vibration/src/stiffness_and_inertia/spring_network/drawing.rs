//! The drawing of a network.

use std::collections::VecDeque;

use dalembert_core::{Drawing, Point, Sketch, Text};

use super::{ElementKind, SpringNetwork};
use crate::shared::letters::of_row;

/// Nodes in columns by their distance from ground, elements between them, the load at its node.
pub(super) fn drawing(problem: &SpringNetwork) -> Drawing {
    let at = places(problem);
    let rows = at.iter().fold(0.0, |rows: f64, at| rows.max(at.1));
    let mut sketch = Sketch::new("The network");
    sketch.ground((0.0, rows + 0.8), (0.0, -0.8));
    let mut drawn: Vec<[Option<usize>; 2]> = Vec::new();
    for (n, element) in problem.elements.iter().enumerate() {
        let mut ends = problem.ends(n);
        ends.sort();
        let beside = drawn.iter().filter(|other| **other == ends).count();
        drawn.push(ends);
        let [from, to] = problem.ends(n).map(|end| end.map(|node| at[node]));
        let (Some(from), to) = (from, to) else { continue };
        let to = to.unwrap_or((0.0, from.1));
        let shift = 0.45 * beside as f64;
        let (from, to) = ((from.0, from.1 + shift), (to.0, to.1 + shift));
        let name = |letter: &'static str| of_row(&[letter], n + 1);
        match &element.kind {
            ElementKind::Spring { .. } => sketch.spring(name("k"), from, to),
            ElementKind::Damper { .. } => sketch.damper(name("c"), from, to),
            ElementKind::KelvinVoigt { .. } => {
                sketch.spring_and_damper((name("k"), name("c")), from, to, 0.6)
            }
        };
    }
    for ((node, &(x, y)), row) in problem.nodes.iter().zip(&at).zip(1..) {
        match node.mass {
            Some(_) => {
                sketch.mass(of_row(&["m"], row), (x - 0.35, y - 0.5), (x + 0.35, y + 0.5));
            }
            None => {
                sketch.bars([(x, y - 0.4), (x, y + 0.4)]);
            }
        }
        let top = if node.mass.is_some() { y + 0.5 } else { y + 0.4 };
        sketch.label(Text::new("{x}").with("x", &node.name), (x, top));
    }
    let (x, y) = at[problem.loaded.0];
    sketch.force("F", (x + 0.35, y), (x + 1.2, y)).finish()
}

fn places(problem: &SpringNetwork) -> Vec<Point> {
    let count = problem.nodes.len();
    let mut depth: Vec<Option<u16>> = vec![None; count];
    let mut waiting = VecDeque::new();
    let links: Vec<[Option<usize>; 2]> = (0..problem.elements.len()).map(|n| problem.ends(n)).collect();
    for ends in &links {
        if let [Some(node), None] = *ends
            && depth[node].is_none()
        {
            depth[node] = Some(1);
            waiting.push_back(node);
        }
    }
    while let Some(node) = waiting.pop_front() {
        for ends in &links {
            if let [Some(a), Some(b)] = *ends {
                for (here, there) in [(a, b), (b, a)] {
                    if here == node && depth[there].is_none() {
                        depth[there] = depth[node].map(|depth| depth + 1);
                        waiting.push_back(there);
                    }
                }
            }
        }
    }
    let mut used: Vec<(u16, u16)> = Vec::new();
    depth
        .into_iter()
        .map(|depth| {
            let depth = depth.unwrap_or(1);
            let row = used.iter().filter(|(other, _)| *other == depth).count();
            used.push((depth, 0));
            (2.2 * f64::from(depth), 1.6 * row as f64)
        })
        .collect()
}
