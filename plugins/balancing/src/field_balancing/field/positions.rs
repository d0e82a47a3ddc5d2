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

/// Splits the masses that are to be mounted next between adjacent positions.
pub(super) fn split<W: Worksheet>(
    positions: &Positions,
    given: &PositionsGiven<W>,
    masses: &[Found<W::Num>],
    sheet: W,
) {
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
        sheet.answer(("position", n), "Number of the first position in plane", numbers[0]);
        sheet.answer(("position_mass", n), "Mass at the first position in plane", one);
        sheet.answer(("next_position", n), "Number of the second position in plane", numbers[1]);
        sheet.answer(("next_position_mass", n), "Mass at the second position in plane", two);
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
