//! Studies: sweep, target value, Monte Carlo, and plans.

#![expect(clippy::unwrap_used, reason = "a test ends where its data fails")]

use std::{
    cell::RefCell,
    path::PathBuf,
    thread,
    time::{Duration, Instant},
};

use dalembert_core::{
    Entry, Plot, Record, Solution, SolveError, Stop, cases, find, registry, sensitivity,
    study::{self, FoundTarget},
    vary,
};
use dalembert_plugins as _;
use dalembert_study::plans;
use dalembert_tests::person::Person;
use dalembert_tui::{
    Effect, Msg,
    ask::{Question, Reply, StudyResult},
    dialog::Dialog,
    keys::{KeyContext, notation::keys_of},
    layout::Focus,
    update,
};
use insta::assert_snapshot;

const FAN: &str = "vibration/rotating-unbalance";
const SHAFT: &str = "vibration/mass-on-shaft";

pub(crate) struct Problem {
    pub(crate) entry: &'static Entry,
    pub(crate) record: Record,
    pub(crate) solution: Solution,
}

/// The first case of an analysis, solved.
fn problem(entry: &'static Entry) -> Problem {
    let record = cases::first(entry).unwrap().record(entry).unwrap();
    let solution = entry.solve(&record, &Stop::new()).unwrap();
    Problem { entry, record, solution }
}

pub(crate) fn fan() -> Problem {
    problem(find(FAN).unwrap())
}

/// A study of the fan in the workbench: its plan in TOML, without the problem.
fn asked(fan: &Problem, plan: &str) -> StudyResult {
    let plan = plans::read(&format!("problem = \"fan.toml\"\n{plan}")).unwrap();
    let question = Question::Study {
        entry: fan.entry,
        record: fan.record.clone(),
        answers: fan.solution.answers.clone(),
        plan: Box::new(plan),
        folder: PathBuf::new(),
    };
    match question.answer(&Stop::new(), &|_| {}) {
        Some(Reply::Study(found)) => found.unwrap(),
        other => panic!("{other:?}"),
    }
}

/// Values of an input of the fan at which an answer is a wanted one.
fn sought(fan: &Problem, input: (&str, [f64; 2]), answer: (&str, f64)) -> FoundTarget {
    let (name, wanted) = answer;
    let answer = fan.solution.answer(name).unwrap();
    study::find_target(fan.entry, &fan.record, input, (answer, wanted), &Stop::new()).unwrap()
}

#[test]
fn an_answer_that_does_not_change_is_said_to_be_so() {
    let found = sought(&fan(), ("mass", [20.0, 60.0]), ("stiffness", 451_388.9));
    let said: Vec<String> = found.remarks.iter().map(dalembert_core::Text::english).collect();
    assert_eq!(said, ["Stiffness of the support does not depend on Mass of the machine"]);
    assert!(found.values.is_empty());
}

#[test]
fn a_value_that_is_found_gives_the_wanted_answer() {
    let fan = fan();
    let wanted = 0.01;
    let range = [500.0, 3000.0].map(|rpm| rpm * std::f64::consts::TAU / 60.0);
    let found = sought(&fan, ("speed", range), ("amplitude", wanted));
    // Once on the way up to the resonance, once behind it.
    assert_eq!(found.values.len(), 2, "{:?}", found.remarks);
    for speed in found.values {
        let record = vary::changed(&fan.record, "speed", speed).unwrap();
        let amplitude =
            fan.entry.solve(&record, &Stop::new()).unwrap().answer("amplitude").unwrap().si().unwrap();
        assert!((amplitude / wanted - 1.0).abs() < 1e-9, "{amplitude}");
    }
    let found = sought(&fan, ("speed", range), ("amplitude", 1.0));
    assert!(
        found.values.is_empty() && found.remarks[0].english().contains("target not reached in the range"),
        "{:?}",
        found.remarks
    );
}

