//! Solutions in systems of units: every number in a coherent unit, and the working still true.

use dalembert_core::{
    Entry, Exhibit, Locale, Number, ShownUnits, Solution, printer,
    trace::{Op, ROUNDING},
};
use dalembert_units::{Unit, UnitSystem, unit};

use crate::{
    evaluator::hold,
    printed::printed_number,
    problems::{first_solutions, numbers},
};

/// The parts of a solution that have a unit: what each is, its unit, and its numbers in SI.
type Shown = (String, Unit, Vec<f64>);

/// Shows the first case of each analysis in every system: units of lengths, masses and forces are coherent, the numbers
/// are those of SI, and every printed substitution gives the result beside it. Returns the number of units and of
/// substitutions.
pub fn every_solution_is_coherent_in_every_system(entries: &[&'static Entry]) -> (usize, usize) {
    let mut faults = Vec::new();
    let (mut seen, mut read) = (0, 0);
    for (entry, solution) in first_solutions(entries) {
        for system in UnitSystem::ALL {
            let units = ShownUnits { system, is_found: false };
            let name = format!("{} in {}", entry.about.id, system.key());
            let shown = solution.clone().in_units(units);
            for ((what, unit, numbers), (_, before, _)) in
                itertools::zip_eq(with_units(&shown), with_units(&solution))
            {
                seen += 1;
                let is_material = unit.dim.length != 0 || unit.dim.mass != 0;
                if is_material && !system.writes(&unit) && !unit.text.ends_with("/Hz") && unit.text != "oz*in"
                {
                    faults.push(format!("{name}: {what} in {}", unit.text));
                }
                if !unit.dim.agrees(before.dim) {
                    faults.push(format!("{name}: {what} in {}, before in {}", unit.text, before.text));
                }
                for si in numbers {
                    let again = unit.si(unit.value(si));
                    if (again - si).abs() > 1e-14 * si.abs() {
                        faults.push(format!("{name}: {what}: {again} for {si}"));
                    }
                }
            }
            for (digits, step) in
                [5, 15].into_iter().flat_map(|digits| shown.steps.iter().map(move |step| (digits, step)))
            {
                let written = printer::step(&shown, step, &Locale::english().digits(digits));
                if written.substitution.is_empty() {
                    continue;
                }
                read += 1;
                let node = shown.trace.node(step.result);
                if let Err(why) = hold(
                    &written,
                    printed_number(&shown, step),
                    step.unit.dim,
                    digits,
                    2.0 * ROUNDING * node.scale,
                ) {
                    let (symbol, text, result) = (written.symbol, written.substitution, written.result);
                    faults.push(format!("{name} ({digits} digits): {symbol} = {text} = {result}: {why}"));
                }
            }
        }
    }
    assert!(faults.is_empty(), "{} of {seen}:\n{}", faults.len(), faults.join("\n"));
    (seen, read)
}

fn with_units(solution: &Solution) -> Vec<Shown> {
    let mut all: Vec<Shown> = Vec::new();
    for answer in &solution.answers {
        all.push((answer.name.to_string(), answer.unit.clone(), numbers(&answer.value)));
    }
    for step in &solution.steps {
        let si = match solution.trace.node(step.result).number {
            Number::Scalar(si) => vec![si],
            Number::Vector(si) => si.to_vec(),
        };
        all.push((printer::symbol(&step.symbol), step.unit.clone(), si));
    }
    for node in &solution.trace.nodes {
        if let Op::Given { unit, .. } | Op::Constant(unit) = &node.op {
            all.push(("an input".into(), unit.clone(), Vec::new()));
        }
    }
    let mut text = |what: String, text: &str| {
        if let Ok(unit) = unit(text) {
            all.push((what, unit, Vec::new()));
        }
    };
    for exhibit in &solution.exhibits {
        match exhibit {
            Exhibit::Plot(plot) => {
                text(plot.x.label.english(), plot.x.unit);
                text(plot.y.label.english(), plot.y.unit);
            }
            Exhibit::Table(table) => {
                table.columns.iter().for_each(|column| text(column.heading.english(), column.unit));
            }
            Exhibit::Drawing(_) | Exhibit::Animation(_) | Exhibit::Scene(_) => {}
        }
    }
    all
}
