//! Linked problems, configurations, and the exam questions of several steps.

use dalembert_core::{
    AnswerValue, Entry, Exhibit, Goal, Number, Record, SolveError, Stop, cases, cases::Comparison,
    exams::exams, file, find, vary,
};
use dalembert_plugins as _;
use itertools::zip_eq;

use super::{number, solved};

const FAN: &str = r#"format = 2
title = "Fan on a bracket"

[let]
E = "210 GPa"

[problem.bracket]
analysis = "vibration/equivalent-stiffness"

[problem.bracket.inputs] # steel
motion.translation.springs.cantilever = { length = "0.5 m", young = "E", section.rectangle = { breadth = "60 mm", height = "10 mm" } }
motion.translation.load.mass.mass = "fan.mass"
motion.translation.spring_masses = []

[problem.fan]
analysis = "vibration/rotating-unbalance"

[problem.fan.let]
bolt = "12 g"

[problem.fan.inputs]
mass = "40 kg"
unbalance = "bolt * 120 mm"
support.stiffness.stiffness = "bracket.stiffness"
damping.ratio.ratio = "0.05"
speed = "1500 rpm"

[problem.fan.configuration.weighted]
mass = "m + 2 kg"

[problem.fan.ask]
"force amplitude" = "m0e*omega^2"

[problem.fan.show]
amplitude = "um" # small

[ask]
"share" = "fan.force_amplitude/(bracket.stiffness*fan.X)"
"drop" = "fan.weighted.natural_frequency/fan.natural_frequency"
"#;

const WEIGHED: &str = r#"format = 2
analysis = "vibration/rotating-unbalance"
title = "Fan with an unknown base"

[let]
bolt = "12 g"

[inputs]
mass = "?"
unbalance = "bolt * 120 mm"
support.stiffness.stiffness = "? 10 kN/m .. 10 MN/m"
damping.ratio.ratio = "0.05"
speed = "1500 rpm"

[configuration.weighted]
mass = "m + 2 kg"

[given]
natural_frequency = "8.2 Hz"
"weighted.natural_frequency" = "7.9 Hz"

[ask]
"peak to peak" = "2*X"
"force amplitude" = "m0e * omega^2"
"power" = { value = "c*(omega*X)^2/2", unit = "W", key = "power", symbol = "P" }
"#;

fn read(text: &str) -> (&'static Entry, Record) {
    read_with(text, &[])
}

/// The problem of a text among files.
fn read_with(text: &str, files: &[(&str, &str)]) -> (&'static Entry, Record) {
    let problem = parse(text, files).unwrap_or_else(|why| panic!("{why}\n{text}"));
    let record = problem.draft.read(&problem.entry.shape());
    (problem.entry, record.unwrap_or_else(|errors| panic!("{errors:?}\n{text}")))
}

fn parse(text: &str, files: &[(&str, &str)]) -> Result<file::ProblemFile, String> {
    let read = file::parse_with(text, &mut |path| {
        let found = files.iter().find(|(name, _)| *name == path);
        found.map(|(_, text)| (*text).to_owned()).ok_or_else(|| "file not found".into())
    });
    read.map_err(|errors| errors.iter().map(|error| error.why.english()).collect::<Vec<_>>().join("; "))
}

/// Error of a text: of the file, of its inputs, or of the solution.
fn wrong(text: &str, files: &[(&str, &str)]) -> String {
    let problem = match parse(text, files) {
        Ok(problem) => problem,
        Err(why) => return why,
    };
    let record = problem.draft.read(&problem.entry.shape()).map_err(SolveError::Fields);
    match record.and_then(|record| problem.entry.solve(&record, &Stop::new())) {
        Ok(solution) => solution.warnings.iter().map(dalembert_core::Text::english).collect(),
        Err(error) => error.to_string(),
    }
}

fn near(found: f64, wanted: f64) {
    assert!((found - wanted).abs() <= 1e-9 * wanted.abs(), "{found} in place of {wanted}");
}

