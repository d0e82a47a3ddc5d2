//! Torsional vibration of a train by Holzer's method: discs on shafts, some of them fixed, without closed loops.
//!
//! Moments of inertia in kg·m², stiffnesses in N·m/rad, all reduced to one speed. A tree has a factorisation of
//! `K − ω²J` without fill and without a difference of stiffnesses, so low frequencies of stiff trains keep their
//! digits; its negative pivots count the frequencies below `ω` (Sylvester), so that none is missed. W. T. Thomson
//! and M. D. Dahleh, *Theory of Vibration with Applications*, 5th ed., ch. on lumped-parameter (Holzer) methods.

/// Reason for which a train has no answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum TrainError {
    /// There is no disc.
    #[error("there is no disc; give at least one with a moment of inertia")]
    Empty,
    /// More discs than are accepted.
    #[error("more than {MOST_DISCS} discs; join some of them")]
    TooMany,
    /// A number is not finite, or a sign is wrong, or a result leaves the range of numbers.
    #[error(
        "an inertia or a stiffness is negative, zero or too large to be computed with; write a usual one"
    )]
    NotFinite,
    /// A shaft joins a disc that does not exist, or a disc to itself.
    #[error("shaft {shaft} does not join two discs of the list")]
    Ends {
        /// The shaft, counted from 1.
        shaft: usize,
    },
    /// A shaft closes a loop.
    #[error("shaft {shaft} closes a loop; join parallel shafts into one")]
    Loop {
        /// The shaft, counted from 1.
        shaft: usize,
    },
    /// A disc hangs on nothing.
    #[error("disc {disc} is not joined to the first one")]
    Apart {
        /// The disc, counted from 1.
        disc: usize,
    },
    /// No disc has inertia.
    #[error("no disc has a moment of inertia; give one that has")]
    Massless,
    /// The frequency of the torque is a natural one.
    #[error("the frequency of the torques is a natural one, so the motion grows without bound")]
    Resonance,
}

/// The most discs of a train.
pub const MOST_DISCS: usize = 200;

/// A shaft between two discs, counted from 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TrainShaft {
    /// The discs.
    pub ends: [usize; 2],
    /// Torsional stiffness, N·m/rad.
    pub stiffness: f64,
}

/// Discs on shafts, joined as a tree.
#[derive(Debug, Clone, PartialEq)]
pub struct Train {
    inertias: Vec<f64>,
    walls: Vec<f64>,
    /// The shaft to the disc nearer to the first end, and its stiffness.
    towards: Vec<Option<(usize, f64)>>,
    /// Every disc after the one it hangs on.
    order: Vec<usize>,
    /// From the first end to the farthest one.
    main_shaft: Vec<usize>,
}

/// A way in which a train vibrates by itself.
#[derive(Debug, Clone, PartialEq)]
pub struct TorsionalMode {
    /// Natural frequency, rad/s; zero for the turning of the whole train.
    pub frequency: f64,
    /// The amplitude of each disc, reduced to the one speed; the largest is 1.
    pub shape: Vec<f64>,
}

/// A line of a Holzer table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HolzerRow {
    /// The disc, counted from 0.
    pub disc: usize,
    /// Amplitude, relative to that of the first disc.
    pub amplitude: f64,
    /// Inertia torque `J ω² θ`.
    pub inertia_torque: f64,
    /// The sizes of the torques of inertia, wall and side branches, which may cancel in it.
    pub size: f64,
    /// The torque in the shaft that leads on: the sum of all inertia torques so far.
    pub shaft_torque: f64,
    /// The twist of that shaft; zero at the end.
    pub twist: f64,
}