#[test]
fn a_sweep_runs_through_the_answers_and_says_where_there_is_none() {
    let fan = fan();
    // No damping gives a largest amplitude below m₀e/m = 2.5 mm.
    let sweep = "answers = [\"amplitude\"]\n[[vary]]\ninput = \"damping.largest-amplitude.amplitude\"\nfrom = \"0.5 mm\"\nto = \"20.5 mm\"\npoints = 41\n";
    let family = |values: &str| format!("{sweep}[[vary]]\ninput = \"mass\"\nvalues = [{values}]\n");
    let found = asked(&fan, &family("\"40 kg\", \"80 kg\""));
    let plot = &found.plots[0];
    assert_eq!(plot.series.len(), 2);
    let (gaps, points): (Vec<_>, Vec<_>) = plot.series[0].points.iter().partition(|(_, y)| y.is_nan());
    assert!(gaps.iter().all(|(x, _)| *x <= 0.0025) && !gaps.is_empty(), "{gaps:?}");
    assert!(points.len() > 30);
    let said = found.remarks[0].english();
    assert!(said.contains("no answer from 0.5 mm to 2.5 mm") && said.contains("m₀e/m"), "{said}");
    let said = asked(&fan, &family("\"-1 kg\", \"40 kg\"")).remarks[0].english();
    assert!(
        said.starts_with("Mass of the machine = −1 kg: no answer from 0.5 mm to 20.5 mm: mass:"),
        "{said}"
    );
    let ours = |x: f64| {
        let record = vary::changed(&fan.record, "damping.largest-amplitude.amplitude", x).unwrap();
        fan.entry.solve(&record, &Stop::new()).unwrap().answer("amplitude").unwrap().si().unwrap()
    };
    for (x, y) in points.into_iter().step_by(7) {
        assert!((ours(x) / y - 1.0).abs() < 1e-12);
    }
    // The curves of eight masses are not all drawn.
    let many = asked(&fan, &family("40, 41, 42, 43, 44, 45, 46, 47"));
    assert_eq!(many.plots[0].series.len(), study::MOST_CURVES);
    assert!(many.remarks.iter().any(|text| text.english() == "the first 6 of 8 curves are drawn"));
}

/// The axis of the curves is the input with the most points, wherever it stands in the plan.
#[test]
fn curves_are_the_same_in_any_order_of_the_inputs() {
    let fan = fan();
    let speed = "[[vary]]\ninput = \"speed\"\nfrom = \"600 rpm\"\nto = \"1800 rpm\"\npoints = 13\n";
    let mass = "[[vary]]\ninput = \"mass\"\nvalues = [40, 60]\n";
    let curves = |plan: String| {
        let found = asked(&fan, &format!("answers = [\"amplitude\", \"phase\"]\n{plan}"));
        let points = |plot: &Plot| plot.series.iter().map(|series| series.points.clone()).collect::<Vec<_>>();
        found.plots.iter().map(points).collect::<Vec<_>>()
    };
    let one = curves(format!("{speed}{mass}"));
    assert_eq!(one, curves(format!("{mass}{speed}")));
    assert_eq!((one.len(), one[0].len(), one[0][0].len()), (2, 2, 13));
    let last = one[0][1][12];
    let record = vary::changed(&vary::changed(&fan.record, "mass", 60.0).unwrap(), "speed", last.0).unwrap();
    let ours = fan.entry.solve(&record, &Stop::new()).unwrap().answer("amplitude").unwrap().si().unwrap();
    assert!((last.0 / (1800.0 * std::f64::consts::TAU / 60.0) - 1.0).abs() < 1e-12);
    assert!((ours / last.1 - 1.0).abs() < 1e-12, "{ours} {last:?}");
}

/// The first number behind a word in what was found.
fn number_behind(found: &StudyResult, word: &str) -> f64 {
    let said = found.found.iter().chain(&found.details).map(dalembert_core::Text::english);
    let said: Vec<String> = said.collect();
    let rest =
        said.iter().find_map(|line| Some(line.split_once(word)?.1)).unwrap_or_else(|| panic!("{said:?}"));
    let number: String = rest.trim_start().chars().take_while(|c| c.is_ascii_digit() || *c == '.').collect();
    number.parse().unwrap()
}

