//! Mistakes on another way to a number than ours: where a check holds two ways together, people take either.

use std::collections::HashSet;

use super::{
    Mistake, Place,
    slip::Slip,
    steps::{LONGEST_TRACE, node_of, of_formula, of_step, scalar},
    tries::Tries,
};
use crate::{
    Refusal, Sides, Solution, Stop,
    reevaluate::{Edit, Reevaluation},
    trace::{Id, Number},
};

/// So many edits of other ways are tried at most.
const MOST: usize = 2_000;

/// Another way to the result of a step.
struct Way {
    /// The place of the step.
    step: usize,
    /// The node that has its number by the other way.
    other: Id,
}

/// Adds the results of every edit of another way to a step before the wrong answers, unless it is one of ours.
pub(super) fn by_other_method(
    all: &mut Tries<'_, '_>,
    solution: &Solution,
    stop: &Stop,
) -> Result<(), Refusal> {
    if solution.trace.nodes.len() > LONGEST_TRACE {
        return Ok(());
    }
    let wanted: Vec<Option<Id>> = all.wrong.iter().map(node_of).collect();
    let nodes: Vec<Id> = wanted.iter().flatten().copied().collect();
    let ours: HashSet<Id> = nodes.iter().flat_map(|id| solution.ancestors(*id)).collect();
    let mut tries = 0;
    for Way { step, other } in others(solution, &ours) {
        let result = solution.steps[step].result;
        let of_other = solution.ancestors(other);
        if of_other.contains(&result) {
            continue;
        }
        let mut again = Reevaluation::new(solution, &[&nodes[..], &[other]].concat());
        let mut slips: Vec<(usize, Slip)> = Vec::new();
        let mut formula = Vec::new();
        of_formula(solution, other, &mut formula);
        slips.extend(formula.into_iter().map(|slip| (step, slip)));
        for (place, step) in solution.steps.iter().enumerate() {
            if of_other.contains(&step.result) && !ours.contains(&step.result) {
                slips.extend(of_step(solution, place).into_iter().map(|slip| (place, slip)));
            }
        }
        for (place, Slip { prior, change, edit, of }) in slips {
            stop.check()?;
            tries += 1;
            if tries > MOST {
                return Ok(());
            }
            let taken = again.with(&[&edit], &[Some(other)]).pop().map_or(f64::NAN, scalar);
            if !taken.is_finite() {
                continue;
            }
            let taken = Edit::number(result, Number::Scalar(taken));
            let values = again.with(&[&edit, &taken], &wanted).into_iter().map(scalar).collect();
            let mistake = Mistake::new(Place::Step(place, solution.steps[place].symbol), change).of(of);
            all.push(prior, mistake, values, true, vec![taken]);
        }
    }
    Ok(())
}

/// The other ways to results that the wrong answers were made from.
fn others(solution: &Solution, ours: &HashSet<Id>) -> Vec<Way> {
    let number = |id: Id| scalar(solution.trace.node(id).number);
    // The side of a check may be the formula of the step.
    let step_of = |id: Id| {
        let is_it = |result: Id| {
            result == id
                || (number(result) - number(id)).abs() <= 1e-13 * number(id).abs() && number(id) != 0.0
        };
        solution.steps.iter().position(|step| ours.contains(&step.result) && is_it(step.result))
    };
    let sides = solution.checks.iter().filter(|check| check.passed).filter_map(|check| match check.sides {
        Sides::Both(left, right) => Some([(left, right), (right, left)]),
        _ => None,
    });
    sides.flatten().filter_map(|(own, other)| Some(Way { step: step_of(own)?, other })).collect()
}