impl Train {
    /// A train, a moment of inertia for each disc; `walls` holds the stiffness of shafts from each disc to fixed ground,
    /// zero for none. Moments of inertia may be zero.
    ///
    /// # Errors
    /// All of [`TrainError`] but `Resonance`.
    pub fn new(inertias: &[f64], walls: &[f64], shafts: &[TrainShaft]) -> Result<Self, TrainError> {
        let n = inertias.len();
        if n == 0 || walls.len() != n {
            return Err(TrainError::Empty);
        }
        if n > MOST_DISCS {
            return Err(TrainError::TooMany);
        }
        let usual = |x: &f64| x.is_finite() && *x >= 0.0;
        let stiffnesses = shafts.iter().all(|shaft| shaft.stiffness.is_finite() && shaft.stiffness > 0.0);
        if !inertias.iter().all(usual) || !walls.iter().all(usual) || !stiffnesses {
            return Err(TrainError::NotFinite);
        }
        if inertias.iter().all(|inertia| *inertia == 0.0) {
            return Err(TrainError::Massless);
        }
        let mut joined = vec![Vec::new(); n];
        for (at, &TrainShaft { ends: [a, b], stiffness }) in shafts.iter().enumerate() {
            if a >= n || b >= n || a == b {
                return Err(TrainError::Ends { shaft: at + 1 });
            }
            joined[a].push((b, stiffness, at));
            joined[b].push((a, stiffness, at));
        }
        let first = (0..n).find(|&disc| joined[disc].len() <= 1).unwrap_or(0);
        let mut towards = vec![None; n];
        let mut depth = vec![None; n];
        let mut order = vec![first];
        depth[first] = Some(0);
        let mut next = 0;
        while let Some(&disc) = order.get(next) {
            next += 1;
            for &(other, stiffness, at) in &joined[disc] {
                if depth[other].is_none() {
                    depth[other] = depth[disc].map(|depth: usize| depth + 1);
                    towards[other] = Some((disc, stiffness, at));
                    order.push(other);
                } else if towards[disc].is_none_or(|(_, _, up)| up != at)
                    && towards[other].is_none_or(|(_, _, up)| up != at)
                {
                    return Err(TrainError::Loop { shaft: at + 1 });
                }
            }
        }
        if let Some(disc) = depth.iter().position(Option::is_none) {
            return Err(TrainError::Apart { disc: disc + 1 });
        }
        let mut end = (0..n).max_by_key(|&disc| (depth[disc], disc));
        let mut main_shaft = Vec::new();
        while let Some(disc) = end {
            main_shaft.push(disc);
            end = towards[disc].map(|(up, _, _)| up);
        }
        main_shaft.reverse();
        let towards = towards.into_iter().map(|up| up.map(|(disc, k, _)| (disc, k))).collect();
        Ok(Self { inertias: inertias.to_vec(), walls: walls.to_vec(), towards, order, main_shaft })
    }

    /// Returns true if the discs form one unbranched line.
    pub fn is_chain(&self) -> bool {
        self.main_shaft.len() == self.inertias.len()
    }

    /// The discs from the first end to the farthest one, in order.
    pub fn main_shaft(&self) -> &[usize] {
        &self.main_shaft
    }

    /// Returns true if the train is unrestrained, with a rigid-body rotation.
    pub fn is_free(&self) -> bool {
        self.walls.iter().all(|stiffness| *stiffness == 0.0)
    }

    /// The dynamic stiffness of what hangs beyond each disc, with the disc itself, and the number of natural
    /// frequencies below `√square`.
    fn beyond(&self, square: f64) -> (Vec<f64>, usize) {
        let mut stiffness: Vec<f64> =
            self.walls.iter().zip(&self.inertias).map(|(wall, inertia)| wall - inertia * square).collect();
        let mut below = 0;
        for &disc in self.order.iter().rev() {
            let Some((up, shaft)) = self.towards[disc] else {
                below += usize::from(stiffness[disc] < 0.0);
                continue;
            };
            below += usize::from(shaft + stiffness[disc] < 0.0);
            stiffness[up] += behind(shaft, stiffness[disc]);
        }
        (stiffness, below)
    }

    /// The number of natural frequencies below a frequency, the turning as a whole among them.
    pub fn count_below(&self, frequency: f64) -> usize {
        self.beyond(frequency.powi(2)).1
    }

