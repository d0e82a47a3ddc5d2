//! Several discs on a shaft: the lowest frequency by approximate methods, beside the exact one, and all critical speeds.

use dalembert_core::{
    About, Analysis, Axis, Cell, Column, Drawing, Exhibit, Ink, Inputs, Plot, Refusal, Series, Sketch,
    Symbol, TableExhibit, Worksheet, register,
};
use dalembert_mechanics::{Real, beam::influence};
use dalembert_numerics::gauss_legendre;

mod exact;

use self::exact::Exact;
use crate::{
    shared::{
        body_load::MassOrWeight,
        continuous::{LineMass, LineMassGiven, line_mass},
        letters::of_row,
        section::{LightProfile, light_profile},
    },
    sources::{BEER, BLEVINS, RAO, SHIGLEY},
};

/// The shaft, its bearings and its discs.
#[derive(Clone, Debug, Inputs)]
pub struct ShaftWithDiscs {
    /// Length.
    #[input("L", "m", positive)]
    pub length: f64,
    /// Section.
    pub section: LightProfile,
    /// Young's modulus.
    #[input("E", "Pa", positive)]
    pub young: f64,
    /// Bearings.
    pub bearings: Bearings,
    /// Discs.
    /// Thin: they load the shaft without stiffening it.
    #[input(min = 1)]
    pub discs: Vec<ShaftDisc>,
    /// Mass of the shaft itself.
    /// Neglected if omitted.
    pub own_mass: Option<LineMass>,
    /// Gravity.
    #[input("g", "m/s^2", positive, default = "9.81 m/s^2", default_before = "9.80665 m/s^2")]
    pub gravity: f64,
}

/// Bearings of the shaft.
#[derive(Clone, Debug, Inputs)]
pub enum Bearings {
    /// Short bearings at both ends
    SimplySupported,
    /// Clamped at the left end
    Cantilever,
    /// Short bearings at the left end and before the right end
    Overhanging {
        /// Distance between the bearings.
        #[input("l", "m", positive)]
        span: f64,
    },
}

/// A disc or another mass on the shaft.
#[derive(Clone, Debug, Inputs)]
pub struct ShaftDisc {
    /// Distance from the left end.
    #[input("x", "m", positive)]
    pub distance: f64,
    /// Its mass or weight.
    pub load: MassOrWeight,
}

register!(ShaftWithDiscs);

/// Most discs: with more the worked solution is no longer read.
const MOST_DISCS: usize = 8;

