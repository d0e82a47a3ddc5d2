//! A flywheel for a turning moment: fluctuation of energy, and inertia against fluctuation of speed.

use std::f64::consts::TAU;

use dalembert_core::{
    About, Analysis, Axis, Exhibit, Inputs, Plot, Refusal, Series, Text, Worksheet, register,
};
use dalembert_mechanics::{
    Real,
    slider_crank::{cycle::TorqueCycle, gas::Diagram as Curve},
};

use crate::{
    shared::flywheel::{FlywheelInertia, Strokes},
    sources::{BEVAN, KHURMI},
};

/// A turning moment that repeats, against a constant resistance.
#[derive(Clone, Debug, Inputs)]
pub struct Flywheel {
    /// Turning moment.
    pub moment: Moment,
    /// Mean speed.
    #[input("ω", "rpm", positive)]
    pub speed: f64,
    /// Sought.
    pub sought: FlywheelUnknown,
}

/// Turning moment of the cycle.
#[derive(Clone, Debug, Inputs)]
pub enum Moment {
    /// Mean and harmonics
    Harmonics {
        /// Mean turning moment.
        #[input("T_m", "N*m")]
        mean: f64,
        /// Harmonics.
        #[input(table)]
        rows: Vec<TorqueHarmonic>,
    },
    /// Table against the crank angle
    /// Linear interpolation between its rows.
    Table {
        /// Strokes of a cycle.
        strokes: Strokes,
        /// Turning moment.
        #[input(table)]
        rows: Vec<MomentRow>,
    },
    /// Areas between the curve and its mean
    /// In order, above the mean positive and below it negative.
    Areas {
        /// Areas.
        #[input("A", "mm^2")]
        areas: Vec<f64>,
        /// Scale of the moments.
        #[input("μ_T", "N*m/mm", positive)]
        moment_scale: f64,
        /// Scale of the angles.
        #[input("μ_θ", "deg/mm", positive)]
        angle_scale: f64,
    },
    /// Fluctuation of energy given
    Energy {
        /// Fluctuation of energy.
        #[input("ΔE", "J", positive)]
        energy: f64,
    },
}

/// A harmonic of the turning moment, a sin kθ + b cos kθ.
#[derive(Clone, Debug, Inputs)]
pub struct TorqueHarmonic {
    /// Order.
    /// An integer, or a half-integer in a cycle of two revolutions.
    #[input("k", "1", positive, max = 48)]
    pub order: f64,
    /// Sine coefficient.
    #[input("a", "N*m")]
    pub sine: f64,
    /// Cosine coefficient.
    #[input("b", "N*m")]
    pub cosine: f64,
}

/// A row of a turning moment diagram.
#[derive(Clone, Debug, Inputs)]
pub struct MomentRow {
    /// Crank angle.
    #[input("θ", "deg")]
    pub angle: f64,
    /// Turning moment.
    #[input("T", "N*m")]
    pub moment: f64,
}

/// Inertia or fluctuation of speed.
#[derive(Clone, Debug, Inputs)]
pub enum FlywheelUnknown {
    /// Inertia for a given fluctuation of speed
    Inertia {
        /// Coefficient of fluctuation of speed.
        /// Maximum minus minimum speed, divided by the mean; twice the value stated as ± of the mean.
        #[input("C_s", "%", positive, max = 100)]
        fluctuation: f64,
        /// Radius of gyration.
        /// Used to find the mass of the flywheel.
        #[input("k_F", "m", positive)]
        radius: Option<f64>,
    },
    /// Fluctuation of speed of a flywheel
    Fluctuation {
        /// Inertia of the flywheel.
        inertia: FlywheelInertia,
    },
}

register!(Flywheel);

/// The moment over a cycle.
struct Curved {
    cycle: TorqueCycle,
    period: f64,
    points: Vec<(f64, f64)>,
}

