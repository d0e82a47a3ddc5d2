//! Central impact of two bodies, on a wall, or on a hinged body such as a ballistic pendulum.

mod hinged;
mod pictures;

use dalembert_core::{About, Analysis, Exhibit, Inputs, Refusal, Worksheet, register};
use dalembert_mechanics::Real;

use self::hinged::HingedTarget;
use crate::sources::{BEER, HIBBELER};

/// A body A that strikes another one along a line of impact, which points from A to the other and is positive that way.
///
/// The bodies are smooth, unless they stick together. The impact is so short that nothing moves meanwhile.
#[derive(Clone, Debug, Inputs)]
pub struct ImpactOfTwoBodies {
    /// Mass of body A.
    #[input("m_A", "kg", positive)]
    pub mass: f64,
    /// Velocity of body A before.
    #[input("A")]
    pub velocity: ImpactVelocity,
    /// Struck body.
    pub target: ImpactTarget,
    /// After the impact.
    pub outcome: ImpactOutcome,
}

/// Velocity of a body before an impact.
#[derive(Clone, Copy, Debug, PartialEq, Inputs)]
pub enum ImpactVelocity {
    /// Along the line of impact
    Direct {
        /// Velocity.
        #[input("u", "m/s")]
        velocity: f64,
    },
    /// Magnitude and direction
    Oblique {
        /// Speed.
        #[input("w", "m/s", nonnegative)]
        speed: f64,
        /// Angle to the line of impact.
        #[input("φ", "deg")]
        angle: f64,
    },
    /// Components
    Components {
        /// Along the line of impact.
        #[input("u", "m/s")]
        normal: f64,
        /// Across it.
        #[input("s", "m/s")]
        tangential: f64,
    },
}

/// The body that is struck.
#[derive(Clone, Debug, Inputs)]
pub enum ImpactTarget {
    /// A free body B
    /// Its centre of mass lies on the line of impact.
    Free {
        /// Mass of body B.
        #[input("m_B", "kg", positive)]
        mass: f64,
        /// Velocity of body B before.
        #[input("B")]
        velocity: ImpactVelocity,
    },
    /// A fixed wall
    Wall,
    /// A hinged body
    /// A rod, a pendulum, a door: the line of impact is normal to the arm from the hinge.
    Hinged {
        /// Hinged body.
        body: HingedTarget,
    },
}

/// Motion of the bodies after an impact, in its relation to that before.
#[derive(Clone, Debug, Inputs)]
pub enum ImpactOutcome {
    /// They separate
    Separate {
        /// Coefficient of restitution.
        /// 1 in an elastic impact.
        #[input("e", "1", min = 0, max = 1)]
        restitution: f64,
    },
    /// They stick together
    Stick,
}

register!(ImpactOfTwoBodies);

