//! Complete balance with unknowns among products mass × radius, angles and positions.

use std::f64::consts::TAU;

/// A mass of which something may be unknown.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PartlyKnown {
    /// Mass times radius, kg·m.
    pub product: Option<f64>,
    /// Angle, rad.
    pub angle: Option<f64>,
    /// Position along the shaft, m.
    pub position: Option<f64>,
}

/// A mass of a balanced rotor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RotorMass {
    /// Mass times radius, kg·m, not negative.
    pub product: f64,
    /// Angle, rad, in `[0, 2π)` where it was unknown.
    pub angle: f64,
    /// Position along the shaft, m.
    pub position: f64,
}

/// Resultants that must vanish.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Vanishing {
    /// The sum of unbalances: two equations. Positions do not matter.
    Force,
    /// The sum of unbalances and that of their moments: four equations.
    ForceAndCouple,
}

/// Reason for which there is no balance.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum UnknownsError {
    /// There are not as many unknowns as equations.
    #[error("{unknowns} unknowns for {equations} equations; there must be as many unknowns as equations")]
    Count {
        /// Unknowns.
        unknowns: usize,
        /// Equations.
        equations: usize,
    },
    /// No angle is known: the rotor may be turned as a whole.
    #[error("no angle is known, so the whole rotor may be turned; give one angle")]
    NoDatum,
    /// No product is known: all may be multiplied alike.
    #[error("no product of mass and radius is known, so all may grow alike; give one")]
    NoScale,
    /// Fewer than two different positions are known: the rotor may be moved or stretched as a whole.
    #[error("fewer than two different positions are known, so the rotor may be stretched; give two")]
    NoLength,
    /// Nothing that was tried makes the sums vanish.
    #[error("no values of the unknowns make the sums vanish")]
    Contradiction,
    /// The sums vanish for a whole range of the unknowns.
    #[error("a whole range of the unknowns makes the sums vanish")]
    NotDetermined,
    /// The sums vanish only with a mass to be taken off at its given angle.
    #[error("mass {0} would have to be negative")]
    Negative(
        /// The row of the mass, counted from 1.
        usize,
    ),
    /// An input is NaN, infinite or beyond the range of numbers.
    #[error("an input is not finite")]
    NotFinite,
}

/// Unknown of a mass, and the form in which it enters the equations.
#[derive(Clone, Copy)]
enum UnknownKind {
    /// Component along x (0) or y (1): mr product and angle both unknown.
    Component(usize),
    /// Product mr, at a known angle and position.
    Product,
    /// Product mr, at a known angle but an unknown position; the moment is a separate unknown.
    Force,
    /// Product times position, at a known angle.
    Moment,
    /// Angular position.
    Angle,
    /// Axial position.
    Position,
}

/// A mass in units of the largest product and of half the length, as the iteration changes it.
#[derive(Clone, Copy)]
struct UnknownRotor {
    unbalance: [f64; 2],
    /// Position, or for an unknown product at an unknown position nothing.
    position: f64,
    /// The direction of a known angle, or of the present one.
    direction: [f64; 2],
    /// Moment apart from the position, where it is sought apart.
    moment: Option<f64>,
}

