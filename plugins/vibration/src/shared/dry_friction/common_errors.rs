//! Common errors of the motion with friction.

use dalembert_core::Worksheet;
use dalembert_mechanics::Real;

use super::FrictionSystem;

/// Records the common errors of the half-cycles until the edge of the sticking zone.
pub(super) fn half_cycles<W: Worksheet>(
    system: &FrictionSystem<W::Num>,
    amplitude: W::Num,
    viscous: Option<[W::Num; 2]>,
    sheet: W,
) {
    let FrictionSystem { offset, hold, .. } = *system;
    match viscous {
        None => {
            let to_zero = || amplitude / (offset * 2.0);
            let what = "the amplitude assumed to decay to zero, without a sticking zone";
            sheet.common_error("n′", what, to_zero);
            sheet.common_error("n", what, || W::Num::from(to_zero().value().ceil()));
            let whole = || (amplitude - hold) / (offset * 4.0);
            let what = "the friction loss of a whole cycle used for a half-cycle";
            sheet.common_error("n′", what, whole);
            sheet.common_error("n", what, || W::Num::from(whole().value().ceil()));
            let down = || W::Num::from(((amplitude - hold) / (offset * 2.0)).value().floor());
            sheet.common_error("n", "the number of half-cycles rounded down", down);
        }
        Some([kept, _]) => {
            let alone = || (amplitude / hold).ln() / (W::Num::from(1.0) / kept).ln();
            sheet.common_error("n′", "the friction neglected beside the viscous damping", alone);
        }
    }
}

/// Records the common error of the position of rest, on the positive side or not.
pub(super) fn rest<W: Worksheet>(
    system: &FrictionSystem<W::Num>,
    [amplitude, strokes]: [W::Num; 2],
    viscous: Option<[W::Num; 2]>,
    is_positive: bool,
    sheet: W,
) {
    let signed = |distance: W::Num| if is_positive { distance } else { -distance };
    match viscous {
        None => {
            let whole = || signed(amplitude - strokes * system.offset * 4.0);
            let what = "the friction loss of a whole cycle used for a half-cycle";
            sheet.common_error(system.units.rest, what, whole);
        }
        Some([kept, _]) => {
            let alone = || signed(amplitude * (strokes * kept.ln()).exp());
            let what = "the friction neglected beside the viscous damping";
            sheet.common_error(system.units.rest, what, alone);
        }
    }
}

/// Records the common errors of the first turning point after a start with a velocity.
pub(super) fn first_turning<W: Worksheet>(system: &FrictionSystem<W::Num>, half: W::Num, sheet: W) {
    let (x0, v0) = (system.given.displacement, system.given.velocity);
    sheet.common_error("t₁", "a quarter of a period taken", || half / 2.0);
    let free = || {
        let radius = (x0.powi(2) + (v0 / system.given.natural).powi(2)).sqrt();
        if v0.value() > 0.0 { radius } else { -radius }
    };
    sheet.common_error(system.units.turned, "the amplitude without friction taken", free);
}

/// Records the common error of the cycles until the amplitude has fallen to `asked`.
pub(super) fn fall<W: Worksheet>(
    system: &FrictionSystem<W::Num>,
    [amplitude, asked]: [W::Num; 2],
    viscous: Option<[W::Num; 2]>,
    sheet: W,
) {
    match viscous {
        None => {
            let half = || (amplitude - asked) / (system.offset * 2.0);
            let what = "the friction loss of a half-cycle used for a whole cycle";
            sheet.common_error("Nₐ′", what, half);
        }
        Some([kept, _]) => {
            let alone = || (amplitude / asked).ln() / ((W::Num::from(1.0) / kept).ln() * 2.0);
            sheet.common_error("Nₐ′", "the friction neglected beside the viscous damping", alone);
        }
    }
}

/// Records the common errors of displacement and velocity at a time, without viscous damping; `centre` is the shifted
/// position of rest, `from` the start of the half-cycle from there and `angle` the phase since then.
pub(super) fn state<W: Worksheet>(
    system: &FrictionSystem<W::Num>,
    time: W::Num,
    [centre, from, angle]: [W::Num; 3],
    sheet: W,
) {
    let given = system.given;
    let (x0, v0, natural) = (given.displacement, given.velocity, given.natural);
    let (x, v) = (system.units.symbol, system.units.speed_symbol);
    let phase = || natural * time;
    let what = "the friction neglected";
    sheet.common_error(x, what, || x0 * phase().cos() + v0 / natural * phase().sin());
    sheet.common_error(v, what, || v0 * phase().cos() - x0 * natural * phase().sin());
    if v0.value() == 0.0 {
        let other_side = || (from + centre * 2.0) * angle.cos() - centre;
        sheet.common_error(x, "the equilibrium position shifted to the wrong side", other_side);
    }
}
