//! A struck body that turns about a hinge.

use dalembert_core::{Inputs, Refusal, Text, Worksheet};
use dalembert_mechanics::Real;

use crate::sources::{BEER, HIBBELER};

/// A body that turns about a hinge O, and that is struck at a distance from it.
#[derive(Clone, Debug, Inputs)]
pub struct HingedTarget {
    /// It is a.
    pub kind: HingedBody,
    /// Distance of the struck point from the hinge.
    #[input("r", "m", positive)]
    pub arm: f64,
    /// Angular velocity before.
    /// Positive in the sense in which the blow of A turns the body.
    #[input("ω₀", "rad/s", default = "0 rad/s")]
    pub speed: f64,
    /// Acceleration of gravity.
    /// For the swing of a body that hangs from the hinge.
    #[input("g", "m/s^2", nonnegative, default = "9.81 m/s^2")]
    pub gravity: f64,
}

/// The body on a hinge.
#[derive(Clone, Debug, Inputs)]
pub enum HingedBody {
    /// Slender rod
    /// Hinged at its end.
    Rod {
        /// Mass.
        #[input("M", "kg", positive)]
        mass: f64,
        /// Length.
        #[input("L", "m", positive)]
        length: f64,
    },
    /// Bob on a cord
    /// A block or a box that swings as a particle.
    Bob {
        /// Mass.
        #[input("M", "kg", positive)]
        mass: f64,
        /// Length of the cord.
        #[input("L", "m", positive)]
        length: f64,
    },
    /// Radius of gyration
    RadiusOfGyration {
        /// Mass.
        #[input("M", "kg", positive)]
        mass: f64,
        /// Radius of gyration about the hinge.
        #[input("k_O", "m", positive)]
        gyration: f64,
        /// Distance of G from the hinge.
        #[input("h", "m", nonnegative)]
        centre: f64,
    },
    /// Moment of inertia
    MomentOfInertia {
        /// Mass.
        #[input("M", "kg", positive)]
        mass: f64,
        /// Moment of inertia about the hinge.
        #[input("I_O", "kg*m^2", positive)]
        inertia: f64,
        /// Distance of G from the hinge.
        #[input("h", "m", nonnegative)]
        centre: f64,
    },
}

/// A hinged body on the worksheet.
pub(super) struct WorkedHinge<N> {
    /// Mass at the struck point that would move like the body, kg.
    pub mass: N,
    /// Velocity of the struck point before, m/s; `None` at rest.
    pub velocity: Option<N>,
    body: N,
    inertia: N,
    centre: N,
    arm: N,
    speed: N,
    gravity: N,
}

impl<W: Worksheet> HingedTargetGiven<W> {
    pub(super) fn work(&self, sheet: W) -> Result<WorkedHinge<W::Num>, Refusal> {
        const WHY: &str = "Moment of inertia about the hinge";
        let inertia = |value| sheet.step("I_O", "kg*m^2", value, WHY);
        let wrong = |what: &'static str, value: &dyn Fn() -> W::Num| sheet.common_error("I_O", what, value);
        match self.kind {
            HingedBodyGiven::Rod { mass, length } => {
                wrong("the moment of inertia of the rod about its centre used", &|| {
                    mass * length.powi(2) / 12.0
                });
                wrong("the mass of the rod taken at its centre", &|| mass * length.powi(2) / 4.0);
            }
            HingedBodyGiven::RadiusOfGyration { mass, gyration, centre } => {
                wrong("M h² added, as if the radius of gyration were about G", &|| {
                    mass * (gyration.powi(2) + centre.powi(2))
                });
            }
            _ => {}
        }
        let (body, inertia, centre) = match self.kind {
            HingedBodyGiven::Rod { mass, length } => (
                mass,
                inertia(rigid_rod(mass, length)),
                sheet.step("h", "m", length / 2.0, "Distance of G from the hinge"),
            ),
            HingedBodyGiven::Bob { mass, length } => (mass, inertia(mass * length.powi(2)), length),
            HingedBodyGiven::RadiusOfGyration { mass, gyration, centre } => {
                (mass, inertia(mass * gyration.powi(2)), centre)
            }
            HingedBodyGiven::MomentOfInertia { mass, inertia, centre } => (mass, inertia, centre),
        };
        if inertia.value() < (body * centre.powi(2)).value() * (1.0 - 1e-9) {
            return Err(Refusal::because(
                "the moment of inertia about the hinge is less than that of the mass at G, M h²: write a larger one, or G closer to the hinge",
            ));
        }
        if !matches!(self.kind, HingedBodyGiven::Bob { .. }) {
            sheet.common_error("m_B", "the mass of the hinged body used, as if it were free", || body);
        }
        let mass = sheet.step(
            "m_B",
            "kg",
            inertia / self.arm.powi(2),
            ("Mass at the struck point that would move like the body", BEER.at("§17.3")),
        );
        let velocity = (self.speed.value() != 0.0).then(|| {
            let why = "Velocity of the struck point before the impact";
            sheet.step("u_B", "m/s", self.speed * self.arm, why)
        });
        Ok(WorkedHinge {
            mass,
            velocity,
            body,
            inertia,
            centre,
            arm: self.arm,
            speed: self.speed,
            gravity: self.gravity,
        })
    }
}

