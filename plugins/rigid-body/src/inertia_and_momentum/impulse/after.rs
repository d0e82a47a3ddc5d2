//! The solution: momenta before, what is given, momenta after.

use dalembert_core::{Exhibit, Ink, Reason, Refusal, Text, Worksheet};
use dalembert_mechanics::{
    Real, Vector,
    rigid::{MassProperties, Principal},
};
use nalgebra::{Matrix3, Vector3};

use super::{
    BodyConstraint, BodyConstraintGiven, Impulse, ImpulseGiven, MassAfter, MassAfterGiven, Strength,
    StrengthGiven, common_errors,
    free::{self, After},
};
use crate::{
    shared::{
        body::{
            AboutPoint, WorkedBody, about_line, about_point, crossed, directed, matrix_times, product_errors,
            projection_error, refused, transferred, transferred_sum,
        },
        flat,
        scene::Scene,
    },
    sources::{BEER, HIBBELER, MERIAM},
};

/// A reason that names a blow or a projectile; written only where somebody reads it.
struct Named<'a>(&'static str, &'a str);

impl From<Named<'_>> for Reason {
    fn from(Named(reason, name): Named<'_>) -> Self {
        Reason { reason: Text::new(reason).with("name", name), cite: None }
    }
}

/// External impulses.
pub(super) struct Given<W: Worksheet> {
    /// Impulses, each at its point.
    pub(super) at_points: Vec<PointImpulse<W>>,
    /// Angular impulses of couples.
    pub(super) couples: Vec<W::Vec>,
}

/// External impulse at a point.
pub(super) struct PointImpulse<W: Worksheet> {
    pub(super) impulse: W::Vec,
    pub(super) point: W::Vec,
}

impl<W: Worksheet> Given<W> {
    /// The moments of all of them about a point.
    pub(super) fn moments(&self, about: W::Vec) -> impl Iterator<Item = W::Vec> {
        let moment = move |one: &PointImpulse<W>| (one.point - about).cross(one.impulse);
        self.at_points.iter().map(moment).chain(self.couples.iter().copied())
    }
}

/// Below this share of the largest moment a product of inertia is rounding.
const NO_PRODUCT: f64 = 1e-13;

const POINT_C: AboutPoint = AboutPoint {
    symbols: ["I_Cx", "I_Cy", "I_Cz", "I_Cyz", "I_Czx", "I_Cxy"],
    moment: "Parallel-axis theorem: moment of inertia about an axis through the newly fixed point",
    product: "Parallel-axis theorem: product of inertia about the newly fixed point",
};

