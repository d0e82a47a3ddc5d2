//! Virtual works of a linkage with one degree of freedom: what every link does for a unit of the coordinate.
//!
//! Links carry the numbers of the field: 1 the frame, 2 the crank, 3 the rod or coupler, 4 what follows. For the
//! coordinate θ₂ and a virtual turn δθ₂ = 1 a point moves by `u` and a link turns by `h`, so that `δW = F·u + T h`.

use dalembert_core::{Cite, Inputs, Symbol, Text, Worksheet};
use dalembert_mechanics::{Real, Vector};

use crate::{
    shared::built::{self, Solved},
    sources::{RIUL, SHIGLEY},
};

/// The mass of a link.
#[derive(Clone, Debug, Inputs)]
pub enum LinkMass {
    /// Uniform slender bar
    /// Its centre of mass is in the middle and its moment of inertia is m l²/12.
    Uniform {
        /// Mass.
        #[input("m", "kg", nonnegative)]
        mass: f64,
    },
    /// Mass, centre of mass and moment of inertia
    Given {
        /// Mass.
        #[input("m", "kg", nonnegative)]
        mass: f64,
        /// Distance of the centre of mass from the first pin.
        /// The first pin of a crank or rocker is the fixed one, that of a coupler is the crank pin.
        #[input("ρ", "mm")]
        distance: f64,
        /// Angle of the centre of mass from the line of the pins.
        #[input("δ", "deg", default = "0 deg")]
        offset: f64,
        /// Moment of inertia about the centre of mass.
        #[input("I", "kg*m^2", nonnegative, default = "0 kg*m^2")]
        inertia: f64,
    },
}

/// A link by its number: what its symbols carry.
#[derive(Clone, Copy)]
pub(crate) struct Number {
    pub(crate) link: &'static str,
    centre: &'static str,
}

/// Link 2, the crank.
pub(crate) const TWO: Number = Number { link: "2", centre: "G2" };
/// Link 3.
pub(crate) const THREE: Number = Number { link: "3", centre: "G3" };
/// Link 4.
pub(crate) const FOUR: Number = Number { link: "4", centre: "G4" };
/// Link 5.
pub(crate) const FIVE: Number = Number { link: "5", centre: "G5" };
/// Link 6.
pub(crate) const SIX: Number = Number { link: "6", centre: "G6" };

/// Works of most linkages: weight, inertia force and couple of three links, a force and a couple.
const WORKS: usize = 11;

/// A point: its virtual displacement for a unit of the coordinate, and its acceleration.
#[derive(Clone, Copy)]
pub(crate) struct PointWork<W: Worksheet> {
    pub(crate) shift: W::Vec,
    pub(crate) acceleration: W::Vec,
}

/// A link that turns: its angle, its virtual turn for a unit of the coordinate, and its real motion.
#[derive(Clone, Copy)]
pub(crate) struct RotatingLinkWork<N> {
    pub(crate) angle: N,
    pub(crate) ratio: N,
    pub(crate) speed: N,
    pub(crate) acceleration: N,
}

impl<N: Real> RotatingLinkWork<N> {
    /// The crank, whose angle is the coordinate.
    #[inline(always)]
    pub(crate) fn crank(angle: N, speed: N, acceleration: N) -> Self {
        Self { angle, ratio: 1.0.into(), speed, acceleration }
    }

    /// A link of that length from its first pin to its second, and the length.
    #[inline(always)]
    pub(crate) fn reach<W: Worksheet<Num = N>>(&self, length: N) -> (W::Vec, N) {
        (direction::<W>(self.angle) * length, length)
    }
}

/// The virtual works so far.
pub(crate) struct Works<W: Worksheet> {
    sheet: W,
    gravity: Option<W::Vec>,
    moves: bool,
    done: Vec<W::Num>,
}

/// Returns true if the coordinate has a velocity or an acceleration: otherwise the problem is one of statics.
#[inline(always)]
pub(crate) fn moves<N: Real>(speed: N, acceleration: N) -> bool {
    speed.holds_with(acceleration, |speed, acceleration| speed != 0.0 || acceleration != 0.0)
}

