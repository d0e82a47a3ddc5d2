use dalembert_core::Axis;
use dalembert_terminal::glyphs::Colors;
use ratatui::style::Color;

use super::*;
use crate::look::Theme;

const BARE: Appearance =
    Appearance { ascii: false, colors: Colors::None, theme: Theme::Terminal, basic: false, pixels: None };

/// Straight lines through the origin, the steepest last.
fn lines(count: usize) -> Plot {
    let line = |n: usize| {
        let points = (0..=100).map(f64::from).map(|x| (x, x * (n + 1) as f64 / count as f64)).collect();
        Series::line(dalembert_core::Text::verbatim(format!("curve {}", n + 1)), points)
    };
    Plot::new("", Axis::linear("x", ""), Axis::linear("y", ""), (0..count).map(line).collect())
}

fn buffer(plot: &Plot, state: &PlotState, look: &Appearance, (width, height): (u16, u16)) -> Buffer {
    let area = Rect::new(0, 0, width, height);
    let mut buffer = Buffer::empty(area);
    render(plot, None, state, look, &Locale::english(), area, &mut buffer);
    buffer
}

fn rows(buffer: &Buffer) -> Vec<String> {
    let row = |y| (0..buffer.area.width).map(|x| buffer[(x, y)].symbol()).collect::<String>();
    (0..buffer.area.height).map(|y| row(y).trim_end().to_owned()).collect()
}

#[test]
fn no_two_of_eight_curves_look_alike() {
    let looks = Theme::ALL.into_iter().flat_map(|theme| {
        [Colors::None, Colors::Sixteen, Colors::Indexed256, Colors::True].into_iter().flat_map(
            move |colors| {
                [true, false].map(|ascii| Appearance { ascii, colors, theme, basic: false, pixels: None })
            },
        )
    });
    for look in looks {
        for marker in [Marker::Braille, Marker::HalfBlock, Marker::Dot, Marker::Ascii] {
            let marker = if look.ascii { Marker::Ascii } else { marker };
            let mut seen = Vec::new();
            for n in 0..8 {
                let pen = pen(n, marker, &look);
                // Braille has no stamp to be seen.
                let finer = matches!(marker, Marker::Braille | Marker::HalfBlock);
                let stamp = if finer { ' ' } else { pen.stamp };
                let seen_as = (pen.style, pen.mark.map(|(sign, _)| sign), stamp);
                assert!(!seen.contains(&seen_as), "curve {n} in {look:?} with {marker:?}");
                seen.push(seen_as);
            }
        }
    }
}

#[test]
fn without_colours_the_legend_shows_the_signs_of_the_curves() {
    let buffer = buffer(&lines(5), &PlotState::default(), &BARE, (70, 24));
    let all = rows(&buffer);
    assert!(all[0..3].join(" ").contains("── curve 1  ─◆─ curve 2  ─▲─ curve 3  ─■─ curve 4"), "{all:#?}");
    let curves = all[4..20].join("\n");
    for sign in ['◆', '▲', '■', '○'] {
        assert!(curves.contains(sign), "{sign} in\n{curves}");
    }
}

#[test]
fn a_mark_and_its_words_have_a_colour_of_their_own_and_stand_together() {
    let plot = lines(4).mark("answer", (50.0, 0.5));
    let buffer = buffer(&plot, &PlotState::default(), &Appearance::default(), (70, 24));
    let find = |sign: &str| {
        let cells = (0..24).flat_map(|y| (0..70).map(move |x| (x, y)));
        cells.into_iter().find(|at| buffer[*at].symbol() == sign)
    };
    let dot = find("●").expect("the mark is drawn");
    let row = rows(&buffer).iter().position(|row| row.contains("answer")).expect("the words stand") as u16;
    assert!(row.abs_diff(dot.1) <= 1, "{:#?}", rows(&buffer));
    let from =
        (0..64).find(|x| (0..6).all(|n| buffer[(x + n, row)].symbol() == &"answer"[n.into()..=n.into()]));
    let letters = from.map(|x| (x..x + 6).map(|x| (x, row)).collect::<Vec<_>>()).expect("they are whole");
    for cell in letters.into_iter().chain([dot]) {
        assert_eq!((buffer[cell].fg, buffer[cell].modifier), (Color::Reset, Modifier::BOLD), "{cell:?}");
    }
}

