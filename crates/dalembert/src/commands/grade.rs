//! `dalembert grade`

use std::{
    collections::BTreeMap,
    process::ExitCode,
    sync::mpsc::{self, RecvTimeoutError},
    thread,
    time::Duration,
};

use dalembert_core::{Stop, Text};
use dalembert_report::text;
use dalembert_teaching::{
    Generator, Variant,
    grading::{self, AnswerRow, GradedAnswer, GradedProblem, Rules},
};

use crate::{
    arguments::{Grade, GradeFormat},
    commands::variants,
    console::{Console, print, print_json},
    failure::Failure,
    problem::{self, ProblemSource},
    solving,
};

/// Column of the students where no other is named.
const STUDENT: &str = "student";

/// Grades the answers of a class and prints them with the statistics of the class.
pub(crate) fn run(asked: &Grade, console: &Console) -> Result<ExitCode, Failure> {
    let source = ProblemSource { case: asked.case, ..ProblemSource::named(&asked.problem) };
    let exercise = variants::exercise(problem::read(&source, console)?);
    let rules = Rules { tolerance: variants::tolerance(&asked.tolerance)?, ..Rules::default() };
    let rules = rules
        .with_weights(&asked.weights)
        .map_err(|why| Failure::input(Text::new("--weights {why}").with_text("why", why)))?;
    let column = asked.seed_column.as_deref().unwrap_or(STUDENT);
    let named = |why| {
        let text = Text::new("{file}: {why}").with("file", &asked.answers);
        Failure::input(text.with_text("why", why))
    };
    let rows = grading::read(&problem::text_of(&asked.answers)?, column).map_err(named)?;
    let limit = Duration::from_secs(asked.time_limit);
    let locale = console.locale.at(exercise.entry.about.id);
    let graded = solving::guarded(exercise.entry, || -> Result<Vec<GradedAnswer>, Failure> {
        let own = asked.seed_column.is_some();
        let stop = Stop::new();
        let mut generator = if own {
            Some(Generator::new(&exercise, rules.tolerance, &stop).map_err(Failure::Input)?)
        } else {
            None
        };
        let common = match generator {
            Some(_) => None,
            None => Some(the_problem(&exercise, &stop)?),
        };
        let mut all = Vec::new();
        for (student, given) in by_student(&rows) {
            let drawn = match &mut generator {
                Some(generator) => {
                    Some(within(limit, |stop| variants::of_student(generator, student, stop))?)
                }
                None => None,
            };
            let Some(variant) = drawn.as_ref().or(common.as_ref()) else { continue };
            let problem = GradedProblem {
                entry: exercise.entry,
                record: &variant.record,
                solution: &variant.solution,
                asked: &variant.asked,
            };
            all.extend(within(limit, |stop| {
                grading::grade(&problem, (student, &given), &rules, &locale, stop)
            }));
        }
        Ok(all)
    })??;
    let statistics = grading::statistics(&graded);
    match asked.format {
        GradeFormat::Csv => print(&grading::csv_of(&graded, &locale))?,
        GradeFormat::Json => print_json(&grading::json_of(&graded, &statistics, &rules, &locale))?,
        GradeFormat::Text => {
            let title = exercise.heading().render(&locale);
            let document = grading::document_of(&title, &graded, &statistics, &rules, &locale);
            print(&text(&document.map(&|words| console.plain(words)), console.width))?;
        }
    }
    Ok(ExitCode::SUCCESS)
}

/// The problem itself, which every student has.
fn the_problem(exercise: &dalembert_teaching::Exercise, stop: &Stop) -> Result<Variant, Failure> {
    let (draft, record) = (exercise.draft.clone(), exercise.record.clone());
    let solution = exercise.solve(&draft, &record, stop).map_err(|error| {
        let why = Text::new("the problem itself has no answer: {why}");
        Failure::input(why.with("why", error))
    })?;
    let asked = exercise.asked(&solution);
    let (label, data, errors) = (String::new(), Vec::new(), BTreeMap::new());
    Ok(Variant { label, data, draft, record, solution, asked, errors })
}

/// Rows of each student, in the order in which students come first.
fn by_student(rows: &[AnswerRow]) -> Vec<(&str, Vec<&AnswerRow>)> {
    let mut places = BTreeMap::new();
    let mut found: Vec<(&str, Vec<&AnswerRow>)> = Vec::new();
    for row in rows {
        let student = row.student.as_str();
        let place = *places.entry(student).or_insert(found.len());
        if place == found.len() {
            found.push((student, Vec::new()));
        }
        found[place].1.push(row);
    }
    found
}

/// Runs what can be stopped, and stops it when the time is over.
fn within<T>(limit: Duration, run: impl FnOnce(&Stop) -> T) -> T {
    let stop = Stop::new();
    let (done, waiting) = mpsc::channel::<()>();
    thread::scope(|scope| {
        let stop = &stop;
        scope.spawn(move || {
            if waiting.recv_timeout(limit) == Err(RecvTimeoutError::Timeout) {
                stop.stop();
            }
        });
        let result = run(stop);
        drop(done);
        result
    })
}
