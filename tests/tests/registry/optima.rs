//! Optima: over the registry, against closed forms and brute force, with tolerances, choices and two wanted answers; and what
//! is refused.

use dalembert_core::{Exhibit, Goal, Solution, SolveError, Stop, Text, file, registry};
use dalembert_plugins as _;
use dalembert_testkit::optima;
use dalembert_tests::times;
use itertools::{Itertools as _, zip_eq};

use crate::{number, solved};

#[test]
fn no_optimum_is_worse_than_a_scan() {
    let found = optima::an_optimum_is_no_worse_than_a_scan(registry(), times());
    assert!(found >= 100, "{found} optima");
}

/// A machine on springs, with a requirement in place of `given`.
fn machine(inputs: &str, given: &str) -> String {
    format!(
        "format = 2\nanalysis = \"vibration/rotating-unbalance\"\n[inputs]\nunbalance = \"0.02 kg*m\"\n\
         damping.ratio.ratio = \"0.1\"\nspeed = \"900 rpm\"\n{inputs}\n[given]\n{given}\n"
    )
}

fn refused(text: &str) -> String {
    let problem = file::parse(text).unwrap_or_else(|errors| panic!("{text}: {errors:?}"));
    let record = match problem.draft.read(&problem.entry.shape()) {
        Ok(record) => record,
        Err(errors) => return SolveError::Fields(errors).to_string(),
    };
    match problem.entry.solve(&record, &Stop::new()) {
        Ok(solution) => panic!("{text} is solved: {:?}", solution.answers),
        Err(error) => error.to_string(),
    }
}

/// The amplitude of rotating unbalance over the damping ratio, X = m₀e r²/(m √((1 − r²)² + (2ζr)²)), has its peak over r at
/// 1/√(1 − 2ζ²).
#[test]
fn the_peak_of_a_resonance_is_found() {
    let inputs = "mass = \"50 kg\"\nsupport.stiffness.stiffness = \"? 20 kN/m .. 2 MN/m\"";
    let solution = solved(&machine(inputs, "amplitude = \"maximum\""));
    let ratio = number(&solution, "frequency_ratio");
    assert!((ratio - 1.0 / (1.0_f64 - 2.0 * 0.01).sqrt()).abs() < 1e-6, "{ratio}");
    let determined = solution.determined.as_deref().expect("an optimum");
    let optimum = determined.optimum.as_ref().expect("an optimum");
    assert!(optimum.ended > 4 && optimum.ended <= optimum.starts, "{optimum:?}");
    assert!(solution.checks.iter().all(|check| check.passed), "{:?}", solution.checks);
}

/// A limit that is reached is kept to the last bit, and decides.
#[test]
fn a_limit_decides() {
    let inputs = "mass = \"? 20 kg .. 200 kg\"\nsupport.stiffness.stiffness = \"100 kN/m\"";
    let solution =
        solved(&machine(inputs, "mass = \"minimum\"\namplitude = \"< 0.5 mm\"\n[ask]\nmass = \"m\""));
    let amplitude = number(&solution, "amplitude");
    assert!(amplitude <= 0.5e-3 && amplitude > 0.499_999_9e-3, "{amplitude}");
    let heavier = inputs.replace("? 20 kg .. 200 kg", &format!("{} kg", 0.999 * number(&solution, "mass")));
    assert!(number(&solved(&machine(&heavier, "")), "amplitude") > 0.5e-3);
}

/// The worst case over tolerances is that of every combination of their ends, each solved by itself.
#[test]
fn the_worst_case_is_that_of_the_corners() {
    let with = |mass: &str, stiffness: &str| {
        solved(&machine(&format!("mass = \"{mass}\"\nsupport.stiffness.stiffness = \"{stiffness}\""), ""))
    };
    let corners = [("38 kg", "97 kN/m"), ("38 kg", "103 kN/m"), ("42 kg", "97 kN/m"), ("42 kg", "103 kN/m")];
    let largest = corners.map(|(mass, stiffness)| number(&with(mass, stiffness), "amplitude"));
    let largest = largest.into_iter().fold(0.0, f64::max);
    let table = table(&with("40 kg ± 5 %", "100 kN/m +/- 3"), "Worst case");
    let row = table.iter().find(|row| row[0] == "Amplitude at this speed").expect("the amplitude").clone();
    assert_eq!(row[3], dalembert_units::write_quantity(largest, &mm(), <_>::default()));
    // An optimum under tolerances keeps its limit at every corner.
    let inputs = "mass = \"40 kg ± 5 %\"\nsupport.stiffness.stiffness = \"? 10 kN/m .. 110 kN/m ± 3 %\"";
    let solution = solved(&machine(inputs, "stiffness = \"maximum\"\namplitude = \"< 0.7 mm\""));
    let stiffness = number(&solution, "stiffness");
    let at = |mass: &str, share: f64| number(&with(mass, &format!("{} N/m", share * stiffness)), "amplitude");
    let worst = at("38 kg", 1.03).max(at("42 kg", 1.03)).max(at("38 kg", 0.97)).max(at("42 kg", 0.97));
    assert!(worst <= 0.7e-3 * (1.0 + 1e-12) && worst > 0.699_999e-3, "{worst}");
    assert!(at("40 kg", 1.0) < 0.999 * worst);
}

