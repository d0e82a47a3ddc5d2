//! Velocities and accelerations of the points of a linkage, as books ask for them: of a pin and of one pin relative to
//! another, as vectors and by magnitude and direction, with normal, tangential and Coriolis parts.

mod names;

use dalembert_core::{Symbol, Text, Worksheet};
use dalembert_mechanics::{Real, Vector};

use crate::{
    shared::{
        built::Solved,
        works::{Number, RotatingLinkWork, across, direction, symbol},
    },
    sources::{NORTON, SHIGLEY},
};

pub(crate) use names::{A, A4, B, B_RELATIVE_TO_A, D, Names, P};

/// Below this part of the velocities or accelerations of a mechanism a vector has no direction.
pub(crate) const AT_REST: f64 = 1e-9;

/// Velocity and acceleration of a point.
#[derive(Clone, Copy)]
pub(crate) struct Motion<W: Worksheet> {
    pub(crate) velocity: W::Vec,
    pub(crate) acceleration: W::Vec,
}

/// Velocities and accelerations of the points of a mechanism that is driven at a speed.
pub(crate) struct Kinematics<W: Worksheet> {
    sheet: W,
    runs: bool,
    /// Speed and magnitude of the acceleration of the driven pin.
    driven: [W::Num; 2],
}

impl<W: Worksheet> Kinematics<W> {
    /// The kinematics of a mechanism whose driven pin is `length` from its pivot.
    #[inline(always)]
    pub(crate) fn new(speed: W::Num, acceleration: W::Num, length: W::Num, sheet: W) -> Self {
        let driven = [speed.abs() * length, (speed.powi(2) + acceleration.abs()) * length];
        Self { sheet, runs: speed.holds(|speed| speed != 0.0), driven }
    }

    /// The motion of a pin of a link about a point of the link, `length` apart: a fixed pivot, or the pin that the
    /// motion is relative to.
    pub(crate) fn about(
        &self,
        of: &Names,
        (arm, length): (W::Vec, W::Num),
        link: RotatingLinkWork<W::Num>,
    ) -> Motion<W> {
        let sheet = self.sheet;
        let turned = across::<W>(arm);
        let why = || Text::new("Velocity of {point}, ω × r").with("point", of.words);
        let velocity = turned * link.speed;
        let velocity = sheet.step_vector(symbol("v", of.of), "m/s", velocity, (why, SHIGLEY.at("ch. 3")));
        let why = || Text::new("Acceleration of {point}, α × r − ω² r").with("point", of.words);
        let acceleration = turned * link.acceleration - arm * link.speed.powi(2);
        let acceleration =
            sheet.step_vector(symbol("a", of.of), "m/s^2", acceleration, (why, SHIGLEY.at("ch. 4")));
        let motion = Motion { velocity, acceleration };
        self.answer(of, motion);
        let [key, label] = of.normal;
        let why =
            || Text::new("Normal acceleration of {point}, towards the centre: ω² r").with("point", of.words);
        let size = link.speed.powi(2) * length;
        let size = sheet.step(symbol("a_n", of.of), "m/s^2", size, (why, NORTON.at("ch. 7")));
        sheet.answer(key, label, size);
        let [key, label] = of.tangential;
        let why = || {
            Text::new("Tangential acceleration of {point}, positive counter-clockwise: α r")
                .with("point", of.words)
        };
        let signed = link.acceleration * length;
        let signed = sheet.step(symbol("a_t", of.of), "m/s^2", signed, (why, NORTON.at("ch. 7")));
        sheet.answer(key, label, signed);
        sheet.verify(|| {
            let scale = acceleration.value().norm_squared();
            let what = Text::new("normal and tangential acceleration of {point} make up its acceleration")
                .with("point", of.words);
            sheet.check_sum(what, size.powi(2) + signed.powi(2), acceleration.dot(acceleration), scale);
        });
        motion
    }

