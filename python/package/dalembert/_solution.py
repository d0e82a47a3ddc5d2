"""A solved problem as Python sees it."""

from __future__ import annotations

import importlib
import json
import math
from typing import Any, Dict, Iterator, List, Mapping, NamedTuple, Optional, Tuple, Union

from . import _native

Value = Union[float, Tuple[Any, ...]]
"""A number; ``(x, y, z)`` of a vector; a list of numbers; ``((from, to), …)`` of a set, ``None`` at an open end."""


class Answer(NamedTuple):
    """An answer with its unit. ``float(answer)`` is its value."""

    value: Value
    """Value in ``unit``, the one that is shown."""
    unit: str
    """Unit that can be typed; ``1`` of a pure number."""
    si: Value
    """Value in ``si_unit``."""
    si_unit: str
    """The coherent unit."""
    label: str
    """Name in words."""
    shown: str
    """The answer as it is printed."""
    step: Optional[int] = None
    """Number of the step that it is the result of."""

    def __float__(self) -> float:
        if isinstance(self.value, tuple):
            raise TypeError(f"{self.label} is no single number; take one of its parts from .value")
        return float(self.value)

    def __str__(self) -> str:
        return self.shown

    def pint(self, registry: Any = None) -> Any:
        """The answer as a quantity of pint, of the application's registry where none is given."""
        if registry is None:
            registry = importlib.import_module("pint").get_application_registry()
        try:
            unit = registry.Unit("dimensionless" if self.unit == "1" else self.unit)
        except Exception:  # What pint does not know, whatever its version calls the error.
            return registry.Quantity(_listed(self.si), "dimensionless" if self.si_unit == "1" else self.si_unit)
        return registry.Quantity(_listed(self.value), unit)


class Answers(Mapping[str, Answer]):
    """Answers by their names, ``answers["frequency[2]"]``, those without a place also as attributes."""

    def __init__(self, all: Dict[str, Answer]) -> None:
        self._all = all

    def __getitem__(self, name: str) -> Answer:
        return self._all[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._all)

    def __len__(self) -> int:
        return len(self._all)

    def __getattr__(self, name: str) -> Answer:
        if not name.startswith("_") and name in self._all:
            return self._all[name]
        raise AttributeError(f"there is no answer {name!r}; the answers are {', '.join(self._all)}")

    def __dir__(self) -> List[str]:
        return [*super().__dir__(), *(name for name in self._all if name.isidentifier())]

    def __repr__(self) -> str:
        return "\n".join(f"{name} = {answer.shown}" for name, answer in self._all.items())


class CommonError(NamedTuple):
    """An error that people commonly make in a step, and the number that it gives."""

    what: str
    result: str
    value: Value
    unit: str
    si: Value
    si_unit: str


class Step(NamedTuple):
    """A step of the worked solution, a node of its graph."""

    number: int
    why: str
    symbol: str
    formula: str
    substitution: str
    result: str
    source: str
    value: Value
    unit: str
    si: Value
    si_unit: str
    from_steps: Tuple[int, ...]
    """Numbers of the steps that its operands come from."""
    from_inputs: Tuple[str, ...]
    """Paths of the inputs that its operands come from."""
    problem: Optional[str] = None
    """Name of the linked problem or configuration that it is of."""
    common_errors: Tuple[CommonError, ...] = ()
    """Errors that people commonly make in it."""

    def __str__(self) -> str:
        sides = [self.symbol, self.formula, self.substitution, self.result]
        return " = ".join(side for side in sides if side)


class Check(NamedTuple):
    """Two ways to the same number."""

    what: str
    residual: Optional[float]
    limit: Optional[float]
    passed: bool


