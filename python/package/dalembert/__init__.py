"""Machine dynamics with worked solutions: vibration, balancing, linkages, rigid bodies.

>>> import dalembert
>>> fan = dalembert.solve("vibration/rotating-unbalance", case=1, speed="1500 rpm")
>>> fan.amplitude.shown
'4.5535 mm'

A problem is the id of an analysis, the path of a problem file, or the text of one (which has line breaks). Inputs are
keywords, or dicts of paths: ``set={"support.stiffness": {"stiffness": "2 kN/m"}}``. A value is a text as it would be typed, a
quantity of pint, an answer of another problem, or a number, which is in the unit that `inputs` lists.
"""

from __future__ import annotations

import os
from typing import Any, Dict, List, Mapping, NamedTuple, Optional, Sequence, Tuple, Union

from . import _native
from ._errors import Fault, InputError, InternalError, Refusal
from ._solution import Answer, Answers, Check, CommonError, Solution, Step
from ._values import plain, unit_of

__version__: str = _native.version

__all__ = [
    "Answer",
    "Answers",
    "Check",
    "CommonError",
    "Fault",
    "Input",
    "InputError",
    "InternalError",
    "Refusal",
    "Solution",
    "Step",
    "Study",
    "Table",
    "__version__",
    "analyses",
    "describe",
    "inputs",
    "schema",
    "solve",
    "study",
    "sweep",
]

Problem = Union[str, "os.PathLike[str]"]


class Input(NamedTuple):
    """An input of a problem."""

    path: str
    """Path, ``masses[1].radius``: the keyword, or the key of ``set``."""
    label: str
    """Name in words."""
    symbol: str
    """Symbol in formulas; may be empty."""
    kind: str
    """Kind: of a quantity its name, ``a mass``; ``choice``, ``vector``, ``table``, ``count``, ``flag``, ``text``, ``reference``."""
    units: Tuple[str, ...]
    """The unit of a number alone; of a table, those of its columns."""
    text: str
    """Its text in the problem; of a choice, the name of the alternative."""
    names: Tuple[str, ...]
    """Alternatives of a choice, or columns of a table."""

    @property
    def unit(self) -> str:
        """The unit of a number alone; empty where there is none."""
        return self.units[0] if len(self.units) == 1 else ""


class Table(Dict[str, Any]):
    """Arrays by the names of inputs and answers, with their units."""

    units: Dict[str, str]
    """Unit of every array."""
    refused: List[Tuple[Any, str]]
    """Points without an answer, where the arrays have NaN: place in the arrays, reason."""


class Study(Table):
    """Points of a study, and their statistics."""

    summary: Dict[str, Any]
    """Statistics of each answer, as ``dalembert study --json`` prints them."""


def solve(
    problem: Problem,
    /,
    *,
    case: Optional[int] = None,
    set: Optional[Mapping[str, Any]] = None,
    let: Optional[Mapping[str, Any]] = None,
    ask: Union[None, Mapping[str, str], Sequence[str]] = None,
    given: Optional[Mapping[str, Any]] = None,
    configuration: Optional[Mapping[str, Any]] = None,
    units: Optional[str] = None,
    unit: Optional[Mapping[str, str]] = None,
    digits: Optional[int] = None,
    strict: bool = False,
    lang: str = "en",
    **inputs: Any,
) -> Solution:
    """Solves a problem.

    Without inputs an id is its first published case; with inputs they start empty, or from `case`. `let` are definitions,
    `ask` questions (formulas by their names, or names of usual ones), `given` answers that are known in place of an input
    ``"?"``, `configuration` the same problem with inputs changed beside it. `units` is a system of units, `unit` has units of
    answers, `strict` refuses numbers without a unit in texts.

    Raises `InputError` with everything that is wrong, or `Refusal` where there is no answer.
    """
    return Solution(
        _request(
            problem,
            {**(set or {}), **inputs},
            case=case,
            let=let,
            ask=ask,
            given=given,
            configuration=configuration,
            units=units,
            unit=unit,
            digits=digits,
            strict=strict,
            lang=lang,
        )
    )


