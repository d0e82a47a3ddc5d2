//! The widgets of the workbench: plots, drawings and panes, as plain functions of plain data.
// Long because plots, drawings and panes are compared with the same few machines, drawn here once.

use dalembert_core::{
    Answer, AnswerValue, Axis, Cell, Check, Column, Draft, Drawing, DrawnShape, Entry, Exhibit, FieldError,
    Ink, LabelSide, Locale, Plot, Refusal, Scale, Series, Sides, Solution, SolveError, Stop, TableExhibit,
    Text, cases, find,
};
use dalembert_mechanics::sdof;
use dalembert_numerics::intervals::IntervalSet;
use dalembert_plugins as _;
use dalembert_tui::{
    drawing,
    glyphs::Colors,
    look::{Appearance, Theme},
    panes::{label_of, reasons, results, sources, table, working},
    plot::{self, Marker, PlotState},
    solver::CheckedCase,
};
use ratatui::{buffer::Buffer, layout::Rect, style::Color, text::Line};

const UNICODE: Appearance =
    Appearance { ascii: false, colors: Colors::Sixteen, theme: Theme::Terminal, basic: false, pixels: None };
const ASCII: Appearance = Appearance { ascii: true, ..UNICODE };
const BARE: Appearance = Appearance { colors: Colors::None, ..UNICODE };

/// Speed and largest amplitude of the fan: 40 kg, 0.1 kg·m, ωₙ = 106.23 rad/s, ζ = 0.0617.
const NATURAL: f64 = 106.23;
const ZETA: f64 = 0.061694;

fn amplitude(speed: f64) -> f64 {
    0.1 / 40.0 * sdof::unbalance_magnification(speed / NATURAL, ZETA)
}

fn fan() -> Plot {
    let curve = (0..=400).map(|n| 0.65 * f64::from(n)).map(|speed| (speed, amplitude(speed))).collect();
    let speed = 1000.0 * std::f64::consts::TAU / 60.0;
    Plot::new(
        "Steady-state amplitude against speed",
        Axis::linear("speed", "rpm"),
        Axis::linear("amplitude", "mm"),
        vec![Series::line("X", curve)],
    )
    .mark("at this speed", (speed, amplitude(speed)))
}

/// The fan with everything that a plot may hold.
fn full() -> Plot {
    let mut plot = fan().level("permitted", 0.005).band("keep out", 95.0, 118.0, false).band(
        "good",
        170.0,
        f64::INFINITY,
        true,
    );
    let measured =
        (1..12).map(|n| 20.0 * f64::from(n)).map(|speed| (speed, 1.02 * amplitude(speed))).collect();
    plot.series.push(Series::dots("measured", measured));
    plot
}

fn log(mut plot: Plot) -> Plot {
    (plot.x.scale, plot.y.scale) = (Scale::Log, Scale::Log);
    plot
}

fn drawn(
    plot: &Plot,
    state: &PlotState,
    look: &Appearance,
    locale: &Locale,
    (width, height): (u16, u16),
) -> String {
    screen(width, height, |area, buffer| {
        plot::render(plot, None, state, look, locale, area, buffer);
    })
}

fn screen(width: u16, height: u16, draw: impl FnOnce(Rect, &mut Buffer)) -> String {
    let area = Rect::new(0, 0, width, height);
    let mut buffer = Buffer::empty(area);
    draw(area, &mut buffer);
    rows(&buffer).join("\n")
}

fn rows(buffer: &Buffer) -> Vec<String> {
    (0..buffer.area.height)
        .map(|y| {
            (0..buffer.area.width).map(|x| buffer[(x, y)].symbol()).collect::<String>().trim_end().to_owned()
        })
        .collect()
}

fn text(lines: &[Line]) -> String {
    lines.iter().map(|line| line.to_string().trim_end().to_owned()).collect::<Vec<_>>().join("\n")
}

fn solved() -> (&'static Entry, Solution) {
    let entry = find("vibration/rotating-unbalance").expect("the bundle holds it");
    let case = cases::first(entry).expect("it has a case");
    let record = case.record(entry).expect("its inputs can be read");
    (entry, entry.solve(&record, &Stop::new()).expect("it has an answer"))
}