    /// The motion of a point of a link at `arm` from a pin of it; from none where the pin is fixed.
    pub(crate) fn beyond(
        &self,
        of: &Names,
        from: Option<Motion<W>>,
        arm: W::Vec,
        link: RotatingLinkWork<W::Num>,
    ) -> Motion<W> {
        let sheet = self.sheet;
        let turned = across::<W>(arm);
        let why =
            || Text::new("Velocity of {point}: that of the pin and ω × r about it").with("point", of.words);
        let velocity = turned * link.speed;
        let velocity = from.map_or(velocity, |from| from.velocity + velocity);
        let velocity = sheet.step_vector(symbol("v", of.of), "m/s", velocity, (why, SHIGLEY.at("ch. 3")));
        let why = || {
            Text::new("Acceleration of {point}: that of the pin, tangential and normal parts about it")
                .with("point", of.words)
        };
        let turned = turned * link.acceleration;
        let acceleration = from.map_or(turned, |from| from.acceleration + turned) - arm * link.speed.powi(2);
        let acceleration =
            sheet.step_vector(symbol("a", of.of), "m/s^2", acceleration, (why, SHIGLEY.at("ch. 4")));
        let motion = Motion { velocity, acceleration };
        self.answer(of, motion);
        motion
    }

    /// Answers velocity and acceleration, each as a vector and by magnitude and direction.
    fn answer(&self, of: &Names, motion: Motion<W>) {
        if self.runs {
            let names = [of.velocity, of.speed, of.heading];
            self.polar(
                of,
                0,
                names,
                motion.velocity,
                ["Speed of {point}", "Direction of its velocity, from x"],
            );
        }
        let names = [of.acceleration, of.magnitude, of.direction];
        let words = ["Magnitude of the acceleration of {point}", "Direction of its acceleration, from x"];
        self.polar(of, 1, names, motion.acceleration, words);
    }

