//! Exercises of a list: statement, covered results, hints, a wrong and then the right answer.

use dalembert_core::{
    Locale, Stop, Text,
    cases::{self, Case},
    exercises, find,
};
use dalembert_plugins as _;
use dalembert_tests::person::Person;
use dalembert_tui::{
    picker::{Heading, Row},
    remembered::{HistoryChange, Progress},
};

const FAN: (&str, &str) = ("vibration/rotating-unbalance", "Fan on a cantilever");

/// Goes to an exercise of a list by its keys.
fn goes_to(person: &mut Person, (analysis, case): (&str, &str)) {
    let find_row = |person: &Person, wanted: &dyn Fn(&Row) -> bool| {
        let rows = person.model.picker.rows(person.model.contents());
        rows.iter().position(wanted).unwrap_or_else(|| panic!("there is no row of {analysis}: {case}"))
    };
    let to = |person: &mut Person, row: usize| {
        person.types("<home>").types(&"<down>".repeat(row));
    };
    let set = person.model.sets.iter().position(|set| {
        set.list.iter().any(|exercise| exercise.analysis == analysis && exercise.case == case)
    });
    let set = Heading::Set(set.expect("it is in a list"));
    person.types("<esc><home>");
    for heading in [Heading::Exercises, set] {
        let row = find_row(person, &|row| *row == Row::Heading(heading));
        to(person, row);
        person.types("<right>");
        if !person.model.picker.is_open(heading, &person.model.listings) {
            person.types("<right>");
        }
    }
    let is_it = |person: &Person, row: &Row| match row {
        Row::Leaf(leaf) if leaf.under == Some(set) => {
            let listing = &person.model.listings[leaf.listing];
            let name = leaf.case.and_then(|case| listing.cases().get(case)).map(|case| case.name.as_str());
            listing.entry.about.id == analysis && name == Some(case)
        }
        _ => false,
    };
    let row = find_row(person, &|row| is_it(person, row));
    to(person, row);
}

