use dalembert_core::{Ink, LabelSide};
use dalembert_terminal::pixels;

use super::*;

fn drawing(shapes: Vec<DrawnShape>) -> Drawing {
    Drawing { title: "title".into(), shapes: shapes.into() }
}

fn drawn(drawing: &Drawing, look: &Appearance, width: u16, height: u16) -> Vec<String> {
    let area = Rect::new(0, 0, width, height);
    let mut buffer = Buffer::empty(area);
    render(drawing, look, &Locale::english(), area, &mut buffer);
    (0..height).map(|y| (0..width).map(|x| buffer[(x, y)].symbol()).collect()).collect()
}

#[test]
fn a_circle_is_round() {
    // Rows are twice as high as columns are wide, so twice as many columns as rows hold a circle.
    let circle = drawing(vec![DrawnShape::Circle((3.0, -2.0), 5.0, Ink::Body)]);
    let ascii = Appearance { ascii: true, ..Appearance::default() };
    for look in [Appearance::default(), ascii] {
        let rows = drawn(&circle, &look, 200, 81);
        let high = rows[1..].iter().filter(|row| !row.trim().is_empty()).count();
        let columns =
            (0..200).filter(|x| rows[1..].iter().any(|row| row.chars().nth(*x) != Some(' '))).count();
        assert!(high >= 76, "{high} rows");
        assert!(columns.abs_diff(2 * high) <= 4, "{columns} columns, {high} rows");
    }
}

#[test]
fn a_drawing_stands_upright_and_the_right_way_round() {
    let shapes = vec![
        DrawnShape::Polyline(vec![(0.0, 0.0), (10.0, 0.0), (10.0, 4.0)], Ink::Body),
        DrawnShape::Label((0.0, 4.0), LabelSide::Right, "up".into()),
    ];
    let rows = drawn(&drawing(shapes), &Appearance { ascii: true, ..Appearance::default() }, 40, 12);
    let row = |words: &str| rows.iter().position(|row| row.contains(words)).unwrap();
    assert!(row("up") < row("-----"), "{rows:#?}");
    let last = rows[row("-----")].rfind('-').unwrap();
    let wall = rows[row("-----") - 1].find('|').unwrap();
    assert!(wall.abs_diff(last) <= 1, "{rows:#?}");
}

#[test]
fn a_block_hides_what_lies_under_it() {
    let spring = DrawnShape::Polyline(vec![(0.0, 0.0), (10.0, 0.0)], Ink::Faint);
    let block = DrawnShape::Block((3.0, -2.0), (7.0, 2.0), Ink::Body);
    let ascii = Appearance { ascii: true, ..Appearance::default() };
    let middle = |shapes: Vec<DrawnShape>| drawn(&drawing(shapes), &ascii, 42, 14)[1..].join("\n");
    let over = middle(vec![spring.clone(), block.clone()]);
    let under = middle(vec![block, spring]);
    assert!(under.lines().any(|row| row.contains("--------------------")), "{under}");
    assert!(over.lines().any(|row| row.contains("|            ")), "{over}");
}

#[test]
fn words_do_not_stand_on_one_another() {
    let labels = ["alpha", "beta", "gamma", "delta"]
        .map(|name| DrawnShape::Label((1.0, 1.0), LabelSide::Right, name.into()));
    let shapes = [DrawnShape::Circle((0.0, 0.0), 2.0, Ink::Body)].into_iter().chain(labels).collect();
    let all = drawn(&drawing(shapes), &Appearance::default(), 60, 20).join("\n");
    for name in ["alpha", "beta", "gamma", "delta"] {
        assert!(all.contains(name), "{name} is missing in\n{all}");
    }
}

#[test]
fn arrows_point_where_they_point() {
    for (head, sign) in [((5.0, 0.0), '>'), ((-5.0, 0.0), '<'), ((0.0, 5.0), '^'), ((0.0, -5.0), 'v')] {
        let arrow = drawing(vec![DrawnShape::Arrow((0.0, 0.0), head, Ink::Force)]);
        let all = drawn(&arrow, &Appearance { ascii: true, ..Appearance::default() }, 30, 12).join("");
        assert_eq!(all.matches(sign).count(), 1, "{head:?}");
    }
}

