//! Drawings of every analysis: marks at their stated values, texts that overlap nothing, scenes from every side.

use itertools::Itertools as _;
use std::f64::consts::{FRAC_PI_2, PI};

use dalembert_core::{Exhibit, Stop, Viewpoint3, cases, exhibit::Cell, registry};
use dalembert_plugins as _;
use dalembert_testkit::{exhibits, letters};
use dalembert_tests::person::Person;
use dalembert_tui::panes;

#[test]
fn every_mark_equals_an_answer_or_a_point_of_a_curve() {
    let seen = exhibits::every_mark_equals_an_answer_or_a_point_of_a_curve(registry());
    assert!(seen > 50, "{seen} marks");
}

/// Symbols that no drawing shows, by families.
const LISTED: [&str; 4] = [
    include_str!("drawings/balancing.txt"),
    include_str!("drawings/rigid-body.txt"),
    include_str!("drawings/vibration.txt"),
    include_str!("drawings/virtual-work.txt"),
];

#[test]
fn every_symbol_of_the_form_stands_in_a_drawing() {
    let (labelled, listed) = letters::every_symbol_of_the_form_stands_in_a_drawing(registry(), &LISTED);
    println!("{labelled} symbols are labelled, {listed} are listed");
    assert!(labelled > 175, "{labelled} symbols are labelled, {listed} are listed");
}

#[test]
fn words_of_drawings_stand_over_no_other_words_and_over_no_head_of_an_arrow() {
    let (placed, listed) =
        exhibits::words_of_drawings_stand_over_no_other_words_and_over_no_head_of_an_arrow(registry());
    println!("{placed} words have a place, {listed} are listed");
    assert!(placed > 100 * listed, "{placed} words have a place, {listed} are listed");
}

#[test]
fn words_of_figures_stand_over_no_other_words() {
    exhibits::words_of_figures_stand_over_no_other_words(registry());
}

/// The link of a four-bar linkage meets the rocker at the angle of their triangle over the diagonal.
#[test]
fn the_transmission_angle_of_any_mechanism_is_that_of_the_four_bar() {
    let entry = dalembert_core::find("virtual-work/mechanism").expect("it is registered");
    let record = cases::first(entry).expect("it has a case").record(entry).expect("the case can be read");
    let solution = entry.solve(&record, &Stop::new()).expect("the case has a solution");
    let table = solution.exhibits.iter().find_map(|exhibit| match exhibit {
        Exhibit::Table(table) if table.title.english().starts_with("Transmission angles") => Some(table),
        _ => None,
    });
    let row = &table.unwrap().rows[1];
    let [crank, coupler, rocker, frame] = [50.0_f64, 151.0, 111.0, 100.0];
    let angle = |crank_angle: f64| {
        let diagonal = crank * crank + frame * frame - 2.0 * crank * frame * crank_angle.cos();
        ((coupler * coupler + rocker * rocker - diagonal) / (2.0 * coupler * rocker)).acos()
    };
    for (cell, wanted) in row[1..].iter().zip_eq([angle(2.0 * PI / 3.0), angle(0.0)]) {
        let Cell::Number(found) = cell else { panic!("{cell:?} and not {wanted}") };
        assert!((found - wanted).abs() < 1e-9, "{found} and not {wanted}");
    }
}

#[test]
fn a_view_is_turned_round_and_up() {
    let front = Viewpoint3 { azimuth: 0.0, elevation: 0.0 };
    let near = |a: (f64, f64), b: (f64, f64)| (a.0 - b.0).hypot(a.1 - b.1) < 1e-12;
    assert!(near(front.point([1.0, 2.0, 3.0]), (2.0, 3.0)), "x points at the viewer");
    assert!(
        near(front.turned(-FRAC_PI_2, FRAC_PI_2).point([1.0, 2.0, 3.0]), (1.0, 2.0)),
        "the plan, top view"
    );
    assert!(near(front.turned(PI, 0.0).point([1.0, 2.0, 3.0]), (-2.0, 3.0)), "from behind");
    assert_eq!(front.turned(0.0, 9.0).elevation, FRAC_PI_2, "never over the top");
    // Lengths at right angles to the line of sight are kept from every side.
    for (round, up) in [(0.3, 0.2), (2.0, -1.0), (5.0, 1.5)] {
        let view = front.turned(round, up);
        let sight = [up.cos() * round.cos(), up.cos() * round.sin(), up.sin()];
        let point = [0.3, -0.7, 0.2];
        let along: f64 = point.iter().zip_eq(sight).map(|(a, b)| a * b).sum();
        let whole: f64 = point.iter().map(|a| a * a).sum();
        let (x, y) = view.point(point);
        assert!((x * x + y * y - (whole - along * along)).abs() < 1e-12);
    }
}

