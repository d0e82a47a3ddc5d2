//! Free vibration of one degree of freedom, whatever its damping.

use dalembert_core::{
    About, Analysis, Axis, Drawing, Exhibit, Ink, Inputs, Plot, Refusal, Series, Sketch, Text, Worksheet,
    register,
};
use dalembert_mechanics::{Real, vibration::free::FreeMotion};

mod checks;
mod damping;
mod form;
mod system;

use self::{
    form::{FreeResponse, Units},
    system::{FreeOscillator, Oscillator, system},
};
use crate::{shared::turning, sources::RAO};

/// An oscillator, how it starts, and what is asked of it.
#[derive(Clone, Debug, Inputs)]
pub struct FreeVibration {
    /// Oscillator.
    pub oscillator: Oscillator,
    /// Time at which the motion is required.
    #[input("t", "s", nonnegative)]
    pub time: Option<f64>,
    /// Settling band.
    /// Fraction of the maximum displacement within which the envelope counts as settled.
    #[input("p", "%", positive, fraction, below = 100, default = "2 %")]
    pub settled: f64,
}

register!(FreeVibration);

impl Analysis for FreeVibration {
    const ABOUT: About = About {
        id: "vibration/free-vibration",
        title: "Free vibration",
        topic: "Free vibration",
        summary: "Motion of one degree of freedom from its initial conditions: regime, frequencies, displacement at any time, envelope, overshoot, settling.",
        main: &["displacement", "natural_frequency", "damping_ratio", "maximum"],
        keywords: "transient decay underdamped overdamped critically damped undamped initial conditions envelope \
                   overshoot settling phase plane vibração livre subamortecido superamortecido crítico \
                   sobressinal acomodação critically damped system free vibration of a damped system sistema \
                   criticamente amortecido vibração livre amortecida self-excited vibration negative damping \
                   galloping single degree of freedom vibração autoexcitada amortecimento negativo um grau de \
                   liberdade",
        sources: &[&RAO],
        cases: include_str!("../../cases/free_vibration.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &FreeVibrationGiven<W>, sheet: W) -> Result<(), Refusal> {
        let FreeOscillator { natural, zeta, x0, v0, elastic, units } =
            system(&given.oscillator, given.settled, sheet)?;
        let motion = FreeMotion {
            natural_frequency: natural.value(),
            damping_ratio: zeta.value(),
            displacement: x0.value(),
            velocity: v0.value(),
        };
        sheet.answer("natural_frequency", "Natural frequency", natural);
        sheet.answer("damping_ratio", "Damping ratio", zeta);
        let form = FreeResponse::of(natural, zeta, [x0, v0], &units, sheet);
        if x0.value() == 0.0 && v0.value() == 0.0 {
            sheet.warn(|| {
                Text::new(
                    "the mass starts at rest in its equilibrium position and does not move: write an initial displacement or velocity for the motion in time",
                )
            });
            sheet.show(|| Exhibit::Plot(root_locus(&motion)));
            sheet.show(|| Exhibit::Drawing(drawing(&self.oscillator)));
            return Ok(());
        }
        sheet.verify(|| checks::amplitude(&form, &motion, sheet));
        let largest = events(&form, &motion, &units, x0, sheet);
        if let Some(largest) = largest.filter(|_| zeta.value() > 0.0) {
            settling(given.settled, largest, &form, &motion, sheet);
        }
        let there = given.time.map(|time| at_time(time, &form, &motion, &units, sheet));
        if let Some((mass, stiffness)) = elastic {
            let lost = energy(mass, stiffness, [x0, v0], there, sheet);
            if let (Some([start, lost]), Some(time)) = (lost, self.time) {
                sheet.verify(|| checks::energy_lost([start, lost], mass, time, &motion, sheet));
            }
        }
        if zeta.value() < 0.0 {
            let twice = sheet.step("ρ", "1", W::Num::from(2.0), "Ratio of the amplitudes: doubled");
            let growth = sheet.step(
                "t₂",
                "s",
                twice.ln() / (-zeta * natural),
                "Time for the envelope of the motion to double",
            );
            sheet.answer("doubling_time", "Time to double", growth);
            sheet.verify(|| checks::doubling(growth, &motion, sheet));
            sheet.warn(|| {
                Text::new(
                    "the damping is negative: it feeds energy into the motion, which grows until something not in \
                     this model stops it; the position of rest is unstable",
                )
            });
        }
        sheet.show(|| Exhibit::Plot(history(&motion, self.time, &units)));
        sheet.show(|| Exhibit::Plot(phase_plane(&motion, self.time, &units)));
        sheet.show(|| Exhibit::Plot(root_locus(&motion)));
        sheet.show(|| Exhibit::Drawing(drawing(&self.oscillator)));
        Ok(())
    }
}

/// First passage through rest, first turning point, largest displacement; the last is the result, `None` of a motion
/// that grows.
fn events<W: Worksheet>(
    form: &FreeResponse<W::Num>,
    motion: &FreeMotion,
    units: &Units,
    x0: W::Num,
    sheet: W,
) -> Option<W::Num> {
    // A passage that comes when nothing is left of the motion is none.
    let left =
        |time: &f64| (-motion.damping_ratio * motion.natural_frequency * time).exp() > f64::MIN_POSITIVE;
    if let Some(zero) = motion.first_zero().filter(left) {
        let time = form.first_zero(sheet);
        sheet.check("the first passage through rest found from the motion itself", time, zero.into());
        sheet.answer("first_zero", "First passage through the equilibrium position", time);
    }
    let turning = motion.first_turning().map(|turning| {
        let time = form.first_turning(sheet);
        sheet.check("the first turning point found from the motion itself", time, turning.into());
        sheet.answer("first_turning", "First turning point after the start", time);
        let displacement = sheet.step(
            (units.symbol, 1),
            units.displacement,
            form.displacement(time),
            "Displacement at the first turning point",
        );
        sheet.answer("turning_displacement", "Displacement at that turning point", displacement);
        sheet.verify(|| checks::turning([time, displacement], motion, sheet));
        (time, displacement)
    });
    if motion.damping_ratio < 0.0 {
        return None;
    }
    // Without damping the later turning points are as far as the first.
    let (at, time, why) = match turning {
        Some((time, at)) if at.value().abs() > x0.value().abs() => {
            form.maximum_errors(sheet);
            (at, Some(time), "Maximum displacement, at the first turning point")
        }
        _ => (x0, None, "Maximum displacement, at the start"),
    };
    let largest = sheet.step("Xₘₐₓ", units.displacement, at.abs(), why);
    sheet.answer("maximum", "Maximum displacement", largest);
    if let Some(time) = time {
        sheet.answer("maximum_time", "Time of maximum displacement", time);
    }
    Some(largest)
}

/// Settling time, by the envelope and exactly.
fn settling<W: Worksheet>(
    share: W::Num,
    largest: W::Num,
    form: &FreeResponse<W::Num>,
    motion: &FreeMotion,
    sheet: W,
) {
    if let Some(envelope) = form.settling_of_envelope(share * largest, sheet) {
        sheet.answer("settling_envelope", "Settling time from the envelope", envelope);
        sheet.verify(|| checks::settling_of_envelope(envelope, share * largest, motion, sheet));
    }
    let level = share.value() * largest.value();
    let Some(time) = motion.settling_time(level) else { return };
    let settled = sheet.numerical(
        "tₚ",
        "s",
        time,
        "Settling time, exact: last instant at which the displacement equals the fraction p of the maximum",
    );
    if time > 0.0 {
        let time = settled.value();
        let there = motion.integrated(time).map_or(motion.state(time)[0], |state| state[0]);
        sheet.check(
            "the displacement at the settling time, by integration of the equation of motion",
            W::Num::from(there.abs()),
            share * largest,
        );
    }
    sheet.answer("settling_time", "Settling time", settled);
}

/// The motion at the asked time.
fn at_time<W: Worksheet>(
    time: W::Num,
    form: &FreeResponse<W::Num>,
    motion: &FreeMotion,
    units: &Units,
    sheet: W,
) -> [W::Num; 2] {
    let [x, v, a] = form.state(time, units, sheet);
    if let Some(envelope) = form.envelope(time, units, sheet) {
        sheet.answer("envelope", "Envelope at that time", envelope);
        sheet.verify(|| {
            let what = "envelope: displacement and (velocity without the decay term)/ω_d as legs of a right triangle";
            sheet.check(what, form.radius_squared([x, v]), envelope.powi(2));
        });
    }
    sheet.verify(|| {
        let size = motion.displacement.abs() + motion.velocity.abs() / motion.natural_frequency;
        let size = size * (-motion.damping_ratio * motion.natural_frequency * time.value()).exp().max(1.0);
        if let Some([displacement, velocity]) = motion.integrated(time.value()) {
            sheet.check_sum(
                "displacement by integration of the equation of motion",
                x,
                displacement.into(),
                size,
            );
            sheet.check_sum(
                "velocity by integration of the equation of motion",
                v,
                velocity.into(),
                size * motion.natural_frequency * (1.0 + motion.damping_ratio.abs()),
            );
        }
        let rate = motion.natural_frequency * (1.0 + motion.damping_ratio.abs());
        sheet.check_sum(
            "acceleration as the second derivative of the displacement",
            a,
            form.second_derivative(time),
            size * rate * rate,
        );
    });
    sheet.answer("displacement", "Displacement at that time", x);
    sheet.answer("velocity", "Velocity at that time", v);
    sheet.answer("acceleration", "Acceleration at that time", a);
    [x, v]
}

/// The energy at the start, and at the asked time.
fn energy<W: Worksheet>(
    mass: W::Num,
    stiffness: W::Num,
    [x0, v0]: [W::Num; 2],
    there: Option<[W::Num; 2]>,
    sheet: W,
) -> Option<[W::Num; 2]> {
    let of = |x: W::Num, v: W::Num| stiffness * x.powi(2) / 2.0 + mass * v.powi(2) / 2.0;
    let start = sheet.step("E₀", "J", of(x0, v0), ("Energy at the start", RAO.at("§2.2")));
    sheet.answer("energy", "Energy at the start", start);
    let [x, v] = there?;
    let lost = sheet.step("ΔE", "J", start - of(x, v), "Energy dissipated by the damper up to that time");
    sheet.answer("energy_lost", "Energy dissipated up to that time", lost);
    Some([start, lost])
}

/// The time that is drawn: until little is left, or some cycles.
fn span(motion: &FreeMotion, asked: Option<f64>) -> f64 {
    let FreeMotion { natural_frequency: w, damping_ratio: z, .. } = *motion;
    let cycles = std::f64::consts::TAU / w;
    let span = if z >= 1.0 {
        5.0 * (z + (z * z - 1.0).max(0.0).sqrt()) / w
    } else if z > 0.0 {
        (4.0 / (z * w)).max(1.5 * cycles).min(12.0 * cycles)
    } else {
        3.0 * cycles / (1.0 - z)
    };
    asked.map_or(span, |asked| if asked < 4.0 * span { span.max(1.1 * asked) } else { span })
}

fn history(motion: &FreeMotion, asked: Option<f64>, units: &Units) -> Plot {
    let span = span(motion, asked);
    let times = (0..=400u16).map(|n| span * f64::from(n) / 400.0);
    let points = times.clone().map(|t| (t, motion.state(t)[0])).collect();
    let mut series = vec![Series::line(units.symbol, points).of("displacement")];
    let (w, z) = (motion.natural_frequency, motion.damping_ratio);
    if z != 0.0 && z.abs() < 1.0 {
        let side = (motion.velocity + z * w * motion.displacement) / motion.damped_frequency();
        let size = motion.displacement.hypot(side);
        if size < 50.0 * (motion.displacement.abs() + motion.velocity.abs() / w) {
            let envelope = times.clone().map(|t| (t, size * (-z * w * t).exp()));
            series.push(Series::line("envelope", envelope.collect()).with_reflection());
        }
    }
    let mut plot = Plot::new(
        "Displacement against time",
        Axis::linear("time", "s"),
        Axis::linear("displacement", units.displacement),
        series,
    )
    .over("time");
    if let Some(time) = motion.first_turning()
        && time <= span
    {
        plot = plot.mark("first turning point", (time, motion.state(time)[0]));
    }
    if let Some(time) = asked
        && time <= span
    {
        plot = plot.mark("at the requested time", (time, motion.state(time)[0]));
    }
    plot
}

fn phase_plane(motion: &FreeMotion, asked: Option<f64>, units: &Units) -> Plot {
    let span = span(motion, asked);
    let times: Vec<f64> = (0..=400u16).map(|n| span * f64::from(n) / 400.0).collect();
    let points = times.iter().map(|time| motion.state(*time)).map(|[x, v, _]| (x, v)).collect();
    Plot::new(
        "Phase plane",
        Axis::linear("displacement", units.displacement),
        Axis::linear("velocity", units.velocity),
        vec![Series::line("motion", points).of("velocity").at(times)],
    )
    .over_answer("time", "displacement")
    .mark("start", (motion.displacement, motion.velocity))
}

/// The roots `λ = −ζω_n ± ω_n √(ζ² − 1)` as the damping ratio goes from zero upward.
fn root_locus(motion: &FreeMotion) -> Plot {
    let (w, z) = (motion.natural_frequency, motion.damping_ratio);
    let last = 1.3f64.max(1.2 * z.abs()).min(5.0) * if z < 0.0 { -1.0 } else { 1.0 };
    let roots = |z: f64| {
        let part = w * ((1.0 - z) * (1.0 + z)).abs().sqrt();
        if z.abs() < 1.0 {
            [(-z * w, part), (-z * w, -part)]
        } else {
            [(-z * w + part, 0.0), (-z * w - part, 0.0)]
        }
    };
    let branch = |which: usize| (0..=200u16).map(|n| roots(last * f64::from(n) / 200.0)[which]).collect();
    Plot::new(
        "Roots of the characteristic equation as the damping grows from zero",
        Axis::linear("real part", "rad/s"),
        Axis::linear("imaginary part", "rad/s"),
        vec![
            Series::line("λ₁", branch(0)),
            Series::line("λ₂", branch(1)),
            Series::dots("here", roots(z).to_vec()),
        ],
    )
    .equal()
}

fn drawing(oscillator: &Oscillator) -> Drawing {
    match oscillator {
        Oscillator::Rotation { .. } => {
            let mut sketch = Sketch::new("One degree of freedom in rotation");
            turning::suspended(&mut sketch, ["k_t".into(), "J".into()], 1.6);
            turning::turn(&mut sketch, "θ₀, Ω₀", (0.0, -0.35), 0.9, Ink::Motion);
            sketch.damper("c_t", (0.0, -1.5), (0.0, -0.36)).ground((-0.8, -1.5), (0.8, -1.5)).finish()
        }
        _ => {
            // The mass where it is released, beside the line of its spring at rest.
            let away = 0.7;
            Sketch::new("One degree of freedom, at the start")
                .ground((-2.6, 0.9), (-2.6, -0.9))
                .spring("k", (-2.6, 0.35), (away - 0.7, 0.35))
                .damper("c", (-2.6, -0.35), (away - 0.7, -0.35))
                .mass("m", (away - 0.7, -0.7), (away + 0.7, 0.7))
                .axis((0.0, -1.0), (0.0, 1.3))
                .dimension("x₀", (0.0, 1.1), (away, 1.1), 0.0)
                .motion("v₀", (away + 0.7, 0.0), (away + 1.4, 0.0))
                .finish()
        }
    }
}
