//! A disc at the end of a light shaft: whirl with gyroscopic action and synchronous critical speeds.

use dalembert_core::{
    About, Analysis, Axis, Drawing, Exhibit, Ink, Inputs, Plot, Refusal, Series, Sketch, Symbol, Text,
    Worksheet, register,
};
use dalembert_mechanics::{
    Real,
    rotor::{disc as formula, overhung},
};
use dalembert_numerics::polynomial;

use crate::{
    shared::section::{Section, second_moment},
    sources::{BEER, DEN_HARTOG, FRISWELL},
};

/// The shaft, the disc at its end, and the speed it runs at.
#[derive(Clone, Debug, Inputs)]
pub struct OverhungDisc {
    /// Shaft.
    pub shaft: LightShaft,
    /// Disc.
    pub disc: TiltingDisc,
    /// Speed.
    /// If given, the whirl frequencies at this speed are computed, and the margin to a critical speed.
    #[input("Ω", "rpm", nonnegative)]
    pub speed: Option<f64>,
}

/// Elastic support of the disc; its own mass is neglected.
#[derive(Clone, Debug, Inputs)]
pub enum LightShaft {
    /// Cantilever with the disc at its tip
    Cantilever {
        /// Length.
        #[input("L", "m", positive)]
        length: f64,
        /// Young's modulus.
        #[input("E", "Pa", positive)]
        young: f64,
        /// Section.
        section: Section,
    },
    /// Influence coefficients at the disc
    /// For any other shaft and bearings.
    Influence {
        /// Deflection per unit force.
        #[input("α", "m/N", positive)]
        deflection: f64,
        /// Slope per unit force.
        /// Equal to the deflection per unit moment.
        #[input("β", "rad/N")]
        coupling: f64,
        /// Slope per unit moment.
        #[input("γ", "rad/(N*m)", positive)]
        slope: f64,
    },
}

/// The inertia of the disc.
#[derive(Clone, Debug, Inputs)]
pub enum TiltingDisc {
    /// Mass and moments of inertia
    Inertia {
        /// Mass of the disc.
        #[input("m", "kg", positive)]
        mass: f64,
        /// Moment of inertia about a diameter.
        #[input("I_d", "kg*m^2", positive)]
        diametral: f64,
        /// Moment of inertia about the axis.
        #[input("I_p", "kg*m^2", nonnegative)]
        polar: f64,
    },
    /// Mass, radius of gyration and width
    Gyration {
        /// Mass of the disc.
        #[input("m", "kg", positive)]
        mass: f64,
        /// Radius of gyration about the axis.
        #[input("r_p", "m", positive)]
        gyration: f64,
        /// Width of the disc.
        #[input("h", "m", nonnegative)]
        width: f64,
    },
    /// Diameter, width and density
    Geometry {
        /// Outer diameter of the disc.
        #[input("D_d", "m", positive)]
        outer: f64,
        /// Width of the disc.
        #[input("h", "m", positive)]
        width: f64,
        /// Density of the disc.
        #[input("ρ_d", "kg/m^3", positive, default = "7850 kg/m^3")]
        density: f64,
    },
}

register!(OverhungDisc);

/// The shaft at the disc and the inertia of the disc.
#[derive(Clone, Copy)]
struct OverhungRotor<N> {
    k11: N,
    k12: N,
    k22: N,
    determinant: N,
    /// Influence coefficients, found another way than by inverting the stiffness.
    influence: [N; 3],
    mass: N,
    diametral: N,
    polar: N,
}

