//! Angular momentum of several bodies about one axis, before and after they are coupled or change their shape.

mod inertia;

use dalembert_core::{
    About, Analysis, Axis, Drawing, Exhibit, Inputs, Plot, Refusal, Series, Sketch, TableExhibit, Text,
    Worksheet,
    exhibit::{Cell, Column},
    register,
};
use dalembert_mechanics::Real;

use self::inertia::{MotionAfter, MotionBefore};
use crate::{
    shared::{
        flat,
        joints::{Named, given_name},
    },
    sources::{BEER, KHURMI},
};

/// Bodies that turn about one axis, or pass it by, and what becomes of each of them.
///
/// Angular velocities are positive in one sense about the axis. No moment acts about it from outside but the external
/// angular impulse.
#[derive(Clone, Debug, Inputs)]
pub struct MomentumOfASystem {
    /// Bodies.
    #[input(min = 1)]
    pub bodies: Vec<SystemBody>,
    /// External angular impulse.
    /// Moment from outside times its duration.
    #[input("K", "N*m*s", default = "0 N*m*s")]
    pub impulse: f64,
    /// Torque of the coupling.
    /// Constant while it slips, between two bodies: gives the time of the slip.
    #[input("M_c", "N*m", positive)]
    pub torque: Option<f64>,
}

/// A body of the system.
#[derive(Clone, Debug, Inputs)]
pub struct SystemBody {
    /// Name.
    pub name: String,
    /// Before.
    pub before: MotionBefore,
    /// After.
    #[input(default = "joined")]
    pub after: MotionAfter,
}

register!(MomentumOfASystem);