impl Analysis for ImpactOfTwoBodies {
    const ABOUT: About = About {
        id: "rigid-body/impact-of-two-bodies",
        title: "Impact of two bodies",
        topic: "Inertia and momentum",
        summary: "Velocities after a direct or oblique central impact, on a free body, a wall or a hinged body; impulse, energy lost, and the swing of a ballistic pendulum.",
        main: &["velocity_a", "velocity_b", "speed_a", "speed_b", "angular_velocity", "energy_lost"],
        keywords: "impact collision restitution elastic inelastic plastic direct oblique central spheres ballistic pendulum bullet block \
                   hinged rod percussion choque colisão elástico inelástico coeficiente de restituição pêndulo balístico esferas",
        sources: &[&BEER, &HIBBELER],
        cases: include_str!("../../cases/impact_of_two_bodies.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &ImpactOfTwoBodiesGiven<W>, sheet: W) -> Result<(), Refusal> {
        let zero = W::Num::from(0.0);
        let first = given.velocity.components(["u_A", "s_A"], sheet);
        // The struck body: its velocity, the mass that it puts against A (none for a wall), and its hinge.
        let (second, mass, hinge) = match &given.target {
            ImpactTargetGiven::Free { mass, velocity } => {
                (velocity.components(["u_B", "s_B"], sheet), Some(*mass), None)
            }
            ImpactTargetGiven::Wall {} => ([zero; 2], None, None),
            ImpactTargetGiven::Hinged { body: target } => {
                let hinge = target.work(sheet)?;
                ([hinge.velocity.unwrap_or(zero), zero], Some(hinge.mass), Some(hinge))
            }
        };
        let rests = hinge.as_ref().map_or(mass.is_none(), |hinge| hinge.velocity.is_none());
        let approach = if rests {
            first[0]
        } else {
            let why = "Velocity of approach along the line of impact";
            sheet.step("w_n", "m/s", first[0] - second[0], why)
        };
        if approach.value() <= 0.0 {
            return Err(Refusal::because(
                "body A does not approach what it strikes: along the line of impact its velocity must be above that of the struck body; change a sign or an angle",
            ));
        }
        let reduced = match mass {
            Some(mass) => sheet.step(
                "m_r",
                "kg",
                given.mass * mass / (given.mass + mass),
                "Reduced mass of the two: that of their relative motion",
            ),
            None => given.mass,
        };
        let restitution = match &given.outcome {
            ImpactOutcomeGiven::Separate { restitution } => Some(*restitution),
            ImpactOutcomeGiven::Stick {} => None,
        };
        if let Some(e) = restitution {
            sheet.common_error("J", "the struck body taken as a fixed wall", || {
                (e + 1.0) * given.mass * approach
            });
            sheet.common_error("J", "body A taken to stop at the impact", || given.mass * first[0]);
            sheet.common_error("J", "a perfectly elastic impact assumed", || reduced * approach * 2.0);
        }
        let impulse = match restitution {
            Some(e) => sheet.step(
                "J",
                "N*s",
                (e + 1.0) * reduced * approach,
                ("Impulse: 1 + e times the one that ends the approach", BEER.at("§13.4")),
            ),
            None => sheet.step("J", "N*s", reduced * approach, "Impulse that ends the approach"),
        };
        let impact = Impact {
            first,
            second,
            mass: given.mass,
            struck: mass,
            rests,
            approach,
            reduced,
            restitution,
            impulse,
        };
        sheet.answer("impulse", "Impulse along the line of impact", impulse);
        let after = impact.after(sheet);
        impact.directions(after, hinge.is_some(), sheet);
        impact.energy(after, hinge.is_none() && mass.is_some(), sheet);
        if let Some(hinge) = &hinge {
            let embedded = restitution.is_none().then_some(given.mass);
            hinge.after(impulse, after[1][0], embedded, sheet);
        }
        impact.check(after, sheet);
        if let ImpactOutcome::Separate { restitution } = self.outcome {
            let numbers = pictures::Numbers {
                before: [first[0].value(), second[0].value()],
                masses: [self.mass, mass.map_or(f64::INFINITY, Real::value)],
                restitution,
            };
            sheet.show(|| Exhibit::Plot(pictures::over_restitution(&numbers)));
        }
        let shown = [first.map(Real::value), second.map(Real::value)];
        sheet.show(|| Exhibit::Drawing(pictures::sketch(self, shown)));
        Ok(())
    }
}

impl<W: Worksheet> ImpactVelocityGiven<W> {
    /// The components along and across the line of impact; zero across it where none is given.
    fn components(&self, symbols: [&'static str; 2], sheet: W) -> [W::Num; 2] {
        match *self {
            ImpactVelocityGiven::Direct { velocity } => [velocity, 0.0.into()],
            ImpactVelocityGiven::Components { normal, tangential } => [normal, tangential],
            ImpactVelocityGiven::Oblique { speed, angle } => [
                sheet.step(symbols[0], "m/s", speed * angle.cos(), "Component along the line of impact"),
                sheet.step(symbols[1], "m/s", speed * angle.sin(), "Component across the line of impact"),
            ],
        }
    }
}

/// An impact: velocities along and across the line of impact, and what happens along it.
struct Impact<N> {
    first: [N; 2],
    second: [N; 2],
    mass: N,
    /// Mass that the struck body puts against A; `None` for a wall.
    struck: Option<N>,
    /// True if the struck body is at rest by what it is.
    rests: bool,
    approach: N,
    reduced: N,
    /// `None` where they stick together.
    restitution: Option<N>,
    impulse: N,
}

impl<N: Real> Impact<N> {
    fn is_oblique(&self) -> bool {
        self.first[1].value() != 0.0 || self.second[1].value() != 0.0
    }