#[test]
fn a_plot_at_the_sizes_of_real_screens() {
    let (english, state) = (Locale::english(), PlotState::default());
    let cursor = PlotState { cursor: Some(104.7), ..state };
    insta::assert_snapshot!("plot_linear", drawn(&fan(), &state, &UNICODE, &english, (76, 20)));
    insta::assert_snapshot!("plot_full", drawn(&full(), &cursor, &UNICODE, &english, (76, 20)));
    insta::assert_snapshot!("plot_log", drawn(&log(full()), &cursor, &UNICODE, &english, (76, 20)));
    insta::assert_snapshot!("plot_ascii", drawn(&full(), &cursor, &ASCII, &english, (76, 20)));
    insta::assert_snapshot!("plot_small", drawn(&full(), &cursor, &UNICODE, &english, (38, 9)));
    let half = PlotState { marker: Marker::HalfBlock, ..state };
    insta::assert_snapshot!("plot_half_blocks", drawn(&fan(), &half, &UNICODE, &english, (50, 12)));
}

#[test]
fn portuguese_plots_have_decimal_commas() {
    let points = vec![(0.0, 0.0), (1.0, 1.25)];
    let line = Plot::new("", Axis::linear("", ""), Axis::linear("", ""), vec![Series::line("", points)]);
    let state = PlotState { cursor: Some(1.0), ..PlotState::default() };
    let shown = drawn(&line, &state, &UNICODE, &Locale::portuguese(), (60, 16));
    for words in ["0,5┤", "0,2 ", " = 1,25"] {
        assert!(shown.contains(words), "{words} in\n{shown}");
    }
    assert!(!shown.contains('.'), "{shown}");
}

#[test]
fn a_peak_keeps_its_height_however_many_points_there_are() {
    // A spike of one point among a million must reach the top of the plot.
    let mut points: Vec<(f64, f64)> = (0..1_000_000).map(|n| (f64::from(n), 1.0)).collect();
    points[654_321].1 = 100.0;
    let plot = Plot::new("", Axis::linear("x", ""), Axis::linear("y", ""), vec![Series::line("y", points)]);
    let area = Rect::new(0, 0, 60, 20);
    let mut buffer = Buffer::empty(area);
    plot::render(&plot, None, &PlotState::default(), &UNICODE, &Locale::english(), area, &mut buffer);
    let hundred = rows(&buffer).iter().position(|row| row.starts_with("100")).expect("the axis goes to 100");
    let spike: Vec<u16> = (4..60)
        .filter(|x| {
            buffer[(*x, hundred as u16)].symbol().chars().all(|c| ('\u{2801}'..='\u{28FF}').contains(&c))
        })
        .collect();
    // 56 cells of two dots behind an axis of 4: the last dot is the 111th after the first.
    assert_eq!(spike, [4 + (0.654_321f64 * 111.0).round() as u16 / 2]);
}

#[test]
fn a_value_that_is_no_number_breaks_the_line() {
    let ramp = |gap: f64| {
        let points = (0..=40).map(|n| (f64::from(n), if n == 20 { gap } else { 10.0 })).collect();
        let plot =
            Plot::new("", Axis::linear("x", ""), Axis::linear("y", ""), vec![Series::line("y", points)]);
        drawn(&plot, &PlotState::default(), &ASCII, &Locale::english(), (60, 12))
    };
    let whole = ramp(10.0);
    let stars = |drawn: &str| drawn.matches('*').count();
    for gap in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let broken = ramp(gap);
        // Two of forty steps are not drawn, 2.8 cells with an end each; nothing else moves.
        assert!((1..=3).contains(&(stars(&whole) - stars(&broken))), "{broken}");
        assert_eq!(broken.lines().filter(|line| line.contains('*')).count(), 1, "{broken}");
    }
}

