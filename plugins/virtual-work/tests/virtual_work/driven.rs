//! A driven mechanism is one mechanism: at every value of its driver it is the one that was drawn.

use std::f64::consts::PI;

use crate::solved::solve;
use dalembert_core::{
    AnswerValue, Draft, Exhibit, Number, Record, Solution, SolveError, Stop, cases, file, find, vary,
};

const GEARS: &str = r#"analysis = "virtual-work/mechanism"
title = "Two equal gears, a weight on a lever of the second"
[inputs]
bodies = [ { name = "first" }, { name = "second", mass = "1 kg", centre = "(100; 0) mm" } ]
points = [
 { name = "O", on = "ground", at = "(0; 0) mm" },
 { name = "Q", on = "ground", at = "(200; 0) mm" },
 { name = "o", on.body.body = "first", at = "(0; 0) mm" },
 { name = "q", on.body.body = "second", at = "(0; 0) mm" },
]
joints = [
 { name = "O", joint.pin = { a = "O", b = "o" } },
 { name = "Q", joint.pin = { a = "Q", b = "q" } },
 { name = "mesh", joint.gears = { a.body.body = "first", b.body.body = "second", carrier = "ground", size_a = 20, size_b = 20, internal = false } },
]
drivers = [ { name = "hand", what.angle = { body = "first", against = "ground", value = "0 deg" } } ]
loads = []
range = "turn"
"#;

const WHEEL: &str = r#"analysis = "virtual-work/mechanism"
title = "A wheel that rolls, with a weight at its rim"
[inputs]
bodies = [ { name = "wheel", angle = "60 deg", mass = "1 kg", centre = "(30; 0) mm" } ]
points = [
 { name = "line", on = "ground", at = "(0; 0) mm" },
 { name = "W", on.body.body = "wheel", at = "(0; 0) mm" },
]
joints = [ { name = "contact", joint.rolling = { guide = "line", centre = "W", radius = "40 mm", resting = true } } ]
drivers = [ { name = "pull", what.position = { from = "line", to = "W", value = "0 mm" } } ]
loads = []
watched = [ { point = "W" } ]
range = { lengths = { from = "-60 mm", to = "100 mm" } }
"#;

const CORD: &str = r#"analysis = "virtual-work/mechanism"
title = "A bar that lifts a weight by a cord over a pulley"
[inputs]
bodies = [ { name = "bar", angle = "20 deg" }, { name = "weight", mass = "10 kg" } ]
points = [
 { name = "O", on = "ground", at = "(0; 0) mm" },
 { name = "pulley", on = "ground", at = "(0; 400) mm" },
 { name = "guide", on = "ground", at = "(0; 0) mm" },
 { name = "O1", on.body.body = "bar", at = "(0; 0) mm" },
 { name = "end", on.body.body = "bar", at = "(300; 0) mm" },
 { name = "hook", on.body.body = "weight", at = "(0; 0) mm" },
]
joints = [
 { name = "O", joint.pin = { a = "O", b = "O1" } },
 { name = "guide", joint.slider = { guide = "guide", direction = "90 deg", slides = "hook", angle = "-90 deg" } },
 { name = "cord", joint.cord = { runs = [ { from = "end", to = "pulley" }, { from = "pulley", to = "hook" } ] } },
]
drivers = [{ name = "hand", what.angle = { body = "bar", against = "ground", value = "20 deg" } }]
loads = []
watched = [ { point = "hook" } ]
range = { angles = { from = "-30 deg", to = "60 deg" } }
"#;