fn mm() -> dalembert_units::Unit {
    dalembert_units::unit("mm").expect("a unit")
}

/// The rows of the table whose title begins so.
fn table(solution: &Solution, title: &str) -> Vec<Vec<String>> {
    let locale = dalembert_core::Locale::english();
    let found = solution.exhibits.iter().find_map(|exhibit| match exhibit {
        Exhibit::Table(table) if table.title.english().starts_with(title) => Some(table),
        _ => None,
    });
    let found = found.unwrap_or_else(|| panic!("there is no table {title}"));
    let cell = |cell: &dalembert_core::Cell| match cell {
        dalembert_core::Cell::Text(text) => text.render(&locale),
        dalembert_core::Cell::Number(number) => number.to_string(),
        dalembert_core::Cell::Empty => String::new(),
    };
    found.rows.iter().map(|row| row.iter().map(cell).collect()).collect()
}

/// A row of a list is chosen as a whole: stiffness and damping of a mount belong together.
#[test]
fn a_choice_from_a_list() {
    let list = |given: &str| {
        format!(
            "format = 2\nanalysis = \"vibration/rotating-unbalance\"\n[let]\nn = \"? 1; 2; 3\"\n[inputs]\n\
             mass = \"40 kg\"\nunbalance = \"0.02 kg*m\"\nspeed = \"900 rpm\"\n\
             support.stiffness.stiffness = \"choose(n; 50 kN/m; 400 kN/m; 250 kN/m)\"\n\
             damping.ratio.ratio = \"choose(n; 0.02; 0.02; 0.3)\"\n[given]\n{given}\n"
        )
    };
    let each = [1, 2, 3].map(|n| {
        let text = list("").replace("? 1; 2; 3", &n.to_string()).replace("[given]", "");
        [number(&solved(&text), "amplitude"), number(&solved(&text), "transmitted_force")]
    });
    let best = each.iter().position_min_by(|a, b| a[1].total_cmp(&b[1])).expect("three") + 1;
    let solution = solved(&list("transmitted_force = \"minimum\""));
    assert_eq!(number(&solution, "n"), best as f64);
    let rows = table(&solution, "Optima and choices");
    assert_eq!(rows.len(), 3);
    let limited =
        solved(&list(&format!("amplitude = \"< {} m\"\ntransmitted_force = \"minimum\"", each[2][0])));
    let permitted = |n: usize| each[n][0] <= each[2][0];
    let best =
        (0..3).filter(|n| permitted(*n)).min_by(|a, b| each[*a][1].total_cmp(&each[*b][1])).expect("one");
    assert_eq!(number(&limited, "n"), (best + 1) as f64);
}

