//! What a person asks of a problem beside its results: whether their own answers are right, and if not, why; which
//! input matters; how an answer runs over an input, where it is a wanted one, and how it scatters.

#![expect(clippy::unwrap_used, reason = "a test ends where its data fails")]

use std::{
    thread,
    time::{Duration, Instant},
};

use dalembert_core::{
    AnswerValue, Display, Draft, Entry, Number, Record, Scale, Solution, Stop, cases,
    check::{self, Verdict},
    find, registry, sensitivity,
    study::{self, Distribution, Plan},
    vary,
};
use dalembert_plugins as _;
use dalembert_tests::person::Person;
use dalembert_tui::{
    Effect, Msg,
    ask::Question,
    bench::Tab,
    keys::{Place, notation::keys_of},
    update,
};
use dalembert_units::{Style, write_quantity};
use insta::assert_snapshot;

const FAN: &str = "vibration/rotating-unbalance";

/// Problems with answers that slips change in many ways.
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
    /// The answer of that name with another text in one input, as a person would write it.
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

    fn slips(&self, answer: &str, typed: &str) -> Vec<String> {
        self.slips_of(&[(answer, typed)]).remove(0)
    }

    fn slips_of(&self, typed: &[(&str, &str)]) -> Vec<Vec<String>> {
        let typed: Vec<(String, String)> =
            typed.iter().map(|(name, text)| ((*name).to_owned(), (*text).to_owned())).collect();
        let found = check::slips(self.entry, &self.record, &self.solution, &typed, &Stop::new()).unwrap();
        found
            .into_iter()
            .map(|(_, slips)| slips.iter().map(|slip| slip.text(&self.solution).english()).collect())
            .collect()
    }
}

#[test]
fn what_we_show_is_right_to_any_number_of_digits() {
    let mut seen = 0;
    for entry in registry() {
        let Some(Ok(record)) = cases::first(entry).map(|case| case.record(entry)) else { continue };
        let Ok(solution) = entry.solve(&record, &Stop::new()) else { continue };
        for answer in &solution.answers {
            let AnswerValue::Number(Number::Scalar(si), _) = answer.value else { continue };
            let si = if si.abs() <= answer.noise { 0.0 } else { si };
            for digits in [4, 6, 12] {
                for ascii in [false, true] {
                    let typed = write_quantity(si, &answer.unit, Style { digits, ascii, ..Style::default() });
                    let verdict = check::compare(answer, &typed);
                    assert_eq!(verdict, Verdict::Right, "{} {} = {typed}", entry.about.id, answer.name);
                    seen += 1;
                }
            }
        }
    }
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
        ("2 cm", Verdict::TooFewDigits),
        ("19 mm", Verdict::TooFewDigits),
        ("20 mm", Verdict::Wrong),
        ("19.6 mm", Verdict::Wrong),
        ("-19.46 mm", Verdict::Wrong),
        ("1.743 mm", Verdict::Wrong),
    ] {
        assert_eq!(verdict("amplitude", typed), wanted, "{typed}");
    }
    assert!(matches!(verdict("amplitude", "19.47 mm"), Verdict::RoundedEarly(off) if off < 1e-3));
    assert!(matches!(verdict("amplitude", "19.46 kg"), Verdict::Unread(_)));
    assert_eq!(verdict("natural_frequency", "16.907 Hz"), Verdict::Right);
    assert_eq!(verdict("natural_frequency", "1014.4 rpm"), Verdict::Right);
}

#[test]
fn a_slip_in_an_input_is_found_and_named() {
    for (id, path, text, answer, wanted) in [
        (
            "vibration/rotating-unbalance",
            "speed",
            "1000 rad/s",
            "amplitude",
            "Speed of the machine: the number is in rpm and was taken in rad/s",
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
            "Speed of the machine: the number is in rpm and was taken in Hz",
        ),
    ] {
        let problem = problem(id);
        let typed = problem.with(&[(path, text)], answer, 4);
        let slips = problem.slips(answer, &typed);
        assert!(slips.iter().any(|slip| slip == wanted), "{id} {answer} = {typed}: {slips:?}");
    }
}

