//! An oscillator with an elastic dry-friction damper (Jenkins element), by one harmonic.

use std::{f64::consts::PI, ops::ControlFlow};

use dalembert_core::{
    About, Analysis, Axis, Drawing, Exhibit, Ink, Inputs, Plot, Refusal, Series, Sketch, Text, Worksheet,
    register,
};
use dalembert_mechanics::{
    Real, sdof,
    vibration::jenkins::{self, JenkinsOscillator, ResponsePoint},
};
use dalembert_numerics::roots;

use crate::{
    shared::oscillator::{Mass, mass},
    sources::RAO,
};

/// The oscillator, its damper, and the force.
#[derive(Clone, Debug, Inputs)]
pub struct FrictionDamper {
    /// Mass or weight.
    pub mass: Mass,
    /// Stiffness in parallel with the damper.
    #[input("k", "N/m", positive)]
    pub stiffness: f64,
    /// Additional viscous damping.
    #[input("c", "N*s/m", nonnegative, default = "0 N*s/m")]
    pub damping: f64,
    /// Stiffness of the friction element.
    /// Of the spring in series with its slider.
    #[input("k_d", "N/m", positive)]
    pub element: f64,
    /// Force at which slip begins.
    #[input("F_d", "N", positive)]
    pub slip_force: f64,
    /// Amplitude of the force.
    #[input("F₀", "N", positive)]
    pub force: f64,
    /// Frequency at which the amplitude is requested.
    #[input("ω", "rad/s", positive)]
    pub frequency: Option<f64>,
}

register!(FrictionDamper);