/// The screen as one line of words, without frames.
fn words(person: &mut Person) -> String {
    let screen = person.sees();
    let plain: String = screen.chars().map(|c| if "│╭╮╰╯─".contains(c) { ' ' } else { c }).collect();
    plain.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[test]
fn an_exercise_shows_its_statement_and_covers_its_results() {
    let mut person = Person::at(80, 24);
    goes_to(&mut person, FAN);
    let screen = words(&mut person);
    assert!(
        screen.contains("A fan of 40 kg stands on") && screen.contains("Fan on a cantilever"),
        "{screen}"
    );
    assert!(!screen.contains("19.46"), "{screen}");
    person.types("<enter>");
    let screen = words(&mut person);
    assert!(
        screen.contains("Statement") && screen.contains("A fan of 40 kg stands on the free end"),
        "{screen}"
    );
    assert!(screen.contains("Mass of the machine") && screen.contains("Check"), "{screen}");
    assert!(!screen.contains("19.4") && !screen.contains("0.0617"), "{screen}");
    // What does not fit is read on, then the statement is collapsed.
    let mut keys = 0;
    while !words(&mut person).contains("steady amplitude at 1000 rpm.") {
        person.types("i");
        keys += 1;
        assert!(keys < 5, "{}", person.sees());
    }
    person.types("i");
    let screen = words(&mut person);
    assert!(screen.contains("Statement") && !screen.contains("A fan of 40 kg"), "{screen}");
    person.types("i");
    assert!(words(&mut person).contains("A fan of 40 kg stands"), "{}", person.sees());
    // With another input it is another problem.
    person.types("41 kg<enter>");
    assert!(!words(&mut person).contains("A fan of 40 kg stands"), "{}", person.sees());
    person.types("z");
    assert!(words(&mut person).contains("A fan of 40 kg stands"), "{}", person.sees());
}

#[test]
fn an_exercise_is_solved_by_the_answers_that_it_asks_for() {
    for (mut person, comma) in [(Person::at(80, 24), false), (Person::in_portuguese(80, 24), true)] {
        let say = |english: &'static str| {
            let locale = if comma { Locale::portuguese() } else { Locale::english() };
            Text::from(english).render(&locale)
        };
        let number = |text: &str| if comma { text.replace('.', ",") } else { text.to_owned() };
        let score = |right: usize| {
            let locale = if comma { Locale::portuguese() } else { Locale::english() };
            Text::new("Asked for: {right} of {count} right")
                .with("right", right)
                .with("count", 2)
                .render(&locale)
        };
        goes_to(&mut person, FAN);
        person.types("<enter><tab>");
        let screen = words(&mut person);
        assert!(screen.contains(&score(0)), "{screen}");
        assert!(screen.contains(&say("Damping ratio")) && screen.contains(&say("hint")), "{screen}");
        // Three hints give away more and more.
        for (n, level) in ["Principle", "Formulas", "Numbers"].into_iter().enumerate() {
            person.types("H");
            let screen = words(&mut person);
            assert!(screen.contains(&say(level)), "{screen}");
            assert_eq!(screen.contains(&number("0.0616")), n == 2, "{screen}");
        }
        person.types("H");
        assert!(!words(&mut person).contains(&say("Numbers")), "{}", person.sees());
        // A wrong answer, then the right one.
        person.types(&number("0.707<enter>"));
        assert!(words(&mut person).contains(&score(0)), "{}", person.sees());
        person.types(&number("0.06169<enter>"));
        assert!(words(&mut person).contains(&score(1)), "{}", person.sees());
        assert!(person.model.bench.as_ref().is_some_and(|bench| bench.problem.found.revealed.is_some()));
        // A wrong answer that is not asked for does not count.
        person.types("<down><down>1<enter><up>");
        person.types(&number("19.46<enter>"));
        assert!(words(&mut person).contains(&say("all required answers are correct")), "{}", person.sees());
        assert!(person.model.bench.as_ref().is_some_and(|bench| bench.problem.found.revealed.is_none()));
        person.types("[[[[[[[[[");
        let solved = |change: &HistoryChange| matches!(change, HistoryChange::Reach { case, progress: Progress::Solved, .. } if case == FAN.1);
        assert!(person.remembered.iter().any(solved), "{:?}", person.remembered);
        person.types("<esc><esc>");
        assert!(words(&mut person).contains(&say("solved by hand")), "{}", person.sees());
    }
}

#[test]
fn no_exercise_shows_what_it_asks_for_before_it_is_solved() {
    let locale = Locale::english();
    let mut answers = 0;
    for list in exercises::bundled() {
        for exercise in list.expect("the list can be read").list {
            let entry = find(&exercise.analysis).expect("there is the analysis");
            let case: Case = cases::cases(entry)
                .expect("the cases are read")
                .into_iter()
                .find(|case| case.name == exercise.case)
                .expect("there is the case");
            let record = case.record(entry).expect("the case is read");
            let solution = entry.solve(&record, &Stop::new()).expect("it has a solution");
            let mut person = Person::at(160, 45).knows(&[&exercise.analysis]);
            goes_to(&mut person, (&exercise.analysis, &exercise.case));
            let mut screens = words(&mut person);
            person.types("<enter>");
            screens += &words(&mut person);
            let problem = &person.model.bench.as_ref().expect("it is open").problem;
            let shown = problem.found.solution.as_ref().unwrap_or(&solution);
            let statement = case.statement.render(&locale);
            let start: String = statement.chars().take(30).collect();
            assert!(screens.contains(&start), "{}: {}", case.name, person.sees());
            for name in &case.asked {
                let answer = shown.answer(name).expect("what is asked for is an answer");
                let text = answer.shown(&locale);
                let number = text.split(' ').next().unwrap_or_default().to_owned();
                // Short numbers are on every screen: of an axis, of an input.
                if number.chars().filter(char::is_ascii_digit).count() < 4 || statement.contains(&number) {
                    continue;
                }
                answers += 1;
                assert!(!screens.contains(&number), "{}: {name} = {text}\n{}", case.name, person.sees());
            }
        }
    }
    assert!(answers > 150, "{answers}");
}
