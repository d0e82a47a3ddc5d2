//! A mode from a table of the complex frequency response.

use std::f64::consts::FRAC_1_SQRT_2;

use dalembert_core::{Cell, Column, Exhibit, Inputs, Refusal, TableExhibit, Text, Worksheet};
use dalembert_mechanics::{
    Real,
    identification::{
        self,
        modal::{self, Complex, DampingModel, MeasuredResponse, Residuals, ResponsePoint},
    },
    sdof,
};

pub use super::mode::DampingKind;
use super::{circle, mode::IdentifiedMode, normal_equations::normal_equations, plots, points::ordered};
use crate::sources::{EWINS, RAO};

/// The fewest points whose fit has something left to judge it by.
const FEW: usize = 6;

/// Table of a measured response, by quantity and notation.
#[derive(Clone, Debug, Inputs)]
pub enum ResponseTable {
    /// Receptance, real and imaginary part
    ReceptanceParts {
        /// Points.
        /// Three at least, in any order, about one resonance.
        #[input(table)]
        points: Vec<ReceptancePart>,
    },
    /// Receptance, amplitude and phase
    ReceptancePolar {
        /// Points.
        /// Three at least, in any order, about one resonance.
        #[input(table)]
        points: Vec<ReceptancePolar>,
    },
    /// Mobility, real and imaginary part
    MobilityParts {
        /// Points.
        /// Three at least, in any order, about one resonance.
        #[input(table)]
        points: Vec<MobilityPart>,
    },
    /// Mobility, amplitude and phase
    MobilityPolar {
        /// Points.
        /// Three at least, in any order, about one resonance.
        #[input(table)]
        points: Vec<MobilityPolar>,
    },
    /// Accelerance, real and imaginary part
    AcceleranceParts {
        /// Points.
        /// Three at least, in any order, about one resonance.
        #[input(table)]
        points: Vec<AccelerancePart>,
    },
    /// Accelerance, amplitude and phase
    AccelerancePolar {
        /// Points.
        /// Three at least, in any order, about one resonance.
        #[input(table)]
        points: Vec<AccelerancePolar>,
    },
}

/// A point of a measured receptance, by its parts.
#[derive(Clone, Debug, Inputs)]
pub struct ReceptancePart {
    /// Frequency.
    #[input("ω", "Hz", nonnegative)]
    pub frequency: f64,
    /// Real part.
    #[input("Re H", "m/N")]
    pub real: f64,
    /// Imaginary part.
    #[input("Im H", "m/N")]
    pub imaginary: f64,
}

/// A point of a measured receptance, by amplitude and phase.
#[derive(Clone, Debug, Inputs)]
pub struct ReceptancePolar {
    /// Frequency.
    #[input("ω", "Hz", nonnegative)]
    pub frequency: f64,
    /// Amplitude.
    #[input("|H|", "m/N", nonnegative)]
    pub amplitude: f64,
    /// Phase.
    /// Negative if the motion lags the force.
    #[input("φ", "deg")]
    pub phase: f64,
}

/// A point of a measured mobility, by its parts.
#[derive(Clone, Debug, Inputs)]
pub struct MobilityPart {
    /// Frequency.
    #[input("ω", "Hz", nonnegative)]
    pub frequency: f64,
    /// Real part.
    #[input("Re Y", "m/(N*s)")]
    pub real: f64,
    /// Imaginary part.
    #[input("Im Y", "m/(N*s)")]
    pub imaginary: f64,
}

/// A point of a measured mobility, by amplitude and phase.
#[derive(Clone, Debug, Inputs)]
pub struct MobilityPolar {
    /// Frequency.
    #[input("ω", "Hz", nonnegative)]
    pub frequency: f64,
    /// Amplitude.
    #[input("|Y|", "m/(N*s)", nonnegative)]
    pub amplitude: f64,
    /// Phase.
    /// Negative if the motion lags the force.
    #[input("φ", "deg")]
    pub phase: f64,
}

/// A point of a measured accelerance, by its parts.
#[derive(Clone, Debug, Inputs)]
pub struct AccelerancePart {
    /// Frequency.
    #[input("ω", "Hz", nonnegative)]
    pub frequency: f64,
    /// Real part.
    #[input("Re A", "1/kg")]
    pub real: f64,
    /// Imaginary part.
    #[input("Im A", "1/kg")]
    pub imaginary: f64,
}

