//! Studies: sensitivity to inputs; sweep, target value and Monte Carlo of an answer.

#![expect(clippy::unwrap_used, reason = "a test ends where its data fails")]

use std::{
    thread,
    time::{Duration, Instant},
};

use dalembert_core::{
    Entry, Record, Scale, Solution, Stop, cases, find, registry, sensitivity,
    study::{self, Distribution, Plan},
    vary,
};
use dalembert_plugins as _;
use dalembert_tests::person::Person;
use dalembert_tui::{
    Effect, Msg,
    ask::Question,
    keys::{KeyContext, notation::keys_of},
    update,
};
use insta::assert_snapshot;

const FAN: &str = "vibration/rotating-unbalance";

struct Problem {
    entry: &'static Entry,
    record: Record,
    solution: Solution,
}

/// The first case of an analysis, solved.
fn problem(entry: &'static Entry) -> Problem {
    let record = cases::first(entry).unwrap().record(entry).unwrap();
    let solution = entry.solve(&record, &Stop::new()).unwrap();
    Problem { entry, record, solution }
}

fn fan() -> Problem {
    problem(find(FAN).unwrap())
}

/// An answer's sensitivity, by the path of the input.
fn elasticity(problem: &Problem, answer: &str, path: &str) -> f64 {
    let found =
        sensitivity::sensitivity(problem.entry, &problem.record, answer, (&[], 1.0), &Stop::new()).unwrap();
    let one = found.influences.iter().find(|one| one.input.path == path).unwrap();
    one.elasticity(found.value)
}