impl Analysis for OverhungDisc {
    const ABOUT: About = About {
        id: "vibration/overhung-disc",
        title: "Overhung disc with gyroscopic action",
        topic: "Shafts and rotors",
        summary: "Natural frequencies at rest, forward and backward whirl at a speed, and synchronous critical speeds of a disc on a light shaft.",
        main: &["forward_critical", "backward_critical", "forward_whirl"],
        keywords: "overhung disc cantilever gyroscopic whirl critical speed forward backward Campbell disco em balanço \
                   efeito giroscópico precessão direta retrógrada velocidade crítica",
        sources: &[&DEN_HARTOG, &FRISWELL, &BEER],
        cases: include_str!("../../cases/overhung_disc.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &OverhungDiscGiven<W>, sheet: W) -> Result<(), Refusal> {
        let [mass, diametral, polar] = inertia(&given.disc, sheet);
        let system = OverhungRotor { mass, diametral, polar, ..held(&given.shaft, mass, sheet)? };

        let rest = whirls(&system, diametral, ["p", "ω"], &AT_REST, sheet);
        for (n, square) in rest.into_iter().flatten().enumerate() {
            sheet.answer(("natural_frequency", n + 1), "Natural frequency at rest", square);
        }
        let forward_inertia = sheet.step(
            "J_f",
            "kg*m^2",
            diametral - polar,
            ("Effective tilting inertia of the disc in synchronous forward whirl", DEN_HARTOG.at("§6.6")),
        );
        let forward = whirls(&system, forward_inertia, ["p_f", "Ω_f"], &FORWARD, sheet);
        for (n, speed) in forward.into_iter().flatten().enumerate() {
            sheet.answer(("forward_critical", n + 1), "Critical speed of forward whirl", speed);
        }
        let backward_inertia = sheet.step(
            "J_b",
            "kg*m^2",
            diametral + polar,
            ("Effective tilting inertia of the disc in synchronous backward whirl", DEN_HARTOG.at("§6.6")),
        );
        let backward = whirls(&system, backward_inertia, ["p_b", "Ω_b"], &BACKWARD, sheet);
        for (n, speed) in backward.into_iter().flatten().enumerate() {
            sheet.answer(("backward_critical", n + 1), "Critical speed of backward whirl", speed);
        }
        if forward[1].is_none() {
            sheet.warn(|| {
                Text::new(
                    "I_p ≥ I_d: gyroscopic action stiffens the tilting of the disc faster than the speed \
                     rises, so there is no second forward critical speed; unbalance excites only the first",
                )
            });
        }
        let criticals: Vec<f64> =
            forward.iter().chain(&backward).flatten().map(|speed| speed.value()).collect();
        if let Some(speed) = given.speed {
            at_speed(&system, speed, sheet)?;
            if let Some(near) =
                criticals.iter().find(|&&critical| (speed.value() / critical - 1.0).abs() < 0.1)
            {
                sheet.warn(|| {
                    Text::new("the speed is within 10 % of the critical speed {critical}")
                        .with_quantity("critical", *near, "rpm")
                });
            }
        }
        let numbers = Numbers::of(&system);
        sheet.show(|| {
            Exhibit::Plot(self.campbell(
                &numbers,
                &forward.map(|speed| speed.map(Real::value)),
                &backward.map(|speed| speed.map(Real::value)),
            ))
        });
        sheet.show(|| Exhibit::Drawing(self.drawing()));
        Ok(())
    }
}

/// The words of the two roots of a frequency equation.
struct Words {
    half_sum: &'static str,
    lower: &'static str,
    upper: &'static str,
    check: &'static str,
    cite: &'static str,
}

const AT_REST: Words = Words {
    half_sum: "Half of the coefficient of ω² in the frequency equation m I_d ω⁴ − 2p ω² + Δ = 0",
    lower: "Lower natural frequency of the disc that does not spin",
    upper: "Upper natural frequency of the non-rotating disc",
    check: "the natural frequency makes the determinant of the influence coefficients vanish",
    cite: "§6.6",
};

const FORWARD: Words = Words {
    half_sum: "The same, with the effective inertia in forward whirl",
    lower: "Critical speed of forward whirl: excited by unbalance",
    upper: "Second critical speed of forward whirl",
    check: "the forward critical speed makes the determinant of the influence coefficients vanish",
    cite: "§6.6",
};

const BACKWARD: Words = Words {
    half_sum: "The same, with the effective inertia in backward whirl",
    lower: "First critical speed of backward whirl",
    upper: "Second critical speed of backward whirl",
    check: "the backward critical speed makes the determinant of the influence coefficients vanish",
    cite: "§6.6",
};

/// The positive roots of the frequency equation with a tilting inertia.
fn whirls<W: Worksheet>(
    system: &OverhungRotor<W::Num>,
    inertia: W::Num,
    [half, symbol]: [&'static str; 2],
    words: &Words,
    sheet: W,
) -> [Option<W::Num>; 2] {
    let OverhungRotor { k11, k22, determinant, mass, influence: [a, b, c], .. } = *system;
    let cite = DEN_HARTOG.at(words.cite);
    let half_sum =
        sheet.step(half, "kg*N*m", overhung::half_sum(k11, k22, mass, inertia), (words.half_sum, cite));
    let particle = || (determinant / (k22 * mass)).sqrt();
    sheet.common_error((symbol, 1), "the disc taken as a point mass, without moments of inertia", particle);
    let upright = || (k11 / mass).sqrt();
    sheet.common_error((symbol, 1), "the disc taken to deflect without tilting", upright);
    let lower = sheet.step(
        (symbol, 1),
        "rpm",
        overhung::lower_square(mass, inertia, half_sum, determinant).sqrt(),
        (words.lower, cite),
    );
    let upper = (inertia.value() > 0.0).then(|| {
        let tilting = || (k22 / inertia).sqrt();
        sheet.common_error((symbol, 2), "the disc taken to tilt without deflecting", tilting);
        sheet.step(
            (symbol, 2),
            "rpm",
            overhung::upper_square(mass, inertia, half_sum, determinant).sqrt(),
            (words.upper, cite),
        )
    });
    sheet.verify(|| {
        for whirl in [Some(lower), upper].into_iter().flatten() {
            let square = whirl.powi(2);
            let one = W::Num::from(1.0);
            let (move_, tilt) = (one - a * mass * square, one - c * inertia * square);
            let cross = b.powi(2) * mass * inertia * square.powi(2);
            let scale =
                1.0 + (a * mass * square).value().abs() * (1.0 + (c * inertia * square).value().abs());
            sheet.check_zero(words.check, move_ * tilt - cross, scale);
        }
    });
    [Some(lower), upper]
}

/// The inertia of the disc: mass, about a diameter, about the axis.
fn inertia<W: Worksheet>(given: &TiltingDiscGiven<W>, sheet: W) -> [W::Num; 3] {
    match given {
        TiltingDiscGiven::Inertia { mass, diametral, polar } => [*mass, *diametral, *polar],
        TiltingDiscGiven::Gyration { mass, gyration, width } => {
            let polar = sheet.step(
                "I_p",
                "kg*m^2",
                *mass * gyration.powi(2),
                "Moment of inertia of the disc about the axis",
            );
            let about_face = || polar / 2.0 + *mass * width.powi(2) / 3.0;
            sheet.common_error("I_d", "the moment of inertia about a diameter of the face taken", about_face);
            let diametral = sheet.step(
                "I_d",
                "kg*m^2",
                formula::diametral(*mass, polar, *width),
                ("Moment of inertia of the disc about a diameter", FRISWELL.at("app. 1")),
            );
            [*mass, diametral, polar]
        }
        TiltingDiscGiven::Geometry { outer, width, density } => {
            let mass = sheet.step(
                "m",
                "kg",
                *density * outer.powi(2) * *width * std::f64::consts::PI / 4.0,
                "Mass of the disc",
            );
            let polar = sheet.step(
                "I_p",
                "kg*m^2",
                mass * outer.powi(2) / 8.0,
                "Moment of inertia of the disc about the axis",
            );
            let about_face = || polar / 2.0 + mass * width.powi(2) / 3.0;
            sheet.common_error("I_d", "the moment of inertia about a diameter of the face taken", about_face);
            let diametral = sheet.step(
                "I_d",
                "kg*m^2",
                formula::diametral(mass, polar, *width),
                ("Moment of inertia of the disc about a diameter", FRISWELL.at("app. 1")),
            );
            [mass, diametral, polar]
        }
    }
}

/// The shaft at the disc.
fn held<W: Worksheet>(
    given: &LightShaftGiven<W>,
    mass: W::Num,
    sheet: W,
) -> Result<OverhungRotor<W::Num>, Refusal> {
    let (stiffness, influence) = match given {
        LightShaftGiven::Cantilever { length, young, section } => {
            let moment = second_moment(section, sheet, Symbol::from("I"))?;
            let [k11, k12, k22] = overhung::cantilever(*young, moment, *length);
            let bending = *young * moment;
            let free = || bending * 3.0 / length.powi(3);
            sheet.common_error("k₁₁", "the stiffness 3EI/L³ of a tip that is free to tilt used", free);
            let inverse = || -(bending * 2.0) / length.powi(2);
            sheet.common_error("k₁₂", "the inverse of the slope per unit force used", inverse);
            let free = || bending / *length;
            sheet.common_error("k₂₂", "the stiffness EI/L of a tip that is free to deflect used", free);
            let why = "Force at the tip per unit deflection, with the rotation of the tip prevented";
            let k11 = sheet.step("k₁₁", "N/m", k11, (why, DEN_HARTOG.at("§6.6")));
            let why = "Moment at the tip per unit deflection, with the tip prevented from rotating";
            let k12 = sheet.step("k₁₂", "N", k12, (why, DEN_HARTOG.at("§6.6")));
            let why = "Moment at the tip per unit slope, with the tip held in place";
            let k22 = sheet.step("k₂₂", "N*m", k22, (why, DEN_HARTOG.at("§6.6")));
            // The deflections of the tables of beams, not the inverse of the stiffness.
            let tip = [length.powi(3) / (bending * 3.0), length.powi(2) / (bending * 2.0), *length / bending];
            ([k11, k12, k22], tip)
        }
        LightShaftGiven::Influence { deflection, coupling, slope } => {
            let spread = *deflection * *slope - coupling.powi(2);
            if spread.value() <= 0.0 {
                return Err(Refusal::because(
                    "α γ is not above β², so the shaft would not resist some load: check the influence coefficients",
                ));
            }
            let spread = sheet.step("Δ_α", "N^-2", spread, "Determinant of the influence coefficients");
            let why = "Stiffness is the inverse of the influence coefficients: force per unit deflection";
            let k11 = sheet.step("k₁₁", "N/m", *slope / spread, why);
            let k12 = sheet.step("k₁₂", "N", -*coupling / spread, "Moment per unit deflection");
            let k22 = sheet.step("k₂₂", "N*m", *deflection / spread, "Moment per unit slope");
            ([k11, k12, k22], [*deflection, *coupling, *slope])
        }
    };
    let [k11, k12, k22] = stiffness;
    let determinant = sheet.step(
        "Δ",
        "N^2",
        overhung::determinant(k11, k12, k22),
        "Determinant of the stiffness of the shaft at the disc",
    );
    Ok(OverhungRotor { k11, k12, k22, determinant, influence, mass, diametral: mass, polar: mass })
}

/// The system as plain numbers.
struct Numbers {
    k11: f64,
    k22: f64,
    determinant: f64,
    mass: f64,
    diametral: f64,
    polar: f64,
}

impl Numbers {
    fn of<N: Real>(system: &OverhungRotor<N>) -> Self {
        Self {
            k11: system.k11.value(),
            k22: system.k22.value(),
            determinant: system.determinant.value(),
            mass: system.mass.value(),
            diametral: system.diametral.value(),
            polar: system.polar.value(),
        }
    }

    /// The four frequencies of whirl at a speed, ascending: two backward (negative), two forward.
    fn whirl(&self, speed: f64) -> Option<[f64; 4]> {
        let scale = (self.k11 / self.mass).sqrt();
        let (m, d, p) = (self.mass, self.diametral, self.polar * speed / scale);
        let (k, t) = (self.k11 / scale.powi(2), self.k22 / scale.powi(2));
        let coefficients = [m * d, -m * p, -(k * d + t * m), k * p, self.determinant / scale.powi(4)];
        let size = coefficients[0];
        let roots = polynomial::roots(&coefficients.map(|a| a / size)).ok()?;
        let real: Vec<f64> = roots.iter().map(|root| root.re * scale).collect();
        <[f64; 4]>::try_from(real).ok().filter(|real| real.iter().all(|x| x.is_finite()))
    }
}

/// The frequencies of whirl at a speed.
fn at_speed<W: Worksheet>(system: &OverhungRotor<W::Num>, speed: W::Num, sheet: W) -> Result<(), Refusal> {
    let numbers = Numbers::of(system);
    let Some([b2, b1, f1, f2]) = numbers.whirl(speed.value()) else {
        return Err(Refusal::because(
            "the frequency equation at this speed could not be solved: check units and sizes",
        ));
    };
    let OverhungRotor { k11, k12, k22, determinant, mass, diametral, polar, .. } = *system;
    let root = |symbol: (&'static str, usize), value: f64, words: &'static str, sign: f64| {
        let whirl = sheet.numerical(symbol, "rpm", value, (words, DEN_HARTOG.at("§6.6")));
        sheet.verify(|| {
            let moved = k11 - mass * whirl.powi(2);
            let tilted = k22 - diametral * whirl.powi(2) + polar * speed * whirl * sign;
            let scale = determinant.value()
                + (mass * whirl.powi(2)).value() * (k22 + diametral * whirl.powi(2)).value();
            sheet.check_zero(
                "the whirl frequency satisfies the frequency equation (k₁₁ − mω²)(k₂₂ − I_d ω² ± I_p Ω ω) = k₁₂²",
                moved * tilted - k12.powi(2),
                scale,
            );
        });
        whirl
    };
    let words = "Forward whirl: root of (k₁₁ − mω²)(k₂₂ − I_d ω² + I_p Ω ω) = k₁₂²";
    for (n, value) in [f1, f2].into_iter().enumerate() {
        let whirl = root(("ω_f", n + 1), value, words, 1.0);
        sheet.answer(("forward_whirl", n + 1), "Forward whirl at this speed", whirl);
    }
    let words = "Backward whirl: root of (k₁₁ − mω²)(k₂₂ − I_d ω² − I_p Ω ω) = k₁₂²";
    for (n, value) in [-b1, -b2].into_iter().enumerate() {
        let whirl = root(("ω_b", n + 1), value, words, -1.0);
        sheet.answer(("backward_whirl", n + 1), "Backward whirl at this speed", whirl);
    }
    Ok(())
}

impl OverhungDisc {
    fn campbell(&self, numbers: &Numbers, forward: &[Option<f64>; 2], backward: &[Option<f64>; 2]) -> Plot {
        let criticals = || forward.iter().chain(backward).flatten().copied();
        let last = 1.3 * criticals().fold(self.speed.unwrap_or(0.0), f64::max);
        let speeds = (0..=200).map(|n| last * f64::from(n) / 200.0);
        let whirls: Vec<(f64, Option<[f64; 4]>)> =
            speeds.map(|speed| (speed, numbers.whirl(speed))).collect();
        let curve = |pick: fn([f64; 4]) -> f64| {
            // Whirl far above the speeds of the plot would leave its critical speeds no room.
            let at = |&(speed, all): &(f64, Option<[f64; 4]>)| all.map(|all| (speed, pick(all)));
            whirls.iter().filter_map(at).filter(|(_, whirl)| whirl.abs() <= 1.2 * last).collect()
        };
        let mut plot = Plot::new(
            "Campbell diagram",
            Axis::linear("speed", "rpm"),
            Axis::linear("frequency of whirl", "Hz"),
            vec![
                Series::line("backward 1", curve(|[_, b, _, _]| -b)).of("backward_whirl[1]"),
                Series::line("forward 1", curve(|[_, _, f, _]| f)).of("forward_whirl[1]"),
                Series::line("backward 2", curve(|[b, _, _, _]| -b)).of("backward_whirl[2]"),
                Series::line("forward 2", curve(|[_, _, _, f]| f)).of("forward_whirl[2]"),
                Series::line(
                    Text::new("{order}× speed").with("order", 1_usize),
                    vec![(0.0, 0.0), (last, last)],
                ),
            ],
        )
        .over("speed");
        for critical in forward.iter().flatten() {
            plot = plot.mark("forward critical speed", (*critical, *critical));
        }
        for critical in backward.iter().flatten() {
            plot = plot.mark("backward critical speed", (*critical, *critical));
        }
        plot
    }
}

impl OverhungDisc {
    fn drawing(&self) -> Drawing {
        let line = (0..=20).map(|n| {
            let s = f64::from(n) / 20.0;
            (-2.0 + 3.5 * s, 0.5 * s * s * (3.0 - s) / 2.0)
        });
        let (tip, slope) = ((1.5, 0.5), 0.22f64);
        let (sin, cos) = slope.sin_cos();
        let disc = |along: f64, across: f64| {
            (tip.0 + along * cos - across * sin, tip.1 + along * sin + across * cos)
        };
        let half = 0.1;
        let mut sketch = Sketch::new("The disc on its bent shaft");
        sketch
            .ground((-2.0, 0.8), (-2.0, -0.8))
            .axis((-2.0, 0.0), (2.4, 0.0))
            .bars(line.collect::<Vec<_>>())
            .body("", [disc(-half, -0.9), disc(half, -0.9), disc(half, 0.9), disc(-half, 0.9)])
            .motion("y", (2.1, 0.0), (2.1, 0.5))
            .angle("θ", (0.2, 0.0), 0.0, slope);
        match self.disc {
            TiltingDisc::Inertia { .. } => sketch.label("m, I_d, I_p", disc(half, 0.8)),
            TiltingDisc::Gyration { .. } => sketch
                .label("m", disc(half, 0.8))
                .dimension("h", disc(-half, 0.9), disc(half, 0.9), 1.0)
                .dimension("r_p", disc(half, 0.0), disc(half, -0.65), -1.0),
            TiltingDisc::Geometry { .. } => sketch
                .dimension("h", disc(-half, 0.9), disc(half, 0.9), 1.0)
                .dimension("D_d", disc(half, -0.9), disc(half, 0.9), -2.0),
        };
        match &self.shaft {
            LightShaft::Cantilever { section, .. } => {
                sketch.dimension("L", (-2.0, -0.4), (1.5, -0.4), -1.5);
                section.label(&mut sketch, (-1.2, 0.0));
            }
            LightShaft::Influence { .. } => {
                sketch.label("α, β, γ", (-0.4, 0.15));
            }
        }
        if self.speed.is_some() {
            sketch.couple("Ω", (-1.2, 0.0), (-1.2, 1.2), Ink::Motion);
        }
        sketch.finish()
    }
}
