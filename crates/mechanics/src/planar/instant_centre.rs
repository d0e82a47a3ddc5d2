//! Instant centres of velocity: the points in which two parts of a mechanism have the same velocity.

use super::{BodyFrame, Model, tolerances::RELATIVE_REST};

/// The instant centre of two parts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum InstantCentre {
    /// This point, m.
    At([f64; 2]),
    /// Both have the same angular velocity: at infinity in the direction of this unit vector, across their relative
    /// velocity.
    Far([f64; 2]),
    /// They do not move against each other: every point.
    Everywhere,
}

impl Model {
    /// The point at which two parts have the same velocity, in the axes of the ground.
    ///
    /// `p = O + ẑ × (v_b − v_a) / (ω_b − ω_a)`, with the velocities v of both parts at any point O. The velocities may
    /// be those of the motion or of a virtual one. J. J. Uicker, G. R. Pennock, J. E. Shigley, *Theory of Machines and
    /// Mechanisms*, 4th ed. (2011), ch. 3.
    pub fn instant_centre(
        &self,
        [a, b]: [BodyFrame; 2],
        positions: &[[f64; 3]],
        velocities: &[[f64; 3]],
    ) -> InstantCentre {
        let size = |[x, y, turn]: &[f64; 3]| x.hypot(*y).max(turn.abs() * self.length);
        let rest = RELATIVE_REST * velocities.iter().map(size).fold(0.0, f64::max);
        let [ox, oy] = b.or(a).map_or([0.0; 2], |body| [positions[body][0], positions[body][1]]);
        let at_o = |part: BodyFrame| {
            part.map_or([0.0; 3], |body| {
                let ([x, y, _], [vx, vy, turn]) = (positions[body], velocities[body]);
                [vx - turn * (oy - y), vy + turn * (ox - x), turn]
            })
        };
        let ([ax, ay, turn_a], [bx, by, turn_b]) = (at_o(a), at_o(b));
        let (x, y, turn) = (bx - ax, by - ay, turn_b - turn_a);
        let speed = x.hypot(y);
        if turn.abs() * self.length > rest {
            InstantCentre::At([ox - y / turn, oy + x / turn])
        } else if speed > rest {
            InstantCentre::Far([-y / speed, x / speed])
        } else {
            InstantCentre::Everywhere
        }
    }
}
