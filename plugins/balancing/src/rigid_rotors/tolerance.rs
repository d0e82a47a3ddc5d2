//! Balance quality grade and permissible residual unbalance (ISO 21940-11), and conformity of what was measured.

// Long because every machine of the list of grades is an alternative with its own grade.

use std::f64::consts::TAU;

use dalembert_core::{
    About, Analysis, Axis, Cell, Column, Drawing, Exhibit, Ink, Inputs, Plot, Refusal, Series, Sketch,
    TableExhibit, Text, Worksheet, register,
};
use dalembert_mechanics::{
    Real,
    balance::{self, PlaneUnbalance},
};

use crate::{
    shared::{rotor, tolerance},
    sources::{ISO_TOLERANCES, MIL_STD_167},
};

/// The rotor, its speed, and what is demanded of it.
#[derive(Clone, Debug, Inputs)]
pub struct Tolerance {
    /// Requirement.
    pub criterion: Criterion,
    /// Mass of the rotor.
    #[input("m", "kg", positive)]
    pub mass: f64,
    /// Service speed.
    #[input("Ω", "rpm", positive)]
    pub speed: f64,
    /// Tolerance planes.
    pub planes: Planes,
    /// Residual unbalance that was measured.
    pub residual: Residual,
    /// Trial weight.
    pub trial: Option<Trial>,
    /// Gravity.
    /// Reference weight for the forces.
    #[input("g", "m/s^2", positive, default = "9.81 m/s^2", default_before = "9.80665 m/s^2")]
    pub gravity: f64,
}

/// A demand on the balance of a rotor.
#[derive(Clone, Debug, Inputs)]
pub enum Criterion {
    /// Balance quality grade
    Grade {
        /// Grade.
        /// Speed of the centre of mass: G 6.3 is 6.3 mm/s.
        #[input("G", "mm/s", positive, grade, default = "6.3 mm/s")]
        grade: f64,
    },
    /// Kind of machine
    Machine {
        /// Machine.
        machine: MachineClass,
    },
    /// Specific unbalance
    Specific {
        /// Permissible displacement of the centre of mass.
        #[input("e", "µm", positive)]
        displacement: f64,
    },
    /// Total unbalance
    Total {
        /// Permissible residual unbalance.
        #[input("U", "g*mm", positive)]
        unbalance: f64,
    },
    /// US Navy, MIL-STD-167-1: ounce-inches per pound at one revolution per minute
    /// U = 4 W/N above 1000 rpm.
    Navy {
        /// Constant.
        #[input("k", "oz*in*rpm/lb", positive, default = "4 oz*in*rpm/lb")]
        constant: f64,
    },
}

/// Machines and the grades that are customary for them; the grade may be changed.
#[derive(Clone, Debug, Inputs)]
pub enum MachineClass {
    /// Gyroscopes, spindles and drives of high precision
    Precision {
        /// Grade.
        #[input("G", "mm/s", positive, grade, default = "0.4 mm/s")]
        grade: f64,
    },
    /// Drives of grinding machines, audio and video drives
    Grinding {
        /// Grade.
        #[input("G", "mm/s", positive, grade, default = "1 mm/s")]
        grade: f64,
    },
    /// Steam and gas turbines, compressors, machine-tool drives, larger motors above 950 rpm
    Turbine {
        /// Grade.
        #[input("G", "mm/s", positive, grade, default = "2.5 mm/s")]
        grade: f64,
    },
    /// Fans, pumps, gears, general machinery, small motors, water turbines, turbochargers
    General {
        /// Grade.
        #[input("G", "mm/s", positive, grade, default = "6.3 mm/s")]
        grade: f64,
    },
    /// Agricultural machines, crushers, cardan shafts, balanced and rigidly mounted crankshafts
    Agricultural {
        /// Grade.
        #[input("G", "mm/s", positive, grade, default = "16 mm/s")]
        grade: f64,
    },
    /// Wheels and drive shafts of cars, balanced and elastically mounted crankshafts
    Car {
        /// Grade.
        #[input("G", "mm/s", positive, grade, default = "40 mm/s")]
        grade: f64,
    },
    /// Complete piston engines of cars, lorries and locomotives
    Engine {
        /// Grade.
        #[input("G", "mm/s", positive, grade, default = "100 mm/s")]
        grade: f64,
    },
    /// Unbalanced and rigidly mounted crankshafts
    RigidCrankshaft {
        /// Grade.
        #[input("G", "mm/s", positive, grade, default = "250 mm/s")]
        grade: f64,
    },
    /// Unbalanced and elastically mounted crankshafts
    ElasticCrankshaft {
        /// Grade.
        #[input("G", "mm/s", positive, grade, default = "630 mm/s")]
        grade: f64,
    },
    /// Balanced crankshafts of large slow marine engines
    BalancedMarine {
        /// Grade.
        #[input("G", "mm/s", positive, grade, default = "1600 mm/s")]
        grade: f64,
    },
    /// Unbalanced crankshafts of large slow marine engines
    UnbalancedMarine {
        /// Grade.
        #[input("G", "mm/s", positive, grade, default = "4000 mm/s")]
        grade: f64,
    },
}

