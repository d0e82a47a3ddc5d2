//! The frame of the jack as a mechanism, held by the axial force.

use std::f64::consts::{FRAC_PI_2, PI};

use dalembert_mechanics::planar::{
    BodyPoint, Driver, PlanarBody, PlanarJoint, PlanarMechanism, RelativeCoordinate,
};

use super::{JackFrame, ScrewJack};
use crate::shared::{equilibria::down, scissor::Scissor};

impl ScrewJack {
    /// None where the load stands on the screw.
    pub(super) fn built(&self, load: f64) -> Option<(PlanarMechanism, Vec<[f64; 3]>)> {
        match self.frame {
            JackFrame::Plain => None,
            JackFrame::Rhombus { link, angle } => Some(rhombus(link, angle, load)),
            JackFrame::Scissors { stages, link, angle } => {
                let scissor = Scissor { stages: stages as usize, bar: link };
                let (mut mechanism, drawn) = scissor.built(angle);
                mechanism.drivers =
                    vec![apart(BodyPoint::ground([0.0; 2]), scissor.falling(0, 0.0), link * angle.cos())];
                mechanism.loads = vec![down(scissor.table(link * angle.cos() / 2.0, 0.0), load)];
                Some((mechanism, drawn))
            }
        }
    }
}

/// The lower links from the foot, the upper ones from the nuts; the head stays over the foot.
fn rhombus(l: f64, angle: f64, load: f64) -> (PlanarMechanism, Vec<[f64; 3]>) {
    let on = |body: usize, s: f64| BodyPoint::body(body, [s, 0.0]);
    let foot = BodyPoint::ground([0.0; 2]);
    let (wide, high) = (l * angle.cos(), l * angle.sin());
    let mechanism = PlanarMechanism {
        bodies: vec![PlanarBody::default(); 4],
        joints: vec![
            PlanarJoint::Pin { a: foot, b: on(0, 0.0) },
            PlanarJoint::Pin { a: foot, b: on(1, 0.0) },
            PlanarJoint::Pin { a: on(0, l), b: on(2, 0.0) },
            PlanarJoint::Pin { a: on(1, l), b: on(3, 0.0) },
            PlanarJoint::Pin { a: on(2, l), b: on(3, l) },
            PlanarJoint::Slot { guide: foot, direction: FRAC_PI_2, pin: on(2, l), offset: 0.0 },
        ],
        drivers: vec![apart(on(1, l), on(0, l), 2.0 * wide)],
        loads: vec![down(on(2, l), load)],
        gravity: [0.0; 2],
    };
    let drawn =
        vec![[0.0, 0.0, angle], [0.0, 0.0, PI - angle], [wide, high, PI - angle], [-wide, high, angle]];
    (mechanism, drawn)
}

fn apart(from: BodyPoint, to: BodyPoint, value: f64) -> Driver {
    let measure = RelativeCoordinate::Component { direction: [1.0, 0.0], from, to };
    Driver { measure, value, velocity: 0.0, acceleration: 0.0 }
}
