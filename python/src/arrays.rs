//! Sweeps and studies on arrays: on all processors, without the lock of the interpreter, until they are interrupted.
//!
//! An array is the bytes of its numbers, in the order of this machine, as NumPy writes and takes them at the cost of a
//! copy. Its own interface would bring a second crate of matrices.

use std::{panic, path::Path, sync::mpsc, thread, time::Duration};

use dalembert::request::{self, RequestFailure, RequestedProblem};
use dalembert_core::{
    Answer, Language, Locale, Solution, Stop, Text, nearest,
    study::{Design, Study, StudyPlan, answer},
    vary,
};
use dalembert_report::study_json;
use dalembert_study::{data, points, workers};
use pyo3::{
    exceptions::PyValueError,
    prelude::*,
    types::{PyByteArray, PyBytes, PyDict},
};
use serde_json::Value as Json;

use crate::{
    convert::{object, to_json, to_python},
    failures::{input, of_fields, of_solve, of_study, raised},
};

/// Time between two looks for an interrupt.
const LOOK: Duration = Duration::from_millis(50);

/// An input that varies: its path, the unit of its values, if another than that of a number alone, and the bytes of its
/// values.
type Varied<'py> = (String, Option<String>, Bound<'py, PyBytes>);

/// Bytes of a number.
const BYTES: usize = size_of::<f64>();

/// Solves the problem of a request at every point: the names, arrays and units of answers, and the refused points.
#[pyfunction]
#[pyo3(signature = (request, varied, answers, threads))]
pub(crate) fn sweep(
    py: Python<'_>,
    request: &Bound<'_, PyDict>,
    varied: Vec<Varied<'_>>,
    answers: Option<Vec<String>>,
    threads: Option<usize>,
) -> PyResult<Py<PyAny>> {
    let request = object(request)?;
    let inputs: Vec<(&str, Option<&str>, &[u8])> = varied
        .iter()
        .map(|(path, unit, values)| (path.as_str(), unit.as_deref(), values.as_bytes()))
        .collect();
    let lengths: Vec<usize> = inputs.iter().map(|(_, _, values)| values.len()).collect();
    if lengths.iter().any(|length| length % BYTES != 0 || *length != lengths[0]) {
        return Err(PyValueError::new_err("arrays of one length are needed for all inputs that vary"));
    }
    let swept = interruptible(py, |stop| {
        guarded("sweep", || swept(&request, &inputs, answers.as_deref(), cores(threads), stop))
    })?;
    let swept = swept.map_err(|failure| raised(py, failure))?;
    let table = PyDict::new(py);
    for (name, values) in swept.columns {
        table.set_item(name, bytes_of(py, &values)?)?;
    }
    Ok((table, swept.units, swept.refused).into_pyobject(py)?.into_any().unbind())
}

/// A sweep with its answers in their units.
struct Swept {
    columns: Vec<(String, Vec<f64>)>,
    units: Vec<(String, String)>,
    refused: Vec<(usize, String)>,
}

