//! The shaft diameters that keep an unbalanced rotor clear of its stator at every speed of a range.

use std::f64::consts::FRAC_1_SQRT_2;

use dalembert_core::{
    About, Analysis, Drawing, DrawnShape, Exhibit, Ink, Inputs, Refusal, Text, Worksheet, register,
};
use dalembert_mechanics::{
    Real, beam,
    intervals::IntervalSet,
    sdof, section,
    whirl::{self, LimitedBy, PermittedStiffness},
};

mod judged;
mod limits;
mod plot;

use crate::sources::{BEER, LISTS, RAO, SHIGLEY};

/// The rotor, the speeds it runs at, and the shaft whose diameter is sought.
#[derive(Clone, Debug, Inputs)]
pub struct ShaftClearance {
    /// Mass of the rotor.
    #[input("m", "kg", positive)]
    pub mass: f64,
    /// Unbalance.
    /// Mass of the rotor times the distance of its mass centre from the axis.
    #[input("m₀e", "kg*m", positive)]
    pub unbalance: f64,
    /// Radial clearance between rotor and stator.
    #[input("R", "m", positive)]
    pub clearance: f64,
    /// Lowest speed.
    #[input("ω_a", "rad/s", nonnegative)]
    pub lowest_speed: f64,
    /// Highest speed.
    #[input("ω_b", "rad/s", positive)]
    pub highest_speed: f64,
    /// Margin on the speeds.
    /// Taken off the lowest speed and added to the highest.
    #[input("s", "%", nonnegative, below = 100)]
    pub margin: Option<f64>,
    /// Damping.
    pub damping: Damping,
    /// Shaft.
    pub shaft: Shaft,
    /// Smallest diameter available.
    #[input("d_min", "m", positive)]
    pub smallest_diameter: Option<f64>,
    /// Largest diameter available.
    #[input("d_max", "m", positive)]
    pub largest_diameter: Option<f64>,
    /// A diameter to be judged.
    #[input("d", "m", positive)]
    pub diameter: Option<f64>,
}

/// What damps the whirl.
#[derive(Clone, Debug, Inputs)]
pub enum Damping {
    /// Undamped
    Undamped,
    /// Damping ratio given
    /// The same for every diameter, so that the coefficient follows the stiffness.
    Ratio {
        /// Damping ratio.
        #[input("ζ", "1", nonnegative)]
        ratio: f64,
    },
    /// Damping coefficient given
    /// The same for every diameter.
    Coefficient {
        /// Damping coefficient.
        #[input("c", "N*s/m", nonnegative)]
        coefficient: f64,
    },
}

/// A solid round shaft.
#[derive(Clone, Debug, Inputs)]
pub struct Shaft {
    /// Mounting.
    pub mounting: Mounting,
    /// Length.
    /// Of the overhang where the rotor is at its end, of the span otherwise.
    #[input("L", "m", positive)]
    pub length: f64,
    /// Young's modulus.
    #[input("E", "Pa", positive)]
    pub young: f64,
}

/// How the shaft is held, and where the rotor is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum Mounting {
    /// Cantilever, rotor at its end
    Cantilever,
    /// Simply supported, rotor at the middle
    SimplySupported,
    /// Clamped at both ends, rotor at the middle
    Clamped,
    /// Clamped and pinned, rotor at the middle
    ClampedPinned,
}

register!(ShaftClearance);

