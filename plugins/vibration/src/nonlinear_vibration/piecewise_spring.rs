//! Free vibration on a spring of two slopes: a gap, a stop, a spring that saturates.

use dalembert_core::{
    About, Analysis, Animation, Axis, Drawing, Exhibit, Inputs, Plot, Refusal, Series, Sketch, Worksheet,
    register,
};
use dalembert_mechanics::{Real, sdof, vibration::piecewise::TwoSlopes};

use crate::{
    shared::letters::joined,
    sources::{NAYFEH, THOMSON},
};

/// A mass on a spring whose stiffness changes at a corner, the same on both sides.
#[derive(Clone, Debug, Inputs)]
pub struct PiecewiseSpring {
    /// Mass.
    #[input("m", "kg", positive)]
    pub mass: f64,
    /// Spring characteristic.
    pub characteristic: Characteristic,
    /// Initial displacement.
    #[input("x₀", "m", default = "0 mm")]
    pub displacement: f64,
    /// Initial velocity.
    #[input("v₀", "m/s", default = "0 m/s")]
    pub velocity: f64,
}

/// Force–displacement characteristic.
#[derive(Clone, Debug, Inputs)]
pub enum Characteristic {
    /// Saturating: linear, then a constant force
    Saturating {
        /// Stiffness up to the breakpoint.
        #[input("k₁", "N/m", positive)]
        stiffness: f64,
        /// Displacement at the breakpoint.
        #[input("y", "m", positive)]
        corner: f64,
    },
    /// Bilinear: softer or stiffer beyond the breakpoint
    TwoSlopes {
        /// Stiffness up to the breakpoint.
        #[input("k₁", "N/m", positive)]
        stiffness: f64,
        /// Displacement at the breakpoint.
        #[input("y", "m", positive)]
        corner: f64,
        /// Stiffness beyond the breakpoint.
        #[input("k₂", "N/m", positive)]
        beyond: f64,
    },
    /// Gap: no force until contact with the spring
    Gap {
        /// Free travel to each side.
        #[input("y", "m", positive)]
        corner: f64,
        /// Stiffness of the spring beyond the gap.
        #[input("k₂", "N/m", positive)]
        beyond: f64,
    },
}

register!(PiecewiseSpring);