impl Impulse {
    pub(super) fn follow<W: Worksheet>(&self, given: &ImpulseGiven<W>, sheet: W) -> Result<(), Refusal> {
        let body = self.body.work(&given.body, sheet)?;
        let omega = self.turning.work(&given.turning, &body, sheet)?;
        let velocity = self.going.work(&given.going, &body, omega, sheet)?;
        let kept: Vec<bool> = self.projectiles.iter().map(|one| one.mass_after == MassAfter::Kept).collect();
        let before =
            sheet.step("v", "m/s", velocity.magnitude(), "Speed of the centre of mass before impact");
        sheet.answer("speed_before", "Speed of the centre of mass before impact", before);
        let gifts = self.gifts(given, sheet);
        let before = body.momentum(omega);
        let momentum = sheet.step_vector(
            "H_G",
            "kg*m^2/s",
            before,
            ("Angular momentum about G before impact", BEER.at("§18.1A")),
        );
        let linear = sheet.step_vector("L", "kg*m/s", velocity * body.mass, "Linear momentum before impact");

        // With projectiles that stay, the body after is another one.
        let joined = if kept.contains(&true) { Some(self.joined(given, &body, sheet)?) } else { None };
        let arm = joined.as_ref().map(|(_, arm)| *arm);
        let after_body = joined.as_ref().map_or(&body, |(joined, _)| joined);
        let about = match arm {
            Some(arm) => momentum + arm.cross(linear),
            None => momentum,
        };
        let linear_after = sheet.step_vector(
            "L′",
            "kg*m/s",
            <W::Vec as Vector>::sum(
                std::iter::once(linear).chain(gifts.at_points.iter().map(|one| one.impulse)),
            ),
            ("Linear momentum after impact, excluding the support reactions: L + Σ J", BEER.at("§18.1B")),
        );
        let momentum_after = sheet.step_vector(
            "H_G′",
            "kg*m^2/s",
            <W::Vec as Vector>::sum(std::iter::once(about).chain(gifts.moments(after_body.centre))),
            (
                "Angular momentum about G after impact, excluding the support reactions: H_G + Σ r × J + Σ K",
                BEER.at("§18.1B"),
            ),
        );
        let after = self.after(given, after_body, linear_after, momentum_after, sheet)?;
        sheet.answer_vector("angular_velocity", "Angular velocity immediately after impact", after.omega);
        self.by_energy(&body, [omega, velocity], &after, sheet);
        let speed =
            sheet.step("ω_1", "rad/s", after.omega.magnitude(), "Angular speed immediately after impact");
        sheet.answer("angular_speed", "Angular speed immediately after impact", speed);
        sheet.answer_vector(
            "centre_velocity",
            "Velocity of the centre of mass just after impact",
            after.velocity,
        );
        let fast = sheet.step(
            "v_1",
            "m/s",
            after.velocity.magnitude(),
            "Speed of the centre of mass just after impact",
        );
        sheet.answer("centre_speed", "Speed of the centre of mass just after impact", fast);
        if let Some((reaction, _)) = after.reaction {
            sheet.answer_vector("reaction", "Impulsive reaction of the constraint", reaction);
        }
        if let Some(couple) = after.couple {
            sheet.answer_vector("reaction_couple", "Impulsive reaction couple of the axis", couple);
        }
        let change = self.energies(given, &body, after_body, [omega, velocity], &after, sheet);
        free::axis(after_body, &after, sheet);
        if matches!(self.hold, BodyConstraint::Nothing | BodyConstraint::Surface { .. }) {
            free::precession(after_body, &after, sheet)?;
        }
        self.wanted_mass(given, &body, momentum.value(), &after, &gifts, sheet)?;
        let before = [omega.value(), velocity.value()];
        self.check(&body, after_body, before, &gifts, &after, change.value(), sheet);
        let (turns, goes) = (after.omega.value(), after.velocity.value());
        sheet.show(|| self.drawn(after_body, &gifts, turns, goes));
        Ok(())
    }

    /// All impulses from outside.
    fn gifts<W: Worksheet>(&self, given: &ImpulseGiven<W>, sheet: W) -> Given<W> {
        let mut at_points = Vec::new();
        for (row, (blow, this)) in (1..).zip(self.blows.iter().zip(&given.blows)) {
            let impulse = match (&blow.strength, &this.strength) {
                (Strength::Force { .. }, StrengthGiven::Force { force, duration }) => sheet.step_vector(
                    ("J", row),
                    "N*s",
                    *force * *duration,
                    Named("Impulse of {name}: mean force times duration", &blow.name),
                ),
                (_, StrengthGiven::Impulse { impulse }) => *impulse,
                (_, StrengthGiven::Force { force, duration }) => *force * *duration,
            };
            at_points.push(PointImpulse { impulse, point: this.point });
        }
        for (row, (one, this)) in (1..).zip(self.projectiles.iter().zip(&given.projectiles)) {
            let (change, why) = match this.mass_after {
                MassAfterGiven::Leaves { velocity } => (
                    this.velocity - velocity,
                    "Linear momentum lost by {name}: its mass times the change of its velocity",
                ),
                _ => (this.velocity, "Linear momentum added by {name}"),
            };
            let impulse =
                sheet.step_vector(("L_p", row), "kg*m/s", change * this.mass, Named(why, &one.name));
            at_points.push(PointImpulse { impulse, point: this.point });
        }
        Given { at_points, couples: given.angular_impulses.iter().map(|this| this.impulse).collect() }
    }