#[test]
fn an_answer_of_one_problem_is_an_input_of_another() {
    let solution = solved(FAN);
    let stiffness = 3.0 * 210e9 * (0.06 * 0.01f64.powi(3) / 12.0) / 0.5f64.powi(3);
    near(number(&solution, "bracket.stiffness"), stiffness);
    near(number(&solution, "fan.natural_frequency"), (stiffness / 40.0).sqrt());
    // The other way round: the bracket takes the mass of the fan.
    near(number(&solution, "bracket.natural_frequency"), (stiffness / 40.0).sqrt());
    near(number(&solution, "fan.weighted.natural_frequency"), (stiffness / 42.0).sqrt());
    near(number(&solution, "drop"), (40.0f64 / 42.0).sqrt());
    let speed = 1500.0 * std::f64::consts::TAU / 60.0;
    near(number(&solution, "fan.force_amplitude"), 0.012 * 0.12 * speed * speed);
    let share = 0.012 * 0.12 * speed * speed / (stiffness * number(&solution, "fan.amplitude"));
    near(number(&solution, "share"), share);
    let headings: Vec<&str> = solution.problems.iter().map(|problem| problem.name).collect();
    assert_eq!(headings, ["bracket", "fan", "fan.weighted", ""]);
    assert!(solution.checks.iter().all(|check| check.passed));
}

#[test]
fn two_frequencies_and_an_added_weight_give_mass_and_spring() {
    let solution = solved(WEIGHED);
    let tau = std::f64::consts::TAU;
    let mass = 2.0 / ((8.2f64 / 7.9).powi(2) - 1.0);
    near(number(&solution, "mass"), mass);
    near(number(&solution, "support.stiffness.stiffness"), mass * (tau * 8.2).powi(2));
    near(number(&solution, "weighted.natural_frequency"), tau * 7.9);
    let determined = solution.determined.as_deref().expect("two inputs were unknown");
    assert_eq!(determined.solutions.len(), 1);
    let amplitude = number(&solution, "amplitude");
    near(number(&solution, "peak_to_peak"), 2.0 * amplitude);
    let speed = 1500.0 * tau / 60.0;
    near(number(&solution, "power"), number(&solution, "damping") * (speed * amplitude).powi(2) / 2.0);
}

#[test]
fn a_given_answer_of_one_problem_determines_an_input_of_another() {
    let text = FAN
        .replace("breadth = \"60 mm\"", "breadth = \"? 1 mm .. 1 m\"")
        .replace("[ask]\n\"share\"", "[given]\n\"fan.natural_frequency\" = \"5 Hz\"\n\n[ask]\n\"share\"");
    let solution = solved(&text);
    let stiffness = 40.0 * (std::f64::consts::TAU * 5.0).powi(2);
    let breadth = stiffness * 0.5f64.powi(3) / (3.0 * 210e9) * 12.0 / 0.01f64.powi(3);
    near(
        number(&solution, "bracket.motion.translation.springs.cantilever.section.rectangle.breadth"),
        breadth,
    );
}