#[test]
fn any_size_and_any_numbers_will_do() {
    let line = |points: Vec<(f64, f64)>| {
        Plot::new("title", Axis::linear("x", "m"), Axis::linear("y", "mm"), vec![Series::line("y", points)])
            .mark("mark", (1.0, 1.0))
            .level("level", 3.0)
            .band("band", f64::NEG_INFINITY, 0.5, false)
    };
    let mut plots = vec![
        line(vec![]),
        line(vec![(1.0, 1.0)]),
        line(vec![(0.0, 5.0), (1.0, 5.0), (2.0, 5.0)]),
        line(vec![(1e-300, 1e-300), (2e-300, 3e-300)]),
        line(vec![(-1e300, -1e300), (1e300, 1e300)]),
        line(vec![(f64::MIN, f64::MIN), (f64::MAX, f64::MAX)]),
        line(vec![(f64::NAN, 1.0), (1.0, f64::NAN), (f64::INFINITY, 2.0), (3.0, f64::NEG_INFINITY)]),
        line(vec![(9.0, 1.0), (5.0, 2.0), (1.0, -3.0), (6.0, 0.0)]),
        line(vec![(1e9, 1.0), (1e9 + 1e-6, 1.0 + 1e-15)]),
        full(),
    ];
    plots.extend(plots.clone().into_iter().map(log));
    // A level in decibels of what is zero, and a unit that does not exist.
    let mut odd = line(vec![(0.0, 0.0), (1.0, 1.0), (2.0, 10.0)]);
    (odd.y.unit, odd.x.unit) = ("dB", "no such unit");
    plots.push(odd);
    plots.push(Plot { marks: Vec::new(), levels: Vec::new(), ..line(vec![]) });
    let sizes = [(1, 1), (3, 2), (7, 3), (9, 5), (12, 4), (17, 6), (24, 8), (33, 9), (40, 11), (100, 40)];
    for (plot, marker) in
        plots.iter().zip([Marker::Braille, Marker::HalfBlock, Marker::Dot, Marker::Ascii].into_iter().cycle())
    {
        for cursor in [None, Some(1.0), Some(f64::NAN), Some(-1e308), Some(0.0)] {
            for look in [UNICODE, ASCII, BARE] {
                for (size, share) in
                    sizes.into_iter().zip([0.01, -0.3, 7.0, f64::NAN, 0.0].into_iter().cycle())
                {
                    let state = PlotState { cursor, marker, ..PlotState::default() }.moved(plot, share);
                    drawn(plot, &state, &look, &Locale::portuguese(), size);
                }
            }
        }
    }
    for width in 0..100 {
        for height in 0..40 {
            let state = PlotState { cursor: Some(104.7), ..PlotState::default() };
            drawn(&full(), &state, &UNICODE, &Locale::english(), (width, height));
        }
    }
}

#[test]
fn labels_of_an_axis_keep_their_distance() {
    for (from, to) in [(0.0, 1.0), (-5.0, 5.0), (1e-9, 3e-7), (12345.0, 12346.0), (-2e9, 7e12), (0.1, 1e6)] {
        for scale in [Scale::Linear, Scale::Log] {
            let points = (0..=50).map(|n| (from + (to - from) * f64::from(n) / 50.0, 1.0)).collect();
            let mut plot =
                Plot::new("", Axis::linear("x", ""), Axis::linear("y", ""), vec![Series::line("y", points)]);
            plot.x.scale = scale;
            for width in 20..100 {
                let drawn = drawn(&plot, &PlotState::default(), &ASCII, &Locale::english(), (width, 12));
                let lines: Vec<&str> = drawn.lines().collect();
                let axis = lines.iter().rposition(|line| line.contains("+--")).expect("there is an axis");
                let labels: Vec<&str> = lines[axis + 1].split_whitespace().collect();
                assert!(!labels.is_empty(), "{width}: {from} to {to}\n{drawn}");
                // Each word is one number: none ran into the next.
                for label in labels {
                    assert!(label.parse::<f64>().is_ok(), "`{label}`: {width}: {from} to {to}\n{drawn}");
                }
            }
        }
    }
}

#[test]
fn ticks_stand_at_their_values() {
    // A line from (0, 0) to (100, 100): its cell over the tick of x = 40 is in the row of the tick of y = 40.
    let points = (0..=100).map(|n| (f64::from(n), f64::from(n))).collect();
    let plot = Plot::new("", Axis::linear("x", ""), Axis::linear("y", ""), vec![Series::line("y", points)]);
    for width in [40u16, 53, 61, 78] {
        let drawn = drawn(&plot, &PlotState::default(), &ASCII, &Locale::english(), (width, 30));
        let lines: Vec<Vec<char>> = drawn.lines().map(|line| line.chars().collect()).collect();
        let row = drawn.lines().position(|line| line.trim_start().starts_with("40+")).expect("a tick at 40");
        let axis = drawn.lines().position(|line| line.contains("++-")).expect("an axis");
        let label = drawn.lines().nth(axis + 1).and_then(|line| line.find("40")).expect("a label 40");
        let tick = (label - 1..label + 3).find(|x| lines[axis][*x] == '+').expect("a tick over it");
        assert_eq!(lines[row].get(tick), Some(&'*'), "{width}\n{drawn}");
    }
}