impl Analysis for Flywheel {
    const ABOUT: About = About {
        id: "virtual-work/flywheel",
        title: "Flywheel",
        topic: "Engines, gears and wheels",
        summary: "Energy fluctuation of a turning moment, and flywheel inertia for a speed fluctuation, or the speed fluctuation for an inertia.",
        keywords: "volante de inércia flutuação de energia coeficiente de flutuação de velocidade diagrama de torque \
                   flywheel fluctuation of energy coefficient of fluctuation of speed turning moment diagram steadiness",
        sources: &[&KHURMI, &BEVAN],
        cases: include_str!("../../cases/flywheel.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &FlywheelGiven<W>, sheet: W) -> Result<(), Refusal> {
        let energy = self.energy(given, sheet)?;
        sheet.answer("energy_fluctuation", "Fluctuation of energy", energy);
        let square = given.speed.powi(2);
        let cite = KHURMI.at("ch. 16");
        let mut rim = None;
        let (inertia, fluctuation) = match &given.sought {
            FlywheelUnknownGiven::Inertia { fluctuation, radius } => {
                if energy.value() == 0.0 {
                    return Err(Refusal::because(
                        "the turning moment is constant and equal to its mean: no flywheel is needed",
                    ));
                }
                let why = (
                    "Moment of inertia: the energy ½ I (ω₁² − ω₂²) = I ω² C_s absorbs the fluctuation",
                    cite,
                );
                let inertia = sheet.step("I_F", "kg*m^2", energy / (square * *fluctuation), why);
                if let Some(radius) = radius {
                    let mass = sheet.step("m_F", "kg", inertia / radius.powi(2), "Mass of the flywheel");
                    sheet.answer("mass", "Mass of the flywheel", mass);
                    rim = Some(mass * radius.powi(2));
                }
                (inertia, *fluctuation)
            }
            FlywheelUnknownGiven::Fluctuation { inertia } => {
                let inertia = inertia.moment(sheet);
                let why = ("Coefficient of fluctuation of speed, from I ω² C_s = ΔE", cite);
                (inertia, sheet.step("C_s", "%", energy / (inertia * square), why))
            }
        };
        if fluctuation.value() > 0.5 {
            sheet.warn(|| {
                Text::new(
                    "the speed would vary by more than half its value: the turning moment at a constant speed is no longer valid",
                )
            });
        }
        let half = || fluctuation / 2.0;
        let fast = sheet.step("ω₁", "rpm", given.speed * (half() + 1.0), "Maximum speed");
        let slow = sheet.step("ω₂", "rpm", given.speed * (W::Num::from(1.0) - half()), "Minimum speed");
        sheet.answer("inertia", "Moment of inertia of the flywheel", inertia);
        sheet.answer("fluctuation", "Coefficient of fluctuation of speed", fluctuation);
        sheet.answer("greatest_speed", "Maximum speed", fast);
        sheet.answer("least_speed", "Minimum speed", slow);
        sheet.verify(|| {
            let range = inertia * (fast.powi(2) - slow.powi(2)) / 2.0;
            let scale = inertia.value() * fast.value().powi(2);
            let what = "the flywheel's kinetic energies at both speeds differ by the fluctuation";
            sheet.check_zero(what, range - energy, scale.max(energy.value()));
            if let Some(rim) = rim {
                let range = rim * (fast.powi(2) - slow.powi(2)) / 2.0;
                let what =
                    "the mass of the flywheel at its radius of gyration absorbs the fluctuation of energy";
                sheet.check(what, range, energy);
            }
        });
        Ok(())
    }
}

impl Flywheel {
    fn energy<W: Worksheet>(&self, given: &FlywheelGiven<W>, sheet: W) -> Result<W::Num, Refusal> {
        match (&self.moment, &given.moment) {
            (Moment::Harmonics { mean, rows }, MomentGiven::Harmonics { mean: given_mean, .. }) => {
                let moment = |angle: f64| {
                    let waves = rows.iter().map(|row| {
                        let (sine, cosine) = (row.order * angle).sin_cos();
                        row.sine * sine + row.cosine * cosine
                    });
                    mean + waves.sum::<f64>()
                };
                let period = period(rows)?;
                let curved = curved(moment, period, &[]);
                let done = curved.cycle.mean * period;
                let energy = fluctuation(&curved, given.speed, *given_mean, done, sheet);
                sheet.verify(|| {
                    // The work above the mean has a closed form: the integral of every harmonic.
                    let work = |angle: f64| -> f64 {
                        let of = |row: &TorqueHarmonic| {
                            let (sine, cosine) = (row.order * angle).sin_cos();
                            (row.cosine * sine - row.sine * cosine) / row.order
                        };
                        rows.iter().map(of).sum()
                    };
                    let all: Vec<f64> =
                        curved.cycle.crossings.iter().map(|(angle, _)| work(*angle)).collect();
                    let most = all.iter().copied().fold(f64::NEG_INFINITY, f64::max);
                    let least = all.iter().copied().fold(f64::INFINITY, f64::min);
                    let again = if most > least { most - least } else { 0.0 };
                    let scale: f64 = rows.iter().map(|row| row.sine.abs() + row.cosine.abs()).sum();
                    let what = "fluctuation of energy from the integrals of the harmonics";
                    sheet.check_sum(what, energy, again.into(), scale);
                });
                Ok(energy)
            }
            (Moment::Table { strokes, rows }, _) => {
                let turns = strokes.turns();
                let period = TAU * f64::from(turns);
                let rows: Vec<[f64; 2]> = rows.iter().map(|row| [row.angle, row.moment]).collect();
                let span = match rows[..] {
                    [first, .., last] => last[0] - first[0],
                    _ => f64::INFINITY,
                };
                let ascending = rows.windows(2).all(|pair| pair[0][0] < pair[1][0]);
                if !ascending || span > period * (1.0 + 1e-9) {
                    return Err(Refusal::because(
                        "the table needs at least two rows in ascending order of crank angle, within one cycle",
                    ));
                }
                let corners: Vec<f64> = rows.iter().map(|row| row[0]).collect();
                let trapezia = trapezia(&rows, period);
                let curve = Curve::Angle { rows, turns };
                let moment = |angle: f64| curve.pressure(angle, 0.0, true);
                let curved = curved(moment, period, &corners);
                let mean =
                    sheet.numerical("T_m", "N*m", curved.cycle.mean, "Mean turning moment over the cycle");
                sheet.verify(|| {
                    let scale = curved.cycle.rms;
                    let what = "mean turning moment from the trapezia between the rows";
                    sheet.check_sum(what, mean, trapezia.into(), scale);
                });
                Ok(fluctuation(&curved, given.speed, mean, trapezia * period, sheet))
            }
            (
                Moment::Areas { areas, .. },
                MomentGiven::Areas { areas: given_areas, moment_scale, angle_scale },
            ) => energy_of_areas(areas, given_areas, *moment_scale, *angle_scale, sheet),
            (_, MomentGiven::Energy { energy }) => Ok(*energy),
            _ => unreachable!("what is given is made from the inputs"),
        }
    }
}

/// Mean, extremes and fluctuation of a curve. `done` is the work of a cycle in another way.
fn fluctuation<W: Worksheet>(curved: &Curved, speed: W::Num, mean: W::Num, done: f64, sheet: W) -> W::Num {
    let cycle = &curved.cycle;
    sheet.answer_list(
        "crossings",
        "Crank angles at which the turning moment crosses its mean",
        "deg",
        &cycle.crossings.iter().map(|(angle, _)| *angle).collect::<Vec<f64>>(),
    );
    let by = |sign: f64| {
        let work = |it: &&(f64, f64)| sign * it.1;
        cycle.crossings.iter().max_by(|a, b| work(a).total_cmp(&work(b))).map_or((0.0, 0.0), |it| *it)
    };
    let (most, least) = (by(1.0), by(-1.0));
    let most_work = sheet.numerical(
        "E₁",
        "J",
        most.1,
        "Maximum work above the mean, from the start of the cycle to a crossing: the speed is maximum there",
    );
    let least_work =
        sheet.numerical("E₂", "J", least.1, "Minimum of the same work: the speed is minimum there");
    let energy =
        sheet.step("ΔE", "J", most_work - least_work, ("Fluctuation of energy", KHURMI.at("ch. 16")));
    let power = sheet.step("P", "kW", mean * speed, "Mean power");
    sheet.answer("mean_moment", "Mean turning moment over the cycle", mean);
    sheet.answer("power", "Mean power", power);
    // The rounding of the work is that of the moments that it is added up from.
    let size = cycle.rms * curved.period;
    sheet.verify(|| {
        let time = W::Num::from(curved.period) / speed;
        sheet.check_sum("work of a cycle from its mean power and its time", power * time, done.into(), size);
    });
    let work = mean * curved.period;
    if mean.value() != 0.0 && energy.value() != 0.0 {
        let why = ("Coefficient of fluctuation of energy: ratio to the work per cycle", KHURMI.at("ch. 16"));
        let part = sheet.step("C_E", "1", energy / work.abs(), why);
        sheet.answer("energy_coefficient", "Coefficient of fluctuation of energy", part);
        sheet.verify(|| {
            let what = "fluctuation of energy as a fraction of the work per cycle";
            sheet.check_sum(what, part * done.abs(), cycle.fluctuation.into(), size);
        });
    }
    let mean = mean.value();
    sheet.show(|| Exhibit::Plot(plot(curved, mean)));
    energy
}

/// Fluctuation of energy from the areas between the curve and its mean.
fn energy_of_areas<W: Worksheet>(
    areas: &[f64],
    given: &[W::Num],
    moment_scale: W::Num,
    angle_scale: W::Num,
    sheet: W,
) -> Result<W::Num, Refusal> {
    if areas.len() < 2 {
        return Err(Refusal::because(
            "one area alone cannot close a cycle: write all areas in order, with their signs",
        ));
    }
    let scale =
        sheet.step("μ", "J/mm^2", moment_scale * angle_scale, "Energy of a square millimetre of the diagram");
    let (mut sums, mut so_far) = (Vec::new(), 0.0);
    for area in areas {
        so_far += area;
        sums.push(so_far);
    }
    let size = areas.iter().map(|area| area.abs()).sum::<f64>();
    if so_far.abs() > 0.01 * size {
        sheet.warn(|| {
                Text::new("the areas above and below the mean differ by {rest}: the curve does not close over the cycle")
                    .with_quantity("rest", so_far, "mm^2")
            });
    }
    let best = |sign: f64| {
        let mut at = 0;
        for (k, sum) in sums.iter().enumerate() {
            if sign * sum > sign * sums[at] {
                at = k;
            }
        }
        at
    };
    let (most, least) = (best(1.0), best(-1.0));
    let sum = |to: usize| W::Num::sum(given[..=to].iter().copied());
    let why = "Maximum cumulative area, at a crossing: the speed is maximum there";
    let most_area = sheet.step("A_max", "mm^2", sum(most), why);
    let why = "Minimum cumulative area, at a crossing";
    let least_area = sheet.step("A_min", "mm^2", sum(least), why);
    let energy = sheet.step(
        "ΔE",
        "J",
        (most_area - least_area) * scale,
        ("Fluctuation of energy", KHURMI.at("ch. 16")),
    );
    sheet.verify(|| {
        let (from, to) = (most.min(least), most.max(least));
        let between: f64 = areas[from + 1..=to].iter().sum();
        let what = "the fluctuation from the areas between the two crossings";
        sheet.check_sum(what, energy, (scale.value() * between.abs()).into(), scale.value() * size);
    });
    Ok(energy)
}

/// The mean of straight lines through the rows, closed over the period.
fn trapezia(rows: &[[f64; 2]], period: f64) -> f64 {
    let inside: f64 =
        rows.windows(2).map(|pair| f64::midpoint(pair[0][1], pair[1][1]) * (pair[1][0] - pair[0][0])).sum();
    let closing = match rows {
        [first, .., last] => f64::midpoint(first[1], last[1]) * (period - (last[0] - first[0])),
        _ => 0.0,
    };
    (inside + closing) / period
}

/// One turn where all orders are whole, two where some are halves.
fn period(rows: &[TorqueHarmonic]) -> Result<f64, Refusal> {
    let whole = |x: f64| (x - x.round()).abs() < 1e-9;
    if rows.is_empty() {
        return Err(Refusal::because(
            "without harmonics the turning moment is its mean: write at least one harmonic",
        ));
    }
    if rows.iter().all(|row| whole(row.order)) {
        Ok(TAU)
    } else if rows.iter().all(|row| whole(2.0 * row.order)) {
        Ok(2.0 * TAU)
    } else {
        Err(Refusal::because(
            "an order is neither an integer nor a half-integer, so the turning moment is not periodic over two revolutions",
        ))
    }
}

fn curved(moment: impl Fn(f64) -> f64, period: f64, corners: &[f64]) -> Curved {
    let cycle = TorqueCycle::of(&moment, period, corners);
    let points =
        (0..=360).map(|k| period * f64::from(k) / 360.0).map(|angle| (angle, moment(angle))).collect();
    Curved { cycle, period, points }
}

fn plot(curved: &Curved, mean: f64) -> Plot {
    let cycle = &curved.cycle;
    let crossings = cycle.crossings.iter().map(|(angle, _)| (*angle, mean)).collect();
    Plot::new(
        "Turning moment over the cycle",
        Axis::linear("Crank angle", "deg"),
        Axis::linear("Turning moment", "N*m"),
        vec![
            Series::line("turning moment", curved.points.clone()),
            Series::dots("crossings of the mean", crossings),
        ],
    )
    .level("mean", mean)
}