/// Planes to which the tolerance applies.
#[derive(Clone, Debug, Inputs)]
pub enum Planes {
    /// One plane
    /// A disc between closely spaced bearings: the couple unbalance is not assessed.
    One,
    /// Both bearing planes
    /// The centre of mass may lie between the bearings or outside.
    Bearings {
        /// Position of bearing A.
        #[input("z_A", "mm", default = "0 mm")]
        first: f64,
        /// Position of bearing B.
        #[input("z_B", "mm")]
        second: f64,
        /// Position of the centre of mass.
        #[input("z_G", "mm")]
        centre: f64,
    },
}

/// Measured quantity.
#[derive(Clone, Debug, Inputs)]
pub enum Residual {
    /// Nothing
    None,
    /// Unbalances in measuring planes
    Measured {
        /// Unbalances.
        #[input(min = 1)]
        unbalances: Vec<MeasuredUnbalance>,
    },
    /// A static unbalance and a couple
    StaticCouple {
        /// Static unbalance.
        #[input("U_s", "g*mm", nonnegative)]
        unbalance: f64,
        /// Its angle.
        #[input("θ_s", "deg", default = "0 deg")]
        angle: f64,
        /// Its position.
        /// Along the shaft, from the same origin as the bearings.
        #[input("z_s", "mm")]
        position: f64,
        /// Couple unbalance.
        /// One of the two opposite unbalances times their distance.
        #[input("K", "g*mm^2", nonnegative)]
        couple: f64,
        /// Angle of the couple.
        /// Angle of its unbalance on the side of bearing B.
        #[input("θ_K", "deg", default = "0 deg")]
        couple_angle: f64,
    },
}

/// An unbalance as a balancing machine shows it.
#[derive(Clone, Debug, Inputs)]
pub struct MeasuredUnbalance {
    /// Unbalance.
    #[input("U", "g*mm", nonnegative)]
    pub unbalance: f64,
    /// Angle.
    #[input("θ", "deg", default = "0 deg")]
    pub angle: f64,
    /// Position.
    /// Along the shaft, from the same origin as the bearings.
    #[input("z", "mm", default = "0 mm")]
    pub position: f64,
}

/// A mass to begin balancing with.
#[derive(Clone, Debug, Inputs)]
pub struct Trial {
    /// Its force over the weight that its plane carries.
    #[input("q", "%", positive, default = "10 %")]
    pub share: f64,
    /// Radius of its position.
    #[input("r_t", "mm", positive)]
    pub radius: f64,
}

register!(Tolerance);

