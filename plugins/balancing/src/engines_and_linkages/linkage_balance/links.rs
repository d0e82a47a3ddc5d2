//! Newton's and Euler's equations of all links at once: the forces in the joints and the torque on the crank.

use dalembert_mechanics::balance::linkage::{Counterweight, Follower, LinkInertia, Linkage, Pose};
use dalembert_numerics::linalg;
use nalgebra::{DMatrix, DVector};

/// Forces and moments of the links in one position.
pub(super) struct FrameLoads {
    pub force: [f64; 2],
    pub moment: f64,
    pub torque: f64,
    /// In the order of [`dalembert_mechanics::balance::linkage::Shaking::joints`].
    pub joints: [[f64; 2]; 4],
    /// Amplification of rounding by the equations and by the accelerations in them.
    pub growth: f64,
}

/// A link with its counterweights, about its first pin.
#[derive(Clone, Copy, Default)]
struct Sums {
    mass: f64,
    /// First moment from the pin.
    first: [f64; 2],
    /// Moment of inertia about the pin.
    inertia: f64,
}

impl Sums {
    fn add(&mut self, link: LinkInertia, turned: f64) {
        let (sine, cosine) = (turned + link.offset).sin_cos();
        self.mass += link.mass;
        self.first[0] += link.mass * link.distance * cosine;
        self.first[1] += link.mass * link.distance * sine;
        self.inertia += link.inertia + link.mass * link.distance * link.distance;
    }
}

fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

/// Equations of motion in one position, the crank turning at a steady speed.
pub(super) fn frame_loads(
    linkage: &Linkage,
    pose: &Pose,
    counterweights: &[Counterweight],
    speed: f64,
) -> Option<FrameLoads> {
    let [pin, end, fixed] = pose.pins;
    let rod = [end[0] - pin[0], end[1] - pin[1]];
    let rocker = [end[0] - fixed[0], end[1] - fixed[1]];
    let mut sums = [Sums::default(); 3];
    sums[0].add(linkage.crank_link, pose.angles[0]);
    sums[1].add(linkage.coupler_link, pose.angles[1]);
    match linkage.follower {
        Follower::Rocker { link, .. } => sums[2].add(link, pose.angles[2]),
        Follower::Slider { mass, .. } => sums[2].mass += mass,
    }
    for c in counterweights {
        let link = LinkInertia { mass: c.mass, distance: c.distance, offset: c.angle, inertia: 0.0 };
        sums[c.link].add(link, pose.angles[c.link]);
    }
    // Velocities and accelerations that keep the loop closed.
    let is_slider = matches!(linkage.follower, Follower::Slider { .. });
    let turning = |known: [f64; 2]| -> [f64; 2] {
        if is_slider {
            return [-known[1] / rod[0], 0.0];
        }
        // known + x k × rod = y k × rocker.
        let across = cross(rod, rocker);
        [
            -(known[0] * rocker[0] + known[1] * rocker[1]) / across,
            -(known[0] * rod[0] + known[1] * rod[1]) / across,
        ]
    };
    let square = speed * speed;
    let [second, third] = turning([-speed * pin[1], speed * pin[0]]);
    let of_pin = [-square * pin[0], -square * pin[1]];
    let towards = |k: usize| of_pin[k] - second * second * rod[k] + third * third * rocker[k];
    let known =
        if is_slider { [0, 1].map(|k| of_pin[k] - second * second * rod[k]) } else { [0, 1].map(towards) };
    let [of_second, of_third] = turning(known);
    let of_end = [known[0] - of_second * rod[1], 0.0];

    // Unknown: the forces of the frame on the crank, of the crank on the coupler, of the coupler on the follower, of the
    // frame on the follower, and the torque over the length of the crank.
    let mut matrix = DMatrix::zeros(9, 9);
    let mut right = DVector::zeros(9);
    let length = linkage.crank;
    let motions = [
        ([0.0; 2], speed, 0.0, [Some(0), Some(1)]),
        (of_pin, second, of_second, [Some(1), Some(2)]),
        (if is_slider { of_end } else { [0.0; 2] }, third, of_third, [Some(2), None]),
    ];
    let arms = [pin, rod, rocker];
    for (link, (of_start, velocity, acceleration, [from, to])) in motions.into_iter().enumerate() {
        let Sums { mass, first, inertia } = sums[link];
        let row = 3 * link;
        for axis in 0..2 {
            if let Some(from) = from {
                matrix[(row + axis, 2 * from + axis)] = 1.0;
            }
            match to {
                Some(to) => matrix[(row + axis, 2 * to + axis)] = -1.0,
                None => matrix[(row + axis, 6 + axis)] = 1.0,
            }
            let across = if axis == 0 { -first[1] } else { first[0] };
            right[row + axis] =
                mass * of_start[axis] + acceleration * across - velocity * velocity * first[axis];
        }
        if link == 2 && is_slider {
            // A guide without friction.
            matrix[(row + 2, 6)] = 1.0;
            continue;
        }
        // Moments about the first pin: of the force at the second one, and of the torque on the crank.
        let (loaded, sign) = if link == 2 { (2, 1.0) } else { (link + 1, -1.0) };
        matrix[(row + 2, 2 * loaded)] = -sign * arms[link][1] / length;
        matrix[(row + 2, 2 * loaded + 1)] = sign * arms[link][0] / length;
        if link == 0 {
            matrix[(row + 2, 8)] = 1.0;
        }
        right[row + 2] = (inertia * acceleration + cross(first, of_start)) / length;
    }
    let solved = linalg::solve(&matrix, &right).ok()?;
    let x = &solved.x;
    let joints = [0, 1, 2, 3].map(|joint| [x[2 * joint], x[2 * joint + 1]]);
    let torque = x[8] * length;
    let force = [0, 1].map(|axis| -joints[0][axis] - joints[3][axis]);
    let moment = -(torque + cross(fixed, joints[3]));
    let growth = solved.condition / pose.transmission.powi(2);
    Some(FrameLoads { force, moment, torque, joints, growth })
}
