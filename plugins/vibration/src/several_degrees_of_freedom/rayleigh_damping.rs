//! Damping proportional to mass and stiffness, from two modes whose damping is known.

use dalembert_core::{
    About, Analysis, Axis, Exhibit, Inputs, Plot, Refusal, Series, Text, Worksheet, register,
};
use dalembert_mechanics::{Real, vibration::rayleigh};

use crate::{
    shared::system::damping::{MEAN_RATIO, ONE_TERM},
    sources::{CLOUGH, RAO},
};

/// Two modes whose damping is known.
#[derive(Clone, Debug, Inputs)]
pub struct RayleighDamping {
    /// First mode.
    #[input("1")]
    pub first: KnownMode,
    /// Second mode.
    #[input("2")]
    pub second: KnownMode,
    /// Frequency at which the damping ratio is requested.
    #[input("ω", "Hz", positive)]
    pub asked: Option<f64>,
}

/// A frequency and the damping ratio there.
#[derive(Clone, Debug, Inputs)]
pub struct KnownMode {
    /// Frequency.
    #[input("ω", "Hz", positive)]
    pub frequency: f64,
    /// Damping ratio.
    #[input("ζ", "1", nonnegative, below = 1)]
    pub damping_ratio: f64,
}

register!(RayleighDamping);

