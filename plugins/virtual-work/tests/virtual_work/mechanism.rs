//! Results of the plane mechanism for its cases, compared with the templates and with statics.

use dalembert_core::{
    AnswerValue, Exhibit, Locale, Number, Plot, Solution, Stop, TableExhibit, cases, exhibit::Cell, find,
};
use itertools::zip_eq;

use crate::solved::solve;

/// Crank of 50 mm at 120°, massless; the coupler and the rocker have mass.
fn mechanism() -> Solution {
    case("Four-bar linkage with massive coupler and rocker")
}

fn case(name: &str) -> Solution {
    let entry = find("virtual-work/mechanism").expect("it is registered");
    let cases = cases::cases(entry).expect("they can be read");
    let case = cases.iter().find(|case| case.name == name).expect("there is such a case");
    entry.solve(&case.record(entry).expect("it can be read"), &Stop::new()).expect("it has an answer")
}

fn template() -> Solution {
    solve(
        r#"
analysis = "virtual-work/four-bar"

[inputs]
crank = "50 mm"
coupler = "151 mm"
rocker = "111 mm"
frame = "100 mm"
closing = "open"
angle = "120 deg"
unknown.torque.load = "0 N*m"
speed = "95 rad/s"
coupler_mass.given = { mass = "0.5 kg", distance = "75.5 mm", inertia = "0.00121 kg*m^2" }
rocker_mass.given = { mass = "0.4 kg", distance = "55.5 mm", inertia = "0.00091 kg*m^2" }
gravity = "(0; 0) m/s^2"
"#,
    )
    .expect("it has an answer")
}

#[test]
fn the_centre_of_crank_and_rocker_is_where_the_template_finds_it() {
    let solution = mechanism();
    let centres = table(&solution, "Instant centres");
    assert_eq!(centres.rows.len(), 6);
    let [x, y] = numbers(row(centres, &["crank and rocker"]))[..] else { panic!("it is a point") };
    close(x, answer(&template(), "instant_centre_24"), 1e-10);
    close(y, 0.0, 1e-12);
    let [x, y] = numbers(row(centres, &["crank and coupler"]))[..] else { panic!("it is a point") };
    close(x, -0.025, 1e-12);
    close(y, 0.05 * 120f64.to_radians().sin(), 1e-12);
}

#[test]
fn the_force_across_the_massless_crank_is_its_torque_over_its_length() {
    let solution = mechanism();
    let axes = table(&solution, "Reaction of each joint on each body, in body axes");
    let [along, across, size] = numbers(row(axes, &["pin A", "crank"]))[..] else { panic!("three forces") };
    close(across, -answer(&solution, "effort[1]") / 0.05, 1e-8);
    close(size, answer(&template(), "crank_pin_force"), 1e-8);
    // What the other pin does to the crank is equal and opposite along it, and across it too.
    let other = numbers(row(axes, &["pin O", "crank"]));
    close(other[0], -along, 1e-8);
    close(other[1], -across, 1e-8);
}

#[test]
fn a_wheel_at_rest_on_the_floor_is_held_by_friction_and_by_the_floor() {
    let solution = case("Disc rolled by a crank against spring and damper");
    let joints = table(&solution, "Reaction of each joint on its second point");
    let [friction, normal, size, ..] = numbers(row(joints, &["rolling"]))[..] else { panic!("forces") };
    close(friction, 4.58006, 1e-6);
    close(size, friction.hypot(normal), 1e-12);
    close(size, answer(&solution, "reaction[4]"), 1e-12);
}

#[test]
fn the_ground_takes_the_forces_of_its_two_pins() {
    let solution = mechanism();
    let pins = plot(&solution, "Forces of the pins, in the axes of the ground");
    let names: Vec<String> =
        pins.series.iter().map(|series| series.label.render(&Locale::english())).collect();
    assert_eq!(names, ["pin O on the ground", "pin C on the ground", "pin A on coupler", "pin B on rocker"]);
    let (x, y) = pins.series[0].points[0];
    close(x.hypot(y), answer(&solution, "reaction[1]"), 1e-8);
    let shaking = &plot(&solution, "Shaking force: resultant force on the ground").series[0].points;
    assert!(shaking.len() > 100);
    for (n, &(x, y)) in shaking.iter().enumerate() {
        let [(ox, oy), (cx, cy)] = [0, 1].map(|pin: usize| pins.series[pin].points[n]);
        close(x, ox + cx, 1e-8);
        close(y, oy + cy, 1e-8);
    }
}

fn table<'s>(solution: &'s Solution, title: &str) -> &'s TableExhibit {
    let tables = solution.exhibits.iter().filter_map(|exhibit| match exhibit {
        Exhibit::Table(table) => Some(table),
        _ => None,
    });
    tables.into_iter().find(|table| table.title.english() == title).expect("the table is shown")
}

fn plot<'s>(solution: &'s Solution, title: &str) -> &'s Plot {
    let plots = solution.exhibits.iter().filter_map(|exhibit| match exhibit {
        Exhibit::Plot(plot) => Some(plot),
        _ => None,
    });
    plots.into_iter().find(|plot| plot.title.english() == title).expect("the plot is shown")
}

/// The row that begins with these words.
fn row<'t>(table: &'t TableExhibit, words: &[&str]) -> &'t [Cell] {
    let begins = |row: &&Vec<Cell>| {
        let first = row.get(..words.len());
        first.is_some_and(|first| {
            zip_eq(first, words).all(|(cell, word)| match cell {
                Cell::Text(text) => text.english() == *word,
                _ => false,
            })
        })
    };
    table.rows.iter().find(begins).expect("the row is there")
}

fn numbers(row: &[Cell]) -> Vec<f64> {
    let number = |cell: &Cell| match cell {
        Cell::Number(si) => Some(*si),
        _ => None,
    };
    row.iter().filter_map(number).collect()
}

fn answer(solution: &Solution, name: &str) -> f64 {
    let answer = solution.answers.iter().find(|answer| answer.name.to_string() == name);
    match answer.expect("it is answered").value {
        AnswerValue::Number(Number::Scalar(si), _) => si,
        _ => panic!("{name} is not a number"),
    }
}

#[track_caller]
fn close(computed: f64, expected: f64, relative: f64) {
    let size = computed.abs().max(expected.abs()).max(1e-3);
    assert!((computed - expected).abs() <= relative * size, "{computed} is not {expected}");
}
