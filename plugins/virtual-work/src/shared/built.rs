//! Plane mechanisms put together from their lengths: the second method to every effort of a template, the way to its
//! reactions, and the pictures of bars, pins, blocks and forces.

use std::{cell::OnceCell, f64::consts::TAU};

use dalembert_core::{
    Axis, Cell, Column, Exhibit, FieldPath, Inputs, Lift, Plain, Plot, Refusal, Series, Sketch, Stop,
    TableExhibit, Text, Worksheet, exhibit::Point as At,
};
use dalembert_mechanics::{
    Real,
    planar::{
        BodyFrame, BodyPoint, Driver, Effort, InverseDynamics, LoadId, Model, PlanarBody, PlanarError,
        PlanarJoint, PlanarLoad, PlanarMechanism, PlanarState, RelativeCoordinate,
    },
};

use crate::shared::parts::closure::rotation_sizes;

/// A mechanism while it is put together. Names are for its table of works.
#[derive(Clone, Default)]
pub(crate) struct Built {
    mechanism: PlanarMechanism,
    drawn: Vec<[f64; 3]>,
    links: Vec<&'static str>,
    centres: Vec<[f64; 2]>,
    loads: Vec<&'static str>,
}

/// A link; its own axes start at its first pin, and x goes along the line of its pins.
#[derive(Clone, Copy)]
pub(crate) struct Link {
    body: usize,
    centre: [f64; 2],
}

/// The mass of a link, with its centre in the axes of the link; SI.
#[derive(Clone, Copy, Default)]
pub(crate) struct BuiltMass {
    pub(crate) mass: f64,
    pub(crate) centre: [f64; 2],
    pub(crate) inertia: f64,
}

/// A mechanism that closes, with its motion and its efforts.
pub(crate) struct Solved {
    system: Model,
    pub(crate) state: PlanarState,
    pub(crate) dynamics: InverseDynamics,
    links: Vec<&'static str>,
    centres: Vec<[f64; 2]>,
    loads: Vec<&'static str>,
}

impl Link {
    /// A point of the link, in the axes of the link.
    pub(crate) fn point(&self, at: [f64; 2]) -> BodyPoint {
        BodyPoint::body(self.body, [at[0] - self.centre[0], at[1] - self.centre[1]])
    }

    /// The link as the body that joints and measures name.
    #[expect(clippy::unnecessary_wraps, reason = "what they name may be the ground")]
    pub(crate) fn frame(&self) -> BodyFrame {
        Some(self.body)
    }
}

impl BuiltMass {
    /// A mass at the first pin.
    pub(crate) fn at_pin(mass: f64) -> Self {
        Self { mass, ..Self::default() }
    }
}

impl Built {
    /// No links yet, in a field of gravity.
    pub(crate) fn new(gravity: [f64; 2]) -> Self {
        Self { mechanism: PlanarMechanism { gravity, ..PlanarMechanism::default() }, ..Self::default() }
    }

    /// A link whose first pin is about at `start` and whose x axis makes about that angle with the ground's.
    pub(crate) fn link(&mut self, name: &'static str, start: [f64; 2], angle: f64, mass: BuiltMass) -> Link {
        let [x, y] = turned(mass.centre, angle);
        self.mechanism.bodies.push(PlanarBody { mass: mass.mass, inertia: mass.inertia });
        self.drawn.push([start[0] + x, start[1] + y, angle]);
        self.links.push(name);
        self.centres.push(mass.centre);
        Link { body: self.drawn.len() - 1, centre: mass.centre }
    }

    /// A joint; its number.
    pub(crate) fn join(&mut self, joint: PlanarJoint) -> usize {
        self.mechanism.joints.push(joint);
        self.mechanism.joints.len() - 1
    }

    /// A pin; its number.
    pub(crate) fn pin(&mut self, a: BodyPoint, b: BodyPoint) -> usize {
        self.join(PlanarJoint::Pin { a, b })
    }

    /// A driven measure: value, velocity, acceleration.
    pub(crate) fn drive(&mut self, measure: RelativeCoordinate, [value, velocity, acceleration]: [f64; 3]) {
        self.mechanism.drivers.push(Driver { measure, value, velocity, acceleration });
    }

    /// A driven link: angle, angular velocity, angular acceleration.
    pub(crate) fn turn(&mut self, link: Link, motion: [f64; 3]) {
        self.drive(RelativeCoordinate::Angle { of: link.frame(), against: None }, motion);
    }

