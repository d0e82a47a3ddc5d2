//! The circle fit in the Nyquist plane.

use dalembert_core::{Refusal, Text, Worksheet};
use dalembert_mechanics::{
    Real,
    identification::modal::{
        self, CircleFit, Complex, DampingModel, MeasuredResponse, ModalError, ResponsePoint,
    },
};

use super::mode::{DampingKind, IdentifiedMode};
use crate::sources::EWINS;

/// The mode of the circle, with the circle for the plot.
pub(super) fn circle<W: Worksheet>(
    points: &[ResponsePoint],
    response: MeasuredResponse,
    damping: DampingKind,
    sheet: W,
) -> Result<(IdentifiedMode<W::Num>, CircleFit), Refusal> {
    let model = damping.model();
    let fit = modal::circle_fit(points, response, model).map_err(|err| refused(&err))?;
    let unit = match model {
        DampingModel::Viscous => "mm/(N*s)",
        DampingModel::Hysteretic => "mm/N",
    };
    let how = match model {
        DampingModel::Viscous => {
            "Diameter of the circle through the mobilities, from a least-squares fit of x² + y² + ax + by + c"
        }
        DampingModel::Hysteretic => {
            "Diameter of the circle through the receptances, from a least-squares fit of x² + y² + ax + by + c"
        }
    };
    let diameter = sheet.numerical("D", unit, 2.0 * fit.circle.radius, (how, EWINS.at("§4.3.3")));
    let misfit = sheet.numerical(
        "ε_D",
        "%",
        fit.circle.misfit,
        "Root mean square of the distances of the points from the circle, over its radius",
    );
    let why =
        "Natural frequency: where the points go round the circle fastest, by least squares of their angles";
    let natural = sheet.numerical("ω_D", "Hz", fit.natural_frequency, (why, EWINS.at("§4.3.3")));
    let why = "Frequency a quarter of the circle before it: lower half-power point";
    let lower = sheet.numerical("ω_l", "Hz", fit.half_power[0], (why, EWINS.at("§4.3.3")));
    let upper = sheet.numerical(
        "ω_u",
        "Hz",
        fit.half_power[1],
        "A quarter of the circle after it: upper half-power point",
    );
    sheet.check_zeros("the angles round the circle satisfy their normal equations", fit.slopes, 1.0);
    sheet.verify(|| {
        let squares: f64 = points
            .iter()
            .map(|point| {
                let receptance = response.receptance(*point);
                let turned = match model {
                    DampingModel::Viscous => receptance * Complex::new(0.0, point.0),
                    DampingModel::Hysteretic => receptance,
                };
                (turned - fit.circle.centre).norm_sqr()
            })
            .sum();
        sheet.check(
            "square of the radius is the mean square of the distances of the points from the centre",
            W::Num::from(squares / points.len() as f64),
            W::Num::from(diameter.value().powi(2) / 4.0),
        );
    });
    let (ratio, constant) = match model {
        DampingModel::Viscous => {
            let zeta = sheet.step(
                "ζ_D",
                "1",
                (upper - lower) / (natural * 2.0),
                ("Damping ratio from the half-power points, exact for the mobility", EWINS.at("§4.3.3")),
            );
            sheet.check("natural frequency from the half-power points", (lower * upper).sqrt(), natural);
            let constant = sheet.step(
                "A_D",
                "1/kg",
                diameter * zeta * natural * 2.0,
                ("Modal constant: the diameter is A/(2ζωₙ)", EWINS.at("§4.3.3")),
            );
            (zeta, constant)
        }
        DampingModel::Hysteretic => {
            let eta = sheet.step(
                "η_D",
                "1",
                (upper.powi(2) - lower.powi(2)) / (natural.powi(2) * 2.0),
                ("Loss factor from the half-power points, exact for the receptance", EWINS.at("§4.3.3")),
            );
            if fit.half_power[0] > 0.0 {
                sheet.check(
                    "natural frequency from the half-power points",
                    ((lower.powi(2) + upper.powi(2)) / 2.0).sqrt(),
                    natural,
                );
            }
            let constant = sheet.step(
                "A_D",
                "1/kg",
                diameter * eta * natural.powi(2),
                ("Modal constant: the diameter is A/(ηωₙ²)", EWINS.at("§4.3.3")),
            );
            let zeta = sheet.step(
                "ζ_D",
                "1",
                eta / 2.0,
                "Viscous damping ratio with the same loss at the natural frequency",
            );
            (zeta, constant)
        }
    };
    sheet.check(
        "damping ratio from the upper half-power point alone, a quarter of the circle after the natural frequency",
        match model {
            DampingModel::Viscous => upper / natural - natural / upper,
            DampingModel::Hysteretic => (upper / natural).powi(2) - 1.0,
        },
        ratio * 2.0,
    );
    sheet.answer("circle_diameter", "Diameter of the Nyquist circle", diameter);
    sheet.answer("circle_misfit", "Fit residual of the points about the circle", misfit);
    sheet.answer("circle_natural_frequency", "Natural frequency, circle fit", natural);
    sheet.answer("circle_damping_ratio", "Damping ratio, circle fit", ratio);
    sheet.answer("lower_half_power", "Lower half-power frequency, circle fit", lower);
    sheet.answer("upper_half_power", "Upper half-power frequency, circle fit", upper);
    if let Some([least, most]) = fit.damping_of_pairs
        && most - least > 0.2 * most
    {
        sheet.warn(|| {
            Text::new(
                "pairs of points below and above the natural frequency give damping values that differ by {spread}: noise, damping of another kind, or another mode nearby",
            )
            .with_quantity("spread", (most - least) / most, "%")
        });
    }
    Ok((IdentifiedMode { natural, damping_ratio: ratio, constant }, fit))
}

/// A fit that could not be made, in words.
pub(super) fn refused(err: &ModalError) -> Refusal {
    match err {
        ModalError::TooFew { need, .. } => Refusal::because(
            Text::new("there are too few frequencies above zero: {need} at least are needed")
                .with("need", need),
        ),
        ModalError::NoCircle => Refusal::because(
            "the points do not lie on a circle in the Nyquist plane: check that real and imaginary part, or amplitude and phase, are in their columns",
        ),
        _ => Refusal::because(
            "no damped mode fits these points: choose a range of frequencies about one resonance only, and check that the imaginary part of the receptance is negative there",
        ),
    }
}