impl Analysis for ShaftWithDiscs {
    const ABOUT: About = About {
        id: "vibration/shaft-with-discs",
        title: "Shaft with several discs",
        topic: "Shafts and rotors",
        summary: "Critical speeds and mode shapes of a shaft with several discs; the lowest also by Dunkerley, Rayleigh and matrix iteration, with the exact value and the bound each method gives.",
        main: &["critical_speed", "rayleigh", "dunkerley"],
        keywords: "critical speeds whirling stodola influence coefficients two masses cantilever mode shapes \
                   higher critical speed eixo discos duas massas em balanço velocidades críticas dunkerley \
                   rayleigh iteração matricial coeficientes de influência modos flexibility matrix matriz de \
                   flexibilidade",
        sources: &[&RAO, &BEER, &SHIGLEY, &BLEVINS],
        cases: include_str!("../../cases/shaft_with_discs.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &ShaftWithDiscsGiven<W>, sheet: W) -> Result<(), Refusal> {
        self.check()?;
        let by_density = matches!(given.own_mass, Some(LineMassGiven::Density { .. }));
        let (area, second_moment) = light_profile(&given.section, by_density, sheet)?;
        let bending = sheet.step("EI", "N*m^2", given.young * second_moment, "Bending stiffness");
        let line = match (&given.own_mass, area) {
            (None, _) => None,
            (Some(_), None) if by_density => {
                return Err(Refusal::because(
                    "the mass of the shaft by its density needs the area of the section: write the area, or the mass per unit length",
                ));
            }
            (Some(own), area) => Some(line_mass(own, 0, area.unwrap_or_else(|| W::Num::from(0.0)), sheet)),
        };
        let mass = |(n, disc): (usize, &ShaftDiscGiven<W>)| {
            disc.load.mass(given.gravity, sheet, ("m", n), "Mass of the disc: weight over gravity")
        };
        let shaft = Shaft {
            bearings: &given.bearings,
            bending,
            length: given.length,
            places: given.discs.iter().map(|disc| disc.distance).collect(),
            masses: (1..).zip(&given.discs).map(mass).collect(),
            line,
        };
        let influence = shaft.influence(sheet);
        let dunkerley = shaft.dunkerley(&influence, sheet)?;
        let (rayleigh, deflections) = shaft.rayleigh(&influence, given.gravity, sheet);
        sheet.keep_going()?;
        let exact = match line {
            None => {
                let improved = shaft.improved_rayleigh(&influence, (rayleigh, &deflections), sheet);
                sheet.answer("rayleigh_improved", "Rayleigh's bound, improved", improved);
                shaft.lumped(&influence, [dunkerley, rayleigh, improved], sheet)?
            }
            Some(line) => shaft.distributed(line, sheet)?,
        };
        let omega = exact.modes[0].frequency;
        let one = |base: &'static str, value: W::Num, label: &'static str| {
            sheet.step(base, "%", (value - omega) / omega, label)
        };
        let below = one("e_D", dunkerley, "Dunkerley's frequency is never above the exact one");
        let above = one("e_R", rayleigh, "Rayleigh's frequency is never below the exact one");
        let critical = sheet.step(
            "n_c",
            "rpm",
            omega,
            "The shaft whirls with maximum amplitude at its natural frequency, the discs treated as thin",
        );
        sheet.answer("dunkerley", "Dunkerley's lower bound", dunkerley);
        sheet.answer("rayleigh", "Rayleigh's upper bound", rayleigh);
        sheet.answer("exact", "Exact lowest frequency", omega);
        sheet.answer("critical_speed", "Critical speed", critical);
        sheet.answer("dunkerley_error", "Error of Dunkerley's frequency", below);
        sheet.answer("rayleigh_error", "Error of Rayleigh's value", above);
        for (n, mode) in (1..).zip(&exact.modes) {
            sheet.answer(("frequency", n), "Natural frequency", mode.frequency);
        }
        sheet.show(|| methods(dunkerley.value(), rayleigh.value(), omega.value()));
        sheet.show(|| exact.table());
        if line.is_none() {
            sheet.show(|| shaft.iteration(&influence));
        }
        sheet.show(|| shaft.shapes_plot(&exact, given.gravity.value()));
        sheet.show(|| shaft.modes_plot(&exact));
        sheet.show(|| Exhibit::Drawing(self.drawing()));
        Ok(())
    }
}

/// A shaft with its numbers, in SI.
struct Shaft<'t, W: Worksheet> {
    bearings: &'t BearingsGiven<W>,
    bending: W::Num,
    length: W::Num,
    places: Vec<W::Num>,
    masses: Vec<W::Num>,
    line: Option<W::Num>,
}

impl ShaftWithDiscs {
    fn check(&self) -> Result<(), Refusal> {
        if self.discs.len() > MOST_DISCS {
            return Err(Refusal::because(
                "more than eight discs: merge adjacent discs, or analyse the rotor by finite elements",
            ));
        }
        if self.discs.iter().any(|disc| disc.distance > self.length) {
            return Err(Refusal::because(
                "a disc lies beyond the right end of the shaft: write a distance not greater than its length",
            ));
        }
        let span = match self.bearings {
            Bearings::SimplySupported => self.length,
            Bearings::Cantilever => return Ok(()),
            Bearings::Overhanging { span } if span >= self.length => {
                return Err(Refusal::because(
                    "the second bearing is not before the end of the shaft: choose bearings at both ends, or write a shorter distance between them",
                ));
            }
            Bearings::Overhanging { span } => span,
        };
        if self.own_mass.is_none()
            && self.discs.iter().any(|disc| (disc.distance - span).abs() <= 1e-12 * span)
        {
            return Err(Refusal::because(
                "a disc is at a bearing, where it cannot vibrate: leave it out or move it",
            ));
        }
        Ok(())
    }

