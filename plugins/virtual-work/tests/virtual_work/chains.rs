//! Chains of equal four-bars that fall through their singular positions, through the analysis.

use dalembert_core::{AnswerValue, Exhibit, Number, Solution};

use crate::solved::solve;

/// `n` four-bars in a row: upright and level rods of 1 m and 1 kg, pushed over at 1 rad/s.
fn chain(n: usize) -> String {
    String::from("analysis = \"virtual-work/motion\"\n[inputs]\nduration = \"10 s\"\n")
        + &rods(n, 90)
        + "[[inputs.starts]]\nname = \"push\"\n\
           what.angle = { body = \"v0\", against = \"ground\", value = \"90 deg\", velocity = \"-1 rad/s\" }\n"
}

/// The rods and pins of `n` four-bars in a row, 1 m and 1 kg each, the upright ones drawn at an angle in degrees.
fn rods(n: usize, upright: u32) -> String {
    let mut text = String::new();
    let mut body = |name: String, angle: u32| {
        text += &format!(
            "[[inputs.bodies]]\nname = \"{name}\"\nmass = \"1 kg\"\ninertia = \"1/12 kg*m^2\"\nangle = \"{angle} deg\"\n"
        );
    };
    (0..=n).for_each(|k| body(format!("v{k}"), upright));
    (0..n).for_each(|k| body(format!("h{k}"), 0));
    let mut point = |name: String, on: &str, x: usize| {
        text += &format!(
            "[[inputs.points]]\nname = \"{name}\"\non = {on}\nat = \"({}; 0) mm\"\n",
            x as i64 - 500
        );
    };
    let on = |name: &str, k: usize| format!("{{ body = {{ body = \"{name}{k}\" }} }}");
    for k in 0..=n {
        point(format!("G{k}"), "\"ground\"", 1000 * k + 500);
        point(format!("A{k}"), &on("v", k), 0);
        point(format!("B{k}"), &on("v", k), 1000);
    }
    for k in 0..n {
        point(format!("C{k}"), &on("h", k), 0);
        point(format!("D{k}"), &on("h", k), 1000);
    }
    let mut pin = |name: String, a: String, b: String| {
        text +=
            &format!("[[inputs.joints]]\nname = \"{name}\"\njoint.pin = {{ a = \"{a}\", b = \"{b}\" }}\n");
    };
    for k in 0..=n {
        pin(format!("foot{k}"), format!("G{k}"), format!("A{k}"));
    }
    for k in 0..n {
        pin(format!("left{k}"), format!("B{k}"), format!("C{k}"));
        pin(format!("right{k}"), format!("B{}", k + 1), format!("D{k}"));
    }
    text
}

/// A driven chain keeps its plots, however many loops it has.
#[test]
fn a_driven_chain_of_many_loops_has_all_its_plots() {
    for loops in [1, 13, 20, 100] {
        let text = String::from("format = 2\nanalysis = \"virtual-work/mechanism\"\n[inputs]\n")
            + &rods(loops, 60)
            + "[[inputs.drivers]]\nname = \"crank\"\n\
               what.angle = { body = \"v0\", against = \"ground\", value = \"60 deg\", velocity = \"1 rad/s\" }\n\
               [inputs.range.angles]\nfrom = \"30 deg\"\nto = \"150 deg\"\n";
        let solution = solve(&text).unwrap_or_else(|error| panic!("{loops} loops: {error:?}"));
        let plots = solution.exhibits.iter().filter_map(|exhibit| match exhibit {
            Exhibit::Plot(plot) => Some(plot),
            _ => None,
        });
        let points: Vec<usize> = plots.map(|plot| plot.series[0].points.len()).collect();
        assert!(points.len() >= 4 && points.iter().all(|count| *count >= 100), "{loops} loops: {points:?}");
        assert!(solution.checks.iter().all(|check| check.passed), "{loops} loops");
    }
}

fn number(solution: &Solution, name: &str) -> f64 {
    let answer = solution.answers.iter().find(|answer| answer.name.to_string() == name);
    match answer.map(|answer| &answer.value) {
        Some(AnswerValue::Number(Number::Scalar(si), _)) => *si,
        other => panic!("{name} is {other:?}"),
    }
}

/// The angle of the rods after 10 s: with all of them parallel the chain is a pendulum, `θ̈ = −c cos θ`, followed by the
/// method of Runge and Kutta of order 4.
fn pendulum(n: usize) -> f64 {
    let bars = n as f64;
    let c = 9.81 * (f64::midpoint(bars, 1.0) + bars) / ((bars + 1.0) / 3.0 + bars);
    let (mut angle, mut rate) = (std::f64::consts::FRAC_PI_2, -1.0);
    let h = 1e-4;
    for _ in 0..100_000 {
        let slope = |angle: f64| -c * f64::cos(angle);
        let (k1, l1) = (rate, slope(angle));
        let (k2, l2) = (rate + h / 2.0 * l1, slope(angle + h / 2.0 * k1));
        let (k3, l3) = (rate + h / 2.0 * l2, slope(angle + h / 2.0 * k2));
        let (k4, l4) = (rate + h * l3, slope(angle + h * k3));
        angle += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
        rate += h / 6.0 * (l1 + 2.0 * l2 + 2.0 * l3 + l4);
    }
    angle
}

fn falls(n: usize) {
    let solution = solve(&chain(n)).unwrap_or_else(|error| panic!("{n} four-bars: {error:?}"));
    for check in &solution.checks {
        assert!(check.passed, "{n} four-bars: {} ({:e})", check.what.english(), check.residual);
    }
    let expected = pendulum(n);
    for body in 1..=n + 1 {
        let angle = number(&solution, &format!("angle[{body}]"));
        let off = (angle - expected) / std::f64::consts::TAU;
        assert!((off - off.round()).abs() < 2e-6, "{n} four-bars: {angle} is not {expected}");
    }
    // What the steps and, along the row, the rounding of positions let through.
    let bars = n as f64;
    let start = (bars + 1.0) / 6.0 + bars / 2.0;
    let size = 2.0 * 9.81 * (1.5 * bars + 0.5);
    let left = number(&solution, "kinetic_energy") + number(&solution, "stored_energy") - start;
    assert!(left.abs() < (3e-10 + 2e-10 * (bars + 5.0)) * size, "{n} four-bars: {left:e} J of {size} J");
}

#[test]
fn chains_of_equal_four_bars_pass_their_singular_positions() {
    (1..=20).chain([40]).for_each(falls);
}

#[test]
#[ignore = "minutes without optimisation"]
fn chains_of_up_to_a_hundred_four_bars_pass_their_singular_positions() {
    (1..=100).for_each(falls);
}