fn swept(
    request: &serde_json::Map<String, Json>,
    inputs: &[(&str, Option<&str>, &[u8])],
    answers: Option<&[String]>,
    threads: usize,
    stop: &Stop,
) -> Result<Swept, RequestFailure> {
    let solved = RequestedProblem::read(request, Language::English)?.solve()?;
    let (problem, locale) = (solved.requested(), *solved.requested().locale());
    let varied = points::varied(problem.record(), inputs.iter().map(|(path, ..)| *path))
        .map_err(|n| unknown_input(inputs[n].0, problem, &locale))?;
    let wanted = wanted(solved.solution()?, answers, &locale)?;
    let mut units = Vec::new();
    for ((path, unit, _), input) in inputs.iter().zip(&varied) {
        let own = || Ok(input.measure.own_unit());
        let unit = unit.map_or_else(own, |unit| {
            let known = dalembert_units::unit(unit).ok().filter(|known| known.dim == input.unit.dim);
            let why = Text::new("`{unit}` is not a unit of this input").with("unit", unit);
            known.ok_or_else(|| crate::failures::input(path, &why, &locale))
        })?;
        units.push(unit);
    }
    let rows = inputs.first().map_or(0, |(_, _, values)| values.len() / BYTES);
    let mut si = vec![0.0; rows * inputs.len()];
    for (at, ((_, _, values), unit)) in inputs.iter().zip(&units).enumerate() {
        // Every chunk has the bytes of one number: the length was examined.
        for (row, number) in si.chunks_exact_mut(inputs.len()).zip(values.as_chunks::<BYTES>().0) {
            row[at] = unit.si(f64::from_ne_bytes(*number));
        }
    }
    let names: Vec<String> = wanted.iter().map(|answer| answer.name.to_string()).collect();
    let named: Vec<&str> = names.iter().map(String::as_str).collect();
    let swept = points::solve((problem.entry(), problem.record()), &varied, &named, &si, threads, stop)
        .map_err(|error| of_solve(error, &locale))?;
    let column = |(at, answer): (usize, &Answer)| {
        let rows = swept.answers.chunks_exact(wanted.len().max(1));
        (names[at].clone(), rows.map(|row| answer.unit.value(row[at])).collect())
    };
    Ok(Swept {
        columns: wanted.iter().enumerate().map(column).collect(),
        units: units_of(&wanted),
        refused: swept.refused.iter().map(|(row, why)| (*row, why.render(&locale))).collect(),
    })
}

fn unknown_input(path: &str, problem: &RequestedProblem, locale: &Locale) -> RequestFailure {
    let known: Vec<String> = vary::inputs(problem.record()).into_iter().map(|input| input.path).collect();
    let why = match nearest(path, known.iter().map(String::as_str)) {
        Some(near) => Text::new("there is no `{name}`; did you mean `{near}`?").with("near", near),
        None => Text::new("there is no `{name}`; write one of {known}").with("known", known.join(", ")),
    };
    input(path, &why.with("name", path), locale)
}

/// The answers of these names; every number where none is named.
fn wanted(
    solution: &Solution,
    names: Option<&[String]>,
    locale: &Locale,
) -> Result<Vec<Answer>, RequestFailure> {
    let numbers = || solution.answers.iter().filter(|answer| answer.si().is_some());
    let Some(names) = names else { return Ok(numbers().cloned().collect()) };
    let find =
        |name: &String| answer(solution, "answers", name).map_err(|error| of_fields(vec![error], locale));
    names.iter().map(find).collect()
}

fn units_of(answers: &[Answer]) -> Vec<(String, String)> {
    answers.iter().map(|answer| (answer.name.to_string(), typed(&answer.unit))).collect()
}

fn typed(unit: &dalembert_units::Unit) -> String {
    let text = unit.ascii();
    if text.is_empty() { "1".to_owned() } else { text }
}

/// Solves the problem of a request at the points of a plan: columns, units, refused points, summary.
#[pyfunction]
#[pyo3(signature = (request, plan, folder, threads))]
pub(crate) fn study(
    py: Python<'_>,
    request: &Bound<'_, PyDict>,
    plan: &Bound<'_, PyAny>,
    folder: &str,
    threads: Option<usize>,
) -> PyResult<Py<PyAny>> {
    let request = object(request)?;
    let plan = to_json(plan)?;
    let studied = interruptible(py, |stop| {
        guarded("study", || studied(&request, plan, Path::new(folder), cores(threads), stop))
    })?;
    let studied = studied.map_err(|failure| raised(py, failure))?;
    let table = PyDict::new(py);
    for (name, values) in studied.columns {
        table.set_item(name, bytes_of(py, &values)?)?;
    }
    let summary = to_python(py, &studied.summary)?;
    Ok((table, studied.units, studied.refused, summary).into_pyobject(py)?.into_any().unbind())
}

/// A study with its inputs and answers in their units.
struct Studied {
    columns: Vec<(String, Vec<f64>)>,
    units: Vec<(String, String)>,
    refused: Vec<(usize, String)>,
    summary: Json,
}