#[test]
fn the_cursor_reads_what_was_computed() {
    let (plot, english) = (fan(), Locale::english());
    let first = PlotState::default().moved(&plot, 0.01);
    let read = |state: &PlotState, locale: &Locale| plot::readout(&plot, state, locale).unwrap();
    // It begins at the mark, which lies between two points of the curve: the line between them does not contradict it.
    assert_eq!(read(&first, &english), "speed = 1000 rpm   at this speed = 19.456 mm   X = 19.456 mm");
    let right = first.moved(&plot, 0.01);
    assert!(right.cursor > first.cursor);
    let (speed, read_out): (f64, String) = (right.cursor.unwrap(), read(&right, &Locale::portuguese()));
    let exact = format!("X = {:.3} mm", 1e3 * amplitude(speed)).replace('.', ",");
    assert!(read_out.contains(&exact), "{read_out} lacks {exact}");
    let back = right.moved(&plot, -1e-9).cursor.unwrap();
    assert!((speed - back - 0.65).abs() < 1e-9, "one stop back is one computed point: {speed} {back}");
    let last = first.moved(&plot, 9.0);
    assert_eq!(last.cursor, Some(0.65 * 400.0));
    assert_eq!(last.moved(&plot, 0.1).cursor, last.cursor);
    assert_eq!(last.without_cursor().cursor, None);
    // A cursor beyond the axis, as inputs change, is read at its end.
    let beyond = PlotState { cursor: Some(1e6), ..first };
    assert_eq!(read(&beyond, &english), read(&last, &english));
}

#[test]
fn the_markers_go_round() {
    let start = PlotState::default();
    let round = start.next_marker().next_marker().next_marker();
    assert_ne!(round.marker, start.marker);
    assert_eq!(round.next_marker(), start);
}

#[test]
fn a_limit_far_above_is_named_at_the_edge_and_does_not_flatten_the_curve() {
    let near =
        drawn(&fan().level("limit", 0.025), &PlotState::default(), &UNICODE, &Locale::english(), (70, 18));
    assert!(near.contains("limit") && !near.contains('▲'), "{near}");
    let far =
        drawn(&fan().level("limit", 3.0), &PlotState::default(), &UNICODE, &Locale::english(), (70, 18));
    assert!(far.contains("▲ limit: 3000 mm") && far.contains("20┤"), "{far}");
}

#[test]
fn curves_are_distinguished_with_and_without_colours() {
    let mut plot = fan();
    plot.series
        .push(Series::line("undamped", plot.series[0].points.iter().map(|at| (at.0, 0.5 * at.1)).collect()));
    let area = Rect::new(0, 0, 70, 18);
    let colors = |look: Appearance| {
        let mut buffer = Buffer::empty(area);
        plot::render(&plot, None, &PlotState::default(), &look, &Locale::english(), area, &mut buffer);
        let mut colors: Vec<Color> = buffer.content.iter().map(|cell| cell.fg).collect();
        colors.sort_by_key(|color| format!("{color}"));
        colors.dedup();
        (colors, rows(&buffer).join("\n"))
    };
    let (seen, _) = colors(UNICODE);
    assert!(seen.contains(&Color::Cyan) && seen.contains(&Color::LightMagenta), "{seen:?}");
    let (seen, drawn) = colors(BARE);
    assert_eq!(seen, [Color::Reset]);
    assert!(drawn.contains("── X") && drawn.contains("─◆─ undamped"), "{drawn}");
    let (_, drawn) = colors(ASCII);
    assert!(drawn.contains("* X  + undamped") && drawn.is_ascii(), "{drawn}");
}

#[test]
fn the_drawing_of_the_fan() {
    let (_, solution) = solved();
    let found = solution.exhibits.iter().find_map(|exhibit| match exhibit {
        Exhibit::Drawing(drawing) => Some(drawing),
        _ => None,
    });
    let machine = found.expect("the fan is drawn");
    for (look, unbalance) in [(UNICODE, "m₀e"), (ASCII, "m_0e")] {
        let drawn = screen(60, 20, |area, buffer| {
            drawing::render(machine, &look, &Locale::english(), area, buffer);
        });
        assert!(drawn.contains(unbalance), "{drawn}");
    }
}