/// All balances of a rotor with as many unknowns as equations that Newton's method finds from a grid of starts
/// dense enough for the at most a few solutions such a rotor has, ordered by the unknown angles; each makes the
/// sums vanish to rounding.
///
/// Products and angles that are both unknown are sought as components, products and positions at a known angle as
/// force and moment: the equations are linear in these, so that only angles of known products, and positions of
/// unknown angles, make them curved.
///
/// # Errors
/// [`UnknownsError`].
pub fn balance_unknowns(
    masses: &[PartlyKnown],
    vanishing: Vanishing,
) -> Result<Vec<Vec<RotorMass>>, UnknownsError> {
    let both = vanishing == Vanishing::ForceAndCouple;
    let equations = if both { 4 } else { 2 };
    let unknowns = masses.iter().map(|m| {
        usize::from(m.product.is_none())
            + usize::from(m.angle.is_none())
            + usize::from(both && m.position.is_none())
    });
    let unknowns = unknowns.sum();
    if unknowns != equations {
        return Err(UnknownsError::Count { unknowns, equations });
    }
    if masses.iter().all(|m| m.angle.is_none()) {
        return Err(UnknownsError::NoDatum);
    }
    let scale = masses.iter().filter_map(|m| m.product).fold(0.0, f64::max);
    if scale == 0.0 {
        return Err(UnknownsError::NoScale);
    }
    let positions = || masses.iter().filter_map(|m| m.position);
    let low = positions().fold(f64::INFINITY, f64::min);
    let high = positions().fold(f64::NEG_INFINITY, f64::max);
    if both && low >= high {
        return Err(UnknownsError::NoLength);
    }
    let (middle, half) = if both { (low / 2.0 + high / 2.0, high / 2.0 - low / 2.0) } else { (0.0, 1.0) };
    let finite = |x: Option<f64>| x.is_none_or(f64::is_finite);
    if !masses.iter().all(|m| finite(m.product) && finite(m.angle) && finite(m.position))
        || !half.is_finite()
        || scale < 1e-250
        || half < 1e-250
    {
        return Err(UnknownsError::NotFinite);
    }
    let own = |m: &PartlyKnown| PartlyKnown {
        product: m.product.map(|p| p / scale),
        angle: m.angle,
        position: if both { m.position.map(|z| (z - middle) / half) } else { Some(0.0) },
    };
    let scaled: Vec<PartlyKnown> = masses.iter().map(own).collect();
    let search = Search { masses: &scaled, sought: sought(&scaled), equations };
    let solutions = search.solutions()?;
    let back = |states: Vec<UnknownRotor>| {
        let one = |(m, s): (&PartlyKnown, UnknownRotor)| {
            let size = s.unbalance[0].hypot(s.unbalance[1]);
            RotorMass {
                product: m.product.unwrap_or(size * scale),
                angle: m.angle.unwrap_or_else(|| s.unbalance[1].atan2(s.unbalance[0]).rem_euclid(TAU)),
                position: m.position.unwrap_or(middle + half * s.position),
            }
        };
        masses.iter().zip(states).map(one).collect::<Vec<RotorMass>>()
    };
    let mut all: Vec<Vec<RotorMass>> = solutions.into_iter().map(back).collect();
    let order = |solution: &[RotorMass]| {
        let angles = masses.iter().zip(solution).filter(|(m, _)| m.angle.is_none()).map(|(_, k)| k.angle);
        angles.chain(solution.iter().map(|k| (k.position - middle) / half)).collect::<Vec<f64>>()
    };
    all.sort_by(|a, b| {
        order(a)
            .partial_cmp(&order(b))
            .expect("what was found was checked against its equations, so it is no NaN")
    });
    Ok(all)
}

fn sought(masses: &[PartlyKnown]) -> Vec<(usize, UnknownKind)> {
    let of = |(row, m): (usize, &PartlyKnown)| {
        let mut all = Vec::new();
        match (m.product, m.angle, m.position) {
            (None, None, _) => all.extend([UnknownKind::Component(0), UnknownKind::Component(1)]),
            (None, Some(_), Some(_)) => all.push(UnknownKind::Product),
            (None, Some(_), None) => all.extend([UnknownKind::Force, UnknownKind::Moment]),
            (Some(_), None, _) => all.push(UnknownKind::Angle),
            (Some(_), Some(_), _) => {}
        }
        if m.position.is_none() && !(m.product.is_none() && m.angle.is_some()) {
            all.push(UnknownKind::Position);
        }
        all.into_iter().map(move |what| (row, what)).collect::<Vec<_>>()
    };
    masses.iter().enumerate().flat_map(of).collect()
}

struct Search<'m> {
    masses: &'m [PartlyKnown],
    sought: Vec<(usize, UnknownKind)>,
    equations: usize,
}

/// The sums of unbalances and of moments, along x and y.
type Sums = [f64; 4];