fn studied(
    request: &serde_json::Map<String, Json>,
    plan: Json,
    folder: &Path,
    threads: usize,
    stop: &Stop,
) -> Result<Studied, RequestFailure> {
    let locale = Locale::english();
    let of_plan = |error: &dyn std::fmt::Display| input("plan", &Text::verbatim(error), &locale);
    let plan: StudyPlan = match plan {
        Json::String(text) => toml::from_str(&text).map_err(|error| of_plan(&error))?,
        object => serde_json::from_value(object).map_err(|error| of_plan(&error))?,
    };
    let mut request = request.clone();
    let named = if dalembert_core::find(&plan.problem).is_some() {
        plan.problem.clone()
    } else {
        folder.join(&plan.problem).to_string_lossy().into_owned()
    };
    request.insert("problem".to_owned(), named.into());
    let solved = RequestedProblem::read(&request, Language::English)?.solve()?;
    let (problem, locale) = (solved.requested(), *solved.requested().locale());
    let read = |name: &str| data::read(&folder.join(name));
    let design = Design::new(&plan, problem.record(), &read).map_err(|errors| of_fields(errors, &locale))?;
    let study = Study::new(problem.entry(), problem.record(), &plan, design, solved.solution()?)
        .map_err(|error| of_solve(error, &locale))?;
    let (inputs, answers) = (study.design.inputs.len(), study.answers.len());
    let mut columns = vec![Vec::new(); inputs + answers];
    let mut refused = Vec::new();
    let mut sums = study.accumulator(0);
    workers::solve(&study, 0..study.design.points(), threads, None, stop, &mut |block| {
        for row in block.rows.iter() {
            if let Some(why) = row.refusal {
                refused.push((columns[0].len(), why.render(&locale)));
            }
            for (column, value) in columns.iter_mut().zip(row.inputs.iter().chain(row.answers)) {
                column.push(*value);
            }
            sums.push(row.inputs, row.answers, row.refusal);
        }
        Ok(())
    })
    .map_err(|error| of_study(error, &locale))?;
    let mut units: Vec<(String, String)> =
        study.design.inputs.iter().map(|input| (input.path.clone(), typed(&input.unit))).collect();
    units.extend(units_of(&study.answers));
    let columns = units.iter().map(|(name, _)| name.clone()).zip(columns).collect();
    let summary = study_json(&study, &sums.summary(), &locale);
    Ok(Studied { columns, units, refused, summary })
}

fn bytes_of<'py>(py: Python<'py>, values: &[f64]) -> PyResult<Bound<'py, PyByteArray>> {
    PyByteArray::new_with(py, values.len() * BYTES, |bytes| {
        for (place, value) in bytes.as_chunks_mut::<BYTES>().0.iter_mut().zip(values) {
            *place = value.to_ne_bytes();
        }
        Ok(())
    })
}

fn cores(threads: Option<usize>) -> usize {
    threads.unwrap_or_else(|| thread::available_parallelism().map_or(1, usize::from))
}

fn guarded<T>(what: &str, run: impl FnOnce() -> Result<T, RequestFailure>) -> Result<T, RequestFailure> {
    request::guarded(what, run).and_then(|done| done)
}

fn look_for_interrupt(py: Python<'_>) -> PyResult<()> {
    py.check_signals()
}

/// Runs a long computation without the lock of the interpreter. An interrupt of the user stops it.
fn interruptible<T: Send>(py: Python<'_>, work: impl FnOnce(&Stop) -> T + Send) -> PyResult<T> {
    let stop = Stop::new();
    py.detach(|| {
        thread::scope(|scope| {
            let (done, waiting) = mpsc::channel();
            let signal = &stop;
            let worker = scope.spawn(move || {
                let result = work(signal);
                // Nobody waits any more after an interrupt.
                let _ = done.send(());
                result
            });
            let mut interrupted = Ok(());
            while waiting.recv_timeout(LOOK) == Err(mpsc::RecvTimeoutError::Timeout) {
                interrupted = Python::attach(look_for_interrupt);
                if interrupted.is_err() {
                    stop.stop();
                    break;
                }
            }
            let result = worker.join().unwrap_or_else(|fault| panic::resume_unwind(fault));
            interrupted.map(|()| result)
        })
    })
}