    fn drawing(&self) -> Drawing {
        let width = 6.0;
        let at = |x: f64| x / self.length * width;
        let mut sketch = Sketch::new("The discs on the shaft");
        sketch.mass("", (0.0, -0.06), (width, 0.06));
        match self.bearings {
            Bearings::SimplySupported => sketch.pin("", (0.0, -0.06)).pin("", (width, -0.06)),
            Bearings::Cantilever => sketch.ground((0.0, 0.6), (0.0, -0.6)),
            Bearings::Overhanging { span } => sketch
                .pin("", (0.0, -0.06))
                .pin("", (at(span), -0.06))
                .dimension("l", (0.0, 0.8), (at(span), 0.8), 0.0),
        };
        for (disc, row) in self.discs.iter().zip(1..) {
            let x = at(disc.distance);
            sketch.mass("", (x - 0.12, -0.6), (x + 0.12, 0.6));
            match disc.load {
                MassOrWeight::Mass { .. } => sketch.label(of_row(&["m"], row), (x, 0.6)),
                MassOrWeight::Weight { .. } => sketch.force(of_row(&["W"], row), (x, -0.6), (x, -1.1)),
            };
        }
        // Distances from the left end, as ordinates on one line.
        let level = -1.5;
        sketch.vector("x", (0.0, level), (width + 0.5, level), Ink::Faint);
        for (disc, row) in self.discs.iter().zip(1..) {
            let x = at(disc.distance);
            sketch.axis((x, level - 0.08), (x, level + 0.2)).label(of_row(&["x"], row), (x, level - 0.08));
        }
        sketch.axis((0.0, level - 0.15), (0.0, level + 0.15)).dimension("L", (0.0, 0.9), (width, 0.9), 0.0);
        self.section.draw(&mut sketch, (width + 1.3, 0.2), 0.8);
        sketch.finish()
    }
}