    /// A load.
    pub(crate) fn load(&mut self, name: &'static str, load: PlanarLoad) {
        self.mechanism.loads.push(load);
        self.loads.push(name);
    }

    /// A force in the axes of the ground.
    pub(crate) fn force(&mut self, name: &'static str, at: BodyPoint, force: [f64; 2]) {
        self.load(name, PlanarLoad::Force { at, force, turns_with: None });
    }

    /// A couple on a link.
    pub(crate) fn couple(&mut self, name: &'static str, link: Link, moment: f64) {
        let measure = RelativeCoordinate::Angle { of: link.frame(), against: None };
        self.load(name, PlanarLoad::Effort { measure, effort: Effort::Constant(moment) });
    }

    /// Closes the mechanism where it is drawn and finds motion, efforts and reactions.
    pub(crate) fn solve(self) -> Result<Solved, PlanarError> {
        let system = Model::new(&self.mechanism, &self.drawn)?;
        let positions = system.assemble(&self.drawn)?;
        let (state, dynamics) = system.kinetostatics(&positions)?;
        let Self { links, centres, loads, .. } = self;
        Ok(Solved { system, state, dynamics, links, centres, loads })
    }
}

impl Solved {
    /// Position, velocity and acceleration of a point of a link, in the axes of the link.
    pub(crate) fn point(&self, link: usize, at: [f64; 2]) -> [[f64; 2]; 3] {
        let link = Link { body: link, centre: self.centres[link] };
        self.system.point(link.point(at), &self.state)
    }

    /// Angular velocity and angular acceleration of a link, and the magnitudes of those of all links.
    pub(crate) fn rotation(&self, link: usize) -> [f64; 4] {
        let [[.., speed], [.., acceleration]] = [self.state.velocities[link], self.state.accelerations[link]];
        let [fastest, hardest] = self.sizes().map(|size| size / self.system.size());
        [speed, acceleration, fastest, hardest]
    }

    /// Magnitudes of velocities and accelerations of points that rotate with the links.
    pub(crate) fn sizes(&self) -> [f64; 2] {
        let [_, velocity, acceleration] = rotation_sizes(&self.system, &self.state);
        [velocity, acceleration]
    }

    /// The effort of a driver by the equations of Newton and Euler.
    pub(crate) fn effort(&self, driver: usize) -> f64 {
        self.dynamics.newton_euler[driver]
    }

    /// Reaction of the joint on its second point: of a pin the force, of a slider the force to the left of its line and
    /// the couple, of any other joint its first effort.
    pub(crate) fn reaction(&self, joint: usize) -> [f64; 2] {
        let mut of_joint = (0..self.system.equations().len())
            .filter(|&equation| self.system.owner(equation) == joint)
            .map(|equation| self.dynamics.multipliers[equation]);
        let largest = self.dynamics.multipliers.iter().fold(0.0, |most: f64, effort| most.max(effort.abs()));
        // What is rounding alone is zero.
        let mut next = || of_joint.next().filter(|effort| effort.abs() > 1e-13 * largest).unwrap_or(0.0);
        [next(), next()]
    }

    /// `Σ m (a − g)`: what all forces from outside must add up to.
    pub(crate) fn inertia_resultant(&self) -> [f64; 2] {
        let PlanarMechanism { bodies, gravity, .. } = self.system.mechanism();
        let of = |axis: usize| {
            let rates = bodies.iter().zip(&self.state.accelerations);
            rates.map(|(body, a)| body.mass * (a[axis] - gravity[axis])).sum()
        };
        [of(0), of(1)]
    }

