//! Supports as a user describes them, and the unknowns that they bring into the six equations.

use dalembert_core::{
    Inputs, Refusal, TableExhibit, Text, Worksheet,
    exhibit::{Cell, Column},
};
use dalembert_mechanics::{
    Real, Vector,
    rigid::{
        Axis,
        chain::ChainFrame,
        supports::{ReactionUnknown, SupportError, Supports, Wrench},
    },
};
use nalgebra::Vector3;

use super::{Found, Reactions};
use crate::shared::joints::{Named, given_name, seen_from};

/// A support of the body.
#[derive(Clone, Debug, Inputs)]
pub struct Support {
    /// Name.
    pub name: String,
    /// Point.
    /// From the origin of the axes of the supports.
    #[input("r_s", "m")]
    pub at: Vector3<f64>,
    /// Kind of support.
    pub kind: SupportKind,
}

/// Constraint of a support.
#[derive(Clone, Debug, Inputs)]
pub enum SupportKind {
    /// Bearing
    /// Two forces normal to the shaft.
    Bearing {
        /// Direction of the shaft.
        #[input("a_B", "1")]
        shaft: Vector3<f64>,
    },
    /// Bearing that also carries the axial force
    /// Three forces.
    ThrustBearing,
    /// Ball-and-socket
    /// Three forces.
    BallAndSocket,
    /// Clevis
    /// Three forces, and couples normal to its pin.
    Clevis {
        /// Direction of the pin.
        #[input("a_P", "1")]
        pin: Vector3<f64>,
    },
    /// Weld
    /// Three forces and three couples.
    Weld,
    /// Wire, cable or rod with a joint at each end
    /// One force along it.
    Wire {
        /// Direction from the body along the wire.
        #[input("a_W", "1")]
        direction: Vector3<f64>,
    },
    /// Contact with a plane, smooth or sliding
    /// One force, tilted from the normal by the friction.
    Contact {
        /// Normal of the plane, towards the body.
        #[input("n", "1")]
        normal: Vector3<f64>,
        /// Coefficient of friction.
        #[input("µ", "1", nonnegative, default = "0")]
        friction: f64,
        /// Direction in which the body slides.
        /// No effect without friction.
        #[input("s", "1", default = "(0; 0; 0)")]
        sliding: Vector3<f64>,
    },
    /// Contact with a plane, without sliding
    /// Three forces; the required friction is calculated.
    RoughContact {
        /// Normal of the plane, towards the body.
        #[input("n", "1")]
        normal: Vector3<f64>,
    },
    /// Couple about a direction
    /// A drive or a key that lets the point move.
    Couple {
        /// Direction.
        #[input("a_C", "1")]
        about: Vector3<f64>,
    },
}

impl Support {
    /// Unknown reactions of the support.
    fn unknowns(&self) -> Result<Vec<ReactionUnknown>, Refusal> {
        let force = |along: Vector3<f64>| ReactionUnknown::Force { at: self.at, along };
        let forces = || [Vector3::x(), Vector3::y(), Vector3::z()].map(force).to_vec();
        let couple = |about: Vector3<f64>| ReactionUnknown::Couple { about };
        Ok(match self.kind {
            SupportKind::Bearing { shaft } => across(self.unit(shaft)?).map(force).to_vec(),
            SupportKind::ThrustBearing | SupportKind::BallAndSocket => forces(),
            SupportKind::Clevis { pin } => {
                let mut all = forces();
                all.extend(across(self.unit(pin)?).map(couple));
                all
            }
            SupportKind::Weld => {
                let mut all = forces();
                all.extend([Vector3::x(), Vector3::y(), Vector3::z()].map(couple));
                all
            }
            SupportKind::Wire { direction } => vec![force(self.unit(direction)?)],
            SupportKind::Contact { normal, friction, sliding } => {
                let normal = self.unit(normal)?;
                if friction == 0.0 {
                    return Ok(vec![force(normal)]);
                }
                let along = sliding - normal * normal.dot(sliding);
                vec![force(normal - self.unit(along)? * friction)]
            }
            SupportKind::RoughContact { normal } => {
                self.unit(normal)?;
                forces()
            }
            SupportKind::Couple { about } => vec![couple(self.unit(about)?)],
        })
    }