impl Analysis for PiecewiseSpring {
    const ABOUT: About = About {
        id: "vibration/piecewise-spring",
        title: "Piecewise-linear spring",
        topic: "Nonlinear vibration",
        summary: "Exact free vibration of a mass on a spring with a gap, a stop or a force limit: maximum displacement and period.",
        main: &["period", "frequency", "largest_displacement"],
        keywords: "nonlinear gap clearance bilinear stop elastoplastic folga batente mola bilinear não linear",
        sources: &[&THOMSON, &NAYFEH],
        cases: include_str!("../../cases/piecewise_spring.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &PiecewiseSpringGiven<W>, sheet: W) -> Result<(), Refusal> {
        let spring = self.characteristic.spring();
        let start = self.mass / 2.0 * self.velocity.powi(2) + spring.energy(self.displacement);
        if self.displacement == 0.0 && self.velocity == 0.0 {
            return Err(Refusal::because(
                "the mass starts at rest where no force acts on it: give it a displacement or a velocity",
            ));
        }
        if start == 0.0 {
            return Err(Refusal::because(
                "the mass starts at rest inside the gap, where no force acts on it: give it a velocity, or a displacement beyond the gap",
            ));
        }
        let zero = W::Num::from(0.0);
        let (first, corner, second) = match &given.characteristic {
            CharacteristicGiven::Saturating { stiffness, corner } => (Some(*stiffness), *corner, None),
            CharacteristicGiven::TwoSlopes { stiffness, corner, beyond } => {
                (Some(*stiffness), *corner, Some(*beyond))
            }
            CharacteristicGiven::Gap { corner, beyond } => (None, *corner, Some(*beyond)),
        };
        // Energy up to the corner, then beyond it.
        let at_corner = match first {
            Some(stiffness) => sheet.step(
                "V_y",
                "J",
                stiffness * corner.powi(2) / 2.0,
                ("Energy stored in the spring at the breakpoint", THOMSON.at("§2.4")),
            ),
            None => zero,
        };
        let kinetic = given.mass * given.velocity.powi(2) / 2.0;
        let away = given.displacement.abs();
        let stored = if away.value() <= spring.corner {
            first.map_or(zero, |stiffness| stiffness * away.powi(2) / 2.0)
        } else {
            let more = away - corner;
            let held = first.map_or(zero, |stiffness| stiffness * corner * more);
            at_corner + held + second.map_or(zero, |stiffness| stiffness * more.powi(2) / 2.0)
        };
        if away.value() > spring.corner {
            if let Some(stiffness) = first {
                sheet.common_error(
                    "E",
                    "the stiffness up to the breakpoint used for the whole displacement",
                    || kinetic + stiffness * away.powi(2) / 2.0,
                );
            }
            if let (None, Some(second)) = (first, second) {
                sheet.common_error("E", "the free travel counted as deformation of the spring", || {
                    kinetic + second * away.powi(2) / 2.0
                });
            }
        }
        let energy = sheet.step(
            "E",
            "J",
            kinetic + stored,
            ("Initial energy, which is conserved", THOMSON.at("§2.4")),
        );
        let amplitude = if energy.value() <= at_corner.value() && first.is_some() {
            let stiffness = first.unwrap_or(zero);
            sheet.step(
                "A",
                "mm",
                (energy * 2.0 / stiffness).sqrt(),
                "Maximum displacement: the corner is not reached, the vibration is that of a linear spring",
            )
        } else {
            let rest = sheet.step("W", "J", energy - at_corner, "Energy remaining at the breakpoint");
            let beyond = match (first, second) {
                (Some(stiffness), None) => rest / (stiffness * corner),
                (None, Some(second)) => (rest * 2.0 / second).sqrt(),
                (Some(stiffness), Some(second)) => {
                    let held = stiffness * corner;
                    rest * 2.0 / (held + (held.powi(2) + second * rest * 2.0).sqrt())
                }
                (None, None) => zero,
            };
            if let (Some(stiffness), Some(second)) = (first, second) {
                sheet.common_error("d", "the force of the spring at the breakpoint omitted", || {
                    (rest * 2.0 / second).sqrt()
                });
                sheet.common_error("d", "both stiffnesses added beyond the breakpoint", || {
                    let held = stiffness * corner;
                    let together = stiffness + second;
                    rest * 2.0 / (held + (held.powi(2) + together * rest * 2.0).sqrt())
                });
            }
            let beyond =
                sheet.step("d", "mm", beyond, "Displacement beyond the breakpoint that stores this energy");
            if let Some(stiffness) = first {
                sheet.common_error("A", "the spring assumed linear beyond the breakpoint", || {
                    (energy * 2.0 / stiffness).sqrt()
                });
            }
            sheet.step("A", "mm", corner + beyond, "Maximum displacement")
        };
        let reach = amplitude.value();
        if reach > spring.corner {
            let of = |stiffness: W::Num| {
                W::Num::from(std::f64::consts::TAU) / sdof::natural_frequency(stiffness, given.mass)
            };
            if let Some(stiffness) = first {
                sheet.common_error("T", "the stiffness up to the breakpoint used throughout", || {
                    of(stiffness)
                });
            }
            if let Some(second) = second {
                sheet.common_error("T", "the stiffness beyond the breakpoint used throughout", || of(second));
                sheet.common_error("T", "the secant stiffness at the maximum displacement used", || {
                    let beyond = second * (amplitude - corner);
                    of(first.map_or(beyond, |first| first * corner + beyond) / amplitude)
                });
                if first.is_none() {
                    sheet.common_error("T", "the free travel counted on one side only", || {
                        of(second) + corner * 2.0 / (energy * 2.0 / given.mass).sqrt()
                    });
                }
            }
        }
        let period = sheet.numerical(
            "T",
            "s",
            spring.period(self.mass, reach),
            (
                "Four quarters, each with one part up to the breakpoint and one part beyond it",
                NAYFEH.at("§2.2"),
            ),
        );
        sheet.common_error("V", "a harmonic motion of this amplitude and period assumed", || {
            amplitude * sdof::angular_frequency(period)
        });
        let speed = sheet.step(
            "V",
            "m/s",
            (energy * 2.0 / given.mass).sqrt(),
            "Maximum velocity, at the centre position",
        );
        let frequency = sheet.step("f", "Hz", sdof::angular_frequency(period), "Frequency at this amplitude");
        let force = spring.force(reach);
        sheet.verify(|| {
            // The way beyond the corner is known to the last places of the whole displacement.
            sheet.check_residual(
                "energy stored at the largest displacement",
                W::Num::from(spring.energy(reach) - start),
                start,
                f64::EPSILON * force * reach,
            );
            sheet.check(
                "period by quadrature of dt = dx/v",
                W::Num::from(quadrature(&spring, self.mass, reach)),
                W::Num::from(period.value()),
            );
        });
        sheet.answer("largest_displacement", "Maximum displacement", amplitude);
        sheet.answer("period", "Period", period);
        sheet.answer("frequency", "Frequency", frequency);
        sheet.answer("largest_speed", "Maximum velocity", speed);
        let largest_force = sheet.numerical(
            "Fₘₐₓ",
            "N",
            force,
            "Spring force at that displacement, from the spring characteristic",
        );
        sheet.answer("largest_force", "Maximum force of the spring", largest_force);
        sheet.verify(|| {
            // Straight lines: from rest to the corner, and on to the largest displacement.
            let (corner, top) = (spring.corner.min(reach), largest_force.value());
            let at_corner = if corner < reach { spring.force(corner) } else { top };
            let area = at_corner * corner / 2.0 + (at_corner + top) * (reach - corner) / 2.0;
            sheet.check(
                "area under the characteristic up to the maximum displacement equals the kinetic energy at the equilibrium position",
                W::Num::from(area),
                W::Num::from(self.mass * speed.value().powi(2) / 2.0),
            );
        });
        let period = period.value();
        sheet.show(|| Exhibit::Plot(self.motion(&spring, reach, period)));
        sheet.show(|| Exhibit::Plot(self.backbone(&spring, reach, period)));
        sheet.show(|| Exhibit::Plot(characteristic(&spring, reach)));
        sheet.show(|| Exhibit::Drawing(self.drawing()));
        sheet.show(|| Exhibit::Animation(self.animation(&spring, reach, period)));
        Ok(())
    }
}

impl Characteristic {
    fn spring(&self) -> TwoSlopes {
        match *self {
            Self::Saturating { stiffness, corner } => TwoSlopes { first: stiffness, corner, second: 0.0 },
            Self::TwoSlopes { stiffness, corner, beyond } => {
                TwoSlopes { first: stiffness, corner, second: beyond }
            }
            Self::Gap { corner, beyond } => TwoSlopes { first: 0.0, corner, second: beyond },
        }
    }
}

/// `T = 4 ∫ dx/v`, in each piece with the substitution that takes away the singularity at its end.
fn quadrature(spring: &TwoSlopes, mass: f64, amplitude: f64) -> f64 {
    let corner = amplitude.min(spring.corner);
    // The force is straight over each piece, so its mean is exact: energies close to each other are not subtracted.
    let work = |x: f64, force: f64, way: f64| f64::midpoint(spring.force(x), force) * way;
    // x = end − (end − from) s², so that dx/v is smooth at the turning point.
    let piece = |from: f64, end: f64| -> f64 {
        if end <= from {
            return 0.0;
        }
        let at_end = work(end, spring.force(amplitude), amplitude - end);
        let integrand = |s: f64| {
            if s == 0.0 {
                let pull = spring.force(end) / mass;
                return if end < amplitude { 0.0 } else { 2.0 * (end - from).sqrt() / (2.0 * pull).sqrt() };
            }
            let way = (end - from) * s * s;
            let left = at_end + work(end, spring.force(end - way), way);
            2.0 * (end - from) * s / (2.0 * left / mass).sqrt()
        };
        simpson(integrand)
    };
    4.0 * (piece(0.0, corner) + piece(corner, amplitude))
}

/// Simpson's rule over `0…1`, refined until it does not change.
fn simpson(function: impl Fn(f64) -> f64) -> f64 {
    let mut before = f64::INFINITY;
    for power in 5..16 {
        let count = 1u32 << power;
        let weight = |n: u32| if n == 0 || n == count { 1.0 } else { f64::from(2 + 2 * (n % 2)) };
        let sum: f64 = (0..=count).map(|n| weight(n) * function(f64::from(n) / f64::from(count))).sum();
        let now = sum / (3.0 * f64::from(count));
        if (now - before).abs() <= 1e-13 * now.abs() {
            return now;
        }
        before = now;
    }
    before
}

impl PiecewiseSpring {
    /// Time at which the motion of this amplitude passes the initial state, counted from rest in the middle.
    fn start(&self, spring: &TwoSlopes, amplitude: f64, period: f64) -> f64 {
        // The displacement grows over the first quarter: the instant is bisected.
        let away = self.displacement.abs().min(amplitude);
        let (mut low, mut high) = (0.0, period / 4.0);
        for _ in 0..60 {
            let middle = f64::midpoint(low, high);
            if spring.displacement(self.mass, amplitude, middle) < away {
                low = middle;
            } else {
                high = middle;
            }
        }
        let outward = self.velocity * self.displacement >= 0.0;
        let instant = if outward { low } else { period / 2.0 - low };
        let below = self.displacement < 0.0 || (self.displacement == 0.0 && self.velocity < 0.0);
        if below { instant + period / 2.0 } else { instant }
    }