impl Analysis for ShaftClearance {
    const ABOUT: About = About {
        id: "vibration/shaft-clearance",
        title: "Shaft for a rotor with clearance",
        summary: "All shaft diameters with which an unbalanced rotor stays clear of its stator at every speed of a range.",
        keywords: "whirl critical speed Francis turbine rotor stator jeffcott turbina eixo diâmetro folga \
                   velocidade crítica 08/3",
        sources: &[&RAO, &BEER, &SHIGLEY, &LISTS],
        cases: include_str!("../cases/shaft_clearance.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &ShaftClearanceGiven<W>, sheet: W) -> Result<(), Refusal> {
        let speeds = self.range(given, sheet)?;
        let eccentricity = sheet.step(
            "e",
            "µm",
            given.unbalance / given.mass,
            ("Distance of the mass centre from the axis", RAO.at("§9.5")),
        );
        let largest = self.largest_amplitude(given, eccentricity, sheet);
        let permitted = self.permitted([speeds[0].value(), speeds[1].value()])?;
        let (soft, stiff) = match &given.damping {
            DampingGiven::Coefficient { coefficient } => {
                limits::found_limits(given, *coefficient, &permitted, sheet)
            }
            DampingGiven::Ratio { ratio } if ratio.value() > 0.0 => {
                limits::ratio_limits(given, *ratio, speeds, &permitted, sheet)
            }
            _ => limits::undamped_limits(given, speeds, &permitted, sheet),
        };
        let thin = soft.map(|k| self.diameter_of(k, given, Branch::Soft, sheet));
        let thick = stiff.map(|k| self.diameter_of(k, given, Branch::Stiff, sheet));

        let (set, limits) =
            self.permitted_diameters(&permitted, thin.map(Real::value), thick.map(Real::value));
        sheet.answer_set("diameters", "Permitted diameters", "mm", &set, limits);
        if let (Some(k), Some(d)) = (soft, thin) {
            sheet.answer("soft_stiffness", "Largest stiffness of the soft branch", k);
            sheet.answer("soft_limit", "Largest diameter of the soft branch", d);
        }
        if let (Some(k), Some(d)) = (stiff, thick) {
            sheet.answer("stiff_stiffness", "Smallest stiffness of the stiff branch", k);
            sheet.answer("stiff_limit", "Smallest diameter of the stiff branch", d);
        }
        if let Some(largest) = largest {
            sheet.answer("largest_amplitude", "Largest amplitude of any shaft at any speed", largest);
        }
        say_what_limits(&permitted, &set, sheet);
        if let Some(diameter) = given.diameter {
            self.judge(given, diameter, speeds, sheet)?;
        }
        let range = [speeds[0].value(), speeds[1].value()];
        sheet.show(|| {
            Exhibit::Plot(self.amplitude_over_diameter(
                range,
                &set,
                [thin, thick].map(|d| d.map(Real::value)),
            ))
        });
        sheet.show(|| Exhibit::Drawing(self.drawing()));
        Ok(())
    }
}

/// One side of the resonance.
#[derive(Clone, Copy)]
enum Branch {
    /// The rotor runs above its critical speed.
    Soft,
    /// The rotor runs below its critical speed.
    Stiff,
}

impl ShaftClearance {
    /// The range of speeds with its margins.
    fn range<W: Worksheet>(&self, given: &ShaftClearanceGiven<W>, sheet: W) -> Result<[W::Num; 2], Refusal> {
        if self.lowest_speed > self.highest_speed {
            return Err(Refusal::because(
                "the lowest speed is above the highest one: write the smaller speed as the lowest",
            ));
        }
        let Some(margin) = given.margin else { return Ok([given.lowest_speed, given.highest_speed]) };
        let one = W::Num::from(1.0);
        Ok([
            sheet.step("ω₁", "rpm", given.lowest_speed * (one - margin), "Lowest speed, with its margin"),
            sheet.step("ω₂", "rpm", given.highest_speed * (one + margin), "Highest speed, with its margin"),
        ])
    }

    /// The kernel: which stiffnesses are permitted.
    fn permitted(&self, speeds: [f64; 2]) -> Result<PermittedStiffness, Refusal> {
        let (m, u, r) = (self.mass, self.unbalance, self.clearance);
        let permitted = match self.damping {
            Damping::Undamped => whirl::permitted_stiffness(m, u, r, speeds, 0.0),
            Damping::Ratio { ratio } => whirl::permitted_stiffness(m, u, r, speeds, ratio),
            Damping::Coefficient { coefficient } => {
                whirl::permitted_stiffness_at_damping(m, u, r, speeds, coefficient)
            }
        };
        permitted.map_err(|_| {
            Refusal::because("these numbers do not describe a rotor, or lead beyond the range of numbers")
        })
    }