    /// The virtual work of every load for a unit of a driver's measure, and its power.
    pub(crate) fn works(&self, driver: usize) -> Exhibit {
        let name = |of: LoadId| match of {
            LoadId::Load(load) => self.loads[load].into(),
            LoadId::Weight(body) => Text::new("Weight: {link}").with_text("link", self.links[body]),
            LoadId::InertiaForce(body) => {
                Text::new("Inertia force: {link}").with_text("link", self.links[body])
            }
            LoadId::InertiaCouple(body) => {
                Text::new("Inertia couple: {link}").with_text("link", self.links[body])
            }
        };
        let measure = &self.system.mechanism().drivers[driver].measure;
        let (driving, unit) =
            if measure.is_angle() { ("Driving torque", "N*m") } else { ("Driving force", "N") };
        let rate = self.system.mechanism().drivers[driver].velocity;
        let known = &self.dynamics.powers;
        let effort = self.dynamics.efforts[driver];
        let mut rows: Vec<Vec<Cell>> = known
            .iter()
            .map(|load| vec![Cell::Text(name(load.of)), load.generalised[driver].into(), load.power.into()])
            .collect();
        rows.push(vec![driving.into(), effort.into(), (effort * rate).into()]);
        let tidy = |sum: f64, size: f64| if sum.abs() <= 1e-12 * size { 0.0 } else { sum };
        let (work, power) = known.iter().fold((effort, effort * rate), |(work, power), load| {
            (work + load.generalised[driver], power + load.power)
        });
        let size = self.size(driver);
        Exhibit::Table(TableExhibit {
            title: "Virtual work of each load".into(),
            columns: vec![
                Column { heading: "Load".into(), unit: "" },
                Column { heading: "Work per unit of the coordinate".into(), unit },
                Column { heading: "Power".into(), unit: "W" },
            ],
            rows,
            foot: vec!["Total".into(), tidy(work, size).into(), tidy(power, size * rate.abs()).into()],
        })
    }

    /// Holds the size of the force in a pin to its virtual power with the pin released.
    pub(crate) fn check_pin<W: Worksheet>(&self, joint: usize, point: &'static str, force: W::Num, sheet: W) {
        check_pin((&self.system, &self.state, &self.dynamics), (joint, point), force, sheet);
    }

    /// Holds the force across a guide or slot, to the left of its line on what slides, to its virtual power with the
    /// joint released.
    pub(crate) fn check_across<W: Worksheet>(&self, joint: usize, force: W::Num, sheet: W) {
        let Some((efforts, size)) = released(&self.system, &self.state, &self.dynamics, joint, 1) else {
            return;
        };
        let what = "force across the line of the joint by virtual power, with the joint released";
        sheet.check_sum(what, force, efforts[0].into(), size.max(efforts[0].abs()));
    }

    /// The largest virtual work of a load for a unit of a driver's measure.
    pub(crate) fn size(&self, driver: usize) -> f64 {
        self.dynamics.powers.iter().fold(0.0, |most, load| f64::max(most, load.generalised[driver].abs()))
    }

    /// Holds an effort that was found by virtual work against the two ways of the mechanism that was put together.
    pub(crate) fn check_effort<W: Worksheet>(&self, driver: usize, effort: W::Num, sheet: W) {
        let size = self.size(driver).max(effort.value().abs());
        sheet.check_sum(
            "the effort from the Newton–Euler equations of every link",
            effort,
            self.effort(driver).into(),
            size,
        );
    }
}

/// Reaction of a joint along its first relative coordinates by virtual power, with the joint released and driven in its
/// place, and the magnitude of its terms. None where its equations are not measures of their own.
fn released(
    system: &Model,
    state: &PlanarState,
    dynamics: &InverseDynamics,
    joint: usize,
    measures: usize,
) -> Option<(Vec<f64>, f64)> {
    let mut mechanism = system.mechanism().clone();
    let (first, positions) = (mechanism.drivers.len(), &state.positions);
    for equation in mechanism.joints.remove(joint).equations() {
        let [term] = &equation.terms[..] else { return None };
        let (measure, value) = (term.measure, system.value(&term.measure, positions));
        mechanism.drivers.push(Driver { measure, value, velocity: 0.0, acceleration: 0.0 });
    }
    let (_, driven) = Model::new(&mechanism, positions).ok()?.kinetostatics(positions).ok()?;
    let wanted = first..first + measures;
    let forces = system.equations().iter().zip(&dynamics.multipliers);
    let forces = forces.filter(|(equation, _)| !equation.terms[0].measure.is_angle()).map(|(_, force)| force);
    let works = driven.powers.iter().flat_map(|load| &load.generalised[wanted.clone()]);
    let size = forces.chain(works).fold(0.0, |most: f64, effort| most.max(effort.abs()));
    Some((driven.efforts[wanted].to_vec(), size))
}

