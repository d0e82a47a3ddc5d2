//! A study as it is typed: a few cells, of which the kind of the study says which.

use dalembert_core::{
    Answer, Record, Scale, Solution, Text, check,
    study::{Distribution, MOST_POINTS, MOST_SAMPLES, Plan},
    vary::{self, VariedInput},
};
use dalembert_units::{Decimal, Style, Unit, write_quantity};

use crate::{ask::USUAL, keys::turned, panes::answers::chosen, typed::Typed};

/// Points of a curve, unless the user says otherwise.
const POINTS: usize = 201;
/// The ends of the range of an input, unless the user says otherwise, as shares of what it is.
const RANGE: [f64; 2] = [0.5, 1.5];
/// The values of a family of curves, unless the user says otherwise, as shares of what the input is.
const FAMILY: [f64; 3] = [0.5, 1.0, 2.0];
/// Samples, unless the user says otherwise.
const SAMPLES: usize = 2000;

/// A study as it is typed.
#[derive(Debug, Default)]
pub(super) struct Cells {
    /// The cell under the cursor.
    pub(super) cursor: usize,
    /// Kind of study.
    pub(super) kind: Kind,
    /// The input that it begins with, by its path: that of the cursor of the form when the tab was turned to.
    pub(super) begins: String,
    /// The input that the user chose, by its path.
    pub(super) input: Option<String>,
    /// The answer that the user chose, by its name.
    pub(super) answer: Option<String>,
    /// The input of which every value gives a curve, by its path.
    pub(super) family: Option<String>,
    /// True if points are spread by equal ratios.
    pub(super) log: bool,
    /// True if values lie normally within their tolerances.
    pub(super) normal: bool,
    /// Texts as typed, by cell.
    pub(super) typed: Typed<Cell>,
}

/// Inputs and answers that can be studied, and those selected: by the user, or by default.
#[derive(Debug)]
pub(super) struct Subject<'s> {
    /// The inputs that are numbers.
    pub(super) inputs: Vec<VariedInput>,
    /// The place of the one that the answer runs over.
    pub(super) input: usize,
    /// The answers that are numbers.
    pub(super) answers: Vec<&'s Answer>,
    /// The place of the one that is studied.
    pub(super) answer: usize,
    /// The place of the input of which every value gives a curve.
    pub(super) family: Option<usize>,
}

/// Kind of study.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Kind {
    /// Curve of an answer over an input.
    #[default]
    Sweep,
    /// Input at which the answer takes a target value.
    Find,
    /// Monte Carlo within tolerances.
    Scatter,
}

/// A cell of a study.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Cell {
    /// Kind of study.
    Kind,
    /// The input.
    Input,
    /// The answer.
    Answer,
    /// The beginning of the range.
    From,
    /// End of the range.
    To,
    /// Number of points.
    Points,
    /// Spacing of the points.
    Spread,
    /// The input of the family of curves.
    Family,
    /// Parameter values.
    Values,
    /// The wanted value.
    Wanted,
    /// Distribution of values within their tolerances.
    Distribution,
    /// Number of samples.
    Samples,
    /// The same seed gives the same samples.
    Seed,
}

impl Cell {
    /// Label of the cell.
    pub(super) fn name(self) -> Text {
        match self {
            Cell::Kind => Text::new("Study"),
            Cell::Input => Text::new("Variable"),
            Cell::Answer => Text::new("Answer"),
            Cell::From => Text::new("Range from"),
            Cell::To => Text::new("Range to"),
            Cell::Points => Text::new("Points"),
            Cell::Spread => Text::new("Spacing"),
            Cell::Family => Text::new("Parameter"),
            Cell::Values => Text::new("Parameter values"),
            Cell::Wanted => Text::new("Target value"),
            Cell::Distribution => Text::new("Within the tolerances"),
            Cell::Samples => Text::new("Samples"),
            Cell::Seed => Text::new("Seed"),
        }
    }

    /// True if it is chosen, not typed.
    pub(super) fn is_choice(self) -> bool {
        matches!(
            self,
            Cell::Kind | Cell::Input | Cell::Answer | Cell::Spread | Cell::Family | Cell::Distribution
        )
    }
}

impl Cells {
    /// The cells from top to bottom.
    pub(super) fn cells(&self) -> Vec<Cell> {
        let mut cells = vec![Cell::Kind, Cell::Answer];
        cells.extend_from_slice(match self.kind {
            Kind::Sweep => &[Cell::Input, Cell::From, Cell::To, Cell::Points, Cell::Spread, Cell::Family],
            Kind::Find => &[Cell::Wanted, Cell::Input, Cell::From, Cell::To],
            Kind::Scatter => &[Cell::Distribution, Cell::Samples, Cell::Seed],
        });
        if self.kind == Kind::Sweep && self.family.is_some() {
            cells.push(Cell::Values);
        }
        cells
    }