    /// Answers the velocities after the impact, and gives them along and across the line of impact.
    fn after<W: Worksheet<Num = N>>(&self, sheet: W) -> [[N; 2]; 2] {
        let (first_mass, second_mass) = (self.mass, self.struck);
        let why = ("Velocity of A after the impact, along the line of impact", HIBBELER.at("§15.4"));
        let first = sheet.step("v_A", "m/s", self.first[0] - self.impulse / first_mass, why);
        sheet.answer("velocity_a", "Velocity of A after, along the line", first);
        let Some(mass) = second_mass else {
            let across = if self.restitution.is_some() { self.first[1] } else { 0.0.into() };
            return [[first, across], [0.0.into(); 2]];
        };
        let why = ("Velocity of the struck body there, along the line of impact", HIBBELER.at("§15.4"));
        let gained = self.impulse / mass;
        let second = if self.rests { gained } else { self.second[0] + gained };
        let second = sheet.step("v_B", "m/s", second, why);
        sheet.answer("velocity_b", "Velocity of B after, along the line", second);
        [[first, self.first[1]], [second, self.second[1]]]
    }

    /// Answers speeds and directions after an oblique impact. `is_hinged` says that the struck body turns.
    fn directions<W: Worksheet<Num = N>>(&self, after: [[N; 2]; 2], is_hinged: bool, sheet: W) {
        if !self.is_oblique() {
            return;
        }
        let (first_mass, second_mass) = (self.mass, self.struck);
        let free = second_mass.filter(|_| !is_hinged);
        if let Some(e) = self.restitution {
            reduced_across(e, ["v_A′", "φ_A′"], after[0], sheet);
            direction(["v_A′", "φ_A′"], ["speed_a", "angle_a"], SPEED_A, after[0], sheet);
            if free.is_some() {
                reduced_across(e, ["v_B′", "φ_B′"], after[1], sheet);
                direction(["v_B′", "φ_B′"], ["speed_b", "angle_b"], SPEED_B, after[1], sheet);
            }
        } else if let Some(mass) = free {
            sheet.common_error(
                "v_s",
                "the component of A across the line of impact taken as unchanged",
                || self.first[1],
            );
            let across = sheet.step(
                "v_s",
                "m/s",
                (first_mass * self.first[1] + mass * self.second[1]) / (first_mass + mass),
                "Across the line of impact both move on together too",
            );
            direction(["v′", "φ′"], ["speed", "angle"], SPEED_BOTH, [after[0][0], across], sheet);
        }
    }

    /// Answers the energy that is lost; two free bodies that stick together lose that of the motion across the line of
    /// impact in part, what holds one of them takes all of it.
    fn energy<W: Worksheet<Num = N>>(&self, after: [[N; 2]; 2], is_free: bool, sheet: W) {
        let (first_mass, second_mass) = (self.mass, self.struck);
        let kinetic = |[first, second]: [[N; 2]; 2]| {
            let square =
                |[n, t]: [N; 2], is_oblique: bool| if is_oblique { n.powi(2) + t.powi(2) } else { n.powi(2) };
            let of_first = first_mass * square(first, self.first[1].value() != 0.0) / 2.0;
            let is_oblique = self.second[1].value() != 0.0;
            let of_second = second_mass
                .filter(|_| second[0].value() != 0.0 || is_oblique)
                .map(|mass| mass * square(second, is_oblique) / 2.0);
            W::Num::sum([Some(of_first), of_second].into_iter().flatten())
        };
        let before =
            sheet.step("T", "J", kinetic([self.first, self.second]), "Kinetic energy before the impact");
        let along = self.reduced * self.approach.powi(2) / 2.0;
        let (lost, why) = match self.restitution {
            Some(e) => {
                ((W::Num::from(1.0) - e.powi(2)) * along, "Energy lost: 1 − e² of that of the approach")
            }
            None if !self.is_oblique() => (along, "Energy lost: all of that of the approach"),
            None if is_free => (
                self.reduced * (self.approach.powi(2) + (self.first[1] - self.second[1]).powi(2)) / 2.0,
                "Energy lost: all of that of the relative motion",
            ),
            None => (
                along + first_mass * self.first[1].powi(2) / 2.0,
                "Energy lost: that of the approach, and that of A across the line of impact",
            ),
        };
        match self.restitution {
            Some(e) => {
                sheet.common_error("ΔT", "1 − e² of the whole kinetic energy taken", || {
                    (W::Num::from(1.0) - e.powi(2)) * before
                });
            }
            None if !self.is_oblique() => {
                sheet.common_error("ΔT", "the mass of A used in place of the reduced mass", || {
                    first_mass * self.approach.powi(2) / 2.0
                });
            }
            None => {}
        }
        let lost = sheet.step("ΔT", "J", lost, (why, BEER.at("§13.4")));
        let share = sheet.step("q", "%", lost / before, "Share of the kinetic energy that is lost");
        sheet.answer("energy_lost", "Kinetic energy lost", lost);
        sheet.answer("energy_share", "Share of the kinetic energy lost", share);
        sheet.verify(|| {
            // What is left, in numbers: along the line of impact, and across it.
            let [a, t_a] = after[0].map(Real::value);
            let [b, t_b] = after[1].map(Real::value);
            let (m_a, m_b) = (first_mass.value(), second_mass.map_or(0.0, Real::value));
            let across = match (self.restitution, is_free) {
                (Some(_), _) => [t_a, t_b],
                (None, true) => [(m_a * t_a + m_b * t_b) / (m_a + m_b); 2],
                (None, false) => [0.0; 2],
            };
            let [t_a, t_b] = across;
            let left = m_a * (a.powi(2) + t_a.powi(2)) / 2.0 + m_b * (b.powi(2) + t_b.powi(2)) / 2.0;
            let size = before.value();
            let what = "kinetic energy lost as the difference of that before and after";
            sheet.check_sum(what, (size - left).into(), lost, size);
            sheet.check_sum(
                "lost share from the ratio of the kinetic energies",
                (1.0 - left / size).into(),
                share,
                1.0,
            );
        });
    }

