//! A rotor of shaft, discs and bearings, by finite elements: whirl, critical speeds, unbalance response, stability.
// Long because shaft, discs, bearings and unbalances are asked for here, one description each.

use std::f64::consts::TAU;

use dalembert_core::{About, Analysis, Inputs, Refusal, Text, Worksheet, register};
use dalembert_mechanics::{
    Real,
    rotor::{
        Assembled, BearingSupport as Held, Complex, RigidDisc, Rotor, RotorError, SupportType,
        campbell::{Campbell, campbell},
        critical::{self, Critical, Criticals},
        element::{BeamTheory as Bending, Material},
        mesh::{Segment, mesh},
        modes::{self, Polished, ReducedRotor, Spectrum, WhirlDirection, WhirlMode},
        response::{Unbalance, residual, unbalance_response},
    },
};
use dalembert_numerics::linalg::LinalgError;

mod parts;
mod pictures;
mod stiffness_map;
mod tables;

pub use parts::{
    Bearing, BearingGiven, DiscSize, DiscSizeGiven, InternalDamping, InternalDampingGiven, RotorDisc,
    RotorDiscGiven, RotorSupport, RotorSupportGiven, RotorUnbalance, RotorUnbalanceGiven, ShaftMaterial,
    ShaftMaterialGiven, ShaftSegment, ShaftSegmentGiven, ShaftTheory, SpeedRow, SpeedRowGiven,
};

use crate::sources::{FRISWELL, NELSON, ZORZI};

/// The rotor, its mesh, and the speeds that are asked for.
#[derive(Clone, Debug, Inputs)]
pub struct RotorDynamics {
    /// Shaft segments.
    /// From left to right.
    #[input(min = 1)]
    pub segments: Vec<ShaftSegment>,
    /// Material of the shaft.
    pub material: ShaftMaterial,
    /// Discs.
    pub discs: Vec<RotorDisc>,
    /// Supports.
    #[input(min = 1)]
    pub supports: Vec<RotorSupport>,
    /// Unbalances.
    pub unbalances: Vec<RotorUnbalance>,
    /// Speed.
    #[input("Ω", "rpm", nonnegative)]
    pub speed: f64,
    /// Maximum speed of the diagrams.
    /// Upper limit of the search for critical speeds and the stability threshold.
    #[input("Ωₘₐₓ", "rpm", positive)]
    pub highest_speed: f64,
    /// Frequency of the excitation over the speed.
    /// 1 for unbalance; 2 for a non-circular shaft; the slope of the line in the Campbell diagram.
    #[input("s", "1", positive, default = "1")]
    pub slope: f64,
    /// Position of the response.
    /// Distance from the left end; by default that of the first unbalance.
    #[input("z_R", "m", nonnegative)]
    pub place: Option<f64>,
    /// Axial tension of the shaft.
    /// Negative for compression.
    #[input("N", "N")]
    pub tension: Option<f64>,
    /// Bending of the shaft.
    pub theory: ShaftTheory,
    /// Elements per segment.
    /// Between neighbouring steps of the shaft, discs, supports and unbalances.
    #[input(min = 1, max = 40)]
    pub elements: usize,
    /// Modes.
    #[input(min = 1, max = 10)]
    pub modes: usize,
}

register!(RotorDynamics);

/// The agreement that a check asks for where rounding leaves that many digits.
const AGREEMENT: f64 = 1e-9;
/// Speeds of the Campbell diagram.
const SPEEDS: usize = 14;
/// The most elements of the whole shaft.
const MOST_ELEMENTS: usize = 400;
/// A real part below so many times what rounding changes of an eigenvalue is rounding.
const STILL: f64 = 32.0;
/// The most bands of instability that are answered.
const MOST_BANDS: usize = 4;