const JANSEN: &str = r#"analysis = "virtual-work/mechanism"
title = "Theo Jansen leg"
[inputs]
bodies = [
 { name = "crank", angle = "30 deg" },
 { name = "upper", angle = "90 deg" },
 { name = "lower", angle = "200 deg" },
]
points = [
 { name = "O", on = "ground", at = "(0; 0) mm" },
 { name = "B", on = "ground", at = "(-38; -7.8) mm" },
 { name = "O2", on.body.body = "crank", at = "(0; 0) mm" },
 { name = "A", on.body.body = "crank", at = "(15; 0) mm" },
 { name = "B3", on.body.body = "upper", at = "(0; 0) mm" },
 { name = "C", on.body.body = "upper", at = "(41.5; 0) mm" },
 { name = "E", on.body.body = "upper", at = "(2.60988; 40.014979) mm" },
 { name = "D", on.body.body = "lower", at = "(0; 0) mm" },
 { name = "F", on.body.body = "lower", at = "(36.7; 0) mm" },
 { name = "G", on.body.body = "lower", at = "(-7.746594; 48.383781) mm" },
]
joints = [
 { name = "O", joint.pin = { a = "O", b = "O2" } },
 { name = "B", joint.pin = { a = "B", b = "B3" } },
 { name = "j", joint.rod = { from = "A", to = "C", length = "50 mm" } },
 { name = "k", joint.rod = { from = "A", to = "D", length = "61.9 mm" } },
 { name = "c", joint.rod = { from = "B", to = "D", length = "39.3 mm" } },
 { name = "f", joint.rod = { from = "E", to = "F", length = "39.4 mm" } },
]
drivers = [{ name = "motor", what.angle = { body = "crank", against = "ground", value = "30 deg", velocity = "10 rad/s" } }]
loads = [{ name = "foot", load.force = { at = "G", force = "(-3; 20) N", axes = "ground" } }]
watched = [ { point = "G" } ]
range = "turn"
"#;

const PEAUCELLIER: &str = r#"analysis = "virtual-work/mechanism"
title = "Peaucellier's inversor"
[inputs]
bodies = [
 { name = "crank", angle = "40 deg" },
 { name = "upper arm", angle = "52 deg" },
 { name = "lower arm", angle = "-12 deg" },
 { name = "link", angle = "-42 deg" },
]
points = [
 { name = "C", on = "ground", at = "(30; 0) mm" },
 { name = "O", on = "ground", at = "(0; 0) mm" },
 { name = "C1", on.body.body = "crank", at = "(0; 0) mm" },
 { name = "B", on.body.body = "crank", at = "(30; 0) mm" },
 { name = "O2", on.body.body = "upper arm", at = "(0; 0) mm" },
 { name = "D", on.body.body = "upper arm", at = "(100; 0) mm" },
 { name = "O3", on.body.body = "lower arm", at = "(0; 0) mm" },
 { name = "E", on.body.body = "lower arm", at = "(100; 0) mm" },
 { name = "D4", on.body.body = "link", at = "(0; 0) mm" },
 { name = "P", on.body.body = "link", at = "(60; 0) mm" },
]
joints = [
 { name = "C", joint.pin = { a = "C", b = "C1" } },
 { name = "O upper", joint.pin = { a = "O", b = "O2" } },
 { name = "O lower", joint.pin = { a = "O", b = "O3" } },
 { name = "D", joint.pin = { a = "D", b = "D4" } },
 { name = "BD", joint.rod = { from = "B", to = "D", length = "60 mm" } },
 { name = "BE", joint.rod = { from = "B", to = "E", length = "60 mm" } },
 { name = "PE", joint.rod = { from = "P", to = "E", length = "60 mm" } },
]
drivers = [{ name = "motor", what.angle = { body = "crank", against = "ground", value = "40 deg" } }]
loads = []
watched = [ { point = "P" } ]
range = { angles = { from = "-90 deg", to = "90 deg" } }
"#;

const WHITWORTH: &str = r#"analysis = "virtual-work/mechanism"
title = "Whitworth's quick return"
[inputs]
bodies = [
 { name = "crank", angle = "60 deg" },
 { name = "arm", angle = "70 deg" },
 { name = "ram", mass = "12 kg", place = "(160; -20) mm" },
]
points = [
 { name = "O", on = "ground", at = "(0; 0) mm" },
 { name = "Q", on = "ground", at = "(0; -30) mm" },
 { name = "guide", on = "ground", at = "(0; -20) mm" },
 { name = "O1", on.body.body = "crank", at = "(0; 0) mm" },
 { name = "A", on.body.body = "crank", at = "(50; 0) mm" },
 { name = "Q2", on.body.body = "arm", at = "(0; 0) mm" },
 { name = "S", on.body.body = "arm", at = "(40; 0) mm" },
 { name = "R", on.body.body = "ram", at = "(0; 0) mm" },
]
joints = [
 { name = "O", joint.pin = { a = "O", b = "O1" } },
 { name = "Q", joint.pin = { a = "Q", b = "Q2" } },
 { name = "slot", joint.slot = { guide = "Q2", pin = "A" } },
 { name = "bed", joint.slider = { guide = "guide", slides = "R" } },
 { name = "rod", joint.rod = { from = "S", to = "R", length = "150 mm" } },
]
drivers = [{ name = "motor", what.angle = { body = "crank", against = "ground", value = "60 deg", velocity = "10 rad/s" } }]
loads = []
watched = [ { point = "R" } ]
range = "turn"
"#;

