//! The plan of the pane: one of each kind, its cells from top to bottom, and what is chosen or typed in them.

use dalembert_core::{
    Answer, FieldError, Record, Solution, Text, check,
    study::{Sampling, StudyPlan},
    vary::{self, VariedInput},
};
use dalembert_units::{Decimal, Style, write_quantity};

use super::{
    draft::{Draft, SAMPLES, SEED, Varied, usual},
    kind::Kind,
};
use crate::{
    keys::turned,
    panes::answers::chosen,
    problem::{OpenFile, Problem},
};

/// So many inputs that vary are shown at once; of more, their number.
const MOST_SHOWN: usize = 4;

/// The plans of the pane.
#[derive(Debug, Default)]
pub(super) struct Plan {
    /// The kind that is shown.
    pub(super) kind: Kind,
    /// The input that the user chose for a curve or a search, by its path.
    input: Option<String>,
    /// Choices and texts, by kind.
    pub(super) slots: [Slot; Kind::ALL.len()],
    /// The file of the plan of that kind.
    pub(super) file: Option<OpenFile>,
    /// True if many inputs that vary are shown.
    pub(super) unfolded: bool,
}

/// Choices and texts of a kind.
#[derive(Debug, Default)]
pub(super) struct Slot {
    /// The answers by their names, none for all of them; `None` where nobody chose.
    pub(super) answers: Option<Vec<String>>,
    /// The texts; `None` while they are the usual ones.
    pub(super) draft: Option<Draft>,
    /// Target value of a search.
    pub(super) wanted: String,
}

/// Inputs and answers that can be studied, and the plan as it is, chosen and typed or by default.
#[derive(Debug)]
pub(super) struct Subject<'s> {
    /// The inputs that are numbers.
    pub(super) inputs: Vec<VariedInput>,
    /// The answers that are numbers.
    pub(super) answers: Vec<&'s Answer>,
    /// The answers that are studied, by their names; none for all of them.
    pub(super) names: Vec<String>,
    /// The texts.
    pub(super) draft: Draft,
    /// The line of each input that varies whose text is empty.
    pub(super) usual: Vec<String>,
    /// Tolerances as typed, by the paths of inputs.
    tolerances: Vec<(String, String)>,
}

/// A cell of a plan.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Cell {
    /// Kind of study.
    Kind,
    /// An answer, by its place.
    Answer(usize),
    /// Target value.
    Wanted,
    /// Many inputs that vary, shown or hidden.
    Inputs,
    /// An input that varies, by its place.
    Vary(usize),
    /// A correlation.
    Correlation(usize),
    /// A limit.
    Limit(usize),
    /// A condition.
    Condition(usize),
    /// Method by which samples are drawn.
    Sampling,
    /// Number of samples.
    Samples,
    /// The same seed gives the same samples.
    Seed,
}

impl Cell {
    /// True if it is chosen, not typed.
    pub(super) fn is_choice(self) -> bool {
        matches!(self, Cell::Kind | Cell::Answer(_) | Cell::Inputs | Cell::Sampling)
    }

    /// The cell before in its list.
    pub(super) fn before(self) -> Option<Self> {
        Some(match self {
            Cell::Answer(at) => Cell::Answer(at.checked_sub(1)?),
            Cell::Vary(at) => Cell::Vary(at.checked_sub(1)?),
            Cell::Correlation(at) => Cell::Correlation(at.checked_sub(1)?),
            Cell::Limit(at) => Cell::Limit(at.checked_sub(1)?),
            Cell::Condition(at) => Cell::Condition(at.checked_sub(1)?),
            _ => return None,
        })
    }

    /// Place in a plan, as errors name it.
    pub(super) fn path(self) -> String {
        let (list, at) = match self {
            Cell::Answer(at) => ("answers", at),
            Cell::Vary(at) => ("vary", at),
            Cell::Correlation(at) => ("correlation", at),
            Cell::Limit(at) => ("limit", at),
            Cell::Condition(at) => ("condition", at),
            Cell::Kind => return "study".to_owned(),
            Cell::Wanted => return "target".to_owned(),
            Cell::Inputs => return "vary".to_owned(),
            Cell::Sampling => return "sampling".to_owned(),
            Cell::Samples => return "samples".to_owned(),
            Cell::Seed => return "seed".to_owned(),
        };
        format!("{list}[{}]", at + 1)
    }
}

impl Plan {
    fn slot(&self) -> &Slot {
        &self.slots[self.kind as usize]
    }

