//! A flywheel for a turning moment: fluctuation of energy, and inertia against fluctuation of speed.

mod curves;

use std::f64::consts::FRAC_PI_3;

use dalembert_core::{
    About, Analysis, Drawing, Exhibit, Ink, Inputs, Refusal, Sketch, Text, Worksheet, register,
};
use dalembert_mechanics::Real;

use self::curves::{Course, Curved, curved, harmonics, plot, table};
use crate::{
    shared::{
        figure,
        flywheel::{FlywheelInertia, Strokes},
    },
    sources::{BEVAN, KHURMI},
};

/// A turning moment that repeats, against a load that is constant or repeats too.
#[derive(Clone, Debug, Inputs)]
pub struct Flywheel {
    /// Turning moment.
    pub moment: Moment,
    /// Load torque.
    #[input(default = "constant")]
    pub load: LoadTorque,
    /// Mean speed.
    #[input("ω", "rpm", positive)]
    pub speed: f64,
    /// Find.
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

/// Torque of the driven machine over the cycle. At a steady speed its mean is that of the turning moment.
#[derive(Clone, Debug, Inputs)]
pub enum LoadTorque {
    /// Constant
    Constant,
    /// Harmonics about the mean
    Harmonics {
        /// Harmonics.
        #[input(table)]
        rows: Vec<TorqueHarmonic>,
    },
    /// Table against the crank angle
    /// Linear interpolation between its rows.
    Table {
        /// Strokes of a cycle.
        strokes: Strokes,
        /// Load torque.
        #[input(table)]
        rows: Vec<LoadRow>,
    },
}

/// A row of a diagram of the load torque.
#[derive(Clone, Debug, Inputs)]
pub struct LoadRow {
    /// Crank angle.
    #[input("θ", "deg")]
    pub angle: f64,
    /// Load torque.
    #[input("T_L", "N*m")]
    pub moment: f64,
}

/// A harmonic of a torque, a sin kθ + b cos kθ.
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
        #[input("C_s", "%", positive, fraction, max = 100)]
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

impl Analysis for Flywheel {
    const ABOUT: About = About {
        id: "virtual-work/flywheel",
        title: "Flywheel",
        topic: "Engines, gears and wheels",
        summary: "Energy fluctuation of a turning moment against a constant or varying load, and flywheel inertia for a speed fluctuation, or the speed fluctuation for an inertia.",
        main: &["inertia", "mass", "fluctuation", "energy_fluctuation"],
        keywords: "volante de inércia flutuação de energia coeficiente de flutuação de velocidade diagrama de torque \
                   flywheel fluctuation of energy coefficient of fluctuation of speed turning moment diagram steadiness \
                   smoothing the input torque energy storage volante torque de entrada",
        sources: &[&KHURMI, &BEVAN],
        cases: include_str!("../../cases/flywheel.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &FlywheelGiven<W>, sheet: W) -> Result<(), Refusal> {
        let (energy, excess) = self.energy(given, sheet)?;
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
                let of_range = || energy * 2.0 / (given.speed * *fluctuation).powi(2);
                let below_given = || {
                    let slow = W::Num::from(1.0) - *fluctuation;
                    energy * 2.0 / (square * (W::Num::from(1.0) - slow.powi(2)))
                };
                sheet.common_error(
                    "I_F",
                    "the energy of the difference of the speeds, ½ I (ω₁ − ω₂)², used",
                    of_range,
                );
                sheet.common_error("I_F", "the given speed taken as the maximum speed", below_given);
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
                let of_range = || (energy * 2.0 / inertia).sqrt() / given.speed;
                let below_given =
                    || W::Num::from(1.0) - (W::Num::from(1.0) - energy * 2.0 / (inertia * square)).sqrt();
                sheet.common_error(
                    "C_s",
                    "the energy of the difference of the speeds, ½ I (ω₁ − ω₂)², used",
                    of_range,
                );
                sheet.common_error("C_s", "the given speed taken as the maximum speed", below_given);
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
        if let Some(excess) = excess {
            accelerations(&excess, inertia, sheet);
        }
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
        sheet.show(|| Exhibit::Drawing(self.drawing()));
        Ok(())
    }
}

/// Crank angles and moments that accelerate and retard the flywheel most, and the moment at any angle.
struct Excess<'a> {
    most: [(f64, f64); 2],
    at: Box<dyn Fn(f64) -> f64 + 'a>,
}

impl Flywheel {
    /// The flywheel, in front of its shaft and from its side.
    fn drawing(&self) -> Drawing {
        let (mass, radius) = match &self.sought {
            FlywheelUnknown::Inertia { radius, .. } => (radius.map_or("I_F", |_| "m_F"), radius.is_some()),
            FlywheelUnknown::Fluctuation { inertia: FlywheelInertia::Gyration { .. } } => ("m_F", true),
            FlywheelUnknown::Fluctuation { inertia: FlywheelInertia::Moment { .. } } => ("I_F", false),
        };
        let moment = if let Moment::Harmonics { .. } = self.moment { "T_m" } else { "T" };
        let (o, side) = ((0.0, 0.0), 2.2);
        let mut sketch = Sketch::new("The flywheel and its shaft");
        sketch.size(4.0).disc("", o, 1.0).circle(o, 0.8, Ink::Body);
        for spoke in 0..6 {
            let angle = f64::from(spoke) * FRAC_PI_3 + 0.2;
            sketch.bars([o, figure::away(o, 0.8, angle)]);
        }
        if radius {
            sketch.circle(o, 0.9, Ink::Faint).dimension("k_F", o, figure::away(o, 0.9, -FRAC_PI_3), 0.0);
        }
        sketch.joint("", o);
        figure::turning(&mut sketch, o, ("ω", self.speed), (moment, 1.0));
        sketch
            .link("", (side - 0.8, 0.0), (side + 0.8, 0.0))
            .mass("", (side - 0.18, -1.0), (side + 0.18, 1.0))
            .label(mass, (side, 1.0))
            .bearing("", (side - 0.5, 0.0), 0.0)
            .bearing("", (side + 0.5, 0.0), 0.0);
        sketch.finish()
    }