#[test]
fn every_marker_makes_another_picture() {
    let mut state = PlotState::default();
    let mut seen: Vec<Vec<String>> = Vec::new();
    for _ in 0..4 {
        let drawn = rows(&buffer(&lines(2), &state, &Appearance::default(), (60, 16)));
        assert!(!seen.contains(&drawn), "{drawn:#?}");
        seen.push(drawn);
        state = state.next_marker();
    }
}

#[test]
fn the_cursor_reads_every_curve_of_a_pane_of_half_a_screen() {
    let state = PlotState { cursor: Some(50.0), ..PlotState::default() };
    let all = rows(&buffer(&lines(6), &state, &Appearance::default(), (38, 19)));
    for n in 1..=6 {
        let reading = format!(
            "curve {n} = {}",
            dalembert_units::write_number(f64::from(n) * 50.0 / 6.0, dalembert_units::Style::default())
        );
        assert!(all.iter().any(|row| row.contains(&reading)), "{reading} in\n{all:#?}");
    }
}

#[test]
fn a_reading_between_points_has_no_digit_that_they_do_not_give() {
    let parabola = |step: f64| {
        let points = (0..=80).map(|n| f64::from(n) * step).map(|x| (x, 1.0 + x * x)).collect();
        Plot::new("", Axis::linear("x", ""), Axis::linear("y", ""), vec![Series::line("y", points)])
            .mark("off the curve", (5.05, 3.0))
    };
    let read = |step: f64| {
        let state = PlotState { cursor: Some(5.05), ..PlotState::default() };
        readout(&parabola(step), &state, &Locale::english()).expect("there is a cursor")
    };
    // 1 + 5.05² = 26.5025. A chord lies h²/4 above the middle of a parabola x²: 0.0025 for points 0.1 apart.
    assert!(read(0.1).ends_with("y ≈ 26.51") || read(0.1).ends_with("y ≈ 26.5"), "{}", read(0.1));
    // 2 apart, from 4 to 6: 1.05 · 0.95 too high.
    assert!(read(2.0).ends_with("y ≈ 30"), "{}", read(2.0));
    // A mark that lies on the curve, as closely as its points tell, is a point of it.
    let on = parabola(0.1).mark("on the curve", (5.05, 26.5025));
    let state = PlotState { cursor: Some(5.05), ..PlotState::default() };
    let said = readout(&on, &state, &Locale::english()).expect("there is a cursor");
    assert!(said.contains("on the curve = 26.503") && said.ends_with("y = 26.503"), "{said}");
}

#[test]
fn marks_ticks_and_curves_tell_the_same_values() {
    // A level line at every label: its dots lie in the row of the label, and so does a mark on it.
    for (height, from, to) in [(24, -0.3, 9.7), (19, -47.0, 52.0), (31, 2.0, 17.0), (13, -8.0, -1.0)] {
        for log in [false, true].into_iter().filter(|log| !log || from > 0.0) {
            for marker in [Marker::Braille, Marker::HalfBlock, Marker::Dot] {
                let ends = Series::line("ends", vec![(0.0, from), (1.0, to)]);
                let mut plot = Plot::new("", Axis::linear("x", ""), Axis::linear("y", ""), vec![ends]);
                if log {
                    plot.y.scale = dalembert_core::Scale::Log;
                }
                let state = PlotState { marker, ..PlotState::default() };
                let labels = rows(&buffer(&plot, &state, &Appearance::default(), (60, height)));
                for (row, at) in labels.iter().enumerate().filter_map(|(row, line)| {
                    let label = line.split_once('┤')?.0.trim().replace('−', "-");
                    Some((row, label.parse::<f64>().ok().filter(|at| (from..=to).contains(at))?))
                }) {
                    let level = Series::line("level", vec![(0.0, at), (1.0, at)]);
                    let marked = Plot { series: vec![level, plot.series[0].clone()], ..plot.clone() };
                    let drawn = rows(&buffer(
                        &marked.mark("", (0.7, at)),
                        &state,
                        &Appearance::default(),
                        (60, height),
                    ));
                    assert!(drawn[row].contains('●'), "{at} in\n{drawn:#?}");
                    assert!(
                        !drawn[row].ends_with('┤') && drawn[row].chars().count() > 50,
                        "{at} in\n{drawn:#?}"
                    );
                }
            }
        }
    }
}

