//! Pairs of links that close a loop: two bars that meet in a pin, or a bar that ends in a slider.
//!
//! Positions by the triangle of the lengths; virtual turns and accelerations from the one equation that both ways
//! to the common pin must agree, multiplied by a vector along the link that is not asked for (Uicker, Pennock and
//! Shigley, ch. 2 to 4).

use std::f64::consts::PI;

use dalembert_core::{Refusal, Text, Worksheet};
use dalembert_mechanics::{Real, Vector};

use crate::{
    shared::works::{Number, PointWork, RotatingLinkWork, across, direction, symbol},
    sources::SHIGLEY,
};

/// Links are in one line, and the loop does not determine their motion, below this sine.
const DEAD: f64 = 1e-9;

/// A pin that a pair hangs on.
#[derive(Clone, Copy)]
pub(crate) struct DyadPin<W: Worksheet> {
    /// Name of the point.
    pub(crate) name: &'static str,
    /// Position.
    pub(crate) at: W::Vec,
    /// Motion; `None` for a fixed point.
    pub(crate) moving: Option<PointWork<W>>,
}

/// Two bars that meet: the first from one support, the second from the other.
pub(crate) struct Bars<W: Worksheet> {
    pub(crate) angles: [W::Num; 2],
    /// From the supports to the common pin.
    pub(crate) reach: [W::Vec; 2],
    /// The common pin.
    pub(crate) at: W::Vec,
    numbers: [Number; 2],
    sheet: W,
}

/// A bar from a pin to a slider.
pub(crate) struct Slide<W: Worksheet> {
    pub(crate) bar: RotatingLinkWork<W::Num>,
    /// Position of the slider along its line.
    pub(crate) position: W::Num,
    /// Virtual displacement along the line per unit of the coordinate.
    pub(crate) shift: W::Num,
    pub(crate) velocity: W::Num,
    pub(crate) acceleration: W::Num,
}

/// The triangle of two bars between their supports: the common pin is to the left of the way from the first support
/// to the second, or to its right. `span` names that way.
#[inline(always)]
pub(crate) fn two_bars<W: Worksheet>(
    span: &'static str,
    [p, q]: [DyadPin<W>; 2],
    [b, c]: [W::Num; 2],
    numbers: [Number; 2],
    left: bool,
    sheet: W,
) -> Result<Bars<W>, Refusal> {
    let [first, second] = numbers;
    let why = || Text::new("From {from} to {to}").with("from", p.name).with("to", q.name);
    let s = sheet.step_vector(symbol("s", span), "mm", q.at - p.at, why);
    let distance = s.magnitude();
    let (beyond, short) = (distance - (b + c), (b - c).abs() - distance);
    let refusal = |why: &'static str, gap: W::Num| {
        Refusal::because(
            Text::new(why)
                .with("from", p.name)
                .with("to", q.name)
                .with_quantity("distance", distance.value(), "mm")
                .with_quantity("gap", gap.value(), "mm")
                .with("one", first.link)
                .with("two", second.link),
        )
    };
    if beyond.holds(|gap| gap > 0.0) {
        let why = "the loop does not close: {from} and {to} are {distance} apart, {gap} more than links {one} and {two} can span";
        return Err(refusal(why, beyond));
    }
    if short.holds(|gap| gap > 0.0) {
        let why = "the loop does not close: {from} and {to} are {distance} apart, {gap} less than links {one} and {two} can fold to";
        return Err(refusal(why, short));
    }
    let [x, y, _] = s.components();
    let beta = sheet.step(symbol("β", span), "deg", y.atan2(x), "Angle of that line");
    let cosine = (b.powi(2) + distance.powi(2) - c.powi(2)) / (b * distance * 2.0);
    let why = || Text::new("Law of cosines: angle between that line and link {n}").with("n", first.link);
    let psi = sheet.step(symbol("ψ", first.link), "deg", cosine.acos(), (why, SHIGLEY.at("ch. 2")));
    let angle = if left { beta + psi } else { beta - psi };
    let why = || Text::new("Angle of link {n}").with("n", first.link);
    let one = sheet.step(symbol("θ", first.link), "deg", angle, why);
    let why = || Text::new("Vector of link {n}").with("n", first.link);
    let reach = sheet.step_vector(symbol("r", first.link), "mm", direction::<W>(one) * b, why);
    let why = || Text::new("Vector of link {n}, which closes the loop").with("n", second.link);
    let other = sheet.step_vector(symbol("r", second.link), "mm", reach - s, why);
    let [x, y, _] = other.components();
    let why = || Text::new("Angle of link {n}").with("n", second.link);
    let two = sheet.step(symbol("θ", second.link), "deg", y.atan2(x), why);
    sheet.verify(|| {
        let what = Text::new("link {n} has its length").with("n", second.link);
        sheet.check(what, other.magnitude(), c);
        let what = Text::new("the loop closes at the common pin of links {one} and {two}");
        let what = what.with("one", first.link).with("two", second.link);
        sheet.check_vector(what, p.at + direction::<W>(one) * b, q.at + direction::<W>(two) * c);
    });
    let [.., across] = reach.cross(other).components();
    if (across / (b * c)).holds(|sine| sine.is_nan() || sine.abs() < DEAD) {
        return Err(dead(numbers));
    }
    Ok(Bars { angles: [one, two], reach: [reach, other], at: p.at + reach, numbers, sheet })
}

