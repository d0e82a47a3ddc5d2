//! Templates of mechanisms with random numbers: every effort, motion and reaction in its two ways.

use dalembert_core::{Refusal, SolveError};

use crate::solved::solve;

/// Numbers without pattern, the same in every run.
struct Random(u64);

impl Random {
    /// A number between two others.
    fn between(&mut self, from: f64, to: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        from + (to - from) * (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    /// One of several words.
    fn one<'a>(&mut self, words: &[&'a str]) -> &'a str {
        words[self.between(0.0, words.len() as f64) as usize]
    }

    fn length(&mut self, from: f64, to: f64) -> String {
        format!("\"{} mm\"", self.between(from, to))
    }

    fn vector(&mut self, size: f64, unit: &str) -> String {
        format!("\"({}; {}) {unit}\"", self.between(-size, size), self.between(-size, size))
    }

    fn mass(&mut self, name: &str) -> String {
        if self.between(0.0, 1.0) < 0.4 {
            return format!("{name}.uniform.mass = \"{} kg\"\n", self.between(0.0, 5.0));
        }
        let (mass, inertia) = (self.between(0.1, 5.0), self.between(0.0, 0.05));
        let (distance, offset) = (self.between(-50.0, 150.0), self.between(-180.0, 180.0));
        format!(
            "{name}.given = {{ mass = \"{mass} kg\", distance = \"{distance} mm\", offset = \"{offset} deg\", inertia = \"{inertia} kg*m^2\" }}\n"
        )
    }

    /// Angle, motion and gravity of a mechanism with one crank.
    fn crank(&mut self) -> String {
        let (angle, speed) = (self.between(-180.0, 180.0), self.between(-30.0, 30.0));
        let acceleration = self.between(-100.0, 100.0);
        let gravity = self.vector(10.0, "m/s^2");
        format!(
            "angle = \"{angle} deg\"\nspeed = \"{speed} rad/s\"\nacceleration = \"{acceleration} rad/s^2\"\ngravity = {gravity}\n"
        )
    }
}

#[test]
fn slider_cranks() {
    held("slider-crank", 60, |r| {
        let unknown = match r.one(&["torque", "force"]) {
            "torque" => format!("unknown.torque.force = \"{} N\"\n", r.between(-3000.0, 3000.0)),
            _ => format!("unknown.force.torque = \"{} N*m\"\n", r.between(-200.0, 200.0)),
        };
        let lengths = format!(
            "crank = {}\nrod = {}\noffset = {}\npin_force = {}\nslider_mass = \"{} kg\"\n",
            r.length(50.0, 100.0),
            r.length(150.0, 400.0),
            r.length(-60.0, 60.0),
            r.vector(500.0, "N"),
            r.between(0.0, 4.0),
        );
        lengths + &unknown + &r.crank() + &r.mass("crank_mass") + &r.mass("rod_mass")
    });
}

#[test]
fn four_bars() {
    held("four-bar", 40, |r| {
        let unknown = match r.one(&["torque", "load"]) {
            "torque" => format!("unknown.torque.load = \"{} N*m\"\n", r.between(-50.0, 50.0)),
            _ => format!("unknown.load.torque = \"{} N*m\"\n", r.between(-50.0, 50.0)),
        };
        let (along, across) = (r.length(-50.0, 200.0), r.length(-80.0, 80.0));
        let force = r.vector(300.0, "N");
        let point = format!("point = {{ along = {along}, across = {across}, force = {force} }}\n");
        four(r)
            + &unknown
            + &point
            + &r.crank()
            + &r.mass("crank_mass")
            + &r.mass("coupler_mass")
            + &r.mass("rocker_mass")
    });
}

#[test]
fn quick_returns() {
    held("quick-return", 40, |r| {
        let unknown = match r.one(&["torque", "force"]) {
            "torque" => format!("unknown.torque.force = \"{} N\"\n", r.between(-800.0, 800.0)),
            _ => format!("unknown.force.torque = \"{} N*m\"\n", r.between(-50.0, 50.0)),
        };
        let lengths = format!(
            "crank = {}\nframe = {}\nlever = {}\n",
            r.length(60.0, 140.0),
            r.length(80.0, 260.0),
            r.length(300.0, 500.0)
        );
        let output = match r.one(&["lever", "slider"]) {
            "lever" => "output = \"lever\"\n".to_owned(),
            _ => format!(
                "output.slider = {{ link = {}, height = {}, side = \"{}\", slider_mass = \"{} kg\" }}\n",
                r.length(300.0, 500.0),
                r.length(200.0, 400.0),
                r.one(&["ahead", "behind"]),
                r.between(0.0, 5.0)
            ),
        };
        lengths + &output + &unknown + &r.crank() + &r.mass("crank_mass") + &r.mass("lever_mass")
    });
}