    /// With a damping ratio, the largest amplitude of any shaft; and the ratio from which no shaft can touch.
    fn largest_amplitude<W: Worksheet>(
        &self,
        given: &ShaftClearanceGiven<W>,
        eccentricity: W::Num,
        sheet: W,
    ) -> Option<W::Num> {
        if matches!(self.damping, Damping::Coefficient { .. }) {
            return None;
        }
        let room = sheet.step(
            "Λ",
            "1",
            given.clearance / eccentricity,
            "Clearance as a multiple of the eccentricity",
        );
        if let Some(enough) = sdof::damping_ratio_from_peak(room) {
            let enough = sheet.step(
                "ζ_R",
                "1",
                enough,
                ("Damping ratio whose peak, e/(2ζ√(1 − ζ²)), just reaches the clearance", RAO.at("§3.7")),
            );
            sheet.check(
                "the peak with that damping ratio is the clearance",
                eccentricity * sdof::peak_magnification(enough),
                given.clearance,
            );
            sheet.answer("harmless_damping_ratio", "Damping ratio from which no shaft touches", enough);
        }
        let DampingGiven::Ratio { ratio } = &given.damping else { return None };
        (ratio.value() > 0.0 && ratio.value() < FRAC_1_SQRT_2).then(|| {
            let largest = sheet.step(
                "Xₘₐₓ",
                "mm",
                eccentricity * sdof::peak_magnification(*ratio),
                ("Largest amplitude of any shaft, at its worst speed: the peak does not depend on the stiffness", RAO.at("§3.7")),
            );
            sheet.check(
                "the same from the whirl amplitude at the frequency ratio of the peak",
                whirl::whirl_amplitude(eccentricity, sdof::unbalance_peak_ratio(*ratio), *ratio),
                largest,
            );
            largest
        })
    }

    /// The diameter with a stiffness.
    fn diameter_of<W: Worksheet>(
        &self,
        stiffness: W::Num,
        given: &ShaftClearanceGiven<W>,
        branch: Branch,
        sheet: W,
    ) -> W::Num {
        let (length, young) = (given.shaft.length, given.shaft.young);
        let (moment_symbol, symbol) = match branch {
            Branch::Soft => ("Iₛ", "dₛ"),
            Branch::Stiff => ("Iₕ", "dₕ"),
        };
        let (moment, why) = match self.shaft.mounting {
            Mounting::Cantilever => (
                stiffness * length.powi(3) / (young * 3.0),
                ("Second moment of area, from k = 3EI/L³ of a cantilever", RAO.at("§1.7")),
            ),
            Mounting::SimplySupported => (
                stiffness * length.powi(3) / (young * 48.0),
                ("Second moment of area, from k = 48EI/L³ of a simply supported shaft", RAO.at("§1.7")),
            ),
            Mounting::Clamped => (
                stiffness * length.powi(3) / (young * 192.0),
                ("Second moment of area, from k = 192EI/L³ of a shaft clamped at both ends", RAO.at("§1.7")),
            ),
            Mounting::ClampedPinned => (
                stiffness * length.powi(3) * 7.0 / (young * 768.0),
                (
                    "Second moment of area, from k = 768EI/(7L³) of a clamped and pinned shaft",
                    SHIGLEY.at("table A-9"),
                ),
            ),
        };
        let moment = sheet.step(moment_symbol, "cm^4", moment, why);
        let diameter = sheet.step(
            symbol,
            "mm",
            section::round_diameter(moment),
            ("Diameter of the solid round shaft with I = πd⁴/64", BEER.at("app. A")),
        );
        sheet.check(
            "the shaft of that diameter has the stiffness of the limit",
            self.shaft.mounting.stiffness(young, section::round_second_moment(diameter), length),
            stiffness,
        );
        diameter
    }

    /// The permitted diameters, and what limits each end of the set.
    fn permitted_diameters(
        &self,
        permitted: &PermittedStiffness,
        thin: Option<f64>,
        thick: Option<f64>,
    ) -> (IntervalSet, Vec<Text>) {
        use std::ops::Bound::{Excluded, Included, Unbounded};
        let finite = |d: Option<f64>| d.filter(|d| d.is_finite());
        let available = IntervalSet::interval(
            finite(self.smallest_diameter).map_or(Included(0.0), Included),
            finite(self.largest_diameter).map_or(Unbounded, Included),
        );
        let forbidden = match finite(thick) {
            Some(thick) => {
                IntervalSet::interval(finite(thin).map_or(Included(0.0), Excluded), Excluded(thick))
            }
            None => IntervalSet::none(),
        };
        let set = available.intersection(&forbidden.complement());
        let ends = set.intervals().flat_map(|interval| [interval.lower, interval.upper]);
        let limits = ends.filter_map(|end| match end {
            Included(d) | Excluded(d) if d > 0.0 => Some(self.why_it_ends(d, permitted, thin, thick)),
            _ => None,
        });
        let limits = limits.collect();
        (set, limits)
    }

