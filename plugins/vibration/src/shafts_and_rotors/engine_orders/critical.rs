//! A critical speed as it is worked: an order meets a natural frequency.

use std::f64::consts::{PI, TAU};

use dalembert_core::{Symbol, Text, Worksheet};
use dalembert_mechanics::Real;
use dalembert_numerics::quadrature::integral;

use super::{
    CrankshaftDamping, CrankshaftDampingGiven, EngineOrders, EngineOrdersGiven, Order, TorquesGiven,
    Vibration, WORKED, firing::Cylinders, line::CrankshaftLine,
};
use crate::sources::DEN_HARTOG;

/// A critical speed.
#[derive(Clone, Copy)]
pub(super) struct Critical {
    /// Counted from 0.
    pub(super) mode: usize,
    pub(super) order: Order,
    pub(super) speed: f64,
    /// Sum of the phase vectors.
    pub(super) sum: f64,
    /// Equilibrium amplitude, rad, or what stands for it where the torques are unknown.
    pub(super) severity: f64,
}

/// The worst ones, in the order of modes and orders. What differs by rounding alone counts as equal, so that the
/// choice does not depend on units.
pub(super) fn worst(criticals: &[Critical], most: usize) -> Vec<&Critical> {
    let largest = criticals.iter().fold(0.0, |largest: f64, critical| largest.max(critical.severity));
    let rank = |critical: &Critical| (critical.severity / largest * 1e8).round();
    let mut chosen: Vec<(usize, &Critical)> =
        criticals.iter().enumerate().filter(|(_, critical)| rank(critical) > 10.0).collect();
    chosen.sort_by(|(a, first), (b, second)| rank(second).total_cmp(&rank(first)).then(a.cmp(b)));
    chosen.truncate(most);
    chosen.sort_by_key(|(at, _)| *at);
    chosen.into_iter().map(|(_, critical)| critical).collect()
}

/// The steady amplitude of the first mass over its equilibrium amplitude; `None` without damping.
pub(super) fn magnifier<N: Real>(
    problem: &EngineOrders,
    cylinders: &Cylinders<N>,
    vibration: &Vibration<N>,
) -> Option<f64> {
    problem.damping.as_ref().map(|damping| match damping {
        CrankshaftDamping::Ratio { ratio } => 0.5 / ratio,
        CrankshaftDamping::Magnifier { magnifier } => *magnifier,
        CrankshaftDamping::Cranks { coefficient } => {
            let squares: f64 =
                cylinders.each.iter().map(|one| vibration.shape[one.mass].value().powi(2)).sum();
            vibration.frequency.value() * vibration.inertia.value() / (coefficient * squares)
        }
    })
}