#[test]
fn every_slip_that_is_made_is_found() {
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
                let slips = problem.slips(&name.to_string(), &typed);
                made += 1;
                found += usize::from(!slips.is_empty());
                named += usize::from(slips.iter().any(|slip| slip.contains(&input.label.english())));
                assert!(!slips.is_empty(), "{id}: {} = {si}, {name} = {typed}", input.path);
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
        ("natural_frequency", "16.91 rad/s", "the number is in Hz, not in rad/s"),
        ("natural_frequency", "106.2 Hz", "the number is in rad/s, not in Hz"),
        ("natural_frequency", "1014 rad/s", "the number is in rpm, not in rad/s"),
        ("amplitude", "19.46 m", "the number is in mm, not in m"),
        ("amplitude", "38.91 mm", "2 times too large"),
        ("amplitude", "-19.46 mm", "it has the other sign"),
        ("stiffness", "451.4 N/m", "the number is in kN/m, not in N/m"),
        ("natural_frequency", "11280 rad/s", "it is the square: a root is missing"),
    ] {
        let slips = fan.slips(answer, typed);
        assert_eq!(slips.first().map(String::as_str), Some(wanted), "{answer} = {typed}: {slips:?}");
    }
}

#[test]
fn what_follows_from_a_wrong_answer_is_no_slip_of_its_own() {
    let fan = problem("vibration/rotating-unbalance");
    // The printed solution of the course: ζ assumed as 0.707, from which its amplitude follows.
    let found = fan.slips_of(&[("damping_ratio", "0.707"), ("amplitude", "1.743 mm")]);
    assert_eq!(
        found[1].first().map(String::as_str),
        Some("it follows from your own answer to: Damping ratio"),
        "{found:?}"
    );
    assert_eq!(found[0], [""; 0], "an assumption is no slip: {found:?}");
}

#[test]
fn a_random_answer_is_no_slip() {
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
                let slips = problem.slips(&answer.name.to_string(), &typed);
                accused += usize::from(!slips.is_empty());
            }
        }
    }
    assert!(asked > 500, "{asked}");
    assert!(20 * accused < asked, "{accused} of {asked} random answers were said to be slips");
}

/// Turns the tabs until this one is shown.
fn goes_to(person: &mut Person, tab: Tab) {
    for _ in 0..Tab::ALL.len() {
        if person.model.bench.as_ref().unwrap().tab == tab {
            return;
        }
        person.types("]");
    }
    panic!("{} is no tab of this problem", tab.name());
}

/// Types answers of one's own into the tab of checks.
fn checks(mut person: Person) -> Person {
    person
        .types("]]]]<tab>")
        .types("<down>106,2<enter>")
        .types("<down><down>0.707 <enter><down><down>1.743<enter><down>-127.5<enter>");
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
    person.types("t]]]]<tab>");
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
        let solution = person.model.bench.as_ref().unwrap().found.solution.as_ref().unwrap();
        let locale = dalembert_core::Locale::english().digits(6);
        solution.answers.iter().map(|answer| answer.shown(&locale)).collect()
    };
    person.types("<tab>");
    goes_to(&mut person, Tab::Check);
    let mut praised = 0;
    for answer in answers {
        person.types("<enter>").types(&answer).types("<enter>");
        praised += usize::from(person.sees().contains("well done"));
        person.types("<down>");
    }
    assert_eq!(praised, 1, "{}", person.sees());
}

/// An answer's sensitivity, by the path of the input.
fn elasticity(problem: &Problem, answer: &str, path: &str) -> f64 {
    let found =
        sensitivity::sensitivity(problem.entry, &problem.record, answer, (&[], 0.01), &Stop::new()).unwrap();
    let one = found.influences.iter().find(|one| one.input.path == path).unwrap();
    one.elasticity(found.value)
}

#[test]
fn elasticities_are_the_exponents_of_the_formulas() {
    let fan = problem(FAN);
    // ωₙ = √(3EI/(mL³)).
    for (path, exponent) in [
        ("mass", -0.5),
        ("support.cantilever.young", 0.5),
        ("support.cantilever.length", -1.5),
        ("support.cantilever.section.given.second_moment", 0.5),
        ("speed", 0.0),
    ] {
        let found = elasticity(&fan, "natural_frequency", path);
        assert!((found - exponent).abs() < 1e-6, "{path}: {found}");
    }
}