impl Tolerance {
    /// The rotor on its shaft from the side, with the planes of its tolerance at the bearings.
    fn drawing(&self) -> Drawing {
        let mut sketch = Sketch::new("The rotor and its tolerance planes");
        let (first, second, centre) = match self.planes {
            Planes::One => (-1.0, 1.0, 0.0),
            Planes::Bearings { first, second, centre } => (first, second, centre),
        };
        let (low, high) = (first.min(second).min(centre).min(0.0), first.max(second).max(centre).max(0.0));
        let at = |z: f64| 4.0 * (z - low) / (high - low).max(f64::MIN_POSITIVE);
        let [left, right, middle] = [first, second, centre].map(at);
        let (from, to) = (left.min(right), left.max(right));
        sketch
            .size(5.0)
            .link("", (-0.5, 0.0), (4.5, 0.0))
            .mass("", (from + 0.2 * (to - from), -0.8), (from + 0.8 * (to - from), 0.8))
            .bearing("A", (left, 0.0), 0.0)
            .bearing("B", (right, 0.0), 0.0)
            .mass_centre("G, m", (middle, 0.0))
            .couple("Ω", (4.5, 0.0), (-1.2, 1.2), Ink::Motion);
        if let Planes::Bearings { .. } = self.planes {
            let mut row = 0.0;
            for (z, name) in [(first, "z_A"), (centre, "z_G"), (second, "z_B")] {
                if z != 0.0 {
                    row += 1.0;
                    sketch.dimension(name, (at(0.0), -0.9), (at(z), -0.9), -2.4 * row * z.signum());
                }
            }
        }
        sketch.finish()
    }
}

