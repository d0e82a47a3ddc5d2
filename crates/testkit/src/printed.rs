//! Printed working and answers: what is printed is true.

use std::f64::consts::TAU;

use dalembert_core::{
    AnswerValue, Entry, Language, Locale, Number, Solution, Step,
    check::{self, Verdict},
    printer,
    trace::ROUNDING,
};
use dalembert_units::{self as units, Style, write_quantity};

use crate::{
    evaluator::hold,
    problems::{SolvedCase, first_solutions, for_each_problem},
};

/// The number that the substitution of a step gives: that of the trace, over 2π where it is a frequency in cycles.
pub(crate) fn printed_number(solution: &Solution, step: &Step) -> Number {
    match solution.trace.node(step.result).number {
        Number::Scalar(x) if printer::is_in_cycles(solution, step) => Number::Scalar(x / TAU),
        number => number,
    }
}

/// Reads every printed substitution again from its text and computes it: it gives the result beside it, in both
/// languages, with 5 and 15 digits, in Unicode and in ASCII. Returns the number of substitutions.
pub fn printed_steps_give_their_results(entries: &[&'static Entry]) -> usize {
    let mut faults = Vec::new();
    let mut read = 0;
    for_each_problem(entries, |SolvedCase { name, solution, .. }| {
        for (language, digits, ascii) in [
            (Language::English, 15, false),
            (Language::English, 15, true),
            (Language::Portuguese, 15, false),
            (Language::Portuguese, 15, true),
            // As a user sees them: compared with what rounding to five digits permits.
            (Language::English, 5, false),
            (Language::Portuguese, 5, false),
        ] {
            let mut locale = Locale::of(language).digits(digits);
            locale.style.ascii = ascii;
            for step in &solution.steps {
                let mut written = printer::step(solution, step, &locale);
                if language == Language::Portuguese {
                    // As it is read where the language is known.
                    let terms = written.terms.iter_mut().map(|(_, value)| value);
                    for text in terms.chain([&mut written.substitution, &mut written.result]) {
                        *text = units::with_point(text).into_owned();
                    }
                }
                if written.substitution.is_empty() {
                    continue;
                }
                read += 1;
                let node = solution.trace.node(step.result);
                // Where large numbers cancel, what is left may be rounding alone: that of the terms and that of their sum.
                let noise = 2.0 * ROUNDING * node.scale;
                if let Err(why) = hold(&written, printed_number(solution, step), step.unit.dim, digits, noise)
                {
                    let (symbol, text) = (&written.symbol, &written.substitution);
                    faults.push(format!(
                        "{name} ({digits} digits, ascii {ascii}): {symbol} = {text} = {}: {why}",
                        written.result
                    ));
                }
            }
        }
    });
    assert!(faults.is_empty(), "{} of {read}:\n{}", faults.len(), faults.join("\n"));
    read
}

/// Types every answer of the first cases as it is shown: it is judged right. Returns the number of texts that were
/// typed.
pub fn what_is_shown_is_right_to_any_number_of_digits(entries: &[&'static Entry]) -> usize {
    let mut seen = 0;
    for (entry, solution) in first_solutions(entries) {
        for answer in &solution.answers {
            let AnswerValue::Number(Number::Scalar(si), _) = answer.value else { continue };
            let si = if si.abs() <= answer.noise { 0.0 } else { si };
            for digits in [4, 6, 12] {
                for ascii in [false, true] {
                    let typed = write_quantity(si, &answer.unit, Style { digits, ascii, ..Style::default() });
                    let verdict = check::compare(answer, &typed);
                    assert_eq!(verdict, Verdict::Right, "{} {} = {typed}", entry.about.id, answer.name);
                    seen += 1;
                }
            }
        }
    }
    seen
}