/// A point of a measured accelerance, by amplitude and phase.
#[derive(Clone, Debug, Inputs)]
pub struct AccelerancePolar {
    /// Frequency.
    #[input("ω", "Hz", nonnegative)]
    pub frequency: f64,
    /// Amplitude.
    #[input("|A|", "1/kg", nonnegative)]
    pub amplitude: f64,
    /// Phase.
    /// Negative if the motion lags the force.
    #[input("φ", "deg")]
    pub phase: f64,
}

/// Residual terms for the modes outside the range.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Inputs)]
pub enum ResidualKind {
    /// Single mode
    None,
    /// Modes above: a constant receptance
    Stiffness,
    /// Modes above and below: a constant receptance and a mass line
    StiffnessAndMass,
}

impl ResponseTable {
    /// Measured quantity and its points.
    fn read(&self) -> (MeasuredResponse, Vec<ResponsePoint>) {
        let polar = Complex::from_polar;
        match self {
            ResponseTable::ReceptanceParts { points } => (
                MeasuredResponse::Receptance,
                points.iter().map(|p| (p.frequency, Complex::new(p.real, p.imaginary))).collect(),
            ),
            ResponseTable::ReceptancePolar { points } => (
                MeasuredResponse::Receptance,
                points.iter().map(|p| (p.frequency, polar(p.amplitude, p.phase))).collect(),
            ),
            ResponseTable::MobilityParts { points } => (
                MeasuredResponse::Mobility,
                points.iter().map(|p| (p.frequency, Complex::new(p.real, p.imaginary))).collect(),
            ),
            ResponseTable::MobilityPolar { points } => (
                MeasuredResponse::Mobility,
                points.iter().map(|p| (p.frequency, polar(p.amplitude, p.phase))).collect(),
            ),
            ResponseTable::AcceleranceParts { points } => (
                MeasuredResponse::Accelerance,
                points.iter().map(|p| (p.frequency, Complex::new(p.real, p.imaginary))).collect(),
            ),
            ResponseTable::AccelerancePolar { points } => (
                MeasuredResponse::Accelerance,
                points.iter().map(|p| (p.frequency, polar(p.amplitude, p.phase))).collect(),
            ),
        }
    }
}

