use dalembert_core::Axis;
use dalembert_terminal::glyphs::Colors;
use ratatui::style::Color;

use super::*;
use crate::look::Theme;

const BARE: Appearance =
    Appearance { ascii: false, colors: Colors::None, theme: Theme::Terminal, basic: false };

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
            move |colors| [true, false].map(|ascii| Appearance { ascii, colors, theme, basic: false }),
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