/// Holds the size of the force in a pin to its virtual power with the pin released.
pub(crate) fn check_pin<W: Worksheet>(
    (system, state, dynamics): (&Model, &PlanarState, &InverseDynamics),
    (joint, point): (usize, &str),
    force: W::Num,
    sheet: W,
) {
    let Some((efforts, size)) = released(system, state, dynamics, joint, 2) else { return };
    let what = Text::new("force at {point} by virtual power, with this joint released").with("point", point);
    let by_power = efforts[0].hypot(efforts[1]);
    sheet.check_sum(what, force, by_power.into(), size.max(by_power));
}

/// Message for a refusal of the kernel.
#[expect(clippy::needless_pass_by_value, reason = "it stands in map_err")]
pub(crate) fn refusal(error: PlanarError) -> Refusal {
    Refusal::because(match error {
        PlanarError::DoesNotClose { residual, .. } => {
            Text::new("the links do not close the loop: {gap} short; change a length or the position")
                .with_quantity("gap", residual, "mm")
        }
        PlanarError::DeadCentre { .. } | PlanarError::Limit { .. } | PlanarError::OverDriven { .. } => {
            "in this position the coordinate does not determine the motion (dead centre); change it slightly"
                .into()
        }
        PlanarError::Jammed { .. } => "no equilibrium was found with friction: the mechanism jams".into(),
        PlanarError::Number { .. }
        | PlanarError::NoSuchBody { .. }
        | PlanarError::UnderDriven { .. }
        | PlanarError::TooFar { .. }
        | PlanarError::NoEquilibrium
        | PlanarError::Massless { .. }
        | PlanarError::Rate { .. }
        | PlanarError::Sticks { .. }
        | PlanarError::Motion(_)
        | PlanarError::NotFinite => {
            "the numbers of this mechanism differ too much in magnitude to be computed with".into()
        }
    })
}

/// A template: what it finds in one position, as the worked solution and, for plots and animations, as plain numbers.
pub(crate) trait Template: Inputs {
    /// Results in one position.
    type Found<N: Real>;

    /// Writes positions, virtual displacements and works, and the effort asked for.
    fn efforts<W: Worksheet>(&self, given: &Self::Given<W>, sheet: W)
    -> Result<Self::Found<W::Num>, Refusal>;

    /// The same as plain numbers; none where there is no answer.
    fn plain(&self) -> Option<Self::Found<f64>> {
        let stop = Stop::new();
        let sheet = Plain::new(&stop);
        let given = self.given(Lift { sheet: &sheet, value: None, field_path: &FieldPath::TOP });
        self.efforts(&given, &sheet).ok()
    }
}

/// The positions that an animation or a plot goes through.
#[derive(Clone, Copy)]
pub(crate) enum Range {
    /// A whole turn, from where it is now.
    Turn(f64),
    /// There and back between two values.
    Between(f64, f64),
}

impl Range {
    /// The positions about `start` that can be reached: a whole turn, or from one limit to the other.
    pub(crate) fn about(start: f64, closes: impl Fn(f64) -> bool) -> Self {
        const STEPS: usize = 180;
        let reached = |sense: f64| {
            (1..=STEPS).map(|n| n as f64 * TAU / 360.0).take_while(|way| closes(start + sense * way)).last()
        };
        let (back, forth) = (reached(-1.0).unwrap_or(0.0), reached(1.0).unwrap_or(0.0));
        if back + forth >= TAU - 1e-9 {
            Range::Turn(start)
        } else {
            Range::Between(start - back, start + forth)
        }
    }

    /// Evenly spaced values, ascending, from end to end.
    pub(crate) fn values(self, count: usize) -> impl Iterator<Item = f64> {
        let (from, to) = match self {
            Range::Turn(_) => (0.0, TAU),
            Range::Between(from, to) => (from, to),
        };
        (0..=count).map(move |n| from + (to - from) * n as f64 / count as f64)
    }
}

/// A template through its range, computed when somebody looks.
pub(crate) struct TemplateRange<P: Template, A: Fn(f64) -> P> {
    pub(crate) range: Range,
    /// The path of the input that is the coordinate.
    input: &'static str,
    at: A,
    found: OnceCell<Vec<(f64, Option<P::Found<f64>>)>>,
}

impl<P: Template, A: Fn(f64) -> P> TemplateRange<P, A> {
    /// The template at each value of the coordinate, which is the input at a path.
    pub(crate) fn new(range: Range, input: &'static str, at: A) -> Self {
        Self { range, input, at, found: OnceCell::new() }
    }

