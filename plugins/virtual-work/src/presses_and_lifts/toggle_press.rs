//! A toggle press: two links that are pushed towards a straight line thrust with a force that grows without bound.

use std::f64::consts::PI;

use dalembert_core::{
    About, Analysis, Axis, Exhibit, Inputs, Plot, Refusal, Series, Sketch, Text, Worksheet, register,
};
use dalembert_mechanics::{
    Real,
    planar::{BodyPoint, Driver, PlanarBody, PlanarJoint, PlanarLoad, PlanarMechanism, RelativeCoordinate},
};

use crate::{
    shared::equilibria::{animation, reactions, solved, spread},
    sources::{BEER, HIBBELER, RIUL},
};

/// Two links between a fixed pin and a ram that slides along the line of thrust, pushed at the knee.
#[derive(Clone, Debug, Inputs)]
pub struct TogglePress {
    /// Length of the link at the fixed pin.
    #[input("L₁", "m", positive)]
    pub fixed_link: f64,
    /// Length of the link at the ram.
    #[input("L₂", "m", positive)]
    pub ram_link: f64,
    /// Angle of the link at the fixed pin from the line of thrust.
    #[input("α", "deg", positive, below = 90)]
    pub angle: f64,
    /// Find.
    pub sought: TogglePressUnknown,
}

/// Unknown of the problem.
#[derive(Clone, Debug, Inputs)]
pub enum TogglePressUnknown {
    /// Thrust of the ram
    Thrust {
        /// Force on the knee, perpendicular to the line of thrust.
        #[input("P", "N", positive)]
        knee: f64,
    },
    /// Force on the knee
    Knee {
        /// Thrust of the ram.
        #[input("Q", "N", positive)]
        thrust: f64,
    },
}

register!(TogglePress);

impl Analysis for TogglePress {
    const ABOUT: About = About {
        id: "virtual-work/toggle-press",
        title: "Toggle press",
        topic: "Presses and lifts",
        summary: "Thrust of a toggle press from the force on its knee, or vice versa, with the forces in its links.",
        main: &["thrust", "mechanical_advantage"],
        keywords: "knuckle joint press clamp mechanical advantage prensa de joelho alavanca articulada vantagem mecânica grampo",
        sources: &[&BEER, &HIBBELER, &RIUL],
        cases: include_str!("../../cases/toggle_press.toml"),
    };