/// A symbol that belongs to a part.
pub(crate) fn symbol(base: &'static str, of: &'static str) -> Symbol {
    Symbol { of, ..Symbol::from(base) }
}

/// The unit vector of a direction.
#[inline(always)]
pub(crate) fn direction<W: Worksheet>(angle: W::Num) -> W::Vec {
    W::Vec::from_components(angle.cos(), angle.sin(), 0.0.into())
}

/// A vector in the plane.
#[inline(always)]
pub(crate) fn plane<W: Worksheet>(x: W::Num, y: W::Num) -> W::Vec {
    W::Vec::from_components(x, y, 0.0.into())
}

/// A vector turned a quarter turn counter-clockwise, `k × a`.
#[inline(always)]
pub(crate) fn across<W: Worksheet>(a: W::Vec) -> W::Vec {
    W::Vec::from_components(0.0.into(), 0.0.into(), 1.0.into()).cross(a)
}

/// A point that is at rest.
#[inline(always)]
pub(crate) fn fixed<W: Worksheet>() -> PointWork<W> {
    let zero = plane::<W>(0.0.into(), 0.0.into());
    PointWork { shift: zero, acceleration: zero }
}

/// The point at `arm` from the first pin of a link.
#[inline(always)]
pub(crate) fn moving<W: Worksheet>(
    of: &'static str,
    pin: PointWork<W>,
    arm: W::Vec,
    turning: RotatingLinkWork<W::Num>,
    moves: bool,
    sheet: W,
) -> PointWork<W> {
    let still = pin.shift.is_zero();
    let turned = across::<W>(arm);
    // The coordinate itself turns by 1.
    let turned = if turning.ratio.holds(|h| h == 1.0) { turned } else { turned * turning.ratio };
    let shift = if still { turned } else { pin.shift + turned };
    let why = || Text::new("Virtual displacement of {point} per unit of the coordinate").with("point", of);
    let shift = sheet.step_vector(symbol("u", of), "mm", shift, (why, SHIGLEY.at("ch. 3")));
    if !moves {
        return PointWork { shift, acceleration: plane::<W>(0.0.into(), 0.0.into()) };
    }
    let turned = across::<W>(arm) * turning.acceleration - arm * turning.speed.powi(2);
    let acceleration = if still { turned } else { pin.acceleration + turned };
    let why = || Text::new("Acceleration of {point}").with("point", of);
    let acceleration = sheet.step_vector(symbol("a", of), "m/s^2", acceleration, (why, SHIGLEY.at("ch. 4")));
    PointWork { shift, acceleration }
}

impl LinkMass {
    /// The mass in the axes of a link of that length.
    pub(crate) fn built(this: Option<&Self>, length: f64) -> built::BuiltMass {
        match this {
            None => built::BuiltMass::default(),
            Some(&LinkMass::Uniform { mass }) => {
                built::BuiltMass { mass, centre: [length / 2.0, 0.0], inertia: mass * length * length / 12.0 }
            }
            Some(&LinkMass::Given { mass, distance, offset, inertia }) => {
                built::BuiltMass { mass, centre: built::away([0.0; 2], distance, offset), inertia }
            }
        }
    }
}

impl<W: Worksheet> Works<W> {
    /// No works yet. Without gravity no weight is written, without motion no inertia load.
    #[inline(always)]
    pub(crate) fn new(gravity: W::Vec, moves: bool, sheet: W) -> Self {
        let gravity = (!gravity.is_zero()).then_some(gravity);
        Self { sheet, gravity, moves, done: Vec::with_capacity(WORKS) }
    }

    /// The work of a force whose point moves by `shift`.
    #[inline(always)]
    pub(crate) fn force(&mut self, of: &'static str, force: W::Vec, shift: W::Vec) {
        if !force.is_zero() {
            let why = || {
                Text::new("Virtual work of the force at {point}: force times displacement").with("point", of)
            };
            let whole = || force.magnitude() * shift.magnitude();
            self.sheet.common_error(
                symbol("δW", of),
                "the magnitudes of force and displacement multiplied, without the angle between them",
                whole,
            );
            self.push(symbol("δW", of), force.dot(shift), why, RIUL.at("eq. 1"));
        }
    }