impl Analysis for RotorDynamics {
    const ABOUT: About = About {
        id: "vibration/rotor-dynamics",
        title: "Rotor on bearings by finite elements",
        topic: "Shafts and rotors",
        summary: "Natural frequencies with direction of whirl and damping, critical speeds, unbalance response and threshold of stability of a stepped shaft with discs on bearings.",
        main: &["critical_speed", "frequency", "stability_threshold"],
        keywords: "rotor rotordynamics whirl campbell critical speed gyroscopic bearing unbalance finite element \
                   log decrement instability dinâmica de rotores velocidade crítica mancal giroscópico \
                   desbalanceamento diagrama elementos finitos out-of-balance response unbalance response \
                   forward backward whirl resposta ao desbalanceamento response to out-of-balance forces \
                   self-excited",
        sources: &[&FRISWELL, &NELSON, &ZORZI],
        cases: include_str!("../../cases/rotor_dynamics.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &RotorDynamicsGiven<W>, sheet: W) -> Result<(), Refusal> {
        let discs = given
            .discs
            .iter()
            .enumerate()
            .map(|(n, disc)| parts::disc(disc, n + 1, sheet))
            .collect::<Result<Vec<_>, _>>()?;
        self.refuse_what_makes_no_rotor()?;
        let shaft = W::Num::sum(given.segments.iter().enumerate().map(|(n, segment)| {
            sheet.step(
                ("m_s", n + 1),
                "kg",
                parts::segment_mass(segment, given.material.density),
                "Mass of the segment",
            )
        }));
        let whole = shaft + W::Num::sum(discs.iter().map(|disc| disc.mass));
        let whole = sheet.step("m", "kg", whole, "Mass of the rotor: shaft and discs");
        sheet.answer("mass", "Mass of the rotor", whole);

        let sizes: Vec<[f64; 3]> = discs
            .iter()
            .map(|disc| [disc.mass.value(), disc.diametral.value(), disc.polar.value()])
            .collect();
        let (rotor, stations) = self.rotor(&sizes, self.elements)?;
        let all = Assembled::new(&rotor).map_err(refusal)?;
        sheet.verify(|| {
            sheet.check(
                "rotor mass from a lateral rigid translation of all nodes in the mass matrix",
                W::Num::from(translating_mass(&rotor, &all)),
                whole,
            );
        });
        sheet.keep_going()?;

        let asked = [self.speed, self.highest_speed.max(self.speed)];
        let cancelled = || sheet.keep_going().is_err();
        let reduced =
            ReducedRotor::to_within(&all, self.modes, &asked, modes::EXACT, &cancelled).map_err(refusal)?;
        let mut spectrum = reduced.modes(self.speed).map_err(refusal)?;
        if spectrum.modes.is_empty() {
            return Err(Refusal::because(
                "no mode oscillates: all motions are overdamped; reduce the bearing damping",
            ));
        }
        let conservative = rotor.is_conservative();
        let mut grows = false;
        for (n, mode) in spectrum.modes.iter_mut().enumerate() {
            // What is shown of a mode is what is answered.
            if let Some(lambda) = self.answer_mode(&rotor, &all, n + 1, mode, sheet) {
                mode.lambda = lambda;
                grows |= lambda.re > critical::NEUTRAL * lambda.norm();
            }
        }
        warn_of_modes(&spectrum, grows, sheet);
        sheet.keep_going()?;

        let diagram = std::cell::OnceCell::new();
        let campbell_diagram = || -> Result<&Campbell, Refusal> {
            if let Some(made) = diagram.get() {
                return Ok(made);
            }
            let made = campbell(&reduced, &self.speeds(conservative)).map_err(refusal)?;
            Ok(diagram.get_or_init(|| made))
        };
        // A free shaft has no stiffness of its own to divide by.
        let directly = conservative && !reduced.is_free();
        let Criticals { found: mut criticals, lost } = if directly {
            critical::direct(&reduced, self.slope, self.highest_speed).map_err(refusal)?
        } else {
            critical::crossings(&reduced, campbell_diagram()?, self.slope).map_err(refusal)?
        };
        criticals.truncate(self.modes);
        self.answer_criticals(&all, &criticals, &lost, directly, sheet);
        sheet.keep_going()?;
        if !conservative {
            self.answer_stability(&rotor, &all, &reduced, campbell_diagram()?, grows, sheet)?;
        }
        self.answer_response(given, &all, &stations, sheet)?;
        self.warn_of_inputs(&sizes, sheet);
        let finer = std::cell::OnceCell::new();
        let finer = || finer.get_or_init(|| self.finer(&sizes)).as_ref();
        sheet.verify(|| warn_of_mesh(&spectrum, finer(), sheet));

        let shown = pictures::RotorFigures {
            problem: self,
            rotor: &rotor,
            all: &all,
            spectrum: &spectrum,
            criticals: &criticals,
            stations: &stations,
        };
        pictures::show(&shown, &|| campbell_diagram().ok(), &finer, sheet);
        Ok(())
    }
}

/// Node indices of the discs, supports, unbalances and the response.
pub(super) struct Stations {
    pub(super) unbalances: Vec<usize>,
    pub(super) response: Option<usize>,
}

impl RotorDynamics {
    fn refuse_what_makes_no_rotor(&self) -> Result<(), Refusal> {
        for segment in &self.segments {
            let ends = [
                (segment.outer, segment.inner.unwrap_or(0.0)),
                (segment.outer_right.unwrap_or(segment.outer), segment.inner.unwrap_or(0.0)),
            ];
            if ends.iter().any(|(outer, inner)| inner >= outer) {
                return Err(Refusal::because(
                    "the inner diameter of a shaft segment is not below the outer one: write the larger one as the outer",
                ));
            }
        }
        let length: f64 = self.segments.iter().map(|segment| segment.length).sum();
        let places = self
            .discs
            .iter()
            .map(|disc| disc.position)
            .chain(self.supports.iter().map(|support| support.position))
            .chain(self.unbalances.iter().map(|unbalance| unbalance.position))
            .chain(self.place);
        for place in places {
            if place > length * (1.0 + 1e-7) {
                return Err(Refusal::because(
                    Text::new(
                        "{place} is not on the shaft, which is {length} long: place discs, supports and unbalances on it",
                    )
                    .with_quantity("place", place, "mm")
                    .with_quantity("length", length, "mm"),
                ));
            }
        }
        self.refuse_what_lies_beyond_a_table()
    }