#[test]
fn elasticities_are_the_exponents_of_the_formulas() {
    let fan = fan();
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

/// The size of an angle depends on where it is counted from: it is taken by degrees, as it is also at zero.
#[test]
fn a_tolerance_is_a_share_or_a_width() {
    let inputs = |id: &str| {
        let entry = find(id).unwrap();
        vary::inputs(&cases::first(entry).unwrap().record(entry).unwrap())
    };
    let of = |inputs: &[vary::VariedInput], path: &str| {
        inputs.iter().find(|input| input.path == path).unwrap().clone()
    };
    let mass = of(&inputs("vibration/rotating-unbalance"), "mass");
    let angle =
        inputs("virtual-work/slider-crank").into_iter().find(|input| input.unit.pretty() == "°").unwrap();
    for (input, typed, width) in [
        (&mass, "2 %", 0.8),
        (&mass, "2", 0.8),
        (&mass, "500 g", 0.5),
        (&angle, "2", 2f64.to_radians()),
        (&angle, "0.01 rad", 0.01),
        (&angle, "10 %", 0.1 * angle.si.abs()),
    ] {
        assert!((input.tolerance(typed).unwrap() - width).abs() < 1e-12, "{typed} of {}", input.path);
    }
    assert_eq!((mass.step(), angle.step()), (0.4, 1f64.to_radians()));
    assert!(
        mass.tolerance("3 mm").is_err() && mass.tolerance("-1 %").is_err() && mass.tolerance("").is_err()
    );
}

/// One percent of a negative input is one percent more of it; a tolerance is a width, and holds to both sides.
#[test]
fn a_negative_input_has_a_step_of_its_sign_and_a_tolerance_of_none() {
    let entry = find("virtual-work/mechanism").unwrap();
    let record = cases::first(entry).unwrap().record(entry).unwrap();
    let record = vary::changed(&record, "gravity.y", -9.81).unwrap();
    let found = sensitivity::sensitivity(entry, &record, "effort[1]", (&[], 1.0), &Stop::new()).unwrap();
    let gravity = found.influences.iter().find(|one| one.input.path == "gravity.y").unwrap();
    let (step, size) = (gravity.input.step(), gravity.input.si.abs());
    assert!(gravity.input.si < 0.0 && (step + 0.01 * size).abs() < 1e-12, "{gravity:?}");
    assert!((gravity.tolerance - 0.01 * size).abs() < 1e-12, "{gravity:?}");
    assert!(found.influences.iter().all(|one| one.tolerance >= 0.0), "{:?}", found.influences);
}

#[test]
fn tolerances_add_up_at_worst_and_in_squares() {
    let fan = fan();
    let tolerances = [("mass".to_owned(), 0.8), ("support.cantilever.young".to_owned(), 8e9)];
    let found = sensitivity::sensitivity(
        fan.entry,
        &fan.record,
        "natural_frequency",
        (&tolerances, 0.0),
        &Stop::new(),
    )
    .unwrap();
    let spread = found.spread;
    // ω ∝ √(E/m): the stiffest material with the lightest mass, and the other way round.
    let [least, most] = spread.worst.map(|end| end / found.value);
    assert!((least - (0.96f64 / 1.02).sqrt()).abs() < 1e-12, "{spread:?}");
    assert!((most - (1.04f64 / 0.98).sqrt()).abs() < 1e-12, "{spread:?}");
    // ½ · 2 % and ½ · 4 %, to the second order of what is left out.
    assert!(
        (spread.likely / found.value - (0.01f64.powi(2) + 0.02f64.powi(2)).sqrt()).abs() < 5e-4,
        "{spread:?}"
    );
}

/// Near the peak of a resonance too, what all do together is no less than what each does alone.
#[test]
fn the_worst_of_all_tolerances_holds_that_of_each() {
    let fan = fan();
    for answer in ["amplitude", "frequency_ratio", "phase", "damping_ratio"] {
        let found =
            sensitivity::sensitivity(fan.entry, &fan.record, answer, (&[], 3.0), &Stop::new()).unwrap();
        let [least, most] = found.spread.worst;
        let ends = found.influences.iter().flat_map(|one| one.at_tolerance).filter(|end| end.is_finite());
        for end in ends.chain([found.value]) {
            assert!((least..=most).contains(&end), "{answer}: {end} in {least} to {most}");
        }
        assert!(least < found.value && found.value < most, "{answer}");
    }
}

#[test]
fn an_answer_that_does_not_change_is_said_to_be_so() {
    let fan = fan();
    let plan = Plan::Find {
        input: "mass".into(),
        range: [20.0, 60.0],
        answer: "stiffness".into(),
        wanted: 451_388.9,
    };
    let found = study::study(fan.entry, &fan.record, &plan, &Stop::new()).unwrap();
    let said: Vec<String> = found.remarks.iter().map(dalembert_core::Text::english).collect();
    assert_eq!(said, ["Stiffness of the support does not depend on Mass of the machine"]);
    assert!(found.numbers.is_empty());
}

/// The input that the answer runs over is not offered for a family of curves.
#[test]
fn a_family_is_of_another_input() {
    let mut person = Person::at(120, 36).opens(FAN);
    person.types("]]]]]]<tab>").types(&"<down>".repeat(7));
    let offered: Vec<String> = (0..12)
        .map(|_| {
            let screen = person.types("<enter>").sees();
            screen.lines().find(|line| line.contains("Parameter")).unwrap_or_default().to_owned()
        })
        .collect();
    assert!(offered.iter().any(|line| line.contains("Unbalance")), "{offered:#?}");
    assert!(!offered.iter().any(|line| line.contains("Mass of the machine ▾")), "{offered:#?}");
}

#[test]
fn a_value_that_is_found_gives_the_wanted_answer() {
    let fan = fan();
    let wanted = 0.01;
    let range = [500.0, 3000.0].map(|rpm| rpm * std::f64::consts::TAU / 60.0);
    let plan = Plan::Find { input: "speed".into(), range, answer: "amplitude".into(), wanted };
    let found = study::study(fan.entry, &fan.record, &plan, &Stop::new()).unwrap();
    // Once on the way up to the resonance, once behind it.
    assert_eq!(found.numbers.len(), 2, "{:?}", found.remarks);
    for speed in found.numbers {
        let record = vary::changed(&fan.record, "speed", speed).unwrap();
        let amplitude =
            fan.entry.solve(&record, &Stop::new()).unwrap().answer("amplitude").unwrap().si().unwrap();
        assert!((amplitude / wanted - 1.0).abs() < 1e-9, "{amplitude}");
    }
    let nowhere = Plan::Find { input: "speed".into(), range, answer: "amplitude".into(), wanted: 1.0 };
    let found = study::study(fan.entry, &fan.record, &nowhere, &Stop::new()).unwrap();
    assert!(
        found.numbers.is_empty() && found.remarks[0].english().contains("target not reached in the range"),
        "{:?}",
        found.remarks
    );
}

#[test]
fn a_sweep_runs_through_the_answers_and_says_where_there_is_none() {
    let fan = fan();
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
    let said = found.remarks[0].english();
    assert!(said.contains("no answer from 0.5 mm to 2.5 mm") && said.contains("m₀e/m"), "{said}");
    let Plan::Sweep { input, range, points: count, scale, answer, .. } = plan else { panic!("a sweep") };
    let family = Some(("mass".into(), vec![-1.0, 40.0]));
    let outside = Plan::Sweep { input, range, points: count, scale, family, answer };
    let said = study::study(fan.entry, &fan.record, &outside, &Stop::new()).unwrap().remarks[0].english();
    assert!(said.starts_with("Mass of the machine = −1 kg: ") && said.contains("limits"), "{said}");
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
    let fan = fan();
    let plan = |distribution, seed| Plan::Scatter {
        tolerances: vec![("unbalance".into(), 0.01)],
        usual: 0.0,
        distribution,
        samples: 10_000,
        seed,
        answer: "stiffness".into(),
    };
    let stiffness = Plan::Scatter {
        tolerances: vec![("support.cantilever.young".into(), 0.1 * 2e11)],
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
        tolerances: vec![("support.cantilever.young".into(), 0.3 * 2e11)],
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
    let fan = fan();
    let stop = Stop::new();
    stop.stop();
    let plan =
        Plan::Find { input: "speed".into(), range: [50.0, 300.0], answer: "amplitude".into(), wanted: 0.01 };
    assert!(study::study(fan.entry, &fan.record, &plan, &stop).is_err());
    assert!(sensitivity::sensitivity(fan.entry, &fan.record, "amplitude", (&[], 1.0), &stop).is_err());
}

/// Effects of a key, without performing them.
fn presses(person: &mut Person, key: &str) -> Vec<Effect> {
    let key = keys_of(key).unwrap().remove(0);
    update(&mut person.model, Msg::Key(key))
}

#[test]
fn escape_stops_what_is_asked_and_turning_to_it_asks_again() {
    for (tab, keys, change) in [
        ("Study", "", "<right>"),
        ("Sensitivity", "", "<right>"),
        ("Sensitivity", "<down>", "3"),
        ("Check", "<down>99 rad/", "s"),
    ] {
        let mut person = at(Person::at(120, 36).opens(FAN), tab);
        person.types(keys);
        assert!(matches!(presses(&mut person, change)[..], [Effect::Ask(_)]), "{tab}");
        let screen = person.sees();
        assert!(screen.contains("solving; Esc cancels"), "{screen}");
        assert!(
            screen.matches("solving").count() > 1 || screen.contains("searching for a common error"),
            "{screen}"
        );
        // What is typed ends first.
        if person.model.place() == KeyContext::Cell {
            assert!(matches!(presses(&mut person, "<esc>")[..], []), "{tab}");
            assert!(person.sees().contains("solving; Esc cancels"), "{}", person.sees());
        }
        assert!(matches!(presses(&mut person, "<esc>")[..], [Effect::Cancel]), "{tab}");
        let screen = person.sees();
        assert!(screen.contains(&format!("{tab} cancelled")), "{screen}");
        assert!(!screen.contains("solving") && !screen.contains("searching for"), "{screen}");
        assert!(screen.contains(if tab == "Check" { "incorrect" } else { " cancelled" }), "{screen}");
        person.types("[]");
        let screen = person.sees();
        assert!(!screen.contains("cancelled"), "{screen}");
        let found = ["No common error", "all tolerances:", "current value", "target"];
        assert!(found.iter().any(|words| screen.contains(words)), "{screen}");
        // The next one goes back to the inputs.
        person.types("<esc>");
        assert_eq!(person.model.place(), KeyContext::Form);
    }
}

#[test]
fn what_another_tab_waited_for_is_asked_again() {
    let mut person = at(Person::at(120, 36).opens(FAN), "Sensitivity");
    presses(&mut person, "<right>");
    person.types("]");
    assert!(person.sees().contains("current value"), "{}", person.sees());
    person.types("[");
    assert!(person.sees().contains("all tolerances:"), "{}", person.sees());
    // Of a problem that was put aside as well.
    presses(&mut person, "<right>");
    let mut person = person.opens("vibration/free-vibration");
    person.types("b");
    let screen = person.sees();
    assert!(screen.contains("all tolerances:") && !screen.contains("solving"), "{screen}");
}

#[test]
fn every_question_ends_soon_after_it_is_stopped() {
    // Most take longer than this to the end, also where the machine is busy; how soon is measured by `bench tui`.
    const SOON: Duration = Duration::from_secs(2);
    let mut stopped = 0;
    for entry in registry() {
        let id = entry.about.id;
        let Problem { record, solution, .. } = problem(entry);
        let solution = Box::new(solution);
        let answer = solution.answers.iter().find(|answer| answer.si().is_some()).unwrap().name.to_string();
        let scatter = Plan::Scatter {
            tolerances: Vec::new(),
            usual: 0.01,
            distribution: Distribution::Uniform,
            samples: study::MOST_SAMPLES,
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

fn at(mut person: Person, tab: &str) -> Person {
    person.types("<tab>");
    person.turns_to(tab);
    person
}

#[test]
fn which_input_matters_is_seen_as_bars() {
    let mut person = at(Person::at(80, 24).opens(FAN), "Sensitivity");
    for _ in 0..4 {
        person.types("<right>");
    }
    assert_snapshot!("sensitivity", person.types("<down>2 %<enter>").sees());
    let mut person = at(Person::at(160, 50).opens(FAN), "Sensitivity");
    assert_snapshot!("sensitivity_wide", person.sees());
    let mut person = at(Person::in_portuguese(120, 36).opens(FAN), "Sensitivity");
    assert_snapshot!("sensitivity_portuguese", person.sees());
    let mut person = at(Person::in_ascii(80, 24).opens(FAN), "Sensitivity");
    assert_snapshot!("sensitivity_ascii", person.types("e").sees());
}

#[test]
fn a_study_is_typed_and_its_curve_is_seen() {
    // The amplitude over the speed.
    let keys = "<down><right><right><right><right><down><left><down>500 rpm<down><enter>1500 rpm<enter>";
    let mut person = at(Person::at(80, 24).opens(FAN), "Study");
    assert_snapshot!("study", person.types(keys).types("e").sees());
    let mut person = at(Person::at(160, 50).opens(FAN), "Study");
    assert_snapshot!("study_wide", person.types(keys).sees());
    assert!(person.model.bench.as_ref().unwrap().problem.plots().count() > 1, "the plot is among the others");
    let mut person = at(Person::in_portuguese(120, 36).opens(FAN), "Study");
    assert_snapshot!("study_find_portuguese", person.types("<right><down><right><right><right><right><down>10 mm<enter><down><left><down>500 rpm<down><enter>3000 rpm<enter>").sees());
    let mut person = at(Person::in_ascii(100, 36).opens(FAN), "Study");
    assert_snapshot!("study_scatter_ascii", person.types("<left>").sees());
    let mut wrong = at(Person::at(110, 36).opens(FAN), "Study");
    wrong.types("<down><down><down>3 s<enter>");
    assert!(wrong.sees().contains("is a time"), "{}", wrong.sees());
}

/// Text on the screen behind the name of a cell.
fn cell(person: &mut Person, name: &str) -> String {
    let screen = person.sees();
    let line = screen.lines().find_map(|line| Some(line.split_once(name)?.1));
    let rest = line.unwrap_or_else(|| panic!("`{name}` is not on the screen:\n{screen}"));
    rest.split(['▾', '│']).next().unwrap_or_default().trim().to_owned()
}

#[test]
fn sensitivity_and_study_begin_with_the_input_under_the_cursor() {
    let about = |person: &mut Person| (cell(person, "Variable"), cell(person, "Answer"));
    let pair = |input: &str, answer: &str| (input.to_owned(), answer.to_owned());
    // The stiffness of the support does not rest on the mass that it carries, nor does the natural frequency on the
    // speed.
    let mut person = Person::at(120, 36).opens(FAN);
    person.turns_to("Study");
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
    person.turns_to("Study");
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
    let form = &mut person.model.bench.as_mut().unwrap().problem.inputs.form;
    form.cursor = form.lines().iter().position(|line| line.path.ends_with(".velocity")).unwrap();
    person.types("<del>0 m/s<enter>");
    person.turns_to("Study");
    assert_eq!(
        (cell(&mut person, "Range from"), cell(&mut person, "Range to")),
        ("−0.5 m/s".into(), "0.5 m/s".into())
    );
    assert!(!person.sees().contains("no width"), "{}", person.sees());
    // What cannot be negative begins at zero.
    let mut person = Person::at(120, 36).opens("vibration/base-excitation");
    person.types("]]]]]]<tab>").types(&"<down>".repeat(7));
    for _ in 0..12 {
        if cell(&mut person, "Parameter").contains("Damping ratio") {
            break;
        }
        person.types("<right>");
    }
    assert_eq!(cell(&mut person, "Parameter values"), "0; 0.5; 1.5", "{}", person.sees());
    assert!(!person.sees().contains("no answer"), "{}", person.sees());
}