impl<W: Worksheet> Shaft<'_, W> {
    fn lengths(&self) -> Lengths<W::Num> {
        match self.bearings {
            BearingsGiven::SimplySupported {} => Lengths::Span(self.length),
            BearingsGiven::Cantilever {} => Lengths::Cantilever(self.length),
            BearingsGiven::Overhanging { span } => Lengths::Overhang(*span, self.length),
        }
    }

    fn lengths_value(&self) -> Lengths<f64> {
        match self.lengths() {
            Lengths::Span(span) => Lengths::Span(span.value()),
            Lengths::Cantilever(length) => Lengths::Cantilever(length.value()),
            Lengths::Overhang(span, length) => Lengths::Overhang(span.value(), length.value()),
        }
    }

    /// The influence coefficients of the discs.
    fn influence(&self, sheet: W) -> Vec<Vec<W::Num>> {
        let mut all: Vec<Vec<W::Num>> = vec![Vec::new(); self.places.len()];
        for (i, place) in self.places.iter().enumerate() {
            for (j, load) in self.places.iter().enumerate().skip(i) {
                let value = coefficient(self.bending, [*place, *load], self.lengths());
                let why = if i == j {
                    "Deflection at the disc due to a unit force there"
                } else {
                    "Deflection at one disc due to a unit force at the other"
                };
                let symbol = Symbol::from("a").row(i + 1).row(j + 1);
                if i == j {
                    self.influence_errors(symbol, *place, sheet);
                }
                let value = sheet.step(symbol, "mm/kN", value, (why, SHIGLEY.at("table A-9")));
                // Maxwell: the same with place and load exchanged. Rows before this one have filled its beginning.
                all[i].push(value);
                if i != j {
                    all[j].push(value);
                }
            }
        }
        all
    }

    /// The common errors of the deflection at a disc due to a unit force there.
    fn influence_errors(&self, symbol: Symbol, place: W::Num, sheet: W) {
        let bending = self.bending;
        match self.lengths() {
            Lengths::Span(span) => {
                let middle = || span.powi(3) / (bending * 48.0);
                sheet.common_error(symbol, "the deflection of a disc at midspan, L³/(48EI), used", middle);
            }
            Lengths::Cantilever(length) => {
                let tip = || length.powi(3) / (bending * 3.0);
                sheet.common_error(symbol, "the deflection of the tip, L³/(3EI), used", tip);
            }
            Lengths::Overhang(span, _) if place.value() > span.value() => {
                let clamped = || (place - span).powi(3) / (bending * 3.0);
                sheet.common_error(symbol, "the overhang taken as clamped at the bearing", clamped);
            }
            Lengths::Overhang(..) => {}
        }
    }

    /// The lowest root of the shaft without discs, `β²` being `ω` over `√(EI/(m̄L⁴))`.
    fn bare(&self) -> Result<f64, Refusal> {
        let beam = self.beam(None);
        let roots = beam.roots(1).map_err(|_| Refusal::because(NOT_FOUND))?;
        Ok(roots[0])
    }

    fn dunkerley(&self, influence: &[Vec<W::Num>], sheet: W) -> Result<W::Num, Refusal> {
        let mut terms: Vec<W::Num> =
            (0..self.masses.len()).map(|n| influence[n][n] * self.masses[n]).collect();
        if let Some(line) = self.line {
            let beta = sheet.numerical(
                "β_s",
                "1",
                self.bare()?,
                ("Root of the frequency equation of the shaft without discs", RAO.at("§8.5")),
            );
            let own = sheet.step(
                "ω_s",
                "rad/s",
                beta.powi(2) * (self.bending / (line * self.length.powi(4))).sqrt(),
                ("Frequency of the shaft without discs", RAO.at("§8.5")),
            );
            terms.push(W::Num::from(1.0) / own.powi(2));
        }
        let periods = || W::Num::from(1.0) / W::Num::sum(terms.iter().map(|term| term.sqrt()));
        sheet.common_error("ω_D", "the periods of the masses alone added", periods);
        let squares = || W::Num::sum(terms.iter().map(|term| W::Num::from(1.0) / *term)).sqrt();
        sheet.common_error("ω_D", "the squares of the frequencies of the masses alone added", squares);
        let sum = W::Num::sum(terms);
        Ok(sheet.step(
            "ω_D",
            "Hz",
            W::Num::from(1.0) / sum.sqrt(),
            ("Dunkerley: the squares of the periods of each mass alone are added", RAO.at("§7.2")),
        ))
    }

    /// Rayleigh's frequency, and the static deflections of the discs that it rests on.
    fn rayleigh(&self, influence: &[Vec<W::Num>], gravity: W::Num, sheet: W) -> (W::Num, Vec<W::Num>) {
        let count = self.masses.len();
        let deflections: Vec<W::Num> = (0..count)
            .map(|i| {
                let discs = (0..count).map(|j| influence[i][j] * self.masses[j] * gravity);
                let own = self
                    .line
                    .map(|line| own_deflection(self.bending, line * gravity, self.places[i], self.lengths()));
                let alone = || influence[i][i] * self.masses[i] * gravity;
                sheet.common_error(("y", i + 1), "the deflection under the weight of that disc alone", alone);
                let why = ("Static deflection at the disc under all weights", RAO.at("§7.3"));
                sheet.step(("y", i + 1), "mm", W::Num::sum(discs.chain(own)), why)
            })
            .collect();
        let potential = (0..count).map(|n| self.masses[n] * gravity * deflections[n]);
        let kinetic = (0..count).map(|n| self.masses[n] * deflections[n].powi(2));
        let (potential, kinetic) = match self.line {
            None => (W::Num::sum(potential), W::Num::sum(kinetic)),
            Some(line) => {
                let [work, square, own] = self.own_integrals(line.value(), gravity.value());
                let work_found = sheet.numerical(
                    "∫wy",
                    "N*m",
                    work,
                    "Weight of the shaft times its static deflection, integrated over the length",
                );
                let square_found = sheet.numerical(
                    "∫m̄y²",
                    "kg*m^2",
                    square,
                    "Mass of the shaft times the square of its static deflection, integrated over the length",
                );
                sheet.verify(|| {
                    let (bending, lengths) = (self.bending.value(), self.lengths_value());
                    let weight = line.value() * gravity.value();
                    let betti = (0..count).map(|n| {
                        let place = self.places[n].value();
                        self.masses[n].value() * gravity.value() * own_deflection(bending, weight, place, lengths)
                    });
                    sheet.check(
                        "work of the shaft weight through the deflection due to the discs equals that of the discs through the deflection due to the shaft weight (Betti)",
                        W::Num::from(betti.sum::<f64>() + own),
                        work_found,
                    );
                });
                (W::Num::sum(potential.chain([work_found])), W::Num::sum(kinetic.chain([square_found])))
            }
        };
        let why = (
            "Rayleigh: maximum potential energy over maximum kinetic energy of the static deflection",
            RAO.at("§7.3"),
        );
        let largest = || deflections[1..].iter().fold(deflections[0].abs(), |most, y| most.max(y.abs()));
        let single = || (gravity / largest()).sqrt();
        sheet.common_error("ω_R", "√(g/δ) with the largest static deflection used", single);
        let added = || (gravity / W::Num::sum(deflections.iter().copied())).sqrt();
        sheet.common_error("ω_R", "√(g/δ) with the sum of the static deflections used", added);
        (sheet.step("ω_R", "Hz", (potential / kinetic).sqrt(), why), deflections)
    }

    /// Rayleigh's frequency of the deflections under the inertia forces `m ω² y` of the first ones, without a mass of the
    /// shaft.
    fn improved_rayleigh(
        &self,
        influence: &[Vec<W::Num>],
        (first, deflections): (W::Num, &[W::Num]),
        sheet: W,
    ) -> W::Num {
        let count = self.masses.len();
        let why = ("Inertia force of the disc at Rayleigh's frequency", RAO.at("§7.3"));
        let force =
            |n: usize| sheet.step(("F", n + 1), "N", self.masses[n] * first.powi(2) * deflections[n], why);
        let forces: Vec<W::Num> = (0..count).map(force).collect();
        let second: Vec<W::Num> = (0..count)
            .map(|i| {
                let parts = (0..count).map(|j| influence[i][j] * forces[j]);
                sheet.step(
                    ("z", i + 1),
                    "mm",
                    W::Num::sum(parts),
                    "Deflection at the disc under these forces",
                )
            })
            .collect();
        let potential = (0..count).map(|n| forces[n] * second[n]);
        let kinetic = (0..count).map(|n| self.masses[n] * second[n].powi(2));
        let square = W::Num::sum(potential) / W::Num::sum(kinetic);
        let why = "Rayleigh's quotient of these deflections, whose bending energy is the work of the forces";
        sheet.step("ω_R2", "Hz", square.sqrt(), (why, RAO.at("§7.3")))
    }

    /// The static deflection at a place under all weights.
    fn static_deflection(&self, place: f64, line: f64, gravity: f64) -> f64 {
        let (bending, lengths) = (self.bending.value(), self.lengths_value());
        let discs: f64 = self
            .places
            .iter()
            .zip(&self.masses)
            .map(|(at, mass)| mass.value() * gravity * coefficient(bending, [place, at.value()], lengths))
            .sum();
        discs + own_deflection(bending, line * gravity, place, lengths)
    }

    /// `∫ w y dx` and `∫ m̄ y² dx` of the static deflection, and the first with the weight of the shaft alone.
    fn own_integrals(&self, line: f64, gravity: f64) -> [f64; 3] {
        let (bending, lengths, length) = (self.bending.value(), self.lengths_value(), self.length.value());
        // The deflection is a polynomial between discs and bearings.
        let mut breaks: Vec<f64> =
            self.places.iter().map(|place| place.value()).chain([0.0, length]).collect();
        if let Lengths::Overhang(span, _) = lengths {
            breaks.push(span);
        }
        breaks.sort_by(f64::total_cmp);
        let mut sums = [0.0; 3];
        for part in breaks.windows(2) {
            let width = part[1] - part[0];
            for (xi, weight) in gauss_legendre::points(1) {
                let place = part[0] + width * xi;
                let y = self.static_deflection(place, line, gravity);
                let own = own_deflection(bending, line * gravity, place, lengths);
                let load = line * width * weight;
                sums[0] += load * gravity * y;
                sums[1] += load * y * y;
                sums[2] += load * gravity * own;
            }
        }
        sums
    }

    fn shapes_plot(&self, exact: &Exact<W::Num>, gravity: f64) -> Exhibit {
        let length = self.length.value();
        let line = self.line.map_or(0.0, Real::value);
        let points: Vec<(f64, f64)> = (0..=120u16)
            .map(|n| length * f64::from(n) / 120.0)
            .map(|x| (x, self.static_deflection(x, line, gravity)))
            .collect();
        let largest = points.iter().fold(0.0f64, |a, (_, y)| a.max(y.abs()));
        let discs = &exact.modes[0].discs;
        let sign = discs
            .iter()
            .zip(&self.places)
            .fold(0.0, |sum, (w, place)| sum + w * self.static_deflection(place.value(), line, gravity));
        // The discs of the exact shape at the size of the static one.
        let statics =
            self.places.iter().map(|place| self.static_deflection(place.value(), line, gravity).abs());
        let scale = statics.fold(0.0f64, f64::max) / largest;
        let crest = discs.iter().fold(0.0f64, |a, w| a.max(w.abs()));
        let disc = |(place, w): (&W::Num, &f64)| (place.value(), sign.signum() * w / crest * scale);
        Exhibit::Plot(Plot::new(
            "Static deflection and exact mode shape",
            Axis::linear("distance from the left end", "m"),
            Axis::linear("deflection / maximum deflection", "1"),
            vec![
                Series::line(
                    "static deflection",
                    points.into_iter().map(|(x, y)| (x, y / largest)).collect(),
                ),
                Series::dots(
                    "discs in the exact mode shape",
                    self.places.iter().zip(discs).map(disc).collect(),
                ),
            ],
        ))
    }
}