#[test]
fn a_scene_in_space_is_turned_by_keys_and_keeps_its_side() {
    let mut person = Person::at(120, 40).opens("rigid-body/mass-properties");
    let usual = person.types("<tab>]]]").sees();
    assert!(usual.contains("principal axes at G"), "{usual}");
    let turned = person.types("<right>").sees();
    assert_ne!(turned, usual);
    assert_eq!(person.types("<left>").sees(), usual);
    assert_eq!(person.types(&"<right>".repeat(36)).sees(), usual, "once round");
    let above = person.types(&"<up>".repeat(20)).sees();
    assert_eq!(person.types("<up>").sees(), above, "not over the top");
    assert_eq!(person.types("i").sees(), usual);
    // A change of the inputs is seen from the same side; an animation as well.
    let mut person = Person::at(120, 40).opens("rigid-body/heavy-top");
    person.types("<tab>").turns_to("Drawing");
    person.types("<up><right>");
    let view = |person: &Person| person.model.bench.as_ref()?.find::<panes::drawing::Drawing>()?.view();
    let turned = view(&person);
    person.types(".,<tab>+-<tab>");
    assert!(turned.is_some());
    assert_eq!(view(&person), turned);
    let mut flat = Person::at(120, 40).opens("vibration/rotating-unbalance");
    assert!(flat.types("<tab>]]]<right>").sees().contains("this drawing is planar"), "{}", flat.sees());
}

/// An export contains the visible state: the window, the decibels, the cursor; the side of a scene.
#[test]
fn what_is_seen_is_exported() {
    let folder = tempfile::tempdir().expect("a folder");
    let name = |name: &str| folder.path().join(name).display().to_string();
    let mut person = Person::at(120, 40).opens("vibration/rotating-unbalance");
    assert!(person.types("P").sees().contains("no plot or drawing on the screen"), "{}", person.sees());
    person.types("<tab>]]aa<right>++P").types(&name("seen.csv")).types("<enter>");
    assert!(person.sees().contains("plot or drawing written to"), "{}", person.sees());
    let csv = std::fs::read_to_string(name("seen.csv")).expect("it is written");
    assert!(csv.starts_with("series,speed of the machine [rpm],") && csv.contains("dB over 1 mm"), "{csv}");
    let speeds: Vec<f64> =
        csv.lines().skip(1).filter_map(|line| line.split(',').nth(1)?.parse().ok()).collect();
    let bench = person.model.bench.as_ref().expect("a problem");
    let (from, to) = bench
        .find::<panes::plot::Plot>()
        .and_then(|plot| plot.state().view.window)
        .expect("a part of the axis");
    let rpm = |si: f64| si * 30.0 / PI;
    assert!(speeds.iter().all(|speed| (rpm(from) - 1e-6..=rpm(to) + 1e-6).contains(speed)), "{csv}");
    assert!(csv.contains("at the cursor,1000,"), "{csv}");
    person.types("P").types(&name("seen.svg")).types("<enter>");
    let svg = std::fs::read_to_string(name("seen.svg")).expect("it is written");
    assert!(svg.contains("dB over 1 mm") && svg.contains("= 1000 rpm"), "{svg}");
    // Every curve stays inside the axes.
    for points in svg.lines().filter_map(|line| line.strip_prefix("<polyline points=\"")) {
        let points = points.split('"').next().expect("they end");
        let xs = points.split(' ').filter_map(|at| at.split(',').next()?.parse::<f64>().ok());
        assert!(xs.into_iter().all(|x| (0.0..=640.0).contains(&x)), "{points}");
    }
    let mut scene = Person::at(120, 40).opens("rigid-body/mass-properties");
    scene.types("<tab>]]]P").types(&name("usual.svg")).types("<enter>");
    scene.types("<right><right>P").types(&name("turned.svg")).types("<enter>");
    let [usual, turned] =
        ["usual.svg", "turned.svg"].map(|file| std::fs::read_to_string(name(file)).expect("it is written"));
    assert_ne!(usual, turned);
    let lines = |svg: &str| svg.matches("<polyline").count();
    assert_eq!(lines(&usual), lines(&turned), "the same strokes from another side");
}

#[test]
fn a_frequency_axis_may_be_logarithmic() {
    let mut person = Person::at(120, 40).opens("vibration/rotating-unbalance");
    let linear = person.types("<tab>]]").sees();
    let logarithmic = person.types("x").sees();
    assert_ne!(linear, logarithmic);
    assert!(logarithmic.contains(" 100 ") && logarithmic.contains(" 1000 "), "{logarithmic}");
    assert_eq!(person.types("x").sees(), linear);
}

#[test]
fn a_tall_screen_shows_two_plots() {
    let id = "rigid-body/motion";
    let shown = Person::at(200, 60).opens(id).sees();
    assert!(shown.contains("Plot 1/") && shown.contains(" 2/"), "{shown}");
    let low = Person::at(160, 40).opens(id).sees();
    assert!(low.contains("Plot 1/") && !low.contains(" 2/"), "{low}");
}