impl Analysis for Tolerance {
    const ABOUT: About = About {
        id: "balancing/tolerance",
        title: "Balance tolerances",
        topic: "Rigid rotors",
        summary: "Permissible residual unbalance by the balance quality grades of ISO 21940-11, its allocation to two planes, and the conformity of a measured residual unbalance.",
        main: &["permissible", "permissible_a", "permissible_b", "grade", "trial_mass"],
        keywords: "iso 1940 21940 grau de qualidade de balanceamento G 2.5 G 6.3 G16 desbalanceamento residual \
                   admissível tolerância permissible residual unbalance quality grade oz in 4W/N mil-std-167 api \
                   trial mass massa de teste NBR 8008 API 610 617",
        sources: &[&ISO_TOLERANCES, &MIL_STD_167],
        cases: include_str!("../../cases/tolerance.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &ToleranceGiven<W>, sheet: W) -> Result<(), Refusal> {
        if let Planes::Bearings { first, second, .. } = self.planes
            && first == second
        {
            return Err(Refusal::because(
                "both bearings are at the same position; give them different positions, or use one plane",
            ));
        }
        let (total, displacement) = permissible(given, sheet);
        sheet.answer("specific", "Permissible specific unbalance", displacement);
        sheet.answer("permissible", "Permissible residual unbalance", total);
        let grade = sheet.step(
            "G_Ω",
            "mm/s",
            displacement * given.speed,
            ("Speed of the centre of mass: the grade", ISO_TOLERANCES.at("")),
        );
        sheet.answer("grade", "Grade", grade);
        let customary = sheet.step("U_US", "oz*in", total * 1.0, "The same in ounce-inches");
        sheet.answer("permissible_us", "Permissible residual unbalance in ounce-inches", customary);
        let force = balance::centrifugal_force(total, given.speed);
        let force = sheet.step("F", "N", force, "Rotating force of the permissible unbalance");
        let ratio =
            sheet.step("F_W", "1", force / (given.mass * given.gravity), "This force over the weight");
        sheet.answer("force", "Rotating force of the permissible unbalance", force);
        sheet.answer("force_ratio", "This force over the weight", ratio);
        sheet.check("the force from mass, grade and speed", force, given.mass * grade * given.speed);
        sheet.check(
            "acceleration of the centre of mass over gravity",
            ratio,
            displacement * given.speed.powi(2) / given.gravity,
        );

        let limits = match &given.planes {
            PlanesGiven::One {} => None,
            PlanesGiven::Bearings { first, second, centre } => {
                Some(shares(total, (*first, *second, *centre), sheet))
            }
        };
        let measured = self.measured(given, total, limits, sheet);
        if let Some(trial) = &given.trial {
            let planes = if limits.is_some() { 2 } else { 1 };
            let carried = 1.0 / planes as f64;
            let rotor = (given.mass, given.gravity, given.speed);
            let unbalance = tolerance::trial_unbalance(trial.share, rotor, planes, sheet);
            let mass = sheet.step("m_t", "g", unbalance / trial.radius, "Trial weight at its radius");
            sheet.answer("trial_unbalance", "Trial unbalance", unbalance);
            sheet.answer("trial_mass", "Trial weight", mass);
            sheet.check(
                "trial unbalance over the permissible one, as their forces over the weight",
                mass * trial.radius * ratio,
                total * trial.share * carried,
            );
        }
        if matches!(self.criterion, Criterion::Navy { .. }) && self.speed < 1000.0 * TAU / 60.0 {
            sheet.warn(|| {
                Text::new("4 W/N holds above 1000 rpm; from 150 to 1000 rpm the standard has 4000 W/N², below that 0.177 W")
            });
        }
        let (speed, mass) = (self.speed, self.mass);
        let residual = measured.as_ref().map(|all| all.total / mass);
        sheet.show(|| Exhibit::Drawing(self.drawing()));
        sheet.show(|| Exhibit::Plot(chart(speed, displacement.value(), residual)));
        if let Some(measured) = measured {
            sheet.show(|| Exhibit::Table(measured.table(total.value())));
        }
        sheet.show(|| Exhibit::Table(grades(speed)));
        Ok(())
    }
}

/// The total permissible unbalance, and over the mass.
fn permissible<W: Worksheet>(given: &ToleranceGiven<W>, sheet: W) -> (W::Num, W::Num) {
    let by_grade = |grade: W::Num| tolerance::by_grade(grade, given.mass, given.speed, sheet);
    match &given.criterion {
        CriterionGiven::Grade { grade } => by_grade(*grade),
        CriterionGiven::Machine { machine } => by_grade(machine.grade()),
        CriterionGiven::Specific { displacement } => {
            let displacement = sheet.step("e_per", "µm", *displacement * 1.0, "Required specific unbalance");
            (tolerance::whole(displacement, given.mass, sheet), displacement)
        }
        CriterionGiven::Total { unbalance } => {
            let total = sheet.step("U_per", "g*mm", *unbalance * 1.0, "Required unbalance");
            (total, sheet.step("e_per", "µm", total / given.mass, "Unbalance over mass"))
        }
        CriterionGiven::Navy { constant } => {
            let why = ("Ounce-inches per pound, inversely proportional to the speed", MIL_STD_167.at(""));
            let total = sheet.step("U_per", "g*mm", *constant * given.mass / given.speed, why);
            (total, sheet.step("e_per", "µm", total / given.mass, "Unbalance over mass"))
        }
    }
}

impl<W: Worksheet> MachineClassGiven<W> {
    fn grade(&self) -> W::Num {
        match self {
            MachineClassGiven::Precision { grade }
            | MachineClassGiven::Grinding { grade }
            | MachineClassGiven::Turbine { grade }
            | MachineClassGiven::General { grade }
            | MachineClassGiven::Agricultural { grade }
            | MachineClassGiven::Car { grade }
            | MachineClassGiven::Engine { grade }
            | MachineClassGiven::RigidCrankshaft { grade }
            | MachineClassGiven::ElasticCrankshaft { grade }
            | MachineClassGiven::BalancedMarine { grade }
            | MachineClassGiven::UnbalancedMarine { grade } => *grade,
        }
    }
}

/// The permissible unbalances in the planes of the bearings.
fn shares<W: Worksheet>(
    total: W::Num,
    (first, second, centre): (W::Num, W::Num, W::Num),
    sheet: W,
) -> [W::Num; 2] {
    let span = second - first;
    let inside = (centre.value() - first.value()) * (centre.value() - second.value()) <= 0.0;
    let most = if inside { 0.7 } else { 1.3 };
    let mut limited = false;
    let mut one = |symbol, arm: W::Num| {
        let share = (arm / span).abs();
        let (value, why) = if share.value() < 0.3 {
            limited = true;
            (total * 0.3, "At least 0.3 of the total for a plane")
        } else if share.value() > most {
            limited = true;
            let why = if inside {
                "At most 0.7 of the total for a plane between the bearings"
            } else {
                "At most 1.3 of the total for a plane of an overhung rotor"
            };
            (total * most, why)
        } else {
            (
                total * share,
                "The share falls with the distance from the centre of mass, as that of the weight",
            )
        };
        sheet.common_error(symbol, "half of the total taken for each plane", || total / 2.0);
        if !(0.3..=most).contains(&share.value()) {
            sheet.common_error(symbol, "the limits of the shares not applied", || total * share);
        }
        sheet.step(symbol, "g*mm", value, (why, ISO_TOLERANCES.at("")))
    };
    let in_first = one("U_perA", second - centre);
    let in_second = one("U_perB", centre - first);
    sheet.answer("permissible_a", "Permissible residual unbalance at bearing A", in_first);
    sheet.answer("permissible_b", "Permissible residual unbalance at bearing B", in_second);
    if limited {
        sheet.warn(|| {
            Text::new("the centre of mass is near a bearing or outside: a limit of the shares applies")
        });
    } else if inside {
        sheet.check("the sum of the shares is the total", in_first + in_second, total);
    } else {
        let difference = (in_first.value() - in_second.value()).abs();
        sheet.check("the difference of the shares is the total", difference.into(), total.value().into());
    }
    [in_first, in_second]
}

/// Measured unbalance for comparison with the tolerance.
struct Judged {
    total: f64,
    /// Residual and permissible unbalance at each bearing.
    at_bearings: Option<[(f64, f64); 2]>,
}

impl Tolerance {
    /// The measured unbalance, in one plane or stated at the bearings, over what is permitted.
    fn measured<W: Worksheet>(
        &self,
        given: &ToleranceGiven<W>,
        permissible: W::Num,
        limits: Option<[W::Num; 2]>,
        sheet: W,
    ) -> Option<Judged> {
        let mut unbalances: Vec<[W::Num; 3]> = Vec::new();
        let mut couple = None;
        let mut polar = Vec::new();
        match &given.residual {
            ResidualGiven::None {} => return None,
            ResidualGiven::Measured { unbalances: all } => {
                for (n, u) in (1..).zip(all) {
                    unbalances.push(components(sheet, n, u.unbalance, u.angle, u.position));
                    polar.push((u.unbalance.value(), u.angle.value()));
                }
            }
            ResidualGiven::StaticCouple { unbalance, angle, position, couple: size, couple_angle } => {
                unbalances.push(components(sheet, 1, *unbalance, *angle, *position));
                polar.push((unbalance.value(), angle.value()));
                let why = "Couple unbalance along x and y";
                couple = Some([
                    sheet.step("K_x", "g*mm^2", *size * couple_angle.cos(), why),
                    sheet.step("K_y", "g*mm^2", *size * couple_angle.sin(), why),
                ]);
            }
        }
        let sum = |axis: usize| balance::resultant(unbalances.iter().map(|u| u[axis]));
        let what = "the measured unbalances added as numbers, their angles ignored";
        sheet.common_error("U_res", what, || {
            W::Num::sum(unbalances.iter().map(|u| balance::magnitude(u[0], u[1])))
        });
        let total =
            sheet.step("U_res", "g*mm", balance::magnitude(sum(0), sum(1)), "Static residual unbalance");
        sheet.answer("static_residual", "Static residual unbalance", total);
        sheet.verify(|| {
            let (squared, scale) = rotor::by_pairs(&polar);
            let what = "square of the static unbalance by the law of cosines over all pairs";
            sheet.check_sum(what, total.powi(2), squared.into(), scale);
        });
        let mut judged = Judged { total: total.value(), at_bearings: None };
        match (limits, &given.planes) {
            (Some([in_first, in_second]), PlanesGiven::Bearings { first, second, .. }) => {
                let (first, second) = (*first, *second);
                let [x, y] = [0, 1].map(|axis: usize| {
                    let all = || unbalances.iter().map(|u| (u[axis], u[2]));
                    let mut one = balance::equivalent_in_first(all(), first, second);
                    let mut other = balance::equivalent_in_second(all(), first, second);
                    if let Some(couple) = couple {
                        one = one - couple[axis] / (second - first);
                        other = other + couple[axis] / (second - first);
                    }
                    let (one_symbol, other_symbol) =
                        if axis == 0 { ("U_Ax", "U_Bx") } else { ("U_Ay", "U_By") };
                    let why = "Measured unbalances transferred to bearing plane A";
                    let one = sheet.step(one_symbol, "g*mm", one, why);
                    let why = "Measured unbalances transferred to bearing plane B";
                    (one, sheet.step(other_symbol, "g*mm", other, why))
                });
                let size = |symbol, x, y, why: &'static str| {
                    sheet.step(symbol, "g*mm", balance::magnitude(x, y), why)
                };
                let one = size("U_A", x.0, y.0, "Residual unbalance at bearing A");
                let other = size("U_B", x.1, y.1, "Residual unbalance at bearing B");
                sheet.answer("residual_a", "Residual unbalance at bearing A", one);
                sheet.answer("residual_b", "Residual unbalance at bearing B", other);
                self.check_equivalents(
                    [x, y].map(|(a, b)| [a.value(), b.value()]),
                    [one, other],
                    &unbalances,
                    couple,
                    sheet,
                );
                let ratio = |symbol, residual: W::Num, permitted: W::Num| {
                    sheet.step(
                        symbol,
                        "1",
                        residual / permitted,
                        "Residual over permissible unbalance: 1 at most",
                    )
                };
                let (ratio_a, ratio_b) = (ratio("q_A", one, in_first), ratio("q_B", other, in_second));
                sheet.answer("ratio_a", "Residual over permissible unbalance at bearing A", ratio_a);
                sheet.answer("ratio_b", "Residual over permissible unbalance at bearing B", ratio_b);
                for (plane, ratio) in [("A", ratio_a), ("B", ratio_b)] {
                    if ratio.value() > 1.0 {
                        sheet.warn(|| exceeded(plane, ratio.value()));
                    }
                }
                judged.at_bearings =
                    Some([(one.value(), in_first.value()), (other.value(), in_second.value())]);
            }
            _ => {
                let why = "Residual over permissible unbalance: 1 at most";
                let ratio = sheet.step("q_r", "1", total / permissible, why);
                sheet.answer("ratio", "Residual over permissible unbalance", ratio);
                if ratio.value() > 1.0 {
                    sheet.warn(|| exceeded("", ratio.value()));
                }
            }
        }
        Some(judged)
    }

