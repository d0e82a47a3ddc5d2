"""Values of inputs as a request takes them: numbers, texts, lists, dicts; quantities of pint and arrays of NumPy."""

from __future__ import annotations

import os
from typing import Any, Mapping

from . import _native


def plain(value: Any) -> Any:
    """The value as numbers, texts, lists and dicts."""
    if value is None or isinstance(value, (bool, int, float, str)):
        # A number of NumPy may be a subclass of float.
        return float(value) if type(value) not in (type(None), bool, int, float, str) and isinstance(value, float) else value
    if isinstance(value, Mapping):
        return {str(key): plain(inner) for key, inner in value.items()}
    if hasattr(value, "magnitude") and hasattr(value, "units"):
        return _of_quantity(value)
    if hasattr(value, "si") and hasattr(value, "si_unit"):
        # An answer of another problem.
        return _with_unit(value.si, value.si_unit)
    if hasattr(value, "tolist"):
        return plain(value.tolist())
    if isinstance(value, (list, tuple)):
        return [plain(inner) for inner in value]
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    raise TypeError(
        f"a {type(value).__name__} is no value of an input; give a number, a text, a list, a dict, an array or a quantity"
    )


def unit_of(quantity: Any) -> "tuple[Any, str]":
    """The magnitude of a quantity, and its unit as it is typed."""
    for written in _written(quantity.units):
        if _native.is_unit(written):
            return quantity.magnitude, written
    base = quantity.to_base_units()
    for written in _written(base.units):
        if _native.is_unit(written):
            return base.magnitude, written
    raise TypeError(f"the unit `{quantity.units}` has no counterpart here; convert the quantity to another one")


def _written(units: Any) -> "list[str]":
    if getattr(units, "dimensionless", False) and str(units) in ("", "dimensionless"):
        return ["1"]
    forms = []
    for form in ("~P", "~C", "C"):
        try:
            forms.append(format(units, form).replace("**", "^").replace(" ", ""))
        except (TypeError, ValueError):
            continue
    return forms + [str(units)]


def _of_quantity(quantity: Any) -> Any:
    magnitude, unit = unit_of(quantity)
    if hasattr(magnitude, "tolist"):
        magnitude = magnitude.tolist()
    return _with_unit(magnitude, unit)


def _with_unit(magnitude: Any, unit: str) -> Any:
    if isinstance(magnitude, (list, tuple)):
        return [_with_unit(inner, unit) for inner in magnitude]
    # A number alone would be in the unit of its input, which may be another than 1.
    return f"{100 * float(magnitude)!r} %" if unit == "1" else f"{float(magnitude)!r} {unit}"
