//! The native part of the Python module `dalembert`: requests in, results and arrays out. What a user sees is in
//! `package/dalembert`.

mod arrays;
mod convert;
mod failures;

use dalembert::request::{self, RequestedProblem, SolvedProblem};
use dalembert_core::Language;
use dalembert_plugins as _;
use dalembert_report::{document, html, html_fragment, json_of, latex, latex_formulas, markdown, text};
use pyo3::{prelude::*, types::PyDict};
use serde_json::Value as Json;

use crate::{
    convert::{object, to_python},
    failures::raised,
};

/// Columns of a text.
const WIDTH: usize = 100;

/// The native part of `dalembert`.
#[pymodule(gil_used = false)]
mod _native {
    #[pymodule_export]
    use super::{
        Solved,
        arrays::{study, sweep},
        describe, inputs, is_unit, list, schema, solve,
    };

    #[pymodule_export]
    #[expect(non_upper_case_globals, reason = "a name of Python")]
    const version: &str = env!("CARGO_PKG_VERSION");
}

/// A solved problem.
#[pyclass(frozen, module = "dalembert._native")]
struct Solved(SolvedProblem);

#[pymethods]
impl Solved {
    /// Value of a key of the result.
    fn part(&self, py: Python<'_>, key: &str) -> PyResult<Py<PyAny>> {
        let json = json_of(&self.0.worked(), &|known| known == key, self.0.requested().locale());
        to_python(py, json.get(key).unwrap_or(&Json::Null))
    }

    /// The whole result as JSON.
    fn json(&self) -> String {
        self.0.json().to_string()
    }

    /// The worked solution in a format.
    fn written(&self, py: Python<'_>, format: &str) -> Option<String> {
        py.detach(|| {
            let locale = self.0.requested().locale();
            let document = document(&self.0.worked(), locale);
            Some(match format {
                "html" => html(&document, locale),
                "html_fragment" => html_fragment(&document),
                "latex" => latex(&document),
                "latex_formulas" => latex_formulas(&document),
                "markdown" => markdown(&document, None),
                "text" => text(&document, WIDTH),
                _ => return None,
            })
        })
    }
}

/// Solves the problem of a request.
#[pyfunction]
fn solve(py: Python<'_>, request: &Bound<'_, PyDict>) -> PyResult<Solved> {
    let request = object(request)?;
    let solved = py.detach(|| {
        let solved =
            request::guarded("solve", || RequestedProblem::read(&request, Language::English)?.solve());
        let solved = solved.and_then(|solved| solved)?;
        solved.solution()?;
        Ok(solved)
    });
    Ok(Solved(solved.map_err(|failure| raised(py, failure))?))
}

/// The inputs of the problem of a request: path, label, symbol, kind, units, text, names.
#[pyfunction]
fn inputs(py: Python<'_>, request: &Bound<'_, PyDict>) -> PyResult<Py<PyAny>> {
    let request = object(request)?;
    let problem = py.detach(|| RequestedProblem::read(&request, Language::English));
    let inputs = problem.map_err(|failure| raised(py, failure))?.inputs();
    let rows = inputs.into_iter().map(|input| {
        (input.path, input.label, input.symbol, input.kind, input.units, input.text, input.names)
    });
    Ok(rows.collect::<Vec<_>>().into_pyobject(py)?.into_any().unbind())
}

/// The analyses of a search.
#[pyfunction]
fn list(py: Python<'_>, words: Vec<String>, language: &str) -> PyResult<Py<PyAny>> {
    let found = py.detach(|| request::listed(&words, Language::of(language)));
    to_python(py, &found)
}

/// Inputs, answers, questions, sources and cases of an analysis.
#[pyfunction]
fn describe(py: Python<'_>, id: &str, language: &str) -> PyResult<Py<PyAny>> {
    let described = py.detach(|| request::described(id, Language::of(language)));
    to_python(py, &described.map_err(|failure| raised(py, failure))?)
}

/// JSON Schema of the problem file of an analysis, or of results.
#[pyfunction]
fn schema(py: Python<'_>, id: &str) -> PyResult<Py<PyAny>> {
    let schema = py.detach(|| request::schema_of(id, Language::English));
    to_python(py, &schema.map_err(|failure| raised(py, failure))?)
}

/// Returns true if a text is a unit.
#[pyfunction]
fn is_unit(text: &str) -> bool {
    dalembert_units::unit(text).is_ok()
}
