//! Positions for weights around the rotor, and a correction split between two of them.

use dalembert_core::{Inputs, Text, Worksheet};
use dalembert_mechanics::Real;

use super::Found;
use crate::shared::{rotor, split};

/// Holes, bolts or blades around the rotor.
#[derive(Clone, Debug, Inputs)]
pub struct Positions {
    /// Number of positions.
    /// The same in every plane, at equal angles.
    #[input(min = 3, max = 1000)]
    pub count: usize,
    /// Angle of position number 1.
    /// The others follow in the sense of the trial-weight angles.
    #[input("θ₀", "deg", default = "0 deg")]
    pub start: f64,
}

/// The masses that are split: those to be mounted next.
#[derive(Clone, Copy)]
pub(super) enum SplitMass {
    /// The corrections, with every trial weight taken off.
    Correction,
    /// The masses that are added to the trial weights.
    Added,
    /// The trim after a check run.
    Trim,
}

impl SplitMass {
    /// Labels of the first position and its mass, and of the second and its mass.
    fn labels(self) -> [&'static str; 4] {
        match self {
            Self::Correction => [
                "Number of the first position of the correction mass in plane",
                "Correction mass at the first position in plane",
                "Number of the second position of the correction mass in plane",
                "Correction mass at the second position in plane",
            ],
            Self::Added => [
                "Number of the first position of the mass to add in plane",
                "Mass to add at the first position in plane",
                "Number of the second position of the mass to add in plane",
                "Mass to add at the second position in plane",
            ],
            Self::Trim => [
                "Number of the first position of the trim mass in plane",
                "Trim mass at the first position in plane",
                "Number of the second position of the trim mass in plane",
                "Trim mass at the second position in plane",
            ],
        }
    }
}

/// Splits the masses that are to be mounted next between adjacent positions.
pub(super) fn split<W: Worksheet>(
    positions: &Positions,
    given: &PositionsGiven<W>,
    (split_mass, masses): (SplitMass, &[Found<W::Num>]),
    sheet: W,
) {
    let labels = split_mass.labels();
    for (n, found) in (1..).zip(masses) {
        if found.mass.value() == 0.0 {
            continue;
        }
        let (whole, angle) = (found.mass.value(), found.angle.value());
        let adjacent = split::adjacent(positions.count, given.start.value(), angle);
        let at = adjacent.numbers.map(|number| given.start.value() + adjacent.pitch * (number - 1.0));
        // What rounding leaves at a position that needs nothing is nothing.
        let parts = split::parts(whole, angle, at).map(|part| if part < 1e-9 * whole { 0.0 } else { part });
        let how = "Number of the position, counted from 1";
        let numbers = [("N_a", adjacent.numbers[0]), ("N_b", adjacent.numbers[1])]
            .map(|(symbol, number)| sheet.numerical((symbol, n), "1", number, how));
        let how = "Components of the mass along the two positions: law of sines in the parallelogram";
        let [one, two] = [("m_a", parts[0]), ("m_b", parts[1])]
            .map(|(symbol, part)| sheet.numerical((symbol, n), "g", part, how));
        sheet.answer(("position", n), labels[0], numbers[0]);
        sheet.answer(("position_mass", n), labels[1], one);
        sheet.answer(("next_position", n), labels[2], numbers[1]);
        sheet.answer(("next_position_mass", n), labels[3], two);
        sheet.verify(|| {
            let vectors = [(one.value(), at[0]), (two.value(), at[1])];
            let (along, across) = vectors
                .iter()
                .fold((0.0, 0.0), |(x, y), (m, a)| (x + m * (a - angle).cos(), y + m * (a - angle).sin()));
            sheet.check_zero("masses at the positions, along the correction", (along - whole).into(), whole);
            sheet.check_zero("masses at the positions, across the correction", across.into(), whole);
            let (squared, scale) = rotor::by_pairs(&vectors);
            let what = Text::new("square of the mass in plane {n} by the law of cosines").with("n", n);
            sheet.check_sum(what, found.mass.powi(2), squared.into(), scale);
        });
    }
}
