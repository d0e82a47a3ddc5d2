//! The parts of a network of springs, linear or torsional.

use dalembert_core::{Symbol, Text, Worksheet};
use dalembert_mechanics::{Real, spring};

use crate::sources::RAO;

/// A spring or a part of a network, with its stiffness.
pub(crate) struct Element<N> {
    /// Path in the network, rows counted from 1: that of `k₁,₂` is `[1, 2]`.
    pub(crate) place: Vec<usize>,
    /// Name of the type of the element.
    pub(crate) label: &'static str,
    /// Type of motion: translation or rotation.
    pub(crate) motion: SpringMotion,
    /// Stiffness, N/m or N·m/rad.
    pub(crate) stiffness: N,
    /// Connection of its members: series or parallel.
    pub(crate) joined: Joined<N>,
}

/// Connection of the members of an element.
pub(crate) enum Joined<N> {
    /// It has none.
    Alone,
    /// End to end.
    Series(Vec<Element<N>>),
    /// Side by side.
    Parallel(Vec<Element<N>>),
    /// Side by side behind a lever or gears: what the members move for the motion of the whole.
    Through(N, Vec<Element<N>>),
}

/// Type of motion of springs: translation or rotation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum SpringMotion {
    /// Along a line: forces and deflections.
    Translation,
    /// About an axis: torques and angles of twist.
    Rotation,
}

impl SpringMotion {
    /// The symbol of a stiffness.
    pub(crate) fn symbol(self) -> &'static str {
        match self {
            SpringMotion::Translation => "k",
            SpringMotion::Rotation => "k_t",
        }
    }

    /// The unit of a stiffness.
    pub(crate) fn unit(self) -> &'static str {
        match self {
            SpringMotion::Translation => "kN/m",
            SpringMotion::Rotation => "N*m/rad",
        }
    }
}

/// A symbol with the rows of a place.
pub(crate) fn symbol(base: &'static str, place: &[usize]) -> Symbol {
    place.iter().fold(Symbol::from(base), |symbol, row| symbol.row(*row))
}

/// Writer of the steps of an element of a network.
pub(super) struct Build<'p, W> {
    pub(super) motion: SpringMotion,
    pub(super) place: &'p [usize],
    pub(super) label: &'static str,
    pub(super) sheet: W,
}

impl<W: Worksheet> Build<'_, W> {
    pub(super) fn alone(self, stiffness: W::Num) -> Element<W::Num> {
        self.element(stiffness, Joined::Alone)
    }

    pub(super) fn series(self, members: Vec<Element<W::Num>>) -> Element<W::Num> {
        let why = match self.motion {
            SpringMotion::Translation => "Springs in series: the deflections add up",
            SpringMotion::Rotation => "Torsional springs in series: the angles of twist add up",
        };
        if members.len() > 1 {
            let added = || spring::parallel(members.iter().map(|member| member.stiffness));
            self.common_error("the springs combined as if in parallel", &added);
        }
        let k = self.step(spring::series(members.iter().map(|member| member.stiffness)), why);
        self.element(k, Joined::Series(members))
    }

    pub(super) fn parallel(self, members: Vec<Element<W::Num>>) -> Element<W::Num> {
        let why = match self.motion {
            SpringMotion::Translation => "Springs in parallel: the forces add up",
            SpringMotion::Rotation => "Torsional springs in parallel: the torques add up",
        };
        if members.len() > 1 {
            let chained = || spring::series(members.iter().map(|member| member.stiffness));
            self.common_error("the springs combined as if in series", &chained);
        }
        let k = self.step(spring::parallel(members.iter().map(|member| member.stiffness)), why);
        self.element(k, Joined::Parallel(members))
    }

    /// Members side by side that move `ratio` times what the whole moves.
    pub(super) fn reflected_stiffness(
        self,
        ratio: W::Num,
        why: &'static str,
        members: Vec<Element<W::Num>>,
    ) -> Element<W::Num> {
        let ratio = self.sheet.step(symbol("i", self.place), "1", ratio, why);
        let behind = spring::parallel(members.iter().map(|member| member.stiffness));
        let backwards = || behind / ratio.powi(2);
        self.common_error("the stiffness reflected to the wrong side, by the inverse ratio", &backwards);
        if members.len() > 1 {
            let chained = || spring::series(members.iter().map(|member| member.stiffness));
            let reflected = || spring::reflected_stiffness(chained(), ratio);
            self.common_error("the springs combined as if in series", &reflected);
        }
        let k = self.step(
            spring::reflected_stiffness(behind, ratio),
            "Both store the same energy, so the stiffness varies as the square of the ratio",
        );
        self.element(k, Joined::Through(ratio, members))
    }

    fn common_error(&self, what: &'static str, wrong: &dyn Fn() -> W::Num) {
        self.sheet.common_error(symbol(self.motion.symbol(), self.place), what, wrong);
    }

    fn step(&self, stiffness: W::Num, why: &'static str) -> W::Num {
        let cited = (Text::from(why), RAO.at("§1.7"));
        self.sheet.step(symbol(self.motion.symbol(), self.place), self.motion.unit(), stiffness, cited)
    }

    fn element(self, stiffness: W::Num, joined: Joined<W::Num>) -> Element<W::Num> {
        let Self { motion, place, label, .. } = self;
        Element { place: place.to_vec(), label, motion, stiffness, joined }
    }
}
