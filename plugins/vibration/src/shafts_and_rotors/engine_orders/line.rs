//! The line of masses of an engine: what stands in front of the cranks, the cranks, what stands behind them.

use std::f64::consts::TAU;

use dalembert_core::{Inputs, Refusal, Symbol, Text, Worksheet};
use dalembert_mechanics::{
    Real, section, spring as kernel,
    vibration::{
        crankshaft::{self, ThrowContributions},
        torsional::{Train, TrainError, TrainShaft},
    },
};
use dalembert_numerics::quadrature::integral;

use super::{
    Attached, AttachedGiven, CrankshaftCranksGiven, EngineOrders, EngineOrdersGiven, firing::Cylinders,
};
use crate::{
    shared::{inertia, spring::torsional::network},
    sources::KER_WILSON,
};

/// Shaft between two cranks, by stiffness or dimensions.
#[derive(Clone, Debug, Inputs)]
pub enum ThrowStiffness {
    /// Stiffness given
    Stiffness {
        /// Torsional stiffness.
        #[input("k_c", "N*m/rad", positive)]
        stiffness: f64,
    },
    /// Equivalent length given
    /// A straight shaft with the same twist.
    Equivalent {
        /// Shear modulus.
        #[input("G", "Pa", positive)]
        shear: f64,
        /// Equivalent length.
        #[input("L_e", "m", positive)]
        length: f64,
        /// Diameter of the equivalent shaft.
        #[input("D_e", "m", positive)]
        diameter: f64,
    },
    /// Dimensions given
    Dimensions {
        /// Shear modulus.
        #[input("G", "Pa", positive)]
        shear: f64,
        /// Length of a journal.
        #[input("L_j", "m", positive)]
        journal_length: f64,
        /// Diameter of the journals.
        #[input("D_j", "m", positive)]
        journal_diameter: f64,
        /// Bore of the journals.
        #[input("d_j", "m", positive)]
        journal_bore: Option<f64>,
        /// Length of the crankpin.
        #[input("L_c", "m", positive)]
        pin_length: f64,
        /// Diameter of the crankpin.
        #[input("D_c", "m", positive)]
        pin_diameter: f64,
        /// Bore of the crankpin.
        #[input("d_c", "m", positive)]
        pin_bore: Option<f64>,
        /// Thickness of a web.
        /// Along the shaft.
        #[input("t", "m", positive)]
        web_thickness: f64,
        /// Width of a web.
        #[input("W", "m", positive)]
        web_width: f64,
        /// Radius of the crank.
        /// Half of the stroke.
        #[input("R", "m", positive)]
        radius: f64,
        /// Formula.
        rule: Rule,
    },
}

/// By which formula a throw is reckoned.
#[derive(Clone, Debug, Inputs)]
pub enum Rule {
    /// Carter
    /// For webs whose bending exceeds the twist of journals and crankpin.
    Carter,
    /// Ker Wilson
    /// For stiff webs.
    KerWilson,
    /// Mean of both
    Mean,
}

/// Masses in one line and the stiffnesses between them.
pub(super) struct CrankshaftLine<N> {
    pub(super) inertias: Vec<N>,
    pub(super) stiffnesses: Vec<N>,
    pub(super) names: Vec<Text>,
    /// The first crank and the last.
    pub(super) cranks: [usize; 2],
    /// The first and the last mass that are joined by the crankshaft.
    pub(super) crankshaft: [usize; 2],
    pub(super) train: Train,
}

