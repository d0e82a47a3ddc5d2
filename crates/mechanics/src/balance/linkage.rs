//! Force balance of planar linkages with one crank at a steady speed: four-bar and slider-crank.
//!
//! Points are `[x, y]` in metres, with the crank pivot at the origin.

use crate::{
    four_bar::{self, FourBar, Links},
    linkage::{LinkRotation, PointMotion},
    slider_crank,
};

/// The smallest [transmission](Pose::transmission), a sine or cosine: below it the linkage is at a dead point, where rounding
/// over its square would leave no digit of the accelerations.
const MIN_TRANSMISSION: f64 = 1e-9;

/// A rigid link: its mass, where its centre is, and its moment of inertia about it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinkInertia {
    /// Mass, kg.
    pub mass: f64,
    /// Distance of the centre of mass from the first pin of the link, m.
    pub distance: f64,
    /// Angle of the centre from the line to the second pin, rad.
    pub offset: f64,
    /// Moment of inertia about the centre, kg·m².
    pub inertia: f64,
}

/// Member that closes the loop after crank and coupler: rocker or slider.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Follower {
    /// A rocker that turns about a pin on the x axis.
    Rocker {
        /// Distance of the fixed pins, m.
        frame: f64,
        /// Length of the rocker, m.
        length: f64,
        /// True for the crossed assembly, with the pins of coupler and rocker below the frame.
        crossed: bool,
        /// The rocker itself; its first pin is the fixed one.
        link: LinkInertia,
    },
    /// A slider that moves along x at the height `offset`.
    Slider {
        /// Height of the guide, m.
        offset: f64,
        /// Mass of the slider, kg.
        mass: f64,
    },
}

/// A linkage with a crank.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Linkage {
    /// Length of the crank, m.
    pub crank: f64,
    /// Length of the coupler, m.
    pub coupler: f64,
    /// The crank; its first pin is the fixed one.
    pub crank_link: LinkInertia,
    /// The coupler; its first pin is that of the crank.
    pub coupler_link: LinkInertia,
    /// The third moving link.
    pub follower: Follower,
}

/// A counterweight: a mass fixed to a link.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Counterweight {
    /// The link: 0 crank, 1 coupler, 2 follower.
    pub link: usize,
    /// Mass, kg.
    pub mass: f64,
    /// Distance from the first pin of the link, m.
    pub distance: f64,
    /// Angle from the line to the second pin, rad.
    pub angle: f64,
}

/// A place of the linkage, and how it moves there at the speed of the crank.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pose {
    /// Crank pin, coupler pin and fixed pin (or guide point) of the follower, m.
    pub pins: [[f64; 2]; 3],
    /// Angles of crank, coupler and follower, rad; zero for a slider.
    pub angles: [f64; 3],
    /// Their angular velocities, rad/s.
    pub velocities: [f64; 3],
    /// Conditioning of the loop closure: the sine of the transmission angle for a four-bar, the cosine of the coupler's
    /// angle for a slider; 0 at a dead point.
    pub transmission: f64,
    speed: f64,
    /// Rotation of the links and motion of their first pins as functions of the crank angle.
    links: [LinkRotation<f64>; 3],
    starts: [PointMotion<f64>; 3],
}

/// Shaking force and moment on the frame, and driving torque of the crank.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Shaking {
    /// Shaking force on the frame, N.
    pub force: [f64; 2],
    /// Shaking moment on the frame about the crank pivot, N·m.
    pub moment: f64,
    /// Torque on the crank, N·m.
    pub torque: f64,
    /// Kinetic energy, J.
    pub energy: f64,
    /// First moment of all moving masses, `Σ m r`, kg·m: still when the force is balanced.
    pub first_moment: [f64; 2],
    /// Forces in the joints, N: of the frame on the crank, of the crank on the coupler, of the coupler on the follower,
    /// of the frame on the follower.
    pub joints: [[f64; 2]; 4],
}

impl Linkage {
    /// The place at a crank angle, and how it moves at a steady speed of the crank; `None` where the loop does not
    /// close, or only at a dead point.
    pub fn pose(&self, angle: f64, speed: f64) -> Option<Pose> {
        let (links, crank_pin, fixed) = match self.follower {
            Follower::Rocker { frame, length, crossed, .. } => {
                let four_bar = FourBar { frame, crank: self.crank, coupler: self.coupler, rocker: length };
                let branch = if crossed { four_bar::Branch::Crossed } else { four_bar::Branch::Open };
                let Links { crank, coupler, rocker, crank_pin } = four_bar.links(angle, branch);
                ([crank, coupler, rocker], crank_pin, Some([frame, 0.0]))
            }
            Follower::Slider { offset, .. } => {
                let ahead = slider_crank::Branch::Ahead;
                let slider_crank::Links { crank, crank_pin, rod, .. } =
                    slider_crank::links(self.crank, self.coupler, offset, ahead, angle);
                let still = LinkRotation { direction: [1.0, 0.0], first: 0.0, second: 0.0 };
                ([crank, rod, still], crank_pin, None)
            }
        };
        let [[_, _], [c3, s3], [c4, s4]] = links.map(|link| link.direction);
        let transmission = if fixed.is_some() { (c3 * s4 - s3 * c4).abs() } else { c3 };
        if transmission.is_nan() || transmission < MIN_TRANSMISSION {
            return None;
        }
        let coupler_pin = crank_pin.to(links[1], [self.coupler, 0.0]);
        let angles = links.map(|link| link.direction[1].atan2(link.direction[0]));
        Some(Pose {
            pins: [crank_pin.at, coupler_pin.at, fixed.unwrap_or(coupler_pin.at)],
            angles: [angle, angles[1], angles[2]],
            velocities: links.map(|link| link.first * speed),
            transmission,
            speed,
            links,
            starts: [PointMotion::fixed([0.0; 2]), crank_pin, fixed.map_or(coupler_pin, PointMotion::fixed)],
        })
    }