/// A circle of radius 3 mm about (100, 2) mm.
fn circle() -> Plot {
    let points = (0..=360).map(|n| f64::from(n).to_radians());
    let points = points.map(|angle| (0.1 + 0.003 * angle.cos(), 0.002 + 0.003 * angle.sin())).collect();
    let axes = [Axis::linear("x", "mm"), Axis::linear("y", "mm")];
    let [x, y] = axes;
    Plot::new("", x, y, vec![Series::line("circle", points)]).equal()
}

#[test]
fn circles_of_equal_scales_are_round() {
    for size in [(38, 14), (56, 18), (30, 30), (110, 30), (60, 60)] {
        let pixels = Marker::Pixels { across: 9, down: 20 };
        for marker in [Marker::Braille, Marker::HalfBlock, Marker::Dot, pixels] {
            let state = PlotState { marker, ..PlotState::default() };
            let plot = circle();
            let area = Rect::new(0, 0, size.0, size.1);
            let mut axes = Axes::of(&plot).unwrap();
            let look = Appearance::default();
            let locale = Locale::english();
            let frame = Frame::of(&axes, &state, Setting { area, marker, look: &look, locale: &locale });
            (axes.x.span, axes.y.span) = (frame.across, frame.up);
            let canvas = Canvas {
                axes: &axes,
                area: frame.canvas,
                marker,
                look: &look,
                zero: false,
                ticks: &frame.ticks,
            };
            let dots = Dots::new(frame.canvas, marker);
            let per_cell = dots::per_cell(marker);
            let at = |x: f64, y: f64| canvas.dot(&dots, (x, y)).unwrap();
            let across = (at(0.103, 0.002).0 - at(0.097, 0.002).0) / f64::from(per_cell.0);
            let down = dots::aspect(marker) * (at(0.1, -0.001).1 - at(0.1, 0.005).1) / f64::from(per_cell.1);
            assert!((across / down - 1.0).abs() < 1e-9, "{across} and {down} at {size:?} with {marker:?}");
            let inside = |place: f64| (-1e-9..=1.0 + 1e-9).contains(&place);
            assert!([0.097, 0.103].into_iter().all(|x| inside(axes.x.of(x).unwrap())), "{size:?}");
            assert!([-0.001, 0.005].into_iter().all(|y| inside(axes.y.of(y).unwrap())), "{size:?}");
        }
    }
}

/// A pointer reads what stands in its column, though equal scales show more of the axis than there are data.
#[test]
fn a_column_is_the_place_that_is_drawn_in_it() {
    let plot = circle();
    let (look, locale) = (Appearance::default(), Locale::english());
    let area = Rect::new(0, 0, 80, 20);
    let place = |column| place_at(&plot, &PlotState::default(), &look, &locale, area, column).unwrap().0;
    let drawn = rows(&buffer(&plot, &PlotState::default(), &look, (80, 20)));
    let of_curve = |row: &String| row.chars().position(|c| ('⠁'..='⣿').contains(&c) && c != '⠄');
    let left = drawn.iter().filter_map(of_curve).min().unwrap();
    assert!(place(left as u16).abs() < 0.1, "{} at {left} of\n{drawn:#?}", place(left as u16));
    assert!(place(12) < -0.5, "{}", place(12));
}

#[test]
fn units_and_powers_of_ten_outlive_long_names() {
    let points = (0..=10).map(|n| (f64::from(n), 5e4 * f64::from(n))).collect();
    let name = "Maximum diameter of the shaft in supercritical operation of the rotor";
    let plot = Plot::new(
        "",
        Axis::linear("Clearance between the rotor and its stator", "kg*m^2"),
        Axis::linear(name, "m^2/s^4/Hz"),
        vec![Series::line("d", points)],
    );
    for (width, height) in [(24, 7), (30, 11), (38, 14), (38, 24)] {
        let drawn = rows(&buffer(&plot, &PlotState::default(), &Appearance::default(), (width, height)));
        let all = drawn.join("\n");
        let is_whole = all.contains("[10³ m²/s⁴/Hz]") || all.contains("[10⁶ m²/s⁴/Hz]");
        assert!(is_whole && all.contains("[kg·m²]"), "{width}×{height}:\n{all}");
    }
    // In a low plot that has no room for a title at the axis there are no numbers that want one.
    let low = rows(&buffer(&plot, &PlotState::default(), &Appearance::default(), (38, 5)));
    assert!(!low.join("").contains("200"), "{low:#?}");
}