    fn unit(&self, direction: Vector3<f64>) -> Result<Vector3<f64>, Refusal> {
        let largest = direction.amax();
        if largest > 0.0 && direction.iter().all(|x| x.is_finite()) {
            return Ok((direction / largest).normalize());
        }
        Err(Refusal::NoAnswer(
            Text::new("a direction of the support {name} has no length: write any vector along it, such as (1; 0; 0)")
                .with("name", &self.name),
        ))
    }
}

/// Two unit vectors across a unit vector, along axes of the frame where it lies along one of them.
fn across(axis: Vector3<f64>) -> [Vector3<f64>; 2] {
    let near = if axis.z.abs() > 0.7 { Vector3::x() } else { Vector3::z() };
    let first = (near - axis * axis.dot(near)).normalize();
    [axis.cross(first), first]
}

/// The supports with their unknowns, ready for any load.
pub(super) struct Held<'a> {
    all: &'a [Support],
    /// To which support each unknown belongs.
    owners: Vec<usize>,
    alone: Supports,
    /// With the couple of the drive about the last axis, where the supports leave that turn free.
    driven: Option<Supports>,
}

impl<'a> Held<'a> {
    /// Counts the unknowns.
    pub(super) fn new(problem: &'a Reactions, frames: &[ChainFrame]) -> Result<Self, Refusal> {
        let all = &problem.supports;
        let (mut unknowns, mut owners) = (Vec::new(), Vec::new());
        for (n, support) in all.iter().enumerate() {
            let own = support.unknowns()?;
            owners.extend(own.iter().map(|_| n));
            unknowns.extend(own);
        }
        let last = frames.len() - 1;
        let axis = problem.joints[last - 1].axis;
        // The frames have been found sound: the axis has a length.
        let axis = frames[last].rotation * (axis / axis.amax()).normalize();
        let axis = seen_from(&frames[problem.axes.place()], axis);
        let alone = Supports::new(unknowns.clone()).map_err(|error| refused(&error, all, &owners))?;
        let driven = if alone.hold_against(axis) {
            None
        } else {
            unknowns.push(ReactionUnknown::Couple { about: axis });
            Some(Supports::new(unknowns).map_err(|error| refused(&error, all, &owners))?)
        };
        Ok(Self { all, owners, alone, driven })
    }

    /// Returns true if the supports hold the body against rotation about the axis of the last joint.
    pub(super) fn against_the_drive(&self) -> bool {
        self.driven.is_none()
    }

    /// Force of each support, with its moment about the origin, and the couple of the drive where it is unknown.
    pub(super) fn reactions(
        &self,
        known: &Wrench,
        with_drive: bool,
    ) -> Result<(Vec<Wrench>, Option<f64>), Refusal> {
        let equations = self.driven.as_ref().filter(|_| with_drive).unwrap_or(&self.alone);
        let x = equations.reactions(known).map_err(|error| refused(&error, self.all, &self.owners))?;
        let mut supports = vec![Wrench::zero(); self.all.len()];
        for ((unknown, x), owner) in equations.unknowns().iter().zip(&x).zip(&self.owners) {
            let one = unknown.wrench();
            supports[*owner] = supports[*owner] + Wrench { force: one.force * *x, moment: one.moment * *x };
        }
        Ok((supports, x.get(self.owners.len()).copied()))
    }

    /// Returns true if a support exerts couples.
    pub(super) fn has_couples(&self, n: usize) -> bool {
        matches!(
            self.all[n].kind,
            SupportKind::Clevis { .. } | SupportKind::Weld | SupportKind::Couple { .. }
        )
    }

    /// The largest distance of a support from the origin, m.
    pub(super) fn length(&self) -> f64 {
        self.all.iter().map(|support| support.at.norm()).fold(0.0, f64::max)
    }

