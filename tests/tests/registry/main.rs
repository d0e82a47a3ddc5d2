//! Properties of every analysis, every case and every problem file.

mod alternatives;
mod cancellation;
mod catalogue;
mod configurations;
mod coverage;
mod engines;
mod errors;
mod examples;
mod exercises;
mod exhibits;
mod extremes;
mod field_conventions;
mod file_forms;
mod glossary;
mod gravity_and_tables;
mod invariance;
mod inverse;
mod languages;
mod linked;
mod near_singular;
mod optima;
mod papers;
mod path_independence;
mod perturbation;
mod reports;
mod studies;
mod suggestions;
mod symbols;
mod teaching;
mod theory;
mod unit_systems;
mod unknowns;
mod vector_formulas;

use dalembert_core::{Solution, Stop, file};

/// The problem file of a text, solved.
fn solved(text: &str) -> Solution {
    let problem = file::parse(text).unwrap_or_else(|errors| panic!("{text}: {errors:?}"));
    let record =
        problem.draft.read(&problem.entry.shape()).unwrap_or_else(|errors| panic!("{text}: {errors:?}"));
    problem.entry.solve(&record, &Stop::new()).unwrap_or_else(|error| panic!("{text}: {error}"))
}

/// The number that an answer is.
fn number(solution: &Solution, name: &str) -> f64 {
    let answer = solution.answer(name).unwrap_or_else(|| panic!("there is no answer {name}"));
    answer.si().unwrap_or_else(|| panic!("{name} is not a number"))
}
