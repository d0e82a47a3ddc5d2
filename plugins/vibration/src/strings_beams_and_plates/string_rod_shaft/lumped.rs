//! Common errors of the lowest frequency: body or end taken as a spring or a mass.

use dalembert_core::Worksheet;
use dalembert_mechanics::Real;

use super::WaveBody;

/// The common errors of the lowest frequency of a body with a mass or a spring at an end.
pub(super) fn errors<W: Worksheet>(body: &WaveBody<W::Num>, length: W::Num, sheet: W) {
    let is_free = |n: usize| {
        let end = body.ends[n];
        !end.fixed && end.ratio_of_stiffness.is_none() && end.ratio_of_mass.is_none()
    };
    let end = |n: usize| (body.ends[n].ratio_of_stiffness, body.ends[n].ratio_of_mass);
    let (is_held, (spring, mass)) = match [0, 1].map(|n| (body.ends[n].fixed, is_free(n))) {
        [(true, _), _] => (true, end(1)),
        [_, (true, _)] => (true, end(0)),
        [(_, true), _] => (false, end(1)),
        [_, (_, true)] => (false, end(0)),
        _ => return,
    };
    let one = W::Num::from(1.0);
    let lumped = |stiffness: W::Num, mass: W::Num| body.speed / length * (stiffness / mass).sqrt();
    match (is_held, spring, mass) {
        (true, spring, Some(mass)) => {
            let stiffness = || spring.map_or(one, |spring| one + spring);
            let massless = || lumped(stiffness(), mass);
            sheet.common_error(("ω", 1), "the mass of the body itself left out", massless);
            let whole = || lumped(stiffness(), mass + one);
            sheet.common_error(("ω", 1), "the whole mass of the body added to that at its end", whole);
        }
        (false, Some(spring), mass) => {
            let rigid = || lumped(spring, mass.map_or(one, |mass| one + mass));
            sheet.common_error(("ω", 1), "the body taken as rigid on the spring", rigid);
        }
        _ => {}
    }
}
