//! Arms, bars, lifts and chains in equilibrium over many shapes: what is found one way is found again the other way,
//! and every check holds.

use std::f64::consts::FRAC_PI_2;

use dalembert_core::Solution;

use crate::solved::solve;

#[test]
fn the_load_of_an_angle_has_its_equilibrium_at_that_angle() {
    for n in 1..40 {
        let angle = 0.07 * f64::from(n);
        let arm = |mass: &str, position: &str| {
            format!(
                "analysis = \"virtual-work/spring-lever\"\n[inputs]\nreference = \"upright\"\n\
                 load.mass = {{ {mass}arm = \"0.3 m\" }}\n\
                 spring.drum = {{ stiffness = \"4 kN/m\", radius = \"80 mm\" }}\nposition.{position}\n"
            )
        };
        let there = solved(&arm("", &format!("given.angle = \"{angle} rad\"")));
        let mass = number(&there, "mass");
        let again = solved(&arm(
            &format!("mass = \"{mass:e} kg\", "),
            "sought = { from = \"0.001 rad\", to = \"3.1 rad\" }",
        ));
        // Of θ/sin θ, which grows, every value is met once: the equilibrium is stable there.
        let found = number(&again, "stable_angle[1]");
        assert!((found - angle).abs() < 1e-9, "{angle}: {found}");
        assert!(number(&there, "curvature") > 0.0 && again.answer("unstable_angle[1]").is_none());
    }
}

#[test]
fn bars_and_linkages_balance_again_where_their_load_was_found() {
    for n in 1..30 {
        let angle = FRAC_PI_2 * f64::from(n) / 30.0;
        let bar = |force: &str, position: &str| {
            format!(
                "analysis = \"virtual-work/guided-bar\"\n[inputs]\nside = \"above\"\nlength = \"2 m\"\n\
                 mass = \"12 kg\"\nforce_a = \"30 N\"\n{force}\n\
                 spring.horizontal = {{ stiffness = \"90 N/m\", distance = \"1.3 m\", free = \"50 deg\" }}\n\
                 position.{position}\n"
            )
        };
        let there = solved(&bar("", &format!("given.angle = \"{angle} rad\"")));
        let force = number(&there, "force_b");
        let held =
            solved(&bar(&format!("force_b = \"{force:e} N\""), &format!("given.angle = \"{angle} rad\"")));
        assert!(number(&held, "holding_couple").abs() < 1e-10, "{angle}");
        let around = solved(&bar(
            &format!("force_b = \"{force:e} N\""),
            &format!("sought = {{ from = \"{} rad\", to = \"{} rad\" }}", angle - 0.02, angle + 0.02),
        ));
        let kind = if number(&there, "curvature") > 0.0 { "stable_angle[1]" } else { "unstable_angle[1]" };
        assert!((number(&around, kind) - angle).abs() < 1e-9, "{angle}");
    }
}

#[test]
fn scissor_lifts_with_cylinders_anywhere_are_those_of_newton_and_euler() {
    for n in 0..48 {
        let part = |by: f64| 0.1 + 0.8 * (f64::from(n) * by).rem_euclid(1.0);
        let stages = 1 + n % 4;
        let ends = [
            format!("ground = {{ x = \"{} m\", y = \"-0.1 m\" }}", 2.0 * part(0.37)),
            format!("table = {{ x = \"{} m\", y = \"0.05 m\" }}", part(0.61)),
            format!("rising = {{ stage = {}, distance = \"{} m\" }}", 1 + n % stages, part(0.23)),
            format!("falling = {{ stage = {}, distance = \"{} m\" }}", stages, part(0.71)),
        ];
        let (lower, upper) = (&ends[(n % 3) as usize], &ends[3]);
        let lift = solved(&format!(
            "analysis = \"virtual-work/scissor-lift\"\n[inputs]\nstages = {stages}\nbar = \"1 m\"\n\
             angle = \"{} deg\"\nbar_weight = \"40 N\"\nframes = 2\nlower.{lower}\nupper.{upper}\n\
             sought.cylinder.load = \"5 kN\"\n",
            10.0 + 65.0 * part(0.47),
        ));
        assert!(!lift.checks.is_empty());
    }
}

#[test]
fn tongs_and_chains_of_any_length_hold() {
    for n in 1..=12 {
        let load = |square: u32| {
            let hinge = if square.is_multiple_of(3) { "lower" } else { "upper" };
            let force = 100.0 + 17.0 * f64::from(square);
            format!("[[inputs.loads]]\nsquare = {square}\nhinge = \"{hinge}\"\nforce = \"{force} N\"")
        };
        let loads = (1..=n).map(load).collect::<Vec<_>>().join("\n");
        let head = "analysis = \"virtual-work/lazy-tongs\"\n[inputs]\nside = \"0.4 m\"\nangle = \"35 deg\"";
        solved(&format!("{head}\nsquares = {n}\n{loads}"));
        let bar = |bar: u32| {
            let (weight, length) = (10.0 + 3.0 * f64::from(bar), 0.5 + 0.1 * f64::from(bar));
            format!("[[inputs.bars]]\nweight = \"{weight} N\"\nlength = \"{length} m\"")
        };
        let bars = (1..=n).map(bar).collect::<Vec<_>>().join("\n");
        let head = "analysis = \"virtual-work/hanging-chain\"\n[inputs]\nvertical = \"-20 N\"";
        let chain = solved(&format!("{head}\nsought.angles.force = \"35 N\"\n{bars}"));
        // The lighter the rest below, the more a bar leans.
        let angles: Vec<f64> = (1..=n).map(|bar| number(&chain, &format!("angle[{bar}]"))).collect();
        assert!(angles.windows(2).all(|pair| pair[0] < pair[1]), "{angles:?}");
    }
}

fn number(solution: &Solution, name: &str) -> f64 {
    let answer = solution.answer(name).unwrap_or_else(|| panic!("no answer {name}"));
    answer.si().unwrap_or_else(|| panic!("{name} is not a number"))
}

/// The solution of a problem, all of whose checks hold.
fn solved(text: &str) -> Solution {
    let solution = solve(text).unwrap_or_else(|error| panic!("{error:?}\n{text}"));
    let failed: Vec<_> = solution.checks.iter().filter(|check| !check.passed).collect();
    assert!(failed.is_empty(), "{failed:?}\n{text}");
    solution
}
