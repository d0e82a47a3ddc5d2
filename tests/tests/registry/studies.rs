//! Studies over the whole registry: a row is what the problem answers at that point, to the last bit.

use std::sync::atomic::{AtomicUsize, Ordering};

use dalembert_core::{
    Answer, Entry, FieldError, Record, Refusal, SolveError, Stop, cases, find, registry,
    study::{Amount, Design, DistributionKind, Rows, Sampling, Study, StudyPlan, Variation},
    vary,
};
use dalembert_plugins as _;
use dalembert_study::points::{self, PointAnswers};
use dalembert_testkit::on_all_cores;
use itertools::zip_eq;

/// A plan that varies every number among the inputs by a percent.
fn plan_of(entry: &Entry, record: &Record) -> StudyPlan {
    let variation = |input: &vary::VariedInput| Variation {
        input: Some(input.path.clone()),
        distribution: Some(DistributionKind::Uniform),
        tolerance: Some(Amount::Text("1e-3 %".to_owned())).filter(|_| input.si != 0.0),
        ..Variation::default()
    };
    let inputs = vary::inputs(record);
    StudyPlan {
        problem: entry.about.id.to_owned(),
        samples: Some(3),
        sampling: Sampling::Sobol,
        vary: inputs.iter().filter(|input| input.si != 0.0).take(60).map(variation).collect(),
        ..StudyPlan::default()
    }
}

#[test]
fn a_row_is_what_the_problem_answers_at_that_point() {
    let compared = AtomicUsize::new(0);
    on_all_cores(registry(), |_, entry| {
        let id = entry.about.id;
        let case = cases::first(entry).unwrap_or_else(|| panic!("{id} has no case"));
        let record = case.record(entry).unwrap_or_else(|errors| panic!("{id}: {errors:?}"));
        let solution = entry.solve(&record, &Stop::new()).unwrap_or_else(|error| panic!("{id}: {error}"));
        let mut plan = plan_of(entry, &record);
        let no_data = |_: &str| panic!("{id}: the plan names no file");
        // An input that the analysis cannot vary is left as it is.
        let study = loop {
            let design =
                Design::new(&plan, &record, &no_data).unwrap_or_else(|errors| panic!("{id}: {errors:?}"));
            match Study::new(entry, &record, &plan, design, &solution) {
                Ok(study) => break study,
                Err(SolveError::Fields(errors)) => {
                    let is_wrong = |path: &str| errors.iter().any(|error: &FieldError| error.path == path);
                    let before = plan.vary.len();
                    plan.vary.retain(|variation| !is_wrong(variation.input.as_deref().unwrap_or_default()));
                    assert!(plan.vary.len() < before, "{id}: {errors:?}");
                }
                Err(error) => panic!("{id}: {error}"),
            }
        };
        let mut rows = Rows::default();
        let points = study.design.points();
        let mut evaluation = study.evaluation().unwrap_or_else(|error| panic!("{id}: {error}"));
        evaluation.rows(0..points, &mut rows, &Stop::new()).unwrap_or_else(|error| panic!("{id}: {error}"));
        let inputs = study.design.inputs.len();
        let (mut shown, mut si) = (vec![0.0; inputs], vec![0.0; inputs]);
        for (point, row) in zip_eq(0..points, rows.iter().collect::<Vec<_>>()) {
            study.design.rows(point, &mut shown, &mut si);
            let mut changed = record.clone();
            for (input, si) in zip_eq(&study.design.inputs, &si) {
                changed = vary::changed(&changed, &input.path, *si).expect("an input of the problem");
            }
            if let Some(why) = row.refusal {
                assert!(
                    row.answers.iter().all(|value| value.is_nan()),
                    "{id}: point {point} has answers: {why:?}"
                );
                let is_outside = zip_eq(&study.design.inputs, &si).any(|(input, si)| !input.permits(*si));
                assert!(is_outside || entry.solve(&changed, &Stop::new()).is_err(), "{id}: {why:?}");
                continue;
            }
            let solved = entry.solve(&changed, &Stop::new()).unwrap_or_else(|error| panic!("{id}: {error}"));
            for (answer, ours) in zip_eq(&study.answers, row.answers) {
                let name = answer.name.to_string();
                let theirs = solved.answer(&name).and_then(Answer::si);
                let theirs = theirs.map_or(f64::NAN, |si| answer.unit.value(si));
                let is_same = ours.to_bits() == theirs.to_bits() || ours.is_nan() && theirs.is_nan();
                assert!(is_same, "{id}: {name} of point {point} is {ours}, and {theirs} where it is solved");
                compared.fetch_add(1, Ordering::Relaxed);
            }
        }
    });
    let compared = compared.into_inner();
    assert!(compared > 2_000, "only {compared} answers were compared");
}