#[test]
fn tolerances_add_up_at_worst_and_in_squares() {
    let fan = problem(FAN);
    let tolerances = [("mass".to_owned(), 0.02), ("support.cantilever.young".to_owned(), 0.04)];
    let found = sensitivity::sensitivity(
        fan.entry,
        &fan.record,
        "natural_frequency",
        (&tolerances, 0.0),
        &Stop::new(),
    )
    .unwrap();
    let spread = found.spread();
    // ½ · 2 % and ½ · 4 %, to the second order of what is left out.
    assert!((spread.worst / found.value - 0.03).abs() < 6e-4, "{spread:?}");
    assert!(
        (spread.likely / found.value - (0.01f64.powi(2) + 0.02f64.powi(2)).sqrt()).abs() < 5e-4,
        "{spread:?}"
    );
}

#[test]
fn a_value_that_is_found_gives_the_wanted_answer() {
    let fan = problem(FAN);
    let wanted = 0.01;
    let range = [500.0, 3000.0].map(|rpm| rpm * std::f64::consts::TAU / 60.0);
    let plan = Plan::Find { input: "speed".into(), range, answer: "amplitude".into(), wanted };
    let found = study::study(fan.entry, &fan.record, &plan, &Stop::new()).unwrap();
    // Once on the way up to the resonance, once behind it.
    assert_eq!(found.numbers.len(), 2, "{:?}", found.says);
    for speed in found.numbers {
        let record = vary::changed(&fan.record, "speed", speed).unwrap();
        let amplitude =
            fan.entry.solve(&record, &Stop::new()).unwrap().answer("amplitude").unwrap().si().unwrap();
        assert!((amplitude / wanted - 1.0).abs() < 1e-9, "{amplitude}");
    }
    let nowhere = Plan::Find { input: "speed".into(), range, answer: "amplitude".into(), wanted: 1.0 };
    let found = study::study(fan.entry, &fan.record, &nowhere, &Stop::new()).unwrap();
    assert!(
        found.numbers.is_empty() && found.says[0].english().contains("no value in the range"),
        "{:?}",
        found.says
    );
}

#[test]
fn a_sweep_runs_through_the_answers_and_says_where_there_is_none() {
    let fan = problem(FAN);
    // No damping gives a largest amplitude below m₀e/m = 2.5 mm.
    let plan = Plan::Sweep {
        input: "damping.largest-amplitude.amplitude".into(),
        range: [0.0005, 0.0205],
        points: 41,
        scale: Scale::Linear,
        family: Some(("mass".into(), vec![40.0, 80.0])),
        answer: "amplitude".into(),
    };
    let found = study::study(fan.entry, &fan.record, &plan, &Stop::new()).unwrap();
    let plot = found.plot.unwrap();
    assert_eq!(plot.series.len(), 2);
    let (gaps, points): (Vec<_>, Vec<_>) = plot.series[0].points.iter().partition(|(_, y)| y.is_nan());
    assert!(gaps.iter().all(|(x, _)| *x <= 0.0025) && !gaps.is_empty(), "{gaps:?}");
    assert!(points.len() > 30);
    let said = found.says[0].english();
    assert!(said.contains("no answer from 0.5 mm to 2.5 mm") && said.contains("m₀e/m"), "{said}");
    let ours = |x: f64| {
        let record = vary::changed(&fan.record, "damping.largest-amplitude.amplitude", x).unwrap();
        fan.entry.solve(&record, &Stop::new()).unwrap().answer("amplitude").unwrap().si().unwrap()
    };
    for (x, y) in points.into_iter().step_by(7) {
        assert!((ours(x) / y - 1.0).abs() < 1e-12);
    }
}