#[test]
fn every_shape_at_every_size() {
    let shapes = vec![
        DrawnShape::Ground((-1.0, -1.5), (1.0, -1.5)),
        DrawnShape::Spring((-0.4, -1.5), (-0.4, -0.4), 5),
        DrawnShape::Damper((0.4, -1.5), (0.4, -0.4)),
        DrawnShape::Block((-0.8, -0.4), (0.8, 0.8), Ink::Body),
        DrawnShape::Circle((0.0, 0.2), 0.4, Ink::Faint),
        DrawnShape::Arc((0.0, 0.2), 0.5, 0.0, 1.5, Ink::Result),
        DrawnShape::Pin((1.6, -0.4)),
        DrawnShape::Polyline(vec![(1.6, -0.4), (2.6, 0.8)], Ink::Body),
        DrawnShape::Arrow((1.2, -0.3), (1.2, 0.7), Ink::Motion),
        DrawnShape::Label((1.2, 0.7), LabelSide::Right, "X".into()),
        DrawnShape::Label((2.6, 0.8), LabelSide::Right, "a rod".into()),
    ];
    let good = Drawing { title: "A machine".into(), shapes: shapes.clone().into() };
    let bad = Drawing {
        title: "Not a machine".into(),
        shapes: vec![
            DrawnShape::Circle((f64::NAN, 0.0), 1.0, Ink::Body),
            DrawnShape::Block((-1e308, -1e308), (1e308, 1e308), Ink::Body),
            DrawnShape::Arrow((0.0, 0.0), (f64::INFINITY, 1.0), Ink::Force),
            DrawnShape::Spring((1.0, 1.0), (1.0, 1.0), 5),
            DrawnShape::Arc((0.0, 0.0), 1e-300, 5.0, 1.0, Ink::Body),
            DrawnShape::Label((f64::NAN, 1.0), LabelSide::Right, "nowhere".into()),
            DrawnShape::Polyline(Vec::new(), Ink::Body),
        ]
        .into(),
    };
    let point = Drawing { title: "".into(), shapes: vec![DrawnShape::Pin((1e9, 1e9))].into() };
    let empty = Drawing { title: "".into(), shapes: Vec::new().into() };
    for look in [UNICODE, ASCII] {
        for (width, height) in (0..100u16).flat_map(|width| (0..40u16).map(move |height| (width, height))) {
            for drawing in [&good, &bad, &point, &empty] {
                if drawing != &good && (width % 7 != 0 || height % 5 != 0) {
                    continue;
                }
                screen(width, height, |area, buffer| {
                    drawing::render(drawing, &look, &Locale::english(), area, buffer);
                });
            }
        }
    }
    let shown = |look: &Appearance| {
        screen(64, 24, |area, buffer| {
            drawing::render(&good, look, &Locale::english(), area, buffer);
        })
    };
    insta::assert_snapshot!("drawing", shown(&UNICODE));
    insta::assert_snapshot!("drawing_ascii", shown(&ASCII));
}

#[test]
fn the_working_of_the_fan_at_every_width() {
    let (_, solution) = solved();
    for locale in [Locale::english(), Locale::portuguese()] {
        for look in [UNICODE, ASCII] {
            for width in 16..120u16 {
                let page = working::lines(&solution, &look, &locale, width);
                assert_eq!(page.starts.len(), solution.steps.len());
                for line in &page.lines {
                    assert!(line.width() <= width.into(), "{width}: {line}");
                }
            }
        }
    }
    let wide = text(&working::lines(&solution, &UNICODE, &Locale::english(), 100).lines);
    assert!(
        wide.contains(
            "    k = 3 E I / L³\n      = 3 × 200 kN/mm² × 1.3×10⁻⁶ m⁴ / (1.2 m)³\n      = 451.39 kN/m\n"
        ),
        "{wide}"
    );
    // Narrow lines hold the same formula, in pieces.
    let narrow = text(&working::lines(&solution, &UNICODE, &Locale::english(), 38).lines);
    assert!(
        narrow.contains("      = 3 × 200 kN/mm² × 1.3×10⁻⁶ m⁴\n          / (1.2 m)³\n      = 451.39 kN/m"),
        "{narrow}"
    );
    let portuguese = text(&working::lines(&solution, &UNICODE, &Locale::portuguese(), 60).lines);
    assert!(portuguese.contains("= 451,39 kN/m"), "{portuguese}");
}

#[test]
fn answers_stand_in_columns_with_their_checks() {
    let (_, solution) = solved();
    let shown = text(&results::lines(&solution, &UNICODE, &Locale::english(), 70));
    let column = |words: &str, of: &str| {
        let line =
            shown.lines().find(|line| line.contains(words)).unwrap_or_else(|| panic!("{words} in\n{shown}"));
        line.find(of).map(|at| line[..at].chars().count())
    };
    assert_eq!(column("19.456", "."), column("451.39", "."), "{shown}");
    assert_eq!(column("19.456", "mm"), column("451.39", "kN/m"), "{shown}");
    assert!(shown.contains("✓ amplitude from the dynamic stiffness"), "{shown}");
    for width in 1..100u16 {
        let lines = results::lines(&solution, &UNICODE, &Locale::portuguese(), width);
        assert!(
            lines.iter().all(|line| line.width() <= usize::from(width).max(16)),
            "{width}:\n{}",
            text(&lines)
        );
    }
}