#[test]
fn a_linear_answer_scatters_as_its_input_does() {
    let fan = fan();
    let of = |distribution: &str| {
        asked(
            &fan,
            &format!(
                "answers = [\"stiffness\"]\nsamples = 10000\nseed = 7\n[[vary]]\ninput = \"support.cantilever.young\"\n{distribution}\n[[limit]]\nanswer = \"stiffness\"\nabove = \"451.388889 kN/m\"\n"
            ),
        )
    };
    let ours = 451.388_9;
    // Uniform within ± 10 %: σ = 0.1/√3; the mean of 10 000 samples is off by σ/100.
    let uniform = of("distribution = \"uniform\"\ntolerance = \"10 %\"");
    assert!((number_behind(&uniform, "mean") / ours - 1.0).abs() < 0.0025);
    assert!((number_behind(&uniform, "deviation") / ours - 0.1 / 3f64.sqrt()).abs() < 0.0015);
    assert!((number_behind(&uniform, "interval:") / ours - 0.905).abs() < 0.003);
    assert!((number_behind(&uniform, "quartiles") / ours - 0.95).abs() < 0.003);
    // Half of a symmetric distribution is above its middle.
    assert!((number_behind(&uniform, "kN/m:") - 50.0).abs() < 2.0, "{:?}", uniform.found);
    let normal = of("distribution = \"normal\"\ndeviation = \"10 %\"");
    assert!((number_behind(&normal, "deviation") / ours - 0.1).abs() < 0.003);
    assert!((number_behind(&normal, "interval:") / ours - 0.804).abs() < 0.01);
    assert_eq!(normal.plots.len(), 1);
}

#[test]
fn a_study_is_stopped() {
    let fan = fan();
    let stop = Stop::new();
    stop.stop();
    let answer = fan.solution.answer("amplitude").unwrap();
    let input = ("speed", [50.0, 300.0]);
    assert!(study::find_target(fan.entry, &fan.record, input, (answer, 0.01), &stop).is_err());
    assert!(sensitivity::sensitivity(fan.entry, &fan.record, "amplitude", (&[], 1.0), &stop).is_err());
}

/// A million points are reported while they come, and their statistics are those of the whole at the end.
#[test]
fn a_long_study_is_reported_while_it_runs() {
    let fan = fan();
    let plan = "samples = 100000000\nanswers = [\"amplitude\"]\n[[vary]]\ninput = \"mass\"\ndistribution = \"normal\"\ndeviation = \"2 %\"\n";
    let question = Question::Study {
        entry: fan.entry,
        record: fan.record.clone(),
        answers: fan.solution.answers.clone(),
        plan: Box::new(plans::read(&format!("problem = \"fan.toml\"\n{plan}")).unwrap()),
        folder: PathBuf::new(),
    };
    let reported = RefCell::new(Vec::new());
    let stop = Stop::new();
    let reply = question.answer(&stop, &|reply| {
        assert!(reply.is_partial());
        let Reply::Study(found) = reply else { panic!("{reply:?}") };
        reported.borrow_mut().push(found.unwrap().progress.unwrap());
        if reported.borrow().len() == 2 {
            stop.stop();
        }
    });
    let reported = reported.into_inner();
    let ascends = reported.windows(2).all(|pair| pair[0].done < pair[1].done);
    assert!(ascends && reported.iter().all(|so_far| so_far.done < so_far.points), "{reported:?}");
    assert!(
        reported
            .iter()
            .all(|so_far| so_far.points == 100_000_000 && so_far.rate() > 0.0 && so_far.left() > 0.0)
    );
    // A hundred million points take far longer than two reports.
    assert!(reply.is_none() && reported.len() >= 2);
}

/// Effects of a key, without performing them.
pub(crate) fn presses(person: &mut Person, key: &str) -> Vec<Effect> {
    let key = keys_of(key).unwrap().remove(0);
    update(&mut person.model, Msg::Key(key))
}

