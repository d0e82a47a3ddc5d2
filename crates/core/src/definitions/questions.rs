//! Questions of the user's own, answered behind the answers of the analysis, and the meaning of a name on a solved sheet.

use dalembert_numerics::Real as _;
use dalembert_units::Unit;

use super::{
    Plan,
    names::Named,
    working::{Working, operand_at},
};
use crate::{
    AnswerValue, Name, Symbol, Text, Worksheet,
    formula::{Operand, evaluate, normalised, unit_of},
    intern::{intern, unit_text},
    printer,
    trace::{Id, Op},
};

/// Answers a question on the sheet of a solved problem. One without a value costs no other answer: why it has none is a
/// warning.
pub(super) fn ask(working: &Working<'_, '_>, at: usize) {
    if let Err(why) = answer(working, at) {
        let text = Text::new("{question}: no value: {why}");
        let label = working.plan.questions[at].label.clone();
        working.sheet.warn(|| text.with("question", label).with_text("why", why));
    }
}

/// The path that an error of a question is reported at.
pub(super) fn path(plan: &Plan, at: usize) -> String {
    let question = &plan.questions[at];
    let row = plan.questions[..at].iter().filter(|other| other.scope == question.scope).count();
    plan.names.scopes[question.scope].outside(&format!("ask[{}].formula", row + 1))
}

fn answer<'s>(working: &Working<'_, 's>, at: usize) -> Result<(), Text> {
    let (plan, sheet) = (&working.plan, working.sheet);
    let question = &plan.questions[at];
    let scope_of = &plan.names.scopes[question.scope];
    let scope = |name: &str| found(working, question.scope, name);
    let known = |name: &str| known(working, question.scope, name);
    let value = evaluate::<&crate::Sheet<'s>>(&question.formula, &scope, &known, sheet);
    let value = value.map_err(|error| error.why)?;
    let dim = value.dim();
    let unit = match &question.unit {
        Some(unit) if unit.dim.agrees(dim) => unit.clone(),
        Some(unit) => {
            let why = Text::new("`{text}` is {found}, which {unit} does not measure");
            let found = crate::reading::of_dim(dim);
            return Err(why
                .with("text", &question.formula.text)
                .with_text("found", found)
                .with("unit", unit.ascii()));
        }
        None => unit_of(&question.formula, dim, &|name| unit_of_name(working, question.scope, name)),
    };
    let unit = unit_text(&unit);
    let symbol = match &question.symbol {
        Some(symbol) => Symbol::from(intern(symbol)),
        None => {
            Symbol::from(("Q", 1 + sheet.solution().answers.iter().filter(|answer| answer.asked).count()))
        }
    };
    let (name, label) = (Name::from(intern(&scope_of.outside(&question.key))), intern(&question.label));
    let why = Text::new("Question: {question}").with("question", &question.label);
    match value {
        Operand::Number(number, _) => {
            let step = sheet.step(symbol, unit, number, why);
            sheet.answer(name, label, step);
        }
        Operand::Vector(vector, _) => {
            let step = sheet.step_vector(symbol, unit, vector, why);
            sheet.answer_vector(name, label, step);
        }
        Operand::List(all, _) => {
            let numbers: Vec<f64> = all.iter().map(|x| x.value()).collect();
            sheet.answer_list(name, label, unit, &numbers);
        }
    }
    sheet.mark_asked(name, scope_of.name, question.unit.is_some());
    Ok(())
}

/// The names that a formula of a scope can use behind its solution: those of any formula, its answers and those of other
/// problems, and the symbols of its steps.
pub(super) fn known(working: &Working<'_, '_>, scope: usize, name: &str) -> Vec<String> {
    let (names, solution) = (&working.plan.names, working.sheet.solution());
    let of = &names.scopes[scope];
    let inside = |name: String| of.inside(&name).map(str::to_owned).unwrap_or(name);
    let answers = solution.answers.iter().map(|answer| inside(answer.name.to_string()));
    let symbols = solution.steps.iter().map(|step| printer::symbol(&step.symbol));
    names
        .known(scope, name)
        .into_iter()
        .chain(answers)
        .chain(symbols.filter(|symbol| !symbol.is_empty()))
        .collect()
}

