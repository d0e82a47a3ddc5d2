use std::f64::consts::TAU;

use super::*;

/// The words of a drawing with their sides.
fn labels(drawing: &Drawing) -> Vec<(String, LabelSide)> {
    let label = |shape: &DrawnShape| match shape {
        DrawnShape::Label(_, side, text) => Some((text.english(), *side)),
        _ => None,
    };
    drawing.shapes.iter().filter_map(label).collect()
}

fn side(drawing: &Drawing, name: &str) -> LabelSide {
    labels(drawing).into_iter().find(|(words, _)| words == name).expect("the name is written").1
}

/// A mechanism with a letter at everything, by a sign that mirrors it.
fn linkage(mirror: f64) -> Drawing {
    let at = |x: f64, y: f64| (mirror * x, y);
    let (o, a, b, c) = (at(0.0, 0.0), at(0.5, 1.0), at(3.0, 1.9), at(3.4, 0.1));
    Sketch::new("")
        .link("2", o, a)
        .link("3", a, b)
        .link("4", c, b)
        .pin("O₂", o)
        .pin("O₄", c)
        .joint("A", a)
        .joint("B", b)
        .force("F", b, at(4.2, 2.3))
        .motion("v", a, at(0.1, 1.4))
        .spring("k", at(0.2, 0.4), at(3.4, 1.0))
        .finish()
}

#[test]
fn a_name_stands_beyond_the_head_of_its_vector() {
    for (n, wanted) in LabelSide::AROUND.into_iter().enumerate() {
        let angle = TAU * n as f64 / 8.0;
        let drawing = Sketch::new("").force("F", (0.0, 0.0), (angle.cos(), angle.sin())).finish();
        assert_eq!(labels(&drawing), [("F".to_owned(), wanted)]);
    }
}

#[test]
fn the_name_of_a_force_that_presses_on_a_part_stands_at_its_tail() {
    let place = |tail, head| {
        let drawing = Sketch::new("").mass("m", (0.0, 0.0), (4.0, 4.0)).force("F", tail, head).finish();
        let label = |shape: &DrawnShape| match shape {
            DrawnShape::Label(at, _, text) if text.english() == "F" => Some(*at),
            _ => None,
        };
        drawing.shapes.iter().find_map(label)
    };
    assert_eq!(place((-2.0, 2.0), (0.0, 2.0)), Some((-2.0, 2.0)), "it presses");
    assert_eq!(place((4.0, 2.0), (6.0, 2.0)), Some((6.0, 2.0)), "it pulls");
    assert_eq!(place((1.0, 2.0), (3.0, 2.0)), Some((3.0, 2.0)), "it lies within");
}

#[test]
fn a_name_stands_in_a_mass_that_is_wide_enough() {
    let mass = |width: f64| {
        Sketch::new("").mass("m", (0.0, 0.0), (width, 2.0)).ground((-5.0, 0.0), (5.0, 0.0)).finish()
    };
    assert_eq!(side(&mass(2.0), "m"), LabelSide::Over);
    assert_ne!(side(&mass(0.1), "m"), LabelSide::Over);
}

#[test]
fn names_stand_beside_lines_and_not_on_them() {
    let drawing = Sketch::new("").ground((0.0, 0.0), (4.0, 0.0)).spring("k", (2.0, 0.0), (2.0, 3.0)).finish();
    assert!(matches!(side(&drawing, "k"), LabelSide::Left | LabelSide::Right), "{drawing:?}");
    let drawing = Sketch::new("").link("l", (0.0, 0.0), (4.0, 0.0)).axis((2.0, 0.0), (2.0, 3.0)).finish();
    assert_eq!(side(&drawing, "l"), LabelSide::Below, "the axis takes the place above");
}

#[test]
fn names_of_one_point_part() {
    let names = ["A", "B", "C", "D", "E", "F"];
    let mut sketch = Sketch::new("");
    sketch.axes((0.0, 0.0), 3.0);
    for name in names {
        sketch.label(name, (1.0, 1.0));
    }
    let mut sides: Vec<LabelSide> = labels(&sketch.finish()).into_iter().map(|(_, side)| side).collect();
    assert_eq!(sides.len(), names.len());
    sides.sort_unstable_by_key(|side| LabelSide::AROUND.iter().position(|one| one == side));
    sides.dedup();
    assert_eq!(sides.len(), names.len(), "each at a side of its own");
}

#[test]
fn a_sketch_has_the_same_sides_every_time_and_in_the_mirror_their_mirror() {
    assert_eq!(linkage(1.0), linkage(1.0));
    let mirrored = |side: LabelSide| {
        let (x, y) = side.direction();
        LabelSide::AROUND
            .into_iter()
            .find(|other| (other.direction().0 + x).hypot(other.direction().1 - y) < 1e-9)
            .unwrap_or(side)
    };
    let here = labels(&linkage(1.0));
    assert_eq!(here.len(), 10);
    let there: Vec<_> = here.into_iter().map(|(name, side)| (name, mirrored(side))).collect();
    assert_eq!(labels(&linkage(-1.0)), there);
}