#[test]
fn small_lengths_are_in_millimetres() {
    let points = (0..=10).map(|n| (f64::from(n), 5e-4 * f64::from(n))).collect();
    let plot = Plot::new("", Axis::linear("t", "s"), Axis::linear("x", "m"), vec![Series::line("x", points)]);
    let all = rows(&buffer(&plot, &PlotState::default(), &Appearance::default(), (38, 14))).join("\n");
    assert!(all.contains("x [mm]") && all.contains("4┤") && !all.contains("10⁻"), "{all}");
    let state = PlotState { cursor: Some(3.0), ..PlotState::default() };
    assert_eq!(readout(&plot, &state, &Locale::english()).unwrap(), "t = 3 s   x = 1.5 mm");
    // A tenth of a unit is still read in it.
    let whole = Plot { series: vec![Series::line("x", vec![(0.0, 0.0), (1.0, 0.4)])], ..plot };
    let all = rows(&buffer(&whole, &PlotState::default(), &Appearance::default(), (38, 14))).join("\n");
    assert!(all.contains("x [m]"), "{all}");
}

#[test]
fn a_pinned_plot_keeps_its_operating_point() {
    let before = lines(1).mark("operating point", (20.0, 20.0));
    let now = lines(1).mark("operating point", (80.0, 80.0));
    let area = Rect::new(0, 0, 60, 18);
    let mut drawn = Buffer::empty(area);
    let look = Appearance::default();
    render(&now, Some(&before), &PlotState::default(), &look, &Locale::english(), area, &mut drawn);
    let all = rows(&drawn).join("\n");
    let column = |sign: char| {
        let mut canvas = rows(&drawn).into_iter().skip(3);
        canvas.find_map(|row| row.chars().position(|c| c == sign)).unwrap()
    };
    assert!(all.contains("┄○ before"), "{all}");
    assert_eq!(all.matches('●').count(), 1, "{all}");
    assert!(column('○') < 20 && column('●') > 40, "{all}");
}

#[test]
fn marks_that_share_a_cell_stand_beside_each_other() {
    let plot = lines(1).mark("first", (50.0, 50.0)).mark("second", (50.1, 50.1)).mark("third", (49.9, 49.9));
    let all = rows(&buffer(&plot, &PlotState::default(), &Appearance::default(), (60, 18))).join("\n");
    assert!(all.contains("●●●"), "{all}");
    for name in ["first", "second", "third"] {
        assert!(all.contains(name), "{all}");
    }
    // Two names of one point are one mark.
    let same = lines(1).mark("first", (50.0, 50.0)).mark("second", (50.0, 50.0));
    let all = rows(&buffer(&same, &PlotState::default(), &Appearance::default(), (60, 18))).join("\n");
    assert_eq!(all.matches('●').count(), 1, "{all}");
}

#[test]
fn the_pointer_is_read_before_the_cursor() {
    let plot = lines(1);
    let state = PlotState::default().with_cursor(&plot, 0.25);
    let read = |state: &PlotState| readout(&plot, state, &Locale::english()).unwrap();
    assert!(read(&state).starts_with("x = 25"), "{}", read(&state));
    let over = state.with_pointer(&plot, Some(0.75));
    assert!(read(&over).starts_with("x = 75"), "{}", read(&over));
    assert_eq!(over.with_pointer(&plot, None), state);
    assert_eq!(over.with_pointer(&plot, Some(1.2)), state, "beyond the axis there is nothing to read");
}

/// The pictures of a plot in cells of 10 × 20 pixels.
fn pictures(plot: &Plot, state: &PlotState, (width, height): (u16, u16)) -> (Vec<Picture>, Buffer) {
    let area = Rect::new(0, 0, width, height);
    let mut buffer = Buffer::empty(area);
    let look = Appearance { pixels: Some((10, 20)), ..Appearance::default() };
    let pictures = render(plot, None, state, &look, &Locale::english(), area, &mut buffer);
    (pictures, buffer)
}