    fn solve<W: Worksheet>(&self, given: &TogglePressGiven<W>, sheet: W) -> Result<(), Refusal> {
        let (l1, l2, alpha) = (given.fixed_link, given.ram_link, given.angle);
        let height = sheet.step("y", "mm", l1 * alpha.sin(), "Height of the knee above the line of thrust");
        if height.value() >= l2.value() {
            let why =
                Text::new("the link at the ram does not reach the line of thrust: it is {short} too short");
            return Err(Refusal::NoAnswer(why.with_quantity("short", height.value() - l2.value(), "mm")));
        }
        sheet.common_error("β", "both links taken at the same angle to the line of thrust", || alpha);
        let beta = sheet.step(
            "β",
            "deg",
            (height / l2).asin(),
            "Angle of the link at the ram: both links meet at the knee, L₁ sin α = L₂ sin β",
        );
        let rise =
            sheet.step("y′", "mm", l1 * alpha.cos(), "Upward virtual displacement of the knee per unit δα");
        let turn = sheet.step(
            "β′",
            "1",
            rise / (l2 * beta.cos()),
            "Virtual rotation of the link at the ram: L₂ cos β δβ = L₁ cos α δα",
        );
        let retreat = sheet.step(
            "x′",
            "mm",
            l1 * alpha.sin() + l2 * beta.sin() * turn,
            "Virtual retraction of the ram per unit δα, from x = L₁ cos α + L₂ cos β",
        );
        let equal_links = "the formula for two equal links, Q = P/(2 tan α), used";
        sheet.common_error("r", equal_links, || W::Num::from(0.5) / alpha.tan());
        let ratio = sheet.step(
            "r",
            "1",
            rise / retreat,
            "Mechanical advantage: displacement of the knee over that of the ram",
        );
        let words = "P δy + Q δx = 0: the virtual works of the knee force and of the thrust cancel";
        let (knee, thrust) = match &given.sought {
            TogglePressUnknownGiven::Thrust { knee } => {
                sheet.common_error("Q", equal_links, || *knee / (alpha.tan() * 2.0));
                let half = "the force in a link, P/(2 sin α), taken for the thrust";
                sheet.common_error("Q", half, || *knee / (alpha.sin() * 2.0));
                let thrust = sheet.step("Q", "N", *knee * rise / retreat, (words, RIUL.at("eq. 3")));
                sheet.answer("thrust", "Thrust of the ram", thrust);
                (*knee, thrust)
            }
            TogglePressUnknownGiven::Knee { thrust } => {
                sheet.common_error("P", equal_links, || *thrust * alpha.tan() * 2.0);
                let knee = sheet.step("P", "N", *thrust * retreat / rise, (words, RIUL.at("eq. 3")));
                sheet.answer("knee", "Force on the knee", knee);
                (knee, *thrust)
            }
        };
        sheet.answer("mechanical_advantage", "Mechanical advantage", ratio);
        let halved = "half of the knee force given to each link";
        sheet.common_error("F₁", halved, || knee / (alpha.sin() * 2.0));
        sheet.common_error("F₁", "the thrust resolved along the link", || thrust * alpha.cos());
        let first = sheet.step(
            "F₁",
            "N",
            (knee - thrust * beta.tan()) / alpha.sin(),
            "Compression of the link at the fixed pin, from the forces on the knee perpendicular to the line of thrust",
        );
        sheet.common_error("F₂", halved, || knee / (beta.sin() * 2.0));
        sheet.common_error("F₂", "the thrust resolved along the link", || thrust * beta.cos());
        let second = sheet.step(
            "F₂",
            "N",
            thrust / beta.cos(),
            "Compression of the link at the ram: along the line of thrust it is Q",
        );
        sheet.common_error("N", "half of the knee force taken for that of the guide", || knee / 2.0);
        let side = sheet.step(
            "N",
            "N",
            thrust * beta.tan(),
            "Force of the guide on the ram, perpendicular to the line of thrust",
        );
        let even = || (l1 + l2) * (W::Num::from(1.0) - alpha.cos());
        sheet.common_error("s", "both links taken at the same angle to the line of thrust", even);
        let left = sheet.step(
            "s",
            "mm",
            l1 * 2.0 * (alpha / 2.0).sin().powi(2) + l2 * 2.0 * (beta / 2.0).sin().powi(2),
            "Remaining stroke of the ram until the links are collinear, L₁ (1 − cos α) + L₂ (1 − cos β) with 1 − cos x = 2 sin²(x/2)",
        );
        sheet.answer("fixed_link_force", "Compression of the link at the fixed pin", first);
        sheet.answer("ram_link_force", "Compression of the link at the ram", second);
        sheet.answer("guide_force", "Force of the guide on the ram", side);
        sheet.answer("remaining_stroke", "Remaining stroke of the ram until the links are collinear", left);
        sheet.verify(|| {
            sheet.check(
                "the remaining stroke of the ram from the lengths along the line of thrust",
                l1 + l2 - l1 * alpha.cos() - l2 * beta.cos(),
                left,
            );
            sheet.check("the thrust from P = Q (tan α + tan β)", knee / (alpha.tan() + beta.tan()), thrust);
            sheet.check("the forces along the line of thrust at the knee", first * alpha.cos(), thrust);
            let (mechanism, drawn) = self.built(beta.value(), knee.value());
            let names = ["Fixed pin", "Knee", "Guide of the ram"].map(Text::from);
            if let Some(table) = reactions(&mechanism, &drawn, &names) {
                sheet.show(|| table);
            }
            if let Some(effort) = solved(&mechanism, &drawn) {
                let found = W::Num::from(-effort.newton_euler[0]);
                sheet.check("the thrust from the Newton–Euler equations of every body", found, thrust);
                let multipliers = &effort.multipliers;
                let at_pin = multipliers[0].hypot(multipliers[1]);
                sheet.check(
                    "the force on the fixed pin from the Newton–Euler equations",
                    W::Num::from(at_pin),
                    first,
                );
                let at_knee = multipliers[2].hypot(multipliers[3]);
                let what = "the force of the link at the ram on the knee from the Newton–Euler equations";
                sheet.check(what, W::Num::from(at_knee), second);
                let what = "the force of the guide from the Newton–Euler equations";
                let scale = thrust.value() + knee.value();
                sheet.check_sum(what, side, multipliers[4].abs().into(), scale);
                let by_them = W::Num::from(-effort.newton_euler[0] / knee.value());
                sheet.check("the mechanical advantage from the Newton–Euler equations", by_them, ratio);
            }
        });
        if ratio.value() > 50.0 {
            sheet.warn(|| {
                Text::new(
                    "the links are nearly collinear: clearances and the stiffness of the frame, not this ratio, limit the thrust",
                )
            });
        }
        sheet.show(|| Exhibit::Plot(self.advantage(ratio.value())));
        let range =
            [0.02, (1.6 * self.angle).min(1.4).min(0.95 * (self.ram_link / self.fixed_link).min(1.0).asin())];
        sheet
            .show(|| animation("The press closing", ("angle", self.angle), range, |angle| self.frame(angle)));
        Ok(())
    }
}