impl Analysis for MomentumOfASystem {
    const ABOUT: About = About {
        id: "rigid-body/momentum-of-a-system",
        title: "Angular momentum of several bodies",
        topic: "Inertia and momentum",
        summary: "Common speed of discs that are coupled, of a turntable on which somebody walks, of a body pulled in: conservation of angular momentum about an axis, energy lost.",
        main: &["speed", "momentum", "energy_lost"],
        keywords: "angular momentum conservation system clutch coupling flywheels common speed slip turntable merry-go-round skater \
                   conservação momento angular sistema embreagem acoplamento volantes velocidade comum carrossel patinadora",
        sources: &[&KHURMI, &BEER],
        cases: include_str!("../../cases/momentum_of_a_system.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &MomentumOfASystemGiven<W>, sheet: W) -> Result<(), Refusal> {
        let bodies: Vec<WorkedBody<W::Num>> = self
            .bodies
            .iter()
            .zip(&given.bodies)
            .enumerate()
            .map(|(n, (body, given))| body.work(given, n, sheet))
            .collect();
        let before = sheet.step(
            "H₀",
            "kg*m^2/s",
            W::Num::sum(bodies.iter().map(|body| body.before.momentum)),
            "Angular momentum before",
        );
        let joined: Vec<W::Num> = bodies.iter().filter_map(|body| body.after.inertia()).collect();
        if joined.is_empty() {
            return Err(Refusal::because(
                "no body turns with an angular velocity that is to be found: let one of them turn with the others after",
            ));
        }
        let inertia = sheet.step(
            "I",
            "kg*m^2",
            W::Num::sum(joined),
            "Moment of inertia of what turns with the common angular velocity",
        );
        if inertia.value() <= 0.0 {
            return Err(Refusal::because(
                "what turns with the common angular velocity has no moment of inertia: write a distance from the axis above zero",
            ));
        }
        let own: Vec<W::Num> = bodies.iter().filter_map(|body| body.after.own_momentum()).collect();
        let is_alone = self.impulse == 0.0 && own.is_empty();
        let mut available = before;
        if self.impulse != 0.0 {
            available = available + given.impulse;
        }
        if !own.is_empty() {
            let own = sheet.step(
                "H_r",
                "kg*m^2/s",
                W::Num::sum(own),
                "Angular momentum beside the common rotation: of relative and of given motions",
            );
            available = available - own;
        }
        common_errors(&bodies, is_alone, [available, inertia], sheet);
        let speed = sheet.step(
            "ω",
            "rad/s",
            available / inertia,
            (
                "The angular momentum about the axis is that before and the external angular impulse",
                BEER.at("§17.2"),
            ),
        );
        sheet.answer("momentum", "Angular momentum before", before);
        sheet.answer("speed", "Common angular velocity after", speed);
        let after: Vec<[W::Num; 2]> = bodies
            .iter()
            .enumerate()
            .map(|(n, body)| body.after.state(speed, &self.bodies[n].name, n, sheet))
            .collect();
        for (n, (body, [momentum, _])) in bodies.iter().zip(&after).enumerate() {
            let name = &self.bodies[n].name;
            let change = sheet.step(
                ("K", n + 1),
                "N*m*s",
                *momentum - body.before.momentum,
                Named("Angular impulse on {name}: change of its angular momentum", name, None),
            );
            sheet.answer(("angular_impulse", n + 1), "Angular impulse", change);
            sheet.row_label(("angular_impulse", n + 1), name);
            sheet.verify(|| self.check_impulse(n, change, &bodies, &after, sheet));
        }
        let energy = self.energies(&bodies, &after, sheet);
        self.slip(given, &bodies, speed, sheet)?;
        self.check(&bodies, &after, speed, energy, sheet);
        let shown = speed.value();
        let inertia = inertia.value();
        sheet.show(|| Exhibit::Table(self.table(&bodies, &after)));
        // With the torque of a coupling an external angular impulse is refused.
        if self.torque.is_none() {
            sheet.show(|| Exhibit::Plot(self.over_impulse(shown, inertia)));
        }
        sheet.show(|| Exhibit::Drawing(self.sketch(&bodies)));
        Ok(())
    }
}

/// A body before and after.
struct WorkedBody<N> {
    before: Before<N>,
    after: After<N>,
}

/// Motion before.
#[derive(Clone, Copy)]
struct Before<N> {
    momentum: N,
    energy: N,
    /// Moment of inertia and angular velocity of a body that turns.
    turning: Option<[N; 2]>,
}

/// Motion after.
#[derive(Clone, Copy)]
enum After<N> {
    /// With the common angular velocity, and one relative to it.
    Common { inertia: N, relative: Option<N> },
    /// With a given angular velocity.
    Given { inertia: N, speed: N },
    /// In a straight line.
    Leaving { momentum: N, energy: N },
}

impl<N: Real> After<N> {
    fn inertia(self) -> Option<N> {
        match self {
            After::Common { inertia, .. } => Some(inertia),
            _ => None,
        }
    }

    /// Moment of inertia of what turns relative to the common angular velocity.
    fn relative_inertia(self) -> Option<N> {
        match self {
            After::Common { inertia, relative: Some(_) } => Some(inertia),
            _ => None,
        }
    }

    /// Angular momentum that does not depend on the common angular velocity.
    fn own_momentum(self) -> Option<N> {
        match self {
            After::Common { relative: None, .. } => None,
            After::Common { inertia, relative: Some(relative) } => Some(inertia * relative),
            After::Given { inertia, speed } => Some(inertia * speed),
            After::Leaving { momentum, .. } => Some(momentum),
        }
    }

