//! A rigid rotor with known eccentric masses, balanced in two planes.

use dalembert_core::{About, Analysis, Exhibit, Ink, Inputs, Refusal, Text, Worksheet, register};
use dalembert_mechanics::{
    Real, Vector,
    balance::{self, PlaneUnbalance},
};

use crate::{
    shared::{
        rotor::letter,
        rotor::{self, CorrectionMethod},
        views::{self, ListedUnbalance},
    },
    sources::{MABIE, RIUL},
};

/// The eccentric masses, the two planes, and what is put there.
#[derive(Clone, Debug, Inputs)]
pub struct TwoPlane {
    /// Eccentric masses.
    #[input(min = 1)]
    pub masses: Vec<EccentricMass>,
    /// Position of plane A.
    /// Along the shaft, from the same origin as the masses.
    #[input("z_A", "mm", default = "0 mm")]
    pub plane_a: f64,
    /// Position of plane B.
    #[input("z_B", "mm")]
    pub plane_b: f64,
    /// Correction in plane A.
    #[input("A")]
    pub correction_a: Correction,
    /// Correction in plane B.
    #[input("B")]
    pub correction_b: Correction,
    /// Correction method.
    pub way: CorrectionMethod,
    /// Gravity.
    /// Only turns masses into weights; the balance does not depend on it.
    #[input("g", "m/s^2", positive, default = "9.81 m/s^2")]
    pub gravity: f64,
    /// Speed.
    /// For the force and the couple before balancing.
    #[input("ω", "rpm", positive)]
    pub speed: Option<f64>,
}

/// A mass that is not on the axis.
#[derive(Clone, Debug, Inputs)]
pub struct EccentricMass {
    /// Mass.
    #[input("m", "kg", positive)]
    pub mass: f64,
    /// Radius.
    #[input("r", "mm", nonnegative)]
    pub radius: f64,
    /// Angle.
    /// Counter-clockwise from a mark on the rotor.
    #[input("θ", "deg")]
    pub angle: f64,
    /// Position.
    /// Along the shaft, from any origin.
    #[input("z", "mm")]
    pub position: f64,
}

/// Known quantity of a correction: mass or radius.
#[derive(Clone, Debug, Inputs)]
pub enum Correction {
    /// Radius given, mass required
    Radius {
        /// Radius.
        #[input("r", "mm", positive)]
        radius: f64,
    },
    /// Mass given, radius required
    Mass {
        /// Mass.
        #[input("m", "kg", positive)]
        mass: f64,
    },
}

register!(TwoPlane);

const COINCIDENT: &str = "planes A and B are the same plane, so no corrections there can balance a couple; give them different positions";

impl Analysis for TwoPlane {
    const ABOUT: About = About {
        id: "balancing/two-plane",
        title: "Balancing in two planes",
        topic: "Rigid rotors",
        summary: "Corrections in two planes that cancel both the rotating force and the rotating couple of a rigid rotor.",
        main: &["mass_a", "radius_a", "angle_a", "mass_b", "angle_b"],
        keywords: "balanceamento dinâmico dois planos rotor correção dynamic balancing correction planes example 2",
        sources: &[&RIUL, &MABIE],
        cases: include_str!("../../cases/two_plane.toml"),
    };
    const SIMD: bool = true;

