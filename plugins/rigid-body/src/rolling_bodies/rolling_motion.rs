//! The motion of a disc, hoop or coin that rolls without slip, from a start.

use std::f64::consts::PI;

use dalembert_core::{
    About, Analysis, Axis, Exhibit, Ink, Inputs, Plot, Refusal, Series, Text, Worksheet, register,
};
use dalembert_mechanics::{
    Real, Vector,
    rigid::rolling::{Ended, Limits, Moment, Rolled, Rolling, RollingError, roll},
};
use dalembert_numerics::ode::OdeError;
use nalgebra::{Matrix3, Vector3};

use crate::{
    shared::{
        scene::{self, Scene},
        wheel::{self, Wheel},
    },
    sources::{HAIRER, ROUTH},
};

/// Moments of a motion that are shown.
const MOMENTS: usize = 361;

/// A disc, hoop or coin on a level floor, released in any motion that rolls.
///
/// θ is the angle of its plane to the floor: 90° upright. The axes 1, 2 and 3 through its centre precess with it but do
/// not spin: 1 horizontal in its plane, 2 in its plane away from the contact, 3 along its axis. X, Y and Z stand
/// still, Z up; the contact starts at their origin.
#[derive(Clone, Debug, Inputs)]
pub struct RollingMotion {
    /// Mass.
    #[input("m", "kg", positive, default = "1 kg")]
    pub mass: f64,
    /// Radius of the circle that touches the floor.
    #[input("r", "m", positive)]
    pub radius: f64,
    /// It is a.
    pub wheel: Wheel,
    /// Angle between its plane and the floor at the start.
    #[input("θ", "deg", above = 0, below = 180, default = "80 deg")]
    pub inclination: f64,
    /// Direction of its horizontal diameter at the start, from X.
    #[input("φ", "deg", default = "0 deg")]
    pub heading: f64,
    /// Precession at the start.
    #[input("φ̇", "rad/s", default = "0 rad/s")]
    pub precession: f64,
    /// Rate of tilting at the start.
    #[input("θ̇", "rad/s", default = "0 rad/s")]
    pub tilting: f64,
    /// Spin at the start.
    /// Positive spin rolls it against the direction of its horizontal diameter.
    #[input("ψ̇", "rad/s", default = "0 rad/s")]
    pub spin: f64,
    /// Coefficient of friction with the floor.
    /// If omitted, the floor is assumed to be rough enough.
    #[input("μ", "1", nonnegative)]
    pub friction: Option<f64>,
    /// Angle to the floor below which it is taken as flat.
    #[input("θ_f", "deg", above = 0, below = 45, default = "1 deg")]
    pub flat: f64,
    /// Duration.
    #[input("t_e", "s", positive, default = "2 s")]
    pub duration: f64,
    /// Acceleration of gravity.
    #[input("g", "m/s^2", positive, default = "9.81 m/s^2")]
    pub gravity: f64,
}

register!(RollingMotion);

/// Error of a moment between two steps, in parts of a radian and of the largest.
const INTEGRATION_ERROR: f64 = 1e-10;