impl Analysis for FrictionDamper {
    const ABOUT: About = About {
        id: "vibration/friction-damper",
        title: "Elastic dry-friction damper",
        topic: "Isolation, absorbers and instruments",
        summary: "Peak of the response and amplitude at a frequency of an oscillator with a spring-and-slider damper, by one harmonic.",
        main: &["peak_amplitude", "peak_frequency", "amplitude"],
        keywords: "jenkins element coulomb slip stick harmonic balance underplatform turbine blade hysteresis \
                   amortecedor de atrito elástico elemento de jenkins balanço harmônico palheta",
        sources: &[&RAO],
        cases: include_str!("../../cases/friction_damper.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &FrictionDamperGiven<W>, sheet: W) -> Result<(), Refusal> {
        let mass = mass(&given.mass, sheet);
        let oscillator = JenkinsOscillator {
            mass: mass.value(),
            damping: self.damping,
            stiffness: self.stiffness,
            element: self.element,
            slip_force: self.slip_force,
            force: self.force,
        };
        let both = || given.slip_force / (given.stiffness + given.element);
        sheet.common_error("x_y", "both springs taken to carry the slip force", both);
        let slip = sheet.step(
            "x_y",
            "µm",
            given.slip_force / given.element,
            "Displacement at which the element begins to slip",
        );
        let stuck = sheet.step(
            "ω₁",
            "rad/s",
            sdof::natural_frequency(given.stiffness + given.element, mass),
            "Natural frequency while the element sticks: both springs act",
        );
        let slipping = sheet.step(
            "ω₂",
            "rad/s",
            sdof::natural_frequency(given.stiffness, mass),
            "Natural frequency far beyond the slip limit: the element only slides",
        );
        sheet.answer("slip_displacement", "Displacement at which slip begins", slip);
        sheet.check_sum(
            "stiffness of the element = stiffness added by sticking, m (ω₁² − ω₂²)",
            mass * (stuck.powi(2) - slipping.powi(2)),
            given.element,
            (given.stiffness + given.element).value(),
        );
        sheet.answer("stuck_frequency", "Natural frequency, sticking", stuck);
        sheet.answer("slipping_frequency", "Natural frequency, slipping", slipping);
        let Some(peak) = oscillator.peak() else {
            return Err(Refusal::because(
                "the force supplies more energy per cycle than the slipping element can dissipate, since 4F_d/π is below F₀, and there is no other damping: the resonance grows with time without bound",
            ));
        };
        let frequency = sheet.numerical(
            "ωₚ",
            "rad/s",
            peak.frequency,
            "Peak of the response by one harmonic: the frequency at which that amplitude requires the least force",
        );
        let viscous = || given.force / (given.damping * frequency);
        sheet.common_error("Xₚ", "the viscous damper alone taken to dissipate energy", viscous);
        let rigid = || (given.force - given.slip_force * 4.0 / PI) / (given.damping * frequency);
        sheet.common_error("Xₚ", "the spring of the friction element taken as rigid", rigid);
        let amplitude = sheet.numerical("Xₚ", "µm", peak.amplitude, "Amplitude at that frequency");
        let [stiffness, quadrature] =
            balance(given, [mass, slip, frequency, amplitude], PEAK, &oscillator, sheet);
        sheet.verify(|| {
            // d|D|²/dω = 0, in units of its terms.
            let left = mass * frequency * (stiffness - mass * frequency.powi(2)) * 2.0;
            let right = given.damping * (given.damping * frequency + quadrature);
            let scale = mass.value() * frequency.value() * stiffness.value();
            sheet.check_zero(
                "the minimum force has zero slope with respect to frequency",
                left - right,
                scale,
            );
        });
        sheet.answer("peak_frequency", "Frequency of the peak", frequency);
        sheet.answer("peak_amplitude", "Amplitude at the peak", amplitude);
        let mut asked = None;
        if let Some(given_frequency) = given.frequency {
            let amplitudes = oscillator.amplitudes(given_frequency.value());
            let Some(&largest) = amplitudes.last() else {
                return Err(Refusal::because(
                    "at this frequency the force exceeds the slip force and the damping: there is no steady-state amplitude",
                ));
            };
            if amplitudes.len() > 1 {
                sheet.warn(|| {
                    Text::new("there is more than one amplitude at this frequency; the largest is given")
                });
            }
            let linear = |stiffness: W::Num| {
                sdof::forced_amplitude(given.force, stiffness, mass, given.damping, given_frequency)
            };
            let sticking = || linear(given.stiffness + given.element);
            sheet.common_error("X", "the friction element taken to stick at every amplitude", sticking);
            sheet.common_error("X", "the friction element left out", || linear(given.stiffness));
            let found = sheet.numerical(
                "X",
                "µm",
                largest,
                "Amplitude at the requested frequency, where amplitude and dynamic stiffness balance the force",
            );
            balance(given, [mass, slip, given_frequency, found], ASKED, &oscillator, sheet);
            sheet.answer("amplitude", "Amplitude at this frequency", found);
            asked = Some(ResponsePoint { frequency: given_frequency.value(), amplitude: largest });
        }
        sheet.show(|| Exhibit::Plot(response(&oscillator, &peak, asked)));
        sheet.show(|| Exhibit::Plot(hysteresis(&oscillator, peak.amplitude)));
        sheet.show(|| Exhibit::Drawing(drawing()));
        Ok(())
    }
}

/// Symbols of the steps at the peak, and at the asked frequency.
const PEAK: [&str; 5] = ["θₚ", "kₚ", "Wₚ", "hₚ", "Kₚ"];
const ASKED: [&str; 5] = ["θ", "k_j", "W", "h", "K"];

/// Stiffness and quadrature part at an amplitude, compared with the force and to the summed loop.
fn balance<W: Worksheet>(
    given: &FrictionDamperGiven<W>,
    [mass, slip, frequency, amplitude]: [W::Num; 4],
    symbols: [&'static str; 5],
    oscillator: &JenkinsOscillator,
    sheet: W,
) -> [W::Num; 2] {
    let [angle, element, area, quadrature, whole] = symbols;
    let (stiffness, quadrature) = if amplitude.value() <= slip.value() {
        let stiffness = sheet.step(
            whole,
            "N/m",
            given.stiffness + given.element,
            "The element sticks at this amplitude: both springs act, and no energy is dissipated",
        );
        (stiffness, W::Num::from(0.0))
    } else {
        let angle = sheet.step(
            angle,
            "rad",
            jenkins::elastic_angle(slip, amplitude),
            "Sticking part of each half-cycle, as an angle",
        );
        let element = sheet.step(
            element,
            "N/m",
            jenkins::equivalent_stiffness(given.element, angle),
            "Equivalent stiffness of the element: first harmonic of its force in phase with the motion",
        );
        let area = sheet.step(
            area,
            "J",
            jenkins::loop_area(given.slip_force, amplitude, slip),
            "Energy dissipated by the element per cycle: area of its loop",
        );
        let quadrature = sheet.step(
            quadrature,
            "N/m",
            jenkins::quadrature_stiffness(area, amplitude),
            ("First harmonic in phase with the velocity, per unit amplitude", RAO.at("§3.9")),
        );
        sheet.verify(|| {
            let [summed, part] = oscillator.harmonic_by_summation(amplitude.value());
            sheet.check(
                "equivalent stiffness by integration around the hysteresis loop",
                W::Num::from(summed),
                element,
            );
            sheet.check(
                "component in phase with the velocity, by integration around the hysteresis loop",
                W::Num::from(part),
                quadrature,
            );
        });
        let stiffness = sheet.step(whole, "N/m", given.stiffness + element, "Combined stiffness");
        (stiffness, quadrature)
    };
    sheet.check(
        "amplitude times dynamic stiffness equals the force",
        amplitude
            * ((stiffness - mass * frequency.powi(2)).powi(2)
                + (given.damping * frequency + quadrature).powi(2))
            .sqrt(),
        given.force,
    );
    [stiffness, quadrature]
}

/// The response by one harmonic: amplitude by amplitude, the frequency below and the one above its softest.
fn response(oscillator: &JenkinsOscillator, peak: &ResponsePoint, asked: Option<ResponsePoint>) -> Plot {
    let top = 2.0 * ((oscillator.stiffness + oscillator.element) / oscillator.mass).sqrt();
    let (mut below, mut above) = (Vec::new(), Vec::new());
    for n in 0..=120u16 {
        // Dense towards the peak, down to a hundredth of it.
        let part = 1.0 - f64::from(n) / 120.0;
        let amplitude = peak.amplitude * (1.0 - 1e-9) * 10f64.powf(-2.0 * part * part);
        let softest = oscillator.softest_frequency(amplitude);
        let excess = |w: f64| amplitude * oscillator.dynamic_stiffness(w, amplitude) - oscillator.force;
        let crossing = |ends: [f64; 2]| roots::find(excess, ends, |_| ControlFlow::Continue(())).ok();
        below.extend(crossing([0.0, softest]).map(|w| (w, amplitude)));
        above.extend(crossing([softest, top]).map(|w| (w, amplitude)));
    }
    above.reverse();
    let mut curve = below;
    curve.push((peak.frequency, peak.amplitude));
    curve.extend(above);
    curve.retain(|point| point.0 <= top);
    let linear = |stiffness: f64| {
        let at = move |n: u16| {
            let w = top * f64::from(n) / 300.0;
            (w, sdof::forced_amplitude(oscillator.force, stiffness, oscillator.mass, oscillator.damping, w))
        };
        (1..=300u16).map(at).collect::<Vec<_>>()
    };
    let mut series = vec![Series::line("with the element", curve).of("amplitude")];
    if oscillator.damping > 0.0 {
        series.push(Series::line("continuous sticking", linear(oscillator.stiffness + oscillator.element)));
        series.push(Series::line("without the element", linear(oscillator.stiffness)));
    }
    let mut plot = Plot::new(
        "Amplitude against frequency",
        Axis::linear("frequency of the force", "rad/s"),
        Axis::log("amplitude", "µm"),
        series,
    )
    .over("frequency")
    .mark("peak", (peak.frequency, peak.amplitude))
    .level("onset of slip", oscillator.slip_displacement());
    if let Some(asked) = asked {
        plot = plot.mark("at this frequency", (asked.frequency, asked.amplitude));
    }
    plot
}

/// The loop of the element at the peak.
fn hysteresis(oscillator: &JenkinsOscillator, amplitude: f64) -> Plot {
    let (slip, force) = (oscillator.slip_displacement(), oscillator.slip_force);
    let points = if amplitude <= slip {
        let end = oscillator.element * amplitude;
        vec![(-amplitude, -end), (amplitude, end)]
    } else {
        let back = 2.0 * slip - amplitude;
        vec![(-amplitude, -force), (back, force), (amplitude, force), (-back, -force), (-amplitude, -force)]
    };
    Plot::new(
        "Hysteresis loop of the element at the peak",
        Axis::linear("displacement", "µm"),
        Axis::linear("force", "N"),
        vec![Series::line("force of the element", points)],
    )
}

fn drawing() -> Drawing {
    Sketch::new("The oscillator and its friction element")
        .ground((-2.6, 1.2), (-2.6, -1.2))
        .spring("k", (-2.6, 0.7), (-0.7, 0.7))
        .damper("c", (-2.6, 0.0), (-0.7, 0.0))
        .block("F_d", (-2.3, -0.95), (-1.8, -0.55), Ink::Danger)
        .bars([(-2.6, -0.95), (-1.6, -0.95)])
        .spring("k_d", (-1.8, -0.75), (-0.7, -0.75))
        .mass("m", (-0.7, -1.0), (0.7, 1.0))
        .force("F₀ cos(ω t)", (0.7, 0.0), (1.7, 0.0))
        .finish()
}