/// Reads a mode in every way and answers that of the complex least squares.
pub(super) fn identify<W: Worksheet>(
    table: &ResponseTable,
    damping: DampingKind,
    residuals: ResidualKind,
    range: [Option<f64>; 2],
    force: Option<W::Num>,
    sheet: W,
) -> Result<(), Refusal> {
    let (response, all) = table.read();
    let all = ordered(all, sheet)?;
    let points = within(all, range, sheet)?;
    let receptances: Vec<ResponsePoint> =
        points.iter().map(|point| (point.0, response.receptance(*point))).collect();

    let mut modes: Vec<(&'static str, IdentifiedMode<W::Num>)> = Vec::new();
    if let Some(mode) = by_amplitude(&receptances, sheet) {
        modes.push(("peak and half-power points", mode));
    }
    let (mode, circle) = circle::circle(&points, response, damping, sheet)?;
    modes.push(("circle fit", mode));
    let (mode, fit) = least_squares(&points, response, damping, residuals, sheet)?;
    modes.push(("complex least squares", mode));

    answers(&mode, damping, force, sheet);
    spread(&modes, sheet);
    let numbers: Vec<(&'static str, [f64; 3])> = modes
        .iter()
        .map(|(method, mode)| (*method, [mode.natural, mode.damping_ratio, mode.constant].map(Real::value)))
        .collect();
    caution(points.len(), mode.damping_ratio.value(), sheet);
    let model = damping.model();
    sheet.show(|| Exhibit::Plot(plots::nyquist(&receptances, &circle, &fit, model)));
    for which in [0, 1] {
        sheet.show(|| {
            let [amplitude, phase] = plots::bode(&receptances, &fit, model);
            Exhibit::Plot(if which == 0 { amplitude } else { phase })
        });
    }
    sheet.show(|| Exhibit::Table(side_by_side(numbers)));
    Ok(())
}

/// The points above zero and within the range that is read.
fn within<W: Worksheet>(
    mut points: Vec<ResponsePoint>,
    [lowest, highest]: [Option<f64>; 2],
    sheet: W,
) -> Result<Vec<ResponsePoint>, Refusal> {
    if let (Some(lowest), Some(highest)) = (lowest, highest)
        && lowest >= highest
    {
        return Err(Refusal::because(
            "the lowest frequency of the reading range is not below the highest one: exchange them",
        ));
    }
    let inside = |frequency: f64| {
        lowest.is_none_or(|lowest| frequency >= lowest) && highest.is_none_or(|highest| frequency <= highest)
    };
    points.retain(|point| inside(point.0));
    if points.first().is_some_and(|point| point.0 == 0.0) {
        points.remove(0);
        sheet.warn(|| Text::new("the point at frequency zero is omitted: phase and circle begin above it"));
    }
    if points.len() < 3 {
        return Err(Refusal::because(
            "there are fewer than three frequencies above zero in the reading range: measure more, or widen it",
        ));
    }
    Ok(points)
}

/// The reading of the amplitude alone: peak and half-power points of the receptance.
fn by_amplitude<W: Worksheet>(receptances: &[ResponsePoint], sheet: W) -> Option<IdentifiedMode<W::Num>> {
    let amplitudes: Vec<(f64, f64)> = receptances.iter().map(|(w, a)| (*w, a.norm())).collect();
    let Some(peak) = identification::measured_peak(&amplitudes) else {
        sheet.warn(|| {
            Text::new(
                "the largest amplitude is the first or the last of the range, so the peak was not measured: the peak and half-power points cannot be evaluated, and the other readings extrapolate beyond the measured range",
            )
        });
        return None;
    };
    let ([Some(lower), Some(upper)], true) = (peak.half_power, peak.receptance.is_normal()) else {
        sheet.warn(|| {
            Text::new(
                "the table does not reach down to 1/√2 of the peak on both sides: there is no half-power reading",
            )
        });
        return None;
    };
    let height = sheet.numerical(
        "Hₕ",
        "mm/N",
        peak.receptance,
        "Height of the measured peak: vertex of the parabola of 1/H² against ω² through the highest point and its neighbours",
    );
    let why = "Half-power frequency below the peak: the receptance is 1/√2 of the peak value";
    let lower = sheet.numerical("ω_a", "Hz", lower, (why, RAO.at("§3.4")));
    let upper = sheet.numerical("ω_b", "Hz", upper, "Half-power frequency above the peak");
    let zeta = sheet.step(
        "ζₕ",
        "1",
        sdof::damping_ratio_from_half_power(lower, upper),
        "Damping ratio from the half-power frequencies, exact for one mode with viscous damping",
    );
    if zeta.value() >= FRAC_1_SQRT_2 {
        return None;
    }
    let natural = sheet.step(
        "ωₕ",
        "Hz",
        sdof::natural_frequency_from_force_peak(identification::peak_between_half_power(lower, upper), zeta),
        ("Natural frequency: the peak lies at ωₙ√(1 − 2ζ²)", RAO.at("§3.4")),
    );
    let constant = sheet.step(
        "Aₕ",
        "1/kg",
        height * natural.powi(2) / sdof::peak_magnification(zeta),
        ("Modal constant: the peak is A/(2ζωₙ²√(1 − ζ²))", RAO.at("§3.4")),
    );
    sheet.check(
        "modal constant from the half-power frequencies alone",
        W::Num::from(1.0) / identification::mass_from_half_power(height, lower, upper),
        constant,
    );
    sheet.answer("half_power_damping_ratio", "Damping ratio, half-power points", zeta);
    Some(IdentifiedMode { natural, damping_ratio: zeta, constant })
}

/// The mode nearest to all points.
fn least_squares<W: Worksheet>(
    points: &[ResponsePoint],
    response: MeasuredResponse,
    damping: DampingKind,
    residuals: ResidualKind,
    sheet: W,
) -> Result<(IdentifiedMode<W::Num>, modal::ModalFit), Refusal> {
    let model = damping.model();
    let with = match residuals {
        ResidualKind::None => Residuals::None,
        ResidualKind::Stiffness => Residuals::Stiffness,
        ResidualKind::StiffnessAndMass => Residuals::StiffnessAndMass,
    };
    let fit = modal::modal_fit(points, response, model, with).map_err(|err| circle::refused(&err))?;
    let how = match model {
        DampingModel::Viscous => {
            "Natural frequency by least squares of the complex differences from A/(ωₙ² − ω² + 2iζωₙω) + R − S/ω²"
        }
        DampingModel::Hysteretic => {
            "Natural frequency by least squares of the complex differences from A/(ωₙ² − ω² + iηωₙ²) + R − S/ω²"
        }
    };
    let natural = sheet.numerical("ωₙ", "Hz", fit.natural_frequency, (how, EWINS.at("§4.4")));
    let (damping, zeta) = match model {
        DampingModel::Viscous => {
            let zeta = sheet.numerical("ζ", "1", fit.damping, "Damping ratio by the same least squares");
            (zeta, zeta)
        }
        DampingModel::Hysteretic => {
            let eta = sheet.numerical("η", "1", fit.damping, "Loss factor by the same least squares");
            sheet.answer("loss_factor", "Loss factor", eta);
            let zeta = sheet.step(
                "ζ",
                "1",
                eta / 2.0,
                "Viscous damping ratio with the same loss at the natural frequency",
            );
            (eta, zeta)
        }
    };
    let constant =
        sheet.numerical("A", "1/kg", fit.modal_constant, "Modal constant by the same least squares");
    let misfit = sheet.numerical(
        "ε",
        "%",
        fit.misfit,
        "Root mean square of the differences between fitted and measured response, over the largest measured one",
    );
    sheet.answer("natural_frequency", "Natural frequency", natural);
    sheet.answer("damping_ratio", "Damping ratio", zeta);
    sheet.answer("modal_constant", "Modal constant", constant);
    let mut answered = vec![natural.value(), damping.value(), constant.value()];
    if residuals != ResidualKind::None {
        let residual =
            sheet.numerical("R", "mm/N", fit.stiffness_residual, "Stiffness residual, for the higher modes");
        sheet.answer("stiffness_residual", "Stiffness residual", residual);
        answered.push(residual.value());
    }
    if residuals == ResidualKind::StiffnessAndMass {
        let residual = sheet.numerical("S", "1/kg", fit.mass_residual, "Mass residual, for the modes below");
        sheet.answer("mass_residual", "Mass residual", residual);
        answered.push(residual.value());
    }
    sheet.verify(|| {
        sheet.check_zeros(
            "the complex residuals are orthogonal to the derivatives of the fit with respect to each of its parameters",
            normal_equations(points, response, model, &answered),
            1.0,
        );
    });
    sheet.answer("misfit", "Fit residual of the points", misfit);
    if fit.misfit > 0.05 {
        sheet.warn(|| {
            Text::new(
                "the points scatter by more than 5 % of the peak about the fit: noise, or more than one mode in this range",
            )
        });
    }
    Ok((IdentifiedMode { natural, damping_ratio: zeta, constant }, fit))
}

/// Mass, stiffness and damping, where force and motion are those of one mass, and the response at resonance.
fn answers<W: Worksheet>(
    mode: &IdentifiedMode<W::Num>,
    damping: DampingKind,
    force: Option<W::Num>,
    sheet: W,
) {
    let IdentifiedMode { natural, damping_ratio, constant } = *mode;
    let resonant = sheet.step(
        "Hₙ",
        "mm/N",
        constant.abs() / (damping_ratio * natural.powi(2) * 2.0),
        ("Receptance of the mode at its natural frequency, A/(2ζωₙ²)", RAO.at("§3.4")),
    );
    sheet.answer("resonant_receptance", "Amplitude at resonance per unit force", resonant);
    if let Some(force) = force {
        let amplitude = sheet.step(
            "Xₙ",
            "mm",
            resonant * force,
            ("Amplitude at the natural frequency under this force", RAO.at("§3.4")),
        );
        sheet.answer("natural_amplitude", "Amplitude at the natural frequency", amplitude);
    }
    if constant.value() < 0.0 {
        sheet.warn(|| {
            Text::new(
                "the modal constant is negative: force and motion are not at the same point, and no mass can be identified from it",
            )
        });
        return;
    }
    let mass = sheet.step(
        "m",
        "kg",
        W::Num::from(1.0) / constant,
        (
            "Modal mass: one over the modal constant, where the motion is that of the point of the force",
            EWINS.at("§4.3"),
        ),
    );
    let stiffness = sheet.step(
        "k",
        "N/m",
        sdof::stiffness_from_natural_frequency(mass, natural),
        ("Stiffness that gives the natural frequency", RAO.at("§2.2")),
    );
    let coefficient = match damping {
        DampingKind::Viscous => sheet.step(
            "c",
            "N*s/m",
            sdof::damping_from_ratio(damping_ratio, stiffness, mass),
            ("Damping coefficient", RAO.at("§2.6")),
        ),
        DampingKind::Hysteretic => sheet.step(
            "c",
            "N*s/m",
            stiffness * damping_ratio * 2.0 / natural,
            ("Viscous damping with the same loss at the natural frequency, ηk/ωₙ", RAO.at("§2.10")),
        ),
    };
    sheet.check(
        "at the natural frequency the damper alone balances the force: 1/(c ωₙ)",
        sdof::damping_from_resonant_receptance(coefficient, natural),
        resonant,
    );
    sheet.answer("mass", "Mass", mass);
    sheet.answer("stiffness", "Stiffness", stiffness);
    sheet.answer("damping", "Damping coefficient", coefficient);
}

/// Differences between the methods.
fn spread<W: Worksheet>(modes: &[(&'static str, IdentifiedMode<W::Num>)], sheet: W) {
    let of = |which: fn(&IdentifiedMode<W::Num>) -> W::Num| {
        let by_size = |a: &W::Num, b: &W::Num| a.value().total_cmp(&b.value());
        let all = || modes.iter().map(|(_, mode)| which(mode));
        all().min_by(by_size).zip(all().max_by(by_size))
    };
    let (Some((slow, fast)), Some((least, most))) = (of(|mode| mode.natural), of(|mode| mode.damping_ratio))
    else {
        return;
    };
    let frequencies = sheet.step(
        "Δω",
        "%",
        (fast - slow) / fast,
        "Difference between the methods in the natural frequency",
    );
    let dampings =
        sheet.step("Δζ", "%", (most - least) / most, "Difference between the methods in the damping ratio");
    sheet.answer("frequency_spread", "Spread of the natural frequency", frequencies);
    sheet.answer("damping_spread", "Spread of the damping ratio", dampings);
    if dampings.value() > 0.1 {
        sheet.warn(|| {
            Text::new(
                "the readings of the damping ratio differ by {spread}: the points about the peak are too few or too \
                 noisy, or this is not one mass on one spring",
            )
            .with_quantity("spread", dampings.value(), "%")
        });
    }
}

/// Warnings at the limits of the methods.
fn caution<W: Worksheet>(count: usize, damping_ratio: f64, sheet: W) {
    if count < FEW {
        sheet.warn(|| {
            Text::new(
                "{count} points are too few: the circle and the fit pass through them whatever their errors; measure more frequencies about the resonance",
            )
            .with("count", count)
        });
    }
    if damping_ratio > 0.1 {
        sheet.warn(|| {
            Text::new(
                "the damping ratio is above 0.1: the half-power points are far from the peak, and other modes contribute to the range between them",
            )
        });
    }
}

/// The methods in rows.
fn side_by_side(rows: Vec<(&'static str, [f64; 3])>) -> TableExhibit {
    let column = |heading: &'static str, unit| Column { heading: heading.into(), unit };
    let row = |(method, numbers): (&'static str, [f64; 3])| {
        std::iter::once(Cell::Text(Text::new(method))).chain(numbers.map(Cell::Number)).collect()
    };
    TableExhibit {
        title: "Comparison of the methods".into(),
        columns: vec![
            column("method", ""),
            column("natural frequency", "Hz"),
            column("damping ratio", "1"),
            column("modal constant", "1/kg"),
        ],
        rows: rows.into_iter().map(row).collect(),
        foot: Vec::new(),
    }
}
