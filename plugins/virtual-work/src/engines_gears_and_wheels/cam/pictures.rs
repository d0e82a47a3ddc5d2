//! Plots of the motion and drawing of cam and follower.

use std::f64::consts::TAU;

use dalembert_core::{Axis, Drawing, Ink, Plot, Series, Sketch, Text, exhibit::Point};

use super::{
    follower::Outline,
    load::Load,
    motion::Units,
    program::{Course, Motion},
};
use crate::shared::figure::{letter, turning};

/// Course, contact and load that are shown.
pub(super) struct View<'a> {
    pub course: &'a Course,
    pub speed: Option<f64>,
    pub angle: Option<f64>,
    pub outline: Option<Outline<f64>>,
    pub load: Option<Load>,
}

impl View<'_> {
    fn curve(
        &self,
        (title, label, unit): (&'static str, &'static str, &'static str),
        (symbol, answer): (&'static str, &'static str),
        number: impl Fn(&Motion) -> f64,
    ) -> Plot {
        let points = self.course.motions().iter().map(|motion| (motion.angle, number(motion))).collect();
        let plot = Plot::new(
            title,
            Axis::linear("cam angle", "deg"),
            Axis::linear(label, unit),
            vec![Series::line(symbol, points).of(answer)],
        )
        .over("angle");
        match self.angle.and_then(|angle| self.course.at(angle)) {
            Some(motion) => plot.mark("at this cam angle", (motion.angle, number(&motion))),
            None => plot,
        }
    }

    pub(super) fn plots(&self) -> Vec<Plot> {
        let units = Units::of(self.course);
        let mut plots =
            vec![
                self.curve(("Lift against cam angle", "lift", units.lift), ("s", "lift"), |motion| {
                    motion.lift
                }),
            ];
        match self.speed {
            Some(w) => {
                let [first, second, third] = units.per_second;
                plots.push(self.curve(
                    ("Velocity of the follower", "velocity", first),
                    ("v", "velocity"),
                    |motion| w * motion.rate,
                ));
                plots.push(self.curve(
                    ("Acceleration of the follower", "acceleration", second),
                    ("a", "acceleration"),
                    |motion| w * w * motion.second,
                ));
                plots.push(self.curve(("Jerk of the follower", "jerk", third), ("j", "jerk"), |motion| {
                    w * w * w * motion.third
                }));
            }
            None => {
                let [first, second, third] = units.per_radian;
                plots.push(self.curve(
                    ("Velocity per radian of the cam", "ds/dθ", first),
                    ("s′", "lift_rate"),
                    |motion| motion.rate,
                ));
                plots.push(self.curve(
                    ("Acceleration per radian of the cam squared", "d²s/dθ²", second),
                    ("s″", "lift_second"),
                    |motion| motion.second,
                ));
                plots.push(self.curve(
                    ("Jerk per radian of the cam cubed", "d³s/dθ³", third),
                    ("s‴", "lift_third"),
                    |motion| motion.third,
                ));
            }
        }
        if let Some(outline) = self.outline.filter(|outline| !matches!(outline, Outline::Flat { .. })) {
            plots.push(self.curve(
                ("Pressure angle against cam angle", "pressure angle", "deg"),
                ("φ", "pressure_angle"),
                |motion| outline.pressure(motion),
            ));
        }
        if let Some(load) = self.load {
            plots.push(self.curve(
                ("Force of the cam", "force of the cam", "N"),
                ("F", "contact_force"),
                |motion| load.force(motion),
            ));
            plots.push(self.curve(("Torque on the cam shaft", "torque", "N*m"), ("T", "torque"), |motion| {
                load.torque(motion)
            }));
        }
        plots
    }

    /// A cam, and the course of its follower over the angle, as a timing diagram is drawn: its lift and its angles.
    pub(super) fn diagram(&self) -> Drawing {
        const WIDE: f64 = 3.0;
        let segments = &self.course.segments;
        let whole: f64 = segments.iter().map(|segment| segment.turn).sum();
        let motions = self.course.motions();
        let highest = motions.iter().fold(0.0f64, |most, motion| most.max(motion.lift.abs()));
        let (start, scale) = (segments.first().map_or(0.0, |first| first.from), 1.0 / highest.max(1e-300));
        let at = |angle: f64, lift: f64| (WIDE * (angle - start) / whole, scale * lift);
        let mut sketch = Sketch::new("Cam (not to scale), and lift of the follower over its angle");
        let course: Vec<Point> = motions.iter().map(|motion| at(motion.angle, motion.lift)).collect();
        sketch
            .motion("θ", (0.0, 0.0), (1.1 * WIDE, 0.0))
            .motion("s", (0.0, 0.0), (0.0, 1.3))
            .curve(course, Ink::Body);
        let several = segments.len() > 1;
        for (row, segment) in (1..).zip(segments) {
            let name =
                |symbol: &str| Text::verbatim(if several { letter(symbol, row) } else { symbol.to_owned() });
            let end = segment.from + segment.turn;
            sketch.dimension(name("β"), at(segment.from, 0.0), at(end, 0.0), -3.0);
            if segment.rise != 0.0 {
                let low = segment.start.min(segment.start + segment.rise);
                let side = if segment.rise > 0.0 { end } else { segment.from };
                sketch.dimension(name("h"), at(side, low), at(side, low + segment.rise.abs()), -1.5);
            }
        }
        // Radii about a base circle that is not given, and the follower at the start.
        let (hub, base) = ((-1.9, 0.4), 0.8);
        let radius = |lift: f64| base + 0.4 * scale * lift;
        let on_cam =
            |turn: f64, lift: f64| (hub.0 + radius(lift) * turn.sin(), hub.1 + radius(lift) * turn.cos());
        let outline = motions.iter().map(|motion| on_cam(motion.angle - start, motion.lift));
        let foot = hub.1 + motions.first().map_or(base, |first| radius(first.lift));
        sketch
            .circle(hub, base, Ink::Faint)
            .curve(outline.collect::<Vec<Point>>(), Ink::Body)
            .pin("", hub)
            .bars([(hub.0 - 0.3, foot), (hub.0 + 0.3, foot)])
            .bars([(hub.0, foot), (hub.0, foot + 0.6)]);
        // What is left of the turn is not given: a dwell and the way back, the program mirrored.
        let rest = TAU - whole;
        if let Some(last) = motions.last().filter(|_| rest > 1e-9 * TAU) {
            let is_back = (last.lift - motions[0].lift).abs() <= 1e-9 * highest;
            let back = if is_back { 0.0 } else { rest.min(whole) };
            let dwell = (0..=24).map(|n| on_cam(whole + (rest - back) * f64::from(n) / 24.0, last.lift));
            sketch.curve(dwell.collect::<Vec<Point>>(), if is_back { Ink::Body } else { Ink::Faint });
            if !is_back {
                let mirrored =
                    |motion: &Motion| on_cam(TAU - (motion.angle - start) * back / whole, motion.lift);
                sketch.curve(motions.iter().map(mirrored).collect::<Vec<Point>>(), Ink::Faint);
            }
        }
        if self.speed.is_some() {
            turning(&mut sketch, hub, ("ω", 1.0), ("", 0.0));
        }
        sketch.finish()
    }

    /// Cam and follower at a cam angle.
    pub(super) fn drawing(&self, outline: &Outline<f64>, motion: &Motion) -> Drawing {
        let mut sketch = Sketch::new("Cam and follower");
        let shown = |[x, y]: [f64; 2]| {
            let (sin, cos) = (outline.sign() * motion.angle).sin_cos();
            (x * cos - y * sin, x * sin + y * cos)
        };
        let on_cam = |there: &Motion| {
            let contact = outline.contact(there.lift, there.rate, there.second);
            shown(outline.on_cam(contact, there.angle))
        };
        let motions = self.course.motions();
        let mut profile: Vec<Point> = motions.iter().map(on_cam).collect();
        if self.course.closed {
            profile.extend(profile.first().copied());
        }
        let lowest = Motion { lift: 0.0, rate: 0.0, second: 0.0, third: 0.0, ..*motion };
        let [x, y] = outline.contact(0.0, 0.0, 0.0);
        let base = match *outline {
            Outline::Flat { base } => base,
            Outline::Translating { prime, roller, .. } => prime - roller.unwrap_or(0.0),
            Outline::Oscillating { roller, .. } => outline
                .tangent_at(&lowest)
                .map_or(x.hypot(y), |tangent| tangent.point[0].hypot(tangent.point[1]) - roller),
        };
        sketch.circle((0.0, 0.0), base, Ink::Faint).curve(profile, Ink::Body).pin("O", (0.0, 0.0));
        if self.speed.is_some() {
            turning(&mut sketch, (0.0, 0.0), ("ω", outline.sign()), ("", 0.0));
        }
        let [cx, cy] = outline.contact(motion.lift, motion.rate, motion.second);
        let high = 2.2 * base + motion.lift.min(base);
        match (*outline, outline.tangent_at(motion)) {
            (Outline::Flat { base }, _) => {
                let height = base + motion.lift;
                let half = (1.2 * motion.rate.abs()).max(0.6 * base);
                sketch
                    .bars([(-half, height), (half, height)])
                    .link("", (0.0, height), (0.0, height + base))
                    .axis((0.0, 0.0), (0.0, height + base))
                    .motion("s", (0.25 * base, height + 0.3 * base), (0.25 * base, height + 0.8 * base));
            }
            (Outline::Translating { roller, .. }, Some(tangent)) => {
                let centre = (tangent.point[0], tangent.point[1]);
                let top = (centre.0, centre.1 + base);
                if let Some(roller) = roller {
                    sketch.disc("", centre, roller);
                }
                sketch.link("", centre, top).axis((centre.0, 0.0), (centre.0, high.max(top.1)));
                sketch.motion(
                    "s",
                    (centre.0 + 0.25 * base, top.1 - 0.5 * base),
                    (centre.0 + 0.25 * base, top.1),
                );
                self.normal(&mut sketch, &tangent.normal(), (cx, cy), centre, base);
                let angle = outline.pressure(motion);
                if angle.abs() > 0.03 {
                    let up = std::f64::consts::FRAC_PI_2;
                    let (from, to) = if angle > 0.0 { (up, up + angle) } else { (up + angle, up) };
                    sketch.angle("φ", centre, from, to);
                }
            }
            (Outline::Oscillating { pivot, roller, .. }, Some(tangent)) => {
                let centre = (tangent.point[0], tangent.point[1]);
                sketch
                    .disc("", centre, roller)
                    .axis((0.0, 0.0), (pivot, 0.0))
                    .link("l", (pivot, 0.0), centre)
                    .pin("A", (pivot, 0.0));
                self.normal(&mut sketch, &tangent.normal(), (cx, cy), centre, base);
            }
            _ => {}
        }
        sketch.finish()
    }

    /// Line of the normal through the contact.
    fn normal(&self, sketch: &mut Sketch, normal: &[f64; 2], from: Point, through: Point, base: f64) {
        let reach = 0.8 * base;
        let to = (through.0 + reach * normal[0], through.1 + reach * normal[1]);
        sketch.line("n", from, to, Ink::Force);
    }
}