#[test]
fn a_sweep_is_what_the_problem_answers_at_each_point() {
    on_all_cores(registry(), |_, entry| {
        let id = entry.about.id;
        let record = cases::first(entry).unwrap().record(entry).unwrap();
        let solution = entry.solve(&record, &Stop::new()).unwrap();
        let names: Vec<String> = solution
            .answers
            .iter()
            .filter(|answer| answer.si().is_some())
            .map(|answer| answer.name.to_string())
            .collect();
        let wanted: Vec<&str> = names.iter().map(String::as_str).collect();
        let inputs = vary::inputs(&record);
        let Some(input) = inputs.iter().find(|input| {
            input.si != 0.0 && entry.prepare(&record, &[&input.path], &wanted).is_ok() && !wanted.is_empty()
        }) else {
            return;
        };
        let input = points::varied(&record, [input.path.as_str()]).unwrap();
        let points = [1.0, 1.0 + 1e-5, 1.0 - 1e-5].map(|factor| factor * input[0].si);
        let swept = points::solve((entry, &record), &input, &wanted, &points, 2, &Stop::new()).unwrap();
        for (point, answers) in zip_eq(points, swept.answers.chunks_exact(wanted.len())) {
            let Ok(solved) =
                entry.solve(&vary::changed(&record, &input[0].path, point).unwrap(), &Stop::new())
            else {
                assert!(answers.iter().all(|answer| answer.is_nan()), "{id}");
                continue;
            };
            for (name, answer) in zip_eq(&wanted, answers) {
                let own = solved.answer(name).and_then(Answer::si);
                assert_eq!(own.map(f64::to_bits), Some(answer.to_bits()), "{id}: {name} at {point}");
            }
        }
    });
}

#[test]
fn a_sweep_is_the_same_on_any_number_of_threads_and_refuses_what_is_outside_its_limits() {
    let entry = find("vibration/rotating-unbalance").unwrap();
    let record = cases::first(entry).unwrap().record(entry).unwrap();
    let inputs = points::varied(&record, ["mass", "speed"]).unwrap();
    assert_eq!(points::varied(&record, ["mass", "sped"]).unwrap_err(), 1);
    let mut points: Vec<f64> = (0..20_000).flat_map(|n| [30.0 + f64::from(n) * 1e-3, 80.0]).collect();
    points[2 * 4096] = -1.0;
    points[2 * 9000 + 1] = f64::NAN;
    let swept = |threads| {
        points::solve((entry, &record), &inputs, &["amplitude", "phase"], &points, threads, &Stop::new())
            .unwrap()
    };
    let one = swept(1);
    let bits = |swept: &PointAnswers| swept.answers.iter().map(|answer| answer.to_bits()).collect::<Vec<_>>();
    for threads in [2, 3, 64] {
        assert_eq!(bits(&swept(threads)), bits(&one), "{threads} threads");
    }
    let refused: Vec<usize> = one.refused.iter().map(|(row, _)| *row).collect();
    assert_eq!(refused, [4096, 9000]);
    assert_eq!(one.refused[0].1.english(), "mass = -1 kg: outside the limits of this input");
    let is_refused = |row: usize| one.answers[2 * row..2 * row + 2].iter().all(|answer| answer.is_nan());
    assert!((0..20_000).all(|row| is_refused(row) == refused.contains(&row)));
    let stopped = Stop::new();
    stopped.stop();
    let swept = points::solve((entry, &record), &inputs, &["amplitude"], &points, 2, &stopped);
    assert!(matches!(swept, Err(SolveError::Refused(Refusal::Stopped))), "{swept:?}");
}