    /// Angular momentum and kinetic energy.
    fn state<W: Worksheet<Num = N>>(self, speed: N, name: &str, n: usize, sheet: W) -> [N; 2] {
        let (inertia, speed) = match self {
            After::Common { inertia, relative: None } => (inertia, speed),
            After::Common { inertia, relative: Some(relative) } => {
                let reason = Named("Angular velocity of {name}", name, None);
                (inertia, sheet.step(("ω", n + 1), "rad/s", speed + relative, reason))
            }
            After::Given { inertia, speed } => (inertia, speed),
            After::Leaving { momentum, energy } => return [momentum, energy],
        };
        let reason = Named("Angular momentum of {name} after", name, None);
        let momentum = sheet.step(("H_1", n + 1), "kg*m^2/s", inertia * speed, reason);
        [momentum, inertia * speed.powi(2) / 2.0]
    }
}

impl SystemBody {
    fn work<W: Worksheet>(&self, given: &SystemBodyGiven<W>, n: usize, sheet: W) -> WorkedBody<W::Num> {
        let name = &self.name;
        let momentum = |value| {
            let reason = Named("Angular momentum of {name} before", name, None);
            sheet.step(("H_0", n + 1), "kg*m^2/s", value, reason)
        };
        let (before, inertia) = given.before.work(momentum, name, n, sheet);
        let after = given.after.work(inertia, name, n, sheet);
        WorkedBody { before, after }
    }
}

/// Records the errors of the common angular velocity; `is_alone` where all turn with it and no impulse acts from outside.
fn common_errors<W: Worksheet>(
    bodies: &[WorkedBody<W::Num>],
    is_alone: bool,
    [available, inertia]: [W::Num; 2],
    sheet: W,
) {
    if is_alone {
        sheet.common_error(
            "ω",
            "the kinetic energy taken as conserved in place of the angular momentum",
            || (W::Num::sum(bodies.iter().map(|body| body.before.energy)) * 2.0 / inertia).sqrt(),
        );
    }
    if is_alone && bodies.iter().all(|body| body.before.turning.is_some()) {
        sheet.common_error("ω", "the mean of the angular velocities taken", || {
            let speeds = bodies.iter().filter_map(|body| body.before.turning);
            W::Num::sum(speeds.map(|[_, speed]| speed)) / bodies.len() as f64
        });
    }
    if bodies.iter().any(|body| body.after.relative_inertia().is_some()) {
        sheet.common_error("ω", "the relative angular velocity taken as absolute", || {
            let moving = bodies.iter().filter_map(|body| body.after.relative_inertia());
            available / (inertia - W::Num::sum(moving))
        });
    }
}

impl MomentumOfASystem {
    /// Answers the kinetic energies.
    fn energies<W: Worksheet>(
        &self,
        bodies: &[WorkedBody<W::Num>],
        after: &[[W::Num; 2]],
        sheet: W,
    ) -> [W::Num; 3] {
        let before = sheet.step(
            "T₀",
            "J",
            W::Num::sum(bodies.iter().map(|body| body.before.energy)),
            "Kinetic energy before",
        );
        let now = sheet.step(
            "T₁",
            "J",
            W::Num::sum(after.iter().map(|[_, energy]| *energy)),
            "Kinetic energy after",
        );
        let lost = sheet.step(
            "ΔT",
            "J",
            before - now,
            ("Kinetic energy lost; negative where work is done, by muscles or a motor", KHURMI.at("§3.27")),
        );
        sheet.answer("energy_before", "Kinetic energy before", before);
        sheet.answer("energy_after", "Kinetic energy after", now);
        sheet.answer("energy_lost", "Kinetic energy lost", lost);
        [before, now, lost]
    }

    /// Answers the time for which a coupling of two bodies slips.
    fn slip<W: Worksheet>(
        &self,
        given: &MomentumOfASystemGiven<W>,
        bodies: &[WorkedBody<W::Num>],
        speed: W::Num,
        sheet: W,
    ) -> Result<(), Refusal> {
        let Some(torque) = given.torque else { return Ok(()) };
        let [first, second] = bodies else {
            return Err(Refusal::because(
                "the torque of a coupling acts between two bodies: write two of them, or leave the torque out",
            ));
        };
        let (
            Some([inertia, start]),
            Some([_, other]),
            After::Common { relative: None, .. },
            After::Common { relative: None, .. },
        ) = (first.before.turning, second.before.turning, first.after, second.after)
        else {
            return Err(Refusal::because(
                "a coupling slips between two bodies that turn before and have the common angular velocity after: describe them so, or leave the torque out",
            ));
        };
        if self.impulse != 0.0 {
            return Err(Refusal::because(
                "the time of the slip is found without an external angular impulse: write zero for it, or leave the torque out",
            ));
        }
        sheet.common_error("t_s", "the first body taken to reach the initial speed of the second", || {
            inertia * (other - start).abs() / torque
        });
        let time = sheet.step(
            "t_s",
            "s",
            inertia * (speed - start).abs() / torque,
            "Time of the slip: the torque brings the first body to the common angular velocity",
        );
        sheet.answer("slip_time", "Time of the slip", time);
        sheet.verify(|| {
            if let Some([inertia, start]) = second.before.turning {
                let other = inertia * (speed - start).abs() / torque;
                sheet.check("time in which the torque brings the second body to it", other, time);
            }
        });
        Ok(())
    }

