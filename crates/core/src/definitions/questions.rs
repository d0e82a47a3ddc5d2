//! Questions of the user's own, answered behind the answers of the analysis.

use dalembert_numerics::Real as _;

use super::{Plan, Question, operand_at};
use crate::{
    AnswerValue, Name, Sheet, Solution, Symbol, Text, Worksheet,
    formula::{Operand, evaluate, normalised, unit_of},
    intern::intern,
    printer,
    trace::{Id, Op},
};

/// Answers every question on the sheet of a solved problem. One without a value costs no other answer: why it has none
/// is a warning.
pub(crate) fn ask(plan: &Plan, sheet: &Sheet<'_>) {
    for (n, question) in plan.questions.iter().enumerate() {
        if let Err(why) = answer(plan, question, n, sheet) {
            let text = Text::new("{question}: no value: {why}");
            sheet.warn(|| text.with("question", &question.label).with_text("why", why));
        }
    }
}

fn answer(plan: &Plan, question: &Question, n: usize, sheet: &Sheet<'_>) -> Result<(), Text> {
    let scope = |name: &str| found(plan, name, sheet);
    let value = evaluate::<&Sheet<'_>>(&question.formula, &scope, sheet).map_err(|error| error.why)?;
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
        None => unit_of(&question.formula, dim, &|name| unit_at(plan, name, sheet)),
    };
    let unit = match unit.ascii() {
        unit if unit.is_empty() => "1",
        unit => intern(&unit),
    };
    let symbol = match &question.symbol {
        Some(symbol) => Symbol::from(intern(symbol)),
        None => Symbol::from(("Q", n + 1)),
    };
    let (name, label) = (Name::from(intern(&question.key)), intern(&question.label));
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
    sheet.mark_asked(name);
    Ok(())
}

/// Meaning of a name on a solved sheet: by its path or name, else by its symbol.
fn found<'s>(plan: &Plan, name: &str, sheet: &'s Sheet<'s>) -> Result<Option<Operand<&'s Sheet<'s>>>, Text> {
    let node = {
        let solution = sheet.solution();
        match meaning(plan, name, &solution)? {
            Some(Meaning::Node(id)) => id,
            Some(Meaning::List(numbers, unit)) => {
                let unit = unit.clone();
                drop(solution);
                let all = numbers.iter().map(|si| sheet.constant(*si, &unit)).collect();
                return Ok(Some(Operand::List(all, unit.dim)));
            }
            None => return Ok(None),
        }
    };
    Ok(Some(operand_at(sheet, node)))
}

fn unit_at(plan: &Plan, name: &str, sheet: &Sheet<'_>) -> Option<dalembert_units::Unit> {
    let solution = sheet.solution();
    match meaning(plan, name, &solution).ok()?? {
        Meaning::Node(id) => match &solution.trace.node(id).op {
            Op::Given { unit, .. } => Some(unit.clone()),
            Op::Step(step) => Some(solution.steps[*step].unit.clone()),
            _ => None,
        },
        Meaning::List(_, unit) => Some(unit),
    }
}

/// Meaning of a name in a question.
enum Meaning {
    Node(Id),
    /// Numbers in SI, and their unit.
    List(Vec<f64>, dalembert_units::Unit),
}

fn meaning(plan: &Plan, name: &str, solution: &Solution) -> Result<Option<Meaning>, Text> {
    let given = |wanted: &str| {
        let is_it = |op: &Op| matches!(op, Op::Given { path, .. } if path == wanted);
        solution.trace.nodes.iter().position(|node| is_it(&node.op)).map(|at| at as Id)
    };
    // The whole name: an input, an answer, one of several answers, a step by its number.
    if let Some(path) = plan.names.path_of_input(name).filter(|path| path == name) {
        return Ok(input_node(plan, &path, solution).or_else(|| given(&path)).map(Meaning::Node));
    }
    if let Some(answer) = solution.answer(name) {
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
    let several: Vec<_> = solution.answers.iter().filter(|answer| answer.name.base == name).collect();
    if let Some(first) = several.first() {
        let numbers: Option<Vec<f64>> = several.iter().map(|answer| answer.si()).collect();
        if let Some(numbers) = numbers {
            return Ok(Some(Meaning::List(numbers, first.unit.clone())));
        }
    }
    if let Some(step) = name.strip_prefix("step[").and_then(|rest| rest.strip_suffix(']')) {
        let step = step.parse::<usize>().ok().and_then(|n| solution.steps.get(n.checked_sub(1)?));
        return Ok(step.map(|step| Meaning::Node(step.result)));
    }
    // The symbol: of a definition, then of an input, then of a step.
    let wanted = normalised(name);
    if let Some(definition) =
        plan.definitions.iter().find(|definition| normalised(&definition.name) == wanted)
    {
        let of_step =
            solution.steps.iter().find(|step| step.symbol == Symbol::from(intern(&definition.name)));
        return Ok(of_step.map(|step| step.result).or_else(|| given(&definition.name)).map(Meaning::Node));
    }
    match &plan.names.with_symbol(name)[..] {
        [] => {}
        [only] => {
            return Ok(input_node(plan, &only.path, solution)
                .or_else(|| given(&only.path))
                .map(Meaning::Node));
        }
        several => {
            let known: Vec<String> = several.iter().map(|input| input.path.clone()).collect();
            return Err(ambiguous(name, &known));
        }
    }
    let steps: Vec<usize> = (0..solution.steps.len())
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

/// The node of an input that takes its value from a formula: the step of the formula.
fn input_node(plan: &Plan, path: &str, solution: &Solution) -> Option<Id> {
    let input = plan.inputs.iter().find(|input| input.path == path && input.formula.is_some())?;
    solution.steps.iter().find(|step| step.symbol == input.symbol).map(|step| step.result)
}

fn ambiguous(name: &str, known: &[String]) -> Text {
    Text::new("`{name}` has several meanings: write one of {known}")
        .with("name", name)
        .with("known", known.join(", "))
}