    fn check<W: Worksheet<Num = N>>(&self, after: [[N; 2]; 2], sheet: W) {
        sheet.verify(|| {
            let (first_mass, second_mass) = (self.mass, self.struck);
            let [[first, _], [second, _]] = after;
            if let Some(mass) = second_mass {
                let before = first_mass * self.first[0];
                let (before, gained) = if self.rests {
                    (before, second)
                } else {
                    (before + mass * self.second[0], second - self.second[0])
                };
                let now = first_mass * first + mass * second;
                let size = (first_mass * self.first[0]).value().abs() + (mass * self.second[0]).value().abs();
                sheet.check_sum(
                    "momentum, or moment of momentum over the arm, before and after",
                    before,
                    now,
                    size,
                );
                sheet.check_sum("impulse = change of the momentum of B", self.impulse, mass * gained, size);
            } else {
                let size = (first_mass * self.first[0]).value().abs();
                sheet.check_sum(
                    "impulse = change of the momentum of A",
                    self.impulse,
                    first_mass * (self.first[0] - first),
                    size,
                );
            }
            let parting = self.restitution.unwrap_or_else(|| 0.0.into()) * self.approach;
            let size = self.first[0].value().abs() + self.second[0].value().abs();
            let apart = if second_mass.is_some() { second - first } else { -first };
            sheet.check_sum("velocity of separation = e times that of approach", apart, parting, size);
        });
    }
}

const SPEED_A: [&str; 2] = ["Speed of A after", "Angle of A to the line of impact after"];
const SPEED_B: [&str; 2] = ["Speed of B after", "Angle of B to the line of impact after"];
const SPEED_BOTH: [&str; 2] = ["Common speed after", "Angle of both to the line of impact"];

/// Records the error of a coefficient of restitution that is applied across the line of impact as well.
fn reduced_across<W: Worksheet>(
    e: W::Num,
    [speed, angle]: [&'static str; 2],
    [normal, across]: [W::Num; 2],
    sheet: W,
) {
    const WHAT: &str = "the component across the line of impact multiplied by e as well";
    if across.holds(|across| across != 0.0) {
        sheet.common_error(speed, WHAT, || (normal.powi(2) + (e * across).powi(2)).sqrt());
        sheet.common_error(angle, WHAT, || (e * across).atan2(normal));
    }
}

/// Answers speed and direction of a body. Without friction the component across the line of impact is as before.
fn direction<W: Worksheet>(
    symbols: [&'static str; 2],
    names: [&'static str; 2],
    labels: [&'static str; 2],
    [normal, across]: [W::Num; 2],
    sheet: W,
) {
    let why = "Speed, from the components along the line of impact and across it";
    let speed = sheet.step(symbols[0], "m/s", (normal.powi(2) + across.powi(2)).sqrt(), why);
    sheet.answer(names[0], labels[0], speed);
    if speed.value() == 0.0 {
        return;
    }
    let angle =
        sheet.step(symbols[1], "deg", across.atan2(normal), "Direction of the velocity after the impact");
    sheet.answer(names[1], labels[1], angle);
    sheet.verify(|| {
        let size = speed.value();
        sheet.check_sum(
            "speed and direction make up the component along the line",
            speed * angle.cos(),
            normal,
            size,
        );
        sheet.check_sum(
            "speed and direction make up the component across it",
            speed * angle.sin(),
            across,
            size,
        );
    });
}
