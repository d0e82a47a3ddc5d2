//! The motion with friction as it is worked on paper: stroke by stroke to rest.

use std::f64::consts::PI;

use dalembert_core::{Refusal, Text, Worksheet};
use dalembert_mechanics::{
    Real, sdof,
    vibration::{
        free::FreeMotion,
        friction::{FrictionDecay, Rest},
        transient::closed,
    },
};

use super::{FrictionSystem, common_errors};
use crate::sources::{GROVER, RAO};

/// The first turning point.
pub(super) struct First<N> {
    /// Time of the turning point; `None` for a release from rest, at once.
    time: Option<N>,
    /// Size of the displacement there.
    pub(super) amplitude: N,
    /// True if the turning point lies on the positive side.
    positive: bool,
    /// Time of a stroke.
    half: N,
    /// Factor of viscous decay of the amplitude in a stroke, and the constant `C` that joins `|X|`.
    viscous: Option<[N; 2]>,
}

/// From the start to rest. The result is the position of rest and the first turning point; `None` where viscous
/// damping leaves no strokes.
pub(super) fn to_rest<W: Worksheet>(
    system: &FrictionSystem<W::Num>,
    decay: &FrictionDecay,
    rest: &Rest,
    sheet: W,
) -> (W::Num, Option<First<W::Num>>) {
    if decay.motion.damping_ratio >= 1.0 {
        return (creeping(system, decay, rest, sheet), None);
    }
    let (half, viscous) = stroke(system, sheet);
    let first = first_turning(system, decay, half, viscous, sheet);
    let more = decay.strokes_from(first.amplitude.value(), decay.hold);
    let one = W::Num::from(1.0);
    let needed = match viscous {
        None => (first.amplitude - system.hold) / (system.offset * 2.0),
        Some([kept, constant]) => {
            ((first.amplitude + constant) / (system.hold + constant)).ln() / (one / kept).ln()
        }
    };
    if more > 0.0 {
        common_errors::half_cycles(system, first.amplitude, viscous, sheet);
        let needed = sheet.step(
            "n′",
            "1",
            needed,
            "Half-cycles until the turning point would reach the edge of the sticking zone",
        );
        let (outer, inner) = (first.amplitude, system.hold);
        match viscous {
            None => sheet.check(
                "the energy difference down to the edge of the sticking zone is the friction work over the path of those half-cycles",
                (outer.powi(2) - inner.powi(2)) / 2.0,
                system.offset * needed * (outer + inner),
            ),
            Some([kept, constant]) => sheet.check(
                "the edge of the sticking zone + C results from the first amplitude + C after those half-cycles",
                inner + constant,
                (outer + constant) * (kept.ln() * needed).exp(),
            ),
        }
        sheet.answer("strokes_exact", "Half-cycles to rest, before rounding up", needed);
        let not_rounded = || first.time.map_or(needed * half, |begun| begun + needed * half);
        sheet.common_error("t_R", "the number of half-cycles not rounded up", not_rounded);
    }
    let strokes =
        sheet.numerical("n", "1", more, ("Half-cycles to rest: that number rounded up", RAO.at("§2.9")));
    let distance = match viscous {
        None => first.amplitude - strokes * system.offset * 2.0,
        Some([kept, constant]) => {
            (first.amplitude + constant) * (-(strokes * (one / kept).ln())).exp() - constant
        }
    };
    let is_positive = (more % 2.0 == 0.0) == first.positive;
    let position = if is_positive { distance } else { -distance };
    common_errors::rest(system, [first.amplitude, strokes], viscous, is_positive, sheet);
    let position =
        sheet.step(system.units.rest, system.units.displacement, position, ("Rest position", RAO.at("§2.9")));
    let run = strokes * half;
    let time = match first.time {
        None => sheet.step("t_R", "s", run, "Time to rest"),
        Some(begun) => sheet.step("t_R", "s", begun + run, "Time to rest"),
    };
    sheet.verify(|| {
        energy(system, &first, [strokes, position], sheet);
        let end = rest.time.unwrap_or(0.0) * 1.01;
        if let Some([there, _]) = decay.step_by_step(end) {
            let off = W::Num::from(there - position.value());
            sheet.check_zero(
                "rest position by step-by-step integration of the equation of motion",
                off,
                first.amplitude.value() + decay.hold,
            );
        }
        if more > 0.0 {
            let end = [position, time].map(Real::value);
            last_stroke(decay, end, [half.value(), system.offset.value()], sheet);
        }
    });
    let cycles = sheet.step("N_c", "1", strokes / 2.0, "Cycles: two half-cycles each");
    sheet.answer("strokes", "Half-cycles after the first turning point", strokes);
    sheet.answer("cycles", "Cycles to rest", cycles);
    sheet.answer("stop_time", "Time to rest", time);
    sheet.answer("rest_position", "Rest position", position);
    (position, Some(first))
}

