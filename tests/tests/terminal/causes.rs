//! The search for the cause of a wrong answer while it goes on.

use std::cell::RefCell;

use dalembert_core::Stop;
use dalembert_tests::person::Person;
use dalembert_tui::{
    Effect, Msg,
    solver::{Job, solve},
};

use crate::studies::{at, presses};

const FAN: &str = "vibration/rotating-unbalance";
/// The amplitude of the fan with the damping that its book assumes: an error that its analysis knows.
const ASSUMED: &str = "assumed ζ = 0.707";

/// The fan with that amplitude typed into Check, and the search for its cause.
fn with_a_wrong_amplitude() -> (Person, Job) {
    let mut person = at(Person::at(120, 40).opens(FAN), "Check");
    person.types("<home>1.74");
    let [Effect::Ask(job)] = &presses(&mut person, "3")[..] else { panic!("nothing is asked") };
    let job = job.clone();
    (person, job)
}

#[test]
fn the_first_cause_is_seen_before_the_search_is_over() {
    let (mut person, job) = with_a_wrong_amplitude();
    assert!(!person.sees().contains(ASSUMED), "{}", person.sees());
    let so_far = RefCell::new(Vec::new());
    let last = solve(&job, &Stop::new(), &|outcome| so_far.borrow_mut().push(outcome)).unwrap();
    let so_far = so_far.into_inner();
    assert!(so_far.len() > 1, "{so_far:?}");
    for outcome in so_far.iter().cloned() {
        let screen = person.happens(Msg::Asked(outcome)).sees();
        let words = ["Likely cause:", ASSUMED, "searching further", "solving; Esc cancels"];
        assert!(words.iter().all(|words| screen.contains(words)), "{screen}");
    }
    let screen = person.happens(Msg::Asked(last)).sees();
    assert!(
        screen.contains(ASSUMED) && !screen.contains("searching") && !screen.contains("cancels"),
        "{screen}"
    );
    // What another search had found so far is not wanted any more.
    person.types("<bs>9");
    let before = person.sees();
    assert_eq!(person.happens(Msg::Asked(so_far[0].clone())).sees(), before);
}

#[test]
fn escape_ends_the_search() {
    let (mut person, job) = with_a_wrong_amplitude();
    // The signal is given with the first report: there is no last one.
    let (stop, first) = (Stop::new(), RefCell::new(None));
    let last = solve(&job, &stop, &|outcome| {
        stop.stop();
        first.borrow_mut().get_or_insert(outcome);
    });
    assert!(last.is_none());
    person.happens(Msg::Asked(first.into_inner().unwrap())).types("<enter>");
    assert!(person.sees().contains("searching further"), "{}", person.sees());
    assert!(matches!(presses(&mut person, "<esc>")[..], [Effect::Cancel]));
    let screen = person.sees();
    assert!(screen.contains("Check cancelled") && screen.contains("incorrect"), "{screen}");
    assert!(!screen.contains("searching") && !screen.contains(ASSUMED), "{screen}");
    // Turned to, it is searched to the end.
    let screen = person.types("[]").sees();
    assert!(screen.contains(ASSUMED) && !screen.contains("cancelled"), "{screen}");
}

#[test]
fn another_value_ends_the_search_for_the_cause_of_the_first() {
    let (mut person, first) = with_a_wrong_amplitude();
    let [Effect::Ask(second)] = &presses(&mut person, "5")[..] else { panic!("nothing is asked") };
    // The solver stops what is older.
    assert!(second.generation > first.generation);
    assert!(person.sees().contains("searching for a common error"), "{}", person.sees());
    // A right value needs no cause.
    presses(&mut person, "<c-u>");
    for key in ["1", "9", ".", "4", "5"] {
        presses(&mut person, key);
    }
    assert!(matches!(presses(&mut person, "6")[..], [Effect::Cancel]), "{}", person.sees());
    assert!(!person.sees().contains("searching"), "{}", person.sees());
}
