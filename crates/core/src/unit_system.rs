//! The units of a whole problem: a system for every answer, table, plot and step.
//!
//! It is found from the inputs, or set: `units = "in-lbf-s"` in a file, `--units in-lbf-s` on the command line. Numbers
//! stay in SI; [`Solution::in_units`] changes the units that they are shown in, and everything that shows a solution
//! follows.

use std::{fmt, sync::Arc};

use dalembert_units::{Dim, Unit, UnitSystem, quantity_of, unit};

use crate::{
    Answer, AnswerValue, Draft, Shape, Solution, Symbol, Text, gravity, intern::fixed, table, trace::Op,
};

/// Setting of the units of a problem.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum UnitSetting {
    /// The system that the inputs show; where they show none, as [`AsTyped`](Self::AsTyped).
    #[default]
    Auto,
    /// Inputs in the units they were typed in, answers in those of the analysis.
    AsTyped,
    /// A system, whatever the inputs are typed in.
    System(UnitSystem),
}

/// System of units that a solution is shown in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ShownUnits {
    /// The system.
    pub system: UnitSystem,
    /// True if it was found from the inputs, false if it was set.
    pub is_found: bool,
}

/// The most lines of a table that are read for its units.
const TABLE_LINES: usize = 50;

/// Units of feet.
const FEET: [&str; 10] = ["ft", "foot", "feet", "yd", "mi", "mph", "fps", "psf", "slug", "slugs"];

/// Units of inches.
const INCHES: [&str; 18] = [
    "in",
    "inch",
    "inches",
    "pol",
    "polegada",
    "polegadas",
    "uin",
    "µin",
    "μin",
    "mil",
    "mils",
    "thou",
    "ips",
    "psi",
    "kpsi",
    "ksi",
    "Msi",
    "slinch",
];

/// Dimension of an unbalance.
const UNBALANCE: Dim = Dim::new(1, 1, 0, 0);

/// Standard gravity as a unit of acceleration.
const GRAVITIES: [&str; 4] = ["g0", "gn", "gs", "g's"];

/// Units of mass that are of no system here: their weight is a force, they themselves are no coherent mass.
const POUNDS: [&str; 4] = ["lb", "lbm", "lbs", "oz"];

impl UnitSetting {
    /// Every setting, in the order in which they follow one another.
    pub const ALL: [UnitSetting; 6] = [
        UnitSetting::Auto,
        UnitSetting::System(UnitSystem::Si),
        UnitSetting::System(UnitSystem::InchPound),
        UnitSetting::System(UnitSystem::FootSlug),
        UnitSetting::System(UnitSystem::MillimetreTonne),
        UnitSetting::AsTyped,
    ];

    /// Reads a setting: `auto`, `as-typed`, or the name of a system.
    ///
    /// # Errors
    /// The text is none of these.
    pub fn read(text: &str) -> Result<Self, Text> {
        match text.trim() {
            "auto" => Ok(UnitSetting::Auto),
            "as-typed" => Ok(UnitSetting::AsTyped),
            named => UnitSystem::named(named).map(UnitSetting::System).ok_or_else(|| {
                Text::new("`{text}` is no system of units; write one of {known}")
                    .with("text", named)
                    .with("known", Self::ALL.map(|setting| setting.to_string()).join(", "))
            }),
        }
    }

    /// The setting after this one; the first after the last.
    #[must_use]
    pub fn next(self) -> Self {
        let at = Self::ALL.iter().position(|setting| *setting == self).unwrap_or(0);
        Self::ALL[(at + 1) % Self::ALL.len()]
    }

    /// The system that a solution of a problem is shown in; `None` for the units as typed.
    pub fn shown(self, draft: &Draft, shape: &Shape, solution: &Solution) -> Option<ShownUnits> {
        match self {
            UnitSetting::AsTyped => None,
            UnitSetting::System(system) => Some(ShownUnits { system, is_found: false }),
            UnitSetting::Auto => {
                let any = |is: fn(Dim) -> bool| solution.answers.iter().any(|answer| is(answer.dim()));
                let forces = any(is_of_force) && !any(|dim| dim == UNBALANCE);
                let system = found(draft, shape, forces)?;
                Some(ShownUnits { system, is_found: true })
            }
        }
    }
}