/// The middle of the last stroke, back from its end by the free vibration about the shifted position of rest, and by
/// marching from the start.
fn last_stroke<W: Worksheet>(
    decay: &FrictionDecay,
    [position, time]: [f64; 2],
    [half, offset]: [f64; 2],
    sheet: W,
) {
    let back = half / 2.0;
    let Some([there, speed]) = decay.step_by_step(time - back) else { return };
    let FreeMotion { natural_frequency: natural, damping_ratio: ratio, displacement, velocity } =
        decay.motion;
    let centre = if speed > 0.0 { -offset } else { offset };
    let damped = natural * (1.0 - ratio * ratio).sqrt();
    let middle = centre + (position - centre) * closed::release_underdamped(natural, ratio, damped, -back);
    sheet.check_zero(
        "time of rest: the middle of the last stroke, backwards from its end and by step-by-step integration from the start",
        W::Num::from(there - middle),
        displacement.abs() + velocity.abs() / natural + decay.hold,
    );
}

/// The time of a stroke, what it takes of the amplitude, and what viscous damping leaves.
fn stroke<W: Worksheet>(system: &FrictionSystem<W::Num>, sheet: W) -> (W::Num, Option<[W::Num; 2]>) {
    let Some(zeta) = system.zeta else {
        let half = sheet.step(
            "T/2",
            "s",
            W::Num::from(PI) / system.given.natural,
            "Duration of a half-cycle, from one turning point to the next",
        );
        let what = "the friction loss of a half-cycle used for a whole cycle";
        sheet.common_error(system.units.loss, what, || system.offset * 2.0);
        let loss = sheet.step(
            system.units.loss,
            system.units.displacement,
            system.offset * 4.0,
            (
                system.of(
                    "Amplitude decrease per cycle, 4F/k: the same in each",
                    "Amplitude decrease per cycle, 4 T_f/k_t: the same in each",
                ),
                RAO.at("§2.9"),
            ),
        );
        sheet.answer("loss", "Amplitude decrease per cycle", loss);
        return (half, None);
    };
    let damped = sheet.step(
        "ω_d",
        "rad/s",
        sdof::damped_frequency(system.given.natural, zeta),
        ("Frequency of the half-cycles", RAO.at("§2.6")),
    );
    let undamped = || W::Num::from(PI) / system.given.natural;
    sheet.common_error("T/2", "the period without damping used", undamped);
    let half = sheet.step(
        "T/2",
        "s",
        W::Num::from(PI) / damped,
        "Duration of a half-cycle, from one turning point to the next",
    );
    let kept = sheet.step(
        "q",
        "1",
        (-(zeta * PI / (W::Num::from(1.0) - zeta.powi(2)).sqrt())).exp(),
        "Per half-cycle, viscous damping reduces the distance from the shifted equilibrium position to this fraction",
    );
    let one = W::Num::from(1.0);
    let constant = sheet.step(
        "C",
        system.units.displacement,
        system.offset * (one + kept) / (one - kept),
        "Turning points satisfy Xₙ₊₁ = q Xₙ − f (1 + q); X + C then decreases by the factor q in each half-cycle",
    );
    sheet.answer("kept", "Amplitude ratio per half-cycle due to viscous damping", kept);
    (half, Some([kept, constant]))
}

