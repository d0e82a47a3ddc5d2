//! Roberval's balance: two beams one above the other and two pans that stay upright wherever they are loaded.

use dalembert_core::{About, Analysis, Inputs, Refusal, Sketch, Worksheet, register};
use dalembert_mechanics::{
    Real,
    planar::{BodyPoint, Driver, PlanarBody, PlanarJoint, PlanarMechanism, RelativeCoordinate},
};

use crate::{
    shared::equilibria::{animation, down, solved},
    sources::{BEER, RIUL},
};

/// A parallelogram of two beams and two upright stems with pans.
#[derive(Clone, Debug, Inputs)]
pub struct RobervalBalance {
    /// Arm of the beams on the left.
    #[input("l₁", "m", positive)]
    pub left_arm: f64,
    /// Arm of the beams on the right.
    #[input("l₂", "m", positive)]
    pub right_arm: f64,
    /// Distance between the beams.
    #[input("h", "m", positive)]
    pub height: f64,
    /// Mass on the left pan.
    #[input("m₁", "kg", nonnegative)]
    pub left_mass: f64,
    /// Distance of the left mass from its stem, outwards.
    #[input("e₁", "m", default = "0 m")]
    pub left_offset: f64,
    /// Mass on the right pan.
    /// If left blank, the balancing mass is computed.
    #[input("m₂", "kg", nonnegative)]
    pub right_mass: Option<f64>,
    /// Distance of the right mass from its stem, outwards.
    #[input("e₂", "m", default = "0 m")]
    pub right_offset: f64,
    /// Inclination of the beams, the right side up.
    #[input("φ", "deg", min = -90, max = 90, default = "0 deg")]
    pub angle: f64,
    /// Acceleration of gravity.
    #[input("g", "m/s^2", positive, default = "9.81 m/s^2")]
    pub gravity: f64,
}

register!(RobervalBalance);

impl Analysis for RobervalBalance {
    const ABOUT: About = About {
        id: "virtual-work/roberval-balance",
        title: "Roberval balance",
        topic: "Bars and levers",
        summary: "Equilibrant couple of a Roberval balance, or the mass that balances it, and the effect of the mass offsets on its beams.",
        main: &["holding_couple", "right_mass"],
        keywords: "parallelogram scale pans shop balance balança de Roberval paralelogramo pratos",
        sources: &[&BEER, &RIUL],
        cases: include_str!("../../cases/roberval_balance.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &RobervalBalanceGiven<W>, sheet: W) -> Result<(), Refusal> {
        let RobervalBalanceGiven {
            left_arm,
            right_arm,
            height,
            left_mass,
            left_offset,
            right_offset,
            angle,
            gravity,
            ..
        } = given;
        let left = sheet.step("W₁", "N", *left_mass * *gravity, "Weight on the left pan");
        let fall = sheet.step(
            "y′₁",
            "m",
            *left_arm * angle.cos(),
            "Downward virtual displacement of the left pan per unit δφ: the pans translate without rotating, so the offset does not matter",
        );
        let rise = sheet.step(
            "y′₂",
            "m",
            *right_arm * angle.cos(),
            "Upward virtual displacement of the right pan per unit δφ",
        );
        let (mut held, mut weight) = (W::Num::from(0.0), None);
        let right = match given.right_mass {
            Some(mass) => {
                let right = sheet.step("W₂", "N", mass * *gravity, "Weight on the right pan");
                let as_lever = || {
                    (right * (*right_arm + *right_offset) - left * (*left_arm + *left_offset)) * angle.cos()
                };
                sheet.common_error(
                    "T",
                    "the offsets of the masses added to the arms, as on a plain lever",
                    as_lever,
                );
                let couple = sheet.step(
                    "T",
                    "N*m",
                    right * rise - left * fall,
                    ("Equilibrant couple on the beams, raising the right side: its virtual work and those of the weights sum to zero", RIUL.at("eq. 3")),
                );
                sheet.answer("holding_couple", "Equilibrant couple on the beams", couple);
                held = couple;
                right
            }
            None => {
                if angle.value().cos() < 1e-12 {
                    return Err(Refusal::because("the beams are vertical: no weight does virtual work"));
                }
                let as_lever = || left * (*left_arm + *left_offset) / (*right_arm + *right_offset);
                sheet.common_error(
                    "W₂",
                    "the offsets of the masses added to the arms, as on a plain lever",
                    as_lever,
                );
                let right = sheet.step(
                    "W₂",
                    "N",
                    left * fall / rise,
                    (
                        "Weight on the right pan: the total virtual work of both weights is zero",
                        RIUL.at("eq. 3"),
                    ),
                );
                let mass = sheet.step("m₂", "kg", right / *gravity, "Mass on the right pan");
                sheet.answer("right_mass", "Balancing mass", mass);
                weight = Some(mass.value() * self.gravity);
                right
            }
        };
        let pull = |weight: W::Num, offset: W::Num| weight * offset / *height;
        sheet.common_error(
            "H₁",
            "the moment of the weight taken about the pivot of the beams, not about its stem",
            || pull(left, *left_arm + *left_offset),
        );
        let left_force = sheet.step(
            "H₁",
            "N",
            pull(left, *left_offset),
            "Pull of the left stem on the upper beam and push on the lower one: they hold the stem vertical against W₁ e₁",
        );
        sheet.common_error(
            "H₂",
            "the moment of the weight taken about the pivot of the beams, not about its stem",
            || pull(right, *right_arm + *right_offset),
        );
        let right_force = sheet.step(
            "H₂",
            "N",
            pull(right, *right_offset),
            "Pull of the right stem on the upper beam and push on the lower one: they hold the stem vertical against W₂ e₂",
        );
        sheet.answer("left_pull", "Pull of the left stem on the beams", left_force);
        sheet.answer("right_pull", "Pull of the right stem on the beams", right_force);
        sheet.verify(|| {
            let (mechanism, drawn) = self.built(left.value(), weight.unwrap_or(right.value()));
            if let Some(effort) = solved(&mechanism, &drawn) {
                // Rounding of the masses' moments about their stems counts, and of arms that hardly reach out.
                let moment = |weight: W::Num, arm: f64, offset: f64| weight.value() * (arm + offset.abs());
                let size = moment(left, self.left_arm, self.left_offset)
                    + moment(right, self.right_arm, self.right_offset);
                sheet.check_sum(
                    "the couple on the beams from the Newton–Euler equations, with the masses at their offsets",
                    held,
                    effort.newton_euler[0].into(),
                    size,
                );
                for (pull, by_them, what) in [
                    (left_force, effort.multipliers[4], "the pull of the left stem from the Newton–Euler equations"),
                    (right_force, -effort.multipliers[8], "the pull of the right stem from the Newton–Euler equations"),
                ] {
                    let size = left.value() + right.value() + pull.value().abs();
                    sheet.check_sum(what, pull, by_them.into(), size);
                }
            }
        });
        let range = [self.angle.min(-0.35), self.angle.max(0.35)];
        sheet.show(|| animation("The balance", ("angle", self.angle), range, |angle| self.frame(angle)));
        Ok(())
    }
}

impl RobervalBalance {
    fn built(&self, left: f64, right: f64) -> (PlanarMechanism, Vec<[f64; 3]>) {
        let (l1, l2, half) = (self.left_arm, self.right_arm, self.height / 2.0);
        let on = |body: usize, x: f64, y: f64| BodyPoint::body(body, [x, y]);
        let mechanism = PlanarMechanism {
            bodies: vec![PlanarBody::default(); 4],
            joints: vec![
                PlanarJoint::Pin { a: BodyPoint::ground([0.0, half]), b: on(0, 0.0, 0.0) },
                PlanarJoint::Pin { a: BodyPoint::ground([0.0, -half]), b: on(1, 0.0, 0.0) },
                PlanarJoint::Pin { a: on(0, -l1, 0.0), b: on(2, 0.0, half) },
                PlanarJoint::Pin { a: on(1, -l1, 0.0), b: on(2, 0.0, -half) },
                PlanarJoint::Pin { a: on(0, l2, 0.0), b: on(3, 0.0, half) },
                PlanarJoint::Pin { a: on(1, l2, 0.0), b: on(3, 0.0, -half) },
            ],
            drivers: vec![Driver {
                measure: RelativeCoordinate::Angle { of: Some(0), against: None },
                value: self.angle,
                velocity: 0.0,
                acceleration: 0.0,
            }],
            loads: vec![
                down(on(2, -self.left_offset, half), left),
                down(on(3, self.right_offset, half), right),
            ],
            gravity: [0.0; 2],
        };
        let (sin, cos) = self.angle.sin_cos();
        let drawn = vec![
            [0.0, half, self.angle],
            [0.0, -half, self.angle],
            [-l1 * cos, -l1 * sin, 0.0],
            [l2 * cos, l2 * sin, 0.0],
        ];
        (mechanism, drawn)
    }