    /// The rotor with so many elements in every stretch.
    fn rotor(&self, discs: &[[f64; 3]], elements: usize) -> Result<(Rotor, Stations), Refusal> {
        let (viscous_damping, loss_factor) = match self.material.damping {
            InternalDamping::None => (0.0, 0.0),
            InternalDamping::Viscous { coefficient } => (coefficient, 0.0),
            InternalDamping::Hysteretic { loss_factor } => (0.0, loss_factor),
        };
        let material = Material {
            young: self.material.young,
            shear: self.material.shear,
            density: self.material.density,
            viscous_damping,
            loss_factor,
        };
        let segments: Vec<Segment> = self
            .segments
            .iter()
            .map(|segment| Segment {
                length: segment.length,
                outer: [segment.outer, segment.outer_right.unwrap_or(segment.outer)],
                inner: [segment.inner.unwrap_or(0.0); 2],
                material,
            })
            .collect();
        let places: Vec<f64> = self
            .discs
            .iter()
            .map(|disc| disc.position)
            .chain(self.supports.iter().map(|support| support.position))
            .chain(self.unbalances.iter().map(|unbalance| unbalance.position))
            .chain(self.place)
            .collect();
        let stretches = segments.len() + places.len();
        if stretches.saturating_mul(elements) > 4 * MOST_ELEMENTS {
            return Err(too_many());
        }
        let mesh = mesh(&segments, &places, elements).map_err(refusal)?;
        if mesh.elements.len() > MOST_ELEMENTS {
            return Err(too_many());
        }
        let (at_discs, rest) = mesh.stations.split_at(self.discs.len());
        let (at_supports, rest) = rest.split_at(self.supports.len());
        let (at_unbalances, at_response) = rest.split_at(self.unbalances.len());
        let discs = at_discs
            .iter()
            .zip(discs)
            .map(|(&node, &[mass, diametral, polar])| RigidDisc { node, mass, diametral, polar })
            .collect();
        let supports = at_supports
            .iter()
            .zip(&self.supports)
            .map(|(&node, support)| Held { node, hold: support.bearing.hold() })
            .collect();
        let theory = match self.theory {
            ShaftTheory::Timoshenko => Bending::Timoshenko,
            ShaftTheory::EulerBernoulli => Bending::EulerBernoulli,
        };
        let stations = Stations {
            unbalances: at_unbalances.to_vec(),
            response: at_response.first().or(at_unbalances.first()).copied(),
        };
        let tension = self.tension.unwrap_or(0.0);
        Ok((Rotor { elements: mesh.elements, theory, tension, discs, supports }, stations))
    }