/// The first turning point: the release itself, or the end of the first stroke.
fn first_turning<W: Worksheet>(
    system: &FrictionSystem<W::Num>,
    decay: &FrictionDecay,
    half: W::Num,
    viscous: Option<[W::Num; 2]>,
    sheet: W,
) -> First<W::Num> {
    let (x0, v0) = (system.given.displacement, system.given.velocity);
    let (time, at) = decay.first_turning().unwrap_or_default();
    if v0.value() == 0.0 {
        let amplitude = sheet.step(
            system.units.first,
            system.units.displacement,
            x0.abs(),
            "Released from rest: the start is a turning point",
        );
        return First { time: None, amplitude, positive: at > 0.0, half, viscous };
    }
    let forward = v0.value() > 0.0;
    let (turned, displacement) = if system.zeta.is_none() {
        // About the shifted position of rest, mirrored so that the motion begins forward.
        let (y0, speed) = if forward { (x0 + system.offset, v0) } else { (system.offset - x0, -v0) };
        let y0 = sheet.step(
            "y₀",
            system.units.displacement,
            y0,
            "Start of the first half-cycle, from its shifted equilibrium position, positive forwards",
        );
        let radius = sheet.step(
            "R",
            system.units.displacement,
            (y0.powi(2) + (speed / system.given.natural).powi(2)).sqrt(),
            ("Amplitude of the first half-cycle about that position", RAO.at("§2.9")),
        );
        common_errors::first_turning(system, half, sheet);
        let turned = (speed / system.given.natural).atan2(y0) / system.given.natural;
        let turned = sheet.step("t₁", "s", turned, "First turning point after the start");
        let displacement = if forward { radius - system.offset } else { system.offset - radius };
        (
            turned,
            sheet.step(
                system.units.turned,
                system.units.displacement,
                displacement,
                system.of("Displacement at that instant", "Angle at that instant"),
            ),
        )
    } else {
        (
            sheet.numerical(
                "t₁",
                "s",
                time,
                "First turning point after the start: zero of the velocity in the first half-cycle",
            ),
            sheet.numerical(
                system.units.turned,
                system.units.displacement,
                at,
                system.of("Displacement at that instant", "Angle at that instant"),
            ),
        )
    };
    sheet.verify(|| {
        if let Some([there, speed]) = decay.step_by_step(turned.value()) {
            let size = decay.motion.displacement.abs()
                + decay.motion.velocity.abs() / decay.motion.natural_frequency;
            sheet.check_zero(
                system.of(
                    "displacement at the first turning point by step-by-step integration",
                    "angle at the first turning point by step-by-step integration",
                ),
                W::Num::from(there - displacement.value()),
                size,
            );
            sheet.check_zero(
                "zero velocity at the first turning point",
                W::Num::from(speed),
                size * decay.motion.natural_frequency,
            );
        }
    });
    sheet.answer("first_turning_time", "First turning point after the start", turned);
    let label = system.of("Displacement at the first turning point", "Angle at the first turning point");
    sheet.answer("first_turning", label, displacement);
    let amplitude =
        sheet.step(system.units.first, system.units.displacement, displacement.abs(), "First amplitude");
    First { time: Some(turned), amplitude, positive: at > 0.0, half, viscous }
}

/// Energy at the start = energy at rest + friction times the way, without viscous damping.
fn energy<W: Worksheet>(
    system: &FrictionSystem<W::Num>,
    first: &First<W::Num>,
    [strokes, position]: [W::Num; 2],
    sheet: W,
) {
    if first.viscous.is_some() {
        return;
    }
    let (x0, v0) = (system.given.displacement, system.given.velocity);
    let begun = system.given.stiffness * x0.powi(2) / 2.0 + system.given.mass * v0.powi(2) / 2.0;
    // The amplitudes fall by 2f a stroke: the ways form an arithmetic series.
    let strokes_way = strokes * (first.amplitude - strokes * system.offset) * 2.0;
    let signed = if first.positive { first.amplitude } else { -first.amplitude };
    let way = (signed - x0).abs() + strokes_way;
    sheet.check(
        system.of(
            "initial energy = energy at rest + friction force × distance travelled",
            "initial energy = energy at rest + friction torque × angle travelled",
        ),
        begun,
        system.given.stiffness * position.powi(2) / 2.0 + system.given.force * way,
    );
}

/// Viscous damping so strong that the mass approaches, without oscillating, the shifted position of rest.
fn creeping<W: Worksheet>(
    system: &FrictionSystem<W::Num>,
    decay: &FrictionDecay,
    rest: &Rest,
    sheet: W,
) -> W::Num {
    let position = match rest.time {
        // The first turning point already lies where friction holds.
        Some(time) => {
            let time = sheet.numerical("t_R", "s", time, "Time to rest: end of the first half-cycle");
            sheet.answer("stop_time", "Time to rest", time);
            sheet.numerical(
                system.units.rest,
                system.units.displacement,
                rest.position,
                "Rest position: friction holds the mass at the first turning point",
            )
        }
        None => {
            sheet.warn(|| {
                Text::new(system.of(
                    "the viscous damping is critical or higher: the mass does not oscillate, and only approaches the edge of the sticking zone",
                    "the viscous damping is critical or higher: the body does not oscillate, and only approaches the edge of the sticking zone",
                ))
            });
            let signed = if rest.position > 0.0 { system.offset } else { -system.offset };
            sheet.step(
                system.units.rest,
                system.units.displacement,
                signed,
                "Position approached asymptotically: equilibrium shifted by friction",
            )
        }
    };
    sheet.verify(|| {
        let late = rest.time.unwrap_or(60.0 * decay.motion.damping_ratio / decay.motion.natural_frequency);
        if let Some([there, _]) = decay.step_by_step(late * 1.01) {
            sheet.check_zero(
                "rest position by step-by-step integration of the equation of motion",
                W::Num::from(there - position.value()),
                decay.motion.displacement.abs() + decay.hold,
            );
        }
    });
    sheet.answer("rest_position", "Rest position", position);
    position
}

