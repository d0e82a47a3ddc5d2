//! A chain of masses on a randomly excited base.

use dalembert_core::{
    About, Analysis, Axis, Exhibit, Inputs, Plot, Refusal, Series, Symbol, Text, Worksheet, register,
};
use dalembert_mechanics::{
    Real,
    vibration::random::{
        Resonance, absolute_squared, integrate, integrate_about, miles, relative_squared, white_displacement,
    },
};

use crate::{
    shared::{
        chain::{self, ChainMass, WorkedMode},
        spectral_density::{AccelerationDensity, AccelerationDensityGiven, Spectrum, not_found},
    },
    sources::{CHOPRA, RAO},
};

/// The chain, its damping and what shakes its base.
#[derive(Clone, Debug, Inputs)]
pub struct RandomChain {
    /// Masses and springs.
    /// Starting from the base.
    #[input(min = 1)]
    pub links: Vec<ChainMass>,
    /// Damping ratio of every mode.
    #[input("ζ", "1", nonnegative, default = "0.02")]
    pub ratio: f64,
    /// Power spectral density of the base acceleration.
    /// Stationary, Gaussian, zero mean.
    pub density: AccelerationDensity,
}

register!(RandomChain);

impl Analysis for RandomChain {
    const ABOUT: About = About {
        id: "vibration/random-chain",
        title: "Chain of masses under random base excitation",
        topic: "Random vibration and earthquakes",
        summary: "Root mean square of displacement and acceleration of each mass of a chain whose base moves with a spectral density, with modal damping.",
        main: &["displacement", "acceleration"],
        keywords: "psd random vibration rms one sigma modal damping multi degree chain vibração aleatória densidade \
                   espectral vários graus de liberdade cadeia de massas amortecimento modal um sigma",
        sources: &[&RAO, &CHOPRA],
        cases: include_str!("../../cases/random_chain.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &RandomChainGiven<W>, sheet: W) -> Result<(), Refusal> {
        if self.ratio == 0.0 {
            return Err(Refusal::because(
                "without damping a random excitation makes the motion grow without bound, as √t: give a damping ratio",
            ));
        }
        let spectrum = self.density.spectrum()?;
        let modes = chain::modes(&given.links, sheet)?;
        common_errors(given, &modes, sheet);
        let problem = Excited::new(&modes, self.ratio, spectrum);
        for mass in 0..given.links.len() {
            problem.answers(mass, sheet)?;
        }
        sheet.show(|| Exhibit::Plot(problem.plot(given.links.len())));
        sheet.show(|| Exhibit::Drawing(chain::drawing(&self.links).finish()));
        Ok(())
    }
}

/// Common errors in the root mean squares under a level: formulas of white noise for modes by themselves.
fn common_errors<W: Worksheet>(given: &RandomChainGiven<W>, modes: &[WorkedMode<W::Num>], sheet: W) {
    let (AccelerationDensityGiven::White { level } | AccelerationDensityGiven::Band { level, .. }) =
        &given.density
    else {
        return;
    };
    let displacement = |mode: &WorkedMode<W::Num>| white_displacement(*level, mode.natural, given.ratio);
    let acceleration = |mode: &WorkedMode<W::Num>| miles(*level, mode.natural, given.ratio);
    for mass in 0..given.links.len() {
        let [moved, pushed] = ["σ_z", "σ_a"].map(|symbol| Symbol::from(symbol).row(mass + 1));
        let first = || modes[0].shares[mass].abs() * displacement(&modes[0]).sqrt();
        sheet.common_error(moved, FIRST_MODE, first);
        let first = || modes[0].shares[mass].abs() * acceleration(&modes[0]).sqrt();
        sheet.common_error(pushed, FIRST_MODE, first);
        let unscaled = || acceleration(&modes[0]).sqrt();
        let what = "Miles' formula used with the first frequency, as for one degree of freedom";
        sheet.common_error(pushed, what, unscaled);
        let apart = |of: &dyn Fn(&WorkedMode<W::Num>) -> W::Num| {
            W::Num::sum(modes.iter().map(|mode| mode.shares[mass].powi(2) * of(mode))).sqrt()
        };
        if modes.len() > 1 {
            sheet.common_error(moved, UNCORRELATED, || apart(&displacement));
            sheet.common_error(pushed, UNCORRELATED, || apart(&acceleration));
        }
    }
}

/// Common errors of the modes.
const FIRST_MODE: &str = "the first mode alone counted, by the formula for white noise";
const UNCORRELATED: &str =
    "the mean squares of the modes added by the formula for white noise, without cross terms";

/// A chain under a density.
struct Excited {
    /// The modes with their shares in the motion of each mass.
    modes: Vec<Vec<(Resonance, f64)>>,
    spectrum: Spectrum,
}

/// Response quantity of a mass.
#[derive(Clone, Copy)]
enum Response {
    Displacement,
    RelativeAcceleration,
    AbsoluteAcceleration,
}

impl Excited {
    fn new<N: Real>(modes: &[WorkedMode<N>], ratio: f64, spectrum: Spectrum) -> Self {
        let at = |mass: usize| {
            let mode = |mode: &WorkedMode<N>| {
                (Resonance { natural: mode.numbers.natural, ratio }, mode.shares[mass].value())
            };
            modes.iter().map(mode).collect()
        };
        Self { modes: (0..modes.len()).map(at).collect(), spectrum }
    }

    fn resonances(&self) -> impl Iterator<Item = Resonance> + Clone {
        self.modes[0].iter().map(|(mode, _)| *mode)
    }

