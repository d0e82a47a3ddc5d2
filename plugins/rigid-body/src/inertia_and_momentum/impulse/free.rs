//! Motion after the impulse: instantaneous axis, and free precession of a body of revolution.

use dalembert_core::{Refusal, Text, Worksheet};
use dalembert_mechanics::{Real, Vector};
use nalgebra::Vector3;

use crate::{
    shared::body::{WorkedBody, refused},
    sources::BEER,
};

/// The motion just after.
pub(super) struct After<W: Worksheet> {
    pub(super) omega: W::Vec,
    pub(super) velocity: W::Vec,
    /// Impulse of what holds the body, and where.
    pub(super) reaction: Option<(W::Vec, Vector3<f64>)>,
    /// Impulsive couple.
    pub(super) couple: Option<W::Vec>,
}

/// The instantaneous axis: its direction, its point nearest to G, and the sliding along it.
pub(super) fn axis<W: Worksheet>(body: &WorkedBody<W>, after: &After<W>, sheet: W) {
    let (omega, velocity) = (after.omega, after.velocity);
    let spin = omega.value().norm();
    let reach =
        body.properties.centre.norm() + (body.properties.inertia.trace() / body.properties.mass).sqrt();
    if spin * reach <= 1e-12 * velocity.value().norm() || spin == 0.0 {
        return;
    }
    let along =
        sheet.step_vector("λ′", "1", omega / omega.magnitude(), "Direction of the instantaneous axis");
    sheet.answer_vector("axis_direction", "Direction of the instantaneous axis", along);
    let point = sheet.step_vector(
        "r_I",
        "m",
        body.centre + omega.cross(velocity) / omega.dot(omega),
        ("Point of the instantaneous axis nearest to G: r_G + ω × v_G/ω²", BEER.at("§15.6B")),
    );
    sheet.answer_vector("axis_point", "Point of the instantaneous axis nearest to the centre of mass", point);
    let sliding =
        sheet.step("v_s", "m/s", along.dot(velocity), "Velocity of sliding along the instantaneous axis");
    sheet.answer("sliding", "Velocity along the instantaneous axis", sliding);
    sheet.verify(|| {
        let (omega, velocity) = (omega.value(), velocity.value());
        let there = velocity + omega.cross(point.value() - body.centre.value());
        sheet.check_zero(
            "the point on the instantaneous axis only slides along it",
            (there - along.value() * sliding.value()).norm().into(),
            velocity.norm() + omega.norm() * body.centre.value().norm(),
        );
        // Another point of the axis, at the distance one along it.
        let along = along.value();
        sheet.check_zero(
            "points of the instantaneous axis have no relative velocity",
            omega.cross(along).norm().into(),
            omega.norm(),
        );
        sheet.check("the direction is of length one", along.norm_squared().into(), 1.0.into());
    });
}

/// The free motion of a body of revolution afterwards.
pub(super) fn precession<W: Worksheet>(
    body: &WorkedBody<W>,
    after: &After<W>,
    sheet: W,
) -> Result<(), Refusal> {
    let principal = body.properties.check().map_err(|error| refused(&error, "this body"))?;
    let omega = after.omega.value();
    let Some(alone) = principal.symmetry_axis() else { return Ok(()) };
    let across = principal.moments[(alone + 1) % 3];
    let unit = principal.axis(alone);
    if omega == Vector3::zeros() || across <= 0.0 || principal.moments[alone] <= 0.0 {
        return Ok(());
    }
    // The axis is taken in the sense in which the body spins about it.
    let unit = if unit.dot(omega) < 0.0 { -unit } else { unit };
    let axis = sheet.numerical_vector(
        "u",
        "1",
        unit,
        (
            "Two principal moments are equal: the axis of the third, in the sense of the spin",
            BEER.at("§18.3C"),
        ),
    );
    let axial =
        sheet.numerical("I_a", "kg*m^2", principal.moments[alone], "Moment of inertia about this axis");
    let transverse = sheet.numerical("I_t", "kg*m^2", across, "Transverse moment of inertia");
    let momentum = sheet.step_vector(
        "H",
        "kg*m^2/s",
        body.momentum(after.omega),
        "Angular momentum about G: its direction is constant, and the axis now precesses about it",
    );
    let to_axis = |vector: W::Vec| axis.cross(vector).magnitude().atan2(axis.dot(vector));
    let gamma =
        sheet.step("γ", "deg", to_axis(after.omega), ("Angle between the axis and ω", BEER.at("§18.3C")));
    let theta = sheet.step(
        "θ",
        "deg",
        to_axis(momentum),
        ("Angle between the axis and H: the nutation", BEER.at("§18.3C")),
    );
    sheet.common_error("φ̇", "H divided by the moment of inertia about the axis", || {
        momentum.magnitude() / axial
    });
    let rate = sheet.step(
        "φ̇",
        "rad/s",
        momentum.magnitude() / transverse,
        ("Rate of precession about H", BEER.at("§18.3C")),
    );
    sheet.common_error("ψ̇", "the whole precession subtracted from ω_a", || axis.dot(after.omega) - rate);
    sheet.common_error("ψ̇", "the difference of the moments of inertia divided by I_a", || {
        axis.dot(after.omega) * (transverse - axial) / axial
    });
    let spin = sheet.step(
        "ψ̇",
        "rad/s",
        axis.dot(after.omega) * (transverse - axial) / transverse,
        ("Rate of spin about the axis, ψ̇ = ω_a − φ̇ cos θ", BEER.at("§18.3C")),
    );
    sheet.answer("body_cone", "Angle between the axis of the body and ω", gamma);
    sheet.answer("nutation", "Angle between the axis of the body and H", theta);
    sheet.answer("precession_rate", "Rate of precession", rate);
    sheet.answer("spin_rate", "Rate of spin", spin);
    sheet.verify(|| {
        // The angular momentum across the axis and along it, each its own moment of inertia times that of ω.
        sheet.check_zero(
            "the angles of ω and H from the axis, tan θ = (I_t/I_a) tan γ",
            axial * theta.sin() * gamma.cos() - transverse * gamma.sin() * theta.cos(),
            axial.value() + transverse.value(),
        );
        let along = momentum.value().normalize();
        let sum = along * rate.value() + unit * spin.value();
        sheet.check_zero(
            "the angular velocity composed of precession and spin",
            (sum - omega).norm().into(),
            rate.value().abs() + spin.value().abs(),
        );
    });
    if theta.value() > 1e-9 {
        sheet.warn(|| {
            Text::new(if spin.value() < 0.0 {
                "from then on the axis precesses against the spin (retrograde precession: the axial moment of inertia is the larger one)"
            } else {
                "from then on the axis precesses in the sense of the spin (direct precession: the axial moment of inertia is the smaller one)"
            })
        });
    }
    Ok(())
}