fn rigid_rod<N: Real>(mass: N, length: N) -> N {
    mass * length.powi(2) / 3.0
}

impl<N: Real> WorkedHinge<N> {
    /// Answers the rotation after the impact, the impulse of the hinge and the swing. `embedded` is the mass that has
    /// stuck to the body.
    pub(super) fn after<W: Worksheet<Num = N>>(
        &self,
        impulse: N,
        velocity: N,
        embedded: Option<N>,
        sheet: W,
    ) {
        let &Self { body, inertia, centre, arm, speed, .. } = self;
        sheet.common_error("ω", "the velocity of the struck point divided by the distance of G", || {
            velocity / centre
        });
        let omega = sheet.step(
            "ω",
            "rad/s",
            velocity / arm,
            ("Angular velocity after the impact", HIBBELER.at("§19.4")),
        );
        sheet.answer("angular_velocity", "Angular velocity after", omega);
        let change = if self.velocity.is_none() { omega } else { omega - speed };
        let hinge = sheet.step(
            "J_O",
            "N*s",
            body * centre * change - impulse,
            (
                "Impulse of the hinge, in the direction of the blow: with it G has its new velocity",
                BEER.at("§17.3"),
            ),
        );
        sheet.answer("hinge_impulse", "Impulse of the hinge on the body", hinge);
        sheet.verify(|| {
            // Moments about G, which both impulses turn.
            let about = inertia - body * centre.powi(2);
            let size = (inertia * change).value().abs();
            let what = "angular momentum about G: the moments of blow and hinge";
            sheet.check_sum(what, impulse * (arm - centre) - hinge * centre, about * change, size);
            let what = "angular momentum about the hinge: the moment of the blow";
            sheet.check_sum(what, inertia * change, impulse * arm, size);
        });
        if centre.value() <= 0.0 {
            return;
        }
        if inertia.holds_with(body * centre.powi(2), |whole, at_g| whole > at_g * (1.0 + 1e-9)) {
            sheet.common_error("r_P", "the radius of gyration about the hinge taken", || {
                (inertia / body).sqrt()
            });
            sheet.common_error(
                "r_P",
                "the moment of inertia about G used, or the distance measured from G",
                || inertia / (body * centre) - centre,
            );
        }
        let percussion = sheet.step(
            "r_P",
            "m",
            inertia / (body * centre),
            (
                "Distance of the centre of percussion: a blow there needs no impulse of the hinge",
                BEER.at("§17.3"),
            ),
        );
        sheet.answer("percussion", "Distance of the centre of percussion", percussion);
        sheet.verify(|| {
            let what = "a blow at that distance gives G its velocity by itself";
            sheet.check(what, percussion * body * centre / inertia, W::Num::from(1.0));
        });
        self.swing(omega, impulse, embedded, sheet);
    }

    /// Answers how far the body swings that hung from the hinge.
    fn swing<W: Worksheet<Num = N>>(&self, omega: N, impulse: N, embedded: Option<N>, sheet: W) {
        let &Self { body, inertia, centre, arm, gravity, .. } = self;
        if gravity.value() <= 0.0 || omega.value() <= 0.0 {
            return;
        }
        let (inertia, moment) = match embedded {
            Some(mass) => (
                sheet.step(
                    "I_t",
                    "kg*m^2",
                    inertia + mass * arm.powi(2),
                    "Moment of inertia with A in the body",
                ),
                sheet.step("S", "kg*m", body * centre + mass * arm, "Moment of the masses about the hinge"),
            ),
            None => (inertia, sheet.step("S", "kg*m", body * centre, "Moment of the mass about the hinge")),
        };
        if inertia.holds_with(moment * centre, |whole, at_g| whole > at_g * (1.0 + 1e-9)) {
            sheet.common_error(
                "c",
                "v_G²/(2 g) used as the rise of G, the energy of the rotation omitted",
                || centre * omega.powi(2) / (gravity * 2.0),
            );
        }
        if let (Some(mass), None) = (embedded, self.velocity) {
            sheet.common_error("c", "the kinetic energy of A before the impact taken as conserved", || {
                let before = impulse * (mass + self.mass) / self.mass;
                before.powi(2) / (mass * 2.0) / (moment * gravity)
            });
        }
        let rise = sheet.step(
            "c",
            "1",
            inertia * omega.powi(2) / (moment * gravity * 2.0),
            "Energy after the impact as a height: 1 − cos θ of a body that hung from the hinge",
        );
        if rise.value() >= 2.0 {
            sheet.warn(|| Text::new("a body that hung from the hinge goes over the top"));
            return;
        }
        let angle = sheet.step(
            "θ",
            "deg",
            (W::Num::from(1.0) - rise).acos(),
            "Swing, at whose end the energy has become that of the weight",
        );
        let height = sheet.step("H", "m", centre * rise, "Rise of G, from h (1 − cos θ)");
        sheet.answer("swing", "Swing of the hanging body", angle);
        sheet.answer("rise", "Rise of G in the swing", height);
        sheet.verify(|| {
            let half = (angle / 2.0).sin();
            let work = moment * gravity * half.powi(2) * 2.0;
            sheet.check(
                "energy after the impact = work against the weight",
                work,
                inertia * omega.powi(2) / 2.0,
            );
            sheet.check("rise of G by the half angle", height, centre * half.powi(2) * 2.0);
        });
    }
}