/// The lengths that the deflections of a shaft depend on.
#[derive(Clone, Copy)]
enum Lengths<N> {
    /// Between bearings at both ends.
    Span(N),
    /// From the clamp to the end.
    Cantilever(N),
    /// Between the bearings, and of the whole shaft.
    Overhang(N, N),
}

/// The influence coefficient of two places.
fn coefficient<N: Real>(bending: N, places: [N; 2], lengths: Lengths<N>) -> N {
    let [place, load] = places;
    let (place, load) = if place.value() <= load.value() { (place, load) } else { (load, place) };
    match lengths {
        Lengths::Span(span) => influence::simply_supported(bending, span, place, load),
        Lengths::Cantilever(_) => influence::cantilever(bending, place, load),
        Lengths::Overhang(span, _) => match (place.value() <= span.value(), load.value() <= span.value()) {
            (true, true) => influence::simply_supported(bending, span, place, load),
            (true, false) => influence::overhang_of_inner_load(bending, span, load - span, place),
            _ => influence::overhang(bending, span, place - span, load - span),
        },
    }
}

/// The deflection under the weight of the shaft itself, N/m.
fn own_deflection<N: Real>(bending: N, weight: N, place: N, lengths: Lengths<N>) -> N {
    match lengths {
        Lengths::Span(span) => influence::own_simply_supported(bending, weight, span, place),
        Lengths::Cantilever(length) => influence::own_cantilever(bending, weight, length, place),
        Lengths::Overhang(span, length) if place.value() <= span.value() => {
            influence::own_inside(bending, weight, span, length - span, place)
        }
        Lengths::Overhang(span, length) => {
            influence::own_overhang(bending, weight, span, length - span, place - span)
        }
    }
}

const NOT_FOUND: &str = "the lowest frequency cannot be found: the masses of discs and shaft differ too much";

fn methods(dunkerley: f64, rayleigh: f64, exact: f64) -> Exhibit {
    let column = |heading: &'static str, unit| Column { heading: heading.into(), unit };
    let row = |method: &'static str, bound: &'static str, value: f64| {
        vec![method.into(), bound.into(), Cell::Number(value), Cell::Number((value - exact) / exact)]
    };
    Exhibit::Table(TableExhibit {
        title: "Three methods for the lowest frequency".into(),
        columns: vec![
            column("method", ""),
            column("bound", ""),
            column("frequency", "Hz"),
            column("error", "%"),
        ],
        rows: vec![
            row("Dunkerley", "lower bound", dunkerley),
            row("exact", "exact", exact),
            row("Rayleigh", "upper bound", rayleigh),
        ],
        foot: Vec::new(),
    })
}