/// The problem with its only driver at another value, in degrees or millimetres.
fn at(text: &str, value: f64) -> Solution {
    let record = record(text);
    let moved = moved(&record, value);
    let entry = find("virtual-work/mechanism").expect("it is registered");
    let solution = entry.solve(&moved, &Stop::new()).unwrap_or_else(|error| panic!("at {value}: {error}"));
    let failed: Vec<_> = solution.checks.iter().filter(|check| !check.passed).collect();
    assert!(failed.is_empty(), "at {value}: {failed:?}");
    solution
}

fn record(text: &str) -> Record {
    let problem = file::parse(text).unwrap_or_else(|errors| panic!("{errors:?}"));
    problem.draft.read(&problem.entry.shape()).unwrap_or_else(|errors| panic!("{errors:?}"))
}

/// The record with another value of its first driver, in SI.
fn moved(record: &Record, si: f64) -> Record {
    let value = vary::inputs(record).into_iter().find(|input| {
        input.path.starts_with("drivers[1].what.") && input.path.rsplit('.').next() == Some("value")
    });
    vary::changed(record, &value.expect("a driver has a value").path, si)
        .expect("the path is that of an input")
}

fn scalar(solution: &Solution, name: &str) -> f64 {
    match solution.answer(name).unwrap_or_else(|| panic!("no {name}")).value {
        AnswerValue::Number(Number::Scalar(si), _) => si,
        ref other => panic!("{name} is {other:?}"),
    }
}

fn point(solution: &Solution) -> [f64; 2] {
    match solution.answer("position[1]").expect("a point is watched").value {
        AnswerValue::Number(Number::Vector([x, y, _]), _) => [x, y],
        ref other => panic!("{other:?}"),
    }
}

#[track_caller]
fn close(found: f64, wanted: f64, within: f64) {
    assert!((found - wanted).abs() <= within, "{found} and not {wanted}");
}

/// Two equal gears: the second turns back by as much as the first goes on, and carries its weight with it.
#[test]
fn gears_stay_in_the_mesh_in_which_they_are_drawn() {
    for degrees in [0.0f64, 30.0, 60.0, 90.0, 200.0, -75.0] {
        let angle = degrees.to_radians();
        let solution = at(GEARS, angle);
        close(scalar(&solution, "angle[2]"), -angle, 1e-12);
        close(scalar(&solution, "effort[1]"), -0.981 * angle.cos(), 1e-12);
    }
}

#[test]
fn a_wheel_rolls_from_where_it_is_drawn() {
    for travel in [-0.06, 0.0, 0.02, 0.1] {
        let angle = 60f64.to_radians() - travel / 0.04;
        let solution = at(WHEEL, travel);
        close(scalar(&solution, "angle[1]"), angle, 1e-12);
        // The weight turns about the contact: its height is r + e sin θ, with dθ/ds = −1/r.
        close(scalar(&solution, "effort[1]"), -9.81 * 0.03 * angle.cos() / 0.04, 1e-10);
    }
}

#[test]
fn a_cord_keeps_the_length_with_which_it_is_drawn() {
    let run = |degrees: f64| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        (0.3 * cos).hypot(0.4 - 0.3 * sin)
    };
    let height = |degrees: f64| point(&at(CORD, degrees.to_radians()))[1];
    let drawn = height(20.0);
    for degrees in [-30.0, 0.0, 40.0, 60.0] {
        close(height(degrees) - drawn, run(degrees) - run(20.0), 1e-12);
    }
}

/// Positions by closing the loops of pylinkage's order by hand, to the hundredth of a millimetre.
#[test]
fn a_leg_of_jansen_stays_on_the_assembly_that_is_drawn() {
    for (degrees, [x, y]) in [(30.0f64, [-30.806, -91.823]), (200.0, [-47.42, -71.18])] {
        let [px, py] = point(&at(JANSEN, degrees.to_radians()));
        close(px * 1e3, x, 0.006);
        close(py * 1e3, y, 0.006);
    }
}