/// The middle of what an ink of this colour covers, column by column of pixels.
fn middles(picture: &Picture, color: Color) -> Vec<(f64, f64)> {
    let (width, height) = picture.raster.size();
    let middle = |x: usize| {
        let share = |y| match picture.raster.pixel((x, y)) {
            Some((ink, degree)) if ink.color == color => f64::from(degree),
            _ => 0.0,
        };
        let (sum, moment) =
            (0..height).fold((0.0, 0.0), |(sum, moment), y| (sum + share(y), moment + share(y) * y as f64));
        (sum > 0.0).then(|| (x as f64, moment / sum))
    };
    (0..width).filter_map(middle).collect()
}

#[test]
fn in_pixels_a_straight_line_is_straight_to_half_a_pixel() {
    let (pictures, buffer) = pictures(&lines(1), &PlotState::default(), (70, 24));
    let [picture] = &pictures[..] else { panic!("{} pictures", pictures.len()) };
    assert_eq!(
        picture.raster.size(),
        (10 * usize::from(picture.area.width), 20 * usize::from(picture.area.height))
    );
    // The cells under the picture hold no strokes of their own.
    let inside = picture.area.positions().map(|at| buffer[at].symbol()).collect::<String>();
    assert_eq!(inside.trim(), "");
    let line = middles(picture, Color::Cyan);
    assert!(line.len() as f64 > 0.95 * picture.raster.size().0 as f64, "{} columns", line.len());
    let (first, last) = (line[5], line[line.len() - 6]);
    let slope = (last.1 - first.1) / (last.0 - first.0);
    assert!(slope < -0.4, "{slope}");
    for (x, y) in &line[5..line.len() - 5] {
        let off = y - first.1 - slope * (x - first.0);
        assert!(off.abs() < 0.5, "{off} at {x}");
    }
}

#[test]
fn in_pixels_the_cursor_is_a_picture_of_three_columns_and_leaves_the_curves() {
    let state = |at: f64| PlotState { cursor: Some(at), ..PlotState::default() };
    let (first, _) = pictures(&lines(3), &state(30.0), (70, 24));
    let (second, _) = pictures(&lines(3), &state(31.0), (70, 24));
    assert_eq!((first.len(), first[1].area.width, first[1].area.height), (2, 3, first[0].area.height));
    assert_eq!(first[0], second[0]);
    assert_ne!(first[1], second[1]);
    // The line down the plot is where the cursor is, and the points on the curves are beside none of it.
    let (across, cells) = (f64::from(first[1].area.x - first[0].area.x), f64::from(first[0].area.width));
    let line = middles(&first[1], Color::Reset).into_iter().map(|(x, _)| x).sum::<f64>();
    assert!((across * 10.0 + line - 0.3 * (10.0 * cells - 1.0)).abs() <= 0.5, "{line}");
}

#[test]
fn in_pixels_words_have_their_cells_for_themselves() {
    let mut found = 0;
    // Of eight curves, those without a colour of their own have signs.
    for (curves, x) in (0..100).flat_map(|n| [(2, f64::from(n)), (8, f64::from(n))]) {
        let plot = lines(curves).mark("peak", (x, 0.93 * x));
        let (pictures, buffer) = pictures(&plot, &PlotState::default(), (70, 24));
        let area = pictures[0].area;
        let words: Vec<_> = area.positions().filter(|at| buffer[*at].symbol() != " ").collect();
        let written = words.iter().map(|at| buffer[*at].symbol()).collect::<String>();
        // Where there is no room, they are left out.
        assert!(["", "peak"].contains(&&*written), "{curves} curves, {x}: {written}");
        found += usize::from(!words.is_empty());
        for at in words {
            let (x, y) = (usize::from(at.x - area.x) * 10, usize::from(at.y - area.y) * 20);
            // Letters leave an eighth of a cell above and below.
            assert!(pictures[0].raster.is_free(y + 2..y + 18, x..x + 10), "{curves} curves, {at}");
        }
    }
    assert!(found > 150, "{found} of 200");
}