#[test]
fn names_and_symbols_do_not_change_while_a_machine_moves() {
    let frame = |n: u32| {
        let angle = TAU * f64::from(n) / 12.0;
        let tip = (angle.cos(), angle.sin());
        let mut sketch = Sketch::default();
        sketch
            .pin("O", (0.0, 0.0))
            .link("r", (0.0, 0.0), tip)
            .joint("A", tip)
            .spring("k", (3.0, 0.0), tip)
            .torsion_spring("k_t", (3.0, 0.0), angle);
        sketch
    };
    let animation = Sketch::animation("", (0..12).map(frame), 1.0);
    let first = &animation.frames[0];
    let fixed = |shapes: &[DrawnShape]| -> Vec<String> {
        let one = |shape: &DrawnShape| match shape {
            DrawnShape::Label(_, side, text) => Some(format!("{} {side:?}", text.english())),
            DrawnShape::Spring(_, _, coils) => Some(format!("{coils} coils")),
            DrawnShape::Disc(_, radius, _) => Some(format!("{radius}")),
            DrawnShape::Extent(low, high) => Some(format!("{low:?} {high:?}")),
            _ => None,
        };
        shapes.iter().filter_map(one).collect()
    };
    assert_eq!(fixed(first).len(), 8);
    for frame in animation.frames.iter() {
        assert_eq!(fixed(frame), fixed(first));
    }
}

#[test]
fn a_longer_spring_has_more_coils_of_the_same_pitch() {
    let drawing = Sketch::new("")
        .size(10.0)
        .spring("", (0.0, 0.0), (3.0, 0.0))
        .spring("", (0.0, 1.0), (9.0, 1.0))
        .finish();
    let coils: Vec<u32> = drawing
        .shapes
        .iter()
        .filter_map(|shape| if let DrawnShape::Spring(_, _, coils) = shape { Some(*coils) } else { None })
        .collect();
    assert_eq!(coils, [4, 12]);
}

#[test]
fn symbols_have_one_size_whatever_the_length_of_the_machine() {
    let radius = |length: f64| {
        let drawing = Sketch::new("").bars([(0.0, 0.0), (length, 0.0)]).joint("", (0.0, 0.0)).finish();
        let disc = drawing.shapes.iter().find_map(|shape| match shape {
            DrawnShape::Disc(_, radius, _) => Some(*radius),
            _ => None,
        });
        disc.expect("a joint is a disc") / length
    };
    assert!((radius(0.01) - radius(400.0)).abs() < 1e-12);
}

#[test]
fn the_name_of_a_spring_belongs_to_the_edge_of_its_side() {
    for end in [(0.0, 3.0), (3.0, 0.0), (2.0, -2.0)] {
        let mut sketch = Sketch::new("");
        let half = 1.2 * sketch.size(3.0).symbol();
        let drawing = sketch.spring("k", (0.0, 0.0), end).finish();
        let at = drawing.shapes.iter().find_map(|shape| match shape {
            DrawnShape::Label(at, side, _) => Some((*at, side.direction())),
            _ => None,
        });
        let (at, side) = at.expect("it has a name");
        let off = (at.0 - end.0 / 2.0, at.1 - end.1 / 2.0);
        assert!((off.0.hypot(off.1) - half).abs() < 1e-12, "{end:?}: {off:?}");
        assert!((off.0 * end.0 + off.1 * end.1).abs() < 1e-12, "across: {end:?}: {off:?}");
        assert!(off.0 * side.0 + off.1 * side.1 > 0.0, "{end:?}: on the side of the name");
    }
}

#[test]
fn a_cylinder_hangs_on_two_pins() {
    let (from, to) = ((0.0, 0.0), (4.0, 3.0));
    let drawing = Sketch::new("").cylinder("F", from, to, 2.0).finish();
    let pins: Vec<Point> = drawing
        .shapes
        .iter()
        .filter_map(|shape| match shape {
            DrawnShape::Disc(at, ..) => Some(*at),
            _ => None,
        })
        .collect();
    assert_eq!(pins, [from, to]);
    let barrel = drawing.shapes.iter().find_map(|shape| match shape {
        DrawnShape::Body(corners, _) => Some(corners.clone()),
        _ => None,
    });
    let farthest = barrel.expect("it has a barrel").into_iter().map(|(x, y)| 0.8 * x + 0.6 * y);
    assert!((farthest.fold(0.0, f64::max) - 2.0).abs() < 1e-12);
}

#[test]
fn names_of_results_are_covered_with_them() {
    let drawing = Sketch::new("The {what}")
        .force("F", (0.0, 0.0), (1.0, 0.0))
        .vector("R", (0.0, 0.0), (0.0, 1.0), Ink::Result)
        .round("W", (1.0, 1.0), 0.1, Ink::Result)
        .mass("m", (2.0, 0.0), (3.0, 1.0))
        .finish();
    let names = |drawing: &Drawing| labels(drawing).into_iter().map(|(name, _)| name).collect::<Vec<_>>();
    assert_eq!(names(&drawing), ["F", "R", "W", "m"]);
    assert_eq!(names(&drawing.unsolved()), ["F", "m"]);
}

#[test]
fn a_vector_without_length_has_no_name_and_a_sketch_of_nothing_is_empty() {
    assert!(Sketch::new("").force("F", (1.0, 1.0), (1.0, 1.0)).finish().shapes.is_empty());
    assert!(Sketch::new("").finish().shapes.is_empty());
    assert_eq!(Sketch::animation("", [], 1.0).frames.len(), 0);
    let bad = Sketch::new("").disc("D", (f64::NAN, 0.0), f64::INFINITY).joint("A", (0.0, 0.0)).finish();
    assert_eq!(labels(&bad).len(), 2, "what is not finite is left to who draws");
}