#[test]
fn the_plain_reading_gives_the_bits_of_the_worked_one() {
    let (mut problems, mut points) = (0, 0);
    let exams = exams().iter().map(|entry| (*entry, cases::first(entry).expect("it has a case")));
    // What is unknown is searched again at each point, on the worked reading.
    let known = exams.filter(|(entry, _)| !entry.about.cases.contains("\"?"));
    let exams = known.map(|(entry, case)| {
        (entry, case.record(entry).unwrap_or_else(|error| panic!("{}: {error}", entry.about.id)))
    });
    for (entry, record) in [read(FAN)].into_iter().chain(exams) {
        problems += 1;
        let solution = entry.solve(&record, &Stop::new()).expect("it is solved");
        let scalar = |answer: &&dalembert_core::Answer| {
            matches!(answer.value, AnswerValue::Number(Number::Scalar(_), _))
        };
        let names: Vec<String> =
            solution.answers.iter().filter(scalar).map(|answer| answer.name.to_string()).collect();
        let wanted: Vec<&str> = names.iter().map(String::as_str).collect();
        // The first input that can be varied, at its own value and at another.
        let inputs = vary::inputs(&record);
        let input = inputs.iter().find(|input| entry.prepare(&record, &[&input.path], &wanted[..1]).is_ok());
        let input = input.unwrap_or_else(|| panic!("{}: nothing can be varied", entry.about.id));
        let mut plain = entry.prepare(&record, &[&input.path], &wanted).expect("the plain reading");
        for share in [1.0, 1.001] {
            let si = input.si * share;
            let mut row = vec![f64::NAN; wanted.len()];
            plain.sweep(&[si], &mut row, &Stop::new()).expect("the answers");
            let changed = vary::changed(&record, &input.path, si).expect("a varied input");
            let worked = entry.solve(&changed, &Stop::new()).expect("it is solved");
            for (name, found) in zip_eq(&wanted, &row) {
                assert_eq!(found.to_bits(), number(&worked, name).to_bits(), "{}: {name}", entry.about.id);
                points += 1;
            }
        }
    }
    assert!(problems >= 16 && points > 500, "{problems} {points}");
}

#[test]
fn every_exam_question_comes_out() {
    let mut answers = 0;
    let mut of_four = 0;
    for entry in exams() {
        let id = entry.about.id;
        let [case] = &cases::cases(entry).unwrap_or_else(|why| panic!("{id}: {why}"))[..] else {
            panic!("{id}: one case")
        };
        let is_optimum =
            case.draft.read(&entry.shape()).is_ok_and(|record| record.goals().any(Goal::is_extreme));
        assert!(entry.linked().len() >= 2 || is_optimum, "{id} has one step");
        of_four += usize::from(entry.linked().len() >= 4);
        let verdicts = case.verify(entry).unwrap_or_else(|error| panic!("{id}: {error}"));
        for verdict in &verdicts {
            assert_eq!(verdict.outcome, Comparison::Agreed, "{id}: {verdict:?}");
        }
        answers += verdicts.len();
        assert!(case.statement.english().len() > 100, "{id} has no statement");
        assert!(find(id).is_some_and(|found| found.about.id == id));
    }
    assert!((exams().len(), of_four, answers) >= (25, 5, 200), "{} {of_four} {answers}", exams().len());
}

#[test]
fn an_exam_question_shows_the_pictures_of_the_problem_that_it_names_first() {
    let entry = find("exam/turbine-disc-critical-speed").unwrap();
    let [case] = &cases::cases(entry).unwrap()[..] else { panic!("one case") };
    let solution = entry.solve(&case.draft.read(&entry.shape()).unwrap(), &Stop::default()).unwrap();
    let title = |exhibit: &Exhibit| match exhibit {
        Exhibit::Plot(plot) => plot.title.english(),
        Exhibit::Drawing(drawing) => drawing.title.english(),
        Exhibit::Animation(animation) => animation.title.english(),
        Exhibit::Scene(scene) => scene.title.english(),
        Exhibit::Table(table) => table.title.english(),
    };
    let all: Vec<String> = solution.exhibits.iter().map(title).collect();
    assert!(all[0].starts_with("whirl: "), "{all:?}");
    assert!(all.iter().any(|title| title.starts_with("span: ")), "{all:?}");
    for of in &solution.problems {
        let own = &all[of.exhibits.clone()];
        assert!(own.iter().all(|title| title.starts_with(&format!("{}: ", of.name))), "{}: {own:?}", of.name);
    }
}

#[test]
fn an_empty_configuration_is_the_problem_itself() {
    let text = FAN.replace("mass = \"m + 2 kg\"\n", "");
    assert!(text.contains("[problem.fan.configuration.weighted]\n\n"), "{text}");
    let solution = solved(&text);
    near(number(&solution, "drop"), 1.0);
    let problem = parse(&text, &[]).expect("it is read");
    assert_eq!(file::write(&problem, &text), text);
    let again = parse(&file::write(&problem, ""), &[]).expect("what is written is read");
    assert_eq!(again.draft, problem.draft);
}