    #[inline(always)]
    fn solve<W: Worksheet>(&self, given: &TwoPlaneGiven<W>, sheet: W) -> Result<(), Refusal> {
        if given.plane_a.holds_with(given.plane_b, |a, b| a == b) {
            return Err(Refusal::because(COINCIDENT));
        }
        let x = Along::new(sheet, given, TransverseAxis::X);
        let y = Along::new(sheet, given, TransverseAxis::Y);
        let mut checked = Ok(());
        sheet.verify(|| checked = self.check_balance(sheet, given, [&x, &y]));
        checked?;

        self.other_rules(sheet, given, [&x, &y]);
        let b = self.correction(sheet, ("U_B", "m_B", "r_B", "θ_B"), (x.in_b, y.in_b), &given.correction_b);
        let a = self.correction(sheet, ("U_A", "m_A", "r_A", "θ_A"), (x.in_a, y.in_a), &given.correction_a);
        sheet.answer("unbalance_a", "Unbalance of the correction in plane A", a.unbalance);
        sheet.answer("angle_a", "Angle in plane A", a.angle);
        match self.correction_a {
            Correction::Radius { .. } => sheet.answer("mass_a", "Mass in plane A", a.wanted),
            Correction::Mass { .. } => sheet.answer("radius_a", "Radius in plane A", a.wanted),
        }
        sheet.answer("unbalance_b", "Unbalance of the correction in plane B", b.unbalance);
        sheet.answer("angle_b", "Angle in plane B", b.angle);
        match self.correction_b {
            Correction::Radius { .. } => sheet.answer("mass_b", "Mass in plane B", b.wanted),
            Correction::Mass { .. } => sheet.answer("radius_b", "Radius in plane B", b.wanted),
        }
        weights(sheet, given.gravity, [&x, &y], [a.mass, b.mass]);
        if let Some(speed) = given.speed {
            before(sheet, speed, given.plane_a, [&x, &y]);
        }

        let corrections = || [&x, &y].map(|along| [along.in_a.value(), along.in_b.value()]);
        sheet.verify(|| {
            let largest = self.masses.iter().map(|m| m.mass * m.radius).fold(0.0, f64::max);
            let reach = a.unbalance.value().max(b.unbalance.value());
            if reach > 10.0 * largest {
                sheet.warn(|| {
                    Text::new("the planes are so close together that a correction is {times} times the largest unbalance")
                        .with("times", format!("{:.0}", reach / largest))
                });
            }
        });
        sheet.show(|| Exhibit::Table(views::table(&self.shown(corrections()), true)));
        sheet.show(|| Exhibit::Drawing(views::polar(&self.shown(corrections()), self.speed.map(|_| "ω"))));
        sheet.show(|| Exhibit::Drawing(views::side(&self.shown(corrections()), &[])));
        Ok(())
    }
}

/// Everything along one direction across the shaft.
struct Along<N> {
    /// The component of each mass, and its position.
    masses: Vec<(N, N)>,
    /// The component of the correction in plane A.
    in_a: N,
    /// The component of the correction in plane B.
    in_b: N,
}

/// An axis across that of the rotor.
#[derive(Clone, Copy)]
enum TransverseAxis {
    X,
    Y,
}

impl<N: Real> Along<N> {
    #[inline(always)]
    fn new<W: Worksheet<Num = N>>(sheet: W, given: &TwoPlaneGiven<W>, axis: TransverseAxis) -> Self {
        let ([mass, in_b, in_a], why) = match axis {
            TransverseAxis::X => (["U_x", "U_Bx", "U_Ax"], "Unbalance of each mass along x"),
            TransverseAxis::Y => (["U_y", "U_By", "U_Ay"], "Unbalance of each mass along y"),
        };
        let mut masses = Vec::with_capacity(given.masses.len());
        // A loop: what an iterator calls is not always inlined, as SIMD needs it.
        for (n, m) in (1..).zip(&given.masses) {
            let unbalance = match axis {
                TransverseAxis::X => balance::component_x(m.mass, m.radius, m.angle),
                TransverseAxis::Y => balance::component_y(m.mass, m.radius, m.angle),
            };
            masses.push((sheet.step((mass, n), "kg*mm", unbalance, why), m.position));
        }
        let formula = balance::correction_in_b(masses.iter().copied(), given.plane_a, given.plane_b);
        let in_b =
            sheet.step(in_b, "kg*mm", formula, ("Moments about plane A vanish", RIUL.at("eqs. 13–15")));
        let formula = balance::correction_in_a(masses.iter().map(|(u, _)| *u), in_b);
        let in_a = sheet.step(in_a, "kg*mm", formula, ("Forces vanish", RIUL.at("eqs. 12, 20")));
        Self { masses, in_a, in_b }
    }