    fn why_it_ends(
        &self,
        diameter: f64,
        permitted: &PermittedStiffness,
        thin: Option<f64>,
        thick: Option<f64>,
    ) -> Text {
        let limit = match Some(diameter) {
            d if d == thin => permitted.soft,
            d if d == thick => permitted.stiff,
            d if d == self.smallest_diameter => return Text::new("smallest diameter available"),
            _ => return Text::new("largest diameter available"),
        };
        let Some(limit) = limit else { return Text::new("largest diameter available") };
        let text = match limit.by {
            LimitedBy::LowestSpeed => Text::new("the clearance is reached at the lowest speed, {speed}"),
            LimitedBy::HighestSpeed => Text::new("the clearance is reached at the highest speed, {speed}"),
            LimitedBy::Peak => Text::new("the clearance is reached at the peak of the response, at {speed}"),
        };
        text.with_quantity("speed", limit.speed, "rpm")
    }

    /// The rotor on its shaft, inside the stator.
    fn drawing(&self) -> Drawing {
        let rotor = |x: f64| {
            [
                DrawnShape::Block((x - 0.35, -0.8), (x + 0.35, 0.8), Ink::Body),
                DrawnShape::Polyline(vec![(x - 0.5, 1.0), (x + 0.5, 1.0)], Ink::Danger),
                DrawnShape::Polyline(vec![(x - 0.5, -1.0), (x + 0.5, -1.0)], Ink::Danger),
                DrawnShape::Label((x + 0.6, 1.0), Text::from("stator")),
                DrawnShape::Label((x + 0.6, 0.85), Text::from("R")),
                DrawnShape::Circle((x, 0.12), 0.06, Ink::Danger),
                DrawnShape::Label((x + 0.1, 0.2), Text::from("e")),
            ]
        };
        let left_clamp = DrawnShape::Ground((-2.5, 0.6), (-2.5, -0.6));
        let right_clamp = DrawnShape::Ground((2.5, -0.6), (2.5, 0.6));
        let pins = |x: f64| DrawnShape::Pin((x, 0.0));
        let shaft = |to: f64| DrawnShape::Polyline(vec![(-2.5, 0.0), (to, 0.0)], Ink::Result);
        let mut shapes = match self.shaft.mounting {
            Mounting::Cantilever => vec![left_clamp, shaft(1.5)],
            Mounting::SimplySupported => vec![pins(-2.5), pins(2.5), shaft(2.5)],
            Mounting::Clamped => vec![left_clamp, right_clamp, shaft(2.5)],
            Mounting::ClampedPinned => vec![left_clamp, pins(2.5), shaft(2.5)],
        };
        let x = if self.shaft.mounting == Mounting::Cantilever { 1.5 } else { 0.0 };
        shapes.extend(rotor(x));
        shapes.push(DrawnShape::Label((-1.4, 0.25), Text::from("d")));
        Drawing { title: "The rotor in its stator".into(), shapes }
    }
}

impl Mounting {
    /// Stiffness of the shaft at the rotor.
    fn stiffness<N: Real>(self, young: N, second_moment: N, length: N) -> N {
        match self {
            Mounting::Cantilever => beam::cantilever(young, second_moment, length),
            Mounting::SimplySupported => beam::simply_supported_middle(young, second_moment, length),
            Mounting::Clamped => beam::clamped_clamped_middle(young, second_moment, length),
            Mounting::ClampedPinned => beam::clamped_pinned_middle(young, second_moment, length),
        }
    }
}

/// Says plainly when the clearance decides nothing, or everything.
fn say_what_limits<W: Worksheet>(permitted: &PermittedStiffness, set: &IntervalSet, sheet: W) {
    if permitted.stiff.is_none() {
        sheet.warn(|| {
            Text::new(
                "the limit is never active: with this damping the rotor stays clear of the stator with every \
                 diameter, so clearance and speeds do not decide the diameter; strength and bearings do",
            )
        });
    } else if permitted.soft.is_some() {
        sheet.warn(|| {
            Text::new(
                "on the soft branch the rotor passes its critical speed on the way to the lowest speed: run \
                 through it quickly",
            )
        });
    }
    if set.is_none() {
        sheet.warn(|| {
            Text::new(
                "no available diameter keeps the rotor clear: change clearance, unbalance, damping or speeds",
            )
        });
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use dalembert_core::{AnswerValue, Inputs, Lift, Sheet, Stop, Trail};

    use super::*;

    fn turbine(damping: Damping, unbalance: f64) -> ShaftClearance {
        ShaftClearance {
            mass: 250.0,
            unbalance,
            clearance: 5e-3,
            lowest_speed: 600.0 * TAU / 60.0,
            highest_speed: 6000.0 * TAU / 60.0,
            margin: None,
            damping,
            shaft: Shaft { mounting: Mounting::Clamped, length: 2.0, young: 207e9 },
            smallest_diameter: None,
            largest_diameter: None,
            diameter: None,
        }
    }

    fn permitted_diameters(problem: &ShaftClearance) -> IntervalSet {
        let stop = Stop::new();
        let sheet = Sheet::new(&stop);
        let given = problem.given(Lift { sheet: &sheet, value: None, trail: &Trail::TOP });
        problem.solve(&given, &sheet).unwrap();
        let solution = sheet.into_solution().unwrap();
        assert!(solution.checks.iter().all(|check| check.passed));
        match &solution.answer("diameters").unwrap().value {
            AnswerValue::Set(set, _) => set.clone(),
            AnswerValue::Number(..) | AnswerValue::List(_) => panic!("the diameters are a set"),
        }
    }

    /// The largest amplitude at any of many speeds of the range.
    fn by_brute_force(problem: &ShaftClearance, diameter: f64) -> f64 {
        let moment = section::round_second_moment(diameter);
        let k = problem.shaft.mounting.stiffness(problem.shaft.young, moment, problem.shaft.length);
        let c = match problem.damping {
            Damping::Undamped => 0.0,
            Damping::Ratio { ratio } => sdof::damping_from_ratio(ratio, k, problem.mass),
            Damping::Coefficient { coefficient } => coefficient,
        };
        let amplitude = |n: u16| {
            let share = f64::from(n) / 4000.0;
            let speed = problem.lowest_speed + share * (problem.highest_speed - problem.lowest_speed);
            sdof::unbalance_amplitude(problem.unbalance, k, problem.mass, c, speed)
        };
        (0..=4000).map(amplitude).fold(0.0, f64::max)
    }

    #[test]
    fn a_diameter_is_permitted_where_no_speed_reaches_the_clearance() {
        let dampings = [
            Damping::Ratio { ratio: 0.03 },
            Damping::Ratio { ratio: 0.2 },
            Damping::Ratio { ratio: 0.5 },
            Damping::Ratio { ratio: 1.2 },
            Damping::Coefficient { coefficient: 3e3 },
            Damping::Coefficient { coefficient: 3e4 },
            Damping::Coefficient { coefficient: 3e5 },
        ];
        let mut seen = [0, 0];
        for damping in dampings {
            // Eccentricities of a fifth of the clearance, four fifths and twice.
            for unbalance in [0.25, 1.0, 2.5] {
                let problem = turbine(damping.clone(), unbalance);
                let set = permitted_diameters(&problem);
                for n in 0..60 {
                    let diameter = 0.01 * 1.08f64.powi(n);
                    let worst = by_brute_force(&problem, diameter) / problem.clearance;
                    // So near to the clearance the speeds tried are not dense enough to tell.
                    if (worst - 1.0).abs() > 2e-3 {
                        assert_eq!(
                            set.contains(diameter),
                            worst < 1.0,
                            "{problem:?}, d = {diameter}, {worst}"
                        );
                        seen[usize::from(worst < 1.0)] += 1;
                    }
                }
            }
        }
        assert!(seen.iter().all(|count| *count > 100), "{seen:?}");
    }
}