    /// The root mean squares of a mass.
    fn answers<W: Worksheet>(&self, mass: usize, sheet: W) -> Result<(), Refusal> {
        let place = mass + 1;
        let displacement = self.rms(mass, Response::Displacement, ("σ_z", "mm"), sheet)?;
        sheet.answer(
            ("displacement", place),
            "Root mean square of the relative displacement of mass",
            displacement,
        );
        if matches!(self.spectrum, Spectrum::White(_)) {
            if mass == 0 {
                sheet.warn(|| {
                    Text::new(
                        "under white-noise base acceleration the relative acceleration has no finite mean square: it contains the base acceleration itself",
                    )
                });
            }
        } else {
            let relative = self.rms(mass, Response::RelativeAcceleration, ("σ_r", "m/s^2"), sheet)?;
            sheet.answer(
                ("relative_acceleration", place),
                "Root mean square of the relative acceleration of mass",
                relative,
            );
        }
        let absolute = self.rms(mass, Response::AbsoluteAcceleration, ("σ_a", "m/s^2"), sheet)?;
        sheet.answer(
            ("acceleration", place),
            "Root mean square of the absolute acceleration of mass",
            absolute,
        );
        Ok(())
    }

    fn rms<W: Worksheet>(
        &self,
        mass: usize,
        response: Response,
        (symbol, unit): (&'static str, &'static str),
        sheet: W,
    ) -> Result<W::Num, Refusal> {
        sheet.keep_going()?;
        let points = self.spectrum.breaks(self.resonances());
        let integral =
            integrate(|omega| self.integrand(mass, response, omega), &points).map_err(not_found)?;
        let why = match response {
            Response::Displacement => {
                "Displacement of this mass relative to the base: the frequency responses of all modes are summed, squared and integrated with the spectral density over the band"
            }
            Response::RelativeAcceleration => {
                "Acceleration of this mass relative to the base, by the same integral with ω⁴"
            }
            Response::AbsoluteAcceleration => {
                "Absolute acceleration of this mass: the base acceleration is added before squaring"
            }
        };
        let value = sheet.numerical(
            Symbol::from(symbol).row(mass + 1),
            unit,
            integral.sqrt(),
            (why, RAO.at("ch. 14")),
        );
        sheet.verify(|| match self.partial_fractions(mass, response) {
            Some((closed, scale)) => sheet.check_zero(
                "mean square by partial fractions, mode by mode with their cross terms",
                (value.value().powi(2) - closed).into(),
                scale,
            ),
            None if points.iter().all(|point| point.is_finite()) => {
                let (first, _) = self.modes[0][0];
                let mut points = points.clone();
                points.sort_by(f64::total_cmp);
                points.dedup();
                let second = integrate_about(
                    |omega| self.integrand(mass, response, omega),
                    &points,
                    [first.natural, first.natural * first.ratio],
                );
                sheet.check("root mean square by a rule of fixed panels", second.sqrt().into(), value);
            }
            None => {}
        });
        Ok(value)
    }

    fn integrand(&self, mass: usize, response: Response, omega: f64) -> f64 {
        let modes = &self.modes[mass];
        let squared = match response {
            Response::Displacement => relative_squared(modes, omega),
            Response::RelativeAcceleration => relative_squared(modes, omega) * omega.powi(4),
            Response::AbsoluteAcceleration => absolute_squared(modes, omega),
        };
        squared * self.spectrum.at(omega)
    }

    /// The mean square in closed form where the density is a level, with the size of its terms.
    fn partial_fractions(&self, mass: usize, response: Response) -> Option<(f64, f64)> {
        let modes = &self.modes[mass];
        let terms = match (response, &modes[..]) {
            (Response::Displacement, _) => vec![(0, 1.0)],
            (Response::RelativeAcceleration, _) => vec![(4, 1.0)],
            (Response::AbsoluteAcceleration, [(only, _)]) => {
                vec![(0, only.natural.powi(4)), (2, (2.0 * only.ratio * only.natural).powi(2))]
            }
            (Response::AbsoluteAcceleration, _) => return None,
        };
        let (mut value, mut scale) = (0.0, 0.0);
        for (power, factor) in terms {
            let moment = self.spectrum.partial_fractions(modes, power)?;
            value += factor * moment.value;
            scale += factor * moment.scale;
        }
        Some((value, scale))
    }

    /// The density of the absolute acceleration of each mass.
    fn plot(&self, masses: usize) -> Plot {
        let ends = self.spectrum.ends();
        let first = self.modes[0][0].0.natural;
        let top = self.resonances().fold(first, |most: f64, mode| most.max(mode.natural));
        let least = ends.iter().copied().find(|omega| *omega > 0.0).unwrap_or(first);
        let most = ends.last().copied().filter(|omega| omega.is_finite()).unwrap_or(top);
        let (from, to) = (0.8 * least.min(0.5 * first), 1.25 * most.max(2.0 * top));
        let frequency = |n: u16| from * ((to / from).ln() * f64::from(n) / 400.0).exp();
        let line = |of: &dyn Fn(f64) -> f64| (0..=400).map(|n| (frequency(n), of(frequency(n)))).collect();
        let mut series =
            vec![Series::line("acceleration of the base", line(&|omega| self.spectrum.at(omega)))];
        for mass in 0..masses.min(4) {
            let label = Text::new("mass {place}").with("place", mass + 1);
            let of = |omega: f64| self.integrand(mass, Response::AbsoluteAcceleration, omega);
            series.push(Series::line(label, line(&of)));
        }
        Plot::new(
            "Power spectral density of the absolute acceleration",
            Axis::log("frequency", "Hz"),
            Axis::log("spectral density", "m^2/s^4/Hz"),
            series,
        )
    }
}