#[test]
fn a_file_is_written_as_it_was_read() {
    for text in [FAN, WEIGHED] {
        let problem = parse(text, &[]).expect("it is read");
        assert_eq!(file::write(&problem, text), text);
        let again = parse(&file::write(&problem, ""), &[]).expect("what is written is read");
        assert_eq!(again.draft, problem.draft);
        assert!(std::ptr::eq(again.entry, problem.entry));
    }
    // A changed input is changed in its place.
    let mut problem = parse(FAN, &[]).expect("it is read");
    let shape = problem.entry.shape();
    problem.draft.set(&shape, "fan.mass", "41 kg").expect("an input");
    problem.draft.set(&shape, "fan.configuration[1].formula", "m + 3 kg").expect("a configuration");
    let wanted = FAN.replace("40 kg", "41 kg").replace("m + 2 kg", "m + 3 kg");
    assert_eq!(file::write(&problem, FAN), wanted);
}

#[test]
fn the_display_of_an_answer_is_written_where_its_problem_is() {
    let mut problem = parse(FAN, &[]).expect("it is read");
    assert_eq!(problem.show, [("fan.amplitude".to_owned(), "um".to_owned())]);
    problem.show[0].1 = "mm; 3 digits".into();
    problem.show.push(("bracket.stiffness".into(), "kN/m".into()));
    problem.show.push(("drop".into(), "%".into()));
    let written = file::write(&problem, FAN);
    for lines in [
        "[problem.fan.show]\namplitude = \"mm; 3 digits\" # small\n",
        "[problem.bracket.show]\nstiffness = \"kN/m\"\n",
        "[show]\ndrop = \"%\"\n",
    ] {
        assert!(written.contains(lines), "{lines:?} is missing in\n{written}");
    }
    let mut again = parse(&written, &[]).expect("what is written is read");
    assert_eq!(again.show.len(), 3);
    // Without a display there is no line of it.
    again.show.iter_mut().for_each(|(_, unit)| unit.clear());
    let written = file::write(&again, &written);
    assert!(!written.contains("amplitude =") && !written.contains("\ndrop = \"%"), "{written}");
}

const BEAM: &str = r#"format = 2
analysis = "vibration/equivalent-stiffness"
[inputs]
motion.translation.springs.cantilever = { length = "0.5 m", young = "@material/steel.toml:E_steel", section.rectangle = { breadth = "60 mm", height = "10 mm" } }
"#;

const STEEL: &str = r#"format = 2
analysis = "vibration/equivalent-stiffness"
[let]
E_steel = "210 GPa"
[inputs]
motion.translation.springs.stiffness.stiffness = "1 N/m"
"#;

const LINKED: &str = r#"format = 2
analysis = "vibration/rotating-unbalance"
[inputs]
mass = "40 kg"
unbalance = "0.1 kg m"
support.stiffness.stiffness = "2*@parts/beam.toml:stiffness"
damping.ratio.ratio = "0.05"
speed = "1500 rpm"
"#;

#[test]
fn a_problem_of_another_file_is_linked() {
    let files = [("parts/beam.toml", BEAM), ("parts/material/steel.toml", STEEL)];
    let (entry, record) = read_with(LINKED, &files);
    let solution = entry.solve(&record, &Stop::new()).expect("it is solved");
    let stiffness = 3.0 * 210e9 * (0.06 * 0.01f64.powi(3) / 12.0) / 0.5f64.powi(3);
    near(number(&solution, "beam.stiffness"), stiffness);
    near(number(&solution, "natural_frequency"), (2.0 * stiffness / 40.0).sqrt());
    let problem = parse(LINKED, &files).expect("it is read");
    assert_eq!(file::write(&problem, LINKED), LINKED);
    let paths: Vec<&str> = problem.files.iter().map(|file| file.path.as_str()).collect();
    assert_eq!(paths, ["parts/material/steel.toml", "parts/beam.toml"]);
}