    /// The body together with the projectiles that stay in it, and the way from its centre of mass to that before.
    fn joined<W: Worksheet>(
        &self,
        given: &ImpulseGiven<W>,
        body: &WorkedBody<W>,
        sheet: W,
    ) -> Result<(WorkedBody<W>, W::Vec), Refusal> {
        let stay = || {
            self.projectiles
                .iter()
                .zip(&given.projectiles)
                .filter(|(one, _)| one.mass_after == MassAfter::Kept)
        };
        let mass = sheet.step(
            "m′",
            "kg",
            Real::sum(std::iter::once(body.mass).chain(stay().map(|(_, this)| this.mass))),
            "Mass including the projectiles",
        );
        let centre = sheet.step_vector(
            "r_G′",
            "m",
            <W::Vec as Vector>::sum(
                std::iter::once(body.centre * body.mass)
                    .chain(stay().map(|(_, this)| this.point * this.mass)),
            ) / mass,
            "Centre of mass including the projectiles",
        );
        let own = sheet.step_vector(
            "d_0",
            "m",
            body.centre - centre,
            "From the centre of mass after impact to that before",
        );
        let arms: Vec<(W::Num, W::Vec)> = std::iter::once((body.mass, own))
            .chain((1..).zip(stay()).map(|(row, (one, this))| {
                let arm = sheet.step_vector(
                    ("d", row),
                    "m",
                    this.point - centre,
                    Named("From the centre of mass after impact to {name}", &one.name),
                );
                (this.mass, arm)
            }))
            .collect();
        let inertia = |symbol: &'static str, own: W::Num, gain: &dyn Fn(W::Num, W::Vec) -> Option<W::Num>| {
            let value = arms.iter().fold(own, |sum, (mass, arm)| transferred_sum(sum, gain(*mass, *arm)));
            common_errors::joined(symbol, own, &arms, gain, sheet);
            sheet.step(
                symbol,
                "kg*m^2",
                value,
                (
                    "Inertia about the centre of mass after impact, by the parallel-axis theorem",
                    MERIAM.at("App. B"),
                ),
            )
        };
        let [x, y, z] = body.moments;
        let [yz, zx, xy] = body.products;
        let moments = [
            inertia("I_x′", x, &|mass, arm| transferred(mass, arm, 0)),
            inertia("I_y′", y, &|mass, arm| transferred(mass, arm, 1)),
            inertia("I_z′", z, &|mass, arm| transferred(mass, arm, 2)),
        ];
        let products = [
            inertia("I_yz′", yz, &|mass, arm| crossed(mass, arm, 0)),
            inertia("I_zx′", zx, &|mass, arm| crossed(mass, arm, 1)),
            inertia("I_xy′", xy, &|mass, arm| crossed(mass, arm, 2)),
        ];
        let parts: Vec<MassProperties> = std::iter::once(body.properties)
            .chain(stay().map(|(one, _)| MassProperties::particle(one.mass, one.point)))
            .collect();
        let properties = MassProperties::composite(&parts).map_err(|error| refused(&error, "this body"))?;
        Ok((WorkedBody { mass, centre, moments, products, properties }, own))
    }

    /// The motion after: free, or held.
    fn after<W: Worksheet>(
        &self,
        given: &ImpulseGiven<W>,
        body: &WorkedBody<W>,
        linear: W::Vec,
        momentum: W::Vec,
        sheet: W,
    ) -> Result<After<W>, Refusal> {
        let free = |symbols: [&'static str; 2]| -> Result<[W::Vec; 2], Refusal> {
            let omega = turning(symbols[0], body.moments, body.products, momentum, "G", sheet)?;
            let velocity = sheet.step_vector(
                symbols[1],
                "m/s",
                linear / body.mass,
                "Velocity of the centre of mass just after impact",
            );
            Ok([omega, velocity])
        };
        match (&self.hold, &given.hold) {
            (BodyConstraint::Point { point: at }, BodyConstraintGiven::Point { point }) => {
                let arm =
                    sheet.step_vector("ρ", "m", body.centre - *point, "From the newly fixed point to G");
                let about = about_point(body, arm, &POINT_C, sheet);
                let momentum = sheet.step_vector(
                    "H_C",
                    "kg*m^2/s",
                    momentum + arm.cross(linear),
                    ("Angular momentum about the newly fixed point: the impulse there has no moment about it", BEER.at("§18.1B")),
                );
                let [x, y, z, yz, zx, xy] = about;
                let omega = turning("ω′", [x, y, z], [yz, zx, xy], momentum, "C", sheet)?;
                let (velocity, reaction) = held(body, omega, arm, linear, sheet);
                Ok(After { omega, velocity, reaction: Some((reaction, *at)), couple: None })
            }
            (BodyConstraint::Axis { point: at, axis: along }, BodyConstraintGiven::Axis { point, axis }) => {
                directed(*along)?;
                let cosines =
                    sheet.step_vector("λ", "1", *axis / axis.magnitude(), "Direction cosines of the axis");
                let arm =
                    sheet.step_vector("ρ", "m", body.centre - *point, "From the point on the axis to G");
                let momentum = sheet.step_vector(
                    "H_C",
                    "kg*m^2/s",
                    momentum + arm.cross(linear),
                    "Angular momentum about the point on the axis, excluding the reaction of the axis",
                );
                projection_error(momentum, cosines, sheet);
                let component = sheet.step(
                    "H_λ",
                    "kg*m^2/s",
                    momentum.dot(cosines),
                    (
                        "Angular momentum about the axis: the constraint has no moment about it",
                        BEER.at("§18.1B"),
                    ),
                );
                product_errors("I_λG", body, cosines, sheet);
                let through_g = sheet.step(
                    "I_λG",
                    "kg*m^2",
                    about_line(body.moments, body.products, cosines),
                    ("Moment of inertia about the parallel line through G", MERIAM.at("App. B/2")),
                );
                let inertia = sheet.step(
                    "I_λ",
                    "kg*m^2",
                    through_g + body.mass * arm.cross(cosines).magnitude().powi(2),
                    ("Moment of inertia about the axis", MERIAM.at("App. B/1")),
                );
                if inertia.value() <= 0.0 {
                    return Err(Refusal::because(
                        "the body has no moment of inertia about the axis that is held: its angular speed there is indeterminate; give it a thickness",
                    ));
                }
                let omega = sheet.step_vector(
                    "ω′",
                    "rad/s",
                    cosines * (component / inertia),
                    (
                        "Angular velocity immediately after impact: H_λ = I_λ ω′ along the axis",
                        BEER.at("§18.1B"),
                    ),
                );
                sheet.answer("axis_inertia", "Moment of inertia about the axis", inertia);
                sheet.answer("axis_momentum", "Angular momentum about the axis", component);
                let (velocity, reaction) = held(body, omega, arm, linear, sheet);
                sheet.verify(|| {
                    if let Ok(about) = body.properties.inertia_about_line(*at, *along) {
                        let size = body.properties.inertia.amax() + inertia.value();
                        let what = "moment of inertia about the axis from the tensor about the point on it";
                        sheet.check_sum(what, inertia, about.into(), size);
                    }
                    let transferred_sum =
                        matrix_times(body.moments, body.products, omega) + arm.cross(velocity * body.mass);
                    sheet.check_sum(
                        "angular momentum about the axis from the motion just after impact",
                        transferred_sum.dot(cosines),
                        component,
                        transferred_sum.value().norm(),
                    );
                });
                let couple = sheet.step_vector(
                    "C",
                    "N*m*s",
                    matrix_times(body.moments, body.products, omega) + arm.cross(velocity * body.mass)
                        - momentum,
                    "Impulsive reaction couple of the axis: change of the angular momentum about its point",
                );
                Ok(After { omega, velocity, reaction: Some((reaction, *at)), couple: Some(couple) })
            }
            (
                BodyConstraint::Surface { point: at, normal: out, .. },
                BodyConstraintGiven::Surface { point, normal, restitution },
            ) => {
                directed(*out)?;
                let [omega, velocity] = free(["ω_G0", "v_G0"])?;
                let cosines =
                    sheet.step_vector("n", "1", *normal / normal.magnitude(), "Unit normal of the surface");
                let arm = sheet.step_vector("ρ", "m", *point - body.centre, "From G to the point of impact");
                let approach = sheet.step(
                    "u_n",
                    "m/s",
                    (velocity + omega.cross(arm)).dot(cosines),
                    "Velocity of the point along the normal, before impact",
                );
                if approach.value() >= 0.0 {
                    return Err(Refusal::because(
                        "the point does not move towards the surface: check its normal, which points out of the surface, and the motion before impact",
                    ));
                }
                let lever = sheet.step_vector(
                    "q",
                    "m",
                    arm.cross(cosines),
                    "Lever arm of an impulse along the normal",
                );
                let turned = turning("w", body.moments, body.products, lever, "G", sheet)?;
                let mobility = sheet.step(
                    "κ",
                    "1/kg",
                    W::Num::from(1.0) / body.mass + lever.dot(turned),
                    "Velocity of the point per unit impulse along the normal",
                );
                let size = sheet.step(
                    "J_n",
                    "N*s",
                    -((*restitution + 1.0) * approach / mobility),
                    (
                        "Impulse of the surface: the separation velocity of the point is ε times its approach velocity",
                        MERIAM.at("§3/12"),
                    ),
                );
                let reaction = sheet.step_vector("R", "N*s", cosines * size, "Impulse of the surface");
                let omega = sheet.step_vector(
                    "ω′",
                    "rad/s",
                    omega + turned * size,
                    "Angular velocity immediately after impact",
                );
                let velocity = sheet.step_vector(
                    "v_G′",
                    "m/s",
                    velocity + reaction / body.mass,
                    "Velocity of the centre of mass just after impact",
                );
                Ok(After { omega, velocity, reaction: Some((reaction, *at)), couple: None })
            }
            _ => {
                let [omega, velocity] = free(["ω′", "v_G′"])?;
                Ok(After { omega, velocity, reaction: None, couple: None })
            }
        }
    }

    /// Kinetic energy before and after.
    fn energies<W: Worksheet>(
        &self,
        given: &ImpulseGiven<W>,
        body: &WorkedBody<W>,
        after_body: &WorkedBody<W>,
        [omega, velocity]: [W::Vec; 2],
        after: &After<W>,
        sheet: W,
    ) -> W::Num {
        let energy = |body: &WorkedBody<W>, omega: W::Vec, velocity: W::Vec| {
            (body.mass * velocity.dot(velocity) + omega.dot(body.momentum(omega))) / 2.0
        };
        let own = energy(body, omega, velocity);
        let brought: Vec<W::Num> =
            given.projectiles.iter().map(|this| this.mass * this.velocity.dot(this.velocity) / 2.0).collect();
        let taken = given.projectiles.iter().filter_map(|this| match this.mass_after {
            MassAfterGiven::Leaves { velocity } => Some(this.mass * velocity.dot(velocity) / 2.0),
            _ => None,
        });
        let reason = if brought.is_empty() {
            "Kinetic energy before impact"
        } else {
            "Kinetic energy before impact, including that of the projectiles"
        };
        let first = sheet.step("T", "J", Real::sum(std::iter::once(own).chain(brought)), reason);
        let second = sheet.step(
            "T′",
            "J",
            Real::sum(std::iter::once(energy(after_body, after.omega, after.velocity)).chain(taken)),
            "Kinetic energy after impact",
        );
        let change = sheet.step("ΔT", "J", second - first, "Change of the kinetic energy");
        sheet.answer("energy_before", "Kinetic energy before impact", first);
        sheet.answer("energy_after", "Kinetic energy after impact", second);
        sheet.answer("energy_change", "Change of the kinetic energy", change);
        change
    }

    fn drawn<W: Worksheet>(
        &self,
        body: &WorkedBody<W>,
        gifts: &Given<W>,
        omega: Vector3<f64>,
        velocity: Vector3<f64>,
    ) -> Exhibit {
        let mut scene = Scene::new();
        if let Ok(principal) = body.properties.check() {
            let size = self.body.draw(&mut scene, &body.properties, &principal);
            scene.axes(Vector3::zeros(), &Matrix3::identity(), 0.5 * size, ["x", "y", "z"]);
            let along = |vector: Vector3<f64>| {
                vector.try_normalize(0.0).map_or_else(Vector3::zeros, |unit| unit * (0.7 * size))
            };
            for (blow, row) in self.blows.iter().zip(1..) {
                let (vector, letters): (_, &[&'static str]) = match blow.strength {
                    Strength::Impulse { impulse } => (impulse, &["J", "r_J"]),
                    Strength::Force { force, .. } => (force, &["F", "r_J"]),
                };
                let arrow = along(vector);
                scene.arrow(blow.point - arrow, arrow, Ink::Force, flat::of_row(letters, row));
            }
            for (projectile, row) in self.projectiles.iter().zip(1..) {
                let (tip, arrow) = (projectile.point, along(projectile.velocity));
                scene.arrow(tip - arrow, arrow, Ink::Force, flat::of_row(&["r_p"], row));
                scene.label(tip - arrow, flat::of_row(&["m_p", "v_p"], row));
            }
            let centre = body.properties.centre;
            for couple in &gifts.couples {
                scene.arrow(centre, along(couple.value()), Ink::Force, "K");
            }
            self.turning.label(&mut scene, centre, 0.6 * size);
            self.going.label(&mut scene, centre, 0.5 * size);
            match self.hold {
                BodyConstraint::Nothing => {}
                BodyConstraint::Point { point }
                | BodyConstraint::Axis { point, .. }
                | BodyConstraint::Surface { point, .. } => scene.label(point, "r_C"),
            }
            scene.arrow(centre, along(omega), Ink::Result, "ω′");
            scene.arrow(centre, along(velocity), Ink::Motion, "v_G′");
            scene.label(centre, "G");
        }
        scene.exhibit("The body, the impulses on it and its motion just after impact")
    }
}