    /// A curve over the range; it breaks where there is no value. Infinity, not NaN: a solution equals itself.
    pub(crate) fn curve(&self, of: impl Fn(&P::Found<f64>) -> f64) -> Vec<(f64, f64)> {
        const STEPS: usize = 120;
        let every = || self.range.values(STEPS).map(|x| (x, (self.at)(x).plain())).collect();
        let found = self.found.get_or_init(every);
        found.iter().map(|(x, found)| (*x, found.as_ref().map_or(f64::INFINITY, &of))).collect()
    }

    /// The torque on the crank over its angle.
    pub(crate) fn torque(&self, of: impl Fn(&P::Found<f64>) -> f64) -> Exhibit {
        let label = ("Torque on the crank", "N*m");
        self.plot("Torque over one revolution", label, &[("torque", "torque", &of)])
    }

    /// Named curves over the crank angle, each of an answer, with the label and the unit of what they show.
    pub(crate) fn plot(
        &self,
        title: &'static str,
        (label, unit): (&'static str, &'static str),
        series: &[(&'static str, &'static str, &dyn Fn(&P::Found<f64>) -> f64)],
    ) -> Exhibit {
        let lines = series.iter().map(|(name, answer, of)| Series::line(*name, self.curve(of)).of(answer));
        let (x, y) = (Axis::linear("Crank angle", "deg"), Axis::linear(label, unit));
        Exhibit::Plot(Plot::new(title, x, y, lines.collect()).over(self.input))
    }
}

/// An effort that grows without bound near the dead centres, where what it acts on hardly moves with the crank: left
/// out where it moves by less than a tenth of `unit` for a unit turn.
pub(crate) fn bounded(effort: f64, shift: f64, unit: f64) -> f64 {
    if shift.abs() <= 0.1 * unit { f64::INFINITY } else { effort }
}

/// An animation of the mechanism going through its range of an input from its present value on; positions without a picture
/// are left out. Symbols are of the scale of a machine of that size.
pub(crate) fn animation(
    title: &'static str,
    (input, present): (&'static str, f64),
    range: Range,
    size: f64,
    frame: impl Fn(f64, &mut Sketch) -> Option<()>,
) -> Exhibit {
    const FRAMES: usize = 24;
    let at = |n: usize| {
        let part = TAU * n as f64 / FRAMES as f64;
        match range {
            Range::Turn(start) => start + part,
            Range::Between(..) if n == 0 => present,
            Range::Between(from, to) => {
                let (middle, half) = (f64::midpoint(from, to), (to - from) / 2.0);
                let begun =
                    if half > 0.0 { ((middle - present) / half).clamp(-1.0, 1.0).acos() } else { 0.0 };
                middle - half * (begun + part).cos()
            }
        }
    };
    let drawn = |value: f64| {
        let mut sketch = Sketch::default();
        sketch.size(size);
        frame(value, &mut sketch)?;
        Some((value, sketch))
    };
    let (values, frames): (Vec<f64>, Vec<Sketch>) = (0..FRAMES).map(at).filter_map(drawn).unzip();
    Exhibit::Animation(Sketch::animation(title, frames, 3.0).over(input, values))
}

/// Forces as arrows that start at their points, the largest as long as `length`.
pub(crate) fn forces(sketch: &mut Sketch, forces: &[(&'static str, At, [f64; 2])], length: f64) {
    let largest = forces.iter().fold(0.0f64, |most, (.., [x, y])| most.max(x.hypot(*y)));
    for (name, at, [x, y]) in forces.iter().filter(|(.., [x, y])| x.hypot(*y) > 1e-3 * largest) {
        let scale = length / largest;
        sketch.force(*name, *at, (at.0 + scale * x, at.1 + scale * y));
    }
}

/// A vector turned by an angle.
pub(crate) fn turned([x, y]: [f64; 2], angle: f64) -> [f64; 2] {
    let (sin, cos) = angle.sin_cos();
    [cos * x - sin * y, sin * x + cos * y]
}

/// The point so far from another, in a direction.
pub(crate) fn away(from: [f64; 2], length: f64, angle: f64) -> [f64; 2] {
    let (sin, cos) = angle.sin_cos();
    [from[0] + length * cos, from[1] + length * sin]
}
