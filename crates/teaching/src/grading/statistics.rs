//! Statistics of a class.

use std::collections::BTreeMap;

use dalembert_core::Text;

use super::{GradedAnswer, Outcome};

/// So many of the most common causes are listed for an answer.
pub const MOST_CAUSES: usize = 5;

/// Statistics of one answer.
#[derive(Clone, Debug, PartialEq)]
pub struct AnswerStatistics {
    /// Name of the answer.
    pub answer: String,
    /// Number of students.
    pub students: usize,
    /// Number of each outcome, in the order in which they were met first.
    pub outcomes: Vec<(Outcome, usize)>,
    /// Share of right answers, those rounded early among them.
    pub right: f64,
    /// Mean credit.
    pub credit: f64,
    /// The most common causes of wrong answers, and how often each was found.
    pub causes: Vec<(Text, usize)>,
}

/// Statistics of each answer, in the order in which answers were met first. Names that are no answer have none.
pub fn statistics(graded: &[GradedAnswer]) -> Vec<AnswerStatistics> {
    let mut names: Vec<&str> = Vec::new();
    let mut of: BTreeMap<&str, Vec<&GradedAnswer>> = BTreeMap::new();
    for one in graded.iter().filter(|one| !one.expected.is_empty()) {
        if !of.contains_key(one.answer.as_str()) {
            names.push(&one.answer);
        }
        of.entry(&one.answer).or_default().push(one);
    }
    names.into_iter().map(|name| one_answer(name, &of[name])).collect()
}

fn one_answer(name: &str, graded: &[&GradedAnswer]) -> AnswerStatistics {
    let mut outcomes: Vec<(Outcome, usize)> = Vec::new();
    let mut causes: Vec<(Text, usize)> = Vec::new();
    for one in graded {
        count(&mut outcomes, &one.outcome);
        if [Outcome::Wrong, Outcome::SignOrUnit, Outcome::CarriedForward].contains(&one.outcome)
            && !one.cause.is_empty()
        {
            count(&mut causes, &one.cause);
        }
    }
    // Equal ones stay in their order.
    causes.sort_by_key(|(_, times)| std::cmp::Reverse(*times));
    causes.truncate(MOST_CAUSES);
    let students = graded.len();
    let is_right = |one: &&&GradedAnswer| [Outcome::Right, Outcome::RoundedEarly].contains(&one.outcome);
    let share = |sum: f64| sum / students.max(1) as f64;
    AnswerStatistics {
        answer: name.to_owned(),
        students,
        right: share(graded.iter().filter(is_right).count() as f64),
        credit: share(graded.iter().map(|one| one.credit).sum()),
        outcomes,
        causes,
    }
}

fn count<T: PartialEq + Clone>(counts: &mut Vec<(T, usize)>, what: &T) {
    match counts.iter_mut().find(|(known, _)| known == what) {
        Some((_, times)) => *times += 1,
        None => counts.push((what.clone(), 1)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_class_is_counted() {
        let one = |outcome, credit, cause: &'static str| GradedAnswer {
            student: String::new(),
            answer: "amplitude".into(),
            value: String::new(),
            expected: "19.5 mm".into(),
            outcome,
            credit,
            cause: Text::from(cause),
        };
        let class = [
            one(Outcome::Right, 1.0, ""),
            one(Outcome::Wrong, 0.0, "a"),
            one(Outcome::SignOrUnit, 0.5, "b"),
            one(Outcome::Wrong, 0.0, "b"),
        ];
        let [of] = &statistics(&class)[..] else { panic!("there is one answer") };
        assert_eq!((of.students, of.right, of.credit), (4, 0.25, 0.375));
        assert_eq!(of.causes, [(Text::from("b"), 2), (Text::from("a"), 1)]);
        assert_eq!(of.outcomes, [(Outcome::Right, 1), (Outcome::Wrong, 2), (Outcome::SignOrUnit, 1)]);
    }
}
