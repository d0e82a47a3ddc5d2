//! Check of a user's own answers, with the probable mistakes; display of answers.

#![expect(clippy::unwrap_used, reason = "a test ends where its data fails")]

use dalembert_core::{
    Display, Draft, Entry, Record, Solution, Stop, cases,
    check::{self, Verdict},
    find, registry, vary,
};
use dalembert_plugins as _;
use dalembert_testkit::printed;
use dalembert_tests::person::Person;
use dalembert_units::{Style, write_quantity};
use insta::assert_snapshot;

const FAN: &str = "vibration/rotating-unbalance";

/// Problems with answers that mistakes change in many ways.
const PROBLEMS: [&str; 12] = [
    "vibration/rotating-unbalance",
    "vibration/beam-and-springs",
    "vibration/free-vibration",
    "vibration/harmonic-force",
    "vibration/base-excitation",
    "vibration/vibration-isolation",
    "vibration/mass-on-shaft",
    "vibration/logarithmic-decrement",
    "vibration/drop-impact",
    "rigid-body/rod-on-shaft",
    "rigid-body/spinning-disc-on-arm",
    "rigid-body/gyroscopic-couple",
];

struct Problem {
    entry: &'static Entry,
    draft: Draft,
    record: Record,
    solution: Solution,
}

/// The first case of an analysis, solved.
fn problem(id: &str) -> Problem {
    let entry = find(id).unwrap_or_else(|| panic!("{id} is linked"));
    let draft = cases::first(entry).unwrap().draft;
    let record = draft.read(&entry.shape()).unwrap();
    let solution = entry.solve(&record, &Stop::new()).unwrap();
    Problem { entry, draft, record, solution }
}

impl Problem {
    /// The answer of that name with another text in one input, as a user would write it.
    fn with(&self, changes: &[(&str, &str)], answer: &str, digits: u8) -> String {
        let mut draft = self.draft.clone();
        for (path, text) in changes {
            draft.set(&self.entry.shape(), path, text).unwrap();
        }
        let record = draft.read(&self.entry.shape()).unwrap();
        let solution = self.entry.solve(&record, &Stop::new()).unwrap();
        let answer = solution.answer(answer).unwrap();
        write_quantity(answer.si().unwrap(), &answer.unit, Style { digits, ..Style::default() })
    }

    fn causes(&self, answer: &str, typed: &str) -> Vec<String> {
        self.causes_of(&[(answer, typed)]).remove(0)
    }

    fn causes_of(&self, typed: &[(&str, &str)]) -> Vec<Vec<String>> {
        let typed: Vec<(String, String)> =
            typed.iter().map(|(name, text)| ((*name).to_owned(), (*text).to_owned())).collect();
        let found = check::causes(self.entry, &self.record, &self.solution, &typed, &Stop::new(), None);
        found
            .into_iter()
            .map(|(_, causes)| causes.iter().map(|cause| cause.text(&self.solution).english()).collect())
            .collect()
    }

    /// True if a cause is named of an answer.
    fn is_named(&self, answer: &str, typed: &str) -> bool {
        let typed = [(answer.to_owned(), typed.to_owned())];
        let found = check::causes(self.entry, &self.record, &self.solution, &typed, &Stop::new(), None);
        found.iter().flat_map(|(_, causes)| causes).any(|cause| cause.is_named)
    }
}

#[test]
fn what_we_show_is_right_to_any_number_of_digits() {
    let seen = printed::what_is_shown_is_right_to_any_number_of_digits(registry());
    assert!(seen > 1000, "{seen}");
}

