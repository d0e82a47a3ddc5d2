//! The motion of a disc that rolls without slip, from a start.

use dalembert_numerics::{
    extremes::{Extremes, Sampling},
    ode::{Integrator, OdeError, OdeSystem},
    roots,
};

/// A disc or hoop on a level plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rolling {
    /// Mass, kg.
    pub mass: f64,
    /// Radius, m.
    pub radius: f64,
    /// Moment of inertia about its axis through its centre, kg·m².
    pub axial: f64,
    /// Moment of inertia about a diameter, kg·m².
    pub transverse: f64,
    /// Acceleration of gravity, m/s².
    pub gravity: f64,
}

/// Reason for which a rolling motion cannot be computed.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum RollingError {
    /// A quantity of the disc or of the start makes no sense.
    #[error(
        "mass, radius and moments of inertia must be positive and finite, the inclination between 0 and 180°"
    )]
    Input,
    /// The motion ends early.
    #[error(transparent)]
    Motion(#[from] OdeError),
}

/// Conditions that end a motion before its duration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// The disc counts as flat with its plane at this angle to the floor, rad.
    pub flat: f64,
    /// Coefficient of friction beyond which it would slip; none for a floor that is rough enough.
    pub friction: Option<f64>,
}

/// Condition that ended a motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ended {
    /// End of its duration.
    Time,
    /// The disc lies flat.
    Flat,
    /// It leaves the floor.
    Lifts,
    /// It slips.
    Slips,
}

/// A moment of a motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moment {
    /// s.
    pub time: f64,
    /// Angle of the plane of the disc to the floor, rad.
    pub inclination: f64,
    /// Direction of the horizontal diameter against x, rad.
    pub heading: f64,
    /// Angle about its axis, rad.
    pub spin: f64,
    /// Angular velocity in the axes 123, rad/s.
    pub omega: [f64; 3],
    /// Contact point, m.
    pub contact: [f64; 2],
    /// Normal force, N.
    pub normal: f64,
    /// Friction along the horizontal diameter and normal to it, N.
    pub friction: [f64; 2],
    /// Kinetic and potential energy, J.
    pub energy: [f64; 2],
}

/// A motion.
#[derive(Debug, Clone, PartialEq)]
pub struct Rolled {
    /// From the start to the end.
    pub moments: Vec<Moment>,
    /// The least and the largest inclination, rad.
    pub inclination: Extremes,
    /// The least and the largest friction over the normal force; none where it leaves the floor.
    pub demand: Option<Extremes>,
    /// Condition that ended the motion.
    pub ended: Ended,
    /// Number of integration steps.
    pub steps: usize,
}

impl Moment {
    /// Friction over the normal force, infinite where the floor does not press.
    pub fn demand(&self) -> f64 {
        let [along, across] = self.friction;
        if self.normal > 0.0 { along.hypot(across) / self.normal } else { f64::INFINITY }
    }
}

impl Rolled {
    /// The largest change of the energy over the largest energy: zero when exact.
    pub fn energy_drift(&self) -> f64 {
        let Some(first) = self.moments.first() else { return 0.0 };
        let sum = |moment: &Moment| moment.energy[0] + moment.energy[1];
        let off = self.moments.iter().map(|moment| (sum(moment) - sum(first)).abs()).fold(0.0, f64::max);
        let size = self.moments.iter().map(sum).fold(0.0, f64::max);
        if size > 0.0 { off / size } else { off }
    }
}

impl Rolling {
    /// `ω̇₁`, `ω̇₂`, `ω̇₃` at an inclination, rad/s².
    pub fn accelerations(&self, inclination: f64, [first, second, third]: [f64; 3]) -> [f64; 3] {
        let Self { mass, radius, axial, transverse, gravity } = *self;
        let (sin, cos) = inclination.sin_cos();
        let (rolling, turning) = (mass * radius * radius, second * cos / sin);
        [
            (transverse * turning * second
                - (axial + rolling) * second * third
                - mass * gravity * radius * cos)
                / (transverse + rolling),
            (axial * third / transverse - turning) * first,
            rolling * first * second / (axial + rolling),
        ]
    }

    /// `K` of the small oscillations `ε̈ + K ε = 0` of the inclination about a steady motion with `ω₂` and `ω₃`, 1/s².
    pub fn tilting_stiffness(&self, inclination: f64, omega: [f64; 2]) -> f64 {
        let Self { mass, radius, axial, transverse, gravity } = *self;
        let moments = [axial, transverse];
        let slopes = super::tilting_slopes(mass, radius, moments, inclination, omega);
        super::tilting_stiffness(mass, radius, moments, gravity, inclination, omega, slopes)
    }

