//! Truth of a printed worked solution: every substitution, read again from its text and computed, gives the
//! result beside it.

use dalembert_core::{AnswerValue, Entry, Locale, Solution, Stop, cases, printer, registry, trace::Op};
use dalembert_plugins as _;
use dalembert_testkit::{SolvedCase, for_each_problem, printed};

/// The solution of the first case of every analysis.
fn first_solutions() -> impl Iterator<Item = (&'static Entry, Solution)> {
    registry().iter().map(|entry| {
        let cases = cases::cases(entry).expect("the cases can be read");
        let record = cases[0].record(entry).expect("the case can be read");
        (*entry, entry.solve(&record, &Stop::new()).expect("the first case has an answer"))
    })
}

#[test]
fn printed_steps_give_their_results() {
    let read = printed::printed_steps_give_their_results(registry());
    assert!(read > 100, "only {read} substitutions were read");
}

/// Analyses whose formulas have constants without an exact form: the coefficients of cam laws that are joined from pieces.
const JOINED: [&str; 1] = ["virtual-work/cam"];

#[test]
fn numbers_of_formulas_are_exact_and_none_is_zero() {
    let (locale, mut read) = (Locale::english(), 0);
    for_each_problem(registry(), |SolvedCase { name, entry, solution, .. }| {
        for step in &solution.steps {
            let formula = printer::step(solution, step, &locale).formula;
            let is_long = |number: &str| number.chars().filter(char::is_ascii_digit).count() > 9;
            let mut numbers = formula.split(|c: char| !c.is_ascii_digit() && c != '.');
            assert!(JOINED.contains(&entry.about.id) || !numbers.any(is_long), "{name}: {formula}");
            let zeros = [" + 0 ", " − 0 ", "(0 + "];
            assert!(!zeros.iter().any(|zero| formula.contains(zero)), "{name}: {formula}");
            read += 1;
        }
    });
    assert!(read > 20_000, "only {read} formulas");
}

#[test]
fn a_frequency_in_cycles_is_the_angular_frequency_over_two_pi() {
    let (locale, mut seen) = (Locale::english(), 0);
    for (entry, solution) in first_solutions() {
        for step in
            solution.steps.iter().filter(|step| step.unit.text == "Hz" && step.symbol.base.starts_with('f'))
        {
            let formula = printer::step(&solution, step, &locale).formula;
            assert!(!formula.contains('ω') || formula.contains("2π"), "{}: f = {formula}", entry.about.id);
            seen += usize::from(formula.contains("2π"));
        }
    }
    assert!(seen > 30, "only {seen} frequencies");
}

#[test]
fn the_working_of_one_answer_is_whole_and_is_nothing_else() {
    let (mut narrower, mut seen) = (0, 0);
    for (entry, solution) in first_solutions() {
        for chosen in &solution.answers {
            let AnswerValue::Number(value, _) = chosen.value else { continue };
            let alone = solution.working_of(|answer| answer.name == chosen.name);
            let place = format!("{} {}", entry.about.id, chosen.name);
            let [AnswerValue::Number(shown, id)] =
                alone.answers.iter().map(|one| one.value.clone()).collect::<Vec<_>>()[..]
            else {
                panic!("{place}: {:?}", alone.answers)
            };
            assert_eq!(shown, value, "{place}");
            assert!(
                matches!(alone.trace.node(id).op, Op::Step(_) | Op::Given { .. } | Op::Literal),
                "{place}"
            );
            // Every step is one of the whole, in its order, and the operands of each stand before it.
            let mut rest = solution.steps.iter();
            for (n, step) in alone.steps.iter().enumerate() {
                assert!(rest.any(|whole| whole == step), "{place}: step {n}");
                let mut open: Vec<_> = step.formula.into_iter().collect();
                while let Some(id) = open.pop() {
                    if let Op::Step(before) = alone.trace.node(id).op {
                        assert!(before < n, "{place}: step {n} needs step {before}");
                        assert_eq!(
                            alone.trace.node(alone.steps[before].result).number,
                            alone.trace.node(id).number
                        );
                    }
                    open.extend(alone.trace.operands(id));
                }
            }
            narrower += usize::from(alone.steps.len() < solution.steps.len());
            seen += 1;
        }
    }
    assert!(seen > 1000 && narrower > seen / 2, "{narrower} of {seen}");
}