    pub(super) fn slot_mut(&mut self) -> &mut Slot {
        &mut self.slots[self.kind as usize]
    }

    /// True if it begins with the input under the cursor of the form.
    pub(super) fn follows_form(&self) -> bool {
        matches!(self.kind, Kind::Sweep | Kind::Find) && self.input.is_none() && self.slot().draft.is_none()
    }

    /// Inputs and answers that can be studied, and the plan as it is.
    pub(super) fn subject<'s>(
        &self,
        problem: &Problem,
        record: &Record,
        solution: &'s Solution,
        begins: &str,
    ) -> Subject<'s> {
        let inputs = vary::inputs(record);
        let tolerances = problem.inputs.tolerances.0.clone();
        let place = |path: &str| inputs.iter().position(|input| input.path == path);
        let at = self.input.as_deref().and_then(place).or_else(|| place(begins)).unwrap_or(0);
        let draft = match &self.slot().draft {
            Some(draft) => draft.clone(),
            None => {
                let varied = |input: &VariedInput| Varied::new(&input.path, String::new());
                let vary = match self.kind {
                    Kind::Normal | Kind::Uniform => {
                        inputs.iter().filter(|input| input.step() != 0.0).map(varied).collect()
                    }
                    _ => inputs.get(at).map(varied).into_iter().collect(),
                };
                Draft { vary, ..Draft::default() }
            }
        };
        let typed = |path: &str| {
            tolerances.iter().find(|(known, _)| known == path).map_or("", |(_, typed)| typed.as_str())
        };
        let line = |varied: &Varied| {
            let input = inputs.iter().find(|input| varied.input.as_ref() == Some(&input.path));
            input.map_or_else(String::new, |input| usual(self.kind, input, typed(&input.path)))
        };
        let usual = draft.vary.iter().map(line).collect();
        let first = draft.vary.first().and_then(|varied| varied.input.clone());
        let first = first.filter(|_| matches!(self.kind, Kind::Sweep | Kind::Find)).unwrap_or_default();
        let first = if first.is_empty() { begins } else { &first };
        let (answers, answer) = chosen(solution, None, first);
        let by_default = || answers.get(answer).map(|answer| answer.name.to_string()).into_iter().collect();
        let is_known = |name: &String| answers.iter().any(|answer| answer.name.is(name));
        let names = match &self.slot().answers {
            // Chosen of other inputs, a name may be none any more; that of a file is reported to be none.
            Some(names) if self.kind == Kind::File || names.iter().all(is_known) => names.clone(),
            _ => by_default(),
        };
        Subject { inputs, answers, names, draft, usual, tolerances }
    }

    /// The cells from top to bottom.
    pub(super) fn cells(&self, of: &Subject<'_>) -> Vec<Cell> {
        let draft = &of.draft;
        let mut cells = vec![Cell::Kind];
        cells.extend((0..of.names.len().max(1)).map(Cell::Answer));
        if self.kind == Kind::Find {
            cells.truncate(2);
            cells.extend([Cell::Wanted, Cell::Vary(0)]);
            return cells;
        }
        let is_folded = draft.vary.len() > MOST_SHOWN;
        cells.extend(is_folded.then_some(Cell::Inputs));
        if !is_folded || self.unfolded {
            cells.extend((0..draft.vary.len()).map(Cell::Vary));
        }
        cells.extend((0..draft.correlation.len()).map(Cell::Correlation));
        cells.extend((0..draft.limit.len()).map(Cell::Limit));
        cells.extend((0..draft.condition.len()).map(Cell::Condition));
        if draft.is_drawn(&of.usual) {
            cells.extend([Cell::Sampling, Cell::Samples, Cell::Seed]);
        }
        cells
    }

    /// Label of a cell.
    pub(super) fn label(&self, cell: Cell, of: &Subject<'_>) -> Text {
        match cell {
            Cell::Kind => Text::new("Study"),
            Cell::Answer(_) => Text::new("Answer"),
            Cell::Wanted => Text::new("Target value"),
            Cell::Inputs => Text::new("Inputs"),
            Cell::Vary(at) => match of.draft.vary.get(at).map(|varied| varied.input.as_deref()) {
                Some(Some(path)) => {
                    of.input(path).map_or_else(|| Text::verbatim(path), |input| input.label.clone())
                }
                _ => Text::new("Table"),
            },
            Cell::Correlation(_) => Text::new("Correlation of inputs"),
            Cell::Limit(_) => Text::new("Limit"),
            Cell::Condition(_) => Text::new("Condition to meet"),
            Cell::Sampling => Text::new("Sampling"),
            Cell::Samples => Text::new("Samples"),
            Cell::Seed => Text::new("Seed"),
        }
    }

    /// Typed text of a cell; empty where it is the usual one.
    fn typed<'o>(&'o self, cell: Cell, of: &'o Subject<'_>) -> &'o str {
        let nth = |texts: &'o [String], at: usize| texts.get(at).map_or("", String::as_str);
        match cell {
            Cell::Wanted => &self.slot().wanted,
            Cell::Vary(at) => of.draft.vary.get(at).map_or("", |varied| &varied.text),
            Cell::Correlation(at) => nth(&of.draft.correlation, at),
            Cell::Limit(at) => nth(&of.draft.limit, at),
            Cell::Condition(at) => nth(&of.draft.condition, at),
            Cell::Samples => &of.draft.samples,
            Cell::Seed => &of.draft.seed,
            Cell::Kind | Cell::Answer(_) | Cell::Inputs | Cell::Sampling => "",
        }
    }

    /// True if a cell shows what is usual.
    pub(super) fn is_usual(&self, cell: Cell, of: &Subject<'_>) -> bool {
        !cell.is_choice() && self.typed(cell, of).trim().is_empty()
    }

    /// Text of a cell that is typed in: typed, or else the usual one.
    pub(super) fn text(&self, cell: Cell, of: &Subject<'_>) -> String {
        let typed = self.typed(cell, of);
        if !typed.trim().is_empty() {
            return typed.to_owned();
        }
        match cell {
            Cell::Vary(at) => of.usual.get(at).cloned().unwrap_or_default(),
            Cell::Samples => SAMPLES.to_owned(),
            Cell::Seed => SEED.to_owned(),
            Cell::Wanted => of.answer().and_then(|answer| Some((answer, answer.si()?))).map_or_else(
                String::new,
                |(answer, si)| {
                    write_quantity(
                        si,
                        &answer.unit,
                        Style { decimal: Decimal::Point, ascii: true, ..Style::default() },
                    )
                },
            ),
            _ => String::new(),
        }
    }

    /// Content of a cell as it is shown.
    pub(super) fn shown(&self, cell: Cell, of: &Subject<'_>) -> Text {
        match cell {
            Cell::Kind if self.kind == Kind::File => {
                let file = self.file.as_ref().and_then(|file| file.path.file_name());
                let text = if self.is_changed(of) { "plan {file} (changed)" } else { "plan {file}" };
                Text::new(text).with("file", file.unwrap_or_default().to_string_lossy())
            }
            Cell::Kind if self.slot().draft.is_none() || self.kind == Kind::Find => self.kind.name(),
            Cell::Kind if of.draft.is_drawn(&of.usual) => Text::new("Monte Carlo"),
            Cell::Kind => Kind::Sweep.name(),
            Cell::Answer(at) => match of.names.get(at) {
                None => Text::new("all answers"),
                Some(name) => match of.answers.iter().find(|answer| answer.name.is(name)) {
                    Some(answer) => answer.title(),
                    None => Text::verbatim(name),
                },
            },
            Cell::Inputs => {
                let text = if self.unfolded { "{count} inputs" } else { "{count} inputs, hidden" };
                Text::new(text).with("count", of.draft.vary.len())
            }
            Cell::Sampling => Text::new(match of.draft.sampling {
                Sampling::MonteCarlo => "random",
                Sampling::LatinHypercube => "Latin hypercube",
                Sampling::Sobol => "scrambled Sobol' sequence",
            }),
            _ => Text::verbatim(self.text(cell, of)),
        }
    }

    /// True if the plan is otherwise than in its file.
    fn is_changed(&self, of: &Subject<'_>) -> bool {
        let Some(file) = &self.file else { return false };
        let saved = dalembert_study::plans::read(&file.text);
        let now = self.read(of).map(|plan| StudyPlan {
            problem: saved.as_ref().map_or_else(|_| String::new(), |saved| saved.problem.clone()),
            ..plan
        });
        // The usual number of samples may be left out of a file.
        let saved = saved.map(|saved| {
            let samples = saved.samples.or_else(|| now.as_ref().ok()?.samples);
            StudyPlan { samples, ..saved }
        });
        !matches!((now, saved), (Ok(now), Ok(saved)) if now == saved)
    }

    /// The plan.
    ///
    /// # Errors
    /// Every text that cannot be read, by its place in a plan.
    pub(super) fn read(&self, of: &Subject<'_>) -> Result<StudyPlan, Vec<FieldError>> {
        of.draft.read(&of.names, &of.usual)
    }

    /// The input and its range, the answer and its wanted value of a search.
    ///
    /// # Errors
    /// Texts that cannot be read, by the paths of their cells.
    #[expect(clippy::type_complexity, reason = "the two parts of a question")]
    pub(super) fn target(
        &self,
        of: &Subject<'_>,
    ) -> Result<((String, [f64; 2]), (Box<Answer>, f64)), Vec<FieldError>> {
        let wrong = |path: String, why: Text| vec![FieldError::new(path, why)];
        let answer = of
            .answer()
            .ok_or_else(|| wrong(Cell::Answer(0).path(), Text::new("this problem has no scalar answer")))?;
        let wanted = match self.slot().wanted.trim() {
            "" => answer.si().unwrap_or(f64::NAN),
            typed => check::value(answer, typed).map_err(|why| wrong(Cell::Wanted.path(), why))?,
        };
        let plan = self.read(of)?;
        let path = Cell::Vary(0).path();
        let range = plan.vary.first().and_then(|varied| {
            let input = of.input(varied.input.as_deref()?)?;
            Some((input, varied.from.as_ref()?, varied.to.as_ref()?))
        });
        let (input, from, to) = range.ok_or_else(|| {
            wrong(path.clone(), Text::new("write the range in which the input is sought, as in 1..9 mm"))
        })?;
        let end = |amount: &dalembert_core::study::Amount| {
            amount.si(&input.unit, input.measure.kind()).map_err(|why| wrong(path.clone(), why))
        };
        Ok(((input.path.clone(), [end(from)?, end(to)?]), (Box::new(answer.clone()), wanted)))
    }

    /// The texts, to be changed: those that are shown become the user's own.
    pub(super) fn edit(&mut self, of: &Subject<'_>) -> &mut Draft {
        let draft = of.draft.clone();
        let names = of.names.clone();
        let slot = self.slot_mut();
        slot.answers.get_or_insert(names);
        slot.draft.get_or_insert(draft)
    }

    /// Takes a text for a cell.
    pub(super) fn set(&mut self, cell: Cell, text: String, of: &Subject<'_>) {
        let nth = |texts: &mut Vec<String>, at: usize, text: String| {
            if let Some(old) = texts.get_mut(at) {
                *old = text;
            }
        };
        let draft = self.edit(of);
        match cell {
            Cell::Wanted => self.slot_mut().wanted = text,
            Cell::Vary(at) => {
                if let Some(varied) = draft.vary.get_mut(at) {
                    varied.text = text;
                }
            }
            Cell::Correlation(at) => nth(&mut draft.correlation, at, text),
            Cell::Limit(at) => nth(&mut draft.limit, at, text),
            Cell::Condition(at) => nth(&mut draft.condition, at, text),
            Cell::Samples => draft.samples = text,
            Cell::Seed => draft.seed = text,
            Cell::Kind | Cell::Answer(_) | Cell::Inputs | Cell::Sampling => {}
        }
    }

    /// Chooses what stands so many places further in a cell.
    pub(super) fn choose(&mut self, cell: Cell, by: isize, of: &Subject<'_>) {
        match cell {
            Cell::Kind => {
                let all: Vec<Kind> =
                    Kind::ALL.into_iter().filter(|kind| *kind != Kind::File || self.file.is_some()).collect();
                let at = all.iter().position(|kind| *kind == self.kind).unwrap_or(0);
                let chosen = self.slot().answers.clone().filter(|_| self.kind != Kind::File);
                self.kind = all[turned(at, by, all.len())];
                // What was chosen before is asked about in another way.
                if self.kind != Kind::File && self.slot().draft.is_none() {
                    self.slot_mut().answers = chosen;
                }
            }
            Cell::Answer(at) => {
                let names: Vec<String> = of.answers.iter().map(|answer| answer.name.to_string()).collect();
                let now = of.names.get(at).and_then(|name| names.iter().position(|known| known == name));
                // All answers stand behind the last one, where there is one line.
                let is_alone = of.names.len() <= 1 && self.kind != Kind::Find;
                let all = names.len() + usize::from(is_alone);
                let to = turned(now.unwrap_or(if of.names.is_empty() { all - 1 } else { 0 }), by, all);
                let mut chosen = of.names.clone();
                match names.get(to) {
                    None => chosen.clear(),
                    Some(name) if chosen.is_empty() => chosen.push(name.clone()),
                    Some(name) => chosen[at].clone_from(name),
                }
                self.slot_mut().answers = Some(chosen);
                self.slot_mut().wanted.clear();
            }
            Cell::Vary(at) => {
                let used = |path: &str| {
                    of.draft
                        .vary
                        .iter()
                        .enumerate()
                        .any(|(n, other)| n != at && other.input.as_deref() == Some(path))
                };
                let free: Vec<&VariedInput> = of.inputs.iter().filter(|input| !used(&input.path)).collect();
                let now = of.draft.vary.get(at).and_then(|varied| varied.input.as_deref());
                // From what is no input, to the first one.
                let place = free.iter().position(|input| now == Some(&input.path));
                let to = place.map_or(0, |place| turned(place, by, free.len()));
                let Some(to) = free.get(to) else { return };
                if self.slot().draft.is_none() && matches!(self.kind, Kind::Sweep | Kind::Find) {
                    self.input = Some(to.path.clone());
                } else if let Some(varied) = self.edit(of).vary.get_mut(at) {
                    *varied = Varied::new(&to.path, String::new());
                }
            }
            Cell::Sampling => {
                let all = [Sampling::MonteCarlo, Sampling::LatinHypercube, Sampling::Sobol];
                let draft = self.edit(of);
                let at = all.iter().position(|sampling| *sampling == draft.sampling).unwrap_or(0);
                draft.sampling = all[turned(at, by, all.len())];
            }
            _ => {}
        }
    }

    /// Removes the line of a cell; what was typed in one that has to be there; on the first, everything that was chosen
    /// and typed.
    pub(super) fn remove(&mut self, cell: Cell, of: &Subject<'_>) {
        let out = |texts: &mut Vec<String>, at: usize| drop((at < texts.len()).then(|| texts.remove(at)));
        match cell {
            Cell::Kind if self.kind == Kind::File => {
                if let Some(file) = self.file.take() {
                    self.slots[Kind::File as usize] = Slot::default();
                    drop(file);
                }
                self.kind = Kind::Sweep;
            }
            Cell::Kind => {
                *self.slot_mut() = Slot::default();
                self.input = None;
            }
            Cell::Answer(at) => {
                let mut names = of.names.clone();
                if names.len() > 1 {
                    names.remove(at);
                    self.slot_mut().answers = Some(names);
                } else {
                    self.slot_mut().answers = None;
                }
            }
            Cell::Vary(_) if self.kind == Kind::Find => self.set(cell, String::new(), of),
            Cell::Vary(at) => {
                let draft = self.edit(of);
                if at < draft.vary.len() {
                    draft.vary.remove(at);
                }
            }
            Cell::Correlation(at) => out(&mut self.edit(of).correlation, at),
            Cell::Limit(at) => out(&mut self.edit(of).limit, at),
            Cell::Condition(at) => out(&mut self.edit(of).condition, at),
            Cell::Wanted | Cell::Samples | Cell::Seed => self.set(cell, String::new(), of),
            Cell::Inputs | Cell::Sampling => {}
        }
    }

    /// Moves an input that varies by so many places; to which.
    pub(super) fn swap(&mut self, at: usize, by: isize, of: &Subject<'_>) -> usize {
        let draft = self.edit(of);
        let to = at.saturating_add_signed(by).min(draft.vary.len().saturating_sub(1));
        if at < draft.vary.len() {
            draft.vary.swap(at, to);
        }
        to
    }
}

impl Subject<'_> {
    /// The input at a path.
    pub(super) fn input(&self, path: &str) -> Option<&VariedInput> {
        self.inputs.iter().find(|input| input.path == path)
    }

    /// The input of a line, by the place of the line; `None` of a table.
    pub(super) fn varied(&self, at: usize) -> Option<&VariedInput> {
        self.input(self.draft.vary.get(at)?.input.as_deref()?)
    }

    /// The first answer that is studied.
    pub(super) fn answer(&self) -> Option<&Answer> {
        let named = |name: &String| self.answers.iter().find(|answer| answer.name.is(name));
        self.names.first().and_then(named).or(self.answers.first()).copied()
    }

    /// The tolerance that was typed for an input; empty where none was.
    pub(super) fn tolerance(&self, path: &str) -> &str {
        self.tolerances.iter().find(|(known, _)| known == path).map_or("", |(_, typed)| typed.trim())
    }
}