    /// The work of a couple on a link that turns by `ratio`.
    #[inline(always)]
    pub(crate) fn couple(&mut self, of: Number, moment: W::Num, ratio: W::Num) {
        if moment.holds(|moment| moment != 0.0) {
            let why = || {
                Text::new("Virtual work of the couple on link {n}: couple times rotation").with("n", of.link)
            };
            self.push(symbol("δW_T", of.link), moment * ratio, why, RIUL.at("eq. 1"));
        }
    }

    /// The work of a known torque on the crank.
    #[inline(always)]
    pub(crate) fn driving(&mut self, torque: W::Num) {
        if torque.holds(|torque| torque != 0.0) {
            let why = "Virtual work of the torque for δθ_2 = 1";
            self.push(symbol("δW_T", "2"), torque, why, RIUL.at("eq. 1"));
        }
    }

    /// A work that was written elsewhere.
    #[inline(always)]
    pub(crate) fn push(&mut self, symbol: Symbol, work: W::Num, why: impl Into<Text>, cite: Cite) {
        let work = self.sheet.step(symbol, "N*m", work, (why, cite));
        self.done.push(work);
    }

    /// The works of the weight and of the inertia force of a mass.
    #[inline(always)]
    pub(crate) fn mass(&mut self, of: Number, mass: W::Num, point: PointWork<W>) {
        if mass.holds(|mass| mass == 0.0) {
            return;
        }
        if let Some(gravity) = self.gravity {
            let why = || Text::new("Virtual work of the weight of link {n}").with("n", of.link);
            let whole = || gravity.magnitude() * mass * point.shift.magnitude();
            self.sheet.common_error(
                symbol("δW_W", of.link),
                "the whole displacement used for the weight, not its vertical part",
                whole,
            );
            let work = (gravity * mass).dot(point.shift);
            self.push(symbol("δW_W", of.link), work, why, RIUL.at("eq. 5"));
        }
        if self.moves {
            let why = || Text::new("Virtual work of the inertia force −m a of link {n}").with("n", of.link);
            let work = -(point.acceleration * mass).dot(point.shift);
            self.push(symbol("δW_F", of.link), work, why, RIUL.at("eq. 5"));
        }
    }

    /// The works of the weight and of the inertia loads of a link, from its first pin on.
    #[inline(always)]
    pub(crate) fn link(
        &mut self,
        of: Number,
        mass: Option<&LinkMassGiven<W>>,
        length: W::Num,
        pin: PointWork<W>,
        turning: RotatingLinkWork<W::Num>,
    ) {
        let Some(mass) = mass else { return };
        let (sheet, n) = (self.sheet, of.link);
        let (mass, arm, inertia) = match *mass {
            LinkMassGiven::Uniform { mass } => {
                let why =
                    || Text::new("Link {n} is a uniform bar: from its first pin to its middle").with("n", n);
                let arm = direction::<W>(turning.angle) * (length / 2.0);
                let arm = sheet.step_vector(symbol("r", of.centre), "mm", arm, why);
                let mut inertia = mass * length.powi(2) / 12.0;
                if self.moves {
                    let why = || Text::new("Moment of inertia of the uniform bar, link {n}").with("n", n);
                    inertia = sheet.step(symbol("I", n), "kg*m^2", inertia, why);
                }
                (mass, arm, inertia)
            }
            LinkMassGiven::Given { mass, distance, offset, inertia } => {
                let angle =
                    if offset.holds(|offset| offset == 0.0) { turning.angle } else { turning.angle + offset };
                let why = || Text::new("From the first pin of link {n} to its centre of mass").with("n", n);
                let arm = direction::<W>(angle) * distance;
                (mass, sheet.step_vector(symbol("r", of.centre), "mm", arm, why), inertia)
            }
        };
        self.body(of, pin, arm, turning, mass, inertia);
    }