#[test]
fn doubts_and_faults_are_not_passed_over() {
    let (_, mut solution) = solved();
    solution.warnings.push(Text::new("the speed is near the natural frequency"));
    solution.defects.push("k is in m·kg·s⁻², not in kN/m".into());
    solution.checks.push(Check {
        what: "a second method".into(),
        residual: 3e-4,
        limit: 1e-9,
        passed: false,
        sides: Sides::Plain,
    });
    let set = IntervalSet::interval(std::ops::Bound::Unbounded, std::ops::Bound::Included(0.1134));
    let unit = dalembert_units::unit("mm").unwrap();
    let value = AnswerValue::Set(set, vec!["the first critical speed".into()]);
    let answer = solution.answers[0].clone();
    solution.answers.push(Answer {
        name: "diameter".into(),
        label: "Permitted diameters",
        value,
        unit,
        ..answer
    });
    let shown = text(&results::lines(&solution, &UNICODE, &Locale::english(), 70));
    let place = |words: &str| shown.find(words).unwrap_or_else(|| panic!("{words} in\n{shown}"));
    assert!(place("✗ Internal error") < place("k is in m·kg·s⁻²"));
    assert!(place("k is in m·kg·s⁻²") < place("Stiffness of the support"));
    assert!(place("≤ 113.4 mm") < place("· the first critical speed"));
    assert!(
        place("! the speed is near") < place("✗ a second method  FAILED: a second method differs by 3×10⁻⁴")
    );
    assert!(place("✗ a second method") < place("✓"), "what failed comes first");
    let stale = reasons::stale(
        results::lines(&solution, &UNICODE, &Locale::english(), 70),
        &UNICODE,
        &Locale::english(),
        70,
    );
    assert_eq!(stale[0].to_string(), "! results for the previous, complete inputs");
}

#[test]
fn a_refusal_is_said_in_words() {
    let error = SolveError::Refused(Refusal::NoAnswer("there is no steady state".into()));
    let shown = text(&reasons::refusal(None, &error, &UNICODE, &Locale::english(), 40));
    assert_eq!(shown, "No solution\n\nthere is no steady state");
    let (entry, _) = solved();
    let mut draft = cases::first(entry).unwrap().draft;
    if let Draft::Group(fields) = &mut draft {
        fields.clear();
    }
    let Err(errors) = draft.read(&entry.shape()) else { panic!("an empty form was read") };
    let shown = text(&reasons::refusal(None, &SolveError::Fields(errors), &UNICODE, &Locale::english(), 60));
    assert!(shown.contains("✗ mass: "), "{shown}");
}

#[test]
fn cases_are_shown_with_their_verdicts() {
    let (entry, _) = solved();
    let cases: Vec<CheckedCase> = cases::cases(entry)
        .unwrap()
        .into_iter()
        .map(|case| CheckedCase { verdicts: Some(case.verify(entry)), case })
        .collect();
    let page = sources::lines(entry, &cases, Some(0), Some(&[]), &UNICODE, &Locale::english(), 90);
    let shown = text(&page.lines);
    assert_eq!(page.starts.len(), cases.len());
    assert!(page.lines[page.starts[0]].to_string().starts_with("▸ 1  "), "{shown}");
    for words in ["106.23 rad/s", "agreed", "disputed", "0.707", "S. S. Rao, Mechanical Vibrations"] {
        assert!(shown.contains(words), "{words} in\n{shown}");
    }
    for width in 24..120u16 {
        let page = sources::lines(entry, &cases, None, Some(&[]), &UNICODE, &Locale::portuguese(), width);
        assert!(
            page.lines.iter().all(|line| line.width() <= width.into()),
            "{width}:\n{}",
            text(&page.lines)
        );
    }
    let waiting = CheckedCase { verdicts: None, ..cases[0].clone() };
    let shown =
        text(&sources::lines(entry, &[waiting], None, Some(&[]), &UNICODE, &Locale::english(), 90).lines);
    assert!(shown.contains("not compared yet"));
}