    /// Answers a vector, the velocity (0) or the acceleration (1), with its magnitude and direction.
    fn polar(
        &self,
        of: &Names,
        order: usize,
        [vector, size, angle]: [[&'static str; 2]; 3],
        value: W::Vec,
        [of_size, of_angle]: [&'static str; 2],
    ) {
        let sheet = self.sheet;
        let (unit, base) = [("m/s", "θ_v"), ("m/s^2", "θ_a")][order];
        sheet.answer_vector(vector[0], vector[1], value);
        let why = || Text::new(of_size).with("point", of.words);
        let magnitude = sheet.step(of.size[order], unit, value.magnitude(), why);
        sheet.answer(size[0], size[1], magnitude);
        if magnitude.holds_with(self.driven[order], |size, driven| size.abs() > AT_REST * driven) {
            let [x, y, _] = value.components();
            let heading = sheet.step(symbol(base, of.of), "deg", y.atan2(x), of_angle);
            sheet.answer(angle[0], angle[1], heading);
            sheet.verify(|| {
                let what = Text::new("{point}: magnitude and direction make up the vector");
                let what = what.with("point", of.words);
                sheet.check_vector(what, direction::<W>(heading) * magnitude, value);
            });
        }
    }

    /// Holds the motion of a point to that of another point and the motion relative to it.
    pub(crate) fn check_relative(&self, names: [&'static str; 3], [point, from, relative]: [Motion<W>; 3]) {
        let whats = [
            ["v_{point} = v_{from} + v_{relative}, along x", "v_{point} = v_{from} + v_{relative}, along y"],
            ["a_{point} = a_{from} + a_{relative}, along x", "a_{point} = a_{from} + a_{relative}, along y"],
        ];
        let parts = [point, from, relative];
        let rates = [parts.map(|of| of.velocity), parts.map(|of| of.acceleration)];
        for (order, (whats, rates)) in whats.into_iter().zip(rates).enumerate() {
            let size = rates.iter().fold(self.driven[order].value(), |most, of| most.max(of.value().norm()));
            let [whole, from, relative] = rates.map(Vector::components);
            for (axis, what) in whats.into_iter().enumerate() {
                let what = Text::new(what).with("point", names[0]).with("from", names[1]);
                let what = what.with("relative", names[2]);
                self.sheet.check_sum(what, whole[axis], from[axis] + relative[axis], size);
            }
        }
    }

    /// The motion of what slides along the unit vector `along` of a link that turns, relative to that link: slip, and
    /// the acceleration of the slip with the Coriolis acceleration.
    pub(crate) fn sliding(along: W::Vec, slip: W::Num, acceleration: W::Num, coriolis: W::Num) -> Motion<W> {
        Motion { velocity: along * slip, acceleration: along * acceleration + across::<W>(along) * coriolis }
    }

    /// Holds angular velocity and angular acceleration of a link to those of the mechanism that was put together.
    pub(crate) fn check_rotation(
        &self,
        number: Number,
        (speed, acceleration): (W::Num, W::Num),
        solved: &Solved,
        link: usize,
    ) {
        let [by_speed, by_acceleration, fastest, hardest] = solved.rotation(link);
        let what = "angular velocity of link {n} from the derivatives of the constraint equations";
        let what = Text::new(what).with("n", number.link);
        self.sheet.check_sum(what, speed, by_speed.into(), fastest);
        let what = "angular acceleration of link {n} from the derivatives of the constraint equations";
        let what = Text::new(what).with("n", number.link);
        self.sheet.check_sum(what, acceleration, by_acceleration.into(), hardest);
    }

    /// Holds the motion of a point of a link to that of the mechanism that was put together, from the derivatives of its
    /// constraint equations. `link` is its place among the links, `at` the point in its axes.
    pub(crate) fn check(&self, of: &Names, motion: Motion<W>, solved: &Solved, link: usize, at: [f64; 2]) {
        let [_, velocity, acceleration] = solved.point(link, at);
        let sizes = solved.sizes();
        let whats = [
            [
                "velocity of {point} along x from the derivatives of the constraint equations",
                "velocity of {point} along y from the derivatives of the constraint equations",
            ],
            [
                "acceleration of {point} along x from the derivatives of the constraint equations",
                "acceleration of {point} along y from the derivatives of the constraint equations",
            ],
        ];
        for (order, (found, by_constraints)) in
            [(motion.velocity, velocity), (motion.acceleration, acceleration)].into_iter().enumerate()
        {
            let [x, y, _] = found.components();
            for (axis, component) in [x, y].into_iter().enumerate() {
                let what = Text::new(whats[order][axis]).with("point", of.words);
                self.sheet.check_sum(what, component, by_constraints[axis].into(), sizes[order]);
            }
        }
    }
}

/// Coriolis acceleration of what slides along a line that turns, driven by a crank of that speed.
#[inline(always)]
pub(crate) fn coriolis<W: Worksheet>(speed: W::Num, slip: W::Num, crank: W::Num, sheet: W) -> W::Num {
    let why = "Coriolis acceleration, 2 ω v_s, perpendicular to the line of sliding";
    sheet.common_error(
        symbol("a", "c"),
        "the angular velocity of the crank used, not that of the line of sliding",
        || crank * slip * 2.0,
    );
    sheet.step(symbol("a", "c"), "m/s^2", speed * slip * 2.0, (why, NORTON.at("ch. 7")))
}

/// Declares the errors in the acceleration of a slider on a rod of length `l` driven by a crank of length `r`.
pub(crate) fn slider_acceleration_errors<W: Worksheet>(
    symbol: impl Into<Symbol>,
    [r, l]: [W::Num; 2],
    [angle, speed, acceleration]: [W::Num; 3],
    sheet: W,
) {
    let symbol = symbol.into();
    let first = || -(r * speed.powi(2) * angle.cos()) - r * acceleration * angle.sin();
    let second = || {
        let doubled = angle * 2.0;
        r.powi(2) / l * (speed.powi(2) * doubled.cos() + acceleration * doubled.sin() / 2.0)
    };
    sheet.common_error(symbol, "the obliquity of the rod neglected", first);
    sheet.common_error(symbol, "the approximate formula of two terms used", || first() - second());
}