impl Analysis for RayleighDamping {
    const ABOUT: About = About {
        id: "vibration/rayleigh-damping",
        title: "Rayleigh damping",
        topic: "Several degrees of freedom",
        summary: "Coefficients of proportional (Rayleigh) damping from the damping ratios of two modes, and the damping ratio at any frequency.",
        main: &["mass_coefficient", "stiffness_coefficient"],
        keywords: "proportional damping alpha beta amortecimento proporcional de Rayleigh",
        sources: &[&CLOUGH, &RAO],
        cases: include_str!("../../cases/rayleigh_damping.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &RayleighDampingGiven<W>, sheet: W) -> Result<(), Refusal> {
        if self.first.frequency == self.second.frequency {
            return Err(Refusal::because(
                "both modes have the same frequency: two different frequencies are needed to separate mass from stiffness",
            ));
        }
        let (first, second) = (&given.first, &given.second);
        let frequencies = [first.frequency, second.frequency];
        let ratios = [first.damping_ratio, second.damping_ratio];
        let [w1, w2] = frequencies;
        let [z1, z2] = ratios;
        sheet.common_error("α", ONE_TERM, || z1 * w1 * 2.0);
        sheet.common_error("α", MEAN_RATIO, || (z1 + z2) * w1 * w2 / (w1 + w2));
        let alpha = sheet.step(
            "α",
            "1/s",
            rayleigh::mass_coefficient(frequencies, ratios),
            ("Both modes satisfy ζ = α/(2ω) + βω/2: the coefficient of the mass", CLOUGH.at("§12-6")),
        );
        sheet.common_error("β", ONE_TERM, || z2 * 2.0 / w2);
        sheet.common_error("β", MEAN_RATIO, || (z1 + z2) / (w1 + w2));
        let beta = sheet.step(
            "β",
            "s",
            rayleigh::stiffness_coefficient(frequencies, ratios),
            ("The stiffness coefficient", CLOUGH.at("§12-6")),
        );
        // Of the two terms of each mode, one may be the smaller difference of the other and ζ.
        let scale = [&self.first, &self.second].map(|mode| {
            (alpha.value() / mode.frequency).abs()
                + (beta.value() * mode.frequency).abs()
                + mode.damping_ratio
        });
        let back = |mode: &KnownModeGiven<W>| {
            rayleigh::damping_ratio(alpha, beta, mode.frequency) - mode.damping_ratio
        };
        sheet.check_zero(
            "the coefficients reproduce the damping ratio of the first mode",
            back(first),
            scale[0],
        );
        sheet.check_zero(
            "the coefficients reproduce the damping ratio of the second mode",
            back(second),
            scale[1],
        );
        sheet.answer("mass_coefficient", "Mass-proportional damping coefficient", alpha);
        sheet.answer("stiffness_coefficient", "Stiffness-proportional damping coefficient", beta);
        let mut least = None;
        if alpha.value() > 0.0 && beta.value() > 0.0 {
            let between = || (w1 + w2) / 2.0;
            sheet.common_error("ω₀", "the minimum assumed halfway between the two frequencies", between);
            let geometric = || (w1 * w2).sqrt();
            sheet.common_error("ω₀", "the geometric mean of the two frequencies taken", geometric);
            let at = sheet.step("ω₀", "Hz", (alpha / beta).sqrt(), "Frequency of minimum damping ratio");
            let zeta = sheet.step(
                "ζ₀",
                "1",
                (alpha * beta).sqrt(),
                "The minimum damping ratio, where both terms are equal",
            );
            sheet.check(
                "minimum damping ratio from the sum of both terms",
                rayleigh::damping_ratio(alpha, beta, at),
                zeta,
            );
            sheet.check(
                "the damping ratio is the same an octave above and an octave below its minimum",
                rayleigh::damping_ratio(alpha, beta, at * 2.0),
                rayleigh::damping_ratio(alpha, beta, at / 2.0),
            );
            sheet.answer("least_frequency", "Frequency of minimum damping", at);
            sheet.answer("least_damping_ratio", "Minimum damping ratio", zeta);
            least = Some((at.value(), zeta.value()));
        } else {
            sheet.warn(|| {
                Text::new(
                    "a coefficient is negative: at very low or very high frequencies the damping ratio would be negative and such modes would be unstable",
                )
            });
        }
        if let Some(asked) = given.asked {
            let straight = || z1 + (z2 - z1) * (asked - w1) / (w2 - w1);
            let what = "the damping ratio interpolated linearly between the two modes";
            sheet.common_error("ζ", what, straight);
            let zeta = sheet.step(
                "ζ",
                "1",
                rayleigh::damping_ratio(alpha, beta, asked),
                ("Damping ratio at the requested frequency", CLOUGH.at("§12-6")),
            );
            sheet.answer("damping_ratio", "Damping ratio at the frequency", zeta);
            sheet.verify(|| {
                // 2ζω is a straight line over ω², through both modes.
                let [low, here, high] = [first.frequency, asked, second.frequency].map(|w| w.powi(2));
                let parts = [
                    first.frequency * first.damping_ratio * (high - here) / (high - low),
                    second.frequency * second.damping_ratio * (here - low) / (high - low),
                ];
                let size = parts.map(|part| part.value().abs()).iter().sum::<f64>();
                sheet.check_sum(
                    "damping ratio from the line of 2ζω over ω² through both modes",
                    zeta * asked,
                    parts[0] + parts[1],
                    size.max((zeta * asked).value().abs()),
                );
            });
            if zeta.value() < 0.0 {
                sheet.warn(|| {
                    Text::new(
                        "at the requested frequency the damping ratio is negative: such a mode is unstable",
                    )
                });
            }
        }
        let coefficients = (alpha.value(), beta.value());
        sheet.show(|| Exhibit::Plot(self.curve(coefficients, least)));
        Ok(())
    }
}

impl RayleighDamping {
    fn curve(&self, (alpha, beta): (f64, f64), least: Option<(f64, f64)>) -> Plot {
        let known = [&self.first, &self.second].map(|mode| (mode.frequency, mode.damping_ratio));
        let marks = known.map(|mode| mode.0).into_iter().chain(least.map(|at| at.0)).chain(self.asked);
        let low = marks.clone().fold(f64::INFINITY, f64::min) / 3.0;
        let high = marks.fold(0.0, f64::max) * 3.0;
        let frequency = |n: u32| low * (high / low).powf(f64::from(n) / 300.0);
        let curve =
            |of: &dyn Fn(f64) -> f64| (0..=300).map(frequency).map(|w| (w, of(w))).collect::<Vec<_>>();
        Plot::new(
            "Damping ratio against frequency",
            Axis::log("frequency", "Hz"),
            Axis::linear("damping ratio", "%"),
            vec![
                Series::line("both", curve(&|w| rayleigh::damping_ratio(alpha, beta, w))).of("damping_ratio"),
                Series::line("of the mass", curve(&|w| alpha / (2.0 * w))),
                Series::line("of the stiffness", curve(&|w| beta * w / 2.0)),
                Series::dots("given", known.to_vec()).of("damping_ratio"),
            ],
        )
        .over("asked")
    }
}