impl Analysis for RollingMotion {
    const ABOUT: About = About {
        id: "rigid-body/rolling-motion",
        title: "Motion of a rolling disc or coin",
        topic: "Rolling bodies",
        summary: "Contact path, angle, normal force and friction against time for a disc, hoop or coin rolling without slipping, until it lies flat, lifts or slips.",
        main: &["inclination", "omega", "friction_needed"],
        keywords: "rolling disc coin hoop simulation non-holonomic Euler disk moeda disco aro rolando não holonômico simulação contato atrito",
        sources: &[&ROUTH, &HAIRER],
        cases: include_str!("../../cases/rolling_motion.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &RollingMotionGiven<W>, sheet: W) -> Result<(), Refusal> {
        let (mass, radius, gravity, theta) = (given.mass, given.radius, given.gravity, given.inclination);
        let [axial, transverse] = wheel::moments(&given.wheel, mass, radius, true, sheet);
        if self.inclination <= self.flat || self.inclination >= PI - self.flat {
            return Err(Refusal::because(
                "it lies flat from the start; give a larger angle to the floor, or a smaller angle at which it counts as flat",
            ));
        }
        let first =
            sheet.step("ω₁", "rad/s", given.tilting, "Angular velocity along the horizontal diameter");
        let second = sheet.step(
            "ω₂",
            "rad/s",
            given.precession * theta.sin(),
            "Angular velocity along the diameter through the contact: the precession along it",
        );
        let third = sheet.step(
            "ω₃",
            "rad/s",
            given.spin + given.precession * theta.cos(),
            "Angular velocity along the axis: the spin and the precession along it",
        );
        let rolling = sheet.step(
            "I_c",
            "kg*m^2",
            axial + mass * radius.powi(2),
            "Moment of inertia about the contact, along the axis",
        );
        let tilting = sheet.step(
            "I_d",
            "kg*m^2",
            transverse + mass * radius.powi(2),
            "Moment of inertia about the tangent at the contact",
        );
        let acceleration = |third: W::Num| {
            (transverse * second.powi(2) * theta.cos() / theta.sin()
                - rolling * second * third
                - mass * gravity * radius * theta.cos())
                / tilting
        };
        sheet.common_error(
            "θ̈",
            "the moment of the weight alone taken, without the gyroscopic terms",
            || -(mass * gravity * radius * theta.cos() / tilting),
        );
        sheet.common_error("θ̈", "the spin used in place of the angular velocity about the axis", || {
            acceleration(given.spin)
        });
        let tilt = sheet.step(
            "θ̈",
            "rad/s^2",
            acceleration(third),
            (
                "Angular acceleration of the tilt at the start: moments about the tangent at the contact, about which normal force and friction have no moment",
                ROUTH.at("ch. V"),
            ),
        );
        sheet.answer("initial_tilt_acceleration", "Angular acceleration of the tilt at the start", tilt);
        let disc = Rolling {
            mass: self.mass,
            radius: self.radius,
            axial: axial.value(),
            transverse: transverse.value(),
            gravity: self.gravity,
        };
        let omega = [first, second, third].map(Real::value);
        sheet.keep_going()?;
        let limits = Limits { flat: self.flat, friction: self.friction };
        let cancelled = || sheet.keep_going().is_err();
        let rolled = roll(
            &disc,
            [self.inclination, self.heading],
            omega,
            &limits,
            (self.duration, MOMENTS),
            &cancelled,
        );
        sheet.keep_going()?;
        let rolled = rolled.map_err(|error| refusal(&error))?;
        self.finish(sheet, &disc, &rolled, &cancelled);
        sheet.verify(|| {
            let rates = disc.accelerations(self.inclination, omega);
            let size = self.gravity / self.radius + omega.iter().map(|x| x * x).sum::<f64>();
            sheet.check_sum("the tilt by the equations in the axes 123", tilt, rates[0].into(), size);
        });
        self.show(sheet, &rolled);
        Ok(())
    }
}

impl RollingMotion {
    fn finish<W: Worksheet>(&self, sheet: W, disc: &Rolling, rolled: &Rolled, cancelled: &dyn Fn() -> bool) {
        let last = rolled.moments.last().expect("a motion has its start");
        let time = sheet.numerical(
            "t",
            "s",
            last.time,
            (
                Text::new("The equations I_d ω̇₁ = I_t ω₂² cot θ − I_c ω₂ ω₃ − m g r cos θ, I_t ω̇₂ = (I_a ω₃ − I_t ω₂ cot θ) ω₁, I_c ω̇₃ = m r² ω₁ ω₂ and the path of the contact, −r ψ̇ along 1, are integrated by the eighth-order Dormand–Prince method"),
                HAIRER.at("§II.5"),
            ),
        );
        sheet.answer("time", "Time at the end", time);
        match rolled.ended {
            Ended::Time => {}
            Ended::Flat => {
                sheet.warn(|| Text::new("it lies flat after {time}").with_quantity("time", last.time, "s"));
            }
            Ended::Lifts => sheet.warn(|| {
                Text::new("it leaves the floor after {time}: the normal force would become negative")
                    .with_quantity("time", last.time, "s")
            }),
            Ended::Slips => sheet.warn(|| {
                Text::new("it slips after {time}: the friction required for rolling exceeds μ N")
                    .with_quantity("time", last.time, "s")
            }),
        }
        let found = |symbol: &'static str, unit: &'static str, value: f64, reason: &'static str| {
            sheet.numerical(symbol, unit, value, reason)
        };
        let reach =
            rolled.moments.iter().map(|m| m.contact[0].hypot(m.contact[1])).fold(self.radius, f64::max);
        let clean = |x: f64, size: f64| if x.abs() > 1e-12 * size { x } else { 0.0 };
        let [x, y] = last.contact.map(|x| clean(x, reach));
        let x = found("x_C", "mm", x, "Contact at the end, along X");
        sheet.answer("contact_x", "Contact at the end, X", x);
        let y = found("y_C", "mm", y, "Contact at the end, along Y");
        sheet.answer("contact_y", "Contact at the end, Y", y);
        let angle = found("θ_e", "deg", last.inclination, "Angle between its plane and the floor at the end");
        sheet.answer("inclination", "Angle between its plane and the floor at the end", angle);
        let least = found(
            "θ_min",
            "deg",
            rolled.inclination.least.value,
            "Minimum angle over the motion: at a turning point, or at an end",
        );
        sheet.answer("least_inclination", "Minimum angle over the motion", least);
        let most_inclined = found(
            "θ_max",
            "deg",
            rolled.inclination.largest.value,
            "Maximum angle over the motion: at a turning point, or at an end",
        );
        sheet.answer("largest_inclination", "Maximum angle over the motion", most_inclined);
        let fastest = rolled.moments.iter().flat_map(|m| m.omega).fold(0.0, |most: f64, x| most.max(x.abs()));
        let omega = sheet.numerical_vector(
            "ω_e",
            "rad/s",
            Vector3::from(last.omega.map(|x| clean(x, fastest))),
            "Angular velocity at the end, in the axes 123",
        );
        sheet.answer_vector("omega", "Angular velocity at the end, axes 123", omega);
        let normal = found("N", "N", clean(last.normal, self.mass * self.gravity), "Normal force at the end");
        sheet.answer("normal", "Normal force at the end", normal);
        // Where it lifts off no friction is enough.
        if let Some(demand) = rolled.demand {
            let most = clean(demand.largest.value, 1.0);
            let most = found("μ_min", "1", most, "Maximum ratio of friction to normal force");
            sheet.answer("friction_needed", "Required coefficient of friction", most);
        }
        let drift = rolled.energy_drift();
        let bound = (-12..0).map(|power| 10.0_f64.powi(power)).find(|bound| drift <= *bound).unwrap_or(1.0);
        let bound = found(
            "δ_E",
            "1",
            bound,
            "Bound on |T + V − E₀| over the motion, relative to the energy: rolling does no work",
        );
        sheet.answer("energy_drift", "Energy conserved to within", bound);
        if drift > 1e-9 {
            sheet.warn(|| {
                "the energy is not conserved to nine digits: the last digits of the motion are unreliable"
                    .into()
            });
        } else {
            sheet.check_zero("the energy T + V over the motion", drift.into(), 1.0);
        }
        sheet.verify(|| {
            let turning = Vector::value(omega).into();
            let (pressed, _) = disc.contact_forces(angle.value(), turning);
            sheet.check_zero(
                "the normal force at the end",
                W::Num::from(pressed - normal.value()),
                self.mass * self.gravity,
            );
            // The last moments again, from the one that is kept before them.
            let again = |time: f64| integrated(disc, &rolled.moments, time, self.flat, cancelled);
            if let Some(end) = again(time.value()) {
                let place = (end.contact[0] - x.value()).hypot(end.contact[1] - y.value());
                let what = "the contact at the end, continued from the previous instant";
                sheet.check_residual(what, place.into(), reach, INTEGRATION_ERROR * reach);
                let what = "the angle at the end, continued from the previous instant";
                sheet.check_residual(what, (end.inclination - angle.value()).into(), 1.0, INTEGRATION_ERROR);
                let what = "the angular velocity at the end, continued from the previous instant";
                let off = Vector3::from(end.omega) - omega.value();
                sheet.check_residual(what, off.norm().into(), fastest, INTEGRATION_ERROR * fastest);
            }
            let extremes = [rolled.inclination.least.time, rolled.inclination.largest.time];
            for (shown, at) in [least, most_inclined].into_iter().zip(extremes) {
                let Some(there) = again(at) else { continue };
                let what = "the minimum and maximum angle, continued from the previous instant";
                sheet.check_residual(
                    what,
                    (there.inclination - shown.value()).into(),
                    1.0,
                    INTEGRATION_ERROR,
                );
            }
            let beyond = rolled
                .moments
                .iter()
                .map(|m| (least.value() - m.inclination).max(m.inclination - most_inclined.value()).max(0.0));
            sheet.check_zeros(
                "no angle during the motion lies outside the minimum and the maximum",
                beyond,
                1.0,
            );
        });
    }

