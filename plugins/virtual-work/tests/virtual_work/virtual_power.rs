//! Virtual power against the equations of Newton and Euler, and what it refuses and warns of.

use std::fmt::Write as _;

use dalembert_core::{Refusal, SolveError};
use dalembert_mechanics::slider_crank::{Branch, CrankMotion, SliderCrank, SliderCrankMotion};

use crate::solved::solve;

/// Rod and slider of an engine whose crank has no mass.
struct Engine {
    shape: SliderCrank,
    crank: CrankMotion,
    rod_mass: f64,
    rod_inertia: f64,
    /// Distance of the rod's centre of mass from the crank pin, over its length.
    centre: f64,
    slider_mass: f64,
    force: f64,
    gravity: f64,
}

/// Position, velocity and acceleration of a point.
struct Moving {
    position: [f64; 2],
    velocity: [f64; 2],
    acceleration: [f64; 2],
}

impl Engine {
    fn pin(&self) -> Moving {
        let (r, (sin, cos)) = (self.shape.crank, self.crank.angle.sin_cos());
        let (w, alpha) = (self.crank.speed, self.crank.acceleration);
        Moving {
            position: [r * cos, r * sin],
            velocity: [-r * w * sin, r * w * cos],
            acceleration: [-r * w * w * cos - r * alpha * sin, -r * w * w * sin + r * alpha * cos],
        }
    }

    fn rod_centre(&self, motion: &SliderCrankMotion) -> Moving {
        let pin = self.pin();
        let between = |a: [f64; 2], b: [f64; 2]| {
            [a[0] + (b[0] - a[0]) * self.centre, a[1] + (b[1] - a[1]) * self.centre]
        };
        Moving {
            position: between(pin.position, [motion.slider_position, self.shape.offset]),
            velocity: between(pin.velocity, [motion.slider_velocity, 0.0]),
            acceleration: between(pin.acceleration, [motion.slider_acceleration, 0.0]),
        }
    }

    /// The torque on the crank from the forces in the joints: each link by itself.
    fn newton_euler_torque(&self, motion: &SliderCrankMotion) -> f64 {
        let (pin, centre) = (self.pin(), self.rod_centre(motion));
        let to_pin = [pin.position[0] - centre.position[0], pin.position[1] - centre.position[1]];
        let to_slider = [motion.slider_position - centre.position[0], self.shape.offset - centre.position[1]];
        let slider_x = self.force - self.slider_mass * motion.slider_acceleration;
        let pin_x = self.rod_mass * centre.acceleration[0] - slider_x;
        let vertical = self.rod_mass * (centre.acceleration[1] + self.gravity);
        let slider_y = (self.rod_inertia * motion.rod_acceleration - to_pin[0] * vertical
            + to_pin[1] * pin_x
            + to_slider[1] * slider_x)
            / (to_slider[0] - to_pin[0]);
        let pin_y = vertical - slider_y;
        pin.position[0] * pin_y - pin.position[1] * pin_x
    }

