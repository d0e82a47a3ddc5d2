//! Several discs on a shaft: the lowest frequency by approximate methods, beside the exact one.
// Long because four methods stand beside each other, each with its own steps.

use dalembert_core::{
    About, Analysis, Axis, Cell, Column, Drawing, Exhibit, Inputs, Plot, Refusal, Series, Sketch, Symbol,
    TableExhibit, Text, Worksheet, register,
};
use dalembert_mechanics::{
    Real,
    beam::{
        dynamic_stiffness::{Beam, BeamStation},
        influence,
    },
    vibration::lumped,
};
use dalembert_numerics::gauss_legendre;

use crate::{
    shared::{
        body_load::MassOrWeight,
        continuous::{LineMass, line_mass},
        section::{Profile, profile},
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
    pub section: Profile,
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
        summary: "Lowest frequency and critical speed of a shaft with several discs by Dunkerley, Rayleigh and matrix iteration, with the exact value and the bound each method gives.",
        keywords: "critical speed whirling stodola influence coefficients eixo discos velocidade crítica dunkerley \
                   rayleigh iteração matricial coeficientes de influência",
        sources: &[&RAO, &BEER, &SHIGLEY, &BLEVINS],
        cases: include_str!("../../cases/shaft_with_discs.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &ShaftWithDiscsGiven<W>, sheet: W) -> Result<(), Refusal> {
        self.check()?;
        let (area, second_moment) = profile(&given.section, 0, sheet)?;
        let bending = sheet.step("EI", "N*m^2", given.young * second_moment, "Bending stiffness");
        let line = given.own_mass.as_ref().map(|own| line_mass(own, 0, area, sheet));
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
        let rayleigh = shaft.rayleigh(&influence, given.gravity, sheet);
        sheet.keep_going()?;
        let exact = match line {
            None => shaft.lumped(&influence, [dunkerley, rayleigh], sheet)?,
            Some(line) => shaft.distributed(line, sheet)?,
        };
        let omega = exact.frequency;
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
        sheet.show(|| methods(dunkerley.value(), rayleigh.value(), omega.value()));
        if line.is_none() {
            sheet.show(|| shaft.iteration(&influence));
        }
        sheet.show(|| shaft.shapes_plot(&exact, given.gravity.value()));
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

/// The exact frequency and the deflections of the discs, largest one.
struct Exact<N> {
    frequency: N,
    discs: Vec<f64>,
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
        sketch.bars([(0.0, 0.0), (width, 0.0)]);
        match self.bearings {
            Bearings::SimplySupported => sketch.pin("", (0.0, 0.0)).pin("", (width, 0.0)),
            Bearings::Cantilever => sketch.ground((0.0, 0.6), (0.0, -0.6)),
            Bearings::Overhanging { span } => sketch.pin("", (0.0, 0.0)).pin("", (at(span), 0.0)),
        };
        for (n, disc) in (1..).zip(&self.discs) {
            let x = at(disc.distance);
            sketch.mass(Text::new("disc {n}").with("n", n), (x - 0.1, -0.7), (x + 0.1, 0.7));
        }
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
        let sum = W::Num::sum(terms);
        Ok(sheet.step(
            "ω_D",
            "Hz",
            W::Num::from(1.0) / sum.sqrt(),
            ("Dunkerley: the squares of the periods of each mass alone are added", RAO.at("§7.2")),
        ))
    }

    fn rayleigh(&self, influence: &[Vec<W::Num>], gravity: W::Num, sheet: W) -> W::Num {
        let count = self.masses.len();
        let deflections: Vec<W::Num> = (0..count)
            .map(|i| {
                let discs = (0..count).map(|j| influence[i][j] * self.masses[j] * gravity);
                let own = self
                    .line
                    .map(|line| own_deflection(self.bending, line * gravity, self.places[i], self.lengths()));
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
        sheet.step(
            "ω_R",
            "Hz",
            (potential / kinetic).sqrt(),
            (
                "Rayleigh: maximum potential energy over maximum kinetic energy of the static deflection",
                RAO.at("§7.3"),
            ),
        )
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

    /// The exact frequency of the discs on a shaft without mass, held by matrix iteration.
    fn lumped(
        &self,
        influence: &[Vec<W::Num>],
        [dunkerley, rayleigh]: [W::Num; 2],
        sheet: W,
    ) -> Result<Exact<W::Num>, Refusal> {
        let (rows, masses) = self.numbers(influence);
        let all = lumped::frequencies(&rows, &masses).map_err(|_| Refusal::because(NOT_FOUND))?;
        let lowest = all[0];
        let frequency = sheet.numerical(
            "ω₁",
            "Hz",
            lowest,
            (
                "Exact: 1/ω² is the largest eigenvalue of the product of influence coefficients and masses",
                RAO.at("§6.4"),
            ),
        );
        let rounds = lumped::matrix_iteration(&rows, &masses, 5000);
        let [Some(first), Some(last)] = [rounds.first(), rounds.last()].map(Option::<&_>::cloned) else {
            return Err(Refusal::because(NOT_FOUND));
        };
        sheet.verify(|| {
            let squares: f64 = all.iter().map(|frequency| frequency.powi(-2)).sum();
            sheet.check(
                "Dunkerley: the sum of the squared periods of all modes gives the same value",
                W::Num::from(squares.sqrt().recip()),
                dunkerley,
            );
            sheet.check(
                "Rayleigh: the first step of matrix iteration, from equal deflections",
                W::Num::from(first.frequency),
                rayleigh,
            );
            sheet.check(
                "matrix iteration starting from equal deflections converges to the exact frequency",
                W::Num::from(last.frequency),
                frequency,
            );
        });
        Ok(Exact { frequency, discs: last.shape })
    }

    /// The exact frequency of the discs on a shaft with its mass.
    fn distributed(&self, line: W::Num, sheet: W) -> Result<Exact<W::Num>, Refusal> {
        let beam = self.beam(Some(line.value()));
        let root = beam.roots(1).map_err(|_| Refusal::because(NOT_FOUND))?[0];
        let shape = beam.shape(root).map_err(|_| Refusal::because(NOT_FOUND))?;
        let beta = sheet.numerical(
            "β₁",
            "1",
            root,
            (
                "Exact: lowest root of the dynamic stiffness of the shaft, including its mass and the discs",
                BLEVINS.at("ch. 8"),
            ),
        );
        let frequency = sheet.step(
            "ω₁",
            "Hz",
            beta.powi(2) * (self.bending / (line * self.length.powi(4))).sqrt(),
            ("Exact lowest frequency", RAO.at("§8.5")),
        );
        sheet.verify(|| {
            sheet.check(
                "strain energy over kinetic energy of the exact mode shape reproduces the root",
                W::Num::from(shape.rayleigh_quotient()),
                beta.powi(4),
            );
        });
        let length = self.length.value();
        let discs = self.places.iter().map(|place| shape.state(place.value() / length).deflection).collect();
        Ok(Exact { frequency, discs })
    }

    /// The shaft as a beam, with its discs where the mass of the shaft per unit length is given.
    fn beam(&self, with_discs: Option<f64>) -> Beam {
        let length = self.length.value();
        let at = |at: f64| BeamStation { at, ..BeamStation::default() };
        let mut stations = match self.lengths_value() {
            Lengths::Span(_) => {
                vec![BeamStation { held: true, ..at(0.0) }, BeamStation { held: true, ..at(1.0) }]
            }
            Lengths::Cantilever(_) => vec![BeamStation { held: true, clamped: true, ..at(0.0) }, at(1.0)],
            Lengths::Overhang(span, _) => {
                vec![
                    BeamStation { held: true, ..at(0.0) },
                    BeamStation { held: true, ..at(span / length) },
                    at(1.0),
                ]
            }
        };
        if let Some(line) = with_discs {
            for (place, mass) in self.places.iter().zip(&self.masses) {
                let xi = place.value() / length;
                let near = stations.iter().position(|station| (station.at - xi).abs() <= 1e-9);
                let index = near.unwrap_or_else(|| {
                    let index = stations.partition_point(|station| station.at < xi);
                    stations.insert(index, at(xi));
                    index
                });
                stations[index].mass += mass.value() / (line * length);
            }
        }
        Beam { shear: 0.0, rotary: 0.0, axial: 0.0, foundation: 0.0, stations }
    }

    /// Influence coefficients and masses as plain numbers.
    fn numbers(&self, influence: &[Vec<W::Num>]) -> (Vec<Vec<f64>>, Vec<f64>) {
        let plain = |row: &Vec<W::Num>| row.iter().map(|a| a.value()).collect();
        (influence.iter().map(plain).collect(), self.masses.iter().map(|mass| mass.value()).collect())
    }

    fn iteration(&self, influence: &[Vec<W::Num>]) -> Exhibit {
        let (rows, masses) = self.numbers(influence);
        let rounds = lumped::matrix_iteration(&rows, &masses, 6);
        let mut columns = vec![
            Column { heading: "round".into(), unit: "1" },
            Column { heading: "frequency".into(), unit: "Hz" },
        ];
        columns.extend(
            (1..=self.masses.len())
                .map(|n| Column { heading: Text::new("disc {n}").with("n", n), unit: "1" }),
        );
        let row = |(n, round): (usize, lumped::Round)| {
            let mut row = vec![Cell::Number(n as f64), Cell::Number(round.frequency)];
            row.extend(round.shape.into_iter().map(Cell::Number));
            row
        };
        Exhibit::Table(TableExhibit {
            title: "Matrix iteration from equal deflections".into(),
            columns,
            rows: (1..).zip(rounds).map(row).collect(),
            foot: Vec::new(),
        })
    }

    fn shapes_plot(&self, exact: &Exact<W::Num>, gravity: f64) -> Exhibit {
        let length = self.length.value();
        let line = self.line.map_or(0.0, Real::value);
        let points: Vec<(f64, f64)> = (0..=120u16)
            .map(|n| length * f64::from(n) / 120.0)
            .map(|x| (x, self.static_deflection(x, line, gravity)))
            .collect();
        let largest = points.iter().fold(0.0f64, |a, (_, y)| a.max(y.abs()));
        let sign = exact
            .discs
            .iter()
            .zip(&self.places)
            .fold(0.0, |sum, (w, place)| sum + w * self.static_deflection(place.value(), line, gravity));
        // The discs of the exact shape at the size of the static one.
        let statics =
            self.places.iter().map(|place| self.static_deflection(place.value(), line, gravity).abs());
        let scale = statics.fold(0.0f64, f64::max) / largest;
        let crest = exact.discs.iter().fold(0.0f64, |a, w| a.max(w.abs()));
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
                    self.places.iter().zip(&exact.discs).map(disc).collect(),
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
