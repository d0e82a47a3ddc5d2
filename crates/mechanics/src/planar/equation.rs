//! Joints and drivers, and the scalar equations that they stand for.

use super::{BodyFrame, BodyPoint, GenevaWheel, Profile, RelativeCoordinate, TransmissionFunction};

/// A joint: a constraint between bodies.
#[derive(Debug, Clone, PartialEq)]
pub enum PlanarJoint {
    /// A revolute joint: two points stay together.
    Pin {
        /// A point.
        a: BodyPoint,
        /// The point that is pinned to it.
        b: BodyPoint,
    },
    /// A prismatic joint: a point stays on a line of another body and the bodies keep their angle.
    Slider {
        /// A point of the line.
        guide: BodyPoint,
        /// Direction of the line in the axes of its body, rad.
        direction: f64,
        /// The point that slides.
        slides: BodyPoint,
        /// The angle of the sliding body against the guide, rad.
        angle: f64,
    },
    /// A pin in a straight slot: a point stays at a distance to the left of a line of another body.
    Slot {
        /// A point of the line.
        guide: BodyPoint,
        /// Direction of the line in the axes of its body, rad.
        direction: f64,
        /// The pin.
        pin: BodyPoint,
        /// Distance to the left of the line, m.
        offset: f64,
    },
    /// Two bodies are one: their points stay together and they keep their angle.
    Weld {
        /// A point.
        a: BodyPoint,
        /// The point that is fixed to it.
        b: BodyPoint,
        /// The angle of the second body against the first, rad.
        angle: f64,
    },
    /// A massless rod with a pin at each end.
    Rod {
        /// One end.
        from: BodyPoint,
        /// The other end.
        to: BodyPoint,
        /// The length, m.
        length: f64,
    },
    /// A pair of gears: `Nₐ(θₐ − θ_c) ± N_b(θ_b − θ_c)` does not change.
    Gears {
        /// A gear.
        a: BodyFrame,
        /// The gear that it meshes with.
        b: BodyFrame,
        /// The body that carries both.
        carrier: BodyFrame,
        /// Teeth or pitch radii of the two.
        sizes: [f64; 2],
        /// True if the second has its teeth inside.
        internal: bool,
    },
    /// Rack and pinion, or a wheel that rolls on a line without slip: the distance along the line and the rolled arc
    /// differ by a constant, that of the initial guess.
    Rack {
        /// A point of the pitch line.
        guide: BodyPoint,
        /// Direction of the line in the axes of its body, rad.
        direction: f64,
        /// The centre of the wheel.
        centre: BodyPoint,
        /// Pitch radius, m; positive with the centre to the left of the line.
        radius: f64,
    },
    /// A cord of constant length over small pulleys, wound on drums: `Σ|B − A| + Σ r (θ_of − θ_against)` does not
    /// change. It is taut in the initial guess.
    Cord {
        /// The straight runs.
        runs: Vec<[BodyPoint; 2]>,
        /// The drums: body, the body that carries it, and the radius with which a positive turn takes cord up, m.
        drums: Vec<(BodyFrame, BodyFrame, f64)>,
    },
    /// A weighted sum of measures keeps its value, or the one that it has in the initial guess: screws, belts and every
    /// other linear relation.
    Relation {
        /// The weights and measures.
        terms: Vec<(f64, RelativeCoordinate)>,
        /// The constant value of their sum; that of the initial guess if none.
        constant: Option<f64>,
    },
    /// A cam: one measure follows another by a table.
    Cam {
        /// The measure that follows.
        follower: RelativeCoordinate,
        /// The measure that leads.
        cam: RelativeCoordinate,
        /// The value of the follower for each value of the leader.
        profile: Profile,
    },
    /// A Geneva drive: the pin of a driver turns a slotted wheel, which is locked between two engagements. The drawn
    /// angle of the wheel is kept.
    Geneva {
        /// The body with the pin.
        driver: BodyFrame,
        /// The slotted wheel.
        wheel: BodyFrame,
        /// The body that carries both.
        carrier: BodyFrame,
        /// The slots and the place of the pin.
        geometry: GenevaWheel,
    },
}

/// A driver: a measure whose value, velocity and acceleration are given.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Driver {
    /// The relative coordinate that is driven.
    pub measure: RelativeCoordinate,
    /// The value, m or rad.
    pub value: f64,
    /// The velocity, m/s or rad/s.
    pub velocity: f64,
    /// The acceleration, m/s² or rad/s².
    pub acceleration: f64,
}

/// A part of an [`Equation`].
#[derive(Debug, Clone, PartialEq)]
pub struct ConstraintTerm {
    /// The factor of the measure or of its function.
    pub weight: f64,
    /// The relative coordinate.
    pub measure: RelativeCoordinate,
    /// The function that the measure goes through.
    pub function: Option<TransmissionFunction>,
}