    /// Shaking force and moment, crank torque and kinetic energy at a place, gravity left out: the sums of
    /// d'Alembert's forces `−m a` and couples `−I α`, and the power `Σ m a·v + I α ω` over the speed of the crank.
    pub fn shaking(&self, pose: &Pose, counterweights: &[Counterweight]) -> Shaking {
        let speed = pose.speed;
        let square = speed * speed;
        let mut sum = Shaking::default();
        // Of each link the sum of d'Alembert's forces, and their moment about its first pin.
        let mut loads = [([0.0; 2], 0.0); 3];
        let mut add = |link: usize, mass: f64, distance: f64, angle: f64, inertia: f64| {
            let (start, turning) = (pose.starts[link], pose.links[link]);
            let (velocity, acceleration) = (turning.first * speed, turning.second * square);
            let along = [distance * angle.cos(), distance * angle.sin()];
            let PointMotion { at, first, second } = start.to(turning, along);
            let (v, a) = (first.map(|x| x * speed), second.map(|x| x * square));
            let force = [-mass * a[0], -mass * a[1]];
            sum.force[0] += force[0];
            sum.force[1] += force[1];
            sum.moment += at[0] * force[1] - at[1] * force[0] - inertia * acceleration;
            let power = inertia * acceleration * velocity - force[0] * v[0] - force[1] * v[1];
            sum.torque += power / speed;
            sum.energy += 0.5 * mass * (v[0] * v[0] + v[1] * v[1]) + 0.5 * inertia * velocity * velocity;
            sum.first_moment[0] += mass * at[0];
            sum.first_moment[1] += mass * at[1];
            let arm = [at[0] - start.at[0], at[1] - start.at[1]];
            let (load, moment) = &mut loads[link];
            *load = [load[0] + force[0], load[1] + force[1]];
            *moment += arm[0] * force[1] - arm[1] * force[0] - inertia * acceleration;
        };
        let mut add_link = |n, link: LinkInertia| add(n, link.mass, link.distance, link.offset, link.inertia);
        add_link(0, self.crank_link);
        add_link(1, self.coupler_link);
        match self.follower {
            Follower::Rocker { link, .. } => add_link(2, link),
            Follower::Slider { mass, .. } => {
                add_link(2, LinkInertia { mass, distance: 0.0, offset: 0.0, inertia: 0.0 });
            }
        }
        for c in counterweights {
            add(c.link, c.mass, c.distance, c.angle, 0.0);
        }
        sum.joints = self.joints(pose, loads);
        sum
    }

    /// The forces in the joints from the balance of each link, its loads given as force and moment about its first pin.
    fn joints(&self, pose: &Pose, loads: [([f64; 2], f64); 3]) -> [[f64; 2]; 4] {
        let [(on_crank, _), (on_coupler, of_coupler), (on_follower, of_follower)] = loads;
        let [_, e3, e4] = pose.links.map(|link| link.direction);
        let b = [self.coupler * e3[0], self.coupler * e3[1]];
        // P, of the coupler on the follower: b × P = M₃ about the crank pin, and what the follower asks for.
        let p = match self.follower {
            Follower::Rocker { length, .. } => {
                // c × P = −M₄ about the fixed pin.
                let c = [length * e4[0], length * e4[1]];
                let across = b[0] * c[1] - b[1] * c[0];
                let [left, right] = [of_coupler, -of_follower];
                [(c[0] * left - b[0] * right) / across, (c[1] * left - b[1] * right) / across]
            }
            Follower::Slider { .. } => {
                let along = -on_follower[0];
                [along, (of_coupler + b[1] * along) / b[0]]
            }
        };
        let of_crank = [p[0] - on_coupler[0], p[1] - on_coupler[1]];
        let of_frame = [of_crank[0] - on_crank[0], of_crank[1] - on_crank[1]];
        [of_frame, of_crank, p, [-p[0] - on_follower[0], -p[1] - on_follower[1]]]
    }
}