    /// Tension of a wire, normal force and friction of a contact.
    pub(super) fn own_numbers<W: Worksheet>(
        &self,
        n: usize,
        of: &Wrench,
        reaction: W::Vec,
        given: &SupportGiven<W>,
        common_errors: &[(&'static str, Vector3<f64>)],
        sheet: W,
    ) {
        let name = &self.all[n].name;
        let errors_along = |symbol: &'static str, along: W::Vec| {
            for &(what, force) in common_errors {
                let share = force.dot(along.value()) / of.force.dot(along.value());
                let wrong = || reaction.dot(along) / along.magnitude() * share;
                sheet.common_error((symbol, n + 1), what, wrong);
            }
        };
        match given.kind {
            SupportKindGiven::Wire { direction } => {
                errors_along("S", direction);
                let tension = sheet.step(
                    ("S", n + 1),
                    "N",
                    reaction.dot(direction) / direction.magnitude(),
                    Named("Tension of {name}", name, None),
                );
                sheet.answer(("tension", n + 1), "Tension", tension);
                sheet.row_label(("tension", n + 1), name);
                sheet.verify(|| {
                    let what = Text::new("the whole reaction of {name} acts along it").with("name", name);
                    sheet.check_vector(what, direction * tension, reaction * direction.magnitude());
                });
            }
            SupportKindGiven::Contact { normal, .. } | SupportKindGiven::RoughContact { normal } => {
                errors_along("N", normal);
                let force = sheet.step(
                    ("N", n + 1),
                    "N",
                    reaction.dot(normal) / normal.magnitude(),
                    Named("Normal force of {name}", name, None),
                );
                sheet.answer(("normal_force", n + 1), "Normal force", force);
                sheet.row_label(("normal_force", n + 1), name);
                if let SupportKindGiven::Contact { friction, .. } = given.kind {
                    sheet.check_sum(
                        Text::new("normal force and friction make up the reaction of {name}")
                            .with("name", name),
                        force.powi(2) * (friction.powi(2) + 1.0),
                        reaction.dot(reaction),
                        of.force.norm_squared(),
                    );
                }
                let rough = matches!(given.kind, SupportKindGiven::RoughContact { .. });
                if rough && force.value() > 1e-12 * of.force.norm() {
                    let along = sheet.step(
                        ("F_f", n + 1),
                        "N",
                        normal.cross(reaction).magnitude() / normal.magnitude(),
                        Named("Friction force of {name}", name, None),
                    );
                    let needed = sheet.step(
                        ("µ", n + 1),
                        "1",
                        along / force,
                        Named("Coefficient of friction required to keep {name} from sliding", name, None),
                    );
                    sheet.answer(("friction_needed", n + 1), "Required coefficient of friction", needed);
                    sheet.row_label(("friction_needed", n + 1), name);
                }
            }
            _ => {}
        }
    }

    /// Warns of wires that would push, contacts that would pull, and motions that nothing holds.
    pub(super) fn warn<W: Worksheet>(&self, problem: &Reactions, found: &[Wrench], sheet: W) {
        for (support, of) in problem.supports.iter().zip(found) {
            let (direction, words) = match support.kind {
                SupportKind::Wire { direction } => {
                    (direction, "the wire {name} would have to push: it goes slack and the motion changes")
                }
                SupportKind::Contact { normal, .. } | SupportKind::RoughContact { normal } => {
                    (normal, "the contact {name} would have to pull: contact is lost and the motion changes")
                }
                _ => continue,
            };
            if of.force.dot(direction) < -1e-12 * of.force.norm() * direction.norm() {
                sheet.warn(|| Text::new(words).with("name", &support.name));
            }
        }
        let equations = self.driven.as_ref().unwrap_or(&self.alone);
        if equations.degrees_of_freedom() > 0 {
            let count = u32::try_from(equations.degrees_of_freedom()).unwrap_or(6);
            sheet.warn(|| {
                Text::new("the supports leave {count} of the six motions free: no load does work in them now, but nothing restrains the body there")
                    .with("count", count)
            });
        }
    }

    /// Support reactions.
    pub(super) fn table(&self, problem: &Reactions, found: &Found) -> TableExhibit {
        let number = |heading: &'static str, unit: &'static str| Column { heading: heading.into(), unit };
        let mut columns = vec![
            Column { heading: "Support".into(), unit: "" },
            number("Rₓ", "N"),
            number("R_y", "N"),
            number("R_z", "N"),
        ];
        let couples = (0..self.all.len()).any(|n| self.has_couples(n));
        if couples {
            columns.extend([number("Cₓ", "N*m"), number("C_y", "N*m"), number("C_z", "N*m")]);
        }
        let largest = found.supports.iter().map(|of| of.force.amax()).fold(0.0f64, f64::max);
        let clean = |x: f64, size: f64| Cell::Number(if x.abs() > 1e-13 * size { x } else { 0.0 });
        let row = |(n, (support, of)): (usize, (&Support, &Wrench))| {
            let mut row = vec![Cell::Text(given_name(&support.name))];
            row.extend(of.force.iter().map(|x| clean(*x, largest)));
            if couples {
                let own = of.moment_about(support.at);
                row.extend(
                    own.iter()
                        .map(|x| if self.has_couples(n) { clean(*x, of.moment.amax()) } else { Cell::Empty }),
                );
            }
            row
        };
        TableExhibit {
            title: "Support reactions".into(),
            columns,
            rows: problem.supports.iter().zip(&found.supports).enumerate().map(row).collect(),
            foot: Vec::new(),
        }
    }
}

/// Common errors in a reaction, in words, and the force that each gives: from its part at rest, and from the reaction
/// without the inertia couple.
pub(super) fn common_errors(
    reaction: Vector3<f64>,
    at_rest: Option<Vector3<f64>>,
    without_couple: Option<Vector3<f64>>,
) -> Vec<(&'static str, Vector3<f64>)> {
    let mut common_errors = Vec::new();
    if let Some(at_rest) = at_rest {
        common_errors.push(("dynamic part alone taken, without weight and loads", reaction - at_rest));
        common_errors.push(("static part alone taken, without inertia force and couple", at_rest));
    }
    if let Some(force) = without_couple {
        common_errors.push(("inertia couple omitted: the inertia force at G alone considered", force));
    }
    if let (Some(at_rest), Some(_)) = (at_rest, without_couple) {
        let what = "inertia force and couple applied in the sense of the acceleration";
        common_errors.push((what, at_rest * 2.0 - reaction));
    }
    common_errors
}

/// Message for reactions that the six equations do not determine, in the words of the form.
fn refused(error: &SupportError, all: &[Support], owners: &[usize]) -> Refusal {
    let text = match error {
        SupportError::Indeterminate { missing, unknowns } => {
            let mut named: Vec<&str> =
                unknowns.iter().filter_map(|x| owners.get(*x)).map(|n| all[*n].name.as_str()).collect();
            named.dedup();
            let count = |n: usize| u32::try_from(n).unwrap_or(u32::MAX);
            Text::new("the supports are statically indeterminate: {count} of their {unknowns} unknowns are too many for the six equations, and {names} can strain one another without any load; release one of them, such as one axial force or one couple")
                .with("count", count(*missing))
                .with("unknowns", count(owners.len()))
                .with("names", named.join(", "))
        }
        SupportError::Mechanism { turning, axis } => {
            let words = if *turning {
                "the supports leave the body free to turn about {axis}, and this motion with these loads requires a moment there: add a support or a drive, or let the acceleration be calculated"
            } else {
                "the supports leave the body free to move along {axis}, and this motion with these loads requires a force there: add a support that resists it"
            };
            Text::new(words).with(
                "axis",
                match axis {
                    Axis::X => "x",
                    Axis::Y => "y",
                    Axis::Z => "z",
                },
            )
        }
        SupportError::Data(_) => {
            Text::from("the positions or the loads exceed the numerical range: check their units")
        }
    };
    Refusal::NoAnswer(text)
}