#[test]
fn six_bars() {
    held("six-bar", 20, |r| {
        let slider = r.one(&["slider", "rocker"]) == "slider";
        let output = if slider {
            format!(
                "output.slider = {{ through = {}, direction = \"{} deg\", side = \"{}\", mass = \"{} kg\" }}\n",
                r.vector(80.0, "mm"),
                r.between(-180.0, 180.0),
                r.one(&["ahead", "behind"]),
                r.between(0.0, 5.0)
            )
        } else {
            format!(
                "output.rocker.pivot = {}\noutput.rocker.length = {}\noutput.rocker.closing = \"{}\"\n",
                r.vector(400.0, "mm"),
                r.length(150.0, 300.0),
                r.one(&["open", "crossed"])
            ) + &r.mass("output.rocker.mass")
        };
        let load = match (r.one(&["known", "unknown"]), slider) {
            ("known", true) => format!("load.force.force = \"{} N\"\n", r.between(-900.0, 900.0)),
            ("known", false) => format!("load.torque.torque = \"{} N*m\"\n", r.between(-90.0, 90.0)),
            _ => format!("load.unknown.torque = \"{} N*m\"\n", r.between(-90.0, 90.0)),
        };
        let attached = format!(
            "attached.{} = {{ along = {}, across = {} }}\nlink = {}\n",
            r.one(&["rocker", "coupler"]),
            r.length(20.0, 150.0),
            r.length(-40.0, 40.0),
            r.length(200.0, 400.0)
        );
        four(r) + &attached + &output + &load + &r.crank() + &r.mass("coupler_mass") + &r.mass("link_mass")
    });
}

#[test]
fn swinging_cylinders() {
    held("oscillating-cylinder", 60, |r| {
        let unknown = match r.one(&["torque", "force"]) {
            "torque" => format!("unknown.torque.force = \"{} N\"\n", r.between(-800.0, 800.0)),
            _ => format!("unknown.force.torque = \"{} N*m\"\n", r.between(-50.0, 50.0)),
        };
        let part = |r: &mut Random, name: &str| {
            let (mass, inertia) = (r.between(0.1, 4.0), r.between(0.0, 0.05));
            let distance = r.length(0.0, 150.0);
            format!(
                "{name} = {{ mass = \"{mass} kg\", distance = {distance}, inertia = \"{inertia} kg*m^2\" }}\n"
            )
        };
        let lengths = format!("crank = {}\npivot = {}\n", r.length(50.0, 100.0), r.vector(300.0, "mm"));
        let parts = part(r, "piston") + &part(r, "cylinder");
        lengths + &unknown + &parts + &r.crank() + &r.mass("crank_mass")
    });
}

#[test]
fn five_bars() {
    held("five-bar", 40, |r| {
        let lengths = format!(
            "first_crank = {}\nfirst_rod = {}\nsecond_rod = {}\nsecond_crank = {}\nframe = {}\napex = \"{}\"\n",
            r.length(40.0, 90.0),
            r.length(150.0, 250.0),
            r.length(150.0, 250.0),
            r.length(40.0, 90.0),
            r.length(50.0, 150.0),
            r.one(&["left", "right"])
        );
        let (one, two) = (r.between(-180.0, 180.0), r.between(-180.0, 180.0));
        let cranks = match r.one(&["free", "geared"]) {
            "free" => "cranks = \"free\"\n".to_owned(),
            _ => format!(
                "cranks.geared = {{ first = \"{:.0}\", second = \"{:.0}\", mesh = \"{}\" }}\n",
                r.between(15.0, 60.0),
                r.between(15.0, 60.0),
                r.one(&["outside", "same"])
            ),
        };
        let force = r.vector(100.0, "N");
        format!(
            "{lengths}first_angle = \"{one} deg\"\nsecond_angle = \"{two} deg\"\n{cranks}unknown.torques.force = {force}\n"
        )
    });
}

/// The lengths and the closing of a four-bar.
fn four(r: &mut Random) -> String {
    format!(
        "crank = {}\ncoupler = {}\nrocker = {}\nframe = {}\nclosing = \"{}\"\n",
        r.length(60.0, 120.0),
        r.length(150.0, 250.0),
        r.length(120.0, 200.0),
        r.length(150.0, 250.0),
        r.one(&["open", "crossed"])
    )
}

/// Solves random problems: each must be answered with all its checks, or refused in words; most must be answered.
fn held(name: &str, times: usize, inputs: impl Fn(&mut Random) -> String) {
    let mut random = Random(20_260_611);
    let mut answered = 0;
    for _ in 0..times {
        let text = format!("analysis = \"virtual-work/{name}\"\n\n[inputs]\n{}", inputs(&mut random));
        match solve(&text) {
            Ok(solution) => {
                answered += 1;
                assert!(solution.defects.is_empty(), "{:?}\n{text}", solution.defects);
                for check in &solution.checks {
                    assert!(check.passed, "{} ({:e})\n{text}", check.what.english(), check.residual);
                }
            }
            Err(SolveError::Refused(Refusal::NoAnswer(_))) => {}
            Err(other) => panic!("{other:?}\n{text}"),
        }
    }
    assert!(answered * 3 >= times, "only {answered} of {times} {name} problems have an answer");
}
