//! Motion in time of systems with many degrees of freedom.

use dalembert_core::{
    About, Analysis, Axis, Exhibit, Inputs, Name, Plot, Refusal, Series, Symbol, Text, Worksheet, register,
};
use dalembert_mechanics::{
    Real,
    vibration::{
        poles::Poles,
        response::{TimeExcitation, TimeResponse, state_by_series},
    },
};
use nalgebra::{Complex, DMatrix};

use crate::{
    shared::system::{
        Assembled, System, assemble,
        damping::{ModalDamping, SystemDamping, in_modes},
        excitation::{BaseAcceleration, Excitation, Force, InitialCondition, Observed, loads},
        histories::History,
        modes::{WorkedModes, find},
        picture,
    },
    sources::RAO,
};

/// Points of a curve.
const POINTS: usize = 400;
/// The most examines the motion for its largest displacement, times the number of poles.
const LOOKS: usize = 4_000_000;
/// The most steps of the second method; longer motions are not followed step by step.
const LIMIT: usize = 150;

/// The system, its start, the forces on it, and what is asked for.
#[derive(Clone, Debug, Inputs)]
pub struct MultiDegreeResponse {
    /// System.
    pub system: System,
    /// Damping.
    pub damping: SystemDamping,
    /// Initial conditions.
    /// Coordinates that are not listed start from rest.
    pub start: Vec<InitialCondition>,
    /// Forces.
    pub forces: Vec<Force>,
    /// Accelerations of the base.
    /// All coordinates are displacements in its direction, and are then relative to it.
    pub base: Vec<BaseAcceleration>,
    /// Times.
    /// At which the motion is requested.
    #[input(table)]
    pub times: Vec<OutputTime>,
    /// Observed coordinates.
    #[input(min = 1)]
    pub observed: Vec<Observed>,
    /// Time span of the plots.
    #[input("t_e", "s", positive)]
    pub duration: Option<f64>,
}

/// A time that is asked for.
#[derive(Clone, Debug, Inputs)]
pub struct OutputTime {
    /// Time.
    #[input("t", "s", nonnegative)]
    pub time: f64,
}

register!(MultiDegreeResponse);

impl Analysis for MultiDegreeResponse {
    const ABOUT: About = About {
        id: "vibration/multi-degree-response",
        title: "Motion of many degrees of freedom in time",
        topic: "Several degrees of freedom",
        summary: "Exact motion of a chain or of given matrices from initial conditions, under steps, pulses, ramps, harmonic forces or tables of forces, or on a moving base, with any damping.",
        main: &["largest", "largest_time", "frequency"],
        keywords: "transient time response mdof pulse step initial conditions modal superposition state space \
                   transitório resposta no tempo condições iniciais pulso degrau superposição modal vários graus \
                   de liberdade",
        sources: &[&RAO],
        cases: include_str!("../../cases/multi_degree_response.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &MultiDegreeResponseGiven<W>, sheet: W) -> Result<(), Refusal> {
        let system = assemble(&self.system, &given.system, sheet)?;
        if self.times.len() > 50 {
            return Err(Refusal::because("at most 50 times and 50 coordinates are computed at a time"));
        }
        let Self { start, forces, base, observed, .. } = self;
        let excitation = Excitation { start, forces, base, observed }.over(&system.mass)?;
        let found = find(&system, sheet)?;
        let damped =
            in_modes(&self.damping, &given.damping, &system.damping, &system.mass, &found.modes, sheet)?;
        for (mode, frequency) in found.frequencies.iter().enumerate() {
            sheet.answer(("frequency", mode + 1), "Natural frequency", *frequency);
        }
        let last_asked = self.times.iter().map(|asked| asked.time).fold(0.0, f64::max);
        let duration = self.duration.unwrap_or_else(|| self.shown(last_asked, &found));
        let poles = Poles::new(&found.modes, &damped.matrix, duration.max(last_asked)).map_err(|_| {
            Refusal::because(
                "two damped modes share one root and one mode shape (critical damping): change a damper by a millionth",
            )
        })?;
        let momentum = found.modes.shapes.transpose() * &system.mass;
        let motion = TimeResponse::new(&poles, &momentum, &excitation);
        self.write(&system, &damped, &excitation, &poles, &motion, sheet)?;
        self.resonance(&found, &damped, sheet);
        sheet.show(|| Exhibit::Drawing(picture::at_rest(&self.system, &loads(&self.forces))));
        let matrices = [&system.mass, &damped.physical, &system.stiffness];
        self.curves(&poles, &motion, (matrices, &excitation), duration, sheet)
    }
}

impl MultiDegreeResponse {
    /// Time histories of forces and of the base.
    fn histories(&self) -> impl Iterator<Item = History> {
        let forces = self.forces.iter().map(|row| row.course.history());
        forces.chain(self.base.iter().map(|row| row.course.history())).flatten()
    }

