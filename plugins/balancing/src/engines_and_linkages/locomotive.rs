//! Locomotives with two cylinders: partial balance, hammer blow, tractive effort, swaying couple.

use std::f64::consts::PI;

use dalembert_core::{About, Analysis, Exhibit, Inputs, Refusal, Text, Worksheet, register};
use dalembert_mechanics::{
    Real,
    balance::{self, locomotive as engine, reciprocating},
};

use crate::{
    shared::{crank::Throw, rotor},
    sources::{BEVAN, KHURMI},
};

mod pictures;

/// A locomotive with two cylinders.
#[derive(Clone, Debug, Inputs)]
pub struct Locomotive {
    /// Reciprocating mass of a cylinder.
    #[input("m", "kg", positive)]
    pub reciprocating: f64,
    /// Rotating mass at each crank pin.
    #[input("m_r", "kg", nonnegative, default = "0 kg")]
    pub rotating: f64,
    /// Crank.
    pub throw: Throw,
    /// Distance between the lines of stroke.
    /// Less than that of the wheels for inside cylinders, more for outside ones.
    #[input("a", "m", positive)]
    pub cylinders: f64,
    /// Distance between the planes of the wheels.
    #[input("w", "m", positive)]
    pub wheels: f64,
    /// Angle from the first crank to the second.
    #[input("α", "deg", default = "90 deg")]
    pub between: f64,
    /// Balance of the reciprocating masses.
    pub balance: Balance,
    /// Radius of the balance masses in the wheels.
    #[input("b", "m", positive)]
    pub radius: Option<f64>,
    /// Diameter of the wheels.
    /// For the speed on the rails.
    #[input("D", "m", positive)]
    pub diameter: Option<f64>,
    /// Running.
    pub running: Running,
    /// Dead load on each wheel.
    /// For the speed at which a wheel leaves the rail.
    #[input("P", "kN", positive)]
    pub load: Option<f64>,
    /// Coupled wheels.
    pub coupled: Option<CoupledWheels>,
}

/// Balanced fraction of the reciprocating masses, or the limit that determines it.
#[derive(Clone, Debug, Inputs)]
pub enum Balance {
    /// Fraction given
    Fraction {
        /// Balanced fraction of the reciprocating mass.
        #[input("c", "1", min = 0.0, max = 1.0)]
        fraction: f64,
    },
    /// Hammer blow given, fraction required
    HammerBlow {
        /// Hammer blow of a wheel.
        #[input("H", "kN", positive)]
        blow: f64,
    },
}

/// Speed of travel or of the wheels.
#[derive(Clone, Debug, Inputs)]
pub enum Running {
    /// Speed of the train
    Train {
        /// Speed of the train.
        #[input("v", "km/h", positive)]
        speed: f64,
    },
    /// Speed of the wheels
    Wheel {
        /// Speed of the wheels.
        #[input("ω", "rpm", positive)]
        speed: f64,
    },
    /// At the speed at which a wheel begins to lift
    Limit,
}

/// Wheels coupled to the driving ones.
#[derive(Clone, Debug, Inputs)]
pub struct CoupledWheels {
    /// Axles that share the balance of the reciprocating masses.
    /// The driving axle is one of them.
    #[input(min = 1, max = 8)]
    pub axles: usize,
    /// Mass of the coupling rods at each pin.
    #[input("m_k", "kg", nonnegative, default = "0 kg")]
    pub mass: f64,
    /// Radius of the coupling pins.
    #[input("r_k", "m", positive)]
    pub radius: f64,
    /// Distance between the coupling rods.
    #[input("a_k", "m", positive)]
    pub apart: f64,
    /// Angle from each crank to its coupling pin.
    /// 180° for inside cylinders as a rule, 0° for outside ones.
    #[input("ε", "deg", default = "180 deg")]
    pub angle: f64,
}

register!(Locomotive);

