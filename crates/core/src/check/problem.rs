//! Mistakes in what the problem is: another option of a choice, another count.

use super::{Change, Mistake, Place, tries::Tries};
use crate::{
    Answer, Draft, Entry, Field, Record, Refusal, Shape, Solution, SolveError, Stop, Text, Value, Variant,
    vary::{self, VariedInput},
};

/// Adds the results of other options of every choice, and of other counts.
pub(super) fn problems(
    all: &mut Tries<'_, '_>,
    entry: &Entry,
    record: &Record,
    stop: &Stop,
) -> Result<(), Refusal> {
    solve_otherwise(entry, record, stop, &mut |prior, mistake, solution| {
        let values = all.wrong.iter().map(|one| si_of(&solution, one.name)).collect();
        all.data(prior, mistake, values, Vec::new());
    })
}

/// Solves the problem with other options of every choice, and with other counts; `each` takes the prior, the mistake and the
/// solution of every one as it is found.
pub(super) fn solve_otherwise(
    entry: &Entry,
    record: &Record,
    stop: &Stop,
    each: &mut dyn FnMut(f64, Mistake, Solution),
) -> Result<(), Refusal> {
    let draft = Draft::of_record(record);
    let shape = entry.shape();
    let numbers = vary::inputs(record);
    let mut others = Vec::new();
    record.leaves(&mut |path, field, value| match (field.shape.present(), value) {
        (Shape::OneOf(variants), Value::OneOf { variant, .. }) => {
            others.extend(options(path, field, variants(), *variant));
        }
        (_, Value::Count(count)) => {
            others.extend([count + 1, count.saturating_sub(1)].map(|other| Other::Count {
                path: path.to_owned(),
                label: vary::title_of(&shape, path).unwrap_or_else(|| Text::from(field.label)),
                count: other,
            }));
        }
        _ => {}
    });
    for other in others {
        stop.check()?;
        let Some((mistake, changed, prior)) = other.applied(&draft, &shape, &numbers) else { continue };
        let Ok(record) = changed.read(&shape) else { continue };
        match entry.solve_nominal(&record, stop) {
            Err(SolveError::Refused(Refusal::Stopped)) => return Err(Refusal::Stopped),
            Err(_) => {}
            Ok(solution) => each(prior, mistake, solution),
        }
    }
    Ok(())
}

fn si_of(solution: &Solution, name: &str) -> f64 {
    solution.answer(name).and_then(Answer::si).unwrap_or(f64::NAN)
}

/// The problem otherwise.
enum Other {
    Option { path: String, label: Text, labels: [Text; 2], at: usize },
    Count { path: String, label: Text, count: u64 },
}

/// The other options of a choice.
fn options(
    path: &str,
    field: &'static Field,
    variants: &'static [Variant],
    chosen: usize,
) -> impl Iterator<Item = Other> {
    (0..variants.len()).filter(move |at| *at != chosen).map(move |at| Other::Option {
        path: path.to_owned(),
        label: Text::from(field.label),
        labels: [Text::from(variants[chosen].label), Text::from(variants[at].label)],
        at,
    })
}

impl Other {
    /// The mistake, and the inputs with it. Of another option the inputs of the same names are taken over, and the only number
    /// as the only number: 0.3 that is the damping ratio as 0.3 N·s/m.
    fn applied(self, draft: &Draft, shape: &Shape, numbers: &[VariedInput]) -> Option<(Mistake, Draft, f64)> {
        let mut draft = draft.clone();
        match self {
            Other::Count { path, label, count } => {
                draft.set(shape, &path, &count.to_string()).ok()?;
                Some((Mistake::new(Place::Input(path, label), Change::Count), draft, 10.0))
            }
            Other::Option { path, label, labels: [right, taken], at } => {
                let (choice, choice_shape) = draft.at_mut(shape, &path).ok()?;
                let choice_shape = choice_shape.present();
                let Draft::OneOf(before, fields) = choice else { return None };
                let Shape::OneOf(variants) = choice_shape else { return None };
                let chosen = variants()[at].name;
                let known = choice_shape.fields(Some(*before));
                let mut other = Draft::alternative(&choice_shape, at);
                if let (Draft::OneOf(_, blank), Draft::Group(values)) = (&mut other, &**fields)
                    && let Draft::Group(blank) = &mut **blank
                {
                    for (field, slot) in choice_shape.fields(Some(at)).iter().zip(blank) {
                        let same = known.iter().position(|one| one.name == field.name);
                        if let Some(value) = same.and_then(|same| values.get(same)) {
                            *slot = value.clone();
                        }
                    }
                }
                let only = |fields: &[Field]| match fields {
                    [only] if matches!(only.shape.present(), Shape::Quantity(_)) => Some(only.name),
                    _ => None,
                };
                let mut prior = 9.0;
                let (before, after) = (only(known), only(choice_shape.fields(Some(at))));
                *choice = other;
                if let (Some(before), Some(after)) = (before, after)
                    && before != after
                {
                    let is_it = |number: &&VariedInput| {
                        number.path.starts_with(&format!("{path}."))
                            && number.path.ends_with(&format!(".{before}"))
                    };
                    let si = numbers.iter().find(is_it)?.si;
                    draft.set(shape, &format!("{path}.{chosen}.{after}"), &si.to_string()).ok()?;
                    prior = 10.0;
                }
                let change = Change::Alternative(right, taken);
                Some((Mistake::new(Place::Input(path, label), change), draft, prior))
            }
        }
    }
}