    /// The load torque less its mean, where it varies.
    fn load<W: Worksheet>(&self, mean: f64, sheet: W) -> Result<Option<Course<'_>>, Refusal> {
        match &self.load {
            LoadTorque::Constant => Ok(None),
            LoadTorque::Harmonics { rows } => Ok(Some(harmonics(rows)?)),
            LoadTorque::Table { strokes, rows } => {
                let rows: Vec<[f64; 2]> = rows.iter().map(|row| [row.angle, row.moment]).collect();
                let (course, own) = table(rows, *strokes)?;
                let size = own.abs().max(mean.abs());
                if (own - mean).abs() > 0.01 * size {
                    sheet.warn(|| {
                        Text::new("the mean of the load torque, {load}, is not that of the turning moment, {mean}: no speed is steady, and the fluctuation is that of the variations alone")
                            .with_quantity("load", own, "N*m")
                            .with_quantity("mean", mean, "N*m")
                    });
                }
                let Course { at, period, corners } = course;
                Ok(Some(Course { at: Box::new(move |angle| at(angle) - own), period, corners }))
            }
        }
    }

    /// The fluctuation of energy, and what accelerates the flywheel where the moment is known over the cycle.
    fn energy<W: Worksheet>(
        &self,
        given: &FlywheelGiven<W>,
        sheet: W,
    ) -> Result<(W::Num, Option<Excess<'_>>), Refusal> {
        let is_curve = matches!(self.moment, Moment::Harmonics { .. } | Moment::Table { .. });
        if !is_curve && !matches!(self.load, LoadTorque::Constant) {
            return Err(Refusal::because(
                "areas and a fluctuation of energy are those between the turning moment and its load already: choose a constant load",
            ));
        }
        match (&self.moment, &given.moment) {
            (Moment::Harmonics { mean, rows }, MomentGiven::Harmonics { mean: given_mean, .. }) => {
                let driving = harmonics(rows)?;
                let load = self.load(*mean, sheet)?;
                let (curved, at) = curved(driving, load, *mean);
                let done = curved.cycle.mean * curved.period;
                let energy = fluctuation(&curved, given.speed, *given_mean, done, sheet);
                let both: Option<Vec<(f64, &TorqueHarmonic)>> = match &self.load {
                    LoadTorque::Table { .. } => None,
                    LoadTorque::Constant => Some(rows.iter().map(|row| (1.0, row)).collect()),
                    LoadTorque::Harmonics { rows: load } => {
                        let load = load.iter().map(|row| (-1.0, row));
                        Some(rows.iter().map(|row| (1.0, row)).chain(load).collect())
                    }
                };
                if let Some(rows) = both {
                    sheet.verify(|| {
                        // The work above the mean has a closed form: the integral of every harmonic.
                        let work = |angle: f64| -> f64 {
                            let of = |(sign, row): &(f64, &TorqueHarmonic)| {
                                let (sine, cosine) = (row.order * angle).sin_cos();
                                sign * (row.cosine * sine - row.sine * cosine) / row.order
                            };
                            rows.iter().map(of).sum()
                        };
                        let all: Vec<f64> =
                            curved.cycle.crossings.iter().map(|(angle, _)| work(*angle)).collect();
                        let most = all.iter().copied().fold(f64::NEG_INFINITY, f64::max);
                        let least = all.iter().copied().fold(f64::INFINITY, f64::min);
                        let again = if most > least { most - least } else { 0.0 };
                        let scale: f64 = rows.iter().map(|(_, row)| row.sine.abs() + row.cosine.abs()).sum();
                        let what = "fluctuation of energy from the integrals of the harmonics";
                        sheet.check_sum(what, energy, again.into(), scale);
                    });
                }
                Ok((energy, Some(Excess { most: curved.excess, at })))
            }
            (Moment::Table { strokes, rows }, _) => {
                let rows: Vec<[f64; 2]> = rows.iter().map(|row| [row.angle, row.moment]).collect();
                let (driving, trapezia) = table(rows, *strokes)?;
                let load = self.load(trapezia, sheet)?;
                let (curved, at) = curved(driving, load, 0.0);
                let mean =
                    sheet.numerical("T_m", "N*m", curved.cycle.mean, "Mean turning moment over the cycle");
                sheet.verify(|| {
                    let scale = curved.cycle.rms;
                    let what = "mean turning moment from the trapezia between the rows";
                    sheet.check_sum(what, mean, trapezia.into(), scale);
                });
                let energy = fluctuation(&curved, given.speed, mean, trapezia * curved.period, sheet);
                Ok((energy, Some(Excess { most: curved.excess, at })))
            }
            (
                Moment::Areas { areas, .. },
                MomentGiven::Areas { areas: given_areas, moment_scale, angle_scale },
            ) => Ok((energy_of_areas(areas, given_areas, *moment_scale, *angle_scale, sheet)?, None)),
            (_, MomentGiven::Energy { energy }) => Ok((*energy, None)),
            _ => unreachable!("what is given is made from the inputs"),
        }
    }
}