impl Analysis for Locomotive {
    const ABOUT: About = About {
        id: "balancing/locomotive",
        title: "Partial balance of locomotives",
        topic: "Engines and linkages",
        summary: "Balance masses in the wheels of a locomotive with two cylinders, hammer blow, limit speed, variation of tractive effort and swaying couple.",
        main: &["mass", "angle", "hammer_blow", "tractive"],
        keywords: "locomotiva balanceamento parcial golpe de martelo esforço de tração conjugado de balanço rodas acopladas \
                   locomotive inside outside cylinders hammer blow tractive effort swaying couple limit speed",
        sources: &[&KHURMI, &BEVAN],
        cases: include_str!("../../cases/locomotive.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &LocomotiveGiven<W>, sheet: W) -> Result<(), Refusal> {
        let crank = given.throw.radius(sheet);
        let cite = BEVAN.at("ch. 14");
        let near = engine::near_share(given.wheels, given.cylinders);
        let near = sheet.step("f", "1", near, ("Share of a cylinder in the wheel of its own side", cite));
        let far = engine::far_share(given.wheels, given.cylinders);
        let far = sheet.step("f′", "1", far, ("Share of a cylinder in the wheel of the other side", cite));
        let between = given.between;
        // Balance of unit masses at the cranks, from the first crank.
        let of_wheels = [(near, far), (far, near)];
        let (x, y) = (far * between.cos() + near, far * between.sin());
        let why = "Effect on one wheel of equal masses at both cranks, relative to that of one";
        let share = sheet.step("e", "1", balance::magnitude(x, y), (why, cite));
        if share.value() <= 1e-12 {
            return Err(Refusal::because(
                "the cylinders balance each other in both wheels, so there is nothing to balance; check the angle between the cranks",
            ));
        }
        let axles = self.coupled.as_ref().map_or(1, |coupled| coupled.axles).max(1) as f64;
        let product =
            sheet.step("U", "kg*m", given.reciprocating * crank, "Reciprocating mass times crank radius");
        let wheel_speed = self.wheel_speed(given, sheet)?;
        let fraction = match (&given.balance, wheel_speed) {
            (BalanceGiven::Fraction { fraction }, _) => *fraction,
            (BalanceGiven::HammerBlow { blow }, Some(speed)) => {
                let whole = product * share * speed.powi(2);
                let fraction = if axles == 1.0 { *blow / whole } else { *blow * axles / whole };
                let why = ("Fraction whose vertical component causes the hammer blow", KHURMI.at("ch. 22"));
                sheet.common_error("c", WITH_ROTATING, || {
                    fraction - given.rotating * axles / given.reciprocating
                });
                sheet.step("c", "1", fraction, why)
            }
            (BalanceGiven::HammerBlow { .. }, None) => {
                return Err(Refusal::because(
                    "a hammer blow fixes the fraction only at a known speed; give the speed of the train or of the wheels",
                ));
            }
        };
        if fraction.value() > 1.0 {
            return Err(Refusal::because(
                Text::new(
                    "the hammer blow would require balancing {times} times the whole reciprocating mass; give a smaller one, or a higher speed",
                )
                .with("times", format!("{:.3}", fraction.value())),
            ));
        }
        sheet.answer(
            "fraction",
            "Balanced fraction of the reciprocating mass",
            fraction_step(given, fraction, sheet),
        );
        let lifting = self.limit(given, product, fraction, share, axles, sheet);
        let Some(speed) = wheel_speed.or(lifting) else {
            return Err(Refusal::because(
                "the speed where a wheel begins to lift needs the dead load of a wheel and a balanced fraction above 0; give them, or another speed",
            ));
        };
        let placed = self.balance_masses(given, crank, fraction, axles, of_wheels, sheet);
        let blow = product * fraction * share * speed.powi(2);
        let blow = if axles == 1.0 { blow } else { blow / axles };
        let why = (
            "Hammer blow: the vertical component of the balance of the reciprocating masses is not opposed",
            KHURMI.at("ch. 22"),
        );
        let whole = || given.rotating + fraction * given.reciprocating / axles;
        sheet.common_error("H_max", WITH_ROTATING, || whole() * crank * share * speed.powi(2));
        let blow = sheet.step("H_max", "N", blow, why);
        sheet.answer("hammer_blow", "Hammer blow of a wheel", blow);
        // Moments about the other wheel of the part of the reciprocating masses that is balanced at both cranks.
        let vertical = |at: f64| {
            let pull = product.value() * fraction.value() / axles * speed.value().powi(2);
            let arms = [self.wheels + self.cylinders, self.wheels - self.cylinders];
            pull * (arms[0] * at.cos() + arms[1] * (at + self.between).cos()) / (2.0 * self.wheels)
        };
        sheet.verify(|| {
            let (_, most) = reciprocating::largest(|at| [vertical(at), 0.0]);
            let scale = most * (1.0 + self.cylinders / self.wheels) / share.value();
            let what = "maximum vertical force of the balance masses over a revolution";
            sheet.check_sum(what, blow, most.into(), scale);
        });
        if let Some(load) = given.load {
            let most = sheet.step("R_max", "N", load + blow, "Maximum load of a wheel on the rail");
            let least = sheet.step("R_min", "N", load - blow, "Minimum load of a wheel on the rail");
            sheet.answer("load_max", "Maximum load of a wheel on the rail", most);
            sheet.answer("load_min", "Minimum load of a wheel on the rail", least);
            sheet.verify(|| {
                let (at, _) = reciprocating::largest(|at| [vertical(at), 0.0]);
                let parts = [vertical(at), vertical(at + PI)];
                let scale =
                    load.value() + blow.value() * (1.0 + self.cylinders / self.wheels) / share.value();
                let above = load.value() + parts[0].max(parts[1]);
                sheet.check_sum("load of a wheel where that force is largest", most, above.into(), scale);
                let below = load.value() + parts[0].min(parts[1]);
                sheet.check_sum("load of a wheel 180° from that position", least, below.into(), scale);
            });
            if least.value() < -1e-9 * load.value() {
                sheet.warn(|| {
                    Text::new(
                        "the hammer blow exceeds the dead load: the wheel leaves the rail once per revolution",
                    )
                });
            }
        }
        let unbalanced = (W::Num::from(1.0) - fraction) * product * speed.powi(2);
        let why = "Unbalanced reciprocating force of a cylinder";
        sheet.common_error("F_u", "the rotating mass counted as a reciprocating one", || {
            (W::Num::from(1.0) - fraction) * (given.reciprocating + given.rotating) * crank * speed.powi(2)
        });
        let unbalanced = sheet.step("F_u", "N", unbalanced, (why, KHURMI.at("ch. 22")));
        let tractive = unbalanced * engine::sum_of_cranks(between);
        let why = ("Maximum of (1 − c) m r ω² (cos θ + cos(θ + α)) over a revolution", KHURMI.at("ch. 22"));
        sheet.common_error("F_T", "both cranks taken in phase", || unbalanced * 2.0);
        let tractive = sheet.step("F_T", "N", tractive, why);
        sheet.answer("tractive", "Variation of tractive effort (±)", tractive);
        let sway = unbalanced * given.cylinders / 2.0 * engine::crank_difference(between);
        let why =
            ("Maximum of (1 − c) m r ω² (a/2)(cos θ − cos(θ + α)) over a revolution", KHURMI.at("ch. 22"));
        let sway = sheet.step("C_S", "N*m", sway, why);
        sheet.answer("sway", "Swaying couple (±)", sway);
        let (force, apart, angle) = (unbalanced.value(), self.cylinders, self.between);
        sheet.verify(|| {
            let (_, most) = reciprocating::largest(|at| [engine::tractive_effort(force, at, angle), 0.0]);
            sheet.check_sum("maximum tractive effort over a revolution", tractive, most.into(), 2.0 * force);
            let (_, most) =
                reciprocating::largest(|at| [engine::swaying_couple(force, apart, at, angle), 0.0]);
            sheet.check_sum("maximum swaying couple over a revolution", sway, most.into(), apart * force);
        });
        let blow = blow.value();
        sheet.show(|| Exhibit::Plot(pictures::over_a_turn(force, angle)));
        sheet.show(|| Exhibit::Plot(pictures::swaying(force, apart, angle)));
        let speed = speed.value();
        let limit = lifting.map(Real::value);
        sheet.show(|| Exhibit::Plot(pictures::against_speed(blow, speed, self.load, limit)));
        sheet.show(|| Exhibit::Drawing(self.drawn(placed)));
        Ok(())
    }
}

const WITH_ROTATING: &str =
    "the whole balance mass counted in the hammer blow, its part for the rotating mass included";

/// A given fraction as a step of its own: answers are results of steps.
fn fraction_step<W: Worksheet>(given: &LocomotiveGiven<W>, fraction: W::Num, sheet: W) -> W::Num {
    match given.balance {
        BalanceGiven::HammerBlow { .. } => fraction,
        BalanceGiven::Fraction { .. } => sheet.step("c′", "1", fraction, "The fraction as it is given"),
    }
}

impl Locomotive {
    fn wheel_speed<W: Worksheet>(
        &self,
        given: &LocomotiveGiven<W>,
        sheet: W,
    ) -> Result<Option<W::Num>, Refusal> {
        match (&given.running, given.diameter) {
            (RunningGiven::Wheel { speed }, _) => Ok(Some(*speed)),
            (RunningGiven::Train { speed }, Some(diameter)) => {
                let why = "The wheels roll";
                Ok(Some(sheet.step("ω", "rad/s", *speed / (diameter / 2.0), why)))
            }
            (RunningGiven::Train { .. }, None) => Err(Refusal::because(
                "the speed of the train is converted to that of the wheels with their diameter; give it, or the speed of the wheels",
            )),
            (RunningGiven::Limit {}, _) => Ok(None),
        }
    }