    /// Default time span of the curves.
    fn shown<N>(&self, last_asked: f64, found: &WorkedModes<N>) -> f64 {
        let period = found
            .modes
            .squares
            .iter()
            .find(|square| **square > 0.0)
            .map_or(0.0, |square| std::f64::consts::TAU / square.sqrt());
        let forced = self.histories().map(|history| history.end());
        let forced = forced.fold(0.0, f64::max);
        (1.2 * last_asked).max(forced + 3.0 * period).max(1e-9)
    }

    fn write<W: Worksheet>(
        &self,
        system: &Assembled<W::Num>,
        damped: &ModalDamping,
        excitation: &TimeExcitation,
        poles: &Poles,
        motion: &TimeResponse<'_>,
        sheet: W,
    ) -> Result<(), Refusal> {
        for (place, asked) in self.times.iter().enumerate() {
            sheet.keep_going()?;
            let state = motion.state(asked.time);
            let mut shown = Vec::with_capacity(self.observed.len());
            for row in &self.observed {
                let at = row.coordinate;
                let symbol = |base| Symbol::from(base).row(place + 1).row(at);
                let why = Text::new(
                    "Displacement of coordinate {at} at time {place}: modal responses from breakpoint to breakpoint of the forces, each in closed form",
                );
                let why = why.with("at", at).with("place", place + 1);
                let x = finite(poles.displacement(at - 1, &state))?;
                let v = finite(poles.velocity(at - 1, &state))?;
                let x = sheet.numerical(symbol("x"), "m", x, (why, RAO.at("§6.14")));
                sheet.answer(("displacement", place + 1, at), "Displacement", x);
                let v = sheet.numerical(symbol("v"), "m/s", v, "Velocity at that time");
                sheet.answer(("velocity", place + 1, at), "Velocity", v);
                shown.push([x.value(), v.value()]);
            }
            sheet.verify(|| {
                if system.size() > 12 {
                    return;
                }
                let matrices = [&system.mass, &damped.physical, &system.stiffness];
                let Ok([series, rates]) = state_by_series(matrices, excitation, asked.time, LIMIT) else { return };
                for (row, [x, v]) in self.observed.iter().zip(shown) {
                    sheet.check_zero(
                        Text::new("displacement {at} at time {place} by Taylor series of M ẍ + C ẋ + K x = f, step by step")
                            .with("at", row.coordinate)
                            .with("place", place + 1),
                        (x - series[row.coordinate - 1]).into(),
                        series.amax().max(excitation.position.amax()),
                    );
                    sheet.check_zero(
                        Text::new("velocity {at} at time {place} by Taylor series of M ẍ + C ẋ + K x = f, step by step")
                            .with("at", row.coordinate)
                            .with("place", place + 1),
                        (v - rates[row.coordinate - 1]).into(),
                        rates.amax().max(excitation.velocity.amax()).max(series.amax() * fastest(poles)),
                    );
                }
            });
        }
        Ok(())
    }

    /// A harmonic force at a natural frequency without damping: the motion is right, and grows.
    fn resonance<W: Worksheet>(&self, found: &WorkedModes<W::Num>, damped: &ModalDamping, sheet: W) {
        for history in self.histories() {
            let History::Harmonic([_, frequency, _]) = history else { continue };
            let square = frequency * frequency;
            let near = (0..found.modes.squares.len()).find(|&mode| {
                (found.modes.squares[mode] - square).abs() <= 1e-9 * square
                    && damped.matrix[(mode, mode)] == 0.0
            });
            if let Some(mode) = near {
                sheet.warn(|| {
                    Text::new(
                        "a force acts at the natural frequency {mode} without damping: the motion is unbounded, it \
                         grows with t",
                    )
                    .with("mode", mode + 1)
                });
            }
        }
    }