    /// The same by the corrections in the planes of the bearings: the opposites of what is there.
    fn check_equivalents<W: Worksheet>(
        &self,
        [x, y]: [[f64; 2]; 2],
        sizes: [W::Num; 2],
        unbalances: &[[W::Num; 3]],
        couple: Option<[W::Num; 2]>,
        sheet: W,
    ) {
        let Planes::Bearings { first, second, .. } = self.planes else { return };
        sheet.verify(|| {
            let mut all: Vec<PlaneUnbalance> = unbalances
                .iter()
                .map(|[x, y, z]| PlaneUnbalance { position: z.value(), components: [x.value(), y.value()] })
                .collect();
            if let Some(couple) = couple {
                // Any pair of opposite unbalances: here in planes twice as far apart as the bearings.
                let pair = couple.map(|k| k.value() / (2.0 * (second - first)));
                let far = 2.0 * second - first;
                all.push(PlaneUnbalance { position: first, components: pair.map(|u| -u) });
                all.push(PlaneUnbalance { position: far, components: pair });
            }
            let scale: f64 = all.iter().map(|u| u.components[0].hypot(u.components[1])).sum();
            let reach = all.iter().map(|u| (u.position - first).abs()).fold((second - first).abs(), f64::max);
            let Ok(corrections) = balance::balance_two_planes(&all, [first, second]) else { return };
            for (size, [u, v]) in sizes.into_iter().zip([corrections.in_a, corrections.in_b]) {
                sheet.check_sum(
                    "the unbalance transferred to a bearing plane has the magnitude of the correction needed there",
                    size,
                    u.hypot(v).into(),
                    scale * reach / (second - first).abs(),
                );
            }
            for axis in 0..2 {
                let ours = [x, y][axis];
                let theirs = [corrections.in_a[axis], corrections.in_b[axis]];
                for (ours, correction) in ours.into_iter().zip(theirs) {
                    sheet.check_zero(
                        "the unbalance transferred to the bearing planes is the opposite of the correction needed there",
                        (ours + correction).into(),
                        scale * reach / (second - first).abs(),
                    );
                }
            }
        });
    }
}

