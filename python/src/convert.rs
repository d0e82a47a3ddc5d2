//! Values of Python as JSON, and back.

use pyo3::{
    exceptions::PyTypeError,
    prelude::*,
    types::{PyBool, PyDict, PyFloat, PyInt, PyList, PyString, PyTuple},
};
use serde_json::{Map, Number, Value as Json};

/// A dictionary with texts as keys.
pub(crate) fn object(dict: &Bound<'_, PyDict>) -> PyResult<Map<String, Json>> {
    dict.iter().map(|(key, value)| Ok((key.extract::<String>()?, to_json(&value)?))).collect()
}

/// A value of Python.
pub(crate) fn to_json(value: &Bound<'_, PyAny>) -> PyResult<Json> {
    if value.is_none() {
        Ok(Json::Null)
    } else if let Ok(flag) = value.cast::<PyBool>() {
        Ok(Json::Bool(flag.is_true()))
    } else if let Ok(text) = value.cast::<PyString>() {
        Ok(Json::String(text.extract()?))
    } else if value.is_instance_of::<PyInt>() {
        Ok(value.extract::<i64>()?.into())
    } else if let Ok(number) = value.cast::<PyFloat>() {
        let number = number.value();
        let wrong = || PyTypeError::new_err(format!("{number} is not a finite number; give one"));
        Ok(Json::Number(Number::from_f64(number).ok_or_else(wrong)?))
    } else if let Ok(dict) = value.cast::<PyDict>() {
        Ok(Json::Object(object(dict)?))
    } else if let Ok(list) = value.cast::<PyList>() {
        Ok(Json::Array(list.iter().map(|item| to_json(&item)).collect::<PyResult<_>>()?))
    } else if let Ok(tuple) = value.cast::<PyTuple>() {
        Ok(Json::Array(tuple.iter().map(|item| to_json(&item)).collect::<PyResult<_>>()?))
    } else {
        let kind = value.get_type().name()?;
        Err(PyTypeError::new_err(format!(
            "a {kind} is no value of an input; give a number, a text, a list or a dict"
        )))
    }
}

/// A value of JSON.
pub(crate) fn to_python(py: Python<'_>, json: &Json) -> PyResult<Py<PyAny>> {
    Ok(match json {
        Json::Null => py.None(),
        Json::Bool(flag) => PyBool::new(py, *flag).to_owned().into_any().unbind(),
        Json::Number(number) => match (number.as_i64(), number.as_f64()) {
            (Some(whole), _) => whole.into_pyobject(py)?.into_any().unbind(),
            (None, number) => number.into_pyobject(py)?.unbind(),
        },
        Json::String(text) => PyString::new(py, text).into_any().unbind(),
        Json::Array(items) => {
            let items: Vec<_> = items.iter().map(|item| to_python(py, item)).collect::<PyResult<_>>()?;
            PyList::new(py, items)?.into_any().unbind()
        }
        Json::Object(object) => {
            let dict = PyDict::new(py);
            for (key, value) in object {
                dict.set_item(key, to_python(py, value)?)?;
            }
            dict.into_any().unbind()
        }
    })
}