#[test]
fn what_is_wrong_is_named() {
    let fan = |from: &str, to: &str| FAN.replace(from, to);
    let weighed = |from: &str, to: &str| WEIGHED.replace(from, to);
    let steel: &[(&str, &str)] = &[("parts/beam.toml", BEAM), ("parts/material/steel.toml", STEEL)];
    let in_a_circle = BEAM.replace("@material/steel.toml:E_steel", "@../parts/beam.toml:E_steel");
    let circle: &[(&str, &str)] = &[("parts/beam.toml", &in_a_circle)];
    let rows: &[(String, &[(&str, &str)], &str)] = &[
        (fan("\"bracket.stiffness\"", "\"bracket.stifness\""), &[], "did you mean `stiffness`"),
        (fan("\"fan.mass\"", "\"fan.amplitude*1 kg/m\""), &[], "defined in a circle: "),
        (
            fan("analysis = \"vibration/rotating-unbalance\"", ""),
            &[],
            "problem.fan: the analysis is not named",
        ),
        (
            fan("vibration/rotating-unbalance", "vibration/rotating-unbalanc"),
            &[],
            "did you mean `vibration/rotating-unbalance`",
        ),
        (fan("[problem.fan.let]\nbolt", "[problem.fan.let]\nmass"), &[], "is the name of an input"),
        (fan("[let]\nE =", "[let]\nfan = \"1 m\"\nE ="), &[], "`fan` is the name of a problem"),
        (
            fan("[problem.fan.configuration.weighted]\nmass", "[problem.fan.configuration.weighted]\nmas"),
            &[],
            "did you mean `mass`",
        ),
        (fan("\"m + 2 kg\"", "\"m + 2 m\""), &[], "m + 2 m"),
        (fan("\"m + 2 kg\"", "\"m - 50 kg\""), &[], "must be above zero"),
        (fan("\"m + 2 kg\"", "\"-2 kg\""), &[], "must be above zero"),
        (fan("\"bracket.stiffness\"", "\"bracket.period\""), &[], "a time"),
        (fan("\"bracket.stiffness\"", "\"braket.stiffness*2\""), &[], "did you mean `bracket.stiffness`"),
        (fan("\"fan.mass\"", "\"fam.mass\""), &[], "did you mean `fan.mass`"),
        (fan("\"bracket.stiffness\"", "\"-bracket.stiffness\""), &[], "must be above zero"),
        (
            weighed("\"weighted.natural_frequency\"", "\"wheighted.natural_frequency\""),
            &[],
            "weighted.natural_frequency",
        ),
        (
            weighed("[configuration.weighted]\nmass", "[configuration.weighted]\nsupport"),
            &[],
            "write one of stiffness",
        ),
        (
            format!("{LINKED}[problem.mass]\nanalysis = \"vibration/rotating-unbalance\"\n"),
            steel,
            "`mass` is the name of an input",
        ),
        (
            format!("{LINKED}[problem.beam]\nanalysis = \"vibration/rotating-unbalance\"\n"),
            steel,
            "two linked problems are called `beam`",
        ),
        (LINKED.to_owned(), &[], "@parts/beam.toml: file not found"),
        (LINKED.to_owned(), &[("parts/beam.toml", "x = 1")], "only problem files can be linked"),
        (LINKED.to_owned(), circle, "in a circle: parts/beam.toml → parts/beam.toml"),
        (LINKED.replace("beam.toml:stiffness", "beam.toml:stifness"), steel, "did you mean `stiffness`"),
        (
            LINKED.replace("@parts/beam.toml:stiffness", "@parts/beam.toml"),
            steel,
            "a link names a file and an answer",
        ),
    ];
    for (text, files, words) in rows {
        let why = wrong(text, files);
        assert!(why.contains(words), "{why:?} does not say {words:?}\n{text}");
    }
}