/// Mean, extremes and fluctuation of a curve. `done` is the work of a cycle in another way.
fn fluctuation<W: Worksheet>(curved: &Curved, speed: W::Num, mean: W::Num, done: f64, sheet: W) -> W::Num {
    let cycle = &curved.cycle;
    let label = if curved.load.is_some() {
        "Crank angles at which the turning moment equals the load"
    } else {
        "Crank angles at which the turning moment crosses its mean"
    };
    sheet.answer_list(
        "crossings",
        label,
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
        "Maximum work above the load, from the start of the cycle to a crossing: the speed is maximum there",
    );
    let least_work =
        sheet.numerical("E₂", "J", least.1, "Minimum of the same work: the speed is minimum there");
    if cycle.crossings.len() > 2 {
        let areas = || {
            let works = &cycle.crossings;
            (0..works.len()).map(move |n| works[(n + 1) % works.len()].1 - works[n].1)
        };
        let of_range = |area: f64| (most_work - least_work) * (area / (most.1 - least.1));
        let largest = || of_range(areas().map(f64::abs).fold(0.0, f64::max));
        let above = || of_range(areas().filter(|area| *area > 0.0).sum());
        sheet.common_error("ΔE", "the largest single area between the moment and the load taken", largest);
        sheet.common_error("ΔE", "all areas above the load added up", above);
    }
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
    if given.len() > 2 {
        let largest = || given.iter().fold(given[0].abs(), |most, area| most.max(area.abs())) * scale;
        let above = || W::Num::sum(given.iter().copied().filter(|area| area.value() > 0.0)) * scale;
        sheet.common_error("ΔE", "the largest single area between the moment and the load taken", largest);
        sheet.common_error("ΔE", "all areas above the load added up", above);
    }
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

/// Answers the extreme angular accelerations of the flywheel.
fn accelerations<W: Worksheet>(excess: &Excess<'_>, inertia: W::Num, sheet: W) {
    let names = [
        ("T₁", "θ₁", "α₁", "greatest_acceleration", "greatest_acceleration_angle"),
        ("T₂", "θ₂", "α₂", "least_acceleration", "least_acceleration_angle"),
    ];
    let words = [
        [
            "Maximum of turning moment less load",
            "Crank angle there",
            "Maximum angular acceleration of the flywheel",
            "Crank angle at the maximum acceleration",
        ],
        [
            "Minimum of turning moment less load",
            "Crank angle there",
            "Minimum angular acceleration of the flywheel",
            "Crank angle at the minimum acceleration",
        ],
    ];
    let size = excess.most.iter().map(|(_, moment)| moment.abs()).fold(0.0, f64::max);
    for (((moment_symbol, angle_symbol, symbol, name, angle_name), sign), (words, &(angle, moment))) in
        names.into_iter().zip([1.0, -1.0]).zip(words.into_iter().zip(&excess.most))
    {
        let moment = sheet.numerical(moment_symbol, "N*m", moment, words[0]);
        let angle = sheet.numerical(angle_symbol, "deg", angle, words[1]);
        let acceleration = sheet.step(symbol, "rad/s^2", moment / inertia, words[2]);
        sheet.answer(name, words[2], acceleration);
        sheet.answer(angle_name, words[3], angle);
        sheet.verify(|| {
            let there = W::Num::from((excess.at)(angle.value()));
            let what = "the angular acceleration from turning moment and load at that crank angle";
            sheet.check_sum(what, acceleration * inertia, there, size);
            // No crank angle of a finer search has more.
            let beyond = (0..5760u16)
                .map(|k| 4.0 * std::f64::consts::PI * f64::from(k) / 5760.0)
                .map(|angle| sign * (excess.at)(angle))
                .fold(f64::NEG_INFINITY, f64::max);
            let over = (beyond - sign * moment.value()).max(0.0);
            sheet.check_zero("no crank angle has a more extreme moment", W::Num::from(over), size);
        });
    }
}