impl TogglePress {
    fn other_angle(&self, angle: f64) -> f64 {
        (self.fixed_link * angle.sin() / self.ram_link).min(1.0).asin()
    }

    fn built(&self, beta: f64, knee: f64) -> (PlanarMechanism, Vec<[f64; 3]>) {
        let (l1, l2, alpha) = (self.fixed_link, self.ram_link, self.angle);
        let pin = BodyPoint::ground([0.0; 2]);
        let (at_knee, ram) = (BodyPoint::body(0, [l1, 0.0]), BodyPoint::body(1, [l2, 0.0]));
        let x = l1 * alpha.cos() + l2 * beta.cos();
        let mechanism = PlanarMechanism {
            bodies: vec![PlanarBody::default(); 2],
            joints: vec![
                PlanarJoint::Pin { a: pin, b: BodyPoint::body(0, [0.0; 2]) },
                PlanarJoint::Pin { a: at_knee, b: BodyPoint::body(1, [0.0; 2]) },
                PlanarJoint::Slot { guide: pin, direction: 0.0, pin: ram, offset: 0.0 },
            ],
            drivers: vec![Driver {
                measure: RelativeCoordinate::Component { direction: [1.0, 0.0], from: pin, to: ram },
                value: x,
                velocity: 0.0,
                acceleration: 0.0,
            }],
            loads: vec![PlanarLoad::Force { at: at_knee, force: [0.0, -knee], turns_with: None }],
            gravity: [0.0; 2],
        };
        (mechanism, vec![[0.0, 0.0, alpha], [l1 * alpha.cos(), l1 * alpha.sin(), -beta]])
    }

    fn advantage(&self, present: f64) -> Plot {
        let last = (self.ram_link / self.fixed_link).min(1.0).asin().min(1.5);
        let at = |angle: f64| (angle, 1.0 / (angle.tan() + self.other_angle(angle).tan()));
        Plot::new(
            "Mechanical advantage against the angle",
            Axis::linear("angle of the link at the fixed pin", "deg"),
            Axis::linear("thrust over force on the knee", "1"),
            vec![
                Series::line("Q/P", spread([0.03, 0.98 * last], 300).map(at).collect())
                    .of("mechanical_advantage"),
            ],
        )
        .over("angle")
        .mark("at this angle", (self.angle, present))
    }

    fn frame(&self, angle: f64) -> Sketch {
        let (l1, l2) = (self.fixed_link, self.ram_link);
        let beta = self.other_angle(angle);
        let (o, knee) = ((0.0, 0.0), (l1 * angle.cos(), l1 * angle.sin()));
        let ram = (knee.0 + l2 * beta.cos(), 0.0);
        let tail = (knee.0, knee.1 + 0.35 * l1);
        let mut sketch = Sketch::default();
        sketch
            .size(1.4 * (l1 + l2))
            .axis(o, (1.3 * (l1 + l2), 0.0))
            .guide((0.6 * (l1 + l2), 0.0), (1.2 * (l1 + l2), 0.0))
            .slider("", ram, 0.0)
            .link("L₁", o, knee)
            .link("L₂", knee, ram)
            .pin("", o)
            .joint("", knee)
            .joint("", ram)
            .angle("α", o, 0.0, angle)
            .angle("β", ram, PI - beta, PI)
            .force("", tail, (knee.0, knee.1 + 0.05 * l1))
            .label("P", tail)
            .force("Q", (ram.0 + 0.12 * (l1 + l2), 0.0), (ram.0 + 0.12 * (l1 + l2) + 0.3 * l2, 0.0));
        sketch
    }
}