#[test]
fn few_digits_and_early_rounding_are_no_praise() {
    let fan = problem("vibration/rotating-unbalance");
    let verdict = |name: &str, typed: &str| check::compare(fan.solution.answer(name).unwrap(), typed);
    // X = 19.4559 mm, ωₙ = 106.23 rad/s.
    for (typed, wanted) in [
        ("19.456 mm", Verdict::Right),
        ("19,46 mm", Verdict::Right),
        ("19.5", Verdict::Right),
        ("0.019456 m", Verdict::Right),
        ("1.9456e4 um", Verdict::Right),
        // A mark before three digits is that of the country whose reading is ours.
        ("19,456 mm", Verdict::Right),
        ("19.456,0 um", Verdict::RoundedEarly(0.0)),
        ("19,546 mm", Verdict::RoundedEarly(0.0)),
        ("25,456 mm", Verdict::Wrong),
        ("2 cm", Verdict::TooFewDigits),
        ("19 mm", Verdict::TooFewDigits),
        ("20 mm", Verdict::Wrong),
        ("19.6 mm", Verdict::Wrong),
        ("-19.46 mm", Verdict::Wrong),
        ("1.743 mm", Verdict::Wrong),
    ] {
        match verdict("amplitude", typed) {
            Verdict::RoundedEarly(_) => assert!(matches!(wanted, Verdict::RoundedEarly(_)), "{typed}"),
            found => assert_eq!(found, wanted, "{typed}"),
        }
    }
    assert!(matches!(verdict("amplitude", "19.47 mm"), Verdict::RoundedEarly(off) if off < 1e-3));
    assert!(matches!(verdict("amplitude", "19.46 kg"), Verdict::Unread(_)));
    assert_eq!(verdict("natural_frequency", "16.907 Hz"), Verdict::Right);
    assert_eq!(verdict("natural_frequency", "1014.4 rpm"), Verdict::Right);
}

#[test]
fn a_mistake_in_an_input_is_found_and_named() {
    for (id, path, text, answer, wanted) in [
        (
            "vibration/rotating-unbalance",
            "speed",
            "1000 rad/s",
            "amplitude",
            "Speed of the machine: rpm used as rad/s",
        ),
        (
            "vibration/rotating-unbalance",
            "mass",
            "80 kg",
            "natural_frequency",
            "Mass of the machine: 2 times too large",
        ),
        (
            "vibration/rotating-unbalance",
            "speed",
            "1000 Hz",
            "transmitted_force",
            "Speed of the machine: rpm used as Hz",
        ),
    ] {
        let problem = problem(id);
        let typed = problem.with(&[(path, text)], answer, 4);
        let causes = problem.causes(answer, &typed);
        assert!(
            causes.iter().any(|slip| slip.split("; or, with the same result, ").any(|one| one == wanted)),
            "{id} {answer} = {typed}: {causes:?}"
        );
    }
}

#[test]
fn every_mistake_that_is_made_is_found() {
    let (mut made, mut found, mut named) = (0, 0, 0);
    for id in PROBLEMS {
        let problem = problem(id);
        for input in vary::inputs(&problem.record) {
            let plain = input.unit.value(input.si);
            // Twice the value, and the number taken in SI.
            for si in [2.0 * input.si, plain] {
                let Some(record) = vary::changed(&problem.record, &input.path, si) else { continue };
                let Ok(solution) = problem.entry.solve(&record, &Stop::new()) else { continue };
                let wrong = solution.answers.iter().find_map(|answer| {
                    let ours = problem.solution.answer(&answer.name.to_string())?;
                    let style = Style { digits: 5, ..Style::default() };
                    let typed = write_quantity(answer.si()?, &ours.unit, style);
                    (check::compare(ours, &typed) == Verdict::Wrong && input.permits(si))
                        .then_some((answer.name, typed))
                });
                let Some((name, typed)) = wrong else { continue };
                if typed.chars().filter(char::is_ascii_digit).count() < 4 {
                    continue;
                }
                let causes = problem.causes(&name.to_string(), &typed);
                made += 1;
                found += usize::from(!causes.is_empty());
                named += usize::from(causes.iter().any(|slip| slip.contains(&input.label.english())));
                assert!(!causes.is_empty(), "{id}: {} = {si}, {name} = {typed}", input.path);
            }
        }
    }
    assert!(made > 60, "{made}");
    assert!(5 * named > 4 * made, "{named} of {made} are named, {found} found");
}

