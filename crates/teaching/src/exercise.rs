//! A problem as an exercise.

use dalembert_core::{
    AnswerValue, Draft, Entry, Number, Record, Refusal, Solution, SolveError, Statement, Stop, Text,
    UnitSetting,
};
use dalembert_report::show_answers_in;

/// A problem with its statement.
#[derive(Clone, Debug)]
pub struct Exercise {
    /// Analysis of the problem.
    pub entry: &'static Entry,
    /// Name of the case or title of the file; may be empty.
    pub title: Text,
    /// Statement, the answers that it asks for, and the ranges of its data.
    pub statement: Statement,
    /// Texts of the inputs.
    pub draft: Draft,
    /// Inputs as read.
    pub record: Record,
    /// Units of everything that is shown.
    pub units: UnitSetting,
    /// Units of answers: `(answer, unit)`.
    pub show: Vec<(String, String)>,
}

impl Exercise {
    /// Title for display: that of the analysis where the problem has none.
    pub fn heading(&self) -> Text {
        if self.title.is_empty() { Text::from(self.entry.about.title) } else { self.title.clone() }
    }

    /// Solution with these inputs, in the units that the exercise is shown in.
    ///
    /// # Errors
    /// Why there is none.
    pub fn solve(&self, draft: &Draft, record: &Record, stop: &Stop) -> Result<Solution, SolveError> {
        let solution = self.entry.solve(record, stop)?;
        let mut solution = solution.in_units_of(self.units, draft, &self.entry.shape());
        show_answers_in(&mut solution, &self.show)
            .map_err(|why| SolveError::Refused(Refusal::NoAnswer(why)))?;
        Ok(solution)
    }

    /// Names of the answers that are asked for: those that the statement names, else the questions of the problem, else
    /// its main answers.
    pub fn asked(&self, solution: &Solution) -> Vec<String> {
        let named = &self.statement.asked;
        if !named.is_empty() {
            return named.iter().filter(|name| solution.answer(name).is_some()).cloned().collect();
        }
        let names = |is_wanted: &dyn Fn(&dalembert_core::Answer) -> bool| -> Vec<String> {
            solution.answers.iter().filter(|one| is_wanted(one)).map(|one| one.name.to_string()).collect()
        };
        let questions = names(&|answer| answer.asked);
        if questions.is_empty() { names(&|answer| answer.is_main) } else { questions }
    }
}

/// Of these answers those that are single numbers, which alone can be graded by a tolerance.
pub(crate) fn numbers(asked: &[String], solution: &Solution) -> Vec<String> {
    let is_number = |name: &&String| {
        solution
            .answer(name)
            .is_some_and(|answer| matches!(answer.value, AnswerValue::Number(Number::Scalar(_), _)))
    };
    asked.iter().filter(is_number).cloned().collect()
}