/// The tracing point of Peaucellier's inversor runs on the line `x = (a² − b²)/(2 c)`, at `y = x tan(θ/2)`.
#[test]
fn peaucellier_draws_his_line_over_his_whole_range() {
    let line = (0.1f64.powi(2) - 0.06f64.powi(2)) / 0.06;
    for step in 0..=24 {
        let angle = (-90.0 + 7.5 * f64::from(step)).to_radians();
        let [x, y] = point(&at(PEAUCELLIER, angle));
        close(x, line, 1e-12);
        close(y, line * (angle / 2.0).tan(), 1e-12);
    }
}

#[test]
fn a_quick_return_of_whitworth_follows_its_closed_form() {
    for step in 0..25 {
        let angle = PI / 3.0 + 2.0 * PI * f64::from(step) / 25.0;
        let arm = (0.05 * angle.sin() + 0.03).atan2(0.05 * angle.cos());
        let [sx, sy] = [0.04 * arm.cos(), 0.04 * arm.sin() - 0.03];
        let ram = sx + (0.15f64.powi(2) - (sy + 0.02).powi(2)).sqrt();
        close(point(&at(WHITWORTH, angle))[0], ram, 1e-12);
    }
}

/// The place at which a body is drawn settles on which side it is assembled.
#[test]
fn a_body_is_assembled_on_the_side_where_it_is_drawn() {
    let other_side = WHITWORTH.replace("(160; -20)", "(-160; -20)");
    let angle = PI / 3.0;
    let arm = (0.05 * angle.sin() + 0.03).atan2(0.05 * angle.cos());
    let [sx, sy] = [0.04 * arm.cos(), 0.04 * arm.sin() - 0.03];
    let reach = (0.15f64.powi(2) - (sy + 0.02).powi(2)).sqrt();
    close(point(&at(WHITWORTH, angle))[0], sx + reach, 1e-12);
    close(point(&at(&other_side, angle))[0], sx - reach, 1e-12);
}

/// Without a place the ram closes on either side: that is said.
#[test]
fn a_slider_that_closes_on_two_sides_is_named() {
    let says = |solution: &Solution| {
        solution.warnings.iter().any(|warning| warning.english().contains("give the position of ram"))
    };
    assert!(says(&at(&WHITWORTH.replace(", place = \"(160; -20) mm\"", ""), PI / 3.0)));
    assert!(!says(&at(WHITWORTH, PI / 3.0)));
}

/// The weight at the end of a cord may hang anywhere: its place is asked for.
#[test]
fn a_place_that_does_not_follow_is_asked_for() {
    let asks = |solution: &Solution| {
        solution.warnings.iter().any(|warning| warning.english().contains("give the position of weight"))
    };
    assert!(asks(&at(CORD, 20f64.to_radians())));
    let placed = CORD.replace("mass = \"10 kg\"", "mass = \"10 kg\", place = \"(0; 100) mm\"");
    let solution = at(&placed, 20f64.to_radians());
    assert!(!asks(&solution));
    close(point(&solution)[1], 0.1, 1e-12);
}

/// A block on a spring moves as it does because of where it was released: without its place there is no motion.
#[test]
fn a_block_that_nothing_places_is_refused() {
    let block = r#"format = 2
analysis = "virtual-work/motion"
[inputs]
bodies = [ { name = "block", mass = "1 kg" } ]
points = [
 { name = "wall", on = "ground", at = "(0; 0) mm" },
 { name = "hook", on.body.body = "block", at = "(0; 0) mm" },
]
joints = [ { name = "guide", joint.slider = { guide = "wall", direction = "0 deg", slides = "hook", angle = "0 deg" } } ]
loads = [ { name = "spring", load.spring = { from = "wall", to = "hook", stiffness = "100 N/m", free = "100 mm" } } ]
watched = [ { point = "hook" } ]
duration = "1 s"
"#;
    let why = solve(block).unwrap_err().to_string();
    assert!(why.contains("do not determine the position of block"), "{why}");
    let placed = block.replace("mass = \"1 kg\"", "mass = \"1 kg\", place = \"(150; 0) mm\"");
    // At 10 rad/s from 50 mm beyond the free length.
    let solution = solve(&placed).unwrap();
    close(point(&solution)[0], 0.1 + 0.05 * 10f64.cos(), 1e-9);
}