/// A scalar constraint equation `Σ weight · f(measure) = constant`.
#[derive(Debug, Clone, PartialEq)]
pub struct Equation {
    /// The parts of its left side.
    pub terms: Vec<ConstraintTerm>,
    /// The constant term, m or rad; the left side in the initial guess if none.
    pub constant: Option<f64>,
}

impl Equation {
    /// The equation of a measure that keeps a value.
    pub fn of(measure: RelativeCoordinate, constant: Option<f64>) -> Self {
        Self { terms: vec![ConstraintTerm { weight: 1.0, measure, function: None }], constant }
    }

    fn weighted(terms: impl IntoIterator<Item = (f64, RelativeCoordinate)>, constant: Option<f64>) -> Self {
        let terms =
            terms.into_iter().map(|(weight, measure)| ConstraintTerm { weight, measure, function: None });
        Self { terms: terms.collect(), constant }
    }
}

impl PlanarJoint {
    /// The constraint equations of the joint. The multipliers of a pin or weld are the components of the force on its
    /// second point; those of a slider or slot the force across the line, to its left, on the point.
    pub fn equations(&self) -> Vec<Equation> {
        let meet = |a: BodyPoint, b: BodyPoint| {
            [[1.0, 0.0], [0.0, 1.0]].map(|direction| {
                Equation::of(RelativeCoordinate::Component { direction, from: a, to: b }, Some(0.0))
            })
        };
        // A direction of the ground does not turn.
        let along = |direction: [f64; 2], from: BodyPoint, to: BodyPoint| match from.on {
            Some(_) => RelativeCoordinate::Along { direction, from, to },
            None => RelativeCoordinate::Component { direction, from, to },
        };
        let left_of = |guide: BodyPoint, direction: f64, point: BodyPoint, offset: f64| {
            Equation::of(along([-direction.sin(), direction.cos()], guide, point), Some(offset))
        };
        let angle = |of: BodyFrame, against: BodyFrame| RelativeCoordinate::Angle { of, against };
        match self {
            &PlanarJoint::Pin { a, b } => meet(a, b).into(),
            &PlanarJoint::Slider { guide, direction, slides, angle: kept } => vec![
                left_of(guide, direction, slides, 0.0),
                Equation::of(angle(slides.on, guide.on), Some(kept)),
            ],
            &PlanarJoint::Slot { guide, direction, pin, offset } => {
                vec![left_of(guide, direction, pin, offset)]
            }
            &PlanarJoint::Weld { a, b, angle: kept } => {
                let [x, y] = meet(a, b);
                vec![x, y, Equation::of(angle(b.on, a.on), Some(kept))]
            }
            &PlanarJoint::Rod { from, to, length } => {
                vec![Equation::of(RelativeCoordinate::Distance { from, to }, Some(length))]
            }
            &PlanarJoint::Gears { a, b, carrier, sizes: [of_a, of_b], internal } => {
                let of_b = if internal { -of_b } else { of_b };
                vec![Equation::weighted([(of_a, angle(a, carrier)), (of_b, angle(b, carrier))], None)]
            }
            &PlanarJoint::Rack { guide, direction, centre, radius } => {
                let along = along([direction.cos(), direction.sin()], guide, centre);
                vec![Equation::weighted([(1.0, along), (radius, angle(centre.on, guide.on))], None)]
            }
            PlanarJoint::Cord { runs, drums } => {
                let runs = runs.iter().map(|&[from, to]| (1.0, RelativeCoordinate::Distance { from, to }));
                let drums = drums.iter().map(|&(of, against, radius)| (radius, angle(of, against)));
                vec![Equation::weighted(runs.chain(drums), None)]
            }
            PlanarJoint::Relation { terms, constant } => {
                vec![Equation::weighted(terms.iter().copied(), *constant)]
            }
            PlanarJoint::Cam { follower, cam, profile } => {
                let terms = vec![
                    ConstraintTerm { weight: 1.0, measure: *follower, function: None },
                    ConstraintTerm {
                        weight: -1.0,
                        measure: *cam,
                        function: Some(TransmissionFunction::Profile(profile.clone())),
                    },
                ];
                vec![Equation { terms, constant: Some(0.0) }]
            }
            &PlanarJoint::Geneva { driver, wheel, carrier, geometry } => {
                let terms = vec![
                    ConstraintTerm { weight: 1.0, measure: angle(wheel, carrier), function: None },
                    ConstraintTerm {
                        weight: -1.0,
                        measure: angle(driver, carrier),
                        function: Some(TransmissionFunction::Geneva(geometry)),
                    },
                ];
                vec![Equation { terms, constant: None }]
            }
        }
    }
}