/// Components and position of a measured unbalance.
fn components<W: Worksheet>(
    sheet: W,
    row: usize,
    size: W::Num,
    angle: W::Num,
    position: W::Num,
) -> [W::Num; 3] {
    let why = "Measured unbalance along x and y";
    let x = sheet.step(("U_x", row), "g*mm", size * angle.cos(), why);
    let y = sheet.step(("U_y", row), "g*mm", size * angle.sin(), why);
    [x, y, position]
}

fn exceeded(plane: &'static str, ratio: f64) -> Text {
    let times = format!("{ratio:.2}");
    if plane.is_empty() {
        Text::new("the residual unbalance is {times} times the permissible: balance further")
            .with("times", times)
    } else {
        Text::new(
            "at bearing {plane} the residual unbalance is {times} times the permissible: balance further",
        )
        .with("plane", plane)
        .with("times", times)
    }
}

impl Judged {
    fn table(&self, permissible: f64) -> TableExhibit {
        let column = |heading: &'static str, unit| Column { heading: heading.into(), unit };
        let row = |name: &'static str, (residual, permitted): (f64, f64)| -> Vec<Cell> {
            let verdict = if residual <= permitted { "within tolerance" } else { "out of tolerance" };
            vec![name.into(), residual.into(), permitted.into(), verdict.into()]
        };
        let rows = match self.at_bearings {
            None => vec![row("one plane", (self.total, permissible))],
            Some([a, b]) => vec![row("bearing A", a), row("bearing B", b)],
        };
        TableExhibit {
            title: "Residual and permissible unbalance".into(),
            columns: vec![
                column("", ""),
                column("residual unbalance", "g*mm"),
                column("permissible", "g*mm"),
                column("conformity", ""),
            ],
            rows,
            foot: Vec::new(),
        }
    }
}