fn dead([first, second]: [Number; 2]) -> Refusal {
    Refusal::because(
        Text::new("links {one} and {two} are collinear (dead centre): the coordinate does not determine their motion; change it slightly")
            .with("one", first.link)
            .with("two", second.link),
    )
}

/// The motion of a point against another; none if neither moves.
#[inline(always)]
fn against<W: Worksheet>(p: Option<W::Vec>, q: Option<W::Vec>) -> Option<W::Vec> {
    match (p, q) {
        (Some(p), Some(q)) => Some(p - q),
        (Some(p), None) => Some(p),
        (None, Some(q)) => Some(-q),
        (None, None) => None,
    }
}

impl<W: Worksheet> Bars<W> {
    /// The virtual turns of both bars for a unit of the coordinate, by the displacements of their supports.
    #[inline(always)]
    pub(crate) fn turns(&self, base: &'static str, shifts: [Option<W::Vec>; 2]) -> [W::Num; 2] {
        let [first, second] = self.numbers;
        let [one, two] = self.reach;
        let Some(apart) = against::<W>(shifts[0], shifts[1]) else { return [0.0.into(); 2] };
        let why = |n: Number, m: Number| {
            let why = move || {
                let why = "Virtual rotation of link {n}: displacement of the common pin along both paths, dotted with the vector of link {m}";
                Text::new(why).with("n", n.link).with("m", m.link)
            };
            (why, SHIGLEY.at("ch. 3"))
        };
        for (number, reach) in [(first, one), (second, two)] {
            self.sheet.common_error(
                symbol(base, number.link),
                "the whole displacement of the driving pin divided by the length of the link",
                || apart.magnitude() / reach.magnitude(),
            );
        }
        let turn = -(apart.dot(two)) / across::<W>(one).dot(two);
        let turn = self.sheet.step(symbol(base, first.link), "1", turn, why(first, second));
        let other = apart.dot(one) / across::<W>(two).dot(one);
        let other = self.sheet.step(symbol(base, second.link), "1", other, why(second, first));
        [turn, other]
    }

    /// The whole motion of both bars: their supports' and the velocity of the coordinate are known.
    #[inline(always)]
    pub(crate) fn motion(
        &self,
        [p, q]: [DyadPin<W>; 2],
        ratios: [W::Num; 2],
        rate: W::Num,
        moves: bool,
    ) -> [RotatingLinkWork<W::Num>; 2] {
        let zero = W::Num::from(0.0);
        let still = |n: usize| RotatingLinkWork {
            angle: self.angles[n],
            ratio: ratios[n],
            speed: zero,
            acceleration: zero,
        };
        if !moves {
            return [still(0), still(1)];
        }
        let sheet = self.sheet;
        let speed = |n: usize| {
            let link = self.numbers[n].link;
            let why = || Text::new("Angular velocity of link {n}").with("n", link);
            sheet.step(symbol("ω", link), "rad/s", ratios[n] * rate, why)
        };
        let (w1, w2) = (speed(0), speed(1));
        let ends = [p, q].map(|support| support.moving.map(|moving| moving.shift * rate));
        let turning = [0, 1].map(|n| across::<W>(self.reach[n]) * [w1, w2][n]);
        sheet.verify(|| {
            let what = "links {one} and {two} give their common pin the same velocity";
            self.check_common(what, ends, turning);
        });
        let accelerations = self.accelerations([p, q], [w1, w2]);
        [(0, w1), (1, w2)].map(|(n, speed)| RotatingLinkWork {
            speed,
            acceleration: accelerations[n],
            ..still(n)
        })
    }