    /// The wheel speed at which the hammer blow is as large as the dead load.
    fn limit<W: Worksheet>(
        &self,
        given: &LocomotiveGiven<W>,
        product: W::Num,
        fraction: W::Num,
        share: W::Num,
        axles: f64,
        sheet: W,
    ) -> Option<W::Num> {
        let load = given.load?;
        if fraction.value() <= 0.0 {
            sheet.warn(|| {
                Text::new(
                    "no part of the reciprocating masses is balanced: no hammer blow, no limiting speed",
                )
            });
            return None;
        }
        let load = if axles == 1.0 { load } else { load * axles };
        let speed = (load / (product * fraction * share)).sqrt();
        let why = ("Speed at which the hammer blow is as large as the dead load", KHURMI.at("ch. 22"));
        sheet.common_error("ω_L", WITH_ROTATING, || {
            let rotating = given.rotating * axles / given.reciprocating;
            (load / (product * (fraction + rotating) * share)).sqrt()
        });
        let speed = sheet.step("ω_L", "rpm", speed, why);
        sheet.answer("limit_wheel_speed", "Wheel speed at which a wheel begins to lift", speed);
        let train = given.diameter.map(|diameter| {
            let train = sheet.step("v_L", "km/h", speed * diameter / 2.0, "The wheels roll");
            sheet.answer("limit_speed", "Speed at which a wheel begins to lift", train);
            train.value() / (diameter.value() / 2.0)
        });
        sheet.verify(|| {
            for speed in [Some(speed.value()), train].into_iter().flatten() {
                let blow = product.value() * fraction.value() * share.value() * speed.powi(2) / axles;
                sheet.check(
                    "at that speed the hammer blow is the dead load",
                    blow.into(),
                    (load.value() / axles).into(),
                );
            }
        });
        Some(speed)
    }