def sweep(
    problem: Problem,
    vary: Mapping[str, Any],
    /,
    *,
    answers: Optional[Sequence[str]] = None,
    threads: Optional[int] = None,
    case: Optional[int] = None,
    set: Optional[Mapping[str, Any]] = None,
    units: Optional[str] = None,
    unit: Optional[Mapping[str, str]] = None,
    let: Optional[Mapping[str, Any]] = None,
    ask: Union[None, Mapping[str, str], Sequence[str]] = None,
    configuration: Optional[Mapping[str, Any]] = None,
    lang: str = "en",
    **inputs: Any,
) -> Table:
    """Solves a problem at every point of arrays that vary together, broadcast against each other.

    Numbers of an array are in the unit that `inputs` lists, those of a quantity of pint in its own. An input that varies need
    not be given otherwise. The answers, every number where none is named, are arrays of the same shape in their units; they
    are NaN where a point has none, which `Table.refused` lists. All processors work, and the interpreter's lock is released.
    """
    import numpy as np

    if not vary:
        raise InputError([("vary", "no input varies; give arrays by the paths of inputs", None, None)])
    names, units_of_arrays, arrays = [], [], []
    for path, values in vary.items():
        magnitude, written = unit_of(values) if hasattr(values, "units") else (values, None)
        names.append(path)
        units_of_arrays.append(written)
        arrays.append(np.asarray(magnitude, dtype=float))
    shape = np.broadcast_shapes(*(array.shape for array in arrays))
    flat = [np.broadcast_to(array, shape).ravel() for array in arrays]
    given = {**(set or {}), **inputs}
    if case is None and not _is_file(problem):
        # The first finite value stands for an input that is not given, so that the problem is whole.
        for path, written, values in zip(names, units_of_arrays, flat):
            finite = values[np.isfinite(values)]
            if path not in given and finite.size:
                first = float(finite[0])
                given[path] = first if written is None else f"{first!r} {written}"
    request = _request(
        problem,
        given,
        case=case,
        let=let,
        ask=ask,
        configuration=configuration,
        units=units,
        unit=unit,
        lang=lang,
    )
    wanted = None if answers is None else list(answers)
    varied = [(name, written, values.tobytes()) for name, written, values in zip(names, units_of_arrays, flat)]
    columns, units_found, refused = _native.sweep(request, varied, wanted, threads)
    table = Table((name, np.frombuffer(column).reshape(shape)) for name, column in columns.items())
    table.units = dict(units_found)
    # In an array of one dimension the place is a number.
    place_of = (lambda at: at) if len(shape) == 1 else (lambda at: tuple(int(k) for k in np.unravel_index(at, shape)))
    table.refused = [(place_of(at), why) for at, why in refused]
    return table


def study(
    plan: Union[Mapping[str, Any], Problem],
    /,
    *,
    folder: Problem = "",
    threads: Optional[int] = None,
    case: Optional[int] = None,
    set: Optional[Mapping[str, Any]] = None,
    lang: str = "en",
    **inputs: Any,
) -> Study:
    """Solves a problem at the points of a plan: grids, samples of distributions, rows of a file.

    A plan is a dict with the keys of a plan file (``problem``, ``vary``, ``answers``, ``samples`` …), or the path of one; `folder` is
    where the files that a dict names stand.
    """
    import numpy as np

    if isinstance(plan, Mapping):
        read: Any = plain(plan)
        beside = os.fspath(folder)
    else:
        path = os.fspath(plan)
        with open(path, encoding="utf-8") as file:
            read = file.read()
        beside = os.path.dirname(path)
    request = _request("", {**(set or {}), **inputs}, case=case, lang=lang)
    columns, units, refused, summary = _native.study(request, read, beside, threads)
    table = Study((name, np.frombuffer(column)) for name, column in columns.items())
    table.units = dict(units)
    table.refused = list(refused)
    table.summary = summary
    return table


def inputs(problem: Problem, /, *, case: Optional[int] = None, lang: str = "en", **changed: Any) -> List[Input]:
    """The inputs of a problem, of an id those of its first case: paths, units of numbers, texts, alternatives."""
    if changed and case is None and not _is_file(problem):
        case = 1
    rows = _native.inputs(_request(problem, changed, case=case, lang=lang))
    return [
        Input(path, label, symbol, kind, tuple(units), text, tuple(names))
        for path, label, symbol, kind, units, text, names in rows
    ]


def analyses(words: str = "", *, lang: str = "en") -> List[Dict[str, Any]]:
    """The analyses in which the words are found, the best match first; all without words."""
    found: List[Dict[str, Any]] = _native.list(words.split(), lang)
    return found


def describe(id: str, *, lang: str = "en") -> Dict[str, Any]:
    """What an analysis asks for, what it answers, its questions, sources and cases."""
    described: Dict[str, Any] = _native.describe(id, lang)
    return described


def schema(id: str = "results") -> Dict[str, Any]:
    """JSON Schema of results, or of the problem file of an analysis."""
    found: Dict[str, Any] = _native.schema(id)
    return found


def _is_file(problem: Problem) -> bool:
    return "\n" in os.fspath(problem) or os.path.exists(problem)


def _request(problem: Problem, inputs: Mapping[str, Any], **options: Any) -> Dict[str, Any]:
    named = os.fspath(problem)
    request: Dict[str, Any] = {"problem_file" if "\n" in named else "problem": named}
    request["set"] = {path: plain(value) for path, value in inputs.items()}
    for key, value in options.items():
        if value is not None and value is not False:
            request[key] = plain(value)
    return request