/// No point of the front is beaten in both answers, its ends are the two optima, and what is worked out lies on it.
#[test]
fn the_front_of_two_answers() {
    let text = |given: &str| {
        format!(
            "format = 2\nanalysis = \"vibration/damped-absorber\"\n[inputs]\nmain.ratio.ratio = \"0.1\"\n\
             absorber.given.tuning.ratio.ratio = \"? 0.6 .. 1.1\"\n\
             absorber.given.damping.by-absorber.ratio = \"? 0.05 .. 0.5\"\n[given]\n{given}\n"
        )
    };
    let solution = solved(&text("peak = \"minimum\"\nstroke_ratio = \"minimum\""));
    let determined = solution.determined.as_deref().expect("an optimum");
    let optimum = determined.optimum.as_ref().expect("a front");
    let points: Vec<[f64; 2]> =
        optimum.candidates.iter().map(|one| [one.answers[0], one.answers[1]]).collect();
    assert!(points.len() >= 10, "{points:?}");
    assert!(points.windows(2).all(|two| two[0][0] < two[1][0] && two[0][1] > two[1][1]), "{points:?}");
    let best = number(&solved(&text("peak = \"minimum\"")), "peak");
    assert!((points[0][0] - best).abs() < 1e-7 * best, "{} {best}", points[0][0]);
    let chosen = points[optimum.chosen];
    assert_eq!(chosen[0].to_bits(), number(&solution, "peak").to_bits());
    assert!(optimum.chosen > 0 && optimum.chosen + 1 < points.len());
    let plots = solution.exhibits.iter().filter(|exhibit| match exhibit {
        Exhibit::Plot(plot) => plot.title == Text::new("Pareto front"),
        _ => false,
    });
    assert_eq!(plots.count(), 1);
}

#[test]
fn what_is_refused_says_why() {
    let inputs = "mass = \"? 20 kg .. 200 kg\"\nsupport.stiffness.stiffness = \"100 kN/m\"";
    let choice = "mass = \"? 20 kg; 30 kg\"\nsupport.stiffness.stiffness = \"100 kN/m\"";
    let known = "mass = \"40 kg\"\nsupport.stiffness.stiffness = \"100 kN/m\"";
    for (inputs, given, words) in [
        (inputs, "amplitude = \"< 1 mm\"", "a limit alone determines nothing"),
        (choice, "amplitude = \"1 mm\"", "a choice needs an answer that is to be least or largest"),
        (known, "amplitude = \"minimum\"", "nothing is unknown"),
        (inputs, "amplitude = \"minimum\"\nphase = \"< 1 N\"", "an angle expected"),
        (inputs, "amplitude = \"minimum\"\nphase = \"< 1 deg ± 2\"", "a limit has no uncertainty"),
        (inputs, "damping_ratio = \"minimum\"", "Mass of the machine has no influence"),
        (
            inputs,
            "amplitude = \"minimum\"\nnatural_frequency = \"> 500 rad/s\"",
            "Natural frequency ≥ 500 rad/s (found: 70.711 rad/s), with Mass of the machine = 20 kg",
        ),
        (
            inputs,
            "amplitude = \"minimum\"\nphase = \"maximum\"\ntransmitted_force = \"minimum\"",
            "at most two answers can be the least or the largest",
        ),
        (
            "mass = \"40 kg ± 0 kg\"\nsupport.stiffness.stiffness = \"? 1 kN/m .. 2 kN/m\"",
            "amplitude = \"minimum\"",
            "the tolerance behind ± is above zero",
        ),
        (
            "mass = \"40 kg ± 2 m\"\nsupport.stiffness.stiffness = \"? 1 kN/m .. 2 kN/m\"",
            "amplitude = \"minimum\"",
            "mass",
        ),
        (
            "mass = \"choose(3; 20 kg; 30 kg)\"\nsupport.stiffness.stiffness = \"? 1 kN/m .. 2 kN/m\"",
            "amplitude = \"minimum\"",
            "the first argument is the number of one of the others, from 1 to 2",
        ),
    ] {
        let why = refused(&machine(inputs, given));
        assert!(why.contains(words), "{given}: {why}");
    }
}

/// An optimum at every point of a study is that of each problem by itself.
#[test]
fn an_optimum_follows_another_input() {
    let inputs = "mass = \"50 kg\"\nsupport.stiffness.stiffness = \"? 20 kN/m .. 2 MN/m\"";
    let problem = file::parse(&machine(inputs, "amplitude = \"maximum\"")).expect("it is read");
    let record = problem.draft.read(&problem.entry.shape()).expect("inputs");
    let mut evaluate = problem.entry.prepare(&record, &["speed"], &["stiffness"]).expect("it is prepared");
    let mut found = [f64::NAN; 2];
    evaluate.sweep(&[60.0, 90.0], &mut found, &Stop::new()).expect("nobody stops it");
    // k = m ω² (1 − 2ζ²)
    for (speed, stiffness) in zip_eq([60.0_f64, 90.0], found) {
        let known = 50.0 * speed.powi(2) * (1.0 - 2.0 * 0.01);
        assert!((stiffness - known).abs() < 1e-5 * known, "{stiffness} and not {known}");
    }
    assert!(record.goals().eq([Goal::Maximum]));
}