    /// The same of a body whose centre of mass is at `arm` from a point of it.
    #[inline(always)]
    pub(crate) fn body(
        &mut self,
        of: Number,
        point: PointWork<W>,
        arm: W::Vec,
        turning: RotatingLinkWork<W::Num>,
        mass: W::Num,
        inertia: W::Num,
    ) {
        if mass.holds(|mass| mass != 0.0) {
            let centre = moving(of.centre, point, arm, turning, self.moves, self.sheet);
            self.mass(of, mass, centre);
        }
        if self.moves && inertia.holds(|inertia| inertia != 0.0) {
            let why = || Text::new("Virtual work of the inertia couple −I α of link {n}").with("n", of.link);
            let about_pin = || inertia + mass * arm.magnitude().powi(2);
            self.sheet.common_error(
                symbol("δW_I", of.link),
                "the moment of inertia about the pin used together with the inertia force at the centre of mass",
                || -(about_pin() * turning.acceleration * turning.ratio),
            );
            let couple = -(inertia * turning.acceleration);
            let work = if turning.ratio.holds(|h| h == 1.0) { couple } else { couple * turning.ratio };
            self.push(symbol("δW_I", of.link), work, why, RIUL.at("eq. 5"));
        }
    }

    /// The torque on link 2 that brings the works, with that of the load on the output, to zero.
    #[inline(always)]
    pub(crate) fn balanced(&mut self, of: &'static str, work: W::Num, why: &'static str) -> W::Num {
        if work.holds(|work| work != 0.0) {
            self.push(symbol("δW", of), work, why, RIUL.at("eq. 1"));
        }
        let why = "Torque: the total virtual work is zero, T_2 δθ_2 + ΣδW = 0";
        self.sheet.step(symbol("T", "2"), "N*m", -self.sum(), (why, RIUL.at("eq. 5")))
    }

    /// The sum of the works.
    #[inline(always)]
    pub(crate) fn sum(&self) -> W::Num {
        match self.done[..] {
            [] => self.sheet.numerical("ΣδW", "N*m", 0.0, "No load does work: there is nothing to balance"),
            [only] => only,
            _ => {
                let sum = Real::sum(self.done.iter().copied());
                self.sheet.step("ΣδW", "N*m", sum, ("Virtual work of all known loads", RIUL.at("eq. 1")))
            }
        }
    }
}

/// Reaction of a pin, by the Newton–Euler equations: components and magnitude. `of` is the pin, and with x and y behind
/// it.
pub(crate) fn reaction<W: Worksheet>(
    of: [&'static str; 3],
    (name, label): (&'static str, &'static str),
    (solved, joint): (&Solved, usize),
    sheet: W,
) {
    let [x, y] = solved.reaction(joint);
    let why = "From the equations of Newton and Euler of every link, solved together";
    let x = sheet.numerical(symbol("R", of[1]), "N", x, (why, SHIGLEY.at("ch. 11")));
    let y = sheet.numerical(symbol("R", of[2]), "N", y, (why, SHIGLEY.at("ch. 11")));
    let size = sheet.step(symbol("R", of[0]), "N", (x.powi(2) + y.powi(2)).sqrt(), "Force in the joint");
    sheet.answer(name, label, size);
    sheet.verify(|| solved.check_pin(joint, of[0], size, sheet));
}

/// Holds the reactions of the frame and the forces from outside to what the masses demand.
pub(crate) fn check_balance<W: Worksheet>(forces: &[[f64; 2]], demanded: [f64; 2], sheet: W) {
    for (axis, what) in ["ΣF_x = Σm a_Gx for the whole mechanism", "ΣF_y = Σm a_Gy for the whole mechanism"]
        .into_iter()
        .enumerate()
    {
        let sum: f64 = forces.iter().map(|force| force[axis]).sum();
        let size = forces.iter().chain([&demanded]).fold(0.0f64, |most, f| most.max(f[0].hypot(f[1])));
        sheet.check_zero(what, (sum - demanded[axis]).into(), size);
    }
}