/// Grades, mm/s, and the machines they are customary for.
const GRADES: [(f64, &str); 11] = [
    (0.4, "Gyroscopes, spindles and drives of high precision"),
    (1.0, "Drives of grinding machines, audio and video drives"),
    (2.5, "Steam and gas turbines, compressors, machine-tool drives, larger motors above 950 rpm"),
    (6.3, "Fans, pumps, gears, general machinery, small motors, water turbines, turbochargers"),
    (16.0, "Agricultural machines, crushers, cardan shafts, balanced and rigidly mounted crankshafts"),
    (40.0, "Wheels and drive shafts of cars, balanced and elastically mounted crankshafts"),
    (100.0, "Complete piston engines of cars, lorries and locomotives"),
    (250.0, "Unbalanced and rigidly mounted crankshafts"),
    (630.0, "Unbalanced and elastically mounted crankshafts"),
    (1600.0, "Balanced crankshafts of large slow marine engines"),
    (4000.0, "Unbalanced crankshafts of large slow marine engines"),
];

fn grades(speed: f64) -> TableExhibit {
    let column = |heading: &'static str, unit| Column { heading: heading.into(), unit };
    TableExhibit {
        title: "Balance quality grades, and the specific unbalance at this speed".into(),
        columns: vec![column("G", "mm/s"), column("e_per", "µm"), column("machines", "")],
        rows: GRADES
            .iter()
            .map(|(grade, machines)| {
                let si = grade * 1e-3;
                vec![si.into(), (si / speed).into(), Cell::Text(Text::new(*machines))]
            })
            .collect(),
        foot: Vec::new(),
    }
}

/// Specific unbalance against speed: the grades about the one demanded, what is permitted and what is there.
fn chart(speed: f64, permissible: f64, residual: Option<f64>) -> Plot {
    let grade = permissible * speed * 1e3;
    let near = GRADES.iter().filter(|(g, _)| *g > grade / 50.0 && *g < grade * 50.0);
    let ends = [speed / 10.0, speed * 10.0];
    let line = |(g, _): &(f64, &str)| {
        let label = Text::new("G {grade}").with("grade", g);
        let line = Series::line(label, ends.map(|w| (w, g * 1e-3 / w)).to_vec());
        line.of("specific").with("criterion.grade.grade", g * 1e-3)
    };
    let plot = Plot::new(
        "Permissible specific unbalance against speed",
        Axis::log("Speed", "rpm"),
        Axis::log("Specific unbalance", "µm"),
        near.map(line).collect(),
    )
    .over("speed");
    let plot = plot.mark("permissible", (speed, permissible));
    match residual {
        Some(residual) if residual > 0.0 => plot.mark("measured unbalance", (speed, residual)),
        _ => plot,
    }
}
