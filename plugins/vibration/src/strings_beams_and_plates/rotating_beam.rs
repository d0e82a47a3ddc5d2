//! Bending vibration of a blade that turns with its hub.

use std::cell::OnceCell;

use dalembert_core::{
    About, Analysis, Axis, Drawing, Exhibit, Ink, Inputs, Name, Plot, Refusal, Series, Sketch, Text,
    Worksheet, register,
};
use dalembert_mechanics::{
    Real,
    beam::{
        rotating::Rotating,
        tapered::{Ritz, RitzShape},
    },
};
use dalembert_numerics::gauss_legendre;

use crate::{
    shared::{
        continuous::{LineMass, Sampled, line_mass, shapes_film, shapes_plot},
        section::{Profile, profile},
    },
    sources::{RAO, SOUTHWELL, WRIGHT},
};

/// The blade, its hub and its speed.
#[derive(Clone, Debug, Inputs)]
pub struct RotatingBeam {
    /// Length of the blade.
    #[input("L", "m", positive)]
    pub length: f64,
    /// Section.
    pub section: Profile,
    /// Young's modulus.
    #[input("E", "Pa", positive)]
    pub young: f64,
    /// Mass of the blade.
    pub mass: LineMass,
    /// Radius of the hub.
    /// From the axis to the clamped end.
    #[input("R", "m", nonnegative, default = "0 m")]
    pub hub: f64,
    /// Mass at the tip.
    #[input("m_t", "kg", nonnegative)]
    pub tip: Option<f64>,
    /// Rotational speed.
    #[input("n", "rpm", nonnegative)]
    pub speed: f64,
    /// Direction of the motion.
    pub direction: BladeDirection,
    /// Number of frequencies.
    #[input(min = 1, max = 5, default = "3")]
    pub modes: usize,
}

/// Direction of vibration of the blade.
#[derive(Clone, Debug, Inputs)]
pub enum BladeDirection {
    /// Out of the plane of rotation (flapwise)
    Flapwise,
    /// In the plane of rotation (lagwise)
    Lagwise,
    /// At an angle to the axis of rotation
    Angle {
        /// Angle between the motion and the axis of rotation.
        /// 0° is flapwise, 90° edgewise.
        #[input("ψ", "deg", min = 0, max = 90)]
        angle: f64,
    },
}

register!(RotatingBeam);

/// Terms of the trial functions.
const TERMS: usize = 24;

