//! The stiffnesses at which the amplitude just reaches the clearance.

use dalembert_core::Worksheet;
use dalembert_mechanics::{
    Real, sdof,
    whirl::{self, PermittedStiffness},
};

use super::Rotor;
use crate::sources::RAO;

/// The limits of the two branches, N/m; `None` for a branch without one.
pub(super) type Limits<N> = (Option<N>, Option<N>);

/// Without damping: the amplitude is `m₀eω²/|k − mω²|`.
pub(super) fn undamped_limits<W: Worksheet>(
    rotor: &Rotor<W::Num>,
    speeds: [W::Num; 2],
    permitted: &PermittedStiffness,
    sheet: W,
) -> Limits<W::Num> {
    let (m, u, r) = (rotor.mass, rotor.unbalance, rotor.clearance);
    let hold = |k: W::Num, speed: W::Num, kernel: f64| {
        sheet.check(
            "the amplitude with that stiffness is the clearance",
            u * speed.powi(2) / (k - m * speed.powi(2)).abs(),
            r,
        );
        sheet.check("same limit evaluated over the whole speed range", k, kernel.into());
        k
    };
    let one = W::Num::from(1.0);
    let soft = permitted.soft.map(|limit| {
        let highest = || whirl::soft_limit_undamped(m, u, r, speeds[1]);
        sheet.common_error("kₛ", "the highest speed of the range taken as the worst", highest);
        let forced = || m * speeds[0].powi(2) / (one + u / (m * r));
        sheet.common_error("kₛ", "the amplitude under a constant force, e/|1 − r²|, used", forced);
        let k = sheet.step(
            "kₛ",
            "MN/m",
            whirl::soft_limit_undamped(m, u, r, speeds[0]),
            ("Supercritical operation, m₀eω²/(mω² − k) = R: worst case at the lowest speed", RAO.at("§3.7")),
        );
        hold(k, speeds[0], limit.stiffness)
    });
    let stiff = permitted.stiff.map(|limit| {
        let lowest = || whirl::stiff_limit_undamped(m, u, r, speeds[0]);
        sheet.common_error("kₕ", "the lowest speed of the range taken as the worst", lowest);
        let forced = || m * speeds[1].powi(2) / (one - u / (m * r));
        sheet.common_error("kₕ", "the amplitude under a constant force, e/|1 − r²|, used", forced);
        let k = sheet.step(
            "kₕ",
            "MN/m",
            whirl::stiff_limit_undamped(m, u, r, speeds[1]),
            ("Subcritical operation, m₀eω²/(k − mω²) = R: worst case at the highest speed", RAO.at("§3.7")),
        );
        hold(k, speeds[1], limit.stiffness)
    });
    (soft, stiff)
}

/// With a damping ratio: the roots of a quadratic equation in `k/(mω²)`.
pub(super) fn ratio_limits<W: Worksheet>(
    rotor: &Rotor<W::Num>,
    ratio: W::Num,
    speeds: [W::Num; 2],
    permitted: &PermittedStiffness,
    sheet: W,
) -> Limits<W::Num> {
    let (m, u, r) = (rotor.mass, rotor.unbalance, rotor.clearance);
    let hold = |k: W::Num, speed: W::Num, kernel: f64| {
        sheet.check(
            "the amplitude with that stiffness is the clearance",
            sdof::unbalance_amplitude(u, k, m, sdof::damping_from_ratio(ratio, k, m), speed),
            r,
        );
        sheet.check("same limit evaluated over the whole speed range", k, kernel.into());
        k
    };
    let soft = permitted.soft.map(|limit| {
        let highest = || whirl::soft_limit(m, u, r, speeds[1], ratio);
        sheet.common_error("kₛ", "the highest speed of the range taken as the worst", highest);
        let k = sheet.step(
            "kₛ",
            "MN/m",
            whirl::soft_limit(m, u, r, speeds[0], ratio),
            (
                "Supercritical operation: the smaller stiffness for which the amplitude at the lowest speed equals the clearance",
                RAO.at("§3.7"),
            ),
        );
        hold(k, speeds[0], limit.stiffness)
    });
    let stiff = permitted.stiff.map(|limit| {
        let lowest = || whirl::stiff_limit(m, u, r, speeds[0], ratio);
        sheet.common_error("kₕ", "the lowest speed of the range taken as the worst", lowest);
        let k = sheet.step(
            "kₕ",
            "MN/m",
            whirl::stiff_limit(m, u, r, speeds[1], ratio),
            (
                "Subcritical operation: the larger stiffness for which the amplitude at the highest speed equals the clearance",
                RAO.at("§3.7"),
            ),
        );
        hold(k, speeds[1], limit.stiffness)
    });
    (soft, stiff)
}

/// With a fixed coefficient the worst speed of the soft branch may lie inside the range, so it is searched.
pub(super) fn found_limits<W: Worksheet>(
    rotor: &Rotor<W::Num>,
    coefficient: W::Num,
    permitted: &PermittedStiffness,
    sheet: W,
) -> Limits<W::Num> {
    let find =
        |limit: &whirl::StiffnessLimit, [k, speed, amplitude]: [&'static str; 3], how: &'static str| {
            let k = sheet.numerical(k, "MN/m", limit.stiffness, (how, RAO.at("§3.7")));
            let speed = sheet.numerical(speed, "rpm", limit.speed, "Speed of maximum amplitude");
            let amplitude = sheet.step(
                amplitude,
                "mm",
                sdof::unbalance_amplitude(rotor.unbalance, k, rotor.mass, coefficient, speed),
                ("Amplitude at that speed", RAO.at("§3.7")),
            );
            sheet.check("the amplitude with that stiffness is the clearance", amplitude, rotor.clearance);
            k
        };
    let soft = permitted.soft.as_ref().map(|limit| {
        find(
            limit,
            ["kₛ", "ωₛ", "Xₛ"],
            "Supercritical operation: the largest stiffness with (k − mω²)² + (cω)² ≥ (m₀eω²/R)² at every speed of the range",
        )
    });
    let stiff = permitted.stiff.as_ref().map(|limit| {
        find(
            limit,
            ["kₕ", "ωₕ", "Xₕ"],
            "Subcritical operation: the smallest stiffness with (k − mω²)² + (cω)² ≥ (m₀eω²/R)² at every speed of the range",
        )
    });
    (soft, stiff)
}
