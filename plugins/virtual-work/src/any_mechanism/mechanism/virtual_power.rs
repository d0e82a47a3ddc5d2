//! The balance of virtual power of a mechanism, load by load, and what Newton and Euler say to it.

use dalembert_core::{Reason, Symbol, Text, Worksheet};
use dalembert_mechanics::{
    Real, Vector,
    planar::{BodyPoint, LoadId, PlanarState, RelativeCoordinate},
    work,
};
use nalgebra::{Rotation2, Vector2, Vector3};

use super::{MechanismGiven, Solved};
use crate::{
    shared::parts::{Driven, PartLoad, PartLoadGiven, PartReference},
    sources::RIUL,
};

/// The units of one driver: of its effort, and of a length and an angle for each unit of its measure.
struct Per {
    effort: &'static str,
    length: &'static str,
    angle: &'static str,
}

impl Solved<'_> {
    /// The efforts of the drivers from the virtual power of all loads.
    /// `angular` are the angular accelerations of the bodies.
    pub(super) fn efforts<W: Worksheet>(&self, given: &MechanismGiven<W>, angular: &[W::Num], sheet: W) {
        for (driver, drive) in self.parts.drivers.iter().enumerate() {
            let (per, reason) = match drive.what {
                Driven::Angle { .. } => (
                    Per { effort: "N*m", length: "m/rad", angle: "rad/rad" },
                    "Torque of {name}: the total virtual power of all loads is zero, T + Σ W = 0",
                ),
                Driven::Position { .. } | Driven::Distance { .. } => (
                    Per { effort: "N", length: "m/m", angle: "rad/m" },
                    "Force of {name}, from the principle of virtual power, T + Σ W = 0",
                ),
            };
            let powers = &self.dynamics.powers;
            let works: Vec<W::Num> = (1..)
                .zip(powers)
                .filter(|(_, power)| power.generalised[driver] != 0.0)
                .map(|(row, power)| self.work(power.of, given, angular, (driver, row), &per, sheet))
                .collect();
            let row = driver + 1;
            let why = (Text::new(reason).with("name", &drive.name), RIUL.at("eq. 5"));
            let effort = if works.is_empty() {
                sheet.numerical(("T", row), per.effort, 0.0, why)
            } else {
                sheet.step(("T", row), per.effort, -<W::Num as Real>::sum(works), why)
            };
            sheet.answer(("effort", row), "Driving force or torque", effort);
            sheet.row_label(("effort", row), &drive.name);
            sheet.verify(|| {
                let largest = powers.iter().fold(0.0f64, |most, p| most.max(p.generalised[driver].abs()));
                sheet.check_zero(
                    Text::new("virtual power and the Newton–Euler equations give the same effort for {name}")
                        .with("name", &drive.name),
                    (effort.value() - self.dynamics.newton_euler[driver]).into(),
                    largest,
                );
            });
        }
        sheet.verify(|| self.check_power(sheet));
    }

    /// All that is brought in is the rate of the kinetic energy.
    fn check_power<W: Worksheet>(&self, sheet: W) {
        let inertia = |of: LoadId| matches!(of, LoadId::InertiaForce(_) | LoadId::InertiaCouple(_));
        let applied = self.dynamics.powers.iter().filter(|power| !inertia(power.of)).map(|power| power.power);
        let drivers = &self.system.mechanism().drivers;
        let driving =
            drivers.iter().zip(&self.dynamics.newton_euler).map(|(driver, effort)| driver.velocity * effort);
        let powers: Vec<f64> = applied.chain(driving).collect();
        let rate = self.dynamics.energy_rate;
        let largest = powers.iter().fold(rate.abs(), |most, power| most.max(power.abs()));
        let gap = powers.iter().sum::<f64>() - rate;
        sheet.check_zero(
            "the power of loads and drivers equals the rate of change of the kinetic energy",
            gap.into(),
            largest,
        );
    }

    /// The virtual power of a load for a unit velocity of a driver.
    fn work<W: Worksheet>(
        &self,
        of: LoadId,
        given: &MechanismGiven<W>,
        angular: &[W::Num],
        (driver, row): (usize, usize),
        per: &Per,
        sheet: W,
    ) -> W::Num {
        // With several drivers every symbol also says which one moves.
        let symbol = |base: &'static str| {
            let symbol = Symbol::from((base, row));
            if self.parts.drivers.len() > 1 { symbol.row(driver + 1) } else { symbol }
        };
        let name = self.name(of);
        let why = |reason: &'static str| Reason { reason: Text::new(reason).with("name", name), cite: None };
        let moved =
            PlanarState { velocities: self.dynamics.coefficients[driver].clone(), ..self.state.clone() };
        let way = |point: BodyPoint, reason: &'static str| {
            let [_, [x, y], _] = self.system.point(point, &moved);
            sheet.numerical_vector(symbol("u"), per.length, Vector3::new(x, y, 0.0), why(reason))
        };
        let rate = |measure: &RelativeCoordinate| {
            let unit = if measure.is_angle() { per.angle } else { per.length };
            let reason = if measure.is_angle() {
                "Rotation of {name} per unit displacement of the driver"
            } else {
                "Elongation of {name} per unit displacement of the driver"
            };
            sheet.numerical(symbol("u"), unit, self.system.rate(measure, &moved), why(reason))
        };
        let power = Reason {
            reason: Text::new("Virtual power of {name}").with("name", name),
            cite: Some(RIUL.at("eqs. 1, 5")),
        };
        let of_force = |force: W::Vec, way: W::Vec, power: Reason| {
            sheet.common_error(
                symbol("W"),
                "the magnitudes of force and displacement multiplied, without the angle between them",
                || force.magnitude() * way.magnitude(),
            );
            sheet.step(symbol("W"), per.effort, work::force_power(force, way), power)
        };
        let of_effort = |effort: W::Num, rate: W::Num, power: Reason| {
            sheet.step(symbol("W"), per.effort, effort * rate, power)
        };
        const OF_CENTRE: &str =
            "Displacement of the centre of mass of {name} per unit displacement of the driver";
        match of {
            LoadId::Weight(body) => {
                let way = way(BodyPoint::body(body, [0.0; 2]), OF_CENTRE);
                let weight = work::weight(given.bodies[body].mass, given.gravity);
                of_force(sheet.step_vector(symbol("F"), "N", weight, why("Weight of {name}")), way, power)
            }
            LoadId::InertiaForce(body) => {
                let way = way(BodyPoint::body(body, [0.0; 2]), OF_CENTRE);
                let [x, y, _] = self.state.accelerations[body];
                let reason = why("Acceleration of the centre of mass of {name}");
                let acceleration =
                    sheet.numerical_vector(symbol("a"), "m/s^2", Vector3::new(x, y, 0.0), reason);
                let force = work::inertia_force(given.bodies[body].mass, acceleration);
                let reason = why("Inertia force of {name}, opposite to the acceleration");
                of_force(sheet.step_vector(symbol("F"), "N", force, reason), way, power)
            }
            LoadId::InertiaCouple(body) => {
                let turning = rate(&RelativeCoordinate::Angle { of: Some(body), against: None });
                let couple = -(given.bodies[body].inertia * angular[body]);
                let reason = why("Inertia couple of {name}, opposite to the angular acceleration");
                of_effort(sheet.step(symbol("M"), "N*m", couple, reason), turning, power)
            }
            LoadId::Load(load) => {
                let described = &self.parts.loads[load].load;
                let measured = self.parts.measure(described).map(|measure| {
                    let value = self.system.value(&measure, &self.state.positions);
                    (measure, value, self.system.rate(&measure, self.state))
                });
                match (described, &given.loads[load].load, measured) {
                    (PartLoad::Force { at, axes, force: typed }, PartLoadGiven::Force { force, .. }, _) => {
                        let reason =
                            "Displacement of the point of {name} per unit displacement of the driver";
                        let way = way(self.parts.point(*at), reason);
                        let force = match axes {
                            PartReference::Ground => *force,
                            PartReference::Body { body } => {
                                let turned = Rotation2::new(self.state.positions[body.0][2])
                                    * Vector2::new(typed.x, typed.y);
                                let reason =
                                    why("Force {name}, rotated with the body in whose axes it is given");
                                sheet.numerical_vector(symbol("F"), "N", turned.push(0.0), reason)
                            }
                        };
                        of_force(force, way, power)
                    }
                    (_, PartLoadGiven::Couple { moment, .. }, Some((measure, ..))) => {
                        of_effort(*moment, rate(&measure), power)
                    }
                    (_, PartLoadGiven::Thrust { force }, Some((measure, ..))) => {
                        of_effort(*force, rate(&measure), power)
                    }
                    (_, PartLoadGiven::Spring { stiffness, free }, Some((measure, value, _))) => {
                        let length = sheet.numerical(symbol("L"), "mm", value, why("Length of {name}"));
                        let reason = why("Force of {name}, positive when it pushes its ends apart");
                        let force = -(*stiffness * (length - *free));
                        of_effort(sheet.step(symbol("F"), "N", force, reason), rate(&measure), power)
                    }
                    (_, PartLoadGiven::TorsionSpring { stiffness, free, .. }, Some((measure, value, _))) => {
                        let angle = sheet.numerical(symbol("φ"), "deg", value, why("Angle at {name}"));
                        let couple = -(*stiffness * (angle - *free));
                        let couple = sheet.step(symbol("M"), "N*m", couple, why("Couple of {name}"));
                        of_effort(couple, rate(&measure), power)
                    }
                    (_, PartLoadGiven::Damper { coefficient }, Some((measure, _, velocity))) => {
                        let reason = why("Rate of extension of {name}");
                        let velocity = sheet.numerical(symbol("v"), "m/s", velocity, reason);
                        let reason = why("Force of {name}, positive when it pushes its ends apart");
                        let force = sheet.step(symbol("F"), "N", -(*coefficient * velocity), reason);
                        of_effort(force, rate(&measure), power)
                    }
                    (
                        &PartLoad::Gas { area, pressure, column, exponent, ambient, .. },
                        _,
                        Some((measure, value, _)),
                    ) => {
                        let force = area * (pressure * (column / value).powf(exponent) - ambient);
                        let reason = why("Force of the gas of {name}, A (p₁ (L₁/L)ⁿ − p₀)");
                        of_effort(sheet.numerical(symbol("F"), "N", force, reason), rate(&measure), power)
                    }
                    _ => {
                        let reason = why(
                            "Virtual power of the friction of {name}, proportional to the force transmitted by its joint",
                        );
                        let found = self.dynamics.powers.iter().find(|power| power.of == of);
                        let si = found.map_or(0.0, |power| power.generalised[driver]);
                        sheet.numerical(symbol("W"), per.effort, si, reason)
                    }
                }
            }
        }
    }

    /// The name of a load, or of the body that is heavy or inert.
    pub(super) fn name(&self, of: LoadId) -> &str {
        match of {
            LoadId::Load(load) => &self.parts.loads[load].name,
            LoadId::Weight(body) | LoadId::InertiaForce(body) | LoadId::InertiaCouple(body) => {
                &self.parts.bodies[body].name
            }
        }
    }
}