    fn curves<W: Worksheet>(
        &self,
        poles: &Poles,
        motion: &TimeResponse<'_>,
        (matrices, excitation): ([&DMatrix<f64>; 3], &TimeExcitation),
        duration: f64,
        sheet: W,
    ) -> Result<(), Refusal> {
        let grid: Vec<f64> = (0..=POINTS).map(|point| duration * point as f64 / POINTS as f64).collect();
        let states: Vec<Vec<Complex<f64>>> = grid.iter().map(|time| motion.state(*time)).collect();
        for row in &self.observed {
            sheet.keep_going()?;
            let looks = LOOKS / poles.roots.len().max(1);
            let cancelled = || sheet.keep_going().is_err();
            let Some(farthest) = motion.farthest(row.coordinate - 1, duration, looks, &cancelled) else {
                sheet.keep_going()?;
                sheet.warn(|| {
                    Text::new("the largest displacement of coordinate {at} is not sought over so many oscillations: shorten the duration of the curves")
                        .with("at", row.coordinate)
                });
                continue;
            };
            let largest = sheet.numerical(
                ("x_m", row.coordinate),
                "m",
                finite(farthest.value)?,
                "Maximum displacement in the plotted time: the extremum farthest from zero, end points included",
            );
            let time = sheet.numerical(("t_m", row.coordinate), "s", farthest.time, "Its time");
            sheet.answer(("largest", row.coordinate), "Maximum displacement in the time shown", largest);
            sheet.answer(("largest_time", row.coordinate), "Time of maximum displacement", time);
            sheet.verify(|| {
                let at = time.value();
                if matrices[0].nrows() > 12 {
                    return;
                }
                let Ok([series, rates]) = state_by_series(matrices, excitation, at, LIMIT) else { return };
                let size = series.amax().max(excitation.position.amax());
                sheet.check_zero(
                    Text::new(
                        "maximum displacement {at}, by Taylor series of M ẍ + C ẋ + K x = f up to its time",
                    )
                    .with("at", row.coordinate),
                    (largest.value() - series[row.coordinate - 1]).into(),
                    size,
                );
                if farthest.time > 0.0 && farthest.time < duration {
                    sheet.check_zero(
                        Text::new("the velocity {at} is zero at its maximum displacement, by Taylor series")
                            .with("at", row.coordinate),
                        rates[row.coordinate - 1].into(),
                        rates.amax().max(size * fastest(poles)),
                    );
                }
            });
        }
        sheet.show(|| {
            let series = self.observed.iter().take(4).map(|row| {
                let points = grid.iter().zip(&states);
                let points =
                    points.map(|(time, state)| (*time, poles.displacement(row.coordinate - 1, state)));
                let label = Text::new("coordinate {at}").with("at", row.coordinate);
                Series::line(label, points.collect()).of(Name::from(("displacement", 1, row.coordinate)))
            });
            let mut plot = Plot::new(
                "Displacement against time",
                Axis::linear("time", "s"),
                Axis::linear("displacement", "m"),
                series.collect(),
            )
            .over("times[1].time");
            for asked in &self.times {
                let coordinate = self.observed[0].coordinate;
                let x = poles.displacement(coordinate - 1, &motion.state(asked.time));
                plot = plot.mark_on(Text::new("coordinate {at}").with("at", coordinate), (asked.time, x));
            }
            Exhibit::Plot(plot)
        });
        Ok(())
    }
}

/// The fastest root, rad/s.
fn fastest(poles: &Poles) -> f64 {
    poles.roots.iter().map(|root| root.norm()).fold(0.0, f64::max)
}

fn finite(number: f64) -> Result<f64, Refusal> {
    if number.is_finite() {
        return Ok(number);
    }
    Err(Refusal::because("these inputs lead to a motion that cannot be represented"))
}