/// A range that the mechanism cannot reach is reported with the position where it ends.
#[test]
fn a_range_that_is_cut_short_is_reported() {
    let wide = PEAUCELLIER.replace("\"90 deg\"", "\"170 deg\"");
    let solution = at(&wide, 40f64.to_radians());
    let said: Vec<String> = solution.warnings.iter().map(dalembert_core::Text::english).collect();
    // The arms are in line with the sides where the crank pin is farthest: cos(θ/2) = (a − b)/(2 c).
    assert!(said.iter().any(|text| text.contains("the plots end at 96.3")), "{said:?}");
}

/// A plot over the first driver agrees with a solve at each of its values.
#[test]
fn a_sweep_is_the_direct_solve_at_each_of_its_values() {
    let entry = find("virtual-work/mechanism").expect("it is registered");
    let published = cases::cases(entry).unwrap().into_iter().filter_map(|case| case.record(entry).ok());
    let own = [GEARS, JANSEN, PEAUCELLIER, WHITWORTH, WHEEL, CORD].map(record);
    let mut compared = 0;
    for record in published.chain(own) {
        let Ok(solution) = entry.solve(&record, &Stop::new()) else { continue };
        for exhibit in &solution.exhibits {
            let Exhibit::Plot(plot) = exhibit else { continue };
            let name = match plot.title.english().as_str() {
                "Angular velocities" => "angular_velocity",
                title if title.starts_with("Driving force or torque of ") => "effort",
                _ => continue,
            };
            let largest = plot
                .series
                .iter()
                .flat_map(|series| &series.points)
                .map(|at| at.1.abs())
                .fold(1e-9, f64::max);
            let count = plot.series[0].points.len();
            for pick in 0..25 {
                let n = pick * (count - 1) / 24;
                let direct = match entry.solve(&moved(&record, plot.series[0].points[n].0), &Stop::new()) {
                    Ok(direct) => direct,
                    // The ends of a range may be dead centres.
                    Err(SolveError::Refused(_)) if n == 0 || n == count - 1 => continue,
                    Err(error) => {
                        panic!("{} at {}: {error}", plot.title.english(), plot.series[0].points[n].0)
                    }
                };
                for (row, series) in (1..).zip(&plot.series) {
                    let row =
                        if name == "effort" { effort_row(&solution, &plot.title.english()) } else { row };
                    let wanted = scalar(&direct, &format!("{name}[{row}]"));
                    let (x, found) = series.points[n];
                    let off = (found - wanted).abs() / largest;
                    assert!(off <= 1e-9, "{}, at {x}: {found} and directly {wanted}", plot.title.english());
                    compared += 1;
                }
            }
        }
    }
    assert!(compared > 1000, "{compared} values compared");
}

/// The row of the driver that a plot is named after.
fn effort_row(solution: &Solution, title: &str) -> usize {
    let name = title.trim_start_matches("Driving force or torque of ");
    let efforts = solution.answers.iter().filter(|answer| answer.name.to_string().starts_with("effort["));
    efforts.into_iter().position(|answer| answer.row_label == name).map_or(1, |at| at + 1)
}

/// Changing the value of a driver writes the old one beside it, once.
#[test]
fn the_first_change_of_a_driver_keeps_what_was_drawn() {
    let problem = file::parse(GEARS).unwrap();
    let shape = problem.entry.shape();
    let value = "drivers[1].what.angle.value";
    let change = |draft: &mut Draft, text: &str| {
        let before = draft.clone();
        draft.set(&shape, value, text).unwrap();
        draft.keep_first(&before, &shape);
    };
    let drawn = |draft: &Draft| draft.at(&shape, "drivers[1].what.angle.drawn").unwrap().0.clone();
    let mut draft = problem.draft.clone();
    assert_eq!(drawn(&draft), Draft::Absent);
    change(&mut draft, "30 deg");
    assert_eq!(drawn(&draft), Draft::Leaf("0 deg".into()));
    change(&mut draft, "60 deg");
    assert_eq!(drawn(&draft), Draft::Leaf("0 deg".into()));
    let solution = problem.entry.solve(&draft.read(&shape).unwrap(), &Stop::new()).unwrap();
    close(scalar(&solution, "effort[1]"), -0.4905, 1e-12);
}