#[test]
fn a_linear_answer_scatters_as_its_input_does() {
    let fan = problem(FAN);
    let plan = |distribution, seed| Plan::Scatter {
        tolerances: vec![("unbalance".into(), 0.1)],
        usual: 0.0,
        distribution,
        samples: 10_000,
        seed,
        answer: "stiffness".into(),
    };
    let stiffness = Plan::Scatter {
        tolerances: vec![("support.cantilever.young".into(), 0.1)],
        usual: 0.0,
        distribution: Distribution::Uniform,
        samples: 10_000,
        seed: 7,
        answer: "stiffness".into(),
    };
    let ours = fan.solution.answer("stiffness").unwrap().si().unwrap();
    // Uniform within ± 10 %: σ = 0.1/√3; the mean of 10 000 samples is off by σ/100.
    let found = study::study(fan.entry, &fan.record, &stiffness, &Stop::new()).unwrap().numbers;
    assert!((found[0] / ours - 1.0).abs() < 0.0025, "{found:?}");
    assert!((found[1] / ours - 0.1 / 3f64.sqrt()).abs() < 0.0015, "{found:?}");
    assert!((found[2] / ours - 0.905).abs() < 0.003 && (found[3] / ours - 1.095).abs() < 0.003, "{found:?}");
    let normal = Plan::Scatter {
        tolerances: vec![("support.cantilever.young".into(), 0.3)],
        usual: 0.0,
        distribution: Distribution::Normal,
        samples: 10_000,
        seed: 7,
        answer: "stiffness".into(),
    };
    let normal = study::study(fan.entry, &fan.record, &normal, &Stop::new()).unwrap().numbers;
    assert!((normal[1] / ours - 0.1).abs() < 0.003, "{normal:?}");
    assert!((normal[3] / ours - 1.196).abs() < 0.01, "{normal:?}");
    // What does not matter does not scatter, and the same seed gives the same samples.
    let still =
        study::study(fan.entry, &fan.record, &plan(Distribution::Uniform, 1), &Stop::new()).unwrap().numbers;
    assert!(still[1] <= 1e-12 * ours, "{still:?}");
    let again = study::study(fan.entry, &fan.record, &stiffness, &Stop::new()).unwrap().numbers;
    assert_eq!(found, again);
}

#[test]
fn a_study_is_stopped() {
    let fan = problem(FAN);
    let stop = Stop::new();
    stop.stop();
    let plan =
        Plan::Find { input: "speed".into(), range: [50.0, 300.0], answer: "amplitude".into(), wanted: 0.01 };
    assert!(study::study(fan.entry, &fan.record, &plan, &stop).is_err());
    assert!(sensitivity::sensitivity(fan.entry, &fan.record, "amplitude", (&[], 0.01), &stop).is_err());
}

/// What a key leads to, while nobody does it.
fn presses(person: &mut Person, key: &str) -> Vec<Effect> {
    let key = keys_of(key).unwrap().remove(0);
    update(&mut person.model, Msg::Key(key))
}

#[test]
fn escape_stops_what_is_asked_and_turning_to_it_asks_again() {
    for (tab, keys, change) in [
        (Tab::Study, "", "<right>"),
        (Tab::Sensitivity, "", "<right>"),
        (Tab::Sensitivity, "<down>", "3"),
        (Tab::Check, "<down>99 rad/", "s"),
    ] {
        let mut person = at(Person::at(120, 36).opens(FAN), tab);
        person.types(keys);
        assert!(matches!(presses(&mut person, change)[..], [Effect::Ask(_)]), "{tab:?}");
        let screen = person.sees();
        assert!(screen.contains("solving; Esc stops it"), "{screen}");
        assert!(screen.matches("solving").count() > 1 || screen.contains("looking for a slip"), "{screen}");
        // What is typed ends first.
        if person.model.place() == Place::Cell {
            assert!(matches!(presses(&mut person, "<esc>")[..], []), "{tab:?}");
            assert!(person.sees().contains("solving; Esc stops it"), "{}", person.sees());
        }
        assert!(matches!(presses(&mut person, "<esc>")[..], [Effect::Cancel]), "{tab:?}");
        let screen = person.sees();
        assert!(screen.contains(&format!("{} is stopped", tab.name())), "{screen}");
        assert!(!screen.contains("solving") && !screen.contains("looking for"), "{screen}");
        assert!(screen.contains(if tab == Tab::Check { "not right" } else { " stopped " }), "{screen}");
        person.types("[]");
        let screen = person.sees();
        assert!(!screen.contains("stopped"), "{screen}");
        let found = ["no slip we know", "all tolerances together", "as it stands", "wanted"];
        assert!(found.iter().any(|words| screen.contains(words)), "{screen}");
        // The next one goes back to the inputs.
        person.types("<esc>");
        assert_eq!(person.model.place(), Place::Form);
    }
}