#[test]
fn a_table_is_aligned_and_none_of_its_columns_is_lost() {
    let column = |heading: &'static str, unit| Column { heading: heading.into(), unit };
    let balance = TableExhibit {
        title: "Balance of moments".into(),
        columns: vec![
            column("mass", ""),
            column("m", "kg"),
            column("m r cos θ", "kg*mm"),
            column("m r L sin θ", "kg*m^2"),
        ],
        rows: vec![
            vec!["A".into(), 10.0.into(), 0.5.into(), (-0.0123).into()],
            vec!["correction".into(), 0.123.into(), (-0.0125).into(), Cell::Empty],
        ],
        foot: vec!["Σ".into(), Cell::Empty, 0.4875.into(), 0.3.into()],
    };
    let wide = text(&table::lines(&balance, &UNICODE, &Locale::english(), 80));
    insta::assert_snapshot!("table", wide);
    for width in 12..80u16 {
        let lines = table::lines(&balance, &UNICODE, &Locale::portuguese(), width);
        let shown = text(&lines);
        assert!(lines.iter().all(|line| line.width() <= width.into()), "{width}:\n{shown}");
        for words in ["10", "0,123", "−12,5", "487,5", "−0,0123", "[kg·m²]"] {
            assert!(shown.contains(words), "{words} at {width} in\n{shown}");
        }
    }
}

#[test]
fn every_block_of_a_table_names_its_rows() {
    let column = |heading: &'static str| Column { heading: heading.into(), unit: "mm" };
    let names = Column { heading: "Method of computation".into(), unit: "" };
    let table = TableExhibit {
        title: "".into(),
        columns: [
            vec![names],
            ["Maximum amplitude", "Minimum amplitude", "Mean amplitude"].map(column).into(),
        ]
        .concat(),
        rows: vec![vec!["Newton's second law".into(), 1.0.into(), 2.0.into(), 3.0.into()]],
        foot: Vec::new(),
    };
    // Names get half the width where they need it; at 32 cells, that shows eleven letters.
    for width in 32..90 {
        let lines = table::lines(&table, &UNICODE, &Locale::english(), width);
        let shown = text(&lines);
        let headings = shown.lines().filter(|line| line.contains("amplitude")).count();
        let named = shown.lines().filter(|line| line.starts_with("Newton's se")).count();
        assert_eq!(named, headings, "{width}:\n{shown}");
        assert!(lines.iter().all(|line| line.width() <= width.into()), "{width}:\n{shown}");
        for heading in ["Maximum", "Minimum", "Mean"] {
            assert!(shown.contains(heading), "{heading} at {width}:\n{shown}");
        }
    }
}

#[test]
fn one_long_label_does_not_undo_the_columns() {
    let (_, mut solution) = solved();
    let long = "Maximum amplitude of the machine at any speed that its motor can reach";
    solution.answers.push(Answer { label: long, ..solution.answers[0].clone() });
    let shown = text(&results::lines(&solution, &UNICODE, &Locale::english(), 70));
    let column = |words: &str, of: &str| {
        let line = shown.lines().find(|line| line.contains(words)).expect("the line is there");
        line.find(of).map(|at| line[..at].chars().count()).expect("the line holds it")
    };
    assert_eq!(column("Natural frequency", "rad/s"), column("Amplitude at this speed", "mm"), "{shown}");
    assert_eq!(column("Phase lag", "°"), column("Amplitude at this speed", "mm"), "{shown}");
    assert_eq!(column("Phase lag", "."), column("Amplitude at this speed", "."), "{shown}");
    assert!(
        shown.contains("Maximum amplitude of the machine at any\nspeed that its motor can reach "),
        "{shown}"
    );
}

#[test]
fn fields_are_named_by_their_labels() {
    let (entry, _) = solved();
    let label = |path: &str, locale: Locale| label_of(&entry.shape(), path, &locale);
    assert_eq!(label("mass", Locale::english()).as_deref(), Some("Mass of the machine"));
    let length = label("support.cantilever.length", Locale::english());
    assert_eq!(length.as_deref(), Some("Length"));
    assert_ne!(label("mass", Locale::portuguese()), label("mass", Locale::english()));
    for path in ["", "no_such_field", "mass.x", "support.cantilever.no_such_field", "mass[1]", "[[]."] {
        assert_eq!(label(path, Locale::english()), None, "{path}");
    }
    let errors = vec![
        FieldError::new("mass", "it must be positive"),
        FieldError::new("nowhere", "it must be positive"),
    ];
    let shape = entry.shape();
    let error = SolveError::Fields(errors);
    let shown = text(&reasons::refusal(Some(&shape), &error, &UNICODE, &Locale::english(), 60));
    assert!(shown.contains("✗ Mass of the machine: it must be positive"), "{shown}");
    assert!(shown.contains("✗ nowhere: it must be positive"), "{shown}");
}

