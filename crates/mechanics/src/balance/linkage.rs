//! Force balance of planar linkages with one crank at a steady speed: four-bar and slider-crank.
//!
//! Points are `[x, y]` in metres, with the crank pivot at the origin.

/// A rigid link: its mass, where its centre is, and its moment of inertia about it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Link {
    /// Mass, kg.
    pub mass: f64,
    /// Distance of the centre of mass from the first pin of the link, m.
    pub distance: f64,
    /// Angle of the centre from the line to the second pin, rad.
    pub offset: f64,
    /// Moment of inertia about the centre, kg·m².
    pub inertia: f64,
}

/// What closes the loop after crank and coupler.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Follower {
    /// A rocker that turns about a pin on the x axis.
    Rocker {
        /// Distance of the fixed pins, m.
        frame: f64,
        /// Length of the rocker, m.
        length: f64,
        /// Whether the linkage is put together with the pins of coupler and rocker below the frame.
        crossed: bool,
        /// The rocker itself; its first pin is the fixed one.
        link: Link,
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
    pub crank_link: Link,
    /// The coupler; its first pin is that of the crank.
    pub coupler_link: Link,
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
    /// Their angular accelerations, rad/s².
    pub accelerations: [f64; 3],
    /// How well the loop determines the place: the sine of the transmission angle for a four-bar, the cosine of the
    /// coupler's angle for a slider; 0 at a dead point.
    pub transmission: f64,
}

/// What the frame feels, and what turns the crank.
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

fn unit(angle: f64) -> [f64; 2] {
    [angle.cos(), angle.sin()]
}

/// A point of a moving plane: place, velocity and acceleration.
#[derive(Clone, Copy)]
struct Moving {
    at: [f64; 2],
    velocity: [f64; 2],
    acceleration: [f64; 2],
}

impl Moving {
    const FIXED: Moving = Moving { at: [0.0; 2], velocity: [0.0; 2], acceleration: [0.0; 2] };

    /// The point of a link at a distance and an angle of the plane from this one.
    fn to(self, distance: f64, angle: f64, velocity: f64, acceleration: f64) -> Moving {
        let [c, s] = unit(angle);
        let [x, y] = [distance * c, distance * s];
        Moving {
            at: [self.at[0] + x, self.at[1] + y],
            velocity: [self.velocity[0] - velocity * y, self.velocity[1] + velocity * x],
            acceleration: [
                self.acceleration[0] - acceleration * y - velocity * velocity * x,
                self.acceleration[1] + acceleration * x - velocity * velocity * y,
            ],
        }
    }
}

impl Linkage {
    /// The place at a crank angle, and how it moves at a steady speed of the crank; `None` where the loop does not
    /// close, or only at a dead point.
    pub fn pose(&self, angle: f64, speed: f64) -> Option<Pose> {
        let (a, b) = (self.crank, self.coupler);
        let crank = Moving::FIXED.to(a, angle, speed, 0.0);
        let [x, y] = crank.at;
        match self.follower {
            Follower::Rocker { frame, length: c, crossed, .. } => {
                // The coupler pin is where circles about the crank pin and the fixed pin meet.
                let (dx, dy) = (frame - x, -y);
                let distance = dx.hypot(dy);
                let along = (b * b - c * c + distance * distance) / (2.0 * distance);
                let height = b * b - along * along;
                if height.is_nan() || height <= 0.0 || distance == 0.0 {
                    return None;
                }
                let height = if crossed { -height.sqrt() } else { height.sqrt() };
                let pin =
                    [x + (along * dx - height * dy) / distance, y + (along * dy + height * dx) / distance];
                let coupler = (pin[1] - y).atan2(pin[0] - x);
                let rocker = pin[1].atan2(pin[0] - frame);
                let sine = (rocker - coupler).sin();
                if sine.abs() < 1e-9 {
                    return None;
                }
                let in_coupler = a * speed * (angle - rocker).sin() / (b * (rocker - coupler).sin());
                let in_rocker = a * speed * (angle - coupler).sin() / (c * (rocker - coupler).sin());
                // a ω₂² e₂ + b ω₃² e₃ − c ω₄² e₄ along e₄ and e₃.
                let centripetal = |direction: f64| {
                    a * speed * speed * (angle - direction).cos()
                        + b * in_coupler * in_coupler * (coupler - direction).cos()
                        - c * in_rocker * in_rocker * (rocker - direction).cos()
                };
                Some(Pose {
                    pins: [crank.at, pin, [frame, 0.0]],
                    angles: [angle, coupler, rocker],
                    velocities: [speed, in_coupler, in_rocker],
                    accelerations: [
                        0.0,
                        centripetal(rocker) / (b * (rocker - coupler).sin()),
                        centripetal(coupler) / (c * (rocker - coupler).sin()),
                    ],
                    transmission: sine.abs(),
                })
            }
            Follower::Slider { offset, .. } => {
                let sine = (offset - y) / b;
                if sine.is_nan() || sine.abs() >= 1.0 {
                    return None;
                }
                let coupler = sine.asin();
                let cosine = coupler.cos();
                let in_coupler = -a * speed * angle.cos() / (b * cosine);
                let acceleration =
                    (a * speed * speed * angle.sin() + b * in_coupler * in_coupler * sine) / (b * cosine);
                let pin = [x + b * cosine, offset];
                Some(Pose {
                    pins: [crank.at, pin, pin],
                    angles: [angle, coupler, 0.0],
                    velocities: [speed, in_coupler, 0.0],
                    accelerations: [0.0, acceleration, 0.0],
                    transmission: cosine,
                })
            }
        }
    }

