//! The arm as a mechanism, its animation, and the load that it carries at each angle.

use std::f64::consts::{FRAC_PI_2, PI};

use dalembert_core::{Axis, Exhibit, Ink, Plot, Series, Sketch, Text, exhibit::Point as At};
use dalembert_mechanics::planar::{
    BodyPoint, Driver, Effort, PlanarBody, PlanarJoint, PlanarLoad as Acting, PlanarMechanism,
    RelativeCoordinate,
};

use super::{ArmLoad, ArmPosition, ArmSpring, Geometry, Height, PotentialLaw, SpringLever};
use crate::shared::equilibria::{animation, down, spread};

impl SpringLever {
    /// Angle of the arm from the upright position, clockwise, at θ = 0.
    fn tilt(&self) -> f64 {
        match self.reference {
            ArmPosition::Upright => 0.0,
            ArmPosition::Horizontal => FRAC_PI_2,
            ArmPosition::Hanging => 2.0 * FRAC_PI_2,
            ArmPosition::Tilted { tilt } => tilt,
        }
    }

    fn arm(&self) -> f64 {
        match (&self.load, &self.spring) {
            (ArmLoad::Mass { arm, .. } | ArmLoad::Force { arm, .. }, _) => *arm,
            (_, ArmSpring::Drum { radius, .. }) => 2.0 * radius,
            (_, ArmSpring::Points { on_arm, .. }) => *on_arm,
            (_, ArmSpring::Sides { height, .. }) => *height,
            (_, ArmSpring::Torsion { .. }) => 1.0,
        }
    }

    /// The arm as a plane mechanism of one body, held at an angle.
    pub(super) fn built(
        &self,
        law: &PotentialLaw<f64>,
        k: f64,
        moment: f64,
        at: f64,
    ) -> (PlanarMechanism, Vec<[f64; 3]>) {
        let start = FRAC_PI_2 - self.tilt();
        let angle = RelativeCoordinate::Angle { of: Some(0), against: None };
        let arm = self.arm();
        let load = if matches!(law.height, Height::Couple) {
            Acting::Effort { measure: angle, effort: Effort::Constant(-moment) }
        } else {
            down(BodyPoint::body(0, [arm, 0.0]), moment / arm)
        };
        let (measure, stiffness, free) = match (&self.spring, law.geometry) {
            (_, Geometry::Torsion { free }) => (angle, k, start - free.unwrap_or(0.0)),
            (_, Geometry::Drum { radius, free }) => (angle, k * radius * radius, start - free.unwrap_or(0.0)),
            (_, Geometry::Sides { height }) => {
                let direction = [self.tilt().cos(), -self.tilt().sin()];
                let on_arm = BodyPoint::body(0, [height, 0.0]);
                (
                    RelativeCoordinate::Component {
                        direction,
                        from: BodyPoint::ground([0.0; 2]),
                        to: on_arm,
                    },
                    2.0 * k,
                    0.0,
                )
            }
            (
                ArmSpring::Points { on_arm_angle, fixed_angle, .. },
                Geometry::Points { on_arm, fixed, free, .. },
            ) => {
                let (gamma, delta) = (-on_arm_angle, start - fixed_angle);
                let on_arm = BodyPoint::body(0, [on_arm * gamma.cos(), on_arm * gamma.sin()]);
                let fixed = BodyPoint::ground([fixed * delta.cos(), fixed * delta.sin()]);
                (RelativeCoordinate::Distance { from: fixed, to: on_arm }, k, free)
            }
            (_, Geometry::Points { .. }) => unreachable!("the geometry is that of this spring"),
        };
        let mechanism = PlanarMechanism {
            bodies: vec![PlanarBody::default()],
            joints: vec![PlanarJoint::Pin {
                a: BodyPoint::ground([0.0; 2]),
                b: BodyPoint::body(0, [0.0; 2]),
            }],
            drivers: vec![Driver { measure: angle, value: start - at, velocity: 0.0, acceleration: 0.0 }],
            loads: vec![load, Acting::Effort { measure, effort: Effort::Spring { stiffness, free } }],
            gravity: [0.0; 2],
        };
        (mechanism, vec![[0.0, 0.0, start - at]])
    }

    /// The arm swinging through a range about where it stands.
    pub(super) fn animation(&self, at: f64, [from, to]: [f64; 2]) -> Exhibit {
        animation("The arm about its position", ("", at), [from.max(at - 0.6), to.min(at + 0.6)], |angle| {
            self.frame(angle)
        })
    }

