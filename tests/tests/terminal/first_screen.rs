//! First screens of every analysis: nothing is cut, and no pane is left empty.

use dalembert_core::{Entry, exams::exams, registry};
use dalembert_tests::{person::Person, times};
use dalembert_tui::{form::Role, pane::Content, seen_panes};

/// Rows at the foot of the screen: what is said of the field under the cursor may be longer than the line.
const FOOT: usize = 2;

/// The user before the first screen of an analysis.
fn before(entry: &Entry, portuguese: bool, columns: u16, rows: u16) -> Person {
    let person = if portuguese { Person::in_portuguese(columns, rows) } else { Person::at(columns, rows) };
    person.opens(entry.about.id)
}

#[test]
fn no_word_of_a_first_screen_is_cut() {
    let mut cut = Vec::new();
    for entry in registry() {
        for (columns, rows) in [(80, 24), (160, 45)] {
            for portuguese in [false, true] {
                let lines = cut_lines(&before(entry, portuguese, columns, rows).sees());
                let line = |line| format!("{} {columns}×{rows}: {line}", entry.about.id);
                cut.extend(lines.into_iter().map(line));
            }
        }
    }
    assert!(cut.is_empty(), "{} lines\n{}", cut.len(), cut.join("\n"));
}

/// The lines of a screen above its foot that something was cut from. The mark of that follows a
/// letter; alone it stands between the ends of an interval.
fn cut_lines(screen: &str) -> Vec<String> {
    let lines = screen.lines().count();
    let body = screen.lines().take(lines - FOOT);
    let is_cut = |line: &&str| {
        line.char_indices().any(|(at, c)| c == '…' && line[..at].ends_with(char::is_alphanumeric))
    };
    let cut = body.filter(is_cut);
    cut.map(|line| line.trim().to_owned()).collect()
}

#[test]
fn no_option_of_a_form_is_cut() {
    let mut cut = Vec::new();
    let mut opened = 0;
    for entry in registry() {
        for portuguese in [false, true] {
            let mut person = before(entry, portuguese, 80, 24);
            let form =
                |person: &Person| person.model.bench.as_ref().map(|bench| bench.problem.inputs.form.lines());
            let lines = form(&person).expect("a problem is open");
            for line in lines {
                if matches!(line.role, Role::Choice { .. }) {
                    person.types("<enter>");
                    opened += 1;
                    cut.extend(
                        cut_lines(&person.sees())
                            .into_iter()
                            .map(|line| format!("{}: {line}", entry.about.id)),
                    );
                    person.types("<esc>");
                }
                person.types("<down>");
            }
        }
    }
    assert!(opened > 300, "{opened} lists of options");
    assert!(cut.is_empty(), "{} lines\n{}", cut.len(), cut.join("\n"));
}

#[test]
fn no_line_of_a_tab_is_cut() {
    let mut cut = Vec::new();
    // Sensitivities and studies are solved on the way: one analysis in six, all of them in the soak.
    for entry in registry().iter().step_by(6_usize.div_ceil(times())) {
        let mut person = before(entry, false, 80, 24);
        let tabs = person.model.bench.as_ref().map_or(0, |bench| bench.tabs().len());
        for _ in 0..tabs {
            let bench = person.model.bench.as_ref().expect("a problem is open");
            if bench.shown().content() != Content::Picture {
                let name = bench.shown().name();
                cut.extend(
                    cut_lines(&person.sees())
                        .into_iter()
                        .map(|line| format!("{} {name}: {line}", entry.about.id)),
                );
            }
            person.types("]");
        }
    }
    assert!(cut.is_empty(), "{} lines\n{}", cut.len(), cut.join("\n"));
}

#[test]
fn no_pane_of_a_first_screen_is_a_third_blank() {
    let mut blank = Vec::new();
    for entry in registry().iter().chain(exams()) {
        for (columns, rows) in [(80, 24), (120, 36), (160, 45), (200, 60)] {
            let mut person = before(entry, false, columns, rows);
            let lines: Vec<String> = person.sees().lines().map(str::to_owned).collect();
            for (name, content, area) in seen_panes(&person.model) {
                let inside = area.y + 1..area.bottom() - 1;
                let is_blank = |y: &u16| {
                    let line = lines.get(usize::from(*y)).map_or("", String::as_str);
                    let cells = line.chars().skip(usize::from(area.x) + 1).take(usize::from(area.width) - 2);
                    cells.clone().all(char::is_whitespace)
                };
                // The free lines between parts of a text are no room for anything else: those at its end are, and those
                // above and below a drawing.
                let above = match content {
                    Content::Picture => inside.clone().skip(1).take_while(is_blank).count(),
                    Content::Text | Content::Cells => 0,
                };
                let empty = above + inside.clone().rev().take_while(is_blank).count();
                // A row is rounding.
                if 3 * empty > inside.len() + 1 {
                    blank.push(format!(
                        "{} {columns}×{rows}: {name} {empty} of {}",
                        entry.about.id,
                        inside.len()
                    ));
                }
            }
        }
    }
    assert!(blank.is_empty(), "{} panes\n{}", blank.len(), blank.join("\n"));
}