impl Search<'_> {
    fn solutions(&self) -> Result<Vec<Vec<UnknownRotor>>, UnknownsError> {
        let curved = |what: &UnknownKind| matches!(what, UnknownKind::Angle);
        let angles = self.sought.iter().filter(|(_, what)| curved(what)).count();
        let per_angle = [1, 12, 8, 6, 5][angles.min(4)];
        let bent = |row: usize| self.masses[row].angle.is_none() && self.masses[row].position.is_none();
        let places = self.masses.iter().enumerate().filter(|(row, _)| bent(*row)).count();
        let per_place: usize = if places > 0 { 4 } else { 1 };
        let mut found: Vec<Vec<UnknownRotor>> = Vec::new();
        let (mut singular, mut negative) = (false, None);
        let starts = usize::pow(per_angle, angles as u32) * usize::pow(per_place, places as u32);
        for start in 0..starts {
            let mut rest = start;
            let mut next = |among: usize| {
                let at = rest % among;
                rest /= among;
                at as f64 / among as f64
            };
            let mut states: Vec<UnknownRotor> = self.masses.iter().map(begin).collect();
            for &(row, what) in &self.sought {
                match what {
                    UnknownKind::Angle => {
                        let angle = TAU * next(per_angle) + 0.3;
                        let size = self.masses[row].product.unwrap_or(1.0);
                        states[row].direction = [angle.cos(), angle.sin()];
                        states[row].unbalance = states[row].direction.map(|c| size * c);
                    }
                    UnknownKind::Position if bent(row) => states[row].position = 2.6 * next(per_place) - 1.1,
                    _ => {}
                }
            }
            // Full steps go straight through where the equations say little; short ones reach what those leap over.
            match self.newton(states.clone(), false).or_else(|| self.newton(states, true)) {
                Some((_, false)) => singular = true,
                Some((states, true)) => match self.first_negative(&states) {
                    Some(row) => negative = Some(row + 1),
                    None => {
                        if !found.iter().any(|known| same(known, &states)) {
                            found.push(states);
                        }
                    }
                },
                None => {}
            }
        }
        match (found.is_empty(), negative, singular) {
            (false, _, _) => Ok(found),
            (true, Some(row), _) => Err(UnknownsError::Negative(row)),
            (true, None, true) => Err(UnknownsError::NotDetermined),
            (true, None, false) => Err(UnknownsError::Contradiction),
        }
    }

    /// The first mass whose unbalance points against its known angle.
    fn first_negative(&self, states: &[UnknownRotor]) -> Option<usize> {
        let against = |(m, s): (&PartlyKnown, &UnknownRotor)| {
            m.product.is_none()
                && m.angle.is_some()
                && s.unbalance[0] * s.direction[0] + s.unbalance[1] * s.direction[1] < -1e-12
        };
        self.masses.iter().zip(states).position(against)
    }

    fn sums(&self, states: &[UnknownRotor]) -> Sums {
        let mut sums = [0.0; 4];
        for s in states {
            let moment = match s.moment {
                Some(moment) => s.direction.map(|c| moment * c),
                None => s.unbalance.map(|u| u * s.position),
            };
            for axis in 0..2 {
                sums[axis] += s.unbalance[axis];
                sums[2 + axis] += moment[axis];
            }
        }
        if self.equations == 2 { [sums[0], sums[1], 0.0, 0.0] } else { sums }
    }

    /// Partial derivative of the sums with respect to one unknown.
    fn slope(states: &[UnknownRotor], (row, what): (usize, UnknownKind)) -> Sums {
        let UnknownRotor { unbalance: [x, y], position: z, direction: [c, s], .. } = states[row];
        match what {
            UnknownKind::Component(0) => [1.0, 0.0, z, 0.0],
            UnknownKind::Component(_) => [0.0, 1.0, 0.0, z],
            UnknownKind::Product => [c, s, c * z, s * z],
            UnknownKind::Force => [c, s, 0.0, 0.0],
            UnknownKind::Moment => [0.0, 0.0, c, s],
            UnknownKind::Angle => [-y, x, -y * z, x * z],
            UnknownKind::Position => [0.0, 0.0, x, y],
        }
    }

    fn moved(&self, states: &[UnknownRotor], step: &Sums, part: f64) -> Vec<UnknownRotor> {
        let mut moved = states.to_vec();
        for (&(row, what), by) in self.sought.iter().zip(step) {
            let (by, state) = (part * by, &mut moved[row]);
            match what {
                UnknownKind::Component(axis) => state.unbalance[axis] += by,
                UnknownKind::Product | UnknownKind::Force => {
                    let along =
                        state.unbalance[0] * state.direction[0] + state.unbalance[1] * state.direction[1];
                    state.unbalance = state.direction.map(|c| (along + by) * c);
                }
                UnknownKind::Moment => state.moment = Some(state.moment.unwrap_or(0.0) + by),
                UnknownKind::Angle => {
                    let angle = state.direction[1].atan2(state.direction[0]) + by;
                    let size = self.masses[row].product.unwrap_or(1.0);
                    state.direction = [angle.cos(), angle.sin()];
                    state.unbalance = state.direction.map(|c| size * c);
                }
                UnknownKind::Position => state.position += by,
            }
        }
        moved
    }

    /// A balance from a start, and whether the equations determine it; `None` where the iteration goes astray.
    /// Held, every step brings the sums nearer to zero.
    fn newton(&self, mut states: Vec<UnknownRotor>, held: bool) -> Option<(Vec<UnknownRotor>, bool)> {
        let mut left = self.sums(&states);
        let mut settled = 0;
        let mut sharp = false;
        for _ in 0..60 {
            let (step, pivot) = self.step(&states, &left)?;
            sharp = pivot > 1e-7;
            let mut part = 1.0;
            let (next, after) = loop {
                let next = self.moved(&states, &step, part);
                let after = self.sums(&next);
                if !held || length(&after) < length(&left) || length(&left) < 1e-12 || part < 1e-3 {
                    break (next, after);
                }
                part /= 2.0;
            };
            (states, left) = (next, after);
            if !length(&left).is_finite() || states.iter().any(|s| s.position.abs() > 1e6) {
                return None;
            }
            let scale: f64 = states
                .iter()
                .map(|s| {
                    (1.0 + s.position.abs()) * s.unbalance[0].hypot(s.unbalance[1])
                        + s.moment.unwrap_or(0.0).abs()
                })
                .sum();
            if length(&left) <= 1e-13 * scale.max(1.0) {
                settled += 1;
                if settled == 3 {
                    break;
                }
            }
        }
        if settled == 0 {
            return None;
        }
        for state in &mut states {
            if let Some(moment) = state.moment {
                let force = state.unbalance[0] * state.direction[0] + state.unbalance[1] * state.direction[1];
                // Without a force no position gives the moment.
                if force.abs() < 1e-12 {
                    return None;
                }
                state.position = moment / force;
            }
        }
        Some((states, sharp))
    }

    /// Newton's step, by elimination with complete choice of rows, and the least pivot over the largest.
    fn step(&self, states: &[UnknownRotor], left: &Sums) -> Option<(Sums, f64)> {
        let n = self.equations;
        let mut a = [[0.0; 5]; 4];
        for (column, &of) in self.sought.iter().enumerate() {
            let slope = Self::slope(states, of);
            for row in 0..n {
                a[row][column] = slope[row];
            }
        }
        for row in 0..n {
            a[row][4] = -left[row];
        }
        let largest = a[..n].iter().flat_map(|row| &row[..n]).fold(0.0f64, |m, x| m.max(x.abs()));
        let mut least = f64::INFINITY;
        for k in 0..n {
            let pivot = (k..n).max_by(|i, j| a[*i][k].abs().total_cmp(&a[*j][k].abs()))?;
            a.swap(k, pivot);
            least = least.min(a[k][k].abs() / largest);
            if a[k][k].abs() <= 1e-14 * largest {
                // A start where the equations say nothing of an unknown is left by a small push.
                a[k][k] = 1e-3;
            }
            for i in k + 1..n {
                let factor = a[i][k] / a[k][k];
                for j in k..5 {
                    a[i][j] -= factor * a[k][j];
                }
            }
        }
        let mut x = [0.0; 4];
        for k in (0..n).rev() {
            let sum: f64 = (k + 1..n).map(|j| a[k][j] * x[j]).sum();
            x[k] = (a[k][4] - sum) / a[k][k];
        }
        x.iter().all(|x| x.is_finite()).then_some((x, least))
    }
}

/// A mass before the first step: what is unknown of it has a place to begin.
fn begin(m: &PartlyKnown) -> UnknownRotor {
    let angle = m.angle.unwrap_or(1.0);
    let direction = [angle.cos(), angle.sin()];
    let size = m.product.unwrap_or(0.7);
    let apart = m.product.is_none() && m.angle.is_some() && m.position.is_none();
    UnknownRotor {
        unbalance: direction.map(|c| size * c),
        position: m.position.unwrap_or(0.0),
        direction,
        moment: apart.then_some(0.0),
    }
}

fn length(sums: &Sums) -> f64 {
    sums.iter().map(|x| x * x).sum::<f64>().sqrt()
}

fn same(a: &[UnknownRotor], b: &[UnknownRotor]) -> bool {
    let near = |(a, b): (&UnknownRotor, &UnknownRotor)| {
        (a.unbalance[0] - b.unbalance[0]).hypot(a.unbalance[1] - b.unbalance[1]) < 1e-6
            && (a.position - b.position).abs() < 1e-6 * (1.0 + a.position.abs())
    };
    a.iter().zip(b).all(near)
}