impl fmt::Display for UnitSetting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            UnitSetting::Auto => "auto",
            UnitSetting::AsTyped => "as-typed",
            UnitSetting::System(system) => system.key(),
        })
    }
}

impl ShownUnits {
    /// Name of the system, and whether it was found: `Units: in·lbf·s, found from the inputs`.
    pub fn line(self) -> Text {
        let text = if self.is_found {
            Text::new("Units: {system}, found from the inputs")
        } else {
            Text::new("Units: {system}")
        };
        text.with("system", self.system.name(false))
    }
}

/// The units that the inputs are written in, and those of the columns of their tables. Zero is the same in every unit.
fn written(draft: &Draft, shape: &Shape) -> (Vec<Unit>, Vec<Unit>) {
    let (mut units, mut columns_of_tables): (Vec<Unit>, Vec<Unit>) = Default::default();
    gravity::written(draft, shape, &mut |text, shape| {
        let is_zero = !text.contains(|c: char| c.is_alphabetic() || ('1'..='9').contains(&c));
        match shape {
            _ if is_zero => {}
            Shape::Table(columns) => {
                let head = text.lines().take(TABLE_LINES).collect::<Vec<_>>().join("\n");
                let read = table::read(&head, columns());
                if read.faults.is_empty() {
                    columns_of_tables.extend(read.table.units);
                }
            }
            Shape::Quantity(measure) => {
                units.extend(gravity::unit_of(text, &Shape::Quantity(measure.meant(text))));
            }
            // Definitions and given answers.
            Shape::Text => units.extend(quantity_of(text).map(|quantity| quantity.unit)),
            shape => units.extend(gravity::unit_of(text, shape)),
        }
    });
    (units, columns_of_tables)
}

/// The system that the inputs are written in; `None` where they show none.
///
/// Every length, mass and force is in US customary units: ft·slug·s where some are of feet and none of inches, in·lbf·s
/// otherwise. Pounds and ounces of mass without a force beside them show a system only where an answer is of force
/// (`forces`): a balancing mass in ounces is wanted in ounces. Standard gravity is the same in every system.
pub(crate) fn found(draft: &Draft, shape: &Shape, forces: bool) -> Option<UnitSystem> {
    let (mut units, columns) = written(draft, shape);
    units.extend(columns);
    let is_material = |unit: &Unit| unit.dim.length != 0 || unit.dim.mass != 0;
    units.retain(|unit| is_material(unit) && !GRAVITIES.contains(&&*unit.text));
    let words: Vec<&str> = units.iter().flat_map(gravity::words).collect();
    let is_metric = |word: &&str| unit(word).is_ok_and(|unit| is_material(&unit)) && !is_customary(word);
    if words.iter().any(is_metric) {
        return None;
    }
    let any = |known: &[&str]| words.iter().any(|word| known.contains(word));
    let has_force = units.iter().any(|unit| is_of_force(unit.dim)) || any(&["slug", "slugs", "slinch"]);
    if units.is_empty() || (any(&POUNDS) && !has_force && !forces) {
        return None;
    }
    Some(if any(&FEET) && !any(&INCHES) { UnitSystem::FootSlug } else { UnitSystem::InchPound })
}

/// Returns true for the symbol of a US customary unit.
fn is_customary(word: &str) -> bool {
    gravity::is_customary_symbol(word) || FEET.contains(&word) || INCHES.contains(&word)
}

/// Returns true for a force and what is derived from one: a moment, a stiffness, a stress, a power.
fn is_of_force(dim: Dim) -> bool {
    dim.mass != 0 && dim.time != 0
}

impl Solution {
    /// The same solution in the units of a setting: in the system that it names or the inputs show; where they show none,
    /// with answers in the customary units of inputs of the same dimension.
    #[must_use]
    pub fn in_units_of(self, setting: UnitSetting, draft: &Draft, shape: &Shape) -> Self {
        match (setting.shown(draft, shape, &self), setting) {
            (Some(units), _) => self.in_units(units),
            (None, UnitSetting::Auto) => self.in_units_of_inputs(draft, shape),
            (None, _) => self,
        }
    }