#[test]
fn a_spring_is_a_zigzag_and_ground_is_hatched_where_a_cell_is_a_dot() {
    let ascii = Appearance { ascii: true, ..Appearance::default() };
    let across = vec![DrawnShape::Spring((0.0, 0.0), (10.0, 0.0), 5)];
    let all = drawn(&drawing(across), &ascii, 42, 12).join("\n");
    assert!(all.contains(r"-/\/\/\/\/\/\/\/\") || all.contains(r"-\/\/\/\/\/\/\/\/"), "{all}");
    let up = vec![
        DrawnShape::Ground((-2.0, 0.0), (2.0, 0.0)),
        DrawnShape::Spring((0.0, 0.0), (0.0, 5.0), 5),
        DrawnShape::Polyline(vec![(-2.0, 5.0), (2.0, 5.0)], Ink::Body),
    ];
    let rows = drawn(&drawing(up), &ascii, 42, 24);
    let column = rows.iter().find_map(|row| row.find('\\')).expect("the spring is drawn");
    let down: String = rows.iter().filter_map(|row| row.chars().nth(column)).collect();
    assert!(down.contains(r"/\/\/\/\"), "{down}");
    let ground = rows.iter().rposition(|row| row.contains("-----")).expect("the ground is drawn");
    assert!(
        rows[ground + 1].trim().len() > 10 && rows[ground + 1].trim().chars().all(|c| c == '/'),
        "{rows:#?}"
    );
}

#[test]
fn the_smallest_circle_is_one_sign() {
    let shapes = vec![
        DrawnShape::Polyline(vec![(0.0, 0.0), (40.0, 0.0)], Ink::Body),
        DrawnShape::Circle((20.0, 3.0), 0.5, Ink::Body),
    ];
    let all =
        drawn(&drawing(shapes), &Appearance { ascii: true, ..Appearance::default() }, 42, 12).join("\n");
    assert_eq!((all.matches('O').count(), all.matches('o').count()), (1, 0), "{all}");
}

/// The columns and rows of pixels that a drawing covers.
fn extent_in_pixels(drawing: &Drawing, cell: (u16, u16)) -> [(usize, usize); 2] {
    let area = Rect::new(0, 0, 60, 20);
    let look = Appearance { pixels: Some(cell), ..Appearance::default() };
    let placed = render(drawing, &look, &Locale::english(), area, &mut Buffer::empty(area));
    let raster = placed.picture.expect("a picture").raster;
    let (width, height) = raster.size();
    let is_drawn = |x: usize, y: usize| raster.pixel((x, y)).is_some();
    let ends = |mut drawn: Box<dyn Iterator<Item = usize> + '_>| {
        let first = drawn.next().expect("something is drawn");
        (first, drawn.last().unwrap_or(first))
    };
    [
        ends(Box::new((0..width).filter(move |x| (0..height).any(|y| is_drawn(*x, y))))),
        ends(Box::new((0..height).filter(move |y| (0..width).any(|x| is_drawn(x, *y))))),
    ]
}

#[test]
fn in_pixels_a_circle_is_round_whatever_the_font() {
    let circle = drawing(vec![DrawnShape::Circle((3.0, -2.0), 5.0, Ink::Body)]);
    for cell in [(10, 20), (9, 20), (8, 14), (12, 30)] {
        let [across, down] = extent_in_pixels(&circle, cell);
        let (width, height) = (across.1 - across.0, down.1 - down.0);
        assert!(width.abs_diff(height) <= 2, "{width} × {height} in cells of {cell:?}");
        assert!(height > 15 * usize::from(cell.1), "{height}");
    }
}

#[test]
fn in_pixels_a_block_hides_what_lies_under_it() {
    let line = DrawnShape::Polyline(vec![(0.0, 0.0), (10.0, 0.0)], Ink::Motion);
    let block = DrawnShape::Block((3.0, -2.0), (7.0, 2.0), Ink::Body);
    let covered = |shapes: Vec<DrawnShape>| {
        let area = Rect::new(0, 0, 60, 20);
        let look = Appearance { pixels: Some((10, 20)), ..Appearance::default() };
        let placed = render(&drawing(shapes), &look, &Locale::english(), area, &mut Buffer::empty(area));
        let raster = placed.picture.expect("a picture").raster;
        let motion = pixels::Ink::from(look.ink(Ink::Motion));
        let is_line = |x: &usize| {
            (0..raster.size().1).any(|y| raster.pixel((*x, y)).is_some_and(|(ink, _)| ink == motion))
        };
        (0..raster.size().0).filter(is_line).count() as f64
    };
    let (over, under) = (covered(vec![line.clone(), block.clone()]), covered(vec![block, line]));
    assert!((over / under - 0.6).abs() < 0.02, "{over} of {under}");
}