/// The line, with the steps that lead to its numbers.
pub(super) fn line<W: Worksheet>(
    problem: &EngineOrders,
    given: &EngineOrdersGiven<W>,
    cylinders: &Cylinders<W::Num>,
    sheet: W,
) -> Result<CrankshaftLine<W::Num>, Refusal> {
    let (mut inertias, mut stiffnesses, mut names) = (Vec::new(), Vec::new(), Vec::new());
    let attached = |side: usize, n: usize, given: &AttachedGiven<W>| {
        let symbol = Symbol { of: if side == 1 { "f" } else { "r" }, ..Symbol::from("J") }.row(n + 1);
        let inertia = inertia::moment_of_inertia(&given.inertia, sheet, symbol);
        network(&given.shaft, sheet, &[side, n + 1]).map(|element| (inertia, element.stiffness))
    };
    let name = |part: &Attached| Text::new("{x}").with("x", &part.name);
    for (n, (part, given)) in problem.front.iter().zip(&given.front).enumerate() {
        let (inertia, stiffness) = attached(1, n, given)?;
        inertias.push(inertia);
        stiffnesses.push(stiffness);
        names.push(name(part));
    }
    match &given.cranks {
        CrankshaftCranksGiven::Alike { inertia, throw } => {
            inertias.extend(std::iter::repeat_n(*inertia, cylinders.cranks));
            if cylinders.cranks > 1 {
                let between = throw_stiffness(problem, throw, sheet)?;
                sheet.answer("throw_stiffness", "Stiffness between two cranks", between);
                stiffnesses.extend(std::iter::repeat_n(between, cylinders.cranks - 1));
            }
        }
        CrankshaftCranksGiven::Each { cranks } => {
            for (n, crank) in cranks.iter().enumerate() {
                inertias.push(crank.inertia);
                match crank.stiffness {
                    Some(stiffness) if n + 1 < cranks.len() => stiffnesses.push(stiffness),
                    None if n + 1 == cranks.len() => {}
                    Some(_) => {
                        return Err(Refusal::because(
                            "the last crank has no next one: omit its stiffness and write it with the part behind",
                        ));
                    }
                    None => {
                        return Err(Refusal::because(
                            Text::new(
                                "the stiffness from crank {crank} to the next one is missing: write it",
                            )
                            .with("crank", n + 1),
                        ));
                    }
                }
            }
        }
    }
    names.extend((1..=cylinders.cranks).map(|n| Text::new("crank {n}").with("n", n)));
    for (n, (part, given)) in problem.rear.iter().zip(&given.rear).enumerate() {
        let (inertia, stiffness) = attached(2, n, given)?;
        inertias.push(inertia);
        stiffnesses.push(stiffness);
        names.push(name(part));
    }
    let last = problem.front.len() + cylinders.cranks - 1;
    let cranks = [problem.front.len(), last];
    let crankshaft = [problem.front.len(), (last + 1).min(inertias.len() - 1)];
    let values: Vec<f64> = inertias.iter().map(|inertia: &W::Num| inertia.value()).collect();
    let shaft =
        |(n, stiffness): (usize, &W::Num)| TrainShaft { ends: [n, n + 1], stiffness: stiffness.value() };
    let shafts: Vec<TrainShaft> = stiffnesses.iter().enumerate().map(shaft).collect();
    let train = Train::new(&values, &vec![0.0; values.len()], &shafts).map_err(|error| refusal(&error))?;
    Ok(CrankshaftLine { inertias, stiffnesses, names, cranks, crankshaft, train })
}

/// Message for a refusal of the kernel.
pub(super) fn refusal(error: &TrainError) -> Refusal {
    Refusal::because(match error {
        TrainError::TooMany => "there are more than 200 masses: join some of them",
        _ => {
            "the moments of inertia and stiffnesses lead to numbers that cannot be represented: write realistic ones"
        }
    })
}

