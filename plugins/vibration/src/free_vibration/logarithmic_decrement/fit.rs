//! The decrement of a table of amplitudes.

use std::f64::consts::LN_10;

use dalembert_core::{Refusal, Text, Worksheet};
use dalembert_mechanics::{Real, vibration::decay_fit};

use super::MeasuredPeak;

/// The decrement by least squares of `ln X` over the cycles.
pub(super) fn least_squares<W: Worksheet>(peaks: &[MeasuredPeak], sheet: W) -> Result<W::Num, Refusal> {
    if peaks.len() < 3 {
        return Err(Refusal::because(
            "the table has fewer than three amplitudes: measure more, or write their ratio as two amplitudes",
        ));
    }
    let count = peaks.len() as f64;
    let mean = |of: fn(&MeasuredPeak) -> f64| peaks.iter().map(|peak| of(peak) / count).sum::<f64>();
    let (mean_cycles, mean_log) = (mean(|peak| peak.cycles), mean(|peak| peak.amplitude.ln()));
    let sum = |of: &dyn Fn(f64, f64) -> f64| {
        peaks.iter().map(|peak| of(peak.cycles - mean_cycles, peak.amplitude.ln() - mean_log)).sum::<f64>()
    };
    let (both, squares) = (sum(&|n, log| n * log), sum(&|n, _| n * n));
    if squares == 0.0 {
        return Err(Refusal::because("all amplitudes are at the same cycle: number them 0, 1, 2, …"));
    }
    if both >= 0.0 {
        return Err(Refusal::because(
            "the amplitudes do not fall with the cycles: are the rows in the order of time?",
        ));
    }
    let number = sheet.numerical("N", "1", count, "Number of amplitudes");
    sheet.answer("amplitudes", "Number of amplitudes", number);
    let products = sheet.numerical("S_nx", "1", both, "Sum of (n − n̄)(ln X − mean of ln X) over the table");
    let spread = sheet.numerical("S_nn", "1", squares, "Sum of (n − n̄)² over the table");
    let (first, last) = (&peaks[0], &peaks[peaks.len() - 1]);
    let ends = || W::Num::from((first.amplitude / last.amplitude).ln() / (last.cycles - first.cycles));
    sheet.common_error("δ", "only the first and the last amplitude used", ends);
    let decimal = || -products / spread / LN_10;
    sheet.common_error("δ", "the logarithm to base 10 used in place of the natural one", decimal);
    let decrement = sheet.step(
        "δ",
        "1",
        -products / spread,
        "Decrement by least squares: the slope of the straight line ln X = ln X₀ − δ n",
    );
    sheet.verify(|| {
        let points: Vec<(f64, f64)> = peaks.iter().map(|peak| (peak.cycles, peak.amplitude)).collect();
        if let Some(slope) = decay_fit::logarithmic_slope(&points) {
            sheet.check("the same slope by orthogonal decomposition", W::Num::from(slope), decrement);
        }
    });
    let slope = decrement.value();
    let misfit = sum(&|n, log| (log + slope * n).powi(2));
    let scatter = sheet.numerical(
        "ε",
        "%",
        (misfit / count).sqrt(),
        "Root mean square of the relative differences between the amplitudes and the fitted decay",
    );
    let uncertainty = sheet.numerical(
        "σ_δ",
        "1",
        (misfit / (count - 2.0) / squares).sqrt(),
        "Standard deviation of the decrement",
    );
    sheet.verify(|| {
        // Where the sum of squares is least, the differences are orthogonal to the fitted line.
        let (mut product, mut sizes, mut largest) = (0.0, 0.0, 0.0f64);
        for peak in peaks {
            let (n, log) = (peak.cycles - mean_cycles, peak.amplitude.ln() - mean_log);
            product += log * (log + slope * n);
            sizes += (log * (log + slope * n)).abs();
            largest = largest.max(peak.amplitude.ln().abs() + (slope * peak.cycles).abs());
        }
        // The differences are known to the last places of the logarithms.
        let spread_of_logs = sum(&|_, log| log.abs());
        let error = f64::EPSILON * largest * (spread_of_logs + count * largest * f64::EPSILON);
        sheet.check_residual(
            "scatter: sum of squares from the orthogonality of the residuals to the fitted line",
            scatter.powi(2) * number - product,
            sizes,
            count * error,
        );
        sheet.check_residual(
            "standard deviation of the decrement: the same sum of squares over N − 2 degrees of freedom",
            uncertainty.powi(2) * (number - 2.0) * spread - product,
            sizes,
            count * error,
        );
    });
    sheet.answer("scatter", "Fit residual of the amplitudes", scatter);
    sheet.answer("decrement_deviation", "Standard deviation of the decrement", uncertainty);
    if scatter.value() > 0.05 {
        sheet.warn(|| {
            Text::new(
                "the amplitudes scatter by more than 5 % about an exponential decay: noise, or friction in addition to viscous damping",
            )
        });
    }
    Ok(decrement)
}