class Solution:
    """A solved problem. Its parts are made when they are first asked for."""

    def __init__(self, request: Dict[str, Any]) -> None:
        self._request = request
        self._parts: Dict[str, Any] = {}
        self._native = _native.solve(request)

    def __reduce__(self):  # type: ignore[no-untyped-def]
        # It is solved again where it arrives, which takes less than to send it.
        return Solution, (self._request,)

    def _part(self, key: str) -> Any:
        if key not in self._parts:
            self._parts[key] = self._native.part(key)
        return self._parts[key]

    @property
    def analysis(self) -> str:
        """Id of the analysis."""
        return str(self._part("analysis"))

    @property
    def answers(self) -> Answers:
        """The answers by their names."""
        if "Answers" not in self._parts:
            found = self._native.part("answers")
            self._parts["Answers"] = Answers({name: _answer(answer) for name, answer in found.items()})
        answers: Answers = self._parts["Answers"]
        return answers

    @property
    def inputs(self) -> Dict[str, Dict[str, Any]]:
        """The inputs by their paths: ``text``, ``value``, ``unit``, ``si``, ``si_unit``."""
        return dict(self._part("inputs"))

    @property
    def steps(self) -> List[Step]:
        """The worked solution, a graph: every step names the steps and inputs it comes from."""
        return [_step(step) for step in self._part("steps")]

    @property
    def checks(self) -> List[Check]:
        """Independent ways to the same numbers."""
        return [Check(check["what"], check["residual"], check["limit"], check["passed"]) for check in self._part("checks")]

    @property
    def warnings(self) -> List[str]:
        """What is valid but doubtful."""
        return list(self._part("warnings"))

    @property
    def notes(self) -> List[str]:
        """How inputs were read where that does not stand in them."""
        return list(self._part("notes"))

    @property
    def plots(self) -> List[Dict[str, Any]]:
        """Plots with the points of their curves."""
        return list(self._part("plots"))

    @property
    def tables(self) -> List[Dict[str, Any]]:
        """Tables by their columns: ``heading``, ``unit``, ``cells``, ``foot``."""
        return list(self._part("tables"))

    @property
    def unknowns(self) -> Dict[str, Dict[str, Any]]:
        """Inputs that were found from given answers."""
        return dict(self._part("unknowns"))

    @property
    def definitions(self) -> Dict[str, Dict[str, Any]]:
        """Definitions of the problem."""
        return dict(self._part("definitions"))

    def __getattr__(self, name: str) -> Answer:
        if name.startswith("_") or hasattr(type(self), name):
            raise AttributeError(name)
        return getattr(self.answers, name)  # type: ignore[no-any-return]

    def __dir__(self) -> List[str]:
        return [*super().__dir__(), *(name for name in self.answers if name.isidentifier())]

    def to_json(self) -> str:
        """The whole result as JSON, as ``dalembert schema results`` describes it."""
        return self._native.json()

    def to_dict(self) -> Dict[str, Any]:
        """The same as a dict."""
        result: Dict[str, Any] = json.loads(self.to_json())
        return result

    def html(self) -> str:
        """The worked solution as an HTML page with its figures."""
        return self._written("html")

    def latex(self) -> str:
        """The worked solution as a LaTeX document with its figures."""
        return self._written("latex")

    def markdown(self) -> str:
        """The worked solution in Markdown, without figures."""
        return self._written("markdown")

    def __str__(self) -> str:
        return self._written("text")

    def __repr__(self) -> str:
        return f"<{self.analysis}>\n{self.answers!r}"

    def _repr_html_(self) -> str:
        return self._written("html_fragment")

    def _repr_latex_(self) -> str:
        return f"$$\n{self._written('latex_formulas')}\n$$"

    def _written(self, format: str) -> str:
        return self._native.written(format) or ""


def _answer(answer: Dict[str, Any]) -> Answer:
    return Answer(
        _tupled(answer["value"]),
        answer["unit"],
        _tupled(answer["si"]),
        answer["si_unit"],
        answer["label"],
        answer["shown"],
        answer.get("step"),
    )


def _step(step: Dict[str, Any]) -> Step:
    values = {key: _tupled(value) for key, value in step.items() if key != "common_errors"}
    errors = [{key: _tupled(value) for key, value in error.items()} for error in step.get("common_errors", [])]
    return Step(**values, common_errors=tuple(CommonError(**error) for error in errors))


def _tupled(value: Any) -> Any:
    return tuple(_tupled(inner) for inner in value) if isinstance(value, list) else value


def _listed(value: Any) -> Any:
    if isinstance(value, tuple) and None in value:
        # An open end of a set.
        lower, upper = value
        return [-math.inf if lower is None else lower, math.inf if upper is None else upper]
    return [_listed(inner) for inner in value] if isinstance(value, tuple) else value
