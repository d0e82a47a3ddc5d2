//! The mouse: a click goes there, a second one enters, the wheel moves what is under the pointer.

use dalembert_tests::person::Person;
use dalembert_tui::{keys::KeyContext, look::Theme, panes::plot::Plot, plot::PlotState};
use ratatui::crossterm::event::{MouseButton, MouseEventKind};

const FAN: &str = "vibration/rotating-unbalance";

fn fan(columns: u16, rows: u16) -> Person {
    Person::at(columns, rows).opens(FAN)
}

#[test]
fn a_click_goes_there_and_a_second_one_enters() {
    let mut person = fan(90, 30);
    person.clicks("0.1 kg");
    assert_eq!(person.model.place(), KeyContext::Form);
    assert!(person.sees().contains("▸ Unbalance"), "{}", person.sees());
    person.clicks("0.1 kg");
    assert_eq!(person.model.place(), KeyContext::Edit);
    person.types("<esc>");
    person.clicks("Working");
    assert_eq!(person.model.place().id(), "working");
    person.clicks("Plot");
    assert_eq!(person.model.place().id(), "plot");
    // A key of the footer: what is clicked is done.
    person.clicks("Tab edit inputs");
    assert_eq!(person.model.place(), KeyContext::Form);
    // Of two keys side by side each is its own.
    let tab = |person: &Person| person.model.bench.as_ref().map(|bench| bench.tab);
    let before = tab(&person);
    let (column, row) = person.place_of("[ ] tabs");
    person.mouse(MouseEventKind::Down(MouseButton::Left), (column + 2, row));
    assert_ne!(tab(&person), before);
    // The keys are in the pane now, and the footer is that of the pane.
    let place = person.place_of("[ ] tabs");
    person.mouse(MouseEventKind::Down(MouseButton::Left), place);
    assert_eq!(tab(&person), before);
}

#[test]
fn a_dialog_is_chosen_from_and_left_by_the_mouse() {
    let mut person = fan(90, 30);
    person.types(":");
    person.clicks("clear and edit");
    assert!(person.sees().contains("▸ clear and edit"), "{}", person.sees());
    person.clicks("clear and edit");
    assert_eq!(person.model.place(), KeyContext::Edit);
    person.types("<esc>?");
    let before = person.sees();
    person.mouse(MouseEventKind::ScrollDown, (10, 10));
    assert_ne!(person.sees(), before);
    person.types("<esc>:theme<enter>");
    person.clicks(" light ");
    person.clicks(" light ");
    assert_eq!(person.model.look.theme, Theme::Light);
    // Beside it the palette is left, a question is not.
    person.types(":");
    person.mouse(MouseEventKind::Down(MouseButton::Left), (85, 3));
    assert!(person.model.dialog.is_none());
    person.types(":theme<enter>");
    person.mouse(MouseEventKind::Down(MouseButton::Left), (1, 3));
    assert!(person.model.dialog.is_some());
}

#[test]
fn the_wheel_moves_what_is_under_the_pointer() {
    let mut person = fan(110, 20);
    person.clicks("Working");
    person.clicks("Mass");
    let before = person.sees();
    person.mouse(MouseEventKind::ScrollDown, (70, 10));
    assert_ne!(person.sees(), before);
    assert_eq!(person.model.place(), KeyContext::Form, "the focus stays");
    person.mouse(MouseEventKind::ScrollUp, (70, 10));
    assert_eq!(person.sees(), before);
}

#[test]
fn a_plot_is_pointed_at_zoomed_and_dragged() {
    let mut person = fan(90, 30);
    person.clicks("Plot");
    let state =
        |person: &Person| -> Option<PlotState> { Some(person.model.bench.as_ref()?.find::<Plot>()?.state()) };
    let cursor = |person: &Person| state(person).and_then(|state| state.cursor);
    let window = |person: &Person| state(person).and_then(|state| state.view.window);
    assert_eq!(cursor(&person), None);
    person.mouse(MouseEventKind::Down(MouseButton::Left), (60, 15));
    let first = cursor(&person).expect("a cursor");
    person.mouse(MouseEventKind::Drag(MouseButton::Left), (75, 15));
    let dragged = cursor(&person).expect("a cursor");
    assert!(dragged > first, "{dragged} {first}");
    person.mouse(MouseEventKind::Up(MouseButton::Left), (75, 15));
    person.mouse(MouseEventKind::ScrollUp, (75, 15));
    let (from, to) = window(&person).expect("a part of the axis");
    assert_eq!(cursor(&person), Some(dragged), "the cursor stays");
    assert!(from < dragged && dragged < to);
    person.mouse(MouseEventKind::Down(MouseButton::Left), (60, 15));
    person.mouse(MouseEventKind::Drag(MouseButton::Left), (70, 15));
    let (moved, _) = window(&person).expect("a part of the axis");
    assert!(moved < from, "what is shown follows the pointer: {moved} {from}");
    person.mouse(MouseEventKind::ScrollDown, (60, 15));
    assert_eq!(window(&person), None);
}