    /// All modes, ascending, the turning of a free train first. Each frequency is bisected until neighbouring
    /// numbers enclose it; each shape is found by inverse iteration and made orthogonal to the earlier ones of
    /// nearly the same frequency.
    ///
    /// # Errors
    /// `NotFinite`.
    pub fn modes(&self) -> Result<Vec<TorsionalMode>, TrainError> {
        let n = self.inertias.len();
        let mut held = self.walls.clone();
        for disc in 0..n {
            if let Some((up, shaft)) = self.towards[disc] {
                held[disc] += shaft;
                held[up] += shaft;
            }
        }
        let bounds = held.iter().zip(&self.inertias).filter(|(_, inertia)| **inertia > 0.0);
        let highest = 2.0 * bounds.map(|(held, inertia)| held / inertia).fold(0.0, f64::max);
        if !highest.is_finite() {
            return Err(TrainError::NotFinite);
        }
        let count = self.inertias.iter().filter(|inertia| **inertia > 0.0).count();
        let mut modes: Vec<TorsionalMode> = Vec::new();
        if self.is_free() {
            modes.push(TorsionalMode { frequency: 0.0, shape: vec![1.0; n] });
        }
        for index in modes.len()..count {
            let (mut low, mut high) = (f64::MIN_POSITIVE.to_bits(), (highest * 1.001).to_bits());
            while high - low > 1 {
                let middle = u64::midpoint(low, high);
                if self.beyond(f64::from_bits(middle)).1 > index {
                    high = middle;
                } else {
                    low = middle;
                }
            }
            let square = f64::from_bits(low);
            let near = |mode: &&TorsionalMode| (mode.frequency.powi(2) - square).abs() <= 1e-6 * square;
            let neighbours: Vec<&TorsionalMode> = modes.iter().filter(near).collect();
            let shape = self.shape(square, &neighbours)?;
            modes.push(TorsionalMode { frequency: square.sqrt(), shape });
        }
        Ok(modes)
    }

    fn shape(&self, square: f64, neighbours: &[&TorsionalMode]) -> Result<Vec<f64>, TrainError> {
        // A start that no mode of a symmetric train is orthogonal to.
        let mut shape: Vec<f64> =
            (0..self.inertias.len()).map(|disc| 1.0 + (1.7 * disc as f64).sin() / 3.0).collect();
        // Of equal frequencies no shape is distinguished from another: a shift beside them treats them all alike, so that
        // the shapes found follow from the start and not from rounding.
        let several = self.beyond(square * (1.0 + 1e-12)).1 > self.beyond(square * (1.0 - 1e-12)).1 + 1;
        let (square, steps) = if several { (square * (1.0 - 1e-5), 10) } else { (square, 4) };
        for _ in 0..steps {
            self.remove(neighbours, &mut shape);
            let torques: Vec<f64> =
                shape.iter().zip(&self.inertias).map(|(amplitude, inertia)| amplitude * inertia).collect();
            shape = self.solved(square, &torques);
            let largest =
                shape.iter().fold(0.0, |largest: f64, x| if x.abs() > largest.abs() { *x } else { largest });
            for amplitude in &mut shape {
                *amplitude /= largest;
            }
            if !shape.iter().all(|x| x.is_finite()) {
                return Err(TrainError::NotFinite);
            }
        }
        self.remove(neighbours, &mut shape);
        Ok(shape)
    }

    /// Takes the parts along `modes` out of a shape.
    fn remove(&self, modes: &[&TorsionalMode], shape: &mut [f64]) {
        for mode in modes {
            let weighed = |other: &[f64]| -> f64 {
                (0..other.len()).map(|i| self.inertias[i] * mode.shape[i] * other[i]).sum()
            };
            let part = weighed(shape) / weighed(&mode.shape);
            shape.iter_mut().zip(&mode.shape).for_each(|(x, own)| *x -= part * own);
        }
    }

