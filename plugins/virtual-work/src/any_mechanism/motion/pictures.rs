//! Plots and the animation of a motion.

use dalembert_core::{
    Animation, Axis, Exhibit, Ink, Name, Plot, Series, Sketch, Text, Worksheet, exhibit::Point as At,
};
use dalembert_mechanics::planar::Snapshot;

use super::{Motion, Solved};
use crate::shared::parts::verbatim;

impl Solved<'_> {
    /// All figures and tables.
    pub(super) fn show<W: Worksheet>(&self, problem: &Motion, sheet: W) {
        sheet.show(|| Exhibit::Animation(self.animation(problem)));
        for (row, followed) in (1..).zip(&problem.watched) {
            let name = &self.parts.points[followed.point.0].name;
            let point = self.parts.point(followed.point);
            let speed = move |moment: &Snapshot| {
                let [_, [x, y], _] = self.system.point(point, &moment.state);
                x.hypot(y)
            };
            sheet.show(|| {
                let title = Text::new("Speed of {name}").with("name", name);
                let line = self.line("".into(), speed).of(Name::from(("velocity", row)));
                Exhibit::Plot(self.over_time(title, "Speed", "m/s", vec![line]))
            });
            sheet.show(|| {
                let at = |moment: &Snapshot| self.parts.place(followed.point, &moment.state.positions);
                let path = self.moved.samples.iter().map(at).collect();
                let times = self.moved.samples.iter().map(|moment| moment.time).collect();
                let answer = Name::from(("position", row));
                Exhibit::Plot(
                    Plot::new(
                        Text::new("Path of {name}").with("name", name),
                        Axis::linear("x", "mm"),
                        Axis::linear("y", "mm"),
                        vec![Series::line("", path).of(format_args!("{answer}.y")).at(times)],
                    )
                    .equal()
                    .over_answer("duration", format_args!("{answer}.x")),
                )
            });
        }
        sheet.show(|| {
            Exhibit::Plot(
                self.of_bodies("Angles", ("Angle", "deg"), "angle", |moment| &moment.state.positions),
            )
        });
        sheet.show(|| {
            let axis = ("Angular velocity", "rad/s");
            Exhibit::Plot(
                self.of_bodies("Angular velocities", axis, "angular_velocity", |moment| {
                    &moment.state.velocities
                }),
            )
        });
        sheet.show(|| {
            let start = self.moved.samples[0].stored;
            let series = vec![
                self.line("Kinetic".into(), |moment| moment.kinetic).of("kinetic_energy"),
                self.line("Stored".into(), move |moment| moment.stored - start).of("stored_energy"),
                self.line("Work done".into(), |moment| moment.work).of("work"),
            ];
            Exhibit::Plot(self.over_time("Energy".into(), "Energy", "J", series))
        });
    }

    /// A part of all bodies over time.
    fn of_bodies(
        &self,
        title: &'static str,
        (label, unit): (&'static str, &'static str),
        answer: &'static str,
        of: impl Fn(&Snapshot) -> &[[f64; 3]] + Copy,
    ) -> Plot {
        let line = |(body, part): (usize, &crate::shared::parts::Part)| {
            let name = verbatim(&part.name);
            self.line(name, move |moment| of(moment)[body][2]).of(Name::from((answer, body + 1)))
        };
        let series = self.parts.bodies.iter().enumerate().map(line).collect();
        self.over_time(title.into(), label, unit, series)
    }

    fn line(&self, name: Text, of: impl Fn(&Snapshot) -> f64) -> Series {
        Series::line(name, self.moved.samples.iter().map(|moment| (moment.time, of(moment))).collect())
    }

    fn over_time(&self, title: Text, label: &'static str, unit: &'static str, series: Vec<Series>) -> Plot {
        Plot::new(title, Axis::linear("Time", "s"), Axis::linear(label, unit), series).over("duration")
    }

    fn animation(&self, problem: &Motion) -> Animation {
        const FRAMES: usize = 24;
        let moments = &self.moved.samples;
        let sizes = moments.iter().map(|moment| self.parts.size(self.system, &moment.state.positions));
        let size = sizes.fold(0.0, f64::max);
        let path = |followed: &super::Continuation| {
            let at = |moment: &Snapshot| self.parts.place(followed.point, &moment.state.positions);
            moments.iter().map(at).collect()
        };
        let paths: Vec<Vec<At>> = problem.watched.iter().map(path).collect();
        let frame = |k: usize| {
            let mut sketch = Sketch::default();
            for path in &paths {
                sketch.curve(path.as_slice(), Ink::Motion);
            }
            let moment = &moments[k * (moments.len() - 1) / (FRAMES - 1)];
            self.parts.draw(&moment.state.positions, size, &mut sketch);
            sketch
        };
        Sketch::animation("Mechanism", (0..FRAMES).map(frame), 4.0)
    }
}