    fn problem(&self, motion: &SliderCrankMotion) -> String {
        let centre = self.rod_centre(motion);
        let vector = |[x, y]: [f64; 2], unit: &str| format!("({x:e}; {y:e}) {unit}");
        let mut text = problem(
            &vector([0.0, -self.gravity], "m/s^2"),
            &format!("driving-torque.link.turning = {{ speed = \"{:e} rad/s\" }}", self.crank.speed),
        );
        write!(
            text,
            r#"
[[inputs.bodies]]
name = "rod"
mass = "{:e} kg"
inertia = "{:e} kg*m^2"
velocity = "{}"
acceleration = "{}"
angular_velocity = "{:e} rad/s"
angular_acceleration = "{:e} rad/s^2"
[[inputs.bodies]]
name = "slider"
mass = "{:e} kg"
velocity = "{}"
acceleration = "{}"
[[inputs.forces]]
name = "gas"
force = "{}"
point.mass-centre = {{ body = "slider" }}
[inputs.slider_crank]
geometry.lengths = {{ crank = "{:e} m", rod = "{:e} m", offset = "{:e} m", crank_angle = "{:e} rad", crank_acceleration = "{:e} rad/s^2" }}
crank_speed = "{:e} rad/s"
rod = "rod"
slider = "slider"
"#,
            self.rod_mass,
            self.rod_inertia,
            vector(centre.velocity, "m/s"),
            vector(centre.acceleration, "m/s^2"),
            motion.rod_speed,
            motion.rod_acceleration,
            self.slider_mass,
            vector([motion.slider_velocity, 0.0], "m/s"),
            vector([motion.slider_acceleration, 0.0], "m/s^2"),
            vector([self.force, 0.0], "N"),
            self.shape.crank,
            self.shape.rod,
            self.shape.offset,
            self.crank.angle,
            self.crank.acceleration,
            self.crank.speed,
        )
        .expect("a string takes whatever is written");
        text
    }
}

#[test]
fn virtual_power_is_the_torque_of_newton_and_euler() {
    let mut largest = 0.0f64;
    for step in 0..72 {
        let n = f64::from(step);
        let engine = Engine {
            shape: SliderCrank {
                crank: 0.05 + 0.001 * n,
                rod: 0.2 + 0.003 * n,
                offset: 0.03 * (n * 0.7).sin(),
                branch: Branch::Ahead,
            },
            crank: CrankMotion {
                angle: n * 0.31,
                speed: 150.0 - 4.1 * n,
                acceleration: 900.0 * (n * 1.3).cos(),
            },
            rod_mass: 0.5 + 0.02 * n,
            rod_inertia: 0.004 + 0.0001 * n,
            centre: 0.2 + 0.008 * n,
            slider_mass: 0.4 + 0.01 * n,
            force: 4000.0 * (n * 0.9).sin(),
            gravity: 9.81,
        };
        let motion = engine.shape.motion(engine.crank).unwrap();
        let solution = solve(&engine.problem(&motion)).unwrap();
        let torque = solution.answer("torque").unwrap().si().unwrap();
        let expected = engine.newton_euler_torque(&motion);
        largest = largest.max(expected.abs());
        assert!((torque - expected).abs() < 1e-9 * largest, "{step}: {torque} and {expected}");
        assert!(solution.warnings.is_empty(), "{step}: {:?}", solution.warnings);
        assert!(solution.checks.iter().all(|check| check.passed), "{step}: {:?}", solution.checks);
    }
}

#[test]
fn a_motion_that_does_not_close_the_loop_is_reported_by_how_much() {
    let engine = Engine {
        shape: SliderCrank { crank: 0.1, rod: 0.3, offset: 0.0, branch: Branch::Ahead },
        crank: CrankMotion { angle: 0.8, speed: 10.0, acceleration: 0.0 },
        rod_mass: 1.0,
        rod_inertia: 0.01,
        centre: 0.5,
        slider_mass: 1.0,
        force: 100.0,
        gravity: 10.0,
    };
    let mut motion = engine.shape.motion(engine.crank).unwrap();
    motion.rod_speed *= 1.25;
    let warnings = solve(&engine.problem(&motion)).unwrap().warnings;
    let words: Vec<String> = warnings.iter().map(dalembert_core::Text::english).collect();
    assert_eq!(words.len(), 2, "{words:?}");
    assert!(words[0].starts_with("angular velocity of the rod"), "{words:?}");
    // 1.25 against 1: a difference of a fifth of the larger.
    assert!(words[0].contains("20 % of the larger)"), "{words:?}");
}