    /// Holds the angular impulse on a body to the external one less those on the others.
    fn check_impulse<W: Worksheet>(
        &self,
        n: usize,
        change: W::Num,
        bodies: &[WorkedBody<W::Num>],
        after: &[[W::Num; 2]],
        sheet: W,
    ) {
        let others = bodies.iter().zip(after).enumerate().filter(|(other, _)| *other != n);
        let (mut rest, mut size) = (self.impulse, self.impulse.abs() + change.value().abs());
        for (_, (body, [momentum, _])) in others {
            let [before, now] = [body.before.momentum, *momentum].map(Real::value);
            rest -= now - before;
            size += before.abs() + now.abs();
        }
        let what = "angular impulse: the external one less those on the other bodies";
        sheet.check_sum(what, change, rest.into(), size);
    }

    fn check<W: Worksheet>(
        &self,
        bodies: &[WorkedBody<W::Num>],
        after: &[[W::Num; 2]],
        speed: W::Num,
        [before, now, lost]: [W::Num; 3],
        sheet: W,
    ) {
        sheet.verify(|| {
            let size: f64 = bodies
                .iter()
                .zip(after)
                .map(|(body, [h, _])| body.before.momentum.value().abs() + h.value().abs())
                .sum::<f64>()
                + self.impulse.abs();
            let changes =
                W::Num::sum(bodies.iter().zip(after).map(|(body, [h, _])| *h - body.before.momentum));
            sheet.check_sum(
                "the angular impulses on all bodies make up the external one",
                changes,
                self.impulse.into(),
                size,
            );
            // Kinetic energies from the angular momenta: H ω/2.
            let halves = |momentum: W::Num, energy: W::Num, inertia: Option<W::Num>| match inertia {
                Some(inertia) if inertia.value() > 0.0 => momentum.powi(2) / (inertia * 2.0),
                _ => energy,
            };
            let first = W::Num::sum(bodies.iter().map(|body| {
                halves(
                    body.before.momentum,
                    body.before.energy,
                    body.before.turning.map(|[inertia, _]| inertia),
                )
            }));
            let second = W::Num::sum(bodies.iter().zip(after).map(|(body, [momentum, energy])| {
                let inertia = match body.after {
                    After::Common { inertia, .. } | After::Given { inertia, .. } => Some(inertia),
                    After::Leaving { .. } => None,
                };
                halves(*momentum, *energy, inertia)
            }));
            let size = before.value() + now.value();
            sheet.check_sum("kinetic energy before from the angular momenta, H²/(2 I)", before, first, size);
            sheet.check_sum("kinetic energy after from the angular momenta, H²/(2 I)", now, second, size);
            sheet.check_sum("energy lost from the angular momenta", lost, first - second, size);
            let relative: Option<Vec<W::Num>> = bodies
                .iter()
                .map(|body| match (body.before.turning, body.after) {
                    (Some([inertia, start]), After::Common { inertia: now, relative: None })
                        if now.value() == inertia.value() =>
                    {
                        Some(inertia * (start - speed).powi(2) / 2.0)
                    }
                    _ => None,
                })
                .collect();
            if let Some(relative) = relative.filter(|_| self.impulse == 0.0) {
                let what = "energy lost: that of the motions relative to the common one";
                sheet.check_sum(what, lost, W::Num::sum(relative), size);
            }
        });
    }

