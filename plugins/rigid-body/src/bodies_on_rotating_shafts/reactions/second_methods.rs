//! The reactions again: parts that are balanced by themselves, and the momenta at other times.

use dalembert_core::Worksheet;
use dalembert_mechanics::rigid::{self, MassProperties, chain, supports::Wrench};
use nalgebra::Vector3;

use super::{Found, Moved, Reactions};

/// The reactions at rest, what the motion adds to them, and the whole in the fixed axes, as they are shown.
#[derive(Default)]
pub(super) struct ReactionParts {
    pub(super) at_rest: Vec<Vector3<f64>>,
    pub(super) added: Vec<Vector3<f64>>,
    pub(super) fixed: Vec<Vector3<f64>>,
}

impl ReactionParts {
    /// The parts at rest against weight, loads and what holds the body; the others against inertia force and couple
    /// alone.
    pub(super) fn check<W: Worksheet>(
        &self,
        still: &[Wrench],
        loads: Wrench,
        moving: Option<(Vec<Wrench>, Option<f64>)>,
        sheet: W,
    ) {
        if self.at_rest.is_empty() {
            return;
        }
        let largest =
            |all: &[Wrench]| all.iter().map(|of| of.force.norm()).fold(loads.force.norm(), f64::max);
        let sum = self.at_rest.iter().sum::<Vector3<f64>>() + loads.force;
        let what = "the static reactions balance weight and loads";
        sheet.check_zero(what, sum.norm().into(), largest(still));
        let Some((moving, _)) = moving else { return };
        let off = self.added.iter().zip(&moving).map(|(added, of)| (added - of.force).norm());
        let what = "the dynamic reactions from inertia force and couple alone";
        sheet.check_zeros(what, off, largest(&moving).max(largest(still)));
    }
}

impl Reactions {
    /// A second method: momentum and angular momentum of the body about the fixed origin at other times, by
    /// differences, against the sum of all that acts on it.
    pub(super) fn check_by_differences<W: Worksheet>(
        &self,
        body: &MassProperties,
        moved: &Moved<W>,
        found: &Found,
        axes: &chain::ChainFrame,
        sheet: W,
    ) {
        let chain_at = |t: f64| {
            self.joints_with(moved.joint_acceleration).iter().map(|joint| joint.after(t)).collect::<Vec<_>>()
        };
        let lost = Vector3::repeat(f64::NAN);
        let momentum = |t: f64, angular: bool| {
            let Ok(frames) = chain::frames(&chain_at(t)) else { return lost };
            let last = &frames[frames.len() - 1];
            let point = last.point(body.centre);
            if angular {
                rigid::turned(&body.inertia, &last.rotation) * last.angular_velocity
                    + nalgebra::Matrix::cross(&(point.place - axes.origin), &(point.velocity * body.mass))
            } else {
                point.velocity * body.mass
            }
        };
        let period = chain::period(&chain_at(0.0));
        let (Ok(force), Ok(moment)) = (
            rigid::numerical_rate(|t| momentum(t, false), period),
            rigid::numerical_rate(|t| momentum(t, true), period),
        ) else {
            return;
        };
        let all = found.supports.iter().fold(found.known + found.drive, |sum, of| sum + *of);
        let (all_force, all_moment) = (axes.rotation * all.force, axes.rotation * all.moment);
        let size = |vectors: [Vector3<f64>; 3]| vectors.iter().map(Vector3::norm).fold(0.0f64, f64::max);
        let most = |part: fn(&Wrench) -> Vector3<f64>| {
            found.supports.iter().chain([&found.known]).map(|of| part(of).norm()).fold(0.0f64, f64::max)
        };
        let speed = std::f64::consts::TAU / period;
        let scale = body.mass * speed.powi(2) * body.centre.norm();
        sheet.check_zero(
            "the resultant of all forces equals the difference quotient of the momentum",
            W::Num::from((all_force - force).norm()),
            size([all_force, force, Vector3::x() * scale]).max(most(|of| of.force)),
        );
        if let Some(fixed) = found.fixed {
            let sum = fixed + axes.rotation * (found.known.force + found.drive.force);
            sheet.check_zero(
                "the reactions in the fixed axes plus all other forces equal the same difference quotient",
                W::Num::from((sum - force).norm()),
                size([all_force, force, Vector3::x() * scale]).max(most(|of| of.force)),
            );
        }
        let inertia = body.inertia.amax() * speed.powi(2) + scale * body.centre.norm();
        sheet.check_zero(
            "the sum of all moments equals the difference quotient of the angular momentum",
            W::Num::from((all_moment - moment).norm()),
            size([all_moment, moment, Vector3::x() * inertia]).max(most(|of| of.moment)),
        );
    }
}