    /// The angular accelerations of both bars.
    #[inline(always)]
    pub(crate) fn accelerations(&self, [p, q]: [DyadPin<W>; 2], [w1, w2]: [W::Num; 2]) -> [W::Num; 2] {
        let [one, two] = self.reach;
        let of = |support: DyadPin<W>| support.moving.map(|moving| moving.acceleration);
        let inward = one * w1.powi(2) - two * w2.powi(2);
        let supports = against::<W>(of(p), of(q));
        let apart = match supports {
            Some(supports) => inward - supports,
            None => inward,
        };
        let [first, second] = self.numbers;
        let why = "Relative acceleration to be compensated by the angular accelerations of the pair";
        let apart =
            self.sheet.step_vector(symbol("e", first.link), "m/s^2", apart, (why, SHIGLEY.at("ch. 4")));
        let of = |n: Number| {
            let why = move || Text::new("Angular acceleration of link {n}").with("n", n.link);
            (why, SHIGLEY.at("ch. 4"))
        };
        if let Some(supports) = supports {
            let words = "the normal accelerations ω² r of the two links omitted";
            let turn = || -(supports.dot(two)) / across::<W>(one).dot(two);
            self.sheet.common_error(symbol("α", first.link), words, turn);
            let other = || supports.dot(one) / across::<W>(two).dot(one);
            self.sheet.common_error(symbol("α", second.link), words, other);
        }
        let turn = apart.dot(two) / across::<W>(one).dot(two);
        let turn = self.sheet.step(symbol("α", first.link), "rad/s^2", turn, of(first));
        let other = -(apart.dot(one)) / across::<W>(two).dot(one);
        let other = self.sheet.step(symbol("α", second.link), "rad/s^2", other, of(second));
        self.sheet.verify(|| {
            let bars = [(one, turn, w1), (two, other, w2)];
            let against = bars.map(|(reach, turn, speed)| across::<W>(reach) * turn - reach * speed.powi(2));
            let ends = [p, q].map(|support| support.moving.map(|moving| moving.acceleration));
            let what = "links {one} and {two} give their common pin the same acceleration";
            self.check_common(what, ends, against);
        });
        [turn, other]
    }

    /// Holds a rate of the common pin by the first bar to that by the second: of their supports, and against them.
    fn check_common(&self, what: &'static str, ends: [Option<W::Vec>; 2], against: [W::Vec; 2]) {
        let [one, two] = [0, 1].map(|n| ends[n].map_or(against[n], |end| end + against[n]));
        let [first, second] = self.numbers.map(|number| number.link);
        self.sheet.check_vector(Text::new(what).with("one", first).with("two", second), one, two);
    }
}

/// A line that a slider moves on: a point of it, its direction as an angle and as a vector, and the vector to its left.
#[derive(Clone, Copy)]
pub(crate) struct SliderLine<W: Worksheet> {
    pub(crate) through: W::Vec,
    pub(crate) angle: Option<W::Num>,
    pub(crate) along: W::Vec,
    pub(crate) left: W::Vec,
    /// True if the slider is behind the pin that the bar comes from, rather than ahead of it.
    pub(crate) behind: bool,
}