#[test]
fn escape_stops_what_is_asked_and_turning_to_it_asks_again() {
    for (tab, keys, change) in [
        ("Study", "", "<right>"),
        ("Sensitivity", "", "<right>"),
        ("Sensitivity", "<down>", "3"),
        ("Check", "<down><down><down>99 rad/", "s"),
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
        // What is typed is kept first.
        if person.model.place() == KeyContext::Cell {
            assert!(matches!(presses(&mut person, "<enter>")[..], []), "{tab}");
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
        let found = ["Possible causes", "all tolerances:", "current value", "target"];
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
        let scatter = scatter(entry, 1_000_000);
        let typed = vec![(answer.clone(), "1.2345e6".to_owned())];
        for question in [
            scatter,
            Question::Sensitivity { entry, record: record.clone(), answer, tolerances: Vec::new() },
            Question::Causes { entry, record: record.clone(), solution, typed },
        ] {
            let stop = Stop::new();
            thread::scope(|scope| {
                let asked = scope.spawn(|| question.answer(&stop, &|_| {}));
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

/// The Monte Carlo study that the pane begins with, of so many samples.
fn scatter(entry: &'static Entry, samples: u64) -> Question {
    let mut person = Person::at(120, 36).opens(entry.about.id);
    let bench = person.model.bench.as_mut().unwrap();
    bench.tab = bench.tab_of_plan().unwrap();
    bench.focus = Focus::Pane;
    presses(&mut person, "<left>");
    let bench = person.model.bench.as_ref().unwrap();
    let problem = &bench.problem;
    let mut plan = bench.shown().plan(problem).unwrap();
    assert!(!plan.vary.is_empty() && plan.samples == Some(2000), "{}: {plan:?}", entry.about.id);
    plan.samples = Some(samples);
    let answers = problem.found.solution.as_ref().unwrap().answers.clone();
    let record = problem.record().unwrap();
    Question::Study { entry, record, answers, plan: Box::new(plan), folder: PathBuf::new() }
}

/// One key gives the scatter of an answer of any analysis.
#[test]
fn every_analysis_has_a_scatter() {
    for entry in registry() {
        match scatter(entry, 3).answer(&Stop::new(), &|_| {}) {
            Some(Reply::Study(found)) => {
                let fits = !matches!(*found, Err(SolveError::Fields(_)));
                assert!(fits, "{}: {found:?}", entry.about.id);
            }
            other => panic!("{}: {other:?}", entry.about.id),
        }
    }
}

pub(crate) fn at(mut person: Person, tab: &str) -> Person {
    person.turns_to(tab);
    person
}

#[test]
fn which_input_matters_is_seen_as_bars() {
    let mut person = at(Person::at(80, 24).opens(FAN), "Sensitivity");
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
    let keys = "<down><down><left>500..1500 rpm<enter>";
    let mut person = at(Person::at(80, 24).opens(FAN), "Study");
    assert_snapshot!("study", person.types(keys).types("e").sees());
    let mut person = at(Person::at(160, 45).opens(FAN), "Study");
    assert_snapshot!("study_wide", person.types(keys).sees());
    assert!(person.model.bench.as_ref().unwrap().problem.plots().count() > 1, "the plot is among the others");
    let mut person = at(Person::in_portuguese(120, 36).opens(FAN), "Study");
    assert_snapshot!(
        "study_find_portuguese",
        person.types("<right><down><down>10 mm<enter><down><left>500..3000 rpm<enter>").sees()
    );
    let mut person = at(Person::in_ascii(100, 36).opens(FAN), "Study");
    assert_snapshot!("study_scatter_ascii", person.types("<left>").sees());
    let mut wrong = at(Person::at(110, 36).opens(FAN), "Study");
    wrong.types("<down><down>3..5 s<enter>");
    assert!(wrong.sees().contains("from: ") && wrong.sees().contains("is a time"), "{}", wrong.sees());
    wrong.types("<del>gamma(2)<enter>");
    assert!(wrong.sees().contains("write a range"), "{}", wrong.sees());
}

/// The plan that a test engineer wants: tolerances at several speeds, and how often a limit is exceeded.
#[test]
fn a_plan_is_put_together_by_keys() {
    for (size, name) in [((80, 24), "study_plan"), ((160, 45), "study_plan_wide")] {
        let mut person = at(Person::at(size.0, size.1).opens(FAN), "Study");
        // Uniform tolerances of every input; of these mass and Young's modulus stay, the mass normally.
        person.types("<left><down><down><enter><down>");
        assert!(person.sees().contains("uniform(1 %)"), "{}", person.sees());
        person.types(" <down><enter>");
        assert!(person.sees().contains("normal(1 %)"), "{}", person.sees());
        person.types("<del>normal(2 %)<enter><down>xx<down>xxx");
        // A speed in steps makes a grid, and the amplitude has a limit.
        person.types("a");
        let offered = person.sees();
        assert!(offered.contains("Speed of the machine") && offered.contains("vary this input"), "{offered}");
        person.types(&"<down>".repeat(4)).types("<enter>");
        person.types("<del>900 rpm; 1000 rpm; 1100 rpm<enter>");
        person.types("a<end><up><up><up><enter>");
        person.types("<c-u>amplitude > 9 mm<enter>");
        person.types("<down><right><down>500<enter>");
        if size.0 < 100 {
            person.types("e");
        }
        assert_snapshot!(name, person.sees());
    }
}

/// Content of the Study tab, cell by cell: labels and texts up to the first empty line.
fn plan_lines(person: &mut Person) -> Vec<(String, String)> {
    let screen = person.sees();
    let begins =
        screen.lines().position(|line| line.contains("Study  ")).unwrap_or_else(|| panic!("{screen}"));
    let of_pane = |line: &str| -> Option<(String, String)> {
        let part = line.split('│').find(|part| part.contains("  ") && !part.trim().is_empty())?;
        let parts: Vec<&str> = line.split('│').collect();
        let part = parts.get(parts.len().saturating_sub(2)).copied().unwrap_or(part);
        let text = part.trim_start_matches([' ', '▸']).trim_end_matches(['▾', ' ']);
        let (label, text) = text.split_once("  ")?;
        Some((label.trim().to_owned(), text.trim().to_owned()))
    };
    screen.lines().skip(begins).map_while(of_pane).collect()
}

/// Text on the screen behind the name of a cell.
fn cell(person: &mut Person, name: &str) -> String {
    let lines = plan_lines(person);
    let found = lines.iter().find(|(label, _)| label == name);
    found.unwrap_or_else(|| panic!("`{name}` is not among {lines:?}")).1.clone()
}

/// Options of the list on the screen.
fn offered(person: &Person) -> Vec<String> {
    match &person.model.dialog {
        Some(Dialog::Choice { options, .. }) => options.iter().map(|option| option.label.clone()).collect(),
        other => panic!("{other:?}"),
    }
}

/// The input of a sweep and its answer.
fn about(person: &mut Person) -> (String, String) {
    let lines = plan_lines(person);
    let varied = lines.iter().find(|(_, text)| text.contains("..")).unwrap_or_else(|| panic!("{lines:?}"));
    (varied.0.clone(), cell(person, "Answer"))
}

fn pair(input: &str, answer: &str) -> (String, String) {
    (input.to_owned(), answer.to_owned())
}

#[test]
fn sensitivity_and_study_begin_with_the_input_under_the_cursor() {
    // Of the fan the main answer rests on every input.
    let mut person = Person::at(120, 36).opens(FAN);
    person.types("<end>").turns_to("Study");
    assert_eq!(about(&mut person), pair("Speed of the machine", "Amplitude at this speed"));
    // Of the mass on a shaft only the torsional frequency, its third one, rests on the shear modulus.
    let mut person = Person::at(120, 36).opens(SHAFT);
    person.turns_to("Study");
    assert_eq!(about(&mut person), pair("Mass", "Transverse frequency"));
    person.types("[");
    assert!(person.sees().contains("◀ Transverse frequency ▶"), "{}", person.sees());
    // On a heading: the first input below it. On the last line: the shear modulus.
    person.types("<tab><down><down>]");
    assert_eq!(about(&mut person), pair("From one end to the body", "Transverse frequency"));
    person.types("[<tab><end>]");
    assert_eq!(about(&mut person), pair("Shear modulus", "Torsional frequency"));
    assert!(person.types("[").sees().contains("◀ Torsional frequency ▶"), "{}", person.sees());
    // An answer that nobody chose goes with the input.
    person.types("]<down><down><right>");
    assert_eq!(about(&mut person), pair("Mass", "Transverse frequency"));
    // What was chosen stays, wherever the cursor of the form is, and so does what a text was typed for.
    person.types("<up><right><right><tab><home><down>[]");
    assert_eq!(about(&mut person), pair("Mass", "Torsional frequency"));
    let mut person = Person::at(120, 36).opens(SHAFT);
    person.types("<end>");
    person.turns_to("Study");
    person.types("<down><down>9e6..1e7 psi<enter><tab><home>[]");
    assert_eq!(about(&mut person), pair("Shear modulus", "Torsional frequency"));
    assert_eq!(cell(&mut person, "Shear modulus"), "9e6..1e7 psi");
    // The choice is of an input, not of a place among them: another support has other inputs.
    person.types("<tab><home><down><down><right><right>");
    assert!(person.sees().contains("in a bearing at the other"), "{}", person.sees());
    assert_eq!(about(&mut person), pair("Shear modulus", "Torsional frequency"));
    // Everything as it was at first.
    person.types("<tab><home>x");
    assert_eq!(about(&mut person), pair("Mass", "Transverse frequency"));
}

#[test]
fn a_study_of_an_input_that_is_zero_has_a_range() {
    let mut person = Person::at(120, 36).opens("vibration/free-vibration");
    let form = &mut person.model.bench.as_mut().unwrap().problem.inputs.form;
    form.cursor = form.lines().iter().position(|line| line.path.ends_with(".velocity")).unwrap();
    person.types("<del>0 m/s<enter>");
    person.turns_to("Study");
    let lines = plan_lines(&mut person);
    assert!(lines.iter().any(|(_, text)| text == "-0.5..0.5 m/s:201"), "{lines:?}");
    assert!(!person.sees().contains("no width"), "{}", person.sees());
    // What cannot be negative begins at zero.
    let mut person = at(Person::at(120, 36).opens("vibration/base-excitation"), "Study");
    person.types("a");
    let offered = offered(&person);
    let at =
        offered.iter().position(|label| label == "Damping ratio").unwrap_or_else(|| panic!("{offered:?}"));
    person.types(&"<down>".repeat(at)).types("<enter>");
    assert_eq!(cell(&mut person, "Damping ratio"), "0; 0.5; 1.5");
    assert!(!person.sees().contains("no answer"), "{}", person.sees());
}

/// The input that the answer runs over is not offered for a family of curves.
#[test]
fn a_family_is_of_another_input() {
    let mut person = at(Person::at(120, 36).opens(FAN), "Study");
    person.types("a");
    let offered = offered(&person);
    assert!(offered.iter().any(|label| label == "Unbalance"), "{offered:?}");
    assert!(!offered.iter().any(|label| label == "Mass of the machine"), "{offered:?}");
    person.types("<enter>");
    assert!(cell(&mut person, "Unbalance").contains("0.05 kg*m; 0.1 kg*m; 0.2 kg*m"));
    // Another input of the family is none that varies already.
    for _ in 0..9 {
        person.types("<right>");
        assert_eq!(
            plan_lines(&mut person).iter().filter(|(label, _)| label == "Mass of the machine").count(),
            1
        );
    }
}