    fn motion(&self, spring: &TwoSlopes, amplitude: f64, period: f64) -> Plot {
        let start = self.start(spring, amplitude, period);
        let at = |n: u32| {
            let time = 2.0 * period * f64::from(n) / 400.0;
            (time, spring.displacement(self.mass, amplitude, start + time))
        };
        Plot::new(
            "Displacement against time",
            Axis::linear("time", "s"),
            Axis::linear("displacement", "mm"),
            vec![Series::line("x", (0..=400).map(at).collect())],
        )
        .level("corner", spring.corner)
        .level("corner below", -spring.corner)
    }

    fn backbone(&self, spring: &TwoSlopes, amplitude: f64, period: f64) -> Plot {
        let most = 2.0 * amplitude.max(spring.corner);
        let at = |n: u32| {
            let amplitude = most * f64::from(n) / 300.0;
            (amplitude, std::f64::consts::TAU / spring.period(self.mass, amplitude))
        };
        Plot::new(
            "Frequency against amplitude",
            Axis::linear("amplitude", "mm"),
            Axis::linear("frequency", "Hz"),
            vec![Series::line("f", (1..=300).map(at).collect()).of("frequency").with("velocity", 0.0)],
        )
        .over("displacement")
        .mark("at this amplitude", (amplitude, std::f64::consts::TAU / period))
    }