    /// The force of the floor on the disc in the axes 123, N: `F = m a_G + m g`.
    fn force(&self, inclination: f64, omega: [f64; 3]) -> [f64; 3] {
        let [first, second, third] = omega;
        let rates = self.accelerations(inclination, omega);
        let (sin, cos) = inclination.sin_cos();
        [
            self.mass * self.radius * (first * second - rates[2]),
            self.mass * (self.gravity * sin - self.radius * (first * first + third * second * cos / sin)),
            self.mass * (self.gravity * cos + self.radius * (rates[0] + third * second)),
        ]
    }

    /// Normal force, and friction along the horizontal diameter and normal to it, N.
    pub fn contact_forces(&self, inclination: f64, omega: [f64; 3]) -> (f64, [f64; 2]) {
        let [along, up, across] = self.force(inclination, omega);
        let (sin, cos) = inclination.sin_cos();
        (up * sin + across * cos, [along, up * cos - across * sin])
    }

    fn good(&self) -> bool {
        let positive = [self.mass, self.radius, self.axial, self.transverse];
        positive.iter().all(|x| x.is_finite() && *x > 0.0) && self.gravity.is_finite() && self.gravity >= 0.0
    }

    fn moment(&self, time: f64, state: &[f64]) -> Moment {
        let (inclination, omega) = (state[0], [state[3], state[4], state[5]]);
        let (normal, friction) = self.contact_forces(inclination, omega);
        let [first, second, third] = omega.map(|x| x * x);
        let rolling = self.mass * self.radius * self.radius;
        let kinetic =
            (self.transverse + rolling) * first + self.transverse * second + (self.axial + rolling) * third;
        Moment {
            time,
            inclination,
            heading: state[1],
            spin: state[2],
            omega,
            contact: [state[6], state[7]],
            normal,
            friction,
            energy: [kinetic / 2.0, self.mass * self.gravity * self.radius * inclination.sin()],
        }
    }
}

/// Follows a disc from an inclination, a heading and an angular velocity in the axes 123, with its contact at the origin.
///
/// # Errors
/// [`RollingError`].
pub fn roll(
    disc: &Rolling,
    [inclination, heading]: [f64; 2],
    omega: [f64; 3],
    limits: &Limits,
    (duration, samples): (f64, usize),
    cancelled: &dyn Fn() -> bool,
) -> Result<Rolled, RollingError> {
    const STEPS: usize = 40_000;
    /// Examines each step, which is a small part of a turn, and how far beside a time the rate is taken.
    const LOOKS: u32 = 4;
    const BESIDE: f64 = 1e-5;
    let good = disc.good()
        && inclination > limits.flat
        && inclination < std::f64::consts::PI - limits.flat
        && heading.is_finite()
        && omega.iter().all(|x| x.is_finite())
        && duration.is_finite()
        && duration > 0.0;
    if !good {
        return Err(RollingError::Input);
    }
    // The rates that errors are held against: of the start, and of falling over.
    let fall = (disc.gravity / disc.radius).sqrt();
    let rate = omega.iter().fold(fall, |most, x| most.max(x.abs())).max(1.0 / duration);
    let mut problem = Following { disc, rate, cancelled };
    let start = [inclination, heading, 0.0, omega[0], omega[1], omega[2], 0.0, 0.0];
    let mut integrator = Integrator::new(&mut problem, 0.0, &start, duration, STEPS)?.examined_between();
    let gaps = samples.saturating_sub(1).max(1);
    let time_of = |n: usize| if n == gaps { duration } else { duration * n as f64 / gaps as f64 };
    let mut moments = vec![disc.moment(0.0, &start)];
    let left = |ended: Ended, moment: &Moment| match ended {
        Ended::Flat => moment.inclination.sin() - limits.flat.sin(),
        Ended::Lifts => moment.normal,
        // Squares, so that there is no corner; in parts of the weight.
        Ended::Slips => limits.friction.map_or(1.0, |friction| {
            let [along, across] = moment.friction;
            let most = friction * moment.normal;
            (most * most - along * along - across * across)
                / (disc.mass * disc.gravity).powi(2).max(f64::MIN_POSITIVE)
        }),
        Ended::Time => 1.0,
    };
    let mut ended = Ended::Time;
    let mut inclinations = Extremes::at(0.0, inclination);
    let mut demand = Extremes::at(0.0, moments[0].demand());
    for at_once in [Ended::Lifts, Ended::Slips] {
        if left(at_once, &moments[0]) < 0.0 {
            let demand = (at_once != Ended::Lifts).then_some(demand);
            return Ok(Rolled { moments, inclination: inclinations, demand, ended: at_once, steps: 0 });
        }
    }
    while integrator.time() < duration && ended == Ended::Time {
        integrator.advance(&mut problem, duration)?;
        let mut until = integrator.time();
        for end in [Ended::Flat, Ended::Lifts, Ended::Slips] {
            let number = |_: &mut Following, time: f64, state: &[f64]| left(end, &disc.moment(time, state));
            let zero = integrator.first_zero(&mut problem, number);
            if let Some(time) = zero.filter(|time| *time <= until) {
                (until, ended) = (time, end);
            }
        }
        let (before, end) = (integrator.before(), integrator.time());
        let mut at = |time: f64| disc.moment(time, &integrator.at(&mut problem, time));
        for part in 0..LOOKS {
            let place = |part: u32| {
                if part == LOOKS {
                    until
                } else {
                    before + (until - before) * f64::from(part) / f64::from(LOOKS)
                }
            };
            let stretch = [place(part), place(part + 1)];
            let mut inclined = |time: f64| {
                let moment = at(time);
                Sampling::of(moment.inclination, moment.omega[0])
            };
            inclinations.follow(&mut inclined, stretch);
            let beside = BESIDE * (end - before);
            let mut demanded = |time: f64| {
                let [early, late] = [(time - beside).max(before), (time + beside).min(end)];
                Sampling::of(at(time).demand(), (at(late).demand() - at(early).demand()) / (late - early))
            };
            if ended != Ended::Lifts {
                demand.follow(&mut demanded, stretch);
            }
        }
        while moments.len() <= gaps && time_of(moments.len()) <= until {
            let time = time_of(moments.len());
            let state = integrator.at(&mut problem, time);
            moments.push(disc.moment(time, &state));
        }
        if ended != Ended::Time && moments.last().is_none_or(|last| last.time < until) {
            let state = integrator.at(&mut problem, until);
            moments.push(disc.moment(until, &state));
        }
    }
    let demand = (ended != Ended::Lifts).then_some(demand);
    Ok(Rolled { moments, inclination: inclinations, demand, ended, steps: integrator.steps() })
}