/// Value of a name in a question of a scope.
fn found<'s>(
    working: &Working<'_, 's>,
    scope: usize,
    name: &str,
) -> Result<Option<Operand<&'s crate::Sheet<'s>>>, Text> {
    match elsewhere(working, scope, name) {
        Some((of, rest)) => answered_outside(working, of, &rest),
        None => answered(working, scope, name),
    }
}

/// Value of an answer that a formula names behind its problem.
pub(super) fn answered_outside<'s>(
    working: &Working<'_, 's>,
    scope: usize,
    name: &str,
) -> Result<Option<Operand<&'s crate::Sheet<'s>>>, Text> {
    let found = answered(working, scope, name)?;
    let is_component = name.rsplit_once(['.', '_']).is_some_and(|(_, axis)| matches!(axis, "x" | "y" | "z"));
    if found.is_some() || is_component {
        return Ok(found);
    }
    let of = &working.plan.names.scopes[scope];
    let solution = working.sheet.solution();
    let names = solution.answers.iter().filter(|answer| answer.problem == of.name);
    let known: Vec<String> =
        names.filter_map(|answer| of.inside(&answer.name.to_string()).map(str::to_owned)).collect();
    let why = match crate::nearest(name, known.iter().map(String::as_str)) {
        Some(near) => {
            Text::new("`{problem}` has no answer `{name}` with these inputs; did you mean `{near}`?")
                .with("near", near)
        }
        None => Text::new("`{problem}` has no answer `{name}` with these inputs; it has {known}")
            .with("known", known.join(", ")),
    };
    Err(why.with("problem", of.name).with("name", name))
}

/// Scope and name of an answer or a question that is named from another scope.
fn elsewhere(working: &Working<'_, '_>, scope: usize, name: &str) -> Option<(usize, String)> {
    match working.plan.names.find(scope, name)? {
        Named::Answer(of, rest) => Some((of, rest)),
        Named::Question(at) => {
            let question = &working.plan.questions[at];
            Some((question.scope, question.key.clone()))
        }
        Named::Input(_) | Named::Definition(_) => None,
    }
}

fn unit_of_name(working: &Working<'_, '_>, scope: usize, name: &str) -> Option<Unit> {
    match elsewhere(working, scope, name) {
        Some((of, rest)) => unit_at(working, of, &rest),
        None => unit_at(working, scope, name),
    }
}

/// Value of a name on the solved sheet of a scope: by its path or name, else by its symbol.
pub(super) fn answered<'s>(
    working: &Working<'_, 's>,
    scope: usize,
    name: &str,
) -> Result<Option<Operand<&'s crate::Sheet<'s>>>, Text> {
    let sheet = working.sheet;
    match meaning(working, scope, name)? {
        Some(Meaning::Node(id)) => Ok(Some(operand_at(sheet, id))),
        Some(Meaning::List(numbers, unit)) => {
            let all = numbers.iter().map(|si| sheet.constant(*si, &unit)).collect();
            Ok(Some(Operand::List(all, unit.dim)))
        }
        Some(Meaning::Element(si, unit)) => Ok(Some(Operand::Number(sheet.constant(si, &unit), unit.dim))),
        None => Ok(None),
    }
}

/// Unit of a name on the solved sheet of a scope.
pub(super) fn unit_at(working: &Working<'_, '_>, scope: usize, name: &str) -> Option<Unit> {
    match meaning(working, scope, name).ok()?? {
        Meaning::Node(id) => {
            let solution = working.sheet.solution();
            match &solution.trace.node(id).op {
                Op::Given { unit, .. } => Some(unit.clone()),
                Op::Step(step) => Some(solution.steps[*step].unit.clone()),
                _ => None,
            }
        }
        Meaning::List(_, unit) | Meaning::Element(_, unit) => Some(unit),
    }
}

/// Meaning of a name on a solved sheet.
enum Meaning {
    Node(Id),
    /// Numbers in SI, and their unit.
    List(Vec<f64>, Unit),
    /// One of them.
    Element(f64, Unit),
}