#[test]
fn what_another_tab_waited_for_is_asked_again() {
    let mut person = at(Person::at(120, 36).opens(FAN), Tab::Sensitivity);
    presses(&mut person, "<right>");
    person.types("]");
    assert!(person.sees().contains("as it stands"), "{}", person.sees());
    person.types("[");
    assert!(person.sees().contains("all tolerances together"), "{}", person.sees());
    // Of a problem that was put aside as well.
    presses(&mut person, "<right>");
    let mut person = person.opens("vibration/free-vibration");
    person.types("b");
    let screen = person.sees();
    assert!(screen.contains("all tolerances together") && !screen.contains("solving"), "{screen}");
}

#[test]
fn every_question_ends_soon_after_it_is_stopped() {
    // Released, the program is more than five times as fast.
    const SOON: Duration = Duration::from_millis(if cfg!(debug_assertions) { 250 } else { 50 });
    let mut stopped = 0;
    for entry in registry() {
        let id = entry.about.id;
        let record = cases::first(entry).unwrap().record(entry).unwrap();
        let solution = Box::new(entry.solve(&record, &Stop::new()).unwrap());
        let answer = solution.answers.iter().find(|answer| answer.si().is_some()).unwrap().name.to_string();
        let scatter = Plan::Scatter {
            tolerances: Vec::new(),
            usual: 0.01,
            distribution: Distribution::Uniform,
            samples: study::MOST_POINTS,
            seed: 1,
            answer: answer.clone(),
        };
        let typed = vec![(answer.clone(), "1.2345e6".to_owned())];
        for question in [
            Question::Study { entry, record: record.clone(), plan: scatter },
            Question::Sensitivity { entry, record: record.clone(), answer, tolerances: Vec::new() },
            Question::Slips { entry, record: record.clone(), solution, typed },
        ] {
            let stop = Stop::new();
            thread::scope(|scope| {
                let asked = scope.spawn(|| question.answer(&stop));
                thread::sleep(Duration::from_millis(20));
                let under_way = !asked.is_finished();
                stop.stop();
                let begun = Instant::now();
                asked.join().unwrap();
                stopped += usize::from(under_way);
                assert!(begun.elapsed() < SOON, "{id}: {:?}", begun.elapsed());
            });
        }
    }
    assert!(stopped > 20, "{stopped}");
}

fn at(mut person: Person, tab: Tab) -> Person {
    person.types("<tab>");
    goes_to(&mut person, tab);
    person
}

#[test]
fn which_input_matters_is_seen_as_bars() {
    let mut person = at(Person::at(80, 24).opens(FAN), Tab::Sensitivity);
    for _ in 0..4 {
        person.types("<right>");
    }
    assert_snapshot!("sensitivity", person.types("<down>2 %<enter>").sees());
    let mut person = at(Person::at(160, 50).opens(FAN), Tab::Sensitivity);
    assert_snapshot!("sensitivity_wide", person.sees());
    let mut person = at(Person::in_portuguese(120, 36).opens(FAN), Tab::Sensitivity);
    assert_snapshot!("sensitivity_portuguese", person.sees());
    let mut person = at(Person::in_ascii(80, 24).opens(FAN), Tab::Sensitivity);
    assert_snapshot!("sensitivity_ascii", person.types("e").sees());
}

#[test]
fn a_study_is_typed_and_its_curve_is_seen() {
    // The amplitude over the speed.
    let keys = "<down><right><right><right><right><down><left><down>500 rpm<down><enter>1500 rpm<enter>";
    let mut person = at(Person::at(80, 24).opens(FAN), Tab::Study);
    assert_snapshot!("study", person.types(keys).types("e").sees());
    let mut person = at(Person::at(160, 50).opens(FAN), Tab::Study);
    assert_snapshot!("study_wide", person.types(keys).sees());
    assert!(person.model.bench.as_ref().unwrap().plots().count() > 1, "the plot is among the others");
    let mut person = at(Person::in_portuguese(120, 36).opens(FAN), Tab::Study);
    assert_snapshot!("study_find_portuguese", person.types("<right><down><right><right><right><right><down>10 mm<enter><down><left><down>500 rpm<down><enter>3000 rpm<enter>").sees());
    let mut person = at(Person::in_ascii(100, 36).opens(FAN), Tab::Study);
    assert_snapshot!("study_scatter_ascii", person.types("<left>").sees());
    let mut wrong = at(Person::at(110, 36).opens(FAN), Tab::Study);
    wrong.types("<down><down><down>3 s<enter>");
    assert!(wrong.sees().contains("is a time"), "{}", wrong.sees());
}