impl Analysis for RotatingBeam {
    const ABOUT: About = About {
        id: "vibration/rotating-beam",
        title: "Rotating blade",
        topic: "Strings, beams and plates",
        summary: "Frequencies of a uniform blade on a rotating hub, flapwise or edgewise, with centrifugal stiffening, Southwell's coefficients and the Campbell diagram.",
        main: &["frequency"],
        keywords: "turbine blade propeller helicopter rotor centrifugal stiffening Southwell Campbell flap lag pá \
                   palheta turbina hélice enrijecimento centrífugo",
        sources: &[&WRIGHT, &SOUTHWELL, &RAO],
        cases: include_str!("../../cases/rotating_beam.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &RotatingBeamGiven<W>, sheet: W) -> Result<(), Refusal> {
        let (area, second_moment) = profile(&given.section, 0, sheet)?;
        let line = line_mass(&given.mass, 0, area, sheet);
        let length = given.length;
        let bending = sheet.step("EI", "N*m^2", given.young * second_moment, "Bending stiffness");
        let unit = sheet.step(
            "ω_u",
            "rad/s",
            (bending / (line * length.powi(4))).sqrt(),
            ("The frequencies are multiples of √(EI/(m̄L⁴))", RAO.at("§8.5")),
        );
        let speed = sheet.step("Ω", "rad/s", given.speed, "Rotational speed");
        let eta =
            sheet.step("η", "1", speed / unit, ("Speed in multiples of this unit", WRIGHT.at("pp. 197–202")));
        let hub = sheet.step("r", "1", given.hub / length, "Radius of the hub over the length");
        let tip = given
            .tip
            .map(|tip| sheet.step("μ", "1", tip / (line * length), "Mass at the tip over that of the blade"));
        // The share of the square of the speed that the motion in the plane of rotation loses.
        let plane = match &given.direction {
            BladeDirectionGiven::Flapwise {} => None,
            BladeDirectionGiven::Lagwise {} => Some(W::Num::from(1.0)),
            BladeDirectionGiven::Angle { angle } => Some(angle.sin()),
        };
        let blade = Rotating { speed: eta.value(), hub: hub.value(), tip: tip.map_or(0.0, Real::value) };
        let Ritz { lambdas, shapes } = ritz(&blade, TERMS, self.modes)?;
        let before = ritz(&blade, TERMS - 3, self.modes)?.lambdas;
        let rest = ritz(&Rotating { speed: 0.0, ..blade }, TERMS, self.modes)?;
        let creeping = Rotating { speed: 1e-2 / ((1.0 + blade.hub) * (1.0 + blade.tip)), ..blade };
        let slow = OnceCell::new();
        sheet.keep_going()?;
        for (n, (lambda, shape)) in (1..).zip(lambdas.iter().zip(&shapes)) {
            if (lambda / before[n - 1] - 1.0).abs() > 1e-9 {
                return Err(Refusal::because(
                    "the blade rotates so fast for its stiffness that its mode shapes do not converge: write a lower speed, or analyse it as a string",
                ));
            }
            let still = sheet.numerical(
                ("Λ₀", n),
                "1",
                rest.lambdas[n - 1].sqrt(),
                (
                    Text::new("Frequency number of mode {n} at rest, ω over √(EI/(m̄L⁴))").with("n", n),
                    RAO.at("§8.5"),
                ),
            );
            let number = sheet.numerical(
                ("Λ", n),
                "1",
                lambda.sqrt(),
                (
                    "Rayleigh–Ritz with polynomials that satisfy the clamped end, the work of the centrifugal tension included: a converged upper bound",
                    WRIGHT.at("pp. 197–202"),
                ),
            );
            let at_rest = || still * unit;
            sheet.common_error(("ω_f", n), "the stiffening by the centrifugal force left out", at_rest);
            let rigid = || ((still * unit).powi(2) + speed.powi(2)).sqrt();
            sheet.common_error(("ω_f", n), "Southwell's coefficient taken as 1", rigid);
            let flap = sheet.step(
                ("ω_f", n),
                "rad/s",
                number * unit,
                Text::new("Natural frequency {n}, out of the plane of rotation").with("n", n),
            );
            let omega = match plane {
                None => flap,
                Some(share) => {
                    let square = flap.powi(2) - (speed * share).powi(2);
                    if square.value() <= 0.0 {
                        return Err(Refusal::because(
                            "the blade is unstable in the plane of rotation: write a larger stiffness",
                        ));
                    }
                    let at_rest = || still * unit;
                    sheet.common_error(("ω", n), "the frequency at rest used, rotation left out", at_rest);
                    let whole = || (flap.powi(2) - speed.powi(2)).sqrt();
                    sheet.common_error(("ω", n), "the motion taken to lie in the plane of rotation", whole);
                    sheet.step(
                        ("ω", n),
                        "rad/s",
                        square.sqrt(),
                        (
                            "In the plane of rotation the centrifugal force rotates with the blade and subtracts Ω²",
                            WRIGHT.at("pp. 197–202"),
                        ),
                    )
                }
            };
            let frequency = sheet.step(("f", n), "Hz", omega, "In cycles per second");
            sheet.answer(("frequency", n), "Natural frequency", frequency);
            sheet.answer(("number", n), "Out-of-plane frequency number, ω_f√(m̄L⁴/(EI))", number);
            sheet.verify(|| {
                sheet.check(
                    Text::new("mode shape {n}: the moments of tension and inertia forces balance the bending moment")
                        .with("n", n),
                    W::Num::from(blade.moment_balance(shape)),
                    number.powi(2),
                );
                let lost = plane.map_or(0.0, |share| (speed * share).value().powi(2));
                sheet.check(
                    Text::new(
                        "frequency {n}: including the reduction in the plane of rotation, from the same balance",
                    )
                    .with("n", n),
                    W::Num::from((frequency.value().powi(2) + lost) / unit.value().powi(2)),
                    W::Num::from(blade.moment_balance(shape)),
                );
            });
            let still_shape = &rest.shapes[n - 1];
            if eta.value() > 0.0 {
                let coefficient = sheet.step(
                    ("S", n),
                    "1",
                    (number.powi(2) - still.powi(2)) / eta.powi(2),
                    ("Southwell's coefficient: ω_f² = ω₀² + S Ω² at this speed", SOUTHWELL.at("R&M 766")),
                );
                sheet.answer(("southwell", n), "Southwell's coefficient at this speed", coefficient);
            }
            let coefficient = sheet.numerical(
                ("S₀", n),
                "1",
                blade.southwell(still_shape),
                (
                    "Southwell's coefficient from the mode shape at rest: work of the centrifugal tension at unit speed over the kinetic energy",
                    SOUTHWELL.at("R&M 766"),
                ),
            );
            sheet.answer(
                ("southwell_at_rest", n),
                "Southwell's coefficient from the mode shape at rest",
                coefficient,
            );
            sheet.verify(|| {
                sheet.check(
                    Text::new(
                        "mode shape {n}: work of the centrifugal forces through the shortening of the blade, over its kinetic energy",
                    )
                    .with("n", n),
                    W::Num::from(shortening_work(&blade, still_shape)),
                    coefficient,
                );
                // At small speeds the coefficient is the slope of λ over η².
                let slow = slow.get_or_init(|| ritz(&creeping, TERMS, self.modes).ok());
                let slope =
                    slow.as_ref().map_or(f64::NAN, |slow| creeping.moment_balance(&slow.shapes[n - 1]));
                let line = rest.lambdas[n - 1] + creeping.speed.powi(2) * coefficient.value();
                sheet.check(
                    Text::new(
                        "mode {n}: the moment balance at low speed rises by Southwell's coefficient",
                    )
                    .with("n", n),
                    W::Num::from(slope),
                    W::Num::from(line),
                );
            });
        }
        sheet.show(|| self.campbell(&blade, unit.value()));
        let sampled = || -> Vec<Sampled> {
            let one =
                |(n, shape): (usize, &RitzShape)| Sampled::new(n, self.length, |xi| shape.deflection(xi));
            (1..).zip(&shapes).map(one).collect()
        };
        sheet.show(|| shapes_plot(&sampled()));
        sheet.show(|| Exhibit::Drawing(self.drawing()));
        sheet.show(|| {
            shapes_film(&sampled(), self.length, |sketch, _, y| {
                sketch.ground((0.0, y + 0.5), (0.0, y - 0.5));
            })
        });
        Ok(())
    }
}

impl RotatingBeam {
    /// The blade on its hub, which is drawn with a radius of its own where there is none.
    fn drawing(&self) -> Drawing {
        const WIDTH: f64 = 5.0;
        let hub = (self.hub / self.length * WIDTH).clamp(0.5, 3.0);
        let mut sketch = Sketch::new("The blade on its hub, and its section");
        sketch
            .mass("", (0.0, -0.1), (WIDTH, 0.1))
            .disc("", (-hub, 0.0), hub)
            .joint("", (-hub, 0.0))
            .dimension("L", (0.0, -0.5), (WIDTH, -0.5), -1.0);
        if self.hub > 0.0 {
            sketch.dimension("R", (-hub, 0.0), (0.0, 0.0), 0.0);
        }
        sketch.couple("n", (-hub, 0.0), (0.6, 2.4), Ink::Motion);
        if self.tip.is_some() {
            sketch.round("m_t", (WIDTH, 0.0), 0.2, Ink::Body);
        }
        if let BladeDirection::Angle { .. } = self.direction {
            sketch.label("ψ", (WIDTH, 0.1));
        }
        self.section.draw(&mut sketch, (WIDTH + 1.3, 0.0), 0.9);
        sketch.finish()
    }
}

/// Work of the centrifugal forces of unit speed on the way by which each point comes nearer as the blade bends,
/// `½ ∫₀ˢ φ′² dξ`, over half the kinetic energy of the shape.
fn shortening_work(blade: &Rotating, shape: &RitzShape) -> f64 {
    let points = gauss_legendre::legendre(TERMS + 4);
    let over = |to: f64, of: &dyn Fn(f64) -> f64| -> f64 {
        points.iter().map(|(xi, weight)| to * weight * of(to * xi)).sum()
    };
    let nearer = |s: f64| over(s, &|xi| shape.slope(xi).powi(2));
    let work = over(1.0, &|s| (blade.hub + s) * nearer(s)) + blade.tip * (blade.hub + 1.0) * nearer(1.0);
    let kinetic = over(1.0, &|s| shape.deflection(s).powi(2)) + blade.tip * shape.deflection(1.0).powi(2);
    work / kinetic
}

impl RotatingBeam {
    /// The frequencies over the speed, with the multiples of the speed.
    fn campbell(&self, blade: &Rotating, unit: f64) -> Exhibit {
        const POINTS: u16 = 24;
        // Far enough for the first mode to rise.
        let still = Rotating { speed: 0.0, ..*blade }.ritz(14, 1).ok();
        let still = still
            .and_then(|ritz| ritz.lambdas.first().copied())
            .map_or(4.0, |lambda| 1.5 * lambda.abs().sqrt());
        let last = still.max(2.0 * blade.speed);
        let share = match self.direction {
            BladeDirection::Flapwise => 0.0,
            BladeDirection::Lagwise => 1.0,
            BladeDirection::Angle { angle } => angle.sin(),
        };
        let speeds: Vec<f64> = (0..=POINTS).map(|n| last * f64::from(n) / f64::from(POINTS)).collect();
        let roots: Vec<Vec<f64>> = speeds
            .iter()
            .map(|speed| {
                let here = Rotating { speed: *speed, ..*blade };
                here.ritz(14, self.modes).map_or_else(|_| Vec::new(), |ritz| ritz.lambdas)
            })
            .collect();
        let mode = |n: usize| {
            let point = |(speed, lambdas): (&f64, &Vec<f64>)| {
                let square = lambdas.get(n)? - (speed * share).powi(2);
                (square > 0.0).then(|| (speed * unit, square.sqrt() * unit))
            };
            let points = speeds.iter().zip(&roots).filter_map(point).collect();
            Series::line(Text::new("mode {n}").with("n", n + 1), points).of(Name::from(("frequency", n + 1)))
        };
        let highest = roots.last().and_then(|lambdas| lambdas.last()).map_or(1.0, |lambda| lambda.sqrt());
        let order = |k: u16| {
            let k = f64::from(k);
            let end = last.min(highest / k);
            let points = vec![(0.0, 0.0), (end * unit, k * end * unit)];
            Series::line(Text::new("{order}× speed").with("order", k as usize), points)
        };
        let mut series: Vec<Series> = (0..self.modes).map(mode).collect();
        series.extend([1, 2, 4].map(order));
        Exhibit::Plot(
            Plot::new(
                "Frequencies against speed",
                Axis::linear("speed of rotation", "rpm"),
                Axis::linear("natural frequency", "Hz"),
                series,
            )
            .over("speed"),
        )
    }
}

fn ritz(blade: &Rotating, terms: usize, count: usize) -> Result<Ritz, Refusal> {
    let found = blade.ritz(terms, count).ok();
    found.filter(|ritz| ritz.lambdas.iter().all(|lambda| lambda.is_finite() && *lambda > 0.0)).ok_or_else(|| {
        Refusal::because(
            "the frequencies cannot be found: speed, hub and mass at the tip are too large for this blade",
        )
    })
}