    fn frame(&self, angle: f64) -> Sketch {
        let (l1, l2, half) = (self.left_arm, self.right_arm, self.height / 2.0);
        let (sin, cos) = angle.sin_cos();
        let size = l1.max(l2).max(self.height);
        let ends = [(-l1 * cos, -l1 * sin), (l2 * cos, l2 * sin)];
        let mut sketch = Sketch::default();
        sketch.size(l1 + l2);
        for y in [half, -half] {
            sketch.bars(ends.map(|end| (end.0, end.1 + y))).pin("", (0.0, y));
        }
        let unit = sketch.symbol();
        sketch
            .dimension("l₁", (ends[0].0, ends[0].1 + half), (0.0, half), 2.0)
            .dimension("l₂", (0.0, half), (ends[1].0, ends[1].1 + half), 2.0)
            .dimension("h", (ends[1].0, ends[1].1 - half), (ends[1].0, ends[1].1 + half), -2.0);
        let pans = [
            (ends[0], -self.left_offset, ["m₁", "e₁", "W₁"]),
            (ends[1], self.right_offset, ["m₂", "e₂", "W₂"]),
        ];
        for ((x, y), offset, [mass, eccentricity, weight]) in pans {
            let pan = y + half + 0.25 * size;
            let reach = (0.2 * size).max(offset.abs() + 0.1 * size);
            let (at, block) = (x + offset, 0.06 * size);
            if offset != 0.0 {
                let above = 2.0 * block / unit + 1.0;
                sketch.dimension(eccentricity, (x, pan), (at, pan), above * offset.signum());
            }
            sketch
                .bars([(x, y - half), (x, pan)])
                .joint("", (x, y + half))
                .joint("", (x, y - half))
                .bars([(x - reach, pan), (x + reach, pan)])
                .mass(mass, (at - block, pan), (at + block, pan + 2.0 * block))
                .force(weight, (at, pan), (at, pan - 0.3 * size));
        }
        sketch
    }
}
