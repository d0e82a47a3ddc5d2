//! Scenes in space: words beside the points that they belong to.

use dalembert_core::{DrawnShape, Ink, LabelSide, Scene, Shape3, Viewpoint3};

/// The sides of the words of a scene of one frame, by the words.
fn sides(shapes: Vec<Shape3>, view: Viewpoint3) -> Vec<(String, LabelSide)> {
    let scene = Scene { title: "scene".into(), frames: vec![shapes], period: 0.0, view };
    let drawing = scene.seen(0, view);
    let words = drawing.shapes.iter().filter_map(|shape| match shape {
        DrawnShape::Label(_, side, text) => Some((text.english(), *side)),
        _ => None,
    });
    words.collect()
}

#[test]
fn words_at_the_head_of_an_arrow_go_on_in_its_direction() {
    // Seen along −x: y to the right, z up.
    let front = Viewpoint3 { azimuth: 0.0, elevation: 0.0 };
    let tail = [0.0, 5.0, 5.0];
    let arrow = |name: &'static str, along: [f64; 3]| {
        let head = [tail[0] + along[0], tail[1] + along[1], tail[2] + along[2]];
        [Shape3::Arrow(tail, head, Ink::Body), Shape3::Label(head, name.into())]
    };
    let mut shapes = vec![Shape3::Polyline(vec![[0.0; 3], [0.0, 20.0, 20.0]], Ink::Body)];
    shapes.extend(arrow("right", [0.0, 1.0, 0.0]));
    shapes.extend(arrow("up", [0.0, 0.0, 1.0]));
    shapes.extend(arrow("left", [0.0, -1.0, 0.0]));
    shapes.extend(arrow("down and right", [0.0, 1.0, -1.0]));
    let expected = [
        ("right", LabelSide::Right),
        ("up", LabelSide::Above),
        ("left", LabelSide::Left),
        ("down and right", LabelSide::LowerRight),
    ];
    let found = sides(shapes, front);
    assert_eq!(found, expected.map(|(words, side)| (words.to_owned(), side)));
}

#[test]
fn words_without_an_arrow_stand_away_from_the_middle_as_it_is_seen() {
    let square = vec![[0.0, -1.0, -1.0], [0.0, 1.0, -1.0], [0.0, 1.0, 1.0], [0.0, -1.0, 1.0]];
    let shapes = || {
        vec![
            Shape3::Polyline(square.clone(), Ink::Body),
            Shape3::Label([0.0, 1.0, 0.0], "y".into()),
            Shape3::Label([0.0, 0.0, -1.0], "foot".into()),
        ]
    };
    let front = Viewpoint3 { azimuth: 0.0, elevation: 0.0 };
    let found = sides(shapes(), front).into_iter().map(|(_, side)| side).collect::<Vec<_>>();
    assert_eq!(found, [LabelSide::Right, LabelSide::Below]);
    // From behind, y goes to the left.
    let behind = front.turned(std::f64::consts::PI, 0.0);
    let found = sides(shapes(), behind).into_iter().map(|(_, side)| side).collect::<Vec<_>>();
    assert_eq!(found, [LabelSide::Left, LabelSide::Below]);
}