    fn show<W: Worksheet>(&self, sheet: W, rolled: &Rolled) {
        let moments = &rolled.moments;
        let line = |name: &'static str, of: &dyn Fn(&Moment) -> f64| {
            Series::line(name, moments.iter().map(|moment| (moment.time, of(moment))).collect())
        };
        let over = |title: &'static str, label: &'static str, unit: &'static str, series| {
            let plot = Plot::new(title, Axis::linear("Time", "s"), Axis::linear(label, unit), series);
            Exhibit::Plot(plot.over("duration"))
        };
        sheet.show(|| self.animation(moments));
        sheet.show(|| {
            let contact = moments.iter().map(|moment| (moment.contact[0], moment.contact[1])).collect();
            let centre = moments.iter().map(|moment| self.centre(moment)).map(|c| (c.x, c.y)).collect();
            let times = moments.iter().map(|moment| moment.time).collect();
            Exhibit::Plot(
                Plot::new(
                    "Path on the floor",
                    Axis::linear("X", "mm"),
                    Axis::linear("Y", "mm"),
                    vec![
                        Series::line("contact", contact).of("contact_y").at(times),
                        Series::line("centre", centre),
                    ],
                )
                .equal()
                .over_answer("duration", "contact_x"),
            )
        });
        sheet.show(|| {
            over("Angle to the floor", "angle", "deg", vec![line("θ", &|m| m.inclination).of("inclination")])
        });
        sheet.show(|| {
            let omegas = vec![
                line("ω₁", &|m| m.omega[0]).of("omega.x"),
                line("ω₂", &|m| m.omega[1]).of("omega.y"),
                line("ω₃", &|m| m.omega[2]).of("omega.z"),
            ];
            over("Angular velocity in the axes 123", "Angular velocity", "rad/s", omegas)
        });
        sheet.show(|| {
            let forces = vec![
                line("N", &|m| m.normal).of("normal"),
                line("F", &|m| m.friction[0].hypot(m.friction[1])),
            ];
            over("Normal force and friction", "force", "N", forces)
        });
        sheet.show(|| {
            let series = vec![line("F/N", &|m| m.demand().min(1e3))];
            let plot = Plot::new(
                "Ratio of friction to normal force",
                Axis::linear("Time", "s"),
                Axis::linear("F/N", "1"),
                series,
            );
            Exhibit::Plot(match self.friction {
                Some(friction) => plot.level("μ", friction),
                None => plot,
            })
        });
    }

    /// The axes 1, 2 and 3 of a moment as the columns of a rotation.
    fn axes(moment: &Moment) -> Matrix3<f64> {
        let ((sin, cos), (sin_tilt, cos_tilt)) = (moment.heading.sin_cos(), moment.inclination.sin_cos());
        let first = Vector3::new(cos, sin, 0.0);
        let second = Vector3::new(-sin * cos_tilt, cos * cos_tilt, sin_tilt);
        Matrix3::from_columns(&[first, second, first.cross(second)])
    }

    fn centre(&self, moment: &Moment) -> Vector3<f64> {
        Vector3::new(moment.contact[0], moment.contact[1], 0.0) + Self::axes(moment).column(1) * self.radius
    }

    fn animation(&self, moments: &[Moment]) -> Exhibit {
        let points = moments.iter().map(|m| Vector3::new(m.contact[0], m.contact[1], 0.0));
        let path: Vec<Vector3<f64>> = points.collect();
        scene::animation("The rolling disc", 5.0, |part| {
            let moment = &moments[((moments.len() - 1) as f64 * part).round() as usize];
            let axes = Self::axes(moment);
            let spin = nalgebra::Rotation3::from_axis_angle(&Vector3::z_axis(), moment.spin);
            let centre = self.centre(moment);
            let mut scene = Scene::seen_from(self.heading - 0.9, 0.35);
            let radius = self.radius;
            scene.line(path.iter().copied(), Ink::Motion);
            scene.disc(centre, &(axes * spin.matrix()), radius, Ink::Body);
            let [across, up, axle] = [0, 1, 2].map(|n| axes.column(n).into_owned());
            scene.label(centre + (across + up) * (0.75 * radius), self.wheel.letters());
            let contact = Vector3::new(moment.contact[0], moment.contact[1], 0.0);
            scene.line([centre, contact], Ink::Faint);
            scene.label(centre - up * (0.5 * radius), "r");
            // The floor: the fixed direction X, the line of the horizontal diameter, and the line across it.
            let [x, z] = [Vector3::x(), Vector3::z()];
            let level = z.cross(across);
            scene.arrow(contact, x * (1.6 * radius), Ink::Faint, "X");
            scene.line([contact, contact + across * (1.6 * radius)], Ink::Faint);
            scene.angle("φ", contact, [x, across], 1.1 * radius);
            scene.line([contact, contact + level * (1.3 * radius)], Ink::Faint);
            scene.angle("θ", contact, [level, up], 0.8 * radius);
            scene.turn("φ̇", contact + z * (2.4 * radius), z, 0.3 * radius, Ink::Motion);
            scene.turn("ψ̇", centre + axle * (0.6 * radius), axle, 0.3 * radius, Ink::Motion);
            scene.line([centre, centre + axle * (0.6 * radius)], Ink::Faint);
            scene.turn("θ̇", contact + across * (1.3 * radius), across, 0.25 * radius, Ink::Motion);
            let omega = axes * Vector3::from(moment.omega);
            let size = omega.norm();
            if size > 0.0 {
                scene.arrow(centre, omega * (self.radius / size), Ink::Motion, "ω");
            }
            let weight = self.mass * self.gravity;
            let [along, across] = moment.friction;
            let side = Vector3::z().cross(axes.column(0).into_owned());
            let force = axes.column(0) * along + side * across + Vector3::z() * moment.normal;
            let most = (force.norm() / weight).clamp(0.0, 2.0);
            if let Some(unit) = force.try_normalize(0.0) {
                scene.arrow(contact, unit * (most * self.radius), Ink::Force, "R");
            }
            scene
        })
    }
}

/// The state at a time, followed on from the kept moment before it, with a contact that counts on.
fn integrated(
    disc: &Rolling,
    moments: &[Moment],
    time: f64,
    flat: f64,
    cancelled: &dyn Fn() -> bool,
) -> Option<Moment> {
    let before = moments[..moments.partition_point(|m| m.time < time)].last()?;
    // Where it lies flat it is not compared with that angle.
    let limits = Limits { flat: 0.9 * flat, friction: None };
    let start = [before.inclination, before.heading];
    let rolled = roll(disc, start, before.omega, &limits, (time - before.time, 2), cancelled).ok()?;
    let end = rolled.moments.last()?;
    let [x, y] = [0, 1].map(|axis| before.contact[axis] + end.contact[axis]);
    Some(Moment { contact: [x, y], ..*end })
}

fn refusal(error: &RollingError) -> Refusal {
    match error {
        RollingError::Motion(OdeError::TooManySteps { .. } | OdeError::TooShort { .. }) => Refusal::because(
            "the motion requires too many steps: the disc rotates or oscillates too fast for this duration; make it shorter",
        ),
        RollingError::Input | RollingError::Motion(_) => Refusal::because(
            "the motion cannot be integrated with these values: they are too large or too small relative to each other",
        ),
    }
}