/// A bar from a moving pin to a slider on a line. `of` is the slider's pin; without a
/// rate of the coordinate nothing is said of velocities.
pub(crate) fn bar_and_slider<W: Worksheet>(
    of: &'static str,
    number: Number,
    pin: (DyadPin<W>, PointWork<W>),
    length: W::Num,
    line: SliderLine<W>,
    rate: Option<W::Num>,
    sheet: W,
) -> Result<Slide<W>, Refusal> {
    let (support, moving) = pin;
    let why =
        || Text::new("Distance of the slider's line to the left of {point}").with("point", support.name);
    let height = sheet.step(symbol("n", of), "mm", (line.through - support.at).dot(line.left), why);
    if height.holds_with(length, |height, length| height.abs() > length) {
        let gap = height.value().abs() - length.value();
        return Err(Refusal::because(
            Text::new("the loop does not close: the line of the slider is {distance} away from {point}, and link {n} is {gap} too short")
                .with_quantity("distance", height.value().abs(), "mm")
                .with("point", support.name)
                .with("n", number.link)
                .with_quantity("gap", gap, "mm"),
        ));
    }
    let against_line = (height / length).asin();
    let against_line = if line.behind { W::Num::from(PI) - against_line } else { against_line };
    let angle = match line.angle {
        Some(angle) => angle + against_line,
        None => against_line,
    };
    let why = || Text::new("Angle of link {n}").with("n", number.link);
    let angle = sheet.step(symbol("θ", number.link), "deg", angle, (why, SHIGLEY.at("ch. 2")));
    let why = || Text::new("Vector of link {n}").with("n", number.link);
    let reach = sheet.step_vector(symbol("r", number.link), "mm", direction::<W>(angle) * length, why);
    let turned = across::<W>(reach);
    if turned.dot(line.left).holds_with(length, |across, length| across.abs() < 1e-7 * length) {
        return Err(Refusal::because(
            Text::new("link {n} is perpendicular to the line of its slider (limit position): change the coordinate slightly")
                .with("n", number.link),
        ));
    }
    let position = (support.at + reach - line.through).dot(line.along);
    let position = sheet.step(symbol("x", of), "mm", position, "Position of the slider along its line");
    sheet.verify(|| {
        let what = Text::new("link {n} ends where the slider is on its line").with("n", number.link);
        let end = support.at + direction::<W>(angle) * length;
        sheet.check_vector(what, end, line.through + line.along * position);
    });
    let why =
        || Text::new("Virtual rotation of link {n}: the slider stays on its line").with("n", number.link);
    let ratio = -(moving.shift.dot(line.left)) / turned.dot(line.left);
    sheet.common_error(
        symbol("h", number.link),
        "the whole displacement of the driving pin divided by the length of the link",
        || moving.shift.magnitude() / length,
    );
    let ratio = sheet.step(symbol("h", number.link), "1", ratio, (why, SHIGLEY.at("ch. 3")));
    let shift = (moving.shift + turned * ratio).dot(line.along);
    let why = "Virtual displacement of the slider per unit of the coordinate";
    sheet.common_error(
        symbol("u", of),
        "the displacement of the driving pin taken for that of the slider",
        || moving.shift.magnitude(),
    );
    let shift = sheet.step(symbol("u", of), "mm", shift, (why, SHIGLEY.at("ch. 3")));
    let zero = W::Num::from(0.0);
    let Some(rate) = rate else {
        let bar = RotatingLinkWork { angle, ratio, speed: zero, acceleration: zero };
        return Ok(Slide { bar, position, shift, velocity: zero, acceleration: zero });
    };
    let why = || Text::new("Angular velocity of link {n}").with("n", number.link);
    let speed = sheet.step(symbol("ω", number.link), "rad/s", ratio * rate, why);
    let velocity = sheet.step(symbol("v", of), "m/s", shift * rate, "Velocity of the slider");
    sheet.verify(|| {
        let what = Text::new("both ends of link {n} have the same velocity along it").with("n", number.link);
        let (end, start) = (line.along * velocity, moving.shift * rate);
        let size = length.value() * end.value().norm().max(start.value().norm());
        sheet.check_sum(what, end.dot(reach), start.dot(reach), size);
    });
    let inward = moving.acceleration - reach * speed.powi(2);
    let why = || Text::new("Angular acceleration of link {n}").with("n", number.link);
    let turning = -(inward.dot(line.left)) / turned.dot(line.left);
    let turning = sheet.step(symbol("α", number.link), "rad/s^2", turning, (why, SHIGLEY.at("ch. 4")));
    let acceleration = (inward + turned * turning).dot(line.along);
    let why = ("Acceleration of the slider", SHIGLEY.at("ch. 4"));
    let acceleration = sheet.step(symbol("a", of), "m/s^2", acceleration, why);
    let bar = RotatingLinkWork { angle, ratio, speed, acceleration: turning };
    Ok(Slide { bar, position, shift, velocity, acceleration })
}