/// Cycles and time to fall to an amplitude.
pub(super) fn fall<W: Worksheet>(
    system: &FrictionSystem<W::Num>,
    asked: W::Num,
    first: &First<W::Num>,
    decay: &FrictionDecay,
    sheet: W,
) -> Result<(), Refusal> {
    if asked.value() >= first.amplitude.value() {
        return Err(Refusal::because(
            "the target amplitude of the decay is not below the first one: write a smaller one",
        ));
    }
    if asked.value() < decay.hold {
        return Err(Refusal::because(
            system.of(
                "friction stops the mass before it decays to the required amplitude: write one above the half-width of the sticking zone",
                "friction stops the body before it decays to the required amplitude: write one above the half-width of the sticking zone",
            ),
        ));
    }
    let exact = match first.viscous {
        None => (first.amplitude - asked) / (system.offset * 4.0),
        Some([kept, constant]) => {
            ((first.amplitude + constant) / (asked + constant)).ln() / ((W::Num::from(1.0) / kept).ln() * 2.0)
        }
    };
    common_errors::fall(system, [first.amplitude, asked], first.viscous, sheet);
    let exact = sheet.step(
        "Nₐ′",
        "1",
        exact,
        ("Cycles for the amplitude to decay to the requested value", GROVER.at("§3.6")),
    );
    let strokes = sheet.numerical(
        "nₐ",
        "1",
        decay.strokes_from(first.amplitude.value(), asked.value()),
        "Half-cycles until a turning point is no farther out: twice that number, rounded up",
    );
    let cycles = sheet.step("Nₐ", "1", strokes / 2.0, "Whole half-cycles, in cycles");
    let time = match first.time {
        None => strokes * first.half,
        Some(begun) => begun + strokes * first.half,
    };
    let time = sheet.step("tₐ", "s", time, "Time of that turning point");
    sheet.verify(|| {
        // At that turning point it is inside, at the one before still outside.
        let size = |strokes: f64| decay.turning(first.amplitude.value(), strokes).abs();
        let inside = size(strokes.value()) <= asked.value() * (1.0 + 1e-9);
        let outside = size(strokes.value() - 1.0) > asked.value() * (1.0 - 1e-9);
        let off = if inside && outside { 0.0 } else { 1.0 };
        sheet.check_zero(
            "the turning point is the first one within the required amplitude",
            W::Num::from(off),
            1.0,
        );
        if let Some([_, speed]) = decay.step_by_step(time.value()) {
            sheet.check_zero(
                "zero velocity at that turning point, by step-by-step integration",
                W::Num::from(speed),
                system.given.natural.value() * first.amplitude.value(),
            );
        }
    });
    let [outer, inner] = [first.amplitude, asked];
    match first.viscous {
        None => sheet.check(
            "the energy difference between the two amplitudes is the friction work over the path of those cycles",
            (outer.powi(2) - inner.powi(2)) / 2.0,
            system.offset * exact * (outer + inner) * 2.0,
        ),
        Some([kept, constant]) => sheet.check(
            "Xₐ + C results from X₁ + C after two half-cycles of each of those cycles",
            inner + constant,
            (outer + constant) * ((kept.ln() * exact * 2.0).exp()),
        ),
    }
    sheet.answer("fall_cycles_exact", "Cycles of that decay, as a fraction", exact);
    sheet.answer("fall_cycles", "Cycles of that decay, whole half-cycles", cycles);
    sheet.answer("fall_time", "Duration of that decay", time);
    Ok(())
}