    /// The amplitudes that torques `T cos ωt` on the discs keep up, rad; a torque and an amplitude for each disc, in
    /// order.
    ///
    /// # Errors
    /// `Resonance` within `1e-12` of a natural frequency; `NotFinite`.
    pub fn steady(&self, torques: &[f64], frequency: f64) -> Result<Vec<f64>, TrainError> {
        let around = |factor: f64| self.beyond((frequency * factor).powi(2)).1;
        if around(1.0 - 1e-12) != around(1.0 + 1e-12) || (frequency == 0.0 && self.is_free()) {
            return Err(TrainError::Resonance);
        }
        let amplitudes = self.solved(frequency.powi(2), torques);
        if amplitudes.iter().all(|x| x.is_finite()) { Ok(amplitudes) } else { Err(TrainError::NotFinite) }
    }

    /// Solves `(K − ω² J) θ = T`; at a natural frequency, along its shape.
    fn solved(&self, square: f64, torques: &[f64]) -> Vec<f64> {
        let (stiffness, _) = self.beyond(square);
        let mut right = torques.to_vec();
        let safe = |pivot: f64, size: f64| if pivot == 0.0 { f64::EPSILON * size } else { pivot };
        for &disc in self.order.iter().rev() {
            if let Some((up, shaft)) = self.towards[disc] {
                right[up] += right[disc] * (shaft / safe(shaft + stiffness[disc], shaft));
            }
        }
        let mut amplitudes = vec![0.0; right.len()];
        for &disc in &self.order {
            amplitudes[disc] = match self.towards[disc] {
                Some((up, shaft)) => {
                    (right[disc] + shaft * amplitudes[up]) / safe(shaft + stiffness[disc], shaft)
                }
                None => right[disc] / safe(stiffness[disc], self.inertias[disc] * square + f64::MIN_POSITIVE),
            };
        }
        amplitudes
    }

    /// The Holzer table at a trial frequency, along the main shaft; what the side branches ask for at a junction counts
    /// as if it were part of the inertia torque there.
    pub fn holzer(&self, frequency: f64) -> Vec<HolzerRow> {
        let square = frequency.powi(2);
        let (stiffness, _) = self.beyond(square);
        let mut rows = Vec::with_capacity(self.main_shaft.len());
        let (mut amplitude, mut shaft_torque) = (1.0, 0.0);
        for (at, &disc) in self.main_shaft.iter().enumerate() {
            let next = self.main_shaft.get(at + 1);
            let own = self.inertias[disc] * square - self.walls[disc];
            let sides = || {
                (0..self.towards.len()).filter(|other| Some(other) != next).filter_map(|other| {
                    let (up, shaft) = self.towards[other]?;
                    (up == disc).then(|| behind(shaft, stiffness[other]))
                })
            };
            let inertia_torque = (own - sides().sum::<f64>()) * amplitude;
            let parts = self.inertias[disc] * square + self.walls[disc] + sides().map(f64::abs).sum::<f64>();
            let size = parts * amplitude.abs();
            shaft_torque += inertia_torque;
            let twist =
                next.and_then(|&next| self.towards[next]).map_or(0.0, |(_, shaft)| shaft_torque / shaft);
            rows.push(HolzerRow { disc, amplitude, inertia_torque, size, shaft_torque, twist });
            amplitude -= twist;
        }
        rows
    }

    /// Residual torque at the end of the main shaft, over the sum of the magnitudes of the torques: zero at a natural
    /// frequency, within −1 and 1.
    pub fn residual(&self, frequency: f64) -> f64 {
        let rows = self.holzer(frequency);
        let size: f64 = rows.iter().map(|row| row.size).sum();
        match rows.last() {
            Some(last) if size > 0.0 => last.shaft_torque / size,
            _ => 0.0,
        }
    }
}

/// Dynamic stiffness reflected through a shaft; a number as large as rounding allows where what hangs beyond is at its
/// own frequency with the near end held.
fn behind(shaft: f64, beyond: f64) -> f64 {
    let pivot = shaft + beyond;
    shaft * (beyond / if pivot == 0.0 { f64::EPSILON * shaft } else { pivot })
}