/// Solves `I x = H` for a body without products of inertia by components, else by its principal axes.
fn turning<W: Worksheet>(
    symbol: &'static str,
    moments: [W::Num; 3],
    products: [W::Num; 3],
    momentum: W::Vec,
    about: &'static str,
    sheet: W,
) -> Result<W::Vec, Refusal> {
    let unit = if symbol == "w" { "1/(kg*m)" } else { "rad/s" };
    let largest = moments.iter().fold(0.0f64, |largest, moment| largest.max(moment.value().abs()));
    let diagonal = products.iter().all(|product| product.value().abs() <= NO_PRODUCT * largest);
    let size = momentum.value().norm();
    let components = momentum.components();
    let thin = |n: usize| moments[n].value() <= 1e-9 * largest;
    if diagonal && (0..3).all(|n| !thin(n) || components[n].value().abs() <= 1e-9 * size) {
        let over = |n: usize| if thin(n) { W::Num::from(0.0) } else { components[n] / moments[n] };
        return Ok(sheet.step_vector(
            symbol,
            unit,
            W::Vec::from_components(over(0), over(1), over(2)),
            ("The axes are principal: each component over its moment of inertia", BEER.at("§18.1A")),
        ));
    }
    let tensor = MassProperties::tensor(
        Vector3::from(moments.map(Real::value)),
        Vector3::from(products.map(Real::value)),
    );
    let solved = Principal::of(&tensor).and_then(|principal| principal.angular_velocity(momentum.value()));
    let solved = solved.map_err(|error| refused(&error, "this body"))?;
    let why = if about == "G" {
        "The three equations I ω = H about G, with the products of inertia"
    } else {
        "The three equations I ω = H about the constrained point, with the products of inertia"
    };
    let found = sheet.numerical_vector(symbol, unit, solved, (why, HIBBELER.at("§21.2")));
    sheet.verify(|| {
        let left = tensor * solved - momentum.value();
        sheet.check_zero(
            "the solution substituted into I ω = H",
            left.norm().into(),
            momentum.value().norm().max(f64::MIN_POSITIVE),
        );
    });
    Ok(found)
}

/// A body that turns about a point at rest: velocity of G, and the impulse at the point.
fn held<W: Worksheet>(
    body: &WorkedBody<W>,
    omega: W::Vec,
    arm: W::Vec,
    linear: W::Vec,
    sheet: W,
) -> (W::Vec, W::Vec) {
    let velocity = sheet.step_vector(
        "v_G′",
        "m/s",
        omega.cross(arm),
        "Velocity of the centre of mass just after impact: G rotates about the constrained point",
    );
    let reaction = sheet.step_vector(
        "R",
        "N*s",
        velocity * body.mass - linear,
        (
            "Impulsive reaction: change of the linear momentum not due to the applied impulses",
            BEER.at("§18.1B"),
        ),
    );
    (velocity, reaction)
}