fn meaning(working: &Working<'_, '_>, scope: usize, name: &str) -> Result<Option<Meaning>, Text> {
    let (plan, solution) = (&working.plan, working.sheet.solution());
    let given = |path: &str| {
        let is_it = |op: &Op| matches!(op, Op::Given { path: of, .. } if of == path);
        let at = solution.trace.nodes.iter().position(|node| is_it(&node.op));
        working.sheet.lifted(path).or(at.map(|at| at as Id)).map(Meaning::Node)
    };
    let named = plan.names.find(scope, name);
    // The whole name: an input, an answer, one of several answers, a step by its number.
    if let Some(Named::Input(path)) = &named
        && plan.names.input(path).is_some_and(|input| input.inner == name)
    {
        return Ok(given(path));
    }
    let outside = plan.names.scopes[scope].outside(name);
    if let Some(answer) = solution.answer(&outside) {
        return Ok(Some(match &answer.value {
            AnswerValue::Number(_, id) => Meaning::Node(*id),
            AnswerValue::List(all) => Meaning::List(all.clone(), answer.unit.clone()),
            AnswerValue::Set(..) => {
                return Err(
                    Text::new("`{name}` is a set of values, which a formula cannot take").with("name", name)
                );
            }
        }));
    }
    let several: Vec<_> = solution.answers.iter().filter(|answer| answer.name.base == outside).collect();
    if let Some(first) = several.first() {
        let numbers: Option<Vec<f64>> = several.iter().map(|answer| answer.si()).collect();
        if let Some(numbers) = numbers {
            return Ok(Some(Meaning::List(numbers, first.unit.clone())));
        }
    }
    if let Some((list, n)) = name.strip_suffix(']').and_then(|name| name.rsplit_once('['))
        && let Some(answer) = solution.answer(&plan.names.scopes[scope].outside(list))
        && let AnswerValue::List(all) = &answer.value
    {
        let at = n.parse::<usize>().ok().and_then(|n| n.checked_sub(1));
        let element = at.and_then(|at| all.get(at)).ok_or_else(|| {
            Text::new("`{list}` has {count} elements, counted from 1")
                .with("list", list)
                .with("count", all.len())
        })?;
        return Ok(Some(Meaning::Element(*element, answer.unit.clone())));
    }
    if let Some(step) = name.strip_prefix("step[").and_then(|rest| rest.strip_suffix(']')) {
        let step = step.parse::<usize>().ok().and_then(|n| solution.steps.get(n.checked_sub(1)?));
        return Ok(step.map(|step| Meaning::Node(step.result)));
    }
    // The symbol: of a definition, then of an input, then of a step.
    match &named {
        Some(named @ Named::Definition(at)) => {
            let path = plan.outside(&plan.definitions[*at]);
            return Ok(working.node(named).map(Meaning::Node).or_else(|| given(&path)));
        }
        Some(Named::Input(path)) => return Ok(given(path)),
        Some(Named::Question(_) | Named::Answer(..)) | None => {}
    }
    if let several @ [_, _, ..] = &plan.names.with_symbol(scope, name)[..] {
        let known: Vec<String> = several.iter().map(|input| input.inner.clone()).collect();
        return Err(ambiguous(name, &known));
    }
    let wanted = normalised(name);
    // What is not yet of a problem is that of the question itself, whose steps end with this name.
    let of_scope = |n: &usize| {
        let of = solution.problems.iter().find(|problem| problem.steps.contains(n));
        of.is_none_or(|problem| problem.name == plan.names.scopes[scope].name)
    };
    let steps: Vec<usize> = (0..solution.steps.len())
        .filter(of_scope)
        .filter(|n| normalised(&printer::symbol(&solution.steps[*n].symbol)) == wanted)
        .collect();
    match steps[..] {
        [] => Ok(None),
        [only] => Ok(Some(Meaning::Node(solution.steps[only].result))),
        _ => {
            let known: Vec<String> = steps.iter().map(|n| format!("step[{}]", n + 1)).collect();
            Err(ambiguous(name, &known))
        }
    }
}

fn ambiguous(name: &str, known: &[String]) -> Text {
    Text::new("`{name}` has several meanings: write one of {known}")
        .with("name", name)
        .with("known", known.join(", "))
}
