//! The mass for an angular speed, and the blow again by momenta about the origin and by work.

use dalembert_core::{Refusal, Worksheet};
use dalembert_mechanics::{Real, Vector, rigid::MassProperties};
use nalgebra::Vector3;

use super::{BodyConstraint, Impulse, ImpulseGiven, after::Given, free::After};
use crate::shared::body::WorkedBody;

impl Impulse {
    /// With which mass the body would turn as fast as is wanted.
    pub(super) fn wanted_mass<W: Worksheet>(
        &self,
        given: &ImpulseGiven<W>,
        body: &WorkedBody<W>,
        before: Vector3<f64>,
        after: &After<W>,
        gifts: &Given<W>,
        sheet: W,
    ) -> Result<(), Refusal> {
        let Some(wanted) = given.wanted_speed else { return Ok(()) };
        let moves = before != Vector3::zeros() || body.mass.value() == 0.0;
        if !matches!(self.hold, BodyConstraint::Axis { .. }) || moves || !self.projectiles.is_empty() {
            return Err(Refusal::because(
                "the mass for a required angular speed is calculated only for a body at rest that is held by an axis and struck by blows: otherwise leave the required angular speed out",
            ));
        }
        sheet.common_error("m*", "the ratio of the angular speeds inverted", || {
            body.mass * wanted / after.omega.magnitude()
        });
        let mass = sheet.step(
            "m*",
            "kg",
            body.mass * after.omega.magnitude() / wanted,
            "Mass for which the body, with the same shape, reaches the required angular speed: ω′ is proportional to 1/m",
        );
        sheet.answer("wanted_mass", "Mass for the required angular speed", mass);
        sheet.verify(|| {
            let BodyConstraint::Axis { point, axis } = self.hold else { return };
            let Ok(inertia) = body.properties.inertia_about_line(point, axis) else { return };
            let blows =
                gifts.at_points.iter().map(|one| (one.point.value() - point).cross(one.impulse.value()));
            let all = blows.chain(gifts.couples.iter().map(|couple| couple.value()));
            let (moments, sizes): (Vec<_>, Vec<_>) =
                all.map(|moment| (moment.dot(axis.normalize()), moment.norm())).unzip();
            let turned = mass / body.mass * inertia * wanted;
            sheet.check_sum(
                "angular momentum of that mass about the axis, and the moments of the blows",
                turned,
                moments.iter().sum::<f64>().abs().into(),
                sizes.iter().sum(),
            );
        });
        Ok(())
    }

    /// Momenta about the origin, the constraint, and the work of the impulses.
    #[expect(
        clippy::too_many_arguments,
        reason = "a blow is the body before and after, what is given, and the change"
    )]
    pub(super) fn check<W: Worksheet>(
        &self,
        body: &WorkedBody<W>,
        after_body: &WorkedBody<W>,
        [omega, velocity]: [Vector3<f64>; 2],
        gifts: &Given<W>,
        after: &After<W>,
        change: f64,
        sheet: W,
    ) {
        sheet.verify(|| {
            let (first, second) = (&body.properties, &after_body.properties);
            let (turns, goes) = (after.omega.value(), after.velocity.value());
            let about_origin = |body: &MassProperties, omega: Vector3<f64>, velocity: Vector3<f64>| {
                body.inertia * omega + body.centre.cross(velocity * body.mass)
            };
            let mut terms = vec![about_origin(second, turns, goes), -about_origin(first, omega, velocity)];
            terms.extend(gifts.at_points.iter().map(|one| -one.point.value().cross(one.impulse.value())));
            terms.extend(gifts.couples.iter().map(|couple| -couple.value()));
            if let Some((reaction, at)) = after.reaction {
                terms.push(-at.cross(reaction.value()));
            }
            if let Some(couple) = after.couple {
                terms.push(-couple.value());
            }
            let size = terms.iter().map(Vector3::norm).sum::<f64>();
            sheet.check_zero(
                "the angular momentum about O: after − before = Σ r × J with all reactions",
                terms.iter().sum::<Vector3<f64>>().norm().into(),
                size,
            );
            let at = |point: Vector3<f64>,
                      omega: Vector3<f64>,
                      velocity: Vector3<f64>,
                      centre: Vector3<f64>| { velocity + omega.cross(point - centre) };
            if let (BodyConstraint::Point { point } | BodyConstraint::Axis { point, .. }, Some(_)) =
                (&self.hold, after.reaction)
            {
                let left = at(*point, turns, goes, second.centre);
                sheet.check_zero(
                    "the velocity of the constrained point, which is zero",
                    left.norm().into(),
                    goes.norm() + turns.norm() * (point - second.centre).norm(),
                );
            }
            if self.projectiles.is_empty() {
                // The work of an impulse is its product with the mean of the velocities before and after.
                let work = |impulse: Vector3<f64>, point: Vector3<f64>| {
                    impulse
                        .dot(at(point, turns, goes, second.centre) + at(point, omega, velocity, first.centre))
                        / 2.0
                };
                let mut terms: Vec<f64> =
                    gifts.at_points.iter().map(|one| work(one.impulse.value(), one.point.value())).collect();
                terms.extend(gifts.couples.iter().map(|couple| couple.value().dot(turns + omega) / 2.0));
                if let Some((reaction, point)) = after.reaction {
                    terms.push(work(reaction.value(), point));
                }
                if let Some(couple) = after.couple {
                    terms.push(couple.value().dot(turns + omega) / 2.0);
                }
                let energy = |body: &MassProperties, omega: Vector3<f64>, velocity: Vector3<f64>| {
                    body.mass * velocity.norm_squared() / 2.0 + omega.dot(body.inertia * omega) / 2.0
                };
                terms.push(-change);
                let size = terms.iter().map(|term| term.abs()).sum::<f64>()
                    + energy(first, omega, velocity)
                    + energy(second, turns, goes);
                sheet.check_zero(
                    "the change of the kinetic energy from the work of the impulses, J · (v + v′)/2",
                    terms.iter().sum::<f64>().into(),
                    size,
                );
            }
        });
    }
}