#[test]
fn a_unit_a_sign_and_a_factor_of_the_answer_are_found() {
    let fan = problem("vibration/rotating-unbalance");
    for (answer, typed, wanted) in [
        ("natural_frequency", "16.91 rad/s", "the number is in Hz, not rad/s"),
        ("natural_frequency", "106.2 Hz", "the number is in rad/s, not Hz"),
        ("natural_frequency", "1014 rad/s", "the number is in rpm, not rad/s"),
        ("amplitude", "19.46 m", "the number is in mm, not m"),
        (
            "amplitude",
            "38.91 mm",
            "computing X (Steady-state amplitude at the running speed): peak-to-peak value in place of the amplitude",
        ),
        ("amplitude", "-19.46 mm", "computing X (Steady-state amplitude at the running speed): sign error"),
        ("stiffness", "451.4 N/m", "the number is in kN/m, not N/m"),
        (
            "natural_frequency",
            "11280 rad/s",
            "computing ωₙ (Natural frequency without damping): a square root omitted",
        ),
    ] {
        let causes = fan.causes(answer, typed);
        let first = causes.first().and_then(|first| first.split("; or, with the same result, ").next());
        assert_eq!(first, Some(wanted), "{answer} = {typed}: {causes:?}");
    }
}

#[test]
fn what_follows_from_a_wrong_answer_has_no_cause_of_its_own() {
    let fan = problem("vibration/rotating-unbalance");
    // The printed solution of the course: ζ assumed as 0.707, from which its amplitude follows.
    let found = fan.causes_of(&[("damping_ratio", "0.707"), ("amplitude", "1.743 mm")]);
    assert_eq!(
        found[1].first().map(String::as_str),
        Some("consistent with your earlier answer to Damping ratio (error carried forward)"),
        "{found:?}"
    );
    assert!(found[0][0].contains("assumes 0.707"), "{found:?}");
}

#[test]
fn a_random_answer_has_no_named_cause() {
    // Deterministic numbers, spread evenly.
    let mut state = 0x2545_F491_4F6C_DD1D_u64;
    let mut random = move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    let (mut asked, mut accused) = (0, 0);
    for id in PROBLEMS {
        let problem = problem(id);
        let answers: Vec<_> = problem
            .solution
            .answers
            .iter()
            .filter(|answer| answer.si().is_some_and(|si| si.abs() > answer.noise))
            .collect();
        for digits in [3, 4, 5] {
            for _ in 0..20 {
                let answer = answers[(random() * answers.len() as f64) as usize];
                let off = (6.0 * random() - 3.0).exp();
                let typed = write_quantity(
                    answer.si().unwrap() * off,
                    &answer.unit,
                    Style { digits, ..Style::default() },
                );
                if check::compare(answer, &typed) != Verdict::Wrong {
                    continue;
                }
                asked += 1;
                accused += usize::from(problem.is_named(&answer.name.to_string(), &typed));
            }
        }
    }
    assert!(asked > 500, "{asked}");
    assert!(25 * accused < asked, "of {asked} random answers {accused} have a named cause");
}

/// Types the user's answers into the tab of checks.
fn checks(mut person: Person) -> Person {
    person
        .types("]]]]")
        .types("<down><down><down>106,2<enter>")
        .types("<down><down>0.707 <enter><home>1.743<enter><end><up>-127.5<enter>");
    person
}

#[test]
fn answers_of_ones_own_are_checked_as_they_are_typed() {
    assert_snapshot!("check", checks(Person::at(80, 24).opens(FAN)).sees());
    assert_snapshot!("check_wide", checks(Person::at(160, 50).opens(FAN)).sees());
    assert_snapshot!("check_portuguese", checks(Person::in_portuguese(120, 36).opens(FAN)).sees());
    assert_snapshot!("check_ascii", checks(Person::in_ascii(80, 24).opens(FAN)).types("e").sees());
}

#[test]
fn ours_stays_covered_until_it_is_asked_for() {
    let mut person = Person::at(110, 40).opens(FAN);
    person.types("t]]]]");
    for _ in 0..2 {
        let screen = person.sees();
        assert!(!screen.contains("19.456") && !screen.contains("106.23"), "{screen}");
        person.types("<down>99.9 rad/s<enter>");
    }
    person.types("<up><down> ");
    assert!(person.sees().contains("= "), "{}", person.sees());
}

