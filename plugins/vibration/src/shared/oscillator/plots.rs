//! The plots and drawings of the textbooks: magnification and phase for several dampings, the vectors of the forces.

use dalembert_core::{Axis, Drawing, Exhibit, Ink, Plot, Series, Sketch, Text, Worksheet};
use dalembert_mechanics::sdof;

use super::motion::OscillatorMotion;
use crate::shared::turning;

/// The damping ratios of a family.
const FAMILY: [f64; 4] = [0.05, 0.2, 0.5, 1.0];
/// Points of each curve of a family.
const POINTS: u16 = 120;

/// A family of curves over the frequency ratio: this oscillator's, then those of other dampings.
pub(crate) fn family(
    title: &'static str,
    y: Axis,
    here: (f64, f64),
    own: impl Fn(f64) -> f64,
    of: impl Fn(f64, f64) -> f64,
) -> Plot {
    let last = (1.4 * here.0).clamp(2.5, 20.0);
    let curve = |of: &dyn Fn(f64) -> f64| -> Vec<(f64, f64)> {
        (0..=POINTS).map(|n| last * f64::from(n) / f64::from(POINTS)).map(|r| (r, of(r))).collect()
    };
    let mut series = vec![Series::line("this oscillator", curve(&own))];
    series.extend(FAMILY.map(|zeta| {
        let label = Text::new("ζ = {ratio}").with_quantity("ratio", zeta, "1");
        Series::line(label, curve(&|r| of(r, zeta)))
    }));
    Plot::new(title, Axis::linear("frequency ratio", "1"), y, series).mark("here", here)
}

/// A family as what an answer is with another frequency, the input at a path, and with the dampings of the family.
pub(crate) fn answered(mut plot: Plot, input: &'static str, answer: &'static str) -> Plot {
    let dampings = [None].into_iter().chain(FAMILY.map(Some));
    let series = std::mem::take(&mut plot.series).into_iter().zip(dampings);
    plot.series = series
        .map(|(series, damping)| match damping {
            Some(ratio) => series.of(answer).with("damping.ratio.ratio", ratio),
            None => series.of(answer),
        })
        .collect();
    plot.over_answer(input, "frequency_ratio")
}

/// Magnification and phase of a harmonic force. `own` is the damping ratio at a frequency ratio, `answer` the name of the
/// magnification among the answers.
pub(crate) fn force_families<W: Worksheet>(
    ratio: f64,
    own: impl Fn(f64) -> f64 + Copy,
    answer: Option<&'static str>,
    sheet: W,
) {
    let magnification = move |r: f64| {
        let zeta = if r > 0.0 { own(r) } else { 0.0 };
        below(sdof::magnification(r, zeta), 20.0)
    };
    let lag = move |r: f64| sdof::phase_lag_from_ratios(r, if r > 0.0 { own(r) } else { 0.0 });
    sheet.show(|| {
        let here = (ratio, sdof::magnification(ratio, own(ratio)));
        let y = Axis::linear("magnification", "1");
        let plot = family("Magnification against frequency ratio", y, here, magnification, |r, zeta| {
            below(sdof::magnification(r, zeta), 20.0)
        });
        Exhibit::Plot(match answer {
            Some(answer) => answered(plot, "frequency", answer),
            None => plot,
        })
    });
    sheet.show(|| {
        let here = (ratio, lag(ratio));
        let y = Axis::linear("phase lag", "deg");
        let plot = family("Phase lag against frequency ratio", y, here, lag, sdof::phase_lag_from_ratios);
        Exhibit::Plot(answered(plot, "frequency", "phase"))
    });
}

/// Transmissibility for several dampings.
pub(crate) fn transmissibility_family(ratio: f64, own: impl Fn(f64) -> f64) -> Plot {
    let of = |r: f64| if r > 0.0 { own(r) } else { 0.0 };
    let here = (ratio, sdof::transmissibility(ratio, of(ratio)));
    let y = Axis::linear("transmissibility", "1");
    let title = "Transmissibility against frequency ratio";
    family(
        title,
        y,
        here,
        |r| below(sdof::transmissibility(r, of(r)), 20.0),
        |r, zeta| below(sdof::transmissibility(r, zeta), 20.0),
    )
}

/// A value, or a gap in the curve where it leaves the picture.
pub(crate) fn below(value: f64, top: f64) -> f64 {
    if value <= top { value } else { f64::INFINITY }
}

/// The forces, or the torques of a rotation, as rotating vectors: spring, damper and inertia add up to what is applied.
pub(crate) fn force_vectors(motion: OscillatorMotion, spring: f64, damper: f64, inertia: f64) -> Drawing {
    let size = spring.max(damper).max(inertia).max(f64::MIN_POSITIVE);
    let [spring, damper, inertia] = [spring, damper, inertia].map(|force| 4.0 * force / size);
    let (corner, tip, end) = ((spring, 0.0), (spring, damper), (spring - inertia, damper));
    let title = motion.of("Rotating vectors of the forces", "Rotating vectors of the torques");
    let [held, damped, inert, applied] =
        motion.of(["kX", "cωX", "mω²X", "F₀"], ["k_t Θ", "c_t ωΘ", "Jω²Θ", "T₀"]);
    Sketch::new(title)
        .circle((0.0, 0.0), end.0.hypot(end.1), Ink::Faint)
        .axis((-4.6, 0.0), (4.6, 0.0))
        .edge(held, (0.0, 0.0), corner, Ink::Body)
        .edge(damped, corner, tip, Ink::Motion)
        .edge(inert, tip, end, Ink::Danger)
        .edge(applied, (0.0, 0.0), end, Ink::Force)
        .finish()
}

/// The mass, spring and damper under a force.
pub(crate) fn mass_spring_damper(force: &'static str, letters: [Text; 2]) -> Drawing {
    supported("One degree of freedom", letters)
        .ground((-1.0, -1.5), (1.0, -1.5))
        .force(force, (0.0, 0.4), (0.0, 1.2))
        .finish()
}

/// The disc on a shaft over a torsional damper, with the letters of its inertia and of the shaft.
pub(crate) fn inertia_spring_damper(torque: &'static str, [inertia, spring]: [Text; 2]) -> Drawing {
    let mut sketch = Sketch::new("One degree of freedom in rotation");
    turning::suspended(&mut sketch, [spring, inertia], 1.6);
    turning::turn(&mut sketch, "θ", (0.0, -0.35), 0.9, Ink::Motion);
    turning::turn(&mut sketch, torque, (0.0, 0.6), 0.5, Ink::Force);
    sketch.damper("c_t", (0.0, -1.5), (0.0, -0.36)).ground((-0.8, -1.5), (0.8, -1.5)).finish()
}

/// A mass over a spring and a damper that stand at the height −1.5, with the letters of the mass and of the spring.
pub(crate) fn supported(title: &'static str, [mass, spring]: [Text; 2]) -> Sketch {
    let mut sketch = Sketch::new(title);
    sketch
        .spring(spring, (-0.45, -1.5), (-0.45, -0.4))
        .damper("c", (0.45, -1.5), (0.45, -0.4))
        .mass(mass, (-0.9, -0.4), (0.9, 0.4))
        .motion("x", (1.2, -0.2), (1.2, 0.5));
    sketch
}
