//! The matrices of a whole rotor.

use super::{Coefficients, Hold, Plane, Rotor, RotorError, Support, element};

/// The matrices of a rotor in one plane, and its supports.
#[derive(Debug, Clone, PartialEq)]
pub struct Assembled {
    /// Mass of shaft and discs.
    pub mass: Plane,
    /// Polar inertia of shaft and discs: `Ω G` couples the planes.
    pub gyroscopic: Plane,
    /// Stiffness of the shaft, its tension included, without bearings.
    pub stiffness: Plane,
    /// Internal viscous damping `Hᵥ`; `Ω Hᵥ` is circulatory too.
    pub viscous: Plane,
    /// Circulatory matrix `Hₕ` of internal hysteretic damping.
    pub hysteretic: Plane,
    /// What holds the shaft.
    pub supports: Vec<Support>,
    /// Freedoms of a plane that do not move.
    pub fixed: Vec<usize>,
    /// Nodes that carry a disc.
    pub(super) discs: Vec<usize>,
    /// Distances of the nodes from the left end, m.
    pub positions: Vec<f64>,
    /// Whether a matrix of internal damping is there.
    pub(super) internal: bool,
}

impl Assembled {
    /// Adds up elements, discs and supports.
    ///
    /// # Errors
    /// `Value` and `Node`.
    pub fn new(rotor: &Rotor) -> Result<Self, RotorError> {
        let nodes = rotor.nodes();
        if rotor.elements.is_empty() {
            return Err(RotorError::Value { what: "the number of elements", value: 0.0 });
        }
        let at = |node: usize| {
            if node < nodes { Ok(node) } else { Err(RotorError::Node { node, last: nodes - 1 }) }
        };
        let zeros = Plane::zeros(nodes);
        let mut all = Self {
            mass: zeros.clone(),
            gyroscopic: zeros.clone(),
            stiffness: zeros.clone(),
            viscous: zeros.clone(),
            hysteretic: zeros,
            supports: rotor.supports.clone(),
            fixed: Vec::new(),
            discs: rotor.discs.iter().map(|disc| disc.node).collect(),
            positions: rotor.positions(),
            internal: false,
        };
        for (n, element) in rotor.elements.iter().enumerate() {
            let matrices = element::matrices(element, rotor.theory)?;
            let (viscous, loss) = (element.material.viscous_damping, element.material.loss_factor);
            let phase = loss.hypot(1.0);
            all.mass.add(n, &matrices.mass, 1.0);
            all.gyroscopic.add(n, &matrices.gyroscopic, 1.0);
            all.stiffness.add(n, &matrices.elastic, (1.0 + loss) / phase);
            all.stiffness.add(n, &matrices.geometric, rotor.tension);
            all.viscous.add(n, &matrices.elastic, viscous);
            all.hysteretic.add(n, &matrices.elastic, loss / phase);
            all.internal |= viscous != 0.0 || loss != 0.0;
        }
        for disc in &rotor.discs {
            let block = at(disc.node)?;
            all.mass.diagonal[block][(0, 0)] += disc.mass;
            all.mass.diagonal[block][(1, 1)] += disc.diametral;
            all.gyroscopic.diagonal[block][(1, 1)] += disc.polar;
        }
        for support in &rotor.supports {
            let node = at(support.node)?;
            match support.hold {
                Hold::Bearing(_) => {}
                Hold::Pinned => all.fixed.push(2 * node),
                Hold::Clamped => all.fixed.extend([2 * node, 2 * node + 1]),
            }
        }
        all.fixed.sort_unstable();
        all.fixed.dedup();
        for &freedom in &all.fixed {
            let own = all.stiffness.diagonal[freedom / 2][(freedom % 2, freedom % 2)];
            all.stiffness.fix(freedom, own);
            for plane in [&mut all.mass, &mut all.gyroscopic, &mut all.viscous, &mut all.hysteretic] {
                plane.fix(freedom, 0.0);
            }
        }
        let wild = [&all.mass, &all.stiffness, &all.viscous, &all.hysteretic]
            .into_iter()
            .flat_map(|plane| plane.diagonal.iter().flatten())
            .copied()
            .find(|x| !x.is_finite());
        match wild {
            Some(value) => Err(RotorError::Value { what: "a matrix of the rotor", value }),
            None => Ok(all),
        }
    }

    /// The number of nodes.
    pub fn nodes(&self) -> usize {
        self.positions.len()
    }

    /// The bearings that can move, with their coefficients at a speed.
    pub(super) fn bearings(&self, speed: f64) -> impl Iterator<Item = (usize, Coefficients)> {
        self.supports.iter().filter_map(move |support| {
            let free = !self.fixed.contains(&(2 * support.node));
            support.at(speed).filter(|_| free).map(|here| (support.node, here))
        })
    }
}