#[test]
fn praise_is_given_once() {
    let mut person = Person::at(110, 40).opens("vibration/harmonic-force");
    let answers: Vec<String> = {
        let solution = person.model.bench.as_ref().unwrap().problem.found.solution.as_ref().unwrap();
        let locale = dalembert_core::Locale::english().digits(6);
        solution.answers.iter().map(|answer| answer.shown(&locale)).collect()
    };
    person.turns_to("Check");
    let mut congratulated = 0;
    for answer in answers {
        person.types("<enter>").types(&answer).types("<enter>");
        congratulated += usize::from(person.sees().contains("all required answers are correct"));
        person.types("<down>");
    }
    assert_eq!(congratulated, 1, "{}", person.sees());
}

/// Text of the fan in the list of exercises.
fn exercise(person: &mut Person) -> String {
    person.types("<esc><esc>").clicks("Exercise lists").types("<right><down>");
    let screen = person.sees();
    let line = screen.lines().find_map(|line| Some(line.split_once("Fan on a cantilever  ")?.1));
    line.unwrap_or(&screen).trim_end_matches(['│', ' ']).to_owned()
}

#[test]
fn an_exercise_is_solved_when_its_last_answer_is_right_and_none_is_wrong() {
    for (answers, solved) in [
        // What the others are made for is enough.
        ("<end><up>", false),
        ("AMPLITUDE19.456<enter>", true),
        ("AMPLITUDE19.9<enter>", false),
        ("AMPLITUDE19.5<enter>", true),
        ("RATIO0.06169<enter>", false),
        ("RATIO0.707<enter>AMPLITUDE19.456<enter>", false),
        ("RATIO0.707<enter>AMPLITUDE19.456<enter>RATIO0.06169<enter>", true),
    ] {
        let mut person = Person::at(120, 40).knows(&[FAN]).opens(FAN);
        person.turns_to("Check");
        let answers = answers.replace("RATIO", "<home><down><down><down><down><down>");
        person.types(&answers.replace("AMPLITUDE", "<home>"));
        let screen = person.sees();
        let is_said = ["answers entered are correct; still empty: ", "all required answers are correct"]
            .iter()
            .any(|words| screen.contains(words));
        assert_eq!(is_said, solved, "{answers}\n{screen}");
        assert_eq!(exercise(&mut person), if solved { "solved by hand" } else { "opened" }, "{answers}");
    }
}

#[test]
fn an_answer_is_shown_in_another_unit_and_with_other_digits() {
    let mut person = Person::at(110, 40).opens(FAN);
    person.types("<tab>v<down><down><down>vDD");
    let screen = person.sees();
    assert!(screen.contains("1014.418"), "{screen}");
    // It stays so with other inputs, in copies and in the file.
    person.types("y");
    assert!(person.clipboard.contains("1014.418"), "{}", person.clipboard);
    person.types("<esc><tab><del>50 kg<enter>");
    assert!(person.sees().contains("907.3228"), "{}", person.sees());
    let kept = person.kept.values().next().cloned().unwrap();
    assert!(kept.contains("natural_frequency = \"rpm; 7 digits\""), "{kept}");
    // The first key only chooses an answer.
    person.types("<tab>v<down><down><down>v");
    assert!(person.sees().contains(" Hz"), "{}", person.sees());
}

#[test]
fn a_display_is_read_as_it_is_written() {
    for text in ["mm", "mm; 6 digits", "6 digits", "kg*m", ""] {
        assert_eq!(Display::of(text).to_string(), text);
    }
}

/// The last answer stands at the edge of the pane: what is said of it is scrolled to.
#[test]
fn the_verdict_on_the_last_answer_is_seen() {
    let mut person = Person::at(80, 24).opens(FAN);
    person.types("]]]]");
    for _ in 0..30 {
        person.types("7<enter><down>");
    }
    let screen = person.types("1<enter>").sees();
    let (_, after) = screen.split_once("✗ ").expect("an answer is wrong");
    let last = after.rsplit('✗').next().unwrap_or_default();
    assert!(last.contains("Incorrect") || last.contains("·"), "{screen}");
}
