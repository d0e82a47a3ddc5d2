"""Exceptions of the module. Each has all errors at once, as data."""

from __future__ import annotations

from typing import NamedTuple, Optional, Sequence, Tuple


class Fault(NamedTuple):
    """An error of a request."""

    path: str
    """Path of the input, ``masses[1].radius``; empty where it is about none."""
    message: str
    """The whole sentence, with value and repair."""
    repair: Optional[str] = None
    """The name that was probably meant, where there is one."""
    line: Optional[int] = None
    """Line of the problem file, counted from 1."""


class _WithFaults(Exception):
    errors: "list[Fault]"

    def __init__(self, errors: Sequence[Tuple[str, str, Optional[str], Optional[int]]]) -> None:
        self.errors = [Fault(*error) for error in errors]
        super().__init__("\n".join(error.message for error in self.errors))

    def __reduce__(self):  # type: ignore[no-untyped-def]
        return type(self), ([tuple(error) for error in self.errors],)


class InputError(_WithFaults, ValueError):
    """The inputs, the file or the options are wrong: everything that is."""


class Refusal(_WithFaults):
    """The problem is well written but has no answer."""


class InternalError(_WithFaults, RuntimeError):
    """A fault of the program, not caused by its input."""