    /// Balance masses of the driving and the coupled wheels; the angles of those of the driving wheels.
    fn balance_masses<W: Worksheet>(
        &self,
        given: &LocomotiveGiven<W>,
        crank: W::Num,
        fraction: W::Num,
        axles: f64,
        shares: [(W::Num, W::Num); 2],
        sheet: W,
    ) -> [f64; 2] {
        let between = given.between;
        let part = if axles == 1.0 { fraction } else { fraction / axles };
        let why = (
            "Mass to be balanced at each crank: the rotating one and a part of the reciprocating one",
            BEVAN.at("ch. 14"),
        );
        sheet.common_error("M", "the balanced fraction taken of the rotating mass too", || {
            part * (given.rotating + given.reciprocating)
        });
        let driven = sheet.step("M", "kg", given.rotating + part * given.reciprocating, why);
        let rods = given.coupled.as_ref().filter(|coupled| coupled.mass.value() > 0.0).map(|coupled| {
            let near = engine::near_share(given.wheels, coupled.apart);
            let far = engine::far_share(given.wheels, coupled.apart);
            let near = sheet.step("f_k", "1", near, "Share of a coupling rod in the wheel of its own side");
            let far = sheet.step("f′_k", "1", far, "Share of a coupling rod in the wheel of the other side");
            (coupled.mass * coupled.radius, coupled.angle, [(near, far), (far, near)])
        });
        let mut angles = [0.0; 2];
        let mut of_wheels = |mass: W::Num, names: &WheelNames, sheet: W| {
            let mut sums = [0.0; 4];
            for (wheel, (first, second)) in shares.into_iter().enumerate() {
                let row = wheel + 1;
                let of_cranks = [first + second * between.cos(), second * between.sin()];
                let of_rods = rods.map(|(product, lead, shares)| {
                    let (first, second) = shares[wheel];
                    let other = between + lead;
                    [
                        product * (first * lead.cos() + second * other.cos()),
                        product * (first * lead.sin() + second * other.sin()),
                    ]
                });
                let component = |axis: usize| {
                    let cranks = mass * crank * of_cranks[axis];
                    of_rods.map_or(-cranks, |rods| -(cranks + rods[axis]))
                };
                let why = (
                    "Balance mass of this wheel opposes the unbalance received from both cranks",
                    BEVAN.at("ch. 14"),
                );
                let x = sheet.step((names.x, row), "kg*m", component(0), why);
                let y = sheet.step((names.y, row), "kg*m", component(1), why);
                let alone = "each crank balanced in the wheel of its own side alone";
                if rods.is_none() {
                    sheet.common_error((names.size, row), alone, || mass * crank);
                }
                let size =
                    sheet.step((names.size, row), "kg*m", balance::magnitude(x, y), "Mass–radius product");
                sheet.answer((names.product, row), names.labels[0], size);
                let scale = mass.value() * crank.value() + rods.map_or(0.0, |(product, ..)| product.value());
                if size.value() <= 1e-12 * scale {
                    continue;
                }
                let placed = given.radius.map(|radius| {
                    let why = "Balance mass in this wheel";
                    let mass = sheet.step((names.mass_symbol, row), "kg", size / radius, why);
                    sheet.answer((names.mass, row), names.labels[1], mass);
                    mass.value() * radius.value()
                });
                let why = "Angle from the first crank, positive towards the second crank";
                if rods.is_none() {
                    let own = if wheel == 0 { W::Num::from(0.0) } else { between };
                    sheet.common_error((names.angle_symbol, row), alone, || balance::marked_angle(own + PI));
                }
                let what = "the direction of the resultant of the cranks taken, not the opposite";
                sheet.common_error((names.angle_symbol, row), what, || balance::marked_direction(-x, -y));
                rotor::quadrant_ignored(sheet, (names.angle_symbol, row), (x, y));
                let angle =
                    sheet.step((names.angle_symbol, row), "deg", balance::marked_direction(x, y), why);
                sheet.answer((names.angle, row), names.labels[2], angle);
                let placed = placed.unwrap_or(size.value());
                let (x, y) = (placed * angle.value().cos(), placed * angle.value().sin());
                let side = if wheel == 0 { -0.5 } else { 0.5 } * self.wheels;
                for (sum, part) in sums.iter_mut().zip([x, y, side * x, side * y]) {
                    *sum += part;
                }
                if names.driving {
                    angles[wheel] = angle.value();
                }
            }
            sheet.verify(|| self.check(mass.value(), crank.value(), sums, sheet));
        };
        of_wheels(driven, &DRIVING, sheet);
        if given.coupled.is_some() {
            let why = "Part of the reciprocating mass that each other axle balances";
            let share = if self.coupled.as_ref().is_some_and(|coupled| coupled.axles > 1) {
                part
            } else {
                0.0.into()
            };
            let mass = sheet.step("M_k", "kg", share * given.reciprocating, why);
            of_wheels(mass, &COUPLED, sheet);
        }
        angles
    }