    /// The mass between its springs: the first acts from the middle on, the second beyond y.
    fn drawing(&self) -> Drawing {
        let mut sketch = Sketch::new("The mass and its springs (y is not to scale)");
        sketch
            .ground((-3.4, 0.9), (-3.4, -0.6))
            .ground((-3.4, -0.6), (3.4, -0.6))
            .ground((3.4, -0.6), (3.4, 0.9))
            .mass("m", (-0.6, -0.6), (0.6, 0.5));
        let (first, second) = match self.characteristic {
            Characteristic::Saturating { .. } => (true, false),
            Characteristic::TwoSlopes { .. } => (true, true),
            Characteristic::Gap { .. } => (false, true),
        };
        if first {
            sketch.spring("k₁", (-3.4, 0.2), (-0.6, 0.2));
        }
        if second {
            // Stops at both sides, on springs.
            for side in [-1.0, 1.0] {
                let name = if side > 0.0 { "k₂" } else { "" };
                let level = if first { -0.3 } else { 0.0 };
                sketch
                    .spring(name, (3.4 * side, level), (1.5 * side, level))
                    .bars([(1.5 * side, level - 0.25), (1.5 * side, level + 0.25)]);
            }
        }
        sketch.dimension("y", (0.6, 0.5), (1.5, 0.5), 1.5).axis((1.5, -0.5), (1.5, 0.8));
        let start = [("x₀", self.displacement), ("v₀", self.velocity)];
        let letters = start.map(|(letter, value)| if value == 0.0 { "" } else { letter });
        sketch.motion(joined(&letters), (-0.4, 1.1), (0.5, 1.1)).finish()
    }

    fn animation(&self, spring: &TwoSlopes, amplitude: f64, period: f64) -> Animation {
        const FRAMES: u32 = 24;
        let corner = spring.corner / amplitude;
        let frame = |n: u32| {
            let x = spring.displacement(self.mass, amplitude, period * f64::from(n) / f64::from(FRAMES))
                / amplitude;
            let mut sketch = Sketch::default();
            sketch.ground((-1.6, -0.25), (1.6, -0.25));
            if corner < 1.0 {
                for at in [-corner - 0.25, corner + 0.25] {
                    sketch.axis((at, -0.25), (at, 0.4));
                }
            }
            sketch.mass("m", (x - 0.25, -0.25), (x + 0.25, 0.25)).motion("x", (-1.6, 0.6), (-1.2, 0.6));
            sketch
        };
        Sketch::animation("The motion of the mass", (0..FRAMES).map(frame), 2.0)
    }
}

fn characteristic(spring: &TwoSlopes, amplitude: f64) -> Plot {
    let most = 1.3 * amplitude.max(spring.corner);
    let corners = [-most, -spring.corner, spring.corner, most];
    Plot::new(
        "Force against displacement",
        Axis::linear("displacement", "mm"),
        Axis::linear("force", "N"),
        vec![Series::line("F", corners.map(|x| (x, spring.force(x))).to_vec())],
    )
    .mark("maximum displacement", (amplitude, spring.force(amplitude)))
}