#[test]
fn answers_to_be_checked_are_clicked_and_typed() {
    let mut person = fan(110, 14);
    person.turns_to("Check").clicks("Natural frequency");
    assert!(person.model.place() == KeyContext::Cells && person.sees().contains("▸ Natural frequency"));
    person.clicks("Natural frequency").types("106.23");
    // A click into the cell that is typed in changes nothing, one beside it keeps the text.
    person.clicks("Natural frequency");
    assert_eq!(person.model.place(), KeyContext::Cell);
    person.clicks("Damping ratio");
    assert!(person.sees().contains("▸ Damping ratio") && person.sees().contains("= 106.23 rad/s"));
    person.clicks("Damping ratio").types("0.0617").clicks("0.1 kg");
    assert_eq!(person.model.place(), KeyContext::Form);
    assert!(person.sees().contains("= 0.061694"), "{}", person.sees());
    // What lies further up is a turn of the wheel away.
    let over = person.place_of("Damping ratio");
    assert!(!person.sees().contains("Force transmitted"), "{}", person.sees());
    for _ in 0..3 {
        person.mouse(MouseEventKind::ScrollUp, over);
    }
    person.clicks("Force transmitted");
    assert!(person.sees().contains("▸ Force transmitted"), "{}", person.sees());
}

#[test]
fn inputs_and_answers_of_the_sensitivity_are_clicked() {
    let mut person = fan(90, 30);
    person.turns_to("Sensitivity").types("<right><right><right>").clicks("Young's modulus ");
    let screen = person.sees();
    assert!(screen.contains("▸ Young's modulus") && screen.contains("elasticity 0.5"), "{screen}");
    // The lines below a row belong to it.
    person.clicks("elasticity").types("2 %<enter>");
    assert!(person.sees().contains(" 2 % "), "{}", person.sees());
    person.clicks("◀ Natural frequency");
    assert!(person.sees().contains("◀ Stiffness of the support"), "{}", person.sees());
    person.clicks("Stiffness of the support ▶");
    assert!(person.sees().contains("◀ Natural frequency"), "{}", person.sees());
    // What all of them do together is no input.
    let cursor = |person: &mut Person| {
        let bench = person.model.bench.as_mut()?;
        bench.cursor(bench.tab).copied()
    };
    let place = cursor(&mut person);
    person.clicks("all tolerances:");
    assert_eq!(cursor(&mut person), place);
    let mut low = fan(90, 12);
    low.turns_to("Sensitivity");
    let over = low.place_of("for +1 %");
    for _ in 0..5 {
        low.mouse(MouseEventKind::ScrollDown, over);
    }
    assert!(low.sees().contains("all tolerances"), "{}", low.sees());
}

#[test]
fn cells_of_a_study_are_clicked() {
    let mut person = fan(90, 30);
    person.turns_to("Study").clicks("20..60 kg");
    assert!(person.sees().contains("▸ Mass of the machine"), "{}", person.sees());
    person.clicks("20..60 kg").types("<c-u>30..80 kg").clicks("Answer");
    assert!(person.sees().contains("▸ Answer") && person.sees().contains("30..80 kg"), "{}", person.sees());
    person.clicks("Answer");
    assert!(person.sees().contains("Force transmitted to the foundation ▾"), "{}", person.sees());
    // Its curve is no cell.
    person.clicks("current value");
    assert!(person.sees().contains("▸ Answer"), "{}", person.sees());
}

#[test]
fn cases_beside_the_list_are_clicked() {
    let mut person = Person::at(100, 30).knows(&[FAN, "vibration/free-vibration"]);
    person.types("/rotunb<tab>");
    let cases = person.model.listings[0].cases().len();
    assert!(cases > 2, "{cases}");
    let place = person.place_of("Cases");
    let of = |person: &Person| person.model.picker.case;
    person.clicks("Fan on a cantilever, corr");
    assert_eq!(of(&person), Some(1));
    // Neither the heading nor the drawing is a case.
    person.clicks("Cases");
    assert_eq!((of(&person), person.model.bench.is_some()), (Some(1), false));
    person.mouse(MouseEventKind::ScrollDown, place);
    assert_eq!(of(&person), Some(2));
    person.mouse(MouseEventKind::ScrollUp, place);
    person.clicks("Fan on a cantilever, corr");
    assert_eq!(person.model.bench.as_ref().map(|bench| bench.problem.case), Some(1));
    // The wheel goes to the cases, where the list has the keys.
    let mut person = Person::at(100, 30).knows(&[FAN, "vibration/free-vibration"]);
    person.types("/rotunb<tab>");
    let place = person.place_of("Cases");
    person.mouse(MouseEventKind::ScrollDown, place);
    assert_eq!(of(&person), Some(1));
}

/// The curves are read under the pointer, with units, as long as it is over the plot; the cursor stays.
#[test]
fn a_plot_is_read_under_the_pointer() {
    let mut person = fan(80, 24);
    let before = person.types("<tab>]]").sees();
    assert!(before.contains("speed of the machine [rpm]"), "{before}");
    let (column, row) = person.place_of("speed of the machine [rpm]");
    person.mouse(MouseEventKind::Moved, (column + 4, row - 6));
    let read = person.sees();
    assert!(
        read.contains("speed of the machine = ") && read.contains(" rpm") && read.contains("X = "),
        "{read}"
    );
    assert!(read.contains(" mm"), "{read}");
    person.mouse(MouseEventKind::Moved, (column + 12, row - 6));
    assert_ne!(person.sees(), read, "farther right another speed is read");
    person.mouse(MouseEventKind::Moved, (2, 3));
    assert_eq!(person.sees(), before, "elsewhere nothing is read");
}