/// What stands on the screen behind the name of a cell.
fn cell(person: &mut Person, name: &str) -> String {
    let screen = person.sees();
    let line = screen.lines().find_map(|line| Some(line.split_once(name)?.1));
    let rest = line.unwrap_or_else(|| panic!("`{name}` is not on the screen:\n{screen}"));
    rest.split(['▾', '│']).next().unwrap_or_default().trim().to_owned()
}

#[test]
fn sensitivity_and_study_begin_with_the_input_under_the_cursor() {
    let about = |person: &mut Person| (cell(person, "Over the input"), cell(person, "Answer"));
    let pair = |input: &str, answer: &str| (input.to_owned(), answer.to_owned());
    // The stiffness of the support does not rest on the mass that it carries, nor does the natural frequency on the
    // speed.
    let mut person = Person::at(120, 36).opens(FAN);
    goes_to(&mut person, Tab::Study);
    assert_eq!(about(&mut person), pair("Mass of the machine", "Natural frequency"));
    person.types("[");
    assert!(person.sees().contains("◀ Natural frequency ▶"), "{}", person.sees());
    // On a heading: the first input below it. On the last line: the speed.
    person.types("<down><down>]");
    assert_eq!(about(&mut person), pair("Length", "Stiffness of the support"));
    person.types("[<end>]");
    assert_eq!(about(&mut person), pair("Speed of the machine", "Frequency ratio"));
    assert!(person.types("[").sees().contains("◀ Frequency ratio ▶"), "{}", person.sees());
    // An answer that nobody chose goes with the input.
    person.types("]<tab><down><down><right>");
    assert_eq!(about(&mut person), pair("Mass of the machine", "Natural frequency"));
    // What was chosen stays, wherever the cursor of the form is, and so does what a text was typed for.
    person.types("<up><right><right><tab><home><down>[]");
    assert_eq!(about(&mut person), pair("Mass of the machine", "Damping ratio"));
    let mut person = Person::at(120, 36).opens(FAN);
    person.types("<end>");
    goes_to(&mut person, Tab::Study);
    person.types("<tab><down><down><down>900 rpm<enter><tab><home>[]");
    assert_eq!(about(&mut person), pair("Speed of the machine", "Frequency ratio"));
    assert_eq!(cell(&mut person, "Range from"), "900 rpm");
    // The choice is of an input, not of a place among them: another support has other inputs.
    person.types("<down><down><right>");
    assert_eq!(about(&mut person), pair("Speed of the machine", "Frequency ratio"));
}

#[test]
fn a_study_of_an_input_that_is_zero_has_a_range() {
    let mut person = Person::at(120, 36).opens("vibration/free-vibration");
    let form = &mut person.model.bench.as_mut().unwrap().form;
    form.cursor = form.lines().iter().position(|line| line.path.ends_with(".velocity")).unwrap();
    person.types("<del>0 m/s<enter>");
    goes_to(&mut person, Tab::Study);
    assert_eq!(
        (cell(&mut person, "Range from"), cell(&mut person, "Range to")),
        ("−0.5 m/s".into(), "0.5 m/s".into())
    );
    assert!(!person.sees().contains("no width"), "{}", person.sees());
}

#[test]
fn an_answer_is_shown_in_another_unit_and_with_other_digits() {
    let mut person = Person::at(110, 40).opens(FAN);
    person.types("<tab>v<down>vDD");
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
    person.types("<tab>v<down>v");
    assert!(person.sees().contains(" Hz"), "{}", person.sees());
}

#[test]
fn a_display_is_read_as_it_is_written() {
    for text in ["mm", "mm; 6 digits", "6 digits", "kg*m", ""] {
        assert_eq!(Display::of(text).to_string(), text);
    }
}