    /// Answers in the unit that every input of their dimension has, where that is US customary, as in a correction mass
    /// in ounces from a trial weight in ounces, or the unit of a measured table in hertz. A metric unit of the inputs
    /// says less: lengths in millimetres do not ask for a deflection in millimetres.
    fn in_units_of_inputs(mut self, draft: &Draft, shape: &Shape) -> Self {
        let (units, columns) = written(draft, shape);
        let asks = |unit: &Unit| gravity::words(unit).any(is_customary);
        let wanted: Vec<&Unit> = units
            .iter()
            .filter(|unit| asks(unit))
            .chain(columns.iter().filter(|unit| asks(unit) || unit.text == "Hz"))
            .collect();
        for at in 0..self.answers.len() {
            let answer = &self.answers[at];
            let is_of_answer = |unit: &&Unit| unit.dim.agrees(answer.unit.dim);
            let Some(unit) = wanted.iter().copied().find(is_of_answer) else { continue };
            let mut alike = units.iter().chain(&columns).filter(is_of_answer);
            if answer.is_unit_asked || is_named(&answer.unit) || !alike.all(|other| other.text == unit.text) {
                continue;
            }
            // The root mean square of an angular velocity is of the dimension of a frequency, and none.
            if unit.text == "Hz" && self.symbol_of(answer).is_some_and(|symbol| symbol.base.starts_with('σ'))
            {
                continue;
            }
            self.show_answer_in(at, unit);
        }
        self
    }

    /// The symbol of the step that found an answer.
    fn symbol_of(&self, answer: &Answer) -> Option<Symbol> {
        let AnswerValue::Number(_, id) = answer.value else { return None };
        let Op::Step(step) = self.trace.node(id).op else { return None };
        Some(self.steps[step].symbol)
    }

    /// Shows an answer, by its place, and the step that found it in another unit. In a system of units the step keeps its
    /// unit, so that numbers can be put into later formulas as they are.
    pub fn show_answer_in(&mut self, at: usize, unit: &Unit) {
        let answer = &mut self.answers[at];
        answer.unit = unit.clone();
        if let (AnswerValue::Number(_, id), None) = (&answer.value, self.units)
            && let Op::Step(step) = self.trace.node(*id).op
        {
            self.steps[step].unit = unit.clone();
        }
    }

    /// The same solution in a system of units: answers, steps with what is put into them, tables, plots and sentences.
    /// Numbers stay what they are. The result of a question keeps the unit that it states.
    #[must_use]
    pub fn in_units(mut self, units: ShownUnits) -> Self {
        let system = units.system;
        for answer in &mut self.answers {
            if !answer.is_unit_asked && !is_named(&answer.unit) {
                answer.show_in(system);
            }
        }
        for step in &mut self.steps {
            if !is_named(&step.unit) {
                step.unit = system.unit(&step.unit);
            }
            step.why.show_in(system);
        }
        for node in &mut self.trace.nodes {
            if let Op::Constant(unit) | Op::Given { unit, .. } = &mut node.op {
                *unit = system.unit(unit);
            }
        }
        self.exhibits.iter_mut().for_each(|exhibit| exhibit.show_in(system));
        self.checks.iter_mut().for_each(|check| check.what.show_in(system));
        self.warnings.iter_mut().for_each(|warning| warning.show_in(system));
        if let Some(determined) = &mut self.determined {
            let determined = Arc::make_mut(determined);
            for unknown in &mut determined.unknowns {
                unknown.unit = system.unit(&unknown.unit);
            }
        }
        self.units = Some(units);
        self
    }
}

/// Returns true for a unit that the words beside it name: a permissible unbalance in ounce-inches.
fn is_named(unit: &Unit) -> bool {
    unit.text == "oz*in"
}

impl Answer {
    fn show_in(&mut self, system: UnitSystem) {
        self.unit = system.unit(&self.unit);
        if let AnswerValue::Set(_, limits) = &mut self.value {
            for limit in limits {
                limit.show_in(system);
            }
        }
    }
}

/// The unit of the system for what is measured in the unit of a text, kept for the whole run.
pub(crate) fn of_text(text: &'static str, system: UnitSystem) -> &'static str {
    match unit(text) {
        Ok(unit) if !system.writes(&unit) => fixed(&system.unit(&unit)),
        _ => text,
    }
}