    /// The cell under the cursor.
    pub(super) fn cell(&self) -> Cell {
        let cells = self.cells();
        cells[self.cursor.min(cells.len() - 1)]
    }

    /// Typed text of a cell.
    pub(super) fn text(&self, cell: Cell) -> &str {
        self.typed.text(&cell)
    }

    /// Takes a text for a cell.
    pub(super) fn set(&mut self, cell: Cell, text: String) {
        self.typed.set(&cell, text);
    }

    /// Inputs and answers that can be studied, and those selected.
    pub(super) fn subject<'s>(&self, record: &Record, solution: &'s Solution) -> Subject<'s> {
        let inputs = vary::inputs(record);
        let place = |path: &str| inputs.iter().position(|input| input.path == path);
        let own = self.input.as_deref().and_then(place);
        let input = own.or_else(|| place(&self.begins)).unwrap_or(0);
        let path = inputs.get(input).map_or("", |input| &input.path);
        let (answers, answer) = chosen(solution, self.answer.as_deref(), path);
        // A curve for each value of the input that the answer runs over is none.
        let family = self.family.as_deref().and_then(place).filter(|at| *at != input);
        Subject { inputs, input, answers, answer, family }
    }

    /// Chooses what stands so many places further in a cell.
    pub(super) fn choose(&mut self, cell: Cell, by: isize, of: &Subject<'_>) {
        let path = |at: usize| of.inputs.get(at).map(|input| input.path.clone());
        match cell {
            Cell::Kind => {
                let all = [Kind::Sweep, Kind::Find, Kind::Scatter];
                let at = all.iter().position(|kind| *kind == self.kind).unwrap_or(0);
                self.kind = all[turned(at, by, all.len())];
            }
            Cell::Input => {
                self.input = path(turned(of.input, by, of.inputs.len()));
                self.typed.0.retain(|(cell, _)| !matches!(cell, Cell::From | Cell::To));
            }
            Cell::Answer => {
                self.answer =
                    of.answers.get(turned(of.answer, by, of.answers.len())).map(|answer| name(answer));
                self.typed.0.retain(|(cell, _)| *cell != Cell::Wanted);
            }
            Cell::Family => {
                let others: Vec<usize> = (0..of.inputs.len()).filter(|at| *at != of.input).collect();
                let at = others.iter().position(|at| Some(*at) == of.family).map_or(0, |at| at + 1);
                let to = turned(at, by, others.len() + 1).checked_sub(1);
                self.family = to.and_then(|to| path(others[to]));
                self.typed.0.retain(|(cell, _)| *cell != Cell::Values);
            }
            Cell::Spread => self.log = !self.log,
            Cell::Distribution => self.normal = !self.normal,
            _ => {}
        }
    }

    /// Keeps the selected input and answer: a text was typed for them.
    pub(super) fn keep(&mut self, (input, answer): (Option<String>, Option<String>)) {
        (self.input, self.answer) = (input, answer);
    }

    /// Content of a cell: the typed text or the chosen item, or else its default.
    pub(super) fn shown(&self, cell: Cell, of: &Subject<'_>, decimal: Decimal) -> Text {
        let words = |text: &str| Text::new(text.to_owned());
        let typed = self.text(cell);
        if !typed.trim().is_empty() {
            return words(typed);
        }
        let style = Style { decimal, ..Style::default() };
        let written =
            |input: &VariedInput, share: f64| write_quantity(part(input, share), &input.unit, style);
        let end = |share: f64| of.input().map_or_else(|| words(""), |input| words(&written(input, share)));
        match cell {
            Cell::Kind => match self.kind {
                Kind::Sweep => Text::new("sweep: answer as a function of an input"),
                Kind::Find => Text::new("solve: input for a target value of the answer"),
                Kind::Scatter => Text::new("Monte Carlo: inputs within their tolerances"),
            },
            Cell::Input => of.input().map_or_else(|| words(""), |input| input.label.clone()),
            Cell::Answer => of.answer().map_or_else(|| words(""), Answer::title),
            Cell::From => end(RANGE[0]),
            Cell::To => end(RANGE[1]),
            Cell::Points => words(&POINTS.to_string()),
            Cell::Spread if self.log => Text::new("logarithmic"),
            Cell::Spread => Text::new("linear"),
            Cell::Family => match of.family() {
                Some(input) => input.label.clone(),
                None => Text::new("no parameter"),
            },
            Cell::Values => of.family().map_or_else(
                || words(""),
                |input| words(&FAMILY.map(|share| written(input, share)).join("; ")),
            ),
            Cell::Wanted => match of.answer().and_then(|answer| Some((answer, answer.si()?))) {
                Some((answer, si)) => words(&write_quantity(si, &answer.unit, style)),
                None => words(""),
            },
            Cell::Distribution if self.normal => Text::new("normal (tolerance = 3 standard deviations)"),
            Cell::Distribution => Text::new("uniform"),
            Cell::Samples => words(&SAMPLES.to_string()),
            Cell::Seed => words("1"),
        }
    }

    /// The unit of a number that is typed alone in a cell; `None` where a whole number without one is wanted.
    pub(super) fn unit(&self, cell: Cell, of: &Subject<'_>) -> Option<Unit> {
        let input = match cell {
            Cell::Wanted => return Some(of.answers.get(of.answer)?.unit.clone()),
            Cell::From | Cell::To => of.input,
            Cell::Values => of.family?,
            _ => return None,
        };
        Some(of.inputs.get(input)?.unit.clone())
    }

    /// Plan of the study.
    ///
    /// # Errors
    /// The first cell that cannot be read.
    pub(super) fn plan(&self, of: &Subject<'_>, tolerances: &[(String, f64)]) -> Result<Plan, (Cell, Text)> {
        let none = || (Cell::Input, Text::new("this problem has no numeric input"));
        let answer =
            of.answer().ok_or_else(|| (Cell::Answer, Text::new("this problem has no scalar answer")))?;
        let value = |input: &VariedInput, cell: Cell, share: f64| match self.text(cell).trim() {
            "" => Ok(part(input, share)),
            typed => input.read(typed).map_err(|why| (cell, why)),
        };
        let range = |input: &VariedInput| {
            Ok([value(input, Cell::From, RANGE[0])?, value(input, Cell::To, RANGE[1])?])
        };
        Ok(match self.kind {
            Kind::Sweep => {
                let input = of.input().ok_or_else(none)?;
                let family = match of.family() {
                    Some(other) => Some((other.path.clone(), self.values(other)?)),
                    None => None,
                };
                Plan::Sweep {
                    input: input.path.clone(),
                    range: range(input)?,
                    points: self.count(Cell::Points, POINTS)?,
                    scale: if self.log { Scale::Log } else { Scale::Linear },
                    family,
                    answer: name(answer),
                }
            }
            Kind::Find => {
                let input = of.input().ok_or_else(none)?;
                let wanted = match self.text(Cell::Wanted).trim() {
                    "" => answer.si().unwrap_or(f64::NAN),
                    typed => check::value(answer, typed).map_err(|why| (Cell::Wanted, why))?,
                };
                Plan::Find { input: input.path.clone(), range: range(input)?, answer: name(answer), wanted }
            }
            Kind::Scatter => Plan::Scatter {
                tolerances: tolerances.to_vec(),
                usual: USUAL,
                distribution: if self.normal { Distribution::Normal } else { Distribution::Uniform },
                samples: self.count(Cell::Samples, SAMPLES)?,
                seed: self.count(Cell::Seed, 1)? as u64,
                answer: name(answer),
            },
        })
    }

    fn values(&self, input: &VariedInput) -> Result<Vec<f64>, (Cell, Text)> {
        match self.text(Cell::Values).trim() {
            "" => Ok(FAMILY.map(|share| part(input, share)).to_vec()),
            typed => {
                let read = |text: &str| input.read(text.trim()).map_err(|why| (Cell::Values, why));
                typed.split(';').filter(|text| !text.trim().is_empty()).map(read).collect()
            }
        }
    }

    fn count(&self, cell: Cell, usual: usize) -> Result<usize, (Cell, Text)> {
        let most = if cell == Cell::Points { MOST_POINTS } else { MOST_SAMPLES };
        match self.text(cell).trim() {
            "" => Ok(usual),
            typed => typed
                .parse()
                .ok()
                .filter(|count| (1..=most).contains(count))
                .ok_or_else(|| (cell, Text::new("enter an integer from 1 to {most}").with("most", most))),
        }
    }
}

impl<'s> Subject<'s> {
    /// The input that the answer runs over.
    pub(super) fn input(&self) -> Option<&VariedInput> {
        self.inputs.get(self.input)
    }

    /// The answer that is studied.
    pub(super) fn answer(&self) -> Option<&'s Answer> {
        self.answers.get(self.answer).copied()
    }

    /// The input of which every value gives a curve.
    pub(super) fn family(&self) -> Option<&VariedInput> {
        self.inputs.get(self.family?)
    }

    /// The path of the input and the name of the answer.
    pub(super) fn names(&self) -> (Option<String>, Option<String>) {
        (self.input().map(|input| input.path.clone()), self.answer().map(name))
    }
}

fn name(answer: &Answer) -> String {
    answer.name.to_string()
}

/// An input that is so large a share of what it is; of one that is zero, off by that share of its unit to both sides, or
/// from zero on where it cannot be negative.
fn part(input: &VariedInput, share: f64) -> f64 {
    if input.si != 0.0 {
        return share * input.si;
    }
    let least = (RANGE[0] - 1.0) * input.unit.factor;
    let zero = if input.permits(least) { 1.0 } else { RANGE[0] };
    (share - zero) * input.unit.factor
}