#[test]
fn a_loop_that_cannot_close_is_said() {
    let text = |crank_angle: &str, rod_angle: &str| {
        format!(
            r#"{}
[[inputs.bodies]]
name = "rod"
mass = "1 kg"
velocity = "(1; 1) m/s"
[[inputs.bodies]]
name = "slider"
mass = "1 kg"
velocity = "(-1; 0) m/s"
[inputs.slider_crank]
geometry.angles = {{ crank_angle = "{crank_angle}", rod_angle = "{rod_angle}" }}
crank_speed = "10 rad/s"
rod = "rod"
slider = "slider"
"#,
            problem("(0; -10) m/s^2", "driving-torque.link.turning = { speed = \"10 rad/s\" }")
        )
    };
    for (crank, rod) in
        [("0 deg", "0 deg"), ("30 deg", "22 deg"), ("90 deg", "-20 deg"), ("180 deg", "0 deg")]
    {
        let words = solve(&text(crank, rod)).unwrap().warnings[0].english();
        assert!(words.contains("the in-line loop does not close"), "{crank}, {rod}: {words}");
    }
    let words = solve(&text("-30 deg", "22 deg")).unwrap().warnings[0].english();
    assert!(words.contains("no crank of positive length"), "{words}");
}

#[test]
fn a_body_named_is_its_motion_written_out() {
    let with = |link: &str, point: &str| {
        let text = format!(
            r#"{}
[[inputs.bodies]]
name = "bar"
mass = "2 kg"
inertia = "0.3 kg*m^2"
velocity = "(3; -1) m/s"
acceleration = "(5; 7) m/s^2"
angular_velocity = "4 rad/s"
angular_acceleration = "-6 rad/s^2"
[[inputs.forces]]
name = "P"
force = "(10; 20) N"
point.{point}
[[inputs.couples]]
name = "C"
moment = "8 N*m"
link.{link}
"#,
            problem("(0; -10) m/s^2", &format!("driving-torque.link.{link}"))
        );
        solve(&text).unwrap().answer("torque").unwrap().si().unwrap()
    };
    let named = with("body = { body = \"bar\" }", "mass-centre = { body = \"bar\" }");
    let written = with("turning = { speed = \"4 rad/s\" }", "moving = { velocity = \"(3; -1) m/s\" }");
    assert_eq!(named.to_bits(), written.to_bits());
    // 10 + 32 + 20 − 2 (15 − 7) + 0.3 · 6 · 4 = 53.2 W over 4 rad/s.
    assert!((named + 13.3).abs() < 1e-12, "{named}");
}

#[test]
fn what_powers_cannot_tell_is_refused_in_words() {
    let load = "[[inputs.forces]]\nname = \"P\"\nforce = \"(10; 0) N\"\npoint.moving = { velocity = \"(1; 0) m/s\" }\n";
    let still = "driving-torque.link.turning = { speed = \"0 rad/s\" }";
    assert!(refusal(still, load).contains("the driven link is at rest"));
    let force = |direction: &str, velocity: &str| {
        format!(
            "driving-force = {{ direction = \"{direction}\", point = {{ moving = {{ velocity = \"{velocity}\" }} }} }}"
        )
    };
    assert!(refusal(&force("(1; 0)", "(0; 0) m/s"), load).contains("the driven point is at rest"));
    assert!(refusal(&force("(0; 0)", "(0; 1) m/s"), load).contains("no length"));
    assert!(refusal(&force("(3; -1)", "(1; 3) m/s"), load).contains("perpendicular"));
    assert!(
        refusal("driving-torque.link.turning = { speed = \"1 rad/s\" }", "").contains("no load is given")
    );
}

fn problem(gravity: &str, unknown: &str) -> String {
    format!(
        "analysis = \"virtual-work/virtual-power\"\n[inputs]\ngravity = \"{gravity}\"\nunknown.{unknown}\n"
    )
}

fn refusal(unknown: &str, loads: &str) -> String {
    match solve(&format!("{}{loads}", problem("(0; 0) m/s^2", unknown))) {
        Err(SolveError::Refused(Refusal::NoAnswer(why))) => why.english(),
        other => panic!("this was to be refused: {other:?}"),
    }
}