/// The stiffness between two cranks.
fn throw_stiffness<W: Worksheet>(
    problem: &EngineOrders,
    given: &ThrowStiffnessGiven<W>,
    sheet: W,
) -> Result<W::Num, Refusal> {
    match given {
        ThrowStiffnessGiven::Stiffness { stiffness } => Ok(*stiffness),
        ThrowStiffnessGiven::Equivalent { shear, length, diameter } => {
            let polar = sheet.step(
                "I_p",
                "cm^4",
                section::round_polar_moment(*diameter),
                "Polar second moment of area of the equivalent shaft",
            );
            let why = "Stiffness between two cranks: that of the equivalent shaft";
            Ok(sheet.step("k_c", "N*m/rad", kernel::torsional(*shear, polar, *length), why))
        }
        ThrowStiffnessGiven::Dimensions {
            shear,
            journal_length,
            journal_diameter,
            journal_bore,
            pin_length,
            pin_diameter,
            pin_bore,
            web_thickness,
            web_width,
            radius,
            ..
        } => {
            let solid =
                |outer: &W::Num, bore: &Option<W::Num>| bore.is_none_or(|bore| bore.value() < outer.value());
            if !solid(journal_diameter, journal_bore) || !solid(pin_diameter, pin_bore) {
                return Err(Refusal::because(
                    "a bore is not smaller than the surrounding diameter: write a smaller bore or leave it out",
                ));
            }
            let throw = crankshaft::CrankThrow {
                journal_length: *journal_length,
                journal_diameter: *journal_diameter,
                journal_bore: *journal_bore,
                pin_length: *pin_length,
                pin_diameter: *pin_diameter,
                pin_bore: *pin_bore,
                web_thickness: *web_thickness,
                web_width: *web_width,
                radius: *radius,
            };
            let parts = |parts: ThrowContributions<W::Num>, which: usize| {
                ThrowContributions {
                journal: sheet.step(
                    Symbol::from("a").row(which),
                    "1/m^3",
                    parts.journal,
                    "Contribution of the journals: length over the fourth power of the diameter, plus the twisting part of the webs",
                ),
                pin: sheet.step(Symbol::from("b").row(which), "1/m^3", parts.pin, "Contribution of the crankpin"),
                webs: sheet.step(Symbol::from("e").row(which), "1/m^3", parts.webs, "Contribution of the webs in bending"),
            }
            };
            let carter = parts(throw.carter(), 1).stiffness(*shear);
            let why = ("Stiffness by Carter's formula", KER_WILSON.at("vol. 1"));
            let carter = sheet.step("k_C", "N*m/rad", carter, why);
            sheet.answer("carter", "Stiffness by Carter's formula", carter);
            let short = radius.value() <= 0.2 * (journal_diameter.value() + pin_diameter.value());
            let super::CrankshaftCranks::Alike { throw: ThrowStiffness::Dimensions { rule, .. }, .. } =
                &problem.cranks
            else {
                return Ok(carter);
            };
            if short {
                if matches!(rule, Rule::Carter) {
                    return Ok(equivalent(carter, *shear, *journal_diameter, sheet));
                }
                return Err(Refusal::because(
                    "journal and crankpin overlap so much that Ker Wilson's formula leaves no web length: choose Carter's formula",
                ));
            }
            let wilson = parts(throw.ker_wilson(), 2).stiffness(*shear);
            let why = ("Stiffness by Ker Wilson's formula", KER_WILSON.at("vol. 1"));
            let wilson = sheet.step("k_W", "N*m/rad", wilson, why);
            sheet.answer("ker_wilson", "Stiffness by Ker Wilson's formula", wilson);
            let apart = carter.value() / wilson.value();
            if !(0.8..=1.25).contains(&apart) {
                sheet.warn(|| {
                    Text::new("Carter's and Ker Wilson's formulas differ by more than 20 %: measure the stiffness, or calculate with both")
                });
            }
            let chosen = match rule {
                Rule::Carter => carter,
                Rule::KerWilson => wilson,
                Rule::Mean => {
                    sheet.step("k_c", "N*m/rad", (carter + wilson) / 2.0, "Mean of the two formulas")
                }
            };
            Ok(equivalent(chosen, *shear, *journal_diameter, sheet))
        }
    }
}

/// Names the equivalent length of a throw, and goes on with its stiffness.
fn equivalent<W: Worksheet>(stiffness: W::Num, shear: W::Num, diameter: W::Num, sheet: W) -> W::Num {
    let polar = sheet.step(
        "I_p",
        "cm^4",
        section::round_polar_moment(diameter),
        "Polar second moment of area of a straight shaft with the diameter of the journals",
    );
    let length = sheet.step(
        "L_e",
        "mm",
        shear * polar / stiffness,
        "Equivalent length: a straight shaft with the same twist",
    );
    sheet.verify(|| {
        let radius = diameter / 2.0;
        let share = integral(|share| TAU * share * share * share, [0.0, 1.0], 1);
        sheet.check(
            "torque of the equivalent shaft from its shear stress over the section, for a unit twist",
            shear / length * radius.powi(4) * share,
            stiffness,
        );
    });
    sheet.answer("equivalent_length", "Equivalent length of a throw", length);
    stiffness
}