    fn frame(&self, angle: f64) -> Sketch {
        let arm = self.arm();
        let polar = |radius: f64, angle: f64| -> At { (radius * angle.sin(), radius * angle.cos()) };
        let turned = angle + self.tilt();
        let (o, tip) = ((0.0, 0.0), polar(arm, turned));
        let mut sketch = Sketch::default();
        sketch.size(2.0 * arm).axis(o, polar(1.1 * arm, self.tilt()));
        match &self.spring {
            ArmSpring::Torsion { .. } => {
                sketch.torsion_spring("k", o, FRAC_PI_2 - turned);
            }
            ArmSpring::Drum { radius, .. } => {
                let bottom = -1.3 * arm;
                let wound = (radius * angle).max(-0.4 * arm).min(0.4 * arm) - 0.5 * arm;
                sketch
                    .disc("", o, *radius)
                    .line("a", o, polar(*radius, turned + PI), Ink::Faint)
                    .bars([(-radius, 0.0), (-radius, wound)])
                    .spring("k", (-radius, bottom), (-radius, wound))
                    .ground((-radius - 0.2 * arm, bottom), (0.2 * arm - radius, bottom));
            }
            ArmSpring::Points { on_arm, on_arm_angle, fixed, fixed_angle, .. } => {
                let (end, fixed) =
                    (polar(*on_arm, turned + on_arm_angle), polar(*fixed, self.tilt() + fixed_angle));
                let up = FRAC_PI_2 - self.tilt();
                if *on_arm_angle != 0.0 {
                    sketch.angle("γ", o, FRAC_PI_2 - turned, FRAC_PI_2 - turned - on_arm_angle);
                }
                sketch
                    .line("d", o, fixed, Ink::Faint)
                    .angle("δ", o, up, up - fixed_angle)
                    .link("b", o, end)
                    .spring("k", fixed, end)
                    .pin("", fixed);
            }
            ArmSpring::Sides { height, .. } => {
                let end = polar(*height, turned);
                let across = polar(1.2 * arm, self.tilt() + FRAC_PI_2);
                let foot = polar(*height, self.tilt());
                sketch.dimension("a", o, foot, 2.0);
                for sign in [-1.0, 1.0] {
                    let wall = (foot.0 + sign * across.0, foot.1 + sign * across.1);
                    sketch.spring("k", wall, end).pin("", wall);
                }
            }
        }
        sketch.link("l", o, tip).pin("", o).label("θ", polar(0.5 * arm, self.tilt() + angle / 2.0));
        let below = (tip.0, tip.1 - 0.4 * arm);
        match &self.load {
            ArmLoad::Mass { .. } => sketch.particle("m", tip).force("W", tip, below),
            ArmLoad::Force { .. } => sketch.force("P", tip, below),
            ArmLoad::Couple { .. } => sketch.couple("M", o, (2.4, 0.3), Ink::Force),
        };
        sketch
    }
}

/// The load that the spring holds at each angle, in equilibrium.
pub(super) fn load_over_angle(
    law: &PotentialLaw<f64>,
    k: f64,
    arm: Option<f64>,
    moment: Option<f64>,
    [from, to]: [f64; 2],
) -> Plot {
    let arm_or_one = arm.unwrap_or(1.0);
    let held = |angle: f64| {
        let (down, drop) = law.height.slope(angle);
        let load = k * law.plain_spring(angle)[1] / if down { drop } else { -drop };
        (angle, load / arm_or_one)
    };
    let points: Vec<(f64, f64)> = spread([from, to], 360).map(held).collect();
    // Where the load turns nothing, no load is enough: the curve is broken there.
    let mut sizes: Vec<f64> =
        points.iter().map(|(_, load)| load.abs()).filter(|load| load.is_finite()).collect();
    sizes.sort_by(f64::total_cmp);
    let middle = sizes.get(sizes.len() / 2).copied().unwrap_or(0.0);
    let most = 4.0 * middle.max(moment.map_or(0.0, |moment| (moment / arm_or_one).abs()));
    let shown = |(angle, load): (f64, f64)| (angle, if load.abs() <= most { load } else { f64::INFINITY });
    let (label, unit) =
        if arm.is_some() { ("load in equilibrium", "N") } else { ("couple in equilibrium", "N*m") };
    let plot = Plot::new(
        Text::from("Load balanced by the spring, against the angle"),
        Axis::linear("angle", "deg"),
        Axis::linear(label, unit),
        vec![Series::line("held", points.into_iter().map(shown).collect())],
    );
    match moment {
        Some(moment) => plot.level("this load", moment / arm_or_one),
        None => plot,
    }
}