    fn answer_mode<W: Worksheet>(
        &self,
        rotor: &Rotor,
        all: &Assembled,
        n: usize,
        mode: &WhirlMode,
        sheet: W,
    ) -> Option<Complex<f64>> {
        let Ok(Polished { mode: exact, rounding }) = modes::polished(all, mode, self.speed) else {
            sheet.warn(|| {
                Text::new("mode {n}, near {frequency}, could not be refined on the equations of all nodes: it is omitted")
                    .with("n", n)
                    .with_quantity("frequency", mode.frequency(), "Hz")
            });
            return None;
        };
        let mut lambda = exact.lambda;
        if rotor.is_undamped() || lambda.re.abs() <= STILL * rounding * lambda.norm() {
            lambda.re = 0.0;
        }
        // What this rotor leaves of the digits of an eigenvalue, as the scale against which two of them are compared.
        let scale = lambda.norm() * (STILL * rounding / AGREEMENT).max(1.0);
        let how = (
            Text::new(
                "Damped natural frequency of mode {n}: eigenvalue λ = σ + iω of λ²M + λ(C + ΩG) + K, assembled from shaft elements, discs and supports",
            )
            .with("n", n),
            FRISWELL.at("ch. 5"),
        );
        let frequency = sheet.numerical(("ω", n), "rad/s", lambda.im, how);
        let by_energy = modes::energy_eigenvalue(all, &exact, self.speed);
        let by_energy = by_energy.unwrap_or(Complex::new(f64::NAN, f64::NAN));
        sheet.verify(|| {
            sheet.check_zero(
                "at this frequency the powers of inertia, rotation, damping and stiffness balance for the mode shape",
                (frequency.value() - by_energy.im).into(),
                scale,
            );
        });
        let cycles = sheet.step(("f", n), "Hz", frequency, "The same in hertz");
        sheet.answer(("frequency", n), "Damped natural frequency", cycles);
        let growth = sheet.numerical(
            ("σ", n),
            "s^-1",
            lambda.re,
            ("Growth rate: real part of the eigenvalue; negative if the motion decays", FRISWELL.at("ch. 5")),
        );
        sheet.verify(|| {
            sheet.check_zero(
                "at this growth rate the powers of inertia, rotation, damping and stiffness balance for the mode shape",
                (growth.value() - by_energy.re).into(),
                scale,
            );
        });
        let natural = (growth.powi(2) + frequency.powi(2)).sqrt();
        let zeta = sheet.step(
            ("ζ", n),
            "1",
            -growth / natural,
            ("Damping ratio, from the real part and modulus of the eigenvalue", FRISWELL.at("ch. 5")),
        );
        let decrement = sheet.step(
            ("δ", n),
            "1",
            -(growth / frequency) * TAU,
            ("Logarithmic decrement: the decrease over one period 2π/ω", FRISWELL.at("ch. 5")),
        );
        sheet.verify(|| {
            sheet.check_zero(
                "the decrement from the damping ratio, δ = 2πζ/√(1 − ζ²)",
                decrement - zeta * TAU / (W::Num::from(1.0) - zeta.powi(2)).sqrt(),
                1.0,
            );
        });
        sheet.answer(("damping_ratio", n), "Damping ratio", zeta);
        sheet.answer(("log_decrement", n), "Logarithmic decrement", decrement);
        if self.speed > 0.0 {
            let widest = (0..all.nodes())
                .map(|node| (node, exact.orbit(node)))
                .max_by(|(_, a), (_, b)| a.major.total_cmp(&b.major));
            let orbit = widest.map_or(0.0, |(_, orbit)| orbit.minor / orbit.major);
            let ratio = if orbit.abs() < 1e-9 { 0.0 } else { orbit };
            let how = (
                Text::new(
                    "Whirl: ratio of minor to major axis of the orbit where it is largest, positive for forward whirl; the mode {direction}",
                )
                .with_text("direction", in_words(mode.direction())),
                FRISWELL.at("ch. 3"),
            );
            let whirl = sheet.numerical(("b/a", n), "1", ratio, how);
            let label = match mode.direction() {
                WhirlDirection::Forward => "Axis ratio b/a, forward whirl",
                WhirlDirection::Backward => "Axis ratio b/a, backward whirl",
                WhirlDirection::Mixed => "Axis ratio b/a of the largest orbit, mixed whirl",
                WhirlDirection::Planar => "Axis ratio b/a, motion in a plane",
            };
            sheet.answer(("whirl", n), label, whirl);
            sheet.verify(|| {
                let Some((node, _)) = widest else { return };
                let [x, _, y, _] = exact.shape[node];
                let (area, squares) = ((x * y.conj()).im, x.norm_sqr() + y.norm_sqr());
                sheet.check_zero(
                    "area of the orbit divided by the sum of the squares of its amplitudes, b a/(a² + b²)",
                    (whirl.value() / (1.0 + whirl.value().powi(2)) - area / squares).into(),
                    1.0,
                );
            });
        }
        Some(lambda)
    }