    fn resultant(&self) -> N {
        balance::resultant(self.masses.iter().map(|(u, _)| *u))
    }
}

/// A correction as found.
struct Corrected<N> {
    unbalance: N,
    angle: N,
    mass: N,
    /// The mass, or the radius where the mass is given.
    wanted: N,
}

impl TwoPlane {
    /// Magnitude, angle and mass (or radius) of a correction from its components.
    #[inline(always)]
    fn correction<W: Worksheet>(
        &self,
        sheet: W,
        (unbalance, mass, radius, angle): (&'static str, &'static str, &'static str, &'static str),
        (x, y): (W::Num, W::Num),
        known: &CorrectionGiven<W>,
    ) -> Corrected<W::Num> {
        let size = sheet.step(
            unbalance,
            "kg*mm",
            balance::magnitude(x, y),
            ("Magnitude of the correction", RIUL.at("eq. 16")),
        );
        let (wanted, mass, product) = match known {
            CorrectionGiven::Radius { radius } => {
                let mass =
                    sheet.step(mass, "kg", size / *radius, ("Mass at the given radius", RIUL.at("eq. 17")));
                (mass, mass, mass * *radius)
            }
            CorrectionGiven::Mass { mass } => {
                let radius = sheet.step(radius, "mm", size / *mass, "Radius of the given mass");
                (radius, *mass, *mass * radius)
            }
        };
        let (direction, why) = match self.way {
            CorrectionMethod::Add => (
                balance::marked_direction(x, y),
                "Angle where the mass is added, counter-clockwise from the mark",
            ),
            CorrectionMethod::Drill => (
                balance::marked_direction(-x, -y),
                "Angle where the mass is removed, opposite to where it would be added",
            ),
        };
        rotor::quadrant_ignored(sheet, angle, (x, y));
        let angle = sheet.step(angle, "deg", direction, (why, RIUL.at("eq. 19")));
        sheet.verify(|| {
            let product = if self.way == CorrectionMethod::Add { product } else { -product };
            let scale = size.value();
            sheet.check_sum(
                "mass, radius and angle make up the component along x",
                product * angle.cos(),
                x,
                scale,
            );
            sheet.check_sum(
                "mass, radius and angle make up the component along y",
                product * angle.sin(),
                y,
                scale,
            );
        });
        Corrected { unbalance: size, angle, mass, wanted }
    }

    /// Declares the rules by which people find other corrections.
    #[inline(always)]
    fn other_rules<W: Worksheet>(&self, sheet: W, given: &TwoPlaneGiven<W>, directions: [&Along<W::Num>; 2]) {
        sheet.verify(|| {
            let scale: f64 = self.masses.iter().map(|m| m.mass * m.radius).sum();
            let declare = |symbols: (&'static str, &'static str),
                           what: &'static str,
                           rule: &dyn Fn(&Along<W::Num>) -> W::Num| {
                let [x, y] = directions;
                rotor::by_another_rule(sheet, symbols, (self.way, scale), what, || (rule(x), rule(y)));
            };
            let (in_a, in_b) = (("U_A", "θ_A"), ("U_B", "θ_B"));
            for symbols in [in_a, in_b] {
                declare(symbols, rotor::HALF_EACH, &|along| -along.resultant() / 2.0);
            }
            declare(in_a, rotor::WITHOUT_THE_OTHER, &|along| -along.resultant());
            declare(in_b, rotor::ABOUT_THE_ORIGIN, &|along| {
                let moment = W::Num::sum(along.masses.iter().map(|(u, z)| *u * *z));
                -moment / (given.plane_b - given.plane_a)
            });
            sheet.common_error(in_b.0, rotor::MOMENTS_AS_NUMBERS, || {
                let moment = moments_as_numbers(directions, given.plane_a);
                moment / (given.plane_b - given.plane_a).abs()
            });
        });
    }