#[test]
fn verdicts_are_written_as_everything_else_is() {
    let (entry, solution) = solved();
    let case = cases::first(entry).unwrap();
    let mut verdicts = case.verify(entry).unwrap();
    (verdicts[0].printed, verdicts[0].computed) = ("-1.5e-3 m s^-1".into(), "−1.5004 m/s".into());
    let judged = [CheckedCase { verdicts: Some(Ok(verdicts)), case }];
    let shown = |look: &Appearance, locale: &Locale| {
        text(&sources::lines(entry, &judged, None, Some(&solution.answers), look, locale, 100).lines)
    };
    let english = shown(&UNICODE, &Locale::english());
    assert!(english.contains("✓ Natural frequency "), "{english}");
    assert!(english.contains(" −1.5e-3 m s^-1  −1.5004 m/s "), "{english}");
    let portuguese = shown(&UNICODE, &Locale::portuguese());
    assert!(portuguese.contains(" −1,5e-3 m s^-1  −1,5004 m/s "), "{portuguese}");
    let ascii = shown(&ASCII, &Locale::english());
    assert!(ascii.contains(" -1.5e-3 m s^-1  -1.5004 m/s "), "{ascii}");
}

#[test]
fn long_titles_go_on_in_a_second_line() {
    let title = "Steady-state amplitude of the machine against the speed of its motor";
    let plot = Plot { title: title.into(), ..fan() };
    let drawing = Drawing { title: title.into(), shapes: vec![DrawnShape::Pin((0.0, 0.0))].into() };
    let whole = |screen: &str| {
        let lines: Vec<&str> = screen.lines().take(2).map(str::trim).collect();
        lines.join(" ") == title
    };
    let sketch = |height| {
        screen(40, height, |area, buffer| {
            drawing::render(&drawing, &UNICODE, &Locale::english(), area, buffer);
        })
    };
    let curve = |height| drawn(&plot, &PlotState::default(), &UNICODE, &Locale::english(), (40, height));
    assert!(whole(&curve(20)) && whole(&sketch(20)));
    for low in [curve(10), sketch(10)] {
        assert!(low.lines().next().unwrap().ends_with('…'), "{low}");
    }
}

#[test]
fn marks_are_seen_on_their_curves_in_ascii() {
    let plot = fan().mark("at half of it", (50.0, amplitude(50.0)));
    let shown = drawn(&plot, &PlotState::default(), &ASCII, &Locale::english(), (76, 20));
    assert_eq!(shown.matches('@').count(), 2, "{shown}");
    assert!(shown.contains("at this speed") && shown.contains("at half of it"), "{shown}");
    let cursor = PlotState { cursor: Some(200.0), ..PlotState::default() };
    let shown = drawn(&plot, &cursor, &ASCII, &Locale::english(), (76, 20));
    assert_eq!(shown.matches('O').count(), 1, "{shown}");
}

#[test]
fn the_panes_speak_portuguese() {
    let locale = Locale::portuguese();
    let (_, mut solution) = solved();
    solution.defects.push("k".into());
    solution.checks.push(Check {
        what: "k".into(),
        residual: 3e-4,
        limit: 1e-9,
        passed: false,
        sides: Sides::Plain,
    });
    let shown =
        text(&reasons::stale(results::lines(&solution, &UNICODE, &locale, 90), &UNICODE, &locale, 90));
    for words in [
        "! resultados dos dados anteriores, completos",
        "✗ Erro interno do programa",
        "outro método difere em 3×10⁻⁴",
    ] {
        assert!(shown.contains(words), "{words} in\n{shown}");
    }
    let error = SolveError::Refused(Refusal::NoAnswer("k".into()));
    assert!(text(&reasons::refusal(None, &error, &UNICODE, &locale, 40)).starts_with("Sem solução"));
    let nothing = Plot::new("", Axis::linear("", ""), Axis::linear("", ""), Vec::new());
    assert!(drawn(&nothing, &PlotState::default(), &UNICODE, &locale, (40, 5)).contains("nada a desenhar"));
    for words in [
        "verified by a second method",
        "verified by a second method (relative difference {difference})",
        "Some inputs cannot be read",
        "Solution cancelled.",
        "Published cases",
        "Books and notes",
        "not compared yet",
        "published",
        "closed form",
        "other program",
        "regression value",
        "published",
        "computed",
        "agreed",
        "disputed",
        "differing",
        "refusal",
        "permitted",
        "forbidden",
    ] {
        assert!(dalembert_core::text::is_translated(words), "{words}");
    }
}