    /// The speeds of the diagrams. Where stability is asked for, the speed that is asked for and every row of every
    /// table are among them.
    fn speeds(&self, conservative: bool) -> Vec<f64> {
        let (lowest, highest) = (self.lowest_speed(), self.highest_speed);
        let mut speeds: Vec<f64> =
            (0..=SPEEDS).map(|n| lowest + (highest - lowest) * n as f64 / SPEEDS as f64).collect();
        if !conservative {
            speeds.extend(
                self.table_speeds().chain([self.speed]).filter(|here| (lowest..=highest).contains(here)),
            );
            speeds.sort_by(f64::total_cmp);
            speeds.dedup_by(|a, b| (*a - *b).abs() <= 1e-9 * highest);
        }
        speeds
    }

    fn answer_criticals<W: Worksheet>(
        &self,
        all: &Assembled,
        criticals: &[Critical],
        lost: &[f64],
        conservative: bool,
        sheet: W,
    ) {
        for (n, critical) in criticals.iter().enumerate() {
            let how = if conservative {
                Text::new(
                    "Critical speed: with ω = sΩ free whirl obeys (K − ω²(M − iG/s)) v = 0, an eigenproblem for ω; \
                     the whirl {direction}",
                )
            } else {
                Text::new(
                    "Critical speed: intersection of a damped natural frequency with sΩ; the whirl {direction}",
                )
            };
            let how = (how.with_text("direction", in_words(critical.mode.direction())), NELSON.at(""));
            let speed = sheet.numerical(("Ω_c", n + 1), "rpm", critical.speed, how);
            sheet.verify(|| {
                // From the other side in each case: the free whirl at this spin, or the powers in the shape that was found.
                let there = if conservative {
                    modes::polished(all, &critical.mode, critical.speed).ok().map(|there| there.mode.lambda)
                } else {
                    modes::energy_eigenvalue(all, &critical.mode, critical.speed)
                };
                let rounding = modes::polished(all, &critical.mode, critical.speed).map_or(0.0, |there| there.rounding);
                sheet.check_zero(
                    "at this speed a natural frequency from the equations of all nodes is the required multiple of the speed",
                    (speed.value() * self.slope - there.map_or(f64::NAN, |lambda| lambda.im)).into(),
                    self.slope * critical.speed * (STILL * rounding / AGREEMENT).max(1.0),
                );
            });
            sheet.answer(("critical_speed", n + 1), "Critical speed", speed);
        }
        for &speed in lost {
            sheet.warn(|| {
                Text::new("the critical speed near {speed} could not be refined on the equations of all nodes: it is omitted")
                    .with_quantity("speed", speed, "rpm")
            });
        }
        if criticals.is_empty() && lost.is_empty() {
            sheet.warn(|| Text::new("there is no critical speed up to the highest speed of the diagrams"));
        }
    }

