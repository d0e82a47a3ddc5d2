//! Tables, plots and the animation of a mechanism.

use dalembert_core::{
    Animation, Axis, Exhibit, Ink, Name, Plot, Series, Sketch, TableExhibit, Text, Worksheet,
    exhibit::Point as At,
    exhibit::{Cell, Column},
};
use dalembert_mechanics::planar::{BodyPoint, LoadId, PlanarState};

use super::{Mechanism, Sample, Solved};
use crate::shared::parts::{Driven, Joint, verbatim};

impl Solved<'_> {
    /// All figures and tables.
    pub(super) fn show<W: Worksheet>(&self, problem: &Mechanism, samples: &[Sample], sheet: W) {
        let is_driven = !self.parts.drivers.is_empty();
        if is_driven {
            sheet.show(|| Exhibit::Table(self.table_of_works()));
        }
        sheet.show(|| Exhibit::Table(self.table_of_reactions()));
        if self.parts.joints.iter().any(|joint| !matches!(joint.joint, Joint::Gears { .. })) {
            sheet.show(|| Exhibit::Table(self.table_of_axes()));
        }
        if is_driven {
            sheet.show(|| Exhibit::Table(self.table_of_centres()));
            let links = self.links();
            if !links.is_empty() {
                sheet.show(|| Exhibit::Table(self.table_of_transmission(&links, samples)));
            }
        }
        if samples.len() > 1 {
            let first_driver = self.system.equations().len() - self.parts.drivers.len();
            for (driver, drive) in self.parts.drivers.iter().enumerate() {
                let (unit, label) = match drive.what {
                    Driven::Angle { .. } => ("N*m", "Torque"),
                    _ => ("N", "Force"),
                };
                let title = Text::new("Driving force or torque of {name}").with("name", &drive.name);
                let of = |sample: &Sample| sample.multipliers[first_driver + driver];
                let answer = Name::from(("effort", driver + 1));
                sheet.show(|| {
                    Exhibit::Plot(self.over_range(samples, title, label, unit, &[("", answer, &of)]))
                });
            }
            let mut all: Vec<(String, Box<dyn Fn(&Sample) -> f64>)> = Vec::new();
            for (body, part) in self.parts.bodies.iter().enumerate() {
                all.push((part.name.clone(), Box::new(move |sample| sample.state.velocities[body][2])));
            }
            let series: Vec<Of<'_>> = (1..)
                .zip(&all)
                .map(|(row, (name, of))| (name.as_str(), ("angular_velocity", row).into(), of.as_ref()))
                .collect();
            let title = Text::new("Angular velocities");
            sheet.show(|| {
                Exhibit::Plot(self.over_range(samples, title, "Angular velocity", "rad/s", &series))
            });
            for (row, watched) in (1..).zip(&problem.watched) {
                let name = &self.parts.points[watched.point.0].name;
                let point = self.parts.point(watched.point);
                let of = |part: usize| {
                    move |sample: &Sample| {
                        let [x, y] = self.system.point(point, &sample.state)[part];
                        x.hypot(y)
                    }
                };
                let title = Text::new("Speed of {name}").with("name", name);
                let answer = Name::from(("velocity", row));
                sheet.show(|| {
                    let series = [("", answer, &of(1) as &dyn Fn(&Sample) -> f64)];
                    Exhibit::Plot(self.over_range(samples, title, "Speed", "m/s", &series))
                });
                let title = Text::new("Acceleration of {name}").with("name", name);
                let answer = Name::from(("acceleration", row));
                sheet.show(|| {
                    let series = [("", answer, &of(2) as &dyn Fn(&Sample) -> f64)];
                    Exhibit::Plot(self.over_range(samples, title, "Acceleration", "m/s^2", &series))
                });
                sheet.show(|| Exhibit::Plot(self.path(point, (row, name), samples)));
            }
            self.show_polar_diagrams(samples, sheet);
        }
        sheet.show(|| Exhibit::Animation(self.animation(problem, samples)));
    }

    fn over_range(
        &self,
        samples: &[Sample],
        title: Text,
        label: &'static str,
        unit: &'static str,
        series: &[Of<'_>],
    ) -> Plot {
        let (x_label, x_unit) = match self.parts.drivers[0].what {
            Driven::Angle { .. } => ("Angle of the first driver", "deg"),
            _ => ("Length of the first driver", "mm"),
        };
        let line = |(name, answer, of): &Of<'_>| {
            let points = samples.iter().map(|sample| (sample.value, of(sample))).collect();
            Series::line(verbatim(*name), points).of(answer)
        };
        Plot::new(
            title,
            Axis::linear(x_label, x_unit),
            Axis::linear(label, unit),
            series.iter().map(line).collect(),
        )
        .over(self.input())
    }

    /// The path of the value of the first driver.
    fn input(&self) -> String {
        format!("drivers[1].{}", self.parts.drivers[0].what.path())
    }

    /// The path of a point over the range.
    fn path(&self, point: BodyPoint, (row, name): (usize, &str), samples: &[Sample]) -> Plot {
        let at = |state: &PlanarState| {
            let [[x, y], ..] = self.system.point(point, state);
            (x, y)
        };
        let points = samples.iter().map(|sample| at(&sample.state)).collect();
        let values = samples.iter().map(|sample| sample.value).collect();
        let answer = Name::from(("position", row));
        Plot::new(
            Text::new("Path of {name}").with("name", name),
            Axis::linear("x", "mm"),
            Axis::linear("y", "mm"),
            vec![Series::line("", points).of(format_args!("{answer}.y")).at(values)],
        )
        .equal()
        .over_answer(self.input(), format_args!("{answer}.x"))
        .mark("here", at(self.state))
    }

    fn table_of_works(&self) -> TableExhibit {
        let unit = match self.parts.drivers[0].what {
            Driven::Angle { .. } => "N*m",
            _ => "N",
        };
        let row = |power: &dalembert_mechanics::planar::LoadPower| {
            let of = |words: &'static str| Text::new(words).with("name", self.name(power.of));
            let name = match power.of {
                LoadId::Load(_) => verbatim(self.name(power.of)),
                LoadId::Weight(_) => of("Weight of {name}"),
                LoadId::InertiaForce(_) => of("Inertia force of {name}"),
                LoadId::InertiaCouple(_) => of("Inertia couple of {name}"),
            };
            vec![Cell::Text(name), Cell::Number(power.generalised[0]), Cell::Number(power.power)]
        };
        let mut rows: Vec<Vec<Cell>> = self.dynamics.powers.iter().map(row).collect();
        for (driver, drive) in self.parts.drivers.iter().enumerate() {
            let (effort, velocity) =
                (self.dynamics.efforts[driver], self.system.mechanism().drivers[driver].velocity);
            let own = if driver == 0 { Cell::Number(effort) } else { Cell::Empty };
            rows.push(vec![Cell::Text(verbatim(&drive.name)), own, Cell::Number(effort * velocity)]);
        }
        TableExhibit {
            title: "Virtual power of the loads".into(),
            columns: vec![
                Column { heading: "Load".into(), unit: "" },
                Column { heading: "Per unit velocity of the first driver".into(), unit },
                Column { heading: "Power".into(), unit: "W" },
            ],
            rows,
            foot: Vec::new(),
        }
    }

    fn animation(&self, problem: &Mechanism, samples: &[Sample]) -> Animation {
        const FRAMES: usize = 24;
        let size = self.drawn_size();
        let paths: Vec<Vec<At>> = problem
            .watched
            .iter()
            .filter(|_| samples.len() > 1)
            .map(|watched| {
                let at = |sample: &Sample| self.parts.place(watched.point, &sample.state.positions);
                samples.iter().map(at).collect()
            })
            .collect();
        let frame = |state: &PlanarState| {
            let mut sketch = Sketch::default();
            for path in &paths {
                sketch.curve(path.as_slice(), Ink::Motion);
            }
            self.parts.draw(&state.positions, size, &mut sketch);
            sketch
        };
        let mut frames = vec![frame(self.state)];
        let mut values = vec![self.here()];
        if samples.len() > 1 {
            // The animation begins where the problem stands.
            let start = samples
                .iter()
                .enumerate()
                .min_by(|(_, a), (_, b)| {
                    let here = |sample: &Sample| (sample.value - self.here()).abs();
                    here(a).total_cmp(&here(b))
                })
                .map_or(0, |(at, _)| at);
            let shown = |k: usize| &samples[(start + k * (samples.len() - 1) / FRAMES) % samples.len()];
            frames.extend((1..FRAMES).map(|k| frame(&shown(k).state)));
            values.extend((1..FRAMES).map(|k| shown(k).value));
        }
        let animation = Sketch::animation("Mechanism", frames, 4.0);
        if values.len() > 1 { animation.over(self.input(), values) } else { animation }
    }

    /// The size of the drawn mechanism, which is the same wherever its drivers have taken it.
    fn drawn_size(&self) -> f64 {
        let drawn: Vec<f64> = self.parts.drivers.iter().map(|drive| drive.what.drawn()).collect();
        let there = self.system.continue_to(&self.state.positions, &drawn);
        let there = there.and_then(|there| self.system.kinetostatics(&there.positions));
        let state = there.as_ref().map_or(self.state, |(state, _)| state);
        self.parts.size(self.system, &state.positions)
    }

    fn here(&self) -> f64 {
        self.system.mechanism().drivers.first().map_or(0.0, |driver| driver.value)
    }
}

/// A curve: its name, the answer that it shows, and what it is at a sample.
type Of<'a> = (&'a str, Name, &'a dyn Fn(&Sample) -> f64);