/// Works a critical speed, the `row`th that is written.
pub(super) fn work<W: Worksheet>(
    given: &EngineOrdersGiven<W>,
    line: &CrankshaftLine<W::Num>,
    cylinders: &Cylinders<W::Num>,
    vibrations: &[Vibration<W::Num>],
    critical: &Critical,
    row: usize,
    sheet: W,
) {
    let vibration = &vibrations[critical.mode];
    let why = Text::new("Order of a torque that is critical in mode {mode}").with("mode", critical.mode + 1);
    // An index in letters: the sums run over the numbers of the cylinders alone.
    let order = Symbol { of: ["A", "B", "C", "D", "E", "F"][(row - 1) % WORKED], ..Symbol::from("n") };
    let order = sheet.numerical(order, "1", critical.order.order, why);
    sheet.answer(("order", row), "Order", order);
    let speed = sheet.step(
        ("Ω", row),
        "rpm",
        vibration.frequency / order,
        ("The order makes n vibrations per revolution: critical speed", DEN_HARTOG.at("ch. 5")),
    );
    sheet.answer(("critical_speed", row), "Critical speed", speed);
    sheet.verify(|| {
        let twisted = line
            .stiffnesses
            .iter()
            .enumerate()
            .map(|(at, stiffness)| *stiffness * (vibration.shape[at] - vibration.shape[at + 1]).powi(2));
        sheet.check(
            "critical speed: n vibrations per revolution, by Rayleigh's quotient Σ k (Δβ)²/Σ J β²",
            (order * speed).powi(2) * vibration.inertia,
            W::Num::sum(twisted),
        );
    });
    let arms = || vibration.arms.iter().zip(&cylinders.each).map(|(beta, one)| (*beta, one.angle));
    let cosines = sheet.step(
        ("X", row),
        "1",
        W::Num::sum(arms().map(|(beta, angle)| beta * (order * angle).cos())),
        "Phase vectors: each cylinder with the amplitude of its crank, rotated by n times its firing angle",
    );
    let sines = sheet.step(
        ("Y", row),
        "1",
        W::Num::sum(arms().map(|(beta, angle)| beta * (order * angle).sin())),
        "Sum of their sine components",
    );
    let star = |arms: Vec<(W::Num, W::Num)>| {
        let part =
            |of: fn(W::Num) -> W::Num| W::Num::sum(arms.iter().map(|(beta, phase)| *beta * of(*phase)));
        (part(Real::cos).powi(2) + part(Real::sin).powi(2)).sqrt()
    };
    let aligned = || W::Num::sum(arms().map(|(beta, _)| beta.abs()));
    sheet.common_error(("S", row), "the phase vectors added as numbers", aligned);
    let equal = || star(arms().map(|(_, angle)| (W::Num::from(1.0), order * angle)).collect());
    sheet.common_error(("S", row), "all cranks given the same amplitude, without the mode shape", equal);
    let first = || star(arms().collect());
    sheet.common_error(("S", row), "the firing angles not multiplied by the order", first);
    let sum = sheet.step(
        ("S", row),
        "1",
        (cosines.powi(2) + sines.powi(2)).sqrt(),
        ("Sum of the phase vectors", DEN_HARTOG.at("ch. 5")),
    );
    sheet.answer(("phase_sum", row), "Sum of the phase vectors", sum);
    sheet.verify(|| {
        let values: Vec<(f64, f64)> = arms().map(|(beta, angle)| (beta.value(), angle.value())).collect();
        let pairs = values.iter().flat_map(|(beta, angle)| {
            values.iter().map(move |(other, at)| beta * other * (critical.order.order * (angle - at)).cos())
        });
        sheet.check_zero(
            "square of the sum from the angles between each pair of cylinders",
            W::Num::from(pairs.sum::<f64>()) - sum.powi(2),
            values.iter().map(|(beta, _)| beta.abs()).sum::<f64>().powi(2),
        );
    });
    let amplitude = critical.order.amplitude;
    let torque = match &given.torques {
        TorquesGiven::Unknown { .. } => return,
        TorquesGiven::Given { .. } => sheet.numerical(
            ("T", row),
            "N*m",
            amplitude,
            "Torque of a cylinder for this order, from the table",
        ),
        TorquesGiven::Pressure { bore, stroke, .. } => {
            let pressure = sheet.numerical(
                ("p", row),
                "bar",
                amplitude,
                "Tangential pressure for this order, from the table",
            );
            let torque = pressure * (bore.powi(2) * PI / 4.0) * (*stroke / 2.0);
            sheet.step(
                ("T", row),
                "N*m",
                torque,
                "Torque of a cylinder: pressure times piston area times crank radius",
            )
        }
    };
    let of_shaft = || torque * sum / (speed.powi(2) * vibration.inertia);
    sheet.common_error(("Θ₀", row), "the speed of the crankshaft used as the frequency", of_shaft);
    let equilibrium = sheet.step(
        ("Θ₀", row),
        "deg",
        torque * sum / (vibration.frequency.powi(2) * vibration.inertia),
        (
            "Equilibrium amplitude at the first mass: static torques over the modal stiffness ω² J",
            DEN_HARTOG.at("ch. 5"),
        ),
    );
    sheet.answer(("equilibrium_amplitude", row), "Equilibrium amplitude of the first mass", equilibrium);
    let Some(damping) = &given.damping else { return };
    let balance = "Energy balance: the work π T Θ S of the torques per cycle equals the energy π c ω Θ² Σ β² dissipated by damping";
    let (steady, lost) = match damping {
        CrankshaftDampingGiven::Ratio { ratio } => {
            let why = "Amplitude at resonance, larger by the factor 1/(2 ζ)";
            let steady = sheet.step(("Θ", row), "deg", equilibrium / (*ratio * 2.0), why);
            let coefficient = 2.0 * ratio.value() * vibration.frequency.value() * vibration.inertia.value();
            (steady, coefficient)
        }
        CrankshaftDampingGiven::Magnifier { magnifier } => {
            let why = "Amplitude at resonance: larger by the dynamic magnifier";
            let steady = sheet.step(("Θ", row), "deg", equilibrium * *magnifier, why);
            let coefficient = vibration.frequency.value() * vibration.inertia.value() / magnifier.value();
            (steady, coefficient)
        }
        CrankshaftDampingGiven::Cranks { coefficient } => {
            let squares = W::Num::sum(arms().map(|(beta, _)| beta.powi(2)));
            let linear = || W::Num::sum(arms().map(|(beta, _)| beta));
            sheet.common_error(("B", row), "the amplitudes not squared", linear);
            let squares =
                sheet.step(("B", row), "1", squares, "Sum of the squared amplitudes of the damped cranks");
            let of_shaft = || torque * sum / (*coefficient * speed * squares);
            sheet.common_error(("Θ", row), "the speed of the crankshaft used as the frequency", of_shaft);
            let steady = torque * sum / (*coefficient * vibration.frequency * squares);
            let steady = sheet.step(("Θ", row), "deg", steady, (balance, DEN_HARTOG.at("ch. 5")));
            (steady, coefficient.value() * squares.value())
        }
    };
    sheet.answer(("amplitude", row), "Amplitude of the first mass", steady);
    sheet.verify(|| {
        let work = work_of_a_cycle(critical, cylinders, vibration, torque.value(), steady.value());
        let taken = PI * lost * vibration.frequency.value() * steady.value().powi(2);
        sheet.check(
            "work of the torques, summed over a cycle, equals the energy dissipated by damping",
            W::Num::from(work),
            W::Num::from(taken),
        );
    });
    let [first, last] = line.crankshaft;
    let twist = |at: usize| vibration.shape[at] - vibration.shape[at + 1];
    let size = |at: usize| line.stiffnesses[at].value() * twist(at).value().abs();
    let most =
        (first..last).fold(first, |most, at| if size(at) > size(most) * (1.0 + 1e-9) { at } else { most });
    if first == last {
        return;
    }
    let why = Text::new("Maximum vibratory torque in the crankshaft, behind {mass}")
        .with_text("mass", line.names[most].clone());
    let applied = || torque * sum;
    let symbol = Symbol::from("Q").row(row);
    sheet.common_error(symbol, "the torques of the cylinders taken as the torque in the shaft", applied);
    let slow = || line.stiffnesses[most] * twist(most).abs() * equilibrium;
    sheet.common_error(symbol, "the equilibrium amplitude used in place of that at resonance", slow);
    let largest = sheet.step(symbol, "N*m", line.stiffnesses[most] * twist(most).abs() * steady, why);
    sheet.answer(("shaft_torque", row), "Maximum torque in the crankshaft", largest);
    sheet.verify(|| {
        let inertias = || line.inertias[..=most].iter().zip(&vibration.shape).map(|(j, beta)| *j * *beta);
        let size: f64 = inertias().map(|part| part.value().abs()).sum();
        let scale = steady * vibration.frequency.powi(2);
        let turned = W::Num::sum(inertias());
        sheet.check_sum(
            "maximum torque: inertia torque of all masses before it, ω² Θ Σ J β",
            largest,
            scale * turned.abs(),
            scale.value() * size,
        );
    });
    if let Some(diameter) = given.diameter {
        let stress = largest * 16.0 / (diameter.powi(3) * PI);
        let stress =
            sheet.step(("τ", row), "MPa", stress, "Shear stress due to that torque in a circular shaft");
        sheet.answer(("stress", row), "Shear stress in the crankshaft", stress);
        sheet.verify(|| {
            let radius = diameter.value() / 2.0;
            let moment = |r: f64| stress.value() * r / radius * TAU * r * r;
            sheet.check(
                "moment of the shear stress, which grows with the radius, summed over the section",
                W::Num::from(integral(moment, [0.0, radius], 4)),
                largest,
            );
        });
    }
}

/// The work of all cylinders in a cycle of the vibration, a quarter of which the motion lags behind; equal steps are
/// exact for it.
fn work_of_a_cycle<N: Real>(
    critical: &Critical,
    cylinders: &Cylinders<N>,
    vibration: &Vibration<N>,
    torque: f64,
    amplitude: f64,
) -> f64 {
    const STEPS: u32 = 32;
    let [x, y] = cylinders.vector(critical.order.order, vibration);
    let lead = y.atan2(x);
    let mut work = 0.0;
    for step in 0..STEPS {
        let now = TAU * f64::from(step) / f64::from(STEPS);
        for one in &cylinders.each {
            let push = torque * (now - critical.order.order * one.angle.value()).cos();
            work += push * vibration.shape[one.mass].value() * amplitude * (now - lead).cos();
        }
    }
    work * TAU / f64::from(STEPS)
}