    fn answer_stability<W: Worksheet>(
        &self,
        rotor: &Rotor,
        all: &Assembled,
        reduced: &ReducedRotor<'_>,
        diagram: &Campbell,
        grows: bool,
        sheet: W,
    ) -> Result<(), Refusal> {
        let diverges =
            diagram.spectra.iter().flat_map(|spectrum| &spectrum.overdamped).any(|&root| root > 0.0);
        if diverges {
            sheet.warn(|| {
                Text::new(
                    "a non-oscillatory motion grows: the bearings push the shaft away at some of the speeds",
                )
            });
        }
        if rotor.cannot_grow() {
            sheet.warn(|| {
                Text::new(
                    "no mode can grow up to the highest speed of the diagrams: every stiffness is symmetric, and damping only dissipates energy",
                )
            });
            return Ok(());
        }
        let critical::Instability { bands, lost, examined } =
            critical::instability(reduced, diagram).map_err(refusal)?;
        for &speed in &lost {
            sheet.warn(|| {
                Text::new("the limit of stability near {speed} could not be refined on the equations of all nodes: it is omitted")
                    .with_quantity("speed", speed, "rpm")
            });
        }
        if bands.is_empty() && !grows && !diverges {
            sheet.warn(|| {
                Text::new(
                    "no mode grows at the {count} speeds examined up to the highest speed of the diagrams",
                )
                .with("count", examined)
            });
        }
        let edge = |symbol: (&'static str, usize), edge: &Critical, words: &'static str| {
            let how =
                (Text::new(words).with_text("direction", in_words(edge.mode.direction())), ZORZI.at(""));
            let speed = sheet.numerical(symbol, "rpm", edge.speed, how);
            sheet.verify(|| {
                let there = modes::energy_eigenvalue(all, &edge.mode, speed.value());
                sheet.check_zero(
                    "at the limit of stability the mode neither grows nor decays",
                    W::Num::from(there.map_or(f64::NAN, |lambda| lambda.re)),
                    edge.mode.lambda.norm(),
                );
            });
            speed
        };
        for (n, band) in (1..).zip(bands.iter().take(MOST_BANDS)) {
            if let Some(from) = &band.from {
                let words = "Stability threshold: unstable above this speed; whirl {direction}";
                let speed = edge(("Ω_s", n), from, words);
                if n == 1 {
                    sheet.answer("stability_threshold", "Stability threshold", speed);
                } else {
                    sheet.answer(("stability_lost", n), "Further stability threshold", speed);
                }
            } else if n == 1 && lost.is_empty() {
                sheet.warn(|| {
                    let lowest = self.lowest_speed();
                    match (lowest == 0.0, &band.to) {
                        (true, None) => Text::new("a mode is unstable even at rest: the rotor is unstable at every speed examined"),
                        (true, Some(_)) => Text::new("a mode is unstable even at rest"),
                        (false, _) => Text::new(
                            "a mode is unstable even at the lowest speed of the bearing tables, {speed}: the stability threshold lies below it",
                        )
                        .with_quantity("speed", lowest, "rpm"),
                    }
                });
            }
            if let Some(to) = &band.to {
                let words = "Upper limit of the instability: above this speed the mode is stable again; whirl {direction}";
                let speed = edge(("Ω_r", n), to, words);
                sheet.answer(("stability_regained", n), "Upper limit of the instability", speed);
                if let Some(from) = &band.from {
                    sheet.warn(|| {
                        Text::new("a mode is unstable between {from} and {to}: the rotor is unstable there")
                            .with_quantity("from", from.speed, "rpm")
                            .with_quantity("to", to.speed, "rpm")
                    });
                }
            }
        }
        let below = |edge: &Option<Critical>| edge.as_ref().is_none_or(|edge| edge.speed < self.speed);
        let above = |edge: &Option<Critical>| edge.as_ref().is_none_or(|edge| edge.speed > self.speed);
        let around = bands.iter().find(|band| below(&band.from) && above(&band.to));
        if let Some(threshold) = around.and_then(|band| band.from.as_ref()) {
            sheet.warn(|| {
                Text::new("the speed lies above the stability threshold, {threshold}: the whirl grows until another effect limits it")
                    .with_quantity("threshold", threshold.speed, "rpm")
            });
        }
        Ok(())
    }

    fn answer_response<W: Worksheet>(
        &self,
        _given: &RotorDynamicsGiven<W>,
        all: &Assembled,
        stations: &Stations,
        sheet: W,
    ) -> Result<(), Refusal> {
        let Some(node) = stations.response else { return Ok(()) };
        if self.unbalances.is_empty() || self.speed == 0.0 {
            return Ok(());
        }
        let unbalances = self.unbalance_at(stations);
        let response = unbalance_response(all, &unbalances, self.speed).map_err(refusal)?;
        let [x, _, y, _] = response[node];
        // Without damping the motion is exactly in phase or against it; what is left of the rest is rounding.
        let size = x.norm().max(y.norm());
        let clean = |part: f64| if part.abs() <= 1e-9 * size { 0.0 } else { part };
        let part = |symbol: &'static str, value: f64, words: &'static str| {
            sheet.numerical(symbol, "um", value, (words, FRISWELL.at("ch. 6")))
        };
        let xc = part(
            "X_c",
            clean(x.re),
            "Unbalance response (−Ω²M + iΩ(C + ΩG) + K) q = Ω² m e e^{iδ}: motion along x in phase with the mark on \
             the shaft",
        );
        let xs = part("X_s", clean(x.im), "The same, 90° ahead of the mark");
        let yc = part("Y_c", clean(y.re), "Motion along y in phase with the mark on the shaft");
        let ys = part("Y_s", clean(y.im), "The same, 90° ahead of the mark");
        let half = |a: W::Num, b: W::Num| (a.powi(2) + b.powi(2)).sqrt() / 2.0;
        let forward = sheet.step(
            "r_f",
            "um",
            half(xc - ys, xs + yc),
            ("Radius of the forward rotating component", FRISWELL.at("ch. 3")),
        );
        let backward = sheet.step(
            "r_b",
            "um",
            half(xc + ys, xs - yc),
            ("Radius of the backward rotating component", FRISWELL.at("ch. 3")),
        );
        let major = sheet.step(
            "a",
            "um",
            forward + backward,
            "Semi-major axis of the orbit: maximum deflection, zero to peak",
        );
        let minor = sheet.step(
            "b",
            "um",
            forward - backward,
            "Semi-minor axis of the orbit, negative for backward whirl",
        );
        let along_x =
            sheet.step("X", "um", (xc.powi(2) + xs.powi(2)).sqrt(), "Amplitude along x, zero to peak");
        let along_y =
            sheet.step("Y", "um", (yc.powi(2) + ys.powi(2)).sqrt(), "Amplitude along y, zero to peak");
        sheet.verify(|| {
            sheet.check_zero(
                "the forces of inertia, damping and stiffness of this motion balance the unbalance at every node",
                W::Num::from(residual(all, &unbalances, self.speed, &response).unwrap_or(f64::NAN)),
                1.0,
            );
            sheet.check(
                "the squares of the two semi-axes sum to those of the two amplitudes",
                major.powi(2) + minor.powi(2),
                along_x.powi(2) + along_y.powi(2),
            );
        });
        sheet.answer("response_major", "Semi-major axis of the orbit", major);
        let label = if minor.value() < 0.0 {
            "Semi-minor axis of the orbit, backward whirl"
        } else {
            "Semi-minor axis of the orbit, forward whirl"
        };
        sheet.answer("response_minor", label, minor);
        sheet.answer("response_x", "Amplitude along x", along_x);
        sheet.answer("response_y", "Amplitude along y", along_y);
        if along_x.value() > 0.0 {
            let phase = sheet.step(
                "φ",
                "deg",
                xs.atan2(xc),
                "Phase lead of the motion along x relative to the mark on the shaft",
            );
            sheet.answer("response_phase", "Phase lead along x, relative to the mark", phase);
            let size = along_x.value();
            sheet.check_sum(
                "amplitude and phase along x: component in phase",
                along_x * phase.cos(),
                xc,
                size,
            );
            sheet.check_sum(
                "amplitude and phase along x: component leading by 90°",
                along_x * phase.sin(),
                xs,
                size,
            );
        }
        Ok(())
    }

    /// The unbalances at their nodes.
    pub(super) fn unbalance_at(&self, stations: &Stations) -> Vec<Unbalance> {
        self.unbalances
            .iter()
            .zip(&stations.unbalances)
            .map(|(unbalance, &node)| Unbalance { node, size: unbalance.size, angle: unbalance.angle })
            .collect()
    }

    /// The modes with twice as many elements.
    fn finer(&self, discs: &[[f64; 3]]) -> Option<Spectrum> {
        let (rotor, _) = self.rotor(discs, 2 * self.elements).ok()?;
        let all = Assembled::new(&rotor).ok()?;
        let reduced = ReducedRotor::to_within(&all, self.modes, &[self.speed], 1e-7, &|| false).ok()?;
        reduced.modes(self.speed).ok()
    }

    fn warn_of_inputs<W: Worksheet>(&self, discs: &[[f64; 3]], sheet: W) {
        if discs.iter().any(|[_, diametral, polar]| polar > diametral) {
            sheet.warn(|| {
                Text::new(
                    "a disc is thin, I_p greater than I_d: the gyroscopic effect stiffens its forward tilting so much that this has no synchronous critical speed; only backward whirl of the disc intersects the line",
                )
            });
        }
        let one_sided = self.supports.iter().any(|support| {
            let SupportType::Bearing(table) = support.bearing.hold() else { return false };
            table.iter().any(|(_, here)| {
                let [[_, xy], [yx, _]] = here.stiffness;
                (xy == 0.0) != (yx == 0.0)
            })
        });
        if one_sided {
            sheet.warn(|| {
                Text::new(
                    "a bearing has only one of k_xy and k_yx: is its partner missing? an elastic support has both alike, a \
                     fluid film has both with opposite signs",
                )
            });
        }
        if matches!(self.material.damping, InternalDamping::Hysteretic { loss_factor } if loss_factor > 0.0) {
            sheet.warn(|| {
                Text::new(
                    "this model of hysteretic damping destabilises every forward whirl at every speed; in a real shaft this occurs only above the critical speed of the mode",
                )
            });
        }
    }
}

fn warn_of_mesh<W: Worksheet>(spectrum: &Spectrum, finer: Option<&Spectrum>, sheet: W) {
    let Some(finer) = finer else { return };
    let worst = spectrum
        .modes
        .iter()
        .zip(&finer.modes)
        .map(|(coarse, fine)| (coarse.frequency() / fine.frequency() - 1.0).abs())
        .fold(0.0, f64::max);
    if worst > 0.01 {
        sheet.warn(|| {
            Text::new("the mesh is coarse: with twice as many elements a frequency changes by {change}; write more elements")
                .with_quantity("change", worst, "%")
        });
    }
}

fn warn_of_modes<W: Worksheet>(spectrum: &Spectrum, grows: bool, sheet: W) {
    if spectrum.overdamped.len() == 1 {
        sheet.warn(|| {
            Text::new("one motion at this speed is overdamped: it returns almost without oscillating and is not listed among the modes")
        });
    } else if !spectrum.overdamped.is_empty() {
        sheet.warn(|| {
            Text::new("{count} motions at this speed are overdamped: they return almost without oscillating and are not listed among the modes")
                .with("count", spectrum.overdamped.len())
        });
    }
    if grows {
        sheet.warn(|| Text::new("a mode is unstable at this speed: the rotor is unstable there"));
    }
}

/// The direction of a mode in words.
pub(super) fn in_words(direction: WhirlDirection) -> Text {
    match direction {
        WhirlDirection::Forward => Text::new("rotates forward"),
        WhirlDirection::Backward => Text::new("rotates backward"),
        WhirlDirection::Mixed => Text::new("rotates forward at some points and backward at others"),
        WhirlDirection::Planar => Text::new("stays in a plane"),
    }
}

/// Mass of a rotor from its mass matrix, without constraints at its fixed nodes.
fn translating_mass(rotor: &Rotor, all: &Assembled) -> f64 {
    let free = Rotor { supports: Vec::new(), ..rotor.clone() };
    let Ok(free) = Assembled::new(&free) else { return f64::NAN };
    let level: Vec<f64> = (0..2 * all.nodes()).map(|n| if n % 2 == 0 { 1.0 } else { 0.0 }).collect();
    free.mass.energy(&level)
}

fn too_many() -> Refusal {
    Refusal::because("the shaft would have more than 400 elements: write fewer elements in every segment")
}

/// Message for a refusal of the kernel.
pub(super) fn refusal(error: RotorError) -> Refusal {
    match error {
        RotorError::Buckled => Refusal::because(
            "the rotor is statically unstable: the compression buckles the shaft, or a bearing has negative stiffness",
        ),
        RotorError::Rigid => Refusal::because(
            "no node of the shaft can move: write more elements in every segment, or check masses and densities",
        ),
        RotorError::Unbounded { speed } => Refusal::because(
            Text::new(
                "{speed} is a critical speed without damping: the unbalance response is unbounded and grows with time",
            )
            .with_quantity("speed", speed, "rpm"),
        ),
        RotorError::Linalg(LinalgError::NotConverged) => Refusal::because(
            "the search for the modes of this rotor did not converge; this is a limitation of the program, not of the rotor: another number of elements may avoid it",
        ),
        RotorError::Stopped => Refusal::Stopped,
        RotorError::Value { .. } | RotorError::Node { .. } | RotorError::Linalg(_) => Refusal::because(
            "the values of this rotor are outside the range of computation: check units, diameters and stiffnesses",
        ),
    }
}