    fn table<N: Real>(&self, bodies: &[WorkedBody<N>], after: &[[N; 2]]) -> TableExhibit {
        let column = |heading: &'static str| Column { heading: heading.into(), unit: "kg*m^2/s" };
        let rows = self.bodies.iter().zip(bodies).zip(after).map(|((body, worked), [momentum, _])| {
            let [before, now] = [worked.before.momentum, *momentum].map(|h| Cell::Number(h.value()));
            vec![Cell::from(Text::verbatim(&body.name)), before, now]
        });
        TableExhibit {
            title: "Angular momenta about the axis".into(),
            columns: vec![Column { heading: "body".into(), unit: "" }, column("before"), column("after")],
            rows: rows.collect(),
            foot: Vec::new(),
        }
    }

    fn over_impulse(&self, speed: f64, inertia: f64) -> Plot {
        let reach = (1.5 * self.impulse.abs()).max(speed.abs() * inertia).max(inertia);
        let at = |n: u16| {
            let impulse = reach * (f64::from(n) / 20.0 - 1.0);
            (impulse, speed + (impulse - self.impulse) / inertia)
        };
        Plot::new(
            "Common angular velocity against the external angular impulse",
            Axis::linear("external angular impulse", "N*m*s"),
            Axis::linear("common angular velocity", "rad/s"),
            vec![Series::line("ω", (0..=40).map(at).collect()).of("speed")],
        )
        .over("impulse")
        .mark("this system", (self.impulse, speed))
    }

    fn sketch<N: Real>(&self, bodies: &[WorkedBody<N>]) -> Drawing {
        const MOST: usize = 8;
        let inertias: Vec<f64> = bodies
            .iter()
            .take(MOST)
            .map(|body| {
                let after = match body.after {
                    After::Common { inertia, .. } | After::Given { inertia, .. } => inertia.value(),
                    After::Leaving { .. } => 0.0,
                };
                body.before.turning.map_or(after, |[inertia, _]| inertia.value())
            })
            .collect();
        let largest = inertias.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
        let mut sketch = Sketch::new("The bodies along the axis before");
        let width = 1.6 * inertias.len() as f64;
        let turns = |body: Option<&SystemBody>| {
            body.is_some_and(|body| matches!(body.before, MotionBefore::Turns { .. }))
        };
        let mut from = -0.9;
        for row in 1..inertias.len() {
            // What turns on its own before is joined by a clutch: two plates with a gap between the ends of the shafts.
            if turns(self.bodies.get(row - 1)) && turns(self.bodies.get(row)) {
                let middle = 1.6 * row as f64 - 0.8;
                let (left, right) = (middle - 0.08, middle + 0.08);
                sketch.link("", (from, 0.0), (left, 0.0));
                for x in [left, right] {
                    sketch.bars([(x, -0.3), (x, 0.3)]);
                }
                from = right;
            }
        }
        sketch.link("", (from, 0.0), (width - 0.6, 0.0));
        for ((body, inertia), row) in self.bodies.iter().zip(&inertias).zip(1..) {
            let x = 1.6 * (row - 1) as f64;
            let half = 0.25 + 0.75 * (inertia / largest).sqrt();
            sketch.mass("", (x - 0.2, -half), (x + 0.2, half)).label(given_name(&body.name), (x, -half));
            match &body.before {
                MotionBefore::Turns { body, speed } => {
                    sketch.label(flat::of_row(body.letters(), row), (x, half));
                    if *speed != 0.0 {
                        let along = 0.45 * speed.signum();
                        let tail = x + 0.2 - along.min(0.0);
                        sketch.motion(flat::of_row(&["ω_0"], row), (tail, 0.0), (tail + along, 0.0));
                    }
                }
                MotionBefore::Straight { .. } => {
                    sketch.label(flat::of_row(&["m"], row), (x, half));
                    sketch.motion(flat::of_row(&["v_0"], row), (x, half), (x + 0.7, half)).dimension(
                        flat::of_row(&["b"], row),
                        (x, 0.0),
                        (x, half),
                        4.0,
                    );
                }
            }
        }
        let end = (width - 0.6, 0.0);
        if self.impulse != 0.0 {
            sketch.force("K", end, (end.0 + 0.6 * self.impulse.signum(), 0.0));
        }
        sketch.finish()
    }
}