/// The motion at the asked time.
pub(super) fn at_time<W: Worksheet>(
    system: &FrictionSystem<W::Num>,
    [time, rest]: [W::Num; 2],
    decay: &FrictionDecay,
    sheet: W,
) {
    let stroke = decay.stroke(time.value());
    let Some(motion) = stroke.motion else {
        let rests = sheet.step(
            system.units.symbol,
            system.units.displacement,
            rest,
            "Already at rest, at its rest position",
        );
        let still = sheet.numerical(system.units.speed_symbol, system.units.velocity, 0.0, "It is at rest");
        sheet.answer("displacement", system.of("Displacement at that time", "Angle at that time"), rests);
        sheet.answer("velocity", system.of("Velocity at that time", "Angular velocity at that time"), still);
        return;
    };
    let begun =
        sheet.numerical("t_j", "s", stroke.begun, "Start of the half-cycle that contains the requested time");
    let centre = if stroke.centre > 0.0 { system.offset } else { -system.offset };
    let centre = sheet.step(
        system.units.centre,
        system.units.displacement,
        centre,
        ("Equilibrium position, shifted by friction against the motion", RAO.at("§2.9")),
    );
    let lapse = sheet.step("τ", "s", time - begun, "Time since the start of the half-cycle");
    let first = stroke.begun == 0.0;
    let from = if first {
        sheet.step(
            "y",
            system.units.displacement,
            system.given.displacement - centre,
            "Start of the half-cycle, from the shifted equilibrium position",
        )
    } else {
        sheet.numerical(
            "y",
            system.units.displacement,
            motion.displacement,
            "Start of the half-cycle, from the shifted equilibrium position",
        )
    };
    let speed = if motion.velocity == 0.0 { None } else { Some(system.given.velocity) };
    let words = system.of(
        "Displacement at that time: free vibration about the shifted equilibrium position",
        "Angle at that time: free vibration about the shifted equilibrium position",
    );
    let why = (words, RAO.at("§2.9"));
    let derivative =
        system.of("Velocity at that time: its derivative", "Angular velocity at that time: its derivative");
    let (x, v) = match system.zeta {
        None => {
            let angle = system.given.natural * lapse;
            common_errors::state(system, time, [centre, from, angle], sheet);
            let (mut x, mut v) = (centre + from * angle.cos(), -(from * system.given.natural * angle.sin()));
            if let Some(speed) = speed {
                x = x + speed / system.given.natural * angle.sin();
                v = v + speed * angle.cos();
            }
            (
                sheet.step(system.units.symbol, system.units.displacement, x, why),
                sheet.step(system.units.speed_symbol, system.units.velocity, v, derivative),
            )
        }
        Some(zeta) if zeta.value() < 1.0 => {
            let damped = sdof::damped_frequency(system.given.natural, zeta);
            let sine = match speed {
                Some(speed) => (speed + zeta * system.given.natural * from) / damped,
                None => zeta * system.given.natural * from / damped,
            };
            let sine =
                sheet.step("B", system.units.displacement, sine, "Sine coefficient in that half-cycle");
            let fade = (-(zeta * system.given.natural * lapse)).exp();
            let (c, s) = ((damped * lapse).cos(), (damped * lapse).sin());
            let x = centre + fade * (from * c + sine * s);
            let v = fade
                * ((damped * sine - zeta * system.given.natural * from) * c
                    - (damped * from + zeta * system.given.natural * sine) * s);
            (
                sheet.step(system.units.symbol, system.units.displacement, x, why),
                sheet.step(system.units.speed_symbol, system.units.velocity, v, derivative),
            )
        }
        Some(_) => {
            let [x, v] = decay.state(time.value());
            let how = "From the overdamped motion about the shifted equilibrium position";
            (
                sheet.numerical(system.units.symbol, system.units.displacement, x, how),
                sheet.numerical(system.units.speed_symbol, system.units.velocity, v, how),
            )
        }
    };
    sheet.verify(|| {
        let size =
            decay.motion.displacement.abs() + decay.motion.velocity.abs() / decay.motion.natural_frequency;
        if let Some([there, moving]) = decay.step_by_step(time.value()) {
            let off = [there - x.value(), moving - v.value()].map(W::Num::from);
            sheet.check_zero(
                system.of(
                    "displacement by step-by-step integration of the equation of motion",
                    "angle by step-by-step integration of the equation of motion",
                ),
                off[0],
                size,
            );
            sheet.check_zero(
                system.of(
                    "velocity by step-by-step integration of the equation of motion",
                    "angular velocity by step-by-step integration of the equation of motion",
                ),
                off[1],
                size * decay.motion.natural_frequency,
            );
        }
    });
    sheet.answer("displacement", system.of("Displacement at that time", "Angle at that time"), x);
    sheet.answer("velocity", system.of("Velocity at that time", "Angular velocity at that time"), v);
}