    /// Further ways to the same corrections: moments about plane B, both equations as one linear system, and what
    /// is left of forces and moments.
    fn check_balance<W: Worksheet>(
        &self,
        sheet: W,
        given: &TwoPlaneGiven<W>,
        directions: [&Along<W::Num>; 2],
    ) -> Result<(), Refusal> {
        let unbalances = self.masses.iter().map(|m| PlaneUnbalance {
            position: m.position,
            components: [m.mass * m.radius * m.angle.cos(), m.mass * m.radius * m.angle.sin()],
        });
        let unbalances: Vec<PlaneUnbalance> = unbalances.collect();
        let system = balance::balance_two_planes(&unbalances, [self.plane_a, self.plane_b])
            .map_err(|_| Refusal::because(COINCIDENT))?;
        // Terms cancel; what is left is compared with the size of what cancelled.
        let force =
            self.masses.iter().map(|m| m.mass * m.radius).sum::<f64>() + system.in_a[0].hypot(system.in_a[1]);
        let reach = self.masses.iter().map(|m| (m.position - self.plane_b).abs()).fold(0.0, f64::max);
        let moment = force * (reach + (self.plane_b - self.plane_a).abs());
        for (axis, Along { masses, in_a, in_b }) in directions.into_iter().enumerate() {
            let (in_a, in_b) = (*in_a, *in_b);
            let by_moments =
                balance::correction_in_a_by_moments(masses.iter().copied(), given.plane_a, given.plane_b);
            sheet.check_zero("plane A from moments about plane B", in_a - by_moments, force);
            let [by_system_a, by_system_b] =
                [system.in_a, system.in_b].map(|found| W::Num::from(found[axis]));
            sheet.check_sum("plane A from both equations at once", in_a, by_system_a, force);
            sheet.check_sum("plane B from both equations at once", in_b, by_system_b, force);
            let all = || masses.iter().copied().chain([(in_a, given.plane_a), (in_b, given.plane_b)]);
            sheet.check_zero("no force is left", balance::resultant(all().map(|(u, _)| u)), force);
            sheet.check_zero(
                "no moment is left about plane B",
                balance::moment(all(), given.plane_b),
                moment,
            );
        }
        Ok(())
    }

    /// The masses and the corrections, whose components along x and y are those in both planes, to be listed and drawn.
    fn shown(&self, [x, y]: [[f64; 2]; 2]) -> Vec<ListedUnbalance> {
        let masses = self.masses.iter().zip(1..).map(|(m, n)| ListedUnbalance {
            name: Text::new("mass {n}").with("n", n),
            label: letter("m", n),
            polar: format!("{} {} ∠ {}", letter("m", n), letter("r", n), letter("θ", n)),
            place: letter("z", n),
            mass_and_radius: None,
            unbalance: (m.mass * m.radius * m.angle.cos(), m.mass * m.radius * m.angle.sin()),
            position: m.position,
            ink: Ink::Force,
        });
        let [in_a, in_b] = [(x[0], y[0]), (x[1], y[1])];
        let plane = |name: &'static str, label: &str, unbalance, position| ListedUnbalance {
            name: name.into(),
            label: label.into(),
            polar: format!("m_{label} r_{label}"),
            place: format!("z_{label}"),
            mass_and_radius: None,
            unbalance,
            position,
            ink: Ink::Result,
        };
        masses
            .chain([plane("plane A", "A", in_a, self.plane_a), plane("plane B", "B", in_b, self.plane_b)])
            .collect()
    }
}

