//! The permitted diameters, and the permitted stiffnesses.

use dalembert_core::{Exhibit, Refusal, Worksheet};
use dalembert_mechanics::{Real, section};

use super::{
    Branch, Mounting, PermittedQuantity, PermittedQuantityGiven, RoundShaft, RoundShaftGiven, ShaftClearance,
    ShaftClearanceGiven, available_set, say_what_limits,
};
use crate::sources::{BEER, RAO, SHIGLEY};

impl ShaftClearance {
    pub(super) fn diameters<W: Worksheet>(
        &self,
        given: &ShaftClearanceGiven<W>,
        sheet: W,
    ) -> Result<(), Refusal> {
        let (
            PermittedQuantity::Diameter { speeds: range, shaft, smallest_diameter, largest_diameter, .. },
            PermittedQuantityGiven::Diameter { unbalance, speeds, shaft: shaft_given, diameter, .. },
        ) = (&self.sought, &given.sought)
        else {
            return Ok(());
        };
        let speeds = range.widened(speeds, sheet)?;
        let branches = self.branches(given, *unbalance, speeds, sheet)?;
        let thin = branches.soft.map(|k| diameter_of(k, shaft, shaft_given, Branch::Soft, sheet));
        let thick = branches.stiff.map(|k| diameter_of(k, shaft, shaft_given, Branch::Stiff, sheet));
        let ends = [thin, thick].map(|d| d.map(Real::value));
        let available = [
            (*smallest_diameter, "minimum available diameter"),
            (*largest_diameter, "maximum available diameter"),
        ];
        let (set, limits) = available_set(available, ends, &branches.permitted);
        sheet.answer_set("diameters", "Permitted diameters", "mm", &set, limits);
        if let Some(d) = thin {
            sheet.answer("soft_limit", "Maximum diameter, supercritical operation", d);
        }
        if let Some(d) = thick {
            sheet.answer("stiff_limit", "Minimum diameter, subcritical operation", d);
        }
        let words = [
            "the clearance is not a constraint: with this damping the rotor stays clear of the stator at every diameter, so clearance and speeds do not determine the diameter; strength and bearings do",
            "no available diameter keeps the rotor clear: change clearance, unbalance, damping or speeds",
        ];
        say_what_limits(&branches.permitted, &set, words, sheet);
        if let Some(diameter) = *diameter {
            let moment = sheet.step(
                "I",
                "cm^4",
                section::round_second_moment(diameter),
                ("Second moment of area of the shaft to be checked", BEER.at("app. A")),
            );
            let spread = || {
                let bending = shaft_given.young * moment;
                bending * shaft.mounting.spread_load() / shaft_given.length.powi(3)
            };
            sheet.common_error("k", "the deflection under a uniformly distributed load used", spread);
            let k = sheet.step(
                "k",
                "MN/m",
                shaft.mounting.stiffness(shaft_given.young, moment, shaft_given.length),
                ("Its stiffness at the rotor", RAO.at("§1.7")),
            );
            self.assess(given, *unbalance, k, speeds, sheet)?;
        }
        let (range, unbalance) = (branches.range(), unbalance.value());
        sheet.show(|| {
            let stiffness =
                |d: f64| shaft.mounting.stiffness(shaft.young, section::round_second_moment(d), shaft.length);
            let critical = |speed: f64| {
                let moment =
                    self.mass * speed.powi(2) / shaft.mounting.stiffness(shaft.young, 1.0, shaft.length);
                section::round_diameter(moment)
            };
            // From well below to well above the diameters whose critical speed lies in the range.
            let ends_shown = [0.4 * critical(range[0].max(0.02 * range[1])), 1.6 * critical(range[1])];
            let plot = self.amplitude_over(ends_shown, unbalance, range, stiffness);
            Exhibit::Plot(
                plot.permitted(
                    "Maximum amplitude in the range of speeds against diameter",
                    ("diameter", "mm"),
                    &set,
                    ends,
                )
                .over("sought.diameter.diameter"),
            )
        });
        Ok(())
    }

    pub(super) fn stiffnesses<W: Worksheet>(
        &self,
        given: &ShaftClearanceGiven<W>,
        sheet: W,
    ) -> Result<(), Refusal> {
        let (
            PermittedQuantity::Stiffness { speeds: range, smallest_stiffness, largest_stiffness, .. },
            PermittedQuantityGiven::Stiffness { unbalance, speeds, stiffness, .. },
        ) = (&self.sought, &given.sought)
        else {
            return Ok(());
        };
        let speeds = range.widened(speeds, sheet)?;
        let branches = self.branches(given, *unbalance, speeds, sheet)?;
        let ends = [branches.soft, branches.stiff].map(|k| k.map(Real::value));
        let available = [
            (*smallest_stiffness, "minimum available stiffness"),
            (*largest_stiffness, "maximum available stiffness"),
        ];
        let (set, limits) = available_set(available, ends, &branches.permitted);
        sheet.answer_set("stiffnesses", "Permitted stiffnesses", "MN/m", &set, limits);
        let words = [
            "at every stiffness the rotor stays clear of the stator with this damping: the clearance is not a constraint",
            "no available stiffness keeps the rotor clear: change clearance, unbalance, damping or speeds",
        ];
        say_what_limits(&branches.permitted, &set, words, sheet);
        if let Some(k) = *stiffness {
            self.assess(given, *unbalance, k, speeds, sheet)?;
        }
        let (range, unbalance) = (branches.range(), unbalance.value());
        sheet.show(|| {
            let critical = |speed: f64| self.mass * speed.powi(2);
            let ends_shown = [0.03 * critical(range[0].max(0.02 * range[1])), 6.0 * critical(range[1])];
            let plot = self.amplitude_over(ends_shown, unbalance, range, |k| k);
            Exhibit::Plot(
                plot.permitted(
                    "Maximum amplitude in the range of speeds against stiffness",
                    ("stiffness", "MN/m"),
                    &set,
                    ends,
                )
                .over("sought.stiffness.stiffness"),
            )
        });
        Ok(())
    }
}

/// The diameter with a stiffness.
fn diameter_of<W: Worksheet>(
    stiffness: W::Num,
    shaft: &RoundShaft,
    given: &RoundShaftGiven<W>,
    branch: Branch,
    sheet: W,
) -> W::Num {
    let (length, young) = (given.length, given.young);
    let (moment_symbol, symbol) = match branch {
        Branch::Soft => ("Iₛ", "dₛ"),
        Branch::Stiff => ("Iₕ", "dₕ"),
    };
    let (moment, why) = match shaft.mounting {
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
    let spread = || stiffness * length.powi(3) / (young * shaft.mounting.spread_load());
    sheet.common_error(moment_symbol, "the deflection under a uniformly distributed load used", spread);
    let moment = sheet.step(moment_symbol, "cm^4", moment, why);
    let diameter = sheet.step(
        symbol,
        "mm",
        section::round_diameter(moment),
        ("Diameter of the solid circular shaft with I = πd⁴/64", BEER.at("app. A")),
    );
    sheet.check(
        "the shaft of that diameter has the limiting stiffness",
        shaft.mounting.stiffness(young, section::round_second_moment(diameter), length),
        stiffness,
    );
    diameter
}