struct Following<'a> {
    disc: &'a Rolling,
    rate: f64,
    cancelled: &'a dyn Fn() -> bool,
}

impl OdeSystem for Following<'_> {
    fn rates(&mut self, _: f64, state: &[f64], rates: &mut [f64]) {
        let (sin, cos) = state[0].sin_cos();
        let omega = [state[3], state[4], state[5]];
        let precession = omega[1] / sin;
        let spin = omega[2] - precession * cos;
        let (across, along) = state[1].sin_cos();
        rates[0] = omega[0];
        rates[1] = precession;
        rates[2] = spin;
        rates[3..6].copy_from_slice(&self.disc.accelerations(state[0], omega));
        rates[6] = -self.disc.radius * spin * along;
        rates[7] = -self.disc.radius * spin * across;
    }

    fn allowed(&mut self, _: &[f64], _: &[f64], allowed: &mut [f64]) {
        const TOLERANCE: f64 = 1e-13;
        allowed[..3].fill(TOLERANCE);
        allowed[3..6].fill(TOLERANCE * self.rate);
        allowed[6..].fill(TOLERANCE * self.disc.radius);
    }

    fn stopped(&self) -> bool {
        (self.cancelled)()
    }
}

impl Rolling {
    /// The inclinations up to upright with which a disc rolls steadily with its centre on a circle of radius `a` at a
    /// precession `φ̇`, rad, ascending.
    pub fn steady_inclinations(&self, centre_radius: f64, precession: f64) -> Vec<f64> {
        let Self { mass, radius, axial, transverse, gravity } = *self;
        let turning = precession * precession;
        let rolled = (axial + mass * radius * radius) * centre_radius / radius;
        let scale = mass * gravity * radius;
        let moment = |angle: f64| {
            let (sin, cos) = angle.sin_cos();
            turning / scale * sin * (rolled + transverse * cos) - cos
        };
        const PARTS: usize = 400;
        let at = |n: usize| std::f64::consts::FRAC_PI_2 * n as f64 / PARTS as f64;
        let between = |n: usize| {
            let ends = [at(n), at(n + 1)];
            let (a, b) = (moment(ends[0]), moment(ends[1]));
            let crosses = a * b < 0.0 || (b == 0.0 && a != 0.0);
            let on = |_| std::ops::ControlFlow::Continue(());
            crosses.then(|| roots::find(moment, ends, on).ok()).flatten()
        };
        (0..PARTS).filter_map(between).collect()
    }
}