/// The products weight × radius that textbooks write, and the weights of the corrections.
fn weights<W: Worksheet>(
    sheet: W,
    gravity: W::Num,
    [x, y]: [&Along<W::Num>; 2],
    [mass_a, mass_b]: [W::Num; 2],
) {
    let zero = || W::Num::from(0.0);
    let product = |x: W::Num, y: W::Num| W::Vec::from_components(x, y, zero()) * gravity;
    let why = ("Weight–radius product, as in textbooks", RIUL.at("eqs. 12–20"));
    let sum = sheet.step_vector("ΣW r", "N*mm", product(x.resultant(), y.resultant()), why);
    let at_b = sheet.step_vector("W_B r_B", "N*mm", product(x.in_b, y.in_b), why);
    let at_a = sheet.step_vector("W_A r_A", "N*mm", product(x.in_a, y.in_a), why);
    let weight_a = sheet.step("W_A", "N", mass_a * gravity, "Weight of the correction");
    let weight_b = sheet.step("W_B", "N", mass_b * gravity, "Weight of the correction");
    sheet.answer("weight_a", "Weight in plane A", weight_a);
    sheet.answer("weight_b", "Weight in plane B", weight_b);
    sheet.answer_vector("weight_moments", "Weight–radius product of all masses", sum);
    sheet.answer_vector("weight_moment_b", "Weight–radius product in plane B", at_b);
    sheet.answer_vector("weight_moment_a", "Weight–radius product in plane A", at_a);
}

/// The moments of all masses about plane A, added without their directions.
fn moments_as_numbers<N: Real>([x, y]: [&Along<N>; 2], plane_a: N) -> N {
    let both = x.masses.iter().zip(&y.masses);
    N::sum(both.map(|((x, z), (y, _))| (balance::magnitude(*x, *y) * (*z - plane_a)).abs()))
}

/// The rotating force and couple that the bearings carry before balancing.
fn before<W: Worksheet>(sheet: W, speed: W::Num, plane_a: W::Num, [x, y]: [&Along<W::Num>; 2]) {
    let sum = balance::magnitude(x.resultant(), y.resultant());
    sheet.common_error("F", rotor::AS_NUMBERS, || {
        let sizes = x.masses.iter().zip(&y.masses).map(|((x, _), (y, _))| balance::magnitude(*x, *y));
        balance::centrifugal_force(W::Num::sum(sizes), speed)
    });
    let force = sheet.step(
        "F",
        "N",
        balance::centrifugal_force(sum, speed),
        ("Rotating force before balancing", RIUL.at("eq. 7")),
    );
    let couple = balance::magnitude(
        balance::moment(x.masses.iter().copied(), plane_a),
        balance::moment(y.masses.iter().copied(), plane_a),
    );
    let why = ("Rotating couple about plane A before balancing", RIUL.at("eq. 13"));
    sheet.common_error("C", rotor::MOMENTS_AS_NUMBERS, || {
        balance::centrifugal_force(moments_as_numbers([x, y], plane_a), speed)
    });
    sheet.common_error("C", rotor::ABOUT_THE_ORIGIN, || {
        let moment = |along: &Along<W::Num>| W::Num::sum(along.masses.iter().map(|(u, z)| *u * *z));
        balance::centrifugal_force(balance::magnitude(moment(x), moment(y)), speed)
    });
    let couple = sheet.step("C", "N*m", balance::centrifugal_force(couple, speed), why);
    sheet.answer("force_before", "Rotating force before balancing", force);
    sheet.answer("couple_before", "Rotating couple about plane A before balancing", couple);
    sheet.verify(|| {
        let spun = speed.value().powi(2);
        let each = || x.masses.iter().zip(&y.masses);
        let polar = |(x, y): (W::Num, W::Num)| (x.value().hypot(y.value()), y.value().atan2(x.value()));
        let all: Vec<_> = each().map(|(x, y)| polar((x.0, y.0))).collect();
        let (again, scale) = rotor::along_first(&all);
        let what = "force by components along the first mass and across it";
        sheet.check_sum(what, force, (again * spun).into(), scale * spun);
        let arms = each().map(|(x, y)| {
            let (size, angle) = polar((x.0, y.0));
            (size * (x.1 - plane_a).value(), angle)
        });
        let (again, scale) = rotor::along_first(&arms.collect::<Vec<_>>());
        let what = "couple by components along the first mass and across it";
        sheet.check_sum(what, couple, (again * spun).into(), scale * spun);
    });
}