    /// Shaking force and moment, crank torque and kinetic energy at a place, gravity left out: the sums of
    /// d'Alembert's forces `−m a` and couples `−I α`, and the power `Σ m a·v + I α ω` over the speed of the crank.
    pub fn shaking(&self, pose: &Pose, counterweights: &[Counterweight]) -> Shaking {
        let crank_pin = Moving::FIXED.to(self.crank, pose.angles[0], pose.velocities[0], 0.0);
        let coupler_pin =
            crank_pin.to(self.coupler, pose.angles[1], pose.velocities[1], pose.accelerations[1]);
        let start = |link: usize| match (link, self.follower) {
            (0, _) => Moving::FIXED,
            (1, _) => crank_pin,
            (_, Follower::Rocker { frame, .. }) => Moving { at: [frame, 0.0], ..Moving::FIXED },
            (_, Follower::Slider { .. }) => coupler_pin,
        };
        let mut sum = Shaking::default();
        // Of each link the sum of d'Alembert's forces, and their moment about its first pin.
        let mut loads = [([0.0; 2], 0.0); 3];
        let mut add = |link: usize, mass: f64, distance: f64, angle: f64, inertia: f64| {
            let (velocity, acceleration) = (pose.velocities[link], pose.accelerations[link]);
            let centre = start(link).to(distance, pose.angles[link] + angle, velocity, acceleration);
            let Moving { at, velocity: v, acceleration: a } = centre;
            let force = [-mass * a[0], -mass * a[1]];
            sum.force[0] += force[0];
            sum.force[1] += force[1];
            sum.moment += at[0] * force[1] - at[1] * force[0] - inertia * acceleration;
            let power = inertia * acceleration * velocity - force[0] * v[0] - force[1] * v[1];
            sum.torque += power / pose.velocities[0];
            sum.energy += 0.5 * mass * (v[0] * v[0] + v[1] * v[1]) + 0.5 * inertia * velocity * velocity;
            sum.first_moment[0] += mass * at[0];
            sum.first_moment[1] += mass * at[1];
            let arm = [at[0] - start(link).at[0], at[1] - start(link).at[1]];
            let (load, moment) = &mut loads[link];
            *load = [load[0] + force[0], load[1] + force[1]];
            *moment += arm[0] * force[1] - arm[1] * force[0] - inertia * acceleration;
        };
        let mut add_link = |n, link: Link| add(n, link.mass, link.distance, link.offset, link.inertia);
        add_link(0, self.crank_link);
        add_link(1, self.coupler_link);
        match self.follower {
            Follower::Rocker { link, .. } => add_link(2, link),
            Follower::Slider { mass, .. } => {
                add_link(2, Link { mass, distance: 0.0, offset: 0.0, inertia: 0.0 });
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
        let [_, e3, e4] = pose.angles.map(unit);
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