    /// Forces and moments of all masses of an axle, each in its own plane, vanish.
    fn check<W: Worksheet>(&self, mass: f64, crank: f64, wheels: [f64; 4], sheet: W) {
        let product = mass * crank;
        let mut places =
            vec![(product, 0.0, -0.5 * self.cylinders), (product, self.between, 0.5 * self.cylinders)];
        if let Some(rods) = &self.coupled {
            let product = rods.mass * rods.radius;
            places.push((product, rods.angle, -0.5 * rods.apart));
            places.push((product, self.between + rods.angle, 0.5 * rods.apart));
        }
        let sum =
            |of: &dyn Fn(f64, f64) -> f64| places.iter().map(|(u, angle, z)| u * of(*angle, *z)).sum::<f64>();
        let sums = [
            sum(&|angle, _| angle.cos()),
            sum(&|angle, _| angle.sin()),
            sum(&|angle, z| z * angle.cos()),
            sum(&|angle, z| z * angle.sin()),
        ];
        let size: f64 = places.iter().map(|(u, ..)| u).sum();
        let reach: f64 = places.iter().map(|(_, _, z)| z.abs()).fold(self.wheels, f64::max);
        for (k, (left, right)) in sums.into_iter().zip(wheels).enumerate() {
            // Shares of masses far outside the wheels cancel.
            let scale = size * if k < 2 { reach / self.wheels } else { reach };
            let what = "forces and moments of cranks, rods and balance masses vanish";
            sheet.check_zero(what, (left + right).into(), scale);
        }
    }
}

/// Symbols and labels of the balance of a pair of wheels.
struct WheelNames {
    driving: bool,
    x: &'static str,
    y: &'static str,
    size: &'static str,
    mass_symbol: &'static str,
    angle_symbol: &'static str,
    product: &'static str,
    mass: &'static str,
    angle: &'static str,
    labels: [&'static str; 3],
}

const DRIVING: WheelNames = WheelNames {
    driving: true,
    x: "U_x",
    y: "U_y",
    size: "U_B",
    mass_symbol: "B",
    angle_symbol: "β",
    product: "balance",
    mass: "mass",
    angle: "angle",
    labels: [
        "Mass–radius product of the balance mass in driving wheel",
        "Balance mass in driving wheel",
        "Angle of the balance mass from the first crank, driving wheel",
    ],
};

const COUPLED: WheelNames = WheelNames {
    driving: false,
    x: "V_x",
    y: "V_y",
    size: "V_B",
    mass_symbol: "B_k",
    angle_symbol: "β_k",
    product: "coupled_balance",
    mass: "coupled_mass",
    angle: "coupled_angle",
    labels: [
        "Mass–radius product of the balance mass in coupled wheel",
        "Balance mass in coupled wheel",
        "Angle of the balance mass from the first crank, coupled wheel",
    ],
};
